//! Holders: which one takes a shank, how far the cutter stands out, how long the assembly is.

use crate::error::KnowledgeError;
use crate::knowledge::table::ToolHead;
use crate::knowledge::units::{Micrometres, Unit};
use crate::knowledge::vocabulary::Shank;
use crate::knowledge::{Input, Knowledge, RowRef};
use crate::machine::Machine;
use crate::note::{Because, Note};
use crate::plan::{Link, Operation};
use crate::reason::{HolderFault, Unfit};

use super::{Cutter, CutterNeed};

/// A cutter in its holder.
#[derive(Clone, Debug)]
pub struct Assembly {
    /// The holder's designation; the cutter's own when it carries the machine's taper.
    pub holder: String,
    /// The holder's table.
    pub holder_table: String,
    /// Length of the holder, from the spindle's face.
    pub holder_length: Micrometres,
    /// How far the cutter stands out of the holder.
    pub overhang: Micrometres,
    /// From the spindle's face to the tip.
    pub length: Micrometres,
    /// From the spindle to the tip: the 7:24 shank, the holder, the cutter.
    pub links: Vec<Link>,
    /// Mass of holder and cutter, kg, where the holder's is known; the cutter is taken as a steel bar.
    pub mass_kg: Option<f64>,
    /// Why.
    pub because: Vec<Because>,
}

/// Puts a cutter into the first holder that takes it.
///
/// # Errors
/// The knowledge cannot answer. That no holder fits is not an error: the inner `Err` says why.
pub fn assemble(
    cutter: &Cutter<'_>,
    need: &CutterNeed<'_>,
    knowledge: &Knowledge,
    machine: &Machine<'_>,
) -> Result<Result<Assembly, Vec<Unfit>>, KnowledgeError> {
    let (overhang, overhang_because) = overhang(cutter, need, knowledge)?;
    let taper = Link {
        kind: "taper-7-24".to_owned(),
        designation: machine.taper.to_string(),
        table: "taper-7-24".to_owned(),
        length_mm: Micrometres::ZERO,
    };
    let tip = Link {
        kind: "cutter".to_owned(),
        designation: cutter.designation.to_owned(),
        table: cutter.row.table.id.clone(),
        length_mm: overhang,
    };
    if cutter.head.shank == Shank::Taper {
        let assembly = Assembly {
            holder: cutter.designation.to_owned(),
            holder_table: cutter.row.table.id.clone(),
            holder_length: Micrometres::ZERO,
            overhang,
            length: overhang,
            links: vec![taper, tip],
            mass_kg: cutter.row.number_in("mass", Unit::Kilogram).ok(),
            because: vec![overhang_because],
        };
        return Ok(within_limits(assembly, cutter, machine));
    }
    let family = family(cutter.head, need.operation, knowledge)?;
    let table = knowledge.table(family.text("holders")?)?;
    let mut rejected = Vec::new();
    for row in table.all_rows() {
        let designation = row.text("designation")?;
        let length = row.length("length")?;
        let why = refuse(row, cutter, machine).or_else(|| too_short(row, cutter, length, overhang, need));
        if let Some(fault) = why {
            rejected.push((designation, fault));
            continue;
        }
        let over = rejected.iter().map(|(holder, fault)| fault.note().with("holder", holder)).collect();
        let note = Note::new("holder").with("shank", cutter.head.shank.name());
        let assembly = Assembly {
            holder: designation.to_owned(),
            holder_table: table.id.clone(),
            holder_length: length,
            overhang,
            length: length + overhang,
            links: vec![
                taper,
                Link {
                    kind: "holder".to_owned(),
                    designation: designation.to_owned(),
                    table: table.id.clone(),
                    length_mm: length,
                },
                tip,
            ],
            mass_kg: row.number_in("mass", Unit::Kilogram).ok().map(|holder| holder + bar_mass(cutter)),
            because: vec![Because::row(row, note).over(over), overhang_because],
        };
        return Ok(within_limits(assembly, cutter, machine));
    }
    Ok(Err(rejected.into_iter().map(|(holder, fault)| unfit(cutter, holder, fault)).collect()))
}

