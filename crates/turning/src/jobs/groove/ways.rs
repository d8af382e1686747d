//! The toolpath of a blade through a groove: plunges, the middle first, then sides and floor, each side from its
//! mouth inwards with its own corner of the blade.
//!
//! The blade is a straight edge between two round corners. It reaches as far as both corners do, because a groove
//! with concave corners is nowhere higher between two places than at the higher of them.

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::point::{Point, Vector};
use crate::turning::toolpath::{Move, Purpose, Toolpath};

use super::valley::{CentrePath, Lie, Valley};

/// The edge that cuts a groove, mm; a turning tool has no straight part, so its width is twice its nose radius.
#[derive(Clone, Copy, Debug)]
pub(super) struct CuttingEdge {
    pub width: f64,
    pub corner: f64,
}

/// The division of a groove into plunges and passes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Division {
    /// Distance between two plunges, divided by the width.
    pub step: f64,
    /// The allowance that plunges leave on sides and floor, mm.
    pub allowance: f64,
    /// The largest finishing depth, mm.
    pub finish: f64,
    /// Pecking: the depth from which it is used and the depth of a step, divided by the width; and the retract, mm.
    pub peck: (f64, f64, f64),
    /// The approach before the metal.
    pub approach: Half,
}

/// A toolpath, seen from the mouth, from before the mouth and back.
#[derive(Clone, Debug)]
pub(super) struct Ways {
    pub path: Toolpath,
    /// The plunges, in order.
    pub plunges: Vec<Half>,
    /// Whether one plunge makes floor and walls.
    pub at_once: bool,
    /// Steps of the deepest plunge; 1 without pecking.
    pub steps: usize,
}

impl CuttingEdge {
    /// The vectors to the leading corner of the edge from the centre of the corner at the smaller `z`, and from the
    /// other one.
    fn leads(self) -> (Vector, Vector) {
        (Vector::new(self.width - self.corner, -self.corner), Vector::new(self.corner, -self.corner))
    }

    /// Its straight part.
    fn flat(self) -> f64 {
        self.width - 2.0 * self.corner
    }

    /// The clearance at the floor beside the edge, mm; negative if the edge does not enter.
    pub fn room(self, finished: &CentrePath) -> f64 {
        let (from, to) = finished.floor();
        to - from - self.flat()
    }

    /// The lowest height of the leading corner at a place, mm; none beyond the mouth.
    fn lowest(self, way: &CentrePath, lead: f64) -> Option<f64> {
        let heights = [lead - self.width + self.corner, lead - self.corner].map(|centre| way.height(centre));
        Some(heights[0]?.max(heights[1]?) - self.corner)
    }
}

/// Rounding, mm: a blade as wide as its groove has no clearance, except for half micrometres.
const TRIFLE: f64 = 0.002;

/// The toolpath of a blade; none if it does not reach the floor.
pub(super) fn blade(valley: &Valley, edge: CuttingEdge, division: Division) -> Option<Ways> {
    let finished = valley.centres(edge.corner)?;
    let room = edge.room(&finished);
    if room < -TRIFLE {
        return None;
    }
    let (left, right) = edge.leads();
    let (from, to) = finished.floor();
    let (first, last) = (from + left.z, to + right.z);
    let middle = (first + last) / 2.0;
    let (mut builder, mut plunges) = (Builder::at(valley, middle, division), Vec::new());
    let (steep_fall, steep_rise) = valley.steepest();
    let upright = steep_fall > 89.9 && steep_rise > 89.9;
    let at_once = room <= TRIFLE;
    let floor = valley.floor.to_mm();
    if at_once {
        // The blade itself makes the floor, and perpendicular walls.
        let bottom = Half::from(floor).max(Half::from(edge.lowest(&finished, middle).unwrap_or(floor)));
        builder.plunge(middle, bottom, edge, Purpose::Return);
        plunges.push(Half::from(middle));
    } else if let Some(way) = valley.centres(edge.corner + division.allowance) {
        let mut places = places(&way, edge, division, (steep_fall, steep_rise));
        if valley.lie == Lie::Face {
            // A face blade is curved for the diameter of its first plunge; from there the groove is widened towards
            // the axis.
            places.sort_by(f64::total_cmp);
        }
        // If the allowance leaves no room beside the blade, only the floor keeps one.
        let tight = |lead| Some(edge.lowest(&finished, lead)? + division.allowance);
        for lead in places {
            let Some(low) = edge.lowest(&way, lead).or_else(|| tight(lead)).map(Half::from) else { continue };
            if low < valley.mouth {
                builder.plunge(lead, low, edge, Purpose::Rapid);
                plunges.push(Half::from(lead));
            }
        }
    }
    if !(at_once && upright) {
        let (down, up) = finished.halves(left, right);
        let bottom = Half::from(floor);
        builder.side(&down, Point { radius: bottom, z: Half::from(middle) }, 1.0);
        builder.side(&up, Point { radius: bottom, z: Half::from(middle) }, -1.0);
    }
    Some(Ways { path: builder.path, plunges, at_once, steps: builder.steps })
}

