//! The passes of each variant, drawn on the half section: the metal of each pass in its colour, with its number and
//! direction (the paper's figure 6, for any shaft).

use super::super::canvas::{Anchor, At, Canvas, Pen};
use super::cells::{figure, rounded};
use super::phrases::word;
use super::{Lang, schemes_drawing};
use technolog_turning::length::Half;
use technolog_turning::passes::pass::{Pass, PassDirection};
use technolog_turning::passes::{Sequences, Variant};
use technolog_turning::point::Point;
use technolog_turning::ways::Ways;
use technolog_words::say;

/// Width of a panel, in units of the drawing.
pub(super) const PANEL: f64 = 600.0;
/// The greatest height of a section in a panel.
pub(super) const TALL: f64 = 420.0;
pub(super) const MARGIN: f64 = 34.0;
pub(super) const TITLE: f64 = 30.0;
/// Fills of longitudinal and of transverse passes, two of each in turn so that neighbours differ.
pub(super) const FILLS: [[&str; 2]; 2] = [["#9fc8e8", "#cfe3f3"], ["#f6c69a", "#fbe0c6"]];
const STEEL: &str = "#d9d9d9";
/// The least side of a rectangle that can hold a number, in units of the drawing.
const NUMBERED: f64 = 9.0;

/// One panel for each variant, two in a row; below them one for each scheme.
pub fn drawing(ways: &Ways, lang: Lang) -> String {
    let found = &ways.sequences;
    let shaft = &found.shaft;
    let (length, radius) = (shaft.blank.length.to_mm(), shaft.blank.diameter.to_mm() / 2.0);
    let scale = ((PANEL - 2.0 * MARGIN) / length.max(0.001)).min(TALL / radius.max(0.001));
    let panel_height = TITLE + radius * scale + 2.0 * MARGIN;
    let mut canvas = Canvas::default();
    for (index, variant) in found.variants.iter().enumerate() {
        let left = (index % 2) as f64 * PANEL;
        let top = (index / 2) as f64 * panel_height;
        // The free end is on the right, as on a lathe.
        let width = length * scale;
        let right = left + (PANEL + width) / 2.0;
        let place = move |point: Point| -> At {
            (right - point.z.to_mm() * scale, top + TITLE + MARGIN + (radius - point.radius.to_mm()) * scale)
        };
        panel(&mut canvas, found, variant, lang, (left + MARGIN, top + TITLE - 8.0), &place);
    }
    let rows = found.variants.len().div_ceil(2).max(1);
    legend(&mut canvas, rows as f64 * panel_height, lang);
    let bottom = schemes_drawing::panels(&mut canvas, found, &ways.schemes, rows as f64 * panel_height + 26.0, lang);
    canvas.page(2.0 * PANEL, bottom)
}

fn legend(canvas: &mut Canvas, top: f64, lang: Lang) {
    let mut left = MARGIN;
    for (index, kind) in [PassDirection::Longitudinal, PassDirection::Transverse].into_iter().enumerate() {
        for fill in FILLS[index] {
            canvas.rectangle((left, top), (left + 18.0, top + 12.0), fill, Some(Pen::solid("#666", 0.5)));
            left += 22.0;
        }
        canvas.text((left, top + 10.0), 12.0, Anchor::Start, lang.term("word", kind.name()));
        left += 140.0;
    }
}

fn panel(
    canvas: &mut Canvas,
    found: &Sequences,
    variant: &Variant,
    lang: Lang,
    title_at: At,
    place: &impl Fn(Point) -> At,
) {
    let path = rounded(variant.cutting_path_mm.to_mm(), lang);
    let title = say!(lang, "turn-panel", variant = word(variant.name), path = path, count = variant.passes.len());
    canvas.text(title_at, 14.0, Anchor::Start, &title);
    part(canvas, found, lang, place);
    let mut turn = [0_usize; 2];
    for pass in &variant.drawn {
        let kind = usize::from(pass.kind == PassDirection::Transverse);
        let fill = FILLS[kind][turn[kind] % 2];
        turn[kind] += 1;
        for &(near, far) in &pass.removed {
            canvas.rectangle(place(near), place(far), fill, Some(Pen::solid("#666", 0.5)));
        }
    }
    for (index, pass) in variant.drawn.iter().enumerate() {
        arrow(canvas, pass, index + 1, place);
    }
}

/// The part under the stock, with its axis and its diameters.
pub(super) fn part(canvas: &mut Canvas, found: &Sequences, lang: Lang, place: &impl Fn(Point) -> At) {
    let shaft = &found.shaft;
    let mut outline = vec![Point::default()];
    let mut z = Half::ZERO;
    for step in &shaft.steps {
        let radius = Half::radius_of(step.diameter);
        outline.push(Point { radius, z });
        z = z + Half::of(step.length);
        outline.push(Point { radius, z });
    }
    // The bar beyond the steps stays unturned, in the chuck.
    let (bar, end) = (Half::radius_of(shaft.blank.diameter), Half::of(shaft.blank.length));
    if end > z {
        outline.extend([Point { radius: bar, z }, Point { radius: bar, z: end }]);
        z = end;
    }
    outline.push(Point { radius: Half::ZERO, z });
    let corners: Vec<At> = outline.into_iter().map(place).collect();
    canvas.area(&corners, STEEL, Some(Pen::solid("#333", 1.2)));
    let (right, left) = (place(Point::default()), place(Point { radius: Half::ZERO, z }));
    canvas.line(&[(left.0 - 14.0, left.1), (right.0 + 14.0, right.1)], Pen::dashed("#333", 0.8));
    let mut z = Half::ZERO;
    for step in &shaft.steps {
        let length = Half::of(step.length);
        let middle = place(Point { radius: Half::ZERO, z: z + Half::new(length.halves() / 2) });
        let name = format!("Ø{}", figure(step.diameter, lang));
        let far = place(Point { radius: Half::ZERO, z: z + length });
        if middle.0 - far.0 > name.chars().count() as f64 * 3.2 {
            canvas.text((middle.0, middle.1 - 8.0), 11.0, Anchor::Middle, &name);
        }
        z = z + length;
    }
}

/// The path of the tool through metal, with the number of the pass beside its beginning.
pub(super) fn arrow(canvas: &mut Canvas, pass: &Pass, number: usize, place: &impl Fn(Point) -> At) {
    let (from, to) = (place(pass.from), place(pass.to));
    let colour = if pass.kind == PassDirection::Longitudinal { "#0072b2" } else { "#d55e00" };
    let pen = Pen::solid(colour, 1.0);
    canvas.line(&[from, to], pen);
    canvas.head(from, to, pen);
    let Some(&(near, far)) = pass.removed.first() else { return };
    let (near, far) = (place(near), place(far));
    let (wide, tall) = ((near.0 - far.0).abs(), (near.1 - far.1).abs());
    if wide.min(tall) < NUMBERED {
        return;
    }
    let number = number.to_string();
    // The width of a digit is about 0.6 of its height.
    let size = 11.0_f64.min(tall).min((wide - 1.0) / (0.6 * number.len() as f64)).max(6.0);
    // Beside the middle, so that it does not cover the arrow of a narrow pass.
    let at = match pass.kind {
        PassDirection::Longitudinal => (near.0 - 12.0_f64.min(wide / 2.0), (near.1 + far.1) / 2.0 + size * 0.35),
        PassDirection::Transverse => ((near.0 + far.0) / 2.0, far.1 + 12.0_f64.min(tall / 2.0 + size * 0.35)),
    };
    canvas.text(at, size, Anchor::Middle, &number);
}
