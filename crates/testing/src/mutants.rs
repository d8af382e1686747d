//! Programs with one word deleted, altered or swapped, and what must come of it: something is said of the mutant that is
//! not said of the program, or its motions, states and time are the same.

use std::collections::BTreeMap;
use std::fmt::Write;

use technolog::motion::{Axis, Motion, MotionStep, Position, trace};
use technolog_laws::share;

/// A program with one fault.
#[derive(Clone, Debug)]
pub struct Mutant {
    /// What was done to it.
    pub kind: &'static str,
    /// The line, from 1, and what was there and is now.
    pub line: usize,
    pub change: String,
    pub text: String,
}

/// What a checker says of a program, and what the program does.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Run {
    /// Sentences without their places, and how often each is said.
    pub findings: BTreeMap<String, usize>,
    /// Where the axes go and how.
    pub motions: Vec<String>,
    /// What else is switched, in order, by what it is.
    pub states: BTreeMap<String, Vec<String>>,
    /// Its time.
    pub time: String,
}

impl Run {
    /// Takes the steps apart into motions and states. What moves nothing and switches nothing is left out, and rapids that
    /// go on along one axis are one. The order of two switches of different kinds does not count: what acts in a cut the
    /// proof has to tell.
    pub fn of(steps: &[MotionStep], start: Position, findings: impl IntoIterator<Item = String>, time: String) -> Self {
        let mut run = Self { time, ..Self::default() };
        for sentence in findings {
            *run.findings.entry(sentence).or_default() += 1;
        }
        for kind in ["spindle stopped", "coolant off"] {
            run.switch(kind.to_owned());
        }
        let mut at = start;
        // Where the last rapid began, if the next may go on from it.
        let mut rapid: Option<Position> = None;
        for step in steps {
            // Without line and block.
            let line: String = trace::line(&MotionStep { block: Default::default(), ..step.clone() });
            let line = line.trim_start_matches([' ', '0', '-']).to_owned();
            match step.motion {
                Motion::Rapid | Motion::Feed { .. } if step.at == at => {}
                Motion::Rapid => {
                    let goes_on = rapid.filter(|from| one_way(*from, at, step.at));
                    if goes_on.is_some() {
                        run.motions.pop();
                    }
                    rapid = goes_on.or(Some(at));
                    run.motions.push(line);
                }
                Motion::Feed { .. } | Motion::Arc { .. } | Motion::Dwell { .. } | Motion::End => {
                    rapid = None;
                    run.motions.push(line);
                }
                _ => run.switch(line),
            }
            at = step.at;
        }
        run
    }

    /// Takes a switch, if it is not switched so already.
    fn switch(&mut self, line: String) {
        let kind = line.split(' ').next().unwrap_or_default().to_owned();
        let switches = self.states.entry(kind).or_default();
        if switches.last() != Some(&line) {
            switches.push(line);
        }
    }

    /// Whether something is said of it that is not said of the other, or is said more often.
    pub fn says_more_than(&self, other: &Self) -> bool {
        self.findings.iter().any(|(sentence, count)| other.findings.get(sentence).is_none_or(|before| before < count))
    }

    /// Whether it does the same.
    pub fn does_as(&self, other: &Self) -> bool {
        self.motions == other.motions && self.states == other.states && self.time == other.time
    }
}

/// Whether two ways go along one axis in one direction.
fn one_way(from: Position, by: Position, to: Position) -> bool {
    let ways = Axis::ALL.map(|axis| {
        ((by.get(axis) - from.get(axis)).micrometres().signum(), (to.get(axis) - by.get(axis)).micrometres().signum())
    });
    ways.iter().filter(|(first, _)| *first != 0).count() == 1 && ways.iter().all(|(first, second)| first == second)
}

