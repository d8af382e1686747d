//! Threads on the axis that a tap cuts.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::vocabulary::{Operation, ToolMaterial};
use crate::note::{Because, Note};
use crate::tables::holes::{HoleConvention, HoleDefault};
use crate::tables::tools::CutterRow;
use crate::tables::turning::jobs::JobLimit;
use crate::turning::contour::{Piece, Surface, SurfaceKind, SurfaceName};
use crate::turning::length::Half;
use crate::turning::operation::tapped::taps;
use crate::turning::operation::tools::Bench;
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::turning::workpiece::{Tapped, Thread};
use crate::units::{Micrometres, RevsPerMinute};
use technolog_cutting::Cut;

use super::super::limits::Limits;
use super::super::refused::NoJob;
use super::super::{Body, Job, JobTool, Work, site};
use super::{Stroke, before, cut, on_axis, pace};

/// The job of a tap; `index` is the thread's surface among those of the bore of the set-up, `face` Z of the rough face.
///
/// # Errors
/// The hole goes on before the thread with the same diameter, or has no room behind it; no tap reaches; the tables have no figures; the
/// knowledge base lacks a table.
pub fn tap(
    surfaces: &[Surface],
    index: usize,
    thread: &Thread,
    tapped: &Tapped,
    face: Half,
    bench: &Bench<'_, '_>,
) -> Tried<Job, NoJob> {
    let lathe = site::lathe(bench)?;
    let found = surfaces.get(index).and_then(|surface| Some((surface, surface.pieces.first()?)));
    let Some((surface, piece)) = found else {
        return Err(Refusal::Not(NoJob::ThreadOnNoCylinder { surface: thread.surface.clone() }));
    };
    let name = || surface.name.clone();
    if let Some(plain) = plain_before(surfaces, index) {
        return Err(Refusal::Not(NoJob::PlainBeforeTap { surface: name(), plain }));
    }
    let mut limits = Limits::of(bench.knowledge);
    let (lead, of_lead) = pitches(HoleDefault::TapLeadPitches, thread.pitch, bench)?;
    let stop = Half::from(limits.ratio(JobLimit::TapStopTurns)? * thread.pitch.to_mm());
    let entry = Half::from(limits.ratio(JobLimit::TapEntry)? * thread.pitch.to_mm());
    let full = piece.to.z;
    let bottom = bottom(surfaces, index);
    let tip = match bottom {
        None if plain_behind(surfaces, index) >= lead => full + lead,
        Some(bottom) if bottom < full + lead + stop => {
            let (needs, room) = (lead + stop, bottom - full);
            return Err(Refusal::Not(NoJob::NoTapRunOut {
                surface: name(),
                needs,
                room,
                thread: thread.written.clone(),
            }));
        }
        Some(_) => full + lead,
        None => full + lead + stop,
    };
    let pieces: Vec<&Piece> = surfaces.iter().take(index + 1).flat_map(|surface| &surface.pieces).collect();
    // How far something of a radius enters.
    let enters = |radius: Half| {
        let wider = pieces.iter().take_while(|piece| piece.radii().0 > radius);
        wider.last().map_or(face, |last| last.to.z)
    };
    let chosen = Tap::choose(thread, tapped, tip, &enters, lead, bench)?;
    let depth = (tip - face).rounded_up();
    let cut = Cut {
        blind: bottom.is_some(),
        pitch: Some(thread.pitch),
        ..cut(Operation::Tap, thread.size, tapped.hole_mm, depth, ToolMaterial::HighSpeedSteel)
    };
    let most = RevsPerMinute(limits.ratio(JobLimit::TapSpindle)?);
    let conditions = pace::tap_pace(&cut, most, lathe, bench)?;
    let from = before(face, bench)?;
    let in_step = enters(Half::radius_of(thread.size)) - entry;
    let from = from.min(in_step);
    let mut path = Toolpath::at(on_axis(from));
    path.go(on_axis(in_step), Purpose::Rapid);
    path.go(on_axis(tip), Purpose::Thread);
    path.go(on_axis(in_step), Purpose::Thread);
    path.go(on_axis(from), Purpose::Rapid);
    let mut notes: Vec<Note> = thread.way.iter().map(|way| way.note.clone()).collect();
    let note = Note::new("job-tapped")
        .with("surface", &surface.name)
        .with("thread", thread.written.as_str())
        .with("hole", piece.from.radius.diameter())
        .with("least", tapped.smallest_hole_mm)
        .with("most", tapped.largest_hole_mm)
        .with("full", full)
        .with("tip", tip);
    notes.push(note);
    let end = match bottom {
        Some(_) => Some("job-tap-blind"),
        None if tip > full + lead => Some("job-tap-through"),
        None => None,
    };
    notes.extend(end.map(|code| Note::new(code).with("surface", &surface.name).with("stop", stop)));
    let mut because: Vec<Because> = thread.way.iter().cloned().chain([of_lead]).collect();
    because.extend(limits.because);
    let stroke = Stroke {
        work: Work::Tap,
        tool: chosen.tool,
        surfaces: vec![surface.name.clone()],
        path,
        notes,
        row: chosen.row,
        because,
    };
    Ok(stroke.job(conditions, lathe, bench))
}

