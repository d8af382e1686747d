//! The machine's limits: spindle step, feed range, thrust, torque, power.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::units::Percent;
use crate::knowledge::{Answer, RowRef};
use crate::note::{Because, Figure, Note};
use crate::plan::{Limit, Operation};
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::tables::cutting::DrillStrength;
use crate::tables::machines::MachineQuantity;
use crate::tables::practice::{ProofLimit, ProofLimits};
use crate::tables::rules::{Load, LoadMarginFor, Neighbour, SpindleStepFor};
use crate::units::{MetresPerMinute, MillimetresPerRev, NewtonMetres, RevsPerMinute, round_to};

use super::{Cut, DraftConditions, Loads, PowerLaw, rpm_at, speed_at};

/// Conditions within the machine's limits.
pub(super) struct LimitedConditions {
    pub feed: MillimetresPerRev,
    pub rpm: RevsPerMinute,
    pub limited_by: Limit,
    /// Whether a load or the power has reduced the feed at this step.
    pub reduced: bool,
    pub because: Vec<Because>,
}

/// A load that must stay below a limit, and the row that sets the limit.
struct Bound<'k> {
    law: Option<PowerLaw>,
    limit: f64,
    kind: Limit,
    row: RowRef<'k>,
    /// The share of the machine's limit that a load may take.
    margin: Option<Margin<'k>>,
}

/// A share of a limit, by the rule `load-margin`.
#[derive(Clone, Copy)]
struct Margin<'k> {
    share: f64,
    row: RowRef<'k>,
}

impl<'k> Margin<'k> {
    fn of(load: Load, shop: &Shop<'k>) -> Result<Self, KnowledgeError> {
        let margin = shop.knowledge.ask(&LoadMarginFor { load })?.need(load.name())?;
        Ok(Self { share: margin.share, row: margin.row })
    }

    fn reason(self) -> Because {
        Because::row(self.row, Note::new("load-margin").with("percent", round_to(self.share * 100.0, 0)))
    }
}

/// The feed that the loads permit, if it is less than the required one.
pub(super) struct ReducedFeed {
    pub feed: MillimetresPerRev,
    /// The limit.
    pub limit: Limit,
    pub because: Vec<Because>,
}

/// A load that exceeds its limit by no more than this equals it, because the limit was converted to a feed and back.
const SLACK: f64 = 1e-9;

