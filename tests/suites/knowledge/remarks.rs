//! What tables say in sentences is there in every language, and so is every word of their enums.

use std::collections::BTreeSet;

use technolog::knowledge::table::Cell;
use technolog::knowledge::{Column, ColumnRole, ColumnType, Table};
use technolog::words::{LANGUAGES, Lang};
use technolog_testing::KNOWLEDGE;

/// Everything that tables say in sentences: of their rows, of what no row answers, of themselves, and in cells.
fn of_tables() -> BTreeSet<&'static str> {
    // What planning says of a cutter that no row has (crates/holes/src/tooling/cutter.rs).
    let ours = "the catalogs have no cutter of this size; it must be ground to order";
    let rows = KNOWLEDGE.tables().flat_map(|table| table.all_rows());
    let of_rows = rows.flat_map(|row| {
        let row = row.row();
        let corrections = row.corrections.iter().map(|correction| correction.reason.as_str());
        [&row.reason, &row.unconfirmed, &row.note].into_iter().flatten().map(String::as_str).chain(corrections)
    });
    let gaps = KNOWLEDGE.tables().flat_map(|table| table.uncovered.iter().map(|gap| gap.reason.as_str()));
    let notes = KNOWLEDGE.tables().flat_map(|table| table.notes.iter().map(String::as_str));
    of_rows.chain(gaps).chain(notes).chain(cells()).chain([ours]).collect()
}

/// Columns of words that people read and no table lists: single words count there too.
const SPOKEN: &[(&str, &str)] =
    &[("materials", "delivery_state"), ("machine-ir500pmf4", "text"), ("drill-force-formula", "used")];

/// Whether a word of a text may be an English one.
fn is_english(word: &str) -> bool {
    let word = word.trim_matches(|sign: char| sign.is_ascii_punctuation());
    word.len() > 1 && word.bytes().all(|byte| byte.is_ascii_lowercase() || byte == b'\'')
}

/// Columns of addresses, values and few words, of which a single one counts.
const WORDED: &[&str] = &["page", "text"];

/// The sentences in cells: texts of two English words or more, in columns that are of no one language; of pages, and of
/// what machines and controls have besides figures, those with a word between the names.
fn cells() -> impl Iterator<Item = &'static str> {
    let of_table = |table: &'static Table| {
        let sentences = |column: &Column| {
            let is_named = column.name.ends_with("_uk") || column.name.ends_with("_en");
            column.ty == ColumnType::Text && !is_named
        };
        let columns: Vec<usize> = (0..table.columns.len()).filter(|&at| sentences(&table.columns[at])).collect();
        let cells =
            table.rows.iter().flat_map(move |row| columns.clone().into_iter().map(move |at| (at, &row.cells[at])));
        cells.filter_map(move |(at, cell)| match cell {
            Cell::Value(value) => {
                let (text, column) = (value.as_text()?, table.columns[at].name.as_str());
                let worded = WORDED.contains(&column) && text.split_whitespace().any(is_english);
                Some((worded || SPOKEN.contains(&(table.id.as_str(), column)), text))
            }
            _ => None,
        })
    };
    let is_sentence = |text: &str| {
        let words: Vec<&str> = text.split_whitespace().collect();
        words.windows(2).any(|pair| pair[0].len() > 2 && pair.iter().all(|word| is_english(word)))
    };
    let of_all = KNOWLEDGE.tables().flat_map(of_table);
    of_all.filter(move |(is_spoken, text)| *is_spoken || is_sentence(text)).map(|(_, text)| text)
}

/// Names of sources, of people, of standards and of figures, which no language translates.
const NAMES: &[&str] = &[
    "LinuxCNC",
    "Handbook",
    "Fanuc",
    "Series",
    "MD",
    "Sinumerik",
    "NC",
    "CYCLE",
    "Codes",
    "Code",
    "Lathe",
    "Overview",
    "ISO",
    "DIN",
    "AISI",
    "GOST",
    "Sumitomo",
    "WIDIA",
    "MGEHR",
    "MGMN",
    "SER",
    "SNR",
    "ER",
    "IR",
    "TurningCalc",
    "FrezDBZ",
    "NPT",
    "HSS",
    "Kg",
    "Kis",
    "Kiv",
    "Kls",
    "Klv",
    "Kmp",
    "Kmv",
    "Kpv",
    "Cr",
    "Interp",
    "milltask",
    "github",
    "Autodesk",
    "Dormer",
    "Haas",
    "Ingersoll",
    "Iscar",
    "Kennametal",
    "Kyocera",
    "Mitsubishi",
    "Sandvik",
    "Coromant",
    "Dormer",
    "Robur",
    "HSMWorks",
    "Boothroyd",
    "Dewhurst",
    "Knight",
    "Pramet",
    "Somta",
    "Tormach",
    "Widia",
    // Before an address.
    "http",
    "https",
];

