//! Finds cutter, holder and cutting conditions for each step of one hole, or says why there are none.

mod centring;
mod mills;
mod one_drill;
mod reach;

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use crate::chip_room::holder_over_face;
use crate::cutting::{self, CardDoubt, Cut, Surface};
use crate::error::{KnowledgeError, Refusal, Tried};
use crate::job::{self, Duration, Feeding};
use crate::knowledge::vocabulary::ToolMaterial;
use crate::note::{Because, Note};
use crate::part::{Hole, Part};
use crate::plan::{Conditions, Feature, HolderRef, Operation, ToolRef, Transition};
use crate::reason::Reason;
use crate::route::bores::EdgeCut;
use crate::route::point::point_angle;
use crate::route::{RouteStep, StepLocation};
use crate::shop::Shop;
use crate::tables::holes::HoleDefault;
use crate::tables::rules::{Lead, ReamerLeadFor};
use crate::tooling::{self, Assembly, CutterNeed};
use crate::units::{ItGrade, Micrometres, Roughness};

pub(super) use centring::widest_spot;
use one_drill::{SingleDrill, SingleKey};

/// A step with its tool and cutting conditions.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    /// The step; its reasons are among `because` below.
    pub step: RouteStep,
    /// Absent for centring until the whole part is known.
    pub tool: Option<Rc<FittedTool>>,
    pub travel: Micrometres,
    pub approach: Micrometres,
    pub conditions: Rc<Conditions>,
    /// The time of one pass in one hole.
    pub pass_time: Duration,
    /// What the card could not give for the conditions.
    pub doubts: Vec<CardDoubt>,
    /// Whether the step is a centring spot that also makes an edge of the hole.
    pub makes_edge: bool,
    pub because: Vec<Because>,
}

impl Fitted {
    /// The depth of its tip at the end of its travel.
    pub fn end(&self) -> Micrometres {
        self.step.place.start + self.travel - self.approach
    }

    /// The transition as a plan has it, with its tool number; the tool of a centring spot may not be chosen yet.
    pub fn transition(&self, number: u32) -> Transition {
        let mut because = self.because.clone();
        let tool = self.tool.as_deref();
        because.extend(tool.into_iter().flat_map(|tool| tool.because.iter().cloned()));
        let place = self.step.place;
        Transition {
            operation: self.step.operation,
            feature: place.feature,
            step: place.step,
            face: place.face,
            start_mm: place.start,
            depth_mm: place.depth,
            elsewhere: self.step.elsewhere,
            also_diameter_mm: self.step.also,
            achieved: self.step.achieved,
            diameter_mm: self.step.diameter,
            from_diameter_mm: self.step.from,
            passes: self.step.passes,
            travel_mm: self.travel,
            approach_mm: self.approach,
            tool: ToolRef {
                number,
                designation: tool.map(|tool| tool.designation.clone()).unwrap_or_default(),
                table: tool.map(|tool| tool.table.clone()).unwrap_or_default(),
                diameter_mm: tool.map(|tool| tool.diameter).unwrap_or_default(),
            },
            holder: HolderRef {
                designation: tool.map(|tool| tool.assembly.holder.clone()).unwrap_or_default(),
                table: tool.map(|tool| tool.assembly.holder_table.clone()).unwrap_or_default(),
                length_mm: tool.map(|tool| tool.assembly.holder_length).unwrap_or_default(),
            },
            conditions: (*self.conditions).clone(),
            because,
        }
    }
}

/// A cutter in its holder, as plain data.
#[derive(Clone, Debug)]
pub(super) struct FittedTool {
    pub designation: String,
    pub table: String,
    pub diameter: Micrometres,
    /// The diameter of its flat front, where the catalog has one.
    pub front: Option<Micrometres>,
    /// The size the cutter is ground or set to; it distinguishes two tools of one designation.
    pub size: Micrometres,
    /// The catalog diameter, where the cutter is ground down from it.
    pub ground_from: Option<Micrometres>,
    /// The hole that the pilot of a counterbore fits, where the catalog's has a bore for one.
    pub pilot: Option<Micrometres>,
    /// The lead of a tap in pitches, where it is not the usual one: a bottoming tap is a tool of its own.
    pub lead_pitches: Option<f64>,
    /// Whether it is a mill whose end teeth reach its middle.
    pub centre_cutting: bool,
    /// The assembly; its reasons are among those below.
    pub assembly: Assembly,
    pub because: Vec<Because>,
}

