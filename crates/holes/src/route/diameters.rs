//! Intermediate diameters, computed backwards from the finished cylinder by the allowances of section 1.2.1 and,
//! within them, by the step diameters of the handbook. Drills are here, rough boring and milling in `boring`,
//! transitions that remove an allowance in `finishing`; `two_passes` splits the drilling.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::note::{Because, Figure, Note};
use crate::part::{ThreadKind, ToleratedDiameter, tolerance_width};
use crate::plan::Operation;
use crate::reason::Reason;
use crate::shop::Shop;
use crate::tables::holes::HoleDefault;
use crate::tables::rules::{BoringInstead, MillInstead, MillOrBoreFor, StockForElsewhereFor, TooSmallToBoreFor};
use crate::tables::standards::ConicalThread;
use crate::units::Micrometres;

use super::bores::Bore;
use super::point::{cone, point_angle};
use super::{Candidate, RouteStep, accuracy};

mod allowance;
mod boring;
mod finishing;
mod two_passes;

use allowance::allowance;
pub use allowance::{Range, range};
use two_passes::two_passes;

/// What is needed to turn a route into steps.
#[derive(Clone, Copy, Debug)]
pub struct Sizes<'a> {
    /// All drills that reach deep enough, ascending.
    pub drills: &'a [Micrometres],
    /// Drills that other holes have in the magazine.
    pub in_magazine: &'a [Micrometres],
    /// The smallest hole that a boring bar of the catalogs can enter.
    pub smallest_bore: Micrometres,
    /// How far a tool runs past the end of a blind and of a through cylinder.
    pub overruns: [Micrometres; 2],
    /// The diameter the cylinder is opened from; absent in solid metal.
    pub start: Option<Micrometres>,
    /// Whether to drill in one pass although a first drill is available.
    pub single_drill: bool,
    /// Whether to bore although the rule `mill-or-bore` prefers milling.
    pub bore_large: bool,
    /// Whether a flat floor is made; otherwise the cone of the drill stays there.
    pub level_floor: bool,
}

impl Sizes<'_> {
    /// The diameter that a transition leaves where it is the last: where no bar enters, another tool bores in its place.
    ///
    /// # Errors
    /// The knowledge base has no answer.
    pub fn last_size(&self, operation: Operation, bore: &Bore, shop: &Shop<'_>) -> Result<Micrometres, KnowledgeError> {
        let enters = bore.diameter.nominal >= self.smallest_bore;
        if enters { shop.aimed_by(operation, &bore.diameter) } else { shop.aimed(&bore.diameter) }
    }
}

/// The steps of a candidate for a cylinder, first to last; centring gets its spot later, when the drill is known.
///
/// # Errors
/// The knowledge base has no answer. Where no diameters fit, the refusal says why.
pub fn steps(candidate: &Candidate, bore: &Bore, sizes: &Sizes<'_>, shop: &Shop<'_>) -> Tried<Vec<RouteStep>> {
    let (transitions, replaced) = milled(&candidate.transitions, bore, sizes, shop)?;
    let Finished { mut after, slack, because: left, elsewhere } =
        finished(candidate, transitions.last().copied(), bore, sizes, shop)?;
    let mut steps: Vec<RouteStep> = Vec::new();
    let (after_here, mut bored_elsewhere) = (after, Vec::new());
    for index in (0..transitions.len()).rev() {
        let previous = index.checked_sub(1).map(|before| transitions[before]);
        let question = BackwardStep { operation: transitions[index], leaves: after, previous, bore, sizes, shop };
        let mut made = if steps.is_empty() && transitions[index] == Operation::Drill {
            vec![question.last_drill(slack)?]
        } else {
            question.steps()?
        };
        after = made.first().map_or(after, |first| first.from);
        if let Some(last) = made.last_mut()
            && steps.is_empty()
        {
            last.because.extend(left.clone());
        }
        steps.extend(made.into_iter().rev());
    }
    steps.reverse();
    if let Some(reason) = replaced
        && let Some(step) = steps.iter_mut().find(|step| step.operation == Operation::Mill)
    {
        step.because.push(reason);
    }
    if let (Some((_, first)), Some(last)) = (elsewhere.first(), steps.last_mut())
        && *first - last.diameter > slack.unwrap_or_default() + (*first - after_here)
    {
        // The first transition on the other machine may find more stock: that machine bores the rest away first, and
        // the drill leaves what rough boring needs.
        let previous = Some(last.operation);
        let question =
            BackwardStep { operation: Operation::RoughBore, leaves: after_here, previous, bore, sizes, shop };
        let rough = question.rough_bore()?;
        last.diameter = rough.first().map_or(last.diameter, |first| first.from);
        bored_elsewhere = rough;
    }
    two_passes(&mut steps, bore, sizes, shop)?;
    steps.extend(bored_elsewhere.into_iter().map(|rough| RouteStep { elsewhere: true, ..rough }));
    for (operation, diameter) in elsewhere {
        let from = steps.last().map_or(Micrometres::ZERO, |last| last.diameter);
        steps.push(RouteStep { elsewhere: true, ..RouteStep::plain(operation, bore.place, diameter, from) });
    }
    Ok(steps)
}

