//! The duration of a job: the motions of its cycles, the paths between them, tool changes and manual work.
//!
//! Every program written from the job takes this time on the machine: rapids by the slower axis at the machine's rate
//! (textbook 3.9.1, 3.10.2), feeds along their path, dwells as given.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::machine::{Machine, Rapid};
use crate::motion::Position;
use crate::part::Point;
use crate::plan::{HolePlan, Plan, Times, ToolVisit};
use crate::shop::Shop;
use crate::tables::controls::Convention;
use crate::units::{Micrometres, Minutes};

use super::{Cycle, CycleKind, Job, Pause, SetUp, SlotMotion, ToolWork, convention};

/// Times of manual work while a program waits.
#[derive(Clone, Copy, Debug)]
pub struct Hands {
    /// To put a tool into the magazine.
    pub load_tool: Minutes,
    /// To set the bar of a boring tool to a diameter.
    pub set_bar: Minutes,
    /// To turn the part over and clamp it again.
    pub turn_over: Minutes,
}

impl Hands {
    /// By the table `program-conventions`.
    ///
    /// # Errors
    /// The table lacks a figure.
    pub fn read(knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let minutes = |name| convention(name, knowledge).map(|(value, _)| Minutes(value));
        Ok(Self {
            load_tool: minutes(Convention::LoadToolTime)?,
            set_bar: minutes(Convention::SetBarTime)?,
            turn_over: minutes(Convention::TurnOverTime)?,
        })
    }

    /// The time of a pause.
    pub const fn pause(&self, pause: Pause) -> Minutes {
        match pause {
            Pause::LoadTool { .. } => self.load_tool,
            Pause::SetBar { .. } => self.set_bar,
            Pause::TurnOver => self.turn_over,
        }
    }
}

/// The time of one cycle at one point, beginning and ending at the height of the paths between points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Duration {
    /// At feed, into the metal and through it.
    pub feed: Minutes,
    /// At feed beside that: out of the hole, as a reamer leaves, and again over what a pecking drill has drilled.
    pub feed_out: Minutes,
    /// Waiting at the bottom.
    pub dwell: Minutes,
    /// At rapid, up and down.
    pub rapid: Minutes,
}

impl Duration {
    /// All of it.
    pub fn total(&self) -> Minutes {
        self.feed + self.feed_out + self.dwell + self.rapid
    }
}

impl Cycle {
    /// The time it takes at one point.
    pub fn duration(&self, rapid: Rapid) -> Duration {
        let depth = self.begin - self.end;
        let at_feed = |travel: f64| match self.feed_mm_per_min.0 > 0.0 {
            true => Minutes(travel / self.feed_mm_per_min.0),
            false => Minutes(0.0),
        };
        let down = rapid.time(self.out - self.begin);
        let mut took = Duration {
            feed: at_feed(depth.to_mm()),
            feed_out: Minutes(0.0),
            dwell: Minutes(self.dwell_s.map_or(0.0, |dwell| dwell.0 / 60.0)),
            rapid: down + rapid.time(self.out - self.end),
        };
        match &self.kind {
            CycleKind::Drill | CycleKind::BoreStop => {}
            CycleKind::FeedOut => {
                took.feed_out = took.feed;
                took.rapid = down + rapid.time(self.out - self.begin);
            }
            // In and out, as in the machine time of a tap.
            CycleKind::Tap { .. } => {
                took.feed = took.feed + took.feed;
                took.rapid = down + rapid.time(self.out - self.begin);
            }
            CycleKind::Peck { step, clearance } => {
                for reached in bottoms(depth, *step) {
                    took.feed_out = took.feed_out + at_feed(clearance.to_mm());
                    took.rapid = took.rapid + rapid.time(reached) + rapid.time(reached - *clearance);
                }
            }
            CycleKind::ChipBreak { step, retreat } => {
                for _ in bottoms(depth, *step) {
                    took.feed_out = took.feed_out + at_feed(retreat.to_mm());
                    took.rapid = took.rapid + rapid.time(*retreat);
                }
            }
            CycleKind::Circles { levels, radii, plunge_mm_per_min, .. } => {
                let widest = radii.last().copied().unwrap_or_default().to_mm();
                let round: f64 = radii.iter().map(|radius| 2.0 * std::f64::consts::PI * radius.to_mm()).sum();
                let lowest = levels.last().copied().unwrap_or(self.end);
                let down_at_feed = (self.begin - lowest).to_mm();
                took.feed = at_feed(levels.len() as f64 * (round + 2.0 * widest))
                    + plunge_mm_per_min.map_or_else(|| at_feed(down_at_feed), |feed| Minutes(down_at_feed / feed.0));
                took.rapid = down + rapid.time(self.out - lowest);
            }
            CycleKind::Slot(slot) => {
                let (mut at, mut z) = ([0.0, 0.0], self.begin);
                took.feed = Minutes(0.0);
                // On the finest grid: what a program rounds takes no time.
                for made in Self::slot_path(slot, Micrometres::new(1)) {
                    let to = made.to.map(Micrometres::to_mm);
                    let length = match made.motion {
                        SlotMotion::Down(level) => {
                            let down = (z - level).to_mm();
                            z = level;
                            down
                        }
                        SlotMotion::Across => libm::hypot(to[0] - at[0], to[1] - at[1]),
                        SlotMotion::Arc(_, turn) => libm::hypot(to[0] - at[0], to[1] - at[1]) * turn.over_chord(),
                    };
                    at = to;
                    let feed = slot.feed_of(made, self.feed_mm_per_min).0;
                    took.feed = took.feed + Minutes(if feed > 0.0 { length / feed } else { 0.0 });
                }
                took.rapid = down + rapid.time(self.out - z);
            }
        }
        took
    }
}