/// How far behind the end of a thread that goes through its hole is drilled, so that its tap finds it.
///
/// # Errors
/// The knowledge base lacks a convention.
pub fn drilled_behind(thread: &Thread, bench: &Bench<'_, '_>) -> Result<Half, KnowledgeError> {
    let (lead, _) = pitches(HoleDefault::TapLeadPitches, thread.pitch, bench)?;
    let stop = Limits::of(bench.knowledge).ratio(JobLimit::TapStopTurns)?;
    Ok(lead + Half::from((stop + 1.0) * thread.pitch.to_mm()))
}

/// A length in pitches, by the conventions for holes in plates.
fn pitches(name: HoleDefault, pitch: Micrometres, bench: &Bench<'_, '_>) -> Result<(Half, Because), KnowledgeError> {
    let row = HoleConvention::of(name, bench.knowledge)?;
    let length = Half::from(row.value * pitch.to_mm());
    Ok((length, Because::row(row.row, Note::new("tap-lead").with("lead", length))))
}

/// A plain cylinder of the same diameter before the thread, which a tap would cut as well.
pub fn plain_before(surfaces: &[Surface], index: usize) -> Option<SurfaceName> {
    let radius = surfaces.get(index)?.pieces.first()?.from.radius;
    let same =
        |surface: &&Surface| surface.pieces.iter().all(|piece| piece.is_cylinder() && piece.from.radius == radius);
    let before = surfaces.get(..index)?.iter().rev().take_while(same);
    before.filter(|one| one.kind != SurfaceKind::Thread).map(|one| one.name.clone()).next()
}

/// The length of the plain hole of the same diameter behind the thread.
fn plain_behind(surfaces: &[Surface], index: usize) -> Half {
    let same = |piece: &&Piece, radius: Half| piece.is_cylinder() && piece.from.radius == radius;
    let Some(thread) = surfaces.get(index).and_then(|one| one.pieces.first()) else { return Half::ZERO };
    let behind = surfaces.get(index + 1..).unwrap_or_default().iter().flat_map(|surface| &surface.pieces);
    behind.take_while(|piece| same(piece, thread.from.radius)).map(|piece| piece.to.z - piece.from.z).sum()
}

/// Z where the hole of a thread narrows behind it; none if it goes through.
fn bottom(surfaces: &[Surface], index: usize) -> Option<Half> {
    let radius = surfaces.get(index)?.pieces.first()?.from.radius;
    let behind = surfaces.get(index + 1..)?.iter().flat_map(|surface| &surface.pieces);
    behind.into_iter().find(|piece| piece.radii().0 < radius).map(|piece| piece.from.z)
}

/// A tap of the catalogs.
struct Tap {
    tool: JobTool,
    row: Because,
}

impl Tap {
    /// The first tap that reaches.
    fn choose(
        thread: &Thread,
        tapped: &Tapped,
        tip: Half,
        enters: &dyn Fn(Half) -> Half,
        lead: Half,
        bench: &Bench<'_, '_>,
    ) -> Tried<Self, NoJob> {
        let clamped = HoleConvention::of(HoleDefault::TapClampDiameters, bench.knowledge)?.value;
        let mut longest = Half::ZERO;
        for row in taps(&tapped.id, thread.size, bench.knowledge)? {
            let Some((designation, body)) = body(&row, thread, tapped, lead, clamped) else { continue };
            let Body::Tap { neck_mm, shank_mm, free_mm, .. } = body else { continue };
            // Its shank and its chuck, which is about twice as thick, enter only what is wider.
            let shank = enters(Half::radius_of(shank_mm)) + Half::of(neck_mm);
            let chuck = enters(Half::of(shank_mm)) + Half::of(free_mm);
            let reach = shank.min(chuck);
            if tip <= reach {
                let tool = JobTool { designation: designation.to_owned(), body };
                return Ok(Self {
                    tool,
                    row: Because::row(row.row, Note::new("job-tool-taken").with("tool", designation)),
                });
            }
            longest = longest.max(reach);
        }
        let thread = thread.written.clone();
        Err(Refusal::Not(match longest {
            Half::ZERO => NoJob::NoTap { thread },
            reach => NoJob::TapTooShort { thread, depth: tip, reach },
        }))
    }
}

/// The designation and the shape of a tap.
fn body<'k>(
    row: &CutterRow<'k>,
    thread: &Thread,
    tapped: &Tapped,
    lead: Half,
    clamped: f64,
) -> Option<(&'k str, Body)> {
    let (length, shank, flute) = (row.length?, row.shank_diameter?, row.flute_length?);
    let body = Body::Tap {
        diameter_mm: thread.size,
        pitch_mm: thread.pitch,
        core_mm: tapped.smallest_hole_mm,
        lead_mm: lead.rounded_up(),
        thread_mm: flute,
        neck_mm: row.reach.unwrap_or(flute),
        shank_mm: shank,
        free_mm: length - Micrometres::from_mm_rounded(shank.to_mm() * clamped),
    };
    Some((row.designation?, body))
}
