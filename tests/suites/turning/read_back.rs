//! Programs of lathes compared with their part, as text: what the control makes of them is carried through the proof.

use technolog::audit::turned::{compare_with_part, read_back, reader};
use technolog::note::Severity;
use technolog::program::Fault;
use technolog::program::lathe::{LatheLanguage, Subprogram, read};
use technolog::turning::operation::Operation;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::workpiece::read_turned;
use technolog_testing::KNOWLEDGE;

use crate::operation::{example, planned};

const CONTROLS: [&str; 3] = ["linuxcnc", "fanuc", "sinumerik"];

/// What is found of a text that is to be set-up 1.
fn found(operation: &Operation, text: &str) -> Vec<Fault> {
    let language = LatheLanguage::read("linuxcnc-lathe", &KNOWLEDGE).unwrap();
    let run = read(text, &language, &[] as &[Subprogram<'_>]);
    compare_with_part(operation, 1, text, &run, &KNOWLEDGE).unwrap()
}

/// Codes with how grave they are and their lines, without the notes.
fn grave(faults: &[Fault]) -> Vec<(&'static str, Severity, u32)> {
    let grave = faults.iter().filter(|fault| fault.severity < Severity::Note);
    grave.map(|fault| (fault.code, fault.severity, fault.span.line)).collect()
}

fn sleeve() -> (Operation, String) {
    let operation = planned(&example("turned-sleeve"));
    let written = programs(&operation, "linuxcnc", Form::Motions, None, &KNOWLEDGE).unwrap();
    let text = written[0].files.as_ref().unwrap()[0].text.clone();
    (operation, text)
}

/// The line of a program, from 1, on which that stands after that remark.
fn line_of(text: &str, remark: &str, block: &str) -> u32 {
    let from = text.lines().position(|line| line.contains(remark)).unwrap();
    let at = text.lines().skip(from).position(|line| line == block).unwrap();
    u32::try_from(from + at + 1).unwrap()
}

/// The text with one block changed.
fn changed(text: &str, line: u32, to: &str) -> String {
    let index = usize::try_from(line).unwrap() - 1;
    text.lines().enumerate().map(|(at, old)| format!("{}\n", if at == index { to } else { old })).collect()
}

#[test]
fn programs_of_the_examples_do_what_their_toolpaths_do() {
    let mut count = 0;
    for name in ["turned-sleeve", "turned-stepped", "turned-cone", "turned-neck", "turned-nose", "turned-dowel"] {
        let operation = planned(&example(name));
        for (control, form) in CONTROLS.into_iter().flat_map(|one| [(one, Form::Motions), (one, Form::Cycles)]) {
            for written in programs(&operation, control, form, None, &KNOWLEDGE).unwrap() {
                let files = written.files.unwrap();
                let why = read_back(&operation, written.set_up, control, &files, &KNOWLEDGE).unwrap();
                assert!(why.is_none(), "{name} {control} {form:?} {}: {why:?}", written.set_up);
                let beside: Vec<Subprogram<'_>> = files[1..]
                    .iter()
                    .map(|file| Subprogram { name: file.name.trim_end_matches(".SPF"), text: &file.text })
                    .collect();
                let language = LatheLanguage::read(reader(control, &KNOWLEDGE).unwrap().unwrap(), &KNOWLEDGE).unwrap();
                let run = read(&files[0].text, &language, &beside);
                let faults = compare_with_part(&operation, written.set_up, &files[0].text, &run, &KNOWLEDGE).unwrap();
                // A centre of Morse 5 before a thin end is doubtful: the page says so too.
                let mut grave = grave(&faults);
                grave.retain(|one| (one.0, one.1) != ("swept-struck", Severity::Doubtful));
                assert_eq!(grave, [], "{name} {control} {form:?} {}", written.set_up);
                assert!(faults.iter().any(|fault| fault.code == "turned-held"));
                assert!(faults.iter().all(|fault| fault.code != "turned-tool-taken"), "every tool is named");
                count += 1;
            }
        }
    }
    assert!(count >= 36, "{count}");
}

/// A pass 0.5 mm below the lower limit of a seat of Ø50h8, 49.961 to 50, is told with that amount and its line.
#[test]
fn a_finishing_cut_too_deep_is_told_with_its_line() {
    let (operation, text) = sleeve();
    let line = line_of(&text, "FINISH)", "X49.981 Z-2.459 F0.323");
    let faults = found(&operation, &changed(&text, line, "X48.961 Z-2.459 F0.323"));
    assert_eq!(grave(&faults), [("swept-gouge", Severity::Wrong, line + 1)]);
    let gouge = faults.iter().find(|fault| fault.code == "swept-gouge").unwrap();
    assert_eq!(gouge.note.figure_text("depth").unwrap(), "0.5");
}

#[test]
fn what_follows_of_a_tool_that_is_not_named_is_doubtful_at_most() {
    let (operation, text) = sleeve();
    let line = line_of(&text, "FINISH)", "X49.981 Z-2.459 F0.323");
    let bad = changed(&text, line, "X48.961 Z-2.459 F0.323").replace("(T5 PCLNR 2525M12, FINISH)", "(finishing)");
    let faults = found(&operation, &bad);
    assert_eq!(grave(&faults), [("swept-gouge", Severity::Doubtful, line + 1)]);
    assert!(faults.iter().any(|fault| fault.code == "turned-tool-taken" && fault.severity == Severity::Note));
}

#[test]
fn a_rapid_through_metal_is_told() {
    let (operation, text) = sleeve();
    let line = line_of(&text, "ROUGH)", "G1 Z-46 F0.5");
    let faults = found(&operation, &changed(&text, line, "G0 Z-46"));
    assert!(grave(&faults).contains(&("swept-rapid", Severity::Wrong, line)), "{faults:?}");
}

/// The sleeve is parted off at Z-45 by a blade of 4 mm, so that the jaws close at Z-54: their front is 5 mm behind the blade.
#[test]
fn a_way_into_the_jaws_is_told() {
    let (operation, text) = sleeve();
    let line = line_of(&text, "ROUGH)", "G0 X58.1 Z-45.5") + 1;
    let faults = found(&operation, &changed(&text, line, "X64\nZ-53.9\nX64 Z2.6"));
    assert_eq!(grave(&faults), [], "{faults:?}");
    let faults = found(&operation, &changed(&text, line, "X64\nZ-54.1\nX64 Z2.6"));
    assert_eq!(grave(&faults), [("swept-struck", Severity::Wrong, line + 1)]);
}

#[test]
fn a_program_without_its_finishing_leaves_metal() {
    let (operation, text) = sleeve();
    let from = text.find("(T5 ").unwrap();
    let short = format!("{}M2\n", &text[..from]);
    let codes: Vec<&str> = grave(&found(&operation, &short)).iter().map(|fault| fault.0).collect();
    assert!(codes.contains(&"swept-stands"), "{codes:?}");
}

#[test]
fn what_is_not_known_is_not_blamed() {
    let (operation, text) = sleeve();
    let faults_of = |text: &str| grave(&found(&operation, text)).iter().map(|one| (one.0, one.1)).collect::<Vec<_>>();
    let doubtful = |code| vec![(code, Severity::Doubtful)];
    let strange = text.replace("T5 M6 G43", "T15 M6 G43").replace("(T5 PCLNR 2525M12, FINISH)", "(my tool)");
    assert_eq!(faults_of(&strange), doubtful("turned-tool-unknown"));
    let line = line_of(&text, "FINISH)", "G0 X61.1 Z2.6");
    assert_eq!(faults_of(&changed(&text, line, "G0 G42 X61.1 Z2.6")), doubtful("turned-compensated"));
    // A text with errors does not move as it says.
    assert_eq!(faults_of(&changed(&text, line, "G0 X61.1 Q")), []);
}

/// Ten tools in six places: after the six first the program stops once for the other four. A tool comes into the place of one that
/// has done its work; its offset is its own, of Sinumerik the second one of the place. Without the stop nobody can have put
/// them in, and the program is not given out.
#[test]
fn a_turret_that_is_too_small_is_filled_at_a_stop() {
    let path = format!("{}/tests/everyday/many-tools.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap();
    let operation = planned(&read_turned(&path, &text, &KNOWLEDGE).unwrap());
    assert_eq!(operation.turret_places, Some(6));
    let calls = [
        ("linuxcnc", ["T2 M6 G43 H7", "T3 M6 G43 H8", "T4 M6 G43 H9", "T5 M6 G43 H10"]),
        ("fanuc", ["T0207", "T0308", "T0409", "T0510"]),
        ("sinumerik", ["T2 D2", "T3 D2", "T4 D2", "T5 D2"]),
    ];
    for (control, calls) in calls {
        let written = programs(&operation, control, Form::Motions, None, &KNOWLEDGE).unwrap();
        let mut files = written[0].files.clone().unwrap();
        let (before, after) = files[0].text.split_once("\nM0\n").unwrap();
        assert!(!after.contains("\nM0\n"), "one stop is enough");
        for call in calls {
            assert!(
                !before.contains(&format!("\n{call}\n")) && after.contains(&format!("\n{call}\n")),
                "{control} {call}"
            );
        }
        // The turret is away, the spindle and the coolant are off; then the operator is told the tools.
        let told = before.lines().rev().take(6).collect::<Vec<_>>();
        assert_eq!(&told[4..], ["M9", "M5"], "{before}");
        assert!(told[3].contains("S12M-SCLCR06") && told[0].contains("SER 2525M16"), "{told:?}");
        assert!(read_back(&operation, 1, control, &files, &KNOWLEDGE).unwrap().is_none(), "{control}");
        files[0].text = format!("{before}\n{after}");
        let why = read_back(&operation, 1, control, &files, &KNOWLEDGE).unwrap().unwrap();
        assert_eq!(why.code(), "turned-read-back");
        let language = LatheLanguage::read(reader(control, &KNOWLEDGE).unwrap().unwrap(), &KNOWLEDGE).unwrap();
        let run = read(&files[0].text, &language, &[] as &[Subprogram<'_>]);
        let faults = compare_with_part(&operation, 1, &files[0].text, &run, &KNOWLEDGE).unwrap();
        let found: Vec<_> = grave(&faults).iter().map(|one| (one.0, one.1)).collect();
        assert_eq!(found, [("turned-no-stop", Severity::Wrong); 4], "{control}");
    }
}

/// A turret of the record that has no such place: others of that lathe may have it.
#[test]
fn a_place_that_the_turret_does_not_have_is_doubtful() {
    let (operation, text) = sleeve();
    assert_eq!(operation.turret_places, Some(6));
    let faults = found(&operation, &text.replace("T5 M6 G43", "T7 M6 G43"));
    assert_eq!(
        grave(&faults).iter().map(|one| (one.0, one.1)).collect::<Vec<_>>(),
        [("turned-beyond-turret", Severity::Doubtful)]
    );
}

/// A stud with a relief behind its thread as the turner has it on the desk: M24x1.5 to Z-30, its passes to Z-30.9735.
fn threaded() -> (Operation, String) {
    threaded_with(0.0, "")
}

/// The same with a bore of that diameter at its mouth.
fn threaded_with(mouth: f64, bore: &str) -> (Operation, String) {
    let text = "shaft: Stud\nmaterial: steel-45\nblank: {kind: bar, diameter: 50, length: 185, face: 2}\n\
        machine: 16k20f3\nholding: chuck\nouter:\n  - {from: {d: 0, z: 0}}\n  - {face: 20}\n  - {chamfer: 2}\n  \
        - {thread: M24x1.5-6g, to: -30}\n  - {groove: thread-relief}\n  - {face: 28}\n  - {chamfer: 1}\n  \
        - {cylinder: -70, name: bearing, grade: h9, roughness: Ra 3.2}\n  - {face: 44}\n  - {chamfer: 1}\n  \
        - {cylinder: -130}\n";
    let text = format!("{}{bore}", text.replacen("{d: 0, z: 0}", &format!("{{d: {mouth}, z: 0}}"), 1));
    let operation = planned(&read_turned("stud.yaml", &text, &KNOWLEDGE).unwrap());
    let written = programs(&operation, "fanuc", Form::Motions, None, &KNOWLEDGE).unwrap();
    let text = written[0].files.as_ref().unwrap()[0].text.clone();
    (operation, text)
}

/// What is found of a text of Fanuc that is to be set-up 1, beside what is found of our own program.
fn new_in_fanuc(operation: &Operation, own: &str, text: &str) -> Vec<(&'static str, Severity)> {
    let language = LatheLanguage::read("fanuc-lathe", &KNOWLEDGE).unwrap();
    let found = |text: &str| {
        let run = read(text, &language, &[] as &[Subprogram<'_>]);
        let faults = compare_with_part(operation, 1, text, &run, &KNOWLEDGE).unwrap();
        assert!(faults.iter().any(|fault| fault.code == "turned-held"), "{faults:?}");
        grave(&faults).iter().map(|one| (one.0, one.1)).collect::<Vec<_>>()
    };
    let known = found(own);
    found(text).into_iter().filter(|one| !known.contains(one)).collect()
}

#[test]
fn a_thread_that_ends_too_soon_is_told() {
    let (operation, text) = threaded();
    assert!(text.contains("G32 Z-30.9735 F1.5"), "{text}");
    let ended = |z: &str| new_in_fanuc(&operation, &text, &text.replace("G32 Z-30.9735", &format!("G32 Z{z}")));
    for z in ["-16.", "-28."] {
        assert_eq!(ended(z), [("swept-thread-part", Severity::Wrong)], "{z}");
    }
    for z in ["-30.", "-30.5", "-31."] {
        assert_eq!(ended(z), [], "{z}");
    }
    // A spring pass more that ends anywhere takes nothing away.
    let spring =
        text.replacen("G0 X25.85\nZ1.\nX54.", "G0 X25.85\nZ1.\nX22.053\nG32 Z-20. F1.5\nG0 X25.85\nZ1.\nX54.", 1);
    assert_ne!(spring, text);
    assert_eq!(new_in_fanuc(&operation, &text, &spring), []);
}

/// The T word says which tool cuts; the remark before it does not.
#[test]
fn a_thread_by_a_tool_that_cuts_none_is_told() {
    let (operation, text) = threaded();
    let call = text.lines().skip_while(|line| !line.contains("SER")).nth(1).unwrap().to_owned();
    assert_eq!(call, "T0404", "{text}");
    let called = |to: &str| new_in_fanuc(&operation, &text, &text.replace(&format!("{call}\n"), to));
    for to in ["T0101\n", "T0303\n"] {
        assert!(called(to).contains(&("turned-no-stop", Severity::Wrong)), "{to} {:?}", called(to));
    }
    assert!(called("").contains(&("turned-no-threading-tool", Severity::Wrong)), "{:?}", called(""));
    // Without any remark of the threading tool there is only T to go by.
    let remark = text.lines().find(|line| line.contains("SER")).unwrap();
    let mute = text.replace(remark, "(thread)").replace("T0404", "T0101");
    let found = new_in_fanuc(&operation, &text, &mute);
    assert!(found.contains(&("turned-no-threading-tool", Severity::Wrong)), "{found:?}");
    assert_eq!(called("T0403\n"), [("turned-offset-of-other", Severity::Wrong)]);
    // A second offset of its own, which the plan does not have.
    assert_eq!(called("T0414\n"), [("turned-offset-unknown", Severity::Wrong)]);
    // A wrong lead is one whatever tool cuts it.
    let unnamed = text.replace(remark, "(thread)");
    let found = new_in_fanuc(&operation, &unnamed, &unnamed.replace("F1.5", "F1.25"));
    assert!(found.contains(&("swept-thread-lead", Severity::Wrong)), "{found:?}");
    // Another place, and a tool that the operator puts in at a stop.
    assert_eq!(called("T0606\n"), []);
    let stopped = text.replace(&format!("{remark}\nT0404"), &format!("M0\n{remark}\nT0101"));
    let found = new_in_fanuc(&operation, &text, &stopped);
    assert!(found.iter().all(|one| !["turned-no-threading-tool", "turned-no-stop"].contains(&one.0)), "{found:?}");
}

/// The drive lags by turns that grow with the speed: passes at another one are cut beside the groove.
#[test]
fn passes_of_a_thread_at_other_speeds_are_told() {
    let (operation, text) = threaded();
    let (first, rest) = text.split_once("G32 ").unwrap();
    let slower = |words: &str| format!("{first}G32 {}", rest.replacen("G32 ", &format!("{words}\nG32 "), 1));
    let speeds = ("turned-thread-speeds", Severity::Wrong);
    assert_eq!(new_in_fanuc(&operation, &text, &slower("S200")), [speeds]);
    assert!(new_in_fanuc(&operation, &text, &slower("G50 S2000\nG96 S40")).contains(&speeds));
}

/// Drilled and tapped M8 from the end of its thread M24x1.5: what the tap turns at 8 mm inside of the crests is no pass of the thread
/// outside, neither a deep one nor one at another speed.
#[test]
fn a_tapped_bore_is_no_pass_of_the_thread_outside() {
    let bore = "inner:\n  - {from: {d: 8.5, z: 0}}\n  - {chamfer: 0.9}\n  - {thread: M8, to: -20}\n  - {cylinder: -30}\n  - {face: 0}\n";
    let (operation, text) = threaded_with(8.5, bore);
    let written = programs(&operation, "linuxcnc", Form::Motions, None, &KNOWLEDGE).unwrap();
    let of_linuxcnc = written[0].files.as_ref().unwrap()[0].text.clone();
    assert!(of_linuxcnc.contains("G33.1 Z-23.75 K1.25"), "{of_linuxcnc}");
    // In step by the words of a thread, as older controls tap.
    assert!(text.contains("M29 S500\nG84 Z-23.75 F1.25\nG80\n"), "{text}");
    let in_step = text.replace("M29 S500\nG84 Z-23.75 F1.25\nG80\n", "G32 Z-23.75 F1.25\nM4\nG32 Z4.55 F1.25\nM5\n");
    for (text, reader) in [(of_linuxcnc, "linuxcnc-lathe"), (text, "fanuc-lathe"), (in_step, "fanuc-lathe")] {
        let language = LatheLanguage::read(reader, &KNOWLEDGE).unwrap();
        let run = read(&text, &language, &[] as &[Subprogram<'_>]);
        let faults = compare_with_part(&operation, 1, &text, &run, &KNOWLEDGE).unwrap();
        assert!(faults.iter().any(|fault| fault.code == "turned-held"), "{reader} {faults:?}");
        let of_thread = |code: &str| code.starts_with("turned-thread") || code.starts_with("swept-thread");
        let found: Vec<_> = grave(&faults).into_iter().filter(|one| of_thread(one.0)).collect();
        assert_eq!(found, [], "{reader}");
    }
}

/// M24x1.5 is 0.92 deep (ISO 68-1, 0.613 P), which Mitsubishi cuts in 6 passes: whole at once it breaks the point, by a cycle, too.
/// Of the first pass makers take 0.5 at the most.
#[test]
fn a_thread_that_is_cut_too_deep_at_once_is_told() {
    let (operation, text) = threaded();
    let (before, _) = text.split_once("\nG32 ").unwrap();
    let (head, first) = before.rsplit_once('\n').unwrap();
    let (all, _) = text.rsplit_once("\nG32 ").unwrap();
    let last: f64 = all.rsplit_once("\nX").unwrap().1.parse().unwrap();
    let (whole, own) = (0.613 * 1.5, &text);
    let begun = |depth: f64| {
        let text =
            text.replacen(&format!("{head}\n{first}\n"), &format!("{head}\nX{:.3}\n", last + 2.0 * (whole - depth)), 1);
        new_in_fanuc(&operation, own, &text)
    };
    assert_eq!(begun(0.45), []);
    assert_eq!(begun(0.7), [("turned-thread-pass", Severity::Doubtful)]);
    assert_eq!(begun(whole), [("turned-thread-pass", Severity::Wrong)]);
    let cycle = format!("{head}\nG76 P010060 Q50 R0\nG76 X{last:.3} Z-30.9735 P920 Q2000 F1.5\n{first}\n");
    let found = new_in_fanuc(&operation, &text, &text.replacen(&format!("{head}\n{first}\n"), &cycle, 1));
    assert!(found.contains(&("turned-thread-pass", Severity::Wrong)), "{found:?}");
}

/// The finishing pass of the cone as a person writes it, along the drawing with G42: a control with the tool of the plan makes the way
/// of our own pass, which the planner has from an offset of its own. The drawn sizes are those of `examples/turned-cone.yaml`.
#[test]
fn a_finishing_pass_under_g42_is_followed() {
    let operation = planned(&example("turned-cone"));
    for (control, reader) in [("fanuc", "fanuc-lathe"), ("sinumerik", "sinumerik")] {
        let written = programs(&operation, control, Form::Motions, None, &KNOWLEDGE).unwrap();
        let text = written[0].files.as_ref().unwrap()[0].text.clone();
        let finish = text.find("FINISH").unwrap();
        let from = finish + text[finish..].find("X19.428").unwrap();
        let to = from + text[from..].find("G0 X73").unwrap();
        let radius = |size: &str| if control == "fanuc" { format!("R{size}.") } else { format!("CR={size}") };
        let drawn = format!(
            "G0 X-1.6\nG1 G42 X0. Z0. F0.15\nX12.\nG3 X24. Z-6. {}\nG1 X44. Z-46.\nZ-56.\nG2 X56. Z-62. {}\n\
             G1 X70.\nX72. Z-63.\nZ-102.\nG40 X73.\n",
            radius("6"),
            radius("6")
        );
        let by_hand = format!("{}{drawn}{}", &text[..from], &text[to..]);
        let language = LatheLanguage::read(reader, &KNOWLEDGE).unwrap();
        let found = |text: &str| {
            let run = read(text, &language, &[] as &[Subprogram<'_>]);
            compare_with_part(&operation, 1, text, &run, &KNOWLEDGE).unwrap()
        };
        let codes = |faults: &[Fault]| faults.iter().map(|one| (one.code, one.severity)).collect::<Vec<_>>();
        let same = codes(&found(&text));
        let faults = found(&by_hand);
        assert!(faults.iter().any(|one| one.code == "turned-nose-taken"), "{faults:?}");
        let others: Vec<_> = codes(&faults).into_iter().filter(|one| one.0 != "turned-nose-taken").collect();
        assert_eq!(others, same, "{control}: {faults:?}");
        // The other side cuts into the part; without a correction metal is left on the cone.
        for (wrong, code) in
            [(by_hand.replace("G42", "G41"), "swept-gouge"), (by_hand.replace("G42 ", ""), "swept-stands")]
        {
            assert!(codes(&found(&wrong)).contains(&(code, Severity::Wrong)), "{control}");
        }
    }
}
