//! The division of a thread's depth into passes.

use crate::note::Because;
use crate::turning::length::Half;

/// The law of division.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passes {
    /// Each pass removes the same area: pass n of N reaches h·√(n/N).
    Area,
    /// Each pass has the same depth: pass n of N reaches h·n/N.
    Depth,
}

/// The passes of a thread.
pub(super) struct Divided {
    /// The depth of each, ascending; the last is the whole depth.
    pub depths: Vec<Half>,
    /// Further passes at the whole depth.
    pub springs: usize,
    /// Their rows.
    pub because: Vec<Because>,
}

impl Passes {
    /// The depths of the passes: the wanted number, more if the first would be too deep. No pass is less deep than
    /// the least, so that the edge cuts and does not rub; that can reduce their number.
    ///
    /// LinuxCNC's G76 with R2 and Fanuc's G76 have the same law of area, and Fanuc's the same least pass.
    pub fn depths(self, whole: Half, wanted: usize, first: Half, least: Half) -> Vec<Half> {
        let (depth, most) = (whole.to_mm(), first.to_mm().max(0.001));
        let needed = match self {
            Self::Area => libm::ceil(depth * depth / (most * most) - 1e-9),
            Self::Depth => libm::ceil(depth / most - 1e-9),
        };
        let count = (wanted as f64).max(needed).max(1.0);
        let reached = |number: f64| match self {
            Self::Area => depth * libm::sqrt(number / count),
            Self::Depth => depth * number / count,
        };
        let mut depths: Vec<Half> = Vec::new();
        for number in 1..=count as i64 {
            let before = depths.last().copied().unwrap_or(Half::ZERO);
            let reach = Half::from(reached(number as f64)).max(before + least);
            // A remainder too small for a pass of its own is added to this one.
            if reach + least > whole {
                break;
            }
            depths.push(reach);
        }
        depths.push(whole);
        depths
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn depths(passes: Passes, whole: f64, wanted: usize, first: f64) -> Vec<f64> {
        let depths = passes.depths(Half::from(whole), wanted, Half::from(first), Half::from(0.05));
        depths.iter().map(|depth| depth.to_mm()).collect()
    }

    /// By hand: h = 1.227 in 8 passes by area: 1.227·√(n/8).
    #[test]
    fn passes_of_one_area_become_thinner() {
        let by_hand = [0.4338, 0.6135, 0.7514, 0.8676, 0.9700, 1.0626, 1.1477, 1.227];
        let found = depths(Passes::Area, 1.227, 8, 0.5);
        assert_eq!(found.len(), 8);
        for (is, should) in found.iter().zip(by_hand) {
            assert!((is - should).abs() < 0.0006, "{found:?}");
        }
        let by_depth = depths(Passes::Depth, 1.2, 8, 0.5);
        assert!(by_depth.windows(2).all(|pair| (pair[1] - pair[0] - 0.15).abs() < 0.001), "{by_depth:?}");
    }

    /// The first pass is not deeper than it may be, no pass thinner than 0.05, and the last is the whole depth.
    #[test]
    fn passes_stay_between_the_deepest_first_and_the_thinnest() {
        for pitch in 1..=20 {
            let whole = 0.6134 * f64::from(pitch) * 0.25;
            for (wanted, first) in [(4, 0.5), (14, 0.33), (8, 0.4), (30, 0.2)] {
                for law in [Passes::Area, Passes::Depth] {
                    let found = depths(law, whole, wanted, first);
                    assert!((found[found.len() - 1] - whole).abs() < 0.0006);
                    // Where the whole depth is less than two of the thinnest, one pass takes it.
                    let thin = found[0].min(whole);
                    assert!(thin <= first + 0.0006 || whole < 0.1, "{whole} {found:?}");
                    let steps = found.windows(2).map(|pair| pair[1] - pair[0]);
                    assert!(
                        steps.into_iter().all(|step| (0.0495..=first + 0.051).contains(&step)),
                        "{whole} {found:?}"
                    );
                }
            }
        }
        // Mitsubishi wants 4 passes at P 0.5, of h 0.307; by area the last would be 0.041.
        assert_eq!(depths(Passes::Area, 0.307, 4, 0.5).len(), 3);
    }
}
