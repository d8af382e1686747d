//! The limits of tool and lathe. Every limit compares a load, which grows with the depth of cut, with a capacity.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use technolog_note::note;

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::note::{Because, Figure, Finding, IntoFigure, Note, Severity};
use crate::tables::lathes::LatheQuantity as Q;
use crate::tables::rules::TurningChipWidthFor;
use crate::tables::turning::tools::{InsertEdgeShare, Limit, TurningLimits};
use crate::turning::length::Half;
use crate::turning::tooling::{Shank, TurningTool};
use crate::units::{Kilowatts, MetresPerMinute, Micrometres, MillimetresPerRev, NewtonMetres, Newtons, RevsPerMinute};
use technolog_cutting::rpm_at;

use super::conditions::BladeForce;
use super::laws::{self, Component, ForceLaw};
use super::{BarTooLong, CuttingRefusal, Direction, Flexibility, MissingFigure, TurningCut};

technolog_knowledge::vocabulary! {
    /// A limit of the depth of cut.
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum Bound {
        /// The bending stress of the shank is too large.
        ShankStrength = "shank-strength",
        /// The deflection of the tip is too large.
        ShankStiffness = "shank-stiffness",
        /// The edge of the insert is too short.
        InsertEdge = "insert-edge",
        /// The chip would be too wide for its thickness to break.
        ChipWidth = "chip-width",
        /// The main force is too large for the carriage.
        CuttingForce = "cutting-force",
        /// The drive along the feed is too weak.
        FeedForce = "feed-force",
        /// The drive across the feed is too weak to hold the tool.
        SideForce = "side-force",
        /// The torque of the spindle is too small.
        SpindleTorque = "spindle-torque",
        /// The power of the main drive is too small.
        SpindlePower = "spindle-power",
        /// The deflection of the part is too large.
        PartStiffness = "part-stiffness",
        /// The bending stress of the part is too large.
        PartStrength = "part-strength",
        /// The pull of the cut is more than the jaws hold.
        Grip = "grip",
        /// The cut tips the part out of the jaws.
        Tipping = "tipping",
        /// The depth would be more than the radius of the part.
        PartRadius = "part-radius",
        /// The end of the handbook's feeds and formulas.
        Handbook = "handbook",
    }
}

impl Bound {
    /// Several of them, for a note.
    pub fn list(bounds: &[Self]) -> Figure {
        Figure::list(bounds.iter().map(|bound| Figure::word(bound.name())))
    }
}

/// A load or a capacity, with its unit in its name.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Load {
    /// A force.
    ForceN(Newtons),
    /// A torque.
    TorqueNM(NewtonMetres),
    /// A power.
    PowerKw(Kilowatts),
    /// A depth of cut, if the limit is a depth.
    DepthMm(Micrometres),
}

impl Load {
    /// Whether it is within a capacity of its own kind.
    pub fn within(self, capacity: Self) -> bool {
        match (self, capacity) {
            (Self::ForceN(load), Self::ForceN(capacity)) => load.0 <= capacity.0,
            (Self::TorqueNM(load), Self::TorqueNM(capacity)) => load.0 <= capacity.0,
            (Self::PowerKw(load), Self::PowerKw(capacity)) => load.0 <= capacity.0,
            (Self::DepthMm(load), Self::DepthMm(capacity)) => load <= capacity,
            _ => false,
        }
    }

    /// How many times a force is a capacity; none of other loads.
    pub fn over(self, capacity: Self) -> Option<f64> {
        match (self, capacity) {
            (Self::ForceN(load), Self::ForceN(capacity)) => Some(load.0 / capacity.0),
            _ => None,
        }
    }

    /// As it is printed: forces to 1 N, torques to 0.1 N·m, powers to 0.01 kW.
    #[must_use]
    pub fn rounded(self) -> Self {
        match self {
            Self::ForceN(force) => Self::ForceN(force.rounded(0)),
            Self::TorqueNM(torque) => Self::TorqueNM(torque.rounded(1)),
            Self::PowerKw(power) => Self::PowerKw(power.rounded(2)),
            Self::DepthMm(depth) => Self::DepthMm(depth),
        }
    }
}

/// A limit that could not be calculated, and the missing figure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct UnknownBound {
    /// The bound.
    pub bound: Bound,
    /// The missing figure and its place.
    #[serde(rename = "note")]
    #[schemars(with = "Note")]
    pub why: MissingFigure,
}

impl UnknownBound {
    /// As a finding: depths are given without the limits that need the figure.
    pub fn finding(&self) -> Finding {
        Finding::of_part(Severity::Note, self.missing(Note::new("bound-not-reckoned")))
    }

