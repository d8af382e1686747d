//! Reads the question of a case: one of the kinds of questions, with its keys.

use crate::audit::{read_plan, read_plan_node, stated::Stated};
use crate::knowledge::diagnostic::{Diagnostic, Place};
use crate::knowledge::form::KeyOf;
use crate::knowledge::yaml::{Fields, Key, Node, NodeKind};
use crate::machine::Machine;
use crate::part::file::{PartFile, hole::Hole};
use crate::part::{Part, read_part, read_part_node};
use crate::plan::CuttingMethod;
use crate::program::{Language, Setting};
use crate::turning::passes::cost::Objective;
use crate::turning::workpiece::{Workpiece, read_turned, read_turned_node};
use technolog_note::{Note, note};

use super::file::CaseForm;
use super::question::{Program, Question};
use super::read::{ReadContext, Reader};
use super::{merge, table};

/// Keys of a case that belong together.
type Keys = &'static [KeyOf<CaseForm>];

/// Keys of a case about a part, and of one without a question yet.
const PLAN_KEYS: Keys = &[
    CaseForm::part,
    CaseForm::hole,
    CaseForm::cutting,
    CaseForm::table,
    CaseForm::turn,
    CaseForm::program,
    CaseForm::audit,
];

/// A key that determines the kind of question.
#[derive(Clone, Copy)]
enum QuestionKind {
    Table,
    Turn,
    Program,
    Audit,
}

/// These keys first, each with its companions; `part` also goes with `program`.
const QUESTION_KEYS: [(QuestionKind, Keys); 4] = [
    (QuestionKind::Table, &[CaseForm::table, CaseForm::given]),
    (QuestionKind::Turn, &[CaseForm::turn, CaseForm::show, CaseForm::objective]),
    (
        QuestionKind::Program,
        &[CaseForm::program, CaseForm::control, CaseForm::machine, CaseForm::setting, CaseForm::part],
    ),
    (QuestionKind::Audit, &[CaseForm::audit]),
];

/// The input of a question: a named file, or inline content.
enum Input<'n> {
    File(String, String),
    Here(&'n Node),
}

