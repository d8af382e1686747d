//! The common types of all rooms; nothing here plans.
//!
//! - [`part`] is what is to be made, [`shop`] what it is made with ([`machine`], [`material`], [`zone`]);
//! - [`tapping`] is the hole under a tapped thread;
//! - [`chip_room`] is what must stay open of a drill's flutes;
//! - [`practice_speed`] is the speed used in shops, for comparison with the formulas;
//! - [`demand`] is what a plan asks of its machine;
//! - [`plan`] is the result of planning, a value; [`motion`] is what programs do;
//! - [`note`] and [`error`] are sentences as data; [`lang`] and [`words`] are the few words that are read as well as
//!   written;
//! - [`memo`] and [`parallel`] serve work on many parts at once.
//!
//! Architecture invariant: nothing here chooses a tool, a figure or an order.

pub mod ascii;
pub mod chip_room;
pub mod demand;
pub mod error;
pub mod lang;
pub mod machine;
pub mod material;
pub mod memo;
pub mod motion;
pub mod note;
pub mod parallel;
pub mod part;
pub mod plan;
pub mod practice_speed;
pub mod reason;
pub mod shelf;
pub mod shop;
pub mod tapping;
pub mod words;
pub mod zone;

// Re-exported, so that paths are the same here as in every later room.
use technolog_knowledge::{self as knowledge, units};
#[cfg(test)]
use technolog_shipped as shipped;
use technolog_tables as tables;
