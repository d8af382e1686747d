//! The holes of a program held against one another: a feed that begins in metal that the program itself has touched higher up, taps
//! deeper than their holes or without one, depths with a digit too many. With a part the proof knows the holes.

use std::collections::{BTreeMap, BTreeSet};

use super::below::{BELOW, Measure, Seen, ToldBelow};
use super::widths;
use crate::motion::{BlockRef, Motion, MotionStep, Position, Turning};
use crate::note::Note;
use crate::tables::audit::ToolKind;
use crate::units::{Micrometres, round_to};

/// Heights that differ by less are one, mm.
const SAME: f64 = 0.01;
/// The most holes that are kept, and the most that is told of them.
const MOST: usize = 20_000;
const MOST_TOLD: usize = 100;

/// A place: the system, and X and Y in hundredths.
pub(super) type Place = (u8, i64, i64);

pub(super) fn place(system: u8, at: Position) -> Place {
    let [x, y] = [at.x, at.y].map(|along| along.micrometres().div_euclid(10));
    (system, x, y)
}

/// A way straight down at feed, in one or several steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hole {
    pub place: Place,
    /// The number of the tool change before it: a tool may come into the place of another.
    pub section: usize,
    pub tool: u32,
    /// Where the first feed began and the last ended, over the zero, mm.
    pub begin: f64,
    pub bottom: f64,
    /// Whether the program had milled there before, down to where the feed began; and whether it had cut nothing near it.
    pub milled: bool,
    untouched: bool,
    /// Whether a cycle made it.
    pub in_cycle: bool,
    /// Feed for a turn of a tap, mm.
    pub pitch: Option<f64>,
    /// Feed for a turn on its way down, mm.
    pub per_turn: f64,
    /// Whether a cycle pulled it out of its bottom at rapid: no tap bears that.
    out_at_rapid: bool,
    /// Whether it was made there once more, from its beginning to the same depth, with no move to another place between.
    again: bool,
    /// How often the program had stopped: another part may have come.
    pub stops: usize,
    /// Whether the tool went on sideways at feed.
    pub mills: bool,
    pub block: BlockRef,
    /// How the tool had come below the zero at rapid there.
    plunge: Option<Plunge>,
}

/// A way down at rapid below the zero at a place where its tool has made nothing yet, nor the program milled down to there.
#[derive(Clone, Copy, Debug)]
struct Plunge {
    place: Place,
    zero: Micrometres,
    tool: u32,
    z: f64,
    block: BlockRef,
    /// Whether nothing at all was cut there down to that height.
    untouched: bool,
}

