//! How much of each part of a plan is missing, whatever the plan says that it covers: what marks take points off for.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::tables::audit::{AuditShares, PlanPart};

use super::stated::Stated;

/// A part of a plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coverage {
    /// Which.
    pub part: PlanPart,
    /// What it is worth, per cent of the whole, by the table `audit-shares`.
    pub share: f64,
    /// How much of it is missing, from 0 to 1.
    pub missing: f64,
    /// Whether the plan says that it covers it.
    pub covered: bool,
}

/// The parts of a plan with what is missing of them.
///
/// # Errors
/// The table `audit-shares` lacks a part.
pub(super) fn of(stated: &Stated, knowledge: &Knowledge) -> Result<Vec<Coverage>, KnowledgeError> {
    let rows = knowledge.rows::<AuditShares<'_>>()?;
    let coverage = rows.iter().map(|row| Coverage {
        part: row.part,
        share: row.of_points.0,
        missing: missing(stated, row.part),
        covered: stated.covers(row.part),
    });
    Ok(coverage.collect())
}

fn missing(stated: &Stated, part: PlanPart) -> f64 {
    // A plan of the program is whole; it has no program because a command of its own writes that.
    if stated.is_own {
        return 0.0;
    }
    let whole = |there: bool| if there { 0.0 } else { 1.0 };
    let rows = || stated.rows.iter().enumerate().filter(|(_, row)| !row.elsewhere);
    let all = rows().count();
    // Of what is stated row by row, the share of the rows that have none.
    let without = |none: usize, stated_at_all: bool| match all {
        0 => whole(stated_at_all),
        _ => none as f64 / all as f64,
    };
    match part {
        PlanPart::Holes => whole(!stated.rows.is_empty()),
        PlanPart::Tools => {
            let named =
                |tool: usize| stated.tools[tool].designation.is_some() || !stated.tools[tool].figures.is_empty();
            let bare = rows().filter(|(_, row)| !stated.tool_of(row).is_some_and(named)).count();
            // A list of tools alone names no rows.
            let unused = rows().all(|(_, row)| row.tool.is_none()) && !stated.tools.is_empty();
            if unused { 0.0 } else { without(bare, !stated.tools.is_empty()) }
        }
        PlanPart::Conditions => {
            let bare = rows().filter(|(at, _)| stated.conditions_of(*at).is_none()).count();
            without(bare, !stated.conditions.is_empty())
        }
        PlanPart::Clamping => whole(stated.clamping.is_some()),
        PlanPart::Program => whole(stated.program.is_some()),
        PlanPart::Times => whole(!stated.times.is_empty()),
    }
}
