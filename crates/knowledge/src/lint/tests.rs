//! Every check on a small sound knowledge base with one fault at a time.

use super::lint;
use crate::knowledge::{Knowledge, SourceFile};

const RULE: &str = r#"table: rule
title: {uk: п, en: r}
kind: decision
hit: unique
place: test
columns:
  - {name: diameter, type: length, unit: mm, role: input, domain: "(0..100]"}
  - {name: through, type: bool, role: input}
  - {name: scheme, type: text, role: output, refers: {table: schemes, column: scheme}}
uncovered:
  - {when: {diameter: "> 50", through: "false"}, reason: the source has no row}
rows:
  - {diameter: "<= 10", scheme: "01", source: seed}
  - {diameter: "(10..50]", through: "true", scheme: "02", source: seed}
  - {diameter: "(10..50]", through: "false", scheme: "03", source: seed}
  - {diameter: "> 50", through: "true", scheme: "03", source: seed}
"#;

const CASES: &str = r#"table: rule
tests:
  - {given: {diameter: 10, through: "true"}, expect: {scheme: "01"}, because: test}
  - {given: {diameter: 60, through: "false"}, expect: none, because: test}
"#;

const SCHEMES: &str = r#"table: schemes
title: {uk: с, en: s}
kind: catalog
place: test
key: [scheme]
columns:
  - {name: scheme, type: text}
  - {name: tools, type: int}
  - {name: transitions, type: text, list: true}
laws:
  - {law: count, column: tools, of: transitions}
rows:
  - {scheme: "01", tools: 1, transitions: [drill], source: seed}
  - {scheme: "02", tools: 2, transitions: [drill, ream], source: seed}
  - {scheme: "03", tools: 2, transitions: [drill, bore], source: seed}
"#;

const DRILLS: &str = r#"table: drills
title: {uk: с, en: d}
kind: catalog
place: test
key: [designation]
tool: {operations: [drill], shank: morse, material: HSS}
columns:
  - {name: designation, type: text}
  - {name: diameter, type: length, unit: mm}
  - {name: length, type: length, unit: mm}
  - {name: projection, type: length, unit: mm}
  - {name: morse, type: int}
laws:
  - {law: rising, column: length, over: diameter}
  - {law: less, column: projection, than: length}
  - {law: morse, length: length, projection: projection, shank: tang_length}
rows:
  - {designation: a, diameter: 6, length: 140, projection: 78, morse: 1, source: seed}
  - {designation: b, diameter: 8, length: 155, projection: 93, morse: 1, source: seed}
"#;

const TAPERS: &str = r#"table: morse-tapers
title: {uk: к, en: t}
kind: catalog
place: test
key: [morse]
columns:
  - {name: morse, type: int}
  - {name: tang_length, type: length, unit: mm}
rows:
  - {morse: 1, tang_length: 62, source: standard}
"#;

/// Codes and lines of the findings when one text is replaced in one of the files.
fn found(file: &str, from: &str, to: &str) -> Vec<(&'static str, u32)> {
    let files = [
        ("rules/rule.yaml", RULE),
        ("rules/rule.test.yaml", CASES),
        ("catalogs/schemes.yaml", SCHEMES),
        ("catalogs/drills.yaml", DRILLS),
        ("catalogs/tapers.yaml", TAPERS),
    ];
    let spoilt: Vec<(&str, String)> = files
        .iter()
        .map(|&(path, text)| {
            let text = if path == file { text.replacen(from, to, 1) } else { text.to_owned() };
            (path, text)
        })
        .collect();
    assert!(from.is_empty() || spoilt.iter().any(|(path, text)| *path == file && text.contains(to)), "{from}");
    let sources: Vec<SourceFile<'_>> = spoilt.iter().map(|(path, text)| SourceFile { path, text }).collect();
    let (knowledge, problems) = Knowledge::read_sources(&sources);
    problems
        .iter()
        .chain(&lint(&knowledge))
        .map(|finding| (finding.code, finding.place.as_ref().map_or(0, |place| place.line)))
        .collect()
}

#[test]
fn a_sound_base_has_no_findings() {
    assert_eq!(found("", "", ""), []);
}

/// A row that does not load takes its table away, and what names the table is left without it.
const UNREAD: &[(&str, u32)] = &[("bad-value", 13), ("dangling-reference", 0)];

