//! Intermediate diameters: backwards from the finished cylinder, by the allowances of section 1.2.1 and,
//! inside them, by the handbook's step diameters.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::Input;
use crate::knowledge::units::Unit;
use crate::note::{Because, Note};
use crate::part::{ThreadKind, ToleratedDiameter};
use crate::plan::Operation;
use crate::shop::Shop;
use crate::units::Micrometres;

use super::bores::Bore;
use super::{Candidate, Step, handbook};

mod allowance;
mod boring;

use allowance::allowance;
pub use allowance::{Range, range};

/// What a route is turned into steps with.
#[derive(Clone, Copy, Debug)]
pub struct Sizes<'a> {
    /// Every drill that reaches, ascending.
    pub drills: &'a [Micrometres],
    /// Drills that are in the magazine anyway, for other holes.
    pub in_magazine: &'a [Micrometres],
    /// The smallest hole a boring bar of the catalogs enters.
    pub smallest_bore: Micrometres,
    /// The diameter the cylinder is opened from; absent in solid metal.
    pub start: Option<Micrometres>,
    /// Whether to drill in one pass although a first drill is at hand.
    pub single_drill: bool,
    /// Whether to bore although the rule `mill-or-bore` would mill.
    pub bore_large: bool,
}

/// The steps of a candidate for a cylinder, first to last; centring takes its spot later, when the drill
/// is known.
///
/// # Errors
/// The knowledge cannot answer. That no diameters work is a refusal that says why.
pub fn steps(candidate: &Candidate, bore: &Bore, sizes: &Sizes<'_>, shop: &Shop<'_>) -> Tried<Vec<Step>> {
    let (transitions, replaced) = milled(&candidate.transitions, bore, sizes, shop)?;
    let mut steps: Vec<Step> = Vec::new();
    let (mut after, left) = finished(candidate, bore, shop)?;
    for index in (0..transitions.len()).rev() {
        let previous = index.checked_sub(1).map(|before| transitions[before]);
        let question = Backwards { operation: transitions[index], after, previous, bore, sizes, shop };
        let mut made = if steps.is_empty() && transitions[index] == Operation::Drill {
            vec![question.last_drill(candidate.finish_elsewhere)?]
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
    two_passes(&mut steps, bore, sizes, shop)?;
    Ok(steps)
}

/// The transitions with the first opening milled where the rule `mill-or-bore` says so.
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
    let rule = shop.knowledge.table("mill-or-bore")?;
    let diameter = bore.diameter.nominal;
    let answer = rule.decide(&[
        ("operation", Input::Text(Operation::RoughBore.name())),
        ("contouring", Input::Bool(shop.machine.contouring)),
        ("diameter", Input::Length(diameter)),
    ])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this hole"))?;
    if row.text("instead")? != Operation::Mill.name() {
        return Ok((transitions, None));
    }
    transitions[first] = Operation::Mill;
    let note = Note::new("milled-instead").with("diameter", diameter);
    Ok((transitions, Some(Because::answer(&answer, note))))
}

/// The diameter the route ends at: the cylinder's, or smaller by the stock for a finish on another machine
/// (rule `stock-for-elsewhere`); of a thread its own.
fn finished(
    candidate: &Candidate,
    bore: &Bore,
    shop: &Shop<'_>,
) -> Result<(Micrometres, Option<Because>), KnowledgeError> {
    if let (Some(thread), Some(Operation::Tap)) = (&bore.thread, candidate.transitions.last()) {
        return Ok((thread.size, None));
    }
    let target = bore.diameter.target();
    if !candidate.finish_elsewhere {
        return Ok((target, None));
    }
    let rule = shop.knowledge.table("stock-for-elsewhere")?;
    let answer = rule.decide(&[("diameter", Input::Length(target))])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this diameter"))?;
    let allowances = shop.knowledge.table("allowances")?;
    let mut stock = Micrometres::ZERO;
    for name in row.texts("allowances")? {
        let allowance = allowances.find("name", name).ok_or_else(|| KnowledgeError::no_row(allowances, name))?;
        stock = stock + allowance.length("maximum")?;
    }
    Ok((target - stock, Some(Because::row(row, Note::new("stock-for-elsewhere").with("stock", stock)))))
}

/// One transition, seen from what it must leave.
#[derive(Clone, Copy)]
pub(super) struct Backwards<'a, 'k> {
    /// The transition.
    pub operation: Operation,
    /// The diameter it leaves.
    pub after: Micrometres,
    /// The transition before it; absent at the beginning.
    pub previous: Option<Operation>,
    pub bore: &'a Bore,
    pub sizes: &'a Sizes<'a>,
    pub shop: &'a Shop<'k>,
}

impl Backwards<'_, '_> {
    /// The steps that make the transition, first to last: one, or several where rough boring needs slimmer
    /// bars first. The first one's `from` is what the transition before must leave.
    pub fn steps(self) -> Tried<Vec<Step>> {
        let (operation, replaced) = self.stand_in()?;
        let this = Self { operation, ..self };
        let mut steps = match operation {
            Operation::CentreDrill => vec![this.step(Micrometres::ZERO)],
            Operation::Drill => vec![this.drill()?],
            Operation::RoughBore => this.rough_bore()?,
            Operation::Mill => vec![this.mill()?],
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
            Operation::Countersink | Operation::Chamfer => {
                return Err(Refusal::Not(Note::new("not-planned").with("operation", operation.name())));
            }
        };
        if let Some(first) = steps.first_mut() {
            first.because.extend(replaced);
        }
        Ok(steps)
    }

    fn step(self, from: Micrometres) -> Step {
        Step::plain(self.operation, self.bore.place, self.after, from)
    }

    /// The diameter the cylinder is opened from.
    fn start(self) -> Tried<Micrometres> {
        let refuse = || Refusal::Not(Note::new("no-hole-to-open").with("operation", self.operation.name()));
        let start = self.sizes.start.ok_or_else(refuse)?;
        if start >= self.after {
            let note = Note::new("opened-already").with("diameter", self.after).with("start", start);
            return Err(Refusal::Not(note.with("operation", self.operation.name())));
        }
        let least = match self.operation {
            Operation::DrillOut => Some("least-stock-drill-out-mm"),
            Operation::Mill => Some("least-stock-mill-mm"),
            _ => None,
        };
        if let Some(least) = least {
            let least = self.shop.convention(least)?;
            let stock = self.after - start;
            if stock < least {
                let note = Note::new("stock-too-small").with("operation", self.operation.name());
                let note = note.with("diameter", self.after).with("start", start);
                return Err(Refusal::Not(note.with("stock", stock).with("least", least)));
            }
        }
        Ok(start)
    }

    /// Whether the transition before is a drill, whose sizes are those of the catalogs.
    fn after_drill(self) -> bool {
        matches!(self.previous, Some(Operation::Drill | Operation::DrillOut))
    }

    /// The largest drill that leaves a mill or counterbore something to cut.
    fn drill_to_open(self) -> Tried<Micrometres> {
        let largest = self.after - self.shop.convention("mill-clearance-mm")?;
        let start = self.sizes.start.unwrap_or_default();
        let drill = self.sizes.drills.iter().rev().copied().find(|drill| *drill <= largest && *drill > start);
        drill.ok_or_else(|| {
            let note = Note::new("no-drill-before").with("operation", self.operation.name());
            Refusal::Not(note.with("diameter", self.after).with("largest", largest))
        })
    }

    /// What stands in where no boring bar enters, by the rule `too-small-to-bore`.
    fn stand_in(self) -> Tried<(Operation, Option<Because>)> {
        let (operation, after) = (self.operation, self.after);
        if !operation.is_boring() {
            return Ok((operation, None));
        }
        let enters = after >= self.sizes.smallest_bore;
        let rule = self.shop.knowledge.table("too-small-to-bore")?;
        let answer =
            rule.decide(&[("operation", Input::Text(operation.name())), ("bar_enters", Input::Bool(enters))])?;
        let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, operation.name()))?;
        let note = |code: &str| {
            Note::new(code)
                .with("operation", operation.name())
                .with("diameter", after)
                .with("smallest", self.sizes.smallest_bore)
        };
        let instead = row.text("operation_instead")?;
        match (instead, Operation::from_name(instead)) {
            ("same", _) => Ok((operation, None)),
            (_, Some(other)) => {
                Ok((other, Some(Because::row(row, note("bored-by-stand-in").with("instead", other.name())))))
            }
            _ => Err(Refusal::Not(note("too-small-to-bore"))),
        }
    }

    /// The drill that ends a route: of the hole's size, or the largest that leaves the stock for a finish
    /// elsewhere.
    pub fn last_drill(self, finish_elsewhere: bool) -> Tried<Step> {
        let drills = self.sizes.drills;
        let found = if finish_elsewhere {
            drills.iter().rev().copied().find(|drill| *drill <= self.after)
        } else {
            final_drill(&self.bore.diameter, drills)
        };
        let diameter = found.ok_or_else(|| Refusal::Not(self.no_drill()))?;
        Ok(Step::plain(Operation::Drill, self.bore.place, diameter, Micrometres::ZERO))
    }

    /// A drill of exactly the size the next transition asks for; under a thread one within the tolerance.
    fn drill(self) -> Tried<Step> {
        let mut found = self.sizes.drills.iter().copied().find(|drill| *drill == self.after);
        if found.is_none() && self.bore.thread.is_some() && self.after == self.bore.diameter.target() {
            found = final_drill(&self.bore.diameter, self.sizes.drills);
        }
        let diameter = found.ok_or_else(|| Refusal::Not(self.no_drill()))?;
        Ok(Step::plain(Operation::Drill, self.bore.place, diameter, Micrometres::ZERO))
    }

    fn no_drill(self) -> Note {
        let below = self.sizes.drills.iter().rev().find(|drill| **drill < self.after);
        let above = self.sizes.drills.iter().find(|drill| **drill > self.after);
        let show = |size: Option<&Micrometres>| size.map_or_else(|| "-".to_owned(), |size| format!("Ø{size}"));
        let most = self.shop.machine.drill_max;
        if self.after > most {
            return Note::new("no-drill-so-large").with("diameter", self.after).with("limit", most);
        }
        Note::new("no-drill").with("diameter", self.after).with("below", show(below)).with("above", show(above))
    }

    /// Tapping: the hole under the thread must be there.
    fn tap(self) -> Tried<Step> {
        let thread = self.bore.thread.as_ref();
        let thread = thread.ok_or_else(|| Refusal::Not(Note::new("no-thread-to-tap")))?;
        let step = self.step(self.bore.diameter.target());
        // A conical tap goes to its main plane, however deep the hole.
        let length = match thread.kind {
            ThreadKind::Conical => {
                let table = self.shop.knowledge.table("conical-threads")?;
                table.find("thread", &thread.id).and_then(|row| row.length_if_any("thread_length"))
            }
            ThreadKind::Cylindrical => None,
        };
        let depth = length.map_or(self.bore.thread_depth, |length| length.min(self.bore.thread_depth));
        let through = step.place.through && length.is_none();
        let place = super::Place { feature: crate::plan::Feature::Thread, depth, through, ..step.place };
        Ok(Step { place, pitch: Some(thread.pitch), ..step })
    }

    /// A transition that removes an allowance: the diameter before it is the handbook's where the range of
    /// section 1.2.1 permits it, else the aim of the range; the drill nearest to that where a drill makes it.
    fn finishing(self) -> Tried<Step> {
        let Self { operation, after, previous, bore, sizes, shop } = self;
        let allowance = allowance(operation, after, bore.diameter.nominal, previous, shop)?;
        let (smallest, largest) = (after - allowance.high, after - allowance.low);
        let handbook_row = handbook::row(bore, shop)?;
        let advised = handbook_row.and_then(|row| handbook::before(row, operation, previous));
        let aim = advised.unwrap_or(after - allowance.aim).max(smallest).min(largest);
        let before = if previous.is_none() {
            let start = self.start()?;
            if start < smallest || start > largest {
                return Err(Refusal::Not(
                    Note::new("stock-outside-allowance")
                        .with("operation", operation.name())
                        .with("stock", after - start)
                        .with("low", allowance.low)
                        .with("high", allowance.high)
                        .with("diameter", after),
                ));
            }
            start
        } else if self.after_drill() {
            let inside = |drill: &Micrometres| *drill >= smallest && *drill <= largest && *drill < after;
            let drills = sizes.drills.iter().copied().filter(inside);
            let nearest = drills.min_by_key(|drill| ((*drill - aim).abs(), *drill));
            nearest.ok_or_else(|| {
                Refusal::Not(
                    Note::new("no-drill-in-allowance")
                        .with("operation", operation.name())
                        .with("low", smallest)
                        .with("high", largest)
                        .with("diameter", after),
                )
            })?
        } else if previous == Some(Operation::Counterbore) {
            let inside = |size: &Micrometres| *size >= smallest && *size <= largest;
            let sizes = super::openings::counterbores(after, shop)?;
            let nearest = sizes.into_iter().filter(inside).min_by_key(|size| ((*size - aim).abs(), *size));
            nearest.ok_or_else(|| {
                let note = Note::new("no-counterbore-in-allowance").with("operation", operation.name());
                Refusal::Not(note.with("low", smallest).with("high", largest).with("diameter", after))
            })?
        } else if advised == Some(aim) {
            aim
        } else {
            // To the setting step, but never out of the range.
            let step = shop.convention("setting-step-mm")?.micrometres().max(1);
            let set = Micrometres::new((aim.micrometres() + step / 2).div_euclid(step) * step);
            set.max(smallest).min(largest)
        };
        let note = Note::new("allowance")
            .with("operation", operation.name())
            .with("low", allowance.low)
            .with("high", allowance.high)
            .with("taken", after - before);
        let mut because = vec![Because::row(allowance.row, note)];
        because.extend(allowance.stock);
        if let (Some(row), Some(advised)) = (handbook_row, advised) {
            let code = if advised == before { "handbook-step" } else { "handbook-step-outside" };
            let note = Note::new(code).with("advised", advised).with("taken", before);
            because.push(Because::row(row, note.with("low", smallest).with("high", largest)));
        }
        // Reamers and core drills of the catalog are ground to the size before the last one.
        let fixed = operation.is_reaming() || operation == Operation::CoreDrill;
        let nominal = if fixed { bore.diameter.nominal } else { after };
        if fixed && after != nominal {
            let note = Note::new("ground-to-size").with("nominal", nominal).with("size", after);
            because.push(Because::row(allowance.row, note));
        }
        Ok(Step { nominal, because, ..self.step(before) })
    }
}

