//! Two independent readings of the source tables, held against each other cell by cell.
//!
//! The first reading is the shipped catalogs; the second is `tests/readings/*.csv`, made from the same
//! sources by somebody who had only the column names. Where they differ, one of them is wrong or the
//! source leaves a choice: every such cell stands in `tests/readings/settled.yaml` with the reading that
//! was taken and why. A difference that is not listed fails, and so does a listed one that is gone.
//!
//! Catalogs are paired by their key columns and compared cell by cell. Decision tables are compared by
//! what they say: every input is cut at the ends of every test of both readings, and for each
//! combination of the elementary intervals the rows that match must have the same outputs, however the
//! rows are written. Texts that the second reading leaves empty, and prose, are not compared.

#![allow(clippy::unwrap_used, reason = "clippy allows it in tests, but not in the functions they share")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use technolog::knowledge::cell::parse_test;
use technolog::knowledge::set::Set;
use technolog::knowledge::table::{Cell, Kind};
use technolog::knowledge::{Column, ColumnType, HitPolicy, Knowledge, Role, Table, Value};
use technolog::shipped;

/// The column of a difference that is a whole row, which one reading has and the other has not.
const WHOLE_ROW: &str = "(row)";

/// Where the two readings differ.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
struct Difference {
    table: String,
    row: String,
    column: String,
    first: String,
    second: String,
}

/// A line of `settled.yaml`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Settled {
    table: String,
    row: String,
    column: String,
    first: String,
    second: String,
    taken: Taken,
    because: String,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Taken {
    First,
    Second,
}

/// One reading of a table: rows of cells in the order of the table's columns.
type Rows = Vec<Vec<Cell>>;

/// What comparing one table came to.
struct Comparison<'t> {
    table: &'t Table,
    /// The columns that both readings have.
    shared: BTreeSet<usize>,
    cells: usize,
    differences: BTreeSet<Difference>,
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/readings")
}

#[test]
fn the_two_readings_agree_but_for_what_is_settled() {
    let knowledge = Knowledge::from_sources(shipped::SOURCES).unwrap();
    let mut differences = BTreeSet::new();
    for path in second_readings() {
        let table = knowledge.table(path.file_stem().unwrap().to_str().unwrap()).unwrap();
        let comparison = compare(table, &path);
        println!("{}: {} cells, {} differ", table.id, comparison.cells, comparison.differences.len());
        differences.extend(comparison.differences);
    }

    let text = fs::read_to_string(folder().join("settled.yaml")).unwrap();
    let settled: Vec<Settled> = serde_yaml::from_str(&text).unwrap();
    let mut listed = BTreeSet::new();
    for line in settled {
        assert!(!line.because.is_empty(), "{} {}: settled without a reason", line.table, line.row);
        let Settled { table, row, column, first, second, .. } = line;
        let difference = Difference { table, row, column, first, second };
        assert!(listed.insert(difference.clone()), "listed twice: {difference:?}");
    }
    let shown = |differences: BTreeSet<&Difference>| -> String { differences.iter().map(|d| in_yaml(d)).collect() };
    let unlisted = shown(differences.difference(&listed).collect());
    let gone = shown(listed.difference(&differences).collect());
    assert!(unlisted.is_empty(), "differences that settled.yaml does not list:\n{unlisted}");
    assert!(gone.is_empty(), "settled.yaml lists differences that no longer exist:\n{gone}");
}

/// The CSV files, by name.
fn second_readings() -> Vec<PathBuf> {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "csv"));
    paths.sort();
    paths
}

/// A difference as a line of `settled.yaml`.
fn in_yaml(difference: &Difference) -> String {
    let Difference { table, row, column, first, second } = difference;
    format!("- {{table: {table:?}, row: {row:?}, column: {column:?}, first: {first:?}, second: {second:?}}}\n")
}

fn compare<'t>(table: &'t Table, path: &Path) -> Comparison<'t> {
    let (shared, second) = read_second(table, path);
    let first: Rows = table.rows.iter().map(|row| row.cells.clone()).collect();
    let mut comparison = Comparison { table, shared, cells: 0, differences: BTreeSet::new() };
    match table.kind {
        Kind::Catalog => comparison.catalog(&first, &second),
        Kind::Decision => comparison.decision(&first, &second),
    }
    comparison
}

