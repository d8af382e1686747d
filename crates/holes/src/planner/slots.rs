//! The route of a slot: a mill that cuts down to its middle goes along it and round in it; where grade or surface ask for it, the
//! same mill leaves stock on the walls and takes it by one more way round.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::note::{Because, Note, Severity};
use crate::part::{Face, Hole, Part};
use crate::plan::{Achieved, Feature, Operation, RouteSource, Transition};
use crate::reason::Reason;
use crate::route::{Candidate, RouteStep, StepLocation, accuracy};
use crate::shop::Shop;
use crate::tables::practice::ReachOfTransitionFor;
use crate::tables::rules::{MadeBy, MillingFinishRoundFor, WayOfTransitionFor};
use crate::units::{Micrometres, Minutes, Roughness};
use technolog_proof::Fault;

use super::fit::{Fitted, Fitting};
use super::options::{Choice, Options};
use super::sources::refused;

/// The one route of a slot, or why it cannot be made.
///
/// # Errors
/// As for [`super::options::options`].
pub(super) fn options(hole: &Hole, part: &Part, shop: &Shop<'_>) -> Tried<Options> {
    let centre_tolerance = accuracy::centre_tolerance(hole, shop).map_err(Refusal::Not)?;
    let mut options = Options { centre_tolerance, ..Options::default() };
    let fitting = Fitting::new(hole, &[], part, shop)?;
    let (candidate, steps) = route(hole, shop)?;
    let steps = match Refusal::split(fitting.fit(steps, false))? {
        Ok(steps) => steps,
        Err(why) => {
            options.refused.push(refused(&candidate, why));
            return Ok(options);
        }
    };
    let transitions: Vec<Transition> = steps.iter().map(|fitted| fitted.transition(0)).collect();
    let faults = technolog_proof::prove_hole(hole, &transitions, part, shop)?;
    if let Some(first) = faults.iter().find(|fault| fault.severity() != Severity::Doubtful) {
        options.refused.push(refused(&candidate, Reason::NotProven { why: first.note() }));
        return Ok(options);
    }
    let own: f64 = steps.iter().map(|fitted: &Fitted| fitted.pass_time.total().0).sum();
    options.choices.push(Choice {
        candidate,
        steps,
        misses: Vec::new(),
        untold: Vec::new(),
        at_best: faults.iter().map(Fault::note).collect(),
        own_time: Minutes(own),
        borrowed: None,
        instead_of: None,
        ranked_after: None,
    });
    Ok(options)
}

/// The transitions of a slot. How much is left on a wall for a last way round the rule `milling-finish-round` says.
fn route(hole: &Hole, shop: &Shop<'_>) -> Result<(Candidate, Vec<RouteStep>), KnowledgeError> {
    let place = StepLocation {
        feature: Feature::Bore,
        step: None,
        face: Face::Entry,
        start: Micrometres::ZERO,
        depth: hole.depth,
        through: hole.through,
    };
    let (it, roughness) = (hole.diameter.it, hole.roughness);
    let rule = shop.knowledge.ask(&MillingFinishRoundFor { it, roughness })?.need(&format!("IT {it}"))?;
    // The middle of the field: slot mills are made thinner than their size, and whatever presses the mill aside may go either way.
    let width = (hole.diameter.smallest() + hole.diameter.largest()).half();
    let rough = width - rule.stock - rule.stock;
    let step = |width, from| RouteStep {
        required_finish: Some((it, roughness)),
        ..RouteStep::plain(Operation::Mill, place, width, from)
    };
    let mut steps = vec![step(rough, Micrometres::ZERO)];
    if rule.stock > Micrometres::ZERO {
        steps.push(RouteStep { entered: Some(rough), ..step(width, rough) });
    }
    let last = steps.len() - 1;
    for (at, step) in steps.iter_mut().enumerate() {
        write_reached(step, at == last, shop)?;
    }
    let note = match rule.stock {
        Micrometres::ZERO => Note::new("slot-milled-at-once"),
        stock => Note::new("slot-finished").with("stock", stock),
    };
    let candidate = Candidate {
        source: RouteSource::Search,
        table: rule.row.table.id.clone(),
        scheme: vec![Operation::Mill.name(); steps.len()].join(" + "),
        transitions: vec![Operation::Mill; steps.len()],
        finish_elsewhere: false,
        last_resort: false,
        promise: None,
        because: vec![Because::row(rule.row, note)],
    };
    Ok((candidate, steps))
}

/// Writes what shops reach with a way of a mill in a slot, which no table of the textbook has.
fn write_reached(step: &mut RouteStep, last: bool, shop: &Shop<'_>) -> Result<(), KnowledgeError> {
    let after = if step.from == Micrometres::ZERO { MadeBy::Solid } else { MadeBy::Mill };
    let way = WayOfTransitionFor { operation: Operation::Mill, centred: false, after, last };
    let way = shop.knowledge.ask(&way)?.need(Operation::Mill.name())?.way;
    let reach = ReachOfTransitionFor { way, diameter: step.diameter };
    let Some(row) = shop.knowledge.ask(&reach)?.winner()? else { return Ok(()) };
    let roughness = Roughness::from_ra(row.ra_ordinary);
    step.achieved = Some(Achieved { it: row.it_ordinary, roughness: Some(roughness), position_mm: None });
    if let Some(it) = row.it_ordinary {
        step.because.push(Because::row(row.row, Note::new("reaches").with("it", it).with("roughness", roughness)));
    }
    Ok(())
}