    /// A sentence with the limit, the missing figure, and its owner.
    pub(super) fn noted(&self, note: Note) -> Note {
        self.missing(note.with("bound", Figure::word(self.bound.name())))
    }

    fn missing(&self, note: Note) -> Note {
        let (of, what) = self.why.names();
        let of = Figure::word_of("machine", of.to_owned());
        note.with("of", of).with("what", Figure::word_of("characteristic", what.to_owned()))
    }
}

/// The load of a limit.
#[derive(Clone, Copy, Debug)]
enum Measure {
    Force(Component),
    /// The main force and a component across the part, together.
    Across(Component),
    /// The main force and the component along the axis, together, at the diameter that the jaws grip, and what the speed takes off
    /// their friction.
    Pull(Component, Micrometres, JawLoss),
    /// The moment that tips the part out of the jaws: of the main force and the components across and along the axis, at a distance
    /// from the middle of the grip, mm, and what the speed takes off the moment that they hold.
    Tip(Component, Component, f64, JawLoss),
    Torque,
    Power,
    Depth,
}

/// A bound with its capacity.
#[derive(Clone, Debug)]
pub(super) struct Check {
    pub bound: Bound,
    measure: Measure,
    pub capacity: Load,
    pub because: Vec<Because>,
}

/// The forces of a cut at a feed, where their figures are known.
#[derive(Clone, Debug)]
pub(super) struct Forces {
    pub feed: MillimetresPerRev,
    pub main: Result<ForceLaw, MissingFigure>,
    pub radial: Result<ForceLaw, MissingFigure>,
    pub axial: Result<ForceLaw, MissingFigure>,
}

impl Forces {
    pub fn of(cut: &TurningCut<'_, '_>, feed: MillimetresPerRev) -> Result<Self, KnowledgeError> {
        let law = |component| Refusal::split(cut.named(laws::force(cut, component, feed)));
        let [main, radial, axial] = [Component::Main, Component::Radial, Component::Axial].map(law);
        Ok(Self { feed, main: main?, radial: radial?, axial: axial? })
    }

    fn law(&self, component: Component) -> &Result<ForceLaw, MissingFigure> {
        match component {
            Component::Main => &self.main,
            Component::Radial => &self.radial,
            Component::Axial => &self.axial,
        }
    }

    /// A component at a depth and a speed; none if its figures are not known.
    pub fn at(&self, component: Component, depth: Micrometres, speed: MetresPerMinute) -> Option<Newtons> {
        self.law(component).as_ref().ok().map(|law| law.at(depth.to_mm(), speed))
    }

    /// The rows behind all of them.
    pub fn because(&self) -> impl Iterator<Item = Because> + '_ {
        [&self.main, &self.radial, &self.axial].into_iter().flatten().flat_map(|law| law.because.iter().cloned())
    }
}

/// Torque of a main force, N·m: Pz · D / 2000, with D in mm.
pub(super) fn torque(force: Newtons, diameter: Micrometres) -> NewtonMetres {
    NewtonMetres(force.0 * diameter.to_mm() / 2000.0)
}

/// Power of a main force, kW: Pz · V / 60000, with V in m/min.
pub(super) fn power(force: Newtons, speed: MetresPerMinute) -> Kilowatts {
    Kilowatts(force.0 * speed.0 / 60_000.0)
}

impl Check {
    /// Whether it limits a load. The length of the edge limits a depth only.
    pub const fn is_of_loads(&self) -> bool {
        !matches!(self.measure, Measure::Depth)
    }

    /// Whether it is what the jaws hold.
    pub const fn is_of_grip(&self) -> bool {
        matches!(self.bound, Bound::Grip | Bound::Tipping)
    }

    /// The load at a depth and a speed. A check exists only if its figures are known.
    pub fn load(
        &self,
        cut: &TurningCut<'_, '_>,
        forces: &Forces,
        depth: Micrometres,
        speed: MetresPerMinute,
    ) -> Option<Load> {
        let main = || forces.at(Component::Main, depth, speed);
        Some(match self.measure {
            Measure::Force(component) => Load::ForceN(forces.at(component, depth, speed)?),
            Measure::Across(component) => {
                let (main, across) = (main()?.0, forces.at(component, depth, speed)?.0);
                Load::ForceN(Newtons(libm::sqrt(main * main + across * across)))
            }
            Measure::Pull(component, grips, loss) => {
                let along = forces.at(component, depth, speed)?;
                let lost = loss.at(rpm_at(speed, cut.diameter));
                Load::ForceN(Newtons(pull(torque(main()?, cut.diameter), along, grips).0 + lost))
            }
            Measure::Tip(across, along, lever, loss) => {
                let [across, along] = [across, along].map(|one| forces.at(one, depth, speed));
                let radius = cut.diameter.to_mm() / 2.0;
                let tips = tipping(main()?, across?, along?, lever, if cut.is_inner() { -radius } else { radius });
                Load::TorqueNM(NewtonMetres(tips.0 + loss.at(rpm_at(speed, cut.diameter))))
            }
            Measure::Torque => Load::TorqueNM(torque(main()?, cut.diameter)),
            Measure::Power => Load::PowerKw(power(main()?, speed)),
            Measure::Depth => Load::DepthMm(depth),
        })
    }
}

