//! The machine's limits, from its record in catalogs/machines.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::contract::Named;
use crate::knowledge::{Knowledge, RowRef, Table};
use crate::tables::machines::{MachineQuantity as Q, MachineRecord};
use crate::units::{
    Kilowatts, Micrometres, MillimetresPerMinute, MillimetresPerSecondSquared, Minutes, NewtonMetres, Newtons,
    RevsPerMinute, Unit,
};

/// A controlled linear axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub enum Axis {
    /// Along the table.
    X,
    /// Across the table.
    Y,
    /// Along the spindle, plus away from the table.
    Z,
}

impl Axis {
    /// The three of them.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// Its letter.
    pub const fn letter(self) -> char {
        match self {
            Self::X => 'X',
            Self::Y => 'Y',
            Self::Z => 'Z',
        }
    }

    /// The axis with that letter.
    pub const fn of(letter: char) -> Option<Self> {
        match letter {
            'X' => Some(Self::X),
            'Y' => Some(Self::Y),
            'Z' => Some(Self::Z),
            _ => None,
        }
    }

    /// Its index in arrays of three, from 0.
    pub const fn index(self) -> usize {
        self as usize
    }
}

/// The id that a typed name of a machine may mean: `ГФ2171` is called so in the workshop, and `gf2171` in its files.
pub fn id_of(typed: &str) -> String {
    let letters = typed.to_lowercase();
    let letters = letters.chars().filter(|letter| !letter.is_whitespace());
    letters
        .map(|letter| match letter {
            'а' => 'a',
            'б' => 'b',
            'в' => 'v',
            'г' => 'g',
            'е' => 'e',
            'и' | 'і' => 'i',
            'к' => 'k',
            'л' => 'l',
            'м' => 'm',
            'н' => 'n',
            'о' => 'o',
            'п' => 'p',
            'р' => 'r',
            'с' => 's',
            'т' => 't',
            'ф' => 'f',
            other => other,
        })
        .collect()
}

/// A characteristic of a machine.
#[derive(Clone, Copy, Debug)]
pub struct Characteristic<'m> {
    /// Its key: `spindle-power`.
    pub name: &'m str,
    /// Its figures; none where it is a word.
    pub values: &'m [f64],
    /// Their unit.
    pub unit: Unit,
    /// What is said beside the figures, or instead of them.
    pub text: Option<&'m str>,
}

/// A machine as the planner sees it.
#[derive(Clone, Debug)]
pub struct Machine<'k> {
    /// The table of its record.
    pub table: &'k Table,
    record: Record<'k>,
    /// The control for which its programs are written, by its name on the command line; absent if the record does not
    /// say.
    pub control: Option<&'k str>,
    /// Length of its table, along X; absent if the record does not say.
    pub table_length: Option<Micrometres>,
    /// Width of its table, along Y; absent if the record does not say.
    pub table_width: Option<Micrometres>,
    /// Whether its record says how many T-slots it has, which are then all lengthwise.
    pub slots: bool,
    /// The width of its T-slots; absent if the record does not say.
    pub slot_width: Option<Micrometres>,
    /// The spindle's steps, ascending.
    pub spindle_steps: Vec<RevsPerMinute>,
    /// Power of the main drive.
    pub spindle_power: Kilowatts,
    /// Largest torque of the spindle.
    pub spindle_torque: NewtonMetres,
    /// Largest thrust along Z.
    pub thrust: Newtons,
    /// Smallest feed.
    pub feed_min: MillimetresPerMinute,
    /// Largest feed.
    pub feed_max: MillimetresPerMinute,
    /// Rapid of each axis.
    pub rapid: MillimetresPerMinute,
    /// Acceleration of each axis in rapids, where the record has it.
    pub rapid_acceleration: Option<MillimetresPerSecondSquared>,
    /// Travel of the table along X, of the whole stroke.
    pub travel_x: Micrometres,
    /// Travel of the table along Y, of the whole stroke.
    pub travel_y: Micrometres,
    /// Travel of the quill along Z, of the whole stroke.
    pub travel_z: Micrometres,
    /// The middle of the travels along X and Y, where the spindle stands over the middle of the table, machine coordinates: zero
    /// where the machine has its zero there, as ГФ2171 has.
    pub middle: [Micrometres; 2],
    /// The least step of its axes.
    pub resolution: Micrometres,
    /// Largest mass of a part, kg.
    pub load_max_kg: f64,
    /// Places of the magazine, at least one: a tool stands in the spindle of a machine without one.
    pub magazine: usize,
    /// Time of one tool change.
    pub tool_change: Minutes,
    /// The position of the table for a tool change.
    pub tool_change_at: (Micrometres, Micrometres),
    /// The position of the quill for a tool change.
    pub tool_change_z: Micrometres,
    /// Whether the tool is changed wherever the table stands, so that only the quill has a place for it.
    pub change_anywhere: bool,
    /// Whether the spindle turns at every speed between the ends of its row.
    pub stepless: bool,
    /// From the spindle nose to the table with the quill retracted, least and greatest by the knee; absent if the
    /// record does not say.
    pub nose_to_table: Option<(Micrometres, Micrometres)>,
    /// From the spindle's axis to the column behind it; absent if the record does not say.
    pub spindle_to_column: Option<Micrometres>,
    /// Number of the spindle's 7:24 taper.
    pub taper: i64,
    /// Largest drill.
    pub drill_max: Micrometres,
    /// Largest overhang of a tool from the spindle's face.
    pub overhang_max: Micrometres,
    /// Largest end mill.
    pub end_mill_max: Micrometres,
    /// Largest tool of any kind: the face mill.
    pub tool_diameter_max: Micrometres,
    /// Largest mass of a tool with its holder, kg.
    pub tool_mass_max_kg: f64,
    /// Accuracy of position along an axis: σc of table A.6.
    pub position_accuracy: Micrometres,
    /// Circularity of a cylinder milled by contour; absent if the record does not say.
    pub roundness: Option<Micrometres>,
    /// Whether it cuts threads with a tap.
    pub can_tap: bool,
    /// Whether its control interpolates circles.
    pub contouring: bool,
    /// Cost of a minute, in the record's currency, where it is given.
    pub minute_rate: Option<f64>,
}

