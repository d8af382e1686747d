//! Patterns of centres: a grid, a line or a circle instead of a list of points.

use crate::knowledge::form::KeyOf;
use crate::knowledge::yaml::{Fields, Node, NodeKind};
use crate::units::{Decimal, Micrometres};
use technolog_note::note;

use super::Point;
use super::file::hole as form;
use super::read::Reader;

/// Beyond a kilometre a point is outside every blank, and the figures need not be exact.
const FARTHEST_UM: f64 = 1e9;
/// A full turn, millionths of a degree.
const TURN: i128 = 360_000_000;

impl Reader<'_> {
    /// The points of a pattern, in its order; none if it has a mistake.
    pub(super) fn pattern(&mut self, node: &Node) -> Vec<Point> {
        let Some(mut fields) = self.problems.map(node) else { return Vec::new() };
        let kinds = [form::Pattern::grid, form::Pattern::line, form::Pattern::circle].map(|kind| fields.take(kind));
        let before = self.problems.0.len();
        fields.finish(self.problems);
        match kinds {
            [Some(node), None, None] => self.grid(node),
            [None, Some(node), None] => self.line(node),
            [None, None, Some(node)] => self.circle(node),
            [None, None, None] => {
                // A misspelt kind has been reported already.
                if self.problems.0.len() == before {
                    let help = note!("part-give-one-grid-line-circle");
                    self.problems.error_help::<()>("bad-value", note!("part-pattern-no-kind"), &node.place, help);
                }
                None
            }
            _ => self.problems.error_help(
                "bad-value",
                note!("part-pattern-one-kind"),
                &node.place,
                note!("part-keep-one-them"),
            ),
        }
        .unwrap_or_default()
    }

    fn grid(&mut self, node: &Node) -> Option<Vec<Point>> {
        let mut fields = self.problems.map(node)?;
        let start = fields.need(form::Grid::start, self.problems).and_then(|node| self.point(node));
        let columns = self.count(&mut fields, form::Grid::columns, 1);
        let rows = self.count(&mut fields, form::Grid::rows, 1);
        let step = fields.need(form::Grid::step, self.problems).and_then(|node| self.grid_step(node));
        let angle = self.direction(&mut fields, form::Grid::angle);
        fields.finish(self.problems);
        let (start, (step_x, step_y), turn) = (start?, step?, Turn::new(angle?, TURN));
        let (columns, rows) = (columns?, rows?);
        self.room_for(columns.saturating_mul(rows), node)?;
        let place =
            |row: usize, column: usize| turn.place(start, column as f64 * step_x.to_mm(), row as f64 * step_y.to_mm());
        Some((0..rows).flat_map(|row| (0..columns).map(move |column| place(row, column))).collect())
    }

    fn line(&mut self, node: &Node) -> Option<Vec<Point>> {
        let mut fields = self.problems.map(node)?;
        let start = fields.need(form::Line::start, self.problems).and_then(|node| self.point(node));
        let count = self.count(&mut fields, form::Line::count, 1);
        let step = self.need_size(&mut fields, form::Line::step);
        let angle = self.direction(&mut fields, form::Line::angle);
        fields.finish(self.problems);
        let (start, count, step, turn) = (start?, count?, step?, Turn::new(angle?, TURN));
        self.room_for(count, node)?;
        Some((0..count).map(|index| turn.place(start, index as f64 * step.to_mm(), 0.0)).collect())
    }

    fn circle(&mut self, node: &Node) -> Option<Vec<Point>> {
        let mut fields = self.problems.map(node)?;
        let centre = fields.need(form::Circle::centre, self.problems).and_then(|node| self.point(node));
        let diameter = self.need_size(&mut fields, form::Circle::diameter);
        let count = self.count(&mut fields, form::Circle::count, 2);
        let start = self.direction(&mut fields, form::Circle::start_angle);
        fields.finish(self.problems);
        let (centre, radius_mm, count, start) = (centre?, diameter?.to_mm() / 2.0, count?, start?);
        self.room_for(count, node)?;
        // In exact fractions of a turn, so that opposite points are opposite to the micrometre.
        let parts = count as i128;
        let place = |index: usize| Turn::new(start * parts + TURN * index as i128, TURN * parts);
        Some((0..count).map(|index| place(index).place(centre, radius_mm, 0.0)).collect())
    }

    /// One step for both directions, or one for each, mm.
    fn grid_step(&mut self, node: &Node) -> Option<(Micrometres, Micrometres)> {
        let NodeKind::Seq(items) = &node.kind else {
            let step = self.positive(node, "step")?;
            return Some((step, step));
        };
        let [x, y] = items.as_slice() else {
            let message = note!("part-step-has-two-figures-x", items = items.len());
            return self.problems.error("bad-value", message, &node.place);
        };
        let (x, y) = (self.positive(x, "step"), self.positive(y, "step"));
        Some((x?, y?))
    }

    fn count<F>(&mut self, fields: &mut Fields<'_, F>, key: KeyOf<F>, least: usize) -> Option<usize> {
        let node = fields.need(key, self.problems)?;
        let number: Decimal = self.problems.scalar(node)?;
        let count = number.to_int().and_then(|count| usize::try_from(count).ok()).filter(|count| *count >= least);
        if count.is_none() {
            let message = note!("part-must-whole-number-at-least", name = key.name(), number = number, least = least);
            return self.problems.error("bad-value", message, &node.place);
        }
        count
    }

    /// An angle in millionths of a degree, counter-clockwise from +X; zero when left out.
    pub(super) fn direction<F>(&mut self, fields: &mut Fields<'_, F>, key: KeyOf<F>) -> Option<i128> {
        match fields.take(key) {
            Some(node) => self.problems.scalar::<Decimal>(node).map(|angle| i128::from(angle.millionths())),
            None => Some(0),
        }
    }
}

