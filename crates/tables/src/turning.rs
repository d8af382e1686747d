//! Row types of turning: the rules and tables used only for turned parts.

pub mod jobs;
pub mod part;
pub mod passes;
pub mod tools;
