//! The clamp: whether standard and screw belong to its designation, and whether the screw bears the force.

use crate::error::KnowledgeError;
use crate::note::{Because, Figure, Note, Severity};
use crate::tables::materials::{ClampDesignations, ClampScrew, Clamping as Constant, ClampingConstant};
use crate::units::{Micrometres, round_to};

use super::super::context::Context;
use super::super::figures::shown;
use super::super::finding::{AuditFinding, Section};
use super::super::graph::Graph;
use super::super::near::{Likeness, likeness, plain};
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::stated::{Clamping, Row, Text};

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let Some(clamping) = &context.stated.clamping else { return Ok(()) };
    largest(context, graph, clamping, findings);
    let known = designation(context, clamping, findings)?;
    // A clamp whose screw is not stated has that of its designation.
    let own = clamping.screw.as_ref().map(|screw| (screw.value.as_str(), screw));
    let of_clamp = known.zip(clamping.designation.as_ref()).map(|(clamp, name)| (clamp.screw, name));
    match own.or(of_clamp) {
        Some((thread, text)) => screw(context, graph, thread, text, findings),
        None => Ok(()),
    }
}

/// The clamping must be computed for the row that needs the largest force: the largest torque divided by its distance
/// to the clamp, where plan or drawing give the places of clamps (5.2 item 7).
fn largest(context: &Context<'_>, graph: &Graph<'_>, clamping: &Clamping, findings: &mut Vec<AuditFinding>) {
    // Against sliding the side force decides, not the torque.
    let slides = context.stated.figure(Id::new(Scope::Clamping, Q::SideForce)).is_some();
    if context.stated.is_own || slides {
        return;
    }
    let load = |(at, row): (usize, &Row)| {
        let conditions = context.stated.conditions_of(at)?;
        let torque = graph.right(Id::new(Scope::Conditions(conditions), Q::Torque))?;
        let hole = context.hole(row)?;
        let arm = context.distance_to_clamp(hole).map(Micrometres::to_mm);
        Some((at, row.number, hole.name.as_str(), torque, arm))
    };
    let loads: Vec<_> = context.stated.rows.iter().enumerate().filter_map(load).collect();
    let arms = loads.iter().all(|(.., arm)| arm.is_some());
    let need =
        |load: &&(usize, u32, &str, f64, Option<f64>)| if arms { load.3 / load.4.unwrap_or(1.0) } else { load.3 };
    let largest = |a: &&_, b: &&_| need(a).total_cmp(&need(b));
    let own = match (&clamping.row, &clamping.hole) {
        (Some(row), _) => loads.iter().find(|(at, ..)| *at == row.value).map(|load| (load, "for", &row.place)),
        (None, Some(hole)) => {
            let of_hole = loads.iter().filter(|(_, _, name, ..)| *name == hole.value);
            of_hole.max_by(largest).map(|load| (load, "hole", &hole.place))
        }
        (None, None) => None,
    };
    let (Some((own, key, place)), Some(most)) = (own, loads.iter().max_by(largest)) else { return };
    let share = context.auditor.tolerances().share(Q::ClampForce);
    if need(&most) <= need(&own) * (1.0 + share) {
        return;
    }
    let note = Note::new("audit-clamp-not-largest").with("torque", Figure::number(shown(own.3))).with("row", most.1);
    let note = note.with("other", Figure::number(shown(most.3)));
    let finding = AuditFinding::new(Severity::Wrong, Section::Clamping, format!("clamping.{key}"), note).at(place);
    findings.push(finding.with_values(own.1, most.1));
}

fn finding(severity: Severity, key: &str, note: Note, text: &Text) -> AuditFinding {
    AuditFinding::new(severity, Section::Clamping, format!("clamping.{key}"), note).at(&text.place)
}

/// The clamp of a designation, with findings on what does not belong to it. The catalog has only clamps that the
/// source names, so another designation is not wrong: it cannot be checked.
fn designation<'k>(
    context: &Context<'k>,
    clamping: &Clamping,
    findings: &mut Vec<AuditFinding>,
) -> Result<Option<ClampDesignations<'k>>, KnowledgeError> {
    let Some(name) = &clamping.designation else { return Ok(None) };
    let same = |clamp: &ClampDesignations<'_>| plain(clamp.designation) == plain(&name.value);
    let Some(clamp) = context.shop.knowledge.find(same)? else {
        let note = Note::new("audit-no-catalog").with("designation", &name.value);
        findings.push(finding(Severity::Note, "designation", note, name));
        return Ok(None);
    };
    let because = || [Because::row(clamp.row, Note::new("named"))];
    let attributes = [
        ("standard", &clamping.standard, clamp.standard, "audit-clamp-standard"),
        ("screw", &clamping.screw, clamp.screw, "audit-clamp-screw"),
    ];
    for (key, stated, right, code) in attributes {
        let Some(stated) = stated else { continue };
        if likeness(&stated.value, right) != Likeness::Same {
            let note = Note::new(code).with(key, &stated.value).with("designation", &name.value).with("known", right);
            let finding = finding(Severity::Wrong, key, note, stated);
            findings.push(finding.with_values(&stated.value, right).resting_on(because()));
        }
    }
    Ok(Some(clamp))
}

/// Checks that the screw bears the force on its clamp; that a smaller one would bear it too is no fault.
fn screw(
    context: &Context<'_>,
    graph: &Graph<'_>,
    thread: &str,
    text: &Text,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let screws = context.shop.knowledge.rows::<ClampScrew<'_>>()?;
    let Some(own) = screws.iter().find(|screw| plain(screw.thread) == plain(thread)) else {
        let known: Vec<&str> = screws.iter().map(|screw| screw.thread).collect();
        let note = Note::new("audit-no-screw").with("screw", thread).with("known", known.join(", "));
        findings.push(finding(Severity::Wrong, "screw", note, text));
        return Ok(());
    };
    let each = Id::new(Scope::Clamping, Q::ForcePerClamp);
    // Where the force per clamp is not stated, it is the force divided by the number of clamps.
    let total = Id::new(Scope::Clamping, Q::ClampForce);
    let Some(force) = graph.right(each).or_else(|| graph.right(total)) else { return Ok(()) };
    let bears = own.force_80.0;
    if bears + 0.5 >= force {
        // The program's own plan takes the smallest screw that bears the force and is thick enough, unless the
        // drawing names the screws.
        let wanted = ClampingConstant::LeastScrew;
        let least = context.shop.knowledge.need(wanted.name(), |row: &Constant<'_>| row.name.is(wanted))?.maximum;
        let thick = |screw: &&ClampScrew<'_>| screw.nominal_diameter.to_mm() >= least;
        let smallest = screws.iter().filter(thick).find(|screw| screw.force_80.0 + 0.5 >= force);
        let named = context.stated.part.fixture.clamps.iter().any(|clamp| clamp.screw.is_some());
        let smaller = |screw: &&ClampScrew<'_>| context.stated.is_own && !named && screw.row.index < own.row.index;
        if let Some(smallest) = smallest.filter(smaller) {
            let note = Note::new("audit-screw-large").with("screw", thread).with("force", round_to(force, 0));
            let finding = finding(Severity::Doubtful, "screw", note, text);
            findings.push(finding.with_values(thread, smallest.thread));
        }
        return Ok(());
    }
    let note =
        Note::new("audit-screw-weak").with("screw", thread).with("bears", bears).with("force", round_to(force, 0));
    let finding = finding(Severity::Error, "screw", note, text);
    findings.push(finding.resting_on([Because::row(own.row, Note::new("named"))]));
    Ok(())
}
