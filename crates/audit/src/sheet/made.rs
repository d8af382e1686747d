//! A part that has the holes of a list or of a program, and of which nothing else is known.

use crate::knowledge::diagnostic::Place;
use crate::knowledge::yaml::Node;

use super::{STAND_INS, entry, list_of, map, scalar};

/// A hole of such a part.
pub(crate) struct MadeHole {
    pub name: String,
    /// As a part file has it: `10H14`.
    pub diameter: String,
    /// mm.
    pub depth: f64,
    /// mm.
    pub at: Vec<[f64; 2]>,
}

/// The part as its file would have it. `blank` is length, width and thickness, mm; `said` gives material and machine where somebody
/// names them.
pub(crate) fn part(
    name: &str,
    holes: &[MadeHole],
    blank: [f64; 3],
    said: impl Fn(&str) -> Option<Node>,
    place: &Place,
) -> Node {
    let text = |text: &str| scalar(text, place);
    let number = |value: f64| text(&value.to_string());
    let hole = |own: &MadeHole| {
        let at = own.at.iter().map(|point| list_of(point.iter().map(|value| number(*value)).collect(), place));
        map(
            vec![
                entry("name", text(&own.name)),
                entry("diameter", text(&own.diameter)),
                entry("depth", number(own.depth)),
                entry("roughness", text("Rz 80")),
                entry("centre_tolerance", text("1")),
                entry("at", list_of(at.collect(), place)),
            ],
            place,
        )
    };
    let sizes = ["length", "width", "thickness"].into_iter().zip(blank);
    let mut blank = vec![entry("kind", text("plate"))];
    blank.extend(sizes.map(|(key, size)| entry(key, number(size))));
    let mut part = vec![
        entry("part", text(name)),
        entry("blank", map(blank, place)),
        entry("holes", list_of(holes.iter().map(hole).collect(), place)),
    ];
    part.extend(STAND_INS.map(|(key, stand_in)| entry(key, said(key).unwrap_or_else(|| text(stand_in)))));
    map(part, place)
}
