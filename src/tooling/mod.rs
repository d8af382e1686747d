//! Cutters and holders from the catalogs, and whether they reach.

mod cutter;
mod holder;

pub use cutter::{Cutter, CutterNeed, drill_diameters, find_cutter};
pub use holder::{Assembly, assemble};
