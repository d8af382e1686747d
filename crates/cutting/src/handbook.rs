//! The handbook's formulas for a feed, depth of cut, diameter and tool life that were chosen elsewhere.

use crate::error::{Refusal, Tried};
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::reason::Uncut;
use crate::units::{MillimetresPerRev, Minutes};

use crate::tables::cutting::{Coefficients, Process};

use super::figures::Asking;
use super::laws::{self, LoadLaw, SpeedLaw};
use super::{Cut, drilling, factors, feed, reaming};

/// The formulas of one transition, with the corrections for its material, surface and depth.
#[derive(Clone, Debug)]
pub struct Handbook {
    /// The law of the speed, without corrections.
    pub speed: SpeedLaw,
    /// Kmv, Kpv and Klv, as far as the transition has them.
    pub speed_factors: Vec<f64>,
    /// The rows behind the speed.
    pub speed_because: Vec<Because>,
    /// The laws of torque and thrust, without Kp; absent if no row is known.
    pub loads: Option<(LoadLaw, LoadLaw)>,
    /// Kp.
    pub load_factor: f64,
    /// The rows behind the loads.
    pub loads_because: Vec<Because>,
}

impl Handbook {
    /// Kv = Kmv·Kpv·Klv.
    pub fn speed_factor(&self) -> f64 {
        self.speed_factors.iter().product()
    }
}

/// The name of a transition in the tables of speed and tool life; none for transitions that they lack (boring,
/// milling, tapping, and tools with figures of other tools).
pub fn operation_of(operation: Operation) -> Option<Coefficients> {
    match operation {
        Operation::CentreDrill | Operation::Drill | Operation::DrillOut | Operation::CoreDrill => {
            Some(drilling::table_operation(operation))
        }
        Operation::RoughReam | Operation::FinishReam => Some(Coefficients::Ream),
        _ => None,
    }
}

/// The tool life for which the handbook gives speeds, by the table `tool-life`; none if the transition has none.
///
/// # Errors
/// The tables have no figure for this material or diameter, or the knowledge base has no answer at all.
pub fn tool_life<'k>(cut: &Cut, shop: &impl Asking<'k>) -> Tried<Option<(Minutes, Vec<Because>)>, Uncut> {
    operation_of(cut.operation).map(|operation| factors::tool_life(operation, cut, shop)).transpose()
}

/// The formulas of a cut at a feed; none for transitions that they do not cover. Reamers have no loads here: those
/// need the number of teeth.
///
/// # Errors
/// As for [`tool_life`].
pub fn formulas<'k>(cut: &Cut, feed: MillimetresPerRev, shop: &impl Asking<'k>) -> Tried<Option<Handbook>, Uncut> {
    let Some(operation) = operation_of(cut.operation) else { return Ok(None) };
    let reams = operation == Coefficients::Ream;
    let (speed, figures) = laws::speed(operation, cut.tool_material, feed, shop)?;
    let note = Note::new("speed-coefficients").with("cv", speed.cv).with("q", speed.q).with("x", speed.x);
    let mut speed_because = figures.because(note.with("y", speed.y).with("m", speed.m));
    let corrections = match reams {
        true if figures.is_own_group() => vec![factors::material_speed(Process::Drilling, cut.tool_material, shop)?],
        true => Vec::new(),
        false => drilling::speed_corrections(cut, figures.is_own_group(), shop)?.0,
    };
    let speed_factors = corrections.iter().map(|(factor, _)| *factor).collect();
    speed_because.extend(corrections.into_iter().map(|(_, reason)| reason));

    let (mut loads, mut load_factor, mut loads_because) = (None, 1.0, Vec::new());
    if !reams && let Ok((torque, thrust, figures)) = Refusal::split(laws::loads(operation, cut.tool_material, shop))? {
        loads = Some((torque, thrust));
        loads_because = figures.because(Note::new("load-coefficients"));
        if figures.is_own_group() {
            let (factor, reason) = factors::material_force(Process::Drilling, cut.tool_material, shop)?;
            load_factor = factor;
            loads_because.push(reason);
        }
    }
    Ok(Some(Handbook { speed, speed_factors, speed_because, loads, load_factor, loads_because }))
}

/// The feed of a transition by the tables, with the rows behind it.
///
/// # Errors
/// As for [`tool_life`].
pub fn feed<'k>(cut: &Cut, shop: &impl Asking<'k>) -> Tried<(MillimetresPerRev, Vec<Because>), Uncut> {
    let found =
        if cut.operation.is_reaming() { reaming::corrected_feed(cut, shop)? } else { feed::tabulated(cut, shop)? };
    Ok((found.feed, found.because))
}
