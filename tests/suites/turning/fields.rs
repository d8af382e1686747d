//! The field of a fit beside the nominal size, which is what programs make, and what goes to the machine in words.

use std::path::PathBuf;
use std::process::Command;

use technolog::audit::turned::compare_with_part;
use technolog::note::Severity;
use technolog::program::lathe::{LatheLanguage, Subprogram, read};
use technolog::turning::operation::Operation;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::workpiece::{read_turned, read_workpiece};
use technolog_testing::KNOWLEDGE;

use crate::operation::{example, planned};

/// A pin with a seat of Ø20, in its end a hole of Ø12 if it has one, as a file.
fn pin(seat: &str, bore: Option<&str>) -> String {
    let (from, inner) = match bore {
        None => (0, String::new()),
        Some(bore) => {
            (12, format!("inner:\n  - {{from: {{d: 12, z: 0}}}}\n  - {{cylinder: -60, name: bore, {bore}}}\n"))
        }
    };
    format!(
        "shaft: Pin\nmaterial: steel-45\nblank: {{kind: bar, diameter: 40, length: 62, face: 1}}\nmachine: \
         16k20f3\nouter:\n  - {{from: {{d: {from}, z: 0}}}}\n  - {{face: 20}}\n  - {{cylinder: -30, name: seat, \
         {seat}}}\n  - {{face: 36}}\n  - {{cylinder: -60}}\n{inner}"
    )
}

fn operation(seat: &str, bore: Option<&str>) -> Operation {
    planned(&read_workpiece("part", &pin(seat, bore), &KNOWLEDGE).unwrap())
}

/// The surfaces that are told, each with its field and the size that is made.
fn told(operation: &Operation) -> Vec<[String; 3]> {
    let told = operation.findings.iter().filter(|finding| finding.note.code() == "field-off-size");
    let told = told.inspect(|finding| assert_eq!(finding.severity, Severity::Wrong));
    told.map(|finding| ["surface", "field", "diameter"].map(|name| finding.note.figure_text(name).unwrap())).collect()
}

/// ISO 286-2 for Ø20: f7 19.959 to 19.980, x8 above 20.054, d9, e8 and g6 below 20; Ø12: F8, E9 above, N7 11.977 to 11.995. A part
/// of the nominal size is scrap there. h, js, H and JS hold it, and so do grades by number.
#[test]
fn a_field_without_the_size_that_is_made_is_wrong() {
    for field in ["f7", "x8", "d9", "e8", "k7", "p7"] {
        let told = told(&operation(&format!("grade: {field}, roughness: Ra 3.2"), None));
        assert_eq!(told, [["seat", field, "20"]], "{field}");
    }
    for field in ["F8", "E9", "N7"] {
        let told = told(&operation("grade: h8", Some(&format!("grade: {field}, roughness: Ra 3.2"))));
        assert_eq!(told, [["bore", field, "12"]], "{field}");
    }
    for (seat, bore) in [("h8", "H8"), ("js8", "JS9"), ("7", "9"), ("h9", "Js9"), ("js12", "IT12")] {
        assert!(
            told(&operation(&format!("grade: {seat}"), Some(&format!("grade: {bore}")))).is_empty(),
            "{seat} {bore}"
        );
    }
}

/// A seat of grade 6 and Ra 1.25 is ground: the lathe leaves the allowance, and the grinder makes the size.
#[test]
fn what_is_ground_gets_its_size_there() {
    for field in ["k6", "m6", "n6", "p6", "s6", "f6"] {
        let operation = operation(&format!("grade: {field}, roughness: Ra 0.63"), None);
        assert!(operation.elsewhere.iter().any(|one| one.surface.to_string() == "seat"), "{field}");
        assert!(told(&operation).is_empty(), "{field}");
    }
    assert!(told(&planned(&example("turned-bushing"))).is_empty());
}

