//! Toolpaths of turning tools: lines and arcs of the theoretical point, each with its purpose. Transitions make them;
//! programs, drawings and times use them.
//!
//! Architecture invariant: a toolpath does not depend on any control.

use serde::Serialize;

use super::contour::{Curve, Piece};
use super::length::Half;
use super::point::Point;
use crate::units::MillimetresPerRev;

/// The purpose of a move. It decides the rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Purpose {
    /// Through air, as fast as the axes move.
    Rapid,
    /// A straight working pass, at the main feed.
    Cut,
    /// Straight into the metal, towards the contour, at the infeed rate.
    Infeed,
    /// Along the contour, cutting the ridges that passes left, at the feed of pick-up.
    PickUp,
    /// Along the whole contour after the passes, at the feed of the semi-finishing pass.
    SemiFinish,
    /// Along the contour at the feed of finishing.
    Finish,
    /// At a feed, but not through metal: along a finished contour, or off it.
    Return,
    /// Straight into the metal with the whole edge: a blade, a drill.
    Plunge,
    /// Along a thread: its feed is the pitch, synchronised with the spindle.
    Thread,
}

/// A move.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Move {
    /// Its end.
    pub to: Point,
    /// Its curve; a rapid is a line.
    pub curve: Curve,
    /// Its purpose.
    pub purpose: Purpose,
    /// The feed of this move, where it is not that of its purpose.
    #[serde(rename = "feed_mm_per_rev", skip_serializing_if = "Option::is_none")]
    pub feed: Option<MillimetresPerRev>,
}

impl Move {
    /// A move along a piece at the feed of its purpose.
    pub const fn along(piece: Piece, purpose: Purpose) -> Self {
        Self { to: piece.to, curve: piece.curve, purpose, feed: None }
    }
}

/// A toolpath: a start point and the moves from there.
#[derive(Clone, Debug, PartialEq, Default, Serialize)]
pub struct Toolpath {
    /// Where it begins.
    pub from: Point,
    /// Its moves.
    pub moves: Vec<Move>,
}

impl Toolpath {
    /// An empty toolpath at a point.
    pub const fn at(from: Point) -> Self {
        Self { from, moves: Vec::new() }
    }

    /// Where it ends.
    pub fn end(&self) -> Point {
        self.moves.last().map_or(self.from, |last| last.to)
    }

    /// Adds a straight move to a point. A move without length is left out.
    pub fn go(&mut self, to: Point, purpose: Purpose) {
        if to != self.end() {
            self.moves.push(Move { to, curve: Curve::Line, purpose, feed: None });
        }
    }

    /// Follows a piece, which begins where the toolpath ends.
    pub fn follow(&mut self, piece: Piece, purpose: Purpose) {
        if !piece.is_nothing() {
            self.moves.push(Move::along(piece, purpose));
        }
    }

    /// Inside out: from a bore to an outer contour, or back; radii count inwards from `top`.
    #[must_use]
    pub fn inside_out(&self, top: Half) -> Self {
        let moves = self.pieces().map(|(piece, purpose)| Move::along(piece.inside_out(top), purpose));
        Self { from: self.from.inside_out(top), moves: moves.collect() }
    }

    /// Its moves as pieces, each with its purpose and, where it has one, its own feed.
    pub fn paced(&self) -> impl Iterator<Item = (Piece, Purpose, Option<MillimetresPerRev>)> + '_ {
        self.pieces().zip(&self.moves).map(|((piece, purpose), one)| (piece, purpose, one.feed))
    }

    /// Its moves as pieces, each with its purpose.
    pub fn pieces(&self) -> impl Iterator<Item = (Piece, Purpose)> + '_ {
        let starts = std::iter::once(self.from).chain(self.moves.iter().map(|one| one.to));
        starts.zip(&self.moves).map(|(from, one)| (Piece { from, to: one.to, curve: one.curve }, one.purpose))
    }
}
