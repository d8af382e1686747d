//! Tools on the axis that follow a drill: core drills, reamers, countersinks.

use crate::error::{Refusal, Tried};
use crate::knowledge::vocabulary::{Operation, ToolMaterial};
use crate::note::{Because, Note};
use crate::tables::holes::{HoleConvention, HoleDefault};
use crate::tables::practice::StockBeforeReamingFor;
use crate::tables::rules::{Lead, ReamerLeadFor, ReamingCase, ToolTablesFor};
use crate::tables::tools::CutterRow;
use crate::tables::turning::jobs::JobLimit;
use crate::turning::contour::{Side, SurfaceName};
use crate::turning::length::Half;
use crate::turning::operation::tools::Bench;
use crate::turning::point::Point;
use crate::turning::program::Speed;
use crate::turning::schemes::rates;
use crate::turning::tooling::Lathe;
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::units::{Degrees, ItGrade, Micrometres, Roughness};
use technolog_cutting::{Cut, speed_at};

use super::super::clock::time;
use super::super::limits::Limits;
use super::super::refused::NoJob;
use super::super::{Body, Job, JobTool, Pace, Work, site};
use super::pace::{self, AxialConditions};
use super::{HoleEnd, cut};

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
    /// The angle of its lead to the axis.
    lead: Degrees,
    reach: Micrometres,
}

/// The play of the front of such a tool in the hole before it, a side: what the hole runs out of true must not hold it up.
const PLAY: Half = Half::new(300);

/// The angle of a core drill's lead to the axis (ГОСТ 12489: φ 60°).
const CORE_DRILL_LEAD: Degrees = Degrees(60.0);

/// The job of a core drill or a reamer.
///
/// # Errors
/// No cutter of that size reaches so deep; the tables have no figures; the knowledge base lacks a table.
pub fn widen(task: &Widening, bench: &Bench<'_, '_>) -> Tried<Job, NoJob> {
    let lathe = site::lathe(bench)?;
    let mut limits = Limits::of(bench.knowledge);
    let beyond = Half::of(limits.length(JobLimit::DrillBreakthrough)?);
    let height = Half::radius_of(task.diameter - task.from) + PLAY;
    let lead_of = |lead: Degrees| Half::from(height.to_mm() / libm::tan(lead.0.to_radians()));
    let blind = matches!(task.end, HoleEnd::Blind(_));
    let tip_of = |lead: Degrees| match task.end {
        HoleEnd::Through(end) => end + lead_of(lead) + beyond,
        HoleEnd::Blind(end) => end,
    };
    let reaches = |one: &Chosen<'_>| Half::of(one.reach) >= tip_of(one.lead) - task.face;
    let Some(tool) = cutters(task, blind, bench)?.into_iter().find(reaches) else {
        let (HoleEnd::Through(end) | HoleEnd::Blind(end)) = task.end;
        let (operation, diameter) = (task.operation, task.diameter);
        return Err(Refusal::Not(NoJob::NoCutter { operation, diameter, depth: end - task.face }));
    };
    let tip = tip_of(tool.lead);
    let depth = (tip - task.face).rounded_up();
    let cut = Cut {
        blind,
        it: task.it,
        roughness: task.roughness,
        ..cut(task.operation, task.diameter, task.from, depth, tool.material)
    };
    let AxialConditions { speed, feed, because: mut of_pace } = pace::pace(&cut, lathe, bench)?;
    let (speed, slower) = no_faster_than_rough(speed, &cut, lathe, bench)?;
    of_pace.extend(slower);
    let (rates, _) = rates::of_table(bench.knowledge)?;
    let at = |z: Half| Point { radius: Half::ZERO, z };
    let from = task.face - Half::of(rates.approach);
    let mut path = Toolpath::at(at(from));
    path.go(at(tip), Purpose::Plunge);
    // A reamer comes out at its feed: at rapid its margins score the wall.
    let out = if task.operation == Operation::CoreDrill { Purpose::Rapid } else { Purpose::Plunge };
    path.go(at(from), out);
    let ground = tool.diameter != task.diameter;
    let mut notes = Vec::new();
    if ground {
        notes.push(Note::new("job-ground").with("nominal", tool.diameter).with("size", task.diameter));
    }
    let mut because = vec![Because::row(tool.row.row, Note::new("job-tool-taken").with("tool", tool.designation))];
    because.extend(of_pace);
    because.extend(limits.because);
    let body = Body::Reamer {
        diameter_mm: task.diameter,
        front_mm: (Half::radius_of(task.diameter) - height).diameter(),
        lead_mm: lead_of(tool.lead).rounded_up(),
        reach_mm: tool.reach,
    };
    let designation =
        if ground { format!("{}/{}", tool.designation, task.diameter) } else { tool.designation.to_owned() };
    let rapid = bench.workpiece.rates.map_or(lathe.rapid_z, |given| given.main.rapid);
    Ok(Job {
        work: if task.operation == Operation::CoreDrill { Work::CoreDrill } else { Work::Ream },
        side: Side::Inner,
        tool: JobTool { designation, body },
        surfaces: task.surfaces.clone(),
        time_min: time(&path, speed, &feed, rapid),
        path,
        pace: Pace::PerRev { speed, feeds: feed },
        conditions: None,
        thread: None,
        zone: None,
        notes,
        because,
    })
}

