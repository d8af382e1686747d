//! Sets of whole numbers as sorted closed intervals: the meaning of every test of a cell.
//!
//! Because table figures are exact (whole micrometres, millionths, positions in a list of values),
//! `(15..30]` is simply 15 001 to 30 000 micrometres, and gaps, overlaps and dead rows are exact
//! arithmetic, not sampling.

use serde::{Deserialize, Serialize};

/// A set of `i64`, as disjoint closed intervals in ascending order that do not touch.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
pub struct Set(Vec<(i64, i64)>);

impl Set {
    /// Every number.
    pub fn all() -> Self {
        Self(vec![(i64::MIN, i64::MAX)])
    }

    /// Nothing.
    pub const fn empty() -> Self {
        Self(Vec::new())
    }

    /// One number.
    pub fn point(value: i64) -> Self {
        Self(vec![(value, value)])
    }

    /// A closed interval; empty when its ends are crossed.
    pub fn interval(low: i64, high: i64) -> Self {
        if low <= high { Self(vec![(low, high)]) } else { Self::empty() }
    }

    /// The union of closed intervals in any order.
    pub fn from_intervals(mut intervals: Vec<(i64, i64)>) -> Self {
        intervals.retain(|(low, high)| low <= high);
        intervals.sort_unstable();
        let mut merged: Vec<(i64, i64)> = Vec::with_capacity(intervals.len());
        for (low, high) in intervals {
            match merged.last_mut() {
                Some(last) if low <= last.1.saturating_add(1) => last.1 = last.1.max(high),
                _ => merged.push((low, high)),
            }
        }
        Self(merged)
    }

    /// Its intervals, ascending.
    pub fn intervals(&self) -> &[(i64, i64)] {
        &self.0
    }

    /// Whether nothing is in it.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Its smallest member.
    pub fn first(&self) -> Option<i64> {
        self.0.first().map(|interval| interval.0)
    }

    /// Whether it holds the number.
    pub fn contains(&self, value: i64) -> bool {
        let after = self.0.partition_point(|interval| interval.0 <= value);
        after > 0 && self.0[after - 1].1 >= value
    }

    /// The members of both sets.
    pub fn intersection(&self, other: &Self) -> Self {
        let mut both = Vec::new();
        for &(a, b) in &self.0 {
            for &(c, d) in &other.0 {
                if a.max(c) <= b.min(d) {
                    both.push((a.max(c), b.min(d)));
                }
            }
        }
        // The result is ascending and does not touch, because the intervals of both sets are so.
        Self(both)
    }

    /// Whether the sets have no common member.
    pub fn is_disjoint(&self, other: &Self) -> bool {
        self.0.iter().all(|&(a, b)| other.0.iter().all(|&(c, d)| b < c || d < a))
    }

    /// The members of either set.
    pub fn union(&self, other: &Self) -> Self {
        Self::from_intervals(self.0.iter().chain(&other.0).copied().collect())
    }

    /// The members of this set that are not in the other.
    pub fn difference(&self, other: &Self) -> Self {
        let mut left = self.0.clone();
        for &(c, d) in &other.0 {
            left = left
                .into_iter()
                .flat_map(|(a, b)| {
                    if d < a || c > b {
                        vec![(a, b)]
                    } else {
                        let mut parts = Vec::new();
                        if a < c {
                            parts.push((a, c - 1));
                        }
                        if b > d {
                            parts.push((d + 1, b));
                        }
                        parts
                    }
                })
                .collect();
        }
        Self(left)
    }

    /// Whether every member is in the other too.
    pub fn is_subset(&self, other: &Self) -> bool {
        self.difference(other).is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn sets() -> impl Strategy<Value = Set> {
        prop::collection::vec((-20_i64..20, 0_i64..6), 0..5)
            .prop_map(|parts| Set::from_intervals(parts.into_iter().map(|(low, len)| (low, low + len)).collect()))
    }

    proptest! {
        #![proptest_config(technolog_laws::cases!(256))]

        #[test]
        fn sets_agree_with_membership(a in sets(), b in sets()) {
            for x in -30..30 {
                prop_assert_eq!(a.union(&b).contains(x), a.contains(x) || b.contains(x));
                prop_assert_eq!(a.intersection(&b).contains(x), a.contains(x) && b.contains(x));
                prop_assert_eq!(a.difference(&b).contains(x), a.contains(x) && !b.contains(x));
            }
            prop_assert_eq!(a.is_subset(&b), (-30..30).all(|x| !a.contains(x) || b.contains(x)));
            prop_assert_eq!(a.is_disjoint(&b), a.intersection(&b).is_empty());
            let both = a.intersection(&b);
            prop_assert_eq!(&Set::from_intervals(both.intervals().to_vec()), &both);
        }
    }
}
