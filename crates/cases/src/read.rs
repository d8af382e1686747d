//! The file of cases: YAML to [`Case`], collecting every mistake.

use std::collections::BTreeSet;

use crate::audit::{Files, NamedText, rules};
use crate::knowledge::Knowledge;
use crate::knowledge::Word;
use crate::knowledge::diagnostic::{Place, nearest};
use crate::knowledge::form::{Form, KeyOf};
use crate::knowledge::yaml::{Node, Problems, parse};
use crate::note::{Note, Severity};
use crate::turning::shaft::Mistake;
use technolog_note::note;

use super::expected::{self, Expected, ExpectedKind};
use super::file::{CaseForm, CasesFile};
use super::question::Question;
use super::written::node as written;
use super::{Case, CaseFile, limits, merge, planned, table};

/// The context for reading a file of cases.
#[derive(Clone, Copy)]
pub struct ReadContext<'a> {
    /// The tables that are asked.
    pub knowledge: &'a Knowledge,
    /// Every code that a finding can have.
    pub codes: &'a [String],
    /// Reads the files that cases name, relative to the file of cases.
    pub files: Files<'a>,
}

impl std::fmt::Debug for ReadContext<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Around").finish_non_exhaustive()
    }
}

/// Keys that every case may have.
const COMMON: [KeyOf<CaseForm>; 4] = [CaseForm::name, CaseForm::source, CaseForm::because, CaseForm::expect];

/// Reads a file of cases. Usable cases are returned beside the mistakes.
pub fn read_cases(file: &str, text: &str, around: ReadContext<'_>) -> CaseFile {
    let (root, diagnostics) = parse(file, text);
    let mut reader =
        Reader { context: around, problems: Problems(diagnostics), mistakes: Vec::new(), texts: Vec::new(), file };
    let cases = root.map(|root| reader.file(&root)).unwrap_or_default();
    let Reader { problems, mistakes: meant, texts, .. } = reader;
    // The head is read for each case.
    let mut known = BTreeSet::new();
    let all = problems.0.into_iter().map(Mistake::Form).chain(meant);
    let mut mistakes: Vec<Mistake> = all.filter(|mistake| known.insert(identity(mistake))).collect();
    mistakes.sort_by(|a, b| a.place().cmp(&b.place()));
    CaseFile { file: file.to_owned(), cases, mistakes, texts }
}

/// A mistake with its remedy.
type IntoFigure = (Note, Option<Note>);

/// The identity of a mistake; for a mistake in the form, with its words.
fn identity(mistake: &Mistake) -> (Option<Place>, &'static str, Option<IntoFigure>) {
    let words = match mistake {
        Mistake::Form(problem) => Some((problem.message.clone(), problem.help.clone())),
        Mistake::Meaning(..) => None,
    };
    (mistake.place().cloned(), mistake.code(), words)
}

/// Reads one file.
pub(super) struct Reader<'a> {
    pub(super) context: ReadContext<'a>,
    pub(super) problems: Problems,
    /// Mistakes of turned parts, which have their own words.
    pub(super) mistakes: Vec<Mistake>,
    pub(super) texts: Vec<NamedText>,
    pub(super) file: &'a str,
}

