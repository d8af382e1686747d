//! The finishing passes of a side: along its main contour, and down into its hollows.

use super::beyond::{leading_on, run_out};
use super::finishing::{Finishing, allowance, needs};
use super::tools::Bench;
use super::work::{Hollow, ZoneWork};
use super::{SideWork, clip, crests, features, thin};
use crate::error::KnowledgeError;
use crate::note::Finding;
use crate::tables::turning::jobs::JobLimit;
use crate::turning::contour::{Contour, Piece, Side, Surface, SurfaceKind};
use crate::turning::elements::Element;
use crate::turning::jobs::Job;
use crate::turning::jobs::along::{along, dip};
use crate::turning::jobs::limits::Limits;
use crate::turning::length::Half;
use crate::turning::point::Vector;
use crate::turning::zones::{SetUp, TurnedSide};

/// The finishing passes along the main contour of a side: one, or the face of the free end separately if no tool both
/// faces and follows the rest. None if there is nothing to finish, or if roughing left stock in the way.
pub(super) fn finish(
    set_up: &SetUp,
    side: &SideWork,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Vec<Job>, KnowledgeError> {
    let standing = &side.layers.rough;
    // At a centre the face is finished before: the tailstock is in front of it.
    let contour = if set_up.centre && side.side == Side::Outer {
        without_face(&side.layers.left)
    } else {
        side.layers.left.clone()
    };
    let contour = worked(as_turned(contour, set_up, bench), side, bench)?;
    if contour.pieces.is_empty() || contour == *standing || !side.zones.iter().all(ZoneWork::is_cleared) {
        return Ok(Vec::new());
    }
    let made = set_up.side(side.side).map(|stretch| main_surfaces(stretch, set_up, bench));
    let surfaces: Vec<&Surface> = made.iter().flatten().collect();
    let face = |surface: &&Surface| {
        surface.kind == SurfaceKind::Face && surface.pieces.iter().all(|piece| piece.from.z == Half::ZERO)
    };
    let faces = contour.start() == side.layers.left.start();
    let as_it_is = |surface: &Surface| thin::is_of_blank(surface, &side.layers.blank);
    let surfaces: Vec<&Surface> =
        surfaces.into_iter().filter(|surface| (faces || !face(surface)) && !as_it_is(surface)).collect();
    let over = |contour, surfaces: Vec<_>| Finishing {
        side: side.side,
        contour,
        standing,
        allowance: allowance(&side.layers, &surfaces),
        allowances: &side.layers.allowances,
        surfaces,
        needs: needs(contour),
    };
    let whole = over(&contour, surfaces.clone());
    let (face_alone, rest) = split_at_face(&contour);
    let parts = if whole.tool(bench)?.is_some() || face_alone.pieces.is_empty() || rest.pieces.is_empty() {
        vec![whole]
    } else {
        let (of_face, others) = surfaces.into_iter().partition(face);
        vec![over(&face_alone, of_face), over(&rest, others)]
    };
    let mut jobs = Vec::new();
    for part in parts {
        jobs.extend(part.job(bench, findings, |seen, standing, clearance| Some(along(seen, standing, clearance)))?);
    }
    Ok(jobs)
}

/// A contour without the cylinders of the blank at its end, led on over them along its slope.
fn worked(contour: Contour, side: &SideWork, bench: &Bench<'_, '_>) -> Result<Contour, KnowledgeError> {
    let worked = thin::worked(contour.clone(), &side.layers.blank);
    if side.layers.drilled_first.is_some() || worked == contour {
        return Ok(contour);
    }
    let Some(along) = worked.pieces.last().map(|last| last.direction_at_end()) else { return Ok(worked) };
    let into_air = if worked.side == Side::Outer { along.radius > 0.0 } else { along.radius < 0.0 };
    if !into_air || along.z <= 0.0 {
        return Ok(worked);
    }
    let by = run_out(&worked, bench)?;
    Ok(leading_on(worked, by, along.radius / along.z))
}

/// What a finishing pass follows behind a hollow, as the nose meets it: as long as it does not fall, and no further than `over_lip` along
/// the axis and up a wall.
fn rising_behind(seen: &Contour, last: Half, over_lip: Half) -> Vec<Piece> {
    let beyond = clip::between(seen, last, last + over_lip);
    let out = |along: Vector| if seen.side == Side::Outer { along.radius } else { -along.radius };
    let rises = |piece: &Piece| {
        [piece.direction_at_start(), piece.direction_at_end()].into_iter().all(|along| out(along) >= -1e-9)
    };
    let top = beyond.start().map(|start| start.radius.off(over_lip, seen.side));
    let mut followed = Vec::new();
    for piece in beyond.pieces.iter().take_while(|piece| rises(piece)) {
        let ends = top.and_then(|top| piece.at_radius(top).first().copied()).filter(|end| *end != piece.from);
        followed.push(piece.between(piece.from, ends.unwrap_or(piece.to)));
        if ends.is_some() {
            break;
        }
    }
    followed
}

/// The finishing passes along a hollow, zone by zone, each with a tool that reaches it.
pub(super) fn finish_hollow(
    set_up: &SetUp,
    side: &SideWork,
    hollow: &Hollow,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Vec<Job>, KnowledgeError> {
    let mut jobs = Vec::new();
    if !hollow.zones.iter().all(ZoneWork::is_cleared) {
        return Ok(jobs);
    }
    let mut limits = Limits::of(bench.knowledge);
    let seam = Half::of(limits.length(JobLimit::HollowSeam)?);
    let over_lip = Half::of(limits.length(JobLimit::HollowOverLip)?);
    let steepest = limits.ratio(JobLimit::HollowSteepest)?;
    let profile = set_up.side(side.side);
    let profile = profile.map(|stretch| bench.sizes.profile(&stretch.profile, set_up.turned_over));
    let profile = profile.as_ref();
    let surfaces: Vec<&Surface> =
        hollow.surfaces.iter().filter_map(|index| profile.and_then(|profile| profile.surfaces.get(*index))).collect();
    let contour = &as_turned(hollow.layers.left.clone(), set_up, bench);
    let (first, last) = hollow.lips;
    let mut from = first;
    for (index, zone) in hollow.zones.iter().enumerate() {
        let is_last = index + 1 == hollow.zones.len();
        let to = if is_last { last } else { zone.zone.to_z };
        let within = |by: Half| ((from - by).max(first), (to + by).min(last));
        let own = within(Half::ZERO);
        let task = Finishing {
            side: side.side,
            contour,
            standing: &side.layers.left,
            surfaces: surfaces.clone(),
            allowance: allowance(&hollow.layers, &surfaces),
            allowances: &hollow.layers.allowances,
            needs: needs(&clip::between(contour, own.0, own.1)),
        };
        let (mut from_z, to_z) = within(seam);
        // Where the contour falls already before the hollow, the pass along the bridge has left the round of its nose there.
        let before = clip::between(contour, first - seam, first);
        let falls = |piece: &Piece| {
            let along = piece.chord().unit();
            let out = if side.side == Side::Outer { along.radius } else { -along.radius };
            out < 0.0 && along.z > steepest
        };
        if index == 0 && !before.pieces.is_empty() && before.pieces.iter().all(falls) {
            from_z = before.start().map_or(first, |start| start.z);
        }
        jobs.extend(task.job(bench, findings, |seen, standing, clearance| {
            let mut followed = clip::between(seen, from_z, to_z);
            if is_last {
                let behind = rising_behind(seen, to_z, over_lip);
                let goes_on = behind.first().map(|first| first.from) == followed.end();
                followed.pieces.extend(behind.into_iter().filter(|_| goes_on));
            }
            Some(dip(&followed, standing, clearance)).filter(|path| !path.moves.is_empty())
        })?);
        from = to;
    }
    Ok(jobs)
}

/// A contour with the cylinders of threads and of fits as turned.
fn as_turned(contour: Contour, set_up: &SetUp, bench: &Bench<'_, '_>) -> Contour {
    let Some(stretch) = set_up.side(contour.side) else { return contour };
    let crests = crests::turned(contour, &features::with_made_before(set_up, &stretch.profile, bench), bench.workpiece);
    bench.sizes.contour(crests, set_up)
}

/// A contour without the face at its free end.
fn without_face(contour: &Contour) -> Contour {
    split_at_face(contour).1
}

/// The face at the beginning of a contour, and the rest.
fn split_at_face(contour: &Contour) -> (Contour, Contour) {
    let (face, rest) = contour.split_at_face();
    let of = |pieces: &[Piece]| Contour { side: contour.side, pieces: pieces.to_vec() };
    (of(face), of(rest))
}

/// The main elements of a turned side, as they are made.
fn main_surfaces(stretch: &TurnedSide, set_up: &SetUp, bench: &Bench<'_, '_>) -> Vec<Surface> {
    let made = bench.sizes.profile(&stretch.profile, set_up.turned_over);
    let both = made.surfaces.into_iter().zip(&stretch.classes);
    both.filter(|(_, class)| class.element == Element::Main).map(|(surface, _)| surface).collect()
}
