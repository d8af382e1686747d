//! Divides the stock at every face and slope: each part has one floor, at most one fall behind it and one rise ahead.
//!
//! Along the contour a part ends where a rise ends (the next floor begins there) and where a fall begins. It also ends
//! where the blank has a step (lecture, fig. 12.10); the higher step is then stock ahead. A thicker bar behind the end
//! of the contour is a wall. Parts without stock are left out.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::Because;
use crate::turning::contour::{Contour, Piece, Side};
use crate::turning::elements::view::{outer, quarters, steepness};
use crate::turning::length::{Half, negative_z};
use crate::units::{Degrees, round_to};

use super::kind::{Bounds, ZoneKind, alone};
use super::{NOTHING, Stock};

/// A right angle.
const UPRIGHT: Degrees = Degrees(90.0);

/// The angles that a zone requires of a tool that feeds from its beginning to its end; 0 if it requires none.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Needs {
    /// The least φ: the steepest rise, 90° before a face.
    #[serde(rename = "main_angle_deg")]
    pub main: Degrees,
    /// The least φ1: the steepest fall.
    #[serde(rename = "secondary_angle_deg")]
    pub secondary: Degrees,
}

impl Needs {
    /// The larger requirements of both.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self { main: self.main.max(other.main), secondary: self.secondary.max(other.secondary) }
    }
}

/// A part of the stock.
#[derive(Clone, Debug, Serialize)]
pub struct ZonePart {
    /// Z of its beginning, towards the chuck.
    #[serde(rename = "from_z_mm", serialize_with = "negative_z")]
    pub from_z: Half,
    /// Z of its end, towards the chuck.
    #[serde(rename = "to_z_mm", serialize_with = "negative_z")]
    pub to_z: Half,
    /// The least radius of its stock.
    #[serde(rename = "least_radius_mm")]
    pub least_radius: Half,
    /// The greatest radius of its stock.
    #[serde(rename = "greatest_radius_mm")]
    pub greatest_radius: Half,
    /// Open, half-open or closed.
    pub kind: ZoneKind,
    /// The angles that it requires.
    pub needs: Needs,
    /// The length of its floor along the axis; a grooving tool must not be wider.
    #[serde(rename = "floor_length_mm")]
    pub floor_length: Half,
    /// The rough contour under it; empty for a face.
    pub contour: Vec<Piece>,
    /// The reason for its kind.
    pub because: Because,
    /// Its bounds.
    #[serde(skip)]
    pub bounds: Bounds,
    /// Radii as seen from outside, for a bore inside out: of the floor, of the surface of the blank, of the border to
    /// the next part.
    #[serde(skip)]
    pub(super) floor: Half,
    #[serde(skip)]
    pub(super) top: Half,
    #[serde(skip)]
    pub(super) border: Half,
}

/// A divided stock.
pub struct Apart {
    /// The stock before the face of the free end, if there is any; for outer stocks only.
    pub face: Option<ZonePart>,
    /// The parts along the axis, from the free end.
    pub along: Vec<ZonePart>,
}

/// A part while it is collected.
struct PartDraft {
    bits: Vec<Piece>,
    /// Whether stock of the next part, or the bar behind the end, is ahead.
    stock_ahead: bool,
}

impl PartDraft {
    fn start_z(&self) -> Half {
        self.bits.first().map_or(Half::ZERO, |bit| bit.from.z)
    }

    fn rises(&self) -> bool {
        self.bits.last().is_some_and(|bit| bit.to.radius > bit.from.radius)
    }

    fn falls(&self) -> bool {
        self.bits.first().is_some_and(|bit| bit.to.radius < bit.from.radius)
    }

    fn end_z(&self) -> Half {
        self.bits.last().map_or(Half::ZERO, |bit| bit.to.z)
    }
}

