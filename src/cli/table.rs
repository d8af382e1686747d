//! `technolog table`: the list of tables, or one table as its source prints it.

use serde::Serialize;
use technolog::document::{Column as Head, Document, Inlines, Keep, Table as Grid};
use technolog::knowledge::{Column, Table, TableKind};
use technolog::units::Unit;

use super::{CliError, Context, Format, Lang, Outcome, knowledge, record, sheet, shown};

// The list of tables, or one table as its source prints it
#[derive(Debug, clap::Args)]
pub struct Args {
    table: Option<String>,
}

/// The formats of its answers.
pub const FORMATS: &[Format] = &[Format::Text, Format::Json, Format::Csv, Format::Markdown, Format::Html];

/// Shows a table or the list of all.
///
/// # Errors
/// There is no such table, or the answer cannot be written.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let format = context.format("table", FORMATS)?;
    let knowledge = knowledge::load_to_read(context)?;
    let Some(id) = &args.table else {
        let mut tables: Vec<&Table> = knowledge.tables().collect();
        tables.sort_by_key(|table| knowledge::natural(&table.id));
        match format {
            Format::Json => context.emit_json(&list_json(&tables, context))?,
            Format::Csv => context.emit_rows(list_rows(&tables, context), "\n")?,
            _ => context.emit_document(&list_page(&tables, context.lang), format)?,
        }
        return Ok(Outcome::Done);
    };
    let table = knowledge::table(knowledge, id, context)?;
    match format {
        Format::Json => context.emit_json(&table_json(table, context))?,
        Format::Csv => context.emit_rows(table_rows(table), "\n")?,
        _ => context.emit_document(&sheet::table_page(table, context.lang, context.room(format)), format)?,
    }
    Ok(Outcome::Done)
}

const fn kind(table: &Table) -> &'static str {
    match table.kind {
        TableKind::Catalog => "catalog",
        TableKind::Decision => "decision",
    }
}

fn list_page(tables: &[&Table], lang: Lang) -> Document {
    let mut page = Document::new(lang.tag(), lang.word("table-list"));
    let mut list = Grid::new([
        Head::text(lang.word("cli-table")).min_width(24),
        Head::number(lang.word("cli-row-count"), "").keep(Keep::Optional),
        Head::text(lang.word("cli-kind")).min_width(7).keep(Keep::Optional),
        Head::text(lang.word("cli-title")).min_width(30),
    ]);
    for table in tables {
        let kind = match table.kind {
            TableKind::Catalog => "cli-catalog",
            TableKind::Decision => "cli-decision",
        };
        list.row([
            Inlines::default().code(&table.id),
            Inlines::number(table.rows.len().to_string()),
            lang.word(kind).into(),
            shown::title(lang, table).into(),
        ]);
    }
    page.push(list);
    page
}

#[derive(Serialize)]
struct Listed<'t> {
    table: &'t str,
    title: &'t str,
    kind: &'static str,
    rows: usize,
    file: &'t str,
}

fn list_json<'t>(tables: &[&'t Table], context: &Context) -> Vec<Listed<'t>> {
    tables
        .iter()
        .map(|table| Listed {
            table: &table.id,
            title: shown::title(context.lang, table),
            kind: kind(table),
            rows: table.rows.len(),
            file: &table.file,
        })
        .collect()
}

fn list_rows(tables: &[&Table], context: &Context) -> Vec<Vec<String>> {
    let head = ["table", "rows", "kind", "title", "file"];
    let lines = tables.iter().map(|table| {
        let rows = table.rows.len().to_string();
        [&table.id, rows.as_str(), kind(table), shown::title(context.lang, table), &table.file]
            .map(str::to_owned)
            .to_vec()
    });
    std::iter::once(head.map(str::to_owned).to_vec()).chain(lines).collect()
}

/// A column in JSON.
#[derive(Serialize)]
struct ColumnJson<'t> {
    name: &'t str,
    #[serde(rename = "type")]
    ty: &'static str,
    unit: Option<&'static str>,
    symbol: Option<&'t str>,
    label: Option<&'t str>,
    role: &'static str,
    list: bool,
    optional: bool,
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    values: &'t [String],
    #[serde(skip_serializing_if = "Option::is_none")]
    domain: Option<&'t str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    default: Option<record::ValueJson<'t>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    refers: Option<Refers<'t>>,
}

#[derive(Serialize)]
struct Refers<'t> {
    table: &'t str,
    column: &'t str,
}

#[derive(Serialize)]
struct TableJson<'t> {
    table: &'t str,
    title: &'t str,
    kind: &'static str,
    place: &'t str,
    standard: Option<&'t str>,
    file: &'t str,
    result: &'t [String],
    key: &'t [String],
    columns: Vec<ColumnJson<'t>>,
    rows: Vec<record::WholeRow<'t>>,
    notes: &'t [String],
}

fn table_json<'t>(table: &'t Table, context: &Context) -> TableJson<'t> {
    TableJson {
        table: &table.id,
        title: shown::title(context.lang, table),
        kind: kind(table),
        place: &table.place,
        standard: table.standard.as_deref(),
        file: &table.file,
        result: &table.result,
        key: &table.key,
        columns: table.columns.iter().map(|column| column_json(column, context)).collect(),
        rows: table.all_rows().map(record::WholeRow::of).collect(),
        notes: &table.notes,
    }
}

fn column_json<'t>(column: &'t Column, context: &Context) -> ColumnJson<'t> {
    // A pure number has the unit 1; a text or a truth value has none.
    let has_unit = column.unit != Unit::None || column.ty.default_unit() != Some(Unit::None);
    ColumnJson {
        name: &column.name,
        ty: column.ty.name(),
        unit: has_unit.then(|| column.unit.text()),
        symbol: column.symbol.as_deref(),
        label: shown::label(context.lang, column),
        role: record::role(column.role),
        list: column.list,
        optional: column.optional,
        values: &column.values,
        domain: column.domain_text.as_deref(),
        default: column.default.as_ref().map(|value| record::ValueJson(column, value)),
        refers: column.refers.as_ref().map(|(table, column)| Refers { table, column }),
    }
}

fn table_rows(table: &Table) -> Vec<Vec<String>> {
    let names = table.columns.iter().map(|column| column.name.as_str());
    let head = names.chain(["source", "place", "reason", "unconfirmed", "choice", "note"]).map(str::to_owned).collect();
    let mut rows = vec![head];
    for row in table.all_rows() {
        let content = row.row();
        let mut cells: Vec<String> =
            table.columns.iter().zip(&content.cells).map(|(column, cell)| record::cell(column, cell)).collect();
        cells.push(content.source.to_string());
        cells.push(row.place().to_owned());
        let (unconfirmed, choice) =
            if content.is_choice { (&None, &content.unconfirmed) } else { (&content.unconfirmed, &None) };
        for about in [&content.reason, unconfirmed, choice, &content.note] {
            cells.push(about.clone().unwrap_or_default());
        }
        rows.push(cells);
    }
    rows
}
