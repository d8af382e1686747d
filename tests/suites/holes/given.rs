//! What tests of one hole ask of its plan.

use technolog::plan::{Plan, Transition};
use technolog::units::Micrometres;

pub fn mm(length: f64) -> Micrometres {
    Micrometres::from_mm_rounded(length)
}

/// The plan of an ordinary hole: it has no errors.
#[track_caller]
pub fn without_errors(plan: Plan, keys: &str) -> Plan {
    assert!(!plan.has_errors(), "{keys}: {:?}", plan.findings);
    plan
}

pub fn steps(plan: &Plan) -> &[Transition] {
    &plan.holes[0].transitions
}
