//! The plan file: YAML to [`Stated`], collecting every mistake.

mod conditions;
mod figures;
mod rows;
mod tools;

pub(super) use figures::{MOST, number};

use crate::knowledge::Knowledge;
use crate::knowledge::diagnostic::{Diagnostic, Severity};
use crate::knowledge::form::{Form, KeyOf};
use crate::knowledge::yaml::{Fields, Node, NodeKind, Problems, parse};
use crate::part::{Part, read_part, read_part_node};
use crate::plan::CuttingMethod;
use crate::program::Language;
use technolog_note::note;
use technolog_sheets::Sheet;

use super::file::{self, PlanFile};
use super::finding::Section;
use super::sheet::{self, columns, translate};
use super::stated::{Author, Figures, Program, Remark, Stated, StatedValue, Text};
use super::tolerance::Tolerances;
use crate::tables::audit::PlanPart;

/// Reads the files that a plan names, relative to it. An error is the reason.
pub type Files<'a> = &'a dyn Fn(&str) -> Result<String, String>;

/// A text that diagnostics may point into: its name and its content.
pub type NamedText = (String, String);

/// Why a plan could not be read.
#[derive(Debug)]
pub struct Unreadable {
    /// Every mistake.
    pub problems: Vec<Diagnostic>,
    /// The texts of the files that the plan names.
    pub texts: Vec<NamedText>,
}

/// Reads a plan, written by hand or by `technolog plan`.
///
/// # Errors
/// Every mistake of the file, each with its place and what to do.
pub fn read_plan(file: &str, text: &str, knowledge: &Knowledge, files: Files<'_>) -> Result<Stated, Unreadable> {
    read_plan_of(file, text, None, knowledge, files)
}

/// As [`read_plan`], of a part that the command line names, whatever the plan says.
///
/// # Errors
/// As for [`read_plan`].
pub fn read_plan_of(
    file: &str,
    text: &str,
    part: Option<&Part>,
    knowledge: &Knowledge,
    files: Files<'_>,
) -> Result<Stated, Unreadable> {
    read_tree(parse(file, text), Source { file, text, part }, knowledge, files)
}

/// Reads the tables of CSV or XLSX: a plan by sections, or a list of tools, of a part that the command line names, of one that the
/// tables name, or of none.
///
/// # Errors
/// Every mistake of the tables, each with its place, `file:row:column`.
pub fn read_table(
    file: &str,
    sheets: &[Sheet],
    part: Option<&Part>,
    knowledge: &Knowledge,
    files: Files<'_>,
) -> Result<Stated, Unreadable> {
    let mut problems = Problems::default();
    let tabled = sheet::read(file, sheets, part, &mut problems);
    // A column that is not known is not read: what its cells are nobody can say.
    let Some(tabled) = tabled.filter(|_| problems.0.is_empty()) else {
        return Err(Unreadable { problems: problems.0, texts: Vec::new() });
    };
    let source = Source { file, text: "", part };
    let mut stated = read_tree((Some(tabled.root), Vec::new()), source, knowledge, files)?;
    stated.is_list = tabled.is_list;
    stated.unsaid = tabled.unsaid;
    let severity = crate::note::Severity::Note;
    let remark =
        |(place, note)| Remark { place, note, severity, section: Section::Missing, figure: None, unless_proven: false };
    stated.remarks.extend(tabled.remarks.into_iter().map(remark));
    Ok(stated)
}

/// Reads a plan that stands inside another file. Files that it names are read as of [`read_plan`].
///
/// # Errors
/// Every mistake of the plan, each with its place in that file.
pub fn read_plan_node(node: &Node, file: &str, knowledge: &Knowledge, files: Files<'_>) -> Result<Stated, Unreadable> {
    read_tree((Some(node.clone()), Vec::new()), Source { file, text: "", part: None }, knowledge, files)
}

/// As [`read_plan_node`], for a file of a folder that may be something else: none where it is readable but no plan.
///
/// # Errors
/// As for [`read_plan`].
pub fn read_if_plan(
    file: &str,
    text: &str,
    knowledge: &Knowledge,
    files: Files<'_>,
) -> Result<Option<Stated>, Unreadable> {
    let (mut root, diagnostics) = parse(file, text);
    if let Some(root) = &mut root {
        translate::keys(root);
    }
    if root.as_ref().is_some_and(|root| !is_plan(root)) {
        return Ok(None);
    }
    read_tree((root, diagnostics), Source { file, text, part: None }, knowledge, files).map(Some)
}

/// Whether a file is meant as a plan: written by `technolog plan`, or with a section of a plan and no holes (part
/// files have holes). A plan without its part is one too.
fn is_plan(root: &Node) -> bool {
    let NodeKind::Map(entries) = &root.kind else { return false };
    if root.get("holes").is_some() {
        return root.get("sequence").is_some();
    }
    let own = |key: &str| PlanFile::KEYS.iter().any(|known| known.name() == key);
    let has = |key: KeyOf<PlanFile>| root.get(key.name()).is_some();
    let parts = [PlanFile::route, PlanFile::tools, PlanFile::conditions, PlanFile::clamping, PlanFile::program];
    parts.into_iter().any(has) || has(PlanFile::part) && entries.iter().all(|(key, _)| own(&key.text))
}

