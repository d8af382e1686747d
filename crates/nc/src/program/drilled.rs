//! The holes of a program held against one another: a feed that begins in metal that the program itself has touched higher up, taps
//! deeper than their holes or without one, depths with a digit too many. With a part the proof knows the holes.

use std::collections::{BTreeMap, BTreeSet};

use super::below::{BELOW, Seen, ToldBelow};
use crate::motion::{BlockRef, Motion, MotionStep, Position, Turning};
use crate::note::Note;
use crate::units::round_to;

/// Heights that differ by less are one, mm.
const SAME: f64 = 0.01;
/// A depth so many times that of the others has a digit too many: ten, less what they differ.
const TENFOLD: f64 = 9.5;
/// The most holes that are kept, and the most that is told of them.
const MOST: usize = 20_000;
const MOST_TOLD: usize = 100;

/// A place: the system, and X and Y in hundredths.
type Place = (u8, i64, i64);

/// A way straight down at feed, in one or several steps.
#[derive(Clone, Copy, Debug)]
struct Hole {
    place: Place,
    /// The number of the tool change before it: a tool may come into the place of another.
    section: usize,
    tool: u32,
    /// Where the first feed began and the last ended, over the zero, mm.
    begin: f64,
    bottom: f64,
    /// Whether the program had milled there before, down to where the feed began; and whether it had cut nothing near it.
    milled: bool,
    untouched: bool,
    /// Whether a cycle made it.
    in_cycle: bool,
    /// Feed for a turn of a tap, mm.
    pitch: Option<f64>,
    /// Whether the tool went on sideways at feed.
    mills: bool,
    block: BlockRef,
}

/// The holes of a program.
#[derive(Clone, Debug, Default)]
pub(super) struct Holes {
    holes: Vec<Hole>,
    /// Whether the last one goes on.
    open: bool,
    section: usize,
    /// Feed for a turn on the last way down.
    per_turn: f64,
    turning: Option<Turning>,
    speed: f64,
}

impl Holes {
    /// A step, with heights over the zero before and behind it; `room` says of a height whether the program had milled down to it here,
    /// and whether it had cut nothing near it.
    pub fn takes(
        &mut self,
        step: &MotionStep,
        from: Position,
        (before, z): (f64, f64),
        seen: Seen,
        room: impl FnOnce(f64) -> (bool, bool),
    ) {
        let at = step.at;
        let upright = from.x == at.x && from.y == at.y;
        match &step.motion {
            Motion::Rapid => self.open &= upright,
            Motion::Feed { feed_mm_per_min } if upright && z < before => {
                self.per_turn = feed_mm_per_min.0 / self.speed;
                let [x, y] = [at.x, at.y].map(|along| along.micrometres().div_euclid(10));
                self.down((seen.system, x, y), (before, z), step.block, seen, room);
            }
            Motion::Feed { .. } if upright => {}
            Motion::Feed { .. } | Motion::Arc { .. } => {
                if let Some(hole) = self.last().filter(|hole| z < hole.begin) {
                    hole.mills = true;
                }
                self.open = false;
            }
            Motion::Spindle { turning, speed_rpm } => {
                self.speed = speed_rpm.0;
                if *turning == Turning::Stopped {
                    return;
                }
                let before = self.turning.replace(*turning);
                let pitch = self.per_turn;
                if let Some(hole) = self.last().filter(|_| before == Some(turning.reversed())) {
                    hole.pitch.get_or_insert(pitch);
                }
            }
            Motion::ToolChange { .. } | Motion::End => {
                self.open = false;
                self.section += 1;
            }
            _ => {}
        }
    }

    fn last(&mut self) -> Option<&mut Hole> {
        let open = self.open;
        self.holes.last_mut().filter(|_| open)
    }

    fn down(
        &mut self,
        place: Place,
        (begin, bottom): (f64, f64),
        block: BlockRef,
        Seen { tool, in_cycle, .. }: Seen,
        room: impl FnOnce(f64) -> (bool, bool),
    ) {
        if let Some(hole) = self.last() {
            hole.bottom = hole.bottom.min(bottom);
            return;
        }
        if self.holes.len() == MOST {
            return;
        }
        let (milled, untouched) = if begin < -BELOW { room(begin) } else { (true, false) };
        let (pitch, mills, section) = (None, false, self.section);
        self.holes.push(Hole { place, section, tool, begin, bottom, milled, untouched, in_cycle, pitch, mills, block });
        self.open = true;
    }

