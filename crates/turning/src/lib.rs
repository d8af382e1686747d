//! Turning: planning of the operations, tools and programs that turn a shaft or a part of any contour.
//!
//! - [`workpiece`] reads the file of a part and reports all its mistakes at once;
//! - [`shaft`] is a stepped one as the paper has it;
//! - [`length`] is the exact length of this crate, in halves of a micrometre, because half of a diameter is one;
//! - [`contour`] is a section of lines and arcs, [`point`] its points, [`toolpath`] the motions of a tool along it;
//! - [`schemes`] clears the levels over a shaft by the schemes of the lecture;
//! - [`elements`] separates main elements from additional ones, [`allowances`] makes the rough contour, [`zones`]
//!   divides the stock and decides from which end it is turned;
//! - [`tooling`] is lathes and turning tools, [`cutting`] their depths of cut and cutting conditions
//!   (docs/turning-tools.md);
//! - [`transitions`] clears a zone of any shape by the lecture's seven schemes of passes;
//! - [`nose`] offsets a contour for the reference point of a tool with a round nose;
//! - [`operation`] runs all of these in order, and [`jobs`] is the work of its tools;
//! - [`program`] writes toolpaths and contours as programs of controls (docs/turning-programs.md);
//! - [`passes`] finds the shortest sequence of longitudinal and transverse passes (docs/turning.md);
//! - [`ways`] has all ways of roughing a stepped shaft in one table, and the one to take.
//!
//! Sources: "the paper" is the article on structural optimisation of multi-pass rough turning, "the lecture" is lecture
//! 12 on turning on NC lathes.

pub mod allowances;
pub mod contour;
pub mod cutting;
pub mod elements;
pub mod jobs;
pub mod length;
pub mod nose;
pub mod numbering;
pub mod operation;
pub mod passes;
pub mod point;
pub mod program;
mod reading;
mod reasons;
pub mod schemes;
pub mod shaft;
pub mod tooling;
pub mod toolpath;
pub mod transitions;
pub mod ways;
pub mod workpiece;
pub mod zones;

// The types of this crate and of others, under the names that the whole program uses.
use crate as turning;
use technolog_core::{error, material, note, practice_speed, reason, tapping};
use technolog_knowledge::{self as knowledge, units};
#[cfg(test)]
use technolog_shipped as shipped;
use technolog_tables as tables;
