//! A finishing pass: its tool, and for each stretch of it the feed that its own roughness, nose and stiffness allow.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Figure, Finding, IntoFigure, Note, Severity};
use crate::tables::turning::jobs::JobLimit;
use crate::turning::allowances::finishing::Allowance;
use crate::turning::contour::{Contour, Piece, Side, Surface, SurfaceName};
use crate::turning::cutting::{
    Bound, Direction, Flexibility, TurningConditions, least_sensible_depth, unsaid_roughness, wall_share,
};
use crate::turning::elements::steepness;
use crate::turning::jobs::along::Clearance;
use crate::turning::jobs::limits::Limits;
use crate::turning::jobs::{Body, Job, JobTool, Pace, UNKNOWN_EDGE, Work as JobWork};
use crate::turning::length::Half;
use crate::turning::nose::{tightest, up_to};
use crate::turning::point::Point;
use crate::turning::tooling::{Spindle, TurningTool};
use crate::turning::toolpath::Toolpath;
use crate::turning::zones::Needs;
use crate::turning::zones::fit::reaches;
use crate::units::{Degrees, Micrometres, MillimetresPerRev, RevsPerMinute, Roughness, round_to};
use technolog_core::part::tolerance_width;

use super::depth::{self, ZoneCut};
use super::feeds::{OwnFeed, with_feeds};
use super::jobs::{constant_speed, pace_of};
use super::layers::Layers;
use super::tools::{self, Bench};
use super::{Sized, Stage};

/// The largest finishing allowance of the surfaces of a pass; for a far face alone, which is no surface of the
/// set-up, the one over it. If none of them is known, the largest of the side; where that has none, as its surfaces stay as the blank
/// has them, the one over its face.
pub(super) fn allowance(layers: &Layers, surfaces: &[&Surface]) -> Half {
    let start = |contour: &Contour| contour.start().map_or(Half::ZERO, |start| start.z);
    let over_face = start(&layers.left) - start(&layers.rough);
    let known = layers.allowances.iter().filter_map(|one| Some((&one.surface, one.allowance_mm?)));
    let own = known.clone().filter(|(name, _)| surfaces.iter().any(|surface| surface.name == **name));
    let of_side = || known.map(|one| one.1).max().filter(|most| *most > Half::ZERO);
    own.map(|one| one.1).max().or_else(of_side).unwrap_or(over_face)
}

/// The task of a finishing pass.
pub(super) struct Finishing<'a> {
    pub side: Side,
    /// The contour after it.
    pub contour: &'a Contour,
    /// The contour before it.
    pub standing: &'a Contour,
    /// The surfaces that it finishes.
    pub surfaces: Vec<&'a Surface>,
    /// The largest stock that it removes.
    pub allowance: Half,
    /// The stock of each surface.
    pub allowances: &'a [Allowance],
    pub needs: Needs,
}

/// Surfaces of a pass that ask for the same.
struct Stretch<'a> {
    surfaces: Vec<&'a Surface>,
    roughness: Roughness,
    /// The rule of a roughness that the drawing does not give.
    unsaid: Option<Because>,
    /// The tolerance of their diameters.
    tolerance: Option<Micrometres>,
    direction: Direction,
    /// The stock over them.
    depth: Half,
    /// Their range of Z.
    from: Half,
    to: Half,
}

impl Stretch<'_> {
    /// The length of its surfaces along the contour, mm.
    fn length_mm(&self) -> f64 {
        self.surfaces.iter().flat_map(|surface| &surface.pieces).map(|piece| piece.length_mm()).sum()
    }

    fn asks_as(&self, other: &Self) -> bool {
        let of = |one: &Self| (one.roughness, one.tolerance, one.direction == Direction::Longitudinal);
        of(self) == of(other)
    }
}

/// A tool with its conditions over each stretch; none where the tables have none.
struct Cut<'k> {
    tool: TurningTool<'k>,
    conditions: Vec<Option<TurningConditions>>,
    findings: Vec<Finding>,
    /// The tool that it is taken instead of, because that one presses the part away.
    instead_of: Option<&'k str>,
}

