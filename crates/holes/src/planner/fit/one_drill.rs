//! Compares two-pass drilling with a single drill: the time that the second drill costs, and the thrust that it
//! saves.

use crate::cutting;
use crate::error::KnowledgeError;
use crate::knowledge::vocabulary::ToolMaterial;
use crate::note::{Because, Figure, Note};
use crate::plan::{Feature, Operation};
use crate::route::{RouteStep, StepLocation};
use crate::tables::rules::TwoPassDrilling;
use crate::units::{ItGrade, Micrometres, Minutes, Newtons, round_to};

use super::{Fitted, Fitting};

/// Time and thrust of a single drill of full size.
#[derive(Clone, Copy, Debug)]
pub(super) struct SingleDrill {
    time: Minutes,
    thrust: Option<Newtons>,
}

/// The key of a single drill: the place of the step, its diameters, its passes, the required grade, and the next
/// transition.
pub(super) type SingleKey = (StepLocation, Micrometres, Option<Micrometres>, u32, Option<ItGrade>, Option<Operation>);

impl Fitting<'_, '_> {
    /// Reports what the second drill costs in time and saves in thrust, compared with one drill of full size.
    pub fn compare_with_one_drill(&self, fitted: &mut [Fitted]) -> Result<(), KnowledgeError> {
        let Some(second) = fitted
            .iter()
            .position(|one| one.step.operation == Operation::DrillOut && one.step.place.feature == Feature::Bore)
        else {
            return Ok(());
        };
        let follows = fitted.get(second + 1).map(|one| one.step.operation);
        let Some(single) = self.single_drill(&fitted[second].step, follows) else { return Ok(()) };
        let pair = &fitted[second.saturating_sub(1)..=second];
        let time: f64 = pair.iter().map(|step| step.conditions.machine_time_min.0).sum();
        let thrust = pair
            .iter()
            .filter_map(|step| step.conditions.axial_force_n)
            .fold(0.0, |most: f64, force| most.max(force.0));
        let table = self.shop.knowledge.table_of::<TwoPassDrilling<'_>>()?;
        let note = Note::new("two-passes-cost")
            .with("time", Figure::number(format!("{:+.3}", time - single.time.0)))
            .with("thrust", round_to(thrust, 0))
            .with("one-thrust", single.thrust.map_or_else(|| "-".to_owned(), |force| round_to(force.0, 0).to_string()));
        fitted[second].because.push(Because::table(table, note));
        Ok(())
    }

    /// The result of drilling the second drill's diameter in one pass; none where there are no conditions.
    fn single_drill(&self, second: &RouteStep, follows: Option<Operation>) -> Option<SingleDrill> {
        let it = second.required_finish.map(|(grade, _)| grade);
        let key = (second.place, second.diameter, second.also, second.passes, it, follows);
        if let Some(known) = self.single_drills.borrow().get(&key) {
            return *known;
        }
        let single =
            RouteStep { operation: Operation::Drill, from: Micrometres::ZERO, because: Vec::new(), ..second.clone() };
        let (travel, _) = self.travel(&single);
        let cut = self.cut(&single, follows, ToolMaterial::HighSpeedSteel, travel);
        let found = cutting::conditions(&cut, self.shop).ok();
        let found = found.map(|found| SingleDrill { time: found.machine_time_min, thrust: found.axial_force_n });
        self.single_drills.borrow_mut().insert(key, found);
        found
    }
}
