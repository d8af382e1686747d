//! Text in columns: never wider than [`WIDTH`], wrapped between words, widths as the screen counts them.

use tabled::builder::Builder;
use tabled::settings::{Padding, Style};
use unicode_width::UnicodeWidthStr;

/// The widest line that is printed, in columns of the screen.
pub const WIDTH: usize = 120;

/// Narrower than this no column of [`columns`] is made to save its longest word.
const NARROW: usize = 12;

/// A ruled table under a head, or, where that is too wide, the rows in columns without head and rules, indented.
pub fn table(head: &[String], rows: &[Vec<String>], indent: usize) -> String {
    ruled(head, rows).unwrap_or_else(|| columns(rows, indent))
}

/// A ruled table under a head. Nothing, when not even wrapping at every word makes it fit.
pub fn ruled(head: &[String], rows: &[Vec<String>]) -> Option<String> {
    // Each column has a space on both sides, and a rule between two.
    let budget = (WIDTH + 1).checked_sub(3 * head.len())?;
    let measures: Vec<Measure> =
        (0..head.len()).map(|column| Measure::of(&head[column], true).with(rows, column)).collect();
    let widths = fit(&measures, budget)?;
    let mut builder = Builder::default();
    builder.push_record(head.iter().zip(&widths).map(|(cell, &width)| wrap(cell, width, true).join("\n")));
    for row in rows {
        builder.push_record(wrapped(row, &widths));
    }
    let mut table = builder.build();
    table.with(Style::psql());
    Some(trimmed(&table.to_string(), 0))
}

/// Rows in columns without rules, indented.
pub fn columns(rows: &[Vec<String>], indent: usize) -> String {
    let count = rows.iter().map(Vec::len).max().unwrap_or(0);
    if count == 0 {
        return String::new();
    }
    let budget = (WIDTH + 2).saturating_sub(indent + 2 * count);
    let mut measures: Vec<Measure> = (0..count).map(|column| Measure::default().with(rows, column)).collect();
    let widths = fit(&measures, budget).unwrap_or_else(|| {
        for measure in &mut measures {
            measure.least = measure.least.min(NARROW);
        }
        fit(&measures, budget).unwrap_or_else(|| vec![NARROW; count])
    });
    let mut builder = Builder::default();
    for row in rows {
        builder.push_record(wrapped(row, &widths));
    }
    let mut table = builder.build();
    table.with(Style::empty()).with(Padding::new(0, 2, 0, 0));
    trimmed(&table.to_string(), indent)
}

/// A paragraph: its first line indented, the others two columns more.
pub fn paragraph(text: &str, indent: usize) -> String {
    let mut shown = String::new();
    for (number, line) in wrap(text, WIDTH - indent - 2, false).iter().enumerate() {
        let indent = indent + if number == 0 { 0 } else { 2 };
        shown.push_str(format!("{}{line}", " ".repeat(indent)).trim_end());
        shown.push('\n');
    }
    shown
}

/// How wide a column would like to be, and how narrow it can be.
#[derive(Clone, Copy, Default)]
struct Measure {
    most: usize,
    least: usize,
}

impl Measure {
    fn of(cell: &str, head: bool) -> Self {
        let most = cell.lines().map(UnicodeWidthStr::width).max().unwrap_or(0);
        let least = cell.lines().flat_map(|line| pieces(line, head)).map(|(piece, _)| piece.width()).max();
        Self { most, least: least.unwrap_or(0) }
    }

    fn with(self, rows: &[Vec<String>], column: usize) -> Self {
        rows.iter().filter_map(|row| row.get(column)).fold(self, |all, cell| {
            let own = Self::of(cell, false);
            Self { most: all.most.max(own.most), least: all.least.max(own.least) }
        })
    }
}

/// Widths that fit, by narrowing the widest column again and again.
fn fit(measures: &[Measure], budget: usize) -> Option<Vec<usize>> {
    let mut widths: Vec<usize> = measures.iter().map(|measure| measure.most).collect();
    while widths.iter().sum::<usize>() > budget {
        let widest = (0..widths.len()).filter(|&column| widths[column] > measures[column].least.max(1));
        let widest = widest.max_by_key(|&column| widths[column])?;
        widths[widest] -= 1;
    }
    Some(widths)
}

