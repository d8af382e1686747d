//! The language of a control as data: functions, groups, addresses, cycles and limits, from catalogs/controls.

use std::collections::BTreeMap;
use technolog_note::note;

use crate::error::KnowledgeError;
use crate::knowledge::contract::Word;
use crate::knowledge::{Knowledge, RowRef, Table};
use crate::program::setting::Limits;
use crate::program::{in_unit, letters};
use crate::tables::controls::Acts;
use crate::tables::controls::iso::{
    ActiveComments, Addresses, Characteristic, Cycles, GFunctions, MFunctions, MGroup, NotCarriedOut, Record,
};
use crate::units::Micrometres;

pub use crate::tables::controls::iso::IsoControl;
pub(super) use crate::tables::controls::iso::{Action, Bottom, CommentAct, Effect, Group, Inwards, Outwards, Written};

/// A G function.
#[derive(Clone, Copy, Debug)]
pub(super) struct GFunction {
    pub group: Group,
    pub effect: Effect,
}

/// An M function.
#[derive(Clone, Debug)]
pub(super) struct MFunction {
    pub action: Action,
    /// Whether it acts before the motion of its block.
    pub at_start: bool,
    /// Its group; LinuxCNC permits one function of a group in a block.
    pub group: MGroup,
}

/// A cycle: table iso-cycles.
#[derive(Clone, Debug)]
pub(super) struct Cycle {
    pub required: Vec<char>,
    pub optional: Vec<char>,
    pub inwards: Inwards,
    pub bottom: Bottom,
    pub outwards: Outwards,
}

/// A word that is not carried out here: table iso-not-carried-out.
#[derive(Clone, Debug)]
pub(super) struct Passed {
    /// The addresses that it takes with it.
    pub takes: Vec<char>,
    /// The address that names it together with its code.
    pub named_by: Option<char>,
    /// Whether nothing of its block is carried out but modes and machine functions.
    pub whole: bool,
    /// Whether that holds for the blocks behind it, until the next function of motion or cycle.
    pub goes_on: bool,
    /// Whether it changes no motion.
    pub harmless: bool,
}

/// A comment that the control executes.
#[derive(Clone, Debug)]
pub(super) struct ActiveComment {
    /// What it begins with, in capitals.
    pub begins: String,
    pub act: CommentAct,
    /// Whether it also acts after a semicolon.
    pub after_semicolon: bool,
    /// Whether it acts only if nothing follows it.
    pub nothing_follows: bool,
}

/// The language of a control.
#[derive(Clone, Debug)]
pub struct Control {
    pub(in crate::program) kind: IsoControl,
    /// G functions by their codes in tenths: 911 is G91.1.
    pub(super) g: BTreeMap<i64, GFunction>,
    /// The codes in force after power-on.
    pub(super) power_on: Vec<i64>,
    pub(super) m: BTreeMap<i64, MFunction>,
    pub(super) addresses: BTreeMap<char, Written>,
    /// What is not carried out: G functions in tenths, M functions, addresses.
    pub(super) passed_g: BTreeMap<i64, Passed>,
    pub(super) passed_m: BTreeMap<i64, Passed>,
    pub(super) passed_addresses: BTreeMap<char, Passed>,
    pub(super) active_comments: Vec<ActiveComment>,
    pub(super) cycles: BTreeMap<i64, Cycle>,
    pub(super) depth: usize,
    pub(super) m_per_block: usize,
    /// The unit of P in a dwell, s.
    pub(super) dwell_unit_s: f64,
    /// The permitted difference between the radii at start and end of an arc, mm, and as a part of the radius.
    pub(super) arc_tolerance: (f64, f64),
    /// The distance above the metal where the rapid of G83 ends; the retract of G73.
    pub(super) pecks: (Micrometres, Micrometres),
    /// Whether cycles and motions are one group, so that a block may have one of them.
    pub(super) cycles_are_motions: bool,
    pub(super) small_letters: bool,
    /// Whether subprograms are written with o-words.
    pub(in crate::program) o_words: bool,
    /// Whether G43 without H takes the offset register of the tool in the spindle.
    pub(super) length_of_tool: bool,
    setting: Limits,
}

impl Control {
    /// Reads the language from the tables.
    ///
    /// # Errors
    /// There is no such control, or a table lacks what is needed.
    pub fn read(control: &str, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let table = knowledge.table(&format!("control-{control}"))?;
        let lacks = || KnowledgeError::missing(&table.id, note!("nc-interpreter", control = control));
        let kind = IsoControl::from_word(control).ok_or_else(lacks)?;
        let record: Vec<Record<'_>> = table.rows().collect::<Result<_, _>>()?;
        let figures = |name| figures(&record, name, table);
        let number = |name| figures(name).map(|(first, _)| first);
        let count = |name| number(name).map(|value| value as usize);
        let flag = |name| number(name).map(|value| value > 0.0);
        let length = |name| number(name).map(Micrometres::from_mm_rounded);
        let mut language = Self {
            kind,
            g: BTreeMap::new(),
            power_on: Vec::new(),
            m: BTreeMap::new(),
            addresses: BTreeMap::new(),
            passed_g: BTreeMap::new(),
            passed_m: BTreeMap::new(),
            passed_addresses: BTreeMap::new(),
            active_comments: Vec::new(),
            cycles: BTreeMap::new(),
            depth: count(Characteristic::SubprogramDepthMax)?,
            m_per_block: count(Characteristic::MFunctionsPerBlockMax)?,
            dwell_unit_s: number(Characteristic::DwellUnit)?,
            arc_tolerance: (number(Characteristic::ArcTolerance)?, number(Characteristic::ArcToleranceRelative)?),
            pecks: (length(Characteristic::G83Clearance)?, length(Characteristic::G73Retract)?),
            cycles_are_motions: flag(Characteristic::CyclesAreMotions)?,
            small_letters: flag(Characteristic::WordsInSmallLetters)?,
            o_words: flag(Characteristic::OWords)?,
            length_of_tool: flag(Characteristic::LengthOfToolInSpindle)?,
            setting: Limits {
                correctors: number(Characteristic::Correctors)? as i64,
                feed_overrides: steps(&figures(Characteristic::FeedOverride)?.1),
                speed_overrides: steps(&figures(Characteristic::SpindleOverride)?.1),
                panel_2c42_65: false,
                pecks: flag(Characteristic::PecksOfSetting)?,
                most: None,
                decimal: kind == IsoControl::Fanuc,
            },
        };
        language.read_words(knowledge)?;
        Ok(language)
    }