/// The row of the rule `holder-for-shank` that names the family of holders for a shank.
pub(super) fn family<'k>(
    head: &ToolHead,
    operation: Operation,
    knowledge: &'k Knowledge,
) -> Result<RowRef<'k>, KnowledgeError> {
    let rule = knowledge.table("holder-for-shank")?;
    // End mills with a Morse shank are drawn in by a thread, drills are driven by a tang.
    let mills = head.operations.contains(&Operation::Mill);
    let drawbar = head.shank == Shank::Morse && mills;
    let answer = rule.decide(&[
        ("shank", Input::Text(head.shank.name())),
        ("drawbar", Input::Bool(drawbar)),
        ("tap", Input::Bool(operation == Operation::Tap)),
    ])?;
    answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, head.shank.name()))
}

fn unfit(cutter: &Cutter<'_>, holder: &str, fault: HolderFault) -> Unfit {
    Unfit::Holder { tool: cutter.designation.to_owned(), holder: holder.to_owned(), fault }
}

fn within_limits(assembly: Assembly, cutter: &Cutter<'_>, machine: &Machine<'_>) -> Result<Assembly, Vec<Unfit>> {
    if assembly.length > machine.overhang_max {
        let fault = HolderFault::TooLong { length: assembly.length, limit: machine.overhang_max };
        return Err(vec![unfit(cutter, &assembly.holder, fault)]);
    }
    if let Some(mass) = assembly.mass_kg.filter(|mass| *mass > machine.tool_mass_max_kg) {
        let fault = HolderFault::TooHeavy { mass, limit: machine.tool_mass_max_kg };
        return Err(vec![unfit(cutter, &assembly.holder, fault)]);
    }
    Ok(assembly)
}

/// Mass of a steel bar as thick and long as the cutter, kg: above the cutter's own, which has flutes.
fn bar_mass(cutter: &Cutter<'_>) -> f64 {
    // Density of steel, kg/mm3.
    const STEEL: f64 = 7.85e-6;
    let length = cutter.row.length("length").unwrap_or_default().to_mm();
    let diameter = cutter.diameter.to_mm();
    std::f64::consts::PI / 4.0 * diameter * diameter * length * STEEL
}

/// Why a holder does not take the cutter.
pub(super) fn refuse(row: RowRef<'_>, cutter: &Cutter<'_>, machine: &Machine<'_>) -> Option<HolderFault> {
    if let Ok(taper) = row.int("taper")
        && taper != machine.taper
    {
        return Some(HolderFault::OtherTaper { own: taper, spindle: machine.taper });
    }
    match cutter.head.shank {
        Shank::Cylindrical if row.table.column_index("thread_min").is_some() => {
            let (low, high) = (row.length_if_any("thread_min")?, row.length_if_any("thread_max")?);
            let thread = cutter.diameter;
            (thread < low || thread > high).then_some(HolderFault::ThreadOutsideChuck { thread, low, high })
        }
        Shank::Cylindrical => {
            let shank = cutter.row.length("shank_diameter").unwrap_or(cutter.diameter);
            let (low, high) = (row.length_if_any("clamp_min")?, row.length_if_any("clamp_max")?);
            (shank < low || shank > high).then_some(HolderFault::ShankOutsideClamp { shank, low, high })
        }
        Shank::Morse => {
            let (own, taken) = (cutter.row.int("morse").ok()?, row.int("morse").ok()?);
            (own != taken).then_some(HolderFault::OtherMorse { own, taken })
        }
        Shank::Shell => {
            let (own, taken) = (cutter.row.length_if_any("bore")?, row.length_if_any("bore")?);
            (own != taken).then_some(HolderFault::OtherBore { own, taken })
        }
        Shank::Taper => None,
    }
}

