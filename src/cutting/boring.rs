//! Boring with a single-point tool.

use crate::error::KnowledgeError;
use crate::knowledge::units::Unit;
use crate::knowledge::{Input, Table};
use crate::note::{Because, Note};
use crate::shop::Shop;
use crate::units::{MetresPerMinute, Micrometres, MillimetresPerRev, Minutes, Roughness};

use super::factors::{self, number};
use super::feed::feed_input;
use super::{Cut, Draft, Loads, PowerLaw};

/// Turning formulas, speed × 0.9 for internal work (Косилова/Мещеряков т.2; facts 1.8).
///
/// - V = Cv / (T^m·t^x·s^y)·Kmv·Kpv·0.9;
/// - Pz = 10·Cp·t^x·s^y·V^n·Kp, N; the torque is Pz·D/2.
pub(super) fn draft(cut: &Cut<'_>, shop: &Shop<'_>) -> Result<Result<Draft, Note>, KnowledgeError> {
    let (feed, reason) = match feed(cut, shop)? {
        Ok(feed) => feed,
        Err(note) => return Ok(Err(note)),
    };
    let mut because = vec![reason];
    let parameters = shop.knowledge.table("boring-parameters")?;
    let life_row =
        parameters.find("name", "tool-life").ok_or_else(|| KnowledgeError::no_row(parameters, "tool-life"))?;
    let life = life_row.number_in("time", Unit::Minute)?;
    let internal = parameters
        .find("name", "internal-factor")
        .ok_or_else(|| KnowledgeError::no_row(parameters, "internal-factor"))?
        .number_in("factor", Unit::None)?;
    let t = cut.depth_of_cut();

    let speed_table = shop.knowledge.table("boring-speed")?;
    let answer =
        speed_table.decide(&[("material_group", Input::Text(shop.material.group)), ("feed", feed_input(feed))])?;
    let Some(row) = answer.winner() else { return Ok(Err(factors::missing(speed_table, shop))) };
    let mut speed = number(row, "cv")?
        / (libm::pow(life, number(row, "m")?) * libm::pow(t, number(row, "x")?) * libm::pow(feed.0, number(row, "y")?))
        * internal;
    because.push(Because::row(life_row, Note::new("tool-life").with("minutes", life)));
    because.push(Because::row(row, Note::new("speed-coefficients").with("cv", number(row, "cv")?)));
    for factor in [factors::material_speed("turning", cut, shop)?, factors::surface(cut, shop)?] {
        match factor {
            Ok((factor, reason)) => {
                speed *= factor;
                because.push(reason);
            }
            Err(note) => return Ok(Err(note)),
        }
    }

    let force_table = shop.knowledge.table("boring-force")?;
    let answer = force_table.decide(&[
        ("material_group", Input::Text(shop.material.group)),
        ("tool_material", Input::Text(cut.tool_material)),
    ])?;
    let mut loads = Loads::default();
    if let Some(row) = answer.winner() {
        let material = match factors::material_force("turning", cut, shop)? {
            Ok((factor, reason)) => {
                because.push(reason);
                factor
            }
            Err(note) => return Ok(Err(note)),
        };
        let force = 10.0
            * number(row, "cp")?
            * libm::pow(t, number(row, "x")?)
            * libm::pow(speed, number(row, "n")?)
            * material;
        because.push(Because::row(row, Note::new("load-coefficients")));
        loads.torque = Some(PowerLaw { factor: force * cut.diameter.to_mm() / 2000.0, exponent: number(row, "y")? });
    }
    Ok(Ok(Draft { feed, speed: MetresPerMinute(speed), tool_life: Minutes(life), loads, because, card: None }))
}

/// The feed of a boring pass by the rule-bearing table `boring-feed`: roughing by its own figure, the
/// last pass by the roughness it must leave and the nose radius (table `boring-finish-feed`).
fn feed(cut: &Cut<'_>, shop: &Shop<'_>) -> Result<Result<(MillimetresPerRev, Because), Note>, KnowledgeError> {
    let stages = shop.knowledge.table("boring-feed")?;
    let answer = stages.decide(&[("operation", Input::Text(cut.operation.name()))])?;
    let stage = answer.winner().ok_or_else(|| KnowledgeError::no_row(stages, cut.operation.name()))?;
    let plain = stage.number_in("feed", Unit::MillimetrePerRev)?;
    let (Some(limit), Some(nose)) = (cut.roughness, cut.nose_radius) else {
        return Ok(Ok((MillimetresPerRev(plain), Because::row(stage, Note::new("boring-feed").with("feed", plain)))));
    };
    let finish = shop.knowledge.table("boring-finish-feed")?;
    let Some(column) = nearest_column(finish, limit) else {
        return Ok(Err(Note::new("too-fine-to-bore").with("roughness", limit)));
    };
    if column < limit && column_is_coarsest(finish, column) {
        // A coarser surface than the table goes to is no reason to feed faster than the stage does.
        return Ok(Ok((MillimetresPerRev(plain), Because::row(stage, Note::new("boring-feed").with("feed", plain)))));
    }
    let nose = nose_name(nose);
    let answer = finish.decide(&[("roughness", Input::Roughness(column)), ("nose_radius", Input::Text(&nose))])?;
    let Some(row) = answer.winner() else { return Ok(Err(factors::missing(finish, shop))) };
    let feed = row.number_in("feed", Unit::MillimetrePerRev)?.min(plain);
    Ok(Ok((MillimetresPerRev(feed), Because::row(row, Note::new("boring-finish-feed").with("feed", feed)))))
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