/// A file with its text, and the part that the command line names for it.
#[derive(Clone, Copy)]
struct Source<'a> {
    file: &'a str,
    text: &'a str,
    part: Option<&'a Part>,
}

fn read_tree(
    (root, diagnostics): (Option<Node>, Vec<Diagnostic>),
    Source { file, text, part }: Source<'_>,
    knowledge: &Knowledge,
    files: Files<'_>,
) -> Result<Stated, Unreadable> {
    // Without the table every figure is accepted; the audit itself reports that it is missing.
    let tolerances = Tolerances::read(knowledge).unwrap_or_default();
    let mut reader = Reader {
        knowledge,
        files,
        tolerances,
        problems: Problems(diagnostics),
        texts: Vec::new(),
        file,
        unread_rows: Vec::new(),
        given: part,
        remarks: Vec::new(),
    };
    let stated = root.and_then(|mut root| {
        // Only `technolog plan` writes holes at the top; a part file has them too, but no tools.
        if root.get("holes").is_some() && root.get("sequence").is_some() {
            super::own::read(&root, text, file, &mut reader.problems, knowledge)
        } else {
            translate::keys(&mut root);
            reader.plan(&root)
        }
    });
    let broken = reader.problems.0.iter().any(|problem| problem.severity == Severity::Error);
    match stated {
        Some(stated) if !broken => Ok(stated),
        _ => {
            reader.problems.0.sort_by(|a, b| a.place.cmp(&b.place));
            Err(Unreadable { problems: reader.problems.0, texts: reader.texts })
        }
    }
}

/// The parts of a plan that a key `scope` names: one, or a list.
pub(super) fn scope_of(node: &Node, problems: &mut Problems) -> Vec<PlanPart> {
    let items = match node.text() {
        Some(_) => std::slice::from_ref(node),
        None => problems.list(node).unwrap_or_default(),
    };
    let mut parts = Vec::new();
    for item in items {
        parts.extend(problems.text(item).map(str::to_owned).and_then(|text| part_of_plan(&text, item, problems)));
    }
    parts
}

fn part_of_plan(text: &str, node: &Node, problems: &mut Problems) -> Option<PlanPart> {
    let named = |text: &str| PlanPart::NAMES.iter().find(|(name, _)| *name == text).map(|(_, part)| *part);
    let known = named(text).or_else(|| named(columns::written(text, PlanPart::NAMES.iter().map(|(name, _)| *name))?));
    known.or_else(|| {
        let names: Vec<&str> = PlanPart::NAMES.iter().map(|(name, _)| *name).collect();
        let help = note!("part-may", names = names.join(", "));
        problems.error_help("bad-value", note!("part-known-here", text = text), &node.place, help)
    })
}

/// Reads one plan file.
struct Reader<'a> {
    knowledge: &'a Knowledge,
    files: Files<'a>,
    tolerances: Tolerances,
    problems: Problems,
    texts: Vec<NamedText>,
    file: &'a str,
    /// Rows of the route that were not read because of a fault: their numbers and their tools.
    unread_rows: Vec<(u32, Option<u32>)>,
    /// The part that the command line names.
    given: Option<&'a Part>,
    /// Figures that there cannot be.
    remarks: Vec<Remark>,
}

