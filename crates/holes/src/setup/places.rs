//! Where straps of the plan's own may stand.

use crate::machine::Machine;
use crate::part::{Part, Point};
use crate::units::Micrometres;

/// A hole so near to a clamp that the tool would hit it: half the width of the clamp is the inset.
pub(super) fn blocked<'p>(
    part: &'p Part,
    clamps: &[Point],
    inset: Micrometres,
) -> Option<(&'p str, Micrometres, Micrometres)> {
    part.holes.iter().find_map(|hole| {
        let needed = hole.diameter.nominal.half() + inset;
        let nearest = hole.ways().flat_map(|way| clamps.iter().map(move |clamp| way.distance(*clamp))).min()?;
        (nearest < needed).then_some((hole.name.as_str(), nearest, needed))
    })
}

/// Symmetric pairs on two opposite sides, sets of four from two pairs, and of six from three of the best: those with the most room to the holes
/// first, corners last; among equals the middles of the sides first. Where holes block all of them, the best pair
/// alone.
///
/// A disc has its pairs opposite each other around the rim instead. Where the table ends before the part does, clamps stand over the table: the middle of the part lies over its middle.
pub(super) fn proposals(part: &Part, inset: Micrometres, combined: usize, machine: &Machine<'_>) -> Vec<Vec<Point>> {
    let pairs = pairs(part, inset, machine);
    // A hole that blocks a pair blocks every set of four with it.
    let free: Vec<&Vec<Point>> = pairs.iter().filter(|clamps| blocked(part, clamps, inset).is_none()).collect();
    if free.is_empty() {
        return pairs.into_iter().take(1).collect();
    }
    let fours = free.iter().enumerate().flat_map(|(at, one)| free[at + 1..].iter().map(|two| [&one[..], two].concat()));
    let fours: Vec<Vec<Point>> = fours.collect();
    let best = &free[..free.len().min(combined)];
    let mut sixes = Vec::new();
    for (at, one) in best.iter().enumerate() {
        for (next, two) in best.iter().enumerate().skip(at + 1) {
            sixes.extend(best[next + 1..].iter().map(|three| [&one[..], two, three].concat()));
        }
    }
    free.iter().map(|pair| (*pair).clone()).chain(fours).chain(sixes).collect()
}

/// Sets of three and of four straps that need not stand opposite each other, of as many places as are combined: the one with the
/// most room to the holes, and then always the one farthest from those taken. The widest sets first.
pub(super) fn uneven(part: &Part, inset: Micrometres, combined: usize, machine: &Machine<'_>) -> Vec<Vec<Point>> {
    let places = pairs(part, inset, machine).into_iter().flatten();
    let mut free: Vec<Point> = places.filter(|at| blocked(part, &[*at], inset).is_none()).collect();
    let mut taken: Vec<Point> = Vec::new();
    while taken.len() < combined && !free.is_empty() {
        let apart = |at: &Point| taken.iter().map(|own| own.distance(*at)).min().unwrap_or_default();
        // Of equals the first, which has the most room.
        let widest = free.iter().map(apart).max().unwrap_or_default();
        let next = free.iter().position(|at| apart(at) == widest).unwrap_or_default();
        taken.push(free.remove(next));
        free.retain(|at| !taken.contains(at));
    }
    let mut sets: Vec<Vec<Point>> = Vec::new();
    for (at, one) in taken.iter().enumerate() {
        for (next, two) in taken.iter().enumerate().skip(at + 1) {
            for (last, three) in taken.iter().enumerate().skip(next + 1) {
                sets.push(vec![*one, *two, *three]);
                sets.extend(taken[last + 1..].iter().map(|four| vec![*one, *two, *three, *four]));
            }
        }
    }
    let width = |set: &Vec<Point>| {
        set.iter().flat_map(|one| set.iter().map(|two| one.distance(*two).micrometres())).sum::<i64>()
    };
    sets.sort_by_cached_key(|set| (set.len(), -width(set)));
    sets
}

/// Symmetric pairs of places for straps, those with the most room to the holes first, corners last.
fn pairs(part: &Part, inset: Micrometres, machine: &Machine<'_>) -> Vec<Vec<Point>> {
    let (blank, middle) = (&part.blank, part.middle());
    // A spindle that does not stand over its table says nothing of its height.
    let upright = machine.nose_to_table.is_some();
    let within = |size: Micrometres, table: Option<Micrometres>| {
        let bearing = table.filter(|_| upright).map_or(size, |table| table.min(size));
        (bearing - inset - inset).half()
    };
    let (across, along) = (within(blank.width, machine.table_width), within(blank.length, machine.table_length));
    let pair = |x: Micrometres, y: Micrometres| {
        vec![Point { x: middle.x - x, y: middle.y - y }, Point { x: middle.x + x, y: middle.y + y }]
    };
    let shifts = [0, 1, -1, 2, -2, 3, -3, 4, -4];
    let sides = shifts
        .iter()
        .flat_map(|&tenths| [pair(along.ratio(tenths, 5), across), pair(along, across.ratio(tenths, 5))])
        .filter(|_| !blank.is_round());
    // On a disc they stand opposite each other at the rim, every 15° of it, where the table is under them.
    let reach = blank.length.half() - inset;
    let around = (0..12_i32).map(|step| (f64::from(step) * 15.0).to_radians()).map(|angle| {
        let at = |share: f64| Micrometres::from_mm_rounded(reach.to_mm() * share);
        (at(libm::cos(angle)), at(libm::sin(angle)))
    });
    let rim =
        around.filter(|(x, y)| blank.is_round() && x.abs() <= along && y.abs() <= across).map(|(x, y)| pair(x, y));
    let room = |clamps: &Vec<Point>| {
        let holes = part.holes.iter().flat_map(|hole| hole.ways().map(|way| (way, hole.diameter.nominal.half())));
        holes.flat_map(|(way, radius)| clamps.iter().map(move |clamp| way.distance(*clamp) - radius)).min()
    };
    let mut pairs: Vec<Vec<Point>> = sides.chain(rim).collect();
    pairs.sort_by_cached_key(|clamps| std::cmp::Reverse(room(clamps)));
    // The corners last: a strap clamp is least stable there.
    let corners = [1, -1].map(|side| pair(along, across.ratio(side, 1)));
    pairs.extend(corners.into_iter().filter(|_| !blank.is_round()));
    pairs
}