/// Where a route ends on this machine.
struct Finished {
    /// The diameter; with the most stock, where another machine finishes the hole.
    after: Micrometres,
    /// How much wider the hole may be left for that machine; absent if none finishes it.
    slack: Option<Micrometres>,
    because: Option<Because>,
    /// The transitions on that machine, each with the diameter it leaves.
    elsewhere: Vec<(Operation, Micrometres)>,
}

/// The transitions, with milling for the first opening where the rule `mill-or-bore` requires it.
fn milled(
    transitions: &[Operation],
    bore: &Bore,
    sizes: &Sizes<'_>,
    shop: &Shop<'_>,
) -> Result<(Vec<Operation>, Option<Because>), KnowledgeError> {
    let mut transitions = transitions.to_vec();
    let Some(first) = transitions.iter().position(|operation| *operation == Operation::RoughBore) else {
        return Ok((transitions, None));
    };
    if sizes.bore_large || transitions.contains(&Operation::Mill) {
        return Ok((transitions, None));
    }
    let diameter = bore.diameter.nominal;
    let question = MillOrBoreFor { operation: Operation::RoughBore, contouring: shop.machine.contouring, diameter };
    let answer = shop.knowledge.ask(&question)?;
    if answer.need("this hole")?.instead == MillInstead::Same {
        return Ok((transitions, None));
    }
    transitions[first] = Operation::Mill;
    let note = Note::new("milled-instead").with("diameter", diameter);
    Ok((transitions, Some(Because::answer(&answer.answer, note))))
}

/// The diameter where the route ends: that of the cylinder, or less by the stock for finishing on another machine
/// (rule `stock-for-elsewhere`), with the transitions of that machine; for a thread its own diameter.
fn finished(
    candidate: &Candidate,
    last: Option<Operation>,
    bore: &Bore,
    sizes: &Sizes<'_>,
    shop: &Shop<'_>,
) -> Result<Finished, KnowledgeError> {
    let here = |after| Finished { after, slack: None, because: None, elsewhere: Vec::new() };
    if let (Some(thread), Some(Operation::Tap)) = (&bore.thread, candidate.transitions.last()) {
        return Ok(here(thread.size));
    }
    let target = shop.aimed(&bore.diameter)?;
    if !candidate.finish_elsewhere {
        return match last {
            Some(last) => sizes.last_size(last, bore, shop).map(here),
            None => Ok(here(target)),
        };
    }
    let rule = shop.knowledge.ask(&StockForElsewhereFor { diameter: target })?.need("this diameter")?;
    let (mut after, mut slack, mut elsewhere) = (target, Micrometres::ZERO, Vec::new());
    // What is bored here already is not bored so there once more; the last transition is always that machine's.
    let done = |operation: &Operation| candidate.transitions.contains(operation);
    let transitions = rule.transitions.unwrap_or_default();
    let begin = transitions.iter().position(|operation| !done(operation)).unwrap_or(transitions.len());
    let there = &transitions[begin.min(transitions.len().saturating_sub(1))..];
    for (index, operation) in there.iter().enumerate().rev() {
        elsewhere.push((*operation, after));
        let own = candidate.transitions.last().copied().filter(|operation| operation.is_boring());
        let previous = index.checked_sub(1).map_or(own.unwrap_or(Operation::Drill), |before| there[before]);
        let range = allowance(*operation, after, bore.diameter.nominal, Some(previous), shop)?;
        (after, slack) = (after - range.high, range.high - range.low);
    }
    elsewhere.reverse();
    let note = Note::new("stock-for-elsewhere").with("stock", target - after);
    Ok(Finished { after, slack: Some(slack), because: Some(Because::row(rule.row, note)), elsewhere })
}

/// One transition, seen backwards from the diameter that it must leave.
#[derive(Clone, Copy)]
pub(super) struct BackwardStep<'a, 'k> {
    /// The transition.
    pub operation: Operation,
    /// The diameter it leaves.
    pub leaves: Micrometres,
    /// The transition before it; absent for the first one.
    pub previous: Option<Operation>,
    pub bore: &'a Bore,
    pub sizes: &'a Sizes<'a>,
    pub shop: &'a Shop<'k>,
}

