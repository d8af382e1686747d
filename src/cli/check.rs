//! `technolog check`: reads and runs a program, and shows its mistakes, its trace and its time; with a part the proof
//! that the program makes it (`proof.rs`).

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use serde::Serialize;
use technolog::cases::FileKind;
use technolog::document::{Block, Document, Table};
use technolog::knowledge::{Diagnostic, Place, Severity};
use technolog::motion::MotionStep;
use technolog::motion::time::{Clock, KnownTimes};
use technolog::motion::trace;
use technolog::note::{Figure, Finding, Note};
use technolog::plan::CuttingMethod;
use technolog::program::lathe::{LatheLanguage, recognised};
use technolog::program::proof::PlannedJob;
use technolog::program::{Fault, Language, Setting, Subject, is_run};
use technolog::report;
use technolog::units::Minutes;
use technolog::words::say;

use super::diagnostics::{Amount, Texts};
use super::usage::whole_number;
use super::{CliError, Context, Format, Lang, Outcome, check_lathe, control, kind, knowledge, plan, problems, proof};

// Read and run an NC program: its mistakes, the trace of its motions, its time
#[derive(Debug, clap::Args)]
pub struct Args {
    #[arg(value_name = "PROGRAM")]
    pub(super) program: PathBuf,
    #[arg(long, value_parser = control::Names { lathes: true })]
    pub(super) control: Option<String>,
    #[arg(long, value_name = "ID")]
    pub(super) machine: Option<String>,
    #[arg(long, value_name = "FILE.yaml")]
    setting: Option<PathBuf>,
    #[arg(long, value_name = "PART.yaml")]
    pub(super) part: Option<PathBuf>,
    #[arg(long, value_name = "N", requires = "part", value_parser = whole_number::<1, 9>)]
    pub(super) set_up: Option<u32>,
}

/// The answer in JSON.
#[derive(Serialize)]
struct Answer<'a> {
    program: &'a str,
    control: &'a str,
    /// The machine whose limits are checked; none where nobody names one.
    machine: Option<&'a str>,
    /// Reasons why no program can make the part.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    part: Vec<String>,
    /// What a program of this machine leaves undone of the part.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    unfinished: Vec<String>,
    findings: Vec<FaultMessage<'a>>,
    trace: &'a [MotionStep],
    time: KnownTimes,
    #[serde(skip_serializing_if = "Option::is_none")]
    proof: Option<proof::Answer<'a>>,
}

#[derive(Serialize)]
pub(super) struct FaultMessage<'a> {
    message: String,
    help: Option<String>,
    #[serde(flatten)]
    fault: &'a Fault,
}

/// The formats of its answers; a drawing only of a program of a mill.
pub const FORMATS: &[Format] = &[Format::Text, Format::Json, Format::Svg, Format::Markdown, Format::Html];

/// The faults of a program that is written for another control.
const OF_ANOTHER_LANGUAGE: [&str; 3] = ["unknown-character", "unknown-address", "unknown-function"];

/// Doubts of a program by itself that are none with a part: its proof knows where metal is and which holes go through.
const SETTLED_BY_PART: [&str; 6] = [
    "tap-beyond-hole-maybe",
    "widens-beyond-hole-maybe",
    "hole-made-later-maybe",
    "tap-hole-wide",
    "rapid-below-zero",
    "rapid-under-begin-maybe",
];

