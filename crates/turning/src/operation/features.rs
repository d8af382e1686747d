//! The jobs that cut into the finished contour: grooves, reliefs, threads.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::note::{Finding, Severity};
use crate::turning::contour::{Contour, Piece, Profile, Side, Surface, SurfaceKind};
use crate::turning::jobs::groove::{groove, with_fewer_blades};
use crate::turning::jobs::hole;
use crate::turning::jobs::thread::{Passes, thread};
use crate::turning::jobs::{Job, NoJob, Site};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::zones::{SetUp, TurnedSide};

use super::SideWork;
use super::tools::Bench;
use super::work::Hollow;

/// The jobs of the grooves and threads of a side. One that cannot be cut is a finding with the failed inequality.
///
/// # Errors
/// The knowledge base lacks a table.
pub(super) fn features(
    set_up: &SetUp,
    side: &SideWork,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Vec<Job>, KnowledgeError> {
    let (mut jobs, mut grooves) = (Vec::new(), Vec::new());
    let Some(stretch) = set_up.side(side.side) else { return Ok(jobs) };
    let site = site(stretch, side, bench)?;
    let with_made = with_made_before(set_up, &stretch.profile, bench);
    let sized = bench.sizes.profile(&stretch.profile, set_up.turned_over);
    let of_grooves = Site { profile: &sized, ..site };
    let of_threads = Site { profile: &with_made, ..site };
    let face = side.layers.rough.start().map_or(Half::ZERO, |start| start.z);
    let surfaces = stretch.profile.surfaces.iter().enumerate();
    for (index, surface) in surfaces.filter(|(_, surface)| !bench.leaves(&surface.name)) {
        if surface.kind == SurfaceKind::Thread {
            jobs.extend(thread_job(of_threads, index, face, bench, findings)?);
        } else if surface.kind.is_additional() {
            let Some(surface) = sized.surfaces.get(index) else { continue };
            grooves.extend(made(groove(of_grooves, surface, bench), findings)?.map(|job| (surface, job)));
        }
    }
    jobs.extend(with_fewer_blades(of_grooves, grooves, bench)?);
    Ok(jobs)
}

/// The surfaces of a set-up, and behind them those that the first set-up has made: a thread may end over them.
pub(super) fn with_made_before(set_up: &SetUp, profile: &Profile, bench: &Bench<'_, '_>) -> Profile {
    let part = bench.workpiece.profile(profile.side);
    let mut all = profile.clone();
    if let (Some(part), Some(end), true) = (part, profile.contour().end(), set_up.turned_over) {
        let behind = |surface: &Surface| surface.pieces.first().is_some_and(|first| first.from.z >= end.z);
        all.surfaces.extend(part.turned_over(bench.workpiece.length()).surfaces.into_iter().filter(behind));
    }
    all
}

/// The job of a thread, the surface of that index: tapped, or turned pass by pass.
///
/// # Errors
/// The knowledge base lacks a table.
pub(super) fn thread_job(
    site: Site<'_>,
    index: usize,
    face: Half,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Option<Job>, KnowledgeError> {
    let surfaces = &site.profile.surfaces;
    let Some(surface) = surfaces.get(index) else { return Ok(None) };
    let Some(cut) = bench.workpiece.thread_on(&surface.name) else { return Ok(None) };
    if let Some(tapped) = &cut.tapped {
        return made(hole::tap(surfaces, index, cut, tapped, face, bench), findings);
    }
    let mut job = made(thread(site, surface, cut, Passes::Makers, bench), findings)?;
    match (&mut job, &cut.way) {
        (Some(job), Some(way)) => {
            job.notes.insert(0, way.note.clone());
            job.because.push(way.clone());
        }
        // Why it is not tapped either.
        (None, Some(way)) => findings.push(Finding::of_part(Severity::Wrong, way.note.clone())),
        _ => {}
    }
    Ok(job)
}

/// The job of a hollow that no turning tool reaches into: a blade cuts it like a groove. Where none does, the findings are those of
/// the turning tools.
///
/// # Errors
/// The knowledge base lacks a table.
pub(super) fn hollow(
    set_up: &SetUp,
    side: &SideWork,
    hollow: &Hollow,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Option<Job>, KnowledgeError> {
    let Some(stretch) = set_up.side(side.side) else { return Ok(None) };
    let surfaces: Vec<_> = hollow.surfaces.iter().filter_map(|index| stretch.profile.surfaces.get(*index)).collect();
    if surfaces.iter().any(|surface| bench.leaves(&surface.name)) {
        return Ok(None);
    }
    let Some(floor) = surfaces.iter().find(|surface| surface.pieces.iter().any(|piece| piece.is_cylinder())) else {
        findings.extend(hollow.lacking.clone());
        return Ok(None);
    };
    let under = Contour { side: side.side, pieces: hollow.under.clone() };
    let pieces = with_allowances(bench.sizes.contour(under, set_up), &surfaces, bench).pieces;
    let whole = Surface { kind: SurfaceKind::RectangularGroove, pieces, ..(*floor).clone() };
    let mut why = Vec::new();
    let job = made(groove(site(stretch, side, bench)?, &whole, bench), &mut why)?;
    if job.is_none() {
        findings.extend(hollow.lacking.iter().cloned().chain(why));
    }
    let surfaces = surfaces.into_iter().map(|surface| surface.name.clone()).collect();
    Ok(job.map(|job| Job { surfaces, ..job }))
}

/// A hollow with what another machine takes off its cylinders: a blade must leave it, too.
fn with_allowances(mut under: Contour, surfaces: &[&Surface], bench: &Bench<'_, '_>) -> Contour {
    let side = under.side;
    for surface in surfaces {
        let later = bench.later(&surface.name);
        let (Some(later), Some(own)) = (later, surface.pieces.iter().find(|piece| piece.is_cylinder())) else {
            continue;
        };
        let raise = |radius: Half| radius.off(later, side);
        for at in 0..under.pieces.len() {
            let lies_on = |piece: &Piece| piece.is_cylinder() && piece.from.z < own.to.z && own.from.z < piece.to.z;
            let Some(piece) = under.pieces.get_mut(at).filter(|piece| lies_on(piece)) else { continue };
            piece.from.radius = raise(piece.from.radius);
            piece.to.radius = raise(piece.to.radius);
            let (from, to) = (piece.from, piece.to);
            if let Some(before) = at.checked_sub(1).and_then(|before| under.pieces.get_mut(before)) {
                before.to = from;
            }
            if let Some(behind) = under.pieces.get_mut(at + 1) {
                behind.from = to;
            }
        }
    }
    under
}

/// Where the tools of a side come from.
fn site<'a>(stretch: &'a TurnedSide, side: &SideWork, bench: &Bench<'_, '_>) -> Result<Site<'a>, KnowledgeError> {
    let [approach, retract] = bench.approach_and_retract()?;
    let start = side.layers.rough.start().map_or(Half::ZERO, |start| start.z);
    let radius = match side.side {
        Side::Outer => side.layers.blank.radii().map_or(Half::ZERO, |(_, most)| most) + approach,
        Side::Inner => stretch.profile.contour().narrowest().unwrap_or_default() - retract,
    };
    Ok(Site { profile: &stretch.profile, clear: Point { radius, z: start - approach }, off: retract })
}

/// A job, or the finding why there is none.
///
/// # Errors
/// The knowledge base lacks a table.
pub(super) fn made<T>(tried: Tried<T, NoJob>, findings: &mut Vec<Finding>) -> Result<Option<T>, KnowledgeError> {
    match Refusal::split(tried)? {
        Ok(job) => Ok(Some(job)),
        Err(why) => {
            findings.push(Finding::of_part(Severity::Wrong, why.note()));
            Ok(None)
        }
    }
}
