//! A thin sample of the grid of ordinary holes, docs/refusals.md; examples/refusals.rs plans all of it.

use std::fs;

use technolog_testing::grid::{GridHole, holes};
use technolog_testing::refusals::{LIMITS, Verdict, replaced, table, verdict};
use technolog_testing::root;

/// Every so manieth hole is tried: a prime, so that no key of the grid is passed over.
const EVERY: usize = 241;
const HEADING: &str = "## A thin sample";

#[test]
fn what_is_refused_says_its_limit_and_what_is_possible_beside_it() {
    let sample: Vec<GridHole> = holes().into_iter().step_by(EVERY).collect();
    let outcomes: Vec<(GridHole, Verdict)> = sample.into_iter().map(|hole| (hole, verdict(&hole))).collect();
    for (hole, verdict) in &outcomes {
        if let Verdict::Refused { limit, why, nearest } = verdict {
            assert!(LIMITS.contains(&limit.as_str()), "{hole}: {limit}: {why}");
            assert!(nearest.is_some(), "{hole}: {why}");
        }
    }
    let path = root().join("docs/refusals.md");
    let page = fs::read_to_string(&path).unwrap();
    let fresh = replaced(&page, HEADING, &table(&outcomes));
    if std::env::var("UPDATE_DOCS").is_ok_and(|value| value == "1") {
        fs::write(&path, fresh).unwrap();
        return;
    }
    assert_eq!(fresh, page, "UPDATE_DOCS=1 writes the sample anew");
}
