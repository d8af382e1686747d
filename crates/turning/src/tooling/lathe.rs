//! A lathe's limits, from its record in `catalogs/lathes`.

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, RowRef, Table};
use crate::note::Note;
use crate::tables::lathes::{LatheQuantity as Q, LatheRecord};
use crate::units::{
    ItGrade, Kilowatts, Micrometres, MillimetresPerMinute, NewtonMetres, Newtons, RevsPerMinute, Roughness,
};

use super::{Seconds, Shank, TurningTool};

/// The speeds of a spindle.
#[derive(Clone, Debug, PartialEq)]
pub enum Spindle {
    /// At these speeds only, ascending; never empty.
    Steps(Vec<RevsPerMinute>),
    /// At any speed between two.
    Range {
        /// The slowest.
        min: RevsPerMinute,
        /// The fastest.
        max: RevsPerMinute,
    },
}

impl Spindle {
    /// The fastest speed of the spindle that is not above the wanted one; otherwise its slowest.
    ///
    /// Handbook examples take the nearest lower step (ukrbukva.net/page,8,69910): the tool then lasts at least as long
    /// as calculated.
    pub fn at_most(&self, wanted: RevsPerMinute) -> RevsPerMinute {
        match self {
            Self::Steps(steps) => {
                steps.iter().rev().find(|step| step.0 <= wanted.0).or_else(|| steps.first()).copied().unwrap_or(wanted)
            }
            // Whole revolutions, as controls read them.
            Self::Range { min, max } => RevsPerMinute(wanted.0.min(max.0).floor().max(min.0)),
        }
    }

    /// The same spindle where what it turns must not be faster; its slowest speed stays.
    #[must_use]
    pub fn no_faster_than(&self, most: RevsPerMinute) -> Self {
        match self {
            Self::Steps(steps) => {
                let slow = steps.iter().enumerate().filter(|(place, step)| *place == 0 || step.0 <= most.0);
                Self::Steps(slow.map(|(_, step)| *step).collect())
            }
            Self::Range { min, max } => {
                Self::Range { min: *min, max: RevsPerMinute(max.0.min(most.0.floor()).max(min.0)) }
            }
        }
    }

    /// The slowest and the fastest speed.
    pub fn ends(&self) -> (RevsPerMinute, RevsPerMinute) {
        match self {
            Self::Steps(steps) => {
                (steps.first().copied().unwrap_or_default(), steps.last().copied().unwrap_or_default())
            }
            Self::Range { min, max } => (*min, *max),
        }
    }
}

/// A lathe for planning. Figures missing in its record are `None`.
#[derive(Clone, Debug)]
pub struct Lathe<'k> {
    /// The table of its record.
    pub table: &'k Table,
    record: Record<'k>,
    /// Its spindle.
    pub spindle: Spindle,
    /// Power of the main drive's motor.
    pub power: Kilowatts,
    /// The share of that power that reaches the spindle.
    pub efficiency: Option<Share>,
    /// Largest torque of the spindle.
    pub torque: Option<NewtonMetres>,
    /// Largest diameter turned over the bed.
    pub over_bed: Option<Micrometres>,
    /// Time of a tool change.
    pub tool_change: Option<Seconds>,
    /// Largest diameter turned over the carriage.
    pub over_carriage: Micrometres,
    /// Distance between the centres.
    pub between_centres: Micrometres,
    /// Diameter of the largest bar that goes through the spindle.
    pub bar_hole: Option<Micrometres>,
    /// Least and largest feed along Z.
    pub feed_z: (MillimetresPerMinute, MillimetresPerMinute),
    /// Least and largest feed along X.
    pub feed_x: (MillimetresPerMinute, MillimetresPerMinute),
    /// Rapid along Z.
    pub rapid_z: MillimetresPerMinute,
    /// Largest force of the drive along Z.
    pub feed_force_z: Option<Newtons>,
    /// Largest force of the drive along X.
    pub feed_force_x: Option<Newtons>,
    /// Largest main cutting force, if the maker gives one.
    pub cutting_force: Option<Newtons>,
    /// The grade that it reaches in finishing outer surfaces.
    pub it_outer: Option<ItGrade>,
    /// The same of bores.
    pub it_inner: Option<ItGrade>,
    /// The same of lengths between faces.
    pub it_face: Option<ItGrade>,
    /// The best roughness of finishing.
    pub best_roughness: Option<Roughness>,
    /// How many tools its turret holds.
    pub turret_places: Option<usize>,
    /// Height of the shanks that fit.
    pub shank_height: Option<Micrometres>,
}

/// A share of one.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Share(pub f64);

/// The rows of a lathe's record.
#[derive(Clone, Debug)]
struct Record<'k>(Vec<LatheRecord<'k>>);

impl<'k> Record<'k> {
    fn row(&self, quantity: Q) -> Option<&LatheRecord<'k>> {
        self.0.iter().find(|row| row.name.is(quantity))
    }

    /// The figures of a quantity, in the unit that `lathe-quantities` names; empty if the record has none.
    fn values(&self, quantity: Q) -> &[f64] {
        self.row(quantity).and_then(|row| row.value.as_deref()).unwrap_or_default()
    }
}

