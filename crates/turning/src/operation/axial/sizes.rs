//! The diameters on the way to the size of a hole on the axis.

use crate::error::KnowledgeError;
use crate::note::{Because, Note};
use crate::tables::holes::StepDiameters;
use crate::tables::practice::StockBeforeReamingFor;
use crate::tables::rules::{DrillBeforeCoreDrillFor, ReamingCase};
use crate::tables::turning::part::AxialWay;
use crate::turning::operation::tools::Bench;
use crate::units::Micrometres;

use super::AxialHole;

/// The diameters on the way to the size of a hole.
pub(super) struct Sizes {
    pub drill: Micrometres,
    pub core_drill: Option<Micrometres>,
    pub rough_ream: Option<Micrometres>,
    pub because: Vec<Because>,
}

impl Sizes {
    /// Those of the handbook, where it has the hole; otherwise the least stock of the tables under the last reamer, and what a core
    /// drill or a rough reamer takes.
    pub fn of(hole: &AxialHole, bench: &Bench<'_, '_>) -> Result<Self, KnowledgeError> {
        let (diameter, twice) = (hole.diameter_mm, hole.way == AxialWay::ReamedTwice);
        if hole.way == AxialWay::Drilled {
            return Ok(Self { drill: diameter, core_drill: None, rough_ream: None, because: Vec::new() });
        }
        let known = bench.knowledge.find(|row: &StepDiameters<'_>| row.diameter == diameter)?;
        if let Some(row) = known.filter(|row| row.core_drill.is_some() == hole.core_drilled) {
            let note = Note::new("axial-steps").with("diameter", diameter);
            return Ok(Self {
                drill: row.drill_1,
                core_drill: row.core_drill,
                rough_ream: row.rough_ream.filter(|_| twice),
                because: vec![Because::row(row.row, note)],
            });
        }
        let mut because = Vec::new();
        let mut stock = |case| -> Result<Micrometres, KnowledgeError> {
            let asked = bench.knowledge.ask(&StockBeforeReamingFor { case, diameter })?;
            let row = asked.need(&diameter.to_string())?;
            because.push(Because::answer(&asked.answer, Note::new("axial-steps").with("diameter", diameter)));
            Ok(row.stock_min)
        };
        let rough_ream = match twice {
            true => Some(diameter - stock(ReamingCase::FinishAfterRough)?),
            false => None,
        };
        let case = match (twice, hole.core_drilled) {
            (true, true) => ReamingCase::RoughAfterCoreDrill,
            (true, false) => ReamingCase::RoughAfterDrill,
            (false, true) => ReamingCase::OneAfterCoreDrill,
            (false, false) => ReamingCase::OneAfterDrill,
        };
        let before = rough_ream.unwrap_or(diameter) - stock(case)?;
        if !hole.core_drilled {
            return Ok(Self { drill: tenths(before), core_drill: None, rough_ream, because });
        }
        let asked = bench.knowledge.ask(&DrillBeforeCoreDrillFor { diameter })?;
        let drill = diameter - asked.need(&diameter.to_string())?.stock;
        Ok(Self { drill, core_drill: Some(before), rough_ream, because })
    }
}

/// Down to whole tenths of a millimetre, as drills are made.
fn tenths(length: Micrometres) -> Micrometres {
    Micrometres::new(length.micrometres() / 100 * 100)
}
