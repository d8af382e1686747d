//! Chooses the tool of a groove: the widest blade that fits; for a groove with a tolerance the widest one narrower than
//! the floor, so that both walls are turned. A relief too narrow for every blade is cut along its contour by a turning
//! tool whose edges clear its walls.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::Question;
use crate::note::{Because, Note};
use crate::tables::cutting::{GroovingFeedFor, GroovingSpeedFor};
use crate::tables::turning::jobs::{GroovingPracticeFor, JobLimit};
use crate::turning::contour::Surface;
use crate::turning::cutting::{
    BladeForce, Bound, CuttingRefusal, Direction, GripLimit, TurningCut, blade_force, conditions, finish_feed,
    floor_bears,
};
use crate::turning::length::Half;
use crate::turning::operation::tools::Bench;
use crate::turning::program::{Feeds, Speed};
use crate::turning::tooling::{Hand, Place, Shank, ToolKind, TurningTool};
use crate::units::{Micrometres, MillimetresPerRev, Newtons, RevsPerMinute, round_to};
use technolog_cutting::rpm_at;

use super::super::limits::Limits;
use super::super::refused::{NoJob, Operation, no_figure};
use super::super::site::{self, Site};
use super::valley::{Lie, Valley};
use super::ways::{self, CuttingEdge, Ways};
use super::{division, not, taken};

/// A tool with its toolpath and its cutting conditions.
pub(super) struct Chosen<'k> {
    pub tool: TurningTool<'k>,
    pub ways: Ways,
    pub speed: Speed,
    pub feeds: Feeds,
    pub because: Vec<Because>,
    /// Whether it is a turning tool.
    pub by_nose: bool,
    /// What a blade presses with.
    pub blade: Option<BladeForce>,
}

/// The first tool that can cut it, or a blade of that name if it can; otherwise the reason of the last one.
pub(super) fn choose<'k>(
    site: Site<'_>,
    surface: &Surface,
    valley: &Valley,
    only: Option<&str>,
    limits: &mut Limits<'k>,
    bench: &Bench<'_, 'k>,
) -> Tried<Chosen<'k>, NoJob> {
    let mut why = NoJob::NoTool { surface: surface.name.clone() };
    let wanted = |tool: &TurningTool<'_>| only.is_none_or(|only| tool.designation == only);
    for tool in blades(surface, valley, bench)?.into_iter().filter(wanted) {
        match Refusal::split(by_blade(site, surface, valley, tool, limits, bench))? {
            Ok(chosen) => return Ok(chosen),
            Err(other) => why = later(why, other),
        }
    }
    if valley.lie != Lie::Face && only.is_none() {
        for tool in noses(valley, bench)? {
            if let Ok(chosen) = Refusal::split(by_nose(site, surface, valley, tool, limits, bench))? {
                return Ok(chosen);
            }
        }
    }
    not(why)
}

/// Of two reasons, that of the tool that passed more checks: narrower blades are tried later, and that even they are
/// too wide says more.
fn later(one: NoJob, other: NoJob) -> NoJob {
    match (&one, &other) {
        (NoJob::TooNarrow { .. } | NoJob::NoTool { .. }, _) => other,
        (_, NoJob::TooNarrow { .. }) | (NoJob::Overloaded { .. }, NoJob::TooDeep { .. }) => one,
        _ => other,
    }
}

