//! What the comments of a program say of its tools: the thread that a tap cuts and the diameter of a tool. Nobody has to write
//! them; where somebody has, the program is held to them.

use std::collections::{BTreeMap, BTreeSet};

use technolog_core::ascii::{ascii, says};

use crate::tables::audit::ToolKind;

/// What comments say of tools, by their numbers.
#[derive(Clone, Debug, Default)]
pub(super) struct Names {
    threads: BTreeMap<u32, Vec<Thread>>,
    diameters: BTreeMap<u32, Vec<f64>>,
    edges: BTreeSet<u32>,
    kinds: BTreeMap<u32, BTreeSet<ToolKind>>,
    left: BTreeSet<u32>,
}

/// A word of comments and the kind of tool that it names, the narrower before the wider.
pub(super) type KindWord = (String, ToolKind);

/// A thread that a comment names.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Thread {
    /// As it is written: `M8`, `M8X1`, `1/4-20`.
    pub name: String,
    /// Its pitch, mm; the coarse one where the comment gives none.
    pub pitch: f64,
    /// Its diameter, mm, where it is a metric one and not that in a wire insert.
    pub diameter: Option<f64>,
}

/// A comment or the words of a line, in capitals.
type Line = (String, Vec<String>);

impl Names {
    /// Reads the comments of a text; `coarse` has sizes and pitches of coarse threads, mm, `of_taps` the words of which one stands
    /// beside the thread of a tap: M8 alone may be the coolant. `of_edges` has those of tools that break edges, `of_kinds` those of all.
    pub fn read(
        text: &str,
        coarse: &[(f64, f64)],
        (of_taps, of_edges): (&[String], &[String]),
        of_kinds: &[KindWord],
    ) -> Self {
        let lines: Vec<Line> = text.lines().map(parts).collect();
        let mut names = Self::default();
        let (mut tool, mut wanted) = (0, 0);
        for (index, (words, comments)) in lines.iter().enumerate() {
            let called = number(words, 'T');
            wanted = called.unwrap_or(wanted);
            if [6, 0].iter().any(|code| number(words, 'M') == Some(*code)) {
                tool = wanted;
            }
            // A comment on a line of its own before a tool is called is about that tool.
            let alone = words.trim_start_matches(|c: char| c == 'N' || c.is_ascii_digit()).trim().is_empty();
            let next = lines.iter().skip(index + 1).map(|(words, _)| words).find(|words| !words.trim().is_empty());
            let next = next.filter(|_| alone).and_then(|words| number(words, 'T'));
            for comment in comments {
                let own =
                    comment.trim_start().strip_prefix('T').and_then(|rest| leading(rest)).map(|(number, _)| number);
                let of = own.map(|number| number as u32).or(called).or(next).unwrap_or(tool);
                if let Some(thread) = thread(comment, coarse, of_taps) {
                    names.threads.entry(of).or_default().push(thread);
                }
                names.diameters.entry(of).or_default().extend(diameter(comment));
                let latin = ascii(comment);
                if of_edges.iter().any(|word| says(&latin, word)) {
                    names.edges.insert(of);
                }
                if is_left_hand(&latin) {
                    names.left.insert(of);
                }
                if let Some((_, kind)) = of_kinds.iter().find(|(word, _)| says(&latin, word)) {
                    names.kinds.entry(of).or_default().insert(*kind);
                }
            }
        }
        // There a comment gives inches.
        if lines.iter().any(|(words, _)| number(words, 'G') == Some(20) || words.contains("G20")) {
            names.diameters.clear();
        }
        names
    }

    /// The kind of a tool, where its comments name one and no other.
    pub fn kind(&self, tool: u32) -> Option<ToolKind> {
        let kinds = self.kinds.get(&tool)?;
        kinds.first().copied().filter(|_| kinds.len() == 1)
    }

    /// Whether a comment calls the tool left-hand.
    pub fn is_left_hand(&self, tool: u32) -> bool {
        self.left.contains(&tool)
    }

    /// The diameter of a tool, mm, where its comments give one and no other.
    pub fn diameter(&self, tool: u32) -> Option<f64> {
        self.radius(tool).map(|radius| 2.0 * radius)
    }

    /// The threads that comments name for a tool.
    pub fn threads(&self, tool: u32) -> &[Thread] {
        self.threads.get(&tool).map_or(&[], Vec::as_slice)
    }

    /// The pitches of the threads that comments name, by tools.
    pub fn pitches(&self) -> BTreeMap<u32, Vec<f64>> {
        let of = |threads: &Vec<Thread>| threads.iter().map(|thread| thread.pitch).collect();
        self.threads.iter().map(|(tool, threads)| (*tool, of(threads))).collect()
    }

    /// The tools that break edges.
    pub fn of_edges(&self) -> BTreeSet<u32> {
        self.edges.clone()
    }

