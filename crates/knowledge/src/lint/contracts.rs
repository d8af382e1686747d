//! Check: every table agrees with the code that reads it.
//!
//! Run by the build, by `--knowledge` and by `lint`, so that a renamed or retyped column, or another unit, is
//! reported there and never changes a plan.

use crate::column::{Column, ColumnRole, ColumnType};
use crate::contract::{Contract, Holds, RequiredColumn, Use, Which, Word};
use crate::diagnostic::{Diagnostic, Place, nearest};
use crate::knowledge::Knowledge;
use crate::table::{Cell, Table};
use crate::units::Unit;
use technolog_note::{Note, note};

/// Checks every table against the contracts of the code; also reports required tables that are missing.
pub fn check(knowledge: &Knowledge, contracts: &[&Contract]) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    for contract in contracts {
        for id in contract.required().filter(|id| knowledge.table(id).is_err()) {
            let message = note!("lint-there-no-table-which-reads", id = id, row = contract.row);
            findings.push(Diagnostic::error("absent-table", message, None).help(note!("lint-add-file-restore")));
        }
        let tables: Vec<&Table> = knowledge.tables().filter(|table| contract.is_of(table)).collect();
        if let (Which::Record(schema), true) = (contract.which, tables.is_empty()) {
            let message = note!("lint-no-table-obeys-law-record", schema = schema, row = contract.row);
            findings.push(Diagnostic::error("absent-table", message, None).help(note!("lint-add-at-least-one")));
        }
        for table in tables {
            findings.extend(hold(table, contract));
        }
        if let Which::Record(schema) = contract.which {
            findings.extend(without_law(knowledge, schema, contracts));
        }
    }
    findings
}

/// Tables named like records of a schema (`machine-…` of `machine-quantities`) and with their columns, but without
/// the law that says so: no code finds them.
fn without_law(knowledge: &Knowledge, schema: &str, contracts: &[&Contract]) -> Vec<Diagnostic> {
    let family = schema.trim_end_matches(|letter| letter != '-');
    let is_record = |id: &&str| id.starts_with(family) && !family.is_empty();
    let unread = unread(knowledge, contracts).into_iter().filter(is_record);
    let tables = unread.filter_map(|id| knowledge.table(id).ok());
    let records = tables.filter(|table| ["name", "value"].iter().all(|name| table.column_index(name).is_some()));
    let finding = |table: &Table| {
        let message = note!("lint-table-has-no-law-record", table = table.id);
        let finding = Diagnostic::error("no-record", message, super::rows::head_place(table));
        finding.help(note!("lint-say-laws-law-record-schema", schema = schema))
    };
    records.map(finding).collect()
}

/// The tables of a knowledge base without a contract, by id: no code reads them.
pub fn unread<'k>(knowledge: &'k Knowledge, contracts: &[&Contract]) -> Vec<&'k str> {
    let has_contract = |table: &Table| contracts.iter().any(|contract| contract.is_of(table));
    knowledge.tables().filter(|table| !has_contract(table)).map(|table| table.id.as_str()).collect()
}

/// The number of tables required by name that exist, and the number that are required.
pub fn present(knowledge: &Knowledge, contracts: &[&Contract]) -> (usize, usize) {
    let ids: Vec<&str> = contracts.iter().flat_map(|contract| contract.required()).collect();
    (ids.iter().filter(|id| knowledge.table(id).is_ok()).count(), ids.len())
}

impl Contract {
    /// The tables that must exist.
    fn required(&self) -> impl Iterator<Item = &'static str> {
        let ids: Vec<&'static str> = match self.which {
            Which::One(id) => vec![id],
            Which::Each(ids) => ids.to_vec(),
            Which::Record(_) | Which::Tools => Vec::new(),
        };
        ids.into_iter()
    }

    /// Whether it is the contract of that table.
    pub fn is_of(&self, table: &Table) -> bool {
        match self.which {
            Which::One(id) => table.id == id,
            Which::Each(ids) => ids.contains(&table.id.as_str()),
            Which::Record(schema) => table.record_of() == Some(schema),
            Which::Tools => table.tool.is_some(),
        }
    }

    /// Whether its tables may lack an optional column.
    const fn is_of_family(&self) -> bool {
        !matches!(self.which, Which::One(_))
    }
}

