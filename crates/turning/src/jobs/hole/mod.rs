//! Holes on the axis: the spot for a drill, the centre holes of ГОСТ 14034, and drilling. Feed, speed, torque and
//! thrust follow the same tables and formulas as for holes in plates, within the limits of the lathe.

mod centre;
mod pace;
mod tap;
mod widen;

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests look at what notes are told")]
mod tests;

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::table::ToolHead;
use crate::knowledge::vocabulary::{Operation, Surface, ToolMaterial};
use crate::note::{Because, Note};
use crate::tables::holes::FirstDrill;
use crate::tables::rules::{HoleCycle, MachiningCycleFor, ToolTablesFor, TwoPassDrillingFor};
use crate::tables::tools::CutterRow;
use crate::tables::turning::jobs::JobLimit;
use crate::turning::contour::{Side, SurfaceName};
use crate::turning::length::Half;
use crate::turning::operation::tools::Bench;
use crate::turning::point::Point;
use crate::turning::program::Feeds;
use crate::turning::schemes::rates;
use crate::turning::tooling::Lathe;
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::units::{Degrees, Micrometres, MillimetresPerRev};
use technolog_cutting::{Cut, handbook};

use super::limits::Limits;
use super::refused::NoJob;
use super::site;
use super::{Body, Job, JobTool, Work};
pub use centre::{CentreForm, centre_hole, centre_hole_for, spot};
use pace::AxialConditions;
pub use tap::{drilled_behind, plain_before, tap};
pub use widen::{Mouth, Widening, countersink, has_countersink, widen};

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
    /// Whether a tap follows: the drill is then fed less, as before a reamer.
    pub tapped: bool,
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
        cone_length(Half::radius_of(self.diameter), self.point_angle)
    }

    fn taken(&self) -> Because {
        Because::row(self.row.row, Note::new("job-tool-taken").with("tool", self.designation))
    }

    const fn body(&self) -> Body {
        Body::Drill { diameter_mm: self.diameter, point_angle_deg: self.point_angle, flute_mm: Some(self.flute) }
    }
}

