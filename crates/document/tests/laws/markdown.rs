//! Markdown, read by the parser that mdBook uses.

use proptest::prelude::*;
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use technolog_document::{Block, Document, Inlines, markdown};

use crate::samples::{document, inlines, marked};
use crate::{WORDS, expected, spaced};

/// The lines of a text, each with its kind, as a reader of Markdown sees them.
fn read(text: &str) -> Vec<(String, String)> {
    let options = Options::all() - Options::ENABLE_SMART_PUNCTUATION - Options::ENABLE_OLD_FOOTNOTES;
    let mut all: Vec<(String, String)> = Vec::new();
    let mut depth = 0;
    for event in Parser::new_ext(text, options) {
        let begun = match &event {
            Event::Start(Tag::Heading { level, .. }) => Some(level.to_string()),
            Event::Start(Tag::Paragraph) if depth == 0 => Some("p".to_owned()),
            Event::Start(Tag::List(None)) if depth == 0 => Some("list".to_owned()),
            Event::Start(Tag::Item) => Some(format!("li{depth}")),
            Event::Start(Tag::TableCell) => Some("cell".to_owned()),
            Event::Start(Tag::CodeBlock(_)) => Some("code".to_owned()),
            _ => None,
        };
        all.extend(begun.map(|kind| (kind, String::new())));
        match event {
            Event::Start(Tag::List(None)) => depth += 1,
            Event::End(TagEnd::List(_)) => depth -= 1,
            Event::Text(text) | Event::Code(text) => match all.last_mut() {
                Some((_, words)) => words.push_str(&text),
                None => all.push(("nowhere".to_owned(), text.to_string())),
            },
            Event::InlineHtml(tag) => {
                assert!(["<strong>", "</strong>", "<code>", "</code>"].contains(&tag.as_ref()), "{tag}");
            }
            Event::Html(_)
            | Event::Rule
            | Event::SoftBreak
            | Event::HardBreak
            | Event::InlineMath(_)
            | Event::DisplayMath(_)
            | Event::TaskListMarker(_)
            | Event::FootnoteReference(_)
            | Event::Start(Tag::List(Some(_)) | Tag::Strikethrough | Tag::Emphasis | Tag::BlockQuote(_)) => {
                all.push((format!("{event:?}"), String::new()));
            }
            _ => {}
        }
    }
    all.into_iter().map(|(kind, words)| (kind, spaced(&words))).collect()
}

proptest! {
    #![proptest_config(technolog_laws::cases!(300))]

    #[test]
    fn markdown_is_read_as_the_same_blocks(document in document(marked())) {
        let text = markdown(&document, &WORDS);
        prop_assert_eq!(read(&text), expected(&document), "{}", text);
        prop_assert_eq!(&text, &markdown(&document, &WORDS));
    }

    #[test]
    fn a_paragraph_of_marks_is_a_paragraph(words in inlines(marked())) {
        prop_assume!(!words.plain().trim().is_empty());
        let document = Document { blocks: vec![Block::Paragraph(words)], ..Document::new("uk", "t") };
        let text = markdown(&document, &WORDS);
        prop_assert_eq!(read(&text), expected(&document), "{}", text);
    }

    #[test]
    fn no_text_at_all_is_read_as_something_else(words in any::<String>()) {
        // What no page may have is shown as a replacement character, which is law enough for `clean`.
        let words: String = words.chars().filter(|sign| !sign.is_control() && !"\u{2028}\u{2029}".contains(*sign)).collect();
        prop_assume!(!words.trim().is_empty() && !words.contains(|sign: char| "\u{200e}\u{200f}".contains(sign)
            || ('\u{202a}'..='\u{202e}').contains(&sign) || ('\u{2066}'..='\u{2069}').contains(&sign)));
        let document = Document { blocks: vec![Block::Paragraph(words.into())], ..Document::new("uk", "t") };
        let text = markdown(&document, &WORDS);
        prop_assert_eq!(read(&text), expected(&document), "{}", text);
    }

    #[test]
    fn a_program_is_read_as_it_stands(code in "(`{0,5}[a-zN0-9 #%<&*-]{0,6}\n?){0,6}[a-z`]") {
        let document = Document { blocks: vec![Block::Code(code.clone())], ..Document::new("uk", "t") };
        let text = markdown(&document, &WORDS);
        let options = Options::all();
        let read: String = Parser::new_ext(&text, options)
            .skip_while(|event| !matches!(event, Event::Start(Tag::CodeBlock(_))))
            .filter_map(|event| if let Event::Text(text) = event { Some(text.to_string()) } else { None })
            .collect();
        prop_assert_eq!(read, format!("{}\n", code), "{}", text);
    }
}

#[test]
fn figures_keep_their_points_and_dashes() {
    let mut document = Document::new("en", "T");
    for words in ["1. Drill", "-0,5 mm", "+ 3", "# 5", "2.5 mm", "A | B", "a_b_c", "`rout`", "Ø < 10 & > 6", "---"] {
        document.paragraph(words);
    }
    document.paragraph(Inlines::from("up to ").quantity("0.5", "mm").text(" of ").code("a|b"));
    assert_eq!(read(&markdown(&document, &WORDS)), expected(&document));
}
