//! What the part is made of, as the cutting tables ask for it.

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, RowRef};
use crate::units::{Decimal, Unit};

/// A material grade.
#[derive(Clone, Debug)]
pub struct Material<'k> {
    /// Its row in `materials`.
    pub row: RowRef<'k>,
    /// Group of the cutting tables: `steel`, `grey-iron`, …
    pub group: &'k str,
    /// Class of steels for the speed factor, or `none`.
    pub steel_class: &'k str,
    /// Class of copper and aluminium alloys, or `none`.
    pub alloy_class: &'k str,
    /// Brinell hardness used for cutting.
    pub hardness: Decimal,
    /// Tensile strength, MPa; zero where the tables do not ask for it.
    pub strength: Decimal,
}

impl<'k> Material<'k> {
    /// The grade of that id.
    ///
    /// # Errors
    /// There is no such grade, or its row lacks a figure.
    pub fn find(knowledge: &'k Knowledge, id: &str) -> Result<Self, KnowledgeError> {
        let table = knowledge.table("materials")?;
        let row = table.find("id", id).ok_or_else(|| KnowledgeError::no_row(table, id))?;
        let strength = row.number_in("strength", Unit::Megapascal).unwrap_or_default();
        Ok(Self {
            row,
            group: row.text("group")?,
            steel_class: row.text("steel_class")?,
            alloy_class: row.text("alloy_class")?,
            hardness: Decimal::from_f64_rounded(row.number_in("hardness", Unit::Brinell)?),
            strength: Decimal::from_f64_rounded(strength),
        })
    }

    /// Its name on drawings.
    pub fn designation(&self) -> &'k str {
        self.row.text("designation").unwrap_or_default()
    }
}
