//! The part from above: the plate with its overall sizes, every hole with the name of its group, once with its size, the chains of
//! dimensions between the centres where they have room, the zero of the drawing.

use std::collections::BTreeMap;

use crate::note::IntoFigure;
use crate::part::{Blank, Hole, Part, Point};
use crate::units::Micrometres;

use super::super::canvas::{Anchor, At, Canvas, Pen, THIN, width_of};
use super::super::sheet::mm;
use super::super::words::say;
use super::Lang;

pub(super) const WIDTH: f64 = 720.0;
pub(super) const MARGIN: f64 = 96.0;
const TALLEST: f64 = 640.0;
const TOP: f64 = 30.0;
const INK: Pen = Pen::solid("#333", 1.2);
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
    let plate = Plate::of(part, TOP);
    let Plate { corner, across, up, .. } = plate;
    let mut canvas = Canvas::default();
    plate.outline(&mut canvas);
    let zero_at = plate.at(Point { x: Micrometres::ZERO, y: Micrometres::ZERO });
    let mut labels = Labels { plate, holes: Vec::new(), taken: axes(zero_at) };
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
            labels.holes.extend(ends.map(|end| (end, radius)));
        }
    }
    for hole in &part.holes {
        let Some((centre, diameter)) = circle_of_centres(hole, part) else { continue };
        let (centre, radius) = (plate.at(centre), diameter.to_mm() / 2.0 * plate.scale);
        canvas.circle(centre, radius, "none", Some(AXIS));
        let text = format!("Ø{}", mm(diameter, lang));
        let around = (0..EIGHTHS).map(|number| {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * (f64::from(number) + 0.5) / f64::from(EIGHTHS));
            (centre.0 + radius * cos, centre.1 + radius * sin)
        });
        // Where no hole and no other size stands.
        if let Some(place) = around.into_iter().find_map(|at| labels.free(at, 0.0, &text)) {
            labels.taken.push((place, width_of(&text, SIZE)));
            canvas.text(place, SIZE, Anchor::Start, &text);
        }
    }
    for hole in &part.holes {
        // The size stands once, at the first hole of a group that has room for it.
        let mut sized = Some(group(hole, lang)).filter(|_| hole.slot.is_none());
        let mut unnamed = true;
        for way in hole.middles() {
            let at = plate.at(way.to);
            let radius = plate.radius(hole);
            let told = sized.as_deref().and_then(|text| Some((text.to_owned(), labels.free(at, radius, text)?)));
            let by_name = || Some((hole.name.clone(), labels.free(at, radius, &hole.name)?));
            // A group is named at least once, wherever that stands.
            let at_last = || unnamed.then(|| (hole.name.clone(), labels.any(at, radius, &hole.name)));
            let Some((text, place)) = told.clone().or_else(by_name).or_else(at_last) else { continue };
            if told.is_some() {
                sized = None;
            }
            unnamed = false;
            labels.taken.push((place, width_of(&text, SIZE)));
            canvas.text(place, SIZE, Anchor::Start, &text);
        }
    }
    zero(&mut canvas, zero_at);
    let xs = chain(part, |point| point.x).filter(|chain| fits(chain, plate.scale, lang));
    let ys = chain(part, |point| point.y).filter(|chain| fits(chain, plate.scale, lang));
    let (mut below, mut beside) = (corner.1 + up + 22.0, corner.0 - 22.0);
    if let Some(links) = xs {
        let links: Vec<_> = links.into_iter().map(|(x, y)| (x, plate.at(Point { x, y }))).collect();
        links_drawn(&mut canvas, &links, |(x, _), out| (x, below + out), lang);
        below += NEXT;
    }
    if let Some(links) = ys {
        let links: Vec<_> = links.into_iter().map(|(y, x)| (y, plate.at(Point { x, y }))).collect();
        links_drawn(&mut canvas, &links, |(_, y), out| (beside - out, y), lang);
        beside -= ASIDE;
    }
    let round = part.blank.is_round();
    let size = format!("{}{}", if round { "Ø" } else { "" }, mm(part.blank.length, lang));
    canvas.dimension([(corner.0, below), (corner.0 + across, below)], &size);
    // A disc is widest at the height of its axis.
    let from = if round { corner.1 + up / 2.0 } else { corner.1 + up };
    for x in [corner.0, corner.0 + across] {
        canvas.line(&[(x, from), (x, below + 4.0)], THIN);
    }
    if !round {
        canvas.dimension([(beside, corner.1 + up), (beside, corner.1)], &mm(part.blank.width, lang));
        for y in [corner.1, corner.1 + up] {
            canvas.line(&[(corner.0, y), (beside - 4.0, y)], THIN);
        }
    }
    canvas.page(WIDTH, below + 24.0)
}

