//! The whole knowledge base: every table by its id.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::OnceLock;
use std::{fs, io};
use technolog_note::{Note, note};

use serde::{Deserialize, Serialize};

use crate::by_id::ById;
use crate::diagnostic::Diagnostic;
use crate::input::{bytes_of, of_system, text_of, too_large};
use crate::lint::cases::CaseFile;
use crate::load::table_with;
use crate::table::{Table, TableError};
use crate::vocabulary::Vocabularies;

/// The folder of vocabularies: tables that are read before all others.
const VOCABULARIES: &str = "catalogs/vocabularies/";

/// A knowledge file as text, named by its path inside the knowledge folder.
#[derive(Clone, Copy, Debug)]
pub struct SourceFile<'a> {
    /// `catalogs/holes/a08-....yaml`.
    pub path: &'a str,
    /// Its text.
    pub text: &'a str,
}

/// A table that is unpacked on first use: a plan needs a quarter of them.
#[derive(Debug)]
struct Stored {
    packed: &'static [u8],
    table: OnceLock<Result<Table, TableError>>,
    family: Family<'static>,
}

/// The properties of a table that are known without unpacking: the family it belongs to.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
struct Family<'a> {
    /// Whether it is a table of cutters.
    of_cutters: bool,
    /// The schema whose record it is.
    #[serde(borrow)]
    record_of: Option<Cow<'a, str>>,
}

impl<'a> Family<'a> {
    fn of(table: &'a Table) -> Self {
        Self { of_cutters: table.tool.is_some(), record_of: table.record_of().map(Cow::Borrowed) }
    }
}

impl Stored {
    fn read(table: Table) -> Self {
        let Family { of_cutters, record_of } = Family::of(&table);
        let family = Family { of_cutters, record_of: record_of.map(|schema| Cow::Owned(schema.into_owned())) };
        Self { packed: &[], family, table: OnceLock::from(Ok(table)) }
    }

    fn table(&self) -> Result<&Table, TableError> {
        self.table.get_or_init(|| unpacked(self.packed)).as_ref().map_err(Clone::clone)
    }
}

fn unpacked(bytes: &[u8]) -> Result<Table, TableError> {
    postcard::from_bytes(bytes).map_err(|error| TableError {
        table: String::new(),
        file: "knowledge".to_owned(),
        row: String::new(),
        problem: note!("table-compiled-tables-do-fit-this", error = error.to_string()).into(),
    })
}

/// The compiled form of a table: the properties needed for all tables, and the rest.
#[derive(Serialize, Deserialize)]
struct Packed<'a> {
    id: &'a str,
    #[serde(borrow)]
    family: Family<'a>,
    #[serde(borrow)]
    bytes: Cow<'a, [u8]>,
}

/// Every table, ordered by id, and the examples beside the decision tables.
#[derive(Debug, Default)]
pub struct Knowledge {
    tables: ById<Stored>,
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

