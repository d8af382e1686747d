//! `technolog check`: a program read and run, its mistakes, its trace and its time; with a part the proof that it makes
//! the part (`proof.rs`).

use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::Serialize;
use technolog::knowledge::yaml::text_of;
use technolog::knowledge::{Diagnostic, Knowledge, Place};
use technolog::machine::Machine;
use technolog::motion::Step;
use technolog::motion::time::{Clock, Times};
use technolog::motion::trace;
use technolog::program::proof::Held;
use technolog::program::{Fault, Language, Setting};
use technolog::report;

use super::diagnostics::{Texts, render};
use super::proof;
use super::{CliError, Context, Format, Outcome, control, knowledge, words};

// Read and run an NC program: its mistakes, the trace of its motions, its time
#[derive(Debug, clap::Args)]
pub struct Args {
    #[arg(value_name = "PROGRAM")]
    program: PathBuf,
    #[arg(long, value_parser = Language::NAMES)]
    control: Option<String>,
    #[arg(long, value_name = "ID")]
    machine: Option<String>,
    #[arg(long, value_name = "FILE.yaml")]
    setting: Option<PathBuf>,
    #[arg(long, value_name = "PART.yaml")]
    part: Option<PathBuf>,
}

/// The answer for programs.
#[derive(Serialize)]
struct Answer<'a> {
    program: &'a str,
    control: &'a str,
    machine: &'a str,
    /// What keeps any program from making the part.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    part: Vec<String>,
    findings: Vec<Finding<'a>>,
    trace: &'a [Step],
    time: Times,
    #[serde(skip_serializing_if = "Option::is_none")]
    proof: Option<proof::Answer<'a>>,
}

#[derive(Serialize)]
struct Finding<'a> {
    message: String,
    help: Option<String>,
    #[serde(flatten)]
    fault: &'a Fault,
}

/// Checks a program.
///
/// # Errors
/// The program, the setting or the machine cannot be used.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let format = context.format("check", &[Format::Text, Format::Json, Format::Svg])?;
    let knowledge = knowledge::load(context)?;
    let at_fault = |error: technolog::error::KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let shown = args.program.display().to_string();
    let text = read(&args.program, context)?;
    let mut held = args.part.as_deref().map(|part| proof::held(part, knowledge, context)).transpose()?;
    let of_part = held.as_ref().map(|held| held.plan.part.machine.clone());
    let id = args.machine.as_deref().or(of_part.as_deref()).unwrap_or("gf2171");
    if let Some(own) = of_part.as_deref().filter(|own| *own != id) {
        let message = words::other_machine(context.lang, id, own);
        return Err(Diagnostic::error("other-machine", message, None).help(words::leave_machine(context.lang)).into());
    }
    let machine = machine(id, knowledge, context)?;
    let control = control::meant(args.control.as_deref(), &machine, context)?;
    let language = Language::read(control, knowledge).map_err(at_fault)?;
    let mut setting = match &args.setting {
        None => Setting::default(),
        Some(path) => {
            let (shown, text) = (path.display().to_string(), read(path, context)?);
            language.setting(&shown, &text).map_err(|problems| CliError::Unusable {
                problems,
                texts: Texts::default().with(&shown, shown.clone(), Cow::Owned(text)),
            })?
        }
    };
    if let Some(held) = &mut held {
        held.set(&mut setting);
    }
    let mut sink = (Vec::<Step>::new(), Clock::new(&machine, setting.start));
    let faults = language.check(&text, &machine, &setting, &mut sink);
    let (steps, clock) = sink;
    let proof = held.as_ref().map(|held| held.prove(&steps, &setting));
    let serious = held.as_ref().map(Held::serious).unwrap_or_default();
    match format {
        Format::Json => {
            let findings = faults
                .iter()
                .map(|fault| Finding {
                    message: report::sentence(&fault.note, context.lang),
                    help: report::remedy(&fault.note, context.lang),
                    fault,
                })
                .collect();
            context.emit_json(&Answer {
                program: &shown,
                control,
                machine: id,
                part: serious.iter().map(|finding| report::sentence(&finding.note, context.lang)).collect(),
                findings,
                trace: &steps,
                time: clock.times(),
                proof: proof.as_ref().map(|proof| proof::answer(proof, context)),
            })?;
        }
        Format::Svg => {
            let frame = held.as_ref().map(proof::frame);
            context.emit(&report::backplot::backplot(&steps, frame.as_ref(), context.lang))?;
        }
        _ => {
            let file: Arc<str> = Arc::from(shown.as_str());
            let mut problems: Vec<Diagnostic> = faults.iter().map(|fault| diagnostic(fault, &file, context)).collect();
            problems.extend(proof::of_part(&serious, context));
            let mut made = String::new();
            if let (Some(held), Some(proof)) = (&held, &proof) {
                problems.extend(proof::diagnostics(proof, &text, &file, context));
                made = proof::table(held, proof, context);
            }
            context.emit(&page(&problems, &made, &steps, clock.times(), &shown, text, context))?;
        }
    }
    let unproven = !serious.is_empty() || proof.as_ref().is_some_and(technolog::program::proof::Proof::has_errors);
    Ok(if unproven || faults.iter().any(Fault::is_error) { Outcome::Findings } else { Outcome::Done })
}

