//! Whether designations exist, and agree with the standards, shanks and tables stated for them.

use std::collections::BTreeSet;

use crate::error::KnowledgeError;
use crate::knowledge::RowRef;
use crate::note::{Because, Figure, Note, Severity};
use crate::tables::audit::{PrintedNames, StandardsAlike};
use crate::units::Micrometres;

use super::super::context::Context;
use super::super::finding::{AuditFinding, Section};
use super::super::graph::Graph;
use super::super::near::{Likeness, NameMatch, away, likeness, plain, same_table};
use super::super::quantity::{Quantity as Q, Scope};
use super::super::stated::Text;

pub(super) fn check<'a>(
    context: &Context<'a>,
    _: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    for (at, tool) in context.stated.tools.iter().enumerate() {
        let field = |key: &str| format!("tools.T{}.{key}", tool.number);
        let about = |finding: AuditFinding| finding.about(context.subject(Scope::Tool(at)));
        let near = context.cutter_near(at);
        dimensions(context, at, findings);
        let reported = Reported { section: Section::Tools, field: field("designation"), about: &about };
        // A number of no catalog, with the dimensions of one that differs in a sign or two: the number is misprinted.
        let proven = |known: &str| context.has_dimensions_of(at, known);
        let meant = |name: &str| context.auditor.cutters.alike(name).find(|known| proven(known)).map(str::to_owned);
        named(context, near, |cutter| cutter.row.row, tool.designation.as_ref(), &meant, &reported, findings)?;
        if let Some(cutter) = context.cutter(at) {
            let row = cutter.row.row;
            let reported = ReportedRow { row, section: Section::Tools };
            standard(context, &reported, tool.standard.as_ref(), field("standard"), &about, findings)?;
            if let Some(shank) = &tool.shank
                && shank.value != cutter.head.shank.name()
            {
                let note = Note::new("audit-shank")
                    .with("shank", Figure::word(shank.value.clone()))
                    .with("name", Figure::word(cutter.head.shank.name()));
                let finding = AuditFinding::new(Severity::Wrong, Section::Tools, field("shank"), note).at(&shank.place);
                let finding = finding.with_values(&shank.value, cutter.head.shank.name());
                findings.push(about(finding.resting_on([Because::row(row, Note::new("named"))])));
            }
            // Of equal designations the one of the stated table is taken; here the found row is not in that table.
            if let Some(table) = tool.table.as_ref().filter(|table| !same_table(&table.value, &row.table.id)) {
                let note = Note::new("audit-tool-table").with("table", &table.value).with("tool", cutter.designation);
                let note = note.with("known", &row.table.id);
                let finding = AuditFinding::new(Severity::Wrong, Section::Tools, field("table"), note).at(&table.place);
                let finding = finding.with_values(&table.value, &row.table.id);
                findings.push(about(finding.resting_on([Because::row(row, Note::new("named"))])));
            }
        }
        let near = context.holder_near(at);
        // A cutter with the machine's taper is its own holder.
        if context.has_machine_taper(at) {
            continue;
        }
        let reported = Reported { section: Section::Holders, field: field("holder.designation"), about: &about };
        let length = tool.figures.get(&Q::HolderLength).map(|figure| Micrometres::from_mm_rounded(figure.value));
        let of_length = |known: &&str| {
            let mut holders = context.auditor.holders.values().filter(|holder| holder.designation == *known);
            holders.any(|holder| Some(holder.length) == length)
        };
        let meant = |name: &str| context.auditor.holders.alike(name).find(of_length).map(str::to_owned);
        named(context, near, |holder| holder.row, tool.holder.as_ref(), &meant, &reported, findings)?;
        if let Some(holder) = context.holder(at) {
            let reported = ReportedRow { row: holder.row, section: Section::Holders };
            let field = field("holder.standard");
            standard(context, &reported, tool.holder_standard.as_ref(), field, &about, findings)?;
        }
    }
    Ok(())
}

/// A row and the section of the report it belongs to.
struct ReportedRow<'k> {
    row: RowRef<'k>,
    section: Section,
}

/// Where a finding on a designation stands.
struct Reported<'f> {
    section: Section,
    field: String,
    about: &'f dyn Fn(AuditFinding) -> AuditFinding,
}

