//! The order of tools and the path of each over the holes of a part, and the path over a list of points.

use serde::Serialize;

use super::Lang;
use super::sheet::route::stops;
use super::sheet::{cell, exactly, number};
use super::words::say;
use crate::document::{Block, Column, Document, Field, Inlines, Item, Table};
use crate::note::{Figure, Finding, IntoFigure};
use crate::part::Point;
use crate::plan::{Plan, Stop, ToolVisit, Visiting};
use crate::units::{Micrometres, Minutes};

/// The order of a part: its tools, their points, and how the holes are visited. `not_kept` are the findings about
/// visiting methods that the machine cannot follow.
pub fn part_page(plan: &Plan, home: Point, not_kept: &[Finding], lang: Lang) -> Document {
    let mut page = Document::new(lang.tag(), say!(lang, "order-title", part = plan.part.part.as_str()));
    let home = say!(lang, "plan-point", x = home.x, y = home.y);
    page.paragraph(say!(lang, "order-there-and-back", home = home));
    if !plan.sequence.is_empty() {
        page.push(table(&plan.sequence, lang));
    }
    let paths = plan.sequence.iter().map(|visit| {
        let mut before = None;
        let apart = plan.by_zero(visit).into_iter().flatten().filter(|stop| before.replace(stop.at) != Some(stop.at));
        let apart: Vec<&Stop> = apart.collect();
        Field::new(format!("T{}", visit.tool), stops(apart, lang))
    });
    page.push(Block::Fields(paths.collect()));
    if !plan.visiting.is_empty() {
        page.heading(2, say!(lang, "order-visiting"));
        page.paragraph(say!(lang, "order-methods"));
        let not_kept = plan.findings.iter().filter(|finding| not_kept.contains(finding)).map(|finding| {
            let hole = finding.hole.as_deref().unwrap_or_default();
            say!(lang, "order-method", hole = hole, why = finding.note.clone()).into()
        });
        page.push(Block::List(plan.visiting.iter().map(|method| visiting(method, lang)).chain(not_kept).collect()));
    }
    page
}

fn table(visits: &[ToolVisit], lang: Lang) -> Table {
    let minutes = lang.word("unit-min");
    let mut table = Table::new([
        Column::text("T"),
        Column::number(say!(lang, "order-stops"), ""),
        Column::number(say!(lang, "order-path"), lang.word("unit-mm")),
        Column::number(say!(lang, "order-rapids"), minutes),
        Column::number(say!(lang, "order-nearest"), minutes),
        Column::number(say!(lang, "order-saved"), "%"),
        Column::number(say!(lang, "order-bound"), minutes),
    ]);
    for visit in visits {
        let (rapid, nearest) = (visit.rapid_min.0, visit.nearest_rapid_min.0);
        table.row([
            Inlines::from(format!("T{}", visit.tool)),
            Inlines::number(visit.stops.len().to_string()),
            cell(visit.path_mm.to_mm(), 1, lang),
            cell(rapid, 3, lang),
            cell(nearest, 3, lang),
            cell(saving(rapid, nearest), 1, lang),
            visit.bound_min.map_or_else(|| super::sheet::NONE.into(), |bound| cell(bound.0, 3, lang)),
        ]);
    }
    table
}

/// The saving, per cent.
fn saving(now: f64, before: f64) -> f64 {
    if before > 0.0 { (1.0 - now / before) * 100.0 } else { 0.0 }
}

/// How the holes of a group are visited, with the times of each method.
fn visiting(visiting: &Visiting, lang: Lang) -> Item {
    let why = Figure::List(visiting.because.iter().map(|why| (&why.note).into_figure()).collect(), "; ");
    let mut items = vec![Item::from(say!(
        lang,
        "order-times-of-methods",
        parallel = exactly(visiting.book_parallel_min.0, 2),
        sequential = exactly(visiting.book_sequential_min.0, 2),
        here = exactly(visiting.sequential_min.0, 2)
    ))];
    if let Some(mixture) = &visiting.mixture {
        let quickest = visiting.book_parallel_min.0.min(visiting.sequential_min.0);
        let (tools, time) = (mixture.sequential_tools, exactly(mixture.time_min.0, 2));
        items.push(Item::from(if mixture.time_min.0 < quickest {
            say!(lang, "order-mixture-quicker", tools = tools, time = time)
        } else {
            say!(lang, "order-mixture-not-quicker", tools = tools, time = time)
        }));
    }
    Item { words: say!(lang, "order-method", hole = visiting.hole.as_str(), why = why).into(), items }
}

