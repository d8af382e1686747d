//! The answer to a question as the JSON value of its command, without sentences.

use serde::Serialize;
use serde_json::Value;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::machine::Machine;
use crate::motion::MotionStep;
use crate::motion::time::Clock;
use crate::plan::{CuttingMethod, Preference};
use crate::planner;
use crate::program::is_run;
use crate::program::proof::PlannedJob;
use crate::turning::{operation, ways};

use super::question::{Program, Question};
use super::{Asker, planned, table};

/// Answers.
///
/// # Errors
/// The knowledge base lacks something for the answer.
pub fn answer(question: &Question, asker: &Asker<'_>) -> Result<Value, KnowledgeError> {
    let knowledge = asker.knowledge;
    Ok(match question {
        Question::Table(table) => table::json(&table.rows(knowledge.table(&table.table)?)),
        Question::Part { part, method } => {
            let plan = planner::plan(part, *method, knowledge)?;
            planned::json(&plan, &planner::plan_by(part, *method, Preference::Tables, knowledge)?)
        }
        Question::Turned { part, operation, objective } => {
            let ways = if *operation { None } else { ways::find(part, *objective, knowledge)? };
            match ways {
                Some(ways) => value(&ways),
                None => value(&operation::plan(part, knowledge)?),
            }
        }
        Question::Program(program) => checked(program, knowledge)?,
        Question::Audit(stated) => value(&asker.auditor()?.audit(stated)?),
    })
}

fn value(answer: &impl Serialize) -> Value {
    // Answers of the program have no keys that JSON does not permit.
    serde_json::to_value(answer).unwrap_or_default()
}

/// The result of `technolog check` for a program.
fn checked(program: &Program, knowledge: &Knowledge) -> Result<Value, KnowledgeError> {
    let mut setting = program.setting.clone();
    let planned = match &program.part {
        None => None,
        Some(part) => {
            let plan = planner::plan(part, CuttingMethod::default(), knowledge)?;
            let mut planned = PlannedJob::of(plan, &program.language, knowledge)?;
            planned.set(&mut setting);
            Some(planned)
        }
    };
    let of_part = planned.as_ref().map(|planned| planned.plan.part.machine.as_str());
    let id = program.machine.as_deref().or(of_part).or_else(|| program.language.own_machine());
    setting.assumed.machine = program.machine.as_deref().or(of_part).is_none() && id.is_some();
    let machine = id.map(|id| Machine::find(knowledge, id)).transpose()?;
    let mut sink = (Vec::<MotionStep>::new(), Clock::new(machine.as_ref(), setting.start));
    let faults = program.language.check(&program.text, machine.as_ref(), &setting, &mut sink);
    let (trace, clock) = sink;
    let mut answer = serde_json::json!({
        "control": program.control,
        "machine": id,
        "findings": value(&faults),
        "trace": value(&trace),
        "time": value(&clock.known_times()),
    });
    if let (Some(planned), Some(answer)) = (&planned, answer.as_object_mut()) {
        answer.insert("part".to_owned(), value(&planned.serious()));
        if is_run(&faults, &trace) {
            answer.insert("proof".to_owned(), value(&planned.prove(&trace, &setting)));
        }
    }
    Ok(answer)
}
