//! Decides which surfaces are turned from which end (lecture 12.2, l. 200-202: most parts take two set-ups).
//!
//! From the free end a tool makes elements that rise towards the chuck. Behind the largest radius the contour falls;
//! where it falls more steeply than φ1 and never rises again, the rest is for the second set-up, with the part turned
//! over. A bore is treated the same inside out: it is bored from the end to which it widens. The far face belongs to
//! the second set-up, and so do threads that cannot be cut from the free end.
//!
//! In the second set-up the part is held by a cylinder that the first one made, long enough for the jaws by the rule
//! `turning-hold`.

use serde::Serialize;

use super::far_threads;
use super::hold::{Hold, hold_blank, hold_part};
use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Note};
use crate::turning::contour::{Contour, Profile, Side, Surface};
use crate::turning::cutting::jaw_clearance;
use crate::turning::elements::{Angles, Class, Main, classify, main_contour, split};
use crate::turning::length::Half;
use crate::turning::shaft::Holding;
use crate::turning::workpiece::{SteadyRest, Workpiece};

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

/// A set-up.
#[derive(Clone, Debug, Serialize)]
pub struct SetUp {
    /// Its number, 1 or 2.
    pub number: u8,
    /// Whether the part is turned over: Z is measured from its far face.
    pub turned_over: bool,
    /// Whether it faces stock off at its free end.
    pub faces: bool,
    /// Whether the tailstock centre stands in its free end.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub centre: bool,
    /// The steady rest in it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rest: Option<SteadyRest>,
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

impl SetUp {
    /// A contour of the part, whose length is given, in its coordinates.
    pub fn sees(&self, contour: &Contour, length: Half) -> Contour {
        if self.turned_over { contour.turned_over(length) } else { contour.clone() }
    }

