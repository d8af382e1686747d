//! The permitted range of the figures of a part: that of every table that planning queries with them directly.

use crate::knowledge::yaml::Node;
use crate::knowledge::{Column, Knowledge, Value};
use crate::tables::cutting::{MillingFinishFeed, MillingFinishFeedFor};
use crate::tables::rules::{ReamingFeedCondition, ReamingFeedConditionFor};
use crate::units::{Micrometres, Roughness};
use technolog_note::{Note, note};

use super::read::Reader;
use super::{Part, ToleratedDiameter};

fn roughness_help() -> Note {
    note!("part-roughness-micrometres-ra-rz")
}

fn free_size_help() -> Note {
    note!("part-free-size-within-grades")
}

impl Reader<'_> {
    /// A roughness that every table knows.
    pub(super) fn roughness(&mut self, node: &Node) -> Option<Roughness> {
        let roughness = self.problems.scalar(node)?;
        match outside(roughness, self.knowledge) {
            Some(message) => self.problems.error_help("bad-value", message, &node.place, roughness_help()),
            None => Some(roughness),
        }
    }

    /// A diameter without a tolerance, which the table of grades knows.
    pub(super) fn free_size(&mut self, node: &Node) -> Option<Micrometres> {
        let diameter = self.positive(node, "diameter")?;
        match ToleratedDiameter::free(diameter, self.knowledge) {
            Ok(_) => Some(diameter),
            Err(message) => self.problems.error_help("bad-diameter", message, &node.place, free_size_help()),
        }
    }
}

impl Part {
    /// The first figure outside a table that is queried with it, in words, and the remedy; for a part that was not
    /// read by [`super::read_part`].
    pub fn outside_tables(&self, knowledge: &Knowledge) -> Option<(Note, Note)> {
        let of_steps = self.holes.iter().flat_map(|hole| &hole.steps).map(|step| step.roughness);
        let mut all = self.holes.iter().map(|hole| hole.roughness).chain(of_steps);
        let rough = all.find_map(|roughness| outside(roughness, knowledge)).map(|message| (message, roughness_help()));
        rough.or_else(|| {
            let mut free = self.holes.iter().filter_map(|hole| hole.counterbore);
            let message = free.find_map(|bore| ToleratedDiameter::free(bore.diameter, knowledge).err())?;
            Some((message, free_size_help()))
        })
    }
}

/// The fault of a roughness. The columns are those that are queried with it; other tables are queried with the
/// nearest value that they have.
fn outside(roughness: Roughness, knowledge: &Knowledge) -> Option<Note> {
    let milling =
        knowledge.tables_of::<MillingFinishFeed>().map(|table| (table, MillingFinishFeedFor::roughness(table)));
    let reaming = knowledge.tables_of::<ReamingFeedCondition<'_>>();
    let reaming = reaming.map(|table| (table, ReamingFeedConditionFor::roughness(table)));
    milling.chain(reaming).find_map(|(table, column)| {
        let column: &Column = column?;
        let (domain, rank) = (column.allowed(), column.rank(&Value::Roughness(roughness))?);
        let (low, high) = (domain.intervals().first()?.0, domain.intervals().last()?.1);
        let (low, high) = (column.show_rank(low), column.show_rank(high));
        let message =
            note!("part-outside-which-table-covers", roughness = roughness, low = low, high = high, table = table.id);
        (!domain.contains(rank)).then_some(message)
    })
}
