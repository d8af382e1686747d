//! What of a turned part is gauged, for its norm of time.

use crate::tables::practice::TimeNorm;
use crate::turning::contour::{Surface, SurfaceKind};

use super::Operation;

/// How each cylinder with a grade and each thread of the bore is gauged. No row at hand has a time for outside diameters, and none
/// for a cylinder without a grade.
pub fn gauges(operation: &Operation) -> Vec<TimeNorm> {
    let gauge = |surface: &Surface| match surface.kind {
        SurfaceKind::Thread => Some(TimeNorm::ThreadPlug),
        _ if surface.pieces.iter().all(|piece| piece.is_cylinder()) => surface.grade.map(TimeNorm::plug),
        _ => None,
    };
    // What another machine finishes is gauged there.
    let is_here = |surface: &&Surface| operation.elsewhere.iter().all(|one| one.surface != surface.name);
    let bore = operation.workpiece.inner.iter().flat_map(|inner| &inner.surfaces);
    bore.filter(is_here).filter_map(gauge).collect()
}

/// Whether a cylinder or a thread outside would be gauged, too.
pub fn gauges_outside(operation: &Operation) -> bool {
    operation
        .workpiece
        .outer
        .surfaces
        .iter()
        .any(|surface| surface.grade.is_some() || surface.kind == SurfaceKind::Thread)
}