    /// As [`Self::from_sources`], with everything that could be read beside the problems.
    pub fn read_sources(files: &[SourceFile<'_>]) -> (Self, Vec<Diagnostic>) {
        let mut knowledge = Self::default();
        let mut tables = BTreeMap::<Cow<'static, str>, Stored>::new();
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
                Ok(table) => match tables.get(table.id.as_str()).and_then(|first| first.table().ok()) {
                    Some(first) => problems.push(Diagnostic::error(
                        "duplicate-table",
                        note!("table-table-already", path = file.path, table = table.id, file = first.file),
                        None,
                    )),
                    None => {
                        if file.path.starts_with(VOCABULARIES) {
                            vocabularies.add(&table);
                        }
                        tables.insert(Cow::Owned(table.id.clone()), Stored::read(table));
                    }
                },
                Err(found) => problems.extend(found),
            }
        }
        knowledge.tables = tables.into();
        (knowledge, problems)
    }

    /// Reads `catalogs/` and `rules/` of a folder: every file that ends in `.yaml`.
    ///
    /// # Errors
    /// Every file that cannot be read; otherwise paths and contents.
    pub fn read_folder(folder: &Path) -> Result<Vec<(String, String)>, Vec<Diagnostic>> {
        let mut files = Vec::new();
        let mut problems = Vec::new();
        for top in ["catalogs", "rules"] {
            collect_yaml(&folder.join(top), top, &mut files, &mut problems);
        }
        if files.is_empty() && problems.is_empty() {
            let message = note!("table-no-tables", folder = folder.display().to_string());
            problems
                .push(Diagnostic::error("no-knowledge", message, None).help(note!("table-must-hold-catalogs-rules")));
        }
        if problems.is_empty() { Ok(files) } else { Err(problems) }
    }

    /// A table by its id.
    ///
    /// # Errors
    /// There is no such table.
    pub fn table(&self, id: &str) -> Result<&Table, TableError> {
        let stored = self.tables.get(id).ok_or_else(|| TableError {
            table: id.to_owned(),
            file: "knowledge".to_owned(),
            row: String::new(),
            problem: note!("table-there-no-such-table-technolog").into(),
        })?;
        stored.table()
    }

    /// Every table, by id.
    pub fn tables(&self) -> impl Iterator<Item = &Table> {
        self.tables.items().filter_map(|stored| stored.table().ok())
    }

    /// The tables of cutters, by id.
    pub fn tables_of_cutters(&self) -> impl Iterator<Item = &Table> {
        self.of_family(|family| family.of_cutters)
    }

    /// The tables that are records of a schema, by id.
    pub fn records_of(&self, schema: &str) -> impl Iterator<Item = &Table> {
        self.of_family(move |family| family.record_of.as_deref() == Some(schema))
    }

    fn of_family(&self, is: impl Fn(&Family<'static>) -> bool) -> impl Iterator<Item = &Table> {
        self.tables.items().filter(move |stored| is(&stored.family)).filter_map(|stored| stored.table().ok())
    }

    /// The ids of the tables, in their order.
    pub fn ids(&self) -> impl Iterator<Item = &str> {
        self.tables.ids()
    }

    /// All tables, moved out.
    pub fn into_tables(self) -> impl Iterator<Item = Table> {
        self.tables.into_items().filter_map(|stored| {
            let table = stored.table.into_inner().unwrap_or_else(|| unpacked(stored.packed));
            table.ok()
        })
    }

    /// The compiled form that the program embeds.
    ///
    /// # Errors
    /// A table does not serialise; never for tables that were read.
    pub fn to_bytes(&self) -> Result<Vec<u8>, String> {
        let pack = |table: &Table| postcard::to_stdvec(table).map_err(|error| error.to_string());
        let packed = self
            .tables()
            .map(|table| Ok(Packed { id: &table.id, family: Family::of(table), bytes: pack(table)?.into() }))
            .collect::<Result<Vec<_>, String>>()?;
        postcard::to_stdvec(&packed).map_err(|error| error.to_string())
    }

    /// Reads the compiled form; its tables are unpacked when they are first used.
    ///
    /// # Errors
    /// The bytes are not of this version of the program.
    pub fn from_bytes(bytes: &'static [u8]) -> Result<Self, String> {
        let packed: Vec<Packed<'static>> = postcard::from_bytes(bytes).map_err(|error| error.to_string())?;
        let stored = packed.into_iter().map(|Packed { id, family, bytes }| {
            let Cow::Borrowed(packed) = bytes else { return Err("the tables are not embedded".to_owned()) };
            Ok((Cow::Borrowed(id), Stored { packed, table: OnceLock::new(), family }))
        });
        let tables = stored.collect::<Result<BTreeMap<_, _>, String>>()?;
        Ok(Self { tables: tables.into(), cases: Vec::new() })
    }
}

fn collect_yaml(folder: &Path, name: &str, files: &mut Vec<(String, String)>, problems: &mut Vec<Diagnostic>) {
    let unreadable = |error: std::io::Error| {
        let why = of_system(&error);
        Diagnostic::error(
            "unreadable",
            note!("table-file-unreadable", file = folder.display().to_string(), why = why),
            None,
        )
        .help(note!("table-name-folder-holds-catalogs-rules"))
    };
    let entries = match fs::read_dir(folder).and_then(Iterator::collect::<io::Result<Vec<_>>>) {
        Ok(entries) => entries,
        Err(error) => return problems.push(unreadable(error)),
    };
    // Links to folders are skipped, because they could form a cycle.
    let is_folder = |entry: &fs::DirEntry| entry.file_type().is_ok_and(|kind| kind.is_dir());
    let mut paths: Vec<_> = entries.iter().map(|entry| (entry.path(), is_folder(entry))).collect();
    paths.sort();
    for (path, is_folder) in paths {
        let Some(file_name) = path.file_name().and_then(|name| name.to_str()) else { continue };
        let inner = format!("{name}/{file_name}");
        if is_folder {
            collect_yaml(&path, &inner, files, problems);
        } else if file_name.ends_with(".yaml") {
            match text_of_file(&path) {
                Ok(text) => files.push((inner, text)),
                Err(problem) => problems.push(problem),
            }
        }
    }
}

#[expect(clippy::result_large_err, reason = "a file is read once")]
fn text_of_file(path: &Path) -> Result<String, Diagnostic> {
    let shown = path.display().to_string();
    let unreadable =
        |why: Note| Diagnostic::error("unreadable", note!("table-file-unreadable", file = shown, why = why), None);
    // Reading a pipe would wait for a writer.
    if fs::metadata(path).is_ok_and(|file| !file.is_file()) {
        return Err(unreadable(note!("input-not-regular")));
    }
    let bytes = fs::File::open(path).and_then(bytes_of).map_err(|error| unreadable(of_system(&error)))?;
    text_of(&shown, bytes.ok_or_else(|| too_large(&shown))?)
}