/// The limits of a cut that can be calculated, and the missing figures of the others.
pub(super) fn checks(
    cut: &TurningCut<'_, '_>,
    forces: &Forces,
) -> Result<(Vec<Check>, Vec<UnknownBound>), KnowledgeError> {
    // In longitudinal turning Px acts along the axis, in facing along X. In grooving there is no Px, and Py acts
    // against the feed.
    let (along, across) = match cut.direction {
        Direction::Longitudinal => (Q::FeedForceZ, Q::FeedForceX),
        Direction::Transverse => (Q::FeedForceX, Q::FeedForceZ),
    };
    let against = if cut.tool.plunges() { Component::Radial } else { Component::Axial };
    let mut tried = vec![
        (Bound::ShankStrength, Some(Component::Main), shank_strength(cut)),
        (Bound::ShankStiffness, Some(Component::Main), shank_stiffness(cut)),
        (Bound::InsertEdge, None, insert_edge(cut)),
        (Bound::FeedForce, Some(against), drive(cut, Bound::FeedForce, against, along)),
        (Bound::SpindleTorque, Some(Component::Main), spindle_torque(cut)),
        (Bound::SpindlePower, Some(Component::Main), spindle_power(cut)),
        (Bound::Handbook, None, handbook(cut)),
    ];
    if !cut.tool.plunges() {
        tried.push((Bound::ChipWidth, None, Ok(chip_width(cut, forces.feed)?)));
        let side = drive(cut, Bound::SideForce, Component::Radial, across);
        tried.push((Bound::SideForce, Some(Component::Radial), side));
    }
    if let Some(force) = cut.lathe.cutting_force {
        let row = cut.lathe.row(Q::CuttingForceMax)?;
        let because = vec![Because::row(row, Note::new("lathe-limit").with("limit", force.0))];
        let capacity = Load::ForceN(force);
        let measure = Measure::Force(Component::Main);
        let check = Check { bound: Bound::CuttingForce, measure, capacity, because };
        tried.push((Bound::CuttingForce, Some(Component::Main), Ok(check)));
    }
    if !cut.is_inner() && !cut.tool.plunges() && cut.direction == Direction::Longitudinal {
        tried.push((Bound::PartRadius, None, Ok(part_radius(cut))));
    }
    if let Some(grip) = cut.grip {
        let along = along_axis(cut);
        let measure = Measure::Pull(along, grip.grips, grip.loss);
        let capacity = Load::ForceN(grip.most);
        let check = Check { bound: Bound::Grip, measure, capacity, because: grip.because.clone() };
        tried.push((Bound::Grip, Some(along), Ok(check)));
        let across = across_part(cut);
        let known = forces.law(across).is_ok() && forces.law(along).is_ok();
        if let Some(tips) = grip.tips.filter(|_| known && !cut.tool.plunges()) {
            let lever = tips.lever_mm + cut.stands_out.to_mm();
            let (measure, capacity) = (Measure::Tip(across, along, lever, tips.loss), Load::TorqueNM(tips.most));
            let check = Check { bound: Bound::Tipping, measure, capacity, because: grip.because.clone() };
            tried.push((Bound::Tipping, Some(Component::Main), Ok(check)));
        }
    }
    let (mut checks, mut missing) = (Vec::new(), Vec::new());
    if let Some(part) = cut.part.filter(|_| !cut.is_inner()) {
        let across = across_part(cut);
        let lacking = [Component::Main, across].into_iter().find_map(|one| forces.law(one).as_ref().err().cloned());
        for check in [Some(part_stiffness(cut, part, across)?), part_strength(cut, part, across)?].into_iter().flatten()
        {
            match &lacking {
                None => checks.push(check),
                Some(why) => missing.push(UnknownBound { bound: check.bound, why: why.clone() }),
            }
        }
    }
    for (bound, component, check) in tried {
        // A limit that does not apply to the tool is neither calculated nor missing.
        if bound == Bound::InsertEdge && cut.tool.plunges() {
            continue;
        }
        let lacking = component.and_then(|component| forces.law(component).as_ref().err());
        match (Refusal::split(check)?, lacking) {
            (Ok(check), None) => checks.push(check),
            (Err(why), _) => missing.push(UnknownBound { bound, why }),
            (Ok(_), Some(why)) => missing.push(UnknownBound { bound, why: why.clone() }),
        }
    }
    Ok((checks, missing))
}