/// The drill that can make a cylinder itself: of its nominal diameter, or within its tolerance.
pub fn final_drill(diameter: &ToleratedDiameter, drills: &[Micrometres]) -> Option<Micrometres> {
    let target = diameter.target();
    let permitted = |drill: &Micrometres| (diameter.smallest()..=diameter.largest()).contains(drill);
    drills.iter().copied().find(|drill| *drill == target).or_else(|| drills.iter().copied().find(permitted))
}

/// Splits the drilling in two where the rule `two-pass-drilling` or the handbook says so.
fn two_passes(steps: &mut Vec<Step>, bore: &Bore, sizes: &Sizes<'_>, shop: &Shop<'_>) -> Result<(), KnowledgeError> {
    let Some(index) = steps.iter().position(|step| step.operation == Operation::Drill) else { return Ok(()) };
    let diameter = steps[index].diameter;
    if let Some(row) = handbook::row(bore, shop)?
        && let (Some(first), Some(last)) = (handbook::first_drill(row), handbook::last_drill(row))
        && last == diameter
        && !sizes.single_drill
        && sizes.drills.contains(&first)
    {
        let note = Note::new("handbook-first-drill").with("first", first).with("diameter", diameter);
        split(steps, index, first, Because::row(row, note.clone()), Because::row(row, note));
        return Ok(());
    }
    let shares = shop.knowledge.table("first-drill")?;
    let share = shares.row(0).ok_or_else(|| KnowledgeError::no_row(shares, "two-pass drilling"))?;
    let (share_min, share_max) = (share.number_in("share_min", Unit::None)?, share.number_in("share_max", Unit::None)?);
    let [low, high] = [share_min, share_max].map(|share| Micrometres::from_mm_rounded(diameter.to_mm() * share));
    let inside = |drills: &[Micrometres]| drills.iter().copied().filter(|drill| (low..=high).contains(drill)).max();
    let at_hand = inside(sizes.in_magazine);
    let rule = shop.knowledge.table("two-pass-drilling")?;
    let in_magazine = at_hand.is_some() && !sizes.single_drill;
    let answer =
        rule.decide(&[("diameter", Input::Length(diameter)), ("first_drill_in_magazine", Input::Bool(in_magazine))])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this drill"))?;
    let note = |code: &str| Note::new(code).with("diameter", diameter).with("low", low).with("high", high);
    if row.int("passes")? < 2 {
        steps[index].because.push(Because::answer(&answer, note("one-pass")));
        return Ok(());
    }
    // Above 30 mm with nothing at hand: the smallest drill of the range cuts with the least thrust.
    let first = at_hand.or_else(|| sizes.drills.iter().copied().find(|drill| (low..=high).contains(drill)));
    let Some(first) = first else { return Ok(()) };
    let why = Because::answer(&answer, note("two-passes").with("first", first));
    let note = note("first-drill").with("first", first).with("share-min", share_min).with("share-max", share_max);
    split(steps, index, first, Because::row(share, note), why);
    // Below the limit above which two drills are the rule, the first is there for another hole only.
    steps[index].borrowed = at_hand.is_some() && diameter <= share.length("above_diameter")?;
    Ok(())
}

/// Puts a first drill before the drill at `index`, which then opens what the first left.
fn split(steps: &mut Vec<Step>, index: usize, first: Micrometres, of_first: Because, of_second: Because) {
    let second = &mut steps[index];
    second.operation = Operation::DrillOut;
    second.from = first;
    second.because.push(of_second);
    let mut drill = Step::plain(Operation::Drill, second.place, first, Micrometres::ZERO);
    drill.because.push(of_first);
    steps.insert(index, drill);
}
