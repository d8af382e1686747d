//! Holders: the one for a shank, the overhang of the cutter, and the length of the assembly.

use crate::error::KnowledgeError;
use crate::knowledge::table::ToolHead;
use crate::knowledge::units::Micrometres;
use crate::knowledge::vocabulary::Shank;
use crate::knowledge::{Knowledge, RowRef, TableRow};
use crate::machine::Machine;
use crate::note::{Because, Figure, Note};
use crate::plan::{Link, Operation};
use crate::reason::{HolderFault, Unfit};
use crate::shop::Shop;
use crate::tables::holders::HolderRow;
use crate::tables::holes::HoleDefault;
use crate::tables::materials::{Clamping, ClampingConstant};
use crate::tables::rules::{HolderForShank, HolderForShankFor};
use crate::tables::standards::{MorseTaper, Taper724};
use crate::tables::tools::CutterRow;
use technolog_note::note;

use super::cutter::stated;
use super::{Cutter, CutterNeed};

/// A cutter in its holder.
#[derive(Clone, Debug)]
pub struct Assembly {
    /// The holder's designation; the cutter's own when it carries the machine's taper.
    pub holder: String,
    /// The holder's table.
    pub holder_table: String,
    /// Length of the holder from the spindle face.
    pub holder_length: Micrometres,
    /// Overhang: how far the cutter projects from the holder.
    pub overhang: Micrometres,
    /// From the spindle face to the tip.
    pub length: Micrometres,
    /// The links from the spindle to the tip: the 7:24 shank, the holder, the cutter.
    pub links: Vec<Link>,
    /// Mass of holder and cutter, kg, where that of the holder is known; the cutter counts as a steel bar.
    pub mass_kg: Option<f64>,
    /// Why.
    pub because: Vec<Because>,
}

/// Puts a cutter into the first holder that takes it.
///
/// # Errors
/// The knowledge base has no answer. That no holder fits is not an error: the inner `Err` says why.
pub fn assemble<'k>(
    cutter: &Cutter<'_, 'k>,
    need: &CutterNeed<'_>,
    shop: &Shop<'k>,
) -> Result<Result<Assembly, Vec<Unfit>>, KnowledgeError> {
    let mounted = match first_holder(cutter, need, holders(cutter.head, need.operation, shop)?, shop)? {
        Ok(mounted) => mounted,
        Err(why) => return Ok(Err(why)),
    };
    let taper = Link {
        kind: "taper-7-24".to_owned(),
        designation: shop.machine.taper.to_string(),
        table: Taper724::CONTRACT.which.id().to_owned(),
        length_mm: Micrometres::ZERO,
    };
    let tip = Link {
        kind: "cutter".to_owned(),
        designation: cutter.designation.to_owned(),
        table: cutter.row.row.table.id.clone(),
        length_mm: mounted.overhang.length,
    };
    let MountedCutter { holder, overhang, length, mass_kg } = mounted;
    let stands_out = overhang.because();
    Ok(Ok(match holder {
        None => Assembly {
            holder: cutter.designation.to_owned(),
            holder_table: cutter.row.row.table.id.clone(),
            holder_length: Micrometres::ZERO,
            overhang: overhang.length,
            length,
            links: vec![taper, tip],
            mass_kg,
            because: vec![stands_out],
        },
        Some((row, passed_over)) => {
            let table = &row.row.table.id;
            let over = passed_over.iter().map(|(holder, fault)| fault.note().with("holder", holder)).collect();
            let note = Note::new("holder").with("shank", Figure::word(cutter.head.shank.name()));
            let link = Link {
                kind: "holder".to_owned(),
                designation: row.designation.to_owned(),
                table: table.clone(),
                length_mm: row.length,
            };
            Assembly {
                holder: row.designation.to_owned(),
                holder_table: table.clone(),
                holder_length: row.length,
                overhang: overhang.length,
                length,
                links: vec![taper, link, tip],
                mass_kg,
                because: vec![Because::row(row.row, note).with_rejected(over), stands_out],
            }
        }
    }))
}

