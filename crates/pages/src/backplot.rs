//! The backplot: the motions of a program seen from above, one panel for each tool.
//!
//! It is drawn from the steps of any interpreter. With a [`Frame`] the plate and its holes are drawn under the paths,
//! in the coordinates of the drawing; without one the coordinates are those of the machine.
//!
//! - `read` divides the steps into panels; `labels` places the numbers; `legend` explains the signs.

use super::Lang;
use super::canvas::{Anchor, At, COLOURS, Canvas, Pen, width_of};
use super::sheet::mm;
use super::words::say;
use crate::job::Job;
use crate::motion::{MotionStep, Position, Sense};
use crate::part::{Face, Hole, Outline, Part, Point, Standing, Way};
use crate::units::Micrometres;

mod labels;
mod legend;
mod read;

use labels::Labels;
use legend::{legend, zero};
use read::{DrawnShape, Panel, PathSegment};

/// The position of the part while a program runs.
#[derive(Clone, Debug)]
pub struct Frame<'a> {
    /// The part.
    pub part: &'a Part,
    /// Its set-ups, in order. A panel belongs to the one whose holes lie under its plunges.
    pub setups: Vec<Placed>,
    /// The designations of tools by their T numbers in the program.
    pub tools: Vec<(u32, String)>,
    /// Clamps and obstacles, each with its set-up.
    pub standing: Vec<(u32, Standing)>,
}

/// A set-up of a [`Frame`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placed {
    /// Its number, from 1.
    pub number: u32,
    /// The face that is up; with the back face up the X axis of the part is reversed.
    pub face: Face,
    /// The zero of the drawing, machine coordinates.
    pub zero: Position,
}

impl<'a> Frame<'a> {
    /// The frame of a job.
    pub fn of(job: &Job, part: &'a Part) -> Self {
        let mut tools: Vec<(u32, String)> = Vec::new();
        for work in job.setups.iter().flat_map(|setup| &setup.works) {
            match tools.iter_mut().find(|(place, _)| *place == work.place) {
                // A place that is loaded twice has no tool name.
                Some((_, known)) if *known != work.designation => known.clear(),
                Some(_) => {}
                None => tools.push((work.place, work.designation.clone())),
            }
        }
        let placed = job.setups.iter().map(|setup| Placed { number: setup.number, face: setup.face, zero: setup.zero });
        let standing = job.setups.iter().flat_map(|setup| setup.standing.iter().map(|one| (setup.number, *one)));
        Self { part, setups: placed.collect(), tools, standing: standing.collect() }
    }
}

impl Placed {
    /// Where the holes are, with their diameters and names, in this set-up.
    fn holes<'p>(&self, part: &'p Part) -> impl Iterator<Item = (Way, Micrometres, &'p str)> + 'p {
        let (middle, back) = (part.middle().x, self.face == Face::Back);
        let turned = move |at: Point| Point { x: if back { middle + middle - at.x } else { at.x }, y: at.y };
        let all = move |hole: &'p Hole| {
            let lies = move |way: Way| Way { from: turned(way.from), to: turned(way.to), ..way };
            hole.middles().map(move |way| (lies(way), hole.diameter.nominal, hole.name.as_str()))
        };
        part.holes.iter().flat_map(all)
    }
}

const MARGIN: f64 = 30.0;
const TITLE: f64 = 46.0;
/// Width of a panel where two are side by side, and where there are too many points for that.
const WIDTHS: [f64; 2] = [620.0, 1240.0];
const HEIGHT_MAX: f64 = 900.0;
/// Width of a panel without a neighbour.
const ALONE: f64 = 820.0;
/// Points that would be nearer than this on a narrow panel are shown on a wide one.
const CROWDED: f64 = 26.0;

/// The width of a sheet of a report, on which letters keep their size, the most that its panels are high together, and the
/// most that one is where its points leave room for it: two stand on a sheet.
const SHEET: f64 = 680.0;
const SHEET_HEIGHT: f64 = 860.0;
const PANEL: f64 = 350.0;
/// Clamps.
const CLAMP: &str = "#e3d3c3";

