//! Feeds that no tool of the kind bears, whatever our plan has: more than the nose of an insert, more than tables give a drill.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{IntoFigure, Note};
use crate::tables::audit::PaceFigure;
use crate::tables::cutting::{DrillingFeedFor, FeedMultiple, FeedStep};
use crate::tables::practice::{PracticeFeedFor, PracticeWork};
use crate::turning::jobs::{Body, Job};
use crate::turning::tooling::ToolKind;
use crate::units::{Brinell, round_to};
use technolog_core::material::Material;

/// A feed as a share of what bears it.
pub(super) struct Borne {
    pub code: &'static str,
    pub figure: PaceFigure,
    pub share: f64,
    /// What is said of it, but for the tool.
    pub note: Note,
}

impl Borne {
    /// The feed `used`, mm/rev, as a share of `most`.
    pub fn of(figure: PaceFigure, code: &'static str, used: f64, most: f64) -> Self {
        Self { figure, code, share: used / most, note: Note::new(code).with("feed", round_to(used, 3)) }
    }

    pub fn with(self, key: &'static str, value: impl IntoFigure) -> Self {
        Self { note: self.note.with(key, value), ..self }
    }
}

/// The feed `used`, mm/rev, of a tool of ours; none of a kind that nothing is known of. `opened` is whether a smaller drill works
/// in the same program.
///
/// # Errors
/// The knowledge base lacks a table.
pub(super) fn borne(
    job: &Job,
    opened: bool,
    used: f64,
    material: &Material<'_>,
    knowledge: &Knowledge,
) -> Result<Option<Borne>, KnowledgeError> {
    let fed = |figure, code, most: f64| Borne::of(figure, code, used, most);
    match job.tool.body {
        Body::Insert { kind: ToolKind::Turning | ToolKind::Boring, nose_radius_mm, .. } => {
            let radius = nose_radius_mm.to_mm();
            let borne = || fed(PaceFigure::NoseFeed, "turned-feed-nose", radius);
            Ok((radius > 0.0).then(borne).map(|borne| borne.with("radius", radius)))
        }
        Body::Drill { diameter_mm: diameter, .. } => {
            let (material_group, hardness) = (material.group, Brinell(material.hardness));
            let practice = PracticeFeedFor { operation: PracticeWork::Drill, material_group, diameter };
            let practice = knowledge.winner_within(&practice)?;
            let handbook = DrillingFeedFor { material_group, hardness, diameter };
            let handbook = knowledge.winner_within(&handbook)?;
            let both = [practice.map(|row| row.feed_high.0), handbook.map(|row| row.feed_max.0)];
            let Some(solid) = both.into_iter().flatten().max_by(f64::total_cmp) else { return Ok(None) };
            let multiple = if opened { FeedMultiple::Handbook } else { FeedMultiple::Single };
            let high = solid * knowledge.need(multiple.name(), |step: &FeedStep<'_>| step.name == multiple)?.factor;
            let borne = fed(PaceFigure::DrillFeed, "turned-feed-drill", high);
            Ok(Some(borne.with("high", round_to(high, 3)).with("diameter", diameter)))
        }
        _ => Ok(None),
    }
}
