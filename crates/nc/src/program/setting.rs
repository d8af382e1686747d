//! The operator's setting before a program runs: zeros, offset registers, switches (textbook section 4). The file of
//! a setting is YAML; its faults are reported with their places. All controls share it; [`Limits`] says what a
//! control has of it.

use std::collections::BTreeMap;
use std::fmt::Write;
use technolog_note::note;

use crate::job::Job;
use crate::knowledge::diagnostic::{self, Diagnostic};
use crate::knowledge::yaml::{Node, Problems, parse};
use crate::motion::{Axis, Position};
use crate::note::Severity;
use crate::units::Micrometres;

/// The parts of a setting that a control has.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Limits {
    /// The highest number of an offset register.
    pub correctors: i64,
    /// Settings of the feed switch, per cent.
    pub feed_overrides: Vec<i64>,
    /// Settings of the spindle switch, per cent.
    pub speed_overrides: Vec<i64>,
    /// Whether it searches the machine zero by a program, mirrors axes, and has the shifts СМ1 and СМ2: only 2С42-65.
    pub panel_2c42_65: bool,
    /// Whether the clearances of deep drilling are parameters: only Fanuc.
    pub pecks: bool,
    /// The largest value of an offset register and of a zero, either sign, where the control has a limit.
    pub most: Option<Micrometres>,
    /// Whether a parameter says what a length without a point counts: only Fanuc.
    pub decimal: bool,
}

/// What a length without a decimal point counts: a parameter of Fanuc (3401#0).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DecimalInput {
    /// Whole millimetres, as on a calculator.
    Calculator,
    /// The least increments: micrometres.
    Increment,
}

/// The state of the operator's panel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setting {
    /// Where the axes stand, machine coordinates, mm.
    pub start: Position,
    /// Whether the axes have been homed since power-on.
    pub homed: bool,
    /// The zeros of G54…G59, machine coordinates; an axis left out is not set.
    pub zeros: [[Option<Micrometres>; 3]; 6],
    /// СМ1 and СМ2 together: added to every zero of G54…G59.
    pub shift: Position,
    /// Values of the correctors by their numbers, mm.
    pub correctors: BTreeMap<u32, Micrometres>,
    /// Axes that are mirrored (4.2.4.4).
    pub mirror: [bool; 3],
    /// Whether blocks and parts of blocks after `/` are skipped (4.2.4.3).
    pub skip: bool,
    /// Whether M01 stops (4.2.4.2).
    pub optional_stop: bool,
    /// The feed switch, per cent.
    pub feed_override: i64,
    /// The spindle switch, per cent.
    pub speed_override: i64,
    /// The fixed point of G29 and G31 (2С42-65) and of G30 (the others), machine coordinates: a constant of the machine
    /// that no source gives.
    pub fixed_point: Option<Position>,
    /// The distance above the metal where the rapid of G83 ends, where that is a parameter of the control.
    pub g83_clearance: Option<Micrometres>,
    /// The retract of G73, where that is a parameter of the control.
    pub g73_retract: Option<Micrometres>,
    /// What a length without a point counts, where the owner has said so.
    pub decimal: Option<DecimalInput>,
    /// What is known of the control when the program begins.
    pub before: Before,
    /// What nobody has stated.
    pub assumed: Assumed,
}

/// What nobody has stated, so that something else stands for it: no program is held to a limit that rests on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Assumed {
    /// The machine: that of the control's description.
    pub machine: bool,
    /// The zero along an axis, or along Z the lengths of the tools: those of the plan.
    pub zeros: [bool; 3],
}

/// What is known of the control when a program begins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Before {
    /// Nothing is said of it: another program, its breaking off or a block by hand may have left its modes. A program that
    /// relies on plane, units, distances, corrections or a cycle without setting them is wrong. Doubtful is what many shops
    /// hold by habit: the system of coordinates, the height of the quill, and of a tool that no M6 has brought the length with
    /// which its zero was set and that its radius is not corrected.
    #[default]
    Unsaid,
    /// It was switched on just now: what acts is known.
    PoweredOn,
    /// Other programs ran: whatever the program relies on it must set.
    OtherPrograms,
}

impl Before {
    /// How grave it is that the program relies on what it never sets, where habit may hold it.
    pub(super) fn of_habit(self) -> Severity {
        if self == Self::Unsaid { Severity::Doubtful } else { Severity::Wrong }
    }

    /// Its word in messages.
    pub(super) fn word(self) -> String {
        if self == Self::Unsaid { "unsaid" } else { "programs" }.to_owned()
    }
}

impl Default for Setting {
    fn default() -> Self {
        Self {
            start: Position::default(),
            homed: true,
            zeros: [[None; 3]; 6],
            shift: Position::default(),
            correctors: BTreeMap::new(),
            mirror: [false; 3],
            skip: false,
            optional_stop: false,
            feed_override: 100,
            speed_override: 100,
            fixed_point: None,
            g83_clearance: None,
            g73_retract: None,
            decimal: None,
            before: Before::Unsaid,
            assumed: Assumed::default(),
        }
    }
}

