//! Cutting conditions of a transition at a given depth, within the limits of the lathe.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::note::{Because, Finding, Note};
use crate::tables::lathes::LatheQuantity;
use crate::tables::practice::RoughOrFinish;
use crate::tables::turning::tools::Limit;
use crate::turning::tooling::Spindle;
use crate::units::{
    Kilowatts, MetresPerMinute, Micrometres, MillimetresPerMinute, MillimetresPerRev, Minutes, NewtonMetres, Newtons,
    RevsPerMinute, Roughness, round_to,
};
use technolog_cutting::{rpm_at, speed_at};

use super::bounds::{self, Bound, Check, Forces, Load, UnknownBound};
use super::feed::{finish_feed, rough_feed};
use super::laws::Component;
use super::limit::positive;
use super::speed;
use super::{CuttingRefusal, Direction, NonPositive, TurningCut, of_figures};

/// Feed, speed and loads of a transition.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TurningConditions {
    /// The tool.
    pub tool: String,
    /// The lathe's id.
    pub lathe: String,
    /// Depth of cut, mm; for a grooving tool the width of its blade.
    pub depth_mm: Micrometres,
    /// Feed.
    pub feed_mm_per_rev: MillimetresPerRev,
    /// The speed of the tool's life; if there is no formula for the material, the usual speed of practice.
    pub computed_speed_m_per_min: MetresPerMinute,
    /// The speed at the spindle's step.
    pub speed_m_per_min: MetresPerMinute,
    /// The spindle's speed.
    pub spindle_rpm: RevsPerMinute,
    /// The feed rate.
    pub feed_mm_per_min: MillimetresPerMinute,
    /// Tool life at the spindle's step: T·(V/Vstep)^(1/m); absent if there is no formula for the material.
    pub tool_life_min: Option<Minutes>,
    /// Pz; absent if no figures are known.
    pub main_force_n: Option<Newtons>,
    /// Py, perpendicular to the feed, in grooving against it; absent if no figures are known.
    pub radial_force_n: Option<Newtons>,
    /// Px, against the feed; absent in grooving, and if no figures are known.
    pub axial_force_n: Option<Newtons>,
    /// Torque at the largest diameter; absent if no figures are known.
    pub torque_n_m: Option<NewtonMetres>,
    /// Cutting power; absent if no figures are known.
    pub power_kw: Option<Kilowatts>,
    /// The limit that applied: `tool-life`, `practice`, `spindle-speed-max`, `spindle-speed-min`, `spindle-power`,
    /// `feed-max` or `feed-min`.
    pub limited_by: String,
    /// The limits that these conditions exceed: the depth must be reduced.
    pub exceeded: Vec<Bound>,
    /// In finishing, by which share of its tolerance the part gives way, where a second pass mends that; none where it is stiff
    /// enough, and where it is not at all.
    #[serde(skip)]
    pub gives_way: Option<f64>,
    /// The limits that could not be calculated.
    pub missing: Vec<UnknownBound>,
    /// The rows behind the figures.
    pub because: Vec<Because>,
}

impl TurningConditions {
    /// Findings for the reader of the conditions: every limit that could not be calculated.
    pub fn findings(&self) -> Vec<Finding> {
        self.missing.iter().map(UnknownBound::finding).collect()
    }
}