/// A constant of `turning-limits` with its reason; `of` reads the required figure from the row.
fn constant<T: IntoFigure + Clone>(
    knowledge: &Knowledge,
    name: Limit,
    of: impl Fn(&TurningLimits<'_>) -> Option<T>,
) -> Result<(T, Because), KnowledgeError> {
    let row = knowledge.need(name.name(), |row: &TurningLimits<'_>| row.name == name)?;
    let lacks = || KnowledgeError::missing(&row.row.table.id, note!("turned-has-no-figure-kind", value = name.name()));
    let value = of(&row).ok_or_else(lacks)?;
    let note = Note::new("turning-limit").with("name", Figure::word(name.name())).with("value", &value);
    Ok((value, Because::row(row.row, note)))
}

/// A length of `turning-limits`, and the reason.
pub(super) fn constant_length(cut: &TurningCut<'_, '_>, name: Limit) -> Result<(Micrometres, Because), KnowledgeError> {
    constant(cut.knowledge, name, |row| row.length)
}

/// The clearance of the jaws from the end of the toolpath: the least, and the wanted one.
///
/// # Errors `turning-limits` does not have it.
pub fn jaw_clearance(knowledge: &Knowledge) -> Result<[Micrometres; 2], KnowledgeError> {
    let of = |name| constant(knowledge, name, |row| row.length).map(|(length, _)| length);
    Ok([of(Limit::JawClearanceLeast)?, of(Limit::JawClearance)?])
}

/// The share of a part's length that soft jaws are bored for.
///
/// # Errors `turning-limits` does not have it.
pub fn soft_jaw_share(knowledge: &Knowledge) -> Result<f64, KnowledgeError> {
    Ok(ratio(knowledge, Limit::SoftJawShare)?.0)
}

/// The share of its edge that a tool may bring into a wall while it rises.
///
/// # Errors `turning-limits` does not have it.
pub fn wall_share(knowledge: &Knowledge) -> Result<f64, KnowledgeError> {
    Ok(ratio(knowledge, Limit::WallShare)?.0)
}

/// The least depth of a useful roughing pass.
///
/// # Errors `turning-limits` does not have it.
pub fn least_sensible_depth(knowledge: &Knowledge) -> Result<Micrometres, KnowledgeError> {
    Ok(constant(knowledge, Limit::LeastSensibleDepth, |row| row.length)?.0)
}

pub(super) fn ratio(knowledge: &Knowledge, name: Limit) -> Result<(f64, Because), KnowledgeError> {
    constant(knowledge, name, |row| row.ratio)
}

/// A stress of `turning-limits`, MPa, and the reason.
fn stress(cut: &TurningCut<'_, '_>, name: Limit) -> Result<(f64, Because), KnowledgeError> {
    constant(cut.knowledge, name, |row| row.stress.map(|stress| stress.0.to_f64()))
}

/// The overhang, mm: from the tool's row; for a bar the depth of the bore and a clearance; otherwise by the ratio of
/// `turning-limits` to its height or diameter.
fn overhang(cut: &TurningCut<'_, '_>, shank: Shank) -> Tried<(f64, Vec<Because>), BarTooLong> {
    if let (Shank::Round { .. }, Some(depth)) = (shank, cut.bore_depth) {
        let (overhang, because) = bar_overhang(cut.tool, depth, cut.knowledge)?;
        return Ok((overhang.to_mm(), because));
    }
    if let Some(reach) = cut.tool.reach {
        let note = Note::new("overhang").with("length", reach);
        return Ok((reach.to_mm(), vec![Because::row(cut.tool.row, note)]));
    }
    let (size, name) = match shank {
        Shank::Square { height, .. } => (height, Limit::OverhangRatio),
        Shank::Round { diameter } => (diameter, overhang_ratio(cut.tool)),
    };
    let (ratio, because) = ratio(cut.knowledge, name)?;
    Ok((ratio * size.to_mm(), vec![because]))
}

/// The largest overhang of a boring bar, and the reason: from its row, otherwise by the ratio of `turning-limits` to its
/// diameter, for a bar of its material. None for a tool without a bar.
///
/// # Errors
/// The knowledge base lacks the ratio.
pub fn largest_overhang(
    tool: &TurningTool<'_>,
    knowledge: &Knowledge,
) -> Result<Option<(Micrometres, Because)>, KnowledgeError> {
    Ok(match (tool.reach, tool.shank) {
        (Some(reach), _) => Some((reach, Because::row(tool.row, Note::new("overhang").with("length", reach)))),
        (None, Some(Shank::Round { diameter })) => {
            let (ratio, because) = ratio(knowledge, overhang_ratio(tool))?;
            Some((Micrometres::from_mm_rounded(ratio * diameter.to_mm()), because))
        }
        _ => None,
    })
}

const fn overhang_ratio(tool: &TurningTool<'_>) -> Limit {
    if tool.carbide_bar { Limit::CarbideBarOverhangRatio } else { Limit::BarOverhangRatio }
}

/// What a boring bar stands out more than its bore is deep (`turning-limits`).
///
/// # Errors
/// The table does not have it.
pub fn bar_clearance(knowledge: &Knowledge) -> Result<Micrometres, KnowledgeError> {
    Ok(constant(knowledge, Limit::BarClearance, |row| row.length)?.0)
}

/// The overhang of a boring bar for a bore of a depth: the depth and a clearance (`turning-limits`), and the reason.
///
/// # Errors
/// The bar would stand out farther than its [largest overhang](largest_overhang).
pub fn bar_overhang(
    tool: &TurningTool<'_>,
    bore_depth: Micrometres,
    knowledge: &Knowledge,
) -> Tried<(Micrometres, Vec<Because>), BarTooLong> {
    let (clearance, of_clearance) = constant(knowledge, Limit::BarClearance, |row| row.length)?;
    let overhang = bore_depth + clearance;
    match largest_overhang(tool, knowledge)? {
        Some((most, _)) if overhang > most => {
            Err(Refusal::Not(BarTooLong { tool: tool.designation.to_owned(), overhang, most }))
        }
        most => Ok((overhang, [of_clearance].into_iter().chain(most.map(|(_, because)| because)).collect())),
    }
}

/// Refuses a cut if the overhang of its bar would be too large.
///
/// # Errors
/// It would be; the knowledge base lacks a constant.
pub fn bar_reaches(cut: &TurningCut<'_, '_>) -> Tried<(), CuttingRefusal> {
    let (Some(depth), Some(Shank::Round { .. })) = (cut.bore_depth, cut.tool.shank) else { return Ok(()) };
    let reaches = bar_overhang(cut.tool, depth, cut.knowledge);
    reaches.map(|_| ()).map_err(|refusal| refusal.map(CuttingRefusal::BarTooLong))
}

/// What the jaws hold without slipping: μ·F/S.
#[derive(Clone, Debug, PartialEq)]
pub struct GripLimit {
    /// The diameter that they grip.
    pub grips: Micrometres,
    /// The largest pull at that diameter.
    pub most: Newtons,
    /// What the speed takes off it, N.
    pub loss: JawLoss,
    /// What tips it out of them; none where a centre or a rest holds it, too.
    pub tips: Option<TipLimit>,
    /// The rows behind it.
    pub because: Vec<Because>,
}

impl GripLimit {
    /// The speed up to which they hold a torque and a force along the axis, but not below that at the largest diameter of the cut; none
    /// where they lose nothing.
    pub fn held_up_to(&self, torque: NewtonMetres, along: Newtons, slowest: RevsPerMinute) -> Option<RevsPerMinute> {
        let held = self.loss.reaches(self.most.0 - pull(torque, along, self.grips).0)?;
        Some(RevsPerMinute(held.0.max(slowest.0)))
    }
}

impl GripLimit {
    /// Whether they hold a blade that plunges at a Z outside, at a speed.
    pub fn holds(&self, blade: BladeForce, z: Half, rpm: RevsPerMinute) -> bool {
        let upright = self.tips.is_none_or(|tips| {
            let (lever, radius) = ((tips.lever_mm - z.to_mm()).max(0.0), blade.diameter.to_mm() / 2.0);
            let moment = tipping(blade.main, blade.across, blade.along, lever, radius);
            moment.0 + tips.loss.at(rpm) <= tips.most.0
        });
        upright && pull(blade.torque(1.0), blade.along, self.grips).0 + self.loss.at(rpm) <= self.most.0
    }
}

/// What jaws hold against tipping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipLimit {
    /// From the middle of the grip to Z 0, the finished face of the free end; the stock before it comes from the cut, mm.
    pub lever_mm: f64,
    /// The largest moment.
    pub most: NewtonMetres,
    /// What the speed takes off it, N·m.
    pub loss: JawLoss,
}

/// What the speed of a chuck takes off what its jaws hold from outside: the centrifugal force of the jaws, Fc = Σ(m·r)·ω² (VDI 3106),
/// which grows by n². Zero where the chuck is not known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JawLoss {
    /// Of 1 (1/min)².
    pub per_square: f64,
}

