//! What the part is made of, as the cutting tables ask for it.

use crate::error::KnowledgeError;
use crate::knowledge::diagnostic::nearest;
use crate::knowledge::{Knowledge, RowRef};
use crate::tables::materials::{MaterialAlias, MaterialGrade};
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
    /// Tensile strength, MPa; zero where the tables do not ask for it.
    pub strength: Decimal,
    designation: &'k str,
}

/// The id of a material by itself or by an alias; else the known name that is nearest to it, if one is near.
///
/// # Errors
/// No material has that name.
pub fn named(knowledge: &Knowledge, text: &str) -> Result<String, Option<String>> {
    // Knowledge without materials, as tests have it, knows no name.
    let grades = knowledge.rows::<MaterialGrade<'_>>().unwrap_or_default().into_iter().map(|row| (row.id, row.id));
    let aliases = knowledge.rows::<MaterialAlias<'_>>().unwrap_or_default().into_iter().map(|row| (row.alias, row.id));
    let known: Vec<(&str, &str)> = grades.chain(aliases).collect();
    match known.iter().find(|(name, _)| *name == text) {
        Some((_, id)) => Ok((*id).to_owned()),
        None => Err(nearest(text, known.iter().map(|(name, _)| *name)).map(str::to_owned)),
    }
}

impl<'k> Material<'k> {
    /// The grade of that id.
    ///
    /// # Errors
    /// There is no such grade.
    pub fn find(knowledge: &'k Knowledge, id: &str) -> Result<Self, KnowledgeError> {
        let grade: MaterialGrade<'_> = knowledge.need(id, |row: &MaterialGrade<'_>| row.id == id)?;
        Ok(Self {
            row: grade.row,
            id: grade.id,
            group: grade.group,
            steel_class: grade.steel_class,
            alloy_class: grade.alloy_class,
            hardness: grade.hardness.0,
            strength: grade.strength.unwrap_or_default().0,
            designation: grade.designation,
        })
    }

    /// Its name on drawings.
    pub const fn designation(&self) -> &'k str {
        self.designation
    }
}
