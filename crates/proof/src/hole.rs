//! The state of a hole between transitions: its largest diameter, the offset of its axis, its depth.

use std::collections::BTreeMap;

use crate::error::KnowledgeError;
use crate::part::{BlankHole, CentreTolerance, Hole, Part, ThreadKind, tolerance_width};
use crate::plan::{Feature, Operation, Transition};
use crate::shop::Shop;
use crate::tables::practice::{ProofLimit, StockBeforeReamingFor};
use crate::tables::rules::{MadeBy, ReamingCase};
use crate::tapping::minor_diameter;
use crate::units::Micrometres;

use super::cylinder::{CylinderId, CylinderRequirements};
use super::reach::{Both, MethodKey, Reach, drift, oversize};
use super::{Fault, Shortfall, core, loads, middle, shoulder, tool};

/// The current state of a cylinder.
#[derive(Clone, Copy, Debug)]
struct State {
    made_by: MadeBy,
    /// Its largest possible diameter.
    largest: Micrometres,
    /// The possible offset of its axis from the programmed position.
    axis: Option<Both<Micrometres>>,
    /// How far its axis may lie aside of the next tool's; of a cast hole how far its core may be shifted.
    aside: Option<Micrometres>,
    /// The further drift of the axis, at its end.
    drift: Micrometres,
    /// Whether the spindle guided its tool, as in boring.
    led: bool,
    /// Where its full diameter ends.
    depth: Micrometres,
}

/// All faults in the transitions of a hole.
///
/// # Errors
/// The knowledge base has no answer.
pub fn prove_hole(
    hole: &Hole,
    transitions: &[Transition],
    part: &Part,
    shop: &Shop<'_>,
) -> Result<Vec<Fault>, KnowledgeError> {
    let mut walk = Walk { hole, transitions, part, shop, states: BTreeMap::new(), centred: false, faults: Vec::new() };
    if let Some(diameter) = hole.state.diameter() {
        let (made_by, aside) = match hole.state {
            BlankHole::Cast(_) => {
                let shift = tool::limit(ProofLimit::CoreShift, shop)?;
                (MadeBy::BlankHole, Some(Micrometres::from_mm_rounded(shift)))
            }
            _ => (MadeBy::PreMachined, None),
        };
        walk.states.insert(
            CylinderId::Main,
            State {
                made_by,
                largest: diameter,
                axis: None,
                aside,
                drift: Micrometres::ZERO,
                led: false,
                depth: part.blank.thickness,
            },
        );
    }
    for (at, transition) in transitions.iter().enumerate() {
        walk.step(at, transition)?;
    }
    walk.faults.extend(tool::hard(transitions, shop)?);
    Ok(walk.faults)
}

/// Whether a transition only levels a floor.
fn levels(transition: &Transition) -> bool {
    transition.operation == Operation::Mill && transition.from_diameter_mm == transition.diameter_mm
}

struct Walk<'a, 'k> {
    hole: &'a Hole,
    transitions: &'a [Transition],
    part: &'a Part,
    shop: &'a Shop<'k>,
    states: BTreeMap<CylinderId, State>,
    centred: bool,
    faults: Vec<Fault>,
}

