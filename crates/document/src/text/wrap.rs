//! Words and lines: widths are those on the screen, and lines break only between words.

use unicode_width::UnicodeWidthStr;

use crate::{Inline, Inlines, Severity, clean};

/// The style of words on a coloured terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Style {
    Plain,
    Strong,
    Code,
    Of(Severity),
}

impl Style {
    /// The parameters of the ANSI sequence that begins it.
    const fn begins(self) -> Option<&'static str> {
        match self {
            Self::Plain => None,
            Self::Strong => Some("1"),
            Self::Code => Some("36"),
            Self::Of(Severity::Error) => Some("1;31"),
            Self::Of(Severity::Wrong) => Some("31"),
            Self::Of(Severity::Doubtful) => Some("33"),
            Self::Of(Severity::Note) => Some("32"),
        }
    }
}

/// A unit without line breaks, in runs of one style.
#[derive(Clone, Debug, Default)]
pub(super) struct Word {
    runs: Vec<(String, Style)>,
    pub width: usize,
    /// Whether a space precedes it on a line.
    spaced: bool,
}

impl Word {
    fn push(&mut self, text: &str, style: Style) {
        match self.runs.last_mut() {
            Some((run, same)) if *same == style => run.push_str(text),
            _ => self.runs.push((text.to_owned(), style)),
        }
        self.width = self.plain().width();
    }

    fn plain(&self) -> String {
        self.runs.iter().map(|(run, _)| run.as_str()).collect()
    }

    /// Whether the next word must stay with it, as in `Ra 2.5` and `<= 6`.
    fn holds(&self, next: &Self) -> bool {
        let (own, next) = (self.plain(), next.plain());
        matches!(own.as_str(), "Ra" | "Rz" | "<" | "<=" | ">" | ">=" | "≤" | "≥" | "→")
            || next == "|"
            || next.starts_with('%')
    }
}

/// A line of words.
#[derive(Clone, Debug, Default)]
pub(super) struct Line {
    runs: Vec<(String, Style)>,
    pub width: usize,
}

impl Line {
    /// The line, with its colours if `colour` is set.
    pub fn shown(&self, colour: bool) -> String {
        let mut shown = String::new();
        for (run, style) in &self.runs {
            match style.begins().filter(|_| colour) {
                Some(begins) => shown.push_str(&format!("\u{1b}[{begins}m{run}\u{1b}[0m")),
                None => shown.push_str(run),
            }
        }
        shown
    }

    fn room_for(&self, word: &Word, width: usize) -> bool {
        self.runs.is_empty() || self.width + usize::from(word.spaced) + word.width <= width
    }

    fn push(&mut self, word: &Word) {
        if word.spaced && !self.runs.is_empty() {
            self.runs.push((" ".to_owned(), Style::Plain));
            self.width += 1;
        }
        self.runs.extend(word.runs.iter().cloned());
        self.width += word.width;
    }
}

/// The words of a paragraph or a cell. Code in a sentence has backticks, because not every screen has colours.
pub(super) fn words(inlines: &Inlines) -> Vec<Word> {
    split(inlines, None, None)
}

/// All words in one style.
pub(super) fn styled(inlines: &Inlines, style: Style) -> Vec<Word> {
    split(inlines, Some(style), None)
}

/// The words of a column heading: long names may also be broken after `_`.
pub(super) fn heading_words(inlines: &Inlines) -> Vec<Word> {
    split(inlines, Some(Style::Strong), Some('_'))
}

/// The words of a cell: long names may also be broken after a `+` inside.
pub(super) fn cell_words(inlines: &Inlines) -> Vec<Word> {
    split(inlines, None, Some('+'))
}

fn split(inlines: &Inlines, all: Option<Style>, after: Option<char>) -> Vec<Word> {
    let mut words = Vec::new();
    // Whether the next piece is a continuation of the last word.
    let mut open = false;
    let quoted = inlines.pieces().len() > 1;
    for piece in inlines.pieces() {
        let text = clean::line(&shown(piece, quoted));
        let style = all.unwrap_or(match piece {
            Inline::Strong(_) => Style::Strong,
            Inline::Code(_) => Style::Code,
            Inline::Text(_) | Inline::Quantity { .. } | Inline::Link { .. } => Style::Plain,
        });
        if matches!(piece, Inline::Quantity { .. }) {
            add(&mut words, text.trim(), style, open, None);
            open = true;
            continue;
        }
        for (at, word) in text.split(' ').enumerate() {
            open &= at == 0;
            if !word.is_empty() {
                add(&mut words, word, style, open, after);
                open = true;
            }
        }
    }
    join_inseparable(words)
}

