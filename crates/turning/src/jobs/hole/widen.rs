//! Tools on the axis that follow a drill: core drills, reamers, countersinks.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::vocabulary::{Operation, ToolMaterial};
use crate::note::{Because, Note};
use crate::tables::holes::{HoleConvention, HoleDefault};
use crate::tables::rules::{Lead, ReamerLeadFor, ToolTablesFor};
use crate::tables::tools::CutterRow;
use crate::tables::turning::jobs::JobLimit;
use crate::turning::contour::SurfaceName;
use crate::turning::length::Half;
use crate::turning::operation::tools::Bench;
use crate::turning::program::Speed;
use crate::turning::tooling::Lathe;
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::units::{Degrees, ItGrade, Micrometres, Roughness};
use technolog_core::shop::grind_limit;
use technolog_cutting::reaming::rough_instead;
use technolog_cutting::{Cut, speed_at};

use super::super::limits::Limits;
use super::super::refused::NoJob;
use super::super::{Body, Job, JobTool, Work, site};
use super::pace::{self, AxialConditions};
use super::{HoleEnd, Stroke, before, cone_length, cut, in_and_out, on_axis};

/// A hole that a core drill or a reamer makes wider.
#[derive(Clone, Debug)]
pub struct Widening {
    /// Core drilling, or one of the two reamings.
    pub operation: Operation,
    /// The diameter after it.
    pub diameter: Micrometres,
    /// The diameter before it.
    pub from: Micrometres,
    /// Z of the face where it begins.
    pub face: Half,
    /// Its end; in a blind hole the front of the tool goes to that Z.
    pub end: HoleEnd,
    /// The surfaces that it finishes; empty for a tool that prepares.
    pub surfaces: Vec<SurfaceName>,
    /// The grade that it must hold, if it is the last.
    pub it: Option<ItGrade>,
    /// The roughness that it must leave, if it is the last.
    pub roughness: Option<Roughness>,
}

/// A cutter of the catalogs for it.
struct Chosen<'k> {
    row: CutterRow<'k>,
    designation: &'k str,
    diameter: Micrometres,
    material: ToolMaterial,
    /// How deep it enters.
    reach: Micrometres,
}

/// The job of a core drill or a reamer.
///
/// # Errors
/// The hole leaves it nothing to cut; no cutter of that size reaches so deep; the tables have no figures; the knowledge base lacks a table.
pub fn widen(task: &Widening, bench: &Bench<'_, '_>) -> Tried<Job, NoJob> {
    let lathe = site::lathe(bench)?;
    if task.from >= task.diameter {
        let (operation, diameter, from) = (task.operation, task.diameter, task.from);
        return Err(Refusal::Not(NoJob::NoStock { operation, diameter, from }));
    }
    let mut limits = Limits::of(bench.knowledge);
    let beyond = Half::of(limits.length(JobLimit::DrillBreakthrough)?);
    let blind = matches!(task.end, HoleEnd::Blind(_));
    let angle = lead_angle(bench)?;
    let (height, lead) = lead(task, angle, &mut limits, bench)?;
    let tip = match task.end {
        HoleEnd::Through(end) => end + lead + beyond,
        HoleEnd::Blind(end) => end,
    };
    let depth = tip - task.face;
    let reaches = |one: &Chosen<'_>| Half::of(one.reach) >= depth;
    let Some(tool) = cutters(task, blind, angle, bench)?.into_iter().find(reaches) else {
        let (operation, diameter) = (task.operation, task.diameter);
        return Err(Refusal::Not(NoJob::NoCutter { operation, diameter, depth }));
    };
    let cut = Cut {
        blind,
        it: task.it,
        roughness: task.roughness,
        ..cut(task.operation, task.diameter, task.from, depth.rounded_up(), tool.material)
    };
    let conditions = no_faster_than_rough(pace::pace(&cut, lathe, bench)?, &cut, lathe, bench)?;
    let core_drills = task.operation == Operation::CoreDrill;
    // A reamer comes out at its feed: at rapid its margins score the wall.
    let out = if core_drills { Purpose::Rapid } else { Purpose::Plunge };
    let path = in_and_out(task.face, tip, out, bench)?;
    let ground = tool.diameter != task.diameter;
    let note = || Note::new("job-ground").with("nominal", tool.diameter).with("size", task.diameter);
    let body = Body::Reamer {
        diameter_mm: task.diameter,
        front_mm: (Half::radius_of(task.diameter) - height).diameter(),
        lead_mm: lead.rounded_up(),
        reach_mm: tool.reach,
    };
    let designation =
        if ground { format!("{}/{}", tool.designation, task.diameter) } else { tool.designation.to_owned() };
    let stroke = Stroke {
        work: if core_drills { Work::CoreDrill } else { Work::Ream },
        tool: JobTool { designation, body },
        surfaces: task.surfaces.clone(),
        path,
        notes: ground.then(note).into_iter().collect(),
        row: Because::row(tool.row.row, Note::new("job-tool-taken").with("tool", tool.designation)),
        because: limits.because,
    };
    Ok(stroke.job(conditions, lathe, bench))
}

