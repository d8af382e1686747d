//! The division of a thread's depth into passes.

use crate::note::Because;
use crate::turning::length::Half;

/// The law of division.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passes {
    /// As makers divide it, for single passes: pass n of N reaches h·√(φ/(N − 1)) with φ = n − 1, and for the first a share
    /// of 1 (`thread-first-share`), so that it is no deeper than the others although nothing else bears on the tip.
    Makers,
    /// Each pass removes the same area: pass n of N reaches h·√(n/N).
    Area,
    /// Each pass has the same depth: pass n of N reaches h·n/N.
    Depth,
}

/// What bounds the passes.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    /// No pass is deeper.
    pub first: Half,
    /// None is thinner.
    pub least: Half,
    /// φ of the first pass of [`Passes::Makers`].
    pub first_share: f64,
}

/// The passes of a thread.
pub(super) struct Divided {
    /// The depth of each, ascending; the last is the whole depth.
    pub depths: Vec<Half>,
    /// The same by equal areas, as cycles of controls make them.
    pub of_cycles: Vec<Half>,
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
    pub fn depths(self, whole: Half, wanted: usize, bounds: Bounds) -> Vec<Half> {
        let Bounds { first, least, first_share: share } = bounds;
        let (depth, most) = (whole.to_mm(), first.to_mm().max(0.001));
        // The deepest pass of the makers is the second, or the first where its share is more than a quarter.
        let deepest = libm::sqrt(share).max(1.0 - libm::sqrt(share));
        let needed = match self {
            Self::Makers => 1.0 + libm::ceil(deepest * deepest * depth * depth / (most * most) - 1e-9),
            Self::Area => libm::ceil(depth * depth / (most * most) - 1e-9),
            Self::Depth => libm::ceil(depth / most - 1e-9),
        };
        let count = (wanted as f64).max(needed).max(1.0);
        let reached = |number: f64| match self {
            // One pass alone takes it all.
            Self::Makers if count < 2.0 => depth,
            Self::Makers => depth * libm::sqrt(if number < 2.0 { share } else { number - 1.0 } / (count - 1.0)),
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
        let bounds = Bounds { first: Half::from(first), least: Half::from(0.05), first_share: 0.3 };
        let depths = passes.depths(Half::from(whole), wanted, bounds);
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

    /// Sandvik's and Widia's formula: 1.23·√(φ/7) with φ = 0.3, 1, 2 … 7, worked by hand. Mitsubishi's table for P 2 has 0.25, 0.25,
    /// 0.20, 0.15, 0.15, 0.10, 0.08, 0.05 and Sumitomo's first pass of P 2 is 0.28, both as deep to a tenth.
    #[test]
    fn passes_of_makers_begin_as_their_tables() {
        let by_hand = [0.2546, 0.4649, 0.6575, 0.8052, 0.9298, 1.0395, 1.1387, 1.23];
        let found = depths(Passes::Makers, 1.23, 8, 0.5);
        assert_eq!(found.len(), 8);
        for (is, should) in found.iter().zip(by_hand) {
            assert!((is - should).abs() < 0.0006, "{found:?}");
        }
        let (mut reached, mut before) = (0.0, 0.0);
        for (table, is) in [0.25, 0.25, 0.20, 0.15, 0.15, 0.10, 0.08, 0.05].into_iter().zip(&found) {
            reached += table;
            assert!((is - reached).abs() < 0.1 && is - before <= 0.2546 + 0.001, "{found:?}");
            before = *is;
        }
        // P 4 in stainless steel, at most 0.33: the second pass is deeper than the first, by (1 − √0.3)·2.45/√(N − 1).
        assert!(depths(Passes::Makers, 2.45, 4, 0.33).len() as f64 >= 1.0 + (2.45 * 0.5477_f64 / 0.33).powi(2));
    }

    /// The first pass is not deeper than it may be, no pass thinner than 0.05, and the last is the whole depth.
    #[test]
    fn passes_stay_between_the_deepest_first_and_the_thinnest() {
        for pitch in 1..=20 {
            let whole = 0.6134 * f64::from(pitch) * 0.25;
            for (wanted, first) in [(4, 0.5), (14, 0.33), (8, 0.4), (30, 0.2)] {
                for law in [Passes::Makers, Passes::Area, Passes::Depth] {
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
