//! Reaming.

use crate::error::KnowledgeError;
use crate::knowledge::Input;
use crate::note::{Because, Note};
use crate::shop::Shop;
use crate::units::{MetresPerMinute, Minutes};

use super::factors::{self, number};
use super::{Cut, Draft, Loads, feed};

/// V = Cv·D^q / (T^m·t^x·s^y)·Kv (Косилова/Мещеряков т.2 table 29; facts 1.2).
///
/// The reaming torque needs the number of teeth, which tables A.24-A.27 do not print; it is small, and
/// left out rather than guessed.
pub(super) fn draft(cut: &Cut<'_>, shop: &Shop<'_>) -> Result<Result<Draft, Note>, KnowledgeError> {
    let feed = match feed::tabulated(cut, shop)? {
        Ok(feed) => feed,
        Err(note) => return Ok(Err(note)),
    };
    let mut because = feed.because;
    let operation = Input::Text("ream");
    let group = Input::Text(shop.material.group);
    let tool = Input::Text(cut.tool_material);

    let (tool_life, life) = match factors::tool_life("ream", cut, shop)? {
        Ok(life) => life,
        Err(note) => return Ok(Err(note)),
    };

    let speed_table = shop.knowledge.table("cutting-speed")?;
    let speed = speed_table.decide(&[
        ("operation", operation),
        ("material_group", group),
        ("tool_material", tool),
        ("feed", feed::feed_input(feed.feed)),
    ])?;
    let Some(row) = speed.winner() else { return Ok(Err(factors::missing(speed_table, shop))) };
    let (material, reason) = match factors::material_speed("drilling", cut, shop)? {
        Ok(factor) => factor,
        Err(note) => return Ok(Err(note)),
    };
    let speed = number(row, "cv")? * libm::pow(cut.diameter.to_mm(), number(row, "q")?)
        / (libm::pow(tool_life, number(row, "m")?)
            * libm::pow(cut.depth_of_cut(), number(row, "x")?)
            * libm::pow(feed.feed.0, number(row, "y")?))
        * material;
    because.push(life);
    because.push(Because::row(row, Note::new("speed-coefficients").with("cv", number(row, "cv")?)));
    because.push(reason);
    Ok(Ok(Draft {
        feed: feed.feed,
        speed: MetresPerMinute(speed),
        tool_life: Minutes(tool_life),
        loads: Loads::default(),
        because,
        card: None,
    }))
}