/// The height and the length of a tool's lead. That of a reamer is longer than the stock asks, by the convention for holes in plates.
fn lead(
    task: &Widening,
    angle: Lead,
    limits: &mut Limits<'_>,
    bench: &Bench<'_, '_>,
) -> Result<(Half, Half), KnowledgeError> {
    let height = convention(HoleDefault::ReamerLeadShare, bench)? * (task.diameter - task.from).to_mm() / 2.0;
    let slope = match angle {
        _ if task.operation == Operation::CoreDrill => limits.ratio(JobLimit::CoreDrillLead)?,
        Lead::Deg5 => 1.0 / libm::tan(5_f64.to_radians()),
        Lead::Deg15 => 1.0 / libm::tan(15_f64.to_radians()),
    };
    Ok((Half::from(height), Half::from(height * slope)))
}

/// The angle of a reamer's lead, by the rule `reamer-lead`.
fn lead_angle(bench: &Bench<'_, '_>) -> Result<Lead, KnowledgeError> {
    let asked = bench.knowledge.ask(&ReamerLeadFor { material_group: bench.material.group })?;
    Ok(asked.need(bench.material.group)?.lead)
}

/// A convention on holes.
fn convention(name: HoleDefault, bench: &Bench<'_, '_>) -> Result<f64, KnowledgeError> {
    Ok(HoleConvention::of(name, bench.knowledge)?.value)
}

/// Conditions at a speed that is at most that of a rough reamer, for the last one, as for holes in plates.
fn no_faster_than_rough(
    conditions: AxialConditions,
    cut: &Cut,
    lathe: &Lathe<'_>,
    bench: &Bench<'_, '_>,
) -> Tried<AxialConditions, NoJob> {
    let Some((rough, row)) = rough_instead(cut, bench.knowledge)? else { return Ok(conditions) };
    let most = pace::pace(&rough, lathe, bench)?.speed;
    Ok(match (conditions.speed, most) {
        (Speed::Spindle(own), Speed::Spindle(most)) if most.0 < own.0 => {
            let used = speed_at(most, cut.diameter).rounded(1);
            let note = Note::new("reamed-for-surface").with("stock", row.stock_max).with("speed", used.0);
            let because = conditions.because.into_iter().chain([Because::row(row.row, note)]).collect();
            AxialConditions { speed: Speed::Spindle(most), because, ..conditions }
        }
        _ => conditions,
    })
}

/// The rows of the tables that the rule `tool-tables` names for a cutter, in their order, each with the material of its table.
fn rows<'k>(
    operation: Operation,
    diameter: Micrometres,
    bench: &Bench<'_, 'k>,
) -> Result<Vec<(CutterRow<'k>, ToolMaterial)>, KnowledgeError> {
    let asked = bench.knowledge.ask(&ToolTablesFor { operation, diameter })?;
    let named = asked.winner()?.map(|rule| rule.tables).unwrap_or_default();
    let mut rows = Vec::new();
    for table in named.into_iter().filter_map(|id| bench.knowledge.tables().find(|table| table.id == *id)) {
        let Some(head) = table.tool.as_ref() else { continue };
        for row in table.rows::<CutterRow<'_>>() {
            rows.push((row?, head.material));
        }
    }
    Ok(rows)
}

/// The cutters of that size, or wider by no more than may be ground off, the nearest first; of one diameter in the order of the
/// rule `tool-tables`.
fn cutters<'k>(task: &Widening, blind: bool, lead: Lead, bench: &Bench<'_, 'k>) -> Tried<Vec<Chosen<'k>>, NoJob> {
    let most = task.diameter + grind_limit(task.diameter, bench.knowledge)?;
    let of = |(row, material): (CutterRow<'k>, ToolMaterial)| {
        let (diameter, reach) =
            (row.diameter?, row.reach.or(row.flute_length).or(row.projection).or(row.cutting_length)?);
        let of_end = if blind { row.designation_blind } else { row.designation_through };
        let of_lead = match lead {
            Lead::Deg5 => row.designation_5deg,
            Lead::Deg15 => row.designation_15deg,
        };
        let designation = row.designation.or(of_end).or(of_lead)?;
        let fits = diameter >= task.diameter && diameter <= most;
        fits.then_some(Chosen { row, designation, diameter, material, reach })
    };
    let mut found: Vec<Chosen<'k>> = rows(task.operation, task.diameter, bench)?.into_iter().filter_map(of).collect();
    found.sort_by_key(|one| one.diameter);
    Ok(found)
}