impl Setting {
    /// The setting for a job: the zeros of its set-ups in G54, G55 and on, and the offset registers. Other programs ran
    /// before its own.
    pub fn of_job(job: &Job) -> Self {
        let mut setting = Self { before: Before::OtherPrograms, ..Self::default() };
        let zeros = job.setups.iter().flat_map(|setup| setup.frames.iter().map(move |_| setup));
        for (setup, zero) in zeros.zip(&mut setting.zeros) {
            *zero = Axis::ALL.map(|axis| Some(setup.zero.get(axis)));
        }
        setting.correctors = job.correctors.iter().copied().collect();
        setting
    }

    /// Where the first zero of each set-up of a job lies by it, machine coordinates.
    pub fn zeros_of(&self, job: &Job) -> Vec<Position> {
        let zero = |zero: &[Option<Micrometres>; 3]| {
            Position::of(Axis::ALL.map(|axis| zero[axis.index()].unwrap_or_default() + self.shift.get(axis)))
        };
        let mut at = 0;
        let firsts = job.setups.iter().filter_map(|setup| {
            let first = self.zeros.get(at);
            at += setup.frames.len();
            first.map(zero)
        });
        firsts.collect()
    }

    /// The file of a setting, as [`read_setting`] reads it: the differences from the power-on state.
    pub fn to_yaml(&self) -> String {
        let mut text = String::from("zeros:\n");
        // Writing to a text cannot fail.
        for (name, zero) in ZEROS.iter().zip(&self.zeros) {
            let axes: Vec<String> = AXES
                .iter()
                .zip(zero)
                .filter_map(|(axis, value)| value.map(|value| format!("{axis}: {value}")))
                .collect();
            if !axes.is_empty() {
                let _ = writeln!(text, "  {name}: {{{}}}", axes.join(", "));
            }
        }
        let correctors: Vec<String> =
            self.correctors.iter().map(|(number, value)| format!("{number}: {value}")).collect();
        let _ = writeln!(text, "correctors: {{{}}}", correctors.join(", "));
        text
    }
}

/// Keys that every control has.
const KEYS: &[&str] = &[
    "start",
    "zeros",
    "correctors",
    "skip",
    "optional_stop",
    "feed_override",
    "speed_override",
    "fixed_point",
    "as_powered_on",
];
const PANEL: &[&str] = &["homed", "mirror"];
const PECKS: &[&str] = &["g83_clearance", "g73_retract"];
const DECIMAL: &[&str] = &["decimal"];
/// The last two are of 2С42-65.
const ZEROS: &[&str] = &["G54", "G55", "G56", "G57", "G58", "G59", "CM1", "CM2"];
const AXES: &[&str] = &["x", "y", "z"];

/// Reads a setting.
///
/// # Errors
/// Every mistake of the file, each with its place and what to do.
pub fn read_setting(file: &str, text: &str, limits: &Limits) -> Result<Setting, Vec<Diagnostic>> {
    let (root, diagnostics) = parse(file, text);
    let mut problems = Problems(diagnostics);
    let setting = root.and_then(|root| read(&root, limits, &mut problems));
    match setting {
        Some(setting) if !problems.0.iter().any(|problem| problem.severity == diagnostic::Severity::Error) => {
            Ok(setting)
        }
        _ => {
            problems.0.sort_by(|a, b| a.place.cmp(&b.place));
            Err(problems.0)
        }
    }
}