/// Whoever wrote a program of such a part, it is told, at its end.
#[test]
fn a_program_of_a_part_with_such_a_field_is_not_passed() {
    let operation = operation("grade: f7, roughness: Ra 3.2", None);
    let written = programs(&operation, "linuxcnc", Form::Motions, None, &KNOWLEDGE).unwrap();
    let text = &written[0].files.as_ref().unwrap()[0].text;
    let language = LatheLanguage::read("linuxcnc-lathe", &KNOWLEDGE).unwrap();
    let run = read(text, &language, &[] as &[Subprogram<'_>]);
    let faults = compare_with_part(&operation, 1, text, &run, &KNOWLEDGE).unwrap();
    let wrong: Vec<_> = faults.iter().filter(|fault| fault.severity <= Severity::Wrong).collect();
    assert_eq!(wrong.iter().map(|fault| fault.code).collect::<Vec<_>>(), ["turned-of-plan"], "{wrong:?}");
}

/// What the command answers about a part: its end, what it gives out and what it complains of.
fn turn(name: &str, part: &str, arguments: &[&str]) -> (Option<i32>, String, String) {
    let folder: PathBuf = std::env::temp_dir().join(format!("technolog-fields-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("part.yaml"), part).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_technolog"));
    let run = command.current_dir(&folder).args(["turn", "part.yaml"]).args(arguments).output().unwrap();
    std::fs::remove_dir_all(&folder).unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (run.status.code(), text(run.stdout), text(run.stderr))
}

#[test]
fn the_page_and_the_programs_say_it_in_both_languages() {
    let part = pin("grade: f7, roughness: Ra 3.2", None);
    for (lang, said) in [("en", "the field f7 does not contain Ø20"), ("uk", "поле допуску f7 не містить Ø20")]
    {
        let (code, page, _) = turn(lang, &part, &["--lang", lang]);
        assert!(code == Some(1) && page.contains(said), "{page}");
        let (code, _, errors) = turn(lang, &part, &["--show", "program", "--lang", lang]);
        assert!(code == Some(1) && errors.contains(said), "{errors}");
    }
    let (code, ..) = turn("middle", &pin("grade: 7, roughness: Ra 3.2", None), &["--show", "program"]);
    assert_eq!(code, Some(0));
}

/// A thread that the cycle of the control does not make as planned says why in words, of the language asked.
#[test]
fn a_program_says_in_words_why_a_thread_has_single_passes() {
    let nut = "shaft: Nut\nmaterial: steel-45\nblank: {kind: bar, diameter: 60, length: 60, face: 2}\nmachine: \
               16k20f3\nouter:\n  - {from: {d: 40.84, z: 0}}\n  - {face: 53}\n  - {chamfer: 1}\n  - {cylinder: \
               -38}\ninner:\n  - {from: {d: 40.84, z: 0}}\n  - {chamfer: 1.5}\n  - {thread: M40x2-6H, to: -22}\n  - \
               {groove: rectangular, width: 5, depth: 1.3}\n  - {face: 25}\n  - {cylinder: -38, grade: H9}\n";
    for (lang, said) in [("en", "(the passes of the cycle are off the planned ones by up to"), ("uk", "(khody tsyklu")]
    {
        let (_, text, _) = turn(lang, nut, &["--show", "cycle", "--control", "fanuc", "--lang", lang]);
        assert!(text.contains(said) && !text.contains("not-cycled") && text.is_ascii(), "{text}");
    }
}

/// The first set-up leaves the seat of Ø54 thicker by the allowance for grinding, so soft jaws are bored to that.
#[test]
fn soft_jaws_are_bored_to_the_size_as_turned() {
    let bush = "shaft: Bush\nmaterial: steel-45\nblank: {kind: bar, diameter: 70, length: 64, face: 2}\nmachine: \
                16k20f3\nouter:\n  - {from: {d: 40, z: 0}}\n  - {face: 52}\n  - {chamfer: 1}\n  - {cylinder: -40, name: \
                seat, grade: h6, roughness: Ra 1.25}\n  - {groove: grinding-relief}\n  - {face: 65}\n  - {cylinder: \
                -60}\ninner:\n  - {from: {d: 40, z: 0}}\n  - {cylinder: -60}\n";
    let operation = planned(&read_workpiece("part", bush, &KNOWLEDGE).unwrap());
    let left = operation.elsewhere.iter().find(|one| one.surface.to_string() == "seat").unwrap();
    let jaws = operation.set_ups[1].jaws.unwrap();
    assert!(left.allowance_mm.to_mm() > 0.0 && jaws.soft);
    assert!((jaws.grips_mm.to_mm() - (54.0 + 2.0 * left.allowance_mm.to_mm())).abs() < 1e-9, "{jaws:?}");
    assert_eq!(jaws.bored().and_then(|note| note.figure_text("grips")), Some(jaws.grips_mm.to_string()));
}

/// Of ten tools in six places the seventh stands in place 2, as its programs call it.
#[test]
fn the_example_of_a_shared_place_is_a_real_one() {
    let path = format!("{}/tests/everyday/many-tools.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap();
    let operation = planned(&read_turned(&path, &text, &KNOWLEDGE).unwrap().into_workpiece());
    let told = operation.findings.iter().find(|finding| finding.note.code() == "turret-too-small").unwrap();
    let told = ["place", "offset"].map(|name| told.note.figure_text(name));
    assert_eq!(told, [Some("2".to_owned()), Some("7".to_owned())]);
}
