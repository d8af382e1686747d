//! Which rows of a table have the required size, and the existing sizes where none has.

use std::cmp::Reverse;
use std::rc::Rc;

use crate::error::KnowledgeError;
use crate::knowledge::units::Micrometres;
use crate::plan::Operation;
use crate::reason::NoSize;
use crate::shop::Shop;
use crate::tables::rules::{ToolTables, ToolTablesFor};
use crate::tables::tools::{BoringStage, CutterRow};

use super::cutter::{Cutter, CutterNeed, CutterReason, Tables, designation, is_grindable};
use super::holder::{first_holder, holders};
use super::reach::{reach_of, refuse};

/// Rows of the right size, in the order of trial: mills from the largest, cones and ground cutters from the smallest,
/// others in the order of the table.
pub(super) fn fitting<'s, 'k>(
    rows: &'s [CutterRow<'k>],
    need: &CutterNeed<'_>,
    ground: bool,
) -> Vec<&'s CutterRow<'k>> {
    let mut found: Vec<&CutterRow<'_>> = rows.iter().filter(|row| is_of_size(row, need, ground)).collect();
    match need.operation {
        Operation::Mill => found.sort_by_key(|row| Reverse(row.diameter)),
        Operation::Countersink | Operation::Chamfer => found.sort_by_key(|row| row.diameter),
        _ if ground => found.sort_by_key(|row| row.diameter),
        _ => {}
    }
    found
}

/// Whether a row has the right size. Centring: any wider one; boring: within the range of the bar; milling: what
/// enters; cone: its angle and any wider one; tapping: the thread; others: the size itself, or with `ground` a larger
/// one that may be ground down.
fn is_of_size(row: &CutterRow<'_>, need: &CutterNeed<'_>, ground: bool) -> bool {
    let own = row.diameter.unwrap_or_default();
    match need.operation {
        Operation::RoughBore | Operation::SemiFinishBore | Operation::FinishBore => {
            let rough = need.operation == Operation::RoughBore;
            row.stage == Some(if rough { BoringStage::Rough } else { BoringStage::Finish })
                && row.diameter_min.is_some_and(|low| low <= need.first_pass())
                && row.diameter_max.is_some_and(|high| need.diameter <= high)
        }
        Operation::CentreDrill => own >= need.diameter,
        Operation::Mill => {
            let enters = own + need.clearance <= need.enters;
            own > Micrometres::ZERO && (enters || need.plunges.is_some_and(|down| own <= down.widest))
        }
        Operation::Countersink | Operation::Chamfer => {
            let angle = f64::from(need.angle_millideg.unwrap_or_default());
            let fits = |tip: Micrometres| match need.round {
                Some(wider) => tip + wider <= own && tip + wider < need.enters,
                None => own >= need.diameter && tip < need.enters,
            };
            row.cone_angle.is_some_and(|own| (own.0 * 1000.0 - angle).abs() < 0.5) && row.tip_diameter.is_some_and(fits)
        }
        Operation::Tap => row.thread == need.thread,
        _ if ground => own > need.nominal && own - need.diameter <= need.grind_limit,
        _ => row.diameter == Some(need.nominal),
    }
}

/// Whether a row has a usable size, ground down if necessary.
pub(super) fn size_fits(row: &CutterRow<'_>, need: &CutterNeed<'_>) -> bool {
    is_of_size(row, need, false) || (is_grindable(need.operation) && is_of_size(row, need, true))
}

/// The refusal that no row has the size, with the nearest sizes below and above.
pub(super) fn nothing_of_size(need: &CutterNeed<'_>, rule: &ToolTables<'_>, tables: &Tables<'_, '_>) -> NoSize {
    let named = rule.tables.join(", ");
    let rows = || tables.iter().flat_map(|(_, rows)| rows.iter());
    if let Some(angle) = need.angle_millideg {
        return no_cone(need, angle, rows(), named);
    }
    if need.operation == Operation::Mill {
        return NoSize::NoMillEnters { hole: need.enters, clearance: need.clearance };
    }
    if let Some(thread) = need.thread.filter(|_| need.operation == Operation::Tap) {
        return NoSize::NoTap { thread: thread.to_owned(), tables: named };
    }
    // The diameter of a cutter, or the range of a boring bar.
    let sizes = || rows().flat_map(|row| [row.diameter, row.diameter_min, row.diameter_max]).flatten();
    let below = sizes().filter(|size| *size < need.nominal).max();
    let above = sizes().filter(|size| *size > need.nominal).min();
    NoSize::NoCutter { operation: need.operation, diameter: need.nominal, below, above, tables: named }
}

