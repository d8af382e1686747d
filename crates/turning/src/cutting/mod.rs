//! How deep, how fast and with what feed a lathe cuts: the limiting depth of cut of lecture 12.4 and the cutting
//! conditions of a transition.
//!
//! - [`Cut`] says what cuts what on which lathe; everybody here starts from it;
//! - `laws` turns the coefficient tables into power laws of depth and speed, once for a cut and a feed;
//! - [`rough_feed`] and [`finish_feed`] ask the tables of feeds;
//! - `bounds` is what tool and lathe can carry, [`limiting_depth`] the largest depth within all of it;
//! - [`conditions`] is feed, speed, spindle step and forces at a depth that is given.
//!
//! Planning of contours takes its figures from here and computes none.

mod bounds;
mod conditions;
mod feed;
mod laws;
mod limit;
mod refusal;

use crate::error::Tried;
use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::reason::Uncut;
use crate::tables::cutting::Surface;
use crate::tables::lathes::LatheQuantity;
use crate::turning::tooling::{Lathe, Place, TurningTool};
use crate::units::{Decimal, MetresPerMinute, Micrometres, RevsPerMinute};
use technolog_cutting::figures::Asking;

pub use bounds::{Bound, Load, UnknownBound};
pub use conditions::{TurningConditions, conditions};
pub use feed::{Feed, finish_feed, rough_feed};
pub use limit::{BoundTold, LimitingDepth, limiting_depth};
pub use refusal::{CuttingRefusal, FigureOwner, MissingFigure, NonPositive, Process};

/// What cuts what, on which lathe.
#[derive(Clone, Copy, Debug)]
pub struct Cut<'a, 'k> {
    /// Every table.
    pub knowledge: &'k Knowledge,
    /// The lathe.
    pub lathe: &'a Lathe<'k>,
    /// The tool.
    pub tool: &'a TurningTool<'k>,
    /// What is cut.
    pub material: &'a Material<'k>,
    /// The largest diameter that is cut: that before an outer cut, that after an inner one. The speed is meant there.
    pub diameter: Micrometres,
    /// Where the feed goes.
    pub direction: Direction,
    /// The surface of the metal before the cut.
    pub surface: Surface,
}

/// Where the feed goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Along the axis, Z.
    Longitudinal,
    /// Across the axis, X.
    Transverse,
}

/// What the cutting speed is to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Speed {
    /// That at which the tool lasts as long as `boring-parameters` says.
    ForToolLife,
    /// The same, or as much slower as the power of the spindle asks for: how [`conditions`] turns.
    WithinPower,
    /// A speed at the largest diameter.
    Surface(MetresPerMinute),
    /// A spindle speed.
    Spindle(RevsPerMinute),
}

impl<'k> Asking<'k> for Cut<'_, 'k> {
    fn knowledge(&self) -> &'k Knowledge {
        self.knowledge
    }

    fn material(&self) -> &Material<'k> {
        self.material
    }
}

impl Cut<'_, '_> {
    /// The angle between the edge that cuts and the feed, degrees: φ along the axis; across it the edge behind the tip
    /// cuts, which leans back from the feed by 90 + φ1.
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

    /// A refusal that names what was being done.
    fn named<T>(&self, tried: Tried<T, MissingFigure>) -> Tried<T, MissingFigure> {
        tried.map_err(|refusal| refusal.map(|lacking| lacking.during(self.process())))
    }

    /// Which coefficients hold: those of turning, or of grooving.
    fn process(&self) -> Process {
        if self.tool.plunges() { Process::Grooving } else { Process::Turning }
    }

    /// That the row of the tool lacks a figure.
    fn tool_lacks(&self, quantity: &str) -> MissingFigure {
        FigureOwner::Tool { tool: self.tool.designation.to_owned(), quantity: quantity.to_owned() }.into()
    }

    /// That the record of the lathe lacks a figure.
    fn lathe_lacks(&self, quantity: LatheQuantity) -> MissingFigure {
        FigureOwner::Lathe { lathe: self.lathe.id().to_owned(), quantity: quantity.name().to_owned() }.into()
    }
}

/// What the tables of cutting conditions refuse, as something that is missing.
fn of_tables<T>(tried: Tried<T, Uncut>) -> Tried<T, MissingFigure> {
    tried.map_err(|refusal| refusal.map(|why| FigureOwner::Cutting(why).into()))
}

/// What is missing, as what keeps a cut from being computed.
fn of_figures<T>(tried: Tried<T, MissingFigure>) -> Tried<T, CuttingRefusal> {
    tried.map_err(|refusal| refusal.map(CuttingRefusal::Figure))
}