    /// The radius of a tool, mm, where its comments give one diameter and no other.
    pub fn radius(&self, tool: u32) -> Option<f64> {
        match self.diameters.get(&tool)?.as_slice() {
            [first, rest @ ..] if rest.iter().all(|other| other == first) => Some(first / 2.0),
            _ => None,
        }
    }
}

/// The words of a line and its comments, in capitals.
fn parts(line: &str) -> Line {
    let (mut words, mut comments, mut comment) = (String::new(), Vec::new(), None::<String>);
    for c in line.chars().flat_map(char::to_uppercase) {
        match (&mut comment, c) {
            (Some(text), ')') => {
                comments.push(std::mem::take(text));
                comment = None;
            }
            (Some(text), c) => text.push(c),
            (None, '(' | ';') => comment = Some(String::new()),
            (None, c) => words.push(c),
        }
    }
    comments.extend(comment);
    (words, comments)
}

/// The number with which a text begins, and what follows it.
fn leading(text: &str) -> Option<(f64, &str)> {
    let end = text.find(|c: char| !(c.is_ascii_digit() || c == '.' || c == ',')).unwrap_or(text.len());
    let (number, rest) = text.split_at_checked(end)?;
    let number = number.trim_end_matches([',', '.']).replace(',', ".");
    number.parse().ok().map(|number| (number, rest))
}

/// Whether a comment calls its tool left-hand: `TAP M8 LH`, `LH DRILL`, `LEFT-HAND TAP`. `LH HOLES` are those on the left.
fn is_left_hand(comment: &str) -> bool {
    ["LEFT HAND", "LEFT-HAND", "LH"].iter().any(|phrase| {
        comment.match_indices(phrase).any(|(at, found)| {
            let (before, behind) = (&comment[..at], &comment[at + found.len()..]);
            let whole = !before.ends_with(|sign: char| sign.is_ascii_alphanumeric())
                && !behind.starts_with(|sign: char| sign.is_ascii_alphanumeric());
            let behind = behind.trim_start_matches([' ', '-']);
            let of_tool = ["TAP", "DRILL", "THREAD", "MILL", "END MILL"].iter().any(|word| says(behind, word));
            whole && (behind.is_empty() || of_tool && !behind.contains("HOLES"))
        })
    })
}

/// The whole number behind the first word of that letter.
fn number(words: &str, letter: char) -> Option<u32> {
    words
        .match_indices(letter)
        .find_map(|(at, _)| leading(words.get(at + letter.len_utf8()..)?))
        .map(|(it, _)| it as u32)
}

/// What follows the first of these letters that begins a word and stands before a number.
fn behind<'t>(text: &'t str, letters: &[&str]) -> Option<(f64, &'t str)> {
    let begins = |at: usize| !text.get(..at).is_some_and(|before| before.ends_with(char::is_alphanumeric));
    letters.iter().find_map(|letter| {
        text.match_indices(letter).filter(|(at, _)| begins(*at)).find_map(|(at, found)| {
            let rest = text.get(at + found.len()..)?;
            leading(rest.trim_start_matches([' ', '=', ':', '.']))
        })
    })
}

/// The thread that a comment names.
fn thread(comment: &str, coarse: &[(f64, f64)], of_taps: &[String]) -> Option<Thread> {
    metric(comment, coarse, of_taps).or_else(|| inch(comment, of_taps))
}

/// An inch thread: its size and its turns to the inch, `1/4-20`, `#10-24`, `10-32 UNF`. What is neither a tap nor called unified
/// may be anything.
fn inch(comment: &str, of_taps: &[String]) -> Option<Thread> {
    let latin = ascii(comment);
    let unified = comment.match_indices("UN").any(|(at, _)| {
        let ends = comment.get(at + 2..).map(|rest| rest.trim_start_matches(['C', 'F', 'E', 'S', 'R', 'J']));
        ends.is_some_and(|rest| !rest.starts_with(char::is_alphabetic))
            && !comment.get(..at).is_some_and(|before| before.ends_with(char::is_alphabetic))
    });
    if !unified && !of_taps.iter().any(|word| says(&latin, word)) {
        return None;
    }
    comment.match_indices('-').find_map(|(at, _)| {
        let size = comment.get(..at)?.trim_end_matches(['"', ' ']);
        let begin = size.trim_end_matches(|c: char| c.is_ascii_digit() || matches!(c, '/' | '#' | '.')).len();
        let before = size.get(..begin)?.trim_end();
        let size = size.get(begin..).filter(|size| size.chars().any(|c| c.is_ascii_digit()))?;
        let (turns, rest) = leading(comment.get(at + 1..)?.trim_start())?;
        let whole = turns.fract() == 0.0 && (4.0..=80.0).contains(&turns);
        // `M8-10`, `T3-20` and `8-6H` are none.
        let letters = rest.starts_with(char::is_alphabetic) && !rest.starts_with("UN");
        let known = whole && !letters && !before.ends_with(|c: char| c.is_alphabetic() && before.len() == begin);
        known.then(|| Thread {
            name: format!("{size}-{turns}"),
            pitch: crate::units::round_to(25.4 / turns, 4),
            diameter: None,
        })
    })
}

