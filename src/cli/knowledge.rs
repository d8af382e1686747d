//! The knowledge base of a command: the embedded tables, or those of the folder of `--knowledge`, with the layers of `--with` over
//! them.

use std::borrow::Cow;
use std::path::Path;

pub use technolog::knowledge::alike::latin;
use technolog::knowledge::diagnostic::nearest;
use technolog::knowledge::{Diagnostic, Knowledge, SourceFile, Table};
use technolog::shipped;

use super::diagnostics::Texts;
use super::{CliError, Context, words};

/// The tables for planning, checked against their contracts.
///
/// # Errors
/// A file cannot be read, contains something that no table may, or breaks a contract.
pub fn load(context: &Context) -> Result<&'static Knowledge, CliError> {
    let knowledge = loaded(context, technolog::tables::load)?;
    Ok(context.tables.get_or_init(|| knowledge))
}

/// The tables for queries: a folder may contain a few tables that are not enough for planning.
///
/// # Errors
/// A file cannot be read, or contains something that no table may.
pub fn load_to_read(context: &Context) -> Result<&'static Knowledge, CliError> {
    loaded(context, Knowledge::from_sources)
}

fn loaded(
    context: &Context,
    read_tables: impl Fn(&[SourceFile<'_>]) -> Result<Knowledge, Vec<Diagnostic>>,
) -> Result<&'static Knowledge, CliError> {
    let knowledge = if context.knowledge.is_none() && context.layers.is_empty() {
        shipped::knowledge().map_err(|error| {
            let message = words::broken_build(context.lang, error);
            CliError::from(Diagnostic::error("broken-build", message, None).help(words::rebuild(context.lang)))
        })?
    } else {
        let texts = texts(context)?;
        read_tables(&sources(&texts)).map_err(|problems| CliError::Unusable { problems, texts })?
    };
    // It lives as long as the process: freeing thousands of rows at the end would take a tenth of the time of a plan.
    Ok(Box::leak(Box::new(knowledge)))
}

/// The texts of the tables, with the places that `lint` needs. A file of a layer takes the place of that with the same path below
/// it, and is a table more where there is none.
///
/// # Errors
/// A file cannot be read.
pub fn texts(context: &Context) -> Result<Texts, CliError> {
    let base = match &context.knowledge {
        Some(folder) => over(Texts::default(), folder)?,
        None => shipped::SOURCES.iter().fold(Texts::default(), |texts, source| {
            texts.with(source.path, source.path.to_owned(), Cow::Borrowed(source.text))
        }),
    };
    context.layers.iter().try_fold(base, |texts, folder| over(texts, folder))
}

/// The texts in the form that the knowledge crate takes.
pub fn sources(texts: &Texts) -> Vec<SourceFile<'_>> {
    texts.iter().map(|(path, text)| SourceFile { path, text }).collect()
}

/// The texts of a folder over others.
fn over(below: Texts, folder: &Path) -> Result<Texts, CliError> {
    let files =
        Knowledge::read_folder(folder).map_err(|problems| CliError::Unusable { problems, texts: Texts::default() })?;
    Ok(files.into_iter().fold(below, |texts, (path, text)| {
        let shown = folder.join(&path).display().to_string();
        texts.with(&path, shown, Cow::Owned(text))
    }))
}

/// A table by the id a user typed: `A.8`, `a.8`, or with a Cyrillic А.
///
/// # Errors
/// There is no such table; the message names the nearest.
pub fn table<'k>(knowledge: &'k Knowledge, typed: &str, context: &Context) -> Result<&'k Table, CliError> {
    // The book has А.18б, with a Cyrillic letter at the end too.
    let wanted = latin(typed.trim()).replace(['б', 'Б'], "b");
    let exact = knowledge.tables().find(|table| table.id == wanted);
    if let Some(table) = exact.or_else(|| knowledge.tables().find(|table| table.id.eq_ignore_ascii_case(&wanted))) {
        return Ok(table);
    }
    let lower = wanted.to_ascii_lowercase();
    let ids: Vec<(String, &str)> =
        knowledge.tables().map(|table| (table.id.to_ascii_lowercase(), table.id.as_str())).collect();
    // A table of the book may be divided into several here, each with a letter.
    let is_part = |id: &str| {
        id.strip_prefix(&lower)
            .is_some_and(|rest| rest.len() == 1 && rest.bytes().all(|sign| sign.is_ascii_alphabetic()))
    };
    let parts: Vec<&str> = ids.iter().filter(|(lower, _)| is_part(lower)).map(|(_, id)| *id).collect();
    let near = nearest(&lower, ids.iter().map(|(lower, _)| lower.as_str()))
        .and_then(|near| ids.iter().find(|(lower, _)| lower == near));
    let list = words::list_tables(context.lang);
    let help = match near {
        _ if parts.len() > 1 => format!("{} {list}", words::did_you_mean(context.lang, parts.join("`, `"))),
        Some((_, id)) => format!("{} {list}", words::did_you_mean(context.lang, id)),
        None => list,
    };
    Err(Diagnostic::error("unknown-table", words::unknown_table(context.lang, typed), None).help(help).into())
}

/// A sort key for ids: `A.2` before `A.10`.
pub fn natural(id: &str) -> Vec<(u64, String)> {
    let mut parts: Vec<(u64, String)> = Vec::new();
    let mut rest = id;
    while !rest.is_empty() {
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        let (number, after) = rest.split_at(digits);
        let letters = after.bytes().take_while(|byte| !byte.is_ascii_digit()).count();
        let (text, next) = after.split_at(letters);
        parts.push((number.parse().unwrap_or(0), text.to_owned()));
        rest = next;
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_ordered_by_their_numbers() {
        let mut ids = ["A.10", "A.2", "A.18b", "tapers", "A.18a", "2c42-65", "A.1"];
        ids.sort_by_key(|id| natural(id));
        assert_eq!(ids, ["A.1", "A.2", "A.10", "A.18a", "A.18b", "tapers", "2c42-65"]);
    }
}
