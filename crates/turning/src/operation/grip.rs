//! How hard the jaws must hold a part, so that the heaviest cut neither turns it in them nor pulls it out.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Finding, Note, Severity};
use crate::tables::lathes::{LatheWorkholding, WorkholdingFigure as Row};
use crate::turning::cutting::{GripLimit, pull as turning_pull};
use crate::turning::jobs::{Job, Work};
use crate::units::{Micrometres, Newtons};

use super::jaws::Jaws;

/// The gripping force that a set-up requires, of all jaws together.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Grip {
    /// The diameter that the jaws grip.
    pub grips_mm: Micrometres,
    /// The largest pull of a cut at that diameter.
    pub pull_n: Newtons,
    /// What the jaws must press with.
    pub required_n: Newtons,
    /// What a chuck of that size presses with, where the size is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub given_n: Option<Newtons>,
    /// Friction of the jaws.
    pub friction: f64,
    /// The safety.
    pub safety: f64,
    /// The rows behind it.
    pub because: Vec<Because>,
}

impl Grip {
    /// What the cuts of a set-up require of its jaws; none where no force of a cut is known.
    ///
    /// At the jaws the cut pulls around with 2·M/d and along the axis with the force on that way, together
    /// √((2·M/d)² + P²), N, with the torque M in N·mm and d in mm. Friction holds it if S·pull ≤ μ·F (the form of VDI
    /// 3106 without tilting and loss by speed); S and μ are rows of `chuck-and-tailstock`, μ by hard or soft jaws.
    ///
    /// # Errors The knowledge base lacks a row.
    pub fn of(jaws: Option<&Jaws>, jobs: &[Job], knowledge: &Knowledge) -> Result<Option<Self>, KnowledgeError> {
        let Some(jaws) = jaws.filter(|jaws| jaws.grips_mm > Micrometres::ZERO) else { return Ok(None) };
        let Some(pull) = jobs.iter().filter_map(|job| pull(job, jaws.grips_mm)).max_by(f64::total_cmp) else {
            return Ok(None);
        };
        let held = Self::holds(jaws, knowledge)?;
        let Held { friction, safety, given_n, because } = held;
        let required_n = Newtons(safety * pull / friction);
        Ok(Some(Self {
            grips_mm: jaws.grips_mm,
            pull_n: Newtons(pull),
            required_n,
            given_n,
            friction,
            safety,
            because,
        }))
    }

    /// What jaws hold, as a limit of the cuts; none where the size of the chuck is not known.
    ///
    /// # Errors The knowledge base lacks a row.
    pub fn limit(jaws: Option<&Jaws>, knowledge: &Knowledge) -> Result<Option<GripLimit>, KnowledgeError> {
        let Some(jaws) = jaws.filter(|jaws| jaws.grips_mm > Micrometres::ZERO) else { return Ok(None) };
        let Held { friction, safety, given_n, because } = Self::holds(jaws, knowledge)?;
        let most = given_n.map(|given| Newtons(given.0 * friction / safety));
        Ok(most.map(|most| GripLimit { grips: jaws.grips_mm, most, because }))
    }