/// The cutter, conditions and travel of a step, without the step's own reasons; shared by all routes that have the
/// step.
#[derive(Clone, Debug)]
pub(super) struct ToolAndConditions {
    tool: Rc<FittedTool>,
    pub travel: Micrometres,
    pub conditions: Rc<Conditions>,
    /// The time of one pass in one hole.
    pub pass_time: Duration,
    doubts: Vec<CardDoubt>,
}

/// The key of an outfit: everything it depends on. The routes of one hole share most of their steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct StepKey {
    operation: Operation,
    place: StepLocation,
    diameter: Micrometres,
    nominal: Micrometres,
    from: Micrometres,
    entered: Option<Micrometres>,
    passes: u32,
    pitch: Option<Micrometres>,
    also: Option<Micrometres>,
    levels: bool,
    goes_round: bool,
    angle: Option<u32>,
    within: Option<Micrometres>,
    elsewhere: bool,
    /// The grade and roughness that the last single pass must leave.
    leaves: Option<(ItGrade, Roughness)>,
    eased: bool,
}

/// What all steps of a hole have in common.
pub(super) struct Fitting<'p, 'k> {
    hole: &'p Hole,
    edges: &'p [EdgeCut],
    shop: &'p Shop<'k>,
    /// Approach and overrun of a blind and of a through cut, with their reasons.
    travels: [(Micrometres, Micrometres, Because); 2],
    /// The widest spot a centring drill of the catalogs makes.
    pub(super) widest_spot: Micrometres,
    /// Point angles, degrees.
    drill_point: f64,
    core_drill_point: f64,
    surface: Surface,
    lead: Lead,
    clearance: Micrometres,
    floor_clearance: Micrometres,
    /// The lead of a reamer as a multiple of the lead that its stock requires.
    reamer_lead_share: f64,
    /// How far the front of a countersink that goes round an edge stays from the wall below.
    edge_clearance: Micrometres,
    /// The widest mill for a floor over the diameter of the hole, if there is one.
    floor_mill_share: f64,
    /// The middle of an end mill that has no teeth, over its diameter.
    mill_core_share: f64,
    /// How far above a flat floor a reamer or boring bar stops.
    flat_floor_gap: Micrometres,
    /// Room for chips below a reamer in a blind hole, where the part has it.
    reamer_chip_room: Micrometres,
    thickness: Micrometres,
    /// How far a holder must stay over the face.
    over_face: Micrometres,
    /// Lead of the tap, pitches, and its convention.
    tap_lead: (f64, HoleDefault),
    known: RefCell<BTreeMap<StepKey, Result<ToolAndConditions, Reason>>>,
    /// The conditions of centring spots computed so far.
    spots: RefCell<BTreeMap<SpotKey, Rc<Conditions>>>,
    /// The single drills compared with two-pass drilling so far; none where there are no conditions for them.
    single_drills: RefCell<BTreeMap<SingleKey, Option<SingleDrill>>>,
}

/// The key of a spot's conditions: the place of its step, the diameter after and before it, its passes, and the
/// travel.
type SpotKey = (StepLocation, Micrometres, Micrometres, u32, Micrometres);

