//! Cutters and holders from the catalogs, and whether they reach.

mod cutter;
mod holder;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::machine::Machine;
use crate::note::{Because, Note};

pub use cutter::{Cutter, CutterNeed, drill_diameters};
pub use holder::Assembly;

/// The first cutter that fits together with a holder that takes it within the machine's overhang.
///
/// # Errors
/// The knowledge cannot answer. That nothing fits is not an error: the inner `Err` says why each did not.
pub fn find_tool<'k>(
    need: &CutterNeed<'_>,
    knowledge: &'k Knowledge,
    machine: &Machine<'_>,
) -> Result<Result<(Cutter<'k>, Assembly), Vec<Note>>, KnowledgeError> {
    let (cutters, mut rejected) = cutter::cutters(need, knowledge, machine)?;
    for cutter in cutters {
        match holder::assemble(&cutter, need, knowledge, machine)? {
            Ok(assembly) => {
                let because = Because { rejected, ..cutter.because.clone() };
                return Ok(Ok((Cutter { because, ..cutter }, assembly)));
            }
            Err(why) => rejected.extend(why.into_iter().map(|note| note.with("tool", cutter.designation))),
        }
    }
    Ok(Err(rejected))
}
