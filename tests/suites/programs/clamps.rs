//! Clamps and obstacles of the part file: our programs go over them, and a program that does not is told, in both set-ups.

use std::sync::LazyLock;

use technolog::note::Severity;
use technolog::program::Language;
use technolog::units::Micrometres;
use technolog_testing::proof_bench::ProofBench;
use technolog_testing::read;

static LANGUAGES: LazyLock<Vec<(&str, Language)>> = LazyLock::new(technolog_testing::languages);

/// Four holes round a clamp in the middle of each side, and a counterbore from the back face.
fn bench(fixture: &str) -> ProofBench {
    ProofBench::of(&read(&format!(
        "part: P\nmaterial: steel-45\nblank: {{kind: plate, length: 240, width: 160, thickness: 30}}\nmachine: gf2171\n\
         fixture: {{height: 80{fixture}}}\nholes:\n  \
         - {{name: A, diameter: 10H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.5, \
         at: [[-60, -60], [60, -60], [60, 60], [-60, 60]]}}\n  \
         - name: B\n    through: true\n    roughness: Ra 12.5\n    centre_tolerance: 0.3\n    \
         steps: [{{diameter: 11, length: 20}}, {{diameter: 18}}]\n    at: [[-90, 0], [90, 0]]\n"
    )))
}

const CLAMPS: &str =
    ", clamps: [{at: [0, -60], height: 35}, {at: [0, 60], height: 35, outline: [[-15, 50], [15, 90]]}]";

fn highest(bench: &ProofBench, set_up: usize) -> Micrometres {
    let works = &bench.job.setups[set_up].works;
    works.iter().flat_map(|work| &work.cycles).map(|cycle| cycle.out).max().unwrap()
}

#[test]
fn tools_go_over_clamps_and_obstacles_and_the_programs_prove() {
    // Without clamps of the file tools go over straps of M10, 35 mm high: in the second set-up where none of its obstacles are given.
    for (fixture, first, second) in [
        ("", 40, 40),
        (CLAMPS, 40, 40),
        (", obstacles: [{outline: [[-20, -20], [20, 20]], height: 50}]", 55, 40),
        (", obstacles: [{outline: [[-20, -20], [20, 20]], height: 50, set_up: 2}]", 40, 55),
        (", obstacles: [{outline: [[100, -80], [119, -70]], height: 45}]", 40, 40),
        (", retract: 25", 25, 25),
    ] {
        let bench = bench(fixture);
        assert_eq!(bench.job.setups.len(), 2, "{fixture}");
        let reached = [0, 1].map(|set_up| highest(&bench, set_up));
        assert_eq!(reached, [first, second].map(Micrometres::from_mm), "{fixture}");
        for (control, language) in &*LANGUAGES {
            let (faults, proof, _) = bench.run(language, &bench.written(language));
            assert!(!faults.iter().any(technolog::program::Fault::is_grave), "{control} {fixture}: {faults:?}");
            assert!(!proof.has_errors(), "{control} {fixture}: {:?}", proof.findings);
        }
    }
}

#[test]
fn a_way_through_a_clamp_or_an_obstacle_is_an_error_in_both_set_ups() {
    for (fixture, through) in [
        (", retract: 25", false),
        (", retract: 25, clamps: [{at: [0, -60], height: 35}, {at: [0, 60], height: 35}]", true),
        (", retract: 25, clamps: [{at: [0, -60], height: 20}, {at: [0, 60], height: 20}]", false),
        (", retract: 25, obstacles: [{outline: [[-20, -20], [20, 20]], height: 26, set_up: 2}]", true),
        // Down on it, though no way leads over it.
        (", retract: 60, obstacles: [{outline: [[50, 50], [56, 70]], height: 40}]", true),
    ] {
        let bench = bench(fixture);
        for (control, language) in &*LANGUAGES {
            let codes = bench.codes(language, &bench.written(language));
            assert_eq!(codes.contains(&"through-obstacle"), through, "{control} {fixture}: {codes:?}");
        }
    }
}

/// The program of the bare part is another's when clamps stand on it.
#[test]
fn a_program_that_knows_no_clamps_is_told_of_them() {
    let (bare, clamped) = (bench(", retract: 15"), bench(CLAMPS));
    for (control, language) in &*LANGUAGES {
        let codes = clamped.codes(language, &bare.written(language));
        assert!(codes.contains(&"through-obstacle"), "{control}: {codes:?}");
    }
}

