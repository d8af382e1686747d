//! The metal, as a region of the half-plane.

use crate::plane::{Convex, Region, Rule, Vector};
use crate::set_up::Piece;
use crate::units::{At, CubicMm, Mm};

/// The blank, or the metal remaining after motions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stock(pub(crate) Region);

impl Stock {
    /// The metal between an outer chain and a bore, or the axis; both chains run from the free end towards the chuck.
    pub fn between(outer: &[Piece], bore: &[Piece]) -> Self {
        Self(between(&spots(outer), &spots(bore)))
    }

    /// A round blank, with its bore if it has one, from the end at the chuck to the free end.
    pub fn cylinder(radius: Mm, bore: Option<Mm>, chuck_end: Mm, free_end: Mm) -> Self {
        let inner = bore.unwrap_or_default();
        let corners = Convex::rectangle(At::new(chuck_end, inner).spot(), At::new(free_end, radius).spot());
        Self(Region::enclosed([corners.to_vec()]))
    }

    /// Its volume.
    pub fn volume(&self) -> CubicMm {
        CubicMm(self.0.turned_volume())
    }

    /// Clamped by its other end: the part has this length, with its free end at Z0 before and after.
    #[must_use]
    pub fn turned_over(&self, length: Mm) -> Self {
        Self(self.0.mirrored(-length.0))
    }

    /// Its connected pieces that reach nearer to the free end than a place: what lies wholly behind was cut off.
    #[must_use]
    pub fn before(&self, place: Mm) -> Self {
        let reaches = |piece: &Region| piece.window().most.z > place.0;
        let whole = |piece: Region| self.0.made(&piece, Rule::Both);
        let kept = self.0.outer_pieces().filter(reaches).map(whole);
        Self(kept.reduce(|all, piece| all.made(&piece, Rule::Either)).unwrap_or_default())
    }

    /// Its outlines, for drawings: outer ones counter-clockwise with Z to the right and the radius up, those of
    /// cavities clockwise.
    pub fn outlines(&self) -> Vec<Vec<At>> {
        self.0.chains().map(|chain| chain.into_iter().map(At::of).collect()).collect()
    }

    /// Where the metal between two places along the axis has its least outer radius: the stretch nearest to the first place, which is
    /// the one nearer to the free end; its beginning, and that radius. None if the places are in no such order.
    pub fn thinnest(&self, from: Mm, to: Mm) -> Option<(Mm, Mm)> {
        let inside = |z: f64| z < from.0 && z > to.0;
        let corners = self.0.chains().flatten().map(|spot| spot.z).filter(|z| inside(*z));
        let mut places: Vec<f64> = corners.chain([from.0, to.0]).collect();
        places.sort_by(|a, b| b.total_cmp(a));
        let stretches = places.windows(2).filter(|ends| ends[0] - ends[1] > STRETCH);
        let each = stretches.map(|ends| (ends[0], self.outer_radius((ends[0] + ends[1]) / 2.0)));
        each.reduce(|thin, one| if one.1 < thin.1 { one } else { thin }).map(|(z, radius)| (Mm(z), Mm(radius)))
    }

    /// The largest radius of the metal at a Z; 0 where there is none.
    fn outer_radius(&self, z: f64) -> f64 {
        let crossed = self.0.edges().filter(|(a, b)| (a.z - z) * (b.z - z) < 0.0);
        crossed.map(|(a, b)| a.r + (b.r - a.r) * (z - a.z) / (b.z - a.z)).fold(0.0, f64::max)
    }

    /// Whether there is metal at a place.
    pub fn holds(&self, at: At) -> bool {
        self.0.holds(at.spot())
    }
}

/// Shorter stretches along the axis are the grid of regions, mm.
const STRETCH: f64 = 0.0005;

/// The corners of a chain.
fn spots(chain: &[Piece]) -> Vec<Vector> {
    let mut all: Vec<Vector> = Vec::new();
    for path in chain {
        all.extend(path.spots().into_iter().skip(usize::from(!all.is_empty())));
    }
    all
}

/// The region between two chains that run from the free end towards the chuck; the axis replaces a missing bore.
pub(crate) fn between(outer: &[Vector], bore: &[Vector]) -> Region {
    let on_axis = |spot: Option<&Vector>| spot.map(|spot| Vector::new(spot.z, 0.0));
    let mut chain = outer.to_vec();
    match (bore.first(), bore.last()) {
        (Some(_), Some(end)) => {
            // A blind bore ends on the axis, along which the metal continues.
            if end.r <= 0.0 {
                chain.extend(on_axis(outer.last()));
            }
            chain.extend(bore.iter().rev());
        }
        _ => {
            chain.extend(on_axis(outer.last()));
            chain.extend(on_axis(outer.first()));
        }
    }
    Region::enclosed([chain])
}