impl Walk<'_, '_> {
    fn step(&mut self, at: usize, transition: &Transition) -> Result<(), KnowledgeError> {
        if !transition.elsewhere {
            self.faults.extend(loads::faults(transition, self.shop)?);
            self.faults.extend(tool::faults(transition, self.shop)?);
            self.faults.extend(shoulder::gouged(transition, self.hole, self.shop)?);
            let opened = self.states.get(&CylinderId::Main).map_or(Micrometres::ZERO, |state| state.depth);
            self.faults.extend(middle::in_metal(transition, self.hole, opened, self.shop)?);
            if !self.hole.through {
                self.faults.extend(core::left_solid(transition, &self.transitions[..at], self.shop)?);
            }
        }
        if transition.operation == Operation::CentreDrill {
            self.centred = true;
            self.spot(transition);
            return Ok(());
        }
        let Some(place) = CylinderId::of(transition) else { return Ok(()) };
        let Some(mut required) = CylinderRequirements::of(place, self.hole, self.part, self.position()) else {
            return Ok(());
        };
        // A free floor may be flat: the drill then stops above it, and a mill opens the rest.
        required.flat |= self.transitions.iter().any(|step| CylinderId::of(step) == Some(place) && levels(step));
        // A step begins with the state of the cylinder that it widens.
        let before = self.states.get(&place).or_else(|| self.states.get(&CylinderId::Main)).copied();
        self.enters(transition, &required);
        self.depths(transition, &required, before)?;
        if transition.operation == Operation::Tap {
            return Ok(());
        }
        let last = !self.transitions[at + 1..]
            .iter()
            .filter(|next| CylinderId::of(next) == Some(place) && next.operation != Operation::Tap)
            .any(|next| next.from_diameter_mm != next.diameter_mm);
        if levels(transition) {
            return self.wall_over_floor(transition, place, &required, last);
        }
        let method = MethodKey {
            operation: transition.operation,
            centred: self.centred,
            made_by: before.map_or(MadeBy::Solid, |before| before.made_by),
            last,
        };
        // What another machine reaches is its own matter, but it must find stock, on the axis that the hole has.
        if transition.operation.is_only_elsewhere() {
            if let Some(before) = before {
                self.stock(transition, &required, before, None, last);
            }
            return Ok(());
        }
        let Some(mut reach) = Reach::of(method, transition.diameter_mm, self.shop)? else { return Ok(()) };
        // The second drill is as accurate as the first, on its axis.
        reach.own_axis = reach.own_axis.filter(|_| transition.operation != Operation::DrillOut);
        if let Some(before) = before {
            self.stock(transition, &required, before, reach.own_axis, last);
            self.check_largest_stock(transition, before)?;
            self.under_skin(transition, before)?;
        }
        let width = reach.width(transition.diameter_mm, self.shop).unwrap_or_default();
        let state = self.left(transition, before, reach, width)?;
        if last && !transition.elsewhere {
            self.finished(transition, &required, reach, state, width)?;
            self.springs(transition, &required, before)?;
        }
        self.states.insert(place, state);
        Ok(())
    }

    /// An end mill that only levels a floor leaves the cylinder as it is down to where the tools before it ended. Below that it
    /// makes the wall itself: after a drill it takes the rest of its cone away; after other tools, which ended above that cone,
    /// it has the wall of the drill to widen, too, and does so in one cut without a finishing round.
    fn wall_over_floor(
        &mut self,
        transition: &Transition,
        place: CylinderId,
        required: &CylinderRequirements<'_>,
        last: bool,
    ) -> Result<(), KnowledgeError> {
        let Some(mut state) = self.states.get(&place).copied() else { return Ok(()) };
        if transition.depth_mm <= state.depth {
            return Ok(());
        }
        state.depth = transition.depth_mm;
        let method = MethodKey {
            operation: transition.operation,
            centred: self.centred,
            made_by: state.made_by,
            last: state.made_by == MadeBy::Drill,
        };
        if let Some(reach) = Reach::of(method, transition.diameter_mm, self.shop)? {
            let width = reach.width(transition.diameter_mm, self.shop).unwrap_or_default();
            state.largest = state.largest.max(transition.diameter_mm + width);
            if last && !transition.elsewhere {
                self.finished(transition, required, reach, State { axis: None, ..state }, width)?;
            }
        }
        self.states.insert(place, state);
        Ok(())
    }

    /// The permitted position error of the axis, where the drawing gives it as a width.
    fn position(&self) -> Option<Micrometres> {
        match self.hole.centre_tolerance {
            CentreTolerance::Width(width) => Some(width),
            CentreTolerance::Grade { it: grade } => {
                let distance = self.hole.smallest_centre_distance()?;
                tolerance_width(grade, distance, self.shop.knowledge).ok()
            }
        }
    }

    /// The spot of a centring drill must be removed by the hole, or be the edge of the drawing.
    fn spot(&mut self, transition: &Transition) {
        let hole = self.hole;
        let chamfer = hole.chamfer.map(|chamfer| hole.diameter.nominal + chamfer + chamfer);
        let thread = hole.thread.as_ref().map(|thread| thread.size + thread.pitch + thread.pitch);
        let cone = hole.cone.as_ref().map(|_| transition.diameter_mm);
        let edges = [
            chamfer,
            thread,
            cone,
            hole.countersink.as_ref().map(|countersink| countersink.diameter),
            hole.counterbore.as_ref().map(|counterbore| counterbore.diameter),
            hole.face,
            hole.steps.iter().map(|step| step.diameter.nominal).max(),
        ];
        let limit = edges.into_iter().flatten().max().unwrap_or_default().max(hole.diameter.largest());
        if transition.diameter_mm > limit {
            self.faults.push(Fault::SpotStays { spot: transition.diameter_mm, limit });
        }
    }

