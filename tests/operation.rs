//! The whole operation, worked off on paper: what a reader of its programs would see on the lathe. The way of metal is
//! reckoned by columns (`tests/common/section.rs`, `tests/common/side.rs`) that share nothing with what makes the ways.

#![allow(clippy::unwrap_used, reason = "clippy allows it in tests, but not in the functions they share")]
#![allow(clippy::panic, reason = "clippy allows it in tests, but not in the functions they share")]

use std::sync::LazyLock;

use proptest::prelude::*;
use technolog::knowledge::Knowledge;
use technolog::note::Severity;
use technolog::shipped;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::operation::{Operation, plan};
use technolog::turning::workpiece::{Turned, Workpiece, read_turned, read_workpiece};
use technolog::units::RevsPerMinute;

#[path = "common/section.rs"]
mod section;
#[path = "common/side.rs"]
mod side;
#[path = "common/turned.rs"]
mod turned;

use side::{Fault, work_off};

static KNOWLEDGE: LazyLock<Knowledge> = LazyLock::new(|| shipped::knowledge().unwrap());

fn example(name: &str) -> Workpiece {
    let path = format!("{}/examples/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    match read_turned("part", &text, &KNOWLEDGE).unwrap() {
        Turned::Contoured(workpiece) => *workpiece,
        Turned::Stepped(shaft) => Workpiece::from(&shaft),
    }
}

fn planned(workpiece: &Workpiece) -> Operation {
    plan(workpiece, &KNOWLEDGE).unwrap()
}

/// What is not cleared, with nothing that says why.
fn silent(operation: &Operation) -> Vec<String> {
    let grave = || operation.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
    let mut found = Vec::new();
    for set_up in &operation.set_ups {
        let wanted = [&set_up.set_up.outer, &set_up.set_up.inner].into_iter().flatten().count();
        if set_up.sides.len() < wanted && grave().next().is_none() {
            found.push(format!("set-up {} lacks a side", set_up.set_up.number));
        }
    }
    for (set_up, side, zone) in operation.zones() {
        let cleared = !zone.works.is_empty() && zone.works.iter().all(|work| work.transition().is_some());
        if !cleared && grave().next().is_none() {
            let refused: Vec<_> = zone
                .works
                .iter()
                .flat_map(|work| &work.refused)
                .map(|one| format!("{}: {} {:?}", one.scheme.name(), one.why.code, one.why.params))
                .collect();
            found.push(format!(
                "set-up {} {:?} zone {}: {refused:?}",
                set_up.set_up.number, side.side, zone.zone.number
            ));
        }
    }
    found
}

fn told(faults: &[Fault]) -> String {
    let line = |fault: &Fault| format!("{}: {:.4} mm at Z {:.3}, {}", fault.law, fault.by, fault.z, fault.at);
    faults.iter().map(line).collect::<Vec<_>>().join("\n")
}

