//! A diameter with its tolerance: `10H12`, or a nominal size with its limits.

use std::fmt;
use technolog_note::{Note, note};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::knowledge::Knowledge;
use crate::knowledge::alike::latin;
use crate::tables::holes::{HoleConvention, HoleDefault};
use crate::tables::standards::ItGradesFor;
use crate::tapping::minor_diameter;
use crate::units::{ItGrade, Micrometres};

use super::{Deviations, Thread, ThreadKind};

/// A diameter and its tolerance.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct ToleratedDiameter {
    /// Nominal size, mm.
    pub nominal: Micrometres,
    /// Upper deviation, mm.
    pub upper: Micrometres,
    /// Lower deviation, mm.
    pub lower: Micrometres,
    /// The grade for table queries: the stated one, or the coarsest that fits the limits.
    pub it: ItGrade,
    /// How the drawing writes it.
    pub written: String,
    /// What its limits come from.
    #[serde(default, skip_serializing_if = "LimitsOf::is_of_drawing")]
    pub limits: LimitsOf,
}

/// What the limits of a diameter come from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LimitsOf {
    /// The drawing gives a field or deviations.
    #[default]
    Drawing,
    /// The drawing gives a size alone.
    Free,
    /// The minor diameter of a thread, wide and without a size of its own.
    Thread,
}

impl LimitsOf {
    /// Whether the drawing gives them, which need not be said.
    fn is_of_drawing(&self) -> bool {
        *self == Self::Drawing
    }
}

impl fmt::Display for ToleratedDiameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // The name of the hole under a thread begins with the thread.
        let sign = if self.written.starts_with(|first: char| first.is_ascii_digit()) { "Ø" } else { "" };
        write!(f, "{sign}{}", self.written)
    }
}

impl technolog_note::IntoFigure for ToleratedDiameter {
    /// `Ø29.3H13` or `Ø8 +0.1/-0.1`, its numbers with the separator of the language.
    fn into_figure(self) -> technolog_note::Figure {
        let shown = self.to_string();
        let Some(mut rest) = shown.strip_prefix('Ø') else { return shown.into_figure() };
        let mut parts = vec!["Ø".into_figure()];
        while !rest.is_empty() {
            let of_number = |sign: char| sign.is_ascii_digit() || "+-.".contains(sign);
            let (part, behind) = rest.split_at(rest.find(|sign| !of_number(sign)).unwrap_or(rest.len()));
            parts.extend((!part.is_empty()).then(|| technolog_note::Figure::number(part.to_owned())));
            let (part, behind) = behind.split_at(behind.find(of_number).unwrap_or(behind.len()));
            parts.extend((!part.is_empty()).then(|| part.into_figure()));
            rest = behind;
        }
        technolog_note::Figure::List(parts, "")
    }
}

impl ToleratedDiameter {
    /// The diameter to aim at: the nominal where the limits permit it, else the middle between them.
    pub fn target(&self) -> Micrometres {
        if (self.smallest()..=self.largest()).contains(&self.nominal) {
            self.nominal
        } else {
            (self.smallest() + self.largest()).half()
        }
    }

    /// The largest permitted diameter.
    pub fn largest(&self) -> Micrometres {
        self.nominal + self.upper
    }

    /// The smallest permitted diameter.
    pub fn smallest(&self) -> Micrometres {
        self.nominal + self.lower
    }

