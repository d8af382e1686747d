//! What is written is read back by others: XML by a parser of XML, a workbook by a reader of workbooks.

#![allow(clippy::unwrap_used, clippy::panic, reason = "clippy allows it in tests, but not in the functions they share")]

use std::io::{Cursor, Read};

use calamine::{Data, Reader, Xlsx};
use technolog_document::{Block, Column, Document, Drawing, Field, FindingBlock, Inlines, Severity, Table, Words};
use technolog_office::{docx, xlsx};

const WORDS: Words<'_> = Words { left_out: "left out", see_all: "", help: "help", figure: "drawing" };

fn page() -> Document {
    let mut page = Document::new("uk", "Плита & <B>");
    page.push(Block::Fields(vec![Field::new("Матеріал", "Сталь 45")]));
    page.heading(2, "Різальний інструмент T1/T2");
    let mut table = Table::new([Column::text("T"), Column::number("Ø", "мм"), Column::number("S", "мм/об")]);
    table.row(["T1".into(), Inlines::number("29,3"), Inlines::number("0,250")]);
    table.row(["T2".into(), Inlines::number("−102,4"), Inlines::from("9/11")]);
    table.row(["007".into(), Inlines::default().quantity("0,46", "мм"), Inlines::default()]);
    table.notes.push("* припущено".into());
    page.push(table);
    page.heading(2, "Різальний інструмент T1/T2");
    let mut wide = Table::new((0..30).map(|at| Column::text(format!("стовпець{at}"))));
    wide.row((0..30).map(|at| format!("клітинка{at}")));
    page.push(wide);
    let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"50\"><polyline points=\"1,1 9,9\" \
               fill=\"none\" stroke=\"#333\" stroke-width=\"1\"/><text x=\"5\" y=\"9\" font-size=\"12\">Ø10</text></svg>";
    page.push(Drawing {
        svg: svg.into(), caption: "Рисунок".into(), alternative: "лінія \"&\" текст".into()
    });
    let finding = FindingBlock::new(Severity::Error, "помилка", "не вистачає <сили>");
    page.push(FindingBlock { details: vec!["чому".into()], help: Some("як".into()), ..finding });
    page.push(Block::Code("N5 G0\nN10 M2\n".into()));
    page
}

fn parts(file: &[u8]) -> Vec<(String, Vec<u8>)> {
    let mut package = zip::ZipArchive::new(Cursor::new(file)).unwrap();
    (0..package.len())
        .map(|at| {
            let mut part = package.by_index(at).unwrap();
            let mut bytes = Vec::new();
            part.read_to_end(&mut bytes).unwrap();
            (part.name().unwrap().into_owned(), bytes)
        })
        .collect()
}

fn is_well_formed(xml: &str) {
    let mut reader = quick_xml::Reader::from_str(xml);
    reader.config_mut().check_end_names = true;
    loop {
        match reader.read_event() {
            Ok(quick_xml::events::Event::Eof) => return,
            Ok(_) => {}
            Err(error) => panic!("{error} at {} of {xml}", reader.error_position()),
        }
    }
}

#[test]
fn a_word_file_is_a_package_of_well_formed_parts() {
    let file = docx(&page(), &WORDS).unwrap();
    assert_eq!(file, docx(&page(), &WORDS).unwrap(), "the same page is the same file");
    let parts = parts(&file);
    let text = |name: &str| {
        let (_, bytes) = parts.iter().find(|(own, _)| own == name).unwrap_or_else(|| panic!("no {name}"));
        String::from_utf8(bytes.clone()).unwrap()
    };
    for (name, bytes) in parts.iter().filter(|(name, _)| !name.ends_with(".emf")) {
        is_well_formed(std::str::from_utf8(bytes).unwrap_or_else(|_| panic!("{name}")));
    }
    let document = text("word/document.xml");
    // Tables with heads that repeat, the wide one on a page across and its heading with it.
    assert_eq!((document.matches("<w:tbl>").count(), document.matches("<w:tblHeader/>").count()), (2, 2));
    let (before, across) = document.split_once("</w:sectPr>").unwrap();
    assert!(!before.contains("landscape") && before.ends_with("w:gutter=\"0\"/>"));
    assert!(across.find("T1/T2").unwrap() < across.find("стовпець29").unwrap());
    assert!(across.contains("w:orient=\"landscape\""));
    // Every part that is referred to is there.
    for target in text("word/_rels/document.xml.rels").split("Target=\"").skip(1) {
        text_is_there(&parts, &format!("word/{}", target.split('"').next().unwrap()));
    }
    assert!(document.contains("descr=\"лінія &quot;&amp;&quot; текст\""), "a drawing says what it shows");
    assert!(text("word/styles.xml").contains("<w:lang w:val=\"uk\"/>"));
}

fn text_is_there(parts: &[(String, Vec<u8>)], name: &str) {
    assert!(parts.iter().any(|(own, bytes)| own == name && !bytes.is_empty()), "no {name}");
}

#[test]
fn a_workbook_has_its_figures_as_numbers() {
    let file = xlsx(&page(), &WORDS).unwrap();
    assert_eq!(file, xlsx(&page(), &WORDS).unwrap(), "the same page is the same file");
    let mut book: Xlsx<_> = Xlsx::new(Cursor::new(file)).unwrap();
    let names = book.sheet_names().clone();
    assert_eq!(names, ["Плита & <B>", "Різальний інструмент T1 T2", "Різальний інструмент T1 T2 (2)"]);
    let tools = book.worksheet_range(&names[1]).unwrap();
    let cell = |row: u32, column: u32| tools.get_value((row, column)).cloned().unwrap_or(Data::Empty);
    assert_eq!(cell(0, 1), Data::String("Ø, мм".into()));
    assert_eq!((cell(1, 1), cell(1, 2)), (Data::Float(29.3), Data::Float(0.25)));
    assert_eq!((cell(2, 1), cell(2, 2)), (Data::Float(-102.4), Data::String("9/11".into())));
    // A name of digits stays a name; a figure with its unit is a figure.
    assert_eq!((cell(3, 0), cell(3, 1)), (Data::String("007".into()), Data::Float(0.46)));
    assert_eq!(cell(5, 0), Data::String("* припущено".into()));
    // What is no table stands in front, so that no finding is lost.
    let front = book.worksheet_range(&names[0]).unwrap();
    let lines: Vec<String> = front.rows().map(|row| row[0].to_string()).collect();
    for said in ["Матеріал: Сталь 45", "помилка: не вистачає <сили>", "чому", "help: як", "N10 M2"]
    {
        assert!(lines.iter().any(|line| line == said), "{said} in {lines:?}");
    }
    for name in &names {
        assert!(book.worksheet_formula(name).unwrap().is_empty(), "no formulas");
    }
}

/// A figure that nothing confirms is a number like the others; its format shows the mark.
#[test]
fn a_marked_figure_is_a_number() {
    let mut page = Document::new("uk", "Плита");
    let mut table = Table::new([Column::text("Позначення"), Column::number("Тпз", "хв")]);
    table.row(["191113040*", "28,29*"]);
    page.push(table);
    let mut book: Xlsx<_> = Xlsx::new(Cursor::new(xlsx(&page, &WORDS).unwrap())).unwrap();
    let name = book.sheet_names()[1].clone();
    let cells = book.worksheet_range(&name).unwrap();
    assert_eq!(cells.get_value((1, 0)), Some(&Data::String("191113040*".into())), "a designation");
    assert_eq!(cells.get_value((1, 1)), Some(&Data::Float(28.29)));
}
