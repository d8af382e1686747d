//! Numbers with their printed places.

use crate::knowledge::form::Form;
use crate::knowledge::yaml::{Fields, Node};
use crate::note::Severity;
use technolog_note::note;

use super::Reader;
use crate::audit::finding::Section;
use crate::audit::quantity::Quantity;
use crate::audit::stated::{Figures, Remark, StatedFigure};
use crate::audit::tolerance::Range;

/// The largest figure of a plan, in its unit: above it sums are not exact.
pub(crate) const MOST: f64 = 1e9;

impl Reader<'_> {
    /// The fields not yet taken that are figures.
    pub(super) fn figures<F: Form>(&mut self, section: Section, fields: &mut Fields<'_, F>) -> Figures {
        self.figures_under(section, "", fields)
    }

    /// The same where the keys of the quantities have a prefix: `card.`.
    pub(super) fn figures_under<F: Form>(
        &mut self,
        section: Section,
        prefix: &str,
        fields: &mut Fields<'_, F>,
    ) -> Figures {
        let mut figures = Figures::new();
        for key in F::KEYS {
            let Some(quantity) = Quantity::of_key(&format!("{prefix}{}", key.name())) else { continue };
            let Some(node) = fields.take_once(*key) else { continue };
            // Clamping and conditions both have a force; both are in one range of quantities.
            let figure = self.figure(node).and_then(|figure| self.possible(section, quantity, figure));
            figures.extend(figure.map(|it| (quantity, it)));
        }
        figures
    }

    /// A figure within the range of its quantity, by the table `audit-tolerance`. One that there cannot be is a slip of the author: a sign
    /// too much is left out, of anything else nothing is computed.
    fn possible(&mut self, section: Section, quantity: Quantity, figure: StatedFigure) -> Option<StatedFigure> {
        let range = self.tolerances.range(quantity);
        let is_whole = |value: f64| !self.tolerances.is_whole_number(quantity) || libm::trunc(value) == value;
        if range.holds(figure.value) && is_whole(figure.value) {
            return Some(figure);
        }
        let must = if range.holds(figure.value) {
            note!("planfile-must-whole-number")
        } else if range == Range::Positive {
            note!("planfile-must-above-zero")
        } else {
            note!("planfile-must-below-zero")
        };
        let name = technolog_note::Figure::word_of("quantity", quantity.key().replace('.', "-"));
        let note = note!("audit-impossible", text = figure.text, name = name, must = must);
        let figure_of = Some((quantity, figure.text.clone()));
        let place = figure.place.clone();
        self.remarks.push(Remark {
            place,
            note,
            severity: Severity::Wrong,
            section,
            figure: figure_of,
            unless_proven: false,
        });
        let (value, text) = (-figure.value, figure.text.trim_start_matches(['-', '−']).to_owned());
        (range.holds(value) && is_whole(value)).then_some(StatedFigure { value, text, ..figure })
    }

    /// One number.
    pub(super) fn figure(&mut self, node: &Node) -> Option<StatedFigure> {
        let text = with_point(self.problems.text(node)?.trim());
        let figure = number(&text).map(|(value, last_place)| StatedFigure {
            value,
            text: text.clone(),
            last_place,
            place: node.place.clone(),
        });
        figure.filter(|figure| figure.value.abs() <= MOST).or_else(|| {
            let help = if text.contains(',') {
                note!("yaml-write-decimal-point-number-comma")
            } else if text.chars().any(|letter| letter.is_numeric() && !letter.is_ascii_digit()) {
                note!("planfile-write-with-digits-these-other")
            } else {
                note!("planfile-write-number-without-unit")
            };
            self.problems.error_help("bad-value", note!("case-number", text = text), &node.place, help)
        })
    }
}

/// A figure as people write it with a decimal comma: `26,5` is 26.5. Two commas, or a comma and a point, are something else.
fn with_point(text: &str) -> String {
    let single = text.matches(',').count() == 1 && !text.contains('.');
    if single { text.replacen(',', ".", 1) } else { text.to_owned() }
}

/// A number and the value of one unit in its last printed place.
pub(crate) fn number(text: &str) -> Option<(f64, f64)> {
    let digits = text.strip_prefix(['-', '+', '−']).unwrap_or(text);
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    let plain = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    if whole.is_empty() || !plain(whole) || !plain(part) || digits.ends_with('.') || digits.len() > 18 {
        return None;
    }
    let value: f64 = digits.parse().ok()?;
    let sign = if text.starts_with(['-', '−']) { -1.0 } else { 1.0 };
    let places = i32::try_from(part.len()).ok()?;
    Some((sign * value, libm::pow(10.0, f64::from(-places))))
}

#[cfg(test)]
mod tests {
    use super::{number, with_point};

    #[test]
    fn a_comma_is_a_decimal_point_where_nothing_else_is_possible() {
        for (text, read) in
            [("26,5", "26.5"), ("-0,195", "-0.195"), ("1.234,5", "1.234,5"), ("1,2,3", "1,2,3"), ("7", "7")]
        {
            assert_eq!(with_point(text), read);
        }
    }

    #[test]
    fn a_number_knows_its_last_place() {
        for (text, value, last) in [("26.52", 26.52, 0.01), ("-50", -50.0, 1.0), ("0.190", 0.19, 0.001)] {
            let (read, place) = number(text).unwrap();
            assert!((read - value).abs() < 1e-12 && (place - last).abs() < 1e-12, "{text}: {read} {place}");
        }
        for text in ["", "-", "1,5", "1e5", "5.", "2 мм", "nan"] {
            assert!(number(text).is_none(), "{text}");
        }
    }
}
