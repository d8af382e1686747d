//! The reasons for the plan of one hole: every decision with its row and its rejected candidates.

use std::collections::BTreeMap;

use crate::document::{Block, Document, Inlines, Item};
use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, Source};
use crate::note::{Because, Figure, IntoFigure, Note, TO_BE_GROUND};
use crate::plan::{HolePlan, Plan};
use crate::tables::practice::{FactSource, PracticeSource, ReachSource};
use crate::units::round_to;

use super::named::titled;
use super::words::say;
use super::{Lang, operation_verb, sheet};

/// The reasons of one group of holes, and the sources that they name by letters.
///
/// # Errors
/// A table of sources is missing.
pub fn explain(plan: &Plan, hole: &HolePlan, knowledge: &Knowledge, lang: Lang) -> Result<Document, KnowledgeError> {
    let drawn = plan.part.holes.iter().find(|known| known.name == hole.name);
    let size = drawn.map_or(Figure::Text("".into()), |drawn| (&drawn.diameter).into_figure());
    let mut page = Document::new(
        lang.tag(),
        say!(lang, "explain-title", hole = Figure::called(&hole.name), size = size).trim_end(),
    );
    match &hole.route {
        Some(route) => {
            let (scheme, table) = (Figure::scheme(&route.scheme), route.table.as_str());
            page.heading(2, say!(lang, "explain-scheme", scheme = scheme, table = table));
            page.push(Block::List(reasons(&route.because, knowledge, lang)));
            if !route.alternatives.is_empty() {
                page.heading(2, say!(lang, "explain-others"));
                page.push(Block::List(sheet::route::alternatives(route, lang)));
            }
        }
        None => {
            let own = plan.findings.iter().filter(|finding| finding.hole.as_deref() == Some(hole.name.as_str()));
            page.push(Block::List(own.map(|finding| sentence(&lang.say(&finding.note))).collect()));
        }
    }
    for (index, transition) in hole.transitions.iter().enumerate() {
        let only = transition.operation.is_only_elsewhere();
        let key = match transition.elsewhere {
            true if only => "explain-transition-only-elsewhere",
            true => "explain-transition-elsewhere",
            false => "explain-transition",
        };
        let mut made = Note::new(key)
            .with("number", index + 1)
            .with("verb", operation_verb(transition.operation.name(), lang))
            .with("diameter", transition.diameter_mm);
        if !only {
            made = made
                .with("designation", transition.tool.designation.as_str())
                .with("holder", transition.holder.designation.as_str());
        }
        if !transition.elsewhere {
            made = made.with("tool", transition.tool.number);
        }
        page.heading(2, lang.say(&made));
        page.push(Block::List(reasons(&transition.because, knowledge, lang)));
        if only {
            continue;
        }
        let conditions = &transition.conditions;
        let number = |value, places| Figure::number(round_to(value, places).to_string());
        page.paragraph(say!(
            lang,
            "explain-conditions",
            feed = number(conditions.feed_mm_per_rev.0, 3),
            speed = number(conditions.speed_m_per_min.0, 2),
            rpm = number(conditions.spindle_rpm.0, 1)
        ));
        page.push(Block::List(reasons(&conditions.because, knowledge, lang)));
    }
    let of_route = hole.route.iter().flat_map(|route| &route.because);
    let of_transitions = hole.transitions.iter();
    let of_transitions = of_transitions.flat_map(|made| made.because.iter().chain(&made.conditions.because));
    let sources = named_sources(of_route.chain(of_transitions), knowledge)?;
    if !sources.is_empty() {
        page.heading(2, say!(lang, "explain-sources"));
        let item = |(id, source): (&str, &str)| {
            sentence(&say!(lang, "explain-source", id = Figure::called(id), source = lang.remark(source).into_owned()))
        };
        page.push(Block::List(sources.into_iter().map(item).collect()));
    }
    Ok(page)
}

/// The sources that reasons name by letters, such as QT, with where each is found. Letters that two lists have are those
/// of the list that the reason's own table refers to; else those of facts.
pub(super) fn named_sources<'k, 'r>(
    reasons: impl Iterator<Item = &'r Because>,
    knowledge: &'k Knowledge,
) -> Result<BTreeMap<&'k str, &'k str>, KnowledgeError> {
    let facts: BTreeMap<_, _> = knowledge.rows::<FactSource<'_>>()?.iter().map(|row| (row.id, row.page)).collect();
    let practice: BTreeMap<_, _> =
        knowledge.rows::<PracticeSource<'_>>()?.iter().map(|row| (row.id, row.page)).collect();
    let reach: BTreeMap<_, _> = knowledge.rows::<ReachSource<'_>>()?.iter().map(|row| (row.id, row.page)).collect();
    let mut named = BTreeMap::new();
    for reason in reasons {
        let columns = knowledge.table(&reason.table).map(|table| table.columns.as_slice()).unwrap_or_default();
        let refers =
            |id: &str| columns.iter().any(|column| column.refers.as_ref().is_some_and(|(table, _)| table == id));
        let lists: &[_] = match (refers("practice-sources"), refers("reach-sources")) {
            (true, _) => &[&practice, &facts],
            (_, true) => &[&reach, &facts],
            _ => &[&facts, &practice],
        };
        let texts = std::iter::once(&reason.place).chain(&reason.reason).chain(&reason.unconfirmed);
        for word in texts.flat_map(|text| text.split(|letter: char| !letter.is_alphanumeric())) {
            let found = lists.iter().find_map(|list| list.get_key_value(word));
            named.extend(found.map(|(id, page)| (*id, *page)));
        }
    }
    Ok(named)
}

fn reasons(because: &[Because], knowledge: &Knowledge, lang: Lang) -> Vec<Item> {
    because.iter().map(|reason| reason_item(reason, knowledge, lang)).collect()
}

fn reason_item(reason: &Because, knowledge: &Knowledge, lang: Lang) -> Item {
    let row = reason.row.map(|row| say!(lang, "explain-row", row = row));
    let source = reason.source.map(|source| match source {
        Source::Seed => say!(lang, "explain-seed").to_owned(),
        Source::Standard => say!(lang, "explain-standard").to_owned(),
        Source::Reconstructed => say!(lang, "explain-reconstructed").to_owned(),
    });
    let place = [Some(titled(&reason.table, knowledge, lang)), row, source]
        .into_iter()
        .flatten()
        .collect::<Vec<_>>()
        .join(", ");
    let decided = say!(
        lang,
        "explain-decision",
        decision = reason.note.clone(),
        rests = place,
        place = lang.place(&reason.place)
    );
    let why = reason.reason.iter().map(|why| say!(lang, "explain-reason", why = lang.remark(why).into_owned()));
    let doubt = reason.unconfirmed.iter().map(|why| match why.as_str() {
        TO_BE_GROUND => say!(lang, "explain-to-be-ground", why = lang.remark(why).into_owned()),
        _ => say!(lang, "explain-unconfirmed", why = lang.remark(why).into_owned()),
    });
    let passed = reason.rejected.iter().map(|passed| say!(lang, "explain-not-taken", why = passed.clone()));
    let items = why.chain(doubt).chain(passed).map(|text| sentence(&text)).collect();
    Item { items, ..sentence(&decided) }
}

fn sentence(text: &str) -> Item {
    Inlines::sentence(text).into()
}