/// The holes of a program.
#[derive(Clone, Debug, Default)]
pub(super) struct Holes {
    pub holes: Vec<Hole>,
    /// The numbers of the holes of each place.
    at: BTreeMap<Place, Vec<usize>>,
    /// Whether the last one goes on.
    open: bool,
    section: usize,
    stops: usize,
    /// Where a tool came over the zero and was fed up, with its section: a Z without its sign.
    risen: BTreeSet<(Place, usize)>,
    /// Feed for a turn on the last way down.
    per_turn: f64,
    turning: Option<Turning>,
    speed: f64,
    /// The plunge at the place where the tool still is.
    plunge: Option<Plunge>,
    /// Those that the tool left upwards at rapid, with nothing fed there.
    rammed: Vec<Plunge>,
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
            Motion::Rapid => {
                if let Some(hole) = self.last().filter(|hole| upright && before == hole.bottom && z > before) {
                    hole.out_at_rapid = seen.in_cycle;
                }
                self.open &= upright;
                self.plunges(step, place(seen.system, from), (before, z), seen, room);
            }
            Motion::Feed { feed_mm_per_min } if upright && z < before => {
                self.per_turn = feed_mm_per_min.0 / self.speed;
                self.down(place(seen.system, at), (before, z), step.block, seen, room);
            }
            Motion::Feed { .. } if upright && before >= 0.0 && z > before && !self.open => {
                self.risen.insert((place(seen.system, at), self.section));
            }
            Motion::Feed { .. } if upright => {}
            Motion::Feed { .. } | Motion::Arc { .. } => {
                if let Some(hole) = self.last().filter(|hole| z < hole.begin) {
                    hole.mills = true;
                }
                (self.open, self.plunge) = (false, None);
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
            Motion::Stop { .. } => {
                self.stops += 1;
                self.plunge = None;
            }
            Motion::ToolChange { .. } | Motion::End => {
                (self.open, self.plunge) = (false, None);
                self.section += 1;
            }
            _ => {}
        }
    }

    /// A rapid; what a cycle does itself shows where its feed begins.
    fn plunges(
        &mut self,
        step: &MotionStep,
        from: Place,
        (before, z): (f64, f64),
        Seen { zero, system, tool, in_cycle }: Seen,
        room: impl FnOnce(f64) -> (bool, bool),
    ) {
        let here = place(system, step.at);
        self.plunge = self.plunge.filter(|plunge| plunge.place == here && plunge.zero == zero);
        if in_cycle {
            return;
        }
        if z > before {
            self.rammed.extend(self.plunge.take().filter(|_| from == here && self.rammed.len() < MOST_TOLD));
        } else if z < before && z < -BELOW && tool != 0 && !self.of(here).any(|hole| hole.section == self.section) {
            let (milled, untouched) = room(z);
            let plunge = Plunge { place: here, zero, tool, z, block: step.block, untouched };
            self.plunge = Some(plunge).filter(|_| !milled);
        }
    }

    /// The holes of a place so far.
    pub fn of(&self, place: Place) -> impl Iterator<Item = &Hole> + '_ {
        self.at.get(&place).into_iter().flatten().filter_map(|at| self.holes.get(*at))
    }

    /// The number of the tool change before the next hole.
    pub const fn section(&self) -> usize {
        self.section
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
        Seen { zero, tool, in_cycle, .. }: Seen,
        room: impl FnOnce(f64) -> (bool, bool),
    ) {
        let plunge = self.plunge.take().filter(|plunge| plunge.place == place && plunge.zero == zero);
        let per_turn = self.per_turn;
        let stops = self.stops;
        if let Some(hole) = self.last() {
            // From the beginning to the same depth once more: a step of a deep thread goes deeper.
            let whole = begin >= hole.begin - SAME && (bottom - hole.bottom).abs() <= SAME;
            hole.again |= (hole.pitch.is_some() || in_cycle) && whole && hole.stops == stops;
            // What ended above the face was its way to it through the air.
            if hole.bottom > -BELOW {
                hole.per_turn = per_turn;
            }
            hole.bottom = hole.bottom.min(bottom);
            return;
        }
        if self.holes.len() == MOST {
            return;
        }
        let (milled, untouched) = if begin < -BELOW { room(begin) } else { (true, false) };
        self.at.entry(place).or_default().push(self.holes.len());
        self.holes.push(Hole {
            place,
            section: self.section,
            tool,
            begin,
            bottom,
            milled,
            untouched,
            in_cycle,
            pitch: None,
            per_turn: self.per_turn,
            out_at_rapid: false,
            again: false,
            stops,
            mills: false,
            block,
            plunge,
        });
        self.open = true;
    }

    /// What is told of them; `milled` says whether the program has milled a place down to a height.
    pub fn finish(&self, milled: impl Fn([f64; 2], f64) -> bool, measure: &Measure) -> Vec<ToldBelow> {
        let mut review = Review { all: self, milled, measure, told: Vec::new() };
        let drills = self.rammed.iter().filter(|plunge| measure.names.kind(plunge.tool) == Some(ToolKind::Drill));
        drills.filter(|plunge| plunge.untouched).for_each(|plunge| review.rams(*plunge));
        let level = |hole: &Hole, begin: f64| (hole.section, hole.place.0, hundredths(begin), hundredths(hole.bottom));
        let levels: BTreeSet<_> = self.holes.iter().map(|hole| level(hole, hole.begin)).collect();
        let taps = self.holes.iter().enumerate().filter(|(_, hole)| hole.pitch.is_some());
        let drilled: BTreeSet<usize> =
            taps.filter(|(at, hole)| review.drilled(*at, hole).is_some()).map(|(_, hole)| hole.section).collect();
        let each = || self.holes.iter().enumerate();
        let widened: BTreeSet<usize> =
            each().filter(|(at, hole)| review.widens_drilled(*at, hole)).map(|(_, hole)| hole.section).collect();
        for (index, hole) in self.holes.iter().enumerate() {
            if widened.contains(&hole.section) && widths::reams(&measure.names, hole) {
                review.widens_nothing(index, hole);
            }
            if hole.begin < -BELOW && !hole.milled {
                review.begins_below(index, hole, levels.contains(&level(hole, -hole.begin)));
            }
            if let Some(plunge) = hole.plunge.filter(|plunge| plunge.untouched && hole.begin > -BELOW && !hole.mills) {
                let kind = measure.names.kind(hole.tool);
                let unnamed = kind.is_none() && hole.out_at_rapid && hole.pitch.is_none();
                if kind == Some(ToolKind::Drill) || unnamed {
                    review.rams(plunge);
                }
            }
            match hole.pitch.filter(|pitch| pitch.is_finite()) {
                Some(pitch) => review.tap(index, hole, pitch, drilled.contains(&hole.section)),
                None if hole.pitch.is_none() => {
                    review.out_of_cycle(hole);
                    if hole.again {
                        review.tell(hole, "hole-again", |note| note.with("z", round_to(hole.bottom, 3)));
                    }
                }
                None => {}
            }
            review.widths(index, hole);
        }
        for (hole, other) in self.tenfold(measure.depth_beside) {
            review.tell(hole, "depth-tenfold", |note| {
                note.with("z", round_to(hole.bottom, 3)).with("other", round_to(other, 3))
            });
        }
        review.told
    }

    /// How far from a tap, mm, the nearest hole lies, no nearer than `least`, that was made before it for no other tap and into which it would cut: no thread
    /// has less than four pitches in its diameter, as M1 has, so within two of them its middle is in that hole's wall.
    fn beside(&self, index: usize, tap: &Hole, pitch: f64, least: f64) -> Option<f64> {
        let off = |other: &Hole| {
            let [x, y] = [other.place.1 - tap.place.1, other.place.2 - tap.place.2].map(|along| along as f64 / 100.0);
            libm::hypot(x, y)
        };
        let holes = self.holes.iter().take(index).filter(|other| {
            let below = other.bottom < -BELOW && other.place.0 == tap.place.0;
            below && other.section != tap.section && other.pitch.is_none() && !other.mills
        });
        holes.map(off).filter(|off| *off > least && *off < 2.0 * pitch).reduce(f64::min)
    }

    /// Holes so many times as deep as the others of their tool that begin at the same height, each with the height to which those go.
    fn tenfold(&self, times: f64) -> Vec<(&Hole, f64)> {
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
            found.extend(row.iter().filter(|hole| hole.bottom <= times * other).map(|hole| (*hole, other)));
        }
        found
    }
}

