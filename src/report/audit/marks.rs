//! Marks in words.

use crate::audit::marks::{Deduction, Ground, Marks};

use super::super::Lang;
use super::{comma, severity};

/// `Курсовий проєкт: 71,5 з 100, зараховано`.
pub fn headline(marks: &Marks, lang: Lang) -> String {
    let (points, of) = (marks.points, marks.of);
    let score = format!("{points} {} {of}", lang.pick("з", "of"));
    let passed = match marks.passed {
        Some(true) => lang.pick(", зараховано", ", passed"),
        Some(false) => lang.pick(", не зараховано", ", not passed"),
        None => "",
    };
    let name = if marks.scheme.is_empty() { lang.pick("Бали", "Marks") } else { &marks.scheme };
    format!("{name}: {}{passed}", comma(&score, lang))
}

/// What costs points, a line each; what is free only in numbers.
pub(super) fn lines(marks: &Marks, lang: Lang) -> Vec<String> {
    let mut lines: Vec<String> =
        marks.deductions.iter().filter(|one| one.points > 0.0).map(|one| line(one, lang)).collect();
    let free =
        |by: &dyn Fn(&Deduction) -> bool| marks.deductions.iter().filter(|one| one.points == 0.0 && by(one)).count();
    let (capped, follow) = (free(&|one| one.capped), free(&|one| one.by == Ground::Consequence));
    let rest = free(&|_| true) - capped - follow;
    let mut said = Vec::new();
    let counts =
        [(follow, "наслідків", "consequences"), (capped, "понад межу", "beyond a cap"), (rest, "інших", "others")];
    said.extend(
        counts.iter().filter(|(count, ..)| *count > 0).map(|(count, uk, en)| format!("{} {count}", lang.pick(uk, en))),
    );
    if !said.is_empty() {
        lines.push(format!("{}: {}", lang.pick("без втрати балів", "at no cost"), said.join(", ")));
    }
    lines
}

/// `-4 conditions.2.feed: хибно, за правилом feed`.
fn line(deduction: &Deduction, lang: Lang) -> String {
    let by = match deduction.by {
        Ground::Consequence => lang.pick("як наслідок", "as a consequence").to_owned(),
        Ground::Rule => format!("{} {}", lang.pick("за правилом", "by the rule"), deduction.rule),
        Ground::Section => {
            format!("{} {}", lang.pick("за розділом", "by the section"), super::heading(deduction.section, lang))
        }
        Ground::Severity => lang.pick("за вагою", "by its severity").to_owned(),
    };
    let capped = if deduction.capped { lang.pick(", до межі", ", up to the cap") } else { "" };
    let points = comma(&deduction.points.to_string(), lang);
    format!("-{points} {}: {}, {by}{capped}", deduction.field, severity(deduction.severity, lang))
}
