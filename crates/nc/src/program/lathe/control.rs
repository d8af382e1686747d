//! The language of a lathe control as data, from the tables lathe-functions and lathe-read-cycles.

use std::collections::BTreeMap;

use super::LatheReader;
use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::knowledge::contract::Word;
use crate::tables::controls::lathe_reading::{Form, LatheFunctions, LatheGroup, LatheReadCycles, WordEffect};
use technolog_note::note;

/// The fields of a cycle: all, and those that must be given.
#[derive(Clone, Debug, Default)]
pub(super) struct CycleFields {
    pub all: Vec<String>,
    pub required: Vec<String>,
}

/// The language of a control.
#[derive(Clone, Debug)]
pub struct LatheLanguage {
    pub(super) kind: LatheReader,
    pub(super) functions: BTreeMap<String, (LatheGroup, WordEffect)>,
    pub(super) power_on: Vec<(LatheGroup, WordEffect)>,
    /// The groups with a function that must be programmed before the first motion, and that function.
    pub(super) must_be_said: Vec<(LatheGroup, String)>,
    cycles: BTreeMap<(String, &'static str), CycleFields>,
}

impl LatheLanguage {
    /// The controls, as a user names them.
    pub const NAMES: [&'static str; 3] = ["linuxcnc-lathe", "fanuc-lathe", "sinumerik"];

    /// Reads the language of a control.
    ///
    /// # Errors
    /// There is no such control, or a table is missing or lacks what is required of it.
    pub fn read(control: &str, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let unknown = || KnowledgeError::missing("lathe-functions", note!("nc-interpreter", control = control));
        let kind = LatheReader::from_word(control).ok_or_else(unknown)?;
        let mut language = Self {
            kind,
            functions: BTreeMap::new(),
            power_on: Vec::new(),
            must_be_said: Vec::new(),
            cycles: BTreeMap::new(),
        };
        let of_it = |list: &Option<Vec<LatheReader>>| list.as_ref().is_some_and(|list| list.contains(&kind));
        for row in knowledge.rows::<LatheFunctions<'_>>()?.into_iter().filter(|row| row.controls.contains(&kind)) {
            language.functions.insert(row.code.to_owned(), (row.group, row.does));
            if of_it(&row.power_on) {
                language.power_on.push((row.group, row.does));
            }
            if of_it(&row.must_be_said) {
                language.must_be_said.push((row.group, row.code.to_owned()));
            }
        }
        for row in knowledge.rows::<LatheReadCycles<'_>>()?.into_iter().filter(|row| row.control == kind) {
            let owned = |texts: Vec<&str>| texts.into_iter().map(str::to_owned).collect();
            let fields = CycleFields { all: owned(row.fields), required: owned(row.required) };
            language.cycles.insert((row.cycle.to_owned(), form(row.form)), fields);
        }
        Ok(language)
    }

    /// The control.
    pub const fn kind(&self) -> LatheReader {
        self.kind
    }

    pub(super) fn cycle(&self, name: &str, of_form: Form) -> CycleFields {
        self.cycles.get(&(name.to_owned(), form(of_form))).cloned().unwrap_or_default()
    }
}

const fn form(form: Form) -> &'static str {
    match form {
        Form::One => "one",
        Form::First => "first",
        Form::Second => "second",
    }
}
