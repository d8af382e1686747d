//! Writing an answer: whole or not at all, and never with a panic.

use std::fmt::Display;
use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, ErrorKind, IsTerminal, Write};
use std::path::{Component, Path, PathBuf};

use serde::Serialize;
use technolog::document::cleaned_lines;
use technolog::knowledge::Diagnostic;
use technolog::knowledge::input::unseen;
use technolog::words::say;

use super::CliError;
use super::problems::of_system;
use super::words::{self, Lang};

/// Writes an answer to the screen, or to a file; `-` is the screen.
///
/// # Errors
/// It cannot be written. A reader of the screen that went away (`| head`) is no error.
pub fn write(answer: &[u8], file: Option<&Path>, lang: Lang) -> Result<(), CliError> {
    match file {
        Some(path) if path != Path::new("-") && is_dangling(path) => {
            let message = words::cannot_write(lang, path.display(), lang.word("file-dangling-link"));
            Err(Diagnostic::error("unwritable", message, None).help(lang.word("cli-replace-link")).into())
        }
        Some(path) if path != Path::new("-") => to_file(answer, path).map_err(|error| {
            let message = match error.kind() {
                ErrorKind::PermissionDenied => say!(lang, "cli-write-not-permitted", path = path.display()),
                ErrorKind::NotFound => words::cannot_write(lang, path.display(), lang.word("file-no-such-folder")),
                _ => words::cannot_write(lang, path.display(), of_system(&error, lang)),
            };
            Diagnostic::error("unwritable", message, None).help(words::check_folder(lang)).into()
        }),
        _ => match to_screen(answer) {
            Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(unprintable(lang, of_system(&error, lang))),
            _ => Ok(()),
        },
    }
}

/// An answer as JSON. Signs that nobody sees are written as their numbers: programs get them, a terminal does not.
///
/// # Errors
/// It cannot be printed.
pub fn json(answer: &impl Serialize, lang: Lang) -> Result<String, CliError> {
    let text = serde_json::to_string_pretty(answer).map_err(|error| unprintable(lang, error))? + "\n";
    if unseen(&text).is_none() {
        return Ok(text);
    }
    let mut escaped = String::with_capacity(text.len());
    for sign in text.chars() {
        // All of them have no more than four figures.
        if unseen(sign.encode_utf8(&mut [0; 4])).is_some() {
            escaped.push_str(&format!("\\u{:04x}", u32::from(sign)));
        } else {
            escaped.push(sign);
        }
    }
    Ok(escaped)
}

/// The answer cannot be printed.
pub fn unprintable(lang: Lang, error: impl Display) -> CliError {
    Diagnostic::error("unprintable", words::cannot_print(lang, error), None).help(words::print_to_file(lang)).into()
}

/// Whether it is a dangling or circular link: where its author wanted it to lead is not known.
fn is_dangling(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|file| file.is_symlink()) && fs::metadata(path).is_err()
}

/// Narrower than this nothing can be laid out.
#[allow(dead_code, reason = "as emit_document")]
const NARROWEST: usize = 40;
/// What is no terminal is as wide as this.
#[allow(dead_code, reason = "as emit_document")]
const USUAL_WIDTH: usize = 120;

/// What the answer is shown on.
#[derive(Clone, Copy, Debug)]
#[allow(dead_code, reason = "as emit_document")]
pub struct Screen {
    /// Its width in characters.
    pub width: usize,
    /// Whether it shows colours.
    pub colour: bool,
    /// Whether its width is known; otherwise a program may read the output line by line.
    pub narrow: bool,
}

#[allow(dead_code, reason = "as emit_document")]
impl Screen {
    /// The terminal, else a file or a pipe; `COLUMNS` says how wide either is.
    pub fn of(file: Option<&Path>) -> Self {
        let terminal = io::stdout().is_terminal() && file.is_none();
        let said = std::env::var("COLUMNS").ok().and_then(|columns| columns.parse::<usize>().ok());
        let seen = || terminal_size::terminal_size().map(|(width, _)| usize::from(width.0));
        let width = said.or_else(|| if terminal { seen() } else { None }).unwrap_or(USUAL_WIDTH);
        let colour = terminal && std::env::var_os("NO_COLOR").is_none();
        Self { width: width.max(NARROWEST), colour, narrow: terminal || said.is_some() }
    }
}

