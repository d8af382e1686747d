//! The head of a table: which column holds what. What several columns could be called alike is settled by their units, by what the other
//! columns are, and by what stands in the cells; what stays open is asked of the author.

use technolog_core::lang::Lang;
use technolog_core::words::{self, operation_named};
use technolog_note::{Figure, IntoFigure as _, Note, note};
use technolog_sheets::Row;

use crate::knowledge::diagnostic::Place;
use crate::knowledge::units::Unit;
use crate::knowledge::yaml::Problems;

use super::Book;
use super::cells::{self, is_empty};
use super::columns::{Column, Of, head, norm};

/// The columns of a table: each with its number in the file, from 1.
pub(super) type Heads = Vec<(u32, Column)>;

/// What a cell of a head may mean, the likeliest kind of name first.
fn meant(text: &str, forms: &[Of]) -> Vec<Column> {
    let (name, unit) = head(text);
    let wanted = norm(name);
    let alone = forms.len() == 1 || !forms.contains(&Of::Row) && !forms.contains(&Of::Conditions);
    let all: Vec<Column> = forms.iter().flat_map(|of| of.columns()).filter(|column| is_own(*column, forms)).collect();
    let of_unit = |column: &Column| {
        unit.is_none_or(|unit| column.unit() == Some(unit) || unit == Unit::None && column.quantity().is_some())
    };
    let called: Vec<Column> = all.iter().copied().filter(|column| column.has_name(&wanted, alone)).collect();
    let fitting: Vec<Column> = called.iter().copied().filter(of_unit).collect();
    if !fitting.is_empty() {
        return fitting;
    }
    all.into_iter().filter(|column| column.has_symbol(&wanted)).filter(of_unit).collect()
}

/// Whether a table of those mappings has the column: a holder is named by its own, and a list says once what row and conditions share.
fn is_own(column: Column, forms: &[Of]) -> bool {
    match column.of {
        Of::Holder => column.key != "designation",
        Of::Conditions if forms.contains(&Of::Row) => !["for", "count", "diameter", "passes"].contains(&column.key),
        _ => true,
    }
}

/// How many cells of a row are heads of columns.
pub(super) fn count(row: &Row, forms: &[Of]) -> usize {
    row.filled().filter(|(_, text)| !meant(text, forms).is_empty()).count()
}

/// The cells of a head that are no column of a table of those mappings.
pub(super) fn unread<'r>(row: &'r Row, forms: &[Of]) -> Vec<&'r str> {
    row.filled().filter(|(_, text)| meant(text, forms).is_empty()).map(|(_, text)| text).collect()
}

/// Whether a head has a column for what is done.
pub(super) fn has_operation(row: &Row, forms: &[Of]) -> bool {
    let is_operation = |own: &Column| (own.of, own.key) == (Of::Row, "operation");
    row.filled().any(|(_, text)| meant(text, forms).iter().any(is_operation))
}

/// The columns of a table by its head; `below` are the rows under it.
pub(super) fn read(
    book: &Book,
    row: &Row,
    below: &[Row],
    forms: &[Of],
    problems: &mut Problems,
    remarks: &mut Vec<(Place, Note)>,
) -> Heads {
    let mut open: Vec<(u32, &str, Vec<Column>)> =
        row.filled().map(|(column, text)| (column, text, meant(text, forms))).collect();
    for (column, text, _) in open.iter().filter(|(.., meant)| meant.is_empty()) {
        remarks.push((book.place(row.line, *column, text), note!("audit-column-unread", column = *text)));
    }
    open.retain(|(.., meant)| !meant.is_empty());
    // A column of one meaning takes it from the others; what the cells rule out goes, too.
    for (column, _, meant) in &mut open {
        let texts: Vec<&str> = below.iter().map(|row| row.cell(*column)).filter(|text| !is_empty(text)).collect();
        if meant.len() > 1 {
            let fitting: Vec<Column> = meant.iter().copied().filter(|own| cells::fit(*own, &texts)).collect();
            if !fitting.is_empty() {
                *meant = fitting;
            }
        }
    }
    loop {
        let settled: Vec<Column> = open.iter().filter_map(|(.., meant)| single(meant)).collect();
        let before: usize = open.iter().map(|(.., meant)| meant.len()).sum();
        for (.., meant) in open.iter_mut().filter(|(.., meant)| meant.len() > 1) {
            let left: Vec<Column> = meant.iter().copied().filter(|own| !settled.contains(own)).collect();
            if !left.is_empty() {
                *meant = left;
            }
            by_others(meant, &settled);
        }
        if open.iter().map(|(.., meant)| meant.len()).sum::<usize>() == before {
            break;
        }
    }
    words_of_programs(book, row, &mut open, remarks);
    one_operation(book, row, below, &mut open, remarks);
    let mut heads: Heads = Vec::new();
    for (column, text, meant) in open {
        let place = book.place(row.line, column, text);
        let Some(own) = single(&meant) else {
            let names = Figure::list(meant.iter().map(|own| shown(*own).into_figure()));
            let message = note!("sheet-column-open", column = text, meant = names);
            problems.error_help::<()>("ambiguous-column", message, &place, note!("sheet-column-open-help"));
            continue;
        };
        if heads.iter().any(|(_, known)| *known == own) {
            let message = note!("sheet-column-twice", column = text, meant = shown(own));
            problems.error_help::<()>("duplicate-column", message, &place, note!("sheet-column-twice-help"));
            continue;
        }
        heads.push((column, own));
    }
    heads
}