    /// No tool wider than the finished cylinder may enter it.
    fn enters(&mut self, transition: &Transition, required: &CylinderRequirements<'_>) {
        let limit = match (transition.feature, required.thread) {
            (Feature::Thread, Some(thread)) => thread.size,
            _ => required.diameter.largest(),
        };
        let own = matches!(
            transition.operation,
            Operation::Drill | Operation::DrillOut | Operation::CoreDrill | Operation::Counterbore | Operation::Mill
        );
        // A core drill is ground to size; a step drill makes its opening with its wide part.
        let to_size = transition.operation == Operation::CoreDrill || transition.also_diameter_mm.is_some();
        let tool = if to_size { transition.diameter_mm } else { transition.tool.diameter_mm };
        if own && tool > limit && required.thread.is_none_or(|thread| thread.kind == ThreadKind::Cylindrical) {
            self.faults.push(Fault::Enters { operation: transition.operation, tool, limit });
        }
    }

    /// Checks depths: that of the drawing, the floor, and what was opened before.
    fn depths(
        &mut self,
        transition: &Transition,
        required: &CylinderRequirements<'_>,
        before: Option<State>,
    ) -> Result<(), KnowledgeError> {
        let (operation, tip) = (transition.operation, transition.end());
        let thickness = self.part.blank.thickness;
        let floor = thickness - tip;
        let least = Micrometres::from_mm_rounded(tool::limit(ProofLimit::LeastFloor, self.shop)?);
        if self.hole.through {
            // It has no floor.
        } else if tip >= thickness {
            self.faults.push(Fault::BreaksThrough { operation, tip, thickness });
        } else if floor < least && matches!(operation, Operation::Drill | Operation::DrillOut) {
            let thinnest = least.to_mm() * tool::limit(ProofLimit::LeastFloorShare, self.shop)?;
            let bursts = floor.to_mm() < thinnest;
            let least = if bursts { Micrometres::from_mm_rounded(thinnest) } else { least };
            self.faults.push(Fault::ThinFloor { operation, tip, floor, least, bursts });
        }
        let main = CylinderId::of(transition) == Some(CylinderId::Main);
        let floored = main && required.flat && !self.hole.through && !transition.elsewhere;
        if floored && (operation.is_reaming() || operation.is_boring()) && tip == required.depth {
            self.faults.push(Fault::MeetsFloor { operation, tip });
        }
        let follows = operation.is_reaming() || matches!(operation, Operation::Tap | Operation::CoreDrill);
        // A core drill cuts as far inwards as its lips go, so that it may enter the cone of the drill a little.
        let lips =
            if operation == Operation::CoreDrill { tool::limit(ProofLimit::CoreDrillLips, self.shop)? } else { 0.0 };
        let enters = Micrometres::from_mm_rounded(lips * transition.diameter_mm.to_mm());
        if let Some(before) = before.filter(|_| follows && !required.through && !self.hole.through)
            && !matches!(before.made_by, MadeBy::BlankHole | MadeBy::PreMachined)
            && tip > before.depth + enters
            && main
        {
            self.faults.push(Fault::Floor { operation, tip, opened: before.depth });
        }
        Ok(())
    }

    /// The stock in the worst case: the widest hole before, with its axis offset to one side. The first cut of a cast hole is left
    /// to the check of its blank.
    fn stock(
        &mut self,
        transition: &Transition,
        required: &CylinderRequirements<'_>,
        before: State,
        own_axis: Option<Both<Micrometres>>,
        last: bool,
    ) {
        let shift = match (own_axis, before.aside) {
            _ if before.made_by == MadeBy::BlankHole => Micrometres::ZERO,
            // The spindle returns to the same point.
            (Some(own), Some(_)) if before.led => own.best + own.best,
            (Some(own), Some(aside)) => {
                let aside = own.best + aside + before.drift;
                aside + aside
            }
            _ => Micrometres::ZERO,
        };
        let after = if transition.operation.is_only_elsewhere() {
            required.diameter.smallest()
        } else if last && !transition.elsewhere {
            required.diameter.smallest().max(transition.diameter_mm.min(required.diameter.largest()))
        } else {
            transition.diameter_mm
        };
        let least = after - before.largest - shift;
        if least <= Micrometres::ZERO {
            self.faults.push(Fault::NoStock {
                operation: transition.operation,
                before: transition.from_diameter_mm,
                may_be: before.largest,
                shift,
                least,
            });
        }
    }

