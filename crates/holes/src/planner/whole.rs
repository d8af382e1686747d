//! All steps of a hole for one candidate: main cylinder, wider cylinders, edges and floor, in the order of section
//! 1.1.2, each step with its tool and conditions.

use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::job::{Duration, Hands};
use crate::note::{Because, Note};
use crate::part::{Face, Hole, Part};
use crate::plan::{Feature, Operation, Preference};
use crate::reason::Reason;
use crate::route::bores::{self, Bore, Task};
use crate::route::diameters::{self, Sizes};
use crate::route::scheme::SchemeQuestion;
use crate::route::{Candidate, Remark, RouteStep, accuracy, openings, order, search};
use crate::shop::Shop;
use crate::tables::holes::SchemesOfMainHole;
use crate::tables::rules::TransitionOrder;
use crate::units::{ItGrade, Micrometres, Minutes};

use super::fit::{Fitted, Fitting};

/// What makes one way to open a cylinder worse than another, in this order: a good part left unfinished over the shoulder, a last
/// resort, finished here where the tables leave it to another machine, anything left unfinished over the shoulder, bored without
/// need, its time.
type Worse = (bool, bool, bool, bool, bool, Minutes);

/// The steps that open a wider cylinder, or why there are none.
type OpeningSteps = Result<Vec<RouteStep>, Reason>;

/// The steps of an attempt with their tools, or why there are none and the drill that the machine does not bear.
type Attempted = Result<Vec<Fitted>, (Reason, Option<Micrometres>)>;

/// What is needed to find the routes of one group.
pub(super) struct Finder<'a, 'k> {
    pub hole: &'a Hole,
    pub part: &'a Part,
    pub preference: Preference,
    pub task: &'a Task,
    pub fitting: &'a Fitting<'a, 'k>,
    pub question: SchemeQuestion<'a>,
    pub sizes: Sizes<'a>,
    pub position: accuracy::Position,
    pub shop: &'a Shop<'k>,
    /// The best steps to open each wider cylinder from a diameter, found so far.
    pub opened: RefCell<BTreeMap<(usize, Micrometres), OpeningSteps>>,
    pub rapids_between: Minutes,
    /// The times of the operator's manual work.
    pub hands: Hands,
    /// The step that cuts each edge, or why there is none.
    pub edges: Vec<Result<RouteStep, Reason>>,
    /// The finest grade that drilling holds, by table A.1.
    pub drilled: ItGrade,
    /// The edge that centring makes.
    pub centred_edge: Option<bores::EdgeCut>,
}

impl Finder<'_, '_> {
    /// Time of steps in all holes of the group; each step has a tool change of its own.
    pub fn cost(&self, steps: &[RouteStep]) -> Tried<Minutes> {
        let mut minutes = 0.0;
        for step in steps {
            minutes += self.shop.machine.tool_change.0 + self.rapids_between.0;
            if step.operation == Operation::CentreDrill {
                continue;
            }
            let outfit = self.fitting.tool_and_conditions(step, None, false)?;
            minutes += self.time_of(step, outfit.pass_time);
        }
        Ok(Minutes(minutes))
    }

    /// Time of a step in all holes of the group, with approach and retract, and with the setting of the bar between
    /// passes, min.
    pub fn time(&self, fitted: &Fitted) -> f64 {
        self.time_of(&fitted.step, fitted.pass_time)
    }

    fn time_of(&self, step: &RouteStep, took: Duration) -> f64 {
        if step.elsewhere {
            return 0.0;
        }
        let passes = f64::from(step.passes.max(1));
        let set = if step.operation.is_set_by_hand(step.passes) { passes * self.hands.set_bar.0 } else { 0.0 };
        took.total().0 * passes * self.hole.at.len() as f64 + set
    }

    /// The steps of the whole hole for a candidate: as the rules prefer, otherwise with one drill, otherwise with
    /// boring in place of milling.
    pub fn carried_out(&self, candidate: &Candidate, joined: bool) -> Tried<Vec<Fitted>> {
        self.by_first_attempt(candidate, joined, &[(false, false), (true, false), (false, true), (true, true)])
    }