/// The jobs of a hole: one drill, or by the rule `two-pass-drilling` a narrower one before it; where none of its share of the
/// diameter is long enough, the widest that may drill alone.
///
/// # Errors
/// As for [`drill`].
pub fn drilling(hole: &Hole, bench: &Bench<'_, '_>) -> Tried<Vec<Job>, NoJob> {
    let material_group = bench.material.group;
    let question = |diameter| TwoPassDrillingFor { diameter, material_group, first_drill_in_magazine: false };
    let asked = bench.knowledge.ask(&question(hole.diameter))?;
    let passes = asked.need(&hole.diameter.to_string())?.passes;
    if passes < 2 || hole.from > Micrometres::ZERO {
        return Ok(vec![drill(hole, bench)?]);
    }
    let share = bench.knowledge.need("two-pass drilling", |_: &FirstDrill<'_>| true)?;
    let most = Micrometres::from_mm_rounded(hole.diameter.to_mm() * share.share_max);
    let opening = |diameter| drill(&Hole { diameter, exact: false, tapped: false, ..hole.clone() }, bench);
    let mut first = opening(most);
    if matches!(first, Err(Refusal::Not(NoJob::NoDrill { .. }))) {
        for one in drills(hole.diameter, bench)? {
            if bench.knowledge.ask(&question(one.diameter))?.winner()?.is_some_and(|row| row.passes < 2) {
                first = first.or_else(|_| opening(one.diameter));
                break;
            }
        }
    }
    let mut first = first?;
    let note = Note::new("job-first-drill").with("diameter", hole.diameter).with("most", most);
    first.because.extend([Because::answer(&asked.answer, note.clone()), Because::row(share.row, note)]);
    let from = first.tool.diameter().unwrap_or_default();
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
    let fits =
        |drill: &Drill<'_>| if hole.exact { drill.diameter == hole.diameter } else { drill.diameter > hole.from };
    let drill = chosen(hole, bench, |drill| fits(drill).then(|| tip_of(drill)))?;
    let (tip, point) = (tip_of(&drill), drill.point());
    let operation = if hole.from > Micrometres::ZERO { Operation::DrillOut } else { Operation::Drill };
    let depth = (tip - hole.face).rounded_up();
    let cut = Cut {
        blind: matches!(hole.end, HoleEnd::Blind(_)),
        reamer_follows: hole.tapped,
        ..cut(operation, drill.diameter, hole.from, depth, drill.material)
    };
    let conditions = pace::pace(&cut, lathe, bench)?;
    let ratio = depth.to_mm() / drill.diameter.to_mm();
    let material_group = bench.material.group;
    let asked = bench.knowledge.ask(&MachiningCycleFor { operation, depth_ratio: ratio, material_group })?;
    let cycle = asked.need(operation.name())?;
    let steps = Steps {
        kind: cycle.cycle,
        step: Half::from(cycle.step.unwrap_or(1.0) * drill.diameter.to_mm()),
        back: Half::of(cycle.clearance.unwrap_or_default()),
    };
    let (path, count) = steps.toolpath(before(hole.face, bench)?, hole.face, tip);
    let mut notes =
        vec![Note::new("job-drilled").with("diameter", drill.diameter).with("tip", tip).with("steps", count)];
    if matches!(hole.end, HoleEnd::Blind(_)) {
        notes.push(Note::new("job-drill-point").with("full", tip - point).with("point", point));
    }
    let note = Note::new("job-drill-steps").with("ratio", crate::units::round_to(ratio, 2)).with("steps", count);
    let mut because = vec![Because::answer(&asked.answer, note)];
    because.extend(limits.because);
    let tool = JobTool { designation: drill.designation.to_owned(), body: drill.body() };
    let (row, surfaces) = (drill.taken(), hole.surfaces.clone());
    Ok(Stroke { work: Work::Drill, tool, surfaces, path, notes, row, because }.job(conditions, lathe, bench))
}

/// The job of the drill of another job, reground flat: it takes away the cone that this drill has left over a bottom.
///
/// # Errors
/// The drill does not reach the bottom; it exceeds the limits of the lathe; the knowledge base lacks a table.
pub fn flatten(
    drilled: &Job,
    bottom: Half,
    face: Half,
    surfaces: Vec<SurfaceName>,
    bench: &Bench<'_, '_>,
) -> Tried<Job, NoJob> {
    let lathe = site::lathe(bench)?;
    let diameter = drilled.tool.diameter().unwrap_or_default();
    let end = HoleEnd::Blind(bottom);
    let hole = Hole { diameter, from: Micrometres::ZERO, face, end, surfaces, exact: true, tapped: false };
    let drill = chosen(&hole, bench, |drill| (drill.diameter == diameter).then_some(bottom))?;
    let drill = Drill { point_angle: FLAT, ..drill };
    // The cone is as wide at its mouth as the drill: it is fed as in solid metal, but no faster than the drill before, and than a
    // counterbore, whose straight edges cut over their whole width at once, too.
    let cut = cut(Operation::Drill, diameter, Micrometres::ZERO, (bottom - face).rounded_up(), drill.material);
    let mut conditions = pace::pace(&cut, lathe, bench)?;
    let counterbore = Cut { operation: Operation::Counterbore, ..cut };
    let flat = Refusal::split(handbook::feed(&counterbore, bench))?.ok();
    let drilled = drilled.pace.feeds().map(|feeds| feeds.cut);
    let most = drilled.into_iter().chain(flat.as_ref().map(|(feed, _)| *feed)).map(|feed| feed.0);
    let least = most.fold(conditions.feed.cut.0, f64::min);
    conditions.feed = Feeds::all(MillimetresPerRev(least));
    conditions.because.extend(flat.into_iter().flat_map(|(_, because)| because));
    let from = before(face, bench)?;
    // The hole is there down to the cone, and further above a narrower hole.
    let cone = before(bottom - cone_length(Half::radius_of(diameter), TWIST_POINT), bench)?;
    let mut path = Toolpath::at(on_axis(from));
    if cone > from {
        path.go(on_axis(cone), Purpose::Rapid);
    }
    path.go(on_axis(bottom), Purpose::Plunge);
    path.go(on_axis(from), Purpose::Rapid);
    let notes = vec![Note::new("job-flattened").with("diameter", diameter).with("tip", bottom)];
    let tool = JobTool { designation: format!("{}/180", drill.designation), body: drill.body() };
    let (row, because) = (drill.taken(), Vec::new());
    let stroke = Stroke { work: Work::Flatten, tool, surfaces: hole.surfaces, path, notes, row, because };
    Ok(stroke.job(conditions, lathe, bench))
}

/// The widest drill for a hole that reaches the Z to which its point must go; none where the drill does not fit.
fn chosen<'k>(
    hole: &Hole,
    bench: &Bench<'_, 'k>,
    tip_of: impl Fn(&Drill<'k>) -> Option<Half>,
) -> Tried<Drill<'k>, NoJob> {
    let reaches = |drill: &Drill<'k>| tip_of(drill).is_some_and(|tip| Half::of(drill.flute) >= tip - hole.face);
    drills(hole.diameter, bench)?.into_iter().find(reaches).ok_or_else(|| {
        let (HoleEnd::Through(end) | HoleEnd::Blind(end)) = hole.end;
        Refusal::Not(NoJob::NoDrill { diameter: hole.diameter, depth: end - hole.face })
    })
}

