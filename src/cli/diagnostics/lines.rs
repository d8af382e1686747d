//! Finds the lines of a text once; then the part of a line around any place costs the same, however long text and
//! lines are.

use technolog::knowledge::Place;

/// The distance in characters between places with known byte positions.
const STEP: usize = 256;

/// The room that the marks of cut ends take in a line.
const CUTS: usize = 2 * "...".len();

/// The lines of a text.
pub struct Lines<'t> {
    text: &'t str,
    lines: Vec<Line>,
    /// The byte position of every [`STEP`]th character of the text.
    steps: Vec<usize>,
}

/// A line without its end.
struct Line {
    /// Characters of the text before it.
    before: usize,
    /// Its characters.
    length: usize,
}

/// A part of a line around a place.
#[derive(Debug, PartialEq, Eq)]
pub struct Stretch<'t> {
    /// The text before the place.
    pub before: &'t str,
    /// The text of the place; empty at the end of a line.
    pub marked: &'t str,
    /// The text after the place.
    pub behind: &'t str,
    /// Whether the line begins before this part.
    pub cut_before: bool,
    /// Whether it continues after this part.
    pub cut_behind: bool,
}

impl<'t> Lines<'t> {
    /// The lines of a text.
    pub fn of(text: &'t str) -> Self {
        let mut lines = Vec::new();
        let mut before = 0;
        for whole in text.split_inclusive('\n') {
            let line = whole.strip_suffix('\n').map_or(whole, |line| line.strip_suffix('\r').unwrap_or(line));
            let length = line.chars().count();
            lines.push(Line { before, length });
            before += length + whole.len() - line.len();
        }
        let steps = text.char_indices().step_by(STEP).map(|(byte, _)| byte).collect();
        Self { text, lines, steps }
    }

    /// The line of a place, or what of it there is room for around the place, so many characters with the signs of cut
    /// ends; none if the text has no such line.
    pub fn around(&self, place: &Place, room: usize) -> Option<Stretch<'t>> {
        let line = self.lines.get(usize::try_from(place.line).ok()?.checked_sub(1)?)?;
        let number = |figure: u32| usize::try_from(figure).unwrap_or(usize::MAX);
        let whole = line.length <= room;
        let room = if whole { room } else { room.saturating_sub(CUTS) };
        let first = number(place.column).saturating_sub(1).min(line.length);
        let most = if whole { room } else { room / 2 };
        let width = number(place.width).clamp(1, most.max(1)).min(line.length - first);
        let begin = (first + width / 2).saturating_sub(room / 2).min(line.length.saturating_sub(room));
        let end = (begin + room).min(line.length);
        let part = |from: usize, to: usize| self.text.get(self.byte(line.before + from)..self.byte(line.before + to));
        Some(Stretch {
            before: part(begin, first)?,
            marked: part(first, first + width)?,
            behind: part(first + width, end)?,
            cut_before: begin > 0,
            cut_behind: end < line.length,
        })
    }

    /// The byte position of a character.
    fn byte(&self, character: usize) -> usize {
        let Some(&step) = self.steps.get(character / STEP) else { return self.text.len() };
        let on = self.text[step..].char_indices().nth(character % STEP);
        on.map_or(self.text.len(), |(byte, _)| step + byte)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn around(text: &str, line: u32, column: u32, width: u32, room: usize) -> Option<String> {
        let place = Place { file: "t".into(), line, column, width };
        let stretch = Lines::of(text).around(&place, room)?;
        let dots = |cut: bool| if cut { "…" } else { "" };
        let Stretch { before, marked: meant, behind, cut_before, cut_behind } = stretch;
        Some(format!("{}{before}<{meant}>{behind}{}", dots(cut_before), dots(cut_behind)))
    }

    #[test]
    fn a_place_is_found_in_any_line() {
        let text = "ключ: 1\r\n\nназва: біда\nend";
        for (line, column, width, found) in [
            (1, 7, 1, "ключ: <1>"),
            (1, 8, 1, "ключ: 1<>"),
            (1, 1, 99, "<ключ: 1>"),
            (2, 1, 1, "<>"),
            (3, 8, 4, "назва: <біда>"),
            (4, 3, 1, "en<d>"),
        ] {
            assert_eq!(around(text, line, column, width, 40).as_deref(), Some(found));
        }
        for line in [0, 5, u32::MAX] {
            assert_eq!(around(text, line, 1, 1, 40), None);
        }
        assert_eq!(around("", 1, 1, 1, 40), None);
    }

    #[test]
    fn of_a_long_line_the_stretch_around_the_place_is_shown() {
        let text = format!("short\n{}\nshort", "абвгґ".repeat(1000));
        assert_eq!(around(&text, 2, 1, 1, 16).as_deref(), Some("<а>бвгґабвгґ…"));
        assert_eq!(around(&text, 2, 2503, 2, 16).as_deref(), Some("…гґаб<вг>ґабв…"));
        assert_eq!(around(&text, 2, 5000, 1, 16).as_deref(), Some("…абвгґабвг<ґ>"));
        assert_eq!(around(&text, 2, 9999, 1, 16).as_deref(), Some("…абвгґабвгґ<>"));
        assert_eq!(around(&text, 2, 1, u32::MAX, 16).as_deref(), Some("<абвгґ>абвгґ…"));
        assert_eq!(around(&text, 3, 1, 5, 16).as_deref(), Some("<short>"));
    }
}