/// A metric thread.
fn metric(comment: &str, coarse: &[(f64, f64)], of_taps: &[String]) -> Option<Thread> {
    let (size, rest) = behind(comment, &["M", "М"])?;
    let rest = rest.trim_start();
    let times = rest.strip_prefix(['X', 'Х', '×', '*']).or_else(|| rest.strip_prefix('P'));
    let written = times.and_then(|rest| leading(rest.trim_start())).map(|(pitch, _)| pitch);
    // `M8-1.25`, but not `M8-6H`.
    let dashed = rest.strip_prefix('-').and_then(leading).filter(|(_, rest)| !rest.starts_with(char::is_alphabetic));
    let pitch = written.or(dashed.map(|(pitch, _)| pitch));
    let latin = ascii(comment);
    let named = of_taps.iter().any(|word| says(&latin, word));
    // A tap for a wire insert is wider than the thread in the insert.
    let of_insert = ["STI", "HELICOIL", "HELI-COIL", "INSERT", "EG"].iter().any(|word| says(&latin, word));
    let diameter = Some(size).filter(|_| !of_insert);
    match pitch {
        Some(pitch) if pitch > 0.0 => Some(Thread { name: format!("M{size}x{pitch}"), pitch, diameter }),
        Some(_) => None,
        None => {
            let (_, pitch) = coarse.iter().find(|(known, _)| *known == size && named)?;
            Some(Thread { name: format!("M{size}"), pitch: *pitch, diameter })
        }
    }
}

/// The diameter that a comment gives, mm.
fn diameter(comment: &str) -> Option<f64> {
    behind(comment, &["Ø", "DIAM", "DIA", "D"]).map(|(number, _)| number).filter(|number| *number > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_name_threads_and_diameters() {
        let (coarse, of_taps) = ([(8.0, 1.25), (10.0, 1.5)], ["TAP", "MITCHYK"].map(str::to_owned));
        for (comment, expected) in [
            ("TAP M8", Some(1.25)),
            ("M8X1 TAP", Some(1.0)),
            ("M8 X 1.0", Some(1.0)),
            ("TAP M8-6H", Some(1.25)),
            ("T3 TAP M8-1.25 H3", Some(1.25)),
            ("МІТЧИК М10", Some(1.5)),
            ("M8 COOLANT ON", None),
            ("M30 TAP", None),
            ("TAPER MILL M8", None),
            ("TAP 1/4-20 UNC", Some(1.27)),
            ("1/4\"-20 TAP", Some(1.27)),
            ("#10-32 UNF", Some(0.7938)),
            ("T5 - 10-24 TAP", Some(1.0583)),
            ("1/4-20", None),
            ("DRILL 1/4-2 FLUTES", None),
            ("TAP T3-20", None),
            ("TAP 8-6H", None),
        ] {
            assert_eq!(thread(comment, &coarse, &of_taps).map(|thread| thread.pitch), expected, "{comment}");
        }
        for (comment, expected) in [
            ("T1  D=10. CR=0. - ZMIN=-5. - FLAT END MILL", Some(10.0)),
            ("DRILL D6.8 H2", Some(6.8)),
            ("END MILL", None),
        ] {
            assert_eq!(diameter(comment), expected, "{comment}");
        }
    }

    #[test]
    fn comments_name_the_hand() {
        for (comment, expected) in [
            ("TAP M8 LH", true),
            ("LH DRILL D6 EXTRACTOR", true),
            ("LEFT-HAND TAP M8", true),
            ("TAP M8 LH HOLES", false),
            ("TAP LH SIDE", false),
            ("TAP M8 LHS", false),
            ("TAP M8 RH", false),
        ] {
            assert_eq!(is_left_hand(comment), expected, "{comment}");
        }
    }

    #[test]
    fn a_comment_is_about_the_tool_beside_it() {
        let text = "(T4 TAP M10)\n(TAP M8)\nT3 M6\nG84 Z-10 F1000\n(TAP M10)\nT4\nT4 M6 (D12)\n";
        let names = Names::read(text, &[(8.0, 1.25), (10.0, 1.5)], (&["TAP".to_owned()], &[]), &[]);
        let pitches = |tool| names.threads(tool).iter().map(|thread| thread.pitch).collect::<Vec<_>>();
        assert_eq!((pitches(3), pitches(4)), (vec![1.25], vec![1.5, 1.5]));
        assert_eq!(names.radius(4), Some(6.0));
    }
}
