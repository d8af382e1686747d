//! Splitting the stock of any zone into levels: the lecture's steps (12.4 a-e, l. 604-660), over lines and arcs.
//!
//! 1. The blank is divided at its faces into sections, each under its largest radius, the top (l. 794-812).
//! 2. The stock over each piece of the rough contour in a section is tᵢ = top − the deepest point of the piece (a).
//! 3. It needs at least nᵢ = ⌈tᵢ / t_lim⌉ passes (b), of the mean depth tᵢ / nᵢ (c).
//! 4. The largest mean depth is the one depth t_p of the whole zone (d).
//! 5. The horizontals lie at t_p, 2·t_p, … under each top, the last at the deepest point of the section (e).
//!
//! Radii are whole halves of a micrometre, so a mean depth is rounded up to one, which never adds a pass. A cone or an arc
//! counts with its deepest point, and a blank that is not a cylinder with its highest, so the true depth of a pass is nowhere
//! above t_p.

use std::collections::BTreeSet;

use serde::Serialize;

use crate::turning::contour::Contour;
use crate::turning::length::{Half, negative_z};

use super::monotone::MonotoneContour;

/// The stock over a piece of the rough contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct PieceStock {
    /// Z of its beginning.
    #[serde(rename = "from_z_mm", serialize_with = "negative_z")]
    pub from: Half,
    /// Z of its end.
    #[serde(rename = "to_z_mm", serialize_with = "negative_z")]
    pub to: Half,
    /// Its deepest point, radius.
    #[serde(rename = "deepest_radius_mm")]
    pub deepest: Half,
    /// tᵢ, radial.
    #[serde(rename = "stock_mm")]
    pub stock: Half,
    /// nᵢ.
    pub passes: i64,
    /// The mean depth, rounded up to half a micrometre.
    #[serde(rename = "mean_depth_mm")]
    pub mean: Half,
}

/// A section of the zone: under one part of the blank between two of its faces.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct BlankSection {
    /// Z of its beginning.
    #[serde(rename = "from_z_mm", serialize_with = "negative_z")]
    pub from: Half,
    /// Z of its end.
    #[serde(rename = "to_z_mm", serialize_with = "negative_z")]
    pub to: Half,
    /// The highest radius of the blank over it.
    #[serde(rename = "top_radius_mm")]
    pub top: Half,
    /// The stock over each piece, from the free end; pieces without stock are left out.
    #[serde(rename = "stands")]
    pub stocks: Vec<PieceStock>,
    /// The horizontals from the blank inwards.
    #[serde(rename = "horizontals_radius_mm")]
    pub horizontals: Vec<Half>,
}

/// A zone split into levels.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Split {
    /// t_p.
    #[serde(rename = "depth_mm")]
    pub depth: Half,
    /// The sections that have stock, from the free end.
    pub sections: Vec<BlankSection>,
}

impl Split {
    /// The levels of a zone for a limiting depth; t_p is calculated by the lecture.
    pub fn of(rough: &Contour, blank: &Contour, limit: Half) -> Self {
        let (ground, blank) = (MonotoneContour::of(rough), MonotoneContour::of(blank));
        let sections = sections(&ground, &blank, limit);
        let means = sections.iter().flat_map(|section| section.stocks.iter().map(|one| one.mean));
        let depth = means.max().unwrap_or(limit);
        Self::levelled(sections, depth)
    }

    /// The levels of a zone for a given depth t_p.
    pub(super) fn with_depth(ground: &MonotoneContour, blank: &MonotoneContour, depth: Half) -> Self {
        Self::levelled(sections(ground, blank, depth), depth)
    }

    /// The same levels over a part of the zone.
    #[must_use]
    pub(super) fn within(mut self, (from, to): (Half, Half)) -> Self {
        for section in &mut self.sections {
            (section.from, section.to) = (section.from.max(from), section.to.min(to));
        }
        self.sections.retain(|section| section.from < section.to);
        self
    }

    /// The same sections with levels that begin again at each cylinder of the rough contour, so that each cylinder is
    /// reached.
    #[must_use]
    pub(super) fn against_stops(mut self, ground: &MonotoneContour) -> Self {
        for section in &mut self.sections {
            let radii = ground.pieces.iter().filter(|piece| piece.is_cylinder()).map(|piece| piece.from.radius);
            let deepest: BTreeSet<Half> = section.stocks.iter().map(|one| one.deepest).collect();
            let within = |radius: &Half| *radius < section.top && deepest.contains(radius);
            let mut stops: Vec<Half> = radii.filter(within).collect();
            stops.sort();
            stops.dedup();
            let mut top = section.top;
            section.horizontals.clear();
            for stop in stops.into_iter().rev() {
                section.horizontals.extend(horizontals(top, stop, self.depth));
                top = stop;
            }
        }
        self
    }

    /// The same inside out: radii count inwards from `top`. Stocks and depths do not change.
    #[must_use]
    pub fn inside_out(mut self, top: Half) -> Self {
        for section in &mut self.sections {
            section.top = top - section.top;
            for stock in &mut section.stocks {
                stock.deepest = top - stock.deepest;
            }
            for level in &mut section.horizontals {
                *level = top - *level;
            }
        }
        self
    }

