//! Reading the files that the user names: never more than a bound, and each remembered, so that no answer replaces it.

use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use technolog::knowledge::Diagnostic;
use technolog::knowledge::yaml::text_of;
use technolog::words::say;

use super::problems::unreadable;
use super::{CliError, Context};

/// The largest file that is read, bytes.
pub const MOST_BYTES: u64 = 64 << 20;

/// The files that an answer rests on.
#[derive(Debug, Default)]
pub struct Inputs(Mutex<Vec<PathBuf>>);

impl Context {
    /// The text of a file that the answer rests on.
    ///
    /// # Errors
    /// It cannot be read, is too large, or is no text.
    pub fn text(&self, path: &Path) -> Result<String, CliError> {
        self.uses(path);
        let shown = path.display().to_string();
        let bytes = read(path).map_err(|error| unreadable(&shown, &error, self.lang))?;
        Ok(text_of(&shown, bytes)?)
    }

    /// Remembers that the answer rests on this file.
    pub fn uses(&self, path: &Path) {
        self.inputs.0.lock().unwrap_or_else(PoisonError::into_inner).push(path.to_owned());
    }

    /// Sees to it that `-o` replaces nothing that the answer rests on, by whatever path or link it is named.
    ///
    /// # Errors
    /// It would.
    pub fn spare_inputs(&self) -> Result<(), CliError> {
        let Some(output) = self.output.as_deref().filter(|output| output.exists()) else { return Ok(()) };
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

/// The content of a file.
///
/// # Errors
/// It cannot be read, or is larger than [`MOST_BYTES`].
pub fn read(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MOST_BYTES { Err(ErrorKind::FileTooLarge.into()) } else { Ok(bytes) }
}

/// The content of a file that another file names, or that stands in a folder: only of an ordinary one. A pipe would be
/// waited for, a device has no end.
///
/// # Errors
/// As [`read`], or it is no ordinary file.
pub fn read_ordinary(path: &Path) -> io::Result<Vec<u8>> {
    let kind = std::fs::metadata(path)?;
    if kind.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    if kind.is_file() { read(path) } else { Err(ErrorKind::Unsupported.into()) }
}

/// Whether a file lies in a folder or in one below it, by its true place.
pub fn is_below(file: &Path, folder: &Path) -> bool {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    match (file.canonicalize(), folder.canonicalize()) {
        (Ok(file), Ok(folder)) => file.starts_with(folder),
        _ => false,
    }
}
