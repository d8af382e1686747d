//! Missing work of the operation, and toolpaths that would damage the part. Each is a finding of severity wrong: an
//! incomplete plan must not look complete.

use crate::note::{Figure, Finding, IntoFigure, Note, Severity};
use crate::turning::contour::{Contour, Side, Surface, SurfaceKind, SurfaceName};
use crate::turning::elements::Valley;
use crate::turning::jobs::Work as JobWork;
use crate::turning::length::Half;
use crate::turning::shaft::Holding;
use crate::turning::toolpath::Toolpath;
use crate::units::{Degrees, round_to};

use super::finishing::needs;
use super::work::ZoneWork;
use super::{Operation, SetUpWork, SideWork};

/// The surfaces that are not made, and the damage to the part.
pub(super) fn unfinished(operation: &Operation) -> Vec<Finding> {
    let mut findings = Vec::new();
    findings.extend(operation.set_ups.iter().flat_map(undone).map(|undone| undone.finding()));
    findings.extend(operation.set_ups.iter().flat_map(hollows_left));
    let between_centres = operation.workpiece.holding == Holding::Centres;
    let working = || operation.set_ups.iter().filter(|set_up| !set_up.jobs.is_empty());
    // Without jaws another finding says why nothing holds the part.
    let no_size = |set_up: &SetUpWork| !between_centres && set_up.jaws.is_some_and(|jaws| jaws.body.is_none());
    let no_jaws = |set_up: &SetUpWork| !between_centres && set_up.jaws.is_none();
    let no_centre = |set_up: &SetUpWork| set_up.set_up.centre && set_up.tailstock.is_none();
    let named = operation.workpiece.machine.is_some();
    let not_known = [
        (if named { "jaws-not-proven-of-lathe" } else { "jaws-not-proven" }, working().any(no_size)),
        ("jaws-not-proven-none", working().any(no_jaws)),
        ("centre-not-proven", working().any(no_centre)),
    ];
    let not_known = not_known.into_iter().filter(|(_, any)| *any);
    findings.extend(not_known.map(|(code, _)| Finding::of_part(Severity::Doubtful, Note::new(code))));
    let faced =
        |set_up: &SetUpWork, side: &SideWork, zone: &ZoneWork| set_up.set_up.centre && runs_into_centre(side, zone);
    for (set_up, _, zone) in operation.zones().filter(|(set_up, side, zone)| faced(set_up, side, zone)) {
        let number = format!("{}.{}", set_up.set_up.number, zone.zone.number);
        findings.push(Finding::of_part(Severity::Wrong, Note::new("faced-through-centre").with("zone", number)));
    }
    let rests = operation.set_ups.iter().filter_map(|set_up| Some((set_up.set_up.number, set_up.set_up.rest?)));
    findings.extend(rests.map(|(number, rest)| {
        let note = Note::new("rest-seat").with("number", number).with("z", Half::ZERO - rest.z_mm);
        Finding::of_part(Severity::Doubtful, note.with("diameter", rest.seat_mm).with("width", rest.width_mm))
    }));
    if between_centres {
        let length = operation.workpiece.length();
        findings.extend(operation.set_ups.iter().filter_map(|set_up| over_driver(set_up, length)));
    }
    findings
}

/// Between centres the part is driven at its far end. A tool that goes there leaves no room for a dog, and a face driver
/// must be smaller than the path.
fn over_driver(set_up: &SetUpWork, length: Half) -> Option<Finding> {
    let jobs = set_up.jobs.iter().filter(|job| job.side == Side::Outer);
    let there: Vec<_> = jobs.flat_map(|job| &job.path.moves).map(|one| one.to).filter(|to| to.z >= length).collect();
    let past = there.iter().map(|to| to.z).max()? - length;
    let within = there.iter().map(|to| to.radius).min()?;
    let note = Note::new("over-driver")
        .with("number", set_up.set_up.number)
        .with("past", past)
        .with("diameter", within.diameter());
    Some(Finding::of_part(Severity::Doubtful, note))
}

/// A surface that no job of a set-up finishes, or a thread or a groove that nothing cuts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Undone<'a> {
    /// Its name.
    pub name: &'a SurfaceName,
    /// The number of the set-up.
    set_up: u8,
    /// Z where it begins, seen from the free end of the set-up.
    begins: Half,
    code: &'static str,
}

impl Undone<'_> {
    /// It is wrong: the part is not made.
    pub fn finding(&self) -> Finding {
        let note = Note::new(self.code).with("number", self.set_up).with("surface", self.name);
        Finding::of_part(Severity::Wrong, note.with("z", Half::ZERO - self.begins))
    }
}

/// What a set-up leaves undone, outside, inside and on the axis.
pub(super) fn undone(set_up: &SetUpWork) -> Vec<Undone<'_>> {
    let of_sides = set_up.sides.iter().flat_map(|side| undone_on(set_up, side));
    of_sides.chain(undone_on_axis(set_up)).collect()
}