/// Rapids that move each axis on its own, so that the slower axis decides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rapid {
    /// Rate of each axis.
    pub rate: MillimetresPerMinute,
    /// Acceleration of each axis, where the machine's record has it.
    pub acceleration: Option<MillimetresPerSecondSquared>,
}

impl Rapid {
    /// Time of a rapid along one axis, min: `d/v`; with an acceleration `a` at both ends `d/v + v/a` for a travel of
    /// at least `v²/a`, `2·√(d/a)` for a shorter one (a trapezium and a triangle of speed over time). Textbook 1.3.1
    /// adds the same for acceleration, as εр.т.
    pub fn time(self, distance: Micrometres) -> Minutes {
        let (distance, rate) = (distance.abs().to_mm(), self.rate.0 / 60.0);
        let seconds = match self.acceleration.map(|acceleration| acceleration.0) {
            Some(acceleration) if acceleration > 0.0 && distance < rate * rate / acceleration => {
                2.0 * (distance / acceleration).sqrt()
            }
            Some(acceleration) if acceleration > 0.0 => distance / rate + rate / acceleration,
            _ => distance / rate,
        };
        Minutes(seconds / 60.0)
    }
}

/// The rows of a machine's record.
#[derive(Clone, Debug)]
struct Record<'k>(Vec<MachineRecord<'k>>);

impl<'k> Record<'k> {
    fn row(&self, quantity: Q) -> Option<&MachineRecord<'k>> {
        self.0.iter().find(|row| row.name == Named::Read(quantity))
    }

    fn values(&self, quantity: Q) -> Option<&[f64]> {
        self.row(quantity)?.value.as_deref()
    }
}

impl<'k> Machine<'k> {
    /// The rapids of its axes.
    pub const fn rapids(&self) -> Rapid {
        Rapid { rate: self.rapid, acceleration: self.rapid_acceleration }
    }

    /// The ids of the machines: each is a table `machine-…` that is such a record.
    pub fn ids(knowledge: &'k Knowledge) -> impl Iterator<Item = &'k str> {
        knowledge.tables_of::<MachineRecord<'_>>().filter_map(|table| table.id.strip_prefix("machine-"))
    }

    /// Its id.
    pub fn id(&self) -> &'k str {
        self.table.id.strip_prefix("machine-").unwrap_or(&self.table.id)
    }

