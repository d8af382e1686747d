//! A law of every decision table, tried on random ones: an index finds what a scan of the rows finds.

use std::collections::BTreeMap;

use proptest::prelude::*;
use technolog::knowledge::load::table_from_text;
use technolog::knowledge::table::Cell;
use technolog::knowledge::{ColumnType, Input, Table};
use technolog::units::{Decimal, ItGrade, Micrometres, Unit};

/// The types a random column may have, each with how it stands in a table file.
const COLUMNS: [(ColumnType, &str); 5] = [
    (ColumnType::Int, "type: int"),
    (ColumnType::Length, "type: length, unit: mm"),
    (ColumnType::Number, "type: number, unit: kW"),
    (ColumnType::It, "type: it"),
    (ColumnType::Enum, "type: enum, values: [v1, v2, v3, v4, v5, v6]"),
];

/// A value of a random column: 1 to 18, or the enum's values.
fn shown(ty: ColumnType, value: i64) -> String {
    if ty == ColumnType::Enum { format!("v{}", (value - 1) % 6 + 1) } else { value.to_string() }
}

/// A test of a cell over the values 1 to 18.
fn test(ty: ColumnType) -> BoxedStrategy<String> {
    let value = move || (1_i64..=18).prop_map(move |value| shown(ty, value));
    let plain = prop_oneof![Just("-".to_owned()), value()];
    let simple = if ty == ColumnType::Enum {
        plain.boxed()
    } else {
        let ends = (1_i64..=15, 2_i64..4, any::<bool>(), any::<bool>());
        let interval = ends.prop_map(|(low, width, open, closed)| {
            let (start, end) = (if open { '(' } else { '[' }, if closed { ']' } else { ')' });
            format!("{start}{low}..{}{end}", low + width)
        });
        let bound = (prop::sample::select(vec!["<=", "<", ">=", ">"]), value());
        prop_oneof![plain, interval, bound.prop_map(|(sign, value)| format!("{sign} {value}"))].boxed()
    };
    let several = prop::collection::vec(simple, 1..4).prop_map(|tests| tests.join(" | "));
    prop_oneof![3 => several.clone(), 1 => several.prop_map(|tests| format!("not({tests})"))].boxed()
}

/// A decision table of two or three inputs, and questions to it.
fn tables() -> impl Strategy<Value = (Vec<ColumnType>, String, Vec<Vec<i64>>)> {
    prop::collection::vec(0..COLUMNS.len(), 2..=3).prop_flat_map(|picked| {
        let types: Vec<ColumnType> = picked.iter().map(|&index| COLUMNS[index].0).collect();
        let row = types.iter().map(|&ty| test(ty)).collect::<Vec<_>>();
        let rows = prop::collection::vec(row, 0..140);
        let questions = prop::collection::vec(prop::collection::vec(1_i64..=18, types.len()), 1..12);
        (Just(picked), rows, questions).prop_map(move |(picked, rows, questions)| {
            let mut text =
                String::from("table: t\ntitle: {uk: т, en: t}\nkind: decision\nhit: collect\nplace: here\ncolumns:\n");
            for (number, index) in picked.iter().enumerate() {
                text.push_str(&format!("  - {{name: c{number}, {}, role: input}}\n", COLUMNS[*index].1));
            }
            text.push_str("  - {name: out, type: int, role: output}\n");
            text.push_str(if rows.is_empty() { "rows: []\n" } else { "rows:\n" });
            for (number, tests) in rows.iter().enumerate() {
                let cells = tests.iter().enumerate().map(|(column, test)| format!("c{column}: \"{test}\", "));
                text.push_str(&format!("  - {{{}out: {number}, source: seed}}\n", cells.collect::<String>()));
            }
            (picked.iter().map(|&index| COLUMNS[index].0).collect(), text, questions)
        })
    })
}

/// A value as the query takes it, and as the sets of the cells rank it.
fn input(ty: ColumnType, value: i64, text: &str) -> (Input<'_>, i64) {
    match ty {
        ColumnType::Int => (Input::Int(value), value),
        ColumnType::Length => (Input::Length(Micrometres::from_mm(value)), value * 1000),
        ColumnType::Number => (Input::Number(Decimal::from_int(value), Unit::Kilowatt), value * 1_000_000),
        ColumnType::It => (Input::Grade(ItGrade::new(u8::try_from(value).unwrap()).unwrap()), value),
        _ => (Input::Text(text), (value - 1) % 6),
    }
}

/// The first column whose set does not hold the value, or nothing when the row matches.
fn scan(table: &Table, row: usize, ranks: &[i64]) -> Option<String> {
    let tests = table.inputs().zip(ranks);
    let failing = tests.into_iter().find(|((index, _), rank)| match &table.rows[row].cells[*index] {
        Cell::Test(set, _) => !set.contains(**rank),
        _ => false,
    });
    failing.map(|((_, column), _)| column.name.clone())
}

proptest! {
    #![proptest_config(technolog_laws::cases!(96))]

    #[test]
    fn an_index_finds_what_a_scan_finds((types, text, questions) in tables()) {
        let table = table_from_text("t.yaml", &text).unwrap_or_else(|problems| panic!("{problems:?}\n{text}"));
        for question in questions {
            let texts: Vec<String> = types.iter().zip(&question).map(|(&ty, &value)| shown(ty, value)).collect();
            let names: Vec<String> = (0..types.len()).map(|column| format!("c{column}")).collect();
            let (mut inputs, mut ranks) = (Vec::new(), Vec::new());
            for (column, &ty) in types.iter().enumerate() {
                let (value, rank) = input(ty, question[column], &texts[column]);
                inputs.push((names[column].as_str(), value));
                ranks.push(rank);
            }
            let answer = table.decide(&inputs).unwrap();
            let scanned: Vec<Option<String>> = (0..table.rows.len()).map(|row| scan(&table, row, &ranks)).collect();

            let winners: Vec<usize> = answer.winners().map(|row| row.index).collect();
            let matching: Vec<usize> = (0..scanned.len()).filter(|&row| scanned[row].is_none()).collect();
            prop_assert_eq!(winners, matching);
            let rejected: Vec<(usize, &str)> =
                answer.rejected().map(|(row, column)| (row.index, column.name.as_str())).collect();
            let once: BTreeMap<usize, &str> = rejected.iter().copied().collect();
            prop_assert_eq!(once.len(), rejected.len(), "a row is rejected twice");
            let failing: BTreeMap<usize, &str> =
                scanned.iter().enumerate().filter_map(|(row, why)| Some((row, why.as_deref()?))).collect();
            prop_assert_eq!(once, failing);
        }
    }
}
