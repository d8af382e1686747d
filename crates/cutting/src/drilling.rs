//! Drilling, drilling out, core drilling and centring.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::note::{Because, Note};
use crate::plan::{CuttingMethod, Operation};
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::tables::cutting::{Coefficients, Process};
use crate::units::{MetresPerMinute, MillimetresPerRev, Minutes};

use super::card::CardDoubt;
use super::factors::{ByDepth, Factor};
use super::feed::{self, Feed};
use super::figures::Asking;
use super::laws::{self, LoadLaw, SpeedLaw};
use super::{Cut, CutMotion, DraftConditions, Loads, PowerLaw, card, factors};

/// The name of this transition in the coefficient tables: centring is drilling.
pub(super) fn table_operation(operation: Operation) -> Coefficients {
    match operation {
        Operation::DrillOut => Coefficients::DrillOut,
        Operation::CoreDrill => Coefficients::CoreDrill,
        _ => Coefficients::Drill,
    }
}

/// Conditions by the empirical formulas (Косилова/Мещеряков т.2, tables 28-32; facts 1).
///
/// - V = Cv·D^q / (T^m·t^x·s^y)·Kv, m/min, with Kv = Kmv·Klv·Kpv; drilling has no t term (x = 0);
/// - M = 10·Cm·D^q·t^x·s^y·Kp, N·m; P = 10·Cp·D^q·t^x·s^y·Kp, N;
/// - D, t in mm, s in mm/rev, T in min.
pub(super) fn draft(cut: &Cut, taken: Option<MillimetresPerRev>, shop: &Shop<'_>) -> Tried<DraftConditions, Uncut> {
    by_tables(cut, feed::tabulated(cut, shop)?.with_feed(in_table(cut, taken, shop)?), shop)
}

/// A feed as in the tables: the cards raise theirs by a material factor afterwards.
fn in_table(
    cut: &Cut,
    taken: Option<MillimetresPerRev>,
    shop: &Shop<'_>,
) -> Result<Option<MillimetresPerRev>, KnowledgeError> {
    match taken {
        Some(feed) if by_card(cut, shop) => Ok(Some(MillimetresPerRev(feed.0 / card::feed_factor(shop)?))),
        taken => Ok(taken),
    }
}

/// Whether the normative cards are used: they have no core drills.
fn by_card(cut: &Cut, shop: &Shop<'_>) -> bool {
    shop.method == CuttingMethod::Card && cut.operation != Operation::CoreDrill
}

/// The same for a feed found elsewhere, as for tools without coefficients of their own.
pub(super) fn by_tables(cut: &Cut, feed: Feed, shop: &Shop<'_>) -> Tried<DraftConditions, Uncut> {
    let Feed { feed, mut because, mut doubts } = feed;
    let mut base = base(cut, feed, shop)?;
    because.append(&mut base.because);
    let mut force = 1.0;
    if base.own_loads {
        let (factor, reason) = factors::material_force(Process::Drilling, cut.tool_material, shop)?;
        force = factor;
        because.push(reason);
    }
    let scaled = |law: PowerLaw| PowerLaw { factor: law.factor * force, ..law };
    let loads = Loads { torque: base.loads.torque.map(scaled), thrust: base.loads.thrust.map(scaled) };
    let card = by_card(cut, shop);
    let mut factor = 1.0;
    // The cards have a material factor of their own.
    let (corrections, left_out) = speed_corrections(cut, base.own_speed && !card, shop)?;
    doubts.extend(left_out);
    for (correction, reason) in corrections {
        factor *= correction;
        because.push(reason);
    }
    if card {
        return Ok(card::draft(cut, feed, &base, (loads, factor), (because, doubts), shop)?);
    }
    let speed = base.speed * factor;
    Ok(DraftConditions {
        feed,
        speed: MetresPerMinute(speed),
        fastest: None,
        tool_life: base.tool_life,
        life_exponent: base.life_exponent,
        coolant: base.coolant,
        loads,
        motion: CutMotion::along_axis(cut),
        because,
        doubts,
        card: None,
        rounds: None,
        plunge: None,
        arcs: Vec::new(),
    })
}

/// Kv = Kmv·Kpv·Klv, and the factor that the cards leave out. A row of another group is for its own reference
/// material, so the factor of the actual material does not apply.
pub(super) fn speed_corrections<'k>(
    cut: &Cut,
    own_row: bool,
    shop: &impl Asking<'k>,
) -> Tried<(Vec<Factor>, Option<CardDoubt>), Uncut> {
    let (mut corrections, mut doubt) = (Vec::new(), None);
    if own_row {
        corrections.push(factors::material_speed(Process::Drilling, cut.tool_material, shop)?);
    }
    corrections.push(factors::surface(cut.surface, shop)?);
    if cut.operation == Operation::Drill {
        let ByDepth { factor, left_out } = factors::speed_by_depth(Coefficients::Drill, cut, shop)?;
        corrections.push(factor);
        doubt = left_out;
    }
    Ok((corrections, doubt))
}

/// Speed and loads before any correction: for steel at σB = 750 MPa.
#[derive(Clone, Debug)]
pub(super) struct Base {
    /// m/min.
    pub speed: f64,
    /// Whether the speed row belongs to the material's own group.
    pub own_speed: bool,
    pub tool_life: Minutes,
    /// m of V ~ 1/T^m.
    pub life_exponent: f64,
    /// Whether the speed is for cutting with coolant, where the row says.
    pub coolant: Option<bool>,
    pub loads: Loads,
    /// Whether the row of loads belongs to the material's own group.
    pub own_loads: bool,
    pub because: Vec<Because>,
}

fn base(cut: &Cut, feed: MillimetresPerRev, shop: &Shop<'_>) -> Tried<Base, Uncut> {
    let operation = table_operation(cut.operation);
    let (d, t) = (cut.diameter.to_mm(), cut.depth_of_cut());

    let (tool_life, mut because) = factors::tool_life(operation, cut, shop)?;
    let (law, speed) = laws::speed(operation, cut.tool_material, feed, shop)?;
    let SpeedLaw { cv, q, x, y, m } = law;
    let note = Note::new("speed-coefficients").with("cv", cv).with("q", q).with("x", x).with("y", y).with("m", m);
    because.extend(speed.because(note));

    let mut loads = Loads::default();
    let mut own_loads = true;
    // Without a row of loads the transition is cut all the same; its forces are left out, not guessed.
    if let Ok((torque, thrust, figures)) = Refusal::split(laws::loads(operation, cut.tool_material, shop))? {
        let of_feed = |law: LoadLaw| PowerLaw::of_feed(law.without_feed(d, t), law.y);
        loads = Loads { torque: Some(of_feed(torque)), thrust: Some(of_feed(thrust)) };
        own_loads = figures.is_own_group();
        because.extend(figures.because(Note::new("load-coefficients")));
    }
    Ok(Base {
        speed: law.at(d, t, feed.0, tool_life.0),
        own_speed: speed.is_own_group(),
        tool_life,
        life_exponent: m,
        coolant: speed.row.coolant,
        loads,
        own_loads,
        because,
    })
}
