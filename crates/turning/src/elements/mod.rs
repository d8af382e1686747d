//! Main and additional elements of a contour, and the main contour (lecture 12.1, l. 79-99).
//!
//! A main element is one that a contouring tool with φ = 95° and φ1 = 30° can make; all others are additional. Here the
//! tool can be any. [`classify`] classifies every surface for a tool that feeds in one direction, [`main_contour`]
//! bridges what the tool cannot make. The rule `turning-element` names the kind of tool that an additional element
//! needs.
//!
//! - `view` turns bores inside out and mirrors the contour for the other hand, so that the rest knows only one case;
//! - `reach` finds the points that the tool cannot reach because of other `metal`;
//! - `bridge` and `silhouette` make the main contour.

mod bridge;
mod classify;
mod metal;
mod reach;
mod silhouette;
pub(super) mod view;

use std::collections::BTreeMap;

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Note};
use crate::units::Degrees;

pub use crate::tables::turning::part::{Element, ElementReason};

use super::contour::{Contour, Piece, Profile, Surface, SurfaceName};
use super::point::Point;
use bridge::{BridgeSpan, Bridged, bridge};
use classify::Seen;
use reach::{Edges, Shade};
pub(super) use view::steepness;
use view::{Bit, View};

/// In which direction a tool feeds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Hand {
    /// From the free end towards the chuck.
    Right,
    /// From the chuck towards the free end.
    Left,
}

/// The angles of a tool in the plane of the section.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Angles {
    /// φ: between the main cutting edge and the feed; above 90° the edge leans back.
    #[serde(rename = "main_angle_deg")]
    pub main: Degrees,
    /// φ1: between the auxiliary cutting edge and the return direction.
    #[serde(rename = "secondary_angle_deg")]
    pub secondary: Degrees,
    /// The direction of its feed.
    pub hand: Hand,
}

impl Angles {
    /// The contouring tool by which the lecture defines main elements: φ = 95°, φ1 = 30° (12.1, l. 85-91).
    pub const CONTOURING: Self = Self { main: Degrees(95.0), secondary: Degrees(30.0), hand: Hand::Right };
}

/// A classified surface.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Class {
    /// Its index in the profile.
    pub surface: usize,
    /// Its name.
    pub name: SurfaceName,
    /// Main, additional or for the other side.
    pub element: Element,
    /// Why.
    pub ground: ElementReason,
    /// Whether the tool makes part of it, but not all; then all of it is additional.
    pub partly: bool,
    /// Its steepest rise in the direction of the feed, degrees in [0, 180]; above 90 it runs back.
    #[serde(rename = "rise_deg")]
    pub rise: Degrees,
    /// Its steepest fall, degrees in [0, 180].
    #[serde(rename = "fall_deg")]
    pub fall: Degrees,
    /// The kind of tool that makes it, by the rule `turning-element`.
    pub tool: String,
    /// Its angles compared with those of the tool, and the row that names the tool.
    pub because: Because,
    /// Further notes: that part of it could be made.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<Note>,
}

/// A bridge over additional elements.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Valley {
    /// The surfaces under it, by index.
    pub surfaces: Vec<usize>,
    /// The lips, from the free end.
    pub lips: (Point, Point),
    /// The part between the lips: the lower side of the region of these elements (allowance 2).
    pub under: Vec<Piece>,
    /// The bridge between the lips: the other side.
    pub bridge: Vec<Piece>,
    /// Whether the contour never rises to it again, so that the region is for the other set-up.
    pub open: bool,
}

/// The main contour, and what it leaves out.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Main {
    /// Monotone, from the free end, nowhere below the part.
    pub contour: Contour,
    /// The bridges in it, from the free end.
    pub valleys: Vec<Valley>,
}

/// Classifies every surface of a profile for a tool.
///
/// # Errors
/// The knowledge base lacks the rule `turning-element` or a row of it.
pub fn classify(profile: &Profile, tool: Angles, knowledge: &Knowledge) -> Result<Vec<Class>, KnowledgeError> {
    let (_, bits, shades) = seen(profile, tool);
    let lost = lost(profile, &bits, &shades, |_| true);
    let spans = bridge(&bits, &lost).spans;
    let seen = Seen::new(&bits, &shades, &spans);
    let surfaces = profile.surfaces.iter().enumerate();
    surfaces.map(|(index, surface)| classify::class(index, surface, tool, &seen, knowledge)).collect()
}

