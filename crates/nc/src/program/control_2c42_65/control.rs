//! The control's language as data: functions, groups, addresses, planes, cycles and limits, from catalogs/controls.

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, RowRef};
use crate::motion::{Axis, Plane};
use crate::program::alone::Habits;
use crate::program::setting::Limits;
use crate::program::{in_unit, letters};
use crate::tables::controls::Acts;
use crate::tables::controls::control_2c42_65::{
    AddressUnit, Addresses, AxisName, Characteristic, Cycles, GFunctions, Inwards, MActions, MFunctions, Outwards,
    PlaneName, Planes, Record, ToolOffset,
};
use crate::units::Micrometres;
use technolog_note::note;

pub(super) use crate::tables::controls::control_2c42_65::Action;

/// An M function of the tables.
#[derive(Clone, Copy, Debug)]
pub(super) struct MFunction {
    /// What it does.
    pub action: Action,
    /// Whether it acts before the motion of its block.
    pub at_start: bool,
    /// Whether a block may have only one of these.
    pub exclusive: bool,
}

/// The numbers that may follow an address.
#[derive(Clone, Copy, Debug)]
pub(super) struct Address {
    /// Least and greatest number as written, in thousandths.
    pub limits: Option<(i64, i64)>,
    /// Whether it may have a decimal point.
    pub decimal: bool,
    /// Whether its numbers are millimetres.
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
    /// The required parameters.
    pub required: Vec<char>,
    /// Parameters it may have.
    pub optional: Vec<char>,
    /// Whether it feeds to point 2 in steps.
    pub in_steps: bool,
    /// Whether it retracts to point 3 at feed.
    pub out_at_feed: bool,
}

/// Values by the codes of functions or the letters of addresses: an array, because every word needs it.
#[derive(Clone, Debug)]
pub(super) struct ByCode<T>(Vec<Option<T>>);

impl<T> ByCode<T> {
    fn new() -> Self {
        Self((0..=u8::MAX).map(|_| None).collect())
    }

    fn insert(&mut self, code: u8, content: T) {
        self.0[usize::from(code)] = Some(content);
    }

    /// The value for a code.
    pub(super) fn get(&self, code: u8) -> Option<&T> {
        self.0[usize::from(code)].as_ref()
    }

    /// Whether there is a value for a code.
    pub(super) fn contains(&self, code: u8) -> bool {
        self.get(code).is_some()
    }

    /// The value for an address.
    pub(super) fn for_address(&self, address: char) -> Option<&T> {
        self.get(u8::try_from(address).ok()?)
    }
}

/// The language.
#[derive(Clone, Debug)]
pub struct Control {
    /// G code to group.
    pub(super) groups: ByCode<usize>,
    /// The code of every group in force at power-on; 0 where the group has none.
    pub(super) power_on: [u8; GROUPS],
    pub(super) m_functions: ByCode<MFunction>,
    pub(super) addresses: ByCode<Address>,
    pub(super) planes: ByCode<PlaneRow>,
    pub(super) cycles: ByCode<Cycle>,
    /// G45…G48: the number of offsets added to the motion.
    pub(super) offsets: ByCode<i64>,
    /// G17…G19: the words that G45…G48 change.
    pub(super) offset_words: ByCode<Vec<char>>,
    pub(super) block_length: usize,
    pub(super) memory_bytes: usize,
    pub(super) programs: usize,
    pub(super) depth: usize,
    pub(super) m_per_block: usize,
    /// The unit of dwells, s.
    pub(super) dwell_step_s: f64,
    pub(super) habits: Habits,
    pub(super) setting: Limits,
    tape_start: String,
    described_on: String,
}

/// Groups 00 to 07 of table 3.5.
pub(super) const GROUPS: usize = 8;

impl Control {
    /// Reads the language from the tables.
    ///
    /// # Errors
    /// A table is missing or lacks what is required of it.
    pub fn read(knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let table = knowledge.table_of::<Record<'_>>()?;
        let record: Vec<Record<'_>> = table.rows().collect::<Result<_, _>>()?;
        let figures = |name: Characteristic| -> Result<(f64, Vec<f64>), KnowledgeError> {
            let row = record.iter().find(|row| row.name.is(name));
            let row = row.ok_or_else(|| KnowledgeError::no_row(table, name.name()))?;
            in_unit(row.value.as_deref(), row.unit, name.unit(), row.row)
        };
        let number = |name| figures(name).map(|(first, _)| first);
        let text = |name: Characteristic| {
            let row = record.iter().find(|row| row.name.is(name)).and_then(|row| row.text);
            row.map(str::to_owned).ok_or_else(|| KnowledgeError::no_row(table, name.name()))
        };
        let count = |name| number(name).map(|value| value as usize);
        let steps = |name| figures(name).map(|(_, all)| all.into_iter().map(|value| value as i64).collect());
        let dwell_step_s = number(Characteristic::DwellStep)?;
        let mut control = Self {
            groups: ByCode::new(),
            power_on: [0; GROUPS],
            m_functions: ByCode::new(),
            addresses: addresses(knowledge, dwell_step_s)?,
            planes: ByCode::new(),
            cycles: ByCode::new(),
            offsets: ByCode::new(),
            offset_words: ByCode::new(),
            block_length: count(Characteristic::BlockLengthMax)?,
            memory_bytes: count(Characteristic::Memory)? * 1024,
            programs: count(Characteristic::ProgramsMax)?,
            depth: count(Characteristic::SubprogramDepthMax)?,
            m_per_block: count(Characteristic::MFunctionsPerBlockMax)?,
            dwell_step_s,
            // The length of every tool stands in a corrector (3.11.3), that of the reference tool too.
            habits: Habits::read(knowledge)?.with_lengths(true),
            setting: Limits {
                correctors: number(Characteristic::Correctors)? as i64,
                feed_overrides: steps(Characteristic::FeedOverride)?,
                speed_overrides: steps(Characteristic::SpindleOverride)?,
                panel_2c42_65: true,
                pecks: false,
                most: Some(Micrometres::from_mm_rounded(number(Characteristic::CorrectorValueMax)?)),
                decimal: false,
            },
            tape_start: text(Characteristic::TapeStart)?,
            described_on: text(Characteristic::DescribedOn)?,
        };
        control.read_functions(knowledge)?;
        control.read_planes_and_cycles(knowledge)?;
        Ok(control)
    }