/// Checks a program.
///
/// # Errors
/// The program, the setting or the machine cannot be used.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    if let Some(control) = args.control.as_deref().filter(|control| LatheLanguage::NAMES.contains(control)) {
        return check_lathe::run(args, control, context);
    }
    if args.set_up.is_some() {
        return Err(super::turn::refused("set-up-of-lathe", context));
    }
    let format = context.format("check", FORMATS)?;
    let knowledge = knowledge::load(context)?;
    let at_fault = |error: technolog::error::KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let shown = args.program.display().to_string();
    let text = context.text(&args.program)?;
    let plan =
        args.part.as_deref().map(|part| plan::make(part, CuttingMethod::default(), knowledge, context)).transpose()?;
    let of_part = plan.as_ref().map(|plan| plan.part.machine.clone());
    let named = args.machine.as_deref().or(of_part.as_deref());
    let named = named.map(|machine| control::machine(machine, knowledge, context)).transpose()?;
    if let (Some(machine), Some(own)) = (&named, of_part.as_deref()) {
        control::same_machine(machine.id(), own, context)?;
    }
    let control = control::chosen(args.control.as_deref(), named.as_ref(), knowledge, context)?;
    let language = Language::read(control, knowledge).map_err(at_fault)?;
    // Of a machine that nobody has named the program is not blamed for the limits.
    let assumed = language.own_machine().filter(|_| named.is_none());
    let assumed = assumed.map(|machine| control::machine(machine, knowledge, context)).transpose()?;
    let machine = named.as_ref().or(assumed.as_ref());
    let planned = plan.map(|plan| PlannedJob::of(plan, &language, knowledge)).transpose();
    let mut planned = planned.map_err(at_fault)?;
    let mut setting = match &args.setting {
        None => Setting::default(),
        Some(path) => {
            let (shown, text) = (path.display().to_string(), context.text(path)?);
            language.setting(&shown, &text).map_err(|problems| CliError::Unusable {
                problems: kind::or_other(&shown, &text, FileKind::Setting, problems, context),
                texts: Texts::default().with(&shown, shown.clone(), Cow::Owned(text)),
            })?
        }
    };
    setting.assumed.machine = assumed.is_some();
    if let Some(planned) = &mut planned {
        planned.set(&mut setting);
    }
    let mut sink = (Vec::<MotionStep>::new(), Clock::new(machine, setting.start));
    let mut faults = language.check(&text, machine, &setting, &mut sink);
    let (steps, clock) = sink;
    if faults.iter().any(Fault::is_error) {
        kind::refuse_other(&shown, &text, FileKind::Program, context)?;
        refuse_lathe(&text, control, context)?;
    }
    // Nothing is known of a program that is not run: that it makes no hole follows from its mistakes.
    let is_run = is_run(&faults, &steps);
    if planned.is_some() && is_run {
        faults.retain(|fault| !SETTLED_BY_PART.contains(&fault.code));
    }
    let proof = planned.as_ref().filter(|_| is_run).map(|planned| planned.prove(&steps, &setting));
    let serious = planned.as_ref().map(PlannedJob::serious).unwrap_or_default();
    let undone = planned.as_ref().map(PlannedJob::undone).unwrap_or_default();
    let undone: Vec<&Finding> = undone.iter().collect();
    match format {
        Format::Json => {
            let findings = findings(&faults, context);
            context.emit_json(&Answer {
                program: &shown,
                control,
                machine: machine.map(|machine| machine.id()),
                part: serious.iter().map(|finding| context.lang.say(&finding.note)).collect(),
                unfinished: undone.iter().map(|finding| proof::sentence(finding, context)).collect(),
                findings,
                trace: &steps,
                time: clock.known_times(),
                proof: proof.as_ref().map(|proof| proof::answer(proof, context)),
            })?;
        }
        Format::Svg => {
            let frame = planned.as_ref().map(proof::frame);
            context.emit_cleaned(&report::backplot::backplot(&steps, frame.as_ref(), context.lang))?;
        }
        _ => {
            let file: Arc<str> = Arc::from(shown.as_str());
            // Only shown faults get words: a program may have a fault in every word.
            let groups = groups(&faults, context);
            let (reported, more) = context.amount.select(groups, |group| group.0.severity);
            let mut problems: Vec<Diagnostic> =
                reported.iter().map(|(fault, others)| of_group(fault, others, &file, context)).collect();
            // What is said of the whole program stands before its findings.
            let mut before = 0;
            if args.control.is_none() && faults.iter().any(|fault| OF_ANOTHER_LANGUAGE.contains(&fault.code)) {
                let message = say!(context.lang, "check-read-as", control = control);
                let help = say!(context.lang, "check-read-as-other", controls = Language::names(knowledge).join(", "));
                let read_as = Diagnostic::error("read-as", message, None).help(help);
                problems.insert(0, Diagnostic { severity: Severity::Note, ..read_as });
                before += 1;
            }
            if let Some(machine) = &assumed {
                let names = (machine.id(), control);
                let message = say!(context.lang, "check-machine-assumed", machine = names.0, control = names.1);
                let help = Some(context.word("check-name-machine").into());
                let assumed = Diagnostic::error("machine-assumed", message, None);
                problems.insert(0, Diagnostic { severity: Severity::Note, help, ..assumed });
                before += 1;
            }
            problems.extend(proof::part_diagnostics(&serious, context));
            problems.extend(proof::part_diagnostics(&undone, context));
            let texts = Texts::default().with(&shown, shown.clone(), Cow::Owned(text.clone()));
            let mut made = None;
            if let (Some(planned), Some(proof)) = (&planned, &proof) {
                problems.extend(proof::diagnostics(proof, &text, &file, context));
                made = Some(proof::table(planned, proof, context.lang));
            }
            if planned.is_some() && !is_run {
                let message = context.word("check-not-compared");
                let severity = Severity::Note;
                let help = Some(context.word("check-mend-first").into());
                problems.push(Diagnostic { severity, help, ..Diagnostic::error("not-compared", message, None) });
            }
            let hidden = faults.iter().map(|fault| proof::shown(fault.severity));
            let behind = problems.iter().skip(before + reported.len());
            let own = problems.iter().take(before).chain(behind).map(|problem| problem.severity);
            let all: Vec<Severity> = hidden.chain(own).collect();
            let counts = [Severity::Error, Severity::Warning, Severity::Note]
                .map(|severity| all.iter().filter(|one| **one == severity).count());
            let reported = (counts, problems::blocks(problems, more, &texts, format, context));
            let page = page(&shown, reported, made, &steps, clock.known_times(), context.lang);
            context.emit_document(&problems::untitled(page, format), format)?;
        }
    }
    let unproven = !serious.is_empty() || proof.as_ref().is_some_and(technolog::program::proof::Proof::has_errors);
    Ok(if unproven || faults.iter().any(Fault::is_grave) { Outcome::Findings } else { Outcome::Done })
}

