//! Parting off: the part is cut from the bar behind its far face.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::note::{Because, Note};
use crate::tables::turning::jobs::{JobLimit, PartingBladeFor};
use crate::turning::contour::{Side, SurfaceName};
use crate::turning::cutting::Direction;
use crate::turning::length::Half;
use crate::turning::operation::tools::Bench;
use crate::turning::point::Point;
use crate::turning::program::{Feeds, Speed};
use crate::turning::tooling::{Hand, Place, Spindle, ToolKind, TurningTool};
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::units::{Micrometres, MillimetresPerRev, RevsPerMinute, round_to};
use technolog_cutting::speed_at;

use super::groove::blade_pace;
use super::limits::Limits;
use super::refused::NoJob;
use super::site;
use super::{Job, JobTool, Pace, Work};

/// A part that is cut off.
#[derive(Clone, Debug)]
pub struct Parting {
    /// The diameter of the bar at the cut.
    pub bar: Micrometres,
    /// The diameter of a solid bar that is as deep: of a tube twice its wall.
    pub solid: Micrometres,
    /// The diameter of the bore that the blade reaches; zero in solid metal.
    pub bore: Micrometres,
    /// The widest bore behind which the part hangs by its last wall: the feed is slow from there on.
    pub breaks: Micrometres,
    /// Z of the far face, with its allowance; the blade cuts behind it.
    pub face: Half,
    /// Z of the front of the jaws, if known.
    pub jaws: Option<Half>,
    /// The largest radius.
    pub clear: Half,
    /// The far face, if it is a surface of the drawing.
    pub surfaces: Vec<SurfaceName>,
}

/// The width of the blade that parts a bar.
///
/// # Errors
/// No blade is long enough, with the inequality; or the knowledge base lacks a table.
pub fn width(parting: &Parting, bench: &Bench<'_, '_>) -> Tried<Micrometres, NoJob> {
    Ok(blade(parting, &mut Limits::of(bench.knowledge), bench)?.1)
}

/// The least distance of the jaws behind the blade.
///
/// # Errors
/// The knowledge base lacks it.
pub fn jaw_gap(bench: &Bench<'_, '_>) -> Result<Micrometres, KnowledgeError> {
    Limits::of(bench.knowledge).length(JobLimit::PartingJawGap)
}

/// The stock that parting leaves on the face for the second set-up.
///
/// # Errors
/// The knowledge base lacks it.
pub fn face_stock(bench: &Bench<'_, '_>) -> Result<Micrometres, KnowledgeError> {
    Limits::of(bench.knowledge).length(JobLimit::PartingFaceStock)
}

/// The job of parting off, with the narrowest suitable blade: it wastes the least bar.
///
/// # Errors
/// No blade is long enough, or the jaws are too near, with the inequality; or the knowledge base lacks a table.
pub fn part_off(parting: &Parting, bench: &Bench<'_, '_>) -> Tried<Job, NoJob> {
    let lathe = site::lathe(bench)?;
    let mut limits = Limits::of(bench.knowledge);
    let (tool, width, mut because) = blade(parting, &mut limits, bench)?;
    let nose = Half::of(tool.nose_radius.unwrap_or_default());
    let lead = parting.face + Half::of(width);
    let gap = limits.length(JobLimit::PartingJawGap)?;
    if let Some(jaws) = parting.jaws.filter(|jaws| *jaws - lead < Half::of(gap)) {
        return Err(Refusal::Not(NoJob::JawsTooNear { gap: jaws - lead, least: gap }));
    }
    let cut = site::cut(&tool, parting.bar, Direction::Transverse, bench)?;
    let pace = blade_pace(&cut, width, bench.grip.as_ref().map(|grip| (grip, lead)))?;
    let blade = pace.blade;
    because.extend(pace.because);
    let slow = limits.ratio(JobLimit::PartingSlowFeed)?;
    let inner = Half::radius_of(parting.bore);
    // Its round corner must pass the axis, or a pip as high as the corner radius remains.
    let end = inner - nose;
    let breaks = Half::radius_of(parting.breaks.max(parting.bore));
    let slow_from = (breaks + Half::of(limits.length(JobLimit::PartingSlowFrom)?)).min(Half::radius_of(parting.bar));
    let at = |radius: Half| Point { radius, z: lead };
    let mut path = Toolpath::at(at(parting.clear));
    path.go(at(slow_from), Purpose::Plunge);
    path.go(at(end), Purpose::Infeed);
    path.go(at(parting.clear), Purpose::Rapid);
    let speed = match lathe.spindle {
        Spindle::Steps(_) => Speed::Spindle(pace.rpm),
        Spindle::Range { max, .. } => {
            // No faster than the jaws hold its whole pull.
            let held = bench.grip.as_ref().zip(pace.blade).and_then(|(grip, blade)| {
                grip.held_up_to(blade.torque(1.0), blade.along, pace.rpm).map(|rpm| libm::floor(rpm.0))
            });
            Speed::whole(speed_at(pace.rpm, parting.bar), RevsPerMinute(held.map_or(max.0, |held| held.min(max.0))))
        }
    };
    let feeds = Feeds { infeed: MillimetresPerRev(round_to(pace.plunge.0 * slow, 4)), ..Feeds::all(pace.plunge) };
    let rapid = bench.workpiece.rates.map_or(lathe.rapid_z, |given| given.main.rapid);
    let mut notes = vec![
        Note::new("part-off").with("tool", tool.designation).with("width", width).with("face", parting.face),
        Note::new("part-off-slow").with("radius", slow_from).with("feed", feeds.infeed.0),
    ];
    if parting.bore <= Micrometres::ZERO {
        notes.push(Note::new("part-off-pip").with("beyond", nose));
    }
    because.extend(limits.because);
    let (surfaces, tool, pace) = (parting.surfaces.clone(), JobTool::of(&tool), Pace::PerRev { speed, feeds });
    Ok(Job { surfaces, blade, notes, because, ..Job::of(Work::PartOff, Side::Outer, tool, path, pace, rapid) })
}

