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
    /// The depth of a layer that the blade takes sideways, mm; none for a tool that takes none.
    pub layer: Option<f64>,
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
    /// The layers in which inclined walls are turned sideways; none where plunges or the finishing passes take them.
    pub layers: usize,
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

    /// How far the leading corner goes from a place towards another at a height before the blade meets the groove, mm; the heights
    /// over a wall rise on the way.
    fn reaches(self, way: &CentrePath, height: f64, from: f64, to: f64) -> f64 {
        let clear = |lead: f64| self.lowest(way, lead).is_some_and(|low| low <= height + 1e-9);
        let (mut inside, mut beyond) = (from, to);
        // The corners round off to half a micrometre.
        while (beyond - inside).abs() > 0.0005 {
            let half = (inside + beyond) / 2.0;
            *if clear(half) { &mut inside } else { &mut beyond } = half;
        }
        inside
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
    let mut layers = None;
    let floor = valley.floor.to_mm();
    if at_once {
        // The blade itself makes the floor, and perpendicular walls.
        let bottom = Half::from(floor).max(Half::from(edge.lowest(&finished, middle).unwrap_or(floor)));
        builder.plunge(middle, bottom, edge, Purpose::Return);
        plunges.push(Half::from(middle));
    } else if let Some(way) = valley.centres(edge.corner + division.allowance) {
        let Places { over_floor: mut places, over_walls } = places(&way, edge, division, (steep_fall, steep_rise));
        // Plunges beside each other over a steep wall cut slivers: turned sideways in layers it takes less feeding.
        let slot =
            places.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), at| (least.min(*at), most.max(*at)));
        let turned = division.layer.filter(|_| valley.lie != Lie::Face).and_then(|layer| {
            let low = edge.lowest(&way, middle)?;
            Some(Layers::of(&way, edge, (valley.mouth.to_mm(), low), layer, slot))
        });
        let depth = |lead: &f64| edge.lowest(&way, *lead).map_or(0.0, |low| (valley.mouth.to_mm() - low).max(0.0));
        let plunged: f64 = over_walls.iter().map(depth).sum();
        layers = turned.filter(|layers| layers.fed_mm() < plunged);
        if layers.is_none() {
            places.extend(over_walls);
        }
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
        if let Some(layers) = &layers {
            builder.layers(layers);
            let (down, up) = way.halves(left, right);
            let at = Point { radius: Half::from(edge.lowest(&way, middle).unwrap_or(floor)), z: Half::from(middle) };
            builder.side(&down, at, 1.0, Purpose::SemiFinish);
            builder.side(&up, at, -1.0, Purpose::SemiFinish);
        }
    }
    if !(at_once && upright) {
        let (down, up) = finished.halves(left, right);
        let bottom = Half::from(floor);
        builder.side(&down, Point { radius: bottom, z: Half::from(middle) }, 1.0, Purpose::Finish);
        builder.side(&up, Point { radius: bottom, z: Half::from(middle) }, -1.0, Purpose::Finish);
    }
    let layers = layers.map_or(0, |layers| layers.heights.len());
    Some(Ways { path: builder.path, plunges, at_once, steps: builder.steps, layers })
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
    Some(Ways { path: builder.path, plunges: Vec::new(), at_once: false, steps: 1, layers: 0 })
}

/// The places of plunges, in the order of work.
struct Places {
    /// Over the floor, from its middle outwards.
    over_floor: Vec<f64>,
    /// Over inclined walls, away from it.
    over_walls: Vec<f64>,
}

fn places(way: &CentrePath, edge: CuttingEdge, division: Division, (fall, rise): (f64, f64)) -> Places {
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
    let mut over_walls = Vec::new();
    if fall < 89.9 {
        over_walls.extend(outwards(fall, first.min(last), begin + left.z));
    }
    if rise < 89.9 {
        over_walls.extend(outwards(rise, last.max(first), end + right.z));
    }
    Places { over_floor: places, over_walls }
}