/// The pieces of a line between which it may be broken, each with whether a space stands before it:
/// words, but `Ra 2.5` and `<= 6` stay whole, and `|` stays at the end of its line. Names in heads also
/// part after `_`, and cells after `+`.
fn pieces(line: &str, head: bool) -> Vec<(&str, bool)> {
    let mut spans: Vec<(usize, usize)> = Vec::new();
    let mut held = false;
    let mut rest = 0;
    for word in line.split_whitespace() {
        let start = rest + line[rest..].find(word).unwrap_or(0);
        rest = start + word.len();
        match spans.last_mut() {
            Some((_, end)) if held || word == "|" => *end = rest,
            _ => spans.push((start, rest)),
        }
        held = matches!(word, "Ra" | "Rz" | "<" | "<=" | ">" | ">=" | "→");
    }
    let mut pieces = Vec::new();
    for (start, end) in spans {
        let mut spaced = true;
        let whole = &line[start..end];
        for piece in whole.split_inclusive(if head { '_' } else { '+' }) {
            pieces.push((piece, std::mem::take(&mut spaced)));
        }
    }
    pieces
}

/// A text in lines no wider than that; a word is broken only when it is wider itself.
fn wrap(text: &str, width: usize, head: bool) -> Vec<String> {
    let mut lines = Vec::new();
    for line in text.lines() {
        let mut current = String::new();
        for (piece, spaced) in pieces(line, head) {
            let gap = if spaced && !current.is_empty() { " " } else { "" };
            if current.width() + gap.width() + piece.width() <= width {
                current.push_str(gap);
                current.push_str(piece);
                continue;
            }
            if !current.is_empty() {
                lines.push(std::mem::take(&mut current));
            }
            for letter in piece.chars() {
                if !current.is_empty() && current.width() + letter.to_string().width() > width {
                    lines.push(std::mem::take(&mut current));
                }
                current.push(letter);
            }
        }
        lines.push(current);
    }
    lines
}

fn wrapped(row: &[String], widths: &[usize]) -> Vec<String> {
    row.iter().zip(widths).map(|(cell, &width)| wrap(cell, width, false).join("\n")).collect()
}

/// Without spaces at the ends of lines, indented, with a line break at the end.
fn trimmed(text: &str, indent: usize) -> String {
    let indent = " ".repeat(indent);
    text.lines().map(|line| format!("{}\n", format!("{indent}{line}").trim_end())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn lines_break_between_what_belongs_together() {
        assert_eq!(wrap("Ra 2.5 | Ra 1.25", 10, false), ["Ra 2.5 |", "Ra 1.25"]);
        assert_eq!(wrap("finish_elsewhere", 10, true), ["finish_", "elsewhere"]);
        assert_eq!(wrap("розгортання чистове", 11, false), ["розгортання", "чистове"]);
        assert_eq!(wrap("abcdef", 4, false), ["abcd", "ef"]);
    }

    #[test]
    fn what_cannot_fit_is_refused() {
        let head: Vec<String> = (0..50).map(|column| format!("c{column}")).collect();
        assert_eq!(ruled(&head, &[]), None);
        assert_eq!(ruled(&["x".repeat(119)], &[]), None);
        assert!(ruled(&["x".repeat(118)], &[]).is_some());
    }

    proptest! {
        #![proptest_config(technolog_laws::cases!(256))]

        #[test]
        fn no_line_is_wider_than_the_screen_and_no_letter_is_lost(
            rows in prop::collection::vec(prop::collection::vec("([a-zа-яіїє漢é_]{1,30} ?){0,8}", 4), 1..6)
        ) {
            let letters = |text: &str| text.chars().filter(|letter| letter.is_alphabetic()).count();
            let expected: usize = rows.iter().flatten().map(|cell| letters(cell)).sum();
            let drawn = [columns(&rows, 4), ruled(&rows[0], &rows[1..]).unwrap_or_else(|| columns(&rows, 0))];
            for text in drawn {
                prop_assert!(text.lines().all(|line| line.width() <= WIDTH), "{}", text);
                prop_assert_eq!(letters(&text), expected);
            }
        }
    }
}
