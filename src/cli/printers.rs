//! What prints a report: one line for each format, chosen by the ending of its file.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use technolog::document::Document;
use technolog::knowledge::Diagnostic;
use technolog::words::say;

use super::output::unprintable;
use super::progress::Progress;
use super::{CliError, Context, Format};

/// Prints a page as the bytes of a file. The path tells what else may be asked of it: the width of a screen.
type Print = fn(&Document, Option<&Path>, &Context) -> Result<Vec<u8>, CliError>;

/// A format with what prints it.
#[derive(Clone, Copy, Debug)]
pub struct Printer {
    format: Format,
    print: Print,
    /// The command that builds a program with this printer, where this one was built without it.
    lacks: Option<&'static str>,
}

impl Printer {
    const fn here(format: Format, print: Print) -> Self {
        Self { format, print, lacks: None }
    }
}

/// All printers; the first is that of a report for which none is named.
pub const PRINTERS: [Printer; 6] = [
    Printer::here(Format::Html, html),
    PDF,
    Printer::here(Format::Markdown, markdown),
    Printer::here(Format::Text, text),
    Printer::here(Format::Docx, docx),
    Printer::here(Format::Xlsx, xlsx),
];

/// The formats of all printers.
pub const FORMATS: [Format; PRINTERS.len()] = {
    let mut formats = [Format::Text; PRINTERS.len()];
    let mut at = 0;
    while at < formats.len() {
        formats[at] = PRINTERS[at].format;
        at += 1;
    }
    formats
};

#[cfg(feature = "pdf")]
const PDF: Printer = Printer::here(Format::Pdf, |page, file, context| {
    not_for_the_screen(Format::Pdf, file, context)?;
    technolog_pdf::pdf(page, &context.page_words()).map_err(|why| unprintable(context.lang, why.0))
});

#[cfg(not(feature = "pdf"))]
const PDF: Printer = Printer { format: Format::Pdf, print: html, lacks: Some("cargo build --release --features pdf") };

fn html(page: &Document, file: Option<&Path>, context: &Context) -> Result<Vec<u8>, CliError> {
    Ok(context.written(page, Format::Html, file).into_bytes())
}

fn markdown(page: &Document, file: Option<&Path>, context: &Context) -> Result<Vec<u8>, CliError> {
    Ok(context.written(page, Format::Markdown, file).into_bytes())
}

fn text(page: &Document, file: Option<&Path>, context: &Context) -> Result<Vec<u8>, CliError> {
    Ok(context.written(page, Format::Text, file).into_bytes())
}

fn docx(page: &Document, file: Option<&Path>, context: &Context) -> Result<Vec<u8>, CliError> {
    not_for_the_screen(Format::Docx, file, context)?;
    technolog::office::docx(page, &context.page_words()).map_err(|error| unprintable(context.lang, error))
}

fn xlsx(page: &Document, file: Option<&Path>, context: &Context) -> Result<Vec<u8>, CliError> {
    not_for_the_screen(Format::Xlsx, file, context)?;
    technolog::office::xlsx(page, &context.page_words()).map_err(|error| unprintable(context.lang, error))
}

/// A terminal cannot show what is no text.
fn not_for_the_screen(format: Format, file: Option<&Path>, context: &Context) -> Result<(), CliError> {
    if file.is_some_and(|file| file != Path::new("-")) || !std::io::stdout().is_terminal() {
        return Ok(());
    }
    let message = say!(context.lang, "cli-not-on-screen", format = format.name());
    let help = say!(context.lang, "cli-name-a-file", ending = format.endings()[0]);
    Err(Diagnostic::error("not-on-screen", message, None).help(help).into())
}

/// The files of an answer, each with its printer.
#[derive(Debug)]
pub struct Targets(Vec<(Option<PathBuf>, Printer)>);

impl Targets {
    /// The printers for the files of `-o`; for the screen that of `--format`.
    ///
    /// # Errors
    /// An ending has no printer, or another one than `--format` says; a file is named twice; this program was built
    /// without the printer.
    pub fn of(command: &str, context: &Context) -> Result<Self, CliError> {
        let named: Vec<&PathBuf> = context.output.iter().chain(&context.more_outputs).collect();
        if let Some(twice) = named.iter().enumerate().find(|(at, file)| named[..*at].contains(file)) {
            let message = say!(context.lang, "cli-file-twice", file = twice.1.display().to_string());
            return Err(Diagnostic::error("file-twice", message, None).help(context.word("cli-another-file")).into());
        }
        let files = if named.is_empty() { vec![None] } else { named.into_iter().map(Some).collect() };
        let target = |file: Option<&PathBuf>| {
            let file = file.cloned();
            Ok((file.clone(), printer(command, file.as_deref(), context)?))
        };
        files.into_iter().map(target).collect::<Result<_, _>>().map(Self)
    }

    /// Prints a page with all printers, then writes all files, or none.
    ///
    /// # Errors
    /// A file cannot be printed or written.
    pub fn print(&self, page: &Document, context: &Context) -> Result<(), CliError> {
        let page = &*context.named(page);
        let progress = Progress::new(self.0.len());
        let mut printed = Vec::new();
        for (done, (file, printer)) in self.0.iter().enumerate() {
            if self.0.len() > 1 {
                progress.show(done);
            }
            printed.push((file.as_deref(), (printer.print)(page, file.as_deref(), context)?));
        }
        progress.clear();
        context.emit_files(&printed)
    }
}

fn printer(command: &str, file: Option<&Path>, context: &Context) -> Result<Printer, CliError> {
    let format = context.format_of(file, command, &FORMATS)?;
    let is_file = file.is_some_and(|file| file != Path::new("-") && (file.is_file() || !file.exists()));
    if let (true, None, Some(file)) = (is_file, context.format, file)
        && Format::of_ending(file).is_empty()
    {
        let message = say!(context.lang, "cli-unknown-ending", file = file.display().to_string());
        let help = say!(context.lang, "cli-known-endings", known = super::format::endings(&FORMATS));
        return Err(Diagnostic::error("unknown-ending", message, None).help(help).into());
    }
    let printer = PRINTERS.iter().find(|own| own.format == format).copied().unwrap_or(PRINTERS[0]);
    match printer.lacks {
        None => Ok(printer),
        Some(command) => {
            let message = say!(context.lang, "cli-not-built", format = format.name());
            let help = say!(context.lang, "cli-build-it", command = command);
            Err(Diagnostic::error("not-built", message, None).help(help).into())
        }
    }
}