    /// As `carried_out`, but with one drill only.
    pub fn carried_out_alone(&self, candidate: &Candidate) -> Tried<Vec<Fitted>> {
        self.by_first_attempt(candidate, false, &[(true, false), (true, true)])
    }

    /// The steps by the first attempt that succeeds. An attempt says whether to drill in one pass and whether to bore
    /// what would be milled. Where the machine does not bear a drill of theirs, they are made without drills of that size.
    fn by_first_attempt(&self, candidate: &Candidate, joined: bool, attempts: &[(bool, bool)]) -> Tried<Vec<Fitted>> {
        let mut drills = self.sizes.drills.to_vec();
        let mut first_why = None;
        loop {
            let sizes = Sizes { drills: &drills, ..self.sizes };
            let (why, not_borne) = match self.attempted(candidate, joined, attempts, sizes)? {
                Ok(fitted) => return Ok(fitted),
                Err(why) => why,
            };
            // The first reason is reported: what comes after it only tries to avoid it.
            let first = first_why.get_or_insert(why).clone();
            match not_borne.and_then(|drill| drills.iter().position(|own| *own == drill)) {
                Some(at) => drills.remove(at),
                None => return Err(Refusal::Not(first)),
            };
        }
    }

    /// The steps by the first attempt that succeeds; otherwise the first reason, and the drill that the machine does not bear.
    fn attempted(
        &self,
        candidate: &Candidate,
        joined: bool,
        attempts: &[(bool, bool)],
        sizes: Sizes<'_>,
    ) -> Result<Attempted, KnowledgeError> {
        let (mut first_why, mut not_borne) = (None, None);
        for &(single_drill, bore_large) in attempts {
            let sizes = Sizes { single_drill, bore_large, ..sizes };
            let steps = match Refusal::split(diameters::steps(candidate, &self.task.main, &sizes, self.shop))? {
                Ok(steps) => steps,
                Err(why) => {
                    first_why.get_or_insert(why);
                    continue;
                }
            };
            let both = steps.iter().any(|step| step.operation == Operation::DrillOut);
            let drills: Vec<(Operation, Micrometres)> =
                steps.iter().map(|step| (step.operation, step.diameter)).collect();
            match Refusal::split(self.fit_hole(steps, candidate, joined))? {
                Ok(mut fitted) => {
                    if both {
                        self.fitting.compare_with_one_drill(&mut fitted)?;
                    }
                    return Ok(Ok(fitted));
                }
                Err(why) => {
                    let unborne = why.drill_not_borne();
                    let drill = drills.iter().find(|(operation, _)| Some(*operation) == unborne);
                    not_borne = not_borne.or(drill.map(|(_, diameter)| *diameter));
                    first_why.get_or_insert(why);
                }
            }
        }
        Ok(Err((first_why.unwrap_or(Reason::NoRoute), not_borne)))
    }

    /// Adds openings, edges and the floor to the steps of the main cylinder, in the order of section 1.1.2,
    /// and fits them all.
    fn fit_hole(&self, mut steps: Vec<RouteStep>, candidate: &Candidate, joined: bool) -> Tried<Vec<Fitted>> {
        let main = &self.task.main;
        let finish = main.required_finish(self.shop)?;
        for step in &mut steps {
            step.required_finish = Some(finish);
        }
        let promise = candidate.promise.filter(|_| !candidate.finish_elsewhere);
        accuracy::write(&mut steps, main, promise, self.position, self.shop)?;
        if self.sizes.level_floor {
            self.flat_floor(&mut steps)?;
        }
        self.fitting.room_for_leads(&mut steps, main.flat);
        self.fitting.pilots_to_the_point(&mut steps);
        for step in &mut steps {
            step.elsewhere |= step.operation == Operation::Tap && !self.shop.machine.can_tap;
        }
        let centred = steps.iter().any(|step| step.operation == Operation::CentreDrill);
        let made = if centred { self.fitting.edge_by_centring()? } else { None };
        let also = if joined { self.join(&mut steps, made.is_some())? } else { None };
        let opened_from = roughed(&steps);
        let mut before = [opened_from, opened_from];
        for (index, bore) in self.task.wider.iter().enumerate().filter(|(_, bore)| also != Some(bore.place.feature)) {
            let side = usize::from(bore.place.face == Face::Back);
            let opening = self.open(index, bore, before[side])?;
            before[side] = roughed(&opening);
            steps.extend(opening);
        }
        for (edge, step) in self.task.edges.iter().zip(&self.edges).filter(|(edge, _)| Some(**edge) != made) {
            match step {
                _ if also == Some(edge.feature) => {}
                Ok(step) => steps.push(step.clone()),
                // An edge that centring makes in other routes is not made in this one.
                Err(why) if Some(*edge) == self.centred_edge => return Err(Refusal::Not(why.clone())),
                Err(_) => {}
            }
        }
        order::sort(&mut steps, self.shop)?;
        self.within_its_cylinder(&mut steps);
        self.fitting.fit(steps, candidate.finish_elsewhere)
    }