impl BackwardStep<'_, '_> {
    /// The steps of the transition, first to last: one, or several where rough boring needs thinner bars first.
    /// `from` of the first step is what the transition before must leave.
    pub fn steps(self) -> Tried<Vec<RouteStep>> {
        let (operation, replaced) = self.stand_in()?;
        // The tables of reamers and core drills end where the drills do; an opening may be wider.
        let guided = operation.is_reaming() || operation == Operation::CoreDrill;
        if guided && self.bore.diameter.nominal > self.shop.convention(HoleDefault::LargestDiameter)? {
            return Err(Refusal::Not(Reason::NotPlanned { operation }));
        }
        let this = Self { operation, ..self };
        let mut steps = match operation {
            Operation::CentreDrill => vec![this.step(Micrometres::ZERO)],
            Operation::Drill => vec![this.drill()?],
            Operation::RoughBore => this.rough_bore()?,
            Operation::Mill => this.mill()?,
            Operation::Tap => vec![this.tap()?],
            Operation::Counterbore if this.after_drill() && this.sizes.start.is_some() => {
                vec![this.step(this.drill_to_open()?)]
            }
            Operation::DrillOut | Operation::Counterbore => vec![this.step(this.start()?)],
            Operation::CoreDrill
            | Operation::RoughReam
            | Operation::FinishReam
            | Operation::SemiFinishBore
            | Operation::FinishBore => vec![this.finishing()?],
            Operation::Countersink | Operation::Chamfer | Operation::Hone => {
                return Err(Refusal::Not(Reason::NotPlanned { operation }));
            }
        };
        if let Some(first) = steps.first_mut() {
            first.because.extend(replaced);
        }
        Ok(steps)
    }

    fn step(self, from: Micrometres) -> RouteStep {
        RouteStep::plain(self.operation, self.bore.place, self.leaves, from)
    }

    /// The diameter the cylinder is opened from.
    fn start(self) -> Tried<Micrometres> {
        let Self { operation, leaves: diameter, .. } = self;
        let start = self.sizes.start.ok_or(Refusal::Not(Reason::NoHoleToOpen { operation }))?;
        if start >= diameter {
            return Err(Refusal::Not(Reason::OpenedAlready { operation, diameter, start }));
        }
        let least = match self.operation {
            Operation::DrillOut => Some(HoleDefault::LeastStockDrillOut),
            Operation::Mill => Some(HoleDefault::LeastStockMill),
            _ => None,
        };
        if let Some(least) = least {
            let least = self.shop.convention(least)?;
            let stock = diameter - start;
            if stock < least {
                return Err(Refusal::Not(Reason::StockTooSmall { operation, diameter, start, stock, least }));
            }
        }
        Ok(start)
    }

    /// Whether the transition before is a drill, whose sizes are those of the catalogs.
    fn after_drill(self) -> bool {
        matches!(self.previous, Some(Operation::Drill | Operation::DrillOut))
    }

    /// The largest drill that leaves some stock for a mill or counterbore. Over a flat shoulder the part of its point that cuts
    /// must fit above the shoulder: lower, it leaves a crater round the hole below; over a flat floor all of its point.
    fn drill_to_open(self) -> Tried<Micrometres> {
        let largest = self.leaves - self.shop.convention(HoleDefault::MillClearance)?;
        let start = self.sizes.start.unwrap_or_default();
        let angle = point_angle(self.shop.knowledge, Operation::Drill);
        let shoulder =
            self.bore.flat && (self.sizes.start.is_some() || (self.sizes.level_floor && self.bore.has_floor()));
        let above = |drill: Micrometres| cone(drill, angle) - cone(start, angle) < self.bore.place.depth;
        let fits = |drill: &Micrometres| *drill <= largest && *drill > start && (!shoulder || above(*drill));
        let drill = self.sizes.drills.iter().rev().copied().find(fits);
        let (operation, diameter) = (self.operation, self.leaves);
        drill.ok_or(Refusal::Not(Reason::NoDrillBefore { operation, diameter, largest }))
    }

    /// The replacement for boring where no boring bar enters, by the rule `too-small-to-bore`.
    fn stand_in(self) -> Tried<(Operation, Option<Because>)> {
        let (operation, after) = (self.operation, self.leaves);
        if !operation.is_boring() {
            return Ok((operation, None));
        }
        let bar_enters = after >= self.sizes.smallest_bore;
        let question = TooSmallToBoreFor { operation, bar_enters };
        let rule = self.shop.knowledge.ask(&question)?.need(operation.name())?;
        let smallest = self.sizes.smallest_bore;
        let instead = match rule.operation_instead {
            BoringInstead::Same => return Ok((operation, None)),
            BoringInstead::CoreDrill => Operation::CoreDrill,
            BoringInstead::Nothing => {
                return Err(Refusal::Not(Reason::TooSmallToBore { operation, diameter: after, smallest }));
            }
        };
        let note = Note::new("bored-by-stand-in")
            .with("operation", Figure::operation(operation.name()))
            .with("diameter", after)
            .with("smallest", smallest)
            .with("instead", Figure::operation(instead.name()));
        Ok((instead, Some(Because::row(rule.row, note))))
    }

