//! The order of tools and the path of each over its points.
//!
//! Tools change in the order in which the first hole needs them. This is the parallel method of textbook 1.3.1: each
//! tool visits all its points, then the next tool is taken. [`mod@visiting`] compares it with the method that the
//! section recommends for each group. The path leads from the tool-change position and back, in the metric of the
//! machine ([`metric`]): the shortest for few points, a short one for many ([`tour`]). The book's rule, to the
//! nearest point not yet visited, is computed for comparison, and [`bound`] gives a lower bound.

pub mod bound;
pub mod list;
pub mod metric;
mod places;
mod prices;
mod spanning;
pub mod tour;
pub mod visiting;

use std::collections::BTreeMap;

use crate::error::KnowledgeError;
use crate::job;
use crate::machine::{Machine, Rapid};
use crate::part::{Face, Part, Point};
use crate::plan::{HolePlan, Plan, Stop, ToolVisit};
use crate::shop::Shop;
use crate::units::{Micrometres, Minutes};

use metric::Metric;
use tour::{Effort, Path, Space};

/// The visits of all tools, in order. Their rapids are those across the part; [`timed`] adds the rest.
///
/// A tool is taken when every hole that needs it is ready for it. Where two holes need two tools in opposite orders,
/// the lower number is taken first and comes back later for the other hole. Paths are searched with the given effort,
/// or without one as quickly as planning requires.
pub fn sequence(part: &Part, holes: &[HolePlan], machine: &Machine<'_>, effort: Option<Effort>) -> Vec<ToolVisit> {
    let mut visits = Vec::new();
    let mut paths =
        Paths { home: tool_change_point(part, machine), rapid: machine.rapids(), effort, known: Vec::new() };
    for (setup, face) in [(1, Face::Entry), (2, Face::Back)] {
        // The steps that remain in each group, last first.
        let mut to_do: Vec<Vec<usize>> = holes
            .iter()
            .map(|plan| {
                let own = plan.transitions.iter().enumerate().rev();
                own.filter(|(_, step)| step.face == face && !step.elsewhere).map(|(index, _)| index).collect()
            })
            .collect();
        while let Some(tool) = next_tool(holes, &to_do) {
            // The points of the tool in the order of the drawing, each with all its work.
            let mut places: Vec<Vec<Stop>> = Vec::new();
            let mut speeds: Vec<Speeds> = Vec::new();
            for ((plan, hole), to_do) in holes.iter().zip(&part.holes).zip(&mut to_do) {
                let mut own = Vec::new();
                while let Some(transition) = to_do.pop_if(|index| tool_of(plan, *index) == Some(tool)) {
                    own.push(transition);
                }
                if !own.is_empty() {
                    let speed = |step: &usize| plan.transitions.get(*step).map(|step| step.conditions.spindle_rpm);
                    let speed: Speeds = own.iter().filter_map(speed).map(|speed| speed.0.to_bits()).collect();
                    speeds.extend(hole.at.iter().map(|_| speed.clone()));
                    let stop = |at, transition| Stop { hole: plan.name.clone(), transition, at };
                    places.extend(hole.at.iter().map(|&at| own.iter().map(|&step| stop(at, step)).collect()));
                }
            }
            let visit = visit(tool, setup, places, &speeds, &mut paths);
            visits.push(visit);
        }
    }
    visits
}

/// The spindle speeds of the work at a place, one after another.
type Speeds = Vec<u64>;

/// Writes into a plan how its time is spent, what the programs of its job need on the machine, and what prevents them
/// from running on it.
///
/// # Errors
/// The knowledge base has no answer.
pub fn timed(plan: &mut Plan, shop: &Shop<'_>) -> Result<(), KnowledgeError> {
    let job = job::make(plan, shop)?;
    job::tell(plan, &job, shop)
}

/// The lowest tool number that some group needs next.
fn next_tool(holes: &[HolePlan], to_do: &[Vec<usize>]) -> Option<u32> {
    holes.iter().zip(to_do).filter_map(|(plan, to_do)| tool_of(plan, *to_do.last()?)).min()
}

fn tool_of(plan: &HolePlan, transition: usize) -> Option<u32> {
    plan.transitions.get(transition).map(|step| step.tool.number)
}

/// The paths from the tool-change position and back, kept because tools often visit the same points.
struct Paths {
    home: Point,
    rapid: Rapid,
    effort: Option<Effort>,
    /// Points, the tool-change position first, with the path over them.
    known: Vec<(Vec<Point>, Path)>,
}

impl Paths {
    fn over(&mut self, points: &[Point]) -> Path {
        if let Some((_, path)) = self.known.iter().find(|(known, _)| known == points) {
            return path.clone();
        }
        let space = Space::closed(points, Metric::Rapid(self.rapid));
        let path = self.effort.map_or_else(|| tour::plan_path(&space), |effort| tour::path(&space, effort));
        self.known.push((points.to_vec(), path.clone()));
        path
    }
}

