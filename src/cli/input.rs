//! The files that a command reads: no more of them than a bound.

use std::fs::File;
use std::io;
use std::path::Path;

use technolog::knowledge::input::{bytes_of, larger, text_of, too_large};

use super::problems::{of_system, unreadable};
use super::{CliError, Context, Lang};

/// The text of a file that the command line names. It may be a pipe.
///
/// # Errors
/// It cannot be read, is too large, or is no text.
pub fn text(path: &Path, context: &Context) -> Result<String, CliError> {
    let shown = path.display().to_string();
    let bytes = File::open(path).and_then(bytes_of).map_err(|error| unreadable(&shown, &error, context.lang))?;
    Ok(text_of(&shown, bytes.ok_or_else(|| too_large(&shown))?)?)
}

/// The text of a file that stands in a folder.
///
/// # Errors
/// As of [`text`], or it is no file but a pipe, which might never end.
pub fn text_in_folder(path: &Path, context: &Context) -> Result<String, CliError> {
    if is_regular(path) { text(path, context) } else { Err(irregular(path, context)) }
}

/// The text of a file that another one names.
///
/// # Errors
/// Why not, as of [`text_in_folder`].
pub fn named(path: &Path, lang: Lang) -> Result<String, String> {
    if !is_regular(path) {
        return Err(lang.word("input-not-regular").to_owned());
    }
    let bytes = File::open(path).and_then(bytes_of).map_err(|error| of_system(&error, lang))?;
    String::from_utf8(bytes.ok_or_else(|| lang.say(&larger()))?).map_err(|error| error.to_string())
}

/// Whether it may be opened: a pipe waits for a writer. What is not there says so when it is opened.
fn is_regular(path: &Path) -> bool {
    std::fs::metadata(path).map_or(true, |file| file.is_file() || file.is_dir())
}

fn irregular(path: &Path, context: &Context) -> CliError {
    let error = io::Error::other(context.word("input-not-regular"));
    unreadable(path.display(), &error, context.lang)
}
