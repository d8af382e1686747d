//! One check of any bytes: shared by the fuzz target and by `tests/suites/programs/fuzz.rs`, which runs it in every `cargo test`.
//!
//! The bytes are the program. How the operator's panel is set is told by its first line, where that begins with `%`:
//! such a line means nothing to the control, so that the same file is a program and a setting of it.

use std::sync::LazyLock;

use technolog::knowledge::Knowledge;
use technolog::machine::Machine;
use technolog::motion::Position;
use technolog::motion::time::Clock;
use technolog::motion::trace::Trace;
use technolog::program::Setting;
use technolog::program::control_2c42_65::{Control, check_within};
use technolog::report::Lang;
use technolog::shipped;
use technolog::units::Micrometres;

/// Blocks and motions of one check: a tenth of a second in a debug build at the most.
const BUDGET: usize = 4_000;

static KNOWLEDGE: LazyLock<Knowledge> = LazyLock::new(|| shipped::knowledge().expect("the shipped tables are sound"));
static CONTROL: LazyLock<Control> = LazyLock::new(|| Control::read(&KNOWLEDGE).expect("the control has its tables"));

/// Checks a program.
///
/// # Panics
/// The check panics, or tells a place outside the text, or the words of a finding are missing.
pub fn one_check(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let setting = setting_of(&text);
    // The last bit of the panel's line: a machine that can tap.
    let machine = if text.starts_with("%tap") { "ir500pmf4" } else { "gf2171" };
    let machine = Machine::find(&KNOWLEDGE, machine).expect("the machine has its record");
    let mut sink = (Trace::default(), Clock::new(&machine, setting.start));
    let faults = check_within(BUDGET, &text, &CONTROL, &machine, &setting, &mut sink);
    let lines: Vec<&str> = text.lines().collect();
    for fault in &faults {
        let line = lines.get(fault.span.line as usize - 1).map_or(0, |line| line.chars().count());
        let end = (fault.span.column + fault.span.width - 1) as usize;
        assert!(fault.span.column >= 1 && end <= line.max(1), "{fault:?} is outside its line");
        for lang in [Lang::UK, Lang::EN] {
            let sentence = lang.say(&fault.note);
            assert!(!sentence.contains('{') || text.contains('{'), "{sentence}");
            assert!(lang.remedy(&fault.note).is_some(), "{} has no remedy", fault.code);
        }
    }
    assert!(sink.1.times().total_min.0 >= 0.0);
}

/// A setting by the characters behind `%`: switches first, then values of zeros, correctors and start, the extreme ones
/// that a setting file can hold among them.
fn setting_of(text: &str) -> Setting {
    let mut setting = Setting::default();
    let line = text.lines().next().unwrap_or_default();
    let Some(panel) = line.strip_prefix('%') else { return setting };
    let mut bytes = panel.bytes();
    let mut next = || usize::from(bytes.next().unwrap_or_default());
    let switches = next();
    let flag = |bit: usize| switches >> bit & 1 == 1;
    // `@` is 64: what no bit asks for is as the default has it.
    setting.homed = !flag(0);
    setting.skip = flag(1);
    setting.optional_stop = flag(2);
    setting.mirror = [flag(3), flag(4), flag(5)];
    setting.feed_override = [100, 10, 120, 50][next() % 4];
    setting.speed_override = [100, 50, 140, 70][next() % 4];
    let values = [0, 5_000, -5_000, 10_000, -120_000, 1, 9_223_372_036_854_775, -9_223_372_036_854_775];
    let mut length = || Micrometres::new(values[next() % values.len()]);
    for number in 1..=4 {
        setting.correctors.insert(number, length());
    }
    for zero in &mut setting.zeros[..2] {
        *zero = [0; 3].map(|_| Some(length()));
    }
    setting.start = Position::of([0; 3].map(|_| length()));
    setting.shift = Position::of([0; 3].map(|_| length()));
    if flag(6) {
        setting.fixed_point = Some(Position::of([0; 3].map(|_| length())));
    }
    setting
}
