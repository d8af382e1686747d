//! What a plan leaves out: listed, one note per section, never guessed.

use crate::error::KnowledgeError;
use crate::note::{Note, Severity};
use crate::tables::audit::PlanPart;

use super::super::context::Context;
use super::super::finding::{AuditFinding, MissingKeys, Section};
use super::super::graph::Graph;
use super::super::quantity::{Id, Quantity as Q, Scope};

pub(super) fn check<'a>(
    context: &Context<'a>,
    _: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let stated = context.stated;
    // A plan of the program leaves out nothing by mistake, and a list of tools or a program is asked for nothing else.
    if stated.is_own || stated.is_list || stated.is_of_program() {
        return Ok(());
    }
    let mut say = |part: PlanPart, section: &str, missing: Vec<MissingKeys>| {
        if !missing.is_empty() && stated.covers(part) {
            let what: Vec<String> = missing.iter().map(keys_text).collect();
            let note = Note::new("audit-missing").with("section", section).with("what", what.join(", "));
            let mut finding = AuditFinding::new(Severity::Note, Section::Missing, section.to_owned(), note);
            finding.missing = missing;
            findings.push(finding);
        }
    };
    let lack = |part: String, scope: Scope, keys: Vec<&'static str>| MissingKeys {
        part,
        subject: context.subject(scope),
        keys,
    };
    let mut rows = Vec::new();
    if stated.rows.is_empty() {
        rows.push(missing_key("route"));
    }
    for (at, row) in stated.rows.iter().enumerate() {
        let lacks = |quantity| stated.figure(Id::new(Scope::Row(at), quantity)).is_none();
        let mut own = Vec::new();
        own.extend((row.tool.is_none() && stated.covers(PlanPart::Tools)).then_some("tool"));
        own.extend(row.hole.is_none().then_some("hole"));
        own.extend(lacks(Q::Count).then_some("count"));
        own.extend(lacks(Q::Diameter).then_some("diameter"));
        if !own.is_empty() {
            rows.push(lack(row.number.to_string(), Scope::Row(at), own));
        }
        if stated.conditions_of(at).is_none() && stated.covers(PlanPart::Conditions) {
            rows.push(lack(row.number.to_string(), Scope::Row(at), vec!["conditions"]));
        }
    }
    say(PlanPart::Holes, "route", rows);
    let figures = |scope: Scope, quantities: &[Q]| -> Vec<&'static str> {
        let ids = quantities.iter().map(|quantity| Id::new(scope, *quantity));
        ids.filter(|id| stated.figure(*id).is_none()).map(Id::key).collect()
    };
    let mut tools = Vec::new();
    if stated.tools.is_empty() {
        tools.push(missing_key("tools"));
    }
    for (at, tool) in stated.tools.iter().enumerate() {
        let mut own = Vec::new();
        own.extend(tool.designation.is_none().then_some("designation"));
        // A cutter with the taper of the machine has no holder.
        own.extend((tool.holder.is_none() && !context.has_machine_taper(at)).then_some("holder"));
        own.extend(figures(Scope::Tool(at), &[Q::Overhang, Q::Assembly, Q::Corrector, Q::Correction]));
        if !own.is_empty() {
            tools.push(lack(format!("T{}", tool.number), Scope::Tool(at), own));
        }
    }
    say(PlanPart::Tools, "tools", tools);
    let mut conditions = Vec::new();
    for at in 0..stated.conditions.len() {
        let needed = [Q::DepthOfCut, Q::Feed, Q::Speed, Q::Rpm, Q::MinuteFeed, Q::Torque, Q::Power, Q::Time];
        let own = figures(Scope::Conditions(at), &needed);
        if !own.is_empty() {
            conditions.push(lack((at + 1).to_string(), Scope::Conditions(at), own));
        }
    }
    say(PlanPart::Conditions, "conditions", conditions);
    let mut clamping = Vec::new();
    match &stated.clamping {
        None => clamping.push(missing_key("clamping")),
        Some(own) => {
            let needed = [Q::Torque, Q::Distance, Q::ClampForce, Q::Clamps, Q::ForcePerClamp];
            clamping.extend(figures(Scope::Clamping, &needed).into_iter().map(missing_key));
            clamping.extend(own.screw.is_none().then(|| missing_key("screw")));
        }
    }
    say(PlanPart::Clamping, "clamping", clamping);
    if stated.program.is_none() {
        say(PlanPart::Program, "program", vec![missing_key("program")]);
    }
    let times = figures(Scope::Times, &[Q::MachineTime, Q::RapidTime, Q::ChangeTime, Q::TotalTime]);
    say(PlanPart::Times, "times", times.into_iter().map(missing_key).collect());
    Ok(())
}

/// A key that the section as a whole lacks.
fn missing_key(key: &'static str) -> MissingKeys {
    MissingKeys { keys: vec![key], ..MissingKeys::default() }
}

/// In the form that programs read: `T3: correction`, `2: tool hole`.
fn keys_text(lack: &MissingKeys) -> String {
    let keys = lack.keys.join(" ");
    if lack.part.is_empty() { keys } else { format!("{}: {keys}", lack.part) }
}