    /// What is told of them; `milled` says whether the program has milled a place down to a height, and `beyond` how many pitches a tap
    /// may come out of a through hole farther than the drill before it.
    pub fn finish(&self, milled: impl Fn([f64; 2], f64) -> bool, beyond: f64) -> Vec<ToldBelow> {
        let mut at: BTreeMap<Place, Vec<usize>> = BTreeMap::new();
        for (index, hole) in self.holes.iter().enumerate() {
            at.entry(hole.place).or_default().push(index);
        }
        let earlier = |index: usize, hole: &Hole| {
            let there = at.get(&hole.place).into_iter().flatten().take_while(move |other| **other < index);
            there.filter_map(|other| self.holes.get(*other))
        };
        let deepest = |index: usize, hole: &Hole| earlier(index, hole).map(|other| other.bottom).reduce(f64::min);
        // What a tap does itself before it is its way to the hole.
        let drilled = |index: usize, hole: &Hole| {
            let others = earlier(index, hole).filter(|other| other.pitch.is_none() && other.section != hole.section);
            others.map(|other| other.bottom).reduce(f64::min)
        };
        let mut told = Vec::new();
        let mut tell = |block: BlockRef, code: &'static str, note: Note| {
            if told.len() < MOST_TOLD && !told.iter().any(|(_, known, other)| *known == code && *other == note) {
                told.push((block, code, note));
            }
        };
        let taps = self.holes.iter().enumerate().filter(|(_, hole)| hole.pitch.is_some());
        let taps_drilled: BTreeSet<usize> =
            taps.filter(|(at, hole)| drilled(*at, hole).is_some()).map(|(_, hole)| hole.section).collect();
        let level = |hole: &Hole, begin: f64| (hole.section, hole.place.0, hundredths(begin), hundredths(hole.bottom));
        let levels: BTreeSet<_> = self.holes.iter().map(|hole| level(hole, hole.begin)).collect();
        for (index, hole) in self.holes.iter().enumerate() {
            let note = |code| Note::new(code).with("tool", hole.tool);
            if hole.begin < -BELOW && !hole.milled {
                let code = "begins-in-metal";
                match deepest(index, hole) {
                    Some(bottom) if bottom <= hole.begin + BELOW => {}
                    Some(bottom) => {
                        let note = note(code).with("z", round_to(hole.begin, 3)).with("why", "touched".to_owned());
                        tell(hole.block, code, note.with("other", round_to(bottom, 3)));
                    }
                    // As far below the zero as others of the tool above it, and as deep.
                    None if levels.contains(&level(hole, -hole.begin)) => {
                        let note = note(code).with("z", round_to(hole.begin, 3)).with("why", "sign".to_owned());
                        tell(hole.block, code, note.with("other", round_to(-hole.begin, 3)));
                    }
                    None if hole.in_cycle && hole.untouched && hole.tool != 0 => {
                        let code = "rapid-below-zero";
                        tell(hole.block, code, note(code).with("z", round_to(hole.begin, 3)));
                    }
                    None => {}
                }
            }
            let Some(pitch) = hole.pitch.filter(|pitch| pitch.is_finite()) else { continue };
            match drilled(index, hole) {
                Some(bottom) if bottom > hole.bottom + SAME => {
                    let through = bottom - hole.bottom <= beyond * pitch;
                    let code = if through { "tap-beyond-hole-maybe" } else { "tap-beyond-hole" };
                    let note = note(code).with("z", round_to(hole.bottom, 3)).with("other", round_to(bottom, 3));
                    tell(hole.block, code, note);
                }
                Some(_) => {}
                None => {
                    let (_, x, y) = hole.place;
                    if taps_drilled.contains(&hole.section)
                        && !milled([x, y].map(|along| along as f64 / 100.0), hole.bottom)
                    {
                        tell(hole.block, "tap-without-hole", note("tap-without-hole"));
                    }
                }
            }
        }
        for (hole, other) in self.tenfold() {
            let note = Note::new("depth-tenfold").with("tool", hole.tool).with("z", round_to(hole.bottom, 3));
            tell(hole.block, "depth-tenfold", note.with("other", round_to(other, 3)));
        }
        told
    }

    /// Holes ten times as deep as the others of their tool that begin at the same height, each with the height to which those go.
    fn tenfold(&self) -> Vec<(&Hole, f64)> {
        let mut rows: BTreeMap<(usize, u8, i64), Vec<&Hole>> = BTreeMap::new();
        for hole in self.holes.iter().filter(|hole| !hole.mills && hole.bottom < 0.0) {
            rows.entry((hole.section, hole.place.0, hundredths(hole.begin))).or_default().push(hole);
        }
        let mut found = Vec::new();
        for row in rows.values_mut().filter(|row| row.len() > 2) {
            let mut bottoms: Vec<f64> = row.iter().map(|hole| hole.bottom).collect();
            bottoms.sort_by(f64::total_cmp);
            // The middle one, of two the deeper.
            let Some(other) = bottoms.get((bottoms.len() - 1) / 2).copied() else { continue };
            found.extend(row.iter().filter(|hole| hole.bottom <= TENFOLD * other).map(|hole| (*hole, other)));
        }
        found
    }
}

/// A height by which holes are held against one another.
fn hundredths(height: f64) -> i64 {
    libm::round(height / SAME) as i64
}
