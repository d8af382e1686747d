//! The steps of a blank (a forging or casting near the shape of the shaft), held against its cylinder and the shaft.

use crate::note::Tell;

use crate::knowledge::diagnostic::Place;
use crate::turning::reading::{Placed, Reader};
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
        reader.fault::<()>("bar-with-steps", &[], &shape.place);
    }
    let mut before = Micrometres::ZERO;
    let mut ends: Vec<(Micrometres, Micrometres)> = Vec::new();
    let mut end = Micrometres::ZERO;
    for (index, step) in shape.steps.iter().enumerate() {
        let (Some((diameter, place)), Some((long, _))) = (&step.diameter, &step.length) else { return };
        let number = index + 1;
        if *diameter < before {
            let figures: [(&str, &dyn Tell); 3] = [("step", &number), ("diameter", diameter), ("before", &before)];
            reader.fault::<()>("blank-step-rises-to-the-free-end", &figures, place);
        }
        if let Some((around, _)) = around.filter(|(around, _)| diameter > around) {
            let figures: [(&str, &dyn Tell); 3] = [("step", &number), ("diameter", diameter), ("blank", around)];
            reader.fault::<()>("blank-step-beyond-blank", &figures, place);
        }
        before = before.max(*diameter);
        end = end + *long;
        ends.push((end, *diameter));
    }
    if let Some((length, _)) = length.filter(|(length, _)| end > *length) {
        reader.fault::<()>("steps-beyond-blank", &[("sum", &end), ("blank", length)], &shape.place);
    }
    let mut from = Micrometres::ZERO;
    for (index, step) in steps.iter().enumerate() {
        let (Some((diameter, place)), Some((long, _))) = (&step.diameter, &step.length) else { return };
        let over = ends.iter().find(|(end, _)| from < *end).map(|(_, over)| *over);
        if let Some(over) = over.filter(|over| diameter > over) {
            let figures: [(&str, &dyn Tell); 3] = [("step", &(index + 1)), ("diameter", diameter), ("blank", &over)];
            reader.fault::<()>("step-beyond-blank", &figures, place);
        }
        from = from + *long;
    }
}