/// Checks one table against its contract.
pub fn hold(table: &Table, contract: &Contract) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    let required_columns = || contract.inputs.iter().chain(contract.fields);
    for (required, input) in contract
        .inputs
        .iter()
        .map(|required| (required, true))
        .chain(contract.fields.iter().map(|required| (required, false)))
    {
        let Some(column) = table.columns.iter().find(|column| column.name == required.name) else {
            if !(contract.is_of_family() && required.shape.optional) {
                findings.push(missing(table, contract, required.name));
            }
            continue;
        };
        let faults = if input { input_faults(column, required) } else { field_faults(table, column, required) };
        for fault in faults {
            let message =
                note!("lint-table-column", table = table.id, column = column.name, row = contract.row, fault = fault);
            findings.push(Diagnostic::error("broken-contract", message, place(table, column)));
        }
    }
    for name in contract.shown.iter().filter(|name| table.column_index(name).is_none()) {
        if !contract.is_of_family() {
            findings.push(missing(table, contract, name));
        }
    }
    for column in &table.columns {
        let known = required_columns().any(|required| required.name == column.name)
            || contract.shown.contains(&column.name.as_str());
        if !known {
            let message = note!("lint-table-nobody-reads-column", table = table.id, column = column.name);
            let names: Vec<&str> =
                required_columns().map(|required| required.name).chain(contract.shown.iter().copied()).collect();
            let help = match nearest(&column.name, names.iter().copied()) {
                Some(near) => note!("lint-reads", row = contract.row, near = near),
                None => note!("lint-reads-put-what-for-people", row = contract.row, names = names.join(", ")),
            };
            findings.push(Diagnostic::error("unread-column", message, place(table, column)).help(help));
        }
    }
    if let Some(name) = contract.complete {
        complete(table, contract, name, &mut findings);
    }
    findings
}

fn place(table: &Table, column: &Column) -> Option<Place> {
    column.place.clone().or_else(|| Some(super::rows::head_place(table)))
}

fn missing(table: &Table, contract: &Contract, name: &str) -> Diagnostic {
    let message = note!("lint-table-column-missing-which-reads", table = table.id, name = name, row = contract.row);
    let known = contract
        .inputs
        .iter()
        .chain(contract.fields)
        .map(|required| required.name)
        .chain(contract.shown.iter().copied());
    let known: Vec<&str> = known.collect();
    let unread = table.columns.iter().map(|column| column.name.as_str()).filter(|column| !known.contains(column));
    let finding = Diagnostic::error("missing-column", message, super::rows::head_place(table));
    match nearest(name, unread) {
        Some(near) => finding.help(note!("lint-column", near = near)),
        None => finding.help(note!("lint-add-column")),
    }
}

fn input_faults(column: &Column, required: &RequiredColumn) -> Vec<Note> {
    let mut faults = Vec::new();
    if column.role != ColumnRole::Input {
        faults.push(note!("lint-gives-input-which"));
    }
    if required.shape.optional && column.default.is_none() {
        faults.push(note!("lint-may-leave-out-so-needs"));
    }
    faults.extend(type_fault(column, required.shape.holds));
    faults
}

fn field_faults(table: &Table, column: &Column, required: &RequiredColumn) -> Vec<Note> {
    let mut faults = Vec::new();
    if column.role == ColumnRole::Input {
        faults.push(note!("lint-reads-input"));
        return faults;
    }
    if column.list != required.shape.list {
        faults.push(if column.list { note!("lint-reads-one-value-list") } else { note!("lint-reads-list") });
    }
    if column.optional && !required.shape.optional {
        faults.push(note!("lint-needs-every-row-so-cannot"));
    }
    faults.extend(type_fault(column, required.shape.holds));
    // A text or unit that must be a known word is one in every row; otherwise the row could not be read.
    if let (Holds::Word(words), ColumnType::Text | ColumnType::Unit) = (required.shape.holds, column.ty) {
        faults.extend(
            texts(table, column).filter(|text| !words.contains(&text.as_str())).map(|text| unknown(&text, words)),
        );
    }
    faults
}

fn unknown(text: &str, words: &[&str]) -> Note {
    match nearest(text, words.iter().copied()) {
        Some(near) => note!("lint-does-know", text = text, near = near),
        None => note!("lint-does-know-knows", text = text, words = words.join(", ")),
    }
}

