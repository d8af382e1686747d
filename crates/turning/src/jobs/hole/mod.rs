//! Holes on the axis: the spot for a drill, the centre holes of ГОСТ 14034, and drilling. Feed, speed, torque and
//! thrust follow the same tables and formulas as for holes in plates, within the limits of the lathe.

mod pace;
mod widen;

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests look at what notes are told")]
mod tests;

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::Knowledge;
use crate::knowledge::table::ToolHead;
use crate::knowledge::vocabulary::{Operation, Surface, ToolMaterial};
use crate::note::{Because, Note};
use crate::tables::holes::FirstDrill;
use crate::tables::rules::{HoleCycle, MachiningCycleFor, ToolTablesFor, TwoPassDrillingFor};
use crate::tables::tools::CutterRow;
use crate::tables::turning::jobs::{CentreHole, JobLimit};
use crate::turning::contour::{Side, SurfaceName};
use crate::turning::length::Half;
use crate::turning::operation::tools::Bench;
use crate::turning::point::Point;
use crate::turning::schemes::rates;
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::units::{Degrees, Micrometres};
use technolog_cutting::Cut;

use super::clock::time;
use super::limits::Limits;
use super::refused::NoJob;
use super::site;
use super::{Body, Job, JobTool, Work};
use pace::AxialConditions;
pub use widen::{Mouth, Widening, countersink, widen};

/// The end of a drilled hole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HoleEnd {
    /// At a Z where the metal ends: the full diameter comes out.
    Through(Half),
    /// The point of the drill goes to this Z and no further, so that the bottom with its allowance is not cut.
    Blind(Half),
}

/// A hole to drill.
#[derive(Clone, Debug)]
pub struct Hole {
    /// Its largest diameter.
    pub diameter: Micrometres,
    /// The diameter of the existing hole; zero in solid metal.
    pub from: Micrometres,
    /// Z of the face where it begins.
    pub face: Half,
    /// Its end.
    pub end: HoleEnd,
    /// The surfaces that it prepares, or makes to size.
    pub surfaces: Vec<SurfaceName>,
    /// Whether only a drill of its very diameter will do.
    pub exact: bool,
    /// Whether the drill is reground flat, and takes away the cone that the point of the drill before it has left.
    pub flat: bool,
}

/// The form of a centre hole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CentreForm {
    /// Without a protecting cone: the hole is cut off or not used again.
    A,
    /// With a protecting cone of 120°: the hole stays on the part.
    B,
}

/// A drill of the catalogs.
struct Drill<'k> {
    row: CutterRow<'k>,
    designation: &'k str,
    diameter: Micrometres,
    material: ToolMaterial,
    point_angle: Degrees,
    flute: Micrometres,
}

impl Drill<'_> {
    /// The length of the point: d/2 divided by the tangent of half its angle.
    fn point(&self) -> Half {
        Half::from(self.diameter.to_mm() / 2.0 / libm::tan(self.point_angle.0.to_radians() / 2.0))
    }
}

