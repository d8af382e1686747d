//! What a program of this machine leaves undone of the part: whoever runs it must not take the part for finished.

use serde::Serialize;

use crate::note::{Figure, Finding, Note, Severity};
use crate::plan::{Operation, Plan};

/// A group of holes that is not as drawn when the program has ended.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Unfinished {
    /// The group.
    pub hole: String,
    /// What is left.
    pub left: Left,
}

/// What is left of a group of holes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Left {
    /// These transitions, which the plan leaves to another machine.
    ToAnotherMachine(Vec<Operation>),
    /// Something that the plan found no tool for, as a cone or a groove: its findings tell what.
    NotAsDrawn,
    /// All of it: it has no route.
    Everything,
}

impl Unfinished {
    /// What a plan leaves undone, in its order.
    pub fn of(plan: &Plan) -> Vec<Self> {
        let mut unfinished = Vec::new();
        for hole in &plan.holes {
            let elsewhere = hole.transitions.iter().filter(|transition| transition.elsewhere);
            let elsewhere: Vec<Operation> = elsewhere.map(|transition| transition.operation).collect();
            let mut leave = |left| unfinished.push(Self { hole: hole.name.clone(), left });
            if hole.transitions.is_empty() {
                leave(Left::Everything);
                continue;
            }
            if plan.has_errors_of(&hole.name) {
                leave(Left::NotAsDrawn);
            }
            if !elsewhere.is_empty() {
                leave(Left::ToAnotherMachine(elsewhere));
            }
        }
        unfinished
    }

    /// The finding about it; of what the plan itself finds wrong there is one already.
    pub fn finding(&self, severity: Severity) -> Option<Finding> {
        let Left::ToAnotherMachine(operations) = &self.left else { return None };
        let names = Figure::operations(operations.iter().map(|operation| operation.name()));
        Some(Finding::of_hole(severity, &self.hole, Note::new("left-to-another-machine").with("operations", names)))
    }

    /// The same in letters that every control can show.
    pub fn remark(&self) -> String {
        let left = match &self.left {
            Left::ToAnotherMachine(operations) => {
                let names: Vec<String> = operations.iter().map(|it| it.name().to_ascii_uppercase()).collect();
                format!("{} LEFT TO ANOTHER MACHINE", names.join(", "))
            }
            Left::NotAsDrawn => "NOT MADE AS DRAWN".to_owned(),
            Left::Everything => "NOT MADE AT ALL".to_owned(),
        };
        format!("UNFINISHED: {}: {left}", technolog_core::ascii::ascii(&self.hole))
    }
}
