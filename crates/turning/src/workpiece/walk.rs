//! Makes surfaces from the items of a contour, and checks the direction of each.

use crate::knowledge::diagnostic::Place;
use crate::note::Finding;
use crate::note::Note;
use crate::turning::contour::{Curve, Piece, Profile, Side, Surface, SurfaceKind, SurfaceName, Turn};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::reading::{Placed, Reader, mistake};

use technolog_core::part::Deviations;

use crate::units::Micrometres;

use super::Thread;
use super::item_file::{Bulge, GrooveKind};
use super::items::{Along, ContourItem, GrooveValues, ItemShape, Measure};
use super::thread::ThreadSize;
use super::thread_limits::{self, longest_run_out};

/// How far the ends of an arc may be off its circle, because they are rounded.
const SLACK: Half = Half::new(2);

/// A contour, as far as it could be read.
pub(super) struct Walked {
    pub side: Side,
    /// Where it begins.
    pub start: Option<Placed<Point>>,
    /// Its surfaces, each with the place of its item.
    pub surfaces: Vec<Placed<Surface>>,
    pub threads: Vec<Thread>,
    pub findings: Vec<Finding>,
    /// Whether every item became a surface without a mistake.
    pub whole: bool,
}

impl Walked {
    /// The profile, if it is whole.
    pub fn profile(&self) -> Option<Profile> {
        let surfaces = self.surfaces.iter().map(|(surface, _)| surface.clone()).collect();
        self.whole.then_some(Profile { side: self.side, surfaces })
    }

    /// Where it ends.
    pub fn end(&self) -> Option<Point> {
        self.surfaces.last().and_then(|(surface, _)| surface.pieces.last()).map(|piece| piece.to)
    }
}

/// Walks a contour.
pub(super) fn walk(items: &[Option<ContourItem>], side: Side, reader: &mut Reader<'_>) -> Walked {
    let walked =
        Walked { side, start: None, surfaces: Vec::new(), threads: Vec::new(), findings: Vec::new(), whole: true };
    let mut walk = Walk { items, reader, radius: None, z: None, walked };
    for (index, item) in items.iter().enumerate() {
        match item {
            Some(item) => walk.step(index, item),
            None => {
                (walk.radius, walk.z) = (None, None);
                walk.walked.whole = false;
            }
        }
    }
    walk.walked.whole &= walk.walked.start.is_some() && !walk.walked.surfaces.is_empty();
    walk.walked
}

/// A contour under construction.
pub(super) struct Walk<'i, 'r, 'a> {
    pub items: &'i [Option<ContourItem>],
    pub reader: &'r mut Reader<'a>,
    /// The end of the contour so far, as far as it is known.
    radius: Option<Half>,
    z: Option<Half>,
    pub walked: Walked,
}

/// Diameters and Z of the file as lengths of the contour.
fn radius_of(measure: &Measure) -> Option<Half> {
    measure.as_ref().map(|(diameter, _)| Half::radius_of(*diameter))
}

fn z_of(measure: &Measure) -> Option<Half> {
    measure.as_ref().map(|(z, _)| Half::ZERO - Half::of(*z))
}

