use std::collections::BTreeSet;

use proptest::prelude::*;

use super::*;
use crate::units::{Micrometres, MillimetresPerMinute, MillimetresPerSecondSquared};

use super::super::bound::lower_bound;
use super::super::places::PointBoxes;
use super::super::spanning::shortest_tree;
use crate::machine::Rapid;

fn metrics() -> [Metric; 4] {
    let rapid = Rapid { rate: MillimetresPerMinute(7000.0), acceleration: None };
    let accelerated = Rapid { acceleration: Some(MillimetresPerSecondSquared(500.0)), ..rapid };
    [Metric::Euclid, Metric::EuclidWhole, Metric::Rapid(rapid), Metric::Rapid(accelerated)]
}

fn points(most: usize) -> impl Strategy<Value = Vec<Point>> {
    // On a coarse grid, so that equal distances and equal points are common.
    let one = (-6_i64..=6, -6_i64..=6)
        .prop_map(|(x, y)| Point { x: Micrometres::new(x * 7_500), y: Micrometres::new(y * 5_000) });
    prop::collection::vec(one, 0..=most)
}

fn spaces(points: &[Point]) -> Vec<Space<'_>> {
    metrics().into_iter().flat_map(|metric| [Space::closed(points, metric), Space::open(points, metric)]).collect()
}

/// The shortest of all orders.
fn brute(space: &Space<'_>) -> i64 {
    fn go(space: &Space<'_>, order: &mut Vec<usize>, left: &mut Vec<usize>, best: &mut i64) {
        if left.is_empty() {
            *best = space.length(order).min(*best);
        }
        for at in 0..left.len() {
            let node = left.swap_remove(at);
            order.push(node);
            go(space, order, left, best);
            order.pop();
            left.push(node);
            let end = left.len() - 1;
            left.swap(at, end);
        }
    }
    let mut best = i64::MAX;
    let mut left: Vec<usize> = (0..space.points.len()).collect();
    // A tour may begin anywhere; a path may not.
    let mut order: Vec<usize> = if space.free_ends || left.is_empty() { Vec::new() } else { vec![left.remove(0)] };
    go(space, &mut order, &mut left, &mut best);
    best
}

fn each_once(order: &[usize], count: usize) -> bool {
    order.len() == count && order.iter().copied().collect::<BTreeSet<_>>() == (0..count).collect()
}

proptest! {
    #![proptest_config(technolog_laws::cases!(8))]

    #[test]
    fn few_points_are_solved_as_trying_all_orders_solves_them(points in points(7)) {
        for space in spaces(&points) {
            let path = path(&space, Effort(100));
            prop_assert!(path.optimal && each_once(&path.order, points.len()));
            prop_assert_eq!(path.cost, brute(&space));
            prop_assert_eq!(path.cost, space.length(&path.order));
        }
    }

    #[test]
    fn the_search_finds_what_the_exact_way_finds_for_few_points(points in points(9)) {
        for space in spaces(&points) {
            if space.nodes() > 4 {
                let known = (0..space.nodes() as u32).collect();
                let order = from_the_start(&space, search::tour(&space, known, &mut |tries| tries < 200).0);
                prop_assert!(each_once(&order, points.len()));
                prop_assert_eq!(space.length(&order), path(&space, Effort(100)).cost);
            }
        }
    }

    #[test]
    fn a_path_is_below_no_bound_and_the_same_again(points in points(60)) {
        keeps_the_bounds(&points)?;
    }
}

fn keeps_the_bounds(points: &[Point]) -> Result<(), TestCaseError> {
    for space in spaces(points) {
        let found = path(&space, Effort(5));
        prop_assert!(each_once(&found.order, points.len()));
        prop_assert_eq!(&found, &path(&space, Effort(5)));
        prop_assert_eq!(found.cost, space.length(&found.order));
        prop_assert!(found.cost <= nearest_rule(&space).cost);
        let bound = lower_bound(&space, found.cost, 60);
        prop_assert!(bound <= found.cost, "{} > {}", bound, found.cost);
    }
    Ok(())
}

/// Found once by the property test above: two pairs of equal points.
#[test]
fn points_in_one_place_keep_the_bounds() {
    let halves = [
        (45, 0),
        (-30, -10),
        (-75, -60),
        (0, 20),
        (-30, -10),
        (-15, 0),
        (75, -60),
        (-30, 10),
        (90, 0),
        (15, -20),
        (-15, 0),
        (30, -40),
        (-90, 0),
        (0, 10),
        (75, -20),
        (0, 30),
        (-30, 20),
        (-45, 60),
    ];
    let points = halves.map(|(x, y)| Point { x: Micrometres::new(x * 500), y: Micrometres::new(y * 500) });
    keeps_the_bounds(&points).unwrap();
}

/// No loop over all pairs: that would take minutes.
#[test]
fn very_many_points_in_one_place_are_no_trouble() {
    let points = vec![Point { x: Micrometres::from_mm(1), y: Micrometres::from_mm(2) }; 5_000];
    let found = quick_path(&Space::closed(&points, Metric::Euclid));
    assert!(each_once(&found.order, points.len()) && found.cost == 0);
}

