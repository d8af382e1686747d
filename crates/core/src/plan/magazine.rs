//! The tools of a plan: their length corrections, and what is left to another machine after all.

use std::collections::BTreeSet;

use super::{Operation, Plan, ToolPlan};

impl Plan {
    /// Leaves all transitions of an operation to another machine: they are in no sequence, and tools that nothing else
    /// needs are in no magazine; what stays keeps its number. Returns whether anything was left.
    ///
    /// The times of the plan are those of before.
    pub fn leave(&mut self, operation: Operation) -> bool {
        let mut left = BTreeSet::new();
        for hole in &mut self.holes {
            for (index, transition) in hole.transitions.iter_mut().enumerate() {
                if transition.operation == operation && !transition.elsewhere {
                    transition.elsewhere = true;
                    transition.tool.number = 0;
                    left.insert((hole.name.clone(), index));
                }
            }
        }
        for visit in &mut self.sequence {
            visit.stops.retain(|stop| !left.contains(&(stop.hole.clone(), stop.transition)));
        }
        self.sequence.retain(|visit| !visit.stops.is_empty());
        let sequence = &self.sequence;
        self.tools.retain(|tool| sequence.iter().any(|visit| visit.tool == tool.number));
        ToolPlan::correct(&mut self.tools);
        !left.is_empty()
    }
}

impl ToolPlan {
    /// The length corrections of tools: the longest is the one that the others are held against.
    pub fn correct(tools: &mut [Self]) {
        let longest = tools.iter().map(|tool| tool.length_mm).max().unwrap_or_default();
        for tool in tools {
            tool.correction_mm = tool.length_mm - longest;
            tool.book_correction_mm = longest - tool.length_mm;
        }
    }
}
