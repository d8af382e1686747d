//! Escapes text for Markdown.

use crate::{Inline, clean};

/// A text anywhere but at the beginning of a line, see [`started`].
pub(super) fn escaped(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for sign in clean::line(text).chars() {
        // The marks of CommonMark, and those of common additions: tables, ~~, math, ^, attributes.
        if matches!(sign, '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '&' | '#' | '|' | '~' | '$' | '^' | '{') {
            shown.push('\\');
        }
        shown.push(sign);
    }
    shown
}

/// The first line of a block, escaped so that it does not begin a list.
pub(super) fn started(line: String) -> String {
    // A block must not be empty: the mark of a list alone would underline the text above it.
    if line.is_empty() {
        return "&#32;".to_owned();
    }
    let digits = line.bytes().take_while(u8::is_ascii_digit).count();
    let (number, rest) = line.split_at(digits);
    let mut signs = rest.chars();
    let mark = match signs.next() {
        Some('.' | ')') => digits > 0,
        Some('-' | '+' | ':') => digits == 0,
        _ => false,
    };
    // Before a word or a figure, as in `-5`, it is no mark.
    if mark && !signs.next().is_some_and(char::is_alphanumeric) { format!("{number}\\{rest}") } else { line }
}

/// Adds emphasised words. Between words without spaces asterisks are not always marks; tags are.
pub(super) fn strong(shown: &mut String, text: &str, next: Option<&Inline>) {
    let text = clean::line(text);
    let inner = text.trim();
    let Some((before, after)) = text.split_once(inner).filter(|_| !inner.is_empty()) else {
        return shown.push_str(&text);
    };
    shown.push_str(before);
    let word = |sign: Option<char>| sign.is_some_and(char::is_alphanumeric);
    let space = |sign: Option<char>| sign.is_none_or(char::is_whitespace);
    let following =
        if after.is_empty() { next.and_then(|next| clean::line(&next.plain()).chars().next()) } else { Some(' ') };
    let opens = word(inner.chars().next()) || space(shown.chars().next_back());
    let closes = word(inner.chars().next_back()) || space(following);
    let touches = shown.ends_with('*') || (after.is_empty() && matches!(next, Some(Inline::Strong(_))));
    let (begin, end) = if opens && closes && !touches { ("**", "**") } else { ("<strong>", "</strong>") };
    shown.push_str(&format!("{begin}{}{end}{after}", escaped(inner)));
}

/// Adds code between more backticks than it contains, or in tags where backticks would be misread.
pub(super) fn code(shown: &mut String, text: &str, cell: bool) {
    let text = clean::line(text);
    if shown.ends_with('`') || (cell && text.contains('|')) {
        shown.push_str(&format!("<code>{}</code>", escaped(&text)));
        return;
    }
    let marks = "`".repeat(longest_run(&text) + 1);
    let tight = !text.starts_with(['`', ' ']) && !text.ends_with(['`', ' ']);
    let space = if tight || text.trim_matches(' ').is_empty() { "" } else { " " };
    shown.push_str(&format!("{marks}{space}{text}{space}{marks}"));
}

/// Adds a link; after an exclamation mark it would be an image.
pub(super) fn link(shown: &mut String, text: &str, to: &str) {
    if shown.ends_with('!') {
        shown.pop();
        shown.push_str("\\!");
    }
    shown.push_str(&format!("[{}](<{to}>)", escaped(text)));
}

/// The longest run of backticks.
pub(super) fn longest_run(text: &str) -> usize {
    text.split(|sign| sign != '`').map(str::len).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_marks_are_escaped() {
        assert_eq!(escaped("a*b_c|d <e> `f` #1 & 2.5-3"), r"a\*b\_c\|d \<e\> \`f\` \#1 \& 2.5-3");
        for (line, shown) in [
            ("1. a", r"1\. a"),
            ("2.5 mm", "2.5 mm"),
            ("12)", r"12\)"),
            ("- a", r"\- a"),
            ("-5 mm", "-5 mm"),
            ("+", r"\+"),
            ("---", r"\---"),
            (". a", ". a"),
        ] {
            assert_eq!(started(line.to_owned()), shown);
        }
    }

    #[test]
    fn tags_stand_where_marks_would_be_misread() {
        let shown = |before: &str, text: &str, next: Option<&Inline>| {
            let mut shown = before.to_owned();
            strong(&mut shown, text, next);
            shown
        };
        assert_eq!(shown("a ", "b: ", None), "a **b:** ");
        assert_eq!(shown("a", "(b)", None), "a<strong>(b)</strong>");
        assert_eq!(shown("**a**", "b", None), "**a**<strong>b</strong>");
        let mut shown = "`a`".to_owned();
        code(&mut shown, "b", false);
        code(&mut shown, "`|", false);
        assert_eq!(shown, "`a`<code>b</code>`` `| ``");
    }
}
