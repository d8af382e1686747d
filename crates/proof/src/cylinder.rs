//! The requirements of the drawing for a cylinder of a hole, and the cylinder of a transition.

use crate::part::{Bottom, Face, Hole, Part, Thread, ToleratedDiameter};
use crate::plan::{Feature, Transition};
use crate::units::{Micrometres, Roughness};

/// A cylinder of a hole: the main one, or a step of that number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum CylinderId {
    Main,
    Step(usize),
}

impl CylinderId {
    /// The cylinder that a transition works on; none for edges, faces and cones.
    pub fn of(transition: &Transition) -> Option<Self> {
        match (transition.feature, transition.step) {
            (Feature::Bore | Feature::Thread, None) => Some(Self::Main),
            (Feature::Bore | Feature::Thread | Feature::Step, Some(number)) => Some(Self::Step(number)),
            _ => None,
        }
    }
}

/// The requirements of the drawing for a cylinder.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CylinderRequirements<'p> {
    pub diameter: &'p ToleratedDiameter,
    pub roughness: Roughness,
    /// Depth from the face it is entered from.
    pub depth: Micrometres,
    pub through: bool,
    /// Whether its floor or shoulder is flat.
    pub flat: bool,
    pub thread: Option<&'p Thread>,
    /// The permitted position error of its axis; none for steps, which follow the main cylinder.
    pub position: Option<Micrometres>,
}

impl<'p> CylinderRequirements<'p> {
    /// The requirements for a cylinder of a hole; none if the hole has no such step.
    pub fn of(place: CylinderId, hole: &'p Hole, part: &Part, position: Option<Micrometres>) -> Option<Self> {
        match place {
            CylinderId::Main => Some(Self {
                // It ends where the cylinders of the back face begin.
                depth: hole.depth
                    - hole
                        .steps
                        .iter()
                        .filter(|step| step.face == Face::Back)
                        .map(|step| step.depth)
                        .max()
                        .unwrap_or_default(),
                diameter: &hole.diameter,
                roughness: hole.roughness,
                through: hole.through,
                flat: hole.bottom == Bottom::Flat,
                thread: hole.thread.as_ref(),
                position: part.position_tolerance.or(position),
            }),
            CylinderId::Step(number) => hole.steps.get(number.checked_sub(1)?).map(|step| Self {
                diameter: &step.diameter,
                roughness: step.roughness,
                depth: step.depth,
                through: false,
                flat: step.bottom == Bottom::Flat,
                thread: step.thread.as_ref(),
                position: None,
            }),
        }
    }
}
