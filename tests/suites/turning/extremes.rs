//! No figure that the reader of turned parts admits stops what is made of the part: operation and programs.

use std::collections::BTreeMap;
use std::panic::catch_unwind;

use technolog::note::Severity;
use technolog::report::Lang;
use technolog::turning::operation::plan;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::workpiece::read_turned;
use technolog::units::RevsPerMinute;
use technolog_laws::share;
use technolog_testing::KNOWLEDGE;
use technolog_testing::extremes::{admitted, figures};

const PARTS: [&str; 6] =
    ["turned-ball", "turned-bushing", "turned-forging", "turned-pin", "shaft-forging", "shaft-three-cylinders"];

fn text(name: &str) -> String {
    std::fs::read_to_string(format!("{}/examples/{name}.yaml", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// What stops it.
fn fault(text: &str) -> Option<String> {
    let workpiece = read_turned("part", text, &KNOWLEDGE).ok()?;
    let operation = match plan(&workpiece, &KNOWLEDGE) {
        Ok(operation) => operation,
        Err(error) => return Some(error.to_string()),
    };
    let speed = Some(RevsPerMinute(500.0));
    programs(&operation, "linuxcnc", Form::Cycles, speed, &KNOWLEDGE).err().map(|error| format!("programs: {error}"))
}

/// Found by the law below: the way of sixteen thousand levels, each cut from within the one above, overflowed the stack.
#[test]
fn a_blank_of_a_hundred_metres_has_too_many_passes() {
    let text = text("turned-ball");
    let large = text.replacen("diameter: 45", "diameter: 100000", 1);
    assert_ne!(large, text);
    let workpiece = read_turned("part", &large, &KNOWLEDGE).unwrap();
    let findings = plan(&workpiece, &KNOWLEDGE).unwrap().findings;
    let graves: Vec<_> =
        findings.iter().filter(|one| one.severity == Severity::Error).map(|one| one.note.code()).collect();
    assert!(graves.contains(&"too-many-passes"), "{graves:?}");
    for lang in [Lang::UK, Lang::EN] {
        let finding = findings.iter().find(|one| one.note.code() == "too-many-passes").unwrap();
        assert!(lang.remedy(&finding.note).is_some());
    }
}

/// A share of the figures below.
#[test]
fn figures_that_are_admitted_come_to_an_operation() {
    come_to_an_operation(100);
}

#[test]
#[ignore = "takes long: every figure as far as it goes"]
fn every_figure_that_is_admitted_comes_to_an_operation() {
    come_to_an_operation(1);
}

fn come_to_an_operation(usual: usize) {
    let admits = |text: &str| read_turned("part", text, &KNOWLEDGE).is_ok();
    let mut all = Vec::new();
    for name in PARTS {
        let text = text(name);
        assert!(admits(&text), "{name}");
        all.extend(figures(&text).into_iter().map(|figure| (figure, text.clone())));
    }
    // By each fault, how often it came and a part that shows it.
    let mut found = BTreeMap::<String, (usize, String)>::new();
    for (figure, text) in share(all, usual, |_| ()) {
        for changed in admitted(figure, &text, admits) {
            let made = catch_unwind(|| fault(&changed)).unwrap_or_else(|_| Some("panic".to_owned()));
            if let Some(fault) = made {
                found.entry(fault).or_insert_with(|| (0, changed.clone())).0 += 1;
            }
        }
    }
    let texts: Vec<String> =
        found.iter().map(|(fault, (count, text))| format!("{count} times {fault}, as of\n{text}")).collect();
    assert!(texts.is_empty(), "{}", texts.join("\n"));
}
