//! How deep the tools of a hole go: approach and overrun, points, leads, and what lies beyond the hole.

use crate::chip_room::{Drilling, chip_room};
use crate::error::KnowledgeError;
use crate::note::{Because, Note};
use crate::part::Face;
use crate::plan::{Feature, Operation};
use crate::route::point::cone;
use crate::route::{Remark, RouteStep, StepLocation};
use crate::tables::rules::{Lead, TwoPassDrillingFor};
use crate::units::Micrometres;

use super::{Fitted, Fitting};

impl Fitting<'_, '_> {
    pub(in crate::planner) fn travels(&self, through: bool) -> &(Micrometres, Micrometres, Because) {
        &self.travels[usize::from(through)]
    }

    /// How deep a drill of that diameter must reach in a cylinder: depth, point, overrun and room for chips together.
    pub fn drill_reach(&self, place: &StepLocation, diameter: Micrometres) -> Result<Micrometres, KnowledgeError> {
        let depth = place.depth + cone(diameter, self.drill_point) + self.travels(place.through).1;
        Ok(depth + self.chip_room(Operation::Drill, place, diameter)?)
    }

    /// The length of a drill's flutes that must stay open over the hole.
    pub(super) fn chip_room(
        &self,
        operation: Operation,
        place: &StepLocation,
        diameter: Micrometres,
    ) -> Result<Micrometres, KnowledgeError> {
        let (depth, point) = (place.depth - place.start, self.point(diameter));
        let material_group = self.shop.material.group;
        // One that is always a second drill opens the hole of the first, which the search has not put before it yet.
        let question = TwoPassDrillingFor { diameter, material_group, first_drill_in_magazine: false };
        let second =
            operation == Operation::Drill && self.shop.knowledge.ask(&question)?.need("this drill")?.passes >= 2;
        let operation = if second { Operation::DrillOut } else { operation };
        chip_room(&Drilling { operation, diameter, depth, point, material_group }, self.shop.knowledge)
    }

    /// The height of a drill's point.
    pub fn point(&self, diameter: Micrometres) -> Micrometres {
        cone(diameter, self.drill_point)
    }

    /// The depth at which a step of the main cylinder begins below wider cylinders, and the diameter of the narrowest
    /// of those.
    pub(super) fn step_above(&self, step: &RouteStep) -> Option<(Micrometres, Micrometres)> {
        let main = step.place.step.is_none() && step.place.start > Micrometres::ZERO;
        let wider = self.hole.steps.iter().filter(|step| step.face == Face::Entry).map(|step| step.diameter.nominal);
        let around = wider.chain(self.hole.counterbore.map(|counterbore| counterbore.diameter)).min()?;
        (main && step.operation == Operation::Tap).then_some((step.place.start, around))
    }

    /// How deep the wide part of a step drill goes: the counterbore or step, or the edge it chamfers.
    pub(super) fn opening_depth(&self) -> Micrometres {
        let edge = || self.edges.iter().find(|edge| edge.face == Face::Entry).map(|edge| edge.depth(Micrometres::ZERO));
        self.flat_opening_depth().or_else(edge).unwrap_or_default()
    }

    /// The depth of the counterbore or step at the entry, if there is one.
    pub(super) fn flat_opening_depth(&self) -> Option<Micrometres> {
        let step = self.hole.steps.iter().find(|step| step.face == Face::Entry);
        self.hole.counterbore.map(|counterbore| counterbore.depth).or(step.map(|step| step.depth))
    }

    /// How far the point of a tool extends beyond its full diameter.
    pub fn lead(&self, step: &RouteStep) -> Micrometres {
        match step.operation {
            Operation::Drill | Operation::DrillOut => cone(step.diameter, self.drill_point),
            Operation::CoreDrill => cone(step.diameter - step.from, self.core_drill_point),
            Operation::RoughReam | Operation::FinishReam => self.reamer_lead(step.diameter - step.from),
            // The thread is full only behind the tap's lead.
            Operation::Tap => Micrometres::from_mm_rounded(step.pitch.unwrap_or_default().to_mm() * self.tap_lead.0),
            _ => Micrometres::ZERO,
        }
    }

    /// The lead of a reamer that removes this stock on diameter: the length that its angle gives for the stock on one
    /// side, and a little more.
    fn reamer_lead(&self, stock: Micrometres) -> Micrometres {
        let angle: f64 = match self.lead {
            Lead::Deg5 => 5.0,
            Lead::Deg15 => 15.0,
        };
        let one_side = stock.to_mm() / 2.0;
        Micrometres::from_mm_rounded(self.reamer_lead_share * one_side / libm::tan(angle.to_radians()))
    }

    /// Makes room below a blind hole for the leads of its reamers and for chips: the steps before them go deeper by that length.
    /// Chips have no more room than half of what the part has below. Over a flat floor there is no room: the reamers end above it, and boring bars, too.
    pub fn room_for_leads(&self, steps: &mut [RouteStep], flat: bool) {
        let reams = |step: &RouteStep| step.operation.is_reaming() && !step.place.through && !step.elsewhere;
        let room = steps.iter().filter(|step| reams(step)).map(|step| self.lead(step)).max();
        if flat {
            self.stop_above_floor(steps, |operation| operation.is_reaming() || operation.is_boring());
            return;
        }
        let (Some(first), Some(room)) = (steps.iter().position(reams), room) else { return };
        let before = |step: &&RouteStep| step.operation != Operation::CentreDrill;
        let deepest = steps[..first].iter().filter(before).map(|step| step.place.depth + room + self.lead(step)).max();
        let below = self.thickness - deepest.unwrap_or(self.thickness);
        let chips = self.reamer_chip_room.min(below.half()).max(Micrometres::ZERO);
        for step in steps[..first].iter_mut().filter(|step| step.operation != Operation::CentreDrill) {
            step.place.depth = step.place.depth + room + chips;
        }
        if let Some(last) = steps.iter_mut().rfind(|step| reams(step)) {
            let lead = self.lead(last);
            last.remarks.push(Remark::LeadUnknown { lead, room: room + chips - lead });
        }
    }

