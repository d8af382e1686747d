//! Plain lists of points: `x,y` in millimetres on each line, and the `EUC_2D` files of TSPLIB.
//!
//! Spreadsheets write such lists in their own ways: with commas, semicolons or tabs between the cells, with cells in
//! quotes, and, where no comma stands between cells, with a decimal comma.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::knowledge::diagnostic::Place;
use crate::note::Note;
use crate::part::Point;
use crate::units::Micrometres;

/// The most points of a list: a path and a bound for so many take a second.
pub const MOST_POINTS: usize = 20_000;
/// The largest coordinate, mm; sums over all points stay exact.
const LARGEST: f64 = 1.0e7;
/// The number of faults shown for one file; further ones are mostly alike.
const SHOWN: usize = 20;

/// The form of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// `x,y` on each line, with or without a head.
    Csv,
    /// A TSPLIB file with `NODE_COORD_SECTION`.
    Tsplib,
}

/// Points with the form they were given in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct List {
    /// Its form.
    pub form: Form,
    /// The points.
    pub points: Vec<Point>,
    /// The name of each point in the list: its number, from 1, or its number in the TSPLIB file.
    pub names: Vec<u64>,
}

/// A fault in a list of points; the words are in the catalogue of `words`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ListFault {
    /// The code, the same as that of the note.
    pub code: &'static str,
    /// What is wrong, with its figures.
    pub note: Note,
    /// The place; absent if the fault concerns the whole file.
    pub place: Option<Place>,
}

/// Reads a list of points.
///
/// # Errors
/// Every line that cannot be used, with its place.
pub fn read_list(file: &str, text: &str) -> Result<List, Vec<ListFault>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let form = if text.lines().any(|line| line.trim().starts_with("NODE_COORD_SECTION")) || keyword(text) {
        Form::Tsplib
    } else {
        Form::Csv
    };
    let mut reader = Reader { file: file.into(), problems: Vec::new(), points: Vec::new(), names: Vec::new() };
    match form {
        Form::Csv => reader.csv(text),
        Form::Tsplib => reader.tsplib(text),
    }
    if reader.problems.is_empty() && reader.points.is_empty() {
        reader.wrong("no-points", &[], (1, "", text.lines().next().unwrap_or_default()));
    }
    if reader.points.len() > MOST_POINTS {
        let figures = [("count", reader.points.len().to_string()), ("most", MOST_POINTS.to_string())];
        reader.slip("too-many-points", &figures, None);
    }
    if reader.problems.is_empty() {
        return Ok(List { form, points: reader.points, names: reader.names });
    }
    reader.problems.truncate(SHOWN);
    Err(reader.problems)
}

/// Whether a file begins as TSPLIB files do.
fn keyword(text: &str) -> bool {
    let first = text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
    ["NAME", "TYPE", "COMMENT", "DIMENSION", "EDGE_WEIGHT_TYPE"]
        .iter()
        .any(|word| first.trim().strip_prefix(word).is_some_and(|rest| rest.trim_start().starts_with(':')))
}

/// The cells of a line, without their quotes. A semicolon or a tab outside quotes separates cells; a comma does so
/// only where there is neither. So cells may contain decimal commas.
fn cells(line: &str) -> Vec<&str> {
    let mut quoted = false;
    let outside: Vec<(usize, char)> = line
        .char_indices()
        .filter(|&(_, letter)| {
            quoted ^= letter == '"';
            !quoted
        })
        .collect();
    let separator =
        [';', '\t'].into_iter().find(|mark| outside.iter().any(|(_, letter)| letter == mark)).unwrap_or(',');
    let mut cells = Vec::new();
    let mut start = 0;
    for at in outside.iter().filter(|(_, letter)| *letter == separator).map(|(at, _)| *at).chain([line.len()]) {
        let cell = line.get(start..at).unwrap_or_default().trim();
        let inside = cell.strip_prefix('"').and_then(|cell| cell.strip_suffix('"'));
        cells.push(inside.unwrap_or(cell).trim());
        start = at + separator.len_utf8();
    }
    cells
}

/// A number with a decimal point or, as spreadsheets in Ukrainian write it, a decimal comma.
fn value(word: &str) -> Option<f64> {
    let pointed = if word.contains('.') { word.to_owned() } else { word.replacen(',', ".", 1) };
    pointed.parse().ok()
}

struct Reader {
    file: Arc<str>,
    problems: Vec<ListFault>,
    points: Vec<Point>,
    names: Vec<u64>,
}

impl Reader {
    /// The place of a word of a line; `word` is a slice of `line`, or empty for the whole line.
    fn place(&self, number: usize, word: &str, line: &str) -> Place {
        let start = (word.as_ptr() as usize).checked_sub(line.as_ptr() as usize).filter(|start| *start <= line.len());
        let (start, word) = start.map_or((0, line), |start| (start, word));
        let before = line.get(..start).unwrap_or_default();
        let count = |text: &str| u32::try_from(text.chars().count()).unwrap_or(u32::MAX);
        Place {
            file: Arc::clone(&self.file),
            line: u32::try_from(number).unwrap_or(u32::MAX),
            column: count(before).saturating_add(1),
            width: count(word).max(1),
        }
    }

