//! What the part is made of, as the cutting tables ask for it.

use crate::error::KnowledgeError;
use crate::knowledge::diagnostic::nearest;
use crate::knowledge::{Knowledge, RowRef, Table};
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

/// The id of a material by itself or by an alias; else the known name that is nearest to it, if one is near.
///
/// # Errors
/// No material has that name.
pub fn named(knowledge: &Knowledge, text: &str) -> Result<String, Option<String>> {
    let names = |table: &str, column: &'static str| {
        let rows = knowledge.table(table).into_iter().flat_map(Table::all_rows);
        rows.filter_map(move |row| Some((row.text(column).ok()?, row.text("id").ok()?)))
    };
    let known: Vec<(&str, &str)> = names("materials", "id").chain(names("material-aliases", "alias")).collect();
    match known.iter().find(|(name, _)| *name == text) {
        Some((_, id)) => Ok((*id).to_owned()),
        None => Err(nearest(text, known.iter().map(|(name, _)| *name)).map(str::to_owned)),
    }
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
