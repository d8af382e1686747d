//! Turns stays into cuts: one path of the tip into the part and out of it, with its pecks and circles together.

use super::walk::{PointVisit, TipMotion, TipMove};
use crate::motion::{BlockRef, Sense, Turning};
use crate::units::Micrometres;

/// Positions that differ by no more are equal: a step of the machine, 0.01 mm.
pub(super) const TOLERANCE: Micrometres = Micrometres::new(10);

/// Whether two positions are the same to a step of the machine.
pub(super) fn same_position(a: Micrometres, b: Micrometres) -> bool {
    (a - b).abs() <= TOLERANCE
}

/// One path into the part at a point.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Descent {
    /// Its stay.
    pub visit: usize,
    /// The tool change it follows.
    pub section: usize,
    /// The tool, as the program calls it.
    pub tool: u32,
    /// The place of its set-up in the job.
    pub setup: usize,
    /// The point.
    pub at: [Micrometres; 2],
    /// The block that brought the tool here; for a second cut at the same point, its own block.
    pub place: BlockRef,
    /// The block of its first feed.
    pub block: BlockRef,
    /// Its place among the steps.
    pub order: usize,
    /// The offset register in force, none where the program gives the value, and the added value.
    pub corrector: (Option<u32>, Micrometres),
    /// From the first motion below the face to the last.
    pub moves: Vec<TipMove>,
    /// The height to which the tip rose afterwards, before it went on or down again.
    pub retracted_to: Micrometres,
    /// Z where a feed towards it began above the face: steps of a deep hole that end in the air.
    pub begun_above: Option<Micrometres>,
    /// Z where the feed began that led into it with no rapid between: to the face, say, and on from there.
    pub fed_from: Option<Micrometres>,
}

/// The cuts of a stay, and its motions above the face, each with the cut that follows.
pub(super) fn cuts(
    number: usize,
    stay: &PointVisit,
    top: Micrometres,
) -> (Vec<Descent>, Vec<(Option<usize>, TipMove)>) {
    let mut cuts: Vec<Descent> = Vec::new();
    let mut above: Vec<(Option<usize>, TipMove)> = Vec::new();
    // The last motion was below the face.
    let mut inside = false;
    let mut begun_above: Option<Micrometres> = None;
    let mut fed_from: Option<Micrometres> = None;
    // Spindle switches and dwells happen at the position of the tip.
    let low = |made: &TipMove| if made.moves() { made.below(top) } else { made.to[2] < top };
    for (index, made) in stay.moves.iter().enumerate() {
        if !low(made) {
            if let Some(cut) = cuts.last_mut() {
                cut.retracted_to = cut.retracted_to.max(made.to[2]);
            }
            inside = false;
            if made.feed().is_some() {
                begun_above = begun_above.max(Some(made.from[2]));
                fed_from = fed_from.max(Some(made.from[2]));
            } else if made.moves() {
                fed_from = None;
            }
            above.push((None, *made));
            continue;
        }
        // A new entry from exactly the face is a new cut too.
        let from_above = made.moves() && made.from[2] >= top;
        if (!inside || from_above) && !cuts.last().is_some_and(|cut| continues_cut(cut, &stay.moves[index..], top)) {
            for (leads, _) in above.iter_mut().rev().take_while(|(leads, _)| leads.is_none()) {
                *leads = Some(cuts.len());
            }
            let place = if cuts.is_empty() { stay.block } else { made.block };
            cuts.push(Descent {
                visit: number,
                section: stay.section,
                tool: stay.tool,
                setup: stay.setup,
                at: stay.at,
                place,
                block: made.block,
                order: made.order,
                corrector: made.corrector,
                moves: Vec::new(),
                retracted_to: Micrometres::new(i64::MIN / 4),
                begun_above: begun_above.take(),
                fed_from: fed_from.filter(|_| made.feed().is_some()),
            });
        }
        inside = true;
        fed_from = None;
        if let Some(cut) = cuts.last_mut() {
            cut.moves.push(*made);
            cut.retracted_to = cut.retracted_to.max(made.to[2]);
        }
    }
    // A cut begins and ends above the face: motions that lead to no cut belong to the travel.
    (cuts, above)
}

/// Whether a new entry continues a cut: the tool left it no higher than its feed began, and feeds deeper from below.
/// So does a drill that comes out to clear its chips.
fn continues_cut(cut: &Descent, rest: &[TipMove], top: Micrometres) -> bool {
    let Some(begin) = cut.begin().max(cut.begun_above) else { return false };
    let Some(feed) = rest.iter().find(|made| made.feed().is_some()).filter(|made| made.below(top)) else {
        return false;
    };
    cut.retracted_to <= begin + TOLERANCE && feed.from[2] < begin - TOLERANCE && feed.to[2] < cut.deepest()
}

