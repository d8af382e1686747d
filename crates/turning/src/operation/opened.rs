//! The hole that the first set-up leaves open at the far face of the part.

use crate::turning::contour::{Contour, Side};
use crate::turning::jobs::Work as JobWork;
use crate::turning::jobs::hole::point_length;
use crate::turning::length::Half;
use crate::turning::nose::Nose;
use crate::turning::point::Point;
use crate::units::Micrometres;

use super::beyond::leading_on;
use super::{SetUpWork, SideWork};

/// The diameter of the hole that the set-ups before have made as far as the far face of the part; zero where there is none.
pub(super) fn opened(before: &[SetUpWork], length: Half) -> Micrometres {
    let jobs = before.iter().flat_map(|one| &one.jobs).filter(|job| job.side == Side::Inner);
    let drills = jobs.clone().filter_map(|job| {
        let (diameter, tip) = (job.drills()?, job.path.moves.iter().map(|one| one.to.z).max()?);
        (tip - point_length(Half::radius_of(diameter)) >= length).then_some(diameter)
    });
    let is_bored = jobs.clone().any(|job| job.work == JobWork::Finish);
    let sides =
        before.iter().flat_map(|one| &one.sides).filter(|side: &&SideWork| side.side == Side::Inner && is_bored);
    let ends = sides.filter_map(|side| side.layers.left.end()).filter(|end| end.z >= length);
    drills.chain(ends.map(|end| end.radius.diameter())).max().unwrap_or(Micrometres::ZERO)
}

/// A bore that narrows towards the hole that is there, led on into its air as far as a round nose has to go on to leave nothing
/// of the edge: the nose touches the end of a slope of the angle α to the axis with r·(1 − sin α) of its length still before it.
pub(super) fn into_hole(bore: &Contour, opened: Micrometres, nose: Nose) -> Option<Contour> {
    let last = bore.pieces.last().filter(|last| bore.side == Side::Inner && !last.is_face())?;
    let (end, along) = (last.to, last.direction_at_end());
    let narrows = along.radius < 0.0 && along.z > 0.0 && end.radius.diameter() <= opened;
    let by = Half::from(nose.radius.to_mm() * (1.0 + along.radius)) + LITTLE;
    let enough = || end.radius > Half::from(by.to_mm() * -along.radius / along.z);
    (narrows && enough()).then(|| leading_on(bore.clone(), by, along.radius / along.z))
}

/// Rounding of the offset contour.
const LITTLE: Half = Half::new(100);

/// The wall of a hole from one place to another.
pub(super) fn wall(diameter: Micrometres, from: Half, to: Half) -> Contour {
    let radius = Half::radius_of(diameter);
    Contour::through(Side::Inner, &[Point { radius, z: from }, Point { radius, z: to }])
}
