//! Connects findings of all checks: a finding that follows from another one names it, so that each mistake has one
//! root.

use std::collections::BTreeSet;

use crate::note::Severity;

use super::figures::follows;
use super::finding::{AuditFinding, Change, FindingKind};
use super::graph::{Graph, Rule, Status};
use super::quantity::Id;

/// Whether a finding is a slip or follows from one; a note is neither.
fn is_fault(finding: &AuditFinding) -> bool {
    finding.severity < Severity::Note
}

/// The slips that a finding about a stated figure follows from: the figure itself if it is a slip, otherwise its
/// roots.
pub(super) fn figure_roots(graph: &Graph<'_>, id: Id) -> Vec<Id> {
    match graph.verdict(id).map(|verdict| verdict.status.clone()) {
        Some(Status::Root(Severity::Error | Severity::Wrong, _)) => vec![id],
        Some(Status::Follows(roots)) => roots.into_iter().collect(),
        _ => Vec::new(),
    }
}

/// The field, if a finding already reports a slip of it.
pub(super) fn roots_of(findings: &[AuditFinding], field: String) -> Vec<String> {
    let slip = |finding: &AuditFinding| finding.field == field && is_fault(finding) && finding.follows_from.is_empty();
    if findings.iter().any(slip) { vec![field] } else { Vec::new() }
}

/// Removes the verdict on a figure that proved right, and the findings that followed only from it.
pub(super) fn retract(findings: &mut Vec<AuditFinding>, field: &str, rule: &Rule) {
    let slip = |finding: &AuditFinding| {
        finding.field == field && finding.kind.rule() == Some(rule) && finding.follows_from.is_empty()
    };
    if !findings.iter().any(slip) {
        return;
    }
    let follows =
        |one: &AuditFinding| !one.follows_from.is_empty() && one.follows_from.iter().all(|root| root == field);
    findings.retain(|one| !slip(one) && !follows(one));
    // Findings that also follow from another slip keep that one.
    for one in findings.iter_mut() {
        one.follows_from.retain(|root| root != field);
    }
}

/// Traces every finding back to the slips that follow from nothing, and lists its consequences there.
pub(super) fn settle(findings: &mut [AuditFinding]) {
    let settled: Vec<BTreeSet<String>> = findings.iter().map(|finding| roots(finding, findings)).collect();
    for (one, roots) in findings.iter_mut().zip(settled) {
        let known: BTreeSet<String> = one.follows_from.iter().cloned().collect();
        if roots.is_empty() || roots == known {
            continue;
        }
        one.follows_from = roots.into_iter().collect();
        if matches!(one.kind, FindingKind::Follows(_)) {
            one.note = follows(&one.follows_from);
        }
    }
    for at in 0..findings.len() {
        let Some(root) = findings.get(at).filter(|one| is_fault(one) && !one.follows_from.is_empty()) else { continue };
        let (Some(quantity), Some(stated), Some(right)) = (root.quantity, &root.stated, &root.right) else { continue };
        let change = Change { field: root.field.clone(), quantity, stated: stated.clone(), right: right.clone() };
        let fields = root.follows_from.clone();
        // A slip that follows from another no longer lists consequences.
        if let Some(one) = findings.get_mut(at) {
            one.changes.clear();
        }
        for field in fields {
            let mut slips = findings.iter_mut().filter(|one| one.field == field && one.follows_from.is_empty());
            if let Some(slip) = slips.find(|one| is_fault(one))
                && !slip.changes.iter().any(|known| known.field == change.field)
            {
                slip.changes.push(change.clone());
            }
        }
    }
}

/// The fields of a finding's roots: of the findings it follows from, those that follow from nothing.
fn roots(finding: &AuditFinding, all: &[AuditFinding]) -> BTreeSet<String> {
    let (mut found, mut seen) = (BTreeSet::new(), BTreeSet::new());
    let mut open = finding.follows_from.clone();
    while let Some(field) = open.pop() {
        if !seen.insert(field.clone()) {
            continue;
        }
        let at = || all.iter().filter(|other| other.field == field && is_fault(other));
        // A field without a finding of a formula is one that a check names.
        if at().next().is_none() || at().any(|other| other.follows_from.is_empty()) {
            found.insert(field);
        } else {
            open.extend(at().flat_map(|other| other.follows_from.clone()));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use crate::audit::Section;
    use crate::note::Note;

    use super::*;

    const RULE: Rule = Rule { id: "rule", formula: "" };

    fn finding(field: &str, follows: &[&str]) -> AuditFinding {
        let finding = AuditFinding::new(Severity::Wrong, Section::Route, field.to_owned(), Note::new("audit-figure"));
        AuditFinding { follows_from: follows.iter().map(|one| (*one).to_owned()).collect(), ..finding }
    }

    #[test]
    fn what_follows_from_a_consequence_follows_from_its_root() {
        let mut findings = [finding("a", &[]), finding("b", &["a"]), finding("c", &["b"]), finding("d", &["c", "e"])];
        settle(&mut findings);
        assert_eq!(findings[2].follows_from, ["a"]);
        assert_eq!(findings[3].follows_from, ["a", "e"]);
    }

    #[test]
    fn two_that_follow_from_each_other_stay_as_they_are() {
        let mut findings = [finding("a", &["b"]), finding("b", &["a"])];
        settle(&mut findings);
        assert_eq!(findings[0].follows_from, ["b"]);
    }

    #[test]
    fn a_slip_is_taken_back_with_what_followed_from_it_alone() {
        let mut findings = vec![finding("a", &[]), finding("b", &["a"]), finding("c", &["a", "d"]), finding("d", &[])];
        for finding in &mut findings {
            finding.kind = FindingKind::Formula(&RULE);
        }
        retract(&mut findings, "a", &RULE);
        let left: Vec<&str> = findings.iter().map(|one| one.field.as_str()).collect();
        assert_eq!(left, ["c", "d"]);
        assert_eq!(findings[0].follows_from, ["d"]);
    }
}
