//! Checks between a hole and its openings, its groove and its state in the blank.

use crate::knowledge::diagnostic::Place;
use crate::units::Micrometres;
use technolog_note::{Figure, note};

use super::check::BoreSpan;
use super::read::Reader;
use super::read_features::Features;
use super::{Blank, Point};

impl Reader<'_> {
    /// Compares the features with the cylinders of the hole, given from the entry face inwards; from the diameter
    /// `too_wide` on a hole of the blank leaves no work.
    pub(super) fn fit_features(&mut self, features: &Features, cylinders: &[BoreSpan], too_wide: Micrometres) {
        let Some(entry) = cylinders.first() else { return };
        let end = cylinders.last().map_or(entry.to, |last| last.to);
        let mut widest = entry.diameter;
        // Each with its depth, and whether that is too much.
        let mut openings: Vec<(&'static str, Micrometres, Micrometres, bool, &Place)> = Vec::new();
        let mut cone = |name, diameter: Micrometres, angle_millideg, place| {
            let deep = cone_depth(diameter - entry.diameter, angle_millideg);
            // Drawings round angles, and a cone over the whole depth must not seem too long because of that.
            openings.push((name, diameter, deep, deep.ratio(99, 100) > entry.to, place));
        };
        if let Some((it, place)) = &features.cone {
            cone("cone", it.diameter, it.angle_millideg, place);
        }
        if let Some((countersink, place)) = &features.countersink {
            cone("countersink", countersink.diameter, countersink.angle_millideg, place);
        }
        if let Some((bore, place)) = &features.counterbore {
            openings.push(("counterbore", bore.diameter, bore.depth, bore.depth >= entry.to, place));
        }
        for (name, diameter, deep, too_deep, place) in openings {
            if diameter <= entry.diameter {
                self.too_narrow(name, diameter, entry.diameter, place);
            } else if too_deep {
                let message = note!(
                    "part-deep-only",
                    name = Figure::word(name),
                    deep = deep,
                    diameter = entry.diameter,
                    to = entry.to
                );
                self.problems.error_help::<()>("too-deep", message, place, note!("part-make-shallower-than-hole"));
            }
            widest = widest.max(diameter);
        }
        if let Some((diameter, place)) = &features.face
            && *diameter <= widest
        {
            self.too_narrow("face", *diameter, widest, place);
        }
        if let Some((groove, place)) = &features.groove {
            let (from, to) = (groove.depth, groove.depth + groove.width);
            let around =
                cylinders.iter().filter(|span| span.from < to && from < span.to).map(|span| span.diameter).max();
            if to > end {
                let message = note!("part-groove-reaches-hole-only", to = to, end = end);
                let help = note!("part-depth-counts-from-entry-face");
                self.problems.error_help::<()>("too-deep", message, place, help);
            } else if let Some(around) = around.filter(|around| groove.diameter <= *around) {
                self.too_narrow("groove", groove.diameter, around, place);
            }
        }
        if let (Some(diameter), Some(place)) = (features.state.diameter(), &features.state_diameter)
            && diameter >= too_wide
        {
            let message = note!("part-hole-blank-finished-one-may", diameter = diameter, too_wide = too_wide);
            let help = note!("part-give-diameter-stands-blank-leaves");
            self.problems.error_help::<()>("bad-diameter", message, place, help);
        }
    }

    /// A face may extend beyond an edge, but one wider than the blank is a mistake: no mill cuts it.
    pub(super) fn face_on_blank(&mut self, features: &Features, blank: Option<&Blank>) {
        let (Some((diameter, place)), Some(blank)) = (&features.face, blank) else { return };
        let corner = Point { x: Micrometres::ZERO, y: Micrometres::ZERO };
        let across = corner.distance(Point { x: blank.length, y: blank.width });
        if *diameter > across {
            let message = note!("part-face-blank-measures-across-corners", diameter = diameter, across = across);
            let help = note!("part-give-diameter-face-around-hole");
            self.problems.error_help::<()>("outside-blank", message, place, help);
        }
    }

    fn too_narrow(&mut self, name: &'static str, diameter: Micrometres, hole: Micrometres, place: &Place) {
        let message = note!("part-hole-there", name = Figure::word(name), diameter = diameter, hole = hole);
        self.problems.error_help::<()>("too-narrow", message, place, note!("part-make-wider-than-hole-leave"));
    }
}

/// The depth of a cone from its mouth to a diameter smaller by `narrower`.
fn cone_depth(narrower: Micrometres, angle_millideg: u32) -> Micrometres {
    let half_angle = (f64::from(angle_millideg) / 2000.0).to_radians();
    Micrometres::from_mm_rounded(narrower.to_mm() / 2.0 / libm::tan(half_angle))
}
