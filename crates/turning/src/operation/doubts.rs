//! The unconfirmed rows behind an operation: the page marks every figure that nothing confirms.

use crate::note::{Because, Finding, Note, Severity};

use super::work::ZoneWork;
use super::{Operation, SideWork};

/// A finding for every row that is not confirmed, in the order of work.
pub(super) fn doubts(operation: &Operation) -> Vec<Finding> {
    let mut rows: Vec<&Because> = operation.blank_advice.iter().map(|advice| &advice.because).collect();
    rows.extend(operation.elsewhere.iter().flat_map(|one| [&one.because, &one.because_allowance]));
    for set_up in &operation.set_ups {
        rows.push(&set_up.set_up.because);
        rows.extend(set_up.grip.iter().flat_map(|grip| &grip.because));
        let stretches = set_up.set_up.outer.iter().chain(&set_up.set_up.inner);
        rows.extend(stretches.flat_map(|stretch| &stretch.classes).map(|class| &class.because));
        rows.extend(set_up.sides.iter().flat_map(of_side));
        for job in &set_up.jobs {
            rows.extend(job.because.iter().chain(job.conditions.iter().flat_map(|conditions| &conditions.because)));
        }
    }
    let notes = rows.into_iter().filter_map(Because::doubt);
    notes.map(|note: Note| Finding::of_part(Severity::Doubtful, note)).collect()
}

fn of_side(side: &SideWork) -> Vec<&Because> {
    let allowances = side.layers.allowances.iter().filter_map(|one| one.because.as_ref());
    let hollows = side.hollows.iter().flat_map(|hollow| &hollow.zones);
    allowances.chain(side.zones.iter().chain(hollows).flat_map(of_zone)).collect()
}

fn of_zone(work: &ZoneWork) -> Vec<&Because> {
    let mut rows = vec![&work.zone.because, &work.zone.scheme.because];
    rows.extend(work.zone.parts.iter().map(|part| &part.because));
    rows.extend(work.tool.iter().flat_map(|tool| [&tool.because, &tool.because_order]));
    if let Some(limit) = work.depth.as_ref().and_then(|depth| depth.limit.as_ref()) {
        rows.extend(limit.because.iter().chain(limit.bounds.iter().flat_map(|bound| &bound.because)));
    }
    for work in &work.works {
        rows.extend(work.pace.conditions.iter().flat_map(|conditions| &conditions.because));
        rows.extend(work.transition().map(|transition| &transition.because));
    }
    rows
}
