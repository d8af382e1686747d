//! A table as a page: its rows under their columns, and below them everything that does not fit into cells.

use std::collections::BTreeMap;

use technolog::document::{Block, Column as Head, Document, Field, Inlines, Item, Keep, Table as Grid};
use technolog::knowledge::{Column, ColumnRole, Row, RowRef, Table, TableKind};
use technolog::report::unit;
use technolog::words::say;

use super::Lang;
use super::record::results;
use super::shown;

/// One table: title, source, rows, then everything that does not fit into cells. `room` is the width of a text in
/// terminal columns; pages of other formats have all the width they need.
pub fn table_page(table: &Table, lang: Lang, room: Option<usize>) -> Document {
    let all: Vec<RowRef<'_>> = table.all_rows().collect();
    let mut page = titled(table, lang);
    let mut source = Inlines::from(lang.place(&table.place).as_str());
    if let Some(standard) = &table.standard {
        source = source.text("; ").text(standard);
    }
    page.push(Block::Fields(vec![Field::new(lang.word("cli-source"), source)]));
    let numbered = rows(&mut page, table, &all, lang, room);
    columns(&mut page, table, numbered, lang);
    row_remarks(&mut page, &all, lang);
    let gaps = table.uncovered.iter().map(|gap| lang.remark(&gap.reason).into_owned());
    section(&mut page, lang.word("cli-gaps"), gaps);
    section(&mut page, lang.word("cli-notes"), table.notes.iter().map(|note| lang.remark(note).into_owned()));
    page
}

/// A page with the id and the title of a table.
pub fn titled(table: &Table, lang: Lang) -> Document {
    Document::new(lang.tag(), say!(lang, "table-title", table = &table.id, title = shown::title(lang, table)))
}

