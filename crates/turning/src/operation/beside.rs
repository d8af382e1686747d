//! What a plan says of its part beside the motions of one set-up: whoever wrote a program of that set-up, its motions are
//! judged by themselves, and everything else that the plan leaves undone or finds wrong stays true.

use crate::note::{Finding, Severity};

use super::unfinished::undone;
use super::{Operation, merged, proof};

/// What is wrong beside the motions of a set-up.
#[derive(Clone, Debug, Default)]
pub struct Beside {
    /// What other set-ups leave undone, and that nothing holds the part.
    pub left: Vec<Finding>,
    /// What else is wrong with the plan.
    pub planned: Vec<Finding>,
    /// Whether the plan fails in this set-up, so that a program which does not fail there does what the plan cannot.
    pub fails_here: bool,
}

/// What is wrong with an operation beside the motions of a set-up.
pub fn beside(operation: &Operation, set_up: u8) -> Beside {
    let is_wrong = |finding: &&Finding| finding.severity <= Severity::Wrong;
    let undone_in = |number: u8| {
        let works = operation.set_ups.iter().filter(move |work| work.set_up.number == number);
        merged(works.flat_map(undone).map(|undone| undone.finding()).collect())
    };
    let mut left = Vec::new();
    let mut here = undone_in(set_up);
    let own = operation.proven.iter().filter(|one| one.set_up == set_up);
    here.extend(merged(own.flat_map(|one| proof::findings_of(operation, one)).collect()));
    for work in &operation.set_ups {
        left.extend(work.not_held().filter(|finding| is_wrong(&finding)));
        if work.set_up.number != set_up {
            left.extend(undone_in(work.set_up.number));
        }
    }
    let planned = operation.findings.iter().filter(is_wrong);
    let planned = planned.filter(|finding| !here.contains(finding) && !left.contains(finding)).cloned().collect();
    Beside { left, planned, fails_here: here.iter().any(|finding| is_wrong(&finding)) }
}
