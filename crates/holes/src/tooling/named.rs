//! Cutters and holders named by designation: whether they exist, suit the work and fit.

use crate::error::KnowledgeError;
use crate::knowledge::table::ToolHead;
use crate::knowledge::units::Micrometres;
use crate::knowledge::vocabulary::Shank;
use crate::knowledge::{Knowledge, Table, TableError};
use crate::machine::Machine;
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::reason::{HolderFault, OfOther, Unfit};
use crate::shop::Shop;
use crate::tables::holders::HolderRow;
use crate::tables::rules::HolderForShank;
use crate::tables::tools::{BoringStage, CutterRow};

use super::cutter::{Cutter, CutterNeed, CutterReason};
use super::holder;
use super::reach::refuse;
use super::sizes::size_fits;

/// A cutter of a catalog with the head of its table.
#[derive(Clone, Debug)]
pub struct NamedCutter<'k> {
    /// Its row.
    pub row: CutterRow<'k>,
    /// The head of its table.
    pub head: &'k ToolHead,
    /// The designation asked for.
    pub designation: &'k str,
}

/// All designations in the catalogs of cutters.
///
/// # Errors
/// A row breaks its contract; this does not happen to checked tables.
pub fn cutter_names(knowledge: &Knowledge) -> Result<Vec<NamedCutter<'_>>, TableError> {
    let mut names = Vec::new();
    for table in knowledge.tables_of_cutters() {
        let Some(head) = &table.tool else { continue };
        let rows: Vec<CutterRow<'_>> = table.rows().collect::<Result<_, _>>()?;
        // One column of designations after the other, in the order of the table.
        for kind in 0..rows.iter().map(|row| row.designations().count()).max().unwrap_or_default() {
            let named = rows.iter().filter_map(|row| Some((row, row.designations().nth(kind)?)));
            names.extend(named.map(|(row, designation)| NamedCutter { row: row.clone(), head, designation }));
        }
    }
    Ok(names)
}

/// Every holder of the catalogs.
///
/// # Errors
/// As for [`cutter_names`].
pub fn holders(knowledge: &Knowledge) -> Result<Vec<HolderRow<'_>>, TableError> {
    knowledge.tables_of::<HolderRow<'_>>().flat_map(Table::rows).collect()
}

/// Why a cutter is not suitable; none if it is.
pub fn unsuited(cutter: &NamedCutter<'_>, need: &CutterNeed<'_>, machine: &Machine<'_>) -> Option<Unfit> {
    let operation = need.operation;
    if !cutter.head.operations.contains(&operation) {
        let transitions = cutter.head.operations.clone();
        return Some(Unfit::OfOther(OfOther::Operation { operation, transitions }));
    }
    if !size_fits(&cutter.row, need) {
        return Some(Unfit::OfOther(of_other_size(&cutter.row, need)));
    }
    refuse(&cutter.row, cutter.head, need, machine)
}

/// Which size that identifies the kind of a cutter differs from the required one.
fn of_other_size(row: &CutterRow<'_>, need: &CutterNeed<'_>) -> OfOther {
    let operation = need.operation;
    if operation.is_boring()
        && let (Some(low), Some(high)) = (row.diameter_min, row.diameter_max)
    {
        if low <= need.diameter && need.diameter <= high {
            return OfOther::Stage { rough: row.stage == Some(BoringStage::Rough) };
        }
        return OfOther::Range { low, high, needed: need.diameter };
    }
    if let (Some(thread), Some(own), Operation::Tap) = (need.thread, row.thread, operation) {
        return OfOther::Thread { own: own.to_owned(), needed: thread.to_owned() };
    }
    let cone = need.angle_millideg.map(|angle| f64::from(angle) / 1000.0);
    if let (Some(needed), Some(own)) = (cone, row.cone_angle)
        && (own.0 - needed).abs() > 0.0005
    {
        return OfOther::Angle { own: own.0, needed };
    }
    OfOther::Size { own: row.diameter, needed: need.diameter }
}

/// Whether a designation is the other design of a cutter that exists for through and for blind holes.
pub fn other_design_note(cutter: &NamedCutter<'_>, through: bool) -> Option<Note> {
    let (for_through, for_blind) = (cutter.row.designation_through?, cutter.row.designation_blind?);
    let (right, stated) = if through { (for_through, for_blind) } else { (for_blind, for_through) };
    let code = if through { "tool-for-blind-holes" } else { "tool-for-through-holes" };
    (cutter.designation == stated && right != stated).then(|| Note::new(code).with("known", right))
}

/// The row of the rule `holder-for-shank` by which a cutter requires another family of holders than that of this
/// holder; none if the family is right.
///
/// # Errors
/// The knowledge base has no answer.
pub fn other_family<'k>(
    holder: &HolderRow<'_>,
    cutter: &NamedCutter<'_>,
    operation: Operation,
    knowledge: &'k Knowledge,
) -> Result<Option<(&'k Table, HolderForShank<'k>)>, KnowledgeError> {
    let family = holder::family(cutter.head, operation, knowledge)?;
    let Some(id) = family.holders else { return Ok(None) };
    Ok((holder.row.table.id != id).then_some((knowledge.table(id)?, family)))
}

/// Why a holder does not take a cutter; none if it does.
pub fn not_taken(holder: &HolderRow<'_>, cutter: &NamedCutter<'_>, machine: &Machine<'_>) -> Option<HolderFault> {
    // The rows of a family of holders state the values by which it is chosen.
    let takes = match cutter.head.shank {
        Shank::Cylindrical => holder.clamp_min.is_some() || holder.thread_min.is_some(),
        Shank::Morse => holder.morse.is_some(),
        Shank::Shell => holder.bore.is_some(),
        Shank::Taper => return None,
    };
    if !takes {
        return Some(HolderFault::OtherShank { shank: cutter.head.shank.name() });
    }
    holder::refuse(holder, &as_cutter(cutter), machine)
}

/// The permitted overhang of a cutter by section 5.2 item 5: least, most, and the reason.
///
/// # Errors
/// The knowledge base has no answer.
pub fn overhang<'k>(
    cutter: &NamedCutter<'k>,
    operation: Operation,
    shop: &Shop<'k>,
) -> Result<(Micrometres, Micrometres, Because), KnowledgeError> {
    let need = CutterNeed::plain(operation, cutter.row.diameter.unwrap_or_default());
    let overhang = holder::overhang(&as_cutter(cutter), &need, shop)?;
    let (most, because) = (overhang.length, overhang.because());
    if !holder::is_ranged(cutter.head.shank, operation) {
        return Ok((most, most, because));
    }
    let addition = holder::overhang_addition(shop)?;
    Ok((most - Micrometres::from_mm_rounded(addition.maximum - addition.minimum), most, because))
}

/// The angle of a cutter's point, degrees, where its table has one.
pub fn point_angle(cutter: &NamedCutter<'_>) -> Option<f64> {
    cutter.head.point_angle.map(|angle| angle.to_f64())
}

fn as_cutter<'s, 'k>(named: &'s NamedCutter<'k>) -> Cutter<'s, 'k> {
    Cutter {
        row: &named.row,
        head: named.head,
        designation: named.designation,
        diameter: named.row.diameter.unwrap_or_default(),
        reason: CutterReason::Named,
        rejected: Vec::new(),
    }
}
