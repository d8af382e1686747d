//! The accuracy that a transition leaves after another one, by the rule `next-transition` and the tables that it
//! names.

use crate::error::KnowledgeError;
use crate::knowledge::RowRef;
use crate::knowledge::query::TypedAnswer;
use crate::note::{Because, Note};
use crate::part::{BlankHole, CentreTolerance, Hole, Part};
use crate::plan::{Achieved, Operation};
use crate::reason::Reason;
use crate::shop::Shop;
use crate::tables::holes::{
    DrillingWay, HoleAccuracy, PlaneAccuracy, PositionAccuracy, ThreadAccuracy, TransitionAccuracy,
};
use crate::tables::rules::{HoleState, NextTransition, NextTransitionFor, RoughFaceFor};
use crate::units::{ItGrade, Micrometres, Roughness};
use technolog_note::note;

use super::bores::{Before, Bore};
use super::{Promise, Remark, RouteStep};

/// The state of a cylinder before any transition, as the rule `next-transition` names it.
pub(super) fn start(bore: &Bore) -> HoleState {
    match bore.before {
        Before::Own => HoleState::OwnCylinder,
        Before::Blank(BlankHole::Solid) => HoleState::Solid,
        Before::Blank(BlankHole::Cast(_)) => HoleState::CastHole,
        Before::Blank(BlankHole::PreMachined(_)) => HoleState::PreMachinedHole,
    }
}

/// The answer of `next-transition` to a state of a cylinder and the diameter the transition leaves.
pub(super) fn next_transition<'k>(
    state: HoleState,
    diameter: Micrometres,
    bore: &Bore,
    shop: &Shop<'k>,
) -> Result<TypedAnswer<'k, NextTransition<'k>>, KnowledgeError> {
    let beyond_core_drills = bore.beyond_core_drills;
    shop.knowledge.ask(&NextTransitionFor { after: state, diameter, beyond_core_drills })
}

/// Grade and roughness of a row of accuracy.
type Reached = (ItGrade, Roughness);

