//! Times of the whole part.

use crate::error::KnowledgeError;
use crate::note::{Because, Note};
use crate::tables::machines::MachineQuantity;

use super::super::context::Context;
use super::super::graph::{Graph, Rule};
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::{fixed_figure, marks, written};

const MACHINE: Rule = Rule { id: "machine-time-of-part", formula: "ΣTм = Σz·Tм" };
const CHANGE: Rule = Rule { id: "tool-change-time", formula: "Tзм = m·tзм" };
const RAPID: Rule = Rule { id: "rapid-time", formula: "Tх" };
const TOTAL: Rule = Rule { id: "total-time", formula: "T = ΣTм + Tх + Tзм" };

pub(super) const RULES: &[Rule] = &[MACHINE, CHANGE, RAPID, TOTAL];

pub(super) fn add<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>) -> Result<(), KnowledgeError> {
    let stated = context.stated;
    let id = |quantity| Id::new(Scope::Times, quantity);
    let mut inputs = Vec::new();
    let mut terms = Vec::new();
    for (at, _) in stated.rows.iter().enumerate().filter(|(_, row)| !row.elsewhere) {
        let Some(conditions) = stated.conditions_of(at) else { continue };
        terms.push(format!("{{{}}}·{{{}}}", inputs.len(), inputs.len() + 1));
        inputs.push(Id::new(Scope::Row(at), Q::Count));
        inputs.push(Id::new(Scope::Conditions(conditions), Q::Time));
    }
    if !inputs.is_empty() {
        graph.add(written(&MACHINE, id(Q::MachineTime), inputs, &terms.join("+")));
    }
    let changes = context.changes().len();
    if changes > 0 {
        let change = context.shop.machine.tool_change.0;
        let because =
            Because::row(context.shop.machine.row(MachineQuantity::ToolChangeTime)?, Note::new("audit-tool-change"));
        graph.add(fixed_figure(&CHANGE, id(Q::ChangeTime), changes as f64 * change, [because]));
    }
    if stated.is_own {
        graph.add(fixed_figure(&RAPID, id(Q::RapidTime), context.plan.time.rapid_min.0, []));
    }
    // Further times that a plan may include; leaving them out is no mistake by itself.
    let more =
        [Q::FeedOutTime, Q::DwellTime, Q::HandTime].map(id).into_iter().filter(|id| stated.figure(*id).is_some());
    let inputs: Vec<Id> = [Q::MachineTime, Q::RapidTime, Q::ChangeTime].map(id).into_iter().chain(more).collect();
    let sum = marks(inputs.len(), "+");
    graph.add(written(&TOTAL, id(Q::TotalTime), inputs, &sum));
    Ok(())
}