/// The most findings of one kind that are told one by one.
pub(super) const MOST_OF_A_KIND: usize = 3;
/// The most lines that are named of a group.
const MOST_LINES: usize = 8;

/// The findings to tell, each with the lines of others that it stands for: of a kind that is found all over the program
/// the first is told. All of them are told where all are asked for.
fn groups<'a>(faults: &'a [Fault], context: &Context) -> Vec<(&'a Fault, Vec<u32>)> {
    // Findings of two words are of two kinds.
    let kind = |fault: &Fault| {
        let word = if let Some(Subject::Function(word)) = &fault.subject { Some(word.clone()) } else { None };
        (fault.code, word)
    };
    let mut count: BTreeMap<_, usize> = BTreeMap::new();
    faults.iter().for_each(|fault| *count.entry(kind(fault)).or_default() += 1);
    let grouped =
        |fault: &Fault| context.amount != Amount::All && count.get(&kind(fault)).is_some_and(|of| *of > MOST_OF_A_KIND);
    let mut groups: Vec<(&Fault, Vec<u32>)> = Vec::new();
    let mut first = BTreeMap::new();
    for fault in faults {
        match first.get(&kind(fault)).and_then(|index: &usize| groups.get_mut(*index)) {
            Some((_, others)) => others.push(fault.span.line),
            None => {
                if grouped(fault) {
                    first.insert(kind(fault), groups.len());
                }
                groups.push((fault, Vec::new()));
            }
        }
    }
    // A cutter that goes on at no feed is told before anything else.
    groups.sort_by_key(|(fault, _)| fault.code != "feed-zero");
    groups
}

/// A finding with the lines of those that it stands for.
fn of_group(fault: &Fault, others: &[u32], file: &Arc<str>, context: &Context) -> Diagnostic {
    said(fault, more_of_a_kind(others, context.lang), file, context)
}

/// How many more there are of a kind, and in which lines; none if there are none.
pub(super) fn more_of_a_kind(others: &[u32], lang: Lang) -> Option<String> {
    let mut lines: Vec<u32> = others.to_vec();
    lines.dedup();
    let dots = if lines.len() > MOST_LINES { ", …" } else { "" };
    let named: Vec<String> = lines.iter().take(MOST_LINES).map(ToString::to_string).collect();
    let lines = format!("{}{dots}", named.join(", "));
    let more = || say!(lang, "check-more-of-a-kind", count = others.len(), lines = lines);
    (!others.is_empty()).then(more)
}

/// Makes sure that a program that a mill's control finds wrong is none of a lathe.
fn refuse_lathe(text: &str, control: &str, context: &Context) -> Result<(), CliError> {
    let controls = recognised(text);
    if controls.is_empty() {
        return Ok(());
    }
    let named: Vec<String> = controls.iter().map(|control| format!("--control {}", control.name())).collect();
    let message = say!(context.lang, "check-of-lathe", control = control);
    let help = say!(context.lang, "check-name-lathe", controls = named.join(", "));
    Err(Diagnostic::error("program-of-lathe", message, None).help(help).into())
}

