//! Plans the whole grid of ordinary holes and writes the table of its refusals into docs/refusals.md:
//!
//!     cargo run -q --example refusals              # the whole grid, about half an hour of one core without optimisation
//!     cargo run -q --example refusals -- 20        # every twentieth hole, to the terminal alone

use technolog::parallel;
use technolog_testing::grid::{GridHole, holes};
use technolog_testing::refusals::{Verdict, replaced, table, verdict};

fn main() -> Result<(), std::io::Error> {
    let every: Option<usize> = std::env::args().nth(1).and_then(|text| text.parse().ok());
    let holes: Vec<GridHole> = holes().into_iter().step_by(every.unwrap_or(1).max(1)).collect();
    let verdicts = parallel::map(&holes, verdict, |_| {});
    let outcomes: Vec<(GridHole, Verdict)> = holes.into_iter().zip(verdicts).collect();
    let text = table(&outcomes);
    println!("{text}");
    for (hole, verdict) in &outcomes {
        match verdict {
            Verdict::Wanting(why) => println!("wanting: {hole}: {why}"),
            Verdict::Refused { limit, why, nearest: None } => println!("nothing near: {hole}: {limit}: {why}"),
            _ => {}
        }
    }
    if every.is_none() {
        let path = technolog_testing::root().join("docs/refusals.md");
        let page = std::fs::read_to_string(&path)?;
        std::fs::write(&path, replaced(&page, "## The whole grid", &text))?;
    }
    Ok(())
}
