//! What decides the allowance of a surface: its place, its size and that of the part.

use crate::turning::contour::{Profile, Side, Surface, SurfaceKind};
use crate::turning::length::Half;
use crate::units::Micrometres;

pub use crate::tables::turning::part::Place;

/// Where a surface on that side of the part lies. Cones and arcs count as cylinders.
pub fn place(surface: &Surface, side: Side) -> Place {
    on(side, surface.kind == SurfaceKind::Face || surface.pieces.iter().all(|piece| piece.is_face()))
}

/// The place on a side of the part, of a face or of what lies along the axis.
pub const fn on(side: Side, face: bool) -> Place {
    match side {
        _ if face => Place::Face,
        Side::Outer => Place::Outer,
        Side::Inner => Place::Inner,
    }
}

/// The allowance of a table, on one side. The tables give it on the diameter, except for faces.
pub const fn on_side(place: Place, allowance: Micrometres) -> Half {
    match place {
        Place::Face => Half::of(allowance),
        Place::Outer | Place::Inner => Half::radius_of(allowance),
    }
}

/// The largest diameter of a surface.
pub fn diameter(surface: &Surface) -> Micrometres {
    surface.pieces.iter().map(|piece| piece.radii().1).max().unwrap_or_default().diameter()
}

/// The length of the part, from the ends of its contour, in whole micrometres.
pub fn length(profile: &Profile) -> Micrometres {
    let contour = profile.contour();
    match (contour.start(), contour.end()) {
        (Some(start), Some(end)) => Micrometres::new((end.z - start.z).halves() / 2),
        _ => Micrometres::new(0),
    }
}

/// The size for a query of the allowance tables; they begin above zero.
pub(super) fn query_size(size: Micrometres) -> Micrometres {
    size.max(Micrometres::new(1))
}
