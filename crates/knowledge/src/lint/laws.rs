//! Check: the numbers of a table obey the laws that it declares under `laws:`.
//!
//! | law | says | parameters |
//! |---|---|---|
//! | `rising` | the column does not fall as another grows | `column`, `over`, `by` (optional grouping columns) |
//! | `less` | the first column is below the second in every row | `column`, `than` |
//! | `morse` | L − l is the shank length of the row's Morse taper | `length`, `projection`, `shank` (column of `morse-tapers`) |
//! | `count` | a number equals the length of a list | `column`, `of` |
//! | `order` | a list of transitions follows the order numbers of the printed columns | `column`, `names` (printed:transition pairs) |
//! | `record` | a record has every quantity its schema names, in its unit | `schema` |
//! | `between` | every value lies within bounds, a plausibility of the quantity | `column`, `low`, `high` |

use std::collections::BTreeMap;
use technolog_note::{Note, note};

use super::rows::{cell_place, row_place};
use crate::diagnostic::Diagnostic;
use crate::knowledge::Knowledge;
use crate::table::{Cell, Law, Table};
use crate::value::Value;

/// Checks every declared law of a table; a tool table without laws is a finding itself.
pub(super) fn check(table: &Table, knowledge: &Knowledge, findings: &mut Vec<Diagnostic>) {
    if table.tool.is_some() && table.laws.is_empty() {
        let message = note!("lint-tool-table-declares-no-laws", file = table.file, table = table.id);
        findings.push(Diagnostic::error("no-laws", message, None).help(note!("lint-at-least-rising-length-over")));
    }
    if table.tool.is_some() {
        plausible_lengths(table, findings);
    }
    for law in &table.laws {
        let broken = match law.name.as_str() {
            "rising" => rising(table, law),
            "less" => less(table, law, false),
            "at-most" => less(table, law, true),
            "between" => between(table, law),
            "morse" => morse(table, law, knowledge),
            "count" => count(table, law),
            "order" => order(table, law),
            "record" => record(table, law, knowledge),
            other => Err(note!("lint-unknown-law", other = other)),
        };
        match broken {
            Ok(found) => findings.extend(found),
            Err(message) => {
                let message = note!("lint-table-law", table = table.id, law = law.name, message = message);
                findings.push(Diagnostic::error("bad-law", message, law.place.clone()));
            }
        }
    }
}

/// The lengths of a cutter are between a tenth of a millimetre and a metre, in any unit.
fn plausible_lengths(table: &Table, findings: &mut Vec<Diagnostic>) {
    for (index, column) in table.columns.iter().enumerate() {
        for row in 0..table.rows.len() {
            if let Cell::Value(Value::Length(length)) = &table.rows[row].cells[index]
                && !(100..=1_000_000).contains(&length.micrometres())
            {
                let message = note!("lint-mm-which-no-cutter-measures", column = column.name, length = length);
                findings.push(broken(table, row, index, message));
            }
        }
    }
}

type LawFindings = Result<Vec<Diagnostic>, Note>;

fn parameter<'l>(law: &'l Law, name: &str) -> Result<&'l str, Note> {
    law.get(name).ok_or_else(|| note!("lint-parameter-missing", name = name))
}

fn column(table: &Table, law: &Law, name: &str) -> Result<usize, Note> {
    let column = parameter(law, name)?;
    table.column_index(column).ok_or_else(|| note!("table-no-column", name = column))
}

fn rank(table: &Table, row: usize, column: usize) -> Option<i64> {
    match &table.rows[row].cells[column] {
        Cell::Value(value) => table.columns[column].rank(value),
        _ => None,
    }
}

fn broken(table: &Table, row: usize, column: usize, message: Note) -> Diagnostic {
    let message = note!("lint-table-row", table = table.id, row = row + 1, message = message);
    Diagnostic::error("broken-law", message, cell_place(table, row, column))
}

