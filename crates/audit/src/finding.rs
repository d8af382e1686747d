//! The results of an audit: findings as data, independent of language.

use std::collections::BTreeMap;

use serde::{Serialize, Serializer};

use crate::knowledge::diagnostic::Place;
use crate::note::{Because, Figure, IntoFigure as _, Note, Severity, Word};
use crate::plan::{CuttingMethod, Operation};
use technolog_core::lang::Lang;

use super::context::Context;
use super::coverage::Coverage;
use super::graph::Rule;
use super::marks::Marks;
use super::quantity::{Id, Quantity, Scope};
use super::stated::{Author, Remark, Stated};

/// What an audit found.
#[derive(Clone, Debug, Serialize)]
pub struct Audit {
    /// The plan's name.
    pub plan: String,
    /// Its file.
    pub file: String,
    /// Whose work it is, where the plan says so.
    #[serde(flatten)]
    pub author: Author,
    /// How many findings of each severity, in all and by section.
    pub summary: Summary,
    /// The findings by section, the most severe first.
    pub findings: Vec<AuditFinding>,
    /// How much of each of its parts is missing.
    #[serde(skip)]
    pub coverage: Vec<Coverage>,
    /// Its marks, where a scheme was given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub marks: Option<Marks>,
}

/// How many findings there are.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Summary {
    /// In all.
    #[serde(flatten)]
    pub all: Counts,
    /// By section; those without a finding are left out.
    pub sections: BTreeMap<Section, Counts>,
}

/// Findings by severity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Unsafe or impossible.
    pub error: usize,
    /// Contradicts the source or the arithmetic.
    pub wrong: usize,
    /// Allowed, but dominated or resting on unconfirmed figures.
    pub doubtful: usize,
    /// Worth knowing.
    pub note: usize,
    /// How many of them follow from others.
    pub follow: usize,
}

impl Counts {
    fn add(&mut self, finding: &AuditFinding) {
        match finding.severity {
            Severity::Error => self.error += 1,
            Severity::Wrong => self.wrong += 1,
            Severity::Doubtful => self.doubtful += 1,
            Severity::Note => self.note += 1,
        }
        self.follow += usize::from(!finding.follows_from.is_empty());
    }
}

/// A section of a plan's report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
#[allow(missing_docs)] // the headings of the report
pub enum Section {
    Route,
    Tools,
    Holders,
    Conditions,
    Clamping,
    Lengths,
    Program,
    Times,
    Missing,
}

/// A figure as people read it: what it is, and its value.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Shown {
    /// What it is.
    pub quantity: Quantity,
    /// Its value, with a decimal point.
    pub value: String,
}

/// Another figure that is wrong because of this one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Change {
    /// Its path in the plan.
    pub field: String,
    /// What it is.
    pub quantity: Quantity,
    /// As stated.
    pub stated: String,
    /// As it should be.
    pub right: String,
}

/// The keys that a part of the plan leaves out.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct MissingKeys {
    /// Which part: the number of a row, of conditions, or of a tool as `T3`; empty: the section as a whole.
    #[serde(rename = "of", skip_serializing_if = "String::is_empty")]
    pub part: String,
    /// The subject of that part.
    pub subject: Subject,
    /// The keys it lacks, as a plan file has them.
    pub keys: Vec<&'static str>,
}

/// The part of a plan that a finding concerns.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Subject {
    /// The transition.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub operation: Option<Operation>,
    /// The groups of holes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub holes: Vec<String>,
    /// The tool.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tool: Option<u32>,
}

/// What other checks need to know about a finding.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) enum FindingKind {
    /// No other check uses it.
    #[default]
    Other,
    /// A figure differs from what a rule gives.
    Formula(&'static Rule),
    /// A figure is what a rule gives, but from other figures that are slips.
    Follows(&'static Rule),
    /// An opening of a hole is not that of the drawing.
    Opening,
    /// The proof of a program says it better.
    UnlessProven,
    /// A transition has another tool than its place in the magazine.
    ToolOfTransition,
}

impl FindingKind {
    /// The rule of the figure, if there is one.
    pub const fn rule(&self) -> Option<&'static Rule> {
        match self {
            Self::Formula(rule) | Self::Follows(rule) => Some(rule),
            _ => None,
        }
    }
}

