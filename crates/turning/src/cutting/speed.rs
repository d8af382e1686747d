//! The cutting speed: by the handbook's formula, compared with the speeds used in shops; if the formula has no
//! figures for the material, the speed used in shops.

use crate::error::{KnowledgeError, Tried};
use crate::knowledge::Question;
use crate::note::{Because, Note};
use crate::practice_speed::PracticeSpeed;
use crate::tables::cutting::{BoringSpeedFor, GroovingSpeedFor, Process};
use crate::tables::practice::RoughOrFinish;
use crate::tables::rules::{Formula, LatheCut, Taken, TurningSecondOpinionFor};
use crate::tables::turning::tools::TurningSpeedAngleFor;
use crate::units::{MetresPerMinute, MillimetresPerRev, Minutes, round_to};
use technolog_cutting::{factors, figures};

use super::laws::{PowerLaw, TOOL_MATERIAL, angle, degrees, grade};
use super::{MissingFigure, TurningCut, of_tables};

/// The speed of a tool, by the depth of cut.
#[derive(Clone, Debug)]
pub(super) struct SpeedLaw<'k> {
    law: PowerLaw,
    formula: Option<LifeLaw>,
    cut: LatheCut,
    practice: Option<PracticeSpeed<'k>>,
    pub because: Vec<Because>,
}

/// The tool life of a formula.
#[derive(Clone, Copy, Debug)]
struct LifeLaw {
    life: Minutes,
    /// m of V ~ 1/T^m.
    exponent: f64,
}

/// The speed in use.
#[derive(Clone, Debug)]
pub(super) struct TakenSpeed {
    /// The speed for the tool life; without a formula the usual one of practice.
    pub computed: MetresPerMinute,
    /// The speed after the second opinion.
    pub speed: MetresPerMinute,
    /// The tool life at that speed, if the formula applies.
    lives: Option<LifeLaw>,
    /// The row of practice, and the rule if practice is taken.
    pub because: Vec<Because>,
}

impl TakenSpeed {
    /// Whether practice has changed the speed.
    pub const fn is_of_practice(&self) -> bool {
        self.computed.0.to_bits() != self.speed.0.to_bits() || self.lives.is_none()
    }

    /// The tool life at another speed: T·(V/V')^(1/m); none if no formula applies.
    pub fn life_at(&self, speed: MetresPerMinute) -> Option<Minutes> {
        let LifeLaw { life, exponent } = self.lives?;
        Some(Minutes(life.0 * libm::pow(self.computed.0 / speed.0, 1.0 / exponent)))
    }
}

impl SpeedLaw<'_> {
    /// The speed at a depth, by the rule `turning-second-opinion`.
    pub fn at(&self, depth_mm: f64, cut: &TurningCut<'_, '_>) -> Result<TakenSpeed, KnowledgeError> {
        let computed = MetresPerMinute(self.law.at(depth_mm, MetresPerMinute(1.0)));
        let stands = TakenSpeed { computed, speed: computed, lives: self.formula, because: Vec::new() };
        let Some(practice) = &self.practice else { return Ok(stands) };
        let share = computed.0 / practice.typical.0;
        let formula = if self.formula.is_some() { Formula::Own } else { Formula::None };
        let material_group = cut.material.group;
        let asked = cut.knowledge.ask(&TurningSecondOpinionFor { cut: self.cut, material_group, formula, share })?;
        let take = asked.need(self.cut.name())?.take;
        let (speed, lives) = match take {
            // Faster than the formula: its tool life does not apply to practice.
            Taken::PracticeLow if practice.lowest().is_some_and(|low| low.0 > computed.0) => (practice.low, None),
            Taken::PracticeHigh if practice.high.0 < computed.0 => (practice.high, self.formula),
            Taken::PracticeUsual if self.formula.is_some() => (practice.typical, self.formula),
            _ => (computed, self.formula),
        };
        let taken = speed != computed || take == Taken::PracticeUsual;
        let range = match self.formula {
            Some(_) => practice.beside(computed, share),
            None => Note::new("practice-range")
                .with("low", round_to(practice.low.0, 1))
                .with("high", round_to(practice.high.0, 1)),
        };
        let mut because = vec![Because::row(practice.row, range)];
        if taken {
            let note = Note::new("practice-speed").with("speed", round_to(speed.0, 1));
            because.push(Because::answer(&asked.answer, note));
        }
        Ok(TakenSpeed { computed, speed, lives, because })
    }
}