/// Conditions of a cut at a depth. With a roughness the feed is that of finishing, but never above that of roughing.
///
/// The speed is that of the tool life, compared with practice, on the spindle step below it. If the spindle power is
/// not enough, the speed is reduced until it is. Feed rates outside the range of the axis are set to its end. A
/// grooving tool cuts its own width, whatever depth is given.
///
/// # Errors
/// No feed or speed is known; the roughness is finer than the tables or the lathe allow; the depth is not
/// above zero; threads; a broken table.
pub fn conditions(
    cut: &TurningCut<'_, '_>,
    depth: Micrometres,
    roughness: Option<Roughness>,
) -> Tried<TurningConditions, CuttingRefusal> {
    let depth = match (cut.tool.plunges(), cut.tool.width) {
        (true, Some(width)) => width,
        (true, None) => return Err(Refusal::Not(CuttingRefusal::Figure(cut.tool_lacks("width")))),
        (false, _) => depth,
    };
    if depth <= Micrometres::ZERO {
        return Err(Refusal::Not(CuttingRefusal::NothingToCut(NonPositive::Depth(depth))));
    }
    bounds::bar_reaches(cut)?;
    let (mut feed, mut because) = feed_of(cut, depth, roughness)?;
    positive(cut, feed)?;
    let pass = if roughness.is_some() { RoughOrFinish::Finish } else { RoughOrFinish::Rough };
    feed = within_part(cut, depth, feed, pass, &mut because)?;
    let law = of_figures(cut.named(speed::speed(cut, feed, pass)))?;
    because.extend(law.because.iter().cloned());
    let taken = law.at(depth.to_mm(), cut)?;
    because.extend(taken.because.iter().cloned());
    let forces = Forces::of(cut, feed)?;
    let (mut checks, missing) = bounds::checks(cut, &forces)?;
    // A finishing pass is as deep as its allowance, whatever its chips do.
    checks.retain(|check| roughness.is_none() || check.bound != Bound::ChipWidth);
    let wanted = rpm_at(taken.speed, cut.diameter);
    let (mut rpm, mut limited_by) = first_speed(cut, wanted, taken.is_of_practice());
    if let Some(check) = checks.iter().find(|check| check.bound == Bound::SpindlePower)
        && let Some(slower) = within_power(cut, check, &forces, depth, rpm)
    {
        because.extend(check.because.iter().cloned());
        (rpm, limited_by) = (slower, "spindle-power");
    }
    for check in checks.iter().filter(|check| check.is_of_grip()) {
        if let Some(slower) = within_grip(cut, check, &forces, depth, rpm) {
            because.extend(check.because.iter().cloned());
            (rpm, limited_by) = (slower, "grip");
        }
    }
    let ((least, most), (of_least, of_most)) = match cut.direction {
        Direction::Longitudinal => (cut.lathe.feed_z, (LatheQuantity::FeedMinZ, LatheQuantity::FeedMaxZ)),
        Direction::Transverse => (cut.lathe.feed_x, (LatheQuantity::FeedMinX, LatheQuantity::FeedMaxX)),
    };
    let rate = feed.0 * rpm.0;
    let ends = [(rate > most.0, most, "feed-max", of_most), (rate < least.0, least, "feed-min", of_least)];
    for (outside, end, name, quantity) in ends {
        if outside {
            feed = MillimetresPerRev(end.0 / rpm.0);
            limited_by = name;
            because.push(Because::row(cut.lathe.row(quantity)?, Note::new("feed-held").with("limit", end.0)));
        }
    }
    // The feed may have been limited: the loads are those at the feed that is used.
    let forces = Forces::of(cut, feed)?;
    because.extend(forces.because());
    let speed = speed_at(rpm, cut.diameter);
    let exceeded = |check: &&Check| {
        // The speed is already reduced to the power; an excess from rounding does not count.
        check.load(cut, &forces, depth, speed).is_some_and(|load| !load.rounded().within(check.capacity.rounded()))
    };
    let bent = checks.iter().find(|check| check.bound == Bound::PartStiffness && exceeded(check));
    let gives_way = match (bent, cut.part.as_ref().and_then(|part| part.tolerance)) {
        (Some(check), Some(_)) => {
            let (share, _) = bounds::ratio(cut.knowledge, Limit::PartDeflectionShare)?;
            let (most, _) = bounds::ratio(cut.knowledge, Limit::PartDeflectionMost)?;
            let load = check.load(cut, &forces, depth, speed);
            load.and_then(|load| load.over(check.capacity)).map(|over| over * share).filter(|share| *share <= most)
        }
        _ => None,
    };
    let main = forces.at(Component::Main, depth, speed);
    let force = |component| forces.at(component, depth, speed).map(|force| force.rounded(0));
    Ok(TurningConditions {
        tool: cut.tool.designation.to_owned(),
        lathe: cut.lathe.id().to_owned(),
        depth_mm: depth,
        feed_mm_per_rev: feed.rounded(4),
        computed_speed_m_per_min: taken.computed.rounded(2),
        speed_m_per_min: speed.rounded(2),
        spindle_rpm: rpm.rounded(2),
        feed_mm_per_min: MillimetresPerMinute(feed.0 * rpm.0).rounded(1),
        tool_life_min: taken.life_at(speed).map(|life| life.rounded(0)),
        main_force_n: force(Component::Main),
        radial_force_n: force(Component::Radial),
        axial_force_n: force(Component::Axial),
        torque_n_m: main.map(|main| bounds::torque(main, cut.diameter).rounded(1)),
        power_kw: main.map(|main| bounds::power(main, speed).rounded(2)),
        limited_by: limited_by.to_owned(),
        exceeded: checks.iter().filter(exceeded).map(|check| check.bound).collect(),
        gives_way,
        missing,
        because,
    })
}

