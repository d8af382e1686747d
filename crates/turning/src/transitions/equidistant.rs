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

/// A contour at a distance outwards from another; none where it cannot be made.
pub type Offset<'o> = &'o dyn Fn(&Contour, Half) -> Option<Contour>;

/// Each pass is the contour at a distance: so many times the depth, from the outermost that cuts anything to the
/// contour itself. For shaped parts.
///
/// 1. The tool goes to the start beside the metal, and along the whole pass (1-2-3, 5-6-7, 8-9-10 of fig. 12.4 c).
/// 2. It returns to one point off the corner of the blank (3-4, 7-4), straight where nothing is in the way.
/// 3. From there it goes to the start of the next pass (4-5, 4-8).
///
/// The depth is measured square to the contour: radially it is more on cones, and on a face the whole of it.
pub fn work(course: &mut ToolpathBuilder<'_>, offset: Offset<'_>) -> Tried<(), Unsuited> {
    let depth = course.settings.depth;
    let mut passes = Vec::new();
    for count in 1..=MOST {
        let distance = Half::new(depth.halves().saturating_mul(count));
        let Some(beside) = beside(course, distance, offset) else {
            return Err(Refusal::Not(Unsuited::NoEquidistant { distance }));
        };
        if course.trimmed(&beside.pieces).is_empty() {
            break;
        }
        passes.push(beside);
    }
    passes.reverse();
    let (from, to) = course.zone.worked;
    passes.push(MonotoneContour { pieces: course.rough().touching(from, to).to_vec() });
    let corner = Point {
        radius: course.zone.held(course.zone.top + course.settings.retract),
        z: course.rough().from() - course.settings.approach,
    };
    for pass in passes {
        let way = course.trimmed(&pass.pieces);
        if way.is_empty() {
            continue;
        }
        if course.passes > 0 {
            let here = course.here();
            if !course.stock.is_clear(here, corner) {
                course.rapid(Point { radius: corner.radius.max(here.radius), z: here.z }, SupportPointRole::Clear);
            }
            course.rapid(corner, SupportPointRole::Returned);
        }
        course.pass(&way, Purpose::Cut, SupportPointRole::ContourEnd);
    }
    Ok(())
}

/// The equidistant at a distance over the stretch that is worked. No corner of it lies farther from its own than twice the
/// distance, so what lies farther off is not asked for.
fn beside(course: &ToolpathBuilder<'_>, distance: Half, offset: Offset<'_>) -> Option<MonotoneContour> {
    let whole = &course.zone.stock.rough;
    let ((from, to), far) = (course.zone.worked, distance + distance + Half::from(1.0));
    let near = whole.near(from - far, to + far);
    let beside = MonotoneContour::of(&offset(&near, distance)?);
    // To the ends of the zone only where these are the ends of the contour: elsewhere it goes on otherwise.
    let begins = near.pieces.first() == whole.pieces.first();
    let ends = near.pieces.last() == whole.pieces.last();
    let from = if begins { course.rough().from() } else { beside.from() };
    let to = if ends { course.rough().to() } else { beside.to() };
    Some(beside.stretched(from, to))
}