fn type_fault(column: &Column, holds: Holds) -> Option<Note> {
    let is = |expected: bool, what: Note| (!expected).then(|| note!("lint-takes", what = what, kind = type_of(column)));
    match holds {
        Holds::Anything => None,
        Holds::Text | Holds::Name(_) => {
            is(matches!(column.ty, ColumnType::Text | ColumnType::Unit | ColumnType::Enum), note!("lint-a-text"))
        }
        Holds::Word(words) if column.ty == ColumnType::Enum => {
            column.values.iter().find(|value| !words.contains(&value.as_str())).map(|value| unknown(value, words))
        }
        Holds::Word(_) => {
            let written = matches!(column.ty, ColumnType::Text | ColumnType::Unit);
            is(written && column.role != ColumnRole::Input, note!("lint-a-word"))
        }
        Holds::Bool => is(column.ty == ColumnType::Bool, note!("lint-true-false")),
        Holds::Int => is(column.ty == ColumnType::Int, note!("lint-whole-number")),
        Holds::Number(unit) => {
            let number = matches!(column.ty, ColumnType::Number | ColumnType::Angle) && column.unit == unit;
            is(number, note!("lint-number", unit = unit))
        }
        Holds::Length => is(column.ty == ColumnType::Length, note!("lint-a-length")),
        Holds::Grade => is(column.ty == ColumnType::It, note!("lint-tolerance-grade")),
        Holds::Roughness => is(column.ty == ColumnType::Roughness, note!("lint-a-roughness")),
    }
}

fn type_of(column: &Column) -> Note {
    match column.unit {
        Unit::None => note!("lint-column-type", kind = column.ty.name()),
        unit => note!("lint-column-type-2", kind = column.ty.name(), unit = unit),
    }
}

fn texts(table: &Table, column: &Column) -> impl Iterator<Item = String> {
    let index = table.column_index(&column.name);
    let cells = table.rows.iter().filter_map(move |row| row.cells.get(index?));
    cells
        .filter_map(|cell| match cell {
            Cell::Value(value) => Some(value.items()),
            _ => None,
        })
        .flatten()
        .map(ToString::to_string)
}

/// Each word of a column's type has a row; in a column of names, exactly those for planning are such words.
fn complete(table: &Table, contract: &Contract, name: &str, findings: &mut Vec<Diagnostic>) {
    let Some(required) = contract.fields.iter().find(|required| required.name == name) else { return };
    let (Holds::Word(words) | Holds::Name(words)) = required.shape.holds else { return };
    let Some(column) = table.columns.iter().find(|column| column.name == name) else { return };
    let listed: Vec<String> = texts(table, column).collect();
    for word in words.iter().filter(|word| !listed.iter().any(|text| text == *word)) {
        let message = note!("lint-table-there-no-row-which", table = table.id, word = word, row = contract.row);
        findings
            .push(Diagnostic::error("missing-row", message, place(table, column)).help(note!("lint-add-row-restore")));
    }
    for (row, (name, stated)) in named(table, contract).enumerate() {
        let read = words.contains(&name.as_str());
        let right = if read { Use::Planning } else { Use::Documentation };
        if stated != right.word() {
            let who = if read { note!("lint-does-read") } else { note!("lint-does-not-read") };
            let message =
                note!("lint-table-for", table = table.id, name = name, stated = stated, row = contract.row, who = who);
            let help = note!("lint-for", word = right.word());
            findings.push(Diagnostic::error("wrong-use", message, super::rows::row_place(table, row)).help(help));
        }
    }
}

/// The names of a table with their purposes; none where the contract has no such columns.
fn named(table: &Table, contract: &Contract) -> impl Iterator<Item = (String, String)> {
    let of = |is: fn(Holds) -> bool| {
        let required = contract.fields.iter().find(|required| is(required.shape.holds))?;
        table.columns.iter().find(|column| column.name == required.name)
    };
    let names = of(|holds| matches!(holds, Holds::Name(_)));
    let columns = names.zip(of(|holds| holds == Holds::Word(Use::WORDS)));
    columns.into_iter().flat_map(|(names, uses)| texts(table, names).zip(texts(table, uses)))
}

/// The rows of a table that are marked as documentation, by name.
pub fn for_people(table: &Table, contract: &Contract) -> Vec<String> {
    let documentation = named(table, contract).filter(|(_, stated)| stated == Use::Documentation.word());
    documentation.map(|(name, _)| name).collect()
}
