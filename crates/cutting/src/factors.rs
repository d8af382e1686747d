//! Corrections of speed, feed and force for material, depth and surface, and the tool life.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::contract::Question;
use crate::knowledge::units::{Megapascals, Minutes, round_to};
use crate::knowledge::vocabulary::ToolMaterial;
use crate::knowledge::{Knowledge, RowRef};
use crate::material::Material;
use crate::note::{Because, Note};
use crate::plan::CuttingMethod;
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::tables::cutting::{
    BoringConstant, BoringParameters, Coefficients, DepthFeedFactorFor, DepthSpeedFactorFor, ForceAlloyFactorFor,
    ForceMaterialExponentFor, Process, Reference, SkinFactorFor, SpeedAlloyFactorFor, SpeedMaterialExponentFor,
    SpeedSteelClass, SpeedSteelClassFor, Surface, ToolLifeFor,
};
use crate::tables::rules::{DepthBeyondFor, SurfaceFor, ToolLifeBeyondFor};

use super::Cut;
use super::card::CardDoubt;
use super::figures::{self, Asking, missing};

/// A factor and the row behind it.
pub type Factor = (f64, Because);

/// Kmv: factor of the material for the speed.
///
/// Steel: Kg·(750/σB)^nv, in milling with the class's own nv where it has one. Grey iron (190/HB)^nv, malleable iron (150/HB)^nv. Copper and aluminium
/// alloys: a figure of their class. (Косилова/Мещеряков т.2, facts 1.5.)
///
/// # Errors
/// A table has no figure for this material, or the knowledge base has no answer.
pub fn material_speed<'k>(
    process: Process,
    tool_material: ToolMaterial,
    shop: &impl Asking<'k>,
) -> Tried<Factor, Uncut> {
    let (knowledge, material) = (shop.knowledge(), shop.material());
    let of_tool = |tool_material| SpeedMaterialExponentFor {
        process,
        tool_material,
        material_group: material.group,
        strength: Megapascals(material.strength),
    };
    let table = SpeedMaterialExponentFor::TABLE;
    let (row, stand_in) = match knowledge.ask(&of_tool(tool_material))?.winner()? {
        Some(row) => (row, None),
        None => {
            let other = figures::stand_in_tool_material(table, tool_material, shop)?;
            let Some((instead, because)) = other else { return factor_of_one(table, shop) };
            let Some(row) = knowledge.ask(&of_tool(instead))?.winner()? else { return factor_of_one(table, shop) };
            (row, Some(because))
        }
    };
    let mut exponent = row.exponent;
    let mut because = stand_in.unwrap_or_else(|| Because::row(row.row, Note::new("material-speed-factor")));
    let mut class_factor = 1.0;
    if row.reference == Reference::Strength750 {
        let class = steel_class(tool_material, shop)?;
        if let (Process::Milling, Some(own)) = (process, class.milling_exponent) {
            exponent = own;
            because = Because::row(class.row, Note::new("material-speed-factor"));
        }
        class_factor = class.factor;
    }
    let Some((reference, own)) = compared(row.reference, material) else {
        let question = SpeedAlloyFactorFor { alloy_class: material.alloy_class };
        return alloy(&question, |row| row.factor, shop);
    };
    let factor = class_factor * libm::pow(reference / own, exponent);
    Ok((factor, Because { note: shown("material-speed-factor", factor), ..because }))
}

/// Kmp: factor of the material for forces. Steel (σB/750)^n, grey iron (HB/190)^n, malleable (HB/150)^n.
///
/// # Errors
/// As for [`material_speed`].
pub fn material_force<'k>(
    process: Process,
    tool_material: ToolMaterial,
    shop: &impl Asking<'k>,
) -> Tried<Factor, Uncut> {
    let material = shop.material();
    let (material_group, strength) = (material.group, Megapascals(material.strength));
    let question = ForceMaterialExponentFor { process, tool_material, material_group, strength };
    let Some(row) = shop.knowledge().ask(&question)?.winner()? else {
        return factor_of_one(ForceMaterialExponentFor::TABLE, shop);
    };
    let Some((reference, own)) = compared(row.reference, material) else {
        let question = ForceAlloyFactorFor { alloy_class: material.alloy_class };
        return alloy(&question, |row| row.factor, shop);
    };
    let factor = libm::pow(own / reference, row.exponent);
    Ok((factor, Because::row(row.row, shown("material-force-factor", factor))))
}

