//! HTML: one standalone page that loads nothing from elsewhere; all text is escaped.

use std::fmt::Write;

use crate::{
    Align, Block, CellKind, Column, Document, Drawing, FORM_LINE_MM, FORM_STEP_MM, FindingBlock, Form, Inline, Inlines,
    Item, Table, Words, clean,
};

use crate::clean::{escaped, escaped_lines};

/// Colours for light and dark mode and for paper; on narrow screens each table scrolls by itself.
const STYLE: &str = include_str!("html/style.css");

/// The longest name, in bytes, that is kept on one line.
const NAME: usize = 32;
/// The longest text of a cell, in characters, whose column may become as narrow as its longest word.
const SHORT: usize = 32;
/// The same for one that is made as wide as a narrow screen.
const LONG: usize = 80;
/// The longest word without a slash, in characters, that is kept beside a number as its unit.
const UNIT: usize = 3;

/// The document as a standalone page.
pub fn html(document: &Document, words: &Words) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n",
        escaped(&document.lang),
        escaped(&document.title.plain())
    );
    if !document.title.is_empty() {
        page.push_str(&format!("<h1>{}</h1>\n", line(&document.title)));
    }
    let finding = |block: &Block| matches!(block, Block::Finding(_));
    let mut under = document.title.plain();
    for blocks in document.blocks.chunk_by(|one, next| finding(one) && finding(next)) {
        let list = blocks.first().is_some_and(finding);
        page.push_str(if list { "<ul class=\"findings\">\n" } else { "" });
        for own in blocks {
            if let Block::Heading { words, .. } = own {
                under = words.plain();
            }
            block(&mut page, own, &under, words);
        }
        page.push_str(if list { "</ul>\n" } else { "" });
    }
    page.push_str("</main>\n</body>\n</html>\n");
    page
}

/// A block under a heading, which names the frame of a table for those who do not see it.
fn block(page: &mut String, block: &Block, under: &str, words: &Words) {
    match block {
        Block::Heading { level, words } => {
            let level = (*level).clamp(1, 6);
            page.push_str(&format!("<h{level}>{}</h{level}>\n", line(words)));
        }
        Block::Paragraph(words) => page.push_str(&format!("<p>{}</p>\n", line(words))),
        Block::List(items) => list(page, items),
        Block::Table(content) => table(page, content, under),
        Block::Finding(own) => finding(page, own, words),
        Block::Drawing(drawing) => figure(page, drawing),
        Block::Code(code) => page.push_str(&format!("<pre><code>{}</code></pre>\n", escaped_lines(code))),
        Block::Fields(fields) => {
            page.push_str("<dl>\n");
            for field in fields {
                page.push_str(&format!("<dt>{}:</dt> <dd>{}</dd>\n", line(&field.label), line(&field.value)));
            }
            page.push_str("</dl>\n");
        }
        Block::Form(own) => form(page, own, under),
    }
}

/// A sheet of a form: a table whose columns are the edges of all its cells; on paper a page across.
fn form(page: &mut String, form: &Form, under: &str) {
    let (widths, rows) = form.columns();
    page.push_str(&format!(
        "<div class=\"form scroll\" tabindex=\"0\"{}><p>{}</p>\n<table role=\"presentation\">\n<colgroup>",
        named(under),
        escaped(&form.mark)
    ));
    widths
        .iter()
        .for_each(|width| page.push_str(&format!("<col style=\"width:{:.1}mm\">", f64::from(*width) * FORM_STEP_MM)));
    page.push_str("</colgroup>\n<tbody>\n");
    for (row, cells) in form.rows.iter().zip(rows) {
        page.push_str(&format!("<tr style=\"height:{:.2}mm\">", f64::from(row.lines) * FORM_LINE_MM));
        for (cell, span) in cells {
            let class = match cell.kind {
                CellKind::Name => "name",
                CellKind::Value => "value",
                CellKind::Line => "line",
                CellKind::Gap => "gap",
            };
            let down = if cell.rows > 1 { format!(" rowspan=\"{}\"", cell.rows) } else { String::new() };
            // A date in the narrowest of them.
            let class = if cell.kind == CellKind::Value && cell.width <= 6 { "value narrow" } else { class };
            // Who reads by ear has no columns: a value says its name.
            let is_named = !cell.name.is_empty() && !cell.words.is_empty() && cell.kind != CellKind::Name;
            let name =
                if is_named { format!("<span class=\"ear\">{}: </span>", escaped(&cell.name)) } else { String::new() };
            page.push_str(&format!("<td class=\"{class}\" colspan=\"{span}\"{down}>{name}{}</td>", line(&cell.words)));
        }
        page.push_str("</tr>\n");
    }
    page.push_str("</tbody>\n</table></div>\n");
}

fn list(page: &mut String, items: &[Item]) {
    page.push_str("<ul>\n");
    for item in items {
        page.push_str(&format!("<li>{}", line(&item.words)));
        if !item.items.is_empty() {
            page.push('\n');
            list(page, &item.items);
        }
        page.push_str("</li>\n");
    }
    page.push_str("</ul>\n");
}

fn finding(page: &mut String, finding: &FindingBlock, words: &Words) {
    let place = finding.place.iter().map(|place| format!(" <code>{}</code>", escaped(place))).collect::<String>();
    let (class, word) = (finding.severity.name(), escaped(&finding.label()));
    page.push_str(&format!("<li class=\"{class}\"><b>{word}</b>{place} {}", line(&finding.words)));
    let help = finding.help.iter().map(|help| format!("<b>{}:</b> {}", escaped(words.help), line(help)));
    let details: Vec<String> = finding.details.iter().map(line).chain(help).collect();
    if !details.is_empty() {
        page.push_str("\n<ul>\n");
        details.iter().for_each(|detail| page.push_str(&format!("<li>{detail}</li>\n")));
        page.push_str("</ul>\n");
    }
    page.push_str("</li>\n");
}

