//! The zones with their tools and depths, and those of additional elements.

use crate::document::{Block, Column, Document, Inlines, Item, Keep};
use crate::note::{Figure, Note};
use technolog_turning::contour::Side;
use technolog_turning::cutting::{LimitingDepth, is_nose_bound};
use technolog_turning::length::Half;
use technolog_turning::operation::work::ZoneWork;
use technolog_turning::operation::{Operation, SetUpWork, SideWork};
use technolog_turning::zones::Feed;
use technolog_words::say;

use super::super::cells::{Cell, fixed, rounded, span, table};
use super::super::phrases::{reasoned, terms, word, z};
use super::super::{Lang, section};

/// The columns of a table of zones, behind the two that name a zone.
fn columns(named: [Column; 2], lang: Lang) -> Vec<Column> {
    let mm = say!(lang, "unit-mm");
    let own = [
        span("Z", mm),
        span("Ø", mm),
        span("φ", "°").keep(Keep::Optional),
        span("φ1", "°").keep(Keep::Optional),
        // A designation stays on one line.
        Column::text(say!(lang, "turn-tool")).min_width(14),
        Column::number(lang.say(&Note::new("turn-limit")), mm).keep(Keep::Useful),
        span(lang.say(&Note::new("turn-depth-of-pass")), mm),
        Column::text(say!(lang, "turn-scheme")),
    ];
    named.into_iter().chain(own).collect()
}

/// A row of such a table.
fn row(named: [Cell; 2], one: &ZoneWork, lang: Lang) -> Vec<Cell> {
    let figures = [
        one.tool.as_ref().map_or(say!(lang, "turn-no-tool"), |tool| tool.designation.as_str()).into(),
        one.depth.as_ref().map_or_else(Cell::empty, |depth| Cell::Figure(depth.limiting_depth_mm.to_mm(), 2)),
        depths(one, lang).into(),
        schemes(one, lang).into(),
    ];
    named.into_iter().chain(bounds(one, lang)).chain(figures).collect()
}

pub(super) fn zones(page: &mut Document, operation: &Operation, lang: Lang) {
    let columns = columns(
        [
            Column::text(say!(lang, "turn-zone")).min_width(6),
            Column::text(say!(lang, "turn-zone-kind")).keep(Keep::Useful),
        ],
        lang,
    );
    let of_zone = |(set_up, side, one): (&SetUpWork, &SideWork, &ZoneWork)| {
        let kind = match one.zone.feed {
            Feed::Across => say!(lang, "turn-zone-face"),
            Feed::Along => lang.term("word", one.zone.kind.name()),
        };
        row([place(set_up, side, one, lang).into(), kind.into()], one, lang)
    };
    let mut zones = table(columns, operation.zones().map(of_zone).collect(), lang);
    zones.notes.push(lang.say(&Note::new("turn-zones-key")).into());
    page.push(zones);
    let mut items: Vec<Item> = Vec::new();
    for (set_up, side, one) in operation.zones() {
        let name = place(set_up, side, one, lang);
        if let Some(limit) = one.depth.as_ref().and_then(|depth| depth.limit.as_ref()) {
            items.push(limits(&name, limit, lang).into());
        }
        if let Some(returns) = one.returns.filter(|returns| returns.saved > 0) {
            let note = Note::new("returns-saved").with("depth", returns.depth_mm);
            let note = note.with("joined", returns.joined).with("split", returns.split);
            items.push(say!(lang, "turn-of-zone", zone = name.as_str(), said = note).into());
        }
        items.extend(one.fit.refused.iter().map(|refused| refused_tool(&name, &refused.tool, &refused.why, lang)));
    }
    if !items.is_empty() {
        page.blocks.push(Block::List(items));
    }
}

