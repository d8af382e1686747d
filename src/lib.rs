//! `technolog`: a knowledge base and rule engine for machining process planning.
//!
//! This library is the front of the house: it shows the rooms of `crates/` under one name each and has nothing of its own.
//! The way of the data, once, left to right:
//! `part.yaml → part → route → tooling → cutting → setup → sequence → Plan → (program | report | audit)`.
//!
//! - [`knowledge`] and [`units`] are the tables, the queries that say why, and the exact quantities;
//! - [`shipped`] is the knowledge the program carries in itself;
//! - [`part`] is what is to be made, [`shop`] what it is made with ([`machine`], [`material`], [`zone`]);
//! - [`route`], [`tooling`], [`cutting`], [`setup`] and [`sequence`] each add their part;
//! - [`planner`] is the one place where a refusal makes it try the next alternative;
//! - [`plan`] is the result, a value; [`report`] prints it; [`document`] is a page as a tree, with its writers;
//! - [`proof`] follows every hole of a plan through its transitions at worst;
//! - [`job`] is the plan as work of a machine, [`program`] its language, written and read back as [`motion`];
//! - [`audit`] holds a plan that anybody made against all of it;
//! - [`cases`] are questions of every kind with what is expected of the answers;
//! - [`turning`] is a room of its own: a shaft, and the passes that rough it;
//! - [`turning_proof`] carries the stock of a turned part through any program and holds it against the part.
//!
//! Architecture invariant: nothing in this library reads a file, prints or asks the time.

pub use technolog_audit as audit;
pub use technolog_cases as cases;
pub use technolog_core::{ascii, error, machine, material, motion, note, parallel, part, plan, reason, shop, zone};
pub use technolog_cutting as cutting;
pub use technolog_document as document;
pub use technolog_holes::{planner, route, sequence, setup, tooling};
pub use technolog_job as job;
pub use technolog_knowledge::{self as knowledge, units};
pub use technolog_nc::program;
pub use technolog_pages as report;
pub use technolog_proof as proof;
pub use technolog_shipped as shipped;
pub use technolog_tables as tables;
pub use technolog_turning as turning;
pub use technolog_turning_proof as turning_proof;
pub use technolog_words as words;
