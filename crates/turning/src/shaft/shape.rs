//! The steps of a blank (a forging or casting near the shape of the shaft), held against its cylinder and the shaft.

use crate::knowledge::diagnostic::Place;
use crate::turning::reading::{Placed, Reader, mistake};
use crate::units::Micrometres;

use super::BlankKind;
use super::read::PlacedStep;

/// The steps of a blank and where they stand in the file.
pub(crate) struct Shape {
    pub(crate) steps: Vec<PlacedStep>,
    pub(crate) place: Place,
}

/// Every step of the blank against the one before, and against the cylinder around the blank; every step of the shaft
/// against the blank where it begins, which is where the blank over it is thinnest.
pub(crate) fn check(
    shape: &Shape,
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
