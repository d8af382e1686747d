//! The layers over a part in a set-up, from outside: blank, rough contour, main contour, part (lecture 12.2, fig. 12.2).

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::note::{Finding, Note, Severity};
use crate::turning::allowances::areas::{Areas, areas, between};
use crate::turning::allowances::finishing::{Allowance, Errors, Method, allowance, finishing};
use crate::turning::allowances::surfaces::Place;
use crate::turning::allowances::{equidistant, equidistant_over};
use crate::turning::contour::{Contour, Curve, Piece, Profile, Side, Stretches, Surface};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::schemes::rates;
use crate::turning::workpiece::{Allowances, Workpiece};
use crate::turning::zones::{SetUp, TurnedSide};
use crate::units::Micrometres;

use super::drill::{self, Drilled};
use super::tools::Bench;

/// The layers of one side in a set-up, in its coordinates: Z = 0 at the end that is free in it.
#[derive(Clone, Debug, Serialize)]
pub struct Layers {
    /// The finishing allowance of each surface.
    pub allowances: Vec<Allowance>,
    /// The blank within the range of this set-up; for a bore into solid metal the drilled hole.
    #[serde(skip)]
    pub blank: Contour,
    /// That hole, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub drilled_first: Option<Drilled>,
    /// The rough contour.
    pub rough: Contour,
    /// The contour after finishing on this lathe: the main contour with the allowances for other machines.
    #[serde(skip)]
    pub left: Contour,
    /// The main contour, with additional elements bridged.
    #[serde(skip)]
    pub main: Contour,
    /// The part.
    #[serde(skip)]
    pub part: Contour,
    /// The three allowances.
    #[serde(serialize_with = "sizes")]
    pub areas: Areas,
}

/// The areas without their boundaries, which only drawings need.
fn sizes<S: serde::Serializer>(areas: &Areas, serializer: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Size {
        area_mm2: f64,
        volume_mm3: f64,
    }
    let of = |area: &crate::turning::allowances::areas::Area| Size {
        area_mm2: crate::units::round_to(area.area_mm2.0, 3) + 0.0,
        volume_mm3: crate::units::round_to(area.volume_mm3.0, 1) + 0.0,
    };
    [("rough_main", of(&areas.rough_main)), ("additional", of(&areas.additional)), ("finish", of(&areas.finish))]
        .into_iter()
        .collect::<std::collections::BTreeMap<_, _>>()
        .serialize(serializer)
}

/// The layers of a side; `face` is Z of the rough face of the free end, from which a bore is bored. None, with a
/// finding, if they cannot be made.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn layers(
    stretch: &TurnedSide,
    set_up: &SetUp,
    face: Option<Half>,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Option<Layers>, KnowledgeError> {
    let (workpiece, knowledge) = (bench.workpiece, bench.knowledge);
    let length = Micrometres::new(workpiece.length().halves() / 2);
    let method = method(&workpiece.allowances);
    let (allowances, doubts) = finishing(&stretch.profile, method, length, knowledge)?;
    findings.extend(doubts);
    let main = &stretch.main.contour;
    let Some(mut left) = left(stretch, bench, findings) else { return Ok(None) };
    // The file may leave out the far face, but a part that is turned over begins with it.
    if let Some(face) = left.first().and_then(|(first, _)| far_face(first.from, set_up, main.side, workpiece)) {
        left.insert(0, (face, None));
    }
    let mut distances = Vec::new();
    for (piece, surface) in &left {
        let own = surface.and_then(|index| allowances.get(index));
        let distance = match own.and_then(|own| own.allowance_mm) {
            Some(distance) => distance,
            // A bridge: the allowance of a surface at its place.
            None => {
                let place = match main.side {
                    _ if piece.is_face() => Place::Face,
                    Side::Outer => Place::Outer,
                    Side::Inner => Place::Inner,
                };
                let diameter = piece.from.radius.max(piece.to.radius).diameter();
                allowance(place, diameter, length, method, knowledge)?.0.unwrap_or(Half::ZERO)
            }
        };
        distances.push(distance);
    }
    let left = Contour { side: main.side, pieces: left.into_iter().map(|(piece, _)| piece).collect() };
    let rough = match equidistant(&left, &distances) {
        Ok(rough) => rough,
        Err(error) => {
            findings.push(Finding::of_part(Severity::Error, Note::new("no-rough-contour").with("why", error)));
            return Ok(None);
        }
    };
    let finish = between(&rough, &left);
    let rough = up_to(rough, face);
    // A face without an allowance in the file is already made: a missing allowance of a chamfer beside it is no
    // finding.
    let face_is_made = left.pieces.first().is_some_and(|face| face.is_face()) && distances.first() == Some(&Half::ZERO);
    let Some(SideStock { blank, rough, drilled_first }) = standing(&rough, face_is_made, set_up, bench, findings)?
    else {
        return Ok(None);
    };
    let part = stretch.profile.contour();
    let mut areas = areas(&blank, &rough, main, &part);
    areas.finish = finish;
    if let Some(drilled) = drilled_first.as_ref().filter(|_| left.end().is_some_and(|end| end.radius == Half::ZERO)) {
        let bottom = drilled.full_depth();
        let note = Note::new("bore-bottom-stands").with("diameter", drilled.diameter_mm).with("z", Half::ZERO - bottom);
        findings.push(Finding::of_part(Severity::Wrong, note));
        let short = |contour: &Contour| match contour.start() {
            Some(start) => super::clip::between(contour, start.z, bottom),
            None => contour.clone(),
        };
        let (blank, rough, left) = (short(&blank), short(&rough), short(&left));
        return Ok(Some(Layers { allowances, blank, drilled_first, rough, left, main: main.clone(), part, areas }));
    }
    let by = run_out(&left, set_up, bench)?;
    let (blank, rough, left) = (longer(blank, by), longer(rough, by), longer(left, by));
    Ok(Some(Layers { allowances, blank, drilled_first, rough, left, main: main.clone(), part, areas }))
}