/// A cutter in its holder, as data without sentences.
pub(super) struct MountedCutter<'s, 'k> {
    /// The holder, and the holders before it that do not take the cutter; none where the cutter has the taper of the
    /// machine.
    holder: Option<(&'s HolderRow<'k>, Vec<(&'k str, HolderFault)>)>,
    pub overhang: Overhang<'k>,
    /// From the spindle's face to the tip.
    length: Micrometres,
    /// Of holder and cutter, kg.
    mass_kg: Option<f64>,
}

/// The holders to choose from; none where the cutter has the taper of the machine.
pub(super) fn holders<'s, 'k>(
    head: &ToolHead,
    operation: Operation,
    shop: &'s Shop<'k>,
) -> Result<&'s [HolderRow<'k>], KnowledgeError> {
    if head.shank == Shank::Taper {
        return Ok(&[]);
    }
    let family = family(head, operation, shop.knowledge)?;
    let table = family
        .holders
        .ok_or_else(|| KnowledgeError::missing(&family.row.table.id, note!("order-holders-this-shank")))?;
    shop.shelf.holders_of(table)
}

/// The first of the holders that takes a cutter, as in [`assemble`].
pub(super) fn first_holder<'s, 'k>(
    cutter: &Cutter<'_, 'k>,
    need: &CutterNeed<'_>,
    holders: &'s [HolderRow<'k>],
    shop: &Shop<'k>,
) -> Result<Result<MountedCutter<'s, 'k>, Vec<Unfit>>, KnowledgeError> {
    let machine = &shop.machine;
    let overhang = overhang(cutter, need, shop)?;
    if cutter.head.shank == Shank::Taper {
        let mass_kg = cutter.row.mass.map(|mass| mass.0);
        let mounted = MountedCutter { holder: None, length: overhang.length, overhang, mass_kg };
        return Ok(within_limits(mounted, cutter, machine));
    }
    let mut rejected = Vec::new();
    for row in holders {
        let why = refuse(row, cutter, machine).or_else(|| too_short(row, cutter, overhang.length, need));
        if let Some(fault) = why {
            rejected.push((row.designation, fault));
            continue;
        }
        let length = row.length + overhang.length;
        let mass_kg = row.mass.map(|holder| holder.0 + bar_mass(cutter));
        let mounted = MountedCutter { holder: Some((row, rejected)), overhang, length, mass_kg };
        return Ok(within_limits(mounted, cutter, machine));
    }
    Ok(Err(rejected.into_iter().map(|(holder, fault)| unfit(cutter, holder, fault)).collect()))
}

/// The row of the rule `holder-for-shank` that names the family of holders for a shank.
pub(super) fn family<'k>(
    head: &ToolHead,
    operation: Operation,
    knowledge: &'k Knowledge,
) -> Result<HolderForShank<'k>, KnowledgeError> {
    // End mills with a Morse shank are held by a drawbar thread, drills are driven by a tang.
    let mills = head.operations.contains(&Operation::Mill);
    let drawbar = head.shank == Shank::Morse && mills;
    let question = HolderForShankFor { shank: head.shank, drawbar, tap: operation == Operation::Tap };
    knowledge.ask(&question)?.need(head.shank.name())
}

fn unfit(cutter: &Cutter<'_, '_>, holder: &str, fault: HolderFault) -> Unfit {
    Unfit::Holder { tool: cutter.designation.to_owned(), holder: holder.to_owned(), fault }
}

