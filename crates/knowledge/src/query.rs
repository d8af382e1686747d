//! Queries of a decision table; the answer contains the reasons.
//!
//! The tests of each input column are compiled once into elementary intervals with one bit per row. A query finds the
//! interval of each input by binary search and intersects the bits. So the matching rows, and for every other row the
//! first column that failed, need only a few machine words. Planning, `lookup` and `explain` use the same call.

use std::fmt;

use std::marker::PhantomData;
use technolog_note::{Note, note};

use crate::column::{Column, ColumnType};
use crate::contract::{Question, TableRow, Which};
use crate::error::KnowledgeError;
use crate::few::Few;
use crate::knowledge::Knowledge;
use crate::set::Set;
use crate::table::{Cell, HitPolicy, RowRef, Table, TableError, TableKind};
use crate::units::{Decimal, ItGrade, Micrometres, Roughness, Unit};
use crate::value::Value;

/// A typed input of a query.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Input<'a> {
    /// One of the values of an enum column.
    Text(&'a str),
    /// Yes or no.
    Bool(bool),
    /// A whole number.
    Int(i64),
    /// A decimal in a unit.
    Number(Decimal, Unit),
    /// A length.
    Length(Micrometres),
    /// A tolerance grade.
    Grade(ItGrade),
    /// A roughness limit.
    Roughness(Roughness),
}

impl Input<'_> {
    fn rank(&self, column: &Column) -> Option<i64> {
        match (column.ty, self) {
            (ColumnType::Enum, Self::Text(text)) => column.rank_of_text(text),
            (ColumnType::Bool, Self::Bool(value)) => Some(i64::from(*value)),
            (ColumnType::Int, Self::Int(value)) => Some(*value),
            (ColumnType::Number | ColumnType::Angle, Self::Number(value, unit)) if *unit == column.unit => {
                Some(value.millionths())
            }
            (ColumnType::Length, Self::Length(value)) => Some(value.micrometres()),
            (ColumnType::It, Self::Grade(value)) => Some(i64::from(value.number())),
            (ColumnType::Roughness, Self::Roughness(value)) => Some(i64::from(value.ra_nanometres())),
            _ => None,
        }
    }
}

impl<'a> From<&'a Value> for Option<Input<'a>> {
    fn from(value: &'a Value) -> Self {
        Some(match value {
            Value::Text(text) => Input::Text(text),
            Value::Bool(value) => Input::Bool(*value),
            Value::Int(value) => Input::Int(*value),
            Value::Number(value, unit) => Input::Number(*value, *unit),
            Value::Length(value) => Input::Length(*value),
            Value::Grade(value) => Input::Grade(*value),
            Value::Roughness(value) => Input::Roughness(*value),
            Value::List(_) => return None,
        })
    }
}

impl fmt::Display for Input<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text(value) => f.write_str(value),
            Self::Bool(value) => value.fmt(f),
            Self::Int(value) => value.fmt(f),
            Self::Number(value, unit) => write!(f, "{value} {unit}"),
            Self::Length(value) => write!(f, "{value} mm"),
            Self::Grade(value) => write!(f, "IT {value}"),
            Self::Roughness(value) => value.fmt(f),
        }
    }
}

/// A query that cannot be answered: the question is wrong, or the table is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum QueryError {
    /// The table is a catalog.
    NotADecision {
        /// The table's id.
        table: String,
    },
    /// The table has no such input.
    UnknownInput {
        /// The table's id.
        table: String,
        /// The name asked.
        name: String,
        /// The right names.
        known: String,
    },
    /// An input without a default is not given.
    Missing {
        /// The table's id.
        table: String,
        /// The input's name.
        name: String,
        /// Its type and unit.
        expected: Box<Note>,
    },
    /// An input is not of its column's type or unit.
    IllTyped {
        /// The table's id.
        table: String,
        /// The input's name.
        name: String,
        /// What was given.
        given: String,
        /// What is expected.
        expected: Box<Note>,
    },
    /// An input is outside the column's domain.
    OutOfDomain {
        /// The table's id.
        table: String,
        /// The input's name.
        name: String,
        /// What was given.
        given: String,
        /// The domain.
        domain: String,
    },
    /// Rows contradict each other.
    Conflict {
        /// The table's id.
        table: String,
        /// The row numbers.
        rows: String,
    },
}