    /// The first pass in a cast hole, at the place where radius and axis of the hole leave the least: it must get under
    /// the skin. Where the drawing leaves too little for any cut, the fault is that of the blank.
    fn under_skin(&mut self, transition: &Transition, before: State) -> Result<(), KnowledgeError> {
        let BlankHole::Cast(cast) = self.hole.state else { return Ok(()) };
        if before.made_by != MadeBy::BlankHole || transition.elsewhere {
            return Ok(());
        }
        let mm = |name| tool::limit(name, self.shop).map(Micrometres::from_mm_rounded);
        if (self.hole.diameter.nominal - cast).half() < mm(ProofLimit::CastHoleStock)? {
            return Ok(());
        }
        let (place, least) = (mm(ProofLimit::CastHolePlace)?, mm(ProofLimit::CastSkin)?);
        let after = match transition.conditions.rounds {
            Some(rounds) => rounds.after(1, transition.diameter_mm),
            None => {
                before.largest + (transition.diameter_mm - before.largest).ratio(1, i64::from(transition.passes.max(1)))
            }
        };
        let depth = (after - before.largest).half();
        if depth < place + least {
            self.faults.push(Fault::UnderSkin { operation: transition.operation, depth, place, least });
        }
        Ok(())
    }

    /// The largest stock: what a reamer or a finishing bar removes at once.
    fn check_largest_stock(&mut self, transition: &Transition, before: State) -> Result<(), KnowledgeError> {
        let operation = transition.operation;
        let mm = |name| tool::limit(name, self.shop).map(Micrometres::from_mm_rounded);
        let most = match operation {
            Operation::RoughReam | Operation::FinishReam => {
                let case = match (operation, before.made_by) {
                    (Operation::RoughReam, MadeBy::Drill) => ReamingCase::RoughAfterDrill,
                    (Operation::RoughReam, _) => ReamingCase::RoughAfterCoreDrill,
                    (_, MadeBy::Ream) => ReamingCase::FinishAfterRough,
                    (_, MadeBy::Drill) => ReamingCase::OneAfterDrill,
                    // The hole of the blank is given: it may leave as much as any rough reamer removes.
                    (_, MadeBy::BlankHole | MadeBy::PreMachined) => ReamingCase::RoughAfterDrill,
                    _ => ReamingCase::OneAfterCoreDrill,
                };
                let question = StockBeforeReamingFor { case, diameter: transition.diameter_mm };
                self.shop.knowledge.winner_within(&question)?.map(|row| row.stock_max)
            }
            Operation::SemiFinishBore => Some(mm(ProofLimit::SemiFinishBoreStock)?),
            Operation::FinishBore => Some(mm(ProofLimit::FinishBoreStock)?),
            _ => None,
        };
        let stock = transition.diameter_mm - transition.from_diameter_mm;
        if let Some(most) = most.filter(|most| stock > *most) {
            self.faults.push(Fault::TooMuch { operation, stock, most });
        }
        Ok(())
    }

    /// The cylinder after a transition.
    fn left(
        &self,
        transition: &Transition,
        before: Option<State>,
        reach: Reach,
        width: Micrometres,
    ) -> Result<State, KnowledgeError> {
        let drilled = transition.operation == Operation::Drill;
        let along = transition.depth_mm - transition.start_mm;
        let (axis, drift, led) = match (reach.own_axis, before) {
            (Some(own), _) if drilled => (Some(own), drift(transition.diameter_mm, along, self.shop)?, false),
            (Some(own), _) => (Some(own), Micrometres::ZERO, true),
            (None, Some(before)) => (before.axis, before.drift, before.led),
            (None, None) => (None, Micrometres::ZERO, false),
        };
        // The lead of a reamer does not widen the hole: the depth opened before stays available for the next tool.
        let opened = before.filter(|_| transition.operation.is_reaming()).map(|before| before.depth);
        let depth = opened.unwrap_or(transition.depth_mm).max(transition.depth_mm);
        let aside = match reach.own_axis {
            Some(own) => Some(own.ordinary),
            None => before.and_then(|before| before.aside),
        };
        Ok(State {
            made_by: MadeBy::of(transition.operation).or(before.map(|it| it.made_by)).unwrap_or(MadeBy::Solid),
            largest: transition.diameter_mm + if drilled { width.max(oversize(transition, self.shop)?) } else { width },
            axis,
            aside,
            drift,
            led,
            depth,
        })
    }