/// The blades for a groove in the order of trial.
fn blades<'k>(
    surface: &Surface,
    valley: &Valley,
    bench: &Bench<'_, 'k>,
) -> Result<Vec<TurningTool<'k>>, KnowledgeError> {
    let (kind, works) = match valley.lie {
        Lie::Outside => (ToolKind::Grooving, Place::Outer),
        Lie::Inside => (ToolKind::Grooving, Place::Inner),
        Lie::Face => (ToolKind::FaceGrooving, Place::Face),
    };
    let mut tools = bench.tools(kind, works)?;
    tools.retain(|tool| tool.width.is_some());
    let at_once = |tool: &TurningTool<'_>| {
        let room = edge(tool).and_then(|edge| valley.centres(edge.corner).map(|way| edge.room(&way)));
        room.is_some_and(|room| room < 0.002)
    };
    tools.sort_by_key(|tool| {
        let (width, at_once) = (tool.width.unwrap_or_default(), at_once(tool));
        let exact = surface.grade.is_some() && at_once;
        (exact, tool.own_width && !at_once, std::cmp::Reverse(width), tool.hand == Hand::L)
    });
    Ok(tools)
}

/// The turning tools whose edges clear the walls: φ1 behind the tip on the way down, φ on the way up.
fn noses<'k>(valley: &Valley, bench: &Bench<'_, 'k>) -> Result<Vec<TurningTool<'k>>, KnowledgeError> {
    let (kind, works) = match valley.lie {
        Lie::Outside => (ToolKind::Turning, Place::Outer),
        _ => (ToolKind::Boring, Place::Inner),
    };
    let (fall, rise) = valley.steepest();
    let mut tools = bench.tools(kind, works)?;
    tools.retain(|tool| tool.hand == Hand::R && tool.insert.is_some());
    // Rounded ends of pieces may be inclined a little more than in the drawing.
    tools.retain(|tool| tool.trail_angle.to_f64() + 0.06 >= fall && tool.lead_angle.to_f64() + 0.06 >= rise);
    tools.sort_by_key(|tool| tool.nose_radius);
    Ok(tools)
}

/// The edge of a tool.
fn edge(tool: &TurningTool<'_>) -> Option<CuttingEdge> {
    let corner = tool.nose_radius?.to_mm();
    Some(CuttingEdge { width: tool.width.map_or(2.0 * corner, Micrometres::to_mm), corner })
}

/// That the edge makes the walls of a groove, and not only the rounds at their feet.
fn makes_walls(surface: &Surface, valley: &Valley, edge: CuttingEdge) -> Tried<(), NoJob> {
    let depth = valley.depth();
    if valley.rounded_off(edge.corner) > depth {
        return not(NoJob::TooRound { surface: surface.name.clone(), corner: Half::from(edge.corner), depth });
    }
    Ok(())
}

fn by_blade<'k>(
    site: Site<'_>,
    surface: &Surface,
    valley: &Valley,
    tool: TurningTool<'k>,
    limits: &mut Limits<'k>,
    bench: &Bench<'_, 'k>,
) -> Tried<Chosen<'k>, NoJob> {
    let name = || surface.name.clone();
    let (Some(edge), Some(width)) = (edge(&tool), tool.width) else { return not(NoJob::NoTool { surface: name() }) };
    enters(site, surface, valley, &tool, bench)?;
    makes_walls(surface, valley, edge)?;
    let mut division = division(Half::from(edge.corner), limits, bench.knowledge)?;
    division.approach = division.approach.min(play(site, valley, &tool));
    // The deepest layer that may still be fed sideways as fast as the width of the blade allows.
    let (load, share) = (limits.ratio(JobLimit::SideLoad)?, limits.ratio(JobLimit::SideFeed)?);
    let layer = load * edge.width / share;
    division.layer = Some(layer);
    let Some(ways) = ways::blade(valley, edge, division) else {
        let room = valley.centres(edge.corner).map_or(0.0, |way| edge.room(&way));
        return not(NoJob::TooNarrow { surface: name(), room: Half::from((edge.width + room).max(0.0)), width });
    };
    let deep = deep(site, valley, &tool, &ways);
    if let Some(reach) = tool.groove_depth.filter(|reach| Half::of(*reach) < deep) {
        return not(NoJob::TooDeep { surface: name(), depth: deep, reach });
    }
    let (direction, diameter) = match valley.lie {
        Lie::Face => (Direction::Longitudinal, widest(valley)),
        Lie::Outside => (Direction::Transverse, valley.mouth.diameter()),
        // The floor is the widest place of a groove in a bore.
        Lie::Inside => (Direction::Transverse, (Half::ZERO - valley.floor).diameter()),
    };
    let held = reaching(&tool, valley, division.approach);
    let cut = site::cut(&held, diameter, direction, bench)?;
    let Pace { rpm, plunge, force, blade, mut because } = pace(&cut, width, valley, limits, bench)?;
    if let Some(force) = force.filter(|_| valley.lie == Lie::Outside) {
        because.extend(bears(valley, &tool, width, force, bench)?);
    }
    let along = along_walls(&cut, surface, width, plunge, limits)?;
    because.insert(0, taken(&tool));
    // A layer loads the blade no more than a plunge does.
    let sideways = MillimetresPerRev(round_to((share * edge.width).min(plunge.0 * edge.width / layer), 4));
    let feeds = Feeds { finish: along, cut: sideways, semi_finish: along, ..Feeds::all(plunge) };
    Ok(Chosen { ways, speed: Speed::Spindle(rpm), feeds, because, by_nose: false, blade, tool })
}