const OUTLINE: Pen = Pen::solid("#444", 1.0);
const HOLE: Pen = Pen::solid("#999", 1.0);

/// The rectangle that every panel shows, mm.
#[derive(Clone, Copy, Debug)]
struct Extent {
    left: f64,
    right: f64,
    low: f64,
    high: f64,
}

impl Extent {
    fn of(points: impl Iterator<Item = (f64, f64)>) -> Option<Self> {
        points.fold(None, |extent, (x, y)| {
            let one = Self { left: x, right: x, low: y, high: y };
            Some(extent.map_or(one, |extent: Self| extent.with(one)))
        })
    }

    fn with(self, other: Self) -> Self {
        Self {
            left: self.left.min(other.left),
            right: self.right.max(other.right),
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    fn across(self) -> f64 {
        (self.right - self.left).max(1.0)
    }

    fn up(self) -> f64 {
        (self.high - self.low).max(1.0)
    }
}

/// The position of a panel on the page.
#[derive(Clone, Copy, Debug)]
struct View {
    extent: Extent,
    origin: At,
    scale: f64,
}

impl View {
    fn at(&self, (x, y): (f64, f64)) -> At {
        // Y points up on the drawing of the part, and down in the file.
        (self.origin.0 + (x - self.extent.left) * self.scale, self.origin.1 + (self.extent.high - y) * self.scale)
    }

    /// The nearest point of the page that the panel shows.
    fn inside(&self, (x, y): (f64, f64)) -> At {
        let e = self.extent;
        self.at((x.clamp(e.left, e.right), y.clamp(e.low, e.high)))
    }
}

/// The drawing of a program's steps.
///
/// Rapids are straight dashed lines, whatever path each axis takes; feeds and arcs are solid; plunges along Z are
/// points with numbers. A new panel begins with every tool and every stop for the operator.
pub fn backplot(steps: &[MotionStep], frame: Option<&Frame<'_>>, lang: Lang) -> String {
    let panels = read::panels(steps, frame);
    let Some(extent) = extent(&panels, frame) else {
        let mut canvas = Canvas::default();
        canvas.text((20.0, 30.0), 13.0, Anchor::Start, say!(lang, "backplot-empty"));
        return canvas.page(WIDTHS[0], 60.0);
    };
    // Two side by side, unless their numbers would be too close.
    let narrow = (WIDTHS[0] - 2.0 * MARGIN) / extent.across();
    let apart = |panel: &Panel<'_>| labels::apart(&panel.plunges) * narrow;
    let crowded = panels.iter().map(apart).fold(f64::INFINITY, f64::min) < CROWDED;
    let (columns, width) = match (panels.len(), crowded) {
        (_, true) => (1, WIDTHS[1]),
        (1, _) => (1, ALONE),
        _ => (2, WIDTHS[0]),
    };
    sheet(&panels, 0, extent, (columns, width, scale(extent, width)), frame, lang)
}

/// The same as sheets of a report, each with the numbers of the tools that it shows.
pub(crate) fn sheets(steps: &[MotionStep], frame: &Frame<'_>, lang: Lang) -> Vec<(Vec<u32>, String)> {
    let panels = read::panels(steps, Some(frame));
    let Some(extent) = extent(&panels, Some(frame)) else { return Vec::new() };
    let wide = scale(extent, SHEET);
    let low = wide.min(PANEL / extent.up());
    let crowded = |panel: &Panel<'_>| labels::apart(&panel.plunges) * low < CROWDED;
    // Those whose points leave room are small and share a sheet, whatever others need.
    let mut first = 0;
    let mut drawn = Vec::new();
    for alike in panels.chunk_by(|a, b| crowded(a) == crowded(b)) {
        let scale = if alike.iter().any(crowded) { wide } else { low };
        // At least one, as tall as it is.
        let fit = (SHEET_HEIGHT / (TITLE + extent.up() * scale + MARGIN)).max(1.0) as usize;
        for own in alike.chunks(fit) {
            let tools = own.iter().filter_map(|panel| panel.tool).collect();
            drawn.push((tools, sheet(own, first, extent, (1, SHEET, scale), Some(frame), lang)));
            first += own.len();
        }
    }
    drawn
}

/// Units of the page in a millimetre.
fn scale(extent: Extent, width: f64) -> f64 {
    ((width - 2.0 * MARGIN) / extent.across()).min(HEIGHT_MAX / extent.up())
}

/// Panels in columns of a width and scale, of which the first has a number among all.
fn sheet(
    panels: &[Panel<'_>],
    first: usize,
    extent: Extent,
    (columns, width, scale): (usize, f64, f64),
    frame: Option<&Frame<'_>>,
    lang: Lang,
) -> String {
    let height = TITLE + extent.up() * scale + MARGIN;
    let mut canvas = Canvas::default();
    for (number, panel) in panels.iter().enumerate() {
        let corner = ((number % columns) as f64 * width, (number / columns) as f64 * height);
        let used = extent.across() * scale;
        let origin = (corner.0 + (width - used) / 2.0, corner.1 + TITLE);
        let view = View { extent, origin, scale };
        draw(&mut canvas, panel, first + number, view, (corner.0 + MARGIN, corner.1 + 18.0), frame, lang);
    }
    let (all, down) = (width * columns as f64, height * panels.len().div_ceil(columns) as f64);
    let deep = legend(&mut canvas, (MARGIN, down), scale, all, frame, lang);
    canvas.page(all, deep + 20.0)
}

/// The plate, all cuts, and the tool-change position if it is not far away.
fn extent(panels: &[Panel<'_>], frame: Option<&Frame<'_>>) -> Option<Extent> {
    let cut = panels.iter().flat_map(|panel| {
        let lines = panel.lines.iter().filter(|line| !line.rapid).flat_map(PathSegment::reach);
        lines.chain(panel.plunges.iter().copied())
    });
    let mut extent = Extent::of(cut)?;
    if let Some(frame) = frame {
        let (datum, blank) = (frame.part.datum, frame.part.blank);
        let (left, front) = (datum.left.to_mm(), datum.front.to_mm());
        let corners = [(left, front), (left + blank.length.to_mm(), front + blank.width.to_mm())];
        extent = Extent::of(corners.into_iter()).map_or(extent, |plate| extent.with(plate));
    }
    // A single hole has no extent of its own.
    let least = 20.0;
    extent = Extent {
        left: extent.left - ((least - extent.across()) / 2.0).max(0.0),
        right: extent.right + ((least - extent.across()) / 2.0).max(0.0),
        low: extent.low - ((least - extent.up()) / 2.0).max(0.0),
        high: extent.high + ((least - extent.up()) / 2.0).max(0.0),
    };
    let near = |other: Extent| {
        let both = extent.with(other);
        both.across() <= 2.0 * extent.across() && both.up() <= 2.0 * extent.up()
    };
    // What stands over the edge of the part is shown whole where that leaves the part its room.
    let standing = frame.into_iter().flat_map(|frame| &frame.standing).flat_map(|(_, one)| corners(&one.outline));
    let extent = Extent::of(standing).filter(|own| near(*own)).map_or(extent, |standing| extent.with(standing));
    let changes = Extent::of(panels.iter().filter_map(|panel| panel.change));
    Some(changes.filter(|changes| near(*changes)).map_or(extent, |changes| extent.with(changes)))
}

/// The lowest and the highest corner of what an outline covers, mm.
fn corners(outline: &Outline) -> [(f64, f64); 2] {
    match *outline {
        Outline::Round(at, radius) => [-radius, radius].map(|off| ((at.x + off).to_mm(), (at.y + off).to_mm())),
        Outline::Box(low, high) => [low, high].map(|at| (at.x.to_mm(), at.y.to_mm())),
    }
}

fn draw(
    canvas: &mut Canvas,
    panel: &Panel<'_>,
    number: usize,
    view: View,
    title: At,
    frame: Option<&Frame<'_>>,
    lang: Lang,
) {
    let colour = COLOURS[number % COLOURS.len()];
    canvas.text(title, 14.0, Anchor::Start, &heading(panel, frame, lang));
    let (low, high) = (view.at((view.extent.left, view.extent.low)), view.at((view.extent.right, view.extent.high)));
    if let (Some(frame), Some(placed)) = (frame, panel.placed) {
        let (datum, blank) = (frame.part.datum, frame.part.blank);
        let (left, front) = (datum.left.to_mm(), datum.front.to_mm());
        // Turned over about its middle, the plate covers the same area.
        let (right, rear) = (left + blank.length.to_mm(), front + blank.width.to_mm());
        canvas.blank(&blank, [view.at((left, front)), view.at((right, rear))], "#f4f4f4", OUTLINE);
        for (way, diameter, _) in placed.holes(frame.part) {
            let radius = (diameter.to_mm() / 2.0 * view.scale).max(1.0);
            let ends = [way.from, way.to].map(|end| view.at((end.x.to_mm(), end.y.to_mm())));
            let corner = way.corner.map(|corner| corner.to_mm() * view.scale);
            canvas.opening(ends, (radius, corner), "white", Some(HOLE));
        }
        for (_, one) in frame.standing.iter().filter(|(setup, _)| *setup == placed.number) {
            clamp(canvas, one, &view);
        }
        zero(canvas, view.at((0.0, 0.0)));
    }
    canvas.push_element(format_args!(
        "<clipPath id=\"panel{number}\"><rect x=\"{:.2}\" y=\"{:.2}\" width=\"{:.2}\" height=\"{:.2}\"/></clipPath>",
        low.0 - 12.0,
        high.1 - 12.0,
        high.0 - low.0 + 24.0,
        low.1 - high.1 + 24.0
    ));
    canvas.push_element(format_args!("<g clip-path=\"url(#panel{number})\">"));
    let mut labels = Labels::default();
    let mut drawn = std::collections::BTreeSet::new();
    for line in &panel.lines {
        let pen = if line.rapid { Pen::dashed(colour, 1.0) } else { Pen::solid(colour, 1.6) };
        // Dashes in both directions over the same path would fill each other's gaps: the second time only the arrow
        // is drawn.
        let again = line.straight_ends().is_some_and(|ends| !drawn.insert(ends));
        shape(canvas, line, view, pen, again);
        labels.avoid(view.at(line.from), view.at(line.to));
    }
    canvas.push_element(format_args!("</g>"));
    if let Some(change) = panel.change {
        let at = view.inside(change);
        canvas.rectangle((at.0 - 5.0, at.1 - 5.0), (at.0 + 5.0, at.1 + 5.0), colour, None);
        labels.take((at.0 - 6.0, at.1 - 6.0), (at.0 + 6.0, at.1 + 6.0));
        // If it is far away, it is drawn at the edge of the panel, with its coordinates.
        if at != view.at(change) {
            let place = |value: f64| mm(Micrometres::from_mm_rounded(value), lang);
            let text = format!("X{} Y{}", place(change.0), place(change.1));
            let half = width_of(&text, 10.0) / 2.0;
            let x = at.0.clamp(low.0 + half, (high.0 - half).max(low.0 + half));
            let y = if at.1 < f64::midpoint(low.1, high.1) { at.1 - 9.0 } else { at.1 + 17.0 };
            canvas.text((x, y), 10.0, Anchor::Middle, &text);
            labels.take((x - half, y - 10.0), (x + half, y + 3.0));
        }
    }
    numbers(canvas, panel, view, colour, &mut labels);
    if let (Some(frame), Some(placed)) = (frame, panel.placed) {
        names(canvas, placed.holes(frame.part), view, &mut labels);
    }
}

/// What stands over the face, seen from above, as far as the panel reaches.
fn clamp(canvas: &mut Canvas, one: &Standing, view: &View) {
    let pen = Some(Pen::solid("#7a5c3e", 1.0));
    let on_page = |at: Point| view.inside((at.x.to_mm(), at.y.to_mm()));
    match one.outline {
        Outline::Round(at, radius) => canvas.circle(on_page(at), radius.to_mm() * view.scale, CLAMP, pen),
        Outline::Box(low, high) => canvas.rectangle(on_page(low), on_page(high), CLAMP, pen),
    }
}

/// The names of the holes beside them, wherever the numbers leave room.
fn names<'p>(
    canvas: &mut Canvas,
    holes: impl Iterator<Item = (Way, Micrometres, &'p str)>,
    view: View,
    labels: &mut Labels,
) {
    const SIZE: f64 = 9.0;
    for (way, diameter, name) in holes {
        let middle = view.at((way.from.x.to_mm(), way.from.y.to_mm()));
        let off = (diameter.to_mm() / 2.0 * view.scale - 3.0).max(0.0);
        if let Some(place) = labels.place_off(middle, off, name, SIZE) {
            canvas.text_in(place, SIZE, Anchor::Middle, name, "#7a5c3e");
        }
    }
}

/// The points where the tool plunges, each with its number; where they are close together, every tenth.
fn numbers(canvas: &mut Canvas, panel: &Panel<'_>, view: View, colour: &'static str, labels: &mut Labels) {
    let points: Vec<At> = panel.plunges.iter().map(|&at| view.at(at)).collect();
    for &(x, y) in &points {
        canvas.circle((x, y), 2.2, colour, None);
        labels.take((x - 2.2, y - 2.2), (x + 2.2, y + 2.2));
    }
    let size = labels::size(&points);
    let step = match points.len() {
        // Thousands of numbers are useless, and placing them would take long.
        count if count > 2000 => count,
        _ if size < labels::LEAST => 10,
        _ => 1,
    };
    let size = size.max(labels::LEAST);
    for (index, &at) in points.iter().enumerate() {
        let number = index + 1;
        if number % step == 0 || number == 1 || number == points.len() {
            let text = number.to_string();
            if let Some(place) = labels.place(at, &text, size) {
                canvas.text(place, size, Anchor::Middle, &text);
            }
        }
    }
}

fn shape(canvas: &mut Canvas, line: &PathSegment, view: View, pen: Pen, again: bool) {
    let (from, to) = (view.at(line.from), view.at(line.to));
    match line.shape {
        DrawnShape::Straight => {
            if !again {
                canvas.line(&[from, to], pen);
            }
            // Arrows only where they leave room for the line.
            let long = libm::hypot(to.0 - from.0, to.1 - from.1);
            if long > 40.0 {
                let middle = (f64::midpoint(from.0, to.0), f64::midpoint(from.1, to.1));
                canvas.head(from, middle, pen);
            }
        }
        DrawnShape::Arc { centre, sense, sweep } => {
            let radius = libm::hypot(line.from.0 - centre.0, line.from.1 - centre.1) * view.scale;
            // Seen from above, with Y down the page, the visible sense stays the same.
            let flag = u8::from(sense == Sense::Clockwise);
            let path = if sweep >= std::f64::consts::TAU - 1e-9 {
                let far = view.at((2.0 * centre.0 - line.from.0, 2.0 * centre.1 - line.from.1));
                format!(
                    "M{:.2} {:.2} A{radius:.2} {radius:.2} 0 1 {flag} {:.2} {:.2} A{radius:.2} {radius:.2} 0 1 {flag} \
                     {:.2} {:.2}",
                    from.0, from.1, far.0, far.1, from.0, from.1
                )
            } else {
                let large = u8::from(sweep > std::f64::consts::PI);
                format!(
                    "M{:.2} {:.2} A{radius:.2} {radius:.2} 0 {large} {flag} {:.2} {:.2}",
                    from.0, from.1, to.0, to.1
                )
            };
            canvas.path(&path, pen);
        }
    }
}

fn heading(panel: &Panel<'_>, frame: Option<&Frame<'_>>, lang: Lang) -> String {
    let mut parts = Vec::new();
    if let Some(tool) = panel.tool {
        let designation = frame.and_then(|frame| frame.tools.iter().find(|(place, _)| *place == tool));
        let name = designation.map_or_else(String::new, |(_, name)| format!(" {name}"));
        parts.push(format!("T{tool}{}", name.trim_end()));
    }
    let several = frame.is_some_and(|frame| frame.setups.len() > 1);
    if let Some(placed) = panel.placed.filter(|_| several) {
        parts.push(say!(lang, "drawing-set-up", setup = placed.number));
    }
    parts.push(say!(lang, "backplot-points", count = panel.plunges.len()));
    parts.join(", ")
}
