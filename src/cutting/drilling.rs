//! Drilling, drilling out, core drilling and centring.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::Input;
use crate::note::{Because, Note};
use crate::plan::{CuttingMethod, Operation};
use crate::shop::Shop;
use crate::units::{MetresPerMinute, MillimetresPerRev, Minutes};

use super::feed::{self, Feed};
use super::figures::{self, coolant, number};
use super::{Cut, Draft, Loads, Motion, PowerLaw, card, factors};

/// The operation by which the coefficient tables know this transition: centring is drilling.
fn table_operation(operation: Operation) -> &'static str {
    match operation {
        Operation::DrillOut => "drill-out",
        Operation::CoreDrill => "core-drill",
        _ => "drill",
    }
}

/// Conditions by the empirical formulas (Косилова/Мещеряков т.2, tables 28-32; facts 1).
///
/// - V = Cv·D^q / (T^m·t^x·s^y)·Kv, m/min, with Kv = Kmv·Klv·Kpv; drilling has no t term (x = 0);
/// - M = 10·Cm·D^q·t^x·s^y·Kp, N·m; P = 10·Cp·D^q·t^x·s^y·Kp, N;
/// - D, t in mm, s in mm/rev, T in min.
pub(super) fn draft(cut: &Cut<'_>, taken: Option<MillimetresPerRev>, shop: &Shop<'_>) -> Tried<Draft> {
    by_tables(cut, feed::tabulated(cut, shop)?.or(in_table(cut, taken, shop)?), shop)
}

/// A feed as the tables would have it: the cards raise theirs by a factor of the material afterwards.
fn in_table(
    cut: &Cut<'_>,
    taken: Option<MillimetresPerRev>,
    shop: &Shop<'_>,
) -> Result<Option<MillimetresPerRev>, KnowledgeError> {
    match taken {
        Some(feed) if by_card(cut, shop) => Ok(Some(MillimetresPerRev(feed.0 / card::feed_factor(shop)?))),
        taken => Ok(taken),
    }
}

/// Whether the normative cards are asked: they know nothing of core drills.
fn by_card(cut: &Cut<'_>, shop: &Shop<'_>) -> bool {
    shop.method == CuttingMethod::Card && cut.operation != Operation::CoreDrill
}

/// The same for a feed found elsewhere: the tools that have no coefficients of their own take this way.
pub(super) fn by_tables(cut: &Cut<'_>, feed: Feed, shop: &Shop<'_>) -> Tried<Draft> {
    let mut because = feed.because;
    let base = base(cut, feed.feed, shop)?;
    because.extend(base.because.clone());
    let mut force = 1.0;
    if base.own_loads {
        let (factor, reason) = factors::material_force("drilling", cut.tool_material, shop)?;
        force = factor;
        because.push(reason);
    }
    let scaled = |law: PowerLaw| PowerLaw { factor: law.factor * force, ..law };
    let loads = Loads { torque: base.loads.torque.map(scaled), thrust: base.loads.thrust.map(scaled) };
    let card = by_card(cut, shop);
    let mut corrections = Vec::new();
    // A row that stands in is that of its own reference material; the factor of ours would not fit it. The cards have
    // a material factor of their own.
    if base.own_speed && !card {
        corrections.push(factors::material_speed("drilling", cut.tool_material, shop)?);
    }
    corrections.push(factors::surface(cut.surface, shop)?);
    if cut.operation == Operation::Drill {
        corrections.push(factors::by_depth("depth-speed-factor", cut, shop)?);
    }
    let mut factor = 1.0;
    for (correction, reason) in corrections {
        factor *= correction;
        because.push(reason);
    }
    if card {
        return Ok(card::draft(cut, feed.feed, &base, (loads, factor), because, shop)?);
    }
    let speed = base.speed * factor;
    Ok(Draft {
        feed: feed.feed,
        speed: MetresPerMinute(speed),
        tool_life: base.tool_life,
        life_exponent: base.life_exponent,
        coolant: base.coolant,
        loads,
        motion: Motion::along_axis(cut),
        because,
        card: None,
        rounds: None,
    })
}

/// Speed and loads before any correction: for steel at σB = 750 MPa.
#[derive(Clone, Debug)]
pub(super) struct Base {
    /// m/min.
    pub speed: f64,
    /// Whether the speed row is the material's own.
    pub own_speed: bool,
    pub tool_life: Minutes,
    /// m of V ~ 1/T^m.
    pub life_exponent: f64,
    /// Whether the speed is for cutting with coolant, where the row says.
    pub coolant: Option<bool>,
    pub loads: Loads,
    /// Whether the row of loads is the material's own.
    pub own_loads: bool,
    pub because: Vec<Because>,
}

fn base(cut: &Cut<'_>, feed: MillimetresPerRev, shop: &Shop<'_>) -> Tried<Base> {
    let operation = ("operation", Input::Text(table_operation(cut.operation)));
    let tool = ("tool_material", Input::Text(cut.tool_material));
    let (d, t) = (cut.diameter.to_mm(), cut.depth_of_cut());

    let (tool_life, mut because) = factors::tool_life(table_operation(cut.operation), cut, shop)?;
    let speed = figures::ask("cutting-speed", &[operation, tool, ("feed", figures::feed_input(feed))], shop)?;
    let coefficient = |name: &str| number(speed.row, name);
    let (cv, q, x, y, m) =
        (coefficient("cv")?, coefficient("q")?, coefficient("x")?, coefficient("y")?, coefficient("m")?);
    let v = cv * libm::pow(d, q) / (libm::pow(tool_life, m) * libm::pow(t, x) * libm::pow(feed.0, y));
    let note = Note::new("speed-coefficients").with("cv", cv).with("q", q).with("x", x).with("y", y).with("m", m);
    because.extend(speed.because(note));

    let mut loads = Loads::default();
    let mut own_loads = true;
    // Without a row of loads the transition is still cut; its forces are left out and not guessed.
    if let Ok(figures) = Refusal::split(figures::ask("torque-and-thrust", &[operation, tool], shop))? {
        let row = figures.row;
        let law = |c: &str, q: &str, x: &str, y: &str| -> Result<PowerLaw, KnowledgeError> {
            let factor = 10.0 * number(row, c)? * libm::pow(d, number(row, q)?) * libm::pow(t, number(row, x)?);
            Ok(PowerLaw::of_feed(factor, number(row, y)?))
        };
        loads.torque = Some(law("cm", "qm", "xm", "ym")?);
        loads.thrust = Some(law("cp", "qp", "xp", "yp")?);
        own_loads = figures.own();
        because.extend(figures.because(Note::new("load-coefficients")));
    }
    Ok(Base {
        speed: v,
        own_speed: speed.own(),
        tool_life: Minutes(tool_life),
        life_exponent: m,
        coolant: coolant(speed.row),
        loads,
        own_loads,
        because,
    })
}
