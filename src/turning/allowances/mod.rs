//! What is left for finishing, and the rough contour that leaves it (lecture 12.2).

pub mod equidistant;
mod read_back;
mod union;

pub use equidistant::{EquidistantError, Over, equidistant, equidistant_over};
