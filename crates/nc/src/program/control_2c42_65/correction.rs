//! Radius correction G41, G42: the centre of the tool follows the programmed path at the distance of its radius.
//!
//! The text names the functions, the register D, the plane and a point S where two parallel curves meet (3.10,
//! 3.11.1, 3.10.7), and nothing else. The rest is reconstructed from what controls of that time do:
//!
//! 1. The first straight motion brings the tool beside the beginning of the next element, perpendicular to it.
//! 2. Where two elements meet, the centre goes to the point S where their parallel curves meet. On the inside of a
//!    corner there is no other path: if the curves do not meet, the tool does not fit. On the outside, if they do not
//!    meet within three radii of the corner, the centre continues straight by one radius past the end of the first
//!    element, crosses over, and comes straight to the second from one radius before it; so it stays one radius away
//!    from the corner.
//! 3. After the last element the tool stands perpendicular to its end; after G40 the next straight motion leaves from
//!    there.
//!
//! So every element waits for the next one in its plane. Anything between them (a motion across the plane, a dwell, a
//! function) waits too, and is done at S.

use crate::motion::geometry::{Point, distance, in_plane, sweep};
use crate::motion::{Motion, MotionStep, Plane, Position, Sense};
use crate::program::TextSpan;
use crate::units::Micrometres;

