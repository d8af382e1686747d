//! Which threads in the bore are tapped, by the rule `inner-thread`, and the bore as it is drilled for them: it is drawn between the
//! minor diameter and the drill, and made to the drill.

use std::collections::BTreeMap;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::knowledge::vocabulary::Operation;
use crate::note::{Because, Finding, Note, Severity};
use crate::tables::holes::{HoleConvention, HoleDefault};
use crate::tables::rules::ToolTablesFor;
use crate::tables::tools::CutterRow;
use crate::tables::turning::part::{InnerThreadFor, InnerThreadWay};
use crate::tapping::{minor_diameter, tap_hole};
use crate::turning::contour::{Curve, Piece, Profile, Surface, SurfaceKind, SurfaceName};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::tooling::{Hand, Place, ToolKind, TurningTool};
use crate::turning::workpiece::{Tapped, Thread, Workpiece};
use crate::units::Micrometres;

use super::Operation as Planned;

/// Threads that are cut another way than the rule takes first, by their surface.
type Other = BTreeMap<SurfaceName, InnerThreadWay>;

/// The workpiece with the way of each thread in its bore.
///
/// # Errors
/// The knowledge base lacks the rule, or a table.
fn decided(workpiece: &Workpiece, other: &Other, knowledge: &Knowledge) -> Result<Workpiece, KnowledgeError> {
    let mut part = workpiece.clone();
    let Some(mut inner) = part.inner.take() else { return Ok(part) };
    for thread in &mut part.threads {
        let Some((index, name)) = index_of(&inner, thread) else { continue };
        let ways = Ways::of(thread, knowledge)?;
        // A bore that is wider than the drill is bored, and its thread turned.
        let wide = bore_of(&inner, index).is_some_and(|bore| bore > ways.tapped.hole_mm) && ways.bar_enters();
        let other = other.get(&thread.surface).copied().or(wide.then_some(InnerThreadWay::Turned));
        let (way, because) = ways.choose(thread, &name, other, knowledge)?;
        thread.way = Some(because);
        if way == InnerThreadWay::Tapped {
            let radius = Half::radius_of(ways.tapped.hole_mm);
            let drilled = drilled(&inner, index, radius);
            let ends = |profile: &Profile| profile.contour().start().zip(profile.contour().end());
            if let (Some(wider), Some(before)) = (drilled, ends(&inner)) {
                if let Some(after) = ends(&wider) {
                    joined(&mut part.outer, before, after);
                }
                inner = wider;
            }
            thread.tapped = Some(ways.tapped);
        }
    }
    part.inner = Some(inner);
    Ok(part)
}

/// The plan with the threads in the bore tapped or turned as the rule says; what is not cut that way is tried the other way.
///
/// # Errors
/// The knowledge base lacks a table.
pub(super) fn planned(
    workpiece: &Workpiece,
    knowledge: &Knowledge,
    plan: impl Fn(&Workpiece) -> Result<Planned, KnowledgeError>,
) -> Result<Planned, KnowledgeError> {
    let planned = plan(&decided(workpiece, &Other::new(), knowledge)?)?;
    let others = others(&planned, knowledge)?;
    if others.is_empty() {
        return Ok(planned);
    }
    let again = plan(&decided(workpiece, &others, knowledge)?)?;
    Ok(if again.badness() < planned.badness() { again } else { planned })
}

/// The threads of a plan that nothing cuts, each with its other way, if it has one.
///
/// # Errors
/// The knowledge base lacks a table.
fn others(operation: &Planned, knowledge: &Knowledge) -> Result<Other, KnowledgeError> {
    let mut others = Other::new();
    let Some(inner) = &operation.workpiece.inner else { return Ok(others) };
    let cut = |thread: &Thread| {
        let mut surfaces = operation.set_ups.iter().flat_map(|one| &one.jobs).flat_map(|job| &job.surfaces);
        surfaces.any(|surface| *surface == thread.surface)
    };
    for thread in &operation.workpiece.threads {
        if index_of(inner, thread).is_none() || cut(thread) {
            continue;
        }
        let ways = Ways::of(thread, knowledge)?;
        match &thread.tapped {
            Some(_) if ways.bar_enters() => {
                others.insert(thread.surface.clone(), InnerThreadWay::Turned);
            }
            None if ways.has_tap => {
                others.insert(thread.surface.clone(), InnerThreadWay::Tapped);
            }
            _ => {}
        }
    }
    Ok(others)
}

/// The diameter of the bore under a thread.
fn bore_of(inner: &Profile, index: usize) -> Option<Micrometres> {
    Some(inner.surfaces.get(index)?.pieces.first()?.from.radius.diameter())
}

