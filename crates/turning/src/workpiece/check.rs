//! Compares the contours of a workpiece with themselves, with each other and with the blank.

use crate::knowledge::diagnostic::Place;
use crate::turning::contour::{Contour, Side, Surface};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::reading::{Reader, mistake};

use super::Blank;
use super::cross::{Chain, crossing, flat};
use super::walk::Walked;

/// A point within a micrometre of a limit counts as on it: points of arcs are rounded.
const SLACK: Half = Half::new(2);

/// Whether a contour crosses or touches itself; the place is that of the later surface.
pub(super) fn crosses_itself(walked: &Walked, reader: &mut Reader<'_>) {
    let owners: Vec<(&Surface, &Place)> = walked
        .surfaces
        .iter()
        .flat_map(|(surface, place)| surface.pieces.iter().map(move |_| (surface, place)))
        .collect();
    let pieces: Vec<_> = walked.surfaces.iter().flat_map(|(surface, _)| surface.pieces.iter().copied()).collect();
    if let Some((one, two)) = crossing(&pieces)
        && let (Some((surface, _)), Some((later, place))) = (owners.get(one), owners.get(two))
    {
        reader.fault::<()>(mistake!("contour-crosses-itself", surface = later.name, other = surface.name), place);
    }
}

/// The fault of a bore that does not begin where the outside does.
pub(super) fn do_not_meet(bore: Point, outer: Point, place: &Place, reader: &mut Reader<'_>) {
    let mistake = mistake!(
        "contours-do-not-meet",
        d = bore.radius.diameter(),
        z = Half::ZERO - bore.z,
        outer_d = outer.radius.diameter(),
        outer_z = Half::ZERO - outer.z
    );
    reader.fault::<()>(mistake, place);
}

/// Checks where the contours begin and end: the outer one begins on the axis or where the bore begins; the bore ends on
/// the axis or at the far end.
pub(super) fn ends(outer: &Walked, inner: Option<&Walked>, blank: Option<&Blank>, reader: &mut Reader<'_>) {
    let Some((start, place)) = &outer.start else { return };
    if start.z != Half::ZERO {
        reader.fault::<()>(mistake!("does-not-begin-at-zero", z = Half::ZERO - start.z), place);
    }
    match inner {
        Some(inner) => {
            if let Some((bore, place)) = inner.start.as_ref().filter(|(bore, _)| bore != start) {
                do_not_meet(*bore, *start, place, reader);
            }
            let last = inner.surfaces.last().map(|(_, place)| place);
            if let (Some(end), Some(far), Some(place)) = (inner.end(), outer.end(), last)
                && (inner.whole && outer.whole && end.radius != Half::ZERO && end.z != far.z)
            {
                reader.fault::<()>(
                    mistake!("bore-ends-nowhere", z = Half::ZERO - end.z, far = Half::ZERO - far.z),
                    place,
                );
            }
        }
        None => {
            let Some(blank) = blank else { return };
            let bore = blank.inner.as_ref().and_then(Contour::start).map_or(Half::ZERO, |start| start.radius);
            if start.radius != bore {
                reader.fault::<()>(
                    mistake!("does-not-begin-on-the-axis", d = start.radius.diameter(), bore = bore.diameter()),
                    place,
                );
            }
        }
    }
}