/// Every mutant of a program.
pub fn mutants(text: &str) -> Vec<Mutant> {
    let lines: Vec<&str> = text.lines().collect();
    let mut mutants = Vec::new();
    let with = |line: usize, content: &str| -> String {
        let mut all = lines.clone();
        all[line] = content;
        all.join("\n") + "\n"
    };
    for (number, line) in lines.iter().enumerate() {
        let words = words(line);
        let mut put = |kind, change: String, content: String| {
            if content != *line {
                mutants.push(Mutant { kind, line: number + 1, change, text: with(number, &content) });
            }
        };
        for (index, &(from, to)) in words.iter().enumerate() {
            let (before, word, after) = (&line[..from], &line[from..to], &line[to..]);
            put("delete", word.to_owned(), format!("{before}{after}"));
            let (address, value) = word.split_at(word.chars().next().map_or(0, char::len_utf8));
            if let Some(thousandths) = thousandths(value) {
                let altered = [
                    ("plus one", thousandths + 1000),
                    ("other sign", -thousandths),
                    ("times ten", thousandths * 10),
                    ("zero", 0),
                ];
                for (kind, altered) in altered {
                    let altered = written(altered, value);
                    put(kind, format!("{word} → {address}{altered}"), format!("{before}{address}{altered}{after}"));
                }
            }
            if let Some(&(next_from, next_to)) = words.get(index + 1) {
                let (next, between) = (&line[next_from..next_to], &line[to..next_from]);
                let rest = &line[next_to..];
                put("swap words", format!("{word} {next}"), format!("{before}{next}{between}{word}{rest}"));
            }
        }
        if let Some(next) = lines.get(number + 1).filter(|next| *next != line) {
            let mut all = lines.clone();
            all.swap(number, number + 1);
            let change = format!("{line} | {next}");
            mutants.push(Mutant { kind: "swap lines", line: number + 1, change, text: all.join("\n") + "\n" });
        }
    }
    mutants
}

/// The words of a line, a letter with its number, by their places; what stands in brackets or behind `;` is a comment.
fn words(line: &str) -> Vec<(usize, usize)> {
    let mut words = Vec::new();
    let bytes = line.as_bytes();
    let (mut at, mut comment) = (0, false);
    while at < bytes.len() {
        match bytes[at] {
            b'(' => comment = true,
            b')' => comment = false,
            b';' if !comment => return words,
            letter if !comment && (letter.is_ascii_alphabetic() || letter == b':') => {
                let mut end = at + 1;
                while bytes.get(end).is_some_and(|c| c.is_ascii_digit() || matches!(c, b'.' | b'-' | b'+')) {
                    end += 1;
                }
                words.push((at, end));
                at = end;
                continue;
            }
            _ => {}
        }
        at += 1;
    }
    words
}

fn thousandths(value: &str) -> Option<i64> {
    let (sign, unsigned) = match value.strip_prefix('-') {
        Some(rest) => (-1, rest),
        None => (1, value),
    };
    let (whole, part) = unsigned.split_once('.').unwrap_or((unsigned, ""));
    let part = format!("{part:0<3}");
    let whole = if whole.is_empty() { 0 } else { whole.parse::<i64>().ok()? };
    (!unsigned.is_empty()).then_some(sign * (whole * 1000 + part.parse::<i64>().ok()?))
}

/// A number as it would be written, with the leading zeros of the one before.
fn written(thousandths: i64, before: &str) -> String {
    let mut text = String::new();
    let digits = before.trim_start_matches('-').split('.').next().unwrap_or_default();
    let width = if digits.starts_with('0') { digits.len() } else { 1 };
    let size = thousandths.abs();
    write!(text, "{}{:0width$}", if thousandths < 0 { "-" } else { "" }, size / 1000).unwrap();
    if size % 1000 != 0 {
        write!(text, ".{}", format!("{:03}", size % 1000).trim_end_matches('0')).unwrap();
    }
    text
}

/// What came of the mutants of a program.
#[derive(Debug, Default)]
pub struct Score {
    /// By kind: how many were noticed, do the same, and are neither.
    pub kinds: BTreeMap<&'static str, [usize; 3]>,
    /// What nobody noticed.
    pub unnoticed: Vec<String>,
}

/// Runs the mutants of a program, a share of every kind: usually each so manieth.
pub fn score(name: &str, text: &str, usual: usize, run: impl Fn(&str) -> Run) -> Score {
    let right = run(text);
    let mut score = Score::default();
    for mutant in share(mutants(text), usual, |mutant| mutant.kind) {
        let made = run(&mutant.text);
        let place = match (made.does_as(&right), made.says_more_than(&right)) {
            (_, true) => 0,
            (true, false) => 1,
            (false, false) => 2,
        };
        score.kinds.entry(mutant.kind).or_default()[place] += 1;
        if place == 2 {
            let differs = |a: &[String], b: &[String]| {
                let at = a.iter().zip(b).position(|(a, b)| a != b).unwrap_or(a.len().min(b.len()));
                format!("{:?} instead of {:?}", b.get(at), a.get(at))
            };
            let difference = if made.motions != right.motions {
                differs(&right.motions, &made.motions)
            } else if made.states != right.states {
                let all = |run: &Run| run.states.values().flatten().cloned().collect::<Vec<_>>();
                differs(&all(&right), &all(&made))
            } else {
                format!("time {} instead of {}", made.time, right.time)
            };
            score.unnoticed.push(format!("{name}:{}: {}: {}: {difference}", mutant.line, mutant.kind, mutant.change));
        }
    }
    score
}
