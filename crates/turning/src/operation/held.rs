//! The part in a set-up, to calculate its bending.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::note::{Because, Figure, Finding, Note, Severity};
use crate::tables::turning::part::{PartSupport, SupportAsked, TurningSupportFor};
use crate::turning::contour::Contour;
use crate::turning::cutting::{Flexibility, HeldPart, PartSection};
use crate::turning::length::Half;
use crate::turning::workpiece::Workpiece;
use crate::turning::zones::{Hold, SetUp};
use crate::units::Micrometres;

use super::jaws::Jaws;

/// A part in its jaws, at a centre, or both.
#[derive(Clone, Debug)]
pub struct Held {
    part: HeldPart,
    /// Z of the jaws, or of the far centre, in the coordinates of the set-up.
    jaws_at: Half,
}

impl Held {
    /// The held part in a set-up; none if it is not held or its contours enclose no body.
    ///
    /// Its shape is the later one: what the set-up turns with the finished contour, in a second set-up the whole
    /// finished part, with its bore. So the real part is never thinner and never bends more.
    ///
    /// # Errors
    /// The knowledge base lacks a table.
    pub fn of(
        set_up: &SetUp,
        jaws: Option<&Jaws>,
        workpiece: &Workpiece,
        material: &Material<'_>,
        knowledge: &Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        let length = workpiece.length();
        let part = set_up.sees(&workpiece.outer.contour(), length);
        let blank = set_up.sees(&workpiece.blank.outer, length);
        let turned = set_up.outer.as_ref().map(|outer| outer.main.contour.clone());
        let turned_to = turned.as_ref().and_then(Contour::end).map_or(Half::ZERO, |end| end.z);
        let far = |contour: &Contour| contour.pieces.iter().flat_map(|one| [one.from.z, one.to.z]).max();
        let Some(end) = far(&blank) else { return Ok(None) };
        let (support, jaws_at) = match (&set_up.holds_at, jaws) {
            (Some(Hold::Centres), _) => (PartSupport::Centres, end),
            (_, Some(jaws)) if set_up.centre => (PartSupport::ChuckAndCentre, jaws.front_mm),
            (_, Some(jaws)) => (PartSupport::Chuck, jaws.front_mm),
            _ => return Ok(None),
        };
        let inner = workpiece.inner.as_ref().map(|inner| set_up.sees(&inner.contour(), length));
        let bore = |from: Half, to: Half| {
            let within = inner.iter().flat_map(|inner| stretches(inner, from, to));
            within.map(|(.., radii)| radii.1).max().unwrap_or(Half::ZERO)
        };
        // Beyond the turned range of this set-up: the blank, or the part after the first set-up.
        let behind = if set_up.turned_over { &part } else { &blank };
        let mut along = Vec::new();
        if let Some(turned) = &turned {
            along.extend(stretches(turned, Half::ZERO, turned_to));
        }
        along.extend(stretches(behind, turned_to, jaws_at));
        // At the very end of a pointed part there is no thickness, and nothing to bend.
        let solid = along.into_iter().rev().filter(|(.., (least, _))| *least > Half::ZERO);
        let sections = solid.map(|(from, to, (radius, _))| PartSection {
            from: jaws_at - to,
            to: jaws_at - from,
            radius,
            bore: bore(from, to),
        });
        let held = HeldPart::of(support, sections.collect(), material, knowledge)?;
        let rested = |part: HeldPart| match set_up.rest {
            Some(rest) => part.with_rest(jaws_at - rest.z_mm),
            None => part,
        };
        Ok(held.map(|part| Self { part: rested(part), jaws_at }))
    }

    /// The compliance between two places, Z of the set-up; `tolerance` is that of the finished diameter.
    pub fn over(&self, from: Half, to: Half, tolerance: Option<Micrometres>) -> Flexibility {
        self.part.over(self.jaws_at - from, self.jaws_at - to, tolerance)
    }

    /// The required support, where the deflection of the part leaves no useful depth, by the rule `turning-support`.
    /// Shallow passes that a short part bears are slow, and no more than that; a slender one is better supported.
    ///
    /// # Errors
    /// The knowledge base lacks the rule, or a row of it.
    pub fn asks(
        &self,
        bears: Option<Micrometres>,
        knowledge: &Knowledge,
    ) -> Result<(Finding, Because), KnowledgeError> {
        let (support, slenderness) = (self.part.support(), self.part.slenderness());
        let slenderness = crate::units::round_to(slenderness, 1);
        let asked = knowledge.ask(&TurningSupportFor { support, slenderness })?;
        let ask = asked.need(support.name())?.ask;
        let (severity, code) = match bears.filter(|depth| *depth > Micrometres::ZERO) {
            None => (Severity::Wrong, "part-too-slender"),
            Some(_) if ask == SupportAsked::SecondSetUp => (Severity::Note, "part-bears-little"),
            Some(_) => (Severity::Doubtful, "part-bears-little"),
        };
        let note = Note::new(code)
            .with("support", Figure::word(support.name()))
            .with("ratio", slenderness)
            .with("ask", Figure::word(ask.name()));
        let note = bears.into_iter().fold(note, |note, depth| note.with("depth", depth));
        let because = Because::answer(&asked.answer, note.clone());
        Ok((Finding::of_part(severity, note), because))
    }

    /// Whether nothing but the chuck holds it.
    pub fn is_alone(&self) -> bool {
        self.part.support() == PartSupport::Chuck
    }

    /// Whether the part is short for its thickness, by the same rule: no support would make it stiffer.
    ///
    /// # Errors
    /// The knowledge base lacks the rule, or a row of it.
    pub fn is_short(&self, knowledge: &Knowledge) -> Result<bool, KnowledgeError> {
        let (support, slenderness) = (self.part.support(), crate::units::round_to(self.part.slenderness(), 1));
        let asked = knowledge.ask(&TurningSupportFor { support, slenderness })?;
        Ok(asked.need(support.name())?.ask == SupportAsked::SecondSetUp)
    }
}

/// The number of slices of a slope.
const SLICES: i64 = 8;

/// A range of Z with its least and greatest radius.
pub(super) type Stretch = (Half, Half, (Half, Half));

/// A contour between two places as ranges; slopes and arcs are divided.
pub(super) fn stretches(contour: &Contour, from: Half, to: Half) -> Vec<Stretch> {
    let mut stretches = Vec::new();
    for piece in &contour.pieces {
        let (low, high) = (piece.from.z.min(piece.to.z).max(from), piece.from.z.max(piece.to.z).min(to));
        let slices = if piece.is_cylinder() { 1 } else { SLICES };
        let at = |slice: i64| low + Half::new((high - low).halves() * slice / slices);
        for slice in (0..slices).filter(|_| low < high) {
            let ends = [at(slice), at(slice + 1)];
            let radii = ends.iter().flat_map(|z| piece.at_z(*z)).map(|point| point.radius);
            let (least, most) = (radii.clone().min(), radii.max());
            if let (Some(least), Some(most), true) = (least, most, ends[0] < ends[1]) {
                stretches.push((ends[0], ends[1], (least, most)));
            }
        }
    }
    stretches
}
