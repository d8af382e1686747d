//! Corrections of speed, feed and force for material, depth and surface, and the tool life.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::units::{Unit, round_to};
use crate::knowledge::{Input, QueryError, RowRef};
use crate::material::Material;
use crate::note::{Because, Note};
use crate::plan::CuttingMethod;
use crate::reason::Uncut;
use crate::shop::Shop;

use super::Cut;
use super::card::CardDoubt;
use super::figures::{self, Asking, missing, number, plain};

/// A factor and the row behind it.
pub type Factor = (f64, Because);

/// Kmv: how the material moves the speed.
///
/// Steel: Kg·(750/σB)^nv, in milling with the class's own nv where it has one. Grey iron (190/HB)^nv, malleable iron (150/HB)^nv. Copper and aluminium
/// alloys: a figure of their class. (Косилова/Мещеряков т.2, facts 1.5.)
///
/// # Errors
/// A table has no figure for this material, or the knowledge cannot answer.
pub fn material_speed<'k>(process: &str, tool_material: &str, shop: &impl Asking<'k>) -> Tried<Factor, Uncut> {
    let table = shop.knowledge().table("speed-material-exponent")?;
    let (row, stand_in) = match table.decide(&material_inputs(process, tool_material, shop.material()))?.winner() {
        Some(row) => (row, None),
        None => {
            let other = figures::stand_in_tool_material(&table.id, tool_material, shop)?;
            let Some((instead, because)) = other else { return factor_of_one(&table.id, shop) };
            let answer = table.decide(&material_inputs(process, instead, shop.material()))?;
            let Some(row) = answer.winner() else { return factor_of_one(&table.id, shop) };
            (row, Some(because))
        }
    };
    let (strength, hardness) = (shop.material().strength.to_f64(), shop.material().hardness.to_f64());
    let mut exponent = number(row, "exponent")?;
    let mut because = stand_in.unwrap_or_else(|| Because::row(row, Note::new("material-speed-factor")));
    let (ratio, class) = match row.text("reference")? {
        "strength-750" => {
            let class = steel_class(tool_material, shop)?;
            if process == "milling" && class.value("milling_exponent").is_some() {
                exponent = number(class, "milling_exponent")?;
                because = Because::row(class, Note::new("material-speed-factor"));
            }
            (750.0 / strength, number(class, "factor")?)
        }
        "hardness-190" => (190.0 / hardness, 1.0),
        "hardness-150" => (150.0 / hardness, 1.0),
        _ => return alloy("speed-alloy-factor", shop),
    };
    let factor = class * libm::pow(ratio, exponent);
    Ok((factor, Because { note: shown("material-speed-factor", factor), ..because }))
}

/// Kmp: how the material moves forces. Steel (σB/750)^n, grey iron (HB/190)^n, malleable (HB/150)^n.
///
/// # Errors
/// As of [`material_speed`].
pub fn material_force<'k>(process: &str, tool_material: &str, shop: &impl Asking<'k>) -> Tried<Factor, Uncut> {
    let table = shop.knowledge().table("force-material-exponent")?;
    let answer = table.decide(&material_inputs(process, tool_material, shop.material()))?;
    let Some(row) = answer.winner() else { return factor_of_one(&table.id, shop) };
    let (strength, hardness) = (shop.material().strength.to_f64(), shop.material().hardness.to_f64());
    let ratio = match row.text("reference")? {
        "strength-750" => strength / 750.0,
        "hardness-190" => hardness / 190.0,
        "hardness-150" => hardness / 150.0,
        _ => return alloy("force-alloy-factor", shop),
    };
    let factor = libm::pow(ratio, number(row, "exponent")?);
    Ok((factor, Because::row(row, shown("material-force-factor", factor))))
}

fn material_inputs<'a>(
    process: &'a str,
    tool_material: &'a str,
    material: &Material<'a>,
) -> [(&'static str, Input<'a>); 4] {
    [
        ("process", Input::Text(process)),
        ("tool_material", Input::Text(tool_material)),
        ("material_group", Input::Text(material.group)),
        ("strength", Input::Number(material.strength, Unit::Megapascal)),
    ]
}

/// The class of the steel, with its Kg; for carbide by the rule `stand-in-tool-material`.
fn steel_class<'k>(tool_material: &str, shop: &impl Asking<'k>) -> Tried<RowRef<'k>, Uncut> {
    let table = shop.knowledge().table("speed-steel-class")?;
    let ask = |tool: &str| -> Result<Option<RowRef<'k>>, KnowledgeError> {
        let class = ("steel_class", Input::Text(shop.material().steel_class));
        Ok(table.decide(&[class, ("tool_material", Input::Text(tool))])?.winner())
    };
    if let Some(row) = ask(tool_material)? {
        return Ok(row);
    }
    let instead = figures::stand_in_tool_material(&table.id, tool_material, shop)?.map(|(instead, _)| instead);
    instead.map(ask).transpose()?.flatten().ok_or_else(|| missing(table, shop))
}

