//! The narrow end of a bore, which tools on the axis make to size: no boring bar enters it, or a tap follows the drill (rule
//! `axial-hole`).
//!
//! It is found on the bore of a set-up before anything is bored. What is left of the bore is bored as if it ended there.

mod far;
mod mouth;
mod sizes;

use serde::Serialize;

use crate::error::{KnowledgeError, Tried};
use crate::knowledge::vocabulary::Operation;
use crate::note::{Because, Figure, Finding, Note};
use crate::tables::turning::part::{AxialHoleFor, AxialWay};
use crate::turning::contour::{Contour, Piece, Profile, Surface, SurfaceKind, SurfaceName};
use crate::turning::cutting::unsaid_roughness;
use crate::turning::elements::Main;
use crate::turning::jobs::hole::{self, Hole, HoleEnd, Widening, point_length};
use crate::turning::jobs::{Job, NoJob, Site};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::zones::TurnedSide;
use crate::units::{ItGrade, Micrometres, Roughness};

use super::features::{made, thread_job};
use super::tools::Bench;
use mouth::{far_mouth, mouth};
use sizes::Sizes;

pub use mouth::MouthOf;

/// A cylinder that is made on the axis, with what ends it.
#[derive(Clone, Debug, Serialize)]
pub struct AxialHole {
    /// Its diameter, mm.
    pub diameter_mm: Micrometres,
    /// How it is made.
    pub way: AxialWay,
    /// Whether a core drill goes before the reamer.
    pub core_drilled: bool,
    /// Its surfaces: the cylinder, and its bottom or its cone.
    pub surfaces: Vec<SurfaceName>,
    /// The threads on the cylinder, which the drill does not make.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub threads: Vec<SurfaceName>,
    /// How far behind its end the drill of a tapped hole goes, if it goes through.
    #[serde(skip)]
    pub tapped: Option<Half>,
    /// The chamfer at its mouth, if a countersink makes it.
    #[serde(skip)]
    pub mouth: Option<MouthOf>,
    /// Z where it begins in the set-up, mm.
    #[serde(skip)]
    pub begins: Half,
    /// Its end.
    #[serde(skip)]
    pub end: AxialEnd,
    /// The grade and the roughness that it must have.
    #[serde(skip)]
    pub asked: (Option<ItGrade>, Option<Roughness>),
    /// The row.
    pub because: Because,
}

/// The end of such a cylinder, at a Z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxialEnd {
    /// The metal ends there, or a wider bore begins.
    Through(Half),
    /// The cone of a drill's point begins there.
    Point(Half),
    /// A flat bottom, or a shoulder around a narrower hole of a radius.
    Flat(Half, Half),
}

impl AxialEnd {
    /// Z of the end of the cylinder.
    const fn z(self) -> Half {
        match self {
            Self::Through(z) | Self::Point(z) | Self::Flat(z, _) => z,
        }
    }
}

/// The narrow end of a bore.
#[derive(Clone, Debug, Serialize)]
pub struct Axial {
    /// Its cylinders, from the widest.
    pub holes: Vec<AxialHole>,
    /// The chamfer of a hole that is made from the other end.
    #[serde(skip)]
    pub far_mouth: Option<MouthOf>,
    /// What is bored before it; none if it is the whole bore.
    #[serde(skip)]
    pub bored: Option<TurnedSide>,
    /// The whole bore, for the threads in it.
    #[serde(skip)]
    whole: Profile,
    /// Threads behind a plain cylinder of their diameter, which are tapped from the other end.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub left: Vec<SurfaceName>,
    /// The bore of the part as this set-up sees it, and the threads in it that the set-up before has left.
    #[serde(skip)]
    far: Option<(Profile, Vec<SurfaceName>)>,
}

impl Axial {
    /// The narrow end of a bore; none if a bar makes all of it.
    ///
    /// # Errors
    /// The knowledge base lacks the rule `axial-hole`, or a row of it.
    pub fn of(stretch: &TurnedSide, bench: &Bench<'_, '_>) -> Result<Option<Self>, KnowledgeError> {
        let surfaces = &stretch.profile.surfaces;
        let mut holes: Vec<AxialHole> = Vec::new();
        let mut first = surfaces.len();
        while let Some((index, end)) = next(surfaces, first, holes.last()) {
            let Some(mut hole) = axial(surfaces, index, first, end, bench)? else { break };
            hole.mouth = mouth(surfaces, index, hole.diameter_mm, bench)?;
            first = if hole.mouth.is_some() { index - 1 } else { index };
            holes.push(hole);
        }
        holes.reverse();
        let far_mouth = if holes.is_empty() { far_mouth(surfaces, bench)? } else { None };
        if holes.is_empty() && far_mouth.is_none() {
            return Ok(None);
        }
        let bored = if first == 0 || far_mouth.is_some() { None } else { Some(before(stretch, first, &holes)) };
        let whole = stretch.profile.clone();
        Ok(Some(Self { holes, far_mouth, bored, whole, left: Vec::new(), far: None }))
    }

