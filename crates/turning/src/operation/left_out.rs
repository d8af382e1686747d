//! Jobs that the proof rejects with every tool that can do them: they are left out, so that what is written is safe, and
//! what they leave is told.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Figure, Finding, Note, Severity};
use crate::turning::jobs::{Job, Work};

use super::{Operation, barred, proof};

impl Operation {
    /// Leaves out one unsafe job after the other, with what stands on its work, until the proof rejects none.
    pub(super) fn leave_unsafe_out(
        &mut self,
        mut planned: Vec<Finding>,
        knowledge: &Knowledge,
    ) -> Result<(), KnowledgeError> {
        let before = planned.len();
        while let Some(finding) = self.leave_first_out() {
            planned.push(finding);
            self.proven = proof::prove(self);
        }
        if planned.len() > before { self.conclude(&planned, knowledge) } else { Ok(()) }
    }

    /// Leaves out the first job that the proof rejects; its finding.
    fn leave_first_out(&mut self) -> Option<Finding> {
        let unsafe_jobs = self.set_ups.iter().zip(&self.proven).enumerate().find_map(|(index, (set_up, proven))| {
            let places = proof::unsafe_places(self, proven);
            let first = places.into_iter().min_by_key(|(block, _)| *block)?;
            Some((index, barred::index_of(set_up, first.0)?, first.1))
        });
        let (set_up, at, why) = unsafe_jobs?;
        let set_up = self.set_ups.get_mut(set_up)?;
        let job = set_up.jobs.get(at)?.clone();
        let mut index = 0;
        set_up.jobs.retain(|other| {
            index += 1;
            index - 1 != at && !(index > at && stands_on(other, &job))
        });
        let zones = set_up.sides.iter_mut().filter(|side| side.side == job.side).flat_map(|side| &mut side.zones);
        for zone in zones.filter(|zone| job.zone.is_some_and(|(number, _)| zone.zone.number >= number)) {
            zone.works.iter_mut().for_each(|work| work.taken = None);
        }
        if job.work == Work::PartOff {
            set_up.parted_mm = None;
        }
        let note = Note::new("job-left-out").with("number", set_up.set_up.number);
        let note = note.with("work", Figure::word_of("turn-does", job.work.name()));
        let note = note.with("tool", job.tool.designation.clone()).with("why", why);
        Some(Finding::of_part(Severity::Wrong, note))
    }
}

/// Whether a job needs the metal gone that another takes off: whatever follows roughing, drilling and finishing on its side.
/// Beside a groove or a thread that is not cut the next one is.
fn stands_on(job: &Job, other: &Job) -> bool {
    let prepares = match other.work {
        Work::Face
        | Work::Centre
        | Work::Drill
        | Work::Flatten
        | Work::CoreDrill
        | Work::Rough
        | Work::Countersink
        | Work::Ream
        | Work::Finish => true,
        Work::Groove | Work::Thread | Work::Tap | Work::PartOff => false,
    };
    prepares && job.side == other.side && job.work != Work::PartOff
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests look at what notes are told")]
mod tests {
    use super::super::plan::plan_without;
    use super::*;
    use crate::shipped;
    use crate::tables::turning::jobs::JobLimits;
    use crate::turning::length::Half;
    use crate::turning::workpiece::read_turned;

    /// The passes of a thread, moved 3 mm into the part, are left out: nothing is doubtful any more for their rows alone, and the turret
    /// has one tool fewer to hold.
    #[test]
    fn nothing_is_told_of_a_job_that_is_left_out() {
        let knowledge = shipped::knowledge().unwrap();
        let text = "shaft: Stud\nmaterial: steel-45\nblank: {kind: bar, diameter: 50, length: 185, face: 2}\n\
            machine: 16k20f3\nholding: chuck\nouter:\n  - {from: {d: 10, z: 0}}\n  - {face: 20}\n  - {chamfer: 2}\n  \
            - {thread: M24x1.5-6g, to: -30}\n  - {groove: thread-relief}\n  - {face: 28}\n  - {chamfer: 1}\n  \
            - {cylinder: -70}\n  - {face: 44}\n  - {chamfer: 1}\n  - {cylinder: -130}\n\
            inner:\n  - {from: {d: 10, z: 0}}\n  - {cylinder: -30}\n  - {face: 0}\n";
        let part = read_turned("stud.yaml", text, &knowledge).unwrap();
        let attempt = plan_without(&part, &[], true, &knowledge).unwrap();
        let (mut operation, planned) = (attempt.operation, attempt.planned);
        let threads = operation.set_ups.iter_mut().flat_map(|one| &mut one.jobs).find(|job| job.work == Work::Thread);
        let threads = threads.unwrap();
        for one in &mut threads.path.moves {
            one.to.radius = one.to.radius - Half::from(3.0);
        }
        operation.proven = proof::prove(&operation);
        let limits: Vec<JobLimits<'_>> = knowledge.rows().unwrap();
        let name = |number: &str| limits[number.trim().parse::<usize>().unwrap() - 1].name.name();
        // The limits that are doubtful, by their names: their rows may move.
        let doubtful = |operation: &Operation| {
            let of_limits = operation.findings.iter().map(|finding| &finding.note);
            let of_limits =
                of_limits.filter(|note| note.figure_text("table").is_some_and(|table| table == "turning-job-limits"));
            let rows: Vec<String> = of_limits.filter_map(|note| note.figure_text("row")).collect();
            rows.iter().flat_map(|rows| rows.split(',')).map(name).collect::<Vec<_>>()
        };
        let crowded =
            |operation: &Operation| operation.findings.iter().any(|one| one.note.code() == "turret-too-small");
        let pecks = ["peck-from", "peck-step", "peck-retract"];
        let threads = ["thread-entry", "thread-insert-side", "thread-run-out-grade", "thread-spring-passes"];
        assert_eq!((doubtful(&operation), crowded(&operation)), ([&pecks[..], &threads].concat(), true));
        operation.leave_unsafe_out(planned, &knowledge).unwrap();
        assert_eq!((doubtful(&operation), crowded(&operation)), (pecks.to_vec(), false));
        let left_out = operation.findings.iter().filter(|one| one.note.code() == "job-left-out");
        assert_eq!(left_out.count(), 1);
    }
}
