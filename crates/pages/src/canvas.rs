//! The elements of all drawings: lines, arrows, circles and texts of an SVG file, in units of the drawing.

use std::fmt::Write;

use crate::document::escaped;
use crate::part::Blank;

/// Colours that colour-blind people can tell apart (Okabe and Ito, 2008).
pub(super) const COLOURS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"];

/// A point of the page: to the right and down.
pub(super) type At = (f64, f64);

/// The style of a line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pen {
    pub colour: &'static str,
    pub width: f64,
    pub dashed: bool,
}

impl Pen {
    pub(super) const fn solid(colour: &'static str, width: f64) -> Self {
        Self { colour, width, dashed: false }
    }

    pub(super) const fn dashed(colour: &'static str, width: f64) -> Self {
        Self { colour, width, dashed: true }
    }
}

/// Lines of dimensions.
pub(super) const THIN: Pen = Pen::solid("#888", 0.8);

/// The alignment of a text at its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
}

/// A drawing under construction.
#[derive(Debug, Default)]
pub(super) struct Canvas {
    text: String,
}

impl Canvas {
    /// Appends an SVG element unchanged.
    pub(super) fn push_element(&mut self, element: std::fmt::Arguments<'_>) {
        // Writing to a text cannot fail.
        let _ = self.text.write_fmt(element);
        self.text.push('\n');
    }

    /// A line through points.
    pub(super) fn line(&mut self, points: &[At], pen: Pen) {
        let points: Vec<String> = points.iter().map(|(x, y)| format!("{x:.2},{y:.2}")).collect();
        self.push_element(format_args!("<polyline points=\"{}\" fill=\"none\"{}/>", points.join(" "), stroke(pen)));
    }

    /// A path in the language of SVG.
    pub(super) fn path(&mut self, path: &str, pen: Pen) {
        self.push_element(format_args!("<path d=\"{path}\" fill=\"none\"{}/>", stroke(pen)));
    }

    /// An arrow head at the end of a line from one point to another; none if the line has no length.
    pub(super) fn head(&mut self, from: At, to: At, pen: Pen) {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let long = libm::hypot(dx, dy);
        if long < 1e-6 {
            return;
        }
        let (ux, uy) = (dx / long, dy / long);
        let (size, half) = (4.0 + 2.0 * pen.width, 1.6 + 0.8 * pen.width);
        let (bx, by) = (to.0 - ux * size, to.1 - uy * size);
        let corners = [to, (bx - uy * half, by + ux * half), (bx + uy * half, by - ux * half)];
        self.area(&corners, pen.colour, None);
    }

    /// A filled area, with a line around it.
    pub(super) fn area(&mut self, corners: &[At], fill: &str, pen: Option<Pen>) {
        let points: Vec<String> = corners.iter().map(|(x, y)| format!("{x:.2},{y:.2}")).collect();
        let stroke = pen.map_or_else(String::new, stroke);
        self.push_element(format_args!("<polygon points=\"{}\" fill=\"{fill}\"{stroke}/>", points.join(" ")));
    }

    /// A rectangle by two opposite corners.
    pub(super) fn rectangle(&mut self, a: At, b: At, fill: &str, pen: Option<Pen>) {
        self.area(&[a, (b.0, a.1), b, (a.0, b.1)], fill, pen);
    }

    /// A circle.
    pub(super) fn circle(&mut self, (x, y): At, radius: f64, fill: &str, pen: Option<Pen>) {
        let stroke = pen.map_or_else(String::new, stroke);
        self.push_element(format_args!(
            "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.2}\" fill=\"{fill}\"{stroke}/>"
        ));
    }

    /// The outline of a blank between two opposite corners, round with its bore where it is a disc.
    pub(super) fn blank(&mut self, blank: &Blank, [a, b]: [At; 2], fill: &str, pen: Pen) {
        if !blank.is_round() {
            return self.rectangle(a, b, fill, Some(pen));
        }
        let (middle, radius) = (((a.0 + b.0) / 2.0, (a.1 + b.1) / 2.0), (b.0 - a.0).abs() / 2.0);
        self.circle(middle, radius, fill, Some(pen));
        if let Some(bore) = blank.bore {
            let share = bore.to_mm() / blank.length.to_mm().max(f64::MIN_POSITIVE);
            self.circle(middle, radius * share, if fill == "none" { fill } else { "white" }, Some(pen));
        }
    }