    fn levelled(mut sections: Vec<BlankSection>, depth: Half) -> Self {
        for section in &mut sections {
            let floor = section.stocks.iter().map(|one| one.deepest).min().unwrap_or(section.top);
            section.horizontals = horizontals(section.top, floor, depth);
        }
        Self { depth, sections }
    }
}

/// Horizontals a depth apart under a top, the last on the floor.
fn horizontals(top: Half, floor: Half, depth: Half) -> Vec<Half> {
    let step = Half::new(depth.halves().max(1));
    let mut levels = Vec::new();
    let mut level = top;
    while level > floor {
        level = (level - step).max(floor);
        levels.push(level);
    }
    levels
}

fn sections(ground: &MonotoneContour, blank: &MonotoneContour, limit: Half) -> Vec<BlankSection> {
    let (from, to) = (ground.from(), ground.to());
    let mut sections: Vec<BlankSection> = Vec::new();
    let mut begins = true;
    for piece in &blank.pieces {
        if piece.is_face() {
            begins = true;
            continue;
        }
        let (a, b) = (piece.from.z.max(from), piece.to.z.min(to));
        if a >= b {
            continue;
        }
        let top = piece.from.radius.max(piece.to.radius);
        match sections.last_mut().filter(|_| !begins) {
            Some(section) => {
                section.to = b;
                section.top = section.top.max(top);
            }
            None => sections.push(BlankSection { from: a, to: b, top, stocks: Vec::new(), horizontals: Vec::new() }),
        }
        begins = false;
    }
    for section in &mut sections {
        section.stocks = stocks(ground, section, limit);
    }
    sections.retain(|section| !section.stocks.is_empty());
    sections
}

fn stocks(ground: &MonotoneContour, section: &BlankSection, limit: Half) -> Vec<PieceStock> {
    let of = |piece: &crate::turning::contour::Piece| {
        let part = super::monotone::clipped(piece, section.from, section.to)?;
        let deepest = part.from.radius.min(part.to.radius);
        let stock = section.top - deepest;
        let passes = stock.parts(limit);
        let mean = stock.part(passes);
        let found = PieceStock { from: part.from.z, to: part.to.z, deepest, stock, passes, mean };
        (stock > Half::ZERO).then_some(found)
    };
    ground.touching(section.from, section.to).iter().filter(|piece| !piece.is_face()).filter_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::contour::{Piece, Side, Turn};
    use crate::turning::point::at;

    /// By hand: a bar of radius 40 over a cone from 20 to 30 and a fillet from 30 to 35, t_lim 4. The cone's deepest
    /// point is 20: t = 20, n = 5, mean 4; the fillet's 30: t = 10, n = 3, mean 3.3335 (rounded up); t_p = 4, horizontals
    /// 36, 32, 28, 24, 20.
    #[test]
    fn cones_and_arcs_count_with_their_deepest_point() {
        let mut rough = Contour::through(Side::Outer, &[at(20.0, 0.0), at(30.0, 20.0)]);
        rough.pieces.push(Piece::arc(at(30.0, 20.0), at(35.0, 25.0), Half::from(5.0), Turn::Left));
        let blank = Contour::through(Side::Outer, &[at(40.0, 0.0), at(40.0, 25.0)]);
        let split = Split::of(&rough, &blank, Half::from(4.0));
        let found_stocks: Vec<_> =
            split.sections[0].stocks.iter().map(|one| (one.stock, one.passes, one.mean)).collect();
        assert_eq!(found_stocks, [(Half::from(20.0), 5, Half::from(4.0)), (Half::from(10.0), 3, Half::from(3.3335))]);
        assert_eq!(split.depth, Half::from(4.0));
        assert_eq!(split.sections[0].horizontals, [36.0, 32.0, 28.0, 24.0, 20.0].map(Half::from));
    }

    /// A blank of two diameters has two sections, each with its own horizontals.
    #[test]
    fn a_stepped_blank_is_taken_apart_at_its_faces() {
        let rough = Contour::through(Side::Outer, &[at(20.0, 0.0), at(20.0, 10.0), at(25.0, 10.0), at(25.0, 30.0)]);
        let blank = Contour::through(Side::Outer, &[at(25.0, 0.0), at(25.0, 15.0), at(29.0, 15.0), at(29.0, 30.0)]);
        let split = Split::of(&rough, &blank, Half::from(3.0));
        assert_eq!(split.depth, Half::from(2.5));
        let parts: Vec<_> =
            split.sections.iter().map(|one| (one.from, one.to, one.top, one.horizontals.clone())).collect();
        let (first, second) = ([22.5, 20.0].map(Half::from).to_vec(), [26.5, 25.0].map(Half::from).to_vec());
        assert_eq!(parts[0], (Half::ZERO, Half::from(15.0), Half::from(25.0), first));
        assert_eq!(parts[1], (Half::from(15.0), Half::from(30.0), Half::from(29.0), second));
    }
}
