//! The scheme file: YAML to [`MarkingScheme`], collecting every mistake.

use crate::knowledge::Diagnostic;
use crate::knowledge::diagnostic::nearest;
use crate::knowledge::form::KeyOf;
use crate::knowledge::yaml::{Fields, Node, Problems, parse};
use technolog_note::note;

use super::super::finding::Section;
use super::super::read::{number, scope_of};
use super::scheme::{Deduct, Missing, SchemeFile, Section as Own, Sections};
use super::{BySeverity, MarkingScheme, SectionScheme};
use crate::tables::audit::PlanPart;

const SECTIONS: [(KeyOf<Sections>, Section); 9] = [
    (Sections::route, Section::Route),
    (Sections::tools, Section::Tools),
    (Sections::holders, Section::Holders),
    (Sections::conditions, Section::Conditions),
    (Sections::clamping, Section::Clamping),
    (Sections::lengths, Section::Lengths),
    (Sections::program, Section::Program),
    (Sections::times, Section::Times),
    (Sections::missing, Section::Missing),
];

/// Reads a scheme; `rules` are the ids that a finding can have.
///
/// # Errors
/// Every mistake of the file, each with its place and what to do.
pub fn read_scheme(file: &str, text: &str, rules: &[&str]) -> Result<MarkingScheme, Vec<Diagnostic>> {
    let (root, diagnostics) = parse(file, text);
    let mut problems = Problems(diagnostics);
    let scheme = root.and_then(|root| scheme(&root, rules, &mut problems));
    match scheme {
        Some(scheme) if problems.0.is_empty() => Ok(scheme),
        _ => {
            problems.0.sort_by(|a, b| a.place.cmp(&b.place));
            Err(problems.0)
        }
    }
}

fn scheme(root: &Node, rules: &[&str], problems: &mut Problems) -> Option<MarkingScheme> {
    let mut fields = problems.map(root)?;
    let name = fields.take(SchemeFile::scheme).and_then(|node| problems.name(node)).unwrap_or_default().to_owned();
    let points = fields.need(SchemeFile::points, problems).and_then(|node| positive(node, problems));
    let pass_node = fields.take(SchemeFile::pass);
    let pass = pass_node.and_then(|node| positive(node, problems));
    let deduct = fields.take(SchemeFile::deduct).map(|node| deductions(node, problems)).unwrap_or_default();
    let consequences = fields.take(SchemeFile::consequences).and_then(|node| positive(node, problems)).unwrap_or(0.0);
    let slip_at_most = fields.take(SchemeFile::slip_at_most).and_then(|node| positive(node, problems));
    let sections = fields.take(SchemeFile::sections).map(|node| sections(node, problems)).unwrap_or_default();
    let named = fields.take(SchemeFile::rules).map(|node| by_rule(node, rules, problems)).unwrap_or_default();
    let missing = fields.take(SchemeFile::missing).map(|node| missing(node, problems));
    let scope = fields.take(SchemeFile::scope).map(|node| scope_of(node, problems));
    fields.finish(problems);
    if let (Some(node), Some(pass), Some(points)) = (pass_node, pass, points)
        && pass > points
    {
        let message = note!("planfile-nobody-passes-with-points", pass = pass, points = points);
        problems.error_help::<()>("bad-value", message, &node.place, note!("planfile-pass-at-most-points"));
    }
    Some(MarkingScheme {
        name,
        points: points?,
        pass,
        deduct,
        consequences,
        slip_at_most,
        sections,
        rules: named,
        missing,
        scope,
    })
}

/// Points: a number, not below nothing.
fn positive(node: &Node, problems: &mut Problems) -> Option<f64> {
    let text = problems.text(node)?;
    let value = number(text).map(|(value, _)| value).filter(|value| (0.0..=1e6).contains(value));
    let help = if text.contains(',') {
        note!("yaml-write-decimal-point-number-comma")
    } else if text.starts_with(['-', '−']) {
        note!("planfile-write-how-many-points-taken")
    } else {
        note!("planfile-write-number-points")
    };
    value.or_else(|| {
        problems.error_help("bad-value", note!("planfile-no-number-points", text = text), &node.place, help)
    })
}

fn deductions(node: &Node, problems: &mut Problems) -> BySeverity {
    let Some(mut fields) = problems.map(node) else { return BySeverity::default() };
    let deduct = severities(&mut fields, [Deduct::error, Deduct::wrong, Deduct::doubtful, Deduct::note], problems);
    fields.finish(problems);
    deduct
}

fn severities<F>(fields: &mut Fields<'_, F>, keys: [KeyOf<F>; 4], problems: &mut Problems) -> BySeverity {
    let [error, wrong, doubtful, note] = keys.map(|key| fields.take(key).and_then(|node| positive(node, problems)));
    BySeverity { error, wrong, doubtful, note }
}

fn sections(node: &Node, problems: &mut Problems) -> Vec<(Section, SectionScheme)> {
    let Some(mut fields) = problems.map(node) else { return Vec::new() };
    let mut read = Vec::new();
    for (key, section) in SECTIONS {
        let Some(node) = fields.take(key) else { continue };
        let Some(mut own) = problems.map(node) else { continue };
        let deduct = severities(&mut own, [Own::error, Own::wrong, Own::doubtful, Own::note], problems);
        let at_most = own.take(Own::at_most).and_then(|node| positive(node, problems));
        own.finish(problems);
        read.push((section, SectionScheme { deduct, at_most }));
    }
    fields.finish(problems);
    read
}

fn missing(node: &Node, problems: &mut Problems) -> Vec<(PlanPart, f64)> {
    let Some(mut fields) = problems.map(node) else { return Vec::new() };
    let mut read = Vec::new();
    for (key, part) in [
        (Missing::holes, PlanPart::Holes),
        (Missing::tools, PlanPart::Tools),
        (Missing::conditions, PlanPart::Conditions),
        (Missing::clamping, PlanPart::Clamping),
        (Missing::program, PlanPart::Program),
        (Missing::times, PlanPart::Times),
    ] {
        read.extend(fields.take(key).and_then(|node| positive(node, problems)).map(|points| (part, points)));
    }
    fields.finish(problems);
    read
}

fn by_rule(node: &Node, rules: &[&str], problems: &mut Problems) -> Vec<(String, BySeverity)> {
    let Some(mut fields) = problems.open_map(node) else { return Vec::new() };
    let mut read = Vec::new();
    for (key, node) in fields.remaining() {
        if !rules.contains(&key.text.as_str()) {
            let help = match nearest(&key.text, rules.iter().copied()) {
                Some(near) => note!("cli-did-you-mean", name = near),
                None => note!("planfile-docs-audit-md-lists-rules"),
            };
            problems.error_help::<()>("unknown-rule", note!("planfile-no-rule", key = key.text), &key.place, help);
        }
        let points = match node.text() {
            Some(_) => {
                let points = positive(node, problems);
                BySeverity { error: points, wrong: points, doubtful: points, note: None }
            }
            None => deductions(node, problems),
        };
        read.push((key.text.clone(), points));
    }
    read
}