/// Prints problems to the error stream. Names of files and arguments may contain control characters.
pub fn complain(problems: &str) {
    // Where not even this can be printed there is nobody to tell.
    let _ = io::stderr().lock().write_all(cleaned_lines(problems).as_bytes());
}

/// The way to a file from a folder, both absolute.
pub fn relative(file: &Path, folder: &Path) -> PathBuf {
    let shared = file.components().zip(folder.components()).take_while(|(a, b)| a == b).count();
    let up = folder.components().skip(shared).map(|_| Component::ParentDir);
    up.chain(file.components().skip(shared)).collect()
}

fn to_screen(answer: &[u8]) -> io::Result<()> {
    let mut screen = io::stdout().lock();
    screen.write_all(answer)?;
    screen.flush()
}

/// Writes beside the file and renames, so that the file is the old one or the new one, whole, also after a power cut.
fn to_file(answer: &[u8], path: &Path) -> io::Result<()> {
    // Through a link to the file it means; a rename would replace the link.
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let old = fs::metadata(&path).ok();
    if old.as_ref().is_some_and(|old| !old.is_file()) {
        // A device or a pipe cannot be replaced; a folder refuses by itself.
        return OpenOptions::new().write(true).open(&path)?.write_all(answer);
    }
    if let Some(old) = &old {
        // The folder may allow what the file does not.
        if old.permissions().readonly() {
            return Err(ErrorKind::PermissionDenied.into());
        }
        OpenOptions::new().write(true).open(&path)?;
    }
    remove_stale(&path);
    let (mut file, temporary) = beside(&path)?;
    let written = file.write_all(answer).and_then(|()| match &old {
        Some(old) => file.set_permissions(kept(old.permissions())),
        None => Ok(()),
    });
    let renamed = written.and_then(|()| file.sync_all()).and_then(|()| fs::rename(&temporary, &path));
    if renamed.is_err() {
        // The first error is the one to tell of.
        let _ = fs::remove_file(&temporary);
    }
    renamed
}

/// Permissions of the old file stay, but not set-user-id and its like: they were given to another program.
#[cfg(unix)]
fn kept(old: Permissions) -> Permissions {
    use std::os::unix::fs::PermissionsExt;
    Permissions::from_mode(old.mode() & 0o777)
}

#[cfg(not(unix))]
fn kept(old: Permissions) -> Permissions {
    old
}

/// Removes what a killed run left beside the file: a temporary file that is not locked. What cannot be removed harms
/// nobody.
fn remove_stale(path: &Path) {
    let (Some(name), Some(folder)) = (path.file_name(), path.parent()) else { return };
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let begin = format!(".{}.", name.to_string_lossy());
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if !name.strip_prefix(&begin).and_then(|rest| rest.strip_suffix(TEMPORARY)).is_some_and(is_number_of_run) {
            continue;
        }
        if File::open(entry.path()).is_ok_and(|file| file.try_lock().is_ok()) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// How temporary files end; before it stand the number of the process and that of its attempt.
const TEMPORARY: &str = ".technolog-tmp";

fn is_number_of_run(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'-')
}

/// A new file in the same folder, so that the rename stays on one disk.
fn beside(path: &Path) -> io::Result<(File, PathBuf)> {
    let Some(name) = path.file_name() else {
        return Err(ErrorKind::InvalidFilename.into());
    };
    for attempt in 0_u32.. {
        let mut hidden = std::ffi::OsString::from(".");
        hidden.push(name);
        hidden.push(format!(".{}-{attempt}{TEMPORARY}", std::process::id()));
        let temporary = path.with_file_name(hidden);
        match OpenOptions::new().write(true).create_new(true).open(&temporary) {
            Ok(file) => {
                // Where files cannot be locked they are not taken for stale either.
                let _ = file.try_lock();
                return Ok((file, temporary));
            }
            Err(error) if error.kind() == ErrorKind::AlreadyExists && attempt < 100 => {}
            Err(error) => return Err(error),
        }
    }
    Err(ErrorKind::AlreadyExists.into())
}
