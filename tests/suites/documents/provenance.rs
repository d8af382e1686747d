//! `docs/provenance.md` gives for every table the number of rows and their origin. These tests compare the page with
//! the shipped tables.
//!
//! A line of counts is in back quotes: `A.11 · rows 135 · seed 130 · standard 5 · reconstructed 0 · unconfirmed 0 ·
//! corrected 0`. A line that begins with a folder (`catalogs/tools/`), with `catalogs/*` (only the files of that
//! folder) or with `all` is a sum, and gives its number of tables first. The section of a table extends from its line
//! of counts to the next one, and names every figure that the source prints wrongly.
//!
//! `PROVENANCE=write cargo test --test documents provenance::` writes the right counts into the page.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use technolog::knowledge::units::Roughness;
use technolog::knowledge::{Knowledge, Source, Table};
use technolog::shipped;
use technolog::units::Decimal;
use technolog_testing::number;

/// What the first word after a name's `·` can be; no other text in back quotes has it.
const FIRST: [&str; 2] = [" · rows ", " · tables "];

/// What a choice of ours is counted as; a line without one has no such word.
const CHOICES: &str = "choices";

fn page() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/provenance.md")
}

fn knowledge() -> Knowledge {
    Knowledge::from_sources(shipped::SOURCES).unwrap()
}

/// The counts of some tables, as the page writes them.
fn counts<'t>(tables: impl Iterator<Item = &'t Table>) -> String {
    let mut sums =
        ["rows", "seed", "standard", "reconstructed", "unconfirmed", "corrected", CHOICES].map(|name| (name, 0_usize));
    for row in tables.flat_map(|table| &table.rows) {
        let of = |source: Source| usize::from(row.source == source);
        let adds = [
            1,
            of(Source::Seed),
            of(Source::Standard),
            of(Source::Reconstructed),
            usize::from(row.unconfirmed.is_some() && !row.is_choice),
            usize::from(!row.corrections.is_empty()),
            usize::from(row.is_choice),
        ];
        for ((_, sum), add) in sums.iter_mut().zip(adds) {
            *sum += add;
        }
    }
    // Few tables have choices.
    let told = sums.iter().filter(|(name, sum)| *name != CHOICES || *sum > 0);
    told.map(|(name, sum)| format!(" · {name} {sum}")).collect()
}

/// The right line of counts of a name, if it names a table, a folder or all of them.
fn right(name: &str, knowledge: &Knowledge) -> Option<String> {
    if let Ok(table) = knowledge.table(name) {
        return Some(format!("{name}{}", counts(std::iter::once(table))));
    }
    let inside = |table: &&Table| match name.strip_suffix('*') {
        Some(folder) => table.file.strip_prefix(folder).is_some_and(|file| !file.contains('/')),
        None => name == "all" || (name.ends_with('/') && table.file.starts_with(name)),
    };
    let number = knowledge.tables().filter(inside).count();
    (number > 0).then(|| format!("{name} · tables {number}{}", counts(knowledge.tables().filter(inside))))
}

/// Every line of counts: its name, the line itself, and the text from it to the next one.
fn entries(page: &str) -> Vec<(&str, &str, &str)> {
    let quoted: Vec<(usize, &str)> = page
        .split('`')
        .enumerate()
        .scan(0, |at, (index, part)| {
            let start = *at;
            *at += part.len() + 1;
            Some((index, start, part))
        })
        .filter(|(index, _, part)| index % 2 == 1 && FIRST.iter().any(|first| part.contains(first)))
        .map(|(_, start, part)| (start, part))
        .collect();
    let ends = quoted.iter().skip(1).map(|(start, _)| *start).chain([page.len()]);
    quoted
        .iter()
        .zip(ends)
        .map(|(&(start, line), end)| {
            (line.split(" · ").next().unwrap_or_default(), line, &page[start + line.len()..end])
        })
        .collect()
}

#[test]
fn the_page_counts_every_table_and_counts_it_right() {
    let knowledge = knowledge();
    let mut text = fs::read_to_string(page()).unwrap();
    let mut wrong = Vec::new();
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let mut replaced: Vec<(String, String)> = Vec::new();
    for (name, line, _) in entries(&text) {
        *seen.entry(name.to_owned()).or_default() += 1;
        match right(name, &knowledge) {
            Some(right) if right == line => {}
            Some(right) => {
                wrong.push(format!("is   {line}\nmust {right}"));
                replaced.push((format!("`{line}`"), format!("`{right}`")));
            }
            None => wrong.push(format!("`{name}` is no table and no folder of tables")),
        }
    }
    for (name, times) in seen.iter().filter(|(_, times)| **times > 1) {
        wrong.push(format!("`{name}` is counted {times} times"));
    }
    for table in knowledge.tables().filter(|table| !seen.contains_key(&table.id)) {
        let right = right(&table.id, &knowledge).unwrap_or_default();
        wrong.push(format!("{} is not on the page; give it a section with\n`{right}`", table.file));
    }
    if std::env::var("PROVENANCE").is_ok_and(|value| value == "write") {
        for (line, right) in &replaced {
            text = text.replace(line, right);
        }
        fs::write(page(), &text).unwrap();
        wrong.retain(|problem| !problem.starts_with("is   "));
    }
    let help = "`PROVENANCE=write cargo test --test documents provenance::` corrects the counts";
    assert!(wrong.is_empty(), "docs/provenance.md:\n{}\n{help}", wrong.join("\n"));
}

#[test]
fn every_wrongly_printed_figure_is_named_in_the_section_of_its_table() {
    let knowledge = knowledge();
    let text = fs::read_to_string(page()).unwrap();
    let mut missing = Vec::new();
    for (name, _, section) in entries(&text) {
        let Ok(table) = knowledge.table(name) else { continue };
        // A long text may be broken over lines.
        let section = section.split_whitespace().collect::<Vec<_>>().join(" ");
        for (index, row) in table.rows.iter().enumerate() {
            for slip in &row.corrections {
                let note = format!("{name}, row {}, {}: printed as `{}`", index + 1, slip.column, slip.printed);
                if !section.contains(&slip.printed) {
                    missing.push(note);
                }
            }
        }
    }
    assert!(missing.is_empty(), "docs/provenance.md does not name these slips:\n{}", missing.join("\n"));
}

/// The code orders roughness by the pairs of the table `ra-rz`; it must not drift from it.
#[test]
fn the_roughness_pairs_of_the_code_are_those_of_the_table() {
    let knowledge = knowledge();
    let table = knowledge.table("ra-rz").unwrap();
    assert!(!table.rows.is_empty());
    for row in table.all_rows() {
        let rz = Decimal::from_f64_rounded(number(row, "rz"));
        let by_code: Roughness = format!("Rz {rz}").parse().unwrap();
        let by_table = number(row, "ra_preferred");
        assert!(
            (by_code.ra_um() - by_table).abs() < 1e-9,
            "Rz {rz}: {} in the code, {by_table} in the table",
            by_code.ra_um()
        );
    }
}
