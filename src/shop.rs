//! What planning stands in: the knowledge, the machine and the material of one part.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::machine::Machine;
use crate::material::Material;
use crate::part::Part;
use crate::plan::CuttingMethod;
use crate::units::{Micrometres, Roughness, Unit};

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
    /// A share of the conventions in `hole-defaults`.
    ///
    /// # Errors
    /// The table does not name it.
    pub fn share(&self, name: &str) -> Result<f64, KnowledgeError> {
        let table = self.knowledge.table("hole-defaults")?;
        let row = table.find("name", name).ok_or_else(|| KnowledgeError::no_row(table, name))?;
        Ok(row.number_in("value", Unit::None)?)
    }

    /// A roughness of the conventions in `hole-defaults`, whose names end in `-ra-um`.
    ///
    /// # Errors
    /// The table does not name it.
    pub fn roughness(&self, name: &str) -> Result<Roughness, KnowledgeError> {
        Ok(Roughness::from_ra_nanometres((self.share(name)? * 1000.0) as u32))
    }

    /// A length of the conventions in `hole-defaults`, whose names end in `-mm`.
    ///
    /// # Errors
    /// The table does not name it.
    pub fn convention(&self, name: &str) -> Result<Micrometres, KnowledgeError> {
        let table = self.knowledge.table("hole-defaults")?;
        let row = table.find("name", name).ok_or_else(|| KnowledgeError::no_row(table, name))?;
        Ok(Micrometres::from_mm_rounded(row.number_in("value", Unit::None)?))
    }

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
