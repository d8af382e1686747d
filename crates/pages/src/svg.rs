//! Drawings of the order: the plate, its holes, and the path of each tool with its points numbered.

use std::fmt::Write;

use super::canvas::{COLOURS, escaped};
use crate::part::{Part, Point};
use crate::units::Micrometres;

/// A path to be drawn.
#[derive(Clone, Debug)]
pub struct Panel {
    /// What stands over it.
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
/// Beyond so many points their numbers would cover each other.
const NUMBERED: usize = 150;

/// The panels, two in a row, each with the plate (if there is one) and all holes under its path.
pub fn drawing(panels: &[Panel], part: Option<&Part>) -> String {
    let holes: Vec<(Point, Micrometres)> = part
        .iter()
        .flat_map(|part| &part.holes)
        .flat_map(|hole| hole.at.iter().map(|&at| (at, hole.diameter.nominal)))
        .collect();
    let plate = part.map(|part| {
        let (datum, blank) = (part.datum, part.blank);
        (mm(datum.left), mm(datum.front), mm(blank.length), mm(blank.width))
    });
    let mut xs: Vec<f64> = Vec::new();
    let mut ys: Vec<f64> = Vec::new();
    for point in panels.iter().flat_map(|panel| &panel.path).chain(holes.iter().map(|(at, _)| at)) {
        xs.push(mm(point.x));
        ys.push(mm(point.y));
    }
    if let Some((left, front, length, width)) = plate {
        xs.extend([left, left + length]);
        ys.extend([front, front + width]);
    }
    let least = |values: &[f64]| values.iter().copied().reduce(f64::min).unwrap_or_default();
    let most = |values: &[f64]| values.iter().copied().reduce(f64::max).unwrap_or_default();
    let (left, right, low, high) = (least(&xs), most(&xs), least(&ys), most(&ys));
    let (across, up) = ((right - left).max(1.0), (high - low).max(1.0));
    // Wide and flat or narrow and tall, a panel stays on the page.
    let scale = ((WIDTH - 2.0 * MARGIN) / across).min(900.0 / up);
    let height = TITLE + up * scale + 2.0 * MARGIN;
    let columns = panels.len().clamp(1, 2);
    let rows = panels.len().div_ceil(columns).max(1);
    let mut text = String::new();
    let (all_across, all_up) = (WIDTH * columns as f64, height * rows as f64);
    line(
        &mut text,
        format_args!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{all_across:.0}\" height=\"{all_up:.0}\" \
             viewBox=\"0 0 {all_across:.2} {all_up:.2}\" font-family=\"sans-serif\" font-size=\"11\">"
        ),
    );
    line(&mut text, format_args!("<rect width=\"100%\" height=\"100%\" fill=\"white\"/>"));
    for (number, panel) in panels.iter().enumerate() {
        let (x0, y0) = ((number % columns) as f64 * WIDTH, (number / columns) as f64 * height);
        let x = |value: f64| x0 + MARGIN + (value - left) * scale;
        // Y points up on the drawing of the part, and down in the file.
        let y = |value: f64| y0 + TITLE + MARGIN + (high - value) * scale;
        let title = escaped(&panel.title);
        let (tx, ty) = (x0 + MARGIN, y0 + TITLE - 6.0);
        line(&mut text, format_args!("<text x=\"{tx:.2}\" y=\"{ty:.2}\" font-size=\"14\">{title}</text>"));
        if let Some((left, front, length, width)) = plate {
            line(
                &mut text,
                format_args!(
                    "<rect x=\"{:.2}\" y=\"{:.2}\" width=\"{:.2}\" height=\"{:.2}\" fill=\"#f4f4f4\" stroke=\"#444\"/>",
                    x(left),
                    y(front + width),
                    length * scale,
                    width * scale
                ),
            );
        }
        for (at, diameter) in &holes {
            let radius = (mm(*diameter) / 2.0 * scale).max(1.0);
            let (x, y) = (x(mm(at.x)), y(mm(at.y)));
            line(
                &mut text,
                format_args!("<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.2}\" fill=\"white\" stroke=\"#999\"/>"),
            );
        }
        let colour = COLOURS[number % COLOURS.len()];
        let mut points: Vec<String> =
            panel.path.iter().map(|point| format!("{:.2},{:.2}", x(mm(point.x)), y(mm(point.y)))).collect();
        if panel.closed {
            points.extend(points.first().cloned());
        }
        line(
            &mut text,
            format_args!(
                "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\"/>",
                points.join(" ")
            ),
        );
        for (index, point) in panel.path.iter().enumerate() {
            let (x, y) = (x(mm(point.x)), y(mm(point.y)));
            if panel.from_change && index == 0 {
                let (a, b) = (x - 5.0, y - 5.0);
                line(
                    &mut text,
                    format_args!("<rect x=\"{a:.2}\" y=\"{b:.2}\" width=\"10\" height=\"10\" fill=\"{colour}\"/>"),
                );
                continue;
            }
            let shown = index + usize::from(!panel.from_change);
            line(&mut text, format_args!("<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"2.5\" fill=\"{colour}\"/>"));
            if panel.path.len() <= NUMBERED {
                let (a, b) = (x + 5.0, y - 5.0);
                // A white rim under the number keeps it readable over the path.
                for rim in [" stroke=\"white\" stroke-width=\"3\"", ""] {
                    line(&mut text, format_args!("<text x=\"{a:.2}\" y=\"{b:.2}\"{rim}>{shown}</text>"));
                }
            }
        }
    }
    text.push_str("</svg>\n");
    text
}

fn mm(value: Micrometres) -> f64 {
    value.to_mm()
}

fn line(text: &mut String, arguments: std::fmt::Arguments<'_>) {
    // Writing to a text cannot fail.
    let _ = text.write_fmt(arguments);
    text.push('\n');
}
