//! Chamfers at the mouths of holes on the axis, which countersinks make.

use crate::error::KnowledgeError;
use crate::tables::turning::part::{AxialHoleFor, AxialWay};
use crate::turning::contour::{Surface, SurfaceKind, SurfaceName};
use crate::turning::jobs::hole::{self, Mouth};
use crate::turning::length::Half;
use crate::turning::operation::tools::Bench;
use crate::units::{Degrees, Micrometres};

/// A chamfer at the mouth of a hole.
#[derive(Clone, Debug)]
pub struct MouthOf {
    pub(super) surface: SurfaceName,
    pub(super) wide: Micrometres,
    pub(super) hole: Micrometres,
    angle: Degrees,
    /// Z where it begins.
    pub(super) face: Half,
    /// The diameter of the bore before it; none at the face of the part.
    within: Option<Micrometres>,
}

impl MouthOf {
    pub(super) fn task(&self, rough_face: Half) -> Mouth {
        let Self { surface, wide, hole, angle, face, within } = self.clone();
        Mouth { wide, hole, angle, face, rough_face, within, surface }
    }
}

/// The chamfer at the mouth of a hole that begins with a surface: at the face of the part, or in a wider bore with a flat bottom where
/// a countersink goes in.
pub(super) fn mouth(
    surfaces: &[Surface],
    index: usize,
    hole: Micrometres,
    bench: &Bench<'_, '_>,
) -> Result<Option<MouthOf>, KnowledgeError> {
    let Some((surface, before)) = surfaces.get(..index).and_then(<[Surface]>::split_last) else { return Ok(None) };
    let [piece] = surface.pieces.as_slice() else { return Ok(None) };
    let along = piece.chord();
    let narrows = !piece.is_face() && !piece.is_cylinder() && piece.to.radius == Half::radius_of(hole);
    let angle = Degrees(2.0 * libm::atan2(-along.radius, along.z).to_degrees());
    let bottom = before.last().and_then(|one| one.pieces.last()).filter(|one| one.is_face() && one.to == piece.from);
    let within = bottom.map(|bottom| bottom.from.radius.diameter());
    if !narrows || angle.0 <= 0.0 || (within.is_none() && !before.is_empty()) {
        return Ok(None);
    }
    let (wide, face) = (piece.from.radius.diameter(), piece.from.z);
    let mouth = MouthOf { surface: surface.name.clone(), wide, hole, angle, face, within };
    // A chamfer at the face that no countersink makes is told as that; a cone is left to a bar.
    let told = before.is_empty() && surface.kind == SurfaceKind::Chamfer;
    let fits = told || hole::has_countersink(&mouth.task(Half::ZERO), bench)?;
    Ok(fits.then_some(mouth))
}

/// The chamfer of a hole that an earlier set-up has made from the other end, where that is all there is of the bore: of a tapped hole, and
/// where no bar enters.
pub(super) fn far_mouth(surfaces: &[Surface], bench: &Bench<'_, '_>) -> Result<Option<MouthOf>, KnowledgeError> {
    let hole = surfaces.last().and_then(|one| one.pieces.last()).map_or(Half::ZERO, |piece| piece.to.radius).diameter();
    if surfaces.len() != 1 || hole <= Micrometres::ZERO {
        return Ok(None);
    }
    let mut threads = bench.workpiece.threads.iter().filter_map(|thread| thread.tapped.as_ref());
    if threads.any(|tapped| tapped.hole_mm == hole) {
        return mouth(surfaces, surfaces.len(), hole, bench);
    }
    let asked = bench.knowledge.ask(&AxialHoleFor { diameter: hole, tapped: false, it: None, roughness: None })?;
    let bored = asked.need(&hole.to_string())?.made == AxialWay::Bored;
    Ok(mouth(surfaces, surfaces.len(), hole, bench)?.filter(|_| !bored))
}
