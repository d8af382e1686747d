//! The whole knowledge base: every table by its id.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::diagnostic::Diagnostic;
use crate::lint::cases::CaseFile;
use crate::load::table_with;
use crate::table::{Table, TableError};
use crate::vocabulary::Vocabularies;

/// Where the vocabularies stand: tables that are read before all others.
const VOCABULARIES: &str = "catalogs/vocabularies/";

/// A knowledge file as text, named by its path inside the knowledge folder.
#[derive(Clone, Copy, Debug)]
pub struct SourceFile<'a> {
    /// `catalogs/holes/a08-....yaml`.
    pub path: &'a str,
    /// Its text.
    pub text: &'a str,
}

/// Every table, ordered by id, and the examples beside the decision tables.
#[derive(Debug, Default)]
pub struct Knowledge {
    tables: BTreeMap<String, Table>,
    /// Examples of decision tables; only when read from YAML.
    pub(crate) cases: Vec<CaseFile>,
}

impl Knowledge {
    /// Reads tables and examples from texts.
    ///
    /// # Errors
    /// Every problem of every file.
    pub fn from_sources(files: &[SourceFile<'_>]) -> Result<Self, Vec<Diagnostic>> {
        let (knowledge, problems) = Self::read_sources(files);
        if problems.is_empty() { Ok(knowledge) } else { Err(problems) }
    }

    /// As [`Self::from_sources`], with what could be read beside the problems.
    pub fn read_sources(files: &[SourceFile<'_>]) -> (Self, Vec<Diagnostic>) {
        let mut knowledge = Self::default();
        let mut problems = Vec::new();
        let mut vocabularies = Vocabularies::of_code();
        let (words, others): (Vec<_>, Vec<&SourceFile<'_>>) =
            files.iter().partition(|file| file.path.starts_with(VOCABULARIES));
        for file in words.into_iter().chain(others) {
            if file.path.ends_with(".test.yaml") {
                match CaseFile::from_text(file.path, file.text) {
                    Ok(cases) => knowledge.cases.push(cases),
                    Err(found) => problems.extend(found),
                }
                continue;
            }
            match table_with(file.path, file.text, &vocabularies) {
                Ok(table) => match knowledge.tables.get(&table.id) {
                    Some(first) => problems.push(Diagnostic::error(
                        "duplicate-table",
                        format!("{}: the table {} is already in {}", file.path, table.id, first.file),
                        None,
                    )),
                    None => {
                        if file.path.starts_with(VOCABULARIES) {
                            vocabularies.add(&table);
                        }
                        knowledge.tables.insert(table.id.clone(), table);
                    }
                },
                Err(found) => problems.extend(found),
            }
        }
        (knowledge, problems)
    }

    /// Reads `catalogs/` and `rules/` of a folder: every file that ends in `.yaml`.
    ///
    /// # Errors
    /// Every file that cannot be read, as text of path and content otherwise.
    pub fn read_folder(folder: &Path) -> Result<Vec<(String, String)>, Vec<Diagnostic>> {
        let mut files = Vec::new();
        let mut problems = Vec::new();
        for top in ["catalogs", "rules"] {
            collect_yaml(&folder.join(top), top, &mut files, &mut problems);
        }
        if files.is_empty() && problems.is_empty() {
            let message = format!("{}: no tables in it", folder.display());
            problems.push(Diagnostic::error("no-knowledge", message, None).help("it must hold catalogs/ and rules/"));
        }
        if problems.is_empty() { Ok(files) } else { Err(problems) }
    }

    /// A table by its id.
    ///
    /// # Errors
    /// There is no such table.
    pub fn table(&self, id: &str) -> Result<&Table, TableError> {
        self.tables.get(id).ok_or_else(|| TableError {
            table: id.to_owned(),
            file: "knowledge".to_owned(),
            row: String::new(),
            problem: "there is no such table; `technolog table` lists them".to_owned(),
        })
    }

    /// Every table, by id.
    pub fn tables(&self) -> impl Iterator<Item = &Table> {
        self.tables.values()
    }

    /// Every table, given away.
    pub fn into_tables(self) -> impl Iterator<Item = Table> {
        self.tables.into_values()
    }

    /// The compiled form that the program embeds.
    ///
    /// # Errors
    /// A table does not serialise; never for tables that were read.
    pub fn to_bytes(&self) -> Result<Vec<u8>, String> {
        postcard::to_stdvec(&self.tables.values().collect::<Vec<_>>()).map_err(|error| error.to_string())
    }

    /// Reads the compiled form.
    ///
    /// # Errors
    /// The bytes are not of this version of the program.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, String> {
        let tables: Vec<Table> = postcard::from_bytes(bytes).map_err(|error| error.to_string())?;
        Ok(Self { tables: tables.into_iter().map(|table| (table.id.clone(), table)).collect(), cases: Vec::new() })
    }
}

fn collect_yaml(folder: &Path, name: &str, files: &mut Vec<(String, String)>, problems: &mut Vec<Diagnostic>) {
    let unreadable = |error: std::io::Error| {
        Diagnostic::error("unreadable", format!("{}: {error}", folder.display()), None)
            .help("name a folder that holds catalogs/ and rules/")
    };
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(error) => return problems.push(unreadable(error)),
    };
    let mut paths: Vec<_> = entries.filter_map(|entry| entry.ok().map(|entry| entry.path())).collect();
    paths.sort();
    for path in paths {
        let Some(file_name) = path.file_name().and_then(|name| name.to_str()) else { continue };
        let inner = format!("{name}/{file_name}");
        if path.is_dir() {
            collect_yaml(&path, &inner, files, problems);
        } else if file_name.ends_with(".yaml") {
            match fs::read_to_string(&path) {
                Ok(text) => files.push((inner, text)),
                Err(error) => {
                    problems.push(Diagnostic::error("unreadable", format!("{}: {error}", path.display()), None));
                }
            }
        }
    }
}
