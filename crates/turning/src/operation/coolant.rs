//! Which jobs are cut dry.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::knowledge::vocabulary::Operation as Cutting;
use crate::note::{Because, Note};
use crate::tables::rules::{CoolantFor, TurningCoolantFor};
use crate::turning::jobs::{Body, Job, Work};

/// Marks the jobs that are cut dry: inserts by the rule `turning-coolant`, tools of high-speed steel on the axis by `coolant`.
///
/// # Errors
/// The knowledge base lacks a rule, or a row of it.
pub(super) fn mark_dry(jobs: &mut [Job], material_group: &str, knowledge: &Knowledge) -> Result<(), KnowledgeError> {
    for job in jobs {
        let answered = match on_axis(job) {
            Some(operation) => {
                let asked = knowledge.ask(&CoolantFor { operation, material_group })?;
                (asked.need(operation.name())?.coolant, asked.answer)
            }
            None => {
                let asked = knowledge.ask(&TurningCoolantFor { material_group })?;
                (asked.need(material_group)?.coolant, asked.answer)
            }
        };
        if let (false, answer) = answered {
            job.dry = true;
            job.notes.push(Note::new("job-dry"));
            job.because.push(Because::answer(&answer, Note::new("job-dry")));
        }
    }
    Ok(())
}

/// What a tool on the axis does; none of an insert.
const fn on_axis(job: &Job) -> Option<Cutting> {
    Some(match job.tool.body {
        Body::Insert { .. } => return None,
        Body::Drill { .. } => Cutting::Drill,
        Body::CentreDrill { .. } => Cutting::CentreDrill,
        Body::Tap { .. } => Cutting::Tap,
        Body::Reamer { .. } => match job.work {
            Work::CoreDrill => Cutting::CoreDrill,
            Work::Countersink => Cutting::Countersink,
            _ => Cutting::FinishReam,
        },
    })
}
