//! Reports: functions of a plan. They decide nothing.

pub mod audit;
pub mod backplot;
mod canvas;
pub mod cycles;
pub mod encoding;
pub mod grid;
mod lang;
pub mod mistakes;
pub mod sentences;
pub mod svg;
mod transitions;
pub mod turning;
mod why;
mod words;

pub mod sheet;

pub use lang::Lang;
pub use sentences::{remedy, sentence};
pub use why::explain;
pub use words::{operation_named, operation_noun, operation_verb};
