//! With pick-up (з підбором; lecture l. 348-404, fig. 12.4 a).

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::toolpath::Purpose;

use super::builder::{SupportPointRole, ToolpathBuilder};
use super::split::{Section, Split};
use super::straight::Back;

/// After each straight pass the tool follows the contour up to the level of the pass before.
///
/// 1. It cuts a level to the contour ahead, at the main feed (1-2, 5-6, 8-9 of fig. 12.4 a).
/// 2. It goes on along the contour to the level before, at the feed of picking up, and cuts the ridge (2-3, 6-7-2,
///    9-10-11-6).
/// 3. It goes on by half the nose radius, so that no mark stays where the passes end (l. 394-404).
/// 4. It returns as a rapid over the level before to the vertical of the start (2-1, 6-5), and goes down to the next
///    depth. In a closed zone it returns along the contour to where the pass began, at the feed of cutting in, and goes
///    down along the falling flank (l. 468-478).
///
/// What is left is even along the whole contour (l. 354-356).
pub fn work(course: &mut ToolpathBuilder<'_>, split: &Split, nose_radius: Half) {
    for section in &split.sections {
        for within in course.rough().below(section.top, section.from, section.to) {
            course.leave_trail();
            below(course, section, 0, within, section.top, nose_radius);
        }
    }
}

fn below(
    course: &mut ToolpathBuilder<'_>,
    section: &Section,
    index: usize,
    within: (Half, Half),
    before: Half,
    nose_radius: Half,
) {
    let Some(&radius) = section.horizontals.get(index) else { return };
    let way = course.rough().clamped(radius, before, within.0, within.1);
    let way = course.trimmed(&way);
    if !way.is_empty() {
        cut(course, &way, radius, nose_radius);
    }
    for span in course.rough().spans(radius, within.0, within.1) {
        below(course, section, index + 1, span, radius, nose_radius);
    }
}

fn cut(course: &mut ToolpathBuilder<'_>, way: &[Piece], radius: Half, nose_radius: Half) {
    let falls = |piece: &&Piece| piece.to.radius < piece.from.radius;
    let down = way.iter().take_while(falls).count();
    let (above, rest) = way.split_at(down);
    let mut rest = rest.to_vec();
    let foot = above.last().map(|last| last.to).or(rest.first().map(|first| first.from));
    let flank = foot.map(|foot| course.flank(foot, Back::AlongContour)).unwrap_or_default();
    if let Some(top) = flank.first().map(|first| first.from) {
        course.back_along(top);
        course.enter(top);
        course.follow(&flank, Purpose::Infeed, SupportPointRole::AtDepth);
    } else if let Some(first) = rest.first_mut() {
        course.begin(first, Purpose::PickUp);
    }
    let count = rest.len();
    for (index, piece) in rest.iter().enumerate() {
        let straight = piece.is_cylinder() && piece.from.radius == radius;
        let (purpose, role) = match (straight, index + 1 == count) {
            (true, _) => (Purpose::Cut, SupportPointRole::End),
            (false, true) => (Purpose::PickUp, SupportPointRole::ContourEnd),
            (false, false) => (Purpose::PickUp, SupportPointRole::Corner),
        };
        course.feed(*piece, purpose, role);
    }
    let here = course.here();
    if count > 0 && course.rough().holds(here) {
        // Beyond the end of a section stands the stock of the next one: no overrun there.
        let mut over = course.rough().onwards(here, nose_radius.to_mm() / 2.0);
        let through = over.iter().position(|piece| !piece.is_face() && !course.stock.metal(piece).is_empty());
        over.truncate(through.unwrap_or(over.len()));
        course.follow(&over, Purpose::PickUp, SupportPointRole::Overrun);
        rest.extend(over);
    }
    course.passed(rest);
}
