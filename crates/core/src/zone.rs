//! The working zone of the machine: the space that a part and its tools need; used by planning, jobs and audits.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::motion::Axis;
use crate::note::{Note, Severity};
use crate::part::{BlankHole, Hole, Part};
use crate::shop::Shop;
use crate::tables::materials::Density;
use crate::tables::rules::{Approach, ApproachFor};
use crate::units::{Micrometres, round_to};

/// The stroke of a tool between its height above the part and its lowest point; heights of its tip above the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stroke {
    /// From the spindle's nose to its tip.
    pub length: Micrometres,
    /// The height at which it passes above the part.
    pub highest: Micrometres,
    /// Its lowest point.
    pub lowest: Micrometres,
}

impl Stroke {
    /// The height of the spindle nose above the table with the quill retracted: the least at which the tool passes
    /// above the part.
    pub fn passes_from(&self) -> Micrometres {
        self.highest + self.length
    }

    /// The travel of the quill to the tool's lowest point, if the nose has that height with the quill retracted.
    pub fn travel(&self, nose: Micrometres) -> Micrometres {
        nose - self.lowest - self.length
    }
}

/// The lowest height of the spindle nose above the table with the quill retracted: what the most demanding tool
/// allows, but not below the machine's least; `None` without tools.
pub fn lowest_nose(strokes: &[Stroke], least: Option<Micrometres>) -> Option<Micrometres> {
    let needed = strokes.iter().map(Stroke::passes_from).max()?;
    Some(least.map_or(needed, |least| least.max(needed)))
}

/// The axes of the table, each with the least and the greatest coordinate of the holes; none without holes.
pub fn spans(part: &Part) -> impl Iterator<Item = (Axis, Micrometres, Micrometres)> {
    let points = || part.holes.iter().flat_map(Hole::ends);
    let x = points().map(|point| point.x).min().zip(points().map(|point| point.x).max());
    let y = points().map(|point| point.y).min().zip(points().map(|point| point.y).max());
    [(Axis::X, x), (Axis::Y, y)].into_iter().filter_map(|(axis, span)| span.map(|(low, high)| (axis, low, high)))
}

/// A limit of the machine's table that a part exceeds.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum OffTable {
    /// It is heavier than the table bears, kg, as the file says.
    TooHeavy { mass: f64, limit: f64 },
    /// A solid plate of its size is heavier than the table bears, kg; of the lightest metal of its group it weighs `least`, of the
    /// heaviest `most`.
    PlateTooHeavy { least: f64, most: f64, limit: f64 },
    /// Its holes are further apart than the table travels.
    BeyondTravel { axis: Axis, span: Micrometres, travel: Micrometres },
}

impl OffTable {
    /// The sentence.
    pub fn note(&self) -> Note {
        match self {
            Self::TooHeavy { mass, limit } => Note::new("too-heavy").with("mass", mass).with("limit", limit),
            Self::PlateTooHeavy { least, most, limit } => {
                let [least, most] = [least, most].map(|mass| round_to(*mass, 0).to_string());
                let mass = if least == most { least } else { format!("{least}–{most}") };
                Note::new("plate-too-heavy").with("mass", mass).with("limit", limit)
            }
            Self::BeyondTravel { axis, span, travel } => {
                Note::new("beyond-travel").with("axis", axis.letter()).with("span", span).with("travel", travel)
            }
        }
    }

    /// An error, but for a mass that only the heaviest metal of the group would have.
    pub fn severity(&self) -> Severity {
        match self {
            Self::PlateTooHeavy { least, limit, .. } if least <= limit => Severity::Doubtful,
            _ => Severity::Error,
        }
    }
}

/// The limits of the table that a part exceeds: its mass, and its travel for the holes. Where the file gives no mass it is that
/// of a solid plate, V·ρ, ρ of the table `densities`.
///
/// # Errors
/// The knowledge base is broken.
pub fn off_table(part: &Part, shop: &Shop<'_>) -> Result<Vec<OffTable>, KnowledgeError> {
    let machine = &shop.machine;
    let limit = machine.load_max_kg;
    let heavy = match part.mass_kg {
        Some(mass) => (mass > limit).then_some(OffTable::TooHeavy { mass, limit }),
        None => {
            let weighs = masses(part, shop.material.group, shop.knowledge)?;
            let weighs = weighs.filter(|(_, most)| *most > limit);
            weighs.map(|(least, most)| OffTable::PlateTooHeavy { least, most, limit })
        }
    };
    let beyond = spans(part).filter_map(|(axis, low, high)| {
        let (span, travel) = (high - low, machine.travel(axis));
        (span > travel).then_some(OffTable::BeyondTravel { axis, span, travel })
    });
    Ok(heavy.into_iter().chain(beyond).collect())
}

