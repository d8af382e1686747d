//! Two independent readings of the source tables, compared with each other cell by cell.
//!
//! The first reading is the shipped catalogs; the second is `tests/readings/*.csv`, made from the same
//! sources by somebody else, with the columns named alike and one more for `doubt`. Where they differ, one
//! is wrong or the source leaves a choice: every such cell stands in `tests/readings/settled.yaml` with the
//! reading that was taken and why. A difference that is not listed fails, and so does a listed one that is
//! gone.
//!
//! Catalogs are paired by their key columns and compared cell by cell. Decision tables are compared by
//! what they say: every input is cut at the ends of every test of both readings, and for each
//! combination of the elementary intervals the rows that match must have the same outputs, however the
//! rows are cut and the tests written. Prose is not compared, nor a text that the second reading left out.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use technolog::knowledge::cell::parse_test;
use technolog::knowledge::load::table_from_text;
use technolog::knowledge::set::Set;
use technolog::knowledge::table::{Cell, TableKind};
use technolog::knowledge::{Column, ColumnRole, ColumnType, HitPolicy, Knowledge, Table, Value};
use technolog::shipped;

/// The column that stands for a whole row, which one reading has and the other has not.
const WHOLE_ROW: &str = "(row)";

/// One reading of a table: rows of cells in the order of the table's columns.
type Rows = Vec<Vec<Cell>>;

/// What the two readings have in one place.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Pair {
    table: String,
    row: String,
    column: String,
    first: String,
    second: String,
}

impl Pair {
    fn differs(&self) -> bool {
        self.first != self.second
    }
}

/// A line of `settled.yaml`.
#[derive(Clone, Debug, Deserialize)]
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
    /// The catalog stands; the difference remains.
    First,
    /// The catalog held what `first` says and was corrected; both readings now say `second`.
    Second,
}

#[test]
fn the_two_readings_agree_but_for_what_is_settled() {
    let knowledge = Knowledge::from_sources(shipped::SOURCES).unwrap();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/readings");
    let mut pairs = BTreeSet::new();
    for path in csv_files(&folder) {
        let table = knowledge.table(path.file_stem().unwrap().to_str().unwrap()).unwrap();
        let compared = compare(table, &read_second(table, File::open(&path).unwrap()));
        let differing = compared.iter().filter(|pair| pair.differs()).count();
        println!("{}: {} cells compared, {differing} differ", table.id, compared.len());
        pairs.extend(compared);
    }
    let settled = fs::read_to_string(folder.join("settled.yaml")).unwrap();
    let faults = unsettled(&pairs, &serde_yaml::from_str::<Vec<Settled>>(&settled).unwrap());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

fn csv_files(folder: &Path) -> Vec<PathBuf> {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "csv"));
    paths.sort();
    paths
}

/// Every difference that is not listed, and every line of the list that does not hold (any more).
fn unsettled(pairs: &BTreeSet<Pair>, settled: &[Settled]) -> Vec<String> {
    let mut open: BTreeSet<&Pair> = pairs.iter().filter(|pair| pair.differs()).collect();
    let mut faults = Vec::new();
    for line in settled {
        let Settled { table, row, column, first, second, taken, because } = line.clone();
        let listed = Pair { table, row, column, first, second };
        let holds = match taken {
            Taken::First => open.remove(&listed),
            Taken::Second => pairs.contains(&Pair { first: listed.second.clone(), ..listed.clone() }),
        };
        if !holds {
            faults.push(format!("settled.yaml lists what is no longer so: {}", in_yaml(&listed)));
        }
        if because.is_empty() {
            faults.push(format!("settled.yaml gives no reason: {}", in_yaml(&listed)));
        }
    }
    faults.extend(open.into_iter().map(|pair| format!("settled.yaml does not list: {}", in_yaml(pair))));
    faults
}

/// A difference as the beginning of a line of `settled.yaml`.
fn in_yaml(pair: &Pair) -> String {
    let Pair { table, row, column, first, second } = pair;
    format!("{{table: {table:?}, row: {row:?}, column: {column:?}, first: {first:?}, second: {second:?}, ...")
}

/// The second reading as cells of the table's columns.
struct Second {
    /// The columns that it has.
    columns: BTreeSet<usize>,
    rows: Rows,
}

