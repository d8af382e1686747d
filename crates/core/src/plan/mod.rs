//! The plan: all decisions about a part, in plain data with units in the field names.
//!
//! A plan is a value. It serialises to JSON and YAML and back without loss; reports, programs and audits are
//! functions of it and make no decisions.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::note::{Because, Finding, Severity};
use crate::part::{Face, Part, Point};
use crate::units::{
    ItGrade, Kilowatts, MetresPerMinute, Micrometres, MillimetresPerMinute, MillimetresPerRev, Minutes, NewtonMetres,
    Newtons, RevsPerMinute,
};

mod chain;
mod magazine;
mod order;
mod route;
mod set_up;

pub use crate::knowledge::vocabulary::{CuttingMethod, Operation};
pub use crate::tables::rules::{ChainClosing, FixtureKind, HeldBy, PartLocating, PinKind, TableKeying, VisitingMethod};
pub use chain::{Chain, ChainError, ChainTerm, PartZero};
pub use order::{Mixture, Stop, Times, ToolVisit, Visiting};
pub use route::{Achieved, Alternative, AlternativeStep, Feature, Route, RouteSource};
pub use set_up::{
    BarSetting, Chuck, FixturePlan, Held, Loading, LocatingPin, OtherZero, OwnFixture, PinPair, Setup, Stand, Strap,
    Touched, Vice,
};

/// What holds cutting conditions back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Limit {
    /// The cutting speed of the tables: nothing else did.
    CuttingSpeed,
    /// What shops drive.
    PracticeSpeed,
    /// What a thin drill bears.
    DrillStrength,
    /// The thrust at which a long drill bends out.
    DrillBuckling,
    /// The thrust that the machine bears.
    Thrust,
    /// The torque of the spindle.
    SpindleTorque,
    /// The power of the main drive.
    SpindlePower,
    /// The spindle's fastest step.
    SpindleSpeedMax,
    /// The spindle's slowest step.
    SpindleSpeedMin,
    /// The largest feed.
    FeedMax,
    /// The smallest feed.
    FeedMin,
    /// Another machine does it, by conditions that are not known here: all figures but the depth of cut are 0.
    AnotherMachine,
}

impl Limit {
    /// All limits with their names in plans.
    pub const NAMES: [(&'static str, Self); 12] = [
        ("cutting-speed", Self::CuttingSpeed),
        ("practice-speed", Self::PracticeSpeed),
        ("drill-strength", Self::DrillStrength),
        ("drill-buckling", Self::DrillBuckling),
        ("thrust", Self::Thrust),
        ("spindle-torque", Self::SpindleTorque),
        ("spindle-power", Self::SpindlePower),
        ("spindle-speed-max", Self::SpindleSpeedMax),
        ("spindle-speed-min", Self::SpindleSpeedMin),
        ("feed-max", Self::FeedMax),
        ("feed-min", Self::FeedMin),
        ("another-machine", Self::AnotherMachine),
    ];

    /// Its name in plans.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, limit)| *limit == self).map_or("", |(name, _)| name)
    }
}

/// Which routes go before others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Preference {
    /// The quickest of those that hold what the drawing asks.
    #[default]
    Best,
    /// Those of the scheme tables A.8 to A.10, wherever they can be carried out.
    Tables,
}

/// Everything decided about a part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Plan {
    /// The part.
    pub part: Part,
    /// How cutting conditions were found.
    pub cutting: CuttingMethod,
    /// The groups of holes with their routes.
    pub holes: Vec<HolePlan>,
    /// The magazine.
    pub tools: Vec<ToolPlan>,
    /// How the part is clamped by straps; absent when no hole could be planned, or straps find no place.
    pub clamping: Option<Clamping>,
    /// Which tool visits which points, in order.
    pub sequence: Vec<ToolVisit>,
    /// How section 1.3.1 of the textbook would visit the holes of each group of more than one tool.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub visiting: Vec<Visiting>,
    /// Where the time goes.
    pub time: Times,
    /// How the part is set up.
    #[serde(default)]
    pub setup: Setup,
    /// What the reader must know.
    pub findings: Vec<Finding>,
}

