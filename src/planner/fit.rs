//! Gives the steps of one hole their cutters, holders and conditions, or says why one cannot have them.

use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::cutting::{self, Cut};
use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::units::Unit;
use crate::knowledge::{Input, Knowledge, RowRef};
use crate::note::{Because, Note};
use crate::part::{Entry, Face, Hole, Part};
use crate::plan::{Conditions, Feature, Operation};
use crate::route::bores::Edge;
use crate::route::{Place, Step};
use crate::shop::Shop;
use crate::tooling::{self, Assembly, CutterNeed};
use crate::units::{Decimal, ItGrade, Micrometres, Roughness, round_to};

/// A step with what it is done with.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    pub step: Step,
    /// Absent for centring until the whole part is known.
    pub tool: Option<FittedTool>,
    pub travel: Micrometres,
    pub approach: Micrometres,
    pub conditions: Conditions,
    pub because: Vec<Because>,
}

/// A cutter in its holder, in plain data.
#[derive(Clone, Debug)]
pub(super) struct FittedTool {
    pub designation: String,
    pub table: String,
    pub diameter: Micrometres,
    /// The size it is ground or set to; distinguishes two tools of one designation.
    pub size: Micrometres,
    pub assembly: Assembly,
    pub because: Vec<Because>,
}

/// The cutter, conditions and travel of a step, without its own reasons.
#[derive(Clone, Debug)]
struct Outfit {
    tool: FittedTool,
    travel: Micrometres,
    conditions: Conditions,
}

/// What the outfit of a step depends on; the routes of one hole share most of their steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    operation: Operation,
    place: Place,
    diameter: Micrometres,
    nominal: Micrometres,
    from: Micrometres,
    passes: u32,
    pitch: Option<Micrometres>,
    also: Option<Micrometres>,
    angle: Option<u32>,
    within: Option<Micrometres>,
    elsewhere: bool,
    asks: Option<(ItGrade, Roughness)>,
    eased: bool,
    last: bool,
}

/// The point angle of the centring drills (A.14: 2φ = 90°), thousandths of a degree.
const CENTRING_ANGLE: u32 = 90_000;

/// What every step of a hole shares.
pub(super) struct Fitting<'p, 'k> {
    hole: &'p Hole,
    edges: &'p [Edge],
    shop: &'p Shop<'k>,
    /// Approach and overrun of a blind and of a through cut.
    travels: [(Micrometres, Micrometres, Because); 2],
    /// The widest spot a centring drill of the catalogs makes.
    pub(super) widest_spot: Micrometres,
    /// Point angles, degrees.
    drill_point: f64,
    core_drill_point: f64,
    surface: &'k str,
    lead: &'k str,
    clearance: Micrometres,
    floor_clearance: Micrometres,
    grind_limit: Micrometres,
    /// Lead of a tap, pitches.
    tap_lead: f64,
    known: RefCell<BTreeMap<Key, Result<Outfit, Note>>>,
}

