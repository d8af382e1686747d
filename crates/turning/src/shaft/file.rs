//! The short form of the shaft file as its author writes it: half of docs/shaft.schema.json (`workpiece/file.rs` joins
//! it with the contour form), which editors use for completion.
//!
//! These types say which keys there are and what they hold. [`super::read_shaft`] takes the keys from them, and reads the
//! file itself, because it says where every mistake stands.

use schemars::JsonSchema;
use serde::Deserialize;
use technolog_core::part::file::MaterialField;
use technolog_knowledge::forms;

use super::{BlankKind, Division, Holding, Moves};

/// A length above zero, mm, with a decimal point and at most three decimal places.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
pub struct Size(#[schemars(range(min = 0.001, max = 100_000.0))] pub f64);

forms! {
    /// A shaft to be turned by `technolog turn`. All lengths are in mm.
    pub struct ShaftFile {
        /// Name of the shaft.
        pub shaft: String,
        /// The id of a lathe, such as `16k20f3`; without it no speeds and loads are told.
        pub machine: Option<String>,
        /// Material: an id of `technolog table materials` (`steel-45`) or another name of it (`Сталь 45`, `C45`); with its
        /// state `{grade: 40Х, hardness: 250}`.
        pub material: MaterialField,
        /// What it is made from.
        pub blank: Blank,
        /// How it is held; in the chuck unless said.
        pub holding: Option<Holding>,
        /// Its cylinders from the free end towards the chuck, none smaller than the one before it.
        #[schemars(length(min = 1))]
        pub steps: Vec<Step>,
        /// How much one pass takes.
        pub roughing: Roughing,
        /// How fast the tool moves; without it no times are told.
        pub rates: Option<Rates>,
    }

    /// The blank.
    pub struct Blank {
        /// Its kind.
        pub kind: BlankKind,
        /// Its diameter; of a forging or casting that of the cylinder around it.
        pub diameter: Size,
        /// Its length, not less than that of all steps.
        pub length: Size,
        /// Of a forging or casting: its own cylinders from the free end, none smaller than the one before it; behind them it
        /// has its full diameter.
        #[schemars(length(min = 1))]
        pub steps: Option<Vec<Step>>,
    }

    /// A cylinder of the shaft.
    pub struct Step {
        /// Its diameter after roughing.
        pub diameter: Size,
        /// Its length.
        pub length: Size,
    }

    /// How much stock one pass takes.
    pub struct Roughing {
        /// Largest radial depth of a longitudinal pass.
        pub longitudinal_depth: Size,
        /// Largest axial depth of a transverse pass.
        pub transverse_depth: Size,
        /// How stock is divided between shoulders: full depths with the remainder last unless said.
        pub division: Option<Division>,
        /// Which moves passes may make: those of the paper unless said.
        pub moves: Option<Moves>,
    }

    /// How fast the tool moves.
    pub struct Rates {
        /// Feed of longitudinal passes, mm/min.
        pub longitudinal_feed: Size,
        /// Feed of transverse passes, mm/min.
        pub transverse_feed: Size,
        /// Rapid rate, mm/min.
        pub rapid: Size,
        /// How far before the metal the feed begins; 2 unless said.
        pub approach: Option<Size>,
        /// How far the tool draws back after a pass; 0.5 unless said.
        pub retract: Option<Size>,
    }
}