fn rising(table: &Table, law: &Law) -> LawFindings {
    let (value, over) = (column(table, law, "column")?, column(table, law, "over")?);
    let by: Vec<usize> = law
        .get("by")
        .unwrap_or_default()
        .split_whitespace()
        .map(|name| table.column_index(name).ok_or_else(|| note!("table-no-column", name = name)))
        .collect::<Result<_, _>>()?;
    // For each group: the rows by the other column, and for each of its values the smallest and the largest.
    let mut groups: BTreeMap<Vec<String>, Vec<(i64, i64, usize)>> = BTreeMap::new();
    for row in 0..table.rows.len() {
        let key = by.iter().map(|&column| format!("{:?}", table.rows[row].cells[column])).collect();
        if let (Some(over), Some(value)) = (rank(table, row, over), rank(table, row, value)) {
            groups.entry(key).or_default().push((over, value, row));
        }
    }
    let mut found = Vec::new();
    for mut rows in groups.into_values() {
        rows.sort_unstable();
        let (mut smallest, mut largest) = (i64::MIN, i64::MIN);
        for same in rows.chunk_by(|a, b| a.0 == b.0) {
            let (low, high) = (same[0], same[same.len() - 1]);
            let bounds = [(largest, high), (smallest, low)];
            // A single row is both smallest and largest; the stricter bound reports it once.
            let bounds = if same.len() == 1 { &bounds[..1] } else { &bounds[..] };
            for &(bound, (_, own, row)) in bounds {
                if own < bound {
                    let shown = &table.columns[value];
                    let message = note!(
                        "lint-falls-where-smaller-has",
                        value = shown.name,
                        low = shown.show_rank(own),
                        over = table.columns[over].name,
                        high = shown.show_rank(bound)
                    );
                    found.push(broken(table, row, value, message));
                }
            }
            (smallest, largest) = (smallest.max(low.1), largest.max(high.1));
        }
    }
    Ok(found)
}

/// One column is less than another, or at most as large.
fn less(table: &Table, law: &Law, or_equal: bool) -> LawFindings {
    let (small, large) = (column(table, law, "column")?, column(table, law, "than")?);
    Ok((0..table.rows.len())
        .filter_map(|row| {
            let (a, b) = (rank(table, row, small)?, rank(table, row, large)?);
            (a > b || a == b && !or_equal).then(|| {
                let (small_column, large_column) = (&table.columns[small], &table.columns[large]);
                let message = note!(
                    "lint-below",
                    small_column = small_column.name,
                    small = small_column.show_rank(a),
                    large_column = large_column.name,
                    large = large_column.show_rank(b)
                );
                broken(table, row, small, message)
            })
        })
        .collect())
}

fn between(table: &Table, law: &Law) -> LawFindings {
    let index = column(table, law, "column")?;
    let other = &table.columns[index];
    let bound = |name: &str| -> Result<i64, Note> {
        let value = other.parse_value(parameter(law, name)?)?;
        other.rank(&value).ok_or_else(|| note!("lint-has-no-order", of = other.name))
    };
    let (low, high) = (bound("low")?, bound("high")?);
    Ok((0..table.rows.len())
        .filter_map(|row| {
            let value = rank(table, row, index)?;
            (value < low || value > high).then(|| {
                let message = note!(
                    "lint-outside",
                    of = other.name,
                    value = other.show_rank(value),
                    least = other.show_rank(low),
                    most = other.show_rank(high)
                );
                broken(table, row, index, message)
            })
        })
        .collect())
}

fn morse(table: &Table, law: &Law, knowledge: &Knowledge) -> LawFindings {
    let (length, projection) = (column(table, law, "length")?, column(table, law, "projection")?);
    let number = table.column_index("morse").ok_or(note!("lint-no-column-morse"))?;
    let tapers = knowledge.table("morse-tapers").map_err(|error| Note::from(&error))?;
    let shank = tapers.column_index(parameter(law, "shank")?).ok_or(note!("lint-no-such-column-morse-tapers"))?;
    let taper_number = tapers.column_index("morse").ok_or(note!("lint-morse-tapers-has-no-column"))?;
    let mut found = Vec::new();
    for row in 0..table.rows.len() {
        let (Some(l), Some(p), Some(n)) =
            (rank(table, row, length), rank(table, row, projection), rank(table, row, number))
        else {
            continue;
        };
        let taper = (0..tapers.rows.len()).find(|&taper| rank(tapers, taper, taper_number) == Some(n));
        let expected = taper.and_then(|taper| rank(tapers, taper, shank));
        if expected != Some(l - p) {
            let show = |rank: i64| table.columns[length].show_rank(rank);
            let message = match expected {
                Some(expected) => {
                    note!("lint-l-l-but-morse-shank", length = show(l - p), number = n, expected = show(expected))
                }
                None => note!("lint-there-no-morse-taper", number = n),
            };
            found.push(broken(table, row, projection, message));
        }
    }
    Ok(found)
}