impl JawLoss {
    /// At a speed.
    pub fn at(self, rpm: RevsPerMinute) -> f64 {
        self.per_square * rpm.0 * rpm.0
    }

    /// In another measure of the same loss.
    pub fn times(self, share: f64) -> Self {
        Self { per_square: self.per_square * share }
    }

    /// The speed at which it is as large as this; none where there is no loss.
    pub fn reaches(self, most: f64) -> Option<RevsPerMinute> {
        (self.per_square > 0.0).then(|| RevsPerMinute(libm::sqrt(most.max(0.0) / self.per_square)))
    }
}

/// The moment, N·m, that a cut at a radius (below zero in a bore) and a distance from the middle of the grip tips a part with: that of
/// the main force, and across it that of the force across the axis less that of the force along it, which presses towards the chuck:
/// √((Pz·l)² + (Pa·l − Pl·r)²).
pub fn tipping(main: Newtons, across: Newtons, along: Newtons, lever_mm: f64, radius_mm: f64) -> NewtonMetres {
    let (up, aside) = (main.0 * lever_mm, across.0 * lever_mm - along.0 * radius_mm);
    NewtonMetres(libm::sqrt(up * up + aside * aside) / 1000.0)
}

/// The pull at a diameter of the jaws by a torque and a force along the axis: √((2·M/d)² + P²), N, with M in N·mm.
pub fn pull(torque: NewtonMetres, along: Newtons, grips: Micrometres) -> Newtons {
    let around = 2000.0 * torque.0 / grips.to_mm();
    Newtons(libm::sqrt(around * around + along.0 * along.0))
}

