//! `technolog audit DIR`: every plan of a folder, on all cores, in one table.

use std::io;
use std::path::{Path, PathBuf};

use technolog::audit::class::{Alike, alike};
use technolog::audit::marks::MarkingScheme;
use technolog::audit::{Audited, Auditor, Unread};
use technolog::document::cleaned;
use technolog::knowledge::Diagnostic;
use technolog::sheets::{Row, Sheet};
use technolog::words::say;
use technolog::{parallel, report};

use super::super::input::FileRoots;
use super::super::problems::{of_system, unreadable};
use super::super::progress::Progress;
use super::super::{CliError, Context, Format, Outcome, output};
use super::{file, program};

/// The result for a file of the folder.
enum FolderItem {
    Plan(Audited),
    /// It is no plan.
    NoPlan,
    /// A program, which is judged with the part that it makes.
    Program,
}

/// The formats of a folder: the last two are the grade book.
pub const FORMATS: &[Format] =
    &[Format::Text, Format::Json, Format::Yaml, Format::Markdown, Format::Html, Format::Csv, Format::Xlsx];

/// What is asked of a folder.
#[derive(Clone, Copy)]
pub struct Asked<'a> {
    /// The folder.
    pub folder: &'a Path,
    /// The format of the answer.
    pub format: Format,
    /// The marking scheme.
    pub scheme: Option<&'a MarkingScheme>,
    /// Where the sheets of the students are written.
    pub sheets: Option<&'a Path>,
}

/// Audits every plan of a folder and of the folders in it, in the order of their names.
///
/// # Errors
/// The folder cannot be read, or has no plan; or a plan cannot be read, which the table has reported.
pub fn run(
    &Asked { folder, format, scheme, sheets }: &Asked<'_>,
    auditor: &Auditor<'_>,
    places: FileRoots<'_>,
    context: &Context,
) -> Result<Outcome, CliError> {
    let (mut files, mut barred) = (Vec::new(), Vec::new());
    collect(folder, &mut files, &mut barred).map_err(|error| unreadable(folder.display(), &error, context.lang))?;
    let progress = Progress::new(files.len());
    let seen =
        parallel::map(&files, |path| audit_file(path, auditor, scheme, places, context), |done| progress.show(done));
    progress.clear();
    let mut audited: Vec<Audited> = barred.iter().map(|(folder, error)| unopened(folder, error, context)).collect();
    for (path, seen) in files.iter().zip(seen) {
        match seen? {
            FolderItem::Plan(plan) => {
                context.uses(path);
                audited.push(plan);
            }
            FolderItem::Program => {
                let alone = say!(context.lang, "audit-program-in-folder", file = path.display().to_string());
                output::complain(&format!("{}\n", cleaned(&alone)));
            }
            FolderItem::NoPlan => {
                let skipped = say!(context.lang, "audit-skipped-file", file = path.display().to_string());
                output::complain(&format!("{}\n", cleaned(&skipped)));
            }
        }
    }
    if audited.is_empty() {
        let message = say!(context.lang, "audit-no-plans", folder = folder.display().to_string());
        return Err(Diagnostic::error("no-plans", message, None).help(context.word("audit-what-is-a-plan")).into());
    }
    let sheets = sheets.map(|folder| write_sheets(folder, format, &audited, context)).transpose()?.unwrap_or_default();
    let pairs = alike(&audited, auditor);
    match format {
        Format::Csv => context.emit_separated(&grade_book(&audited, &pairs, context))?,
        Format::Xlsx => context.emit_workbook(&grade_book(&audited, &pairs, context))?,
        Format::Json => context.emit_json(&audited)?,
        Format::Yaml => context.emit_yaml(&audited)?,
        _ => context.emit_document(&report::audit::many::page(&audited, &pairs, &sheets, context.lang), format)?,
    }
    if audited.iter().any(|one| one.audit().is_none()) {
        return Err(CliError::Shown);
    }
    let wrong = audited.iter().filter_map(Audited::audit).any(technolog::audit::Audit::has_errors);
    Ok(if wrong { Outcome::Findings } else { Outcome::Done })
}

