//! The field of a fit beside the nominal size, which is what programs make, and what goes to the machine in words.

use std::path::PathBuf;
use std::process::Command;

use technolog::audit::turned::compare_with_part;
use technolog::note::Severity;
use technolog::program::lathe::{LatheLanguage, Subprogram, read};
use technolog::turning::operation::Operation;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::workpiece::read_turned;
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
    planned(&read_turned("part", &pin(seat, bore), &KNOWLEDGE).unwrap())
}

/// The surfaces that are told, each with its field and the size that is made.
fn told(operation: &Operation) -> Vec<[String; 3]> {
    let told = operation.findings.iter().filter(|finding| finding.note.code() == "field-off-size");
    let told = told.inspect(|finding| assert_eq!(finding.severity, Severity::Wrong));
    told.map(|finding| ["surface", "field", "diameter"].map(|name| finding.note.figure_text(name).unwrap())).collect()
}

/// The diameter that the program makes of a surface.
fn made(operation: &Operation, surface: &str) -> Option<String> {
    let sized = operation.sizes.of_surface(&surface.into());
    sized.map(|sized| sized.made_mm.to_string())
}

/// ISO 286-2 for Ø20: f7 -20 -41, g6 -7 -20, d9 -65 -117, k7 +2 +23, p7 +22 +43, h8 0 -33, js8 ±16; Ø12: F8 +16 +43, N7 -5 -23,
/// H8 0 +27. Turners make the middle; an odd one is rounded so that metal is left.
#[test]
fn a_fit_is_turned_in_the_middle_of_its_limits() {
    for (field, middle) in
        [("f7", "19.97"), ("d9", "19.909"), ("k7", "20.013"), ("p7", "20.033"), ("h8", "19.984"), ("js8", "20")]
    {
        let operation = operation(&format!("grade: {field}, roughness: Ra 3.2"), None);
        assert_eq!(made(&operation, "seat").as_deref(), Some(middle), "{field}");
        assert!(told(&operation).is_empty(), "{field}");
        assert!(!operation.has_errors(), "{field}: {:?}", operation.findings);
    }
    // By number there is no field: the size of the drawing.
    for grade in ["7", "IT12"] {
        assert_eq!(made(&operation(&format!("grade: {grade}, roughness: Ra 3.2"), None), "seat"), None);
    }
}

/// Two faces with limits and a cone between them: 30 +0.2 is made 30.1 long and 40 +0.4 is made 40.2 long, each by its own limits.
#[test]
fn each_face_stands_in_the_middle_of_its_own_limits() {
    let text = "shaft: Pin\nmaterial: steel-45\nblank: {kind: bar, diameter: 60, length: 62, face: 1}\nmachine: 16k20f3\nouter:\n  \
                - {from: {d: 0, z: 0}}\n  - {face: 20}\n  - {cylinder: -30}\n  - {face: 30, name: A, limits: {upper: 0.2, lower: \
                0}}\n  - {cone: {d: 40, z: -40}}\n  - {face: 50, name: B, limits: {upper: 0.4, lower: 0}}\n  - {cylinder: -60}\n";
    let operation = planned(&read_turned("part", text, &KNOWLEDGE).unwrap());
    for (face, least, middle, most) in [("A", "30", "30.1", "30.2"), ("B", "40", "40.2", "40.4")] {
        let sized = operation.sizes.of_surface(&face.into()).unwrap();
        let length = |text: String| text.trim_start_matches(['-', '\u{2212}']).to_owned();
        assert_eq!(length(sized.made_mm.to_string()), middle, "{face}");
        let mut ends = [length(sized.least_mm.to_string()), length(sized.most_mm.to_string())];
        ends.sort();
        assert_eq!(ends, [least, most], "{face}");
    }
}

