//! Equidistant (еквідистантна; lecture l. 434-440, fig. 12.4 c).

use crate::error::{Refusal, Tried};
use crate::turning::contour::Contour;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::toolpath::Purpose;

use super::builder::{SupportPointRole, ToolpathBuilder};
use super::check::Unsuited;
use super::monotone::MonotoneContour;

/// No zone needs more passes than this.
const MOST: i64 = 10_000;

/// The offset curve of a contour at a distance outwards; none if it cannot be made.
pub type Offset<'o> = &'o dyn Fn(&Contour, Half) -> Option<Contour>;

/// Each pass is the offset of the contour at a multiple of the depth, from the outermost that cuts anything to the
/// contour itself. For shaped parts.
///
/// 1. The tool moves to the start beside the metal, and along the whole pass (1-2-3, 5-6-7, 8-9-10 of fig. 12.4 c).
/// 2. It returns to one point off the corner of the blank (3-4, 7-4), straight if there is no metal in the way.
/// 3. From there it goes to the start of the next pass (4-5, 4-8).
///
/// The depth is measured normal to the contour: radially it is more on cones, and on a face it is the whole stock.
pub fn work(builder: &mut ToolpathBuilder<'_>, offset: Offset<'_>) -> Tried<(), Unsuited> {
    let depth = builder.settings.depth;
    let mut passes = Vec::new();
    for count in 1..=MOST {
        let distance = Half::new(depth.halves().saturating_mul(count));
        let Some(beside) = beside(builder, distance, offset) else {
            return Err(Refusal::Not(Unsuited::NoEquidistant { distance }));
        };
        if builder.trimmed(&beside.pieces).is_empty() {
            break;
        }
        passes.push(beside);
    }
    passes.reverse();
    let (from, to) = builder.zone.worked;
    passes.push(MonotoneContour { pieces: builder.rough().touching(from, to).to_vec() });
    let corner = Point {
        radius: builder.zone.limited(builder.zone.top + builder.settings.retract),
        z: builder.rough().from() - builder.settings.approach,
    };
    for pass in passes {
        let path = builder.trimmed(&pass.pieces);
        if path.is_empty() {
            continue;
        }
        if builder.passes > 0 {
            let here = builder.here();
            if !builder.stock.is_clear(here, corner) {
                builder.rapid(Point { radius: corner.radius.max(here.radius), z: here.z }, SupportPointRole::Clear);
            }
            builder.rapid(corner, SupportPointRole::Returned);
        }
        builder.pass(&path, Purpose::Cut, SupportPointRole::ContourEnd);
    }
    Ok(())
}

/// The offset at a distance over the worked range. No corner of an offset is farther away than twice the distance, so
/// the rest of the contour does not matter.
fn beside(builder: &ToolpathBuilder<'_>, distance: Half, offset: Offset<'_>) -> Option<MonotoneContour> {
    let whole = &builder.zone.stock.rough;
    let ((from, to), far) = (builder.zone.worked, distance + distance + Half::from(1.0));
    let near = whole.near(from - far, to + far);
    let beside = MonotoneContour::of(&offset(&near, distance)?);
    // Extended to the ends of the zone only if these are the ends of the contour; elsewhere the contour continues.
    let begins = near.pieces.first() == whole.pieces.first();
    let ends = near.pieces.last() == whole.pieces.last();
    let from = if begins { builder.rough().from() } else { beside.from() };
    let to = if ends { builder.rough().to() } else { beside.to() };
    Some(beside.stretched(from, to))
}
