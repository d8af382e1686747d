//! The files that a command reads: limited in size, and remembered so that no answer overwrites them.

use std::fs::File;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use technolog::knowledge::Diagnostic;
use technolog::knowledge::input::{bytes_of, larger, text_of, too_large};
use technolog::words::say;

use super::problems::{of_system, unreadable};
use super::{CliError, Context};

/// The input files of an answer.
#[derive(Debug, Default)]
pub struct Inputs(Mutex<Vec<PathBuf>>);

impl Context {
    /// The text of a file from the command line. It may be a pipe of the shell: standard input, `<(…)`.
    ///
    /// # Errors
    /// It cannot be read, is too large, is not text, or not a file.
    pub fn text(&self, path: &Path) -> Result<String, CliError> {
        self.uses(path);
        if is_opened(path) { read(path, self) } else { text_in_folder(path, self) }
    }

    /// The bytes of a file from the command line, or of one in a folder.
    ///
    /// # Errors
    /// It cannot be read, is too large, or not a file.
    pub fn bytes(&self, path: &Path) -> Result<Vec<u8>, CliError> {
        if !is_opened(path) && !is_regular(path) {
            return Err(irregular(path, self));
        }
        bytes(path, self)
    }

    /// Remembers an input file of the answer.
    pub fn uses(&self, path: &Path) {
        self.inputs.0.lock().unwrap_or_else(PoisonError::into_inner).push(path.to_owned());
    }

    /// Checks that a file of `-o` overwrites no input of the answer, by whatever path or link it is given.
    ///
    /// # Errors
    /// It would overwrite one.
    pub fn spare_inputs(&self, file: Option<&Path>) -> Result<(), CliError> {
        let Some(output) = file.filter(|output| output.exists()) else { return Ok(()) };
        let inputs = self.inputs.0.lock().unwrap_or_else(PoisonError::into_inner);
        let is_input = inputs.iter().any(|input| same_file::is_same_file(input, output).unwrap_or(false));
        let of_knowledge = self.knowledge.as_deref().is_some_and(|folder| is_below(output, folder));
        if !is_input && !of_knowledge {
            return Ok(());
        }
        let message = say!(self.lang, "cli-would-replace-input", file = output.display().to_string());
        Err(Diagnostic::error("replaces-input", message, None).help(self.word("cli-another-file")).into())
    }
}

fn read(path: &Path, context: &Context) -> Result<String, CliError> {
    Ok(text_of(&path.display().to_string(), bytes(path, context)?)?)
}

fn bytes(path: &Path, context: &Context) -> Result<Vec<u8>, CliError> {
    let shown = path.display().to_string();
    let bytes = File::open(path).and_then(bytes_of).map_err(|error| unreadable(&shown, &error, context.lang))?;
    Ok(bytes.ok_or_else(|| too_large(&shown))?)
}

/// The text of a file in a folder; it is not remembered, because it may be any file.
///
/// # Errors
/// It cannot be read, is too large, is not text, or is a pipe, which might never end.
pub fn text_in_folder(path: &Path, context: &Context) -> Result<String, CliError> {
    if is_regular(path) { read(path, context) } else { Err(irregular(path, context)) }
}

/// The folders for files that another file names: below the folder of that file, below one from the command line, or
/// below the working directory. Otherwise the author of a file could make the program show any other file.
#[derive(Clone, Copy, Debug)]
pub struct FileRoots<'p> {
    /// The folder that the command line names.
    pub folder: Option<&'p Path>,
    /// No restriction: the user trusts the file.
    pub anywhere: bool,
}

impl FileRoots<'_> {
    /// The text of a file that another file names, relative to it.
    ///
    /// # Errors
    /// It is elsewhere, or as for [`named`].
    pub fn text(self, by: &Path, name: &str, context: &Context) -> Result<String, String> {
        let own = by.parent().unwrap_or(Path::new(""));
        let path = own.join(name);
        let allowed = [Some(own), self.folder, Some(Path::new(""))];
        if !self.anywhere && !allowed.into_iter().flatten().any(|folder| would_be_below(&path, folder)) {
            return Err(context.word("file-outside").to_owned());
        }
        named(&path, context)
    }
}

/// The text of a file that another file names.
///
/// # Errors
/// The reason, as for [`text_in_folder`].
pub fn named(path: &Path, context: &Context) -> Result<String, String> {
    context.uses(path);
    if !is_regular(path) {
        return Err(context.word("input-not-regular").to_owned());
    }
    let bytes = File::open(path).and_then(bytes_of).map_err(|error| of_system(&error, context.lang))?;
    let bytes = bytes.ok_or_else(|| context.lang.say(&larger()))?;
    String::from_utf8(bytes).map_err(|_| context.word("file-not-utf8").to_owned())
}

/// Whether it may be opened: a pipe, and some system files, would wait for a writer. For a missing file the error
/// comes from opening it.
fn is_regular(path: &Path) -> bool {
    let of_system = || path.canonicalize().is_ok_and(|path| path.starts_with("/proc"));
    std::fs::metadata(path).map_or(true, |file| file.is_dir() || file.is_file() && !of_system())
}

/// Whether the path is a file already opened for this process, such as `/dev/stdin` and the pipes of the shell's
/// `<(…)`.
fn is_opened(path: &Path) -> bool {
    path == Path::new("/dev/stdin") || ["/dev/fd", "/proc/self/fd"].iter().any(|folder| path.starts_with(folder))
}

fn irregular(path: &Path, context: &Context) -> CliError {
    let error = io::Error::other(context.word("input-not-regular"));
    unreadable(path.display(), &error, context.lang)
}

/// Whether a file is in a folder or below it, or would be if it existed: the answer for a file elsewhere must not
/// reveal whether it exists.
fn would_be_below(file: &Path, folder: &Path) -> bool {
    let mut place = file;
    loop {
        if place.as_os_str().is_empty() {
            place = Path::new(".");
        }
        if place.canonicalize().is_ok() {
            return is_below(place, folder);
        }
        // A dangling link, and `..` after a missing folder, may lead anywhere.
        let leads_away = place.is_symlink() || !matches!(place.components().next_back(), Some(Component::Normal(_)));
        match place.parent() {
            Some(parent) if !leads_away => place = parent,
            _ => return false,
        }
    }
}

/// Whether a file is in a folder or below it, by its real path.
pub fn is_below(file: &Path, folder: &Path) -> bool {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    match (file.canonicalize(), folder.canonicalize()) {
        (Ok(file), Ok(folder)) => file.starts_with(folder),
        _ => false,
    }
}
