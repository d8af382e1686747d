//! Cutting conditions: feed, speed, spindle step, forces and time, within the limits of the machine.
//!
//! Every formula is a named function with its source; every coefficient is a catalog row, and the rows used are in
//! `because` of the result.

mod boring;
mod card;
mod countersinking;
mod drilling;
pub mod factors;
mod feed;
pub mod figures;
mod force_opinion;
pub mod handbook;
pub mod laws;
mod limits;
mod milling;
mod milling_force;
pub mod practice;
pub mod reaming;
mod settle;
mod slotting;
pub mod state;
pub mod tapping;

// The types of other crates, under one name each in the whole program.
use technolog_core::{error, material, note, part, plan, practice_speed, reason, shop};
use technolog_knowledge::{self as knowledge, units};
use technolog_tables as tables;

use crate::error::{Refusal, Tried};
use crate::knowledge::vocabulary::ToolMaterial;
use crate::note::Because;
use crate::part::Slot;
use crate::plan::{Conditions, Limit, Operation};
use crate::reason::{Reason, Uncut};
use crate::shop::{Shop, programmed_feed};
use crate::units::{
    ItGrade, Kilowatts, MetresPerMinute, Micrometres, MillimetresPerMinute, MillimetresPerRev, Minutes, NewtonMetres,
    Newtons, RevsPerMinute, Roughness,
};

pub use crate::tables::cutting::Surface;
pub use card::CardDoubt;
pub use limits::spindle_step;

use practice::PracticeComparison;
use settle::Settled;

/// A cut.
#[derive(Clone, Copy, Debug)]
pub struct Cut {
    /// The transition.
    pub operation: Operation,
    /// The diameter it leaves; for centring that of the spot, for a cone its widest, for a thread its nominal.
    pub diameter: Micrometres,
    /// The narrow diameter of a step drill, which permits less feed than the wide one; absent for other tools.
    pub feed_diameter: Option<Micrometres>,
    /// The diameter where the tool bears the torque, if it is not that of the cut: of a spotting drill its own, of a
    /// step drill its narrow part.
    pub tool_diameter: Option<Micrometres>,
    /// Length of the flutes of a drill, along which a thin one bends out under its thrust; absent where it is not known.
    pub flutes: Option<Micrometres>,
    /// The diameter before it; zero in solid metal.
    pub from: Micrometres,
    /// Passes of the tool; milling adds to them what the mill's diameter requires.
    pub passes: u32,
    /// Depth of the hole.
    pub depth: Micrometres,
    /// Working travel of one pass.
    pub travel: Micrometres,
    /// The material of the tool.
    pub tool_material: ToolMaterial,
    /// Nose radius of a boring bar's insert.
    pub nose_radius: Option<Micrometres>,
    /// The roughness that this transition must leave, if it is the last one.
    pub roughness: Option<Roughness>,
    /// Whether a reamer follows.
    pub reamer_follows: bool,
    /// Whether the hole is blind.
    pub blind: bool,
    /// The surface of the blank.
    pub surface: Surface,
    /// The grade of the hole's tolerance; a final reaming pass is fed by it.
    pub it: Option<ItGrade>,
    /// Pitch of the thread, for tapping.
    pub pitch: Option<Micrometres>,
    /// The mill, for milling.
    pub cutter: Option<CutterShape>,
    /// The diameter of a countersink at the face, where it goes round the edge instead of being sunk into it.
    pub around: Option<Micrometres>,
    /// Whether the mill cuts on its way down.
    pub plunges: bool,
    /// How a slot or a pocket runs that is cut; absent for what is round.
    pub slot: Option<Slot>,
}

/// The figures of a mill for its conditions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CutterShape {
    /// Its own diameter, not that of the hole.
    pub diameter: Micrometres,
    /// Teeth, z.
    pub teeth: u32,
    /// Length of its cutting edges along the axis.
    pub cutting_length: Micrometres,
}

impl Cut {
    /// Depth of cut of one pass, mm.
    fn depth_of_cut(&self) -> f64 {
        (self.diameter - self.from).to_mm() / 2.0 / f64::from(self.passes.max(1))
    }
}