impl<'p, 'k> Fitting<'p, 'k> {
    /// Takes approach, overrun, surface and reamer lead from their rules.
    pub fn new(
        hole: &'p Hole,
        edges: &'p [EdgeCut],
        part: &'p Part,
        shop: &'p Shop<'k>,
    ) -> Result<Self, KnowledgeError> {
        let knowledge = shop.knowledge;
        let travel = |through: bool| -> Result<(Micrometres, Micrometres, Because), KnowledgeError> {
            let rule = crate::zone::approach(part, through, knowledge)?;
            let (approach, overrun) = (rule.approach, rule.overrun);
            let note = Note::new("travel").with("approach", approach).with("overrun", overrun);
            Ok((approach, overrun, Because::row(rule.row, note)))
        };
        let travels = [travel(false)?, travel(true)?];

        let material_group = shop.material.group;
        let lead = knowledge.ask(&ReamerLeadFor { material_group })?.need(material_group)?.lead;
        Ok(Self {
            hole,
            edges,
            shop,
            travels,
            widest_spot: widest_spot(shop)?,
            drill_point: point_angle(knowledge, Operation::Drill),
            core_drill_point: point_angle(knowledge, Operation::CoreDrill),
            surface: cutting::factors::surface_of(hole.skin, shop)?,
            lead,
            clearance: shop.convention(HoleDefault::MillClearance)?,
            floor_clearance: shop.convention(HoleDefault::FloorClearance)?,
            reamer_lead_share: shop.share(HoleDefault::ReamerLeadShare)?,
            edge_clearance: shop.convention(HoleDefault::EdgeClearance)?,
            floor_mill_share: shop.share(HoleDefault::FloorMillShare)?,
            mill_core_share: shop.share(HoleDefault::MillCoreShare)?,
            flat_floor_gap: shop.convention(HoleDefault::FlatFloorGap)?,
            reamer_chip_room: shop.convention(HoleDefault::ReamerChipRoom)?,
            thickness: part.blank.thickness,
            over_face: holder_over_face(knowledge)?,
            tap_lead: (shop.share(HoleDefault::TapLeadPitches)?, HoleDefault::TapLeadPitches),
            known: RefCell::new(BTreeMap::new()),
            spots: RefCell::new(BTreeMap::new()),
            single_drills: RefCell::new(BTreeMap::new()),
        })
    }

    /// Taps with the lead of that convention.
    pub fn with_taps(mut self, lead: HoleDefault) -> Result<Self, KnowledgeError> {
        self.tap_lead = (self.shop.share(lead)?, lead);
        Ok(self)
    }

    /// Fits the steps of a hole in their order; the first step that cannot be fitted gives the reason.
    pub fn fit(&self, steps: Vec<RouteStep>, finish_elsewhere: bool) -> Tried<Vec<Fitted>> {
        let drill = steps.iter().find(|step| step.operation == Operation::Drill).map(|step| step.diameter);
        let mut fitted = Vec::with_capacity(steps.len());
        let mut left = steps.into_iter();
        while let Some(step) = left.next() {
            // The next step on the same cylinder.
            let own = (cylinder(&step), step.place.step);
            let follows = left.as_slice().iter().find(|next| (cylinder(next), next.place.step) == own);
            let follows = follows.map(|step| step.operation);
            fitted.push(if step.operation == Operation::CentreDrill {
                self.centre(step, drill.unwrap_or(self.hole.diameter.nominal))?
            } else {
                let last = follows.is_none_or(|next| next == Operation::Tap) && !finish_elsewhere;
                self.fit_step(step, follows, last)?
            });
        }
        Ok(fitted)
    }

    /// The cutter, conditions and travel of a step that is not centring.
    pub fn tool_and_conditions(
        &self,
        step: &RouteStep,
        follows: Option<Operation>,
        last: bool,
    ) -> Tried<ToolAndConditions> {
        let key = StepKey {
            operation: step.operation,
            place: step.place,
            diameter: step.diameter,
            nominal: step.nominal,
            from: step.from,
            entered: step.entered,
            passes: step.passes,
            pitch: step.pitch,
            also: step.also,
            levels: step.levels,
            goes_round: step.goes_round,
            angle: step.angle_millideg,
            within: step.entry_cylinder,
            elsewhere: step.elsewhere,
            leaves: left_by(step, last),
            eased: matches!(step.operation, Operation::Drill | Operation::DrillOut) && follows.is_some_and(eases),
        };
        let known = self.known.borrow().get(&key).cloned();
        let outfit = match known {
            Some(outfit) => outfit,
            None => {
                let outfit = Refusal::split(self.new_tool_and_conditions(step, follows, last))?;
                self.known.borrow_mut().insert(key, outfit.clone());
                outfit
            }
        };
        outfit.map_err(Refusal::Not)
    }

