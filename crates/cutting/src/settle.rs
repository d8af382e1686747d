//! Finds feed and speed together: a feed reduced by a load gets the matching speed.

use crate::error::Tried;
use crate::note::{Because, Note};
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::tables::rules::FeedChoice;
use crate::units::{MetresPerMinute, MillimetresPerRev, round_to};

use super::limits::{self, LimitedConditions, OfDrill, ReducedFeed};
use super::practice::{self, PracticeComparison};
use super::{Cut, DraftConditions, force_opinion, reaming};

/// The most rounds of reducing the feed. Loads that do not depend on the speed need one; those that do (boring,
/// V^-0.15) decrease with the higher speed of a smaller feed.
const ROUNDS: usize = 8;

/// Conditions for the final feed.
pub(super) struct Settled {
    pub draft: DraftConditions,
    /// The speed of the formula for the final feed, before practice and the steps of the spindle.
    pub formula_speed: MetresPerMinute,
    /// The result of the comparison with practice.
    pub practice: PracticeComparison,
    pub limited: LimitedConditions,
}

/// The feed of the tables, or less where drill strength, thrust or torque require it; the speed of the formula for
/// it, V ~ 1/s^y, so that the tool life is as planned; and its spindle step.
///
/// Where power or the feed rate limits the feed, the speed is not raised again, because it would need more of both.
/// The tool life is then that of the final feed and speed.
///
/// This terminates: the feed falls in each round.
pub(super) fn settle(cut: &Cut, shop: &Shop<'_>) -> Tried<Settled, Uncut> {
    let mut found = at(cut, None, None, shop)?;
    let tabulated = Some(found.draft.feed);
    if found.draft.motion.synchronous {
        let limited = limits::synchronous(&found.draft, shop)?;
        return Ok(found.with_conditions(limited));
    }
    let drill = OfDrill::of(cut, shop)?;
    let (mut limited_by, mut because) = (None, Vec::new());
    for _ in 0..ROUNDS {
        let rpm = limits::step_of(&found.draft, shop)?;
        let Some(ReducedFeed { feed, limit, because: reasons }) =
            limits::reduced_feed(&found.draft, found.draft.feed, &drill, rpm, shop)?
        else {
            break;
        };
        let before = found.formula_speed;
        found = at(cut, Some(feed), tabulated, shop)?;
        limited_by = Some(limit);
        because.extend(reasons);
        because.push(feed_reason("speed-for-feed", feed, &found, Some(before), shop)?);
    }
    let mut limited = limits::limit_to_machine(&found.draft, limited_by, &drill, shop)?;
    because.append(&mut limited.because);
    if limited.feed != found.draft.feed {
        found = at(cut, Some(limited.feed), tabulated, shop)?;
        because.push(feed_reason("life-for-feed", limited.feed, &found, None, shop)?);
    }
    Ok(found.with_conditions(LimitedConditions { because, ..limited }))
}

/// Conditions of a feed, before the limits of the machine.
struct DraftAtFeed {
    draft: DraftConditions,
    formula_speed: MetresPerMinute,
    practice: PracticeComparison,
}

impl DraftAtFeed {
    fn with_conditions(self, limited: LimitedConditions) -> Settled {
        Settled { draft: self.draft, formula_speed: self.formula_speed, practice: self.practice, limited }
    }
}

/// The conditions at a feed; `tabulated` is that of the tables, if another.
fn at(
    cut: &Cut,
    feed: Option<MillimetresPerRev>,
    tabulated: Option<MillimetresPerRev>,
    shop: &Shop<'_>,
) -> Tried<DraftAtFeed, Uncut> {
    let mut draft = super::draft(cut, feed, shop)?;
    let formula_speed = draft.speed;
    let mut practice = practice::compare_with_practice(&mut draft, cut, shop)?;
    if reaming::limit_for_surface(&mut draft, cut, shop)? {
        practice = PracticeComparison::Slower;
    }
    force_opinion::compare_torque(&mut draft, tabulated, cut, shop)?;
    Ok(DraftAtFeed { draft, formula_speed, practice })
}

/// A note that the figures belong to the final feed and not to that of the tables.
fn feed_reason(
    code: &'static str,
    feed: MillimetresPerRev,
    found: &DraftAtFeed,
    before: Option<MetresPerMinute>,
    shop: &Shop<'_>,
) -> Tried<Because, Uncut> {
    let note = Note::new(code).with("feed", round_to(feed.0, 3)).with("speed", round_to(found.formula_speed.0, 2));
    let note = match before {
        Some(before) => note.with("before", round_to(before.0, 2)),
        None => note,
    };
    Ok(Because::table(shop.knowledge.table_of::<FeedChoice<'_>>()?, note))
}