/// Reads the second reading as cells of the table's columns, and which columns can be compared.
fn read_second(table: &Table, path: &Path) -> (BTreeSet<usize>, Rows) {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let heads: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let mut rows: Rows = Vec::new();
    for record in reader.records() {
        let record = record.unwrap();
        let line = record.position().unwrap().line();
        // A test that is left out matches anything; any other cell is then empty.
        let mut cells: Vec<Cell> = table.columns.iter().map(|column| read_cell(column, "").unwrap()).collect();
        for (head, text) in heads.iter().zip(&record).filter(|(head, _)| *head != "doubt") {
            let at = || format!("{}:{line}: column `{head}`", path.display());
            let index = table.column_index(head).ok_or_else(|| format!("{}: no such column", at())).unwrap();
            cells[index] =
                read_cell(&table.columns[index], text).map_err(|problem| format!("{}: {problem}", at())).unwrap();
        }
        rows.push(cells);
    }
    let shared = heads
        .iter()
        .filter_map(|head| table.column_index(head))
        .filter(|&index| {
            let column = &table.columns[index];
            let prose = column.name.ends_with("_uk") || column.name.ends_with("_en");
            let left_empty = column.ty == ColumnType::Text && rows.iter().all(|row| row[index] == Cell::Empty);
            !prose && !left_empty
        })
        .collect();
    (shared, rows)
}

/// A cell of the second reading. The items of a list stand between spaces.
fn read_cell(column: &Column, text: &str) -> Result<Cell, String> {
    let text = text.trim();
    if column.role == Role::Input {
        let text = if text.is_empty() { "-" } else { text };
        return parse_test(text, column).map(|set| Cell::Test(set, text.to_owned())).map_err(|error| error.message);
    }
    if text.is_empty() {
        return Ok(Cell::Empty);
    }
    let value = if column.list {
        Value::List(text.split_whitespace().map(|item| column.parse_value(item)).collect::<Result<_, _>>()?)
    } else {
        column.parse_value(text)?
    };
    Ok(Cell::Value(value))
}

/// A cell as `settled.yaml` has it.
fn show(cell: &Cell) -> String {
    match cell {
        Cell::Empty => String::new(),
        Cell::Value(value) => value.to_string(),
        Cell::Test(_, text) => text.clone(),
    }
}

impl Comparison<'_> {
    fn differ(&mut self, row: &str, column: &str, first: &str, second: &str) {
        self.differences.insert(Difference {
            table: self.table.id.clone(),
            row: row.to_owned(),
            column: column.to_owned(),
            first: first.to_owned(),
            second: second.to_owned(),
        });
    }

    /// Pairs rows by the key columns and compares every shared cell.
    fn catalog(&mut self, first: &Rows, second: &Rows) {
        let key: Vec<usize> = self.table.key.iter().map(|name| self.table.column_index(name).unwrap()).collect();
        let fields: Vec<usize> = self.shared.iter().copied().filter(|index| !key.contains(index)).collect();
        let by_key = |rows: &Rows, reading: &str| {
            let mut by_key: BTreeMap<String, Vec<Cell>> = BTreeMap::new();
            for cells in rows {
                let name = key.iter().map(|&index| show(&cells[index])).collect::<Vec<_>>().join("; ");
                let before = by_key.insert(name.clone(), cells.clone());
                assert!(before.is_none(), "{}: two rows `{name}` in the {reading} reading", self.table.id);
            }
            by_key
        };
        let (first, second) = (by_key(first, "first"), by_key(second, "second"));
        for name in first.keys().chain(second.keys()).collect::<BTreeSet<_>>() {
            match (first.get(name), second.get(name)) {
                (Some(first), Some(second)) => {
                    for &index in &fields {
                        self.cells += 1;
                        if first[index] != second[index] {
                            let column = &self.table.columns[index].name;
                            self.differ(name, column, &show(&first[index]), &show(&second[index]));
                        }
                    }
                }
                (Some(_), None) => self.differ(name, WHOLE_ROW, "there", ""),
                (None, _) => self.differ(name, WHOLE_ROW, "", "there"),
            }
        }
    }

    /// Compares what both readings answer to every elementary combination of inputs.
    fn decision(&mut self, first: &Rows, second: &Rows) {
        assert_eq!(self.table.hit, HitPolicy::Unique, "{}: only rows that exclude each other", self.table.id);
        let inputs: Vec<(usize, &Column)> = self.table.inputs().collect();
        let axes: Vec<Vec<(i64, i64)>> = inputs
            .iter()
            .map(|&(index, column)| elementary(&column.allowed(), first.iter().chain(second).map(|row| &row[index])))
            .collect();
        // The regions where the same rows stand against each other, as one set per input.
        let mut regions: BTreeMap<(Vec<usize>, Vec<usize>), Vec<Set>> = BTreeMap::new();
        let mut place = vec![0; axes.len()];
        loop {
            let at: Vec<(i64, i64)> = axes.iter().zip(&place).map(|(axis, &step)| axis[step]).collect();
            let matching = |rows: &Rows| -> Vec<usize> {
                let matches = |row: &Vec<Cell>| {
                    inputs.iter().zip(&at).all(|(&(index, _), &(rank, _))| match &row[index] {
                        Cell::Test(set, _) => set.contains(rank),
                        _ => true,
                    })
                };
                (0..rows.len()).filter(|&row| matches(&rows[row])).collect()
            };
            let region =
                regions.entry((matching(first), matching(second))).or_insert_with(|| vec![Set::empty(); axes.len()]);
            for (set, &(low, high)) in region.iter_mut().zip(&at) {
                *set = set.union(&Set::interval(low, high));
            }
            if !advance(&mut place, &axes) {
                break;
            }
        }

        let outputs: Vec<usize> =
            self.shared.iter().copied().filter(|index| self.table.columns[*index].role == Role::Output).collect();
        for ((in_first, in_second), region) in regions {
            let name = show_region(&inputs, &region);
            match (in_first.is_empty(), in_second.is_empty()) {
                (true, true) => {}
                (false, true) => self.differ(&name, WHOLE_ROW, "there", ""),
                (true, false) => self.differ(&name, WHOLE_ROW, "", "there"),
                (false, false) => {
                    for &index in &outputs {
                        self.cells += 1;
                        let answers = |rows: &Rows, matching: &[usize]| -> BTreeSet<String> {
                            matching.iter().map(|&row| show(&rows[row][index])).collect()
                        };
                        let (first, second) = (answers(first, &in_first), answers(second, &in_second));
                        if first != second {
                            let joined =
                                |answers: BTreeSet<String>| answers.into_iter().collect::<Vec<_>>().join(" or ");
                            self.differ(
                                &name,
                                &self.table.columns[index].name.clone(),
                                &joined(first),
                                &joined(second),
                            );
                        }
                    }
                }
            }
        }
    }
}

