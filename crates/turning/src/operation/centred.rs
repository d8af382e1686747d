//! A part at a centre: its end is faced and centred before, because the centre stands where a tool would face it; between centres
//! both ends are.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Finding, Note, Severity};
use crate::turning::contour::{Contour, Piece, Side};
use crate::turning::jobs::hole::centre_hole_for;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::shaft::Holding;
use crate::turning::workpiece::Workpiece;

use super::clip;

/// The part as it comes between the centres: its blank without the stock on both faces, which are made; and the finding that says
/// so. None in a chuck alone, and where nothing stands on the faces.
///
/// # Errors
/// The knowledge base lacks the table of centre holes.
pub(super) fn centred(
    workpiece: &Workpiece,
    knowledge: &Knowledge,
) -> Result<Option<(Workpiece, Finding)>, KnowledgeError> {
    let (blank, length) = (&workpiece.blank, workpiece.length());
    let between = workpiece.holding == Holding::Centres;
    // In a chuck and at a centre the far end is in the jaws.
    let (near, far) = (blank.face(), if between { blank.end() - length } else { Half::ZERO });
    if workpiece.holding == Holding::Chuck || (near <= Half::ZERO && far <= Half::ZERO) {
        return Ok(None);
    }
    let mut made = workpiece.clone();
    let end = if between { length } else { blank.end() };
    let bore = blank.inner.as_ref().and_then(Contour::start).map(|start| start.radius);
    made.blank.outer = faced(&blank.outer, bore.unwrap_or(Half::ZERO), end);
    made.blank.inner = blank.inner.as_ref().map(|inner| clip::between(inner, Half::ZERO, end));
    let ends = made.outer.surfaces.iter_mut().filter(|surface| {
        let at_end = |z: Half| z <= Half::ZERO || between && z >= length;
        surface.pieces.iter().all(|piece| piece.is_face() && at_end(piece.from.z))
    });
    ends.for_each(|surface| surface.stated_allowance = Some(Half::ZERO));
    let far_end = made.blank.outer.pieces.last().filter(|_| between);
    let thinnest = [made.blank.outer.pieces.iter().find(|piece| !piece.is_face()), far_end];
    let thinnest = thinnest.into_iter().flatten().map(|piece| piece.from.radius.min(piece.to.radius)).min();
    let diameter = thinnest.unwrap_or_default().diameter();
    let hole = centre_hole_for(diameter, knowledge)?;
    let note = Note::new(match (between, &hole) {
        (true, _) if bore.is_some() => "ends-faced-hollow",
        (false, _) if bore.is_some() => "end-faced-hollow",
        (true, Some(_)) => "ends-centred-before",
        (true, None) => "ends-faced-before",
        (false, Some(_)) => "end-centred-before",
        (false, None) => "end-faced-before",
    });
    let note = note.with("near", near.max(Half::ZERO));
    let note = if between { note.with("far", far.max(Half::ZERO)) } else { note };
    let note = match hole {
        Some(hole) if bore.is_none() => note.with("pilot", hole.pilot),
        _ => note,
    };
    Ok(Some((made, Finding::of_part(Severity::Doubtful, note))))
}

/// A blank's outside between its made faces, the first down to its bore.
fn faced(outer: &Contour, bore: Half, length: Half) -> Contour {
    let mut faced = clip::between(outer, Half::ZERO, length);
    if let Some(start) = faced.pieces.iter().find(|piece| !piece.is_face()).map(|piece| piece.from) {
        faced.pieces.retain(|piece| !(piece.is_face() && piece.from.z == start.z));
        faced.pieces.insert(0, Piece::line(Point { radius: bore, z: start.z }, start));
    }
    Contour { side: Side::Outer, ..faced }
}
