//! The cycle of one transition, by the rule `machining-cycle`.

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, RowRef};
use crate::motion::Sense;
use crate::note::{Because, Note};
use crate::part::Part;
use crate::plan::{Operation, Rounds, Transition};
use crate::shop::Shop;
use crate::tables::controls::{Convention, ProgramConventions};
use crate::tables::rules::{Cut, HoleCycle, MachiningCycle, MachiningCycleFor};
use crate::units::{Micrometres, MillimetresPerMinute, RevsPerMinute, Seconds};
use technolog_note::note;

use super::{Cycle, CycleKind};

/// How a transition of a group is carried out at each of its points.
///
/// # Errors
/// The knowledge cannot answer.
pub(super) fn cycle(
    transition: &Transition,
    pitch: Option<Micrometres>,
    part: &Part,
    shop: &Shop<'_>,
) -> Result<Cycle, KnowledgeError> {
    let solid = transition.operation == Operation::Drill && transition.from_diameter_mm == Micrometres::ZERO;
    let way = if solid { transition.depth_mm - transition.start_mm } else { Micrometres::ZERO };
    let ratio = way.to_mm() / transition.diameter_mm.to_mm();
    let operation = transition.operation;
    let question = MachiningCycleFor { operation, depth_ratio: ratio, material_group: shop.material.group };
    let asked = shop.knowledge.ask(&question)?;
    let rule = asked.need(operation.name())?;
    let note = Note::new("machining-cycle").with("cycle", rule.cycle.name());
    let note = note.with("ratio", crate::units::round_to(ratio, 2));

    let top = part.datum.top;
    // What a control is told stands on the machine's grid.
    let grid = |length: Micrometres| length.on_grid(shop.machine.resolution);
    let begin = grid(top - transition.start_mm + transition.approach_mm);
    let end = grid(top - transition.end());
    let conditions = &transition.conditions;
    let dwell = rule.dwell.filter(|turns| *turns > 0.0);
    let dwell_step = convention(Convention::DwellStep, shop.knowledge)?.0;
    let dwell = dwell.map(|turns| {
        // Up to the next step in which dwells are counted, rounded because tenths do not add up exactly in binary.
        let steps = libm::ceil(turns * 60.0 / conditions.spindle_rpm.0 / dwell_step);
        Seconds(crate::units::round_to(steps * dwell_step, 3))
    });
    let (withdrawal, convention) = withdrawal(shop)?;
    Ok(Cycle {
        operation: transition.operation,
        kind: kind(&rule, transition, pitch, top, shop.machine.resolution)?,
        // Programs count turns in whole numbers; a step between them is rounded down.
        speed_rpm: RevsPerMinute(libm::floor(conditions.spindle_rpm.0)),
        feed_mm_per_min: feed(transition, shop)?,
        begin,
        end,
        out: grid(top + withdrawal).max(begin),
        dwell_s: dwell,
        because: vec![Because::answer(&asked.answer, note), convention],
    })
}

fn kind(
    rule: &MachiningCycle<'_>,
    transition: &Transition,
    pitch: Option<Micrometres>,
    top: Micrometres,
    resolution: Micrometres,
) -> Result<CycleKind, KnowledgeError> {
    let lacks = |what: Note| KnowledgeError::lacks(&rule.row.table.id, what);
    let step = || -> Result<Micrometres, KnowledgeError> {
        let share = rule.step.ok_or_else(|| lacks(note!("nc-step-cycle-steps")))?;
        Ok(Micrometres::from_mm_rounded(transition.diameter_mm.to_mm() * share).on_grid(resolution).max(resolution))
    };
    let clearance = || rule.clearance.ok_or_else(|| lacks(note!("nc-clearance-cycle-steps")));
    Ok(match rule.cycle {
        HoleCycle::Drill => CycleKind::Drill,
        HoleCycle::FeedOut => CycleKind::FeedOut,
        HoleCycle::BoreStop => CycleKind::BoreStop,
        HoleCycle::Peck => CycleKind::Peck { step: step()?, clearance: clearance()? },
        HoleCycle::ChipBreak => CycleKind::ChipBreak { step: step()?, retreat: clearance()? },
        HoleCycle::Tap => CycleKind::Tap { pitch: pitch.ok_or_else(|| lacks(note!("nc-pitch-thread-tapped")))? },
        HoleCycle::Circles => {
            let rounds = transition.conditions.rounds.ok_or_else(|| lacks(note!("nc-circles-mill")))?;
            // The spindle turns clockwise: against it the teeth go with the feed.
            let sense = match rule.cut.ok_or_else(|| lacks(note!("nc-how-mill-cuts")))? {
                Cut::Climb => Sense::Counterclockwise,
                Cut::Conventional => Sense::Clockwise,
            };
            circles(transition, rounds, top, sense, resolution)
        }
    })
}

/// The levels and circles of a mill: the stock in equal passes, the depth in equal levels, the overrun with the last.
fn circles(
    transition: &Transition,
    rounds: Rounds,
    top: Micrometres,
    sense: Sense,
    resolution: Micrometres,
) -> CycleKind {
    let (levels, passes) = (i64::from(rounds.levels.max(1)), i64::from(rounds.passes.max(1)));
    let depth = transition.depth_mm - transition.start_mm;
    let level = |number: i64| match number == levels {
        true => top - transition.end(),
        false => top - transition.start_mm - depth.ratio(number, levels),
    };
    let stock = transition.diameter_mm - rounds.from_diameter_mm;
    let radius = |pass: i64| (rounds.from_diameter_mm + stock.ratio(pass, passes) - rounds.mill_diameter_mm).half();
    CycleKind::Circles {
        levels: (1..=levels).map(|number| level(number).on_grid(resolution)).collect(),
        radii: (1..=passes).map(|pass| radius(pass).on_grid(resolution)).collect(),
        sense,
    }
}

/// The feed in the steps that programs count it in, rounded down; a tap's is bound to its pitch and stays.
fn feed(transition: &Transition, shop: &Shop<'_>) -> Result<MillimetresPerMinute, KnowledgeError> {
    let planned = transition.conditions.feed_mm_per_min;
    if transition.operation == Operation::Tap {
        return Ok(planned);
    }
    let step = convention(Convention::FeedStep, shop.knowledge)?.0;
    Ok(MillimetresPerMinute(libm::floor(planned.0 / step).max(1.0) * step))
}

/// How high over the entry face a tool goes from point to point.
fn withdrawal(shop: &Shop<'_>) -> Result<(Micrometres, Because), KnowledgeError> {
    let (value, row) = convention(Convention::Withdrawal, shop.knowledge)?;
    let height = Micrometres::from_mm_rounded(value);
    Ok((height, Because::row(row, Note::new("withdrawal").with("height", height))))
}

/// A figure of the table `program-conventions`, in the unit of its name, and the row.
pub(crate) fn convention(name: Convention, knowledge: &Knowledge) -> Result<(f64, RowRef<'_>), KnowledgeError> {
    let found = knowledge.need(name.name(), |row: &ProgramConventions<'_>| row.name == name)?;
    if found.unit != name.unit() {
        let problem = note!("nc-must", value = name.name(), unit = name.unit());
        return Err(KnowledgeError::lacks(&found.row.table.id, problem));
    }
    Ok((found.value, found.row))
}
