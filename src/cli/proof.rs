//! What `technolog check --part` adds: the part's plan and job, and what a program makes of them.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use serde::Serialize;
use technolog::error::KnowledgeError;
use technolog::job::{self, Job};
use technolog::knowledge::{Diagnostic, Knowledge, Place, Severity};
use technolog::motion::{Axis, Position, Step};
use technolog::note;
use technolog::plan::{CuttingMethod, Plan};
use technolog::program::Setting;
use technolog::program::proof::{Asked, Finding, Missing, Proof, Superfluous, Tolerated, Visit, prove};
use technolog::report::backplot::Frame;
use technolog::report::{self, grid};
use technolog::shop::Shop;
use technolog::units::Micrometres;

use super::words::Word;
use super::{CliError, Context, plan};

/// A part with its plan and job, to hold programs against.
#[derive(Debug)]
pub struct Held {
    /// The plan.
    pub plan: Plan,
    /// Its job.
    pub job: Job,
    tolerated: Tolerated,
    own_correctors: bool,
}

/// The answer for programs.
#[derive(Serialize)]
pub struct Answer<'a> {
    visits: &'a [Visit],
    missing: &'a [Missing],
    superfluous: &'a [Superfluous],
    findings: Vec<Said<'a>>,
}

#[derive(Serialize)]
struct Said<'a> {
    message: String,
    help: Option<&'static str>,
    #[serde(flatten)]
    finding: &'a Finding,
}

impl Held {
    /// Plans a part and makes its job.
    ///
    /// # Errors
    /// The part cannot be used, or the knowledge has no answer.
    pub fn make(path: &Path, knowledge: &Knowledge, context: &Context) -> Result<Self, CliError> {
        Self::of(plan::make(path, CuttingMethod::default(), knowledge, context)?, knowledge, context)
    }

    /// Zeros and correctors that the setting leaves out are set to those of the job; with correctors of his own the
    /// operator may number and measure tools in his own way.
    pub fn set(&mut self, setting: &mut Setting) {
        let job = &self.job;
        for (setup, zero) in job.setups.iter().zip(&mut setting.zeros) {
            for axis in Axis::ALL {
                zero[axis.index()].get_or_insert(setup.zero.get(axis));
            }
        }
        let correctors: BTreeMap<u32, Micrometres> = job.correctors.iter().copied().collect();
        self.own_correctors = !setting.correctors.is_empty() && setting.correctors != correctors;
        if !self.own_correctors {
            setting.correctors = correctors;
        }
    }

    /// A plan and its job, with the job's own zeros and correctors.
    ///
    /// # Errors
    /// The knowledge has no answer.
    pub fn of(plan: Plan, knowledge: &Knowledge, context: &Context) -> Result<Self, CliError> {
        let at_fault = |error: KnowledgeError| CliError::of_knowledge(&error, context.lang);
        let shop = Shop::new(&plan.part, plan.cutting, knowledge).map_err(at_fault)?;
        let job = job::make(&plan, &shop).map_err(at_fault)?;
        let tolerated = Tolerated::read(&plan.part, knowledge).map_err(at_fault)?;
        Ok(Self { plan, job, tolerated, own_correctors: false })
    }

    /// What keeps any program from making the part: holes without a route, a part that does not fit on the machine.
    pub fn serious(&self) -> Vec<&note::Finding> {
        let grave = |finding: &&note::Finding| finding.severity <= note::Severity::Wrong;
        let of_holes = self.plan.findings.iter().filter(|finding| finding.hole.is_some());
        of_holes.filter(grave).chain(self.job.findings.iter().filter(grave)).collect()
    }