impl Plan {
    /// What holds the part in a set-up, from 1. A vice, a chuck or a fixture of the shop's own holds it in both.
    pub const fn held(&self, set_up: u32) -> Held<'_> {
        match (&self.setup.own, &self.setup.vice, &self.setup.chuck, self.clamping_of(set_up)) {
            (Some(own), ..) => Held::Own(own),
            (None, Some(vice), ..) => Held::Vice(vice),
            (None, None, Some(chuck), _) => Held::Chuck(chuck),
            (None, None, None, Some(clamping)) => Held::Straps(clamping),
            (None, None, None, None) => Held::Nothing,
        }
    }

    /// The axis at which X and Y of a set-up are found by indicator, as the part lies: of the round pin, or of a round blank that no
    /// pins locate.
    pub fn zero_axis(&self, set_up: u32) -> Option<Point> {
        let of_disc = self.part.blank.is_round().then(|| self.part.middle());
        self.zero_pin(set_up).map(|pin| pin.at).or(of_disc)
    }

    /// The round pin at which X and Y of a set-up are found, where the part lies on a plane and two holes in it.
    pub fn zero_pin(&self, set_up: u32) -> Option<&LocatingPin> {
        let fixture = self.setup.fixture.as_ref().filter(|_| set_up == 1)?;
        fixture.pins.iter().find(|pin| pin.kind == PinKind::Round)
    }

    /// The zeros of a set-up, from 1, where it has several; the second has one, at the sides of the first.
    pub fn zeros_of(&self, set_up: u32) -> &[PartZero] {
        if set_up == 1 { &self.setup.zeros } else { &[] }
    }

    /// The stops of a visit in the order of the program: those of each zero of its set-up together, with the tool in the spindle.
    pub fn by_zero<'p>(&'p self, visit: &'p ToolVisit) -> Vec<Vec<&'p Stop>> {
        let zeros = self.zeros_of(visit.setup);
        let of = |stop: &Stop| zeros.iter().position(|zero| zero.holes.contains(&stop.hole)).unwrap_or_default();
        let stops = |zero: usize| visit.stops.iter().filter(|stop| of(stop) == zero).collect();
        (0..zeros.len().max(1)).map(stops).collect()
    }

    /// The clamps of a set-up, from 1: as the part lies then.
    pub const fn clamping_of(&self, set_up: u32) -> Option<&Clamping> {
        match set_up {
            1 => self.clamping.as_ref(),
            _ => self.setup.second_clamping.as_ref(),
        }
    }

    /// Whether something is wrong: a hole that cannot be made, a limit exceeded.
    pub fn has_errors(&self) -> bool {
        self.findings.iter().any(|finding| finding.severity <= Severity::Wrong)
    }

    /// Whether something is wrong with one group of holes.
    pub fn has_errors_of(&self, hole: &str) -> bool {
        self.findings.iter().any(|finding| finding.severity <= Severity::Wrong && finding.hole.as_deref() == Some(hole))
    }
}

/// A group of holes and how it is made.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct HolePlan {
    /// The group's name.
    pub name: String,
    /// The number of holes.
    pub count: usize,
    /// The scheme and why; absent when nothing works, which a finding explains.
    pub route: Option<Route>,
    /// The transitions in order.
    pub transitions: Vec<Transition>,
}

/// One transition of a group.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Transition {
    /// What is done.
    pub operation: Operation,
    /// What of the hole it makes.
    pub feature: Feature,
    /// The number of the step of a stepped hole it works on, from 1; absent for the main cylinder.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub step: Option<usize>,
    /// The face it is entered from; what is entered from the back face is done in the second set-up.
    pub face: Face,
    /// Where its cutting begins, below its face, mm.
    pub start_mm: Micrometres,
    /// Where its cutting ends, below its face, mm: the end of the full diameter.
    pub depth_mm: Micrometres,
    /// Whether it is done on another machine, because this one cannot: it is in no magazine, sequence or time.
    pub elsewhere: bool,
    /// What it also makes with the same stroke: a step drill's counterbore or chamfer, mm.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub also_diameter_mm: Option<Micrometres>,
    /// The accuracy and roughness it leaves, by the tables; absent for centring.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub achieved: Option<Achieved>,
    /// The diameter it leaves, mm; for centring the diameter of the spot.
    pub diameter_mm: Micrometres,
    /// The diameter before it, mm; zero in solid metal.
    pub from_diameter_mm: Micrometres,
    /// How often the tool is fed into the hole; how often a mill goes round in it is in `conditions.rounds`.
    pub passes: u32,
    /// Working travel of one pass: approach, depth, point and overrun, mm.
    pub travel_mm: Micrometres,
    /// How far above the beginning of its cutting the feed begins, mm.
    pub approach_mm: Micrometres,
    /// The cutter.
    pub tool: ToolRef,
    /// Its holder; the designation of the cutter itself when it carries the machine's taper.
    pub holder: HolderRef,
    /// The cutting conditions.
    pub conditions: Conditions,
    /// Why this diameter, tool and holder.
    pub because: Vec<Because>,
}

impl Transition {
    /// How far below its face the tool's tip goes: the depth, a drill's point and the overrun.
    pub fn end(&self) -> Micrometres {
        self.start_mm + self.travel_mm - self.approach_mm
    }
}

