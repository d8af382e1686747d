//! What accuracy a transition leaves after another, by the rule `next-transition` and the tables it names.

use crate::error::KnowledgeError;
use crate::knowledge::{Answer, Input, RowRef};
use crate::note::{Because, Note};
use crate::part::{BlankHole, CentreTolerance, Entry, Hole, Part};
use crate::plan::{Achieved, Operation};
use crate::reason::Reason;
use crate::shop::Shop;
use crate::units::{ItGrade, Micrometres, Roughness, Unit};

use super::bores::{Before, Bore};
use super::{Promise, Remark, Step};

/// The state a cylinder is in before anything is done to it, as the rule `next-transition` names it.
pub(super) fn start(bore: &Bore) -> &'static str {
    match bore.before {
        Before::Own => "own-cylinder",
        Before::Blank(BlankHole::Solid) => "solid",
        Before::Blank(BlankHole::Cast(_)) => "cast-hole",
        Before::Blank(BlankHole::PreMachined(_)) => "pre-machined-hole",
    }
}

/// The answer of `next-transition` to a state and the diameter the transition leaves.
pub(super) fn after<'k>(state: &str, diameter: Micrometres, shop: &Shop<'k>) -> Result<Answer<'k>, KnowledgeError> {
    let rule = shop.knowledge.table("next-transition")?;
    Ok(rule.decide(&[("after", Input::Text(state)), ("diameter", Input::Length(diameter))])?)
}

/// The accuracy that a row of `next-transition` refers to; absent where its transition only prepares.
pub(super) fn of_row(
    row: RowRef<'_>,
    shop: &Shop<'_>,
) -> Result<Option<(ItGrade, Roughness, Because)>, KnowledgeError> {
    let knowledge = shop.knowledge;
    let found = if let Ok(number) = row.int("a1") {
        let table = knowledge.table("A.1")?;
        table
            .all_rows()
            .find(|row| row.int("no") == Ok(number))
            .ok_or_else(|| KnowledgeError::no_row(table, &number.to_string()))?
    } else if let Ok(method) = row.text("a2") {
        let table = knowledge.table("A.2")?;
        table.find("method", method).ok_or_else(|| KnowledgeError::no_row(table, method))?
    } else if let Ok(operation) = row.text("own") {
        let table = knowledge.table("transition-accuracy")?;
        table.find("operation", operation).ok_or_else(|| KnowledgeError::no_row(table, operation))?
    } else {
        return Ok(None);
    };
    let it = found.grade("it_finest")?;
    let roughness = ra(found, "ra_finest")?;
    let note = Note::new("reaches").with("it", it).with("roughness", roughness);
    let mut because = Because::row(found, note);
    if because.unconfirmed.is_none() {
        because.unconfirmed = row.row().unconfirmed.clone();
    }
    Ok(Some((it, roughness, because)))
}

