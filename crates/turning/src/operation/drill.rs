//! The hole that is drilled before a solid blank is bored, by the rule `bore-drill`. It is named, not planned.

use serde::Serialize;
use technolog_note::note;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Finding, Note, Severity, doubtful_row};
use crate::tables::turning::part::BoreDrillFor;
use crate::turning::contour::{Contour, Side};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::units::Micrometres;

/// A hole drilled first.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Drilled {
    /// Its diameter, mm.
    pub diameter_mm: Micrometres,
    /// Its depth: Z of its end in the set-up, mm.
    pub depth_mm: Half,
    /// The row of its diameter.
    pub because: Because,
}

impl Drilled {
    /// The depth of its full diameter: the point of the drill, of 118°, ends at its depth. A bar cannot bore away the
    /// metal beside the point, because it would meet the wall on the other side.
    pub(super) fn full_depth(&self) -> Half {
        self.depth_mm - point_length(Half::radius_of(self.diameter_mm))
    }

    /// Its wall, from the beginning of the rough bore.
    pub(super) fn contour(&self, rough: &Contour) -> Contour {
        let radius = Half::radius_of(self.diameter_mm);
        let ends = [rough.start(), rough.end()].into_iter().flatten().map(|end| Point { radius, z: end.z });
        Contour::through(Side::Inner, &ends.collect::<Vec<_>>())
    }
}

/// The length of a drill's point, of 118° (ГОСТ 10903), up to a radius.
pub(super) fn point_length(radius: Half) -> Half {
    /// Half the angle of the point, degrees.
    const HALF_POINT: f64 = 59.0;
    Half::from(radius.to_mm() / libm::tan(HALF_POINT.to_radians()))
}

/// The hole to drill under a rough bore, and the bore without the part of its bottom that the drill removes; none,
/// with a finding, if the bore is too narrow to be drilled and bored.
///
/// # Errors
/// The knowledge base lacks the rule `bore-drill`, or a row of it.
pub(super) fn before_boring(
    rough: &Contour,
    knowledge: &Knowledge,
    findings: &mut Vec<Finding>,
) -> Result<Option<(Drilled, Contour)>, KnowledgeError> {
    let walls = rough.pieces.iter().filter(|piece| !piece.is_face());
    let narrow = walls.flat_map(|piece| [piece.from.radius, piece.to.radius]).min();
    let (Some(narrow), Some(end)) = (narrow, rough.end()) else { return Ok(None) };
    let asked = knowledge.ask(&BoreDrillFor { diameter: narrow.diameter().max(Micrometres::ZERO) })?;
    let rule = asked.need(&narrow.diameter().to_string())?;
    findings.extend(doubtful_row(rule.row));
    let stock_and_step = match (rule.drilled, rule.least_stock, rule.step, rule.largest) {
        (true, Some(stock), Some(step), Some(largest)) => Some((stock, step, largest)),
        (true, ..) => {
            return Err(KnowledgeError::missing(&rule.row.table.id, note!("turned-bore-drilled-has-stock-step")));
        }
        (false, ..) => None,
    };
    let drill = stock_and_step.map(|(stock, step, largest)| {
        let most = (narrow - Half::of(stock)).diameter().min(largest);
        (most.micrometres() / step.micrometres().max(1), stock, step, largest)
    });
    let Some((steps, stock, step, largest)) = drill.filter(|(steps, ..)| *steps > 0) else {
        let note = Note::new("bore-too-narrow-to-drill").with("diameter", narrow.diameter());
        findings.push(Finding::of_part(Severity::Error, note));
        return Ok(None);
    };
    let diameter = Micrometres::new(step.micrometres().saturating_mul(steps));
    let note = Note::new("bore-drilled-first").with("diameter", diameter).with("depth", end.z);
    let note = note.with("stock", stock).with("step", step).with("largest", largest);
    findings.push(Finding::of_part(Severity::Note, note.clone()));
    let because = Because::answer(&asked.answer, note);
    Ok(Some((Drilled { diameter_mm: diameter, depth_mm: end.z, because }, without_middle(rough, diameter))))
}

/// A blind bore ends with its bottom; the drill has removed the middle of it.
fn without_middle(rough: &Contour, drill: Micrometres) -> Contour {
    let (mut rough, radius) = (rough.clone(), Half::radius_of(drill));
    if let Some(bottom) = rough.pieces.last_mut().filter(|last| last.is_face() && last.to.radius < radius) {
        bottom.to.radius = radius;
    }
    rough
}