/// No exponent or factor is known: 1, where the rule `stand-in-material` says so.
fn factor_of_one<'k>(id: &str, shop: &impl Asking<'k>) -> Tried<Factor, Uncut> {
    match figures::stand_in(id, shop)? {
        Some((_, because)) => Ok((1.0, because)),
        None => Err(missing(shop.knowledge().table(id)?, shop)),
    }
}

fn alloy<'k>(id: &str, shop: &impl Asking<'k>) -> Tried<Factor, Uncut> {
    let table = shop.knowledge().table(id)?;
    let known =
        table.inputs().any(|(_, column)| column.values.iter().any(|value| value == shop.material().alloy_class));
    if !known {
        return factor_of_one(id, shop);
    }
    let answer = table.decide(&[("alloy_class", Input::Text(shop.material().alloy_class))])?;
    let Some(row) = answer.winner() else { return factor_of_one(id, shop) };
    let factor = number(row, "factor")?;
    Ok((factor, Because::row(row, shown(id, factor))))
}

/// A factor by the depth of the hole.
pub(super) struct ByDepth {
    pub factor: Factor,
    /// The factor of the handbook that the cards leave out.
    pub left_out: Option<CardDoubt>,
}

/// Klv or Kls: how the depth of the hole, in diameters, moves speed or feed.
///
/// The cards have their own factors of depth, which are not at hand; the worked example takes 1 at 3.5 diameters, where
/// the handbook does not. By the card method the factor is therefore 1, and the reason tells which one was left out.
pub(super) fn by_depth(id: &str, cut: &Cut<'_>, shop: &Shop<'_>) -> Tried<ByDepth, Uncut> {
    let table = shop.knowledge().table(id)?;
    let ratio = cut.depth.to_mm() / cut.diameter.to_mm();
    let mut inputs = vec![("depth_ratio", plain(ratio))];
    if table.inputs().any(|(_, column)| column.name == "operation") {
        inputs.push(("operation", Input::Text(cut.operation.name())));
    }
    let found = match table.decide(&inputs) {
        Err(QueryError::OutOfDomain { .. }) => None,
        answer => answer?.winner(),
    };
    let row = match found {
        Some(row) => row,
        None => {
            let beyond = shop.knowledge().table("depth-beyond")?;
            let answer = beyond.decide(&[("of_table", Input::Text(id)), ("depth_ratio", plain(ratio))])?;
            answer.winner().ok_or_else(|| Refusal::Not(Uncut::TooDeep { table: id.to_owned(), ratio }))?
        }
    };
    let factor = number(row, "factor")?;
    if shop.method == CuttingMethod::Card && factor < 1.0 {
        let doubt = CardDoubt::WithoutDepth { table: id.to_owned(), ratio, factor };
        return Ok(ByDepth { factor: (1.0, Because::row(row, doubt.note())), left_out: Some(doubt) });
    }
    Ok(ByDepth { factor: (factor, Because::row(row, shown(id, factor))), left_out: None })
}

/// Tool life by the handbook's table, by `tool-life-beyond` where that has no cell, or by a stand-in.
pub(crate) fn tool_life(operation: &str, cut: &Cut<'_>, shop: &Shop<'_>) -> Tried<(f64, Vec<Because>), Uncut> {
    let others = [
        ("operation", Input::Text(operation)),
        ("tool_material", Input::Text(cut.tool_material)),
        ("diameter", Input::Length(cut.diameter)),
    ];
    let found = match figures::ask("tool-life", &others, shop) {
        Err(refusal @ Refusal::Not(_)) => figures::ask("tool-life-beyond", &others, shop).map_err(|_| refusal)?,
        found => found?,
    };
    let life = found.row.number_in("life", Unit::Minute)?;
    Ok((life, found.because(Note::new("tool-life").with("minutes", life))))
}

/// The surface of a hole's metal by the rule `surface`, a value of the table `skin-factor`.
///
/// # Errors
/// The knowledge cannot answer.
pub fn surface_of<'k>(skin: bool, shop: &Shop<'k>) -> Result<&'k str, KnowledgeError> {
    let rule = shop.knowledge.table("surface")?;
    let group = Input::Text(shop.material.group);
    let answer = rule.decide(&[("skin", Input::Bool(skin)), ("material_group", group)])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, shop.material.group))?;
    Ok(row.text("surface")?)
}

/// Kpv: the skin of the blank.
///
/// # Errors
/// The table has no such surface, or the knowledge cannot answer.
pub fn surface<'k>(surface: &str, shop: &impl Asking<'k>) -> Tried<Factor, Uncut> {
    let table = shop.knowledge().table("skin-factor")?;
    let answer = table.decide(&[("surface", Input::Text(surface))])?;
    let row = answer.winner().ok_or_else(|| missing(table, shop))?;
    let factor = number(row, "factor")?;
    Ok((factor, Because::row(row, shown("surface-factor", factor))))
}

fn shown(code: &str, factor: f64) -> Note {
    Note::new(code).with("factor", round_to(factor, 3))
}