/// What the drill itself bears, whatever its feed; see [`drill_strength`] and [`drill_buckling`].
pub(super) struct OfDrill<'k> {
    /// N·m, with its row.
    torque: Option<(f64, RowRef<'k>)>,
    /// N, with its row.
    thrust: Option<(f64, RowRef<'k>)>,
}

impl<'k> OfDrill<'k> {
    /// The limits of the drill of a cut; none for other tools.
    pub(super) fn of(cut: &Cut, shop: &Shop<'k>) -> Result<Self, KnowledgeError> {
        Ok(Self { torque: drill_strength(cut, shop)?, thrust: drill_buckling(cut, shop)? })
    }

    fn bounds(&self, loads: Loads) -> [Option<Bound<'k>>; 2] {
        let bound = |law, kind| move |(limit, row): (f64, RowRef<'k>)| Bound { law, limit, kind, row, margin: None };
        [
            self.torque.map(bound(loads.torque, Limit::DrillStrength)),
            self.thrust.map(bound(loads.thrust, Limit::DrillBuckling)),
        ]
    }
}

/// Reduces a feed to the limits of the drill, of thrust and torque at a spindle step; none if it is within them.
pub(super) fn reduced_feed(
    draft: &DraftConditions,
    feed: MillimetresPerRev,
    drill: &OfDrill<'_>,
    rpm: RevsPerMinute,
    shop: &Shop<'_>,
) -> Tried<Option<ReducedFeed>, Uncut> {
    let (machine, loads) = (&shop.machine, draft.loads);
    let speed = speed_at(rpm, draft.motion.turned);
    let (thrust, torque) = (Margin::of(Load::Thrust, shop)?, Margin::of(Load::Torque, shop)?);
    let [strength, buckling] = drill.bounds(loads);
    let bounds = [
        strength,
        buckling,
        Some(Bound {
            law: loads.thrust,
            limit: machine.thrust.0 * thrust.share,
            kind: Limit::Thrust,
            row: machine.row(MachineQuantity::ThrustZMax)?,
            margin: Some(thrust),
        }),
        Some(Bound {
            law: loads.torque,
            limit: machine.spindle_torque.0 * torque.share,
            kind: Limit::SpindleTorque,
            row: machine.row(MachineQuantity::SpindleTorqueMax)?,
            margin: Some(torque),
        }),
    ];
    Ok(within(&bounds, feed, speed))
}

/// The feed within all limits, if the required one is not.
fn within(bounds: &[Option<Bound<'_>>], required: MillimetresPerRev, speed: MetresPerMinute) -> Option<ReducedFeed> {
    let mut borne: Option<ReducedFeed> = None;
    for bound in bounds.iter().flatten() {
        let before = borne.as_ref().map_or(required, |borne| borne.feed);
        if let Some(law) = bound.law
            && law.at(before, speed) > bound.limit * (1.0 + SLACK)
        {
            let feed = law.feed_at(bound.limit, speed);
            let note = Note::new("feed-reduced")
                .with("by", Figure::word(bound.kind.name()))
                .with("from", round_to(before.0, 3))
                .with("to", round_to(feed.0, 3))
                .with("limit", round_to(bound.limit, 1));
            let mut because = borne.map_or_else(Vec::new, |borne| borne.because);
            because.push(Because::row(bound.row, note));
            because.extend(bound.margin.map(Margin::reason));
            borne = Some(ReducedFeed { feed, limit: bound.kind, because });
        }
    }
    borne
}

/// The spindle step of a draft's speed.
pub(super) fn step_of(draft: &DraftConditions, shop: &Shop<'_>) -> Result<RevsPerMinute, KnowledgeError> {
    Ok(SpindleStepChoice::of(rpm_at(draft.speed, draft.motion.turned), fastest(draft), shop)?.rpm)
}

/// The spindle speed at which a cut reaches the upper end of practice.
fn fastest(draft: &DraftConditions) -> Option<RevsPerMinute> {
    draft.fastest.map(|speed| rpm_at(speed, draft.motion.turned))
}

/// Chooses the spindle step and keeps the feed within the loads, the power and the feed range; `limited` names the
/// load that has already reduced the feed.
pub(super) fn limit_to_machine(
    draft: &DraftConditions,
    limited: Option<Limit>,
    drill: &OfDrill<'_>,
    shop: &Shop<'_>,
) -> Tried<LimitedConditions, Uncut> {
    let (rpm, limited_by, reason) = spindle_step(rpm_at(draft.speed, draft.motion.turned), fastest(draft), shop)?;
    let mut best = at_step(draft, drill, rpm, (limited.unwrap_or(limited_by), vec![reason]), shop)?;
    // If power is the limit, a slower step permits more feed: the step with the greatest feed rate is taken.
    for step in shop.machine.spindle_steps.iter().rev().filter(|step| step.0 < rpm.0) {
        if best.limited_by != Limit::SpindlePower {
            break;
        }
        let wanted = rpm_at(draft.speed, draft.motion.turned);
        let note = Note::new("spindle-step-below").with("computed", round_to(wanted.0, 1)).with("step", step.0);
        let reason = Because::row(shop.machine.row(MachineQuantity::SpindleSpeeds)?, note);
        let slower = at_step(draft, drill, *step, (Limit::SpindlePower, vec![reason]), shop)?;
        if slower.feed.0 * slower.rpm.0 <= best.feed.0 * best.rpm.0 {
            break;
        }
        best = slower;
        if !best.reduced {
            break;
        }
    }
    Ok(best)
}

/// The feed at one spindle step.
fn at_step(
    draft: &DraftConditions,
    drill: &OfDrill<'_>,
    rpm: RevsPerMinute,
    (mut limited_by, mut because): (Limit, Vec<Because>),
    shop: &Shop<'_>,
) -> Tried<LimitedConditions, Uncut> {
    let machine = &shop.machine;
    let (mut feed, mut reduced) = (draft.feed, false);
    let margin = Margin::of(Load::Power, shop)?;
    let power = Bound {
        law: draft.loads.torque,
        limit: 9750.0 * machine.spindle_power.0 * margin.share / rpm.0,
        kind: Limit::SpindlePower,
        row: machine.row(MachineQuantity::SpindlePower)?,
        margin: Some(margin),
    };
    for reduced_feed in
        [reduced_feed(draft, feed, drill, rpm, shop)?, within(&[Some(power)], feed, speed_at(rpm, draft.motion.turned))]
    {
        if let Some(borne) = reduced_feed.filter(|borne| borne.feed.0 < feed.0) {
            feed = borne.feed;
            (limited_by, reduced) = (borne.limit, true);
            because.extend(borne.because);
        }
    }
    for (outside, limit, kind, quantity) in [
        (feed.0 * rpm.0 > machine.feed_max.0, machine.feed_max, Limit::FeedMax, MachineQuantity::FeedMax),
        (feed.0 * rpm.0 < machine.feed_min.0, machine.feed_min, Limit::FeedMin, MachineQuantity::FeedMin),
    ] {
        if outside {
            feed = MillimetresPerRev(limit.0 / rpm.0);
            limited_by = kind;
            because.push(Because::row(machine.row(quantity)?, Note::new("feed-held").with("limit", limit.0)));
        }
    }
    Ok(LimitedConditions { feed, rpm, limited_by, reduced, because })
}

/// The strength of a thin drill (textbook 1.2.1, l. 223-226: below 10 mm the drill's own strength limits the feed).
///
/// Permissible torque Mp = k·d³·τ/1000, N·m, with the polar section modulus k·d³ of the fluted section, mm³, and the
/// permissible shear stress τ, MPa (table `drill-strength`); d is the tool's own diameter, which for a spot is not
/// that of the cut.
fn drill_strength<'k>(cut: &Cut, shop: &Shop<'k>) -> Result<Option<(f64, RowRef<'k>)>, KnowledgeError> {
    if !matches!(cut.operation, Operation::CentreDrill | Operation::Drill | Operation::DrillOut) {
        return Ok(None);
    }
    let of_tool = |row: &DrillStrength<'_>| row.tool_material == cut.tool_material;
    let Some(strength) = shop.knowledge.find(of_tool)? else { return Ok(None) };
    let tool = cut.tool_diameter.unwrap_or(cut.diameter);
    if tool >= strength.below_diameter {
        return Ok(None);
    }
    let d = tool.to_mm();
    let limit = strength.modulus_factor * d * d * d * strength.shear_stress.0.to_f64() / 1000.0;
    Ok(Some((limit, strength.row)))
}

/// The thrust at which a long thin drill bends out: the flutes are a column, clamped in the holder and held by the spot.
///
/// Permissible thrust = share·π²·E·v·d⁴ / (μ·L)², N, with E in MPa and the drill's diameter d and the length L of its flutes in mm
/// (Euler; table `proof-limits`, by which the proof of plans judges, too).
fn drill_buckling<'k>(cut: &Cut, shop: &Shop<'k>) -> Result<Option<(f64, RowRef<'k>)>, KnowledgeError> {
    let Some(flutes) = cut.flutes.filter(|_| cut.operation == Operation::Drill) else { return Ok(None) };
    let limit_of = |name: ProofLimit| shop.knowledge.need(name.name(), |row: &ProofLimits<'_>| row.name.is(name));
    let share = limit_of(ProofLimit::DrillBucklingShare)?;
    let modulus_mpa = limit_of(ProofLimit::BarElasticModulus)?.value * 1000.0;
    let column = flutes.to_mm() * limit_of(ProofLimit::DrillColumn)?.value;
    let section = limit_of(ProofLimit::DrillSection)?.value * cut.tool_diameter.unwrap_or(cut.diameter).to_mm().powi(4);
    let euler = core::f64::consts::PI.powi(2) * modulus_mpa * section / (column * column);
    Ok(Some((share.value * euler, share.row)))
}

/// Limits of a tap: its feed is its pitch and cannot be reduced, so the speed is reduced.
///
/// The fastest step not above the computed speed at which power and feed rate are enough. The torque of a tap does
/// not depend on speed; if it is more than that of the spindle, the tap is refused.
pub(super) fn synchronous(draft: &DraftConditions, shop: &Shop<'_>) -> Tried<LimitedConditions, Uncut> {
    let machine = &shop.machine;
    let wanted = rpm_at(draft.speed, draft.motion.turned);
    let torque = draft.loads.torque.map_or(0.0, |law| law.at(draft.feed, draft.speed));
    let most = machine.spindle_torque.0 * Margin::of(Load::Torque, shop)?.share;
    let power = machine.spindle_power.0 * Margin::of(Load::Power, shop)?.share;
    if torque > most {
        let (torque, limit) = (NewtonMetres(torque), NewtonMetres(most));
        return Err(Refusal::Not(Uncut::TorqueBeyondSpindle { torque, limit }));
    }
    let mut limited_by = Limit::CuttingSpeed;
    for step in machine.spindle_steps.iter().rev().filter(|step| step.0 <= wanted.0) {
        if torque * step.0 / 9750.0 > power {
            limited_by = Limit::SpindlePower;
        } else if draft.feed.0 * step.0 > machine.feed_max.0 {
            limited_by = Limit::FeedMax;
        } else {
            let note = Note::new("spindle-step-below").with("computed", round_to(wanted.0, 1)).with("step", step.0);
            let because = vec![Because::row(machine.row(MachineQuantity::SpindleSpeeds)?, note)];
            return Ok(LimitedConditions { feed: draft.feed, rpm: *step, limited_by, reduced: false, because });
        }
    }
    Err(Refusal::Not(Uncut::NoStepBelow { computed: wanted }))
}

/// The step of the machine's series for a computed speed, by the rule `spindle-step`; what limits it, and why. `fastest`
/// is the spindle speed at the upper end of practice, if there is one.
///
/// # Errors
/// The rule or the machine's series cannot answer.
pub fn spindle_step(
    wanted: RevsPerMinute,
    fastest: Option<RevsPerMinute>,
    shop: &Shop<'_>,
) -> Result<(RevsPerMinute, Limit, Because), KnowledgeError> {
    let taken = SpindleStepChoice::of(wanted, fastest, shop)?;
    Ok((taken.rpm, taken.limit, taken.because(wanted, shop)?))
}

/// A step of the series without its reasons: the loads need only the step.
struct SpindleStepChoice<'k> {
    rpm: RevsPerMinute,
    limit: Limit,
    /// Where the speed lies between two steps.
    between: Option<Between<'k>>,
}

/// The steps around a speed, by how much the faster one exceeds it, %, and the answer of the rule.
struct Between<'k> {
    below: RevsPerMinute,
    above: RevsPerMinute,
    excess: f64,
    /// The spindle speed at the upper end of practice, where that alone forbids the faster step.
    held_by: Option<RevsPerMinute>,
    answer: Answer<'k>,
}

