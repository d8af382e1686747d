//! What a program does below its zero, which as a rule lies on the face of the part: rapids down where it has cut nothing yet, and
//! feeds that are many times those beside them. With a part the proof knows where metal is.

use std::collections::{BTreeMap, BTreeSet};

use super::drilled::Holes;
use super::named::Names;
use super::walls::Walls;
use super::widths;
use crate::motion::{BlockRef, Motion, MotionStep, Plane, Position, Sense};
use crate::note::Note;
use crate::units::{Micrometres, round_to};

/// How much of a way down at rapid ends below the zero before it is told, mm.
pub(super) const BELOW: f64 = 0.2;
/// How near two points are one, mm.
const NEAR: f64 = 0.05;
/// The most points of a way that are held against one another.
const MOST: usize = 1000;
/// The most stretches of milling that are looked through for every rapid.
const MOST_MILLED: usize = 2000;

type Point = [f64; 2];

/// Where a stretch of cutting was, and how deep.
#[derive(Clone, Copy, Debug)]
struct Room {
    low: Point,
    high: Point,
    bottom: f64,
    /// How far around its way the tool has cut at most, mm.
    reach: f64,
}

impl Room {
    /// Whether something was milled there: a drill makes no room beside it.
    fn is_milled(&self) -> bool {
        self.low != self.high
    }

    fn has(&self, [x, y]: Point, z: f64, around: f64) -> bool {
        let [within_x, within_y] =
            [(x, 0), (y, 1)].map(|(value, axis)| value > self.low[axis] - around && value < self.high[axis] + around);
        within_x && within_y && self.bottom < z + BELOW
    }
}

/// A rapid down below the zero where the program has made no room.
#[derive(Clone, Debug)]
struct Entry {
    at: Point,
    z: f64,
    tool: u32,
    block: BlockRef,
    /// The way at feed from there, below the zero.
    way: Vec<Point>,
    /// Whether the way is one circle.
    circle: bool,
}

/// A feed below the zero: how fast, and its block.
type Fed = (f64, BlockRef);

/// What is told: a block, a code and its figures.
pub(super) type ToldBelow = (BlockRef, &'static str, Note);

/// By what a motion is seen: its zero along Z, the system, the tool, and whether a cycle makes it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub zero: Micrometres,
    pub system: u8,
    pub tool: u32,
    pub in_cycle: bool,
}

/// What a program does below its zero is held against.
#[derive(Clone, Debug, Default)]
pub(super) struct Measure {
    /// How far around its own cuts a program has made room, mm.
    pub around: f64,
    /// How many times the feed of the cuts beside it a feed may be.
    pub times: f64,
    /// How many pitches a tap may come out of a through hole farther than the drill before it.
    pub beyond: f64,
    /// How far from its hole a tap is beside it, mm.
    pub tap_beside: f64,
    /// How many times the depth of the others of its tool a depth may be.
    pub depth_beside: f64,
    /// How far the feed of a turn of a tap may be off its pitch, as a part of it.
    pub tap_near: f64,
    /// The pitches of the threads that comments name for a tool, mm.
    pub threads: BTreeMap<u32, Vec<f64>>,
    /// Tools that break edges, which are there before.
    pub of_edges: BTreeSet<u32>,
    /// The greatest feed of a drill for a turn, as a part of its diameter.
    pub drill_feed: f64,
    /// How many pitches the hole of a thread is narrower than it: at least, at most.
    pub tap_hole: (f64, f64),
    /// How far beyond its hole a reamer may come out of a through one, mm.
    pub reamer_beyond: f64,
    /// How much wider than its hole a reamer may be, mm.
    pub reamer_stock: f64,
    /// What comments say of the tools.
    pub names: Names,
}

/// Watches what a program does below its zero.
#[derive(Clone, Debug, Default)]
pub(super) struct Below {
    measure: Measure,
    holes: Holes,
    walls: Walls,
    rooms: Vec<Room>,
    /// Those of them that were milled.
    milled: Vec<Room>,
    /// The stretch in progress.
    room: Option<Room>,
    entry: Option<Entry>,
    /// The feeds across and down of each tool, where they change.
    feeds: BTreeMap<(u32, bool), Vec<Fed>>,
    /// The last feed down of the hole in progress.
    down: Option<Fed>,
    told: Vec<ToldBelow>,
}

impl Below {
    pub fn new(measure: Measure) -> Self {
        Self { measure, ..Self::default() }
    }