fn read_second(table: &Table, csv: impl Read) -> Second {
    let mut reader = csv::Reader::from_reader(csv);
    let heads: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let columns: Vec<Option<usize>> = heads.iter().map(|head| table.column_index(head)).collect();
    for (head, column) in heads.iter().zip(&columns) {
        assert!(column.is_some() || head == "doubt", "{}: no column `{head}`", table.id);
    }
    let mut rows: Rows = Vec::new();
    for record in reader.records() {
        let record = record.unwrap();
        let mut cells: Vec<Cell> = table.columns.iter().map(|column| read_cell(column, "").unwrap()).collect();
        for (&index, text) in columns.iter().zip(&record).filter_map(|(index, text)| Some((index.as_ref()?, text))) {
            let column = &table.columns[index];
            cells[index] = read_cell(column, text)
                .map_err(|problem| format!("{}: {record:?}: column `{}`: {problem}", table.id, column.name))
                .unwrap();
        }
        rows.push(cells);
    }
    Second { columns: columns.into_iter().flatten().collect(), rows }
}

/// A cell of the second reading. The items of a list stand between spaces; a test that is left out
/// matches anything, any other cell is then empty.
fn read_cell(column: &Column, text: &str) -> Result<Cell, technolog::note::Note> {
    let text = text.trim();
    if column.role == ColumnRole::Input {
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

/// Every place that both readings have, with what they have there.
fn compare(table: &Table, second: &Second) -> BTreeSet<Pair> {
    let first: Rows = table.rows.iter().map(|row| row.cells.clone()).collect();
    let mut comparison = Comparison { table, pairs: BTreeSet::new() };
    match table.kind {
        TableKind::Catalog => comparison.catalog(&first, second),
        TableKind::Decision => comparison.decision(&first, second),
    }
    comparison.pairs
}

struct Comparison<'t> {
    table: &'t Table,
    pairs: BTreeSet<Pair>,
}

impl Comparison<'_> {
    fn pair(&mut self, row: &str, column: &str, first: String, second: String) {
        let (table, row, column) = (self.table.id.clone(), row.to_owned(), column.to_owned());
        self.pairs.insert(Pair { table, row, column, first, second });
    }

    fn whole_row(&mut self, row: &str, in_first: bool) {
        let (there, missing) = ("there".to_owned(), "missing".to_owned());
        let (first, second) = if in_first { (there, missing) } else { (missing, there) };
        self.pair(row, WHOLE_ROW, first, second);
    }

    /// Pairs rows by the key columns and compares every other cell that can be.
    fn catalog(&mut self, first: &Rows, second: &Second) {
        let key: Vec<usize> = self.table.key.iter().map(|name| self.table.column_index(name).unwrap()).collect();
        let by_key = |rows: &Rows| {
            let mut named: BTreeMap<String, Vec<Cell>> = BTreeMap::new();
            for cells in rows {
                let name = key.iter().map(|&index| show(&cells[index])).collect::<Vec<_>>().join("; ");
                assert!(named.insert(name.clone(), cells.clone()).is_none(), "{}: two rows {name}", self.table.id);
            }
            named
        };
        let (first, mut second_rows) = (by_key(first), by_key(&second.rows));
        let fields: Vec<usize> = second.columns.iter().copied().filter(|index| !key.contains(index)).collect();
        let mut missing = Vec::new();
        for (name, cells) in &first {
            match second_rows.remove(name) {
                Some(other) => self.cells(name, &fields, cells, &other),
                None => missing.push((name, cells)),
            }
        }
        for (name, cells) in missing {
            // A row that differs in nothing but its key is the same row under another name.
            let same = |other: &Vec<Cell>| fields.iter().all(|&index| cells[index] == other[index]);
            let renamed = second_rows.iter().find(|(_, other)| same(other)).map(|(other_name, _)| other_name.clone());
            match renamed.and_then(|other_name| second_rows.remove(&other_name)) {
                Some(other) => self.cells(name, &[key.as_slice(), fields.as_slice()].concat(), cells, &other),
                None => self.whole_row(name, true),
            }
        }
        for name in second_rows.keys() {
            self.whole_row(name, false);
        }
    }

    /// Compares the cells of a row in those columns.
    fn cells(&mut self, row: &str, columns: &[usize], first: &[Cell], second: &[Cell]) {
        for &index in columns {
            let column = &self.table.columns[index];
            let prose = column.name.ends_with("_uk") || column.name.ends_with("_en");
            let left_out = column.ty == ColumnType::Text && !column.list && second[index] == Cell::Empty;
            if !prose && !left_out {
                let (first, second) = (show(&first[index]), show(&second[index]));
                self.pair(row, &column.name.clone(), first, second);
            }
        }
    }

    /// Compares what both readings answer to every elementary combination of inputs.
    fn decision(&mut self, first: &Rows, second: &Second) {
        assert_eq!(self.table.hit, HitPolicy::Unique, "{}: only for rows that exclude each other", self.table.id);
        let inputs: Vec<(usize, &Column)> = self.table.inputs().collect();
        let outputs: Vec<(usize, &Column)> =
            self.table.outputs().filter(|(index, _)| second.columns.contains(index)).collect();
        let cut = |&(index, column): &(usize, &Column)| {
            elementary(&column.allowed(), first.iter().chain(&second.rows).map(|row| &row[index]))
        };
        let axes: Vec<Vec<(i64, i64)>> = inputs.iter().map(cut).collect();

        // Where the same rows stand against each other, as one set per input.
        let mut regions: BTreeMap<(Vec<usize>, Vec<usize>), Vec<Set>> = BTreeMap::new();
        let mut steps = vec![0; axes.len()];
        loop {
            let at: Vec<(i64, i64)> = axes.iter().zip(&steps).map(|(axis, &step)| axis[step]).collect();
            let matches = |row: &[Cell]| {
                inputs.iter().zip(&at).all(|(&(index, _), &(rank, _))| match &row[index] {
                    Cell::Test(set, _) => set.contains(rank),
                    _ => true,
                })
            };
            let matching = |rows: &Rows| (0..rows.len()).filter(|&row| matches(&rows[row])).collect::<Vec<_>>();
            let against = (matching(first), matching(&second.rows));
            let region = regions.entry(against).or_insert_with(|| vec![Set::empty(); axes.len()]);
            for (set, &(low, high)) in region.iter_mut().zip(&at) {
                *set = set.union(&Set::interval(low, high));
            }
            if !advance(&mut steps, &axes) {
                break;
            }
        }

        for ((in_first, in_second), region) in regions {
            let row = show_region(&inputs, &region);
            match (in_first.is_empty(), in_second.is_empty()) {
                (true, true) => {}
                (false, false) => {
                    for &(index, column) in &outputs {
                        let answers = |rows: &Rows, matching: &[usize]| {
                            let answers: BTreeSet<String> =
                                matching.iter().map(|&row| show(&rows[row][index])).collect();
                            answers.into_iter().collect::<Vec<_>>().join(" or ")
                        };
                        let (first, second) = (answers(first, &in_first), answers(&second.rows, &in_second));
                        self.pair(&row, &column.name, first, second);
                    }
                }
                (only_second, _) => self.whole_row(&row, !only_second),
            }
        }
    }
}