/// The component along the axis: Px, in facing Py.
fn along_axis(cut: &TurningCut<'_, '_>) -> Component {
    match cut.direction {
        Direction::Transverse if !cut.tool.plunges() => Component::Radial,
        _ => Component::Axial,
    }
}

/// The component that bends the part: in longitudinal turning and plunging Py, in facing Px, which is perpendicular
/// to the axis there.
fn across_part(cut: &TurningCut<'_, '_>) -> Component {
    match cut.direction {
        Direction::Transverse if !cut.tool.plunges() => Component::Axial,
        _ => Component::Radial,
    }
}

/// Deflection of the part: in roughing the force of Pz and Py together ≤ f/c, with f the deflection of
/// `turning-limits` and c the compliance of the part; in finishing Py ≤ share·T/c, because only a deflection
/// perpendicular to the surface changes the diameter.
fn part_stiffness(cut: &TurningCut<'_, '_>, part: &Flexibility, across: Component) -> Result<Check, KnowledgeError> {
    let mut because = part.because.clone();
    let (mm, measure) = match part.tolerance {
        Some(tolerance) => {
            let (share, of_share) = ratio(cut.knowledge, Limit::PartDeflectionShare)?;
            because.push(of_share);
            (share * tolerance.to_mm(), Measure::Force(across))
        }
        None => {
            let (most, of_most) = constant_length(cut, Limit::PartDeflection)?;
            because.push(of_most);
            (most.to_mm(), Measure::Across(across))
        }
    };
    Ok(Check { bound: Bound::PartStiffness, measure, capacity: Load::ForceN(part.force_to_bend(mm)), because })
}

/// Bending stress of the part ≤ a share of its strength (`turning-limits`); none where its strength is not known.
fn part_strength(
    cut: &TurningCut<'_, '_>,
    part: &Flexibility,
    across: Component,
) -> Result<Option<Check>, KnowledgeError> {
    if part.strength <= 0.0 {
        return Ok(None);
    }
    let (share, of_share) = ratio(cut.knowledge, Limit::PartStressShare)?;
    let capacity = Load::ForceN(part.force_to_stress(share * part.strength));
    let because = vec![of_share];
    Ok(Some(Check { bound: Bound::PartStrength, measure: Measure::Across(across), capacity, because }))
}

/// A bar that is too long is refused before its limits are calculated; here its overhang is missing.
fn of_bar<T>(cut: &TurningCut<'_, '_>, tried: Tried<T, BarTooLong>) -> Tried<T, MissingFigure> {
    tried.map_err(|refusal| refusal.map(|_| cut.tool_lacks("reach")))
}