/// The speed of the last reamer, which serves the surface, at most that of a rough one with the largest stock of
/// `stock-before-reaming`: the formula alone would make it faster for its smaller stock and feed. As for holes in plates.
fn no_faster_than_rough(
    speed: Speed,
    cut: &Cut,
    lathe: &Lathe<'_>,
    bench: &Bench<'_, '_>,
) -> Tried<(Speed, Option<Because>), NoJob> {
    if cut.operation != Operation::FinishReam {
        return Ok((speed, None));
    }
    let asked =
        bench.knowledge.ask(&StockBeforeReamingFor { case: ReamingCase::RoughAfterDrill, diameter: cut.diameter })?;
    let stock = asked.need(&cut.diameter.to_string())?;
    let rough = Cut { operation: Operation::RoughReam, from: cut.diameter - stock.stock_max, roughness: None, ..*cut };
    let rough = pace::pace(&rough, lathe, bench)?.speed;
    Ok(match (speed, rough) {
        (Speed::Spindle(own), Speed::Spindle(most)) if most.0 < own.0 => {
            let used = speed_at(most, cut.diameter).rounded(1);
            let note = Note::new("reamed-for-surface").with("stock", stock.stock_max).with("speed", used.0);
            (rough, Some(Because::answer(&asked.answer, note)))
        }
        _ => (speed, None),
    })
}

/// The cutters of that size, or wider by no more than may be ground off, the nearest first; of one diameter in the order of the
/// rule `tool-tables`.
fn cutters<'k>(task: &Widening, blind: bool, bench: &Bench<'_, 'k>) -> Tried<Vec<Chosen<'k>>, NoJob> {
    let limit = bench.knowledge.need(HoleDefault::CutterGrindLimit.name(), |row: &HoleConvention<'_>| {
        row.name == HoleDefault::CutterGrindLimit
    })?;
    let most = task.diameter + Micrometres::from_mm_rounded(limit.value);
    let asked = bench.knowledge.ask(&ReamerLeadFor { material_group: bench.material.group })?;
    let lead = asked.need(bench.material.group)?.lead;
    let mut found: Vec<Chosen<'k>> = Vec::new();
    let question = ToolTablesFor { operation: task.operation, diameter: task.diameter };
    let tables = bench.knowledge.ask(&question)?.winner()?.map(|rule| rule.tables).unwrap_or_default();
    for id in tables {
        let Some(table) = bench.knowledge.tables().find(|table| table.id == *id) else { continue };
        let Some(head) = table.tool.as_ref() else { continue };
        for row in table.rows::<CutterRow<'_>>() {
            let row = row?;
            // Shell tools sit on an arbor, which is as long as it is made.
            let reach = row.reach.or(row.flute_length).or(row.projection).or(row.cutting_length);
            let (Some(diameter), Some(reach)) = (row.diameter, reach) else { continue };
            let of_end = if blind { row.designation_blind } else { row.designation_through };
            let (of_lead, angle) = match lead {
                Lead::Deg5 => (row.designation_5deg, Degrees(5.0)),
                Lead::Deg15 => (row.designation_15deg, Degrees(15.0)),
            };
            let angle = if task.operation == Operation::CoreDrill { CORE_DRILL_LEAD } else { angle };
            let Some(designation) = row.designation.or(of_end).or(of_lead) else { continue };
            if diameter >= task.diameter && diameter <= most {
                found.push(Chosen { row, designation, diameter, material: head.material, lead: angle, reach });
            }
        }
    }
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
    /// Its surface.
    pub surface: SurfaceName,
}

