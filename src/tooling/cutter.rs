//! Finding a cutter: the tables in the order of the rule `tool-tables`, the first row that fits, and
//! for every row of the right size that does not, the inequality that fails.

use crate::error::KnowledgeError;
use crate::knowledge::table::ToolHead;
use crate::knowledge::units::{Decimal, Micrometres, Unit};
use crate::knowledge::{Input, Knowledge, RowRef, Table};
use crate::machine::Machine;
use crate::note::{Because, Note};
use crate::plan::Operation;

/// A cutter of a catalog, as planning uses it.
#[derive(Clone, Debug)]
pub struct Cutter<'k> {
    /// Its row.
    pub row: RowRef<'k>,
    /// What its table says of all its cutters.
    pub head: &'k ToolHead,
    /// The designation that fits the hole (through or blind, lead angle).
    pub designation: &'k str,
    /// Its own diameter; for a boring bar the diameter it is set to.
    pub diameter: Micrometres,
    /// How it was chosen.
    pub because: Because,
    /// Why its table is asked in this order.
    pub order: Because,
}

/// What is asked of a cutter.
#[derive(Clone, Copy, Debug)]
pub struct CutterNeed<'a> {
    /// The transition.
    pub operation: Operation,
    /// The diameter it must leave.
    pub diameter: Micrometres,
    /// The nominal size of the catalog's cutter, where it is ground to another size.
    pub nominal: Micrometres,
    /// The diameter of the hole it enters; zero in solid metal.
    pub enters: Micrometres,
    /// How far it must reach into the hole.
    pub reach: Micrometres,
    /// Whether the hole goes through.
    pub through: bool,
    /// The lead angle of a reamer, by the rule `reamer-lead`.
    pub lead: &'a str,
    /// The id of a thread.
    pub thread: Option<&'a str>,
    /// Full angle of a cone, thousandths of a degree.
    pub angle_millideg: Option<u32>,
    /// The wider cylinder through which it reaches its place; absent at a face.
    pub within: Option<Micrometres>,
    /// Where its cut begins below the face, and how wide the hole is above that: a shank that passes there
    /// need not be counted.
    pub below: Option<(Micrometres, Micrometres)>,
    /// Room between an end mill and the hole it goes round in.
    pub clearance: Micrometres,
    /// By how much a reamer or core drill of the catalog may be ground down.
    pub grind_limit: Micrometres,
}

/// Every cutter that fits, in the order of the tables of the rule `tool-tables`, and why others of the
/// right size do not.
///
/// # Errors
/// The knowledge cannot answer.
pub(super) fn cutters<'k>(
    need: &CutterNeed<'_>,
    knowledge: &'k Knowledge,
    machine: &Machine<'_>,
) -> Result<(Vec<Cutter<'k>>, Vec<Note>), KnowledgeError> {
    let rule = knowledge.table("tool-tables")?;
    let answer =
        rule.decide(&[("operation", Input::Text(need.operation.name())), ("diameter", Input::Length(need.nominal))])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, need.operation.name()))?;
    let tables: Vec<&Table> =
        row.texts("tables")?.into_iter().map(|id| knowledge.table(id)).collect::<Result<_, _>>()?;
    // Only where no catalog has the size itself is a larger cutter ground down to it.
    let grindable = need.operation.is_reaming() || need.operation == Operation::CoreDrill;
    let ground = grindable && tables.iter().all(|table| fitting(table, need, false).is_empty());
    let (mut cutters, mut rejected) = (Vec::new(), Vec::new());
    for table in tables {
        let Some(head) = &table.tool else { continue };
        if !head.operations.iter().any(|operation| operation == need.operation.name()) {
            continue;
        }
        for candidate in fitting(table, need, ground) {
            if let Some(why) = refuse(candidate, need, machine) {
                rejected.push(why);
                continue;
            }
            let note =
                |code: &str| Note::new(code).with("operation", need.operation.name()).with("order", tables_of(row));
            let mut because = Because::row(candidate, note("cutter"));
            if ground {
                let own = own_diameter(candidate).unwrap_or_default();
                because.note = Note::new("cutter-ground-down").with("own", own).with("size", need.diameter);
                because.unconfirmed =
                    Some("the catalogs have no cutter of this size; it must be ground to order".to_owned());
            }
            cutters.push(Cutter {
                row: candidate,
                head,
                designation: designation(candidate, need)?,
                diameter: own_diameter(candidate).unwrap_or(need.diameter),
                because,
                order: Because::row(row, note("tool-tables")),
            });
        }
    }
    if cutters.is_empty() && rejected.is_empty() {
        rejected.push(nothing_of_size(need, row, knowledge));
    }
    Ok((cutters, rejected))
}

