//! The language of a control as data: functions, groups, addresses, cycles and limits, from catalogs/controls.

use std::collections::{BTreeMap, BTreeSet};
use technolog_note::note;

use crate::error::KnowledgeError;
use crate::knowledge::contract::Named;
use crate::knowledge::{Knowledge, RowRef};
use crate::note::Severity;
use crate::program::alone::Habits;
use crate::program::letters;
use crate::program::setting::Limits;
use crate::tables::controls::Acts;
use crate::tables::controls::iso::{
    ActiveComments, Addresses, Characteristic as Q, Cycles, GFunctions, MFunctions, MGroup, NotCarriedOut, Record,
};
use crate::units::Micrometres;

pub(super) use crate::tables::controls::iso::{
    Action, Bottom, Characteristic, CommentAct, Effect, Group, Inwards, Outwards, Written,
};

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
    /// Whether the ways are traced as they are written, near to those of the axes.
    pub as_written: bool,
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
    /// What its record says yes to.
    yes: BTreeSet<Q>,
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
    /// How deep subprograms may call one another; 0 without any.
    pub(super) depth: usize,
    pub(super) m_per_block: usize,
    /// The unit of P in a dwell, s.
    pub(super) dwell_unit_s: f64,
    /// The permitted difference between the radii at start and end of an arc, mm, in programs in millimetres and in
    /// inches, and as a part of the radius.
    arc_tolerance: (f64, f64, f64),
    /// How far a radius may fall short of the end of its arc, mm; 0 where that is the tolerance.
    arc_reach: f64,
    /// The first parameters, which a called subprogram has for itself.
    pub(super) local_parameters: u32,
    /// The last of those that belong to programs and are 0 before they are set.
    pub(super) free_parameters: u32,
    /// The distance above the metal where the rapid of G83 ends; the retract of G73.
    pub(super) pecks: (Micrometres, Micrometres),
    /// The digits of a program number that is written; 0 without one.
    pub(super) number_digits: usize,
    /// How many M functions are written in a block.
    pub(super) m_written: usize,
    /// Functions of macros that round numbers below 0 in another way than here.
    pub(super) rounds_unlike: Vec<String>,
    /// The M function that is written before a tapping cycle.
    pub(super) tap_preparation: Option<u32>,
    pub(super) habits: Habits,
    setting: Limits,
}

impl Control {
    /// The controls that have a record.
    pub fn names(knowledge: &Knowledge) -> impl Iterator<Item = &str> {
        Record::names(knowledge)
    }

    /// Reads the language from the tables.
    ///
    /// # Errors
    /// There is no such control, or a table lacks what is needed.
    pub fn read(control: &str, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let known = Self::names(knowledge).any(|name| name == control);
        let table = Record::table(control, knowledge)?;
        if !known {
            return Err(KnowledgeError::missing(&table.id, note!("nc-interpreter", control = control)));
        }
        let record: Vec<Record<'_>> = table.rows().collect::<Result<_, _>>()?;
        let row = |name: Q| record.iter().find(|row| row.name.is(name));
        let figures = |name: Q| row(name).and_then(|row| row.value.as_deref()).unwrap_or_default();
        let any = |name: Q| figures(name).first().copied().unwrap_or_default();
        // The law of the record holds that these are there, but a folder of tables may be one that nobody has checked.
        let need = |name: Q| match figures(name) {
            [] => Err(KnowledgeError::no_row(table, name.name())),
            [first, ..] => Ok(*first),
        };
        let length = |name| Micrometres::from_mm_rounded(any(name));
        let yes = record.iter().filter(|row| row.value.as_deref() == Some(&[1.0]));
        let yes: BTreeSet<Q> =
            yes.filter_map(|row| if let Named::Read(name) = row.name { Some(name) } else { None }).collect();
        let mut language = Self {
            g: BTreeMap::new(),
            power_on: Vec::new(),
            m: BTreeMap::new(),
            addresses: BTreeMap::new(),
            passed_g: BTreeMap::new(),
            passed_m: BTreeMap::new(),
            passed_addresses: BTreeMap::new(),
            active_comments: Vec::new(),
            cycles: BTreeMap::new(),
            depth: need(Q::SubprogramDepthMax)? as usize,
            m_per_block: need(Q::MFunctionsPerBlockMax)? as usize,
            dwell_unit_s: need(Q::DwellUnit)?,
            arc_tolerance: (need(Q::ArcTolerance)?, any(Q::ArcToleranceInches), need(Q::ArcToleranceRelative)?),
            arc_reach: any(Q::ArcReach),
            local_parameters: any(Q::LocalParameters) as u32,
            free_parameters: any(Q::FreeParameters) as u32,
            pecks: (length(Q::G83Clearance), length(Q::G73Retract)),
            number_digits: any(Q::ProgramNumberDigits) as usize,
            m_written: (any(Q::MFunctionsWritten) as usize).max(1),
            rounds_unlike: row(Q::RoundsUnlike)
                .and_then(|row| row.text)
                .map(|text| text.split(", ").map(str::to_owned).collect())
                .unwrap_or_default(),
            tap_preparation: Some(any(Q::TapPreparation) as u32).filter(|code| *code > 0),
            habits: Habits::read(knowledge)?.with_lengths(yes.contains(&Q::LengthsInOffsets)),
            setting: Limits {
                correctors: need(Q::Correctors)? as i64,
                feed_overrides: steps(figures(Q::FeedOverride)),
                speed_overrides: steps(figures(Q::SpindleOverride)),
                panel_2c42_65: false,
                pecks: yes.contains(&Q::PecksOfSetting),
                most: None,
                decimal: yes.contains(&Q::DecimalOfSetting),
            },
            yes,
        };
        let other = row(Q::WordsOf).and_then(|row| row.text);
        if let Some(other) = other {
            language.read_words(other, knowledge)?;
        }
        language.read_words(control, knowledge)?;
        Ok(language)
    }