#[test]
fn every_planted_defect_is_found_at_its_line() {
    let rule = "rules/rule.yaml";
    for (file, from, to, expected) in [
        // A widened row overlaps its neighbour, and the gap that it covers is no gap any more.
        (rule, "\"<= 10\"", "\"<= 12\"", &[("overlap", 14), ("overlap", 15)][..]),
        // A removed row leaves a gap.
        (rule, "  - {diameter: \"> 50\", through: \"true\", scheme: \"03\", source: seed}\n", "", &[("gap", 13)]),
        (rule, "\"<= 10\"", "\"<= 9\"", &[("failed-example", 3), ("gap", 13)]),
        // A typo in a cell.
        (rule, "(10..50]", "(10..5O]", &[("bad-test", 14), ("dangling-reference", 0)]),
        // A scheme that is not there.
        (rule, "scheme: \"02\"", "scheme: \"20\"", &[("dangling-reference", 14)]),
        // A declaration wider than its gap.
        (
            rule,
            "diameter: \"> 50\", through: \"false\"}",
            "diameter: \"> 40\", through: \"false\"}",
            &[("wide-gap", 11)],
        ),
        (
            rule,
            "diameter: \"> 50\", through: \"false\"}",
            "diameter: \"> 100\", through: \"false\"}",
            &[("wide-gap", 11), ("gap", 13)],
        ),
        // The same row twice.
        (
            rule,
            "  - {diameter: \"<= 10\", scheme: \"01\", source: seed}\n",
            "  - {diameter: \"<= 10\", scheme: \"01\", source: seed}\n  - {diameter: \"<= 10\", scheme: \"01\", source: seed}\n",
            &[("duplicate-row", 14), ("failed-example", 3), ("overlap", 14)],
        ),
        // A row beyond the domain can never win.
        (
            rule,
            "\"> 50\", through: \"true\"",
            "\"(100..120]\", through: \"true\"",
            &[("gap", 13), ("dead-row", 16), ("outside-domain", 16)],
        ),
        // Units, keys, sources.
        (rule, "unit: mm", "unit: kg", &[("wrong-unit", 7), ("dangling-reference", 0)]),
        (
            rule,
            "scheme: \"01\", source",
            "scheme: \"01\", scheme: \"02\", source",
            &[("duplicate-key", 13), ("dangling-reference", 0)],
        ),
        (rule, "scheme: \"01\", source: seed", "scheme: \"01\"", &[("no-source", 13), ("dangling-reference", 0)]),
        // A row that nothing confirms, without its mark.
        (
            rule,
            "scheme: \"01\", source: seed",
            "scheme: \"01\", source: reconstructed, reason: \"memory; nothing at hand confirms it\"",
            &[("no-mark", 13)],
        ),
        (
            rule,
            "scheme: \"01\", source: seed",
            "scheme: \"01\", source: reconstructed, reason: \"nothing at hand confirms it\", unconfirmed: \"memory\"",
            &[],
        ),
        // A figure that somebody looked for is no choice; neither is one of a source, nor one that is unconfirmed as well.
        (
            rule,
            "scheme: \"01\", source: seed",
            "scheme: \"01\", source: reconstructed, reason: \"nothing at hand confirms it\", choice: \"ours\"",
            &[("no-mark", 13)],
        ),
        (
            rule,
            "scheme: \"01\", source: seed",
            "scheme: \"01\", source: reconstructed, reason: \"half is kept free\", choice: \"ours\"",
            &[],
        ),
        (rule, "scheme: \"01\", source: seed", "scheme: \"01\", source: seed, choice: \"ours\"", UNREAD),
        (
            rule,
            "scheme: \"01\", source: seed",
            "scheme: \"01\", source: reconstructed, reason: \"half\", choice: \"ours\", unconfirmed: \"memory\"",
            UNREAD,
        ),
        ("rules/rule.test.yaml", "scheme: \"01\"", "scheme: \"02\"", &[("failed-example", 3)]),
        ("rules/rule.test.yaml", "expect: none", "expect: {scheme: \"03\"}", &[("failed-example", 4)]),
        // Laws.
        (
            "catalogs/schemes.yaml",
            "tools: 2, transitions: [drill, ream]",
            "tools: 3, transitions: [drill, ream]",
            &[("broken-law", 14)],
        ),
        (
            "catalogs/schemes.yaml",
            "{scheme: \"02\"",
            "{scheme: \"03\"",
            &[("dangling-reference", 14), ("duplicate-row", 15)],
        ),
        ("catalogs/drills.yaml", "length: 155, projection: 93", "length: 135, projection: 73", &[("broken-law", 19)]),
        ("catalogs/drills.yaml", "projection: 93", "projection: 91", &[("broken-law", 19)]),
        (
            "catalogs/drills.yaml",
            "name: diameter, type: length, unit: mm",
            "name: diameter, type: length, unit: um",
            &[("broken-law", 18), ("broken-law", 19)],
        ),
        ("catalogs/drills.yaml", "law: rising, column: length", "law: raising, column: length", &[("bad-law", 14)]),
    ] {
        let mut expected = expected.to_vec();
        let mut found = found(file, from, to);
        found.sort_unstable();
        expected.sort_unstable();
        assert_eq!(found, expected, "{from} -> {to}");
    }
}

