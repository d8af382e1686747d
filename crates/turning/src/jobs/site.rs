//! The site of a job: the side of a set-up, and where a tool is clear of all metal.

use crate::error::{Refusal, Tried};
use crate::note::Because;
use crate::turning::contour::{Profile, Side};
use crate::turning::cutting::{Direction, TurningCut, largest_overhang};
use crate::turning::length::Half;
use crate::turning::operation::tools::Bench;
use crate::turning::point::Point;
use crate::turning::tooling::{Lathe, Shank, TurningTool};
use crate::units::Micrometres;

use super::refused::NoJob;

/// The side of a set-up at the beginning of the job: turned to its finished contour, except for the work of the job.
#[derive(Clone, Copy, Debug)]
pub struct Site<'a> {
    /// The finished surfaces from the free end, in the coordinates of the set-up.
    pub profile: &'a Profile,
    /// A clear position: the radius beyond which (in a bore below which) the tool passes, and a Z before the free
    /// face.
    pub clear: Point,
    /// In a bore: how far off the wall a tool passes it.
    pub off: Half,
}

impl Site<'_> {
    /// Outside or inside.
    pub const fn side(&self) -> Side {
        self.profile.side
    }

    /// A clear position for a bar that goes no deeper than a Z: a narrower place behind it is not in its way, and nearer to the
    /// axis its back would meet the other side.
    pub(super) fn clear_before(&self, z: Half) -> Point {
        let walls = self.profile.surfaces.iter().flat_map(|one| &one.pieces).filter(|piece| !piece.is_face());
        let own = walls.filter(|piece| piece.from.z < z).flat_map(|piece| [piece.from.radius, piece.to.radius]);
        match (self.side(), own.min()) {
            (Side::Inner, Some(least)) => Point { radius: self.clear.radius.max(least - self.off), z: self.clear.z },
            _ => self.clear,
        }
    }

    /// The narrowest diameter of a bore from the free end to a Z; an element that begins at that Z does not count.
    pub(super) fn narrowest(&self, to: Half) -> Micrometres {
        let pieces = self.profile.surfaces.iter().flat_map(|surface| &surface.pieces).filter(|piece| piece.from.z < to);
        let places = pieces.flat_map(|piece| piece.extremes().into_iter().chain(piece.at_z(to)));
        let before = places.filter(|place| place.z <= to).map(|place| place.radius);
        before.min().map_or(Micrometres::ZERO, Half::diameter)
    }
}

/// The lathe of the speeds.
pub(super) fn lathe<'a, 'k>(bench: &'a Bench<'_, 'k>) -> Tried<&'a Lathe<'k>, NoJob> {
    bench.lathe.ok_or(Refusal::Not(NoJob::NoLathe))
}

/// A cut into turned metal.
pub(super) fn cut<'a, 'k>(
    tool: &'a TurningTool<'k>,
    diameter: Micrometres,
    direction: Direction,
    bench: &'a Bench<'_, 'k>,
) -> Tried<TurningCut<'a, 'k>, NoJob> {
    bench.cut(tool, diameter, direction).ok_or(Refusal::Not(NoJob::NoLathe))
}

/// The reach of a bar in a bore: from its row, otherwise by the ratio of `turning-limits` to its diameter. None for a
/// tool without a bar.
pub(super) fn bar_reach(tool: &TurningTool<'_>, bench: &Bench<'_, '_>) -> Tried<Option<(Half, Because)>, NoJob> {
    let most = largest_overhang(tool, bench.knowledge)?.filter(|_| matches!(tool.shank, Some(Shank::Round { .. })));
    Ok(most.map(|(most, because)| (Half::of(most), because)))
}