/// Why the hollows of a set-up stay that no zone was made of: nothing goes down into them from its free end.
fn hollows_left(set_up: &SetUpWork) -> Vec<Finding> {
    let undone = undone(set_up);
    let mut findings = Vec::new();
    for side in &set_up.sides {
        let Some(stretch) = set_up.set_up.side(side.side) else { continue };
        let tried = |valley: &&Valley| side.hollows.iter().any(|hollow| hollow.surfaces == valley.surfaces);
        for valley in stretch.main.valleys.iter().filter(|valley| !tried(valley)) {
            let surfaces = valley.surfaces.iter().filter_map(|index| stretch.profile.surfaces.get(*index));
            let main = surfaces.filter(|surface| !surface.kind.is_additional()).map(|surface| &surface.name);
            let left: Vec<_> = main.filter(|name| undone.iter().any(|one| one.name == *name)).collect();
            if left.is_empty() {
                continue;
            }
            let needs = needs(&Contour { side: side.side, pieces: valley.under.clone() });
            let angle = |degrees: Degrees| round_to(degrees.0, 1);
            let note = Note::new("hollow-left").with("number", set_up.set_up.number);
            let note = note.with("surfaces", Figure::list(left.into_iter().map(IntoFigure::into_figure)));
            let note = note.with("main", angle(needs.main)).with("secondary", angle(needs.secondary));
            findings.push(Finding::of_part(Severity::Wrong, note));
        }
    }
    findings
}

fn named<'a>(set_up: &'a SetUpWork, name: &'a SurfaceName, code: &'static str) -> Undone<'a> {
    let sides = [&set_up.set_up.outer, &set_up.set_up.inner].into_iter().flatten();
    let surface = sides.flat_map(|side| &side.profile.surfaces).find(|surface| surface.name == *name);
    let begins = surface.and_then(|surface| surface.pieces.first()).map(|piece| piece.from.z).unwrap_or_default();
    Undone { name, set_up: set_up.set_up.number, begins, code }
}

/// The surfaces of the hole on the axis that nothing makes.
fn undone_on_axis(set_up: &SetUpWork) -> impl Iterator<Item = Undone<'_>> {
    let made = |name: &SurfaceName| set_up.jobs.iter().any(|job| job.surfaces.contains(name));
    let all = set_up.axial.iter().flat_map(|axial| {
        let threads = axial.threads().map(|name| (name, "thread-not-cut"));
        threads.chain(axial.surfaces().map(|name| (name, "surface-not-finished")))
    });
    all.filter(move |(name, _)| !made(name)).map(|(name, code)| named(set_up, name, code))
}

fn undone_on<'a>(set_up: &'a SetUpWork, side: &'a SideWork) -> impl Iterator<Item = Undone<'a>> {
    let finished = |surface: &Surface| {
        set_up.jobs.iter().any(|job| job.work != JobWork::Rough && job.surfaces.contains(&surface.name))
    };
    let on_axis = |surface: &Surface| {
        let axial = set_up.axial.as_ref();
        axial.is_some_and(|axial| axial.surfaces().chain(axial.threads()).any(|name| *name == surface.name))
    };
    surfaces(set_up, side).filter_map(move |(surface, allowance)| {
        let code = match surface.kind {
            _ if finished(surface) || on_axis(surface) => return None,
            SurfaceKind::Thread => "thread-not-cut",
            kind if kind.is_additional() => "groove-not-cut",
            // Without an allowance the rough contour is that of the part.
            _ if allowance == Some(Half::ZERO) => return None,
            _ => "surface-not-finished",
        };
        Some(named(set_up, &surface.name, code))
    })
}

/// The surfaces of a side, each with its finishing allowance.
fn surfaces<'a>(set_up: &'a SetUpWork, side: &'a SideWork) -> impl Iterator<Item = (&'a Surface, Option<Half>)> {
    let known = set_up.set_up.side(side.side).into_iter().flat_map(|stretch| &stretch.profile.surfaces);
    let allowances = side.layers.allowances.iter().map(|one| one.allowance_mm).chain(std::iter::repeat(None));
    known.zip(allowances)
}

/// Whether the tool of a zone goes to the axis, where the tailstock centre is.
fn runs_into_centre(side: &SideWork, zone: &ZoneWork) -> bool {
    let paths = zone.works.iter().filter_map(|work| work.transition()).map(|transition| &transition.path);
    side.side == Side::Outer && paths.into_iter().any(reaches_axis)
}

/// Whether a path reaches the axis.
pub(super) fn reaches_axis(path: &Toolpath) -> bool {
    path.moves.iter().any(|one| one.to.radius <= Half::ZERO)
}