    /// A motion of a tool; a cycle says itself where its rapids end.
    pub fn takes(&mut self, step: &MotionStep, from: Position, seen: Seen) {
        let Seen { zero, tool, in_cycle, .. } = seen;
        let height = |at: Position| (at.z - zero).to_mm();
        let (z, before) = (height(step.at), height(from));
        let [begin, at] = [from, step.at].map(|at| [at.x.to_mm(), at.y.to_mm()]);
        let (rooms, around) = (&self.rooms, self.measure.around);
        self.holes.takes(step, from, (before, z), seen, |z| {
            let mut here = rooms.iter().chain(&self.room).filter(|room| room.has(at, z, around)).peekable();
            let untouched = here.peek().is_none();
            (here.any(Room::is_milled), untouched)
        });
        let radius = self.measure.names.radius(tool);
        let milled = &self.milled;
        let opened = |at: Point, z: f64| {
            milled.iter().chain(&self.room).any(|room| room.is_milled() && room.has(at, z, room.reach))
        };
        // Of a program of so many cuts nothing is said of its walls.
        if milled.len() < MOST_MILLED {
            self.walls.takes(step, [begin, at], (before, z), (seen, radius), opened);
        }
        if step.motion == Motion::Rapid && !in_cycle && z < before {
            widths::comes_down(&self.holes, step, z, seen, &self.measure, &mut self.told);
        }
        match &step.motion {
            // It may go on below to where it cuts.
            Motion::Rapid if z < -BELOW && self.entry.as_ref().is_some_and(|entry| entry.way.len() < 2) => {
                self.entry = self.entry.take().map(|entry| Entry { at, z: entry.z.min(z), way: vec![at], ..entry });
            }
            Motion::Rapid => {
                self.goes_up(tool, z >= -BELOW);
                if z < -BELOW && z < before && !in_cycle && !self.rooms.iter().any(|room| room.has(at, z, around)) {
                    self.entry = Some(Entry { at, z, tool, block: step.block, way: vec![at], circle: false });
                }
            }
            Motion::Feed { feed_mm_per_min } if z < 0.0 => {
                // A cycle says itself from where it cuts.
                self.entry = self.entry.take().filter(|entry| !in_cycle || entry.way.len() > 1);
                self.cuts([begin, at].into_iter(), z, radius);
                self.feeds_at(feed_mm_per_min.0, step.block, begin == at, (before, z), tool);
            }
            // A small arc is honestly fed much slower than a line: its outside is the wall.
            Motion::Arc { plane: Plane::Xy, centre, sense, .. } if z < 0.0 => {
                let points = round([begin, at], centre.map(|it| it.to_mm()), *sense == Sense::Counterclockwise);
                if let Some(entry) = &mut self.entry {
                    entry.circle |= begin == at;
                }
                self.cuts(points, z, radius);
            }
            Motion::Feed { .. } | Motion::Arc { .. } => self.goes_up(tool, true),
            Motion::ToolChange { .. } | Motion::End => self.goes_up(tool, false),
            _ => {}
        }
    }

    /// The tool leaves what it was cutting. Where it cut nothing at all it is told only when it is one that was called, and comes up
    /// again.
    fn goes_up(&mut self, tool: u32, is_up: bool) {
        let room = self.room.take();
        self.milled.extend(room.filter(Room::is_milled));
        self.rooms.extend(room);
        if let Some((feed, block)) = self.down.take() {
            self.feed_of((tool, true), feed, block);
        }
        let Some(entry) = self.entry.take().filter(|entry| (is_up && tool != 0) || entry.way.len() > 1) else { return };
        // A circle about the place may be the wall of a hole that was there before, and an edge that is broken is there.
        let into = entry.is_enclosed() && !entry.circle && !self.measure.of_edges.contains(&entry.tool);
        let code = if into { "rapid-into-pocket" } else { "rapid-below-zero" };
        let note = Note::new(code).with("z", round_to(entry.z, 3)).with("tool", entry.tool);
        if !self.told.iter().any(|(_, known, other)| *known == code && *other == note) {
            self.told.push((entry.block, code, note));
        }
    }

    fn cuts(&mut self, points: impl Iterator<Item = Point>, z: f64, radius: Option<f64>) {
        let reach = radius.unwrap_or(self.measure.around);
        for point in points {
            let room = self.room.get_or_insert(Room { low: point, high: point, bottom: z, reach });
            for ((low, high), along) in room.low.iter_mut().zip(&mut room.high).zip(point) {
                *low = low.min(along);
                *high = high.max(along);
            }
            room.bottom = room.bottom.min(z);
            if let Some(entry) = self.entry.as_mut().filter(|entry| entry.way.len() < MOST) {
                entry.way.push(point);
            }
        }
    }

