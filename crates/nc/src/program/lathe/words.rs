//! The words of a block with their values; used words are marked, so that the others can be reported.

use std::cell::RefCell;
use std::collections::BTreeSet;

use super::control::LatheLanguage;
use super::expression::Parameters;
use super::rules::fault;
use super::text::Block;
use crate::program::{Fault, TextSpan};
use crate::tables::controls::lathe_reading::{LatheGroup, WordEffect};

/// A word with its value.
#[derive(Clone, Debug)]
pub(super) struct Value {
    pub name: String,
    pub value: f64,
    pub point: bool,
    pub span: TextSpan,
}

/// A function with its place.
#[derive(Clone, Debug)]
pub(super) struct Function {
    pub code: String,
    pub group: LatheGroup,
    pub effect: WordEffect,
    pub span: TextSpan,
}

/// The words of a block.
#[derive(Clone, Debug, Default)]
pub(super) struct BlockWords {
    pub functions: Vec<Function>,
    values: Vec<Value>,
    used: RefCell<BTreeSet<usize>>,
    /// `T="NAME"`.
    pub tool: Option<(String, TextSpan)>,
    /// Names that are no functions: calls of subprograms.
    pub names: Vec<(String, TextSpan)>,
}

/// The code of a function as in the table: `G01` becomes `G1`, `G91.1` stays.
fn code(letter: &str, value: f64) -> String {
    let tenths = libm::round(value * 10.0) as i64;
    if tenths % 10 == 0 {
        format!("{letter}{}", tenths / 10)
    } else {
        format!("{letter}{}.{}", tenths / 10, tenths % 10)
    }
}

impl BlockWords {
    pub fn read(block: &Block, language: &LatheLanguage, parameters: &Parameters, faults: &mut Vec<Fault>) -> Self {
        let mut words = Self { tool: block.tool.clone(), ..Self::default() };
        for word in &block.words {
            let Some(value) = word.value.value(parameters) else {
                faults.push(fault("lathe-parameter-unknown", word.span, block.number).with("word", word.name.clone()));
                continue;
            };
            if matches!(word.name.as_str(), "G" | "M") {
                words.function(&code(&word.name, value), word.span, block, language, faults);
                continue;
            }
            if words.values.iter().any(|known| known.name == word.name) {
                faults.push(fault("word-twice", word.span, block.number).with("address", word.name.clone()));
            }
            words.values.push(Value { name: word.name.clone(), value, point: word.point, span: word.span });
        }
        for (name, span) in &block.names {
            if language.functions.contains_key(name) {
                words.function(name, *span, block, language, faults);
            } else {
                words.names.push((name.clone(), *span));
            }
        }
        words
    }

    fn function(
        &mut self,
        code: &str,
        span: TextSpan,
        block: &Block,
        language: &LatheLanguage,
        faults: &mut Vec<Fault>,
    ) {
        let Some((group, does)) = language.functions.get(code).copied() else {
            faults.push(fault("unknown-word", span, block.number).with("word", code.to_owned()));
            return;
        };
        let free = matches!(group, LatheGroup::Machine | LatheGroup::Free | LatheGroup::OneShot);
        if let Some(first) =
            self.functions.iter().find(|function| function.group == group && (!free || function.code == code))
        {
            let problem = fault("group-exclusive", span, block.number).with("first", first.code.clone());
            faults.push(problem.with("second", code.to_owned()));
        }
        self.functions.push(Function { code: code.to_owned(), group, effect: does, span });
    }

    pub fn of_group(&self, group: LatheGroup) -> Option<&Function> {
        self.functions.iter().find(|function| function.group == group)
    }

    pub fn function_for(&self, does: WordEffect) -> Option<&Function> {
        self.functions.iter().find(|function| function.effect == does)
    }

    /// A word, marked as used.
    pub fn take(&self, name: &str) -> Option<&Value> {
        let index = self.values.iter().position(|value| value.name == name)?;
        self.used.borrow_mut().insert(index);
        self.values.get(index)
    }

    /// Marks all words as used.
    pub fn take_all(&self) {
        self.used.borrow_mut().extend(0..self.values.len());
    }

    /// A word, without marking it.
    pub fn look(&self, name: &str) -> Option<&Value> {
        self.values.iter().find(|value| value.name == name)
    }

    /// The words that no function used.
    pub fn unused(&self) -> Vec<Value> {
        let used = self.used.borrow();
        self.values
            .iter()
            .enumerate()
            .filter(|(index, _)| !used.contains(index))
            .map(|(_, value)| value.clone())
            .collect()
    }

    /// Every word that is no function.
    pub fn all(&self) -> &[Value] {
        &self.values
    }
}
