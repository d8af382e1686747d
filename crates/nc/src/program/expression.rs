//! Numbers of programs: figures, parameters and the four arithmetic operations in brackets (LinuxCNC, Fanuc) or after
//! an equals sign (Sinumerik). Functions (SIN, ATAN and others), powers, remainders and comparisons are read for mills
//! only.

use std::collections::BTreeMap;

/// A number that may depend on parameters.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Expression {
    Number(f64),
    /// `#5`, `#<name>`, `R5`: by its name.
    Parameter(String),
    /// `#[…]`, `##2`: the parameter whose number that is.
    Indirect(Box<Self>),
    Minus(Box<Self>),
    /// `^` is `**`, `%` is `MOD`.
    Of(char, Box<Self>, Box<Self>),
    /// `a LT b`, `a AND b`: 1 or 0.
    Whether(Relation, Box<Self>, Box<Self>),
    /// `EXISTS[#<name>]`: 1 or 0.
    Exists(String),
    Function(Function, Box<Self>),
    /// `ATAN[a]/[b]`, degrees.
    Atan(Box<Self>, Box<Self>),
}

/// A function of one number; angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Function {
    Abs,
    Acos,
    Asin,
    Cos,
    Exp,
    /// Down to a whole number.
    Fix,
    /// Up to a whole number.
    Fup,
    Ln,
    Round,
    Sin,
    Sqrt,
    Tan,
}

impl Function {
    const NAMES: [(&'static str, Self); 12] = [
        ("ABS", Self::Abs),
        ("ACOS", Self::Acos),
        ("ASIN", Self::Asin),
        ("COS", Self::Cos),
        ("EXP", Self::Exp),
        ("FIX", Self::Fix),
        ("FUP", Self::Fup),
        ("LN", Self::Ln),
        ("ROUND", Self::Round),
        ("SIN", Self::Sin),
        ("SQRT", Self::Sqrt),
        ("TAN", Self::Tan),
    ];

    fn of(self, value: f64) -> f64 {
        let angle = value.to_radians();
        match self {
            Self::Abs => value.abs(),
            Self::Acos => libm::acos(value).to_degrees(),
            Self::Asin => libm::asin(value).to_degrees(),
            Self::Cos => libm::cos(angle),
            Self::Exp => libm::exp(value),
            Self::Fix => libm::floor(value),
            Self::Fup => libm::ceil(value),
            Self::Ln => libm::log(value),
            Self::Round => libm::round(value),
            Self::Sin => libm::sin(angle),
            Self::Sqrt => libm::sqrt(value),
            Self::Tan => libm::tan(angle),
        }
    }
}

/// What may hold between two numbers, and between what holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Relation {
    Equal,
    NotEqual,
    Greater,
    GreaterEqual,
    Less,
    LessEqual,
    And,
    Or,
    Xor,
}

