//! The objective and its tie-breaks. All costs are whole numbers, so that sums are exact.

use serde::Serialize;

use crate::turning::length::Half;
use crate::turning::shaft::Rates;
use crate::units::{MillimetresPerMinute, Minutes, round_to};

use super::pass::{PassDirection, PassEnd, PassStart, legs};

/// The minimised quantity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Objective {
    /// The length cut in metal: the criterion of the paper. Among equals the one with fewer passes, then with fewer
    /// changes of direction.
    Path,
    /// The length cut in metal plus a fixed amount for each pass.
    PathAndPasses {
        /// Added for each pass, mm.
        per_pass_mm: Half,
    },
    /// The time with feeds, approach, retract and rapids. Among equals the one with the shorter length in metal.
    Time {
        /// The rates of the tool.
        rates: Rates,
    },
    /// The number of passes. Among equals the one with the shorter length in metal.
    Passes,
}

impl Objective {
    /// Its name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Path => "path",
            Self::PathAndPasses { .. } => "path-and-passes",
            Self::Time { .. } => "time",
            Self::Passes => "passes",
        }
    }

    /// Its quantity in output: mm, min or passes.
    pub(super) fn shown(self, main: u64) -> f64 {
        match self {
            Self::Path | Self::PathAndPasses { .. } => main as f64 / 2000.0,
            Self::Time { .. } => round_to(minutes(main).0, 4),
            Self::Passes => main as f64,
        }
    }

    /// The unit of that.
    pub(super) const fn unit(self) -> &'static str {
        match self {
            Self::Path | Self::PathAndPasses { .. } => "mm",
            Self::Time { .. } => "min",
            Self::Passes => "passes",
        }
    }

    /// The cost of a pass of a length, with the motion to it from the end of the previous one.
    #[inline(always)]
    pub(super) fn pass(&self, start: PassStart, length: Half, before: Option<PassEnd>, bar: Half) -> Cost {
        let long = length.halves().unsigned_abs();
        // The first pass changes no direction.
        let turned = before.is_some_and(|spot| spot.kind != start.kind);
        let (main, second, third) = match self {
            Self::Path => (long, 1, u64::from(turned)),
            Self::PathAndPasses { per_pass_mm } => (long + per_pass_mm.halves().unsigned_abs(), 1, u64::from(turned)),
            Self::Passes => (1, long, u64::from(turned)),
            Self::Time { rates } => {
                (cutting(rates, start.kind, length) + link(rates, before, Some(start), bar), long, 1)
            }
        };
        Cost { main, second, third }
    }

    /// The cost of the return to home after the last pass.
    pub(super) fn home(&self, last: Option<PassEnd>, bar: Half) -> Cost {
        match self {
            Self::Time { rates } if last.is_some() => Cost { main: link(rates, last, None, bar), second: 0, third: 0 },
            _ => Cost::ZERO,
        }
    }
}

/// A cost: the quantity of the objective (halves of a micrometre, nanoseconds or passes), and two numbers to choose
/// among equals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Cost {
    /// The quantity of the objective.
    pub main: u64,
    /// Decides first among equals.
    pub second: u64,
    /// Decides next.
    pub third: u64,
}

impl Cost {
    /// Nothing.
    pub const ZERO: Self = Self { main: 0, second: 0, third: 0 };

    /// Both together.
    #[must_use]
    #[inline]
    pub const fn plus(self, other: Self) -> Self {
        Self { main: self.main + other.main, second: self.second + other.second, third: self.third + other.third }
    }
}

/// The time of a pass and its approach, both at the feed, ns.
fn cutting(rates: &Rates, kind: PassDirection, length: Half) -> u64 {
    let feed = match kind {
        PassDirection::Longitudinal => rates.longitudinal_feed,
        PassDirection::Transverse => rates.transverse_feed,
    };
    nanoseconds(length + Half::of(rates.approach), feed)
}

/// The time of the rapids from the end of a pass (or home) to the start of the next (or home), ns.
fn link(rates: &Rates, before: Option<PassEnd>, next: Option<PassStart>, bar: Half) -> u64 {
    let mut time = 0;
    for (a, b) in legs(before, next, bar, rates) {
        let longer = (a.radius - b.radius).halves().abs().max((a.z - b.z).halves().abs());
        time += nanoseconds(Half::new(longer), rates.rapid);
    }
    time
}

/// The time of a length at a rate, in whole nanoseconds, so that sums do not depend on their order.
fn nanoseconds(length: Half, rate: MillimetresPerMinute) -> u64 {
    // A half of a micrometre takes 30,000,000 ns at 1 mm/min.
    (length.halves() as f64 * 30_000_000.0 / rate.0).round() as u64
}

/// Nanoseconds as minutes.
pub(super) fn minutes(nanoseconds: u64) -> Minutes {
    Minutes(nanoseconds as f64 / 60e9)
}
