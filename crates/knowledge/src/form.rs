//! One description of a mapping in a file format, and the reader that uses its keys.
//!
//! [`forms!`](crate::forms) declares the keys of a mapping, with units and remarks. From it come the JSON Schema, the
//! list of known keys and one constant for each key. A reader takes a field by its constant, so it cannot use a key
//! that the description lacks.

use std::collections::BTreeSet;
use std::marker::PhantomData;

use technolog_note::{Note, note};

use crate::diagnostic::{Diagnostic, Place};
use crate::examples;
use crate::hint;
use crate::input::show_invisible;
use crate::yaml::{Key, Node, Problems};

/// A mapping of a file format.
pub trait Form: Sized + 'static {
    /// Its keys, in the order of its description.
    const KEYS: &'static [KeyOf<Self>];
}

/// A key of the mapping `F`: as it is written, and the path of the mapping in Rust.
#[derive(Debug)]
pub struct KeyOf<F>(&'static str, &'static str, PhantomData<fn() -> F>);

impl<F> Clone for KeyOf<F> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<F> Copy for KeyOf<F> {}

impl<F> KeyOf<F> {
    /// Only for [`forms!`](crate::forms): the name of the field in Rust.
    #[doc(hidden)]
    pub const fn of_field(field: &'static str, form: &'static str) -> Self {
        let name = match field.as_bytes() {
            [b'r', b'#', ..] => field.split_at(2).1,
            _ => field,
        };
        Self(name, form, PhantomData)
    }

    /// As it is written in files.
    pub const fn name(self) -> &'static str {
        self.0
    }
}

/// Marks a mapping whose keys are data.
#[derive(Debug)]
pub struct AnyKeys;

/// A key by which a field of the mapping `F` can be read.
pub trait KeyIn<F> {
    /// The key as written in files.
    fn written(&self) -> &str;

    /// The path of the mapping in Rust; empty where keys are data.
    fn form(&self) -> &'static str;
}

impl<F> KeyIn<F> for KeyOf<F> {
    fn written(&self) -> &str {
        self.0
    }

    fn form(&self) -> &'static str {
        self.1
    }
}

impl KeyIn<AnyKeys> for &str {
    fn written(&self) -> &str {
        self
    }

    fn form(&self) -> &'static str {
        ""
    }
}

