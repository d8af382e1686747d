//! Tables of figures: those of one column have the same number of decimals.

use std::fmt::Display;

use crate::document::{Column, Inlines, Keep, Table};
use crate::note::Figure;
use crate::units::round_to;

use super::Lang;

/// A cell of a table.
pub(super) enum Cell {
    Words(Inlines),
    /// A figure, and its largest number of decimals.
    Figure(f64, usize),
    /// From one figure to another, with the decimals of its column.
    Range(f64, f64, usize),
}

impl<T: Into<Inlines>> From<T> for Cell {
    fn from(words: T) -> Self {
        Self::Words(words.into())
    }
}

impl Cell {
    pub(super) fn empty() -> Self {
        Self::from("")
    }

    pub(super) fn count(count: usize) -> Self {
        Self::Figure(count as f64, 0)
    }

    fn is_empty(&self) -> bool {
        matches!(self, Self::Words(words) if words.is_empty())
    }
}

/// A table, without optional columns that are empty.
pub(super) fn table(columns: impl IntoIterator<Item = Column>, rows: Vec<Vec<Cell>>, lang: Lang) -> Table {
    let columns: Vec<Column> = columns.into_iter().collect();
    let says = |at: usize| rows.iter().any(|row| row.get(at).is_some_and(|cell| !cell.is_empty()));
    let shown: Vec<usize> = (0..columns.len()).filter(|&at| columns[at].keep == Keep::Always || says(at)).collect();
    let decimals: Vec<usize> = (0..columns.len())
        .map(|at| rows.iter().filter_map(|row| row.get(at)).map(decimals).max().unwrap_or_default())
        .collect();
    let mut table = Table::new(shown.iter().map(|&at| columns[at].clone()));
    for row in rows {
        let cells = row.into_iter().enumerate().filter(|(at, _)| shown.contains(at));
        table.row(cells.map(|(at, cell)| match cell {
            Cell::Words(words) => words,
            Cell::Figure(value, most) => Inlines::number(fixed(value, decimals[at].min(most), lang)),
            Cell::Range(from, to, most) => {
                let shown = |value| fixed(value, decimals[at].min(most), lang);
                format!("{}…{}", shown(from), shown(to)).into()
            }
        }));
    }
    table
}

/// A column with several figures in a cell, such as `0 → 42`: they stay on one line.
pub(super) fn span(heading: impl Into<Inlines>, unit: &str) -> Column {
    Column::number(heading, unit).min_width(16)
}

/// A figure as people write it.
pub(super) fn figure(value: impl Display, lang: Lang) -> String {
    lang.figure(&Figure::number(value.to_string())).replace('-', "−")
}

/// A figure with that number of decimals.
pub(super) fn fixed(value: f64, decimals: usize, lang: Lang) -> String {
    // Not −0.
    let value = round_to(value, u32::try_from(decimals).unwrap_or_default()) + 0.0;
    figure(format_args!("{value:.decimals$}"), lang)
}

/// A figure with two decimals at most.
pub(super) fn rounded(value: f64, lang: Lang) -> String {
    figure(round_to(value, 2) + 0.0, lang)
}

/// From one figure to another, or the one that both are.
pub(super) fn arrow(from: String, to: String) -> String {
    if from == to { to } else { format!("{from} → {to}") }
}

fn decimals(cell: &Cell) -> usize {
    let of = |value: f64, most: usize| {
        let shown = round_to(value, u32::try_from(most).unwrap_or_default()).to_string();
        shown.split_once('.').map_or(0, |(_, decimals)| decimals.len().min(most))
    };
    match cell {
        Cell::Words(_) => 0,
        Cell::Figure(value, most) => of(*value, *most),
        Cell::Range(from, to, most) => of(*from, *most).max(of(*to, *most)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_has_as_many_decimals_as_its_finest_figure_needs() {
        let rows = [(1.5, "a"), (0.125, ""), (2.0, "")];
        let rows = rows.map(|(value, text)| vec![Cell::Figure(value, 2), Cell::from(text), Cell::empty()]);
        let columns = ["t", "why", "nothing"].map(|heading| Column::text(heading).keep(Keep::Optional));
        let table = table(columns, rows.into(), Lang::UK);
        let first: Vec<String> = table.rows().iter().map(|row| row[0].plain()).collect();
        assert_eq!(first, ["1,50", "0,13", "2,00"]);
        assert_eq!(table.columns().len(), 2);
        assert_eq!((fixed(-0.001, 2, Lang::EN), fixed(-102.4, 1, Lang::UK)), ("0.00".into(), "−102,4".into()));
    }
}