/// The overrun at the end of the first set-up's range: the round nose of the tool must leave no metal that the second
/// set-up does not reach. The overrun is at the same radius, over a falling contour or into the stock beyond.
///
/// # Errors
/// The knowledge base lacks the table of motions.
fn run_out(left: &Contour, set_up: &SetUp, bench: &Bench<'_, '_>) -> Result<Half, KnowledgeError> {
    let ends_open = left.end().is_some_and(|end| end.radius > Half::ZERO);
    let (table, _) = rates::of_table(bench.knowledge)?;
    let by = bench.workpiece.rates.map_or(table.approach, |rates| rates.main.approach);
    Ok(if ends_open && !set_up.turned_over { Half::of(by) } else { Half::ZERO })
}

/// A contour extended along the axis at its end.
fn longer(mut contour: Contour, by: Half) -> Contour {
    let Some(last) = contour.pieces.last_mut().filter(|_| by > Half::ZERO) else { return contour };
    let end = Point { radius: last.to.radius, z: last.to.z + by };
    if last.is_cylinder() {
        last.to = end;
    } else {
        let on = Piece::line(last.to, end);
        contour.pieces.push(on);
    }
    contour
}

/// A rough bore from the rough face on: the allowance of the face is before the beginning of the bore.
fn up_to(mut rough: Contour, face: Option<Half>) -> Contour {
    if let (Side::Inner, Some(start), Some(z)) = (rough.side, rough.start(), face)
        && z < start.z
    {
        rough.pieces.insert(0, Piece::line(Point { radius: start.radius, z }, start));
    }
    rough
}

