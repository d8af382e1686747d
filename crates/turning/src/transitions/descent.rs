//! Descent (спуск; lecture l. 330-334): the stock is removed by radial motions of the tool.

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::toolpath::Purpose;

use super::builder::{SupportPointRole, ToolpathBuilder};

/// Slice after slice from the free end. The tool has an edge parallel to the axis as wide as a slice, that is the depth
/// of a pass; its theoretical point is the end of the edge towards the chuck.
///
/// 1. Above the slice the tool goes down as a rapid to the approach off the metal.
/// 2. It cuts across the axis to the highest point of the contour under its edge.
/// 3. It moves straight up again as a rapid; there is no room for a sideways retract.
///
/// Slices end and begin where the contour has a corner, so that upright walls and cylinders are exact where a cylinder
/// is not narrower than the edge; on cones and arcs steps remain. Used most in closed zones (l. 332).
pub fn work(builder: &mut ToolpathBuilder<'_>) {
    let edge = builder.settings.depth;
    let clear = builder.zone.limited(builder.zone.top + builder.settings.retract);
    for z in places(builder, edge) {
        let Some(radius) = builder.rough().highest(z - edge, z) else { continue };
        let Some(metal) = builder.stock.highest(z - edge, z).filter(|metal| *metal > radius) else { continue };
        let here = builder.here();
        builder.rapid(Point { radius: here.radius.max(clear), z: here.z }, SupportPointRole::Clear);
        builder.rapid(Point { radius: builder.here().radius, z }, SupportPointRole::Returned);
        builder.rapid(
            Point { radius: builder.zone.limited(metal + builder.settings.approach), z },
            SupportPointRole::Start,
        );
        builder.straight(Point { radius, z }, Purpose::Cut, SupportPointRole::End);
        builder.stock.lower(&slice(Point { radius, z }, edge));
        builder.passed(Vec::new());
        builder.rapid(Point { radius: clear, z }, SupportPointRole::Clear);
    }
}

/// What the edge has under it at a point.
pub fn slice(point: Point, edge: Half) -> Piece {
    Piece::line(Point { radius: point.radius, z: point.z - edge }, point)
}

/// The places of the downward moves: where the edge ends or begins at a corner, and between them so that no gap is
/// wider than the edge.
fn places(builder: &ToolpathBuilder<'_>, edge: Half) -> Vec<Half> {
    let ground = builder.rough();
    let (from, to) = builder.zone.worked;
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
