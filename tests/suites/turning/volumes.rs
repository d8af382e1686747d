//! What the programs remove, read back and carried through the proof, beside blank less part as the drawing has them: the
//! profiles are integrated here, piece by piece, by nothing that planner or proof use.

use std::f64::consts::PI;

use proptest::prelude::*;
use technolog::audit::turned::swept;
use technolog::turning::contour::{Curve, Piece, Profile, Side, Surface, SurfaceKind, Turn};
use technolog::turning::jobs::Work;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::operation::{Operation, SizeOf};
use technolog::turning::workpiece::read_turned;
use technolog::units::RevsPerMinute;
use technolog_testing::{KNOWLEDGE, turned};
use technolog_turning_proof::{Mm, Stock};

use crate::operation::planned;

/// Volumes in mm³, over the length of the part without its threads, whose form the proof does not keep.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Removed {
    /// Of the blank less that of the part.
    pub wanted: f64,
    /// What stands over the part in the end; negative where more was taken.
    pub left: f64,
    /// What of it the round noses leave in the corners.
    pub corners: f64,
}

impl Removed {
    /// By how much of what is to be removed it differs.
    pub fn differs(&self) -> f64 {
        (self.left - self.corners).abs() / self.wanted.max(1.0)
    }
}

/// Stretches along the axis, from the free end towards the chuck, mm.
type Stretches = Vec<(f64, f64)>;

/// The volume between the axis and a line of a meridian, of what lies in the stretches; negative towards the free end.
fn frustum((z0, r0): (f64, f64), (z1, r1): (f64, f64), stretches: &Stretches) -> f64 {
    let (low, high) = (z0.min(z1), z0.max(z1));
    let at = |z: f64| r0 + (r1 - r0) * (z - z0) / (z1 - z0);
    let of = |(from, to): &(f64, f64)| {
        let (from, to) = (from.max(low), to.min(high));
        if to <= from { 0.0 } else { (to - from) * PI / 3.0 * (at(from).powi(2) + at(from) * at(to) + at(to).powi(2)) }
    };
    stretches.iter().map(of).sum::<f64>() * (z1 - z0).signum()
}

/// The places of a piece, an arc in chords of a thousandth of it.
fn places(piece: &Piece) -> Vec<(f64, f64)> {
    let (from, to) = ((piece.from.z.to_mm(), piece.from.radius.to_mm()), (piece.to.z.to_mm(), piece.to.radius.to_mm()));
    let Curve::Arc { radius, turn } = piece.curve else { return vec![from, to] };
    let (dz, dr) = (to.0 - from.0, to.1 - from.1);
    let (chord, r) = (dz.hypot(dr), radius.to_mm());
    let height = (r * r - chord * chord / 4.0).max(0.0).sqrt() * if turn == Turn::Left { 1.0 } else { -1.0 };
    let centre = ((from.0 + to.0) / 2.0 - dr / chord * height, (from.1 + to.1) / 2.0 + dz / chord * height);
    let begin = (from.1 - centre.1).atan2(from.0 - centre.0);
    let mut sweep = (to.1 - centre.1).atan2(to.0 - centre.0) - begin;
    if turn == Turn::Left && sweep < 0.0 {
        sweep += 2.0 * PI;
    } else if turn == Turn::Right && sweep > 0.0 {
        sweep -= 2.0 * PI;
    }
    let place = |at: u32| {
        let angle = begin + sweep * f64::from(at) / 1000.0;
        (centre.0 + r * angle.cos(), centre.1 + r * angle.sin())
    };
    (0..=1000).map(place).collect()
}

fn under<'a>(pieces: impl IntoIterator<Item = &'a Piece>, stretches: &Stretches) -> f64 {
    let of = |piece: &Piece| places(piece).windows(2).map(|two| frustum(two[0], two[1], stretches)).sum::<f64>();
    pieces.into_iter().map(of).sum()
}

/// A surface as it is left: fits in the middle of their limits, and with what another machine takes off.
fn as_left(surface: &Surface, side: Side, operation: &Operation) -> Vec<Piece> {
    let sized = operation.sizes.of_surface(&surface.name).filter(|sized| sized.of == SizeOf::Diameter);
    let later = operation.elsewhere.iter().find(|one| one.surface == surface.name);
    let mut pieces = surface.pieces.clone();
    for piece in pieces.iter_mut().filter(|piece| piece.is_cylinder()) {
        let mut radius = piece.from.radius;
        if let Some(sized) = sized {
            radius = technolog::turning::length::Half::from((sized.least_mm.to_mm() + sized.most_mm.to_mm()) / 4.0);
        }
        if let Some(later) = later {
            radius = if side == Side::Outer { radius + later.allowance_mm } else { radius - later.allowance_mm };
        }
        (piece.from.radius, piece.to.radius) = (radius, radius);
    }
    pieces
}

