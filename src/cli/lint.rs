//! `technolog lint`: checks the knowledge base.

use serde_json::json;
use technolog::document::{Column, Document, Table};
use technolog::knowledge::{Diagnostic, Knowledge, Severity, lint};
use technolog::tables;
use technolog::words::say;

use super::{CliError, Context, Format, Lang, Outcome, diagnostics, knowledge, problems};

// Check the knowledge base: gaps, contradictions, unreachable rows, references, laws, examples
#[derive(Debug, clap::Args)]
pub struct Args {
    #[arg(long)]
    documentation: bool,
}

/// The formats of its answers.
pub const FORMATS: &[Format] = &[Format::Text, Format::Json, Format::Markdown, Format::Html];

/// Shows every load problem and every finding.
///
/// # Errors
/// A file could not be used; all findings are shown nevertheless.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let format = context.format("lint", FORMATS)?;
    let texts = knowledge::texts(context)?;
    let (knowledge, mut problems) = Knowledge::read_sources(&knowledge::sources(&texts));
    if args.documentation {
        return documentation(&knowledge, format, context);
    }
    let unusable = problems.iter().any(is_error);
    problems.extend(lint::lint(&knowledge));
    if tables::is_to_plan_with(&knowledge) {
        problems.extend(tables::check(&knowledge));
    }
    if unusable {
        // It may be in the file that could not be read.
        problems.retain(|problem| problem.code != "absent-table");
    }
    let errors = problems.iter().any(is_error);
    match format {
        Format::Json => {
            context.emit_json(
                &problems.iter().map(|it| diagnostics::Json::of(it, &texts, context.lang)).collect::<Vec<_>>(),
            )?;
        }
        _ => {
            let mut page = Document::new(context.lang.tag(), context.word("lint-title"));
            let count = problems.len();
            page.blocks.extend(problems::blocks(problems, 0, &texts, format, context));
            page.paragraph(summary(&knowledge, count, context.lang));
            context.emit_document(&problems::untitled(page, format), format)?;
        }
    }
    if unusable {
        Err(CliError::Shown)
    } else if errors {
        Ok(Outcome::Findings)
    } else {
        Ok(Outcome::Done)
    }
}

/// One line for each table, with its columns that no code reads and its documentation rows.
fn documentation(knowledge: &Knowledge, format: Format, context: &Context) -> Result<Outcome, CliError> {
    let listed = tables::documentation(knowledge);
    if format == Format::Json {
        let rows =
            listed.iter().map(|parts| json!({"table": parts.table, "columns": parts.columns, "rows": parts.rows}));
        context.emit_json(&rows.collect::<Vec<_>>())?;
    } else {
        let mut page = Document::new(context.lang.tag(), context.word("lint-documentation"));
        let heads = ["cli-table", "cli-columns", "cli-row-count"].map(|head| Column::text(context.word(head)));
        let mut table = Table::new(heads);
        for parts in &listed {
            table.row([parts.table.to_owned(), parts.columns.join(", "), parts.rows.join(", ")]);
        }
        page.push(table);
        context.emit_document(&page, format)?;
    }
    Ok(Outcome::Done)
}

fn is_error(problem: &Diagnostic) -> bool {
    problem.severity == Severity::Error
}

fn summary(knowledge: &Knowledge, findings: usize, lang: Lang) -> String {
    let (tables, rows) = (knowledge.tables().count(), knowledge.tables().map(|table| table.rows.len()).sum::<usize>());
    say!(
        lang,
        "lint-summary",
        tables = say!(lang, "cli-tables-counted", count = tables),
        rows = say!(lang, "cli-rows-counted", count = rows),
        findings = say!(lang, "cli-findings-counted", count = findings)
    )
}