impl<'k> Lathe<'k> {
    /// Every lathe's id, as files name it.
    pub fn ids(knowledge: &'k Knowledge) -> Vec<&'k str> {
        knowledge.tables_of::<LatheRecord<'_>>().filter_map(|table| table.id.strip_prefix("lathe-")).collect()
    }

    /// The lathe with an id, such as `16k20f3`.
    ///
    /// # Errors
    /// There is no such lathe, its record lacks a required quantity, or it has no spindle speeds.
    pub fn find(knowledge: &'k Knowledge, id: &str) -> Result<Self, KnowledgeError> {
        let table = knowledge.table(&format!("lathe-{id}"))?;
        let record = Record(table.rows().collect::<Result<_, _>>()?);
        let any = |quantity| record.values(quantity).first().copied();
        let number = |quantity: Q| any(quantity).ok_or_else(|| KnowledgeError::no_row(table, quantity.name()));
        let length = |quantity| number(quantity).map(Micrometres::from_mm_rounded);
        let rate = |quantity| number(quantity).map(MillimetresPerMinute);
        let grade = |quantity| any(quantity).and_then(|value| ItGrade::new(value as u8));
        let steps = record.values(Q::SpindleSpeeds);
        let spindle = if steps.is_empty() {
            Spindle::Range {
                min: RevsPerMinute(number(Q::SpindleSpeedMin)?),
                max: RevsPerMinute(number(Q::SpindleSpeedMax)?),
            }
        } else {
            Spindle::Steps(steps.iter().copied().map(RevsPerMinute).collect())
        };
        Ok(Self {
            table,
            spindle,
            power: Kilowatts(number(Q::SpindlePower)?),
            efficiency: any(Q::SpindleEfficiency).map(Share),
            torque: any(Q::SpindleTorqueMax).map(NewtonMetres),
            over_bed: any(Q::DiameterOverBed).map(Micrometres::from_mm_rounded),
            tool_change: any(Q::ToolChangeTime).map(Seconds),
            over_carriage: length(Q::DiameterOverCarriage)?,
            between_centres: length(Q::LengthBetweenCentres)?,
            bar_hole: any(Q::BarHole).map(Micrometres::from_mm_rounded),
            feed_z: (rate(Q::FeedMinZ)?, rate(Q::FeedMaxZ)?),
            feed_x: (rate(Q::FeedMinX)?, rate(Q::FeedMaxX)?),
            rapid_z: rate(Q::RapidZ)?,
            feed_force_z: any(Q::FeedForceZ).map(Newtons),
            feed_force_x: any(Q::FeedForceX).map(Newtons),
            cutting_force: any(Q::CuttingForceMax).map(Newtons),
            it_outer: grade(Q::ItOuter),
            it_inner: grade(Q::ItInner),
            it_face: grade(Q::ItFace),
            best_roughness: any(Q::RaBest).map(|um| Roughness::from_ra_nanometres((um * 1000.0).round() as u32)),
            turret_places: any(Q::TurretPlaces).map(|places| places as usize),
            shank_height: any(Q::ShankHeight).map(Micrometres::from_mm_rounded),
            record,
        })
    }

    /// The same where what its spindle turns must not be faster.
    #[must_use]
    pub fn no_faster_than(&self, most: RevsPerMinute) -> Self {
        Self { spindle: self.spindle.no_faster_than(most), ..self.clone() }
    }

    /// Its id.
    pub fn id(&self) -> &'k str {
        self.table.id.strip_prefix("lathe-").unwrap_or(&self.table.id)
    }

    /// The row of a quantity, as a source.
    ///
    /// # Errors
    /// The record does not have it.
    pub fn row(&self, quantity: Q) -> Result<RowRef<'k>, KnowledgeError> {
        let row = self.record.row(quantity);
        row.map(|row| row.row).ok_or_else(|| KnowledgeError::no_row(self.table, quantity.name()))
    }

    /// Why a part does not fit: a diameter over the carriage, or a length between the centres; none if it fits.
    pub fn refuses_part(&self, diameter: Micrometres, length: Micrometres) -> Option<Note> {
        let refusal = |quantity: Q, is: Micrometres, most: Micrometres| {
            let note = Note::new("lathe-too-small").with("lathe", self.id());
            let note = note.with("quantity", quantity.name());
            note.with("is", is).with("most", most)
        };
        if diameter > self.over_carriage {
            return Some(refusal(Q::DiameterOverCarriage, diameter, self.over_carriage));
        }
        (length > self.between_centres).then(|| refusal(Q::LengthBetweenCentres, length, self.between_centres))
    }

    /// Why a tool does not fit: its shank is higher than the seat; none if it fits or the record has no seat.
    pub fn refuses_tool(&self, tool: &TurningTool<'_>) -> Option<Note> {
        let (Some(Shank::Square { height, .. }), Some(most)) = (tool.shank, self.shank_height) else { return None };
        (height > most).then(|| {
            let note = Note::new("shank-too-high").with("lathe", self.id()).with("tool", tool.designation);
            note.with("is", height).with("most", most)
        })
    }
}
