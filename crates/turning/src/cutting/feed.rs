//! Feeds of turning, by the tables.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::units::Megapascals;
use crate::knowledge::{Column, Knowledge, Question};
use crate::note::{Because, Note};
use crate::tables::cutting::{BoringFinishFeedFor, GroovingFeedFor, TurningBoringFeedFor, TurningRoughFeedFor};
use crate::tables::turning::tools::{TurningFinishFeedFor, TurningFinishFeedStrengthFor};
use crate::turning::tooling::{Shank, ToolKind};
use crate::units::{Micrometres, MillimetresPerRev, Roughness};
use technolog_cutting::figures;

use super::{Cut, CuttingRefusal, of_tables};

/// A feed and the rows it rests on.
#[derive(Clone, Debug, PartialEq)]
pub struct Feed {
    /// The feed.
    pub feed: MillimetresPerRev,
    /// Why.
    pub because: Vec<Because>,
}

/// The feed of a roughing pass at a depth (`turning-rough-feed`, `turning-boring-feed`); for a grooving tool its feed
/// at the diameter (`grooving-feed`), whatever the depth. It is the lower end of the handbook's range.
///
/// # Errors The table has no feed for the tool, the diameter or the depth; the tool's row lacks its shank; threads.
pub fn rough_feed(cut: &Cut<'_, '_>, depth: Micrometres) -> Tried<Feed, CuttingRefusal> {
    let (diameter, process) = (cut.diameter, cut.process());
    let lacks = |quantity: &str| Refusal::Not(CuttingRefusal::Figure(cut.tool_lacks(quantity).during(process)));
    let figures = match cut.tool.kind {
        ToolKind::Turning => {
            let Some(Shank::Square { height: shank_height, .. }) = cut.tool.shank else {
                return Err(lacks("shank_height"));
            };
            let question = |material_group| TurningRoughFeedFor { material_group, shank_height, diameter, depth };
            figures::ask(question, cut).map(|figures| figures.map(|row| row.feed_min))
        }
        ToolKind::Boring => {
            let Some(Shank::Round { diameter: bar_diameter }) = cut.tool.shank else {
                return Err(lacks("bar_diameter"));
            };
            let question = |material_group| TurningBoringFeedFor { material_group, bar_diameter, depth };
            figures::ask(question, cut).map(|figures| figures.map(|row| row.feed_min))
        }
        ToolKind::Grooving | ToolKind::FaceGrooving => {
            let question = |material_group| GroovingFeedFor { material_group, diameter };
            figures::ask(question, cut).map(|figures| figures.map(|row| row.feed_min))
        }
        ToolKind::Threading => {
            return Err(Refusal::Not(CuttingRefusal::Threads { tool: cut.tool.designation.to_owned(), process }));
        }
    };
    let no_feed = |lacking| CuttingRefusal::NoFeed { lacking, depth, diameter };
    let figures = cut.named(of_tables(figures)).map_err(|refusal| refusal.map(no_feed))?;
    let feed = figures.row;
    let note = Note::new("turning-feed").with("feed", feed.0).with("tool", cut.tool.designation);
    Ok(Feed { feed, because: figures.because(note) })
}

/// The feed that leaves a roughness, by the nose radius: nine cells are from `boring-finish-feed`, the others from
/// `turning-finish-feed`, for steel multiplied by `turning-finish-feed-strength`. Between two columns the finer one,
/// between two radii the smaller one is taken.
///
/// # Errors The roughness is finer than the table; the tool's row has no nose radius, or one below the table's;
/// threads.
pub fn finish_feed(cut: &Cut<'_, '_>, roughness: Roughness) -> Tried<Feed, CuttingRefusal> {
    let process = cut.process();
    let no_nose = || Refusal::Not(CuttingRefusal::Figure(cut.tool_lacks("nose_radius").during(process)));
    let rest = cut.knowledge.table(TurningFinishFeedFor::TABLE)?;
    let nose = cut.tool.nose_radius.ok_or_else(no_nose)?;
    let nose_radius = nose_of_table(cut.knowledge, nose)?.ok_or_else(no_nose)?;
    let columns = TurningFinishFeedFor::roughness(rest).map(Column::roughness_points);
    let column = columns.into_iter().flatten().filter(|column| *column <= roughness).max();
    let roughness = column.ok_or(Refusal::Not(CuttingRefusal::TooFineToTurn { roughness, process }))?;
    let (mut feed, row) = match rest.ask(&TurningFinishFeedFor { roughness, nose_radius })?.winner()? {
        Some(cell) => (cell.feed.0, cell.row),
        None => {
            let nine = cut.knowledge.ask(&BoringFinishFeedFor { roughness, nose_radius })?;
            let cell = nine.need("this roughness and nose")?;
            (cell.feed.0, cell.row)
        }
    };
    let mut because = vec![Because::row(row, Note::new("turning-finish-feed").with("feed", feed))];
    if cut.material.group == "steel" {
        let question = TurningFinishFeedStrengthFor { strength: Megapascals(cut.material.strength) };
        let rule = cut.knowledge.ask(&question)?.need("this strength")?;
        feed *= rule.factor;
        because.push(Because::row(rule.row, Note::new("feed-strength-factor").with("factor", rule.factor)));
    }
    Ok(Feed { feed: MillimetresPerRev(feed), because })
}

/// The largest nose radius of the table that is not above the tool's: a smaller nose has a slower feed.
fn nose_of_table(knowledge: &Knowledge, nose: Micrometres) -> Result<Option<&str>, KnowledgeError> {
    let table = knowledge.table(TurningFinishFeedFor::TABLE)?;
    let radii = TurningFinishFeedFor::nose_radius(table).into_iter().flat_map(|column| &column.values);
    let known = radii.filter_map(|text| text.parse::<Micrometres>().ok().map(|radius| (radius, text.as_str())));
    Ok(known.filter(|(radius, _)| *radius <= nose).max().map(|(_, text)| text))
}
