//! Checks of the tool in a transition: its speed, the strength of a thin drill, the stiffness of a boring bar.
//!
//! A tool that is in no catalog, which a plan by hand may name, is not checked.

use crate::chip_room::{Drilling, chip_room};
use crate::error::KnowledgeError;
use crate::plan::{Operation, Transition};
use crate::practice_speed::{PracticeSpeed, practice_group};
use crate::shop::Shop;
use crate::tables::cutting::DrillStrength;
use crate::tables::practice::{ProofLimit, ProofLimits, SpecificCuttingForceFor};
use crate::tables::tools::CutterRow;
use crate::units::{Micrometres, NewtonMetres, Newtons};
use technolog_knowledge::units::Brinell;
use technolog_knowledge::vocabulary::ToolMaterial;

use super::Fault;
use super::loads::SLACK;

/// The conditions of speed and strength that do not hold.
pub(crate) fn faults(transition: &Transition, shop: &Shop<'_>) -> Result<Vec<Fault>, KnowledgeError> {
    let found = [
        too_hard(transition, shop)?,
        too_fast(transition, shop)?,
        twists(transition, shop)?,
        buckles(transition, shop)?,
        flutes_close(transition, shop)?,
        slender(transition, shop)?,
        out_of_range(transition, shop)?,
        beyond_machine(transition, shop),
        too_thick(transition, shop)?,
    ];
    Ok(found.into_iter().flatten().collect())
}

/// The deflection of a boring bar, on the diameter, when its stock varies; none for other tools.
///
/// Spring = L³ / (3·E·I) · share · kc1·s^(1-mc) · spread, mm, with I = π·d⁴/64; the bar's reach L and diameter d in mm, E in
/// MPa, s in mm/rev (tables `proof-limits`, `specific-cutting-force`).
pub(crate) fn spring(
    transition: &Transition,
    spread: Micrometres,
    shop: &Shop<'_>,
) -> Result<Option<Micrometres>, KnowledgeError> {
    let Some(Bar { reach, diameter: bar, carbide, .. }) = bar(transition, shop)? else { return Ok(None) };
    let Some(group) = practice_group(&shop.material, shop.knowledge)? else { return Ok(None) };
    let Some(force) = shop.knowledge.ask(&SpecificCuttingForceFor { vdi: group.vdi })?.winner()? else {
        return Ok(None);
    };
    let (length, diameter) = (reach.to_mm(), bar.to_mm());
    let of = if carbide { ProofLimit::CarbideBarElasticModulus } else { ProofLimit::BarElasticModulus };
    let modulus = limit(of, shop)? * 1000.0;
    let inertia = core::f64::consts::PI * diameter * diameter * diameter * diameter / 64.0;
    let compliance = length * length * length / (3.0 * modulus * inertia);
    let feed = transition.conditions.feed_mm_per_rev.0;
    // Radial force per mm of depth of cut, N.
    let radial = limit(ProofLimit::BarRadialShare, shop)? * force.kc1.0.to_f64() * libm::pow(feed, 1.0 - force.mc);
    Ok(Some(Micrometres::from_mm_rounded(compliance * radial * spread.to_mm())))
}