/// Faults with their words.
pub(super) fn findings<'a>(faults: &'a [Fault], context: &Context) -> Vec<FaultMessage<'a>> {
    let with_words = |fault: &'a Fault| {
        let (message, help) = (context.lang.say(&fault.note), context.lang.remedy(&fault.note));
        FaultMessage { message, help, fault }
    };
    faults.iter().map(with_words).collect()
}

/// The answer for people: mistakes with their lines, the result for the part, the trace, the times.
fn page(
    program: &str,
    (counts, problems): ([usize; 3], Vec<Block>),
    made: Option<Table>,
    steps: &[MotionStep],
    times: KnownTimes,
    lang: Lang,
) -> Document {
    let mut page = Document::new(lang.tag(), say!(lang, "check-title", program = program));
    page.blocks.extend(problems);
    if let Some(made) = made {
        page.heading(2, lang.word("check-made"));
        page.push(made);
    }
    if !steps.is_empty() {
        page.heading(2, lang.word("check-trace"));
        page.push(Block::Code(steps.iter().map(|step| motion(step, lang) + "\n").collect()));
        page.heading(2, lang.word("check-times"));
        let minutes = |minutes: Minutes| Figure::fixed(minutes.0, 2);
        page.paragraph(match times {
            KnownTimes::OfMachine(times) => say!(
                lang,
                "check-times-of",
                total = minutes(times.total_min),
                feed = minutes(times.feed_min),
                rapid = minutes(times.rapid_min),
                dwell = minutes(times.dwell_min),
                change = minutes(times.tool_change_min)
            ),
            KnownTimes::Alone { feed_min, dwell_min } => {
                say!(lang, "check-times-alone", feed = minutes(feed_min), dwell = minutes(dwell_min))
            }
        });
    }
    page.paragraph(total(counts, lang));
    page
}

/// A line of the trace in the language of the page.
fn motion(step: &MotionStep, lang: Lang) -> String {
    figures_of(&trace::line_in(step, &|word| lang.find(&format!("trace-{word}")).unwrap_or(word)), lang)
}

/// The line of a trace with its numbers, `Ø-1.827`, as written in a language.
pub(super) fn figures_of(line: &str, lang: Lang) -> String {
    let word = |word: &str| {
        let begin = word.find(|sign: char| sign.is_ascii_digit() || sign == '-').unwrap_or(word.len());
        let (letters, rest) = word.split_at(begin);
        let of_number = |sign: char| sign.is_ascii_digit() || "-.".contains(sign);
        let (number, unit) = rest.split_at(rest.find(|sign| !of_number(sign)).unwrap_or(rest.len()));
        match number.parse::<f64>() {
            Ok(_) => format!("{letters}{}{unit}", lang.figure(&Figure::number(number.to_owned()))),
            Err(_) => word.to_owned(),
        }
    };
    line.split(' ').map(word).collect::<Vec<_>>().join(" ")
}

/// The number of findings by severity.
pub(super) fn total(counts: [usize; 3], lang: Lang) -> String {
    let codes = ["check-errors", "check-warnings", "check-notes"];
    let some = codes.into_iter().zip(counts).filter(|(_, count)| *count > 0);
    let counted: Vec<String> = some.map(|(code, count)| lang.say(&Note::new(code).with("count", count))).collect();
    if counted.is_empty() { say!(lang, "cli-findings-counted", count = 0) } else { counted.join(", ") }
}

/// A mistake of a program with its place.
pub fn diagnostic(fault: &Fault, file: &Arc<str>, context: &Context) -> Diagnostic {
    said(fault, None, file, context)
}

fn said(fault: &Fault, more: Option<String>, file: &Arc<str>, context: &Context) -> Diagnostic {
    let span = fault.span;
    let place = Place { file: file.clone(), line: span.line, column: span.column, width: span.width };
    let severity = proof::shown(fault.severity);
    let sentence = context.lang.say(&fault.note);
    let message = match fault.path() {
        Some(path) => format!("{path}: {sentence}"),
        None => sentence,
    };
    let message = more.map_or_else(|| message.clone(), |more| format!("{message} ({more})"));
    let help = context.lang.remedy(&fault.note);
    let help = help
        .map(|what| say!(context.lang, "cli-by-rule", what = what, section = fault.rule.trim_end_matches('*')).into());
    Diagnostic { severity, code: fault.code, message: message.into(), place: Some(place), help }
}
