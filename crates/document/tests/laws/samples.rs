//! Documents to try the writers on: every kind of block, and words that look like marks.

use proptest::prelude::*;
use technolog_document::{
    Align, Block, Column, Document, Drawing, Field, FindingBlock, Inline, Inlines, Item, Keep, Severity, Table,
};

/// What some reader might take for a mark.
const MARKS: [&str; 60] = [
    "1.",
    "1. ",
    "23)",
    "- ",
    "-",
    "+ ",
    "+5",
    "-5",
    "#",
    "# ",
    "* ",
    "*",
    "**",
    "_",
    "__",
    "~",
    "~~~",
    "|",
    "||",
    "\\",
    "\\|",
    "`",
    "``",
    "```",
    "<",
    ">",
    "> ",
    "<b>",
    "</td>",
    "<!--",
    "&",
    "&amp;",
    "&#33;",
    "&lt",
    "$",
    "$$",
    "^",
    "{#a}",
    "[",
    "]",
    "[x](y)",
    "![x](y)",
    "[^1]",
    "[ ] ",
    ": ",
    ":::",
    "---",
    "===",
    "!",
    "\"",
    "'",
    "%",
    "https://a.b/c_d",
    "www.a.b",
    "a@b.c",
    "  ",
    "    ",
    "...",
    "=",
    "\\`",
];

/// Words among which marks stand.
pub fn marked() -> BoxedStrategy<String> {
    let word =
        prop_oneof!["[a-zа-яїґ]{1,5}", "[0-9]{1,3}", Just(" ".to_owned()), Just("2И20-5-80".to_owned()), "[Ø漢é×²]"];
    let piece = prop_oneof![word, proptest::sample::select(MARKS.to_vec()).prop_map(str::to_owned)];
    prop::collection::vec(piece, 0..7).prop_map(|pieces| pieces.concat()).boxed()
}

/// Words of letters only, some longer than a narrow screen is wide.
pub fn plain() -> BoxedStrategy<String> {
    let word = prop_oneof![9 => "[a-zа-яїґ漢é]{1,9}", 1 => "[a-zа-яїґ漢é]{10,30}"];
    prop::collection::vec(word, 1..9).prop_map(|words| words.join(" ")).boxed()
}

pub fn inlines(words: BoxedStrategy<String>) -> BoxedStrategy<Inlines> {
    let piece = prop_oneof![
        4 => words.clone().prop_map(Inline::Text),
        1 => words.clone().prop_map(Inline::Strong),
        1 => words.clone().prop_map(Inline::Code),
        // Units have no spaces.
        1 => words.clone().prop_map(|unit| {
            Inline::Quantity { number: "0,25".to_owned(), unit: unit.replace(' ', ""), value: "0.25".parse().ok() }
        }),
        1 => words.clone().prop_map(|to| Inline::Link { text: to.clone(), to }),
    ];
    prop::collection::vec(piece, 1..4).prop_map(|pieces| pieces.into_iter().collect()).boxed()
}

pub fn document(words: BoxedStrategy<String>) -> impl Strategy<Value = Document> {
    let line = inlines(words.clone());
    let lines = prop::collection::vec(line.clone(), 0..3);
    let leaf = line.clone().prop_map(Item::from);
    let item = (line.clone(), prop::collection::vec(leaf, 0..3)).prop_map(|(words, items)| Item { words, items });
    let field = (words.clone(), line.clone()).prop_map(|(label, value)| Field::new(label, value));
    let finding =
        (words.clone(), prop::option::of(words.clone()), line.clone(), lines.clone(), prop::option::of(line.clone()))
            .prop_map(|(word, place, message, details, help)| {
                let finding = FindingBlock::new(Severity::Wrong, format!("w{word}"), message);
                FindingBlock { place: place.map(|place| format!("p{place}")), details, help, ..finding }
            });
    let block = prop_oneof![
        (2_u8..=6, line.clone()).prop_map(|(level, words)| Block::Heading { level, words }),
        line.clone().prop_filter("no words, no paragraph", read).prop_map(Block::Paragraph),
        prop::collection::vec(item, 1..4).prop_map(Block::List),
        prop::collection::vec(field, 1..4).prop_map(Block::Fields),
        finding.clone().prop_map(Block::Finding),
        finding.prop_map(Block::Finding),
        table(words.clone(), line.clone()).prop_map(Block::Table),
        (words.clone(), line.clone().prop_filter("read", read)).prop_map(|(alternative, caption)| {
            Block::Drawing(Drawing { svg: "<svg/>".to_owned(), alternative: format!("a{alternative}"), caption })
        }),
    ];
    (line, prop::collection::vec(block, 0..6)).prop_map(|(title, blocks)| Document {
        lang: "uk".to_owned(),
        title: Inlines::from("t").append(title),
        blocks,
    })
}

fn read(words: &Inlines) -> bool {
    !words.plain().trim().is_empty()
}

fn table(words: BoxedStrategy<String>, line: BoxedStrategy<Inlines>) -> impl Strategy<Value = Table> {
    (1_usize..6).prop_flat_map(move |columns| {
        let column = (words.clone(), words.clone(), any::<bool>()).prop_map(|(heading, unit, number)| Column {
            align: if number { Align::Right } else { Align::Left },
            // In letters of their own, which no cell has.
            heading: greek(&heading).into(),
            unit: greek(&unit),
            keep: Keep::Always,
            min_width: 6,
        });
        let columns_of = prop::collection::vec(column, columns);
        let rows = prop::collection::vec(prop::collection::vec(line.clone(), columns), 0..4);
        let note = line.clone().prop_filter("read", read);
        (columns_of, rows, prop::collection::vec(note, 0..2)).prop_map(|(columns, rows, notes)| {
            let mut table = Table::new(columns);
            rows.into_iter().for_each(|row| table.row(row));
            table.notes = notes;
            table
        })
    })
}

fn greek(text: &str) -> String {
    let letter = |sign: char| if sign.is_alphabetic() { 'ω' } else { sign };
    text.chars().map(letter).collect()
}