/// A cell in one spelling: numbers without needless zeros, whatever the reading wrote.
fn show(cell: &Cell) -> String {
    match cell {
        Cell::Empty => String::new(),
        Cell::Value(value) => value.to_string(),
        Cell::Test(_, text) => text.clone(),
    }
}

/// The allowed ranks of an input, cut at the ends of every test.
fn elementary<'c>(allowed: &Set, tests: impl Iterator<Item = &'c Cell>) -> Vec<(i64, i64)> {
    let mut starts: BTreeSet<i64> = allowed.intervals().iter().map(|&(low, _)| low).collect();
    for test in tests {
        if let Cell::Test(set, _) = test {
            starts.extend(set.intervals().iter().map(|&(low, _)| low));
            starts.extend(set.intervals().iter().filter_map(|&(_, high)| high.checked_add(1)));
        }
    }
    let mut parts = Vec::new();
    for &(low, high) in allowed.intervals() {
        let inside: Vec<i64> = starts.range(low..=high).copied().collect();
        let ends = inside.iter().skip(1).map(|next| next - 1).chain([high]);
        parts.extend(inside.iter().copied().zip(ends));
    }
    parts
}

/// The next combination of steps, one per axis; false after the last.
fn advance(steps: &mut [usize], axes: &[Vec<(i64, i64)>]) -> bool {
    for (step, axis) in steps.iter_mut().zip(axes).rev() {
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

const CATALOG: &str = "
table: c
title: {uk: к, en: c}
kind: catalog
place: nowhere
key: [code]
columns:
  - {name: code, type: text}
  - {name: diameter, type: length, unit: mm}
  - {name: steps, type: int, list: true, optional: true}
rows:
  - {code: a, diameter: 3.50, steps: [1, 2], source: seed}
  - {code: b, diameter: 4, source: seed}
";

const DECISION: &str = r#"
table: d
title: {uk: р, en: d}
kind: decision
hit: unique
place: nowhere
columns:
  - {name: operation, type: enum, values: [drill, drill-out, ream], role: input}
  - {name: diameter, type: length, unit: mm, role: input, domain: "(0..20]"}
  - {name: life, type: number, unit: min, role: output}
rows:
  - {operation: drill | drill-out, diameter: <= 10, life: 15, source: seed}
  - {operation: drill | drill-out, diameter: "(10..20]", life: 25, source: seed}
"#;

/// The differences of a small table, as column and what each reading has.
fn differences(table: &str, csv: &str) -> Vec<(String, String)> {
    let table = table_from_text("small.yaml", table).unwrap();
    let pairs = compare(&table, &read_second(&table, csv.as_bytes()));
    let differing = pairs.into_iter().filter(Pair::differs);
    differing.map(|pair| (pair.row, format!("{}: {} / {}", pair.column, pair.first, pair.second))).collect()
}

#[test]
fn catalogs_are_paired_by_key_and_compared_by_value() {
    assert!(differences(CATALOG, "code,diameter,steps,doubt\nb,4.0,,\na,3.5,1 2,smudged\n").is_empty());
    for (csv, row, difference) in [
        ("code,diameter,steps\na,3.05,1 2\nb,4,\n", "a", "diameter: 3.5 / 3.05"),
        ("code,diameter,steps\na,3.5,2 1\nb,4,\n", "a", "steps: 1, 2 / 2, 1"),
        ("code,diameter,steps\na,3.5,1 2\nb,4,1\n", "b", "steps:  / 1"),
        ("code,diameter,steps\na,3.5,1 2\n", "b", "(row): there / missing"),
        ("code,diameter,steps\na,3.5,1 2\nb,4,\nc,5,\n", "c", "(row): missing / there"),
        ("code,diameter,steps\na,3.5,1 2\nc,4,\n", "b", "code: b / c"),
    ] {
        assert_eq!(differences(CATALOG, csv), [(row.to_owned(), difference.to_owned())], "{csv}");
    }
}

#[test]
fn decision_tables_are_compared_by_what_they_say() {
    let split = "operation,diameter,life\ndrill,(0..10],15\ndrill-out,[0.001..10],15.0\nnot(ream),> 10,25\n";
    assert!(differences(DECISION, split).is_empty());
    for (csv, row, difference) in [
        (
            "operation,diameter,life\nnot(ream),< 10,15\nnot(ream),>= 10,25\n",
            "operation: drill | drill-out; diameter: 10",
            "life: 15 / 25",
        ),
        (
            "operation,diameter,life\nnot(ream),<= 10,15\ndrill,> 10,25\n",
            "operation: drill-out; diameter: (10..20]",
            "(row): there / missing",
        ),
    ] {
        assert_eq!(differences(DECISION, csv), [(row.to_owned(), difference.to_owned())], "{csv}");
    }
}

#[test]
fn the_list_must_be_complete_and_current() {
    let table = table_from_text("small.yaml", CATALOG).unwrap();
    let pairs = compare(&table, &read_second(&table, "code,diameter\na,3.5\nb,5\n".as_bytes()));
    let line = |row: &str, first: &str, second: &str, taken: Taken| Settled {
        table: "c".to_owned(),
        row: row.to_owned(),
        column: "diameter".to_owned(),
        first: first.to_owned(),
        second: second.to_owned(),
        taken,
        because: "so".to_owned(),
    };
    let listed = line("b", "4", "5", Taken::First);
    assert!(unsettled(&pairs, std::slice::from_ref(&listed)).is_empty());
    assert!(unsettled(&pairs, &[listed.clone(), line("a", "3", "3.5", Taken::Second)]).is_empty());
    for (list, fault) in [
        (vec![], "does not list"),
        (vec![listed.clone(), line("a", "3", "3.5", Taken::First)], "no longer so"),
        (vec![listed.clone(), line("a", "3.5", "3", Taken::Second)], "no longer so"),
        (vec![listed.clone(), listed.clone()], "no longer so"),
        (vec![Settled { because: String::new(), ..listed.clone() }], "no reason"),
    ] {
        let faults = unsettled(&pairs, &list);
        assert!(faults.len() == 1 && faults[0].contains(fault), "{faults:?}");
    }
}
