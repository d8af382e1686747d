//! What a zone and a tool must be, before a way is made over them.

use crate::error::{Refusal, Tried};
use crate::note::Note;
use crate::turning::contour::{Contour, Piece};
use crate::turning::length::Half;

use super::ground::{Ground, clipped, radius_on};
use super::standing::Standing;
use super::{Scheme, Settings, Stock, Tool};

/// What the rounding of points may do to an angle.
const ROUNDING_DEGREES: f64 = 0.01;

/// Whether ways can be made at all.
///
/// # Errors
/// A reason, each with its remedy in the sentences: contours that do not hang together, lead back, differ in their
/// stretch of Z or in their side; a rough contour above its blank; lengths that are not positive; a contour steeper than
/// the tool's angles; a way against a stop over a contour that is not stepped.
pub fn check(
    stock: &Stock,
    ground: &Ground,
    blank: &Ground,
    tool: &Tool,
    settings: &Settings,
    scheme: Scheme,
) -> Tried<()> {
    let not = |note: Note| Err(Refusal::Not(note));
    for (name, contour) in [("rough", &stock.rough), ("blank", &stock.blank)] {
        if contour.pieces.is_empty() || !contour.hangs_together() || !contour.is_monotone() {
            return not(Note::new("zone-contour-not-monotone").with("contour", name));
        }
    }
    if stock.rough.side != stock.blank.side || !same_stretch(stock, ground, blank) {
        return not(Note::new("zone-contours-differ"));
    }
    if settings.depth <= Half::ZERO || settings.approach <= Half::ZERO || settings.retract <= Half::ZERO {
        return not(Note::new("zone-settings-not-positive"));
    }
    if let Some(z) = above(ground, blank) {
        return not(Note::new("rough-above-blank").with("z", Half::ZERO - z));
    }
    if scheme == Scheme::LoopAgainstStop && !is_roller(&stock.rough, ground) {
        return not(Note::new("stop-needs-steps"));
    }
    let steep = ground.pieces.iter().find_map(|piece| too_steep(piece, tool));
    if let Some((piece, angle, limit)) = steep.filter(|_| scheme != Scheme::Descent) {
        let note = Note::new("flank-too-steep").with("z", Half::ZERO - piece.from.z);
        return not(note.with("angle", crate::units::round_to(angle, 2)).with("limit", limit));
    }
    Ok(())
}

fn same_stretch(stock: &Stock, ground: &Ground, blank: &Ground) -> bool {
    let (from, to) = (stock.from, stock.to);
    from < to && [ground, blank].iter().all(|one| one.from() == from && one.to() == to)
}

/// Where a rough contour is above its blank.
fn above(ground: &Ground, blank: &Ground) -> Option<Half> {
    let standing = Standing::of(blank);
    let over = |piece: &Piece| {
        standing.cells().iter().find_map(|cell| {
            let top = clipped(&cell.top, piece.from.z.max(cell.from), piece.to.z.min(cell.to))?;
            let middle = Half::new((top.from.z + top.to.z).halves().div_euclid(2));
            let places = [top.from.z, middle, top.to.z];
            places.into_iter().find(|z| (radius_on(piece, *z) - radius_on(&top, *z)).halves() > 1)
        })
    };
    ground.pieces.iter().filter(|piece| !piece.is_face()).find_map(over)
}

/// Cylinders and faces that rise towards the chuck.
fn is_roller(rough: &Contour, ground: &Ground) -> bool {
    rough.is_stepped() && ground.pieces.iter().all(|piece| piece.to.radius >= piece.from.radius)
}

/// A piece that rises more steeply than the main angle, or falls more steeply than the secondary one: its steepest angle,
/// and the limit.
fn too_steep<'p>(piece: &'p Piece, tool: &Tool) -> Option<(&'p Piece, f64, f64)> {
    let angles = [piece.direction_at_start().degrees(), piece.direction_at_end().degrees()];
    let rises = piece.to.radius > piece.from.radius;
    let angle = angles.iter().map(|angle| libm::fabs(*angle)).fold(0.0, libm::fmax);
    let limit = if rises { tool.main.0 } else { tool.secondary.0 };
    (piece.from.radius != piece.to.radius && angle > limit + ROUNDING_DEGREES).then_some((piece, angle, limit))
}
