//! Decides which surfaces are turned from which end (lecture 12.2, l. 200-202: most parts take two set-ups).
//!
//! From the free end a tool makes elements that rise towards the chuck. Behind the largest radius the contour falls;
//! where it falls more steeply than φ1 and never rises again, the rest is for the second set-up, with the part turned
//! over. A bore is treated the same inside out: it is bored from the end to which it widens. The far face belongs to
//! the second set-up.
//!
//! In the second set-up the part is held by a cylinder that the first one made, long enough for the jaws by the rule
//! `turning-hold`.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Note};
use crate::tables::turning::part::{TurningHold, TurningHoldFor};
use crate::turning::contour::{Contour, Profile, Surface, SurfaceKind};
use crate::turning::elements::{Angles, Class, Element, Main, classify, main_contour, split};
use crate::turning::length::Half;
use crate::turning::shaft::Holding;
use crate::units::Micrometres;

/// The part to be turned.
#[derive(Clone, Copy, Debug)]
pub struct Workpiece<'a> {
    /// The outer profile from the free end.
    pub outer: &'a Profile,
    /// The bore, if there is one.
    pub inner: Option<&'a Profile>,
    /// The length of the finished part.
    pub length: Half,
    /// The blank from outside, in the same coordinates.
    pub blank: &'a Contour,
    /// The way of clamping.
    pub holding: Holding,
}

/// The work of one set-up on one side, in its own coordinates: Z = 0 at the end that is free in it.
#[derive(Clone, Debug, Serialize)]
pub struct TurnedSide {
    /// The surfaces. A surface that is turned in both set-ups is in both, with the pieces of each.
    pub profile: Profile,
    /// Their classes for the tool.
    pub classes: Vec<Class>,
    /// The main contour.
    pub main: Main,
}

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
    },
    /// In the chuck, by a cylinder that the first set-up made.
    Surface {
        /// Its name.
        name: String,
        /// Its diameter.
        diameter_mm: Micrometres,
        /// Its length.
        length_mm: Half,
    },
}

/// A set-up.
#[derive(Clone, Debug, Serialize)]
pub struct SetUp {
    /// Its number, 1 or 2.
    pub number: u8,
    /// Whether the part is turned over: Z is measured from its far face.
    pub turned_over: bool,
    /// Whether it faces stock off at its free end.
    pub faces: bool,
    /// Its work outside.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outer: Option<TurnedSide>,
    /// Its work in the bore.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inner: Option<TurnedSide>,
    /// The clamping place; none if no cylinder is long enough.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub holds_at: Option<Hold>,
    /// The reason for the clamping place, or for its absence.
    pub because: Because,
    /// The reason for this set-up.
    pub notes: Vec<Note>,
}

/// The one or two set-ups of a part, for a tool that feeds from the free end of each.
///
/// # Errors
/// The knowledge base lacks the rule `turning-element` or `turning-hold`, or a row of one.
pub fn set_ups(part: Workpiece<'_>, tool: Angles, knowledge: &Knowledge) -> Result<Vec<SetUp>, KnowledgeError> {
    let (near, far) = divided(part.outer, tool, knowledge)?;
    let (bored, bored_far) = match part.inner {
        Some(inner) => divided(inner, tool, knowledge)?,
        None => (None, None),
    };
    let far_face = part.blank.end().is_some_and(|end| end.z > part.length);
    let near_face = part.blank.start().is_some_and(|start| start.z < Half::ZERO);
    let mut notes = vec![Note::new("setup-first")];
    let second = far.is_some() || bored_far.is_some() || far_face;
    if !second {
        notes.push(Note::new("setup-only"));
    }
    let from = |profile: Option<Profile>| profile.map(|one| stretch(one, tool, knowledge)).transpose();
    let first = {
        let outer = from(near)?;
        let (holds_at, because) = hold_blank(part, outer.as_ref(), knowledge)?;
        let inner = from(bored)?;
        SetUp { number: 1, turned_over: false, faces: near_face, outer, inner, holds_at, because, notes }
    };
    if !second {
        return Ok(vec![first]);
    }
    let over = |profile: Option<Profile>| profile.map(|one| turned_over(&one, part.length));
    let mut notes = Vec::new();
    let lip = far.as_ref().and_then(|far| far.contour().start());
    if let Some(lip) = lip {
        let note = Note::new("setup-falls-away").with("z", Half::ZERO - lip.z).with("diameter", lip.radius.diameter());
        notes.push(note.with("secondary", crate::units::round_to(tool.secondary.0, 2)));
    }
    if bored_far.is_some() {
        notes.push(Note::new("setup-bore-widens"));
    }
    if far_face {
        notes.push(Note::new("setup-far-face"));
    }
    let (holds_at, because) = hold_part(part, first.outer.as_ref(), knowledge)?;
    let (outer, inner) = (from(over(far))?, from(over(bored_far))?);
    let second = SetUp { number: 2, turned_over: true, faces: far_face, outer, inner, holds_at, because, notes };
    Ok(vec![first, second])
}