/// Declares mappings of a file format. A field that is no `Option` is required; its remark is the description in the
/// JSON Schema. The constants have the names of the fields: `Hole::diameter`.
#[macro_export]
macro_rules! forms {
    ($(
        $(#[$meta:meta])*
        pub struct $name:ident { $($(#[$remark:meta])* pub $field:ident: $kind:ty),* $(,)? }
    )*) => {$(
        #[derive(Clone, Debug, serde::Deserialize, schemars::JsonSchema)]
        $(#[$meta])*
        #[serde(deny_unknown_fields)]
        pub struct $name {
            $($(#[$remark])* pub $field: $kind,)*
        }

        impl $crate::form::Form for $name {
            const KEYS: &'static [$crate::form::KeyOf<Self>] = &[$(Self::$field),*];
        }

        #[allow(non_upper_case_globals, missing_docs)] // they are the fields
        impl $name {
            $(pub const $field: $crate::form::KeyOf<Self> = $crate::form::KeyOf::of_field(
                stringify!($field),
                concat!(module_path!(), "::", stringify!($name)),
            );)*
        }
    )*};
}

/// The fields of one mapping; a field that is not taken is an unknown key.
#[derive(Debug)]
pub struct Fields<'n, F> {
    entries: &'n [(Key, Node)],
    taken: Vec<bool>,
    /// Where the mapping begins.
    pub place: &'n Place,
    /// The number of problems before the mapping was read: problems about missing keys come after it.
    before: usize,
    form: PhantomData<F>,
}

impl<'n, F> Fields<'n, F> {
    pub(crate) fn new(entries: &'n [(Key, Node)], place: &'n Place, before: usize) -> Self {
        Self { entries, taken: vec![false; entries.len()], place, before, form: PhantomData }
    }

    /// Takes an optional field; an empty value counts as absent.
    pub fn take(&mut self, key: impl KeyIn<F>) -> Option<&'n Node> {
        let index = self.entries.iter().position(|(known, _)| known.text == key.written())?;
        self.taken[index] = true;
        Some(&self.entries[index].1).filter(|node| !node.is_null())
    }

    /// Takes a field of another form with which the mapping may be confused.
    pub fn take_foreign<G>(&mut self, key: KeyOf<G>) -> Option<&'n Node> {
        self.take(KeyOf::of_field(key.0, key.1))
    }

    /// Takes a field that must be there.
    pub fn need(&mut self, key: impl KeyIn<F>, problems: &mut Problems) -> Option<&'n Node> {
        let missing = missing_key(key.written(), self.place).help(examples::to_add(key.form(), key.written()));
        let node = self.take(key);
        if node.is_none() {
            problems.0.push(missing);
        }
        node
    }

    /// Takes an optional field unless it has been taken before.
    pub fn take_once(&mut self, key: KeyOf<F>) -> Option<&'n Node> {
        let index = self.entries.iter().position(|(known, _)| known.text == key.0)?;
        if self.taken[index] { None } else { self.take(key) }
    }

    /// The fields not yet taken, in order.
    pub fn remaining(&mut self) -> Vec<(&'n Key, &'n Node)> {
        let entries = self.entries;
        let rest =
            entries.iter().zip(&self.taken).filter(|(_, taken)| !**taken).map(|((key, node), _)| (key, node)).collect();
        self.taken.fill(true);
        rest
    }

    /// Reports every field that was not taken. A mistyped required key is one mistake, not two: it is no longer
    /// reported as missing.
    fn report(mut self, known: &[&str], problems: &mut Problems) {
        let present = hint::present(known, self.entries);
        let (mut unknown, mut meant) = (Vec::new(), BTreeSet::new());
        for (key, node) in self.remaining() {
            let hint = hint::for_typed(&key.text, known, &present);
            let help = match &hint {
                _ if node.is_null() && key.text.bytes().all(|byte| byte.is_ascii_digit()) => {
                    note!("yaml-write-decimal-point-number-comma")
                }
                Some(hint) => hint.to_note(),
                None => note!("case-known-here", names = known.join(", ")),
            };
            meant.extend(hint.map(|hint| missing_key(hint.key(), self.place).message));
            let message = note!("yaml-unknown-key", key = show_invisible(&key.text));
            unknown.push(Diagnostic::error("unknown-key", message, key.place.clone()).help(help));
        }
        if !meant.is_empty() {
            let behind = problems.0.split_off(self.before.min(problems.0.len()));
            let same =
                |problem: &Diagnostic| problem.place.as_ref() == Some(self.place) && meant.contains(&problem.message);
            problems.0.extend(behind.into_iter().filter(|one| !same(one)));
        }
        problems.0.extend(unknown);
    }
}

impl<F: Form> Fields<'_, F> {
    /// Reports every field that was not taken.
    pub fn finish(self, problems: &mut Problems) {
        self.finish_among(F::KEYS, problems);
    }

    /// The same where only some keys of the mapping belong together.
    pub fn finish_among(self, known: &[KeyOf<F>], problems: &mut Problems) {
        let known: Vec<&str> = known.iter().map(|key| key.0).collect();
        self.report(&known, problems);
    }

    /// Whether the field is present, taken or not, or only mistyped: then nothing can be said about other missing
    /// keys.
    pub fn means(&self, key: KeyOf<F>) -> bool {
        let known: Vec<&str> = F::KEYS.iter().map(|key| key.0).collect();
        let present = hint::present(&known, self.entries);
        let meant = |typed: &str| {
            typed == key.0
                || !known.contains(&typed)
                    && hint::for_typed(typed, &known, &present).is_some_and(|hint| hint.key() == key.0)
        };
        self.entries.iter().any(|(typed, node)| !node.is_null() && meant(&typed.text))
    }
}

impl Fields<'_, AnyKeys> {
    /// Reports every field that was not taken; `known` are the right keys.
    pub fn finish(self, known: &[&str], problems: &mut Problems) {
        self.report(known, problems);
    }
}

impl Problems {
    /// Reports a missing key that the other keys require, and returns nothing.
    pub fn missing<F, T>(&mut self, key: KeyOf<F>, place: &Place, help: impl Into<Note>) -> Option<T> {
        self.0.push(missing_key(key.0, place).help(help));
        None
    }
}

/// The known key meant by a mistyped or Ukrainian one.
pub fn similar_key<'k>(typed: &str, known: &[&'k str]) -> Option<&'k str> {
    hint::for_typed(typed, known, &[]).map(|hint| hint.key())
}

/// The problem that [`Fields::need`] reports for a missing key.
pub fn missing_key(name: &str, place: &Place) -> Diagnostic {
    Diagnostic::error("missing-key", note!("yaml-key-missing", name = name), place.clone())
}
