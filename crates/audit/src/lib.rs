//! The audit: compares any plan with the knowledge base.
//!
//! ```text
//! plan.yaml → read → Stated ┐                ┌ rules  → graph → verdicts ┐
//! plan.json → own  → Stated ┴ context (tools, ┤                           ├ findings
//!                             our own plan)   └ checks ───────────────────┘
//! ```
//!
//! - [`stated`] is a plan as written, every figure with its place and its printed text;
//! - [`rules`] compute figures from others, `graph` finds where a deviation begins and what follows from it;
//! - [`checks`] compare choices with the tables: designations, cutters, holders, routes, limits, the program;
//! - [`Auditor`] keeps what many audits share;
//! - the table `audit-tolerance` gives the rounding tolerances.
//!
//! Architecture invariant: an audit invents nothing. What a plan does not state is listed as missing, and a value
//! taken from the tables in its place is named in the finding that uses it.

mod against;
mod auditor;
mod backed;
pub mod checks;
pub mod class;
mod context;
mod coverage;
mod figures;
pub mod file;
mod finding;
mod from_program;
mod graph;
pub mod limits;
mod many;
pub mod marks;
mod misprints;
mod mistakes;
mod near;
mod of_dimensions;
mod own;
pub mod quantity;
mod read;
mod roots;
pub mod rules;
mod sheet;
pub mod stated;
mod tolerance;
pub mod turned;
mod unsaid;
mod write;

// The types of this crate and of others, under one name each in the whole program.
use crate as audit;
use technolog_core::{error, machine, memo, motion, note, part, plan, reason, shop, zone};
use technolog_cutting as cutting;
use technolog_holes::{planner, route, sequence, tooling};
use technolog_knowledge::{self as knowledge, units};
use technolog_nc::{job, program};
use technolog_tables as tables;
use technolog_turning as turning;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::plan::Plan;

pub use against::{Comparison, Cost, Difference};
pub use auditor::Auditor;
pub use coverage::Coverage;
pub use file::schema;
pub use finding::{Audit, AuditFinding, Change, Counts, MissingKeys, Section, Shown, Subject, Summary};
pub use from_program::ProgramAlone;
pub use graph::Rule;
pub use many::{Audited, Mistake, Unread, total};
pub use read::{Files, NamedText, Unreadable, read_if_plan, read_plan, read_plan_node, read_plan_of, read_table};
pub use sheet::{Unsaid, by_tables, is_plan_table};
use stated::Stated;
pub use tables::audit::PlanPart;
pub use write::by_hand;

/// Checks one plan against the knowledge base; for many plans one [`Auditor`] is faster.
///
/// # Errors
/// The knowledge base has no answer. A fault of the plan is a finding.
pub fn audit(stated: &Stated, knowledge: &Knowledge) -> Result<Audit, KnowledgeError> {
    Auditor::new(knowledge)?.audit(stated)
}

/// As [`audit()`], beside an existing plan of the program for the same part and method.
///
/// # Errors
/// As for [`audit()`].
pub fn audit_beside(stated: &Stated, ours: &Plan, knowledge: &Knowledge) -> Result<Audit, KnowledgeError> {
    Auditor::new(knowledge)?.audit_beside(stated, ours)
}
