//! Whether a lathe can do what a program asks of its spindle and its drives.

use crate::error::KnowledgeError;
use crate::note::{Note, Severity};
use crate::program::Fault;
use crate::program::lathe::{LatheAct, LatheFeed, LatheMotion, LatheRun, LatheSpeed};
use crate::tables::lathes::LatheQuantity as Q;
use crate::turning::tooling::{Lathe, Spindle};
use crate::units::{Micrometres, MillimetresPerMinute, RevsPerMinute, round_to};
use technolog_cutting::rpm_at;

use super::fault;

/// The share of a limit by which a figure may pass it: programs round.
const ROUNDING: f64 = 0.01;

/// What the spindle and the drives of a lathe cannot do, each once. Where the record of the lathe is not confirmed it is doubtful
/// at most.
///
/// # Errors
/// The record lacks a row.
pub fn against_lathe(run: &LatheRun, lathe: &Lathe<'_>) -> Result<Vec<Fault>, KnowledgeError> {
    let mut faults: Vec<Fault> = Vec::new();
    for motion in run.motions.iter().filter(|motion| motion.act.cuts()) {
        for (code, severity, quantity, note) in spindle(motion, lathe).into_iter().chain(drives(motion, lathe)) {
            let note = note.with("lathe", lathe.id());
            if faults.iter().any(|one| one.code == code && one.note == note) {
                continue;
            }
            let is_confirmed = lathe.row(quantity)?.row().unconfirmed.is_none();
            let severity = if is_confirmed { severity } else { severity.max(Severity::Doubtful) };
            faults.push(fault(code, severity, note, motion.line));
        }
    }
    Ok(faults)
}

type Found = (&'static str, Severity, Q, Note);

fn spindle(motion: &LatheMotion, lathe: &Lathe<'_>) -> Vec<Found> {
    let (least, most) = lathe.spindle.ends();
    let is_stepped = matches!(lathe.spindle, Spindle::Steps(_));
    let quantity = |of_range| if is_stepped { Q::SpindleSpeeds } else { of_range };
    match motion.modes.speed {
        Some(LatheSpeed::Cutting { .. }) if is_stepped => {
            let note = Note::new("lathe-spindle-stepped");
            vec![("lathe-spindle-stepped", Severity::Doubtful, Q::SpindleSpeeds, note)]
        }
        Some(LatheSpeed::Spindle(speed)) => {
            let told = |code, severity, quantity, limit: RevsPerMinute| {
                let note = Note::new(code).with("speed", round_to(speed.0, 1)).with("limit", limit.0);
                vec![(code, severity, quantity, note)]
            };
            if speed.0 > most.0 * (1.0 + ROUNDING) {
                return told("lathe-spindle-fast", Severity::Wrong, quantity(Q::SpindleSpeedMax), most);
            }
            if speed.0 < least.0 * (1.0 - ROUNDING) {
                return told("lathe-spindle-slow", Severity::Wrong, quantity(Q::SpindleSpeedMin), least);
            }
            let step = lathe.spindle.at_most(RevsPerMinute(speed.0 * (1.0 + ROUNDING)));
            if is_stepped && step.0 < speed.0 * (1.0 - ROUNDING) {
                return told("lathe-spindle-step", Severity::Doubtful, Q::SpindleSpeeds, step);
            }
            Vec::new()
        }
        _ => Vec::new(),
    }
}

/// The slowest and the fastest spindle of a motion, by its programmed speed.
pub(super) fn turns(motion: &LatheMotion) -> Option<(RevsPerMinute, RevsPerMinute)> {
    match motion.modes.speed? {
        LatheSpeed::Spindle(speed) => Some((speed, speed)),
        LatheSpeed::Cutting { speed, limit } => {
            let radii = [motion.from.radius_mm?, motion.to.radius_mm?].map(f64::abs);
            let limit = limit.map_or(f64::INFINITY, |limit| limit.0);
            let at = |radius: f64| {
                let turns = rpm_at(speed, Micrometres::from_mm_rounded(2.0 * radius));
                RevsPerMinute(turns.0.min(limit))
            };
            Some((at(radii[0].max(radii[1])), at(radii[0].min(radii[1]))))
        }
    }
}

/// The feed of a motion per revolution at a spindle, mm.
pub(super) fn per_turn(motion: &LatheMotion, turns: RevsPerMinute) -> Option<f64> {
    match motion.act {
        LatheAct::Thread { lead, .. } => Some(lead.0),
        LatheAct::Feed { feed } | LatheAct::Arc { feed, .. } => Some(match feed {
            LatheFeed::PerRevolution(feed) => feed.0,
            LatheFeed::PerMinute(rate) => rate.0 / turns.0,
        }),
        _ => None,
    }
}

fn drives(motion: &LatheMotion, lathe: &Lathe<'_>) -> Option<Found> {
    let (slow, fast) = turns(motion)?;
    let rate = |turns: RevsPerMinute| per_turn(motion, turns).map(|feed| feed * turns.0);
    let (least, most) = (rate(slow)?, rate(fast)?);
    let (dz, dr) = (motion.to.z_mm? - motion.from.z_mm?, motion.to.radius_mm? - motion.from.radius_mm?);
    let length = libm::hypot(dz, dr);
    let share = |along: f64| if matches!(motion.act, LatheAct::Arc { .. }) { 1.0 } else { along.abs() / length };
    let told = |code, quantity, rate: f64, limit: MillimetresPerMinute| {
        let note = Note::new(code).with("rate", round_to(rate, 1)).with("limit", limit.0);
        (code, Severity::Wrong, quantity, note)
    };
    if length < 1e-6 || !most.is_finite() {
        return None;
    }
    let axes = [(dz, lathe.feed_z, Q::FeedMinZ, Q::FeedMaxZ), (dr, lathe.feed_x, Q::FeedMinX, Q::FeedMaxX)];
    let main = if dz.abs() >= dr.abs() { 0 } else { 1 };
    axes.into_iter().enumerate().find_map(|(axis, (along, (slowest, fastest), of_least, of_most))| {
        let (least, most) = (least * share(along), most * share(along));
        if most > fastest.0 * (1.0 + ROUNDING) {
            return Some(told("lathe-feed-fast", of_most, most, fastest));
        }
        (axis == main && least < slowest.0 * (1.0 - ROUNDING))
            .then(|| told("lathe-feed-slow", of_least, least, slowest))
    })
}