/// A chamfer at the mouth of a hole on the axis.
#[derive(Clone, Debug)]
pub struct Mouth {
    /// Its diameter at the face.
    pub wide: Micrometres,
    /// The diameter of the hole.
    pub hole: Micrometres,
    /// The full angle of its cone.
    pub angle: Degrees,
    /// Z of the finished face.
    pub face: Half,
    /// From where the tool comes: Z of the rough face.
    pub rough_face: Half,
    /// The diameter of the bore before it, through which the countersink goes; none at the face of the part.
    pub within: Option<Micrometres>,
    /// Its surface.
    pub surface: SurfaceName,
}

/// The job of a countersink of the angle of the chamfer, as wide as it or wider.
///
/// # Errors
/// No countersink has its angle and size; the tables have no figures; the knowledge base lacks a table.
pub fn countersink(mouth: &Mouth, bench: &Bench<'_, '_>) -> Tried<Job, NoJob> {
    let lathe = site::lathe(bench)?;
    let point = mouth.face + cone_length(Half::radius_of(mouth.wide), mouth.angle);
    let found = countersinks(mouth, bench)?.into_iter().min_by_key(|one| one.diameter);
    let Some(Countersink { front, tool, material, row, .. }) = found else {
        let (operation, diameter, depth) = (Operation::Chamfer, mouth.wide, point - mouth.rough_face);
        return Err(Refusal::Not(NoJob::NoCutter { operation, diameter, depth }));
    };
    // It is set by its front, which is flat.
    let tip = point - cone_length(Half::radius_of(front), mouth.angle);
    let depth = tip - mouth.rough_face;
    // A maker runs and feeds it as a drill of the middle diameter.
    let mut limits = Limits::of(bench.knowledge);
    let share = limits.ratio(JobLimit::CountersinkShare)?;
    let middle = mouth.hole + Micrometres::from_mm_rounded((mouth.wide - mouth.hole).to_mm() * share);
    let cut = cut(Operation::Drill, middle, Micrometres::ZERO, depth.rounded_up(), material);
    let conditions = pace::pace(&cut, lathe, bench)?;
    let mut path = in_and_out(mouth.rough_face, tip, Purpose::Rapid, bench)?;
    if mouth.within.is_some() {
        // Through the wider bore at rapid.
        let (from, near) = (path.from, on_axis(before(mouth.face, bench)?));
        path = Toolpath::at(from);
        path.go(near, Purpose::Rapid);
        path.go(on_axis(tip), Purpose::Plunge);
        path.go(from, Purpose::Rapid);
    }
    let stroke = Stroke {
        work: Work::Countersink,
        tool,
        surfaces: vec![mouth.surface.clone()],
        path,
        notes: Vec::new(),
        row,
        because: limits.because,
    };
    Ok(stroke.job(conditions, lathe, bench))
}

/// Whether a countersink of the catalogs makes a mouth.
///
/// # Errors
/// A table of tools is broken.
pub fn has_countersink(mouth: &Mouth, bench: &Bench<'_, '_>) -> Result<bool, KnowledgeError> {
    Ok(!countersinks(mouth, bench)?.is_empty())
}

/// A countersink of the catalogs.
struct Countersink {
    diameter: Micrometres,
    /// The diameter of its flat front; zero where its cone ends in a point.
    front: Micrometres,
    tool: JobTool,
    material: ToolMaterial,
    row: Because,
}

/// The countersinks of the angle of a mouth, as wide as it or wider, that go in.
fn countersinks(mouth: &Mouth, bench: &Bench<'_, '_>) -> Result<Vec<Countersink>, KnowledgeError> {
    let of = |(row, material): (CutterRow<'_>, ToolMaterial)| {
        let (diameter, angle, designation) = (row.diameter?, row.cone_angle?, row.designations().next()?);
        let same_angle = (angle.0 - mouth.angle.0).abs() < SAME_ANGLE;
        let enters = mouth.within.is_none_or(|within| diameter < within);
        let front = row.tip_diameter.unwrap_or_default();
        let wide = diameter >= mouth.wide && front <= mouth.hole;
        let cone = cone_length(Half::radius_of(diameter) - Half::radius_of(front), mouth.angle).rounded_up();
        let body = Body::Reamer {
            diameter_mm: diameter,
            front_mm: front,
            lead_mm: cone,
            reach_mm: row.cutting_length.unwrap_or(cone).max(cone),
        };
        let taken = Because::row(row.row, Note::new("job-tool-taken").with("tool", designation));
        let tool = JobTool { designation: designation.to_owned(), body };
        (same_angle && wide && enters).then_some(Countersink { diameter, front, tool, material, row: taken })
    };
    Ok(rows(Operation::Chamfer, mouth.wide, bench)?.into_iter().filter_map(of).collect())
}

/// Angles nearer than this are the same, degrees.
const SAME_ANGLE: f64 = 0.01;
