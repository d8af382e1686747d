//! A part that is parted off its bar at the end of the first set-up.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::note::Finding;
use crate::turning::contour::{Contour, SurfaceName};
use crate::turning::jobs::Job;
use crate::turning::jobs::part_off::{Parting, face_stock, jaw_gap, part_off, width};
use crate::turning::length::Half;
use crate::turning::shaft::Holding;
use crate::turning::workpiece::{StockKind, Workpiece};
use crate::turning::zones::JawLengths;
use crate::units::Micrometres;

use super::features::made;
use super::tools::Bench;
use super::{Jaws, clip};

/// Where a bar is parted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Parted {
    /// The stock on the far face, for the second set-up; zero where there is none.
    pub stock: Half,
    /// The width of the blade.
    width: Half,
    /// From the blade to the jaws.
    gap: Half,
    /// The length of the part.
    length: Half,
    /// The hole that is drilled through to where the blade goes: at least that wide; zero in solid metal.
    drilled: Micrometres,
}

technolog_knowledge::vocabulary! {
    /// Why a bar is not parted behind the part.
    pub(super) enum NotParted {
        /// The blank is no bar or tube in a chuck.
        NoBar = "no-bar",
        /// A centre stands in its free end: the part would jam the blade between centre and chuck as it comes off.
        Centre = "centre",
        /// A steady rest stands before the place.
        Rest = "rest",
        /// No blade of the catalog reaches the axis.
        NoBlade = "no-blade",
        /// Too little of the blank is left for the jaws.
        Short = "short",
        /// The hole through the part is too narrow.
        Hole = "hole",
    }
}

impl Parted {
    /// Parting behind the part, where its bar or tube is long enough for the blade and the jaws behind it, and thin enough for a
    /// blade of the catalog; with the stock for a second set-up.
    ///
    /// # Errors
    /// Why not; or the knowledge base lacks a table.
    pub fn of(workpiece: &Workpiece, bench: &Bench<'_, '_>) -> Tried<Self, NotParted> {
        let bar = matches!(workpiece.blank.kind, StockKind::Bar | StockKind::Tube);
        if workpiece.holding != Holding::Chuck || !bar || bench.lathe.is_none() {
            let centre = workpiece.holding == Holding::ChuckAndCentre && bar;
            return Err(Refusal::Not(if centre { NotParted::Centre } else { NotParted::NoBar }));
        }
        if workpiece.steady_rest.is_some() {
            return Err(Refusal::Not(NotParted::Rest));
        }
        let (stock, gap) = (Half::of(face_stock(bench)?), Half::of(jaw_gap(bench)?));
        let mut parted =
            Self { stock, width: Half::ZERO, gap, length: workpiece.length(), drilled: drilled_through(workpiece) };
        let task = parted.task(workpiece, None, parted.drilled);
        let Ok(blade) = Refusal::split(width(&task, bench))? else {
            return Err(Refusal::Not(NotParted::NoBlade));
        };
        parted.width = Half::of(blade);
        let least = JawLengths::of(task.bar, bench.knowledge)?.least;
        if workpiece.blank.end() - parted.jaws_from() < least {
            return Err(Refusal::Not(NotParted::Short));
        }
        Ok(parted)
    }

    /// Z of the face that it leaves.
    pub fn face(self) -> Half {
        self.length + self.stock
    }

    /// Z from which the jaws may stand.
    pub fn jaws_from(self) -> Half {
        self.face() + self.width + self.gap
    }

    /// Whether it counts on a hole that is drilled through the part.
    pub fn counts_on_hole(self) -> bool {
        self.drilled > Micrometres::ZERO
    }

    /// How deep a through hole is drilled for it: past the blade. None where nothing is drilled through.
    pub fn drilled_to(self) -> Option<Half> {
        self.counts_on_hole().then(|| self.face() + self.width)
    }

    /// Without stock: nothing follows.
    pub const fn to_length(self) -> Self {
        Self { stock: Half::ZERO, ..self }
    }