    /// Whether a word of the control has that address, carried out or not.
    pub(super) fn knows_address(&self, address: char) -> bool {
        let passed = self.passed_g.values().chain(self.passed_m.values());
        self.addresses.contains_key(&address)
            || self.passed_addresses.contains_key(&address)
            || passed.flat_map(|passed| &passed.takes).any(|taken| *taken == address)
    }

    /// Whether what stands before the first sign of a text is no program.
    pub(in crate::program) fn reads_from_sign(&self) -> bool {
        self.is(Q::ReadsFromSign)
    }

    /// The permitted difference between the radii at start and end of an arc, mm, and as a part of the radius.
    pub(super) const fn arc_tolerance(&self, inches: bool) -> (f64, f64) {
        let (metric, in_inches, part) = self.arc_tolerance;
        (if inches && in_inches > 0.0 { in_inches } else { metric }, part)
    }

    /// How far a radius may fall short of the end of its arc, mm.
    pub(super) const fn arc_reach(&self) -> f64 {
        if self.arc_reach > 0.0 { self.arc_reach } else { self.arc_tolerance.0 }
    }

    /// The radius below which there is none, mm.
    pub(super) const fn least_radius(&self) -> f64 {
        self.arc_reach
    }

    /// Whether its record says yes.
    pub(super) fn is(&self, characteristic: Characteristic) -> bool {
        self.yes.contains(&characteristic)
    }

    /// Whether it has a radius compensation, carried out here or not, that another program may have left.
    pub(super) fn corrects_radius(&self) -> bool {
        self.g.contains_key(&410) || self.passed_g.contains_key(&410)
    }

    /// Whether the address is known, and not carried out here.
    pub(super) fn passes_address(&self, address: char) -> bool {
        self.passed_addresses.contains_key(&address) && !self.addresses.contains_key(&address)
    }

    /// Whether it has a function for the tool change.
    pub(super) fn changes_tools(&self) -> bool {
        self.m.values().any(|function| function.action == Action::ToolChange)
    }

    /// Whether it taps: a spindle and a feed that go together.
    pub(in crate::program) fn taps(&self) -> bool {
        self.cycles.values().any(|cycle| cycle.bottom == Bottom::Reversed)
    }

    /// How grave a tool change is to which the spindle turns.
    pub(in crate::program) fn turning_at_change(&self) -> Severity {
        if self.is(Q::ChangeStopsSpindle) { Severity::Note } else { Severity::Wrong }
    }

    /// Whether the builder of the machine decides if a tool change stops the spindle: M5 is the only word that is sure to.
    pub(in crate::program) fn change_by_builder(&self) -> bool {
        self.is(Q::ChangeByBuilder)
    }

    /// The machine function that a tapping cycle needs before it.
    pub(in crate::program) fn tap_word(&self) -> Option<String> {
        self.tap_preparation.map(|code| format!("M{code}"))
    }

    /// The parts of a setting that this control has.
    pub const fn setting(&self) -> &Limits {
        &self.setting
    }

    /// The rows of the tables iso-… that name the control.
    fn read_words(&mut self, control: &str, knowledge: &Knowledge) -> Result<(), KnowledgeError> {
        let names = |controls: &[&str]| controls.contains(&control);
        for row in knowledge.rows::<Addresses<'_>>()?.into_iter().filter(|row| names(&row.controls)) {
            self.addresses.insert(row.address.0, row.kind);
        }
        for row in knowledge.rows::<ActiveComments<'_>>()?.into_iter().filter(|row| names(&row.controls)) {
            self.active_comments.push(ActiveComment {
                begins: row.begins.to_owned(),
                act: row.acts,
                after_semicolon: row.after_semicolon == Some(true),
                nothing_follows: row.whole == Some(true),
            });
        }
        for row in knowledge.rows::<GFunctions<'_>>()?.into_iter().filter(|row| names(&row.controls)) {
            let code = code(row.code, row.row)?;
            self.g.insert(code, GFunction { group: row.group, effect: row.effect });
            if row.power_on.is_some_and(|controls| names(&controls)) {
                self.power_on.push(code);
            }
        }
        for row in knowledge.rows::<MFunctions<'_>>()?.into_iter().filter(|row| names(&row.controls)) {
            let function = MFunction { action: row.action, at_start: row.acts == Acts::Start, group: row.group };
            self.m.insert(code(row.code, row.row)? / 10, function);
        }
        for row in knowledge.rows::<NotCarriedOut<'_>>()?.into_iter().filter(|row| names(&row.controls)) {
            let passed = Passed {
                takes: letters(row.takes.unwrap_or_default()),
                named_by: row.named_by.map(|letter| letter.0),
                whole: row.whole == Some(true),
                goes_on: row.goes_on == Some(true),
                harmless: row.harmless == Some(true),
                as_written: row.as_written == Some(true),
            };
            let mut signs = row.word.chars();
            match (signs.next(), signs.next()) {
                (Some('G'), Some(_)) => {
                    let code = code(row.word, row.row)?;
                    if !self.g.contains_key(&code) {
                        self.passed_g.insert(code, passed);
                    }
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
        for row in knowledge.rows::<Cycles<'_>>()?.into_iter().filter(|row| names(&row.controls)) {
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