/// Whether what stands out of the spindle is too short for the hole, or too thick to enter it.
fn too_short(
    row: RowRef<'_>,
    cutter: &Cutter<'_>,
    length: Micrometres,
    overhang: Micrometres,
    need: &CutterNeed<'_>,
) -> Option<HolderFault> {
    let shell = cutter.head.shank == Shank::Shell;
    // A shell cutter is followed into the hole by its arbor; any other cutter must reach by itself.
    let reach = if shell { length + overhang } else { overhang };
    if reach < need.reach {
        return Some(HolderFault::StandsOutTooLittle { reach, needed: need.reach });
    }
    let thick = row.length_if_any("max_diameter").filter(|thick| shell && *thick >= need.diameter);
    thick.map(|arbor| HolderFault::ArborDoesNotEnter { arbor, hole: need.diameter })
}

/// Whether a cutter may stand out a little more or less: a cylindrical shank is clamped as deep as one likes, but that of a
/// tap by a rule of its own.
pub(super) fn is_ranged(shank: Shank, operation: Operation) -> bool {
    shank == Shank::Cylindrical && operation != Operation::Tap
}

/// How far the cutter stands out.
///
/// With a cylindrical shank L − seat + 2…3 mm (textbook 5.2 item 5); with a Morse shank the length
/// outside the taper; a shell cutter sits on its arbor; a tool with the machine's taper stands out whole.
pub(super) fn overhang(
    cutter: &Cutter<'_>,
    need: &CutterNeed<'_>,
    knowledge: &Knowledge,
) -> Result<(Micrometres, Because), KnowledgeError> {
    let row = cutter.row;
    let own = |column: &str| row.length(column).map_err(KnowledgeError::from);
    if need.operation == Operation::Tap {
        let conventions = knowledge.table("hole-defaults")?;
        let clamped = conventions
            .find("name", "tap-clamp-diameters")
            .ok_or_else(|| KnowledgeError::no_row(conventions, "tap-clamp-diameters"))?;
        let held = own("shank_diameter")?.to_mm() * clamped.number_in("value", Unit::None)?;
        let free = own("length")? - Micrometres::from_mm_rounded(held);
        return Ok((free, Because::row(clamped, Note::new("overhang-tap").with("free", free))));
    }
    match cutter.head.shank {
        Shank::Cylindrical => {
            let clamping = knowledge.table("clamping")?;
            let addition = clamping
                .find("name", "overhang-addition")
                .ok_or_else(|| KnowledgeError::no_row(clamping, "overhang-addition"))?;
            let extra = Micrometres::from_mm_rounded(addition.number_in("maximum", Unit::None)?);
            let length = own("length").or_else(|_| own("cutting_length"))?;
            let free = match row.length("shank_length") {
                Ok(shank) => length - shank,
                Err(_) => own("flute_length").or_else(|_| own("cutting_length"))?,
            };
            let note = Note::new("overhang-cylindrical").with("free", free).with("extra", extra);
            Ok((free + extra, Because::row(addition, note)))
        }
        Shank::Morse => {
            let note = Note::new("overhang-morse");
            let projection = match row.length("projection") {
                Ok(projection) => projection,
                Err(_) => own("length")? - taper_shank(row, knowledge)?,
            };
            Ok((projection, Because::row(row, note.with("projection", projection))))
        }
        Shank::Shell => Ok((own("length")?, Because::row(row, Note::new("overhang-shell")))),
        Shank::Taper => Ok((own("length")?, Because::row(row, Note::new("overhang-taper")))),
    }
}

/// The length of a Morse shank with tang, by the table `morse-tapers`.
fn taper_shank(row: RowRef<'_>, knowledge: &Knowledge) -> Result<Micrometres, KnowledgeError> {
    let tapers = knowledge.table("morse-tapers")?;
    let number = row.int("morse")?;
    let taper = tapers.all_rows().find(|taper| taper.int("morse") == Ok(number));
    Ok(taper.ok_or_else(|| KnowledgeError::no_row(tapers, &number.to_string()))?.length("tang_length")?)
}
