//! Drawings of the order: the plate, its holes, and the path of each tool with its points numbered.

use super::canvas::{Anchor, At, COLOURS, Canvas, Pen};
use crate::part::{Part, Point, Way};
use crate::units::Micrometres;

/// A path to be drawn.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Its title.
    pub title: String,
    /// The points in order. The first is not numbered where it is the tool-change position.
    pub path: Vec<Point>,
    /// Whether the first point is the tool-change position and not a hole.
    pub from_change: bool,
    /// Whether the path returns to its first point.
    pub closed: bool,
}

/// Width of a panel, in units of the drawing.
const WIDTH: f64 = 560.0;
const TITLE: f64 = 26.0;
const MARGIN: f64 = 22.0;
/// Sizes of the letters of a title and of a number.
const LETTERS: (f64, f64) = (14.0, 11.0);
/// Above this number of points their numbers would overlap.
const NUMBERED: usize = 150;

/// The panels, two in a row, each with the plate (if there is one) and all holes under its path.
pub fn drawing(panels: &[Panel], part: Option<&Part>) -> String {
    let holes: Vec<(Way, Micrometres)> = part
        .iter()
        .flat_map(|part| &part.holes)
        .flat_map(|hole| hole.middles().map(|way| (way, hole.diameter.nominal)))
        .collect();
    let plate = part.map(|part| {
        let (datum, blank) = (part.datum, part.blank);
        (blank, [mm(datum.left), mm(datum.front), mm(blank.length), mm(blank.width)])
    });
    let mut xs: Vec<f64> = Vec::new();
    let mut ys: Vec<f64> = Vec::new();
    for point in
        panels.iter().flat_map(|panel| &panel.path).chain(holes.iter().flat_map(|(way, _)| [&way.from, &way.to]))
    {
        xs.push(mm(point.x));
        ys.push(mm(point.y));
    }
    if let Some((_, [left, front, length, width])) = plate {
        xs.extend([left, left + length]);
        ys.extend([front, front + width]);
    }
    let least = |values: &[f64]| values.iter().copied().reduce(f64::min).unwrap_or_default();
    let most = |values: &[f64]| values.iter().copied().reduce(f64::max).unwrap_or_default();
    let (left, right, low, high) = (least(&xs), most(&xs), least(&ys), most(&ys));
    let (across, up) = ((right - left).max(1.0), (high - low).max(1.0));
    // The panel stays on the page, whether wide or tall.
    let scale = ((WIDTH - 2.0 * MARGIN) / across).min(900.0 / up);
    let height = TITLE + up * scale + 2.0 * MARGIN;
    let columns = panels.len().clamp(1, 2);
    let rows = panels.len().div_ceil(columns).max(1);
    let mut canvas = Canvas::default();
    for (number, panel) in panels.iter().enumerate() {
        let (x0, y0) = ((number % columns) as f64 * WIDTH, (number / columns) as f64 * height);
        // Y points up on the drawing of the part, and down in the file.
        let page = |x: f64, y: f64| (x0 + MARGIN + (x - left) * scale, y0 + TITLE + MARGIN + (high - y) * scale);
        let at = |point: &Point| page(mm(point.x), mm(point.y));
        canvas.text((x0 + MARGIN, y0 + TITLE - 6.0), LETTERS.0, Anchor::Start, &panel.title);
        if let Some((blank, [left, front, length, width])) = plate {
            let corner = page(left + length, front + width);
            canvas.blank(&blank, [page(left, front), corner], "#f4f4f4", Pen::solid("#444", 1.0));
        }
        for (hole, diameter) in &holes {
            let radius = (mm(*diameter) / 2.0 * scale).max(1.0);
            let (ends, corner) = ([at(&hole.from), at(&hole.to)], hole.corner.map(|corner| mm(corner) * scale));
            canvas.opening(ends, (radius, corner), "white", Some(Pen::solid("#999", 1.0)));
        }
        let colour = COLOURS[number % COLOURS.len()];
        let back = panel.path.first().filter(|_| panel.closed);
        let points: Vec<At> = panel.path.iter().chain(back).map(at).collect();
        canvas.line(&points, Pen::solid(colour, 1.5));
        for (index, point) in panel.path.iter().enumerate() {
            let (x, y) = at(point);
            if panel.from_change && index == 0 {
                canvas.rectangle((x - 5.0, y - 5.0), (x + 5.0, y + 5.0), colour, None);
                continue;
            }
            canvas.circle((x, y), 2.5, colour, None);
            if panel.path.len() <= NUMBERED {
                let shown = index + usize::from(!panel.from_change);
                canvas.text((x + 5.0, y - 5.0), LETTERS.1, Anchor::Start, &shown.to_string());
            }
        }
    }
    canvas.page(WIDTH * columns as f64, height * rows as f64)
}

fn mm(value: Micrometres) -> f64 {
    value.to_mm()
}