    /// One step that is not centring.
    pub fn fit_step(&self, mut step: RouteStep, follows: Option<Operation>, last: bool) -> Tried<Fitted> {
        let ToolAndConditions { tool, travel, conditions, pass_time, doubts } =
            self.tool_and_conditions(&step, follows, last)?;
        let mut because = std::mem::take(&mut step.because);
        let (approach, _, reason) = self.travels(step.place.through);
        because.push(reason.clone());
        because.extend(self.conventions(&step, &tool)?);
        let (tool, approach) = (Some(tool), *approach);
        Ok(Fitted { step, tool, travel, approach, conditions, pass_time, doubts, makes_edge: false, because })
    }

    /// The time of one pass in one hole, in the canned cycle that a program uses for it.
    fn pass_time(
        &self,
        step: &RouteStep,
        travel: Micrometres,
        approach: Micrometres,
        conditions: &Conditions,
    ) -> Result<Duration, KnowledgeError> {
        let feeding = Feeding {
            operation: step.operation,
            diameter: step.diameter,
            from: step.from,
            start: step.place.start,
            depth: step.place.depth,
            end: step.place.start + travel - approach,
            approach,
            pitch: step.pitch,
            slot: self.hole.slot_to(step.diameter),
            conditions,
        };
        let cycle = job::cycle(&feeding, Micrometres::ZERO, self.shop)?;
        Ok(cycle.duration(self.shop.machine.rapids()))
    }

    /// The conventions on which the lengths of a step rest.
    fn conventions(&self, step: &RouteStep, tool: &FittedTool) -> Result<Vec<Because>, KnowledgeError> {
        let mut because = Vec::new();
        let mut cite = |name, note: Note| -> Result<(), KnowledgeError> {
            because.push(Because::row(self.shop.default_row(name)?.row, note));
            Ok(())
        };
        let main = step.place.feature == Feature::Bore && step.place.step.is_none();
        match step.operation {
            // It is in the reasons of its route and its passes.
            _ if self.hole.slot.is_some() => {}
            Operation::Tap => cite(self.tap_lead.1, Note::new("tap-lead").with("lead", self.lead(step)))?,
            Operation::Mill if tool.centre_cutting && (step.levels || tool.diameter >= step.from) => {
                let note = Note::new("mill-cuts-down").with("percent", self.floor_mill_share * 100.0);
                cite(HoleDefault::FloorMillShare, note)?;
            }
            Operation::Mill if tool.diameter >= step.from => {
                let note = Note::new("mill-over-hole").with("hole", step.from);
                cite(HoleDefault::MillCoreShare, note.with("percent", self.mill_core_share * 100.0))?;
            }
            Operation::Mill => {
                let floor = step.levels;
                let name = if floor { HoleDefault::FloorClearance } else { HoleDefault::MillClearance };
                let clearance = if floor { self.floor_clearance } else { self.clearance };
                cite(name, Note::new("mill-clearance").with("clearance", clearance))?;
            }
            Operation::Countersink | Operation::Chamfer if step.goes_round => {
                let note = Note::new("countersink-goes-round").with("clearance", self.edge_clearance);
                cite(HoleDefault::EdgeClearance, note)?;
            }
            Operation::Drill | Operation::DrillOut if main && self.hole.thread.is_some() && !step.place.through => {
                let run_out = step.place.depth - self.hole.depth;
                let pitch = self.hole.thread.as_ref().map_or(0.0, |thread| thread.pitch.to_mm());
                let (lead, lead_name) = self.tap_lead;
                let short = run_out <= Micrometres::from_mm_rounded(pitch * lead);
                let name = if short { lead_name } else { HoleDefault::ThreadRunoutPitches };
                let code = if short { "thread-runout-short" } else { "thread-runout" };
                let usual = Micrometres::from_mm_rounded(pitch * self.shop.share(HoleDefault::ThreadRunoutPitches)?);
                let note = Note::new(code).with("runout", run_out);
                cite(name, if short { note.with("usual", usual) } else { note })?;
            }
            _ => {}
        }
        Ok(because)
    }

