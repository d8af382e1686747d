//! `technolog check` for a lathe program: its mistakes, its trace and its time.

use std::borrow::Cow;
use std::path::Path;
use std::sync::Arc;

use serde::Serialize;
use technolog::audit::turned;
use technolog::document::{Block, Document};
use technolog::knowledge::{Diagnostic, Severity};
use technolog::note::Figure;
use technolog::program::lathe::{
    LatheLanguage, LatheMotion, LatheRates, LatheTimes, Subprogram, is_serious, read, times, trace,
};
use technolog::units::Minutes;
use technolog::words::say;

use super::check::{Args, FaultMessage, diagnostic, figures_of, findings, total};
use super::diagnostics::Texts;

use super::{CliError, Context, Format, Lang, Outcome, control, knowledge, problems, proof, turn, turn_operation};

/// The answer in JSON.
#[derive(Serialize)]
struct Answer<'a> {
    program: &'a str,
    control: &'a str,
    findings: Vec<FaultMessage<'a>>,
    trace: &'a [LatheMotion],
    time: LatheTimes,
}

/// Checks a lathe program.
///
/// # Errors
/// The program, one of its contour files or the lathe cannot be used.
pub fn run(args: &Args, control: &str, context: &Context) -> Result<Outcome, CliError> {
    let format = context.format("check", &[Format::Text, Format::Json, Format::Markdown, Format::Html])?;
    let knowledge = knowledge::load(context)?;
    let at_fault = |error: technolog::error::KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let language = LatheLanguage::read(control, knowledge).map_err(at_fault)?;
    let part = args.part.as_ref().map(|part| turn::read(part, knowledge, context)).transpose()?;
    // As for a mill, the machine of the part is meant where none is named, and no other than it.
    let of_part = part.as_ref().and_then(|part| part.machine.as_deref());
    let lathe = args.machine.as_deref().or(of_part).map(|id| control::lathe(id, knowledge, context)).transpose()?;
    if let Some((lathe, own)) = lathe.as_ref().zip(of_part) {
        control::same_machine(lathe.id(), own, context)?;
    }
    let rates = lathe.as_ref().map(|lathe| LatheRates { rapid_z: lathe.rapid_z, rapid_x: None });
    let shown = args.program.display().to_string();
    let text = context.text(&args.program)?;
    let beside = contours(&args.program, &text, context)?;
    let files: Vec<Subprogram<'_>> = beside.iter().map(|(name, text)| Subprogram { name, text }).collect();
    let mut run = read(&text, &language, &files);
    if let Some(part) = &part {
        let operation = turn_operation::plan(part, knowledge, context)?;
        let set_up = args.set_up.and_then(|number| u8::try_from(number).ok()).unwrap_or(1);
        let compared = turned::compare_with_part(&operation, set_up, &text, &run, knowledge);
        run.faults.extend(compared.map_err(at_fault)?);
    }
    if let Some(lathe) = &lathe {
        let faults = turned::against_lathe(&run, lathe).map_err(at_fault)?;
        run.faults.extend(faults);
    }
    let time = times(&run.motions, rates);
    match format {
        Format::Json => {
            let findings = findings(&run.faults, context);
            context.emit_json(&Answer { program: &shown, control, findings, trace: &run.motions, time })?;
        }
        _ => {
            let file: Arc<str> = Arc::from(shown.as_str());
            let (reported, more) = context.amount.select(run.faults.iter().collect(), |fault| fault.severity);
            let problems: Vec<Diagnostic> = reported.iter().map(|fault| diagnostic(fault, &file, context)).collect();
            let texts = Texts::default().with(&shown, shown.clone(), Cow::Owned(text.clone()));
            let all: Vec<Severity> = run.faults.iter().map(|fault| proof::shown(fault.severity)).collect();
            let counts = [Severity::Error, Severity::Warning, Severity::Note]
                .map(|severity| all.iter().filter(|one| **one == severity).count());
            let blocks = problems::blocks(problems, more, &texts, format, context);
            let page = page(&shown, (counts, blocks), &run.motions, time, context.lang);
            context.emit_document(&problems::untitled(page, format), format)?;
        }
    }
    // With `--part` the command must not end as done if the program was not compared with the part.
    let unproven = args.part.is_some() && run.faults.iter().all(|fault| fault.code != turned::HELD);
    Ok(if unproven || run.faults.iter().any(is_serious) { Outcome::Findings } else { Outcome::Done })
}

/// The contours of CYCLE95 in files of their own beside the program: `NAME.SPF`.
fn contours(program: &Path, text: &str, context: &Context) -> Result<Vec<(String, String)>, CliError> {
    let mut found: Vec<(String, String)> = Vec::new();
    for call in text.split("CYCLE95").skip(1) {
        let name = call.split('"').nth(1).unwrap_or_default();
        let is_name = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        if !is_name || found.iter().any(|(known, _)| known == name) {
            continue;
        }
        let beside = program.with_file_name(format!("{name}.SPF"));
        if beside.is_file() {
            found.push((name.to_owned(), context.text(&beside)?.to_string()));
        }
    }
    Ok(found)
}

/// The answer for people.
fn page(
    program: &str,
    (counts, problems): ([usize; 3], Vec<Block>),
    motions: &[LatheMotion],
    times: LatheTimes,
    lang: Lang,
) -> Document {
    let mut page = Document::new(lang.tag(), say!(lang, "check-title", program = program));
    page.blocks.extend(problems);
    if !motions.is_empty() {
        page.heading(2, lang.word("check-lathe-trace"));
        let word = |word: &'static str| lang.find(&format!("trace-{word}")).unwrap_or(word);
        let line = |motion| figures_of(&trace::line_in(motion, &word), lang) + "\n";
        page.push(Block::Code(motions.iter().map(line).collect()));
        page.heading(2, lang.word("check-times"));
        let minutes = |minutes: Minutes| Figure::fixed(minutes.0, 2);
        let (feed, dwell) = (minutes(times.feed_min), minutes(times.dwell_min));
        page.paragraph(match times.rapid_min {
            None => say!(lang, "check-lathe-times", feed = feed, dwell = dwell),
            Some(rapid) => say!(
                lang,
                "check-lathe-times-of",
                total = minutes(times.total_min),
                feed = feed,
                rapid = minutes(rapid),
                dwell = dwell,
                left = times.rapids_not_counted
            ),
        });
    }
    page.paragraph(total(counts, lang));
    page
}