impl Reader<'_> {
    fn plan(&mut self, root: &Node) -> Option<Stated> {
        let mut fields = self.problems.map(root)?;
        let name = self.text(fields.take(PlanFile::plan)).map(|name| name.value).unwrap_or_default();
        let mut said = |key| self.text(fields.take(key)).map(|text| text.value);
        let author =
            Author { student: said(PlanFile::student), group: said(PlanFile::group), variant: said(PlanFile::variant) };
        let part = match self.given {
            // What the plan says of its part is not read.
            Some(given) => {
                let _ = fields.take(PlanFile::part);
                Some(given.clone())
            }
            None => fields.need(PlanFile::part, &mut self.problems).and_then(|node| self.part(node)),
        };
        let cutting = fields.take(PlanFile::cutting);
        let method = cutting
            .and_then(|node| self.choice(node, &[("formula", CuttingMethod::Formula), ("card", CuttingMethod::Card)]));
        let scope = fields.take(PlanFile::scope).map(|node| scope_of(node, &mut self.problems));
        let route = fields.take(PlanFile::route);
        let tools = fields.take(PlanFile::tools);
        let conditions = fields.take(PlanFile::conditions);
        let clamping = fields.take(PlanFile::clamping);
        let program = fields.take(PlanFile::program);
        let times = fields.take(PlanFile::times);
        fields.finish(&mut self.problems);

        let part = part?;
        let rows = route.map(|node| self.rows(node, &part)).unwrap_or_default();
        let tools = tools.map(|node| self.tools(node)).unwrap_or_default();
        for row in &rows {
            if let Some(tool) = &row.tool
                && !tools.is_empty()
                && !tools.iter().any(|known| known.number == tool.value)
            {
                let known: Vec<String> = tools.iter().map(|tool| format!("T{}", tool.number)).collect();
                let message = note!("planfile-no-tool-t-tools", value = tool.value);
                let help = note!("planfile-known", known = known.join(", "));
                self.problems.error_help::<()>("unknown-tool", message, &tool.place, help);
            }
        }
        let conditions = conditions.map(|node| self.conditions(node, &rows)).unwrap_or_default();
        let clamping = clamping.and_then(|node| self.clamping(node, &rows, &part));
        let program = program.and_then(|node| self.program(node));
        let times = times.map(|node| self.times(node)).unwrap_or_default();
        let name = if name.is_empty() { part.part.clone() } else { name };
        Some(Stated {
            name,
            file: self.file.to_owned(),
            part,
            method: method.unwrap_or_default(),
            scope,
            is_own: false,
            tree: None,
            rows,
            tools,
            conditions,
            clamping,
            program,
            times,
            changes: None,
            author,
            is_list: false,
            unsaid: None,
            remarks: std::mem::take(&mut self.remarks),
        })
    }

    /// The part: a path, or the part itself.
    fn part(&mut self, node: &Node) -> Option<Part> {
        if matches!(node.kind, NodeKind::Map(_)) {
            return read_part_node(node, self.knowledge, &mut self.problems);
        }
        let path = self.problems.text(node)?.to_owned();
        let text = self.named(&path, node)?;
        match read_part(&path, &text, self.knowledge) {
            Ok(part) => Some(part),
            Err(problems) => {
                self.problems.0.extend(problems);
                None
            }
        }
    }

    /// The text of a file that the plan names.
    fn named(&mut self, path: &str, node: &Node) -> Option<String> {
        match (self.files)(path) {
            Ok(text) => {
                self.texts.push((path.to_owned(), text.clone()));
                Some(text)
            }
            Err(why) => {
                let message = note!("planfile-cannot-read", path = path, why = why);
                let is_text = !why.to_lowercase().contains("utf-8");
                let help = if is_text {
                    note!("planfile-paths-relative-plan-file")
                } else {
                    note!("planfile-no-text-save-utf-text")
                };
                self.problems.error_help("unreadable", message, &node.place, help)
            }
        }
    }

    fn program(&mut self, node: &Node) -> Option<Program> {
        let mut fields = self.problems.map(node)?;
        let file_node = fields.need(file::Program::file, &mut self.problems);
        let control_node = fields.need(file::Program::control, &mut self.problems);
        let setting_node = fields.take(file::Program::setting);
        fields.finish(&mut self.problems);
        let names: Vec<(&str, &str)> = Language::names(self.knowledge).into_iter().map(|name| (name, name)).collect();
        let control = control_node.and_then(|node| self.choice(node, &names));
        let path = self.text(file_node);
        let text = path.as_ref().zip(file_node).and_then(|(path, node)| self.named(&path.value, node));
        let setting = setting_node.and_then(|node| {
            let path = self.problems.text(node)?.to_owned();
            let text = self.named(&path, node)?;
            let language = Language::read(control?, self.knowledge).ok()?;
            match language.setting(&path, &text) {
                Ok(_) => Some((path, text)),
                Err(problems) => {
                    self.problems.0.extend(problems);
                    None
                }
            }
        });
        Some(Program {
            file: path?,
            text: text?,
            control: control?.to_owned(),
            place: control_node?.place.clone(),
            setting,
            shift: crate::motion::Position::default(),
            alone: None,
        })
    }

    fn times(&mut self, node: &Node) -> Figures {
        let Some(mut fields) = self.problems.map::<file::Times>(node) else { return Figures::new() };
        let figures = self.figures(Section::Times, &mut fields);
        fields.finish(&mut self.problems);
        figures
    }

    /// A text that is not empty.
    fn text(&mut self, node: Option<&Node>) -> Option<Text> {
        let node = node?;
        let text = self.problems.name(node)?;
        if text.is_empty() {
            return self.problems.error("bad-value", note!("planfile-text-must-empty"), &node.place);
        }
        Some(StatedValue { value: text.to_owned(), place: node.place.clone() })
    }

    fn choice<T: Copy>(&mut self, node: &Node, choices: &[(&str, T)]) -> Option<T> {
        let text = self.problems.text(node)?;
        if let Some((_, value)) = choices.iter().find(|(name, _)| *name == text) {
            return Some(*value);
        }
        let meant = columns::written(text, choices.iter().map(|(name, _)| *name));
        if let Some((_, value)) = choices.iter().find(|(name, _)| Some(*name) == meant) {
            return Some(*value);
        }
        let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
        let help = match crate::knowledge::diagnostic::nearest(text, names.iter().copied()) {
            Some(near) => note!("cli-did-you-mean", name = near),
            None => note!("part-may", names = names.join(", ")),
        };
        self.problems.error_help("bad-value", note!("part-known-here", text = text), &node.place, help)
    }

    /// A field that holds a text.
    fn text_of<F>(&mut self, fields: &mut Fields<'_, F>, key: KeyOf<F>) -> Option<Text> {
        let node = fields.take(key);
        self.text(node)
    }
}