/// The refusal that no cutter has the angle, or that none with the angle is wide enough; names what there is.
fn no_cone<'s, 'k: 's>(
    need: &CutterNeed<'_>,
    angle: u32,
    rows: impl Iterator<Item = &'s CutterRow<'k>>,
    tables: String,
) -> NoSize {
    let cutters: Vec<(u32, Micrometres, Micrometres)> =
        rows.filter_map(|row| Some(((row.cone_angle?.0 * 1000.0) as u32, row.diameter?, row.tip_diameter?))).collect();
    let of_angle = || cutters.iter().filter(|(own, ..)| *own == angle);
    let widest = of_angle().map(|(_, diameter, _)| *diameter).max();
    let diameter = need.diameter;
    // Those wide enough have a front that does not enter the hole.
    if let Some(tip) = of_angle().filter(|(_, own, _)| *own >= diameter).map(|(.., tip)| *tip).min() {
        return NoSize::NoConeSoPointed { angle, diameter, tip, hole: need.enters, tables };
    }
    if let Some(widest) = widest {
        return NoSize::NoConeSoWide { angle, diameter, widest, hole: need.enters, tables };
    }
    let mut angles: Vec<u32> = cutters.into_iter().map(|(own, ..)| own).collect();
    angles.sort_unstable();
    angles.dedup();
    NoSize::NoConeOfAngle { angle, diameter, angles, tables }
}

/// A drill size with how deep it can be driven on a machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DrillSize {
    /// The drill's diameter.
    pub diameter: Micrometres,
    /// The deepest reach of the drills of that size that a holder takes within the machine's overhang.
    pub reach: Micrometres,
}

/// All drill sizes that this machine can hold, ascending: computed once and used for every hole.
///
/// # Errors
/// The knowledge base has no answer.
pub fn drill_sizes(shop: &Shop<'_>) -> Result<Vec<DrillSize>, KnowledgeError> {
    let tables = shop.shelf.cutters().iter().filter(|tables| tables.head.operations.contains(&Operation::Drill));
    let mut drills = Vec::new();
    for tables in tables {
        let holders = holders(tables.head, Operation::Drill, shop)?;
        let sized = tables.rows()?.iter().filter_map(|row| Some((row.diameter?, tables.head, row, holders)));
        drills.extend(sized.filter(|(diameter, ..)| *diameter <= shop.machine.drill_max));
    }
    drills.sort_by_key(|(diameter, ..)| *diameter);
    let mut sizes = Vec::new();
    for drills in drills.chunk_by(|a, b| a.0 == b.0) {
        let diameter = drills[0].0;
        let need = CutterNeed::plain(Operation::Drill, diameter);
        let operation = Operation::Drill;
        let rule = shop.knowledge.ask(&ToolTablesFor { operation, diameter })?.need(operation.name())?;
        let rule = Rc::new(rule);
        let mut reach = Micrometres::ZERO;
        for &(_, head, row, holders) in
            drills.iter().filter(|(.., row, _)| rule.tables.contains(&row.row.table.id.as_str()))
        {
            if refuse(row, head, &need, &shop.machine).is_some() {
                continue;
            }
            let by = CutterReason::Order { rule: Rc::clone(&rule), operation, ground: None, size: diameter };
            let cutter =
                Cutter { row, head, designation: designation(row, &need)?, diameter, reason: by, rejected: Vec::new() };
            if let Ok(mounted) = first_holder(&cutter, &need, holders, shop)? {
                reach = reach.max(reach_of(row).unwrap_or_default().min(mounted.overhang.length));
            }
        }
        if reach > Micrometres::ZERO {
            sizes.push(DrillSize { diameter, reach });
        }
    }
    Ok(sizes)
}
