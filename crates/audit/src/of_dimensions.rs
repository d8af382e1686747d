//! The cutter that the stated dimensions of a tool belong to, where its designation names another one.
//!
//! A designation is a long number, and one digit of it is misprinted more easily than all dimensions. Where they agree
//! with each other and with the rows, they are right: nothing is then computed from the cutter that was not meant.

use crate::plan::Operation;
use crate::reason::{OfOther, Unfit};
use crate::shop::Shop;
use crate::tooling::CutterNeed;
use crate::tooling::named::{self, NamedCutter};
use crate::units::Micrometres;

use super::auditor::Auditor;
use super::near::{away, same_table};
use super::quantity::Quantity as Q;
use super::rules::tools::{dimensions, may_be_ground};
use super::stated::{Row, Stated, Tool};

/// The cutter meant by the dimensions of a tool; none if its designation is right, or a dimension may be the slip.
pub(super) fn meant<'a>(
    stated: &Stated,
    at: usize,
    named: &NamedCutter<'a>,
    auditor: &Auditor<'a>,
    shop: &Shop<'_>,
) -> Option<NamedCutter<'a>> {
    let tool = stated.tools.get(at)?;
    let name = &tool.designation.as_ref()?.value;
    let rows: Vec<&Row> = stated.rows_of_tool(tool.number).map(|(_, row)| row).collect();
    let ground = stated.is_own && may_be_ground(rows.first().map(|row| row.operation.value));
    let off = dimensions(&named.row).into_iter().filter(|(quantity, length)| {
        let Some((figure, length)) = tool.figures.get(quantity).zip(*length) else { return false };
        let tolerance = auditor.tolerances().allowed_difference(*quantity, figure, length.to_mm());
        !(ground && *quantity == Q::Diameter) && (figure.value - length.to_mm()).abs() > tolerance
    });
    // A single dimension may itself be the slip; the rows of the tool decide which of the two is meant.
    match off.count() {
        0 => return None,
        1 if rows.iter().all(|row| does(named, row, stated, shop)) => return None,
        _ => {}
    }
    let fits = |cutter: &NamedCutter<'_>| {
        dimensions(&cutter.row).into_iter().all(|(quantity, length)| {
            let stated = tool.figures.get(&quantity).map(|figure| figure.value);
            stated.is_none_or(|value| length.is_some_and(|length| (length.to_mm() - value).abs() < 1e-6))
        })
    };
    // Another tool of the same dimensions may be of another kind: it must also suit the rows of this one.
    let suits = |cutter: &&NamedCutter<'a>| fits(cutter) && rows.iter().all(|row| does(cutter, row, stated, shop));
    let table = tool.table.as_ref().map_or(named.row.row.table.id.as_str(), |table| table.value.as_str());
    let far =
        |cutter: &&NamedCutter<'a>| (!same_table(&cutter.row.row.table.id, table), away(name, cutter.designation));
    auditor.cutters.values().filter(suits).min_by_key(far).cloned()
}

/// Whether a tool states two or more dimensions, and all of them are those of a cutter.
pub(super) fn has(tool: &Tool, cutter: &NamedCutter<'_>) -> bool {
    let stated = dimensions(&cutter.row).into_iter().filter_map(|(quantity, length)| {
        let value = tool.figures.get(&quantity)?.value;
        Some(length.is_some_and(|length| (length.to_mm() - value).abs() < 1e-6))
    });
    let stated: Vec<bool> = stated.collect();
    stated.len() >= 2 && stated.into_iter().all(|same| same)
}

/// Whether a cutter is of the kind and size that a row states.
fn does(cutter: &NamedCutter<'_>, row: &Row, stated: &Stated, shop: &Shop<'_>) -> bool {
    let operation = row.operation.value;
    let Some(diameter) = row.figures.get(&Q::Diameter) else { return cutter.head.operations.contains(&operation) };
    let hole = row.hole.as_ref().and_then(|name| stated.part.holes.iter().find(|hole| hole.name == name.value));
    let cone = hole.and_then(|hole| {
        let sink = hole.countersink.map(|sink| sink.angle_millideg);
        sink.or_else(|| hole.cone.map(|cone| cone.angle_millideg))
    });
    let need = CutterNeed {
        thread: hole.and_then(|hole| hole.thread_at(row.step)).map(|thread| thread.id.as_str()),
        angle_millideg: match operation {
            Operation::Countersink => cone.or(Some(90_000)),
            Operation::Chamfer => Some(90_000),
            _ => None,
        },
        clearance: Micrometres::ZERO,
        grind_limit: shop.grind_limit(Micrometres::from_mm_rounded(diameter.value)).unwrap_or_default(),
        ..CutterNeed::plain(operation, Micrometres::from_mm_rounded(diameter.value))
    };
    let other = named::unsuited(cutter, &need, &shop.machine);
    let of_kind =
        |other: &OfOther| matches!(other, OfOther::Operation { .. } | OfOther::Angle { .. } | OfOther::Size { .. });
    !other.is_some_and(|why| matches!(&why, Unfit::OfOther(other) if of_kind(other)))
}
