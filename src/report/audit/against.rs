//! Two plans beside each other, as a page: what they state otherwise, then what that costs.

use crate::audit::{Comparison, Cost, Difference};

use super::super::{Lang, grid};
use super::{comma, heading, name, subject};

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
    for chunk in comparison.differences.chunk_by(|a, b| a.section == b.section) {
        let Some(first) = chunk.first() else { continue };
        page.push_str(&format!("\n## {}\n\n", heading(first.section, lang)));
        for difference in chunk {
            page.push_str(&format!("- {}\n", line(difference, lang)));
        }
    }
    if comparison.differences.is_empty() {
        page.push_str(&format!("\n{}\n", none(lang)));
    }
    if !comparison.costs.is_empty() {
        page.push_str(&format!("\n## {}\n\n", costs_heading(lang)));
        for cost in &comparison.costs {
            page.push_str(&format!("- {}\n", cost_line(cost, lang)));
        }
    }
    page
}

fn title(comparison: &Comparison, lang: Lang) -> String {
    let beside = lang.pick("поруч із", "beside");
    format!("{} {beside} {}", comparison.a, comparison.b)
}

fn none(lang: Lang) -> &'static str {
    lang.pick("плани кажуть те саме", "the plans say the same")
}

fn costs_heading(lang: Lang) -> &'static str {
    lang.pick("Чого це коштує", "What it costs")
}

/// `свердління A: подача S 0,25 | 0,325`.
fn line(difference: &Difference, lang: Lang) -> String {
    let about = subject(&difference.subject, lang);
    let what = what(difference, lang);
    let said = |text: &Option<String>| text.clone().unwrap_or_else(|| "-".to_owned());
    let (a, b) = (said(&difference.a), said(&difference.b));
    // A designation has points too, which are no decimal ones.
    let values = format!("{a} | {b}");
    let values = if difference.quantity.is_some() { comma(&values, lang) } else { values };
    if about.is_empty() { format!("{what}: {values}") } else { format!("{about}: {what}: {values}") }
}

fn what(difference: &Difference, lang: Lang) -> String {
    if let Some(quantity) = difference.quantity {
        let factor = difference.what.strip_prefix(quantity.key()).filter(|rest| !rest.is_empty());
        let factor = factor.map(|rest| format!(" ({})", rest.trim_start_matches('.'))).unwrap_or_default();
        return name(quantity, lang) + &factor;
    }
    let (uk, en) = match difference.what.as_str() {
        "row" => ("рядок маршруту", "row of the route"),
        "order" => ("порядок рядків", "order of the rows"),
        "tool" => ("місце інструмента", "place of the tool"),
        "scheme" => ("схема", "scheme"),
        "table" => ("таблиця", "table"),
        "designation" => ("позначення", "designation"),
        "standard" => ("стандарт", "standard"),
        "shank" => ("хвостовик", "shank"),
        "holder" => ("допоміжний інструмент", "holder"),
        "with" => ("слово корекції", "word of the correction"),
        "screw" => ("гвинт", "screw"),
        other => (other, other),
    };
    lang.pick(uk, en).to_owned()
}

/// `машинний час: 2,6 | 2,1 хв (-0,5)`.
fn cost_line(cost: &Cost, lang: Lang) -> String {
    let (uk, en, timed) = match cost.what {
        "machine" => ("машинний час", "machine time", true),
        "rapid" => ("холості ходи", "rapids", true),
        "tool_change" => ("заміни інструмента", "tool changes", true),
        "total" => ("загальний час", "total time", true),
        "changes" => ("кількість замін", "number of changes", false),
        "places" => ("місць у магазині", "places in the magazine", false),
        other => (other, other, false),
    };
    let unit = if timed { lang.pick(" хв", " min") } else { "" };
    let said = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| value.to_string());
    let more = cost.more.map(|more| if more == 0.0 { " (=)".to_owned() } else { format!(" ({more:+})") });
    let text = format!("{}: {} | {}{unit}{}", lang.pick(uk, en), said(cost.a), said(cost.b), more.unwrap_or_default());
    comma(&text, lang)
}