/// That the floor of a groove bears the plunge of its blade, which no other law sees: the part is calculated without its grooves. Only
/// solid ones are: a bore makes the wall a ring.
fn bears(
    valley: &Valley,
    tool: &TurningTool<'_>,
    width: Micrometres,
    force: Newtons,
    bench: &Bench<'_, '_>,
) -> Tried<Option<Because>, NoJob> {
    let (Some(held), None) = (&bench.held, &bench.workpiece.inner) else { return Ok(None) };
    let ends = valley.pieces.iter().flat_map(|piece| [piece.from.z, piece.to.z]);
    let (Some(from), Some(to)) = (ends.clone().min(), ends.max()) else { return Ok(None) };
    let half = width.to_mm() / 2.0;
    let lever = ((to - from).to_mm() - half).max(half);
    let floor = valley.floor.diameter();
    let Some((most, because)) = floor_bears(floor, lever, held.is_alone(), &bench.material, bench.knowledge)? else {
        return Ok(None);
    };
    if force.0 > most.0 {
        return not(NoJob::Overloaded { tool: tool.designation.to_owned(), bound: Bound::PartStrength });
    }
    Ok(Some(because))
}

fn by_nose<'k>(
    site: Site<'_>,
    surface: &Surface,
    valley: &Valley,
    tool: TurningTool<'k>,
    limits: &mut Limits<'k>,
    bench: &Bench<'_, 'k>,
) -> Tried<Chosen<'k>, NoJob> {
    let name = || surface.name.clone();
    let Some(edge) = edge(&tool) else { return not(NoJob::NoTool { surface: name() }) };
    let most = limits.length(JobLimit::GrooveFinishDepth)?;
    if valley.depth() > Half::of(most) {
        return not(NoJob::TooDeep { surface: name(), depth: valley.depth(), reach: most });
    }
    enters(site, surface, valley, &tool, bench)?;
    // An upright wall is that of a shoulder here, which goes on above the relief.
    if !valley.is_upright() {
        makes_walls(surface, valley, edge)?;
    }
    let mut division = division(Half::from(edge.corner), limits, bench.knowledge)?;
    division.approach = division.approach.min(play(site, valley, &tool));
    let Some(ways) = ways::nose(valley, edge, division) else {
        let width = Micrometres::from_mm_rounded(edge.width);
        return not(NoJob::TooNarrow { surface: name(), room: Half::ZERO, width });
    };
    let diameter = if valley.lie == Lie::Inside { Half::ZERO - valley.floor } else { valley.mouth }.diameter();
    let held = reaching(&tool, valley, division.approach);
    let cut = site::cut(&held, diameter, Direction::Longitudinal, bench)?;
    let found = conditions(&cut, valley.depth().rounded_up(), surface.roughness).map_err(of_cutting)?;
    if let Some(bound) = found.exceeded.first() {
        return not(NoJob::Overloaded { tool: tool.designation.to_owned(), bound: *bound });
    }
    let mut because = vec![taken(&tool)];
    because.extend(found.because);
    let (speed, feeds) = (Speed::Spindle(found.spindle_rpm), Feeds::all(found.feed_mm_per_rev));
    Ok(Chosen { ways, speed, feeds, because, by_nose: true, blade: None, tool })
}