impl Descent {
    /// Z where its first feed begins; absent if it never feeds.
    pub fn begin(&self) -> Option<Micrometres> {
        self.moves.iter().find(|made| made.feed().is_some()).map(|made| made.from[2])
    }

    /// Z of its deepest point.
    pub fn deepest(&self) -> Micrometres {
        self.moves.iter().map(|made| made.to[2]).min().unwrap_or_default()
    }

    /// Its feeds downwards: from where to where; successive ones are joined.
    pub fn downs(&self) -> Vec<(Micrometres, Micrometres)> {
        let mut downs: Vec<(Micrometres, Micrometres)> = Vec::new();
        let mut goes_on = false;
        for made in self.moves.iter().filter(|made| made.moves()) {
            let down = matches!(made.motion, TipMotion::Feed(_)) && made.to[2] < made.from[2];
            match downs.last_mut() {
                Some(last) if down && goes_on => last.1 = made.to[2],
                _ if down => downs.push((made.from[2], made.to[2])),
                _ => {}
            }
            goes_on = down;
        }
        downs
    }

    /// How high the tip rose between its feeds downwards.
    pub fn returns(&self, top: Micrometres) -> Vec<Micrometres> {
        let mut returns = Vec::new();
        let mut highest: Option<Micrometres> = None;
        for made in self.moves.iter().filter(|made| made.moves()) {
            if matches!(made.motion, TipMotion::Feed(_)) && made.to[2] < made.from[2] {
                returns.extend(highest.take());
                continue;
            }
            let reached = made.to[2].max(made.from[2]);
            highest = highest.max(Some(reached.max(if made.below(top) { reached } else { top })));
        }
        // Motions before the first feed downwards are no return.
        let first = self.moves.iter().find(|made| made.moves());
        if first.is_some_and(|made| made.motion == TipMotion::Rapid) && !returns.is_empty() {
            returns.remove(0);
        }
        returns
    }

    /// The motions after the tip left its deepest point for the last time.
    pub fn way_out(&self) -> &[TipMove] {
        let deepest = self.deepest();
        let last = self.moves.iter().rposition(|made| made.moves() && made.to[2] == deepest).map_or(0, |at| at + 1);
        &self.moves[last..]
    }

    /// How long it waited at its deepest point, s.
    pub fn dwell(&self) -> f64 {
        let deepest = self.deepest();
        let waits = self.moves.iter().filter(|made| made.to[2] == deepest);
        waits.map(|made| if let TipMotion::Dwell(seconds) = made.motion { seconds } else { 0.0 }).sum()
    }

    /// Waits elsewhere, s.
    pub fn other_dwells(&self) -> f64 {
        let deepest = self.deepest();
        let waits = self.moves.iter().filter(|made| made.to[2] != deepest);
        waits.map(|made| if let TipMotion::Dwell(seconds) = made.motion { seconds } else { 0.0 }).sum()
    }

    /// Its circles in order: depth, centre, radius in mm and sense; successive arcs of one circle are joined, with
    /// their total angle, rad.
    pub fn circles(&self) -> Vec<Circle> {
        let mut circles: Vec<Circle> = Vec::new();
        let mut goes_on = false;
        for made in self.moves.iter().filter(|made| made.moves()) {
            let TipMotion::Round { centre, radius, sense, turned, .. } = made.motion else {
                goes_on = false;
                continue;
            };
            let next = Circle { z: made.to[2], from_z: made.from[2], centre, radius, sense, turned, block: made.block };
            match circles.last_mut() {
                Some(last) if goes_on && last.same_circle(&next) => last.turned += turned,
                _ => circles.push(next),
            }
            goes_on = true;
        }
        circles
    }

    /// The motions in the metal: at feed, without the retract.
    pub fn cutting(&self) -> impl Iterator<Item = &TipMove> {
        let into = self.moves.len() - self.way_out().len();
        self.moves[..into].iter().filter(|made| made.feed().is_some())
    }

    /// Whether the spindle turned right while it cut.
    pub fn turning(&self) -> Turning {
        let wrong = self.cutting().map(|made| made.turning).find(|turning| *turning != Turning::Clockwise);
        wrong.unwrap_or(Turning::Clockwise)
    }
}

/// A circle of a mill.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Circle {
    pub from_z: Micrometres,
    pub z: Micrometres,
    pub centre: [Micrometres; 2],
    pub radius: f64,
    pub sense: Sense,
    pub turned: f64,
    pub block: BlockRef,
}

impl Circle {
    fn same_circle(&self, other: &Self) -> bool {
        self.z == other.z
            && self.centre == other.centre
            && self.sense == other.sense
            && (self.radius - other.radius).abs() < 0.005
    }
}
