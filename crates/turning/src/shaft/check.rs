//! Compares the steps of a shaft file with each other and with the blank.

use crate::knowledge::diagnostic::Place;
use crate::turning::passes::grid::{MOST_STATES, states};
use crate::turning::reading::{Placed, Reader, mistake};
use crate::units::Micrometres;

use super::Shaft;
use super::read::PlacedStep;

/// Compares every step with the one before it and with the blank.
pub(super) fn steps(
    steps: &[PlacedStep],
    blank_diameter: Option<&Placed<Micrometres>>,
    blank_length: Option<&Placed<Micrometres>>,
    reader: &mut Reader<'_>,
) {
    let mut largest: Option<(Micrometres, usize)> = None;
    for (index, step) in steps.iter().enumerate() {
        let Some((diameter, place)) = &step.diameter else { continue };
        let (diameter, number) = (*diameter, index + 1);
        if let Some((blank, _)) = blank_diameter.filter(|(blank, _)| diameter > *blank) {
            reader.fault::<()>(mistake!("step-beyond-blank", step = number, diameter = diameter, blank = blank), place);
        }
        match largest {
            Some((before, other)) if diameter < before => {
                reader.fault::<()>(
                    mistake!(
                        "step-rises-to-the-free-end",
                        step = number,
                        diameter = diameter,
                        before = before,
                        other = other
                    ),
                    place,
                );
            }
            _ => largest = Some((diameter, number)),
        }
    }
    // Only the first step beyond the end of the blank is reported; those after it are beyond it too.
    let Some((blank, _)) = blank_length else { return };
    let mut sum = Micrometres::ZERO;
    for step in steps {
        let Some((length, place)) = &step.length else { return };
        sum = sum + *length;
        if sum > *blank {
            let all: Option<Micrometres> = steps.iter().map(|step| step.length.as_ref().map(|(it, _)| *it)).sum();
            let all = all.unwrap_or(sum);
            reader.fault::<()>(mistake!("steps-beyond-blank", sum = all, blank = blank), place);
            return;
        }
    }
}

/// Whether there are few enough levels and slices to search.
pub(super) fn grid(shaft: &Shaft, place: &Place, reader: &mut Reader<'_>) {
    let states = states(shaft);
    if states > MOST_STATES {
        reader.fault::<()>(mistake!("grid-too-fine", states = states, most = MOST_STATES), place);
    }
}