/// Straps that the plan proposes may be lower, so a lower way over them is a note; what the shop has is as high as it is, even
/// where straps are proposed beside it.
#[test]
fn a_low_way_is_a_note_only_over_straps_of_the_plan() {
    let obstacle = |height: u32| format!(", obstacles: [{{outline: [[-20, -20], [20, 20]], height: {height}}}]");
    for (lower, fixture, severity) in
        [(", retract: 38".to_owned(), String::new(), Severity::Note), (obstacle(48), obstacle(50), Severity::Doubtful)]
    {
        let (lower, bench) = (bench(&lower), bench(&fixture));
        assert!(bench.job.setups[0].standing.iter().any(|one| one.proposed), "{fixture}");
        for (control, language) in &*LANGUAGES {
            let proof = bench.run(language, &lower.written(language)).1;
            let low: Vec<_> = proof.findings.iter().filter(|one| one.code.name() == "travel-low").collect();
            assert!(!low.is_empty() && low.iter().all(|one| one.severity == severity), "{control} {fixture}: {low:?}");
        }
    }
}

/// A way over a clamp whose height nobody has said cannot be proven: the height is asked for. One that no way crosses is
/// not asked for.
#[test]
fn the_height_of_a_clamp_under_a_way_is_asked_for() {
    for (fixture, asked) in [
        (", clamps: [{at: [0, -60]}, {at: [0, 60]}]", true),
        (", clamps: [{at: [0, -60], height: 35}, {at: [0, 60], height: 35}]", false),
        (", clamps: [{at: [110, -70]}, {at: [-110, -70]}]", false),
    ] {
        let bench = bench(fixture);
        let asks = |finding: &&technolog::note::Finding| finding.note.code() == "ways-over-clamps";
        let found: Vec<_> = bench.job.findings.iter().filter(asks).collect();
        assert_eq!(!found.is_empty(), asked, "{fixture}");
        assert!(found.iter().all(|finding| finding.severity == technolog::note::Severity::Wrong), "{fixture}");
    }
}

/// G99 for G98 lets a tool go from hole to hole on plane R: harmless over a bare face, through a clamp it is an error.
#[test]
fn on_plane_r_a_tool_goes_through_clamps() {
    for (fixture, through) in [(CLAMPS, true), (", retract: 15", false)] {
        let bench = bench(fixture);
        for (control, language) in LANGUAGES.iter().filter(|(control, _)| *control != "2c42-65") {
            let written = bench.written(language);
            // Without cycles there is no plane R.
            if !written.contains("G98") {
                continue;
            }
            let text = written.replace("G98", "G99");
            assert_eq!(bench.codes(language, &text).contains(&"through-obstacle"), through, "{control} {fixture}");
        }
    }
}

/// The cutter clears a tall obstacle beside its hole, its holder does not: in either set-up. A holder that no table
/// knows is taken to be as thick as its collar, 97.5 mm, and the nose of the spindle is 128.57 mm wide.
#[test]
fn a_holder_meets_an_obstacle_beside_the_hole() {
    let codes = |fixture: &str| {
        let bench = bench(fixture);
        let (_, language) = &LANGUAGES[0];
        let proof = bench.run(language, &bench.written(language)).1;
        proof
            .findings
            .iter()
            .filter(|one| one.severity <= technolog::note::Severity::Wrong)
            .map(|one| one.code.name())
            .collect::<Vec<_>>()
    };
    // Hole A at X60 Y60; the obstacle begins 20 mm behind it.
    let beside = |height: u32, set_up: u32, x: u32| {
        format!(
            ", retract: 200, obstacles: [{{outline: [[{x}, 50], [{}, 70]], height: {height}, set_up: {set_up}}}]",
            x + 20
        )
    };
    assert_eq!(codes(&beside(20, 1, 80)), [""; 0]);
    let found = codes(&beside(60, 1, 80));
    assert!(found.contains(&"holder-unknown") && !found.contains(&"through-obstacle"), "{found:?}");
    // 20 mm are free beside the axis, and 48.75 mm are half the collar: the setter is told both.
    let near = bench(&beside(60, 1, 80));
    let (_, language) = &LANGUAGES[0];
    let proof = near.run(language, &near.written(language)).1;
    let told = proof.findings.iter().find(|one| one.code.name() == "holder-unknown").unwrap();
    let figure = |name: &str| {
        let (_, value) = told.note.figures().find(|(known, _)| *known == name).unwrap();
        value.text().parse::<f64>().unwrap()
    };
    assert!((figure("free") - 40.0).abs() < 0.003 && (figure("aside") - 28.75).abs() < 0.003, "{:?}", told.note);
    assert_eq!(codes(&beside(60, 1, 109)), [""; 0]);
    // Beyond the collar there is nothing that low.
    assert_eq!(codes(&beside(60, 1, 110)), [""; 0]);
    let found = codes(&beside(190, 1, 110));
    assert!(found.contains(&"holder-through-obstacle"), "the nose: {found:?}");
    // The second set-up bores B at X90 Y0 (seen from the back at X-90).
    let back = ", retract: 200, obstacles: [{outline: [[-120, -10], [-110, 10]], height: 190, set_up: 2}]";
    let found = codes(back);
    assert!(found.iter().any(|code| code.starts_with("holder-")), "{found:?}");
}
