//! Jobs that the proof rejects with every tool that can do them: they are left out, so that what is written is safe, and
//! what they leave is told.

use crate::note::{Figure, Finding, Note, Severity};
use crate::turning::jobs::{Job, Work};

use super::unfinished::unfinished;
use super::{Operation, barred, merged, proof};

impl Operation {
    /// Leaves out one unsafe job after the other, with what stands on its work, until the proof rejects none.
    pub(super) fn leave_unsafe_out(&mut self) {
        let mut left_out = Vec::new();
        let before = merged(self.of_its_jobs());
        while let Some(finding) = self.leave_first_out() {
            left_out.push(finding);
            self.proven = proof::prove(self);
        }
        if left_out.is_empty() {
            return;
        }
        self.findings.retain(|finding| !before.contains(finding));
        left_out.extend(self.of_its_jobs());
        self.findings.extend(merged(left_out));
    }

    /// The findings that follow from what its jobs do and leave.
    fn of_its_jobs(&self) -> Vec<Finding> {
        [unfinished(self), proof::findings(self)].concat()
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
