//! Whether a text is surely a program of a lathe, so that a mill's control need not tell every word of it wrong.
//!
//! Only what no program of a mill has counts: two axes and no third, no plane XY, no drilling cycle of a mill, and a word
//! that belongs to turning. Where that is not all there the answer is that nobody knows.

use super::LatheReader;

/// What a text shows.
#[derive(Default)]
struct Signs {
    x: bool,
    z: bool,
    /// A word that a lathe has no use for.
    of_mill: bool,
    /// H: of a mill, and of a lathe with LinuxCNC where tools share a place.
    offset: bool,
    /// M6.
    change: bool,
    /// T of four digits: place and offset.
    place_and_offset: bool,
    /// G7 or G8: X is a diameter or a radius (LinuxCNC).
    diameter: bool,
    /// G96: constant cutting speed.
    cutting_speed: bool,
    /// G18: the plane of X and Z.
    plane: bool,
    /// A word of Sinumerik for turning.
    siemens: bool,
}

/// The controls of lathes that a text may be for, where it is surely for a lathe; otherwise empty.
pub fn recognised(text: &str) -> Vec<LatheReader> {
    let mut signs = Signs::default();
    text.lines().for_each(|line| signs.line(line));
    if !signs.x || !signs.z || signs.of_mill || (signs.offset && !signs.diameter) {
        Vec::new()
    } else if signs.siemens {
        vec![LatheReader::Sinumerik]
    } else if signs.diameter && signs.plane {
        vec![LatheReader::LinuxCnc]
    } else if signs.place_and_offset && !signs.change {
        vec![LatheReader::Fanuc]
    } else if signs.cutting_speed && signs.plane {
        vec![LatheReader::LinuxCnc, LatheReader::Sinumerik]
    } else {
        Vec::new()
    }
}

impl Signs {
    fn line(&mut self, line: &str) {
        let mut rest = line.trim_start_matches('/');
        while let Some(first) = rest.chars().next() {
            match first {
                ';' => return,
                // A comment ends on its line.
                '(' => rest = rest.find(')').map_or("", |end| rest.get(end + 1..).unwrap_or_default()),
                // What Sinumerik names stands in quotes.
                '"' => {
                    let inner = rest.get(1..).unwrap_or_default();
                    rest = inner.find('"').map_or("", |end| inner.get(end + 1..).unwrap_or_default());
                }
                first if first.is_ascii_alphabetic() => {
                    let letters = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
                    let (word, behind) = rest.split_at(letters);
                    let digits = behind.find(|c: char| !c.is_ascii_digit()).unwrap_or(behind.len());
                    let (number, behind) = behind.split_at(digits);
                    self.word(&word.to_ascii_uppercase(), number);
                    rest = behind;
                }
                first => rest = rest.get(first.len_utf8()..).unwrap_or_default(),
            }
        }
    }

    fn word(&mut self, word: &str, number: &str) {
        let value: Option<u32> = number.parse().ok();
        match (word, value) {
            ("X", _) => self.x = true,
            ("Z", _) => self.z = true,
            // G84 taps the face on a lathe too.
            ("H", _) => self.offset = true,
            ("Y" | "J" | "A" | "B", _) | ("G", Some(17 | 19 | 81..=83 | 85..=89)) => self.of_mill = true,
            ("G", Some(7 | 8)) => self.diameter = true,
            ("G", Some(18)) => self.plane = true,
            ("G", Some(96)) => self.cutting_speed = true,
            ("M", Some(6)) => self.change = true,
            ("T", Some(place)) => self.place_and_offset |= number.len() == 4 && place >= 100,
            ("CYCLE", Some(95)) | ("DIAMON" | "DIAMOF" | "LIMS", _) => self.siemens = true,
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_turning_tell_a_lathe() {
        for (text, controls) in [
            ("G18 G21 G7 G40 G90 G95\nT1 M6 G43\nG0 X64 Z4", &[LatheReader::LinuxCnc][..]),
            ("G18 G21 G7\nT1 M6 G43 H7\nG0 X64 Z4", &[LatheReader::LinuxCnc]),
            ("O0001\nG21 G40 G99\nT0101\nG97 S560 M3\nG0 X64. Z4.", &[LatheReader::Fanuc]),
            ("O0001\nT0606\nG97 S355 M3\nG0 X0. Z5.\nM29 S355\nG84 Z-25. F1.75\nG80", &[LatheReader::Fanuc]),
            ("G18 DIAMON G95\nT1 D1\nG0 X64 Z4\nCYCLE95(\"Y\", 5)", &[LatheReader::Sinumerik]),
            ("G18 G96 S150\nT1 D1\nG0 X64 Z4 (Y is none)", &[LatheReader::LinuxCnc, LatheReader::Sinumerik]),
        ] {
            assert_eq!(recognised(text), controls, "{text}");
        }
    }

    /// One sign is not enough: an arc in XZ, a drill at one place, a tool of four digits that M6 changes.
    #[test]
    fn what_a_mill_may_have_tells_nothing() {
        for text in [
            "",
            "%",
            "G18\nG2 X10 Z0 R5",
            "G95 G1 Z-5 F0.1\nX10",
            "T0101 M6\nG0 X1 Z2",
            "T1000\nM06\nG0 X1 Z2",
            "G96 S100\nG0 X1 Z2",
            "T0101\nG0 X1 Y1\nZ2",
            "T0101\nG43 H1 Z2\nX1",
            "T0101\nG0 X1 Z2\nG81 Z-5 R1",
            "T0101\nG0 X1",
            "Українською: X1 Z2",
        ] {
            assert!(recognised(text).is_empty(), "{text}");
        }
    }
}
