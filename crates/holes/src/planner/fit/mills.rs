//! Mills that go down and round, and countersinks that go round an edge.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::part::Slot;
use crate::plan::{Feature, Operation};
use crate::reason::{CutterFault, Reason, Unfit};
use crate::route::RouteStep;
use crate::shop::{Shop, widest_over_hole};
use crate::tables::holes::HoleDefault;
use crate::tooling::{self, Assembly, Cutter, CutterNeed, Plunging};
use crate::units::Micrometres;

use super::Fitting;

/// A cutter in its holder, or why none of those of its size is right.
type FoundTool<'s, 'k> = Result<Result<(Cutter<'s, 'k>, Assembly), Vec<Unfit>>, KnowledgeError>;

impl<'k> Fitting<'_, 'k> {
    /// The mill of a step: the first that is found by these wishes, in this order. One that makes a floor cuts down to its middle
    /// and leaves itself room to move; one that opens a hole enters it, or cuts its way down on the rim of it.
    pub(super) fn find_mill<'s>(
        &self,
        step: &RouteStep,
        need: &CutterNeed<'_>,
        shop: &'s Shop<'k>,
    ) -> FoundTool<'s, 'k> {
        let share = self.floor_mill_share;
        // The finishing round of a hole with a floor is that of the mill that roughed it: what is asked of that is asked here.
        let after_floor = !step.levels && step.entered == Some(step.from) && step.place.feature == Feature::Bore;
        let made = if after_floor { step.from } else { step.diameter };
        let need = &CutterNeed { clearance: if after_floor { self.floor_clearance } else { need.clearance }, ..*need };
        let room = Micrometres::from_mm_rounded((1.0 - share) * made.to_mm()).max(need.clearance);
        let any = Plunging { widest: Micrometres::ZERO, without_middle: step.diameter };
        let in_metal = Plunging { widest: Micrometres::ZERO, without_middle: Micrometres::ZERO };
        let wishes = match (step.levels || after_floor, step.from == step.diameter) {
            (true, true) => vec![
                CutterNeed { clearance: room, plunges: Some(in_metal), ..*need },
                CutterNeed { plunges: Some(in_metal), ..*need },
                CutterNeed { clearance: room, plunges: Some(any), ..*need },
                CutterNeed { plunges: Some(any), ..*need },
            ],
            (true, false) => {
                let within = CutterNeed { enters: made, clearance: room, ..*need };
                vec![
                    CutterNeed { plunges: Some(in_metal), ..within },
                    CutterNeed { clearance: need.clearance, plunges: Some(in_metal), ..within },
                    CutterNeed { plunges: Some(any), ..within },
                ]
            }
            (false, _) if step.place.feature == Feature::Bore => vec![*need],
            (false, _) => {
                let down = |share| CutterNeed { plunges: Some(self.plunging(step, share)), ..*need };
                // On a face a mill that enters the hole is small for its work.
                let face = step.place.feature == Feature::Face;
                if face { vec![down(share)] } else { vec![*need, down(share), down(1.0)] }
            }
        };
        let mut first = None;
        for wish in &wishes {
            match tooling::find_tool(wish, shop)? {
                Ok(found) => return Ok(Ok(found)),
                // On a floor the last wish is the least.
                Err(why) if step.levels || after_floor => first = Some(why),
                Err(why) => drop(first.get_or_insert(why)),
            }
        }
        Ok(Err(first.unwrap_or_default()))
    }

    /// The mill of a step of a slot: the widest that goes down into metal and leaves stock on its walls. They are finished by the one
    /// that has roughed them.
    pub(super) fn find_slot_mill<'s>(
        &self,
        step: &RouteStep,
        need: &CutterNeed<'_>,
        shop: &'s Shop<'k>,
    ) -> FoundTool<'s, 'k> {
        // What another way round takes is left beside it already.
        let leaves = step.diameter < self.hole.diameter.smallest() || step.entered.is_some();
        let clearance = if leaves { Micrometres::ZERO } else { self.floor_clearance };
        let plunges = Some(Plunging { widest: Micrometres::ZERO, without_middle: Micrometres::ZERO });
        let enters = step.entered.unwrap_or(step.diameter);
        // It makes the corners of a pocket by itself, and goes round in them where it is thinner.
        let corner = self.hole.slot_to(enters).and_then(|slot| slot.corner);
        let enters = corner.map_or(enters, |corner| enters.min(corner + corner).max(Micrometres::ZERO));
        let found = tooling::find_tool(&CutterNeed { enters, clearance, plunges, ..*need }, shop)?;
        // Of end mills nobody expects it: what keeps a slot mill out is the reason.
        let no_teeth = |why: &Unfit| matches!(why, Unfit::Cutter { fault: CutterFault::NoTeethInMiddle { .. }, .. });
        Ok(found.map_err(|mut reasons| {
            reasons.sort_by_key(no_teeth);
            reasons
        }))
    }

    /// How wide a mill may be that cuts its way down over a hole: so that its circles are not so small that its centre hardly
    /// moves, and where its teeth do not reach its middle, so that this lies over the hole.
    pub(super) fn plunging(&self, step: &RouteStep, share: f64) -> Plunging {
        let widest =
            Micrometres::from_mm_rounded(step.diameter.to_mm() * share).min(step.diameter - Micrometres::new(1));
        Plunging { widest, without_middle: widest_over_hole(step.from, self.mill_core_share) }
    }

    /// Checks that the circularity error of a milled cylinder takes no more than its share of the tolerance.
    pub(super) fn round_enough(&self, step: &RouteStep) -> Tried<()> {
        let Some(roundness) = self.shop.machine.roundness else { return Ok(()) };
        // The walls of a slot along an axis are straight by that axis alone; its round ends have no tolerance of their own.
        if self.hole.slot.is_some_and(Slot::along_axis) {
            return Ok(());
        }
        let required = match step.place.step {
            Some(number) => self.hole.steps.get(number - 1).map(|step| &step.diameter),
            None => Some(&self.hole.diameter).filter(|_| step.place.feature == Feature::Bore),
        };
        let Some(required) = required else { return Ok(()) };
        if self.hole.slot.is_none() && self.shop.aimed_by(Operation::Mill, required)? != step.diameter {
            return Ok(());
        }
        let share = self.shop.share(HoleDefault::MilledRoundnessShare)?;
        let most = Micrometres::from_mm_rounded((required.upper - required.lower).to_mm() * share);
        if roundness > most {
            return Err(Refusal::Not(Reason::MilledNotRound { roundness, most, diameter: step.diameter }));
        }
        Ok(())
    }

    /// How much wider a countersink that goes round an edge is at its face than at its front: the cone of the drawing, and
    /// beside it the room of its front.
    pub(super) fn wider_than_front(&self, step: &RouteStep) -> Micrometres {
        step.diameter - step.from + self.edge_clearance + self.edge_clearance
    }
}