impl Reader<'_> {
    /// The question of a case, with its keys.
    pub(super) fn question(&mut self, fields: &mut Fields<'_, CaseForm>) -> (Option<Question>, Keys) {
        let questions: Vec<(&Node, QuestionKind, Keys)> = QUESTION_KEYS
            .iter()
            .filter_map(|(kind, keys)| Some((fields.take(*keys.first()?)?, *kind, *keys)))
            .collect();
        if let [(.., first), (second, _, other), ..] = questions.as_slice() {
            let name = |keys: Keys| keys.first().map(|key| key.name()).unwrap_or_default();
            let message = note!("case-two-questions-one-case", first = name(first), name = name(other));
            return (
                self.problems.error_help("two-questions", message, &second.place, note!("case-make-two-cases")),
                PLAN_KEYS,
            );
        }
        let Some((node, kind, keys)) = questions.first() else { return (self.planned(fields), PLAN_KEYS) };
        let question = match kind {
            QuestionKind::Table => {
                let given = fields.take(CaseForm::given);
                let knowledge = self.context.knowledge;
                table::Question::read(node, given, knowledge, &mut self.problems).map(Question::Table)
            }
            QuestionKind::Turn => self.turned(node, fields),
            QuestionKind::Program => self.program(node, fields),
            QuestionKind::Audit => self.audit(node).map(Box::new).map(Question::Audit),
        };
        (question, keys)
    }

    fn planned(&mut self, fields: &mut Fields<'_, CaseForm>) -> Option<Question> {
        let (part, hole) = (fields.take(CaseForm::part), fields.take(CaseForm::hole));
        let method = fields.take(CaseForm::cutting);
        let methods = [("formula", CuttingMethod::Formula), ("card", CuttingMethod::Card)];
        let method = method.map_or(Some(CuttingMethod::default()), |node| self.choice(node, &methods));
        let part = match (part, hole) {
            (None, None) => None,
            (Some(part), None) => self.part(part),
            (part, Some(hole)) => {
                let merged = self.part_of_hole(part, hole);
                merged.and_then(|whole| self.part(&whole))
            }
        };
        part.zip(method).map(|(part, method)| Question::Part { part: Box::new(part), method })
    }

    /// A part with one group of holes, of which the case writes only unusual values.
    fn part_of_hole(&mut self, part: Option<&Node>, hole: &Node) -> Option<Node> {
        let _ = self.problems.open_map(hole)?;
        let at = |kind: NodeKind| Node { kind, place: hole.place.clone() };
        let key = |text: &str| Key { text: text.to_owned(), place: hole.place.clone() };
        let text = |text: &str| at(NodeKind::Scalar { text: text.to_owned(), quoted: true });
        let origin = at(NodeKind::Seq(vec![at(NodeKind::Seq(vec![text("0"), text("0")]))]));
        let mut usual = vec![(key(Hole::name.name()), text("A"))];
        if hole.get(Hole::pattern.name()).is_none() {
            usual.push((key(Hole::at.name()), origin));
        }
        let hole = merge::over(hole, &at(NodeKind::Map(usual)));
        let part = match part {
            None => at(NodeKind::Map(Vec::new())),
            Some(part) => {
                let _ = self.problems.open_map(part)?;
                if let Some(holes) = part.get(PartFile::holes.name()) {
                    let message = note!("case-part-has-holes-case-has");
                    return self.problems.error_help(
                        "two-questions",
                        message,
                        &holes.place,
                        note!("case-leave-one-them-out"),
                    );
                }
                part.clone()
            }
        };
        let own =
            vec![(key(PartFile::part.name()), text("A")), (key(PartFile::holes.name()), at(NodeKind::Seq(vec![hole])))];
        Some(merge::over(&part, &at(NodeKind::Map(own))))
    }

    fn part(&mut self, node: &Node) -> Option<Part> {
        let knowledge = self.context.knowledge;
        match self.input(node)? {
            Input::Here(node) => read_part_node(node, knowledge, &mut self.problems),
            Input::File(path, text) => match read_part(&path, &text, knowledge) {
                Ok(part) => Some(part),
                Err(problems) => self.faults(problems),
            },
        }
    }

    fn turned(&mut self, node: &Node, fields: &mut Fields<'_, CaseForm>) -> Option<Question> {
        let knowledge = self.context.knowledge;
        let show = fields.take(CaseForm::show);
        let operation = match show {
            None => Some(false),
            Some(node) => self.choice(node, &[("passes", false), ("operation", true)]),
        };
        let aim = fields.take(CaseForm::objective);
        let read = match self.input(node)? {
            Input::Here(node) => read_turned_node(node, knowledge),
            Input::File(path, text) => read_turned(&path, &text, knowledge),
        };
        let part = match read {
            Ok(part) => part,
            Err(mistakes) => {
                self.mistakes.extend(mistakes);
                return None;
            }
        };
        let objective = match aim {
            None => Some(Objective::Path),
            Some(node) => self.objective(node, &part),
        };
        Some(Question::Turned { part: Box::new(part), operation: operation?, objective: objective? })
    }

    fn objective(&mut self, node: &Node, part: &Workpiece) -> Option<Objective> {
        let rates = part.shaft.as_ref().and_then(|shaft| shaft.rates);
        match self.choice(node, &[("path", 0), ("passes", 1), ("time", 2)])? {
            0 => Some(Objective::Path),
            1 => Some(Objective::Passes),
            _ => match rates {
                Some(rates) => Some(Objective::Time { rates }),
                None => {
                    let help = note!("case-give-shaft-rates");
                    self.problems.error_help("no-rates", note!("case-without-rates-there-no-time"), &node.place, help)
                }
            },
        }
    }

    fn program(&mut self, node: &Node, fields: &mut Fields<'_, CaseForm>) -> Option<Question> {
        let knowledge = self.context.knowledge;
        let control = fields.need(CaseForm::control, &mut self.problems);
        let names: Vec<(&str, &str)> = Language::names(knowledge).into_iter().map(|name| (name, name)).collect();
        let control = control.and_then(|node| self.choice(node, &names));
        let machine = fields.take(CaseForm::machine);
        let (setting, part) = (fields.take(CaseForm::setting), fields.take(CaseForm::part));
        let text = self.named_or_text(node).map(|(_, text)| text);
        let part = match part {
            Some(node) => self.part(node).map(Some),
            None => Some(None),
        };
        let language = control.map(|control| Language::read(control, knowledge));
        let language = match language? {
            Ok(language) => language,
            Err(error) => return self.problems.error("knowledge", Note::from(&error), &node.place),
        };
        let setting = match setting {
            None => Some(Setting::default()),
            Some(node) => self.named_or_text(node).and_then(|(name, text)| match language.setting(&name, &text) {
                Ok(setting) => Some(setting),
                Err(problems) => self.faults(problems),
            }),
        };
        let machine = match machine {
            Some(node) => Some(self.machine(node, part.as_ref()?.as_ref())?),
            None => None,
        };
        let control = control?.to_owned();
        Some(Question::Program(Box::new(Program {
            text: text?,
            language,
            control,
            machine,
            setting: setting?,
            part: part?,
        })))
    }

    fn machine(&mut self, node: &Node, part: Option<&Part>) -> Option<String> {
        let id = self.problems.text(node)?;
        if let Err(error) = Machine::find(self.context.knowledge, id) {
            return self.problems.error("unknown-machine", Note::from(&error), &node.place);
        }
        match part.filter(|part| part.machine != id) {
            Some(part) => {
                let message = note!("cli-other-machine", asked = id, own = part.machine);
                self.problems.error_help("other-machine", message, &node.place, note!("case-leave-out-machine"))
            }
            None => Some(id.to_owned()),
        }
    }

    fn audit(&mut self, node: &Node) -> Option<Stated> {
        let ReadContext { knowledge, files, .. } = self.context;
        let read = match self.input(node)? {
            Input::Here(node) => read_plan_node(node, self.file, knowledge, files),
            Input::File(path, text) => {
                // Files named by the plan are relative to the plan.
                let beside = |name: &str| files(&relative_to(&path, name));
                read_plan(&path, &text, knowledge, &beside)
            }
        };
        match read {
            Ok(stated) => Some(stated),
            Err(unreadable) => {
                self.texts.extend(unreadable.texts);
                self.faults(unreadable.problems)
            }
        }
    }

    fn faults<T>(&mut self, problems: Vec<Diagnostic>) -> Option<T> {
        self.problems.0.extend(problems);
        None
    }

    fn input<'n>(&mut self, node: &'n Node) -> Option<Input<'n>> {
        if matches!(node.kind, NodeKind::Map(_)) {
            return Some(Input::Here(node));
        }
        let path = self.problems.text(node)?.to_owned();
        let text = self.named(&path, &node.place)?;
        Some(Input::File(path, text))
    }

    /// A named file or, if the value has several lines, the text itself; with the name for places.
    fn named_or_text(&mut self, node: &Node) -> Option<(String, String)> {
        let text = self.problems.lines(node)?.to_owned();
        if text.contains('\n') {
            return Some((format!("{}:{}", self.file, node.place.line), text));
        }
        let content = self.named(&text, &node.place)?;
        Some((text, content))
    }

    fn named(&mut self, path: &str, place: &Place) -> Option<String> {
        match (self.context.files)(path) {
            Ok(text) => {
                self.texts.push((path.to_owned(), text.clone()));
                Some(text)
            }
            Err(why) => {
                let message = note!("planfile-cannot-read", path = path, why = why);
                self.problems.error_help("unreadable", message, place, note!("case-paths-relative-file-cases"))
            }
        }
    }

    fn choice<T: Copy>(&mut self, node: &Node, choices: &[(&str, T)]) -> Option<T> {
        let text = self.problems.text(node)?;
        if let Some((_, value)) = choices.iter().find(|(name, _)| *name == text) {
            return Some(*value);
        }
        let known = choices.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
        let message = note!("case-none-choices", text = text);
        self.problems.error_help("bad-value", message, &node.place, note!("case-known-here", names = known))
    }
}

/// A name relative to the folder of a file.
fn relative_to(path: &str, name: &str) -> String {
    match path.rsplit_once('/') {
        Some((folder, _)) if !name.starts_with('/') => format!("{folder}/{name}"),
        _ => name.to_owned(),
    }
}
