//! Reads lathe programs: LinuxCNC, Fanuc (0i-TF, system A) and Sinumerik. docs/lathe-programs-read.md says which part
//! of the three languages is read. Nothing here is shared with the code that writes such programs.
//!
//! - `control` the language as data, from the tables lathe-functions and lathe-read-cycles;
//! - `text` blocks with their places, `words` the words of a block;
//! - `block` one block and the motions it makes, `state` the state kept between blocks;
//! - `contour` elements of contours and the frame of passes, `roughing` passes over them, `cycles` the cycles that
//!   make passes over a contour, `threads` those that cut threads, `tapping` those that drive a tap;
//! - `corners` chamfers and roundings between two lines, `pecks` cycles that go in step by step;
//! - `recognise` whether a text is certainly a program of a lathe;
//! - `offsets` those that two tools share; `run` the execution of the blocks; `motion` the result; `time` its duration; `rules` all rules.

mod block;
mod contour;
mod control;
mod corners;
mod cycles;
mod motion;
mod offsets;
mod pecks;
mod recognise;
mod roughing;
mod rules;
mod run;
mod siemens;
mod state;
mod tapping;
#[cfg(test)]
mod tests;
mod text;
mod threads;
mod time;
pub mod trace;
mod words;

pub use crate::tables::controls::lathe_reading::LatheReader;
pub use control::LatheLanguage;
pub use motion::{LatheAct, LatheFeed, LatheModes, LatheMotion, LathePlace, LathePoint, LatheSpeed, LatheTool};
pub use recognise::recognised;
pub use run::{LatheRun, Subprogram, read};
pub use time::{LatheRates, LatheTimes, times};

use super::{Fault, expression};

/// Whether a program with this fault must not be run on a machine.
pub fn is_serious(fault: &Fault) -> bool {
    matches!(fault.severity, crate::note::Severity::Error | crate::note::Severity::Wrong)
}
