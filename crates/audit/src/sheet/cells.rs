//! What stands in one cell: a figure with or without its unit, a hole by its size, a tool with its standard.

use crate::knowledge::alike::latin;
use crate::knowledge::units::Unit;
use crate::part::Part;

use super::columns::{Column, unit};

/// Whether a cell says nothing.
pub(super) fn is_empty(text: &str) -> bool {
    matches!(text, "" | "-" | "–" | "—" | "−")
}

/// The figure of a cell without the unit of its column behind it, a sign of diameter before it, and spaces between thousands.
pub(super) fn figure(text: &str, of: Unit) -> String {
    let text = text.trim_start_matches(['Ø', '⌀', 'Φ', 'ø']).trim();
    let end = text.rfind(|sign: char| sign.is_ascii_digit()).map_or(0, |at| at + 1);
    let (digits, rest) = text.split_at(end);
    let own = rest.trim().is_empty() || unit(rest) == Some(of);
    let digits = if own && end > 0 { digits } else { text };
    // Thousands apart: `1 250`.
    let groups: Vec<&str> = digits.split(' ').collect();
    let plain = |group: &str| group.bytes().all(|byte| byte.is_ascii_digit());
    let apart = groups.len() > 1
        && groups.first().is_some_and(|first| (1..=3).contains(&first.len()) && plain(first))
        && groups.iter().skip(1).all(|group| group.len() == 3 && plain(group));
    if apart { groups.concat() } else { digits.to_owned() }
}

/// The group of holes that a cell names: by its name, or by a size that only one group has.
pub(super) fn hole(text: &str, part: Option<&Part>) -> String {
    let Some(part) = part else { return text.to_owned() };
    let named =
        |name: &str| part.holes.iter().find(|hole| latin(&hole.name) == latin(name)).map(|hole| hole.name.clone());
    let first = text.split([' ', ',', '(', ';']).next().unwrap_or_default();
    if let Some(name) = named(text).or_else(|| named(first)) {
        return name;
    }
    by_thread(text, part).or_else(|| size(text).and_then(|size| of_size(size, part))).unwrap_or_else(|| text.to_owned())
}

/// The group of holes whose size a name writes out, `Ø20H7` or `M8`, where only one group has it. A bare number may be
/// the number of a hole.
pub(crate) fn by_size(text: &str, part: &Part) -> Option<String> {
    let written = text.trim_start_matches(|sign: char| sign.is_ascii_digit() || matches!(sign, '.' | ',' | ' '));
    let sized = || size(text).filter(|_| !written.is_empty()).and_then(|size| of_size(size, part));
    by_thread(text, part).or_else(sized)
}

/// The one group of holes of a thread.
fn by_thread(text: &str, part: &Part) -> Option<String> {
    let is = |own: &str| latin(own) == latin(text);
    let thread = |hole: &&crate::part::Hole| hole.thread.as_ref().is_some_and(|own| is(&own.written) || is(&own.id));
    let mut own = part.holes.iter().filter(thread);
    own.next().filter(|_| own.next().is_none()).map(|hole| hole.name.clone())
}

/// The one group of holes of a nominal diameter, mm.
pub(super) fn of_size(size: f64, part: &Part) -> Option<String> {
    let mut own = part.holes.iter().filter(|hole| (hole.diameter.nominal.to_mm() - size).abs() < 1e-6);
    own.next().filter(|_| own.next().is_none()).map(|hole| hole.name.clone())
}

/// The diameter that a text begins with, mm: `Ø20H7`, `20H7 x 40`, `2 отв. 10` has none.
pub(super) fn size(text: &str) -> Option<f64> {
    let text = text.trim_start_matches(['Ø', '⌀', 'Φ', 'ø']).trim();
    let end = text.find(|sign: char| !sign.is_ascii_digit() && !matches!(sign, '.' | ',')).unwrap_or(text.len());
    let (digits, rest) = text.split_at(end);
    let tolerance = rest.is_empty()
        || rest.trim_start().starts_with(|sign: char| sign.is_ascii_uppercase() || "×xх*".contains(sign));
    digits.replace(',', ".").parse().ok().filter(|size: &f64| tolerance && *size > 0.0)
}

