//! The section about levels and zones on a shaft's page.

use crate::document::{Column, Document, Keep};
use technolog_tables::turning::passes::Scheme;
use technolog_turning::length::Half;
use technolog_turning::schemes::levels::Levels;
use technolog_turning::schemes::{Schemes, Splitting};
use technolog_words::say;

use super::Lang;
use super::cells::{Cell, arrow, figure, rounded, span, table};
use super::phrases::{schemes_column, terms, word};
use super::section;

/// The section; none if there is no stock.
pub(super) fn section_of_levels(page: &mut Document, found: &Schemes, lang: Lang) {
    if !found.schemes.is_empty() {
        section(page, say!(lang, "turn-levels-and-zones"));
        levels(page, found, lang);
    }
}

fn levels(page: &mut Document, found: &Schemes, lang: Lang) {
    let Splitting { levels: Levels { limit, depth, cylinders }, horizontals, .. } = &found.splitting;
    let depth = rounded(depth.to_mm(), lang);
    page.paragraph(say!(lang, "turn-limiting-depth", limit = limit, depth = depth));
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
    let z = |z: Half| figure(Half::ZERO - z, lang);
    let rows = cylinders.iter().zip(&found.zones).enumerate().map(|(index, (one, zone))| {
        vec![
            Cell::count(index + 1),
            figure(one.radius.diameter(), lang).into(),
            figure(one.blank.diameter(), lang).into(),
            arrow(z(one.from), z(one.to)).into(),
            Cell::Figure(one.stock.to_mm(), 2),
            Cell::Figure(one.passes as f64, 0),
            Cell::Figure(one.mean.to_mm(), 2),
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