/// Threads turned in a bore that is drawn at the least minor diameter, so that a bore that comes out any narrower is scrap, or
/// wider than 6H allows, so that their crests are too low.
///
/// # Errors
/// The knowledge base lacks a table.
pub(super) fn bored_beside_limits(
    workpiece: &Workpiece,
    knowledge: &Knowledge,
) -> Result<Vec<Finding>, KnowledgeError> {
    let mut findings = Vec::new();
    let Some(inner) = &workpiece.inner else { return Ok(findings) };
    for thread in &workpiece.threads {
        let is_6h = thread.flanks.as_ref().is_some_and(|limits| limits.class == "6H");
        let Some((index, surface)) = index_of(inner, thread).filter(|_| is_6h && thread.tapped.is_none()) else {
            continue;
        };
        let Some(drawn) = bore_of(inner, index) else { continue };
        let (least, most) = minor_diameter(thread.size, thread.pitch, knowledge)?;
        let room = Micrometres::new((most - least).micrometres() / 10);
        if drawn < least + room {
            let middle = Micrometres::new((least.micrometres() + most.micrometres()) / 2);
            let note = Note::new("thread-bored-to-least").with("surface", &surface).with("drawn", drawn);
            let note = note.with("least", least).with("most", most).with("middle", middle);
            findings.push(Finding::of_part(Severity::Doubtful, note));
        } else if drawn > most {
            let share = (thread.size - drawn).to_mm() / (thread.size - least).to_mm();
            let note = Note::new("thread-bored-wide").with("surface", &surface).with("drawn", drawn).with("most", most);
            let note = note.with("share", crate::units::round_to(100.0 * share, 0));
            findings.push(Finding::of_part(Severity::Doubtful, note));
        }
    }
    Ok(findings)
}

/// The thread's surface in the bore.
fn index_of(inner: &Profile, thread: &Thread) -> Option<(usize, SurfaceName)> {
    let is_it = |surface: &Surface| surface.kind == SurfaceKind::Thread && surface.name == thread.surface;
    let (index, surface) = inner.surfaces.iter().enumerate().find(|(_, surface)| is_it(surface))?;
    Some((index, surface.name.clone()))
}

/// The ways of a thread in a bore.
struct Ways {
    tapped: Tapped,
    /// Whether the catalogs have its tap.
    has_tap: bool,
    /// The smallest bore that a bar with an insert of its pitch enters; none without such an insert.
    least_bore: Option<Micrometres>,
}

impl Ways {
    fn of(thread: &Thread, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let hole = tap_hole(thread.size, thread.pitch, knowledge)?;
        let (smallest_hole_mm, largest_hole_mm) = minor_diameter(thread.size, thread.pitch, knowledge)?;
        let run_out = HoleConvention::of(HoleDefault::ThreadRunoutPitches, knowledge)?.value;
        let run_out_mm = Micrometres::from_mm_rounded(run_out * thread.pitch.to_mm());
        let has_tap = !taps(&hole.id, thread.size, knowledge)?.is_empty();
        let mut bars = TurningTool::all(knowledge)?;
        bars.retain(|tool| (tool.kind, tool.works) == (ToolKind::Threading, Place::Inner) && tool.hand == Hand::R);
        bars.retain(|tool| tool.nose_radius.is_some());
        bars.retain(|tool| tool.pitch.is_some_and(|(least, most)| (least..=most).contains(&thread.pitch)));
        let least_bore = bars.iter().filter_map(|tool| tool.min_bore).min();
        let tapped = Tapped { id: hole.id, hole_mm: hole.drill, smallest_hole_mm, largest_hole_mm, run_out_mm };
        Ok(Self { tapped, has_tap, least_bore })
    }

    fn bar_enters(&self) -> bool {
        self.least_bore.is_some_and(|least| least <= self.tapped.hole_mm)
    }

