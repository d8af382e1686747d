//! What must hold between the values of a part: holes inside the blank, points apart.

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::Problems;
use crate::units::Micrometres;

use super::{Blank, Datum, Hole};

/// A group of holes with the places its geometry is reported at.
pub(super) struct Placed {
    pub hole: Hole,
    pub depth_place: Place,
    pub at_places: Vec<Place>,
}

/// Depths against the thickness, every hole inside the blank, no two holes in each other.
pub(super) fn geometry(holes: &[Placed], blank: &Blank, datum: &Datum, problems: &mut Problems) {
    for placed in holes {
        depth(placed, blank, problems);
        inside(placed, blank, datum, problems);
    }
    apart(holes, problems);
}

fn depth(placed: &Placed, blank: &Blank, problems: &mut Problems) {
    let hole = &placed.hole;
    if hole.through && hole.depth != blank.thickness {
        let message = format!(
            "hole {}: a through hole is {} deep, but the blank is {} thick",
            hole.name, hole.depth, blank.thickness
        );
        problems.error_help::<()>(
            "bad-depth",
            message,
            &placed.depth_place,
            "leave `depth` out, or make it the thickness",
        );
    } else if !hole.through && hole.depth >= blank.thickness {
        let message =
            format!("hole {}: a blind hole is {} deep in a blank {} thick", hole.name, hole.depth, blank.thickness);
        problems.error_help::<()>(
            "bad-depth",
            message,
            &placed.depth_place,
            "say `through: true`, or make it shallower",
        );
    }
}

fn inside(placed: &Placed, blank: &Blank, datum: &Datum, problems: &mut Problems) {
    let hole = &placed.hole;
    let radius = hole.diameter.nominal.half();
    let (right, back) = (datum.left + blank.length, datum.front + blank.width);
    for (point, place) in hole.at.iter().zip(&placed.at_places) {
        let (x, y) = (point.x, point.y);
        if x - radius < datum.left || x + radius > right || y - radius < datum.front || y + radius > back {
            let message =
                format!("hole {}: Ø{} at [{x}, {y}] is not inside the blank", hole.name, hole.diameter.nominal);
            let help =
                format!("the blank reaches from X {} to {right} and from Y {} to {back}", datum.left, datum.front);
            problems.error_help::<()>("outside-blank", message, place, help);
        }
    }
}

fn apart(holes: &[Placed], problems: &mut Problems) {
    let all: Vec<(&Hole, _, &Place)> = holes
        .iter()
        .flat_map(|placed| {
            placed.hole.at.iter().zip(&placed.at_places).map(|(point, place)| (&placed.hole, *point, place))
        })
        .collect();
    for (index, (hole, point, place)) in all.iter().enumerate() {
        for (other, other_point, other_place) in &all[..index] {
            let distance = point.distance(*other_point);
            let least = (hole.diameter.nominal + other.diameter.nominal).half();
            if distance < least.max(Micrometres::new(1)) {
                let message = format!(
                    "hole {} at [{}, {}] runs into hole {} at line {}",
                    hole.name, point.x, point.y, other.name, other_place.line
                );
                let help = format!("the centres are {distance} mm apart, and the holes need {least}");
                problems.error_help::<()>("holes-meet", message, place, help);
            }
        }
    }
}