    /// The names of the surfaces that it makes.
    pub fn surfaces(&self) -> impl Iterator<Item = &SurfaceName> {
        let mouths = self.holes.iter().filter_map(|hole| hole.mouth.as_ref()).chain(&self.far_mouth);
        self.holes.iter().flat_map(|hole| &hole.surfaces).chain(mouths.map(|mouth| &mouth.surface))
    }

    /// The names of the threads in it, under which it is drilled.
    pub fn threads(&self) -> impl Iterator<Item = &SurfaceName> {
        let own = self.holes.iter().flat_map(|hole| &hole.threads).filter(|name| !self.left.contains(name));
        own.chain(self.far())
    }

    /// Whether a surface is the cone that the point of its drill leaves.
    pub fn is_point(&self, name: &SurfaceName) -> bool {
        self.holes.iter().any(|hole| matches!(hole.end, AxialEnd::Point(_)) && hole.surfaces.last() == Some(name))
    }

    /// The diameter of the drill at its beginning, where the bored part ends.
    ///
    /// # Errors
    /// The knowledge base lacks a table.
    pub fn drill(&self, bench: &Bench<'_, '_>) -> Result<Micrometres, KnowledgeError> {
        match self.holes.first() {
            Some(hole) => Ok(Sizes::of(hole, bench)?.drill),
            None => Ok(Micrometres::ZERO),
        }
    }

    /// Its jobs, from the narrowest hole, which guides the others; `face` is Z of the rough face. A job that cannot be made is a
    /// finding, and ends the list.
    ///
    /// # Errors
    /// The knowledge base lacks a table.
    pub fn jobs(
        &self,
        face: Half,
        bench: &Bench<'_, '_>,
        findings: &mut Vec<Finding>,
    ) -> Result<Vec<Job>, KnowledgeError> {
        let mut jobs = Vec::new();
        let mut from = bench.raw_bore();
        for hole in self.holes.iter().rev() {
            let sizes = Sizes::of(hole, bench)?;
            let Some(own) = made(hole.jobs(&sizes, from, face, bench), findings)? else { return Ok(jobs) };
            jobs.extend(own);
            from = from.max(sizes.drill);
        }
        for mouth in self.holes.iter().filter_map(|hole| hole.mouth.as_ref()).chain(&self.far_mouth) {
            jobs.extend(made(hole::countersink(&mouth.task(face), bench), findings)?);
        }
        let [approach, off] = bench.approach_and_retract()?;
        for profile in std::iter::once(&self.whole).chain(self.far.iter().map(|(whole, _)| whole)) {
            let threads = profile.surfaces.iter().enumerate();
            for (index, surface) in threads.filter(|(_, surface)| self.threads().any(|name| *name == surface.name)) {
                let Some(radius) = surface.cylinder().map(|piece| piece.from.radius) else { continue };
                let clear = Point { radius: radius - off, z: face - approach };
                jobs.extend(thread_job(Site { profile, clear, off }, index, face, bench, findings)?);
            }
        }
        Ok(jobs)
    }
}

/// The next cylinder towards the free end that could be made on the axis: the index of its first surface, and its end. `first` is the
/// index of the first surface behind it that is taken, `behind` the hole there. Cylinders of one diameter, threads among them, are
/// one.
fn next(surfaces: &[Surface], first: usize, behind: Option<&AxialHole>) -> Option<(usize, AxialEnd)> {
    let before = surfaces.get(..first)?;
    let (index, end) = last_cylinder(before, behind)?;
    let radius = before.get(index)?.cylinder()?.from.radius;
    let same = |surface: &&Surface| surface.cylinder().is_some_and(|other| other.from.radius == radius);
    Some((index - before.get(..index)?.iter().rev().take_while(same).count(), end))
}