    /// The part under the motions of a program.
    pub fn frame(&self) -> Frame<'_> {
        Frame::of(&self.job, &self.plan.part)
    }

    /// Holds the steps of a program against the job.
    pub fn prove(&self, steps: &[Step], setting: &Setting) -> Proof {
        let zero = |zero: &[Option<Micrometres>; 3]| {
            Position::of(Axis::ALL.map(|axis| zero[axis.index()].unwrap_or_default() + setting.shift.get(axis)))
        };
        let zeros: Vec<Position> = setting.zeros.iter().take(self.job.setups.len()).map(zero).collect();
        prove(
            steps,
            &Asked {
                plan: &self.plan,
                job: &self.job,
                zeros: &zeros,
                start: setting.start,
                tolerated: self.tolerated,
                own_correctors: self.own_correctors,
            },
        )
    }

    /// Transition by transition how many points are made of those that are needed.
    pub fn table(&self, proof: &Proof, context: &Context) -> String {
        let mut rows = Vec::new();
        for hole in &self.plan.holes {
            for (number, transition) in hole.transitions.iter().enumerate() {
                let of = |name: &str, transition: usize| name == hole.name && transition == number;
                let made = proof.visits.iter().filter(|visit| of(&visit.hole, visit.transition)).count();
                let missing = proof.missing.iter().filter(|stop| of(&stop.hole, stop.transition)).count();
                // What is done on another machine is in no job.
                if made + missing > 0 {
                    rows.push(vec![
                        hole.name.clone(),
                        report::operation_noun(transition.operation.name(), context.lang).to_owned(),
                        format!("T{}", transition.tool.number),
                        format!("{made}/{}", made + missing),
                    ]);
                }
            }
        }
        let head = [Word::Hole, Word::Transition, Word::Tool, Word::Made].map(|word| context.word(word).to_owned());
        let table = grid::table(&head, &rows, 2);
        format!("{}\n{table}", context.word(Word::ProofHead))
    }
}

/// How grave a finding is, as a diagnostic.
pub const fn shown(severity: note::Severity) -> Severity {
    match severity {
        note::Severity::Error | note::Severity::Wrong => Severity::Error,
        note::Severity::Doubtful => Severity::Warning,
        note::Severity::Note => Severity::Note,
    }
}

/// Findings about the part as diagnostics, without a place in the program.
pub fn of_part(findings: &[&note::Finding], context: &Context) -> Vec<Diagnostic> {
    let told = |finding: &&note::Finding| {
        let sentence = report::sentence(&finding.note, context.lang);
        let message = finding.hole.iter().fold(sentence, |sentence, hole| format!("{hole}: {sentence}"));
        let severity = shown(finding.severity);
        Diagnostic { severity, code: "finding", message, place: None, help: None }
    };
    findings.iter().map(told).collect()
}

/// The proof with its words.
pub fn answer<'a>(proof: &'a Proof, context: &Context) -> Answer<'a> {
    let said = |finding: &'a Finding| Said {
        message: report::sentence(&finding.note, context.lang),
        help: report::remedy(&finding.note, context.lang),
        finding,
    };
    Answer {
        visits: &proof.visits,
        missing: &proof.missing,
        superfluous: &proof.superfluous,
        findings: proof.findings.iter().map(said).collect(),
    }
}

/// The findings with the lines they are about.
pub fn diagnostics(proof: &Proof, text: &str, file: &Arc<str>, context: &Context) -> Vec<Diagnostic> {
    let lines: Vec<&str> = text.lines().collect();
    let one = |finding: &Finding| {
        let place = finding.block.map(|block| {
            let line = usize::try_from(block.line).ok().and_then(|line| lines.get(line.checked_sub(1)?));
            let width = line.map_or(1, |line| line.trim_end().chars().count().max(1));
            Place { file: file.clone(), line: block.line, column: 1, width: u32::try_from(width).unwrap_or(1) }
        });
        let sentence = report::sentence(&finding.note, context.lang);
        let message = match finding.block.and_then(|block| block.number) {
            Some(number) => format!("N{number}: {sentence}"),
            None => sentence,
        };
        let severity = shown(finding.severity);
        let help = report::remedy(&finding.note, context.lang).map(str::to_owned);
        Diagnostic { severity, code: finding.code.name(), message, place, help }
    };
    proof.findings.iter().map(one).collect()
}