fn within_limits<'s, 'k>(
    mounted: MountedCutter<'s, 'k>,
    cutter: &Cutter<'_, '_>,
    machine: &Machine<'_>,
) -> Result<MountedCutter<'s, 'k>, Vec<Unfit>> {
    let holder = mounted.holder.as_ref().map_or(cutter.designation, |(row, _)| row.designation);
    if mounted.length > machine.overhang_max {
        let fault = HolderFault::TooLong { length: mounted.length, limit: machine.overhang_max };
        return Err(vec![unfit(cutter, holder, fault)]);
    }
    if let Some(mass) = mounted.mass_kg.filter(|mass| *mass > machine.tool_mass_max_kg) {
        let fault = HolderFault::TooHeavy { mass, limit: machine.tool_mass_max_kg };
        return Err(vec![unfit(cutter, holder, fault)]);
    }
    Ok(mounted)
}

/// Mass of a steel bar with the diameter and length of the cutter, kg: more than the real mass, because of the
/// flutes.
fn bar_mass(cutter: &Cutter<'_, '_>) -> f64 {
    // Density of steel, kg/mm3.
    const STEEL: f64 = 7.85e-6;
    let length = cutter.row.length.unwrap_or_default().to_mm();
    let diameter = cutter.diameter.to_mm();
    std::f64::consts::PI / 4.0 * diameter * diameter * length * STEEL
}

/// Why a holder does not take the cutter.
pub(super) fn refuse(row: &HolderRow<'_>, cutter: &Cutter<'_, '_>, machine: &Machine<'_>) -> Option<HolderFault> {
    if row.taper != machine.taper {
        return Some(HolderFault::OtherTaper { own: row.taper, spindle: machine.taper });
    }
    match cutter.head.shank {
        Shank::Cylindrical if row.thread_min.is_some() => {
            let (low, high) = (row.thread_min?, row.thread_max?);
            let thread = cutter.diameter;
            (thread < low || thread > high).then_some(HolderFault::ThreadOutsideChuck { thread, low, high })
        }
        Shank::Cylindrical => {
            let shank = cutter.row.shank_diameter.unwrap_or(cutter.diameter);
            let (low, high) = (row.clamp_min?, row.clamp_max?);
            (shank < low || shank > high).then_some(HolderFault::ShankOutsideClamp { shank, low, high })
        }
        Shank::Morse => {
            let (own, taken) = (cutter.row.morse?, row.morse?);
            (own != taken).then_some(HolderFault::OtherMorse { own, taken })
        }
        Shank::Shell => {
            let (own, taken) = (cutter.row.bore?, row.bore?);
            (own != taken).then_some(HolderFault::OtherBore { own, taken })
        }
        Shank::Taper => None,
    }
}

/// Whether the part outside the spindle is too short for the hole, or too thick to enter it.
fn too_short(
    row: &HolderRow<'_>,
    cutter: &Cutter<'_, '_>,
    overhang: Micrometres,
    need: &CutterNeed<'_>,
) -> Option<HolderFault> {
    let shell = cutter.head.shank == Shank::Shell;
    // The arbor of a shell cutter follows it into the hole; any other cutter must reach by itself.
    let reach = if shell { row.length + overhang } else { overhang };
    let over_face = if shell { Micrometres::ZERO } else { need.over_face };
    if reach < need.reach + over_face {
        return Some(HolderFault::StandsOutTooLittle { reach, needed: need.reach, over_face });
    }
    let thick = row.max_diameter.filter(|thick| shell && *thick >= need.diameter);
    thick.map(|arbor| HolderFault::ArborDoesNotEnter { arbor, hole: need.diameter })
}

/// Whether the overhang of a cutter may vary a little: a cylindrical shank may be clamped at any depth, but a tap has
/// a rule of its own.
pub(super) fn is_ranged(shank: Shank, operation: Operation) -> bool {
    shank == Shank::Cylindrical && operation != Operation::Tap
}

