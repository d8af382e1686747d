//! One tool: the spindle, the approach, its cycles and its points.

use crate::job::{self, Cycle, Job, SlotCycle, SlotMotion, Stop, ToolWork};
use crate::motion::Sense;
use crate::part::Point;
use crate::program::block::Block;
use crate::program::written::{Form, LineRole, WorkRef};
use crate::units::{Micrometres, MillimetresPerMinute};

use super::dialect::Dialect;
use super::expand::expand;
use super::{ProgramWriter, Shared};

/// The characters of a subprogram of points besides its blocks.
const SUBPROGRAM: usize = 30;

/// How often each list of further points occurs.
pub(super) fn shared_points(job: &Job, form: Form, dialect: Dialect<'_>) -> Shared {
    let mut counts = Shared::new();
    for work in job.setups.iter().flat_map(|setup| &setup.works) {
        for (cycle, stops) in runs(work) {
            let along = matches!(cycle.kind, job::CycleKind::Circles { .. } | job::CycleKind::Slot(_));
            if !along && !dialect.feeds_beyond(cycle) {
                *counts.entry(further(stops, form, dialect)).or_insert(0) += 1;
            }
        }
    }
    counts
}

/// Successive stops with the same cycle.
fn runs(work: &ToolWork) -> impl Iterator<Item = (&Cycle, &[Stop])> {
    work.stops.chunk_by(|a, b| a.cycle == b.cycle).filter_map(|stops| {
        let cycle = work.cycles.get(stops.first()?.cycle)?;
        Some((cycle, stops))
    })
}

fn point(at: Point, form: Form, dialect: Dialect<'_>) -> Block {
    let at = form.point(at);
    Block::new().word('X', dialect.length(at.x)).word('Y', dialect.length(at.y))
}

/// A block for every stop after the first.
fn further(stops: &[Stop], form: Form, dialect: Dialect<'_>) -> Vec<Block> {
    stops.iter().skip(1).map(|stop| point(stop.at, form, dialect)).collect()
}

impl ProgramWriter<'_> {
    pub(super) fn one_tool(&mut self, work: &ToolWork, work_ref: WorkRef, job: &Job, shared: &Shared) {
        let place = Some(work_ref);
        let (form, dialect) = (self.form, self.dialect);
        let length = |value: Micrometres| dialect.length(form.grid(value));
        let mut speed = None;
        let mut height = None;
        for (index, (cycle, stops)) in runs(work).enumerate() {
            let Some(first) = stops.first() else { continue };
            let number = Some(first.cycle);
            let to = point(first.at, form, dialect);
            if speed != Some(cycle.speed_rpm) {
                for block in dialect.turning(cycle.speed_rpm, index == 0 && work.coolant) {
                    self.push_block(block, LineRole::Spindle, place, number);
                }
            }
            if index == 0 {
                self.push_block(to.clone().g(0).g(work.frame.into()), LineRole::Approach, place, number);
                let known = job.correctors.iter().find(|(corrector, _)| *corrector == work.corrector);
                let value = known.map(|(_, value)| form.grid(*value)).unwrap_or_default();
                for down in dialect.length_on(length(cycle.out), work.corrector, value) {
                    self.push_block(down, LineRole::Approach, place, number);
                }
            } else {
                self.push_block(to.clone().g(0), LineRole::Point, place, number);
                if height != Some(cycle.out) {
                    self.push_block(Block::new().g(0).word('Z', length(cycle.out)), LineRole::Approach, place, number);
                }
            }
            (speed, height) = (Some(cycle.speed_rpm), Some(cycle.out));
            match &cycle.kind {
                job::CycleKind::Circles { plunge_mm_per_min, levels, radii, sense } => {
                    let contour = contour(cycle, (levels, radii, *sense), *plunge_mm_per_min, dialect, form);
                    self.at_each(contour, stops, place);
                }
                job::CycleKind::Slot(slot) => self.at_each(slot_ways(cycle, slot, dialect, form), stops, place),
                // Left out of the job (`Language::leave`): a thread cannot be cut by a feed that the spindle does not follow.
                job::CycleKind::Tap { .. } if !dialect.has(cycle) => {}
                _ if dialect.feeds_beyond(cycle) => self.one_by_one(cycle, stops, place),
                _ if dialect.has(cycle) => self.fixed(cycle, to, stops, place, shared),
                _ => self.expanded(cycle, stops, place),
            }
        }
    }

    /// Motions in increments as a subprogram, called at each point.
    fn at_each(&mut self, motions: Vec<Block>, stops: &[Stop], place: Option<WorkRef>) {
        let number = stops.first().map(|stop| stop.cycle);
        let motions = self.subprogram(motions, place);
        self.call(motions, LineRole::Cycle, place, number);
        for block in further(stops, self.form, self.dialect) {
            self.push_block(block.g(0), LineRole::Point, place, number);
            self.call(motions, LineRole::Cycle, place, number);
        }
    }

    /// A cycle in single motions at each of its points.
    fn expanded(&mut self, cycle: &Cycle, stops: &[Stop], place: Option<WorkRef>) {
        let number = stops.first().map(|stop| stop.cycle);
        for (index, stop) in stops.iter().enumerate() {
            if index > 0 {
                let to = point(stop.at, self.form, self.dialect).g(0);
                self.push_block(to, LineRole::Point, place, number);
            }
            for block in expand(cycle, self.form, self.dialect) {
                self.push_block(block, LineRole::Cycle, place, number);
            }
        }
    }

    /// A fixed cycle that would feed as far as the level of travel: at each point it ends where its feed began, and the rest of the
    /// way up is at rapid.
    fn one_by_one(&mut self, cycle: &Cycle, stops: &[Stop], place: Option<WorkRef>) {
        let (form, dialect) = (self.form, self.dialect);
        let number = stops.first().map(|stop| stop.cycle);
        let up = Block::new().g(0).word('Z', dialect.length(form.grid(cycle.out)));
        for (index, stop) in stops.iter().enumerate() {
            let to = point(stop.at, form, dialect);
            if index > 0 {
                self.push_block(to.clone().g(0), LineRole::Point, place, number);
            }
            let words = dialect.cycle(cycle, 99, |value| form.grid(value));
            self.push_block(words.with(&to), LineRole::Cycle, place, number);
            self.push_block(up.clone(), LineRole::Cycle, place, number);
        }
    }

    /// A fixed cycle at its first point and the further ones.
    fn fixed(&mut self, cycle: &Cycle, to: Block, stops: &[Stop], place: Option<WorkRef>, shared: &Shared) {
        let (form, dialect) = (self.form, self.dialect);
        let number = stops.first().map(|stop| stop.cycle);
        let words = dialect.cycle(cycle, 98, |value| form.grid(value));
        if let Some(block) = dialect.before_cycle(cycle) {
            self.push_block(block, LineRole::Spindle, place, number);
        }
        // The point is in the block itself, because the cycle would not run there otherwise.
        self.push_block(words.with(&to), LineRole::Cycle, place, number);
        let further = further(stops, form, dialect);
        let again = shared.get(&further).copied().unwrap_or(1);
        let once: usize = further.iter().map(|block| block.text().len() + 6).sum();
        if again > 1 && once + SUBPROGRAM < once * again {
            let points = self.subprogram(further, None);
            self.call(points, LineRole::Point, place, number);
        } else {
            for block in further {
                self.push_block(block, LineRole::Point, place, number);
            }
        }
        self.push_block(Block::new().g(80), LineRole::Cycle, place, number);
    }
}

