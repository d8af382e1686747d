//! Plain lists of points: comma-separated `x,y` in millimetres, and the `EUC_2D` files of TSPLIB.

use std::sync::Arc;

use crate::knowledge::diagnostic::{Diagnostic, Place};
use crate::part::Point;
use crate::units::Micrometres;

/// The most points of a list: the time of the search grows with their square.
pub const MOST_POINTS: usize = 20_000;
/// The largest coordinate, mm: sums over all points stay exact.
const LARGEST: f64 = 1.0e7;
/// Problems shown of one file; the next ones are mostly like them.
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
    /// What each is called in the list: its number, from 1, or its number in the TSPLIB file.
    pub names: Vec<u64>,
}

/// Reads a list of points.
///
/// # Errors
/// Every line that cannot be used, with its place and what to write instead.
pub fn read_list(file: &str, text: &str) -> Result<List, Vec<Diagnostic>> {
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
        let place = reader.place(1, "", text.lines().next().unwrap_or_default());
        reader.problems.push(
            Diagnostic::error("no-points", "there are no points in the list", place)
                .help("write a line `x,y` for each"),
        );
    }
    if reader.points.len() > MOST_POINTS {
        let message = format!("{} points are more than {MOST_POINTS}", reader.points.len());
        reader.problems.push(Diagnostic::error("too-many-points", message, None).help("split the list"));
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

struct Reader {
    file: Arc<str>,
    problems: Vec<Diagnostic>,
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

    fn wrong(&mut self, code: &'static str, message: String, (number, word, line): (usize, &str, &str), help: &str) {
        if self.problems.len() < SHOWN {
            let place = self.place(number, word, line);
            self.problems.push(Diagnostic::error(code, message, place).help(help));
        }
    }

    fn coordinate(&mut self, word: &str, number: usize, line: &str) -> Option<Micrometres> {
        let word = word.trim();
        match word.parse::<f64>() {
            Ok(value) if value.is_finite() && value.abs() <= LARGEST => Some(Micrometres::from_mm_rounded(value)),
            Ok(_) => {
                let message = format!("`{word}` is beyond {LARGEST} mm");
                self.wrong(
                    "coordinate-too-large",
                    message,
                    (number, word, line),
                    "write the coordinate in millimetres",
                );
                None
            }
            Err(_) => {
                let message = format!("`{word}` is not a number");
                self.wrong(
                    "not-a-number",
                    message,
                    (number, word, line),
                    "write millimetres with a decimal point: 12.5",
                );
                None
            }
        }
    }

    fn csv(&mut self, text: &str) {
        let mut first = true;
        for (index, line) in text.lines().enumerate() {
            let number = index + 1;
            let line = line.strip_prefix('\u{feff}').unwrap_or(line);
            if line.trim().is_empty() || line.trim_start().starts_with('#') {
                continue;
            }
            let split = if line.contains(';') { ';' } else { ',' };
            let cells: Vec<&str> = line.split(split).collect();
            // The head: words, and no number among them.
            let head = cells.iter().all(|cell| cell.trim().parse::<f64>().is_err());
            if std::mem::take(&mut first)
                && head
                && cells.len() == 2
                && cells.iter().all(|cell| !cell.trim().is_empty())
            {
                continue;
            }
            if let [x, y] = cells.as_slice() {
                let (x, y) = (self.coordinate(x, number, line), self.coordinate(y, number, line));
                self.push(x, y, None);
            } else {
                let message = format!("a point has two coordinates, here are {}", cells.len());
                self.wrong("not-a-point", message, (number, "", line), "write `x,y`, with a decimal point: 12.5,-40");
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
                    let message = format!("a node is `number x y`, here are {} words", words.len());
                    self.wrong("not-a-node", message, (number, "", line), "write, for example, `1 12.5 -40`");
                    continue;
                };
                let (x, y) = (self.coordinate(x, number, line), self.coordinate(y, number, line));
                match name.parse::<u64>() {
                    Ok(name) => self.push(x, y, Some(name)),
                    Err(_) => {
                        let message = format!("`{name}` is not the number of a node");
                        self.wrong("not-a-node", message, (number, name, line), "number the nodes from 1");
                    }
                }
            } else if let Some((key, value)) = line.split_once(':') {
                let value = value.trim();
                match key.trim() {
                    "EDGE_WEIGHT_TYPE" if value != "EUC_2D" => {
                        let message = format!("distances of the kind {value} are not read");
                        self.wrong("distance-kind", message, (number, value, line), "only EUC_2D is known");
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
            let message = format!("DIMENSION is `{value}`, and there are {} nodes", self.points.len());
            self.wrong("dimension", message, (number, value, line), "write the number of nodes that follow");
        }
        if !seen_kind && self.problems.is_empty() {
            let line = text.lines().next().unwrap_or_default();
            let message = "EDGE_WEIGHT_TYPE is missing".to_owned();
            self.wrong("distance-kind", message, (1, "", line), "write `EDGE_WEIGHT_TYPE : EUC_2D`");
        }
        let mut names = self.names.clone();
        names.sort_unstable();
        if let Some(twice) = names.windows(2).find(|pair| pair[0] == pair[1]) {
            let message = format!("the node {} stands twice", twice[0]);
            self.problems.push(Diagnostic::error("node-twice", message, None).help("number each node once"));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn codes(text: &str) -> Vec<String> {
        let problems = read_list("list", text).unwrap_err();
        problems
            .iter()
            .map(|problem| {
                let at = problem.place.as_ref().map_or(String::new(), |at| format!(" {}:{}", at.line, at.column));
                assert!(problem.help.is_some(), "{problem}");
                format!("{}{at}", problem.code)
            })
            .collect()
    }

    #[test]
    fn lists_of_both_forms_are_read() {
        for text in
            ["1,2\n3.5,-4\n", "x,y\n1,2\n\n3.5,-4", "X;Y\r\n1;2\r\n3.5; -4\r\n", "\u{feff}x,y\n# a remark\n1,2\n3.5,-4"]
        {
            let list = read_list("list", text).unwrap();
            assert_eq!((list.form, list.names.as_slice()), (Form::Csv, [1, 2].as_slice()), "{text}");
            assert_eq!(list.points[1], Point { x: Micrometres::new(3500), y: Micrometres::from_mm(-4) });
        }
        let text = "NAME: two\nTYPE : TSP\nDIMENSION : 2\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n7 1 2\n8 3.5e0 -4\nEOF\n";
        let list = read_list("list", text).unwrap();
        assert_eq!((list.form, list.names), (Form::Tsplib, vec![7, 8]));
    }

    #[test]
    fn every_slip_is_told_at_once_with_its_place() {
        assert_eq!(
            codes("x,y\n1,two\n3\n1e9,4\n"),
            ["not-a-number 2:3", "not-a-point 3:1", "coordinate-too-large 4:1"]
        );
        assert_eq!(codes(""), ["no-points 1:1"]);
        assert_eq!(codes("x,y\n"), ["no-points 1:1"]);
        assert_eq!(codes("1,2,3\n"), ["not-a-point 1:1"]);
        assert_eq!(codes("nan,inf\n"), ["coordinate-too-large 1:1", "coordinate-too-large 1:5"]);
        assert_eq!(
            codes("NAME: x\nDIMENSION: 2\nEDGE_WEIGHT_TYPE: GEO\nNODE_COORD_SECTION\n1 2\nb 3 4\n"),
            ["distance-kind 3:19", "not-a-node 5:1", "not-a-node 6:1"]
        );
        assert_eq!(
            codes("DIMENSION: 3\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 2 3\n1 2 3\n"),
            ["dimension 1:12", "node-twice"]
        );
        assert_eq!(codes("NODE_COORD_SECTION\n1 2 3\n"), ["distance-kind 1:1"]);
    }
}