/// The name of a frame that scrolls, for those who do not see under which heading it stands.
fn named(under: &str) -> String {
    if under.is_empty() { String::new() } else { format!(" role=\"group\" aria-label=\"{}\"", escaped(under)) }
}

/// A table in a frame that scrolls; the frame can be focused by keyboard.
fn table(page: &mut String, table: &Table, under: &str) {
    let longest = |column: usize| table.rows().iter().map(|row| row[column].plain().chars().count()).max();
    // The last column of words may be off a narrow screen, where nobody sees why its rows are tall; figures may stand behind it.
    let last = table.columns().iter().rposition(|column| column.align == Align::Left).unwrap_or_default();
    let class = |(at, column): (usize, &Column)| match column.align {
        Align::Right => " class=\"number\"",
        Align::Left if at < last => "",
        Align::Left if longest(at) > Some(LONG) => " class=\"longest\"",
        Align::Left if longest(at) > Some(SHORT) => " class=\"long\"",
        Align::Left => "",
    };
    let classes: Vec<&str> = table.columns().iter().enumerate().map(class).collect();
    page.push_str(&format!("<div class=\"scroll\" tabindex=\"0\"{}><table>\n", named(under)));
    if table.has_head() {
        let heads = table.columns().iter().zip(&classes);
        let heads = heads.map(|(column, class)| format!("<th scope=\"col\"{class}>{}</th>", head(column)));
        page.push_str(&format!("<thead><tr>{}</tr></thead>\n", heads.collect::<String>()));
    }
    page.push_str("<tbody>\n");
    for row in table.rows() {
        let cells = row.iter().zip(&classes).map(|(cell, class)| format!("<td{class}>{}</td>", line(cell)));
        page.push_str(&format!("<tr>{}</tr>\n", cells.collect::<String>()));
    }
    page.push_str("</tbody>\n</table></div>\n");
    for note in &table.notes {
        page.push_str(&format!("<p class=\"under\">{}</p>\n", line(note)));
    }
}

/// Heading and unit; the unit is not broken at its slash.
fn head(column: &Column) -> String {
    match (line(&column.heading), column.unit.as_str()) {
        (heading, "") => heading,
        (heading, unit) if heading.is_empty() => escaped(unit),
        (heading, unit) => format!("{heading}, <span>{}</span>", escaped(unit)),
    }
}

fn figure(page: &mut String, figure: &Drawing) {
    let caption = line(&figure.caption);
    let caption = if caption.is_empty() { caption } else { format!("\n<figcaption>{caption}</figcaption>") };
    let (source, alternative) = (image(&figure.svg), escaped(&figure.alternative));
    page.push_str(&format!("<figure><img src=\"{source}\" alt=\"{alternative}\">{caption}</figure>\n"));
}

/// A drawing as a data URL of an image: no scripts run in it, and its ids do not collide with those of another
/// drawing.
pub fn image(svg: &str) -> String {
    let kept = |byte| matches!(byte, b'-' | b'.' | b'_' | b'=' | b'/' | b',' | b':' | b';');
    format!("data:image/svg+xml,{}", clean::percent(svg, kept))
}

fn line(inlines: &Inlines) -> String {
    let mut shown = String::new();
    for piece in inlines.pieces() {
        let plain = piece.plain();
        // Writing to a string never fails.
        let _ = match piece {
            Inline::Text(_) => write!(shown, "{}", unbroken(&plain)),
            Inline::Strong(_) => write!(shown, "<strong>{}</strong>", unbroken(&plain)),
            Inline::Code(_) => write!(shown, "<code>{}</code>", unbroken(&plain)),
            Inline::Quantity { unit, .. } if unit.is_empty() => write!(shown, "{}", escaped(&plain)),
            Inline::Quantity { .. } => write!(shown, "<span>{}</span>", escaped(&plain)),
            Inline::Link { to, .. } => match clean::address(to) {
                Some(to) => write!(shown, "<a href=\"{}\">{}</a>", escaped(&to), escaped(&plain)),
                None => write!(shown, "{}", escaped(&plain)),
            },
        };
    }
    shown
}

/// A text without line breaks at the dash of a short name or number, `2И20-5-80`, or between a number and its unit.
fn unbroken(text: &str) -> String {
    let mut shown: Vec<String> = Vec::new();
    let mut words = text.split(' ').peekable();
    while let Some(word) = words.next() {
        let name = word.contains('-') && word.contains(|sign: char| sign.is_ascii_digit()) && word.len() <= NAME;
        shown.push(match words.next_if(|next| !name && is_quantity(word, next)) {
            Some(unit) => format!("<span>{} {}</span>", escaped(word), escaped(unit)),
            None if name => format!("<span>{}</span>", escaped(word)),
            None => escaped(word),
        });
    }
    shown.join(" ")
}

/// Whether the second word looks like the unit of the first: `90 мм`, `0.25 mm/rev`, `5 %`.
fn is_quantity(number: &str, unit: &str) -> bool {
    number.ends_with(|sign: char| sign.is_ascii_digit())
        && unit.starts_with(|sign: char| sign.is_alphabetic() || "%°".contains(sign))
        && (unit.contains(['/', '·']) || unit.trim_end_matches([',', ';', '.', ':', ')']).chars().count() <= UNIT)
}

#[cfg(test)]
mod tests;
