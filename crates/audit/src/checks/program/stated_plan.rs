//! The stated plan in the form of a plan of the program, so that a program can be compared with it: the stated rows,
//! tools and conditions, completed from the program's own plan only where nothing is stated.

use crate::error::KnowledgeError;
use crate::knowledge::diagnostic::Place;
use crate::note::{Figure, Note};
use crate::part::{Clamp, Face, Hole, Part, Point};
use crate::plan::{
    Conditions, Feature, HolderRef, HolePlan, Limit, Operation, Plan, Rounds, ToolPlan, ToolRef, Transition,
};
use crate::planner;
use crate::program::Setting;
use crate::route::{RouteStep, StepLocation as Where};
use crate::sequence;
use crate::tables::materials::ClampScrew;
use crate::units::{MetresPerMinute, Micrometres, MillimetresPerMinute, MillimetresPerRev, Minutes, RevsPerMinute};

use super::super::super::context::Context;
use super::super::super::figures::{Nature, nature};
use super::super::super::graph::{Graph, Status};
use super::super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::super::stated::Row;

/// Which figures of a plan its program is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reading {
    /// Those that are stated.
    Stated,
    /// The corrected ones: wrong figures are replaced.
    Right,
}

/// Why a program cannot be compared with a plan, with the place in the file.
#[derive(Debug)]
pub(super) struct NotComparable {
    pub note: Note,
    pub place: Option<Place>,
}

type Comparable<T> = Result<T, NotComparable>;

/// The stated plan in the form of a plan of the program, or why there is none.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn comparable_plan(
    context: &Context<'_>,
    graph: &Graph<'_>,
    setting: &Setting,
    reading: Reading,
) -> Result<Comparable<Plan>, KnowledgeError> {
    let mut plan = match unordered(context, graph, setting, reading)? {
        Ok(plan) => plan,
        Err(why) => return Ok(Err(why)),
    };
    plan.sequence = sequence::sequence(&plan.part, &plan.holes, &context.shop.machine, None);
    Ok(Ok(plan))
}

/// As above, but without the order over the points.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn unordered(
    context: &Context<'_>,
    graph: &Graph<'_>,
    setting: &Setting,
    reading: Reading,
) -> Result<Comparable<Plan>, KnowledgeError> {
    let stated = context.stated;
    if stated.rows.is_empty() {
        return Ok(Err(NotComparable { note: Note::new("audit-program-no-route"), place: None }));
    }
    if let Some(row) = stated.rows.iter().find(|row| row.hole.is_none() && !row.elsewhere) {
        return Ok(Err(not_comparable(row, "audit-program-row-hole")));
    }
    let making = Making { context, graph, setting, reading };
    let ours = context.plan;
    let mut plan = Plan {
        part: clamped(context)?,
        cutting: ours.cutting,
        holes: Vec::new(),
        tools: Vec::new(),
        clamping: ours.clamping.clone(),
        setup: ours.setup.clone(),
        sequence: Vec::new(),
        visiting: ours.visiting.clone(),
        time: ours.time,
        findings: ours.findings.clone(),
    };
    // In the order of the part, because `sequence` goes through both together.
    for hole in &stated.part.holes {
        let mut transitions: Vec<Transition> = Vec::new();
        for (at, row) in stated.rows_of_hole(&hole.name) {
            let transition = match making.transition(hole, at, transitions.last())? {
                Ok(transition) => transition,
                Err(why) => return Ok(Err(why)),
            };
            let number = transition.tool.number;
            if !transition.elsewhere && !plan.tools.iter().any(|tool| tool.number == number) {
                plan.tools.push(making.tool(number, row));
            }
            transitions.push(transition);
        }
        plan.holes.push(HolePlan { name: hole.name.clone(), count: hole.at.len(), route: None, transitions });
    }
    plan.tools.sort_by_key(|tool| tool.number);
    Ok(Ok(plan))
}

/// The part under the clamps of the plan, where its file has none. A clamp of which nobody says how high it is stands at least as high as
/// its screw is thick: the nut alone has 0.8 of that (ISO 4032), and the strap under it more than the rest.
fn clamped(context: &Context<'_>) -> Result<Part, KnowledgeError> {
    let mut part = context.plan.part.clone();
    let stated = context.stated.clamping.as_ref();
    if part.fixture.clamps.is_empty() {
        let places = stated.map(|own| own.at.as_slice()).unwrap_or_default();
        let screw = stated.and_then(|own| own.screw.as_ref()).map(|screw| screw.value.replace('М', "M"));
        let clamp = |at: &Point| Clamp { at: *at, screw: screw.clone(), height: None, outline: None };
        part.fixture.clamps = places.iter().map(clamp).collect();
    }
    let screws = context.shop.knowledge.rows::<ClampScrew<'_>>()?;
    let thinnest = screws.iter().map(|screw| screw.nominal_diameter).min();
    for clamp in part.fixture.clamps.iter_mut().filter(|clamp| clamp.height.is_none()) {
        let own = screws.iter().find(|screw| clamp.screw.as_deref() == Some(screw.thread));
        clamp.height = own.map(|screw| screw.nominal_diameter).or(thinnest);
    }
    Ok(part)
}