/// The depths below the beginning where a cycle in steps retracts, without the last.
fn bottoms(depth: Micrometres, step: Micrometres) -> impl Iterator<Item = Micrometres> {
    let step = step.max(Micrometres::new(1));
    std::iter::successors(Some(step), move |reached| Some(*reached + step)).take_while(move |reached| *reached < depth)
}

/// The rapid motions of a work outside its cycles: from the tool-change position over its points and back.
struct RapidTimes {
    rapid: Rapid,
    change_at: Position,
}

impl RapidTimes {
    /// Along X and Y between two points of a set-up; an absent point is the tool-change position.
    fn across(&self, from: Option<Point>, to: Option<Point>, setup: &SetUp) -> Minutes {
        let home = Point { x: self.change_at.x - setup.zero.x, y: self.change_at.y - setup.zero.y };
        let (from, to) = (from.unwrap_or(home), to.unwrap_or(home));
        self.rapid.time((from.x - to.x).abs().max((from.y - to.y).abs()))
    }

    /// The quill from the tool-change position to the height of the paths between points, or back.
    fn down(&self, out: Micrometres, correction: Micrometres, setup: &SetUp) -> Minutes {
        self.rapid.time(self.change_at.z - (setup.zero.z + out + correction))
    }

    /// All rapids that are not part of a cycle.
    fn work_time(&self, work: &ToolWork, correction: Micrometres, setup: &SetUp) -> Minutes {
        let points = || work.stops.iter().map(|stop| Some(stop.at));
        let from = std::iter::once(None).chain(points());
        let to = points().chain([None]);
        let across: Minutes = from.zip(to).map(|(from, to)| self.across(from, to, setup)).sum();
        let height =
            |stop: Option<&super::Stop>| stop.and_then(|stop| work.cycles.get(stop.cycle)).map(|cycle| cycle.out);
        let ends = [height(work.stops.first()), height(work.stops.last())];
        let quill: Minutes = ends.into_iter().flatten().map(|out| self.down(out, correction, setup)).sum();
        across + quill
    }
}

/// Writes into a plan how its time is spent: what the programs of its job need on the machine.
///
/// # Errors
/// The knowledge base has no answer.
pub fn timed(plan: &mut Plan, job: &Job, shop: &Shop<'_>) -> Result<(), KnowledgeError> {
    let hands = Hands::read(shop.knowledge)?;
    let mut time = times(job, &shop.machine, &hands, &mut plan.sequence);
    // Machine time follows the conditions, as beside each transition; programs round feeds down a little.
    let of_hole = |hole: &HolePlan| -> f64 {
        let here = hole.transitions.iter().filter(|step| !step.elsewhere);
        here.map(|step| step.conditions.machine_time_min.0 * hole.count as f64).sum()
    };
    time.machine_min = Minutes(plan.holes.iter().map(of_hole).sum());
    plan.time = time.rounded();
    Ok(())
}

/// The times of a job without machine time, which the plan has; they are rounded together with it. The rapids of each
/// visit of the plan, so far only those across the part, become complete. So do those by the textbook's rule and the
/// lower bound, because no order of the points avoids the rest.
pub fn times(job: &Job, machine: &Machine<'_>, hands: &Hands, visits: &mut [ToolVisit]) -> Times {
    let ways = RapidTimes { rapid: machine.rapids(), change_at: job.change_at };
    // A program begins at the machine's zero and first moves to the tool-change position: that belongs to the first
    // work.
    let Position { x, y, z } = job.change_at;
    let mut begins = Some(ways.rapid.time(x.abs().max(y.abs())) + ways.rapid.time(z));
    let mut sum = Times::default();
    // The rapids of each visit, and the number of rounds in which it is made.
    let mut of_visit: Vec<(Minutes, usize)> = vec![Default::default(); visits.len()];
    let mut in_spindle = None;
    for setup in &job.setups {
        for work in &setup.works {
            let correction = job.correctors.iter().find(|(number, _)| *number == work.corrector);
            let mut rapid = ways.work_time(work, correction.map_or(Micrometres::ZERO, |(_, length)| *length), setup);
            for stop in &work.stops {
                let Some(cycle) = work.cycles.get(stop.cycle) else { continue };
                let took = cycle.duration(ways.rapid);
                sum.feed_out_min = sum.feed_out_min + took.feed_out;
                sum.dwell_min = sum.dwell_min + took.dwell;
                rapid = rapid + took.rapid;
            }
            rapid = rapid + begins.take().unwrap_or_default();
            sum.rapid_min = sum.rapid_min + rapid;
            sum.hand_min = sum.hand_min + work.pauses.iter().map(|pause| hands.pause(*pause)).sum();
            let loaded = work.pauses.iter().any(|pause| matches!(pause, Pause::LoadTool { .. }));
            if loaded || in_spindle != Some(work.place) {
                sum.tool_change_min = sum.tool_change_min + machine.tool_change;
                in_spindle = Some(work.place);
            }
            if let Some((own, rounds)) = of_visit.get_mut(work.visit) {
                (*own, *rounds) = (*own + rapid, *rounds + 1);
            }
        }
    }
    for (visit, (rapid, rounds)) in visits.iter_mut().zip(of_visit) {
        // The part of the time that does not depend on the order of the points.
        let more = rapid.0 - visit.rapid_min.0;
        visit.rapid_min = rapid.rounded(3);
        visit.nearest_rapid_min = Minutes(visit.nearest_rapid_min.0 + more).rounded(3);
        let bound = visit.bound_min.filter(|_| rounds == 1);
        visit.bound_min = bound.map(|bound| Minutes(bound.0 + more).rounded(3));
    }
    sum
}
