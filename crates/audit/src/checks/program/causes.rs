//! Several checks may see the same fault of a program. The table `audit-program-causes` says which finding is the
//! cause and which are its consequences.

use std::collections::BTreeMap;
use technolog_note::note;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Note, Severity};
use crate::program::proof::{self, Code, DeviationFigure, Name};
use crate::program::{Fault, Subject};
use crate::tables::audit::ProgramCauses;

use super::super::super::finding::AuditFinding;
use super::super::consequences::is_of_plans;

/// A finding about a program, with the facts by which its cause is found.
#[derive(Debug)]
pub(super) struct FindingFacts {
    pub finding: AuditFinding,
    who: FindingOrigin<'static>,
    /// The tool in the spindle, where it is known.
    tool: Option<u32>,
    figures: BTreeMap<Name, DeviationFigure>,
    /// The function that the fault concerns.
    function: Option<String>,
    /// Whether the control stops at this fault.
    pub broken: bool,
}

/// The sentence of that code with the figures of a deviation.
pub(super) fn called(figures: &BTreeMap<Name, DeviationFigure>, code: &str) -> Note {
    figures.iter().fold(Note::new(code.to_owned()), |note, (name, figure)| note.with(name.name(), figure))
}

/// Which check found it, and what.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FindingOrigin<'t> {
    /// The operator's setting differs from the plan.
    Setting,
    /// The program differs from the plan.
    Proof(Code),
    /// An error or a warning of the control.
    Control(&'t str),
    /// Any error of the control that runs the program.
    AnyError,
}

/// The code of a setting that differs from the plan.
pub(super) const SETTING: &str = "audit-setting-correction";

impl<'t> FindingOrigin<'t> {
    /// As the table names it.
    fn named(name: &'t str) -> Self {
        match name {
            "fault" => Self::AnyError,
            SETTING => Self::Setting,
            _ => Code::from_name(name).map_or(Self::Control(name), Self::Proof),
        }
    }
}

/// The facts in which a cause and its consequence agree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SharedFactKind {
    Code,
    Line,
    Figure(Name),
}

/// A fact that two findings may share.
#[derive(Debug, PartialEq)]
enum SharedFact<'s> {
    Who(FindingOrigin<'s>),
    Function(&'s str),
    Figure(DeviationFigure),
}

impl FindingFacts {
    /// A setting of a tool that differs from the plan.
    pub fn of_setting(finding: AuditFinding, tool: u32) -> Self {
        let figures = BTreeMap::new();
        Self { finding, who: FindingOrigin::Setting, tool: Some(tool), figures, function: None, broken: false }
    }

    /// A deviation of the program, with its tool.
    pub fn of_deviation(finding: AuditFinding, tool: Option<u32>, deviation: proof::ProgramFinding) -> Self {
        let (who, figures) = (FindingOrigin::Proof(deviation.code), deviation.figures);
        Self { finding, who, tool, figures, function: None, broken: false }
    }

    /// A fault found by the control, with the tool in the spindle.
    pub fn of_fault(finding: AuditFinding, tool: Option<u32>, fault: &Fault) -> Self {
        let (mut figures, mut function) = (BTreeMap::new(), None);
        match &fault.subject {
            Some(Subject::Tool(number)) => _ = figures.insert(Name::Tool, DeviationFigure::Count(*number)),
            Some(Subject::Function(name)) => function = Some(name.clone()),
            Some(Subject::Missing(_)) | None => {}
        }
        // What is doubtful of another machine stops nothing.
        let broken = fault.is_error() && finding.severity == Severity::Error;
        Self { finding, who: FindingOrigin::Control(fault.code), tool, figures, function, broken }
    }

    fn is(&self, who: FindingOrigin<'_>) -> bool {
        self.who == who || self.broken && who == FindingOrigin::AnyError
    }

    fn says(&self, what: SharedFactKind) -> Option<SharedFact<'_>> {
        let count = |number: u32| SharedFact::Figure(DeviationFigure::Count(number as usize));
        match what {
            SharedFactKind::Code => {
                Some(self.function.as_deref().map_or(SharedFact::Who(self.who), SharedFact::Function))
            }
            SharedFactKind::Line => self.finding.line.map(count),
            SharedFactKind::Figure(name) => {
                let own = self.figures.get(&name).cloned().map(SharedFact::Figure);
                own.or_else(|| self.tool.filter(|_| name == Name::Tool).map(count))
            }
        }
    }
}

/// A row of the table.
struct Rule<'k> {
    cause: FindingOrigin<'k>,
    consequence: FindingOrigin<'k>,
    /// Each pair: the fact of the cause, and that of the consequence.
    alike: Vec<(SharedFactKind, SharedFactKind)>,
    /// What the cause is called together with this consequence.
    told: Option<&'k str>,
}