    /// Reads `10H12`; a bare number is a free size, of the grade `free-size-grade` of `hole-defaults` (textbook 1.1).
    ///
    /// # Errors
    /// What is wrong, and what to write.
    pub fn parse(text: &str, knowledge: &Knowledge) -> Result<Self, Note> {
        // Cyrillic letters that look like Latin ones are typed as often.
        let written = without_sign(text);
        let text = latin(&written.replace('н', "H").replace('У', "Y"));
        if let Some(what_to_write) = of_drawing(&text) {
            return Err(what_to_write);
        }
        // The grade, and the letters of a field before it, so that a letter typed for a digit is reported as such.
        let without_grade = text.trim_end().trim_end_matches(|sign: char| sign.is_ascii_digit());
        let of_two = TWO_LETTERS.iter().find(|letters| without_grade.ends_with(**letters));
        let split = match without_grade.char_indices().last() {
            Some((at, _)) if of_two.is_some() => at - 1,
            Some((at, 'A'..='Z')) => at,
            _ => text.find(char::is_alphabetic).unwrap_or(text.len()),
        };
        let (size, field) = text.split_at(split);
        if size.trim().is_empty() {
            return Err(note!("part-no-size", text = written, example = "10H12"));
        }
        let nominal: Micrometres = size.trim().parse().map_err(|error| {
            // The meant value, where only the comma is wrong.
            let meant = size.trim().replace(',', ".");
            let meant = meant.parse::<Micrometres>().is_ok().then(|| format!("{meant}{field}"));
            note!("part-write-h", error = error, example = meant.unwrap_or_else(|| "10H12".to_owned()))
        })?;
        if field.is_empty() {
            let grade = convention(HoleDefault::FreeSizeGrade, knowledge)? as u8;
            let free = Self::with_grade(nominal, grade, nominal.to_string(), knowledge)?;
            return Ok(Self { limits: LimitsOf::Free, ..free });
        }
        let (letters, grade) =
            field.trim().split_at(field.trim().find(|sign: char| sign.is_ascii_digit()).unwrap_or(field.len()));
        if grade.is_empty() && letters.chars().all(|sign| sign.is_ascii_uppercase()) {
            return Err(note!("part-no-grade", text = text, field = letters, example = format!("{nominal}{letters}7")));
        }
        let unknown = || note!("part-no-tolerance-field-tables-know", field = field, nominal = nominal);
        let grade = grade.parse::<u8>().map_err(|_| unknown())?;
        let of_grade = Self::with_grade(nominal, grade, text.clone(), knowledge);
        if letters == "H" {
            return of_grade;
        }
        if !letters.is_empty() && letters.chars().all(|sign| sign.is_ascii_lowercase()) {
            let example = format!("{nominal}{}{grade}", letters.to_ascii_uppercase());
            return Err(note!("part-field-of-a-shaft", field = field, example = example));
        }
        let of_grade = of_grade?;
        let limits =
            Deviations::of_field(letters, of_grade.it, nominal, knowledge).map_err(|error| Note::from(&error))?;
        let Deviations { upper, lower } = limits.ok_or_else(unknown)?;
        Ok(Self { upper, lower, ..of_grade })
    }

    /// A size without a tolerance, such as that of a counterbore: of the grade `free-size-grade`, for any size.
    ///
    /// # Errors
    /// The size is outside the table `it-grades`.
    pub fn free(nominal: Micrometres, knowledge: &Knowledge) -> Result<Self, Note> {
        let number = convention(HoleDefault::FreeSizeGrade, knowledge)? as u8;
        let grade = ItGrade::new(number).ok_or_else(|| note!("part-grade-outside", number = number))?;
        let upper = tolerance_width(grade, nominal, knowledge)?;
        let written = nominal.to_string();
        Ok(Self { nominal, upper, lower: Micrometres::ZERO, it: grade, written, limits: LimitsOf::Free })
    }

    fn with_grade(nominal: Micrometres, grade: u8, written: String, knowledge: &Knowledge) -> Result<Self, Note> {
        in_range(nominal, knowledge)?;
        let it = ItGrade::new(grade)
            .filter(|grade| (6..=14).contains(&grade.number()))
            .ok_or_else(|| note!("part-grade-outside-which-tables-cover", grade = grade))?;
        let width = tolerance_width(it, nominal, knowledge)?;
        Ok(Self { nominal, upper: width, lower: Micrometres::ZERO, it, written, limits: LimitsOf::Drawing })
    }

    /// The hole that is drilled for a thread, within the limits of its minor diameter 6H; tables are asked by the grade of
    /// `hole-defaults` (textbook 1.2.1). A conical thread has no such limits: its hole is of that grade, from its nominal
    /// diameter upwards.
    ///
    /// # Errors
    /// The tables lack the grade or its width.
    pub fn under_thread(nominal: Micrometres, thread: &Thread, knowledge: &Knowledge) -> Result<Self, Note> {
        let grade = convention(HoleDefault::ThreadHoleGrade, knowledge)? as u8;
        let it = ItGrade::new(grade).ok_or_else(|| note!("part-thread-hole-grade-no-tolerance", grade = grade))?;
        let written = thread.written.clone();
        let minor = match thread.kind {
            ThreadKind::Cylindrical => {
                let limits = minor_diameter(thread.size, thread.pitch, knowledge);
                Some(limits.map_err(|error| Note::from(&error))?)
            }
            ThreadKind::Conical => None,
        };
        let Some((smallest, largest)) = minor.filter(|(least, most)| (least..=most).contains(&&nominal)) else {
            let upper = tolerance_width(it, nominal, knowledge)?;
            return Ok(Self { nominal, upper, lower: Micrometres::ZERO, it, written, limits: LimitsOf::Drawing });
        };
        let (upper, lower) = (largest - nominal, smallest - nominal);
        Ok(Self { nominal, upper, lower, it, written, limits: LimitsOf::Thread })
    }

