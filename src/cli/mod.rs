//! The command line: one file per command, each thin.
//!
//! A command is an `Args` struct and a function `run(&Args, &Context) -> Result<Outcome, CliError>`, one line in
//! [`Command`] and one in [`Command::run`], and its help in the message catalogue (`help.ftl`). Exit codes: 0 done, 1
//! done with something wrong found, 2 the input could not be used.
//!
//! Architecture invariant: nothing here makes decisions; a command calls the library and shows the answer. No other
//! part of the program uses arguments, environment, terminal or output files.

mod audit;
mod check;
mod check_lathe;
mod control;
mod diagnostics;
mod format;
mod help;
mod input;
mod kind;
mod knowledge;
mod lint;
mod lookup;
mod order;
mod output;
mod plan;
mod printers;
mod problems;
mod program;
mod progress;
mod proof;
mod record;
mod report;
mod sheet;
mod shown;
mod table;
mod test;
mod turn;
mod turn_operation;
mod usage;
mod words;

use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::OnceLock;

use clap::{ArgAction, FromArgMatches, Parser, Subcommand};
use serde::Serialize;
use technolog::document::{self, Document};
use technolog::error::KnowledgeError;
use technolog::knowledge::{Diagnostic, Knowledge};
use technolog::sheets;
use technolog::words::say;

use diagnostics::{Amount, Texts};
pub use format::Format;
use words::Lang;

// Knowledge base and rule engine for planning the machining of holes and shafts
#[derive(Debug, Parser)]
#[command(name = "technolog", version, disable_help_flag = true, disable_version_flag = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    global: Global,
}

// The options of every command.
#[derive(Debug, clap::Args)]
struct Global {
    #[arg(long, global = true, value_parser = language_named)]
    lang: Option<Lang>,
    #[arg(long, global = true, value_name = "DIR")]
    knowledge: Option<PathBuf>,
    #[arg(long, global = true, value_name = "DIR", action = ArgAction::Append)]
    with: Vec<PathBuf>,
    #[arg(long, global = true, value_enum, hide_possible_values = true)]
    format: Option<Format>,
    // More than one only for a report.
    #[arg(short, long, global = true, value_name = "FILE", action = ArgAction::Append)]
    output: Vec<PathBuf>,
    #[arg(long, global = true)]
    all_problems: bool,
    #[arg(short, long, global = true, action = ArgAction::Help)]
    help: Option<bool>,
    #[arg(short = 'V', long, action = ArgAction::Version)]
    version: Option<bool>,
}

/// A language by its tag; the error lists the existing ones.
fn language_named(tag: &str) -> Result<Lang, String> {
    tag.parse().map_err(|fault: technolog::note::Note| help::requested_language().say(&fault))
}

/// The commands.
#[derive(Debug, Subcommand)]
enum Command {
    Plan(plan::Args),
    Explain(plan::ExplainArgs),
    Order(order::Args),
    Turn(turn::Args),
    Program(program::Args),
    Report(report::Args),
    Audit(audit::Args),
    Table(table::Args),
    Lookup(lookup::Args),
    Check(check::Args),
    Lint(lint::Args),
    Test(test::Args),
}

impl Command {
    fn run(&self, context: &Context) -> Result<Outcome, CliError> {
        match self {
            Self::Plan(args) => plan::run(args, context),
            Self::Explain(args) => plan::explain(args, context),
            Self::Order(args) => order::run(args, context),
            Self::Turn(args) => turn::run(args, context),
            Self::Program(args) => program::run(args, context),
            Self::Report(args) => report::run(args, context),
            Self::Audit(args) => audit::run(args, context),
            Self::Table(args) => table::run(args, context),
            Self::Lookup(args) => lookup::run(args, context),
            Self::Check(args) => check::run(args, context),
            Self::Lint(args) => lint::run(args, context),
            Self::Test(args) => test::run(args, context),
        }
    }
}

/// The values of the global options.
#[derive(Debug)]
pub struct Context {
    /// The language of the answers.
    pub lang: Lang,
    /// The knowledge folder; none for the embedded knowledge.
    pub knowledge: Option<PathBuf>,
    /// Folders whose tables lie over those of the knowledge, the last one on top.
    pub layers: Vec<PathBuf>,
    /// The format of the answer, if given.
    pub format: Option<Format>,
    /// The file for the answer; none for the screen.
    pub output: Option<PathBuf>,
    /// Further files for the answer, of a command that writes several.
    pub more_outputs: Vec<PathBuf>,
    /// The input files of the answer.
    pub inputs: input::Inputs,
    /// How many problems are shown.
    pub amount: Amount,
    /// The tables of a command that plans: its pages name them for people. Commands about tables keep their ids.
    pub tables: OnceLock<&'static Knowledge>,
}

