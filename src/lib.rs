//! `technolog`: a knowledge base and rule engine for machining process planning.
//!
//! This library re-exports the crates of `crates/` under one name each and has no code of its own. The flow of data,
//! from left to right: `part.yaml → part → route → tooling → cutting → setup → sequence → Plan → (program | report |
//! audit)`.
//!
//! - [`knowledge`] and [`units`] are the tables, the queries with reasons, and the exact quantities;
//! - [`shipped`] is the knowledge base inside the program;
//! - [`part`] is what is to be made, [`shop`] what it is made with ([`machine`], [`material`], [`zone`]);
//! - [`route`], [`tooling`], [`cutting`], [`setup`] and [`sequence`] each add their part;
//! - [`planner`] is the only room that tries the next alternative after a refusal;
//! - [`plan`] is the result, a value; [`report`] prints it; [`document`] is a page as a tree, with its writers,
//!   [`office`] those for Word and spreadsheets;
//! - [`proof`] simulates every hole of a plan through its transitions in the worst case;
//! - [`job`] is the plan as work of a machine, [`program`] the languages of controls, written and read back as
//!   [`motion`];
//! - [`audit`] checks a plan of any author;
//! - [`cases`] are questions of every kind with their expected answers;
//! - [`turning`] plans turned parts: a shaft, and the passes that rough it;
//! - [`turning_proof`] simulates the in-process stock of a turned part through any program and compares the result
//!   with the part.
//!
//! Architecture invariant: nothing in this library reads a file, prints or reads the clock.

pub use technolog_audit as audit;
pub use technolog_cases as cases;
pub use technolog_core::{ascii, error, machine, material, motion, note, parallel, part, plan, reason, shop, zone};
pub use technolog_cutting as cutting;
pub use technolog_document as document;
pub use technolog_holes::{planner, route, sequence, setup, tooling};
pub use technolog_job as job;
pub use technolog_knowledge::{self as knowledge, units};
pub use technolog_nc::program;
pub use technolog_office as office;
pub use technolog_pages as report;
pub use technolog_proof as proof;
pub use technolog_sheets as sheets;
pub use technolog_shipped as shipped;
pub use technolog_tables as tables;
pub use technolog_turning as turning;
pub use technolog_turning_proof as turning_proof;
pub use technolog_words as words;
