//! Why a row of the right size cannot be used: the machine, the hole that it enters, how deep it goes.

use crate::knowledge::RowRef;
use crate::knowledge::units::Micrometres;
use crate::machine::Machine;
use crate::plan::Operation;
use crate::reason::{CutterFault, Unfit};

use super::cutter::CutterNeed;
use super::sizes::own_diameter;

/// Why a row of the right size cannot be used.
pub(super) fn refuse(row: RowRef<'_>, need: &CutterNeed<'_>, machine: &Machine<'_>) -> Option<Unfit> {
    let fault = fault(row, need, machine)?;
    let tool = row.table.result.first().and_then(|column| row.text(column).ok()).unwrap_or_default();
    Some(Unfit::Cutter { tool: tool.to_owned(), table: row.table.id.clone(), fault })
}

fn fault(row: RowRef<'_>, need: &CutterNeed<'_>, machine: &Machine<'_>) -> Option<CutterFault> {
    if matches!(need.operation, Operation::Drill | Operation::DrillOut) && need.diameter > machine.drill_max {
        return Some(CutterFault::DrillTooLarge { diameter: need.diameter, limit: machine.drill_max });
    }
    if need.operation == Operation::Mill
        && let Some(diameter) = own_diameter(row).filter(|own| *own > machine.end_mill_max)
    {
        return Some(CutterFault::MillTooLarge { diameter, limit: machine.end_mill_max });
    }
    if let Some(diameter) = own_diameter(row).filter(|own| *own > machine.tool_diameter_max) {
        return Some(CutterFault::TooWide { diameter, limit: machine.tool_diameter_max });
    }
    if let (Some(diameter), Some(within)) = (own_diameter(row), need.within)
        && diameter >= within
    {
        return Some(CutterFault::DoesNotPass { diameter, within });
    }
    if need.operation == Operation::Counterbore
        && let Some(pilot) = row.length_if_any("pilot_bore").filter(|pilot| *pilot > need.enters)
    {
        return Some(CutterFault::PilotWider { pilot, hole: need.enters });
    }
    if need.operation.is_boring()
        && let Ok(bar) = row.length("bar_diameter")
        && bar >= need.enters
    {
        return Some(CutterFault::BarDoesNotEnter { bar, hole: need.enters });
    }
    if matches!(need.operation, Operation::CentreDrill | Operation::Countersink | Operation::Chamfer) {
        return None;
    }
    let reach = reach_of(row)?;
    // A reamer's teeth are shorter than the hole; it is its neck that must reach.
    let reach = if need.operation.is_reaming() { reach_of_reamer(row).unwrap_or(reach) } else { reach };
    let passes = |around: Micrometres| row.length_if_any("shank_diameter").is_some_and(|shank| shank < around);
    let needed = match need.below {
        Some((start, around)) if passes(around) => need.reach - start,
        _ => need.reach,
    };
    (reach < needed).then_some(CutterFault::DoesNotReach { reach, needed })
}

/// How deep a reamer goes: to the end of its neck, which is all that stands out of the holder.
fn reach_of_reamer(row: RowRef<'_>) -> Option<Micrometres> {
    if let Ok(projection) = row.length("projection") {
        return Some(projection);
    }
    let length = row.length_if_any("length")?;
    match row.length("shank_length") {
        Ok(shank) => Some(length - shank),
        // A shell reamer goes as deep as its arbor, which the holder checks.
        Err(_) => Some(Micrometres::new(i64::MAX / 4)).filter(|_| row.length("bore").is_ok()).or(Some(length)),
    }
}

/// How deep a cutter goes by its own table: what is named first of these columns. A tap whose shank is
/// thinner than the hole under its thread follows it in, as far as it stands out of its chuck.
pub(super) fn reach_of(row: RowRef<'_>) -> Option<Micrometres> {
    if let (Some(pitch), Some(diameter), Some(shank)) =
        (row.length_if_any("pitch"), row.length_if_any("diameter"), row.length_if_any("shank_diameter"))
        && shank < diameter - pitch
    {
        return row.length_if_any("length");
    }
    ["reach", "flute_length", "projection", "cutting_length"].into_iter().find_map(|column| row.length_if_any(column))
}
