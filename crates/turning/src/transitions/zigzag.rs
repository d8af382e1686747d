//! Zigzag (виток, зиґзаґ; lecture l. 326-330): cuts on the way there and on the way back.

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::toolpath::Purpose;

use super::builder::{SupportPointRole, ToolpathBuilder};
use super::split::{Section, Split};
use super::straight::Back;

/// Where the tool stands after a pass.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    Near,
    Far,
}

/// Straight passes in both directions.
///
/// 1. The tool cuts a level towards the chuck, to the contour ahead.
/// 2. There it goes down along the contour to the next level, at the feed of cutting in; the ridge between the two levels
///    is gone with that. Where the zone is open at that end it goes straight down.
/// 3. It cuts that level back towards the free end, and out of the metal where the zone is open.
/// 4. It goes down to the next level: through air where the zone is open, along the falling flank where it is closed.
///
/// Only every second ridge of the far flank is cut, those of a falling flank all are. Good for zones of every kind
/// (l. 328-330). After a hump has parted a level, the other side begins anew towards the chuck.
pub fn work(course: &mut ToolpathBuilder<'_>, split: &Split) {
    for section in &split.sections {
        below(course, section, 0, (section.from, section.to), End::Near);
    }
}

fn below(course: &mut ToolpathBuilder<'_>, section: &Section, index: usize, within: (Half, Half), stands: End) {
    let Some(&radius) = section.horizontals.get(index) else { return };
    let mut spans = course.rough().spans(radius, within.0, within.1);
    if stands == End::Far {
        spans.reverse();
    }
    let mut came = Some((stands, course.here()));
    for (from, to) in spans {
        let span = Piece::line(Point { radius, z: from }, Point { radius, z: to });
        let mut end = End::Near;
        if let Some(pass) = course.trimmed(&[span]).first() {
            end = cut(course, *pass, came.take().filter(|_| index > 0));
        }
        below(course, section, index + 1, (from, to), end);
    }
}

/// Cuts a level from the end where the tool stands, and says where it stands then.
fn cut(course: &mut ToolpathBuilder<'_>, pass: Piece, came: Option<(End, Point)>) -> End {
    let down = came.filter(|(end, _)| *end == End::Far).and_then(|(_, here)| down_far(course, pass.to, here));
    if let Some(down) = down {
        course.follow(&down, Purpose::Infeed, SupportPointRole::AtDepth);
        let out = course.side_start(pass.from).unwrap_or(pass.from);
        course.straight(out, Purpose::Cut, SupportPointRole::End);
        course.passed(Vec::new());
        return End::Near;
    }
    let flank = course.flank(pass.from, Back::ThroughAir);
    match flank.first() {
        Some(first) => {
            course.enter(first.from);
            course.follow(&flank, Purpose::Infeed, SupportPointRole::AtDepth);
            course.feed(pass, Purpose::Cut, SupportPointRole::End);
            course.passed(Vec::new());
        }
        None => {
            course.pass(&[pass], Purpose::Cut, SupportPointRole::End);
        }
    }
    End::Far
}

/// The way down along the contour from where the last pass ended to where this one begins at its far end; none where
/// they do not hang together.
fn down_far(course: &ToolpathBuilder<'_>, to: Point, here: Point) -> Option<Vec<Piece>> {
    if to.z > here.z {
        return None;
    }
    let along = course.rough().clamped(to.radius, here.radius, to.z, here.z);
    let mut down: Vec<Piece> = along.iter().rev().map(|piece| piece.reversed()).collect();
    let top = down.first().map_or(to, |first| first.from);
    if top != here {
        if top.z != here.z {
            return None;
        }
        down.insert(0, Piece::line(here, top));
    }
    down.last().is_some_and(|last| last.to == to).then_some(down)
}
