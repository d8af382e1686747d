use super::*;
use crate::{Column, Drawing, Field, Keep, Severity, Table};

const WORDS: Words =
    Words {
        left_out: "пропущено графи", see_all: "усі показує `--format html`", help: "підказка", figure: "рисунок"
    };

fn tools() -> Table {
    let mut table = Table::new([
        Column::text("T"),
        Column::text("Позначення").min_width(20),
        Column::number("Ø", "мм"),
        Column::text("Для").keep(Keep::Useful),
        Column::number("Виліт", "мм").keep(Keep::Optional),
    ]);
    table.row(["T1", "035-2317-0103", "16", "центрування", "51"]);
    table.row(["T12", "035-2301-1060", "9,5", "розсвердлювання, зенкування", "165"]);
    table.notes.push("Ø - найбільший.".into());
    table
}

fn shown(width: usize, blocks: Vec<Block>) -> String {
    text(&Document { blocks, ..Document::new("uk", "Плита") }, width, false, &WORDS)
}

#[test]
fn a_page_is_sections_with_what_stands_in_them() {
    let mut finding = FindingBlock::new(Severity::Wrong, "хибно", Inlines::from("подача ").code("feed").text(" 0,25"));
    finding.place = Some("13:47".to_owned());
    finding.details = vec!["підстава: таблиця A.6".into()];
    finding.help = Some("взяти 0,325".into());
    let explained = Item { words: "схема 07".into(), items: vec!["не взято: рядки 1-4".into()] };
    let figure = Drawing { svg: String::new(), caption: "Шлях".into(), alternative: "10 точок".to_owned() };
    let blocks = vec![
        Block::Paragraph("Сталь 45.".into()),
        Block::Heading { level: 2, words: "1. Маршрут".into() },
        Block::Heading { level: 3, words: "005 З ЧПК".into() },
        Block::Fields(vec![Field::new("T1", "A [-200;100], B [-175;50], A [-200;0]"), Field::new("T2", "B")]),
        Block::List(vec![explained]),
        tools().into(),
        Block::Finding(finding),
        figure.into(),
        Block::Code("%\nN5 G17 G40 G49 G80 G90 G54 G0 X0 Y0".to_owned()),
    ];
    let page = "\
Плита
Сталь 45.

1. Маршрут
005 З ЧПК
  T1: A [-200;100], B
    [-175;50], A [-200;0]
  T2: B
  - схема 07
    - не взято: рядки 1-4

 T   | Позначення    |  Ø,
     |               |  мм
-----+---------------+-----
 T1  | 035-2317-0103 |  16
 T12 | 035-2301-1060 | 9,5
  пропущено графи: Для,
    Виліт; усі показує
    `--format html`
  Ø - найбільший.

  хибно: 13:47: подача
    `feed` 0,25
      підстава: таблиця A.6
      підказка: взяти 0,325
  [рисунок] Шлях
    10 точок

%
N5 G17 G40 G49 G80 G90 G54 G0 X0 Y0
";
    assert_eq!(shown(28, blocks), page);
}

#[test]
fn a_wide_table_is_wrapped_then_loses_columns_then_its_form() {
    let wide = "\
Плита

 T   | Позначення    | Ø, мм | Для                         | Виліт, мм
-----+---------------+-------+-----------------------------+-----------
 T1  | 035-2317-0103 |    16 | центрування                 |        51
 T12 | 035-2301-1060 |   9,5 | розсвердлювання, зенкування |       165
  Ø - найбільший.
";
    let wrapped = "\
Плита

 T   | Позначення    | Ø, мм | Для              | Виліт, мм
-----+---------------+-------+------------------+-----------
 T1  | 035-2317-0103 |    16 | центрування      |        51
 T12 | 035-2301-1060 |   9,5 | розсвердлювання, |       165
     |               |       | зенкування       |
  Ø - найбільший.
";
    let without_one = "\
Плита

 T   | Позначення    |  Ø, | Для
     |               |  мм |
-----+---------------+-----+------------------
 T1  | 035-2317-0103 |  16 | центрування
 T12 | 035-2301-1060 | 9,5 | розсвердлювання,
     |               |     | зенкування
  пропущено графи: Виліт; усі показує `--format
    html`
  Ø - найбільший.
";
    let records = "\
Плита

T: T1
  Позначення:
    035-2317-0103
  Ø, мм: 16
  Для: центрування
  Виліт, мм: 51
T: T12
  Позначення:
    035-2301-1060
  Ø, мм: 9,5
  Для:
    розсвердлювання,
    зенкування
  Виліт, мм: 165
  усі показує
    `--format html`
  Ø - найбільший.
";
    for (width, page) in [(80, wide), (61, wrapped), (47, without_one), (20, records)] {
        assert_eq!(shown(width, vec![tools().into()]), page, "{width}");
    }
}

#[test]
fn rows_without_heads_stand_in_columns() {
    let mut table = Table::new([Column::text(""), Column::number("", ""), Column::text("")]);
    table.row(["it", "52", "[9..10] ×37"]);
    table.row(["diameter", "7", "<= 6 ×2"]);
    let blocks = vec![Block::Heading { level: 2, words: "Відкинуто".into() }, table.into()];
    let page = "\
Плита

Відкинуто
  it        52  [9..10] ×37
  diameter   7  <= 6 ×2
";
    assert_eq!(shown(80, blocks), page);
}

#[test]
fn colours_say_what_words_say_too() {
    let blocks = vec![Block::Finding(FindingBlock::new(Severity::Error, "помилка", "Ø"))];
    let page = text(&Document { blocks, ..Document::new("uk", "A") }, 80, true, &WORDS);
    assert_eq!(page, "\u{1b}[1mA\u{1b}[0m\n\u{1b}[1;31mпомилка:\u{1b}[0m Ø\n");
}

/// A narrow column is shown where a wide one of the same rank had to go, and the width named is wide enough for all.
#[test]
fn a_column_that_fits_is_shown_and_the_width_for_all_is_told() {
    let words = Words { see_all: "COLUMNS=<width>", ..WORDS };
    let mut table = Table::new([
        Column::text("Код"),
        Column::text("Найдовшеслово").keep(Keep::Optional),
        Column::text("Кут").keep(Keep::Optional),
    ]);
    table.row(["A", "зенкування", "90"]);
    let page = |width: usize| {
        let blocks = vec![Block::Table(table.clone())];
        text(&Document { blocks, ..Document::new("uk", "П") }, width, false, &words)
    };
    let narrow = page(17);
    assert!(narrow.contains("Кут") && !narrow.contains("зенкування"), "{narrow}");
    assert!(narrow.contains("COLUMNS=27"), "{narrow}");
    assert!(page(27).contains("зенкування") && !page(27).contains("COLUMNS"), "{}", page(27));
    assert!(page(26).contains("COLUMNS=27"), "{}", page(26));
}
