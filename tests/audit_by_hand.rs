//! A plan of ours written down as people write one: what we plan by the formulas is right by the audit of plans by hand,
//! too. So the formulas, reaches and lengths that are held against such plans are those of planning.

#![allow(clippy::unwrap_used, clippy::panic, reason = "clippy allows it in tests, but not in the functions they share")]

mod common;

use std::fmt::Write;

use technolog::audit::{audit, read_plan};
use technolog::note::Severity;
use technolog::part::Part;
use technolog::plan::{CuttingMethod, Plan};

use common::{KNOWLEDGE, planned, read};

/// The plan of a part file as a file by hand: route, tools with their lengths, conditions.
fn by_hand(part_file: &str, plan: &Plan) -> String {
    let mut text = String::from("part:\n");
    for line in part_file.lines() {
        writeln!(text, "  {line}").unwrap();
    }
    text.push_str("cutting: formula\nroute:\n");
    let transitions = || plan.holes.iter().flat_map(|hole| hole.transitions.iter().map(move |one| (hole, one)));
    let elsewhere = |number: u32| number == 0;
    for (at, (hole, one)) in transitions().enumerate() {
        write!(text, "  - {{row: {}, operation: {}, hole: {}", at + 1, one.operation.name(), hole.name).unwrap();
        write!(text, ", diameter: {}, depth: {}", one.diameter_mm, one.depth_mm).unwrap();
        if one.passes > 1 {
            write!(text, ", passes: {}", one.passes).unwrap();
        }
        if !elsewhere(one.tool.number) {
            write!(text, ", tool: T{}", one.tool.number).unwrap();
        }
        text.push_str("}\n");
    }
    text.push_str("tools:\n");
    for tool in &plan.tools {
        writeln!(text, "  T{}:\n    designation: \"{}\"", tool.number, tool.designation).unwrap();
        writeln!(text, "    table: {}\n    overhang: {}", tool.table, tool.overhang_mm).unwrap();
        if tool.holder != tool.designation {
            let used = tool.length_mm - tool.overhang_mm;
            writeln!(text, "    holder: {{designation: \"{}\"}}\n    holder_used: {used}", tool.holder).unwrap();
        }
        writeln!(text, "    assembly: {}", tool.length_mm).unwrap();
    }
    text.push_str("conditions:\n");
    for (at, (_, one)) in transitions().enumerate().filter(|(_, (_, one))| one.conditions.rounds.is_none()) {
        let own = &one.conditions;
        writeln!(text, "  - for: {}\n    depth_of_cut: {}", at + 1, own.depth_of_cut_mm).unwrap();
        writeln!(text, "    feed: {}", own.feed_mm_per_rev.0).unwrap();
        // What a limit of drill or machine held back has a speed computed at a larger feed than the one it is left with.
        if own.limited_by == "cutting-speed" {
            writeln!(text, "    speed: {}", own.computed_speed_m_per_min.0).unwrap();
            writeln!(text, "    rpm: {}\n    minute_feed: {}", own.spindle_rpm.0, own.feed_mm_per_min.0).unwrap();
            writeln!(text, "    tool_life: {}", own.tool_life_min.0).unwrap();
        }
        for (key, value) in
            [("force", own.axial_force_n.map(|force| force.0)), ("torque", own.torque_n_m.map(|torque| torque.0))]
        {
            if let Some(value) = value {
                writeln!(text, "    {key}: {value}").unwrap();
            }
        }
    }
    text
}

/// What the audit has against the plan of a part, notes left aside.
fn found(part_file: &str) -> Vec<String> {
    let part: Part = read(part_file);
    let plan = planned(&part, CuttingMethod::Formula);
    let text = by_hand(part_file, &plan);
    let none = |_: &str| Err("no files here".to_owned());
    let stated = read_plan("plan.yaml", &text, &KNOWLEDGE, &none).unwrap_or_else(|why| panic!("{why:?}\n{text}"));
    let audit = audit(&stated, &KNOWLEDGE).unwrap();
    let grave = audit.findings.iter().filter(|one| one.severity < Severity::Note);
    grave.map(|one| format!("{:?} {} {} {:?} {:?}", one.severity, one.rule, one.field, one.stated, one.note)).collect()
}

#[test]
fn what_we_plan_is_right_when_it_is_written_by_hand() {
    let mut wrong = Vec::new();
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
                let said = found(&part);
                if !said.is_empty() {
                    wrong.push(format!("{material} {diameter} {depth} {through}: {}", said.join("\n    ")));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
