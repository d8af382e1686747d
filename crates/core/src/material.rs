//! The material of the part, as the cutting tables need it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::KnowledgeError;
use crate::knowledge::contract::Question;
use crate::knowledge::diagnostic::nearest;
use crate::knowledge::units::{Brinell, Megapascals};
use crate::knowledge::{Knowledge, RowRef};
use crate::tables::materials::{
    DeliveryState, DeliveryStates, Governs, HardnessBounds, HardnessStrength, MaterialAlias, MaterialGrade,
};
use crate::tables::rules::AlloyClassStateFor;
use crate::units::Decimal;

/// A material grade.
#[derive(Clone, Debug)]
pub struct Material<'k> {
    /// Its row in `materials`.
    pub row: RowRef<'k>,
    /// Its id.
    pub id: &'k str,
    /// Group of the cutting tables: `steel`, `grey-iron`, …
    pub group: &'k str,
    /// Class of steels for the speed factor, or `none`.
    pub steel_class: &'k str,
    /// Class of copper and aluminium alloys, or `none`.
    pub alloy_class: &'k str,
    /// Brinell hardness used for cutting.
    pub hardness: Decimal,
    /// Tensile strength, MPa; zero where the tables do not require it.
    pub strength: Decimal,
    designation: &'k str,
}

/// Hardness or strength of the blank; for steels a missing one follows from the other.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct MaterialState {
    /// Brinell hardness, HB.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hardness: Option<f64>,
    /// Tensile strength, MPa.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strength: Option<f64>,
}

/// The id of a material by its name or an alias; otherwise the nearest known name, if one is near.
///
/// # Errors
/// No material has that name.
pub fn named(knowledge: &Knowledge, text: &str) -> Result<String, Option<String>> {
    // Knowledge without materials, as in tests, has no names.
    let grades = knowledge.rows::<MaterialGrade<'_>>().unwrap_or_default().into_iter().map(|row| (row.id, row.id));
    let aliases = knowledge.rows::<MaterialAlias<'_>>().unwrap_or_default().into_iter().map(|row| (row.alias, row.id));
    let known: Vec<(&str, &str)> = grades.chain(aliases).collect();
    match known.iter().find(|(name, _)| *name == text) {
        Some((_, id)) => Ok((*id).to_owned()),
        None => Err(nearest(text, known.iter().map(|(name, _)| *name)).map(str::to_owned)),
    }
}

/// The figures of a steel in a delivery state; none if no available standard has the steel in that state.
pub fn delivered(knowledge: &Knowledge, material: &str, state: DeliveryState) -> Option<MaterialState> {
    let is = |row: &DeliveryStates<'_>| row.material == material && row.state == state;
    let row = knowledge.find(is).ok().flatten()?;
    let hardness = row.hardness.map(|hardness| hardness.0.to_f64());
    let strength = row.strength.map(|strength| strength.0.to_f64());
    Some(MaterialState { hardness, strength })
}

/// The MPa per HB between which hardness and strength of one bar lie, and the one by which each follows from the
/// other; none for a material that is not in the table `hardness-strength`.
pub(crate) fn hardness_to_strength<'k>(knowledge: &'k Knowledge, material: &str) -> Option<HardnessStrength<'k>> {
    let grade = knowledge.find(|row: &MaterialGrade<'_>| row.id == material).ok().flatten()?;
    knowledge.find(|row: &HardnessStrength<'_>| row.material_group == grade.group).ok().flatten()
}

/// Between which hardness, HB, metals of that grade's group lie; none for a grade that is not in the tables.
pub(crate) fn hardness_bounds<'k>(knowledge: &'k Knowledge, material: &str) -> Option<HardnessBounds<'k>> {
    let grade = knowledge.find(|row: &MaterialGrade<'_>| row.id == material).ok().flatten()?;
    knowledge.find(|row: &HardnessBounds<'_>| row.material_group == grade.group).ok().flatten()
}

impl<'k> Material<'k> {
    /// The grade of that id.
    ///
    /// # Errors
    /// There is no such grade.
    pub fn find(knowledge: &'k Knowledge, id: &str) -> Result<Self, KnowledgeError> {
        let grade: MaterialGrade<'_> = knowledge.need(id, |row: &MaterialGrade<'_>| row.id == id)?;
        let (hardness, strength) = (grade.hardness.0, grade.strength.unwrap_or_default().0);
        let found = Self {
            row: grade.row,
            id: grade.id,
            group: grade.group,
            steel_class: grade.steel_class,
            alloy_class: grade.alloy_class,
            hardness,
            strength,
            designation: grade.designation,
        };
        match grade.governs {
            Governs::Both => Ok(found),
            Governs::Hardness => {
                found.in_state(MaterialState { hardness: Some(hardness.to_f64()), strength: None }, knowledge)
            }
            Governs::Strength => {
                found.in_state(MaterialState { hardness: None, strength: Some(strength.to_f64()) }, knowledge)
            }
        }
    }

    /// The material in a state: the stated hardness or strength, and the other figure by the table
    /// `hardness-strength`, so that feeds, speeds and forces belong to one bar. Materials that are not in the table
    /// keep the figure that is not stated; alloys take the class of their state.
    ///
    /// # Errors
    /// The knowledge has no such table.
    pub fn in_state(self, state: MaterialState, knowledge: &'k Knowledge) -> Result<Self, KnowledgeError> {
        let ratio = knowledge.find(|row: &HardnessStrength<'_>| row.material_group == self.group)?.map(|row| row.ratio);
        let exact = |value: f64| Decimal::from_f64_rounded(value);
        let figure = |value: f64| exact(crate::units::round_to(value, 0));
        let follows = |value: Option<f64>, by: &dyn Fn(f64, f64) -> f64| {
            value.zip(ratio).map(|(of, ratio)| figure(by(of, ratio)))
        };
        let hardness =
            state.hardness.map(exact).or_else(|| follows(state.strength, &|strength, ratio| strength / ratio));
        let strength =
            state.strength.map(exact).or_else(|| follows(state.hardness, &|hardness, ratio| hardness * ratio));
        let (hardness, strength) = (hardness.unwrap_or(self.hardness), strength.unwrap_or(self.strength));
        let alloy_class = self.alloy_class_in(state, knowledge)?;
        Ok(Self { hardness, strength, alloy_class, ..self })
    }

    /// The class of an alloy in a state, by the rule `alloy-class-state`; the grade's own where the rule has none.
    fn alloy_class_in(&self, state: MaterialState, knowledge: &'k Knowledge) -> Result<&'k str, KnowledgeError> {
        let stated = |value: Option<f64>| value.map_or_else(Decimal::default, Decimal::from_f64_rounded);
        let question = AlloyClassStateFor {
            alloy_class: self.alloy_class,
            hardness: Brinell(stated(state.hardness)),
            strength: Megapascals(stated(state.strength)),
        };
        // Steels and irons have no class.
        let table = knowledge.table(AlloyClassStateFor::TABLE)?;
        if !table.inputs().any(|(_, column)| column.values.iter().any(|value| value == self.alloy_class)) {
            return Ok(self.alloy_class);
        }
        Ok(knowledge.ask(&question)?.winner()?.map_or(self.alloy_class, |row| row.class))
    }

    /// Its name on drawings.
    pub const fn designation(&self) -> &'k str {
        self.designation
    }
}