/// The last cylinder before what is taken.
fn last_cylinder(before: &[Surface], behind: Option<&AxialHole>) -> Option<(usize, AxialEnd)> {
    let (last, others) = before.split_last()?;
    let index = others.len();
    if let Some(cylinder) = last.cylinder() {
        // Straight to the end of the metal; a wider cylinder that is made to size needs a shoulder.
        return behind.is_none().then_some((index, AxialEnd::Through(cylinder.to.z)));
    }
    let Point { radius: wide, z } = others.last()?.cylinder()?.to;
    let [piece] = last.pieces.as_slice() else { return None };
    let within = piece.to.radius;
    // Without a hole behind it the narrower one is made from the other end.
    let edge = |hole: &AxialHole| hole.mouth.as_ref().map_or(hole.diameter_mm, |mouth| mouth.wide);
    let is_shoulder = behind.is_none_or(|hole| Half::radius_of(edge(hole)) == within);
    if piece.is_face() && within < wide && is_shoulder {
        return Some((index - 1, AxialEnd::Flat(z, within)));
    }
    let to_axis = behind.is_none() && piece.to.radius == Half::ZERO && piece.from.radius == wide;
    let is_point = (piece.to.z - piece.from.z - point_length(wide)).to_mm().abs() <= POINT_TOLERANCE * wide.to_mm();
    (to_axis && last.kind == SurfaceKind::Cone && is_point).then_some((index - 1, AxialEnd::Point(z)))
}

/// How far the drawn cone of a hole's bottom may differ from that of a drill of 118°, in radii: drawings have it at 120°, which is
/// 0.024 of the radius shorter.
const POINT_TOLERANCE: f64 = 0.03;

/// The cylinder as the rule has it made; none if it is bored.
fn axial(
    surfaces: &[Surface],
    index: usize,
    first: usize,
    end: AxialEnd,
    bench: &Bench<'_, '_>,
) -> Result<Option<AxialHole>, KnowledgeError> {
    let Some(surface) = surfaces.get(index) else { return Ok(None) };
    let Some(begin) = surface.pieces.first().map(|piece| piece.from) else { return Ok(None) };
    let taken = surfaces.get(index..first).unwrap_or_default();
    // What a thread asks for is of its flanks; the hole under it is drilled.
    let is_thread = |surface: &&Surface| surface.kind == SurfaceKind::Thread;
    let plain = || taken.iter().filter(|one| one.cylinder().is_some() && !is_thread(one));
    let (it, roughness) = (plain().filter_map(|one| one.grade).min(), plain().filter_map(|one| one.roughness).min());
    let threads: Vec<SurfaceName> = taken.iter().filter(is_thread).map(|one| one.name.clone()).collect();
    let tapped = bench.workpiece.threads.iter().filter(|thread| thread.tapped.is_some());
    let tapped = tapped.filter(|thread| threads.contains(&thread.surface));
    let tapped = tapped.map(|thread| hole::drilled_behind(thread, bench)).collect::<Result<Vec<_>, _>>()?;
    let tapped = tapped.into_iter().max();
    let diameter = begin.radius.diameter();
    if diameter <= Micrometres::ZERO {
        return Ok(None);
    }
    let asked = bench.knowledge.ask(&AxialHoleFor { diameter, tapped: tapped.is_some(), it, roughness })?;
    let rule = asked.need(&diameter.to_string())?;
    // Without a drill of its very size a drilled hole is bored, as far as a bar enters.
    let no_drill = rule.made == AxialWay::Drilled && !hole::has_drill(diameter, bench)?;
    if rule.made == AxialWay::Bored || no_drill {
        return Ok(None);
    }
    let note = Note::new("axial-hole").with("surface", &surface.name).with("diameter", diameter);
    let note = note.with("way", Figure::word(rule.made.name()));
    Ok(Some(AxialHole {
        diameter_mm: diameter,
        way: rule.made,
        core_drilled: rule.core_drilled,
        surfaces: taken.iter().filter(|one| !is_thread(one)).map(|one| one.name.clone()).collect(),
        threads,
        tapped,
        mouth: None,
        begins: begin.z,
        end,
        asked: (it, roughness),
        because: Because::answer(&asked.answer, note),
    }))
}

