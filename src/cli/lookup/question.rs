//! Parses `it=7 diameter=12` into typed values of a table's columns.

use std::borrow::Cow;

use technolog::knowledge::diagnostic::nearest;
use technolog::knowledge::table::Cell;
use technolog::knowledge::{Column, ColumnRole, ColumnType, Diagnostic, Place, RowRef, Table, TableKind, Value};
use technolog::words::say;

use super::Args;
use crate::cli::diagnostics::Texts;
use crate::cli::{CliError, Context, shown};

/// A question to a table, in which every key is a column and every value is of its type.
#[derive(Debug)]
pub struct LookupQuestion<'t> {
    /// The table that is queried.
    pub table: &'t Table,
    /// The position of each given column, and its value.
    pub given: Vec<(usize, Value)>,
}

impl<'t> LookupQuestion<'t> {
    /// Reads the arguments against the columns of the table.
    ///
    /// # Errors
    /// All mistakes in the question, each with its place in the command line.
    pub fn read(table: &'t Table, args: &Args, context: &Context) -> Result<Self, CliError> {
        let line = CommandLine::of(args, context);
        let mut reader =
            Reader { table, context, line: &line, given: vec![], named: vec![], misspelt: vec![], problems: vec![] };
        for (pair, at) in args.query.iter().zip(&line.pairs) {
            reader.pair(pair, *at);
        }
        reader.missing();
        let Reader { given, problems, .. } = reader;
        if problems.is_empty() {
            return Ok(Self { table, given });
        }
        let texts = Texts::default().with(line.name, line.name.to_owned(), Cow::Owned(line.text));
        Err(CliError::Unusable { problems, texts })
    }

    /// The given value of a column.
    pub fn value(&self, column: usize) -> Option<&Value> {
        self.given.iter().find(|(index, _)| *index == column).map(|(_, value)| value)
    }
}

/// A place in the command line: first character and number of characters.
#[derive(Clone, Copy, Debug)]
struct At {
    start: usize,
    width: usize,
}

/// The question as one line of text, so that a mistake in it has a place as in a file.
struct CommandLine {
    name: &'static str,
    text: String,
    table: At,
    pairs: Vec<At>,
}

impl CommandLine {
    fn of(args: &Args, context: &Context) -> Self {
        let mut text = String::from("technolog lookup");
        let mut add = |word: &str| {
            let (start, width) = (text.chars().count() + 1, word.chars().count());
            text.push(' ');
            text.push_str(word);
            At { start, width }
        };
        let table = add(&plain(&args.table));
        let pairs = args.query.iter().map(|pair| add(&quoted(&plain(pair)))).collect();
        Self { name: context.word("cli-command-line"), text, table, pairs }
    }

    fn place(&self, at: At) -> Place {
        let number = |count: usize| u32::try_from(count).unwrap_or(u32::MAX);
        Place { file: self.name.into(), line: 1, column: number(at.start + 1), width: number(at.width) }
    }
}

/// On one line, whatever was typed.
fn plain(text: &str) -> String {
    text.chars().map(|letter| if letter.is_control() { ' ' } else { letter }).collect()
}

/// As a shell takes it: `roughness="Ra 2.5"`.
fn quoted(pair: &str) -> String {
    match pair.split_once('=') {
        Some((key, value)) if value.contains(char::is_whitespace) => format!("{key}=\"{value}\""),
        _ => pair.to_owned(),
    }
}

struct Reader<'t, 'a> {
    table: &'t Table,
    context: &'a Context,
    line: &'a CommandLine,
    given: Vec<(usize, Value)>,
    /// The columns that were named, with a valid value or not.
    named: Vec<usize>,
    /// The columns that a misspelt key may mean.
    misspelt: Vec<usize>,
    problems: Vec<Diagnostic>,
}

impl Reader<'_, '_> {
    fn problem(&mut self, code: &'static str, message: String, at: At, help: String) {
        self.problems.push(Diagnostic::error(code, message, self.line.place(at)).help(help));
    }

    /// The columns of possible keys, with their positions.
    fn keys(&self) -> Vec<(usize, &Column)> {
        match self.table.kind {
            TableKind::Decision => self.table.inputs().collect(),
            TableKind::Catalog => self.table.columns.iter().enumerate().collect(),
        }
    }