/// What a blade presses on the part with as it plunges with its whole width: Pz around it, Py against the feed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BladeForce {
    /// Pz.
    pub main: Newtons,
    /// Py across the axis.
    pub across: Newtons,
    /// Py along it, of a blade that is fed into a face.
    pub along: Newtons,
    /// The largest diameter of the cut.
    pub diameter: Micrometres,
}

impl BladeForce {
    /// The torque at a share of the largest diameter.
    pub fn torque(self, share: f64) -> NewtonMetres {
        NewtonMetres(bounds::torque(self.main, self.diameter).0 * share)
    }
}

/// The forces of a blade at its feed and spindle speed; none where their figures are not known.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn blade_force(
    cut: &TurningCut<'_, '_>,
    width: Micrometres,
    feed: MillimetresPerRev,
    rpm: RevsPerMinute,
) -> Result<Option<BladeForce>, KnowledgeError> {
    let forces = Forces::of(cut, feed)?;
    let speed = speed_at(rpm, cut.diameter);
    let [main, against] = [Component::Main, Component::Radial].map(|component| forces.at(component, width, speed));
    let Some(main) = main else { return Ok(None) };
    // Without Py the rest of it is known yet.
    let against = against.unwrap_or_default();
    let (across, along) = match cut.direction {
        Direction::Transverse => (against, Newtons(0.0)),
        Direction::Longitudinal => (Newtons(0.0), against),
    };
    Ok(Some(BladeForce { main, across, along, diameter: cut.diameter }))
}

/// A feed reduced until the part bears the cut: until it deflects within what is allowed, in finishing a share of its tolerance, and
/// is not bent beyond its strength. In hundredths of a millimetre, but not below the least feed of `turning-limits`; a remaining
/// excess is among the exceeded limits.
///
/// # Errors
/// No speed or load is known; a broken table.
pub fn within_part(
    cut: &TurningCut<'_, '_>,
    depth: Micrometres,
    feed: MillimetresPerRev,
    pass: RoughOrFinish,
    because: &mut Vec<Because>,
) -> Tried<MillimetresPerRev, CuttingRefusal> {
    if cut.part.is_none() {
        return Ok(feed);
    }
    let (least, _) = bounds::constant_length(cut, Limit::FinishFeedLeast)?;
    let (mut held, mut bound) = (feed, None);
    // Held at the least feed as well, it is told why it is no larger.
    loop {
        let forces = Forces::of(cut, held)?;
        let (checks, _) = bounds::checks(cut, &forces)?;
        let law = of_figures(cut.named(speed::speed(cut, held, pass)))?;
        // The speed that the spindle has: a slower cut presses harder.
        let (rpm, _) = first_speed(cut, rpm_at(law.at(depth.to_mm(), cut)?.speed, cut.diameter), false);
        let speed = speed_at(rpm, cut.diameter);
        let of_part = |check: &&Check| matches!(check.bound, Bound::PartStiffness | Bound::PartStrength);
        let bears =
            |check: &Check| check.load(cut, &forces, depth, speed).is_none_or(|load| load.within(check.capacity));
        let Some(exceeded) = checks.iter().filter(of_part).find(|check| !bears(check)) else { break };
        let next = ((held.0 - 0.01) * 100.0).round() / 100.0;
        if next < least.to_mm() {
            break;
        }
        held = MillimetresPerRev(next);
        let note = Note::new("feed-within-part").with("feed", held.0).with("before", feed.0);
        bound = exceeded.because.last().map(|one| Because { note, ..one.clone() });
    }
    because.extend(bound);
    Ok(held)
}