fn read(root: &Node, limits: &Limits, problems: &mut Problems) -> Option<Setting> {
    let mut setting = Setting::default();
    let mut fields = problems.open_map(root)?;
    if let Some(node) = fields.take("start") {
        setting.start = position(node, limits, problems);
    }
    setting.fixed_point = fields.take("fixed_point").map(|node| position(node, limits, problems));
    for (key, slot) in [("skip", &mut setting.skip), ("optional_stop", &mut setting.optional_stop)] {
        if let Some(value) = fields.take(key).and_then(|node| problems.boolean(node)) {
            *slot = value;
        }
    }
    if let Some(value) = fields.take("as_powered_on").and_then(|node| problems.boolean(node)) {
        setting.before = if value { Before::PoweredOn } else { Before::OtherPrograms };
    }
    let mut keys = KEYS.to_vec();
    if limits.panel_2c42_65 {
        keys.extend(PANEL);
        if let Some(value) = fields.take("homed").and_then(|node| problems.boolean(node)) {
            setting.homed = value;
        }
        if let Some(items) = fields.take("mirror").and_then(|node| problems.list(node)) {
            for item in items {
                mirror(item, &mut setting, problems);
            }
        }
    }
    if limits.pecks {
        keys.extend(PECKS);
        setting.g83_clearance = positive(fields.take("g83_clearance"), problems);
        setting.g73_retract = positive(fields.take("g73_retract"), problems);
    }
    if limits.decimal {
        keys.extend(DECIMAL);
        setting.decimal = fields.take("decimal").and_then(|node| decimal(node, problems));
    }
    for (key, slot, steps) in [
        ("feed_override", &mut setting.feed_override, &limits.feed_overrides),
        ("speed_override", &mut setting.speed_override, &limits.speed_overrides),
    ] {
        let Some(node) = fields.take(key) else { continue };
        match problems.scalar::<i64>(node) {
            Some(value) if steps.contains(&value) => *slot = value,
            Some(value) => {
                let known: Vec<String> = steps.iter().map(ToString::to_string).collect();
                let help = note!("nc-switch-has", known = known.join(", "));
                problems.error_help::<()>(
                    "bad-override",
                    note!("nc-switch-has-no-step", value = value),
                    &node.place,
                    help,
                );
            }
            None => {}
        }
    }
    if let Some(node) = fields.take("zeros") {
        zeros(node, &mut setting, limits, problems);
    }
    if let Some(mut entries) = fields.take("correctors").and_then(|node| problems.open_map(node)) {
        for (key, node) in entries.remaining() {
            let number = key.text.parse::<u32>().ok().filter(|n| (1..=limits.correctors).contains(&i64::from(*n)));
            match number {
                Some(number) => {
                    if let Some(value) = within(node, limits, problems) {
                        setting.correctors.insert(number, value);
                    }
                }
                None => {
                    let help = note!("nc-correctors-have-numbers", correctors = limits.correctors);
                    problems.error_help::<()>("bad-corrector", note!("nc-there-no-such-corrector"), &key.place, help);
                }
            }
        }
    }
    fields.finish(&keys, problems);
    Some(setting)
}

fn mirror(item: &Node, setting: &mut Setting, problems: &mut Problems) {
    match item.text().and_then(|text| text.chars().next().filter(|_| text.len() == 1)).and_then(Axis::of) {
        Some(axis) => setting.mirror[axis.index()] = true,
        None => {
            problems.error_help::<()>("bad-axis", note!("nc-this-no-axis"), &item.place, note!("nc-name-x-y-z"));
        }
    }
}

/// What a length without a point counts.
fn decimal(node: &Node, problems: &mut Problems) -> Option<DecimalInput> {
    match node.text() {
        Some("calculator") => Some(DecimalInput::Calculator),
        Some("increment") => Some(DecimalInput::Increment),
        _ => {
            let help = note!("nc-give-calculator-increment");
            problems.error_help::<()>("bad-value", note!("nc-no-decimal-input"), &node.place, help);
            None
        }
    }
}

/// A length that a register of the control can hold.
fn within(node: &Node, limits: &Limits, problems: &mut Problems) -> Option<Micrometres> {
    let value = problems.scalar::<Micrometres>(node)?;
    if let Some(most) = limits.most.filter(|most| value.abs() > *most) {
        let help = note!("nc-offset-within", most = most);
        problems.error_help::<()>("offset-beyond", note!("nc-offset-beyond", value = value), &node.place, help);
    }
    Some(value)
}

/// A length above 0.
fn positive(node: Option<&Node>, problems: &mut Problems) -> Option<Micrometres> {
    let node = node?;
    let value = problems.scalar::<Micrometres>(node)?;
    if value <= Micrometres::ZERO {
        problems.error_help::<()>("bad-value", note!("nc-this-must-above"), &node.place, note!("nc-give-length-mm"));
    }
    Some(value)
}

/// The zeros of the systems, and the two further shifts.
fn zeros(node: &Node, setting: &mut Setting, limits: &Limits, problems: &mut Problems) {
    let names = if limits.panel_2c42_65 { ZEROS } else { ZEROS.get(..6).unwrap_or(ZEROS) };
    let Some(mut fields) = problems.open_map(node) else { return };
    for (index, name) in names.iter().enumerate() {
        let Some(node) = fields.take(*name) else { continue };
        let values = axes(node, limits, problems);
        match setting.zeros.get_mut(index) {
            Some(zero) => *zero = values,
            None => {
                for axis in Axis::ALL {
                    let shifted = setting.shift.get(axis) + values[axis.index()].unwrap_or_default();
                    setting.shift = setting.shift.with(axis, shifted);
                }
            }
        }
    }
    fields.finish(names, problems);
}

fn position(node: &Node, limits: &Limits, problems: &mut Problems) -> Position {
    Position::of(axes(node, limits, problems).map(Option::unwrap_or_default))
}

fn axes(node: &Node, limits: &Limits, problems: &mut Problems) -> [Option<Micrometres>; 3] {
    let mut values = [None; 3];
    let Some(mut fields) = problems.open_map(node) else { return values };
    for (value, name) in values.iter_mut().zip(AXES) {
        *value = fields.take(*name).and_then(|node| within(node, limits, problems));
    }
    fields.finish(AXES, problems);
    values
}
