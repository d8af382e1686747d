//! What a lathe program asks of its spindle, its drives and its tools.

use technolog::audit::turned::{against_lathe, compare_with_part};
use technolog::note::Severity;
use technolog::program::Fault;
use technolog::program::lathe::{LatheLanguage, LatheRun, Subprogram, read};
use technolog::turning::operation::Operation;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::tooling::Lathe;
use technolog_testing::KNOWLEDGE;

use crate::operation::{example, planned};

fn program(name: &str) -> (Operation, String) {
    let operation = planned(&example(name));
    let written = programs(&operation, "linuxcnc", Form::Motions, None, &KNOWLEDGE).unwrap();
    let text = written[0].files.as_ref().unwrap()[0].text.clone();
    (operation, text)
}

fn run(text: &str) -> LatheRun {
    let language = LatheLanguage::read("linuxcnc-lathe", &KNOWLEDGE).unwrap();
    read(text, &language, &[] as &[Subprogram<'_>])
}

/// What is doubtful and worse, each once.
fn grave(faults: &[Fault]) -> Vec<(&'static str, Severity)> {
    let mut grave: Vec<_> = faults.iter().map(|fault| (fault.code, fault.severity)).collect();
    grave.retain(|one| one.1 < Severity::Note);
    grave.dedup();
    grave
}

/// What the lathe of the part cannot do.
fn of_lathe(operation: &Operation, text: &str) -> Vec<(&'static str, Severity)> {
    let lathe = Lathe::find(&KNOWLEDGE, operation.workpiece.machine.as_deref().unwrap()).unwrap();
    grave(&against_lathe(&run(text), &lathe).unwrap())
}

fn of_part(operation: &Operation, text: &str) -> Vec<(&'static str, Severity)> {
    grave(&compare_with_part(operation, 1, text, &run(text), &KNOWLEDGE).unwrap())
}

/// 16К20Ф3 turns at 12.5 to 2000 in steps, 560 and 710 among them; 16А20Ф3 at 20 to 2500, and feeds at 10 to 2000 along and 5 to 1000
/// mm/min across. 0.5 mm/rev at 560 1/min are 280 mm/min; 0.5 mm/min is no feed, 5 mm/rev at 560 are 2800.
#[test]
fn a_lathe_does_only_what_its_record_has() {
    let (sleeve, text) = program("turned-sleeve");
    let of = |from: &str, to: &str| of_lathe(&sleeve, &text.replacen(from, to, 1));
    assert_eq!(of("", ""), []);
    assert_eq!(of("S560", "S2240"), [("lathe-spindle-fast", Severity::Wrong)]);
    assert_eq!(of("S560", "S10"), [("lathe-spindle-slow", Severity::Wrong)]);
    assert_eq!(of("S560", "S600"), [("lathe-spindle-step", Severity::Doubtful)]);
    assert_eq!(of("G97 S560", "G96 D2000 S100"), [("lathe-spindle-stepped", Severity::Doubtful)]);
    let slow = of("G95", "G94");
    assert!(!slow.is_empty() && slow.iter().all(|one| *one == ("lathe-feed-slow", Severity::Wrong)), "{slow:?}");
    assert_eq!(of("Z-46 F0.5", "Z-46 F5"), [("lathe-feed-fast", Severity::Wrong)]);
    let (cone, text) = program("turned-cone");
    assert_eq!(of_lathe(&cone, &text), []);
    assert_eq!(of_lathe(&cone, &text.replacen("S662", "S2600", 1)), [("lathe-spindle-fast", Severity::Wrong)]);
}

/// Facing to the axis at a constant cutting speed the spindle runs up to its limit. At 0.5 mm/rev the cross slide of 16А20Ф3, which
/// feeds at 1000 mm/min, follows 2000 1/min, not the 2500 of the spindle.
#[test]
fn a_constant_cutting_speed_ends_where_the_drive_does() {
    let (cone, text) = program("turned-cone");
    assert!(text.contains("G96 D2000 S148 M3") && text.contains("X-1.827 F0.5"), "{text}");
    let faults = of_lathe(&cone, &text.replacen("D2000", "D2500", 1));
    assert_eq!(faults, [("lathe-feed-fast", Severity::Wrong)]);
}

/// A right-hand tool rubs with its back while the spindle turns the other way; so does a drill.
#[test]
fn a_right_hand_tool_cuts_with_m3() {
    let (sleeve, text) = program("turned-sleeve");
    for block in ["S280 M3", "S500 M3"] {
        let found = of_part(&sleeve, &text.replace(block, &block.replace("M3", "M4")));
        assert_eq!(found, [("turned-rotation", Severity::Wrong)], "{block}");
    }
}

/// Shops drive the roughing of the cone's steel up to 239 m/min. By hand at Ø75: G96 S1000 runs at its limit of 2000 1/min,
/// 0.075·π·2000 = 471 m/min, twice as fast; at 3500 1/min it is 825, and nothing is left of the edge.
#[test]
fn speed_and_feed_are_held_against_practice_and_plan() {
    let (cone, text) = program("turned-cone");
    assert_eq!(of_part(&cone, &text), []);
    let doubtful = [("turned-speed", Severity::Doubtful)];
    assert_eq!(of_part(&cone, &text.replacen("S148", "S1000", 1)), doubtful);
    assert_eq!(of_part(&cone, &text.replacen("D2000 S148", "D3500 S1000", 1)), [("turned-speed", Severity::Wrong)]);
    // A turner: at 600 1/min Ø75 runs at 141 m/min, and S1000 is still no cutting speed; S15 rubs.
    let stated = [("turned-speed-stated", Severity::Doubtful)];
    assert_eq!(of_part(&cone, &text.replacen("D2000 S148", "D600 S1000", 1)), stated);
    let slowed =
        |line: &str| line.split_once(" S").filter(|_| line.contains("G96")).map(|(modes, _)| format!("{modes} S15 M3"));
    let slow: Vec<String> = text.lines().map(|line| slowed(line).unwrap_or_else(|| line.to_owned())).collect();
    let found = of_part(&cone, &slow.join("\n"));
    let is_slow = |one: &(&str, Severity)| *one == ("turned-speed-slow", Severity::Doubtful);
    assert!(!found.is_empty() && found.iter().all(is_slow), "{found:?}");
}

/// A drill of 29 in bronze: the handbook ends at 0.96 mm/rev, practice at 0.635, which the plan takes. A nose of 0.8 bears less than
/// 0.8 mm/rev (Ingersoll), and 0.56 in roughing.
#[test]
fn a_feed_is_held_against_what_the_tool_bears() {
    let (sleeve, text) = program("turned-sleeve");
    let at = text.find("DRILL)").unwrap();
    let fed = |feed: &str| format!("{}{}", &text[..at], text[at..].replacen("F0.635", &format!("F{feed}"), 1));
    assert_eq!(of_part(&sleeve, &fed("0.95")), []);
    assert_eq!(of_part(&sleeve, &fed("1.27")), [("turned-feed-drill", Severity::Doubtful)]);
    assert_eq!(of_part(&sleeve, &fed("1.5")), [("turned-feed-drill", Severity::Wrong)]);
    assert_eq!(of_part(&sleeve, &fed("6.35")), [("turned-feed-drill", Severity::Wrong)]);
    let (cone, text) = program("turned-cone");
    let faced = |feed: &str| of_part(&cone, &text.replacen("X-1.827 F0.5", &format!("X-1.827 F{feed}"), 1));
    assert!(faced("0.75").contains(&("turned-feed-nose", Severity::Doubtful)), "{:?}", faced("0.75"));
    assert!(faced("0.9").contains(&("turned-feed-nose", Severity::Wrong)), "{:?}", faced("0.9"));
    // On the way back through the air nothing is cut.
    let back = text.replacen("G0 Z1.2\n", "G1 Z1.2 F3\nF0.5\n", 1);
    assert_ne!(back, text);
    assert_eq!(of_part(&cone, &back), []);
}

/// Some 8 mm before the face the turret turns to a drill that goes 60 mm deep: it stands out by that at least, and a turning tool
/// by its shank of 25 and a little more.
#[test]
fn the_turret_does_not_turn_a_long_tool_into_the_stock() {
    let (sleeve, text) = program("turned-sleeve");
    let turned = |z: &str| text.replacen("G28\nM5\nM9\n(T2", &format!("G0 X64 Z{z}\nM5\nM9\n(T2"), 1);
    assert_eq!(of_part(&sleeve, &turned("9")), [("turned-index-into", Severity::Wrong)]);
    assert_eq!(of_part(&sleeve, &turned("60")), []);
}

/// M30x2: passes at 1.5 mm per turn cut another thread.
#[test]
fn a_thread_is_fed_by_its_pitch() {
    let (stepped, text) = program("turned-stepped");
    let found = of_part(&stepped, &text.replace(" K2\n", " K1.5\n"));
    assert!(found.contains(&("swept-thread-lead", Severity::Wrong)), "{found:?}");
}
