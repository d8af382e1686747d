//! Laws that hold for every table and every part, tried on random ones.
//!
//! - An index finds what a scan of the rows finds.
//! - A part file is read or refused with places inside it; nothing makes the reader panic.
//! - A part that can be read can be planned: every hole has a route whose steps follow from one another,
//!   with tools of the catalogs and loads the machine bears, or an error that says why not.
//! - A plan survives JSON and YAML.

#![allow(clippy::unwrap_used, clippy::panic, reason = "clippy allows it in tests, but not in the functions they share")]

mod common;

use std::collections::BTreeMap;

use common::lawful::lawful;
use common::spoilt::{read_or_refused, spoilt};
use common::{KNOWLEDGE, planned, read};
use proptest::prelude::*;
use technolog::knowledge::load::table_from_text;
use technolog::knowledge::table::Cell;
use technolog::knowledge::{ColumnType, Input, Table};
use technolog::plan::{CuttingMethod, Plan};
use technolog::units::{Decimal, ItGrade, Micrometres, Unit};

// ---------------------------------------------------------------------------------------------------
// An index finds what a scan finds.

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
    #![proptest_config(ProptestConfig { cases: 96, ..ProptestConfig::default() })]

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

// ---------------------------------------------------------------------------------------------------
// Parts.

/// A group of holes as it stands in a part file, without its points.
fn group() -> impl Strategy<Value = String> {
    let size = prop_oneof![
        (3_i64..=80).prop_map(|mm| mm * 1000),
        (6_i64..=160).prop_map(|half| half * 500),
        (30_i64..=800).prop_map(|tenth| tenth * 100),
        (3_000_i64..=80_000),
    ];
    let depth = prop_oneof![Just(None), (100_i64..=39_999).prop_map(Some), (1_i64..=39).prop_map(|mm| Some(mm * 1000))];
    let roughness = prop::sample::select(vec![
        "Ra 25", "Ra 12.5", "Rz 80", "Ra 6.3", "Rz 40", "Ra 3.2", "Rz 20", "Ra 2.5", "Ra 1.25", "Ra 0.63", "Ra 0.1",
    ]);
    let centres = prop::sample::select(vec![
        "0.01", "0.05", "0.051", "0.1", "0.3", "0.301", "0.46", "1", "10", "IT5", "IT7", "IT9", "IT12", "IT14",
    ]);
    let extras = prop::sample::select(vec!["", "", "", ", chamfer: 1", ", skin: true", ", chamfer: 2.5, skin: true"]);
    (size, 7_u8..=14, depth, roughness, centres, extras).prop_map(|(size, grade, depth, roughness, centres, extras)| {
        let depth = depth.map_or("through: true".to_owned(), |depth| format!("depth: {}", Micrometres::new(depth)));
        format!(
            "diameter: {}H{grade}, {depth}, roughness: {roughness}, centre_tolerance: {centres}{extras}",
            Micrometres::new(size)
        )
    })
}

/// A valid part file: up to five groups on a grid of 100 mm, so that even Ø80 keeps apart.
fn part_files() -> impl Strategy<Value = String> {
    let grid: Vec<(i64, i64)> = (-4..=4).flat_map(|x| (-1..=1).map(move |y| (x * 100, y * 100))).collect();
    let materials: Vec<String> =
        KNOWLEDGE.table("materials").unwrap().all_rows().map(|row| row.text("id").unwrap().to_owned()).collect();
    let heads = prop::sample::select(vec![
        "",
        "entry: rough\n",
        "position_tolerance: 0.04\nmass: 30\n",
        "mass: 900\nfixture: {height: 60, clamps: [{at: [-450, -180]}, {at: [450, 180], screw: M24}]}\n",
        "fixture: {clamps: [{at: [0, 190], screw: M6}]}\n",
    ]);
    let groups = prop::collection::vec((group(), 1_usize..=5), 1..=5);
    (prop::sample::select(materials), heads, groups, Just(grid).prop_shuffle()).prop_map(
        |(material, head, groups, points)| {
            let mut text = format!(
                "part: P\nmaterial: {material}\nmachine: gf2171\n{head}\
                 blank: {{kind: plate, length: 1000, width: 400, thickness: 40}}\nholes:\n"
            );
            let mut points = points.into_iter();
            for (number, (group, count)) in groups.into_iter().enumerate() {
                let at: Vec<String> = points.by_ref().take(count).map(|(x, y)| format!("[{x}, {y}]")).collect();
                text.push_str(&format!("  - {{name: H{number}, {group}, at: [{}]}}\n", at.join(", ")));
            }
            text
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn every_part_that_can_be_read_can_be_planned(text in part_files()) {
        let part = read(&text);
        for method in [CuttingMethod::Formula, CuttingMethod::Card] {
            let plan = planned(&part, method);
            lawful(&part, &plan).map_err(|error| TestCaseError::fail(format!("{error}\n{text}")))?;
            prop_assert_eq!(&planned(&part, method), &plan, "the same part, another plan");
        }
    }

    #[test]
    fn a_hole_ends_inside_deviations_on_one_side_of_its_nominal(
        size in 4_i64..=40, lower in 1_i64..300, width in 60_i64..400, below in any::<bool>()
    ) {
        let (upper, lower) = if below { (-lower, -lower - width) } else { (lower + width, lower) };
        let (upper, lower) = (Micrometres::new(upper), Micrometres::new(lower));
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\n\
             blank: {{kind: plate, length: 100, width: 100, thickness: 20}}\nholes:\n  \
             - {{name: A, diameter: {{nominal: {size}, upper: {upper}, lower: {lower}}}, through: true, \
             roughness: Ra 12.5, centre_tolerance: 0.46, at: [[0, 0]]}}\n"
        );
        let part = read(&text);
        lawful(&part, &planned(&part, CuttingMethod::Formula))?;
    }

    #[test]
    fn a_plan_survives_json_and_yaml(text in part_files()) {
        let plan = planned(&read(&text), CuttingMethod::Formula);
        let json = serde_json::to_string(&plan).unwrap();
        prop_assert_eq!(&serde_json::from_str::<Plan>(&json).unwrap(), &plan);
        let yaml = serde_yaml::to_string(&plan).unwrap();
        prop_assert_eq!(&serde_yaml::from_str::<Plan>(&yaml).unwrap(), &plan);
    }
}

// ---------------------------------------------------------------------------------------------------
// Spoilt part files.

/// Something to put into a part file where it does not belong.
fn litter() -> impl Strategy<Value = String> {
    let known = vec![
        "",
        "-",
        "-1",
        "0",
        "1e9",
        "99999999999",
        ".5",
        ",",
        ":",
        ": ",
        "\n",
        "\t",
        "  ",
        "- ",
        "[",
        "]",
        "{",
        "}",
        "#",
        "'",
        "\"",
        "&a ",
        "*a",
        "!!str ",
        "---\n",
        "null",
        "true",
        "Ø",
        "Н",
        "IT",
        "mm",
        "\u{feff}",
        "\r",
        "\u{0}",
        "%",
        "|",
        ">",
        "? ",
        "at: ",
        "name: A",
        "holes: []\n",
    ];
    prop_oneof![4 => prop::sample::select(known).prop_map(str::to_owned), 1 => any::<char>().prop_map(String::from)]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, ..ProptestConfig::default() })]

    #[test]
    fn a_spoilt_part_file_is_read_or_refused_with_places_inside_it(text in spoilt(part_files(), litter())) {
        if let Some(part) = read_or_refused(&text)? {
            planned(&part, CuttingMethod::Formula);
        }
    }
}
