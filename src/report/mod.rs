//! Reports: functions of a plan. They decide nothing.

pub mod grid;
mod lang;

pub use lang::Lang;
