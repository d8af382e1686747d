//! Straight passes, level under level: what the loop and the scheme with a semi-finishing pass have in common.

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::toolpath::Purpose;

use super::builder::{SupportPointRole, ToolpathBuilder};
use super::split::Section;

/// How the tool comes back from a pass that began on a falling flank. One that began in the open always comes back
/// through air.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Back {
    /// Drawn back, and over the pass to its beginning.
    ThroughAir,
    /// Along the contour of the zone, at the feed of cutting in (l. 468-478).
    AlongContour,
}

/// Clears a section by straight passes.
///
/// 1. Each level is cut wherever the contour is not above it, towards the chuck, up to the contour ahead.
/// 2. Between two passes the tool is drawn back by the retract, returns to the vertical of its start as a rapid, and goes
///    down to the next depth (l. 314-318).
/// 3. Where a pass begins on a falling flank, the tool follows the flank to its depth at the feed of cutting in.
/// 4. Where a hump parts a level, one side is finished to its bottom before the other.
pub fn clear(course: &mut ToolpathBuilder<'_>, section: &Section, back: Back) {
    course.leave_trail();
    below(course, section, 0, (section.from, section.to), back);
}

fn below(course: &mut ToolpathBuilder<'_>, section: &Section, index: usize, within: (Half, Half), back: Back) {
    let Some(&radius) = section.horizontals.get(index) else { return };
    for (from, to) in course.rough().spans(radius, within.0, within.1) {
        let span = Piece::line(Point { radius, z: from }, Point { radius, z: to });
        if let Some(pass) = course.trimmed(&[span]).first() {
            cut(course, *pass, back);
        }
        below(course, section, index + 1, (from, to), back);
    }
}

fn cut(course: &mut ToolpathBuilder<'_>, pass: Piece, back: Back) {
    let flank = course.flank(pass.from, back);
    let Some(top) = flank.first().map(|first| first.from) else {
        if course.passes > 0 {
            course.draw_back();
        }
        course.pass(&[pass], Purpose::Cut, SupportPointRole::End);
        return;
    };
    if back == Back::AlongContour {
        course.back_along(top);
    }
    if course.here() != top && course.passes > 0 {
        course.draw_back();
    }
    course.enter(top);
    course.follow(&flank, Purpose::Infeed, SupportPointRole::AtDepth);
    course.feed(pass, Purpose::Cut, SupportPointRole::End);
    course.passed(vec![pass]);
}