/// The overhang of the cutter.
///
/// With a cylindrical shank L − seat + 2…3 mm (textbook 5.2 item 5); with a Morse shank the length outside the taper;
/// of a shell cutter its own length on the arbor; of a tool with the taper of the machine its whole length.
pub(super) fn overhang<'k>(
    cutter: &Cutter<'_, 'k>,
    need: &CutterNeed<'_>,
    shop: &Shop<'k>,
) -> Result<Overhang<'k>, KnowledgeError> {
    let row = &cutter.row;
    let length = || stated(row, "length", row.length);
    if need.operation == Operation::Tap {
        let clamped = shop.default_row(HoleDefault::TapClampDiameters)?;
        let clamped_length = stated(row, "shank_diameter", row.shank_diameter)?.to_mm() * clamped.value;
        let free = length()? - Micrometres::from_mm_rounded(clamped_length);
        return Ok(Overhang { length: free, row: clamped.row, by: ByShank::Tap });
    }
    match cutter.head.shank {
        Shank::Cylindrical => {
            let addition = overhang_addition(shop)?;
            let extra = Micrometres::from_mm_rounded(addition.maximum);
            let free = match row.shank_length {
                Some(shank) => stated(row, "length", row.length.or(row.cutting_length))? - shank,
                None => stated(row, "flute_length", row.flute_length.or(row.cutting_length))?,
            };
            Ok(Overhang { length: free + extra, row: addition.row, by: ByShank::Cylindrical { free, extra } })
        }
        Shank::Morse => {
            let projection = match row.projection {
                Some(projection) => projection,
                None => length()? - taper_shank(row, shop)?,
            };
            Ok(Overhang { length: projection, row: row.row, by: ByShank::Morse })
        }
        Shank::Shell => Ok(Overhang { length: length()?, row: row.row, by: ByShank::Shell }),
        Shank::Taper => Ok(Overhang { length: length()?, row: row.row, by: ByShank::Taper }),
    }
}

/// The overhang of a cutter, and the row that gives it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Overhang<'k> {
    /// From the holder's face to the tip; of a shell cutter its own length.
    pub length: Micrometres,
    row: RowRef<'k>,
    by: ByShank,
}

#[derive(Clone, Copy, Debug)]
enum ByShank {
    Tap,
    Cylindrical { free: Micrometres, extra: Micrometres },
    Morse,
    Shell,
    Taper,
}

impl Overhang<'_> {
    pub fn because(&self) -> Because {
        let note = match self.by {
            ByShank::Tap => Note::new("overhang-tap").with("free", self.length),
            ByShank::Cylindrical { free, extra } => {
                Note::new("overhang-cylindrical").with("free", free).with("extra", extra)
            }
            ByShank::Morse => Note::new("overhang-morse").with("projection", self.length),
            ByShank::Shell => Note::new("overhang-shell"),
            ByShank::Taper => Note::new("overhang-taper"),
        };
        Because::row(self.row, note)
    }
}

/// The least and the most overhang of a cylindrical shank beyond the flutes, mm.
pub(super) fn overhang_addition<'s, 'k>(shop: &'s Shop<'k>) -> Result<&'s Clamping<'k>, KnowledgeError> {
    let wanted = ClampingConstant::OverhangAddition;
    let found = shop.shelf.clamping()?.iter().find(|row| row.name.is(wanted));
    found.ok_or_else(|| {
        KnowledgeError::missing(Clamping::CONTRACT.which.id(), note!("table-lacks-figure-of", name = wanted.name()))
    })
}

/// The length of a Morse shank with tang, by the table `morse-tapers`.
fn taper_shank(row: &CutterRow<'_>, shop: &Shop<'_>) -> Result<Micrometres, KnowledgeError> {
    let number = stated(row, "morse", row.morse)?;
    let taper = shop.shelf.morse_tapers()?.iter().find(|taper| taper.morse == number);
    let lacks =
        || KnowledgeError::missing(MorseTaper::CONTRACT.which.id(), note!("order-there-no-row-for", number = number));
    Ok(taper.ok_or_else(lacks)?.tang_length)
}
