//! A sheet of a form as standards draw it: rows over one width, each divided in its own way.

use crate::Inlines;

/// The width of a form in its steps: 110 characters of a typewriter make the 286 mm of a landscape A4.
pub const FORM_WIDTH: u16 = 110;
/// The width of a step, mm: a character of a typewriter (GOST 3.1129).
pub const FORM_STEP_MM: f64 = 2.6;
/// The height of a line of a form, mm.
pub const FORM_LINE_MM: f64 = 4.25;

/// One sheet of a form, A4 across.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Form {
    /// The mark above the frame, at the right: the standard and the number of the form.
    pub mark: String,
    /// Its rows from top to bottom.
    pub rows: Vec<FormRow>,
}

/// A row of a form. Cells that reach down from a row above take their place in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FormRow {
    /// Its height in lines of [`FORM_LINE_MM`].
    pub lines: u16,
    /// Its cells from left to right.
    pub cells: Vec<FormCell>,
}

/// The kinds of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellKind {
    /// The name of what is in the cells below or beside it; printed by writers that draw the form, and by no other.
    Name,
    /// A value in a frame.
    Value,
    /// A value on a line of the body, whose columns have no full rules between them.
    Line,
    /// Outside the frame.
    Gap,
}

/// A cell of a form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FormCell {
    /// Its width in steps of [`FORM_WIDTH`].
    pub width: u16,
    /// How many rows it reaches down over; 1 for its own alone.
    pub rows: u16,
    /// Its kind.
    pub kind: CellKind,
    /// What its value is called, for writers that print a line of text for a row.
    pub name: String,
    /// Its text.
    pub words: Inlines,
}

/// A cell with the number of columns that it takes.
pub type Spanning<'f> = (&'f FormCell, usize);

impl FormCell {
    /// A cell of one row without a name of its own.
    pub fn new(kind: CellKind, width: u16, words: impl Into<Inlines>) -> Self {
        Self { width, rows: 1, kind, name: String::new(), words: words.into() }
    }

    /// A value with its name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// It reaches down over so many rows.
    #[must_use]
    pub fn over(self, rows: u16) -> Self {
        Self { rows, ..self }
    }
}

impl Form {
    /// The widths of the columns that divide all rows alike, in steps, and for each row its cells with the number of
    /// those columns that each takes.
    pub fn columns(&self) -> (Vec<u16>, Vec<Vec<Spanning<'_>>>) {
        let placed = self.placed();
        let mut rules: Vec<u16> =
            placed.iter().flatten().flat_map(|(left, cell)| [*left, left + cell.width]).chain([0]).collect();
        rules.sort_unstable();
        rules.dedup();
        let at = |place: u16| rules.partition_point(|rule| *rule < place);
        let spans = |row: &Vec<(u16, &'_ FormCell)>| -> Vec<(usize, usize)> {
            row.iter().map(|(left, cell)| (at(*left), at(left + cell.width))).collect()
        };
        let rows = placed
            .iter()
            .map(|row| row.iter().zip(spans(row)).map(|((_, cell), (from, to))| (*cell, to - from)).collect());
        let rows = rows.collect();
        (rules.windows(2).map(|pair| pair[1] - pair[0]).collect(), rows)
    }

    /// The cells of every row with their left edges.
    fn placed(&self) -> Vec<Vec<(u16, &FormCell)>> {
        // What reaches down: left edge, width, rows that are left.
        let mut held: Vec<(u16, u16, u16)> = Vec::new();
        let mut placed = Vec::new();
        for row in &self.rows {
            let mut left = 0;
            let mut cells = Vec::new();
            let mut begun = Vec::new();
            for cell in &row.cells {
                while let Some((_, width, _)) = held.iter().find(|(own, ..)| *own == left) {
                    left += width;
                }
                cells.push((left, cell));
                if cell.rows > 1 {
                    begun.push((left, cell.width, cell.rows - 1));
                }
                left += cell.width;
            }
            held.iter_mut().for_each(|own| own.2 -= 1);
            held.retain(|own| own.2 > 0);
            held.extend(begun);
            placed.push(cells);
        }
        placed
    }

    /// What is filled in, a line for each row: names with their values.
    pub fn lines(&self) -> Vec<Inlines> {
        let line = |row: &FormRow| {
            let filled = row
                .cells
                .iter()
                .filter(|cell| matches!(cell.kind, CellKind::Value | CellKind::Line) && !cell.words.is_empty());
            let cell = |cell: &FormCell| match cell.name.as_str() {
                "" => cell.words.clone(),
                name => Inlines::from(format!("{name}: ")).append(cell.words.clone()),
            };
            Inlines::joined(filled.map(cell), "; ")
        };
        self.rows.iter().map(line).filter(|line| !line.is_empty()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(width: u16) -> FormCell {
        FormCell::new(CellKind::Value, width, "x")
    }

    #[test]
    fn rows_share_the_columns_of_all_their_edges() {
        let row = |cells: Vec<FormCell>| FormRow { lines: 1, cells };
        let form = Form {
            mark: String::new(),
            rows: vec![
                row(vec![cell(10), cell(100).over(2)]),
                row(vec![cell(4), cell(6)]),
                row(vec![cell(50), cell(60)]),
            ],
        };
        let (widths, rows) = form.columns();
        assert_eq!(widths, [4, 6, 40, 60]);
        let spans: Vec<Vec<usize>> = rows.iter().map(|row| row.iter().map(|(_, span)| *span).collect()).collect();
        assert_eq!(spans, [vec![2, 2], vec![1, 1], vec![3, 1]]);
    }

    #[test]
    fn a_line_has_the_names_of_its_values_and_no_empty_ones() {
        let cells = vec![
            FormCell::new(CellKind::Name, 10, "Head"),
            FormCell::new(CellKind::Line, 10, "А01"),
            FormCell::new(CellKind::Line, 10, "").named("Shop"),
            FormCell::new(CellKind::Line, 10, "005").named("No."),
        ];
        let form = Form { mark: String::new(), rows: vec![FormRow { lines: 2, cells }] };
        assert_eq!(form.lines().iter().map(Inlines::plain).collect::<Vec<_>>(), ["А01; No.: 005"]);
    }
}
