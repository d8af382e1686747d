//! The sheet as a page for people, and as cells for other programs. JSON is the sheet itself.

use crate::document::{Block, Column, Document, Field, Inlines, Keep, Table};
use crate::words::say;

use super::{EncodingSheet, SheetRow};

impl EncodingSheet {
    /// The sheet as a page. Additions to the textbook's sheet have a `†`.
    pub fn page(&self) -> Document {
        let lang = self.lang;
        let mut page = Document::new(lang.tag(), say!(lang, "encoding-title"));
        let part = self.part.iter().map(|part| Field::new(say!(lang, "encoding-part"), part.as_str()));
        let mut fields: Vec<Field> = part.collect();
        fields.push(Field::new(say!(lang, "encoding-equipment"), self.equipment.as_str()));
        if !self.instructions.is_empty() {
            fields.push(Field::new(say!(lang, "encoding-instructions"), self.instructions.join("; ")));
        }
        page.push(Block::Fields(fields));
        page.paragraph(say!(lang, "encoding-ours"));
        let mut table = Table::new([
            Column::text(say!(lang, "encoding-transition")),
            Column::text(say!(lang, "encoding-tool")).min_width(4).keep(Keep::Useful),
            Column::text(say!(lang, "encoding-block")).min_width(16),
            Column::text(say!(lang, "encoding-meaning")).min_width(30),
        ]);
        for row in &self.rows {
            let [transition, tool, code, meaning] = cells(row);
            table.row([transition.into(), tool.into(), Inlines::default().code(code), meaning.into()]);
        }
        page.push(table);
        page
    }

    /// The rows as cells for a program for tables, the number of the line first, under their names.
    pub fn rows_of_cells(&self) -> Vec<Vec<String>> {
        let head = ["line", "transition", "tool", "code", "meaning"].map(str::to_owned).to_vec();
        let row = |row: &SheetRow| std::iter::once(row.line.to_string()).chain(cells(row)).collect();
        std::iter::once(head).chain(self.rows.iter().map(row)).collect()
    }
}

fn cells(row: &SheetRow) -> [String; 4] {
    let text = |cell: &Option<String>| cell.clone().unwrap_or_default();
    [text(&row.transition), text(&row.tool), row.code.clone(), row.meaning.clone()]
}
