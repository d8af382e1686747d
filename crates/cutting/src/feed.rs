//! Finds the feed: the rule `feed-choice` names the table and the factor.

use crate::error::{KnowledgeError, Tried};
use crate::knowledge::units::Brinell;
use crate::knowledge::{Column, Question, Table};
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::reason::Uncut;
use crate::tables::cutting::{
    CentringFeedFor, CoreDrillingFeedFor, CounterboringFeedFor, DrillingFeedFor, FeedCondition, FeedFactor, FeedStep,
    ReamingFeedFor,
};
use crate::tables::practice::{PracticeFeed, PracticeFeedFor, PracticeWork};
use crate::tables::rules::{FeedChoice, FeedChoiceFor, FeedTable};
use crate::units::{Micrometres, MillimetresPerRev, round_to};

use super::card::CardDoubt;
use super::factors::ByDepth;
use super::figures::{Asking, Figures};
use super::{Cut, factors, figures};

/// A feed and the rows behind it.
pub(super) struct Feed {
    pub feed: MillimetresPerRev,
    pub because: Vec<Because>,
    /// What the cards cannot give for the feed.
    pub doubts: Vec<CardDoubt>,
}

impl Feed {
    /// The same with the feed `taken`, if given, in place of the tabulated one.
    pub fn with_feed(self, taken: Option<MillimetresPerRev>) -> Self {
        Self { feed: taken.unwrap_or(self.feed), ..self }
    }
}

/// The tabulated feed of a drill, core drill or reamer with its corrections.
pub(super) fn tabulated<'k>(cut: &Cut, shop: &impl Asking<'k>) -> Tried<Feed, Uncut> {
    let knowledge = shop.knowledge();
    let material_group = shop.material().group;
    let question = FeedChoiceFor { operation: cut.operation, method: shop.method(), material_group };
    let choice = knowledge.ask(&question)?.need(cut.operation.name())?;
    let multiple = choice.multiple;
    let multiple = knowledge.need(multiple.name(), |step: &FeedStep<'_>| step.name == multiple)?.factor;
    let (figures, asked_at) = upper(&choice, cut, shop)?;
    let mut feed = figures.row.0 * multiple;
    let mut note = Note::new("feed").with("upper", figures.row.0).with("multiple", multiple);
    if let Some(diameter) = asked_at {
        note = note.with("asked-at", diameter);
    }
    let (mut because, mut doubts) = (figures.because(note), Vec::new());
    because.push(Because::row(choice.row, Note::new("feed-choice")));
    if choice.within_practice {
        let question = PracticeFeedFor { operation: PracticeWork::Drill, material_group, diameter: cut.diameter };
        let practice = knowledge.winner_within(&question)?;
        let most = |row: &PracticeFeed<'_>| row.feed_high.0 * multiple;
        if let Some(row) = practice.filter(|row| most(row) < feed) {
            let note = Note::new("feed-within-practice")
                .with("table", round_to(feed, 3))
                .with("practice", row.feed_high.0)
                .with("multiple", multiple);
            feed = most(&row);
            because.push(Because::row(row.row, note));
        }
    }
    // The cards give the feed of the point itself, too; their factor of the material follows in `card`.
    if matches!(cut.operation, Operation::Drill | Operation::DrillOut) {
        let ByDepth { factor: (factor, reason), left_out } = factors::feed_by_depth(cut, shop)?;
        feed *= factor;
        because.push(reason);
        doubts.extend(left_out);
        if cut.reamer_follows && choice.eased {
            let condition = FeedCondition::BeforeFinishing;
            let row = knowledge.need(condition.name(), |row: &FeedFactor<'_>| row.condition.is(condition))?;
            feed *= row.factor;
            because.push(Because::row(row.row, Note::new("feed-before-finishing").with("factor", row.factor)));
        }
    }
    Ok(Feed { feed: MillimetresPerRev(feed), because, doubts })
}

/// A tabulated feed, and the diameter of the query where it is not that of the cut.
type Upper<'k> = (Figures<'k, MillimetresPerRev>, Option<Micrometres>);

/// The upper end of the feeds in the table that a choice names.
fn upper<'k>(choice: &FeedChoice<'_>, cut: &Cut, shop: &impl Asking<'k>) -> Tried<Upper<'k>, Uncut> {
    let hardness = Brinell(shop.material().hardness);
    match choice.feed_table {
        FeedTable::Centring => at(
            CentringFeedFor::diameter,
            |material_group, diameter| CentringFeedFor { material_group, diameter },
            |row| row.feed,
            (cut, shop),
        ),
        FeedTable::Drilling => at(
            DrillingFeedFor::diameter,
            |material_group, diameter| DrillingFeedFor { material_group, hardness, diameter },
            |row| row.feed_max,
            (cut, shop),
        ),
        FeedTable::CoreDrilling => at(
            CoreDrillingFeedFor::diameter,
            |material_group, diameter| CoreDrillingFeedFor { material_group, hardness, diameter },
            |row| row.feed_max,
            (cut, shop),
        ),
        FeedTable::Reaming => at(
            ReamingFeedFor::diameter,
            |material_group, diameter| ReamingFeedFor { material_group, hardness, diameter },
            |row| row.feed,
            (cut, shop),
        ),
        FeedTable::Counterboring => at(
            CounterboringFeedFor::diameter,
            |material_group, diameter| CounterboringFeedFor { material_group, hardness, diameter },
            |row| row.feed,
            (cut, shop),
        ),
        FeedTable::Boring => Err(KnowledgeError::no_row(choice.row.table, "what is not bored").into()),
    }
}

/// The feed of one table; `column` is the column of the diameter.
fn at<'k, Q: Question, A: Asking<'k>>(
    column: impl Fn(&Table) -> Option<&Column>,
    question: impl Fn(&'k str, Micrometres) -> Q,
    feed: impl FnOnce(Q::Row<'k>) -> MillimetresPerRev,
    (cut, shop): (&Cut, &A),
) -> Tried<Upper<'k>, Uncut> {
    let diameter = cut.feed_diameter.unwrap_or(cut.diameter);
    let first = first_above(diameter, column(shop.knowledge().table(Q::TABLE)?));
    let figures = figures::ask(|group| question(group, first.unwrap_or(diameter)), shop)?;
    Ok((figures.map(feed), first))
}

/// The first diameter of a table, where the required one is smaller (a centring spot of 1.8 mm).
fn first_above(diameter: Micrometres, column: Option<&Column>) -> Option<Micrometres> {
    let (first, _) = *column?.domain.as_ref()?.intervals().first()?;
    (diameter.micrometres() < first).then(|| Micrometres::new(first))
}
