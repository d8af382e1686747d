//! `technolog lookup`: one query against one table, with its reason.

mod catalog;
mod decision;
mod near;
mod question;

use technolog::document::{Block, Document, Field, Inlines};
use technolog::knowledge::TableKind;

use super::{CliError, Context, Format, Lang, Outcome, knowledge};
use question::LookupQuestion;

// One query against one table, with the reason of its answer
#[derive(Debug, clap::Args)]
pub struct Args {
    table: String,
    #[arg(value_name = "KEY=VALUE")]
    query: Vec<String>,
    #[arg(long)]
    all: bool,
}

/// The formats of its answers.
pub const FORMATS: &[Format] = &[Format::Text, Format::Json, Format::Markdown, Format::Html];

/// Answers one query.
///
/// # Errors
/// The question does not fit the table; all its mistakes are reported at once.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let format = context.format("lookup", FORMATS)?;
    let knowledge = knowledge::load_to_read(context)?;
    let table = knowledge::table(knowledge, &args.table, context)?;
    let question = LookupQuestion::read(table, args, context)?;
    match table.kind {
        TableKind::Decision => decision::answer(&question, args.all, format, context),
        TableKind::Catalog => catalog::answer(&question, format, context),
    }
}

/// The answer of the table.
fn result(page: &mut Document, result: &str, lang: Lang) {
    page.push(Block::Fields(vec![Field::new(lang.word("cli-result"), Inlines::default().strong(result))]));
}
