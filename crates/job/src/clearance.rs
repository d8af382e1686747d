//! Clearance over obstacles: the clamps of the part file, and the part at the tool change.

use crate::error::KnowledgeError;
use crate::note::{Finding, Note, Severity};
use crate::part::{Part, Point};
use crate::shop::Shop;
use crate::tables::holes::HoleDefault;
use crate::units::Micrometres;

use super::SetUp;

/// A tool change above the part: the tools are not higher above it than during their motions.
pub(super) fn change_over_part(
    setup: &SetUp,
    part: &Part,
    change: (Micrometres, Micrometres),
    findings: &mut Vec<Finding>,
) {
    let over = |zero: Micrometres, begin: Micrometres, length: Micrometres, at: Micrometres| {
        (zero + begin..=zero + begin + length).contains(&at)
    };
    let (datum, blank) = (part.datum, part.blank);
    let x = over(setup.zero.x, datum.left, blank.length, change.0);
    let y = over(setup.zero.y, datum.front, blank.width, change.1);
    if x && y {
        let note = Note::new("change-over-part").with("x", change.0).with("y", change.1);
        findings.push(Finding::of_part(Severity::Doubtful, note));
    }
}

/// Paths from hole to hole that cross a clamp of the part file. The height of clamps is not known.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn ways_over_clamps(
    setup: &SetUp,
    part: &Part,
    change: (Micrometres, Micrometres),
    shop: &Shop<'_>,
    findings: &mut Vec<Finding>,
) -> Result<(), KnowledgeError> {
    let foot = shop.convention(HoleDefault::ClampInset)?;
    let home = Point { x: change.0 - setup.zero.x, y: change.1 - setup.zero.y };
    let mut under: Vec<String> = Vec::new();
    let mut height = None;
    for work in &setup.works {
        let ends = std::iter::once(home).chain(work.stops.iter().map(|stop| stop.at)).chain([home]);
        let points: Vec<Point> = ends.collect();
        for (clamp, pair) in
            part.fixture.clamps.iter().flat_map(|clamp| points.windows(2).map(move |pair| (clamp, pair)))
        {
            let shown = format!("[{};{}]", clamp.at.x, clamp.at.y);
            if passes(pair[0], pair[1], clamp.at, foot) && !under.contains(&shown) {
                under.push(shown);
                let out = work.cycles.iter().map(|cycle| cycle.out).min();
                height = height.into_iter().chain(out).min();
            }
        }
    }
    if let Some(height) = height {
        let over = height - part.datum.top;
        let note = Note::new("ways-over-clamps").with("clamps", under.join(", ")).with("height", over);
        findings.push(Finding::of_part(Severity::Doubtful, note));
    }
    Ok(())
}

/// Whether a rapid passes a point at less than a distance. Both axes have the same rate: the path is at 45° until one
/// axis has arrived, then along the other.
fn passes(from: Point, to: Point, at: Point, near: Micrometres) -> bool {
    let (dx, dy) = (to.x - from.x, to.y - from.y);
    let both = dx.abs().min(dy.abs());
    let toward = |offset: Micrometres| if offset < Micrometres::ZERO { -both } else { both };
    let corner = Point { x: from.x + toward(dx), y: from.y + toward(dy) };
    [(from, corner), (corner, to)].iter().any(|(a, b)| distance(*a, *b, at) < near.to_mm())
}

/// The distance from a point to a line segment, mm.
fn distance(a: Point, b: Point, at: Point) -> f64 {
    let [ax, ay, bx, by, px, py] = [a.x, a.y, b.x, b.y, at.x, at.y].map(Micrometres::to_mm);
    let (dx, dy) = (bx - ax, by - ay);
    let square = dx * dx + dy * dy;
    let share = if square > 0.0 { (((px - ax) * dx + (py - ay) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
    libm::hypot(px - ax - share * dx, py - ay - share * dy)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(x: i64, y: i64) -> Point {
        Point { x: Micrometres::from_mm(x), y: Micrometres::from_mm(y) }
    }

    /// From the origin to X100 Y40 both axes move to X40 Y40, then one along X.
    #[test]
    fn a_rapid_leads_at_45_degrees_first() {
        let near = Micrometres::from_mm(5);
        assert!(passes(point(0, 0), point(100, 40), point(70, 42), near));
        assert!(passes(point(0, 0), point(100, 40), point(20, 22), near));
        assert!(!passes(point(0, 0), point(100, 40), point(70, 28), near), "the straight line is not its way");
    }
}
