//! The short form: `steps:` of a part, and those of a blank, compared with each other and with the blank.

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::Node;
use crate::turning::contour::{Contour, Piece, Profile, Side, Surface, SurfaceKind, SurfaceName};
use crate::turning::length::Half;
use crate::turning::passes::grid::{MOST_STATES, states};
use crate::turning::reading::{Placed, Reader, mistake};
use crate::turning::shaft::{Shaft, Step};
use crate::units::Micrometres;

use super::blank::corners;
use super::file;

/// Steps, as far as they could be read.
pub(super) struct PlacedSteps {
    all: Vec<PlacedStep>,
    place: Place,
}

struct PlacedStep {
    diameter: Option<Placed<Micrometres>>,
    length: Option<Placed<Micrometres>>,
}

impl PlacedSteps {
    /// The steps, if all of them could be read.
    pub(super) fn whole(&self) -> Option<Vec<Step>> {
        let step = |one: &PlacedStep| Some(Step { diameter: one.diameter.as_ref()?.0, length: one.length.as_ref()?.0 });
        self.all.iter().map(step).collect()
    }

    /// Z of the beginning and end of each, and its diameter, up to the first that could not be read.
    fn along_the_axis(&self) -> impl Iterator<Item = (Micrometres, Micrometres, &Placed<Micrometres>)> {
        let mut end = Micrometres::ZERO;
        self.all.iter().map_while(move |one| {
            let from = end;
            end = end + one.length.as_ref()?.0;
            Some((from, end, one.diameter.as_ref()?))
        })
    }
}

impl Reader<'_> {
    pub(super) fn steps(&mut self, node: &Node) -> Option<PlacedSteps> {
        let nodes = self.problems.list(node)?;
        if nodes.is_empty() {
            self.fault::<()>(mistake!("no-steps"), &node.place);
        }
        let mut all = Vec::new();
        for node in nodes {
            let Some(mut fields) = self.problems.map(node) else { continue };
            let diameter = self.need(&mut fields, file::Step::diameter);
            let length = self.need(&mut fields, file::Step::length);
            fields.finish(&mut self.problems);
            all.push(PlacedStep { diameter, length });
        }
        Some(PlacedSteps { all, place: node.place.clone() })
    }

    /// Compares every step of the part with the one before it and with the cylinder around the blank.
    pub(super) fn check_steps(
        &mut self,
        steps: &PlacedSteps,
        blank_diameter: Option<&Placed<Micrometres>>,
        blank_length: Option<&Placed<Micrometres>>,
    ) {
        let mut largest: Option<(Micrometres, usize)> = None;
        for (number, step) in (1..).zip(&steps.all) {
            let Some((diameter, place)) = &step.diameter else { continue };
            self.beyond("step-beyond-blank", number, (*diameter, place), blank_diameter.map(|(blank, _)| *blank));
            match largest {
                Some((before, other)) if *diameter < before => {
                    let code = "step-rises-to-the-free-end";
                    self.fault::<()>(
                        mistake!(code, step = number, diameter = diameter, before = before, other = other),
                        place,
                    );
                }
                _ => largest = Some((*diameter, number)),
            }
        }
        // Only the first step beyond the end of the blank is reported; those after it are beyond it too.
        let Some((blank, _)) = blank_length else { return };
        let mut sum = Micrometres::ZERO;
        for step in &steps.all {
            let Some((length, place)) = &step.length else { return };
            sum = sum + *length;
            if sum > *blank {
                let all: Option<Micrometres> =
                    steps.all.iter().map(|step| step.length.as_ref().map(|(it, _)| *it)).sum();
                self.fault::<()>(mistake!("steps-beyond-blank", sum = all.unwrap_or(sum), blank = blank), place);
                return;
            }
        }
    }

    /// Compares every step of the blank with the one before it and with the cylinder around the blank.
    pub(super) fn check_blank_steps(
        &mut self,
        shape: &PlacedSteps,
        around: Option<&Placed<Micrometres>>,
        length: Option<&Placed<Micrometres>>,
    ) {
        let (mut before, mut last) = (Micrometres::ZERO, Micrometres::ZERO);
        for (number, (_, end, (diameter, place))) in (1..).zip(shape.along_the_axis()) {
            if *diameter < before {
                let code = "blank-step-rises-to-the-free-end";
                self.fault::<()>(mistake!(code, step = number, diameter = diameter, before = before), place);
            }
            self.beyond("blank-step-beyond-blank", number, (*diameter, place), around.map(|(around, _)| *around));
            (before, last) = (before.max(*diameter), end);
        }
        if let Some((length, _)) = length.filter(|(length, _)| last > *length) {
            self.fault::<()>(mistake!("steps-beyond-blank", sum = last, blank = length), &shape.place);
        }
    }

    /// Compares every step of the part with the step of the blank where it begins, because the blank over it is thinnest there.
    pub(super) fn check_under_blank(&mut self, steps: &PlacedSteps, shape: &PlacedSteps) {
        for (number, (from, _, (diameter, place))) in (1..).zip(steps.along_the_axis()) {
            let over = shape.along_the_axis().find(|(_, end, _)| from < *end).map(|(_, _, (over, _))| *over);
            self.beyond("step-beyond-blank", number, (*diameter, place), over);
        }
    }

    fn beyond(
        &mut self,
        code: &'static str,
        step: usize,
        (diameter, place): (Micrometres, &Place),
        blank: Option<Micrometres>,
    ) {
        if let Some(blank) = blank.filter(|blank| diameter > *blank) {
            self.fault::<()>(mistake!(code, step = step, diameter = diameter, blank = blank), place);
        }
    }

    /// Whether there are few enough levels and slices to search.
    pub(super) fn check_grid(&mut self, shaft: &Shaft, place: &Place) {
        let states = states(shaft);
        if states > MOST_STATES {
            self.fault::<()>(mistake!("grid-too-fine", states = states, most = MOST_STATES), place);
        }
    }
}

/// The outside of a stepped shaft. Steps of one diameter are one cylinder.
pub(super) fn outer(steps: &[Step]) -> Profile {
    let mut surfaces: Vec<Surface> = Vec::new();
    for piece in Contour::through(Side::Outer, &corners(Half::ZERO, steps)).pieces {
        let kind = if piece.is_face() { SurfaceKind::Face } else { SurfaceKind::Cylinder };
        if let Some(last) = surfaces.last_mut().filter(|last| last.kind == kind) {
            if let Some(before) = last.pieces.first_mut() {
                *before = Piece::line(before.from, piece.to);
            }
            continue;
        }
        let name = SurfaceName::Place(Side::Outer, surfaces.len() + 1);
        surfaces.push(Surface::plain(name, kind, vec![piece]));
    }
    Profile { side: Side::Outer, surfaces }
}