/// The rows under the names of the columns. Where these are too wide together for the room, a column has its symbol
/// for a name, and where symbols are too wide the columns have numbers, like those of the source; if that does not
/// help either, they keep their names. Returns whether the names are left out.
pub fn rows(page: &mut Document, table: &Table, rows: &[RowRef<'_>], lang: Lang, room: Option<usize>) -> bool {
    let first = rows.first().map(|row| row.row().source);
    let one_source = rows.iter().all(|row| Some(row.row().source) == first);
    let heads: Vec<Head> = columns_of(table, lang)
        .map(|(index, column)| {
            let head = shown::head(lang, column, keep(table, index, lang));
            match column.role {
                ColumnRole::Output => Head { heading: Inlines::from("→ ").append(head.heading.clone()), ..head },
                _ => head,
            }
        })
        .collect();
    let cells: Vec<Vec<Inlines>> = rows
        .iter()
        .map(|row| {
            let cells = columns_of(table, lang).zip(&heads);
            let cell = |((index, column), head): ((usize, &Column), &Head)| {
                let text = shown::cell(lang, column, &row.row().cells[index]);
                if shown::is_right(head) { Inlines::number(text) } else { text.into() }
            };
            cells.map(cell).collect()
        })
        .collect();
    let sources = rows.iter().map(|row| shown::source(lang, row.row().source).chars().count()).max().unwrap_or(0);
    let beside = if one_source { 0 } else { sources + 3 };
    let fits = |heads: &[Head]| room.is_none_or(|room| width(heads, &cells) + beside <= room);
    let symbols = columns_of(table, lang).zip(&heads).map(|((_, column), head)| symbol_head(column, head));
    let numbers = (1..).zip(&heads).map(|(number, head)| numbered_head(number, head));
    let shorter = [symbols.collect::<Vec<Head>>(), numbers.collect()];
    let short = if fits(&heads) { None } else { shorter.into_iter().find(|heads| fits(heads)) };
    let is_short = short.is_some();
    let heads = short.unwrap_or(heads);
    let mut columns = vec![Head::number(lang.word("cli-row-number"), "")];
    columns.extend(heads);
    columns.extend((!one_source).then(|| Head::text(lang.word("cli-row-source")).keep(Keep::Optional)));
    let mut grid = Grid::new(columns);
    for (row, cells) in rows.iter().zip(cells) {
        let number = Inlines::number(format!("{}{}", row.number(), marks(row.row())));
        let source = (!one_source).then(|| shown::source(lang, row.row().source).into());
        grid.row(std::iter::once(number).chain(cells).chain(source));
    }
    if let Some(source) = first.filter(|_| one_source) {
        grid.notes.push(say!(lang, "cli-all-rows-of-one-source", source = shown::source(lang, source)).into());
    }
    page.push(grid);
    is_short
}

/// The columns of a page, with their positions in the table; those in another language are left out.
fn columns_of(table: &Table, lang: Lang) -> impl Iterator<Item = (usize, &Column)> {
    let columns = table.columns.iter().enumerate();
    columns.filter(move |(_, column)| !shown::is_of_other_language(lang, table, column))
}

/// The key columns and the result columns are never left out; ids go before what the language has words for beside them, and
/// words of another language before their ids.
fn keep(table: &Table, index: usize, lang: Lang) -> Keep {
    let column = &table.columns[index];
    let has = |name: String| table.column_index(&name).is_some();
    let in_words = has(format!("{}_{}", column.name, lang.tag()));
    let is_foreign = column.name.rsplit_once('_').is_some_and(|(id, tag)| {
        has(id.to_owned()) && tag != lang.tag() && Lang::all().any(|known| known.tag() == tag)
    });
    let sought = match table.kind {
        TableKind::Decision => column.role == ColumnRole::Input || results(table).contains(&index),
        TableKind::Catalog => index == 0 || table.key.contains(&column.name) || table.result.contains(&column.name),
    };
    match (sought, column.optional || in_words || is_foreign) {
        (true, _) => Keep::Always,
        (false, false) => Keep::Useful,
        (false, true) => Keep::Optional,
    }
}

/// The head of a column that has a symbol: `D, мм`.
fn symbol_head(column: &Column, head: &Head) -> Head {
    let symbol = column.symbol.as_deref().map(Inlines::from);
    Head { heading: symbol.unwrap_or_else(|| head.heading.clone()), ..head.clone() }
}

fn numbered_head(number: usize, head: &Head) -> Head {
    Head { heading: number.to_string().into(), unit: String::new(), ..head.clone() }
}

/// The least width of a table, before its longest words are broken.
fn width(heads: &[Head], cells: &[Vec<Inlines>]) -> usize {
    let longest = |text: &str| text.split_whitespace().map(|word| word.chars().count()).max().unwrap_or(0);
    let column = |(index, head): (usize, &Head)| {
        let cells = cells.iter().filter_map(|row| row.get(index)).map(|cell| longest(&cell.plain()));
        cells.chain([longest(&head.heading.plain())]).max().unwrap_or(0)
    };
    heads.iter().enumerate().map(|one| column(one) + 3).sum::<usize>() + 6
}

/// The marks beside the number of a row: `*` for a correction, `?` for what nobody has confirmed, a choice of ours too.
fn marks(row: &Row) -> String {
    let corrected = if row.corrections.is_empty() { "" } else { "*" };
    let unconfirmed = if row.unconfirmed.is_some() { "?" } else { "" };
    format!("{corrected}{unconfirmed}")
}

/// The description of each column, and the queries that it permits.
pub fn columns(page: &mut Document, table: &Table, numbered: bool, lang: Lang) {
    page.heading(2, lang.word("cli-columns"));
    let text = |head: &str| Head::text(lang.word(head));
    let number = Head::number(lang.word("cli-row-number"), "");
    let heads =
        vec![number, text("table-key"), text("table-what"), text("table-symbol"), text("table-expected").min_width(24)];
    let row = |(number, (_, column)): (usize, (usize, &Column))| {
        let number = if numbered { number.to_string() } else { String::new() };
        let key = Inlines::default().code(&column.name);
        let label = shown::label(lang, column).unwrap_or_default();
        let about = about(column, lang).join("; ");
        vec![Inlines::number(number), key, label.into(), symbol(column, lang).into(), about.into()]
    };
    page.push(filled(heads, (1..).zip(columns_of(table, lang)).map(row).collect()));
}

/// A table without empty columns.
pub fn filled(heads: Vec<Head>, rows: Vec<Vec<Inlines>>) -> Grid {
    let is_filled = |index: &usize| rows.iter().any(|row| row.get(*index).is_some_and(|cell| !cell.is_empty()));
    let kept: Vec<usize> = (0..heads.len()).filter(is_filled).collect();
    let mut grid = Grid::new(kept.iter().filter_map(|&index| heads.get(index).cloned()));
    for row in &rows {
        grid.row(kept.iter().filter_map(|&index| row.get(index).cloned()));
    }
    grid
}

/// The symbol and the unit of a column: `d, мм`.
fn symbol(column: &Column, lang: Lang) -> String {
    match (column.symbol.as_deref().unwrap_or_default(), unit(column.unit, lang)) {
        (symbol, "") => symbol.to_owned(),
        ("", unit) => unit.to_owned(),
        (symbol, unit) => say!(lang, "table-symbol-unit", symbol = symbol, unit = unit),
    }
}

/// The permitted values of a column, as written in a query.
fn about(column: &Column, lang: Lang) -> Vec<String> {
    let mut about = Vec::new();
    let word = |key: &str| lang.word(key).to_owned();
    match column.role {
        ColumnRole::Field => {}
        ColumnRole::Input => about.push(word("cli-input")),
        ColumnRole::Output => about.push(word("cli-output")),
    }
    about.push(shown::expected(lang, column));
    about.extend(column.domain_text.as_deref().map(|domain| shown::test(lang, column, domain)));
    about.extend(column.list.then(|| word("cli-list")));
    about.extend(column.optional.then(|| word("cli-optional")));
    let default = column.default.as_ref().map(|value| super::record::bare(column, value));
    about.extend(default.map(|value| say!(lang, "cli-default-is", value = value)));
    let refers = column.refers.as_ref();
    about.extend(refers.map(|(table, column)| say!(lang, "cli-refers-to", table = table, column = column)));
    about
}

/// The data of rows besides their cells: corrections, doubts, reasons, places, notes. Rows with the same text are
/// joined.
pub fn row_remarks(page: &mut Document, rows: &[RowRef<'_>], lang: Lang) {
    let corrections = |row: &Row| -> Vec<String> {
        let texts = row.corrections.iter().map(|correction| {
            let (column, printed, reason) =
                (&correction.column, &correction.printed, lang.remark(&correction.reason).into_owned());
            say!(lang, "cli-printed-otherwise", column = column, printed = printed, reason = reason)
        });
        texts.collect()
    };
    let one =
        |text: &Option<String>| -> Vec<String> { text.iter().map(|text| lang.remark(text).into_owned()).collect() };
    by_rows(page, rows, "cli-corrections", lang, &corrections);
    let doubted =
        |row: &Row, as_choice: bool| if row.is_choice == as_choice { one(&row.unconfirmed) } else { Vec::new() };
    by_rows(page, rows, "cli-unconfirmed", lang, &|row| doubted(row, false));
    by_rows(page, rows, "cli-choices", lang, &|row| doubted(row, true));
    by_rows(page, rows, "cli-reasons", lang, &|row| one(&row.reason));
    by_rows(page, rows, "cli-places", lang, &|row| row.place.iter().map(|place| lang.place(place)).collect());
    by_rows(page, rows, "cli-row-notes", lang, &|row| one(&row.note));
}

fn by_rows(page: &mut Document, rows: &[RowRef<'_>], head: &str, lang: Lang, texts_of: &dyn Fn(&Row) -> Vec<String>) {
    let mut rows_of: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for row in rows {
        for sentence in texts_of(row.row()) {
            rows_of.entry(sentence).or_default().push(row.number());
        }
    }
    let mut lines: Vec<(Vec<usize>, String)> = rows_of.into_iter().map(|(sentence, rows)| (rows, sentence)).collect();
    lines.sort();
    let line = |(rows, text): (Vec<usize>, String)| {
        say!(lang, "table-of-rows", rows = shown::rows_named(lang, &rows), said = text)
    };
    section(page, lang.word(head), lines.into_iter().map(line));
}

/// A heading with its lines; nothing if there are no lines.
pub fn section(page: &mut Document, head: &str, lines: impl Iterator<Item = String>) {
    let lines: Vec<Item> = lines.map(|line| Inlines::sentence(&line).into()).collect();
    if !lines.is_empty() {
        page.heading(2, head);
        page.push(Block::List(lines));
    }
}
