//! Loads of a transition compared with the machine's limits, with a margin.

use crate::error::KnowledgeError;
use crate::plan::Transition;
use crate::shop::Shop;
use crate::tables::rules::{Load, LoadMarginFor};

use super::Fault;

/// A load at its limit counts as within it, because limits are converted to feeds and back.
pub(crate) const SLACK: f64 = 1.001;

/// The loads of a transition that exceed their share of the machine's limits.
pub(crate) fn faults(transition: &Transition, shop: &Shop<'_>) -> Result<Vec<Fault>, KnowledgeError> {
    let (machine, conditions) = (&shop.machine, &transition.conditions);
    let loads = [
        (Load::Thrust, conditions.axial_force_n.map(|force| force.0), machine.thrust.0),
        (Load::Torque, conditions.torque_n_m.map(|torque| torque.0), machine.spindle_torque.0),
        (Load::Power, conditions.power_kw.map(|power| power.0), machine.spindle_power.0),
    ];
    let mut faults = Vec::new();
    for (load, value, limit) in loads {
        let Some(value) = value else { continue };
        let share = shop.knowledge.ask(&LoadMarginFor { load })?.need(load.name())?.share;
        if value > limit * share * SLACK {
            faults.push(Fault::Overload { operation: transition.operation, load, value, limit, share });
        }
    }
    Ok(faults)
}
