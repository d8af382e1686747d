//! Descent (спуск; lecture l. 330-334): the stock is taken by radial motion of the tool.

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::toolpath::Purpose;

use super::builder::{SupportPointRole, ToolpathBuilder};

/// Slice after slice from the free end. The tool has an edge parallel to the axis, as wide as a slice, which is as wide
/// as the depth of a pass; its theoretical point is the end of the edge towards the chuck.
///
/// 1. Above the slice the tool goes down as a rapid to off the metal by the approach.
/// 2. It cuts across the axis to the highest point of the contour under its edge.
/// 3. It goes straight up again as a rapid; there is no room to draw it back aside.
///
/// Slices end where the contour has a corner and begin where it has one, so that upright walls and cylinders come out
/// exact where a cylinder is not narrower than the edge; on cones and arcs steps stay. Used most in closed zones (l. 332).
pub fn work(course: &mut ToolpathBuilder<'_>) {
    let edge = course.settings.depth;
    let clear = course.zone.held(course.zone.top + course.settings.retract);
    for z in places(course, edge) {
        let Some(radius) = course.rough().highest(z - edge, z) else { continue };
        let Some(metal) = course.stock.highest(z - edge, z).filter(|metal| *metal > radius) else { continue };
        let here = course.here();
        course.rapid(Point { radius: here.radius.max(clear), z: here.z }, SupportPointRole::Clear);
        course.rapid(Point { radius: course.here().radius, z }, SupportPointRole::Returned);
        course.rapid(Point { radius: course.zone.held(metal + course.settings.approach), z }, SupportPointRole::Start);
        course.straight(Point { radius, z }, Purpose::Cut, SupportPointRole::End);
        course.stock.lower(&slice(Point { radius, z }, edge));
        course.passed(Vec::new());
        course.rapid(Point { radius: clear, z }, SupportPointRole::Clear);
    }
}

/// What the edge has under it at a point.
pub fn slice(point: Point, edge: Half) -> Piece {
    Piece::line(Point { radius: point.radius, z: point.z - edge }, point)
}

/// Where the point goes down: where an edge ends at a corner or begins at one, and between so that no gap is wider than
/// the edge.
fn places(course: &ToolpathBuilder<'_>, edge: Half) -> Vec<Half> {
    let ground = course.rough();
    let (from, to) = course.zone.worked;
    let beside = ground.touching(from - edge - edge, to + edge);
    let mut places: Vec<Half> = beside.iter().flat_map(|piece| [piece.from.z, piece.to.z]).collect();
    places.extend(places.clone().into_iter().map(|z| z + edge));
    places.retain(|z| (ground.from()..=ground.to()).contains(z));
    places.sort();
    places.dedup();
    let mut filled = Vec::new();
    let mut before = places.first().copied().unwrap_or(ground.from());
    for place in places {
        let width = place - before;
        let parts = width.parts(edge);
        filled.extend((1..=parts).map(|part| Half::new(before.halves() + width.halves() * part / parts)));
        before = place;
    }
    filled
}
