//! Two plans beside each other, as a page: what they state otherwise, then what that costs.

use technolog_audit::{Comparison, Cost, Difference};

use super::super::{Lang, grid};
use super::words::{self, value};
use super::{comma, heading, keys, marked_table, name, subject};

/// The page for people.
pub fn page(comparison: &Comparison, lang: Lang) -> String {
    let mut page = format!("{}\n", title(comparison, lang));
    for chunk in comparison.differences.chunk_by(|a, b| a.section == b.section) {
        let Some(first) = chunk.first() else { continue };
        page.push_str(&format!("\n{}\n", heading(first.section, lang)));
        for difference in chunk {
            page.push_str(&grid::paragraph(&line(difference, lang), 2));
        }
    }
    if comparison.differences.is_empty() {
        page.push_str(&format!("\n{}\n", none(lang)));
    }
    if !comparison.costs.is_empty() {
        page.push_str(&format!("\n{}\n", costs_heading(lang)));
        for cost in &comparison.costs {
            page.push_str(&grid::paragraph(&cost_line(cost, lang), 2));
        }
    }
    page
}

/// The same for documents.
pub fn markdown(comparison: &Comparison, lang: Lang) -> String {
    let mut page = format!("# {}\n", title(comparison, lang));
    if comparison.differences.is_empty() {
        page.push_str(&format!("\n{}\n", none(lang)));
    }
    for (heading, head, rows) in tables(comparison, lang) {
        page.push_str(&format!("\n## {heading}\n\n{}", marked_table(&head, &rows)));
    }
    page
}

/// A table under a heading: heading, head, rows.
type Table = (&'static str, Vec<String>, Vec<Vec<String>>);

/// A table for every section with a difference, and one of the costs.
pub(super) fn tables(comparison: &Comparison, lang: Lang) -> Vec<Table> {
    let (a, b) = (&comparison.a, &comparison.b);
    let head = [lang.pick("про що", "about"), lang.pick("що", "what"), a, b];
    let sections = comparison.differences.chunk_by(|a, b| a.section == b.section).filter_map(|chunk| {
        let rows = chunk.iter().map(|one| {
            let [a, b] = values(one, lang);
            vec![subject(&one.subject, lang), what(one, lang), a, b]
        });
        Some((heading(chunk.first()?.section, lang), head.map(str::to_owned).to_vec(), rows.collect()))
    });
    let mut tables: Vec<Table> = sections.collect();
    if !comparison.costs.is_empty() {
        let head = [lang.pick("що", "what"), a, b, lang.pick("різниця", "difference")].map(str::to_owned).to_vec();
        let rows = comparison.costs.iter().map(|cost| {
            let (name, unit) = cost_name(cost, lang);
            let [a, b, more] = cost_values(cost, lang);
            vec![if unit.is_empty() { name.to_owned() } else { format!("{name},{unit}") }, a, b, more]
        });
        tables.push((costs_heading(lang), head, rows.collect()));
    }
    tables
}

pub(super) fn title(comparison: &Comparison, lang: Lang) -> String {
    let beside = lang.pick("поруч із", "beside");
    format!("{} {beside} {}", comparison.a, comparison.b)
}

pub(super) fn none(lang: Lang) -> &'static str {
    lang.pick("плани кажуть те саме", "the plans say the same")
}

fn costs_heading(lang: Lang) -> &'static str {
    lang.pick("Чого це коштує", "What it costs")
}

/// `свердління A: подача S: 0,25 | 0,325`.
fn line(difference: &Difference, lang: Lang) -> String {
    let about = subject(&difference.subject, lang);
    let what = what(difference, lang);
    let values = values(difference, lang).join(" | ");
    if about.is_empty() { format!("{what}: {values}") } else { format!("{about}: {what}: {values}") }
}

/// What both say, `-` where one says nothing.
fn values(difference: &Difference, lang: Lang) -> [String; 2] {
    [&difference.a, &difference.b].map(|said| match said {
        None => "-".to_owned(),
        // A designation has points too, which are no decimal ones.
        Some(text) if difference.quantity.is_some() => comma(text, lang),
        Some(text) if difference.what == "shank" => value(text, lang),
        Some(text) => text.clone(),
    })
}

fn what(difference: &Difference, lang: Lang) -> String {
    if let Some(quantity) = difference.quantity {
        let factor = difference.what.strip_prefix(quantity.key()).and_then(|rest| rest.strip_prefix('.'));
        return factor.map_or_else(|| name(quantity, lang), |factor| words::factor(quantity, factor, lang));
    }
    keys::words(&difference.what, lang).unwrap_or_else(|| difference.what.clone())
}

/// `машинний час: 2,6 | 2,1 хв (-0,5)`.
fn cost_line(cost: &Cost, lang: Lang) -> String {
    let (name, unit) = cost_name(cost, lang);
    let [a, b, more] = cost_values(cost, lang);
    let more = if more == "-" { String::new() } else { format!(" ({more})") };
    format!("{name}: {a} | {b}{unit}{more}")
}

/// What costs, and its unit.
fn cost_name(cost: &Cost, lang: Lang) -> (&'static str, &'static str) {
    let (uk, en, timed) = match cost.what {
        "machine" => ("машинний час", "machine time", true),
        "rapid" => ("холості ходи", "rapids", true),
        "tool_change" => ("заміни інструмента", "tool changes", true),
        "total" => ("загальний час", "total time", true),
        "changes" => ("кількість замін", "number of changes", false),
        "places" => ("місць у магазині", "places in the magazine", false),
        other => (other, other, false),
    };
    (lang.pick(uk, en), if timed { lang.pick(" хв", " min") } else { "" })
}

/// What it costs in both and how much more, `-` where that is not known.
fn cost_values(cost: &Cost, lang: Lang) -> [String; 3] {
    let said = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| comma(&value.to_string(), lang));
    let more = |more: f64| if more == 0.0 { "=".to_owned() } else { comma(&format!("{more:+}"), lang) };
    [said(cost.a), said(cost.b), cost.more.map_or_else(|| "-".to_owned(), more)]
}
