//! Arcs and helices: G2 and G3 with I, J, K or R.

use super::block::Maker;
use super::control::{Characteristic as Q, Group};
use super::words::{BlockWords, WordValue};
use crate::motion::geometry::{Point, distance, in_plane};
use crate::motion::{Axis, Motion, Plane, Position, Sense};
use crate::note::IntoFigure;
use crate::program::TextSpan;
use crate::units::Micrometres;

impl Maker<'_> {
    /// An arc in the active plane; with a word across the plane a helix. I, J, K are relative to the start; a missing
    /// one is 0. Behind G90.1 they are a position, and both must be there. Without an axis of the plane it is a full circle. Some controls make P turns of it.
    pub(super) fn arc(&mut self, words: &BlockWords) {
        let plane = self.state.plane();
        let [a, b, _] = plane.axes();
        let centre = [a, b].map(|axis| self.take(words, centre_letter(axis)));
        let radius = self.take(words, 'R');
        // A zero across the plane moves the centre nowhere, where the control does not refuse it.
        let [.., off] = plane.axes().map(centre_letter);
        if !self.control.is(Q::ArcCentreInPlane) && words.get(off).is_some_and(|word| word.millionths == 0) {
            self.take(words, off);
        }
        let target = self.target(words, false);
        let given = centre.iter().flatten().next().or(radius.as_ref()).map(|word| word.span);
        let Some(span) = target.span.or(given) else { return };
        let named = [a, b].into_iter().any(|axis| words.names(axis));
        if !named && self.control.is(Q::ArcNamesEnd) {
            self.fault("arc-without-end", span);
            return;
        }
        let sense = if self.state.mode(Group::Motion) == Some(20) { Sense::Clockwise } else { Sense::Counterclockwise };
        // Judged as written: a rounded end may lie off a small arc by more than the control allows.
        let (start, end) = (exact(self.state.at, self.state.lost, plane), exact(target.at, target.lost, plane));
        let middle = match (given, radius) {
            (None, _) => {
                self.fault("arc-without-centre", span);
                None
            }
            (Some(_), Some(radius)) if centre.iter().any(Option::is_some) => {
                self.report("word-unused", radius.span, &[("word", "R".to_owned().into_figure())]);
                None
            }
            (Some(_), Some(radius)) => self.by_radius(start, end, radius, sense),
            (Some(_), None) => self.by_centre(start, end, centre, span),
        };
        let turns = if self.control.is(Q::ArcTurns) { self.take(words, 'P') } else { None };
        if let Some(given) = turns.filter(|given| given.millionths < 1_000_000 || given.millionths % 1_000_000 != 0) {
            let figures =
                [("address", "P".into_figure()), ("low", 1_u32.into_figure()), ("high", 99_999_u32.into_figure())];
            self.report("number-out-of-range", given.span, &figures);
        }
        let turns = turns.map_or(0, |given| u32::try_from(given.millionths / 1_000_000 - 1).unwrap_or_default());
        let across = plane.axes()[2];
        let rise = (target.at.get(across) - self.state.at.get(across)).to_mm();
        let length = middle.map_or(0.0, |middle| arc_length([start, end], middle, sense, turns, rise));
        let feed_mm_per_min = self.feed_along(Some(length), span);
        let Some(middle) = middle else {
            // The run continues as if the position had been reached.
            self.state.at = target.at;
            (self.state.lost, self.state.floating) = (target.lost, target.floating);
            return;
        };
        let centre = middle.map(Micrometres::from_mm_rounded);
        self.go(Motion::Arc { plane, sense, centre, turns, feed_mm_per_min }, target.at, target.floating, span);
        self.state.lost = target.lost;
    }

    fn by_centre(&mut self, start: Point, end: Point, centre: [Option<WordValue>; 2], span: TextSpan) -> Option<Point> {
        let inches = self.state.inches();
        let mut middle = start;
        if self.state.mode(Group::ArcDistance) == Some(901) {
            if centre.iter().any(Option::is_none) {
                self.fault("arc-without-centre", span);
                return None;
            }
            let [a, b, _] = self.state.plane().axes();
            middle = [a, b].map(|axis| self.state.origin(axis, self.setting).0.to_mm());
        }
        for (value, given) in middle.iter_mut().zip(centre) {
            *value += given.map(|word| word.exact_mm(inches)).unwrap_or_default();
        }
        let (radius, other) = (distance(start, middle), distance(end, middle));
        let off = (radius - other).abs();
        let (near, part) = self.control.arc_tolerance(inches);
        if radius == 0.0 || radius.min(other) < self.control.least_radius() {
            self.fault("arc-without-radius", span);
            return None;
        }
        // LinuxCNC refuses a difference of a hundred times the first limit, or of both limits.
        let wrong =
            if part > 0.0 { off > 100.0 * near || (off > near && off > part * radius.max(other)) } else { off > near };
        if wrong {
            let shown = |value: f64| Micrometres::from_mm_rounded(value).to_string();
            self.report(
                "arc-radius",
                span,
                &[("start", shown(radius).into_figure()), ("end", shown(other).into_figure())],
            );
            return None;
        }
        Some(middle)
    }

    /// The centre of an arc by its radius: of the smaller arc, with a negative R of the larger one.
    fn by_radius(&mut self, start: Point, end: Point, given: WordValue, sense: Sense) -> Option<Point> {
        let radius = given.exact_mm(self.state.inches());
        let chord = distance(start, end);
        if chord == 0.0 || radius == 0.0 {
            self.fault("arc-radius-alone", given.span);
            return None;
        }
        let half = chord / 2.0;
        if half > radius.abs() + self.control.arc_reach() {
            let shown = |value: f64| Micrometres::from_mm_rounded(value).to_string();
            self.report(
                "arc-radius-short",
                given.span,
                &[("radius", shown(radius.abs()).into_figure()), ("needed", shown(half).into_figure())],
            );
            return None;
        }
        let height = libm::sqrt((radius * radius - half * half).max(0.0));
        // Clockwise along the smaller arc the centre is to the right of the chord.
        let right = (sense == Sense::Clockwise) == (radius > 0.0);
        let side = if right { height } else { -height };
        let [dx, dy] = [(end[0] - start[0]) / chord, (end[1] - start[1]) / chord];
        Some([(start[0] + end[0]) / 2.0 + dy * side, (start[1] + end[1]) / 2.0 - dx * side])
    }
}

/// The length of an arc or a helix about a centre, mm.
fn arc_length([start, end]: [Point; 2], middle: Point, sense: Sense, turns: u32, rise: f64) -> f64 {
    let angle = |point: Point| libm::atan2(point[1] - middle[1], point[0] - middle[0]);
    let swept = if sense == Sense::Counterclockwise { angle(end) - angle(start) } else { angle(start) - angle(end) };
    let turn = std::f64::consts::TAU;
    let swept = swept - turn * libm::floor(swept / turn);
    // A full circle ends where it begins.
    let swept = (if swept < 1e-9 { turn } else { swept }) + turn * f64::from(turns);
    libm::hypot(swept * distance(start, middle), rise)
}

/// A position in a plane before it was rounded.
fn exact(at: Position, lost: [f64; 3], plane: Plane) -> Point {
    let [a, b, _] = plane.axes();
    let [x, y] = in_plane(at, plane);
    [x + lost[a.index()], y + lost[b.index()]]
}

/// The letter of a centre along an axis.
const fn centre_letter(axis: Axis) -> char {
    match axis {
        Axis::X => 'I',
        Axis::Y => 'J',
        Axis::Z => 'K',
    }
}
