//! The finished part as the proof sees it: the contour that a set-up must make, with its allowances and threads.

use technolog_turning_proof as proof;

use crate::note::IntoFigure;
use crate::turning::contour::{Piece, Profile, Surface, SurfaceKind};
use crate::turning::jobs::Body;
use crate::turning::jobs::hole::point_length;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::units::Micrometres;
use proof::{At, Mm};

use super::super::{Operation, SetUpWork, SizeOf};
use super::{ROUNDING, proof_piece};

/// The required profile after a set-up. After the last one it is the whole part, seen from its free end; before that
/// the range that the set-up turns, beside which no later set-up puts metal back: the whole part comes second.
pub(super) fn profiles(operation: &Operation, set_up: &SetUpWork) -> (proof::Profile, Option<proof::Profile>) {
    let workpiece = &operation.workpiece;
    let last = operation.set_ups.last().is_some_and(|last| last.set_up.number == set_up.set_up.number);
    let over = set_up.set_up.turned_over;
    let made = |profile: &Profile| operation.sizes.profile(profile, over);
    let seen = |profile: &Profile| made(&if over { profile.turned_over(workpiece.length()) } else { profile.clone() });
    let whole = profile(Some(&seen(&workpiece.outer)), workpiece.inner.as_ref().map(seen).as_ref(), over, operation);
    if last {
        return (whole, None);
    }
    let own = |side: &'_ Option<crate::turning::zones::TurnedSide>| side.as_ref().map(|side| made(&side.profile));
    let (outer, inner) = (own(&set_up.set_up.outer), own(&set_up.set_up.inner));
    (profile(outer.as_ref(), inner.as_ref(), over, operation), Some(whole))
}

fn profile(outer: Option<&Profile>, inner: Option<&Profile>, over: bool, operation: &Operation) -> proof::Profile {
    let pieces = |profile: &Profile| {
        (0..profile.surfaces.len()).flat_map(|at| surface_pieces(profile, at, over, operation)).collect()
    };
    let bore: Vec<proof::ProfilePiece> = inner.map(pieces).unwrap_or_default();
    let mut outside: Vec<proof::ProfilePiece> = outer.map(pieces).unwrap_or_default();
    // The file may leave out the face of the end.
    let within = bore.first().map_or(Mm(0.0), |first| first.path.from().radius);
    if let Some(first) = outside.first().map(|first| first.path.from()).filter(|first| first.radius.0 > within.0) {
        let face = proof::Piece::Line { from: At::new(first.z, within), to: first };
        outside.insert(0, proof::ProfilePiece::new(face, None));
    }
    proof::Profile { outside, bore }
}

fn surface_pieces(profile: &Profile, at: usize, over: bool, operation: &Operation) -> Vec<proof::ProfilePiece> {
    let surface = &profile.surfaces[at];
    let later = operation.elsewhere.iter().find(|one| one.surface == surface.name);
    let sized = operation.sizes.of_surface(&surface.name);
    let limits = |piece: &Piece| {
        let sized = sized.filter(|sized| match sized.of {
            SizeOf::Diameter => piece.is_cylinder() && piece.from.radius == sized.made_radius(),
            SizeOf::Length => piece.is_face(),
        })?;
        let size = match sized.of {
            SizeOf::Diameter => proof::Size::Diameter,
            SizeOf::Length if over => {
                proof::Size::Length { from: Mm(-operation.workpiece.length().to_mm()), to_chuck: false }
            }
            SizeOf::Length => proof::Size::Length { from: Mm(0.0), to_chuck: true },
        };
        Some(proof::Limits { size, least: Mm(sized.least_mm.to_mm()), most: Mm(sized.most_mm.to_mm()) })
    };
    let thread = (surface.kind == SurfaceKind::Thread).then(|| thread(profile, at, operation)).flatten();
    let piece = |piece: &Piece| proof::ProfilePiece {
        path: proof_piece(piece),
        surface: Some((&surface.name).into_figure()),
        allowance: Mm(later.map_or(0.0, |one| one.allowance_mm.to_mm())),
        thread,
        limits: limits(piece),
    };
    // A drawn cone at the bottom of a drilled hole stands for the point of the drill, whatever its angle.
    let axial = operation.set_ups.iter().filter_map(|set_up| set_up.axial.as_ref());
    if axial.into_iter().any(|axial| axial.is_point(&surface.name)) {
        return surface.pieces.iter().map(|one| piece(&as_drilled(one))).collect();
    }
    surface.pieces.iter().map(piece).collect()
}

