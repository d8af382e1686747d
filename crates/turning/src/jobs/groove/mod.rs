//! Grooves and reliefs: outside, in a bore and in a face, by grooving tools; narrow reliefs by a turning tool whose
//! edges reach the floor.
//!
//! - `valley` is the shape of a groove, seen from its mouth;
//! - `ways` is the toolpath of an edge through it;
//! - `blades` finds the tool, the widest suitable blade first;
//! - [`groove`] makes the job.
//!
//! The finished profile is never cut below: corners tighter than those of the blade keep the radius of the blade.

mod blades;
mod valley;
mod ways;

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests look at what notes are told")]
mod tests;

use std::collections::BTreeSet;

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::Knowledge;
use crate::note::{Because, Figure, IntoFigure, Note};
use crate::tables::turning::jobs::JobLimit;
use crate::turning::contour::Surface;
use crate::turning::length::Half;
use crate::turning::operation::tools::Bench;
use crate::turning::point::Point;
use crate::turning::schemes::rates;
use crate::turning::tooling::TurningTool;
use crate::turning::toolpath::{Move, Purpose, Toolpath};
use crate::units::round_to;

use super::limits::Limits;
use super::refused::NoJob;
use super::site::{self, Site};
use super::{Job, JobTool, Pace, Work};
use blades::Chosen;
pub(super) use blades::blade_pace;
use valley::{Lie, Valley};
use ways::{Division, Ways};

/// The job of a groove or a relief.
///
/// # Errors
/// No tool makes it, with the inequality that fails; or the knowledge base lacks a table.
pub fn groove(site: Site<'_>, surface: &Surface, bench: &Bench<'_, '_>) -> Tried<Job, NoJob> {
    groove_by(site, surface, None, bench)
}

/// The jobs of several grooves with as few blades as there is little time in it (`blade-saved`): a blade that is there for one
/// of them also cuts another that would have a wider one. Blades made for the width of their groove stay.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn with_fewer_blades(
    site: Site<'_>,
    mut grooves: Vec<(&Surface, Job)>,
    bench: &Bench<'_, '_>,
) -> Result<Vec<Job>, KnowledgeError> {
    let saved = Limits::of(bench.knowledge).ratio(JobLimit::BladeSaved)?;
    let own: Vec<&str> =
        TurningTool::all(bench.knowledge)?.iter().filter(|tool| tool.own_width).map(|tool| tool.designation).collect();
    let names: BTreeSet<String> = grooves.iter().map(|(_, job)| job.tool.designation.clone()).collect();
    let shared = names.iter().filter(|name| !own.contains(&name.as_str()));
    for (one, other) in shared.clone().flat_map(|one| shared.clone().map(move |other| (one, other))) {
        let both = [one, other].map(|name| grooves.iter().any(|(_, job)| job.tool.designation == *name));
        if one == other || both != [true, true] {
            continue;
        }
        let (mut made, mut more) = (Vec::new(), 0.0);
        for (index, (surface, job)) in grooves.iter().enumerate().filter(|(_, (_, job))| job.tool.designation == *other)
        {
            // Both walls of a groove with a tolerance are turned by a blade chosen for it.
            let tried = Some(surface).filter(|surface| surface.grade.is_none());
            let Some(Ok(again)) =
                tried.map(|surface| Refusal::split(groove_by(site, surface, Some(one), bench))).transpose()?
            else {
                more = f64::INFINITY;
                break;
            };
            more += again.time_min.0 - job.time_min.0;
            made.push((index, again));
        }
        if more <= saved {
            for (index, again) in made {
                if let Some((_, job)) = grooves.get_mut(index) {
                    *job = again;
                }
            }
        }
    }
    Ok(grooves.into_iter().map(|(_, job)| job).collect())
}

