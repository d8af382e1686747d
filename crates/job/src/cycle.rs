//! The cycle of one transition, by the rule `machining-cycle`.

use crate::error::KnowledgeError;
use crate::motion::Sense;
use crate::note::{Because, Note};
use crate::part::Slot;
use crate::plan::{Conditions, Operation, Rounds, Transition};
use crate::shop::{Shop, convention, programmed_feed};
use crate::tables::controls::Convention;
use crate::tables::rules::{HoleCycle, MachiningCycle, MachiningCycleFor, MillingDirection};
use crate::units::{Micrometres, MillimetresPerMinute, RevsPerMinute, Seconds};
use technolog_note::note;

use super::{Cycle, CycleKind, SlotArc, SlotCycle};

/// One stroke of a tool into a hole, with lengths below the entry face.
#[derive(Clone, Copy, Debug)]
pub struct Feeding<'a> {
    /// What is done.
    pub operation: Operation,
    /// The diameter it leaves.
    pub diameter: Micrometres,
    /// The diameter before it; zero in solid metal.
    pub from: Micrometres,
    /// Where its cutting begins.
    pub start: Micrometres,
    /// Where its full diameter ends.
    pub depth: Micrometres,
    /// Where its tip ends.
    pub end: Micrometres,
    /// The distance above its cut where the feed begins.
    pub approach: Micrometres,
    /// The pitch of its thread.
    pub pitch: Option<Micrometres>,
    /// How the slot runs on, as the part lies in the set-up; absent for what is round.
    pub slot: Option<Slot>,
    /// The cutting conditions.
    pub conditions: &'a Conditions,
}

impl<'a> Feeding<'a> {
    /// The stroke of a transition of a plan into a round hole.
    pub fn of(transition: &'a Transition, pitch: Option<Micrometres>) -> Self {
        Self {
            operation: transition.operation,
            diameter: transition.diameter_mm,
            from: transition.from_diameter_mm,
            start: transition.start_mm,
            depth: transition.depth_mm,
            end: transition.end(),
            approach: transition.approach_mm,
            pitch,
            slot: None,
            conditions: &transition.conditions,
        }
    }
}

/// How a tool is fed at each of its points; `top` is Z of the entry face in the drawing.
///
/// # Errors
/// The knowledge base has no answer.
pub fn cycle(transition: &Feeding<'_>, top: Micrometres, shop: &Shop<'_>) -> Result<Cycle, KnowledgeError> {
    let fills_flutes = match transition.operation {
        Operation::Drill => transition.from == Micrometres::ZERO,
        operation => matches!(operation, Operation::DrillOut | Operation::CoreDrill),
    };
    let depth = if fills_flutes { transition.depth - transition.start } else { Micrometres::ZERO };
    let ratio = depth.to_mm() / transition.diameter.to_mm();
    // A countersink that goes round an edge moves as a mill does.
    let goes_round = transition.conditions.rounds.is_some();
    let operation = if goes_round { Operation::Mill } else { transition.operation };
    let question = MachiningCycleFor { operation, depth_ratio: ratio, material_group: shop.material.group };
    let answer = shop.knowledge.ask(&question)?;
    let rule = answer.need(operation.name())?;
    let note = Note::new("machining-cycle").with("cycle", rule.cycle.name());
    let note = note.with("ratio", crate::units::round_to(ratio, 2));

    // Figures in programs are multiples of the machine's step.
    let grid = |length: Micrometres| length.on_grid(shop.machine.resolution);
    let begin = grid(top - transition.start + transition.approach);
    let end = grid(top - transition.end);
    let conditions = transition.conditions;
    let dwell = rule.dwell.filter(|turns| *turns > 0.0);
    let dwell_step = convention(Convention::DwellStep, shop.knowledge)?.0;
    let dwell = dwell.map(|turns| {
        // Rounded up to the next step in which dwells are counted; first rounded, because tenths are not exact in
        // binary.
        let steps = libm::ceil(turns * 60.0 / conditions.spindle_rpm.0 / dwell_step);
        Seconds(crate::units::round_to(steps * dwell_step, 3))
    });
    let (withdrawal, convention) = withdrawal(shop)?;
    Ok(Cycle {
        operation: transition.operation,
        kind: kind(&rule, transition, top, shop)?,
        // Programs count turns in whole numbers; a step between them is rounded down.
        speed_rpm: RevsPerMinute(libm::floor(conditions.spindle_rpm.0)),
        feed_mm_per_min: feed(transition, shop)?,
        begin,
        end,
        out: grid(top + withdrawal).max(begin),
        dwell_s: dwell,
        because: vec![Because::answer(&answer.answer, note), convention],
    })
}