/// A cutter of a catalog.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct ToolRef {
    /// Its place in the magazine: T1, T2, …
    pub number: u32,
    /// Its designation.
    pub designation: String,
    /// Its table.
    pub table: String,
    /// Its own diameter, mm.
    pub diameter_mm: Micrometres,
}

/// A holder of a catalog.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct HolderRef {
    /// Its designation.
    pub designation: String,
    /// Its table.
    pub table: String,
    /// From the spindle's face to where the cutter's overhang begins, mm.
    pub length_mm: Micrometres,
}

/// Cutting conditions of one transition.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Conditions {
    /// Depth of cut, mm.
    pub depth_of_cut_mm: f64,
    /// Feed, mm/rev.
    pub feed_mm_per_rev: MillimetresPerRev,
    /// Cutting speed at the spindle step, m/min.
    pub speed_m_per_min: MetresPerMinute,
    /// Spindle step, 1/min.
    pub spindle_rpm: RevsPerMinute,
    /// Feed rate, mm/min.
    pub feed_mm_per_min: MillimetresPerMinute,
    /// Axial force, N; absent if no formula is known.
    pub axial_force_n: Option<Newtons>,
    /// Torque, N·m; absent if no formula is known.
    pub torque_n_m: Option<NewtonMetres>,
    /// Cutting power, kW; absent if no formula is known.
    pub power_kw: Option<Kilowatts>,
    /// Machine time of one hole, min.
    pub machine_time_min: Minutes,
    /// What held the conditions back.
    pub limited_by: Limit,
    /// Tool life at the speed of the spindle step, min: T·(V/Vstep)^(1/m).
    pub tool_life_min: Minutes,
    /// Whether the speed is for cutting with coolant; absent if the figures do not say.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub coolant: Option<bool>,
    /// The speed of the formula, or that of practice where it is faster, before the spindle's step was chosen, m/min.
    pub computed_speed_m_per_min: MetresPerMinute,
    /// The circles of a mill; absent for other tools.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub rounds: Option<Rounds>,
    /// What the normative card would print; only with the card method.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub card: Option<CardPoint>,
    /// The rows behind the figures.
    pub because: Vec<Because>,
}

impl Conditions {
    /// Those of work that only another machine does: but for its stock, here half of that on the diameter, they are not known.
    pub fn of_another_machine(stock: Micrometres) -> Self {
        Self {
            depth_of_cut_mm: stock.to_mm() / 2.0,
            feed_mm_per_rev: MillimetresPerRev(0.0),
            speed_m_per_min: MetresPerMinute(0.0),
            spindle_rpm: RevsPerMinute(0.0),
            feed_mm_per_min: MillimetresPerMinute(0.0),
            axial_force_n: None,
            torque_n_m: None,
            power_kw: None,
            machine_time_min: Minutes(0.0),
            limited_by: Limit::AnotherMachine,
            tool_life_min: Minutes(0.0),
            coolant: None,
            computed_speed_m_per_min: MetresPerMinute(0.0),
            rounds: None,
            card: None,
            because: Vec::new(),
        }
    }
}

/// How an end mill goes round in a hole: at every level it takes the stock in equal radial passes, and a last thin one where it
/// finishes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Rounds {
    /// The diameter before the first pass, mm.
    pub from_diameter_mm: Micrometres,
    /// The mill's own diameter, mm.
    pub mill_diameter_mm: Micrometres,
    /// Radial passes at each level.
    pub passes: u32,
    /// Axial levels.
    pub levels: u32,
    /// The radial stock of the last of the passes, mm, where it is a finishing one; absent where all are equal.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub finish_mm: Option<Micrometres>,
    /// Feed down, mm/min, where the mill cuts on its way down; absent where it goes down through an open hole.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub plunge_feed_mm_per_min: Option<MillimetresPerMinute>,
    /// In a slot, the feed of the mill's middle on the tightest of its arcs, mm/min: there the teeth are faster at the wall than along
    /// it. On wider ones it is r/R of the feed along the walls, r the radius of the mill's own way and R that of the wall, and no
    /// less than this. Absent for what is round, and where the mill only goes along the middle.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub arc_feed_mm_per_min: Option<MillimetresPerMinute>,
    /// Whether the first pass goes along the middle of a slot, in solid metal: it leaves a slot as wide as the mill.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub along_middle: bool,
}

impl Rounds {
    /// Whether they are the ways of a mill in a slot.
    pub const fn of_slot(&self) -> bool {
        self.along_middle || self.arc_feed_mm_per_min.is_some()
    }

