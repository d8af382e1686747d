//! Splitting the rough zone of a stepped shaft into levels, by lecture 12.4 (l. 576-660).
//!
//! 1. The stock over a cylinder is tᵢ = X(blank) − X(cylinder) (a, l. 608).
//! 2. It needs at least nᵢ = ⌈tᵢ / t_lim⌉ passes (b, l. 614).
//! 3. Their mean depth is tᵢ / nᵢ (c, l. 628).
//! 4. The largest mean depth becomes the one depth t_p of the whole zone (d, l. 640). No mean depth is above t_lim, so
//!    t_p is not either.
//! 5. The horizontals lie at t_p, 2·t_p, … under the surface of the blank (e, l. 646).
//!
//! Radii are whole halves of a micrometre, so a mean depth is rounded up to one. That never adds a pass.

pub mod zone;

use crate::turning::length::Half;
use crate::turning::shaft::Shaft;
use zone::{Cylinder, ZoneSection, sections};

/// The stock over a cylinder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CylinderStock {
    /// The cylinder.
    pub cylinder: Cylinder,
    /// Radius of the blank over it.
    pub blank: Half,
    /// tᵢ, radial.
    pub stock: Half,
    /// nᵢ: the fewest passes that the limiting depth allows.
    pub passes: i64,
    /// The mean depth tᵢ / nᵢ, rounded up.
    pub mean: Half,
}

/// The rough zone with its one depth.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Levels {
    /// The limiting depth t_lim.
    pub limit: Half,
    /// The one depth t_p.
    pub depth: Half,
    /// The sections of the zone.
    pub sections: Vec<ZoneSection>,
}

impl Levels {
    /// The levels of a shaft for its limiting depth, `roughing.longitudinal_depth`.
    pub fn of(shaft: &Shaft) -> Self {
        let limit = Half::of(shaft.roughing.longitudinal_depth);
        let sections = sections(shaft);
        let depth = stocks(&sections, limit).iter().map(|one| one.mean).max().unwrap_or(limit);
        Self { limit, depth, sections }
    }

    /// The same zone with another depth t_p.
    #[must_use]
    pub fn with_depth(mut self, depth: Half) -> Self {
        self.depth = depth;
        self
    }

    /// The stock over each cylinder, from the free end.
    pub fn stocks(&self) -> Vec<CylinderStock> {
        stocks(&self.sections, self.limit)
    }

    /// The radius of a horizontal of a section, from 1; 0 is the surface of the blank.
    pub fn horizontal(&self, section: &ZoneSection, level: i64) -> Half {
        section.blank - Half::new(self.depth.halves().saturating_mul(level))
    }

    /// The number of levels over a cylinder, the last perhaps thinner: ⌈tᵢ / t_p⌉.
    pub fn count(&self, section: &ZoneSection, cylinder: &Cylinder) -> i64 {
        section.stock(cylinder).parts(self.depth)
    }

    /// The number of levels of the full depth over a cylinder: ⌊tᵢ / t_p⌋.
    pub fn full(&self, section: &ZoneSection, cylinder: &Cylinder) -> i64 {
        section.stock(cylinder).halves() / self.depth.halves().max(1)
    }
}

fn stocks(sections: &[ZoneSection], limit: Half) -> Vec<CylinderStock> {
    let of = |section: &ZoneSection, cylinder: &Cylinder| {
        let stock = section.stock(cylinder);
        let passes = stock.parts(limit);
        let mean = stock.part(passes);
        CylinderStock { cylinder: *cylinder, blank: section.blank, stock, passes, mean }
    };
    sections.iter().flat_map(|section| section.cylinders.iter().map(move |one| of(section, one))).collect()
}
