//! Diagnostics: the fault, its place and the remedy; one type for every problem of an input file.

use std::fmt;
use std::sync::Arc;

use technolog_note::Note;

/// The severity of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// The file cannot be used.
    Error,
    /// It can be used, but breaks a rule of the project.
    Warning,
    /// Worth knowing.
    Note,
}

/// A stretch of one line of a file. Line and column count from one, in characters.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// The file as the user named it.
    pub file: Arc<str>,
    /// Line, from 1.
    pub line: u32,
    /// Column, from 1.
    pub column: u32,
    /// Characters to underline, at least 1.
    pub width: u32,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.file, self.line, self.column)
    }
}

/// A problem of an input file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// How grave.
    pub severity: Severity,
    /// Stable id of the kind of problem, kebab-case.
    pub code: &'static str,
    /// What is wrong.
    pub message: Note,
    /// Where; absent when the whole file is meant.
    pub place: Option<Place>,
    /// What to do.
    pub help: Option<Note>,
}

impl Diagnostic {
    /// An error at a place.
    pub fn error(code: &'static str, message: impl Into<Note>, place: impl Into<Option<Place>>) -> Self {
        Self { severity: Severity::Error, code, message: message.into(), place: place.into(), help: None }
    }

    /// A warning at a place.
    pub fn warning(code: &'static str, message: impl Into<Note>, place: impl Into<Option<Place>>) -> Self {
        Self { severity: Severity::Warning, ..Self::error(code, message, place) }
    }

    /// With what to do.
    #[must_use]
    pub fn help(self, help: impl Into<Note>) -> Self {
        Self { help: Some(help.into()), ..self }
    }
}

impl Diagnostic {
    /// One line: `file:line:column: fault [code]; remedy`; `say` makes the sentences.
    pub fn text(&self, say: impl Fn(&Note) -> String) -> String {
        let place = self.place.as_ref().map_or_else(String::new, |place| format!("{place}: "));
        let help = self.help.as_ref().map_or_else(String::new, |help| format!("; {}", say(help)));
        format!("{place}{} [{}]{help}", say(&self.message), self.code)
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(Note::to_string))
    }
}

/// The known name nearest to a mistyped one, if it is near enough to be the meant one.
pub fn nearest<'a>(typed: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    nearest_few(typed, known).first().copied()
}

/// The number of letters of a long word.
const LONG: usize = 7;

/// As `nearest`, with all names that are equally near, in order.
pub(crate) fn nearest_few<'a>(typed: &str, known: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let typed: Vec<char> = typed.chars().collect();
    // One error in three letters, and one more in a long word, which few others resemble: a wrong hint is worse than
    // none. A word of a single letter permits no error.
    let limit = (typed.len() / 3).max(usize::from(typed.len() > 1)) + usize::from(typed.len() >= LONG);
    let mut near: Vec<(usize, &str)> =
        known.into_iter().filter_map(|name| Some((edit_distance(&typed, name, limit)?, name))).collect();
    near.sort_unstable();
    let least = near.first().map(|(distance, _)| *distance);
    near.into_iter().take_while(|(distance, _)| Some(*distance) == least).map(|(_, name)| name).collect()
}

/// Levenshtein distance in characters, if it is within a limit; two swapped neighbours count as one error. A much
/// longer text is rejected at once.
pub(crate) fn edit_distance(a: &[char], b: &str, limit: usize) -> Option<usize> {
    let b: Vec<char> = b.chars().take(a.len() + limit + 1).collect();
    if a.len().abs_diff(b.len()) > limit {
        return None;
    }
    let mut row: Vec<usize> = (0..=b.len()).collect();
    let (mut above, mut before) = (row.clone(), row.clone());
    for (i, ca) in a.iter().enumerate() {
        std::mem::swap(&mut before, &mut above);
        above.clone_from(&row);
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, cb) in b.iter().enumerate() {
            let substituted = diagonal + usize::from(ca != cb);
            diagonal = row[j + 1];
            row[j + 1] = substituted.min(row[j] + 1).min(diagonal + 1);
            if i > 0 && j > 0 && a[i - 1] == *cb && b[j - 1] == *ca {
                row[j + 1] = row[j + 1].min(before[j - 1] + 1);
            }
        }
        // The distance is not less than the least value of any row.
        if row.iter().all(|distance| *distance > limit) {
            return None;
        }
    }
    Some(row[b.len()]).filter(|distance| *distance <= limit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_of_the_finger_finds_its_key() {
        let known = ["diameter", "depth", "roughness"];
        assert_eq!(nearest("diametr", known), Some("diameter"));
        assert_eq!(nearest("rouhgness", known), Some("roughness"));
        assert_eq!(nearest("colour", known), None);
    }

    #[test]
    fn a_distance_is_told_within_its_limit() {
        // Levenshtein's own kind of example, and the lengths alone.
        for (a, b, distance) in [
            ("kitten", "sitting", 3),
            ("", "abc", 3),
            ("діаметр", "диаметр", 1),
            ("a", "a", 0),
            ("nmae", "name", 1),
            ("rouhgness", "roughness", 1),
        ] {
            let a: Vec<char> = a.chars().collect();
            assert_eq!(edit_distance(&a, b, distance), Some(distance), "{b}");
            assert_eq!(edit_distance(&a, b, distance + 5), Some(distance), "{b}");
            assert_eq!(distance.checked_sub(1).and_then(|less| edit_distance(&a, b, less)), None, "{b}");
        }
    }
}
