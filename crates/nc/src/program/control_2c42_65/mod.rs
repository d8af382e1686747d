//! The control 2С42-65 (textbook section 3): reads and runs its programs. docs/control-2c42-65.md describes the
//! language as it is implemented here, what is reconstructed, and both readings where the text contradicts itself.
//!
//! - `control` the language as data, from catalogs/controls;
//! - `text` words and blocks with their places; `check` checks without running;
//! - `words`, `block`, `moves`, `cycles`, `correction`, `travel` one block: its words, and the steps it makes; `left_over`
//!   what it relies on and the program has not set;
//! - `state` the state kept between blocks; `run` the execution of blocks, calls and repeats;
//! - `rules` every rule with its section.

mod block;
mod check;
mod control;
mod correction;
mod cycles;
mod left_over;
mod moves;
mod rules;
mod run;
mod state;
mod text;
mod travel;
mod words;
mod writer;

pub use control::Control;
pub use run::{check_within, without_machine};
pub(super) use text::{comma_places, decimal_comma, latin};
pub use writer::write;
