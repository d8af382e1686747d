//! Boring with a single-point tool.

use crate::error::{Refusal, Tried};
use crate::knowledge::{Column, Question, Table};
use crate::note::{Because, Note};
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::tables::cutting::{BoringFeedFor, BoringFinishFeedFor, BoringForceFor, BoringSpeedFor, Process};
use crate::units::{MetresPerMinute, MillimetresPerRev, Roughness};

use super::{Cut, CutMotion, DraftConditions, Loads, PowerLaw, factors, figures};

/// Turning formulas, speed × 0.9 for internal work (Косилова/Мещеряков т.2; facts 1.8).
///
/// - V = Cv / (T^m·t^x·s^y)·Kmv·Kpv·0.9;
/// - Pz = 10·Cp·t^x·s^y·V^n·Kp, N, with V the speed used; the torque is Pz·D/2.
pub(super) fn draft(cut: &Cut, taken: Option<MillimetresPerRev>, shop: &Shop<'_>) -> Tried<DraftConditions, Uncut> {
    let (tabulated, reason) = feed(cut, shop)?;
    let feed = taken.unwrap_or(tabulated);
    let mut because = vec![reason];
    let (life, reason) = factors::single_point_life(shop.knowledge)?;
    because.push(reason);
    let (internal, reason) = factors::internal(shop.knowledge)?;
    because.push(reason);
    let t = cut.depth_of_cut();

    let figures = figures::ask(|material_group| BoringSpeedFor { material_group, feed }, shop)?;
    let row = &figures.row;
    because.extend(figures.because(Note::new("speed-coefficients").with("cv", row.cv)));
    let mut speed = row.cv / (libm::pow(life.0, row.m) * libm::pow(t, row.x) * libm::pow(feed.0, row.y)) * internal;
    let life_exponent = row.m;
    let mut corrections = vec![factors::surface(cut.surface, shop)?];
    if figures.is_own_group() {
        corrections.push(factors::material_speed(Process::Turning, cut.tool_material, shop)?);
    }
    for (factor, reason) in corrections {
        speed *= factor;
        because.push(reason);
    }

    let mut loads = Loads::default();
    // Without a row of forces the pass is cut all the same; its torque is left out, not guessed.
    let question = |material_group| BoringForceFor { material_group, tool_material: cut.tool_material };
    if let Ok(figures) = Refusal::split(figures::ask(question, shop))? {
        let row = &figures.row;
        let mut force = 10.0 * row.cp * libm::pow(t, row.x);
        if figures.is_own_group() {
            let (factor, reason) = factors::material_force(Process::Turning, cut.tool_material, shop)?;
            force *= factor;
            because.push(reason);
        }
        because.extend(figures.because(Note::new("load-coefficients")));
        loads.torque =
            Some(PowerLaw { factor: force * cut.diameter.to_mm() / 2000.0, exponent: row.y, of_speed: row.n });
    }
    Ok(DraftConditions {
        feed,
        speed: MetresPerMinute(speed),
        fastest: None,
        tool_life: life,
        life_exponent,
        coolant: None,
        loads,
        motion: CutMotion::along_axis(cut),
        because,
        doubts: Vec::new(),
        card: None,
        rounds: None,
        plunge: None,
        arcs: Vec::new(),
    })
}

/// The feed of a boring pass by the rule-bearing table `boring-feed`: roughing by its own figure, the
/// last pass by the roughness it must leave and the nose radius (table `boring-finish-feed`).
fn feed(cut: &Cut, shop: &Shop<'_>) -> Tried<(MillimetresPerRev, Because), Uncut> {
    let operation = cut.operation;
    let stage = shop.knowledge.ask(&BoringFeedFor { operation })?.need(operation.name())?;
    let note = Note::new("boring-feed").with("feed", stage.feed.0);
    let by_stage = (stage.feed, Because::row(stage.row, note));
    let (Some(limit), Some(nose)) = (cut.roughness, cut.nose_radius) else { return Ok(by_stage) };
    let finish = shop.knowledge.table(BoringFinishFeedFor::TABLE)?;
    let column = nearest_column(finish, limit).ok_or(Refusal::Not(Uncut::TooFineToBore { roughness: limit }))?;
    if column < limit && column_is_coarsest(finish, column) {
        // A surface coarser than the table is no reason for a feed above that of the stage.
        return Ok(by_stage);
    }
    let nose = nose.to_string();
    let answer = finish.ask(&BoringFinishFeedFor { roughness: column, nose_radius: &nose })?;
    let row = answer.winner()?.ok_or_else(|| figures::missing(&finish.id, shop))?;
    let feed = row.feed.0.min(stage.feed.0);
    let because = Because::row(row.row, Note::new("boring-finish-feed").with("feed", feed));
    Ok((MillimetresPerRev(feed), because))
}

/// The coarsest roughness of the table that is within the limit.
fn nearest_column(table: &Table, limit: Roughness) -> Option<Roughness> {
    columns(table).into_iter().filter(|column| *column <= limit).max()
}

fn column_is_coarsest(table: &Table, column: Roughness) -> bool {
    columns(table).into_iter().max() == Some(column)
}

fn columns(table: &Table) -> Vec<Roughness> {
    BoringFinishFeedFor::roughness(table).map(Column::roughness_points).unwrap_or_default()
}
