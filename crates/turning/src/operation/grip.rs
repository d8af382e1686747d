//! How hard the jaws must hold a part, so that the heaviest cut neither turns it in them nor pulls it out.

use std::ops::Range;

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Finding, Note, Severity};
use crate::tables::lathes::{LatheWorkholding, WorkholdingFigure as Row};
use crate::turning::contour::Side;
use crate::turning::cutting::{GripLimit, JawLoss, TipLimit, pull as turning_pull, tipping};
use crate::turning::jobs::{Job, Work};
use crate::turning::length::Half;
use crate::turning::program::Speed;
use crate::turning::toolpath::Purpose;
use crate::turning::zones::Feed;
use crate::units::{Micrometres, NewtonMetres, Newtons, RevsPerMinute};
use technolog_cutting::rpm_at;

use crate::turning::tooling::figure as chuck_figure;

use super::SideWork;
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
    /// The largest moment that tips the part out of them; none where a centre or a rest holds it, too.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tips_n_m: Option<NewtonMetres>,
    /// The moment that they hold for each newton of their force, mm.
    #[serde(skip)]
    seat_mm: f64,
    /// The length that they grip.
    #[serde(skip)]
    over: Half,
    /// Z of their front.
    #[serde(skip)]
    front: Half,
    /// What stands before the finished face.
    #[serde(skip)]
    ahead: Ahead,
    /// What they are loosened to before the bore is finished, where all of their force would spring it out of round, and what they are
    /// tightened to after that.
    #[serde(skip)]
    pub loosened: Option<(Newtons, Option<Newtons>)>,
    /// What the speed of the hardest job takes off that.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lost_n: Option<Newtons>,
    /// The law of that.
    #[serde(skip)]
    loss: JawLoss,
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
    /// √((2·M/d)² + P²), N, with the torque M in N·mm and d in mm. Friction holds it if S·pull ≤ μ·(F − Fc) (the form of VDI
    /// 3106), with the centrifugal force Fc of the jaws at the speed of the job; S and μ are rows of `chuck-and-tailstock`, μ by hard or
    /// soft jaws. What holds the cut at its largest diameter is held against the speed there, and the smallest diameter at its own.
    ///
    /// A part that nothing but its jaws holds is tipped out of them, too. Each of three jaws presses with F/3; against a moment M its
    /// pressure moves by half of its length a at most, and its friction acts along the axis at d/2. With the jaws as they stand worst,
    /// Σ|cos| = √3 over them: S·M ≤ F·(a + μ·d)/(2·√3) (statics; makers' manuals of chucks, such as Forkardt 3QLC, p. 28, ask for a force
    /// against tipping beside that of driving and print no more).
    ///
    /// # Errors The knowledge base lacks a row.
    pub fn of(
        jaws: Option<&Jaws>,
        alone: bool,
        jobs: &[Job],
        ahead: Ahead,
        knowledge: &Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        let Some(jaws) = jaws.filter(|jaws| jaws.grips_mm > Micrometres::ZERO) else { return Ok(None) };
        let Some(pull) = jobs.iter().filter_map(|job| pull(job, jaws.grips_mm)).max_by(f64::total_cmp) else {
            return Ok(None);
        };
        let held = Self::holds(jaws, knowledge)?;
        let seat_mm = held.seat_mm(jaws);
        let Held { friction, safety, given_n, loss, because } = held;
        let middle = middle_mm(jaws.front_mm, jaws.length_mm);
        let tips =
            jobs.iter().filter_map(|job| tips(job, middle, ahead)).max_by(|one, other| one.0.total_cmp(&other.0));
        let tips_n_m = tips.filter(|_| alone);
        let mut grip = Self {
            grips_mm: jaws.grips_mm,
            pull_n: Newtons(pull),
            required_n: Newtons(0.0),
            tips_n_m,
            seat_mm,
            over: jaws.length_mm,
            front: jaws.front_mm,
            ahead,
            loosened: None,
            lost_n: None,
            loss,
            given_n,
            friction,
            safety,
            because,
        };
        let needs = jobs.iter().filter_map(|job| grip.needs(job));
        let (held, lost) =
            needs.max_by(|one, other| (one.0 + one.1).total_cmp(&(other.0 + other.1))).unwrap_or((0.0, 0.0));
        grip.required_n = Newtons(held + lost);
        grip.lost_n = Some(Newtons(lost)).filter(|lost| lost.0 > 0.0);
        Ok(Some(grip))
    }

    /// Where the jaws are loosened and tightened, among the jobs of the set-up.
    pub fn regrips(&self, jobs: &[Job]) -> Vec<Regrip> {
        let (Some((force, tightened)), Some(bore)) = (self.loosened, finishes_bore(jobs)) else { return Vec::new() };
        let tighter = tightened.filter(|_| bore.end < jobs.len());
        let tighter = tighter.map(|force| Regrip { before: bore.end, force, loosens: false });
        std::iter::once(Regrip { before: bore.start, force, loosens: true }).chain(tighter).collect()
    }

    /// What the jaws must press with for a job alone; none if its forces are not known.
    pub fn required_by(&self, job: &Job) -> Option<Newtons> {
        self.needs(job).map(|(held, lost)| Newtons(held + lost))
    }

    /// What a job needs of the jaws while they turn, and what its speed takes off them, N. With a constant cutting speed both are
    /// followed from the largest diameter to the smallest: the torque falls with the diameter, and the speed grows up to its limit.
    fn needs(&self, job: &Job) -> Option<(f64, f64)> {
        let whole = pull(job, self.grips_mm)?;
        let tips = tips(job, middle_mm(self.front, self.over), self.ahead).filter(|_| self.tips_n_m.is_some());
        let held = self.required(whole, tips).0;
        let (speed, limit) = match job.pace.speed() {
            Some(Speed::Cutting { speed, limit }) => (speed, limit),
            Some(Speed::Spindle(rpm)) => return Some((held, self.loss.at(rpm))),
            None => return Some((held, 0.0)),
        };
        let cuts = job.path.pieces().filter(|(_, purpose)| *purpose != Purpose::Rapid).map(|(piece, _)| piece.radii());
        let (least, most) = cuts.reduce(|(least, most), (low, high)| (least.min(low), most.max(high)))?;
        let most = most.max(Half::new(1));
        let at = |share: f64| {
            let diameter = Micrometres::from_mm_rounded((2.0 * most.to_mm() * share).max(0.001));
            let rpm = RevsPerMinute(rpm_at(speed, diameter).0.min(limit.0));
            let along = pull_of(job, self.grips_mm, share).unwrap_or(whole);
            (self.required(along, tips).0, self.loss.at(rpm))
        };
        // Where the speed comes to its limit, or where the cut ends: in between the sum of both is lower than at one of the ends.
        let fastest = rpm_at(speed, most.diameter()).0 / limit.0;
        let ends = [1.0, fastest.max(least.to_mm() / most.to_mm()).min(1.0)].map(at);
        ends.into_iter().max_by(|one, other| (one.0 + one.1).total_cmp(&(other.0 + other.1)))
    }

    /// What jaws that were set to a force press with while they turn in some jobs, at the slowest speed of them.
    pub fn turning(&self, set: Newtons, jobs: &[Job]) -> Newtons {
        let slowest = |job: &Job| match job.pace.speed()? {
            Speed::Spindle(rpm) => Some(rpm.0),
            Speed::Cutting { speed, limit } => {
                let largest =
                    job.path.pieces().map(|(piece, _)| piece.radii().1).max().filter(|one| *one > Half::ZERO)?;
                Some(rpm_at(speed, largest.diameter()).0.min(limit.0))
            }
        };
        let rpm = jobs.iter().map(|job| slowest(job).unwrap_or(0.0)).min_by(f64::total_cmp).unwrap_or(0.0);
        Newtons((set.0 - self.loss.at(RevsPerMinute(rpm))).max(0.0))
    }

    /// What the jaws must press with against a pull, N, and a moment that tips the part.
    fn required(&self, pull: f64, tips: Option<NewtonMetres>) -> Newtons {
        let upright = tips.map_or(0.0, |moment| self.safety * moment.0 * 1000.0 / self.seat_mm);
        Newtons((self.safety * pull / self.friction).max(upright))
    }

    /// What jaws hold, as a limit of the cuts: the force of the chuck, or what the wall of the part bears of it; none where neither is
    /// known.
    ///
    /// # Errors The knowledge base lacks a row.
    pub fn limit(
        jaws: Option<&Jaws>,
        bears: Option<Newtons>,
        alone: bool,
        knowledge: &Knowledge,
    ) -> Result<Option<GripLimit>, KnowledgeError> {
        let Some(jaws) = jaws.filter(|jaws| jaws.grips_mm > Micrometres::ZERO) else { return Ok(None) };
        let held = Self::holds(jaws, knowledge)?;
        let seat_mm = held.seat_mm(jaws);
        let Held { friction, safety, given_n, loss, because } = held;
        let Some(given) = [given_n, bears].into_iter().flatten().min_by(|one, other| one.0.total_cmp(&other.0)) else {
            return Ok(None);
        };
        let tips = TipLimit {
            lever_mm: middle_mm(jaws.front_mm, jaws.length_mm),
            most: NewtonMetres(given.0 * seat_mm / safety / 1000.0),
            loss: loss.times(seat_mm / safety / 1000.0),
        };
        let (most, loss) = (Newtons(given.0 * friction / safety), loss.times(friction / safety));
        Ok(Some(GripLimit { grips: jaws.grips_mm, most, loss, tips: Some(tips).filter(|_| alone), because }))
    }

    /// The highest speed of the jaws: that of their chuck, where they press with all of its force, and less where the wall of the part
    /// bears less, so that the centrifugal force takes no larger share of it. None where the chuck is not known.
    ///
    /// # Errors The knowledge base lacks a row.
    pub fn fastest(
        jaws: Option<&Jaws>,
        bears: Option<Newtons>,
        knowledge: &Knowledge,
    ) -> Result<Option<RevsPerMinute>, KnowledgeError> {
        let Some((jaws, body)) = jaws.and_then(|jaws| Some((jaws, jaws.body?))) else { return Ok(None) };
        let held = Self::holds(jaws, knowledge)?;
        let own = chuck_figure(Row::ChuckSpeed, knowledge)? / body.chuck_mm.to_mm();
        let share = match (held.given_n, bears) {
            (Some(given), Some(bears)) => (bears.0 / given.0).clamp(0.0, 1.0),
            _ => 1.0,
        };
        Ok(Some(RevsPerMinute(libm::floor(own * libm::sqrt(share)))))
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
        let (given_n, loss) = match jaws.body {
            Some(body) => {
                let chuck = body.chuck_mm.to_mm();
                let given = figure(Row::ChuckForce)? * chuck;
                let (fastest, lost) = (figure(Row::ChuckSpeed)? / chuck, figure(Row::ChuckLoss)?);
                (Some(Newtons(given)), JawLoss { per_square: lost * given / (fastest * fastest) })
            }
            None => (None, JawLoss::default()),
        };
        Ok(Held { friction, safety, given_n, loss, because })
    }

    /// Whether a usual chuck of that size presses hard enough; true where the size is not known.
    pub fn is_enough(&self) -> bool {
        self.given_n.is_none_or(|given| self.required_n.0 <= given.0)
    }

    /// What is told of it.
    pub fn note(&self) -> Note {
        if let Some(moment) = self.decides_tipping() {
            return Note::new("grip-required-upright")
                .with("grips", self.grips_mm)
                .with("force", thousands(self.required_n))
                .with("moment", crate::units::round_to(moment.0, 0))
                .with("length", self.over)
                .with("safety", self.safety);
        }
        Note::new("grip-required")
            .with("grips", self.grips_mm)
            .with("force", thousands(self.required_n))
            .with("pull", thousands(self.pull_n))
            .with("friction", self.friction)
            .with("safety", self.safety)
    }

    /// The moment that tips the part, if it asks for more than what pulls at it.
    fn decides_tipping(&self) -> Option<NewtonMetres> {
        let lost = self.lost_n.unwrap_or_default().0;
        self.tips_n_m.filter(|_| self.required_n.0 - lost > self.safety * self.pull_n.0 / self.friction + 1e-6)
    }

    /// That a usual chuck does not press hard enough: doubtful within the safety, wrong beyond it, where the part would come loose by
    /// the figures themselves.
    pub fn finding(&self, set_up: u8) -> Option<Finding> {
        let given = self.given_n.filter(|_| !self.is_enough())?;
        let lost = self.lost_n.unwrap_or_default().0;
        let loose = (self.required_n.0 - lost) / self.safety + lost > given.0;
        let severity = if loose { Severity::Wrong } else { Severity::Doubtful };
        if let Some(moment) = self.decides_tipping() {
            // What the speed of the hardest job leaves of the force.
            let left = (given.0 - lost).max(0.0);
            let note = Note::new("grip-tips")
                .with("number", set_up)
                .with("grips", self.grips_mm)
                .with("length", self.over)
                .with("moment", crate::units::round_to(moment.0, 0))
                .with("safety", self.safety)
                .with("holds", crate::units::round_to(left * self.seat_mm / 1000.0, 0))
                .with("left", thousands(Newtons(left)))
                .with("given", thousands(given));
            return Some(Finding::of_part(severity, note));
        }
        let note = Note::new("grip-too-weak")
            .with("number", set_up)
            .with("grips", self.grips_mm)
            .with("force", thousands(self.required_n))
            .with("given", thousands(given));
        Some(Finding::of_part(severity, note))
    }
}

