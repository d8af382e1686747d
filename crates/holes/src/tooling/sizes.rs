//! Which rows of a table are of the size that is asked, and what sizes there are where none is.

use crate::error::KnowledgeError;
use crate::knowledge::units::{Micrometres, Unit};
use crate::knowledge::{Knowledge, RowRef, Table};
use crate::machine::Machine;
use crate::plan::Operation;
use crate::reason::NoSize;

use super::cutter::{CutterNeed, cutters, tables_of};
use super::reach::reach_of;

/// The diameter printed for a cutter of one size; nothing for a boring bar, which is set.
pub(super) fn own_diameter(row: RowRef<'_>) -> Option<Micrometres> {
    row.length_if_any("diameter")
}

/// Rows of the right size: for centring every wider one; for boring the bar's range; for milling what
/// enters, largest first; for a cone its angle and every wider one; for tapping the thread; for the others
/// the size itself, or with `ground` the next larger that may be ground down to it.
pub(super) fn fitting<'k>(table: &'k Table, need: &CutterNeed<'_>, ground: bool) -> Vec<RowRef<'k>> {
    let rows = table.all_rows();
    let own = |row: &RowRef<'k>| own_diameter(*row).unwrap_or_default();
    match need.operation {
        Operation::RoughBore | Operation::SemiFinishBore | Operation::FinishBore => {
            let stage = if need.operation == Operation::RoughBore { "rough" } else { "finish" };
            rows.filter(|row| row.text("stage") == Ok(stage))
                .filter(|row| {
                    let range = (row.length("diameter_min"), row.length("diameter_max"));
                    matches!(range, (Ok(low), Ok(high)) if low <= need.diameter && need.diameter <= high)
                })
                .collect()
        }
        Operation::CentreDrill => rows.filter(|row| own(row) >= need.diameter).collect(),
        Operation::Mill => {
            let mut found: Vec<RowRef<'k>> =
                rows.filter(|row| own(row) + need.clearance <= need.enters && own(row) > Micrometres::ZERO).collect();
            found.sort_by_key(|row| (std::cmp::Reverse(own(row)), row.index));
            found
        }
        Operation::Countersink | Operation::Chamfer => {
            let angle = need.angle_millideg.unwrap_or_default();
            let mut found: Vec<RowRef<'k>> = rows
                .filter(|row| own(row) >= need.diameter)
                .filter(|row| {
                    row.number_in("cone_angle", Unit::Degree)
                        .is_ok_and(|own| (own * 1000.0 - f64::from(angle)).abs() < 0.5)
                })
                .filter(|row| row.length("tip_diameter").is_ok_and(|tip| tip < need.enters))
                .collect();
            found.sort_by_key(|row| (own(row), row.index));
            found
        }
        Operation::Tap => rows.filter(|row| row.text("thread").ok() == need.thread).collect(),
        _ if ground => {
            let mut found: Vec<RowRef<'k>> =
                rows.filter(|row| own(row) > need.nominal && own(row) - need.nominal <= need.grind_limit).collect();
            found.sort_by_key(|row| (own(row), row.index));
            found
        }
        _ => rows.filter(|row| own_diameter(*row) == Some(need.nominal)).collect(),
    }
}

/// Whether a row is of a size that does what is asked, ground down to it if need be.
pub(super) fn size_fits(row: RowRef<'_>, need: &CutterNeed<'_>) -> bool {
    let held = |ground: bool| fitting(row.table, need, ground).iter().any(|one| one.index == row.index);
    held(false) || ((need.operation.is_reaming() || need.operation == Operation::CoreDrill) && held(true))
}

