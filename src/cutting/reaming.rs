//! Reaming.

use crate::error::Tried;
use crate::knowledge::Input;
use crate::note::Note;
use crate::shop::Shop;
use crate::units::{MetresPerMinute, Minutes};

use super::figures::{self, coolant, number};
use super::{Cut, Draft, Loads, factors, feed};

/// V = Cv·D^q / (T^m·t^x·s^y)·Kv (Косилова/Мещеряков т.2 table 29; facts 1.2).
///
/// The reaming torque needs the number of teeth, which tables A.24-A.27 do not print; it is small, and
/// left out rather than guessed.
pub(super) fn draft(cut: &Cut<'_>, shop: &Shop<'_>) -> Tried<Draft> {
    let feed = feed::tabulated(cut, shop)?;
    let mut because = feed.because;
    let (tool_life, life) = factors::tool_life("ream", cut, shop)?;
    because.extend(life);
    let others = [
        ("operation", Input::Text("ream")),
        ("tool_material", Input::Text(cut.tool_material)),
        ("feed", figures::feed_input(feed.feed)),
    ];
    let figures = figures::ask("cutting-speed", &others, shop)?;
    let row = figures.row;
    because.extend(figures.because(Note::new("speed-coefficients").with("cv", number(row, "cv")?)));
    let mut speed = number(row, "cv")? * libm::pow(cut.diameter.to_mm(), number(row, "q")?)
        / (libm::pow(tool_life, number(row, "m")?)
            * libm::pow(cut.depth_of_cut(), number(row, "x")?)
            * libm::pow(feed.feed.0, number(row, "y")?));
    if figures.own() {
        let (factor, reason) = factors::material_speed("drilling", cut, shop)?;
        speed *= factor;
        because.push(reason);
    }
    Ok(Draft {
        feed: feed.feed,
        speed: MetresPerMinute(speed),
        tool_life: Minutes(tool_life),
        life_exponent: number(row, "m")?,
        coolant: coolant(row),
        loads: Loads::default(),
        because,
        card: None,
    })
}
