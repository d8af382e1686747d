//! `technolog audit`: anybody's plan held against the knowledge.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use technolog::audit::{self, Unreadable};
use technolog::knowledge::Diagnostic;
use technolog::knowledge::yaml::text_of;
use technolog::report;

use super::diagnostics::Texts;
use super::{CliError, Context, Format, Outcome, knowledge, words};

/// Hold somebody's plan against the knowledge: every figure, every choice, the program
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The plan file (docs/audit.md), or a plan of `technolog plan --format json`
    #[arg(value_name = "PLAN.yaml")]
    plan: PathBuf,
}

/// Audits a plan.
///
/// # Errors
/// The plan file cannot be used; every mistake in it is told at once.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let format = context.format("audit", &[Format::Text, Format::Json, Format::Yaml, Format::Markdown])?;
    let knowledge = knowledge::load(context)?;
    let shown = args.plan.display().to_string();
    let bytes = std::fs::read(&args.plan).map_err(|error| {
        let message = words::cannot_read(context.lang, &shown, error);
        CliError::from(Diagnostic::error("unreadable", message, None).help(words::check_path(context.lang)))
    })?;
    let text = text_of(&shown, bytes)?;
    let folder = args.plan.parent().unwrap_or(Path::new("")).to_owned();
    let files = |name: &str| {
        let bytes = std::fs::read(folder.join(name)).map_err(|error| error.to_string())?;
        String::from_utf8(bytes).map_err(|error| error.to_string())
    };
    let stated = audit::read_plan(&shown, &text, &knowledge, &files).map_err(|unreadable| {
        let Unreadable { problems, texts } = unreadable;
        let mut known = Texts::default().with(&shown, shown.clone(), Cow::Owned(text.clone()));
        for (name, text) in texts {
            let path = folder.join(&name).display().to_string();
            known = known.with(&name, path, Cow::Owned(text));
        }
        CliError::Unusable { problems, texts: known }
    })?;
    let found = audit::audit(&stated, &knowledge).map_err(|error| CliError::of_knowledge(&error, context.lang))?;
    match format {
        Format::Json => context.emit_json(&found)?,
        Format::Yaml => context.emit_yaml(&found)?,
        Format::Markdown => context.emit(&report::audit::markdown(&found, context.lang))?,
        _ => context.emit(&report::audit::page(&found, context.lang))?,
    }
    Ok(if found.has_errors() { Outcome::Findings } else { Outcome::Done })
}