impl<'p, 'k> Fitting<'p, 'k> {
    /// Approach, overrun, surface and reamer lead by their rules.
    pub fn new(hole: &'p Hole, edges: &'p [Edge], part: &'p Part, shop: &'p Shop<'k>) -> Result<Self, KnowledgeError> {
        let knowledge = shop.knowledge;
        let entry = if part.entry == Entry::Rough { "rough" } else { "machined" };
        let rule = knowledge.table("approach")?;
        let travel = |through: bool| -> Result<(Micrometres, Micrometres, Because), KnowledgeError> {
            let answer = rule.decide(&[("entry", Input::Text(entry)), ("through", Input::Bool(through))])?;
            let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, entry))?;
            let (approach, overrun) = (row.length("approach")?, row.length("overrun")?);
            let note = Note::new("travel").with("approach", approach).with("overrun", overrun);
            Ok((approach, overrun, Because::row(row, note)))
        };
        let travels = [travel(false)?, travel(true)?];

        let rule = knowledge.table("surface")?;
        let group = Input::Text(shop.material.group);
        let answer = rule.decide(&[("skin", Input::Bool(hole.skin)), ("material_group", group)])?;
        let surface = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, shop.material.group))?;

        let rule = knowledge.table("reamer-lead")?;
        let answer = rule.decide(&[("material_group", group)])?;
        let lead = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, shop.material.group))?;
        Ok(Self {
            hole,
            edges,
            shop,
            travels,
            widest_spot: widest_spot(knowledge)?,
            drill_point: point_angle(knowledge, Operation::Drill),
            core_drill_point: point_angle(knowledge, Operation::CoreDrill),
            surface: surface.text("surface")?,
            lead: lead.text("lead")?,
            clearance: shop.convention("mill-clearance-mm")?,
            floor_clearance: shop.convention("floor-clearance-mm")?,
            grind_limit: shop.convention("cutter-grind-limit-mm")?,
            tap_lead: shop.share("tap-lead-pitches")?,
            known: RefCell::new(BTreeMap::new()),
        })
    }

    fn travels(&self, through: bool) -> &(Micrometres, Micrometres, Because) {
        &self.travels[usize::from(through)]
    }

    /// How deep a drill of that diameter must reach in a cylinder: depth, point and overrun.
    pub fn drill_reach(&self, place: &Place, diameter: Micrometres) -> Micrometres {
        place.depth + cone(diameter, self.drill_point) + self.travels(place.through).1
    }

    /// The height of a drill's point.
    pub fn point(&self, diameter: Micrometres) -> Micrometres {
        cone(diameter, self.drill_point)
    }

    /// Fits every step of a hole in their order; the first that cannot be fitted says why.
    pub fn fit(&self, steps: Vec<Step>, finish_elsewhere: bool) -> Tried<Vec<Fitted>> {
        let drill = steps.iter().find(|step| step.operation == Operation::Drill).map(|step| step.diameter);
        let mut fitted = Vec::with_capacity(steps.len());
        for index in 0..steps.len() {
            let step = &steps[index];
            // What follows on the same cylinder.
            let own = (cylinder(step), step.place.step);
            let follows = steps[index + 1..].iter().find(|next| (cylinder(next), next.place.step) == own);
            let follows = follows.map(|step| step.operation);
            let step = step.clone();
            fitted.push(if step.operation == Operation::CentreDrill {
                self.centre(step, drill.unwrap_or(self.hole.diameter.nominal))?
            } else {
                let last = follows.is_none_or(|next| next == Operation::Tap) && !finish_elsewhere;
                self.one(step, follows, last)?
            });
        }
        Ok(fitted)
    }

    /// The edge at the entry that centring makes with its spot, by the rule `centre-spot`: a chamfer or a
    /// countersink of 90° around the main cylinder, where a centring drill of the catalogs is wide enough.
    pub fn edge_by_centring(&self) -> Result<Option<Edge>, KnowledgeError> {
        let around = self.hole.diameter.nominal;
        // A face that is cut after it would take the spot away.
        if self.edges.iter().any(|edge| edge.feature == Feature::Face) {
            return Ok(None);
        }
        let edge = self.edges.iter().find(|edge| {
            edge.face == Face::Entry
                && edge.start == Micrometres::ZERO
                && matches!(edge.feature, Feature::Chamfer | Feature::Countersink)
                && edge.angle_millideg == CENTRING_ANGLE
                && edge.around == around
                && edge.diameter <= self.widest_spot
        });
        let Some(edge) = edge else { return Ok(None) };
        Ok((self.spot_rule(true)?.text("spot")? == "chamfer").then_some(*edge))
    }

    fn spot_rule(&self, chamfer: bool) -> Result<RowRef<'k>, KnowledgeError> {
        let rule = self.shop.knowledge.table("centre-spot")?;
        let diameter = ("diameter", Input::Length(self.hole.diameter.nominal));
        let answer = rule.decide(&[("chamfer", Input::Bool(chamfer)), diameter])?;
        answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this hole"))
    }

    /// Centring: the spot by the rule `centre-spot`; its tool is chosen for the whole part.
    fn centre(&self, step: Step, drill: Micrometres) -> Tried<Fitted> {
        let (row, spot, note) = match self.edge_by_centring()? {
            Some(edge) => (self.spot_rule(true)?, edge.diameter, Note::new("spot-by-chamfer")),
            None => {
                // Where no centring drill is wide enough for the chamfer, the spot is that of a hole without one.
                let row = match self.spot_rule(self.hole.chamfer.is_some())? {
                    row if row.text("spot")? == "chamfer" => self.spot_rule(false)?,
                    row => row,
                };
                let share = row.number_in("share", Unit::None)?;
                let spot = Micrometres::from_mm_rounded(drill.to_mm() * share);
                // A spot of 90° is half as deep as wide: in a thin plate it stays within half of the hole.
                let most = self.hole.depth;
                if spot > most {
                    (row, most, Note::new("spot-by-depth").with("share", share))
                } else {
                    (row, spot, Note::new("spot-by-drill").with("share", share))
                }
            }
        };
        let note = note.with("spot", spot).with("drill", drill);
        let depth = spot.half();
        let travel = self.travels(false).0 + depth;
        let place = Place { depth, through: false, ..step.place };
        let step = Step { diameter: spot, nominal: spot, place, ..step };
        let cut = Cut { depth, travel, ..self.cut(&step, None, "HSS", travel) };
        let conditions = cutting::conditions(&cut, self.shop)?;
        let mut because = step.because.clone();
        because.push(Because::row(row, note));
        Ok(Fitted { step, tool: None, travel, approach: self.travels(false).0, conditions, because })
    }

    /// One step that is not centring.
    pub fn one(&self, step: Step, follows: Option<Operation>, last: bool) -> Tried<Fitted> {
        let key = Key {
            operation: step.operation,
            place: step.place,
            diameter: step.diameter,
            nominal: step.nominal,
            from: step.from,
            passes: step.passes,
            pitch: step.pitch,
            also: step.also,
            angle: step.angle_millideg,
            within: step.within,
            elsewhere: step.elsewhere,
            asks: step.asks,
            eased: follows.is_some_and(eases),
            last,
        };
        let known = self.known.borrow().get(&key).cloned();
        let outfit = match known {
            Some(outfit) => outfit,
            None => {
                let outfit = Refusal::split(self.outfit(&step, follows, last))?;
                self.known.borrow_mut().insert(key, outfit.clone());
                outfit
            }
        };
        let outfit = outfit.map_err(Refusal::Not)?;
        let mut because = step.because.clone();
        let (approach, _, reason) = self.travels(step.place.through);
        because.push(reason.clone());
        let Outfit { tool, travel, conditions } = outfit;
        Ok(Fitted { step, tool: Some(tool), travel, approach: *approach, conditions, because })
    }

    fn outfit(&self, step: &Step, follows: Option<Operation>, last: bool) -> Tried<Outfit> {
        // Another machine has other limits, which are not known here.
        let other = step.elsewhere.then(|| self.shop.without_limits());
        let shop = other.as_ref().unwrap_or(self.shop);
        let (travel, reach) = self.travel(step);
        // How far a tap of that machine would reach is not known here either.
        let reach = if step.elsewhere { Micrometres::ZERO } else { reach };
        if step.operation == Operation::Mill {
            self.round_enough(step)?;
        }
        let need = CutterNeed {
            operation: step.operation,
            diameter: step.diameter,
            nominal: step.nominal,
            enters: step.from,
            reach,
            through: step.place.through,
            lead: self.lead,
            thread: self.hole.thread_at(step.place.step).map(|thread| thread.id.as_str()),
            angle_millideg: step.angle_millideg,
            within: step.within,
            below: self.step_above(step),
            clearance: if step.from == step.diameter { self.floor_clearance } else { self.clearance },
            grind_limit: self.grind_limit,
        };
        let found = match step.also {
            Some(wide) => {
                let pilot = reach - self.opening_depth();
                let opening = if self.flat_opening().is_some() { Operation::Counterbore } else { Operation::Chamfer };
                tooling::find_step_drill(&need, wide, pilot, opening, shop.knowledge, &shop.machine)?
            }
            None => tooling::find_tool(&need, shop.knowledge, &shop.machine)?,
        };
        let (cutter, assembly) = found.map_err(|why| Refusal::Not(first_of(why, step.operation)))?;
        // A step drill goes on until its wide part is as deep as the opening.
        let travel = match (step.also, cutter.row.length("step_length")) {
            (Some(_), Ok(pilot)) => self.travels(step.place.through).0 + self.opening_depth() + pilot,
            _ => travel,
        };
        let nose_radius = cutter.row.length("nose_radius").ok();
        // The surface asked for is left by a last single pass; passes before it, and stock for another
        // machine, need no finish feed.
        let roughness = step.asks.filter(|_| last && step.passes == 1).map(|(_, roughness)| roughness);
        let cut = Cut {
            nose_radius,
            roughness,
            cutter: cutter_shape(&cutter),
            ..self.cut(step, follows, &cutter.head.material, travel)
        };
        // On a floor the mill cuts as far as its own radius.
        let cut = if step.operation == Operation::Mill && step.from == step.diameter {
            Cut { from: (step.diameter - cutter.diameter).max(cutter.diameter + Micrometres::new(1)), ..cut }
        } else {
            cut
        };
        let conditions = cutting::conditions(&cut, shop)?;
        let mut because = vec![cutter.order.clone(), cutter.because.clone()];
        because.extend(assembly.because.clone());
        let tool = FittedTool {
            designation: cutter.designation.to_owned(),
            table: cutter.row.table.id.clone(),
            diameter: cutter.diameter,
            size: if fixed_size(step.operation) { cutter.diameter } else { step.diameter },
            assembly,
            because,
        };
        Ok(Outfit { tool, travel, conditions })
    }

    /// Where a step of the main cylinder begins below wider ones, and the diameter of the narrowest of those.
    fn step_above(&self, step: &Step) -> Option<(Micrometres, Micrometres)> {
        let main = step.place.step.is_none() && step.place.start > Micrometres::ZERO;
        let wider = self.hole.steps.iter().filter(|step| step.face == Face::Entry).map(|step| step.diameter.nominal);
        let around = wider.chain(self.hole.counterbore.map(|counterbore| counterbore.diameter)).min()?;
        (main && step.operation == Operation::Tap).then_some((step.place.start, around))
    }

    /// How deep the wide part of a step drill goes: the counterbore or step, or the edge it chamfers.
    fn opening_depth(&self) -> Micrometres {
        let edge = || self.edges.iter().find(|edge| edge.face == Face::Entry).map(|edge| edge.depth(Micrometres::ZERO));
        self.flat_opening().or_else(edge).unwrap_or_default()
    }

    /// The depth of the counterbore or step at the entry, if there is one.
    fn flat_opening(&self) -> Option<Micrometres> {
        let step = self.hole.steps.iter().find(|step| step.face == Face::Entry);
        self.hole.counterbore.map(|counterbore| counterbore.depth).or(step.map(|step| step.depth))
    }

    /// A milled cylinder is as round as the machine makes it, which may take a share of the tolerance.
    fn round_enough(&self, step: &Step) -> Tried<()> {
        let Some(roundness) = self.shop.machine.roundness else { return Ok(()) };
        let tolerance = match step.place.step {
            Some(number) => self.hole.steps.get(number - 1).map(|step| (&step.diameter.upper, &step.diameter.lower)),
            None if step.place.feature == Feature::Bore => Some((&self.hole.diameter.upper, &self.hole.diameter.lower)),
            None => None,
        };
        let target = match step.place.step {
            Some(number) => self.hole.steps.get(number - 1).map(|step| step.diameter.target()),
            None => Some(self.hole.diameter.target()),
        };
        let Some((upper, lower)) = tolerance.filter(|_| target == Some(step.diameter)) else { return Ok(()) };
        let share = self.shop.share("milled-roundness-share")?;
        let most = Micrometres::from_mm_rounded((*upper - *lower).to_mm() * share);
        if roundness > most {
            let note = Note::new("milled-not-round").with("roundness", roundness).with("most", most);
            return Err(Refusal::Not(note.with("diameter", step.diameter)));
        }
        Ok(())
    }

    fn cut<'c>(&'c self, step: &Step, follows: Option<Operation>, material: &'c str, travel: Micrometres) -> Cut<'c> {
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
            it: step.asks.map(|(it, _)| it),
            feed_diameter: step.also.map(|_| step.diameter),
        }
    }

    /// How far a tool's point goes beyond the full diameter.
    pub fn lead(&self, step: &Step) -> Micrometres {
        match step.operation {
            Operation::Drill | Operation::DrillOut => cone(step.diameter, self.drill_point),
            Operation::CoreDrill => cone(step.diameter - step.from, self.core_drill_point),
            // The thread is full only behind the tap's lead.
            Operation::Tap => Micrometres::from_mm_rounded(step.pitch.unwrap_or_default().to_mm() * self.tap_lead),
            _ => Micrometres::ZERO,
        }
    }

    /// Working travel of one pass, and how far the cutter must reach below its face.
    fn travel(&self, step: &Step) -> (Micrometres, Micrometres) {
        let lead = self.lead(step);
        let (approach, overrun, _) = self.travels(step.place.through);
        let reach = step.place.depth + lead + *overrun;
        (*approach + reach - step.place.start, reach)
    }

    /// What the tools do beyond the hole: a drill's point through a blind hole's floor, a spot deeper than
    /// the hole.
    pub fn beyond(&self, fitted: &[Fitted], thickness: Micrometres) -> Vec<Note> {
        let mut notes = Vec::new();
        for one in fitted {
            let step = &one.step;
            let main = step.place.feature == Feature::Bore;
            let (depth, limit, code) = match step.operation {
                Operation::Drill | Operation::DrillOut if main && !step.place.through => {
                    (step.place.depth + self.point(step.diameter), thickness, "point-breaks-through")
                }
                Operation::CentreDrill => (step.diameter.half(), self.hole.depth, "spot-too-deep"),
                _ => continue,
            };
            if depth >= limit {
                notes.push(Note::new(code).with("depth", depth).with("limit", limit).with("diameter", step.diameter));
            }
        }
        notes
    }

    /// Says what the second drill costs in time and saves in thrust against one drill of full size.
    pub fn compare_with_one_drill(&self, fitted: &mut [Fitted]) -> Result<(), KnowledgeError> {
        let Some(second) = fitted
            .iter()
            .position(|one| one.step.operation == Operation::DrillOut && one.step.place.feature == Feature::Bore)
        else {
            return Ok(());
        };
        let single = Step {
            operation: Operation::Drill,
            from: Micrometres::ZERO,
            because: Vec::new(),
            ..fitted[second].step.clone()
        };
        let (travel, _) = self.travel(&single);
        let follows = fitted.get(second + 1).map(|one| one.step.operation);
        let cut = self.cut(&single, follows, "HSS", travel);
        let Ok(one) = cutting::conditions(&cut, self.shop) else { return Ok(()) };
        let pair = &fitted[second.saturating_sub(1)..=second];
        let time: f64 = pair.iter().map(|step| step.conditions.machine_time_min.0).sum();
        let thrust = pair
            .iter()
            .filter_map(|step| step.conditions.axial_force_n)
            .fold(0.0, |most: f64, force| most.max(force.0));
        let table = self.shop.knowledge.table("two-pass-drilling")?;
        let note = Note::new("two-passes-cost")
            .with("time", format!("{:+.3}", time - one.machine_time_min.0))
            .with("thrust", round_to(thrust, 0))
            .with(
                "one-thrust",
                one.axial_force_n.map_or_else(|| "-".to_owned(), |force| round_to(force.0, 0).to_string()),
            );
        fitted[second].because.push(Because::table(table, note));
        Ok(())
    }
}