fn of_cutting(refusal: Refusal<CuttingRefusal>) -> Refusal<NoJob> {
    refusal.map(NoJob::Cutting)
}

/// The required length of the blade: from the floor to the highest metal beside it within reach of its holder. The
/// shank of a right-hand tool is towards the free end, that of a left-hand one towards the chuck; a bar passes all
/// the metal before the groove.
fn deep(site: Site<'_>, valley: &Valley, tool: &TurningTool<'_>, ways: &Ways) -> Half {
    if valley.lie == Lie::Face {
        return valley.depth();
    }
    let (mut from, mut to) = (Half::new(i64::MAX), Half::new(i64::MIN));
    for one in &ways.path.moves {
        (from, to) = (from.min(one.to.z), to.max(one.to.z));
    }
    from = from - Half::of(tool.width.unwrap_or_default());
    match (tool.shank, tool.hand) {
        (Some(Shank::Square { width, .. }), Hand::L) => to = to + Half::of(width),
        (Some(Shank::Square { width, .. }), _) => from = from - Half::of(width),
        // As far as the bar extends towards the free end.
        _ => from = Half::new(i64::MIN / 4),
    }
    // A shoulder at the wall itself does not stand in the way of the blade.
    (from, to) = (from + Half::new(1), to - Half::new(1));
    let heights = site.profile.surfaces.iter().flat_map(|surface| &surface.pieces).flat_map(|piece| {
        let piece = valley.lie.piece(*piece);
        piece.extremes().into_iter().chain(piece.at_z(from)).chain(piece.at_z(to)).collect::<Vec<_>>()
    });
    let beside = heights.filter(|at| at.z >= from && at.z <= to).map(|at| at.radius);
    beside.max().map_or(valley.mouth, |high| high.max(valley.mouth)) - valley.floor
}

/// The outer diameter of a groove in a face.
fn widest(valley: &Valley) -> Micrometres {
    valley.pieces.first().map_or(Micrometres::ZERO, |piece| (Half::ZERO - piece.from.z).diameter())
}

/// Whether a bar enters the bore and reaches the groove, and a curved blade the face.
fn enters(
    site: Site<'_>,
    surface: &Surface,
    valley: &Valley,
    tool: &TurningTool<'_>,
    bench: &Bench<'_, '_>,
) -> Tried<(), NoJob> {
    let name = || surface.name.clone();
    let end = valley.end();
    match valley.lie {
        Lie::Outside => {}
        Lie::Inside => {
            let bore = site.narrowest(end);
            if let Some(least) = tool.min_bore.filter(|least| bore < *least) {
                return not(NoJob::BoreTooSmall { surface: name(), bore, least });
            }
            if let Some((reach, _)) = site::bar_reach(tool, bench)?
                && end > reach
            {
                return not(NoJob::BarTooShort { surface: name(), depth: end, reach });
            }
        }
        Lie::Face => {
            let diameter = widest(valley);
            if let Some(least) = tool.face_diameter.filter(|least| diameter < *least) {
                return not(NoJob::FaceTooSmall { surface: name(), diameter, least });
            }
        }
    }
    Ok(())
}

/// A bar is clamped as short as the groove permits.
fn reaching<'k>(tool: &TurningTool<'k>, valley: &Valley, approach: Half) -> TurningTool<'k> {
    let end = valley.end();
    let inside = valley.lie == Lie::Inside && tool.reach.is_none();
    TurningTool { reach: if inside { Some((end + approach).rounded_up()) } else { tool.reach }, ..tool.clone() }
}