pub(crate) fn limit(name: ProofLimit, shop: &Shop<'_>) -> Result<f64, KnowledgeError> {
    Ok(shop.knowledge.need(name.name(), |row: &ProofLimits<'_>| row.name.is(name))?.value)
}

/// Checks that high-speed steel is not asked to cut what is as hard as a tool.
fn too_hard(transition: &Transition, shop: &Shop<'_>) -> Result<Option<Fault>, KnowledgeError> {
    let steel = of_steel(transition, shop);
    let (hardness, limit) = (Brinell(shop.material.hardness), limit(ProofLimit::HardestForSteel, shop)?);
    let operation = transition.operation;
    Ok((steel && hardness.0.to_f64() > limit).then_some(Fault::TooHard { operation, hardness, limit }))
}

/// Tells once of a hole whose tools of high-speed steel cut what is harder than they usually do.
pub(crate) fn hard(transitions: &[Transition], shop: &Shop<'_>) -> Result<Option<Fault>, KnowledgeError> {
    let hardness = Brinell(shop.material.hardness);
    let (usual, limit) = (limit(ProofLimit::HardForSteel, shop)?, limit(ProofLimit::HardestForSteel, shop)?);
    let own = hardness.0.to_f64();
    let steel = transitions.iter().filter(|one| !one.elsewhere).any(|one| of_steel(one, shop));
    Ok((steel && own > usual && own <= limit).then_some(Fault::Hard { hardness, usual, limit }))
}

/// Whether the tool of a transition is of high-speed steel; of one that is in no catalog nothing is known.
fn of_steel(transition: &Transition, shop: &Shop<'_>) -> bool {
    let table = shop.shelf.cutters().iter().find(|table| table.table.id == transition.tool.table);
    table.is_some_and(|table| table.head.material == ToolMaterial::HighSpeedSteel)
}

/// Checks that the speed is not above shop practice for such a tool.
fn too_fast(transition: &Transition, shop: &Shop<'_>) -> Result<Option<Fault>, KnowledgeError> {
    let Some(table) = shop.shelf.cutters().iter().find(|table| table.table.id == transition.tool.table) else {
        return Ok(None);
    };
    let operation = transition.operation;
    let Some(practice) = PracticeSpeed::of(operation, table.head.material, &shop.material, shop.knowledge)? else {
        return Ok(None);
    };
    let (value, usual) = (transition.conditions.speed_m_per_min, practice.high);
    let share = limit(ProofLimit::SpeedOverPractice, shop)?;
    Ok((value.0 > usual.0 * share * SLACK).then_some(Fault::TooFast { operation, value, usual, share }))
}

/// The torque exceeds the strength of a thin drill.
///
/// Permissible torque = k·d³·τ / 1000, N·m, with the polar section modulus k·d³, mm³, and the shear stress τ, MPa (table
/// `drill-strength`).
fn twists(transition: &Transition, shop: &Shop<'_>) -> Result<Option<Fault>, KnowledgeError> {
    let operation = transition.operation;
    let drilled = matches!(operation, Operation::CentreDrill | Operation::Drill | Operation::DrillOut);
    let Some(value) = transition.conditions.torque_n_m.filter(|_| drilled) else { return Ok(None) };
    let material = shop.shelf.cutters().iter().find(|table| table.table.id == transition.tool.table);
    let Some(material) = material.map(|table| table.head.material) else { return Ok(None) };
    let of_tool = |row: &DrillStrength<'_>| row.tool_material == material;
    let Some(strength) = shop.knowledge.find(of_tool)? else { return Ok(None) };
    let drill = transition.tool.diameter_mm;
    if drill >= strength.below_diameter {
        return Ok(None);
    }
    let d = drill.to_mm();
    let limit = NewtonMetres(strength.modulus_factor * d * d * d * strength.shear_stress.0.to_f64() / 1000.0);
    Ok((value.0 > limit.0 * SLACK).then_some(Fault::Twists { operation, drill, value, limit }))
}

/// The thrust exceeds the buckling load of a long drill.
///
/// Permissible thrust = share·π²·E·v·d⁴ / (μ·L)², N, with E in MPa, the drill's diameter d and the length L of its flutes in
/// mm (Euler; table `proof-limits`).
fn buckles(transition: &Transition, shop: &Shop<'_>) -> Result<Option<Fault>, KnowledgeError> {
    let operation = transition.operation;
    let Some(value) = transition.conditions.axial_force_n.filter(|_| operation == Operation::Drill) else {
        return Ok(None);
    };
    let Some(flutes) = row(transition, shop)?.and_then(|row| row.flute_length) else { return Ok(None) };
    let drill = transition.tool.diameter_mm;
    let (d, column) = (drill.to_mm(), flutes.to_mm() * limit(ProofLimit::DrillColumn, shop)?);
    let stiffness = limit(ProofLimit::BarElasticModulus, shop)? * 1000.0 * limit(ProofLimit::DrillSection, shop)?;
    let pi = core::f64::consts::PI;
    let euler = pi * pi * stiffness * d * d * d * d / (column * column);
    let limit = Newtons(euler * limit(ProofLimit::DrillBucklingShare, shop)?);
    Ok((value.0 > limit.0 * SLACK).then_some(Fault::Buckles { operation, drill, flutes, value, limit }))
}

/// Checks that enough of a drill's flutes stays open over the metal that it enters.
fn flutes_close(transition: &Transition, shop: &Shop<'_>) -> Result<Option<Fault>, KnowledgeError> {
    let (operation, drill) = (transition.operation, transition.diameter_mm);
    let step_drill = transition.also_diameter_mm.is_some();
    let table = shop.shelf.cutters().iter().find(|table| table.table.id == transition.tool.table);
    let Some(angle) = table.and_then(|table| table.head.point_angle).filter(|_| !step_drill) else { return Ok(None) };
    let Some(flutes) = row(transition, shop)?.and_then(|row| row.flute_length) else { return Ok(None) };
    let depth = transition.depth_mm - transition.start_mm;
    let half = (angle.to_f64() / 2.0).to_radians();
    let point = Micrometres::from_mm_rounded(drill.to_mm() / 2.0 / libm::tan(half));
    let drilling = Drilling { operation, diameter: drill, depth, point, material_group: shop.material.group };
    let (tip, least) = (transition.end() - transition.start_mm, chip_room(&drilling, shop.knowledge)?);
    Ok((flutes - tip < least).then_some(Fault::FlutesClose { operation, drill, flutes, tip, least }))
}

/// Checks that the overhang of a boring bar is not too long for steel, for carbide, or for a damper.
fn slender(transition: &Transition, shop: &Shop<'_>) -> Result<Option<Fault>, KnowledgeError> {
    let Some(Bar { reach, diameter: bar, carbide, damped }) = bar(transition, shop)? else { return Ok(None) };
    let of = match (damped, carbide) {
        (true, _) => ProofLimit::DampedBarOverhangRatio,
        (false, true) => ProofLimit::CarbideBarOverhangRatio,
        (false, false) => ProofLimit::BarOverhangRatio,
    };
    let ratio = limit(of, shop)?;
    let operation = transition.operation;
    Ok((reach.to_mm() > bar.to_mm() * ratio).then_some(Fault::BarSlender { operation, reach, bar, ratio }))
}

/// Checks that every pass of a boring bar is set inside its range: passes take equal stock, so the first and the last one tell.
fn out_of_range(transition: &Transition, shop: &Shop<'_>) -> Result<Option<Fault>, KnowledgeError> {
    let operation = transition.operation;
    if !operation.is_boring() {
        return Ok(None);
    }
    let range = row(transition, shop)?.and_then(|row| row.diameter_min.zip(row.diameter_max));
    let Some((smallest, largest)) = range else { return Ok(None) };
    let (from, to) = (transition.from_diameter_mm, transition.diameter_mm);
    let first = from + (to - from).ratio(1, i64::from(transition.passes.max(1)));
    let outside = [to, first].into_iter().find(|set| !(smallest..=largest).contains(set));
    Ok(outside.map(|set| Fault::BarOutOfRange { operation, set, smallest, largest }))
}

/// Checks that the machine takes a tool as wide as the bar is set.
fn beyond_machine(transition: &Transition, shop: &Shop<'_>) -> Option<Fault> {
    let (operation, set) = (transition.operation, transition.diameter_mm);
    let largest = shop.machine.tool_diameter_max;
    let beyond = operation.is_boring() && !transition.elsewhere && set > largest;
    beyond.then_some(Fault::BarBeyondMachine { operation, set, largest })
}

/// Checks that a boring bar enters the hole that it widens.
fn too_thick(transition: &Transition, shop: &Shop<'_>) -> Result<Option<Fault>, KnowledgeError> {
    let (operation, hole) = (transition.operation, transition.from_diameter_mm);
    let Some(Bar { diameter: bar, .. }) = bar(transition, shop)?.filter(|_| hole > Micrometres::ZERO) else {
        return Ok(None);
    };
    Ok((bar >= hole).then_some(Fault::BarEnters { operation, bar, hole }))
}

/// The stiffness of a boring bar: how far it goes out, and what it is made of.
struct Bar {
    reach: Micrometres,
    diameter: Micrometres,
    carbide: bool,
    damped: bool,
}

/// The boring bar of a transition.
fn bar(transition: &Transition, shop: &Shop<'_>) -> Result<Option<Bar>, KnowledgeError> {
    if !transition.operation.is_boring() {
        return Ok(None);
    }
    Ok(row(transition, shop)?.and_then(|row| {
        let (carbide, damped) = (row.carbide_bar == Some(true), row.damped_bar == Some(true));
        Some(Bar { reach: row.reach?, diameter: row.bar_diameter?, carbide, damped })
    }))
}

/// The row of the cutter of a transition.
pub(crate) fn row<'s>(
    transition: &Transition,
    shop: &'s Shop<'_>,
) -> Result<Option<&'s CutterRow<'s>>, KnowledgeError> {
    let Some(table) = shop.shelf.cutters().iter().find(|table| table.table.id == transition.tool.table) else {
        return Ok(None);
    };
    let named = |row: &&CutterRow<'_>| row.designations().any(|name| name == transition.tool.designation);
    Ok(table.rows()?.iter().find(named))
}
