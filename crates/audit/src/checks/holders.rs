//! Whether a holder takes its cutter: by its size, and by the family that the rule `holder-for-shank` names.

use crate::error::KnowledgeError;
use crate::note::{Because, Note, Severity};
use crate::plan::Operation;
use crate::tables::holders::HolderRow;
use crate::tooling::named;

use super::super::context::Context;
use super::super::finding::{AuditFinding, Section};
use super::super::graph::Graph;
use super::super::near::plain;
use super::super::quantity::Scope;

pub(super) fn check<'a>(
    context: &Context<'a>,
    _: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let shop = &context.shop;
    for (at, tool) in context.stated.tools.iter().enumerate() {
        let (Some(cutter), Some(name)) = (context.cutter(at), &tool.holder) else { continue };
        let say = |severity, why: Note| {
            let field = format!("tools.T{}.holder.designation", tool.number);
            let note = why.with("holder", &name.value).with("tool", cutter.designation);
            AuditFinding::new(severity, Section::Holders, field, note)
                .at(&name.place)
                .about(context.subject(Scope::Tool(at)))
        };
        // A tool with the machine's own taper is its own holder.
        if context.has_machine_taper(at) {
            if plain(&name.value) != plain(cutter.designation) {
                let finding = say(Severity::Error, Note::new("holder-of-whole-tool"));
                findings.push(finding.resting_on([Because::row(cutter.row.row, Note::new("named"))]));
            }
            continue;
        }
        let Some(holder) = context.holder(at) else { continue };
        let because = Because::row(holder.row, Note::new("named"));
        if let Some(why) = named::not_taken(holder, cutter, &shop.machine) {
            findings.push(say(Severity::Error, why.note()).resting_on([because]));
            continue;
        }
        let operation = context.stated.rows_of_tool(tool.number).next().map(|(_, row)| row.operation.value);
        let operation = operation.unwrap_or(Operation::Drill);
        if let Some((family, rule)) = named::other_family(holder, cutter, operation, shop.knowledge)? {
            let rows = family.rows::<HolderRow<'_>>().collect::<Result<Vec<_>, _>>()?;
            let takes = rows.iter().filter(|holder| named::not_taken(holder, cutter, &shop.machine).is_none());
            let known: Vec<&str> = takes.map(|holder| holder.designation).collect();
            let note = Note::new("holder-of-other-family").with("known", known.join(", "));
            let why = Because::row(rule.row, Note::new("named"));
            findings.push(say(Severity::Wrong, note).resting_on([because, why]));
        }
    }
    Ok(())
}
