//! Messages for broken YAML with a remedy. They replace those of the parser, which are English and technical.

/// Phrases of the parser's messages, the message shown instead, and its remedy. The first match is used.
pub(super) const FAULTS: &[(&[&str], &str, &str)] = &[
    (&["tab"], "yaml-broken-tab", "yaml-mend-tab"),
    (&["mapping values are not allowed", "illegal placement of ':'"], "yaml-broken-colon", "yaml-mend-colon"),
    (&["anchor", "alias"], "yaml-broken-anchor", "yaml-mend-anchor"),
    (&["escape", "hexadecimal"], "yaml-broken-escape", "yaml-mend-escape"),
    (&["trailing content"], "yaml-broken-behind-quote", "yaml-mend-behind-quote"),
    (&["quoted scalar", "unexpected eof"], "yaml-broken-quote", "yaml-mend-quote"),
    (&["flow", "misplaced bracket", "',' or", "only valid inside a block"], "yaml-broken-bracket", "yaml-mend-bracket"),
    (&["'-' indicator", "sequence entries"], "yaml-broken-dash", "yaml-mend-dash"),
    (&["key"], "yaml-broken-key", "yaml-mend-key"),
    (&["indent"], "yaml-broken-indent", "yaml-mend-indent"),
    (&["document"], "yaml-broken-document", "yaml-mend-document"),
    (
        &["directive", "tag", "plain scalar", "unexpected character", "block scalar", "node content", "handle", "TAG"],
        "yaml-broken-sign",
        "yaml-mend-sign",
    ),
];

#[cfg(test)]
mod tests {
    use technolog_words::Lang;

    use crate::yaml::parse;

    #[test]
    fn broken_text_is_told_in_the_words_of_the_reader_with_a_remedy() {
        for (text, what, mend) in [
            ("a: b: c\n", "a second `: ` in one line", "quote a text"),
            ("a: 1\n  b: 2\n", "a second `: ` in one line", "the same indent"),
            ("a: 1\nb\nc: 2\n", "`key: value`", "a colon and a space"),
            ("a:\n  - 1\n  b: 2\n", "items of a list", "in the column of the first"),
            ("a:\n\tb: 1\n", "a tab", "with spaces"),
            ("a: \"open\nb: 1\n", "a quotation mark is not closed", "close it"),
            ("a: 'x' y\n", "", "quot"),
            ("a: [1, 2\nb: 3\n", "a bracket is not closed", "`[` with `]`"),
            ("a: {b: 1\nc: 3\n", "a bracket is not closed", "`{` with `}`"),
            ("a: {b: 1\nc:\n  - 3\n", "a bracket is not closed", "`{` with `}`"),
            ("a: *b\n", "begins with `&` or `*`", "quote the text"),
            ("a: %b\nc: @d\n", "a sign that means something else", "quote the text"),
            ("a: \"\\q\"\n", "begins nothing known", "single quotes"),
        ] {
            let (_, problems) = parse("t.yaml", text);
            let [problem] = problems.as_slice() else { panic!("{text:?}: {problems:?}") };
            let message = problem.text(|note| Lang::EN.say(note));
            assert!(message.contains(what) && message.contains(mend), "{text:?}: {message}");
            let message = problem.text(|note| Lang::UK.say(note));
            let letters = |is: fn(&char) -> bool| message.chars().filter(is).count();
            let (latin, cyrillic) = (letters(char::is_ascii_alphabetic), letters(|sign| ('а'..='я').contains(sign)));
            assert!(cyrillic > 2 * latin, "{text:?}: {message}");
        }
    }
}