/// Checks that there is metal between bore and outside everywhere. Both must be whole and begin together.
pub(super) fn walls(outer: &Walked, inner: &Walked, reader: &mut Reader<'_>) {
    let (start, end) = (outer.start.as_ref().map(|(start, _)| *start), outer.end());
    let outers: Vec<(&Surface, Chain)> = outer
        .surfaces
        .iter()
        .flat_map(|(surface, _)| surface.pieces.iter().map(move |piece| (surface, Chain::of(*piece))))
        .collect();
    for (surface, place) in &inner.surfaces {
        let chains = surface.pieces.iter().map(|piece| Chain::of(*piece));
        let meets = |chain: &Chain| outers.iter().find(|(_, other)| chain.meets(other)).map(|(other, _)| *other);
        if let Some(other) = chains.into_iter().find_map(|chain| meets(&chain)) {
            reader.fault::<()>(mistake!("no-wall", surface = surface.name, other = other.name), place);
            return;
        }
    }
    // They do not cross, so one place shows which is inside.
    let (Some(outer), Some(inner), Some(first)) = (outer.profile(), inner.profile(), inner.surfaces.first()) else {
        return;
    };
    let (outer, inner) = (outer.contour(), inner.contour());
    let Some(deep) = inner.end().map(|point| Half::new(point.z.halves() / 2)) else { return };
    let (bore, around) = (inner.radii_at(deep), outer.radii_at(deep));
    let turned_out = bore.zip(around).is_some_and(|((bore, _), (_, around))| bore >= around);
    let ends_beyond = inner.end().zip(end).is_some_and(|(inner, outer)| inner.z > outer.z);
    if (turned_out || ends_beyond) && start.is_some() {
        reader.fault::<()>(mistake!("no-wall", surface = first.0.name, other = "outer"), &first.1);
    }
}

/// Checks for each surface that it is within the blank.
pub(super) fn within_blank(outer: &Walked, inner: Option<&Walked>, blank: &Blank, reader: &mut Reader<'_>) {
    if blank.face() < Half::ZERO
        && let Some((_, place)) = &outer.start
    {
        reader.fault::<()>(mistake!("blank-begins-behind", face = blank.face()), place);
    }
    for (surface, place) in &outer.surfaces {
        let end = surface.pieces.iter().map(|piece| piece.to.z).max().unwrap_or(Half::ZERO);
        if end > blank.end() {
            reader.fault::<()>(
                mistake!(
                    "part-longer-than-blank",
                    surface = surface.name,
                    z = Half::ZERO - end,
                    blank = Half::ZERO - blank.end()
                ),
                place,
            );
            break;
        }
        beyond("part-beyond-blank", surface, &blank.outer, place, reader);
    }
    let (Some(bore), Some(inner)) = (&blank.inner, inner) else { return };
    for (surface, place) in &inner.surfaces {
        beyond("blank-bore-beyond-part", surface, bore, place, reader);
    }
}

/// Checks that a surface is within a contour of the blank.
fn beyond(code: &'static str, surface: &Surface, blank: &Contour, place: &Place, reader: &mut Reader<'_>) {
    if let Some((z, part, limit)) = outside(surface, blank) {
        let (z, diameter, blank) = (Half::ZERO - z, part.diameter(), limit.diameter());
        let mistake = mistake!(code, surface = surface.name, z = z, diameter = diameter, blank = blank);
        reader.fault::<()>(mistake, place);
    }
}

/// The first Z at which a surface is outside of its blank, with both radii. The radii are compared at the corners of
/// both, at points of their arcs so close that the arcs between them are straight to half a micrometre, and midway
/// between all of these.
fn outside(surface: &Surface, blank: &Contour) -> Option<(Half, Half, Half)> {
    let part = Contour { side: blank.side, pieces: surface.pieces.clone() };
    let (least, most) = part.pieces.iter().flat_map(|piece| piece.extremes()).fold(None, |range, point| {
        let (least, most) = range.unwrap_or((point.z, point.z));
        Some((point.z.min(least), point.z.max(most)))
    })?;
    // An arc may exceed the limit by its rounding.
    let blank = blank.near(least - SLACK, most + SLACK);
    let pieces = part.pieces.iter().chain(&blank.pieces);
    let mut places: Vec<Half> = pieces.flat_map(|piece| flat(*piece)).map(|point| point.z).collect();
    places.retain(|z| (least..=most).contains(z));
    places.sort_unstable();
    places.dedup();
    let between: Vec<Half> =
        places.windows(2).map(|pair| Half::new(pair.iter().map(|z| z.halves()).sum::<i64>() / 2)).collect();
    places.extend(between);
    places.sort_unstable();
    places.into_iter().find_map(|z| {
        let ((inward, outward), (within, around)) = (part.radii_at(z)?, blank.radii_at(z)?);
        let (part, limit, beyond) = match blank.side {
            Side::Outer => (outward, around, outward > around + SLACK),
            Side::Inner => (inward, within, inward < within - SLACK),
        };
        beyond.then_some((z, part, limit))
    })
}
