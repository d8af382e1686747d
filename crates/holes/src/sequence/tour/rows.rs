//! Tours along rows: along one row and back along the next, as a technologist would visit a grid.
//!
//! Where both axes move at once, an oblique step to the next row costs no more than a straight one, so a grid has
//! very many shortest tours, and the search finds any of them. A tour along rows is as short and easier to follow,
//! and its program repeats its steps.

use super::{Metric, Path, Space};
use crate::part::Point;

/// The best tour along rows or columns, if it costs no more than the tour that was found.
pub(super) fn at_no_cost(space: &Space<'_>, found: Path) -> Path {
    if space.free_ends || space.points.len() < 4 {
        return found;
    }
    let straight = |order: &[usize]| Space::closed(space.points, Metric::Euclid).length(order);
    let mut best = (found.cost, straight(&found.order), found.order);
    for flat in tours(space.points) {
        let order = from_home(space, &flat);
        let candidate = (space.length(&order), straight(&order));
        if candidate < (best.0, best.1) {
            best = (candidate.0, candidate.1, order);
        }
    }
    Path { cost: best.0, order: super::from_the_start(space, best.2), optimal: found.optimal, tries: found.tries }
}

/// Cycles over all points but the first, where the tour begins: along rows and along columns, to and fro; over all
/// points, or without the first of every row, which are visited on the way back.
fn tours(points: &[Point]) -> Vec<Vec<usize>> {
    let mut tours = Vec::new();
    let swapped = |point: Point| Point { x: point.y, y: point.x };
    for turned in [false, true] {
        let at = |index: usize| if turned { swapped(points[index]) } else { points[index] };
        let Some(rows) = rows((1..points.len()).collect(), at) else { continue };
        for mirrored in [false, true] {
            let rows: Vec<Vec<usize>> = rows
                .iter()
                .map(|row| if mirrored { row.iter().rev().copied().collect() } else { row.clone() })
                .collect();
            tours.push(to_and_fro(&rows, 0));
            tours.push(to_and_fro(&rows, 1));
        }
    }
    tours
}

/// The points by rows of equal Y, each along X; none where most rows have a single point.
fn rows(mut indices: Vec<usize>, at: impl Fn(usize) -> Point) -> Option<Vec<Vec<usize>>> {
    indices.sort_by_key(|&index| (at(index).y, at(index).x, index));
    let rows: Vec<Vec<usize>> = indices.chunk_by(|&a, &b| at(a).y == at(b).y).map(<[usize]>::to_vec).collect();
    (rows.len() * 2 <= indices.len()).then_some(rows)
}

/// Along the first row, back along the second, and so on; the first `kept` points of every row are left for the way
/// back.
fn to_and_fro(rows: &[Vec<usize>], kept: usize) -> Vec<usize> {
    let mut tour = Vec::new();
    for (number, row) in rows.iter().enumerate() {
        let row = row.iter().skip(kept);
        if number % 2 == 0 { tour.extend(row) } else { tour.extend(row.rev()) }
    }
    tour.extend(rows.iter().rev().flat_map(|row| row.iter().take(kept)));
    tour
}

/// A cycle over the other points, entered from point 0 where the cost is least.
fn from_home(space: &Space<'_>, cycle: &[usize]) -> Vec<usize> {
    let longer = |at: usize| {
        let (from, to) = (cycle[at], cycle[(at + 1) % cycle.len()]);
        space.cost(from, 0) + space.cost(0, to) - space.cost(from, to)
    };
    let Some(at) = (0..cycle.len()).min_by_key(|&at| (longer(at), at)) else { return vec![0] };
    let mut order = vec![0];
    order.extend(cycle[at + 1..].iter().chain(&cycle[..=at]));
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Micrometres;

    fn grid(columns: i64, rows: i64) -> Vec<Point> {
        let at = |x, y| Point { x: Micrometres::from_mm(x), y: Micrometres::from_mm(y) };
        let mut points = vec![at(0, 196)];
        points.extend((0..rows).flat_map(|row| (0..columns).map(move |column| at(column * 20, -row * 20))));
        points
    }

    /// Going round a grid and home over its first column, every step is one of the grid.
    #[test]
    fn a_grid_is_gone_over_in_rows() {
        let points = grid(7, 6);
        let metric = Metric::Euclid;
        let space = Space::closed(&points, metric);
        let best = tours(&points)
            .into_iter()
            .map(|cycle| (space.round(&cycle), cycle))
            .min()
            .map(|(cost, cycle)| (cost, cycle.len()));
        assert_eq!(best, Some((42 * 20_000, 42)));
    }

    #[test]
    fn what_is_found_is_kept_where_rows_cost_more() {
        let points: Vec<Point> = [[0, 0], [10, 1], [20, 7], [13, 30], [2, 17]]
            .map(|[x, y]| Point { x: Micrometres::from_mm(x), y: Micrometres::from_mm(y) })
            .to_vec();
        let space = Space::closed(&points, Metric::Euclid);
        let found = super::super::path(&space, super::super::Effort(100));
        assert_eq!(at_no_cost(&space, found.clone()), found);
    }
}
