//! The layers over a part in a set-up, from outside: blank, rough contour, main contour, part (lecture 12.2, fig. 12.2).

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::note::{Finding, Note, Severity};
use crate::tables::turning::jobs::JobLimit;
use crate::turning::allowances::areas::{Areas, areas, between};
use crate::turning::allowances::equidistant;
use crate::turning::allowances::finishing::{Allowance, Errors, Method, allowance, finishing};
use crate::turning::allowances::surfaces::{Place, on};
use crate::turning::contour::{Contour, Curve, Piece, Side, SurfaceKind};
use crate::turning::jobs::UNKNOWN_EDGE;
use crate::turning::jobs::limits::Limits;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::shaft::Holding;
use crate::turning::tooling::TurningTool;
use crate::turning::workpiece::Allowances;
use crate::turning::zones::fit::reaches;
use crate::turning::zones::{SetUp, TurnedSide};
use crate::units::Micrometres;

use super::Stage;
use super::beyond::{ground_behind, into_hole, led_on, longer, off_the_part, over_low_shoulder, past_parting, run_out};
use super::drill::Drilled;
use super::finishing::needs;
use super::intermediate::left;
use super::side_stock::{SideStock, far_face, standing};
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
