//! The sizes that the lathe makes: a diameter with a fit is turned in the middle of its limits, as turners do.
//!
//! What another machine finishes gets its size there; what a tool on the axis makes has the size of that tool; a cylinder of the
//! blank stays as it is. Those keep the size of the drawing, and a field that leaves it out is a finding.

use serde::Serialize;
use technolog_core::part::Deviations;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Finding, Note, Severity};
use crate::tables::turning::jobs::JobLimit;
use crate::turning::allowances::Elsewhere;
use crate::turning::contour::{
    Contour, Field, Piece, Profile, Resized, Side, Slopes, Surface, SurfaceKind, SurfaceName, resized,
};
use crate::turning::jobs::limits::Limits;
use crate::turning::length::Half;
use crate::turning::workpiece::Workpiece;
use crate::turning::zones::SetUp;
use crate::units::Micrometres;

use super::{Axial, thin};

/// What a size is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SizeOf {
    /// The diameter of a cylinder.
    Diameter,
    /// The distance of a face from the free end.
    Length,
}

/// A size that is turned between its limits.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sized {
    /// Its surface.
    pub surface: SurfaceName,
    /// Outside or inside.
    pub side: Side,
    /// A diameter or a length.
    pub of: SizeOf,
    /// The field or the deviations of the drawing.
    pub fit: String,
    /// The nominal size, mm.
    pub nominal_mm: Micrometres,
    /// The least size, mm.
    pub least_mm: Micrometres,
    /// The largest size, mm.
    pub most_mm: Micrometres,
    /// The size that is programmed, mm: the middle, of a diameter rounded to a micrometre on the side of more metal.
    pub made_mm: Half,
}

impl Sized {
    /// The width between its limits.
    pub fn tolerance(&self) -> Micrometres {
        self.most_mm - self.least_mm
    }

    /// The radius that is programmed, of a diameter.
    pub fn made_radius(&self) -> Half {
        Half::new(self.made_mm.halves() / 2)
    }
}

/// The sizes of a part.
#[derive(Clone, Debug, Default)]
pub struct Sizes {
    /// The sizes with limits.
    pub surfaces: Vec<Sized>,
    outer: Vec<Resized>,
    inner: Vec<Resized>,
    slopes: Slopes,
    length: Half,
}

impl Sizes {
    /// The sizes of a part whose surfaces are finished elsewhere or on the axis as given, and a finding for each field that leaves
    /// out the size that is made.
    ///
    /// # Errors
    /// The knowledge base lacks a table.
    pub fn of(
        workpiece: &Workpiece,
        elsewhere: &[Elsewhere],
        axials: &[Option<Axial>],
        knowledge: &Knowledge,
    ) -> Result<(Self, Vec<Finding>), KnowledgeError> {
        let mut limits = Limits::of(knowledge);
        let slopes = Slopes {
            rise: limits.ratio(JobLimit::FitRise)?,
            fall: limits.ratio(JobLimit::FitFall)?,
            far: limits.length(JobLimit::FitSlopeFar)?.to_mm(),
        };
        let mut sizes = Self { length: workpiece.length(), slopes, ..Self::default() };
        let mut findings = Vec::new();
        for profile in std::iter::once(&workpiece.outer).chain(&workpiece.inner) {
            let blank = workpiece.blank.contour(profile.side);
            let mut cylinders = Vec::new();
            for (index, surface) in profile.surfaces.iter().enumerate() {
                let later = elsewhere.iter().any(|one| one.surface == surface.name);
                let on_axis = axials.iter().flatten().flat_map(Axial::surfaces).any(|name| *name == surface.name);
                let stays = later || on_axis || blank.is_some_and(|blank| thin::is_of_blank(surface, blank));
                let sized = limited(surface, profile.side, knowledge)?;
                let turned = sized.filter(|one| !stays && (one.of == SizeOf::Length || floor(surface).is_some()));
                if turned.is_none() && !later {
                    findings.extend(off_size(surface, knowledge)?);
                }
                cylinders.extend(floor(surface).map(|piece| Cylinder {
                    index,
                    piece,
                    made: match &turned {
                        Some(sized) => Some(sized.made_radius()),
                        None if stays || is_fixed(surface) => Some(piece.from.radius),
                        None => None,
                    },
                }));
                sizes.surfaces.extend(turned);
            }
            let made = as_made(profile, &cylinders);
            match profile.side {
                Side::Outer => sizes.outer = made,
                Side::Inner => sizes.inner = made,
            }
        }
        Ok((sizes, findings))
    }

