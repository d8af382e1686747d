//! Reaming.

use crate::error::{KnowledgeError, Tried};
use crate::knowledge::units::Brinell;
use crate::knowledge::{Knowledge, Question};
use crate::note::{Because, Note};
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::tables::cutting::{
    BoringForceFor, Coefficients, Process, ReamerTeethFor, ReamingCondition, ReamingFeedFactorFor,
};
use crate::tables::practice::{PracticeFeed, PracticeFeedFor, PracticeWork, StockBeforeReaming, StockBeforeReamingFor};
use crate::tables::rules::{HeldTo, ReamingCase, ReamingFeedConditionFor};
use crate::units::{MetresPerMinute, MillimetresPerRev, round_to};

use super::feed::Feed;
use super::figures::{self, Asking, missing};
use super::{Cut, CutMotion, DraftConditions, Loads, PowerLaw, factors, feed, laws, practice};

/// Conditions of a reamer (Косилова/Мещеряков т.2 table 29; facts 1, 1.2).
///
/// - V = Cv·D^q / (T^m·t^x·s^y)·Kv, m/min;
/// - M = Cp·t^x·sz^y·D·z/200·Kp, N·m, with Cp, x, y of turning (table `boring-force`), sz = s/z in mm/tooth;
/// - D, t in mm, s in mm/rev, T in min, z the number of teeth.
pub(super) fn draft(cut: &Cut, taken: Option<MillimetresPerRev>, shop: &Shop<'_>) -> Tried<DraftConditions, Uncut> {
    let (corrected, held_from) = held_feed(cut, shop)?;
    let Feed { feed, mut because, doubts } = corrected.with_feed(taken);
    let (tool_life, life) = factors::tool_life(Coefficients::Ream, cut, shop)?;
    because.extend(life);
    let (law, figures) = laws::speed(Coefficients::Ream, cut.tool_material, feed, shop)?;
    because.extend(figures.because(Note::new("speed-coefficients").with("cv", law.cv)));
    // A rough reamer whose feed is held to practice gains no speed by it.
    let slowest = held_from.filter(|_| cut.roughness.is_none()).map_or(feed.0, |table| feed.0.max(table.0));
    let mut speed = law.at(cut.diameter.to_mm(), cut.depth_of_cut(), slowest, tool_life.0);
    if figures.is_own_group() {
        let (factor, reason) = factors::material_speed(Process::Drilling, cut.tool_material, shop)?;
        speed *= factor;
        because.push(reason);
    }
    let (torque, reasons) = torque(cut, shop)?;
    because.extend(reasons);
    Ok(DraftConditions {
        feed,
        speed: MetresPerMinute(speed),
        fastest: None,
        tool_life,
        life_exponent: law.m,
        coolant: figures.row.coolant,
        loads: Loads { torque, thrust: None },
        motion: CutMotion::along_axis(cut),
        because,
        doubts,
        card: None,
        rounds: None,
        plunge: None,
        arcs: Vec::new(),
    })
}

/// The cut that limits the speed of the last reamer, which serves the surface: that of a rough one, at its feed and with the largest
/// stock of a rough reamer (table `stock-before-reaming`). The formula alone would give the last one a faster speed, because its
/// stock is smaller; and a lower feed for the surface must not raise the speed either. With its row; none for other cuts.
///
/// # Errors
/// The knowledge base lacks the table.
pub fn rough_instead<'k>(
    cut: &Cut,
    knowledge: &'k Knowledge,
) -> Result<Option<(Cut, StockBeforeReaming<'k>)>, KnowledgeError> {
    if !cut.operation.is_reaming() || cut.roughness.is_none() {
        return Ok(None);
    }
    let question = StockBeforeReamingFor { case: ReamingCase::RoughAfterDrill, diameter: cut.diameter };
    let row = knowledge.winner_within(&question)?;
    Ok(row.map(|row| (Cut { from: cut.diameter - row.stock_max, roughness: None, ..*cut }, row)))
}

/// Limits the speed of a draft to that of [`rough_instead`]; whether it does.
pub(super) fn limit_for_surface(draft: &mut DraftConditions, cut: &Cut, shop: &Shop<'_>) -> Tried<bool, Uncut> {
    let Some((rough, row)) = rough_instead(cut, shop.knowledge)? else { return Ok(false) };
    let formula = self::draft(&rough, None, shop)?.speed;
    let speed = practice::second_opinion(formula, &rough, &shop.material, shop.knowledge)?.speed;
    if speed.0 >= draft.speed.0 {
        return Ok(false);
    }
    draft.speed = speed;
    // A step of the spindle must not take back what the surface demands.
    draft.fastest = Some(draft.fastest.map_or(speed, |fastest| MetresPerMinute(fastest.0.min(speed.0))));
    let note = Note::new("reamed-for-surface").with("stock", row.stock_max).with("speed", round_to(speed.0, 1));
    draft.because.push(Because::row(row.row, note));
    Ok(true)
}

