//! `technolog`: a knowledge base and rule engine for machining process planning.
//!
//! The way of the data, once, left to right:
//! `part.yaml → part → route → tooling → cutting → setup → sequence → Plan → (program | report | audit)`.
//!
//! - [`knowledge`] and [`units`] are the tables, the queries that say why, and the exact quantities;
//! - [`shipped`] is the knowledge the program carries in itself.

pub use technolog_knowledge as knowledge;
pub use technolog_knowledge::units;

pub mod shipped;
