//! Cutters and holders that somebody else chose, by their designations: whether they exist, suit and fit.

use crate::error::KnowledgeError;
use crate::knowledge::table::ToolHead;
use crate::knowledge::units::{Micrometres, Unit};
use crate::knowledge::vocabulary::Shank;
use crate::knowledge::{Knowledge, RowRef, Table};
use crate::machine::Machine;
use crate::note::{Because, Note};
use crate::plan::Operation;
use crate::reason::{HolderFault, OfOther, Unfit};

use super::cutter::{Cutter, CutterNeed};
use super::holder;
use super::reach::refuse;
use super::sizes::{own_diameter, size_fits};

/// A cutter of a catalog with what its table says of all of them.
#[derive(Clone, Copy, Debug)]
pub struct NamedCutter<'k> {
    /// Its row.
    pub row: RowRef<'k>,
    /// The head of its table.
    pub head: &'k ToolHead,
    /// The designation asked for.
    pub designation: &'k str,
}

/// Every designation of the cutters' catalogs.
pub fn cutter_names(knowledge: &Knowledge) -> impl Iterator<Item = NamedCutter<'_>> {
    let tables = knowledge.tables().filter_map(|table| Some((table, table.tool.as_ref()?)));
    tables.flat_map(|(table, head)| {
        designations(table).map(move |(row, designation)| NamedCutter { row, head, designation })
    })
}

/// Every designation of the holders' catalogs.
pub fn holder_names(knowledge: &Knowledge) -> impl Iterator<Item = (RowRef<'_>, &str)> {
    knowledge.tables().filter(|table| table.id.starts_with("holders-")).flat_map(designations)
}

fn designations(table: &Table) -> impl Iterator<Item = (RowRef<'_>, &str)> {
    let columns =
        table.columns.iter().map(|column| column.name.as_str()).filter(|name| name.starts_with("designation"));
    columns.flat_map(|column| table.all_rows().filter_map(move |row| Some((row, row.text(column).ok()?))))
}

/// Why a cutter does not do what is asked of it; nothing where it does.
pub fn unsuited(cutter: &NamedCutter<'_>, need: &CutterNeed<'_>, machine: &Machine<'_>) -> Option<Unfit> {
    let operation = need.operation;
    if !cutter.head.operations.contains(&operation) {
        let transitions = cutter.head.operations.iter().map(|known| known.name()).collect::<Vec<_>>().join(", ");
        return Some(Unfit::OfOther(OfOther::Operation { operation, transitions }));
    }
    if !size_fits(cutter.row, need) {
        return Some(Unfit::OfOther(of_other_size(cutter.row, need)));
    }
    refuse(cutter.row, need, machine)
}

/// What of a cutter is not of the size that is asked: what its kind is chosen by.
fn of_other_size(row: RowRef<'_>, need: &CutterNeed<'_>) -> OfOther {
    let operation = need.operation;
    if operation.is_boring()
        && let (Some(low), Some(high)) = (row.length_if_any("diameter_min"), row.length_if_any("diameter_max"))
    {
        if low <= need.diameter && need.diameter <= high {
            return OfOther::Stage { rough: row.text("stage") == Ok("rough") };
        }
        return OfOther::Range { low, high, needed: need.diameter };
    }
    if let (Some(thread), Ok(own), Operation::Tap) = (need.thread, row.text("thread"), operation) {
        return OfOther::Thread { own: own.to_owned(), needed: thread.to_owned() };
    }
    let cone = need.angle_millideg.map(|angle| f64::from(angle) / 1000.0);
    if let (Some(needed), Ok(own)) = (cone, row.number_in("cone_angle", Unit::Degree))
        && (own - needed).abs() > 0.0005
    {
        return OfOther::Angle { own, needed };
    }
    OfOther::Size { own: own_diameter(row), needed: need.diameter }
}

/// Whether a designation is the other design of a cutter that is made for through and for blind holes.
pub fn of_other_bottom(cutter: &NamedCutter<'_>, through: bool) -> Option<Note> {
    let (own, other) = if through {
        ("designation_through", "designation_blind")
    } else {
        ("designation_blind", "designation_through")
    };
    let (right, stated) = (cutter.row.text(own).ok()?, cutter.row.text(other).ok()?);
    let code = if through { "tool-for-blind-holes" } else { "tool-for-through-holes" };
    (cutter.designation == stated && right != stated).then(|| Note::new(code).with("known", right))
}

/// The row of the rule `holder-for-shank` by which a cutter asks for another family of holders than this one's; nothing
/// where it is of that family.
///
/// # Errors
/// The knowledge cannot answer.
pub fn other_family<'k>(
    holder: RowRef<'_>,
    cutter: &NamedCutter<'_>,
    operation: Operation,
    knowledge: &'k Knowledge,
) -> Result<Option<(&'k Table, RowRef<'k>)>, KnowledgeError> {
    let family = holder::family(cutter.head, operation, knowledge)?;
    let Ok(id) = family.text("holders") else { return Ok(None) };
    Ok((holder.table.id != id).then_some((knowledge.table(id)?, family)))
}

/// Why a holder does not take a cutter; nothing where it does.
pub fn not_taken(holder: RowRef<'_>, cutter: &NamedCutter<'_>, machine: &Machine<'_>) -> Option<HolderFault> {
    // What a family of holders is chosen by stands in its columns.
    let takes = match cutter.head.shank {
        Shank::Cylindrical => "clamp_min",
        Shank::Morse => "morse",
        Shank::Shell => "bore",
        Shank::Taper => return None,
    };
    let tap_chuck = cutter.head.shank == Shank::Cylindrical && holder.table.column_index("thread_min").is_some();
    if holder.table.column_index(takes).is_none() && !tap_chuck {
        return Some(HolderFault::OtherShank { shank: cutter.head.shank.name() });
    }
    holder::refuse(holder, &as_cutter(cutter), machine)
}

/// How far a cutter may stand out by the rule of section 5.2 item 5: least, most, and why.
///
/// # Errors
/// The knowledge cannot answer.
pub fn overhang(
    cutter: &NamedCutter<'_>,
    operation: Operation,
    knowledge: &Knowledge,
) -> Result<(Micrometres, Micrometres, Because), KnowledgeError> {
    let need = CutterNeed::plain(operation, own_diameter(cutter.row).unwrap_or_default());
    let (most, because) = holder::overhang(&as_cutter(cutter), &need, knowledge)?;
    let ranged = holder::is_ranged(cutter.head.shank, operation);
    let least = match knowledge.table("clamping")?.find("name", "overhang-addition").filter(|_| ranged) {
        Some(row) => {
            let range = row.number_in("maximum", Unit::None)? - row.number_in("minimum", Unit::None)?;
            most - Micrometres::from_mm_rounded(range)
        }
        None => most,
    };
    Ok((least, most, because))
}

/// The angle of a cutter's point, degrees, where its table has one.
pub fn point_angle(cutter: &NamedCutter<'_>) -> Option<f64> {
    cutter.head.point_angle.map(|angle| angle.to_f64())
}

fn as_cutter<'k>(named: &NamedCutter<'k>) -> Cutter<'k> {
    let because = Because::row(named.row, Note::new("named"));
    Cutter {
        row: named.row,
        head: named.head,
        designation: named.designation,
        diameter: own_diameter(named.row).unwrap_or_default(),
        because: because.clone(),
        order: because,
    }
}
