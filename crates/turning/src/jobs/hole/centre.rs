//! Centre holes of ГОСТ 14034, and the spot for a drill.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::Knowledge;
use crate::knowledge::vocabulary::{Operation, ToolMaterial};
use crate::note::{Because, Note};
use crate::tables::turning::jobs::{CentreHole, JobLimit};
use crate::turning::length::Half;
use crate::turning::operation::tools::Bench;
use crate::turning::toolpath::Purpose;
use crate::units::Micrometres;
use technolog_cutting::Cut;

use super::super::limits::Limits;
use super::super::refused::NoJob;
use super::super::{Body, Job, JobTool, Work, site};
use super::{Stroke, cut, in_and_out, pace};

/// The form of a centre hole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CentreForm {
    /// Without a protecting cone: the hole is cut off or not used again.
    A,
    /// With a protecting cone of 120°: the hole stays on the part.
    B,
}

/// The centre hole for an end of a diameter (`centre-holes`); none if it is too thin for any.
///
/// # Errors
/// The knowledge base lacks the table.
pub fn centre_hole_for(end: Micrometres, knowledge: &Knowledge) -> Result<Option<CentreHole<'_>>, KnowledgeError> {
    let rows = knowledge.rows::<CentreHole<'_>>()?;
    Ok(rows.into_iter().filter(|row| row.part_diameter <= end).max_by_key(|row| row.pilot))
}

/// The job of a centre hole in a face of a diameter.
///
/// # Errors
/// The face is too small for any; or the knowledge base lacks a table.
pub fn centre_hole(form: CentreForm, end: Micrometres, face: Half, bench: &Bench<'_, '_>) -> Tried<Job, NoJob> {
    let Some(row) = centre_hole_for(end, bench.knowledge)? else {
        let rows = bench.knowledge.rows::<CentreHole<'_>>()?;
        let least = rows.iter().map(|row| row.part_diameter).min().unwrap_or_default();
        return Err(Refusal::Not(NoJob::NoCentreHole { diameter: end, least }));
    };
    centred(&row, form, face, Note::new("job-centre-hole").with("diameter", end), bench)
}

/// The job of a spot for a drill: the widest cone of a centre drill that stays within the share of its diameter.
///
/// # Errors
/// The drill is too small for any; or the knowledge base lacks a table.
pub fn spot(drill: Micrometres, face: Half, end: Half, bench: &Bench<'_, '_>) -> Tried<Job, NoJob> {
    let mut limits = Limits::of(bench.knowledge);
    let share = limits.ratio(JobLimit::SpotShare)?;
    let most = Micrometres::from_mm_rounded(drill.to_mm() * share);
    let mut rows = bench.knowledge.rows::<CentreHole<'_>>()?;
    rows.sort_by_key(|row| row.pilot);
    let least = rows.first().map(|row| row.pilot).unwrap_or_default();
    // It goes no deeper than the drill.
    let fits = |row: &&CentreHole<'_>| row.cone <= most && face + Half::of(row.cone_depth + row.pilot_length) < end;
    // Under the smallest drills the cone of the smallest goes in only so far.
    let goes_in =
        |row: &&CentreHole<'_>| row.pilot < most && row.cone > most && face + Half::of(row.pilot_length) < end;
    let smallest = || rows.first().filter(goes_in);
    let Some(row) = rows.iter().rfind(fits).or_else(smallest) else {
        let least = Micrometres::from_mm_rounded(least.to_mm() / share.max(0.01));
        return Err(Refusal::Not(NoJob::NoCentreHole { diameter: drill, least }));
    };
    let narrower = row.cone - most.min(row.cone);
    // A cone of 60°: less wide by twice the tangent of 30° times what it is less deep.
    let higher = Micrometres::from_mm_rounded(narrower.to_mm() / 2.0 / libm::tan(30_f64.to_radians()));
    let row = CentreHole { cone: row.cone - narrower, cone_depth: row.cone_depth - higher, ..row.clone() };
    let mut job = centred(&row, CentreForm::A, face, Note::new("job-spot").with("drill", drill), bench)?;
    job.because.extend(limits.because);
    Ok(job)
}

fn centred(row: &CentreHole<'_>, form: CentreForm, face: Half, note: Note, bench: &Bench<'_, '_>) -> Tried<Job, NoJob> {
    let lathe = site::lathe(bench)?;
    let (mouth, cone, body, designation) = match form {
        CentreForm::A => (row.cone, row.cone_depth, row.body, row.drill),
        CentreForm::B => (row.protected, row.protected_depth, row.protected_body, row.protecting_drill),
    };
    let depth = cone + row.pilot_length;
    let cut = Cut {
        // Its thin pilot permits less feed than its body.
        feed_diameter: Some(row.pilot),
        tool_diameter: Some(row.pilot),
        flutes: None,
        ..cut(Operation::CentreDrill, mouth, Micrometres::ZERO, depth, ToolMaterial::HighSpeedSteel)
    };
    let conditions = pace::pace(&cut, lathe, bench)?;
    let path = in_and_out(face, face + Half::of(depth), Purpose::Rapid, bench)?;
    let note = note.with("tool", designation).with("mouth", mouth).with("depth", depth);
    let body = Body::CentreDrill { pilot_mm: row.pilot, pilot_length_mm: row.pilot_length, body_mm: body };
    let tool = JobTool { designation: designation.to_owned(), body };
    let (row, notes) = (Because::row(row.row, note.clone()), vec![note]);
    let stroke = Stroke { work: Work::Centre, tool, surfaces: Vec::new(), path, notes, row, because: Vec::new() };
    Ok(stroke.job(conditions, lathe, bench))
}
