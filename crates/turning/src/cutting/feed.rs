//! Feeds of turning, by the tables.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::query::roughness_points;
use crate::knowledge::{Input, Knowledge};
use crate::note::{Because, Note};
use crate::turning::tooling::{Shank, ToolKind};
use crate::units::{Micrometres, MillimetresPerRev, Roughness, Unit};
use technolog_cutting::figures::{self, number};

use super::{Cut, Lack, of_tables};

/// A feed and the rows it rests on.
#[derive(Clone, Debug, PartialEq)]
pub struct Feed {
    /// The feed.
    pub feed: MillimetresPerRev,
    /// Why.
    pub because: Vec<Because>,
}

/// The feed of a roughing pass of that depth (`turning-rough-feed`, `turning-boring-feed`); of a grooving tool its feed
/// at the diameter (`grooving-feed`), whatever the depth. The lower end of the handbook's range is taken.
///
/// # Errors
/// The table has no feed for the tool, the diameter or the depth; the tool's row lacks its shank; threads.
pub fn rough_feed(cut: &Cut<'_, '_>, depth: Micrometres) -> Tried<Feed, Lack> {
    let diameter = ("diameter", Input::Length(cut.diameter));
    let by_depth = ("depth", Input::Length(depth));
    let process = cut.process();
    let lacks = |quantity: &str| Refusal::Not(Lack::Figure(cut.tool_lacks(quantity).during(process)));
    let figures = match cut.tool.kind {
        ToolKind::Turning => {
            let Some(Shank::Square { height, .. }) = cut.tool.shank else { return Err(lacks("shank_height")) };
            figures::ask("turning-rough-feed", &[("shank_height", Input::Length(height)), diameter, by_depth], cut)
        }
        ToolKind::Boring => {
            let Some(Shank::Round { diameter }) = cut.tool.shank else { return Err(lacks("bar_diameter")) };
            figures::ask("turning-boring-feed", &[("bar_diameter", Input::Length(diameter)), by_depth], cut)
        }
        ToolKind::Grooving | ToolKind::FaceGrooving => figures::ask("grooving-feed", &[diameter], cut),
        ToolKind::Threading => {
            return Err(Refusal::Not(Lack::Threads { tool: cut.tool.designation.to_owned(), process }));
        }
    };
    let no_feed = |lacking| Lack::NoFeed { lacking, depth, diameter: cut.diameter };
    let figures = cut.named(of_tables(figures)).map_err(|refusal| refusal.map(no_feed))?;
    let feed = figures.row.number_in("feed_min", Unit::MillimetrePerRev)?;
    let note = Note::new("turning-feed").with("feed", feed).with("tool", cut.tool.designation);
    Ok(Feed { feed: MillimetresPerRev(feed), because: figures.because(note) })
}

/// The feed that leaves a roughness, by the nose radius: nine cells of `boring-finish-feed`, the others of
/// `turning-finish-feed`, times `turning-finish-feed-strength` for steel. Between two columns the finer one and between
/// two radii the smaller one is taken.
///
/// # Errors
/// The roughness is finer than the table; the tool's row has no nose radius, or one below the table's; threads.
pub fn finish_feed(cut: &Cut<'_, '_>, roughness: Roughness) -> Tried<Feed, Lack> {
    let process = cut.process();
    let no_nose = || Refusal::Not(Lack::Figure(cut.tool_lacks("nose_radius").during(process)));
    let rest = cut.knowledge.table("turning-finish-feed")?;
    let nose = cut.tool.nose_radius.ok_or_else(no_nose)?;
    let nose = nose_of_table(cut.knowledge, nose)?.ok_or_else(no_nose)?;
    let column = roughness_points(rest, "roughness").into_iter().filter(|column| *column <= roughness).max();
    let column = column.ok_or(Refusal::Not(Lack::TooFineToTurn { roughness, process }))?;
    let cell = [("roughness", Input::Roughness(column)), ("nose_radius", Input::Text(&nose))];
    let row = match rest.decide(&cell)?.winner() {
        Some(row) => row,
        None => {
            let nine = cut.knowledge.table("boring-finish-feed")?;
            nine.decide(&cell)?.winner().ok_or_else(|| KnowledgeError::no_row(nine, "this roughness and nose"))?
        }
    };
    let mut feed = row.number_in("feed", Unit::MillimetrePerRev)?;
    let mut because = vec![Because::row(row, Note::new("turning-finish-feed").with("feed", feed))];
    if cut.material.group == "steel" {
        let table = cut.knowledge.table("turning-finish-feed-strength")?;
        let answer = table.decide(&[("strength", Input::Number(cut.material.strength, Unit::Megapascal))])?;
        let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(table, "this strength"))?;
        let factor = number(row, "factor")?;
        feed *= factor;
        because.push(Because::row(row, Note::new("feed-strength-factor").with("factor", factor)));
    }
    Ok(Feed { feed: MillimetresPerRev(feed), because })
}

/// The largest nose radius of the table that is not above the tool's: a smaller nose is fed slower.
fn nose_of_table(knowledge: &Knowledge, nose: Micrometres) -> Result<Option<String>, KnowledgeError> {
    let table = knowledge.table("turning-finish-feed")?;
    let radii =
        table.inputs().filter(|(_, column)| column.name == "nose_radius").flat_map(|(_, column)| &column.values);
    let known = radii.filter_map(|text| text.parse::<Micrometres>().ok().map(|radius| (radius, text)));
    Ok(known.filter(|(radius, _)| *radius <= nose).max().map(|(_, text)| text.clone()))
}
