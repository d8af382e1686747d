//! Places numbers beside their points, not over another number and, if there is room, not over a line.

use crate::report::canvas::{At, width_of};

/// The smallest and largest letter height.
pub(super) const LEAST: f64 = 6.5;
const MOST: f64 = 11.0;

/// The number of neighbours checked on each side of a point.
const NEIGHBOURS: usize = 400;
/// The number of lines checked.
const LINES: usize = 3000;

/// The size of numbers with which neighbours leave room for each other.
pub(super) fn size(points: &[At]) -> f64 {
    // Three digits and the point itself must fit into that distance.
    (apart(points) / 2.2).min(MOST)
}

/// The distance to the nearest neighbour that most points have at least. Points at the same place cannot be separated
/// and do not count.
pub(super) fn apart(points: &[At]) -> f64 {
    let mut by_x: Vec<At> = points.to_vec();
    by_x.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    by_x.dedup();
    let mut nearest: Vec<f64> = Vec::new();
    for (index, a) in by_x.iter().enumerate() {
        let mut least = f64::INFINITY;
        // Sorted along X, the search ends when the difference in X alone is larger.
        for b in by_x[..index].iter().rev().take(NEIGHBOURS) {
            if a.0 - b.0 > least {
                break;
            }
            least = least.min(libm::hypot(a.0 - b.0, a.1 - b.1));
        }
        for b in by_x[index + 1..].iter().take(NEIGHBOURS) {
            if b.0 - a.0 > least {
                break;
            }
            least = least.min(libm::hypot(a.0 - b.0, a.1 - b.1));
        }
        nearest.push(least);
    }
    nearest.sort_by(f64::total_cmp);
    nearest.get(nearest.len() / 4).copied().unwrap_or(f64::INFINITY)
}

/// The occupied areas of a panel.
#[derive(Debug, Default)]
pub(super) struct Labels {
    boxes: Vec<(At, At)>,
    lines: Vec<(At, At)>,
}

impl Labels {
    /// A line that numbers should avoid.
    pub(super) fn avoid(&mut self, from: At, to: At) {
        // A number cannot avoid a contour of thousands of pieces.
        if from != to && self.lines.len() < LINES {
            self.lines.push((from, to));
        }
    }

    /// An area where no number may be, by two opposite corners.
    pub(super) fn take(&mut self, a: At, b: At) {
        self.boxes.push((a, b));
    }

    /// The place of a number (the middle of its base line): of eight places around its point, the one crossed by the
    /// fewest lines. None if all are occupied.
    pub(super) fn place(&mut self, at: At, text: &str, size: f64) -> Option<At> {
        self.place_off(at, 0.0, text, size)
    }

    /// The same for a text that keeps off its point, as far as a hole is wide.
    pub(super) fn place_off(&mut self, at: At, off: f64, text: &str, size: f64) -> Option<At> {
        let (half, high) = (width_of(text, size) / 2.0, size * 0.75);
        // Two adjacent numbers must not be read as one.
        let half = half + 1.0;
        let (dx, dy) = (half + 3.0 + off, high / 2.0 + 5.0 + off);
        let around =
            [(1.0, -1.0), (-1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (1.0, 0.0), (-1.0, 0.0), (0.0, -1.0), (0.0, 1.0)];
        let mut best: Option<(usize, At, At)> = None;
        for (right, down) in around {
            let middle = (at.0 + right * dx, at.1 + down * dy);
            let a = (middle.0 - half, middle.1 - high / 2.0);
            let b = (middle.0 + half, middle.1 + high / 2.0);
            if self.boxes.iter().any(|(c, d)| a.0 < d.0 && c.0 < b.0 && a.1 < d.1 && c.1 < b.1) {
                continue;
            }
            let crossed = self.lines.iter().filter(|(from, to)| crosses(*from, *to, a, b)).count();
            if best.is_none_or(|(least, ..)| crossed < least) {
                best = Some((crossed, a, b));
            }
        }
        let (_, a, b) = best?;
        self.take(a, b);
        Some((f64::midpoint(a.0, b.0), b.1))
    }
}

/// Whether a line passes through a box: the line is clipped by each side in turn (Liang and Barsky, 1984).
fn crosses(from: At, to: At, a: At, b: At) -> bool {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (along, room) in [(-dx, from.0 - a.0), (dx, b.0 - from.0), (-dy, from.1 - a.1), (dy, b.1 - from.1)] {
        if along == 0.0 {
            if room < 0.0 {
                return false;
            }
        } else if along < 0.0 {
            enter = enter.max(room / along);
        } else {
            leave = leave.min(room / along);
        }
    }
    enter <= leave
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_through_a_box_is_seen_and_one_beside_it_is_not() {
        let (a, b) = ((0.0, 0.0), (10.0, 10.0));
        assert!(crosses((-5.0, 5.0), (15.0, 6.0), a, b));
        assert!(crosses((5.0, 5.0), (6.0, 6.0), a, b));
        assert!(!crosses((-5.0, 5.0), (5.0, 20.0), a, b));
        assert!(!crosses((11.0, 0.0), (11.0, 10.0), a, b));
    }

    #[test]
    fn numbers_stand_apart_and_off_the_line() {
        let mut labels = Labels::default();
        labels.avoid((0.0, 0.0), (100.0, -100.0));
        let first = labels.place((50.0, -50.0), "1", 10.0);
        let second = labels.place((50.0, -50.0), "2", 10.0);
        assert!(first.is_some() && second.is_some() && first != second);
        // The line goes up to the right: the numbers must be elsewhere.
        assert!(first.is_some_and(|(x, _)| x < 50.0));
    }
}
