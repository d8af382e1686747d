//! The files of cases, and the files that they name.

use std::io;
use std::path::{Path, PathBuf};

use technolog::audit::Files;
use technolog::cases::{CaseFile, FileKind, ReadContext, read_cases};
use technolog::knowledge::{Diagnostic, Knowledge};
use technolog::report::Lang;
use technolog::turning::shaft::Mistake;
use technolog::words::say;

use super::super::input::{self, FileRoots};
use super::super::problems::unreadable;
use super::super::{CliError, Context, kind};

/// The end of a case file's name in a folder.
const ENDING: &str = ".test.yaml";

/// A file of cases.
pub struct SourceFile {
    pub path: PathBuf,
    /// Its name for the user.
    pub shown: String,
    pub text: String,
    /// The folder from the command line in which it was found.
    pub folder: Option<PathBuf>,
    /// Why it is not text.
    pub problem: Option<Diagnostic>,
}

/// All files of cases, each once: those that are given, and those in folders in the order of their names.
///
/// # Errors
/// A path cannot be read, or a folder has no cases.
pub fn collect(paths: &[PathBuf], context: &Context) -> Result<Vec<SourceFile>, CliError> {
    let unreadable = |path: &Path, error: io::Error| unreadable(path.display(), &error, context.lang);
    let mut files: Vec<(PathBuf, Option<PathBuf>)> = Vec::new();
    for path in paths {
        let mut found = Vec::new();
        if path.is_dir() {
            walk(path, &mut found).map_err(|error| unreadable(path, error))?;
            if found.is_empty() {
                let message = say!(context.lang, "test-no-cases", folder = path.display().to_string());
                return Err(Diagnostic::error("no-cases", message, None)
                    .help(context.word("test-what-is-a-case"))
                    .into());
            }
        } else {
            found.push(path.clone());
        }
        for file in found {
            if !files.iter().any(|(known, _)| *known == file) {
                files.push((file, Some(path.clone()).filter(|path| path.is_dir())));
            }
        }
    }
    let read = |(path, folder): (PathBuf, Option<PathBuf>)| {
        let shown = path.display().to_string();
        let (text, problem) = match input::text_in_folder(&path, context) {
            Ok(text) => (text, None),
            Err(CliError::Unusable { problems, .. }) => (String::new(), problems.into_iter().next()),
            Err(error) => return Err(error),
        };
        Ok(SourceFile { path, shown, text, folder, problem })
    };
    files.into_iter().map(read).collect()
}

/// Hidden files are skipped, and links to folders, which could form a cycle.
fn walk(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    let mut entries = std::fs::read_dir(folder)?.collect::<io::Result<Vec<_>>>()?;
    entries.sort_by_key(std::fs::DirEntry::file_name);
    for entry in entries {
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.starts_with('.') {
            continue;
        }
        if entry.file_type()?.is_dir() {
            walk(&entry.path(), files)?;
        } else if name.ends_with(ENDING) {
            files.push(entry.path());
        }
    }
    Ok(())
}

/// Checks that `-o` overwrites no file of cases, and that a copy is of one file.
///
/// # Errors
/// It would overwrite one, or there are several.
pub fn spare_inputs(found: &[SourceFile], write: bool, context: &Context) -> Result<(), CliError> {
    found.iter().for_each(|file| context.uses(&file.path));
    context.spare_inputs(context.output.as_deref())?;
    let copy = context.output.as_deref().is_some_and(|output| output != Path::new("-"));
    if copy && write && found.len() != 1 {
        let problem = Diagnostic::error("several-files", context.word("test-one-copy"), None);
        return Err(problem.help(context.word("test-one-by-one")).into());
    }
    Ok(())
}

/// Reads a file of cases.
pub fn read(found: &SourceFile, anywhere: bool, knowledge: &Knowledge, context: &Context) -> CaseFile {
    if found.problem.is_some() {
        let (cases, mistakes, texts) = (Vec::new(), Vec::new(), Vec::new());
        return CaseFile { file: found.shown.clone(), cases, mistakes, texts };
    }
    let (files, codes) = (reader(found, anywhere, context), codes());
    let mut read = read_cases(&found.shown, &found.text, around(knowledge, &codes, &files));
    if !read.mistakes.is_empty()
        && let Some(other) = kind::wrong_kind(&found.shown, &found.text, FileKind::Cases, context)
    {
        read.mistakes = vec![Mistake::Form(other)];
    }
    read
}

/// The context for reading cases.
pub fn around<'a>(knowledge: &'a Knowledge, codes: &'a [String], files: Files<'a>) -> ReadContext<'a> {
    ReadContext { knowledge, codes, files }
}

/// Every code that a finding can have.
pub fn codes() -> Vec<String> {
    Lang::codes()
}

/// Reads the files that a file of cases names.
pub fn reader<'c>(
    found: &'c SourceFile,
    anywhere: bool,
    context: &'c Context,
) -> impl Fn(&str) -> Result<String, String> + use<'c> {
    let places = FileRoots { folder: found.folder.as_deref(), anywhere };
    move |name: &str| places.text(&found.path, name, context)
}