/// A hole of Ø12 is drilled: it has the size of its drill. A bore of Ø30 is bored in the middle: F8 +20 +53, N7 -7 -28, H8 0 +33.
#[test]
fn a_bore_is_made_in_the_middle_where_a_bar_bores_it() {
    for field in ["F8", "E9", "N7"] {
        let told = told(&operation("grade: h8", Some(&format!("grade: {field}, roughness: Ra 3.2"))));
        assert_eq!(told, [["bore", field, "12"]], "{field}");
    }
    let bush = |field: &str| {
        format!(
            "shaft: Bush\nmaterial: steel-45\nblank: {{kind: bar, diameter: 60, length: 90, face: 1}}\nmachine: \
             16k20f3\nouter:\n  - {{from: {{d: 30, z: 0}}}}\n  - {{face: 55}}\n  - {{cylinder: -60}}\ninner:\n  - {{from: \
             {{d: 30, z: 0}}}}\n  - {{cylinder: -60, name: bore, grade: {field}, roughness: Ra 3.2}}\n"
        )
    };
    for (field, middle) in [("F8", "30.036"), ("N7", "29.982"), ("H8", "30.016"), ("JS8", "30")] {
        let operation = planned(&read_turned("part", &bush(field), &KNOWLEDGE).unwrap());
        assert_eq!(made(&operation, "bore").as_deref(), Some(middle), "{field}");
        assert!(!operation.has_errors(), "{field}: {:?}", operation.findings);
    }
}

/// The tables do not tell the limits of x8, which lies above the nominal size: what is programmed is scrap.
#[test]
fn a_field_without_figures_is_wrong_where_it_leaves_the_size_out() {
    let operation = operation("grade: x8, roughness: Ra 3.2", None);
    assert_eq!(told(&operation), [["seat", "x8", "20"]]);
}

/// Without a lathe nothing is finished elsewhere: a class needs no machine.
#[test]
fn a_fit_without_a_lathe_is_no_error() {
    let part = pin("grade: k6, roughness: Ra 1.25", None).replace("machine: 16k20f3\n", "");
    let operation = planned(&read_turned("part", &part, &KNOWLEDGE).unwrap());
    assert_eq!(made(&operation, "seat").as_deref(), Some("20.009"));
    assert!(told(&operation).is_empty(), "{:?}", operation.findings);
}

/// A seat of grade 6 and Ra 1.25 is ground: the lathe leaves the allowance over the nominal size, and the grinder makes the fit.
#[test]
fn what_is_ground_gets_its_size_there() {
    for field in ["k6", "m6", "n6", "p6", "s6", "f6"] {
        let operation = operation(&format!("grade: {field}, roughness: Ra 0.63"), None);
        assert!(operation.elsewhere.iter().any(|one| one.surface.to_string() == "seat"), "{field}");
        assert!(told(&operation).is_empty() && made(&operation, "seat").is_none(), "{field}");
    }
    assert!(told(&planned(&example("turned-bushing"))).is_empty());
}