    /// The machine of that id.
    ///
    /// # Errors
    /// There is no such machine, or its record lacks a quantity.
    pub fn find(knowledge: &'k Knowledge, id: &str) -> Result<Self, KnowledgeError> {
        let table = knowledge.table(&format!("machine-{id}"))?;
        let record = Record(table.rows().collect::<Result<_, _>>()?);
        let any = |quantity| record.values(quantity).and_then(|values| values.first().copied());
        let number = |quantity: Q| any(quantity).ok_or_else(|| KnowledgeError::no_row(table, quantity.name()));
        let length = |quantity| number(quantity).map(Micrometres::from_mm_rounded);
        let length_if_any = |quantity| any(quantity).map(Micrometres::from_mm_rounded);
        number(Q::SpindleSpeeds)?;
        Ok(Self {
            table,
            control: record.row(Q::Control).and_then(|row| row.text),
            table_length: length_if_any(Q::TableLength),
            table_width: length_if_any(Q::TableWidth),
            slots: any(Q::TSlots).is_some(),
            slot_width: length_if_any(Q::TSlotWidth),
            spindle_steps: record.values(Q::SpindleSpeeds).into_iter().flatten().copied().map(RevsPerMinute).collect(),
            spindle_power: Kilowatts(number(Q::SpindlePower)?),
            spindle_torque: NewtonMetres(number(Q::SpindleTorqueMax)?),
            thrust: Newtons(number(Q::ThrustZMax)?),
            feed_min: MillimetresPerMinute(number(Q::FeedMin)?),
            feed_max: MillimetresPerMinute(number(Q::FeedMax)?),
            rapid: MillimetresPerMinute(number(Q::RapidRate)?),
            rapid_acceleration: any(Q::RapidAcceleration).map(MillimetresPerSecondSquared),
            travel_x: length(Q::TravelX)?,
            travel_y: length(Q::TravelY)?,
            travel_z: length(Q::TravelZ)?,
            middle: [Q::TravelMiddleX, Q::TravelMiddleY].map(|own| length_if_any(own).unwrap_or_default()),
            resolution: length(Q::Resolution)?,
            load_max_kg: number(Q::LoadMassMax)?,
            magazine: (number(Q::MagazinePlaces)? as usize).max(1),
            tool_change: Minutes(number(Q::ToolChangeTime)? / 60.0),
            tool_change_at: (length(Q::ToolChangeX)?, length(Q::ToolChangeY)?),
            tool_change_z: length(Q::ToolChangeZ)?,
            change_anywhere: any(Q::ChangeAnywhere).is_some_and(|yes| yes > 0.0),
            stepless: any(Q::SpindleStepless).is_some_and(|yes| yes > 0.0),
            nose_to_table: length_if_any(Q::NoseToTableMin).zip(length_if_any(Q::NoseToTableMax)),
            spindle_to_column: length_if_any(Q::SpindleToColumn),
            taper: number(Q::SpindleTaper)? as i64,
            drill_max: length(Q::DrillDiameterMax)?,
            overhang_max: length(Q::ToolOverhangMax)?,
            end_mill_max: length(Q::EndMillDiameterMax)?,
            tool_diameter_max: length(Q::FaceMillDiameterMax)?,
            tool_mass_max_kg: number(Q::ToolMassMax)?,
            position_accuracy: length(Q::PositionAccuracy)?,
            roundness: length_if_any(Q::RoundnessAccuracy),
            can_tap: number(Q::CanTap)? > 0.0,
            contouring: number(Q::Contouring)? > 0.0,
            minute_rate: any(Q::MinuteRate),
            record,
        })
    }

    /// Travel along an axis, of the whole stroke.
    pub const fn travel(&self, axis: Axis) -> Micrometres {
        match axis {
            Axis::X => self.travel_x,
            Axis::Y => self.travel_y,
            Axis::Z => self.travel_z,
        }
    }

    /// Where the tool is changed, machine coordinates.
    pub const fn change_place(&self) -> [Micrometres; 3] {
        [self.tool_change_at.0, self.tool_change_at.1, self.tool_change_z]
    }

    /// The axes along which the tool change asks for its place.
    pub const fn change_axes(&self) -> &'static [Axis] {
        if self.change_anywhere { &[Axis::Z] } else { &Axis::ALL }
    }

    /// Its characteristics as the record has them, each in the unit of its row.
    pub fn characteristics(&self) -> impl Iterator<Item = Characteristic<'_>> {
        self.record.0.iter().map(|row| Characteristic {
            name: match row.name {
                Named::Read(quantity) => quantity.name(),
                Named::Other(name) => name,
            },
            values: row.value.as_deref().unwrap_or_default(),
            unit: row.unit.and_then(|unit| unit.parse().ok()).unwrap_or(Unit::None),
            text: row.text,
        })
    }

    /// The range of an axis in machine coordinates, least and greatest: X and Y about the middle of their travels, Z down from zero
    /// (textbook, l. 4719-4728).
    pub fn range(&self, axis: Axis) -> (Micrometres, Micrometres) {
        let around = |middle: Micrometres, travel: Micrometres| (middle - travel.half(), middle + travel.half());
        match axis {
            Axis::X => around(self.middle[0], self.travel_x),
            Axis::Y => around(self.middle[1], self.travel_y),
            Axis::Z => (-self.travel_z, Micrometres::ZERO),
        }
    }

    /// The row of a quantity, for citing it.
    ///
    /// # Errors
    /// The record does not name it.
    pub fn row(&self, quantity: Q) -> Result<RowRef<'k>, KnowledgeError> {
        let row = self.record.row(quantity).ok_or_else(|| KnowledgeError::no_row(self.table, quantity.name()))?;
        Ok(row.row)
    }
}

#[cfg(test)]
mod tests {
    use super::id_of;

    #[test]
    fn machines_are_named_as_the_workshop_does() {
        for (typed, id) in [
            ("gf2171", "gf2171"),
            ("ГФ2171", "gf2171"),
            ("ГФ 2171", "gf2171"),
            ("ИР500ПМФ4", "ir500pmf4"),
            ("16К20Ф3", "16k20f3"),
            ("16Б16Т1", "16b16t1"),
            ("1740РФ3", "1740rf3"),
        ] {
            assert_eq!(id_of(typed), id);
        }
    }
}