#[test]
fn partial_overlaps_contradict_under_every_hit_policy() {
    let base = |hit: &str, rows: &str| {
        let text = format!(
            "table: t\ntitle: {{uk: т, en: t}}\nkind: decision\nhit: {hit}\nplace: test\ncolumns:\n  - {{name: a, type: int, role: \
             input, domain: \"[0..9]\"}}\n  - {{name: b, type: int, role: input, domain: \"[0..9]\"}}\n  - {{name: out, type: int, \
             role: output}}\nrows:\n{rows}"
        );
        let sources = [SourceFile { path: "catalogs/t.yaml", text: &text }];
        let (knowledge, problems) = Knowledge::read_sources(&sources);
        assert!(problems.is_empty(), "{problems:?}");
        lint(&knowledge).iter().filter(|finding| finding.code == "overlap").count()
    };
    let row = |a: &str, b: &str, out: u8, more: &str| {
        format!("  - {{a: \"{a}\", b: \"{b}\", out: {out}{more}, source: seed}}\n")
    };
    // Two boxes that cross each other, neither inside the other, saying different things.
    let crossing = |more: [&str; 2]| row("[0..5]", "-", 1, more[0]) + &row("-", "[0..5]", 2, more[1]);
    assert_eq!(base("unique", &crossing(["", ""])), 1);
    assert_eq!(base("any", &crossing(["", ""])), 1);
    assert_eq!(base("first", &crossing(["", ""])), 1);
    assert_eq!(base("priority", &crossing([", priority: 1", ", priority: 1"])), 1);
    assert_eq!(base("priority", &crossing([", priority: 1", ", priority: 2"])), 0);
    assert_eq!(base("collect", &crossing(["", ""])), 0);
    // The same outputs: allowed under `any`, a repeated result under `collect`.
    let same = row("[0..5]", "-", 1, "") + &row("-", "[0..5]", 1, "");
    assert_eq!(base("any", &same), 0);
    assert_eq!(base("collect", &same), 1);
    // An exception before the general row is the purpose of `first`.
    let nested = row("[0..5]", "[0..5]", 1, "") + &row("-", "-", 2, "");
    assert_eq!(base("first", &nested), 0);
}

/// A vocabulary of three words, and tables for two of them: one lacks the third, one covers it partly.
#[test]
fn a_word_that_no_row_names_is_listed_with_every_table_that_it_leaves_a_gap_in() {
    const WORDS: &str = r#"table: groups
title: {uk: г, en: g}
kind: catalog
place: test
key: [word]
columns:
  - {name: word, type: text}
rows:
  - {word: steel, source: seed}
  - {word: iron, source: seed}
  - {word: titanium, source: seed}
"#;
    const HEAD: &str = r#"title: {uk: п, en: r}
kind: decision
place: test
columns:
  - {name: group, type: enum, of: groups, role: input}
  - {name: through, type: bool, role: input}
  - {name: answer, type: int, role: output}
rows:
"#;
    let none = format!("table: none\n{HEAD}  - {{group: steel | iron, answer: 1, source: seed}}\n");
    let part = format!(
        "table: part\n{HEAD}  - {{through: \"true\", answer: 1, source: seed}}\n  \
         - {{group: steel | iron, through: \"false\", answer: 2, source: seed}}\n"
    );
    let whole = format!(
        "table: whole\n{HEAD}  - {{group: not(iron), answer: 1, source: seed}}\n  \
         - {{group: iron, answer: 2, source: seed}}\n"
    );
    let named = format!(
        "table: named\n{HEAD}  - {{group: steel | iron, answer: 1, source: seed}}\n  \
         - {{group: titanium, through: \"true\", answer: 2, source: seed}}\n"
    );
    let files = [
        SourceFile { path: "catalogs/vocabularies/groups.yaml", text: WORDS },
        SourceFile { path: "none.yaml", text: &none },
        SourceFile { path: "part.yaml", text: &part },
        SourceFile { path: "whole.yaml", text: &whole },
        SourceFile { path: "named.yaml", text: &named },
    ];
    let findings = lint(&Knowledge::from_sources(&files).unwrap());
    let of = |code: &str| {
        findings
            .iter()
            .filter(|problem| problem.code == code)
            .map(|it| technolog_words::Lang::EN.say(&it.message))
            .collect::<Vec<_>>()
    };
    assert_eq!(of("word-without-rows"), ["groups: `titanium` has no row of its own and leaves a gap in none, part"]);
    assert_eq!(of("gap").len(), 3);
}