/// Writes into every step what it achieves: by the chain of `next-transition`, the last one by the promise
/// of the table the route was found in; and the position of the axis.
///
/// # Errors
/// The knowledge cannot answer.
pub fn write(
    steps: &mut [Step],
    bore: &Bore,
    promise: Option<Promise>,
    position: Position,
    shop: &Shop<'_>,
) -> Result<(), KnowledgeError> {
    let mut state = start(bore).to_owned();
    let last = steps.iter().rposition(|step| !step.elsewhere && step.operation != Operation::Tap);
    let mut centred = false;
    let mut guided = false;
    let mut before: Option<(Operation, ItGrade, Roughness)> = None;
    for (index, step) in steps.iter_mut().enumerate() {
        centred |= step.operation == Operation::CentreDrill;
        guided |= guides(step.operation);
        let mut reached = None;
        // The second drill of two-pass drilling is one drilling to the tables.
        let operation = if step.operation == Operation::DrillOut && bore.before.is_solid() {
            "centred".clone_into(&mut state);
            Operation::Drill
        } else {
            step.operation
        };
        // A centring spot has no diameter yet: the rule is asked with the cylinder's.
        let asked = if step.diameter > Micrometres::ZERO { step.diameter } else { bore.diameter.nominal };
        let answer = if known(&state) { Some(after(&state, asked, shop)?) } else { None };
        let row = answer
            .as_ref()
            .and_then(|answer| answer.winners().find(|row| row.text("operation") == Ok(operation.name())));
        if let Some(row) = row {
            row.text("leaves")?.clone_into(&mut state);
            reached = of_row(row, shop)?;
        }
        if step.operation == Operation::CentreDrill {
            continue;
        }
        if reached.is_none() {
            reached = match before {
                // A wider bar after a slimmer one leaves what the slimmer one did.
                Some((same, it, roughness)) if same == operation => {
                    let note = Note::new("reaches-again").with("it", it).with("roughness", roughness);
                    Some((it, roughness, Because::table(shop.knowledge.table("next-transition")?, note)))
                }
                // What prepares the next transition makes nothing worse than the transitions before it left.
                Some((_, it, roughness)) => by_itself(operation, shop)?.map(|(own, rough, because)| {
                    let (it, roughness) = (it.min(own), roughness.min(rough));
                    let note = Note::new("reaches-no-worse").with("it", it).with("roughness", roughness);
                    (it, roughness, Because { note, ..because })
                }),
                None => by_itself(operation, shop)?,
            };
        }
        if operation == Operation::Tap {
            let (roughness, because) = tapped(shop)?;
            step.because.push(because);
            step.achieved =
                Some(Achieved { it: None, roughness: Some(roughness), position_mm: position.of(centred, guided) });
            continue;
        }
        let (mut it, mut roughness) = (None, None);
        if let Some((grade, rough, because)) = reached {
            (it, roughness) = (Some(grade), Some(rough));
            before = Some((operation, grade, rough));
            step.because.push(because);
        }
        if let (Some(promise), true) = (promise, Some(index) == last) {
            if let Some(own) = it.filter(|own| *own > promise.it) {
                step.remarks.push(Remark::Promised { it: promise.it, own });
                let note = Note::new("promised").with("it", promise.it).with("own", own);
                step.because.push(Because::table(shop.knowledge.table("A.1")?, note));
            }
            it = Some(it.map_or(promise.it, |it| it.min(promise.it)));
            let promised = promise.roughness;
            roughness = match (roughness, promised) {
                (Some(own), Some(promised)) => Some(own.min(promised)),
                (own, promised) => own.or(promised),
            };
        }
        let own = position.of(centred, guided);
        let promised = promise.and_then(|promise| promise.position).filter(|_| Some(index) == last);
        let position_mm = match (own, promised) {
            (Some(own), Some(promised)) => Some(own.min(promised)),
            (own, promised) => own.or(promised),
        };
        step.achieved = Some(Achieved { it, roughness, position_mm });
    }
    Ok(())
}

/// What a transition that only prepares the next one leaves: the coarse end of what section 1.2.1 says of it
/// by itself; absent where it says nothing.
fn by_itself(operation: Operation, shop: &Shop<'_>) -> Result<Option<(ItGrade, Roughness, Because)>, KnowledgeError> {
    let table = shop.knowledge.table("transition-accuracy")?;
    let says = |row: &RowRef<'_>| row.texts("prepares").is_ok_and(|own| own.contains(&operation.name()));
    let Some(row) = table.all_rows().find(says) else { return Ok(None) };
    let (it, roughness) = (row.grade("it_coarsest")?, ra(row, "ra_coarsest")?);
    let note = Note::new("reaches-by-itself").with("it", it).with("roughness", roughness);
    Ok(Some((it, roughness, Because::row(row, note))))
}

/// The roughness that a tap leaves, by table A.3; its grade is the thread's own.
fn tapped(shop: &Shop<'_>) -> Result<(Roughness, Because), KnowledgeError> {
    let table = shop.knowledge.table("A.3")?;
    let row = table.find("method", "tap").ok_or_else(|| KnowledgeError::no_row(table, "tap"))?;
    let roughness = ra(row, "ra_finest")?;
    Ok((roughness, Because::row(row, Note::new("reaches-thread").with("roughness", roughness))))
}

/// A column of Ra, micrometres.
pub(super) fn ra(row: RowRef<'_>, column: &str) -> Result<Roughness, KnowledgeError> {
    let micrometres = row.number_in(column, Unit::Micrometre)?;
    Ok(Roughness::from_ra_nanometres((micrometres * 1000.0).round() as u32))
}

fn known(state: &str) -> bool {
    !matches!(state, "finished" | "")
}

