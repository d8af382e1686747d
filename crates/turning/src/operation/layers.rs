//! The layers over a part in a set-up, from outside: blank, rough contour, main contour, part (lecture 12.2, fig. 12.2).

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::note::{Finding, Note, Severity};
use crate::tables::turning::jobs::JobLimit;
use crate::turning::allowances::areas::{Areas, areas, between};
use crate::turning::allowances::equidistant;
use crate::turning::allowances::finishing::{Allowance, Errors, Method, allowance, finishing};
use crate::turning::allowances::surfaces::{Place, on};
use crate::turning::contour::{Contour, Curve, Piece, Side, Surface, SurfaceKind};
use crate::turning::jobs::UNKNOWN_EDGE;
use crate::turning::jobs::limits::Limits;
use crate::turning::length::Half;
use crate::turning::nose::Nose;
use crate::turning::point::Point;
use crate::turning::shaft::Holding;
use crate::turning::tooling::TurningTool;
use crate::turning::workpiece::{Allowances, Workpiece};
use crate::turning::zones::fit::reaches;
use crate::turning::zones::{SetUp, TurnedSide};
use crate::units::Micrometres;

use super::Stage;
use super::drill::{self, Drilled};
use super::finishing::needs;
use super::intermediate::left;
use super::opened;
use super::thin;
use super::tools::{self, Bench};

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

/// What is there before a side is turned.
#[derive(Clone, Copy, Debug, Default)]
pub struct Before {
    /// Z of the rough face of the free end, from which a bore is bored.
    pub face: Option<Half>,
    /// The drill of the hole that is made to size behind a bore.
    pub axial: Option<Micrometres>,
}

/// The layers of a side. None, with a finding, if they cannot be made.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn layers(
    stretch: &TurnedSide,
    set_up: &SetUp,
    Before { face, axial }: Before,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Option<Layers>, KnowledgeError> {
    let (workpiece, knowledge) = (bench.workpiece, bench.knowledge);
    let length = Micrometres::new(workpiece.length().halves() / 2);
    let method = method(&workpiece.allowances);
    let (mut allowances, doubts) = finishing(&stretch.profile, method, length, knowledge)?;
    findings.extend(doubts);
    let main = &stretch.main.contour;
    let Some(mut left) = left(stretch, bench, findings)? else { return Ok(None) };
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
                let place = on(main.side, piece.is_face());
                let diameter = piece.from.radius.max(piece.to.radius).diameter();
                allowance(place, diameter, length, method, knowledge)?.0.unwrap_or(Half::ZERO)
            }
        };
        distances.push(distance);
    }
    let left = Contour { side: main.side, pieces: left.into_iter().map(|(piece, _)| piece).collect() };
    // A bottom that no bar faces is left to its final depth by the flat drill; one that a bar faces, with no more on it than the
    // edge behind the nose takes. So is a shoulder that is higher than the edge is long.
    if main.side == Side::Inner {
        let last = left.pieces.len().saturating_sub(1);
        for (index, (piece, distance)) in left.pieces.iter().zip(&mut distances).enumerate() {
            if !is_bottom(piece) {
                continue;
            }
            let faced = faced_by_bar(piece, &left, index == last, bench)?;
            let most = if index == last { faced.unwrap_or(Half::ZERO) } else { faced.unwrap_or(*distance) };
            if *distance > most {
                let code = if index == last { "bottom-allowance-less" } else { "shoulder-allowance-less" };
                let note = Note::new(code).with("wanted", *distance).with("left", most);
                let note = if index == last { note } else { note.with("z", Half::ZERO - piece.to.z) };
                findings.push(Finding::of_part(Severity::Note, note));
                *distance = most;
            }
        }
    }
    let rough = match equidistant(&left, &distances) {
        Ok(rough) => rough,
        Err(error) => {
            findings.push(Finding::of_part(Severity::Error, Note::new("no-rough-contour").with("why", error)));
            return Ok(None);
        }
    };
    let rough = without_lips(rough, &left);
    let finish = between(&rough, &left);
    let rough = up_to(rough, face);
    // A face without an allowance in the file is already made: a missing allowance of a chamfer beside it is no
    // finding.
    // Between centres faces are made before, too.
    let face_is_made = workpiece.holding == Holding::Centres
        || left.pieces.first().is_some_and(|face| face.is_face()) && distances.first() == Some(&Half::ZERO);
    let Some(SideStock { blank, rough, drilled_first }) =
        standing(&rough, face_is_made, axial, set_up, bench, findings)?
    else {
        return Ok(None);
    };
    let part = stretch.profile.contour();
    let rough = thin::within(rough, &blank);
    for (surface, allowance) in stretch.profile.surfaces.iter().zip(&mut allowances) {
        if drilled_first.is_none() && thin::is_of_blank(surface, &blank) {
            allowance.allowance_mm = Some(Half::ZERO);
            let severity = thin::judged(surface, workpiece.blank.kind, knowledge)?;
            findings.push(Finding::of_part(severity, Note::new("surface-of-blank").with("surface", &surface.name)));
        }
    }
    let mut areas = areas(&blank, &rough, main, &part);
    areas.finish = finish;
    if main.side == Side::Inner && left.pieces.last().is_some_and(is_bottom) {
        let on = if set_up.turned_over { over_low_shoulder(&left, bench)? } else { None };
        let left = on.unwrap_or(left);
        return Ok(Some(Layers { allowances, blank, drilled_first, rough, left, main: main.clone(), part, areas }));
    }
    let by = run_out(&left, bench)?;
    let threaded = stretch.profile.surfaces.last().is_some_and(|last| last.kind == SurfaceKind::Thread);
    let (blank, rough, left) = if set_up.turned_over {
        let on = match main.side {
            Side::Outer => led_on(&left, threaded, by, bench),
            Side::Inner => into_hole(&left, bench)?,
        };
        (blank, rough, on.unwrap_or(left))
    } else {
        // What is ground later begins there, and keeps its allowance.
        let ground = ground_behind(&left, bench);
        let by = by.max(past_parting(&left, bench)?);
        (longer(blank, by), longer(off_the_part(rough, ground), by), longer(off_the_part(left, ground), by))
    };
    Ok(Some(Layers { allowances, blank, drilled_first, rough, left, main: main.clone(), part, areas }))
}

