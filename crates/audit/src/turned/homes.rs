//! Ways home: where both axes leave at once, which way the tool takes is known to nobody but the machine.

use technolog_turning_proof::{At, Block, Mm, Motion, MotionKind, Piece};

use crate::note::{Figure, Note, Severity};
use crate::program::Fault;
use crate::program::lathe::{LatheAct, LatheMotion};
use crate::turning::operation::proof::{Proven, prove_set_up, told_of_program};
use crate::turning::operation::{Operation, SetUpWork};

use super::{FAR, fault};

/// What the tool would meet if one of both axes went first, each block once: doubtful, because home and the rates of the drives are
/// not known. What it meets on the straight way is told by the proof itself.
pub(super) fn homes(
    operation: &Operation,
    work: &SetUpWork,
    run: &[LatheMotion],
    motions: &[Motion],
    proven: &Proven,
) -> Vec<Fault> {
    let both = |one: &&LatheMotion| {
        let leaves = one.to.radius_mm.is_none() && one.to.z_mm.is_none();
        one.act == LatheAct::Away && leaves && one.from.point().is_some()
    };
    let blocks: Vec<Block> =
        run.iter().filter(both).map(|one| Block(usize::try_from(one.line).unwrap_or(usize::MAX))).collect();
    if blocks.is_empty() {
        return Vec::new();
    }
    let known = |block: Block| {
        let proof = proven.proof.as_ref().ok();
        proof.is_some_and(|proof| proof.faults.iter().any(|fault| fault.block == Some(block)))
    };
    let mut faults: Vec<Fault> = Vec::new();
    for axis in ["X", "Z"] {
        let mut bent = Vec::new();
        for motion in motions {
            let goes = motion.kind == MotionKind::Rapid && blocks.contains(&motion.block);
            let (from, to) = (motion.path.from(), motion.path.to());
            let leaves = goes && to.z.0 >= FAR && to.radius.0 >= FAR && from.z.0 < FAR && from.radius.0 < FAR;
            if !leaves {
                bent.push(*motion);
                continue;
            }
            let corner = if axis == "X" { At::new(from.z, Mm(FAR)) } else { At::new(Mm(FAR), from.radius) };
            bent.extend(Piece::lines(&[from, corner, to]).into_iter().map(|path| Motion { path, ..*motion }));
        }
        let other = prove_set_up(operation, &operation.proven, work, bent, None);
        let Ok(proof) = &other.proof else { continue };
        for (_, found) in told_of_program(operation, work.set_up.number, proof) {
            let Some(block) = found.block.filter(|block| blocks.contains(block) && !known(*block)) else { continue };
            let line = u32::try_from(block.0).unwrap_or(u32::MAX);
            if faults.iter().any(|known| known.span.line == line) {
                continue;
            }
            let note = Note::new("turned-home-way").with("axis", Figure::Text(axis.into())).with("why", found.note());
            faults.push(fault("turned-home-way", Severity::Doubtful, note, line));
        }
    }
    faults
}
