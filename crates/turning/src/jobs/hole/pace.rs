//! Feed and speed of a tool on the axis, by the formulas of holes, within the limits of spindle and drives of the
//! lathe.

use crate::error::{Refusal, Tried};
use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::note::{Because, Figure, Note};
use crate::tables::lathes::LatheQuantity;
use crate::tables::turning::tools::{Limit, TurningLimits};
use crate::turning::operation::tools::Bench;
use crate::turning::program::{Feeds, Speed};
use crate::turning::tooling::Lathe;
use crate::units::{MetresPerMinute, MillimetresPerRev, NewtonMetres, Newtons, RevsPerMinute, round_to};
use technolog_cutting::figures::Asking;
use technolog_cutting::laws::LoadLaw;
use technolog_cutting::practice::SecondOpinion;
use technolog_cutting::{Cut, handbook, practice, rpm_at, speed_at, tapping};

use super::super::refused::{NoJob, Operation, of_tables};

/// Speed and feed of a tool on the axis.
pub(super) struct AxialConditions {
    pub speed: Speed,
    pub feed: Feeds,
    /// Of a tap, where it is known: it turns the part in its jaws.
    pub torque: Option<NewtonMetres>,
    pub because: Vec<Because>,
}

impl<'k> Asking<'k> for Bench<'_, 'k> {
    fn knowledge(&self) -> &'k Knowledge {
        self.knowledge
    }

    fn material(&self) -> &Material<'k> {
        &self.material
    }
}

/// Feed and speed of a cut: those of the tables; the speed compared with practice, limited by the spindle; the feed
/// reduced until thrust, torque and power are within their limits. A load is a power law of the feed, so each limit
/// gives a feed.
///
/// # Errors
/// The tables have no figures; or even the least feed of the lathe is too much.
pub(super) fn pace(cut: &Cut, lathe: &Lathe<'_>, bench: &Bench<'_, '_>) -> Tried<AxialConditions, NoJob> {
    let no_figures = |refusal| of_tables(Operation::Drilling, refusal);
    let (mut feed, mut because) = handbook::feed(cut, bench).map_err(no_figures)?;
    let Some((life, of_life)) = handbook::tool_life(cut, bench).map_err(no_figures)? else {
        return Err(Refusal::Not(NoJob::NoDrill { diameter: cut.diameter, depth: crate::turning::length::Half::ZERO }));
    };
    let Some(law) = handbook::formulas(cut, feed, bench).map_err(no_figures)? else {
        return Err(Refusal::Not(NoJob::NoDrill { diameter: cut.diameter, depth: crate::turning::length::Half::ZERO }));
    };
    let speed_factor = law.speed_factor();
    because.extend(of_life.into_iter().chain(law.speed_because).chain(law.loads_because));
    let (diameter, depth_of_cut) = (cut.diameter.to_mm(), (cut.diameter - cut.from).to_mm() / 2.0);
    let wanted = MetresPerMinute(law.speed.at(diameter, depth_of_cut, feed.0, life.0) * speed_factor);
    let SecondOpinion { speed: wanted, because: of_practice, .. } =
        practice::second_opinion(wanted, cut, &bench.material, bench.knowledge)?;
    because.extend(of_practice);
    let rpm = lathe.spindle.at_most(rpm_at(wanted, cut.diameter)).rounded(2);
    if let Some((torque, thrust)) = law.loads {
        let power = power(lathe, bench.knowledge)?;
        let mut hold = |law_of: LoadLaw, limit: f64, why: Because| {
            let load = law_of.at(diameter, depth_of_cut, feed.0) * law.load_factor;
            if load > limit {
                feed = MillimetresPerRev(feed.0 * libm::pow(limit / load, 1.0 / law_of.y));
                because.push(why);
            }
        };
        if let Some(limit) = lathe.feed_force_z {
            hold(thrust, limit.0, lathe_limit(lathe, LatheQuantity::FeedForceZ, limit.0)?);
        }
        if let Some(limit) = lathe.torque {
            hold(torque, limit.0, lathe_limit(lathe, LatheQuantity::SpindleTorqueMax, limit.0)?);
        }
        hold(torque, 9750.0 * power.0 / rpm.0, power.1);
        let (least, most) = lathe.feed_z;
        feed = MillimetresPerRev(round_to(feed.0.min(most.0 / rpm.0), 4));
        if feed.0 * rpm.0 < least.0 {
            let force = Newtons(thrust.at(diameter, depth_of_cut, least.0 / rpm.0) * law.load_factor);
            let most = lathe.feed_force_z.unwrap_or_default();
            return Err(Refusal::Not(NoJob::DrillTooStrong { diameter: cut.diameter, force, most }));
        }
        let note = Note::new("job-drill-loads")
            .with("feed", feed.0)
            .with("thrust", round_to(thrust.at(diameter, depth_of_cut, feed.0) * law.load_factor, 0))
            .with("torque", round_to(torque.at(diameter, depth_of_cut, feed.0) * law.load_factor, 1));
        because.push(Because::table(lathe.table, note));
    }
    let used = speed_at(rpm, cut.diameter).rounded(1);
    let note =
        Note::new("job-drill-speed").with("wanted", round_to(wanted.0, 1)).with("speed", used.0).with("spindle", rpm.0);
    because.push(Because::table(lathe.table, note));
    Ok(AxialConditions { speed: Speed::Spindle(RevsPerMinute(rpm.0)), feed: Feeds::all(feed), torque: None, because })
}

