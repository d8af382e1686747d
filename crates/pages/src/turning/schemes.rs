//! The sections about levels, zones and schemes on a shaft's page.

use crate::document::{Block, Column, Document, Inlines, Item, Keep, Table};
use technolog_tables::turning::passes::Scheme;
use technolog_turning::schemes::{Schemes, Splitting};
use technolog_words::say;

use super::Lang;
use super::cells::{Cell, arrow, figure, rounded, span, table};
use super::phrases::{note_line, schemes_column, terms, word};
use super::section;

/// The sections; none if there is no stock.
pub(super) fn sections(page: &mut Document, found: &Schemes, lang: Lang) {
    let Some(best) = &found.best_scheme else { return };
    section(page, say!(lang, "turn-levels-and-zones"));
    levels(page, found, lang);
    section(page, say!(lang, "turn-schemes"));
    page.push(schemes(found, lang));
    let what = found.schemes.iter().map(|scheme| {
        let (because, name) = (&scheme.because, word(scheme.name));
        Inlines::sentence(&say!(
            lang,
            "turn-scheme-is",
            scheme = name,
            what = &because.note,
            place = lang.place(&because.place)
        ))
    });
    page.blocks.push(Block::List(what.map(Item::from).collect()));
    page.paragraph(note_line(&best.because.note, lang));
    if let Some(scheme) = found.schemes.iter().find(|scheme| scheme.name == best.scheme) {
        let points: Vec<&str> = scheme.points.iter().map(|point| point.name.as_str()).collect();
        page.paragraph(say!(lang, "turn-points", points = points.join(", ")));
    }
}

fn levels(page: &mut Document, found: &Schemes, lang: Lang) {
    let Splitting { limiting_depth_mm, depth_mm, cylinders, horizontals, .. } = &found.splitting;
    let depth = rounded(depth_mm.to_mm(), lang);
    page.paragraph(say!(lang, "turn-limiting-depth", limit = limiting_depth_mm, depth = depth));
    let mm = say!(lang, "unit-mm");
    let columns = [
        Column::number(lang.word("cli-row-number"), ""),
        span("Ø", mm),
        span(say!(lang, "turn-from-diameter"), mm).keep(Keep::Optional),
        span("Z", mm),
        Column::number("t", mm).keep(Keep::Optional),
        Column::number("i", "").keep(Keep::Useful),
        Column::number("t/i", mm),
        Column::text(say!(lang, "turn-zone")),
        schemes_column(say!(lang, "turn-scheme-of-passes")),
    ];
    let schemes = |all: &[Scheme]| terms(all.iter().map(|scheme| scheme.name()), " + ", lang);
    let rows = cylinders.iter().zip(&found.zones).enumerate().map(|(index, (one, zone))| {
        vec![
            Cell::count(index + 1),
            figure(one.diameter_mm, lang).into(),
            figure(one.blank_diameter_mm, lang).into(),
            arrow(figure(one.from_z_mm, lang), figure(one.to_z_mm, lang)).into(),
            Cell::Figure(one.stock_mm.to_mm(), 2),
            Cell::Figure(one.passes as f64, 0),
            Cell::Figure(one.mean_depth_mm.to_mm(), 2),
            lang.term("word", zone.zone.name()).into(),
            schemes(&zone.schemes).into(),
        ]
    });
    let mut cylinders_table = table(columns, rows.collect(), lang);
    cylinders_table.notes.push(say!(lang, "turn-levels-key").into());
    page.push(cylinders_table);
    for section in horizontals {
        let list: Vec<String> = section.diameters_mm.iter().map(|diameter| figure(diameter, lang)).collect();
        let z = figure(section.from_z_mm, lang);
        page.paragraph(say!(lang, "turn-horizontals", z = z, diameters = list.join(" → ")));
    }
    if let Some(whole) = found.zones.get(cylinders.len()) {
        let zone = word(whole.zone.name());
        page.paragraph(say!(lang, "turn-whole-zone", zone = zone, schemes = schemes(&whole.schemes)));
    }
}

fn schemes(found: &Schemes, lang: Lang) -> Table {
    let (mm, min) = (say!(lang, "unit-mm"), say!(lang, "unit-min"));
    let columns = [
        schemes_column(say!(lang, "turn-scheme")),
        Column::number(say!(lang, "turn-passes"), ""),
        Column::number(say!(lang, "turn-cutting"), mm),
        Column::number(say!(lang, "turn-idle"), mm),
        Column::number(say!(lang, "turn-time"), min),
    ];
    let rows = found.schemes.iter().map(|scheme| {
        let measures = &scheme.measures;
        vec![
            lang.term("word", scheme.name).into(),
            Cell::count(measures.passes),
            Cell::Figure(measures.cutting_mm.to_mm(), 1),
            Cell::Figure(measures.idle_mm, 1),
            Cell::Figure(measures.time_min.0, 3),
        ]
    });
    table(columns, rows.collect(), lang)
}