    /// From limits: the coarsest grade whose tolerance is within the limits.
    ///
    /// # Errors
    /// The limits are crossed, leave no hole or are tighter than grade 6.
    pub fn from_limits(
        nominal: Micrometres,
        upper: Micrometres,
        lower: Micrometres,
        knowledge: &Knowledge,
    ) -> Result<Self, Note> {
        in_range(nominal, knowledge)?;
        let given = upper - lower;
        if given <= Micrometres::ZERO {
            return Err(note!("part-upper-deviation-must-above-lower", upper = upper, lower = lower));
        }
        if lower.abs().max(upper.abs()) >= nominal {
            return Err(note!("part-deviations-small-beside-they-mm", upper = upper, lower = lower, nominal = nominal));
        }
        let limits = Deviations { upper, lower };
        let it = limits.grade_among(6..=14, nominal, knowledge).map_err(|error| Note::from(&error))?;
        let it = it.ok_or_else(|| note!("part-tolerance-mm-tighter-than-grade", given = given, nominal = nominal))?;
        let written = format!("{nominal} {limits}");
        Ok(Self { nominal, upper, lower, it, written, limits: LimitsOf::Drawing })
    }
}

/// The fields of two letters (ISO 286-1); JS is the one that holes have.
const TWO_LETTERS: [&str; 7] = ["CD", "EF", "FG", "JS", "ZA", "ZB", "ZC"];

/// A size without the sign of a diameter before it, whichever of the alike letters it is typed with.
pub(super) fn without_sign(text: &str) -> &str {
    text.trim().trim_start_matches(['Ø', 'ø', '⌀', '∅', 'Φ', 'φ', 'Ф', 'ф']).trim_start()
}

/// What to write instead of a size as drawings have it but part files do not: a thread, a unit, deviations.
fn of_drawing(text: &str) -> Option<Note> {
    let typed = latin(text).replace(',', ".");
    let is_figure = |sign: char| sign.is_ascii_digit();
    if typed.strip_prefix(['M', 'm']).is_some_and(|size| size.trim_start().starts_with(is_figure)) {
        return Some(note!("part-diameter-is-a-thread", text = text, example = format!("thread: {typed}")));
    }
    if let Some(number) = text.strip_suffix("мм").or_else(|| text.strip_suffix("mm")) {
        return Some(note!("unit-write-bare-number-millimetres", text = text, number = number.trim()));
    }
    let limits = |nominal: Micrometres, either: Micrometres| {
        format!("{{nominal: {nominal}, upper: {either}, lower: {}}}", -either)
    };
    if let Some((nominal, either)) = typed.split_once('±')
        && let (Ok(nominal), Ok(either)) = (nominal.trim().parse(), either.trim().parse())
    {
        return Some(note!("part-write-deviations", text = text, example = limits(nominal, either)));
    }
    let letters = typed.find(is_figure).unwrap_or_default();
    let no_size =
        (1..=2).contains(&letters) && typed.starts_with(char::is_alphabetic) && typed[letters..].chars().all(is_figure);
    no_size.then(|| note!("part-size-before-tolerance", text = text, example = format!("10{typed}")))
}

/// Checks that the tools of the catalogs make such a hole (table `hole-defaults`); in solid metal [`largest`] is less.
fn in_range(nominal: Micrometres, knowledge: &Knowledge) -> Result<(), Note> {
    let bound = |name| convention(name, knowledge).map(Micrometres::from_mm_rounded);
    let (smallest, largest) = (bound(HoleDefault::SmallestDiameter)?, bound(HoleDefault::LargestOpened)?);
    if nominal < smallest || nominal > largest {
        return Err(note!(
            "part-outside-which-drills-catalogs-begin",
            nominal = nominal,
            smallest = smallest,
            largest = largest
        ));
    }
    Ok(())
}

/// The largest hole in solid metal, and the largest that the blank has.
pub(super) fn largest(knowledge: &Knowledge) -> Result<(Micrometres, Micrometres), Note> {
    let bound = |name| convention(name, knowledge).map(Micrometres::from_mm_rounded);
    Ok((bound(HoleDefault::LargestDiameter)?, bound(HoleDefault::LargestOpened)?))
}

/// A figure of the table `hole-defaults`.
fn convention(name: HoleDefault, knowledge: &Knowledge) -> Result<f64, Note> {
    HoleConvention::of(name, knowledge).map(|row| row.value).map_err(|error| Note::from(&error))
}