/// A rough contour in which a slope with a larger allowance ends where it crosses the smaller one behind it, not with a short fall
/// that no trailing edge goes down. Falls of the part itself stay.
fn without_lips(mut rough: Contour, left: &Contour) -> Contour {
    /// As short is the end of an allowance, mm.
    const SHORT: f64 = 0.5;
    let is_line = |piece: &Piece| piece.curve == Curve::Line;
    let over_part = |at: Point| match (left.radii_at(at.z), left.side) {
        (Some((_, most)), Side::Outer) => most <= at.radius,
        (Some((least, _)), Side::Inner) => least >= at.radius,
        (None, _) => false,
    };
    let mut at = 1;
    while let Some([slope, fall, behind]) = rough.pieces.get(at - 1..at + 2) {
        let (along, on, down) = (slope.chord().unit(), behind.chord().unit(), fall.chord());
        let falls = if left.side == Side::Outer { down.radius < 0.0 } else { down.radius > 0.0 };
        let turn = along.cross(on);
        let short = falls && down.length() < SHORT && [slope, fall, behind].into_iter().all(is_line);
        let crossing = (short && turn.abs() > 1e-6 && down.z >= 0.0 && on.z > 0.0).then(|| {
            let between = slope.from.to(behind.from);
            (slope.from.moved(along.times(between.cross(on) / turn)), between.cross(along) / turn)
        });
        let within = |(cross, beyond): &(Point, f64)| {
            let before = slope.from.z < cross.z && cross.z < slope.to.z && *beyond < 0.0;
            let led = (slope.to.z - cross.z).to_mm() / on.z;
            let level = cross.moved(on.times(led));
            before && over_part(*cross) && over_part(level)
        };
        match crossing.filter(within) {
            Some((cross, _)) => {
                let (first, last) = (slope.between(slope.from, cross), behind.between(cross, behind.to));
                rough.pieces.splice(at - 1..at + 2, [first, last]);
            }
            None => at += 1,
        }
    }
    rough
}

/// Whether a piece is the bottom of a bore, or its shoulder around a narrower hole.
fn is_bottom(last: &Piece) -> bool {
    last.is_face() && last.to.radius < last.from.radius
}

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