/// The section of the zones under the bridges; where no tool fits, with the reason for each. None if there are no
/// such zones.
pub(super) fn additional(page: &mut Document, operation: &Operation, lang: Lang) {
    let columns =
        columns([Column::number(say!(lang, "turn-set-up-column"), ""), Column::text(say!(lang, "turn-side"))], lang);
    let (mut rows, mut items) = (Vec::new(), Vec::new());
    let sides = operation.set_ups.iter().flat_map(|set_up| set_up.sides.iter().map(move |side| (set_up, side)));
    for (set_up, side) in sides {
        for zone in side.hollows.iter().flat_map(|hollow| &hollow.zones) {
            let span = say!(
                lang,
                "turn-closed-zone",
                number = set_up.set_up.number,
                from = z(zone.zone.from_z, lang),
                to = z(zone.zone.to_z, lang)
            );
            if zone.tool.is_none() {
                items.extend(
                    zone.fit.refused.iter().map(|refused| refused_tool(&span, &refused.tool, &refused.why, lang)),
                );
            }
            let depth = zone.depth.as_ref();
            if let Some(limit) = depth.and_then(|depth| depth.limit.as_ref()) {
                items.push(limits(&span, limit, lang).into());
            }
            for work in &zone.works {
                let because = work.pace.conditions.iter().flat_map(|found| &found.because);
                let nose_bound = because.into_iter().find(|reason| is_nose_bound(reason));
                items.extend(nose_bound.map(|nose_bound| Item::from(reasoned(nose_bound, lang))));
            }
            items.dedup();
            let number = Cell::count(usize::from(set_up.set_up.number));
            rows.push(row([number, lang.term("turn-side", side.side.name()).into()], zone, lang));
        }
    }
    if rows.is_empty() {
        return;
    }
    section(page, say!(lang, "turn-closed-zones"));
    let mut zones = table(columns, rows, lang);
    zones.notes.push(lang.say(&Note::new("turn-zones-key")).into());
    page.push(zones);
    if !items.is_empty() {
        page.blocks.push(Block::List(items));
    }
}

/// The position of a zone, and the angles it requires, before those of its tool.
fn bounds(work: &ZoneWork, lang: Lang) -> [Cell; 4] {
    let zone = &work.zone;
    let diameter = |radius: Half| rounded(2.0 * radius.to_mm(), lang);
    let angle = |needs: f64, has: Option<f64>| match has {
        Some(has) => format!("{} ≤ {}", rounded(needs, lang), rounded(has, lang)),
        None => rounded(needs, lang),
    };
    let has = work.tool.as_ref().filter(|tool| tool.width_mm.is_none());
    [
        format!("{} → {}", z(zone.from_z, lang), z(zone.to_z, lang)).into(),
        // The nose passes the axis, but there is no metal beyond it.
        format!("{}…{}", diameter(zone.least_radius.max(Half::ZERO)), diameter(zone.greatest_radius)).into(),
        angle(zone.needs.main.0, has.map(|tool| tool.main_angle_deg.0)).into(),
        angle(zone.needs.secondary.0, has.map(|tool| tool.secondary_angle_deg.0)).into(),
    ]
}

/// The depth of the passes of each work.
fn depths(zone: &ZoneWork, lang: Lang) -> String {
    let depths: Vec<String> = zone.works.iter().map(|work| fixed(work.levels.depth.to_mm(), 2, lang)).collect();
    depths.join("; ")
}

fn schemes(zone: &ZoneWork, lang: Lang) -> String {
    terms(zone.works.iter().filter_map(|work| Some(work.taken?.name())), " + ", lang)
}

/// The depth that each limit permits.
fn limits(zone: &str, limit: &LimitingDepth, lang: Lang) -> String {
    let bounds = limit.bounds.iter().map(|bound| {
        let depth = bound.depth_mm.map_or_else(|| Figure::number("0"), |depth| Figure::number(depth.to_string()));
        say!(lang, "turn-bound", bound = word(bound.bound.name()), depth = depth)
    });
    let bounds: Vec<String> = bounds.collect();
    let feed = Figure::number(limit.feed_mm_per_rev.0.to_string());
    say!(
        lang,
        "turn-limits",
        zone = zone,
        feed = feed,
        bound = word(limit.decided_by.name()),
        bounds = bounds.join("; ")
    )
}

fn refused_tool(zone: &str, tool: &str, why: &[Note], lang: Lang) -> Item {
    let why: Vec<String> = why.iter().map(|why| lang.say(why)).collect();
    Inlines::sentence(&say!(lang, "turn-tool-refused", zone = zone, tool = tool, why = why.join("; "))).into()
}

/// `1.2`: the second zone of the first set-up; for a bore with its side.
pub(super) fn place(set_up: &SetUpWork, side: &SideWork, zone: &ZoneWork, lang: Lang) -> String {
    let place = format!("{}.{}", set_up.set_up.number, zone.zone.number);
    match side.side {
        Side::Outer => place,
        Side::Inner => say!(lang, "turn-zone-inner", zone = place),
    }
}