/// Divides a stock.
///
/// # Errors
/// The knowledge base lacks the rule `turning-zone` or a row of it.
pub fn of(stock: Stock<'_>, knowledge: &Knowledge) -> Result<Apart, KnowledgeError> {
    let top = (stock.rough.side == Side::Inner).then(|| {
        let most = |contour: &Contour| contour.radii().map_or(Half::ZERO, |(_, most)| most);
        most(stock.rough).max(most(stock.blank))
    });
    let seen = |contour: &Contour| top.map_or_else(|| contour.clone(), |top| contour.inside_out(top));
    let (rough, blank) = (seen(stock.rough), seen(stock.blank));
    let mut along = Vec::new();
    for draft in drafts(&rough, &blank) {
        if has_stock(&draft, &rough, &blank) {
            let at_end = rough.end().is_some_and(|end| end.z == draft.end_z());
            along.push(part(&draft, at_end, &blank, top, knowledge)?);
        }
    }
    let face = if top.is_none() { face(&rough, &blank, knowledge)? } else { None };
    Ok(Apart { face, along })
}

/// Parts divided by the contour, then by the steps of the blank.
fn drafts(rough: &Contour, blank: &Contour) -> Vec<PartDraft> {
    let start = rough.start().map(|start| start.z);
    let mut drafts: Vec<PartDraft> = Vec::new();
    let mut last = std::cmp::Ordering::Less;
    for bit in rough.pieces.iter().flat_map(|piece| quarters(*piece)) {
        let slope = bit.to.radius.cmp(&bit.from.radius);
        // The face of the free end is not a part along the axis.
        if bit.is_face() && Some(bit.from.z) == start && slope.is_gt() && drafts.is_empty() {
            continue;
        }
        // Less is a fall, equal a floor, greater a rise: in this order they belong to one part.
        let begins = slope < last;
        last = slope;
        match drafts.last_mut().filter(|_| !begins) {
            Some(draft) => draft.bits.push(bit),
            None => drafts.push(PartDraft { bits: vec![bit], stock_ahead: false }),
        }
    }
    let steps: Vec<&Piece> = blank.pieces.iter().filter(|piece| piece.is_face()).collect();
    let mut cut: Vec<PartDraft> = Vec::new();
    for mut draft in drafts {
        for step in &steps {
            let rises = step.to.radius > step.from.radius;
            if draft.start_z() < step.from.z && step.from.z < draft.end_z() {
                let (before, behind) = divided(&draft.bits, step.from.z);
                cut.push(PartDraft { bits: before, stock_ahead: rises });
                draft.bits = behind;
            } else if draft.end_z() == step.from.z && rises {
                draft.stock_ahead = true;
            }
        }
        cut.push(draft);
    }
    if let (Some(last), Some(end)) = (cut.last_mut(), rough.end()) {
        let beyond = blank.radii_at(end.z + Half::new(1)).is_some_and(|(_, most)| most > end.radius);
        last.stock_ahead = last.stock_ahead || beyond;
    }
    cut
}

/// Bits before a Z and behind it.
fn divided(bits: &[Piece], z: Half) -> (Vec<Piece>, Vec<Piece>) {
    let (mut before, mut behind) = (Vec::new(), Vec::new());
    for bit in bits {
        if bit.to.z <= z {
            before.push(*bit);
        } else if bit.from.z >= z {
            behind.push(*bit);
        } else {
            let at = bit.at_z(z).first().copied().unwrap_or(bit.from);
            before.push(bit.between(bit.from, at));
            behind.push(bit.between(at, bit.to));
        }
    }
    (before, behind)
}

/// Whether there is stock anywhere over a part: next to the corners of blank and contour, and midway between them.
fn has_stock(draft: &PartDraft, rough: &Contour, blank: &Contour) -> bool {
    let (from, to) = (draft.start_z(), draft.end_z());
    let (rough, blank) = (rough.near(from, to), blank.near(from, to));
    let corners = rough.corners().into_iter().chain(blank.corners()).map(|corner| corner.z);
    let mut places: Vec<Half> = corners.filter(|z| (from..=to).contains(z)).collect();
    places.sort_unstable();
    places.dedup();
    // At a corner a face of the neighbour would count; next to it each Z has one radius.
    let one = Half::new(1);
    let near = |(a, b): (&Half, &Half)| [*a + one, Half::new(i64::midpoint(a.halves(), b.halves())), *b - one];
    places.iter().zip(places.iter().skip(1)).flat_map(near).any(|z| match (rough.radii_at(z), blank.radii_at(z)) {
        (Some((least, _)), Some((_, most))) => most > least,
        _ => false,
    })
}