/// The main contour with the allowances for other machines, each piece with its surface. None, with a finding, if it
/// cannot be made.
fn left(
    stretch: &TurnedSide,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Option<Vec<(Piece, Option<usize>)>> {
    let whole = &stretch.main.contour;
    let main = &if bench.elsewhere.is_empty() { whole.clone() } else { parted(whole, &stretch.profile, bench) };
    let along = along(&stretch.profile);
    let surfaces: Vec<Option<usize>> =
        main.pieces.iter().map(|piece| surface_of(piece, &stretch.profile, &along)).collect();
    let later = |surface: &Option<usize>| {
        let name = surface.and_then(|index| stretch.profile.surfaces.get(index)).map(|surface| &surface.name);
        let one = bench.elsewhere.iter().find(|one| Some(&one.surface) == name);
        one.map_or(Half::ZERO, |one| one.allowance_mm)
    };
    let distances: Vec<Half> = surfaces.iter().map(later).collect();
    if distances.iter().all(|distance| *distance == Half::ZERO) {
        return Some(main.pieces.iter().copied().zip(surfaces).collect());
    }
    match equidistant_over(main, &distances) {
        Ok(over) => Some(over.into_iter().map(|over| (over.piece, surfaces.get(over.of).copied().flatten())).collect()),
        Err(error) => {
            findings.push(Finding::of_part(Severity::Error, Note::new("no-intermediate-contour").with("why", error)));
            None
        }
    }
}

/// The layers before the far face, if a set-up turns nothing else from outside: the face alone, up to the radius of
/// the part there.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn before_face(
    set_up: &SetUp,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Option<Layers>, KnowledgeError> {
    let (workpiece, knowledge) = (bench.workpiece, bench.knowledge);
    let Some((_, radius)) = workpiece.outer.contour().radii_at(workpiece.length()) else { return Ok(None) };
    let rim = Point { radius, z: Half::ZERO };
    let Some(face) = far_face(rim, set_up, Side::Outer, workpiece) else { return Ok(None) };
    let main = Contour { side: Side::Outer, pieces: vec![face] };
    let length = Micrometres::new(workpiece.length().halves() / 2);
    let method = method(&workpiece.allowances);
    let distance = allowance(Place::Face, radius.diameter(), length, method, knowledge)?.0.unwrap_or(Half::ZERO);
    let at = |point: Point| Point { radius: point.radius, z: point.z - distance };
    let rough = Contour { side: Side::Outer, pieces: vec![face.mapped(false, at)] };
    let finish = between(&rough, &main);
    let Some(SideStock { blank, rough, drilled_first }) = standing(&rough, false, set_up, bench, findings)? else {
        return Ok(None);
    };
    let mut areas = areas(&blank, &rough, &main, &main);
    areas.finish = finish;
    let (left, part) = (main.clone(), main.clone());
    Ok(Some(Layers { allowances: Vec::new(), blank, drilled_first, rough, left, main, part, areas }))
}

fn method(allowances: &Allowances) -> Method {
    let half = |height: crate::turning::workpiece::Microns| Half::from(height.to_mm());
    match allowances {
        Allowances::Table => Method::Table,
        Allowances::Analytic(errors) => Method::Analytic(Errors {
            roughness_height: Some(half(errors.rz_um)),
            damaged_layer: Some(half(errors.defect_layer_um)),
            deviation: half(errors.spatial_deviation_um),
            setting: half(errors.setup_error_um),
        }),
        Allowances::Stated { on_diameter, on_face } => {
            Method::Stated { on_diameter: Some(*on_diameter), on_face: Some(*on_face) }
        }
    }
}

/// A contour with its lines divided at the ends of surfaces: two cylinders of one diameter are one line of the main
/// contour, but perhaps only one of them is ground later.
fn parted(contour: &Contour, profile: &Profile, bench: &Bench<'_, '_>) -> Contour {
    let later = |surface: &Surface| bench.elsewhere.iter().any(|one| one.surface == surface.name);
    let beside = profile.surfaces.iter().zip(profile.surfaces.iter().skip(1));
    let differ = beside
        .filter(|(one, next)| !one.kind.is_additional() && !next.kind.is_additional() && later(one) != later(next));
    let ends: Vec<Point> = differ.filter_map(|(one, _)| one.pieces.last()).map(|piece| piece.to).collect();
    let mut pieces = Vec::new();
    for piece in &contour.pieces {
        let mut from = piece.from;
        if piece.is_cylinder() {
            let inside = |end: &&Point| end.radius == piece.from.radius && piece.from.z < end.z && end.z < piece.to.z;
            let mut cuts: Vec<Point> = ends.iter().filter(inside).copied().collect();
            cuts.sort_by_key(|cut| cut.z);
            cuts.dedup();
            for cut in cuts {
                pieces.push(piece.between(from, cut));
                from = cut;
            }
        }
        pieces.push(piece.between(from, piece.to));
    }
    Contour { side: contour.side, pieces }
}

/// The index of the surface of a piece of the main contour: the first one that touches it and has a piece on the same
/// line or circle.
fn surface_of(piece: &Piece, profile: &Profile, along: &Stretches) -> Option<usize> {
    let lies_on = |other: &Piece| touches(piece, other) && same_carrier(piece, other);
    // At the common end of two surfaces on one line both touch it: the one over the middle of the piece comes first.
    let over_middle = |other: &Piece| {
        let (least, most) = (other.from.z.min(other.to.z), other.from.z.max(other.to.z));
        let middle = Half::new((piece.from.z.halves() + piece.to.z.halves()) / 2);
        least <= middle && middle <= most && lies_on(other)
    };
    let near: Vec<usize> = along.touching(piece.from.z.min(piece.to.z), piece.from.z.max(piece.to.z)).collect();
    let of = |test: &dyn Fn(&Piece) -> bool| {
        let has = |index: &usize| profile.surfaces.get(*index).is_some_and(|one| one.pieces.iter().any(test));
        near.iter().copied().find(has)
    };
    of(&over_middle).or_else(|| of(&lies_on))
}

/// The ranges of the surfaces of a profile, by the ends of their pieces.
fn along(profile: &Profile) -> Stretches {
    let ends = |surface: &Surface| {
        let ends = surface.pieces.iter().flat_map(|piece| [piece.from.z, piece.to.z]);
        let (least, most) = (ends.clone().min(), ends.max());
        (least.unwrap_or_default(), most.unwrap_or_default())
    };
    Stretches::new(&profile.surfaces.iter().map(ends).collect::<Vec<_>>())
}

fn touches(one: &Piece, other: &Piece) -> bool {
    let spans = |a: (Half, Half), b: (Half, Half)| a.0.min(a.1) <= b.0.max(b.1) && b.0.min(b.1) <= a.0.max(a.1);
    spans((one.from.z, one.to.z), (other.from.z, other.to.z))
        && spans((one.from.radius, one.to.radius), (other.from.radius, other.to.radius))
}

/// Whether two pieces are on one line or circle, to two micrometres: ends of pieces are rounded.
fn same_carrier(one: &Piece, other: &Piece) -> bool {
    const NEAR: f64 = 0.002;
    match (one.curve, other.curve, one.centre(), other.centre()) {
        (Curve::Line, Curve::Line, ..) => {
            let along = other.chord().unit();
            [one.from, one.to].into_iter().all(|point| along.cross(other.from.to(point)).abs() < NEAR)
        }
        (Curve::Arc { radius: a, .. }, Curve::Arc { radius: b, .. }, Some(here), Some(there)) => {
            (a - b).to_mm().abs() < NEAR && Point::at(here).to(Point::at(there)).length() < 10.0 * NEAR
        }
        _ => false,
    }
}

/// The stock over a rough contour in the coordinates of the set-up.
struct SideStock {
    /// The blank, or the hole drilled into it.
    blank: Contour,
    /// The rough contour within the range of the blank.
    rough: Contour,
    drilled_first: Option<Drilled>,
}

fn standing(
    rough: &Contour,
    face_is_made: bool,
    set_up: &SetUp,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Option<SideStock>, KnowledgeError> {
    let workpiece = bench.workpiece;
    let (Some(start), Some(end)) = (rough.start(), rough.end()) else { return Ok(None) };
    let seen =
        |contour: &Contour| if set_up.turned_over { contour.turned_over(workpiece.length()) } else { contour.clone() };
    let reach = |contour: &Contour| {
        let from = contour.start().map_or(start.z, |first| first.z).min(start.z);
        let mut clipped = super::clip::between(contour, from, end.z);
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
        let outer = if set_up.turned_over { faced(outer, workpiece.blank.inner.as_ref()) } else { outer };
        let blank = reach(&outer);
        let rough = behind_blank(rough, &blank, face_is_made, findings);
        return Ok(Some(SideStock { blank, rough, drilled_first: None }));
    }
    if let Some(inner) = &workpiece.blank.inner {
        return Ok(Some(SideStock { blank: reach(&seen(inner)), rough: rough.clone(), drilled_first: None }));
    }
    let drilled = drill::before_boring(rough, bench.knowledge, findings)?;
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
    let mut clipped = super::clip::between(rough, raw.z, end.z);
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
fn far_face(begins: Point, set_up: &SetUp, side: Side, workpiece: &Workpiece) -> Option<Piece> {
    let bore = workpiece.inner.as_ref().and_then(|inner| inner.contour().end());
    let within = bore.filter(|end| end.z == workpiece.length()).map_or(Half::ZERO, |end| end.radius);
    let face = Piece::line(Point { radius: within, z: begins.z }, begins);
    (set_up.turned_over && side == Side::Outer && begins.radius > within).then_some(face)
}

/// A blank that begins with the face of its end. The far face of a bar is not drawn, so it is added when the bar is
/// turned over.
fn faced(mut blank: Contour, inner: Option<&Contour>) -> Contour {
    if let Some(start) = blank.start().filter(|_| blank.pieces.first().is_some_and(|first| !first.is_face())) {
        let within = inner.and_then(|inner| inner.end()).map_or(Half::ZERO, |end| end.radius);
        if within < start.radius {
            blank.pieces.insert(0, Piece::line(Point { radius: within, z: start.z }, start));
        }
    }
    blank
}
