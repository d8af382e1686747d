//! The additions of `technolog check --part`: the part's plan and job, and what a program makes of them.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::Serialize;
use technolog::document::{Column, Inlines, Table};
use technolog::knowledge::{Diagnostic, Place, Severity};
use technolog::note;
use technolog::program::proof::{Code, MadeStop, MissingStop, PlannedJob, ProgramFinding, Proof, SuperfluousCut};
use technolog::report;
use technolog::report::backplot::Frame;

use super::check::{MOST_OF_A_KIND, more_of_a_kind};
use super::diagnostics::Amount;
use super::{Context, Lang};

/// The answer in JSON.
#[derive(Serialize)]
pub struct Answer<'a> {
    visits: &'a [MadeStop],
    missing: &'a [MissingStop],
    superfluous: &'a [SuperfluousCut],
    findings: Vec<ProofMessage<'a>>,
}

#[derive(Serialize)]
struct ProofMessage<'a> {
    message: String,
    help: Option<String>,
    #[serde(flatten)]
    finding: &'a ProgramFinding,
}

/// The part below the motions of a program.
pub fn frame(planned: &PlannedJob) -> Frame<'_> {
    Frame::of(&planned.job, &planned.plan.part)
}

/// For each transition, the number of points made and required.
pub fn table(planned: &PlannedJob, proof: &Proof, lang: Lang) -> Table {
    let [hole, transition, tool, made] =
        ["cli-hole", "cli-transition", "cli-tool", "cli-made"].map(|key| lang.word(key));
    let heads = [hole, transition, tool].map(Column::text).into_iter().chain([Column::number(made, "")]);
    let mut table = Table::new(heads);
    let mut counts: BTreeMap<(&str, usize), [usize; 2]> = BTreeMap::new();
    for visit in &proof.visits {
        counts.entry((&visit.hole, visit.transition)).or_default()[0] += 1;
    }
    for stop in &proof.missing {
        counts.entry((&stop.hole, stop.transition)).or_default()[1] += 1;
    }
    for hole in &planned.plan.holes {
        for (number, transition) in hole.transitions.iter().enumerate() {
            let [made, missing] = counts.get(&(hole.name.as_str(), number)).copied().unwrap_or_default();
            // Work on another machine is in no job.
            if made + missing > 0 {
                table.row([
                    Inlines::from(hole.name.as_str()),
                    report::operation_noun(transition.operation.name(), lang).into(),
                    format!("T{}", transition.tool.number).into(),
                    Inlines::number(format!("{made}/{}", made + missing)),
                ]);
            }
        }
    }
    table
}

/// The severity of a finding as that of a diagnostic.
pub const fn shown(severity: note::Severity) -> Severity {
    match severity {
        note::Severity::Error | note::Severity::Wrong => Severity::Error,
        note::Severity::Doubtful => Severity::Warning,
        note::Severity::Note => Severity::Note,
    }
}

/// A finding about the part, with its group of holes.
pub fn sentence(finding: &note::Finding, context: &Context) -> String {
    let sentence = context.lang.say(&finding.note);
    finding.hole.iter().fold(sentence, |sentence, hole| format!("{hole}: {sentence}"))
}

/// Findings about the part as diagnostics, without a place in the program.
pub fn part_diagnostics(findings: &[&note::Finding], context: &Context) -> Vec<Diagnostic> {
    let diagnostic = |finding: &&note::Finding| {
        let message = sentence(finding, context);
        let severity = shown(finding.severity);
        // A finding of the plan has no code of a program: none is shown.
        Diagnostic { severity, code: "", message: message.into(), place: None, help: None }
    };
    findings.iter().map(diagnostic).collect()
}

/// The proof with its texts.
pub fn answer<'a>(proof: &'a Proof, context: &Context) -> Answer<'a> {
    let with_words = |finding: &'a ProgramFinding| ProofMessage {
        message: context.lang.say(&finding.note),
        help: context.lang.remedy(&finding.note),
        finding,
    };
    Answer {
        visits: &proof.visits,
        missing: &proof.missing,
        superfluous: &proof.superfluous,
        findings: proof.findings.iter().map(with_words).collect(),
    }
}

/// The findings to tell, each with the lines of others that it stands for: of many of a kind the first is told, unless all are
/// asked for. What is not made each hole has to know for itself.
fn groups<'a>(proof: &'a Proof, context: &Context) -> Vec<(&'a ProgramFinding, Vec<u32>)> {
    let kind = |finding: &ProgramFinding| (finding.code, finding.severity, finding.tool());
    let mut count: BTreeMap<_, usize> = BTreeMap::new();
    proof.findings.iter().for_each(|finding| *count.entry(kind(finding)).or_default() += 1);
    let grouped = |finding: &ProgramFinding| {
        let many = count.get(&kind(finding)).is_some_and(|of| *of > MOST_OF_A_KIND);
        many && context.amount != Amount::All && finding.code != Code::NotMade
    };
    let mut groups: Vec<(&ProgramFinding, Vec<u32>)> = Vec::new();
    let mut first = BTreeMap::new();
    for finding in &proof.findings {
        match first.get(&kind(finding)).and_then(|index: &usize| groups.get_mut(*index)) {
            Some((_, others)) => others.extend(finding.block.map(|block| block.line)),
            None => {
                if grouped(finding) {
                    first.insert(kind(finding), groups.len());
                }
                groups.push((finding, Vec::new()));
            }
        }
    }
    groups
}

/// The findings with their lines.
pub fn diagnostics(proof: &Proof, text: &str, file: &Arc<str>, context: &Context) -> Vec<Diagnostic> {
    let lines: Vec<&str> = text.lines().collect();
    let one = |(finding, others): (&ProgramFinding, Vec<u32>)| {
        let place = finding.block.map(|block| {
            let line = usize::try_from(block.line).ok().and_then(|line| lines.get(line.checked_sub(1)?));
            let width = line.map_or(1, |line| line.trim_end().chars().count().max(1));
            Place { file: file.clone(), line: block.line, column: 1, width: u32::try_from(width).unwrap_or(1) }
        });
        let sentence = context.lang.say(&finding.note);
        let message = match finding.block.and_then(|block| block.number) {
            Some(number) => format!("N{number}: {sentence}"),
            None => sentence,
        };
        let more = more_of_a_kind(&others, context.lang).map(|more| format!(" ({more})")).unwrap_or_default();
        let message = message + &more;
        let severity = shown(finding.severity);
        let help = context.lang.remedy(&finding.note);
        Diagnostic { severity, code: finding.code.name(), message: message.into(), place, help: help.map(Into::into) }
    };
    groups(proof, context).into_iter().map(one).collect()
}
