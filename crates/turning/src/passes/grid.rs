//! The stock over a stepped shaft as radial levels and axial slices (the paper's "grid of steps").
//!
//! Radii count from the axis, Z from the face of the free end towards the chuck. Levels count from the bar inwards,
//! slices from the free end: the order in which a tool can reach them.

use serde::Serialize;

use crate::turning::length::{Half, as_diameter, negative_z};
use crate::turning::shaft::{Division, Shaft};
use crate::units::Micrometres;

/// The largest grid that is searched: 1,000 levels by 1,000 slices.
pub const MOST_STATES: u64 = 1_000_000;

/// The metal of one longitudinal pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Level {
    /// Radius before.
    #[serde(rename = "from_diameter_mm", serialize_with = "as_diameter")]
    pub from: Half,
    /// Radius after.
    #[serde(rename = "to_diameter_mm", serialize_with = "as_diameter")]
    pub to: Half,
    /// Between these.
    #[serde(rename = "depth_mm")]
    pub depth: Half,
    /// Z of the shoulder that it meets.
    #[serde(rename = "shoulder_z_mm", serialize_with = "negative_z")]
    pub end: Half,
}

/// The metal of one transverse pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Slice {
    /// Z before.
    #[serde(rename = "from_z_mm", serialize_with = "negative_z")]
    pub from: Half,
    /// Z after.
    #[serde(rename = "to_z_mm", serialize_with = "negative_z")]
    pub to: Half,
    /// Between these.
    #[serde(rename = "depth_mm")]
    pub depth: Half,
    /// Radius of the step that it goes down to.
    #[serde(rename = "bottom_diameter_mm", serialize_with = "as_diameter")]
    pub bottom: Half,
    /// The step, from 0.
    #[serde(skip)]
    pub step: usize,
}

/// Neighbouring steps of one diameter, as one cylinder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cylinder {
    /// Its radius.
    pub radius: Half,
    /// Z of its beginning.
    pub from: Half,
    /// Z of its end: of the shoulder there.
    pub to: Half,
}

/// The levels and slices of a shaft.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Grid {
    /// Radius of the bar.
    pub bar: Half,
    /// The cylinders with stock over them, from the free end.
    pub cylinders: Vec<Cylinder>,
    /// From the bar inwards.
    pub levels: Vec<Level>,
    /// From the free end.
    pub slices: Vec<Slice>,
    /// Largest radial depth of a longitudinal pass.
    pub longitudinal_depth: Half,
    /// Largest axial depth of a transverse pass.
    pub transverse_depth: Half,
}

impl Grid {
    /// The grid of a shaft.
    pub fn of(shaft: &Shaft) -> Self {
        let bar = Half::radius_of(shaft.blank.diameter);
        let cylinders = cylinders(shaft);
        let (longitudinal, transverse) =
            (Half::of(shaft.roughing.longitudinal_depth), Half::of(shaft.roughing.transverse_depth));
        let division = shaft.roughing.division;
        let mut levels = Vec::new();
        let mut outer = bar;
        for cylinder in cylinders.iter().rev() {
            for (from, to) in divide(outer - cylinder.radius, longitudinal, division) {
                levels.push(Level { from: outer - from, to: outer - to, depth: to - from, end: cylinder.to });
            }
            outer = cylinder.radius;
        }
        let mut slices = Vec::new();
        for (step, cylinder) in cylinders.iter().enumerate() {
            for (from, to) in divide(cylinder.to - cylinder.from, transverse, division) {
                let (depth, from, to) = (to - from, cylinder.from + from, cylinder.from + to);
                slices.push(Slice { from, to, depth, bottom: cylinder.radius, step });
            }
        }
        Self { bar, cylinders, levels, slices, longitudinal_depth: longitudinal, transverse_depth: transverse }
    }

    /// The radius of the stock after so many levels are removed.
    pub fn radius(&self, levels: usize) -> Half {
        levels.checked_sub(1).and_then(|last| self.levels.get(last)).map_or(self.bar, |level| level.to)
    }

    /// Z of the face after so many slices are removed.
    pub fn face(&self, slices: usize) -> Half {
        slices.checked_sub(1).and_then(|last| self.slices.get(last)).map_or(Half::ZERO, |slice| slice.to)
    }

    /// Whether no stock is left: the face is at the shoulder of the next level or, which is the same, the stock is not
    /// larger than the step of the next slice. Every further level and slice is then empty.
    pub fn done(&self, levels: usize, slices: usize) -> bool {
        self.levels.get(levels).is_none_or(|level| level.end <= self.face(slices)) || slices >= self.slices.len()
    }

    /// The area of the stock in the half section, in squares of half a micrometre.
    pub fn area(&self) -> i128 {
        let of = |cylinder: &Cylinder| {
            i128::from((cylinder.to - cylinder.from).halves()) * i128::from((self.bar - cylinder.radius).halves())
        };
        self.cylinders.iter().map(of).sum()
    }
}

/// The number of states of a shaft's grid, calculated without the grid.
pub fn states(shaft: &Shaft) -> u64 {
    let parts = |size: Half, depth: Half| size.parts(depth).unsigned_abs();
    let (longitudinal, transverse) =
        (Half::of(shaft.roughing.longitudinal_depth), Half::of(shaft.roughing.transverse_depth));
    let (mut levels, mut slices, mut outer) = (1_u64, 1_u64, Half::radius_of(shaft.blank.diameter));
    for cylinder in cylinders(shaft).iter().rev() {
        levels = levels.saturating_add(parts(outer - cylinder.radius, longitudinal));
        slices = slices.saturating_add(parts(cylinder.to - cylinder.from, transverse));
        outer = cylinder.radius;
    }
    levels.saturating_mul(slices)
}

/// The cylinders that are smaller than the bar: there is no shoulder between neighbouring steps of one diameter.
fn cylinders(shaft: &Shaft) -> Vec<Cylinder> {
    let bar = Half::radius_of(shaft.blank.diameter);
    let mut cylinders: Vec<Cylinder> = Vec::new();
    let mut at = Micrometres::ZERO;
    for step in &shaft.steps {
        let from = Half::of(at);
        at = at + step.length;
        let (radius, to) = (Half::radius_of(step.diameter), Half::of(at));
        match cylinders.last_mut() {
            Some(last) if last.radius == radius => last.to = to,
            _ if radius < bar => cylinders.push(Cylinder { radius, from, to }),
            _ => {}
        }
    }
    cylinders
}

/// Divides a size into depths: the beginning and the end of each.
fn divide(size: Half, depth: Half, division: Division) -> Vec<(Half, Half)> {
    let count = size.parts(depth);
    let (size, depth) = (size.halves(), depth.halves().max(1));
    let end = |part: i64| match division {
        Division::Full => (part * depth).min(size),
        // Whole halves of a micrometre, none above the depth: size/count is not above the depth, so neither is it
        // rounded up, and neighbouring multiples, rounded down, differ by no more than that.
        Division::Equal => size * part / count,
    };
    (0..count).map(|part| (Half::new(end(part)), Half::new(end(part + 1)))).collect()
}
