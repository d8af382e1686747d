//! The norm of time: its elements with their rows, and the formulas with their figures.

use crate::document::{Column, Document, Inlines, Table};
use crate::job::{Norm, NormItem};
use crate::knowledge::Knowledge;
use crate::note::{Because, Figure};
use crate::units::Minutes;

use super::super::sheet::{MARK, NONE, cell, exactly, rounded};
use super::super::why::named_sources;
use super::super::words::say;
use super::{Lang, Sources};

/// The section; a part that is not made whole has no norm.
pub(super) fn section(page: &mut Document, own: &Sources<'_>, lang: Lang) {
    page.heading(3, say!(lang, "norm-heading"));
    let Some(norm) = own.norm else {
        page.paragraph(say!(lang, "norm-not-whole"));
        return;
    };
    elements(page, norm, true, own.knowledge, lang);
    let is_indicated = |set_up| own.plan.zero_axis(set_up).is_some() && own.plan.zero_pin(set_up).is_none();
    if own.plan.setup.stands.iter().any(|stand| is_indicated(stand.set_up)) {
        page.paragraph(say!(lang, "norm-indicating"));
    }
}

/// The elements of a norm, and the formulas with their figures; a lot that could be given is asked for.
pub(crate) fn elements(page: &mut Document, norm: &Norm, asks_lot: bool, knowledge: &Knowledge, lang: Lang) {
    page.push(of_piece(norm, lang));
    match (norm.auxiliary, norm.piece) {
        (Some(auxiliary), Some(piece)) => page.paragraph(say!(
            lang,
            "norm-piece",
            basic = exactly(norm.basic.0, 2),
            auxiliary = exactly(auxiliary.0, 2),
            service = rounded(norm.service.0, 1),
            rest = rounded(norm.rest.0, 1),
            piece = exactly(piece.0, 2)
        )),
        _ => page.paragraph(Inlines::sentence(say!(lang, "norm-no-loading"))),
    }
    if !norm.gauging.is_empty() {
        page.paragraph(say!(lang, "norm-gauging-meanwhile"));
    }
    page.push(of_lot(norm, lang));
    page.paragraph(say!(lang, "norm-preparatory-is", preparatory = exactly(norm.preparatory.0, 2)));
    if let (Some(lot), Some(piece), Some(with_lot)) = (norm.lot, norm.piece, norm.with_lot) {
        page.paragraph(say!(
            lang,
            "norm-with-lot",
            lot = lot,
            piece = exactly(piece.0, 2),
            preparatory = exactly(norm.preparatory.0, 2),
            with = exactly(with_lot.0, 2)
        ));
    } else if asks_lot && norm.lot.is_none() {
        page.paragraph(Inlines::sentence(say!(lang, "norm-no-lot")));
    }
    if norm.unconfirmed().contains(&true) {
        page.paragraph(say!(lang, "norm-unconfirmed"));
    }
    // Where the letters of the sources are found.
    let items = norm.of_piece.iter().chain(&norm.gauging).chain(&norm.of_lot);
    let reasons = items.filter_map(|item| item.because.as_ref()).chain([&norm.service.1, &norm.rest.1]);
    let Ok(named) = named_sources(reasons, knowledge) else { return };
    for (id, source) in named {
        page.paragraph(say!(
            lang,
            "explain-source",
            id = Figure::called(id),
            source = lang.remark(source).into_owned()
        ));
    }
}

/// A time of the cards, with the mark of what nothing confirms.
pub(super) fn marked(time: Option<Minutes>, unconfirmed: bool, lang: Lang) -> Inlines {
    let Some(time) = time else { return Inlines::default() };
    let told = lang.figure(&exactly(time.0, 2));
    if unconfirmed { Inlines::from(format!("{told}{MARK}")) } else { Inlines::number(told) }
}

fn table(lang: Lang) -> Table {
    let minutes = lang.word("unit-min");
    Table::new([
        Column::text(say!(lang, "norm-element")).min_width(24),
        Column::number(say!(lang, "lab-count"), ""),
        Column::number(say!(lang, "norm-each"), minutes),
        Column::number(say!(lang, "norm-total"), minutes),
        Column::text(say!(lang, "norm-source")).min_width(24),
    ])
}

fn of_piece(norm: &Norm, lang: Lang) -> Table {
    let mut table = table(lang);
    let by_plan = [("norm-basic", norm.basic), ("norm-machine", norm.machine), ("norm-hands", norm.hands)];
    for (key, time) in by_plan.into_iter().filter(|(_, time)| time.0 > 0.0) {
        let figures = [Inlines::number("1"), cell(time.0, 2, lang), cell(time.0, 2, lang)];
        let [count, each, total] = figures;
        table.row([lang.word(key).into(), count, each, total, lang.word("norm-of-plan").into()]);
    }
    norm.of_piece.iter().for_each(|item| row(&mut table, item, true, lang));
    norm.gauging.iter().for_each(|item| row(&mut table, item, false, lang));
    if norm.gauging_beyond.0 > 0.0 {
        let time = || cell(norm.gauging_beyond.0, 2, lang);
        let what = lang.word("norm-gauging-beyond");
        table.row([what.into(), Inlines::number("1"), time(), time(), NONE.into()]);
    }
    for (key, (share, because)) in [("norm-service", &norm.service), ("norm-rest", &norm.rest)] {
        let share = lang.figure(&rounded(*share, 1));
        let what = say!(lang, "norm-share", what = lang.word(key), share = share);
        table.row([what.into(), NONE.into(), NONE.into(), NONE.into(), Inlines::from(source(because, lang))]);
    }
    table
}

fn of_lot(norm: &Norm, lang: Lang) -> Table {
    let mut table = table(lang);
    norm.of_lot.iter().for_each(|item| row(&mut table, item, true, lang));
    table
}

/// A row; what goes on beside the machine has no sum of its own.
fn row(table: &mut Table, item: &NormItem, counts: bool, lang: Lang) {
    let total = if counts { cell(item.total().0, 2, lang) } else { NONE.into() };
    let from = match &item.because {
        Some(because) => source(because, lang),
        None if item.key == "norm-trial" => lang.word("norm-of-plan").to_owned(),
        None => lang.word("norm-given").to_owned(),
    };
    let figures = [Inlines::number(item.count.to_string()), cell(item.each.0, 2, lang)];
    let [count, each] = figures;
    table.row([lang.word(item.key).into(), count, each, total, Inlines::from(from)]);
}

/// Table, row and place of a figure, with the mark and the reason of what is not confirmed.
fn source(because: &Because, lang: Lang) -> String {
    let row = because.row.map(|row| say!(lang, "explain-row", row = row));
    let stands = [Some(because.table.clone()), row].into_iter().flatten().collect::<Vec<_>>().join(", ");
    let place = lang.place(&because.place);
    match &because.unconfirmed {
        Some(why) => format!("{MARK} {stands}: {place}; {}", lang.remark(why)),
        None => format!("{stands}: {place}"),
    }
}
