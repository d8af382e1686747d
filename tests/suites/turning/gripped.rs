//! Whether jaws hold a part, and whether it bears them.

use technolog::note::Severity;
use technolog::turning::operation::plan;
use technolog::turning::workpiece::read_workpiece;
use technolog_testing::KNOWLEDGE;

/// What is told of jaws, doubtful or worse.
fn told(part: &str) -> Vec<(Severity, String)> {
    let operation = plan(&read_workpiece("part", part, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap();
    let found = operation.findings.iter().filter(|finding| finding.severity <= Severity::Doubtful);
    let of_jaws =
        found.filter(|finding| finding.note.code().starts_with("jaws-") || finding.note.code().starts_with("grip-"));
    of_jaws.map(|finding| (finding.severity, finding.note.code().to_owned())).collect()
}

/// A sleeve of a tube: Ø63 with a bore of 56, held by it in the second set-up.
fn sleeve(jaws: &str, outside: u32) -> String {
    format!(
        "shaft: Sleeve\nmaterial: steel-45\nblank: {{kind: tube, diameter: {}, bore: 52, length: 90, face: 1}}\n\
         machine: 16k20f3\n{jaws}outer:\n  - {{from: {{d: 56, z: 0}}}}\n  - {{face: {}}}\n  - {{cylinder: -30}}\n  \
         - {{face: {outside}}}\n  - {{cylinder: -50}}\ninner:\n  - {{from: {{d: 56, z: 0}}}}\n  \
         - {{cylinder: -50, grade: H7, roughness: Ra 1.6}}\n",
        outside + 3,
        outside - 3
    )
}

/// By hand, second set-up: R = 29.75 and t = 3.5 under soft jaws of 35 mm (36°: 0.60 of the bending), 20 mm long, and 13 mm of tube on
/// a side, as far as there is one: σ = 0.3·600 = 180 MPa. Of F/3·0.189·R·0.6·6/(b·t²) + F/(2π·b·t) with b = 40: 180 = F·0.0138 +
/// F·0.0011, F = 12 kN; at b = 20, half of it. The far face pulls with 0.5 kN on μ = 0.1, which asks for 10 kN.
#[test]
fn a_thin_wall_gives_way_to_three_jaws() {
    let has = |part: &str, code: &str| told(part).iter().any(|one| one.1 == code);
    assert!(told(&sleeve("", 63)).contains(&(Severity::Wrong, "jaws-crush".to_owned())));
    // Held nearly all around it bears the same force; a thick wall bears it in three jaws.
    assert!(!has(&sleeve("jaws: full-grip\n", 63), "jaws-crush"));
    assert!(!has(&sleeve("jaws: full-grip\n", 63), "jaws-make-lobes"));
    assert!(!has(&sleeve("", 90), "jaws-crush"));
}

/// A flange of Ø180 on 7 mm of its hub of Ø60, in soft jaws at 40 kN: they hold 40000·(7 + 0.1·60)/(2·√3) = 150 N·m. A cut of 4 mm at
/// 0.5 mm/rev, some 3300 N of Pz, at 33 mm from the middle of the grip tips with 110 N·m and more; with the safety of 2 too much.
#[test]
fn a_flange_on_a_short_hub_tips() {
    let part = |roughing: &str| {
        format!(
            "shaft: Flange\nmaterial: steel-45\nblank: {{kind: bar, diameter: 190, length: 38, face: 2}}\nmachine: 16k20f3\n\
             outer:\n  - {{from: {{d: 0, z: 0}}}}\n  - {{face: 60}}\n  - {{cylinder: -10}}\n  - {{face: 180}}\n  \
             - {{cylinder: -30}}\n{roughing}"
        )
    };
    let weak = |part: String| told(&part).iter().any(|one| one.1 == "grip-tips" || one.1 == "grip-too-weak");
    assert!(weak(part("roughing: {limiting_depth: 4}\n")));
    // Left to the plan, passes are as shallow as the jaws hold.
    assert!(!weak(part("")));
}