/// The narrowest blade that is wide enough for the bar and long enough for its wall.
fn blade<'k>(
    parting: &Parting,
    limits: &mut Limits<'k>,
    bench: &Bench<'_, 'k>,
) -> Tried<(TurningTool<'k>, Micrometres, Vec<Because>), NoJob> {
    let asked = bench.knowledge.ask(&PartingBladeFor { diameter: parting.solid })?;
    let least = asked.need(&parting.solid.to_string())?.width;
    let over_width = limits.ratio(JobLimit::PartingDepth)?;
    let mut tools = bench.tools(ToolKind::Grooving, Place::Outer)?;
    // The shank of a right-hand tool is on the side of the part, away from the jaws.
    tools.sort_by_key(|tool| (tool.width, tool.hand == Hand::L));
    let wall = Half::radius_of(parting.bar) - Half::radius_of(parting.bore);
    let mut longest = Micrometres::ZERO;
    for tool in tools {
        let (Some(width), Some(deepest)) = (tool.width, tool.groove_depth) else { continue };
        let reach = deepest.min(Micrometres::from_mm_rounded(width.to_mm() * over_width));
        longest = longest.max(reach);
        let needs = wall + Half::of(tool.nose_radius.unwrap_or_default());
        if width >= least && Half::of(reach) >= needs {
            let taken = Because::row(tool.row, Note::new("job-tool-taken").with("tool", tool.designation));
            let rule = Because::answer(
                &asked.answer,
                Note::new("parting-blade").with("bar", parting.solid).with("width", least),
            );
            return Ok((tool, width, vec![taken, rule]));
        }
    }
    Err(Refusal::Not(NoJob::PartingTooDeep { depth: wall, reach: longest }))
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests look at what notes are told")]
mod tests {
    use super::*;
    use crate::turning::jobs::tests::{at_bench, plain};

    fn job(bar: i64, bore: i64, jaws: f64) -> Result<Job, NoJob> {
        let parting = Parting {
            bar: Micrometres::from_mm(bar),
            solid: Micrometres::from_mm(bar),
            bore: Micrometres::from_mm(bore),
            breaks: Micrometres::ZERO,
            face: Half::from(40.5),
            jaws: Some(Half::from(jaws)),
            clear: Half::from(20.0),
            surfaces: Vec::new(),
        };
        at_bench(&plain("steel-45"), |bench| Refusal::split(part_off(&parting, bench)).unwrap())
    }

    /// By hand: a bar of 28 mm takes a blade of 3 mm (r 0.4), whose corner towards the chuck is 40.5 + 3 = 43.5 behind
    /// the face; from 2 mm before the axis with a quarter of the feed to 0.4 beyond it.
    #[test]
    fn a_bar_is_parted_beyond_its_axis() {
        let made = job(28, 0, 50.0).unwrap();
        assert_eq!(made.tool.designation, "MGEHR 2525-3");
        let ways: Vec<_> =
            made.path.moves.iter().map(|one| (one.to.radius.to_mm(), one.to.z.to_mm(), one.purpose)).collect();
        assert_eq!(ways, [(2.0, 43.5, Purpose::Plunge), (-0.4, 43.5, Purpose::Infeed), (20.0, 43.5, Purpose::Rapid)]);
        assert!((made.pace.feeds().unwrap().infeed.0 / made.pace.feeds().unwrap().plunge.0 - 0.25).abs() < 0.01);
        assert!(made.notes.iter().any(|note| note.code() == "part-off-pip"));
        // Kyocera 2016, p. 461: a blade of 3 mm at most 0.15 mm/rev; table 15 of the handbook has 0.10 to 40 mm.
        assert!((made.pace.feeds().unwrap().plunge.0 - 0.1).abs() < 1e-9);
    }

    /// A blade of 3 mm that reaches 15 mm parts a tube of Ø40 with a bore of 20; solid Ø40 requires 20 mm and the round
    /// corner, which no blade has.
    #[test]
    fn a_blade_too_short_and_jaws_too_near_are_refused() {
        let tube = job(40, 20, 60.0).unwrap();
        assert_eq!(tube.tool.designation, "MGEHR 2525-3");
        assert!(tube.path.moves.iter().any(|one| one.to.radius == Half::from(9.6)));
        let solid = job(40, 0, 60.0).unwrap_err();
        assert_eq!(solid, NoJob::PartingTooDeep { depth: Half::from(20.0), reach: Micrometres::from_mm(20) });
        // 48 − 43.5 = 4.5, less than the 5 of the table.
        let near = job(28, 0, 48.0).unwrap_err();
        assert_eq!(near, NoJob::JawsTooNear { gap: Half::from(4.5), least: Micrometres::from_mm(5) });
    }
}
