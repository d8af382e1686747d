//! The limiting depth of cut of lecture 12.4 and the cutting conditions of a transition on a lathe.
//!
//! - [`TurningCut`] is the input: tool, material, lathe and place of a cut;
//! - `laws` makes power laws of depth and speed from the coefficient tables, for one cut and one feed;
//! - `speed` compares the formula of the speed with the speeds used in shops;
//! - [`rough_feed`] and [`finish_feed`] take feeds from their tables;
//! - `ring` is a hollow part pressed by its jaws;
//! - `stiffness` is the deflection of a part in chuck or centres;
//! - `bounds` has the limits of tool and lathe, [`limiting_depth`] the largest depth within all of them;
//! - [`conditions`] is feed, speed, spindle step and forces at a given depth.
//!
//! The planning of contours takes its figures from here and calculates none of them.

mod bounds;
mod conditions;
mod feed;
mod laws;
mod limit;
mod refusal;
mod ring;
mod speed;
pub mod stiffness;

use crate::error::Tried;
use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::reason::Uncut;
use crate::tables::cutting::Surface;
use crate::tables::lathes::LatheQuantity;
use crate::turning::length::Half;
use crate::turning::tooling::{Lathe, Place, TurningTool};
use crate::units::{Decimal, MetresPerMinute, Micrometres, RevsPerMinute};
use technolog_cutting::figures::Asking;

pub use bounds::{Bound, GripLimit, JawLoss, Load, TipLimit, UnknownBound, deepest_edge, floor_bears, pull, tipping};
pub use bounds::{
    bar_clearance, bar_overhang, bar_reaches, jaw_clearance, largest_overhang, least_sensible_depth, soft_jaw_share,
    wall_share,
};
pub use conditions::{BladeForce, TurningConditions, blade_force, conditions, within_part};
pub use feed::{Feed, cuts_back, feed_of_nose, finish_feed, is_nose_bound, rough_feed, unsaid_roughness};
pub use limit::{BoundTold, LimitingDepth, limiting_depth};
pub use refusal::{BarTooLong, CuttingRefusal, FigureOwner, MissingFigure, NonPositive, Process};
pub use ring::PressedRing;
pub use stiffness::{Flexibility, HeldPart, PartSection};

/// A cut: tool, material, lathe and place.
#[derive(Clone, Copy, Debug)]
pub struct TurningCut<'a, 'k> {
    /// Every table.
    pub knowledge: &'k Knowledge,
    /// The lathe.
    pub lathe: &'a Lathe<'k>,
    /// The tool.
    pub tool: &'a TurningTool<'k>,
    /// The material.
    pub material: &'a Material<'k>,
    /// The largest diameter of the cut: the one before an outer cut, the one after an inner cut. The speed is for it.
    pub diameter: Micrometres,
    /// The direction of the feed.
    pub direction: Direction,
    /// The surface of the metal before the cut.
    pub surface: Surface,
    /// The depth of the cut in a bore, from its mouth; none outside, and where it is not known. A bar then has the
    /// largest overhang that `turning-limits` permits.
    pub bore_depth: Option<Micrometres>,
    /// The deflection of the part there; none if it is unknown or does not matter.
    pub part: Option<&'a Flexibility>,
    /// What the jaws hold; none if it is unknown or does not matter.
    pub grip: Option<&'a GripLimit>,
    /// How far before Z 0 the cut begins, on stock that stands there: so much longer is the arm with which it tips the part.
    pub stands_out: Half,
    /// The spindle speed of the pass that the cut is a part of: it turns no faster. None for a cut of its own.
    pub spindle_most: Option<RevsPerMinute>,
}

/// The direction of the feed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Along the axis, Z.
    Longitudinal,
    /// Across the axis, X.
    Transverse,
}

/// The required cutting speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Speed {
    /// The speed for the tool life of `boring-parameters`.
    ForToolLife,
    /// The same, reduced as far as the spindle power requires: the speed of [`conditions`].
    WithinPower,
    /// A speed at the largest diameter.
    Surface(MetresPerMinute),
    /// A spindle speed.
    Spindle(RevsPerMinute),
}

impl<'k> Asking<'k> for TurningCut<'_, 'k> {
    fn knowledge(&self) -> &'k Knowledge {
        self.knowledge
    }

    fn material(&self) -> &Material<'k> {
        self.material
    }
}

impl TurningCut<'_, '_> {
    /// The angle between the cutting edge and the feed, degrees: φ along the axis. In facing the edge behind the tip
    /// cuts, at 90 + φ1 to the feed.
    fn edge_angle(&self) -> Decimal {
        match self.direction {
            Direction::Longitudinal => self.tool.lead_angle,
            Direction::Transverse => {
                Decimal::from_millionths(Decimal::from_int(90).millionths() + self.tool.trail_angle.millionths())
            }
        }
    }

    /// Whether the cut is in a bore.
    fn is_inner(&self) -> bool {
        self.tool.works == Place::Inner
    }

    /// A refusal with the name of the process.
    fn named<T>(&self, tried: Tried<T, MissingFigure>) -> Tried<T, MissingFigure> {
        tried.map_err(|refusal| refusal.map(|lacking| lacking.during(self.process())))
    }

    /// The process whose coefficients apply: turning or grooving.
    fn process(&self) -> Process {
        if self.tool.plunges() { Process::Grooving } else { Process::Turning }
    }

    /// A missing figure in the row of the tool.
    fn tool_lacks(&self, quantity: &str) -> MissingFigure {
        FigureOwner::Tool { tool: self.tool.designation.to_owned(), quantity: quantity.to_owned() }.into()
    }

    /// A missing figure in the record of the lathe.
    fn lathe_lacks(&self, quantity: LatheQuantity) -> MissingFigure {
        FigureOwner::Lathe { lathe: self.lathe.id().to_owned(), quantity: quantity.name().to_owned() }.into()
    }
}

/// A refusal of the tables of cutting conditions as a missing figure.
fn of_tables<T>(tried: Tried<T, Uncut>) -> Tried<T, MissingFigure> {
    tried.map_err(|refusal| refusal.map(|why| FigureOwner::Cutting(why).into()))
}

/// A missing figure as the reason why a cut cannot be calculated.
fn of_figures<T>(tried: Tried<T, MissingFigure>) -> Tried<T, CuttingRefusal> {
    tried.map_err(|refusal| refusal.map(CuttingRefusal::Figure))
}
