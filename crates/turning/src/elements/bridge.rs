//! Bridges over elements that the tool cannot make, from lip to lip, and the resulting contour for the tool.
//!
//! Bits that the tool cannot make lie between two lips. They are bridged in the first of these ways that fits:
//!
//! 1. **Corner.** The contour continues straight from both lips until the lines meet: a cylinder over its groove, a
//!    face over its groove, cylinder and face to their corner over a relief. The meeting point must not be above the
//!    higher lip, nor the part above the bridge.
//! 2. **Level.** From the near lip parallel to the axis to where the contour rises through that radius again.
//!    Everything below is covered, even if the tool could make it.
//! 3. **Open.** If it never rises again, parallel to the axis to the end of the contour. What is below is for the other
//!    set-up.

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::point::{Point, Vector};

use super::silhouette::silhouette;
use super::view::{Bit, outer};

/// How far the part may be above a bridge, mm: points are rounded to half a micrometre.
const TRIFLE: f64 = 0.0015;

/// A bridge and what it covers, as the tool sees it.
#[derive(Clone, Debug)]
pub(super) struct BridgeSpan {
    /// The index of the first bit under it, and of the first bit after it.
    pub bits: (usize, usize),
    /// The part below it, from lip to lip.
    pub under: Vec<Bit>,
    /// The bridge.
    pub over: Vec<Bit>,
    /// Whether the contour never rises to it again.
    pub open: bool,
}

/// The contour for the tool, and the bridges.
pub(super) struct Bridged {
    pub bits: Vec<Bit>,
    pub spans: Vec<BridgeSpan>,
}

/// Bridges the bits that are `lost` to the tool.
pub(super) fn bridge(bits: &[Bit], lost: &[bool]) -> Bridged {
    let is_lost = |index: usize| lost.get(index).copied().unwrap_or(false);
    let mut done = Bridged { bits: Vec::new(), spans: Vec::new() };
    let mut index = 0;
    while let Some(bit) = bits.get(index) {
        if !is_lost(index) {
            done.bits.push(*bit);
            index += 1;
            continue;
        }
        let end = (index..bits.len()).find(|index| !is_lost(*index)).unwrap_or(bits.len());
        let run = bits.get(index..end).unwrap_or_default();
        if let Some(over) = corner(done.bits.last(), run, bits.get(end)) {
            done.lay(BridgeSpan { bits: (index, end), under: run.to_vec(), over, open: false });
            index = end;
            continue;
        }
        let lip = bit.piece.from;
        if bit.piece.to.radius >= lip.radius {
            // The contour does not fall from this lip: a corner before a steep face cannot have another shape.
            done.bits.push(*bit);
            index += 1;
            continue;
        }
        index = done.level(bits, index);
    }
    let (bits, overhangs) = silhouette(done.bits);
    done.spans.extend(overhangs);
    Bridged { bits, spans: done.spans }
}

impl Bridged {
    fn lay(&mut self, span: BridgeSpan) {
        self.bits.extend(span.over.iter().copied());
        self.spans.push(span);
    }

    /// Bridges level from the beginning of a falling bit. Returns the index of the next bit.
    fn level(&mut self, bits: &[Bit], index: usize) -> usize {
        let ahead = bits.get(index..).unwrap_or_default();
        let Some(first) = ahead.first() else { return bits.len() };
        let lip = first.piece.from;
        let rises = |bit: &Bit| bit.piece.from.radius < lip.radius && bit.piece.to.radius >= lip.radius;
        let Some(hit) = ahead.iter().position(rises) else {
            let end = ahead.iter().map(|bit| bit.piece.to.z).max().unwrap_or(lip.z);
            let over = laid(first.surface, &[lip, Point::new(lip.radius, end)]);
            self.lay(BridgeSpan { bits: (index, bits.len()), under: ahead.to_vec(), over, open: true });
            return bits.len();
        };
        let mut under: Vec<Bit> = ahead.get(..hit).unwrap_or_default().to_vec();
        if let Some(wall) = ahead.get(hit) {
            let top = wall.piece.at_radius(lip.radius).first().copied().unwrap_or(wall.piece.to);
            under.push(Bit { piece: wall.piece.between(wall.piece.from, top), ..*wall });
            let over = laid(first.surface, &[lip, top]);
            let rest = Bit { piece: wall.piece.between(top, wall.piece.to), ..*wall };
            let all = rest.piece.is_nothing();
            self.lay(BridgeSpan { bits: (index, index + hit + usize::from(all)), under, over, open: false });
            if !all {
                self.bits.push(rest);
            }
        }
        index + hit + 1
    }
}

