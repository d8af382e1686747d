//! What planning stands in: the knowledge, the machine and the material of one part.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::machine::Machine;
use crate::material::Material;
use crate::part::Part;
use crate::plan::CuttingMethod;

/// The knowledge, the machine at hand and the material.
#[derive(Clone, Debug)]
pub struct Shop<'k> {
    /// Every table.
    pub knowledge: &'k Knowledge,
    /// The machine.
    pub machine: Machine<'k>,
    /// The material.
    pub material: Material<'k>,
    /// How cutting conditions are found.
    pub method: CuttingMethod,
}

impl<'k> Shop<'k> {
    /// The shop a part is planned in.
    ///
    /// # Errors
    /// The machine or the material is not in the knowledge base.
    pub fn new(part: &Part, method: CuttingMethod, knowledge: &'k Knowledge) -> Result<Self, KnowledgeError> {
        Ok(Self {
            knowledge,
            machine: Machine::find(knowledge, &part.machine)?,
            material: Material::find(knowledge, &part.material)?,
            method,
        })
    }
}
