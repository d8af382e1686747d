//! The control's language as data: functions, groups, addresses, planes, cycles and limits, from catalogs/controls.

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, RowRef, Table, Value};
use crate::motion::{Axis, Plane};
use crate::program::setting::Limits;
use crate::program::{figures, letter};

/// What an M function makes the control do: the column `action` of table 2c42-65-m-actions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    Stop,
    OptionalStop,
    End,
    Return,
    SpindleClockwise,
    SpindleCounterclockwise,
    SpindleStop,
    ToolChange,
    CoolantOn,
    CoolantOff,
}

/// An M function of the tables.
#[derive(Clone, Copy, Debug)]
pub(super) struct MFunction {
    /// What it does.
    pub action: Action,
    /// Whether it acts before the motion of its block.
    pub at_start: bool,
    /// Whether at most one such may stand in a block.
    pub exclusive: bool,
}

/// What may stand behind an address.
#[derive(Clone, Copy, Debug)]
pub(super) struct Address {
    /// Least and greatest number as written, in thousandths.
    pub limits: Option<(i64, i64)>,
    /// Whether it may have a decimal point.
    pub decimal: bool,
    /// Whether it counts millimetres.
    pub length: bool,
}

/// A plane function: table 3.6.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlaneRow {
    pub plane: Plane,
    /// The axis of length correction.
    pub length_axis: Axis,
    /// The axis of cycles.
    pub cycle_axis: Axis,
    /// The address of a helix' pitch.
    pub pitch: char,
}

/// A cycle: table 2c42-65-cycles.
#[derive(Clone, Debug)]
pub(super) struct Cycle {
    /// Parameters without which it does not run.
    pub required: Vec<char>,
    /// Parameters it may have.
    pub optional: Vec<char>,
    /// Whether it goes to point 2 in steps.
    pub in_steps: bool,
    /// Whether it leaves to point 3 at feed.
    pub out_at_feed: bool,
}

/// What belongs to the codes of functions, or to the letters of addresses: an array, since every word asks for it.
#[derive(Clone, Debug)]
pub(super) struct ByCode<T>(Vec<Option<T>>);

impl<T> ByCode<T> {
    fn new() -> Self {
        Self((0..=u8::MAX).map(|_| None).collect())
    }

    fn insert(&mut self, code: u8, content: T) {
        self.0[usize::from(code)] = Some(content);
    }

    /// What belongs to a code.
    pub(super) fn get(&self, code: u8) -> Option<&T> {
        self.0[usize::from(code)].as_ref()
    }

    /// Whether anything belongs to a code.
    pub(super) fn has(&self, code: u8) -> bool {
        self.get(code).is_some()
    }

    /// What belongs to an address.
    pub(super) fn of(&self, address: char) -> Option<&T> {
        self.get(u8::try_from(address).ok()?)
    }
}

/// The language.
#[derive(Clone, Debug)]
pub struct Control {
    /// G code to group.
    pub(super) groups: ByCode<usize>,
    /// The code of every group that is set at power-on; 0 where the group has none.
    pub(super) power_on: [u8; GROUPS],
    pub(super) m_functions: ByCode<MFunction>,
    pub(super) addresses: ByCode<Address>,
    pub(super) planes: ByCode<PlaneRow>,
    pub(super) cycles: ByCode<Cycle>,
    /// G45…G48: how many offsets are added to the motion.
    pub(super) offsets: ByCode<i64>,
    /// G17…G19: the words that G45…G48 act on.
    pub(super) offset_words: ByCode<Vec<char>>,
    pub(super) block_length: usize,
    pub(super) memory_bytes: usize,
    pub(super) programs: usize,
    pub(super) depth: usize,
    pub(super) m_per_block: usize,
    /// Dwells are counted in so many of a second.
    pub(super) dwell_step_s: f64,
    pub(super) setting: Limits,
}

/// Groups 00 to 07 of table 3.5.
pub(super) const GROUPS: usize = 8;

impl Control {
    /// Reads the language from the tables.
    ///
    /// # Errors
    /// A table is missing or lacks what is asked of it.
    pub fn read(knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let record = knowledge.table("control-2c42-65")?;
        let number = |name: &str| -> Result<f64, KnowledgeError> {
            figures(record, name)?.first().copied().ok_or_else(|| KnowledgeError::no_row(record, name))
        };
        let count = |name: &str| number(name).map(|value| value as usize);
        let mut control = Self {
            groups: ByCode::new(),
            power_on: [0; GROUPS],
            m_functions: ByCode::new(),
            addresses: addresses(knowledge.table("2c42-65-addresses")?, number("dwell-step")?)?,
            planes: ByCode::new(),
            cycles: ByCode::new(),
            offsets: ByCode::new(),
            offset_words: ByCode::new(),
            block_length: count("block-length-max")?,
            memory_bytes: count("memory")? * 1024,
            programs: count("programs-max")?,
            depth: count("subprogram-depth-max")?,
            m_per_block: count("m-functions-per-block-max")?,
            dwell_step_s: number("dwell-step")?,
            setting: Limits {
                correctors: number("correctors")? as i64,
                feed_overrides: figures(record, "feed-override")?.into_iter().map(|value| value as i64).collect(),
                speed_overrides: figures(record, "spindle-override")?.into_iter().map(|value| value as i64).collect(),
                panel_2c42_65: true,
                pecks: false,
            },
        };
        control.read_functions(knowledge)?;
        control.read_planes_and_cycles(knowledge)?;
        Ok(control)
    }