/// The figure of the reference material and that of the actual one, MPa or HB; none for alloys, which have classes.
fn compared(reference: Reference, material: &Material<'_>) -> Option<(f64, f64)> {
    let (strength, hardness) = (material.strength.to_f64(), material.hardness.to_f64());
    match reference {
        Reference::Strength750 => Some((750.0, strength)),
        Reference::Hardness190 => Some((190.0, hardness)),
        Reference::Hardness150 => Some((150.0, hardness)),
        Reference::None => None,
    }
}

/// The class of the steel, with its Kg; for carbide by the rule `stand-in-tool-material`.
fn steel_class<'k>(tool_material: ToolMaterial, shop: &impl Asking<'k>) -> Tried<SpeedSteelClass<'k>, Uncut> {
    let (knowledge, steel_class) = (shop.knowledge(), shop.material().steel_class);
    let ask = |tool_material| -> Result<Option<SpeedSteelClass<'k>>, KnowledgeError> {
        Ok(knowledge.ask(&SpeedSteelClassFor { steel_class, tool_material })?.winner()?)
    };
    if let Some(row) = ask(tool_material)? {
        return Ok(row);
    }
    let table = SpeedSteelClassFor::TABLE;
    let instead = figures::stand_in_tool_material(table, tool_material, shop)?.map(|(instead, _)| instead);
    instead.map(ask).transpose()?.flatten().ok_or_else(|| missing(table, shop))
}

/// No exponent or factor is known: 1, where the rule `stand-in-material` says so.
fn factor_of_one<'k>(table: &str, shop: &impl Asking<'k>) -> Tried<Factor, Uncut> {
    match figures::stand_in(table, shop)? {
        Some((_, because)) => Ok((1.0, because)),
        None => Err(missing(table, shop)),
    }
}

fn alloy<'k, Q: Question>(
    question: &Q,
    factor: impl FnOnce(Q::Row<'k>) -> f64,
    shop: &impl Asking<'k>,
) -> Tried<Factor, Uncut> {
    let table = shop.knowledge().table(Q::TABLE)?;
    let class = shop.material().alloy_class;
    if !table.inputs().any(|(_, column)| column.values.iter().any(|value| value == class)) {
        return factor_of_one(Q::TABLE, shop);
    }
    let Some((row, cited)) = figures::within_reach(question, shop.knowledge())? else {
        return factor_of_one(Q::TABLE, shop);
    };
    let factor = factor(row);
    Ok((factor, Because::row(cited, shown(Q::TABLE, factor))))
}

/// A factor by the depth of the hole.
pub(super) struct ByDepth {
    pub factor: Factor,
    /// The factor of the handbook that the cards leave out.
    pub left_out: Option<CardDoubt>,
}

/// Klv: factor of the depth of the hole, in diameters, for the speed.
pub(super) fn speed_by_depth<'k>(operation: Coefficients, cut: &Cut, shop: &impl Asking<'k>) -> Tried<ByDepth, Uncut> {
    let depth_ratio = depth_ratio(cut);
    let found = figures::within_reach(&DepthSpeedFactorFor { operation, depth_ratio }, shop.knowledge())?;
    by_depth(DepthSpeedFactorFor::TABLE, depth_ratio, found.map(|(row, cited)| (row.factor, cited)), shop)
}

/// Kls: factor of the depth of the hole, in diameters, for the feed.
pub(super) fn feed_by_depth<'k>(cut: &Cut, shop: &impl Asking<'k>) -> Tried<ByDepth, Uncut> {
    let depth_ratio = depth_ratio(cut);
    let found = figures::within_reach(&DepthFeedFactorFor { depth_ratio }, shop.knowledge())?;
    by_depth(DepthFeedFactorFor::TABLE, depth_ratio, found.map(|(row, cited)| (row.factor, cited)), shop)
}

fn depth_ratio(cut: &Cut) -> f64 {
    cut.depth.to_mm() / cut.diameter.to_mm()
}