/// The width of a grade at a size, by the table `it-grades` (ISO 286-1).
///
/// # Errors
/// The size is outside the table.
pub fn tolerance_width(grade: ItGrade, size: Micrometres, knowledge: &Knowledge) -> Result<Micrometres, Note> {
    let answer = knowledge.ask(&ItGradesFor { it: grade, diameter: size }).map_err(|error| Note::from(&error))?;
    let row = answer.winner().map_err(|error| Note::from(&error))?;
    row.map(|row| row.tolerance).ok_or_else(|| note!("part-no-at-mm-table-grades", it = grade, size = size))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shipped;

    #[test]
    fn a_size_is_read_as_drawings_write_it() {
        let knowledge = shipped::knowledge().unwrap();
        for text in ["8H7", "Ø8H7", "ø8H7", "⌀8H7", "φ 8Н7", "Ф8H7"] {
            let read = ToleratedDiameter::parse(text, &knowledge).unwrap();
            assert_eq!(
                (read.nominal, read.upper, read.it.number()),
                (Micrometres::new(8_000), Micrometres::new(15), 7),
                "{text}"
            );
        }
    }

    /// Limits that ISO 286-2 prints; of 30JS7 it prints ±10 and allows it for ±10.5, which is the field.
    #[test]
    fn fields_of_holes_are_read_by_their_letters() {
        let knowledge = shipped::knowledge().unwrap();
        for (text, upper, lower) in [
            ("10K7", 5, -10),
            ("25G7", 28, 7),
            ("20P7", -14, -35),
            ("52K7", 9, -21),
            ("62N7", -9, -39),
            ("40F8", 64, 25),
            ("Ø10К7", 5, -10),
            ("16Р7", -11, -29),
            ("20А11", 430, 300),
            ("30В12", 370, 160),
            ("25С11", 240, 110),
            ("8CD9", 92, 56),
            ("6EF8", 32, 14),
            ("10FG7", 23, 8),
            ("40J7", 14, -11),
            ("30Т7", -33, -54),
            ("50U8", -70, -109),
            ("16V8", -39, -66),
            ("24Х7", -46, -67),
            ("30У8", -75, -108),
            ("40Z8", -112, -151),
            ("8ZA7", -46, -61),
            ("20ZB9", -136, -188),
            ("60ZC10", -405, -525),
        ] {
            let read = ToleratedDiameter::parse(text, &knowledge).unwrap_or_else(|_| panic!("{text}"));
            assert_eq!((read.upper, read.lower), (Micrometres::new(upper), Micrometres::new(lower)), "{text}");
        }
        // IT7 of 30 is 21, of 20 also; IT8 of 50 is 39; IT6 of 100 is 22.
        for (text, shown) in [("30JS7", "0.0105"), ("20JS7", "0.0105"), ("50JS8", "0.0195"), ("70JS6", "0.0095")] {
            let read = ToleratedDiameter::parse(text, &knowledge).unwrap_or_else(|_| panic!("{text}"));
            assert_eq!((read.upper.to_string(), read.lower), (shown.to_owned(), -read.upper), "{text}");
            assert_eq!(read.largest() - read.smallest(), read.upper + read.upper, "{text}");
        }
    }

    #[test]
    fn limits_as_a_hint_writes_them_have_the_grade_of_the_field() {
        let knowledge = shipped::knowledge().unwrap();
        for (nominal, either, grade) in
            [(8, 7, 7), (8, 4, 6), (8, 11, 8), (10, 7, 7), (20, 10, 7), (20, 16, 8), (40, 12, 7)]
        {
            let (nominal, either) = (Micrometres::from_mm(nominal), Micrometres::new(either));
            let read = ToleratedDiameter::from_limits(nominal, either, -either, &knowledge).unwrap();
            assert_eq!(read.it.number(), grade, "{nominal} ±{either}");
        }
        // One that is not JS is of the finer grade.
        let (upper, lower) = (Micrometres::new(14), Micrometres::ZERO);
        assert_eq!(
            ToleratedDiameter::from_limits(Micrometres::from_mm(8), upper, lower, &knowledge).unwrap().it.number(),
            6
        );
    }

    #[test]
    fn what_is_no_size_is_refused_with_the_remedy() {
        let knowledge = shipped::knowledge().unwrap();
        for (text, words) in [
            ("8js7", "is the field of a shaft; holes have capital letters: `8JS7`"),
            ("8ZQ7", "`8Z` is not a number"),
            ("8K", "lacks the grade after `K`, as in `8K7`"),
            ("вісім", "`вісім` is not a size"),
            ("8H", "lacks the grade after `H`, as in `8H7`"),
            ("H7", "as in `10H7`"),
            ("8h7", "is the field of a shaft; holes have capital letters: `8H7`"),
            ("8V7", "`V7` is not a tolerance field of a hole"),
        ] {
            let why = ToleratedDiameter::parse(text, &knowledge).unwrap_err();
            let said = technolog_words::Lang::EN.say(&why);
            assert!(said.contains(words), "{text}: {said}");
        }
    }
}