impl From<&QueryError> for Note {
    fn from(error: &QueryError) -> Self {
        use QueryError as E;
        match error {
            E::NotADecision { table } => note!("table-is-a-catalog", table = table),
            E::UnknownInput { table, name, known } => {
                note!("table-has-no-input", table = table, name = name, known = known)
            }
            E::Missing { table, name, expected } => {
                note!("table-needs-input", table = table, name = name, what = **expected)
            }
            E::IllTyped { table, name, given, expected } => {
                note!("table-input-ill-typed", table = table, name = name, given = given, what = **expected)
            }
            E::OutOfDomain { table, name, given, domain } => {
                note!("table-input-out-of-domain", table = table, name = name, given = given, domain = domain)
            }
            E::Conflict { table, rows } => note!("table-rows-conflict", table = table, rows = rows),
        }
    }
}

impl fmt::Display for QueryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Note::from(self).fmt(f)
    }
}

impl std::error::Error for QueryError {}

/// The compiled tests of a table.
#[derive(Debug)]
pub(crate) struct Index {
    words: usize,
    columns: Vec<ColumnIndex>,
}

#[derive(Debug)]
struct ColumnIndex {
    /// The column's position in the table.
    column: usize,
    /// The domain, if the column declares one.
    domain: Option<Set>,
    /// The rank of the default.
    default: Option<i64>,
    /// First rank of each elementary interval; the first is `i64::MIN`.
    starts: Vec<i64>,
    /// For each interval, the rows whose test it satisfies: `words` words each.
    bits: Vec<u64>,
}

impl Index {
    fn build(table: &Table) -> Self {
        let words = table.rows.len().div_ceil(64).max(1);
        let columns = table.inputs().map(|(index, column)| ColumnIndex::build(table, index, column, words)).collect();
        Self { words, columns }
    }
}

impl ColumnIndex {
    fn build(table: &Table, index: usize, column: &Column, words: usize) -> Self {
        let sets: Vec<Option<&Set>> = table
            .rows
            .iter()
            .map(|row| match &row.cells[index] {
                Cell::Test(set, _) => Some(set),
                _ => None,
            })
            .collect();
        let mut starts = vec![i64::MIN];
        for set in sets.iter().flatten() {
            for &(low, high) in set.intervals() {
                starts.push(low);
                if high < i64::MAX {
                    starts.push(high + 1);
                }
            }
        }
        starts.sort_unstable();
        starts.dedup();
        let mut bits = vec![0; starts.len() * words];
        for (segment, &start) in starts.iter().enumerate() {
            for (row, set) in sets.iter().enumerate() {
                if set.is_none_or(|set| set.contains(start)) {
                    bits[segment * words + row / 64] |= 1 << (row % 64);
                }
            }
        }
        let default = column.default.as_ref().and_then(|value| column.rank(value));
        Self { column: index, domain: column.domain.clone(), default, starts, bits }
    }

    /// An input, with its interval.
    fn input_value(&self, rank: i64) -> InputValue {
        InputValue { rank, segment: self.starts.partition_point(|&start| start <= rank) - 1 }
    }

    /// The rows whose tests an interval satisfies.
    fn matching(&self, segment: usize, words: usize) -> &[u64] {
        &self.bits[segment * words..(segment + 1) * words]
    }
}

/// An input of a query.
#[derive(Debug, Clone, Copy, Default)]
struct InputValue {
    rank: i64,
    /// The index of its elementary interval.
    segment: usize,
}

/// The answer of a decision table: the rows that apply, the matching rows that were not taken, and why every other
/// row failed.
#[derive(Debug, Clone)]
pub struct Answer<'t> {
    table: &'t Table,
    /// The inputs, in the order of their columns.
    inputs: Few<InputValue, 6>,
    /// The rows that apply, by the hit policy.
    winners: Few<u32, 1>,
    /// Matching rows that the hit policy does not take.
    passed_over: Vec<u32>,
}

impl Table {
    pub(crate) fn index(&self) -> &Index {
        self.index.get_or_init(|| Index::build(self))
    }

