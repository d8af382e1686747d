//! What the machine lets through: spindle step, feed range, thrust, torque, power.

use crate::error::KnowledgeError;
use crate::knowledge::Input;
use crate::knowledge::units::Unit;
use crate::note::{Because, Note};
use crate::shop::Shop;
use crate::units::{Decimal, Micrometres, MillimetresPerRev, RevsPerMinute, round_to};

use super::{Draft, rpm_at};

/// Conditions within the machine's limits.
pub(super) struct Held {
    pub feed: MillimetresPerRev,
    pub rpm: RevsPerMinute,
    pub limited_by: String,
    pub because: Vec<Because>,
}

/// Chooses the spindle step and holds the feed inside thrust, torque, power and feed range.
pub(super) fn hold(draft: &Draft, diameter: Micrometres, shop: &Shop<'_>) -> Result<Held, KnowledgeError> {
    let machine = &shop.machine;
    let wanted = rpm_at(draft.speed, diameter);
    let (rpm, mut limited_by, reason) = spindle_step(wanted, shop)?;
    let mut feed = draft.feed;
    let mut because = vec![reason];
    let torque_of_power = 9750.0 * machine.spindle_power.0 / rpm.0;
    let loads = draft.loads;
    let bounds = [
        (loads.thrust, machine.thrust.0, "thrust", "thrust-z-max"),
        (loads.torque, machine.spindle_torque.0, "spindle-torque", "spindle-torque-max"),
        (loads.torque, torque_of_power, "spindle-power", "spindle-power"),
    ];
    for (law, limit, name, quantity) in bounds {
        if let Some(law) = law
            && law.at(feed) > limit
        {
            let before = feed;
            feed = law.feed_at(limit);
            name.clone_into(&mut limited_by);
            let note = Note::new("feed-reduced")
                .with("by", name)
                .with("from", round_to(before.0, 3))
                .with("to", round_to(feed.0, 3))
                .with("limit", round_to(limit, 1));
            because.push(Because::row(machine.row(quantity)?, note));
        }
    }
    for (outside, limit, name) in [
        (feed.0 * rpm.0 > machine.feed_max.0, machine.feed_max, "feed-max"),
        (feed.0 * rpm.0 < machine.feed_min.0, machine.feed_min, "feed-min"),
    ] {
        if outside {
            feed = MillimetresPerRev(limit.0 / rpm.0);
            name.clone_into(&mut limited_by);
            because.push(Because::row(machine.row(name)?, Note::new("feed-held").with("limit", limit.0)));
        }
    }
    Ok(Held { feed, rpm, limited_by, because })
}

/// The step of the spindle's series for a computed speed, by the rule `spindle-step`.
fn spindle_step(wanted: RevsPerMinute, shop: &Shop<'_>) -> Result<(RevsPerMinute, String, Because), KnowledgeError> {
    let steps = &shop.machine.spindle_steps;
    let below = steps.iter().rev().find(|step| step.0 <= wanted.0);
    let above = steps.iter().find(|step| step.0 >= wanted.0);
    let series = |code: &str, step: RevsPerMinute| -> Result<Because, KnowledgeError> {
        let note = Note::new(code).with("computed", round_to(wanted.0, 1)).with("step", step.0);
        Ok(Because::row(shop.machine.row("spindle-speeds")?, note))
    };
    match (below, above) {
        (Some(below), Some(above)) => {
            let excess = (above.0 / wanted.0 - 1.0) * 100.0;
            let rule = shop.knowledge.table("spindle-step")?;
            let answer = rule.decide(&[("excess", Input::Number(Decimal::from_f64_rounded(excess), Unit::Percent))])?;
            let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this excess"))?;
            let step = if row.text("take")? == "above" { *above } else { *below };
            let note = Note::new("spindle-step")
                .with("computed", round_to(wanted.0, 1))
                .with("below", below.0)
                .with("above", above.0)
                .with("excess", round_to(excess, 1))
                .with("step", step.0);
            Ok((step, "cutting-speed".to_owned(), Because::answer(&answer, note)))
        }
        (Some(below), None) => Ok((*below, "spindle-speed-max".to_owned(), series("spindle-fastest", *below)?)),
        (None, Some(above)) => Ok((*above, "spindle-speed-min".to_owned(), series("spindle-slowest", *above)?)),
        (None, None) => Err(KnowledgeError::no_row(shop.machine.table, "spindle-speeds")),
    }
}