    /// Friction, safety and force of jaws.
    fn holds(jaws: &Jaws, knowledge: &Knowledge) -> Result<Held, KnowledgeError> {
        let mut because = Vec::new();
        let mut figure = |name: Row| -> Result<f64, KnowledgeError> {
            let row = knowledge.need(name.name(), |row: &LatheWorkholding<'_>| row.name.is(name))?;
            let note = Note::new("turning-limit").with("name", name.name()).with("value", row.value);
            because.push(Because::row(row.row, note));
            Ok(row.value)
        };
        let friction = figure(if jaws.soft { Row::JawFrictionSoft } else { Row::JawFriction })?;
        let safety = figure(Row::GripSafety)?;
        let given_n = match jaws.body {
            Some(body) => Some(Newtons(figure(Row::ChuckForce)? * body.chuck_mm.to_mm())),
            None => None,
        };
        Ok(Held { friction, safety, given_n, because })
    }

    /// Whether a usual chuck of that size presses hard enough; true where the size is not known.
    pub fn is_enough(&self) -> bool {
        self.given_n.is_none_or(|given| self.required_n.0 <= given.0)
    }

    /// What is told of it.
    pub fn note(&self) -> Note {
        Note::new("grip-required")
            .with("grips", self.grips_mm)
            .with("force", thousands(self.required_n))
            .with("pull", thousands(self.pull_n))
            .with("friction", self.friction)
            .with("safety", self.safety)
    }

    /// That a usual chuck does not press hard enough.
    pub fn finding(&self, set_up: u8) -> Option<Finding> {
        let given = self.given_n.filter(|_| !self.is_enough())?;
        let note = Note::new("grip-too-weak")
            .with("number", set_up)
            .with("grips", self.grips_mm)
            .with("force", thousands(self.required_n))
            .with("given", thousands(given));
        Some(Finding::of_part(Severity::Doubtful, note))
    }
}

/// What jaws hold with.
struct Held {
    friction: f64,
    safety: f64,
    given_n: Option<Newtons>,
    because: Vec<Because>,
}

/// Newtons as kN, to 0.1 kN.
fn thousands(force: Newtons) -> f64 {
    crate::units::round_to(force.0 / 1000.0, 1)
}

/// The pull of a job at a diameter of the jaws, N; none if its forces are not known.
fn pull(job: &Job, grips: Micrometres) -> Option<f64> {
    if let Some(torque) = job.torque_n_m {
        return Some(turning_pull(torque, Newtons(0.0), grips).0);
    }
    let conditions = job.conditions.as_ref()?;
    // Across the axis the feed is along X, and what acts along the axis is Py; a blade is fed against Py.
    let along = match job.work {
        Work::Face => conditions.radial_force_n,
        _ => conditions.axial_force_n,
    };
    Some(turning_pull(conditions.torque_n_m?, along.unwrap_or(Newtons(0.0)), grips).0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shipped;
    use crate::turning::operation::plan;
    use crate::turning::workpiece::read_workpiece;
    use crate::units::NewtonMetres;

    /// 100 N·m on Ø50 are 4000 N around, with 3000 N along the axis 5000 N.
    #[test]
    fn torque_and_axial_force_pull_together() {
        let pull = turning_pull(NewtonMetres(100.0), Newtons(3000.0), Micrometres::from_mm_rounded(50.0));
        assert!((pull.0 - 5000.0).abs() < 1e-9, "{pull:?}");
    }

    /// Hard jaws hold the blank with μ = 0.35, soft ones the finished cylinder with 0.1, both with a safety of 2; a chuck
    /// of 250 mm presses with 160·250 = 40000 N.
    #[test]
    fn a_finished_cylinder_is_held_softly() {
        let knowledge = shipped::knowledge().unwrap();
        let part = "shaft: P\nmaterial: steel-45\nblank: {kind: bar, diameter: 50, length: 80, face: 1}\n\
                    machine: 16k20f3\nouter:\n  - {from: {d: 0, z: 0}}\n  - {face: 30}\n  - {cylinder: -40}\n  - \
                    {face: 46}\n  - {cylinder: -50}\n";
        let workpiece = read_workpiece("part", part, &knowledge).unwrap();
        let operation = plan(&workpiece, &knowledge).unwrap();
        let grips: Vec<&Grip> = operation.set_ups.iter().filter_map(|set_up| set_up.grip.as_ref()).collect();
        let frictions: Vec<f64> = grips.iter().map(|grip| grip.friction).collect();
        assert_eq!(frictions, [0.35, 0.1]);
        for grip in grips {
            let required = 2.0 * grip.pull_n.0 / grip.friction;
            assert!((grip.required_n.0 - required).abs() < 1e-6);
            assert_eq!(grip.given_n, Some(Newtons(40_000.0)));
            assert_eq!(grip.is_enough(), required <= 40_000.0);
        }
        let bored: Vec<bool> = operation.set_ups.iter().map(|set_up| set_up.jaws.unwrap().bored().is_some()).collect();
        assert_eq!(bored, [false, true]);
    }
}
