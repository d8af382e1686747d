//! What stands around a hole that the program itself has cut: rapids sideways out of it, into its floor, and from the side into a
//! place where the feed begins only higher up. It knows no part: what is around a hole that was cut from above is metal.

use super::below::{BELOW, Seen, ToldBelow};
use crate::motion::{BlockRef, Motion, MotionStep, Plane};
use crate::note::Note;
use crate::units::round_to;

type Point = [f64; 2];

/// The most holes that are kept, the most ways that are looked at, and the most points of each.
const MOST: usize = 1000;
const MOST_WAYS: usize = 200;
const MOST_POINTS: usize = 200;
/// Half of the widest hole that is not named, mm: of 50 mm, as table `program-conventions` says of cutters.
const WIDEST: f64 = 25.0;
/// How near two points are one, and how far out of its hole a tool is in the wall, mm.
const NEAR: f64 = 0.05;
const OUT: f64 = 1.0;
/// Half the width of a hole of a tool that is not named, as a part of the way to the next one of that tool.
const OF_PITCH: f64 = 0.4;
/// How near its middle a tool crosses the ring that it has cut, as a part of its radius: no boss is left there then.
const MIDDLE: f64 = 0.1;
/// How far over its face a feed begins at most, mm: over a rough one, by the rule `approach`.
const OVER_FACE: f64 = 10.0;

/// A hole that the program has cut from above.
#[derive(Clone, Copy, Debug)]
struct Hole {
    system: u8,
    /// The number of the tool change before it.
    section: usize,
    centre: Point,
    /// Where in it the tool may stand, about its centre, mm.
    inside: f64,
    /// Half its width, mm, where the tool is named.
    radius: Option<f64>,
    top: f64,
    bottom: f64,
    /// Whether it was milled by a circle from inside.
    round: bool,
}

/// A ring that a tool cuts about a point, in turns down from the face.
#[derive(Clone, Copy, Debug)]
struct Ring {
    centre: Point,
    turn: f64,
    bottom: f64,
}

/// Watches the walls of the holes of a program.
#[derive(Clone, Debug, Default)]
pub(super) struct Walls {
    holes: Vec<Hole>,
    /// The way straight down in progress.
    open: Option<Hole>,
    section: usize,
    /// Where the tool came below the zero.
    down: Option<Point>,
    /// The ring in progress.
    ring: Option<Ring>,
    /// Where a rapid sideways below the zero has ended, how high, and its block.
    across: Option<(Point, f64, BlockRef)>,
    /// A rapid into the floor of a hole, told where the tool then cuts.
    floor: Option<(f64, f64, BlockRef)>,
    /// How many ways out of holes were looked at.
    ways: usize,
    told: Vec<ToldBelow>,
}

fn apart(one: Point, other: Point) -> f64 {
    libm::hypot(one[0] - other[0], one[1] - other[1])
}

impl Walls {
    /// A step from point to point, with heights over the zero before and behind it; `milled` says of a point and a height whether the
    /// program has milled there down to it.
    pub fn takes(
        &mut self,
        step: &MotionStep,
        [from, to]: [Point; 2],
        (before, z): (f64, f64),
        (seen, radius): (Seen, Option<f64>),
        milled: impl Fn(Point, f64) -> bool,
    ) {
        let sideways = from != to;
        match &step.motion {
            Motion::Rapid if sideways => {
                self.closes();
                self.ring = None;
                let high = before.max(z);
                self.across = None;
                if high < -BELOW && seen.tool != 0 {
                    self.leaves([from, to], high, step.block, seen, &milled);
                    if !milled(to, high) {
                        self.across = Some((to, high, step.block));
                    }
                }
                self.down = self.down.filter(|_| z < -BELOW);
            }
            Motion::Rapid => {
                if z < before {
                    self.meets_floor(to, z, step.block, seen, &milled);
                }
                self.down = if z < -BELOW { self.down.or(Some(to)) } else { None };
            }
            Motion::Feed { .. } if !sideways && z < before => {
                self.begins(to, before, seen);
                self.cuts(seen);
                self.down = self.down.or(Some(to));
                let new = Hole {
                    system: seen.system,
                    section: self.section,
                    centre: to,
                    inside: NEAR,
                    radius,
                    top: before,
                    bottom: z,
                    round: false,
                };
                let open = self.open.get_or_insert(new);
                open.bottom = open.bottom.min(z);
            }
            Motion::Feed { .. } if !sideways => {}
            Motion::Arc { plane: Plane::Xy, centre, .. } => {
                self.cuts(seen);
                (self.open, self.across) = (None, None);
                let centre = centre.map(|along| along.to_mm());
                let turn = apart(from, centre);
                self.winds((centre, turn), from == to, (before, z));
                let inside = self.down.is_some_and(|down| apart(down, centre) < turn - NEAR);
                if from == to && z < -BELOW && before == z && inside {
                    let radius = radius.map(|radius| radius + turn);
                    let (system, section) = (seen.system, self.section);
                    self.keeps(Hole {
                        system,
                        section,
                        centre,
                        inside: turn,
                        radius,
                        top: 0.0,
                        bottom: z,
                        round: true,
                    });
                }
            }
            Motion::Feed { .. } | Motion::Arc { .. } => {
                self.cuts(seen);
                (self.open, self.across) = (None, None);
                let crossed = |ring: &Ring| apart(to, ring.centre) < MIDDLE * ring.turn && z <= ring.bottom + NEAR;
                if let Some(Ring { centre, turn, bottom }) = self.ring.take().filter(crossed) {
                    let radius = radius.map(|radius| radius + turn);
                    let (system, section) = (seen.system, self.section);
                    let round = Hole { system, section, centre, inside: turn, radius, top: 0.0, bottom, round: true };
                    self.keeps(round);
                }
            }
            Motion::ToolChange { .. } | Motion::End => {
                self.closes();
                (self.down, self.across, self.floor, self.ring) = (None, None, None, None);
                self.section += 1;
            }
            _ => {}
        }
    }