/// Draft conditions: the result of a formula, before and after the machine's limits.
#[derive(Clone, Debug)]
struct DraftConditions {
    feed: MillimetresPerRev,
    speed: MetresPerMinute,
    /// The upper end of practice for this cut, above which no step of the spindle is taken; absent where no table has it.
    fastest: Option<MetresPerMinute>,
    tool_life: Minutes,
    /// m of V ~ 1/T^m, to convert another speed into a tool life.
    life_exponent: f64,
    coolant: Option<bool>,
    loads: Loads,
    motion: CutMotion,
    because: Vec<Because>,
    /// What the cards could not give.
    doubts: Vec<CardDoubt>,
    card: Option<crate::plan::CardPoint>,
    rounds: Option<crate::plan::Rounds>,
    plunge: Option<AnotherFeed>,
    /// Along the arcs of a slot.
    arcs: Vec<AnotherFeed>,
}

/// The way down of a mill that cuts there, or its way along an arc of a slot.
#[derive(Clone, Copy, Debug)]
struct AnotherFeed {
    /// Its feed over that of the rest.
    share: f64,
    /// Its length, mm.
    travel: f64,
}

/// The motion of a tool: the rotating diameter, the depth of cut and the length of the feed path.
#[derive(Clone, Copy, Debug)]
struct CutMotion {
    /// The diameter of the cutting speed: that of the hole, or that of the mill.
    turned: Micrometres,
    /// Depth of cut of one pass, mm.
    depth_of_cut: f64,
    /// Length of all moves at the working feed, mm.
    path: f64,
    /// Whether the feed is synchronised with the spindle, as by the pitch of a thread.
    synchronous: bool,
}

impl CutMotion {
    /// A tool of the hole's diameter fed along its axis, once for each pass.
    fn along_axis(cut: &Cut) -> Self {
        Self {
            turned: cut.diameter,
            depth_of_cut: cut.depth_of_cut(),
            path: cut.travel.to_mm() * f64::from(cut.passes.max(1)),
            synchronous: false,
        }
    }
}

/// Torque and thrust as power laws of the feed, so that a limit can be converted into a feed.
#[derive(Clone, Copy, Debug, Default)]
struct Loads {
    torque: Option<PowerLaw>,
    thrust: Option<PowerLaw>,
}

/// `factor · s^exponent · V^of_speed`: s in mm/rev, V in m/min, the speed used.
#[derive(Clone, Copy, Debug)]
struct PowerLaw {
    factor: f64,
    exponent: f64,
    /// 0 where the load does not depend on the speed.
    of_speed: f64,
}

impl PowerLaw {
    /// A load that does not depend on the speed.
    const fn of_feed(factor: f64, exponent: f64) -> Self {
        Self { factor, exponent, of_speed: 0.0 }
    }

    fn at(self, feed: MillimetresPerRev, speed: MetresPerMinute) -> f64 {
        self.factor * libm::pow(feed.0, self.exponent) * libm::pow(speed.0, self.of_speed)
    }

    /// The feed at which the load reaches a limit.
    fn feed_at(self, limit: f64, speed: MetresPerMinute) -> MillimetresPerRev {
        let factor = self.factor * libm::pow(speed.0, self.of_speed);
        MillimetresPerRev(libm::pow(limit / factor, 1.0 / self.exponent))
    }
}

/// Conditions of a cut on the machine at hand.
///
/// # Errors
/// A table has no figure for this material, or the knowledge base has no answer at all.
pub fn conditions(cut: &Cut, shop: &Shop<'_>) -> Tried<Conditions> {
    Ok(with_doubts(cut, shop)?.0)
}