    /// The deflection of a boring bar goes into the hole, because stock varies from hole to hole and around it.
    fn springs(
        &mut self,
        transition: &Transition,
        required: &CylinderRequirements<'_>,
        before: Option<State>,
    ) -> Result<(), KnowledgeError> {
        let Some(before) = before else { return Ok(()) };
        let aside = before.aside.filter(|_| !before.led).map_or(Micrometres::ZERO, |aside| aside + before.drift);
        let spread = (before.largest - transition.from_diameter_mm).max(Micrometres::ZERO) + aside + aside;
        let tolerance = required.diameter.largest() - required.diameter.smallest();
        if let Some(spring) = tool::spring(transition, spread, self.shop)?.filter(|spring| *spring > tolerance) {
            self.faults.push(Fault::BarSprings { operation: transition.operation, spring, tolerance });
        }
        Ok(())
    }

    /// Compares the result of the last transition with the drawing.
    fn finished(
        &mut self,
        transition: &Transition,
        required: &CylinderRequirements<'_>,
        reach: Reach,
        state: State,
        width: Micrometres,
    ) -> Result<(), KnowledgeError> {
        let operation = transition.operation;
        if transition.depth_mm < required.depth && (!required.flat || self.hole.slot.is_some()) {
            self.faults.push(Fault::TooShallow { operation, depth: transition.depth_mm, required: required.depth });
        }
        if let Some(thread) = required.thread {
            if thread.kind == ThreadKind::Cylindrical && transition.feature != Feature::Thread {
                self.tap_hole(transition, thread.size, thread.pitch)?;
            }
            return Ok(());
        }
        let (smallest, largest) = (required.diameter.smallest(), required.diameter.largest());
        let left = transition.diameter_mm;
        if !(smallest..=largest).contains(&left) {
            self.faults.push(Fault::NotFinished { left, smallest, largest });
            return Ok(());
        }
        let mut wanting = Vec::new();
        let mut grade = true;
        if let Some(it) = reach.grade {
            let of_grade = Shortfall::Grade(it.best, it.ordinary, required.diameter.it);
            grade = of_grade.holds();
            wanting.push(of_grade);
        }
        wanting.push(Shortfall::Surface(reach.roughness.best, reach.roughness.ordinary, required.roughness));
        if let Some((axis, position)) = state.axis.zip(required.position) {
            wanting.push(Shortfall::Position(axis.best, axis.ordinary, position));
        }
        let wanting = wanting.into_iter().filter(|shortfall| !shortfall.holds());
        self.faults.extend(wanting.map(|shortfall| Fault::Wanting { operation, shortfall }));
        // The size of these tools does not follow the tolerance field.
        let fixed = matches!(operation, Operation::Drill | Operation::DrillOut | Operation::Counterbore);
        let may_be = left + width;
        if fixed && grade && may_be > largest {
            self.faults.push(Fault::TooWide { operation, diameter: left, may_be, limit: largest });
        }
        Ok(())
    }

    /// The hole under a thread: inside the limits of the minor diameter of an internal thread 6H. That the hole is wider than its
    /// drill is left out: the drills of ГОСТ 19257 leave room for it.
    fn tap_hole(
        &mut self,
        transition: &Transition,
        size: Micrometres,
        pitch: Micrometres,
    ) -> Result<(), KnowledgeError> {
        let (smallest, largest) = minor_diameter(size, pitch, self.shop.knowledge)?;
        let diameter = transition.diameter_mm;
        if diameter < smallest || diameter > largest {
            self.faults.push(Fault::TapHole { diameter, smallest, largest });
        }
        Ok(())
    }
}
