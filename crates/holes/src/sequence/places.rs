//! A spatial index of points: boxes, each divided into two, so that near points are found without looking at all.

use std::ops::Range;

use crate::part::Point;
use crate::units::Micrometres;

/// The most points of a box that is not divided.
const LEAF: usize = 6;

/// The points in boxes. Box 0 holds all of them; the halves of box `k` are boxes `2k + 1` and `2k + 2`.
pub(super) struct PointBoxes<'p> {
    points: &'p [Point],
    /// The points, box by box: those of one box are adjacent.
    order: Vec<u32>,
    bounds: Vec<Bounds>,
}

/// The corners of a box, and the number of its first point in the list, which saves looking at many equal points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    pub(super) low: Point,
    pub(super) high: Point,
    pub(super) first: u32,
}

impl Bounds {
    /// The place within the box that is nearest to a point.
    #[inline]
    pub(super) fn nearest(&self, point: Point) -> Point {
        let Self { low, high, .. } = self;
        Point { x: point.x.max(low.x).min(high.x), y: point.y.max(low.y).min(high.y) }
    }
}

/// A query over the index.
pub(super) trait Query {
    /// The least possible cost of a point in a box; none if no point of it is wanted.
    fn lower_bound(&self, number: usize, bounds: &Bounds) -> Option<i64>;
    /// Looks at one point.
    fn meet(&mut self, point: usize);
}

/// A box by its number, with the range of its points.
#[derive(Clone)]
struct BoxOfPoints {
    number: usize,
    range: Range<usize>,
}

impl BoxOfPoints {
    fn halves(&self) -> Option<[Self; 2]> {
        let Range { start, end } = self.range;
        let middle = start.midpoint(end);
        let half = |side, range| Self { number: 2 * self.number + side, range };
        (end - start > LEAF).then(|| [half(1, start..middle), half(2, middle..end)])
    }
}

impl<'p> PointBoxes<'p> {
    pub(super) fn of(points: &'p [Point]) -> Self {
        let zero = Point { x: Micrometres::ZERO, y: Micrometres::ZERO };
        let bounds = vec![Bounds { low: zero, high: zero, first: 0 }; points.len().max(1)];
        let mut places = Self { points, order: (0..points.len() as u32).collect(), bounds };
        places.halve(&places.all());
        places
    }

    fn all(&self) -> BoxOfPoints {
        BoxOfPoints { number: 0, range: 0..self.order.len() }
    }

    /// Finds the corners of a box, and divides it across its longer side.
    fn halve(&mut self, part: &BoxOfPoints) {
        let at = |&index: &u32| self.points[index as usize];
        let own = &mut self.order[part.range.clone()];
        let lowest = own.iter().copied().min().unwrap_or_default();
        let Some(first) = own.first().map(at) else { return };
        let (low, high) = own.iter().map(at).fold((first, first), |(low, high), point| {
            let low = Point { x: low.x.min(point.x), y: low.y.min(point.y) };
            (low, Point { x: high.x.max(point.x), y: high.y.max(point.y) })
        });
        self.bounds[part.number] = Bounds { low, high, first: lowest };
        if let Some(halves) = part.halves() {
            let wide = high.x - low.x > high.y - low.y;
            own.select_nth_unstable_by_key(halves[0].range.len(), |index| {
                let Point { x, y } = at(index);
                (if wide { [x, y] } else { [y, x] }, *index)
            });
            halves.iter().for_each(|half| self.halve(half));
        }
    }

    /// The numbers of the boxes that hold each point, the largest box first.
    pub(super) fn boxes(&self) -> Vec<Vec<u32>> {
        let mut boxes = vec![Vec::new(); self.points.len()];
        self.boxes_in(&self.all(), &mut boxes);
        boxes
    }

    fn boxes_in(&self, part: &BoxOfPoints, boxes: &mut [Vec<u32>]) {
        self.order[part.range.clone()].iter().for_each(|&point| boxes[point as usize].push(part.number as u32));
        part.halves().iter().flatten().for_each(|half| self.boxes_in(half, boxes));
    }

    /// Visits the points that a query may want, the cheaper boxes first.
    pub(super) fn seek(&self, query: &mut impl Query) {
        self.seek_in(&self.all(), query);
    }

    fn seek_in(&self, part: &BoxOfPoints, query: &mut impl Query) {
        let Some(mut halves) = part.halves() else {
            return self.order[part.range.clone()].iter().for_each(|&point| query.meet(point as usize));
        };
        let least = |half: &BoxOfPoints, query: &_| Query::lower_bound(query, half.number, &self.bounds[half.number]);
        match halves.each_ref().map(|half| least(half, query)) {
            [Some(one), Some(other)] if other < one => halves.reverse(),
            [None, Some(_)] => halves.reverse(),
            _ => {}
        }
        for half in halves {
            if least(&half, query).is_some() {
                self.seek_in(&half, query);
            }
        }
    }
}