#[test]
fn a_tour_begins_with_the_first_point_and_goes_the_way_of_the_list() {
    let square = [(0, 0), (0, 10), (10, 10), (10, 0)]
        .map(|(x, y)| Point { x: Micrometres::from_mm(x), y: Micrometres::from_mm(y) });
    assert_eq!(path(&Space::closed(&square, Metric::Euclid), Effort(1)).order, [0, 1, 2, 3]);
    assert_eq!(path(&Space::open(&square, Metric::Euclid), Effort(1)).order, [0, 1, 2, 3]);
}

/// The quadrant of a point as seen from another one, counted from the right and up.
fn quarter(from: Point, to: Point) -> usize {
    match ((to.x - from.x).micrometres(), (to.y - from.y).micrometres()) {
        (1.., 0..) => 0,
        (..=0, 1..) => 1,
        (..=-1, _) => 2,
        _ => 3,
    }
}

proptest! {
    #![proptest_config(technolog_laws::cases!(60))]

    #[test]
    fn near_points_are_those_that_looking_at_all_finds(points in points(120)) {
        for space in spaces(&points) {
            let found = neighbours::near_points(&space);
            for (node, &at) in points.iter().enumerate() {
                let others = (0..points.len()).filter(|other| *other != node);
                let mut all: Vec<(i64, u32)> = others.map(|other| (space.cost(node, other), other as u32)).collect();
                all.sort_unstable();
                let mut near: BTreeSet<(i64, u32)> = all.iter().copied().take(6).collect();
                for own in 0..4 {
                    let of_quarter = all.iter().filter(|(_, other)| quarter(at, points[*other as usize]) == own);
                    near.extend(of_quarter.take(2));
                }
                let near: Vec<(i64, u32)> = near.into_iter().take(12).collect();
                prop_assert_eq!(&found[node], &near, "{}", node);
            }
        }
    }

    #[test]
    fn the_shortest_tree_is_that_of_looking_at_all_pairs(points in points(60), prices in prop::collection::vec(-9_000_i64..9_000, 61)) {
        for space in spaces(&points) {
            let cost = |from: usize, to: usize| space.cost(from, to) + prices[from] + prices[to];
            let mut left: Vec<usize> = (0..points.len()).filter(|&point| point != space.outside_node()).collect();
            let mut tree: Vec<usize> = left.pop().into_iter().collect();
            let mut total = 0;
            while !left.is_empty() {
                let nearest = |&point: &usize| tree.iter().map(|&inside| cost(inside, point)).min();
                let (at, &newest) = left.iter().enumerate().min_by_key(|(_, point)| nearest(point)).unwrap();
                total += nearest(&newest).unwrap();
                tree.push(newest);
                left.swap_remove(at);
            }
            let known = vec![Vec::new(); points.len()];
            let found = shortest_tree(&space, &PointBoxes::of(&points), &prices, &known);
            prop_assert_eq!(found.len() + 1, tree.len().max(1));
            prop_assert_eq!(found.iter().map(|&(from, to)| cost(from, to)).sum::<i64>(), total);
            let mut near = neighbours::near_points(&space);
            near.iter_mut().for_each(|near| near.retain(|&(_, other)| other as usize != space.outside_node()));
            prop_assert_eq!(shortest_tree(&space, &PointBoxes::of(&points), &prices, &near), found);
        }
    }

    #[test]
    fn as_many_tries_as_a_clock_allowed_give_the_same_path(points in points(60), most in 0_u64..40) {
        for space in spaces(&points) {
            let mut queries = 0;
            let timed = path_while(&space, &mut |_| { queries += 1; queries <= most });
            prop_assert_eq!(&timed, &path_while(&space, &mut |tries| tries < timed.tries));
            prop_assert!(timed.cost <= quick_path(&space).cost);
        }
    }

    #[test]
    fn an_open_path_is_never_longer_than_a_tour_without_its_longest_edge(points in points(12)) {
        for metric in metrics() {
            let tour = path(&Space::closed(&points, metric), Effort(20));
            let open = path(&Space::open(&points, metric), Effort(20));
            let edges = (0..points.len()).map(|at| {
                let pair = [at, (at + 1) % points.len()].map(|at| points[tour.order[at]]);
                metric.cost(pair[0], pair[1])
            });
            prop_assert!(open.cost <= tour.cost - edges.max().unwrap_or(0));
        }
    }

    #[test]
    fn the_rule_of_the_book_goes_to_the_nearest_of_all_that_are_left(points in points(120)) {
        let space = Space::closed(&points, Metric::Euclid);
        let order = nearest_rule(&space).order;
        prop_assert!(each_once(&order, points.len()));
        for (at, pair) in order.windows(2).enumerate() {
            let left = &order[at + 1..];
            let nearest = left.iter().map(|&other| (space.cost(pair[0], other), other)).min();
            prop_assert_eq!(nearest.map(|(_, other)| other), Some(pair[1]));
        }
    }
}
