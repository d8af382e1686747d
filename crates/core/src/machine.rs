//! The machine's limits, from its record in catalogs/machines.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, RowRef, Table};
use crate::units::{
    Kilowatts, Micrometres, MillimetresPerMinute, MillimetresPerSecondSquared, Minutes, NewtonMetres, Newtons,
    RevsPerMinute,
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

    /// The axis of a letter.
    pub const fn of(letter: char) -> Option<Self> {
        match letter {
            'X' => Some(Self::X),
            'Y' => Some(Self::Y),
            'Z' => Some(Self::Z),
            _ => None,
        }
    }

    /// Its number, from 0: the place in arrays of three.
    pub const fn index(self) -> usize {
        self as usize
    }
}

/// A machine as planning sees it.
#[derive(Clone, Debug)]
pub struct Machine<'k> {
    /// Its record.
    pub table: &'k Table,
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
    /// The least step that it can be told to go.
    pub resolution: Micrometres,
    /// Largest mass of a part, kg.
    pub load_max_kg: f64,
    /// Places of the magazine.
    pub magazine: usize,
    /// Time of one tool change.
    pub tool_change: Minutes,
    /// Where the table stands for a tool change.
    pub tool_change_at: (Micrometres, Micrometres),
    /// Where the quill stands for a tool change.
    pub tool_change_z: Micrometres,
    /// From the spindle's nose to the table with the quill up, least and greatest by the knee; absent where the record
    /// does not say.
    pub nose_to_table: Option<(Micrometres, Micrometres)>,
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
    /// Roundness of a cylinder milled by contour; absent where the record does not say.
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
    /// Time of a rapid along one axis, min: `d/v`, and with an acceleration `a` that both speeds up and slows
    /// down `d/v + v/a` for a way of at least `v²/a`, `2·√(d/a)` for a shorter one (a trapezium and a triangle
    /// of speed over time). Textbook 1.3.1 adds the same to the way of speeding up, as εр.т.
    pub fn time(self, way: Micrometres) -> Minutes {
        let (way, rate) = (way.abs().to_mm(), self.rate.0 / 60.0);
        let seconds = match self.acceleration.map(|acceleration| acceleration.0) {
            Some(acceleration) if acceleration > 0.0 && way < rate * rate / acceleration => {
                2.0 * (way / acceleration).sqrt()
            }
            Some(acceleration) if acceleration > 0.0 => way / rate + rate / acceleration,
            _ => way / rate,
        };
        Minutes(seconds / 60.0)
    }
}

impl<'k> Machine<'k> {
    /// How its axes move in rapids.
    pub const fn rapids(&self) -> Rapid {
        Rapid { rate: self.rapid, acceleration: self.rapid_acceleration }
    }

    /// The machine of that id.
    ///
    /// # Errors
    /// There is no such machine, or its record lacks a quantity.
    pub fn find(knowledge: &'k Knowledge, id: &str) -> Result<Self, KnowledgeError> {
        let table = knowledge.table(&format!("machine-{id}"))?;
        let number = |name: &str| numbers(table, name).map(|values| values.first().copied().unwrap_or_default());
        let length = |name: &str| number(name).map(Micrometres::from_mm_rounded);
        Ok(Self {
            table,
            spindle_steps: numbers(table, "spindle-speeds")?.into_iter().map(RevsPerMinute).collect(),
            spindle_power: Kilowatts(number("spindle-power")?),
            spindle_torque: NewtonMetres(number("spindle-torque-max")?),
            thrust: Newtons(number("thrust-z-max")?),
            feed_min: MillimetresPerMinute(number("feed-min")?),
            feed_max: MillimetresPerMinute(number("feed-max")?),
            rapid: MillimetresPerMinute(number("rapid-rate")?),
            rapid_acceleration: number("rapid-acceleration").ok().map(MillimetresPerSecondSquared),
            travel_x: length("travel-x")?,
            travel_y: length("travel-y")?,
            travel_z: length("travel-z")?,
            resolution: length("resolution")?,
            load_max_kg: number("load-mass-max")?,
            magazine: number("magazine-places")? as usize,
            tool_change: Minutes(number("tool-change-time")? / 60.0),
            tool_change_at: (length("tool-change-x")?, length("tool-change-y")?),
            tool_change_z: length("tool-change-z")?,
            nose_to_table: length("nose-to-table-min").ok().zip(length("nose-to-table-max").ok()),
            taper: number("spindle-taper")? as i64,
            drill_max: length("drill-diameter-max")?,
            overhang_max: length("tool-overhang-max")?,
            end_mill_max: length("end-mill-diameter-max")?,
            tool_diameter_max: length("face-mill-diameter-max")?,
            tool_mass_max_kg: number("tool-mass-max")?,
            position_accuracy: length("position-accuracy")?,
            roundness: length("roundness-accuracy").ok(),
            can_tap: number("can-tap")? > 0.0,
            contouring: number("contouring")? > 0.0,
            minute_rate: number("minute-rate").ok(),
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

    /// The row of a quantity.
    ///
    /// # Errors
    /// The record does not name it.
    pub fn row(&self, name: &str) -> Result<RowRef<'k>, KnowledgeError> {
        row(self.table, name)
    }
}

fn row<'k>(table: &'k Table, name: &str) -> Result<RowRef<'k>, KnowledgeError> {
    table.find("name", name).ok_or_else(|| KnowledgeError::no_row(table, name))
}

/// The figures of a quantity; `lint` has proven that their unit is the one the schema names.
fn numbers(table: &Table, name: &str) -> Result<Vec<f64>, KnowledgeError> {
    Ok(row(table, name)?.numbers("value"))
}