/// The job of a countersink of the angle of the chamfer, as wide as it or wider.
///
/// # Errors
/// No countersink has its angle and size; the tables have no figures; the knowledge base lacks a table.
pub fn countersink(mouth: &Mouth, bench: &Bench<'_, '_>) -> Tried<Job, NoJob> {
    let lathe = site::lathe(bench)?;
    let question = ToolTablesFor { operation: Operation::Chamfer, diameter: mouth.wide };
    let tables = bench.knowledge.ask(&question)?.winner()?.map(|rule| rule.tables).unwrap_or_default();
    let mut found = Vec::new();
    for id in tables {
        let Some(table) = bench.knowledge.tables().find(|table| table.id == *id) else { continue };
        let Some(head) = table.tool.as_ref() else { continue };
        for row in table.rows::<CutterRow<'_>>() {
            let row = row?;
            let (Some(diameter), Some(angle), Some(designation)) =
                (row.diameter, row.cone_angle, row.designations().next())
            else {
                continue;
            };
            let fits = diameter >= mouth.wide && row.tip_diameter.is_none_or(|tip| tip <= mouth.hole);
            if fits && (angle.0 - mouth.angle.0).abs() < SAME_ANGLE {
                let reach = row.cutting_length.unwrap_or(diameter);
                found.push((diameter, designation, head.material, reach, row));
            }
        }
    }
    found.sort_by_key(|one| one.0);
    let Some((diameter, designation, material, reach, row)) = found.into_iter().next() else {
        let (operation, depth) = (Operation::Chamfer, mouth.face - mouth.rough_face);
        return Err(Refusal::Not(NoJob::NoCutter { operation, diameter: mouth.wide, depth }));
    };
    let tip = mouth.face + Half::from(mouth.wide.to_mm() / 2.0 / libm::tan(mouth.angle.0.to_radians() / 2.0));
    let depth = (tip - mouth.rough_face).rounded_up();
    // A maker runs and feeds it as a drill of the middle diameter.
    let mut limits = Limits::of(bench.knowledge);
    let share = limits.ratio(JobLimit::CountersinkShare)?;
    let middle = mouth.hole + Micrometres::from_mm_rounded((mouth.wide - mouth.hole).to_mm() * share);
    let cut = cut(Operation::Drill, middle, Micrometres::ZERO, depth, material);
    let AxialConditions { speed, feed, because: of_pace } = pace::pace(&cut, lathe, bench)?;
    let (rates, _) = rates::of_table(bench.knowledge)?;
    let at = |z: Half| Point { radius: Half::ZERO, z };
    let from = mouth.rough_face - Half::of(rates.approach);
    let mut path = Toolpath::at(at(from));
    path.go(at(tip), Purpose::Plunge);
    path.go(at(from), Purpose::Rapid);
    let mut because = vec![Because::row(row.row, Note::new("job-tool-taken").with("tool", designation))];
    because.extend(of_pace);
    because.extend(limits.because);
    let body = Body::Drill { diameter_mm: diameter, point_angle_deg: mouth.angle, flute_mm: Some(reach) };
    let rapid = bench.workpiece.rates.map_or(lathe.rapid_z, |given| given.main.rapid);
    Ok(Job {
        work: Work::Countersink,
        side: Side::Inner,
        tool: JobTool { designation: designation.to_owned(), body },
        surfaces: vec![mouth.surface.clone()],
        time_min: time(&path, speed, &feed, rapid),
        path,
        pace: Pace::PerRev { speed, feeds: feed },
        conditions: None,
        thread: None,
        zone: None,
        notes: Vec::new(),
        because,
    })
}

/// Angles nearer than this are the same, degrees.
const SAME_ANGLE: f64 = 0.01;