/// The grade book as tables.
fn grade_book(audited: &[Audited], pairs: &[Alike], context: &Context) -> Vec<Sheet> {
    let tables = report::audit::class::grade_book(audited, pairs, context.lang).into_iter();
    let rows = |rows: Vec<Vec<String>>| (1..).zip(rows).map(|(line, cells)| Row { line, cells }).collect();
    tables.map(|table| Sheet { name: table.name, rows: rows(table.rows) }).collect()
}

/// Writes a sheet for each work that could be read; their paths from the page, in the order of the works.
fn write_sheets(
    folder: &Path,
    format: Format,
    audited: &[Audited],
    context: &Context,
) -> Result<Vec<String>, CliError> {
    let (Format::Html | Format::Markdown) = format else {
        let message = say!(context.lang, "audit-sheets-format");
        return Err(Diagnostic::error("sheets-format", message, None)
            .help(context.word("audit-sheets-format-help"))
            .into());
    };
    std::fs::create_dir_all(folder).map_err(|error| output::unwritable(&error, folder, context.lang))?;
    let ending = format.endings().first().copied().unwrap_or_default();
    let mut paths = Vec::new();
    for (at, one) in audited.iter().enumerate() {
        let Some(audit) = one.audit() else {
            paths.push(String::new());
            continue;
        };
        // The number keeps works of one name apart.
        let stem =
            Path::new(&audit.file).file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        let path = folder.join(format!("{:03}-{stem}{ending}", at + 1));
        let page = context.written(&report::audit::student::page(audit, context.lang), format, Some(&path));
        output::write(page.as_bytes(), Some(&path), context.lang)?;
        paths.push(context.beside_answer(&path));
    }
    Ok(paths)
}

fn audit_file(
    path: &Path,
    auditor: &Auditor<'_>,
    scheme: Option<&MarkingScheme>,
    places: FileRoots<'_>,
    context: &Context,
) -> Result<FolderItem, CliError> {
    if program::is_program(path, false) {
        return Ok(FolderItem::Program);
    }
    if !may_be_plan(path) {
        return Ok(FolderItem::NoPlan);
    }
    let stated = match file::read_any(path, auditor, places, context) {
        Ok(Some(stated)) => stated,
        Ok(None) => return Ok(FolderItem::NoPlan),
        Err(CliError::Unusable { problems, .. }) => {
            return Ok(FolderItem::Plan(unread(path, &problems, context)));
        }
        Err(error) => return Err(error),
    };
    let mut found = match auditor.audit(&stated) {
        Ok(found) => found,
        Err(error) => {
            let problem = stated.at_fault(&error).ok_or_else(|| CliError::of_knowledge(&error, context.lang))?;
            return Ok(FolderItem::Plan(unread(path, &[problem], context)));
        }
    };
    found.marks = scheme.map(|scheme| scheme.mark(&found));
    Ok(FolderItem::Plan(Audited::Plan(Box::new(found))))
}

fn unread(path: &Path, problems: &[Diagnostic], context: &Context) -> Audited {
    Audited::Unreadable(Unread::new(&path.display().to_string(), problems, context.lang))
}

/// A folder that could not be opened, so that its contents are unknown.
fn unopened(folder: &Path, error: &io::Error, context: &Context) -> Audited {
    let error = of_system(error, context.lang);
    let message = say!(context.lang, "cli-cannot-read", path = folder.display().to_string(), error = error);
    unread(folder, &[Diagnostic::error("unreadable", message, None)], context)
}

/// The files, which may be plans, and the subfolders that cannot be read. Hidden files are skipped, and links to
/// folders, which could form a cycle.
fn collect(folder: &Path, files: &mut Vec<PathBuf>, barred: &mut Vec<(PathBuf, io::Error)>) -> io::Result<()> {
    let mut entries = std::fs::read_dir(folder)?.collect::<io::Result<Vec<_>>>()?;
    entries.sort_by_key(std::fs::DirEntry::file_name);
    for entry in entries {
        let path = entry.path();
        if entry.file_name().to_string_lossy().starts_with('.') {
            continue;
        }
        if entry.file_type()?.is_dir() {
            if let Err(error) = collect(&path, files, barred) {
                barred.push((path, error));
            }
        } else {
            files.push(path);
        }
    }
    Ok(())
}

/// Whether a file may be a plan, by its name.
fn may_be_plan(path: &Path) -> bool {
    file::table_kind(path).is_some()
        || path.extension().is_some_and(|kind| ["yaml", "yml", "json"].iter().any(|known| kind == *known))
}