/// A rotation about +Z.
#[derive(Clone, Copy)]
pub(super) struct Turn {
    cos: f64,
    sin: f64,
}

impl Turn {
    /// A turn by `part / whole` of a full turn. Quarter turns are exact, and turns that differ by a quarter agree to
    /// the last digit, because sine and cosine are taken only within a quarter.
    fn new(part: i128, whole: i128) -> Self {
        let quarters = part.rem_euclid(whole) * 4;
        let within = (quarters % whole) as f64 / whole as f64 * std::f64::consts::FRAC_PI_2;
        let (cos, sin) = if quarters % whole == 0 { (1.0, 0.0) } else { (libm::cos(within), libm::sin(within)) };
        let (cos, sin) = match quarters / whole {
            0 => (cos, sin),
            1 => (-sin, cos),
            2 => (-cos, -sin),
            _ => (sin, -cos),
        };
        Self { cos, sin }
    }

    /// A turn by millionths of a degree.
    pub(super) fn of_degrees(millionths: i128) -> Self {
        Self::new(millionths, TURN)
    }

    /// A point at these distances from the origin, rotated about it, rounded to the micrometre.
    pub(super) fn place(self, origin: Point, along_mm: f64, across_mm: f64) -> Point {
        let coordinate = |zero: Micrometres, mm: f64| {
            let um = (zero.to_mm() + mm) * 1000.0;
            Micrometres::new(um.round().clamp(-FARTHEST_UM, FARTHEST_UM) as i64)
        };
        Point {
            x: coordinate(origin.x, along_mm * self.cos - across_mm * self.sin),
            y: coordinate(origin.y, along_mm * self.sin + across_mm * self.cos),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::knowledge::yaml::{Problems, parse};
    use crate::shipped;

    fn points(text: &str) -> (Vec<[i64; 2]>, Vec<String>) {
        let knowledge = shipped::knowledge().unwrap();
        let mut problems = Problems::default();
        let (root, _) = parse("pattern", text);
        let points = Reader::new(&knowledge, &mut problems).pattern(&root.unwrap());
        let shown = |point: Point| [point.x.micrometres(), point.y.micrometres()];
        (
            points.into_iter().map(shown).collect(),
            problems.0.iter().map(|problem| problem.text(|note| technolog_words::Lang::EN.say(note))).collect(),
        )
    }

    #[test]
    fn a_pattern_is_its_points_in_order() {
        for (text, expected) in [
            (
                "grid: {start: [-10, 5], columns: 3, rows: 2, step: [25, 20.5]}",
                vec![
                    [-10_000, 5_000],
                    [15_000, 5_000],
                    [40_000, 5_000],
                    [-10_000, 25_500],
                    [15_000, 25_500],
                    [40_000, 25_500],
                ],
            ),
            (
                "grid: {start: [0, 0], columns: 2, rows: 2, step: 10, angle: 90}",
                vec![[0, 0], [0, 10_000], [-10_000, 0], [-10_000, 10_000]],
            ),
            (
                "line: {start: [1, 2], count: 3, step: 0.001, angle: -180}",
                vec![[1_000, 2_000], [999, 2_000], [998, 2_000]],
            ),
            ("line: {start: [0, 0], count: 2, step: 100, angle: 30}", vec![[0, 0], [86_603, 50_000]]),
            (
                "circle: {centre: [0, 0], diameter: 60, count: 4}",
                vec![[30_000, 0], [0, 30_000], [-30_000, 0], [0, -30_000]],
            ),
            (
                "circle: {centre: [10, 0], diameter: 20, count: 3, start_angle: 450}",
                vec![[10_000, 10_000], [1_340, -5_000], [18_660, -5_000]],
            ),
        ] {
            assert_eq!(points(text), (expected, vec![]), "{text}");
        }
    }

    #[test]
    fn opposite_points_of_a_circle_are_opposite() {
        let (points, _) = points("circle: {centre: [0, 0], diameter: 77.777, count: 84, start_angle: 1.234567}");
        for index in 0..84 {
            let ([x, y], [a, b]) = (points[index], points[(index + 42) % 84]);
            assert_eq!([x, y], [-a, -b]);
            let [a, b] = points[(index + 21) % 84];
            assert_eq!([-y, x], [a, b], "a quarter turn on");
        }
    }

    #[test]
    fn a_wrong_pattern_makes_no_points_and_says_why() {
        for (text, words) in [
            ("circle: {centre: [0, 0], diameter: 60, count: 1}", "at least 2"),
            ("line: {start: [0, 0], count: 2.5, step: 10}", "whole number"),
            ("line: {start: [0, 0], count: 3, step: -10}", "above zero"),
            ("grid: {start: [0, 0], columns: 201, rows: 100, step: 1}", "20100 points"),
            ("grid: {start: [0, 0], columns: 9000000000000, rows: 9000000000000, step: 1}", "points"),
            ("grid: {start: [0, 0], columns: 1, rows: 0, step: 1}", "at least 1"),
            ("grid: {start: [0, 0], columns: 1, rows: 1, step: [1, 2, 3]}", "not 3"),
            ("{grid: {}, line: {}}", "of one kind"),
            ("{}", "of no kind"),
            ("gird: {}", "did you mean `grid`"),
        ] {
            let (points, problems) = points(text);
            assert!(points.is_empty(), "{text}");
            assert_eq!(problems.len(), 1, "{text}: {problems:?}");
            assert!(problems[0].contains(words), "{problems:?}");
        }
    }

    #[test]
    fn a_pattern_far_off_is_no_overflow() {
        // As far as a length is read.
        let far = "line: {start: [1000000000, 0], count: 9999, step: 1000000000, angle: 180}";
        assert_eq!(points(far).0.len(), 9999);
        let farther = points("line: {start: [9000000000000, 0], count: 9999, step: 9000000000000, angle: 180}");
        assert!(farther.0.is_empty() && farther.1.iter().all(|one| one.contains("is beyond")), "{:?}", farther.1);
    }
}