impl Context {
    /// A page with the tables of the command named for people.
    pub fn named<'d>(&self, document: &'d Document) -> Cow<'d, Document> {
        match self.tables.get() {
            Some(knowledge) => Cow::Owned(technolog::report::named(document.clone(), knowledge, self.lang)),
            None => Cow::Borrowed(document),
        }
    }

    /// The format of the answer: the given one, otherwise that of the extension of `-o`, otherwise the first of the
    /// command.
    ///
    /// # Errors
    /// The command does not have it, or name and extension contradict each other.
    pub fn format(&self, command: &str, known: &[Format]) -> Result<Format, CliError> {
        self.format_of(self.output.as_deref(), command, known)
    }

    /// The same for one file of several.
    ///
    /// # Errors
    /// As for [`Self::format`].
    pub fn format_of(&self, file: Option<&Path>, command: &str, known: &[Format]) -> Result<Format, CliError> {
        let meant = file.map(Format::of_ending).unwrap_or_default();
        let writes_programs = ["program", "turn --show=program", "turn --show=tool-table"].contains(&command);
        let foreign = file.and_then(|file| format::foreign_extension(file, writes_programs));
        if let Some(ending) = foreign.filter(|_| !meant.iter().any(|format| known.contains(format))) {
            let message = say!(self.lang, "cli-alien-ending", command = command, ending = ending.as_str());
            let help = say!(self.lang, "cli-known-endings", known = format::endings(known));
            return Err(Diagnostic::error("alien-ending", message, None).help(help).into());
        }
        let lacks = |format: Format| {
            let names: Vec<&str> = known.iter().map(|format| format.name()).collect();
            let message = words::no_format(self.lang, command, format.name());
            let help = words::formats(self.lang, names.join(", "));
            Err(Diagnostic::error("no-format", message, None).help(help).into())
        };
        match (self.format, meant.as_slice()) {
            (None, []) => Ok(known.first().copied().unwrap_or(Format::Text)),
            (None, [usual, ..]) => {
                meant.iter().find(|format| known.contains(format)).copied().map_or_else(|| lacks(*usual), Ok)
            }
            (Some(requested), _) if !known.contains(&requested) => lacks(requested),
            (Some(requested), [usual, ..]) if !meant.contains(&requested) => {
                let file = file.unwrap_or(Path::new("-")).display();
                let message = words::format_contradiction(self.lang, file, usual.name(), requested.name());
                let help = words::format_contradiction_help(self.lang);
                Err(Diagnostic::error("format-contradiction", message, None).help(help).into())
            }
            (Some(requested), _) => Ok(requested),
        }
    }

    /// Writes a page in the format of a document.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn emit_document(&self, document: &Document, format: Format) -> Result<(), CliError> {
        self.emit(&self.written(&self.named(document), format, self.output.as_deref()))
    }

    /// A page as text, Markdown or HTML for a file, or for the screen.
    pub fn written(&self, document: &Document, format: Format, file: Option<&Path>) -> String {
        let format = match format {
            Format::Markdown => document::Format::Markdown,
            Format::Html => document::Format::Html,
            _ => document::Format::Text,
        };
        let screen = output::Screen::of(file);
        document::write(document, format, screen.width, screen.colour, &self.page_words())
    }

    /// The words that the writers of pages need themselves.
    fn page_words(&self) -> document::Words<'_> {
        document::Words {
            left_out: self.word("document-left-out"),
            see_all: self.word("document-see-all"),
            help: self.word("cli-help"),
            figure: self.word("document-figure"),
        }
    }

    /// The width of a page in terminal columns; none for formats that have all the width they need.
    pub fn room(&self, format: Format) -> Option<usize> {
        (format == Format::Text).then(|| output::Screen::of(self.output.as_deref()).width)
    }

    /// Writes the answer to the screen, or to the file of `-o`.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn emit(&self, answer: &str) -> Result<(), CliError> {
        self.emit_files(&[(self.output.as_deref(), answer)])
    }

    /// Writes several files, or none of them; without a path to the screen.
    ///
    /// # Errors
    /// One of them cannot be written.
    pub fn emit_files(&self, files: &[(Option<&Path>, impl AsRef<[u8]>)]) -> Result<(), CliError> {
        files.iter().try_for_each(|(file, _)| self.spare_inputs(*file))?;
        output::write_all(files, self.lang)
    }

    /// Writes tables as a workbook.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn emit_workbook(&self, tables: &[sheets::Sheet]) -> Result<(), CliError> {
        let book = sheets::xlsx(tables).map_err(|error| output::unprintable(self.lang, error))?;
        self.emit_files(&[(self.output.as_deref(), &book)])
    }

    /// Writes tables as text for programs for tables, with the decimal sign of the language.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn emit_separated(&self, tables: &[sheets::Sheet]) -> Result<(), CliError> {
        let sign = if self.lang.find("decimal-comma").is_some() { ',' } else { '.' };
        self.emit(&sheets::csv(tables, sign).map_err(|error| output::unprintable(self.lang, error))?)
    }

    /// Writes rows as lines of fields separated by commas, without invisible characters.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn emit_rows(&self, rows: Vec<Vec<String>>, ending: &str) -> Result<(), CliError> {
        let lines = sheets::lines(rows, b',', ending).map_err(|error| output::unprintable(self.lang, error))?;
        self.emit_cleaned(&lines)
    }

    /// Writes an answer that no page writer made, without invisible characters.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn emit_cleaned(&self, answer: &str) -> Result<(), CliError> {
        self.emit(&document::cleaned_lines(answer))
    }

    /// The path of a file relative to the answer: from the folder of `-o`, otherwise from the working directory.
    pub fn beside_answer(&self, path: &Path) -> String {
        let folder = self.output.as_deref().and_then(Path::parent).filter(|folder| !folder.as_os_str().is_empty());
        let absolute = |path: &Path| std::path::absolute(path).ok();
        let seen = folder.and_then(|folder| Some(output::relative(&absolute(path)?, &absolute(folder)?)));
        seen.unwrap_or_else(|| path.to_owned()).display().to_string()
    }

    /// Writes the answer as JSON.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn emit_json(&self, answer: &impl Serialize) -> Result<(), CliError> {
        self.emit(&output::json(answer, self.lang)?)
    }

    /// Writes the answer as YAML.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn emit_yaml(&self, answer: &impl Serialize) -> Result<(), CliError> {
        match serde_yaml::to_string(answer) {
            Ok(text) => self.emit_cleaned(&text),
            Err(error) => Err(output::unprintable(self.lang, error)),
        }
    }

    /// A word in the language of the answers.
    pub fn word<'k>(&self, word: &'k str) -> &'k str {
        self.lang.word(word)
    }
}

