//! Compares counts, diameters and depths of the route with the drawing and with each other.

use crate::error::KnowledgeError;
use crate::note::{Figure, Note, Severity};
use crate::part::Hole;
use crate::plan::Operation;
use crate::units::Micrometres;

use super::super::backed::{backed, diameter};
use super::super::context::Context;
use super::super::graph::{Graph, Rule};
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::stated::Row;
use super::{equal_figures, fixed_figure, largest, marks, written};

const COUNT: Rule = Rule { id: "holes-of-group", formula: "z" };
const COUNT_OF_CONDITIONS: Rule = Rule { id: "holes-of-rows", formula: "z = Σz" };
pub(crate) const FROM: Rule = Rule { id: "diameter-before", formula: "D0" };
const DIAMETER: Rule = Rule { id: "diameter-of-tool", formula: "D" };
pub(crate) const PASS_DIAMETER: Rule = Rule { id: "diameter-of-row", formula: "D" };
const ONE_DIAMETER: Rule = Rule { id: "diameter-of-conditions", formula: "D" };
const MILL_DIAMETER: Rule = Rule { id: "diameter-of-mill", formula: "D" };
const DEPTH: Rule = Rule { id: "depth-of-hole", formula: "l" };

pub(super) const RULES: &[Rule] =
    &[COUNT, COUNT_OF_CONDITIONS, FROM, DIAMETER, PASS_DIAMETER, ONE_DIAMETER, MILL_DIAMETER, DEPTH];

/// Whether a row is right in its diameter and its tool is of another one: then the tool is the slip.
fn is_of_another_tool(context: &Context<'_>, at: usize, tool: usize, hole: &Hole) -> Result<bool, KnowledgeError> {
    let (row, figures) = (&context.stated.rows[at], &context.stated.tools[tool].figures);
    let of_catalog = context.cutter(tool).and_then(|cutter| cutter.row.diameter);
    let of_tool = of_catalog.or_else(|| Some(Micrometres::from_mm_rounded(figures.get(&Q::Diameter)?.value)));
    let own = diameter(context, at, row);
    Ok(own.zip(of_tool).is_some_and(|(own, of_tool)| own != of_tool) && backed(context, at, row, hole)?)
}

pub(super) fn add<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>) -> Result<(), KnowledgeError> {
    let stated = context.stated;
    for (at, row) in stated.rows.iter().enumerate() {
        let scope = Scope::Row(at);
        let Some(hole) = context.hole(row) else { continue };
        graph.add(fixed_figure(&COUNT, Id::new(scope, Q::Count), hole.at.len() as f64, []));
        let axial = matches!(row.operation.value, Operation::Drill | Operation::DrillOut);
        if let Some(tool) = stated.tool_of(row).filter(|_| axial && !row.elsewhere)
            && !is_of_another_tool(context, at, tool, hole)?
        {
            graph.add(equal_figures(&DIAMETER, Id::new(scope, Q::Diameter), Id::new(Scope::Tool(tool), Q::Diameter)));
        }
        if !row.opens_main_cylinder() {
            // A counterbore widens what came last, where nothing else is stated; in a stepped hole that may be another cylinder.
            let widens = |own: &Row| own.opens_main_cylinder() || own.operation.value == Operation::Counterbore;
            let before = stated.rows_of_hole(&hole.name).take_while(|(other, _)| *other < at);
            if let Some((before, _)) = before.filter(|(_, own)| widens(own)).last()
                && row.operation.value == Operation::Counterbore
                && hole.steps.is_empty()
                && stated.figure(Id::new(scope, Q::From)).is_none()
            {
                let own = Id::new(Scope::Row(before), Q::Diameter);
                graph.add(equal_figures(&FROM, Id::new(scope, Q::From), own));
            }
            continue;
        }
        let before = stated.rows_of_hole(&hole.name).take_while(|(other, _)| *other < at);
        let before = before.filter(|(_, other)| other.opens_main_cylinder()).last();
        let output = Id::new(scope, Q::From);
        match before {
            Some((before, _)) => graph.add(equal_figures(&FROM, output, Id::new(Scope::Row(before), Q::Diameter))),
            None if row.operation.value != Operation::Tap => {
                let start = hole.state.diameter().unwrap_or_default();
                graph.add(fixed_figure(&FROM, output, start.to_mm(), []));
            }
            None => {}
        }
        let plain = hole.steps.is_empty() && hole.thread.is_none() && hole.cone.is_none();
        // A later mill makes the flat bottom, and the point of the drill stays above it.
        let milled = stated.mill_follows(&hole.name, at) && !hole.through;
        // Before a reamer a blind hole goes deeper, for its lead.
        let deeper = stated.reamer_follows(&hole.name, at) && !hole.through;
        // Nor is the depth of the first of two drills that of the hole: its point may go as deep as the other's.
        let deeper = deeper || !hole.through && stated.drilled_out(&hole.name, at).is_some();
        if axial && plain && !milled && !deeper {
            let mut depth = fixed_figure(&DEPTH, Id::new(scope, Q::Depth), hole.depth.to_mm(), []);
            if context.runs_out(hole, at) {
                depth.judge = Some(Box::new(move |value, _| match context.is_overrun(hole, value) {
                    true => None,
                    false => Some((
                        Severity::Wrong,
                        Note::new("audit-depth-of-hole").with("hole", Figure::called(&hole.name)),
                    )),
                }));
            }
            graph.add(depth);
        }
    }
    for (at, conditions) in stated.conditions.iter().enumerate() {
        let scope = Scope::Conditions(at);
        let counts: Vec<Id> = conditions.rows.iter().map(|row| Id::new(Scope::Row(*row), Q::Count)).collect();
        if let Some(first) = conditions.rows.first() {
            let numbers = marks(counts.len(), "+");
            graph.add(written(&COUNT_OF_CONDITIONS, Id::new(scope, Q::Count), counts, &numbers));
            // All rows of the same conditions have the same diameter.
            for other in conditions.rows.iter().skip(1) {
                let same_diameter = equal_figures(
                    &ONE_DIAMETER,
                    Id::new(Scope::Row(*other), Q::Diameter),
                    Id::new(Scope::Row(*first), Q::Diameter),
                );
                graph.add(same_diameter);
            }
            let of_row = |quantity| Id::new(Scope::Row(*first), quantity);
            let output = Id::new(scope, Q::Diameter);
            // n = 1000·V/(π·D) takes the cutting diameter: for a mill its own.
            let mill = stated.rows.get(*first).filter(|row| row.operation.value == Operation::Mill);
            if let Some(tool) = mill.and_then(|row| stated.tool_of(row)) {
                graph.add(equal_figures(&MILL_DIAMETER, output, Id::new(Scope::Tool(tool), Q::Diameter)));
                continue;
            }
            // A step drill is calculated by its wide diameter.
            if stated.figure(of_row(Q::Also)).is_some() {
                graph.add(largest(&PASS_DIAMETER, output, vec![of_row(Q::Diameter), of_row(Q::Also)]));
            } else {
                graph.add(equal_figures(&PASS_DIAMETER, output, of_row(Q::Diameter)));
            }
        }
    }
    Ok(())
}
