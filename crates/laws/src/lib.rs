//! The number of cases and the seeds of property tests, decided in one place.
//!
//! `cargo test` draws the same cases on every machine and in every run. The seed of a law comes from its name, so
//! that equal strategies in two laws draw different values. Two environment variables change that for all laws at
//! once; `.ci/explore` sets both:
//!
//! - `TECHNOLOG_CASES`: the factor on the usual number of cases, `10` or `0.25`;
//! - `TECHNOLOG_SEED`: a whole number that changes all seeds.
//!
//! A failing case is printed as proptest has shrunk it, and is not kept in a file of seeds, because a seed gives
//! another case as soon as its strategy changes: the printed case becomes a test of its own.

use std::collections::BTreeMap;
use std::str::FromStr;

use proptest::test_runner::{Config, RngSeed};

/// How a law of `proptest!` is run: `#![proptest_config(technolog_laws::cases!(300))]` for 300 cases of each law in the
/// block, each law by a seed of its own.
#[macro_export]
macro_rules! cases {
    ($usual:expr) => {{
        // Its type is called by the path of the law that it stands in.
        fn here() {}
        $crate::config(::std::any::type_name_of_val(&here), $usual)
    }};
}

/// The configuration of a law, by the path of something inside it and the usual number of cases.
pub fn config(here: &str, usual: usize) -> Config {
    // A crate may be renamed by its users, so its name is left out.
    let name = here.split_once("::").map_or(here, |(_, name)| name);
    let cases = u32::try_from(count(usual)).unwrap_or(u32::MAX);
    let plain = Config::default();
    Config {
        cases,
        rng_seed: RngSeed::Fixed(seed_of(name)),
        failure_persistence: None,
        // With more cases, more may be rejected.
        max_global_rejects: plain.max_global_rejects.max(cases.saturating_mul(4)),
        ..plain
    }
}

/// The number of cases tried for a usual number: multiplied by `TECHNOLOG_CASES`, at least one.
pub fn count(usual: usize) -> usize {
    scaled(usual, times())
}

/// The stride through a long list: usually `usual`; `1` tries the whole list.
pub fn every(usual: usize) -> usize {
    scaled(usual, 1.0 / times())
}

/// A share of every kind in a long list: with the stride of [`every`], beginning at the first, so that no kind is
/// left out.
pub fn share<T, K: Ord>(all: impl IntoIterator<Item = T>, usual: usize, kind: impl Fn(&T) -> K) -> Vec<T> {
    let (each, mut seen) = (every(usual), BTreeMap::<K, usize>::new());
    let mut taken = |one: &T| {
        let before = seen.entry(kind(one)).or_default();
        *before += 1;
        (*before - 1).is_multiple_of(each)
    };
    all.into_iter().filter(|one| taken(one)).collect()
}

/// The seed by a name: different for every name and every `TECHNOLOG_SEED`.
pub fn seed_of(name: &str) -> u64 {
    let seed: u64 = variable("TECHNOLOG_SEED").unwrap_or(0);
    // FNV-1a: the same numbers everywhere and in every version of the library.
    let bytes = seed.to_le_bytes().into_iter().chain(name.bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

fn times() -> f64 {
    variable("TECHNOLOG_CASES").filter(|times: &f64| times.is_finite() && *times > 0.0).unwrap_or(1.0)
}

fn scaled(usual: usize, times: f64) -> usize {
    ((usual as f64 * times).round() as usize).max(1)
}

fn variable<T: FromStr>(name: &str) -> Option<T> {
    std::env::var(name).ok()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(crate::cases!(16))]

        #[test]
        fn counts_grow_with_the_times(usual in 1_usize..10_000, times in 0.01_f64..100.0) {
            prop_assert!(scaled(usual, times) >= 1);
            prop_assert!(scaled(usual, times) <= scaled(usual, times * 2.0));
            prop_assert_eq!(scaled(usual, 1.0), usual);
        }
    }

    #[test]
    fn a_share_has_every_kind() {
        let all = [(1, 'a'), (2, 'a'), (3, 'b'), (4, 'a'), (5, 'a'), (6, 'c')];
        let few = share(all, 1_000_000, |(_, kind)| *kind);
        assert_eq!(few, [(1, 'a'), (3, 'b'), (6, 'c')]);
    }

    #[test]
    fn a_law_has_a_seed_of_its_own() {
        let config = crate::cases!(7);
        assert_eq!(config.rng_seed, RngSeed::Fixed(seed_of("tests::a_law_has_a_seed_of_its_own::here")));
        assert_ne!(seed_of("one"), seed_of("other"));
        assert!(config.failure_persistence.is_none());
    }
}