    /// The drill that ends a route: of the size of the hole; or the one that leaves the most permitted stock for
    /// finishing elsewhere; otherwise the largest below.
    pub fn last_drill(self, slack: Option<Micrometres>) -> Tried<RouteStep> {
        let drills = self.sizes.drills;
        let found = match slack {
            Some(slack) => {
                let window = self.leaves..=self.leaves + slack;
                let inside = drills.iter().copied().find(|drill| window.contains(drill));
                inside.or_else(|| drills.iter().rev().copied().find(|drill| *drill <= self.leaves))
            }
            None => final_drill(&self.bore.diameter, drills, self.shop)?,
        };
        let diameter = found.ok_or_else(|| Refusal::Not(self.no_drill()))?;
        self.drilled(diameter)
    }

    /// A drill of exactly the size that the next transition requires; under a thread, one within the tolerance.
    fn drill(self) -> Tried<RouteStep> {
        let mut found = self.sizes.drills.iter().copied().find(|drill| *drill == self.leaves);
        if found.is_none() && self.bore.thread.is_some() && self.leaves == self.bore.diameter.target() {
            found = final_drill(&self.bore.diameter, self.sizes.drills, self.shop)?;
        }
        let diameter = found.ok_or_else(|| Refusal::Not(self.no_drill()))?;
        self.drilled(diameter)
    }

    /// The step of a drill; its point must have room above a flat floor.
    fn drilled(self, diameter: Micrometres) -> Tried<RouteStep> {
        let depth = self.bore.place.depth;
        let point = cone(diameter, point_angle(self.shop.knowledge, Operation::Drill));
        if self.sizes.level_floor && self.bore.has_floor() && point >= depth {
            return Err(Refusal::Not(Reason::TooShallowForFlat { depth, diameter }));
        }
        Ok(RouteStep::plain(Operation::Drill, self.bore.place, diameter, Micrometres::ZERO))
    }

    fn no_drill(self) -> Reason {
        let (diameter, limit) = (self.leaves, self.shop.machine.drill_max);
        if diameter > limit {
            return Reason::NoDrillSoLarge { diameter, limit };
        }
        let below = self.sizes.drills.iter().rev().copied().find(|drill| *drill < diameter);
        let above = self.sizes.drills.iter().copied().find(|drill| *drill > diameter);
        Reason::NoDrill { diameter, below, above }
    }

    /// Tapping: the hole under the thread must be there.
    fn tap(self) -> Tried<RouteStep> {
        let thread = self.bore.thread.as_ref();
        let thread = thread.ok_or(Refusal::Not(Reason::NoThreadToTap))?;
        let step = self.step(self.bore.diameter.target());
        // A conical tap goes to its main plane, whatever the depth of the hole.
        let length = match thread.kind {
            ThreadKind::Conical => {
                let row = self.shop.knowledge.find(|row: &ConicalThread<'_>| row.thread == thread.id)?;
                row.map(|row| row.thread_length)
            }
            ThreadKind::Cylindrical => None,
        };
        let depth = length.map_or(self.bore.thread_depth, |length| length.min(self.bore.thread_depth));
        let through = step.place.through && length.is_none();
        let place = super::StepLocation { feature: crate::plan::Feature::Thread, depth, through, ..step.place };
        Ok(RouteStep { place, pitch: Some(thread.pitch), ..step })
    }
}

/// The drill that can make a cylinder alone. Holes are wider than their drills, by the coarse limit of drilling: of the drills
/// whose holes then stay within the limits, the one of the size aimed at, or the first; where there is none, the one of the size
/// aimed at, or the first within the tolerance.
///
/// # Errors
/// The knowledge lacks the accuracy of drilling.
pub fn final_drill(
    diameter: &ToleratedDiameter,
    drills: &[Micrometres],
    shop: &Shop<'_>,
) -> Result<Option<Micrometres>, KnowledgeError> {
    let (target, drilled) = (diameter.target(), accuracy::drilled(shop)?);
    let permitted = |drill: &Micrometres| (diameter.smallest()..=diameter.largest()).contains(drill);
    let stays = |drill: &Micrometres| {
        let wider = || tolerance_width(drilled, *drill, shop.knowledge).unwrap_or_default();
        permitted(drill) && *drill + wider() <= diameter.largest()
    };
    let aimed = drills.iter().copied().find(|drill| *drill == target);
    let sure = aimed.filter(stays).or_else(|| drills.iter().copied().find(stays));
    Ok(sure.or(aimed).or_else(|| drills.iter().copied().find(permitted)))
}