/// The hole of a text without a part, as a part file writes its diameter: with its tolerance, or free.
pub(super) fn diameter(text: &str) -> Option<String> {
    let size = size(text)?;
    let rest = text.trim_start_matches(|sign: char| !sign.is_ascii_uppercase());
    let grade: String = rest.chars().take_while(char::is_ascii_alphanumeric).collect();
    let is_grade = grade.starts_with(['H', 'G', 'J', 'K', 'N']) && grade.ends_with(|sign: char| sign.is_ascii_digit());
    Some(format!("{size}{}", if is_grade { grade.as_str() } else { "H14" }))
}

/// A designation apart from what people write around it: the kind of tool before it, the standard behind it.
pub(super) fn designation(text: &str) -> (String, Option<String>) {
    let begins = |word: &str| ["ОСТ", "ГОСТ", "ДСТУ", "ТУ", "DIN", "ISO", "ANSI"].contains(&word);
    let words: Vec<&str> = text.split(' ').collect();
    let at = words.iter().position(|word| begins(word)).filter(|at| *at > 0).unwrap_or(words.len());
    let (own, standard) = words.split_at(at);
    let has_digit = |word: &&str| word.chars().any(|sign| sign.is_ascii_digit());
    let is_size = |word: &str| word.starts_with(['Ø', '⌀', 'ø']);
    // Words before the number name the kind of tool; a number of its own follows them.
    let skipped = own.iter().take_while(|word| !has_digit(word) || is_size(word)).count();
    let own = own.get(skipped..).filter(|rest| !rest.is_empty()).unwrap_or(own);
    let own: Vec<&str> = own.iter().map(|word| word.trim_end_matches([',', ';'])).collect();
    let standard = (!standard.is_empty()).then(|| standard.join(" "));
    (own.join(" "), standard)
}

/// Whether every text fits a column of several that are called alike.
pub(super) fn fit(column: Column, texts: &[&str]) -> bool {
    let place = |text: &&str| {
        let number = text.strip_prefix(['T', 'Т', 't', 'т']).unwrap_or(text);
        !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()) && number.len() < 4
    };
    match column.key {
        "tool" => !texts.is_empty() && texts.iter().all(place),
        "designation" => texts.is_empty() || !texts.iter().all(place),
        _ => column.quantity().is_none() || texts.iter().all(|text| text.contains(|sign: char| sign.is_ascii_digit())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_figure_stands_apart_from_its_unit() {
        let cases = [
            ("0,25 мм/об", Unit::MillimetrePerRev, "0,25"),
            ("1 250", Unit::RevPerMinute, "1250"),
            ("Ø10.5", Unit::Millimetre, "10.5"),
            ("−60,4 мм", Unit::Millimetre, "−60,4"),
            ("0,25 мм/хв", Unit::MillimetrePerRev, "0,25 мм/хв"),
            ("12 34", Unit::Millimetre, "12 34"),
            ("немає", Unit::Millimetre, "немає"),
        ];
        for (text, of, figure) in cases {
            assert_eq!(super::figure(text, of), figure);
        }
    }

    #[test]
    fn a_size_begins_a_hole() {
        for (text, of) in [
            ("Ø20H7", Some("20H7")),
            ("20H7 x 40", Some("20H7")),
            ("8,5", Some("8.5H14")),
            ("A", None),
            ("2 отв.", None),
        ] {
            assert_eq!(diameter(text).as_deref(), of, "{text}");
        }
    }

    #[test]
    fn a_designation_stands_apart_from_words_around_it() {
        let cases = [
            ("Свердло 035-2300-1273 ОСТ 2И20-1-80", ("035-2300-1273", Some("ОСТ 2И20-1-80"))),
            ("Свердло спіральне Ø10, 035-2300-1273", ("035-2300-1273", None)),
            ("2363-3468", ("2363-3468", None)),
            ("BB-R-25-36", ("BB-R-25-36", None)),
            ("Патрон цанговий 191113040", ("191113040", None)),
            ("Свердло", ("Свердло", None)),
        ];
        for (text, (own, standard)) in cases {
            assert_eq!(designation(text), (own.to_owned(), standard.map(str::to_owned)), "{text}");
        }
    }
}
