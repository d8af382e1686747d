//! A plan of the program rewritten as a hand-written one: what the planner computes by formula must also pass the
//! audit of hand-written plans. So the formulas, reaches and lengths used in that audit are those of planning.

use technolog::audit::{by_hand, read_plan};
use technolog::note::Severity;
use technolog::part::Part;
use technolog::plan::CuttingMethod;
use technolog_laws::every;
use technolog_testing::{AUDITOR, KNOWLEDGE, plan_of_hole_by_tables, planned, read};

/// The findings of the audit about the plan of a part, without notes.
fn found(part_file: &str) -> Vec<String> {
    let part: Part = read(part_file);
    let plan = planned(&part, CuttingMethod::Formula);
    let text = by_hand(&plan, "part.yaml");
    let files = |_: &str| Ok(part_file.to_owned());
    let stated = read_plan("plan.yaml", &text, &KNOWLEDGE, &files).unwrap_or_else(|why| panic!("{why:?}\n{text}"));
    let audit = AUDITOR.audit(&stated).unwrap();
    let grave = audit.findings.iter().filter(|one| one.severity < Severity::Note);
    grave.map(|one| format!("{:?} {} {} {:?} {:?}", one.severity, one.rule, one.field, one.stated, one.note)).collect()
}

/// A mill pushes this part with more than the larger torque of its drill turns it with: the plan states the side force, and the
/// audit holds the clamping force against it.
#[test]
fn a_plan_clamped_against_sliding_is_right_when_it_is_written_by_hand() {
    let part = "part: P\nmaterial: СЧ20\nmachine: gf2171\nblank: {kind: plate, length: 1000, width: 400, thickness: 60}\n\
        holes:\n  - {name: A, diameter: 50H9, through: true, roughness: Ra 2.5, centre_tolerance: 0.3, state: cast, \
        state_diameter: 42, at: [[0, 0]]}\n  - {name: B, diameter: 30H12, through: true, roughness: Ra 12.5, \
        centre_tolerance: 0.3, at: [[300, 0]]}\n";
    let clamping = planned(&read(part), CuttingMethod::Formula).clamping.unwrap();
    assert_eq!((clamping.hole.as_str(), clamping.side_force_n.is_some()), ("A", true));
    assert_eq!(found(part), [""; 0]);
}

/// A countersink that goes round a wide edge is narrower than it, and bars end above a flat floor.
#[test]
fn a_wide_edge_and_a_flat_floor_are_right_when_they_are_written_by_hand() {
    for keys in [
        "diameter: 60H9, roughness: Ra 3.2, through: true, chamfer: 2",
        "diameter: 26H9, roughness: Ra 3.2, depth: 6, bottom: flat",
        "diameter: 30H14, roughness: Ra 12.5, depth: 8, bottom: flat",
        "diameter: 3.4H14, roughness: Ra 12.5, through: true, counterbore: {diameter: 6.5, depth: 3.4}",
        "diameter: 6.6H14, roughness: Ra 12.5, through: true, face: 11",
    ] {
        let part = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, length: 200, width: 150, thickness: 40}}\n\
             holes:\n  - {{name: A, {keys}, centre_tolerance: 0.2, at: [[0, 0]]}}\n"
        );
        assert_eq!(found(&part), [""; 0], "{keys}");
    }
}

/// Fields that do not begin at the nominal size: reamers are ground for those below it, and bought for a field H for those above.
#[test]
fn fields_beside_h_are_right_in_our_plan_and_when_they_are_written_by_hand() {
    for (diameter, roughness) in [
        ("25G7", "Ra 1.6"),
        ("12F8", "Ra 3.2"),
        ("10K7", "Ra 1.6"),
        ("30JS7", "Ra 1.6"),
        ("20P7", "Ra 1.6"),
        ("52K7", "Ra 1.6"),
    ] {
        let part = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: plate, length: 200, width: 150, thickness: 30}}\n\
             holes:\n  - {{name: A, diameter: {diameter}, roughness: {roughness}, through: true, centre_tolerance: 0.5, at: [[0, 0]]}}\n"
        );
        assert_eq!(found(&part), [""; 0], "{diameter} by hand");
        let plan = planned(&read(&part), CuttingMethod::Formula);
        let text = serde_json::to_string(&plan).unwrap();
        let stated = read_plan("plan.json", &text, &KNOWLEDGE, &|_: &str| Err("no file".to_owned())).unwrap();
        let grave = AUDITOR.audit(&stated).unwrap().findings.into_iter().find(|one| one.severity < Severity::Note);
        assert_eq!(grave.map(|one| one.note), None, "{diameter}");
    }
}

#[test]
fn what_we_plan_is_right_when_it_is_written_by_hand() {
    let (mut wrong, mut cases) = (Vec::new(), Vec::new());
    for material in [
        "steel-45",
        "steel-40x",
        "stainless-12h18n10t",
        "cast-iron-sch20",
        "malleable-kch30-6",
        "brass-l63",
        "aluminium-d16",
    ] {
        for (diameter, depth, roughness) in [
            ("4H12", 15, "Ra 12.5"),
            ("8H11", 40, "Ra 6.3"),
            ("9H9", 20, "Ra 2.5"),
            ("12H7", 30, "Ra 1.25"),
            ("16H9", 60, "Ra 2.5"),
            ("20H12", 40, "Ra 12.5"),
            ("28H11", 50, "Ra 6.3"),
            ("40H8", 40, "Ra 2.5"),
        ] {
            for through in [true, false] {
                let thickness = if through { depth } else { depth + 20 };
                let part = format!(
                    "part: P\nmaterial: {material}\nmachine: gf2171\nfixture: {{height: 60}}\n\
                     blank: {{kind: plate, length: 400, width: 200, thickness: {thickness}}}\nholes:\n  - {{name: A, \
                     diameter: {diameter}, depth: {depth}, through: {through}, roughness: {roughness}, \
                     centre_tolerance: 0.2, at: [[-60, 0], [60, 0]]}}\n"
                );
                cases.push((format!("{material} {diameter} {depth} {through}"), part));
            }
        }
    }
    // Sixteen holes of a material: every third case meets each of them.
    for (name, part) in cases.iter().step_by(every(3)) {
        let reported = found(part);
        if !reported.is_empty() {
            wrong.push(format!("{name}: {}", reported.join("\n    ")));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The tables' own route through 18H7 in grey iron takes 0.4 % longer than ours: nobody is blamed for it.
#[test]
fn a_route_that_is_hardly_longer_is_only_noted() {
    let keys = "diameter: 18H7, through: true, roughness: Ra 2.5, centre_tolerance: 0.46, at: [[-50, 0], [50, 0]]";
    let plan = plan_of_hole_by_tables("СЧ20", "gf2171", "30", keys);
    let text = serde_json::to_string(&plan).unwrap();
    let stated = read_plan("plan.json", &text, &KNOWLEDGE, &|_: &str| Err("no file".to_owned())).unwrap();
    let audit = AUDITOR.audit(&stated).unwrap();
    let of_route = audit.findings.iter().filter(|one| one.rule.starts_with("audit-route"));
    let found: Vec<_> = of_route.map(|one| (one.rule.as_str(), one.severity)).collect();
    assert_eq!(found, [("audit-route-as-good", Severity::Note)]);
}