/// The retract of a tool in a bore from its wall: half of the clearance of the bar, so that the bar does not touch
/// the other side. Outside without a limit.
pub(super) fn play(site: Site<'_>, valley: &Valley, tool: &TurningTool<'_>) -> Half {
    /// Enough to leave the wall.
    const LEAST: Half = Half::new(400);
    let end = valley.end();
    match (valley.lie, tool.min_bore) {
        (Lie::Inside, Some(least)) => Half::radius_of(site.narrowest(end) - least).max(LEAST),
        _ => Half::new(i64::MAX / 4),
    }
}

/// Spindle speed and feed of a plunging blade.
pub(in super::super) struct Pace {
    pub rpm: RevsPerMinute,
    pub plunge: MillimetresPerRev,
    /// What the blade presses with, Pz and Py together; none where its figures are not known.
    pub force: Option<Newtons>,
    /// The same at the feed that is used, by its directions.
    pub blade: Option<BladeForce>,
    pub because: Vec<Because>,
}

/// By the handbook, limited by the feed of the blade's maker; only by the maker if the handbook has no figures for
/// the material. Slower in a bore and in a face.
fn pace(
    cut: &TurningCut<'_, '_>,
    width: Micrometres,
    valley: &Valley,
    limits: &mut Limits<'_>,
    bench: &Bench<'_, '_>,
) -> Tried<Pace, NoJob> {
    let first = valley.pieces.iter().map(|piece| piece.from.z).min().unwrap_or_default();
    let jaws = bench.grip.as_ref().filter(|_| valley.lie == Lie::Outside).map(|grip| (grip, first.max(Half::ZERO)));
    let mut pace = blade_pace(cut, width, jaws)?;
    if valley.lie != Lie::Outside {
        let share = limits.ratio(JobLimit::InnerGroovingSpeed)?;
        pace.rpm = cut.lathe.spindle.at_most(RevsPerMinute(pace.rpm.0 * share));
    }
    Ok(pace)
}

/// The same without the factor for bore and face; used for parting too. Jaws are given with the Z of the blade outside: where they do not
/// hold it, its feed is less, in hundredths of a millimetre, down to the least of its maker.
pub(in super::super) fn blade_pace(
    cut: &TurningCut<'_, '_>,
    width: Micrometres,
    jaws: Option<(&GripLimit, Half)>,
) -> Tried<Pace, NoJob> {
    let (knowledge, material_group) = (cut.knowledge, cut.material.group);
    let asked = knowledge.ask(&GroovingPracticeFor { material_group, width })?;
    let Some(maker) = asked.winner()? else {
        return Err(no_figure(Operation::Grooving, GroovingPracticeFor::TABLE, cut));
    };
    let note = Note::new("grooving-practice").with("feed-min", maker.feed_min.0).with("feed-max", maker.feed_max.0);
    let mut because = vec![Because::answer(&asked.answer, note.with("speed", maker.speed_min.0).with("width", width))];
    let diameter = cut.diameter;
    let has_speed = knowledge.ask(&GroovingSpeedFor { material_group })?.winner()?.is_some();
    let has_feed = figures_of(&GroovingFeedFor { material_group, diameter }, cut)?;
    if has_speed && has_feed {
        let found = conditions(cut, width, None).map_err(of_cutting)?;
        if let Some(bound) = found.exceeded.first() {
            return not(NoJob::Overloaded { tool: cut.tool.designation.to_owned(), bound: *bound });
        }
        because.extend(found.because);
        let plunge = MillimetresPerRev(found.feed_mm_per_rev.0.min(maker.feed_max.0));
        let both = found.main_force_n.zip(found.radial_force_n);
        let force = both.map(|(main, radial)| Newtons(libm::hypot(main.0, radial.0)));
        let (rpm, plunge, blade) =
            within_jaws(cut, width, (found.spindle_rpm, plunge), maker.feed_min, jaws, &mut because)?;
        return Ok(Pace { rpm, plunge, force, blade, because });
    }
    let rpm = cut.lathe.spindle.at_most(rpm_at(maker.speed_min, diameter)).rounded(2);
    let (_, most) = if cut.direction == Direction::Transverse { cut.lathe.feed_x } else { cut.lathe.feed_z };
    let plunge = MillimetresPerRev(maker.feed_min.0.min(most.0 / rpm.0));
    let (rpm, plunge, blade) = within_jaws(cut, width, (rpm, plunge), maker.feed_min, jaws, &mut because)?;
    Ok(Pace { rpm, plunge, force: None, blade, because })
}

