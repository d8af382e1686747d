//! The language of a control as data: functions, groups, addresses, cycles and limits, from catalogs/controls.

use std::collections::BTreeMap;

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, RowRef, Table};
use crate::program::setting::Limits;
use crate::program::{figures, letter};
use crate::units::Micrometres;

/// Which dialect it is, where that is no figure of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// LinuxCNC 2.9.
    LinuxCnc,
    /// Fanuc 0i.
    Fanuc,
}

/// Groups of G functions: the column `group` of table iso-g-functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Group {
    OneShot,
    Motion,
    Cycle,
    Plane,
    Units,
    Radius,
    Length,
    System,
    Path,
    Distance,
    ArcDistance,
    FeedMode,
    Retract,
}

impl Group {
    pub(super) const NAMES: [(&str, Self); 13] = [
        ("one-shot", Self::OneShot),
        ("motion", Self::Motion),
        ("cycle", Self::Cycle),
        ("plane", Self::Plane),
        ("units", Self::Units),
        ("radius", Self::Radius),
        ("length", Self::Length),
        ("system", Self::System),
        ("path", Self::Path),
        ("distance", Self::Distance),
        ("arc-distance", Self::ArcDistance),
        ("feed-mode", Self::FeedMode),
        ("retract", Self::Retract),
    ];
}

/// What a G function does: the column `effect`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Effect {
    Mode,
    Cycle,
    CycleOff,
    Dwell,
    Return,
    MachinePosition,
    Noted,
}

const EFFECTS: [(&str, Effect); 7] = [
    ("mode", Effect::Mode),
    ("cycle", Effect::Cycle),
    ("cycle-off", Effect::CycleOff),
    ("dwell", Effect::Dwell),
    ("return", Effect::Return),
    ("machine-position", Effect::MachinePosition),
    ("noted", Effect::Noted),
];

/// A G function.
#[derive(Clone, Copy, Debug)]
pub(super) struct GFunction {
    pub group: Group,
    pub effect: Effect,
}

/// What an M function makes the control do: the column `action` of table iso-m-functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    Stop,
    OptionalStop,
    End,
    Return,
    Call,
    SpindleClockwise,
    SpindleCounterclockwise,
    SpindleStop,
    ToolChange,
    CoolantOn,
    CoolantOff,
    Auxiliary,
}

const ACTIONS: [(&str, Action); 12] = [
    ("stop", Action::Stop),
    ("optional-stop", Action::OptionalStop),
    ("end", Action::End),
    ("return", Action::Return),
    ("call", Action::Call),
    ("spindle-clockwise", Action::SpindleClockwise),
    ("spindle-counterclockwise", Action::SpindleCounterclockwise),
    ("spindle-stop", Action::SpindleStop),
    ("tool-change", Action::ToolChange),
    ("coolant-on", Action::CoolantOn),
    ("coolant-off", Action::CoolantOff),
    ("auxiliary", Action::Auxiliary),
];

/// An M function.
#[derive(Clone, Debug)]
pub(super) struct MFunction {
    pub action: Action,
    /// Whether it acts before the motion of its block.
    pub at_start: bool,
    /// Its group, of which LinuxCNC takes one in a block.
    pub group: String,
}

/// How an address is written: the column `kind` of table iso-addresses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Written {
    Whole,
    Number,
    /// In millimetres or inches.
    Length,
}

/// The way of a cycle to its bottom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Inwards {
    Feed,
    /// After every step out of the hole.
    StepsLeaving,
    /// After every step back a little.
    StepsStaying,
}

/// What the spindle does at the bottom of a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bottom {
    Turning,
    Stopped,
    Reversed,
}

/// The way of a cycle out of the hole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Outwards {
    Rapid,
    /// At feed to R, at rapid from there.
    Feed,
    FeedToTheEnd,
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

/// The language of a control.
#[derive(Clone, Debug)]
pub struct Control {
    pub(in crate::program) kind: Kind,
    /// G functions by their codes in tenths: 911 is G91.1.
    pub(super) g: BTreeMap<i64, GFunction>,
    /// Those that hold after power-on.
    pub(super) power_on: Vec<i64>,
    pub(super) m: BTreeMap<i64, MFunction>,
    pub(super) addresses: BTreeMap<char, Written>,
    pub(super) cycles: BTreeMap<i64, Cycle>,
    pub(super) depth: usize,
    pub(super) m_per_block: usize,
    /// Seconds that one of P counts.
    pub(super) dwell_unit_s: f64,
    /// What the radii at start and end of an arc may differ by, mm, and as a part of the radius.
    pub(super) arc_tolerance: (f64, f64),
    /// How far before the metal the rapid of G83 ends; how far G73 draws back.
    pub(super) pecks: (Micrometres, Micrometres),
    /// Whether cycles and motions are one group, of which a block may have one.
    pub(super) cycles_are_motions: bool,
    pub(super) small_letters: bool,
    /// Whether subprograms are written with o-words.
    pub(super) o_words: bool,
    /// Whether G43 without H takes the corrector of the tool in the spindle.
    pub(super) length_of_tool: bool,
    setting: Limits,
}

