//! Marks in words.

use technolog_audit::marks::{Deduction, Ground, Marks};
use technolog_audit::{Audit, Finding};

use super::super::Lang;
use super::words::whereabouts;
use super::{comma, place, severity};

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
pub(super) fn lines(marks: &Marks, audit: &Audit, lang: Lang) -> Vec<String> {
    // Deductions stand in the order of the findings, one for each.
    let costly = marks.deductions.iter().zip(&audit.findings).filter(|(one, _)| one.points > 0.0);
    let mut lines: Vec<String> = costly.map(|(one, finding)| line(one, finding, &audit.file, lang)).collect();
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

/// `-4 хибно 90:11 свердління A, B: подача S (за вагою)`.
fn line(deduction: &Deduction, finding: &Finding, file: &str, lang: Lang) -> String {
    let by = match deduction.by {
        Ground::Consequence => lang.pick("як наслідок", "as a consequence").to_owned(),
        Ground::Rule => format!("{} {}", lang.pick("за правилом", "by the rule"), deduction.rule),
        Ground::Section => {
            format!("{} «{}»", lang.pick("за розділом", "by the section"), super::heading(deduction.section, lang))
        }
        Ground::Severity => lang.pick("за вагою", "by its severity").to_owned(),
    };
    let capped = if deduction.capped { lang.pick(", до межі", ", up to the cap") } else { "" };
    let points = comma(&deduction.points.to_string(), lang);
    let at = place(finding, file).map(|place| format!(" {place}")).unwrap_or_default();
    let severity = severity(deduction.severity, lang);
    format!("-{points} {severity}{at} {} ({by}{capped})", whereabouts(finding, lang))
}
