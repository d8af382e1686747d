//! A part with its plan and job: the reference that programs are compared with.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::error::KnowledgeError;
use crate::job::{self, Job};
use crate::knowledge::Knowledge;
use crate::motion::{Axis, MotionStep};
use crate::note;
use crate::part::Along;
use crate::plan::Plan;
use crate::program::setting::Before;
use crate::program::{Language, Setting};
use crate::shop::Shop;
use crate::units::Micrometres;

use super::{Proof, ProofInput, Tolerated, prove};

/// A part with its plan and job: the reference that programs are compared with.
#[derive(Debug)]
pub struct PlannedJob {
    /// The plan.
    pub plan: Plan,
    /// Its job.
    pub job: Job,
    tolerated: Tolerated,
    tap_word: Option<String>,
    turning_at_change: note::Severity,
    own_correctors: bool,
}

impl PlannedJob {
    /// A plan and its job, with the job's own zeros and correctors; what the control cannot do is left to another machine.
    ///
    /// # Errors
    /// The knowledge has no answer.
    pub fn of(mut plan: Plan, language: &Language, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let shop = Shop::new(&plan.part, plan.cutting, knowledge)?;
        let mut job = job::make(&plan, &shop)?;
        if language.leave(&mut plan) {
            // What the machine could not do with the tools that are left may be no fault any more.
            plan.findings.retain(|finding| !job.of_plan.contains(finding));
            job = job::make(&plan, &shop)?;
            job::tell(&mut plan, &job, &shop)?;
            note::Finding::in_order(&mut plan.findings);
        }
        let tolerated = Tolerated::read(&plan.part, knowledge)?;
        let tap_word = language.tap_word();
        let turning_at_change = language.turning_at_change();
        Ok(Self { plan, job, tolerated, tap_word, turning_at_change, own_correctors: false })
    }

    /// Zeros and offset registers missing in the setting become those of the job; operators with registers of their
    /// own may number and measure tools as they like.
    ///
    /// Other programs may have run before the one that makes the part.
    pub fn set(&mut self, setting: &mut Setting) {
        setting.before = Before::OtherPrograms;
        let mut at = 0;
        for setup in &self.job.setups {
            let own = at..at + setup.frames.len();
            at = own.end;
            for zero in setting.zeros.iter_mut().take(own.end).skip(own.start) {
                for axis in Axis::ALL {
                    setting.assumed.zeros[axis.index()] |= zero[axis.index()].is_none();
                    zero[axis.index()].get_or_insert(setup.zero.get(axis));
                }
            }
            self.of_nominal_size(setting, own);
        }
        let correctors: BTreeMap<u32, Micrometres> = self.job.correctors.iter().copied().collect();
        self.own_correctors = !setting.correctors.is_empty() && setting.correctors != correctors;
        if !self.own_correctors {
            setting.assumed.zeros[Axis::Z.index()] |= setting.correctors.is_empty();
            setting.correctors = correctors;
        }
    }

    /// Further zeros of a set-up that differ from its first by no more than the size of the blank may: on this blank they are right,
    /// and the holes are proven as on one of nominal size.
    fn of_nominal_size(&self, setting: &mut Setting, own: Range<usize>) {
        let Some(first) = setting.zeros.get(own.start).copied() else { return };
        for zero in setting.zeros.iter_mut().take(own.end).skip(own.start + 1) {
            for (axis, along) in [(Axis::X, Along::X), (Axis::Y, Along::Y)] {
                let (Some(tolerance), Some(one), Some(other)) =
                    (self.plan.part.size_tolerance(along), first[axis.index()], zero[axis.index()])
                else {
                    continue;
                };
                if (one - other).abs() <= tolerance {
                    zero[axis.index()] = Some(one);
                }
            }
        }
    }

    /// Findings because of which no program can make the part: holes without a route, a part that does not fit on the
    /// machine.
    pub fn serious(&self) -> Vec<&note::Finding> {
        let grave = |finding: &&note::Finding| finding.severity <= note::Severity::Wrong;
        let of_holes = self.plan.findings.iter().filter(|finding| finding.hole.is_some());
        of_holes.filter(grave).chain(self.job.findings.iter().filter(grave)).collect()
    }

    /// What a program of this machine leaves undone: no fault of the program, but the part is not finished by it.
    pub fn undone(&self) -> Vec<note::Finding> {
        self.job.unfinished.iter().filter_map(|one| one.finding(note::Severity::Doubtful)).collect()
    }

    /// Compares the steps of a program with the job.
    pub fn prove(&self, steps: &[MotionStep], setting: &Setting) -> Proof {
        let zeros = setting.zeros_of(&self.job);
        prove(
            steps,
            &ProofInput {
                plan: &self.plan,
                job: &self.job,
                zeros: &zeros,
                start: setting.start,
                tolerated: &self.tolerated,
                tap_word: self.tap_word.as_deref(),
                turning_at_change: self.turning_at_change,
                own_correctors: self.own_correctors,
            },
        )
    }
}
