//! From a hole to its ordered transitions and their intermediate diameters.
//!
//! [`scheme::candidates`] asks the tables which schemes a hole may have, best first;
//! [`diameters::steps`] turns a scheme into steps, backwards from the finished diameter, or says by
//! which inequality it cannot. The planner takes the first candidate that everything after it accepts.

pub mod diameters;
pub mod scheme;

use crate::note::Because;
use crate::plan::Operation;
use crate::units::Micrometres;

/// A scheme a hole may have.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// `A.8` or `A.9`.
    pub table: String,
    /// The scheme of A.7 as the plan names it: `07`, `04 + centre`.
    pub scheme: String,
    /// Its transitions in order.
    pub transitions: Vec<Operation>,
    /// Whether the tables finish the hole on another machine.
    pub finish_elsewhere: bool,
    /// The rows it rests on.
    pub because: Vec<Because>,
}

/// One step of a route.
#[derive(Clone, Debug)]
pub struct Step {
    /// What is done.
    pub operation: Operation,
    /// The diameter it leaves.
    pub diameter: Micrometres,
    /// The size of the catalog's cutter, where it is ground to another size.
    pub nominal: Micrometres,
    /// The diameter before it; zero in solid metal.
    pub from: Micrometres,
    /// Passes of the same tool.
    pub passes: u32,
    /// Why.
    pub because: Vec<Because>,
}
