//! Tables: ruled under a head; wrapped and without optional columns if they are too wide; written row by row if they
//! still do not fit.

use super::wrap::{Line, Word, cell_words, heading_words, wrap};
use super::{Page, STEP, wrap as set};
use crate::{Align, Inlines, Table, WIDTH};

/// A table with the notes under it.
pub(super) fn write(page: &mut Page, table: &Table) {
    let head = table.has_head();
    let grid = Grid::of(table);
    // Each column of a ruled table has a space on both sides, and a vertical rule separates two columns.
    let (between, around) = if head { (3, 2) } else { (2, page.indent) };
    let room = |columns: usize| (page.width + between).checked_sub(around + between * columns);
    match grid.layout(table, &room) {
        Some(layout) => {
            grid.draw(page, &layout, head);
            let left_out: Vec<Inlines> = (0..table.columns().len())
                .filter(|column| !layout.iter().any(|(shown, _)| shown == column))
                .map(|column| table.columns()[column].heading.clone())
                .collect();
            notes(page, table, left_out, grid.least_width(between, around));
        }
        None => {
            records(page, table);
            if !page.words.see_all.is_empty() {
                page.paragraph(&set::words(&see_all(page, grid.least_width(between, around))), STEP);
            }
            notes(page, table, Vec::new(), 0);
        }
    }
}

/// The notes under a table; `all` is the width that it needs with every column.
fn notes(page: &mut Page, table: &Table, left_out: Vec<Inlines>, all: usize) {
    if !left_out.is_empty() {
        let mut columns = Inlines::joined(left_out, ", ");
        if !page.words.see_all.is_empty() {
            columns = columns.text("; ").append(see_all(page, all));
        }
        page.field(&page.words.left_out.into(), &columns, STEP);
    }
    for note in &table.notes {
        page.paragraph(&set::words(note), STEP);
    }
}

/// How to see a table in its columns.
fn see_all(page: &Page, width: usize) -> Inlines {
    Inlines::sentence(&page.words.see_all.replace(WIDTH, &width.to_string()))
}

/// The rows one by one, each as its cells with their headings: it fits any width.
fn records(page: &mut Page, table: &Table) {
    for row in table.rows() {
        let mut indent = page.indent;
        for (column, cell) in table.columns().iter().zip(row).filter(|(_, cell)| !cell.is_empty()) {
            match column.head() {
                head if head.is_empty() => page.paragraph(&set::words(cell), indent),
                head => page.field(&head, cell, indent),
            }
            indent = page.indent + STEP;
        }
    }
}

/// The columns that are shown, each with its width.
type Layout = Vec<(usize, usize)>;

/// The words of all cells, so that they are split only once.
struct Grid {
    heads: Vec<Vec<Word>>,
    rows: Vec<Vec<Vec<Word>>>,
    aligns: Vec<Align>,
    /// The preferred and the least width of each column.
    measures: Vec<(usize, usize)>,
}

impl Grid {
    fn of(table: &Table) -> Self {
        let heads: Vec<Vec<Word>> = table.columns().iter().map(|column| heading_words(&column.head())).collect();
        let rows: Vec<Vec<Vec<Word>>> = table.rows().iter().map(|row| row.iter().map(cell_words).collect()).collect();
        let measure = |(at, column): (usize, &crate::Column)| {
            let cells = || rows.iter().map(|row| &row[at]).chain([&heads[at]]);
            let most = cells().map(|words| line_width(words)).max().unwrap_or(0);
            let word = cells().flatten().map(|word| word.width).max().unwrap_or(0);
            (most, word.max(column.min_width.min(most)))
        };
        let measures = table.columns().iter().enumerate().map(measure).collect();
        Self { measures, aligns: table.columns().iter().map(|column| column.align).collect(), heads, rows }
    }

