//! Practice tables for a transition: its accuracy and the offset of its axis.

use crate::error::KnowledgeError;
use crate::part::tolerance_width;
use crate::plan::{Operation, Transition};
use crate::shop::Shop;
use crate::tables::practice::{DrillDriftFor, DrillOversizeFor, HolePositionReachFor, ReachOfTransitionFor};
use crate::tables::rules::{MadeBy, WayOfTransitionFor, Worst};
use crate::units::{ItGrade, Micrometres, Roughness};

/// The best and the ordinary value of a figure.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Both<T> {
    pub best: T,
    pub ordinary: T,
}

/// The accuracy of a transition.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reach {
    /// The grade of its diameter; none for threads.
    pub grade: Option<Both<ItGrade>>,
    pub roughness: Both<Roughness>,
    /// The offset of its axis from the programmed position; none if it follows the hole.
    pub own_axis: Option<Both<Micrometres>>,
    worst: Worst,
}

/// What identifies the method of a transition in the tables.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MethodKey {
    pub operation: Operation,
    pub centred: bool,
    pub made_by: MadeBy,
    pub last: bool,
}

impl Reach {
    /// The accuracy of a transition in a hole of that diameter; none for a spot.
    pub fn of(method: MethodKey, diameter: Micrometres, shop: &Shop<'_>) -> Result<Option<Self>, KnowledgeError> {
        if method.operation == Operation::CentreDrill {
            return Ok(None);
        }
        let knowledge = shop.knowledge;
        let MethodKey { operation, centred, made_by: after, last } = method;
        let named = knowledge.ask(&WayOfTransitionFor { operation, centred, after, last })?.need(operation.name())?;
        let Some(row) = knowledge.ask(&ReachOfTransitionFor { way: named.way, diameter })?.winner()? else {
            return Ok(None);
        };
        let axis = knowledge.ask(&HolePositionReachFor { way: named.way })?.need(named.way)?;
        let own = axis.error_best.zip(axis.error_ordinary).filter(|_| !axis.follows);
        Ok(Some(Self {
            grade: row.it_best.zip(row.it_ordinary).map(|(best, ordinary)| Both { best, ordinary }),
            roughness: Both { best: Roughness::from_ra(row.ra_best), ordinary: Roughness::from_ra(row.ra_ordinary) },
            own_axis: own.map(|(best, ordinary)| Both { best, ordinary }),
            worst: named.worst,
        }))
    }

    /// How much a hole of that diameter may be wider than its tool in the worst case; none outside the tables of
    /// tolerances.
    pub fn width(&self, diameter: Micrometres, shop: &Shop<'_>) -> Option<Micrometres> {
        let it = self.grade?;
        let grade = match self.worst {
            Worst::Best => it.best,
            Worst::Ordinary => it.ordinary,
        };
        tolerance_width(grade, diameter, shop.knowledge).ok()
    }
}

/// The drift of the axis at the end of a drilled hole; none for diameters outside the table.
pub(crate) fn drift(diameter: Micrometres, depth: Micrometres, shop: &Shop<'_>) -> Result<Micrometres, KnowledgeError> {
    let Some(answer) = shop.knowledge.ask_within(&DrillDriftFor { diameter })? else { return Ok(Micrometres::ZERO) };
    Ok(answer
        .winner()?
        .map_or(Micrometres::ZERO, |row| Micrometres::from_mm_rounded(row.drift * depth.to_mm() / 1000.0)))
}

/// The mean oversize of a drilled hole; none for diameters outside the table.
///
/// The largest figures are not used: they belong to badly ground drills and would leave no stock after the handbook's
/// own drills before reamers, Ø7.8 under Ø8.
pub(crate) fn oversize(transition: &Transition, shop: &Shop<'_>) -> Result<Micrometres, KnowledgeError> {
    let question = DrillOversizeFor { diameter: transition.diameter_mm };
    let Some(answer) = shop.knowledge.ask_within(&question)? else { return Ok(Micrometres::ZERO) };
    Ok(answer.winner()?.map_or(Micrometres::ZERO, |row| row.oversize_mean))
}