    /// What a tape begins with; what stands before the program behind it is passed over.
    pub(in crate::program) fn tape_start(&self) -> &str {
        &self.tape_start
    }

    /// The machine of its description.
    pub(in crate::program) fn described_on(&self) -> &str {
        &self.described_on
    }

    /// The parts of a setting that this control has.
    pub const fn setting(&self) -> &Limits {
        &self.setting
    }

    fn read_functions(&mut self, knowledge: &Knowledge) -> Result<(), KnowledgeError> {
        for row in knowledge.rows::<GFunctions<'_>>()? {
            let code = code(row.code, row.row)?;
            let group: usize = row.group.parse().unwrap_or(GROUPS);
            let Some(slot) = self.power_on.get_mut(group) else {
                return Err(KnowledgeError::missing(&row.row.table.id, note!("nc-group-for-every-function")));
            };
            if row.power_on {
                *slot = code;
            }
            self.groups.insert(code, group);
        }
        let functions: Vec<MFunctions<'_>> = knowledge.rows()?;
        for row in knowledge.rows::<MActions<'_>>()? {
            let function = MFunction {
                action: row.action,
                at_start: row.acts == Acts::Start,
                exclusive: functions.iter().any(|one| one.code == row.code && one.exclusive),
            };
            self.m_functions.insert(code(row.code, row.row)?, function);
        }
        Ok(())
    }

    fn read_planes_and_cycles(&mut self, knowledge: &Knowledge) -> Result<(), KnowledgeError> {
        for row in knowledge.rows::<Planes<'_>>()? {
            let content = PlaneRow {
                plane: match row.plane {
                    PlaneName::Xy => Plane::Xy,
                    PlaneName::Zx => Plane::Zx,
                    PlaneName::Yz => Plane::Yz,
                },
                length_axis: axis(row.length_axis),
                cycle_axis: axis(row.cycle_axis),
                pitch: row.pitch_word.0,
            };
            self.planes.insert(code(row.code, row.row)?, content);
        }
        for row in knowledge.rows::<Cycles<'_>>()? {
            // G80 has no motions.
            let Some(inwards) = row.motion_1_2 else { continue };
            let cycle = Cycle {
                required: letters(row.required.unwrap_or_default()),
                optional: letters(row.optional_words.unwrap_or_default()),
                in_steps: inwards == Inwards::FeedInSteps,
                out_at_feed: row.motion_2_3 == Some(Outwards::Feed),
            };
            self.cycles.insert(code(row.code, row.row)?, cycle);
        }
        for row in knowledge.rows::<ToolOffset<'_>>()? {
            let code = code(row.code, row.row)?;
            match row.factor {
                Some(factor) => self.offsets.insert(code, factor as i64),
                None => self.offset_words.insert(code, letters(row.words.unwrap_or_default())),
            }
        }
        Ok(())
    }

    /// The row of a plane function.
    pub(super) fn plane(&self, code: u8) -> PlaneRow {
        // Only codes of group 02 reach this point, and each of them has a row; the values of G17 are a fallback.
        self.planes.get(code).copied().unwrap_or(PlaneRow {
            plane: Plane::Xy,
            length_axis: Axis::Z,
            cycle_axis: Axis::Z,
            pitch: 'K',
        })
    }
}

/// The number of a code such as `G54`.
fn code(text: &str, row: RowRef<'_>) -> Result<u8, KnowledgeError> {
    let digits = text.trim_start_matches(|c: char| !c.is_ascii_digit());
    digits.parse().map_err(|_| KnowledgeError::missing(&row.table.id, note!("nc-code-such-g")))
}

const fn axis(name: AxisName) -> Axis {
    match name {
        AxisName::X => Axis::X,
        AxisName::Y => Axis::Y,
        AxisName::Z => Axis::Z,
    }
}

/// The addresses with the limits of their numbers as written; a dwell is written in steps of time.
fn addresses(knowledge: &Knowledge, dwell_step: f64) -> Result<ByCode<Address>, KnowledgeError> {
    use AddressUnit::{Degrees, Millimetres, MillimetresPerMinute, Seconds};
    let mut addresses = ByCode::new();
    for row in knowledge.rows::<Addresses<'_>>()? {
        let scale = if row.unit == Some(Seconds) { 1.0 / dwell_step } else { 1.0 };
        let limit = |number: f64| libm::round(number * scale * 1000.0) as i64;
        let address = Address {
            limits: row.minimum.map(limit).zip(row.maximum.map(limit)),
            // Dimension words and feeds; all other words are whole numbers (3.8.2).
            decimal: matches!(row.unit, Some(Millimetres | Degrees | MillimetresPerMinute)),
            length: row.unit == Some(Millimetres),
        };
        let lacks = |_| KnowledgeError::missing(&row.row.table.id, note!("nc-address-one-letter"));
        addresses.insert(u8::try_from(row.address.0).map_err(lacks)?, address);
    }
    Ok(addresses)
}