impl<'k> Rule<'k> {
    fn of(row: &ProgramCauses<'k>) -> Result<Self, KnowledgeError> {
        let one = |name: &str| match name {
            "code" => Ok(SharedFactKind::Code),
            "line" => Ok(SharedFactKind::Line),
            _ => Name::from_name(name).map(SharedFactKind::Figure).ok_or_else(|| {
                KnowledgeError::missing(&row.row.table.id, note!("planfile-alike-no-figure-finding", name = name))
            }),
        };
        let both = |name: &&'k str| {
            let (of_cause, of_consequence) = name.split_once('=').unwrap_or((name, name));
            Ok((one(of_cause)?, one(of_consequence)?))
        };
        let alike = row.alike.iter().flatten().map(both).collect::<Result<_, KnowledgeError>>()?;
        let (cause, consequence) = (FindingOrigin::named(row.cause), FindingOrigin::named(row.consequence));
        Ok(Self { cause, consequence, alike, told: row.told })
    }

    /// Whether two findings agree; a fact that one of them lacks agrees with anything.
    fn agree(&self, cause: &FindingFacts, consequence: &FindingFacts) -> bool {
        self.alike.iter().all(|(of_cause, of_consequence)| {
            let two = cause.says(*of_cause).zip(consequence.says(*of_consequence));
            two.is_none_or(|(cause, consequence)| cause == consequence)
        })
    }
}

/// The findings, each consequence with the place of its cause. A consequence of a slip in the plan stays one.
///
/// # Errors
/// The table cannot be read.
pub(super) fn together(seen: Vec<FindingFacts>, knowledge: &Knowledge) -> Result<Vec<AuditFinding>, KnowledgeError> {
    let rows = knowledge.rows::<ProgramCauses<'_>>()?;
    let of_programs = rows.iter().filter(|row| !is_of_plans(row));
    let rules: Vec<Rule<'_>> = of_programs.map(Rule::of).collect::<Result<_, _>>()?;
    let named: Vec<Option<(usize, Option<&str>)>> = (0..seen.len()).map(|at| cause(at, &seen, &rules)).collect();
    let causes: Vec<Option<usize>> = named.iter().map(|one| one.map(|(cause, _)| cause)).collect();
    // An exchange is told as one, of the cause that follows from nothing.
    let told = named.iter().flatten().filter_map(|(cause, told)| Some((*cause, (*told)?)));
    let told: BTreeMap<usize, Note> = told
        .filter(|(cause, _)| causes[*cause].is_none())
        .map(|(cause, told)| (cause, called(&seen[cause].figures, told)))
        .collect();
    // The fields that the cause follows from, or else the cause itself.
    let fields: Vec<Vec<String>> = seen
        .iter()
        .map(|FindingFacts { finding, .. }| match finding.follows_from.is_empty() {
            true => vec![finding.field.clone()],
            false => finding.follows_from.clone(),
        })
        .collect();
    let mut found: Vec<AuditFinding> = seen.into_iter().map(|facts| facts.finding).collect();
    for (at, note) in told {
        found[at].tell(note);
    }
    for at in 0..found.len() {
        let Some(root) = root(at, &causes).filter(|_| found[at].follows_from.is_empty()) else { continue };
        if let Some(fields) = fields.get(root) {
            found[at].follows_from.clone_from(fields);
        }
        // A cut at a wrong place may be something else; with the hole that is missing instead it is as grave as that.
        found[root].severity = found[root].severity.min(found[at].severity);
    }
    Ok(found)
}

/// The cause of a finding, the first that a row of the table names, and what it is called with it.
fn cause<'k>(at: usize, seen: &[FindingFacts], rules: &[Rule<'k>]) -> Option<(usize, Option<&'k str>)> {
    let facts = seen.get(at)?;
    for rule in rules.iter().filter(|rule| facts.is(rule.consequence)) {
        for (number, other) in seen.iter().enumerate() {
            // Of two of one id the first is the cause.
            let later = number >= at && (number == at || other.who == facts.who);
            if !later && other.is(rule.cause) && rule.agree(other, facts) {
                return Some((number, rule.told));
            }
        }
    }
    None
}

/// The first cause of a consequence.
fn root(at: usize, causes: &[Option<usize>]) -> Option<usize> {
    let mut root = causes.get(at).copied().flatten()?;
    // Two findings that name each other as cause would make an endless loop.
    for _ in 0..causes.len() {
        match causes.get(root).copied().flatten().filter(|next| *next != at) {
            Some(next) => root = next,
            None => return Some(root),
        }
    }
    None
}
