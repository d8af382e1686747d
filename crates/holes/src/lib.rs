//! Planning of holes: each room adds its part of a plan, [`planner`] asks them in turn.
//!
//! - [`route`] is by which steps a hole is made, [`tooling`] with what, [`setup`] how the part is clamped;
//! - [`sequence`] is the order of tools and the path of each over the holes;
//! - [`planner`] is the one place where a refusal makes it try the next alternative.

pub mod planner;
pub mod route;
pub mod sequence;
pub mod setup;
pub mod tooling;

// The rooms below, under one name each in the whole program.
use technolog_core::{error, machine, note, part, plan, reason, shop, zone};
use technolog_cutting as cutting;
use technolog_job as job;
use technolog_knowledge::{self as knowledge, units};
use technolog_tables as tables;