    fn pair(&mut self, pair: &str, at: At) {
        let lang = self.context.lang;
        let Some((key, text)) = pair.split_once('=') else {
            let example = self.keys().first().map(|(_, column)| example(column, None)).unwrap_or_default();
            let message = say!(lang, "cli-not-a-pair", text = pair);
            return self.problem("bad-argument", message, at, say!(lang, "cli-write-pair", example = example));
        };
        let key_at = At { start: at.start, width: key.chars().count() };
        let value_start = at.start + key.chars().count() + 1;
        let value_at = At { start: value_start, width: (at.start + at.width - value_start).max(1) };
        let (key, text) = (key.trim(), text.trim());
        let Some(index) = self.keys().iter().find(|(_, column)| column.name == key).map(|(index, _)| *index) else {
            return self.unknown(key, key_at);
        };
        if self.named.contains(&index) {
            return self.problem(
                "duplicate-key",
                say!(lang, "yaml-key-stands-twice", key = key),
                key_at,
                say!(lang, "cli-keep-one").to_owned(),
            );
        }
        self.named.push(index);
        let column = &self.table.columns[index];
        let expected = |domain: bool| {
            let domain = column.domain_text.as_deref().filter(|_| domain);
            let domain = domain.map(|domain| format!(", {}", typed(&shown::test(lang, column, domain))));
            let domain = domain.unwrap_or_default();
            say!(lang, "cli-expected-is", expected = shown::expected(lang, column) + &domain)
        };
        let value = match column.parse_value(text) {
            Ok(value) if !text.is_empty() => value,
            Ok(_) => {
                return self.problem(
                    "bad-value",
                    say!(lang, "cli-bad-value", key = key, value = text),
                    value_at,
                    expected(true),
                );
            }
            Err(why) => {
                return self.problem(
                    "bad-value",
                    say!(lang, "cli-bad-value-because", key = key, why = why),
                    value_at,
                    expected(true),
                );
            }
        };
        // A catalog simply has no row outside its limits; a decision table has no answer there.
        if self.table.kind == TableKind::Decision
            && let (Some(domain), Some(rank)) = (&column.domain, column.rank(&value))
            && !domain.contains(rank)
        {
            let domain = shown::test(lang, column, column.domain_text.as_deref().unwrap_or_default());
            let message =
                say!(lang, "cli-out-of-domain", key = key, value = shown::full(lang, column, &value), domain = domain);
            return self.problem("out-of-domain", message, value_at, say!(lang, "cli-within-domain").to_owned());
        }
        self.given.push((index, value));
    }

    fn unknown(&mut self, key: &str, at: At) {
        let lang = self.context.lang;
        let names: Vec<&str> = self.keys().iter().map(|(_, column)| column.name.as_str()).collect();
        let is_output = self.table.columns.iter().any(|column| column.name == key && column.role == ColumnRole::Output);
        let message = if is_output {
            say!(lang, "cli-is-output", table = &self.table.id, key = key)
        } else {
            say!(lang, "cli-no-such-key", table = &self.table.id, key = key)
        };
        let known = names.join(", ");
        let near = nearest(key, names.iter().copied()).filter(|_| !is_output);
        let meant = near.and_then(|near| self.table.column_index(near));
        let help = match near {
            Some(near) => say!(lang, "cli-no-such-key-but", near = near, known = known),
            None => say!(lang, "cli-the-keys-are", known = known),
        };
        // One mistake is one problem: a misspelt key is not also missing.
        self.misspelt.extend(meant);
        self.problem("unknown-key", message, at, help);
    }

    /// The first row that answers with what is given and the defaults of the rest, so that an example made of it is
    /// answered when it is followed.
    fn answering(&self) -> Option<RowRef<'_>> {
        let fits = |row: &RowRef<'_>| {
            self.table.inputs().all(|(index, column)| {
                let given = self.given.iter().find(|(own, _)| *own == index).map(|(_, value)| value);
                let rank = given.or(column.default.as_ref()).and_then(|value| column.rank(value));
                match (row.row().cells.get(index), rank) {
                    (Some(Cell::Test(set, _)), Some(rank)) => set.contains(rank),
                    _ => true,
                }
            })
        };
        self.table.all_rows().find(fits)
    }

    /// Inputs of a decision table that have no default and were not named.
    fn missing(&mut self) {
        if self.table.kind == TableKind::Catalog {
            return;
        }
        let lang = self.context.lang;
        let missing: Vec<(usize, &Column)> = self
            .table
            .inputs()
            .filter(|(index, column)| {
                column.default.is_none() && !self.named.contains(index) && !self.misspelt.contains(index)
            })
            .collect();
        if missing.is_empty() {
            return;
        }
        let keys: Vec<String> = missing
            .iter()
            .map(|(_, column)| format!("`{}` ({})", column.name, shown::expected(lang, column)))
            .collect();
        let row = self.answering();
        let in_row = |index: usize| row.and_then(|row| row.row().cells.get(index));
        let examples: Vec<String> = missing.iter().map(|(index, column)| example(column, in_row(*index))).collect();
        let message = say!(lang, "cli-missing-keys", table = &self.table.id, keys = keys.join(", "));
        let help = say!(lang, "cli-give-keys", example = examples.join(" "));
        self.problem("missing-key", message, self.line.table, help);
    }
}

/// Numbers as they are typed, with a decimal point.
fn typed(shown: &str) -> String {
    let letters: Vec<char> = shown.chars().collect();
    let is_digit = |at: Option<usize>| at.and_then(|at| letters.get(at)).is_some_and(char::is_ascii_digit);
    let point = |(at, letter): (usize, &char)| match letter {
        ',' if is_digit(at.checked_sub(1)) && is_digit(Some(at + 1)) => '.',
        other => *other,
    };
    letters.iter().enumerate().map(point).collect()
}

/// An example pair for this column: the upper limit of what the row permits, or else of its domain, otherwise the
/// lower.
fn example(column: &Column, of_row: Option<&Cell>) -> String {
    let permitted = match of_row {
        Some(Cell::Test(set, _)) => set.intersection(&column.allowed()),
        _ => column.allowed(),
    };
    let value = match permitted.intervals().last() {
        Some(&(low, i64::MAX)) if low > i64::MIN => column.show_rank(low),
        Some(&(_, high)) if high < i64::MAX => {
            // Below an open bound the nearest whole number is easier to read.
            let whole = high - high.rem_euclid(1_000_000);
            let of_number = column.ty == ColumnType::Number && permitted.contains(whole);
            column.show_rank(if of_number { whole } else { high })
        }
        _ => "…".to_owned(),
    };
    quoted(&format!("{}={value}", column.name))
}
