//! The normative cards of the worked example, regenerated.
//!
//! Only three points of the cards are known (table `card-points`). At them the cards are the same power
//! laws evaluated for steel of about 815 MPa: speed 0.928 of the formula, drilling thrust 1.069 of it
//! (facts 2.1). Drilling-out forces of the card lie 23 % (thrust) and 15 % (power) below the formula, on
//! one point only; the formula's are kept there, being the safe side, and the plan says so.

use crate::error::KnowledgeError;
use crate::material::Material;
use crate::note::{Because, Figure, Note};
use crate::plan::{CardPoint, Operation};
use crate::shop::Shop;
use crate::tables::cutting::{CardCalibration, CardCorrections, CardFactor, CardPoints, CardRatio};
use crate::units::{Kilowatts, MetresPerMinute, MillimetresPerRev, NewtonMetres, Newtons, round_to};

use super::drilling::Base;
use super::{Cut, CutMotion, DraftConditions, Loads, PowerLaw, power_of, rpm_at};

/// What the cards do not contain, so that a plan by cards needs another source there.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum CardDoubt {
    /// At a known point of drilling out, the forces of the card, N and kW, differ from those of the formula that are
    /// used.
    ForcesDiffer { speed: f64, thrust: f64, power: f64 },
    /// The depth factors of the card are not available; that of the handbook would be `factor`, at `ratio` diameters.
    WithoutDepth { table: String, ratio: f64, factor: f64 },
    /// The card's factors are those of the worked example's grade.
    OtherGrade { material: String, example: String },
}

impl CardDoubt {
    /// The sentence.
    pub fn note(&self) -> Note {
        match self {
            Self::ForcesDiffer { speed, thrust, power } => point("card-point-forces-differ", [*speed, *thrust, *power]),
            Self::WithoutDepth { table, ratio, factor } => Note::new("card-without-depth")
                .with("table", table)
                .with("ratio", round_to(*ratio, 2))
                .with("factor", factor),
            Self::OtherGrade { material, example } => {
                Note::new("card-other-grade").with("material", material).with("example", example)
            }
        }
    }
}

/// The figures of a card point: speed, thrust and power.
fn point(code: &'static str, [speed, thrust, power]: [f64; 3]) -> Note {
    Note::new(code).with("speed", speed).with("thrust", thrust).with("power", power)
}