impl Walk<'_, '_, '_> {
    pub fn fault(&mut self, mistake: (&'static str, Note), place: &Place) {
        self.reader.fault::<()>(mistake, place);
        self.walked.whole = false;
    }

    fn here(&self) -> Option<Point> {
        Some(Point { radius: self.radius?, z: self.z? })
    }

    pub fn hollow(&self, hollow: bool) -> Turn {
        match (self.walked.side, hollow) {
            (Side::Outer, true) | (Side::Inner, false) => Turn::Left,
            (Side::Outer, false) | (Side::Inner, true) => Turn::Right,
        }
    }

    fn step(&mut self, index: usize, item: &ContourItem) {
        match &item.shape {
            ItemShape::From(to) if index == 0 => {
                (self.radius, self.z) = (radius_of(&to.d), z_of(&to.z));
                self.walked.start = self.here().map(|point| (point, item.place.clone()));
                if self.walked.side == Side::Inner && self.radius == Some(Half::ZERO) {
                    self.fault(mistake!("bore-begins-on-the-axis"), &item.place);
                }
            }
            ItemShape::From(_) => self.fault(mistake!("from-not-first"), &item.place),
            _ if index == 0 => self.fault(mistake!("first-item-not-from"), &item.place),
            ItemShape::Face(d, _) => self.straight(item, SurfaceKind::Face, (radius_of(d), self.z)),
            ItemShape::Cylinder(along, _) => {
                let z = self.z_after(along);
                self.straight(item, SurfaceKind::Cylinder, (self.radius, z));
            }
            ItemShape::Cone { to, chamfer } => {
                let kind = if *chamfer { SurfaceKind::Chamfer } else { SurfaceKind::Cone };
                let to = (radius_of(&to.d), z_of(&to.z));
                let (same_radius, same_z) = (to.0.is_some() && to.0 == self.radius, to.1.is_some() && to.1 == self.z);
                if same_radius != same_z {
                    self.fault(mistake!("cone-without-slant"), &item.place);
                }
                self.straight(item, kind, to);
            }
            ItemShape::Chamfer(size) => self.chamfer(index, item, size),
            ItemShape::Arc { to, radius, bulge } => self.arc(item, (radius_of(&to.d), z_of(&to.z)), radius, *bulge),
            ItemShape::Thread { size, along } => self.thread(item, size.as_ref(), along),
            ItemShape::Groove(values) => self.groove(index, item, values.as_ref()),
        }
    }

    fn z_after(&self, along: &Along) -> Option<Half> {
        match along {
            Along::Z(z) => z_of(z),
            Along::Length(length) => Some(self.z? + Half::of(length.as_ref()?.0)),
        }
    }

    fn straight(&mut self, item: &ContourItem, kind: SurfaceKind, to: (Option<Half>, Option<Half>)) {
        self.arrive(item, kind, to, Some(Curve::Line));
    }

    /// Goes to a point, as far as it is known; adds the surface if all of it is known.
    fn arrive(
        &mut self,
        item: &ContourItem,
        kind: SurfaceKind,
        to: (Option<Half>, Option<Half>),
        curve: Option<Curve>,
    ) {
        let from = self.here();
        (self.radius, self.z) = to;
        let (Some(from), Some(to), Some(curve)) = (from, self.here(), curve) else {
            self.walked.whole = false;
            return;
        };
        let piece = Piece { from, to, curve };
        let radius_place = match &item.shape {
            ItemShape::Arc { radius: Some((_, place)), .. } => place,
            _ => &item.place,
        };
        if let Some((radius, least)) = falls_short(piece) {
            self.fault(mistake!("arc-does-not-reach", radius = radius, least = least), radius_place);
        } else if self.leads_on(piece, kind, &item.place) {
            self.push(item, kind, vec![piece]);
        }
    }

    fn push(&mut self, item: &ContourItem, kind: SurfaceKind, pieces: Vec<Piece>) {
        let attributes = &item.attributes;
        let name = match &attributes.name {
            Some((name, _)) => SurfaceName::Given(name.clone()),
            None => SurfaceName::Place(self.walked.side, self.walked.surfaces.len() + 1),
        };
        let (roughness, stated_allowance) = (attributes.roughness, attributes.allowance);
        let field = attributes.field.clone();
        let limits = match &item.shape {
            ItemShape::Face(_, limits) | ItemShape::Cylinder(_, limits) => limits.clone(),
            _ => None,
        };
        if let Some((_, place)) = limits.as_ref().filter(|_| field.is_some()) {
            self.fault(mistake!("limits-beside-field"), place);
        }
        let size = pieces.first().map(|first| match kind {
            SurfaceKind::Face => Micrometres::new(first.from.z.halves() / 2),
            _ => first.from.radius.diameter(),
        });
        if let Some((Deviations { upper, lower }, place)) = &limits
            && size.is_some_and(|size| size <= upper.abs().max(lower.abs()))
        {
            self.fault(mistake!("limits-beyond-size", upper = upper, lower = lower), place);
        }
        let limits = limits.map(|(limits, _)| limits);
        let of_limits =
            || limits.zip(size).and_then(|(limits, size)| limits.grade(size, self.reader.knowledge).ok()?);
        let grade = attributes.grade.or_else(of_limits);
        let surface = Surface { name, kind, pieces, grade, field, limits, roughness, stated_allowance };
        self.walked.surfaces.push((surface, item.place.clone()));
    }

    pub fn last(&self) -> Option<&Surface> {
        self.walked.surfaces.last().map(|(surface, _)| surface)
    }

    /// Whether a piece outside of grooves has a permitted direction.
    fn leads_on(&mut self, piece: Piece, kind: SurfaceKind, place: &Place) -> bool {
        let (from, to) = (piece.from, piece.to);
        let after_groove = self.last().filter(|last| last.is_groove());
        let groove_went = after_groove.map(|groove| {
            groove
                .pieces
                .first()
                .zip(groove.pieces.last())
                .map_or(0, |(first, last)| (last.to.radius - first.from.radius).halves())
        });
        let back = (to.radius - from.radius).halves();
        let z_shown = |z: Half| Half::ZERO - z;
        let extremes = piece.extremes();
        if piece.is_nothing() {
            self.fault(mistake!("leads-nowhere", d = to.radius.diameter(), z = z_shown(to.z)), place);
        } else if to.z < from.z || (groove_went.is_some_and(|went| went * back < 0) && kind == SurfaceKind::Face) {
            let code = if groove_went.is_some() { "groove-over-neighbour" } else { "runs-back" };
            self.fault(mistake!(code, from = z_shown(from.z), to = z_shown(to.z)), place);
        } else if let Some(point) = extremes.iter().find(|point| point.z < from.z - SLACK || point.z > to.z + SLACK) {
            self.fault(mistake!("arc-swings-out", z = z_shown(point.z)), place);
        } else if extremes.iter().any(|point| point.radius < Half::ZERO - SLACK) {
            self.fault(mistake!("below-the-axis"), place);
        } else if from.radius == Half::ZERO
            && (to.radius == Half::ZERO && piece.curve == Curve::Line || self.last().is_some())
        {
            self.fault(mistake!("along-the-axis", z = z_shown(from.z)), place);
        } else {
            return true;
        }
        false
    }

    /// The direction of the radius: that of the face before, or of the face after, or of the edge at an end of the part.
    pub fn radial_way(&self, index: usize) -> Option<i64> {
        let before = self.last().filter(|last| last.kind == SurfaceKind::Face).and_then(|face| face.pieces.first());
        if let Some(face) = before {
            return Some((face.to.radius - face.from.radius).halves().signum());
        }
        if self.last().is_none() {
            return Some(if self.walked.side == Side::Outer { 1 } else { -1 });
        }
        // At the far end of the part it breaks the edge of the far face.
        let Some(next) = self.items.get(index + 1) else {
            return Some(if self.walked.side == Side::Outer { -1 } else { 1 });
        };
        match next.as_ref()?.shape {
            ItemShape::Face(ref d, _) => {
                Some((radius_of(d)? - self.radius?).halves().signum()).filter(|direction| *direction != 0)
            }
            _ => None,
        }
    }

    fn chamfer(&mut self, index: usize, item: &ContourItem, size: &Measure) {
        let after_face = self.last().is_none_or(|last| last.kind == SurfaceKind::Face);
        let Some((size, place)) = size else { return self.straight(item, SurfaceKind::Chamfer, (None, None)) };
        let side = Half::of(*size);
        let known = self.here().is_some();
        let Some(direction) = self.radial_way(index) else {
            if known {
                self.fault(mistake!("chamfer-which-way"), &item.place);
            }
            return self.straight(item, SurfaceKind::Chamfer, (None, None));
        };
        let face = match self.items.get(index + 1).and_then(Option::as_ref).map(|next| &next.shape) {
            Some(ItemShape::Face(d, _)) if !after_face => radius_of(d).zip(self.radius).map(|(to, from)| to - from),
            _ => None,
        };
        if let Some(face) = face.map(|face| Half::new(face.halves().abs())).filter(|face| *face < side) {
            self.fault(mistake!("chamfer-larger-than-face", chamfer = size, face = face), place);
        }
        let radius = self.radius.map(|radius| radius + Half::new(direction * side.halves()));
        self.straight(item, SurfaceKind::Chamfer, (radius, self.z.map(|z| z + side)));
    }

    fn arc(&mut self, item: &ContourItem, to: (Option<Half>, Option<Half>), radius: &Measure, bulge: Option<Bulge>) {
        let kind = if bulge == Some(Bulge::In) { SurfaceKind::Fillet } else { SurfaceKind::Ball };
        let radius = radius.as_ref().map(|(radius, _)| Half::of(*radius));
        let curve =
            radius.zip(bulge).map(|(radius, bulge)| Curve::Arc { radius, turn: self.hollow(bulge == Bulge::In) });
        self.arrive(item, kind, to, curve);
    }

    fn thread(&mut self, item: &ContourItem, thread_size: Option<&Placed<ThreadSize>>, along: &Along) {
        let z = self.z_after(along);
        if let Some(((thread_size, place), radius)) = thread_size.zip(self.radius) {
            let diameter = radius.diameter();
            if !thread_size.stands_on(diameter, self.walked.side) {
                let (code, least) = match self.walked.side {
                    Side::Outer => ("thread-on-another-diameter", thread_size.size),
                    Side::Inner => ("thread-in-another-bore", thread_size.minor.unwrap_or_default()),
                };
                let (thread, most) = (&thread_size.written, thread_size.size);
                self.fault(mistake!(code, thread = thread, diameter = diameter, least = least, most = most), place);
            }
        }
        let before = self.walked.surfaces.len();
        self.straight(item, SurfaceKind::Thread, (self.radius, z));
        match (thread_size, self.last()) {
            (Some((thread_size, _)), Some(surface)) if self.walked.surfaces.len() > before => {
                let (written, size, pitch) = (thread_size.written.clone(), thread_size.size, thread_size.pitch);
                let (crests, flanks) = thread_limits::of(thread_size, self.walked.side, self.reader.knowledge);
                let longest_run_out =
                    longest_run_out(self.walked.side, pitch, self.reader.knowledge).map(|row| row.length);
                let surface = surface.name.clone();
                let (tapped, way) = (None, None);
                let thread = Thread { surface, written, size, pitch, crests, flanks, longest_run_out, tapped, way };
                self.walked.threads.push(thread);
            }
            _ => self.walked.whole = false,
        }
    }

    fn groove(&mut self, index: usize, item: &ContourItem, values: Option<&GrooveValues>) {
        let drawn = values.zip(self.here()).and_then(|(values, here)| self.drawn(index, here, item, values));
        match (drawn, values) {
            (Some((kind, pieces)), _) => {
                (self.radius, self.z) = pieces.last().map(|piece| (piece.to.radius, piece.to.z)).unzip();
                self.push(item, kind, pieces);
            }
            (None, values) => {
                // A groove in a cylinder ends at the diameter of the cylinder, even if that is not known.
                if values.is_none_or(|values| matches!(values.kind, GrooveKind::Face | GrooveKind::Corner)) {
                    self.radius = None;
                }
                self.z = None;
                self.walked.whole = false;
            }
        }
    }
}

/// For an arc whose radius is less than half the distance of its ends, apart from rounding: the radius and that half.
fn falls_short(piece: Piece) -> Option<(Half, Half)> {
    let Curve::Arc { radius, .. } = piece.curve else { return None };
    let square = |half: Half| i128::from(half.halves()) * i128::from(half.halves());
    let (z, r) = (piece.to.z - piece.from.z, piece.to.radius - piece.from.radius);
    let short = square(z) + square(r) > square(radius + radius + SLACK);
    short.then(|| (radius, Half::from(piece.chord().length() / 2.0)))
}