/// The codes that are told of a program of the pin, worse than doubtful, and what they measured.
fn faults(operation: &Operation, text: &str) -> Vec<(&'static str, Option<String>)> {
    let language = LatheLanguage::read("linuxcnc-lathe", &KNOWLEDGE).unwrap();
    let run = read(text, &language, &[] as &[Subprogram<'_>]);
    let faults = compare_with_part(operation, 1, text, &run, &KNOWLEDGE).unwrap();
    let wrong = faults.iter().filter(|fault| fault.severity <= Severity::Wrong);
    wrong.map(|fault| (fault.code, fault.note.figure_text("measured"))).collect()
}

/// f7 of Ø20: 19.959 ≤ Ø ≤ 19.980, whoever writes the program. Every size within is good, one micrometre outside is told with the
/// limits.
#[test]
fn a_program_may_make_any_size_within_the_limits() {
    let operation = operation("grade: f7, roughness: Ra 3.2", None);
    let written = programs(&operation, "linuxcnc", Form::Motions, None, &KNOWLEDGE).unwrap();
    let text = &written[0].files.as_ref().unwrap()[0].text;
    assert!(text.contains("X19.97"), "{text}");
    for size in ["19.97", "19.98", "19.959", "19.965"] {
        assert_eq!(faults(&operation, &text.replace("X19.97", &format!("X{size}"))), [], "{size}");
    }
    for (size, code) in [("19.981", "swept-size-left"), ("20", "swept-size-left"), ("19.958", "swept-size-lost")] {
        let told = faults(&operation, &text.replace("X19.97", &format!("X{size}")));
        assert!(told.contains(&(code, Some(size.to_owned()))), "{size}: {told:?}");
    }
}

/// The upper limit of h is the nominal size: a program that makes it is not blamed.
#[test]
fn the_nominal_size_of_h_is_good() {
    let operation = operation("grade: h9, roughness: Ra 3.2", None);
    let written = programs(&operation, "linuxcnc", Form::Motions, None, &KNOWLEDGE).unwrap();
    let text = &written[0].files.as_ref().unwrap()[0].text;
    assert!(text.contains("X19.974"), "{text}");
    for size in ["19.974", "20", "19.948"] {
        assert_eq!(faults(&operation, &text.replace("X19.974", &format!("X{size}"))), [], "{size}");
    }
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
    let part = pin("grade: x8, roughness: Ra 3.2", None);
    for (lang, said) in [("en", "the field x8 does not contain Ø20"), ("uk", "поле допуску x8 не містить Ø20")]
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
    for (lang, said) in [("en", "(THE PASSES OF THE CYCLE ARE OFF THE PLANNED ONES BY UP TO"), ("uk", "(KHODY TSYKLU")]
    {
        let (_, text, _) = turn(lang, nut, &["--show", "cycle", "--control", "fanuc", "--lang", lang]);
        assert!(text.contains(said) && !text.contains("NOT-CYCLED") && text.is_ascii(), "{text}");
    }
}

/// A tube of Ø80, 120 mm long, is faced in the second set-up: soft jaws take a third of it, 40 mm (`soft-jaw-share`), and not the 115
/// up to the tool; it does not go through a spindle of 53. A pin of Ø40 does, and is held close to its face by the same share.
#[test]
fn soft_jaws_are_bored_no_longer_than_the_grip_needs() {
    let jaws = |bar: u32, outside: u32| {
        let part = format!(
            "shaft: P\nmaterial: steel-45\nblank: {{kind: bar, diameter: {bar}, length: 123, face: 1.5}}\nmachine: \
             16k20f3\nouter:\n  - {{from: {{d: 0, z: 0}}}}\n  - {{face: {outside}}}\n  - {{cylinder: -120}}\n"
        );
        planned(&read_turned("part", &part, &KNOWLEDGE).unwrap()).set_ups[1].jaws.unwrap()
    };
    for (bar, outside, front) in [(85, 80, 80.0), (45, 40, 5.0)] {
        let jaws = jaws(bar, outside);
        assert!(jaws.soft);
        assert!((jaws.length_mm.to_mm() - 40.0).abs() < 0.001, "{jaws:?}");
        assert!((jaws.front_mm.to_mm() - front).abs() < 0.001, "{jaws:?}");
    }
}

/// The first set-up leaves the seat of Ø54 thicker by the allowance for grinding, so soft jaws are bored to that.
#[test]
fn soft_jaws_are_bored_to_the_size_as_turned() {
    let bush = "shaft: Bush\nmaterial: steel-45\nblank: {kind: bar, diameter: 70, length: 64, face: 2}\nmachine: \
                16k20f3\nouter:\n  - {from: {d: 40, z: 0}}\n  - {face: 52}\n  - {chamfer: 1}\n  - {cylinder: -40, name: \
                seat, grade: h6, roughness: Ra 1.25}\n  - {groove: grinding-relief}\n  - {face: 65}\n  - {cylinder: \
                -60}\ninner:\n  - {from: {d: 40, z: 0}}\n  - {cylinder: -60}\n";
    let operation = planned(&read_turned("part", bush, &KNOWLEDGE).unwrap());
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
    let operation = planned(&read_turned(&path, &text, &KNOWLEDGE).unwrap());
    let told = operation.findings.iter().find(|finding| finding.note.code() == "turret-too-small").unwrap();
    let told = ["place", "offset"].map(|name| told.note.figure_text(name));
    assert_eq!(told, [Some("2".to_owned()), Some("7".to_owned())]);
}
