//! Checks of choices against the tables: one file per kind, one line each in the list below.

mod allowances;
mod clamps;
mod consequences;
mod cutters;
mod depths;
mod designations;
mod exchanged;
mod holders;
mod limits;
mod loads;
mod missing;
mod openings;
mod ours;
mod pace;
mod program;
mod proof;
mod reach;
mod route;
mod scheme;
mod tables;
mod threads;
mod zone;

use crate::error::KnowledgeError;

use super::context::Context;
use super::finding::AuditFinding;
use super::graph::Graph;
use super::roots;

/// A kind of check; it adds its findings.
type Check = for<'a> fn(&Context<'a>, &Graph<'a>, &mut Vec<AuditFinding>) -> Result<(), KnowledgeError>;

/// Every check, in the order of a report. What a plan does not say it covers may be missing, and each check leaves that out; what
/// stands there is judged all the same.
const CHECKS: &[Check] = &[
    route::check,
    scheme::check,
    openings::check,
    threads::check,
    depths::check,
    allowances::check,
    cutters::check,
    holders::check,
    designations::check,
    limits::check,
    zone::check,
    reach::check,
    clamps::check,
    loads::check,
    pace::check,
    tables::check,
    proof::check,
    program::check,
    ours::check,
    exchanged::check,
    missing::check,
];

/// Runs every check.
pub(super) fn all<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    CHECKS.iter().try_for_each(|check| check(context, graph, findings))?;
    consequences::together(findings, context.shop.knowledge)?;
    roots::settle(findings);
    Ok(())
}