    fn slip(&mut self, code: &'static str, figures: &[(&'static str, String)], place: Option<Place>) {
        if self.problems.len() < SHOWN {
            let note = figures.iter().fold(Note::new(code), |note, (name, value)| note.with(*name, value));
            self.problems.push(ListFault { code, note, place });
        }
    }

    /// A fault in a line, `(number, word, line)`.
    fn wrong(
        &mut self,
        code: &'static str,
        figures: &[(&'static str, String)],
        (number, word, line): (usize, &str, &str),
    ) {
        let place = self.place(number, word, line);
        self.slip(code, figures, Some(place));
    }

    fn coordinate(&mut self, word: &str, number: usize, line: &str) -> Option<Micrometres> {
        let word = word.trim();
        let quoted = ("word", word.to_owned());
        match value(word) {
            Some(value) if value.is_finite() && value.abs() <= LARGEST => Some(Micrometres::from_mm_rounded(value)),
            // A word such as `inf` is not accepted as a number, though it can be parsed.
            Some(_) if word.contains(|sign: char| sign.is_ascii_digit()) => {
                self.wrong("coordinate-too-large", &[quoted, ("most", LARGEST.to_string())], (number, word, line));
                None
            }
            _ => {
                self.wrong("not-a-number", &[quoted], (number, word, line));
                None
            }
        }
    }

    fn csv(&mut self, text: &str) {
        let mut first = true;
        for (index, line) in text.lines().enumerate() {
            let number = index + 1;
            if line.trim().is_empty() || line.trim_start().starts_with('#') {
                continue;
            }
            let cells = cells(line);
            // The head line: words, without any number.
            let head = cells.iter().all(|cell| !cell.is_empty() && value(cell).is_none());
            if std::mem::take(&mut first) && head && cells.len() == 2 {
                continue;
            }
            if let [x, y] = cells.as_slice() {
                let (x, y) = (self.coordinate(x, number, line), self.coordinate(y, number, line));
                self.push(x, y, None);
            } else {
                self.wrong("not-a-point", &[("count", cells.len().to_string())], (number, "", line));
            }
        }
    }

    fn push(&mut self, x: Option<Micrometres>, y: Option<Micrometres>, name: Option<u64>) {
        if let (Some(x), Some(y)) = (x, y) {
            self.points.push(Point { x, y });
            self.names.push(name.unwrap_or(self.points.len() as u64));
        }
    }

    fn tsplib(&mut self, text: &str) {
        let (mut inside, mut dimension, mut seen_kind) = (false, None, false);
        let mut seen = BTreeSet::new();
        for (index, line) in text.lines().enumerate() {
            let number = index + 1;
            let words: Vec<&str> = line.split_whitespace().collect();
            if words.is_empty() {
                continue;
            }
            if words[0] == "EOF" {
                break;
            }
            if words[0] == "NODE_COORD_SECTION" {
                inside = true;
            } else if inside && words[0].ends_with("_SECTION") {
                break;
            } else if inside {
                let [name, x, y] = words.as_slice() else {
                    self.wrong("not-a-node", &[("count", words.len().to_string())], (number, "", line));
                    continue;
                };
                let (x, y) = (self.coordinate(x, number, line), self.coordinate(y, number, line));
                match name.parse::<u64>() {
                    Ok(own) if !seen.insert(own) => {
                        self.wrong("node-twice", &[("word", (*name).to_owned())], (number, name, line));
                    }
                    Ok(own) => self.push(x, y, Some(own)),
                    Err(_) => self.wrong("not-a-node-number", &[("word", (*name).to_owned())], (number, name, line)),
                }
            } else if let Some((key, value)) = line.split_once(':') {
                let value = value.trim();
                match key.trim() {
                    "EDGE_WEIGHT_TYPE" if value != "EUC_2D" => {
                        self.wrong("distance-kind", &[("word", value.to_owned())], (number, value, line));
                    }
                    "EDGE_WEIGHT_TYPE" => seen_kind = true,
                    "DIMENSION" => dimension = Some((value.parse::<usize>().ok(), number, value, line)),
                    _ => {}
                }
            }
        }
        if let Some((count, number, value, line)) = dimension
            && self.problems.is_empty()
            && count != Some(self.points.len())
        {
            let figures = [("word", value.to_owned()), ("count", self.points.len().to_string())];
            self.wrong("dimension", &figures, (number, value, line));
        }
        if !seen_kind && self.problems.is_empty() {
            let line = text.lines().next().unwrap_or_default();
            self.wrong("distance-kind-missing", &[], (1, "", line));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_of_both_forms_are_read() {
        for text in [
            "1,2\n3.5,-4\n",
            "x,y\n1,2\n\n3.5,-4",
            "X;Y\r\n1;2\r\n3.5; -4\r\n",
            "\u{feff}x,y\n# a remark\n1,2\n3.5,-4",
            "\u{feff}X;Y\r\n1,0;2,0\r\n3,5;-4,0\r\n",
            "\"Х, мм\",\"Y, мм\"\n\"1\",\"2\"\n\"3,5\",\"-4\"",
            "x\ty\n1\t2\n3,5\t-4",
        ] {
            let list = read_list("list", text).unwrap();
            assert_eq!((list.form, list.names.as_slice()), (Form::Csv, [1, 2].as_slice()), "{text}");
            assert_eq!(list.points[1], Point { x: Micrometres::new(3500), y: Micrometres::from_mm(-4) });
        }
        let text = "NAME: two\nCOMMENT: of nobody: two\nTYPE : TSP\nDIMENSION : 2\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n7 1 2\n 8 3.50000e+00 -4\nEOF\nnothing more\n";
        let list = read_list("list", text).unwrap();
        assert_eq!((list.form, list.names), (Form::Tsplib, vec![7, 8]));
    }
}
