//! Where the part is held in a set-up: by the blank in the first one, by a cylinder that is made in the second one.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Note};
use crate::tables::turning::part::{TurningHold, TurningHoldFor};
use crate::turning::contour::{Profile, Surface, SurfaceKind};
use crate::turning::cutting::jaw_clearance;
use crate::turning::elements::{Class, Element};
use crate::turning::length::Half;
use crate::turning::shaft::Holding;
use crate::turning::workpiece::Workpiece;
use crate::units::Micrometres;

use super::setup::TurnedSide;

/// The clamping place of the part.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Hold {
    /// Between centres.
    Centres,
    /// In the chuck, by the part of the blank that the set-up does not turn.
    Blank {
        /// Its diameter at the far end.
        diameter_mm: Micrometres,
        /// The length of it that is left for the jaws.
        length_mm: Half,
        /// Where that begins.
        #[serde(skip)]
        from: Half,
    },
    /// In the chuck, by a cylinder that the first set-up made.
    Surface {
        /// Its name.
        name: String,
        /// Its diameter.
        diameter_mm: Micrometres,
        /// The length in which the jaws touch it, without the grooves in it.
        length_mm: Half,
        /// Whether it is a thread, which a split bushing with the same thread holds in the jaws.
        #[serde(skip_serializing_if = "std::ops::Not::not")]
        threaded: bool,
        /// Where it begins and ends, Z of the part.
        #[serde(skip)]
        over: (Half, Half),
    },
}

/// The lengths for the jaws at a diameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JawLengths {
    /// The usual length.
    pub least: Half,
    /// The length below which nothing is held.
    pub shortest: Half,
    /// The length over which the jaws must close at least, back from the tool.
    pub least_grip: Half,
}

impl JawLengths {
    /// The lengths by the rule `turning-hold`.
    ///
    /// # Errors
    /// The knowledge base lacks the rule, or a row of it.
    pub fn of(diameter: Micrometres, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        Ok(Self::because(diameter, Note::new("hold-blank"), knowledge)?.0)
    }

    /// The same with its row.
    fn because(diameter: Micrometres, note: Note, knowledge: &Knowledge) -> Result<(Self, Because), KnowledgeError> {
        let asked = knowledge.ask(&TurningHoldFor { diameter })?;
        let row = asked.need(&diameter.to_string())?;
        let [least, shortest, least_grip] = [row.least_length, row.shortest, row.least_grip].map(Half::of);
        let lengths = Self { least, shortest, least_grip };
        let note = note.with("diameter", diameter).with("least", lengths.least).with("shortest", lengths.shortest);
        Ok((lengths, Because::answer(&asked.answer, note)))
    }
}

type HoldDecision = (Option<Hold>, Because);

/// Held between centres, where the file says so.
fn between_centres(part: &Workpiece, knowledge: &Knowledge) -> Result<Option<HoldDecision>, KnowledgeError> {
    let because = Because::table(knowledge.table_of::<TurningHold>()?, Note::new("hold-centres"));
    Ok((part.holding == Holding::Centres).then_some((Some(Hold::Centres), because)))
}

/// The clamping place of the blank in the first set-up.
///
/// # Errors
/// The knowledge base lacks a table.
pub(super) fn hold_blank(
    part: &Workpiece,
    parted: Option<Half>,
    outer: Option<&TurnedSide>,
    knowledge: &Knowledge,
) -> Result<HoldDecision, KnowledgeError> {
    if let Some(centres) = between_centres(part, knowledge)? {
        return Ok(centres);
    }
    let blank = &part.blank.outer;
    let end = blank.end().unwrap_or_default();
    let turned = outer.and_then(|outer| outer.main.contour.end()).map_or(Half::ZERO, |end| end.z);
    let behind_rest = part.steady_rest.map_or(Half::ZERO, |rest| rest.sides()[1]);
    let from = parted.unwrap_or(turned).max(behind_rest);
    let length = end.z - from;
    // The blank may end with its far face, down to the axis or a bore.
    let radius = blank.radii_at(end.z).map_or(end.radius, |(_, most)| most);
    let diameter = radius.diameter();
    let [near, _] = jaw_clearance(knowledge)?.map(Half::of);
    let lengths = JawLengths::of(diameter, knowledge)?;
    if length >= lengths.least.min(lengths.shortest + near) {
        let because = JawLengths::because(diameter, Note::new("hold-blank").with("length", length), knowledge)?.1;
        return Ok((Some(Hold::Blank { diameter_mm: diameter, length_mm: length, from }), because));
    }
    let note = Note::new("hold-blank-short").with("length", length).with("clearance", near);
    Ok((None, JawLengths::because(diameter, note, knowledge)?.1))
}

