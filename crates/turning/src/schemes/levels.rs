//! The levels over a stepped shaft (lecture 12.4, l. 576-660): those of any zone ([`Split`]), with the walls at the ends of
//! its cylinders.
//!
//! The blank may be stepped too. Then the zone is divided into sections, each under one diameter of the blank (fig. 12.10),
//! and the schemes work one section after the other from the free end.

use serde::Serialize;

use crate::turning::length::{Half, as_diameter, negative_z};
use crate::turning::transitions::split::Split;
use crate::turning::workpiece::Workpiece;
use crate::units::Micrometres;

/// A cylinder of the rough contour under one diameter of the blank, and the stock over it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Cylinder {
    /// Its radius after roughing.
    #[serde(rename = "diameter_mm", serialize_with = "as_diameter")]
    pub radius: Half,
    /// The radius of the blank over it.
    #[serde(rename = "blank_diameter_mm", serialize_with = "as_diameter")]
    pub blank: Half,
    /// Z of its beginning, from the free end towards the chuck.
    #[serde(rename = "from_z_mm", serialize_with = "negative_z")]
    pub from: Half,
    /// Z of its end: the vertical there.
    #[serde(rename = "to_z_mm", serialize_with = "negative_z")]
    pub to: Half,
    /// tᵢ, radial.
    #[serde(rename = "stock_mm")]
    pub stock: Half,
    /// nᵢ: the fewest passes that the limiting depth allows.
    pub passes: i64,
    /// The mean depth tᵢ / nᵢ, rounded up.
    #[serde(rename = "mean_depth_mm")]
    pub mean: Half,
    /// The radius of the top of the face at its end, if there is a face: a shoulder of the rough contour, or the bar in the
    /// chuck after the last cylinder.
    #[serde(skip)]
    pub wall: Option<Half>,
}

/// The rough zone with its one depth.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Levels {
    /// The limiting depth t_lim.
    #[serde(rename = "limiting_depth_mm")]
    pub limit: Half,
    /// The one depth t_p of all passes.
    #[serde(rename = "depth_mm")]
    pub depth: Half,
    /// The cylinders with stock from the free end, in each section each larger than the one before.
    pub cylinders: Vec<Cylinder>,
}

impl Levels {
    /// The levels of a stepped workpiece for a limiting depth.
    pub fn of(workpiece: &Workpiece, limit: Micrometres) -> Self {
        let (rough, blank) = (workpiece.outer.contour(), &workpiece.blank.outer);
        let limit = Half::of(limit);
        let Split { depth, sections } = Split::of(&rough, blank, limit);
        let top = |z: Half| {
            let beyond = z + Half::new(1);
            let bar = blank.near(beyond, beyond).radii_at(beyond).filter(|_| rough.end().is_some_and(|end| end.z == z));
            [rough.near(z, z).radii_at(z), bar].into_iter().flatten().map(|(_, most)| most).max()
        };
        let stocks = sections.iter().flat_map(|section| section.stocks.iter().map(|stock| (section.top, stock)));
        let cylinders = stocks.map(|(blank, stock)| Cylinder {
            radius: stock.deepest,
            blank,
            from: stock.from,
            to: stock.to,
            stock: stock.stock,
            passes: stock.passes,
            mean: stock.mean,
            wall: top(stock.to).filter(|top| *top > stock.deepest),
        });
        Self { limit, depth, cylinders: cylinders.collect() }
    }

    /// The cylinders of each section, from the free end.
    pub fn sections(&self) -> impl Iterator<Item = &[Cylinder]> {
        self.cylinders.chunk_by(|one, next| one.blank == next.blank)
    }

    /// The radius of a horizontal over a cylinder, from 1; 0 is the surface of the blank.
    pub fn horizontal(&self, cylinder: &Cylinder, level: i64) -> Half {
        cylinder.blank - Half::new(self.depth.halves().saturating_mul(level))
    }

    /// The number of levels over a cylinder, the last perhaps thinner: ⌈tᵢ / t_p⌉.
    pub fn count(&self, cylinder: &Cylinder) -> i64 {
        cylinder.stock.parts(self.depth)
    }

    /// The number of levels of the full depth over a cylinder: ⌊tᵢ / t_p⌋.
    pub fn full(&self, cylinder: &Cylinder) -> i64 {
        cylinder.stock.halves() / self.depth.halves().max(1)
    }
}
