//! The proof of plans: every hole is followed through its transitions at worst, and held against drawing and machine.
//!
//! Who planned does not matter: it takes the transitions of a finished plan, ours or one that somebody wrote, and asks
//! tables of its own, by which nothing is chosen: what a way of working reaches in practice, where its axis goes, what
//! share of the machine's limits a load may take.
//!
//! - `hole` walks through the transitions of a hole: sizes, positions and depths at worst;
//! - `cylinder` what the drawing asks of the surface at hand; `reach` what the tables say of a transition;
//! - `loads` forces and power with their margin; `tool` what the tool itself bears; `fault` everything that can fail, as types.
//!
//! Architecture invariant: the proof knows no planner, chooses nothing and mends nothing.

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
/// The knowledge cannot answer.
pub fn prove(plan: &Plan, shop: &Shop<'_>) -> Result<Vec<Finding>, KnowledgeError> {
    let mut findings = Vec::new();
    for hole in &plan.part.holes {
        let Some(planned) = plan.holes.iter().find(|planned| planned.name == hole.name) else { continue };
        let faults = prove_hole(hole, &planned.transitions, &plan.part, shop)?;
        findings.extend(faults.iter().map(|fault| Finding::of_hole(fault.severity(), &hole.name, fault.note())));
    }
    Ok(findings)
}