    /// The limits of a surface.
    pub fn of_surface(&self, name: &SurfaceName) -> Option<&Sized> {
        self.surfaces.iter().find(|one| one.surface == *name)
    }

    /// A contour of a set-up as it is made.
    pub fn contour(&self, contour: Contour, set_up: &SetUp) -> Contour {
        let all = self.seen(contour.side, set_up.turned_over);
        if all.is_empty() {
            return contour;
        }
        let marked = contour.pieces.into_iter().map(|piece| (piece, ())).collect();
        let pieces = resized(marked, contour.side, &all, self.slopes).into_iter().map(|(piece, ())| piece).collect();
        Contour { side: contour.side, pieces }
    }

    /// A profile as it is made, of the part turned over or not.
    pub fn profile(&self, profile: &Profile, turned_over: bool) -> Profile {
        let all = self.seen(profile.side, turned_over);
        if all.is_empty() {
            return profile.clone();
        }
        let marked = profile.surfaces.iter().enumerate();
        let marked = marked.flat_map(|(index, surface)| surface.pieces.iter().map(move |piece| (*piece, index)));
        let made = resized(marked.collect(), profile.side, &all, self.slopes);
        let own = |index| made.iter().filter(|(_, of)| *of == index).map(|(piece, _)| *piece).collect();
        let surfaces = profile.surfaces.iter().enumerate();
        let surfaces = surfaces.map(|(index, surface)| Surface { pieces: own(index), ..surface.clone() }).collect();
        Profile { side: profile.side, surfaces }
    }

    fn seen(&self, side: Side, turned_over: bool) -> Vec<Resized> {
        let all = match side {
            Side::Outer => &self.outer,
            Side::Inner => &self.inner,
        };
        all.iter().map(|one| if turned_over { one.turned_over(self.length) } else { *one }).collect()
    }
}

/// The limits of a surface; none if the drawing gives none, or the tables do not tell those of its field.
fn limited(surface: &Surface, side: Side, knowledge: &Knowledge) -> Result<Option<Sized>, KnowledgeError> {
    if surface.kind == SurfaceKind::Face {
        return Ok(surface.limits.zip(surface.pieces.first()).map(|(limits, piece)| {
            // It stands in the middle already.
            let made_mm = piece.from.z;
            let nominal = Micrometres::new((made_mm.halves() - limits.twice_middle().micrometres()) / 2);
            let fit = limits.to_string();
            Sized { of: SizeOf::Length, made_mm, ..sized(surface, side, fit, nominal, limits) }
        }));
    }
    let Some(nominal) = size(surface) else { return Ok(None) };
    let (fit, limits) = asked(surface, nominal, knowledge)?;
    Ok(limits.map(|limits| sized(surface, side, fit, nominal, limits)))
}

/// The limits of a size as the drawing writes them, and as deviations where the tables tell those of its field.
fn asked(
    surface: &Surface,
    nominal: Micrometres,
    knowledge: &Knowledge,
) -> Result<(String, Option<Deviations>), KnowledgeError> {
    let of_field = |field: &Field| Deviations::of_field(&field.letters, field.grade, nominal, knowledge);
    let field = surface.field.as_ref();
    let limits = match surface.limits {
        Some(limits) => Some(limits),
        None => field.map(of_field).transpose()?.flatten(),
    };
    Ok((written(surface), limits))
}

/// The field or the deviations of a surface as the drawing writes them; nothing where it has none.
pub(super) fn written(surface: &Surface) -> String {
    let limits = surface.limits.map(|limits| limits.to_string());
    limits.or(surface.field.as_ref().map(Field::to_string)).unwrap_or_default()
}

/// A diameter between its limits.
fn sized(surface: &Surface, side: Side, fit: String, nominal: Micrometres, limits: Deviations) -> Sized {
    let twice = limits.twice_middle();
    let middle = if side == Side::Outer { -(-twice).half() } else { twice.half() };
    Sized {
        surface: surface.name.clone(),
        side,
        of: SizeOf::Diameter,
        fit,
        nominal_mm: nominal,
        least_mm: nominal + limits.lower,
        most_mm: nominal + limits.upper,
        made_mm: Half::of(nominal + middle),
    }
}

