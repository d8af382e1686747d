//! A stepped shaft as the paper and the lecture have it: cylinders under a blank, and how passes along and across divide the
//! stock over them. It comes of the `steps:` of a file, which the reader of a [`workpiece`](crate::turning::workpiece) also
//! makes a contour of.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::tables::turning::part::StockKind;
use crate::units::{Micrometres, MillimetresPerMinute};

pub use super::reading::Mistake;
pub use crate::tables::turning::part::Holding;

/// A stepped shaft.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Shaft {
    /// Its blank.
    pub blank: Blank,
    /// The cylinders of a stepped blank from the free end, none smaller than the one before it; behind them it has the
    /// diameter of the blank.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub blank_steps: Vec<Step>,
    /// Its cylinders from the free end towards the chuck; no diameter is smaller than the one before it.
    pub steps: Vec<Step>,
    /// The parameters of roughing.
    pub roughing: Roughing,
    /// How fast the tool moves; if absent, no times are calculated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rates: Option<Rates>,
}

/// The blank.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Blank {
    /// Its kind; no tube.
    pub kind: StockKind,
    /// Its diameter, mm; of a forging or casting that of the cylinder around it.
    pub diameter: Micrometres,
    /// Its length, mm; the part beyond the steps stays in the chuck.
    pub length: Micrometres,
}

/// A cylinder of the shaft.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Step {
    /// Its diameter after roughing, mm.
    pub diameter: Micrometres,
    /// Its length, mm.
    pub length: Micrometres,
}

/// The parameters of roughing passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Roughing {
    /// Largest radial depth of a longitudinal pass, mm.
    pub longitudinal_depth: Micrometres,
    /// Largest axial depth of a transverse pass, mm.
    pub transverse_depth: Micrometres,
    /// The division of stock into depths.
    pub division: Division,
    /// The permitted moves of passes.
    pub moves: Moves,
}

technolog_knowledge::vocabulary! {
    /// The division of the stock between two shoulders.
    #[derive(Default, Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum Division {
        /// Full depths, the remainder last.
        #[default]
        Full = "full",
        /// As few equal depths as the largest allows.
        Equal = "equal",
    }

    /// The permitted moves of passes.
    #[derive(Default, Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum Moves {
        /// Those of the paper: a level to the shoulder, or a slice down to the step.
        #[default]
        Basic = "basic",
        /// Passes may stop anywhere on the grid and take less than the full depth.
        Rich = "rich",
    }
}

/// The rates of the tool, and its distances from the metal.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Rates {
    /// Feed of longitudinal passes.
    pub longitudinal_feed: MillimetresPerMinute,
    /// Feed of transverse passes.
    pub transverse_feed: MillimetresPerMinute,
    /// Rapid rate of an axis.
    pub rapid: MillimetresPerMinute,
    /// The distance before the metal where the feed begins, mm.
    pub approach: Micrometres,
    /// The retract on both axes after a pass, mm.
    pub retract: Micrometres,
}
