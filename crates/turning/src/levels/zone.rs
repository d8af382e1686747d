//! The rough zone of a stepped shaft: the stock over each cylinder, and which cylinders form a section.
//!
//! The blank may be stepped too. Then the zone is divided into sections, each under one diameter of the blank (lecture,
//! fig. 12.10), and the schemes work one section after the other from the free end.

use crate::turning::length::Half;
use crate::turning::shaft::Shaft;

/// A cylinder of the rough contour under one diameter of the blank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cylinder {
    /// Z of its beginning, from the free end towards the chuck.
    pub from: Half,
    /// Z of its end: the vertical there.
    pub to: Half,
    /// Its radius after roughing.
    pub radius: Half,
    /// Radius of the top of the face at its end, if there is a face: a shoulder of the rough contour, or the bar in the
    /// chuck after the last cylinder.
    pub wall: Option<Half>,
}

/// Neighbouring cylinders with stock under one diameter of the blank.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ZoneSection {
    /// Radius of the blank.
    pub blank: Half,
    /// The cylinders from the free end, each larger than the one before.
    pub cylinders: Vec<Cylinder>,
}

impl ZoneSection {
    /// Z of its beginning.
    pub fn from(&self) -> Half {
        self.cylinders.first().map_or(Half::ZERO, |first| first.from)
    }

    /// The stock over a cylinder, tᵢ (radial).
    pub fn stock(&self, cylinder: &Cylinder) -> Half {
        self.blank - cylinder.radius
    }
}

/// The sections of a shaft that have stock, from the free end.
pub fn sections(shaft: &Shaft) -> Vec<ZoneSection> {
    let cells = cells(shaft);
    let mut sections: Vec<ZoneSection> = Vec::new();
    let mut before: Option<Half> = None;
    for (index, cell) in cells.iter().enumerate() {
        let next = cells.get(index + 1).map(|next| next.radius);
        let wall = next.or_else(|| bar_beyond(shaft)).filter(|radius| *radius > cell.radius);
        let cylinder = Cylinder { from: cell.from, to: cell.to, radius: cell.radius, wall };
        if cell.radius < cell.blank {
            match sections.last_mut().filter(|_| before == Some(cell.blank)) {
                Some(section) => section.cylinders.push(cylinder),
                None => sections.push(ZoneSection { blank: cell.blank, cylinders: vec![cylinder] }),
            }
        }
        before = Some(cell.blank);
    }
    sections
}

/// A stretch of the axis with one radius of the part and one of the blank.
struct Cell {
    from: Half,
    to: Half,
    radius: Half,
    blank: Half,
}

/// These stretches from the free end to the end of the steps.
fn cells(shaft: &Shaft) -> Vec<Cell> {
    let mut cells: Vec<Cell> = Vec::new();
    let mut from = Half::ZERO;
    for step in &shaft.steps {
        let end = from + Half::of(step.length);
        let radius = Half::radius_of(step.diameter);
        while from < end {
            let (blank, until) = blank_at(shaft, from);
            let to = until.map_or(end, |until| until.min(end));
            match cells.last_mut() {
                Some(last) if last.radius == radius && last.blank == blank => last.to = to,
                _ => cells.push(Cell { from, to, radius, blank }),
            }
            from = to;
        }
    }
    cells
}

/// The radius of the blank just behind a Z, and Z of the next step of the blank, if there is one.
fn blank_at(shaft: &Shaft, z: Half) -> (Half, Option<Half>) {
    let mut end = Half::ZERO;
    for step in &shaft.blank_steps {
        end = end + Half::of(step.length);
        if z < end {
            return (Half::radius_of(step.diameter), Some(end));
        }
    }
    (Half::radius_of(shaft.blank.diameter), None)
}

/// The radius of the blank behind the last step, if the blank is longer.
fn bar_beyond(shaft: &Shaft) -> Option<Half> {
    let end: Half = shaft.steps.iter().map(|step| Half::of(step.length)).sum();
    (Half::of(shaft.blank.length) > end).then(|| blank_at(shaft, end).0)
}
