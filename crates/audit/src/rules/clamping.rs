//! Clamping: from the cut to the torque, the force, and its division over the clamps.

use crate::error::KnowledgeError;
use crate::note::{Because, Note, Severity};
use crate::tables::audit::AuditClampingFor;
use crate::tables::materials::{Clamping, ClampingConstant};

use super::super::context::Context;
use super::super::figures::nature;
use super::super::graph::{Graph, Judge, Rule};
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::stated::Stated;
use super::conditions::torque_of_power;
use super::{by_its_text, equal_figures, fixed_figure, largest, written};

const POWER: Rule = Rule { id: "clamping-power", formula: "N" };
const RPM: Rule = Rule { id: "clamping-rpm", formula: "nпр" };
const ROW: Rule = Rule { id: "clamping-torque", formula: "M" };
const PLACES: Rule = Rule { id: "clamps-by-places", formula: "zп" };
const LARGEST: Rule = Rule { id: "largest-torque", formula: "M" };
const CONSTANT: Rule = Rule { id: "clamping-constant", formula: "" };
const DISTANCE: Rule = Rule { id: "distance-to-clamp", formula: "d" };
const FORCE: Rule = Rule { id: "clamping-force", formula: "W = k·M/(f·d)" };
const SLIDING: Rule = Rule { id: "clamping-against-sliding", formula: "W = k·P/(f+f2)" };
const CLAMPS: Rule = Rule { id: "two-clamps", formula: "zп" };
const EACH: Rule = Rule { id: "force-per-clamp", formula: "Q = W/zп" };

pub(super) const RULES: &[Rule] = &[POWER, RPM, ROW, PLACES, LARGEST, CONSTANT, DISTANCE, FORCE, SLIDING, CLAMPS, EACH];

pub(super) fn add<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>) -> Result<(), KnowledgeError> {
    let stated = context.stated;
    let Some(clamping) = &stated.clamping else { return Ok(()) };
    let id = |quantity| Id::new(Scope::Clamping, quantity);
    if let Some(at) = clamping.row.as_ref().and_then(|row| stated.conditions_of(row.value)) {
        graph.add(equal_figures(&POWER, id(Q::Power), Id::new(Scope::Conditions(at), Q::Power)));
        graph.add(equal_figures(&RPM, id(Q::Rpm), Id::new(Scope::Conditions(at), Q::Rpm)));
        graph.add(torque_of_power(Scope::Clamping));
        graph.add(equal_figures(&ROW, id(Q::Torque), Id::new(Scope::Conditions(at), Q::Torque)));
    }
    // Who states a side force holds the part against sliding: the torque is then that of the milling or boring.
    let slides = stated.figure(id(Q::SideForce)).is_some();
    if let Some(hole) = clamping.hole.as_ref().filter(|_| !slides) {
        graph.add(largest(&LARGEST, id(Q::Torque), torques_clamped(stated, &hole.value, id(Q::Torque))));
    }
    if let Some(distance) = context.clamped_hole().and_then(|hole| context.distance_to_clamp(hole)) {
        graph.add(fixed_figure(&DISTANCE, id(Q::Distance), distance.to_mm(), []));
    }
    if !clamping.at.is_empty() {
        graph.add(fixed_figure(&PLACES, id(Q::Clamps), clamping.at.len() as f64, []));
    }
    for (name, quantity) in [
        (ClampingConstant::Safety, Q::Safety),
        (ClampingConstant::Friction, Q::Friction),
        (ClampingConstant::SupportFriction, Q::SupportFriction),
        (ClampingConstant::Clamps, Q::Clamps),
    ] {
        let row = context.shop.knowledge.need(name.name(), |row: &Clamping<'_>| row.name.is(name))?;
        let value = row.maximum;
        let because = Because::row(row.row, Note::new(name.name()).with("value", value));
        if quantity != Q::Clamps {
            let mut constant = fixed_figure(&CONSTANT, id(quantity), value, [because]);
            constant.judge = (!stated.is_own).then(|| other_constant(context, quantity, value));
            graph.add(constant);
            continue;
        }
        let mut two = fixed_figure(&CLAMPS, id(quantity), value, [because]);
        two.judge = Some(Box::new(move |stated, _| {
            let note = Note::new("audit-clamps").with("needed", value);
            (stated < value).then_some((Severity::Doubtful, note))
        }));
        graph.add(two);
    }
    if slides {
        let inputs = vec![id(Q::Safety), id(Q::SideForce), id(Q::Friction), id(Q::SupportFriction)];
        graph.add(by_its_text(&SLIDING, id(Q::ClampForce), inputs));
    } else {
        let inputs = vec![id(Q::Safety), id(Q::Torque), id(Q::Friction), id(Q::Distance)];
        // A plan has d in mm.
        graph.add(written(&FORCE, id(Q::ClampForce), inputs, "{0}·{1}/({2}·{3}/1000)"));
    }
    graph.add(by_its_text(&EACH, id(Q::ForcePerClamp), vec![id(Q::ClampForce), id(Q::Clamps)]));
    Ok(())
}

/// The torques of a group of holes that clamps bear: those of the first set-up, or of all set-ups where the largest of all is what is
/// stated, because who clamps for it in the first one, too, is on the safe side.
fn torques_clamped(stated: &Stated, hole: &str, clamped: Id) -> Vec<Id> {
    let here = stated.rows_of_hole(hole).filter(|(_, row)| !row.elsewhere);
    let all: Vec<(u32, Id)> = here
        .filter_map(|(at, row)| {
            let torque = Id::new(Scope::Conditions(stated.conditions_of(at)?), Q::Torque);
            stated.figure(torque).map(|_| (row.setup.unwrap_or(1), torque))
        })
        .collect();
    let value = |id: Id| stated.figure(id).map(|figure| figure.value);
    let largest_of_all = all.iter().filter_map(|(_, torque)| value(*torque)).reduce(f64::max);
    let first: Vec<Id> = all.iter().filter(|(set_up, _)| *set_up == 1).map(|(_, torque)| *torque).collect();
    if first.is_empty() || value(clamped) == largest_of_all {
        return all.into_iter().map(|(_, torque)| torque).collect();
    }
    first
}

/// A factor or friction other than the textbook's: handbooks of fixtures have others, by the rule `audit-clamping`.
fn other_constant<'a>(context: &'a Context<'a>, quantity: Q, of_book: f64) -> Judge<'a> {
    Box::new(move |value, _| {
        if (value - of_book).abs() < 1e-9 {
            return None;
        }
        let question = |of_table| AuditClampingFor { quantity, of_table };
        let (_, asked) = context.by_share(value / of_book, question).ok()?;
        let severity = asked.winner().ok()??.severity;
        let code = if severity == Severity::Doubtful { "audit-clamping-other" } else { nature(value, of_book).code() };
        Some((severity, Note::new(code).with("value", of_book)))
    })
}