/// Whether a tool of this operation makes its own axis and does not follow the hole before it.
pub(super) const fn guides(operation: Operation) -> bool {
    operation.is_boring() || matches!(operation, Operation::Mill)
}

/// The finest grade that drilling holds: row 1 of A.1.
///
/// # Errors
/// The knowledge lacks it.
pub fn drilled(shop: &Shop<'_>) -> Result<ItGrade, KnowledgeError> {
    let table = shop.knowledge.table("A.1")?;
    let row = table.row(0).ok_or_else(|| KnowledgeError::no_row(table, "drilling"))?;
    Ok(row.grade("it_finest")?)
}

/// What the position of an axis is worth, by the table `position-accuracy` and the machine.
#[derive(Clone, Copy, Debug)]
pub struct Position {
    centred: Micrometres,
    not_centred: Micrometres,
    bored: Micrometres,
    drilled: bool,
}

impl Position {
    /// By the table, worse by its loss where the drill enters an unmachined face.
    ///
    /// # Errors
    /// The knowledge lacks a row.
    pub fn new(bore: &Bore, part: &Part, shop: &Shop<'_>) -> Result<Self, KnowledgeError> {
        let table = shop.knowledge.table("position-accuracy")?;
        let row = |name: &str| table.find("name", name).ok_or_else(|| KnowledgeError::no_row(table, name));
        let worst = |name: &str| -> Result<Micrometres, KnowledgeError> { Ok(row(name)?.length("maximum")?) };
        let loss = 1.0 + rough_face(bore, part, shop)?.map_or(0.0, |(loss, _)| loss);
        let spoilt = |length: Micrometres| Micrometres::from_mm_rounded(length.to_mm() * loss);
        Ok(Self {
            centred: spoilt(worst("drilling-with-centring")?),
            not_centred: spoilt(worst("drilling-without-centring")?),
            bored: shop.machine.position_accuracy,
            drilled: bore.before.is_solid(),
        })
    }

    /// Of a cylinder that is opened along the axis of another.
    #[must_use]
    pub fn following(self) -> Self {
        Self { drilled: false, ..self }
    }

    fn of(self, centred: bool, guided: bool) -> Option<Micrometres> {
        match (guided, self.drilled, centred) {
            (true, ..) => Some(self.bored),
            (false, true, true) => Some(self.centred),
            (false, true, false) => Some(self.not_centred),
            // A tool that follows a hole of the blank keeps its axis, which the drawing of the blank knows.
            (false, false, _) => None,
        }
    }
}

/// The largest share of position accuracy that an unmachined face costs (rule `rough-face`).
///
/// # Errors
/// The knowledge cannot answer.
pub fn rough_face(bore: &Bore, part: &Part, shop: &Shop<'_>) -> Result<Option<(f64, Because)>, KnowledgeError> {
    let rule = shop.knowledge.table("rough-face")?;
    let entry = if part.entry == Entry::Rough { "rough" } else { "machined" };
    let state = if bore.before.is_solid() { "solid" } else { "cast-or-pre-machined" };
    let answer = rule.decide(&[("entry", Input::Text(entry)), ("state", Input::Text(state))])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, entry))?;
    let Ok(name) = row.text("loses") else { return Ok(None) };
    let table = shop.knowledge.table("position-accuracy")?;
    let loses = table.find("name", name).ok_or_else(|| KnowledgeError::no_row(table, name))?;
    let percent = loses.number_in("loss_max", Unit::Percent)?;
    Ok(Some((percent / 100.0, Because::row(loses, Note::new("rough-face").with("percent", percent)))))
}

/// The width of the tolerance on centre distances; a grade is taken at the group's smallest distance.
///
/// # Errors
/// The grade has no distance, or stands at one outside the table.
pub fn centre_tolerance(hole: &Hole, shop: &Shop<'_>) -> Result<Micrometres, Reason> {
    match hole.centre_tolerance {
        CentreTolerance::Width(width) => Ok(width),
        CentreTolerance::Grade { it } => {
            let distance = hole.smallest_centre_distance().ok_or(Reason::GradeWithoutDistance { it })?;
            let width = crate::part::tolerance_width(it, distance, shop.knowledge);
            width.map_err(|why| Reason::GradeOutsideTable { it, distance, why })
        }
    }
}
