//! Zigzag (виток, зиґзаґ; lecture l. 326-330): cuts in both directions.

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::toolpath::Purpose;

use super::builder::{SupportPointRole, ToolpathBuilder};
use super::split::{BlankSection, Split};
use super::straight::Back;

/// The end of the level where the tool is after a pass.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    Near,
    Far,
}

/// Straight passes in both directions.
///
/// 1. The tool cuts a level towards the chuck, to the contour ahead.
/// 2. There it moves down along the contour to the next level, at the infeed rate, which removes the ridge between
///    the two levels. If the zone is open at that end it moves straight down.
/// 3. It cuts that level back towards the free end, and out of the metal if the zone is open.
/// 4. It moves down to the next level: through air if the zone is open, along the falling flank if it is closed.
///
/// Only every second ridge of the far flank is cut, but all ridges of a falling flank. Suitable for zones of every kind
/// (l. 328-330). After a hump has divided a level, the other side begins again towards the chuck.
pub fn work(builder: &mut ToolpathBuilder<'_>, split: &Split) {
    for section in &split.sections {
        below(builder, section, 0, (section.from, section.to), End::Near);
    }
}

fn below(builder: &mut ToolpathBuilder<'_>, section: &BlankSection, index: usize, within: (Half, Half), at: End) {
    let Some(&radius) = section.horizontals.get(index) else { return };
    let mut spans = builder.rough().spans(radius, within.0, within.1);
    if at == End::Far {
        spans.reverse();
    }
    let mut came = Some((at, builder.here()));
    for (from, to) in spans {
        let span = Piece::line(Point { radius, z: from }, Point { radius, z: to });
        let mut end = End::Near;
        if let Some(pass) = builder.trimmed(&[span]).first() {
            end = cut(builder, *pass, came.take().filter(|_| index > 0));
        }
        below(builder, section, index + 1, (from, to), end);
    }
}

/// Cuts a level from the end where the tool is, and returns the end where it is then.
fn cut(builder: &mut ToolpathBuilder<'_>, pass: Piece, came: Option<(End, Point)>) -> End {
    let down = came.filter(|(end, _)| *end == End::Far).and_then(|(_, here)| down_far(builder, pass.to, here));
    if let Some(down) = down {
        builder.follow(&down, Purpose::Infeed, SupportPointRole::AtDepth);
        let out = builder.side_start(pass.from).unwrap_or(pass.from);
        builder.straight(out, Purpose::Cut, SupportPointRole::End);
        builder.passed(Vec::new());
        return End::Near;
    }
    let flank = builder.flank(pass.from, Back::ThroughAir);
    match flank.first() {
        Some(first) => {
            builder.enter(first.from);
            builder.follow(&flank, Purpose::Infeed, SupportPointRole::AtDepth);
            builder.feed(pass, Purpose::Cut, SupportPointRole::End);
            builder.passed(Vec::new());
        }
        None => {
            builder.pass(&[pass], Purpose::Cut, SupportPointRole::End);
        }
    }
    End::Far
}

/// The path down along the contour from the end of the last pass to the far end of this one; none if they are not
/// connected.
fn down_far(builder: &ToolpathBuilder<'_>, to: Point, here: Point) -> Option<Vec<Piece>> {
    if to.z > here.z {
        return None;
    }
    let along = builder.rough().clamped(to.radius, here.radius, to.z, here.z);
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
