//! Many points: the book's tour, improved, then kicked and improved again as long as one may.
//!
//! A kick turns the order of three neighbouring stretches round (the double bridge of Martin, Otto and Felten, 1991), so
//! that only their ends have to be looked at again. What it costs depends on the stretches alone, not on the length of the
//! tour. A kick that does not pay is followed by a few more beside it, and all of them are undone if that does not pay
//! either. Nothing looks ahead to the end, so a search of so many tries is the beginning of every longer one.

use super::Space;
use super::candidates::Candidates;
use super::local::Tour;

/// The longest of the stretches that a kick along the tour exchanges.
const STRETCH: usize = 50;
/// One kick of so many goes along the tour, the others from near node to near node.
const ALONG: usize = 2;
/// Steps from node to node along likely edges.
const STEPS: usize = 8;
/// A kick that does not pay is followed by so many at most, within so many places, while all of them cost no more than
/// so many edges of mean length.
const FOLLOWED: usize = 4;
const BESIDE: usize = 100;
const LOSS: i64 = 3;
/// The fewest nodes whose tour can be kicked.
const FEWEST: usize = 8;
/// Where the random numbers begin: any number but zero does.
const SEED: u64 = 0x9E37_79B9_7F4A_7C15;

/// A short closed tour over all nodes, from one that is known, and the tries that it took; before each it is asked, with
/// the number of those that were made, whether to go on.
pub(super) fn tour(space: &Space<'_>, known: Vec<u32>, go_on: &mut dyn FnMut(u64) -> bool) -> (Vec<usize>, u64) {
    let candidates = Candidates::of(space);
    let mut tour = Tour::new(space, &candidates, known);
    for place in 0..space.nodes() {
        tour.touch(tour.at(place));
    }
    tour.improve();
    tour.accept();
    let mut random = Random(SEED);
    let loss = LOSS * space.round(&numbers(tour.order())) / space.nodes().max(1) as i64;
    let (mut tries, mut at) = (0, 0);
    // Kicks in a row that do not pay so far, and what they cost together.
    let (mut row, mut over) = (0, 0);
    while space.nodes() >= FEWEST && go_on(tries) {
        tries += 1;
        at = match row {
            0 => random.below(space.nodes()),
            _ => (at + space.nodes() + random.below(2 * BESIDE + 1) - BESIDE.min(space.nodes())) % space.nodes(),
        };
        let ends = match random.below(ALONG) {
            0 => Some(along(&tour, at, &mut random)),
            _ => around(&tour, at, &candidates, &mut random),
        };
        let Some(ends) = ends else { continue };
        over += exchange(&mut tour, space, ends) - tour.improve();
        row += 1;
        if over <= 0 {
            tour.accept();
        } else if row > FOLLOWED || over > loss {
            tour.undo();
        } else {
            continue;
        }
        (row, over) = (0, 0);
    }
    // What has not paid yet.
    tour.undo();
    (numbers(tour.order()), tries)
}

fn numbers(order: &[u32]) -> Vec<usize> {
    order.iter().map(|&node| node as usize).collect()
}

/// The last nodes before, of the first, of the second and of the third of three neighbouring stretches.
type Ends = [u32; 4];

/// Three stretches that follow each other from a place of the tour on.
fn along(tour: &Tour<'_>, mut at: usize, random: &mut Random) -> Ends {
    let longest = STRETCH.min((tour.order().len() - 2) / 3);
    let mut ends = [tour.at(at); 4];
    for end in &mut ends[1..] {
        at += 1 + random.below(longest);
        *end = tour.at(at);
    }
    ends
}

/// Stretches between four places near each other, or none where likely edges do not lead to so many.
fn around(tour: &Tour<'_>, at: usize, candidates: &Candidates, random: &mut Random) -> Option<Ends> {
    let start = tour.at(at);
    let mut ends = [start; 4];
    for chosen in 1..4 {
        // A walk often ends where one has been: a few are tried.
        let mut walks = (0..20).map(|_| walk(start, candidates, random));
        ends[chosen] = walks.find(|end| !ends[..chosen].contains(end))?;
    }
    ends.sort_unstable_by_key(|&node| tour.place(node));
    Some(ends)
}

fn walk(start: u32, candidates: &Candidates, random: &mut Random) -> u32 {
    (0..STEPS).fold(start, |here, _| {
        let likely = candidates.of_node(here);
        likely.get(random.below(likely.len())).map_or(here, |&(_, node)| node)
    })
}

/// Turns the order of three neighbouring stretches round, none of them reversed; gives by how much the tour grew.
///
/// All four edges change, and no chain of exchanges leads straight back. (Two stretches would change three edges
/// only, which the improvement undoes at once.)
fn exchange(tour: &mut Tour<'_>, space: &Space<'_>, ends: Ends) -> i64 {
    // The ends of the stretches, between the node before them and the node after, as the array has them.
    let mut ends = ends.map(|end| [end, tour.at(tour.place(end) + 1)]).concat();
    if tour.next(ends[0]) != ends[1] {
        ends.reverse();
    }
    let &[before, a, b, c, d, e, f, after] = ends.as_slice() else { return 0 };
    let cost = |from: u32, to: u32| space.cost(from as usize, to as usize);
    let removed = cost(before, a) + cost(b, c) + cost(d, e) + cost(f, after);
    let added = cost(before, e) + cost(f, c) + cost(d, a) + cost(b, after);
    tour.reverse(a, f);
    for (last, first) in [(f, e), (d, c), (b, a)] {
        tour.reverse(last, first);
    }
    for node in ends {
        tour.touch(node);
    }
    added - removed
}

/// The same numbers in every run: xorshift64*, whose high bits are even enough here.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let high = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 32;
        ((high * limit as u64) >> 32) as usize
    }
}