fn shank_of(cut: &TurningCut<'_, '_>) -> Tried<Shank, MissingFigure> {
    cut.tool.shank.ok_or_else(|| Refusal::Not(cut.tool_lacks("shank_height")))
}

/// Bending stress of the shank: Pz · l ≤ σ · W, with W = B·H²/6 for a square shank and π·d³/32 for a bar, mm³.
fn shank_strength(cut: &TurningCut<'_, '_>) -> Tried<Check, MissingFigure> {
    let shank = shank_of(cut)?;
    let modulus = match shank {
        Shank::Square { height, width } => width.to_mm() * height.to_mm() * height.to_mm() / 6.0,
        Shank::Round { diameter } => {
            let d = diameter.to_mm();
            std::f64::consts::PI * d * d * d / 32.0
        }
    };
    let (allowed, reason) = stress(cut, Limit::ShankStress)?;
    let (overhang, mut because) = of_bar(cut, overhang(cut, shank))?;
    because.push(reason);
    Ok(main_force(Bound::ShankStrength, Newtons(allowed * modulus / overhang), because))
}

/// Deflection of the shank: Pz ≤ 3·f·E·J / l³, with J = B·H³/12 for a square shank and π·d⁴/64 for a bar, mm⁴.
fn shank_stiffness(cut: &TurningCut<'_, '_>) -> Tried<Check, MissingFigure> {
    let shank = shank_of(cut)?;
    let inertia = match shank {
        Shank::Square { height, width } => {
            let h = height.to_mm();
            width.to_mm() * h * h * h / 12.0
        }
        Shank::Round { diameter } => {
            let d = diameter.to_mm();
            std::f64::consts::PI * d * d * d * d / 64.0
        }
    };
    let (modulus, of_modulus) =
        stress(cut, if cut.tool.carbide_bar { Limit::CarbideShankModulus } else { Limit::ShankModulus })?;
    let (bend, of_bend) = constant_length(cut, Limit::ShankDeflection)?;
    let (overhang, mut because) = of_bar(cut, overhang(cut, shank))?;
    because.extend([of_modulus, of_bend]);
    let force = 3.0 * bend.to_mm() * modulus * inertia / (overhang * overhang * overhang);
    Ok(main_force(Bound::ShankStiffness, Newtons(force), because))
}