/// The jobs of a hole: one drill, or by the rule `two-pass-drilling` a narrower one before it.
///
/// # Errors
/// As for [`drill`].
pub fn drilling(hole: &Hole, bench: &Bench<'_, '_>) -> Tried<Vec<Job>, NoJob> {
    let question = TwoPassDrillingFor { diameter: hole.diameter, first_drill_in_magazine: false };
    let asked = bench.knowledge.ask(&question)?;
    let passes = asked.need(&hole.diameter.to_string())?.passes;
    if passes < 2 || hole.from > Micrometres::ZERO {
        return Ok(vec![drill(hole, bench)?]);
    }
    let share = bench.knowledge.need("two-pass drilling", |_: &FirstDrill<'_>| true)?;
    let most = Micrometres::from_mm_rounded(hole.diameter.to_mm() * share.share_max);
    let mut first = drill(&Hole { diameter: most, ..hole.clone() }, bench)?;
    let note = Note::new("job-first-drill").with("diameter", hole.diameter).with("most", most);
    first.because.extend([Because::answer(&asked.answer, note.clone()), Because::row(share.row, note)]);
    let from = match first.tool.body {
        Body::Drill { diameter_mm, .. } => diameter_mm,
        _ => Micrometres::ZERO,
    };
    let second = drill(&Hole { from, ..hole.clone() }, bench)?;
    Ok(vec![first, second])
}

/// The job of drilling, with the widest drill that is not wider than the hole and reaches its end.
///
/// # Errors
/// No drill is small enough or long enough; it exceeds the limits of the lathe; the knowledge base lacks a
/// table.
pub fn drill(hole: &Hole, bench: &Bench<'_, '_>) -> Tried<Job, NoJob> {
    let lathe = site::lathe(bench)?;
    let mut limits = Limits::of(bench.knowledge);
    let beyond = Half::of(limits.length(JobLimit::DrillBreakthrough)?);
    let tip_of = |drill: &Drill<'_>| match hole.end {
        HoleEnd::Through(end) => end + drill.point() + beyond,
        HoleEnd::Blind(end) => end,
    };
    let mut all = drills(hole.diameter, bench)?;
    if hole.flat {
        all.iter_mut().for_each(|drill| drill.point_angle = FLAT);
    }
    let reaches = |drill: &&Drill<'_>| Half::of(drill.flute) >= tip_of(drill) - hole.face;
    let fits =
        |drill: &&Drill<'_>| if hole.exact { drill.diameter == hole.diameter } else { drill.diameter > hole.from };
    let chosen = all.iter().find(|drill| reaches(drill) && fits(drill));
    let Some(drill) = chosen else {
        let (HoleEnd::Through(end) | HoleEnd::Blind(end)) = hole.end;
        return Err(Refusal::Not(NoJob::NoDrill { diameter: hole.diameter, depth: end - hole.face }));
    };
    let (tip, point) = (tip_of(drill), drill.point());
    // A flat drill takes a cone away, as wide at its mouth as itself: it is fed like a drill in solid metal.
    let opens = hole.from > Micrometres::ZERO && !hole.flat;
    let (operation, from) =
        if opens { (Operation::DrillOut, hole.from) } else { (Operation::Drill, Micrometres::ZERO) };
    let depth = (tip - hole.face).rounded_up();
    let (rates, _) = rates::of_table(bench.knowledge)?;
    let approach = Half::of(rates.approach);
    let cut = Cut {
        blind: matches!(hole.end, HoleEnd::Blind(_)),
        ..cut(operation, drill.diameter, from, depth, drill.material)
    };
    let AxialConditions { speed, feed, because: of_pace } = pace::pace(&cut, lathe, bench)?;
    let mut because = vec![Because::row(drill.row.row, Note::new("job-tool-taken").with("tool", drill.designation))];
    because.extend(of_pace);
    let ratio = depth.to_mm() / drill.diameter.to_mm();
    let material_group = bench.material.group;
    let asked = bench.knowledge.ask(&MachiningCycleFor { operation, depth_ratio: ratio, material_group })?;
    let cycle = asked.need(operation.name())?;
    let steps = Steps {
        kind: cycle.cycle,
        step: Half::from(cycle.step.unwrap_or(1.0) * drill.diameter.to_mm()),
        back: Half::of(cycle.clearance.unwrap_or_default()),
    };
    // The hole is there down to the cone: a flat drill comes to it at rapid, and takes it away in one stroke.
    let cone = hole.flat.then(|| tip - Half::from(drill.diameter.to_mm() / 2.0 / libm::tan(HALF_POINT.to_radians())));
    let (path, count) = match cone {
        Some(cone) => (flattening(hole.face - approach, cone - approach, tip), 1),
        None => steps.toolpath(hole.face - approach, hole.face, tip),
    };
    let code = if hole.flat { "job-flattened" } else { "job-drilled" };
    let note = Note::new(code).with("diameter", drill.diameter).with("tip", tip).with("steps", count);
    because.push(Because::answer(
        &asked.answer,
        Note::new("job-drill-steps").with("ratio", crate::units::round_to(ratio, 2)).with("steps", count),
    ));
    let mut notes = vec![note];
    if matches!(hole.end, HoleEnd::Blind(_)) && !hole.flat {
        notes.push(Note::new("job-drill-point").with("full", tip - point).with("point", point));
    }
    because.extend(limits.because);
    let body =
        Body::Drill { diameter_mm: drill.diameter, point_angle_deg: drill.point_angle, flute_mm: Some(drill.flute) };
    let designation = if hole.flat { format!("{}/180", drill.designation) } else { drill.designation.to_owned() };
    let tool = JobTool { designation, body };
    let rapid = bench.workpiece.rates.map_or(lathe.rapid_z, |given| given.main.rapid);
    Ok(Job {
        work: if hole.flat { Work::Flatten } else { Work::Drill },
        side: Side::Inner,
        tool,
        surfaces: hole.surfaces.clone(),
        time_min: time(&path, speed, &feed, rapid),
        path,
        pace: super::Pace::PerRev { speed, feeds: feed },
        conditions: None,
        thread: None,
        zone: None,
        notes,
        because,
    })
}