/// The title of a tool's path in the drawing.
pub fn visit_title(visit: &ToolVisit, lang: Lang) -> String {
    say!(lang, "order-of-tool", tool = visit.tool, setup = visit.setup, time = exactly(visit.rapid_min.0, 3))
}

/// The path over a list of points.
#[derive(Clone, Debug, Serialize)]
pub struct Tour {
    /// How many points it has.
    pub points: usize,
    /// The measure of distances: `euclid` or `rapid`.
    pub metric: &'static str,
    /// Whether it returns to its first point.
    pub closed: bool,
    /// The tries made: the same number gives the same path again.
    pub tries: u64,
    /// The points by their numbers in the list, from 1.
    pub order: Vec<u64>,
    /// Its length.
    pub length_mm: Micrometres,
    /// Its time, where distances are rapids.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_min: Option<Minutes>,
    /// The length by the textbook's rule, always to the nearest point.
    pub nearest_length_mm: Micrometres,
    /// The time by that rule.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nearest_time_min: Option<Minutes>,
    /// The lower bound of its length. Absent if axes accelerate: then the time is bounded instead.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound_mm: Option<Micrometres>,
    /// The lower bound of its time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound_min: Option<Minutes>,
    /// Whether it is proven that no path is shorter.
    pub optimal: bool,
}

/// The path over a list of points.
pub fn list_page(tour: &Tour, lang: Lang) -> Document {
    let mut page = Document::new(lang.tag(), say!(lang, "order-list-title"));
    let (millimetres, minutes) = (lang.word("unit-mm"), lang.word("unit-min"));
    let length = |value: Micrometres| Inlines::default().quantity(number(value.to_mm(), 3, lang), millimetres);
    let time = |value: Minutes| Inlines::default().quantity(number(value.0, 4, lang), minutes);
    let mut fields = vec![
        Field::new(say!(lang, "order-points"), tour.points.to_string()),
        Field::new(say!(lang, "order-path"), length(tour.length_mm)),
    ];
    fields.extend(tour.time_min.map(|value| Field::new(say!(lang, "order-rapids"), time(value))));
    fields.push(Field::new(say!(lang, "order-nearest-path"), length(tour.nearest_length_mm)));
    fields.extend(tour.nearest_time_min.map(|value| Field::new(say!(lang, "order-nearest"), time(value))));
    // With acceleration the shortest time is sought, not the shortest path.
    let saved = match (tour.time_min, tour.nearest_time_min) {
        (Some(time), Some(book)) => saving(time.0, book.0),
        _ => saving(tour.length_mm.to_mm(), tour.nearest_length_mm.to_mm()),
    };
    fields.push(Field::new(say!(lang, "order-saved"), Inlines::default().quantity(number(saved, 1, lang), "%")));
    fields.extend(tour.bound_mm.map(|bound| Field::new(say!(lang, "order-bound-path"), length(bound))));
    fields.extend(tour.bound_min.map(|bound| Field::new(say!(lang, "order-bound"), time(bound))));
    fields.push(Field::new(say!(lang, "order-tries"), tour.tries.to_string()));
    page.push(Block::Fields(fields));
    if tour.metric == "rapid" {
        page.paragraph(say!(lang, "order-of-slower-axis"));
    }
    page.heading(2, say!(lang, "order-points-in-order"));
    page.paragraph(tour.order.iter().map(u64::to_string).collect::<Vec<_>>().join(" "));
    page
}

/// The title of a list's path in the drawing.
pub fn tour_title(tour: &Tour, lang: Lang) -> String {
    say!(lang, "order-of-list", count = tour.points, length = tour.length_mm)
}
