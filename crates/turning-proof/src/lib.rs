//! The proof of turned parts: stock is a region of the half-plane through the axis. Each tool, with its edges, nose and
//! holder, is swept along the motions of a program, and the result is compared with the finished part.
//!
//! Its input is the motions of a program that was read back; it shares no code with the planner, the writers or their
//! geometry.
//!
//! - `set_up` is the input, `tool` the tools, `stock` the metal, `units` lengths and places;
//! - `plane` has the geometry: convex pieces, what they sweep, regions on a grid;
//! - `target` is the finished part with its allowances; `carry` simulates the motions, `left` examines the remaining
//!   metal;
//! - `sizes` measures diameters and lengths with limits;
//! - `fault` has all faults, as types.
//!
//! Approximations, and their direction:
//!
//! - Arcs and noses are chords at most 0.5 µm inside their circles, regions are on a grid of 10 nm; findings begin at
//!   5 µm.
//! - A tool beyond the axis cuts on this side of it, because the part turns.
//! - The cut of a motion counts as removed for the holder from the beginning of that motion.
//! - A tap removes nothing from the stock: its core must find the hole free, and behind its lead the thread is full.
//! - A size with limits is measured away from the ends of its surface, where noses leave their roundings.
//! - Passes of a thread leave the crests: they are compared with its root, and remove nothing from the stock.
//! - An insert is a triangle of its nose and both edges, a holder the hull of a shank or bar and the ends of the
//!   edges.
//! - A piece that is cut off stays where it was.
//!
//! Architecture invariant: the proof does not use the planner, makes no choices and corrects nothing.

mod carry;
mod fault;
mod left;
mod plane;
mod refused;
mod set_up;
mod sizes;
mod stock;
mod taps;
mod target;
mod threads;
mod tool;
mod units;

// The room below, under the name that the whole program uses.
use technolog_note as note;

use std::collections::{BTreeMap, BTreeSet};

pub use fault::{Fault, What, Whose};
pub use refused::Refused;
pub use set_up::{
    Body, Indexed, IndexedNear, Limits, Motion, MotionKind, Piece, Profile, ProfilePiece, Sense, SetUp, Size,
    TapLimits, Thread,
};
pub use stock::Stock;
pub use tool::{Cutter, Hand, Holder, Side, Tool};
pub use units::{At, Block, CubicMm, Degrees, Mm};

/// Volumes of a set-up, within its range along the axis. Without faults the removed volume is the one to be removed,
/// except for the roundings of noses in corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Volumes {
    /// Of the stock before.
    pub before: CubicMm,
    /// Of the remaining metal.
    pub left: CubicMm,
    /// Of the metal that the motions removed.
    pub removed: CubicMm,
    /// Of the stock over the part with its allowances.
    pub to_remove: CubicMm,
}

/// What the tools of a program cut.
#[derive(Clone, Debug, Default)]
pub struct Cuts {
    /// The deepest straight cut of each insert, by the index of its tool, and its block.
    pub depths: BTreeMap<usize, (Mm, Block)>,
    /// The blocks in which metal is taken off: a feed in air loads no tool.
    pub blocks: BTreeSet<Block>,
}

/// The result of a program for the stock.
#[derive(Clone, Debug)]
pub struct Proof {
    /// The faults.
    pub faults: Vec<Fault>,
    /// The remaining metal: the stock of the next set-up.
    pub left: Stock,
    /// The volumes.
    pub volumes: Volumes,
    /// Its cuts, where they are measured.
    pub cuts: Cuts,
    /// How far from the stock each tool stands as the turret turns.
    pub indexed: Vec<IndexedNear>,
}

/// Simulates the stock of a set-up through its motions.
///
/// # Errors
/// The set-up cannot be proven: it has no contour, a motion names no tool, a figure is out of range.
pub fn prove(set_up: &SetUp) -> Result<Proof, Refused> {
    refused::check(set_up)?;
    let mut carried = carry::Carried::through(set_up);
    left::hold(&mut carried);
    sizes::hold(&mut carried);
    let stretch = carried.target.stretch();
    let volume = |region: &plane::Region| region.within(stretch).turned_volume();
    let (before, left) = (volume(&set_up.stock.0), volume(&carried.stock.0));
    let part = volume(&set_up.stock.0.made(&carried.target.may_stay, plane::Rule::Both));
    let volumes = Volumes {
        before: CubicMm(before),
        left: CubicMm(left),
        removed: CubicMm(before - left),
        to_remove: CubicMm(before - part),
    };
    Ok(Proof {
        faults: carried.faults.all(),
        left: carried.stock,
        volumes,
        cuts: carried.chips,
        indexed: carried.indexed,
    })
}