/// The point angle of a drill that is reground flat.
const FLAT: Degrees = Degrees(180.0);

/// Half the angle of a twist drill's point, degrees (ГОСТ 10903).
const HALF_POINT: f64 = 59.0;

/// The path of a flat drill: to the cone at rapid, through it at feed.
fn flattening(from: Half, cone: Half, tip: Half) -> Toolpath {
    let at = |z: Half| Point { radius: Half::ZERO, z };
    let mut path = Toolpath::at(at(from));
    if cone > from {
        path.go(at(cone), Purpose::Rapid);
    }
    path.go(at(tip), Purpose::Plunge);
    path.go(at(from), Purpose::Rapid);
    path
}

/// A cut on the axis with default values.
fn cut(
    operation: Operation,
    diameter: Micrometres,
    from: Micrometres,
    depth: Micrometres,
    tool_material: ToolMaterial,
) -> Cut {
    Cut {
        operation,
        diameter,
        feed_diameter: None,
        tool_diameter: None,
        from,
        passes: 1,
        depth,
        travel: depth,
        tool_material,
        nose_radius: None,
        roughness: None,
        reamer_follows: false,
        blind: true,
        surface: Surface::None,
        it: None,
        pitch: None,
        cutter: None,
    }
}

/// Whether the catalogs have a twist drill of a diameter.
///
/// # Errors
/// A table of tools is broken.
pub fn has_drill(diameter: Micrometres, bench: &Bench<'_, '_>) -> Result<bool, KnowledgeError> {
    let found = Refusal::split(drills(diameter, bench))?;
    Ok(found.is_ok_and(|drills| drills.first().is_some_and(|widest| widest.diameter == diameter)))
}

/// The twist drills that are not wider than a diameter, the widest first; of one diameter in the order of the rule
/// `tool-tables`.
fn drills<'k>(most: Micrometres, bench: &Bench<'_, 'k>) -> Tried<Vec<Drill<'k>>, NoJob> {
    let order: Vec<String> =
        match bench.knowledge.ask(&ToolTablesFor { operation: Operation::Drill, diameter: most })?.winner()? {
            Some(rule) => rule.tables.iter().map(|table| (*table).to_owned()).collect(),
            None => Vec::new(),
        };
    let only_drills = |head: &ToolHead| {
        head.operations.contains(&Operation::Drill)
            && head.operations.iter().all(|one| matches!(one, Operation::Drill | Operation::DrillOut))
    };
    let mut found: Vec<(usize, Drill<'k>)> = Vec::new();
    for table in bench.knowledge.tables() {
        let Some((head, angle)) =
            table.tool.as_ref().filter(|head| only_drills(head)).and_then(|head| Some((head, head.point_angle?)))
        else {
            continue;
        };
        let place = order.iter().position(|id| *id == table.id).unwrap_or(order.len());
        for row in table.rows::<CutterRow<'_>>() {
            let row = row?;
            let reach = row.reach.or(row.flute_length);
            let (Some(diameter), Some(flute), Some(designation)) = (row.diameter, reach, row.designations().next())
            else {
                continue;
            };
            if diameter <= most {
                let drill = Drill {
                    designation,
                    diameter,
                    material: head.material,
                    point_angle: Degrees(angle.to_f64()),
                    flute,
                    row,
                };
                found.push((place, drill));
            }
        }
    }
    found.sort_by_key(|(place, drill)| (std::cmp::Reverse(drill.diameter), *place));
    Ok(found.into_iter().map(|(_, drill)| drill).collect())
}