/// The allowed ranks of an input, cut at the ends of every test.
fn elementary<'c>(allowed: &Set, tests: impl Iterator<Item = &'c Cell>) -> Vec<(i64, i64)> {
    let mut starts = BTreeSet::new();
    for test in tests {
        if let Cell::Test(set, _) = test {
            for &(low, high) in set.intervals() {
                starts.extend([Some(low), high.checked_add(1)].into_iter().flatten());
            }
        }
    }
    let mut parts = Vec::new();
    for &(low, high) in allowed.intervals() {
        starts.insert(low);
        let inside: Vec<i64> = starts.range(low..=high).copied().collect();
        let ends = inside.iter().skip(1).map(|next| next - 1).chain([high]);
        parts.extend(inside.iter().copied().zip(ends));
    }
    parts
}

/// The next combination of steps, one per axis; false after the last.
fn advance(place: &mut [usize], axes: &[Vec<(i64, i64)>]) -> bool {
    for (step, axis) in place.iter_mut().zip(axes).rev() {
        *step += 1;
        if *step < axis.len() {
            return true;
        }
        *step = 0;
    }
    false
}

/// A region as tests of the inputs that it limits.
fn show_region(inputs: &[(usize, &Column)], region: &[Set]) -> String {
    let limits = inputs.iter().zip(region).filter(|((_, column), set)| **set != column.allowed());
    limits
        .map(|((_, column), set)| format!("{}: {}", column.name, show_set(column, set)))
        .collect::<Vec<_>>()
        .join("; ")
}

fn show_set(column: &Column, set: &Set) -> String {
    if matches!(column.ty, ColumnType::Enum | ColumnType::Bool) {
        let members = set.intervals().iter().flat_map(|&(low, high)| low..=high);
        return members.map(|rank| column.show_rank(rank)).collect::<Vec<_>>().join(" | ");
    }
    // An end is open when the number next to it is the shorter one: (15..30], not [15.001..30].
    let end = |rank: i64, next: i64, open: char, closed: char| {
        let (shown, next) = (column.show_rank(rank), column.show_rank(next));
        if next.len() < shown.len() { (next, open) } else { (shown, closed) }
    };
    let interval = |&(low, high): &(i64, i64)| {
        if low == high {
            return column.show_rank(low);
        }
        let (low, opening) = if low == i64::MIN { (String::new(), '(') } else { end(low, low - 1, '(', '[') };
        let (high, closing) = if high == i64::MAX { (String::new(), ')') } else { end(high, high + 1, ')', ']') };
        format!("{opening}{low}..{high}{closing}")
    };
    set.intervals().iter().map(interval).collect::<Vec<_>>().join(" | ")
}
