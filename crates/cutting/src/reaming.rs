//! Reaming.

use crate::error::{KnowledgeError, Tried};
use crate::knowledge::Input;
use crate::knowledge::units::Unit;
use crate::note::{Because, Note};
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::units::{MetresPerMinute, MillimetresPerRev, Minutes};

use super::feed::Feed;
use super::figures::{self, coolant, missing, number};
use super::{Cut, Draft, Loads, Motion, PowerLaw, factors, feed, laws};

/// Conditions of a reamer (Косилова/Мещеряков т.2 table 29; facts 1, 1.2).
///
/// - V = Cv·D^q / (T^m·t^x·s^y)·Kv, m/min;
/// - M = Cp·t^x·sz^y·D·z/200·Kp, N·m, with Cp, x, y of turning (table `boring-force`), sz = s/z in mm/tooth;
/// - D, t in mm, s in mm/rev, T in min, z the number of teeth.
pub(super) fn draft(cut: &Cut<'_>, taken: Option<MillimetresPerRev>, shop: &Shop<'_>) -> Tried<Draft, Uncut> {
    let Feed { feed, mut because, doubts } = corrected_feed(cut, shop)?.or(taken);
    let (tool_life, life) = factors::tool_life("ream", cut, shop)?;
    because.extend(life);
    let (law, figures) = laws::speed("ream", cut.tool_material, feed, shop)?;
    because.extend(figures.because(Note::new("speed-coefficients").with("cv", law.cv)));
    let mut speed = law.at(cut.diameter.to_mm(), cut.depth_of_cut(), feed.0, tool_life);
    if figures.own() {
        let (factor, reason) = factors::material_speed("drilling", cut.tool_material, shop)?;
        speed *= factor;
        because.push(reason);
    }
    let (torque, reasons) = torque(cut, shop)?;
    because.extend(reasons);
    Ok(Draft {
        feed,
        speed: MetresPerMinute(speed),
        tool_life: Minutes(tool_life),
        life_exponent: law.m,
        coolant: coolant(figures.row),
        loads: Loads { torque, thrust: None },
        motion: Motion::along_axis(cut),
        because,
        doubts,
        card: None,
        rounds: None,
    })
}

/// The tabulated feed with the factors of `reaming-feed-factor`: which of them apply says the rule
/// `reaming-feed-condition`, and in a blind hole the feed stays inside the limits of the same table.
fn corrected_feed(cut: &Cut<'_>, shop: &Shop<'_>) -> Tried<Feed, Uncut> {
    let Feed { feed, mut because, doubts } = feed::tabulated(cut, shop)?;
    let mut feed = feed.0;
    let rule = shop.knowledge.table("reaming-feed-condition")?;
    // Only the last pass is asked for a roughness.
    let mut asked = vec![("tool_material", Input::Text(cut.tool_material))];
    if let (Some(it), Some(roughness)) = (cut.it, cut.roughness) {
        asked.extend([
            ("final", Input::Bool(true)),
            ("it", Input::Grade(it)),
            ("roughness", Input::Roughness(roughness)),
        ]);
    }
    let answer = rule.decide(&asked)?;
    let choice = answer.winner().ok_or_else(|| missing(rule, shop))?;
    let table = shop.knowledge.table("reaming-feed-factor")?;
    let mut blind = None;
    for condition in choice.texts("conditions")? {
        let answer = table.decide(&[("condition", Input::Text(condition))])?;
        let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(table, condition))?;
        let factor = number(row, "factor")?;
        feed *= factor;
        if condition != "as-tabulated" {
            because.push(Because::row(row, Note::new("reaming-feed").with("factor", factor)));
        }
        blind = Some(row);
    }
    if let Some(row) = blind.filter(|_| cut.blind) {
        let limit = |name| row.number_in(name, Unit::MillimetrePerRev);
        let (low, high) = (limit("blind_feed_min")?, limit("blind_feed_max")?);
        if !(low..=high).contains(&feed) {
            because.push(Because::row(row, Note::new("reaming-feed-blind").with("low", low).with("high", high)));
        }
        feed = feed.max(low).min(high);
    }
    Ok(Feed { feed: MillimetresPerRev(feed), because, doubts })
}

/// The torque as a power law of the feed; absent where no row of forces is known, for it is not guessed.
fn torque(cut: &Cut<'_>, shop: &Shop<'_>) -> Tried<(Option<PowerLaw>, Vec<Because>), Uncut> {
    let Ok((figures, of_tool)) = figures::ask_of_tool("boring-force", cut.tool_material, shop) else {
        return Ok((None, Vec::new()));
    };
    let row = figures.row;
    let mut because = figures.because(Note::new("reaming-load-coefficients"));
    let teeth = match cut.cutter.filter(|cutter| cutter.teeth > 0) {
        Some(cutter) => f64::from(cutter.teeth),
        None => {
            let table = shop.knowledge.table("reamer-teeth")?;
            let answer = table.decide(&[("diameter", Input::Length(cut.diameter))])?;
            let row = answer.winner().ok_or_else(|| missing(table, shop))?;
            let teeth = number(row, "teeth")?;
            because.push(Because::row(row, Note::new("reamer-teeth").with("teeth", teeth)));
            teeth
        }
    };
    let exponent = number(row, "y")?;
    let mut factor =
        number(row, "cp")? * libm::pow(cut.depth_of_cut(), number(row, "x")?) * cut.diameter.to_mm() * teeth
            / (200.0 * libm::pow(teeth, exponent));
    if figures.own() {
        let material = factors::material_force("turning", of_tool, shop)?;
        factor *= material.0;
        because.push(material.1);
    }
    Ok((Some(PowerLaw::of_feed(factor, exponent)), because))
}
