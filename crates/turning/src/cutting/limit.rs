//! The limiting depth of cut: the largest depth within all limits of tool and lathe (lecture 12.4, l. 614-626).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::note::{Because, Finding};
use crate::tables::practice::RoughOrFinish;
use crate::tables::turning::tools::Limit;
use crate::units::{MetresPerMinute, Micrometres, MillimetresPerRev, RevsPerMinute};
use technolog_cutting::{rpm_at, speed_at};

use super::bounds::{self, Bound, Check, Forces, Load, UnknownBound};
use super::conditions::{within_grip, within_power};
use super::speed::{self, SpeedLaw};
use super::{CuttingRefusal, NonPositive, Speed, TurningCut, of_figures};

/// The limiting depth of cut, with every limit that was compared.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LimitingDepth {
    /// The tool.
    pub tool: String,
    /// The lathe's id.
    pub lathe: String,
    /// The material's id.
    pub material: String,
    /// The diameter it was computed at, mm.
    pub diameter_mm: Micrometres,
    /// The feed of the calculation.
    pub feed_mm_per_rev: MillimetresPerRev,
    /// The largest depth, mm, in whole steps of `turning-limits`; absent if not even one step is allowed.
    pub depth_mm: Option<Micrometres>,
    /// The strictest limit; among equals the first of the list.
    pub decided_by: Bound,
    /// The cutting speed at that depth (at one step if none is allowed).
    pub speed_m_per_min: MetresPerMinute,
    /// The spindle speed at that depth.
    pub spindle_rpm: RevsPerMinute,
    /// Every limit that could be calculated.
    pub bounds: Vec<BoundTold>,
    /// The other limits, and why: the depth is given without them.
    pub missing: Vec<UnknownBound>,
    /// The rows behind speed and forces.
    pub because: Vec<Because>,
}

/// A limit of the depth of cut, as printed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BoundTold {
    /// The limit.
    pub bound: Bound,
    /// The largest depth that it allows alone, mm; absent if not even one step.
    pub depth_mm: Option<Micrometres>,
    /// The load at the limiting depth (at one step if none is allowed).
    pub load: Load,
    /// The capacity of tool or lathe.
    pub capacity: Load,
    /// The rows of the capacity.
    pub because: Vec<Because>,
}

impl LimitingDepth {
    /// Findings for the reader of the depth: every limit that could not be calculated.
    pub fn findings(&self) -> Vec<Finding> {
        self.missing.iter().map(UnknownBound::finding).collect()
    }
}

/// The spindle speed as a function of the depth.
struct Turns<'c, 'a, 'k> {
    cut: &'c TurningCut<'a, 'k>,
    speed: Speed,
    law: Option<SpeedLaw<'k>>,
    forces: &'c Forces,
    /// The limits of power and of the jaws that can be calculated.
    power: Option<&'c Check>,
    grip: Vec<&'c Check>,
}

impl<'c, 'a, 'k> Turns<'c, 'a, 'k> {
    fn new(
        cut: &'c TurningCut<'a, 'k>,
        speed: Speed,
        feed: MillimetresPerRev,
        forces: &'c Forces,
        checks: &'c [Check],
    ) -> Tried<Self, CuttingRefusal> {
        let power = checks.iter().find(|check| check.bound == Bound::SpindlePower);
        let law = if matches!(speed, Speed::ForToolLife | Speed::WithinPower) {
            Some(of_figures(cut.named(speed::speed(cut, feed, RoughOrFinish::Rough)))?)
        } else {
            None
        };
        let grip = checks.iter().filter(|check| check.is_of_grip()).collect();
        Ok(Self { cut, speed, law, forces, power, grip })
    }

    /// The row of practice for the speed at a depth.
    fn opinion(&self, depth: Micrometres) -> Result<Vec<Because>, KnowledgeError> {
        let taken = self.law.as_ref().map(|law| law.at(depth.to_mm(), self.cut)).transpose()?;
        Ok(taken.map(|taken| taken.because).unwrap_or_default())
    }

    /// Spindle speed and cutting speed at a depth, on a step of the spindle; a given spindle speed is used as it is.
    fn at(&self, depth: Micrometres) -> Result<(RevsPerMinute, MetresPerMinute), KnowledgeError> {
        let spindle = &self.cut.lathe.spindle;
        let rpm = match (self.speed, &self.law) {
            (Speed::Spindle(rpm), _) => rpm,
            (Speed::Surface(speed), _) => spindle.at_most(rpm_at(speed, self.cut.diameter)),
            (_, Some(law)) => spindle.at_most(rpm_at(law.at(depth.to_mm(), self.cut)?.speed, self.cut.diameter)),
            (_, None) => spindle.ends().0,
        };
        let slower = self.power.filter(|_| self.speed == Speed::WithinPower);
        let slower = slower.and_then(|check| within_power(self.cut, check, self.forces, depth, rpm));
        let mut rpm = slower.unwrap_or(rpm);
        for check in self.grip.iter().filter(|_| self.speed == Speed::WithinPower) {
            rpm = within_grip(self.cut, check, self.forces, depth, rpm).unwrap_or(rpm);
        }
        Ok((rpm, speed_at(rpm, self.cut.diameter)))
    }
}