fn not_comparable(row: &Row, code: &'static str) -> NotComparable {
    let note = Note::new(code).with("row", row.number).with("operation", Figure::operation(row.operation.value.name()));
    NotComparable { note, place: Some(row.place.clone()) }
}

struct Making<'c, 'a, 'g> {
    context: &'c Context<'a>,
    graph: &'c Graph<'g>,
    setting: &'c Setting,
    reading: Reading,
}

impl Making<'_, '_, '_> {
    /// A figure as the plan has it. A misplaced decimal point does not count: the author meant the right value.
    fn figure(&self, id: Id) -> Option<f64> {
        let stated = self.context.stated.figure(id)?.value;
        let Some(verdict) = self.graph.verdict(id) else { return Some(stated) };
        let comma = nature(stated, verdict.right) == Nature::DecimalPoint;
        match verdict.status {
            Status::Fine => Some(stated),
            Status::Root(_, None) if comma => Some(verdict.right),
            _ if self.reading == Reading::Right => Some(verdict.right),
            _ => Some(stated),
        }
    }

    fn length(&self, row: usize, quantity: Q) -> Option<Micrometres> {
        self.figure(Id::new(Scope::Row(row), quantity)).map(Micrometres::from_mm_rounded)
    }

    /// The transition that a row states.
    fn transition(
        &self,
        hole: &Hole,
        at: usize,
        before: Option<&Transition>,
    ) -> Result<Comparable<Transition>, KnowledgeError> {
        let row = &self.context.stated.rows[at];
        let operation = row.operation.value;
        let ours = self.own_transition(hole, at);
        let elsewhere = row.elsewhere || ours.is_some_and(|ours| ours.elsewhere);
        let mut made = ours.cloned().unwrap_or_else(|| blank(row));
        made.elsewhere = elsewhere;
        if elsewhere {
            return Ok(Ok(made));
        }
        let Some(tool) = &row.tool else { return Ok(Err(not_comparable(row, "audit-program-row-tool"))) };
        made.tool.number = tool.value;
        let bored = before.filter(|before| !before.operation.is_of_edge()).map(|before| before.diameter_mm);
        let diameter = self.length(at, Q::Diameter).or(ours.map(|ours| ours.diameter_mm));
        let diameter = diameter
            .or_else(|| hole.thread_at(row.step).filter(|_| operation == Operation::Tap).map(|thread| thread.size));
        let Some(diameter) = diameter.filter(|diameter| *diameter > Micrometres::ZERO) else {
            return Ok(Err(not_comparable(row, "audit-program-row-diameter")));
        };
        let from = self.length(at, Q::From).or(ours.map(|ours| ours.from_diameter_mm)).or(bored).unwrap_or_default();
        // The cone of a centring drill has 90°: its depth is half its width.
        let spot = ours.is_none_or(|ours| ours.diameter_mm != diameter) && operation == Operation::CentreDrill;
        let depth = self.length(at, Q::Depth).or(spot.then(|| diameter.half())).or(ours.map(|ours| ours.depth_mm));
        let depth = depth.or((row.of_main_cylinder() && !operation.is_of_edge()).then_some(hole.depth));
        let Some(depth) = depth else { return Ok(Err(not_comparable(row, "audit-program-row-depth"))) };
        made.also_diameter_mm = self.length(at, Q::Also).or(made.also_diameter_mm);
        if let Some(passes) = self.figure(Id::new(Scope::Row(at), Q::Passes)) {
            made.passes = passes.max(1.0) as u32;
        }
        let same = ours
            .is_some_and(|ours| (ours.diameter_mm, ours.from_diameter_mm, ours.depth_mm) == (diameter, from, depth));
        if !same {
            (made.travel_mm, made.approach_mm) = self.travel_and_approach(hole, row, ours, [diameter, from, depth])?;
        }
        (made.diameter_mm, made.from_diameter_mm, made.depth_mm) = (diameter, from, depth);
        if operation == Operation::Tap && hole.thread_at(made.step).is_none() {
            return Ok(Err(not_comparable(row, "audit-program-row-thread")));
        }
        if operation == Operation::Mill {
            let Some(rounds) = self.rounds(row, ours, from) else {
                return Ok(Err(not_comparable(row, "audit-program-row-mill")));
            };
            made.conditions.rounds = Some(rounds);
        }
        Ok(self.conditions(at, ours.is_some(), made).ok_or_else(|| not_comparable(row, "audit-program-row-conditions")))
    }

    /// The transition of the program's plan that a row means: of the same operation and place, in order.
    fn own_transition(&self, hole: &Hole, at: usize) -> Option<&Transition> {
        let stated = self.context.stated;
        let row = stated.rows.get(at)?;
        let alike = |operation: Operation, feature: Option<Feature>, step: Option<usize>| {
            operation == row.operation.value
                && (row.feature.is_none() || feature.is_none() || feature == row.feature)
                && (row.step.is_none() || step == row.step)
        };
        let earlier = stated.rows_of_hole(&hole.name).take_while(|(other, _)| *other < at);
        let turn = earlier.filter(|(_, other)| alike(other.operation.value, other.feature, other.step)).count();
        let plan = self.context.plan.holes.iter().find(|plan| plan.name == hole.name)?;
        plan.transitions
            .iter()
            .filter(|transition| alike(transition.operation, Some(transition.feature), transition.step))
            .nth(turn)
    }

    /// Travel and approach of a transition that differs from the program's in a diameter or depth.
    fn travel_and_approach(
        &self,
        hole: &Hole,
        row: &Row,
        ours: Option<&Transition>,
        [diameter, from, depth]: [Micrometres; 3],
    ) -> Result<(Micrometres, Micrometres), KnowledgeError> {
        let step = |through: bool, [diameter, from, depth]: [Micrometres; 3]| {
            let place = Where {
                feature: ours.map_or(Feature::Bore, |ours| ours.feature),
                step: row.step,
                face: Face::Entry,
                start: ours.map(|ours| ours.start_mm).unwrap_or_default(),
                depth,
                through,
            };
            let pitch = hole.thread_at(row.step).map(|thread| thread.pitch);
            RouteStep { pitch, ..RouteStep::plain(row.operation.value, place, diameter, from) }
        };
        let measured = |through, sizes| {
            planner::feed_travel(&step(through, sizes), hole, &self.context.stated.part, &self.context.shop)
        };
        let bores = row.of_main_cylinder() && !row.operation.value.is_of_edge();
        let mut through = hole.through && bores && row.operation.value != Operation::CentreDrill;
        if let Some(ours) = ours {
            // An existing transition shows whether this one may run out at the other end.
            let sizes = [ours.diameter_mm, ours.from_diameter_mm, ours.depth_mm];
            through = measured(true, sizes)?.0 == ours.travel_mm;
        }
        measured(through, [diameter, from, depth])
    }

    /// The circles of a mill: those of the program's plan with the stated diameters.
    fn rounds(&self, row: &Row, ours: Option<&Transition>, from: Micrometres) -> Option<Rounds> {
        let ours = ours.and_then(|ours| ours.conditions.rounds);
        let tool = self.context.stated.tool_of(row);
        let of_catalog = tool.and_then(|tool| self.context.cutter(tool)?.row.diameter);
        let stated = tool.and_then(|tool| self.figure(Id::new(Scope::Tool(tool), Q::Diameter)));
        let mill = of_catalog.or(stated.map(Micrometres::from_mm_rounded)).or(ours.map(|ours| ours.mill_diameter_mm));
        let from_diameter_mm =
            if row.figures.contains_key(&Q::From) { Some(from) } else { ours.map(|ours| ours.from_diameter_mm) };
        let passes = row.figures.get(&Q::Passes).map(|passes| passes.value.max(1.0) as u32);
        Some(Rounds {
            from_diameter_mm: from_diameter_mm?,
            mill_diameter_mm: mill?,
            passes: passes.or(ours.map(|ours| ours.passes)).unwrap_or(1),
            levels: ours.map_or(1, |ours| ours.levels),
            finish_mm: ours.and_then(|ours| ours.finish_mm),
            plunge_feed_mm_per_min: ours.and_then(|ours| ours.plunge_feed_mm_per_min),
            arc_feed_mm_per_min: ours.and_then(|ours| ours.arc_feed_mm_per_min),
            along_middle: ours.is_some_and(|ours| ours.along_middle),
        })
    }

    /// The transition with the speed and feed of its row; none if neither plan has them.
    fn conditions(&self, at: usize, ours: bool, mut made: Transition) -> Option<Transition> {
        let figure = |quantity: fn(&super::super::super::stated::Conditions) -> Q| {
            let conditions = self.context.stated.conditions_of(at)?;
            let id = Id::new(Scope::Conditions(conditions), quantity(&self.context.stated.conditions[conditions]));
            self.figure(id).filter(|value| *value > 0.0)
        };
        let known = |value: f64| Some(value).filter(|_| ours);
        let own = &mut made.conditions;
        own.spindle_rpm = RevsPerMinute(figure(|_| Q::Rpm).or(known(own.spindle_rpm.0))?);
        let minute = figure(|_| Q::MinuteFeed);
        let feed = figure(|own| own.feed()).or(known(own.feed_mm_per_rev.0));
        own.feed_mm_per_rev = MillimetresPerRev(feed.or(minute.map(|minute| minute / own.spindle_rpm.0))?);
        own.feed_mm_per_min = MillimetresPerMinute(minute.unwrap_or(own.feed_mm_per_rev.0 * own.spindle_rpm.0));
        Some(made)
    }

    /// A tool as the plan has it; a missing correction is the operator's setting.
    fn tool(&self, number: u32, row: &Row) -> ToolPlan {
        let places = u32::try_from(self.context.shop.machine.magazine).unwrap_or(u32::MAX).max(1);
        let mut tool = ToolPlan {
            number,
            designation: format!("T{number}"),
            table: String::new(),
            diameter_mm: self.length_of(row, Q::Diameter).unwrap_or_default(),
            ground_from_mm: None,
            pilot_mm: None,
            lead_pitches: None,
            bought_for_h: None,
            holder: String::new(),
            holder_table: String::new(),
            overhang_mm: Micrometres::ZERO,
            length_mm: Micrometres::ZERO,
            links: Vec::new(),
            mass_kg: None,
            load: (number.max(1) - 1) / places + 1,
            corrector: number,
            correction_mm: Micrometres::ZERO,
            book_correction_mm: Micrometres::ZERO,
            because: Vec::new(),
        };
        let Some(at) = self.context.stated.tool_at(number) else { return tool };
        let own = &self.context.stated.tools[at];
        if let Some(name) = &own.designation {
            tool.designation.clone_from(&name.value);
        }
        if let Some(corrector) = self.figure(Id::new(Scope::Tool(at), Q::Corrector)) {
            tool.corrector = corrector as u32;
        }
        let id = |quantity| Id::new(Scope::Tool(at), quantity);
        let length = |quantity| {
            self.figure(id(quantity)).or_else(|| self.graph.right(id(quantity))).map(Micrometres::from_mm_rounded)
        };
        tool.length_mm = length(Q::Assembly).unwrap_or_default();
        let correction = length(Q::Correction).or_else(|| self.setting.correctors.get(&tool.corrector).copied());
        let correction = correction.unwrap_or_default();
        // A plan states the value in the register; the correction has the other sign where it is subtracted (3.11.3).
        tool.correction_mm = if self.context.subtracts(at) { -correction } else { correction };
        tool
    }

    fn length_of(&self, row: &Row, quantity: Q) -> Option<Micrometres> {
        row.figures.get(&quantity).map(|figure| Micrometres::from_mm_rounded(figure.value))
    }
}

