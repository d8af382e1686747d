//! What the operation leaves undone, and where its paths would spoil the part. Each is a finding of severity wrong: a
//! plan that is not whole must not pass for one that is.

use crate::note::{Finding, Note, Severity};
use crate::turning::contour::{Curve, Piece, Side, Surface, SurfaceKind, Turn};
use crate::turning::elements::Element;
use crate::turning::length::Half;
use crate::turning::point::Vector;
use crate::turning::shaft::Holding;
use crate::turning::toolpath::Toolpath;

use super::work::ZoneWork;
use super::{Operation, SetUpWork, SideWork};

/// What of the part is not made, and what would be spoilt.
pub(super) fn unfinished(operation: &Operation) -> Vec<Finding> {
    let mut findings = Vec::new();
    for set_up in &operation.set_ups {
        for side in &set_up.sides {
            findings.extend(left_undone(set_up, side));
            findings.extend(gouges(set_up, side));
        }
    }
    if operation.workpiece.holding == Holding::Centres {
        for (set_up, _, zone) in operation.zones().filter(|(_, side, zone)| runs_into_centre(side, zone)) {
            let number = format!("{}.{}", set_up.set_up.number, zone.zone.number);
            let note = Note::new("faced-through-centre").with("zone", number);
            findings.push(Finding::of_part(Severity::Wrong, note));
        }
    }
    findings
}

/// Surfaces that keep their allowance, and threads and grooves that nothing cuts.
fn left_undone(set_up: &SetUpWork, side: &SideWork) -> Vec<Finding> {
    let surfaces = surfaces(set_up, side);
    let undone = surfaces.filter_map(|(surface, _, allowance)| {
        let code = match surface.kind {
            SurfaceKind::Thread => "thread-not-cut",
            kind if kind.is_additional() => "groove-not-cut",
            // Without an allowance the rough contour is the part.
            _ if allowance == Some(Half::ZERO) => return None,
            _ => "surface-not-finished",
        };
        Some(Finding::of_part(Severity::Wrong, Note::new(code).with("surface", &surface.name)))
    });
    undone.collect()
}

/// Main surfaces that fall so steeply that the round nose, led along the path of its theoretical point, cuts below the
/// finished part.
fn gouges(set_up: &SetUpWork, side: &SideWork) -> Vec<Finding> {
    let noses = side.zones.iter().filter_map(|zone| zone.tool.as_ref()?.nose_radius_mm);
    let Some(nose) = noses.min().map(Half::of) else { return Vec::new() };
    let gouged = surfaces(set_up, side).filter_map(|(surface, is_main, allowance)| {
        let depths = surface.pieces.iter().map(|piece| gouge(*piece, side.side, nose, allowance.unwrap_or(Half::ZERO)));
        let deepest = depths.max().filter(|depth| is_main && *depth > Half::ZERO)?;
        let note = Note::new("nose-gouges").with("surface", &surface.name).with("nose", nose).with("depth", deepest);
        Some(Finding::of_part(Severity::Wrong, note))
    });
    gouged.collect()
}

/// The surfaces of a side: whether each is a main element, and its finishing allowance.
fn surfaces<'a>(set_up: &'a SetUpWork, side: &'a SideWork) -> impl Iterator<Item = (&'a Surface, bool, Option<Half>)> {
    let stretch = match side.side {
        Side::Outer => set_up.set_up.outer.as_ref(),
        Side::Inner => set_up.set_up.inner.as_ref(),
    };
    let known = stretch.into_iter().flat_map(|stretch| stretch.profile.surfaces.iter().zip(&stretch.classes));
    let allowances = side.layers.allowances.iter().map(|one| one.allowance_mm).chain(std::iter::repeat(None));
    known.zip(allowances).map(|((surface, class), allowance)| (surface, class.element == Element::Main, allowance))
}

