//! Turns the steps of a program into panels.

use crate::motion::geometry::{Point, in_plane, sweep};
use crate::motion::{Axis, Motion, MotionStep, Plane, Position, Sense};
use crate::units::Micrometres;

use super::{Frame, Placed};

/// A point of the drawing, mm.
pub(super) type DrawingPoint = (f64, f64);

/// The work of one tool until the next tool or stop.
#[derive(Debug, Default)]
pub(super) struct Panel<'f> {
    /// T.
    pub tool: Option<u32>,
    /// The set-up with holes at its plunges.
    pub placed: Option<&'f Placed>,
    /// The path seen from above.
    pub lines: Vec<PathSegment>,
    /// Where the tool plunges at feed, each place once.
    pub plunges: Vec<DrawingPoint>,
    /// Where the tool was changed.
    pub change: Option<DrawingPoint>,
}

/// A segment of the path.
#[derive(Clone, Copy, Debug)]
pub(super) struct PathSegment {
    pub from: DrawingPoint,
    pub to: DrawingPoint,
    pub rapid: bool,
    pub shape: DrawnShape,
}

/// Its form.
#[derive(Clone, Copy, Debug)]
pub(super) enum DrawnShape {
    Straight,
    Arc { centre: DrawingPoint, sense: Sense, sweep: f64 },
}

impl PathSegment {
    /// Points of its bounding box: its ends, and for an arc the whole circle.
    pub(super) fn reach(&self) -> Vec<DrawingPoint> {
        match self.shape {
            DrawnShape::Straight => vec![self.from, self.to],
            DrawnShape::Arc { centre: (x, y), .. } => {
                let radius = libm::hypot(self.from.0 - x, self.from.1 - y);
                vec![self.from, self.to, (x - radius, y - radius), (x + radius, y + radius)]
            }
        }
    }

    /// A straight line by its ends, in either order; `None` for an arc.
    pub(super) fn straight_ends(&self) -> Option<[(i64, i64); 2]> {
        let DrawnShape::Straight = self.shape else { return None };
        let exact = |(x, y): DrawingPoint| [x, y].map(|value| Micrometres::from_mm_rounded(value).micrometres());
        let mut ends = [exact(self.from), exact(self.to)].map(|[x, y]| (x, y));
        ends.sort_unstable();
        Some(ends)
    }

    fn moved(&mut self, (dx, dy): DrawingPoint) {
        for spot in [&mut self.from, &mut self.to] {
            *spot = (spot.0 + dx, spot.1 + dy);
        }
        if let DrawnShape::Arc { centre, .. } = &mut self.shape {
            *centre = (centre.0 + dx, centre.1 + dy);
        }
    }
}

/// The panels of a program; without a cut there is no panel.
pub(super) fn panels<'f>(steps: &[MotionStep], frame: Option<&'f Frame<'_>>) -> Vec<Panel<'f>> {
    let mut panels: Vec<Panel<'f>> = Vec::new();
    let mut panel = Panel::default();
    let mut at: Option<Position> = None;
    for step in steps {
        let from = at.unwrap_or(step.at);
        at = Some(step.at);
        match &step.motion {
            Motion::ToolChange { tool } => {
                if panel.cuts() {
                    panels.push(std::mem::take(&mut panel));
                }
                panel = Panel { tool: Some(*tool), change: Some(spot(step.at)), ..Panel::default() };
            }
            // After this stop the operator may have done anything: turned the part over, set a boring bar.
            Motion::Stop { optional: false } if panel.cuts() => {
                let next = Panel { tool: panel.tool, change: panel.change, ..Panel::default() };
                panels.push(std::mem::replace(&mut panel, next));
            }
            motion => panel.take(motion, from, step.at),
        }
    }
    if panel.cuts() {
        panels.push(panel);
    }
    if let Some(frame) = frame {
        for panel in &mut panels {
            panel.put_on(frame);
        }
    }
    panels
}

fn spot(at: Position) -> DrawingPoint {
    (at.x.to_mm(), at.y.to_mm())
}

impl<'f> Panel<'f> {
    fn cuts(&self) -> bool {
        !self.plunges.is_empty() || self.lines.iter().any(|line| !line.rapid)
    }

    fn take(&mut self, motion: &Motion, from: Position, to: Position) {
        let straight = |rapid| PathSegment { from: spot(from), to: spot(to), rapid, shape: DrawnShape::Straight };
        let moves = spot(from) != spot(to);
        match motion {
            Motion::Rapid if moves => self.lines.push(straight(true)),
            Motion::Feed { .. } if moves => self.lines.push(straight(false)),
            // Down at feed, deeper than the approach of a program that approaches at feed. A further feed down at the
            // same place is the same plunge.
            Motion::Feed { .. } if to.z < from.z && self.plunges.last() != Some(&spot(to)) => {
                self.plunges.push(spot(to));
            }
            Motion::Arc { plane: Plane::Xy, sense, centre, turns, .. } => {
                let centre: Point = centre.map(Micrometres::to_mm);
                let turned = sweep(in_plane(from, Plane::Xy), in_plane(to, Plane::Xy), centre, *sense);
                let whole = if *turns > 0 { std::f64::consts::TAU } else { turned };
                let shape = DrawnShape::Arc { centre: (centre[0], centre[1]), sense: *sense, sweep: whole };
                self.lines.push(PathSegment { shape, ..straight(false) });
            }
            // Seen from above, an arc in a vertical plane is a straight line between its ends.
            Motion::Arc { .. } if moves => self.lines.push(straight(false)),
            _ => {}
        }
    }

    /// Converts the panel to the coordinates of the set-up with holes at most of its plunges.
    fn put_on(&mut self, frame: &'f Frame<'_>) {
        let hits = |placed: &Placed| {
            let holes: Vec<DrawingPoint> =
                placed.holes(frame.part).map(|(way, ..)| (way.from.x.to_mm(), way.from.y.to_mm())).collect();
            let zero = spot(placed.zero);
            let on = |(x, y): &DrawingPoint| {
                holes.iter().any(|hole| (hole.0 + zero.0 - x).abs() < 0.02 && (hole.1 + zero.1 - y).abs() < 0.02)
            };
            self.plunges.iter().filter(|plunge| on(plunge)).count()
        };
        // Among equals the first.
        let best = frame.setups.iter().rev().max_by_key(|placed| hits(placed));
        let Some(placed) = best else { return };
        let shift = (-placed.zero.get(Axis::X).to_mm(), -placed.zero.get(Axis::Y).to_mm());
        for line in &mut self.lines {
            line.moved(shift);
        }
        for spot in self.plunges.iter_mut().chain(&mut self.change) {
            *spot = (spot.0 + shift.0, spot.1 + shift.1);
        }
        self.placed = Some(placed);
    }
}