    fn new_tool_and_conditions(
        &self,
        step: &RouteStep,
        follows: Option<Operation>,
        last: bool,
    ) -> Tried<ToolAndConditions> {
        // The limits of another machine are not known.
        let other = step.elsewhere.then(|| self.shop.without_limits());
        let shop = other.as_ref().unwrap_or(self.shop);
        let (travel, reach) = self.travel(step);
        // What bars and reamers another machine has is not known; a tap is bought by the standard whatever machine drives it.
        let unknown = step.elsewhere && step.operation != Operation::Tap;
        let reach = if unknown { Micrometres::ZERO } else { reach };
        if step.operation == Operation::Mill {
            self.round_enough(step)?;
        }
        let need = CutterNeed {
            operation: step.operation,
            diameter: step.diameter,
            nominal: step.nominal,
            enters: step.entered.unwrap_or(step.from),
            passes: step.passes,
            reach,
            // A step drill has no flutes of one diameter, and its narrow part has a length of its own.
            chip_room: match step.also {
                None if !unknown => self.chip_room(step.operation, &step.place, step.diameter)?,
                _ => Micrometres::ZERO,
            },
            over_face: if unknown { Micrometres::ZERO } else { self.over_face },
            through: step.place.through,
            lead: Some(self.lead),
            thread: self.hole.thread_at(step.place.step).map(|thread| thread.id.as_str()),
            angle_millideg: step.angle_millideg,
            entry_cylinder: step.entry_cylinder,
            hole_above: self.step_above(step),
            clearance: if step.levels { self.floor_clearance } else { self.clearance },
            round: step.goes_round.then(|| self.wider_than_front(step)),
            plunges: (step.operation == Operation::Counterbore).then(|| self.plunging(step, 0.0)),
            grind_limit: self.shop.grind_limit(step.diameter)?,
        };
        let found = match step.also {
            Some(wide) => {
                let pilot = reach - self.opening_depth();
                let opening =
                    if self.flat_opening_depth().is_some() { Operation::Counterbore } else { Operation::Chamfer };
                tooling::find_step_drill(&need, wide, pilot, opening, shop)?
            }
            None if self.hole.slot.is_some() => self.find_slot_mill(step, &need, shop)?,
            None if step.operation == Operation::Mill => self.find_mill(step, &need, shop)?,
            None => tooling::find_tool(&need, shop)?,
        };
        let (cutter, mut assembly) = found.map_err(|why| Refusal::Not(Reason::no_tool(step.operation, why)))?;
        // A step drill continues until its wide part is as deep as the opening.
        let travel = match (step.also, cutter.row.step_length) {
            (Some(_), Some(pilot)) => self.travels(step.place.through).0 + self.opening_depth() + pilot,
            _ => travel + self.beyond_cone(step, cutter.row.tip_diameter),
        };
        let roughness = left_by(step, last).map(|(_, roughness)| roughness);
        let cut = Cut {
            around: cutter.row.tip_diameter.filter(|_| step.goes_round).map(|tip| tip + self.wider_than_front(step)),
            nose_radius: cutter.row.nose_radius,
            flutes: cutter.row.flute_length,
            roughness,
            cutter: cutter_shape(&cutter),
            ..self.cut(step, follows, cutter.head.material, travel)
        };
        let own = cutter.diameter + Micrometres::new(1);
        let cut = match step.operation {
            // It makes its way itself.
            _ if self.hole.slot.is_some() => Cut { plunges: step.from == Micrometres::ZERO, ..cut },
            // It goes down in the middle and cuts the cone of the drill as far as its own radius.
            Operation::Mill if step.levels => {
                Cut { from: own, plunges: true, it: cut.it.filter(|_| step.from < step.diameter), ..cut }
            }
            Operation::Mill if step.from < own => Cut { from: own, plunges: true, ..cut },
            _ => cut,
        };
        let (conditions, doubts) = cutting::with_doubts(&cut, shop)?;
        let mut because = vec![cutter.order(), cutter.because()];
        // A reamer or core drill of the catalogs, wider than asked, is ground down.
        let grinds = step.operation.is_reaming() || step.operation == Operation::CoreDrill;
        if grinds && cutter.diameter > step.nominal {
            let limit = self.shop.grind_limit(step.diameter)?;
            let absolute = limit == self.shop.convention(HoleDefault::CutterGrindLimit)?;
            let name = if absolute { HoleDefault::CutterGrindLimit } else { HoleDefault::CutterGrindShare };
            let note = Note::new("ground-within").with("limit", limit);
            because.push(Because::row(self.shop.default_row(name)?.row, note));
        }
        because.append(&mut assembly.because);
        let tool = FittedTool {
            designation: cutter.designation.to_owned(),
            table: cutter.row.row.table.id.clone(),
            diameter: cutter.diameter,
            front: cutter.row.tip_diameter,
            size: if fixed_size(step.operation) { cutter.diameter } else { step.diameter },
            ground_from: (grinds && cutter.diameter > step.diameter.min(step.nominal)).then_some(cutter.diameter),
            pilot: cutter.row.pilot_bore.filter(|_| step.operation == Operation::Counterbore).map(|_| step.from),
            lead_pitches: (step.operation == Operation::Tap && self.tap_lead.1 != HoleDefault::TapLeadPitches)
                .then_some(self.tap_lead.0),
            centre_cutting: cutter.head.centre_cutting,
            assembly,
            because,
        };
        let pass_time = self.pass_time(step, travel, self.travels(step.place.through).0, &conditions)?;
        Ok(ToolAndConditions { tool: Rc::new(tool), travel, conditions: Rc::new(conditions), pass_time, doubts })
    }

