//! `technolog audit`: checks a plan of any author, or a folder of plans, against the knowledge base.

pub mod file;
mod folder;
mod program;

use std::path::{Path, PathBuf};

use technolog::audit::{Audit, Auditor};
use technolog::knowledge::Diagnostic;
use technolog::report;

use super::input::FileRoots;
use super::{CliError, Context, Format, Outcome, control, knowledge};

// Checks a plan, or a folder of plans, against the knowledge: every figure, every choice, the program
#[derive(Debug, clap::Args)]
pub struct Args {
    #[arg(value_name = "PLAN.yaml")]
    plan: PathBuf,
    #[arg(long, value_name = "PLAN.yaml")]
    against: Option<PathBuf>,
    #[arg(long, value_name = "PART.yaml", conflicts_with = "against")]
    part: Option<PathBuf>,
    #[arg(long, value_parser = control::Names { lathes: false }, conflicts_with = "against")]
    control: Option<String>,
    #[arg(long, value_name = "FILE.yaml", conflicts_with = "against")]
    setting: Option<PathBuf>,
    #[arg(long, value_name = "TOOLS.csv", conflicts_with = "against")]
    tools: Option<PathBuf>,
    #[arg(long, value_name = "FILE", conflicts_with = "against")]
    marks: Option<PathBuf>,
    #[arg(long, value_name = "DIR", conflicts_with = "against")]
    sheets: Option<PathBuf>,
    #[arg(long)]
    allow_outside: bool,
}

/// The formats of an audit and of a comparison.
pub const FORMATS: &[Format] = &[Format::Text, Format::Json, Format::Yaml, Format::Markdown, Format::Html];

/// The formats of the answer on a folder.
pub const FOLDER_FORMATS: &[Format] = folder::FORMATS;

/// Audits a plan or a folder of them.
///
/// # Errors
/// The plan file cannot be used; all its mistakes are reported at once. For a folder: it has no plan, or some cannot
/// be used, which its table reports.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let formats = if args.plan.is_dir() { folder::FORMATS } else { FORMATS };
    let format = context.format("audit", formats)?;
    let knowledge = knowledge::load(context)?;
    let auditor = Auditor::new(knowledge).map_err(|error| CliError::of_knowledge(&error, context.lang))?;
    let scheme = args.marks.as_deref().map(|path| file::scheme(path, context)).transpose()?;
    if args.plan.is_dir() {
        if args.against.is_some() {
            let problem = Diagnostic::error("folder-against", context.word("audit-folder-against"), None);
            return Err(problem.help(context.word("audit-name-a-plan")).into());
        }
        if args.part.is_some() {
            let problem = Diagnostic::error("folder-part", context.word("audit-folder-part"), None);
            return Err(problem.help(context.word("audit-folder-part-help")).into());
        }
        let places = FileRoots { folder: Some(&args.plan), anywhere: args.allow_outside };
        let asked =
            folder::Asked { folder: &args.plan, format, scheme: scheme.as_ref(), sheets: args.sheets.as_deref() };
        return folder::run(&asked, &auditor, places, context);
    }
    if args.sheets.is_some() {
        let problem = Diagnostic::error("sheets-of-one", context.word("audit-sheets-of-one"), None);
        return Err(problem.help(context.word("audit-sheets-of-one-help")).into());
    }
    let places = FileRoots { folder: None, anywhere: args.allow_outside };
    let part = args.part.as_deref().map(|path| file::part(path, &auditor, context)).transpose()?;
    let stated = match program::is_program(&args.plan, args.control.is_some()) {
        true => {
            let of = program::Asked {
                path: &args.plan,
                control: args.control.as_deref(),
                setting: args.setting.as_deref(),
                tools: args.tools.as_deref(),
                part: part.as_ref(),
            };
            program::read(&of, &auditor, places, context)?
        }
        false => file::read_work(&args.plan, part.as_ref(), &auditor, places, context)?,
    };
    if let Some(other) = &args.against {
        let other = file::read(other, None, &auditor, places, context)?;
        let compared = auditor.compare(&stated, &other);
        let compared = compared.map_err(|error| CliError::of_knowledge(&error, context.lang))?;
        match format {
            Format::Json => context.emit_json(&compared)?,
            Format::Yaml => context.emit_yaml(&compared)?,
            _ => context.emit_document(&report::audit::against::page(&compared, context.lang), format)?,
        }
        return Ok(Outcome::Done);
    }
    let mut found = auditor.audit(&stated).map_err(|error| file::at_fault(&stated, &error, context))?;
    found.marks = scheme.map(|scheme| scheme.mark(&found));
    give_out(&found, format, context)?;
    Ok(if found.has_errors() { Outcome::Findings } else { Outcome::Done })
}

/// The audit of one plan, without marks.
///
/// # Errors
/// The file cannot be used; all its mistakes are reported at once.
pub fn of_file(
    plan: &Path,
    auditor: &Auditor<'_>,
    places: FileRoots<'_>,
    context: &Context,
) -> Result<Audit, CliError> {
    let stated = file::read_work(plan, None, auditor, places, context)?;
    auditor.audit(&stated).map_err(|error| file::at_fault(&stated, &error, context))
}

fn give_out(found: &Audit, format: Format, context: &Context) -> Result<(), CliError> {
    match format {
        Format::Json => context.emit_json(found),
        Format::Yaml => context.emit_yaml(found),
        _ => context.emit_document(&report::audit::page(found, context.lang), format),
    }
}
