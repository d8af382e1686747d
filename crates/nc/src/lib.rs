//! NC programs: [`program`] has the languages of controls, with writers and interpreters; [`job`] is the input of the
//! writers.
//!
//! Architecture invariant: nothing is planned here. A job is made from a finished plan.

pub mod program;

// The types of other crates, under one name each in the whole program.
use technolog_core::{error, machine, motion, note, part, plan, shop, zone};
pub use technolog_job as job;
use technolog_knowledge::{self as knowledge, units};
#[cfg(test)]
use technolog_shipped as shipped;
use technolog_tables as tables;
