//! The whole operation, carried through the proof of turning (`crates/turning-proof`), which shares nothing with what
//! makes its toolpaths.

use proptest::prelude::*;
use serde_json::json;
use technolog::audit::turned::{compare_with_part, read_back, reader};
use technolog::note::{Figure, Severity};
use technolog::program::lathe::{LatheLanguage, is_serious, read};
use technolog::turning::contour::Side;
use technolog::turning::length::Half;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::operation::work::Work;
use technolog::turning::operation::{Operation, plan};
use technolog::turning::toolpath::Purpose;
use technolog::turning::workpiece::{Workpiece, read_turned};
use technolog::units::RevsPerMinute;
use technolog_testing::{KNOWLEDGE, shafts, turned};
use technolog_turning_proof::{Fault, What};

pub(crate) fn example(name: &str) -> Workpiece {
    let path = format!("{}/examples/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    read_turned("part", &text, &KNOWLEDGE).unwrap()
}

pub(crate) fn planned(workpiece: &Workpiece) -> Operation {
    plan(workpiece, &KNOWLEDGE).unwrap()
}

/// Codes of findings that say why a zone has no way: those that name it by its number, and those of the part.
const NAMED: [&str; 6] = [
    "no-tool-for-zone",
    "no-bar-for-bore",
    "zone-behind-standing",
    "scheme-not-possible",
    "zone-not-cleared",
    "too-many-passes",
];
const OF_THE_PART: [&str; 6] =
    ["no-limiting-depth", "no-depth-allowed", "no-figure", "flank-too-steep", "bar-too-long", "job-left-out"];
/// The same for a side without layers.
const OF_A_SIDE: [&str; 3] = ["no-rough-contour", "no-intermediate-contour", "bore-too-narrow-to-drill"];

/// What is not cleared, with nothing that says why.
fn silent(operation: &Operation) -> Vec<String> {
    let says = |codes: &[&str]| operation.findings.iter().any(|finding| codes.contains(&finding.note.code()));
    let mut found = Vec::new();
    for set_up in &operation.set_ups {
        let wanted = [&set_up.set_up.outer, &set_up.set_up.inner].into_iter().flatten().count();
        if set_up.sides.len() < wanted && !says(&OF_A_SIDE) {
            found.push(format!("set-up {} lacks a side", set_up.set_up.number));
        }
    }
    for (set_up, side, zone) in operation.zones() {
        let cleared = !zone.works.is_empty() && zone.works.iter().all(|work| work.transition().is_some());
        let number = zone.zone.number.to_string();
        let named = operation.findings.iter().any(|finding| {
            let note = &finding.note;
            NAMED.contains(&note.code()) && note.figure_text("zone").as_ref() == Some(&number)
        });
        if !cleared && !named && !says(&OF_THE_PART) {
            let refused: Vec<_> = zone
                .works
                .iter()
                .flat_map(|work| &work.refused)
                .map(|one| format!("{}: {:?}", one.scheme.name(), one.why))
                .collect();
            found.push(format!("set-up {} {:?} zone {number}: {refused:?}", set_up.set_up.number, side.side));
        }
    }
    found
}

/// A finishing pass takes off what lies on the surfaces that it finishes, not what lies on others of its side: the face of
/// the pull rod, here with a cone in place of its shoulder, has more than its neck.
#[test]
fn a_pass_is_as_deep_as_what_it_finishes() {
    let path = format!("{}/examples/turned-neck.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let short = text.replace("{face: 40}", "{cone: {d: 40, z: -75}}");
    assert_ne!(short, text);
    let operation = planned(&read_turned("part", &short, &KNOWLEDGE).unwrap());
    let mut of_a_hollow = 0;
    for set_up in &operation.set_ups {
        let layers = |side: Side| set_up.sides.iter().filter(move |one| one.side == side).map(|one| &one.layers);
        for job in set_up.jobs.iter().filter(|job| job.work == technolog::turning::jobs::Work::Finish) {
            let known = layers(job.side).flat_map(|layers| &layers.allowances);
            let own = known.clone().filter(|one| job.surfaces.contains(&one.surface));
            let most = own.filter_map(|one| one.allowance_mm).max();
            let (Some(most), Some(conditions)) = (most, &job.conditions) else { continue };
            assert_eq!(conditions.depth_mm, most.rounded_up(), "{:?}", job.surfaces);
            let greatest = known.filter_map(|one| one.allowance_mm).max();
            of_a_hollow += usize::from(greatest > Some(most));
        }
    }
    assert!(of_a_hollow > 0, "the part shows the difference");
}

/// What of an operation would spoil the part or cut at rapid; and why it could not be proven.
fn spoilt(operation: &Operation) -> Vec<String> {
    const SPOILS: [&str; 6] =
        ["swept-gouge", "swept-rapid", "swept-holder", "swept-struck", "swept-off-axis", "turning-not-proven"];
    of_codes(operation, &SPOILS)
}

/// What stands over a surface that a job has finished, thicker than rounding of the thinnest shafts makes it.
fn unfinished(operation: &Operation) -> Vec<String> {
    const ROUNDING_MM: f64 = 0.02;
    let thick = |finding: &&technolog::note::Finding| {
        let thickness = finding.note.figure_text("thickness").and_then(|text| text.parse::<f64>().ok());
        finding.note.code() == "swept-stands" && thickness.is_none_or(|thickness| thickness > ROUNDING_MM)
    };
    operation.findings.iter().filter(thick).map(|finding| format!("{:?}", finding.note)).collect()
}

/// Set-ups that remove another volume than what lies over the part, though nothing is cut too deep and nothing is left but
/// in corners. A nose r leaves r²·(cot θ/2 − (π − θ)/2) in a corner of θ, 0.21 r² in a right one and 0.7 r² in one of 60°.
fn unequal(operation: &Operation) -> Vec<String> {
    use std::f64::consts::PI;
    const FARTHEST: f64 = 100.0;
    let mut found = Vec::new();
    for (index, proven) in operation.proven.iter().enumerate() {
        let Ok(proof) = &proven.proof else { continue };
        // Before the last set-up outside and bore may end at different lengths, and nothing is said of what lies between.
        if index + 1 < operation.proven.len() && operation.workpiece.inner.is_some() {
            continue;
        }
        let (removed, wanted) = (proof.volumes.removed.0, proof.volumes.to_remove.0);
        if !proof.faults.iter().all(Fault::is_mild) {
            continue;
        }
        let corners = proof.faults.iter().filter_map(|fault| match fault {
            Fault { what: What::Corner { radius, .. }, at: Some(at), count: 1, .. } => {
                Some(0.7 * radius.0 * radius.0 * 2.0 * PI * at.radius.0)
            }
            Fault { what: What::Corner { radius, .. }, count, .. } => {
                Some(0.7 * radius.0 * radius.0 * 2.0 * PI * FARTHEST * f64::from(u32::try_from(*count).unwrap()))
            }
            _ => None,
        });
        let (left, rounding) = (corners.sum::<f64>(), wanted * 0.001 + 0.1);
        if removed > wanted + rounding || removed < wanted - left - rounding {
            found.push(format!("set-up {}: {removed} mm³ of {wanted}, {:?}", proven.set_up, proof.faults));
        }
    }
    found
}

fn of_codes(operation: &Operation, codes: &[&str]) -> Vec<String> {
    let found = operation.findings.iter().filter(|finding| codes.contains(&finding.note.code()));
    found.map(|finding| format!("{:?}", finding.note)).collect()
}

#[test]
fn the_examples_are_worked_off_whole() {
    let mut wrong = String::new();
    for name in [
        "turned-ball",
        "turned-bushing",
        "turned-forging",
        "turned-pin",
        "turned-stepped",
        "turned-sleeve",
        "turned-disc",
        "turned-cone",
        "turned-neck",
        "turned-nose",
        "turned-slender",
        "turned-dowel",
        "shaft",
        "shaft-six-steps",
        "shaft-three-cylinders",
        "shaft-forging",
    ] {
        let operation = planned(&example(name));
        let (faults, silent) = (spoilt(&operation), silent(&operation));
        if !faults.is_empty() || !silent.is_empty() {
            wrong.push_str(&format!("{name}:\n{}\n{}\n", faults.join("\n"), silent.join("\n")));
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// By hand, a bar of Ø30 and 0.4 to finish on the radius. Over a head of Ø29 stand 15 − 14.9 = 0.1 mm, no pass worth going: the
/// pin of Ø20 and the head are one work, 15 − 10.4 = 4.6 in three passes of 1.5335. Over a head of Ø27 stand 1.1: they go
/// first, over everything, and the pin's other 13.9 − 10.4 = 3.5 are two passes of 1.75.
#[test]
fn no_pass_is_a_sliver() {
    let depths = |head: u32| {
        let text = format!(
            "shaft: P\nmaterial: steel-45\nblank: {{kind: bar, diameter: 30, length: 120, face: 1}}\nmachine: 16k20f3\n\
             roughing: {{limiting_depth: 2}}\nallowances: {{method: stated, on_diameter: 0.8, on_face: 0.4}}\nouter:\n  \
             - {{from: {{d: 0, z: 0}}}}\n  - {{face: 20}}\n  - {{cylinder: -30}}\n  - {{face: {head}}}\n  - {{cylinder: -50}}\n"
        );
        let operation = planned(&read_turned("part", &text, &KNOWLEDGE).unwrap());
        let (_, _, along) = operation.zones().nth(1).unwrap();
        along.works.iter().map(|work| work.levels.depth.to_mm()).collect::<Vec<_>>()
    };
    assert_eq!(depths(29), [1.5335]);
    assert_eq!(depths(27), [1.1, 1.75]);
}

/// The files in `tests/operations`: parts that once broke a law, each with what went wrong.
#[test]
fn what_once_went_wrong_goes_right() {
    let mut wrong = String::new();
    let mut paths: Vec<_> =
        std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/operations")).unwrap().collect();
    paths.sort_by_key(|path| path.as_ref().unwrap().path());
    assert!(!paths.is_empty());
    for path in paths {
        let path = path.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        let workpiece =
            read_turned("part", &text, &KNOWLEDGE).unwrap_or_else(|mistakes| panic!("{path:?} {mistakes:?}"));
        let operation = planned(&workpiece);
        let mut report = vec![spoilt(&operation).join("\n"), silent(&operation).join("\n")];
        report.retain(|one| !one.is_empty());
        if operation.zones().any(|(_, _, zone)| zone.works.is_empty()) {
            let grave = operation.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
            report.push(format!("not planned whole: {:?}", grave.map(|one| one.note.code()).collect::<Vec<_>>()));
        }
        if !report.is_empty() {
            wrong.push_str(&format!("{}: {}\n", path.file_name().unwrap().display(), report.join("\n")));
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// The files in `tests/turned-whole`: ordinary parts of which something once stood, or that were refused, each with what it was.
#[test]
fn what_was_once_left_is_made() {
    let mut wrong = String::new();
    let mut count = 0;
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/turned-whole")).unwrap() {
        let path = entry.unwrap().path();
        let operation = planned(&read_turned("part", &std::fs::read_to_string(&path).unwrap(), &KNOWLEDGE).unwrap());
        // Depths that some files state are more than their jaws hold: told, and no matter here.
        let of_jaws = ["grip-too-weak", "grip-tips", "jaws-crush"];
        let grave = operation.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
        for finding in grave.filter(|finding| !of_jaws.contains(&finding.note.code())) {
            wrong.push_str(&format!("{}: {:?}\n", path.file_name().unwrap().display(), finding.note));
        }
        count += 1;
    }
    assert!(count > 0 && wrong.is_empty(), "{wrong}");
}

/// The files in `tests/turned-safe`: parts of which the proof rejected each plan. Every program is safe, and what is left is told.
#[test]
fn what_is_unsafe_is_left_out() {
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/turned-safe")).unwrap() {
        let path = entry.unwrap().path();
        let operation = planned(&read_turned("part", &std::fs::read_to_string(&path).unwrap(), &KNOWLEDGE).unwrap());
        let (spoilt, silent) = (spoilt(&operation), silent(&operation));
        assert!(spoilt.is_empty() && silent.is_empty(), "{}: {spoilt:?} {silent:?}", path.display());
        let said = |code: &str| operation.findings.iter().any(|finding| finding.note.code() == code);
        assert!(operation.has_errors() && said("surface-not-finished"), "{}", path.display());
        for written in programs(&operation, "linuxcnc", Form::Motions, None, &KNOWLEDGE).unwrap() {
            let why = written.files.err().map(|why| why.note().code().to_owned());
            assert_ne!(why.as_deref(), Some("lathe-unsafe"), "{} {}", path.display(), written.set_up);
        }
    }
}

/// The files in `tests/turned-nasty`: parts that tempt a planner. The first line of each says which findings of severity wrong or error
/// it has, none where it is made whole. No program cuts into the part or strikes anything, and of a
/// part that is made whole no zone is left without a word.
#[test]
fn nasty_parts_are_made_or_told() {
    let mut wrong = String::new();
    let mut count = 0;
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/turned-nasty")).unwrap() {
        let path = entry.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        let expected: Vec<&str> =
            text.lines().next().unwrap().trim_start_matches("# wrong:").split(',').map(str::trim).collect();
        let operation = planned(&read_turned("part", &text, &KNOWLEDGE).unwrap());
        let grave = operation.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
        let mut codes: Vec<&str> = grave.map(|finding| finding.note.code()).collect();
        codes.sort_unstable();
        codes.dedup();
        let expected: Vec<&str> = expected.into_iter().filter(|code| !code.is_empty()).collect();
        let mut report = spoilt(&operation);
        if expected.is_empty() {
            report.extend(silent(&operation));
        }
        if codes != expected || !report.is_empty() {
            wrong.push_str(&format!("{}: {codes:?} {report:?}\n", path.file_name().unwrap().display()));
        }
        count += 1;
    }
    assert!(count >= 20 && wrong.is_empty(), "{wrong}");
}

/// Between which Z a blank stands over its rough contour by more than rounding, every 0.01 mm.
fn stands(work: &Work) -> Option<(Half, Half)> {
    let over = |z: Half| {
        let (rough, blank) = (work.stock.rough.radii_at(z)?, work.stock.blank.radii_at(z)?);
        let thick = match work.stock.rough.side {
            Side::Outer => blank.1 - rough.0,
            Side::Inner => rough.1 - blank.0,
        };
        (thick > Half::from(0.002)).then_some(z)
    };
    let places = (work.stock.from.halves()..=work.stock.to.halves()).step_by(20).map(Half::new);
    let found: Vec<Half> = places.filter_map(over).collect();
    found.first().copied().zip(found.last().copied())
}

#[test]
fn no_pass_goes_where_nothing_stands() {
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/operations")).unwrap() {
        let path = entry.unwrap().path();
        let operation = planned(&read_turned("part", &std::fs::read_to_string(&path).unwrap(), &KNOWLEDGE).unwrap());
        for work in operation.zones().flat_map(|(_, _, zone)| &zone.works) {
            let (from, to) = stands(work).unwrap();
            // What begins before the metal, runs over its end or has a wide edge.
            let room = work.pace.approach_mm + work.pace.retract_mm + work.levels.depth;
            for transition in &work.transitions {
                for (piece, _) in transition.path.pieces().filter(|(_, purpose)| *purpose != Purpose::Rapid) {
                    let beyond = [piece.from.z, piece.to.z].iter().any(|z| *z < from - room || to + room < *z);
                    assert!(!beyond, "{} {} {piece:?}: stock {from}..{to}", path.display(), transition.scheme.name());
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(technolog_laws::cases!(30))]

    #[test]
    fn any_part_comes_to_an_operation(draft in turned::drafts()) {
        let text = draft.text();
        let read = read_turned("part", &text, &KNOWLEDGE);
        prop_assume!(read.is_ok());
        let operation = planned(&read.unwrap());
        let silent = silent(&operation);
        prop_assert!(silent.is_empty(), "{}", silent.join("\n"));
        // What would spoil the part is told, and no program of that set-up is written.
        let written = programs(&operation, "linuxcnc", Form::Motions, Some(RevsPerMinute(500.0)), &KNOWLEDGE).unwrap();
        let refused = written.iter().any(|one| one.files.is_err());
        prop_assert!(spoilt(&operation).is_empty() || refused);
        let unequal = unequal(&operation);
        prop_assert!(unequal.is_empty(), "{}", unequal.join("\n"));
    }

    /// The short form, whose diameters are those after roughing.
    #[test]
    fn any_stepped_shaft_is_worked_off_whole(shaft in shafts::shafts(40)) {
        // No nose reaches a step that is smaller than it.
        let least = technolog::units::Micrometres::from_mm(2);
        prop_assume!(shaft.steps.iter().all(|step| step.length >= least));
        let radii: Vec<_> = shaft.steps.iter().map(|step| step.diameter).collect();
        prop_assume!(radii.windows(2).all(|two| two[1] - two[0] >= least + least));
        let operation = planned(&shafts::workpiece(&shaft));
        prop_assert!(silent(&operation).is_empty());
        let faults = [spoilt(&operation), unfinished(&operation)].concat();
        prop_assert!(faults.is_empty(), "{:?}\n{}", shaft, faults.join("\n"));
    }

    /// Nothing of a plan depends on what is not in the file.
    #[test]
    fn the_same_part_gives_the_same_operation(draft in turned::drafts()) {
        let plan = || {
            let workpiece = read_turned("part", &draft.text(), &KNOWLEDGE).unwrap();
            serde_json::to_string(&planned(&workpiece)).unwrap()
        };
        prop_assert_eq!(plan(), plan());
    }

    /// Every control and both forms: a file, or a reason. Motions are read back as what the toolpaths are; a cycle makes
    /// passes of its own, and where these would spoil something its program is not given out.
    #[test]
    fn every_part_has_programs_or_reasons(draft in turned::drafts(), rpm in prop::option::of(20.0_f64..3000.0)) {
        let operation = planned(&read_turned("part", &draft.text(), &KNOWLEDGE).unwrap());
        for control in ["linuxcnc", "fanuc", "sinumerik", "nc-201"] {
            for form in [Form::Motions, Form::Cycles] {
                let written = programs(&operation, control, form, rpm.map(RevsPerMinute), &KNOWLEDGE).unwrap();
                for one in &written {
                    let Ok(files) = &one.files else { continue };
                    let why = read_back(&operation, one.set_up, control, files, &KNOWLEDGE).unwrap();
                    // A spindle that is asked for may be too fast for the lathe or its tools.
                    let is_of_speed = why.as_ref().is_some_and(|why| match why.figure("why") {
                        Some(Figure::Note(why)) => why.code().starts_with("lathe-") || why.code() == "turned-speed",
                        _ => false,
                    });
                    let is_own = form == Form::Cycles || (rpm.is_some() && is_of_speed);
                    prop_assert!(is_own || why.is_none(), "{} {}: {:?}\n{}", control, one.set_up, why, draft.text());
                }
                // What is wrong with the part is wrong in the check of each of its programs, and nothing else is.
                for one in written.iter().filter(|_| form == Form::Motions && rpm.is_none()) {
                    let Ok([main]) = one.files.as_deref() else { continue };
                    let Some(reader) = reader(control, &KNOWLEDGE).unwrap() else { continue };
                    let run = read(&main.text, &LatheLanguage::read(reader, &KNOWLEDGE).unwrap(), &[]);
                    let faults = compare_with_part(&operation, one.set_up, &main.text, &run, &KNOWLEDGE).unwrap();
                    let serious: Vec<_> = faults.iter().filter(|fault| is_serious(fault)).collect();
                    let told = (control, one.set_up, &serious, &operation.findings);
                    prop_assert_eq!(operation.has_errors(), !serious.is_empty(), "{:?}\n{}", told, draft.text());
                }
                let worked = operation.set_ups.iter().filter(|set_up| !set_up.jobs.is_empty());
                let numbers: Vec<u8> = worked.map(|set_up| set_up.set_up.number).collect();
                prop_assert_eq!(written.iter().map(|one| one.set_up).collect::<Vec<_>>(), numbers);
                for file in written.iter().flat_map(|one| one.files.iter().flatten()) {
                    prop_assert!(!file.text.is_empty() && !file.name.is_empty());
                }
            }
        }
    }
}

/// So many random parts, always the same for a seed.
fn parts(count: usize, seed: u8) -> Vec<String> {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[seed; 32]);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    (0..count).map(|_| turned::drafts().new_tree(&mut runner).unwrap().current().text()).collect()
}

fn variable(name: &str, otherwise: usize) -> usize {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(otherwise)
}

/// The programs of random parts, one JSON object on a line, for the interpreter of LinuxCNC:
/// `CASES=100 OUT=/tmp/parts.jsonl cargo test --test turning operation::programs_for_rs274 -- --ignored`, then
/// `python3 tests/oracles/lathe.py /tmp/parts.jsonl`. Each set-up is written twice, as single moves and with cycles; `threads`
/// is where the passes of its threads begin.
#[test]
#[ignore = "for the comparison with rs274: OUT says where to write"]
fn programs_for_rs274() {
    let Ok(out) = std::env::var("OUT") else { return };
    let rpm = RevsPerMinute(500.0);
    let mut lines = String::new();
    for (number, text) in parts(variable("CASES", 100), u8::try_from(variable("SEED", 1)).unwrap()).iter().enumerate() {
        let Ok(workpiece) = read_turned("part", text, &KNOWLEDGE) else { continue };
        let operation = planned(&workpiece);
        let of_form = |form| programs(&operation, "linuxcnc", form, Some(rpm), &KNOWLEDGE).unwrap();
        for written in [Form::Motions, Form::Cycles].into_iter().flat_map(of_form) {
            let name = format!("part {number} set-up {}", written.set_up);
            let line = match written.files {
                Ok(files) => {
                    let program = files.iter().map(|file| file.text.as_str()).collect::<String>();
                    // The cycle makes its passes by equal areas, single moves by the depths of makers.
                    let threads = if program.contains("G76") {
                        super::threads::by_areas(&operation, written.set_up)
                    } else {
                        super::threads::of_path(&operation, written.set_up)
                    };
                    json!({"name": name, "kind": "whole", "program": program, "threads": threads, "part": text})
                }
                Err(refused) => json!({"name": name, "refused": format!("{refused:?}"), "part": text}),
            };
            lines.push_str(&format!("{line}\n"));
        }
    }
    std::fs::write(out, lines).unwrap();
}

/// How random parts fare, for reports: `CASES=200 cargo test --test turning operation::survey -- --ignored --nocapture`.
#[test]
#[ignore = "prints a survey: CASES says of how many parts"]
fn survey() {
    if std::env::var_os("CASES").is_none() {
        return;
    }
    use std::collections::BTreeMap;
    let mut seen: BTreeMap<String, (usize, String)> = BTreeMap::new();
    let mut list = String::new();
    let mut note = |what: String, text: &str| {
        let entry = seen.entry(what).or_insert_with(|| (0, text.to_owned()));
        entry.0 += 1;
        if text.len() < entry.1.len() {
            text.clone_into(&mut entry.1);
        }
    };
    for text in parts(variable("CASES", 200), u8::try_from(variable("SEED", 1)).unwrap()) {
        if std::env::var("ONLY").is_ok_and(|only| !text.contains(&only)) {
            continue;
        }
        match read_turned("part", &text, &KNOWLEDGE) {
            Err(mistakes) => {
                for mistake in mistakes {
                    note(format!("refused {}", mistake.code()), &text);
                }
            }
            Ok(workpiece) => {
                let made = std::panic::catch_unwind(|| {
                    let operation = planned(&workpiece);
                    let faults = spoilt(&operation);
                    let silent = silent(&operation);
                    let grave = operation.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
                    let told: Vec<String> = grave.clone().map(|finding| format!("{:?}", finding.note)).collect();
                    let grave: Vec<String> = grave.map(|finding| finding.note.code().to_owned()).collect();
                    let mut refused = Vec::new();
                    for form in [Form::Motions, Form::Cycles] {
                        let rpm = operation.workpiece.machine.is_none().then_some(RevsPerMinute(500.0));
                        for one in programs(&operation, "linuxcnc", form, rpm, &KNOWLEDGE).unwrap() {
                            refused.extend(one.files.err().map(|why| format!("{form:?} {why:?}")));
                        }
                    }
                    let removed = super::volumes::removed(&operation).map(|one| (one.wanted, one.left, one.corners));
                    let more = json!({"told": told, "refused": refused, "removed": removed, "silent": silent});
                    (faults, silent, grave, more)
                });
                match made {
                    Err(_) => note("PANIC".to_owned(), &text),
                    Ok((faults, silent, grave, more)) => {
                        note("read".to_owned(), &text);
                        let line = json!({"part": text, "faults": faults, "grave": grave, "more": more});
                        list.push_str(&format!("{line}\n"));
                        // A part that nothing holds, or that no lathe is named for, is told; what else is told of it counts for little.
                        let told = ["set-up-not-held", "job-needs-lathe"];
                        if faults.is_empty() && grave.iter().any(|one| told.contains(&one.as_str())) {
                            note("read, not held or without a lathe".to_owned(), &text);
                            continue;
                        }
                        if grave.is_empty() {
                            note("read, whole".to_owned(), &text);
                        }
                        for fault in &faults {
                            let kind = fault.split([':', '{', '(']).nth(1).unwrap_or_default().trim().to_owned();
                            note(format!("FAULT {kind}"), &format!("# {fault}\n{text}"));
                        }
                        for one in silent {
                            note("SILENT".to_owned(), &format!("# {one}\n{text}"));
                        }
                        for one in grave {
                            note(format!("finding {one}"), &text);
                        }
                    }
                }
            }
        }
    }
    if let Ok(out) = std::env::var("OUT") {
        std::fs::write(out, list).unwrap();
    }
    for (what, (count, text)) in &seen {
        println!("{count:5} {what}");
        if !what.starts_with("read") && (!what.starts_with("finding") || std::env::var("ALL").is_ok()) {
            println!("{text}\n");
        }
    }
}

/// Prints what becomes of a file: `FILE=part.yaml cargo test --test turning operation::trace -- --ignored --nocapture`.
#[test]
#[ignore = "prints what becomes of a file: FILE says of which"]
fn trace() {
    let Ok(path) = std::env::var("FILE") else { return };
    let text = std::fs::read_to_string(path).unwrap();
    let operation = planned(&read_turned("part", &text, &KNOWLEDGE).unwrap_or_else(|mistakes| panic!("{mistakes:?}")));
    let corners = |contour: &technolog::turning::contour::Contour| {
        let shown = contour.corners().iter().map(|at| format!("({} {})", at.radius, at.z)).collect::<Vec<_>>();
        shown.join(" ")
    };
    for set_up in &operation.set_ups {
        println!("set-up {} over {} faces {}", set_up.set_up.number, set_up.set_up.turned_over, set_up.set_up.faces);
        for side in &set_up.sides {
            println!(
                " {:?}\n  blank {}\n  rough {}\n  main {}\n  part {}",
                side.side,
                corners(&side.layers.blank),
                corners(&side.layers.rough),
                corners(&side.layers.main),
                corners(&side.layers.part)
            );
            println!(
                "  {:?}",
                side.layers.allowances.iter().map(|one| (&one.surface, one.allowance_mm)).collect::<Vec<_>>()
            );
            for zone in &side.zones {
                let one = &zone.zone;
                println!(
                    "  zone {} {:?} {:?} {}..{} {} {:?}",
                    one.number,
                    one.feed,
                    one.kind,
                    one.from_z,
                    one.to_z,
                    one.scheme.parts_worked.name(),
                    one.parts
                        .iter()
                        .map(|part| format!("{:?} {}..{}", part.kind, part.from_z, part.to_z))
                        .collect::<Vec<_>>()
                );
                for work in &zone.works {
                    println!(
                        "   work {:?} t_p {}\n    blank {}\n    rough {}",
                        work.taken,
                        work.levels.depth,
                        corners(&work.stock.blank),
                        corners(&work.stock.rough)
                    );
                    for refused in &work.refused {
                        println!("    refused {} {:?}", refused.scheme.name(), refused.why);
                    }
                    if let Some(transition) = work.transition() {
                        print!("    way ({} {})", transition.path.from.radius, transition.path.from.z);
                        for one in &transition.path.moves {
                            print!(" {:?}({} {})", one.purpose, one.to.radius, one.to.z);
                        }
                        println!();
                    }
                }
            }
        }
    }
    for (set_up, proven) in operation.set_ups.iter().zip(&operation.proven) {
        let jobs = set_up.jobs.iter();
        let moves: Vec<String> = jobs
            .flat_map(|job| {
                job.path.pieces().map(move |one| format!("{:?} {}: {one:?}", job.work, job.tool.designation))
            })
            .collect();
        for fault in proven.proof.iter().flat_map(|proof| &proof.faults) {
            if let Some(at) = fault.block.and_then(|block| moves.get(block.0 - 1)) {
                println!("fault {} in {at}", fault.code());
            }
        }
    }
    for finding in &operation.findings {
        println!("{:?} {:?}", finding.severity, finding.note);
    }
    println!("{}\n{}", spoilt(&operation).join("\n"), silent(&operation).join("\n"));
}