/// The point angle of a drill that is reground flat.
const FLAT: Degrees = Degrees(180.0);

/// The point angle of a twist drill (ГОСТ 10903).
const TWIST_POINT: Degrees = Degrees(118.0);

/// The length of a cone of a full angle, from its tip up to a radius.
fn cone_length(radius: Half, angle: Degrees) -> Half {
    Half::from(radius.to_mm() / libm::tan(angle.0.to_radians() / 2.0))
}

/// The length of a twist drill's point up to a radius.
pub fn point_length(radius: Half) -> Half {
    cone_length(radius, TWIST_POINT)
}

/// A point of the axis.
const fn on_axis(z: Half) -> Point {
    Point { radius: Half::ZERO, z }
}

/// Where the feed begins before a Z.
fn before(z: Half, bench: &Bench<'_, '_>) -> Result<Half, KnowledgeError> {
    let (rates, _) = rates::of_table(bench.knowledge)?;
    Ok(z - Half::of(rates.approach))
}

/// The path of a tool on the axis to a Z and back, from before a face.
fn in_and_out(face: Half, tip: Half, out: Purpose, bench: &Bench<'_, '_>) -> Result<Toolpath, KnowledgeError> {
    let from = before(face, bench)?;
    let mut path = Toolpath::at(on_axis(from));
    path.go(on_axis(tip), Purpose::Plunge);
    path.go(on_axis(from), out);
    Ok(path)
}

/// A tool of the axis with its path.
struct Stroke {
    work: Work,
    tool: JobTool,
    surfaces: Vec<SurfaceName>,
    path: Toolpath,
    notes: Vec<Note>,
    /// The row of the tool.
    row: Because,
    /// The rows behind its path.
    because: Vec<Because>,
}

impl Stroke {
    /// Its job with these conditions.
    fn job(self, conditions: AxialConditions, lathe: &Lathe<'_>, bench: &Bench<'_, '_>) -> Job {
        let Self { work, tool, surfaces, path, notes, row, because: of_path } = self;
        let AxialConditions { speed, feed, torque, because: of_pace } = conditions;
        let because = [row].into_iter().chain(of_pace).chain(of_path).collect();
        let rapid = bench.workpiece.rates.map_or(lathe.rapid_z, |given| given.main.rapid);
        let pace = super::Pace::PerRev { speed, feeds: feed };
        Job { surfaces, torque_n_m: torque, notes, because, ..Job::of(work, Side::Inner, tool, path, pace, rapid) }
    }
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
        flutes: None,
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
        around: None,
        plunges: false,
        slot: None,
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
        let mut path = Toolpath::at(on_axis(from));
        let stepped = matches!(self.kind, HoleCycle::Peck | HoleCycle::ChipBreak);
        let count = if stepped { (tip - face).parts(self.step).max(1) } else { 1 };
        for number in 1..=count {
            let to = if number == count { tip } else { face + Half::new(self.step.halves() * number) };
            path.go(on_axis(to), Purpose::Plunge);
            if number == count {
                break;
            }
            match self.kind {
                HoleCycle::Peck => {
                    path.go(on_axis(from), Purpose::Rapid);
                    path.go(on_axis(to - self.back), Purpose::Rapid);
                }
                _ => path.go(on_axis(to - self.back), Purpose::Return),
            }
        }
        path.go(on_axis(from), Purpose::Rapid);
        (path, count)
    }
}
