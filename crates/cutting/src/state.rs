//! Whether the forces follow the state that a part file states.

use crate::error::{KnowledgeError, Refusal};
use crate::knowledge::Knowledge;
use crate::knowledge::vocabulary::ToolMaterial;
use crate::material::{Material, MaterialState};
use crate::note::{Finding, Note, Severity};
use crate::tables::cutting::Process;
use crate::units::round_to;

use super::factors::material_force;
use super::figures::Asking;

/// A material alone, as the cutting tables ask for it.
struct Bar<'a, 'k> {
    knowledge: &'k Knowledge,
    material: &'a Material<'k>,
}

impl<'k> Asking<'k> for Bar<'_, 'k> {
    fn knowledge(&self) -> &'k Knowledge {
        self.knowledge
    }

    fn material(&self) -> &Material<'k> {
        self.material
    }
}

/// What a part says of a state whose hardness (HB) or strength (MPa) changes no force, because the tables have the
/// forces of this metal for one state: doubtful where the stated metal is harder than the grade, for it needs more.
/// Nothing for a state that the forces follow, or that is the grade's own.
///
/// # Errors
/// The knowledge base has no answer.
pub fn without_force(
    material: &Material<'_>,
    state: MaterialState,
    (process, tool_material): (Process, ToolMaterial),
    knowledge: &Knowledge,
) -> Result<Option<Finding>, KnowledgeError> {
    let grade = Material::find(knowledge, material.id)?;
    let factor = |material: &Material<'_>| -> Result<Option<f64>, KnowledgeError> {
        let bar = Bar { knowledge, material };
        Ok(Refusal::split(material_force(process, tool_material, &bar))?.ok().map(|(factor, _)| factor))
    };
    // A metal without any factor is refused by the stage that needs it.
    let (Some(stated), Some(own)) = (factor(material)?, factor(&grade)?) else { return Ok(None) };
    if stated.to_bits() != own.to_bits() {
        return Ok(None);
    }
    let of = |figure: Option<f64>, own: f64| figure.filter(|figure| figure.to_bits() != own.to_bits());
    let by_hardness =
        of(state.hardness, grade.hardness.to_f64()).map(|figure| ("hardness-no-force", figure, grade.hardness));
    let by_strength =
        of(state.strength, grade.strength.to_f64()).map(|figure| ("strength-no-force", figure, grade.strength));
    let Some((code, figure, own)) = by_hardness.or(by_strength) else { return Ok(None) };
    let severity = if figure > own.to_f64() { Severity::Doubtful } else { Severity::Note };
    let note =
        Note::new(code).with("stated", round_to(figure, 0)).with("own", own).with("material", material.designation());
    Ok(Some(Finding::of_part(severity, note)))
}
