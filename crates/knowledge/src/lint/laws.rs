//! Proof: the numbers of a table obey the laws the table declares under `laws:`.
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

use super::rows::{cell_place, row_place};
use crate::diagnostic::Diagnostic;
use crate::knowledge::Knowledge;
use crate::table::{Cell, Law, Table};
use crate::value::Value;

/// Every declared law of a table; a tool table without laws is a finding itself.
pub(super) fn check(table: &Table, knowledge: &Knowledge, findings: &mut Vec<Diagnostic>) {
    if table.tool.is_some() && table.laws.is_empty() {
        let message = format!("{}: tool table {} declares no `laws`", table.file, table.id);
        findings
            .push(Diagnostic::error("no-laws", message, None).help("at least `rising` of a length over the diameter"));
    }
    if table.tool.is_some() {
        plausible_lengths(table, findings);
    }
    for law in &table.laws {
        let broken = match law.name.as_str() {
            "rising" => rising(table, law),
            "less" => less(table, law),
            "between" => between(table, law),
            "morse" => morse(table, law, knowledge),
            "count" => count(table, law),
            "order" => order(table, law),
            "record" => record(table, law, knowledge),
            other => Err(format!("unknown law `{other}`")),
        };
        match broken {
            Ok(found) => findings.extend(found),
            Err(message) => {
                let message = format!("table {}: law `{}`: {message}", table.id, law.name);
                findings.push(Diagnostic::error("bad-law", message, law.place.clone()));
            }
        }
    }
}

/// Lengths of a cutter lie between a tenth of a millimetre and a metre, whatever unit its table is in.
fn plausible_lengths(table: &Table, findings: &mut Vec<Diagnostic>) {
    for (index, column) in table.columns.iter().enumerate() {
        for row in 0..table.rows.len() {
            if let Cell::Value(Value::Length(length)) = &table.rows[row].cells[index]
                && !(100..=1_000_000).contains(&length.micrometres())
            {
                let message = format!("{} is {length} mm, which no cutter measures", column.name);
                findings.push(broken(table, row, index, message));
            }
        }
    }
}

type Broken = Result<Vec<Diagnostic>, String>;

fn parameter<'l>(law: &'l Law, name: &str) -> Result<&'l str, String> {
    law.get(name).ok_or_else(|| format!("the parameter `{name}` is missing"))
}

fn column(table: &Table, law: &Law, name: &str) -> Result<usize, String> {
    let column = parameter(law, name)?;
    table.column_index(column).ok_or_else(|| format!("no column `{column}`"))
}

fn rank(table: &Table, row: usize, column: usize) -> Option<i64> {
    match &table.rows[row].cells[column] {
        Cell::Value(value) => table.columns[column].rank(value),
        _ => None,
    }
}

fn broken(table: &Table, row: usize, column: usize, message: String) -> Diagnostic {
    let message = format!("table {}, row {}: {message}", table.id, row + 1);
    Diagnostic::error("broken-law", message, cell_place(table, row, column))
}

fn rising(table: &Table, law: &Law) -> Broken {
    let (value, over) = (column(table, law, "column")?, column(table, law, "over")?);
    let by: Vec<usize> = law
        .get("by")
        .unwrap_or_default()
        .split_whitespace()
        .map(|name| table.column_index(name).ok_or_else(|| format!("no column `{name}`")))
        .collect::<Result<_, _>>()?;
    // Per group: the rows by the other column, and for each of its values the smallest and the largest.
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
            // One row is its own smallest and largest; the stricter bound says it once.
            let bounds = if same.len() == 1 { &bounds[..1] } else { &bounds[..] };
            for &(bound, (_, own, row)) in bounds {
                if own < bound {
                    let shown = &table.columns[value];
                    let message = format!(
                        "{} falls to {} where a smaller {} has {}",
                        shown.name,
                        shown.show_rank(own),
                        table.columns[over].name,
                        shown.show_rank(bound)
                    );
                    found.push(broken(table, row, value, message));
                }
            }
            (smallest, largest) = (smallest.max(low.1), largest.max(high.1));
        }
    }
    Ok(found)
}

fn less(table: &Table, law: &Law) -> Broken {
    let (small, large) = (column(table, law, "column")?, column(table, law, "than")?);
    Ok((0..table.rows.len())
        .filter_map(|row| {
            let (a, b) = (rank(table, row, small)?, rank(table, row, large)?);
            (a >= b).then(|| {
                let (small_column, large_column) = (&table.columns[small], &table.columns[large]);
                let message = format!(
                    "{} {} is not below {} {}",
                    small_column.name,
                    small_column.show_rank(a),
                    large_column.name,
                    large_column.show_rank(b)
                );
                broken(table, row, small, message)
            })
        })
        .collect())
}

