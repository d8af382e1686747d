//! The diameter before rough boring and milling.

use crate::error::{Refusal, Tried};
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::reason::Reason;
use crate::tables::holes::HoleDefault;
use crate::tables::rules::MillingFinishRoundFor;
use crate::tables::tools::{BoringStage, CutterRow};
use crate::units::Micrometres;

use super::super::RouteStep;
use super::allowance::Allowance;
use super::{BackwardStep, allowance};

impl<'a, 'k> BackwardStep<'a, 'k> {
    /// Rough boring. After a drill it begins at the largest drill that leaves the smallest allowance or more, and from which
    /// bars lead to the size; after a core drill at the smallest one from which they do; as the first transition at the
    /// existing hole; after another roughing it takes one allowance.
    pub(super) fn rough_bore(self) -> Tried<Vec<RouteStep>> {
        let Self { leaves: after, previous, bore, sizes, shop, .. } = self;
        let allowance = allowance(Operation::RoughBore, after, bore.diameter.nominal, previous, shop)?;
        let [steel, plain, all] = self.rough_bars()?;
        // Bars with a carbide shank are for what those of steel do not reach, damped ones for what those do not.
        let chain = |from| {
            let of = |bars: &[&CutterRow<'_>]| self.chain(from, bars, &allowance);
            of(&steel).or_else(|_| of(&plain)).or_else(|_| of(&all))
        };
        let largest = after - allowance.low;
        let drills = || sizes.drills.iter().rev().copied().filter(|drill| *drill <= largest);
        match previous {
            None => chain(self.start()?),
            Some(Operation::Drill | Operation::DrillOut) => {
                // The widest from which equal passes within the allowance lead to the size, where there is one.
                let whole = |drill: &Micrometres| {
                    let stock = (after - *drill).to_mm();
                    let least = libm::ceil(stock / allowance.high.to_mm().max(0.001) - 1e-9).max(1.0);
                    stock / least >= allowance.low.to_mm() - 1e-9
                };
                let widest = drills().find(whole).or_else(|| drills().next()).ok_or_else(|| {
                    let smallest = sizes.smallest_bore;
                    Refusal::Not(Reason::NoDrillBeforeBoring { diameter: after, largest, smallest })
                })?;
                // The reason of the widest drill says most: it comes nearest.
                let first = chain(widest);
                if first.is_ok() { first } else { drills().find_map(|drill| chain(drill).ok()).map_or(first, Ok) }
            }
            Some(Operation::CoreDrill) => {
                // Where a bar can begin at a drill, nothing is needed between them.
                let Some(drill) = drills().next() else { return chain(after - allowance.aim) };
                let Err(why) = chain(drill) else {
                    return Err(Refusal::Not(Reason::BoredByAnother { operation: Operation::CoreDrill }));
                };
                let core_drills = shop.shelf.cutters_for(Operation::CoreDrill)?;
                let mut wider: Vec<Micrometres> = core_drills.iter().filter_map(|cutter| cutter.diameter).collect();
                wider.retain(|size| *size > drill && *size <= largest);
                wider.sort_unstable();
                wider.into_iter().find_map(|size| chain(size).ok()).ok_or(why)
            }
            Some(_) => chain(after - allowance.aim),
        }
    }

    /// The bars for roughing that reach the end of the cylinder and are not longer than the machine bears: those of steel, those
    /// without a damper and all; all of them where none does, so that the one that comes nearest tells by how much.
    fn rough_bars(self) -> Tried<[Vec<&'a CutterRow<'k>>; 3]> {
        let mut bars = self.shop.shelf.cutters_for(Operation::RoughBore)?;
        bars.retain(|bar| bar.stage == Some(BoringStage::Rough));
        let needed = self.bore.place.depth + self.sizes.overruns[usize::from(self.bore.place.through)];
        let longest = self.shop.machine.overhang_max;
        let borne = |bar: &CutterRow<'_>| bar.length.is_none_or(|length| length <= longest);
        let reaches = |bar: &&CutterRow<'_>| borne(bar) && bar.reach.is_some_and(|reach| reach >= needed);
        let able: Vec<&'a CutterRow<'k>> = bars.iter().copied().filter(reaches).collect();
        let all = if able.is_empty() { bars } else { able };
        let without = |of: fn(&CutterRow<'k>) -> Option<bool>| {
            all.iter().copied().filter(move |bar| of(bar) != Some(true)).collect::<Vec<_>>()
        };
        let steel = without(|bar| bar.carbide_bar);
        let plain = without(|bar| bar.damped_bar);
        Ok([steel, plain, all])
    }

    /// The steps of rough boring from a hole of that diameter, one for each bar: where the bar for the final size does not
    /// enter or is not set so narrow, thinner ones widen the hole first. A step has as many equal passes as the largest
    /// allowance requires; where the first of them were below the range of the bar, it is a step of its own.
    fn chain(self, from: Micrometres, bars: &[&CutterRow<'_>], allowance: &Allowance<'_>) -> Tried<Vec<RouteStep>> {
        let (after, most) = (self.leaves, allowance.high.max(Micrometres::new(1)));
        let mut from = from;
        let mut chain = Vec::new();
        while from < after {
            let enters = |bar: &&&CutterRow<'_>| bar.bar_diameter.is_some_and(|bar| bar < from);
            let ranges = bars.iter().filter(enters).filter_map(|bar| bar.diameter_min.zip(bar.diameter_max));
            let begins = |range: &(Micrometres, Micrometres)| range.0 <= (from + most).min(after) && range.1 > from;
            let Some((least, widest)) = ranges.filter(begins).max_by_key(|range| range.1) else {
                return Err(Refusal::Not(Reason::NoBarEnters { hole: from, diameter: after, most }));
            };
            let mut to = widest.min(after);
            let passes_to = |to: Micrometres| {
                let (stock, most) = ((to - from).micrometres(), most.micrometres());
                u32::try_from((stock + most - 1) / most).unwrap_or(u32::MAX)
            };
            let mut passes = passes_to(to);
            if from + (to - from).ratio(1, i64::from(passes.max(1))) < least {
                (to, passes) = (from + most, 1);
            }
            let note = Note::new("rough-boring")
                .with("low", allowance.low)
                .with("high", allowance.high)
                .with("stock", to - from)
                .with("passes", passes);
            let because = vec![Because::row(allowance.row, note)];
            let step = RouteStep::plain(Operation::RoughBore, self.bore.place, to, from);
            chain.push(RouteStep { passes, because, ..step });
            from = to;
        }
        Ok(chain)
    }

    /// Milling of the contour: after a drill, from the largest one that leaves the mill some stock; as the first
    /// transition, from the existing hole. A cylinder that ends with it is roughed first, and finished by a round of its own
    /// where the rule `milling-finish-round` asks for one: the feed of that round would make all others slow. On a flat floor
    /// it makes that, too.
    pub(super) fn mill(self) -> Tried<Vec<RouteStep>> {
        let from = if self.after_drill() { self.drill_to_open()? } else { self.start()? };
        let last =
            self.leaves == self.sizes.last_size(Operation::Mill, self.bore, self.shop)? && self.bore.thread.is_none();
        let (it, roughness) = (self.bore.diameter.it, self.bore.roughness);
        let round = self.shop.knowledge.ask(&MillingFinishRoundFor { it, roughness })?.need(&format!("IT {it}"))?;
        let roughed = self.leaves - round.stock - round.stock;
        let rough = Self { leaves: roughed, ..self };
        let least = self.shop.convention(HoleDefault::LeastStockMill)?;
        let levels = self.sizes.level_floor && self.bore.has_floor();
        if !last || round.stock == Micrometres::ZERO || roughed - from < least {
            return Ok(vec![RouteStep { levels, ..self.step(from) }]);
        }
        let note = Note::new("milling-finish-round").with("stock", round.stock);
        let because = vec![Because::row(round.row, note)];
        let rough = RouteStep { levels, ..rough.step(from) };
        // Over a floor it is the mill that went down there; elsewhere one that entered the hole.
        let entered = if levels { roughed } else { from };
        Ok(vec![rough, RouteStep { because, entered: Some(entered), ..self.step(roughed) }])
    }
}
