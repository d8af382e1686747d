//! Finds the pieces over a range of Z without a search of the whole contour.

use std::ops::Range;

use crate::turning::length::Half;

/// Ranges of Z in the order of a contour. In grooves the contour may run back, so they need not be sorted.
#[derive(Clone, Debug)]
pub struct Stretches {
    /// The greatest end of each range and all before it.
    ends: Vec<Half>,
    /// The least beginning of each range and all after it.
    begins: Vec<Half>,
}

impl Stretches {
    /// The ranges by their ends.
    pub fn new(all: &[(Half, Half)]) -> Self {
        let farthest = |end: &mut Half, (_, to): &(Half, Half)| {
            *end = (*to).max(*end);
            Some(*end)
        };
        let nearest = |begin: &mut Half, (from, _): &(Half, Half)| {
            *begin = (*from).min(*begin);
            Some(*begin)
        };
        let mut begins: Vec<Half> = all.iter().rev().scan(Half::new(i64::MAX), nearest).collect();
        begins.reverse();
        Self { ends: all.iter().scan(Half::new(i64::MIN), farthest).collect(), begins }
    }

    /// The indices of the ranges that may have a point between two Z, these included. No other range has one.
    pub fn touching(&self, from: Half, to: Half) -> Range<usize> {
        let first = self.ends.partition_point(|end| *end < from);
        first..self.begins.partition_point(|begin| *begin <= to).max(first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_that_touches_is_left_out_where_the_order_is_broken() {
        let half = |(from, to): &(i64, i64)| (Half::new(*from), Half::new(*to));
        // The third leads back under the second.
        let all: Vec<_> = [(0, 10), (10, 30), (15, 30), (30, 40), (40, 50)].iter().map(half).collect();
        let stretches = Stretches::new(&all);
        for from in -5..55 {
            for to in from..55 {
                let (from, to) = half(&(from, to));
                let near = stretches.touching(from, to);
                for (place, (begin, end)) in all.iter().enumerate() {
                    assert!(near.contains(&place) || *end < from || *begin > to, "{place} over {from}..{to}");
                }
            }
        }
        assert_eq!(stretches.touching(Half::new(31), Half::new(39)), 3..4);
        assert_eq!(stretches.touching(Half::new(12), Half::new(14)), 1..2);
        assert!(stretches.touching(Half::new(60), Half::new(70)).is_empty());
    }
}