/// The path of a tool over its points, from the tool-change position and back; the work at one point stays together,
/// in the order of its transitions. Points with one spindle speed follow each other, so that the spindle changes its speed
/// as seldom as can be.
fn visit(tool: u32, setup: u32, mut places: Vec<Vec<Stop>>, speeds: &[Speeds], paths: &mut Paths) -> ToolVisit {
    let at = places.iter().filter_map(|stops| stops.first()).map(|stop| stop.at);
    let points: Vec<Point> = std::iter::once(paths.home).chain(at).collect();
    let metric = Metric::Rapid(paths.rapid);
    let space = Space::closed(&points, metric);
    let (path, nearest) = by_speed(&points, speeds, &space, paths);
    let time = |cost| metric.minutes(cost).unwrap_or_default();
    let rapid_min = time(path.cost);
    let nearest_rapid_min = time(nearest);
    let path_mm = Micrometres::new(Space::closed(&points, Metric::Euclid).length(&path.order));
    let stops = path.order.iter().skip(1).flat_map(|&point| std::mem::take(&mut places[point - 1])).collect();
    let bound_min = path.optimal.then_some(rapid_min);
    ToolVisit { tool, setup, stops, rapid_min, nearest_rapid_min, bound_min, path_mm }
}

/// The path over the points, speed by speed, and the cost of that by the rule of the nearest point.
fn by_speed(points: &[Point], speeds: &[Speeds], space: &Space<'_>, paths: &mut Paths) -> (Path, i64) {
    let mut groups: BTreeMap<&Speeds, Vec<usize>> = BTreeMap::new();
    speeds.iter().zip(1..).for_each(|(speed, point)| groups.entry(speed).or_default().push(point));
    if groups.len() < 2 {
        return (paths.over(points), tour::nearest_rule(space).cost);
    }
    let (mut order, mut nearest, mut tries) = (vec![0], vec![0], 0);
    for group in groups.values() {
        let own: Vec<Point> =
            std::iter::once(&0).chain(group).filter_map(|point| points.get(*point)).copied().collect();
        // The numbers of the points of the group among all.
        let numbers = |order: &[usize]| -> Vec<usize> {
            order.iter().skip(1).filter_map(|point| group.get(point.wrapping_sub(1))).copied().collect()
        };
        let path = paths.over(&own);
        tries += path.tries;
        let mut further = numbers(&path.order);
        let here = order.last().copied().unwrap_or_default();
        let from = |point: Option<&usize>| point.map_or(0, |point| space.cost(here, *point));
        if from(further.last()) < from(further.first()) {
            further.reverse();
        }
        order.append(&mut further);
        nearest.append(&mut numbers(&tour::nearest_rule(&Space::closed(&own, space.metric())).order));
    }
    let (cost, of_nearest) = (space.length(&order), space.length(&nearest));
    let (order, cost) = if of_nearest < cost { (nearest, of_nearest) } else { (order, cost) };
    (Path { order, cost, optimal: false, tries }, of_nearest)
}

/// The lower bound of a visit of a plan: the least time of its rapids, min. Equal to its own time where the path is
/// proven the shortest. Absent if a bar is set by hand between its rounds over the points.
pub fn visit_bound(visit: &ToolVisit, plan: &Plan, machine: &Machine<'_>) -> Option<Minutes> {
    let transition = |stop: &Stop| {
        let hole = plan.holes.iter().find(|hole| hole.name == stop.hole)?;
        hole.transitions.get(stop.transition)
    };
    let in_rounds = |stop| transition(stop).is_some_and(|step| step.operation.is_set_by_hand(step.passes));
    if visit.stops.iter().any(in_rounds) {
        return None;
    }
    if visit.bound_min.is_some() {
        return visit.bound_min;
    }
    let mut points = vec![tool_change_point(&plan.part, machine)];
    points.extend(visit.stops.iter().map(|stop| stop.at));
    // Transitions at one place follow each other.
    points.dedup();
    let metric = Metric::Rapid(machine.rapids());
    let space = Space::closed(&points, metric);
    let order: Vec<usize> = (0..points.len()).collect();
    let cost = space.length(&order);
    // The retracts are the same in every order: only the path between the points can be shorter.
    let saved =
        metric.minutes(cost - bound::lower_bound(&space, cost, bound::rounds(space.nodes()))).unwrap_or_default();
    // Rounded down, so that it stays a bound.
    Some(Minutes((((visit.rapid_min.0 - saved.0) * 1000.0).floor() / 1000.0).max(0.0)))
}

/// Where the spindle stands over the part when tools are changed: the middle of the blank is set up over the middle of the table.
pub fn tool_change_point(part: &Part, machine: &Machine<'_>) -> Point {
    let middle = part.middle();
    let [x, y] = machine.middle;
    Point { x: middle.x + machine.tool_change_at.0 - x, y: middle.y + machine.tool_change_at.1 - y }
}