/// The finding that the limits of a surface leave out the size of the drawing, which is what is made of it.
fn off_size(surface: &Surface, knowledge: &Knowledge) -> Result<Option<Finding>, KnowledgeError> {
    let Some(diameter) = size(surface) else { return Ok(None) };
    let (field, limits) = asked(surface, diameter, knowledge)?;
    let held = match (limits, &surface.field) {
        (Some(limits), _) => (limits.lower..=limits.upper).contains(&Micrometres::ZERO),
        (None, Some(field)) => field.has_nominal(diameter, knowledge)?,
        (None, None) => true,
    };
    let note = Note::new("field-off-size").with("surface", &surface.name).with("diameter", diameter);
    Ok((!held).then(|| Finding::of_part(Severity::Wrong, note.with("field", field))))
}

/// The diameter that a field is of: that of a cylinder, also of the floor of a groove, else the largest. A face has a length, whose
/// size the contour does not tell, and a thread has classes of its own.
fn size(surface: &Surface) -> Option<Micrometres> {
    if matches!(surface.kind, SurfaceKind::Face | SurfaceKind::FaceGroove | SurfaceKind::Thread) {
        return None;
    }
    let straight = surface.pieces.iter().find(|piece| piece.is_cylinder());
    let largest = || surface.pieces.iter().map(|piece| piece.from.radius.max(piece.to.radius)).max();
    straight.map(|piece| piece.from.radius).or_else(largest).map(|radius| radius.diameter())
}

/// The cylinder of a surface, or the floor of a rectangular groove.
fn floor(surface: &Surface) -> Option<Piece> {
    match (surface.kind, surface.pieces.as_slice()) {
        (SurfaceKind::RectangularGroove, [before, floor, behind]) => {
            (before.is_face() && floor.is_cylinder() && behind.is_face()).then_some(*floor)
        }
        _ => surface.cylinder(),
    }
}

/// Whether the drawing asks for the size of a surface; another one is turned with its neighbour of the same diameter.
fn is_fixed(surface: &Surface) -> bool {
    surface.kind != SurfaceKind::Cylinder || surface.grade.is_some() || surface.limits.is_some()
}

/// A cylinder of a profile; `made` is its radius if it has one of its own.
struct Cylinder {
    index: usize,
    piece: Piece,
    made: Option<Half>,
}

/// The cylinders as they are made: one without a size of its own has that of its neighbour on the same diameter, before or behind
/// it, also over grooves; alone it has that of the drawing. The floor of a groove has its own.
fn as_made(profile: &Profile, cylinders: &[Cylinder]) -> Vec<Resized> {
    let of_groove = |one: &&Cylinder| profile.surfaces.get(one.index).is_some_and(Surface::is_groove);
    let (floors, walls): (Vec<&Cylinder>, Vec<&Cylinder>) = cylinders.iter().partition(of_groove);
    let on = |one: &Cylinder, next: &Cylinder| {
        let mut between = profile.surfaces.get(one.index + 1..next.index).unwrap_or_default().iter();
        between.all(Surface::is_groove) && one.piece.from.radius == next.piece.from.radius
    };
    let mut made: Vec<Option<Half>> = walls.iter().map(|one| one.made).collect();
    for index in 1..walls.len() {
        if made[index].is_none() && on(walls[index - 1], walls[index]) {
            made[index] = made[index - 1];
        }
    }
    for index in (1..walls.len()).rev() {
        if made[index - 1].is_none() && on(walls[index - 1], walls[index]) {
            made[index - 1] = made[index];
        }
    }
    let floors = floors.into_iter().map(|one| (one, one.made));
    let each = walls.iter().copied().zip(made).chain(floors).map(|(one, made)| {
        let Piece { from, to, .. } = one.piece;
        Resized { drawn: from.radius, made: made.unwrap_or(from.radius), from: from.z, to: to.z }
    });
    let all: Vec<Resized> = each.collect();
    if all.iter().any(|one| one.made != one.drawn) { all } else { Vec::new() }
}
