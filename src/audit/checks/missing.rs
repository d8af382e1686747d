//! What a plan leaves out: listed, one note per section, and never invented.

use crate::error::KnowledgeError;
use crate::note::{Note, Severity};

use super::super::context::Context;
use super::super::finding::{Finding, Section};
use super::super::graph::Graph;
use super::super::quantity::{Id, Quantity as Q, Scope};

pub(super) fn check<'a>(
    context: &Context<'a>,
    _: &Graph<'a>,
    findings: &mut Vec<Finding>,
) -> Result<(), KnowledgeError> {
    let stated = context.stated;
    // A plan of ours leaves out nothing on purpose.
    if stated.own {
        return Ok(());
    }
    let mut say = |section: &str, what: Vec<String>| {
        if !what.is_empty() {
            let note = Note::new("audit-missing").with("section", section).with("what", what.join(", "));
            findings.push(Finding::new(Severity::Note, Section::Missing, section.to_owned(), note));
        }
    };
    let mut rows = Vec::new();
    if stated.rows.is_empty() {
        rows.push("route".to_owned());
    }
    for (at, row) in stated.rows.iter().enumerate() {
        let lacks = |quantity| stated.figure(Id::new(Scope::Row(at), quantity)).is_none();
        let mut own: Vec<&str> = Vec::new();
        own.extend(row.tool.is_none().then_some("tool"));
        own.extend(row.hole.is_none().then_some("hole"));
        own.extend(lacks(Q::Count).then_some("count"));
        own.extend(lacks(Q::Diameter).then_some("diameter"));
        if !own.is_empty() {
            rows.push(format!("{}: {}", row.number, own.join(" ")));
        }
        if stated.conditions_of(at).is_none() {
            rows.push(format!("{}: conditions", row.number));
        }
    }
    say("route", rows);
    let figures = |scope: Scope, quantities: &[Q]| -> Vec<&'static str> {
        let ids = quantities.iter().map(|quantity| Id::new(scope, *quantity));
        ids.filter(|id| stated.figure(*id).is_none()).map(Id::key).collect()
    };
    let mut tools = Vec::new();
    if stated.tools.is_empty() {
        tools.push("tools".to_owned());
    }
    for (at, tool) in stated.tools.iter().enumerate() {
        let mut own: Vec<&str> = Vec::new();
        own.extend(tool.designation.is_none().then_some("designation"));
        own.extend(tool.holder.is_none().then_some("holder"));
        own.extend(figures(Scope::Tool(at), &[Q::Overhang, Q::Assembly, Q::Corrector, Q::Correction]));
        if !own.is_empty() {
            tools.push(format!("T{}: {}", tool.number, own.join(" ")));
        }
    }
    say("tools", tools);
    let mut conditions = Vec::new();
    for at in 0..stated.conditions.len() {
        let needed = [Q::DepthOfCut, Q::Feed, Q::Speed, Q::Rpm, Q::MinuteFeed, Q::Torque, Q::Power, Q::Time];
        let own = figures(Scope::Conditions(at), &needed);
        if !own.is_empty() {
            conditions.push(format!("{}: {}", at + 1, own.join(" ")));
        }
    }
    say("conditions", conditions);
    let mut clamping: Vec<String> = Vec::new();
    match &stated.clamping {
        None => clamping.push("clamping".to_owned()),
        Some(own) => {
            let needed = [Q::Torque, Q::Distance, Q::ClampForce, Q::Clamps, Q::ForcePerClamp];
            let mut lacking: Vec<&str> = figures(Scope::Clamping, &needed);
            lacking.extend(own.screw.is_none().then_some("screw"));
            clamping.extend(lacking.into_iter().map(str::to_owned));
        }
    }
    say("clamping", clamping);
    if stated.program.is_none() {
        say("program", vec!["program".to_owned()]);
    }
    let times = figures(Scope::Times, &[Q::MachineTime, Q::RapidTime, Q::ChangeTime, Q::TotalTime]);
    say("times", times.into_iter().map(str::to_owned).collect());
    Ok(())
}
