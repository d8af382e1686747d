//! The order of work: which tool visits which points, how long that takes, and what the textbook's rule would give.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::note::Because;
use crate::part::Point;
use crate::tables::rules::VisitingMethod;
use crate::units::{Micrometres, Minutes};

/// One tool's visit to the points of one or more groups.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ToolVisit {
    /// The tool.
    pub tool: u32,
    /// The set-up, from 1: the second is on the back face.
    pub setup: u32,
    /// What it does at each stop, in order.
    pub stops: Vec<Stop>,
    /// Time of the rapid motions of this visit, from the tool-change position and back, min.
    pub rapid_min: Minutes,
    /// The same by the book's rule, to the nearest point not yet visited, min.
    #[serde(default)]
    pub nearest_rapid_min: Minutes,
    /// Lower bound of every order of these stops, min; absent if none was computed. Equal to `rapid_min` where the path
    /// is proven the shortest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bound_min: Option<Minutes>,
    /// Length of the path from the tool-change position and back, straight from point to point, mm.
    #[serde(default)]
    pub path_mm: Micrometres,
}

/// A point and what is done there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Stop {
    /// The group of holes.
    pub hole: String,
    /// The transition of the group, from 0.
    pub transition: usize,
    /// The point.
    pub at: Point,
}

/// Where the time goes.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Times {
    /// Cutting, with approach and overrun, min.
    pub machine_min: Minutes,
    /// At feed beside the machine time: out of the holes, as reamers leave, and again over what pecking drills have drilled, min.
    #[serde(default)]
    pub feed_out_min: Minutes,
    /// Turning at the bottom, min.
    #[serde(default)]
    pub dwell_min: Minutes,
    /// Rapid motions, min.
    pub rapid_min: Minutes,
    /// Tool changes, min.
    pub tool_change_min: Minutes,
    /// The operator's hands while the program waits: loading tools, setting bars, turning the part over, min.
    #[serde(default)]
    pub hand_min: Minutes,
    /// All of it, min.
    pub total_min: Minutes,
}

impl Times {
    /// Each to the hundredth of a minute, and their sum.
    #[must_use]
    pub fn rounded(self) -> Self {
        let [machine_min, feed_out_min, dwell_min] =
            [self.machine_min, self.feed_out_min, self.dwell_min].map(|time| time.rounded(2));
        let [rapid_min, tool_change_min, hand_min] =
            [self.rapid_min, self.tool_change_min, self.hand_min].map(|time| time.rounded(2));
        let parts = [machine_min, feed_out_min, dwell_min, rapid_min, tool_change_min, hand_min];
        let total_min = parts.into_iter().sum::<Minutes>().rounded(2);
        Self { machine_min, feed_out_min, dwell_min, rapid_min, tool_change_min, hand_min, total_min }
    }
}

/// What section 1.3.1 says of visiting a group, and what both methods take. The plan itself visits in parallel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Visiting {
    /// The group of holes.
    pub hole: String,
    /// The method of the book's rule.
    pub method: VisitingMethod,
    /// Holes of the group, n.
    pub holes: usize,
    /// Its tools, m.
    pub tools: usize,
    /// The tools that the rule would change at each hole: all, or those of the finishing transitions.
    pub finishing_tools: usize,
    /// Time of one round of the group from the tool-change position and back, θ, min.
    pub round_min: Minutes,
    /// K_T = Tпар/Tпосл.
    pub ratio: f64,
    /// Tпар = m(τ+θ), which is also what the machine takes, min.
    pub book_parallel_min: Minutes,
    /// Tпосл = nmτ+θ: changing tools wherever the table stands, which this machine cannot, min.
    pub book_sequential_min: Minutes,
    /// The sequential method on this machine: each change at the tool-change position, min.
    pub sequential_min: Minutes,
    /// The quickest mixture of both on this machine; absent with two tools, which leave nothing to mix.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mixture: Option<Mixture>,
    /// The `finishing_tools` in parallel, min.
    pub finish_parallel_min: Minutes,
    /// The `finishing_tools` at each hole in turn, on this machine, min.
    pub finish_sequential_min: Minutes,
    /// The row of the rule.
    pub because: Vec<Because>,
}

/// The first tools of a group in parallel, the last ones at each hole in turn.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Mixture {
    /// How many are the last ones: at least two.
    pub sequential_tools: usize,
    /// What the whole group takes, min.
    pub time_min: Minutes,
}
