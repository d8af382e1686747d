//! Why a row of the right size cannot be used: limits of the machine, the hole it enters, its depth.

use crate::knowledge::table::ToolHead;
use crate::knowledge::units::Micrometres;
use crate::machine::Machine;
use crate::plan::Operation;
use crate::reason::{CutterFault, Unfit};
use crate::tables::tools::CutterRow;

use super::cutter::CutterNeed;

/// Why a row of the right size cannot be used.
pub(super) fn refuse(
    row: &CutterRow<'_>,
    head: &ToolHead,
    need: &CutterNeed<'_>,
    machine: &Machine<'_>,
) -> Option<Unfit> {
    let fault = fault(row, head, need, machine)?;
    let tool = row.designations().next().unwrap_or_default();
    Some(Unfit::Cutter { tool: tool.to_owned(), table: row.row.table.id.clone(), fault })
}

fn fault(row: &CutterRow<'_>, head: &ToolHead, need: &CutterNeed<'_>, machine: &Machine<'_>) -> Option<CutterFault> {
    if matches!(need.operation, Operation::Drill | Operation::DrillOut) && need.diameter > machine.drill_max {
        return Some(CutterFault::DrillTooLarge { diameter: need.diameter, limit: machine.drill_max });
    }
    // An end mill is one whatever it cuts: as a counterbore, too, the spindle bears no wider one.
    if head.operations.contains(&Operation::Mill)
        && let Some(diameter) = row.diameter.filter(|own| *own > machine.end_mill_max)
    {
        return Some(CutterFault::MillTooLarge { diameter, limit: machine.end_mill_max });
    }
    if let (Some(down), Some(diameter)) = (need.plunges, row.diameter)
        && head.operations.contains(&Operation::Mill)
        && !head.centre_cutting
        && diameter > down.without_middle
    {
        return Some(CutterFault::NoTeethInMiddle { diameter, widest: down.without_middle });
    }
    // A bar is as wide as it is set.
    let set = need.operation.is_boring().then_some(need.diameter);
    if let Some(diameter) = row.diameter.or(set).filter(|own| *own > machine.tool_diameter_max) {
        return Some(CutterFault::TooWide { diameter, limit: machine.tool_diameter_max });
    }
    // What goes round sweeps the circle of its middle beside its own.
    let circle = need.round.map(|wider| need.diameter - row.tip_diameter.unwrap_or_default() - wider);
    let swept = row.diameter.map(|own| own + circle.unwrap_or_default());
    if let (Some(diameter), Some(within)) = (swept, need.entry_cylinder)
        && diameter >= within
    {
        return Some(CutterFault::DoesNotPass { diameter, within });
    }
    if need.operation == Operation::Counterbore
        && let Some(pilot) = row.pilot_bore.filter(|pilot| *pilot > need.enters)
    {
        return Some(CutterFault::PilotWider { pilot, hole: need.enters });
    }
    if need.operation.is_boring()
        && let Some(bar) = row.bar_diameter
        && bar >= need.enters
    {
        return Some(CutterFault::BarDoesNotEnter { bar, hole: need.enters });
    }
    if matches!(need.operation, Operation::CentreDrill | Operation::Countersink | Operation::Chamfer) {
        return None;
    }
    let reach = reach_of(row)?;
    // The teeth of a reamer are shorter than the hole; its neck must reach.
    let reach = if need.operation.is_reaming() { reach_of_reamer(row).unwrap_or(reach) } else { reach };
    let passes = |around: Micrometres| row.shank_diameter.is_some_and(|shank| shank < around);
    let needed = match need.hole_above {
        Some((start, around)) if passes(around) => need.reach - start,
        _ => need.reach,
    };
    if reach < needed {
        return Some(CutterFault::DoesNotReach { reach, needed });
    }
    let (flutes, room) = (row.flute_length?, need.chip_room);
    (room > Micrometres::ZERO && flutes < needed + room).then_some(CutterFault::FlutesClose { flutes, needed, room })
}

/// How deep a reamer goes: to the end of its neck, which is its whole overhang.
fn reach_of_reamer(row: &CutterRow<'_>) -> Option<Micrometres> {
    if row.projection.is_some() {
        return row.projection;
    }
    let length = row.length?;
    Some(match (row.shank_length, row.bore) {
        (Some(shank), _) => length - shank,
        // A shell reamer goes as deep as its arbor, which the holder checks.
        (None, Some(_)) => Micrometres::new(i64::MAX / 4),
        (None, None) => length,
    })
}

/// How deep a cutter goes by its own table: the first stated value of reach, flute, projection and cutting length. A
/// tap with a shank thinner than its tapping hole goes in as far as it projects from its chuck.
pub(super) fn reach_of(row: &CutterRow<'_>) -> Option<Micrometres> {
    if row.shank_follows() {
        return row.length;
    }
    row.reach.or(row.flute_length).or(row.projection).or(row.cutting_length)
}