/// The mass of a solid plate of the lightest and of the heaviest metal of a group, V·ρ, ρ of the table `densities`, kg; none for
/// a group without a row.
///
/// # Errors
/// The knowledge base is broken.
pub fn masses(part: &Part, group: &str, knowledge: &Knowledge) -> Result<Option<(f64, f64)>, KnowledgeError> {
    // A new group of materials need not have a row.
    let density = knowledge.find(|row: &Density<'_>| row.material_group == group)?;
    let [length, width, thickness] =
        [part.blank.length, part.blank.width, part.blank.thickness].map(|side| side.to_mm() / 1000.0);
    // Of a disc π/4·(D² − d²)·s.
    let area = match part.blank.is_round() {
        false => length * width,
        true => {
            let bore = part.blank.bore.map_or(0.0, |bore| bore.to_mm() / 1000.0);
            std::f64::consts::FRAC_PI_4 * (length * width - bore * bore)
        }
    };
    let of = |density: f64| area * thickness * density;
    Ok(density.map(|density| (of(density.lightest), of(density.heaviest))))
}

/// The mass of a blank, kg: between two figures where only the group of its metal is known, alike where it is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mass {
    /// The least.
    pub least: f64,
    /// The most.
    pub most: f64,
}

impl Mass {
    /// The mass, where it is one figure.
    pub fn exact(self) -> Option<f64> {
        (self.least >= self.most).then_some(self.most)
    }
}

/// The mass of a part's blank: that of the file, else that of a solid plate ([`masses`]), which is the most where holes are
/// there before the operation.
///
/// # Errors
/// The knowledge base is broken, or lacks the material.
pub fn mass(part: &Part, knowledge: &Knowledge) -> Result<Option<Mass>, KnowledgeError> {
    if let Some(mass) = part.mass_kg {
        return Ok(Some(Mass { least: mass, most: mass }));
    }
    let group = Material::find(knowledge, &part.material)?.group;
    let is_solid = part.holes.iter().all(|hole| hole.state == BlankHole::Solid);
    Ok(masses(part, group, knowledge)?.map(|(least, most)| Mass { least: if is_solid { least } else { 0.0 }, most }))
}

/// The row of the rule `approach` for a part: the distance before the metal where the feed begins (`approach`), and
/// how far a tool comes out of a hole (`overrun`); textbook 1.4, l. 413-418.
///
/// # Errors
/// The rule has no row.
pub fn approach<'k>(part: &Part, through: bool, knowledge: &'k Knowledge) -> Result<Approach<'k>, KnowledgeError> {
    knowledge.ask(&ApproachFor { entry: part.entry, through })?.need(part.entry.name())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stroke(length: i64, highest: i64, lowest: i64) -> Stroke {
        let [length, highest, lowest] = [length, highest, lowest].map(Micrometres::from_mm);
        Stroke { length, highest, lowest }
    }

    #[test]
    fn the_nose_stands_as_low_as_the_longest_tool_lets_it() {
        // A part of 40 mm on supports of 60: tools of 215 and 155 mm pass 3 mm over it and go 6 mm below it.
        let long = stroke(215, 103, 54);
        let short = stroke(155, 103, 54);
        let nose = lowest_nose(&[short, long], Some(Micrometres::from_mm(250))).unwrap();
        assert_eq!(nose, Micrometres::from_mm(318));
        assert_eq!(short.travel(nose), Micrometres::from_mm(318 - 54 - 155));
        // Where the machine keeps the nose higher, it is farther down to the bottom.
        let nose = lowest_nose(&[short, long], Some(Micrometres::from_mm(400))).unwrap();
        assert_eq!(short.travel(nose), Micrometres::from_mm(400 - 54 - 155));
        assert_eq!(lowest_nose(&[], None), None);
    }
}