/// The feed of finishing if a roughness is required, but never above that of roughing if the tables have one.
fn feed_of(
    cut: &TurningCut<'_, '_>,
    depth: Micrometres,
    roughness: Option<Roughness>,
) -> Tried<(MillimetresPerRev, Vec<Because>), CuttingRefusal> {
    let Some(roughness) = roughness else {
        let rough = rough_feed(cut, depth)?;
        return Ok((rough.feed, rough.because));
    };
    if let Some(best) = cut.lathe.best_roughness
        && roughness < best
    {
        return Err(Refusal::Not(CuttingRefusal::TooFineForLathe {
            lathe: cut.lathe.id().to_owned(),
            roughness,
            best,
        }));
    }
    let finish = finish_feed(cut, roughness)?;
    match Refusal::split(rough_feed(cut, depth))? {
        Ok(rough) if rough.feed.0 < finish.feed.0 => Ok((rough.feed, rough.because)),
        _ => Ok((finish.feed, finish.because)),
    }
}

/// The spindle speed for a wanted speed, and the limit that applied.
fn first_speed(cut: &TurningCut<'_, '_>, wanted: RevsPerMinute, practice: bool) -> (RevsPerMinute, &'static str) {
    let (slowest, fastest) = cut.lathe.spindle.ends();
    let limited_by = if wanted.0 > fastest.0 {
        "spindle-speed-max"
    } else if wanted.0 < slowest.0 {
        "spindle-speed-min"
    } else if practice {
        "practice"
    } else {
        "tool-life"
    };
    let most = cut.spindle_most.filter(|most| most.0 < wanted.0).unwrap_or(wanted);
    (cut.lathe.spindle.at_most(most), limited_by)
}

/// The fastest speed below a given one for which the power is enough; none if it is enough already.
///
/// N = Pz·V/60000 with Pz ~ V^n, so for a stepless spindle V' = V·(N'/N)^(1/(1+n)).
pub(super) fn within_power(
    cut: &TurningCut<'_, '_>,
    check: &Check,
    forces: &Forces,
    depth: Micrometres,
    rpm: RevsPerMinute,
) -> Option<RevsPerMinute> {
    let fits = |rpm: RevsPerMinute| {
        let load = check.load(cut, forces, depth, speed_at(rpm, cut.diameter));
        load.is_none_or(|load| load.within(check.capacity))
    };
    if fits(rpm) {
        return None;
    }
    Some(match &cut.lathe.spindle {
        Spindle::Steps(steps) => {
            let below = steps.iter().rev().filter(|step| step.0 < rpm.0).find(|step| fits(**step));
            below.or_else(|| steps.first()).copied().unwrap_or(rpm)
        }
        Spindle::Range { min, .. } => {
            let now = check.load(cut, forces, depth, speed_at(rpm, cut.diameter))?;
            let (Load::PowerKw(now), Load::PowerKw(most)) = (now, check.capacity) else { return None };
            let exponent = forces.main.as_ref().map_or(0.0, |law| law.speed_exponent());
            let slower = rpm.0 * libm::pow(most.0 / now.0, 1.0 / (1.0 + exponent));
            // Rounded down to a tenth of a revolution, as a program writes it.
            RevsPerMinute((round_to(slower, 1) - 0.1).max(min.0))
        }
    })
}

/// The fastest speed below a given one at which the jaws hold a cut; none if they hold it already, and where no speed helps.
pub(super) fn within_grip(
    cut: &TurningCut<'_, '_>,
    check: &Check,
    forces: &Forces,
    depth: Micrometres,
    rpm: RevsPerMinute,
) -> Option<RevsPerMinute> {
    let fits = |rpm: RevsPerMinute| {
        let load = check.load(cut, forces, depth, speed_at(rpm, cut.diameter));
        load.is_none_or(|load| load.within(check.capacity))
    };
    if fits(rpm) {
        return None;
    }
    match &cut.lathe.spindle {
        Spindle::Steps(steps) => steps.iter().rev().filter(|step| step.0 < rpm.0).find(|step| fits(**step)).copied(),
        Spindle::Range { min, .. } => {
            let (mut holds, mut loose) = (*min, rpm);
            if !fits(holds) {
                return None;
            }
            while loose.0 - holds.0 > 0.1 {
                let middle = RevsPerMinute(f64::midpoint(holds.0, loose.0));
                *(if fits(middle) { &mut holds } else { &mut loose }) = middle;
            }
            Some(RevsPerMinute(libm::floor(holds.0 * 10.0) / 10.0))
        }
    }
}
