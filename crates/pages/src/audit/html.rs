//! An audit as a page for a browser: one file, nothing loaded from elsewhere, whatever a plan says only shown.

use technolog_audit::{Audit, Audited, Comparison};

use super::super::Lang;
use super::{against, by_section, counts, details, heading, headline, many, marks, place, severity, summary, title};

/// Colours for both lights of a screen, and for paper; a severity is told by its word too, not by colour alone.
const STYLE: &str = "
:root { color-scheme: light dark; --error: #b3261e; --wrong: #b45309; --doubtful: #52606d; --note: #2f6f4f; --line: #8886; }
@media screen and (prefers-color-scheme: dark) {
  :root { --error: #ff8a80; --wrong: #ffb74d; --doubtful: #b0bec5; --note: #81c784; }
}
body { font: 16px/1.5 system-ui, sans-serif; max-width: 72rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; margin-bottom: 0; } h2 { font-size: 1.15rem; margin-top: 2rem; border-bottom: 1px solid var(--line); }
h1, p, li { text-wrap: pretty; overflow-wrap: anywhere; } .file { margin-top: 0; }
ul { list-style: none; padding: 0; } li { margin: .6rem 0; }
li.finding { border-left: 4px solid; padding-left: .75rem; }
li.error { border-color: var(--error); } li.wrong { border-color: var(--wrong); }
li.doubtful { border-color: var(--doubtful); } li.note { border-color: var(--note); }
.error > b { color: var(--error); } .wrong > b { color: var(--wrong); }
.doubtful > b { color: var(--doubtful); } .note > b { color: var(--note); }
code { opacity: .8; } span { white-space: nowrap; }
.why { font-size: .9rem; margin: .1rem 0 0 1rem; } .why li { margin: 0; opacity: .85; } .marks li { margin: .2rem 0; }
.scroll { overflow-x: auto; } table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { text-align: left; vertical-align: top; padding: .25rem .6rem; border-bottom: 1px solid var(--line); }
.counts :is(th, td):nth-child(n + 2), .plans :is(th, td):is(:nth-child(n + 2):nth-child(-n + 5), :nth-child(7)) { text-align: right; }
.plans, .beside { width: 100%; } .plans :is(th, td):nth-child(1) { min-width: 12rem; overflow-wrap: anywhere; }
.beside { table-layout: fixed; overflow-wrap: anywhere; min-width: 36rem; } .beside th:nth-child(2) { width: 36%; }
@media (max-width: 40rem) { th, td { padding: .2rem .3rem; font-size: .85rem; } }
@media print {
  body { margin: 0; max-width: none; font-size: 11pt; } h2 { break-after: avoid; } li.finding, tr { break-inside: avoid; }
  .scroll { overflow: visible; }
}
";

/// The page of a plan.
pub fn page(audit: &Audit, lang: Lang) -> String {
    let title = title(audit, lang);
    let mut body = format!("<h1>{}</h1>\n<p class=\"file\"><code>{}</code></p>\n", said(&title), escaped(&audit.file));
    body.push_str(&format!("<p>{}</p>\n", escaped(&summary(audit, lang))));
    let (head, rows) = counts::table(audit, lang);
    if !rows.is_empty() {
        body.push_str(&table("counts", &head, &rows));
    }
    for (section, findings) in by_section(audit) {
        body.push_str(&format!("<h2>{}</h2>\n<ul>\n", heading(section, lang)));
        for finding in findings {
            let at = place(finding, &audit.file).map(|place| format!(" <code>{}</code>", escaped(&place)));
            let (class, word) = (finding.severity.name(), severity(finding.severity, lang));
            let said = said(&headline(finding, lang));
            body.push_str(&format!("<li class=\"finding {class}\"><b>{word}</b>{} {said}", at.unwrap_or_default()));
            body.push_str(&list("why", &details(finding, audit, lang)));
            body.push_str("</li>\n");
        }
        body.push_str("</ul>\n");
    }
    if let Some(marks) = &audit.marks {
        body.push_str(&format!("<h2>{}</h2>\n", escaped(&marks::headline(marks, lang))));
        body.push_str(&list("marks", &marks::lines(marks, audit, lang)));
    }
    whole(&title, &body, lang)
}

/// The page of a folder.
pub fn folder(audited: &[Audited], lang: Lang) -> String {
    let (head, rows) = many::table(audited, lang);
    let body = format!(
        "<h1>{}</h1>\n<p>{}</p>\n{}",
        many::title(lang),
        escaped(&many::summary(audited, lang)),
        table("plans", &head, &rows),
    );
    whole(many::title(lang), &body, lang)
}

/// The page of two plans beside each other.
pub fn comparison(comparison: &Comparison, lang: Lang) -> String {
    let title = against::title(comparison, lang);
    let mut body = format!("<h1>{}</h1>\n", escaped(&title));
    for (heading, head, rows) in against::tables(comparison, lang) {
        body.push_str(&format!("<h2>{}</h2>\n{}", escaped(heading), table("beside", &head, &rows)));
    }
    if comparison.differences.is_empty() {
        body.push_str(&format!("<p>{}</p>\n", against::none(lang)));
    }
    whole(&title, &body, lang)
}

/// A table under a head, which scrolls by itself where it is too wide.
fn table(class: &str, head: &[String], rows: &[Vec<String>]) -> String {
    let cells = |cells: &[String], tag: &str| -> String {
        let cells = cells.iter().map(|cell| format!("<{tag}>{}</{tag}>", said(cell))).collect::<String>();
        format!("<tr>{cells}</tr>\n")
    };
    let rows: String = rows.iter().map(|row| cells(row, "td")).collect();
    format!(
        "<div class=\"scroll\"><table class=\"{class}\">\n<thead>{}</thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n",
        cells(head, "th").trim_end(),
    )
}

fn whole(title: &str, body: &str, lang: Lang) -> String {
    format!(
        "<!doctype html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n\
         <style>{STYLE}</style>\n</head>\n<body>\n{body}</body>\n</html>\n",
        lang.pick("uk", "en"),
        escaped(title)
    )
}

fn list(class: &str, lines: &[String]) -> String {
    if lines.is_empty() {
        return String::new();
    }
    let items: String = lines.iter().map(|line| format!("<li>{}</li>\n", said(line))).collect();
    format!("\n<ul class=\"{class}\">\n{items}</ul>\n")
}

/// A sentence: what stands in backticks as code; designations, numbers with a sign and their per cent signs unbroken.
fn said(text: &str) -> String {
    let pieces: Vec<&str> = text.split('`').collect();
    let paired = pieces.len() % 2 == 1;
    let shown = |(at, piece): (usize, &&str)| match (paired, at % 2) {
        (true, 1) => format!("<code>{}</code>", escaped(piece)),
        (false, _) if at > 0 => format!("`{}", unbroken(piece)),
        _ => unbroken(piece),
    };
    pieces.iter().enumerate().map(shown).collect()
}

/// A text whose short names and numbers with a dash, `2И20-5-80`, are not broken at it.
fn unbroken(text: &str) -> String {
    let word = |word: &str| {
        let name = word.contains('-') && word.contains(|letter: char| letter.is_ascii_digit()) && word.len() <= NAME;
        if name { format!("<span>{}</span>", escaped(word)) } else { escaped(word) }
    };
    text.split(' ').map(word).collect::<Vec<_>>().join(" ").replace(" %", "\u{a0}%")
}

/// The longest name, in bytes, that a line has room for as a whole.
const NAME: usize = 32;

/// A text as it is shown, whatever signs are in it.
fn escaped(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => shown.push_str("&amp;"),
            '<' => shown.push_str("&lt;"),
            '>' => shown.push_str("&gt;"),
            '"' => shown.push_str("&quot;"),
            '\'' => shown.push_str("&#39;"),
            // Signs that no page may have, and those that turn the direction of the text.
            '\t' | '\n' => shown.push(' '),
            other if other.is_control() || matches!(other, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}') => {
                shown.push('\u{fffd}');
            }
            other => shown.push(other),
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{escaped, said};

    #[test]
    fn names_stay_whole_and_backticks_are_code() {
        for (text, html) in [
            ("за 2И20-5-80 до", "за <span>2И20-5-80</span> до"),
            ("`a<b` дає -19,9 %", "<code>a&lt;b</code> дає <span>-19,9</span>\u{a0}%"),
            ("a ` b", "a ` b"),
            ("one-two", "one-two"),
        ] {
            assert_eq!(said(text), html);
        }
    }

    proptest! {
        #![proptest_config(technolog_laws::cases!(256))]

        #[test]
        fn no_text_opens_a_tag_or_ends_an_attribute(text in any::<String>()) {
            let shown = escaped(&text);
            prop_assert!(!shown.contains(['<', '>', '"', '\'']), "{shown}");
            let known = ["&amp;", "&lt;", "&gt;", "&quot;", "&#39;"];
            for (at, _) in shown.match_indices('&') {
                prop_assert!(known.iter().any(|name| shown[at..].starts_with(name)), "{shown}");
            }
        }
    }
}
