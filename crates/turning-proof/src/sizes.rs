//! Diameters and lengths with limits, measured on the stock after all motions.

use crate::carry::Carried;
use crate::fault::{Fault, What};
use crate::plane::{Vector, Window};
use crate::set_up::{Limits, ProfilePiece};
use crate::units::{At, Block, Mm};

/// A size that lies so little outside of its limits is within them, mm: programs are written to a micrometre.
const ROUNDING: f64 = 0.0005;
/// How far from its contour a surface is looked for, mm; farther off it is not made at all.
const NEAR: f64 = 0.5;
/// The width of a measuring point, mm.
const WIDTH: f64 = 0.02;
/// How far from both ends of a surface it is measured, where noses leave their roundings: a share of its length, at most so many mm.
const MARGIN: (f64, f64) = (0.3, 3.0);
/// The number of places.
const PLACES: usize = 5;

/// Compares each size that has limits with them. Metal that is left or cut there otherwise is then not told once more.
pub fn hold(carried: &mut Carried<'_>) {
    let found: Vec<Fault> = carried.drawn().filter_map(|(piece, outside)| measured(carried, piece, outside)).collect();
    for fault in found {
        let told = |other: &Fault| match other.what {
            What::Stands { thickness: by, .. } | What::Gouge { depth: by } => other.whose == fault.whose && by.0 < NEAR,
            _ => false,
        };
        carried.faults.without(told);
        carried.faults.add(fault);
    }
}

/// The worst place of a surface, if it is outside of its limits.
fn measured(carried: &Carried<'_>, piece: &ProfilePiece, outside: bool) -> Option<Fault> {
    let limits = piece.limits?;
    let (from, to) = (piece.path.from().spot(), piece.path.to().spot());
    let path = to.minus(from);
    // Away from the metal.
    let out = path.unit().right().times(if outside { 1.0 } else { -1.0 });
    let margin = (MARGIN.0 * path.length()).min(MARGIN.1);
    let places = (0..PLACES).map(|index| {
        let along = margin + index as f64 / (PLACES - 1) as f64 * (path.length() - 2.0 * margin);
        from.plus(path.unit().times(along))
    });
    let off = |drawn: Vector| {
        let beyond = edge_at(carried, drawn, out)?;
        let spot = drawn.plus(out.times(beyond));
        let size = limits.size(limits.of(spot));
        let outside_by = (limits.least.0 - size).max(size - limits.most.0) - ROUNDING;
        Some((outside_by, beyond, size, spot)).filter(|one| one.0 > 0.0)
    };
    let (_, beyond, size, spot) = places.filter_map(off).max_by(|a, b| a.0.total_cmp(&b.0))?;
    let block: Option<Block> = carried.cut_at(spot).map(|motion| motion.block);
    // Told to a micrometre, as programs have it.
    let measured = Mm((1000.0 * size).round() / 1000.0);
    let Limits { size, least, most } = limits;
    let what = What::OffSize { size, measured, least, most, missing: beyond < 0.0 };
    Some(Fault::of_surface(what, piece.surface.clone(), Some(At::of(spot)), block))
}

/// How far from a place of the contour the edge of the stock lies, outwards; none if it is not near.
fn edge_at(carried: &Carried<'_>, drawn: Vector, out: Vector) -> Option<f64> {
    let along = out.right().times(WIDTH / 2.0);
    let across = out.times(NEAR);
    let corners =
        [along.plus(across), across.minus(along), along.minus(across), Vector::default().minus(along).minus(across)];
    let metal = carried.stock.0.within(Window::around(corners.map(|corner| drawn.plus(corner))));
    let window = metal.window();
    let ends = [window.least, window.most].map(|corner| corner.minus(drawn).dot(out));
    let beyond = ends[0].max(ends[1]);
    (!metal.is_empty() && beyond.abs() < NEAR - WIDTH).then_some(beyond)
}
