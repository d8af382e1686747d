//! A page with every kind of block is set, with the same bytes each time. The file is kept where `PAGES` says.
#![cfg(feature = "typeset")]
#![allow(clippy::unwrap_used, reason = "a test")]

use technolog_document::{
    Block, CellKind, Column, Document, Drawing, Field, FindingBlock, Form, FormCell, FormRow, Inlines, Item, Severity,
    Table, Words,
};

const WORDS: Words<'_> =
    Words { left_out: "без граф", see_all: "", help: "порада", figure: "рисунок" };

fn form() -> Form {
    let cell = |kind, width, words: &str| FormCell::new(kind, width, words);
    let row = |lines, cells| FormRow { lines, cells };
    let mut rows = vec![
        row(1, vec![cell(CellKind::Gap, 79, ""), cell(CellKind::Value, 31, "")]),
        row(
            1,
            vec![
                cell(CellKind::Name, 9, "Розроб."),
                cell(CellKind::Value, 95, "Ґ. Їжак").over(2),
                cell(CellKind::Value, 6, "28.11.2026"),
            ],
        ),
        row(1, vec![cell(CellKind::Name, 9, "Перев."), cell(CellKind::Value, 6, "")]),
    ];
    for number in 1..=18 {
        let cells = vec![
            cell(CellKind::Line, 5, &format!("О{number:02}")),
            cell(CellKind::Line, 89, "Свердлити 6 отв. Ø10H12"),
            cell(CellKind::Line, 16, "0,25"),
        ];
        rows.push(row(2, cells));
    }
    rows.push(row(2, vec![cell(CellKind::Name, 9, "МК"), cell(CellKind::Name, 101, "Маршрутна карта")]));
    Form { mark: "ГОСТ 3.1118-82  форма 1".to_owned(), rows }
}

fn page() -> Document {
    let mut page = Document::new("uk", "Звіт: плита «А\" \\ #x $y_z$ *");
    page.heading(2, "1. Мета");
    page.paragraph(
        Inlines::from("Подача ")
            .quantity("0,25", "мм/об")
            .text(", блок ")
            .code("N30 G0 X-200")
            .text("; ")
            .strong("важливо")
            .text(". ".repeat(3) + &"Слово за словом. ".repeat(30)),
    );
    page.push(Block::List(vec![Item::from("перше"), Item { words: "друге".into(), items: vec!["усередині".into()] }]));
    page.push(Block::Fields(vec![Field::new("Матеріал", "Сталь 45")]));
    let mut table = Table::new([Column::text("Назва"), Column::number("Ø", "мм"), Column::text("Блок")]);
    for number in 0..60 {
        table.row([
            Inlines::from("свердло 035-2300-1273"),
            Inlines::number(format!("{number},5")),
            Inlines::default().code("N30 G0 G54 X-200 Y-100 LF"),
        ]);
    }
    table.notes.push("Під таблицею.".into());
    page.push(table);
    page.push(FindingBlock {
        help: Some("коротше".into()),
        details: vec!["бо".into()],
        ..FindingBlock::new(Severity::Error, "неможливо", "завдовге свердло")
    });
    let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"720\" height=\"300\" viewBox=\"0 0 720 300\"><circle cx=\"99\" cy=\"99\" r=\"50\" fill=\"none\" stroke=\"#333\"/><text x=\"20\" y=\"40\" font-family=\"sans-serif\">Ø10 отвір</text></svg>";
    page.push(Drawing { svg: svg.to_owned(), caption: "Отвір".into(), alternative: "Отвір".to_owned() });
    page.push(Block::Code("N5 G90\nN10 M30".to_owned()));
    page.push(form());
    page.paragraph("Після форми.");
    page
}

#[test]
fn every_kind_of_block_is_set_with_the_same_bytes_each_time() {
    let once = technolog_pdf::pdf(&page(), &WORDS).unwrap();
    assert!(once.starts_with(b"%PDF-"));
    assert!(once == technolog_pdf::pdf(&page(), &WORDS).unwrap());
    if let Ok(file) = std::env::var("PAGES") {
        std::fs::write(file, once).unwrap();
    }
}