    /// The widest selection of columns that fits into the room `room` gives for so many columns. Optional columns are
    /// removed one by one, from the last; then a narrower one is put back if there is room for it. None if even the
    /// required columns do not fit.
    fn layout(&self, table: &Table, room: &dyn Fn(usize) -> Option<usize>) -> Option<Layout> {
        let mut shown: Vec<usize> = (0..self.measures.len()).collect();
        let mut left_out = Vec::new();
        let fits = |shown: &[usize]| room(shown.len()).and_then(|room| self.fit(shown, room));
        loop {
            if let Some(mut widths) = fits(&shown) {
                while let Some(column) = left_out.pop() {
                    let mut more = shown.clone();
                    more.insert(more.partition_point(|&known| known < column), column);
                    if let Some(wider) = fits(&more) {
                        (shown, widths) = (more, wider);
                    }
                }
                return Some(shown.into_iter().zip(widths).collect());
            }
            let keep = |column: usize| table.columns()[column].keep;
            let least = shown.iter().copied().filter(|&column| keep(column) > crate::Keep::Always);
            let least = least.max_by_key(|&column| (keep(column), column))?;
            shown.retain(|&column| column != least);
            left_out.push(least);
        }
    }

    /// The least width of a page for every column.
    fn least_width(&self, between: usize, around: usize) -> usize {
        let columns: usize = self.measures.iter().map(|(_, least)| least + between).sum();
        (columns + around).saturating_sub(between)
    }

    /// Widths that fit, by repeatedly narrowing the widest column.
    fn fit(&self, shown: &[usize], room: usize) -> Option<Vec<usize>> {
        let mut widths: Vec<usize> = shown.iter().map(|&column| self.measures[column].0).collect();
        while widths.iter().sum::<usize>() > room {
            let wide = (0..widths.len()).filter(|&at| widths[at] > self.measures[shown[at]].1);
            let widest = wide.max_by_key(|&at| widths[at])?;
            widths[widest] -= 1;
        }
        // Wrapped text seldom fills its column.
        let filled = |(&column, width): (&usize, &usize)| {
            let cells = self.rows.iter().map(|row| &row[column]).chain([&self.heads[column]]);
            cells.flat_map(|words| wrap(words, *width, *width)).map(|line| line.width).max().unwrap_or(0)
        };
        Some(shown.iter().zip(&widths).map(filled).collect())
    }

    fn draw(&self, page: &mut Page, layout: &Layout, head: bool) {
        if head {
            self.row(page, &self.heads, layout, head);
            let rules: Vec<String> = layout.iter().map(|(_, width)| "-".repeat(width + 2)).collect();
            page.text.push_str(&rules.join("+"));
            page.text.push('\n');
        }
        for row in &self.rows {
            self.row(page, row, layout, head);
        }
    }

    fn row(&self, page: &mut Page, row: &[Vec<Word>], layout: &Layout, ruled: bool) {
        let cells: Vec<Vec<Line>> = layout.iter().map(|&(column, width)| wrap(&row[column], width, width)).collect();
        let height = cells.iter().map(Vec::len).max().unwrap_or(0).max(1);
        for number in 0..height {
            let mut line = String::new();
            for (at, (&(column, width), lines)) in layout.iter().zip(&cells).enumerate() {
                line.push_str(match (at, ruled) {
                    (0, true) => " ",
                    (0, false) => "",
                    (_, true) => " | ",
                    (_, false) => "  ",
                });
                let own = lines.get(number);
                let space = " ".repeat(width.saturating_sub(own.map_or(0, |own| own.width)));
                let shown = own.map(|own| own.shown(page.colour)).unwrap_or_default();
                match self.aligns[column] {
                    Align::Left => line.extend([shown, space]),
                    Align::Right => line.extend([space, shown]),
                }
            }
            let indent = if ruled { 0 } else { page.indent };
            page.text.push_str(format!("{}{line}", " ".repeat(indent)).trim_end());
            page.text.push('\n');
        }
    }
}

/// The width of words on one line.
fn line_width(words: &[Word]) -> usize {
    wrap(words, usize::MAX, usize::MAX).first().map_or(0, |line| line.width)
}