/// No row has that size: says so, with the nearest sizes below and above.
pub(super) fn nothing_of_size(need: &CutterNeed<'_>, rule: RowRef<'_>, knowledge: &Knowledge) -> NoSize {
    if let Some(angle) = need.angle_millideg {
        return no_cone(need, angle, rule, knowledge);
    }
    let tables = tables_of(rule);
    if need.operation == Operation::Mill {
        return NoSize::NoMillEnters { hole: need.enters, clearance: need.clearance };
    }
    if let Some(thread) = need.thread.filter(|_| need.operation == Operation::Tap) {
        return NoSize::NoTap { thread: thread.to_owned(), tables };
    }
    let sizes: Vec<Micrometres> = rule
        .texts("tables")
        .unwrap_or_default()
        .into_iter()
        .filter_map(|id| knowledge.table(id).ok())
        .flat_map(|table| table.all_rows().flat_map(sizes_of).collect::<Vec<_>>())
        .collect();
    let below = sizes.iter().copied().filter(|size| *size < need.nominal).max();
    let above = sizes.into_iter().filter(|size| *size > need.nominal).min();
    NoSize::NoCutter { operation: need.operation, diameter: need.nominal, below, above, tables }
}

/// No cutter has that angle, or none of that angle is wide enough: what there is.
fn no_cone(need: &CutterNeed<'_>, angle: u32, rule: RowRef<'_>, knowledge: &Knowledge) -> NoSize {
    let rows = rule
        .texts("tables")
        .unwrap_or_default()
        .into_iter()
        .filter_map(|id| knowledge.table(id).ok())
        .flat_map(|table| table.all_rows().collect::<Vec<_>>());
    let cutters: Vec<(u32, Micrometres)> = rows
        .filter_map(|row| {
            let own = (row.number_in("cone_angle", Unit::Degree).ok()? * 1000.0) as u32;
            Some((own, own_diameter(row)?))
        })
        .collect();
    let widest = cutters.iter().filter(|(own, _)| *own == angle).map(|(_, diameter)| *diameter).max();
    let (diameter, tables) = (need.diameter, tables_of(rule));
    if let Some(widest) = widest {
        return NoSize::NoConeSoWide { angle, diameter, widest, hole: need.enters, tables };
    }
    let mut angles: Vec<u32> = cutters.into_iter().map(|(own, _)| own).collect();
    angles.sort_unstable();
    angles.dedup();
    NoSize::NoConeOfAngle { angle, diameter, angles, tables }
}

/// The sizes a row stands for: a cutter's diameter, a boring bar's range.
fn sizes_of(row: RowRef<'_>) -> Vec<Micrometres> {
    ["diameter", "diameter_min", "diameter_max"].into_iter().filter_map(|column| row.length_if_any(column)).collect()
}

/// A drill size with how deep it can be driven on a machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DrillSize {
    /// The drill's diameter.
    pub diameter: Micrometres,
    /// The deepest reach of the drills of that size that a holder takes within the machine's overhang.
    pub reach: Micrometres,
}

/// Every drill size that this machine can hold, ascending: found once, asked for every hole.
///
/// # Errors
/// The knowledge cannot answer.
pub fn drill_sizes(knowledge: &Knowledge, machine: &Machine<'_>) -> Result<Vec<DrillSize>, KnowledgeError> {
    let mut diameters: Vec<Micrometres> = knowledge
        .tables()
        .filter(|table| table.tool.as_ref().is_some_and(|head| head.operations.contains(&Operation::Drill)))
        .flat_map(Table::all_rows)
        .filter_map(own_diameter)
        .filter(|diameter| *diameter <= machine.drill_max)
        .collect();
    diameters.sort_unstable();
    diameters.dedup();
    let mut sizes = Vec::with_capacity(diameters.len());
    for diameter in diameters {
        let need = CutterNeed::plain(Operation::Drill, diameter);
        let (cutters, _) = cutters(&need, knowledge, machine)?;
        let mut reach = Micrometres::ZERO;
        for cutter in cutters {
            if let Ok(assembly) = super::holder::assemble(&cutter, &need, knowledge, machine)? {
                reach = reach.max(reach_of(cutter.row).unwrap_or_default().min(assembly.overhang));
            }
        }
        if reach > Micrometres::ZERO {
            sizes.push(DrillSize { diameter, reach });
        }
    }
    Ok(sizes)
}
