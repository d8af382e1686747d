//! What the audit finds in a plan of ours with one thing changed: a report of the share found by kind of change.
//!
//! A plan made by `technolog plan` audits clean (tests/audit.rs), so whatever is said of a changed one is said of the change.

#![allow(clippy::unwrap_used, reason = "clippy allows it in tests, but not in the functions they share")]

mod common;

use std::collections::BTreeMap;

use serde_json::Value;
use technolog::audit::{audit_beside, read_plan};
use technolog::knowledge::Value as Cell;
use technolog::note::Severity;
use technolog::plan::CuttingMethod;

use common::{KNOWLEDGE, planned, read};

/// A change: its kind, what was changed, and the plan with it.
struct Mutant {
    kind: &'static str,
    what: String,
    text: String,
    /// The line that differs, from 1; absent where lines were moved.
    line: Option<usize>,
}

/// What does not belong to the plan itself: its part, its reasons, what it was weighed against.
const OUTSIDE: [&str; 7] = ["part", "because", "alternatives", "findings", "visiting", "cutting", "route"];

fn numbers(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Object(map) => {
            for (key, value) in map.iter().filter(|(key, _)| !OUTSIDE.contains(&key.as_str())) {
                numbers(value, &format!("{path}/{key}"), found);
            }
        }
        Value::Array(items) => {
            for (at, item) in items.iter().enumerate() {
                numbers(item, &format!("{path}/{at}"), found);
            }
        }
        Value::Number(_) => found.push(path.to_owned()),
        Value::String(text)
            if text.parse::<f64>().is_ok() && !path.ends_with("designation") && !path.ends_with("holder") =>
        {
            found.push(path.to_owned());
        }
        _ => {}
    }
}

fn text(plan: &Value) -> String {
    serde_json::to_string_pretty(plan).unwrap()
}

fn changed(plan: &Value, kind: &'static str, path: &str, to: Value) -> Mutant {
    let before = text(plan);
    let mut plan = plan.clone();
    *plan.pointer_mut(path).unwrap() = to;
    let after = text(&plan);
    let line = before.lines().zip(after.lines()).position(|(a, b)| a != b).map(|at| at + 1);
    Mutant { kind, what: path.to_owned(), text: after, line }
}

/// A number times a factor, as it was written: whole where it was whole.
fn times(value: &Value, factor: f64) -> Option<Value> {
    let number = value.as_f64().or_else(|| value.as_str()?.parse().ok())?;
    let whole = value.is_i64() || value.is_u64();
    let new = number * factor;
    let new = if whole {
        if factor > 2.0 { new.round() } else { new.round().max(number + 1.0) }
    } else {
        (new * 1e4).round() / 1e4
    };
    if (new - number).abs() < 1e-9 {
        return None;
    }
    Some(if whole { Value::from(new as i64) } else { Value::from(new) })
}

fn mutants(plan: &Value) -> Vec<Mutant> {
    let mut mutants = Vec::new();
    let mut paths = Vec::new();
    numbers(plan, "", &mut paths);
    for path in &paths {
        let value = plan.pointer(path).unwrap();
        for (kind, factor) in [("figure + 15 %", 1.15), ("comma moved right", 10.0), ("comma moved left", 0.1)] {
            if let Some(new) = times(value, factor) {
                mutants.push(changed(plan, kind, path, new));
            }
        }
    }
    let tools = plan["tools"].as_array().unwrap();
    for (at, tool) in tools.iter().enumerate() {
        for (key, table) in [("designation", "table"), ("holder", "holder_table")] {
            let own = tool[key].as_str().unwrap();
            let table = KNOWLEDGE.table(tool[table].as_str().unwrap()).unwrap();
            let other = table
                .all_rows()
                .filter_map(|row| row.value("designation").and_then(Cell::as_text))
                .find(|name| *name != own);
            if let Some(other) = other {
                mutants.push(changed(plan, "designation replaced", &format!("/tools/{at}/{key}"), Value::from(other)));
            }
            mutants.push(changed(
                plan,
                "designation misprinted",
                &format!("/tools/{at}/{key}"),
                Value::from(format!("{own}9")),
            ));
        }
    }
    if !plan["clamping"].is_null() {
        let own = plan["clamping"]["screw"].as_str().unwrap();
        for screw in ["M6", "M24"].into_iter().filter(|screw| *screw != own) {
            mutants.push(changed(plan, "screw replaced", "/clamping/screw", Value::from(screw)));
        }
    }
    for (at, hole) in plan["holes"].as_array().unwrap().iter().enumerate() {
        let count = hole["transitions"].as_array().map_or(0, Vec::len);
        for one in 0..count {
            let mut dropped = plan.clone();
            dropped["holes"][at]["transitions"].as_array_mut().unwrap().remove(one);
            let what = format!("/holes/{at}/transitions/{one}");
            mutants.push(Mutant { kind: "transition dropped", what: what.clone(), text: text(&dropped), line: None });
            if one + 1 < count {
                let mut swapped = plan.clone();
                swapped["holes"][at]["transitions"].as_array_mut().unwrap().swap(one, one + 1);
                mutants.push(Mutant { kind: "transitions swapped", what, text: text(&swapped), line: None });
            }
        }
    }
    mutants
}