#[test]
fn the_examples_are_worked_off_whole() {
    let mut wrong = String::new();
    for name in [
        "turned-ball",
        "turned-bushing",
        "turned-forging",
        "turned-pin",
        "shaft",
        "shaft-six-steps",
        "shaft-three-cylinders",
        "shaft-forging",
    ] {
        let operation = planned(&example(name));
        let (faults, silent) = (work_off(&operation), silent(&operation));
        if !faults.is_empty() || !silent.is_empty() {
            wrong.push_str(&format!("{name}:\n{}\n{}\n", told(&faults), silent.join("\n")));
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn any_part_comes_to_an_operation(draft in turned::drafts()) {
        let text = draft.text();
        let read = read_workpiece("part", &text, &KNOWLEDGE);
        prop_assume!(read.is_ok());
        let operation = planned(&read.unwrap());
        let silent = silent(&operation);
        prop_assert!(silent.is_empty(), "{}", silent.join("\n"));
        let faults = work_off(&operation);
        prop_assert!(faults.is_empty(), "{}", told(&faults));
    }
}

/// How random parts fare, for reports: `cargo test --test operation survey -- --ignored --nocapture`.
#[test]
#[ignore = "prints a survey"]
fn survey() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
    use std::collections::BTreeMap;
    let count: usize = std::env::var("CASES").ok().and_then(|text| text.parse().ok()).unwrap_or(200);
    let seed: u8 = std::env::var("SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[seed; 32]);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let mut seen: BTreeMap<String, (usize, String)> = BTreeMap::new();
    let mut note = |what: String, text: &str| {
        let entry = seen.entry(what).or_insert_with(|| (0, text.to_owned()));
        entry.0 += 1;
        if text.len() < entry.1.len() {
            text.clone_into(&mut entry.1);
        }
    };
    for _ in 0..count {
        let text = turned::drafts().new_tree(&mut runner).unwrap().current().text();
        if std::env::var("ONLY").is_ok_and(|only| !text.contains(&only)) {
            continue;
        }
        match read_workpiece("part", &text, &KNOWLEDGE) {
            Err(mistakes) => {
                for mistake in mistakes {
                    note(format!("refused {}", mistake.code()), &text);
                }
            }
            Ok(workpiece) => {
                let made = std::panic::catch_unwind(|| {
                    let operation = planned(&workpiece);
                    let faults = work_off(&operation);
                    let silent = silent(&operation);
                    let grave = operation.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
                    let grave: Vec<String> = grave.map(|finding| finding.note.code.clone()).collect();
                    for control in ["linuxcnc"] {
                        for form in [Form::Motions, Form::Cycles] {
                            programs(&operation, control, form, Some(RevsPerMinute(500.0)), &KNOWLEDGE).unwrap();
                        }
                    }
                    (faults, silent, grave)
                });
                match made {
                    Err(_) => note("PANIC".to_owned(), &text),
                    Ok((faults, silent, grave)) => {
                        note("read".to_owned(), &text);
                        let scheme = |at: &str| {
                            at.split(' ')
                                .skip(2)
                                .take(4)
                                .filter(|word| word.parse::<f64>().is_err())
                                .take(3)
                                .collect::<Vec<_>>()
                                .join(" ")
                        };
                        for fault in &faults {
                            note(
                                format!("FAULT {} {}", fault.law, scheme(&fault.at)),
                                &format!("# {}\n{text}", told(std::slice::from_ref(fault))),
                            );
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
    for (what, (count, text)) in &seen {
        println!("{count:5} {what}");
        if !what.starts_with("read") && (!what.starts_with("finding") || std::env::var("ALL").is_ok()) {
            println!("{text}\n");
        }
    }
}

/// Prints what becomes of a file: `FILE=part.yaml cargo test --test operation trace -- --ignored --nocapture`.
#[test]
#[ignore = "prints what becomes of a file"]
fn trace() {
    let Ok(path) = std::env::var("FILE") else { return };
    let text = std::fs::read_to_string(path).unwrap();
    let operation =
        planned(&read_workpiece("part", &text, &KNOWLEDGE).unwrap_or_else(|mistakes| panic!("{mistakes:?}")));
    let corners = |contour: &technolog::turning::contour::Contour| {
        let told = contour.corners().iter().map(|at| format!("({} {})", at.radius, at.z)).collect::<Vec<_>>();
        told.join(" ")
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
                    one.scheme.parts_worked,
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
                        println!("    refused {} {} {:?}", refused.scheme.name(), refused.why.code, refused.why.params);
                    }
                    if let Some(transition) = work.transition() {
                        print!("    way ({} {})", transition.way.from.radius, transition.way.from.z);
                        for one in &transition.way.moves {
                            print!(" {:?}({} {})", one.purpose, one.to.radius, one.to.z);
                        }
                        println!();
                    }
                }
            }
        }
    }
    for finding in &operation.findings {
        println!("{:?} {} {:?}", finding.severity, finding.note.code, finding.note.params);
    }
    println!("{}\n{}", told(&work_off(&operation)), silent(&operation).join("\n"));
}
