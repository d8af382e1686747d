//! The bodies that hold a part: chuck, jaws, centre and quill, in the half-plane.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::tables::lathes::{LatheWorkholding, WorkholdingFigure as Figure};
use crate::units::{Micrometres, Minutes};

use super::Lathe;

/// Seconds.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Seconds(pub f64);

/// The workholding of a lathe. No body is smaller than the real one (`chuck-and-tailstock`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Workholding {
    /// Diameter of the chuck.
    pub chuck_diameter: Micrometres,
    /// The length of the jaws before the face of the chuck, and their greatest height above the gripped diameter.
    pub jaw: Micrometres,
    /// The most that jaws close on along the axis: not more than the real ones.
    pub grip: Micrometres,
    /// The tangent of half the angle of the centre.
    pub centre_slope: f64,
    /// Diameter of the centre after its cone.
    pub centre_body: Micrometres,
    /// What stays free between a tool and a centre that is turned down for it, on one side.
    pub centre_clearance: Micrometres,
    /// The distance of the centre's point from the quill.
    pub centre_out: Micrometres,
    /// Diameter of the quill after the centre.
    pub quill_diameter: Micrometres,
}

impl Workholding {
    /// The swing diameter of jaws that grip a part from outside.
    pub fn jaws_sweep(&self, gripped: Micrometres) -> Micrometres {
        (gripped + self.jaw + self.jaw).min(self.chuck_diameter).max(gripped)
    }
}

impl<'k> Lathe<'k> {
    /// Chuck and tailstock; none if the record has no diameter over the bed.
    ///
    /// # Errors
    /// The knowledge base lacks the table `chuck-and-tailstock`, or a row of it.
    pub fn workholding(&self, knowledge: &'k Knowledge) -> Result<Option<Workholding>, KnowledgeError> {
        let Some(bed) = self.over_bed else { return Ok(None) };
        let of = |whole: Micrometres, name: Figure| -> Result<Micrometres, KnowledgeError> {
            Ok(Micrometres::from_mm_rounded(whole.to_mm() * figure(name, knowledge)?))
        };
        let chuck_diameter = of(bed, Figure::ChuckDiameterShare)?;
        Ok(Some(Workholding {
            chuck_diameter,
            jaw: of(chuck_diameter, Figure::JawShare)?,
            grip: of(chuck_diameter, Figure::JawGripShare)?,
            centre_slope: libm::tan((figure(Figure::CentreAngle, knowledge)? / 2.0).to_radians()),
            centre_body: Micrometres::from_mm_rounded(figure(Figure::CentreBody, knowledge)?),
            centre_clearance: Micrometres::from_mm_rounded(figure(Figure::CentreClearance, knowledge)?),
            centre_out: Micrometres::from_mm_rounded(figure(Figure::CentreOut, knowledge)?),
            quill_diameter: of(bed, Figure::QuillShare)?,
        }))
    }

    /// The time of a tool change: of its record, otherwise by `chuck-and-tailstock`.
    ///
    /// # Errors
    /// The knowledge base lacks that table, or its row.
    pub fn tool_change(&self, knowledge: &'k Knowledge) -> Result<Seconds, KnowledgeError> {
        match self.tool_change {
            Some(time) => Ok(time),
            None => Seconds::of_table(Figure::ToolChangeTime, knowledge),
        }
    }
}

impl Seconds {
    /// A time of `chuck-and-tailstock`.
    ///
    /// # Errors
    /// The knowledge base lacks that table, or its row.
    pub fn of_table(name: Figure, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        Ok(Self(figure(name, knowledge)?))
    }

    /// The same in minutes.
    pub fn minutes(self) -> Minutes {
        Minutes(self.0 / 60.0)
    }
}

/// One figure of the table.
///
/// # Errors
/// The knowledge base lacks that table, or its row.
pub(crate) fn figure(name: Figure, knowledge: &Knowledge) -> Result<f64, KnowledgeError> {
    Ok(knowledge.need(name.name(), |row: &LatheWorkholding<'_>| row.name.is(name))?.value)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 16К20Ф3, 400 over the bed: a chuck of 250; jaws of 75; they grip 43.5; gripping Ø60 they sweep 60 + 2·75 = 210, gripping Ø200
    /// not more than the chuck; the quill 90. Its record has no time of a tool change, that of 16М30Ф3 has 4 s.
    #[test]
    fn bodies_follow_from_the_size_of_the_lathe() {
        let knowledge = crate::shipped::knowledge().unwrap();
        let lathe = Lathe::find(&knowledge, "16k20f3").unwrap();
        let held = lathe.workholding(&knowledge).unwrap().unwrap();
        let mm = Micrometres::from_mm_rounded;
        assert_eq!((held.chuck_diameter, held.jaw, held.quill_diameter), (mm(250.0), mm(75.0), mm(90.0)));
        assert_eq!(held.grip, mm(43.5));
        assert_eq!((held.jaws_sweep(mm(60.0)), held.jaws_sweep(mm(200.0))), (mm(210.0), mm(250.0)));
        for lathe in ["16k20f3", "16m30f3"] {
            assert_eq!(Lathe::find(&knowledge, lathe).unwrap().tool_change(&knowledge).unwrap(), Seconds(4.0));
        }
    }
}