fn machine<'k>(id: &str, knowledge: &'k Knowledge, context: &Context) -> Result<Machine<'k>, CliError> {
    let known: Vec<&str> = Machine::ids(knowledge).collect();
    if !known.contains(&id) {
        return Err(Diagnostic::error("unknown-machine", words::no_machine(context.lang, id), None)
            .help(words::known(context.lang, known.join(", ")))
            .into());
    }
    Machine::find(knowledge, id).map_err(|error| CliError::of_knowledge(&error, context.lang))
}

fn read(path: &Path, context: &Context) -> Result<String, CliError> {
    let shown = path.display().to_string();
    let bytes = std::fs::read(path).map_err(|error| {
        let message = words::cannot_read(context.lang, &shown, error);
        CliError::from(Diagnostic::error("unreadable", message, None).help(words::check_path(context.lang)))
    })?;
    Ok(text_of(&shown, bytes)?)
}

/// The answer for people: mistakes with their lines, what is made of the part, the trace, the times.
fn page(
    problems: &[Diagnostic],
    made: &str,
    steps: &[Step],
    times: Times,
    shown: &str,
    text: String,
    context: &Context,
) -> String {
    let texts = Texts::default().with(shown, shown.to_owned(), Cow::Owned(text));
    let mut page = render(problems, &texts, context.lang);
    if !problems.is_empty() {
        page.push('\n');
    }
    if !made.is_empty() {
        page.push_str(made);
        page.push('\n');
    }
    if !steps.is_empty() {
        page.push_str(context.word("cli-trace"));
        page.push('\n');
        for step in steps {
            page.push_str(&trace::line(step));
            page.push('\n');
        }
        page.push('\n');
        let t = [times.feed_min, times.rapid_min, times.dwell_min, times.tool_change_min, times.total_min];
        let [feed, rapid, dwell, change, total] = t.map(|time| time.0);
        page.push_str(&words::times(context.lang, total, feed, rapid, dwell, change));
        page.push('\n');
    }
    page.push_str(&words::findings(context.lang, problems.len()));
    page.push('\n');
    page
}

/// A mistake of a program with its place.
pub fn diagnostic(fault: &Fault, file: &Arc<str>, context: &Context) -> Diagnostic {
    let span = fault.span;
    let place = Place { file: file.clone(), line: span.line, column: span.column, width: span.width };
    let severity = proof::shown(fault.severity);
    let sentence = report::sentence(&fault.note, context.lang);
    let message = match fault.path() {
        Some(path) => format!("{path}: {sentence}"),
        None => sentence,
    };
    let help = report::remedy(&fault.note, context.lang).unwrap_or_default();
    let help = words::by_rule(context.lang, help, fault.rule);
    Diagnostic { severity, code: fault.code, message: message.into(), place: Some(place), help: Some(help.into()) }
}
