//! The one small language of cells: unary tests such as `<= 15`, `(15..30]`, `through | blind`, `not(cast)`.

use crate::column::Column;
use crate::set::Set;
use technolog_note::{Note, note};

/// A cell that is no valid test: the fault, and its characters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TestError {
    /// What is wrong.
    pub message: Note,
    /// First wrong character, counted from the start of the cell.
    pub offset: usize,
    /// Number of wrong characters.
    pub width: usize,
}

/// Reads a unary test of a column as the set of ranks it matches.
///
/// | cell | matches |
/// |---|---|
/// | `-` | anything |
/// | `7`, `Ra 2.5`, `solid` | that value |
/// | `<= 15`, `< 15`, `>= 13`, `> 30` | by order |
/// | `(15..30]` | interval, ends explicit |
/// | <code>a &#124; b</code> | either |
/// | `not(a)` | anything of the domain but |
///
/// # Errors
/// What is wrong, with its place in the cell.
pub fn parse_test(text: &str, column: &Column) -> Result<Set, TestError> {
    let parser = TestParser { column };
    parser.alternatives(text, 0)
}

struct TestParser<'c> {
    column: &'c Column,
}

impl TestParser<'_> {
    fn alternatives(&self, text: &str, offset: usize) -> Result<Set, TestError> {
        let mut whole = Set::empty();
        let mut at = offset;
        for part in split_outside_parentheses(text) {
            whole = whole.union(&self.single(part, at)?);
            at += part.chars().count() + 1;
        }
        Ok(whole)
    }

    fn single(&self, text: &str, offset: usize) -> Result<Set, TestError> {
        let lead = text.chars().take_while(|c| c.is_whitespace()).count();
        let (trimmed, at) = (text.trim(), offset + lead);
        let error = |message: Note| TestError { message, offset: at, width: trimmed.chars().count().max(1) };
        if trimmed == "-" {
            return Ok(self.column.allowed());
        }
        if let Some(inner) = trimmed.strip_prefix("not(").and_then(|rest| rest.strip_suffix(')')) {
            return Ok(self.column.allowed().difference(&self.alternatives(inner, at + 4)?));
        }
        for (sign, low_open, high_open) in
            [("<=", None, Some(false)), (">=", Some(false), None), ("<", None, Some(true)), (">", Some(true), None)]
        {
            if let Some(bound) = trimmed.strip_prefix(sign) {
                let rank = self.value(bound, at + sign.len())?;
                let low = low_open.map_or(i64::MIN, |open| rank + i64::from(open));
                let high = high_open.map_or(i64::MAX, |open| rank - i64::from(open));
                return Ok(Set::interval(low, high));
            }
        }
        if trimmed.starts_with(['(', '[']) {
            return self.interval(trimmed, at);
        }
        if trimmed.contains("..") {
            return Err(error(note!("table-say-whether-ends-belong", range = trimmed)));
        }
        if trimmed.is_empty() {
            return Err(error(note!("table-empty-test-write-for-anything")));
        }
        self.value(trimmed, at).map(Set::point)
    }

    fn interval(&self, text: &str, at: usize) -> Result<Set, TestError> {
        let error = |message: Note| TestError { message, offset: at, width: text.chars().count() };
        let low_open = text.starts_with('(');
        let high_open = text.ends_with(')');
        if !text.ends_with([')', ']']) {
            return Err(error(note!("table-interval-closed-by", text = text)));
        }
        let inner = &text[1..text.len() - 1];
        let Some((low, high)) = inner.split_once("..") else {
            return Err(error(note!("table-interval-written-low-high", text = text)));
        };
        let low_rank = if low.trim().is_empty() { i64::MIN } else { self.value(low, at + 1)? + i64::from(low_open) };
        let high_rank = if high.trim().is_empty() {
            i64::MAX
        } else {
            self.value(high, at + 3 + low.chars().count())? - i64::from(high_open)
        };
        if low_rank > high_rank {
            return Err(error(note!("table-holds-nothing-ends-crossed", text = text)));
        }
        Ok(Set::interval(low_rank, high_rank))
    }

    /// The rank of a value inside a test.
    fn value(&self, text: &str, offset: usize) -> Result<i64, TestError> {
        let lead = text.chars().take_while(|c| c.is_whitespace()).count();
        let trimmed = text.trim();
        let error = |message: Note| TestError { message, offset: offset + lead, width: trimmed.chars().count().max(1) };
        let value = self.column.parse_value(trimmed).map_err(error)?;
        self.column.rank(&value).ok_or_else(|| TestError {
            message: note!("table-column-type-cannot-tested", kind = self.column.ty.name()),
            offset: offset + lead,
            width: trimmed.chars().count().max(1),
        })
    }
}

/// Splits at `|` where no parenthesis is open.
fn split_outside_parentheses(text: &str) -> Vec<&str> {
    let mut parts = Vec::new();
    let (mut depth, mut start) = (0_i32, 0);
    for (index, c) in text.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            '|' if depth == 0 => {
                parts.push(&text[start..index]);
                start = index + 1;
            }
            _ => {}
        }
    }
    parts.push(&text[start..]);
    parts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::column::{ColumnRole, ColumnType};
    use crate::units::Unit;

    fn column(ty: ColumnType, values: &[&str]) -> Column {
        Column {
            name: "c".into(),
            ty,
            unit: ty.default_unit().unwrap_or(Unit::Millimetre),
            symbol: None,
            label: None,
            role: ColumnRole::Input,
            list: false,
            optional: false,
            values: values.iter().map(|&v| v.to_owned()).collect(),
            domain: None,
            domain_text: None,
            default: None,
            refers: None,
            names: Vec::new(),
            vocabulary: None,
            place: None,
        }
    }

    #[test]
    fn interval_ends_are_exact() {
        let diameter = column(ColumnType::Length, &[]);
        let set = parse_test("(15..30]", &diameter).unwrap();
        assert!(!set.contains(15_000) && set.contains(15_001) && set.contains(30_000) && !set.contains(30_001));
        assert!(parse_test("> 30", &diameter).unwrap().contains(30_001));
        assert!(!parse_test("< 30", &diameter).unwrap().contains(30_000));
    }

    #[test]
    fn values_alternatives_and_exclusion() {
        let state = column(ColumnType::Enum, &["solid", "cast", "pre-machined"]);
        assert_eq!(parse_test("solid | cast", &state).unwrap(), Set::interval(0, 1));
        assert_eq!(parse_test("not(cast)", &state).unwrap(), Set::from_intervals(vec![(0, 0), (2, 2)]));
        assert_eq!(parse_test("-", &state).unwrap(), Set::interval(0, 2));
        let column = column(ColumnType::It, &[]);
        assert_eq!(parse_test("[7..8] | 10", &column).unwrap(), Set::from_intervals(vec![(7, 8), (10, 10)]));
    }

    #[test]
    fn a_typo_is_shown_where_it_stands() {
        let diameter = column(ColumnType::Length, &[]);
        let error = parse_test("(0..1O]", &diameter).unwrap_err();
        assert_eq!((error.offset, error.width), (4, 2));
        assert!(technolog_words::Lang::EN.say(&error.message).contains("zero may be meant"), "{}", error.message);
        for bad in ["(30..15]", "15..30", "(1..2", "", "<=", "10 cm"] {
            assert!(parse_test(bad, &diameter).is_err(), "{bad}");
        }
    }
}