/// The bore before the first hole, which begins with it. Over a countersunk mouth its bottom goes on to the hole.
fn before(stretch: &TurnedSide, first: usize, holes: &[AxialHole]) -> TurnedSide {
    let mouth = holes.first().and_then(|hole| hole.mouth.as_ref());
    let begin = mouth.map_or_else(|| holes.first().map_or(Half::ZERO, |hole| hole.begins), |mouth| mouth.face);
    let mut kept: Vec<Surface> = stretch.profile.surfaces.iter().take(first).cloned().collect();
    let pieces = stretch.main.contour.pieces.iter().filter(|piece| piece.from.z <= begin && piece.to.z <= begin);
    let mut pieces: Vec<Piece> = pieces.copied().collect();
    if let Some(mouth) = mouth {
        let last = kept.last_mut().and_then(|surface| surface.pieces.last_mut());
        for bottom in last.into_iter().chain(pieces.last_mut()) {
            bottom.to.radius = Half::radius_of(mouth.hole);
        }
    }
    TurnedSide {
        profile: Profile { side: stretch.profile.side, surfaces: kept },
        classes: stretch.classes.iter().take(first).cloned().collect(),
        main: Main {
            contour: Contour { side: stretch.main.contour.side, pieces },
            valleys: stretch.main.valleys.iter().filter(|valley| valley.lips.1.z <= begin).cloned().collect(),
        },
    }
}

impl AxialHole {
    /// Its jobs; `from` is the diameter of the hole that is there, which may be as wide as the drill.
    fn jobs(&self, sizes: &Sizes, from: Micrometres, face: Half, bench: &Bench<'_, '_>) -> Tried<Vec<Job>, NoJob> {
        let mut jobs = Vec::new();
        let last = self.way == AxialWay::Drilled;
        let own = |is_last: bool| if is_last { self.surfaces.clone() } else { Vec::new() };
        let end = match self.end {
            AxialEnd::Through(z) => HoleEnd::Through(bench.through(z + self.tapped.unwrap_or_default())),
            // The point of a narrower drill ends where that of the hole does.
            AxialEnd::Point(z) => HoleEnd::Blind(z + point_length(Half::radius_of(self.diameter_mm))),
            AxialEnd::Flat(z, within) => HoleEnd::Blind(z + point_length(Half::radius_of(from).max(within))),
        };
        let mut before = from;
        if from < sizes.drill {
            if from == Micrometres::ZERO {
                jobs.push(hole::spot(sizes.drill, face, self.end.z(), bench)?);
            }
            let flat = matches!(self.end, AxialEnd::Flat(..));
            let exact = last || sizes.core_drill.is_none();
            let surfaces = own(last && !flat);
            let tapped = self.tapped.is_some();
            let task = Hole { diameter: sizes.drill, from, face, end, surfaces, exact, tapped };
            let mut all = hole::drilling(&task, bench)?;
            let Some(mut drilled) = all.pop() else { return Ok(jobs) };
            jobs.extend(all);
            drilled.because.push(self.because.clone());
            drilled.because.extend(sizes.because.clone());
            before = drilled.tool.diameter().unwrap_or_default();
            let flattened = flat.then(|| hole::flatten(&drilled, self.end.z(), face, own(last), bench)).transpose()?;
            jobs.extend([Some(drilled), flattened].into_iter().flatten());
        }
        let after = [
            (Operation::CoreDrill, sizes.core_drill),
            (Operation::RoughReam, sizes.rough_ream),
            (Operation::FinishReam, (!last).then_some(self.diameter_mm)),
        ];
        for (operation, diameter) in after.into_iter().filter_map(|(operation, size)| Some((operation, size?))) {
            let is_last = operation == Operation::FinishReam;
            // The front of the tool is narrower than the drill, whose cone begins where its wall ends.
            let end = match self.end {
                AxialEnd::Through(z) => HoleEnd::Through(z),
                AxialEnd::Point(z) | AxialEnd::Flat(z, _) => HoleEnd::Blind(z),
            };
            // A grade asks for a surface even where the drawing gives none.
            let (it, roughness) = match self.asked {
                (it, asked) if is_last => {
                    (it, Some(asked.map_or_else(|| unsaid_roughness(it, bench.knowledge).map(|one| one.0), Ok)?))
                }
                _ => (None, None),
            };
            let task = Widening { operation, diameter, from: before, face, end, surfaces: own(is_last), it, roughness };
            jobs.push(hole::widen(&task, bench)?);
            before = diameter;
        }
        Ok(jobs)
    }
}