/// The accuracy that a row of `next-transition` refers to: the fine and the coarse end of the row that states it; absent if the
/// transition only prepares the next.
pub(super) fn of_row<'k>(
    row: &NextTransition<'_>,
    shop: &Shop<'k>,
) -> Result<Option<(Reached, Reached, RowRef<'k>)>, KnowledgeError> {
    let knowledge = shop.knowledge;
    let (found, grades, ra): (RowRef<'k>, _, _) = if let Some(number) = row.a1 {
        let found = knowledge.need(&number.to_string(), |row: &HoleAccuracy<'_>| row.no == number)?;
        let finest = finest(&found)?;
        (found.row, (finest, found.it_coarsest.unwrap_or(finest)), (found.ra_finest, found.ra_coarsest))
    } else if let Some(method) = row.a2 {
        let found = knowledge.need(method, |row: &PlaneAccuracy<'_>| row.method == method)?;
        (found.row, (found.it_finest, found.it_coarsest), (found.ra_finest, found.ra_coarsest))
    } else if let Some(operation) = row.own {
        let found = knowledge.need(operation, |row: &TransitionAccuracy<'_>| row.operation == operation)?;
        (found.row, (found.it_finest, found.it_coarsest), (found.ra_finest, found.ra_coarsest))
    } else {
        return Ok(None);
    };
    let (fine, coarse) = (Roughness::from_ra(ra.0), Roughness::from_ra(ra.1));
    Ok(Some(((grades.0, fine), (grades.1, coarse), found)))
}

/// As `of_row`, with the reason as a plan shows it.
fn of_row_with_reason(
    row: &NextTransition<'_>,
    shop: &Shop<'_>,
) -> Result<Option<(Reached, Reached, Because)>, KnowledgeError> {
    let Some((fine, coarse, found)) = of_row(row, shop)? else { return Ok(None) };
    let note = Note::new("reaches").with("it", fine.0).with("roughness", fine.1);
    let mut because = Because::row(found, note);
    if because.unconfirmed.is_none() {
        because.unconfirmed = row.row.row().unconfirmed.clone();
    }
    Ok(Some((fine, coarse, because)))
}

/// A transition that another one follows is not said to leave a finer grade or surface than that one, as far as the range of its
/// row goes: the fine end of a row belongs to a last cut.
fn no_finer_than_what_follows(
    steps: &mut [RouteStep],
    coarse: &[Option<Reached>],
    shop: &Shop<'_>,
) -> Result<(), KnowledgeError> {
    let rule = shop.knowledge.table_of::<NextTransition<'_>>()?;
    let mut after: Option<Reached> = None;
    for (step, coarse) in steps.iter_mut().zip(coarse).rev() {
        let Some(achieved) = step.achieved.as_mut().filter(|_| step.operation != Operation::Tap) else { continue };
        let Some(own) = achieved.it.zip(achieved.roughness) else { continue };
        let mut left = own;
        if let (Some(after), Some(coarse)) = (after, coarse) {
            left = (own.0.max(after.0.min(coarse.0)), own.1.max(after.1.min(coarse.1)));
        }
        if left != own {
            (achieved.it, achieved.roughness) = (Some(left.0), Some(left.1));
            let note = Note::new("reaches-before-next").with("it", left.0).with("roughness", left.1);
            step.because.push(Because::table(rule, note));
        }
        after = Some(left);
    }
    Ok(())
}

/// Writes the accuracy that each step achieves: by the chain of `next-transition`, for the last step by the promise
/// of the table of the route; and the position of the axis.
///
/// # Errors
/// The knowledge base has no answer.
pub fn write(
    steps: &mut [RouteStep],
    bore: &Bore,
    promise: Option<Promise>,
    position: Position,
    shop: &Shop<'_>,
) -> Result<(), KnowledgeError> {
    let mut state = start(bore);
    let last = steps.iter().rposition(|step| !step.elsewhere && step.operation != Operation::Tap);
    let mut centred = false;
    let mut guided = false;
    let mut before: Option<(Operation, Reached, Reached)> = None;
    let mut ranges: Vec<Option<Reached>> = vec![None; steps.len()];
    for (index, step) in steps.iter_mut().enumerate() {
        centred |= step.operation == Operation::CentreDrill;
        guided |= sets_own_axis(step.operation);
        let mut reached = None;
        // In the tables, the second drill of two-pass drilling is an ordinary drilling.
        let operation = if step.operation == Operation::DrillOut && bore.before.is_solid() {
            state = HoleState::Centred;
            Operation::Drill
        } else {
            step.operation
        };
        // A centring spot has no diameter yet: the rule is queried with the diameter of the cylinder.
        let diameter = if step.diameter > Micrometres::ZERO { step.diameter } else { bore.diameter.nominal };
        let next = if state == HoleState::Finished {
            Vec::new()
        } else {
            next_transition(state, diameter, bore, shop)?.winners()?
        };
        if let Some(row) = next.iter().find(|row| row.operation == operation) {
            state = row.leaves;
            reached = of_row_with_reason(row, shop)?;
        }
        // What another machine reaches is not known here.
        if step.operation == Operation::CentreDrill || step.elsewhere && step.operation != Operation::Tap {
            continue;
        }
        if reached.is_none() {
            reached = match before {
                // A thicker bar after a thinner one leaves the same accuracy as the thinner one.
                Some((same, fine, coarse)) if same == operation => {
                    let note = Note::new("reaches-again").with("it", fine.0).with("roughness", fine.1);
                    Some((fine, coarse, Because::table(shop.knowledge.table_of::<NextTransition<'_>>()?, note)))
                }
                // A transition that prepares the next one does not make worse what the transitions before it left.
                Some((_, fine, coarse)) => by_itself(operation, shop)?.map(|(own, rough, because)| {
                    let (it, roughness) = (fine.0.min(own), fine.1.min(rough));
                    let note = Note::new("reaches-no-worse").with("it", it).with("roughness", roughness);
                    ((it, roughness), coarse, Because { note, ..because })
                }),
                None => by_itself(operation, shop)?.map(|(it, rough, because)| ((it, rough), (it, rough), because)),
            };
        }
        if operation == Operation::Tap {
            let (roughness, because) = tapped(shop)?;
            step.because.push(because);
            step.achieved =
                Some(Achieved { it: None, roughness: Some(roughness), position_mm: position.error(centred, guided) });
            continue;
        }
        let (mut it, mut roughness) = (None, None);
        if let Some((fine, coarse, because)) = reached {
            (it, roughness) = (Some(fine.0), Some(fine.1));
            before = Some((operation, fine, coarse));
            ranges[index] = Some(coarse);
            step.because.push(because);
        }
        if let (Some(promise), true) = (promise, Some(index) == last) {
            if let Some(own) = it.filter(|own| *own > promise.it) {
                // Where the chain itself holds what is asked, nobody needs the promise.
                if own > bore.diameter.it {
                    step.remarks.push(Remark::Promised { it: promise.it, own });
                }
                let note = Note::new("promised").with("it", promise.it).with("own", own);
                step.because.push(Because::table(shop.knowledge.table_of::<HoleAccuracy<'_>>()?, note));
            }
            // The promise of a table counts only where the chain gives no value.
            it = it.or(Some(promise.it));
            roughness = roughness.or(promise.roughness);
        }
        let promised = promise.and_then(|promise| promise.position).filter(|_| Some(index) == last);
        let position_mm = position.error(centred, guided).or(promised);
        step.achieved = Some(Achieved { it, roughness, position_mm });
    }
    no_finer_than_what_follows(steps, &ranges, shop)
}

/// What a transition that only prepares the next one leaves: the coarse end of the range in section 1.2.1; absent if
/// the section gives none.
fn by_itself(operation: Operation, shop: &Shop<'_>) -> Result<Option<(ItGrade, Roughness, Because)>, KnowledgeError> {
    let says = |row: &TransitionAccuracy<'_>| row.prepares.as_ref().is_some_and(|own| own.contains(&operation));
    let Some(row) = shop.knowledge.find(says)? else { return Ok(None) };
    let (grade, roughness) = (row.it_coarsest, Roughness::from_ra(row.ra_coarsest));
    let note = Note::new("reaches-by-itself").with("it", grade).with("roughness", roughness);
    Ok(Some((grade, roughness, Because::row(row.row, note))))
}

/// The roughness that a tap leaves, by table A.3; its grade is the thread's own.
fn tapped(shop: &Shop<'_>) -> Result<(Roughness, Because), KnowledgeError> {
    let tap = Operation::Tap;
    let row = shop.knowledge.need(tap.name(), |row: &ThreadAccuracy<'_>| row.method == tap)?;
    let roughness = Roughness::from_ra(row.ra_finest);
    Ok((roughness, Because::row(row.row, Note::new("reaches-thread").with("roughness", roughness))))
}

/// Whether the tool of this operation sets its own axis and does not follow the hole before it.
pub(super) const fn sets_own_axis(operation: Operation) -> bool {
    operation.is_boring() || matches!(operation, Operation::Mill)
}

/// The finest grade that drilling holds: row 1 of A.1.
///
/// # Errors
/// The knowledge lacks it.
pub fn drilled(shop: &Shop<'_>) -> Result<ItGrade, KnowledgeError> {
    finest(&drilling(shop)?)
}

/// The accuracy that drilling leaves: row 1 of A.1.
pub(super) fn drilling<'k>(shop: &Shop<'k>) -> Result<HoleAccuracy<'k>, KnowledgeError> {
    shop.knowledge.need("drilling", |row: &HoleAccuracy<'_>| row.no == 1)
}

fn finest(row: &HoleAccuracy<'_>) -> Result<ItGrade, KnowledgeError> {
    row.it_finest
        .ok_or_else(|| KnowledgeError::missing(&row.row.table.id, note!("order-row-has-no-grade", no = row.no)))
}

/// The position accuracy of an axis, by the table `position-accuracy` and the machine.
#[derive(Clone, Copy, Debug)]
pub struct Position {
    centred: Micrometres,
    not_centred: Micrometres,
    bored: Micrometres,
    drilled: bool,
}

impl Position {
    /// By the table, and worse by a loss where the drill enters an unmachined face.
    ///
    /// # Errors
    /// The knowledge lacks a row.
    pub fn new(bore: &Bore, part: &Part, shop: &Shop<'_>) -> Result<Self, KnowledgeError> {
        let worst = |drilling: DrillingWay| {
            let row = position_accuracy(drilling, shop)?;
            row.maximum.ok_or_else(|| {
                KnowledgeError::missing(&row.row.table.id, note!("table-lacks-figure-of", name = drilling.name()))
            })
        };
        let loss = 1.0 + rough_face(bore, part, shop)?.map_or(0.0, |(loss, _)| loss);
        let spoilt = |length: Micrometres| Micrometres::from_mm_rounded(length.to_mm() * loss);
        Ok(Self {
            centred: spoilt(worst(DrillingWay::WithCentring)?),
            not_centred: spoilt(worst(DrillingWay::WithoutCentring)?),
            bored: shop.machine.position_accuracy,
            drilled: bore.before.is_solid(),
        })
    }

    /// The position of a cylinder that is opened along the axis of another.
    #[must_use]
    pub fn following(self) -> Self {
        Self { drilled: false, ..self }
    }

    fn error(self, centred: bool, guided: bool) -> Option<Micrometres> {
        match (guided, self.drilled, centred) {
            (true, ..) => Some(self.bored),
            (false, true, true) => Some(self.centred),
            (false, true, false) => Some(self.not_centred),
            // A tool that follows a hole of the blank keeps the axis of that hole; its position is in the drawing of
            // the blank.
            (false, false, _) => None,
        }
    }
}

/// The largest share of position accuracy that is lost at an unmachined face (rule `rough-face`).
///
/// # Errors
/// The knowledge base has no answer.
pub fn rough_face(bore: &Bore, part: &Part, shop: &Shop<'_>) -> Result<Option<(f64, Because)>, KnowledgeError> {
    let answer = shop.knowledge.ask(&RoughFaceFor { entry: part.entry, state: bore.before.state() })?;
    let Some(drilling) = answer.need(part.entry.name())?.loses else { return Ok(None) };
    let loses = position_accuracy(drilling, shop)?;
    let percent = loses
        .loss_max
        .ok_or_else(|| {
            KnowledgeError::missing(&loses.row.table.id, note!("table-lacks-figure-of", name = drilling.name()))
        })?
        .0;
    Ok(Some((percent / 100.0, Because::row(loses.row, Note::new("rough-face").with("percent", percent)))))
}

fn position_accuracy<'k>(drilling: DrillingWay, shop: &Shop<'k>) -> Result<PositionAccuracy<'k>, KnowledgeError> {
    shop.knowledge.need(drilling.name(), |row: &PositionAccuracy<'_>| row.name == drilling)
}

/// The width of the tolerance on centre distances; where it is a grade, it is taken at the smallest distance in the
/// group.
///
/// # Errors
/// The grade has no distance, or the distance is outside the table.
pub fn centre_tolerance(hole: &Hole, shop: &Shop<'_>) -> Result<Micrometres, Reason> {
    match hole.centre_tolerance {
        CentreTolerance::Width(width) => Ok(width),
        CentreTolerance::Grade { it: grade } => {
            let distance = hole.smallest_centre_distance().ok_or(Reason::GradeWithoutDistance { it: grade })?;
            let width = crate::part::tolerance_width(grade, distance, shop.knowledge);
            width.map_err(|why| Reason::GradeOutsideTable { it: grade, distance, why })
        }
    }
}