/// The speed for the tool life of `boring-parameters` (Косилова/Мещеряков т.2):
///
/// V = Cv / (T^m · t^x · s^y) · Kmv · Kpv · Kiv · Kφv, and 0.9 of it in a bore; in grooving without t, Kφv and the 0.9.
///
/// For a material whose group has no coefficients, the speed is the middle of those used in shops, times Kpv. If no
/// shop table has the material either, the figures of another group are used, and the reason names that group.
///
/// # Errors
/// A table has no figure for this material or tool.
pub(super) fn speed<'k>(
    cut: &TurningCut<'_, 'k>,
    feed: MillimetresPerRev,
    pass: RoughOrFinish,
) -> Tried<SpeedLaw<'k>, MissingFigure> {
    let (kind, practice) = if cut.tool.plunges() {
        let of = |width| PracticeSpeed::of_grooving(width, cut.material, cut.knowledge);
        (LatheCut::Groove, cut.tool.width.map(of).transpose()?.flatten())
    } else {
        let kind = if pass == RoughOrFinish::Rough { LatheCut::Rough } else { LatheCut::Finish };
        (kind, PracticeSpeed::of_turning(pass, cut.is_inner(), cut.material, cut.knowledge)?)
    };
    if let (false, Some(practice)) = (has_own(cut, feed)?, practice) {
        let (skin, reason) = of_tables(factors::surface(cut.surface, cut))?;
        let law = PowerLaw { factor: practice.typical.0 * skin, depth: 0.0, speed: 0.0 };
        return Ok(SpeedLaw { law, formula: None, cut: kind, practice: Some(practice), because: vec![reason] });
    }
    let (life, reason) = factors::single_point_life(cut.knowledge)?;
    let mut because = vec![reason];
    let figures = if cut.tool.plunges() {
        let figures = of_tables(figures::ask(|material_group| GroovingSpeedFor { material_group }, cut))?;
        figures.map(|row| ([row.cv, row.x, row.y, row.m], row.tool_grade))
    } else {
        let figures = of_tables(figures::ask(|material_group| BoringSpeedFor { material_group, feed }, cut))?;
        figures.map(|row| ([row.cv, row.x, row.y, row.m], row.tool_grade))
    };
    let ([cv, x, y, m], tool_grade) = figures.row;
    because.extend(figures.because(Note::new("speed-coefficients").with("cv", cv)));
    let mut factor = cv / (libm::pow(life.0, m) * libm::pow(feed.0, y));
    let mut corrections = vec![of_tables(factors::surface(cut.surface, cut))?];
    if figures.is_own_group() {
        corrections.push(of_tables(factors::material_speed(Process::Turning, TOOL_MATERIAL, cut))?);
    }
    corrections.extend(grade(cut, tool_grade)?);
    if !cut.tool.plunges() {
        let question = TurningSpeedAngleFor { lead_angle: degrees(cut.edge_angle()) };
        corrections.push(angle(cut, &question, |row| row.factor, "angle-speed-factor")?);
        if cut.is_inner() {
            corrections.push(factors::internal(cut.knowledge)?);
        }
    }
    for (correction, reason) in corrections {
        factor *= correction;
        because.push(reason);
    }
    let law = PowerLaw { factor, depth: -x, speed: 0.0 };
    Ok(SpeedLaw { law, formula: Some(LifeLaw { life, exponent: m }), cut: kind, practice, because })
}

/// Whether the handbook has speed coefficients for the material's own group.
fn has_own(cut: &TurningCut<'_, '_>, feed: MillimetresPerRev) -> Result<bool, KnowledgeError> {
    let material_group = cut.material.group;
    fn known<Q: Question>(question: &Q, cut: &TurningCut<'_, '_>) -> Result<bool, KnowledgeError> {
        Ok(figures::within_reach(question, cut.knowledge)?.is_some())
    }
    if cut.tool.plunges() {
        known(&GroovingSpeedFor { material_group }, cut)
    } else {
        known(&BoringSpeedFor { material_group, feed }, cut)
    }
}
