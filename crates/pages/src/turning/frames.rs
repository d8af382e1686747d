//! A sequence of passes step by step: one small picture for each pass, with the removed metal and the remaining stock
//! (the paper's figure 6, step by step).

use super::super::canvas::{Anchor, At, Canvas, Pen};
use super::Lang;
use super::cells::rounded;
use super::drawing::{FILLS, arrow, part};
use super::phrases::word;
use technolog_turning::length::Half;
use technolog_turning::passes::pass::PassDirection;
use technolog_turning::passes::{Sequences, Variant};
use technolog_turning::point::Point;
use technolog_words::say;

/// Pictures in a row.
const ROW: usize = 4;
const WIDE: f64 = 300.0;
const TALL: f64 = 210.0;
const MARGIN: f64 = 18.0;
const TITLE: f64 = 26.0;
const STOCK: &str = "#f3ead2";

/// The optimum, pass by pass.
pub fn frames(found: &Sequences, lang: Lang) -> String {
    let Some(best) = found.variants.last() else { return Canvas::default().page(WIDE, TITLE) };
    let shaft = &found.shaft;
    let (length, radius) = (shaft.blank.length.to_mm(), shaft.blank.diameter.to_mm() / 2.0);
    let scale = ((WIDE - 2.0 * MARGIN) / length.max(0.001)).min(TALL / radius.max(0.001));
    let tall = TITLE + radius * scale + 2.0 * MARGIN;
    let mut canvas = Canvas::default();
    let title = say!(
        lang,
        "turn-frames",
        variant = word(best.name),
        path = rounded(best.cutting_path_mm.to_mm(), lang),
        count = best.passes.len()
    );
    canvas.text((MARGIN, TITLE - 8.0), 14.0, Anchor::Start, &title);
    for index in 0..best.drawn.len() {
        let left = (index % ROW) as f64 * WIDE;
        let top = TITLE + (index / ROW) as f64 * tall;
        let right = left + (WIDE + length * scale) / 2.0;
        let place = move |point: Point| -> At {
            (right - point.z.to_mm() * scale, top + TITLE + MARGIN + (radius - point.radius.to_mm()) * scale)
        };
        frame(&mut canvas, found, best, index, lang, (left + MARGIN, top + TITLE - 6.0), &place);
    }
    let rows = best.drawn.len().div_ceil(ROW);
    canvas.page(WIDE * ROW.min(best.drawn.len().max(1)) as f64, TITLE + rows as f64 * tall)
}

fn frame(
    canvas: &mut Canvas,
    found: &Sequences,
    variant: &Variant,
    index: usize,
    lang: Lang,
    title_at: At,
    place: &impl Fn(Point) -> At,
) {
    let (Some(pass), Some(planned)) = (variant.drawn.get(index), variant.passes.get(index)) else { return };
    let so_far: Half = variant.passes.iter().take(index + 1).map(|pass| pass.length_mm).sum();
    let title = say!(
        lang,
        "turn-frame",
        number = planned.number,
        kind = word(planned.kind.name()),
        length = rounded(planned.length_mm.to_mm(), lang),
        sum = rounded(so_far.to_mm(), lang)
    );
    canvas.text(title_at, 12.0, Anchor::Start, &title);
    part(canvas, found, lang, place);
    for later in variant.drawn.iter().skip(index + 1) {
        for &(near, far) in &later.removed {
            canvas.rectangle(place(near), place(far), STOCK, None);
        }
    }
    for &(near, far) in &pass.removed {
        let fill = FILLS[usize::from(pass.kind == PassDirection::Transverse)][0];
        canvas.rectangle(place(near), place(far), fill, Some(Pen::solid("#666", 0.5)));
    }
    arrow(canvas, pass, index + 1, place);
}
