//! Drilling, drilling out, core drilling and centring.

use crate::error::KnowledgeError;
use crate::knowledge::Input;
use crate::note::{Because, Note};
use crate::plan::{CuttingMethod, Operation};
use crate::shop::Shop;
use crate::units::{MetresPerMinute, Minutes};

use super::factors::{self, number};
use super::{Cut, Draft, Loads, PowerLaw, card, feed};

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
pub(super) fn draft(cut: &Cut<'_>, shop: &Shop<'_>) -> Result<Result<Draft, Note>, KnowledgeError> {
    let feed = match feed::tabulated(cut, shop)? {
        Ok(feed) => feed,
        Err(note) => return Ok(Err(note)),
    };
    let mut because = feed.because;
    let base = match base(cut, feed.feed, shop)? {
        Ok(base) => base,
        Err(note) => return Ok(Err(note)),
    };
    because.extend(base.because.clone());
    if shop.method == CuttingMethod::Card && cut.operation != Operation::CoreDrill {
        return card::draft(cut, feed.feed, &base, because, shop).map(Ok);
    }
    let mut speed = base.speed;
    let mut corrections = vec![factors::material_speed("drilling", cut, shop)?, factors::surface(cut, shop)?];
    if cut.operation == Operation::Drill {
        corrections.push(factors::by_depth("depth-speed-factor", cut, shop)?);
    }
    for correction in corrections {
        match correction {
            Ok((factor, reason)) => {
                speed *= factor;
                because.push(reason);
            }
            Err(note) => return Ok(Err(note)),
        }
    }
    let force = match factors::material_force("drilling", cut, shop)? {
        Ok((factor, reason)) => {
            because.push(reason);
            factor
        }
        Err(note) => return Ok(Err(note)),
    };
    let scaled = |law: PowerLaw| PowerLaw { factor: law.factor * force, ..law };
    let loads = Loads { torque: base.loads.torque.map(scaled), thrust: base.loads.thrust.map(scaled), power: None };
    Ok(Ok(Draft {
        feed: feed.feed,
        speed: MetresPerMinute(speed),
        tool_life: base.tool_life,
        loads,
        because,
        card: None,
    }))
}

/// Speed and loads before any correction: for steel at σB = 750 MPa.
#[derive(Clone, Debug)]
pub(super) struct Base {
    /// m/min.
    pub speed: f64,
    pub tool_life: Minutes,
    pub loads: Loads,
    pub because: Vec<Because>,
}

fn base(
    cut: &Cut<'_>,
    feed: crate::units::MillimetresPerRev,
    shop: &Shop<'_>,
) -> Result<Result<Base, Note>, KnowledgeError> {
    let operation = Input::Text(table_operation(cut.operation));
    let group = Input::Text(shop.material.group);
    let tool = Input::Text(cut.tool_material);
    let (d, t) = (cut.diameter.to_mm(), cut.depth_of_cut());

    let (tool_life, life) = match factors::tool_life(table_operation(cut.operation), cut, shop)? {
        Ok(life) => life,
        Err(note) => return Ok(Err(note)),
    };

    let speed_table = shop.knowledge.table("cutting-speed")?;
    let speed = speed_table.decide(&[
        ("operation", operation),
        ("material_group", group),
        ("tool_material", tool),
        ("feed", feed::feed_input(feed)),
    ])?;
    let Some(speed) = speed.winner() else { return Ok(Err(factors::missing(speed_table, shop))) };
    let (cv, q, x, y, m) =
        (number(speed, "cv")?, number(speed, "q")?, number(speed, "x")?, number(speed, "y")?, number(speed, "m")?);
    let v = cv * libm::pow(d, q) / (libm::pow(tool_life, m) * libm::pow(t, x) * libm::pow(feed.0, y));

    let mut because = vec![
        life,
        Because::row(
            speed,
            Note::new("speed-coefficients").with("cv", cv).with("q", q).with("x", x).with("y", y).with("m", m),
        ),
    ];
    let load_table = shop.knowledge.table("torque-and-thrust")?;
    let load = load_table.decide(&[("operation", operation), ("material_group", group), ("tool_material", tool)])?;
    let loads = match load.winner() {
        None => Loads::default(),
        Some(row) => {
            let law = |c: &str, q: &str, x: &str, y: &str| -> Result<PowerLaw, KnowledgeError> {
                let factor = 10.0 * number(row, c)? * libm::pow(d, number(row, q)?) * libm::pow(t, number(row, x)?);
                Ok(PowerLaw { factor, exponent: number(row, y)? })
            };
            because.push(Because::row(row, Note::new("load-coefficients")));
            Loads {
                torque: Some(law("cm", "qm", "xm", "ym")?),
                thrust: Some(law("cp", "qp", "xp", "yp")?),
                power: None,
            }
        }
    };
    Ok(Ok(Base { speed: v, tool_life: Minutes(tool_life), loads, because }))
}
