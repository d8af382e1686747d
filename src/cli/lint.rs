//! `technolog lint`: proves the knowledge base.

use serde_json::json;
use technolog::knowledge::{Diagnostic, Knowledge, Severity, lint};
use technolog::report::grid;
use technolog::tables::{self, ForPeople};

use super::{CliError, Context, Format, Outcome, diagnostics, knowledge, words};

// Prove the knowledge base: gaps, contradictions, dead rows, references, laws, examples
#[derive(Debug, clap::Args)]
pub struct Args {
    #[arg(long)]
    documentation: bool,
}

/// Shows every load problem and every finding.
///
/// # Errors
/// A file could not be used; what was found in it and in the others is shown all the same.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let format = context.format("lint", &[Format::Text, Format::Json])?;
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
        // It may stand in the file that could not be read.
        problems.retain(|problem| problem.code != "absent-table");
    }
    match format {
        Format::Json => {
            context.emit_json(
                &problems.iter().map(|it| diagnostics::Json::of(it, &texts, context.lang)).collect::<Vec<_>>(),
            )?;
        }
        _ => {
            let mut text = diagnostics::render(&problems, &texts, context.lang);
            if !problems.is_empty() {
                text.push('\n');
            }
            text.push_str(&summary(&knowledge, problems.len(), context));
            context.emit(&text)?;
        }
    }
    if unusable {
        Err(CliError::Shown)
    } else if problems.iter().any(is_error) {
        Ok(Outcome::Findings)
    } else {
        Ok(Outcome::Done)
    }
}

/// A table a line, with its columns that no code reads and its rows that are documentation.
fn documentation(knowledge: &Knowledge, format: Format, context: &Context) -> Result<Outcome, CliError> {
    let listed = tables::documentation(knowledge);
    if format == Format::Json {
        let rows = listed.iter().map(|of| json!({"table": of.table, "columns": of.columns, "rows": of.rows}));
        context.emit_json(&rows.collect::<Vec<_>>())?;
    } else {
        let line = |of: &ForPeople<'_>| vec![of.table.to_owned(), of.columns.join(", "), of.rows.join(", ")];
        let rows: Vec<Vec<String>> = listed.iter().map(line).collect();
        context.emit(&grid::columns(&rows, 0))?;
    }
    Ok(Outcome::Done)
}

fn is_error(problem: &Diagnostic) -> bool {
    problem.severity == Severity::Error
}

fn summary(knowledge: &Knowledge, findings: usize, context: &Context) -> String {
    let lang = context.lang;
    let (tables, rows) = (knowledge.tables().count(), knowledge.tables().map(|table| table.rows.len()).sum());
    format!("{}, {}, {}\n", words::tables(lang, tables), words::rows(lang, rows), words::findings(lang, findings))
}