/// A rule that a corrected path breaks: its code and its place.
pub(super) type Trouble = (&'static str, TextSpan);

/// An element of the programmed path in its plane, mm.
#[derive(Clone, Copy, Debug)]
struct Element {
    from: Point,
    to: Point,
    arc: Option<(Point, Sense)>,
}

/// An element that waits for the next one.
#[derive(Clone, Debug)]
struct Pending {
    element: Element,
    step: MotionStep,
    span: TextSpan,
    /// Whether it only brings the tool to the path.
    approach: bool,
}

/// The radius correction in progress.
#[derive(Clone, Debug, Default)]
pub(super) struct Compensator {
    plane: Option<Plane>,
    /// The distance of the centre to the left of the path, mm; negative to the right.
    offset: f64,
    entering: bool,
    pending: Option<Pending>,
    queue: Vec<MotionStep>,
    /// The position of the centre in the plane, once it has left the programmed path.
    centre: Option<Point>,
}

impl Compensator {
    /// Whether a radius correction is active.
    pub(super) fn active(&self) -> bool {
        self.offset != 0.0
    }

    /// Begins, changes or ends the correction; outputs the waiting steps.
    ///
    /// # Errors
    /// The waiting path cannot be corrected.
    pub(super) fn set(&mut self, plane: Plane, offset: f64, out: &mut Vec<MotionStep>) -> Result<(), Trouble> {
        self.flush(out)?;
        if self.plane.is_some_and(|old| old != plane) {
            self.centre = None;
        }
        self.plane = Some(plane);
        self.offset = offset;
        self.entering = offset != 0.0;
        Ok(())
    }

    /// Outputs the waiting steps; the last element ends perpendicular to its end.
    ///
    /// # Errors
    /// The path cannot be corrected.
    pub(super) fn flush(&mut self, out: &mut Vec<MotionStep>) -> Result<(), Trouble> {
        if let Some(pending) = self.pending.take() {
            let end = pending.element.offset_point(self.offset, true).ok_or(("arc-smaller-than-tool", pending.span))?;
            self.finish(pending, &[end], out)?;
            self.entering = self.offset != 0.0;
        }
        Ok(())
    }

    /// Takes a step of the programmed path that began at `from`; outputs the steps that are known by now.
    ///
    /// # Errors
    /// The path cannot be corrected.
    pub(super) fn take(
        &mut self,
        mut step: MotionStep,
        from: Position,
        span: TextSpan,
        out: &mut Vec<MotionStep>,
    ) -> Result<(), Trouble> {
        let Some(plane) = self.plane else {
            out.push(step);
            return Ok(());
        };
        let element = Element::of(&step, from, plane);
        if self.offset == 0.0 {
            match (element, self.centre) {
                (Some(element), Some(_)) if element.arc.is_some() => return Err(("correction-by-arc", span)),
                (Some(_), _) => self.centre = None,
                (None, Some(centre)) => step.at = with_point(step.at, plane, centre),
                (None, None) => {}
            }
            out.push(step);
            return Ok(());
        }
        let Some(element) = element else {
            if self.pending.is_some() {
                self.queue.push(step);
                return Ok(());
            }
            if let Some(centre) = self.centre {
                step.at = with_point(step.at, plane, centre);
            }
            out.push(step);
            return Ok(());
        };
        let approach = self.entering || self.pending.is_none();
        if approach && element.arc.is_some() {
            return Err(("correction-by-arc", span));
        }
        if let Some(pending) = self.pending.take() {
            let start = element.offset_point(self.offset, false).ok_or(("arc-smaller-than-tool", span))?;
            let meeting = if pending.approach {
                vec![start]
            } else {
                let end =
                    pending.element.offset_point(self.offset, true).ok_or(("arc-smaller-than-tool", pending.span))?;
                meeting(&pending.element, &element, end, start, self.offset).ok_or(("contour-too-tight", span))?
            };
            self.finish(pending, &meeting, out)?;
        }
        self.entering = false;
        self.pending = Some(Pending { element, step, span, approach });
        Ok(())
    }

    /// Outputs an element that ends at the first of the points, straight lines through the others, and the steps
    /// waiting after it.
    fn finish(&mut self, pending: Pending, points: &[Point], steps: &mut Vec<MotionStep>) -> Result<(), Trouble> {
        let Some(plane) = self.plane else { return Ok(()) };
        let Pending { element, mut step, span, approach } = pending;
        let begin = self.centre.unwrap_or(element.from);
        let Some(&end) = points.first() else { return Ok(()) };
        if !approach && element.turned_round(begin, end) {
            return Err(("contour-too-tight", span));
        }
        step.at = with_point(step.at, plane, end);
        let straight = match &step.motion {
            Motion::Arc { feed_mm_per_min, .. } => Motion::Feed { feed_mm_per_min: *feed_mm_per_min },
            other => other.clone(),
        };
        let (at, block) = (step.at, step.block);
        steps.push(step);
        steps.extend(points[1..].iter().map(|&point| MotionStep {
            motion: straight.clone(),
            at: with_point(at, plane, point),
            block,
        }));
        let last = points.last().copied().unwrap_or(end);
        self.centre = Some(last);
        for mut waiting in self.queue.drain(..) {
            waiting.at = with_point(waiting.at, plane, last);
            steps.push(waiting);
        }
        Ok(())
    }
}

impl Element {
    /// The element of a step; none if it does not move in the plane.
    fn of(step: &MotionStep, from: Position, plane: Plane) -> Option<Self> {
        let (from, to) = (in_plane(from, plane), in_plane(step.at, plane));
        match &step.motion {
            Motion::Rapid | Motion::Feed { .. } if from != to => Some(Self { from, to, arc: None }),
            Motion::Arc { centre, sense, .. } => {
                Some(Self { from, to, arc: Some(([centre[0].to_mm(), centre[1].to_mm()], *sense)) })
            }
            _ => None,
        }
    }

    /// The direction at its beginning or end, of length 1.
    fn direction(&self, at_end: bool) -> Point {
        let along = match self.arc {
            None => [self.to[0] - self.from[0], self.to[1] - self.from[1]],
            Some((centre, sense)) => {
                let point = if at_end { self.to } else { self.from };
                let out = [point[0] - centre[0], point[1] - centre[1]];
                match sense {
                    Sense::Counterclockwise => [-out[1], out[0]],
                    Sense::Clockwise => [out[1], -out[0]],
                }
            }
        };
        let length = libm::hypot(along[0], along[1]);
        if length > 0.0 { [along[0] / length, along[1] / length] } else { [1.0, 0.0] }
    }

    /// The radius of its parallel curve, if it is an arc.
    fn parallel_radius(&self, offset: f64) -> Option<f64> {
        self.arc.map(|(centre, sense)| {
            let radius = distance(self.from, centre);
            // The centre of a counterclockwise arc lies to its left.
            if sense == Sense::Counterclockwise { radius - offset } else { radius + offset }
        })
    }

    /// The point beside its beginning or end; none if the tool is larger than the arc.
    fn offset_point(&self, offset: f64, at_end: bool) -> Option<Point> {
        if self.parallel_radius(offset).is_some_and(|radius| radius <= 0.0) {
            return None;
        }
        let point = if at_end { self.to } else { self.from };
        let along = self.direction(at_end);
        Some([point[0] - along[1] * offset, point[1] + along[0] * offset])
    }

    /// Whether its corrected form would go backwards: then the tool does not fit between its neighbours.
    fn turned_round(&self, begin: Point, end: Point) -> bool {
        match self.arc {
            None => {
                let along = self.direction(false);
                (end[0] - begin[0]) * along[0] + (end[1] - begin[1]) * along[1] < -1e-6
            }
            Some((centre, sense)) => {
                let own = sweep(self.from, self.to, centre, sense);
                let corrected = sweep(begin, end, centre, sense);
                (own - corrected).abs() > std::f64::consts::PI && self.from != self.to
            }
        }
    }
}

/// The path of the centre from one element to the next: the point where their parallel curves meet, or several points
/// joined by straight lines; `None` if the tool does not fit between them.
fn meeting(first: &Element, second: &Element, end: Point, start: Point, offset: f64) -> Option<Vec<Point>> {
    if distance(end, start) < 0.002 {
        return Some(vec![end]);
    }
    let corner = first.to;
    let (before, behind) = (first.direction(true), second.direction(false));
    let found = match (first.parallel_radius(offset), second.parallel_radius(offset)) {
        (None, None) => lines_meet(end, before, start, behind).into_iter().collect(),
        (None, Some(radius)) => line_meets_circle(end, before, second, radius),
        (Some(radius), None) => line_meets_circle(start, behind, first, radius),
        (Some(one), Some(other)) => circles_meet(first, one, second, other),
    };
    let nearest = found.into_iter().min_by(|a, b| distance(*a, corner).total_cmp(&distance(*b, corner)));
    let near = nearest.filter(|point| distance(*point, corner) <= 3.0 * offset.abs());
    let turn = before[0] * behind[1] - before[1] * behind[0];
    let onwards = before[0] * behind[0] + before[1] * behind[1] > 0.0;
    if onwards && turn.abs() < SMOOTH {
        // Tangent, apart from the rounding of the numbers.
        return Some(near.map_or(vec![end, start], |point| vec![point]));
    }
    // At an exact reversal neither side is the inside.
    if turn * offset > 0.0 && turn.abs() > 1e-9 {
        return nearest.map(|point| vec![point]);
    }
    if let Some(point) = near {
        return Some(vec![point]);
    }
    let radius = offset.abs();
    let past = [end[0] + before[0] * radius, end[1] + before[1] * radius];
    let ahead = [start[0] - behind[0] * radius, start[1] - behind[1] * radius];
    let mut points = vec![past, ahead];
    // Only a line may be extended; an arc keeps its ends.
    if first.arc.is_some() {
        points.insert(0, end);
    }
    if second.arc.is_some() {
        points.push(start);
    }
    Some(points)
}

/// The sine of a turn so small that two elements count as tangent.
const SMOOTH: f64 = 0.02;

fn lines_meet(a: Point, along_a: Point, b: Point, along_b: Point) -> Option<Point> {
    let cross = along_a[0] * along_b[1] - along_a[1] * along_b[0];
    if cross.abs() < 1e-9 {
        return None;
    }
    let distance = ((b[0] - a[0]) * along_b[1] - (b[1] - a[1]) * along_b[0]) / cross;
    Some([a[0] + along_a[0] * distance, a[1] + along_a[1] * distance])
}

fn line_meets_circle(point: Point, along: Point, arc: &Element, radius: f64) -> Vec<Point> {
    let Some((centre, _)) = arc.arc else { return Vec::new() };
    let to_centre = [centre[0] - point[0], centre[1] - point[1]];
    let foot = to_centre[0] * along[0] + to_centre[1] * along[1];
    let away = to_centre[0] * along[1] - to_centre[1] * along[0];
    let half = radius * radius - away * away;
    if half < 0.0 {
        return Vec::new();
    }
    let half = libm::sqrt(half);
    [foot - half, foot + half].map(|distance| [point[0] + along[0] * distance, point[1] + along[1] * distance]).to_vec()
}

fn circles_meet(first: &Element, one: f64, second: &Element, other: f64) -> Vec<Point> {
    let (Some((a, _)), Some((b, _))) = (first.arc, second.arc) else { return Vec::new() };
    let apart = distance(a, b);
    if apart < 1e-9 {
        return Vec::new();
    }
    let foot = (one * one - other * other + apart * apart) / (2.0 * apart);
    let half = one * one - foot * foot;
    if half < 0.0 {
        return Vec::new();
    }
    let half = libm::sqrt(half);
    let along = [(b[0] - a[0]) / apart, (b[1] - a[1]) / apart];
    [half, -half]
        .map(|side| [a[0] + along[0] * foot - along[1] * side, a[1] + along[1] * foot + along[0] * side])
        .to_vec()
}

/// A position with another point of the plane.
fn with_point(at: Position, plane: Plane, point: Point) -> Position {
    let [a, b, _] = plane.axes();
    at.with(a, Micrometres::from_mm_rounded(point[0])).with(b, Micrometres::from_mm_rounded(point[1]))
}