impl Relation {
    const COMPARISONS: [(&'static str, Self); 6] = [
        ("EQ", Self::Equal),
        ("NE", Self::NotEqual),
        ("GT", Self::Greater),
        ("GE", Self::GreaterEqual),
        ("LT", Self::Less),
        ("LE", Self::LessEqual),
    ];
    const LOGICAL: [(&'static str, Self); 3] = [("AND", Self::And), ("OR", Self::Or), ("XOR", Self::Xor)];

    /// LinuxCNC takes numbers for equal that differ by less than 0.0001 (`TOLERANCE_EQUAL` of `interp_internal.hh`).
    fn holds(self, a: f64, b: f64) -> bool {
        let equal = (a - b).abs() < 0.0001;
        match self {
            Self::Equal => equal,
            Self::NotEqual => !equal,
            Self::Greater => a > b,
            Self::GreaterEqual => a >= b,
            Self::Less => a < b,
            Self::LessEqual => a <= b,
            Self::And => a != 0.0 && b != 0.0,
            Self::Or => a != 0.0 || b != 0.0,
            Self::Xor => (a != 0.0) != (b != 0.0),
        }
    }
}

/// Where the values of parameters are looked up.
pub(super) trait Lookup {
    /// The value of a parameter by its name, `#5`; none where it is not known.
    fn value_of(&self, name: &str) -> Option<f64>;
}

/// Parameters with their values.
pub(super) type Parameters = BTreeMap<String, f64>;

impl Lookup for Parameters {
    fn value_of(&self, name: &str) -> Option<f64> {
        self.get(name).copied()
    }
}

/// The deepest nesting of brackets.
const DEPTH: usize = 20;

/// The most operations of one number: many more than stand in a line of any control.
pub const MOST_OPERATIONS: usize = 200;

impl Expression {
    /// A number that could not be read: it has no value.
    pub const fn unread() -> Self {
        Self::Parameter(String::new())
    }

    /// Its value; none where a parameter has none, or for a division by 0.
    pub fn value(&self, parameters: &impl Lookup) -> Option<f64> {
        let value = match self {
            Self::Number(number) => *number,
            Self::Parameter(name) => parameters.value_of(name)?,
            Self::Indirect(number) => parameters.value_of(&format!("#{}", libm::round(number.value(parameters)?)))?,
            Self::Minus(of) => -of.value(parameters)?,
            Self::Function(function, of) => function.of(of.value(parameters)?),
            Self::Atan(a, b) => libm::atan2(a.value(parameters)?, b.value(parameters)?).to_degrees(),
            Self::Of(sign, a, b) => {
                let (a, b) = (a.value(parameters)?, b.value(parameters)?);
                match sign {
                    '+' => a + b,
                    '-' => a - b,
                    '*' => a * b,
                    '^' => libm::pow(a, b),
                    '%' => a - b * libm::floor(a / b),
                    _ => a / b,
                }
            }
            Self::Whether(relation, a, b) => {
                f64::from(u8::from(relation.holds(a.value(parameters)?, b.value(parameters)?)))
            }
            Self::Exists(name) => f64::from(u8::from(parameters.value_of(name).is_some())),
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
    /// Whether functions, powers, remainders and `#[…]` are read.
    pub functions: bool,
    operations: usize,
}

impl<'a> Reader<'a> {
    pub const fn new(characters: &'a [(usize, char)], at: usize, r_parameters: bool) -> Self {
        Self { characters, at, r_parameters, functions: false, operations: 0 }
    }

    fn peek(&self) -> Option<char> {
        self.characters.get(self.at).map(|(_, c)| *c)
    }

    fn next_is(&mut self, wanted: char) -> bool {
        let is = self.peek() == Some(wanted);
        self.at += usize::from(is);
        is
    }

    /// What stands in brackets: sums, compared and joined by AND, OR and XOR, which bind less than comparisons.
    fn logical(&mut self, depth: usize) -> Option<Expression> {
        let mut left = self.comparison(depth)?;
        while let Some(relation) = self.relation(&Relation::LOGICAL) {
            left = Expression::Whether(relation, Box::new(left), Box::new(self.comparison(depth)?));
        }
        Some(left)
    }

    fn comparison(&mut self, depth: usize) -> Option<Expression> {
        let mut left = self.sum(depth)?;
        while let Some(relation) = self.relation(&Relation::COMPARISONS) {
            left = Expression::Whether(relation, Box::new(left), Box::new(self.sum(depth)?));
        }
        Some(left)
    }

    fn relation(&mut self, known: &[(&str, Relation)]) -> Option<Relation> {
        if !self.functions {
            return None;
        }
        known.iter().find(|(word, _)| self.next_word(word)).map(|(_, relation)| *relation)
    }

    /// An operation with two sides; none beyond the most of a number.
    fn of(&mut self, sign: char, left: Expression, right: Expression) -> Option<Expression> {
        self.operations += 1;
        (self.operations <= MOST_OPERATIONS).then(|| Expression::Of(sign, Box::new(left), Box::new(right)))
    }

    /// A sum; `depth` counts the brackets around it.
    pub fn sum(&mut self, depth: usize) -> Option<Expression> {
        let mut left = self.product(depth)?;
        while let Some(sign @ ('+' | '-')) = self.peek() {
            self.at += 1;
            let right = self.product(depth)?;
            left = self.of(sign, left, right)?;
        }
        Some(left)
    }

    /// Whether a word of letters follows; it is passed.
    fn next_word(&mut self, word: &str) -> bool {
        let is = word
            .chars()
            .enumerate()
            .all(|(index, c)| self.characters.get(self.at + index).is_some_and(|(_, written)| *written == c));
        self.at += if is { word.len() } else { 0 };
        is
    }

    fn product(&mut self, depth: usize) -> Option<Expression> {
        let mut left = self.power(depth)?;
        loop {
            let sign = match self.peek() {
                Some(sign @ ('*' | '/')) => {
                    self.at += 1;
                    sign
                }
                _ if self.functions && self.next_word("MOD") => '%',
                _ => return Some(left),
            };
            let right = self.power(depth)?;
            left = self.of(sign, left, right)?;
        }
    }

    fn power(&mut self, depth: usize) -> Option<Expression> {
        let mut left = self.operand(depth)?;
        while self.functions && self.next_word("**") {
            let right = self.operand(depth)?;
            left = self.of('^', left, right)?;
        }
        Some(left)
    }

    /// `SIN[30]`, `ATAN[1]/[2]`.
    fn function(&mut self, depth: usize) -> Option<Expression> {
        if self.next_word("ATAN") {
            let above = self.bracket(depth)?;
            let below = if self.next_is('/') { self.bracket(depth)? } else { return None };
            return Some(Expression::Atan(Box::new(above), Box::new(below)));
        }
        if self.next_word("EXISTS") {
            let named = self.next_is('[') && self.next_is('#');
            let name = if named { self.parameter("#")? } else { return None };
            return self.next_is(']').then_some(Expression::Exists(name));
        }
        let named = Function::NAMES.iter().find(|(name, _)| self.next_word(name))?.1;
        Some(Expression::Function(named, Box::new(self.bracket(depth)?)))
    }

    fn bracket(&mut self, depth: usize) -> Option<Expression> {
        let inner = if self.next_is('[') { self.logical(depth + 1)? } else { return None };
        self.next_is(']').then_some(inner)
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
                let inner = self.logical(depth + 1)?;
                self.next_is(if open == '[' { ']' } else { ')' }).then_some(inner)
            }
            '#' => {
                self.at += 1;
                if self.functions && matches!(self.peek(), Some('#' | '[')) {
                    return Some(Expression::Indirect(Box::new(self.operand(depth + 1)?)));
                }
                self.parameter("#").map(Expression::Parameter)
            }
            c if self.functions && c.is_ascii_alphabetic() => self.function(depth),
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