/// A stop at which the jaws are set to another force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regrip {
    /// The job before which it is.
    pub before: usize,
    /// What they press with from then on.
    pub force: Newtons,
    /// Whether that is less than before.
    pub loosens: bool,
}

impl Regrip {
    /// What the operator does.
    pub fn note(&self) -> Note {
        let code = if self.loosens { "jaws-stop-loosen" } else { "jaws-stop-tighten" };
        Note::new(code).with("force", thousands(self.force))
    }
}

/// The jobs from the first to the last that finishes the bore.
pub(super) fn finishes_bore(jobs: &[Job]) -> Option<Range<usize>> {
    let finishes = |job: &Job| job.side == Side::Inner && matches!(job.work, Work::Finish | Work::Ream);
    Some(jobs.iter().position(finishes)?..jobs.iter().rposition(finishes)? + 1)
}

/// What stands of the blank before the finished face of the free end, in the coordinates of a set-up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Ahead {
    /// Z of the end of the stock that is faced away.
    pub stock: Half,
    /// Z of the face that roughing leaves.
    pub face: Half,
}

impl Ahead {
    /// That of a set-up by its roughing.
    pub(super) fn of(sides: &[SideWork]) -> Self {
        let face = super::jobs::rough_face(sides).min(Half::ZERO);
        let zones = sides.iter().filter(|side| side.side == Side::Outer).flat_map(|side| &side.zones);
        let faced = zones.map(|work| &work.zone).filter(|zone| zone.feed == Feed::Across).map(|zone| zone.from_z);
        Self { stock: faced.min().map_or(face, |from| from.min(face)), face }
    }
}