    fn cut(&self, step: &RouteStep, follows: Option<Operation>, material: ToolMaterial, travel: Micrometres) -> Cut {
        Cut {
            operation: step.operation,
            diameter: step.also.unwrap_or(step.diameter),
            from: step.from,
            passes: step.passes,
            depth: step.place.depth - step.place.start,
            travel,
            tool_material: material,
            nose_radius: None,
            roughness: None,
            reamer_follows: follows.is_some_and(eases),
            blind: !step.place.through,
            surface: self.surface,
            cutter: None,
            pitch: step.pitch,
            it: step.required_finish.map(|(grade, _)| grade),
            feed_diameter: step.also.map(|_| step.diameter),
            tool_diameter: step.also.map(|_| step.diameter),
            flutes: None,
            around: None,
            plunges: false,
            slot: self.hole.slot_to(step.diameter),
        }
    }
}

/// The feed travel of a step in one pass, and the approach above the metal.
///
/// # Errors
/// The knowledge base has no answer.
pub fn feed_travel(
    step: &RouteStep,
    hole: &Hole,
    part: &Part,
    shop: &Shop<'_>,
) -> Result<(Micrometres, Micrometres), KnowledgeError> {
    let fitting = Fitting::new(hole, &[], part, shop)?;
    Ok((fitting.travel(step).0, fitting.travels(step.place.through).0))
}

/// The grade and surface that a step must leave with a last single pass; earlier passes, and stock for another
/// machine, need no finishing feed.
fn left_by(step: &RouteStep, last: bool) -> Option<(ItGrade, Roughness)> {
    step.required_finish.filter(|_| last && step.passes == 1)
}

/// The cylinder that a step works on; a thread belongs to the cylinder of its hole.
fn cylinder(step: &RouteStep) -> Feature {
    match step.place.feature {
        Feature::Thread if step.place.step.is_none() => Feature::Bore,
        Feature::Thread => Feature::Step,
        feature => feature,
    }
}

/// Whether the tool does not depend on the diameter it leaves: a mill moves round, a cone is cut as wide as the tool
/// goes deep.
const fn fixed_size(operation: Operation) -> bool {
    matches!(
        operation,
        Operation::Mill | Operation::Chamfer | Operation::Countersink | Operation::CentreDrill | Operation::Tap
    )
}

/// Whether a drill before this transition has half the feed (table `feed-factor`): before accurate finishing or
/// tapping.
const fn eases(next: Operation) -> bool {
    next.is_reaming() || matches!(next, Operation::Tap)
}

/// The shape of an end mill, where the row has teeth.
fn cutter_shape(cutter: &tooling::Cutter<'_, '_>) -> Option<cutting::CutterShape> {
    let teeth = u32::try_from(cutter.row.teeth?).ok()?;
    let cutting_length = cutter.row.cutting_length?;
    Some(cutting::CutterShape { diameter: cutter.diameter, teeth, cutting_length })
}
