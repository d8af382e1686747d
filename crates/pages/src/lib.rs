//! Pages: functions of a plan. They make no decisions.

pub mod audit;
pub mod backplot;
mod canvas;
pub mod cycles;
mod doubts;
pub mod encoding;
pub mod laboratory;
mod named;
pub mod order;
pub mod order_drawing;
pub mod setting;
mod transitions;
pub mod turning;
mod why;

pub mod sheet;

pub use doubts::{Doubts, is_of_row};
pub use named::named;
pub use technolog_core::lang::Lang;
pub use technolog_core::words::{operation_named, operation_noun, operation_verb, unit, with_unit};
pub use why::explain;

// The types of this crate and of others, under one name each in the whole program; `audit` and `turning` are rooms of
// pages here.
use crate as report;
use technolog_core::{demand, error, machine, material, motion, note, part, plan, zone};
use technolog_document as document;
use technolog_knowledge::{self as knowledge, units};
use technolog_nc::{job, program};
use technolog_tables as tables;
use technolog_words as words;
