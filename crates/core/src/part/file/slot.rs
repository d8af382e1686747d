//! A slot as its author writes it.

use schemars::JsonSchema;
use serde::Deserialize;
use technolog_knowledge::forms;

use super::hole::{CentreTolerance, Diameter, RoughnessText};
use super::{Coordinate, Direction, Name, Size};

forms! {
    /// A straight slot with round ends, or with `corner` a rectangular pocket. It is closed on all sides, but where it is `open`.
    #[schemars(extend("oneOf" = [{"required": ["from", "to"]}, {"required": ["centre", "length"]}]))]
    #[schemars(extend("anyOf" = [{"required": ["depth"]}, {"required": ["through"]}]))]
    pub struct Slot {
        /// Name of the slot, unique among the holes and slots of the part.
        pub name: Name,
        /// The middle of one end radius, `[X, Y]`, mm.
        pub from: Option<[Coordinate; 2]>,
        /// The middle of the other.
        pub to: Option<[Coordinate; 2]>,
        /// Which of the two ends is open at an edge of the blank: its point is then where the middle of the slot leaves the blank.
        pub open: Option<Open>,
        /// The middle of the slot, `[X, Y]`, mm, instead of `from` and `to`.
        pub centre: Option<[Coordinate; 2]>,
        /// Its length over all, with both end radii, mm; with `centre`.
        pub length: Option<Size>,
        /// The direction it lies in, degrees counter-clockwise from +X; 0 unless said; with `centre`.
        pub angle: Option<Direction>,
        /// Width with its tolerance, as the diameter of a hole: `12H12`, `14` for a free size (grade 13).
        pub width: Diameter,
        /// Of a rectangular pocket the radius of its corners, mm, less than half of its width; with `centre` and `length`. Without it
        /// the ends are round.
        pub corner: Option<Size>,
        /// Depth from the entry face, mm; of a slot that goes through it may be left out.
        pub depth: Option<Size>,
        /// Whether it goes through; `false` unless said.
        pub through: Option<bool>,
        /// Roughness limit of its walls, micrometres, as of a hole.
        pub roughness: RoughnessText,
        /// Full width of the tolerance on its position, mm, up to 10.
        pub centre_tolerance: CentreTolerance,
    }
}

/// Which end of a slot is open.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Open {
    /// That of `from`.
    From,
    /// That of `to`.
    To,
    /// Both: the slot goes across the part.
    Both,
}
