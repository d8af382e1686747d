//! What audits of many plans share: tables are read once, parts planned once, programs interpreted once.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::machine::Machine;
use crate::memo::Memo;
use crate::motion::MotionStep;
use crate::part::Part;
use crate::plan::Plan;
use crate::planner;
use crate::program::{Fault, Language, Setting};
use crate::tables::audit::{AuditThresholds, Mistakes, Threshold};
use crate::tables::holders::HolderRow;
use crate::tooling::named::{self, NamedCutter};

use super::finding::{Audit, AuditFinding};
use super::near::Names;
use super::stated::{Program, Stated};
use super::tolerance::Tolerances;
use super::{checks, context, coverage, figures, graph, mistakes, rules, unsaid};

/// Audits plans, one after the other or many at once.
#[derive(Debug)]
pub struct Auditor<'k> {
    /// The knowledge that plans are compared with.
    pub knowledge: &'k Knowledge,
    pub(super) cutters: Names<'k, NamedCutter<'k>>,
    pub(super) holders: Names<'k, HolderRow<'k>>,
    tolerances: Tolerances,
    pub(super) mistakes: Vec<Mistakes<'k>>,
    thresholds: BTreeMap<Threshold, f64>,
    plans: Memo<Result<Arc<Plan>, KnowledgeError>>,
    runs: Memo<SimulatedProgram>,
    languages: Memo<Result<Arc<Language>, KnowledgeError>>,
}

/// The simulation of a program on a machine with the operator's setting.
#[derive(Clone, Debug)]
pub(super) struct SimulatedProgram {
    pub faults: Arc<[Fault]>,
    pub steps: Arc<[MotionStep]>,
}

impl<'k> Auditor<'k> {
    /// Reads what all audits need.
    ///
    /// # Errors
    /// The table `audit-tolerance` lacks a quantity, or a row is not what its contract says.
    pub fn new(knowledge: &'k Knowledge) -> Result<Self, KnowledgeError> {
        let cutters = named::cutter_names(knowledge)?.into_iter().map(|cutter| (cutter.designation, cutter));
        let holders = named::holders(knowledge)?.into_iter().map(|holder| (holder.designation, holder));
        Ok(Self {
            knowledge,
            cutters: Names::new(cutters),
            holders: Names::new(holders),
            tolerances: Tolerances::read(knowledge)?,
            mistakes: mistakes::read(knowledge)?,
            thresholds: knowledge.rows::<AuditThresholds<'_>>()?.iter().map(|row| (row.name, row.value)).collect(),
            plans: Memo::default(),
            runs: Memo::default(),
            languages: Memo::default(),
        })
    }

    /// Checks a plan against the knowledge. The same part is planned once.
    ///
    /// # Errors
    /// The knowledge base has no answer. A fault of the plan is a finding.
    pub fn audit(&self, stated: &Stated) -> Result<Audit, KnowledgeError> {
        let ours = self.own_plan(stated)?;
        self.audit_beside(stated, &ours)
    }

    /// The program's own plan of the same part by the same method.
    pub(super) fn own_plan(&self, stated: &Stated) -> Result<Arc<Plan>, KnowledgeError> {
        // A part that is made of a list has no holes of its own: nothing is compared with a plan of ours.
        if stated.unsaid.is_some() {
            let part = Part { holes: Vec::new(), ..stated.part.clone() };
            return planner::plan(&part, stated.method, self.knowledge).map(Arc::new);
        }
        let plan = || planner::plan(&stated.part, stated.method, self.knowledge).map(Arc::new);
        // A part that cannot be serialised cannot be compared with another, so it is planned separately.
        match serde_json::to_string(&(&stated.part, stated.method)) {
            Ok(key) => self.plans.get(key, plan),
            Err(_) => plan(),
        }
    }

    /// The language of a control, read once.
    pub(super) fn language(&self, control: &str) -> Result<Arc<Language>, KnowledgeError> {
        self.languages.get(control.to_owned(), || Language::read(control, self.knowledge).map(Arc::new))
    }

    /// A limit by the table `audit-thresholds`.
    pub fn threshold(&self, name: Threshold) -> f64 {
        self.thresholds.get(&name).copied().unwrap_or_default()
    }

    /// The rounding tolerances.
    pub(super) const fn tolerances(&self) -> &Tolerances {
        &self.tolerances
    }

    /// As [`Auditor::audit`], beside an existing plan of the program for the same part and method.
    ///
    /// # Errors
    /// As for [`Auditor::audit`].
    pub fn audit_beside(&self, stated: &Stated, ours: &Plan) -> Result<Audit, KnowledgeError> {
        let context = context::Context::new(stated, ours, self)?;
        let mut graph = graph::Graph::new(stated, &self.tolerances);
        rules::add(&context, &mut graph)?;
        super::misprints::correct(&context, &mut graph);
        rules::tools::meant_overhangs(&context, &mut graph)?;
        for formula in rules::tabulated::far_off(&context, &graph)? {
            graph.replace(formula);
        }
        let mut findings = figures::findings(&context, &graph);
        findings.extend(stated.remarks.iter().map(AuditFinding::of_remark));
        checks::all(&context, &graph, &mut findings)?;
        unsaid::leave_out(stated, self.knowledge, &mut findings)?;
        Ok(Audit::new(stated, coverage::of(stated, self.knowledge)?, findings))
    }

    /// Runs a program. The same program with the same setting is run once.
    pub(super) fn run(
        &self,
        program: &Program,
        language: &Language,
        machine: &Machine<'_>,
        setting: &Setting,
    ) -> SimulatedProgram {
        let key = format!(
            "{} {} {:?} {} {setting:?}\n{}",
            program.control, machine.table.id, machine.travel_z, machine.can_tap, program.text
        );
        self.runs.get(key, || {
            let mut steps: Vec<MotionStep> = Vec::new();
            let faults = language.check(&program.text, machine, setting, &mut steps);
            SimulatedProgram { faults: faults.into(), steps: steps.into() }
        })
    }
}