/// The spindle of a tap: the speed of its formula, compared with practice, as far as the spindle is reversed and the feed follows; slower
/// where the power is not enough. Its torque does not depend on the speed.
///
/// # Errors
/// The tables have no figures; the torque is more than the spindle has.
pub(super) fn tap_pace(
    cut: &Cut,
    most: RevsPerMinute,
    lathe: &Lathe<'_>,
    bench: &Bench<'_, '_>,
) -> Tried<AxialConditions, NoJob> {
    let law = tapping::law(cut, bench).map_err(|refusal| of_tables(Operation::Tapping, refusal))?;
    let mut because = law.because;
    let SecondOpinion { speed: wanted, because: of_practice, .. } =
        practice::second_opinion(law.speed, cut, &bench.material, bench.knowledge)?;
    because.extend(of_practice);
    let pitch = cut.pitch.unwrap_or_default().to_mm();
    let mut rpm = rpm_at(wanted, cut.diameter).0.min(most.0).min(lathe.feed_z.1.0 / pitch);
    if let Some(torque) = law.torque {
        let (power, of_power) = power(lathe, bench.knowledge)?;
        if let Some(limit) = lathe.torque.filter(|limit| torque.0 > limit.0) {
            let (diameter, most) = (cut.diameter, limit.0);
            return Err(Refusal::Not(NoJob::TapTooStrong { diameter, torque, most: NewtonMetres(most) }));
        }
        let powered = 9750.0 * power / torque.0;
        if powered < rpm {
            rpm = powered;
            because.push(of_power);
        }
        because.push(Because::table(lathe.table, Note::new("job-tap-torque").with("torque", round_to(torque.0, 1))));
    }
    let rpm = lathe.spindle.at_most(RevsPerMinute(rpm));
    let used = speed_at(rpm, cut.diameter).rounded(1);
    let note =
        Note::new("job-drill-speed").with("wanted", round_to(wanted.0, 1)).with("speed", used.0).with("spindle", rpm.0);
    because.push(Because::table(lathe.table, note));
    Ok(AxialConditions {
        speed: Speed::Spindle(rpm),
        feed: Feeds::all(MillimetresPerRev(pitch)),
        torque: law.torque,
        because,
    })
}

fn lathe_limit(lathe: &Lathe<'_>, quantity: LatheQuantity, limit: f64) -> Tried<Because, NoJob> {
    Ok(Because::row(lathe.row(quantity)?, Note::new("lathe-limit").with("limit", limit)))
}

/// The power at the spindle, kW, and the reason.
fn power(lathe: &Lathe<'_>, knowledge: &Knowledge) -> Tried<(f64, Because), NoJob> {
    let why = lathe_limit(lathe, LatheQuantity::SpindlePower, lathe.power.0)?;
    if let Some(share) = lathe.efficiency {
        return Ok((lathe.power.0 * share.0, why));
    }
    let name = Limit::DriveEfficiency;
    let row = knowledge.need(name.name(), |row: &TurningLimits<'_>| row.name == name)?;
    let share = row.ratio.unwrap_or(1.0);
    let note = Note::new("turning-limit").with("name", Figure::word(name.name())).with("value", share);
    Ok((lathe.power.0 * share, Because::row(row.row, note)))
}