    /// An arc: whole turns about one point, down from the face, cut a ring in metal, from which the tool may go into its middle.
    fn winds(&mut self, (centre, turn): (Point, f64), whole: bool, (before, z): (f64, f64)) {
        let goes_on = |ring: &Ring| apart(ring.centre, centre) < NEAR && (ring.turn - turn).abs() < NEAR;
        let ring = self.ring.take().filter(|ring| goes_on(ring) && z <= ring.bottom);
        let begins = before >= -BELOW && z < before;
        self.ring = Some(Ring { centre, turn, bottom: z }).filter(|_| whole && (ring.is_some() || begins));
    }

    fn keeps(&mut self, hole: Hole) {
        if self.holes.len() < MOST {
            self.holes.push(hole);
        }
    }

    fn closes(&mut self) {
        if let Some(hole) = self.open.take() {
            self.keeps(hole);
        }
    }

    /// A rapid sideways that begins inside a hole, under its edge, and leaves it where nothing is milled.
    fn leaves(
        &mut self,
        [from, to]: [Point; 2],
        z: f64,
        block: BlockRef,
        seen: Seen,
        milled: &impl Fn(Point, f64) -> bool,
    ) {
        let inside = |hole: &&Hole| {
            let own = hole.system == seen.system && (hole.round || hole.section != self.section);
            let near = apart(from, hole.centre) < hole.inside + NEAR;
            own && near && hole.bottom <= z + BELOW && z < hole.top - BELOW
        };
        let Some(hole) = self.holes.iter().rev().find(inside).copied().filter(|_| self.ways < MOST_WAYS) else {
            return;
        };
        self.ways += 1;
        // Two holes of one tool do not run into each other.
        let of_tool = |other: &Hole| other.section == hole.section && other.system == hole.system;
        let others = self.holes.iter().filter(|other| of_tool(other)).map(|other| apart(other.centre, hole.centre));
        let widest = others.filter(|off| *off > NEAR).map(|off| off * OF_PITCH).fold(WIDEST, f64::min);
        let reach = |other: &Hole| {
            let about = of_tool(other) || apart(other.centre, hole.centre) < NEAR;
            other.radius.unwrap_or(if about { widest } else { WIDEST })
        };
        let points = (libm::ceil(apart(from, to)) as usize).clamp(1, MOST_POINTS);
        let metal = (0..=points).any(|step| {
            let part = step as f64 / points as f64;
            let at = [0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis]));
            let opened = |other: &Hole| other.bottom <= z + BELOW && apart(at, other.centre) < reach(other) + OUT;
            !milled(at, z) && !self.holes.iter().any(|other| other.system == seen.system && opened(other))
        });
        if metal {
            self.tell(block, "rapid-through-wall", |note| note.with("z", round_to(z, 3)), seen.tool);
        }
    }

    /// A rapid down deeper than the floor of a hole milled by a circle.
    fn meets_floor(&mut self, at: Point, z: f64, block: BlockRef, seen: Seen, milled: &impl Fn(Point, f64) -> bool) {
        let around =
            |hole: &&Hole| hole.system == seen.system && hole.round && apart(at, hole.centre) < hole.inside + NEAR;
        let bottom = self.holes.iter().filter(around).map(|hole| hole.bottom).reduce(f64::min);
        let Some(bottom) = bottom.filter(|bottom| *bottom > z + BELOW) else { return };
        let deeper = |hole: &Hole| hole.bottom <= z + BELOW && apart(at, hole.centre) < WIDEST;
        if !milled(at, z) && !self.holes.iter().any(deeper) {
            self.floor = Some((z, bottom, block));
        }
    }

    /// The tool cuts: where it has come into a floor, that is told.
    fn cuts(&mut self, seen: Seen) {
        if let Some((z, bottom, block)) = self.floor.take() {
            let figures = |note: Note| note.with("z", round_to(z, 3)).with("other", round_to(bottom, 3));
            self.tell(block, "rapid-into-floor", figures, seen.tool);
        }
    }

    /// A feed down begins higher than the rapid that came to its place from the side.
    fn begins(&mut self, at: Point, begin: f64, seen: Seen) {
        let Some((_, z, block)) = self.across.take().filter(|(place, ..)| apart(*place, at) < NEAR) else { return };
        if begin <= z + BELOW || begin < -BELOW {
            return;
        }
        let code = if begin - z > OVER_FACE { "rapid-under-begin" } else { "rapid-under-begin-maybe" };
        let figures = |note: Note| note.with("z", round_to(z, 3)).with("other", round_to(begin, 3));
        self.tell(block, code, figures, seen.tool);
    }

    fn tell(&mut self, block: BlockRef, code: &'static str, figures: impl FnOnce(Note) -> Note, tool: u32) {
        let note = figures(Note::new(code).with("tool", tool));
        if self.told.len() < MOST && !self.told.iter().any(|(_, known, other)| *known == code && *other == note) {
            self.told.push((block, code, note));
        }
    }

    /// What is told of the run.
    pub fn finish(self) -> Vec<ToldBelow> {
        self.told
    }
}