/// The contour of a mill around its point.
fn contour(
    cycle: &Cycle,
    (levels, radii, sense): (&[Micrometres], &[Micrometres], Sense),
    plunge: Option<MillimetresPerMinute>,
    dialect: Dialect<'_>,
    form: Form,
) -> Vec<Block> {
    let length = |value: Micrometres| dialect.length(form.grid(value));
    let code = match sense {
        Sense::Clockwise => 2,
        Sense::Counterclockwise => 3,
    };
    let mut blocks = vec![Block::new().g(90).g(0).word('Z', length(cycle.begin))];
    for level in levels {
        let feed = dialect.feed(cycle.feed_mm_per_min);
        let down = plunge.map_or_else(|| feed.clone(), |plunge| dialect.feed(plunge));
        blocks.push(Block::new().g(90).g(1).word('Z', length(*level)).word('F', down));
        // The circles set their own feed after the descent.
        let mut again = plunge.map(|_| feed);
        let mut at = Micrometres::ZERO;
        for radius in radii.iter().map(|radius| form.grid(*radius)) {
            let out = Block::new().g(91).g(1).word('X', dialect.length(radius - at));
            blocks.push(match again.take() {
                Some(feed) => out.word('F', feed),
                None => out,
            });
            blocks.push(dialect.circle(code, radius));
            at = radius;
        }
        blocks.push(Block::new().g(1).word('X', dialect.length(-at)));
    }
    blocks.push(Block::new().g(90).g(0).word('Z', length(cycle.out)));
    blocks
}

/// The way of a mill through a slot, in increments from its point.
fn slot_ways(cycle: &Cycle, slot: &SlotCycle, dialect: Dialect<'_>, form: Form) -> Vec<Block> {
    let length = |value: Micrometres| dialect.length(value);
    let code = match slot.sense {
        Sense::Clockwise => 2,
        Sense::Counterclockwise => 3,
    };
    let mut blocks = vec![Block::new().g(90).g(0).word('Z', length(form.grid(cycle.begin)))];
    let (mut at, mut fed) = ([Micrometres::ZERO; 2], None);
    for made in Cycle::slot_path(slot, form.resolution) {
        let [x, y] = [made.to[0] - at[0], made.to[1] - at[1]].map(length);
        let block = match made.motion {
            SlotMotion::Down(level) => Block::new().g(90).g(1).word('Z', length(level)),
            SlotMotion::Across => Block::new().g(91).g(1).word('X', x).word('Y', y),
            SlotMotion::Arc(centre, _) => {
                let [i, j] = [centre[0] - at[0], centre[1] - at[1]].map(length);
                Block::new().g(91).g(code).word('X', x).word('Y', y).word('I', i).word('J', j)
            }
        };
        let feed = slot.feed_of(made, cycle.feed_mm_per_min);
        blocks.push(if fed == Some(feed.0) { block } else { block.word('F', dialect.feed(feed)) });
        (at, fed) = (made.to, Some(feed.0));
    }
    blocks.push(Block::new().g(90).g(0).word('Z', length(form.grid(cycle.out))));
    blocks
}