/// A transition that the program's plan does not have: only the figures of its row are known.
fn blank(row: &Row) -> Transition {
    Transition {
        operation: row.operation.value,
        feature: row.feature.unwrap_or(Feature::Bore),
        step: row.step,
        face: Face::Entry,
        start_mm: Micrometres::ZERO,
        depth_mm: Micrometres::ZERO,
        elsewhere: false,
        also_diameter_mm: None,
        achieved: None,
        diameter_mm: Micrometres::ZERO,
        from_diameter_mm: Micrometres::ZERO,
        passes: 1,
        travel_mm: Micrometres::ZERO,
        approach_mm: Micrometres::ZERO,
        tool: ToolRef { number: 0, designation: String::new(), table: String::new(), diameter_mm: Micrometres::ZERO },
        holder: HolderRef { designation: String::new(), table: String::new(), length_mm: Micrometres::ZERO },
        conditions: Conditions {
            depth_of_cut_mm: 0.0,
            feed_mm_per_rev: MillimetresPerRev(0.0),
            speed_m_per_min: MetresPerMinute(0.0),
            spindle_rpm: RevsPerMinute(0.0),
            feed_mm_per_min: MillimetresPerMinute(0.0),
            axial_force_n: None,
            torque_n_m: None,
            power_kw: None,
            machine_time_min: Minutes(0.0),
            limited_by: Limit::CuttingSpeed,
            tool_life_min: Minutes(0.0),
            // Of coolant a plan by hand says nothing.
            coolant: Some(false),
            computed_speed_m_per_min: MetresPerMinute(0.0),
            rounds: None,
            card: None,
            because: Vec::new(),
        },
        because: Vec::new(),
    }
}
