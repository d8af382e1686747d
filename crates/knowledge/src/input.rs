//! Text from outside: limited in size, and valid UTF-8.

use std::io::{self, ErrorKind, Read};
use std::sync::Arc;
use technolog_note::{Note, note};

use crate::diagnostic::{Diagnostic, Place};

/// The largest file, MB.
pub const MOST_MB: usize = 32;
/// The largest file, bytes.
pub const MOST_BYTES: usize = MOST_MB * 1_000_000;

/// The bytes of a source; `None` if there are more than [`MOST_BYTES`], and no more than that is read.
///
/// # Errors
/// It cannot be read.
pub fn bytes_of(source: impl Read) -> io::Result<Option<Vec<u8>>> {
    let mut bytes = Vec::new();
    source.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes)?;
    Ok(Some(bytes).filter(|bytes| bytes.len() <= MOST_BYTES))
}

/// The text of a file's bytes.
///
/// # Errors
/// They are not UTF-8; the place is that of the first wrong byte.
#[expect(clippy::result_large_err, reason = "a file is read once")]
pub fn text_of(file: &str, bytes: Vec<u8>) -> Result<String, Diagnostic> {
    String::from_utf8(bytes).map_err(|error| {
        let sound = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let sound = String::from_utf8_lossy(sound);
        let last = sound.rsplit('\n').next().unwrap_or_default();
        let place = Place {
            file: Arc::from(file),
            line: u32::try_from(sound.matches('\n').count() + 1).unwrap_or(u32::MAX),
            column: u32::try_from(last.chars().count() + 1).unwrap_or(u32::MAX),
            width: 1,
        };
        Diagnostic::error("not-utf8", note!("yaml-from-here-on-utf-text"), place).help(note!("yaml-save-file-utf"))
    })
}

/// The first control character of a text, or the first that changes the direction of writing. Line ends and tabs are
/// permitted.
pub fn unseen(text: &str) -> Option<char> {
    text.chars().find(|sign| match sign {
        '\n' | '\t' => false,
        '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => true,
        '\u{fffe}' | '\u{ffff}' => true,
        sign => sign.is_control(),
    })
}

/// A text with its zero-width characters shown as code points: otherwise nobody could see why `a` differs from `a`.
pub fn show_invisible(text: &str) -> String {
    let wide = |sign: char| if has_no_width(sign) { sign.escape_unicode().to_string() } else { sign.to_string() };
    text.chars().map(wide).collect()
}

/// Whether a character is invisible: joiners, soft hyphens, fillers, variation selectors, tags.
pub fn has_no_width(sign: char) -> bool {
    matches!(
        sign,
        '\u{ad}'
            | '\u{34f}'
            | '\u{115f}'..='\u{1160}'
            | '\u{17b4}'..='\u{17b5}'
            | '\u{180b}'..='\u{180f}'
            | '\u{200b}'..='\u{200d}'
            | '\u{2060}'..='\u{2065}'
            | '\u{206a}'..='\u{206f}'
            | '\u{3164}'
            | '\u{fe00}'..='\u{fe0f}'
            | '\u{feff}'
            | '\u{ffa0}'
            | '\u{fff9}'..='\u{fffb}'
            | '\u{e0000}'..='\u{e0fff}'
    )
}

/// A file that is larger than [`MOST_BYTES`].
pub fn too_large(file: &str) -> Diagnostic {
    let place = Place { file: Arc::from(file), line: 1, column: 1, width: 1 };
    Diagnostic::error("too-large", larger(), place).help(note!("input-check-path-or-split"))
}

/// The operating system's reason for not reading or writing a file.
pub fn of_system(error: &io::Error) -> Note {
    match error.kind() {
        ErrorKind::NotFound => note!("file-not-there"),
        ErrorKind::IsADirectory => note!("file-is-a-folder"),
        ErrorKind::NotADirectory => note!("file-in-no-folder"),
        ErrorKind::PermissionDenied => note!("file-not-permitted"),
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => note!("file-no-room"),
        ErrorKind::ReadOnlyFilesystem => note!("file-disk-read-only"),
        ErrorKind::InvalidFilename => note!("file-name-invalid"),
        // An error without a number has its own text.
        _ => match error.raw_os_error() {
            Some(number) => note!("file-system-error", number = number),
            None => error.to_string().into(),
        },
    }
}

/// The text for such a file.
pub fn larger() -> Note {
    note!("input-file-larger", most = MOST_MB)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_byte_that_is_not_utf8_has_a_place() {
        let problem = text_of("t.yaml", b"a: 1\nb: \xd0\xb0\xcf\xeb\n".to_vec()).unwrap_err();
        assert_eq!(problem.place.unwrap().to_string(), "t.yaml:2:5");
        assert_eq!(text_of("t.yaml", b"a: 1".to_vec()).unwrap(), "a: 1");
    }

    #[test]
    fn of_what_never_ends_no_more_than_the_bound_is_read() {
        /// Counts what is taken of it.
        struct Endless(usize);
        impl Read for Endless {
            fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
                self.0 += buffer.len();
                buffer.fill(b'a');
                Ok(buffer.len())
            }
        }
        let mut source = Endless(0);
        assert_eq!(bytes_of(&mut source).unwrap(), None);
        assert_eq!(source.0, MOST_BYTES + 1);
        assert_eq!(bytes_of(Endless(0).take(MOST_BYTES as u64)).unwrap().map(|bytes| bytes.len()), Some(MOST_BYTES));
    }
}
