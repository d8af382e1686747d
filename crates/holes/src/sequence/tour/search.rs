//! Many points: the book's tour, improved, then kicked and improved again as long as the budget lasts.
//!
//! A kick turns the order of three neighbouring stretches round (the double bridge of Martin, Otto and Felten,
//! 1991), between places that are near each other, so that only their surroundings have to be looked at again. A
//! kick that does not pay is undone; but one that costs little is kept sometimes, the less the nearer the end
//! (threshold accepting, Dueck and Scheuer, 1990), and the best tour is remembered.

use super::Space;
use super::local::Tour;
use super::neighbours::Neighbours;

/// The longest of the stretches that a kick along the tour exchanges.
const STRETCH: usize = 50;
/// One kick of so many goes along the tour; the others go from near node to near node. Those along the tour also
/// join what no list of near nodes does: holes of two circles far apart.
const ALONG: usize = 8;
/// Steps from near node to near node, and the near nodes that a step chooses from.
const STEPS: usize = 8;
const CHOICE: usize = 5;
/// A kick at the beginning may cost at most so many edges of mean length, and rarely does.
const LOSS: f64 = 3.0;
/// With fewer kicks for each node there is no time to make good a loss, and none is taken.
const PATIENCE: u64 = 10;
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
    let mut best = tour.order().to_vec();
    // What the tour costs more than the best one.
    let mut over = 0;
    let mut random = Random(SEED);
    let kicks = if space.nodes() < FEWEST { 0 } else { kicks };
    let patient = kicks >= PATIENCE * space.nodes() as u64;
    let edge = space.round(&numbers(&best)) as f64 / space.nodes().max(1) as f64;
    let loss = if patient { LOSS * edge } else { 0.0 };
    for kick in 0..kicks {
        let ends =
            if random.below(ALONG) == 0 { along(&tour, &mut random) } else { around(&tour, &neighbours, &mut random) };
        let Some(ends) = ends else { continue };
        let change = exchange(&mut tour, space, ends) - tour.improve();
        let left = (kicks - kick) as f64 / kicks as f64;
        // The square of an even number: small losses are common, large ones rare.
        let luck = random.below(1000) as f64 / 1000.0;
        if change > 0 && change as f64 >= loss * left * luck * luck {
            tour.undo();
            continue;
        }
        tour.accept();
        over += change;
        if over < 0 {
            over = 0;
            best.copy_from_slice(tour.order());
        }
    }
    numbers(&best)
}

fn numbers(order: &[u32]) -> Vec<usize> {
    order.iter().map(|&node| node as usize).collect()
}

/// The book's tour, so that the one found is never longer than it; the node without place at its end.
fn book(space: &Space<'_>) -> Vec<u32> {
    let mut order: Vec<u32> = super::nearest_rule(space).order.iter().map(|&node| node as u32).collect();
    order.extend(order.len() as u32..space.nodes() as u32);
    order
}

/// The last nodes before, of the first, of the second and of the third of three neighbouring stretches.
type Ends = [u32; 4];

/// Three stretches that follow each other somewhere on the tour.
fn along(tour: &Tour<'_>, random: &mut Random) -> Option<Ends> {
    let longest = STRETCH.min((tour.order().len() - 2) / 3);
    let mut at = random.below(tour.order().len());
    let mut ends = [tour.at(at); 4];
    for end in &mut ends[1..] {
        at += 1 + random.below(longest);
        *end = tour.at(at);
    }
    Some(ends)
}

/// Stretches between four places near each other, or none where the near nodes are too few.
fn around(tour: &Tour<'_>, neighbours: &Neighbours, random: &mut Random) -> Option<Ends> {
    let start = random.below(tour.order().len()) as u32;
    let mut ends = [start; 4];
    for chosen in 1..4 {
        // A walk often ends where one has been: a few are tried.
        let mut walks = (0..20).map(|_| walk(start, neighbours, random));
        ends[chosen] = walks.find(|end| !ends[..chosen].contains(end))?;
    }
    ends.sort_unstable_by_key(|&node| tour.place(node));
    Some(ends)
}

fn walk(start: u32, neighbours: &Neighbours, random: &mut Random) -> u32 {
    (0..STEPS).fold(start, |here, _| {
        let near = neighbours.near(here);
        near.get(random.below(near.len().min(CHOICE))).map_or(here, |&(_, node)| node)
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
