//! Faces whose distance from the free end has limits: they are made in the middle of them.

use crate::turning::contour::{Profile, Side, SurfaceKind};
use crate::turning::length::Half;

/// Both profiles with their faces in the middle of their limits; a bore that ends at the far face still does.
pub(super) fn in_the_middle(mut outer: Profile, mut inner: Option<Profile>) -> (Profile, Option<Profile>) {
    let end = |profile: &Profile| profile.contour().end().map_or(Half::ZERO, |end| end.z);
    let before = end(&outer);
    place(&mut outer);
    if let Some(inner) = &mut inner {
        place(inner);
        let moved = end(&outer) - before;
        if moved != Half::ZERO && end(inner) == before {
            let last = inner.surfaces.len().saturating_sub(1);
            shift(inner, last, moved);
        }
    }
    (outer, inner)
}

fn place(profile: &mut Profile) {
    for index in 0..profile.surfaces.len() {
        let surface = &profile.surfaces[index];
        // Half of a sum of micrometres is so many halves.
        let middle = surface.limits.filter(|_| surface.kind == SurfaceKind::Face).map(|limits| limits.twice_middle());
        if let Some(middle) = middle {
            shift(profile, index, Half::new(middle.micrometres()));
        }
    }
}

/// Moves a surface along the axis with what stands between the cylinders before and behind it, which become longer or shorter.
/// Where another face with limits of its own stands there, the surface moves alone and its neighbours stretch.
fn shift(profile: &mut Profile, index: usize, by: Half) {
    let is_along = |index: usize| {
        profile.surfaces.get(index).is_some_and(|one| matches!(one.kind, SurfaceKind::Cylinder | SurfaceKind::Thread))
    };
    if is_along(index) {
        // The end of a bore is its last cylinder.
        if let Some(last) = profile.surfaces[index].pieces.last_mut().filter(|_| profile.side == Side::Inner) {
            last.to.z = last.to.z + by;
        }
        return;
    }
    let first = (0..index).rev().take_while(|index| !is_along(*index)).last().unwrap_or(index);
    let end = (index + 1..profile.surfaces.len()).find(|index| is_along(*index)).unwrap_or(profile.surfaces.len());
    // The free end stays.
    let first = if first == 0 { index } else { first };
    let has_limits = |index: usize| {
        profile.surfaces.get(index).is_some_and(|one| one.kind == SurfaceKind::Face && one.limits.is_some())
    };
    let shared = (first..end).any(|other| other != index && has_limits(other));
    let (first, end) = if shared { (index, index + 1) } else { (first, end) };
    for piece in profile.surfaces.get_mut(first..end).unwrap_or_default().iter_mut().flat_map(|one| &mut one.pieces) {
        (piece.from.z, piece.to.z) = (piece.from.z + by, piece.to.z + by);
    }
    if let Some(before) = first.checked_sub(1).and_then(|index| profile.surfaces[index].pieces.last_mut()) {
        before.to.z = before.to.z + by;
    }
    if let Some(behind) = profile.surfaces.get_mut(end).and_then(|surface| surface.pieces.first_mut()) {
        behind.from.z = behind.from.z + by;
    }
}
