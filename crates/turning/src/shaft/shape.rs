//! Compares the steps of a blank (a forging or casting near the shape of the shaft) with its cylinder and with the
//! shaft.

use crate::knowledge::diagnostic::Place;
use crate::turning::reading::{Placed, Reader, mistake};
use crate::units::Micrometres;

use super::read::PlacedStep;
use super::{BlankKind, Step};

/// The steps of a blank and their place in the file.
pub(crate) struct BlankShape {
    pub(crate) steps: Vec<PlacedStep>,
    pub(crate) place: Place,
}

impl BlankShape {
    /// The steps, if all of them could be read.
    pub(crate) fn whole(self) -> Option<Vec<Step>> {
        self.steps.into_iter().map(PlacedStep::whole).collect()
    }
}

/// Compares every step of the blank with the one before it and with the cylinder around the blank, and every step of
/// the shaft with the blank where the step begins, because the blank over it is thinnest there.
pub(crate) fn check(
    shape: &BlankShape,
    kind: Option<BlankKind>,
    steps: &[PlacedStep],
    around: Option<&Placed<Micrometres>>,
    length: Option<&Placed<Micrometres>>,
    reader: &mut Reader<'_>,
) {
    if kind == Some(BlankKind::Bar) {
        reader.fault::<()>(mistake!("bar-with-steps"), &shape.place);
    }
    let mut before = Micrometres::ZERO;
    let mut ends: Vec<(Micrometres, Micrometres)> = Vec::new();
    let mut end = Micrometres::ZERO;
    for (index, step) in shape.steps.iter().enumerate() {
        let (Some((diameter, place)), Some((long, _))) = (&step.diameter, &step.length) else { return };
        let number = index + 1;
        if *diameter < before {
            reader.fault::<()>(
                mistake!("blank-step-rises-to-the-free-end", step = number, diameter = diameter, before = before),
                place,
            );
        }
        if let Some((around, _)) = around.filter(|(around, _)| diameter > around) {
            reader.fault::<()>(
                mistake!("blank-step-beyond-blank", step = number, diameter = diameter, blank = around),
                place,
            );
        }
        before = before.max(*diameter);
        end = end + *long;
        ends.push((end, *diameter));
    }
    if let Some((length, _)) = length.filter(|(length, _)| end > *length) {
        reader.fault::<()>(mistake!("steps-beyond-blank", sum = end, blank = length), &shape.place);
    }
    let mut from = Micrometres::ZERO;
    for (index, step) in steps.iter().enumerate() {
        let (Some((diameter, place)), Some((long, _))) = (&step.diameter, &step.length) else { return };
        let over = ends.iter().find(|(end, _)| from < *end).map(|(_, over)| *over);
        if let Some(over) = over.filter(|over| diameter > over) {
            reader
                .fault::<()>(mistake!("step-beyond-blank", step = index + 1, diameter = diameter, blank = over), place);
        }
        from = from + *long;
    }
}
