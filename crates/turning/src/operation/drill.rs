//! The hole that is drilled before a bore, by the rule `bore-drill`.

use serde::Serialize;
use technolog_note::note;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Finding, Note, Severity, doubtful_row};
use crate::tables::turning::part::BoreDrillFor;
use crate::turning::contour::{Contour, Side};
use crate::turning::jobs::{Body, Job, Work};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::units::Micrometres;

impl Job {
    /// The diameter of the hole that it drills; none if it does something else.
    pub(super) fn drills(&self) -> Option<Micrometres> {
        match self.tool.body {
            Body::Drill { diameter_mm, .. } if self.work == Work::Drill => Some(diameter_mm),
            _ => None,
        }
    }

    /// Whether its tool comes to a Z.
    pub(super) fn comes_to(&self, z: Half) -> bool {
        self.path.moves.iter().any(|one| one.to.z >= z)
    }
}

/// A hole drilled first.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Drilled {
    /// Its diameter, mm.
    pub diameter_mm: Micrometres,
    /// Its depth: Z of its end in the set-up, mm.
    pub depth_mm: Half,
    /// Whether it needs a drill of its own; otherwise a hole that is made to size, or that of the blank, goes through here.
    #[serde(skip)]
    pub own: bool,
    /// Whether its bottom is made flat, because no bar has room beside the cone of the drill's point.
    #[serde(skip)]
    pub flat: bool,
    /// The row of its diameter.
    pub because: Because,
}

impl Drilled {
    /// Its wall, from the beginning of the rough bore.
    pub(super) fn contour(&self, rough: &Contour) -> Contour {
        let radius = Half::radius_of(self.diameter_mm);
        let ends = [rough.start(), rough.end()].into_iter().flatten().map(|end| Point { radius, z: end.z });
        Contour::through(Side::Inner, &ends.collect::<Vec<_>>())
    }
}

/// The hole to drill under a rough bore, and the bore without the part of its bottom that the drill removes; none,
/// with a finding, if the bore is too narrow to be drilled and bored. `there` is the diameter of the hole that is there before:
/// that of the blank, or one that is made to size behind this bore; `least_bar` the smallest hole that a bar enters which reaches the end.
///
/// # Errors
/// The knowledge base lacks the rule `bore-drill`, or a row of it.
pub(super) fn before_boring(
    rough: &Contour,
    there: Micrometres,
    least_bar: Option<Micrometres>,
    knowledge: &Knowledge,
    findings: &mut Vec<Finding>,
) -> Result<Option<(Drilled, Contour)>, KnowledgeError> {
    let (Some(narrow), Some(end)) = (rough.narrowest(), rough.end()) else { return Ok(None) };
    let asked = knowledge.ask(&BoreDrillFor { diameter: narrow.diameter().max(Micrometres::ZERO) })?;
    let rule = asked.need(&narrow.diameter().to_string())?;
    findings.extend(doubtful_row(rule.row));
    let figures = (rule.least_stock, rule.stock_for_bar, rule.step, rule.largest.zip(rule.largest_for_bar));
    let stock_and_step = match (rule.drilled, figures) {
        (true, (Some(stock), Some(for_bar), Some(step), Some(largest))) => Some((stock, for_bar, step, largest)),
        (true, ..) => {
            return Err(KnowledgeError::missing(&rule.row.table.id, note!("turned-bore-drilled-has-stock-step")));
        }
        (false, ..) => None,
    };
    let drill = stock_and_step.map(|(stock, for_bar, step, (usual, for_any_bar))| {
        let steps = |stock: Micrometres, largest: Micrometres| {
            let most = (narrow - Half::of(stock)).diameter().min(largest);
            most.micrometres() / step.micrometres().max(1)
        };
        let diameter = |steps: i64| Micrometres::new(step.micrometres().saturating_mul(steps));
        let enters = |steps: &i64| least_bar.is_none_or(|least| least <= diameter(*steps));
        let first = steps(stock, usual);
        let wide = (first..=steps(for_bar, usual)).find(enters).map(|wide| (wide, usual));
        let wide = wide.or_else(|| (first..=steps(stock, for_any_bar)).find(enters).map(|wide| (wide, for_any_bar)));
        let (steps, largest) = wide.unwrap_or((first, usual));
        (steps, stock, step, largest)
    });
    let Some((steps, stock, step, largest)) = drill.filter(|(steps, ..)| *steps > 0) else {
        let note = Note::new("bore-too-narrow-to-drill").with("diameter", narrow.diameter());
        findings.push(Finding::of_part(Severity::Error, note));
        return Ok(None);
    };
    let widest = Micrometres::new(step.micrometres().saturating_mul(steps));
    let own = widest > there;
    let diameter = widest.max(there);
    let note = Note::new("bore-drilled-first").with("diameter", diameter).with("depth", end.z);
    let note = note.with("stock", stock).with("step", step).with("largest", largest);
    if own {
        findings.push(Finding::of_part(Severity::Note, note.clone()));
    }
    let because = Because::answer(&asked.answer, note);
    let flat = rough.pieces.last().is_some_and(|last| last.is_face() && last.to.radius < last.from.radius);
    let drilled = Drilled { diameter_mm: diameter, depth_mm: end.z, own, flat, because };
    Ok(Some((drilled, without_middle(rough, diameter))))
}

/// A blind bore ends with its bottom, one before a narrower hole with its shoulder: the drill has removed the middle of it, or
/// leaves more than the narrower hole will.
fn without_middle(rough: &Contour, drill: Micrometres) -> Contour {
    let (mut rough, radius) = (rough.clone(), Half::radius_of(drill));
    if let Some(bottom) = rough.pieces.last_mut().filter(|last| last.is_face() && last.to.radius < last.from.radius) {
        bottom.to.radius = radius;
    }
    rough
}