fn between(table: &Table, law: &Law) -> Broken {
    let index = column(table, law, "column")?;
    let of = &table.columns[index];
    let bound = |name: &str| -> Result<i64, String> {
        let value = of.parse_value(parameter(law, name)?)?;
        of.rank(&value).ok_or_else(|| format!("`{}` has no order", of.name))
    };
    let (low, high) = (bound("low")?, bound("high")?);
    Ok((0..table.rows.len())
        .filter_map(|row| {
            let value = rank(table, row, index)?;
            (value < low || value > high).then(|| {
                let message = format!(
                    "{} {} is outside {} to {}",
                    of.name,
                    of.show_rank(value),
                    of.show_rank(low),
                    of.show_rank(high)
                );
                broken(table, row, index, message)
            })
        })
        .collect())
}

fn morse(table: &Table, law: &Law, knowledge: &Knowledge) -> Broken {
    let (length, projection) = (column(table, law, "length")?, column(table, law, "projection")?);
    let number = table.column_index("morse").ok_or("no column `morse`")?;
    let tapers = knowledge.table("morse-tapers").map_err(|error| error.to_string())?;
    let shank = tapers.column_index(parameter(law, "shank")?).ok_or("no such column of morse-tapers")?;
    let taper_number = tapers.column_index("morse").ok_or("morse-tapers has no column `morse`")?;
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
                    format!("L - l = {}, but a Morse {n} shank is {} long", show(l - p), show(expected))
                }
                None => format!("there is no Morse taper {n}"),
            };
            found.push(broken(table, row, projection, message));
        }
    }
    Ok(found)
}

fn count(table: &Table, law: &Law) -> Broken {
    let (number, of) = (column(table, law, "column")?, column(table, law, "of")?);
    Ok((0..table.rows.len())
        .filter_map(|row| {
            let stated = rank(table, row, number)?;
            let listed = match &table.rows[row].cells[of] {
                Cell::Value(value) => i64::try_from(value.items().len()).ok()?,
                _ => 0,
            };
            (stated != listed).then(|| {
                let message = format!(
                    "{} says {stated}, but {} lists {listed}",
                    table.columns[number].name, table.columns[of].name
                );
                broken(table, row, number, message)
            })
        })
        .collect())
}

/// `names` holds `printed_column:transition` pairs. A number in a printed column is the position of
/// that transition; a `true` only says that it occurs.
fn order(table: &Table, law: &Law) -> Broken {
    let list = column(table, law, "column")?;
    let pairs = parameter(law, "names")?
        .split_whitespace()
        .map(|pair| {
            let (printed, transition) = pair.split_once(':').ok_or_else(|| format!("`{pair}` is no pair"))?;
            let index = table.column_index(printed).ok_or_else(|| format!("no column `{printed}`"))?;
            Ok((index, transition))
        })
        .collect::<Result<Vec<_>, String>>()?;
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
            let message = format!("the list reads {}, the columns say {}", listed.join(", "), expected.join(", "));
            found.push(broken(table, row, list, message));
        }
    }
    Ok(found)
}

/// A record table (columns `name`, `unit`) against the schema table (columns `name`, `unit`, `required`).
fn record(table: &Table, law: &Law, knowledge: &Knowledge) -> Broken {
    let schema = knowledge.table(parameter(law, "schema")?).map_err(|error| error.to_string())?;
    let mut found = Vec::new();
    for wanted in schema.all_rows() {
        let name = wanted.text("name").map_err(|error| error.to_string())?;
        let Some(Value::Bool(required)) = wanted.value("required") else {
            return Err(format!("table {}, row {}: `required` must be true or false", schema.id, wanted.number()));
        };
        match table.find("name", name) {
            None if *required => {
                let message = format!("table {}: the quantity `{name}` is missing", table.id);
                found.push(Diagnostic::error("broken-law", message, law.place.clone()));
            }
            None => {}
            Some(row) => {
                let (given, unit) = (row.text("unit").ok(), wanted.text("unit").ok());
                if given != unit {
                    let message = format!(
                        "table {}: `{name}` is in `{}`, and must be in `{}`",
                        table.id,
                        given.unwrap_or_default(),
                        unit.unwrap_or_default()
                    );
                    found.push(Diagnostic::error("wrong-unit", message, row_place(table, row.index)));
                }
            }
        }
    }
    for row in table.all_rows() {
        let name = row.text("name").unwrap_or_default();
        if schema.find("name", name).is_none() {
            let message = format!("table {}: `{name}` is no quantity of {}", table.id, schema.id);
            found.push(Diagnostic::error("broken-law", message, row_place(table, row.index)));
        }
    }
    Ok(found)
}