impl Control {
    /// Reads the language from the tables.
    ///
    /// # Errors
    /// There is no such control, or a table lacks what is asked of it.
    pub fn read(control: &str, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let record = knowledge.table(&format!("control-{control}"))?;
        let kind = match control {
            "linuxcnc" => Kind::LinuxCnc,
            "fanuc" => Kind::Fanuc,
            other => return Err(KnowledgeError::lacks(&record.id, &format!("an interpreter of {other}"))),
        };
        let number = |name: &str| figures(record, name).map(|values| values.first().copied().unwrap_or_default());
        let flag = |name: &str| number(name).map(|value| value > 0.0);
        let length = |name: &str| number(name).map(Micrometres::from_mm_rounded);
        let mut language = Self {
            kind,
            g: BTreeMap::new(),
            power_on: Vec::new(),
            m: BTreeMap::new(),
            addresses: BTreeMap::new(),
            cycles: BTreeMap::new(),
            depth: number("subprogram-depth-max")? as usize,
            m_per_block: number("m-functions-per-block-max")? as usize,
            dwell_unit_s: number("dwell-unit")?,
            arc_tolerance: (number("arc-tolerance")?, number("arc-tolerance-relative")?),
            pecks: (length("g83-clearance")?, length("g73-retract")?),
            cycles_are_motions: flag("cycles-are-motions")?,
            small_letters: flag("words-in-small-letters")?,
            o_words: flag("o-words")?,
            length_of_tool: flag("length-of-tool-in-spindle")?,
            setting: Limits {
                correctors: number("correctors")? as i64,
                feed_overrides: steps(record, "feed-override")?,
                speed_overrides: steps(record, "spindle-override")?,
                panel_2c42_65: false,
                pecks: flag("pecks-of-setting")?,
            },
        };
        language.read_words(control, knowledge)?;
        Ok(language)
    }

    /// What of a setting it has.
    pub const fn setting(&self) -> &Limits {
        &self.setting
    }

    /// The rows of the tables iso-… that name the control.
    fn read_words(&mut self, control: &str, knowledge: &Knowledge) -> Result<(), KnowledgeError> {
        for row in rows(knowledge, "iso-addresses", control)? {
            let written = match row.text("kind")? {
                "whole" => Written::Whole,
                "length" => Written::Length,
                _ => Written::Number,
            };
            self.addresses.insert(letter(row.text("address")?), written);
        }
        for row in rows(knowledge, "iso-g-functions", control)? {
            let code = code(row)?;
            let function =
                GFunction { group: named(row, "group", &Group::NAMES)?, effect: named(row, "effect", &EFFECTS)? };
            self.g.insert(code, function);
            if row.texts("power_on").unwrap_or_default().contains(&control) {
                self.power_on.push(code);
            }
        }
        for row in rows(knowledge, "iso-m-functions", control)? {
            let function = MFunction {
                action: named(row, "action", &ACTIONS)?,
                at_start: row.text("acts")? == "start",
                group: row.text("group")?.to_owned(),
            };
            self.m.insert(code(row)? / 10, function);
        }
        for row in rows(knowledge, "iso-cycles", control)? {
            let letters =
                |column: &str| -> Vec<char> { row.texts(column).unwrap_or_default().into_iter().map(letter).collect() };
            let ways = [
                ("feed", Inwards::Feed),
                ("in-steps-leaving", Inwards::StepsLeaving),
                ("in-steps-staying", Inwards::StepsStaying),
            ];
            let bottoms = [("turning", Bottom::Turning), ("stopped", Bottom::Stopped), ("reversed", Bottom::Reversed)];
            let outwards =
                [("rapid", Outwards::Rapid), ("feed", Outwards::Feed), ("feed-to-the-end", Outwards::FeedToTheEnd)];
            let cycle = Cycle {
                required: letters("required"),
                optional: letters("optional_words"),
                inwards: named(row, "inwards", &ways)?,
                bottom: named(row, "bottom", &bottoms)?,
                outwards: named(row, "outwards", &outwards)?,
            };
            self.cycles.insert(code(row)?, cycle);
        }
        Ok(())
    }
}

/// The rows of a table that name a control.
fn rows<'k>(
    knowledge: &'k Knowledge,
    table: &str,
    control: &str,
) -> Result<impl Iterator<Item = RowRef<'k>>, KnowledgeError> {
    let table = knowledge.table(table)?;
    let control = control.to_owned();
    Ok(table.all_rows().filter(move |row| row.texts("controls").unwrap_or_default().contains(&control.as_str())))
}

/// The value that a text of a row names.
fn named<T: Copy>(row: RowRef<'_>, column: &str, names: &[(&str, T)]) -> Result<T, KnowledgeError> {
    let text = row.text(column)?;
    let found = names.iter().find(|(name, _)| *name == text);
    found.map(|(_, value)| *value).ok_or_else(|| KnowledgeError::lacks(&row.table.id, text))
}

/// The number of a code such as `G54` or `G91.1`, in tenths.
fn code(row: RowRef<'_>) -> Result<i64, KnowledgeError> {
    let text = row.text("code")?.trim_start_matches(|c: char| !c.is_ascii_digit());
    let (whole, tenth) = text.split_once('.').unwrap_or((text, "0"));
    let parsed = whole.parse::<i64>().ok().zip(tenth.parse::<i64>().ok());
    let parsed = parsed.filter(|(whole, tenth)| (0..1000).contains(whole) && (0..10).contains(tenth));
    parsed
        .map(|(whole, tenth)| whole * 10 + tenth)
        .ok_or_else(|| KnowledgeError::lacks(&row.table.id, "a code such as G1 or G91.1"))
}

/// The steps of a switch: those listed, or with two figures every whole number between them.
fn steps(table: &Table, name: &str) -> Result<Vec<i64>, KnowledgeError> {
    let listed: Vec<i64> = figures(table, name)?.into_iter().map(|value| value as i64).collect();
    Ok(match listed[..] {
        [low, high] => (low..=high.min(low + 1000)).collect(),
        _ => listed,
    })
}
