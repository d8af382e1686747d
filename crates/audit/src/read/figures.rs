//! Numbers with their printed places.

use crate::knowledge::yaml::{Fields, Node};

use super::Reader;
use crate::audit::quantity::Quantity;
use crate::audit::stated::{Figure, Figures};
use crate::audit::tolerance::Range;
use technolog_core::lang::Lang;
use technolog_core::words::quantity_noun;

/// The most that a figure of a plan can be, in its unit: beyond it no sum is exact.
const MOST: f64 = 1e9;

impl Reader<'_> {
    /// The fields of those keys that are figures.
    pub(super) fn figures(&mut self, fields: &mut Fields<'_>, keys: &[&str]) -> Figures {
        self.figures_under("", fields, keys)
    }

    /// The same where the keys of the quantities have a prefix: `card.`.
    pub(super) fn figures_under(&mut self, prefix: &str, fields: &mut Fields<'_>, keys: &[&str]) -> Figures {
        let mut figures = Figures::new();
        for key in keys {
            let Some(quantity) = Quantity::of_key(&format!("{prefix}{key}")) else { continue };
            let Some(node) = fields.take(key) else { continue };
            // The clamping calls its force as the conditions call theirs; both are in one range.
            figures
                .extend(self.figure(node).and_then(|figure| self.possible(quantity, figure)).map(|it| (quantity, it)));
        }
        figures
    }

    /// A figure that its quantity can have, by the table `audit-tolerance`.
    fn possible(&mut self, quantity: Quantity, figure: Figure) -> Option<Figure> {
        let (name, text) = (quantity_noun(quantity, Lang::EN), &figure.text);
        let range = self.tolerances.range(quantity);
        let (message, help) = if !range.holds(figure.value) && figure.value < 0.0 {
            let must = if range == Range::Positive { "it must be above zero" } else { "it must not be below zero" };
            (
                format!("`{text}` cannot be the {name}: {must}"),
                "write it without a sign: only corrections may be negative",
            )
        } else if !range.holds(figure.value) {
            let must = "it must be above zero";
            (format!("`{text}` cannot be the {name}: {must}"), "leave out what is not known")
        } else if self.tolerances.whole(quantity) && libm::trunc(figure.value) != figure.value {
            let must = "it must be a whole number";
            (format!("`{text}` cannot be the {name}: {must}"), "write it without decimals")
        } else {
            return Some(figure);
        };
        self.problems.error_help("out-of-range", message, &figure.place, help)
    }

    /// One number.
    pub(super) fn figure(&mut self, node: &Node) -> Option<Figure> {
        let text = self.problems.text(node)?.trim().to_owned();
        let figure = number(&text).map(|(value, last_place)| Figure {
            value,
            text: text.clone(),
            last_place,
            place: node.place.clone(),
        });
        figure.filter(|figure| figure.value.abs() <= MOST).or_else(|| {
            let help = if text.contains(',') {
                "write the decimal point of a number, not a comma"
            } else if text.chars().any(|letter| letter.is_numeric() && !letter.is_ascii_digit()) {
                "write it with the digits 0 to 9: these are other characters that look like them"
            } else {
                "write a number without its unit"
            };
            self.problems.error_help("bad-value", format!("`{text}` is no number"), &node.place, help)
        })
    }
}

/// A number and what its last printed place is worth.
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
    use super::number;

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
