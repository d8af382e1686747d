//! Asking the cutting tables: the material's own row, or by the rule `stand-in-material` another group's,
//! marked as such. There is one way to a figure, and it never guesses silently.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::units::{Decimal, MillimetresPerRev, Unit};
use crate::knowledge::{Input, Knowledge, QueryError, RowRef, Table, Value};
use crate::material::Material;
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::reason::Uncut;
use crate::shop::Shop;

/// Who asks the cutting tables: a shop that drills, or a cut on a lathe.
pub trait Asking<'k> {
    /// Every table.
    fn knowledge(&self) -> &'k Knowledge;
    /// What is cut.
    fn material(&self) -> &Material<'k>;
}

impl<'k> Asking<'k> for Shop<'k> {
    fn knowledge(&self) -> &'k Knowledge {
        self.knowledge
    }

    fn material(&self) -> &Material<'k> {
        &self.material
    }
}

/// A row of a cutting table.
pub struct Figures<'k> {
    /// The row.
    pub row: RowRef<'k>,
    /// Why another group's or tool material's row stands in; empty for the material's own.
    pub stand_in: Vec<Because>,
    /// Whether the row is of the material's own group, whatever tool material it is of.
    own_group: bool,
}

impl Figures<'_> {
    /// Whether the row is of the material's own group, so that the material's factor applies to it.
    pub fn own(&self) -> bool {
        self.own_group
    }

    /// The reasons: the row, and the stand-in rule where one was needed.
    pub fn because(&self, note: Note) -> Vec<Because> {
        std::iter::once(Because::row(self.row, note)).chain(self.stand_in.clone()).collect()
    }
}

/// The row of a table for the shop's material; `others` are the inputs beside the material group.
///
/// # Errors
/// The table has no figure for the material, or the knowledge cannot answer.
pub fn ask<'k>(id: &str, others: &[(&str, Input<'_>)], shop: &impl Asking<'k>) -> Tried<Figures<'k>, Uncut> {
    let table = shop.knowledge().table(id)?;
    if let Some(row) = decide(table, others, shop.material().group)? {
        return Ok(Figures { row, stand_in: Vec::new(), own_group: true });
    }
    if let Some((group, because)) = stand_in(id, shop)?
        && let Some(row) = decide(table, others, group)?
    {
        return Ok(Figures { row, stand_in: vec![because], own_group: false });
    }
    Err(missing(table, shop))
}

/// The row of a table for the shop's material and a tool material; where it has none for that tool, the row
/// of the tool material that the rule `stand-in-tool-material` names. With the tool material whose row it is: the
/// material's factor is of that one too.
pub(crate) fn ask_of_tool<'t, 'k: 't>(
    id: &str,
    tool_material: &'t str,
    shop: &impl Asking<'k>,
) -> Tried<(Figures<'k>, &'t str), Uncut> {
    let refusal = match ask(id, &[("tool_material", Input::Text(tool_material))], shop) {
        Err(Refusal::Not(why)) => why,
        found => return Ok((found?, tool_material)),
    };
    let (instead, because) = stand_in_tool_material(id, tool_material, shop)?.ok_or(Refusal::Not(refusal))?;
    let mut figures = ask(id, &[("tool_material", Input::Text(instead))], shop)?;
    figures.stand_in.push(because);
    Ok((figures, instead))
}

/// The tool material whose figures stand in for another in a table, by the rule.
pub(crate) fn stand_in_tool_material<'k>(
    id: &str,
    tool_material: &str,
    shop: &impl Asking<'k>,
) -> Result<Option<(&'k str, Because)>, KnowledgeError> {
    let rule = shop.knowledge().table("stand-in-tool-material")?;
    let answer = rule.decide(&[("of_table", Input::Text(id)), ("tool_material", Input::Text(tool_material))])?;
    let Some(row) = answer.winner() else { return Ok(None) };
    let instead = row.text("instead")?;
    let note = Note::new("stand-in-tool-material").with("table", id).with("tool", tool_material).with("other", instead);
    Ok(Some((instead, Because::row(row, note))))
}

/// The group whose figures stand in for the shop's material in a table, by the rule.
pub(crate) fn stand_in<'k>(id: &str, shop: &impl Asking<'k>) -> Result<Option<(&'k str, Because)>, KnowledgeError> {
    let rule = shop.knowledge().table("stand-in-material")?;
    if !rule.inputs().any(|(_, column)| column.values.iter().any(|value| value == id)) {
        return Ok(None);
    }
    let answer =
        rule.decide(&[("of_table", Input::Text(id)), ("material_group", Input::Text(shop.material().group))])?;
    let Some(row) = answer.winner() else { return Ok(None) };
    let group = row.text("group")?;
    let note =
        Note::new("stand-in").with("table", id).with("group", group).with("material", shop.material().designation());
    Ok(Some((group, Because::row(row, note))))
}

/// The transition whose figures stand in for one that has none, by the rule `stand-in-operation`.
pub(crate) fn stand_in_operation<'k>(
    operation: Operation,
    shop: &impl Asking<'k>,
) -> Tried<(Operation, Because), Uncut> {
    let rule = shop.knowledge().table("stand-in-operation")?;
    let answer = rule.decide(&[("operation", Input::Text(operation.name()))])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, operation.name()))?;
    let instead = row.text("instead")?;
    let instead = Operation::from_name(instead).ok_or_else(|| KnowledgeError::no_row(rule, instead))?;
    let note = Note::new("stand-in-operation").with("operation", operation.name()).with("instead", instead.name());
    Ok((instead, Because::row(row, note)))
}

fn decide<'k>(
    table: &'k Table,
    others: &[(&str, Input<'_>)],
    group: &str,
) -> Result<Option<RowRef<'k>>, KnowledgeError> {
    let mut inputs = vec![("material_group", Input::Text(group))];
    inputs.extend_from_slice(others);
    match table.decide(&inputs) {
        // A figure beyond the table's reach is one that the table does not have.
        Err(QueryError::OutOfDomain { .. }) => Ok(None),
        answer => Ok(answer?.winner()),
    }
}

/// A table has no figure for this material, and nothing stands in.
pub fn missing<'k>(table: &Table, shop: &impl Asking<'k>) -> Refusal<Uncut> {
    let material = shop.material().designation().to_owned();
    Refusal::Not(Uncut::NoFigure { table: table.id.clone(), material })
}

/// A plain number of a row.
///
/// # Errors
/// The row has no number in that column.
pub fn number(row: RowRef<'_>, column: &str) -> Result<f64, KnowledgeError> {
    Ok(row.number_in(column, Unit::None)?)
}

/// Whether a speed row is for cutting with coolant; nothing where it does not say.
pub(crate) fn coolant(row: RowRef<'_>) -> Option<bool> {
    row.value("coolant").map(|value| *value == Value::Bool(true))
}

/// A number without a unit, for a query.
pub(crate) fn plain(value: f64) -> Input<'static> {
    Input::Number(Decimal::from_f64_rounded(value), Unit::None)
}

/// A feed, for a query.
pub fn feed_input(feed: MillimetresPerRev) -> Input<'static> {
    Input::Number(Decimal::from_f64_rounded(feed.0), Unit::MillimetrePerRev)
}