    /// A drill that opens a blind hole finds the hole of the one before under its whole point: that one goes as deep with its
    /// own, so that no core of solid metal is left to the feed of drilling out. Its cone then ends in that of the wider one.
    pub fn pilots_to_the_point(&self, steps: &mut [RouteStep]) {
        for at in 1..steps.len() {
            let [.., first, second] = &mut steps[..=at] else { continue };
            let opens = (first.operation, second.operation) == (Operation::Drill, Operation::DrillOut);
            if opens && !second.place.through {
                let point = second.place.depth + self.lead(second);
                first.place.depth = first.place.depth.max(point - self.lead(first));
            }
        }
    }

    /// Ends core drills, reamers and boring bars above a flat floor or shoulder that is cut already: they would meet it with
    /// nothing left to cut. A core drill leaves a ring of its lead, and no reamer goes below what is open. What stands is told of
    /// the last transition.
    pub fn stop_above_floor(&self, steps: &mut [RouteStep], stops: impl Fn(Operation) -> bool) {
        let stops = |step: &RouteStep| stops(step.operation) && !step.place.through && !step.elsewhere;
        let lead = steps.iter().filter(|step| step.operation.is_reaming()).map(|step| self.lead(step)).max();
        let (mut open, mut last) = (None, None);
        for step in steps.iter_mut().filter(|step| stops(step)) {
            let floor = step.place.depth;
            let deepest = open.unwrap_or(floor - self.flat_floor_gap);
            let lead = if step.operation.is_reaming() { lead.unwrap_or_default() } else { self.lead(step) };
            step.place.depth = (deepest - lead).max(Micrometres::new(1));
            if step.operation == Operation::CoreDrill {
                open = Some(step.place.depth);
            }
            let short = floor - step.place.depth;
            last = Some((step, short));
        }
        if let Some((step, short)) = last {
            step.remarks.push(Remark::EndsAboveFloor(short));
        }
    }

    /// Working travel of one pass, and how far the cutter must reach below its face.
    pub(super) fn travel(&self, step: &RouteStep) -> (Micrometres, Micrometres) {
        let lead = self.lead(step);
        let (approach, overrun, _) = self.travels(step.place.through);
        let reach = step.place.depth + lead + *overrun;
        (*approach + reach - step.place.start, reach)
    }

    /// What the tools cut beyond the hole: the point of a drill in the floor of a blind hole, a spot deeper than the
    /// hole.
    pub fn cut_beyond_hole(&self, fitted: &[Fitted], thickness: Micrometres) -> Vec<Note> {
        let mut notes = Vec::new();
        for one in fitted {
            let step = &one.step;
            let main = step.place.feature == Feature::Bore;
            let (depth, limit, code) = match step.operation {
                Operation::Drill | Operation::DrillOut if main && !step.place.through => {
                    (step.place.depth + self.point(step.diameter), thickness, "point-breaks-through")
                }
                Operation::CentreDrill => (step.diameter.half(), self.hole.depth, "spot-too-deep"),
                Operation::Countersink | Operation::Chamfer => {
                    let end = step.place.start + one.travel - one.approach;
                    let front = one.tool.as_ref().and_then(|tool| tool.front);
                    let Some(floor) = self.floor_below(step, front) else { continue };
                    // It may touch the floor, as a mill does.
                    (end - Micrometres::new(1), floor, "countersink-too-deep")
                }
                _ => continue,
            };
            if depth >= limit {
                notes.push(Note::new(code).with("depth", depth).with("limit", limit).with("diameter", step.diameter));
            }
        }
        notes
    }

    /// The depth of what stands in the way of a countersink's front below its cone: a narrower cylinder under an opening, or
    /// the floor of a blind hole.
    fn floor_below(&self, step: &RouteStep, front: Option<Micrometres>) -> Option<Micrometres> {
        let narrow = self.hole.diameter.nominal < front.unwrap_or(step.from).min(step.from);
        match self.flat_opening_depth().filter(|_| narrow && step.place.face == Face::Entry) {
            Some(opening) => Some(opening),
            None => (!self.hole.through).then_some(self.hole.depth),
        }
    }

    /// How far the flat front of a countersink stands beyond the drawn cone, in the hole below it.
    pub(super) fn beyond_cone(&self, step: &RouteStep, front: Option<Micrometres>) -> Micrometres {
        let (Some(angle), Some(front)) = (step.angle_millideg, front) else { return Micrometres::ZERO };
        let slope = libm::tan((f64::from(angle) / 2000.0).to_radians());
        let half =
            if step.goes_round { self.edge_clearance.to_mm() } else { (step.from - front).to_mm().max(0.0) / 2.0 };
        Micrometres::from_mm_rounded(half / slope)
    }
}
