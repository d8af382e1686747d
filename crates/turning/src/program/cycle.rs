//! The stock over a contour as one roughing cycle of a control: the task, whether a cycle can do it, and the profile
//! for the control.

use crate::turning::contour::{Contour, Piece, Side};
use crate::turning::length::Half;
use crate::turning::point::Point;

use super::refused::{NotWritten, check_arc};

pub use crate::tables::controls::lathe::Direction;

/// How far an arc may go back beyond its ends, 1 µm: they are rounded to half a micrometre along both axes.
const SLACK: Half = Half::new(2);

/// The parameters of a roughing cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Roughing {
    /// The direction of its passes.
    pub direction: Direction,
    /// The depth of a pass, on the radius or along Z, above 0.
    pub depth: Half,
    /// The distance from the blank where it begins, above 0.
    pub clearance: Half,
    /// The retract after a pass along each axis; above 0, at most the clearance.
    pub retract: Half,
    /// The allowance that it leaves over the contour; zero if the contour is the rough one.
    pub allowance: Allowance,
}

/// The allowance of a cycle over the contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Allowance {
    /// On the radius, not below 0.
    pub radius: Half,
    /// Along Z, not below 0.
    pub z: Half,
}

/// A file of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgramFile {
    /// Its name on the control.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// The call of a cycle, and the contour that it reads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct CycleCall {
    /// Lines required before the call: a subprogram of the same file.
    pub before: String,
    /// The lines of the call.
    pub call: String,
    /// The contour in a separate file, if the control requires that.
    pub file: Option<ProgramFile>,
}

/// A program with a cycle: the main program, and its subprograms if the control has them in separate files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CycleProgram {
    /// The main program first.
    pub files: Vec<ProgramFile>,
}

/// A checked task: a contour that the passes can follow, and the corner of the blank before it.
pub(super) struct CycleTask<'a> {
    pub rough: &'a Contour,
    pub corner: Point,
    pub roughing: Roughing,
}

impl<'a> CycleTask<'a> {
    /// Checks a task. The corner is where the face of the blank meets its surface: for an outer contour the radius of
    /// the surface, for a bore that of the hole, and the Z of the free face.
    ///
    /// # Errors
    /// What no cycle can do.
    pub fn new(rough: &'a Contour, corner: Point, roughing: Roughing) -> Result<Self, NotWritten> {
        let (Some(start), Some(end)) = (rough.start(), rough.end()) else { return Err(NotWritten::EmptyContour) };
        for (number, piece) in (1..).zip(&rough.pieces) {
            check_arc(*piece, number)?;
        }
        if let Some(at) = rough.pieces.windows(2).position(|two| matches!(two, [one, next] if one.to != next.from)) {
            return Err(NotWritten::Apart { piece: at + 2 });
        }
        check_roughing(roughing)?;
        check_monotone(rough, roughing.direction)?;
        check_blank(rough, corner)?;
        let clearance = roughing.clearance;
        if rough.side == Side::Inner && corner.radius < clearance {
            return Err(NotWritten::BoreTooNarrow { bore: corner.radius, clearance });
        }
        if start.radius == corner.radius || end.z == corner.z {
            return Err(NotWritten::NothingToCut);
        }
        Ok(Self { rough, corner, roughing })
    }

    /// The profile in the direction of the work: from beside the blank, along the contour, out to the surface of the
    /// blank. `before` and `beyond` are how far outside the blank it begins and ends.
    pub fn profile(&self, before: Half, beyond: Half) -> Vec<Piece> {
        let ends = (self.rough.start(), self.rough.end());
        let (Some(start), Some(end)) = ends else { return Vec::new() };
        let corner = self.corner;
        let outwards = |by: Half| match self.rough.side {
            Side::Outer => corner.radius + by,
            Side::Inner => corner.radius - by,
        };
        let mut pieces = Vec::new();
        match self.roughing.direction {
            Direction::Longitudinal => {
                pieces.push(Piece::line(Point::new(start.radius, corner.z - before), start));
                pieces.extend(&self.rough.pieces);
                pieces.push(Piece::line(end, Point::new(outwards(beyond), end.z)));
            }
            Direction::Facing => {
                pieces.push(Piece::line(Point::new(outwards(before), end.z), end));
                pieces.extend(self.rough.pieces.iter().rev().map(|piece| piece.reversed()));
                pieces.push(Piece::line(start, Point::new(start.radius, corner.z - beyond)));
            }
        }
        pieces.retain(|piece| !piece.is_nothing());
        pieces
    }

    /// The start point of the cycle: at the corner of the blank, by the clearance away from it in the direction from
    /// which the passes come, and on the surface in the other direction.
    pub fn begins(&self) -> Point {
        let Point { radius, z } = self.corner;
        let clearance = self.roughing.clearance;
        match (self.roughing.direction, self.rough.side) {
            (Direction::Longitudinal, _) => Point::new(radius, z - clearance),
            (Direction::Facing, Side::Outer) => Point::new(radius + clearance, z),
            (Direction::Facing, Side::Inner) => Point::new(radius - clearance, z),
        }
    }
}

fn check_roughing(roughing: Roughing) -> Result<(), NotWritten> {
    let Roughing { depth, clearance, retract, allowance, .. } = roughing;
    for (name, length) in [("depth", depth), ("clearance", clearance), ("retract", retract)] {
        if length <= Half::ZERO {
            return Err(NotWritten::NotAboveZero { key: name });
        }
    }
    if retract > clearance {
        return Err(NotWritten::RetractBeyondClearance { retract, clearance });
    }
    if allowance.radius < Half::ZERO || allowance.z < Half::ZERO {
        return Err(NotWritten::NotAboveZero { key: "allowance" });
    }
    Ok(())
}

/// Whether passes of that direction meet each piece once: no piece runs back along the axis or, for passes across the
/// axis, back towards it (in a bore away from it).
fn check_monotone(rough: &Contour, direction: Direction) -> Result<(), NotWritten> {
    let along = |point: Point| match (direction, rough.side) {
        (Direction::Longitudinal, _) => point.z,
        (Direction::Facing, Side::Outer) => point.radius,
        (Direction::Facing, Side::Inner) => Half::ZERO - point.radius,
    };
    let forward = |piece: &Piece| {
        let (from, to) = (along(piece.from), along(piece.to));
        let reach = from - SLACK..=to + SLACK;
        from <= to && piece.extremes().into_iter().all(|point| reach.contains(&along(point)))
    };
    match rough.pieces.iter().position(|piece| !forward(piece)) {
        Some(at) if direction == Direction::Longitudinal => Err(NotWritten::TurnsBack { piece: at + 1 }),
        Some(at) => Err(NotWritten::Falls { piece: at + 1 }),
        None => Ok(()),
    }
}

fn check_blank(rough: &Contour, corner: Point) -> Result<(), NotWritten> {
    let Some((least, most)) = rough.radii() else { return Err(NotWritten::EmptyContour) };
    let beyond = match rough.side {
        Side::Outer => Some(most).filter(|most| *most > corner.radius),
        Side::Inner => Some(least).filter(|least| *least < corner.radius),
    };
    if let Some(contour) = beyond {
        return Err(NotWritten::BeyondBlank { blank: corner.radius, diameter: contour });
    }
    if rough.start().is_some_and(|start| start.z < corner.z) {
        return Err(NotWritten::BeforeFace);
    }
    Ok(())
}