fn shown(piece: &Inline, quoted: bool) -> String {
    match piece {
        Inline::Code(code) if quoted => format!("`{code}`"),
        Inline::Link { text, to } if text != to => format!("{text} ({to})"),
        _ => piece.plain(),
    }
}

/// Adds a piece to the last word or begins a new one; several if it may be broken after a sign inside it.
fn add(words: &mut Vec<Word>, text: &str, style: Style, mut open: bool, after: Option<char>) {
    let mut spaced = true;
    let mut rest = text;
    while !rest.is_empty() {
        // A sign at the beginning belongs to a number.
        let inside = rest.char_indices().skip(1).find(|(_, sign)| Some(*sign) == after);
        let (piece, left) = rest.split_at(inside.map_or(rest.len(), |(at, sign)| at + sign.len_utf8()));
        match words.last_mut().filter(|_| open) {
            Some(word) => word.push(piece, style),
            None => {
                let mut word = Word { spaced, ..Word::default() };
                word.push(piece, style);
                words.push(word);
            }
        }
        (rest, open, spaced) = (left, false, false);
    }
}

/// Joins words that must stay together.
fn join_inseparable(words: Vec<Word>) -> Vec<Word> {
    let mut all: Vec<Word> = Vec::new();
    let mut last = Word::default();
    for word in words {
        let holds = word.spaced && last.holds(&word);
        last = word.clone();
        match all.last_mut().filter(|_| holds) {
            Some(before) => {
                before.push(" ", Style::Plain);
                word.runs.iter().for_each(|(run, style)| before.push(run, *style));
            }
            None => all.push(word),
        }
    }
    all
}

/// Words in lines of the width `first`, then `others`; a line is wider only for a single word.
pub(super) fn wrap(words: &[Word], first: usize, others: usize) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for word in words {
        let width = if lines.len() <= 1 { first } else { others };
        match lines.last_mut() {
            Some(line) if line.room_for(word, width) => line.push(word),
            _ => {
                let mut line = Line::default();
                line.push(word);
                lines.push(line);
            }
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(words: &[Word], width: usize) -> Vec<String> {
        wrap(words, width, width).iter().map(|line| line.shown(false)).collect()
    }

    #[test]
    fn lines_break_between_what_belongs_together() {
        assert_eq!(lines(&words(&"Ra 2.5 | Ra 1.25".into()), 10), ["Ra 2.5 |", "Ra 1.25"]);
        assert_eq!(lines(&words(&"на 2,2 % менше".into()), 6), ["на", "2,2 %", "менше"]);
        assert_eq!(lines(&heading_words(&"finish_elsewhere".into()), 10), ["finish_", "elsewhere"]);
        assert_eq!(lines(&cell_words(&"drill+ream +5".into()), 6), ["drill+", "ream", "+5"]);
        assert_eq!(lines(&words(&Inlines::from("t = ").quantity("0,5", "мм").text(".")), 5), ["t =", "0,5 мм."]);
        assert_eq!(lines(&words(&"abcdef gh".into()), 4), ["abcdef", "gh"]);
    }

    #[test]
    fn code_in_a_sentence_is_quoted() {
        let sentence = Inlines::from("key ").code("rout").text(", not ").code("route");
        assert_eq!(lines(&words(&sentence), 80), ["key `rout`, not `route`"]);
        assert_eq!(lines(&words(&Inlines::default().code("N5 G17")), 80), ["N5 G17"]);
    }

    #[test]
    fn colours_are_no_width() {
        let line = &wrap(&words(&Inlines::from("a").strong("b")), 9, 9)[0];
        assert_eq!((line.width, line.shown(true).as_str()), (2, "a\u{1b}[1mb\u{1b}[0m"));
    }
}
