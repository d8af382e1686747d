//! How wide letters are.

/// Advance widths of Arial, and of Liberation Sans, which has the same by design: in units of 2048 to the size of a letter,
/// with the letters that have it (table `hmtx` of `LiberationSans-Regular.ttf`).
const WIDTHS: [(u16, &str); 62] = [
    (391, "'"),
    (455, "ijlі’"),
    (532, "|"),
    (569, " !,./:;I[\\]ftІЇї·"),
    (682, "()-`r²³“”"),
    (684, "{}"),
    (727, "\""),
    (747, "г"),
    (797, "*"),
    (819, "°"),
    (842, "ґ"),
    (896, "к"),
    (938, "т"),
    (939, "з"),
    (961, "^"),
    (1001, "Ґ"),
    (1024, "Jcksvxyzсухγ"),
    (1045, "эє"),
    (1067, "чь"),
    (1088, "в"),
    (1109, "Гпя"),
    (1124, "±≈≠≤≥√"),
    (1131, "н"),
    (1139, "#$0123456789?L_abdeghnopquаеорё«»–"),
    (1144, "ий"),
    (1173, "бц"),
    (1178, "β"),
    (1184, "α"),
    (1193, "К"),
    (1195, "дл"),
    (1196, "+<=>~×−"),
    (1237, "З"),
    (1251, "FTZТø"),
    (1280, "ъ"),
    (1301, "У"),
    (1328, "φ"),
    (1344, "БЛЬ"),
    (1365, "Ч"),
    (1366, "&ABEKPSVXYАВЕРХ"),
    (1367, "Ё"),
    (1370, "ж"),
    (1387, "Д"),
    (1408, "м"),
    (1472, "ИЙПЭыЄ"),
    (1479, "CDHNRUwНСЯ"),
    (1515, "Ц"),
    (1536, "ю"),
    (1557, "Ф"),
    (1593, "GOQОØ"),
    (1621, "Ъ"),
    (1643, "ш"),
    (1685, "фщ"),
    (1706, "MmМ"),
    (1813, "Ы"),
    (1821, "%"),
    (1877, "Ш"),
    (1891, "Ж"),
    (1920, "Щ"),
    (1933, "W"),
    (2048, "—…→"),
    (2069, "Ю"),
    (2079, "@"),
];
/// The width of a digit, for letters that are not listed.
const USUAL: u16 = 1139;

/// The width of a letter in units of its size.
pub fn width(letter: char) -> f64 {
    let known = WIDTHS.iter().find(|(_, letters)| letters.contains(letter));
    f64::from(known.map_or(USUAL, |(width, _)| *width)) / 2048.0
}

#[cfg(test)]
mod tests {
    /// Half of the letters of a language with a different width than these would stand in one another.
    #[test]
    fn letters_of_both_alphabets_have_their_widths() {
        assert_eq!(super::width('i') * 2048.0, 455.0);
        assert_eq!(super::width('Щ') * 2048.0, 1920.0);
    }
}