/// A finding.
#[derive(Clone, Debug, Serialize)]
pub struct AuditFinding {
    /// The rule or check that found it; stable.
    pub rule: String,
    #[serde(skip)]
    pub(super) kind: FindingKind,
    /// What of the plan it is about, as a path: `conditions.2.feed`.
    pub field: String,
    /// How grave.
    pub severity: Severity,
    /// Where in the report.
    pub section: Section,
    /// Its subject.
    pub subject: Subject,
    /// The figure it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quantity: Option<Quantity>,
    /// The file it stands in.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// The line, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
    /// The column, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<u32>,
    /// As stated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stated: Option<String>,
    /// As it should be.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub right: Option<String>,
    /// What the formula makes of the stated figures, where that is something else.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub by_stated: Option<String>,
    /// How far the stated value is from the right one, per cent of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviation_percent: Option<f64>,
    /// The formula with its figures.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub formula: String,
    /// The usual mistake that gives the stated figure, where one does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mistake: Option<Note>,
    /// Where the formula comes from; programs read it in English.
    #[serde(serialize_with = "english", skip_serializing_if = "Option::is_none")]
    pub source: Option<Note>,
    /// The name of the factor it is about.
    #[serde(skip)]
    pub factor: Option<Figure>,
    /// Whether the author went on with the right figure.
    #[serde(skip)]
    pub is_slip: bool,
    /// What the plan does not state and was taken from tables or computed.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub supplied: Vec<Shown>,
    /// The fields whose slips it follows from; it is no slip of its own then.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub follows_from: Vec<String>,
    /// What else is wrong because of it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub changes: Vec<Change>,
    /// What the plan does not state, where the finding is of that.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<MissingKeys>,
    /// What it says.
    #[serde(flatten)]
    pub note: Note,
    /// Why, where another decision of the tables says it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub reasons: Vec<Note>,
    /// The rows it rests on.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub because: Vec<Because>,
}

#[expect(clippy::ref_option, reason = "serde asks for it")]
fn english<S: Serializer>(source: &Option<Note>, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&source.as_ref().map(|source| Lang::EN.say(source)).unwrap_or_default())
}

impl AuditFinding {
    /// A finding of a check; the note's code is its rule.
    #[expect(clippy::disallowed_methods, reason = "the code is told as the rule too")]
    pub fn new(severity: Severity, section: Section, field: String, note: Note) -> Self {
        Self {
            rule: note.code().to_owned(),
            kind: FindingKind::Other,
            field,
            severity,
            section,
            subject: Subject::default(),
            quantity: None,
            file: None,
            line: None,
            column: None,
            stated: None,
            right: None,
            by_stated: None,
            deviation_percent: None,
            formula: String::new(),
            mistake: None,
            source: None,
            factor: None,
            is_slip: false,
            supplied: Vec::new(),
            follows_from: Vec::new(),
            changes: Vec::new(),
            missing: Vec::new(),
            note,
            reasons: Vec::new(),
            because: Vec::new(),
        }
    }

    /// What is to be said of how a plan is written.
    pub(super) fn of_remark(remark: &Remark) -> Self {
        let (quantity, stated) = remark.figure.clone().unzip();
        let field = quantity.map_or_else(|| "table".to_owned(), |quantity| quantity.key().to_owned());
        let mut finding = Self::new(remark.severity, remark.section, field, remark.note.clone()).at(&remark.place);
        finding.quantity = quantity;
        finding.stated = stated;
        if remark.unless_proven { finding.of_kind(FindingKind::UnlessProven) } else { finding }
    }

    /// Of that kind.
    #[must_use]
    pub(super) fn of_kind(mut self, kind: FindingKind) -> Self {
        self.kind = kind;
        self
    }

    /// Says something else; the note's code is its rule.
    #[expect(clippy::disallowed_methods, reason = "the code is told as the rule too")]
    pub(super) fn tell(&mut self, note: Note) {
        note.code().clone_into(&mut self.rule);
        self.note = note;
    }

    /// At that place.
    #[must_use]
    pub fn at(mut self, place: &Place) -> Self {
        self.file = Some(place.file.to_string());
        self.line = Some(place.line);
        self.column = Some(place.column);
        self
    }

    /// About that.
    #[must_use]
    pub fn about(mut self, subject: Subject) -> Self {
        self.subject = subject;
        self
    }

    /// With what is stated and what it should be.
    #[must_use]
    pub fn with_values(mut self, stated: impl ToString, right: impl ToString) -> Self {
        self.stated = Some(stated.to_string());
        self.right = Some(right.to_string());
        self
    }

    /// With a row it rests on.
    #[must_use]
    pub fn resting_on(mut self, because: impl IntoIterator<Item = Because>) -> Self {
        self.because.extend(because);
        self
    }

    /// Whether it is grave enough to fail the plan.
    pub fn is_wrong(&self) -> bool {
        self.severity <= Severity::Wrong
    }
}