    /// Its work on a side.
    pub const fn side(&self, side: Side) -> Option<&TurnedSide> {
        match side {
            Side::Outer => self.outer.as_ref(),
            Side::Inner => self.inner.as_ref(),
        }
    }
}

/// The surfaces outside, divided between the ends from which they are turned.
struct Division {
    near: Option<Profile>,
    far: Option<Profile>,
    /// Why the first set-up stops earlier than it could.
    early: Option<Note>,
}

/// The one or two set-ups of a part, for a tool that feeds from the free end of each.
///
/// Where the first set-up would leave too little of the blank for the jaws, the last cylinder that it could turn is left to the
/// second one, if both can then be held. `parted` is the Z from which the jaws may stand in the first set-up, where the part is parted
/// off there.
///
/// # Errors
/// The knowledge base lacks the rule `turning-element` or `turning-hold`, or a row of one.
pub fn set_ups(
    part: &Workpiece,
    parted: Option<Half>,
    tool: Angles,
    knowledge: &Knowledge,
) -> Result<Vec<SetUp>, KnowledgeError> {
    let division = divided(&part.outer, tool, knowledge)?;
    let division = match part.steady_rest {
        Some(rest) => before_rest(division, rest, knowledge)?,
        None => division,
    };
    let lent = division
        .near
        .as_ref()
        .filter(|_| part.holding != Holding::Centres && !part.is_only_roughed())
        .and_then(|near| lent(near, division.far.as_ref()));
    let made = set_ups_of((part, parted), division, tool, knowledge)?;
    let unheld = |set_ups: &[SetUp]| set_ups.iter().filter(|one| one.holds_at.is_none()).count();
    if let (Some(lent), true) = (lent, made.first().is_some_and(|first| first.holds_at.is_none())) {
        let other = set_ups_of((part, parted), lent, tool, knowledge)?;
        if unheld(&other) < unheld(&made) {
            return Ok(other);
        }
    }
    Ok(made)
}

/// The division with the last cylinder of the near side, and the grooves in it, left to the far side; none if the near side does
/// not end with a cylinder of its largest radius behind other surfaces.
fn lent(near: &Profile, far: Option<&Profile>) -> Option<Division> {
    let end = near.contour().end()?.radius;
    let largest = near.contour().radii().is_some_and(|(_, most)| most == end);
    let upright =
        |surface: &Surface| surface.pieces.iter().all(|piece| piece.is_cylinder() && piece.from.radius == end);
    let with = |surface: &&Surface| upright(surface) || surface.kind.is_additional();
    let behind = near.surfaces.iter().rev().take_while(with).count();
    // A relief between the shoulder and the cylinder stays with the shoulder.
    let run = near.surfaces.get(near.surfaces.len() - behind..)?;
    let first = near.surfaces.len() - behind + run.iter().position(upright)?;
    largest.then(|| divided_at(near, far, first, "setup-lends")).flatten()
}

/// The division with what does not end clear of a steady rest left to the far side: the tool does not come past it.
fn before_rest(division: Division, rest: SteadyRest, knowledge: &Knowledge) -> Result<Division, KnowledgeError> {
    let [clearance, _] = jaw_clearance(knowledge)?.map(Half::of);
    let [front, _] = rest.sides();
    let ends = |surface: &Surface| surface.pieces.iter().map(|piece| piece.to.z).max().unwrap_or_default();
    let earlier = division.near.as_ref().and_then(|near| {
        let first = near.surfaces.iter().position(|surface| ends(surface) > front - clearance)?;
        divided_at(near, division.far.as_ref(), first, "setup-behind-rest")
    });
    Ok(earlier.unwrap_or(division))
}

/// The division with the surfaces of the near side from one on left to the far side, and the code of the reason.
fn divided_at(near: &Profile, far: Option<&Profile>, first: usize, code: &'static str) -> Option<Division> {
    let (kept, given) = near.surfaces.split_at_checked(first).filter(|(kept, _)| !kept.is_empty())?;
    let begin = given.first()?.pieces.first()?.from;
    let note = Note::new(code).with("z", Half::ZERO - begin.z).with("diameter", begin.radius.diameter());
    let all = given.iter().chain(far.iter().flat_map(|far| &far.surfaces)).cloned().collect();
    let of = |surfaces| Some(Profile { side: near.side, surfaces });
    Some(Division { near: of(kept.to_vec()), far: of(all), early: Some(note) })
}

fn set_ups_of(
    (part, parted): (&Workpiece, Option<Half>),
    Division { near, far, early }: Division,
    tool: Angles,
    knowledge: &Knowledge,
) -> Result<Vec<SetUp>, KnowledgeError> {
    let (bored, bored_far) = match &part.inner {
        Some(inner) => {
            let Division { near, far, .. } = divided(inner, tool, knowledge)?;
            (near, far)
        }
        None => (None, None),
    };
    let far_face = part.blank.end() > part.length();
    let near_face = part.blank.face() > Half::ZERO;
    let mut notes = vec![Note::new("setup-first")];
    let second = far.is_some() || bored_far.is_some() || far_face;
    if !second {
        notes.push(Note::new("setup-only"));
    }
    let from = |profile: Option<Profile>| profile.map(|one| stretch(one, tool, knowledge)).transpose();
    let first = {
        let outer = from(near)?;
        let (holds_at, because) = hold_blank(part, parted, outer.as_ref(), knowledge)?;
        let inner = from(bored)?;
        let centre = part.holding != Holding::Chuck;
        SetUp {
            number: 1,
            turned_over: false,
            faces: near_face,
            centre,
            rest: part.steady_rest,
            outer,
            inner,
            holds_at,
            because,
            notes,
        }
    };
    if !second {
        return Ok(vec![first]);
    }
    let over = |profile: Option<Profile>| profile.map(|one| one.turned_over(part.length()));
    let mut notes = Vec::new();
    let lip = far.as_ref().and_then(|far| far.contour().start());
    if let Some(early) = early {
        notes.push(early);
    } else if let Some(lip) = lip {
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
    // Turned over in a chuck the part is faced at its free end, where a centre would stand.
    let centre = part.holding == Holding::Centres;
    let second = SetUp {
        number: 2,
        turned_over: true,
        faces: far_face,
        centre,
        rest: None,
        outer,
        inner,
        holds_at,
        because,
        notes,
    };
    Ok(vec![first, second])
}

/// The surfaces of a profile turned from the free end, and those from the other end.
fn divided(profile: &Profile, tool: Angles, knowledge: &Knowledge) -> Result<Division, KnowledgeError> {
    let classes = classify(profile, tool, knowledge)?;
    let any = |profile: Profile| (!profile.surfaces.is_empty()).then_some(profile);
    let (near, far) = match split(profile, &classes, tool) {
        Some((near, far)) => (any(near), any(far)),
        None => (any(profile.clone()), None),
    };
    let earlier = near
        .as_ref()
        .and_then(|near| divided_at(near, far.as_ref(), far_threads::begin(near)?, "setup-thread-from-far"));
    Ok(earlier.unwrap_or(Division { near, far, early: None }))
}

fn stretch(profile: Profile, tool: Angles, knowledge: &Knowledge) -> Result<TurnedSide, KnowledgeError> {
    let classes = classify(&profile, tool, knowledge)?;
    let main = main_contour(&profile, &classes, tool);
    Ok(TurnedSide { profile, classes, main })
}
