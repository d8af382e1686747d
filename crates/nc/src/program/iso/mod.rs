//! The controls of ISO 6983 (G and M words), each by its record: reads, runs and writes their programs.
//! docs/control-linuxcnc.md and the pages of the others say which part of their languages is implemented.
//!
//! - `control` the language as data, from the tables iso-… and control-… of catalogs/controls;
//! - `text` words and blocks with their places; `programs` subprograms and calls; `owords` branches and loops; `words` the
//!   words of a block by their groups;
//! - `block`, `moves`, `arc`, `cycles`, `threads`, `zeros`, `kept` one block: the steps it makes; `left_over` what it relies on and the program has
//!   not set; `state` the state kept between blocks;
//! - `run` the execution of the blocks; `values` the parameters of a run; `rules` all rules;
//! - `writer` writes a job as a program.
//!
//! Where the controls differ, their records and tables say so; no code knows a control by its name.

mod arc;
mod block;
mod control;
mod cycles;
mod kept;
mod left_over;
mod moves;
mod owords;
mod programs;
mod radius;
mod rules;
mod run;
mod state;
mod text;
mod threads;
mod values;
mod words;
mod writer;
mod zeros;

pub use control::Control;
pub use run::check_within;
pub use text::MOST_BLOCKS;
pub use writer::write;
