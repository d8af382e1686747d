//! A page with other words: every text of it goes through one function. What is to be copied exactly, figures and drawings stay.

use crate::{Block, Document, Drawing, Field, FindingBlock, Form, Inline, Inlines, Item, Table};

/// Another wording of a text; none where it stays.
pub type Reword<'r> = &'r dyn Fn(&str) -> Option<String>;

impl Document {
    /// The page with all its texts worded anew.
    #[must_use]
    pub fn reworded(mut self, by: Reword<'_>) -> Self {
        line(&mut self.title, by);
        self.blocks.iter_mut().for_each(|own| block(own, by));
        self
    }
}

fn text(own: &mut String, by: Reword<'_>) {
    if let Some(worded) = by(own) {
        *own = worded;
    }
}

fn line(own: &mut Inlines, by: Reword<'_>) {
    for piece in own.pieces_mut() {
        match piece {
            Inline::Text(words) | Inline::Strong(words) => text(words, by),
            Inline::Code(_) | Inline::Quantity { .. } | Inline::Link { .. } => {}
        }
    }
}

fn block(own: &mut Block, by: Reword<'_>) {
    match own {
        Block::Heading { words, .. } | Block::Paragraph(words) => line(words, by),
        Block::List(items) => items.iter_mut().for_each(|own| item(own, by)),
        Block::Table(own) => table(own, by),
        Block::Finding(own) => finding(own, by),
        Block::Drawing(Drawing { caption, alternative, .. }) => {
            line(caption, by);
            text(alternative, by);
        }
        Block::Code(_) => {}
        Block::Fields(fields) => fields.iter_mut().for_each(|Field { label, value }| {
            line(label, by);
            line(value, by);
        }),
        Block::Form(Form { rows, .. }) => {
            rows.iter_mut().flat_map(|row| &mut row.cells).for_each(|cell| line(&mut cell.words, by));
        }
    }
}

fn item(own: &mut Item, by: Reword<'_>) {
    line(&mut own.words, by);
    own.items.iter_mut().for_each(|own| item(own, by));
}

fn table(own: &mut Table, by: Reword<'_>) {
    let (columns, rows) = own.parts_mut();
    columns.iter_mut().for_each(|column| line(&mut column.heading, by));
    rows.iter_mut().flatten().for_each(|cell| line(cell, by));
    own.notes.iter_mut().for_each(|note| line(note, by));
}

fn finding(own: &mut FindingBlock, by: Reword<'_>) {
    own.details.iter_mut().chain(&mut own.help).chain([&mut own.words]).for_each(|words| line(words, by));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Column;

    #[test]
    fn words_change_and_code_and_figures_stay() {
        let mut page = Document::new("uk", "a");
        let mut own = Table::new([Column::number("a", "a")]);
        own.row([Inlines::number("a")]);
        own.row([Inlines::from("a")]);
        own.notes.push("a".into());
        page.push(own);
        page.paragraph(Inlines::from("a ").code("a").strong("a"));
        page.push(Block::List(vec![Item { words: "a".into(), items: vec!["a".into()] }]));
        let page = page.reworded(&|text| Some(text.replace('a', "b")));
        let told = format!("{page:?}");
        assert_eq!(page.title.plain(), "b");
        let Block::Table(own) = &page.blocks[0] else { panic!("{told}") };
        let cells: Vec<String> = own.rows().iter().flatten().map(Inlines::plain).collect();
        assert_eq!(
            (cells, own.notes[0].plain(), own.columns()[0].head().plain()),
            (vec!["a".to_owned(), "b".to_owned()], "b".to_owned(), "b, a".to_owned())
        );
        let Block::Paragraph(words) = &page.blocks[1] else { panic!("{told}") };
        assert_eq!(words.plain(), "b ab");
        let Block::List(items) = &page.blocks[2] else { panic!("{told}") };
        assert_eq!((items[0].words.plain(), items[0].items[0].words.plain()), ("b".to_owned(), "b".to_owned()));
    }
}