impl Audit {
    pub(super) fn new(stated: &Stated, coverage: Vec<Coverage>, mut findings: Vec<AuditFinding>) -> Self {
        // Roots before their consequences, the most severe first, then in the order of report and file; notes last.
        findings.sort_by_key(|finding| {
            let (note, follows) = (finding.severity == Severity::Note, !finding.follows_from.is_empty());
            (note, follows, finding.severity, finding.section, finding.line, finding.column)
        });
        let mut summary = Summary::default();
        for finding in &findings {
            summary.all.add(finding);
            summary.sections.entry(finding.section).or_default().add(finding);
        }
        let (plan, file, author) = (stated.name.clone(), stated.file.clone(), stated.author.clone());
        Self { plan, file, author, summary, findings, coverage, marks: None }
    }

    /// The finding to look at first: the most severe one that follows from no other; among equals the first of the
    /// report.
    pub fn first_root(&self) -> Option<&AuditFinding> {
        let roots =
            self.findings.iter().filter(|finding| finding.severity < Severity::Note && finding.follows_from.is_empty());
        roots.min_by_key(|one| one.severity)
    }

    /// Whether the plan fails: a finding of severity error or wrong.
    pub fn has_errors(&self) -> bool {
        self.findings.iter().any(AuditFinding::is_wrong)
    }
}

impl Context<'_> {
    /// The path of a figure in the plan: `conditions.2.feed`, tools by their numbers, rows by theirs.
    pub(super) fn field(&self, id: Id) -> String {
        let key = id.key();
        match id.scope {
            Scope::Constant => key.to_owned(),
            Scope::Row(at) => format!("route.{}.{key}", self.stated.rows.get(at).map_or(0, |row| row.number)),
            Scope::Conditions(at) => {
                let factors =
                    self.stated.conditions.get(at).and_then(|conditions| conditions.factors.get(&id.quantity));
                match factors.and_then(|factors| factors.get(id.index)) {
                    Some(factor) => format!("conditions.{}.{key}.{}", at + 1, factor.name.value),
                    None => format!("conditions.{}.{key}", at + 1),
                }
            }
            Scope::Tool(at) => format!("tools.T{}.{key}", self.stated.tools.get(at).map_or(0, |tool| tool.number)),
            Scope::Clamping => format!("clamping.{key}"),
            Scope::Times => format!("times.{key}"),
        }
    }

    /// The name of a factor.
    pub(super) fn factor(&self, id: Id) -> Option<Figure> {
        let Scope::Conditions(at) = id.scope else { return None };
        let factor = self.stated.conditions.get(at)?.factors.get(&id.quantity)?.get(id.index)?;
        Some(self.stated.factor(&factor.name.value))
    }

    /// What a part of the plan is about.
    pub(super) fn subject(&self, scope: Scope) -> Subject {
        let rows = match scope {
            Scope::Row(at) => vec![at],
            Scope::Conditions(at) => {
                self.stated.conditions.get(at).map(|conditions| conditions.rows.clone()).unwrap_or_default()
            }
            _ => Vec::new(),
        };
        let tool = match scope {
            Scope::Tool(at) => self.stated.tools.get(at).map(|tool| tool.number),
            _ => None,
        };
        let rows: Vec<_> = rows.iter().filter_map(|at| self.stated.rows.get(*at)).collect();
        let mut holes: Vec<String> = Vec::new();
        for hole in rows.iter().filter_map(|row| row.hole.as_ref()) {
            if !holes.contains(&hole.value) {
                holes.push(hole.value.clone());
            }
        }
        Subject { operation: rows.first().map(|row| row.operation.value), holes, tool }
    }

    /// The report section of a figure.
    pub(super) fn section(id: Id) -> Section {
        match (id.scope, id.quantity) {
            (Scope::Row(_), _) => Section::Route,
            (Scope::Conditions(_) | Scope::Constant, _) => Section::Conditions,
            (Scope::Clamping, _) => Section::Clamping,
            (Scope::Times, _) => Section::Times,
            (
                Scope::Tool(_),
                Quantity::HolderMorse | Quantity::ClampMin | Quantity::ClampMax | Quantity::HolderLength,
            ) => Section::Holders,
            (
                Scope::Tool(_),
                Quantity::Overhang
                | Quantity::HolderUsed
                | Quantity::Assembly
                | Quantity::LongestAssembly
                | Quantity::Corrector
                | Quantity::Correction
                | Quantity::BookCorrection,
            ) => Section::Lengths,
            (Scope::Tool(_), _) => Section::Tools,
        }
    }
}

impl Stated {
    /// The name of a factor: of the card it is one of the table of corrections, else it is the author's own.
    pub(super) fn factor(&self, name: &str) -> Figure {
        match self.method {
            CuttingMethod::Card => Figure::Word(Word { vocabulary: "factor", id: name.to_owned().into() }),
            CuttingMethod::Formula => name.into_figure(),
        }
    }
}
