//! Laws of the writers: a reader of the output reads exactly what the document says.

mod html;
mod markdown;
mod samples;
mod text;

use technolog_document::{Block, Document, Drawing, Inlines, Item, Words};

/// Words that no sample has.
const WORDS: Words = Words { left_out: "Left", see_all: "Wider", help: "Help", figure: "Drawing" };

/// The expected reading of a block: the kind of each line, and its words.
fn expected(document: &Document) -> Vec<(String, String)> {
    let mut all = vec![("h1".to_owned(), document.title.plain())];
    let mut before = None;
    for block in &document.blocks {
        let listed = matches!(block, Block::List(_) | Block::Fields(_) | Block::Finding(_));
        let goes_on = matches!((before.replace(block), block), (Some(Block::Finding(_)), Block::Finding(_)));
        all.extend((listed && !goes_on).then(|| ("list".to_owned(), String::new())));
        match block {
            Block::Heading { level, words } => all.push((format!("h{level}"), words.plain())),
            Block::Paragraph(words) => all.push(kind_and_text("p", words)),
            Block::List(list) => items(&mut all, list, 1),
            Block::Fields(fields) => {
                let field =
                    |field: &technolog_document::Field| format!("{}: {}", field.label.plain(), field.value.plain());
                all.extend(fields.iter().map(|own| ("li1".to_owned(), field(own))));
            }
            Block::Finding(finding) => {
                let place = finding.place.iter().map(|place| format!(" {place}")).collect::<String>();
                // A word has its colon; a mark such as `*` has none.
                let colon = if finding.word.ends_with(char::is_alphanumeric) { ":" } else { "" };
                all.push(("li1".to_owned(), format!("{}{colon}{place} {}", finding.word, finding.words.plain())));
                all.extend(finding.details.iter().map(|detail| kind_and_text("li2", detail)));
                all.extend(finding.help.iter().map(|help| ("li2".to_owned(), format!("Help: {}", help.plain()))));
            }
            Block::Table(table) => {
                let head = |column: &technolog_document::Column| match (column.heading.plain(), column.unit.as_str()) {
                    (name, "") => name,
                    (name, unit) if name.is_empty() => unit.to_owned(),
                    (name, unit) => format!("{name}, {unit}"),
                };
                all.extend(table.columns().iter().map(|column| ("cell".to_owned(), head(column))));
                all.extend(table.rows().iter().flatten().map(|cell| kind_and_text("cell", cell)));
                all.extend(table.notes.iter().map(|note| kind_and_text("p", note)));
            }
            Block::Drawing(Drawing { alternative, caption, .. }) => {
                all.push(("p".to_owned(), alternative.clone()));
                all.extend((!caption.is_empty()).then(|| kind_and_text("p", caption)));
            }
            Block::Code(code) => all.push(("code".to_owned(), code.clone())),
            // No sample has one.
            Block::Form(_) => {}
        }
    }
    all.into_iter().map(|(kind, words)| (kind, spaced(&words))).collect()
}

fn items(all: &mut Vec<(String, String)>, list: &[Item], depth: usize) {
    for item in list {
        all.push(kind_and_text(&format!("li{depth}"), &item.words));
        items(all, &item.items, depth + 1);
    }
}

fn kind_and_text(kind: &str, words: &Inlines) -> (String, String) {
    (kind.to_owned(), words.plain())
}

/// No format keeps more than one space, or spaces at the ends of a line.
fn spaced(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