/// The toolpath of a turning tool from the mouth at the smaller `z` to the other; none if its nose does not reach the
/// floor.
pub(super) fn nose(valley: &Valley, edge: CuttingEdge, division: Division) -> Option<Ways> {
    let finished = valley.centres(edge.corner)?;
    if edge.room(&finished) < -TRIFLE {
        return None;
    }
    let (_, lead) = edge.leads();
    let pieces = finished.whole(lead);
    let start = pieces.first()?.from;
    let mut builder = Builder::at(valley, start.z.to_mm(), division);
    builder.path.go(start, Purpose::Finish);
    for piece in pieces {
        builder.path.follow(piece, Purpose::Finish);
    }
    // Leaves the wall at feed before the rapid.
    let end = builder.path.end();
    let off = division.approach;
    builder.path.go(Point { radius: end.radius, z: end.z - Half::from(division.allowance) }, Purpose::Return);
    builder.path.go(Point { radius: valley.mouth + off, z: builder.path.end().z }, Purpose::Rapid);
    Some(Ways { path: builder.path, plunges: Vec::new(), at_once: false, steps: 1 })
}

/// The places of plunges, in the order of work: over the floor from its middle outwards, then over inclined walls
/// away from it.
fn places(way: &CentrePath, edge: CuttingEdge, division: Division, (fall, rise): (f64, f64)) -> Vec<f64> {
    let (left, right) = edge.leads();
    let (from, to) = way.floor();
    let (first, last) = (from + left.z, to + right.z);
    let mut places = Vec::new();
    // A second plunge beside the first would cut a sliver of the blade's width: where both sides may take what stands beside one
    // plunge in the middle, there is no other.
    let beside = (last - first) / 2.0 + division.allowance;
    if last < first || beside <= division.finish + TRIFLE {
        places.push((first + last) / 2.0);
    } else {
        let count = libm::ceil((last - first) / (division.step * edge.width) - 1e-9).max(0.0);
        let at = |index: f64| if count > 0.0 { first + (last - first) * index / count } else { first };
        let mut indices: Vec<f64> = (0..=count as i64).map(|index| index as f64).collect();
        indices.sort_by(|one, other| (one - count / 2.0).abs().total_cmp(&(other - count / 2.0).abs()));
        places.extend(indices.into_iter().map(at));
    }
    // Steps over inclined walls leave no more than finishing removes: their height on the wall is the step times the
    // sine of its inclination.
    let stair = |slant: f64| {
        let sine = libm::sin(slant.to_radians());
        ((division.finish - division.allowance).max(0.1) / sine.max(0.1)).min(division.step * edge.width)
    };
    let (begin, end) = way.ends();
    let outwards = |slant: f64, from: f64, to: f64| {
        let (step, way) = (stair(slant), (to - from).abs());
        let count = libm::floor(way / step);
        (1..=count as i64).map(move |index| from + step * index as f64 * (to - from).signum())
    };
    if fall < 89.9 {
        places.extend(outwards(fall, first.min(last), begin + left.z));
    }
    if rise < 89.9 {
        places.extend(outwards(rise, last.max(first), end + right.z));
    }
    places
}

/// Assembles a toolpath.
struct Builder {
    path: Toolpath,
    division: Division,
    mouth: Half,
    steps: usize,
}

impl Builder {
    fn at(valley: &Valley, lead: f64, division: Division) -> Self {
        let start = Point { radius: valley.mouth + division.approach, z: Half::from(lead) };
        Self { path: Toolpath::at(start), division, mouth: valley.mouth, steps: 1 }
    }

    fn above(&self) -> Half {
        self.mouth + self.division.approach
    }

    /// Across, above the mouth.
    fn over(&mut self, z: Half) {
        self.path.go(Point { radius: self.above(), z }, Purpose::Rapid);
    }

    /// A plunge to a height, with pecking if it is deep, and out.
    fn plunge(&mut self, lead: f64, low: Half, edge: CuttingEdge, out: Purpose) {
        let z = Half::from(lead);
        self.over(z);
        let (from, by, back) = self.division.peck;
        let deep = self.mouth - low;
        let pecks = deep.to_mm() > from * edge.width;
        let steps = if pecks { deep.parts(Half::from(by * edge.width)).max(1) } else { 1 };
        let step = deep.part(steps);
        for number in 1..=steps {
            let to = if number == steps { low } else { self.mouth - Half::new(step.halves() * number) };
            self.path.go(Point { radius: to, z }, Purpose::Plunge);
            if number < steps {
                self.path.go(Point { radius: to + Half::from(back), z }, Purpose::Return);
            }
        }
        self.steps = self.steps.max(steps as usize);
        self.path.go(Point { radius: self.above(), z }, out);
    }

    /// A side from its mouth down, the floor to a place, and out. The blade comes to a wall from inside the groove,
    /// because a shoulder may be above the wall.
    fn side(&mut self, pieces: &[Piece], to: Point, inwards: f64) {
        let Some(start) = pieces.first().map(|piece| piece.from) else { return };
        let start = Point { radius: start.radius.min(self.above()), z: start.z };
        self.over(start.z + Half::from(inwards * self.division.allowance));
        self.path.go(Point { radius: self.above(), z: start.z }, Purpose::Return);
        self.path.go(start, Purpose::Return);
        for piece in pieces {
            self.path.moves.push(Move::along(*piece, Purpose::Finish));
        }
        self.path.go(to, Purpose::Finish);
        self.over_from(to.z);
    }

    fn over_from(&mut self, z: Half) {
        self.path.go(Point { radius: self.above(), z }, Purpose::Rapid);
    }
}
