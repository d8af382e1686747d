//! Text: no line is wider than the screen, no letter is lost.

use proptest::prelude::*;
use technolog_document::{Document, Words, text};
use unicode_width::UnicodeWidthStr;

use crate::samples::{document, plain};
use crate::{WORDS, expected};

/// Letters of cells and lines, in no order: cells that are wrapped stand beside each other.
fn letters(words: &str) -> String {
    let mut letters: Vec<char> = words.chars().filter(|sign| sign.is_alphabetic() && *sign != 'ω').collect();
    letters.sort_unstable();
    letters.into_iter().collect()
}

/// The document as it is read on a screen: links have their addresses, figures the word for them.
fn screen_text(document: &Document) -> String {
    let drawings =
        document.blocks.iter().filter(|block| matches!(block, technolog_document::Block::Drawing(_))).count();
    expected(document).into_iter().map(|(_, words)| words).collect::<String>() + &"Drawing".repeat(drawings)
}

proptest! {
    #![proptest_config(technolog_laws::cases!(300))]

    #[test]
    fn no_line_is_wider_than_the_screen_and_no_letter_is_lost(document in document(plain()), width in 8_usize..130) {
        // A table that is written row by row says so besides.
        let words = Words { see_all: "", ..WORDS };
        let page = text(&document, width, false, &words);
        for line in page.lines() {
            // A figure and its unit are one word; a rule of a table is none.
            let alone = !line.replace("0,25 ", "").contains(' ') && !line.starts_with("--");
            prop_assert!(line.width() <= width || alone, "{}: {}\n{}", width, line, page);
            prop_assert!(!line.ends_with(' '));
        }
        prop_assert_eq!(letters(&page), letters(&screen_text(&document)), "{}", page);
        prop_assert_eq!(&page, &text(&document, width, false, &words));
    }

    #[test]
    fn colours_change_nothing_else(document in document(plain()), width in 8_usize..130) {
        let page = text(&document, width, true, &WORDS);
        let mut pieces = page.split("\u{1b}[");
        let mut bare = pieces.next().unwrap_or_default().to_owned();
        for piece in pieces {
            bare.push_str(piece.split_once('m').unwrap().1);
        }
        let trimmed: String = bare.lines().map(|line| format!("{}\n", line.trim_end())).collect();
        prop_assert_eq!(trimmed, text(&document, width, false, &WORDS));
    }
}