/// The main contour of a profile with its classes for a tool.
///
/// Bridges extend the lips, or go level from the near lip: a groove in a cylinder is bridged by the cylinder, a relief
/// at a shoulder by cylinder and face to their corner, a face groove by the face. A thread stays as the cylinder that
/// it is cut into. A rise steeper than φ is not bridged, because it cannot have another shape. A face that leans back
/// by no more than φ becomes upright; the rest of it is left for finishing.
pub fn main_contour(profile: &Profile, classes: &[Class], tool: Angles) -> Main {
    let (view, _, done) = bridged(profile, classes, tool);
    let mut valleys: Vec<Valley> = done.spans.iter().map(|span| valley(span, view)).collect();
    valleys.sort_by_key(|valley| valley.lips.0.z);
    Main { contour: Contour { side: profile.side, pieces: view.back(&done.bits) }, valleys }
}

/// Divides a profile where the contour falls and never rises again. A surface across that point is in both parts, with
/// its pieces of each. None if the contour has no such fall.
pub fn split(profile: &Profile, classes: &[Class], tool: Angles) -> Option<(Profile, Profile)> {
    let (view, bits, done) = bridged(profile, classes, tool);
    let open = done.spans.iter().find(|span| span.open)?;
    let part = |bits: &[Bit]| {
        let mut own: BTreeMap<usize, Vec<Bit>> = BTreeMap::new();
        for bit in bits {
            own.entry(bit.surface).or_default().push(*bit);
        }
        let surfaces = own.iter().filter_map(|(index, own)| {
            let surface = profile.surfaces.get(*index)?;
            Some(Surface { pieces: view.back(own), ..surface.clone() })
        });
        Profile { side: profile.side, surfaces: surfaces.collect() }
    };
    let (before, behind) = bits.split_at_checked(open.bits.0)?;
    Some(if view.mirrored() { (part(behind), part(before)) } else { (part(before), part(behind)) })
}

/// The bits of a profile, and the bridges over those that its classes exclude.
fn bridged(profile: &Profile, classes: &[Class], tool: Angles) -> (View, Vec<Bit>, Bridged) {
    let (view, bits, shades) = seen(profile, tool);
    let additional = |bit: &Bit| classes.get(bit.surface).is_some_and(|class| class.element != Element::Main);
    let done = bridge(&bits, &lost(profile, &bits, &shades, additional));
    (view, bits, done)
}

/// What keeps the tip from a point of a bit, and whether it reaches another of its points.
type Shaded = (Option<Shade>, bool);

/// The bits of a profile as a tool sees them, and what keeps the tool from each. Grooves are no metal.
fn seen(profile: &Profile, tool: Angles) -> (View, Vec<Bit>, Vec<Shaded>) {
    let view = View::new(profile, tool.hand);
    let bits = view.bits(profile);
    let shades = Edges::of(tool).shades(&bits, |bit| !is_groove(profile, bit));
    (view, bits, shades)
}

/// The bits that are bridged: grooves, and of those that may be what the tool does not reach from behind or from above.
fn lost(profile: &Profile, bits: &[Bit], shades: &[(Option<Shade>, bool)], may: impl Fn(&Bit) -> bool) -> Vec<bool> {
    let lost = |(bit, (shade, _)): (&Bit, &(Option<Shade>, bool))| {
        is_groove(profile, bit) || (may(bit) && matches!(shade, Some(Shade::Behind | Shade::Over)))
    };
    bits.iter().zip(shades).map(lost).collect()
}

fn is_groove(profile: &Profile, bit: &Bit) -> bool {
    profile.surfaces.get(bit.surface).is_some_and(Surface::is_groove)
}

fn valley(span: &BridgeSpan, view: View) -> Valley {
    let mut surfaces: Vec<usize> = span.under.iter().map(|bit| bit.surface).collect();
    surfaces.sort_unstable();
    surfaces.dedup();
    let ends = |bits: &[Bit]| bits.first().zip(bits.last()).map(|(first, last)| (first.piece.from, last.piece.to));
    // A bridge without length covers what begins and ends at one point: a far face.
    let (near, far) = ends(&span.over).or_else(|| ends(&span.under)).unwrap_or_default();
    let (near, far) = (view.point(near), view.point(far));
    let lips = if view.mirrored() { (far, near) } else { (near, far) };
    Valley { surfaces, lips, under: view.back(&span.under), bridge: view.back(&span.over), open: span.open }
}
