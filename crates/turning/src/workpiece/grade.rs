//! The accuracy of a surface: a grade by number, or by the field of the drawing.

use crate::turning::contour::{Field, Side};
use crate::units::ItGrade;

/// A grade, and its field if letters name one. Reads `6`, `IT6`, `h6`, `js7`, `H7`; Cyrillic letters that look like the Latin ones are read as these.
///
/// # Errors
/// The code of the mistake: it is no grade, or it is the field of a hole on an outer surface (or the other way round).
pub(super) fn read(text: &str, side: Side) -> Result<(ItGrade, Option<Field>), &'static str> {
    let text = text.trim();
    let split = text.find(|letter: char| letter.is_ascii_digit()).unwrap_or(text.len());
    let (letters, number) = text.split_at(split);
    let letters: String = letters.chars().map(latin).collect();
    let grade = number.parse::<u8>().ok().and_then(ItGrade::new).ok_or("bad-grade")?;
    if letters.is_empty() || letters == "IT" {
        return Ok((grade, None));
    }
    if letters.chars().count() > 2 || !letters.chars().all(|letter| letter.is_ascii_alphabetic()) {
        return Err("bad-grade");
    }
    let of_hole = letters.chars().all(|letter| letter.is_ascii_uppercase());
    let of_shaft = letters.chars().all(|letter| letter.is_ascii_lowercase());
    let field = |letters: String| Ok((grade, Some(Field { letters, grade })));
    match side {
        Side::Outer if of_shaft => field(letters),
        Side::Inner if of_hole => field(letters),
        // `Js` is often written for JS.
        Side::Inner if letters == "Js" => field("JS".to_owned()),
        _ if of_hole || of_shaft => Err("field-of-the-other-side"),
        _ => Err("bad-grade"),
    }
}

/// The Latin letter that a Cyrillic one looks like.
const fn latin(letter: char) -> char {
    match letter {
        'Н' | 'н' => {
            if letter == 'Н' {
                'H'
            } else {
                'h'
            }
        }
        'К' => 'K',
        'к' => 'k',
        'е' => 'e',
        'Е' => 'E',
        'с' => 'c',
        'С' => 'C',
        'р' => 'p',
        'Р' => 'P',
        'х' => 'x',
        'Х' => 'X',
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grades_and_fields_are_read() {
        for (text, side, grade) in [
            ("6", Side::Outer, Ok(6)),
            ("IT14", Side::Inner, Ok(14)),
            ("h6", Side::Outer, Ok(6)),
            ("к6", Side::Outer, Ok(6)),
            ("js12", Side::Outer, Ok(12)),
            ("Н7", Side::Inner, Ok(7)),
            ("H7", Side::Outer, Err("field-of-the-other-side")),
            ("g6", Side::Inner, Err("field-of-the-other-side")),
            ("h19", Side::Outer, Err("bad-grade")),
            ("0", Side::Outer, Err("bad-grade")),
            ("fine", Side::Outer, Err("bad-grade")),
            ("abc6", Side::Outer, Err("bad-grade")),
            ("", Side::Outer, Err("bad-grade")),
        ] {
            let field = read(text, side).ok().and_then(|(_, field)| field);
            assert_eq!(field.is_some(), grade.is_ok() && !text.starts_with(['6', 'I']), "{text}");
            assert_eq!(read(text, side).map(|(grade, _)| grade.number()), grade, "{text}");
        }
    }
}