/// How far the tool of somebody's step goes in one pass, and how far above the metal its feed begins.
///
/// # Errors
/// The knowledge cannot answer.
pub(crate) fn way(
    step: &Step,
    hole: &Hole,
    part: &Part,
    shop: &Shop<'_>,
) -> Result<(Micrometres, Micrometres), KnowledgeError> {
    let fitting = Fitting::new(hole, &[], part, shop)?;
    Ok((fitting.travel(step).0, fitting.travels(step.place.through).0))
}

/// The cylinder a step works on: a thread is that of its hole.
fn cylinder(step: &Step) -> Feature {
    match step.place.feature {
        Feature::Thread if step.place.step.is_none() => Feature::Bore,
        Feature::Thread => Feature::Step,
        feature => feature,
    }
}

/// Whether the tool is the same whatever diameter it leaves: a mill goes round, a cone is cut as wide as the
/// tool is driven in.
const fn fixed_size(operation: Operation) -> bool {
    matches!(
        operation,
        Operation::Mill | Operation::Chamfer | Operation::Countersink | Operation::CentreDrill | Operation::Tap
    )
}

/// Whether a drill before this transition is fed at half (table `feed-factor`): accurate finishing or tapping.
const fn eases(next: Operation) -> bool {
    next.is_reaming() || matches!(next, Operation::Tap)
}

