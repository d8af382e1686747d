//! HTML, read by its tags: they nest, and what stands between them is what the document says.

use proptest::prelude::*;
use technolog_document::{Document, html};

use crate::samples::{document, marked};
use crate::{WORDS, expected, spaced};

/// The words between the tags of a body, and the texts of its images. Tags that do not nest are told.
fn read(page: &str) -> Result<String, String> {
    let (_, mut rest) = page.split_once("<body>").ok_or("no body")?;
    let mut words = String::new();
    let mut open: Vec<&str> = vec!["html", "body"];
    while let Some((text, tag)) = rest.split_once('<') {
        words.push_str(&unescaped(text)?);
        let (tag, after) = tag.split_once('>').ok_or("a tag without an end")?;
        rest = after;
        let name = tag.split(' ').next().unwrap_or_default();
        if let Some(name) = name.strip_prefix('/') {
            if open.pop() != Some(name) {
                return Err(format!("</{name}> closes something else"));
            }
        } else if name != "img" {
            open.push(name);
        }
        // Within a line words go on; blocks and cells are apart.
        if !["strong", "code", "b", "span", "a", "/strong", "/code", "/b", "/span", "/a"].contains(&name) {
            words.push(' ');
        }
        if let Some((_, alternative)) = tag.split_once("alt=\"") {
            let (alternative, after) = alternative.split_once('"').ok_or("a quote without an end")?;
            if !after.is_empty() {
                return Err(format!("{after} stands after the last attribute"));
            }
            words.push_str(&unescaped(alternative)?);
        }
    }
    if open.is_empty() { Ok(spaced(&words)) } else { Err(format!("{open:?} are never closed")) }
}

fn unescaped(text: &str) -> Result<String, String> {
    let mut pieces = text.split('&');
    let mut words = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (name, rest) = piece.split_once(';').ok_or("a bare &")?;
        words.push(match name {
            "amp" => '&',
            "lt" => '<',
            "gt" => '>',
            "quot" => '"',
            "#39" => '\'',
            other => return Err(format!("&{other};")),
        });
        words.push_str(rest);
    }
    Ok(words)
}

proptest! {
    #![proptest_config(technolog_laws::cases!(300))]

    #[test]
    fn html_is_read_as_the_same_words(document in document(marked())) {
        let page = html(&document, &WORDS);
        let words: Vec<String> = expected(&document).into_iter().map(|(_, words)| words).collect();
        prop_assert_eq!(read(&page), Ok(spaced(&words.join(" "))), "{}", page);
        prop_assert_eq!(&page, &html(&document, &WORDS));
    }

    #[test]
    fn no_text_opens_a_tag_or_ends_an_attribute(text in any::<String>()) {
        let mut document = Document::new(&text, &*text);
        document.paragraph(technolog_document::Inlines::from(&*text).link(&text, &text).code(&text).strong(&text));
        let page = html(&document, &WORDS);
        prop_assert!(read(&page).is_ok(), "{:?}: {}", read(&page), page);
        let (head, _) = page.split_once("<style>").unwrap();
        prop_assert_eq!(head.matches('<').count(), 7, "{}", head);
    }
}
