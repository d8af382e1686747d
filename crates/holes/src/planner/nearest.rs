//! For a hole that nothing makes: the nearest depth at which the same hole can be made or, if no depth helps, the grade and
//! roughness; and the machine that makes it as drawn, or taps its thread.

use crate::error::{KnowledgeError, Refusal};
use crate::machine::Machine;
use crate::note::{Figure, Note, Severity};
use crate::part::{Hole, Part, ToleratedDiameter, tolerance_width};
use crate::plan::{Operation, Preference};
use crate::reason::Reason;
use crate::route::RouteStep;
use crate::shop::Shop;
use crate::tooling::{self, DrillSize};
use crate::units::{ItGrade, Micrometres, Microns, Roughness};

use super::fit::Fitting;
use super::options::{self, Choice, Options};

/// What a millimetre is.
const MM: i64 = 1000;
/// The roughness that a grade is asked for with, Ra, from the finest grade on: a step or two coarser than each reaches, so that
/// the grade decides.
const WITH: [(u8, f64); 4] = [(7, 1.25), (8, 2.5), (11, 6.3), (14, 12.5)];
/// The same of slots, which have one route: every grade from the finest on that a mill reaches ordinarily.
const OF_SLOTS: [(u8, f64); 5] = [(11, 3.2), (11, 6.3), (12, 12.5), (13, 12.5), (14, 12.5)];

/// The nearest possible hole beside one that is not, `deep` if its depth is a reason; none for stepped holes, of which more than one depth may be meant, and where
/// nothing near is possible.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn nearest(
    (hole, deep): (&Hole, bool),
    part: &Part,
    preference: Preference,
    drills: (&[Micrometres], &[DrillSize]),
    shop: &Shop<'_>,
) -> Result<Option<Note>, KnowledgeError> {
    if !hole.steps.is_empty() {
        return Ok(None);
    }
    let shallower = if deep { depth(hole, part, preference, drills, shop)? } else { None };
    let coarser = match shallower {
        Some(found) => return Ok(Some(found)),
        None => grade(hole, part, preference, drills, shop)?,
    };
    // What does not name depth may still be one of its reasons, such as a bar that enters no hole so long.
    if coarser.is_none() && !deep { depth(hole, part, preference, drills, shop) } else { Ok(coarser) }
}

/// The first other machine of the knowledge base on which the hole can be made as drawn; none where no machine helps.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn machine(
    hole: &Hole,
    part: &Part,
    preference: Preference,
    shop: &Shop<'_>,
) -> Result<Option<Note>, KnowledgeError> {
    for id in Machine::ids(shop.knowledge).filter(|id| *id != shop.machine.id()) {
        let part = Part { machine: id.to_owned(), ..part.clone() };
        let shop = Shop::new(&part, shop.method, shop.knowledge)?;
        let drills = tooling::drill_sizes(&shop)?;
        let found = Refusal::split(options::options(hole, &part, preference, (&[], &drills), &shop))?;
        // A machine that leaves the thread to another one does not make the hole as drawn.
        let whole = |choice: &Choice| {
            choice.meets_requirements() && !choice.steps.iter().any(|fitted| taps_elsewhere(&fitted.step))
        };
        let made = found.is_ok_and(|found| found.choices.iter().any(whole) && found.impossible.is_empty());
        if made && is_planned(hole, &part, preference, &shop)? {
            return Ok(Some(Note::new("nearest-machine").with("machine", Figure::word_of("machine", id.to_owned()))));
        }
    }
    Ok(None)
}

/// Whether a step taps on another machine.
pub(super) fn taps_elsewhere(step: &RouteStep) -> bool {
    step.elsewhere && step.operation == Operation::Tap
}

/// Where a thread is cut that this machine cannot tap.
pub(super) enum TappedBy {
    /// On this machine of the knowledge base.
    Machine(String),
    /// On none of those that tap: the first of them, and why.
    None(Option<(String, Reason)>),
}

/// The other machine of the knowledge base that taps a thread: its chuck holds the tap, both are within its limits, and so is the
/// torque. One with the same control goes first.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn tapped_by(
    hole: &Hole,
    tap: &RouteStep,
    part: &Part,
    shop: &Shop<'_>,
) -> Result<TappedBy, KnowledgeError> {
    let mut machines = Vec::new();
    for id in Machine::ids(shop.knowledge).filter(|id| *id != shop.machine.id()) {
        machines.push(Machine::find(shop.knowledge, id)?);
    }
    machines.retain(|machine| machine.can_tap);
    machines.sort_by_key(|machine| machine.control != shop.machine.control);
    let there = RouteStep { elsewhere: false, ..tap.clone() };
    let mut first = None;
    for machine in machines {
        let id = machine.id().to_owned();
        let shop = Shop { machine, ..shop.clone() };
        let fitting = Fitting::new(hole, &[], part, &shop)?;
        match Refusal::split(fitting.tool_and_conditions(&there, None, true))? {
            Ok(_) => return Ok(TappedBy::Machine(id)),
            Err(why) => {
                first.get_or_insert((id, why));
            }
        }
    }
    Ok(TappedBy::None(first))
}

