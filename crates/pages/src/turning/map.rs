//! The map of the variants over length to diameter: a table and a plot.

use super::super::canvas::{Anchor, At, Canvas, Pen};
use super::Lang;
use super::cells::{Cell, figure, table};
use super::phrases::word;
use crate::document::{Column, Document, Keep};
use technolog_turning::passes::map::{Ratio, settled};
use technolog_turning::passes::pass::PassDirection;
use technolog_words::say;

const NAMES: [&str; 3] = ["longitudinal", "transverse", "per-step"];
const COLOURS: [&str; 3] = ["#0072b2", "#d55e00", "#009e73"];
/// Values more than this above the optimum are drawn at the edge, per cent.
const SHOWN: f64 = 60.0;
const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 420.0;
const LEFT: f64 = 64.0;
const TOP: f64 = 64.0;

fn title(shaft: &str, lang: Lang) -> String {
    say!(lang, "turn-map", shaft = shaft)
}

/// The map as a table.
pub fn map_page(shaft: &str, map: &[Ratio], lang: Lang) -> Document {
    let mut columns = vec![Column::number("L/D", ""), Column::number("L", say!(lang, "unit-mm"))];
    columns.extend(NAMES.map(|name| Column::number(say!(lang, "turn-map-above", variant = word(name)), "%")));
    columns.push(Column::text(say!(lang, "turn-map-best")).keep(Keep::Optional));
    let row = |ratio: &Ratio| {
        let mut row = vec![figure(ratio.length_to_diameter, lang).into(), Cell::Figure(ratio.length_mm.to_mm(), 2)];
        row.extend(ratio.above_optimum_percent.map(|percent| Cell::Figure(percent, 2)));
        row.push(lang.term("word", ratio.winner).into());
        row
    };
    let mut page = Document::new(lang.tag(), title(shaft, lang));
    page.push(table(columns, map.iter().map(row).collect(), lang));
    if let Some((kind, ratio)) = settled(map) {
        page.paragraph(match kind {
            PassDirection::Longitudinal => say!(lang, "turn-map-along", ratio = ratio),
            PassDirection::Transverse => say!(lang, "turn-map-across", ratio = ratio),
        });
    }
    page
}

/// The map as a plot: length to diameter along, on a power scale; per cent above the optimum up.
pub fn map_drawing(shaft: &str, map: &[Ratio], lang: Lang) -> String {
    let mut canvas = Canvas::default();
    let place = |ratio: f64, percent: f64| -> At {
        let along = (libm::log10(ratio) + 1.0) / 2.0;
        (LEFT + along * (WIDTH - LEFT - 24.0), TOP + (1.0 - percent.min(SHOWN) / SHOWN) * (HEIGHT - TOP - 50.0))
    };
    canvas.text((LEFT, 22.0), 14.0, Anchor::Start, &title(shaft, lang));
    let grey = Pen::solid("#ccc", 0.6);
    for percent in [0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0] {
        let (from, to) = (place(0.1, percent), place(10.0, percent));
        canvas.line(&[from, to], grey);
        canvas.text((from.0 - 26.0, from.1 + 4.0), 11.0, Anchor::Middle, &format!("{percent} %"));
    }
    for ratio in [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0] {
        let (low, high) = (place(ratio, 0.0), place(ratio, SHOWN));
        canvas.line(&[low, high], grey);
        canvas.text((low.0, low.1 + 18.0), 11.0, Anchor::Middle, &figure(ratio, lang));
    }
    canvas.text((WIDTH / 2.0, HEIGHT - 12.0), 12.0, Anchor::Middle, "L/D");
    for (index, (name, colour)) in NAMES.into_iter().zip(COLOURS).enumerate() {
        let points: Vec<At> =
            map.iter().map(|one| place(one.length_to_diameter, one.above_optimum_percent[index])).collect();
        let pen = Pen::solid(colour, 2.0);
        canvas.line(&points, pen);
        for &point in &points {
            canvas.circle(point, 2.5, colour, None);
        }
        let left = LEFT + index as f64 * 170.0;
        canvas.line(&[(left, 44.0), (left + 22.0, 44.0)], pen);
        canvas.text((left + 28.0, 48.0), 12.0, Anchor::Start, lang.term("word", name));
    }
    canvas.page(WIDTH, HEIGHT)
}