    /// The part with the blank that is left of the bar.
    pub fn workpiece(self, workpiece: &Workpiece) -> Workpiece {
        let mut parted = workpiece.clone();
        parted.blank.outer = self.cut(&workpiece.blank.outer);
        parted.blank.inner = workpiece.blank.inner.as_ref().map(|inner| self.cut(inner));
        parted
    }

    /// A contour of the bar up to the face that parting leaves, with the face of its free end.
    fn cut(self, contour: &Contour) -> Contour {
        let from = contour.start().map_or(Half::ZERO, |start| start.z);
        let mut cut = clip::between(contour, from, self.face());
        if let Some(first) = contour.pieces.first().filter(|first| first.is_face()) {
            cut.pieces.insert(0, *first);
        }
        cut
    }

    fn task(self, workpiece: &Workpiece, jaws: Option<&Jaws>, drilled: Micrometres) -> Parting {
        let at = workpiece.blank.outer.radii().map_or(Half::ZERO, |(_, most)| most);
        let bore = workpiece.blank.inner.as_ref().and_then(Contour::radii).map_or(Half::ZERO, |(least, _)| least);
        let ends = workpiece
            .outer
            .surfaces
            .iter()
            .filter(|surface| surface.pieces.iter().all(|piece| piece.is_face() && piece.from.z == self.length));
        let surfaces: Vec<SurfaceName> = ends.map(|surface| surface.name.clone()).collect();
        Parting {
            bar: at.diameter(),
            solid: (at - bore).diameter(),
            bore: bore.diameter().max(drilled),
            breaks: end_of_bore(workpiece),
            face: self.face(),
            jaws: jaws.map(|jaws| jaws.front_mm),
            clear: at + Half::of(CLEAR),
            surfaces: if self.stock == Half::ZERO { surfaces } else { Vec::new() },
        }
    }

    /// The job after those before it; none, with a finding, if it cannot be made.
    ///
    /// # Errors
    /// The knowledge base lacks a table.
    pub fn job(
        self,
        jaws: Option<&Jaws>,
        before: &[Job],
        bench: &Bench<'_, '_>,
        findings: &mut Vec<Finding>,
    ) -> Result<Option<Job>, KnowledgeError> {
        let past = self.drilled_to();
        let through = before.iter().filter(|job| past.is_some_and(|past| job.comes_to(past)));
        let drilled = through.filter_map(Job::drills).max().unwrap_or_default();
        made(part_off(&self.task(bench.workpiece, jaws, drilled), bench), findings)
    }
}

/// The diameter of the bore at the far end; zero where none goes through.
fn end_of_bore(workpiece: &Workpiece) -> Micrometres {
    let end = workpiece.inner.as_ref().and_then(|inner| inner.contour().end());
    end.filter(|end| end.z == workpiece.length()).map_or(Half::ZERO, |end| end.radius).diameter()
}

/// The least diameter of the hole that is drilled from the free end through the whole part; zero where the bore of the part does
/// not end with its narrowest cylinder, or a blank has a bore of its own.
fn drilled_through(workpiece: &Workpiece) -> Micrometres {
    /// The most by which a drill is narrower than the bore that follows it, mm: 2 × 1 of stock, the allowance, and whole millimetres.
    const UNDER_BORE: Micrometres = Micrometres::from_mm(4);
    let Some(inner) = workpiece.inner.as_ref().filter(|_| workpiece.blank.inner.is_none()) else {
        return Micrometres::ZERO;
    };
    let contour = inner.contour();
    let (Some(end), Some((least, _))) = (contour.end(), contour.radii()) else { return Micrometres::ZERO };
    let through = end.z == workpiece.length() && end.radius == least;
    if through { (least.diameter() - UNDER_BORE).max(Micrometres::ZERO) } else { Micrometres::ZERO }
}

/// How far off the bar the blade comes and goes.
const CLEAR: Micrometres = Micrometres::from_mm(2);