/// The shape of an end mill, where the row has teeth.
fn cutter_shape(cutter: &tooling::Cutter<'_>) -> Option<cutting::CutterShape> {
    let teeth = u32::try_from(cutter.row.int("teeth").ok()?).ok()?;
    let cutting_length = cutter.row.length("cutting_length").ok()?;
    Some(cutting::CutterShape { diameter: cutter.diameter, teeth, cutting_length })
}

/// The widest centring drill of table A.14.
fn widest_spot(knowledge: &Knowledge) -> Result<Micrometres, KnowledgeError> {
    let table = knowledge.table("A.14")?;
    Ok(table.all_rows().filter_map(|row| row.length("diameter").ok()).max().unwrap_or_default())
}

/// The sharpest point among the tables of an operation's cutters, degrees: the longest cone, so that every
/// one of them clears the hole. 180, a flat end, where no table names an angle.
fn point_angle(knowledge: &Knowledge, operation: Operation) -> f64 {
    knowledge
        .tables()
        .filter_map(|table| table.tool.as_ref())
        .filter(|head| head.operations.iter().any(|name| name == operation.name()))
        .filter_map(|head| head.point_angle)
        .min()
        .map_or(180.0, Decimal::to_f64)
}

/// Height of a cone over a diameter: d/2 / tan(φ/2), the point of a drill or the lead of a core drill.
fn cone(diameter: Micrometres, angle_deg: f64) -> Micrometres {
    Micrometres::from_mm_rounded(diameter.to_mm() / 2.0 / libm::tan((angle_deg / 2.0).to_radians()))
}

/// One reason stands for all, how many there were is said with it: the first that is about the cutter and
/// not about a holder that takes other shanks.
fn first_of(why: Vec<Note>, operation: Operation) -> Note {
    const MISMATCHES: [&str; 5] =
        ["shank-outside-clamp", "other-morse", "other-bore", "other-taper", "thread-outside-chuck"];
    let count = why.len();
    let telling = why.iter().position(|note| !MISMATCHES.contains(&note.code.as_str())).unwrap_or_default();
    let first = why.into_iter().nth(telling).unwrap_or_else(|| Note::new("no-cutter"));
    let first = if first.params.contains_key("operation") { first } else { first.with("operation", operation.name()) };
    if count > 1 { first.with("more", count - 1) } else { first }
}
