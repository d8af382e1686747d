//! Joins neighbouring parts into one zone (lecture 12.4, l. 522-546, fig. 12.5): a zone has as many surfaces as one
//! tool reaches, so that there are few tools and few returns of the tool.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::turning::contour::Side;
use crate::turning::length::Half;

use super::fit::{ToolAngles, refusals};
use super::kind::{Bounds, Circumstances, ZoneKind, scheme, together};
use super::parts::{Needs, ZonePart};
use super::{Feed, NOTHING, Stock, Zone};

/// Groups of neighbours, each as long as one of the tools reaches all of it. Built from one end, these are the fewest
/// groups. A part that no tool reaches is a group of its own.
pub(super) fn groups(parts: Vec<ZonePart>, tools: &[ToolAngles]) -> Vec<Vec<ZonePart>> {
    let mut groups: Vec<Vec<ZonePart>> = Vec::new();
    for part in parts {
        let reach = |group: &[ZonePart]| {
            let touches = group.last().is_some_and(|last| last.to_z == part.from_z);
            let needs = group.iter().fold(part.needs, |sum, one| sum.and(one.needs));
            // A grooving tool plunges: it reaches one groove, and nothing beside it.
            let mut passing = tools.iter().filter(|tool| tool.width.is_none());
            touches && passing.any(|tool| refusals(needs, None, None, tool).is_empty())
        };
        match groups.last_mut().filter(|group| reach(group)) {
            Some(group) => group.push(part),
            None => groups.push(vec![part]),
        }
    }
    groups
}

/// A zone of parts, which are in the order of Z.
///
/// # Errors
/// The knowledge base lacks the rule `turning-zone` or `turning-scheme`, or a row of one.
pub(super) fn zone(
    parts: Vec<ZonePart>,
    feed: Feed,
    stock: Stock<'_>,
    knowledge: &Knowledge,
) -> Result<Zone, KnowledgeError> {
    let kinds: Vec<(ZoneKind, Bounds)> = parts.iter().map(|part| (part.kind, part.bounds)).collect();
    let classified = together(&kinds, knowledge)?;
    let shaped = parts.iter().any(|part| part.contour.iter().any(|piece| !piece.is_face() && !piece.is_cylinder()));
    let circumstances = Circumstances { shaped, near_part: stock.near_part, against_stop: stock.against_stop };
    let nothing = Needs { main: NOTHING, secondary: NOTHING };
    let (from_z, to_z) =
        (parts.first().map_or(Half::ZERO, |first| first.from_z), parts.last().map_or(Half::ZERO, |last| last.to_z));
    let mut zone = Zone {
        number: 1,
        side: stock.rough.side,
        feed,
        from_z,
        to_z,
        least_radius: parts.iter().map(|part| part.least_radius).min().unwrap_or_default(),
        greatest_radius: parts.iter().map(|part| part.greatest_radius).max().unwrap_or_default(),
        kind: classified.kind,
        needs: parts.iter().fold(nothing, |sum, part| sum.and(part.needs)),
        passage: (stock.rough.side == Side::Inner).then(|| passage(stock, from_z, to_z).diameter()),
        scheme: scheme(&classified, circumstances, knowledge)?,
        because: classified.because,
        parts,
    };
    zone.parts.sort_by_key(|part| part.kind);
    Ok(zone)
}

/// The least radius that a boring bar passes on its way through a zone: before the zone that of the roughed hole,
/// inside it that of the drilled hole.
fn passage(stock: Stock<'_>, from: Half, to: Half) -> Half {
    let least = |contour: &crate::turning::contour::Contour, inside: &dyn Fn(Half) -> bool| {
        let ends = contour.pieces.iter().flat_map(|piece| piece.extremes());
        ends.filter(|at| inside(at.z)).map(|at| at.radius).min()
    };
    let before = least(stock.rough, &|z| z < from);
    let along = [from, to].into_iter().filter_map(|z| stock.blank.radii_at(z)).map(|(least, _)| least).min();
    let inside = least(stock.blank, &|z| from < z && z < to);
    [before, along, inside].into_iter().flatten().min().unwrap_or_default()
}

/// The number of returns that joining saves on the same levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Returns {
    /// The depth of the levels, mm.
    pub depth_mm: Half,
    /// With each part cleared separately (fig. 12.5 а).
    pub split: usize,
    /// With passes that continue over neighbouring parts (fig. 12.5 б, в).
    pub joined: usize,
    /// The difference.
    pub saved: usize,
}

/// Counts the passes of a zone, after each of which the tool returns, with levels of one depth down from the greatest
/// radius of the blank. In a joined zone a pass continues over a neighbour if the border between them is not above
/// the level.
///
/// There are no passes for a depth that is not above zero.
pub fn idle_returns(zone: &Zone, depth: Half) -> Returns {
    let mut parts: Vec<&ZonePart> = zone.parts.iter().collect();
    parts.sort_by_key(|part| part.from_z);
    if depth <= Half::ZERO {
        return Returns { depth_mm: depth, split: 0, joined: 0, saved: 0 };
    }
    let top = parts.iter().map(|part| part.top).max().unwrap_or_default();
    let lowest = parts.iter().map(|part| part.floor).min().unwrap_or_default();
    let (mut split, mut joined) = (0, 0);
    let mut above = top;
    while above > lowest {
        let here = |part: &ZonePart| part.floor < above && part.top > above - depth;
        let mut before: Option<&ZonePart> = None;
        for part in &parts {
            let goes_on = before.is_some_and(|before| before.to_z == part.from_z && before.border <= above - depth);
            if here(part) {
                split += 1;
                joined += usize::from(!goes_on);
            }
            before = Some(*part).filter(|part| here(part));
        }
        above = above - depth;
    }
    Returns { depth_mm: depth, split, joined, saved: split - joined }
}