/// Step drills of both diameters, in the order of the tables; class A before B, as the tables have them.
///
/// # Errors
/// The knowledge cannot answer.
pub(super) fn step_drills<'k>(
    need: &CutterNeed<'_>,
    wide: Micrometres,
    pilot: Micrometres,
    opening: Operation,
    knowledge: &'k Knowledge,
) -> Result<(Vec<Cutter<'k>>, Vec<Note>), KnowledgeError> {
    let (mut cutters, mut rejected) = (Vec::new(), Vec::new());
    for table in knowledge.tables().filter(|table| table.column_index("step_diameter").is_some()) {
        let Some(head) = &table.tool else { continue };
        // A flat step for screw heads, or a cone for the chamfer of a thread.
        if !head.operations.iter().any(|operation| operation == opening.name()) {
            continue;
        }
        for row in table.all_rows() {
            if own_diameter(row) != Some(need.diameter) || row.length_if_any("step_diameter") != Some(wide) {
                continue;
            }
            let designation = designation(row, need)?;
            let length = row.length("step_length")?;
            if length < pilot {
                let note = Note::new("does-not-reach").with("tool", designation).with("table", &table.id);
                rejected.push(note.with("reach", length).with("needed", pilot));
                continue;
            }
            let note = Note::new("step-drill").with("narrow", need.diameter).with("wide", wide);
            cutters.push(Cutter {
                row,
                head,
                designation,
                diameter: need.diameter,
                because: Because::row(row, note.clone()),
                order: Because::table(table, note),
            });
        }
    }
    if cutters.is_empty() && rejected.is_empty() {
        rejected.push(Note::new("no-step-drill").with("narrow", need.diameter).with("wide", wide));
    }
    Ok((cutters, rejected))
}

fn tables_of(row: RowRef<'_>) -> String {
    row.value("tables").map(ToString::to_string).unwrap_or_default()
}

/// The diameter printed for a cutter of one size; nothing for a boring bar, which is set.
pub(super) fn own_diameter(row: RowRef<'_>) -> Option<Micrometres> {
    row.length_if_any("diameter")
}

