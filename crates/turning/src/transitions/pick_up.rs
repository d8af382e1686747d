//! With pick-up (з підбором; lecture l. 348-404, fig. 12.4 a).

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::toolpath::Purpose;

use super::builder::{SupportPointRole, ToolpathBuilder};
use super::split::{BlankSection, Split};
use super::straight::Back;

/// After each straight pass the tool follows the contour up to the level of the previous pass.
///
/// 1. It cuts a level to the contour ahead, at the main feed (1-2, 5-6, 8-9 of fig. 12.4 a).
/// 2. It follows the contour to the previous level, at the feed of pick-up, and cuts the ridge (2-3, 6-7-2, 9-10-11-6).
/// 3. It continues by half the nose radius, so that the ends of the passes leave no mark (l. 394-404).
/// 4. It returns as a rapid above the previous level to the vertical of the start (2-1, 6-5), and moves down to the
///    next depth. In a closed zone it returns along the contour to where the pass began, at the infeed rate, and
///    moves down along the falling flank (l. 468-478).
///
/// The allowance that is left is even along the whole contour (l. 354-356).
pub fn work(builder: &mut ToolpathBuilder<'_>, split: &Split, nose_radius: Half) {
    for section in &split.sections {
        for within in builder.rough().below(section.top, section.from, section.to) {
            builder.leave_trail();
            below(builder, section, 0, within, section.top, nose_radius);
        }
    }
}

fn below(
    builder: &mut ToolpathBuilder<'_>,
    section: &BlankSection,
    index: usize,
    within: (Half, Half),
    before: Half,
    nose_radius: Half,
) {
    let Some(&radius) = section.horizontals.get(index) else { return };
    let path = builder.rough().clamped(radius, before, within.0, within.1);
    let path = builder.trimmed(&path);
    if !path.is_empty() {
        cut(builder, &path, radius, nose_radius);
    }
    for span in builder.rough().spans(radius, within.0, within.1) {
        below(builder, section, index + 1, span, radius, nose_radius);
    }
}

fn cut(builder: &mut ToolpathBuilder<'_>, path: &[Piece], radius: Half, nose_radius: Half) {
    let falls = |piece: &&Piece| piece.to.radius < piece.from.radius;
    let down = path.iter().take_while(falls).count();
    let (above, rest) = path.split_at(down);
    let mut rest = rest.to_vec();
    let foot = above.last().map(|last| last.to).or(rest.first().map(|first| first.from));
    let flank = foot.map(|foot| builder.flank(foot, Back::AlongContour)).unwrap_or_default();
    if let Some(top) = flank.first().map(|first| first.from) {
        builder.back_along(top);
        builder.enter(top);
        builder.follow(&flank, Purpose::Infeed, SupportPointRole::AtDepth);
    } else if let Some(first) = rest.first_mut() {
        builder.begin(first, Purpose::PickUp);
    }
    let count = rest.len();
    for (index, piece) in rest.iter().enumerate() {
        let straight = piece.is_cylinder() && piece.from.radius == radius;
        let (purpose, role) = match (straight, index + 1 == count) {
            (true, _) => (Purpose::Cut, SupportPointRole::End),
            (false, true) => (Purpose::PickUp, SupportPointRole::ContourEnd),
            (false, false) => (Purpose::PickUp, SupportPointRole::Corner),
        };
        builder.feed(*piece, purpose, role);
    }
    let here = builder.here();
    if count > 0 && builder.rough().holds(here) {
        // No overrun into the stock of the next section.
        let mut over = builder.rough().onwards(here, nose_radius.to_mm() / 2.0);
        let through = over.iter().position(|piece| !piece.is_face() && !builder.stock.metal(piece).is_empty());
        over.truncate(through.unwrap_or(over.len()));
        builder.follow(&over, Purpose::PickUp, SupportPointRole::Overrun);
        rest.extend(over);
    }
    builder.passed(rest);
}