    /// Work on a cylinder after wider ones above it were opened begins below those; the finishing of the main
    /// cylinder ends where the cylinders of the back face begin.
    fn within_its_cylinder(&self, steps: &mut [RouteStep]) {
        let back = self.task.wider.iter().filter(|bore| bore.place.face == Face::Back);
        let main_end = back.map(|bore| self.task.main.place.depth - bore.place.depth).min();
        // The cylinders opened so far: diameter and depth.
        let mut opened: Vec<(Face, Micrometres, Micrometres)> = Vec::new();
        for step in steps.iter_mut() {
            let face = step.place.face;
            let own = match (step.place.feature, step.place.step) {
                (Feature::Bore | Feature::Thread, None) => self.task.main.diameter.nominal,
                (Feature::Step | Feature::Thread, number) => {
                    let known = self.task.wider.iter().find(|bore| bore.place.step == number);
                    known.map_or(step.diameter, |bore| bore.diameter.nominal)
                }
                (Feature::Counterbore, _) => step.diameter,
                _ => continue,
            };
            let above = opened.iter().filter(|(side, wider, _)| *side == face && *wider > own);
            let below = above.map(|(.., depth)| *depth).max();
            if step.also.is_none()
                && let Some(below) = below.filter(|below| *below > step.place.start && *below < step.place.depth)
            {
                step.place.start = below;
            }
            let main = step.place.step.is_none() && matches!(step.place.feature, Feature::Bore | Feature::Thread);
            if main
                && face == Face::Entry
                && finishes(step.operation)
                && let Some(end) = main_end.filter(|end| *end > step.place.start && *end < step.place.depth)
            {
                step.place.depth = end;
            }
            match (step.also, self.drilled_opening()) {
                (Some(_), Some(bore)) => opened.push((face, bore.diameter.nominal, bore.place.depth)),
                _ if !main => opened.push((face, own, step.place.depth)),
                _ => {}
            }
        }
    }

    /// A flat floor: drills stop where their points touch it, core drills where the drill's cone begins, because they do not cut
    /// in the middle; an end mill then levels the floor, the one that opens the cylinder where there is one.
    fn flat_floor(&self, steps: &mut Vec<RouteStep>) -> Tried<()> {
        if !self.task.main.flat {
            return Ok(());
        }
        let pointed =
            |step: &RouteStep| matches!(step.operation, Operation::Drill | Operation::DrillOut | Operation::CoreDrill);
        let Some(last) = steps.iter().rposition(pointed) else { return Ok(()) };
        let (diameter, depth, whole) = (steps[last].diameter, steps[last].place.depth, steps[last].place);
        let mut open = depth;
        for step in steps[..=last].iter_mut().filter(|step| pointed(step)) {
            let core = step.operation == Operation::CoreDrill;
            let stop = if core { open } else { depth } - self.fitting.lead(step);
            if stop <= Micrometres::ZERO {
                return Err(Refusal::Not(Reason::TooShallowForFlat { depth, diameter: step.diameter }));
            }
            step.place.depth = stop;
            open = stop;
        }
        let stop = steps[..=last].iter().filter(|step| pointed(step)).map(|step| step.place.depth).min();
        let stop = stop.unwrap_or(depth);
        if steps.get(last + 1).is_none_or(|next| !next.levels) {
            let mut floor = RouteStep { levels: true, ..RouteStep::plain(Operation::Mill, whole, diameter, diameter) };
            floor.place.start = stop;
            steps.insert(last + 1, floor);
        }
        steps[last + 1].because.push(Because::table(
            self.shop.knowledge.table_of::<TransitionOrder<'_>>()?,
            Note::new("flat-floor").with("stop", stop).with("depth", depth),
        ));
        Ok(())
    }