/// Conditions by the card: its point for steel, then the worked example's factors of the material group. `loads` are
/// those of the formula for the actual material. `part` is the speed factor for the skin of the blank by the
/// handbook's table: the card's own factor, Kvw, is known only where it is 1.
pub(super) fn draft(
    cut: &Cut,
    feed: MillimetresPerRev,
    base: &Base,
    (loads, part): (Loads, f64),
    (mut because, mut doubts): (Vec<Because>, Vec<CardDoubt>),
    shop: &Shop<'_>,
) -> Result<DraftConditions, KnowledgeError> {
    let mut calibrated = |ratio: CardRatio| -> Result<f64, KnowledgeError> {
        let row = shop.knowledge.need(ratio.name(), |row: &CardCalibration<'_>| row.name.is(ratio))?;
        let note = Note::new("card-calibration").with("name", Figure::word(ratio.name())).with("factor", row.factor);
        because.push(Because::row(row.row, note));
        Ok(row.factor)
    };
    let speed = MetresPerMinute(base.speed * calibrated(CardRatio::Speed)?);
    // The drilling-out forces of the card differ from the formula; one point is not enough for calibration.
    let (thrust_factor, power_factor) = match cut.operation {
        Operation::DrillOut => (1.0, 1.0),
        _ => (calibrated(CardRatio::Thrust)?, calibrated(CardRatio::Power)?),
    };
    let thrust = base.loads.thrust.map(|law| PowerLaw { factor: law.factor * thrust_factor, ..law });
    let rpm = rpm_at(speed, cut.diameter);
    let power =
        base.loads.torque.map(|law| Kilowatts(power_of(NewtonMetres(law.at(feed, speed)), rpm).0 * power_factor));
    if let Some(CardPoints { row, speed, thrust, power, .. }) = known_point(cut, feed, shop)? {
        let (speed, thrust, power) = (speed.0, thrust.0, power.0);
        let doubt = CardDoubt::ForcesDiffer { speed, thrust, power };
        let differs = cut.operation == Operation::DrillOut;
        let note = if differs { doubt.note() } else { point("card-point", [speed, thrust, power]) };
        because.push(Because::row(row, note));
        doubts.extend(differs.then_some(doubt));
    }
    let (product, material) = corrections(shop, &mut because)?;
    let of_group = |row: &CardCorrections<'_>| row.material_group == shop.material.group;
    if let Some(row) = shop.knowledge.find(of_group)?.filter(|row| row.grade != shop.material.id) {
        let example = Material::find(shop.knowledge, row.grade)?.designation().to_owned();
        let material = shop.material.designation().to_owned();
        doubts.push(CardDoubt::OtherGrade { material, example });
    }
    let force = thrust.map(|law| Newtons(law.at(feed, speed)));
    let card = CardPoint {
        feed_mm_per_rev: feed.rounded(3),
        speed_m_per_min: speed.rounded(2),
        axial_force_n: force.map(|force| force.rounded(0)),
        power_kw: power.map(|power| power.rounded(3)),
        axial_force_by_book_n: force.map(|force| Newtons(force.0 / material).rounded(0)),
        power_by_book_kw: power.map(|power| Kilowatts(power.0 / material).rounded(2)),
    };
    // The worked example divides force and power by the factor of its higher feed. The loads on machine and clamps
    // are those of the formula at the real feed.
    Ok(DraftConditions {
        feed: MillimetresPerRev(feed.0 * material),
        speed: MetresPerMinute(speed.0 * product * part),
        fastest: None,
        tool_life: base.tool_life,
        life_exponent: base.life_exponent,
        coolant: base.coolant,
        loads,
        motion: CutMotion::along_axis(cut),
        because,
        doubts,
        card: Some(card),
        rounds: None,
        plunge: None,
        arcs: Vec::new(),
    })
}

/// The printed point of the card, if this cut is one of the three, with its figures.
fn known_point<'k>(
    cut: &Cut,
    feed: MillimetresPerRev,
    shop: &Shop<'k>,
) -> Result<Option<CardPoints<'k>>, KnowledgeError> {
    let same = |point: &CardPoints<'_>| {
        point.operation == cut.operation && point.diameter == cut.diameter && (point.feed.0 - feed.0).abs() < 0.0005
    };
    Ok(shop.knowledge.find(same)?)
}

/// The factor by which the worked example raises the card's feed.
pub(super) fn feed_factor(shop: &Shop<'_>) -> Result<f64, KnowledgeError> {
    Ok(corrections(shop, &mut Vec::new())?.1)
}

/// The product of the worked example's factors, and its material factor alone; 1 for other groups.
fn corrections(shop: &Shop<'_>, because: &mut Vec<Because>) -> Result<(f64, f64), KnowledgeError> {
    let table = shop.knowledge.table_of::<CardCorrections<'_>>()?;
    let (mut product, mut material) = (1.0, 1.0);
    let mut first = None;
    for row in table.rows::<CardCorrections<'_>>() {
        let row = row?;
        if row.material_group != shop.material.group {
            continue;
        }
        product *= row.factor;
        if row.name == CardFactor::Material {
            material = row.factor;
        }
        first.get_or_insert(row.row);
    }
    because.push(match first {
        Some(row) => {
            let product = round_to(product, 3);
            Because::row(row, Note::new("card-corrections").with("product", product).with("material", material))
        }
        None => {
            let mut reason =
                Because::table(table, Note::new("card-other-material").with("material", shop.material.designation()));
            reason.unconfirmed = Some("the cards are known for the worked example's steel only".to_owned());
            reason
        }
    });
    Ok((product, material))
}
