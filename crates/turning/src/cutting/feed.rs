//! Feeds of turning, by the tables.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::contract::TableRow;
use crate::knowledge::{Column, Knowledge, Question};
use crate::note::{Because, Note};
use crate::tables::cutting::{BoringFinishFeedFor, GroovingFeedFor, TurningBoringFeedFor, TurningRoughFeedFor};
use crate::tables::turning::tools::{
    InsertNoseFeed, Limit, TurningCutBackFor, TurningFinishFeedFor, TurningRoughnessUnsaidFor,
};
use crate::turning::tooling::{Shank, ToolKind, TurningTool};
use crate::units::{Degrees, ItGrade, Micrometres, MillimetresPerRev, Roughness};
use technolog_cutting::figures;

use super::{CuttingRefusal, TurningCut, bounds, of_tables};

/// A feed and its rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Feed {
    /// The feed.
    pub feed: MillimetresPerRev,
    /// Why.
    pub because: Vec<Because>,
}

/// The feed of a roughing pass at a depth (`turning-rough-feed`, `turning-boring-feed`); for a grooving tool its feed
/// at the diameter (`grooving-feed`), whatever the depth. It is the lower end of the handbook's range, and no more than the
/// nose bears (`insert-nose-feed`).
///
/// # Errors
/// The table has no feed for the tool, the diameter or the depth; the tool's row lacks its shank; threads.
pub fn rough_feed(cut: &TurningCut<'_, '_>, depth: Micrometres) -> Tried<Feed, CuttingRefusal> {
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
    let mut because = figures.because(note);
    match nose_feed(cut)?.filter(|(most, _)| *most < feed) {
        Some((most, row)) => {
            because.push(row);
            Ok(Feed { feed: most, because })
        }
        None => Ok(Feed { feed, because }),
    }
}

/// The largest feed that the nose of an insert bears in roughing: a share of its radius (`insert-nose-feed`), to 0.01
/// mm/rev downwards. None where nose or shape are not known.
fn nose_feed(cut: &TurningCut<'_, '_>) -> Result<Option<(MillimetresPerRev, Because)>, KnowledgeError> {
    let (Some(nose), Some(shape)) = (cut.tool.nose_radius, cut.tool.insert_shape()) else { return Ok(None) };
    let Some(row) = cut.knowledge.find(|row: &InsertNoseFeed<'_>| row.shape == shape)? else { return Ok(None) };
    let most = (row.share * nose.to_mm() * 100.0 + 1e-9).floor() / 100.0;
    let note = Note::new("feed-bound-by-nose").with("feed", most).with("share", row.share).with("radius", nose);
    Ok(Some((MillimetresPerRev(most), Because::row(row.row, note))))
}

/// Whether a reason is that the nose bounds the roughing feed.
pub fn is_nose_bound(because: &Because) -> bool {
    because.table == InsertNoseFeed::CONTRACT.which.id()
}

/// The feed that leaves a roughness, by the nose radius: nine cells are from `boring-finish-feed`, the others from
/// `turning-finish-feed`. Between two columns the finer one, between two radii the smaller one is taken. It is never above what nose and roughness leave by geometry:
///
/// s ≤ √(31.2·Ra·r/(1000·k)), mm/rev, with Ra in µm, r in mm and k of `turning-limits`, the ratio of real to
/// theoretical roughness (Ra = 1000·s²/(31.2·r)).
///
/// # Errors
/// The roughness is finer than the table; the tool's row has no nose radius, or one below the table's;
/// threads.
pub fn finish_feed(cut: &TurningCut<'_, '_>, roughness: Roughness) -> Tried<Feed, CuttingRefusal> {
    let process = cut.process();
    let no_nose = || Refusal::Not(CuttingRefusal::Figure(cut.tool_lacks("nose_radius").during(process)));
    let rest = cut.knowledge.table(TurningFinishFeedFor::TABLE)?;
    let nose = cut.tool.nose_radius.ok_or_else(no_nose)?;
    let nose_radius = nose_of_table(cut.knowledge, nose)?.ok_or_else(no_nose)?;
    let columns = TurningFinishFeedFor::roughness(rest).map(Column::roughness_points);
    let column = columns.into_iter().flatten().filter(|column| *column <= roughness).max();
    let asked = roughness;
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
    let (factor, of_factor) = bounds::ratio(cut.knowledge, Limit::RoughnessPracticeFactor)?;
    let most = feed_of_nose(asked, nose, factor).0;
    if most < feed {
        // Rounded down, so that the surface is never rougher.
        feed = (most * 1000.0).floor() / 1000.0;
        let note = Note::new("feed-of-nose").with("feed", feed).with("radius", nose).with("factor", factor);
        because.push(Because { note, ..of_factor });
    }
    Ok(Feed { feed: MillimetresPerRev(feed), because })
}

/// The feed at which a nose leaves a roughness, where the surface is so much rougher than the geometrical one:
/// s = √(31.2·Ra·r/(1000·k)).
pub fn feed_of_nose(roughness: Roughness, nose: Micrometres, rougher: f64) -> MillimetresPerRev {
    MillimetresPerRev(libm::sqrt(ARC * roughness.ra_um() * nose.to_mm() / (1000.0 * rougher)))
}

/// Ra of a row of arcs: s²/(18·√3·r), so that s² = 31.18·r·Ra; tables of makers print 31.2.
const ARC: f64 = 31.2;

/// The roughness to be finished where the drawing gives none, by the grade of the surface (rule
/// `turning-roughness-unsaid`).
///
/// # Errors
/// The knowledge base lacks the rule, or a row of it.
pub fn unsaid_roughness(grade: Option<ItGrade>, knowledge: &Knowledge) -> Result<(Roughness, Because), KnowledgeError> {
    let asked = knowledge.ask(&TurningRoughnessUnsaidFor { it: grade })?;
    let roughness = asked.need("this grade")?.roughness;
    Ok((roughness, Because::answer(&asked.answer, Note::new("roughness-unsaid").with("roughness", roughness))))
}

/// Whether a tool may cut on its return (rule `turning-cut-back`), with its second edge, whose angle is φ1. A zigzag
/// requires it.
///
/// # Errors
/// The knowledge base lacks the rule, or a row of it.
pub fn cuts_back(tool: &TurningTool<'_>, knowledge: &Knowledge) -> Result<(bool, Because), KnowledgeError> {
    let asked = knowledge.ask(&TurningCutBackFor { trail_angle: Degrees(tool.trail_angle.to_f64()) })?;
    let back = asked.need(tool.designation)?.cuts_back;
    let note = Note::new(if back { "cuts-back" } else { "cuts-not-back" });
    let note = note.with("tool", tool.designation).with("angle", tool.trail_angle);
    Ok((back, Because::answer(&asked.answer, note)))
}

/// The largest nose radius in the table that is not above the tool's, because a smaller nose has a slower feed.
fn nose_of_table(knowledge: &Knowledge, nose: Micrometres) -> Result<Option<&str>, KnowledgeError> {
    let table = knowledge.table(TurningFinishFeedFor::TABLE)?;
    let radii = TurningFinishFeedFor::nose_radius(table).into_iter().flat_map(|column| &column.values);
    let known = radii.filter_map(|text| text.parse::<Micrometres>().ok().map(|radius| (radius, text.as_str())));
    Ok(known.filter(|(radius, _)| *radius <= nose).max().map(|(_, text)| text))
}