    fn feeds_at(&mut self, feed: f64, block: BlockRef, upright: bool, (before, z): (f64, f64), tool: u32) {
        if upright && z < before {
            self.down = Some((feed, block));
        } else if !upright && (z - before).abs() < NEAR {
            self.feed_of((tool, false), feed, block);
        }
    }

    fn feed_of(&mut self, of: (u32, bool), feed: f64, block: BlockRef) {
        let feeds = self.feeds.entry(of).or_default();
        if feeds.last().is_none_or(|(last, _)| *last != feed) {
            feeds.push((feed, block));
        }
    }

    /// What is told of the run.
    pub fn finish(mut self) -> Vec<ToldBelow> {
        let milled = |at: Point, z: f64| self.rooms.iter().any(|room| room.is_milled() && room.has(at, z, BELOW));
        let mut of_holes = self.holes.finish(milled, &self.measure);
        of_holes.extend(std::mem::take(&mut self.walls).finish());
        // What is certain needs no doubt.
        let certain = |block: BlockRef| {
            let known = of_holes.iter().filter(|(it, ..)| *it == block);
            known.into_iter().any(|(_, code, _)| {
                ["begins-in-metal", "rapid-into-floor", "drill-at-rapid", "tap-begins-in-hole"].contains(code)
            })
        };
        self.told.retain(|(block, code, _)| *code != "rapid-below-zero" || !certain(*block));
        of_holes.retain(|(_, code, note)| !self.told.iter().any(|(_, known, other)| known == code && other == note));
        self.told.extend(of_holes);
        for ((tool, _), feeds) in &self.feeds {
            for (index, (feed, block)) in feeds.iter().enumerate() {
                let beside = [index.checked_sub(1), Some(index + 1)].into_iter().flatten();
                let beside: Vec<f64> = beside.filter_map(|at| feeds.get(at)).map(|(feed, _)| *feed).collect();
                let most = beside.iter().copied().fold(0.0, f64::max);
                if most > 0.0 && *feed >= self.measure.times * most {
                    let code = "feed-tenfold";
                    let note = Note::new(code).with("tool", *tool).with("feed", round_to(*feed, 1));
                    self.told.push((*block, code, note.with("other", round_to(most, 1))));
                    break;
                }
            }
        }
        self.told
    }
}

impl Entry {
    /// Whether the way from there closes around it: it stands in a pocket.
    fn is_enclosed(&self) -> bool {
        let near = |one: &Point, other: &Point| libm::hypot(one[0] - other[0], one[1] - other[1]) < NEAR;
        (3..self.way.len()).any(|end| {
            let closes = |begin: &usize| self.way.get(*begin).zip(self.way.get(end)).is_some_and(|(a, b)| near(a, b));
            let begin = (1..end - 2).rev().find(closes);
            begin.and_then(|begin| self.way.get(begin..end)).is_some_and(|loop_| is_inside(self.at, loop_))
        })
    }
}

/// Whether a point lies inside a closed line of points.
fn is_inside([x, y]: Point, around: &[Point]) -> bool {
    let mut inside = false;
    let next = around.iter().cycle().skip(1);
    for (one, other) in around.iter().zip(next) {
        if (one[1] > y) != (other[1] > y) {
            let at = one[0] + (y - one[1]) * (other[0] - one[0]) / (other[1] - one[1]);
            inside ^= x < at;
        }
    }
    inside
}

/// Points of an arc, a twelfth of a turn apart.
fn round([from, to]: [Point; 2], centre: Point, ccw: bool) -> impl Iterator<Item = Point> {
    let angle = |at: Point| libm::atan2(at[1] - centre[1], at[0] - centre[0]);
    let (begin, turn) = (angle(from), std::f64::consts::TAU);
    let swept = if ccw { angle(to) - begin } else { begin - angle(to) };
    let swept = swept - turn * libm::floor(swept / turn);
    let swept = if swept < 1e-6 { turn } else { swept };
    let radius = libm::hypot(from[0] - centre[0], from[1] - centre[1]);
    let steps = libm::ceil(swept / turn * 12.0).max(1.0) as usize;
    (0..=steps).map(move |step| {
        let part = swept * step as f64 / steps as f64;
        let at = if ccw { begin + part } else { begin - part };
        [centre[0] + radius * libm::cos(at), centre[1] + radius * libm::sin(at)]
    })
}
