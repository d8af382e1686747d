//! Row types of turning: the rules and tables that only turned parts ask.

pub mod jobs;
pub mod part;
pub mod passes;
pub mod tools;
