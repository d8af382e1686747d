//! Parts between centres: the centre and its quill as bodies, and programs that pass them.

use technolog::note::Severity;
use technolog::turning::length::Half;
use technolog::turning::operation::Operation;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::workpiece::read_turned;
use technolog_testing::KNOWLEDGE;

use crate::operation::planned;

/// A shaft of two cylinders between centres, its faces milled before.
fn shaft(journal: u32, body: u32) -> Operation {
    let text = format!(
        "shaft: s
material: steel-45
blank: {{kind: bar, diameter: {blank}, length: 250}}
machine: 16k20f3
holding: centres
outer:
  - {{from: {{d: 0, z: 0}}}}
  - {{face: {journal}, allowance: 0}}
  - {{cylinder: -60, grade: h9, roughness: Ra 3.2}}
  - {{face: {body}}}
  - {{cylinder: -250, grade: h9, roughness: Ra 3.2}}
",
        blank = body + 4
    );
    planned(&read_turned("part", &text, &KNOWLEDGE).unwrap())
}

/// What meets the tailstock, and how grave it is.
fn met(operation: &Operation) -> Vec<Severity> {
    let struck = operation.findings.iter().filter(|finding| finding.note.code() == "swept-struck");
    struck.map(|finding| finding.severity).collect()
}

/// By hand: a tool of a shank of 25 mm stands from Z2 to Z27 at least. There a centre of 60° in a hole of Ø8.5 has
/// grown to Ø8.5 + 2·27·tan 30° = Ø39.7, more than a journal of Ø18: it has to be turned down, 0.5 mm off the nearest tool: Ø18h9 is turned at Ø17.979,
/// so to whole millimetres Ø16. A
/// journal of Ø60 is clear of its body of Ø44.4.
#[test]
fn a_thin_journal_asks_for_a_centre_that_is_turned_down() {
    let slim = |operation: &Operation| {
        let told = operation.findings.iter().find(|finding| finding.note.code() == "centre-turned-down")?;
        Some((told.severity, told.note.figure_text("body")?))
    };
    let thin = shaft(18, 25);
    assert_eq!((met(&thin), slim(&thin)), (vec![], Some((Severity::Doubtful, "16".to_owned()))));
    let thick = shaft(60, 70);
    assert_eq!((met(&thick), slim(&thick)), (vec![], None));
}

/// A turret that left with both axes at once would go through the quill.
#[test]
fn programs_between_centres_leave_by_x_and_come_by_z() {
    let operation = shaft(60, 70);
    for (control, away) in
        [("linuxcnc", "G91 G28 X0\nG28 Z0\nG90\n"), ("fanuc", "G28 U0.\nG28 W0.\n"), ("sinumerik", "G75 X0\nG75 Z0\n")]
    {
        let written = programs(&operation, control, Form::Motions, None, &KNOWLEDGE).unwrap();
        let text = &written[0].files.as_ref().unwrap()[0].text;
        let tools = text.matches("M8\n").count();
        assert_eq!(text.matches(away).count(), tools + 1, "{text}");
        assert_eq!(text.matches("G28").count() + text.matches("G75").count(), 2 * (tools + 1), "{text}");
        for (coolant, _) in text.match_indices("M8\n") {
            let mut next = text[coolant..].lines().skip(1);
            let (first, second) = (next.next().unwrap(), next.next().unwrap());
            assert!(first.starts_with("G0 Z") && second.starts_with('X'), "{first} {second}");
        }
    }
}

/// A shaft 340 mm out of the jaws: by hand Ø40 bends in the chuck by F·L³/(3·E·I), at a centre by 0.00981·F·L³/(E·I), 34 times less:
/// what the chuck alone refuses is turned. The face at the centre is made before, no tool comes to the axis, both bodies are in the
/// proof, the bar is not parted off between them, and turned over the part has no centre before the face that is cut.
#[test]
fn a_long_shaft_is_held_in_the_chuck_and_at_a_centre() {
    let path = format!("{}/tests/everyday/long-shaft.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap();
    let of = |text: &str| planned(&read_turned(&path, text, &KNOWLEDGE).unwrap());
    let codes = |operation: &Operation| {
        let wrong = operation.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
        wrong.map(|finding| finding.note.code().to_owned()).collect::<Vec<_>>()
    };
    let operation = of(&text);
    assert_eq!(codes(&operation), [""; 0], "{:?}", operation.findings);
    let [first, second] = operation.set_ups.as_slice() else { panic!() };
    assert!(first.tailstock.is_some() && first.jaws.is_some_and(|jaws| jaws.body.is_some()));
    assert!(second.tailstock.is_none() && second.jaws.is_some() && first.parted_mm.is_none());
    let nearest = first.jobs.iter().flat_map(|job| &job.path.moves).map(|one| one.to.radius).min().unwrap();
    assert!(nearest > Half::from(10.0), "{nearest}");
    let alone = of(&text.replace("chuck-and-centre", "chuck"));
    assert!(codes(&alone).contains(&"bounds-exceeded".to_owned()), "{:?}", codes(&alone));
    let bored = text.replace("{from: {d: 0, z: 0}}", "{from: {d: 22, z: 0}}")
        + "inner:\n  - {from: {d: 22, z: 0}}\n  - {cylinder: -40}\n  - {face: 0}\n";
    assert!(codes(&of(&bored)).contains(&"bore-behind-centre".to_owned()));
}
