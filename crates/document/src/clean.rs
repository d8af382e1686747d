//! Removes characters that no page may contain, whatever is in a user's file: control characters and those that
//! change the direction of writing; escapes what XML would take for its own; begins with a capital.

/// One line of text: line breaks and tabs become spaces, control characters a replacement character.
pub fn line(text: &str) -> String {
    text.chars().map(|sign| if is_break(sign) || sign == '\t' { ' ' } else { shown(sign) }).collect()
}

/// As `line`, but line breaks stay; `\r\n` is one break.
pub fn lines(text: &str) -> String {
    let kept = |sign| if matches!(sign, '\n' | '\t') { sign } else { shown(sign) };
    text.replace("\r\n", "\n").chars().map(kept).collect()
}

/// A text that begins with a capital letter, as sentences and heads do.
pub fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

/// One line of text, escaped for the contents and the quoted attributes of XML and HTML.
pub fn escaped(text: &str) -> String {
    marks(&line(text))
}

/// As `escaped`, but line breaks stay.
pub fn escaped_lines(text: &str) -> String {
    marks(&lines(text))
}

fn marks(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for sign in text.chars() {
        match sign {
            '&' => shown.push_str("&amp;"),
            '<' => shown.push_str("&lt;"),
            '>' => shown.push_str("&gt;"),
            '"' => shown.push_str("&quot;"),
            '\'' => shown.push_str("&#39;"),
            other => shown.push(other),
        }
    }
    shown
}

const fn is_break(sign: char) -> bool {
    matches!(sign, '\n' | '\r' | '\u{2028}' | '\u{2029}')
}

fn shown(sign: char) -> char {
    let turns = matches!(sign, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    // XML does not permit these characters.
    let none = matches!(sign, '\u{fffe}' | '\u{ffff}');
    if sign.is_control() || turns || none { char::REPLACEMENT_CHARACTER } else { sign }
}

/// The address of a link, encoded; `None` for a scheme that browsers execute.
pub fn address(to: &str) -> Option<String> {
    let to = to.trim();
    let scheme = to.split_once(':').map(|(scheme, _)| scheme).filter(|scheme| !scheme.contains(['/', '?', '#']));
    let known =
        scheme.is_none_or(|scheme| ["http", "https", "mailto"].iter().any(|one| scheme.eq_ignore_ascii_case(one)));
    known.then(|| percent(to, |byte| !matches!(byte, b'<' | b'>' | b'"' | b'\\' | b'|' | b'`' | b'\'')))
}

/// The bytes of a text in an address: ASCII letters and digits, and the other signs for which `kept` holds,
/// unchanged.
pub fn percent(text: &str, kept: impl Fn(u8) -> bool) -> String {
    let mut shown = String::with_capacity(text.len());
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() || (byte.is_ascii_graphic() && kept(byte)) {
            shown.push(byte.into());
        } else {
            shown.push_str(&format!("%{byte:02X}"));
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    #[test]
    fn nothing_steers_a_terminal() {
        assert_eq!(super::line("a\tb\nc\u{1b}[31m\u{202e}"), "a b c\u{fffd}[31m\u{fffd}");
        assert_eq!(super::lines("a\r\n\tb\u{7}"), "a\n\tb\u{fffd}");
    }

    #[test]
    fn an_address_carries_nothing_out() {
        assert_eq!(super::address("docs/a b.md#x").as_deref(), Some("docs/a%20b.md#x"));
        assert_eq!(super::address("https://x.org/?a=1&b=%20").as_deref(), Some("https://x.org/?a=1&b=%20"));
        assert_eq!(super::address("план.md").as_deref(), Some("%D0%BF%D0%BB%D0%B0%D0%BD.md"));
        for to in ["javascript:alert(1)", " JavaScript:x", "data:text/html,<b>", "java\nscript:x"] {
            assert_eq!(super::address(to), None, "{to}");
        }
    }
}
