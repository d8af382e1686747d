//! `technolog test`: runs files of cases and compares the answers with their expectations.

mod answer;
mod files;
mod junit;
mod page;

use std::borrow::Cow;
use std::path::PathBuf;

use technolog::cases::write::fill;
use technolog::cases::{Asker, Case, CaseFile, Failure};
use technolog::error::KnowledgeError;
use technolog::knowledge::Diagnostic;
use technolog::parallel;
use technolog::words::say;

use self::files::{SourceFile, around, collect};
use super::diagnostics::{Texts, render};
use super::problems::untitled;
use super::progress::Progress;
use super::{CliError, Context, Format, Outcome, knowledge, output, turn};

// Run cases: questions to tables, parts, programs, audits, with the expected answers (docs/cases.md)
#[derive(Debug, clap::Args)]
pub struct Args {
    #[arg(value_name = "FILE|DIR", required = true)]
    paths: Vec<PathBuf>,
    #[arg(long)]
    write: bool,
    #[arg(long)]
    allow_outside: bool,
}

/// A file that was run.
pub struct CaseFileRun {
    /// Its name, as the user knows it.
    file: String,
    cases: Vec<CaseRun>,
    /// Mistakes of the file itself, and of the files it names.
    mistakes: Vec<Diagnostic>,
    texts: Texts,
}

/// A case that was run.
pub struct CaseRun {
    case: Case,
    failures: Vec<Failure>,
    /// Whether its expectation was just written.
    written: bool,
}

impl CaseRun {
    fn passed(&self) -> bool {
        self.failures.is_empty()
    }
}

impl CaseFileRun {
    fn failed(&self) -> usize {
        self.cases.iter().filter(|case| !case.passed()).count()
    }

    fn passed(&self) -> usize {
        self.cases.len() - self.failed()
    }

    fn written(&self) -> usize {
        self.cases.iter().filter(|case| case.written).count()
    }
}

/// The formats of its answers.
pub const FORMATS: &[Format] = &[Format::Text, Format::Json, Format::Junit, Format::Markdown, Format::Html];

/// Runs every case of the files.
///
/// # Errors
/// A file of cases, or one that it names, cannot be used, which the answer has reported; or there are no cases at
/// all.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let found = collect(&args.paths, context)?;
    files::spare_inputs(&found, args.write, context)?;
    // The file of `--write -o FILE` is a copy of the cases, not the answer.
    let format = match context.format {
        None if args.write => Format::Text,
        Some(format) if args.write && FORMATS.contains(&format) => format,
        _ => context.format("test", FORMATS)?,
    };
    let knowledge = knowledge::load(context)?;
    let lacking = |error: KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let asker = Asker::new(knowledge);
    let anywhere = args.allow_outside;
    let mut read: Vec<CaseFile> = parallel::map(&found, |file| files::read(file, anywhere, knowledge, context), |_| ());
    let all: Vec<&Case> = read.iter().flat_map(|file| &file.cases).collect();
    let progress = Progress::new(all.len());
    let failures = parallel::map(&all, |case| case.run(&asker), |done| progress.show(done));
    progress.clear();
    let mut failures = failures.into_iter().collect::<Result<Vec<_>, _>>().map_err(lacking)?.into_iter();
    let mut runs = Vec::new();
    for (found, read) in found.iter().zip(&mut read) {
        let failures: Vec<Vec<Failure>> = failures.by_ref().take(read.cases.len()).collect();
        let written = if args.write { write(found, read, &failures, &asker, anywhere, context)? } else { Vec::new() };
        runs.push(run_of(found, read, failures, &written, context));
    }
    // With --write the file of -o is the copy of the cases.
    let screen = if args.write { None } else { context.output.as_deref() };
    let text = match format {
        Format::Json => answer::json(&runs, context)?,
        Format::Junit => junit::document(&runs, context),
        _ => context.written(&untitled(page::page(&runs, context.lang), format), format, context.output.as_deref()),
    };
    context.spare_inputs(context.output.as_deref())?;
    output::write(text.as_bytes(), screen, context.lang)?;
    let render = |run: &CaseFileRun| render(run.mistakes.clone(), &run.texts, context.amount, context.lang);
    let mistakes: String = runs.iter().map(render).collect();
    if !mistakes.is_empty() {
        output::complain(&mistakes);
        return Err(CliError::Shown);
    }
    Ok(if runs.iter().all(|run| run.failed() == 0) { Outcome::Done } else { Outcome::Findings })
}

/// Fills the open expectations of a file; returns the numbers of the filled cases.
fn write(
    found: &SourceFile,
    read: &mut CaseFile,
    failures: &[Vec<Failure>],
    asker: &Asker<'_>,
    anywhere: bool,
    context: &Context,
) -> Result<Vec<usize>, CliError> {
    let at_fault = |error: KnowledgeError| CliError::of_knowledge(&error, context.lang);
    let files = files::reader(found, anywhere, context);
    let codes = files::codes();
    let around = around(asker.knowledge, &codes, &files);
    let filled = fill(&found.text, read, failures, around, asker).map_err(at_fault)?;
    read.mistakes.extend(filled.problems.into_iter().map(technolog::turning::shaft::Mistake::Form));
    let copy = context.output.as_deref();
    context.spare_inputs(context.output.as_deref())?;
    match filled.text {
        Some(text) => {
            // Cases take time: the file may have been edited meanwhile, and that must not be lost.
            if copy.is_none() && std::fs::read(&found.path).ok().as_deref() != Some(found.text.as_bytes()) {
                let message = say!(context.lang, "test-file-changed", file = &found.shown);
                return Err(Diagnostic::error("file-changed", message, None)
                    .help(context.word("test-run-again"))
                    .into());
            }
            output::write(text.as_bytes(), copy.or(Some(&found.path)), context.lang)?;
            Ok(filled.cases)
        }
        None => {
            // A requested copy is written even if nothing had to be filled in.
            if copy.is_some() {
                output::write(found.text.as_bytes(), copy, context.lang)?;
            }
            Ok(Vec::new())
        }
    }
}

fn run_of(
    found: &SourceFile,
    read: &mut CaseFile,
    failures: Vec<Vec<Failure>>,
    written: &[usize],
    context: &Context,
) -> CaseFileRun {
    let mut texts = Texts::default().with(&found.shown, found.shown.clone(), Cow::Owned(found.text.clone()));
    for (name, text) in std::mem::take(&mut read.texts) {
        let shown = found.path.with_file_name(&name).display().to_string();
        texts = texts.with(&name, shown, Cow::Owned(text));
    }
    let mistakes = std::mem::take(&mut read.mistakes);
    let mut mistakes: Vec<Diagnostic> = mistakes.into_iter().map(|mistake| turn::problem(mistake, context)).collect();
    mistakes.extend(found.problem.clone());
    let cases = std::mem::take(&mut read.cases).into_iter().zip(failures);
    let cases = cases.map(|(case, failures)| {
        let written = written.contains(&case.number);
        let stands = |failure: &Failure| !written || !failure.is_open();
        CaseRun { failures: failures.into_iter().filter(stands).collect(), case, written }
    });
    CaseFileRun { file: found.shown.clone(), cases: cases.collect(), mistakes, texts }
}
