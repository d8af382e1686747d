//! Turning: what stands over a stepped shaft, and in which passes it is roughed away.
//!
//! - [`shaft`] is the file of a shaft: what it says, and every mistake of it at once;
//! - [`workpiece`] is the same for a part of any contour, and reads either form of the file;
//! - [`length`] is the exact length of this room, in halves of a micrometre, because half of a diameter is one;
//! - [`contour`] is a section of lines and arcs, [`point`] its points, [`way`] the way of a tool along it;
//! - [`levels`] splits the stock over a shaft into levels, [`schemes`] clears them in the ways of the lecture;
//! - [`passes`] finds the shortest sequence of longitudinal and transverse passes (docs/turning.md).
//!
//! Sources: "the paper" is the article on structural optimisation of multi-pass rough turning, "the lecture" is lecture
//! 12 on turning on NC lathes.

pub mod contour;
pub mod length;
pub mod levels;
pub mod passes;
pub mod point;
mod reading;
pub mod schemes;
pub mod shaft;
pub mod way;
pub mod workpiece;