/// The surfaces of a profile turned from the free end, and those from the other end.
fn divided(
    profile: &Profile,
    tool: Angles,
    knowledge: &Knowledge,
) -> Result<(Option<Profile>, Option<Profile>), KnowledgeError> {
    let classes = classify(profile, tool, knowledge)?;
    let any = |profile: Profile| (!profile.surfaces.is_empty()).then_some(profile);
    Ok(match split(profile, &classes, tool) {
        Some((near, far)) => (any(near), any(far)),
        None => (any(profile.clone()), None),
    })
}

fn stretch(profile: Profile, tool: Angles, knowledge: &Knowledge) -> Result<TurnedSide, KnowledgeError> {
    let classes = classify(&profile, tool, knowledge)?;
    let main = main_contour(&profile, &classes, tool);
    Ok(TurnedSide { profile, classes, main })
}

/// A profile of the part turned over.
fn turned_over(profile: &Profile, length: Half) -> Profile {
    let over = |surface: &Surface| {
        let contour = Contour { side: profile.side, pieces: surface.pieces.clone() }.turned_over(length);
        Surface { pieces: contour.pieces, ..surface.clone() }
    };
    Profile { side: profile.side, surfaces: profile.surfaces.iter().rev().map(over).collect() }
}

/// The least length for the jaws at a diameter, by the rule `turning-hold`.
///
/// # Errors
/// The knowledge base lacks the rule, or a row of it.
pub fn least_length(diameter: Micrometres, knowledge: &Knowledge) -> Result<Half, KnowledgeError> {
    Ok(least_length_because(diameter, Note::new("hold-blank"), knowledge)?.0)
}

/// The same with its row.
fn least_length_because(
    diameter: Micrometres,
    note: Note,
    knowledge: &Knowledge,
) -> Result<(Half, Because), KnowledgeError> {
    let asked = knowledge.ask(&TurningHoldFor { diameter })?;
    let least = Half::of(asked.need(&diameter.to_string())?.least_length);
    let note = note.with("diameter", diameter).with("least", least);
    Ok((least, Because::answer(&asked.answer, note)))
}

type HoldDecision = (Option<Hold>, Because);

/// The clamping place of the blank in the first set-up.
fn hold_blank(
    part: Workpiece<'_>,
    outer: Option<&TurnedSide>,
    knowledge: &Knowledge,
) -> Result<HoldDecision, KnowledgeError> {
    if part.holding == Holding::Centres {
        return Ok((
            Some(Hold::Centres),
            Because::table(knowledge.table_of::<TurningHold>()?, Note::new("hold-centres")),
        ));
    }
    let end = part.blank.end().unwrap_or_default();
    let turned = outer.and_then(|outer| outer.main.contour.end()).map_or(Half::ZERO, |end| end.z);
    let length = end.z - turned;
    // The blank may end with its far face, down to the axis or a bore.
    let radius = part.blank.radii_at(end.z).map_or(end.radius, |(_, most)| most);
    let diameter = radius.diameter();
    let code = |long_enough: bool| {
        Note::new(if long_enough { "hold-blank" } else { "hold-blank-short" }).with("length", length)
    };
    let (least, because) = least_length_because(diameter, code(true), knowledge)?;
    if length >= least {
        return Ok((Some(Hold::Blank { diameter_mm: diameter, length_mm: length }), because));
    }
    Ok((None, least_length_because(diameter, code(false), knowledge)?.1))
}

/// The clamping place of the part in the second set-up: the thickest of the cylinders that are long enough, and of
/// these the longest. A thick cylinder transmits the torque with the least force.
fn hold_part(
    part: Workpiece<'_>,
    made: Option<&TurnedSide>,
    knowledge: &Knowledge,
) -> Result<HoldDecision, KnowledgeError> {
    if part.holding == Holding::Centres {
        return Ok((
            Some(Hold::Centres),
            Because::table(knowledge.table_of::<TurningHold>()?, Note::new("hold-centres")),
        ));
    }
    let mut best: Option<(Half, Half, Hold, Because)> = None;
    let mut passed = Vec::new();
    for (surface, class) in made.iter().flat_map(|made| made.profile.surfaces.iter().zip(&made.classes)) {
        let Some(piece) = surface.pieces.first().filter(|piece| piece.is_cylinder()) else { continue };
        let (radius, length) = (piece.from.radius, piece.to.z - piece.from.z);
        if surface.kind == SurfaceKind::Thread || class.element != Element::Main {
            continue;
        }
        let note = Note::new("hold-surface").with("surface", &surface.name).with("length", length);
        let (least, because) = least_length_because(radius.diameter(), note, knowledge)?;
        if length < least {
            let short = Note::new("hold-surface-short").with("surface", &surface.name).with("length", length);
            passed.push(short.with("least", least));
            continue;
        }
        if best.as_ref().is_none_or(|(thick, long, ..)| (*thick, *long) < (radius, length)) {
            let hold =
                Hold::Surface { name: surface.name.to_string(), diameter_mm: radius.diameter(), length_mm: length };
            best = Some((radius, length, hold, because));
        }
    }
    match best {
        Some((.., hold, because)) => Ok((Some(hold), because.over(passed))),
        None => {
            Ok((None, Because::table(knowledge.table_of::<TurningHold>()?, Note::new("hold-nowhere")).over(passed)))
        }
    }
}