/// The tabulated feed with the factors of `reaming-feed-factor`. The rule `reaming-feed-condition` says which of them
/// apply, and by which figure of practice (`practice-feed`) the feed is held; in a blind hole it stays within the limits of the table
/// of factors.
pub(super) fn corrected_feed<'k>(cut: &Cut, shop: &impl Asking<'k>) -> Tried<Feed, Uncut> {
    held_feed(cut, shop).map(|(feed, _)| feed)
}

/// As [`corrected_feed`], with the feed that it would be if practice did not hold it; none where it does not.
fn held_feed<'k>(cut: &Cut, shop: &impl Asking<'k>) -> Tried<(Feed, Option<MillimetresPerRev>), Uncut> {
    let mut held_from = None;
    let knowledge = shop.knowledge();
    let Feed { feed, mut because, doubts } = feed::tabulated(cut, shop)?;
    let mut feed = feed.0;
    // Only the last pass needs a roughness.
    let rule = knowledge.ask(&ReamingFeedConditionFor {
        tool_material: cut.tool_material,
        material_group: shop.material().group,
        hardness: Brinell(shop.material().hardness),
        diameter: cut.diameter,
        final_: cut.roughness.map(|_| true),
        roughness: cut.roughness,
    })?;
    let rule = rule.winner()?.ok_or_else(|| missing(ReamingFeedConditionFor::TABLE, shop))?;
    let mut blind = None;
    for condition in rule.conditions {
        let row = knowledge.ask(&ReamingFeedFactorFor { condition })?.need(condition.name())?;
        feed *= row.factor;
        if condition != ReamingCondition::AsTabulated {
            because.push(Because::row(row.row, Note::new("reaming-feed").with("factor", row.factor)));
        }
        blind = Some(row);
    }
    if rule.practice != HeldTo::Unheld {
        let question = PracticeFeedFor {
            operation: PracticeWork::Ream,
            material_group: shop.material().group,
            diameter: cut.diameter,
        };
        let practice = knowledge.winner_within(&question)?;
        let most = |row: &PracticeFeed<'_>| match rule.practice {
            HeldTo::Least => row.feed_low.0,
            HeldTo::Usual => row.feed.unwrap_or(row.feed_high).0,
            HeldTo::Unheld | HeldTo::Most => row.feed_high.0,
        };
        if let Some(row) = practice.filter(|row| most(row) < feed) {
            let held = most(&row);
            let note = Note::new("reaming-feed-practice").with("table", round_to(feed, 3)).with("feed", held);
            because.push(Because::row(row.row, note));
            held_from = Some(MillimetresPerRev(feed));
            feed = held;
        }
    }
    if let Some(row) = blind.filter(|_| cut.blind) {
        let (low, high) = (row.blind_feed_min.0, row.blind_feed_max.0);
        if !(low..=high).contains(&feed) {
            because.push(Because::row(row.row, Note::new("reaming-feed-blind").with("low", low).with("high", high)));
        }
        feed = feed.max(low).min(high);
    }
    Ok((Feed { feed: MillimetresPerRev(feed), because, doubts }, held_from))
}

/// The torque as a power law of the feed; absent without a row of forces, because it is not guessed.
fn torque(cut: &Cut, shop: &Shop<'_>) -> Tried<(Option<PowerLaw>, Vec<Because>), Uncut> {
    let question = |material_group, tool_material| BoringForceFor { material_group, tool_material };
    let Ok((figures, of_tool)) = figures::ask_of_tool(question, cut.tool_material, shop) else {
        return Ok((None, Vec::new()));
    };
    let row = &figures.row;
    let mut because = figures.because(Note::new("reaming-load-coefficients"));
    let teeth = match cut.cutter.filter(|cutter| cutter.teeth > 0) {
        Some(cutter) => f64::from(cutter.teeth),
        None => {
            let answer = shop.knowledge.ask(&ReamerTeethFor { diameter: cut.diameter })?;
            let row = answer.winner()?.ok_or_else(|| missing(ReamerTeethFor::TABLE, shop))?;
            because.push(Because::row(row.row, Note::new("reamer-teeth").with("teeth", row.teeth)));
            row.teeth
        }
    };
    let mut factor = row.cp * libm::pow(cut.depth_of_cut(), row.x) * cut.diameter.to_mm() * teeth
        / (200.0 * libm::pow(teeth, row.y));
    if figures.is_own_group() {
        let material = factors::material_force(Process::Turning, of_tool, shop)?;
        factor *= material.0;
        because.push(material.1);
    }
    Ok((Some(PowerLaw::of_feed(factor, row.y)), because))
}
