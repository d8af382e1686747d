//! From a hole to its ordered transitions and their intermediate diameters.
//!
//! [`bores::task`] divides a hole into cylinders and edges. Three sources give candidates for its main cylinder: the
//! scheme tables ([`scheme`], [`auxiliary`]), the complexes ([`complex`]) and the [`search`] over its states.
//! [`diameters::steps`] turns a candidate into steps, backwards from the finished diameter, or says which inequality
//! fails. [`openings`] plans the rest of the hole, and [`order`] sorts all steps by section 1.1.2.

pub mod accuracy;
pub mod auxiliary;
pub mod bores;
pub mod complex;
pub mod diameters;
mod handbook;
pub mod openings;
pub mod order;
pub mod point;
pub mod scheme;
pub mod search;
pub mod table_answer;

use crate::error::KnowledgeError;
use crate::note::Because;
use crate::part::{Face, ToleratedDiameter};
use crate::plan::{Achieved, Feature, Operation, RouteSource};
use crate::shop::Shop;
use crate::tables::rules::UnfinishedOverFloorFor;
use crate::units::{ItGrade, Micrometres, Roughness};

/// A route that the main cylinder of a hole may take.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// The source it was found in.
    pub source: RouteSource,
    /// `A.8`, `A.9`, `A.10`, `A.5` or the search's rule.
    pub table: String,
    /// The scheme of A.7 as the plan names it, such as `07` or `04 + centre`; the name of the complex; the
    /// transitions of the search.
    pub scheme: String,
    /// Its transitions in order.
    pub transitions: Vec<Operation>,
    /// Whether the tables finish the hole on another machine.
    pub finish_elsewhere: bool,
    /// Whether it stands in where the tables have no cell of their own: any other route goes before it.
    pub last_resort: bool,
    /// The accuracy that its table promises; absent if only the chain of transitions says it.
    pub promise: Option<Promise>,
    /// The rows it rests on.
    pub because: Vec<Because>,
}

/// Grade and roughness that a table promises for a scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Promise {
    /// The grade.
    pub it: ItGrade,
    /// The roughness; absent if the table does not require it.
    pub roughness: Option<Roughness>,
    /// The tolerance on centre distances of its cell; absent if the table does not require it.
    pub position: Option<Micrometres>,
}

/// Where a step works.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct StepLocation {
    /// The feature of the hole that it makes.
    pub feature: Feature,
    /// The number of the step of a stepped hole, from 1.
    pub step: Option<usize>,
    /// The face it is entered from.
    pub face: Face,
    /// Where cutting begins, below that face.
    pub start: Micrometres,
    /// The end of the full diameter, below that face.
    pub depth: Micrometres,
    /// Whether the tool may run past the end.
    pub through: bool,
}

/// One step of a route.
#[derive(Clone, Debug)]
pub struct RouteStep {
    /// What is done.
    pub operation: Operation,
    /// Where.
    pub place: StepLocation,
    /// The diameter it leaves.
    pub diameter: Micrometres,
    /// The size of the catalog's cutter, where it is ground to another size.
    pub nominal: Micrometres,
    /// The grade of the field H whose cutter is bought for it, where a reamer finishes with its own size.
    pub bought_for: Option<ItGrade>,
    /// The diameter before it; zero in solid metal.
    pub from: Micrometres,
    /// The hole that its cutter can enter, where that is not the one it widens: a mill finishes what it has roughed itself.
    pub entered: Option<Micrometres>,
    /// Passes of the same tool.
    pub passes: u32,
    /// Pitch of a thread.
    pub pitch: Option<Micrometres>,
    /// Full angle of a cone, thousandths of a degree.
    pub angle_millideg: Option<u32>,
    /// The cylinder above, through which its cutter must pass; absent if there is none.
    pub entry_cylinder: Option<Micrometres>,
    /// The diameter that a step drill makes in the same stroke.
    pub also: Option<Micrometres>,
    /// Whether its mill makes a flat floor: it goes down into the cone that the drill left.
    pub levels: bool,
    /// Whether its countersink goes round the edge, because none is wide enough to be sunk into it.
    pub goes_round: bool,
    /// Whether it is done on another machine.
    pub elsewhere: bool,
    /// Whether its drill is used here only because another hole has it in the magazine.
    pub borrowed: bool,
    /// Grade and roughness required of its cylinder; absent for edges and while a search tries it.
    pub required_finish: Option<(ItGrade, Roughness)>,
    /// The accuracy it leaves, by the tables.
    pub achieved: Option<Achieved>,
    /// Remarks for the reader of the plan.
    pub remarks: Vec<Remark>,
    /// Why.
    pub because: Vec<Because>,
}

/// A remark on a step for the reader of the plan.
#[derive(Clone, Debug, PartialEq)]
pub enum Remark {
    /// A step of the hole, of that diameter, is finished on another machine.
    FinishedElsewhere(ToleratedDiameter),
    /// A reamer or boring bar ends above a flat floor by that length.
    EndsAboveFloor(Micrometres),
    /// A reamer in a blind hole goes deeper than its cylinder by the lead that its stock asks, and has that room below its tip: how
    /// long its own lead is no table says.
    LeadUnknown {
        /// The lead by the stock.
        lead: Micrometres,
        /// The room below.
        room: Micrometres,
    },
    /// A reamer or core drill that is bought makes a field that begins above the nominal size, but only one for that field H.
    BoughtFor {
        /// Its size.
        nominal: Micrometres,
        /// The grade of the field H that it is for.
        it: ItGrade,
    },
    /// A table promises a finer grade than the chain of transitions reaches.
    Promised {
        /// The grade that is promised.
        it: ItGrade,
        /// The grade of the chain.
        own: ItGrade,
    },
}

impl RouteStep {
    /// How much of its cylinder it leaves unfinished above a flat floor or shoulder, where that is too much for a cylinder of that
    /// grade by the rule `unfinished-over-floor`.
    ///
    /// # Errors
    /// The knowledge base has no answer.
    pub fn leaves_unfinished(&self, it: ItGrade, shop: &Shop<'_>) -> Result<Option<Micrometres>, KnowledgeError> {
        let left = self.remarks.iter().find_map(|remark| match remark {
            Remark::EndsAboveFloor(left) => Some(*left),
            _ => None,
        });
        let Some(left) = left else { return Ok(None) };
        let shoulder = self.place.feature != Feature::Bore || self.place.step.is_some();
        let question = UnfinishedOverFloorFor { it, diameter: self.diameter, shoulder };
        let rule = shop.knowledge.ask(&question)?.need(&format!("IT {it}"))?;
        let whole = self.place.depth + left - self.place.start;
        let much = left.to_mm() > rule.share * whole.to_mm() || rule.most.is_some_and(|most| left > most);
        Ok(much.then_some(left))
    }

    /// A step with only its operation and diameters.
    pub fn plain(operation: Operation, place: StepLocation, diameter: Micrometres, from: Micrometres) -> Self {
        Self {
            operation,
            place,
            diameter,
            nominal: diameter,
            bought_for: None,
            from,
            entered: None,
            passes: 1,
            pitch: None,
            angle_millideg: None,
            entry_cylinder: None,
            also: None,
            levels: false,
            goes_round: false,
            elsewhere: false,
            borrowed: false,
            required_finish: None,
            achieved: None,
            remarks: Vec::new(),
            because: Vec::new(),
        }
    }
}
