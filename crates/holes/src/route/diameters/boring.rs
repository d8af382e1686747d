//! The diameter before rough boring and milling.

use crate::error::{Refusal, Tried};
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::reason::Reason;
use crate::tables::tools::{BoringStage, CutterRow};

use super::super::RouteStep;
use super::{BackwardStep, allowance};

impl BackwardStep<'_, '_> {
    /// Rough boring. After a drill it begins at the largest drill that leaves the smallest allowance or more; as the
    /// first transition, at the existing hole; after another roughing it takes one allowance. Where the bar for the
    /// final size cannot enter, thinner bars widen the hole first, one step each. Each step has as many equal passes
    /// as the largest allowance requires.
    pub(super) fn rough_bore(self) -> Tried<Vec<RouteStep>> {
        let Self { leaves: after, previous, bore, sizes, shop, .. } = self;
        let allowance = allowance(Operation::RoughBore, after, bore.diameter.nominal, previous, shop)?;
        let largest = after - allowance.low;
        let mut from = match previous {
            None => self.start()?,
            Some(Operation::Drill | Operation::DrillOut) => {
                sizes.drills.iter().rev().copied().find(|drill| *drill <= largest).ok_or_else(|| {
                    let smallest = sizes.smallest_bore;
                    Refusal::Not(Reason::NoDrillBeforeBoring { diameter: after, largest, smallest })
                })?
            }
            Some(_) => after - allowance.aim,
        };
        let bars = shop.shelf.cutters_for(Operation::RoughBore)?;
        let mut chain = Vec::new();
        while from < after {
            let enters = |bar: &&&CutterRow<'_>| bar.bar_diameter.is_some_and(|bar| bar < from);
            let rough = bars.iter().filter(|bar| bar.stage == Some(BoringStage::Rough)).filter(enters);
            let widest = rough.filter_map(|bar| bar.diameter_max).max().unwrap_or_default();
            if widest <= from {
                return Err(Refusal::Not(Reason::NoBarEnters { hole: from, diameter: after }));
            }
            let to = widest.min(after);
            let stock = (to - from).micrometres();
            let most = allowance.high.micrometres().max(1);
            let passes = u32::try_from((stock + most - 1) / most).unwrap_or(u32::MAX);
            let note = Note::new("rough-boring")
                .with("low", allowance.low)
                .with("high", allowance.high)
                .with("stock", to - from)
                .with("passes", passes);
            let because = vec![Because::row(allowance.row, note)];
            let step = RouteStep::plain(Operation::RoughBore, bore.place, to, from);
            chain.push(RouteStep { passes, because, ..step });
            from = to;
        }
        Ok(chain)
    }

    /// Milling of the contour: after a drill, from the largest one that leaves the mill some stock; as the first
    /// transition, from the existing hole. On a flat floor it makes that, too.
    pub(super) fn mill(self) -> Tried<RouteStep> {
        let from = if self.after_drill() { self.drill_to_open()? } else { self.start()? };
        Ok(RouteStep { levels: self.sizes.level_floor && self.bore.has_floor(), ..self.step(from) })
    }
}
