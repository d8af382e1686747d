//! What rows say of themselves, `reason` and `unconfirmed`, is there in every language.

use std::collections::BTreeSet;

use technolog::words::{LANGUAGES, Lang};
use technolog_testing::KNOWLEDGE;

fn of_rows() -> BTreeSet<&'static str> {
    // What planning says of a cutter that no row has (crates/holes/src/tooling/cutter.rs).
    let ours = "the catalogs have no cutter of this size; it must be ground to order";
    let rows = KNOWLEDGE.tables().flat_map(|table| &table.rows);
    rows.flat_map(|row| [&row.reason, &row.unconfirmed]).flatten().map(String::as_str).chain([ours]).collect()
}

/// Names of sources, of people, of standards and of figures, which no language translates.
const NAMES: &[&str] = &[
    "LinuxCNC",
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
    "HSMWorks",
    "Pramet",
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
        places.iter().map(|place| Lang::UK.place(place)).filter(|said| !english(said).is_empty()).collect();
    assert!(lacks.is_empty(), "put their words into places.tsv: {lacks:#?}");
    let left = LANGUAGES
        .iter()
        .flat_map(|language| language.places())
        .filter(|(word, _)| !places.iter().any(|place| place.contains(word)));
    assert_eq!(left.collect::<Vec<_>>(), Vec::<&(&str, &str)>::new(), "no place says so");
    for (place, said) in [
        ("textbook 1.2.1, l. 270-273", "посібник 1.2.1, ряд. 270-273"),
        ("facts 1.6 (Косилова/Мещеряков т.2 table 25; QT)", "довідка 1.6 (Косилова/Мещеряков т.2 табл. 25; QT)"),
        (
            "MT: github sad-engineer/machine_tools @fd8ea5b, tables_csv/a.csv",
            "MT: github sad-engineer/machine_tools @fd8ea5b, tables_csv/a.csv",
        ),
    ] {
        assert_eq!(Lang::UK.place(place), said);
        assert_eq!(Lang::EN.place(place), place);
    }
}

#[test]
fn every_remark_of_a_row_is_translated_and_no_translation_is_left_over() {
    let said = of_rows();
    assert!(said.len() > 600, "only {} remarks were found", said.len());
    for language in LANGUAGES.iter().filter(|language| !language.remarks().is_empty()) {
        let known: BTreeSet<&str> = language.remarks().keys().copied().collect();
        let lacks: Vec<_> = said.difference(&known).collect();
        assert!(lacks.is_empty(), "put into remarks.tsv of {}: {lacks:#?}", language.tag());
        let left: Vec<_> = known.difference(&said).collect();
        assert!(left.is_empty(), "no row says so any more, in remarks.tsv of {}: {left:#?}", language.tag());
    }
}
