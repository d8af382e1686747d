//! The tailstock centre and its quill before the free end of a part.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Finding, Note, Severity};
use crate::turning::jobs::hole::centre_hole_for;
use crate::turning::length::Half;
use crate::turning::tooling::{Lathe, Workholding};
use crate::turning::workpiece::Workpiece;
use crate::turning::zones::SetUp;
use crate::units::Micrometres;

/// A centre in the centre hole of the free end: a cone from the face outwards, its body, then the quill.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Tailstock {
    /// Z of the face with the centre hole, in the coordinates of the set-up.
    pub face_mm: Half,
    /// The diameter of the cone at the face: the mouth of the centre hole that such an end has (`centre-holes`).
    pub mouth_mm: Micrometres,
    /// The tangent of half the angle of the cone.
    #[serde(skip)]
    pub slope: f64,
    /// The diameter of the centre after its cone.
    pub body_mm: Micrometres,
    /// What stays free between a tool and a centre that is turned down for it, on one side.
    #[serde(skip)]
    pub clearance: Micrometres,
    /// Whether a usual centre is in the way of the tools, so that this one has to be turned down.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub turned_down: bool,
    /// The distance of the quill from the point of the centre.
    pub out_mm: Micrometres,
    /// The diameter of the quill.
    pub quill_mm: Micrometres,
}

impl Tailstock {
    /// The tailstock of a set-up; none where no centre stands, and if the size of the lathe is not known.
    ///
    /// # Errors
    /// The knowledge base lacks a table or a row.
    pub fn of(
        set_up: &SetUp,
        workpiece: &Workpiece,
        lathe: Option<&Lathe<'_>>,
        knowledge: &Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        let (true, Some(lathe)) = (set_up.centre, lathe) else { return Ok(None) };
        let Some(Workholding {
            centre_slope: slope, centre_body, centre_clearance, centre_out, quill_diameter, ..
        }) = lathe.workholding(knowledge)?
        else {
            return Ok(None);
        };
        let blank = set_up.sees(&workpiece.blank.outer, workpiece.length());
        let first = blank.pieces.iter().find(|piece| piece.from.z != piece.to.z);
        let Some(end) = first.map(|piece| piece.from) else { return Ok(None) };
        let mouth_mm = centre_hole_for(end.radius.diameter(), knowledge)?.map_or(Micrometres::ZERO, |row| row.cone);
        Ok(Some(Self {
            face_mm: end.z,
            mouth_mm,
            slope,
            body_mm: centre_body.max(mouth_mm),
            clearance: centre_clearance,
            turned_down: false,
            out_mm: centre_out,
            quill_mm: quill_diameter,
        }))
    }

    /// The distance before the face where the cone reaches the diameter of the body, mm.
    pub fn cone_mm(&self) -> f64 {
        (self.body_mm - self.mouth_mm).to_mm() / 2.0 / self.slope
    }

    /// The distance before the face where the quill ends, mm: the point of the centre is inside the part.
    pub fn quill_off_mm(&self) -> f64 {
        (self.out_mm.to_mm() - self.mouth_mm.to_mm() / 2.0 / self.slope).max(self.cone_mm())
    }

    /// The centre turned down behind its cone until it is clear of tools that come as near to the axis as that; none where nothing
    /// would be left of it beside the centre hole.
    pub fn turned_down(&self, nearest: Half) -> Option<Self> {
        let body_mm = Micrometres::from_mm((nearest - Half::of(self.clearance)).diameter().micrometres() / 1000);
        (body_mm > self.mouth_mm && body_mm < self.body_mm).then_some(Self { body_mm, turned_down: true, ..*self })
    }

    /// That it has to be turned down.
    pub fn finding(&self, set_up: u8) -> Option<Finding> {
        let note = Note::new("centre-turned-down").with("number", set_up).with("body", self.body_mm);
        self.turned_down.then(|| Finding::of_part(Severity::Doubtful, note))
    }

    /// The note about it.
    pub fn note(&self) -> Note {
        Note::new("tailstock-stands")
            .with("mouth", self.mouth_mm)
            .with("body", self.body_mm)
            .with("quill", self.quill_mm)
            .with("off", crate::units::round_to(self.quill_off_mm(), 1))
    }
}