/// The finding about a designation. What no catalog has cannot be checked and is not wrong, unless its dimensions are those of another one,
/// which is `meant`; a lost prefix is no other tool.
fn named<'k, T>(
    context: &Context<'_>,
    near: &NameMatch<T>,
    row: impl Fn(&T) -> RowRef<'k>,
    name: Option<&Text>,
    meant: &dyn Fn(&str) -> Option<String>,
    reported: &Reported<'_>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let Some(name) = name else { return Ok(()) };
    let finding = |severity, note: Note| {
        AuditFinding::new(severity, reported.section, reported.field.clone(), note).at(&name.place)
    };
    let found = match near {
        NameMatch::Unstated | NameMatch::Found(_) => return Ok(()),
        NameMatch::Meant(found, known) => {
            let (severity, code) = match printed(context, &name.value, known)? {
                true => (Severity::Note, "audit-designation-printed"),
                false => (Severity::Doubtful, "audit-designation-misprinted"),
            };
            let note = Note::new(code).with("tool", &name.value).with("known", known);
            let because = Because::row(row(found), Note::new("named"));
            finding(severity, note).with_values(&name.value, known).resting_on([because])
        }
        NameMatch::Unknown(Some(known)) => {
            let meant = meant(&name.value);
            let (severity, code) = match (&meant, away(&name.value, known)) {
                (Some(_), _) => (Severity::Wrong, "audit-designation-unknown"),
                // One sign of another number may be misread, or a number of another catalog.
                (None, 0 | 1) => (Severity::Doubtful, "audit-designation-unchecked"),
                (None, _) => (Severity::Note, "audit-designation-unchecked"),
            };
            finding(severity, Note::new(code).with("tool", &name.value).with("known", meant.as_ref().unwrap_or(known)))
        }
        NameMatch::Unknown(None) => {
            finding(Severity::Note, Note::new("audit-designation-alien").with("tool", &name.value))
        }
    };
    findings.push((reported.about)(found));
    Ok(())
}

/// Whether the textbook itself prints a name of the catalogs so.
fn printed(context: &Context<'_>, written: &str, known: &str) -> Result<bool, KnowledgeError> {
    let same = |row: &PrintedNames<'_>| plain(row.printed) == plain(written) && plain(row.known) == plain(known);
    Ok(context.shop.knowledge.find(same)?.is_some())
}

/// Whether a standard belongs to the row: to its table, or to the place of the row in the source.
fn standard(
    context: &Context<'_>,
    reported: &ReportedRow<'_>,
    standard: Option<&Text>,
    field: String,
    about: &dyn Fn(AuditFinding) -> AuditFinding,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    let Some(standard) = standard else { return Ok(()) };
    let place: String = plain(reported.row.place()).into_iter().collect();
    let written: String = plain(&standard.value).into_iter().collect();
    let alike =
        |row: &StandardsAlike<'_>| row.tools == reported.row.table.id && plain(row.standard) == plain(&standard.value);
    if place.contains(&written) || context.shop.knowledge.find(alike)?.is_some() {
        return Ok(());
    }
    let because = Because::row(reported.row, Note::new("named"));
    let finding =
        |severity, note: Note| AuditFinding::new(severity, reported.section, field.clone(), note).at(&standard.place);
    let found = match reported.row.table.standard.as_deref() {
        // There is nothing to compare it with.
        None => finding(Severity::Note, Note::new("audit-standard-unchecked").with("standard", &standard.value)),
        Some(right) => match likeness(&standard.value, right) {
            Likeness::Same => return Ok(()),
            Likeness::Misread if printed(context, &standard.value, right)? => {
                let note = Note::new("audit-standard-printed").with("standard", &standard.value).with("known", right);
                finding(Severity::Note, note).with_values(&standard.value, right)
            }
            // The standard of other tools is no misprint.
            Likeness::Misread if !is_of_others(context, &standard.value) => {
                let note =
                    Note::new("audit-standard-misprinted").with("standard", &standard.value).with("known", right);
                finding(Severity::Wrong, note).with_values(&standard.value, right)
            }
            Likeness::Misread | Likeness::Other => {
                let note = Note::new("audit-standard-other").with("standard", &standard.value).with("known", right);
                finding(Severity::Wrong, note).with_values(&standard.value, right)
            }
        },
    };
    findings.push(about(found.resting_on([because])));
    Ok(())
}

/// Whether a catalog of cutters goes by that standard.
fn is_of_others(context: &Context<'_>, written: &str) -> bool {
    let standards = context.auditor.cutters.values().filter_map(|cutter| cutter.row.row.table.standard.as_deref());
    let distinct: BTreeSet<&str> = standards.collect();
    distinct.into_iter().any(|known| likeness(written, known) == Likeness::Same)
}

/// Dimensions that do not belong to the designation but all belong to another one: then the designation is wrong.
fn dimensions(context: &Context<'_>, at: usize, findings: &mut Vec<AuditFinding>) {
    let tool = &context.stated.tools[at];
    let (Some(name), Some(other)) = (&tool.designation, context.of_dimensions(at)) else { return };
    let field = format!("tools.T{}.designation", tool.number);
    let note = Note::new("audit-dimensions-of").with("tool", &name.value).with("known", other.designation);
    let finding = AuditFinding::new(Severity::Wrong, Section::Tools, field, note).at(&name.place);
    let because = Because::row(other.row.row, Note::new("named"));
    let finding = finding.with_values(&name.value, other.designation).resting_on([because]);
    findings.push(finding.about(context.subject(Scope::Tool(at))));
}