/// The limiting depth of cut (lecture 12.4, l. 614-626: tool strength, feed drive, torque, tool life and others).
///
/// Depths are tried upwards in the steps of `turning-limits`. At each the speed is that of the tool life, on a step of
/// the spindle, and forces, torque and power follow from it; so t and V(t) always belong to one cut. The depth of a
/// limit is the last one before the first that exceeds it. On a stepped spindle a deeper cut may run a step slower and
/// need less power again, but smaller depths must be possible too, because levels are seldom full. The limiting depth
/// is the least of all, so every depth up to it is allowed, rounded down to the step.
///
/// # Errors
/// A grooving tool (its depth of cut is its width) or a threading tool; a diameter or feed that is not above
/// zero; no figures for the speed of the tool life; no load that can be calculated, so that the depth is unknown; a
/// broken table.
pub fn limiting_depth(
    cut: &TurningCut<'_, '_>,
    feed: MillimetresPerRev,
    speed: Speed,
) -> Tried<LimitingDepth, CuttingRefusal> {
    if cut.tool.plunges() || cut.tool.pitch.is_some() {
        return Err(Refusal::Not(CuttingRefusal::NoDepth { tool: cut.tool.designation.to_owned() }));
    }
    positive(cut, feed)?;
    bounds::bar_reaches(cut)?;
    let forces = Forces::of(cut, feed)?;
    let (checks, missing) = bounds::checks(cut, &forces)?;
    // The length of the edge alone does not limit the load of shank and spindle.
    if !checks.iter().any(Check::is_of_loads) {
        return Err(Refusal::Not(CuttingRefusal::LimitNotKnown(missing.into_iter().next())));
    }
    let turns = Turns::new(cut, speed, feed, &forces, &checks)?;
    let (step, of_step) = bounds::constant_length(cut, Limit::DepthStep)?;
    let (last, _) = bounds::constant_length(cut, Limit::DepthMax)?;
    let depth_at = |steps: i64| Micrometres::new(step.micrometres().saturating_mul(steps));
    let steps = last.micrometres() / step.micrometres().max(1);
    let speeds: Vec<MetresPerMinute> =
        (1..=steps).map(|steps| turns.at(depth_at(steps)).map(|(_, speed)| speed)).collect::<Result<_, _>>()?;
    let allowed = |check: &Check| -> i64 {
        let held = (1..).zip(&speeds).take_while(|(steps, speed)| {
            let load = check.load(cut, &forces, depth_at(*steps), **speed);
            load.is_some_and(|load| load.within(check.capacity))
        });
        held.last().map_or(0, |(steps, _)| steps)
    };
    let allowed_steps: Vec<i64> = checks.iter().map(allowed).collect();
    let least = allowed_steps.iter().copied().min().unwrap_or(0);
    let decided_by =
        checks.iter().zip(&allowed_steps).find(|(_, steps)| **steps == least).map(|(check, _)| check.bound);
    let told_at = depth_at(least.max(1));
    let (rpm, velocity) = turns.at(told_at)?;
    let opinion = turns.opinion(told_at)?;
    let entry = |(check, steps): (&Check, &i64)| {
        let load = check.load(cut, &forces, told_at, velocity)?;
        Some(BoundTold {
            bound: check.bound,
            depth_mm: (*steps > 0).then(|| depth_at(*steps)),
            load: load.rounded(),
            capacity: check.capacity.rounded(),
            because: check.because.clone(),
        })
    };
    let mut because: Vec<Because> = turns.law.iter().flat_map(|law| law.because.clone()).collect();
    because.extend(opinion);
    because.extend(forces.because());
    because.push(of_step);
    Ok(LimitingDepth {
        tool: cut.tool.designation.to_owned(),
        lathe: cut.lathe.id().to_owned(),
        material: cut.material.id.to_owned(),
        diameter_mm: cut.diameter,
        feed_mm_per_rev: feed.rounded(4),
        depth_mm: (least > 0).then(|| depth_at(least)),
        decided_by: decided_by.unwrap_or(Bound::Handbook),
        speed_m_per_min: velocity.rounded(2),
        spindle_rpm: rpm.rounded(2),
        bounds: checks.iter().zip(&allowed_steps).filter_map(entry).collect(),
        missing,
        because,
    })
}

/// A diameter and a feed that can be used in a calculation.
pub(super) fn positive(cut: &TurningCut<'_, '_>, feed: MillimetresPerRev) -> Tried<(), CuttingRefusal> {
    if cut.diameter <= Micrometres::ZERO {
        return Err(Refusal::Not(CuttingRefusal::NothingToCut(NonPositive::Diameter(cut.diameter))));
    }
    if !(feed.0 > 0.0 && feed.0 <= 10.0) {
        return Err(Refusal::Not(CuttingRefusal::NothingToCut(NonPositive::Feed(feed))));
    }
    Ok(())
}
