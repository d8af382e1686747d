//! Straight passes, level by level: the common part of the loop and of the scheme with a semi-finishing pass.

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::toolpath::Purpose;

use super::builder::{SupportPointRole, ToolpathBuilder};
use super::split::BlankSection;

/// The return of the tool from a pass that began on a falling flank. From a pass that began outside of metal it
/// always returns through air.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Back {
    /// Retracted, and above the pass to its beginning.
    ThroughAir,
    /// Along the contour of the zone, at the infeed rate (l. 468-478).
    AlongContour,
}

/// Clears a section by straight passes.
///
/// 1. Each level is cut wherever the contour is not above it, towards the chuck, up to the contour ahead.
/// 2. Between two passes the tool retracts, returns to the vertical of its start as a rapid, and moves down to the
///    next depth (l. 314-318).
/// 3. If a pass begins on a falling flank, the tool follows the flank to its depth at the infeed rate.
/// 4. Stock that the levels of earlier sections have left in the way of a pass is cut with it.
/// 5. If a hump divides a level, one side is finished to its bottom before the other.
pub fn clear(builder: &mut ToolpathBuilder<'_>, section: &BlankSection, back: Back) {
    builder.leave_trail();
    below(builder, section, 0, (section.from, section.to), back);
}

fn below(builder: &mut ToolpathBuilder<'_>, section: &BlankSection, index: usize, within: (Half, Half), back: Back) {
    let Some(&radius) = section.horizontals.get(index) else { return };
    for (from, to) in builder.rough().spans(radius, within.0, within.1) {
        let begins = if from == section.from { beginning(builder, radius, (from, to)) } else { from };
        let span = Piece::line(Point { radius, z: begins }, Point { radius, z: to });
        if let Some(pass) = builder.trimmed(&[span]).first() {
            cut(builder, *pass, back);
        }
        below(builder, section, index + 1, (from, to), back);
    }
}

/// Where a pass over the beginning of a section begins: stock that the levels of earlier sections left above its
/// radius is cut with it, or the tool would plunge through it.
fn beginning(builder: &ToolpathBuilder<'_>, radius: Half, (from, to): (Half, Half)) -> Half {
    let over = builder.rough().spans(radius, builder.zone.worked.0.min(from), to);
    over.into_iter().find(|(begins, ends)| *begins <= from && from < *ends).map_or(from, |(begins, _)| begins)
}

fn cut(builder: &mut ToolpathBuilder<'_>, pass: Piece, back: Back) {
    let flank = builder.flank(pass.from, back);
    let Some(top) = flank.first().map(|first| first.from) else {
        if builder.passes > 0 {
            builder.draw_back();
        }
        builder.pass(&[pass], Purpose::Cut, SupportPointRole::End);
        return;
    };
    if back == Back::AlongContour {
        builder.back_along(top);
    }
    if builder.here() != top && builder.passes > 0 {
        builder.draw_back();
    }
    builder.enter(top);
    builder.follow(&flank, Purpose::Infeed, SupportPointRole::AtDepth);
    builder.feed(pass, Purpose::Cut, SupportPointRole::End);
    builder.passed(vec![pass]);
}