#[test]
fn most_changes_of_a_plan_are_found_and_named_first() {
    // Kind: made, found, found by a formula or a table and not only by our own plan, named first.
    let mut shares: BTreeMap<&str, [usize; 4]> = BTreeMap::new();
    let mut missed: BTreeMap<String, usize> = BTreeMap::new();
    let parts = ["examples/plate.yaml", "tests/parts/reamed-iron.yaml"];
    for path in parts {
        let part = read(&std::fs::read_to_string(path).unwrap());
        let ours = planned(&part, CuttingMethod::Formula);
        let plan = serde_json::to_value(&ours).unwrap();
        for mutant in mutants(&plan) {
            let share = shares.entry(mutant.kind).or_default();
            share[0] += 1;
            let none = |_: &str| Err("no files here".to_owned());
            let (found, ruled, first) = match read_plan("plan.json", &mutant.text, &KNOWLEDGE, &none) {
                // A mistake of the file is found at its place.
                Err(_) => (true, true, true),
                Ok(stated) => {
                    let audit = audit_beside(&stated, &ours, &KNOWLEDGE).unwrap();
                    let mut grave: Vec<_> =
                        audit.findings.iter().filter(|one| one.severity <= Severity::Doubtful).collect();
                    grave.sort_by_key(|one| (!one.follows_from.is_empty(), one.severity));
                    let at = |line: Option<u32>| line.map(|line| line as usize);
                    let first = grave.first().is_some_and(|one| mutant.line.is_none() || at(one.line) == mutant.line);
                    let ruled = grave.iter().any(|one| one.note.code != "audit-not-ours");
                    (!grave.is_empty(), ruled, first)
                }
            };
            share[1] += usize::from(found);
            share[2] += usize::from(ruled);
            share[3] += usize::from(found && first);
            if !found || !first {
                let field: String =
                    mutant.what.chars().map(|letter| if letter.is_ascii_digit() { '#' } else { letter }).collect();
                *missed.entry(format!("{} {field}", if found { "not first:" } else { "missed:" })).or_default() += 1;
            }
        }
    }
    let total = shares.values().fold([0; 4], |sum, one| std::array::from_fn(|at| sum[at] + one[at]));
    let line = |name: &str, [made, found, ruled, first]: [usize; 4]| {
        let share = |part: usize| 100.0 * part as f64 / made as f64;
        format!("{name:<24} {made:>5} {:>5.1} % {:>5.1} % {:>5.1} %", share(found), share(ruled), share(first))
    };
    println!("{:<24} {:>5} {:>7} {:>7} {:>7}", "kind", "made", "found", "by rule", "first");
    for (kind, share) in &shares {
        println!("{}", line(kind, *share));
    }
    println!("{}", line("all", total));
    for (what, count) in &missed {
        println!("{count:>4} {what}");
    }
    assert!(total[1] * 100 >= total[0] * 95, "less than 95 % found");
}