impl Cut<'_> {
    /// Fewer bounds exceeded, then less time at feed.
    fn is_better_than(&self, other: &Self, stretches: &[Stretch<'_>]) -> bool {
        let merit = |cut: &Self| {
            let known = cut.conditions.iter().flatten();
            let exceeded: usize = known.clone().map(|one| one.exceeded.len()).sum();
            let rpm = slowest(&cut.conditions).map_or(0.0, |rpm| rpm.0);
            let times = stretches.iter().zip(&cut.conditions).map(|(stretch, one)| match one {
                Some(one) => stretch.length_mm() / (one.feed_mm_per_rev.0 * rpm),
                None => f64::INFINITY,
            });
            (exceeded, times.sum::<f64>())
        };
        let (own, others) = (merit(self), merit(other));
        own.0.cmp(&others.0).then(own.1.total_cmp(&others.1)).is_lt()
    }
}

impl<'a> Finishing<'a> {
    /// Its tool: the first that reaches everything; a nose that fits into the hollows is preferred to one that leaves
    /// metal in them.
    pub fn tool<'k>(&self, bench: &Bench<'_, 'k>) -> Result<Option<TurningTool<'k>>, KnowledgeError> {
        Ok(self.tools(bench)?.into_iter().next())
    }

    /// The tools that reach everything and fit into the hollows, in order; if none fits, the one with the smallest nose.
    fn tools<'k>(&self, bench: &Bench<'_, 'k>) -> Result<Vec<TurningTool<'k>>, KnowledgeError> {
        let passage = narrowest(self.contour);
        let candidates = tools::candidates(self.side, Stage::Finishing, bench)?;
        let mut fitting = Vec::new();
        for tool in candidates {
            if reaches(self.needs, passage, &tools::angles(&tool, bench.knowledge)?) {
                fitting.push(tool);
            }
        }
        // A bar that faces a bottom as far as it must goes before one that leaves the middle of it.
        let bottom = self.contour.pieces.last().filter(|last| last.is_face()).map(|last| last.to.radius);
        if let (Some(bore), Some(bottom)) = (passage, bottom) {
            let stops = |tool: &TurningTool<'_>| tools::nearest_to_axis(tool, Half::radius_of(bore)).max(Some(bottom));
            let nearest = fitting.iter().map(stops).min();
            fitting.retain(|tool| Some(stops(tool)) == nearest);
        }
        let mut candidates = match self.side {
            Side::Inner => {
                tools::reaching(fitting, self.contour.end().map_or(Half::ZERO, |end| end.z), bench.knowledge)?
            }
            Side::Outer => fitting,
        };
        let tight = tightest(self.contour);
        let fits = |tool: &TurningTool<'_>| tight.is_none_or(|tight| tools::nose(tool).radius <= tight);
        let least = candidates.iter().map(|tool| tools::nose(tool).radius).min();
        if candidates.iter().any(fits) {
            candidates.retain(fits);
        } else {
            candidates.retain(|tool| Some(tools::nose(tool).radius) == least);
        }
        Ok(candidates)
    }

