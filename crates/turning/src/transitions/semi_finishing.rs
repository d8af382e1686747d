//! With a semi-finishing pass (з напівчистовим, зачисним проходом; lecture l. 406-432, fig. 12.4 b).

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::toolpath::Purpose;

use super::builder::{SupportPointRole, ToolpathBuilder};
use super::monotone::clipped;
use super::split::Split;
use super::straight::{Back, clear};

/// Straight passes, then one pass along the contour that cuts all ridges.
///
/// 1. The straight passes are those of the loop (1-2-3-4, 5-6-7-8, 9-10-11-12, 13-14 of fig. 12.4 b).
/// 2. After the last one the tool follows the contour, at a feed of its own because the depth varies
///    (14-10-15-6-2-16; l. 412-426). It continues from the end of the last pass if the contour before that point is
///    already clean; otherwise it begins at the first ridge.
/// 3. In a closed zone it returns after each straight pass along the contour of the zone to where the pass began, at
///    the infeed rate, and moves down along the falling flank (l. 468-478).
pub fn work(builder: &mut ToolpathBuilder<'_>, split: &Split) {
    for section in &split.sections {
        clear(builder, section, Back::AlongContour);
    }
    let Some(end) = worked_to(builder) else { return };
    let here = builder.here();
    let (from, to) = builder.zone.worked;
    let ridge = builder
        .rough()
        .touching(from, to)
        .iter()
        .filter(|piece| !piece.is_face())
        .find_map(|piece| builder.stock.metal(piece).first().map(|(from, _)| (*piece, *from)));
    let on_contour = builder.passes > 0 && builder.rough().holds(here);
    match ridge {
        Some((piece, from)) if !on_contour || from < here.z => {
            let start = Point { radius: super::monotone::radius_on(&piece, from), z: from };
            let path = parted(builder, &cut_off(builder, builder.rough().beyond(start), end));
            if builder.passes > 0 {
                builder.draw_back();
            }
            builder.pass(&path, Purpose::SemiFinish, SupportPointRole::ContourEnd);
        }
        _ if on_contour => {
            let path = parted(builder, &cut_off(builder, builder.rough().beyond(here), end));
            if !path.is_empty() {
                builder.follow(&path, Purpose::SemiFinish, SupportPointRole::ContourEnd);
                builder.passed(Vec::new());
            }
        }
        _ => {}
    }
}

/// Z of the end of the stock over the contour.
fn worked_to(builder: &ToolpathBuilder<'_>) -> Option<Half> {
    let (from, to) = builder.zone.worked;
    let pieces = builder.rough().touching(from, to).iter().rev().filter(|piece| !piece.is_face());
    pieces.filter_map(|piece| builder.zone.whole.metal(piece).last().map(|(_, to)| *to)).next()
}

/// A path up to a Z, with the face there only up to the height of the blank.
fn cut_off(builder: &ToolpathBuilder<'_>, path: impl Iterator<Item = Piece>, end: Half) -> Vec<Piece> {
    let part = |piece: Piece| {
        if !piece.is_face() {
            return clipped(&piece, Half::new(i64::MIN), end);
        }
        let blank = builder.zone.whole.sides(piece.from.z).0.unwrap_or(piece.to.radius);
        let top = if piece.from.z == end { piece.to.radius.min(blank) } else { piece.to.radius };
        let kept = piece.from.z < end || piece.from.z == end && top > piece.from.radius;
        kept.then(|| piece.between(piece.from, Point { radius: top, z: piece.from.z }))
    };
    path.take_while(|piece| piece.from.z <= end).filter_map(part).collect()
}

/// A path with a support point wherever a straight pass ended on it, as fig. 12.4 b numbers them (10, 6, 2).
fn parted(builder: &ToolpathBuilder<'_>, path: &[Piece]) -> Vec<Piece> {
    let mut ends: Vec<Point> = builder.ends().collect();
    ends.sort_by_key(|end| end.z);
    let mut parts = Vec::new();
    for piece in path {
        let on = |end: &&Point| {
            let beside = if piece.is_face() {
                end.z == piece.from.z && piece.from.radius < end.radius && end.radius < piece.to.radius
            } else {
                let within = piece.from.z < end.z && end.z < piece.to.z;
                within && (super::monotone::radius_on(piece, end.z) - end.radius).halves().abs() <= 1
            };
            beside && **end != piece.from && **end != piece.to
        };
        let (_, beside) = ends.split_at(ends.partition_point(|end| end.z < piece.from.z));
        let mut cuts: Vec<Point> = beside.iter().take_while(|end| end.z <= piece.to.z).filter(on).copied().collect();
        cuts.sort_by_key(|cut| {
            (cut.z, if piece.to.radius >= piece.from.radius { cut.radius } else { Half::ZERO - cut.radius })
        });
        cuts.dedup();
        cuts.push(piece.to);
        let mut from = piece.from;
        for to in cuts {
            parts.push(piece.between(from, to));
            from = to;
        }
    }
    parts
}