fn kind(
    rule: &MachiningCycle<'_>,
    transition: &Feeding<'_>,
    top: Micrometres,
    shop: &Shop<'_>,
) -> Result<CycleKind, KnowledgeError> {
    let resolution = shop.machine.resolution;
    let lacks = |what: Note| KnowledgeError::missing(&rule.row.table.id, what);
    let step = || -> Result<Micrometres, KnowledgeError> {
        let share = rule.step.ok_or_else(|| lacks(note!("nc-step-cycle-steps")))?;
        Ok(Micrometres::from_mm_rounded(transition.diameter.to_mm() * share).on_grid(resolution).max(resolution))
    };
    let clearance = || rule.clearance.ok_or_else(|| lacks(note!("nc-clearance-cycle-steps")));
    Ok(match rule.cycle {
        HoleCycle::Drill => CycleKind::Drill,
        HoleCycle::FeedOut => CycleKind::FeedOut,
        HoleCycle::BoreStop => CycleKind::BoreStop,
        HoleCycle::Peck => CycleKind::Peck { step: step()?, clearance: clearance()? },
        HoleCycle::ChipBreak => CycleKind::ChipBreak { step: step()?, retreat: clearance()? },
        HoleCycle::Tap => {
            CycleKind::Tap { pitch: transition.pitch.ok_or_else(|| lacks(note!("nc-pitch-thread-tapped")))? }
        }
        HoleCycle::Circles => {
            let rounds = transition.conditions.rounds.ok_or_else(|| lacks(note!("nc-circles-mill")))?;
            // With a clockwise spindle, a counterclockwise path inside a hole is climb milling.
            let sense = match rule.cut.ok_or_else(|| lacks(note!("nc-how-mill-cuts")))? {
                MillingDirection::Climb => Sense::Counterclockwise,
                MillingDirection::Conventional => Sense::Clockwise,
            };
            match transition.slot {
                Some(run) => slot(transition, rounds, (top, run, sense), shop)?,
                None => circles(transition, rounds, top, sense, shop)?,
            }
        }
    })
}

/// The levels and circles of a mill: the stock in equal passes and a thin last one, the depth in equal levels, the overrun added to the
/// last level.
fn circles(
    transition: &Feeding<'_>,
    rounds: Rounds,
    top: Micrometres,
    sense: Sense,
    shop: &Shop<'_>,
) -> Result<CycleKind, KnowledgeError> {
    let resolution = shop.machine.resolution;
    let radius = |pass: u32| (rounds.after(pass, transition.diameter) - rounds.mill_diameter_mm).half();
    let round = feed(transition, shop)?;
    let plunge_mm_per_min = match rounds.plunge_feed_mm_per_min {
        Some(planned) => Some(programmed_feed(planned, shop.knowledge)?).filter(|plunge| *plunge != round),
        None => None,
    };
    Ok(CycleKind::Circles {
        plunge_mm_per_min,
        levels: levels(transition, rounds, top, resolution),
        radii: (1..=rounds.passes.max(1)).map(|pass| radius(pass).on_grid(resolution)).collect(),
        sense,
    })
}

/// Z of the levels of a mill: equal parts of the depth, the overrun added to the last.
fn levels(transition: &Feeding<'_>, rounds: Rounds, top: Micrometres, resolution: Micrometres) -> Vec<Micrometres> {
    let levels = i64::from(rounds.levels.max(1));
    let depth = transition.depth - transition.start;
    let level = |number: i64| match number == levels {
        true => top - transition.end,
        false => top - transition.start - depth.ratio(number, levels),
    };
    (1..=levels).map(|number| level(number).on_grid(resolution)).collect()
}

/// The levels and the ways round of a mill in a slot.
fn slot(
    transition: &Feeding<'_>,
    rounds: Rounds,
    (top, run, sense): (Micrometres, Slot, Sense),
    shop: &Shop<'_>,
) -> Result<CycleKind, KnowledgeError> {
    let resolution = shop.machine.resolution;
    let along = feed(transition, shop)?;
    let programmed =
        |own: Option<MillimetresPerMinute>| own.map(|own| programmed_feed(own, shop.knowledge)).transpose();
    let radius = |pass: u32| (rounds.after(pass, transition.diameter) - rounds.mill_diameter_mm).half();
    let first = 1 + u32::from(rounds.along_middle);
    let lead = rounds.mill_diameter_mm.half();
    let tightest = programmed(rounds.arc_feed_mm_per_min)?.unwrap_or(along);
    let mut slot = SlotCycle {
        plunge_mm_per_min: programmed(rounds.plunge_feed_mm_per_min)?,
        arcs: Vec::new(),
        run,
        levels: levels(transition, rounds, top, resolution),
        along_middle: rounds.along_middle,
        radii: (first..=rounds.passes).map(|pass| radius(pass).on_grid(resolution)).collect(),
        corner: run.corner.map(|corner| corner - lead),
        lead,
        sense,
    };
    // A wall lies the radius of the mill further out than its middle: the teeth there are faster by as much. The plan knows how slow a
    // feed may be: it is that of the tightest arc.
    let mut radii: Vec<Micrometres> = slot.radii.iter().flat_map(|radius| slot.turns(*radius)).collect();
    radii.sort_unstable();
    radii.dedup();
    for radius in radii {
        let share = radius.to_mm() / (radius + lead).to_mm();
        let own =
            programmed_feed(MillimetresPerMinute(transition.conditions.feed_mm_per_min.0 * share), shop.knowledge)?;
        slot.arcs.push(SlotArc { radius, mm_per_min: if own.0 > tightest.0 { own } else { tightest } });
    }
    Ok(CycleKind::Slot(slot))
}

/// The feed in the steps of programs, rounded down; the feed of a tap depends on its pitch and is not rounded.
fn feed(transition: &Feeding<'_>, shop: &Shop<'_>) -> Result<MillimetresPerMinute, KnowledgeError> {
    let planned = transition.conditions.feed_mm_per_min;
    if transition.operation == Operation::Tap {
        return Ok(planned);
    }
    programmed_feed(planned, shop.knowledge)
}

/// The height above the entry face at which a tool moves from point to point.
fn withdrawal(shop: &Shop<'_>) -> Result<(Micrometres, Because), KnowledgeError> {
    let (value, row) = convention(Convention::Withdrawal, shop.knowledge)?;
    let height = Micrometres::from_mm_rounded(value);
    Ok((height, Because::row(row, Note::new("withdrawal").with("height", height))))
}
