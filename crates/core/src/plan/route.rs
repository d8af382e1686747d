//! The route of a group of holes: its source, what it holds, and the candidates it was compared with.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::note::{Because, Note};
use crate::units::{ItGrade, Micrometres, Minutes, Roughness};

use super::Operation;

/// The three independent sources of a route.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RouteSource {
    /// The scheme tables A.6 to A.10.
    Tables,
    /// The complexes of transitions A.4 and A.5.
    Complexes,
    /// The search over the states of the hole, by A.1 to A.3 and section 1.2.1.
    Search,
}

/// What of a hole a transition makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[allow(missing_docs)] // the elements of table 1.1 and section 1.1.1
pub enum Feature {
    Bore,
    Step,
    Thread,
    Cone,
    Counterbore,
    Countersink,
    Chamfer,
    Face,
}

impl Feature {
    /// All features with their names in plans.
    pub const NAMES: [(&'static str, Self); 8] = [
        ("bore", Self::Bore),
        ("step", Self::Step),
        ("thread", Self::Thread),
        ("cone", Self::Cone),
        ("counterbore", Self::Counterbore),
        ("countersink", Self::Countersink),
        ("chamfer", Self::Chamfer),
        ("face", Self::Face),
    ];

    /// Its name in plans.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, feature)| *feature == self).map_or("", |(name, _)| name)
    }
}

/// The accuracy a transition leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Achieved {
    /// The finest grade that the tables promise.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub it: Option<ItGrade>,
    /// The finest roughness that the tables promise.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub roughness: Option<Roughness>,
    /// Position of the axis, mm.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub position_mm: Option<Micrometres>,
}

/// The route of a group.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Route {
    /// Which source gave it.
    #[serde(rename = "way")]
    pub source: RouteSource,
    /// The table it was found in: `A.8`, `A.9`, `A.10`, `A.5`; of the search the rule `next-transition`.
    pub table: String,
    /// The scheme of A.7, `07` or `04 + centre`; the complex of A.5; of the search its transitions.
    pub scheme: String,
    /// Whether the tables finish the hole on a machine of another type.
    pub finish_elsewhere: bool,
    /// Whether it holds grade, roughness and position.
    pub meets: bool,
    /// The tolerance on centre distances the tables were queried with, mm.
    pub centre_tolerance_mm: Micrometres,
    /// Time of all holes of the group with the tool changes it adds to those of the other groups, min.
    pub time_min: Minutes,
    /// Cost of that time: minutes times the `minute-rate` of the machine's record, in its currency; absent if it has no
    /// `minute-rate`.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub cost: Option<f64>,
    /// By how much the runner-up is slower, min; below zero where a quicker one would take more places of a
    /// magazine that does not suffice, or misses something. Absent without a runner-up.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub margin_min: Option<Minutes>,
    /// The other routes, best first, each with why it lost: the first admissible one is the runner-up.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub alternatives: Vec<Alternative>,
    /// Every decision on the way, with its row.
    pub because: Vec<Because>,
}

impl Route {
    /// Whether the tables permit that another machine finishes the hole, by this route or by one beside it.
    pub fn may_finish_elsewhere(&self) -> bool {
        self.finish_elsewhere || self.alternatives.iter().any(Alternative::finishes_elsewhere)
    }

    /// The best feasible route among those that were not taken.
    pub fn runner_up(&self) -> Option<&Alternative> {
        self.alternatives.iter().find(|other| other.time_min.is_some())
    }
}

/// A transition of a route that was not taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
pub struct AlternativeStep {
    /// What is done.
    pub operation: Operation,
    /// The diameter it leaves, mm.
    pub diameter_mm: Micrometres,
    /// Whether it would be done on another machine.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub elsewhere: bool,
}

/// A route that was not taken.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Alternative {
    /// Which source gave it.
    #[serde(rename = "way")]
    pub source: RouteSource,
    /// Its table.
    pub table: String,
    /// Its scheme.
    pub scheme: String,
    /// Its transitions with the diameters they leave, where they could be found.
    pub operations: Vec<AlternativeStep>,
    /// Its time as of [`Route::time_min`]; absent when it cannot be carried out.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub time_min: Option<Minutes>,
    /// Places of the magazine it would add.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub new_tools: Option<usize>,
    /// Whether it holds grade, roughness and position.
    pub meets: bool,
    /// Why it lost.
    pub why: Note,
}

impl Alternative {
    /// Whether it leaves cutting to another machine, more than a thread.
    pub fn finishes_elsewhere(&self) -> bool {
        self.operations.iter().any(|made| made.elsewhere && made.operation != Operation::Tap)
    }
}
