//! Numbers of programs: figures, parameters and the four arithmetic operations in brackets (LinuxCNC, Fanuc) or after
//! an equals sign (Sinumerik). Functions (SIN, ATAN and others) are not read.

use std::collections::BTreeMap;

/// A number that may depend on parameters.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Expression {
    Number(f64),
    /// `#5`, `#<name>`, `R5`: by its name.
    Parameter(String),
    Minus(Box<Self>),
    Of(char, Box<Self>, Box<Self>),
}

/// Parameters with their values.
pub(super) type Parameters = BTreeMap<String, f64>;

/// The deepest nesting of brackets.
const DEPTH: usize = 20;

impl Expression {
    /// Its value; none where a parameter has none, or for a division by 0.
    pub fn value(&self, parameters: &Parameters) -> Option<f64> {
        let value = match self {
            Self::Number(number) => *number,
            Self::Parameter(name) => *parameters.get(name)?,
            Self::Minus(of) => -of.value(parameters)?,
            Self::Of(sign, a, b) => {
                let (a, b) = (a.value(parameters)?, b.value(parameters)?);
                match sign {
                    '+' => a + b,
                    '-' => a - b,
                    '*' => a * b,
                    _ => a / b,
                }
            }
        };
        value.is_finite().then_some(value)
    }
}

/// A reader of expressions over the characters of a line.
pub(super) struct Reader<'a> {
    characters: &'a [(usize, char)],
    pub at: usize,
    /// Whether `R5` is a parameter, as with Sinumerik.
    pub r_parameters: bool,
}

impl<'a> Reader<'a> {
    pub const fn new(characters: &'a [(usize, char)], at: usize, r_parameters: bool) -> Self {
        Self { characters, at, r_parameters }
    }

    fn peek(&self) -> Option<char> {
        self.characters.get(self.at).map(|(_, c)| *c)
    }

    fn next_is(&mut self, wanted: char) -> bool {
        let is = self.peek() == Some(wanted);
        self.at += usize::from(is);
        is
    }

    /// A sum. `open` is the bracket that began it, if any.
    pub fn sum(&mut self, depth: usize) -> Option<Expression> {
        let mut left = self.product(depth)?;
        while let Some(sign @ ('+' | '-')) = self.peek() {
            self.at += 1;
            left = Expression::Of(sign, Box::new(left), Box::new(self.product(depth)?));
        }
        Some(left)
    }

    fn product(&mut self, depth: usize) -> Option<Expression> {
        let mut left = self.operand(depth)?;
        while let Some(sign @ ('*' | '/')) = self.peek() {
            self.at += 1;
            left = Expression::Of(sign, Box::new(left), Box::new(self.operand(depth)?));
        }
        Some(left)
    }

    /// A number, a parameter, or a sum in brackets, with its sign.
    pub fn operand(&mut self, depth: usize) -> Option<Expression> {
        if depth >= DEPTH {
            return None;
        }
        match self.peek()? {
            '-' => {
                self.at += 1;
                Some(Expression::Minus(Box::new(self.operand(depth + 1)?)))
            }
            '+' => {
                self.at += 1;
                self.operand(depth + 1)
            }
            open @ ('[' | '(') => {
                self.at += 1;
                let inner = self.sum(depth + 1)?;
                self.next_is(if open == '[' { ']' } else { ')' }).then_some(inner)
            }
            '#' => {
                self.at += 1;
                self.parameter("#").map(Expression::Parameter)
            }
            'R' if self.r_parameters => {
                self.at += 1;
                self.parameter("R").map(Expression::Parameter)
            }
            _ => self.number().map(Expression::Number),
        }
    }

    /// The name of a parameter after its sign.
    pub fn parameter(&mut self, sign: &str) -> Option<String> {
        let mut name = sign.to_owned();
        if self.next_is('<') {
            while let Some(c) = self.peek().filter(|c| *c != '>') {
                name.push(c);
                self.at += 1;
            }
            return self.next_is('>').then_some(name);
        }
        while let Some(c) = self.peek().filter(char::is_ascii_digit) {
            name.push(c);
            self.at += 1;
        }
        (name.len() > sign.len()).then_some(name)
    }

    fn number(&mut self) -> Option<f64> {
        let from = self.at;
        let mut point = false;
        while let Some(c) = self.peek() {
            match c {
                '.' if !point => point = true,
                c if c.is_ascii_digit() => {}
                _ => break,
            }
            self.at += 1;
        }
        let text: String = self.characters.get(from..self.at)?.iter().map(|(_, c)| *c).collect();
        // At most nine digits before the point, so that sums stay exact to a micrometre.
        let whole = text.split('.').next().unwrap_or_default();
        (whole.trim_start_matches('0').len() <= 9).then(|| text.parse().ok()).flatten()
    }
}
