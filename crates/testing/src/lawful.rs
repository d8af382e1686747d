//! What holds for every plan, whatever the part.

use std::collections::{BTreeMap, BTreeSet};

use proptest::prelude::*;
use technolog::knowledge::Value;
use technolog::machine::Machine;
use technolog::note::Severity;
use technolog::part::{Hole, Part};
use technolog::plan::{Feature, HolePlan, Operation, Plan, Transition};
use technolog::units::Micrometres;

use super::KNOWLEDGE;

/// Whether a table has a row of that designation, in whichever of its columns.
pub fn designated(table: &str, designation: &str) -> bool {
    let Ok(table) = KNOWLEDGE.table(table) else { return false };
    let columns: Vec<&str> = table
        .columns
        .iter()
        .map(|column| column.name.as_str())
        .filter(|name| name.starts_with("designation"))
        .collect();
    let has_designation =
        |column: &str| table.all_rows().any(|row| row.value(column).and_then(Value::as_text) == Some(designation));
    columns.iter().any(|column| has_designation(column))
}

/// Each step of the main cylinder begins with what the one before left; the first begins in solid metal, the
/// last leaves the hole. Chamfers stand between them.
pub fn chain(hole: &Hole, plan: &HolePlan) -> Result<(), TestCaseError> {
    let mut before = Micrometres::ZERO;
    for (number, step) in plan.transitions.iter().enumerate().filter(|(_, step)| step.feature == Feature::Bore) {
        if step.operation == Operation::CentreDrill {
            prop_assert_eq!(number, 0, "centring comes first");
            prop_assert!(step.diameter_mm > Micrometres::ZERO);
            continue;
        }
        prop_assert_eq!(step.from_diameter_mm, before, "{:?}", step.operation);
        if step.operation == Operation::Mill && step.diameter_mm == before && !hole.through {
            // A free floor may be levelled, too.
            continue;
        }
        prop_assert!(step.diameter_mm > before, "{:?} does not open the hole", step.operation);
        if before == Micrometres::ZERO {
            prop_assert_eq!(step.operation, Operation::Drill);
        }
        before = step.diameter_mm;
    }
    let elsewhere = plan.route.as_ref().is_some_and(|route| route.finish_elsewhere);
    prop_assert!(before <= hole.diameter.largest(), "{} ends at {before}", hole.diameter);
    prop_assert!(elsewhere || before >= hole.diameter.smallest(), "{} ends at {before}", hole.diameter);
    Ok(())
}

/// Tools of the catalogs, conditions that are numbers and that the machine bears.
pub fn sound(step: &Transition, plan: &Plan, machine: &Machine<'_>) -> Result<(), TestCaseError> {
    let step_text = format!("{:?} of {}", step.operation, step.diameter_mm);
    if step.operation.is_only_elsewhere() {
        prop_assert!(step.elsewhere && step.tool.designation.is_empty(), "{step_text}: {:?}", step.tool);
        return Ok(());
    }
    prop_assert!(designated(&step.tool.table, &step.tool.designation), "{step_text}: no {:?}", step.tool);
    prop_assert!(designated(&step.holder.table, &step.holder.designation), "{step_text}: no {:?}", step.holder);
    // What is done on another machine is in no magazine of this one.
    let tool = plan.tools.iter().find(|tool| tool.number == step.tool.number);
    let has = |tool: &technolog::plan::ToolPlan| tool.designation == step.tool.designation;
    prop_assert!(step.elsewhere || tool.is_some_and(has), "{step_text}");
    prop_assert!(step.passes >= 1 && step.travel_mm > Micrometres::ZERO, "{step_text}");
    let conditions = &step.conditions;
    for figure in [
        conditions.depth_of_cut_mm,
        conditions.feed_mm_per_rev.0,
        conditions.speed_m_per_min.0,
        conditions.feed_mm_per_min.0,
        conditions.machine_time_min.0,
        conditions.tool_life_min.0,
        conditions.computed_speed_m_per_min.0,
    ] {
        prop_assert!(figure.is_finite() && figure > 0.0, "{step_text}: {conditions:?}");
    }
    prop_assert!(machine.spindle_steps.contains(&conditions.spindle_rpm), "{step_text}: {:?}", conditions.spindle_rpm);
    // Half of the last printed place above the limit.
    // A small reamer's power may round to nothing.
    let within = |value: Option<f64>, limit: f64, place: f64| value.is_none_or(|it| it >= 0.0 && it <= limit + place);
    prop_assert!(within(Some(conditions.feed_mm_per_min.0), machine.feed_max.0, 0.05), "{step_text}: {conditions:?}");
    prop_assert!(
        within(conditions.axial_force_n.map(|force| force.0), machine.thrust.0, 0.5),
        "{step_text}: {conditions:?}"
    );
    prop_assert!(
        within(conditions.torque_n_m.map(|torque| torque.0), machine.spindle_torque.0, 0.005),
        "{step_text}: {conditions:?}"
    );
    prop_assert!(
        within(conditions.power_kw.map(|power| power.0), machine.spindle_power.0, 0.005),
        "{step_text}: {conditions:?}"
    );
    Ok(())
}

/// Every point gets every transition of its group once, and in their order.
pub fn visited(part: &Part, plan: &Plan) -> Result<(), TestCaseError> {
    let mut done: BTreeMap<(&str, _), Vec<usize>> = BTreeMap::new();
    for visit in &plan.sequence {
        for stop in &visit.stops {
            done.entry((&stop.hole, stop.at)).or_default().push(stop.transition);
        }
    }
    for (hole, own) in part.holes.iter().zip(&plan.holes) {
        for point in &hole.at {
            let stops = done.remove(&(hole.name.as_str(), *point)).unwrap_or_default();
            let here = own.transitions.iter().enumerate().filter(|(_, step)| !step.elsewhere);
            prop_assert_eq!(stops, here.map(|(at, _)| at).collect::<Vec<_>>(), "{} {:?}", hole.name, point);
        }
    }
    prop_assert!(done.is_empty(), "{done:?}");
    Ok(())
}

/// All of it for a whole plan.
pub fn lawful(part: &Part, plan: &Plan) -> Result<(), TestCaseError> {
    let machine = Machine::find(&KNOWLEDGE, &part.machine).unwrap();
    prop_assert_eq!(plan.holes.len(), part.holes.len());
    for (hole, own) in part.holes.iter().zip(&plan.holes) {
        prop_assert_eq!(&hole.name, &own.name);
        prop_assert_eq!(own.route.is_some(), !own.transitions.is_empty(), "{}", own.name);
        if own.route.is_none() {
            let is_reported = plan.findings.iter().any(|finding| {
                finding.severity == Severity::Error && finding.hole.as_deref() == Some(own.name.as_str())
            });
            prop_assert!(is_reported, "{} is not planned, and nobody says why", own.name);
            continue;
        }
        chain(hole, own)?;
        for step in &own.transitions {
            sound(step, plan, &machine)?;
        }
    }
    let numbers: BTreeSet<u32> = plan.tools.iter().map(|tool| tool.number).collect();
    prop_assert_eq!(numbers.len(), plan.tools.len());
    let longest = plan.tools.iter().map(|tool| tool.length_mm).max().unwrap_or_default();
    for tool in &plan.tools {
        prop_assert_eq!(tool.correction_mm, tool.length_mm - longest);
        prop_assert!(tool.length_mm <= machine.overhang_max, "{tool:?}");
    }
    visited(part, plan)
}