/// Layers from the mouth down, in each of which the blade is fed sideways out of the plunged slot to both walls ("step turning").
struct Layers {
    /// The leading corner over the outermost plunges.
    slot: (f64, f64),
    /// The height of each layer, with the leading corner where the blade meets the walls.
    heights: Vec<(f64, f64, f64)>,
}

impl Layers {
    /// Equal layers between the mouth and the plunged floor, none deeper than that.
    fn of(way: &CentrePath, edge: CuttingEdge, (mouth, low): (f64, f64), deepest: f64, slot: (f64, f64)) -> Self {
        let count = libm::ceil((mouth - low) / deepest - 1e-9).max(1.0);
        let (begin, end) = way.ends();
        let (left, right) = edge.leads();
        let heights = (1..=count as i64).map(|index| {
            let height = mouth - (mouth - low) * index as f64 / count;
            let wall = |from: f64, to: f64| edge.reaches(way, height, from, to);
            (height, wall(slot.0, begin + left.z), wall(slot.1, end + right.z))
        });
        Self { slot, heights: heights.collect() }
    }

    /// How far the blade is fed through metal, with the passes along both walls afterwards.
    fn fed_mm(&self) -> f64 {
        let sideways: f64 = self.heights.iter().map(|(_, from, to)| (self.slot.0 - from) + (to - self.slot.1)).sum();
        let (top, bottom) = (self.heights.first(), self.heights.last());
        let deep = top.zip(bottom).map_or(0.0, |(top, bottom)| top.0 - bottom.0);
        sideways + 2.0 * deep
    }
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

    /// Layers, first those towards the smaller `z`: down in the slot, sideways into the wall, off it and back above the layer.
    fn layers(&mut self, layers: &Layers) {
        let (back, off) = (Half::from(self.division.peck.2), Half::from(self.division.allowance));
        // Off the wall of the slot, where there is room, the blade goes down at rapid.
        let room = Half::from(layers.slot.1 - layers.slot.0) >= off;
        let down = if room { Purpose::Rapid } else { Purpose::Return };
        for (slot, inwards) in [(layers.slot.0, 1), (layers.slot.1, -1)] {
            let slot = Half::from(slot) + Half::new(if room { off.halves() * inwards } else { 0 });
            self.over(slot);
            for &(height, from, to) in &layers.heights {
                let wall = Half::from(if inwards > 0 { from } else { to });
                if (wall - slot).to_mm().abs() < 2.0 * off.to_mm() {
                    continue;
                }
                let height = Half::from(height);
                self.path.go(Point { radius: height, z: slot }, down);
                self.path.go(Point { radius: height, z: wall }, Purpose::Cut);
                let off = wall + Half::new(off.halves() * inwards);
                self.path.go(Point { radius: height + back, z: off }, Purpose::Return);
                self.path.go(Point { radius: height + back, z: slot }, Purpose::Rapid);
            }
            self.over_from(slot);
        }
    }

    /// A side from its mouth down, the floor to a place, and out. The blade comes to a wall from inside the groove,
    /// because a shoulder may be above the wall.
    fn side(&mut self, pieces: &[Piece], to: Point, inwards: f64, purpose: Purpose) {
        let Some(start) = pieces.first().map(|piece| piece.from) else { return };
        let start = Point { radius: start.radius.min(self.above()), z: start.z };
        self.over(start.z + Half::from(inwards * self.division.allowance));
        self.path.go(Point { radius: self.above(), z: start.z }, Purpose::Return);
        self.path.go(start, Purpose::Return);
        for piece in pieces {
            self.path.moves.push(Move::along(*piece, purpose));
        }
        self.path.go(to, purpose);
        self.over_from(to.z);
    }

    fn over_from(&mut self, z: Half) {
        self.path.go(Point { radius: self.above(), z }, Purpose::Rapid);
    }
}