/// The most that a bar takes off the bottom of a bore, or off a shoulder in it, as it faces it to its inner end; none if every bar would
/// touch the wall on the other side, or where the edge of each is longer than a shoulder. Towards the axis the secondary edge cuts, which rises by φ1 to its end, where the bar begins.
fn faced_by_bar(
    bottom: &Piece,
    bore: &Contour,
    is_last: bool,
    bench: &Bench<'_, '_>,
) -> Result<Option<Half>, KnowledgeError> {
    let Some(narrow) = bore.narrowest() else { return Ok(None) };
    let mut bars = tools::candidates(Side::Inner, Stage::Finishing, bench)?;
    bars.retain(|bar| bar.min_bore.is_none_or(|least| least <= narrow.diameter()));
    bars.retain(|bar| tools::nearest_to_axis(bar, narrow).is_none_or(|nearest| nearest <= bottom.to.radius));
    // So would one whose edges do not follow the walls.
    let mut following = Vec::new();
    for bar in bars {
        if reaches(needs(bore), Some(narrow.diameter()), &tools::angles(&bar, bench.knowledge)?) {
            following.push(bar);
        }
    }
    let mut bars = tools::reaching(following, bottom.to.z, bench.knowledge)?;
    let high = bottom.from.radius - bottom.to.radius;
    bars.retain(|bar| is_last || high > Half::of(bar.edge.unwrap_or(UNKNOWN_EDGE)));
    let share = Limits::of(bench.knowledge).ratio(JobLimit::BottomEdgeShare)?;
    let rise = |bar: &TurningTool<'_>| {
        let edge = bar.edge.unwrap_or(UNKNOWN_EDGE).to_mm();
        Half::from(share * edge * libm::sin(bar.trail_angle.to_f64().to_radians()))
    };
    Ok(bars.iter().map(rise).min())
}

/// The overrun at the end of a set-up's range: the round nose of the tool must leave no metal that the other set-up does not
/// reach. In the first set-up it is at the same radius, over a falling contour or into the stock beyond.
///
/// # Errors
/// The knowledge base lacks the table of motions.
pub(super) fn run_out(left: &Contour, bench: &Bench<'_, '_>) -> Result<Half, KnowledgeError> {
    let ends_open = left.end().is_some_and(|end| end.radius > Half::ZERO);
    let [approach, _] = bench.approach_and_retract()?;
    Ok(if ends_open { approach } else { Half::ZERO })
}

/// How far the outside goes on behind its end where the part is parted off there and the next set-up turns some of it: past the
/// blade's face by the roundest nose, whose round would stand in the way of that set-up.
fn past_parting(left: &Contour, bench: &Bench<'_, '_>) -> Result<Half, KnowledgeError> {
    let end = left.end().map(|end| end.z).filter(|end| *end < bench.workpiece.length());
    let (Some(end), Some(face), Side::Outer) = (end, bench.parted, left.side) else { return Ok(Half::ZERO) };
    let tools = tools::candidates(Side::Outer, Stage::Finishing, bench)?;
    let nose = tools.iter().map(|tool| tools::nose(tool).radius).max().unwrap_or(Half::ZERO);
    Ok(face - end + nose)
}

/// How far a contour rises at its end along the axis, in its own lengths; none where it ends with a face or a fall.
/// In the second set-up a chamfer or a rounding goes on into the air over the cylinder that was made before, and a cylinder into
/// the air over a fall, or the round nose leaves metal at its end.
fn slope_at_end(left: &Contour) -> Option<f64> {
    let last = left.pieces.last().filter(|_| left.side == Side::Outer)?;
    let along = last.direction_at_end();
    (along.z > LEAST_RUN && along.radius >= -1e-9).then(|| along.radius.max(0.0) / along.z)
}

/// A contour of the second set-up led on behind its end, where the round nose would leave metal: straight along its slope, over what
/// the first set-up made, or along that, where it rises from there; and over the cylinder behind a thread, whose own is turned
/// smaller. None elsewhere.
fn led_on(left: &Contour, threaded: bool, by: Half, bench: &Bench<'_, '_>) -> Option<Contour> {
    let end = left.end().filter(|_| by > Half::ZERO)?;
    let slope = slope_at_end(left)?;
    let part = bench.workpiece.outer.contour().turned_over(bench.workpiece.length());
    let beyond = super::clip::between(&part, end.z, end.z + by);
    let over = |point: &Point| end.radius + Half::from((point.z - end.z).to_mm() * slope) >= point.radius;
    if beyond.pieces.iter().flat_map(|piece| piece.extremes()).all(|point| over(&point)) {
        // A cylinder that goes on in the same radius is made already.
        let flush = left.pieces.iter().chain(beyond.pieces.first()).rev().take(2).all(|piece| piece.is_cylinder());
        return (!flush || threaded && bench.elsewhere.is_empty()).then(|| leading_on(left.clone(), by, slope));
    }
    let rises = |piece: &Piece| !piece.is_face() && piece.to.radius >= piece.from.radius;
    let follows = beyond.start() == Some(end) && beyond.pieces.iter().all(rises);
    // An allowance for another machine stands there.
    (follows && bench.elsewhere.is_empty()).then(|| {
        let pieces = left.pieces.iter().chain(&beyond.pieces).copied().collect();
        Contour { side: left.side, pieces }
    })
}

