//! The proof of plans: every hole is simulated through its transitions with worst-case sizes and compared with
//! drawing and machine.
//!
//! The input is the transitions of any finished plan, made here or by hand. The proof uses tables that planning does
//! not use for its choices: what a transition reaches in practice, the offset of its axis, the share of a machine's
//! limit that a load may take.
//!
//! - `blank` the blank: walls beside holes, stock of cast holes, the spring of a thin plate;
//! - `hole` simulates the transitions of a hole: worst-case sizes, positions and depths;
//! - `shoulder` points of drills over flat shoulders; `core` the solid metal below the first drill of a blind hole;
//! - `cylinder` the requirements of the drawing for a surface; `reach` the practice tables of a transition;
//! - `loads` forces and power with their margin; `tool` the strength of the tool; `holder` what is left under it; `pilot` its room in a blind hole; `fault` all faults, as types.
//!
//! Architecture invariant: the proof does not use the planner, makes no choices and corrects nothing.

mod blank;
mod core;
mod cylinder;
mod fault;
mod holder;
mod hole;
mod loads;
mod middle;
mod pilot;
mod reach;
mod reamer;
mod shoulder;
mod tool;

// The types of other crates, under one name each in the whole program.
use technolog_core::{chip_room, error, note, part, plan, practice_speed, shop, tapping};
use technolog_knowledge::units;
use technolog_tables as tables;

pub use fault::{Beside, Fault, Load, Shortfall};
pub use hole::prove_hole;

use crate::error::KnowledgeError;
use crate::note::Finding;
use crate::plan::Plan;
use crate::shop::Shop;

/// Whether the plate of a plan springs under some of its tools by more than the feed.
///
/// # Errors
/// The knowledge base has no answer.
pub fn plate_springs(plan: &Plan, shop: &Shop<'_>) -> Result<bool, KnowledgeError> {
    blank::plate_springs(plan, shop)
}

/// All faults in a plan, hole by hole.
///
/// # Errors
/// The knowledge base has no answer.
pub fn prove(plan: &Plan, shop: &Shop<'_>) -> Result<Vec<Finding>, KnowledgeError> {
    let mut findings = Vec::new();
    for hole in &plan.part.holes {
        let Some(planned) = plan.holes.iter().find(|planned| planned.name == hole.name) else { continue };
        let mut faults = prove_hole(hole, &planned.transitions, &plan.part, shop)?;
        faults.extend(reamer::bought_too_wide(hole, planned, plan, shop)?);
        faults.extend(holder::low(hole, planned, plan, shop)?);
        faults.extend(pilot::meets_floor(hole, planned, plan, shop)?);
        findings.extend(faults.iter().map(|fault| Finding::of_hole(fault.severity(), &hole.name, fault.note())));
    }
    findings.extend(blank::faults(plan, shop)?);
    Ok(findings)
}