    /// Whether a word of the control has that address, carried out or not.
    pub(super) fn knows_address(&self, address: char) -> bool {
        let passed = self.passed_g.values().chain(self.passed_m.values());
        self.addresses.contains_key(&address)
            || self.passed_addresses.contains_key(&address)
            || passed.flat_map(|passed| &passed.takes).any(|taken| *taken == address)
    }

    /// The parts of a setting that this control has.
    pub const fn setting(&self) -> &Limits {
        &self.setting
    }

    /// The rows of the tables iso-… that name the control.
    fn read_words(&mut self, knowledge: &Knowledge) -> Result<(), KnowledgeError> {
        let kind = self.kind;
        for row in knowledge.rows::<Addresses<'_>>()?.into_iter().filter(|row| row.controls.contains(&kind)) {
            self.addresses.insert(row.address.0, row.kind);
        }
        for row in knowledge.rows::<ActiveComments<'_>>()?.into_iter().filter(|row| row.controls.contains(&kind)) {
            self.active_comments.push(ActiveComment {
                begins: row.begins.to_owned(),
                act: row.acts,
                after_semicolon: row.after_semicolon == Some(true),
                nothing_follows: row.whole == Some(true),
            });
        }
        for row in knowledge.rows::<GFunctions<'_>>()?.into_iter().filter(|row| row.controls.contains(&kind)) {
            let code = code(row.code, row.row)?;
            self.g.insert(code, GFunction { group: row.group, effect: row.effect });
            if row.power_on.is_some_and(|controls| controls.contains(&kind)) {
                self.power_on.push(code);
            }
        }
        for row in knowledge.rows::<MFunctions<'_>>()?.into_iter().filter(|row| row.controls.contains(&kind)) {
            let function = MFunction { action: row.action, at_start: row.acts == Acts::Start, group: row.group };
            self.m.insert(code(row.code, row.row)? / 10, function);
        }
        for row in knowledge.rows::<NotCarriedOut<'_>>()?.into_iter().filter(|row| row.controls.contains(&kind)) {
            let passed = Passed {
                takes: letters(row.takes.unwrap_or_default()),
                named_by: row.named_by.map(|letter| letter.0),
                whole: row.whole == Some(true),
                goes_on: row.goes_on == Some(true),
                harmless: row.harmless == Some(true),
            };
            let mut signs = row.word.chars();
            match (signs.next(), signs.next()) {
                (Some('G'), Some(_)) => {
                    self.passed_g.insert(code(row.word, row.row)?, passed);
                }
                (Some('M'), Some(_)) => {
                    let first = code(row.word, row.row)? / 10;
                    let last = row.last.map(|last| code(last, row.row)).transpose()?.map_or(first, |last| last / 10);
                    self.passed_m.extend((first..=last).map(|code| (code, passed.clone())));
                }
                (Some(letter), None) => {
                    self.passed_addresses.insert(letter, passed);
                }
                _ => {}
            }
        }
        for row in knowledge.rows::<Cycles<'_>>()?.into_iter().filter(|row| row.controls.contains(&kind)) {
            let cycle = Cycle {
                required: letters(row.required),
                optional: letters(row.optional_words.unwrap_or_default()),
                inwards: row.inwards,
                bottom: row.bottom,
                outwards: row.outwards,
            };
            self.cycles.insert(code(row.code, row.row)?, cycle);
        }
        Ok(())
    }
}

/// The figures of a characteristic, in its unit.
fn figures(record: &[Record<'_>], name: Characteristic, table: &Table) -> Result<(f64, Vec<f64>), KnowledgeError> {
    let row = record.iter().find(|row| row.name == name);
    let row = row.ok_or_else(|| KnowledgeError::no_row(table, name.name()))?;
    in_unit(row.value.as_deref(), row.unit, name.unit(), row.row)
}

/// The number of a code such as `G54` or `G91.1`, in tenths.
fn code(text: &str, row: RowRef<'_>) -> Result<i64, KnowledgeError> {
    let text = text.trim_start_matches(|c: char| !c.is_ascii_digit());
    let (whole, tenth) = text.split_once('.').unwrap_or((text, "0"));
    let parsed = whole.parse::<i64>().ok().zip(tenth.parse::<i64>().ok());
    let parsed = parsed.filter(|(whole, tenth)| (0..1000).contains(whole) && (0..10).contains(tenth));
    parsed
        .map(|(whole, tenth)| whole * 10 + tenth)
        .ok_or_else(|| KnowledgeError::missing(&row.table.id, note!("nc-code-such-g-g")))
}

/// The positions of a switch: those listed, or with two figures every whole number between them.
fn steps(figures: &[f64]) -> Vec<i64> {
    let listed: Vec<i64> = figures.iter().map(|value| *value as i64).collect();
    match listed[..] {
        [low, high] => (low..=high.min(low + 1000)).collect(),
        _ => listed,
    }
}