    /// The diameter after a pass, counted from 1, of a hole or slot that is `diameter` wide after the last one.
    pub fn after(&self, pass: u32, diameter: Micrometres) -> Micrometres {
        if self.along_middle {
            let widening = i64::from(self.passes.saturating_sub(1).max(1));
            let stock = diameter - self.mill_diameter_mm;
            return self.mill_diameter_mm + stock.ratio(i64::from(pass.saturating_sub(1)), widening);
        }
        let passes = self.passes.max(1);
        // A thin last pass is not one of the equal ones.
        let finish = self.finish_mm.filter(|_| passes > 1);
        let (equal, thin) = finish.map_or((passes, Micrometres::ZERO), |finish| (passes - 1, finish + finish));
        if pass > equal {
            return diameter;
        }
        let stock = diameter - thin - self.from_diameter_mm;
        self.from_diameter_mm + stock.ratio(i64::from(pass), i64::from(equal))
    }
}

/// A point of the normative cards, before the corrections for material and tool.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CardPoint {
    /// Feed, mm/rev.
    pub feed_mm_per_rev: MillimetresPerRev,
    /// Speed, m/min.
    pub speed_m_per_min: MetresPerMinute,
    /// Axial force, N.
    pub axial_force_n: Option<Newtons>,
    /// Power, kW.
    pub power_kw: Option<Kilowatts>,
    /// Axial force after the worked example's material factor, N. The example divides by the factor by
    /// which it raises the feed; the plan's own force is the formula's at the feed taken.
    pub axial_force_by_book_n: Option<Newtons>,
    /// Power after the worked example's material factor, kW.
    pub power_by_book_kw: Option<Kilowatts>,
}

/// A tool in the magazine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ToolPlan {
    /// Its place: T1, T2, …
    pub number: u32,
    /// The cutter's designation.
    pub designation: String,
    /// The cutter's table.
    pub table: String,
    /// The cutter's diameter, mm.
    pub diameter_mm: Micrometres,
    /// The diameter of the catalog that it is ground down from, mm; absent if it is used as it is bought.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ground_from_mm: Option<Micrometres>,
    /// The diameter of the exchangeable pilot that guides a counterbore in the hole before it, mm; absent for other tools.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pilot_mm: Option<Micrometres>,
    /// The lead of a bottoming tap in pitches; absent for taps with the usual lead and for other tools.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lead_pitches: Option<f64>,
    /// The grade of the field H that a finishing reamer is bought for; absent for other tools.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bought_for_h: Option<ItGrade>,
    /// The holder's designation.
    pub holder: String,
    /// The holder's table.
    pub holder_table: String,
    /// How far the cutter stands out of its holder, mm.
    pub overhang_mm: Micrometres,
    /// From the spindle's face to the tip, mm.
    pub length_mm: Micrometres,
    /// The links from the spindle to the tip, in order.
    pub links: Vec<Link>,
    /// Mass of the assembly, kg, where the tables let it be found.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub mass_kg: Option<f64>,
    /// Which filling of the magazine it belongs to, from 1; a higher one is loaded by hand.
    pub load: u32,
    /// The number of its length corrector, H.
    pub corrector: u32,
    /// What the corrector holds, as G43 adds it: this length less the reference tool's, mm.
    pub correction_mm: Micrometres,
    /// The book's way of writing it: the longest length less this one, mm.
    pub book_correction_mm: Micrometres,
    /// Why.
    pub because: Vec<Because>,
}

/// A link of an assembly.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Link {
    /// `taper-7-24`, `holder` or `cutter`.
    pub kind: String,
    /// Its designation; of the taper its number.
    pub designation: String,
    /// Its table.
    pub table: String,
    /// What it adds to the length from the spindle's face, mm.
    pub length_mm: Micrometres,
}

/// How the part is clamped.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Clamping {
    /// The torque of the hole below that needs the largest force, N·m; another hole, farther from its clamp, may have
    /// a larger one.
    pub torque_n_m: NewtonMetres,
    /// The side force P = 2·M/D of milling or boring, N, where it needs the largest force; a drill has none.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub side_force_n: Option<Newtons>,
    /// The group of holes and the distance that need the largest force.
    pub hole: String,
    /// From that hole to the nearest clamp, mm.
    pub distance_mm: Micrometres,
    /// Clamping force, N: W = k·M/(f·d), or against sliding under a side force W = k·P/(f + f2).
    pub force_n: Newtons,
    /// The force on each clamp, N.
    pub force_per_clamp_n: Newtons,
    /// The screw.
    pub screw: String,
    /// What the screw bears at 80 MPa, N; below the force on each clamp it is too weak, and a finding says so.
    pub screw_bears_n: Newtons,
    /// Where the clamps press.
    pub clamps: Vec<Point>,
    /// Whether the clamps are the program's proposal.
    pub proposed: bool,
    /// The straps of a proposal, by its screw: tools go over them.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub strap: Option<Strap>,
    /// The safe distance from a clamp to the start point, mm.
    pub safe_distance_mm: Micrometres,
    /// Why.
    pub because: Vec<Because>,
}