/// The result of a command with usable input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Done; exit code 0.
    Done,
    /// Done, with something wrong found; exit code 1.
    Findings,
}

/// Why a command has no answer; exit code 2.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// Some input cannot be used: a file, the question, the place for the answer.
    #[error("{}", problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))]
    Unusable {
        /// The problems with their places and remedies.
        problems: Vec<Diagnostic>,
        /// The texts that the places are in.
        texts: Texts,
    },
    /// The command has already shown the problems as its answer.
    #[error("the input could not be used")]
    Shown,
}

impl CliError {
    /// The knowledge base lacks something that is required.
    pub fn of_knowledge(error: &KnowledgeError, lang: Lang) -> Self {
        Diagnostic::error("knowledge", technolog::note::Note::from(error), None).help(words::run_lint(lang)).into()
    }
}

impl From<Diagnostic> for CliError {
    fn from(problem: Diagnostic) -> Self {
        Self::Unusable { problems: vec![problem], texts: Texts::default() }
    }
}

/// Parses the arguments, runs the command, and converts its result into an exit code.
pub fn main() -> ExitCode {
    let environment = std::env::var("LANG").ok();
    let default = Lang::of_environment(environment.as_deref());
    let lang = help::language(default);
    // The texts of the help are looked up only if it is shown.
    let arguments = help::asked_for(std::env::args_os().collect());
    let parsed = help::bare().try_get_matches_from(&arguments);
    let matches = match parsed.or_else(|_| help::command(lang).try_get_matches_from(&arguments)) {
        Ok(matches) => matches,
        Err(error) => return refused(&error, lang),
    };
    let cli = match Cli::from_arg_matches(&matches) {
        Ok(cli) => cli,
        Err(error) => return refused(&error, lang),
    };
    let mut outputs = cli.global.output.into_iter();
    let context = Context {
        lang: cli.global.lang.unwrap_or(default),
        knowledge: cli.global.knowledge,
        layers: cli.global.with,
        format: cli.global.format,
        output: outputs.next(),
        more_outputs: outputs.collect(),
        inputs: input::Inputs::default(),
        amount: if cli.global.all_problems { Amount::All } else { Amount::Some },
        tables: OnceLock::new(),
    };
    let asked = if context.more_outputs.is_empty() || matches!(cli.command, Command::Report(_)) {
        cli.command.run(&context)
    } else {
        let message = say!(context.lang, "usage-twice", argument = "--output <FILE>", value = "");
        Err(Diagnostic::error("several-files", message, None).help(context.word("cli-one-file")).into())
    };
    match asked {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Findings) => ExitCode::from(1),
        Err(CliError::Shown) => ExitCode::from(2),
        Err(CliError::Unusable { problems, texts }) => {
            output::complain(&diagnostics::render(problems, &texts, context.amount, context.lang));
            ExitCode::from(2)
        }
    }
}

/// Help and version, or arguments that fit no command.
fn refused(error: &clap::Error, lang: words::Lang) -> ExitCode {
    let arguments: Vec<String> =
        std::env::args_os().skip(1).map(|argument| argument.to_string_lossy().into_owned()).collect();
    match usage::message(error, &mut help::command(lang), &arguments, lang) {
        Some(message) => output::complain(&document::cleaned_lines(&message)),
        None => {
            let text = usage::worded(&error.render().to_string(), lang);
            // If this cannot be printed either, the error is ignored.
            let _ = if error.use_stderr() {
                output::complain(&text);
                Ok(())
            } else {
                output::write(text.as_bytes(), None, lang)
            };
        }
    }
    ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2))
}