/// The infeed of a drill.
#[derive(Clone, Copy, Debug)]
struct Steps {
    kind: HoleCycle,
    step: Half,
    /// The retract of chip breaking, or the distance before the metal where a rapid ends.
    back: Half,
}

impl Steps {
    /// The path of the point along the axis, and its steps.
    fn toolpath(self, from: Half, face: Half, tip: Half) -> (Toolpath, i64) {
        let at = |z: Half| Point { radius: Half::ZERO, z };
        let mut path = Toolpath::at(at(from));
        let stepped = matches!(self.kind, HoleCycle::Peck | HoleCycle::ChipBreak);
        let count = if stepped { (tip - face).parts(self.step).max(1) } else { 1 };
        for number in 1..=count {
            let to = if number == count { tip } else { face + Half::new(self.step.halves() * number) };
            path.go(at(to), Purpose::Plunge);
            if number == count {
                break;
            }
            match self.kind {
                HoleCycle::Peck => {
                    path.go(at(from), Purpose::Rapid);
                    path.go(at(to - self.back), Purpose::Rapid);
                }
                _ => path.go(at(to - self.back), Purpose::Return),
            }
        }
        path.go(at(from), Purpose::Rapid);
        (path, count)
    }
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
    let rows = bench.knowledge.rows::<CentreHole<'_>>()?;
    let least = rows.iter().map(|row| row.cone).min().unwrap_or_default();
    // It goes no deeper than the drill.
    let fits = |row: &CentreHole<'_>| row.cone <= most && face + Half::of(row.cone_depth + row.pilot_length) < end;
    let fitting = rows.into_iter().filter(fits).max_by_key(|row| row.pilot);
    let Some(row) = fitting else {
        let least = Micrometres::from_mm_rounded(least.to_mm() / share.max(0.01));
        return Err(Refusal::Not(NoJob::NoCentreHole { diameter: drill, least }));
    };
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
        ..cut(Operation::CentreDrill, mouth, Micrometres::ZERO, depth, ToolMaterial::HighSpeedSteel)
    };
    let AxialConditions { speed, feed, because: of_pace } = pace::pace(&cut, lathe, bench)?;
    let (rates, _) = rates::of_table(bench.knowledge)?;
    let at = |z: Half| Point { radius: Half::ZERO, z };
    let from = face - Half::of(rates.approach);
    let mut path = Toolpath::at(at(from));
    path.go(at(face + Half::of(depth)), Purpose::Plunge);
    path.go(at(from), Purpose::Rapid);
    let note = note.with("tool", designation).with("mouth", mouth).with("depth", depth);
    let mut because = vec![Because::row(row.row, note.clone())];
    because.extend(of_pace);
    let rapid = bench.workpiece.rates.map_or(lathe.rapid_z, |given| given.main.rapid);
    let body = Body::CentreDrill { pilot_mm: row.pilot, pilot_length_mm: row.pilot_length, body_mm: body };
    Ok(Job {
        work: Work::Centre,
        side: Side::Inner,
        tool: JobTool { designation: designation.to_owned(), body },
        surfaces: Vec::new(),
        time_min: time(&path, speed, &feed, rapid),
        path,
        pace: super::Pace::PerRev { speed, feeds: feed },
        conditions: None,
        thread: None,
        zone: None,
        notes: vec![note],
        because,
    })
}