fn part(
    draft: &PartDraft,
    at_end: bool,
    blank: &Contour,
    top: Option<Half>,
    knowledge: &Knowledge,
) -> Result<ZonePart, KnowledgeError> {
    let (from_z, to_z) = (draft.start_z(), draft.end_z());
    let steep: Vec<(f64, f64)> = draft.bits.iter().map(|bit| steepness(*bit)).collect();
    let steepest = |of: fn(&(f64, f64)) -> f64| Degrees(round_to(steep.iter().map(of).fold(0.0, f64::max), 4));
    let border = draft.bits.last().map_or(Half::ZERO, |bit| bit.to.radius);
    // A thicker bar behind the end must not be cut into, so the pass ends at an upright wall. Other stock ahead is
    // removed anyway.
    let wall = if draft.stock_ahead && at_end { Degrees(90.0) } else { NOTHING };
    let needs = Needs { main: steepest(|one| one.0).max(wall), secondary: steepest(|one| one.1) };
    let floor = outer(draft.bits.clone()).radii().map_or(Half::ZERO, |(least, _)| least);
    let surface = surface(blank, from_z, to_z);
    let bounds = bounds(draft, surface);
    let classified = alone(bounds, knowledge)?;
    let free = classified.kind == ZoneKind::Open;
    let floor_length = draft.bits.iter().filter(|bit| bit.is_cylinder()).map(|bit| bit.to.z - bit.from.z).sum();
    let (least_radius, greatest_radius) = top.map_or((floor, surface), |top| (top - surface, top - floor));
    let contour = Contour { side: Side::Outer, pieces: draft.bits.clone() };
    Ok(ZonePart {
        from_z,
        to_z,
        least_radius,
        greatest_radius,
        kind: classified.kind,
        needs: if free { Needs { main: NOTHING, secondary: NOTHING } } else { needs },
        floor_length,
        contour: top.map_or(contour.clone(), |top| contour.inside_out(top)).pieces,
        because: classified.because,
        bounds,
        floor,
        top: surface,
        border,
    })
}

/// The bounds of a part. A single slope without stock over its ends is open: passes along it run out on both sides.
fn bounds(draft: &PartDraft, surface: Half) -> Bounds {
    let bounds = Bounds { ahead: draft.rises() || draft.stock_ahead, behind: draft.falls() };
    let [slope] = draft.bits.as_slice() else { return bounds };
    let aslant = !slope.is_face() && !slope.is_cylinder();
    let runs_out = aslant && !draft.stock_ahead && slope.to.radius.max(slope.from.radius) >= surface;
    if runs_out { Bounds { ahead: false, behind: false } } else { bounds }
}

/// The greatest radius of the blank between two Z, without the faces at the ends.
fn surface(blank: &Contour, from: Half, to: Half) -> Half {
    let inside = |z: Half| from < z && z < to;
    let blank = blank.near(from, to);
    let corners = blank.pieces.iter().flat_map(|piece| piece.extremes()).filter(|at| inside(at.z)).map(|at| at.radius);
    let near = [from + Half::new(1), to - Half::new(1)];
    let ends = near.into_iter().filter_map(|z| blank.radii_at(z)).map(|(_, most)| most);
    corners.chain(ends).max().unwrap_or(Half::ZERO)
}

/// The stock before the face of the free end.
fn face(rough: &Contour, blank: &Contour, knowledge: &Knowledge) -> Result<Option<ZonePart>, KnowledgeError> {
    let (Some(part), Some(raw)) = (rough.start(), blank.start()) else { return Ok(None) };
    if raw.z >= part.z {
        return Ok(None);
    }
    let bounds = Bounds { ahead: false, behind: false };
    let classified = alone(bounds, knowledge)?;
    let most = surface(blank, raw.z, part.z);
    Ok(Some(ZonePart {
        from_z: raw.z,
        to_z: part.z,
        // The nose of a tool moves it beyond the axis.
        least_radius: raw.radius.max(Half::ZERO),
        greatest_radius: most,
        kind: classified.kind,
        // An edge ahead of its tip would cut into the face beside it.
        needs: Needs { main: UPRIGHT, secondary: NOTHING },
        floor_length: Half::ZERO,
        contour: Vec::new(),
        because: classified.because,
        bounds,
        floor: raw.radius,
        top: most,
        border: raw.radius,
    }))
}
