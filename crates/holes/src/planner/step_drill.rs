//! One step drill for a hole and its opening, where that is permitted.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::part::Face;
use crate::plan::{Feature, Operation};
use crate::reason::Reason;
use crate::route::bores::Bore;
use crate::route::{Candidate, RouteStep};
use crate::units::Micrometres;

use super::whole::Finder;

impl Finder<'_, '_> {
    /// Whether a step drill may make the hole and its opening at once: for a through hole that is only drilled, with
    /// one flat opening whose grade drilling holds, or with a chamfer.
    pub fn may_join(&self, candidate: &Candidate) -> bool {
        let cuts = |operation: &&Operation| !matches!(operation, Operation::CentreDrill | Operation::Tap);
        let chamfered =
            self.task.wider.is_empty() && self.task.edges.iter().any(|edge| edge.feature == Feature::Chamfer);
        self.task.main.place.through
            && (self.drilled_opening().is_some() || chamfered)
            && candidate.transitions.iter().filter(cuts).eq([&Operation::Drill])
    }

    /// The one wider cylinder of a hole, where a step drill's flat step holds its grade.
    pub fn drilled_opening(&self) -> Option<&Bore> {
        let [bore] = self.task.wider.as_slice() else { return None };
        let drilled = bore.diameter.it >= self.drilled && bore.thread.is_none();
        (bore.place.face == Face::Entry && bore.flat && drilled).then_some(bore)
    }

    /// Makes the drill a step drill that makes the opening too; returns the steps with it, or why there is no such
    /// drill.
    pub fn join(&self, steps: &mut [RouteStep], centring_makes_edge: bool) -> Tried<Option<Feature>> {
        let Some(drill) = steps.iter_mut().find(|step| step.operation == Operation::Drill) else {
            return Err(Refusal::Not(Reason::NothingToStep));
        };
        let (feature, wide) = match self.drilled_opening() {
            Some(bore) => (bore.place.feature, Some(bore.diameter.nominal)),
            None if centring_makes_edge => return Err(Refusal::Not(Reason::ChamferedByCentring)),
            None => {
                let chamfer = self.task.edges.iter().find(|edge| edge.feature == Feature::Chamfer);
                let chamfer = chamfer.map(|edge| edge.diameter).unwrap_or_default();
                (Feature::Chamfer, self.chamfering_drill(drill.diameter, chamfer)?)
            }
        };
        if wide.is_none() {
            let (narrow, wide) = (drill.diameter, Micrometres::ZERO);
            return Err(Refusal::Not(Reason::NoStepDrill { narrow, wide }));
        }
        drill.also = wide;
        Ok(Some(feature))
    }

    /// The wide diameter of a step drill that makes the chamfer too.
    fn chamfering_drill(
        &self,
        drill: Micrometres,
        chamfer: Micrometres,
    ) -> Result<Option<Micrometres>, KnowledgeError> {
        let drills = self.shop.shelf.cutters_for(Operation::Chamfer)?;
        let of_size = drills.iter().filter(|row| row.diameter == Some(drill));
        Ok(of_size.filter_map(|row| row.step_diameter).find(|wide| *wide >= chamfer))
    }
}
