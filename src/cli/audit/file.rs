//! Reading a plan file with the files it names.

use std::borrow::Cow;
use std::path::Path;

use technolog::audit::marks::{MarkingScheme, read_scheme};
use technolog::audit::rules;
use technolog::audit::stated::Stated;
use technolog::audit::{Auditor, Unreadable, read_if_plan, read_plan};
use technolog::cases::FileKind;
use technolog::error::KnowledgeError;
use technolog::report::Lang;

use super::super::diagnostics::Texts;
use super::super::input::{self, FileRoots};
use super::super::{CliError, Context, kind};

/// A plan.
///
/// # Errors
/// Every mistake of the file.
pub fn read(path: &Path, auditor: &Auditor<'_>, places: FileRoots<'_>, context: &Context) -> Result<Stated, CliError> {
    let shown = path.display().to_string();
    let text = context.text(path)?;
    let stated = read_plan(&shown, &text, auditor.knowledge, &|name: &str| places.text(path, name, context));
    stated.map_err(|unreadable| unusable(path, shown, text, unreadable, context))
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