pub(super) const SIZE: f64 = 12.0;
/// From one dimension line to the next, below the plate and beside it, where the figures stand across.
const NEXT: f64 = 26.0;
const ASIDE: f64 = 36.0;

/// A chain of dimensions between places of the page, each with its coordinate: `to_line` brings a place to the dimension line, or so
/// far beyond it.
fn links_drawn(canvas: &mut Canvas, links: &[(Micrometres, At)], to_line: impl Fn(At, f64) -> At, lang: Lang) {
    for pair in links.windows(2) {
        canvas.dimension([to_line(pair[0].1, 0.0), to_line(pair[1].1, 0.0)], &mm(pair[1].0 - pair[0].0, lang));
    }
    for (_, at) in links {
        canvas.line(&[*at, to_line(*at, 4.0)], THIN);
    }
}

/// How many holes of which size a group has, and its name.
fn group(hole: &Hole, lang: Lang) -> String {
    let size = match &hole.thread {
        Some(thread) => thread.written.clone(),
        None => lang.figure(&(&hole.diameter).into_figure()),
    };
    say!(lang, "cycles-holes", count = hole.at.len(), size = size, hole = hole.name.as_str())
}

/// The coordinates that centres have in a direction, the zero among them, in order; of each also how far the nearest of its
/// centres lies to the left or below, from where its extension line comes.
fn chain(part: &Part, along: fn(Point) -> Micrometres) -> Option<Vec<(Micrometres, Micrometres)>> {
    let mut links: BTreeMap<Micrometres, Micrometres> = BTreeMap::new();
    let other = |point: Point| point.x + point.y - along(point);
    let zero = Point { x: Micrometres::ZERO, y: Micrometres::ZERO };
    let centres = part.holes.iter().flat_map(|hole| hole.middles().flat_map(|way| [way.from, way.to]));
    for point in centres.chain([zero]) {
        let least = links.entry(along(point)).or_insert_with(|| other(point));
        *least = (*least).min(other(point));
    }
    Some(links.into_iter().collect()).filter(|links: &Vec<_>| links.len() > 1)
}

/// Whether every link of a chain is a size of a drawing and holds its figure; otherwise the coordinates stand in the table only.
fn fits(chain: &[(Micrometres, Micrometres)], scale: f64, lang: Lang) -> bool {
    chain.windows(2).all(|pair| {
        let link = pair[1].0 - pair[0].0;
        // Coordinates worked out from a circle are rounded: no drawing has such a size.
        let is_drawn = link.micrometres() % 100 == 0;
        is_drawn && link.to_mm() * scale >= width_of(&mm(link, lang), SIZE) + 8.0
    })
}

/// Places around a circle of centres where its size may stand.
const EIGHTHS: u8 = 24;
/// Coordinates worked out from a circle are rounded to micrometres.
const ROUNDING_MM: f64 = 0.002;
/// So many holes evenly about a centre are drawn on a circle; fewer may as well be the corners of a rectangle.
const ON_A_CIRCLE: usize = 5;

