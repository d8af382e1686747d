//! The symbols of quantities in other languages: audits calculate with those of the handbook, whose indexes are Ukrainian;
//! English plans have `Tm`, `F` and `n` for them.

use super::Lang;

/// Symbols of the handbook, and with Latin letters alone.
const LATIN: [(&str, &str); 20] = [
    ("nпр", "n"),
    ("Sхв", "F"),
    ("Sт", "St"),
    ("Vт", "Vt"),
    ("Vд", "Va"),
    ("Pт", "Pt"),
    ("Nт", "Nt"),
    ("Tм", "Tm"),
    ("ΣTм", "ΣTm"),
    ("Tх", "Tr"),
    ("Tвв", "Tf"),
    ("Tвт", "Td"),
    ("Tр", "Th"),
    ("Tзм", "Tc"),
    ("tзм", "tc"),
    ("lопр", "lh"),
    ("lв", "lo"),
    ("Lк", "La"),
    ("Lет", "Lr"),
    ("zп", "zc"),
];

/// A symbol or a formula with the symbols of a language.
pub(super) fn written(formula: &str, lang: Lang) -> String {
    if lang.tag() == "uk" {
        return formula.to_owned();
    }
    let mut text = String::with_capacity(formula.len());
    let mut rest = formula;
    while let Some(first) = rest.chars().next() {
        let is_word = |letter: char| letter.is_alphanumeric();
        let end = rest.find(|letter: char| is_word(letter) != is_word(first)).unwrap_or(rest.len());
        let (token, behind) = rest.split_at(end);
        let known = LATIN.iter().find(|(symbol, _)| *symbol == token);
        text.push_str(known.map_or(token, |(_, latin)| latin));
        rest = behind;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_are_those_of_the_language() {
        assert_eq!(written("Tм = L·i/Sхв", Lang::EN), "Tm = L·i/F");
        assert_eq!(written("ΣTм = Σz·Tм", Lang::UK), "ΣTм = Σz·Tм");
        assert_eq!(written("P = 10·Cp·D^q·t^x·S^y·Kp", Lang::EN), "P = 10·Cp·D^q·t^x·S^y·Kp");
    }
}