/// The holes gone through at the end, each beside those before it.
pub(super) struct Review<'a, M> {
    all: &'a Holes,
    milled: M,
    pub measure: &'a Measure,
    told: Vec<ToldBelow>,
}

impl<'a, M: Fn([f64; 2], f64) -> bool> Review<'a, M> {
    /// Tells it once, with its figures.
    pub fn tell(&mut self, hole: &Hole, code: &'static str, figures: impl FnOnce(Note) -> Note) {
        self.tell_at(hole.block, code, figures(Note::new(code).with("tool", hole.tool)));
    }

    fn tell_at(&mut self, block: BlockRef, code: &'static str, note: Note) {
        if self.told.len() < MOST_TOLD && !self.told.iter().any(|(_, known, other)| *known == code && *other == note) {
            self.told.push((block, code, note));
        }
    }

    /// A drill at rapid where no hole is yet.
    fn rams(&mut self, plunge: Plunge) {
        let code = "drill-at-rapid";
        let note = Note::new(code).with("tool", plunge.tool).with("z", round_to(plunge.z, 3));
        self.tell_at(plunge.block, code, note);
    }

    /// The holes made there later.
    pub fn later(&self, index: usize, hole: &Hole) -> impl Iterator<Item = &'a Hole> + '_ {
        let there = self.all.at.get(&hole.place).into_iter().flatten().filter(move |other| **other > index);
        there.filter_map(|other| self.all.holes.get(*other))
    }

    pub fn earlier(&self, index: usize, hole: &Hole) -> impl Iterator<Item = &'a Hole> + '_ {
        let there = self.all.at.get(&hole.place).into_iter().flatten().take_while(move |other| **other < index);
        there.filter_map(|other| self.all.holes.get(*other))
    }

    /// How deep it was drilled: what a tap does itself before it is its way to the hole.
    fn drilled(&self, index: usize, hole: &Hole) -> Option<f64> {
        let others = self.earlier(index, hole).filter(|other| other.pitch.is_none() && other.section != hole.section);
        others.map(|other| other.bottom).reduce(f64::min)
    }

    pub fn is_milled(&self, hole: &Hole) -> bool {
        let (_, x, y) = hole.place;
        (self.milled)([x, y].map(|along| along as f64 / 100.0), hole.bottom)
    }

