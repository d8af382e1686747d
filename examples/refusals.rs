//! Plans the whole grid of ordinary holes and writes the table of its refusals into docs/refusals.md:
//!
//!     cargo run -q --example refusals              # the whole grid, more than half an hour of one core
//!     cargo run -q --example refusals -- 5         # every fifth hole of it
//!
//! 2, 3, 7 and 11 divide the grid: a stride with one of them takes the same materials, depths or blanks again and again.

use technolog::parallel;
use technolog_testing::grid::{GridHole, holes};
use technolog_testing::refusals::{Verdict, replaced, table, verdict};

fn main() -> Result<(), std::io::Error> {
    let every: usize = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(1).max(1);
    let whole = holes();
    let all = whole.len();
    let holes: Vec<GridHole> = whole.into_iter().step_by(every).collect();
    let verdicts = parallel::map(&holes, verdict, |_| {});
    let outcomes: Vec<(GridHole, Verdict)> = holes.into_iter().zip(verdicts).collect();
    let of = if every == 1 { String::new() } else { format!("One hole in {every} of the {all}: ") };
    let text = of + &table(&outcomes);
    println!("{text}");
    for (hole, verdict) in &outcomes {
        match verdict {
            Verdict::Wanting(why) => println!("wanting: {hole}: {why}"),
            Verdict::Refused { limit, why, nearest: None } => println!("nothing near: {hole}: {limit}: {why}"),
            Verdict::Refused { limit, why, .. } => println!("refused: {hole}: {limit}: {why}"),
            _ => {}
        }
    }
    let path = technolog_testing::root().join("docs/refusals.md");
    let page = std::fs::read_to_string(&path)?;
    std::fs::write(&path, replaced(&page, "## The whole grid", &text))
}