fn single(meant: &[Column]) -> Option<Column> {
    if let [own] = meant { Some(*own) } else { None }
}

/// A table with a computed spindle speed takes the one that was taken from its series beside it: S is the feed then.
fn by_others(meant: &mut Vec<Column>, settled: &[Column]) {
    let own = |key: &str| meant.iter().any(|own| own.key == key);
    if own("feed") && own("rpm") && settled.iter().any(|own| own.key == "rpm_computed") {
        meant.retain(|own| own.key == "feed");
    }
}

/// S beside F, without units and beside no other figure of either kind, are the words of a program: turns and feed per minute. A remark
/// says so.
fn words_of_programs(book: &Book, row: &Row, open: &mut [(u32, &str, Vec<Column>)], remarks: &mut Vec<(Place, Note)>) {
    let may_be = |meant: &[Column], key: &str| meant.iter().any(|own| own.key == key);
    let at =
        |word: &str, key: &str| open.iter().position(|(_, text, meant)| head(text).0 == word && may_be(meant, key));
    let (Some(speed), Some(feed)) = (at("S", "rpm"), at("F", "minute_feed")) else { return };
    for (at, key) in [(speed, "rpm"), (feed, "minute_feed")] {
        let Some((column, text, meant)) = open.get_mut(at).filter(|(.., meant)| meant.len() > 1) else { continue };
        meant.retain(|own| own.key == key);
        let Some(own) = meant.first() else { continue };
        let note = note!("audit-column-read-as", column = *text, meant = shown(*own));
        remarks.push((book.place(row.line, *column, text), note));
    }
}

/// A card has a column for the operation, `005 Свердлильна`, beside that of the transition: what is done stands in the one whose cells
/// name it. A remark tells the other.
fn one_operation(
    book: &Book,
    row: &Row,
    below: &[Row],
    open: &mut Vec<(u32, &str, Vec<Column>)>,
    remarks: &mut Vec<(Place, Note)>,
) {
    let is_operation = |meant: &[Column]| single(meant).is_some_and(|own| (own.of, own.key) == (Of::Row, "operation"));
    let names = |column: u32| {
        let known = |text: &str| Lang::all().any(|lang| operation_named(text, lang).is_some());
        below.iter().filter(|row| known(row.cell(column))).count()
    };
    let own: Vec<(u32, usize)> =
        open.iter().filter(|(.., meant)| is_operation(meant)).map(|(column, ..)| (*column, names(*column))).collect();
    let most = own.iter().map(|(_, count)| *count).max().unwrap_or_default();
    // Where several name it as often the author says which one is meant.
    if most == 0 || own.iter().filter(|(_, count)| *count == most).count() != 1 {
        return;
    }
    open.retain(|(column, text, _)| {
        let other = own.iter().any(|(known, count)| known == column && *count < most);
        if other {
            remarks.push((book.place(row.line, *column, text), note!("audit-column-unread", column = *text)));
        }
        !other
    });
}

/// A column as a message names it: with its unit.
fn shown(column: Column) -> Note {
    let name = Figure::word_of("column", column.message().trim_start_matches("column-").to_owned());
    match column.unit().filter(|unit| *unit != Unit::None) {
        Some(unit) => {
            note!(
                "sheet-column-of-unit",
                name = name,
                unit = Figure::word_of("unit", unit.text().replace(['*', '/'], "-"))
            )
        }
        None => note!("sheet-column-named", name = name),
    }
}

/// The head of a column as the program writes it: `подача, мм/об`.
pub(super) fn titled(column: Column, lang: Lang) -> String {
    let name = column.name(lang);
    match column.unit().map(|unit| words::unit(unit, lang)).filter(|unit| !unit.is_empty()) {
        Some(unit) => format!("{name}, {unit}"),
        None => name.to_owned(),
    }
}