/// A cone to the axis as the point of a drill leaves it.
fn as_drilled(cone: &Piece) -> Piece {
    let tip = |wall: Point, axis: Point| {
        let length = point_length(wall.radius);
        Point { z: if axis.z > wall.z { wall.z + length } else { wall.z - length }, ..axis }
    };
    match (cone.from.radius, cone.to.radius) {
        (_, Half::ZERO) => Piece::line(cone.from, tip(cone.from, cone.to)),
        (Half::ZERO, _) => Piece::line(tip(cone.to, cone.from), cone.to),
        _ => *cone,
    }
}

/// The crests of a thread are its surface as it is turned. Its passes must come between the limits of the pitch diameter: the
/// tip of a pass lies H/2 − r = √3/4 · P − r beyond the pitch line that it makes, with the nose radius r of the tool.
fn thread(profile: &Profile, at: usize, operation: &Operation) -> Option<proof::Thread> {
    let surface = &profile.surfaces[at];
    let thread = operation.workpiece.thread_on(&surface.name)?;
    let crest = surface.pieces.first()?.from.radius.to_mm();
    let inside = crest < thread.size.to_mm() / 2.0 - 1e-6;
    let basic = thread.basic_pitch_diameter();
    let (least, most) = thread.flanks.as_ref().map_or((basic, basic), |limits| (limits.least, limits.most));
    let beyond = libm::sqrt(3.0) / 4.0 * thread.pitch.to_mm() - threading_nose(surface, operation);
    let tip = |pitch_diameter: Micrometres, outwards: f64| pitch_diameter.to_mm() / 2.0 + outwards * beyond;
    let (shallow, root) = if inside {
        (tip(least, 1.0) - ROUNDING, tip(most, 1.0) + ROUNDING)
    } else {
        (tip(most, -1.0) + ROUNDING, tip(least, -1.0) - ROUNDING)
    };
    // It is drawn at the nominal diameter and turned to the middle of what its tolerance leaves.
    let turned = thread.crests.as_ref().map_or(crest, |crests| crests.middle_radius().to_mm());
    let run_out = Mm(run_out(profile, at, thread.longest_run_out));
    let mm = |length: Micrometres| Mm(length.to_mm());
    let tap = thread.tapped.as_ref().map(|tapped| proof::TapLimits {
        diameter: mm(thread.size),
        pitch: mm(thread.pitch),
        largest_hole: mm(tapped.largest_hole_mm),
        run_out: mm(tapped.run_out_mm),
    });
    Some(proof::Thread {
        crest: Mm(turned),
        shallow: Mm(shallow),
        root: Mm(root),
        pitch: mm(thread.pitch),
        run_out,
        tap,
    })
}

/// How far a thread may cut into the metal behind it: as the standard allows, but not into a seat, mm.
fn run_out(profile: &Profile, at: usize, longest: Option<Micrometres>) -> f64 {
    /// The coarsest grade of a seat.
    const SEAT: u8 = 9;
    let Some(longest) = longest.map(Micrometres::to_mm) else { return 0.0 };
    let Some(end) = profile.surfaces[at].pieces.last().map(|last| last.to.z.to_mm()) else { return 0.0 };
    let mut behind = profile.surfaces.iter().skip(at + 1);
    let seat = behind.find(|next| next.grade.is_some_and(|grade| grade.number() <= SEAT));
    let seat = seat.and_then(|seat| seat.pieces.first()).map(|first| (first.from.z.to_mm() - end).abs());
    seat.map_or(longest, |seat| seat.min(longest))
}

/// The nose radius of the tool that cuts a thread, mm; a sharp point where none does.
fn threading_nose(surface: &Surface, operation: &Operation) -> f64 {
    let mut jobs = operation.set_ups.iter().flat_map(|work| &work.jobs);
    let job = jobs.find(|job| job.thread.is_some() && job.surfaces.contains(&surface.name));
    match job.map(|job| &job.tool.body) {
        Some(Body::Insert { nose_radius_mm, .. }) => nose_radius_mm.to_mm(),
        _ => 0.0,
    }
}
