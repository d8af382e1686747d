//! The field of a fit, as the drawing writes it: `h6`, `f7`, `H7`.

use std::fmt;

use crate::note::{Figure, IntoFigure};
use crate::units::{ItGrade, Micrometres};

use super::Side;

/// A field by its letters and its grade.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// Its letters, capital for a hole.
    pub letters: String,
    /// Its grade.
    pub grade: ItGrade,
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.letters, self.grade.number())
    }
}

impl IntoFigure for &Field {
    fn into_figure(self) -> Figure {
        self.to_string().into_figure()
    }
}

impl Field {
    /// Whether the nominal size, which is what a program makes, lies in it: inside it or at its limit (ISO 286-1).
    ///
    /// Outside k of grades 4 to 7 begins above the nominal size, and of others at it. Inside K ends above it or at it up to
    /// grade 8 and at it from 9 on, M reaches it in grades 7 and 8 above Ø3, and N of grade 9 and coarser ends at it above Ø3.
    pub fn has_nominal(&self, side: Side, size: Micrometres) -> bool {
        let grade = self.grade.number();
        let above_3 = size > Micrometres::from_mm(3);
        match (side, self.letters.as_str()) {
            (Side::Outer, "h" | "js" | "j") | (Side::Inner, "H" | "JS" | "J" | "K") => true,
            (Side::Outer, "k") => !(4..=7).contains(&grade),
            (Side::Inner, "M") => above_3 && matches!(grade, 7 | 8),
            (Side::Inner, "N") => above_3 && grade >= 9,
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Limits of ISO 286-2 for Ø20, µm: f7 −20 to −41, k6 +15 to +2, k8 +33 to 0, F8 +53 to +20, K7 +6 to −15, M7 0 to −21, M6 −4 to −17,
    /// N7 −7 to −28, N9 0 to −52; for Ø3 N9 −4 to −29, M7 −2 to −12.
    #[test]
    fn fields_that_leave_the_nominal_size_out_are_known() {
        for (letters, grade, side, mm, has) in [
            ("h", 6, Side::Outer, 20, true),
            ("js", 6, Side::Outer, 20, true),
            ("j", 6, Side::Outer, 20, true),
            ("f", 7, Side::Outer, 20, false),
            ("g", 6, Side::Outer, 20, false),
            ("x", 8, Side::Outer, 20, false),
            ("d", 9, Side::Outer, 20, false),
            ("e", 8, Side::Outer, 20, false),
            ("k", 6, Side::Outer, 20, false),
            ("k", 8, Side::Outer, 20, true),
            ("m", 6, Side::Outer, 20, false),
            ("H", 7, Side::Inner, 20, true),
            ("JS", 7, Side::Inner, 20, true),
            ("F", 8, Side::Inner, 20, false),
            ("E", 9, Side::Inner, 20, false),
            ("K", 7, Side::Inner, 20, true),
            ("M", 7, Side::Inner, 20, true),
            ("M", 6, Side::Inner, 20, false),
            ("M", 7, Side::Inner, 3, false),
            ("N", 7, Side::Inner, 20, false),
            ("N", 9, Side::Inner, 20, true),
            ("N", 9, Side::Inner, 3, false),
        ] {
            let field = Field { letters: letters.to_owned(), grade: ItGrade::new(grade).unwrap() };
            assert_eq!(field.has_nominal(side, Micrometres::from_mm(mm)), has, "{field} of {mm}");
        }
    }
}
