//! A lathe's limits, from its record in `catalogs/lathes`.

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, RowRef, Table};
use crate::note::Note;
use crate::units::{
    ItGrade, Kilowatts, Micrometres, MillimetresPerMinute, NewtonMetres, Newtons, RevsPerMinute, Roughness, Seconds,
};

use super::{Shank, TurningTool};

/// How a spindle turns.
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
    /// The fastest speed of the spindle that is not above the wanted one; where it has none so slow, its slowest.
    ///
    /// The nearest lower step is what handbook examples take (ukrbukva.net/page,8,69910): the tool then lasts at least
    /// as long as it was reckoned for.
    pub fn at_most(&self, wanted: RevsPerMinute) -> RevsPerMinute {
        match self {
            Self::Steps(steps) => {
                steps.iter().rev().find(|step| step.0 <= wanted.0).or_else(|| steps.first()).copied().unwrap_or(wanted)
            }
            Self::Range { min, max } => RevsPerMinute(wanted.0.min(max.0).max(min.0)),
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

/// A lathe as planning sees it. What its record does not say is `None`.
#[derive(Clone, Debug)]
pub struct Lathe<'k> {
    /// Its record.
    pub table: &'k Table,
    /// Its spindle.
    pub spindle: Spindle,
    /// Power of the main drive's motor.
    pub power: Kilowatts,
    /// Share of that power which reaches the spindle.
    pub efficiency: Option<Share>,
    /// Largest torque of the spindle.
    pub torque: Option<NewtonMetres>,
    /// Largest diameter turned over the bed.
    pub over_bed: Micrometres,
    /// Largest diameter turned over the carriage.
    pub over_carriage: Micrometres,
    /// Between the centres.
    pub between_centres: Micrometres,
    /// Largest length turned.
    pub turned_length: Option<Micrometres>,
    /// Largest bar through the spindle.
    pub bar_hole: Micrometres,
    /// Least and largest feed along Z.
    pub feed_z: (MillimetresPerMinute, MillimetresPerMinute),
    /// Least and largest feed along X.
    pub feed_x: (MillimetresPerMinute, MillimetresPerMinute),
    /// Rapid along Z.
    pub rapid_z: MillimetresPerMinute,
    /// Rapid along X.
    pub rapid_x: MillimetresPerMinute,
    /// Largest force of the drive along Z.
    pub feed_force_z: Option<Newtons>,
    /// Largest force of the drive along X.
    pub feed_force_x: Option<Newtons>,
    /// Largest main cutting force, where the maker gives one.
    pub cutting_force: Option<Newtons>,
    /// The least step along Z and X.
    pub resolution: Option<(Micrometres, Micrometres)>,
    /// The grade it holds when finishing outer surfaces.
    pub it_outer: Option<ItGrade>,
    /// The same of bores.
    pub it_inner: Option<ItGrade>,
    /// The same of lengths between faces.
    pub it_face: Option<ItGrade>,
    /// The best roughness of finishing.
    pub best_roughness: Option<Roughness>,
    /// Places of the turret.
    pub turret_places: usize,
    /// Height of the shanks that go in.
    pub shank_height: Option<Micrometres>,
    /// Time of one tool change.
    pub tool_change: Option<Seconds>,
    /// What its programs are written for.
    pub control: Option<&'k str>,
}

/// A share of one.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Share(pub f64);

impl<'k> Lathe<'k> {
    /// Every lathe's id, as files name it. A lathe is a record with a spindle power: tables of the controls of lathes begin
    /// with the same word.
    pub fn ids(knowledge: &'k Knowledge) -> Vec<&'k str> {
        let is_lathe = |table: &Table| table.id != "lathe-quantities" && table.find("name", "spindle-power").is_some();
        let id = |table: &'k Table| table.id.strip_prefix("lathe-").filter(|_| is_lathe(table));
        knowledge.tables().filter_map(id).collect()
    }

    /// The lathe of that id, such as `16k20f3`.
    ///
    /// # Errors
    /// There is no such lathe, its record lacks a required quantity, or it says nothing about its spindle's speeds.
    pub fn find(knowledge: &'k Knowledge, id: &str) -> Result<Self, KnowledgeError> {
        let table = knowledge.table(&format!("lathe-{id}"))?;
        let any = |name: &str| table.find("name", name).and_then(|row| row.numbers("value").first().copied());
        let number = |name: &str| any(name).ok_or_else(|| KnowledgeError::no_row(table, name));
        let length = |name: &str| number(name).map(Micrometres::from_mm_rounded);
        let rate = |name: &str| number(name).map(MillimetresPerMinute);
        let grade = |name: &str| any(name).and_then(|value| ItGrade::new(value as u8));
        let steps = table.find("name", "spindle-speeds").map(|row| row.numbers("value")).unwrap_or_default();
        let spindle = if steps.is_empty() {
            Spindle::Range {
                min: RevsPerMinute(number("spindle-speed-min")?),
                max: RevsPerMinute(number("spindle-speed-max")?),
            }
        } else {
            Spindle::Steps(steps.into_iter().map(RevsPerMinute).collect())
        };
        let optional_length = |name: &str| any(name).map(Micrometres::from_mm_rounded);
        Ok(Self {
            table,
            spindle,
            power: Kilowatts(number("spindle-power")?),
            efficiency: any("spindle-efficiency").map(Share),
            torque: any("spindle-torque-max").map(NewtonMetres),
            over_bed: length("diameter-over-bed")?,
            over_carriage: length("diameter-over-carriage")?,
            between_centres: length("length-between-centres")?,
            turned_length: optional_length("turned-length-max"),
            bar_hole: length("bar-hole")?,
            feed_z: (rate("feed-min-z")?, rate("feed-max-z")?),
            feed_x: (rate("feed-min-x")?, rate("feed-max-x")?),
            rapid_z: rate("rapid-z")?,
            rapid_x: rate("rapid-x")?,
            feed_force_z: any("feed-force-z").map(Newtons),
            feed_force_x: any("feed-force-x").map(Newtons),
            cutting_force: any("cutting-force-max").map(Newtons),
            resolution: optional_length("resolution-z").zip(optional_length("resolution-x")),
            it_outer: grade("it-outer"),
            it_inner: grade("it-inner"),
            it_face: grade("it-face"),
            best_roughness: any("ra-best").map(|um| Roughness::from_ra_nanometres((um * 1000.0).round() as u32)),
            turret_places: number("turret-places")? as usize,
            shank_height: optional_length("shank-height"),
            tool_change: any("tool-change-time").map(Seconds),
            control: table.find("name", "control").and_then(|row| row.text("text").ok()),
        })
    }

    /// Its id.
    pub fn id(&self) -> &'k str {
        self.table.id.strip_prefix("lathe-").unwrap_or(&self.table.id)
    }

    /// The row of a quantity.
    ///
    /// # Errors
    /// The record does not name it.
    pub fn row(&self, name: &str) -> Result<RowRef<'k>, KnowledgeError> {
        self.table.find("name", name).ok_or_else(|| KnowledgeError::no_row(self.table, name))
    }

    /// Why a part does not go in: a diameter over the carriage, or a length between the centres; nothing where it does.
    pub fn refuses_part(&self, diameter: Micrometres, length: Micrometres) -> Option<Note> {
        let refusal = |quantity: &str, is: Micrometres, most: Micrometres| {
            let note = Note::new("lathe-too-small").with("lathe", self.id()).with("quantity", quantity);
            note.with("is", is).with("most", most)
        };
        if diameter > self.over_carriage {
            return Some(refusal("diameter-over-carriage", diameter, self.over_carriage));
        }
        (length > self.between_centres).then(|| refusal("length-between-centres", length, self.between_centres))
    }

    /// Why a tool does not go in: its shank is higher than the seat; nothing where it does or where the record does not
    /// say.
    pub fn refuses_tool(&self, tool: &TurningTool<'_>) -> Option<Note> {
        let (Some(Shank::Square { height, .. }), Some(most)) = (tool.shank, self.shank_height) else { return None };
        (height > most).then(|| {
            let note = Note::new("shank-too-high").with("lathe", self.id()).with("tool", tool.designation);
            note.with("is", height).with("most", most)
        })
    }
}
