//! A comparison of two plans as a page: the differences, then the costs.

use crate::note::Figure;
use technolog_audit::{Comparison, Cost, Difference};
use technolog_core::words::unit;
use technolog_document::{Block, Column, Document, Field, Inlines, Table};
use technolog_words::say;

use super::super::Lang;
use super::words::{self, figure, number};
use super::{heading, keys, name, subject};

/// The page: a table for every section with a difference, and one of the costs.
pub fn page(comparison: &Comparison, lang: Lang) -> Document {
    let (a, b) = (lang.word("audit-first-plan"), lang.word("audit-second-plan"));
    let mut page = Document::new(lang.tag(), say!(lang, "audit-against", a = &comparison.a, b = &comparison.b));
    // File names are too long for a table head.
    let file = |plan, file: &str| Field::new(plan, Inlines::default().code(file));
    page.push(Block::Fields(vec![file(a, &comparison.a), file(b, &comparison.b)]));
    for section in comparison.differences.chunk_by(|a, b| a.section == b.section) {
        let Some(first) = section.first() else { continue };
        page.heading(2, heading(first.section, lang));
        let about = [lang.word("audit-column-about"), lang.word("audit-column-what"), a, b];
        let mut table = Table::new(about.map(Column::text));
        for difference in section {
            let [a, b] = [&difference.a, &difference.b]
                .map(|stated| stated.as_ref().map_or_else(not_stated, |text| value(difference, text, lang)));
            table.row(
                [subject(&difference.subject, lang), quantity_text(difference, lang), a, b]
                    .map(|cell| Inlines::sentence(&cell)),
            );
        }
        page.push(table);
    }
    if comparison.differences.is_empty() {
        page.paragraph(lang.word("audit-same"));
    }
    if !comparison.costs.is_empty() {
        page.heading(2, lang.word("audit-costs"));
        let mut columns = vec![Column::text(lang.word("audit-column-what"))];
        columns.extend([a, b, lang.word("audit-column-difference")].map(|head| Column::number(head, "")));
        let mut table = Table::new(columns);
        comparison.costs.iter().for_each(|cost| table.row(costs(cost, lang)));
        page.push(table);
    }
    page
}

/// The text where a plan states nothing.
fn not_stated() -> String {
    "–".to_owned()
}

fn value(difference: &Difference, text: &str, lang: Lang) -> String {
    match difference.key.as_str() {
        _ if difference.quantity.is_some() => figure(text, lang),
        "shank" => lang.term("word", text).to_owned(),
        "scheme" => lang.figure(&Figure::scheme(text)),
        // Points in a designation are no decimal points.
        _ => text.to_owned(),
    }
}

/// The quantity with its unit.
fn quantity_text(difference: &Difference, lang: Lang) -> String {
    let Some(quantity) = difference.quantity else {
        return keys::words(&difference.key, lang).unwrap_or_else(|| difference.key.clone());
    };
    let factor = difference.factor.as_ref();
    let what = factor.map_or_else(|| name(quantity, lang), |factor| words::factor(quantity, factor, lang));
    match unit(quantity.unit(), lang) {
        "" => what,
        unit => say!(lang, "audit-what-in-unit", what = what, unit = unit),
    }
}

/// The cost in both plans, and the difference.
fn costs(cost: &Cost, lang: Lang) -> [Inlines; 4] {
    let shown = |value: Option<f64>| value.map_or_else(not_stated, |value| lang.figure(&number(value)));
    let more = match cost.more {
        None => not_stated(),
        Some(0.0) => "=".to_owned(),
        Some(more) => figure(&format!("{more:+}"), lang),
    };
    let what = lang.find(&format!("audit-cost-{}", cost.kind)).unwrap_or(cost.kind);
    [what.into(), Inlines::number(shown(cost.a)), Inlines::number(shown(cost.b)), Inlines::number(more)]
}
