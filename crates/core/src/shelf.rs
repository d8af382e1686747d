//! Rows of tables that planning reads again and again: each table is read once for a part.

use std::sync::OnceLock;
use technolog_note::note;

use crate::error::KnowledgeError;
use crate::knowledge::table::ToolHead;
use crate::knowledge::vocabulary::Operation;
use crate::knowledge::{Knowledge, Table, TableError, TableRow};
use crate::tables::holders::HolderRow;
use crate::tables::holes::{HoleConvention, Scheme};
use crate::tables::materials::Clamping;
use crate::tables::standards::MorseTaper;
use crate::tables::tools::CutterRow;

/// Tables that are read at their first use.
#[derive(Debug)]
pub struct Shelf<'k> {
    knowledge: &'k Knowledge,
    cutters: Vec<CutterTable<'k>>,
    holders: Vec<(&'static str, Rows<HolderRow<'k>>)>,
    conventions: Rows<HoleConvention<'k>>,
    schemes: Rows<Scheme<'k>>,
    clamping: Rows<Clamping<'k>>,
    morse: Rows<MorseTaper<'k>>,
}

/// A table of cutters.
#[derive(Debug)]
pub struct CutterTable<'k> {
    /// The table.
    pub table: &'k Table,
    /// The head of the table, for all its cutters.
    pub head: &'k ToolHead,
    rows: Rows<CutterRow<'k>>,
}

/// The rows of one table, once they are read.
#[derive(Debug)]
struct Rows<R>(OnceLock<Vec<R>>);

impl<'k, R: TableRow<'k>> Rows<R> {
    const fn unread() -> Self {
        Self(OnceLock::new())
    }

    fn get_or_read(&self, table: impl FnOnce() -> Result<&'k Table, TableError>) -> Result<&[R], TableError> {
        match self.0.get() {
            Some(rows) => Ok(rows),
            None => {
                let rows = table()?.read()?;
                Ok(self.0.get_or_init(|| rows))
            }
        }
    }
}

impl<'k> CutterTable<'k> {
    /// Its rows.
    ///
    /// # Errors
    /// A row breaks its contract; this does not happen to checked tables.
    pub fn rows(&self) -> Result<&[CutterRow<'k>], TableError> {
        self.rows.get_or_read(|| Ok(self.table))
    }
}

impl<'k> Shelf<'k> {
    /// With nothing read yet.
    pub fn new(knowledge: &'k Knowledge) -> Self {
        let cutters = knowledge.tables_of_cutters().filter_map(|table| {
            let head = table.tool.as_ref()?;
            Some(CutterTable { table, head, rows: Rows::unread() })
        });
        let holders = HolderRow::TABLES.iter().map(|id| (*id, Rows::unread()));
        Self {
            knowledge,
            cutters: cutters.collect(),
            holders: holders.collect(),
            conventions: Rows::unread(),
            schemes: Rows::unread(),
            clamping: Rows::unread(),
            morse: Rows::unread(),
        }
    }

    /// Every table of cutters, by id.
    pub fn cutters(&self) -> &[CutterTable<'k>] {
        &self.cutters
    }

    /// The table of cutters of that id, as the rule `tool-tables` names it.
    ///
    /// # Errors
    /// There is no such table, or it is none of cutters.
    pub fn cutters_of(&self, id: &str) -> Result<&CutterTable<'k>, KnowledgeError> {
        let found = self.cutters.iter().find(|cutters| cutters.table.id == id);
        found.ok_or_else(|| KnowledgeError::missing(id, note!("part-there-no-such-table-cutters")))
    }

    /// Every cutter that makes a transition, whatever its size.
    ///
    /// # Errors
    /// A row breaks its contract; this does not happen to checked tables.
    pub fn cutters_for(&self, operation: Operation) -> Result<Vec<&CutterRow<'k>>, TableError> {
        let mut found = Vec::new();
        for tables in self.cutters.iter().filter(|tables| tables.head.operations.contains(&operation)) {
            found.extend(tables.rows()?);
        }
        Ok(found)
    }

    /// The holders of the table of that id, as the rule `holder-for-shank` names it.
    ///
    /// # Errors
    /// There is no such table, or it is none of holders.
    pub fn holders_of(&self, id: &str) -> Result<&[HolderRow<'k>], KnowledgeError> {
        let found = self.holders.iter().find(|(known, _)| *known == id);
        let (_, rows) = found.ok_or_else(|| KnowledgeError::missing(id, note!("part-there-no-such-table-holders")))?;
        Ok(rows.get_or_read(|| self.knowledge.table(id))?)
    }

    /// The constants of clamping.
    ///
    /// # Errors
    /// There is no such table.
    pub fn clamping(&self) -> Result<&[Clamping<'k>], TableError> {
        self.clamping.get_or_read(|| self.knowledge.table_of::<Clamping<'k>>())
    }

    /// The Morse tapers.
    ///
    /// # Errors
    /// There is no such table.
    pub fn morse_tapers(&self) -> Result<&[MorseTaper<'k>], TableError> {
        self.morse.get_or_read(|| self.knowledge.table_of::<MorseTaper<'k>>())
    }

    /// The conventions on holes.
    ///
    /// # Errors
    /// There is no such table.
    pub fn conventions(&self) -> Result<&[HoleConvention<'k>], TableError> {
        self.conventions.get_or_read(|| self.knowledge.table_of::<HoleConvention<'k>>())
    }

    /// The schemes of A.7.
    ///
    /// # Errors
    /// There is no such table.
    pub fn schemes(&self) -> Result<&[Scheme<'k>], TableError> {
        self.schemes.get_or_read(|| self.knowledge.table_of::<Scheme<'k>>())
    }
}
