//! The toolpath of each scheme on the half section: feeds solid, rapids dashed, points with their names (the
//! lecture's figures 12.7 to 12.10, for any shaft).

use super::super::canvas::{Anchor, At, Canvas, Pen};
use super::Lang;
use super::cells::fixed;
use super::drawing::{MARGIN, PANEL, TALL, TITLE, part};
use super::phrases::word;
use technolog_turning::length::Half;
use technolog_turning::passes::Sequences;
use technolog_turning::point::Point;
use technolog_turning::schemes::path::Motion;
use technolog_turning::schemes::{SchemeEntry, Schemes};
use technolog_words::say;

const STOCK: &str = "#f3ead2";
const FEED: Pen = Pen::solid("#009e73", 1.3);
const RAPID: Pen = Pen::dashed("#cc79a7", 0.9);
/// Height of the names of points.
const NAME: f64 = 9.0;

/// One panel for each scheme, two in a row, beginning at a height; returns the lower end.
pub(super) fn panels(canvas: &mut Canvas, found: &Sequences, schemes: &Schemes, top: f64, lang: Lang) -> f64 {
    let shaft = &found.shaft;
    let (length, radius) = (shaft.blank.length.to_mm(), shaft.blank.diameter.to_mm() / 2.0);
    let approach = schemes.splitting.rates.approach.to_mm();
    // The home point is off the corner of the blank by the approach.
    let scale = ((PANEL - 2.0 * MARGIN) / (length + approach)).min(TALL / (radius + approach));
    let height = TITLE + (radius + approach) * scale + 2.0 * MARGIN;
    for (index, scheme) in schemes.schemes.iter().enumerate() {
        let (left, top) = ((index % 2) as f64 * PANEL, top + (index / 2) as f64 * height);
        let right = left + (PANEL + (length - approach) * scale) / 2.0;
        let place = move |point: Point| -> At {
            let down = radius + approach - point.radius.to_mm();
            (right - point.z.to_mm() * scale, top + TITLE + MARGIN + down * scale)
        };
        let title = say!(
            lang,
            "turn-scheme-panel",
            scheme = word(scheme.name),
            cutting = fixed(scheme.measures.cutting_mm.to_mm(), 1, lang),
            idle = fixed(scheme.measures.idle_mm, 1, lang),
            time = fixed(scheme.measures.time_min.0, 3, lang)
        );
        canvas.text((left + MARGIN, top + TITLE - 8.0), 14.0, Anchor::Start, &title);
        stock(canvas, schemes, &place);
        part(canvas, found, lang, &place);
        draw_toolpath(canvas, scheme, &place);
    }
    let bottom = top + schemes.schemes.len().div_ceil(2) as f64 * height;
    if schemes.schemes.is_empty() {
        return bottom;
    }
    legend(canvas, bottom, lang);
    bottom + 26.0
}

fn legend(canvas: &mut Canvas, top: f64, lang: Lang) {
    let mut left = MARGIN;
    let kinds = [(FEED, say!(lang, "turn-working-feed")), (RAPID, say!(lang, "turn-way-rapid"))];
    for (pen, name) in kinds {
        canvas.line(&[(left, top + 6.0), (left + 40.0, top + 6.0)], pen);
        canvas.text((left + 46.0, top + 10.0), 12.0, Anchor::Start, name);
        left += 184.0;
    }
}

/// The stock with its horizontals.
fn stock(canvas: &mut Canvas, schemes: &Schemes, place: &impl Fn(Point) -> At) {
    let levels = &schemes.splitting.levels;
    for cylinder in &levels.cylinders {
        let at = |radius: Half, z: Half| place(Point { radius, z });
        let (near, far) = (at(cylinder.blank, cylinder.from), at(cylinder.radius, cylinder.to));
        canvas.rectangle(near, far, STOCK, Some(Pen::solid("#666", 0.5)));
        for level in 1..=levels.full(cylinder) {
            let radius = levels.horizontal(cylinder, level);
            canvas.line(&[at(radius, cylinder.from), at(radius, cylinder.to)], Pen::solid("#999", 0.5));
        }
    }
}

/// The path with its points. A name is placed where it covers no other name, and left out if there is no such place.
fn draw_toolpath(canvas: &mut Canvas, scheme: &SchemeEntry, place: &impl Fn(Point) -> At) {
    let path = || scheme.points.iter().map(|point| point.vertex);
    for (before, vertex) in path().zip(path().skip(1)) {
        let (from, to) = (place(before.at), place(vertex.at));
        let pen = if vertex.motion == Motion::Rapid { RAPID } else { FEED };
        canvas.line(&[from, to], pen);
        if vertex.motion != Motion::Rapid {
            canvas.head(from, to, pen);
        }
    }
    let mut named: Vec<(At, &str)> = Vec::new();
    for point in &scheme.points {
        if named.iter().any(|(_, name)| *name == point.name) {
            continue;
        }
        let (x, y) = place(point.vertex.at);
        canvas.circle((x, y), 1.6, "#333", None);
        let sides = [(7.0, -3.0), (-7.0, -3.0), (7.0, 10.0), (-7.0, 10.0), (0.0, -8.0), (0.0, 14.0)];
        let free = sides
            .into_iter()
            .map(|(dx, dy)| (x + dx, y + dy))
            .find(|(x, y)| named.iter().all(|((ox, oy), _)| (x - ox).abs() > 1.3 * NAME || (y - oy).abs() > NAME));
        if let Some(at) = free {
            canvas.text(at, NAME, Anchor::Middle, &point.name);
            named.push((at, &point.name));
        }
    }
}
