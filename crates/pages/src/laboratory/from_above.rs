//! The part from above: the plate with its overall sizes, every hole with the name of its group, the zero of the drawing.

use crate::part::{Blank, Hole, Part, Point};
use crate::units::Micrometres;

use super::super::canvas::{Anchor, At, Canvas, Pen, width_of};
use super::super::sheet::mm;
use super::Lang;

pub(super) const WIDTH: f64 = 720.0;
pub(super) const MARGIN: f64 = 60.0;
const TALLEST: f64 = 640.0;
const INK: Pen = Pen::solid("#333", 1.2);
pub(super) const THIN: Pen = Pen::solid("#888", 0.8);
const AXIS: Pen = Pen::dashed("#999", 0.7);
/// A hole is never drawn smaller than this, so that it is seen.
const LEAST: f64 = 2.5;

/// Where the plate lies on the page.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plate {
    /// Its upper left corner and its size on the page.
    pub corner: At,
    pub across: f64,
    pub up: f64,
    /// Units of the page in a millimetre.
    pub scale: f64,
    left: f64,
    front: f64,
    blank: Blank,
}

impl Plate {
    /// As large as the page allows, that far below its upper edge.
    pub(super) fn of(part: &Part, top: f64) -> Self {
        let (length, width) = (part.blank.length.to_mm().max(1.0), part.blank.width.to_mm().max(1.0));
        let scale = ((WIDTH - 2.0 * MARGIN) / length).min(TALLEST / width);
        let (across, up) = (length * scale, width * scale);
        let corner = ((WIDTH - across) / 2.0, top);
        Self {
            corner,
            across,
            up,
            scale,
            left: part.datum.left.to_mm(),
            front: part.datum.front.to_mm(),
            blank: part.blank,
        }
    }

    /// A point of the drawing: there Y points up, and down in the file.
    pub(super) fn at(&self, point: Point) -> At {
        let (x, y) = (point.x.to_mm() - self.left, point.y.to_mm() - self.front);
        (self.corner.0 + x * self.scale, self.corner.1 + self.up - y * self.scale)
    }

    /// Its outline.
    pub(super) fn outline(&self, canvas: &mut Canvas) {
        let (x, y) = self.corner;
        canvas.blank(&self.blank, [(x, y), (x + self.across, y + self.up)], "none", INK);
    }

    /// How large a hole is drawn.
    pub(super) fn radius(&self, hole: &Hole) -> f64 {
        (hole.diameter.nominal.to_mm() * self.scale / 2.0).max(LEAST)
    }

    /// How much the corners of a pocket are rounded there; none of what has none.
    pub(super) fn corner_of(&self, hole: &Hole) -> Option<f64> {
        hole.slot?.corner.map(|corner| corner.to_mm() * self.scale)
    }
}

/// The drawing, a whole SVG file.
pub(super) fn drawing(part: &Part, lang: Lang) -> String {
    let plate = Plate::of(part, MARGIN / 2.0);
    let Plate { corner, across, up, .. } = plate;
    let mut canvas = Canvas::default();
    plate.outline(&mut canvas);
    let mut taken: Vec<(At, f64)> = Vec::new();
    for hole in &part.holes {
        let radius = plate.radius(hole);
        for way in hole.middles() {
            let ends = [way.from, way.to].map(|end| plate.at(end));
            let arm = radius + 4.0;
            for (x, y) in ends.into_iter().take(if hole.slot.is_some() { 2 } else { 1 }) {
                canvas.line(&[(x - arm, y), (x + arm, y)], AXIS);
                canvas.line(&[(x, y - arm), (x, y + arm)], AXIS);
            }
            canvas.opening(ends, (radius, plate.corner_of(hole)), "none", Some(INK));
            let [_, (x, y)] = ends;
            let long = width_of(&hole.name, SIZE);
            let place = label((x, y), radius, long, &taken);
            taken.push((place, long));
            canvas.text(place, SIZE, Anchor::Start, &hole.name);
        }
    }
    zero(&mut canvas, plate.at(Point { x: Micrometres::ZERO, y: Micrometres::ZERO }));
    let below = corner.1 + up + 22.0;
    let size = format!("{}{}", if part.blank.is_round() { "Ø" } else { "" }, mm(part.blank.length, lang));
    dimension(&mut canvas, [(corner.0, below), (corner.0 + across, below)], &size);
    if !part.blank.is_round() {
        let beside = corner.0 - 22.0;
        dimension(&mut canvas, [(beside, corner.1 + up), (beside, corner.1)], &mm(part.blank.width, lang));
    }
    canvas.page(WIDTH, corner.1 + up + 46.0)
}

pub(super) const SIZE: f64 = 12.0;

/// The first place around a hole for its name where no other name stands; the first place of all if every one is taken.
fn label((x, y): At, radius: f64, long: f64, taken: &[(At, f64)]) -> At {
    let off = radius + 3.0;
    let places =
        [(x + off, y - off), (x + off, y + off + SIZE), (x - off - long, y - off), (x - off - long, y + off + SIZE)];
    let is_free = |place: &At| {
        taken.iter().all(|((tx, ty), tl)| (place.1 - ty).abs() > SIZE || place.0 > tx + tl || place.0 + long < *tx)
    };
    places.into_iter().find(is_free).unwrap_or(places[0])
}

/// The zero of the drawing with its axes.
fn zero(canvas: &mut Canvas, (x, y): At) {
    let pen = Pen::solid("#d55e00", 1.6);
    for (to, name, place) in [((x + 34.0, y), "X", (x + 38.0, y + 4.0)), ((x, y - 34.0), "Y", (x - 4.0, y - 40.0))] {
        canvas.line(&[(x, y), to], pen);
        canvas.head((x, y), to, pen);
        canvas.text(place, SIZE, Anchor::Start, name);
    }
    canvas.circle((x, y), 3.0, "white", Some(pen));
}

/// A dimension line with an arrow at either end; its figure beside the middle.
pub(super) fn dimension(canvas: &mut Canvas, [from, to]: [At; 2], figure: &str) {
    canvas.line(&[from, to], THIN);
    canvas.head(from, to, THIN);
    canvas.head(to, from, THIN);
    let middle = ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0);
    let place = if from.1 == to.1 { (middle.0, middle.1 + 16.0) } else { (middle.0 - 16.0, middle.1 + 4.0) };
    canvas.text(place, SIZE, Anchor::Middle, figure);
}