/// The spindle speed and the feed at which jaws hold a blade, and its forces there: first it turns slower, down to half, because the speed
/// takes force off the jaws; then it is fed less, too. Where they do not hold it even so, both stay as they are.
fn within_jaws(
    cut: &TurningCut<'_, '_>,
    width: Micrometres,
    (wanted, plunge): (RevsPerMinute, MillimetresPerRev),
    least: MillimetresPerRev,
    jaws: Option<(&GripLimit, Half)>,
    because: &mut Vec<Because>,
) -> Result<(RevsPerMinute, MillimetresPerRev, Option<BladeForce>), KnowledgeError> {
    let usual = blade_force(cut, width, plunge, wanted)?;
    let (Some((grip, z)), Some(_)) = (jaws, usual) else { return Ok((wanted, plunge, usual)) };
    let mut feed = plunge;
    while feed.0 >= least.0.min(plunge.0) {
        for slower in (0..=5).map(|tenths| 1.0 - 0.1 * f64::from(tenths)) {
            let rpm = cut.lathe.spindle.at_most(RevsPerMinute(wanted.0 * slower)).rounded(2);
            let Some(blade) = blade_force(cut, width, feed, rpm)?.filter(|blade| grip.holds(*blade, z, rpm)) else {
                continue;
            };
            let note = Note::new("feed-within-jaws").with("feed", feed.0).with("before", plunge.0);
            let row = grip.because.last().filter(|_| rpm.0 < wanted.0 || feed.0 < plunge.0);
            because.extend(row.map(|one| Because { note: note.with("rpm", rpm.0), ..one.clone() }));
            return Ok((rpm, feed, Some(blade)));
        }
        feed = MillimetresPerRev(((feed.0 - 0.01) * 100.0).round() / 100.0);
    }
    Ok((wanted, plunge, usual))
}

/// Whether a table has figures for the material itself.
fn figures_of<Q: Question>(question: &Q, cut: &TurningCut<'_, '_>) -> Result<bool, KnowledgeError> {
    Ok(technolog_cutting::figures::within_reach(question, cut.knowledge)?.is_some())
}

/// The feed along walls and floor: at most a share of the blade's width, the sideways limit of the blade and that of
/// the roughness, and never above the feed of plunging.
fn along_walls(
    cut: &TurningCut<'_, '_>,
    surface: &Surface,
    width: Micrometres,
    plunge: MillimetresPerRev,
    limits: &mut Limits<'_>,
) -> Tried<MillimetresPerRev, NoJob> {
    let share = limits.ratio(JobLimit::SideFeed)? * width.to_mm();
    let load = limits.ratio(JobLimit::SideLoad)? * width.to_mm() * width.to_mm();
    let deepest = limits.length(JobLimit::GrooveFinishDepth)?.to_mm();
    let mut feed = plunge.0.min(share).min(load / deepest);
    if let Some(roughness) = surface.roughness
        && let Ok(finish) = Refusal::split(finish_feed(cut, roughness))?
    {
        feed = feed.min(finish.feed.0);
        limits.because.extend(finish.because);
    }
    Ok(MillimetresPerRev(round_to(feed, 4)))
}
