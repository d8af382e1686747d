//! Many points: the book's tour, improved, then kicked and improved again as long as the budget lasts.
//!
//! A kick turns the order of three neighbouring stretches round (the double bridge of Martin, Otto and Felten, 1991),
//! short ones, so that only their surroundings have to be looked at again; a kick that does not pay is undone.

use super::Space;
use super::local::Tour;
use super::neighbours::Neighbours;

/// The longest of the stretches that a kick exchanges.
const STRETCH: usize = 30;
/// The fewest nodes whose tour can be kicked.
const FEWEST: usize = 8;
/// Where the random numbers begin: any number but zero does.
const SEED: u64 = 0x9E37_79B9_7F4A_7C15;

/// A short closed tour over all nodes, found with that many kicks.
pub(super) fn tour(space: &Space<'_>, kicks: u64) -> Vec<usize> {
    let neighbours = Neighbours::of(space);
    let mut tour = Tour::new(space, &neighbours, book(space));
    for node in 0..space.nodes() {
        tour.touch(node as u32);
    }
    tour.improve();
    tour.accept();
    let mut random = Random(SEED);
    let kicks = if space.nodes() < FEWEST { 0 } else { kicks };
    for _ in 0..kicks {
        let worse = kick(&mut tour, space, &mut random);
        if tour.improve() >= worse {
            tour.accept();
        } else {
            tour.undo();
        }
    }
    tour.order().iter().map(|&node| node as usize).collect()
}

/// The book's tour, so that the one found is never longer than it; the node without place at its end.
fn book(space: &Space<'_>) -> Vec<u32> {
    let mut order: Vec<u32> = super::nearest_rule(space).order.iter().map(|&node| node as u32).collect();
    order.extend(order.len() as u32..space.nodes() as u32);
    order
}

/// Turns the order of three neighbouring stretches round, none of them reversed; gives by how much the tour grew.
///
/// All four edges change, and no chain of exchanges leads straight back. (Two stretches would change three edges
/// only, which the improvement undoes at once.)
fn kick(tour: &mut Tour<'_>, space: &Space<'_>, random: &mut Random) -> i64 {
    let count = space.nodes();
    let longest = STRETCH.min((count - 2) / 3);
    let mut at = random.below(count);
    // The ends of the stretches, between the node before them and the node after.
    let mut ends = [tour.at(at); 8];
    for stretch in 0..3 {
        ends[2 * stretch + 1] = tour.at(at + 1);
        at += 1 + random.below(longest);
        ends[2 * stretch + 2] = tour.at(at);
    }
    ends[7] = tour.at(at + 1);
    if tour.next(ends[0]) != ends[1] {
        ends.reverse();
    }
    let [before, a, b, c, d, e, f, after] = ends;
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
