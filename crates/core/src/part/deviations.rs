//! The limits of a tolerance field, `f7` or `P7`, from the nominal size (ISO 286-1).

use std::fmt;
use std::ops::RangeInclusive;

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, QueryError};
use crate::tables::rules::{FieldBegins, FieldPositionFor};
use crate::tables::standards::{FundamentalDeviationFor, ItGradesFor};
use crate::units::{ItGrade, Micrometres};

/// How far the limits of a size lie from its nominal value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Deviations {
    /// To the largest size.
    pub upper: Micrometres,
    /// To the smallest size.
    pub lower: Micrometres,
}

/// As drawings have them: each with its sign, zero without, the upper one first.
impl fmt::Display for Deviations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = |deviation: Micrometres| if deviation > Micrometres::ZERO { "+" } else { "" };
        let Self { upper, lower } = *self;
        write!(f, "{}{upper}/{}{lower}", sign(upper), sign(lower))
    }
}

impl Deviations {
    /// The width between the limits.
    pub fn width(self) -> Micrometres {
        self.upper - self.lower
    }

    /// The middle between the limits, doubled.
    pub fn twice_middle(self) -> Micrometres {
        self.upper + self.lower
    }

    /// The coarsest grade of some whose tolerance is within the limits, at a size.
    ///
    /// # Errors
    /// The size is outside the table of tolerances, or the knowledge base is broken.
    pub fn grade_among(
        self,
        grades: RangeInclusive<u8>,
        size: Micrometres,
        knowledge: &Knowledge,
    ) -> Result<Option<ItGrade>, KnowledgeError> {
        for it in grades.rev().filter_map(ItGrade::new) {
            let tolerance = knowledge.ask(&ItGradesFor { it, diameter: size })?.need("it")?.tolerance;
            // JS of an odd width may be rounded down to whole micrometres on each side (ISO 286-1), and remains of its grade.
            let js = self.upper == -self.lower && self.upper == tolerance.half();
            if js || tolerance <= self.width() {
                return Ok(Some(it));
            }
        }
        Ok(None)
    }

    /// The coarsest grade of the tables that is within the limits, at a size; the finest if all are wider.
    ///
    /// # Errors
    /// The knowledge base is broken.
    pub fn grade(self, size: Micrometres, knowledge: &Knowledge) -> Result<Option<ItGrade>, KnowledgeError> {
        if size <= Micrometres::ZERO || size > LARGEST {
            return Ok(None);
        }
        Ok(self.grade_among(FINEST..=COARSEST, size, knowledge)?.or(ItGrade::new(FINEST)))
    }

    /// The deviations of a field by its letters and grade; none where the tables do not tell them. The half of an odd
    /// tolerance of js and JS is exact: ±10.5 for 30JS7, which tables print as ±10 (ISO 286-1 allows it).
    ///
    /// Shafts: es, ei = es - IT or ei, es = ei + IT; holes are their mirror image, K, M, N up to IT8 and P to ZC up to IT7
    /// with Δ = IT(n) - IT(n-1) added.
    ///
    /// # Errors
    /// The knowledge base is broken.
    pub fn of_field(
        letters: &str,
        grade: ItGrade,
        size: Micrometres,
        knowledge: &Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        if !(FINEST..=COARSEST).contains(&grade.number()) || size <= Micrometres::ZERO || size > LARGEST {
            return Ok(None);
        }
        let position = match knowledge.ask(&FieldPositionFor { letters, grade, diameter: size }) {
            // Letters that no field has.
            Err(KnowledgeError::Query(QueryError::IllTyped { .. })) => return Ok(None),
            answer => answer?.winner()?,
        };
        let Some(position) = position else { return Ok(None) };
        let width =
            |it| Ok::<_, KnowledgeError>(knowledge.ask(&ItGradesFor { it, diameter: size })?.need("it")?.tolerance);
        let tolerance = width(grade)?;
        if position.begins == FieldBegins::About {
            return Ok(Some(Self { upper: tolerance.exact_half(), lower: -tolerance.exact_half() }));
        }
        let shaft = FundamentalDeviationFor { letters: position.of, grade, diameter: size };
        let shaft = knowledge.ask(&shaft)?.need(position.of)?.deviation;
        let delta = match ItGrade::new(grade.number() - 1).filter(|_| position.delta) {
            Some(finer) if finer.number() >= FINEST => tolerance - width(finer)?,
            Some(_) => return Ok(None),
            None => Micrometres::ZERO,
        };
        let is_hole = letters.starts_with(|first: char| first.is_ascii_uppercase());
        let nearest = if is_hole { -shaft + delta } else { shaft };
        Ok(Some(match position.begins {
            FieldBegins::Lower => Self { upper: nearest + tolerance, lower: nearest },
            FieldBegins::Upper | FieldBegins::About => Self { upper: nearest, lower: nearest - tolerance },
        }))
    }
}

/// The range of the table of tolerances.
const FINEST: u8 = 5;
const COARSEST: u8 = 14;
const LARGEST: Micrometres = Micrometres::from_mm(500);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shipped;

    /// IT8 of 20 is 33: js8 is ±16.5, which ISO 286-1 lets be ±16, and finer than that is js7, ±10. IT6 and IT7 of 40: 16, 25.
    #[test]
    fn limits_of_js_are_of_its_grade() {
        let knowledge = shipped::knowledge().unwrap();
        for (upper, lower, size, grade) in [
            (16, -16, 20, 8),
            (15, -15, 20, 7),
            (32, 0, 20, 7),
            (33, 0, 20, 8),
            (8, -8, 40, 6),
            (12, -12, 40, 7),
            (1, -1, 40, FINEST),
        ] {
            let limits = Deviations { upper: Micrometres::new(upper), lower: Micrometres::new(lower) };
            let found = limits.grade(Micrometres::from_mm(size), &knowledge).unwrap();
            assert_eq!(found, ItGrade::new(grade), "{size} {limits}");
        }
        let limits = Deviations { upper: Micrometres::new(16), lower: Micrometres::ZERO };
        assert_eq!(limits.to_string(), "+0.016/0");
    }
}
