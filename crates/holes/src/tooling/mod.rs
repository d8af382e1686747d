//! Cutters and holders from the catalogs, and whether they reach deep enough.
//!
//! - `cutter`: what is required of a cutter, and all that fit, in the order of the tables;
//! - `sizes`: which rows have the right size; `reach`: why one of them cannot be used;
//! - `holder`: the holder for a shank; [`named`]: a cutter that a plan names.

mod cutter;
mod holder;
pub mod named;
mod reach;
mod sizes;

use crate::error::KnowledgeError;
use crate::plan::Operation;
use crate::reason::Unfit;
use crate::shop::Shop;
use crate::units::Micrometres;

pub use cutter::{Cutter, CutterNeed, Plunging};
pub use holder::Assembly;
pub use sizes::{DrillSize, drill_sizes};

/// The first cutter that fits, with a holder that takes it within the overhang of the machine.
///
/// # Errors
/// The knowledge base has no answer. That nothing fits is not an error: the inner `Err` gives the reason for each
/// cutter.
pub fn find_tool<'s, 'k>(
    need: &CutterNeed<'_>,
    shop: &'s Shop<'k>,
) -> Result<Result<(Cutter<'s, 'k>, Assembly), Vec<Unfit>>, KnowledgeError> {
    let (cutters, rejected) = cutter::cutters(need, shop)?;
    first_that_fits(cutters, rejected, need, shop)
}

/// The step drill that makes a hole and its wider opening in one stroke: with both diameters, a narrow part long
/// enough for the hole, and a wide part of the required form.
///
/// # Errors
/// As for [`find_tool`].
pub fn find_step_drill<'s, 'k>(
    need: &CutterNeed<'_>,
    wide: Micrometres,
    pilot: Micrometres,
    opening: Operation,
    shop: &'s Shop<'k>,
) -> Result<Result<(Cutter<'s, 'k>, Assembly), Vec<Unfit>>, KnowledgeError> {
    let (cutters, rejected) = cutter::step_drills(need, wide, pilot, opening, shop)?;
    first_that_fits(cutters, rejected, need, shop)
}

fn first_that_fits<'s, 'k>(
    cutters: Vec<Cutter<'s, 'k>>,
    mut rejected: Vec<Unfit>,
    need: &CutterNeed<'_>,
    shop: &'s Shop<'k>,
) -> Result<Result<(Cutter<'s, 'k>, Assembly), Vec<Unfit>>, KnowledgeError> {
    for cutter in cutters {
        match holder::assemble(&cutter, need, shop)? {
            Ok(assembly) => {
                let over = rejected.iter().map(Unfit::note).collect();
                return Ok(Ok((Cutter { rejected: over, ..cutter }, assembly)));
            }
            Err(why) => rejected.extend(why),
        }
    }
    Ok(Err(rejected))
}
