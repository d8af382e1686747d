//! Reads the common parts of all files of turned parts: names, materials, choices and lengths, with their mistakes.

use crate::knowledge::Knowledge;
use crate::knowledge::diagnostic::{Diagnostic, Place, Severity};
use crate::knowledge::form::KeyOf;
use crate::knowledge::yaml::{Fields, Node, Problems};
use crate::material::{self, MaterialState};
use crate::note::Note;
use crate::turning::tooling::Lathe;
use crate::turning::workpiece::Drawings;
use crate::units::Micrometres;
use technolog_core::machine;
use technolog_core::part::stated;

/// The largest length or diameter of a file, mm: sums of passes stay exact.
pub(super) const LARGEST: Micrometres = Micrometres::from_mm(100_000);

/// A mistake of a file of a turned part.
#[derive(Clone, Debug)]
pub enum Mistake {
    /// In the form of the file: how it is written.
    Form(Diagnostic),
    /// A mistake of content, with its code, which is also that of the note; the words are in the message catalogue.
    Meaning(&'static str, Note, Place),
}

impl Mistake {
    /// Its place.
    pub const fn place(&self) -> Option<&Place> {
        match self {
            Self::Form(diagnostic) => diagnostic.place.as_ref(),
            Self::Meaning(_, _, place) => Some(place),
        }
    }

    /// Its code.
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Form(diagnostic) => diagnostic.code,
            Self::Meaning(code, ..) => code,
        }
    }
}

/// The code of a mistake of content, and its sentence: `mistake!("unknown-lathe", lathe = text)`.
macro_rules! mistake {
    ($code:expr $(, $name:ident = $value:expr)* $(,)?) => {{
        let code: &'static str = $code;
        (code, technolog_note::note!(code $(, $name = $value)*))
    }};
}
pub(super) use mistake;

/// A value with its place.
pub(super) type Placed<T> = (T, Place);

/// What is read of a key that may be left out: nothing if it stands there and is a mistake.
pub(super) fn given<N, T>(node: Option<N>, read: impl FnOnce(N) -> Option<T>) -> Option<Option<T>> {
    node.map_or(Some(None), |node| read(node).map(Some))
}

/// Reads a file and collects every mistake of it.
pub(super) struct Reader<'a> {
    pub(super) knowledge: &'a Knowledge,
    /// The files that contours of the file name.
    pub(super) drawings: &'a Drawings,
    pub(super) problems: Problems,
    pub(super) meant: Vec<Mistake>,
}

impl<'a> Reader<'a> {
    /// A reader for a tree, with the problems of its text.
    pub(super) fn over(problems: Vec<Diagnostic>, drawings: &'a Drawings, knowledge: &'a Knowledge) -> Self {
        Self { knowledge, drawings, problems: Problems(problems), meant: Vec::new() }
    }

    /// The result, or every mistake in the order of the file.
    pub(super) fn close<T>(self, read: Option<T>) -> Result<T, Vec<Mistake>> {
        let Self { problems, meant, .. } = self;
        let broken = !meant.is_empty() || problems.0.iter().any(|problem| problem.severity == Severity::Error);
        match read {
            Some(read) if !broken => Ok(read),
            _ => {
                let form = problems.0.into_iter().map(Mistake::Form);
                let mut all: Vec<Mistake> = form.chain(meant).collect();
                all.sort_by(|a, b| a.place().cmp(&b.place()));
                Err(all)
            }
        }
    }

    /// Adds a mistake of content. Returns none, for a value that could not be read.
    pub(super) fn fault<T>(&mut self, (code, note): (&'static str, Note), place: &Place) -> Option<T> {
        self.meant.push(Mistake::Meaning(code, note, place.clone()));
        None
    }

    pub(super) fn name(&mut self, node: &Node) -> Option<String> {
        let text = self.problems.text(node)?.trim();
        if text.is_empty() {
            return self.fault(mistake!("empty-name"), &node.place);
        }
        Some(text.to_owned())
    }

    /// A material by its name, or by its name and state.
    pub(super) fn stated_material(&mut self, node: &Node) -> Option<(String, Option<MaterialState>)> {
        let grade = stated::grade(node).and_then(|node| self.material(node));
        let state = stated::state(node, grade.as_deref(), &mut self.problems, self.knowledge)?;
        Some((grade?, state))
    }

    /// The id of a material, from the id itself or an alias.
    pub(super) fn material(&mut self, node: &Node) -> Option<String> {
        let text = self.problems.text(node)?.to_owned();
        match material::named(self.knowledge, &text) {
            Ok(id) => Some(id),
            Err(Some(near)) => self.fault(mistake!("unknown-material-near", material = text, near = near), &node.place),
            Err(None) => self.fault(mistake!("unknown-material", material = text), &node.place),
        }
    }

    /// The id of a lathe, from the id itself or as the workshop calls it: `16К20Ф3`.
    pub(super) fn lathe(&mut self, node: &Node) -> Option<String> {
        let text = self.problems.text(node)?.to_owned();
        let known = Lathe::ids(self.knowledge);
        let id = machine::id_of(&text);
        if known.contains(&id.as_str()) {
            return Some(id);
        }
        let known = known.iter().map(|id| format!("`{id}`")).collect::<Vec<_>>().join(", ");
        self.fault(mistake!("unknown-lathe", lathe = text, known = known), &node.place)
    }

    pub(super) fn choice<T: Copy>(&mut self, node: &Node, choices: &[(&str, T)]) -> Option<T> {
        let text = self.problems.text(node)?.to_owned();
        if let Some((_, value)) = choices.iter().find(|(name, _)| *name == text) {
            return Some(*value);
        }
        let known = choices.iter().map(|(name, _)| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        self.fault(mistake!("no-such-choice", word = text, known = known), &node.place)
    }

    /// A length above zero, with its place.
    pub(super) fn length(&mut self, node: Option<&Node>, key: &str) -> Option<Placed<Micrometres>> {
        let node = node?;
        let length = self.problems.scalar::<Micrometres>(node)?;
        if length <= Micrometres::ZERO {
            return self.fault(mistake!("not-above-zero", key = key, length = length), &node.place);
        }
        if length > LARGEST {
            return self.fault(mistake!("length-too-large", key = key, length = length, most = LARGEST), &node.place);
        }
        Some((length, node.place.clone()))
    }

    pub(super) fn need<F>(&mut self, fields: &mut Fields<'_, F>, key: KeyOf<F>) -> Option<Placed<Micrometres>> {
        let node = fields.need(key, &mut self.problems);
        self.length(node, key.name())
    }
}
