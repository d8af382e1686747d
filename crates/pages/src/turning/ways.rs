//! The ways of roughing on a shaft's page: one table, and the one to take.

use crate::document::{Block, Column, Document, Inlines, Item, Keep, Table};
use technolog_turning::ways::{Way, Ways};
use technolog_words::say;

use super::Lang;
use super::cells::{Cell, table};
use super::phrases::{note_line, reasoned, schemes_column, word};
use super::section;

/// The sections; none if there is no stock.
pub(super) fn sections(page: &mut Document, found: &Ways, lang: Lang) {
    let Some(recommended) = &found.recommended else { return };
    section(page, say!(lang, "turn-ways"));
    page.push(side_by_side(found, recommended.variant, lang));
    page.blocks.push(Block::List(remarks(found, lang).into_iter().map(Item::from).collect()));
    section(page, say!(lang, "turn-recommended"));
    page.paragraph(note_line(&recommended.because.note, lang));
    page.paragraph(reasoned(&found.pass_direction, lang));
    let Some(taken) = recommended.variant else { return };
    page.paragraph(say!(lang, "turn-ways-program", name = taken));
    if let Some(scheme) = found.schemes.schemes.iter().find(|scheme| scheme.name == taken) {
        let points: Vec<&str> = scheme.points.iter().map(|point| point.name.as_str()).collect();
        page.paragraph(say!(lang, "turn-points", points = points.join(", ")));
    }
}

fn side_by_side(found: &Ways, taken: Option<&str>, lang: Lang) -> Table {
    let (mm, min) = (say!(lang, "unit-mm"), say!(lang, "unit-min"));
    let columns = [
        Column::text(say!(lang, "turn-taken")),
        schemes_column(say!(lang, "turn-ways-name")),
        Column::text("--variant").keep(Keep::Useful),
        Column::number(say!(lang, "turn-passes"), ""),
        Column::number(say!(lang, "turn-passes-across"), "").keep(Keep::Useful),
        Column::number(say!(lang, "turn-path"), mm),
        Column::number(say!(lang, "turn-time"), min),
    ];
    let row = |way: &Way| {
        let mark = match (taken == Some(way.name), &way.refused) {
            (true, _) => "+",
            (false, Some(_)) => "×",
            (false, None) => "",
        };
        vec![
            mark.into(),
            lang.term("word", way.name).into(),
            way.name.into(),
            Cell::count(way.passes),
            Cell::count(way.transverse_passes),
            Cell::Figure(way.cutting_path_mm.to_mm(), 2),
            Cell::Figure(way.time_min.0, 3),
        ]
    };
    table(columns, found.ways.iter().map(row).collect(), lang)
}

/// Why ways do not hold, and what the schemes of the lecture are.
fn remarks(found: &Ways, lang: Lang) -> Vec<Inlines> {
    let refused = found.ways.iter().filter_map(|way| Some((way, way.refused.as_ref()?)));
    let refused = refused.map(|(way, why)| say!(lang, "turn-ways-refused", way = word(way.name), why = why));
    let schemes = found.schemes.schemes.iter().map(|scheme| {
        let because = &scheme.because;
        let place = lang.place(&because.place);
        say!(lang, "turn-scheme-is", scheme = word(scheme.name), what = &because.note, place = place)
    });
    let leaves = found.ways.iter().filter_map(|way| Some((way, way.leaves.as_ref()?)));
    let leaves = leaves.map(|(way, what)| say!(lang, "turn-ways-leaves", way = word(way.name), what = what));
    refused.chain(leaves).chain(schemes).map(|said| Inlines::sentence(&said)).collect()
}
