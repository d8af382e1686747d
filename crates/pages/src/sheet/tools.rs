//! The tools of a plan: assemblies to order and mount, and the values of the offset registers.

use crate::document::{Column, Inlines, Keep, Table};
use crate::note::Because;
use crate::plan::{Plan, ToolPlan};

use super::super::words::say;
use super::{Lang, column, heading, mark};
use crate::report::operation_noun;

/// Cutters with their holders.
pub(crate) fn tools(plan: &Plan, lang: Lang) -> Table {
    let mm = lang.word("unit-mm");
    let mut table = Table::new([
        Column::text("T"),
        Column::text(say!(lang, "plan-designation")),
        Column::text(say!(lang, "plan-table")).keep(Keep::Optional),
        Column::number("Ø", mm),
        Column::text(say!(lang, "plan-does")),
        Column::text(say!(lang, "plan-holder")),
        Column::number(heading("plan-holder-length", lang), mm).keep(Keep::Optional),
        Column::number(say!(lang, "plan-overhang"), mm).keep(Keep::Useful),
        Column::number(heading("plan-assembly", lang), mm),
    ]);
    let lengths = |of: &dyn Fn(&ToolPlan) -> _| column(&plan.tools.iter().map(of).collect::<Vec<_>>(), lang);
    let diameters = lengths(&|tool| tool.diameter_mm);
    let holders = lengths(&|tool| tool.length_mm - tool.overhang_mm);
    let overhangs = lengths(&|tool| tool.overhang_mm);
    let assemblies = lengths(&|tool| tool.length_mm);
    let figures = diameters.into_iter().zip(holders).zip(overhangs).zip(assemblies);
    for (tool, (((diameter, holder), overhang), assembly)) in plan.tools.iter().zip(figures) {
        table.row([
            Inlines::from(format!("T{}", tool.number)),
            named(tool, mark(tool.because.iter().chain(reasons(plan, tool))), lang).into(),
            tool.table.as_str().into(),
            diameter,
            work_of_tool(plan, tool, lang).into(),
            tool.holder.as_str().into(),
            holder,
            overhang,
            assembly,
        ]);
    }
    table
}

/// A tool as ordered, and the size to which it is ground where no catalog has its size.
pub(crate) fn named(tool: &ToolPlan, mark: &str, lang: Lang) -> String {
    let designation = format!("{}{mark}", tool.designation);
    match tool.ground_from_mm {
        // A new one is wider than its size by a part of the field H that it is for.
        Some(from) if from == tool.diameter_mm => {
            say!(lang, "plan-ground-exactly", designation = designation, to = tool.diameter_mm).to_owned()
        }
        Some(from) => {
            say!(lang, "plan-ground", designation = designation, from = from, to = tool.diameter_mm).to_owned()
        }
        None => match (tool.bought_for_h, tool.pilot_mm, tool.lead_pitches) {
            (Some(grade), ..) => say!(lang, "plan-bought", designation = designation, it = grade).to_owned(),
            (None, Some(pilot), _) => say!(lang, "plan-pilot", designation = designation, pilot = pilot).to_owned(),
            (None, None, Some(lead)) => {
                say!(lang, "plan-bottoming-tap", designation = designation, lead = lead).to_owned()
            }
            (None, None, None) => designation,
        },
    }
}

/// The reasons of the transitions that a tool makes.
fn reasons<'p>(plan: &'p Plan, tool: &ToolPlan) -> impl Iterator<Item = &'p Because> {
    let number = tool.number;
    let own = plan.holes.iter().flat_map(|hole| &hole.transitions).filter(move |own| own.tool.number == number);
    own.flat_map(|own| &own.because)
}

/// The work of a tool, over all holes.
fn work_of_tool(plan: &Plan, tool: &ToolPlan, lang: Lang) -> String {
    let mut names: Vec<&str> = Vec::new();
    for transition in plan.holes.iter().flat_map(|hole| &hole.transitions) {
        let name = operation_noun(transition.operation.name(), lang);
        if transition.tool.number == tool.number && !names.contains(&name) {
            names.push(name);
        }
    }
    names.join(", ")
}

/// The values of the offset registers.
pub(crate) fn corrections(plan: &Plan, lang: Lang) -> Table {
    let mm = lang.word("unit-mm");
    let mut table = Table::new([
        Column::text("T"),
        Column::text("H"),
        Column::number(heading("plan-length", lang), mm),
        Column::number(say!(lang, "plan-correction"), mm),
        Column::number(say!(lang, "plan-book-correction"), mm),
    ]);
    let lengths = |of: &dyn Fn(&ToolPlan) -> _| column(&plan.tools.iter().map(of).collect::<Vec<_>>(), lang);
    let figures = lengths(&|tool| tool.length_mm)
        .into_iter()
        .zip(lengths(&|tool| tool.correction_mm))
        .zip(lengths(&|tool| tool.book_correction_mm));
    for (tool, ((length, correction), book)) in plan.tools.iter().zip(figures) {
        let (number, register) = (format!("T{}", tool.number), format!("H{:02}", tool.corrector));
        table.row([Inlines::from(number), register.into(), length, correction, book]);
    }
    table
}