/// The circle on which the centres of a group lie, with its diameter: on a disc about its axis, elsewhere where they are evenly
/// spaced.
fn circle_of_centres(hole: &Hole, part: &Part) -> Option<(Point, Micrometres)> {
    let points: Vec<At> = hole.at.iter().map(|at| (at.x.to_mm(), at.y.to_mm())).collect();
    let count = points.len();
    let about = |(x, y): At| -> Option<f64> {
        let radii = points.iter().map(|at| libm::hypot(at.0 - x, at.1 - y));
        let first = radii.clone().next().filter(|first| *first > ROUNDING_MM)?;
        radii.clone().all(|radius| (radius - first).abs() <= ROUNDING_MM).then_some(first)
    };
    let circle = |centre: Point, radius: f64| (centre, Micrometres::from_mm_rounded((200.0 * radius).round() / 100.0));
    if part.blank.is_round() {
        let axis = part.middle();
        return (count > 1 && hole.slot.is_none())
            .then(|| about((axis.x.to_mm(), axis.y.to_mm())))?
            .map(|radius| circle(axis, radius));
    }
    if count < ON_A_CIRCLE || hole.slot.is_some() {
        return None;
    }
    let middle = |along: fn(&At) -> f64| points.iter().map(along).sum::<f64>() / count as f64;
    let (x, y) = (middle(|at| at.0), middle(|at| at.1));
    let radius = about((x, y))?;
    let mut angles: Vec<f64> = points.iter().map(|at| libm::atan2(at.1 - y, at.0 - x)).collect();
    angles.sort_by(f64::total_cmp);
    let even = std::f64::consts::TAU / count as f64;
    let is_even = angles.windows(2).all(|pair| ((pair[1] - pair[0] - even) * radius).abs() <= 2.0 * ROUNDING_MM);
    let centre = Point { x: Micrometres::from_mm_rounded(x), y: Micrometres::from_mm_rounded(y) };
    is_even.then(|| circle(centre, radius))
}

/// Where names stand, and what they must not stand on.
struct Labels {
    plate: Plate,
    holes: Vec<(At, f64)>,
    taken: Vec<(At, f64)>,
}

impl Labels {
    fn places((x, y): At, radius: f64, long: f64) -> [At; 8] {
        let (off, near) = (radius + 3.0, radius * 0.72 + 4.0);
        [
            (x + near, y - near),
            (x + near, y + near + SIZE),
            (x - near - long, y - near),
            (x - near - long, y + near + SIZE),
            (x - long / 2.0, y - off - 4.0),
            (x - long / 2.0, y + off + SIZE + 2.0),
            (x + off + 3.0, y - 4.0),
            (x - off - long - 3.0, y - 4.0),
        ]
    }

    /// The first place around a hole where a text stands within the plate, on no other text and on no hole.
    fn free(&self, at: At, radius: f64, text: &str) -> Option<At> {
        let long = width_of(text, SIZE);
        let (left, top) = self.plate.corner;
        let is_inside = |(x, y): At| {
            x > left + 2.0 && x + long < left + self.plate.across && y - SIZE > top && y + 3.0 < top + self.plate.up
        };
        Self::places(at, radius, long).into_iter().find(|&(x, y)| {
            let is_clear = |&((cx, cy), radius): &(At, f64)| {
                let (dx, dy) = (cx - cx.clamp(x, x + long), cy - cy.clamp(y - SIZE, y + 2.0));
                libm::hypot(dx, dy) >= radius
            };
            let is_alone = |&((tx, ty), tl): &(At, f64)| (y - ty).abs() > SIZE || x > tx + tl || x + long < tx;
            is_inside((x, y)) && self.holes.iter().all(is_clear) && self.taken.iter().all(is_alone)
        })
    }

    /// The same, or the first place of all if none is free.
    fn any(&self, at: At, radius: f64, text: &str) -> At {
        self.free(at, radius, text).unwrap_or(Self::places(at, radius, width_of(text, SIZE))[0])
    }
}

/// Where the axes of the zero stand, as lines of text.
fn axes((x, y): At) -> Vec<(At, f64)> {
    vec![((x, y), 46.0), ((x - 6.0, y - 16.0), 12.0), ((x - 6.0, y - 32.0), 12.0)]
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