/// Rows of the right size: for centring every wider one; for boring the bar's range; for milling what
/// enters, largest first; for a cone its angle and every wider one; for tapping the thread; for the others
/// the size itself, or with `ground` the next larger that may be ground down to it.
fn fitting<'k>(table: &'k Table, need: &CutterNeed<'_>, ground: bool) -> Vec<RowRef<'k>> {
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

/// Why a row of the right size cannot be used.
pub(super) fn refuse(row: RowRef<'_>, need: &CutterNeed<'_>, machine: &Machine<'_>) -> Option<Note> {
    let name = row.table.result.first().and_then(|column| row.text(column).ok()).unwrap_or_default();
    let note = |code: &str| Note::new(code).with("tool", name).with("table", &row.table.id);
    if matches!(need.operation, Operation::Drill | Operation::DrillOut) && need.diameter > machine.drill_max {
        return Some(note("drill-too-large").with("diameter", need.diameter).with("limit", machine.drill_max));
    }
    if need.operation == Operation::Mill
        && let Some(own) = own_diameter(row).filter(|own| *own > machine.end_mill_max)
    {
        return Some(note("mill-too-large").with("diameter", own).with("limit", machine.end_mill_max));
    }
    if let Some(own) = own_diameter(row).filter(|own| *own > machine.tool_diameter_max) {
        return Some(note("tool-too-wide").with("diameter", own).with("limit", machine.tool_diameter_max));
    }
    if let (Some(own), Some(within)) = (own_diameter(row), need.within)
        && own >= within
    {
        return Some(note("does-not-pass").with("diameter", own).with("within", within));
    }
    if need.operation == Operation::Counterbore
        && let Some(pilot) = row.length_if_any("pilot_bore").filter(|pilot| *pilot > need.enters)
    {
        return Some(note("pilot-wider-than-hole").with("pilot", pilot).with("hole", need.enters));
    }
    if need.operation.is_boring()
        && let Ok(bar) = row.length("bar_diameter")
        && bar >= need.enters
    {
        return Some(note("bar-does-not-enter").with("bar", bar).with("hole", need.enters));
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
    (reach < needed).then(|| note("does-not-reach").with("reach", reach).with("needed", needed))
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

fn designation<'k>(row: RowRef<'k>, need: &CutterNeed<'_>) -> Result<&'k str, KnowledgeError> {
    let by_bottom = if need.through { "designation_through" } else { "designation_blind" };
    let by_lead = if need.lead == "5deg" { "designation_5deg" } else { "designation_15deg" };
    for column in ["designation", by_bottom, by_lead] {
        if row.table.column_index(column).is_some() {
            return Ok(row.text(column)?);
        }
    }
    Ok(row.text("designation")?)
}

/// No row has that size: says so, with the nearest sizes below and above.
fn nothing_of_size(need: &CutterNeed<'_>, rule: RowRef<'_>, knowledge: &Knowledge) -> Note {
    if let Some(angle) = need.angle_millideg {
        return no_cone(need, angle, rule, knowledge);
    }
    if need.operation == Operation::Mill {
        return Note::new("no-mill-enters").with("hole", need.enters).with("clearance", need.clearance);
    }
    if let Some(thread) = need.thread.filter(|_| need.operation == Operation::Tap) {
        return Note::new("no-tap").with("thread", thread).with("tables", tables_of(rule));
    }
    let sizes: Vec<Micrometres> = rule
        .texts("tables")
        .unwrap_or_default()
        .into_iter()
        .filter_map(|id| knowledge.table(id).ok())
        .flat_map(|table| table.all_rows().flat_map(sizes_of).collect::<Vec<_>>())
        .collect();
    let below = sizes.iter().filter(|size| **size < need.nominal).max();
    let above = sizes.iter().filter(|size| **size > need.nominal).min();
    let show = |size: Option<&Micrometres>| size.map_or_else(|| "-".to_owned(), |size| format!("Ø{size}"));
    Note::new("no-cutter-of-size")
        .with("operation", need.operation.name())
        .with("diameter", need.nominal)
        .with("below", show(below))
        .with("above", show(above))
        .with("tables", tables_of(rule))
}

/// No cutter has that angle, or none of that angle is wide enough: what there is.
fn no_cone(need: &CutterNeed<'_>, angle: u32, rule: RowRef<'_>, knowledge: &Knowledge) -> Note {
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
    let degrees = |angle: u32| Decimal::from_f64_rounded(f64::from(angle) / 1000.0).to_string();
    let widest = cutters.iter().filter(|(own, _)| *own == angle).map(|(_, diameter)| *diameter).max();
    let note = |code: &str| {
        Note::new(code).with("angle", degrees(angle)).with("diameter", need.diameter).with("tables", tables_of(rule))
    };
    if let Some(widest) = widest {
        return note("no-cone-so-wide").with("widest", widest).with("hole", need.enters);
    }
    let mut angles: Vec<u32> = cutters.into_iter().map(|(own, _)| own).collect();
    angles.sort_unstable();
    angles.dedup();
    note("no-cone-of-angle").with("angles", angles.into_iter().map(degrees).collect::<Vec<_>>().join(", "))
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
        .filter(|table| table.tool.as_ref().is_some_and(|head| head.operations.iter().any(|name| name == "drill")))
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

impl CutterNeed<'_> {
    /// A cutter of that diameter and any reach, with nothing else asked of it.
    pub fn plain(operation: Operation, diameter: Micrometres) -> Self {
        Self {
            operation,
            diameter,
            nominal: diameter,
            enters: Micrometres::ZERO,
            reach: Micrometres::ZERO,
            through: true,
            lead: "",
            thread: None,
            angle_millideg: None,
            within: None,
            below: None,
            clearance: Micrometres::ZERO,
            grind_limit: Micrometres::ZERO,
        }
    }
}

/// How deep a cutter goes by its own table: what is named first of these columns. A tap whose shank is
/// thinner than the hole under its thread follows it in, as far as it stands out of its chuck.
fn reach_of(row: RowRef<'_>) -> Option<Micrometres> {
    if let (Some(pitch), Some(diameter), Some(shank)) =
        (row.length_if_any("pitch"), row.length_if_any("diameter"), row.length_if_any("shank_diameter"))
        && shank < diameter - pitch
    {
        return row.length_if_any("length");
    }
    ["reach", "flute_length", "projection", "cutting_length"].into_iter().find_map(|column| row.length_if_any(column))
}
