//! The proof of plans: every hole is simulated through its transitions at worst-case sizes and compared with drawing
//! and machine.
//!
//! It takes the transitions of any finished plan, made here or written by hand, and uses tables by which nothing is
//! chosen: what a transition reaches in practice, where its axis goes, what share of a machine's limit a load may take.
//!
//! - `hole` walks through the transitions of a hole: sizes, positions and depths at worst;
//! - `cylinder` what the drawing requires of a surface; `reach` what the tables say of a transition;
//! - `loads` forces and power with their margin; `tool` what the tool itself bears; `fault` everything that can fail, as types.
//!
//! Architecture invariant: the proof does not use the planner, chooses nothing and corrects nothing.

mod cylinder;
mod fault;
mod hole;
mod loads;
mod reach;
mod tool;

// The rooms below, under one name each in the whole program.
use technolog_core::{error, note, part, plan, practice_speed, shop};
use technolog_knowledge::units;
use technolog_tables as tables;

pub use fault::{Fault, Load, Wanting};
pub use hole::prove_hole;

use crate::error::KnowledgeError;
use crate::note::Finding;
use crate::plan::Plan;
use crate::shop::Shop;

/// Everything that fails in a plan, hole by hole.
///
/// # Errors
/// The knowledge base has no answer.
pub fn prove(plan: &Plan, shop: &Shop<'_>) -> Result<Vec<Finding>, KnowledgeError> {
    let mut findings = Vec::new();
    for hole in &plan.part.holes {
        let Some(planned) = plan.holes.iter().find(|planned| planned.name == hole.name) else { continue };
        let faults = prove_hole(hole, &planned.transitions, &plan.part, shop)?;
        findings.extend(faults.iter().map(|fault| Finding::of_hole(fault.severity(), &hole.name, fault.note())));
    }
    Ok(findings)
}