impl Reader<'_> {
    fn file(&mut self, root: &Node) -> Vec<Case> {
        let Some(mut fields) = self.problems.map(root) else { return Vec::new() };
        let tests = fields.need(CasesFile::tests, &mut self.problems);
        for key in CasesFile::KEYS {
            let _ = fields.take(*key);
        }
        fields.finish(&mut self.problems);
        let Some(tests) = tests.and_then(|tests| self.problems.list(tests)) else { return Vec::new() };
        if tests.is_empty() {
            let message = note!("case-there-no-cases-here");
            self.problems.error_help::<()>("no-cases", message, &root.place, note!("case-write-them-under-tests"));
        }
        let head = merge::without(root, &[CasesFile::tests.name(), CaseForm::name.name(), CaseForm::expect.name()]);
        let cases = limits::cases(tests, &head, &mut self.problems).iter().enumerate();
        cases.filter_map(|(index, own)| self.case(index + 1, own, &head)).collect()
    }

    fn case(&mut self, number: usize, own: &Node, head: &Node) -> Option<Case> {
        let mistakes = self.mistakes();
        let _ = self.problems.open_map(own)?;
        let merged = merge::over(own, head);
        let mut fields = self.problems.map(&merged)?;
        let name = fields.take(CaseForm::name).and_then(|node| self.problems.name(node)).map(str::to_owned);
        let mut text = |key| fields.take(key).and_then(|node| self.problems.lines(node)).map(str::to_owned);
        let (source, because) = (text(CaseForm::source), text(CaseForm::because));
        let expected = fields.take(CaseForm::expect).map(|node| expected::read(node, &mut self.problems));
        let title = name.unwrap_or_else(|| title(own));
        let (question, known) = self.question(&mut fields);
        let known: Vec<KeyOf<CaseForm>> = COMMON.iter().chain(known).copied().collect();
        fields.finish_among(&known, &mut self.problems);
        if question.is_none() && self.mistakes() == mistakes {
            let help = note!("case-one-table-part-hole-turn");
            self.problems.error_help::<()>("no-question", note!("case-this-case-asks-nothing"), &own.place, help);
        }
        let expected = match expected {
            Some(expected) => {
                let mut expected = expected?;
                match &question {
                    Some(question) => self.fit(&mut expected, question),
                    // The faults of both are reported at once.
                    None if merged.get(CaseForm::hole.name()).is_some() => {
                        planned::fit(&expected, 1, &mut self.problems)
                    }
                    None => {}
                }
                self.codes_of(&expected);
                Some(expected)
            }
            None => None,
        };
        let question = question?;
        let sound = self.mistakes() == mistakes;
        sound.then(|| Case { number, name: title, place: own.place.clone(), source, because, question, expected })
    }

    fn mistakes(&self) -> usize {
        self.problems.0.len() + self.mistakes.len()
    }

    /// Checks an expectation against the possible answers.
    fn fit(&mut self, expected: &mut Expected, question: &Question) {
        match question {
            Question::Table(question) => {
                if let Ok(table) = self.context.knowledge.table(&question.table) {
                    table::fit(expected, table, &mut self.problems);
                }
            }
            Question::Part { part, .. } => planned::fit(expected, part.holes.len(), &mut self.problems),
            Question::Turned { .. } | Question::Program(_) | Question::Audit(_) => {}
        }
    }

    /// Checks the codes of findings that must be absent.
    fn codes_of(&mut self, expected: &Expected) {
        for list in [expected.get("findings"), expected.get("proof").and_then(|proof| proof.get("findings"))] {
            list.into_iter().for_each(|list| self.codes(list));
        }
    }

    /// A misspelt code would never be found among findings that must be absent.
    fn codes(&mut self, findings: &Expected) {
        let ExpectedKind::Some(part) = &findings.kind else { return };
        let codes = part.excluded.iter().map(|item| item.get("code").unwrap_or(item));
        let texts = codes.filter_map(|one| match &one.kind {
            ExpectedKind::Is(text) => Some((one, text)),
            _ => None,
        });
        for (one, text) in texts {
            let is_code = |word: &&str| word.bytes().all(|byte| byte.is_ascii_lowercase() || byte == b'-');
            for word in text.split_whitespace().filter(is_code) {
                let rule = || rules::all().any(|rule| rule.id == word);
                if Severity::from_word(word).is_none() && !self.context.codes.iter().any(|code| code == word) && !rule()
                {
                    let near = nearest(word, self.context.codes.iter().map(String::as_str));
                    let help = near.map_or_else(
                        || note!("case-write-severity-code-findings-format"),
                        |near| note!("cli-did-you-mean", name = near),
                    );
                    let message = note!("case-no-finding-has-code", word = word);
                    self.problems.error_help::<()>("unknown-code", message, &one.place, help);
                }
            }
        }
    }
}

/// The title of a case without a name: its question.
fn title(own: &Node) -> String {
    let keys = |node: &Node| {
        let text = written(node);
        text.strip_prefix('{').and_then(|text| text.strip_suffix('}')).map_or(text.clone(), str::to_owned)
    };
    let question_keys =
        [CaseForm::given, CaseForm::hole, CaseForm::part, CaseForm::turn, CaseForm::program, CaseForm::audit];
    let question = question_keys.into_iter().find_map(|key| own.get(key.name())).map(keys);
    match (own.get(CaseForm::table.name()).and_then(Node::text), question) {
        (Some(table), Some(given)) => format!("{table}: {given}"),
        (Some(table), None) => table.to_owned(),
        (None, question) => question.unwrap_or_default(),
    }
}
