//! What rows say of themselves, `reason` and `unconfirmed`, is there in every language.

use std::collections::BTreeSet;

use technolog::words::LANGUAGES;
use technolog_testing::KNOWLEDGE;

fn of_rows() -> BTreeSet<&'static str> {
    // What planning says of a cutter that no row has (crates/holes/src/tooling/cutter.rs).
    let ours = "the catalogs have no cutter of this size; it must be ground to order";
    let rows = KNOWLEDGE.tables().flat_map(|table| &table.rows);
    rows.flat_map(|row| [&row.reason, &row.unconfirmed]).flatten().map(String::as_str).chain([ours]).collect()
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