/// The largest depth that the edge of a tool takes along or across, by the table `insert-edge-share`; none where the catalogs lack its
/// edge or shape.
///
/// # Errors
/// The knowledge base lacks the table.
pub fn deepest_edge(tool: &TurningTool<'_>, knowledge: &Knowledge) -> Result<Option<Micrometres>, KnowledgeError> {
    let Some((edge, shape)) = tool.edge.zip(tool.insert_shape()) else { return Ok(None) };
    let row = knowledge.find(|row: &InsertEdgeShare<'_>| row.shape == shape)?;
    let sine = |degrees: f64| libm::sin(degrees.to_radians());
    let steepest = sine(tool.lead_angle.to_f64()).max(sine(90.0 + tool.trail_angle.to_f64()));
    Ok(row.map(|row| Micrometres::from_mm_rounded(row.share * edge.to_mm() * steepest)))
}

/// The share of the edge that may cut: t ≤ share · l · sin of the angle between edge and feed.
fn insert_edge(cut: &TurningCut<'_, '_>) -> Tried<Check, MissingFigure> {
    let lacks = |quantity: &str| Refusal::Not(cut.tool_lacks(quantity));
    let edge = cut.tool.edge.ok_or_else(|| lacks("edge"))?;
    let shape = cut.tool.insert_shape().ok_or_else(|| lacks("insert"))?;
    let row = cut.knowledge.find(|row: &InsertEdgeShare<'_>| row.shape == shape)?.ok_or_else(|| lacks("insert"))?;
    let share = row.share;
    let depth = share * edge.to_mm() * libm::sin(cut.edge_angle().to_f64().to_radians());
    // Rounded down to a micrometre, so that the share is never exceeded.
    let depth = Micrometres::new((depth * 1000.0).floor() as i64);
    let note = Note::new("insert-edge").with("share", share).with("edge", edge).with("depth", depth);
    let because = vec![Because::row(row.row, note)];
    Ok(Check { bound: Bound::InsertEdge, measure: Measure::Depth, capacity: Load::DepthMm(depth), because })
}

/// The width of the chip: t ≤ k·f, by the rule `turning-chip-width`.
fn chip_width(cut: &TurningCut<'_, '_>, feed: MillimetresPerRev) -> Result<Check, KnowledgeError> {
    let asked = cut.knowledge.ask(&TurningChipWidthFor { material_group: cut.material.group })?;
    let ratio = asked.need(cut.material.group)?.ratio;
    let depth = Micrometres::new(libm::floor(ratio * feed.0 * 1000.0 + 1e-6) as i64);
    let note = Note::new("chip-width").with("ratio", ratio).with("feed", feed.0).with("depth", depth);
    let because = vec![Because::answer(&asked.answer, note)];
    Ok(Check { bound: Bound::ChipWidth, measure: Measure::Depth, capacity: Load::DepthMm(depth), because })
}

/// The force that the floor of a groove bears: F·l ≤ share·σB·W with W = π·d³/32 of the solid floor, mm³, and the lever l from the
/// blade to the wall at the chuck, mm, half of it where the far end is held, too; none where the strength is not known.
///
/// # Errors
/// The knowledge base lacks the share.
pub fn floor_bears(
    floor: Micrometres,
    lever_mm: f64,
    alone: bool,
    material: &Material<'_>,
    knowledge: &Knowledge,
) -> Result<Option<(Newtons, Because)>, KnowledgeError> {
    let strength = material.strength.to_f64();
    let (share, because) = ratio(knowledge, Limit::PartStressShare)?;
    let modulus = std::f64::consts::PI * libm::pow(floor.to_mm(), 3.0) / 32.0;
    let lever = if alone { lever_mm } else { lever_mm / 2.0 };
    Ok((strength > 0.0).then(|| (Newtons(share * strength * modulus / lever), because)))
}

/// A drive of the carriage: the force along it ≤ the limit in its record.
fn drive(cut: &TurningCut<'_, '_>, bound: Bound, component: Component, quantity: Q) -> Tried<Check, MissingFigure> {
    let force = match quantity {
        Q::FeedForceZ => cut.lathe.feed_force_z,
        _ => cut.lathe.feed_force_x,
    };
    let force = force.ok_or_else(|| Refusal::Not(cut.lathe_lacks(quantity)))?;
    let because = vec![Because::row(cut.lathe.row(quantity)?, Note::new("lathe-limit").with("limit", force.0))];
    Ok(Check { bound, measure: Measure::Force(component), capacity: Load::ForceN(force), because })
}

/// Pz · D / 2 ≤ the torque of the spindle.
fn spindle_torque(cut: &TurningCut<'_, '_>) -> Tried<Check, MissingFigure> {
    let quantity = Q::SpindleTorqueMax;
    let torque = cut.lathe.torque.ok_or_else(|| Refusal::Not(cut.lathe_lacks(quantity)))?;
    let because = vec![Because::row(cut.lathe.row(quantity)?, Note::new("lathe-limit").with("limit", torque.0))];
    Ok(Check { bound: Bound::SpindleTorque, measure: Measure::Torque, capacity: Load::TorqueNM(torque), because })
}

/// Pz · V / 60000 ≤ N · η. If the record has no η, that of `turning-limits` is used and marked.
fn spindle_power(cut: &TurningCut<'_, '_>) -> Tried<Check, MissingFigure> {
    let (share, of_share) = match cut.lathe.efficiency {
        Some(share) => {
            let note = Note::new("lathe-limit").with("limit", share.0);
            (share.0, Because::row(cut.lathe.row(Q::SpindleEfficiency)?, note))
        }
        None => ratio(cut.knowledge, Limit::DriveEfficiency)?,
    };
    let power = Kilowatts(cut.lathe.power.0 * share);
    let note = Note::new("lathe-limit").with("limit", cut.lathe.power.0);
    let because = vec![Because::row(cut.lathe.row(Q::SpindlePower)?, note), of_share];
    Ok(Check { bound: Bound::SpindlePower, measure: Measure::Power, capacity: Load::PowerKw(power), because })
}

/// The depth where the tables of feeds end.
fn handbook(cut: &TurningCut<'_, '_>) -> Tried<Check, MissingFigure> {
    let (depth, because) = constant_length(cut, Limit::DepthMax)?;
    let capacity = Load::DepthMm(depth);
    Ok(Check { bound: Bound::Handbook, measure: Measure::Depth, capacity, because: vec![because] })
}

/// The depth in a solid part is not more than its radius.
fn part_radius(cut: &TurningCut<'_, '_>) -> Check {
    let capacity = Load::DepthMm(cut.diameter.half());
    Check { bound: Bound::PartRadius, measure: Measure::Depth, capacity, because: Vec::new() }
}

fn main_force(bound: Bound, force: Newtons, because: Vec<Because>) -> Check {
    Check { bound, measure: Measure::Force(Component::Main), capacity: Load::ForceN(force), because }
}