    /// What of a setting it has.
    pub const fn setting(&self) -> &Limits {
        &self.setting
    }

    fn read_functions(&mut self, knowledge: &Knowledge) -> Result<(), KnowledgeError> {
        let table = knowledge.table("2c42-65-g-functions")?;
        for row in table.all_rows() {
            let code = code(row)?;
            let group: usize = row.text("group")?.parse().unwrap_or(GROUPS);
            let Some(slot) = self.power_on.get_mut(group) else {
                return Err(KnowledgeError::lacks(&table.id, "a group of 00 to 07 for every function"));
            };
            if row.flag("power_on") {
                *slot = code;
            }
            self.groups.insert(code, group);
        }
        let exclusive = knowledge.table("2c42-65-m-functions")?;
        let table = knowledge.table("2c42-65-m-actions")?;
        for row in table.all_rows() {
            let action = match row.text("action")? {
                "stop" => Action::Stop,
                "optional-stop" => Action::OptionalStop,
                "end" => Action::End,
                "return" => Action::Return,
                "spindle-clockwise" => Action::SpindleClockwise,
                "spindle-counterclockwise" => Action::SpindleCounterclockwise,
                "spindle-stop" => Action::SpindleStop,
                "tool-change" => Action::ToolChange,
                "coolant-on" => Action::CoolantOn,
                "coolant-off" => Action::CoolantOff,
                other => return Err(KnowledgeError::lacks(&table.id, other)),
            };
            let function = MFunction {
                action,
                at_start: row.text("acts")? == "start",
                exclusive: exclusive.find("code", row.text("code")?).is_some_and(|row| row.flag("exclusive")),
            };
            self.m_functions.insert(code(row)?, function);
        }
        Ok(())
    }

    fn read_planes_and_cycles(&mut self, knowledge: &Knowledge) -> Result<(), KnowledgeError> {
        let table = knowledge.table("2c42-65-planes")?;
        for row in table.all_rows() {
            let axis = |column: &str| -> Result<Axis, KnowledgeError> {
                let letter = letter(row.text(column)?);
                Axis::of(letter).ok_or_else(|| KnowledgeError::lacks(&table.id, "an axis X, Y or Z"))
            };
            let plane = match row.text("plane")? {
                "XY" => Plane::Xy,
                "ZX" => Plane::Zx,
                "YZ" => Plane::Yz,
                other => return Err(KnowledgeError::lacks(&table.id, other)),
            };
            let content = PlaneRow {
                plane,
                length_axis: axis("length_axis")?,
                cycle_axis: axis("cycle_axis")?,
                pitch: letter(row.text("pitch_word")?),
            };
            self.planes.insert(code(row)?, content);
        }
        for row in knowledge.table("2c42-65-cycles")?.all_rows() {
            // G80 has no motions.
            let Ok(inwards) = row.text("motion_1_2") else { continue };
            let letters =
                |column: &str| -> Vec<char> { row.texts(column).unwrap_or_default().into_iter().map(letter).collect() };
            let cycle = Cycle {
                required: letters("required"),
                optional: letters("optional_words"),
                in_steps: inwards == "feed-in-steps",
                out_at_feed: row.text("motion_2_3")? == "feed",
            };
            self.cycles.insert(code(row)?, cycle);
        }
        for row in knowledge.table("2c42-65-tool-offset")?.all_rows() {
            match row.value("factor") {
                Some(Value::Number(factor, _)) => {
                    self.offsets.insert(code(row)?, factor.to_int().unwrap_or_default());
                }
                _ => {
                    let words = row.texts("words")?.into_iter().map(letter).collect();
                    self.offset_words.insert(code(row)?, words);
                }
            }
        }
        Ok(())
    }

    /// The row of a plane function.
    pub(super) fn plane(&self, code: u8) -> PlaneRow {
        // Only codes of group 02 get here, and every one of them has a row; G17's values stand for a table without.
        self.planes.get(code).copied().unwrap_or(PlaneRow {
            plane: Plane::Xy,
            length_axis: Axis::Z,
            cycle_axis: Axis::Z,
            pitch: 'K',
        })
    }
}

/// The number of a code such as `G54`.
fn code(row: RowRef<'_>) -> Result<u8, KnowledgeError> {
    let text = row.text("code")?;
    let digits = text.trim_start_matches(|c: char| !c.is_ascii_digit());
    digits.parse().map_err(|_| KnowledgeError::lacks(&row.table.id, "a code such as G01"))
}

/// The addresses with the limits of their numbers as these are written: a dwell is written in its steps.
fn addresses(table: &Table, dwell_step: f64) -> Result<ByCode<Address>, KnowledgeError> {
    let mut addresses = ByCode::new();
    for row in table.all_rows() {
        let unit = row.text("unit").unwrap_or_default();
        let scale = if unit == "s" { 1.0 / dwell_step } else { 1.0 };
        let limit = |column: &str| match row.value(column) {
            Some(Value::Number(number, _)) => Some(libm::round(number.to_f64() * scale * 1000.0) as i64),
            _ => None,
        };
        let address = Address {
            limits: limit("minimum").zip(limit("maximum")),
            // Dimension words and feeds; everything else counts whole things (3.8.2).
            decimal: matches!(unit, "mm" | "deg" | "mm/min"),
            length: unit == "mm",
        };
        let letter = u8::try_from(letter(row.text("address")?));
        addresses.insert(letter.map_err(|_| KnowledgeError::lacks(&table.id, "an address of one letter"))?, address);
    }
    Ok(addresses)
}
