//! Contour (контурна; lecture l. 442-458, fig. 12.4 d): the standard cycle of controls.

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::toolpath::Purpose;

use super::builder::{SupportPointRole, ToolpathBuilder};
use super::monotone::MonotoneContour;

/// No zone needs more passes than this.
const MOST: i64 = 10_000;

/// Each pass is the contour itself, shifted along a straight line.
///
/// 1. From the start beside the metal the tool goes along the shifted contour.
/// 2. It goes up off the metal, and returns as a rapid to above the start: a closed cycle with the pass.
/// 3. The next cycle is the same, nearer to the contour by one step of the line; the last is the contour itself.
///
/// The line leads in the direction of the blank's allowance: outwards, and towards the free end as far as the blank has
/// stock on its faces, where the contour only rises. A bar has no such stock, so its line is radial.
pub fn work(course: &mut ToolpathBuilder<'_>) {
    let step = step(course);
    let shifted = |count: i64| -> Vec<Piece> {
        let by = |size: Half| Half::new(size.halves().saturating_mul(count));
        let place = |point: Point| Point { radius: point.radius + by(step.radius), z: point.z - by(step.z) };
        // What is shifted over the stretch that is worked.
        let ((from, to), rough) = (course.zone.worked, course.rough());
        let near = rough.touching(from, to + by(step.z));
        let pieces = near.iter().map(|piece| piece.mapped(false, place)).collect();
        let pass = MonotoneContour { pieces };
        let begins = near.first() == rough.pieces.first();
        let ends = near.last() == rough.pieces.last();
        let from = if begins { rough.from() } else { pass.from() };
        let to = if ends { rough.to() } else { pass.to() };
        pass.stretched(from, to).pieces
    };
    let count = (1..=MOST).find(|count| course.trimmed(&shifted(*count)).is_empty()).unwrap_or(MOST);
    let passes: Vec<_> = (0..count).rev().map(|count| (count, shifted(count))).collect();
    for (count, pass) in passes {
        let way = course.trimmed(&pass);
        let Some(first) = way.first().map(|first| first.from) else { continue };
        let start = course.side_start(first).unwrap_or(first);
        course.pass(&way, Purpose::Cut, SupportPointRole::ContourEnd);
        let higher = Half::new(step.radius.halves().saturating_mul(count));
        let clear = course.zone.held(course.zone.top + course.settings.retract + higher).max(course.here().radius);
        course.rapid(Point { radius: clear, z: course.here().z }, SupportPointRole::Clear);
        course.rapid(Point { radius: clear, z: start.z }, SupportPointRole::Returned);
    }
}

/// One step of the line: the larger of its two parts is the depth of a pass.
fn step(course: &ToolpathBuilder<'_>) -> Point {
    let depth = course.settings.depth;
    let (across, along) = (across(course).to_mm(), along(course).to_mm());
    let most = across.max(along);
    let part = |size: f64| if most > 0.0 { Half::from(depth.to_mm() * size / most) } else { depth };
    Point { radius: part(across), z: if most > 0.0 { part(along) } else { Half::ZERO } }
}

/// The least stock over a piece that is no face, and has some.
fn across(course: &ToolpathBuilder<'_>) -> Half {
    let over = |piece: &Piece| {
        let top = course.zone.whole.highest(piece.from.z, piece.to.z)?;
        Some(top - piece.from.radius.max(piece.to.radius)).filter(|stock| *stock > Half::ZERO)
    };
    course.rough().pieces.iter().filter(|piece| !piece.is_face()).filter_map(over).min().unwrap_or_default()
}

/// The least stock before a face, where the contour only rises and the blank has a face or slope of its own before it.
fn along(course: &ToolpathBuilder<'_>) -> Half {
    let ground = course.rough();
    if ground.pieces.iter().any(|piece| piece.to.radius < piece.from.radius) {
        return Half::ZERO;
    }
    let cells = course.zone.whole.cells();
    let heights: Vec<Half> = cells
        .iter()
        .scan(Half::ZERO, |highest, cell| {
            *highest = cell.top.to.radius.max(cell.top.from.radius).max(*highest);
            Some(*highest)
        })
        .collect();
    let before = |face: &Piece| {
        let middle = Half::new((face.from.radius + face.to.radius).halves() / 2);
        let cell = cells.get(heights.partition_point(|highest| *highest <= middle))?;
        let stock = face.from.z - cell.from;
        (cell.from > ground.from()).then_some(stock)
    };
    let faces: Vec<Option<Half>> = ground.pieces.iter().filter(|piece| piece.is_face()).map(before).collect();
    // A face with no stock of its own before it would be cut crosswise over all that stands there.
    faces.into_iter().collect::<Option<Vec<_>>>().and_then(|all| all.into_iter().min()).unwrap_or_default()
}
