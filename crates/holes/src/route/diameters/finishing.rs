//! The diameter before a transition that removes an allowance of section 1.2.1.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::note::{Because, Figure, Note};
use crate::part::tolerance_width;
use crate::plan::Operation;
use crate::reason::Reason;
use crate::tables::holes::HoleDefault;
use crate::units::Micrometres;

use super::super::{Remark, RouteStep, accuracy, handbook, openings};
use super::allowance::Allowance;
use super::{BackwardStep, allowance};

impl BackwardStep<'_, '_> {
    /// A transition that removes an allowance. The diameter before it is that of the handbook where the range of
    /// section 1.2.1 permits it, otherwise the aim of the range; where a drill makes it, the nearest drill.
    pub(super) fn finishing(self) -> Tried<RouteStep> {
        let Self { operation, leaves: after, previous, bore, sizes, shop } = self;
        // A core drill far below the size only opens the hole for a bar: it is one of its own size.
        let opens = operation == Operation::CoreDrill && bore.diameter.nominal - after > shop.grind_limit(after)?;
        let of_size = if opens { after } else { bore.diameter.nominal };
        let allowance = allowance(operation, after, of_size, previous, shop)?;
        let (smallest, largest) = (after - allowance.high, after - allowance.low);
        let handbook_row = handbook::row(bore, shop)?;
        // The handbook's are for fields H, which begin at the nominal size.
        let aimed = shop.aimed(&bore.diameter)?;
        let lower = (bore.diameter.nominal - aimed).max(Micrometres::ZERO);
        let advised = handbook_row.as_ref().and_then(|row| handbook::diameter_before(row, operation, previous));
        let exact = self.shared_by_two_reamers(&allowance)?.or(advised.map(|size| size - lower));
        let aim = exact.unwrap_or(after - allowance.aim).max(smallest).min(largest);
        // At the coarse limit, the rough transition must still leave a narrower hole than this transition.
        let drilled = accuracy::drilled(shop)?;
        let leaves_stock =
            |size: Micrometres| tolerance_width(drilled, size, shop.knowledge).is_ok_and(|width| size + width < after);
        let before = if previous.is_none() {
            let start = self.start()?;
            if start < smallest || start > largest {
                let (stock, low, high) = (after - start, allowance.low, allowance.high);
                return Err(Refusal::Not(Reason::StockOutsideAllowance {
                    operation,
                    stock,
                    low,
                    high,
                    diameter: after,
                }));
            }
            start
        } else if self.after_drill() {
            let inside = |drill: &Micrometres| *drill >= smallest && *drill <= largest && leaves_stock(*drill);
            let drills = sizes.drills.iter().copied().filter(inside);
            let nearest = drills.min_by_key(|drill| ((*drill - aim).abs(), *drill));
            nearest.ok_or_else(|| {
                let (low, high) = (smallest, largest);
                Refusal::Not(Reason::NoDrillInAllowance { operation, low, high, diameter: after })
            })?
        } else if previous == Some(Operation::Counterbore) {
            let inside = |size: &Micrometres| *size >= smallest && *size <= largest && leaves_stock(*size);
            let sizes = openings::counterbores(after, shop)?;
            let nearest = sizes.into_iter().filter(inside).min_by_key(|size| ((*size - aim).abs(), *size));
            nearest.ok_or_else(|| {
                let (low, high) = (smallest, largest);
                Refusal::Not(Reason::NoCounterboreInAllowance { operation, low, high, diameter: after })
            })?
        } else if exact == Some(aim) {
            aim
        } else {
            // Rounded to the setting step, but within the range; a rough cylinder is so much narrower that it leaves
            // stock.
            let step = shop.convention(HoleDefault::SettingStep)?.micrometres().max(1);
            let set = Micrometres::new((aim.micrometres() + step / 2).div_euclid(step) * step);
            let set = set.max(smallest).min(largest);
            let rough = matches!(previous, Some(Operation::Mill | Operation::RoughBore));
            let mut sizes = (0..)
                .map(|back| Micrometres::new(set.micrometres() - back * step))
                .take_while(|size| rough && *size >= smallest);
            sizes.find(|size| leaves_stock(*size)).unwrap_or(set)
        };
        let note = Note::new("allowance")
            .with("operation", Figure::operation(operation.name()))
            .with("low", allowance.low)
            .with("high", allowance.high)
            .with("taken", after - before);
        let mut because = vec![Because::row(allowance.row, note)];
        because.extend(allowance.stock);
        if let (Some(row), Some(advised)) = (handbook_row, advised) {
            let code = if advised == before {
                "handbook-step"
            } else if advised == before + lower {
                "handbook-step-lower"
            } else {
                "handbook-step-outside"
            };
            let note = Note::new(code).with("advised", advised).with("taken", before);
            because.push(Because::row(row.row, note.with("low", smallest).with("high", largest)));
        }
        // A smaller reamer or core drill is a catalog tool of the nominal size, ground down.
        let fixed = operation.is_reaming() || operation == Operation::CoreDrill;
        // Where the hole lies above what a bought one of its size makes, the next larger one is ground down.
        let last = after == aimed;
        let bought_for = if fixed && last { shop.bought_for(&bore.diameter)? } else { None };
        let bought = bought_for.is_some() || (!last && after <= bore.diameter.nominal);
        // One of the same size is ground, too, where a new one is too wide: it is asked for by less than its size.
        let below =
            if fixed && !bought && after == bore.diameter.nominal { Micrometres::new(1) } else { Micrometres::ZERO };
        let nominal = if fixed && bought { of_size } else { after - below };
        if fixed && after != nominal {
            let note = Note::new("ground-to-size").with("nominal", nominal).with("size", after);
            because.push(Because::row(allowance.row, note));
        }
        // Beside a field H, one of another field needs to be told which one is meant.
        let above = bore.diameter.lower > Micrometres::ZERO;
        let remarks = bought_for.filter(|_| above).map(|it| Remark::BoughtFor { nominal, it }).into_iter().collect();
        // Core drills are bought by their number, not for a field H.
        let bought_for = bought_for.filter(|_| operation.is_reaming());
        Ok(RouteStep { nominal, bought_for, because, remarks, ..self.step(before) })
    }

    /// What the rough reamer leaves where the hole of the blank has little stock for both: the finish one then takes less.
    fn shared_by_two_reamers(self, finish: &Allowance<'_>) -> Result<Option<Micrometres>, KnowledgeError> {
        let Self { leaves: after, previous, bore, sizes, shop, .. } = self;
        let (Some(start), Some(Operation::RoughReam)) = (sizes.start, previous) else { return Ok(None) };
        let rough = allowance(Operation::RoughReam, after, bore.diameter.nominal, None, shop)?;
        let before = start + rough.low;
        Ok((start < after - finish.low && before > after - finish.aim).then_some(before))
    }
}
