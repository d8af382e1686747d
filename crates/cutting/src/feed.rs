//! Where a feed comes from: the rule `feed-choice` names the table and the multiple.

use crate::error::{KnowledgeError, Tried};
use crate::knowledge::{Input, Knowledge, RowRef};
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::units::{Micrometres, MillimetresPerRev, Unit};

use super::card::CardDoubt;
use super::factors::ByDepth;
use super::{Cut, factors, figures};

/// A feed and the rows behind it.
pub(super) struct Feed {
    pub feed: MillimetresPerRev,
    pub because: Vec<Because>,
    /// What the cards leave out of it.
    pub doubts: Vec<CardDoubt>,
}

impl Feed {
    /// The same with the feed taken in place of the tabulated one.
    pub fn or(self, taken: Option<MillimetresPerRev>) -> Self {
        Self { feed: taken.unwrap_or(self.feed), ..self }
    }
}

/// The tabulated feed of a drill, core drill or reamer with its corrections.
pub(super) fn tabulated(cut: &Cut<'_>, shop: &Shop<'_>) -> Tried<Feed, Uncut> {
    let knowledge = shop.knowledge;
    let rule = knowledge.table("feed-choice")?;
    let choice =
        rule.decide(&[("operation", Input::Text(cut.operation.name())), ("method", Input::Text(shop.method.name()))])?;
    let choice = choice.winner().ok_or_else(|| KnowledgeError::no_row(rule, cut.operation.name()))?;
    let multiple = multiple(choice, knowledge)?;
    let table = knowledge.table(choice.text("feed_table")?)?;
    let (diameter, clamped) = inside_domain(cut.feed_diameter.unwrap_or(cut.diameter), table);
    let hardness = Input::Number(shop.material.hardness, Unit::Brinell);
    let figures = figures::ask(&table.id, &[("hardness", hardness), ("diameter", Input::Length(diameter))], shop)?;
    let row = figures.row;
    let upper =
        row.number_in("feed_max", Unit::MillimetrePerRev).or_else(|_| row.number_in("feed", Unit::MillimetrePerRev))?;
    let mut feed = upper * multiple;
    let mut note = Note::new("feed").with("upper", upper).with("multiple", multiple);
    if clamped {
        note = note.with("asked-at", diameter);
    }
    let (mut because, mut doubts) = (figures.because(note), Vec::new());
    because.push(Because::row(choice, Note::new("feed-choice")));
    // The cards give the feed of the point itself, too; their factor of the material follows in `card`.
    if matches!(cut.operation, Operation::Drill | Operation::DrillOut) {
        let ByDepth { factor: (factor, reason), left_out } = factors::by_depth("depth-feed-factor", cut, shop)?;
        feed *= factor;
        because.push(reason);
        doubts.extend(left_out);
        if cut.reamer_follows {
            let table = knowledge.table("feed-factor")?;
            let condition = "before-accurate-finishing-or-tapping";
            let row = table.find("condition", condition).ok_or_else(|| KnowledgeError::no_row(table, condition))?;
            let factor = row.number_in("factor", Unit::None)?;
            feed *= factor;
            because.push(Because::row(row, Note::new("feed-before-finishing").with("factor", factor)));
        }
    }
    Ok(Feed { feed: MillimetresPerRev(feed), because, doubts })
}

fn multiple(choice: RowRef<'_>, knowledge: &Knowledge) -> Result<f64, KnowledgeError> {
    let steps = knowledge.table("feed-step")?;
    let name = choice.text("multiple")?;
    let row = steps.find("name", name).ok_or_else(|| KnowledgeError::no_row(steps, name))?;
    Ok(row.number_in("factor", Unit::None)?)
}

/// A diameter below the table's first (a centring spot of 1.8 mm) is asked at the table's first.
fn inside_domain(diameter: Micrometres, table: &crate::knowledge::Table) -> (Micrometres, bool) {
    let domain =
        table.columns.iter().find(|column| column.name == "diameter").and_then(|column| column.domain.as_ref());
    let bounds = domain.and_then(|domain| domain.intervals().first().zip(domain.intervals().last()));
    match bounds {
        Some((first, _)) if diameter.micrometres() < first.0 => (Micrometres::new(first.0), true),
        _ => (diameter, false),
    }
}