    /// A slot with round ends, by the middles of those; a circle where both are one.
    pub(super) fn slot(&mut self, [a, b]: [At; 2], radius: f64, fill: &str, pen: Option<Pen>) {
        if a == b {
            return self.circle(a, radius, fill, pen);
        }
        self.pocket([a, b], (radius, radius), fill, pen);
    }

    /// A slot, or a pocket where its corners have a radius of their own.
    pub(super) fn opening(
        &mut self,
        ends: [At; 2],
        (radius, corner): (f64, Option<f64>),
        fill: &str,
        pen: Option<Pen>,
    ) {
        match corner {
            Some(corner) => self.pocket(ends, (radius, corner), fill, pen),
            None => self.slot(ends, radius, fill, pen),
        }
    }

    /// What extends so far about the line between two points and is rounded by another radius in its corners.
    fn pocket(&mut self, [a, b]: [At; 2], (half, corner): (f64, f64), fill: &str, pen: Option<Pen>) {
        const PARTS: i32 = 8;
        let quarter = std::f64::consts::FRAC_PI_2;
        let along = libm::atan2(b.1 - a.1, b.0 - a.0);
        let square = half - corner;
        let turned = |(x, y): At, angle: f64, by: f64| (x + by * libm::cos(angle), y + by * libm::sin(angle));
        let mut corners: Vec<At> = Vec::new();
        for (end, first) in [(b, along - quarter), (b, along), (a, along + quarter), (a, along + 2.0 * quarter)] {
            let about = turned(turned(end, first, square), first + quarter, square);
            let on = |part| turned(about, first + quarter * f64::from(part) / f64::from(PARTS), corner);
            corners.extend((0..=PARTS).map(on));
        }
        self.area(&corners, fill, pen);
    }

    /// A dimension line with an arrow at either end; its figure over the middle of a line across, beside that of one that goes up.
    pub(super) fn dimension(&mut self, [from, to]: [At; 2], figure: &str) {
        const SIZE: f64 = 12.0;
        self.line(&[from, to], THIN);
        self.head(from, to, THIN);
        self.head(to, from, THIN);
        let middle = (f64::midpoint(from.0, to.0), f64::midpoint(from.1, to.1));
        let aside = width_of(figure, SIZE) / 2.0 + 3.0;
        let place = if from.1 == to.1 { (middle.0, middle.1 - 4.0) } else { (middle.0 - aside, middle.1 + 4.0) };
        self.text(place, SIZE, Anchor::Middle, figure);
    }

    /// A text. A white outline keeps it readable over lines.
    pub(super) fn text(&mut self, at: At, size: f64, anchor: Anchor, text: &str) {
        self.written(at, size, anchor, text, "");
    }

    /// The same in a colour.
    pub(super) fn text_in(&mut self, at: At, size: f64, anchor: Anchor, text: &str, colour: &str) {
        self.written(at, size, anchor, text, &format!(" fill=\"{colour}\""));
    }

    fn written(&mut self, (x, y): At, size: f64, anchor: Anchor, text: &str, fill: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
        };
        let text = escaped(text);
        self.push_element(format_args!(
            "<text x=\"{x:.2}\" y=\"{y:.2}\" font-size=\"{size}\" text-anchor=\"{anchor}\" stroke=\"white\" \
             stroke-width=\"3\">{text}</text>"
        ));
        self.push_element(format_args!(
            "<text x=\"{x:.2}\" y=\"{y:.2}\" font-size=\"{size}\" text-anchor=\"{anchor}\"{fill}>{text}</text>"
        ));
    }

    /// The whole file, on white.
    pub(super) fn page(self, width: f64, height: f64) -> String {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
             viewBox=\"0 0 {width:.2} {height:.2}\" font-family=\"sans-serif\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{}</svg>\n",
            self.text
        )
    }
}

fn stroke(pen: Pen) -> String {
    let dashes = if pen.dashed { " stroke-dasharray=\"6 4\"" } else { "" };
    format!(" stroke=\"{}\" stroke-width=\"{}\"{dashes}", pen.colour, pen.width)
}

/// The largest possible width of a text, in units of the drawing: estimated by a wide letter, because the font is not
/// known.
pub(super) fn width_of(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * size * 0.6
}

/// A text broken between words into lines of that width; a longer word has its own line.
pub(super) fn broken(text: &str, size: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if width_of(line, size) + width_of(word, size) + size * 0.6 <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