fn count(table: &Table, law: &Law) -> LawFindings {
    let (number, other) = (column(table, law, "column")?, column(table, law, "of")?);
    Ok((0..table.rows.len())
        .filter_map(|row| {
            let stated = rank(table, row, number)?;
            let listed = match &table.rows[row].cells[other] {
                Cell::Value(value) => i64::try_from(value.items().len()).ok()?,
                _ => 0,
            };
            (stated != listed).then(|| {
                let message = note!(
                    "lint-says-but-lists",
                    columns = table.columns[number].name,
                    stated = stated,
                    of = table.columns[other].name,
                    listed = listed
                );
                broken(table, row, number, message)
            })
        })
        .collect())
}

/// `names` holds `printed_column:transition` pairs. A number in a printed column is the position of that transition;
/// `true` only says that it occurs.
fn order(table: &Table, law: &Law) -> LawFindings {
    let list = column(table, law, "column")?;
    let pairs = parameter(law, "names")?
        .split_whitespace()
        .map(|pair| {
            let (printed, transition) = pair.split_once(':').ok_or_else(|| note!("lint-no-pair", pair = pair))?;
            let index = table.column_index(printed).ok_or_else(|| note!("table-no-column", name = printed))?;
            Ok((index, transition))
        })
        .collect::<Result<Vec<_>, Note>>()?;
    let mut found = Vec::new();
    for (row, content) in table.rows.iter().enumerate() {
        let mut expected: Vec<(i64, &str)> = Vec::new();
        for (position, &(index, transition)) in (0_i64..).zip(&pairs) {
            match &content.cells[index] {
                Cell::Value(Value::Int(number)) => expected.push((*number, transition)),
                Cell::Value(Value::Bool(true)) => expected.push((position, transition)),
                _ => {}
            }
        }
        expected.sort_unstable();
        let expected: Vec<&str> = expected.into_iter().map(|(_, transition)| transition).collect();
        let Cell::Value(value) = &content.cells[list] else { continue };
        let listed: Vec<&str> = value.items().iter().filter_map(Value::as_text).collect();
        if listed != expected {
            let message =
                note!("lint-list-reads-columns-say", listed = listed.join(", "), expected = expected.join(", "));
            found.push(broken(table, row, list, message));
        }
    }
    Ok(found)
}

/// A record table (columns `name`, `unit`) against the schema table (columns `name`, `unit`, `required`).
fn record(table: &Table, law: &Law, knowledge: &Knowledge) -> LawFindings {
    let schema = knowledge.table(parameter(law, "schema")?).map_err(|error| Note::from(&error))?;
    let mut found = Vec::new();
    for wanted in schema.all_rows() {
        let name = wanted.text("name").map_err(|error| Note::from(&error))?;
        let Some(Value::Bool(required)) = wanted.value("required") else {
            return Err(note!("lint-table-row-required-must-true", schema = schema.id, wanted = wanted.number()));
        };
        match table.find("name", name) {
            None if *required => {
                let message = note!("lint-table-quantity-missing", table = table.id, name = name);
                found.push(Diagnostic::error("broken-law", message, law.place.clone()));
            }
            None => {}
            Some(row) => {
                let (given, unit) = (row.text("unit").ok(), wanted.text("unit").ok());
                if given != unit {
                    let message = note!(
                        "lint-table-must",
                        table = table.id,
                        name = name,
                        unit = given.unwrap_or_default(),
                        needed = unit.unwrap_or_default()
                    );
                    found.push(Diagnostic::error("wrong-unit", message, row_place(table, row.index)));
                }
            }
        }
    }
    for row in table.all_rows() {
        let name = row.text("name").unwrap_or_default();
        if schema.find("name", name).is_none() {
            let message = note!("lint-table-no-quantity", table = table.id, name = name, schema = schema.id);
            found.push(Diagnostic::error("broken-law", message, row_place(table, row.index)));
        }
    }
    Ok(found)
}