/// As [`conditions`], and what the cards could not give.
///
/// # Errors
/// As for [`conditions`].
pub fn with_doubts(cut: &Cut, shop: &Shop<'_>) -> Tried<(Conditions, Vec<CardDoubt>)> {
    let operation = cut.operation;
    let Settled { draft, formula_speed, practice, limited } =
        settle::settle(cut, shop).map_err(|refusal| refusal.map(|why| Reason::NoConditions { operation, why }))?;
    let speed = speed_at(limited.rpm, draft.motion.turned);
    let feed_rate = MillimetresPerMinute(limited.feed.0 * limited.rpm.0);
    // The power is computed from the printed torque, so that a check by hand gives the same.
    let torque = draft.loads.torque.map(|law| NewtonMetres(law.at(limited.feed, speed)).rounded(3));
    let power = torque.map(|torque| power_of(torque, limited.rpm));
    // The life belongs to the speed of the formula, also where practice is slower; where practice is faster, to the
    // speed of practice.
    let lives_at = if practice == PracticeComparison::Faster { draft.speed } else { formula_speed };
    let tool_life = Minutes(draft.tool_life.0 * libm::pow(lives_at.0 / speed.0, 1.0 / draft.life_exponent));
    let mut because = draft.because;
    because.extend(limited.because);
    // As for the speed; where its figures do not say, by the rule.
    let coolant = match draft.coolant {
        Some(needed) => needed,
        None => {
            let (cooled, reason) = shop.coolant(operation)?;
            because.push(reason);
            cooled
        }
    };
    // In the steps of programs, so that plan and program take as long.
    let another = |own: Option<AnotherFeed>| {
        own.map(|own| programmed_feed(MillimetresPerMinute(feed_rate.0 * own.share), shop.knowledge)).transpose()
    };
    let (plunge_feed, mut arc_feed) = (another(draft.plunge)?, None::<MillimetresPerMinute>);
    let mut at_other_feeds = draft.plunge.zip(plunge_feed).map_or(0.0, |(own, feed)| own.travel / feed.0);
    for own in draft.arcs {
        let Some(feed) = another(Some(own))? else { continue };
        at_other_feeds += own.travel / feed.0;
        arc_feed = Some(arc_feed.filter(|slowest| slowest.0 <= feed.0).unwrap_or(feed));
    }
    let mut found = Conditions {
        depth_of_cut_mm: crate::units::round_to(draft.motion.depth_of_cut, 3),
        feed_mm_per_rev: limited.feed.rounded(3),
        speed_m_per_min: speed.rounded(2),
        spindle_rpm: limited.rpm,
        // The feed rate of a tap is pitch times speed to the last digit; otherwise the thread is torn.
        feed_mm_per_min: feed_rate.rounded(if draft.motion.synchronous { 3 } else { 1 }),
        axial_force_n: draft.loads.thrust.map(|law| Newtons(law.at(limited.feed, speed)).rounded(0)),
        torque_n_m: torque,
        power_kw: power.map(|power| power.rounded(4)),
        machine_time_min: Minutes(draft.motion.path / feed_rate.0 + at_other_feeds).rounded(3),
        limited_by: match limited.limited_by {
            Limit::CuttingSpeed if practice != PracticeComparison::FormulaKept => Limit::PracticeSpeed,
            limit => limit,
        },
        tool_life_min: tool_life.rounded(0),
        coolant: Some(coolant),
        computed_speed_m_per_min: lives_at.rounded(2),
        rounds: draft.rounds.map(|rounds| crate::plan::Rounds {
            plunge_feed_mm_per_min: plunge_feed,
            arc_feed_mm_per_min: arc_feed,
            ..rounds
        }),
        card: draft.card,
        because,
    };
    found.because.extend(force_opinion::makers(cut, &found, shop)?);
    Ok((found, draft.doubts))
}

/// The draft for a feed: for that of the tables, or for `taken` in its place.
fn draft(cut: &Cut, taken: Option<MillimetresPerRev>, shop: &Shop<'_>) -> Tried<DraftConditions, Uncut> {
    match cut.operation {
        Operation::CentreDrill | Operation::Drill | Operation::DrillOut | Operation::CoreDrill => {
            drilling::draft(cut, taken, shop)
        }
        Operation::Counterbore | Operation::Countersink | Operation::Chamfer => countersinking::draft(cut, taken, shop),
        Operation::RoughReam | Operation::FinishReam => reaming::draft(cut, taken, shop),
        Operation::RoughBore | Operation::SemiFinishBore | Operation::FinishBore => boring::draft(cut, taken, shop),
        Operation::Mill => milling::draft(cut, taken, shop),
        // The pitch permits no other feed.
        Operation::Tap => tapping::draft(cut, shop),
        // It is work of another machine, whose conditions are not known here.
        Operation::Hone => {
            let material = shop.material.designation().to_owned();
            Err(Refusal::Not(Uncut::NoFigure { table: "cutting-speed".to_owned(), material }))
        }
    }
}

/// Spindle speed n = 1000·V/(π·D), 1/min (textbook Appendix Г item 7; V in m/min, D in mm).
pub fn rpm_at(speed: MetresPerMinute, diameter: Micrometres) -> RevsPerMinute {
    RevsPerMinute(1000.0 * speed.0 / (std::f64::consts::PI * diameter.to_mm()))
}

/// Cutting speed V = π·D·n/1000, m/min.
pub fn speed_at(rpm: RevsPerMinute, diameter: Micrometres) -> MetresPerMinute {
    MetresPerMinute(std::f64::consts::PI * diameter.to_mm() * rpm.0 / 1000.0)
}

/// Cutting power N = M·n/9750, kW (textbook Appendix Г item 8; M in N·m).
pub fn power_of(torque: NewtonMetres, rpm: RevsPerMinute) -> Kilowatts {
    Kilowatts(torque.0 * rpm.0 / 9750.0)
}
