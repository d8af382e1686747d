//! `technolog report`: the laboratory report of a part, in sixteen parts, out of its plan and its program.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use technolog::error::KnowledgeError;
use technolog::note::Finding;
use technolog::plan::CuttingMethod;
use technolog::report::encoding::encoding_sheet;
use technolog::report::laboratory::{self, Sources, TitleBlock, read_title};

use super::diagnostics::Texts;
use super::program::Made;
use super::{CliError, Context, Format, Outcome, control, knowledge, plan};

// The report of a laboratory work in sixteen parts: plan, drawings, settings and program in one file
#[derive(Debug, clap::Args)]
pub struct Args {
    #[arg(value_name = "PART.yaml")]
    part: PathBuf,
    #[arg(long, value_name = "FILE")]
    title: Option<PathBuf>,
    #[arg(long, value_parser = control::Names { lathes: false })]
    control: Option<String>,
}

/// The formats of a report.
pub const FORMATS: &[Format] = &[Format::Html, Format::Markdown, Format::Text, Format::Docx, Format::Xlsx];

/// Writes the report of a part.
///
/// # Errors
/// The part or the title block cannot be used; all their mistakes are reported at once.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let format = context.format("report", FORMATS)?;
    let knowledge = knowledge::load(context)?;
    let at_fault = |error: KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let title = args.title.as_deref().map(|path| title_block(path, context)).transpose()?.unwrap_or_default();
    let plan = plan::make(&args.part, CuttingMethod::default(), knowledge, context)?;
    let machine = control::machine(&plan.part.machine, knowledge, context)?;
    let control = control::chosen(args.control.as_deref(), &machine, knowledge, context)?;
    let made = Made::of(plan, control, (None, true), knowledge).map_err(at_fault)?;
    let (plan, job) = (&made.planned.plan, &made.planned.job);
    let sheet = encoding_sheet(&made.written, job, plan, control, knowledge, context.lang).map_err(at_fault)?;
    let said = |finding: Finding| {
        let told = context.lang.say(&finding.note);
        finding.hole.iter().fold(told, |told, hole| format!("{hole}: {told}"))
    };
    let warning = made.gravest().map(said);
    let left: Vec<String> = made.left().iter().cloned().map(said).collect();
    let warning = warning.as_deref();
    let sources = Sources {
        plan,
        job,
        setting: &made.setting,
        sheet: &sheet,
        steps: &made.steps,
        warning,
        left: &left,
        knowledge,
    };
    let page = laboratory::page(&sources, &title, context.lang).map_err(at_fault)?;
    context.emit_document(&page, format)?;
    Ok(if plan.has_errors() || warning.is_some() || !left.is_empty() { Outcome::Findings } else { Outcome::Done })
}

fn title_block(path: &Path, context: &Context) -> Result<TitleBlock, CliError> {
    let shown = path.display().to_string();
    let text = context.text(path)?;
    read_title(&shown, &text).map_err(|problems| CliError::Unusable {
        problems,
        texts: Texts::default().with(&shown.clone(), shown, Cow::Owned(text)),
    })
}
