//! Queries of the cutting tables: the row of the material's own group, or by the rule `stand-in-material` that of
//! another group, marked as a replacement. A figure is never guessed silently.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::contract::{Question, TableRow};
use crate::knowledge::vocabulary::ToolMaterial;
use crate::knowledge::{Knowledge, RowRef};
use crate::material::Material;
use crate::note::{Because, Figure, Note};
use crate::plan::{CuttingMethod, Operation};
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::tables::rules::{StandInMaterial, StandInMaterialFor, StandInOperationFor, StandInToolMaterialFor};

/// The context of a cutting table query: a machine for holes, or a cut on a lathe.
pub trait Asking<'k> {
    /// Every table.
    fn knowledge(&self) -> &'k Knowledge;
    /// What is cut.
    fn material(&self) -> &Material<'k>;
    /// How feed and speed are found.
    fn method(&self) -> CuttingMethod {
        CuttingMethod::default()
    }
}

impl<'k> Asking<'k> for Shop<'k> {
    fn knowledge(&self) -> &'k Knowledge {
        self.knowledge
    }

    fn material(&self) -> &Material<'k> {
        &self.material
    }

    fn method(&self) -> CuttingMethod {
        self.method
    }
}

/// A row of a cutting table.
pub struct Figures<'k, R> {
    /// The row.
    pub row: R,
    /// The row, for citing it.
    cited: RowRef<'k>,
    /// Why the row of another group or tool material is used; empty for a row of the material itself.
    stand_in: Vec<Because>,
    /// Whether the row belongs to the material's own group, for any tool material.
    own_group: bool,
}

impl<'k, R> Figures<'k, R> {
    /// Whether the row belongs to the material's own group, so that the material's factor applies to it.
    pub fn is_own_group(&self) -> bool {
        self.own_group
    }

    /// The reasons: the row, and the stand-in rule where one was needed.
    pub fn because(&self, note: Note) -> Vec<Because> {
        std::iter::once(Because::row(self.cited, note)).chain(self.stand_in.clone()).collect()
    }

    /// The same with only the relevant figures of the row.
    pub fn map<T>(self, of: impl FnOnce(R) -> T) -> Figures<'k, T> {
        let Self { row, cited, stand_in, own_group } = self;
        Figures { row: of(row), cited, stand_in, own_group }
    }
}

/// The row of a table for the shop's material; `question` makes the query for a material group.
///
/// # Errors
/// The table has no figure for the material, or the knowledge base has no answer.
pub fn ask<'k, Q: Question>(
    question: impl Fn(&'k str) -> Q,
    shop: &impl Asking<'k>,
) -> Tried<Figures<'k, Q::Row<'k>>, Uncut> {
    let (knowledge, group) = (shop.knowledge(), shop.material().group);
    if let Some((row, cited)) = within_reach(&question(group), knowledge)? {
        return Ok(Figures { row, cited, stand_in: Vec::new(), own_group: true });
    }
    if let Some((group, because)) = stand_in(Q::TABLE, shop)?
        && let Some((row, cited)) = within_reach(&question(group), knowledge)?
    {
        return Ok(Figures { row, cited, stand_in: vec![because], own_group: false });
    }
    Err(missing(Q::TABLE, shop))
}

/// The row of a table for the shop's material and a tool material; if there is none, the row of the tool material
/// that the rule `stand-in-tool-material` names. Returned with the tool material of the row, because the material's
/// factor depends on it.
pub(crate) fn ask_of_tool<'k, Q: Question>(
    question: impl Fn(&'k str, ToolMaterial) -> Q,
    tool_material: ToolMaterial,
    shop: &impl Asking<'k>,
) -> Tried<(Figures<'k, Q::Row<'k>>, ToolMaterial), Uncut> {
    let refusal = match ask(|group| question(group, tool_material), shop) {
        Err(Refusal::Not(why)) => why,
        found => return Ok((found?, tool_material)),
    };
    let (instead, because) = stand_in_tool_material(Q::TABLE, tool_material, shop)?.ok_or(Refusal::Not(refusal))?;
    let mut figures = ask(|group| question(group, instead), shop)?;
    figures.stand_in.push(because);
    Ok((figures, instead))
}

/// The tool material whose figures are used instead of another's in a table, by the rule.
pub(crate) fn stand_in_tool_material<'k>(
    of_table: &str,
    tool_material: ToolMaterial,
    shop: &impl Asking<'k>,
) -> Result<Option<(ToolMaterial, Because)>, KnowledgeError> {
    let answer = shop.knowledge().ask(&StandInToolMaterialFor { of_table, tool_material })?;
    let Some(rule) = answer.winner()? else { return Ok(None) };
    let note =
        Note::new("stand-in-tool-material").with("table", of_table).with("tool", Figure::word(tool_material.name()));
    Ok(Some((rule.instead, Because::row(rule.row, note.with("other", Figure::word(rule.instead.name()))))))
}

/// The group whose figures are used instead of those of the material in a table, by the rule.
pub(crate) fn stand_in<'k>(
    of_table: &str,
    shop: &impl Asking<'k>,
) -> Result<Option<(&'k str, Because)>, KnowledgeError> {
    let (knowledge, material) = (shop.knowledge(), shop.material());
    let table = knowledge.table_of::<StandInMaterial<'_>>()?;
    if !table.inputs().any(|(_, column)| column.values.iter().any(|value| value == of_table)) {
        return Ok(None);
    }
    let answer = knowledge.ask(&StandInMaterialFor { of_table, material_group: material.group })?;
    let Some(rule) = answer.winner()? else { return Ok(None) };
    let note = Note::new("stand-in").with("table", of_table).with("group", Figure::word(rule.group.to_owned()));
    Ok(Some((rule.group, Because::row(rule.row, note.with("material", material.designation())))))
}

/// The transition whose figures are used for one that has none, by the rule `stand-in-operation`.
pub(crate) fn stand_in_operation<'k>(
    operation: Operation,
    shop: &impl Asking<'k>,
) -> Tried<(Operation, Because), Uncut> {
    let rule = shop.knowledge().ask(&StandInOperationFor { operation })?.need(operation.name())?;
    let note = Note::new("stand-in-operation")
        .with("operation", Figure::operation(operation.name()))
        .with("instead", Figure::operation(rule.instead.name()));
    Ok((rule.instead, Because::row(rule.row, note)))
}

/// The row that answers, with its figures; none if the table has none. A query outside the range of the table counts
/// as missing.
///
/// # Errors
/// The knowledge base has no answer.
pub fn within_reach<'k, Q: Question>(
    question: &Q,
    knowledge: &'k Knowledge,
) -> Result<Option<(Q::Row<'k>, RowRef<'k>)>, KnowledgeError> {
    let Some(answer) = knowledge.ask_within(question)? else { return Ok(None) };
    match answer.answer.winner() {
        Some(row) => Ok(Some((Q::Row::read(row)?, row))),
        None => Ok(None),
    }
}

/// A table has no figure for this material, and no other group's may be used.
pub fn missing<'k>(table: &str, shop: &impl Asking<'k>) -> Refusal<Uncut> {
    Refusal::Not(Uncut::NoFigure { table: table.to_owned(), material: shop.material().designation().to_owned() })
}
