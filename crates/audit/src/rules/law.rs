//! A formula stated once: the text that is shown with its figures is also what computes them.
//!
//! ```text
//! sum = product (('+' | '−') product)*    product = power (('·' | '/') power)*    power = part ('^' part)?
//! part = number | '{' place of an input '}' | '(' sum ')'
//! ```

/// A step of a law, the operands before their sign.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Step {
    Number(f64),
    Input(usize),
    Sign(char),
}

/// A formula that computes.
#[derive(Debug)]
pub(super) struct Law(Vec<Step>);

impl Law {
    /// Reads a formula; none if it is not one.
    pub fn read(text: &str) -> Option<Self> {
        let mut reader = Reader { rest: text, steps: Vec::new() };
        reader.signed(0)?;
        reader.rest.is_empty().then_some(Self(reader.steps))
    }

    /// What comes out of it with these inputs.
    pub fn compute(&self, inputs: &[f64]) -> Option<f64> {
        let mut open: Vec<f64> = Vec::with_capacity(4);
        for step in &self.0 {
            let value = match *step {
                Step::Number(value) => value,
                Step::Input(at) => *inputs.get(at)?,
                Step::Sign(sign) => {
                    let (right, left) = (open.pop()?, open.pop()?);
                    match sign {
                        '+' => left + right,
                        '−' => left - right,
                        '·' => left * right,
                        '/' => left / right,
                        _ => libm::pow(left, right),
                    }
                }
            };
            open.push(value);
        }
        open.pop()
    }
}

/// The signs, those that bind least first.
const SIGNS: [&[char]; 3] = [&['+', '−'], &['·', '/'], &['^']];

/// A formula that is being read.
struct Reader<'t> {
    rest: &'t str,
    steps: Vec<Step>,
}

impl Reader<'_> {
    fn take(&mut self, one: impl Fn(char) -> bool) -> Option<char> {
        let first = self.rest.chars().next().filter(|first| one(*first))?;
        self.rest = &self.rest[first.len_utf8()..];
        Some(first)
    }

    /// Parts with the signs of that rank between them.
    fn signed(&mut self, rank: usize) -> Option<()> {
        let Some(signs) = SIGNS.get(rank) else { return self.part() };
        self.signed(rank + 1)?;
        while let Some(sign) = self.take(|one| signs.contains(&one)) {
            self.signed(rank + 1)?;
            self.steps.push(Step::Sign(sign));
        }
        Some(())
    }

    fn part(&mut self) -> Option<()> {
        if self.take(|one| one == '(').is_some() {
            self.signed(0)?;
            return self.take(|one| one == ')').map(drop);
        }
        let is_input = self.take(|one| one == '{').is_some();
        let digits = self.rest.trim_start_matches(|one: char| one.is_ascii_digit() || one == '.');
        let own = &self.rest[..self.rest.len() - digits.len()];
        let step = if is_input { Step::Input(own.parse().ok()?) } else { Step::Number(own.parse().ok()?) };
        self.rest = digits;
        self.steps.push(step);
        if is_input { self.take(|one| one == '}').map(drop) } else { Some(()) }
    }
}

/// The right side of a formula in symbols, with the places of the inputs for its symbols, in the order in which these
/// first stand there: `1000·{0}/({1}·{2})` of `n = 1000·V/(π·D)`.
pub(super) fn with_places(formula: &str) -> String {
    let right = formula.rsplit('=').next().unwrap_or_default();
    let (mut text, mut symbols, mut symbol) = (String::new(), Vec::new(), String::new());
    for one in right.chars().chain([' ']) {
        if one.is_alphabetic() || !symbol.is_empty() && one.is_ascii_digit() {
            symbol.push(one);
            continue;
        }
        if !symbol.is_empty() {
            let own = std::mem::take(&mut symbol);
            let place = symbols.iter().position(|known| *known == own).unwrap_or(symbols.len());
            if place == symbols.len() {
                symbols.push(own);
            }
            text.push_str(&format!("{{{place}}}"));
        }
        text.extend(Some(one).filter(|one| *one != ' '));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{Law, with_places};

    #[test]
    fn signs_bind_as_in_arithmetic() {
        for (text, value) in [
            ("2+3·4", 14.0),
            ("({0}−{1})/2/{2}", 0.5),
            ("{2}·{0}/{1}", 2.8),
            ("10·{2}^2", 40.0),
            ("{0}−{1}−1", 1.0),
            ("1000·{0}/({1}·{2})", 700.0),
        ] {
            let found = Law::read(text).and_then(|law| law.compute(&[7.0, 5.0, 2.0]));
            assert!(found.is_some_and(|found: f64| (found - value).abs() < 1e-12), "{text}: {found:?}");
        }
    }

    #[test]
    fn what_is_no_formula_is_not_read() {
        for text in ["", "2+", "(2", "2)", "{x}", "max({0}; {1})", "2 3"] {
            assert!(Law::read(text).is_none(), "{text}");
        }
        assert_eq!(Law::read("{3}").and_then(|law| law.compute(&[1.0])), None);
    }

    #[test]
    fn symbols_are_the_inputs_in_their_order() {
        assert_eq!(with_places("n = 1000·V/(π·D)"), "1000·{0}/({1}·{2})");
        assert_eq!(with_places("W = k·P/(f+f2)"), "{0}·{1}/({2}+{3})");
        assert_eq!(with_places("K = Lк − Lет"), "{0}−{1}");
    }
}