    /// A feed that begins below the zero where nothing was milled; `mirrored` says that others of its tool begin as far above it and end
    /// as deep.
    fn begins_below(&mut self, index: usize, hole: &Hole, mirrored: bool) {
        let begin = |note: Note| note.with("z", round_to(hole.begin, 3));
        let deepest = self.earlier(index, hole).map(|other| other.bottom).reduce(f64::min);
        let (why, other) = match deepest {
            Some(bottom) if bottom <= hole.begin + BELOW => return,
            Some(bottom) => ("touched", bottom),
            None if mirrored => ("sign", -hole.begin),
            None if hole.in_cycle && hole.untouched && hole.tool != 0 => {
                return self.tell(hole, "rapid-below-zero", begin);
            }
            None => return,
        };
        self.tell(hole, "begins-in-metal", |note| {
            begin(note).with("why", why.to_owned()).with("other", round_to(other, 3))
        });
    }

    /// A tool that a comment calls a tap, fed by its pitch, in a cycle that pulls it out at rapid.
    fn out_of_cycle(&mut self, hole: &Hole) {
        if !hole.out_at_rapid || hole.mills {
            return;
        }
        let near = |known: &f64| (hole.per_turn / known - 1.0).abs() <= self.measure.tap_near;
        let named = self.measure.threads.get(&hole.tool).into_iter().flatten().copied().find(near);
        if let Some(pitch) = named {
            self.tell(hole, "tap-in-drill-cycle", |note| note.with("pitch", round_to(pitch, 3)));
        }
    }

    /// A tap; `others_drilled` says that the program drilled other holes for it.
    fn tap(&mut self, index: usize, hole: &Hole, pitch: f64, others_drilled: bool) {
        // Deeper than before it goes on in steps.
        let again = self.earlier(index, hole).any(|other| {
            let same = other.pitch.is_some() && other.section == hole.section && other.stops == hole.stops;
            same && hole.bottom >= other.bottom - SAME
        });
        if again || hole.again {
            self.tell(hole, "tap-again", |note| note.with("z", round_to(hole.bottom, 3)));
        }
        let begins = Some((hole.begin, hole.block)).filter(|_| hole.begin < -BELOW && !hole.milled);
        let plunges = hole.plunge.map(|plunge| (plunge.z, plunge.block));
        if let Some((z, block)) = plunges.or(begins).filter(|(z, _)| self.only_drilled(index, hole, *z)) {
            let code = "tap-begins-in-hole";
            self.tell_at(block, code, Note::new(code).with("tool", hole.tool).with("z", round_to(z, 3)));
        }
        match self.drilled(index, hole) {
            Some(bottom) if bottom > hole.bottom + SAME => {
                let through = bottom - hole.bottom <= self.measure.beyond * pitch;
                let code = if through { "tap-beyond-hole-maybe" } else { "tap-beyond-hole" };
                self.tell(hole, code, |note| {
                    note.with("z", round_to(hole.bottom, 3)).with("other", round_to(bottom, 3))
                });
            }
            Some(_) => {}
            None => self.without_hole(index, hole, pitch, others_drilled),
        }
    }

    /// Whether at that height, or on the floor above it, one drill was and nothing else: of two tools that went so deep one may have
    /// been a counterbore, and so may one that came down below the zero.
    fn only_drilled(&self, index: usize, hole: &Hole, z: f64) -> bool {
        let others = || self.earlier(index, hole).filter(|other| other.section != hole.section);
        let Some(floor) = others().map(|other| other.bottom).reduce(f64::min).filter(|floor| *floor < -BELOW) else {
            return false;
        };
        let mut wide = others().filter(|other| other.bottom <= z.max(floor) + BELOW);
        matches!((wide.next(), wide.next()), (Some(only), None) if only.begin >= -BELOW && !only.mills)
    }

    /// A tap where nothing was drilled. Where the program only taps, the holes may be there.
    fn without_hole(&mut self, index: usize, hole: &Hole, pitch: f64, others_drilled: bool) {
        let mut risen = self.all.risen.range((hole.place, 0)..(hole.place, hole.section));
        if others_drilled && !self.is_milled(hole) {
            self.tell(hole, "tap-without-hole", |note| note);
        } else if risen.next().is_some() {
            self.tell(hole, "tap-hole-not-cut", |note| note);
        } else if let Some(off) = self.all.beside(index, hole, pitch, self.measure.tap_beside)
            && !self.is_milled(hole)
        {
            self.tell(hole, "tap-beside-hole", |note| note.with("distance", round_to(off, 2)));
        }
    }
}

/// A height by which holes are held against one another.
fn hundredths(height: f64) -> i64 {
    libm::round(height / SAME) as i64
}