/// How deep the nose cuts below a piece of the part when its theoretical point follows the piece at the allowance. The
/// centre of the nose is one radius behind that point and one radius off the metal; along a line that falls by β it is
/// r·(cos β − sin β) off the path. A fall is steepest at an end of a piece, because arcs bend to one side.
fn gouge(piece: Piece, side: Side, nose: Half, allowance: Half) -> Half {
    let (nose, allowance) = (nose.to_mm(), allowance.to_mm());
    let below = |direction: Vector| {
        let along = direction.unit();
        let fall = if side == Side::Outer { -along.radius } else { along.radius };
        if fall <= 0.0 || along.z < 0.0 {
            return 0.0;
        }
        let off = nose * (along.z - fall);
        match piece.curve {
            Curve::Line => nose - off - allowance,
            Curve::Arc { radius, turn } => {
                let radius = radius.to_mm();
                let is_convex = (turn == Turn::Right) == (side == Side::Outer);
                // From the centre of the arc to the path, away from the metal; of a hollow the other way.
                let path = if is_convex { radius + allowance } else { allowance - radius };
                let centre = libm::sqrt(path * path + 2.0 * path * off + 2.0 * nose * nose);
                if is_convex { radius + nose - centre } else { centre + nose - radius }
            }
        }
    };
    let deepest = below(piece.direction_at_start()).max(below(piece.direction_at_end()));
    Half::from(deepest.max(0.0))
}

/// Whether the tool of a zone goes to the axis, where the tailstock centre stands.
fn runs_into_centre(side: &SideWork, zone: &ZoneWork) -> bool {
    let paths = zone.works.iter().filter_map(|work| work.transition()).map(|transition| &transition.path);
    side.side == Side::Outer && paths.into_iter().any(reaches_axis)
}

/// Whether a path reaches the axis.
pub(super) fn reaches_axis(path: &Toolpath) -> bool {
    path.moves.iter().any(|one| one.to.radius <= Half::ZERO)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::point::Point;

    fn at(radius: f64, z: f64) -> Point {
        Point { radius: Half::from(radius), z: Half::from(z) }
    }

    /// By hand: r·(1 − cos β + sin β) − a. β = 28.6°, r = 0.8, a = 0.2: 0.8·(1 − 0.8780 + 0.4787) − 0.2 = 0.2806.
    #[test]
    fn a_falling_cone_is_gouged_by_the_nose_and_a_rising_one_is_not() {
        let (nose, allowance) = (Half::from(0.8), Half::from(0.2));
        let falls = Piece::line(at(25.0, 0.0), at(25.0 - 5.4522, 10.0));
        let deep = gouge(falls, Side::Outer, nose, allowance).to_mm();
        assert!((deep - 0.2806).abs() < 0.001, "{deep}");
        let rises = Piece::line(at(20.0, 0.0), at(25.0, 10.0));
        assert_eq!(gouge(rises, Side::Outer, nose, allowance), Half::ZERO);
        // Inside the same line leads away from the metal the other way round.
        assert!(gouge(rises, Side::Inner, nose, allowance) > Half::ZERO);
        assert_eq!(gouge(falls, Side::Inner, nose, allowance), Half::ZERO);
        // Enough allowance covers it.
        assert_eq!(gouge(falls, Side::Outer, nose, Half::from(0.5)), Half::ZERO);
    }

    /// By hand, at the far end of a ball of R 20 that falls there by 30°: the path is on R 20.2, the centre of the nose
    /// 0.8·(cos 30° − sin 30°) = 0.2928 off it: √(20.2² + 2·20.2·0.2928 + 2·0.64) = 20.5229, and 20 + 0.8 less that is
    /// 0.277 mm of metal lost.
    #[test]
    fn a_ball_is_gouged_behind_its_greatest_diameter() {
        let ball = Piece::arc(at(20.0, 20.0), at(20.0 * 0.866_025, 30.0), Half::from(20.0), Turn::Right);
        let deep = gouge(ball, Side::Outer, Half::from(0.8), Half::from(0.2)).to_mm();
        assert!((deep - 0.277).abs() < 0.002, "{deep}");
    }
}
