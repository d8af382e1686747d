//! Boring with a single-point tool.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::units::Unit;
use crate::knowledge::{Input, Table};
use crate::note::{Because, Note};
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::units::{MetresPerMinute, Micrometres, MillimetresPerRev, Minutes, Roughness};

use super::figures::feed_input;
use super::figures::{self, number};
use super::{Cut, Draft, Loads, Motion, PowerLaw, factors};

/// Turning formulas, speed × 0.9 for internal work (Косилова/Мещеряков т.2; facts 1.8).
///
/// - V = Cv / (T^m·t^x·s^y)·Kmv·Kpv·0.9;
/// - Pz = 10·Cp·t^x·s^y·V^n·Kp, N, with V the speed that is driven; the torque is Pz·D/2.
pub(super) fn draft(cut: &Cut<'_>, taken: Option<MillimetresPerRev>, shop: &Shop<'_>) -> Tried<Draft, Uncut> {
    let (tabulated, reason) = feed(cut, shop)?;
    let feed = taken.unwrap_or(tabulated);
    let mut because = vec![reason];
    let parameters = shop.knowledge.table("boring-parameters")?;
    let parameter = |name: &str| parameters.find("name", name).ok_or_else(|| KnowledgeError::no_row(parameters, name));
    let life_row = parameter("tool-life")?;
    let life = life_row.number_in("time", Unit::Minute)?;
    let internal_row = parameter("internal-factor")?;
    let internal = number(internal_row, "factor")?;
    because.push(Because::row(life_row, Note::new("tool-life").with("minutes", life)));
    because.push(Because::row(internal_row, Note::new("internal-factor").with("factor", internal)));
    let t = cut.depth_of_cut();

    let figures = figures::ask("boring-speed", &[("feed", feed_input(feed))], shop)?;
    let row = figures.row;
    because.extend(figures.because(Note::new("speed-coefficients").with("cv", number(row, "cv")?)));
    let mut speed = number(row, "cv")?
        / (libm::pow(life, number(row, "m")?) * libm::pow(t, number(row, "x")?) * libm::pow(feed.0, number(row, "y")?))
        * internal;
    let mut corrections = vec![factors::surface(cut.surface, shop)?];
    if figures.own() {
        corrections.push(factors::material_speed("turning", cut.tool_material, shop)?);
    }
    for (factor, reason) in corrections {
        speed *= factor;
        because.push(reason);
    }

    let mut loads = Loads::default();
    // Without a row of forces the pass is still cut; its torque is left out and not guessed.
    if let Ok(figures) =
        Refusal::split(figures::ask("boring-force", &[("tool_material", Input::Text(cut.tool_material))], shop))?
    {
        let row = figures.row;
        let mut force = 10.0 * number(row, "cp")? * libm::pow(t, number(row, "x")?);
        if figures.own() {
            let (factor, reason) = factors::material_force("turning", cut.tool_material, shop)?;
            force *= factor;
            because.push(reason);
        }
        because.extend(figures.because(Note::new("load-coefficients")));
        loads.torque = Some(PowerLaw {
            factor: force * cut.diameter.to_mm() / 2000.0,
            exponent: number(row, "y")?,
            of_speed: number(row, "n")?,
        });
    }
    Ok(Draft {
        feed,
        speed: MetresPerMinute(speed),
        tool_life: Minutes(life),
        life_exponent: number(row, "m")?,
        coolant: None,
        loads,
        motion: Motion::along_axis(cut),
        because,
        doubts: Vec::new(),
        card: None,
        rounds: None,
    })
}

/// The feed of a boring pass by the rule-bearing table `boring-feed`: roughing by its own figure, the
/// last pass by the roughness it must leave and the nose radius (table `boring-finish-feed`).
fn feed(cut: &Cut<'_>, shop: &Shop<'_>) -> Tried<(MillimetresPerRev, Because), Uncut> {
    let stages = shop.knowledge.table("boring-feed")?;
    let answer = stages.decide(&[("operation", Input::Text(cut.operation.name()))])?;
    let stage = answer.winner().ok_or_else(|| KnowledgeError::no_row(stages, cut.operation.name()))?;
    let plain = stage.number_in("feed", Unit::MillimetrePerRev)?;
    let by_stage = (MillimetresPerRev(plain), Because::row(stage, Note::new("boring-feed").with("feed", plain)));
    let (Some(limit), Some(nose)) = (cut.roughness, cut.nose_radius) else { return Ok(by_stage) };
    let finish = shop.knowledge.table("boring-finish-feed")?;
    let column = nearest_column(finish, limit).ok_or(Refusal::Not(Uncut::TooFineToBore { roughness: limit }))?;
    if column < limit && column_is_coarsest(finish, column) {
        // A coarser surface than the table goes to is no reason to feed faster than the stage does.
        return Ok(by_stage);
    }
    let nose = nose_name(nose);
    let answer = finish.decide(&[("roughness", Input::Roughness(column)), ("nose_radius", Input::Text(&nose))])?;
    let row = answer.winner().ok_or_else(|| figures::missing(finish, shop))?;
    let feed = row.number_in("feed", Unit::MillimetrePerRev)?.min(plain);
    Ok((MillimetresPerRev(feed), Because::row(row, Note::new("boring-finish-feed").with("feed", feed))))
}

fn nose_name(nose: Micrometres) -> String {
    nose.to_string()
}

/// The coarsest roughness of the table that still holds the limit.
fn nearest_column(table: &Table, limit: Roughness) -> Option<Roughness> {
    columns(table).into_iter().filter(|column| *column <= limit).max()
}

fn column_is_coarsest(table: &Table, column: Roughness) -> bool {
    columns(table).into_iter().max() == Some(column)
}

fn columns(table: &Table) -> Vec<Roughness> {
    crate::knowledge::query::roughness_points(table, "roughness")
}
