//! A pass, and the motion of the tool between two passes.

use serde::Serialize;

use crate::note::Note;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::shaft::Rates;

technolog_knowledge::vocabulary! {
    /// The direction of a pass.
    #[derive(Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum PassDirection {
        /// Along the axis, towards the chuck.
        Longitudinal = "longitudinal",
        /// Across it, towards the axis.
        Transverse = "transverse",
    }
}

impl PassDirection {
    /// The other direction.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Longitudinal => Self::Transverse,
            Self::Transverse => Self::Longitudinal,
        }
    }
}

/// Where a pass begins in the metal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PassStart {
    /// Its direction.
    pub kind: PassDirection,
    /// The point.
    pub at: Point,
}

/// Where a pass has ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PassEnd {
    /// Its direction.
    pub kind: PassDirection,
    /// The point.
    pub at: Point,
}

/// A pass as it is found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pass {
    /// Its direction.
    pub kind: PassDirection,
    /// Where the metal begins.
    pub from: Point,
    /// Where it ends.
    pub to: Point,
    /// The largest depth: radial of a longitudinal pass, axial of a transverse one.
    pub depth: Half,
    /// The rectangles of metal that it removes, each by its corner nearest to axis and free end, and the opposite one.
    pub removed: Vec<(Point, Point)>,
    /// The reason for it.
    pub reason: Note,
}

impl Pass {
    /// Its length in metal.
    pub fn length(&self) -> Half {
        match self.kind {
            PassDirection::Longitudinal => self.to.z - self.from.z,
            PassDirection::Transverse => self.from.radius - self.to.radius,
        }
    }

    /// Where it begins.
    pub const fn start(&self) -> PassStart {
        PassStart { kind: self.kind, at: self.from }
    }

    /// Where it ends.
    pub const fn end(&self) -> PassEnd {
        PassEnd { kind: self.kind, at: self.to }
    }
}

/// The rapids from the end of a pass to the beginning of the next feed. Before the first pass and after the last one
/// the tool is at the home point: off the corner of the bar by the approach on both axes.
///
/// 1. The tool retracts on both axes, off the surface and off the shoulder.
/// 2. If a longitudinal pass begins nearer to the free end, the tool goes there along the axis, then to its radius.
/// 3. Otherwise, and before a transverse pass, and home, it goes out above the stock first, then along the axis, then
///    in.
///
/// No rapid goes through metal: what is beside the end of a pass, towards the free end and outwards, is removed, and
/// the stock never falls towards the chuck.
pub fn legs(
    before: Option<PassEnd>,
    next: Option<PassStart>,
    bar: Half,
    rates: &Rates,
) -> impl Iterator<Item = (Point, Point)> + use<> {
    let (approach, retract) = (Half::of(rates.approach), Half::of(rates.retract));
    let home = Point { radius: bar + approach, z: Half::ZERO - approach };
    let ended = before.map_or(home, |spot| spot.at);
    let free = match before {
        Some(_) => Point { radius: ended.radius + retract, z: ended.z - retract },
        None => home,
    };
    let (to, over) = match next {
        Some(PassStart { kind: PassDirection::Longitudinal, at }) => {
            let to = Point { radius: at.radius, z: at.z - approach };
            let over = if to.z <= free.z { free.radius } else { free.radius.max(to.radius + retract) };
            (to, over)
        }
        Some(PassStart { kind: PassDirection::Transverse, at }) => {
            let to = Point { radius: at.radius + approach, z: at.z };
            (to, free.radius.max(to.radius))
        }
        None => (home, free.radius.max(home.radius)),
    };
    let (out, along) = (Point { radius: over, z: free.z }, Point { radius: over, z: to.z });
    [(ended, free), (free, out), (out, along), (along, to)].into_iter().filter(|(a, b)| a != b)
}