    /// The way and why: by the rule, or the other one.
    fn choose(
        &self,
        thread: &Thread,
        surface: &SurfaceName,
        other: Option<InnerThreadWay>,
        knowledge: &Knowledge,
    ) -> Result<(InnerThreadWay, Because), KnowledgeError> {
        let bar = self.bar_enters();
        let asked = knowledge.ask(&InnerThreadFor { diameter: thread.size, tap: self.has_tap, bar })?;
        let way = other.unwrap_or(asked.need(&thread.written)?.cut);
        let code = match (way, other) {
            (InnerThreadWay::Tapped, Some(_)) => "thread-tapped-instead",
            (InnerThreadWay::Turned, Some(_)) => "thread-turned-instead",
            (InnerThreadWay::Tapped, None) if bar => "thread-tapped-sooner",
            (InnerThreadWay::Tapped, None) if self.least_bore.is_some() => "thread-tapped-no-bar",
            (InnerThreadWay::Tapped, None) => "thread-tapped-no-insert",
            (InnerThreadWay::Turned, None) if self.has_tap => "thread-turned-sooner",
            (InnerThreadWay::Turned, None) => "thread-turned-no-tap",
        };
        let mut note = Note::new(code).with("surface", surface).with("thread", &*thread.written);
        if code == "thread-tapped-no-bar" {
            note = note.with("least", self.least_bore.unwrap_or_default()).with("hole", self.tapped.hole_mm);
        }
        Ok((way, Because::answer(&asked.answer, note)))
    }
}

/// The taps of a thread, in the tables that the rule `tool-tables` names.
///
/// # Errors
/// A table is broken.
pub(crate) fn taps<'k>(
    id: &str,
    size: Micrometres,
    knowledge: &'k Knowledge,
) -> Result<Vec<CutterRow<'k>>, KnowledgeError> {
    let asked = knowledge.ask(&ToolTablesFor { operation: Operation::Tap, diameter: size })?;
    let named = asked.winner()?.map(|rule| rule.tables).unwrap_or_default();
    let mut rows = Vec::new();
    for table in named.into_iter().filter_map(|id| knowledge.tables().find(|table| table.id == *id)) {
        for row in table.rows::<CutterRow<'_>>() {
            let row = row?;
            if row.thread == Some(id) {
                rows.push(row);
            }
        }
    }
    Ok(rows)
}

/// The bore with the cylinders of a hole at another radius; what is beside them begins and ends there. None if that leaves nothing of
/// a neighbour.
fn drilled(inner: &Profile, index: usize, radius: Half) -> Option<Profile> {
    let mut surfaces = inner.surfaces.clone();
    let drawn = surfaces.get(index)?.cylinder()?.from.radius;
    let same = |surface: &Surface| surface.cylinder().is_some_and(|piece| piece.from.radius == drawn);
    let before = surfaces.get(..index)?.iter().rev().take_while(|surface| same(surface)).count();
    let after = surfaces.get(index..)?.iter().take_while(|surface| same(surface)).count();
    let (first, end) = (index - before, index + after);
    let meets = |piece: &Piece, at: Point| {
        let chord = piece.chord();
        let along = chord.z / chord.radius * (radius - at.radius).to_mm();
        match piece.curve {
            _ if piece.is_face() => Some(Point { radius, z: at.z }),
            Curve::Line => Some(Point { radius, z: at.z + Half::from(along) }),
            Curve::Arc { .. } => piece.at_radius(radius).first().copied(),
        }
    };
    let (mut from, mut to) = (None, None);
    if let Some(piece) = first.checked_sub(1).and_then(|index| surfaces.get_mut(index)?.pieces.last_mut()) {
        piece.to = meets(piece, piece.to)?;
        from = Some(piece.to.z).filter(|z| *z >= piece.from.z);
        from?;
    }
    if let Some(piece) = surfaces.get_mut(end).and_then(|surface| surface.pieces.first_mut()) {
        piece.from = meets(piece, piece.from)?;
        to = Some(piece.from.z).filter(|z| *z <= piece.to.z);
        to?;
    }
    let hole = surfaces.get_mut(first..end)?;
    for piece in hole.iter_mut().flat_map(|surface| &mut surface.pieces) {
        (piece.from.radius, piece.to.radius) = (radius, radius);
    }
    if let (Some(z), Some(piece)) = (from, hole.first_mut().and_then(|surface| surface.pieces.first_mut())) {
        piece.from.z = z;
    }
    if let (Some(z), Some(piece)) = (to, hole.last_mut().and_then(|surface| surface.pieces.last_mut())) {
        piece.to.z = z;
    }
    Some(Profile { side: inner.side, surfaces })
}

/// Faces of the outside that end at a bore end where it does now.
fn joined(outer: &mut Profile, before: (Point, Point), after: (Point, Point)) {
    let mut pieces = outer.surfaces.iter_mut().flat_map(|surface| &mut surface.pieces);
    if let Some(first) = pieces.next().filter(|first| first.is_face() && first.from == before.0) {
        first.from = after.0;
    }
    let last = outer.surfaces.last_mut().and_then(|surface| surface.pieces.last_mut());
    if let Some(last) = last.filter(|last| last.is_face() && last.to == before.1) {
        last.to = after.1;
    }
}
