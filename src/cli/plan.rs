//! `technolog plan` and `technolog explain`: the plan of a part, and the reasons behind one hole.

use std::borrow::Cow;
use std::mem::ManuallyDrop;
use std::path::{Path, PathBuf};

use technolog::cases::FileKind;
use technolog::error::KnowledgeError;
use technolog::job::Unfinished;
use technolog::knowledge::alike::latin;
use technolog::knowledge::diagnostic::nearest;
use technolog::knowledge::{Diagnostic, Knowledge};
use technolog::note::{Finding, Severity};
use technolog::part::{Part, read_part};
use technolog::plan::{CuttingMethod, Plan};
use technolog::words::say;
use technolog::{audit, planner, report};

use super::diagnostics::Texts;
use super::{CliError, Context, Format, Outcome, kind, knowledge, words};

// The whole plan of a part: route, tools, conditions, clamping, corrections, times
#[derive(Debug, clap::Args)]
pub struct Args {
    #[arg(value_name = "PART.yaml")]
    part: PathBuf,
    #[command(flatten)]
    method: Method,
    #[arg(long, value_parser = ["best", "tables"], default_value = "best")]
    prefer: String,
}

// How cutting conditions are found.
#[derive(Debug, clap::Args)]
struct Method {
    #[arg(long, value_parser = ["formula", "card"], default_value = "formula")]
    cutting: String,
}

impl Method {
    fn method(&self) -> CuttingMethod {
        if self.cutting == "card" { CuttingMethod::Card } else { CuttingMethod::Formula }
    }
}

/// The formats of a plan.
pub const FORMATS: &[Format] = &[
    Format::Text,
    Format::Markdown,
    Format::Html,
    Format::Json,
    Format::Yaml,
    Format::Hand,
    Format::Csv,
    Format::Xlsx,
];

/// The formats of an explanation.
pub const EXPLAIN_FORMATS: &[Format] = &[Format::Text, Format::Markdown, Format::Html, Format::Json];

/// Plans a part.
///
/// # Errors
/// The part file cannot be used; all its mistakes are reported at once.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let format = context.format("plan", FORMATS)?;
    let knowledge = knowledge::load(context)?;
    // As the knowledge, it is not freed at the end of the process.
    let planned = match args.prefer.as_str() {
        "tables" => planner::plan_by_tables,
        _ => planner::plan,
    };
    let mut plan = plan_file(&args.part, knowledge, context, |part| planned(part, args.method.method(), knowledge))?;
    tell_unfinished(&mut plan);
    let plan = ManuallyDrop::new(plan);
    match format {
        Format::Json => context.emit_json(&*plan)?,
        Format::Yaml => context.emit_yaml(&*plan)?,
        Format::Hand => context.emit_cleaned(&audit::by_hand(&plan, &context.beside_answer(&args.part)))?,
        Format::Csv => {
            let tables = audit::by_tables(&plan, &context.beside_answer(&args.part), context.lang);
            context.emit_separated(&tables)?;
        }
        Format::Xlsx => {
            let tables = audit::by_tables(&plan, &context.beside_answer(&args.part), context.lang);
            context.emit_workbook(&tables)?;
        }
        _ => context
            .emit_document(&report::sheet::page(&plan, knowledge, context.amount.doubts(), context.lang), format)?,
    }
    Ok(if plan.has_errors() { Outcome::Findings } else { Outcome::Done })
}

// Why one hole is made in this way, and not in another
#[derive(Debug, clap::Args)]
pub struct ExplainArgs {
    #[arg(value_name = "PART.yaml")]
    part: PathBuf,
    #[arg(long, value_name = "NAME")]
    hole: Option<String>,
    #[command(flatten)]
    method: Method,
}

/// Shows the reasons of one hole.
///
/// # Errors
/// The part file cannot be used, or it has no such hole.
pub fn explain(args: &ExplainArgs, context: &Context) -> Result<Outcome, CliError> {
    let format = context.format("explain", EXPLAIN_FORMATS)?;
    let knowledge = knowledge::load(context)?;
    let mut plan = make(&args.part, args.method.method(), knowledge, context)?;
    tell_unfinished(&mut plan);
    let names: Vec<&str> = plan.holes.iter().map(|hole| hole.name.as_str()).collect();
    let Some(wanted) = args.hole.as_deref() else {
        // Which groups there are says the part, not the command line.
        let message = say!(context.lang, "cli-hole-missing");
        let help = say!(context.lang, "cli-known", names = names.join(", "));
        return Err(Diagnostic::error("hole-missing", message, None).help(help).into());
    };
    let Some(hole) = plan.holes.iter().find(|hole| hole.name == wanted) else {
        let message = words::no_hole(context.lang, args.part.display(), wanted);
        let alike = names.iter().find(|name| latin(name) == latin(wanted));
        let help = match (alike, nearest(wanted, names.iter().copied())) {
            (Some(alike), _) => say!(context.lang, "cli-other-alphabet", name = *alike),
            (None, Some(near)) => words::did_you_mean(context.lang, near),
            (None, None) => words::known(context.lang, names.join(", ")),
        };
        return Err(Diagnostic::error("unknown-hole", message, None).help(help).into());
    };
    match format {
        Format::Json => context.emit_json(hole)?,
        _ => {
            let page = report::explain(&plan, hole, knowledge, context.lang);
            let page = page.map_err(|error| CliError::of_knowledge(&error, context.lang))?;
            context.emit_document(&page, format)?;
        }
    }
    Ok(if plan.has_errors_of(&hole.name) { Outcome::Findings } else { Outcome::Done })
}

/// Adds to the findings of a plan what a program of its machine leaves undone: who reads the plan must not take the part for finished
/// either, and both commands end alike.
pub fn tell_unfinished(plan: &mut Plan) {
    let left = Unfinished::of(plan);
    plan.findings.extend(left.iter().filter_map(|one| one.finding(Severity::Wrong)));
    Finding::in_order(&mut plan.findings);
}

/// Reads and plans a part.
///
/// # Errors
/// The part file cannot be used; all its mistakes are reported at once.
pub fn make(path: &Path, method: CuttingMethod, knowledge: &Knowledge, context: &Context) -> Result<Plan, CliError> {
    plan_file(path, knowledge, context, |part| planner::plan(part, method, knowledge))
}

fn plan_file(
    path: &Path,
    knowledge: &Knowledge,
    context: &Context,
    planned: impl FnOnce(&Part) -> Result<Plan, KnowledgeError>,
) -> Result<Plan, CliError> {
    let shown = path.display().to_string();
    let text = context.text(path)?;
    let part = read_part(&shown, &text, knowledge).map_err(|problems| CliError::Unusable {
        problems: kind::or_other(&shown, &text, FileKind::Part, problems, context),
        texts: Texts::default().with(&shown, shown.clone(), Cow::Owned(text)),
    })?;
    planned(&part).map_err(|error| CliError::of_knowledge(&error, context.lang))
}