/// A bore that narrows towards the hole that the set-up before has opened, led on into its air for the roundest nose of a bar.
fn into_hole(left: &Contour, bench: &Bench<'_, '_>) -> Result<Option<Contour>, KnowledgeError> {
    let bars = tools::candidates(Side::Inner, Stage::Finishing, bench)?;
    let roundest = bars.iter().map(tools::nose).max_by_key(|nose| nose.radius);
    let hole = |nose: Nose| {
        let end = left.end().filter(|end| is_bored_behind(*end, nose.radius + nose.radius, bench));
        bench.opened.max(end.map_or(Micrometres::ZERO, |end| end.radius.diameter()))
    };
    Ok(roundest.and_then(|nose| opened::into_hole(left, hole(nose), nose)))
}

/// Whether the set-up before has bored behind the end of a contour of the second one, as far and at least as wide.
fn is_bored_behind(end: Point, by: Half, bench: &Bench<'_, '_>) -> bool {
    let Some(inner) = &bench.workpiece.inner else { return false };
    let bored = inner.contour().turned_over(bench.workpiece.length());
    let beyond = super::clip::between(&bored, end.z, end.z + by);
    let reaches = beyond.end().is_some_and(|last| last.z == end.z + by);
    reaches && beyond.pieces.iter().all(|piece| piece.radii().0 >= end.radius)
}

/// A bore that ends with a shoulder lower than the roundest nose of a bar, led on into what the set-up before has bored behind it, so
/// that the nose rolls over the edge. None where the shoulder is higher, or nothing is bored behind it.
fn over_low_shoulder(left: &Contour, bench: &Bench<'_, '_>) -> Result<Option<Contour>, KnowledgeError> {
    let bars = tools::candidates(Side::Inner, Stage::Finishing, bench)?;
    let nose = bars.iter().map(|bar| tools::nose(bar).radius).max().unwrap_or(Half::ZERO);
    let Some(last) = left.pieces.last() else { return Ok(None) };
    let (by, height) = (nose + nose, last.from.radius - last.to.radius);
    Ok((height < nose && is_bored_behind(last.to, by, bench)).then(|| longer(left.clone(), by)))
}

/// A contour that rises more steeply at its end, nearly as a wall, is not led on.
const LEAST_RUN: f64 = 0.2;

/// A contour led on along a slope at its end.
pub(super) fn leading_on(mut contour: Contour, by: Half, slope: f64) -> Contour {
    let Some(end) = contour.end() else { return contour };
    if slope == 0.0 {
        return longer(contour, by);
    }
    let radius = end.radius + Half::from(by.to_mm() * slope);
    contour.pieces.push(Piece::line(end, Point { radius, z: end.z + by }));
    contour
}

/// The allowance that another machine finishes on the surface behind the end of a contour of the first set-up; zero without one.
fn ground_behind(left: &Contour, bench: &Bench<'_, '_>) -> Half {
    let part = bench.workpiece.profile(left.side);
    let end = left.end();
    let begins =
        |surface: &&Surface| surface.pieces.first().is_some_and(|first| Some(first.from) == end && !first.is_face());
    let behind = part.and_then(|part| part.surfaces.iter().find(begins));
    behind.and_then(|surface| bench.later(&surface.name)).unwrap_or(Half::ZERO)
}

/// A contour that steps away from the part by so much at its end.
fn off_the_part(mut contour: Contour, by: Half) -> Contour {
    if let Some(end) = contour.end().filter(|_| by > Half::ZERO) {
        let to = Point { radius: end.radius.off(by, contour.side), z: end.z };
        match contour.pieces.last_mut().filter(|last| last.is_face()) {
            Some(last) => last.to = to,
            None => contour.pieces.push(Piece::line(end, to)),
        }
    }
    contour
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
    // Where the set-up before did not turn the outside, the blank stands yet.
    let raw = workpiece.blank.outer.radii_at(workpiece.length()).map(|(_, most)| most);
    let radius = if bench.turned.is_some() { radius } else { raw.unwrap_or(radius).max(radius) };
    let rim = Point { radius, z: Half::ZERO };
    let Some(face) = far_face(rim, set_up, Side::Outer, workpiece) else { return Ok(None) };
    let main = Contour { side: Side::Outer, pieces: vec![face] };
    let length = Micrometres::new(workpiece.length().halves() / 2);
    let method = method(&workpiece.allowances);
    let distance = allowance(Place::Face, radius.diameter(), length, method, knowledge)?.0.unwrap_or(Half::ZERO);
    let at = |point: Point| Point { radius: point.radius, z: point.z - distance };
    let rough = Contour { side: Side::Outer, pieces: vec![face.mapped(false, at)] };
    let finish = between(&rough, &main);
    let Some(SideStock { blank, rough, drilled_first }) = standing(&rough, false, None, set_up, bench, findings)?
    else {
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
        let blank = match &bench.turned {
            Some(turned) => super::turned_before::standing(blank, turned),
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