/// What jaws hold with.
struct Held {
    friction: f64,
    safety: f64,
    given_n: Option<Newtons>,
    loss: JawLoss,
    because: Vec<Because>,
}

impl Held {
    /// The moment that jaws hold for each newton of their force, mm: (a + μ·d)/(2·√3).
    fn seat_mm(&self, jaws: &Jaws) -> f64 {
        (jaws.length_mm.to_mm() + self.friction * jaws.grips_mm.to_mm()) / (2.0 * libm::sqrt(3.0))
    }
}

/// Z of the middle of the grip, mm.
fn middle_mm(front: Half, over: Half) -> f64 {
    front.to_mm() + over.to_mm() / 2.0
}

/// The moment with which a job tips the part around the middle of the grip, where it cuts farthest out of it: facing begins at the end
/// of the stock. None if its forces are not known.
fn tips(job: &Job, middle_mm: f64, ahead: Ahead) -> Option<NewtonMetres> {
    let (main, torque, along, across) = match (job.blade, job.conditions.as_ref()) {
        (Some(blade), _) => (blade.main, blade.torque(1.0), blade.along, blade.across),
        (None, Some(conditions)) => {
            let (feed, side) = (conditions.axial_force_n?, conditions.radial_force_n?);
            let (along, across) = if job.work == Work::Face { (side, feed) } else { (feed, side) };
            (conditions.main_force_n?, conditions.torque_n_m?, along, across)
        }
        (None, None) => return None,
    };
    let cuts = job.path.moves.iter().filter(|one| one.purpose != Purpose::Rapid);
    let first = cuts.map(|one| one.to.z).min()?;
    let first = if job.work == Work::Face { ahead.stock } else { first.max(ahead.face) };
    // Torque is Pz·D/2000 by the largest diameter.
    let radius = if main.0 > 0.0 { 1000.0 * torque.0 / main.0 } else { 0.0 };
    let radius = if job.side == Side::Inner { -radius } else { radius };
    Some(tipping(main, across, along, (middle_mm - first.to_mm()).max(0.0), radius))
}