/// The finest grade, with a roughness that goes with it, at which the same hole can be made; none for threads and counterbores.
fn grade(
    hole: &Hole,
    part: &Part,
    preference: Preference,
    drills: (&[Micrometres], &[DrillSize]),
    shop: &Shop<'_>,
) -> Result<Option<Note>, KnowledgeError> {
    if hole.thread.is_some() || hole.counterbore.is_some() {
        return Ok(None);
    }
    let with = if hole.slot.is_some() { &OF_SLOTS[..] } else { &WITH };
    for &(finest, ra) in with {
        let Some(it) = ItGrade::new(hole.diameter.it.number().max(finest)) else { continue };
        let roughness = hole.roughness.max(Roughness::from_ra(Microns(ra)));
        if it == hole.diameter.it && roughness == hole.roughness {
            continue;
        }
        let Ok(width) = tolerance_width(it, hole.diameter.nominal, shop.knowledge) else { continue };
        let diameter = ToleratedDiameter { upper: hole.diameter.lower + width, it, ..hole.diameter.clone() };
        let coarser = Hole { diameter, roughness, ..hole.clone() };
        if is_made(&coarser, part, preference, drills, shop)? {
            return Ok(Some(Note::new("nearest-grade").with("it", it).with("roughness", roughness)));
        }
    }
    Ok(None)
}

/// The deepest hole of the same size, in whole millimetres, that can be made; of a through hole the thickest blank. None where no
/// depth helps.
fn depth(
    hole: &Hole,
    part: &Part,
    preference: Preference,
    drills: (&[Micrometres], &[DrillSize]),
    shop: &Shop<'_>,
) -> Result<Option<Note>, KnowledgeError> {
    let works = |depth: i64| -> Result<bool, KnowledgeError> {
        let depth = Micrometres::new(depth * MM);
        let mut hole = hole.clone();
        let mut part = part.clone();
        hole.depth = depth;
        if hole.through {
            part.blank.thickness = depth;
        }
        let opening = hole.counterbore.map(|counterbore| counterbore.depth).unwrap_or_default();
        if depth <= opening {
            return Ok(false);
        }
        is_made(&hole, &part, preference, drills, shop)
    };
    let mut fails = (hole.depth.micrometres() + MM - 1) / MM;
    let mut makes = None;
    for quarters in [3, 2, 1] {
        let depth = share_of(hole.depth, quarters);
        if depth < 1 || depth >= fails {
            continue;
        }
        if works(depth)? {
            makes = Some(depth);
            break;
        }
        fails = depth;
    }
    let Some(mut makes) = makes else { return Ok(None) };
    while fails - makes > 1 {
        let between = makes + (fails - makes) / 2;
        if works(between)? {
            makes = between;
        } else {
            fails = between;
        }
    }
    let code = if hole.through { "nearest-thickness" } else { "nearest-depth" };
    let wanted = Note::new(code).with("depth", Micrometres::new(makes * MM));
    Ok(Some(wanted.with("asked", hole.depth)))
}

/// Whether a hole is made as asked, alone in its part: some route makes it, and nothing is wrong with the plan of it, as a machine
/// that has no room for its tools. What holds the part is not asked: clamps of the file are for its own holes.
fn is_made(
    hole: &Hole,
    part: &Part,
    preference: Preference,
    drills: (&[Micrometres], &[DrillSize]),
    shop: &Shop<'_>,
) -> Result<bool, KnowledgeError> {
    let found = Refusal::split(options::options(hole, part, preference, drills, shop))?;
    let made = |found: &Options| found.choices.iter().any(Choice::meets_requirements) && found.impossible.is_empty();
    if !found.is_ok_and(|found| made(&found)) {
        return Ok(false);
    }
    is_planned(hole, part, preference, shop)
}

/// Whether nothing is wrong with the plan of a hole alone in its part.
fn is_planned(hole: &Hole, part: &Part, preference: Preference, shop: &Shop<'_>) -> Result<bool, KnowledgeError> {
    let mut alone = Part { holes: vec![hole.clone()], ..part.clone() };
    alone.fixture.clamps.clear();
    let plan = super::plan_by(&alone, shop.method, preference, shop.knowledge)?;
    Ok(plan.findings.iter().all(|finding| finding.severity != Severity::Error))
}

/// That many quarters of a depth, in whole millimetres.
fn share_of(depth: Micrometres, quarters: i64) -> i64 {
    depth.micrometres() * quarters / 4 / MM
}
