//! The search for many points: the tour by the book's rule, improved, then repeatedly disturbed (kicked) and improved
//! again.
//!
//! A kick changes the order of three neighbouring stretches (the double bridge of Martin, Otto and Felten, 1991), so
//! that only their ends must be examined again. Its cost depends on the stretches only, not on the length of the
//! tour. A kick without gain is undone; sometimes it is followed by a few more near it, which are undone together if
//! they do not pay either. After many tries without gain the search begins again, and the best tour is kept. No
//! decision depends on the number of tries, so a search is the beginning of every longer one.

use super::Space;
use super::candidates::Candidates;
use super::local::Tour;

/// The longest of the stretches that a kick exchanges.
const STRETCH: usize = 50;
/// One kick in so many is followed by others if it has no gain: at most so many, within so many places, while
/// together they cost no more than so many edges of mean length.
const ONE_OF: usize = 5;
const FOLLOWED: usize = 4;
const BESIDE: usize = 100;
const LOSS: i64 = 3;
/// After so many tries for each node without gain, the search begins again, because other kicks lead to other tours.
const PATIENCE: u64 = 2;
/// The fewest nodes whose tour can be kicked.
const FEWEST: usize = 8;
/// The seed of the random numbers: any number but zero.
const SEED: u64 = 0x9E37_79B9_7F4A_7C15;

/// A short closed tour over all nodes, from a known one, and the number of tries made. `go_on` gets that number
/// before each try and says whether to continue.
pub(super) fn tour(space: &Space<'_>, known: Vec<u32>, go_on: &mut dyn FnMut(u64) -> bool) -> (Vec<usize>, u64) {
    let candidates = Candidates::of(space);
    let mut tour = Tour::new(space, &candidates, known);
    for place in 0..space.nodes() {
        tour.touch(tour.at(place));
    }
    tour.improve();
    tour.accept();
    let first = tour.order().to_vec();
    let mut best = Found { cost: space.round(&numbers(&first)), order: first.clone() };
    let begun = best.cost;
    let loss = LOSS * begun / space.nodes().max(1) as i64;
    let mut random = Random(SEED);
    let (mut tries, mut at, mut cost, mut paid) = (0, 0, begun, 0);
    // Kicks without gain so far: how many may still follow, and their total cost.
    let (mut left, mut over) = (0, 0);
    while space.nodes() >= FEWEST && go_on(tries) {
        tries += 1;
        if over == 0 {
            if tries - paid > PATIENCE * space.nodes() as u64 {
                best.keep(cost, &tour);
                tour = Tour::new(space, &candidates, first.clone());
                (cost, paid) = (begun, tries);
            }
            at = random.below(space.nodes());
            left = if random.below(ONE_OF) == 0 { FOLLOWED } else { 0 };
        } else {
            at = (at + random.below(BESIDE)) % space.nodes();
            left -= 1;
        }
        over += kick(&mut tour, space, at, &mut random) - tour.improve();
        if over <= 0 {
            tour.accept();
            if over < 0 {
                paid = tries;
            }
            cost += over;
            over = 0;
        } else if left == 0 || over > loss {
            tour.undo();
            over = 0;
        }
    }
    // The kicks that have not paid.
    tour.undo();
    best.keep(cost, &tour);
    (numbers(&best.order), tries)
}

/// The best tour that was found.
struct Found {
    cost: i64,
    order: Vec<u32>,
}

impl Found {
    fn keep(&mut self, cost: i64, tour: &Tour<'_>) {
        if cost < self.cost {
            self.cost = cost;
            self.order.copy_from_slice(tour.order());
        }
    }
}

fn numbers(order: &[u32]) -> Vec<usize> {
    order.iter().map(|&node| node as usize).collect()
}

/// Reverses the order of three stretches that follow each other from a place of the tour, without reversing the
/// stretches; returns by how much the tour grew.
///
/// All four edges change, and no chain of exchanges leads straight back. (Two stretches would change three edges
/// only, and the improvement would undo that at once.)
fn kick(tour: &mut Tour<'_>, space: &Space<'_>, mut at: usize, random: &mut Random) -> i64 {
    let longest = STRETCH.min((space.nodes() - 2) / 3);
    // The ends of the stretches, from the node before them to the node after them, in the order of the array.
    let mut ends = [0; 8];
    for pair in ends.chunks_exact_mut(2) {
        pair.copy_from_slice(&[tour.at(at), tour.at(at + 1)]);
        at += 1 + random.below(longest);
    }
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

/// Pseudo-random numbers, the same in every run: xorshift64*. Its high bits are uniform enough here.
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
