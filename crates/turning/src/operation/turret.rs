//! The tools of an operation in the turret of its lathe. Where it has fewer places than the operation has tools, a tool
//! comes into the place of one that is needed last, by hand: at the beginning of a set-up, or at a planned stop of its
//! program.

use serde::Serialize;

use crate::note::Note;
use crate::turning::jobs::{Job, JobTool, Work};
use crate::turning::program::Seat;

use super::Operation;

/// A tool at its place of the turret.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Station {
    /// Its place and its offset.
    #[serde(flatten)]
    pub seat: Seat,
    /// The tool.
    #[serde(flatten)]
    pub tool: JobTool,
    /// Whether it only finishes. A tool that roughs does not finish, because its edge is worn.
    pub finishes: bool,
}

impl Station {
    /// Whether it is that of a job.
    pub fn is_of(&self, job: &Job) -> bool {
        (&self.tool, self.finishes) == kind(job)
    }
}

fn kind(job: &Job) -> (&JobTool, bool) {
    (&job.tool, job.work == Work::Finish)
}

/// The tools of an operation in the order of their first use over all set-ups, which is that of their offsets.
pub fn stations(operation: &Operation) -> Vec<Station> {
    let mut kinds: Vec<(&JobTool, bool)> = Vec::new();
    let jobs = operation.set_ups.iter().flat_map(|set_up| &set_up.jobs).map(kind);
    let order: Vec<usize> = jobs
        .map(|kind| {
            kinds.iter().position(|known| *known == kind).unwrap_or_else(|| {
                kinds.push(kind);
                kinds.len() - 1
            })
        })
        .collect();
    let seats = seats(&order, kinds.len(), places(operation, kinds.len()));
    let station = |(seat, (tool, finishes)): (Seat, (&JobTool, bool))| Station { seat, tool: tool.clone(), finishes };
    seats.into_iter().zip(kinds).map(station).collect()
}

/// How many places are used.
fn places(operation: &Operation, tools: usize) -> usize {
    operation.turret_places.filter(|places| *places > 0).map_or(tools, |places| places.min(tools))
}

/// The seats of tools, by the order in which they work. A tool for which no place is free takes that of the tool which
/// is needed farthest from then on (Belady's rule: no other choice needs fewer changes); of equal ones, of that which
/// worked first.
fn seats(order: &[usize], tools: usize, places: usize) -> Vec<Seat> {
    let mut seats: Vec<Option<Seat>> = vec![None; tools];
    let mut standing: Vec<usize> = Vec::new();
    let mut tools_of = vec![0; places];
    for (at, &tool) in order.iter().enumerate() {
        if standing.contains(&tool) {
            continue;
        }
        let (done, next) = (order.get(..at).unwrap_or_default(), order.get(at..).unwrap_or_default());
        let needed = |other: &usize| {
            let again = next.iter().position(|one| one == other).unwrap_or(usize::MAX);
            (again, done.iter().rev().position(|one| one == other))
        };
        let farthest = || (0..standing.len()).rev().max_by_key(|place| standing.get(*place).map(needed));
        // A tool that comes back goes to its own place.
        let known = seats.get(tool).copied().flatten().map(|seat| seat.place as usize - 1);
        let Some(place) = known.or_else(|| (standing.len() < places).then_some(standing.len())).or_else(farthest)
        else {
            continue;
        };
        match standing.get_mut(place) {
            Some(held) => *held = tool,
            None => standing.push(tool),
        }
        if let (None, Some(count), Some(seat)) = (known, tools_of.get_mut(place), seats.get_mut(tool)) {
            *count += 1;
            *seat = Some(Seat { place: place as u32 + 1, offset: tool as u32 + 1, edge: *count });
        }
    }
    (1..).zip(seats).map(|(number, seat)| seat.unwrap_or(Seat::only(number))).collect()
}

/// The station of a job.
pub fn station<'a>(stations: &'a [Station], job: &Job) -> Option<&'a Station> {
    stations.iter().find(|one| one.is_of(job))
}

/// Tools that are put into the turret by hand.
#[derive(Clone, Debug)]
pub struct Load<'a> {
    /// The set-up.
    pub set_up: u8,
    /// The job of the set-up before which they come; at the first one the program has not begun, later it stops.
    pub before: usize,
    /// The tools. Before the first job they are all with which the set-up begins.
    pub tools: Vec<Put<'a>>,
}

/// A tool that is put into its place.
#[derive(Clone, Copy, Debug)]
pub struct Put<'a> {
    /// The tool.
    pub station: &'a Station,
    /// The tool that stands there and is taken out.
    pub out: Option<&'a Station>,
}

impl Put<'_> {
    /// The sentence for the operator, with the offset as the control counts it.
    pub fn note(&self, offset: u32) -> Note {
        let place = self.station.seat.place;
        let code = if self.out.is_some() { "turret-exchanged" } else { "turret-holds" };
        let note = Note::new(code).with("place", place).with("offset", offset);
        let note = note.with("tool", &*self.station.tool.designation);
        match self.out {
            Some(out) => note.with("out", &*out.tool.designation),
            None => note,
        }
    }
}

/// What is put into the turret for each set-up, and at which stops; none where the turret holds all tools. Each time as many as the next jobs can work with.
pub fn loads<'a>(operation: &Operation, stations: &'a [Station]) -> Vec<Load<'a>> {
    let mut loads = Vec::new();
    if places(operation, stations.len()) >= stations.len() {
        return loads;
    }
    let mut standing: Vec<&Station> = Vec::new();
    for set_up in &operation.set_ups {
        let tools: Vec<&Station> = set_up.jobs.iter().filter_map(|job| station(stations, job)).collect();
        for (before, tool) in tools.iter().enumerate() {
            if before > 0 && standing.contains(tool) {
                continue;
            }
            let mut next: Vec<&Station> = Vec::new();
            for tool in tools.iter().skip(before) {
                match next.iter().find(|known| known.seat.place == tool.seat.place) {
                    Some(known) if known == tool => {}
                    Some(_) => break,
                    None => next.push(tool),
                }
            }
            let put = |station: &&'a Station| {
                let out = standing.iter().find(|known| known.seat.place == station.seat.place).copied();
                Put { station, out: out.filter(|out| out != station) }
            };
            let puts = next.iter().map(put).filter(|put| before == 0 || !standing.contains(&put.station));
            let puts: Vec<Put<'a>> = puts.collect();
            standing.retain(|known| next.iter().all(|one| one.seat.place != known.seat.place));
            standing.extend(next);
            loads.push(Load { set_up: set_up.set_up.number, before, tools: puts });
        }
    }
    loads
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places_of(order: &[usize], places: usize) -> Vec<u32> {
        let tools = order.iter().max().map_or(0, |most| most + 1);
        seats(order, tools, places).iter().map(|seat| seat.place).collect()
    }

    /// By hand. Enough places: each tool has its number. Of three tools in two places the third comes for the second, because the
    /// first works again; where none works again, for the one that has stood idle longest.
    #[test]
    fn a_tool_comes_for_the_one_that_is_needed_last() {
        assert_eq!(places_of(&[0, 1, 2, 0], 6), [1, 2, 3]);
        assert_eq!(places_of(&[0, 1, 2, 0], 2), [1, 2, 2]);
        assert_eq!(places_of(&[0, 1, 2, 3], 2), [1, 2, 1, 2]);
        let seats = seats(&[0, 1, 2, 3], 4, 2);
        assert_eq!(
            seats.iter().map(|seat| (seat.offset, seat.edge)).collect::<Vec<_>>(),
            [(1, 1), (2, 1), (3, 2), (4, 2)]
        );
    }
}