    /// Queries a decision table. Inputs with a default may be left out.
    ///
    /// # Errors
    /// The question does not fit the table (unknown, missing, ill-typed or out-of-domain input), or rows of the table
    /// contradict each other. That no row matches is not an error: the answer then has no row and says why each row
    /// failed.
    pub fn decide<'t>(&'t self, inputs: &[(&str, Input<'_>)]) -> Result<Answer<'t>, QueryError> {
        let given: Vec<(&str, Option<Input<'_>>)> = inputs.iter().map(|&(name, input)| (name, Some(input))).collect();
        self.decided(&given)
    }

    /// As [`Self::decide`]; for an input that is none the table's default applies.
    fn decided<'t>(&'t self, inputs: &[(&str, Option<Input<'_>>)]) -> Result<Answer<'t>, QueryError> {
        if self.kind != TableKind::Decision {
            return Err(QueryError::NotADecision { table: self.id.clone() });
        }
        let index = self.index();
        let words = index.words;
        let mut given = Few::default();
        let mut used = 0;
        for (at, compiled) in index.columns.iter().enumerate() {
            let column = &self.columns[compiled.column];
            // Most questions have the inputs in the order of the columns.
            let in_order = inputs.get(at).filter(|(name, _)| *name == column.name);
            let rank = match in_order.or_else(|| inputs.iter().find(|(name, _)| *name == column.name)) {
                Some((_, Some(input))) => {
                    used += 1;
                    let rank = input.rank(column).ok_or_else(|| self.ill_typed(column, input))?;
                    if compiled.domain.as_ref().is_some_and(|domain| !domain.contains(rank)) {
                        return Err(self.out_of_domain(column, input));
                    }
                    rank
                }
                _ => compiled.default.ok_or_else(|| self.missing(column))?,
            };
            given.push(compiled.input_value(rank));
        }
        if used != inputs.iter().filter(|(_, input)| input.is_some()).count() {
            return Err(self.unknown_input(inputs));
        }
        let mut matched = Few::default();
        for word in 0..words {
            let tests = index.columns.iter().zip(given.iter());
            let alive = tests.fold(all_of_word(self.rows.len(), word), |alive, (compiled, given)| {
                alive & compiled.matching(given.segment, words)[word]
            });
            rows_of_word(alive, word).for_each(|row| matched.push(row));
        }
        let (winners, passed_over) = self.apply_policy(matched)?;
        Ok(Answer { table: self, inputs: given, winners, passed_over })
    }

    fn apply_policy(&self, matched: Few<u32, 1>) -> Result<(Few<u32, 1>, Vec<u32>), QueryError> {
        if matched.len() <= 1 || self.hit == HitPolicy::Collect {
            return Ok((matched, Vec::new()));
        }
        let matched: Vec<u32> = matched.iter().collect();
        let conflict = |rows: &[u32]| QueryError::Conflict {
            table: self.id.clone(),
            rows: rows.iter().map(|row| (row + 1).to_string()).collect::<Vec<_>>().join(", "),
        };
        let keep = |winner: u32| {
            let mut only = Few::default();
            only.push(winner);
            (only, matched.iter().copied().filter(|&row| row != winner).collect())
        };
        match self.hit {
            HitPolicy::First => Ok(keep(matched[0])),
            HitPolicy::Any if matched.iter().all(|&row| self.same_outputs(matched[0] as usize, row as usize)) => {
                Ok(keep(matched[0]))
            }
            HitPolicy::Priority => {
                let priority = |row: u32| self.rows[row as usize].priority;
                let best = matched.iter().copied().max_by_key(|&row| priority(row)).unwrap_or(matched[0]);
                let equals: Vec<u32> = matched.iter().copied().filter(|&row| priority(row) == priority(best)).collect();
                if equals.len() > 1 { Err(conflict(&equals)) } else { Ok(keep(best)) }
            }
            _ => Err(conflict(&matched)),
        }
    }

    pub(crate) fn same_outputs(&self, a: usize, b: usize) -> bool {
        self.outputs().all(|(column, _)| self.rows[a].cells[column] == self.rows[b].cells[column])
    }

    fn ill_typed(&self, column: &Column, input: &Input<'_>) -> QueryError {
        QueryError::IllTyped {
            table: self.id.clone(),
            name: column.name.clone(),
            given: format!("`{input}`"),
            expected: describe(column).into(),
        }
    }

    fn out_of_domain(&self, column: &Column, input: &Input<'_>) -> QueryError {
        QueryError::OutOfDomain {
            table: self.id.clone(),
            name: column.name.clone(),
            given: input.to_string(),
            domain: column.domain_text.clone().unwrap_or_default(),
        }
    }

    fn missing(&self, column: &Column) -> QueryError {
        QueryError::Missing { table: self.id.clone(), name: column.name.clone(), expected: describe(column).into() }
    }

    fn unknown_input(&self, inputs: &[(&str, Option<Input<'_>>)]) -> QueryError {
        let known: Vec<&str> = self.inputs().map(|(_, column)| column.name.as_str()).collect();
        // If all are known, one is given twice.
        let names = || inputs.iter().map(|(name, _)| *name);
        let twice = || names().find(|one| names().filter(|name| name == one).count() > 1);
        let name = names().find(|name| !known.contains(name)).or_else(twice).unwrap_or_default();
        QueryError::UnknownInput { table: self.id.clone(), name: name.to_owned(), known: known.join(", ") }
    }
}

/// A column's type, unit and values, for messages.
pub fn describe(column: &Column) -> Note {
    match column.ty {
        ColumnType::Enum => note!("lint-one-of", values = column.values.join(", ")),
        ColumnType::Bool => note!("lint-true-false"),
        ColumnType::Int => note!("lint-whole-number"),
        ColumnType::Number | ColumnType::Angle => note!("lint-number-in", unit = column.unit),
        ColumnType::Length => note!("lint-length-in", unit = column.unit),
        ColumnType::It => note!("lint-tolerance-grade"),
        ColumnType::Roughness => note!("lint-roughness-such-as"),
        ColumnType::Unit => note!("lint-a-unit"),
        ColumnType::Text => note!("lint-a-text"),
    }
}

/// The bits of existing rows in one word.
fn all_of_word(rows: usize, word: usize) -> u64 {
    match rows.saturating_sub(word * 64) {
        0 => 0,
        there @ 1..64 => u64::MAX >> (64 - there),
        _ => u64::MAX,
    }
}

/// The rows of the bits in one word.
fn rows_of_word(bits: u64, word: usize) -> impl Iterator<Item = u32> {
    let (mut left, first) = (bits, word as u32 * 64);
    std::iter::from_fn(move || {
        (left != 0).then(|| {
            let bit = left.trailing_zeros();
            left &= left - 1;
            first + bit
        })
    })
}

impl<'t> Answer<'t> {
    /// The table that was asked.
    pub fn table(&self) -> &'t Table {
        self.table
    }

    /// The row that applies; the first of several under `collect`.
    pub fn winner(&self) -> Option<RowRef<'t>> {
        self.winners().next()
    }

    /// Every row that applies.
    pub fn winners(&self) -> impl Iterator<Item = RowRef<'t>> + '_ {
        self.winners.iter().map(|row| RowRef { table: self.table, index: row as usize })
    }

    /// Rows that match but were not taken.
    pub fn passed_over(&self) -> impl Iterator<Item = RowRef<'t>> + '_ {
        self.passed_over.iter().map(|&row| RowRef { table: self.table, index: row as usize })
    }

    /// Every rejected row with the first column whose test failed, column by column.
    pub fn rejected(&self) -> impl Iterator<Item = (RowRef<'t>, &'t Column)> + '_ {
        // Computed here and not in the query, because most callers do not need it.
        let (table, index) = (self.table, self.table.index());
        let mut alive: Vec<u64> = (0..index.words).map(|word| all_of_word(table.rows.len(), word)).collect();
        index.columns.iter().zip(self.inputs.iter()).flat_map(move |(compiled, given)| {
            let column = &table.columns[compiled.column];
            let matching = compiled.matching(given.segment, index.words);
            let lost: Vec<u64> = alive.iter().zip(matching).map(|(alive, matching)| alive & !matching).collect();
            alive.iter_mut().zip(matching).for_each(|(alive, matching)| *alive &= matching);
            let rows = lost.into_iter().enumerate().flat_map(|(word, lost)| rows_of_word(lost, word));
            rows.map(move |row| (RowRef { table, index: row as usize }, column))
        })
    }

    /// The inputs as understood, with defaults.
    pub fn inputs(&self) -> impl Iterator<Item = (&'t str, String)> + '_ {
        self.table
            .inputs()
            .zip(self.inputs.iter())
            .map(|((_, column), given)| (column.name.as_str(), column.show_rank(given.rank)))
    }
}

/// The answer of a table whose rows are read as `R`.
#[derive(Debug, Clone)]
pub struct TypedAnswer<'t, R> {
    /// The answer itself, for citing the rejected rows.
    pub answer: Answer<'t>,
    rows: PhantomData<R>,
}

impl<'t, R: TableRow<'t>> TypedAnswer<'t, R> {
    /// The row that applies, if there is one; the first of several under `collect`.
    ///
    /// # Errors
    /// The row breaks its contract; this does not happen in a checked table.
    pub fn winner(&self) -> Result<Option<R>, TableError> {
        self.answer.winner().map(R::read).transpose()
    }

    /// Every row that applies.
    ///
    /// # Errors
    /// As [`Self::winner`].
    pub fn winners(&self) -> Result<Vec<R>, TableError> {
        self.answer.winners().map(R::read).collect()
    }

    /// The row that must apply; `wanted` names it in the message if there is none.
    ///
    /// # Errors
    /// No row applies.
    pub fn need(&self, wanted: &str) -> Result<R, KnowledgeError> {
        self.winner()?.ok_or_else(|| KnowledgeError::no_row(self.answer.table(), wanted))
    }
}

impl Table {
    /// As [`Self::decide`], with a typed question; for a table whose id is in another table.
    ///
    /// # Errors
    /// As [`Self::decide`].
    pub fn ask<'t, Q: Question>(&'t self, question: &Q) -> Result<TypedAnswer<'t, Q::Row<'t>>, QueryError> {
        Ok(TypedAnswer { answer: question.put(|inputs| self.decided(inputs))?, rows: PhantomData })
    }
}

impl Knowledge {
    /// Queries the table of a question.
    ///
    /// # Errors
    /// There is no such table, or the question does not fit it; see [`Table::decide`].
    pub fn ask<'k, Q: Question>(&'k self, question: &Q) -> Result<TypedAnswer<'k, Q::Row<'k>>, KnowledgeError> {
        Ok(self.table(Q::TABLE)?.ask(question)?)
    }

    /// As [`Self::ask`]; none if a figure is outside the range of the table.
    ///
    /// # Errors
    /// As [`Self::ask`], except for that.
    pub fn ask_within<'k, Q: Question>(
        &'k self,
        question: &Q,
    ) -> Result<Option<TypedAnswer<'k, Q::Row<'k>>>, KnowledgeError> {
        match self.table(Q::TABLE)?.ask(question) {
            Err(QueryError::OutOfDomain { .. }) => Ok(None),
            answer => Ok(Some(answer?)),
        }
    }