/// A cylinder of a profile with the others of its diameter behind it, from which only grooves part them.
struct Cylinder<'a> {
    first: &'a Surface,
    radius: Half,
    over: (Half, Half),
    /// What is left of it beside the grooves.
    touches: Half,
    threaded: bool,
}

/// The cylinders of a profile, in the order of Z.
fn cylinders<'a>(profile: &'a Profile, classes: &[Class]) -> Vec<Cylinder<'a>> {
    let mut cylinders: Vec<Cylinder<'a>> = Vec::new();
    let mut joined = false;
    for (surface, class) in profile.surfaces.iter().zip(classes) {
        if surface.is_groove() {
            continue;
        }
        let piece = surface.pieces.first().filter(|piece| piece.is_cylinder());
        let threaded = surface.kind == SurfaceKind::Thread;
        let Some(piece) = piece.filter(|_| threaded || class.element == Element::Main) else {
            joined = false;
            continue;
        };
        let (radius, length) = (piece.from.radius, piece.to.z - piece.from.z);
        match cylinders.last_mut().filter(|last| joined && last.radius == radius && !threaded && !last.threaded) {
            Some(last) => {
                last.over.1 = piece.to.z;
                last.touches = last.touches + length;
            }
            None => {
                let over = (piece.from.z, piece.to.z);
                cylinders.push(Cylinder { first: surface, radius, over, touches: length, threaded });
            }
        }
        joined = true;
    }
    cylinders
}

/// How well a cylinder holds a part: whether the jaws close over enough of it as they stay off the tool, whether it is none with a
/// thread, whether it has the usual length, its radius and its length.
type Rank = (bool, bool, bool, Half, Half);

/// The clamping place of the part in the second set-up: the thickest of the cylinders that are long enough and that
/// the jaws can close over as far as they must, and of these the longest. A thick cylinder transmits the torque with the least force. Where none has the usual length, one
/// that has the shortest is taken; where there is none of these either, a thread.
///
/// # Errors
/// The knowledge base lacks a table.
pub(super) fn hold_part(
    part: &Workpiece,
    made: Option<&TurnedSide>,
    knowledge: &Knowledge,
) -> Result<HoldDecision, KnowledgeError> {
    if let Some(centres) = between_centres(part, knowledge)? {
        return Ok(centres);
    }
    let mut best: Option<(Rank, Hold, Because)> = None;
    let mut passed = Vec::new();
    let [near, _] = jaw_clearance(knowledge)?.map(Half::of);
    // From there on the second set-up turns.
    let end = made.and_then(|made| made.main.contour.end()).map_or(Half::ZERO, |end| end.z);
    for cylinder in made.iter().flat_map(|made| cylinders(&made.profile, &made.classes)) {
        let (name, diameter, length) = (&cylinder.first.name, cylinder.radius.diameter(), cylinder.touches);
        let threaded = cylinder.threaded;
        let note = Note::new(if threaded { "hold-thread" } else { "hold-surface" });
        let note = note.with("surface", name).with("length", length);
        let (lengths, because) = JawLengths::because(diameter, note, knowledge)?;
        if length < lengths.least {
            let short = Note::new("hold-surface-short").with("surface", name).with("length", length);
            passed.push(short.with("least", lengths.least));
        }
        let grips = length.min(end - near - cylinder.over.0) >= lengths.least_grip;
        let rank = (grips, !threaded, length >= lengths.least, cylinder.radius, length);
        if length >= lengths.shortest && best.as_ref().is_none_or(|(other, ..)| *other < rank) {
            let (name, over) = (name.to_string(), cylinder.over);
            let hold = Hold::Surface { name, diameter_mm: diameter, length_mm: length, threaded, over };
            best = Some((rank, hold, because));
        }
    }
    Ok(match best {
        Some((.., hold, because)) => (Some(hold), because.with_rejected(passed)),
        None => (
            None,
            Because::table(knowledge.table_of::<TurningHold>()?, Note::new("hold-nowhere")).with_rejected(passed),
        ),
    })
}
