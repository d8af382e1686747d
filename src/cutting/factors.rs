//! Corrections of speed, feed and force for material, depth, surface and tool material.

use crate::error::KnowledgeError;
use crate::knowledge::units::Unit;
use crate::knowledge::{Input, RowRef, Table};
use crate::note::{Because, Note};
use crate::shop::Shop;

use super::Cut;
use super::feed::plain;

/// A factor and the row behind it.
pub(super) type Factor = Result<(f64, Because), Note>;

/// Kmv: how the material moves the speed.
///
/// Steel: Kg·(750/σB)^nv. Grey iron (190/HB)^nv, malleable iron (150/HB)^nv. Copper and aluminium
/// alloys: a figure of their class. (Косилова/Мещеряков т.2, facts 1.5.)
pub(super) fn material_speed(process: &str, cut: &Cut<'_>, shop: &Shop<'_>) -> Result<Factor, KnowledgeError> {
    let table = shop.knowledge.table("speed-material-exponent")?;
    let answer = table.decide(&[
        ("process", Input::Text(process)),
        ("tool_material", Input::Text(cut.tool_material)),
        ("material_group", Input::Text(shop.material.group)),
        ("strength", Input::Number(shop.material.strength, Unit::Megapascal)),
    ])?;
    let Some(row) = answer.winner() else { return Ok(Err(missing(table, shop))) };
    let exponent = row.number_in("exponent", Unit::None)?;
    let reference = row.text("reference")?;
    let (strength, hardness) = (shop.material.strength.to_f64(), shop.material.hardness.to_f64());
    let ratio = match reference {
        "strength-750" => 750.0 / strength,
        "hardness-190" => 190.0 / hardness,
        "hardness-150" => 150.0 / hardness,
        _ => return alloy("speed-alloy-factor", shop),
    };
    let mut factor = libm::pow(ratio, exponent);
    if reference == "strength-750" {
        let classes = shop.knowledge.table("speed-steel-class")?;
        let answer = classes.decide(&[
            ("steel_class", Input::Text(shop.material.steel_class)),
            ("tool_material", Input::Text(cut.tool_material)),
        ])?;
        let Some(class) = answer.winner() else { return Ok(Err(missing(classes, shop))) };
        factor *= class.number_in("factor", Unit::None)?;
    }
    Ok(Ok((factor, Because::row(row, shown("material-speed-factor", factor)))))
}

/// Kmp: how the material moves forces. Steel (σB/750)^n, grey iron (HB/190)^n, malleable (HB/150)^n.
pub(super) fn material_force(process: &str, cut: &Cut<'_>, shop: &Shop<'_>) -> Result<Factor, KnowledgeError> {
    let table = shop.knowledge.table("force-material-exponent")?;
    let mut inputs = Vec::new();
    for (_, column) in table.inputs() {
        inputs.push(match column.name.as_str() {
            "process" => ("process", Input::Text(process)),
            "tool_material" => ("tool_material", Input::Text(cut.tool_material)),
            "strength" => ("strength", Input::Number(shop.material.strength, Unit::Megapascal)),
            _ => ("material_group", Input::Text(shop.material.group)),
        });
    }
    let answer = table.decide(&inputs)?;
    let Some(row) = answer.winner() else { return Ok(Err(missing(table, shop))) };
    let exponent = row.number_in("exponent", Unit::None)?;
    let (strength, hardness) = (shop.material.strength.to_f64(), shop.material.hardness.to_f64());
    let ratio = match row.text("reference")? {
        "strength-750" => strength / 750.0,
        "hardness-190" => hardness / 190.0,
        "hardness-150" => hardness / 150.0,
        _ => return alloy("force-alloy-factor", shop),
    };
    let factor = libm::pow(ratio, exponent);
    Ok(Ok((factor, Because::row(row, shown("material-force-factor", factor)))))
}

fn alloy(id: &str, shop: &Shop<'_>) -> Result<Factor, KnowledgeError> {
    let table = shop.knowledge.table(id)?;
    let known = table.inputs().any(|(_, column)| column.values.iter().any(|value| value == shop.material.alloy_class));
    if !known {
        return Ok(Err(missing(table, shop)));
    }
    let answer = table.decide(&[("alloy_class", Input::Text(shop.material.alloy_class))])?;
    let Some(row) = answer.winner() else { return Ok(Err(missing(table, shop))) };
    let factor = row.number_in("factor", Unit::None)?;
    Ok(Ok((factor, Because::row(row, shown(id, factor)))))
}

/// Klv or Kls: how the depth of the hole, in diameters, moves speed or feed.
pub(super) fn by_depth(id: &str, cut: &Cut<'_>, shop: &Shop<'_>) -> Result<Factor, KnowledgeError> {
    let table = shop.knowledge.table(id)?;
    let ratio = cut.depth.to_mm() / cut.diameter.to_mm();
    let mut inputs = vec![("depth_ratio", plain(ratio))];
    if table.inputs().any(|(_, column)| column.name == "operation") {
        inputs.push(("operation", Input::Text(cut.operation.name())));
    }
    let note = || Note::new("too-deep").with("table", &table.id).with("ratio", crate::units::round_to(ratio, 2));
    let answer = match table.decide(&inputs) {
        Ok(answer) => answer,
        Err(crate::knowledge::QueryError::OutOfDomain { .. }) => return Ok(Err(note())),
        Err(error) => return Err(error.into()),
    };
    let Some(row) = answer.winner() else { return Ok(Err(note())) };
    let factor = row.number_in("factor", Unit::None)?;
    Ok(Ok((factor, Because::row(row, shown(id, factor)))))
}

/// Tool life by the handbook's table, or by `tool-life-beyond` where that has no cell.
pub(super) fn tool_life(operation: &str, cut: &Cut<'_>, shop: &Shop<'_>) -> Result<Factor, KnowledgeError> {
    let handbook = shop.knowledge.table("tool-life")?;
    for table in [handbook, shop.knowledge.table("tool-life-beyond")?] {
        let answer = table.decide(&[
            ("operation", Input::Text(operation)),
            ("material_group", Input::Text(shop.material.group)),
            ("tool_material", Input::Text(cut.tool_material)),
            ("diameter", Input::Length(cut.diameter)),
        ])?;
        if let Some(row) = answer.winner() {
            let life = row.number_in("life", Unit::Minute)?;
            return Ok(Ok((life, Because::row(row, Note::new("tool-life").with("minutes", life)))));
        }
    }
    Ok(Err(missing(handbook, shop)))
}

/// Kpv: the skin of the blank.
pub(super) fn surface(cut: &Cut<'_>, shop: &Shop<'_>) -> Result<Factor, KnowledgeError> {
    let table = shop.knowledge.table("skin-factor")?;
    let answer = table.decide(&[("surface", Input::Text(cut.surface))])?;
    let Some(row) = answer.winner() else { return Ok(Err(missing(table, shop))) };
    let factor = row.number_in("factor", Unit::None)?;
    Ok(Ok((factor, Because::row(row, shown("surface-factor", factor)))))
}

fn shown(code: &str, factor: f64) -> Note {
    Note::new(code).with("factor", crate::units::round_to(factor, 3))
}

/// A table has no figure for this material.
pub(super) fn missing(table: &Table, shop: &Shop<'_>) -> Note {
    Note::new("no-figure").with("table", &table.id).with("material", shop.material.designation())
}

/// A plain number of a row.
pub(super) fn number(row: RowRef<'_>, column: &str) -> Result<f64, KnowledgeError> {
    Ok(row.number_in(column, Unit::None)?)
}