    /// The tool with its conditions over each stretch. Where the part gives way and the first one must therefore be fed slower
    /// than the roughness asks, another that presses less is taken if it takes less time.
    fn cut<'k>(&self, stretches: &[Stretch<'a>], bench: &Bench<'_, 'k>) -> Result<Option<Cut<'k>>, KnowledgeError> {
        let mut tools = self.tools(bench)?.into_iter();
        let Some(first) = tools.next() else { return Ok(None) };
        let mut best = self.cut_with(first, stretches, bench)?;
        if self.side == Side::Inner || !self.gives_way(&best, stretches, bench)? {
            return Ok(Some(best));
        }
        let usual = best.tool.designation;
        for tool in tools {
            let cut = self.cut_with(tool, stretches, bench)?;
            if cut.is_better_than(&best, stretches) {
                best = cut;
            }
        }
        best.instead_of = Some(usual).filter(|usual| *usual != best.tool.designation);
        Ok(Some(best))
    }

    fn cut_with<'k>(
        &self,
        tool: TurningTool<'k>,
        stretches: &[Stretch<'a>],
        bench: &Bench<'_, 'k>,
    ) -> Result<Cut<'k>, KnowledgeError> {
        let part = |stretch: &Stretch<'_>| {
            bench.held.as_ref().map(|held| held.over(stretch.from, stretch.to, stretch.tolerance))
        };
        let all = |most| {
            let (mut conditions, mut findings) = (Vec::new(), Vec::new());
            for stretch in stretches {
                let part = part(stretch);
                conditions.push(self.conditions(stretch, &tool, part.as_ref(), most, bench, &mut findings)?);
            }
            Ok::<_, KnowledgeError>((conditions, findings))
        };
        let (mut conditions, mut findings) = all(None)?;
        // One spindle for the whole pass: the slowest that a stretch asks for. A slower cut presses harder.
        if let Some(slowest) = slowest(&conditions)
            .filter(|slowest| conditions.iter().flatten().any(|one: &TurningConditions| one.spindle_rpm.0 > slowest.0))
        {
            (conditions, findings) = all(Some(slowest))?;
        }
        Ok(Cut { tool, conditions, findings, instead_of: None })
    }

    /// Whether the bending of the part slows the feed of a stretch, or is too large at any feed.
    fn gives_way(
        &self,
        cut: &Cut<'_>,
        stretches: &[Stretch<'a>],
        bench: &Bench<'_, '_>,
    ) -> Result<bool, KnowledgeError> {
        for (stretch, conditions) in stretches.iter().zip(&cut.conditions) {
            let Some(conditions) = conditions else { continue };
            let stiff = self.conditions(stretch, &cut.tool, None, None, bench, &mut Vec::new())?;
            let slower = stiff.is_some_and(|stiff| conditions.feed_mm_per_rev.0 < stiff.feed_mm_per_rev.0);
            if slower || conditions.exceeded.contains(&Bound::PartStiffness) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The job; `make_path` makes its toolpath from the contours after and before, both as the nose meets them.
    pub fn job(
        &self,
        bench: &Bench<'_, '_>,
        findings: &mut Vec<Finding>,
        make_path: impl FnOnce(&Contour, &Contour, Clearance) -> Option<Toolpath>,
    ) -> Result<Option<Job>, KnowledgeError> {
        let stretches = self.stretches(bench)?;
        let Some(cut) = self.cut(&stretches, bench)? else {
            let note = Note::new("no-tool-to-finish").with("side", self.side.name());
            let angle = |degrees: Degrees| round_to(degrees.0, 1);
            let note = note.with("main", angle(self.needs.main)).with("secondary", angle(self.needs.secondary));
            findings.push(Finding::of_part(Severity::Wrong, note));
            return Ok(None);
        };
        let tool = cut.tool;
        let nose = tools::nose(&tool);
        let seen = nose.finished(self.contour).and_then(|contour| Ok((contour, nose.seen(self.standing)?)));
        let (seen, standing) = match seen {
            Ok((seen, standing)) => {
                let bore =
                    narrowest(self.contour).and_then(|bore| tools::nearest_to_axis(&tool, Half::radius_of(bore)));
                (up_to(seen, bore), standing)
            }
            Err(error) => {
                let note = Note::new("no-contour-of-nose").with("tool", tool.designation).with("why", error);
                findings.push(Finding::of_part(Severity::Wrong, note));
                return Ok(None);
            }
        };
        findings.extend(cut.findings);
        let mut because: Vec<Because> = Vec::new();
        for one in stretches.iter().filter_map(|stretch| stretch.unsaid.as_ref()) {
            if !because.contains(one) {
                because.push(one.clone());
            }
        }
        let cuts: Vec<_> = stretches.iter().zip(cut.conditions).collect();
        // The spindle is one; what is told of the pass is its heaviest stretch.
        let known = cuts.iter().all(|(_, conditions)| conditions.is_some());
        let heaviest = cuts.iter().filter_map(|(_, conditions)| conditions.as_ref());
        let heaviest = heaviest.min_by(|one, other| {
            let by_speed = one.spindle_rpm.0.total_cmp(&other.spindle_rpm.0);
            by_speed.then(other.feed_mm_per_rev.0.total_cmp(&one.feed_mm_per_rev.0))
        });
        let conditions = heaviest.filter(|_| known).cloned();
        let direction = Direction::Longitudinal;
        let paced = depth::with_rates(direction, conditions, bench, findings)?;
        let mut notes = Vec::new();
        if let Some(usual) = cut.instead_of {
            notes.push(Note::new("finish-tool-presses-less").with("tool", tool.designation).with("instead", usual));
        }
        notes.extend(self.one_speed(paced.conditions.as_ref(), bench)?);
        if let Some(tight) = tightest(self.contour).filter(|tight| nose.radius > *tight) {
            notes.push(Note::new("nose-fills-hollow").with("nose", nose.radius).with("hollow", tight));
        }
        let made = JobTool::of(&tool);
        let wall = wall(&made, bench.knowledge)?;
        // Before the pass the wall on the other side stands nearer by the allowance.
        let nearest = narrowest(self.standing).and_then(|bore| tools::nearest_to_axis(&tool, Half::radius_of(bore)));
        let nearest = nearest.unwrap_or_default().max(Half::ZERO);
        let clearance = Clearance { approach: paced.approach_mm, retract: paced.retract_mm, wall, nearest };
        let Some(mut path) = make_path(&seen, &standing, clearance) else { return Ok(None) };
        let pace = finishing(pace_of(&paced, bench), bench);
        let pace = constant_speed(pace, paced.conditions.as_ref(), bench);
        if let Some(base) = pace.feeds() {
            let own = cuts.iter().filter_map(|(stretch, conditions)| {
                let feed = conditions.as_ref()?.feed_mm_per_rev;
                Some((*stretch, feed))
            });
            let own: Vec<_> = own.collect();
            if own.iter().any(|(_, feed)| *feed != base.finish) {
                let feeds = own.iter().flat_map(|(stretch, feed)| {
                    stretch.surfaces.iter().map(|surface| OwnFeed { pieces: &surface.pieces, feed: *feed })
                });
                path = with_feeds(&path, &feeds.collect::<Vec<_>>(), nose, base.finish);
                notes.extend(told(&own));
            }
        }
        let chosen = tools::chosen(&tool, 1, bench)?;
        because.extend([chosen.because, chosen.because_order]);
        Ok(Some(Job {
            surfaces: self.surfaces.iter().map(|surface| surface.name.clone()).collect::<Vec<SurfaceName>>(),
            conditions: paced.conditions.clone(),
            notes,
            because,
            ..Job::of(JobWork::Finish, self.side, made, path, pace, paced.feeds.rapid)
        }))
    }

    /// That a spindle of steps keeps the speed of the largest diameter of the pass: a step that is changed in the cut marks the
    /// surface. Told where its smallest cylinder would be cut faster by the share that other passes hold the cutting speed for.
    fn one_speed(
        &self,
        conditions: Option<&TurningConditions>,
        bench: &Bench<'_, '_>,
    ) -> Result<Option<Note>, KnowledgeError> {
        let stepped = bench.lathe.map(|lathe| &lathe.spindle).filter(|spindle| matches!(spindle, Spindle::Steps(_)));
        let (Some(spindle), Some(conditions)) = (stepped, conditions) else { return Ok(None) };
        let pieces = self.surfaces.iter().flat_map(|surface| &surface.pieces).filter(|piece| piece.is_cylinder());
        let Some(least) = pieces.map(|piece| piece.from.radius.diameter()).min() else { return Ok(None) };
        let (most, rpm) = (largest(self.contour), conditions.spindle_rpm);
        let ratio = most.to_mm() / least.to_mm();
        let own = spindle.at_most(RevsPerMinute(rpm.0 * ratio));
        let told = ratio >= Limits::of(bench.knowledge).ratio(JobLimit::ConstantSpeedRatio)? && own.0 > rpm.0;
        let note = || {
            let speed = technolog_cutting::speed_at(rpm, least);
            Note::new("finish-one-speed")
                .with("diameter", most)
                .with("rpm", rpm.0)
                .with("least", least)
                .with("own", own.0)
                .with("speed", round_to(speed.0, 1))
        };
        Ok(told.then(note))
    }

    /// The conditions of a stretch, at the largest diameter of the whole pass.
    fn conditions(
        &self,
        stretch: &Stretch<'_>,
        tool: &TurningTool<'_>,
        part: Option<&Flexibility>,
        spindle_most: Option<RevsPerMinute>,
        bench: &Bench<'_, '_>,
        findings: &mut Vec<Finding>,
    ) -> Result<Option<TurningConditions>, KnowledgeError> {
        let bore_depth = (self.side == Side::Inner).then(|| ends(self.contour).1.rounded_up());
        let (diameter, direction, stock) = (largest(self.contour), stretch.direction, stretch.depth);
        let task = ZoneCut { tool, diameter, direction, stock, bore_depth, begins: stretch.from, part, spindle_most };
        depth::found(task, stretch.depth, Some(stretch.roughness), bench, findings)
    }

    /// The surfaces by what they ask for; the whole pass if it makes no surface of the set-up.
    fn stretches(&self, bench: &Bench<'_, '_>) -> Result<Vec<Stretch<'a>>, KnowledgeError> {
        let best = bench.lathe.and_then(|lathe| lathe.best_roughness);
        let within = |asked: Roughness| best.map_or(asked, |best| asked.max(best));
        // Without an allowance the pass takes off only what roughing left standing: thinner than any pass of roughing.
        let whole =
            if self.allowance > Half::ZERO { self.allowance } else { Half::of(least_sensible_depth(bench.knowledge)?) };
        let mut stretches: Vec<Stretch<'a>> = Vec::new();
        for surface in &self.surfaces {
            // Surfaces finished on another machine ask for no roughness here.
            let made = bench.later(&surface.name).is_none();
            let (roughness, unsaid) = match surface.roughness.filter(|_| made) {
                Some(asked) => (asked, None),
                None => {
                    let (unsaid, row) = unsaid_roughness(surface.grade.filter(|_| made), bench.knowledge)?;
                    (unsaid, Some(row))
                }
            };
            let is_face = surface.is_face();
            let radius = surface.pieces.iter().map(|piece| piece.from.radius.max(piece.to.radius)).max();
            let limits = bench.sizes.of_surface(&surface.name).map(Sized::tolerance);
            let tolerance = radius.filter(|_| made && !is_face).and_then(|radius| {
                let by_grade =
                    || surface.grade.and_then(|grade| tolerance_width(grade, radius.diameter(), bench.knowledge).ok());
                limits.or_else(by_grade)
            });
            let own = self.allowances.iter().find(|one| one.surface == surface.name).and_then(|one| one.allowance_mm);
            let z = surface.pieces.iter().flat_map(|piece| [piece.from.z, piece.to.z]);
            let one = Stretch {
                surfaces: vec![surface],
                roughness: within(roughness),
                unsaid,
                tolerance,
                direction: if is_face { Direction::Transverse } else { Direction::Longitudinal },
                depth: own.filter(|own| *own > Half::ZERO).unwrap_or(whole),
                from: z.clone().min().unwrap_or_default(),
                to: z.max().unwrap_or_default(),
            };
            match stretches.iter_mut().find(|known| known.asks_as(&one)) {
                Some(known) => {
                    known.surfaces.extend(one.surfaces);
                    (known.from, known.to) = (known.from.min(one.from), known.to.max(one.to));
                    known.depth = known.depth.max(one.depth);
                    known.unsaid = known.unsaid.take().or(one.unsaid);
                }
                None => stretches.push(one),
            }
        }
        if stretches.is_empty() {
            let (unsaid, row) = unsaid_roughness(None, bench.knowledge)?;
            let (from, to) = ends(self.contour);
            stretches.push(Stretch {
                surfaces: Vec::new(),
                roughness: within(unsaid),
                unsaid: Some(row),
                tolerance: None,
                direction: Direction::Longitudinal,
                depth: whole,
                from,
                to,
            });
        }
        Ok(stretches)
    }
}

/// The slowest spindle of several conditions.
fn slowest(conditions: &[Option<TurningConditions>]) -> Option<RevsPerMinute> {
    let all = conditions.iter().flatten().map(|one| one.spindle_rpm);
    all.min_by(|one, other| one.0.total_cmp(&other.0))
}

/// What each feed of a pass is for; the one of the most surfaces is told as that of the others.
fn told(own: &[(&Stretch<'_>, MillimetresPerRev)]) -> Vec<Note> {
    let mut feeds: Vec<(MillimetresPerRev, Roughness, Vec<Figure>)> = Vec::new();
    for (stretch, feed) in own {
        let names = stretch.surfaces.iter().map(|surface| (&surface.name).into_figure());
        match feeds.iter_mut().find(|one| (one.0, one.1) == (*feed, stretch.roughness)) {
            Some(known) => known.2.extend(names),
            None => feeds.push((*feed, stretch.roughness, names.collect())),
        }
    }
    // A far face is no surface of its set-up: nothing is named for it.
    feeds.retain(|one| !one.2.is_empty());
    let most = feeds.iter().map(|one| one.2.len()).max().unwrap_or_default();
    let others = feeds.iter().position(|one| one.2.len() == most && most > 1).map(|index| feeds.remove(index));
    let note = |code: &'static str, feed: MillimetresPerRev, roughness| {
        Note::new(code).with("feed", feed.0).with("roughness", roughness)
    };
    let named = feeds
        .into_iter()
        .map(|(feed, roughness, names)| note("finish-feed-of", feed, roughness).with("surfaces", Figure::list(names)));
    named.chain(others.map(|(feed, roughness, _)| note("finish-feed-of-others", feed, roughness))).collect()
}

/// The narrowest diameter of a bore. The bottom of a blind one is no passage.
fn narrowest(contour: &Contour) -> Option<Micrometres> {
    contour.narrowest().filter(|_| contour.side == Side::Inner).map(Half::diameter)
}

/// The greatest height of a wall that a tool finishes upwards, so that its holder stays clear of the metal above:
/// `wall-share` of its edge.
fn wall(tool: &JobTool, knowledge: &Knowledge) -> Result<Half, KnowledgeError> {
    let edge = match tool.body {
        Body::Insert { edge_mm, .. } => edge_mm,
        _ => None,
    };
    Ok(Half::from(edge.unwrap_or(UNKNOWN_EDGE).to_mm() * wall_share(knowledge)?))
}

/// The feed of finishing is the main feed of its conditions, or the one in the file.
fn finishing(mut pace: Pace, bench: &Bench<'_, '_>) -> Pace {
    match &mut pace {
        Pace::PerRev { feeds, .. } => feeds.finish = feeds.cut,
        Pace::PerMinute { rates, .. } => {
            if bench.workpiece.rates.is_none_or(|rates| rates.finishing_feed.is_none()) {
                rates.finish = rates.main;
            }
        }
    }
    pace
}

/// Z of the ends of a contour.
fn ends(contour: &Contour) -> (Half, Half) {
    let z = |end: Option<Point>| end.map_or(Half::ZERO, |end| end.z);
    (z(contour.start()), z(contour.end()))
}

/// The largest diameter of a contour.
fn largest(contour: &Contour) -> Micrometres {
    contour.radii().map_or(Half::ZERO, |(_, most)| most).diameter()
}

/// The angles that a contour requires of a tool that follows it. The face at the free end is cut towards the axis,
/// and the main edge must not lean over it.
pub(super) fn needs(contour: &Contour) -> Needs {
    let outer = |piece: &Piece| match contour.side {
        Side::Outer => *piece,
        Side::Inner => piece.inside_out(Half::ZERO),
    };
    let pieces = contour.pieces.iter().map(outer);
    let steepest = pieces.map(steepness).fold((0.0_f64, 0.0_f64), |most, one| (most.0.max(one.0), most.1.max(one.1)));
    Needs { main: Degrees(steepest.0), secondary: Degrees(steepest.1) }
}
