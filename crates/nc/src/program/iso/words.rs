//! The words of a block, its functions by their groups; and the checks of what may be combined.

use std::collections::BTreeSet;

use super::control::{Characteristic as Q, Control, Effect, Group, Passed};
use super::rules::{fault, word_fault};
use super::text::{Block, Word};
use crate::motion::Axis;
use crate::note::Severity;
use crate::program::{Fault, TextSpan};
use crate::units::Micrometres;

/// A number with its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct WordValue {
    pub millionths: i64,
    /// Whether it counts least increments, thousandths, because it has no point.
    pub increments: bool,
    /// Whether it is written with a point.
    pub point: bool,
    pub span: TextSpan,
}

impl WordValue {
    /// As it is written.
    pub(super) const fn value(self) -> f64 {
        self.millionths as f64 / 1e6
    }

    /// As P of a dwell, s.
    pub(super) fn dwell_s(self, control: &Control) -> f64 {
        let in_seconds = self.point && control.is(Q::DwellPointInSeconds);
        self.value() * if in_seconds { 1.0 } else { control.dwell_unit_s }
    }

    /// As the time of an axis word: in increments, milliseconds.
    pub(super) const fn seconds(self) -> f64 {
        self.value() / if self.increments { 1000.0 } else { 1.0 }
    }

    /// As a length, mm or inches, before it is rounded; mm.
    pub(super) const fn exact_mm(self, inches: bool) -> f64 {
        let unit = match (inches, self.increments) {
            (false, false) => 1.0,
            (false, true) => 0.001,
            (true, false) => 25.4,
            (true, true) => 0.00254,
        };
        self.value() * unit
    }

    /// As a length, mm or inches, to the nearest micrometre.
    pub(super) const fn length(self, inches: bool) -> Micrometres {
        // An inch is 25.4 mm: 254 / 10 000 of a micrometre for a millionth of it; its least increment is a ten
        // thousandth.
        let (times, over) = match (inches, self.increments) {
            (false, false) => (1, 1000),
            (false, true) => (1, 1_000_000),
            (true, false) => (254, 10_000),
            (true, true) => (254, 100_000_000),
        };
        let scaled = self.millionths * times;
        let half = if scaled < 0 { -(over / 2) } else { over / 2 };
        Micrometres::new((scaled + half) / over)
    }
}

/// A function with its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Function {
    /// Of G in tenths, of M whole.
    pub code: i64,
    pub span: TextSpan,
}

impl Function {
    /// A G function as people write it.
    pub(super) fn name(self) -> String {
        let (whole, tenth) = (self.code / 10, self.code % 10);
        if tenth == 0 { format!("G{whole}") } else { format!("G{whole}.{tenth}") }
    }
}

/// The words of a block for its execution.
#[derive(Clone, Debug, Default)]
pub(super) struct BlockWords {
    g: [Option<Function>; Group::NAMES.len()],
    /// The M functions, as they stand.
    pub m: Vec<Function>,
    /// Every other address, by its letter.
    values: [Option<WordValue>; ADDRESSES],
    /// G41 or G42: whether the tool keeps to the left, and the register of D.
    pub radius: Option<(bool, Option<u32>)>,
    /// D, the register of the radius.
    pub register: Option<u32>,
    /// Whether nothing of the block is carried out but modes and machine functions.
    pub passed: bool,
    /// Whether that holds for the blocks behind it.
    pub passes_on: bool,
    /// What of it is not carried out: told when the run comes to the block.
    pub told: Vec<Fault>,
}

impl BlockWords {
    /// The function of a group.
    pub(super) const fn function(&self, group: Group) -> Option<Function> {
        self.g[group as usize]
    }

    /// The one-shot function of that effect.
    pub(super) fn one_shot(&self, effect: Effect, control: &Control) -> Option<Function> {
        let function = self.function(Group::OneShot)?;
        control.g.get(&function.code).filter(|known| known.effect == effect).map(|_| function)
    }

    /// A word that is no G and no M.
    pub(super) const fn get(&self, address: char) -> Option<WordValue> {
        self.values[place(address)]
    }

    /// Whether a word names an axis: its letter, or `@` and `^`, which name X and Y.
    pub(super) fn names(&self, axis: Axis) -> bool {
        let polar = axis != Axis::Z && (self.get('@').is_some() || self.get('^').is_some());
        self.get(axis.letter()).is_some() || polar
    }

    /// Whether a word names any axis.
    pub(super) fn names_any(&self) -> bool {
        Axis::ALL.into_iter().any(|axis| self.names(axis))
    }

