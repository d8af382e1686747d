//! Boxes over the inputs of a decision table, and their differences.

use crate::column::Column;
use crate::set::Set;
use crate::table::{Cell, Row, Table};

/// A box: one set per input column.
pub(super) type Region = Vec<Set>;

/// The whole domain of a table's inputs.
pub(super) fn domain(table: &Table) -> Region {
    table.inputs().map(|(_, column)| column.allowed()).collect()
}

/// The box of a row, inside the domain.
fn region_of_row(table: &Table, row: &Row) -> Region {
    table
        .inputs()
        .map(|(index, column)| match &row.cells[index] {
            Cell::Test(set, _) => set.intersection(&column.allowed()),
            _ => column.allowed(),
        })
        .collect()
}

/// The boxes of all rows, in their order.
pub(super) fn regions_of_rows(table: &Table) -> Vec<Region> {
    table.rows.iter().map(|row| region_of_row(table, row)).collect()
}

/// Whether a box is empty.
pub(super) fn is_empty(region: &[Set]) -> bool {
    region.iter().any(Set::is_empty)
}

/// The intersection of two boxes.
pub(super) fn intersection(a: &[Set], b: &[Set]) -> Region {
    a.iter().zip(b).map(|(a, b)| a.intersection(b)).collect()
}

/// Whether two boxes have no common input.
pub(super) fn is_disjoint(a: &[Set], b: &[Set]) -> bool {
    a.iter().zip(b).any(|(a, b)| a.is_disjoint(b))
}

/// Whether the first box lies inside the second.
pub(super) fn is_inside(a: &[Set], b: &[Set]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.is_subset(b))
}

/// The rest of a box without the other boxes, as disjoint boxes.
pub(super) fn minus<'r>(region: &Region, others: impl IntoIterator<Item = &'r Region>) -> Vec<Region> {
    let mut left = vec![region.clone()];
    for other in others {
        let mut next = Vec::new();
        for piece in left {
            if is_disjoint(&piece, other) {
                next.push(piece);
                continue;
            }
            // Split off, column by column, the part outside the other box.
            let mut core = piece;
            for column in 0..core.len() {
                let outside = core[column].difference(&other[column]);
                if !outside.is_empty() {
                    let mut part = core.clone();
                    part[column] = outside;
                    next.push(part);
                }
                core[column] = core[column].intersection(&other[column]);
            }
        }
        left = next;
        if left.is_empty() {
            break;
        }
    }
    left
}

/// An input of the box, written as a query.
pub(super) fn witness(table: &Table, region: &[Set]) -> String {
    let parts: Vec<String> = table
        .inputs()
        .zip(region)
        .map(|((_, column), set)| format!("{}={}", column.name, quoted(&show_first(column, set))))
        .collect();
    parts.join(" ")
}

/// A typical member of the set: within the domain, and not at minus infinity.
fn show_first(column: &Column, set: &Set) -> String {
    let inside = set.intersection(&column.allowed());
    match inside.intervals().first() {
        Some(&(i64::MIN, high)) => column.show_rank(if high == i64::MAX { 0 } else { high }),
        Some(&(low, _)) => column.show_rank(low),
        None => String::from("-"),
    }
}

fn quoted(text: &str) -> String {
    if text.contains(' ') { format!("\"{text}\"") } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn sets() -> impl Strategy<Value = Set> {
        prop::collection::vec((0_i64..12, 0_i64..5), 1..3)
            .prop_map(|parts| Set::from_intervals(parts.into_iter().map(|(low, len)| (low, low + len)).collect()))
    }

    fn boxes() -> impl Strategy<Value = Region> {
        (sets(), sets()).prop_map(|(x, y)| vec![x, y])
    }

    fn holds(region: &[Set], x: i64, y: i64) -> bool {
        region[0].contains(x) && region[1].contains(y)
    }

    proptest! {
        #![proptest_config(technolog_laws::cases!(256))]

        #[test]
        fn what_is_left_is_exactly_what_no_other_box_holds(
            whole in boxes(), others in prop::collection::vec(boxes(), 0..4)
        ) {
            let left = minus(&whole, &others);
            for x in 0..18 {
                for y in 0..18 {
                    let expected = holds(&whole, x, y) && !others.iter().any(|other| holds(other, x, y));
                    let pieces = left.iter().filter(|piece| holds(piece, x, y)).count();
                    prop_assert_eq!(pieces, usize::from(expected));
                }
            }
        }
    }
}