    /// The row that answers a question; none if a figure is outside the range of the table, or no row answers.
    ///
    /// # Errors
    /// As [`Self::ask`], except for that, and rows contradict each other.
    pub fn winner_within<'k, Q: Question>(&'k self, question: &Q) -> Result<Option<Q::Row<'k>>, KnowledgeError> {
        Ok(self.ask_within(question)?.map(|answer| answer.winner()).transpose()?.flatten())
    }

    /// The one table of a row type.
    ///
    /// # Errors
    /// There is no such table.
    pub fn table_of<'k, R: TableRow<'k>>(&'k self) -> Result<&'k Table, TableError> {
        self.table(R::CONTRACT.which.id())
    }

    /// Every table of a row type, by id.
    pub fn tables_of<'k, R: TableRow<'k>>(&'k self) -> Box<dyn Iterator<Item = &'k Table> + 'k> {
        match R::CONTRACT.which {
            Which::One(id) => Box::new(self.table(id).into_iter()),
            Which::Each(ids) => {
                let mut ids = ids.to_vec();
                ids.sort_unstable();
                Box::new(ids.into_iter().filter_map(|id| self.table(id).ok()))
            }
            Which::Record(schema) => Box::new(self.records_of(schema)),
            Which::Tools => Box::new(self.tables_of_cutters()),
        }
    }

    /// Every row of the one table of a row type.
    ///
    /// # Errors
    /// There is no such table, or a row breaks its contract; the latter does not happen in checked tables.
    pub fn rows<'k, R: TableRow<'k>>(&'k self) -> Result<Vec<R>, TableError> {
        self.table_of::<R>()?.read()
    }

    /// The first row for which `is` holds; none if there is none.
    ///
    /// # Errors
    /// As [`Self::rows`].
    pub fn find<'k, R: TableRow<'k>>(&'k self, is: impl Fn(&R) -> bool) -> Result<Option<R>, TableError> {
        let found = self.table_of::<R>()?.rows().find(|row: &Result<R, _>| row.as_ref().map_or(true, &is));
        found.transpose()
    }

    /// The first row for which `is` holds, where there must be one; `wanted` names it in the message.
    ///
    /// # Errors
    /// As [`Self::rows`], or no row is the wanted one.
    pub fn need<'k, R: TableRow<'k>>(&'k self, wanted: &str, is: impl Fn(&R) -> bool) -> Result<R, KnowledgeError> {
        let table = self.table_of::<R>()?;
        self.find(is)?.ok_or_else(|| KnowledgeError::no_row(table, wanted))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::table_from_text;

    const TABLE: &str = r#"
table: t
title: {uk: т, en: t}
kind: decision
hit: unique
place: test
columns:
  - {name: it, type: it, role: input, domain: "[6..10]"}
  - {name: diameter, type: length, unit: mm, role: input, domain: "(0..500]"}
  - {name: state, type: enum, values: [solid, cast], role: input, default: solid}
  - {name: scheme, type: text, role: output}
rows:
  - {it: "[9..10]", diameter: "<= 6", state: solid, scheme: "18", source: seed}
  - {it: "[9..10]", diameter: "(6..10]", state: solid, scheme: "08", source: seed}
  - {it: "[7..8]", diameter: "-", state: solid, scheme: "28", source: seed}
  - {it: "[9..10]", diameter: "-", state: cast, scheme: "14", source: seed}
"#;

    fn grade(grade: u8) -> Input<'static> {
        Input::Grade(ItGrade::new(grade).unwrap())
    }

    fn mm(value: &str) -> Input<'static> {
        Input::Length(value.parse().unwrap())
    }

    #[test]
    fn the_answer_names_the_winner_and_the_failing_column_of_every_other_row() {
        let table = table_from_text("t.yaml", TABLE).unwrap();
        let answer = table.decide(&[("it", grade(9)), ("diameter", mm("6.001"))]).unwrap();
        assert_eq!(answer.winner().unwrap().text("scheme").unwrap(), "08");
        let rejected: Vec<_> = answer.rejected().map(|(row, column)| (row.number(), column.name.as_str())).collect();
        assert_eq!(rejected, [(3, "it"), (1, "diameter"), (4, "state")]);
    }

    #[test]
    fn a_wrong_question_is_an_error_and_never_a_miss() {
        let table = table_from_text("t.yaml", TABLE).unwrap();
        let ask = |inputs: &[(&str, Input<'_>)]| {
            table
                .decide(inputs)
                .map(|_| ())
                .map_err(|error| technolog_words::Lang::EN.say(&Note::from(&error)))
                .unwrap_err()
        };
        assert!(ask(&[("it", grade(9))]).contains("needs the input `diameter`"));
        assert!(ask(&[("it", grade(9)), ("diameter", Input::Int(7))]).contains("is not a length in mm"));
        assert!(ask(&[("it", grade(12)), ("diameter", mm("7"))]).contains("outside the table's domain [6..10]"));
        assert!(
            ask(&[("it", grade(9)), ("diameter", mm("7")), ("colour", Input::Bool(true))]).contains("its inputs are")
        );
        let none = table.decide(&[("it", grade(6)), ("diameter", mm("7"))]).unwrap();
        assert!(none.winner().is_none());
        assert_eq!(none.rejected().count(), 4);
    }

    #[test]
    fn two_rows_under_unique_are_an_error_that_names_both() {
        let text = TABLE.replace("(6..10]", "(5..10]");
        let table = table_from_text("t.yaml", &text).unwrap();
        let error = table.decide(&[("it", grade(9)), ("diameter", mm("5.5"))]).unwrap_err();
        assert_eq!(error, QueryError::Conflict { table: "t".into(), rows: "1, 2".into() });
    }
}
