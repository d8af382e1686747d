//! The order of tools and the path of each over its points.
//!
//! Tools change in the order in which the first hole needs them (the parallel method of textbook 1.3.1:
//! each tool goes round all its points, then the next is taken). The path is the book's rule, to the
//! nearest point not yet visited, from the tool-change position and back.

use crate::machine::Machine;
use crate::part::{Face, Part, Point};
use crate::plan::{HolePlan, Stop, Times, Visit};
use crate::units::{Micrometres, Minutes};

/// Visits of every tool, in order, and where the time goes.
///
/// A tool is taken when every hole that needs it has come to it. Where two holes need two tools in opposite
/// orders, the lower number is taken first and comes back later for the other hole.
pub fn sequence(part: &Part, holes: &[HolePlan], machine: &Machine<'_>) -> (Vec<Visit>, Times) {
    let mut visits = Vec::new();
    let mut times = Times::default();
    for (setup, face) in [(1, Face::Entry), (2, Face::Back)] {
        // What is still to be done to each group, last first.
        let mut to_do: Vec<Vec<usize>> = holes
            .iter()
            .map(|plan| {
                let own = plan.transitions.iter().enumerate().rev();
                own.filter(|(_, step)| step.face == face && !step.elsewhere).map(|(index, _)| index).collect()
            })
            .collect();
        while let Some(tool) = next_tool(holes, &to_do) {
            let mut left: Vec<Stop> = Vec::new();
            for ((plan, hole), to_do) in holes.iter().zip(&part.holes).zip(&mut to_do) {
                while let Some(transition) = to_do.pop_if(|index| tool_of(plan, *index) == Some(tool)) {
                    left.extend(hole.at.iter().map(|&at| Stop { hole: plan.name.clone(), transition, at }));
                }
            }
            let visit = visit(tool, setup, left, holes, part, machine);
            times.rapid_min = times.rapid_min + visit.rapid_min;
            visits.push(visit);
        }
    }
    times.machine_min = holes
        .iter()
        .flat_map(|plan| {
            let own = plan.transitions.iter().filter(|step| !step.elsewhere);
            own.map(|step| step.conditions.machine_time_min.0 * plan.count as f64)
        })
        .map(Minutes)
        .sum::<Minutes>()
        .rounded(2);
    times.tool_change_min = Minutes(machine.tool_change.0 * visits.len() as f64).rounded(2);
    times.rapid_min = times.rapid_min.rounded(2);
    times.total_min = (times.machine_min + times.rapid_min + times.tool_change_min).rounded(2);
    (visits, times)
}

/// The lowest tool that some group needs next.
fn next_tool(holes: &[HolePlan], to_do: &[Vec<usize>]) -> Option<u32> {
    holes.iter().zip(to_do).filter_map(|(plan, to_do)| tool_of(plan, *to_do.last()?)).min()
}

fn tool_of(plan: &HolePlan, transition: usize) -> Option<u32> {
    plan.transitions.get(transition).map(|step| step.tool.number)
}

/// A tool's way over its stops, from the tool-change position and back.
fn visit(tool: u32, setup: u32, mut left: Vec<Stop>, holes: &[HolePlan], part: &Part, machine: &Machine<'_>) -> Visit {
    let home = tool_change_point(part, machine);
    let mut stops = Vec::with_capacity(left.len());
    let (mut here, mut rapid) = (home, 0.0);
    while let Some(next) = nearest(here, &left) {
        let stop = left.remove(next);
        rapid += rapid_between(here, stop.at, machine).0;
        rapid += withdrawal(&stop, holes, machine).0;
        here = stop.at;
        stops.push(stop);
    }
    rapid += rapid_between(here, home, machine).0;
    Visit { tool, setup, stops, rapid_min: Minutes(rapid).rounded(3) }
}

/// Where the spindle stands over the part when tools are changed: the machine's zero is over the middle of
/// the table, and the middle of the blank is set up there.
pub fn tool_change_point(part: &Part, machine: &Machine<'_>) -> Point {
    let middle = part.middle();
    Point { x: middle.x + machine.tool_change_at.0, y: middle.y + machine.tool_change_at.1 }
}

/// The nearest stop; among equals the first in the drawing's order, so that the path is repeatable.
fn nearest(here: Point, left: &[Stop]) -> Option<usize> {
    (0..left.len()).min_by_key(|&index| (here.distance(left[index].at), index))
}

/// Rapids move each axis at its own rate, so the slower axis decides.
fn rapid_between(from: Point, to: Point, machine: &Machine<'_>) -> Minutes {
    let along = (from.x - to.x).abs().max((from.y - to.y).abs());
    Minutes(along.to_mm() / machine.rapid.0)
}

/// Rapid out of the hole after a pass, by the working travel, for every pass.
fn withdrawal(stop: &Stop, holes: &[HolePlan], machine: &Machine<'_>) -> Minutes {
    let step = holes.iter().find(|plan| plan.name == stop.hole).and_then(|plan| plan.transitions.get(stop.transition));
    let (travel, passes) = step.map_or((Micrometres::ZERO, 0), |step| (step.travel_mm, step.passes));
    Minutes(travel.to_mm() * f64::from(passes) / machine.rapid.0)
}