/// The lines of a bridge.
fn laid(surface: usize, points: &[Point]) -> Vec<Bit> {
    let lines = points.iter().zip(points.iter().skip(1)).map(|(from, to)| Piece::line(*from, *to));
    lines.filter(|piece| !piece.is_nothing()).map(|piece| Bit { surface, origin: None, piece }).collect()
}

/// The bridge that extends both lips until the lines meet.
fn corner(before: Option<&Bit>, run: &[Bit], after: Option<&Bit>) -> Option<Vec<Bit>> {
    let (before, first, after) = (before?, run.first()?, after?);
    let (near, far) = (before.piece.to, after.piece.from);
    let (out, back) = (before.piece.direction_at_end(), after.piece.direction_at_start());
    let points = match meeting(near, out, far, back)? {
        Meeting::OneLine => vec![near, far],
        Meeting::At(point) => vec![near, point, far],
    };
    let over = laid(first.surface, &points);
    let highest = near.radius.max(far.radius).to_mm() + TRIFLE;
    let sound = points.iter().all(|point| point.radius.to_mm() <= highest) && !stands_out(run, &over, far);
    (sound && over.iter().all(|bit| bit.piece.to.z >= bit.piece.from.z)).then_some(over)
}

enum Meeting {
    /// Both lips lie on one line.
    OneLine,
    /// The lines meet there.
    At(Point),
}

/// Where the line onwards from one lip meets the line backwards from the other.
fn meeting(near: Point, out: Vector, far: Point, back: Vector) -> Option<Meeting> {
    let gap = near.to(far);
    let across = out.cross(back);
    // The lips of a groove are exact to half a micrometre, and so are their directions over the gap.
    if out.cross(gap).abs() <= TRIFLE && back.cross(gap).abs() <= TRIFLE && out.dot(gap) > 0.0 && back.dot(gap) > 0.0 {
        return Some(Meeting::OneLine);
    }
    if across.abs() < 1e-9 {
        return None;
    }
    let (on, to) = (gap.cross(back) / across, out.cross(gap) / across);
    (on >= -TRIFLE && to >= -TRIFLE).then(|| Meeting::At(near.moved(out.times(on))))
}

/// Whether bits of the part are above a bridge, or beyond its far lip.
fn stands_out(run: &[Bit], over: &[Bit], far: Point) -> bool {
    let bridge = outer(over.iter().map(|bit| bit.piece).collect());
    let above = |at: Point| match bridge.radii_at(at.z) {
        Some((_, most)) => (at.radius - most).to_mm() > TRIFLE,
        None => at.z < bridge.start().map_or(far.z, |start| start.z) || (at.radius - far.radius).to_mm() > TRIFLE,
    };
    run.iter().flat_map(|bit| along(bit.piece)).any(above)
}

/// Points of a piece: its ends, points next to them, and fifteen between. A fillet that ends at an upright lip is above
/// the other line only very near its end.
fn along(piece: Piece) -> impl Iterator<Item = Point> {
    let one = Half::new(1);
    let (from, to) = (piece.from.z.halves(), piece.to.z.halves());
    let between = (1..16).map(move |part| Half::new(from + (to - from) * part / 16));
    let places = [piece.from.z + one, piece.to.z - one].into_iter().chain(between);
    places.flat_map(move |z| piece.at_z(z)).chain([piece.from, piece.to])
}