/// The job of a groove, by that blade if one is named.
fn groove_by(site: Site<'_>, surface: &Surface, only: Option<&str>, bench: &Bench<'_, '_>) -> Tried<Job, NoJob> {
    let lathe = site::lathe(bench)?;
    let valley = Valley::of(surface, site.side())?.between_shoulders(site.profile);
    let mut limits = Limits::of(bench.knowledge);
    let Chosen { tool, ways, speed, feeds, mut because, by_nose, blade } =
        blades::choose(site, surface, &valley, only, &mut limits, bench)?;
    let (rates, _) = rates::of_table(bench.knowledge)?;
    let rapid = bench.workpiece.rates.map_or(lathe.rapid_z, |given| given.main.rapid);
    let clear = match valley.lie {
        Lie::Outside | Lie::Face => site.clear,
        Lie::Inside => {
            let (at, by) = (site.clear_before(valley.end()), blades::play(site, &valley, &tool));
            let nearest = Half::radius_of(site.narrowest(valley.end())) - by;
            Point { radius: at.radius.max(nearest), z: at.z }
        }
    };
    let path = in_set_up(&ways.path, &valley, clear, Half::of(rates.approach));
    because.extend(limits.because);
    let corner = Half::of(tool.nose_radius.unwrap_or_default());
    let name = &surface.name;
    let mut notes =
        vec![division_note(&ways, valley.lie, by_nose).with("surface", name).with("tool", tool.designation)];
    if ways.layers > 0 {
        notes.push(Note::new("groove-layers").with("surface", name).with("layers", ways.layers));
    }
    if ways.steps > 1 {
        notes.push(Note::new("groove-pecked").with("surface", name).with("steps", ways.steps));
    }
    if valley.corner() < corner {
        let note = Note::new("groove-corner-kept").with("surface", name);
        notes.push(note.with("wanted", valley.corner()).with("radius", corner));
    }
    if surface.grade.is_some() && ways.at_once {
        notes.push(Note::new("groove-width-of-blade").with("surface", name));
    }
    let (surfaces, tool, pace) = (vec![name.clone()], JobTool::of(&tool), Pace::PerRev { speed, feeds });
    Ok(Job { surfaces, blade, notes, because, ..Job::of(Work::Groove, site.side(), tool, path, pace, rapid) })
}

/// The note about the cutting of the groove. Plunges stand where the operator sees them: along Z, or at a diameter of a face.
fn division_note(ways: &Ways, lie: Lie, by_nose: bool) -> Note {
    if by_nose {
        return Note::new("groove-by-nose");
    }
    if ways.at_once {
        return Note::new("groove-one-plunge");
    }
    let shown = |place: &Half| match lie {
        Lie::Outside | Lie::Inside => -place.to_mm(),
        Lie::Face => -2.0 * place.to_mm(),
    };
    let places = ways.plunges.iter().map(|place| round_to(shown(place), 2).into_figure());
    let code = if lie == Lie::Face { "groove-plunges-face" } else { "groove-plunges" };
    Note::new(code).with("count", ways.plunges.len()).with("places", Figure::list(places))
}

/// The constants of the tables for a division; `corner` is that of the blade.
fn division(corner: Half, limits: &mut Limits<'_>, knowledge: &Knowledge) -> Tried<Division, NoJob> {
    let (rates, _) = rates::of_table(knowledge)?;
    let allowance = limits.ratio(JobLimit::GrooveAllowance)? * corner.to_mm();
    Ok(Division {
        step: limits.ratio(JobLimit::PlungeStep)?,
        allowance,
        finish: limits.length(JobLimit::GrooveFinishDepth)?.to_mm(),
        peck: (
            limits.ratio(JobLimit::PeckFrom)?,
            limits.ratio(JobLimit::PeckStep)?,
            limits.length(JobLimit::PeckRetract)?.to_mm(),
        ),
        approach: Half::of(rates.approach),
        layer: None,
    })
}

/// A toolpath seen from the mouth, converted to the set-up: from a clear position and back.
fn in_set_up(ways: &Toolpath, valley: &Valley, clear: Point, approach: Half) -> Toolpath {
    let lie = valley.lie;
    let (from, to) = (lie.seen(ways.from), lie.seen(ways.end()));
    let over = |at: Point| match lie {
        Lie::Outside | Lie::Inside => Point { radius: clear.radius, z: at.z },
        Lie::Face => Point { radius: at.radius, z: clear.z.min(Half::ZERO - valley.mouth - approach) },
    };
    let mut path = Toolpath::at(match lie {
        Lie::Outside | Lie::Face => over(from),
        Lie::Inside => clear,
    });
    path.go(over(from), Purpose::Rapid);
    path.go(from, Purpose::Rapid);
    for (piece, purpose) in ways.pieces() {
        let piece = lie.piece(piece);
        path.moves.push(Move::along(piece, purpose));
    }
    path.go(over(to), Purpose::Rapid);
    path.go(path.from, Purpose::Rapid);
    path
}

/// A tool that cannot cut it.
fn not<T>(why: NoJob) -> Tried<T, NoJob> {
    Err(Refusal::Not(why))
}

/// The rows behind a choice.
fn taken(tool: &crate::turning::tooling::TurningTool<'_>) -> Because {
    Because::row(tool.row, Note::new("job-tool-taken").with("tool", tool.designation))
}
