//! `technolog report`: the laboratory report of a part, in sixteen parts, out of its plan and its program; of a turned part,
//! out of its operation; of an audit.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use technolog::audit::Auditor;
use technolog::cases::{FileKind, other_kind};
use technolog::document::Document;
use technolog::error::KnowledgeError;
use technolog::job;
use technolog::knowledge::{Diagnostic, Knowledge};
use technolog::note::Finding;
use technolog::plan::CuttingMethod;
use technolog::report;
use technolog::report::encoding::encoding_sheet;
use technolog::report::laboratory::{self, Form, Sources, TitleBlock, framed, read_title};
use technolog::words::say;

use super::diagnostics::Texts;
use super::input::FileRoots;
use super::printers::{self, Targets};
use super::program::Made;
use super::{CliError, Context, Format, Outcome, audit, control, knowledge, plan, turn, turn_operation};

// The report of a laboratory work: plan, drawings, settings and program in one file
#[derive(Debug, clap::Args)]
pub struct Args {
    #[arg(value_name = "PART.yaml")]
    part: PathBuf,
    #[arg(long, value_name = "FILE")]
    title: Option<PathBuf>,
    #[arg(long, value_name = "FORM", value_parser = PossibleValuesParser::new(Form::NAMES.map(|(name, _)| name)))]
    only: Option<String>,
    #[arg(long, value_parser = control::Names { lathes: true })]
    control: Option<String>,
}

/// The formats of a report.
pub const FORMATS: &[Format] = &printers::FORMATS;

/// Writes the report of a part with holes, of a turned part, or of the audit of a plan, whichever the file is.
///
/// # Errors
/// The file or the title block cannot be used; all their mistakes are reported at once.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let targets = Targets::of("report", context)?;
    let knowledge = knowledge::load(context)?;
    let title = args.title.as_deref().map(|path| title_block(path, context)).transpose()?.unwrap_or_default();
    // A table is the plan of a student, or a list of tools.
    let kind = match audit::file::table_kind(&args.part) {
        Some(_) => Some(FileKind::Plan),
        None => other_kind(&args.part.display().to_string(), &context.text(&args.part)?, FileKind::Part)
            .map(|(kind, _)| kind),
    };
    let asked = Asked { args, title: &title, knowledge, context };
    let (page, outcome) = match kind {
        Some(FileKind::Turned) => turned(asked)?,
        Some(FileKind::Plan) => of_plan(asked)?,
        _ => of_part(asked)?,
    };
    targets.print(&page, context)?;
    Ok(outcome)
}

/// What a report is asked of.
#[derive(Clone, Copy)]
struct Asked<'a> {
    args: &'a Args,
    title: &'a TitleBlock,
    knowledge: &'a Knowledge,
    context: &'a Context,
}

/// The report of a turned part.
fn turned(asked: Asked<'_>) -> Result<(Document, Outcome), CliError> {
    let Asked { args, title, knowledge, context } = asked;
    is_whole(args, title, context)?;
    let control = match args.control.as_deref() {
        None => turn_operation::Control::Linuxcnc,
        Some(name) => turn_operation::Control::named(name).ok_or_else(|| {
            let known = turn_operation::Control::names().join(", ");
            let message = say!(context.lang, "cli-report-lathe-control", control = name);
            let help = say!(context.lang, "cli-report-lathe-controls", known = known);
            Diagnostic::error("unknown-control", message, None).help(help)
        })?,
    };
    let read = turn::read(&args.part, knowledge, context)?;
    let (page, outcome) = turn_operation::report(&read, control, title.times(), knowledge, context)?;
    Ok((framed(page, title, true, context.lang), outcome))
}

/// The report of an audit: what is wrong with somebody's plan.
fn of_plan(asked: Asked<'_>) -> Result<(Document, Outcome), CliError> {
    let Asked { args, title, knowledge, context } = asked;
    is_whole(args, title, context)?;
    if args.control.is_some() {
        let message = context.word("cli-report-audit-control");
        return Err(Diagnostic::error("no-control", message, None).into());
    }
    let auditor = Auditor::new(knowledge).map_err(|error| CliError::of_knowledge(&error, context.lang))?;
    let places = FileRoots { folder: None, anywhere: false };
    let found = audit::of_file(&args.part, &auditor, places, context)?;
    let outcome = if found.has_errors() { Outcome::Findings } else { Outcome::Done };
    Ok((framed(report::audit::page(&found, context.lang), title, false, context.lang), outcome))
}

/// Only the report of a part with holes has numbered parts and forms that stand by themselves.
fn is_whole(args: &Args, title: &TitleBlock, context: &Context) -> Result<(), CliError> {
    let (message, help) = match (&args.only, &title.parts) {
        (Some(_), _) => ("cli-report-no-forms", "cli-report-leave-only"),
        (None, Some(_)) => ("cli-report-no-parts", "cli-report-leave-parts"),
        (None, None) => return Ok(()),
    };
    Err(Diagnostic::error("no-parts", context.word(message), None).help(context.word(help)).into())
}

/// The report of a part with holes, in sixteen parts.
fn of_part(asked: Asked<'_>) -> Result<(Document, Outcome), CliError> {
    let Asked { args, title, knowledge, context } = asked;
    let at_fault = |error: KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let plan = plan::make(&args.part, CuttingMethod::default(), knowledge, context)?;
    let machine = control::machine(&plan.part.machine, knowledge, context)?;
    let control = control::chosen(args.control.as_deref(), Some(&machine), knowledge, context)?;
    let made = Made::of(plan, control, (None, true), knowledge).map_err(at_fault)?;
    let (plan, made_job) = (&made.planned.plan, &made.planned.job);
    let sheet = encoding_sheet(&made.written, made_job, plan, control, knowledge, context.lang).map_err(at_fault)?;
    let said = |finding: Finding| {
        let told = context.lang.say(&finding.note);
        finding.hole.iter().fold(told, |told, hole| format!("{hole}: {told}"))
    };
    let wrong = made.wrong();
    let warning = wrong.first().cloned().map(said);
    let left: Vec<String> = made.left().iter().cloned().map(said).collect();
    let warning = warning.as_deref();
    let mut sources = Sources {
        plan,
        job: made_job,
        setting: &made.setting,
        sheet: &sheet,
        steps: &made.steps,
        wrong: &wrong,
        warning,
        left: &left,
        norm: None,
        control,
        knowledge,
    };
    let clean = sources.is_clean();
    let norm = clean.then(|| job::norm(plan, made_job, title.times(), knowledge)).transpose().map_err(at_fault)?;
    sources.norm = norm.as_ref();
    let form = args.only.as_deref().and_then(Form::named);
    let page = match form {
        Some(form) => form.page(&sources, title, context.lang),
        None => laboratory::page(&sources, title, context.lang),
    };
    Ok((page.map_err(at_fault)?, if clean { Outcome::Done } else { Outcome::Findings }))
}

fn title_block(path: &Path, context: &Context) -> Result<TitleBlock, CliError> {
    let shown = path.display().to_string();
    let text = context.text(path)?;
    read_title(&shown, &text).map_err(|problems| CliError::Unusable {
        problems,
        texts: Texts::default().with(&shown.clone(), shown, Cow::Owned(text)),
    })
}