/// Newtons as kN, to 0.1 kN.
pub(super) fn thousands(force: Newtons) -> f64 {
    crate::units::round_to(force.0 / 1000.0, 1)
}

/// The pull of a job at a diameter of the jaws, N; none if its forces are not known.
fn pull(job: &Job, grips: Micrometres) -> Option<f64> {
    pull_of(job, grips, 1.0)
}

/// The same where it cuts at a share of its largest diameter.
fn pull_of(job: &Job, grips: Micrometres, share: f64) -> Option<f64> {
    if let Some(torque) = job.torque_n_m {
        return Some(turning_pull(torque, Newtons(0.0), grips).0);
    }
    if let Some(blade) = job.blade {
        return Some(turning_pull(blade.torque(share), blade.along, grips).0);
    }
    let conditions = job.conditions.as_ref()?;
    // Across the axis the feed is along X, and what acts along the axis is Py.
    let along = match job.work {
        Work::Face => conditions.radial_force_n,
        _ => conditions.axial_force_n,
    };
    let torque = NewtonMetres(conditions.torque_n_m?.0 * share);
    Some(turning_pull(torque, along.unwrap_or(Newtons(0.0)), grips).0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shipped;
    use crate::turning::operation::plan;
    use crate::turning::workpiece::read_turned;
    use crate::units::NewtonMetres;

    /// 100 N·m on Ø50 are 4000 N around, with 3000 N along the axis 5000 N.
    #[test]
    fn torque_and_axial_force_pull_together() {
        let pull = turning_pull(NewtonMetres(100.0), Newtons(3000.0), Micrometres::from_mm_rounded(50.0));
        assert!((pull.0 - 5000.0).abs() < 1e-9, "{pull:?}");
    }

    /// 1000 N down and 400 N across at 60 mm from the middle of the grip, 300 N along at a radius of 20: 60 and 24 − 6 N·m, together
    /// √(60² + 18²) = 62.64 N·m; in a bore 24 + 6: 67.08.
    #[test]
    fn a_force_far_out_tips() {
        let at = |radius| tipping(Newtons(1000.0), Newtons(400.0), Newtons(300.0), 60.0, radius).0;
        assert!((at(20.0) - 62.642).abs() < 1e-3, "{}", at(20.0));
        assert!((at(-20.0) - 67.082).abs() < 1e-3, "{}", at(-20.0));
    }

    /// A chuck of 200 mm presses with 160·200 = 32000 N and turns at 570000/200 = 2850 1/min at most, where its jaws lose 0.667 of that,
    /// 21344 N; at half of it a quarter, 5336 N. On 16М30Ф3 one of 0.625·670 = 418.75 mm turns at 1361 1/min, though the spindle
    /// has 2000, and no job is faster: facing to the axis at a constant cutting speed runs up to the limit.
    #[test]
    fn jaws_lose_by_the_square_of_the_speed() {
        let knowledge = shipped::knowledge().unwrap();
        let part = |lathe: &str| {
            format!(
                "shaft: P\nmaterial: steel-45\nblank: {{kind: bar, diameter: 150, length: 122, face: 2}}\nmachine: {lathe}\nouter:\n  - \
                 {{from: {{d: 0, z: 0}}}}\n  - {{face: 140}}\n  - {{cylinder: -40}}\n  - {{face: 146}}\n  - {{cylinder: -80}}\n"
            )
        };
        let planned = |lathe: &str| plan(&read_turned("part", &part(lathe), &knowledge).unwrap(), &knowledge).unwrap();
        let operation = planned("16a20f3");
        let grip = operation.set_ups[0].grip.as_ref().unwrap();
        for (rpm, lost) in [(2850.0, 21_344.0), (1425.0, 5336.0)] {
            assert!((grip.loss.at(RevsPerMinute(rpm)) - lost).abs() < 1.0, "{rpm}");
        }
        let operation = planned("16m30f3");
        let speeds = operation.set_ups.iter().flat_map(|set_up| &set_up.jobs).filter_map(|job| job.pace.speed());
        let limits: Vec<f64> = speeds
            .map(|speed| match speed {
                Speed::Spindle(rpm) => rpm.0,
                Speed::Cutting { limit, .. } => limit.0,
            })
            .collect();
        assert!(limits.contains(&1361.0) && limits.iter().all(|rpm| *rpm <= 1361.0), "{limits:?}");
    }

    /// Hard jaws hold the blank with μ = 0.35, soft ones the finished cylinder with 0.1, both with a safety of 2; a chuck
    /// of 250 mm presses with 160·250 = 40000 N.
    #[test]
    fn a_finished_cylinder_is_held_softly() {
        let knowledge = shipped::knowledge().unwrap();
        let part = "shaft: P\nmaterial: steel-45\nblank: {kind: bar, diameter: 50, length: 80, face: 1}\n\
                    machine: 16k20f3\nouter:\n  - {from: {d: 0, z: 0}}\n  - {face: 30}\n  - {cylinder: -40}\n  - \
                    {face: 46}\n  - {cylinder: -50}\n";
        let workpiece = read_turned("part", part, &knowledge).unwrap();
        let operation = plan(&workpiece, &knowledge).unwrap();
        let grips: Vec<&Grip> = operation.set_ups.iter().filter_map(|set_up| set_up.grip.as_ref()).collect();
        let frictions: Vec<f64> = grips.iter().map(|grip| grip.friction).collect();
        assert_eq!(frictions, [0.35, 0.1]);
        for grip in grips {
            // And what the speed takes off, within what 2280 1/min take.
            let required = 2.0 * grip.pull_n.0 / grip.friction;
            let lost = grip.lost_n.unwrap().0;
            assert!(
                lost > 0.0
                    && lost < 26_680.0
                    && grip.required_n.0 >= lost
                    && grip.required_n.0 <= required + lost + 1e-6
            );
            assert_eq!(grip.given_n, Some(Newtons(40_000.0)));
            assert_eq!(grip.is_enough(), grip.required_n.0 <= 40_000.0);
        }
        let bored: Vec<bool> = operation.set_ups.iter().map(|set_up| set_up.jaws.unwrap().bored().is_some()).collect();
        assert_eq!(bored, [false, true]);
    }
}
