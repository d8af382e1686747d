//! Reading a plan file with the files it names.

use std::borrow::Cow;
use std::path::Path;

use technolog::audit::marks::{MarkingScheme, read_scheme};
use technolog::audit::rules;
use technolog::audit::stated::Stated;
use technolog::audit::{Auditor, Unreadable, is_plan_table, read_if_plan, read_plan_of, read_table};
use technolog::cases::FileKind;
use technolog::error::KnowledgeError;
use technolog::knowledge::{Diagnostic, Place};
use technolog::note::Note;
use technolog::part::{Part, read_part};
use technolog::report::Lang;
use technolog::sheets;

use super::super::diagnostics::Texts;
use super::super::input::{self, FileRoots};
use super::super::{CliError, Context, kind};

/// A plan.
///
/// # Errors
/// Every mistake of the file.
pub fn read(
    path: &Path,
    part: Option<&Part>,
    auditor: &Auditor<'_>,
    places: FileRoots<'_>,
    context: &Context,
) -> Result<Stated, CliError> {
    if let Some(kind) = table_kind(path) {
        context.uses(path);
        return read_tables(path, kind, part, auditor, places, context);
    }
    let shown = path.display().to_string();
    let text = context.text(path)?;
    let stated = read_plan_of(&shown, &text, part, auditor.knowledge, &|name: &str| places.text(path, name, context));
    stated.map_err(|unreadable| unusable(path, shown, text, unreadable, context))
}

/// A work: a list that says of no tool what it does has nothing that could be judged.
///
/// # Errors
/// Every mistake of the file.
pub fn read_work(
    path: &Path,
    part: Option<&Part>,
    auditor: &Auditor<'_>,
    places: FileRoots<'_>,
    context: &Context,
) -> Result<Stated, CliError> {
    judged(read(path, part, auditor, places, context)?)
}

fn judged(stated: Stated) -> Result<Stated, CliError> {
    if !stated.is_list || !stated.rows.is_empty() {
        return Ok(stated);
    }
    let place = Place { file: stated.file.as_str().into(), line: 1, column: 1, width: 1 };
    let problem = Diagnostic::error("missing-key", Note::new("sheet-list-without-operation"), place);
    Err(problem.help(Note::new("sheet-list-without-operation-help")).into())
}

/// The form of a file of tables, by its name.
pub fn table_kind(path: &Path) -> Option<sheets::Kind> {
    sheets::Kind::of(&path.to_string_lossy())
}

/// A plan or a list of tools as tables of CSV or XLSX.
fn read_tables(
    path: &Path,
    kind: sheets::Kind,
    part: Option<&Part>,
    auditor: &Auditor<'_>,
    places: FileRoots<'_>,
    context: &Context,
) -> Result<Stated, CliError> {
    let shown = path.display().to_string();
    let tables = sheets::read(kind, &context.bytes(path)?).map_err(|error| {
        let place = Place { file: shown.as_str().into(), line: 1, column: 1, width: 1 };
        CliError::from(Diagnostic::error("unreadable", error.message, place).help(error.help))
    })?;
    let stated = read_table(&shown, &tables, part, auditor.knowledge, &|name: &str| places.text(path, name, context));
    stated.map_err(|unreadable| {
        let Unreadable { problems, texts } = unreadable;
        let mut known = Texts::default();
        for (name, text) in texts {
            let path = folder_of(path).join(&name).display().to_string();
            known = known.with(&name, path, Cow::Owned(text));
        }
        CliError::Unusable { problems, texts: known }
    })
}

/// The part that the command line names.
///
/// # Errors
/// Every mistake of its file.
pub fn part(path: &Path, auditor: &Auditor<'_>, context: &Context) -> Result<Part, CliError> {
    let shown = path.display().to_string();
    let text = context.text(path)?;
    read_part(&shown, &text, auditor.knowledge).map_err(|problems| CliError::Unusable {
        problems: kind::or_other(&shown, &text, FileKind::Part, problems, context),
        texts: Texts::default().with(&shown, shown.clone(), Cow::Owned(text)),
    })
}

/// A file of a folder: none where it is no plan.
///
/// # Errors
/// Every mistake of the plan.
pub fn read_any(
    path: &Path,
    auditor: &Auditor<'_>,
    places: FileRoots<'_>,
    context: &Context,
) -> Result<Option<Stated>, CliError> {
    if let Some(kind) = table_kind(path) {
        return match read_tables(path, kind, None, auditor, places, context) {
            // Any other table of the folder is no plan.
            Err(_) if sheets::read(kind, &context.bytes(path)?).is_ok_and(|tables| !is_plan_table(&tables)) => Ok(None),
            stated => stated.and_then(judged).map(Some),
        };
    }
    let shown = path.display().to_string();
    let text = input::text_in_folder(path, context)?;
    let stated = read_if_plan(&shown, &text, auditor.knowledge, &|name: &str| places.text(path, name, context));
    stated.map_err(|unreadable| unusable(path, shown, text, unreadable, context))
}

/// An error that stopped an audit: in the part inside a plan of the program, with its place, or in the tables.
pub fn at_fault(stated: &Stated, error: &KnowledgeError, context: &Context) -> CliError {
    match stated.at_fault(error) {
        // The text is read again, for the line that the message shows.
        Some(problem) => CliError::Unusable {
            problems: vec![problem],
            texts: match input::named(Path::new(&stated.file), context) {
                Ok(text) => Texts::default().with(&stated.file.clone(), stated.file.clone(), Cow::Owned(text)),
                Err(_) => Texts::default(),
            },
        },
        None => CliError::of_knowledge(error, context.lang),
    }
}

/// A marking scheme.
///
/// # Errors
/// Every mistake of the file.
pub fn scheme(path: &Path, context: &Context) -> Result<MarkingScheme, CliError> {
    let shown = path.display().to_string();
    let text = context.text(path)?;
    // A check is named by the code of its sentence.
    let codes = Lang::codes();
    let known: Vec<&str> = rules::all().map(|rule| rule.id).chain(codes.iter().map(String::as_str)).collect();
    read_scheme(&shown, &text, &known).map_err(|problems| {
        let problems = kind::or_other(&shown, &text, FileKind::Marks, problems, context);
        let texts = Texts::default().with(&shown.clone(), shown, Cow::Owned(text));
        CliError::Unusable { problems, texts }
    })
}

fn folder_of(plan: &Path) -> &Path {
    plan.parent().unwrap_or(Path::new(""))
}

fn unusable(path: &Path, shown: String, text: String, unreadable: Unreadable, context: &Context) -> CliError {
    let Unreadable { problems, texts } = unreadable;
    let problems = kind::or_other(&shown, &text, FileKind::Plan, problems, context);
    let mut known = Texts::default().with(&shown.clone(), shown, Cow::Owned(text));
    for (name, text) in texts {
        let path = folder_of(path).join(&name).display().to_string();
        known = known.with(&name, path, Cow::Owned(text));
    }
    CliError::Unusable { problems, texts: known }
}
