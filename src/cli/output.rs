//! Writes an answer: completely or not at all, and never with a panic.

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
/// It cannot be written. A closed pipe (`| head`) is no error.
pub fn write(answer: &[u8], file: Option<&Path>, lang: Lang) -> Result<(), CliError> {
    write_all(&[(file, answer)], lang)
}

/// Writes several answers, or none: no file is replaced before all of them are on the disk.
///
/// # Errors
/// One of them cannot be written.
pub fn write_all(answers: &[(Option<&Path>, impl AsRef<[u8]>)], lang: Lang) -> Result<(), CliError> {
    let stage = |(file, answer): &(Option<&Path>, _)| match file.filter(|path| *path != Path::new("-")) {
        Some(path) => staged(AsRef::as_ref(answer), path, lang).map(Some),
        None => Ok(None),
    };
    let staged: Vec<Option<Staged>> = answers.iter().map(stage).collect::<Result<_, _>>()?;
    for (staged, (file, answer)) in staged.into_iter().zip(answers) {
        match (staged, file) {
            (Some(staged), Some(path)) => {
                staged.finish(answer.as_ref()).map_err(|error| unwritable(&error, path, lang))?;
            }
            _ => to_screen(answer.as_ref(), lang)?,
        }
    }
    Ok(())
}

fn staged(answer: &[u8], path: &Path, lang: Lang) -> Result<Staged, CliError> {
    if is_dangling(path) {
        let message = words::cannot_write(lang, path.display(), lang.word("file-dangling-link"));
        return Err(Diagnostic::error("unwritable", message, None).help(lang.word("cli-replace-link")).into());
    }
    Staged::of(answer, path).map_err(|error| unwritable(&error, path, lang))
}

/// A file or folder that cannot be written, with why.
pub fn unwritable(error: &io::Error, path: &Path, lang: Lang) -> CliError {
    let message = match error.kind() {
        ErrorKind::PermissionDenied => say!(lang, "cli-write-not-permitted", path = path.display()),
        ErrorKind::NotFound => words::cannot_write(lang, path.display(), lang.word("file-no-such-folder")),
        _ => words::cannot_write(lang, path.display(), of_system(error, lang)),
    };
    Diagnostic::error("unwritable", message, None).help(words::check_folder(lang)).into()
}

/// An answer as JSON. Invisible characters are written as escapes: programs get them, a terminal does not.
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
        // All of them have at most four hexadecimal digits.
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

/// Whether it is a dangling or circular link: its intended target is not known.
fn is_dangling(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|file| file.is_symlink()) && fs::metadata(path).is_err()
}

/// The least usable width of a page.
const NARROWEST: usize = 40;
/// The width where the output is no terminal.
const USUAL_WIDTH: usize = 120;

/// The properties of the output for layout.
#[derive(Clone, Copy, Debug)]
pub struct Screen {
    /// Its width in characters.
    pub width: usize,
    /// Whether it shows colours.
    pub colour: bool,
    /// Whether its width is known; otherwise a program may read the output line by line.
    pub narrow: bool,
}

impl Screen {
    /// The terminal, otherwise a file or a pipe; `COLUMNS` gives the width of either.
    pub fn of(file: Option<&Path>) -> Self {
        let terminal = io::stdout().is_terminal() && file.is_none();
        let stated = std::env::var("COLUMNS").ok().and_then(|columns| columns.parse::<usize>().ok());
        let seen = || terminal_size::terminal_size().map(|(width, _)| usize::from(width.0));
        let width = stated.or_else(|| if terminal { seen() } else { None }).unwrap_or(USUAL_WIDTH);
        let colour = terminal && std::env::var_os("NO_COLOR").is_none();
        Self { width: width.max(NARROWEST), colour, narrow: terminal || stated.is_some() }
    }
}

/// Prints problems to the error stream. Names of files and arguments may contain control characters.
pub fn complain(problems: &str) {
    // If this cannot be printed either, the error is ignored.
    let _ = io::stderr().lock().write_all(cleaned_lines(problems).as_bytes());
}

/// The path to a file from a folder, both absolute.
pub fn relative(file: &Path, folder: &Path) -> PathBuf {
    let shared = file.components().zip(folder.components()).take_while(|(a, b)| a == b).count();
    let up = folder.components().skip(shared).map(|_| Component::ParentDir);
    up.chain(file.components().skip(shared)).collect()
}

fn to_screen(answer: &[u8], lang: Lang) -> Result<(), CliError> {
    let mut screen = io::stdout().lock();
    match screen.write_all(answer).and_then(|()| screen.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(unprintable(lang, of_system(&error, lang))),
        _ => Ok(()),
    }
}

/// A file that is ready to be replaced. It is completely old or completely new, even after a power cut: the new one is
/// a temporary file beside it, which is renamed.
#[derive(Debug)]
enum Staged {
    /// The temporary file with the answer, and the file it replaces.
    Beside { temporary: PathBuf, path: PathBuf },
    /// A device or a pipe, which cannot be replaced.
    Device(File),
}

impl Staged {
    fn of(answer: &[u8], path: &Path) -> io::Result<Self> {
        // A link is followed to its file, because a rename would replace the link.
        let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let old = fs::metadata(&path).ok();
        if old.as_ref().is_some_and(|old| !old.is_file()) {
            // Opening a folder fails here.
            return OpenOptions::new().write(true).open(&path).map(Self::Device);
        }
        if let Some(old) = &old {
            // The folder may permit what the file does not.
            if old.permissions().readonly() {
                return Err(ErrorKind::PermissionDenied.into());
            }
            OpenOptions::new().write(true).open(&path)?;
        }
        remove_stale(&path);
        let (mut file, temporary) = temporary_file(&path)?;
        let staged = Self::Beside { temporary, path };
        file.write_all(answer)?;
        if let Some(old) = old {
            file.set_permissions(kept(old.permissions()))?;
        }
        file.sync_all()?;
        Ok(staged)
    }

    fn finish(mut self, answer: &[u8]) -> io::Result<()> {
        match &mut self {
            Self::Beside { temporary, path } => fs::rename(temporary, path),
            Self::Device(file) => file.write_all(answer),
        }
    }
}

impl Drop for Staged {
    fn drop(&mut self) {
        if let Self::Beside { temporary, .. } = self {
            // After the rename it is not there; otherwise the first error is the one to report.
            let _ = fs::remove_file(temporary);
        }
    }
}

/// The permissions of the old file, without set-user-id and the like: they were given to another program.
#[cfg(unix)]
fn kept(old: Permissions) -> Permissions {
    use std::os::unix::fs::PermissionsExt;
    Permissions::from_mode(old.mode() & 0o777)
}

#[cfg(not(unix))]
fn kept(old: Permissions) -> Permissions {
    old
}

/// Removes the temporary file of a killed run: one that is not locked. A failure here does no harm.
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

/// The end of the names of temporary files; before it are the numbers of the process and of its attempt.
const TEMPORARY: &str = ".technolog-tmp";

fn is_number_of_run(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'-')
}

/// A new file in the same folder, so that the rename stays on one disk.
fn temporary_file(path: &Path) -> io::Result<(File, PathBuf)> {
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
                // If files cannot be locked, they are not considered stale either.
                let _ = file.try_lock();
                return Ok((file, temporary));
            }
            Err(error) if error.kind() == ErrorKind::AlreadyExists && attempt < 100 => {}
            Err(error) => return Err(error),
        }
    }
    Err(ErrorKind::AlreadyExists.into())
}
