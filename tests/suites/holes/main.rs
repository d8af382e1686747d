//! Parts with holes: reading them, routes, cutting conditions, order, whole plans.

#![allow(clippy::disallowed_methods, reason = "tests hold the codes of notes against what is expected")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "clippy allows it in tests, but not in the functions they share"
)]

mod bad_parts;
mod bored;
mod cells;
mod chains;
mod cutting;
mod every_hole;
mod extremes;
mod floors;
mod given;
mod laws;
mod located;
mod many_holes;
mod mistakes;
mod order;
mod part_fuzz;
mod parts;
mod plan_figures;
mod practice;
mod proof;
mod published;
mod red_pencil;
mod refusals;
mod round;
mod route_laws;
mod schools;
mod scrap;
mod set_up;
mod torque;