/// The factor of depth of a table, or beyond it by the rule `depth-beyond`.
///
/// The cards have their own depth factors, which are not available; the worked example takes 1 at 3.5 diameters,
/// where the handbook does not. So the factor of the card method is 1, and the reason names the factor that was left
/// out.
fn by_depth<'k>(
    table: &'static str,
    depth_ratio: f64,
    found: Option<(f64, RowRef<'k>)>,
    shop: &impl Asking<'k>,
) -> Tried<ByDepth, Uncut> {
    let (factor, row) = match found {
        Some(found) => found,
        None => {
            let answer = shop.knowledge().ask(&DepthBeyondFor { of_table: table, depth_ratio })?;
            let too_deep = || Refusal::Not(Uncut::TooDeep { table: table.to_owned(), ratio: depth_ratio });
            let beyond = answer.winner()?.ok_or_else(too_deep)?;
            (beyond.factor, beyond.row)
        }
    };
    if shop.method() == CuttingMethod::Card && factor < 1.0 {
        let doubt = CardDoubt::WithoutDepth { table: table.to_owned(), ratio: depth_ratio, factor };
        return Ok(ByDepth { factor: (1.0, Because::row(row, doubt.note())), left_out: Some(doubt) });
    }
    Ok(ByDepth { factor: (factor, Because::row(row, shown(table, factor))), left_out: None })
}

/// Tool life by the handbook's table; where that has no cell by `tool-life-beyond`, or of a replacement.
pub(crate) fn tool_life<'k>(
    operation: Coefficients,
    cut: &Cut,
    shop: &impl Asking<'k>,
) -> Tried<(Minutes, Vec<Because>), Uncut> {
    let &Cut { tool_material, diameter, .. } = cut;
    let question = |material_group| ToolLifeFor { operation, material_group, tool_material, diameter };
    let beyond = |material_group| ToolLifeBeyondFor { operation, material_group, tool_material, diameter };
    let found = match figures::ask(question, shop) {
        Err(refusal @ Refusal::Not(_)) => figures::ask(beyond, shop).map_err(|_| refusal)?.map(|row| row.life),
        found => found?.map(|row| row.life),
    };
    Ok((found.row, found.because(tool_life_text(found.row))))
}

/// The tool life of single-point tools, by `boring-parameters`.
///
/// # Errors
/// The table does not have it.
pub fn single_point_life(knowledge: &Knowledge) -> Result<(Minutes, Because), KnowledgeError> {
    let row = boring_constant(BoringConstant::ToolLife, knowledge)?;
    let life = row.time.ok_or_else(|| KnowledgeError::no_row(row.row.table, "the tool life"))?;
    Ok((life, Because::row(row.row, tool_life_text(life))))
}

/// The factor on the turning speed inside a bore, by `boring-parameters`.
///
/// # Errors
/// The table does not have it.
pub fn internal(knowledge: &Knowledge) -> Result<Factor, KnowledgeError> {
    let row = boring_constant(BoringConstant::InternalFactor, knowledge)?;
    let factor = row.factor.ok_or_else(|| KnowledgeError::no_row(row.row.table, "the internal factor"))?;
    Ok((factor, Because::row(row.row, Note::new("internal-factor").with("factor", factor))))
}

fn boring_constant(name: BoringConstant, knowledge: &Knowledge) -> Result<BoringParameters<'_>, KnowledgeError> {
    knowledge.need(name.name(), |row: &BoringParameters<'_>| row.name.is(name))
}

/// A tool life in words.
pub(crate) fn tool_life_text(life: Minutes) -> Note {
    Note::new("tool-life").with("minutes", life.0)
}

/// The surface of a hole's metal by the rule `surface`.
///
/// # Errors
/// The knowledge base has no answer.
pub fn surface_of(skin: bool, shop: &Shop<'_>) -> Result<Surface, KnowledgeError> {
    let material_group = shop.material.group;
    Ok(shop.knowledge.ask(&SurfaceFor { skin, material_group })?.need(material_group)?.surface)
}

/// Kpv: the skin of the blank.
///
/// # Errors
/// The table has no such surface, or the knowledge base has no answer.
pub fn surface<'k>(surface: Surface, shop: &impl Asking<'k>) -> Tried<Factor, Uncut> {
    let answer = shop.knowledge().ask(&SkinFactorFor { surface })?;
    let row = answer.winner()?.ok_or_else(|| missing(SkinFactorFor::TABLE, shop))?;
    Ok((row.factor, Because::row(row.row, shown("surface-factor", row.factor))))
}

fn shown(code: &'static str, factor: f64) -> Note {
    Note::new(code).with("factor", round_to(factor, 3))
}