impl<'k> SpindleStepChoice<'k> {
    fn of(wanted: RevsPerMinute, fastest: Option<RevsPerMinute>, shop: &Shop<'k>) -> Result<Self, KnowledgeError> {
        let steps = &shop.machine.spindle_steps;
        let below = steps.iter().rev().find(|step| step.0 <= wanted.0).copied();
        let above = steps.iter().find(|step| step.0 >= wanted.0).copied();
        match (below, above) {
            (Some(below), Some(above)) => {
                let excess = (above.0 / wanted.0 - 1.0) * 100.0;
                let ask = |beyond_practice| -> Result<_, KnowledgeError> {
                    let answer = shop.knowledge.ask(&SpindleStepFor { excess: Percent(excess), beyond_practice })?;
                    Ok((answer.need("this excess")?.take, answer.answer))
                };
                let beyond = fastest.filter(|fastest| above.0 > fastest.0);
                let (taken, answer) = ask(beyond.is_some())?;
                let rpm = match taken {
                    Neighbour::Above => above,
                    Neighbour::Below => below,
                };
                // Whether it is practice alone that refuses the step above.
                let held_by = match beyond {
                    Some(fastest) if rpm.0 < wanted.0 && ask(false)?.0 == Neighbour::Above => Some(fastest),
                    _ => None,
                };
                let limit = if held_by.is_some() { Limit::PracticeSpeed } else { Limit::CuttingSpeed };
                Ok(Self { rpm, limit, between: Some(Between { below, above, excess, held_by, answer }) })
            }
            (Some(rpm), None) => Ok(Self { rpm, limit: Limit::SpindleSpeedMax, between: None }),
            (None, Some(rpm)) => Ok(Self { rpm, limit: Limit::SpindleSpeedMin, between: None }),
            (None, None) => Err(KnowledgeError::no_row(shop.machine.table, "spindle-speeds")),
        }
    }

    fn because(&self, wanted: RevsPerMinute, shop: &Shop<'_>) -> Result<Because, KnowledgeError> {
        let code = match (&self.between, self.limit) {
            (Some(Between { held_by: Some(_), .. }), _) => "spindle-step-in-practice",
            (Some(_), _) => "spindle-step",
            (None, Limit::SpindleSpeedMax) => "spindle-fastest",
            (None, _) => "spindle-slowest",
        };
        let note = Note::new(code).with("computed", round_to(wanted.0, 1)).with("step", self.rpm.0);
        let Some(Between { below, above, excess, held_by, answer }) = &self.between else {
            return Ok(Because::row(shop.machine.row(MachineQuantity::SpindleSpeeds)?, note));
        };
        let note = note.with("below", below.0).with("above", above.0);
        let note = match held_by {
            Some(fastest) => note.with("fastest", round_to(fastest.0, 1)),
            None => note.with("excess", round_to(*excess, 1)),
        };
        Ok(Because::answer(answer, note))
    }
}
