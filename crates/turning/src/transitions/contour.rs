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
/// 3. The next cycle is one step of the line nearer to the contour; the last pass is the contour itself.
///
/// The line has the direction of the blank's allowance: outwards and, if the contour only rises, towards the free end
/// as far as the blank has stock on its faces. A bar has no such stock, so its line is radial.
pub fn work(builder: &mut ToolpathBuilder<'_>) {
    let step = step(builder);
    let shifted = |count: i64| -> Vec<Piece> {
        let by = |size: Half| Half::new(size.halves().saturating_mul(count));
        let place = |point: Point| Point { radius: point.radius + by(step.radius), z: point.z - by(step.z) };
        // Only the part of the shifted contour over the worked range.
        let ((from, to), rough) = (builder.zone.worked, builder.rough());
        let near = rough.touching(from, to + by(step.z));
        let pieces = near.iter().map(|piece| piece.mapped(false, place)).collect();
        let pass = MonotoneContour { pieces };
        let begins = near.first() == rough.pieces.first();
        let ends = near.last() == rough.pieces.last();
        let from = if begins { rough.from() } else { pass.from() };
        let to = if ends { rough.to() } else { pass.to() };
        pass.stretched(from, to).pieces
    };
    let count = (1..=MOST).find(|count| builder.trimmed(&shifted(*count)).is_empty()).unwrap_or(MOST);
    let passes: Vec<_> = (0..count).rev().map(|count| (count, shifted(count))).collect();
    for (count, pass) in passes {
        let path = builder.trimmed(&pass);
        let Some(first) = path.first().map(|first| first.from) else { continue };
        let start = builder.side_start(first).unwrap_or(first);
        builder.pass(&path, Purpose::Cut, SupportPointRole::ContourEnd);
        let higher = Half::new(step.radius.halves().saturating_mul(count));
        let clear =
            builder.zone.limited(builder.zone.top + builder.settings.retract + higher).max(builder.here().radius);
        builder.rapid(Point { radius: clear, z: builder.here().z }, SupportPointRole::Clear);
        builder.rapid(Point { radius: clear, z: start.z }, SupportPointRole::Returned);
    }
}

/// One step of the line; its larger component is the depth of a pass.
fn step(builder: &ToolpathBuilder<'_>) -> Point {
    let depth = builder.settings.depth;
    let (across, along) = (across(builder).to_mm(), along(builder).to_mm());
    let most = across.max(along);
    let part = |size: f64| if most > 0.0 { Half::from(depth.to_mm() * size / most) } else { depth };
    Point { radius: part(across), z: if most > 0.0 { part(along) } else { Half::ZERO } }
}

/// The least stock over the pieces that have stock, without faces.
fn across(builder: &ToolpathBuilder<'_>) -> Half {
    let over = |piece: &Piece| {
        let top = builder.zone.whole.highest(piece.from.z, piece.to.z)?;
        Some(top - piece.from.radius.max(piece.to.radius)).filter(|stock| *stock > Half::ZERO)
    };
    builder.rough().pieces.iter().filter(|piece| !piece.is_face()).filter_map(over).min().unwrap_or_default()
}

/// The least stock before a face. It counts only if the contour never falls and the blank has a face or slope of its
/// own before every face.
fn along(builder: &ToolpathBuilder<'_>) -> Half {
    let ground = builder.rough();
    if ground.pieces.iter().any(|piece| piece.to.radius < piece.from.radius) {
        return Half::ZERO;
    }
    let cells = builder.zone.whole.cells();
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
    // If a face has no stock of its own before it, a shift along the axis would cut all the stock over it across the
    // axis.
    faces.into_iter().collect::<Option<Vec<_>>>().and_then(|all| all.into_iter().min()).unwrap_or_default()
}
