//! `technolog`: a knowledge base and rule engine for machining process planning.
//!
//! The way of the data, once, left to right:
//! `part.yaml → part → route → tooling → cutting → setup → sequence → Plan → (program | report | audit)`.
//!
//! - [`knowledge`] and [`units`] are the tables, the queries that say why, and the exact quantities;
//! - [`shipped`] is the knowledge the program carries in itself;
//! - [`part`] is what is to be made, [`shop`] what it is made with ([`machine`], [`material`], [`zone`]);
//! - [`route`], [`tooling`], [`cutting`], [`setup`] and [`sequence`] each add their part;
//! - [`planner`] is the one place where a refusal makes it try the next alternative;
//! - [`plan`] is the result, a value; [`report`] prints it;
//! - [`job`] is the plan as work of a machine, [`program`] its language, written and read back as [`motion`].
//! - [`audit`] holds a plan that anybody made against all of it;
//! - [`cases`] are questions of every kind with what is expected of the answers;
//! - [`turning`] is a room of its own: a shaft, and the passes that rough it.
//!
//! Architecture invariant: nothing in this library reads a file, prints or asks the time.

pub use technolog_knowledge as knowledge;
pub use technolog_knowledge::units;

pub mod audit;
pub mod cases;
pub mod cutting;
pub mod error;
pub mod job;
pub mod machine;
pub mod material;
mod memo;
pub mod motion;
pub mod note;
pub mod parallel;
pub mod part;
pub mod plan;
pub mod planner;
pub mod program;
pub mod report;
pub mod route;
pub mod sequence;
pub mod setup;
pub mod shipped;
pub mod shop;
pub mod tooling;
pub mod turning;
pub mod zone;