    /// The quickest steps that open a wider cylinder from a diameter.
    fn open(&self, index: usize, bore: &Bore, start: Micrometres) -> Tried<Vec<RouteStep>> {
        if let Some(known) = self.opened.borrow().get(&(index, start)) {
            return known.clone().map_err(Refusal::Not);
        }
        let found = Refusal::split(self.opening(bore, start))?;
        self.opened.borrow_mut().insert((index, start), found.clone());
        found.map_err(Refusal::Not)
    }

    fn opening(&self, bore: &Bore, start: Micrometres) -> Tried<Vec<RouteStep>> {
        let question = SchemeQuestion { bore, ..self.question };
        let sizes = Sizes { start: Some(start), ..self.sizes };
        let cost = |steps: &[RouteStep]| self.cost(steps);
        let (boring, finish) = (self.boring_required()?, bore.required_finish(self.shop)?);
        let mut best: Option<(Worse, Vec<RouteStep>)> = None;
        let mut why = None;
        for candidate in openings::candidates(bore, &question, &sizes, &cost, self.shop)? {
            for bore_large in [false, true] {
                let sizes = Sizes { bore_large, ..sizes };
                let made = diameters::steps(&candidate, bore, &sizes, self.shop).and_then(|mut steps| {
                    for step in &mut steps {
                        step.required_finish = Some(finish);
                    }
                    let promise = candidate.promise.filter(|_| !candidate.finish_elsewhere);
                    accuracy::write(&mut steps, bore, promise, self.position.following(), self.shop)?;
                    if candidate.finish_elsewhere
                        && let Some(last) = steps.last_mut()
                    {
                        last.remarks.push(Remark::FinishedElsewhere(bore.diameter.clone()));
                        let note = Note::new("step-finished-elsewhere").with("diameter", &bore.diameter);
                        // A.8 is the table that leaves a finish to another machine.
                        let table = self.shop.knowledge.tables_of::<SchemesOfMainHole<'_>>().next();
                        last.because.extend(table.map(|table| Because::table(table, note)));
                    }
                    cone_above_shoulder(&mut steps, bore, start, self.fitting)?;
                    // What cuts the shoulder goes down to it, the rest stops above.
                    if bore.flat
                        && let Some(cut) = steps.iter().position(|step| search::leaves_flat(step.operation))
                    {
                        self.fitting.stop_above_floor(&mut steps[cut + 1..], |operation| {
                            operation.is_reaming() || operation.is_boring() || operation == Operation::CoreDrill
                        });
                    }
                    for step in &mut steps {
                        step.elsewhere |= step.operation == Operation::Tap && !self.shop.machine.can_tap;
                    }
                    Ok((self.cost(&steps)?, steps))
                });
                match Refusal::split(made)? {
                    Ok((minutes, mut steps)) => {
                        // As of the main cylinder: beside a mill, time decides.
                        let mills = steps.iter().any(|step| step.operation == Operation::Mill);
                        let bores = !boring && !mills && steps.iter().any(|step| step.operation.is_boring());
                        // Here too, what the tables finish on another machine is left for that machine.
                        let here = !candidate.finish_elsewhere;
                        let last = candidate.last_resort;
                        // A seat of which reamers leave a good part stands back behind any that is finished.
                        let mut short = false;
                        for step in &steps {
                            short |= step.leaves_unfinished(bore.diameter.it, self.shop)?.is_some();
                        }
                        let above = |remark: &Remark| matches!(remark, Remark::EndsAboveFloor(_));
                        let left = steps.iter().any(|step| step.remarks.iter().any(above));
                        let worse: Worse = (short, last, here, left, bores, minutes);
                        if best.as_ref().is_none_or(|(least, _)| worse < *least) {
                            if let Some(first) = steps.first_mut() {
                                first.because.extend(candidate.because.clone());
                            }
                            best = Some((worse, steps));
                        }
                        break;
                    }
                    // The search is the last source, so its reason is the one to report.
                    Err(found) => why = Some(found),
                }
            }
        }
        let none = Reason::NoOpening { diameter: bore.diameter.nominal, start };
        best.map(|(_, steps)| steps).ok_or_else(|| Refusal::Not(why.unwrap_or(none)))
    }
}

