//! Where the blank has less stock than the finishing allowance, or none at all.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::Severity;
use crate::tables::turning::part::{StockKind, TurningBlankSurfaceFor};
use crate::turning::contour::{Contour, Piece, Side, Surface};
use crate::turning::length::Half;
use crate::turning::transitions::in_process_stock::InProcessStock;
use crate::turning::transitions::monotone::{MonotoneContour, clipped};

/// A rough contour that is nowhere outside of its blank: what the blank has less than the allowance is left to finishing alone.
/// Unchanged where there is enough everywhere.
pub(super) fn within(rough: Contour, blank: &Contour) -> Contour {
    let top = [&rough, blank].into_iter().filter_map(Contour::radii).map(|(_, most)| most).max().unwrap_or(Half::ZERO);
    let seen = |contour: &Contour| match rough.side {
        Side::Outer => contour.clone(),
        Side::Inner => contour.inside_out(top),
    };
    let (own, lid) = (seen(&rough), MonotoneContour::of(&seen(blank)));
    let mut stock = InProcessStock::of(&MonotoneContour::of(&own));
    let lids: Vec<&Piece> = lid.pieces.iter().filter(|piece| !piece.is_face()).collect();
    if lids.iter().all(|piece| stock.metal(piece).is_empty()) {
        return rough;
    }
    lids.into_iter().for_each(|piece| stock.lower(piece));
    let ends = [own.start(), own.end()].map(|end| end.map(|end| end.z));
    let lowered = Contour { side: Side::Outer, pieces: with_faces(&own, tops(&stock)) };
    let reaches = [lowered.start(), lowered.end()].map(|end| end.map(|end| end.z)) == ends;
    match rough.side {
        _ if !reaches || !lowered.is_monotone() || !lowered.hangs_together() => rough,
        Side::Outer => lowered,
        Side::Inner => lowered.inside_out(top),
    }
}

/// The surface of a stock, with its steps as faces.
fn tops(stock: &InProcessStock) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    for top in stock.cells().iter().filter_map(|cell| clipped(&cell.top, cell.from, cell.to)) {
        match pieces.last_mut() {
            Some(last) if last.is_cylinder() && top.is_cylinder() && last.to == top.from => last.to = top.to,
            Some(last) => {
                let face = Piece::line(last.to, top.from);
                pieces.extend([face, top].into_iter().filter(|piece| !piece.is_nothing()));
            }
            None => pieces.push(top),
        }
    }
    pieces
}

/// Lowered pieces with the faces of the contour at its ends.
fn with_faces(own: &Contour, mut pieces: Vec<Piece>) -> Vec<Piece> {
    let (Some(first), Some(last)) = (pieces.first().copied(), pieces.last().copied()) else { return pieces };
    let (before, behind) =
        (own.pieces.first().filter(|face| face.is_face()), own.pieces.last().filter(|face| face.is_face()));
    if let Some(face) = before.filter(|face| face.from.z == first.from.z) {
        pieces.insert(0, Piece::line(face.from, first.from));
    }
    if let Some(face) = behind.filter(|face| face.to.z == last.to.z) {
        pieces.push(Piece::line(last.to, face.to));
    }
    pieces.retain(|piece| !piece.is_nothing());
    pieces
}

/// Whether a surface is a cylinder of the blank itself, which is left as it is.
pub(super) fn is_of_blank(surface: &Surface, blank: &Contour) -> bool {
    !surface.kind.is_additional() && surface.pieces.iter().all(|piece| lies_on(piece, blank))
}

/// How grave it is that a surface stays as the blank has it: a note where the drawing asks nothing of it, else by the rule
/// `turning-blank-surface`.
///
/// # Errors
/// The knowledge base lacks the rule, or a row of it.
pub(super) fn judged(surface: &Surface, stock: StockKind, knowledge: &Knowledge) -> Result<Severity, KnowledgeError> {
    if surface.grade.is_none() && surface.roughness.is_none() {
        return Ok(Severity::Note);
    }
    let question = TurningBlankSurfaceFor { stock, it: surface.grade, roughness: surface.roughness };
    Ok(knowledge.ask(&question)?.need(stock.name())?.severity)
}

/// Whether the skin of the blank stays on a cylinder that keeps so much more on a side for another machine.
pub(super) fn keeps_skin(surface: &Surface, more: Half, blank: &Contour) -> bool {
    let covers = |piece: &Piece| {
        let middle = Half::new((piece.from.z.halves() + piece.to.z.halves()) / 2);
        let radii = blank.radii_at(middle);
        let covered = radii.is_some_and(|(least, most)| match blank.side {
            Side::Outer => piece.from.radius + more >= most,
            Side::Inner => piece.from.radius - more <= least,
        });
        piece.is_cylinder() && covered
    };
    !surface.kind.is_additional() && surface.pieces.iter().all(covers)
}

fn lies_on(piece: &Piece, blank: &Contour) -> bool {
    let middle = Half::new((piece.from.z.halves() + piece.to.z.halves()) / 2);
    let radius = piece.from.radius;
    let there = |z: Half| blank.radii_at(z).is_some_and(|(least, most)| (least..=most).contains(&radius));
    piece.is_cylinder() && [piece.from.z, middle, piece.to.z].into_iter().all(there)
}

/// A contour without the cylinders of the blank at its end.
pub(super) fn worked(mut contour: Contour, blank: &Contour) -> Contour {
    while contour.pieces.last().is_some_and(|last| lies_on(last, blank)) {
        contour.pieces.pop();
    }
    contour
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turning::point::Point;

    fn outer(points: &[(f64, f64)]) -> Contour {
        let at = |(radius, z): &(f64, f64)| Point { radius: Half::from(*radius), z: Half::from(*z) };
        Contour::through(Side::Outer, &points.iter().map(at).collect::<Vec<_>>())
    }

    /// Only where the blank is lower than the allowance the rough contour comes down to it; before, it came up to the blank elsewhere.
    #[test]
    fn what_is_thick_stays_thick() {
        let blank = outer(&[(0.0, -1.0), (30.0, -1.0), (30.0, 14.0), (23.0, 14.0), (23.0, 16.0)]);
        let rough = outer(&[(0.0, -0.5), (13.5, -0.5), (13.5, 6.0), (23.5, 13.0), (23.5, 16.0)]);
        let lowered =
            outer(&[(0.0, -0.5), (13.5, -0.5), (13.5, 6.0), (23.5, 13.0), (23.5, 14.0), (23.0, 14.0), (23.0, 16.0)]);
        assert_eq!(within(rough, &blank), lowered);
    }
}
