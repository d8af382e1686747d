//! The stock over the rough contour of a side, in the coordinates of its set-up.

use super::Stage;
use super::drill::{self, Drilled};
use super::opened;
use super::tools::{self, Bench};
use super::{clip, turned_before};
use crate::error::KnowledgeError;
use crate::note::{Finding, Note, Severity};
use crate::turning::contour::{Contour, Piece, Side};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::workpiece::Workpiece;
use crate::turning::zones::SetUp;
use crate::units::Micrometres;

/// The smallest hole that a bar of the catalog enters which reaches so deep, or any bar where none does; none if one enters
/// every hole, or if there is none.
fn least_bar(deep: Half, bench: &Bench<'_, '_>) -> Result<Option<Micrometres>, KnowledgeError> {
    let bars = tools::candidates(Side::Inner, Stage::Roughing, bench)?;
    let bars: Vec<_> =
        bars.iter().map(|bar| tools::angles(bar, bench.knowledge)).collect::<Result<_, KnowledgeError>>()?;
    let least = |reaching: bool| {
        let bars = bars.iter().filter(|bar| !reaching || bar.reach.is_none_or(|reach| reach >= deep));
        bars.map(|bar| bar.least_bore.unwrap_or_default()).min()
    };
    Ok(least(true).or_else(|| least(false)))
}

/// The stock over a rough contour in the coordinates of the set-up.
pub(super) struct SideStock {
    /// The blank, or the hole drilled into it.
    pub blank: Contour,
    /// The rough contour within the range of the blank.
    pub rough: Contour,
    pub drilled_first: Option<Drilled>,
}

pub(super) fn standing(
    rough: &Contour,
    face_is_made: bool,
    axial: Option<Micrometres>,
    set_up: &SetUp,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Option<SideStock>, KnowledgeError> {
    let workpiece = bench.workpiece;
    let (Some(start), Some(end)) = (rough.start(), rough.end()) else { return Ok(None) };
    let seen = |contour: &Contour| set_up.sees(contour, workpiece.length());
    let reach = |contour: &Contour| {
        let from = contour.start().map_or(start.z, |first| first.z).min(start.z);
        let mut clipped = clip::between(contour, from, end.z);
        // The face of the blank's free end.
        if let Some(first) = contour.pieces.first().filter(|first| first.is_face())
            && clipped.pieces.first() != Some(first)
        {
            clipped.pieces.insert(0, *first);
        }
        clipped
    };
    if rough.side == Side::Outer {
        let outer = seen(&workpiece.blank.outer);
        // The far face of a bar is not drawn.
        let within = workpiece.blank.inner.as_ref().and_then(Contour::end).map_or(Half::ZERO, |end| end.radius);
        let outer = if set_up.turned_over { outer.with_face(within) } else { outer };
        let blank = reach(&outer);
        let blank = match &bench.turned {
            Some(turned) => turned_before::standing(blank, turned),
            None => blank,
        };
        let rough = behind_blank(rough, &blank, face_is_made, findings);
        return Ok(Some(SideStock { blank, rough, drilled_first: None }));
    }
    let (raw, there) = (workpiece.blank.inner.as_ref(), bench.raw_bore());
    let least_bar = least_bar(end.z, bench)?;
    let enters = |hole: Micrometres| least_bar.is_none_or(|least| least <= hole);
    if axial.is_none() && bench.opened > there && enters(bench.opened) {
        let blank = opened::wall(bench.opened, start.z, end.z);
        return Ok(Some(SideStock { blank, rough: rough.clone(), drilled_first: None }));
    }
    if let Some(inner) = raw.filter(|_| axial.is_none_or(|axial| axial <= there))
        && enters(there)
    {
        return Ok(Some(SideStock { blank: reach(&seen(inner)), rough: rough.clone(), drilled_first: None }));
    }
    let there = axial.unwrap_or_default().max(there).max(bench.opened);
    let drilled = drill::before_boring(rough, there, least_bar, bench.knowledge, findings)?;
    Ok(drilled.map(|(drilled, rough)| SideStock {
        blank: drilled.contour(&rough),
        rough,
        drilled_first: Some(drilled),
    }))
}

/// The rough contour from the beginning of the blank on. If the stock on the face is less than its allowance, there is
/// a finding, unless the face is made before.
fn behind_blank(rough: &Contour, blank: &Contour, face_is_made: bool, findings: &mut Vec<Finding>) -> Contour {
    let (Some(start), Some(raw), Some(end)) = (rough.start(), blank.start(), rough.end()) else { return rough.clone() };
    if start.z >= raw.z {
        return rough.clone();
    }
    let note = Note::new("face-stock-thin").with("lack", raw.z - start.z);
    findings.extend((!face_is_made).then(|| Finding::of_part(Severity::Doubtful, note)));
    let mut clipped = clip::between(rough, raw.z, end.z);
    if let Some(first) = clipped.start() {
        let face = Piece::line(Point { radius: start.radius, z: raw.z }, first);
        if !face.is_nothing() && first.z == raw.z {
            clipped.pieces.insert(0, face);
        }
    }
    clipped
}

/// The far face of the part up to the beginning of its contour; it is the free face of a part that is turned over. None
/// if the contour has a face itself, and in the first set-up.
pub(super) fn far_face(begins: Point, set_up: &SetUp, side: Side, workpiece: &Workpiece) -> Option<Piece> {
    let bore = workpiece.inner.as_ref().and_then(|inner| inner.contour().end());
    let within = bore.filter(|end| end.z == workpiece.length()).map_or(Half::ZERO, |end| end.radius);
    let face = Piece::line(Point { radius: within, z: begins.z }, begins);
    (set_up.turned_over && side == Side::Outer && begins.radius > within).then_some(face)
}