    /// Every such word with its letter.
    pub(super) fn all(&self) -> impl Iterator<Item = (char, WordValue)> + '_ {
        ('A'..='Z').chain(['@', '^']).zip(&self.values).filter_map(|(letter, given)| given.map(|given| (letter, given)))
    }

    /// Reads a block.
    pub(super) fn read(block: &Block, control: &Control, faults: &mut Vec<Fault>) -> Self {
        let before = faults.len();
        let mut words = Self::default();
        for word in &block.words {
            let given = WordValue {
                millionths: word.millionths,
                increments: word.increments,
                point: word.point,
                span: word.span,
            };
            match word.address {
                'G' => words.take_g(given, control, faults),
                'M' => words.take_m(given, control, faults),
                address => {
                    if words.values[place(address)].replace(given).is_some() {
                        faults.push(fault("word-twice", word.span, None).with("address", address));
                    }
                }
            }
        }
        // Which address has a number that depends on parameters is known before the number.
        let mut calculated = BTreeSet::new();
        for (address, _, span) in block.expressions.iter().filter(|(address, ..)| address.is_ascii_uppercase()) {
            let again = !calculated.insert(*address) || words.values[place(*address)].is_some();
            if again && !matches!(address, 'G' | 'M') {
                faults.push(fault("word-twice", *span, None).with("address", *address));
            }
        }
        words.pass(block, control, faults);
        for fault in &mut words.told {
            fault.block = block.number;
        }
        if let Some(many) = words.m.get(control.m_per_block) {
            let problem = fault("too-many-m", many.span, None).with("count", words.m.len());
            faults.push(problem.with("limit", control.m_per_block));
        }
        for fault in &mut faults[before..] {
            fault.block = block.number;
        }
        words
    }

    /// Takes out what is not carried out here.
    fn pass(&mut self, block: &Block, control: &Control, faults: &mut Vec<Fault>) {
        let known = |word: &Word| match word.address {
            'G' if word.millionths % 100_000 == 0 => {
                let code = word.millionths / 100_000;
                (control.passed_g.get(&code), Function { code, span: word.span }.name())
            }
            'M' => {
                let code = word.millionths / 1_000_000;
                (control.passed_m.get(&code), format!("M{code}"))
            }
            address => (control.passed_addresses.get(&address), address.to_string()),
        };
        self.passed = block.words.iter().any(|word| known(word).0.is_some_and(|passed| passed.whole));
        let register = self.get('D').and_then(|given| u32::try_from(given.millionths / 1_000_000).ok());
        self.register = register;
        self.radius = self.radius.map(|(left, _)| (left, register));
        for word in &block.words {
            let (Some(passed), mut name) = known(word) else { continue };
            // In a block that is passed over as a whole its other words are not told.
            if self.passed && !matches!(word.address, 'G' | 'M') {
                continue;
            }
            if let Some(by) = passed.named_by
                && let Some(given) = block.words.iter().find(|word| word.address == by)
            {
                name.push_str(&format!(" {by}{}", given.millionths / 1_000_000));
            }
            let code = match passed {
                Passed { harmless: true, .. } => "passed-over",
                Passed { as_written: true, .. } => "traced-as-written",
                _ => "not-carried-out",
            };
            // A further axis that is brought to 0 stands there as a rule.
            let to_zero = code == "not-carried-out" && matches!(word.address, 'A'..='C') && word.millionths == 0;
            if to_zero {
                name.push('0');
            }
            let mut told = word_fault(code, word.span, None, name);
            if to_zero {
                told.severity = Severity::Doubtful;
            }
            self.told.push(told);
            self.passes_on |= passed.goes_on;
            for address in passed.takes.iter().copied().chain(Some(word.address)) {
                self.values[place(address)] = None;
            }
        }
        // An address of such a word that stands without it.
        let alone = |address: char| !control.addresses.contains_key(&address) && self.get(address).is_some();
        if self.passed {
            return;
        }
        for address in ('A'..='Z').filter(|address| alone(*address)).collect::<Vec<_>>() {
            if let Some(given) = self.values[place(address)].take() {
                let word = format!("{address}{}", given.value());
                faults.push(fault("unknown-word", given.span, None).with("word", word));
            }
        }
    }

    fn take_g(&mut self, given: WordValue, control: &Control, faults: &mut Vec<Fault>) {
        let function = Function { code: given.millionths / 100_000, span: given.span };
        let known = control.g.get(&function.code).filter(|_| given.millionths % 100_000 == 0);
        let Some(known) = known else {
            if control.passed_g.contains_key(&function.code) && given.millionths % 100_000 == 0 {
                if matches!(function.code, 410 | 411 | 420 | 421) {
                    self.radius = Some((function.code < 420, None));
                }
                return;
            }
            let word = format!("G{}", given.value());
            faults.push(fault("unknown-word", given.span, None).with("word", word));
            return;
        };
        let Some(first) = self.g[known.group as usize].replace(function) else {
            let pair = [Group::Motion, Group::Cycle].map(|group| self.function(group));
            let off = |it: Function| control.g.get(&it.code).is_some_and(|known| known.effect == Effect::CycleOff);
            if let [Some(motion), Some(cycle)] = pair
                && !off(cycle)
                && control.is(Q::CyclesAreMotions)
                && matches!(known.group, Group::Motion | Group::Cycle)
            {
                faults.push(twice("group-exclusive", motion, cycle, given.span));
            }
            return;
        };
        let code = if control.is(Q::OneOfGroup) { "group-exclusive" } else { "group-twice" };
        faults.push(twice(code, first, function, given.span));
    }

    fn take_m(&mut self, given: WordValue, control: &Control, faults: &mut Vec<Fault>) {
        let function = Function { code: given.millionths / 1_000_000, span: given.span };
        let Some(known) = control.m.get(&function.code) else {
            if control.passed_m.contains_key(&function.code) {
                return;
            }
            let word = format!("M{}", function.code);
            faults.push(fault("unknown-word", given.span, None).with("word", word));
            return;
        };
        let group = |it: &&Function| control.m.get(&it.code).is_some_and(|other| other.group == known.group);
        // Fanuc leaves to the machine which M functions may be combined; two ends of the main program are wrong there
        // too.
        if let Some(first) = self.m.iter().find(group) {
            let problem = fault("exclusive-m-twice", given.span, None).with("first", format!("M{}", first.code));
            faults.push(problem.with("second", format!("M{}", function.code)));
        }
        self.m.push(function);
    }
}

fn twice(code: &'static str, first: Function, second: Function, span: TextSpan) -> Fault {
    fault(code, span, None).with("first", first.name()).with("second", second.name())
}

/// The letters, `@` and `^`.
pub(super) const ADDRESSES: usize = 28;

/// The place of an address in an array of all.
pub(super) const fn place(address: char) -> usize {
    match address {
        'A'..='Z' => address as usize - 65,
        '@' => 26,
        '^' => 27,
        _ => 0,
    }
}
