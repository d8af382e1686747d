//! Parts between centres: the centre and its quill as bodies, and programs that pass them.

use technolog::note::Severity;
use technolog::turning::operation::Operation;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::workpiece::{Turned, Workpiece, read_turned};
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
    match read_turned("part", &text, &KNOWLEDGE).unwrap() {
        Turned::Contoured(workpiece) => planned(&workpiece),
        Turned::Stepped(shaft) => planned(&Workpiece::from(&shaft)),
    }
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