/// What noses leave in the inner corners of a profile: r²·(cot θ/2 − (π − θ)/2) of the plane in one of θ, turned about the axis.
fn in_corners(profile: &Profile, operation: &Operation, stretches: &Stretches) -> f64 {
    let noses = |surface: &Surface| {
        let mut jobs = operation.set_ups.iter().flat_map(|set_up| &set_up.jobs);
        let job =
            jobs.find(|job| matches!(job.work, Work::Finish | Work::Groove) && job.surfaces.contains(&surface.name));
        job.map_or(0.0, |job| job.tool.nose_radius().to_mm())
    };
    let all: Vec<(&Piece, f64)> =
        profile.surfaces.iter().flat_map(|one| one.pieces.iter().map(move |piece| (piece, noses(one)))).collect();
    let corner = |two: &[(&Piece, f64)]| {
        let (z, radius) = (two[1].0.from.z.to_mm(), two[1].0.from.radius.to_mm());
        let (a, b) = (two[0].0.direction_at_end().unit(), two[1].0.direction_at_start().unit());
        let turn = if profile.side == Side::Outer { a.cross(b) } else { b.cross(a) };
        let inside = stretches.iter().any(|(from, to)| (*from..=*to).contains(&z));
        if turn < 1e-6 || !inside {
            return 0.0;
        }
        let theta = PI - turn.atan2(a.dot(b));
        let r = two[0].1.max(two[1].1);
        r * r * (1.0 / (theta / 2.0).tan() - (PI - theta) / 2.0) * 2.0 * PI * radius
    };
    all.windows(2).map(corner).sum()
}

/// What the programs of a part remove; none where one is not written or not read.
pub(crate) fn removed(operation: &Operation) -> Option<Removed> {
    let length = operation.workpiece.length().to_mm();
    let mut read = operation.clone();
    let rpm = operation.workpiece.machine.is_none().then_some(RevsPerMinute(500.0));
    for written in programs(operation, "linuxcnc", Form::Motions, rpm, &KNOWLEDGE).unwrap() {
        let proven = swept(&read, written.set_up, "linuxcnc", &written.files.ok()?, &KNOWLEDGE).unwrap()?;
        let place = read.proven.iter().position(|one| one.set_up == written.set_up)?;
        read.proven[place] = proven;
    }
    let left: &Stock = &read.proven.last()?.proof.as_ref().ok()?.left;
    let over = read.set_ups.last()?.set_up.turned_over;
    let left = if over { left.turned_over(Mm(length)) } else { left.clone() };
    let part = &operation.workpiece;
    let mut stretches: Stretches = vec![(-1000.0, length)];
    for profile in [Some(&part.outer), part.inner.as_ref()].into_iter().flatten() {
        for at in (0..profile.surfaces.len()).filter(|at| profile.surfaces[*at].kind == SurfaceKind::Thread) {
            let behind = profile.surfaces.get(at + 1).filter(|next| next.kind.is_additional());
            let pieces = || profile.surfaces[at].pieces.iter().chain(behind.iter().flat_map(|next| &next.pieces));
            let ends = || pieces().flat_map(|piece| [piece.from.z.to_mm(), piece.to.z.to_mm()]);
            let (from, to) = (ends().fold(f64::MAX, f64::min) - 3.0, ends().fold(f64::MIN, f64::max) + 3.0);
            let cut = |(low, high): (f64, f64)| [(low, high.min(from)), (low.max(to), high)];
            stretches = stretches.into_iter().flat_map(cut).filter(|(low, high)| high > low).collect();
        }
    }
    let solid = |outer: &[Piece], inner: Option<&[Piece]>| {
        under(outer, &stretches) - inner.map_or(0.0, |inner| under(inner, &stretches))
    };
    let pieces = |profile: &Profile| {
        profile.surfaces.iter().flat_map(|surface| as_left(surface, profile.side, operation)).collect::<Vec<_>>()
    };
    let finished = solid(&pieces(&part.outer), part.inner.as_ref().map(pieces).as_deref());
    let blank = solid(&part.blank.outer.pieces, part.blank.inner.as_ref().map(|inner| inner.pieces.as_slice()));
    let stands: f64 = left
        .outlines()
        .iter()
        .flat_map(|outline| outline.iter().zip(outline.iter().cycle().skip(1)))
        .map(|(a, b)| frustum((-a.z.0, a.radius.0), (-b.z.0, b.radius.0), &stretches))
        .sum();
    let corners = [Some(&part.outer), part.inner.as_ref()].into_iter().flatten();
    let corners = corners.map(|profile| in_corners(profile, operation, &stretches)).sum();
    Some(Removed { wanted: blank - finished, left: stands - finished, corners })
}

/// The parts that must come out whole, to 0.1 % of what is removed.
#[test]
fn programs_remove_blank_less_part() {
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/turned-whole")).unwrap() {
        let path = entry.unwrap().path();
        let operation = planned(&read_turned("part", &std::fs::read_to_string(&path).unwrap(), &KNOWLEDGE).unwrap());
        let Some(removed) = removed(&operation) else { panic!("{}: a program is not read", path.display()) };
        assert!(removed.differs() < 0.001, "{}: {removed:?}", path.display());
    }
}

proptest! {
    #![proptest_config(technolog_laws::cases!(30))]

    #[test]
    fn programs_of_any_whole_part_remove_blank_less_part(draft in turned::drafts()) {
        let read = read_turned("part", &draft.text(), &KNOWLEDGE);
        prop_assume!(read.is_ok());
        let operation = planned(&read.unwrap());
        prop_assume!(!operation.has_errors());
        if let Some(removed) = removed(&operation) {
            prop_assert!(removed.differs() < 0.001, "{:?}", removed);
        }
    }
}
