//! Planning of holes. Each room adds its part of the plan; [`planner`] calls the rooms in turn.
//!
//! - [`route`] finds the steps of a hole, [`tooling`] its tools, [`setup`] the clamping of the part;
//! - [`sequence`] finds the order of the tools and the path of each tool over the holes;
//! - [`planner`] is the only room that tries the next alternative after a refusal.

pub mod planner;
pub mod route;
pub mod sequence;
pub mod setup;
pub mod tooling;

// The types of other crates, under one name each in the whole program.
use technolog_core::{chip_room, error, machine, note, part, plan, reason, shop, zone};
use technolog_cutting as cutting;
use technolog_job as job;
use technolog_knowledge::{self as knowledge, units};
use technolog_tables as tables;