/// The words of a text that some language has, but this one not: Latin ones of some length that are no part of an address.
fn english(text: &str) -> Vec<String> {
    let parts = text.split([' ', '(', ')', ',', ';', ':', '`']);
    let words = parts.filter(|part| !part.contains(['/', '_', '@', '.', '-', '~']));
    let latin = words.filter(|word| word.len() > 2 && word.bytes().all(|byte| byte.is_ascii_alphabetic()));
    latin
        .filter(|word| !NAMES.contains(word) && word.bytes().any(|byte| byte.is_ascii_lowercase()))
        .map(str::to_owned)
        .collect()
}

#[test]
fn every_place_of_a_row_is_told_in_ukrainian() {
    let tables: Vec<_> = KNOWLEDGE.tables().collect();
    let rows = tables.iter().flat_map(|table| table.rows.iter().filter_map(|row| row.place.as_deref()));
    let places: BTreeSet<&str> = rows.chain(tables.iter().map(|table| table.place.as_str())).collect();
    assert!(places.len() > 500, "only {} places were found", places.len());
    let lacks: Vec<_> =
        places.iter().map(|place| Lang::UK.place(place)).filter(|text| !english(text).is_empty()).collect();
    assert!(lacks.is_empty(), "put their words into places.tsv: {lacks:#?}");
    let left = LANGUAGES
        .iter()
        .flat_map(|language| language.places())
        .filter(|(word, _)| !places.iter().any(|place| place.contains(word)));
    assert_eq!(left.collect::<Vec<_>>(), Vec::<&(&str, &str)>::new(), "no place says so");
    for (place, translated) in [
        ("textbook 1.2.1, l. 270-273", "посібник 1.2.1, ряд. 270–273"),
        ("facts 1.6 (Косилова/Мещеряков т.2 table 25; QT)", "довідка 1.6 (Косилова/Мещеряков т.2 табл. 25; QT)"),
        (
            "MT: github sad-engineer/machine_tools @fd8ea5b, tables_csv/a.csv",
            "MT: github sad-engineer/machine_tools @fd8ea5b, tables_csv/a.csv",
        ),
    ] {
        assert_eq!(Lang::UK.place(place), translated);
        assert_eq!(Lang::EN.place(place), place);
    }
}

#[test]
fn everything_that_tables_say_is_translated_and_no_translation_is_left_over() {
    let remarks = of_tables();
    assert!(remarks.len() > 1_500, "only {} remarks were found", remarks.len());
    for language in LANGUAGES.iter().filter(|language| !language.remarks().is_empty()) {
        let known: BTreeSet<&str> = language.remarks().keys().copied().collect();
        let lacks: Vec<_> = remarks.difference(&known).collect();
        assert!(lacks.is_empty(), "put into remarks.tsv of {}: {lacks:#?}", language.tag());
        let left: Vec<_> = known.difference(&remarks).collect();
        assert!(left.is_empty(), "no row says so any more, in remarks.tsv of {}: {left:#?}", language.tag());
    }
}

/// Every word of an enum has a name in every language, except for designations, figures and ids, which have one name
/// everywhere.
#[test]
fn every_word_of_an_enum_has_a_name() {
    let ids: BTreeSet<&str> = KNOWLEDGE.tables().map(|table| table.id.as_str()).collect();
    let materials = KNOWLEDGE.tables().find(|table| table.id == "materials").unwrap();
    let grades: BTreeSet<&str> = materials.rows.iter().filter_map(|row| text(&row.cells[0])).collect();
    let mut lacks = BTreeSet::new();
    for (table, column) in KNOWLEDGE.tables().flat_map(|table| table.columns.iter().map(move |column| (table, column)))
    {
        for word in column.values.iter().filter(|_| column.ty == ColumnType::Enum) {
            let is_designation = !word.bytes().all(|byte| byte.is_ascii_lowercase() || b"-_".contains(&byte));
            let named = |key: String| Lang::UK.find(&key).is_some() && Lang::EN.find(&key).is_some();
            let is_named = column.name_of(word, "uk").is_some()
                || named(format!("table-value-{}-{word}", column.name))
                || named(format!("table-value-{word}"))
                || named(format!("quantity-{word}"))
                || named(format!("operation-{word}"));
            if !is_designation && !is_named && !ids.contains(word.as_str()) && !grades.contains(word.as_str()) {
                lacks.insert(format!("{}: {} = {word}", table.id, column.name));
            }
        }
    }
    assert!(lacks.is_empty(), "name them in page-values.ftl: {lacks:#?}");
}

/// Every input of a decision table has a name for people, its table's or one that languages have for such columns: reasons
/// say by which of them a row was rejected.
#[test]
fn every_input_has_a_name() {
    let mut lacks = BTreeSet::new();
    for (table, column) in KNOWLEDGE.tables().flat_map(|table| table.columns.iter().map(move |column| (table, column)))
    {
        let key = format!("table-column-{}", column.name);
        let is_input = column.role == ColumnRole::Input;
        if is_input && column.label.is_none() && (Lang::UK.find(&key).is_none() || Lang::EN.find(&key).is_none()) {
            lacks.insert(format!("{}: {}", table.id, column.name));
        }
    }
    assert!(lacks.is_empty(), "give them a `label`: {lacks:#?}");
}

fn text(cell: &Cell) -> Option<&str> {
    match cell {
        Cell::Value(value) => value.as_text(),
        _ => None,
    }
}