/// The step that cuts each edge of a hole, or why there is none; a face for which the catalogs have no counterbore is
/// milled, and round an edge that is wider than every countersink one goes.
pub(super) fn edges(
    task: &Task,
    fitting: &Fitting<'_, '_>,
    shop: &Shop<'_>,
) -> Result<Vec<Result<RouteStep, Reason>>, KnowledgeError> {
    let mut steps = Vec::with_capacity(task.edges.len());
    for edge in &task.edges {
        let cut = |operation: Option<Operation>, goes_round: bool| -> Tried<RouteStep> {
            let mut step = RouteStep { goes_round, ..openings::edge(edge, edge.cylinder_diameter, shop)? };
            step.operation = operation.unwrap_or(step.operation);
            fitting.fit_step(step.clone(), None, false)?;
            Ok(step)
        };
        let mut found = Refusal::split(cut(None, false))?;
        if edge.feature == Feature::Face && found.is_err() {
            found = Refusal::split(cut(Some(Operation::Mill), false))?;
        }
        // Where no countersink is wide enough to be sunk, one goes round; if that fails too, the first reason is told.
        if edge.feature != Feature::Face && found.is_err() && shop.machine.contouring {
            found = Refusal::split(cut(None, true))?.or(found);
        }
        steps.push(found);
    }
    Ok(steps)
}

/// Over a flat shoulder a drill stops where the rim of its point touches the shoulder; the rest is cut flat by the
/// next step.
fn cone_above_shoulder(
    steps: &mut [RouteStep],
    bore: &Bore,
    start: Micrometres,
    fitting: &Fitting<'_, '_>,
) -> Tried<()> {
    if !bore.flat {
        return Ok(());
    }
    for step in steps.iter_mut().filter(|step| step.operation == Operation::DrillOut) {
        let (depth, diameter) = (step.place.depth, step.diameter);
        step.place.depth = depth - (fitting.point(diameter) - fitting.point(start));
        if step.place.depth <= Micrometres::ZERO {
            return Err(Refusal::Not(Reason::TooShallowForFlat { depth, diameter }));
        }
    }
    Ok(())
}

/// Whether a transition only improves the surface of its cylinder, so that it need not go beyond the cylinder.
fn finishes(operation: Operation) -> bool {
    operation.is_reaming()
        || matches!(
            operation,
            Operation::SemiFinishBore | Operation::FinishBore | Operation::CoreDrill | Operation::Tap
        )
}

/// The diameter of the main cylinder when the openings are made: that after its roughing.
fn roughed(steps: &[RouteStep]) -> Micrometres {
    let rough = |step: &&RouteStep| {
        matches!(
            step.operation,
            Operation::Drill | Operation::DrillOut | Operation::Mill | Operation::RoughBore | Operation::Counterbore
        )
    };
    let last = steps.iter().filter(rough).map(|step| step.diameter).max();
    last.or_else(|| steps.iter().map(|step| step.diameter).min()).unwrap_or_default()
}

/// The smallest hole that a boring bar of the catalogs can enter.
pub(super) fn smallest_bore(shop: &Shop<'_>) -> Result<Micrometres, KnowledgeError> {
    let bars = shop.shelf.cutters_for(Operation::RoughBore)?;
    Ok(bars.iter().filter_map(|bar| bar.diameter_min).min().unwrap_or_default())
}

/// Time of the rapids between the holes of one group for one tool: for comparing routes, not the path itself.
pub(super) fn rapids_between(hole: &Hole, shop: &Shop<'_>) -> Minutes {
    let mut points = hole.at.clone();
    points.sort_unstable();
    let length: f64 =
        points.windows(2).map(|pair| (pair[0].x - pair[1].x).abs().max((pair[0].y - pair[1].y).abs()).to_mm()).sum();
    Minutes(length / shop.machine.rapid.0)
}
