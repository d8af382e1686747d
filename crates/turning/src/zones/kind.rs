//! The kind of a zone, and its schemes: the rules `turning-zone` and `turning-scheme`, for stepped shafts and for
//! contours of any shape.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Figure, Note};
use crate::tables::turning::part::BlankShape;
use crate::tables::turning::passes::{ContourShape, PartsWorked, TurningSchemeFor, TurningZoneFor, ZoneParts};
use crate::turning::workpiece::Scheme;

pub use crate::tables::turning::passes::ZoneKind;

/// The bounds of a zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// A face, slope or stock ahead of the tool.
    pub ahead: bool,
    /// A face or slope behind it.
    pub behind: bool,
}

/// A kind with its reason.
#[derive(Clone, Debug)]
pub struct ClassifiedZone {
    /// The kind.
    pub kind: ZoneKind,
    /// The kinds of its parts.
    pub parts: ZoneParts,
    /// The row.
    pub because: Because,
}

/// The kind of a zone that is not combined.
///
/// # Errors
/// The knowledge base lacks the rule `turning-zone` or a row of it.
pub fn alone(bounds: Bounds, knowledge: &Knowledge) -> Result<ClassifiedZone, KnowledgeError> {
    kind(ZoneParts::Alone, bounds, knowledge)
}

/// The kind of a zone that consists of zones with these kinds and bounds. If all are of one kind, it is that kind.
///
/// # Errors
/// The knowledge base lacks the rule `turning-zone` or a row of it.
pub fn together(parts: &[(ZoneKind, Bounds)], knowledge: &Knowledge) -> Result<ClassifiedZone, KnowledgeError> {
    let has = |kind| parts.iter().any(|(one, _)| *one == kind);
    let kinds = match (has(ZoneKind::Open), has(ZoneKind::HalfOpen), has(ZoneKind::Closed)) {
        (true, true, true) => ZoneParts::AllThree,
        (true, true, false) => ZoneParts::OpenAndHalfOpen,
        (true, false, true) => ZoneParts::OpenAndClosed,
        (false, true, true) => ZoneParts::HalfOpenAndClosed,
        _ => ZoneParts::Alone,
    };
    let first = parts.first().map_or(Bounds { ahead: false, behind: false }, |(_, bounds)| *bounds);
    let any = |of: fn(&Bounds) -> bool| parts.iter().any(|(_, bounds)| of(bounds));
    let all = Bounds { ahead: any(|one| one.ahead), behind: any(|one| one.behind) };
    kind(kinds, if kinds == ZoneParts::Alone { first } else { all }, knowledge)
}

fn kind(parts: ZoneParts, bounds: Bounds, knowledge: &Knowledge) -> Result<ClassifiedZone, KnowledgeError> {
    let question = TurningZoneFor { parts, face_ahead: bounds.ahead, face_behind: bounds.behind };
    let asked = knowledge.ask(&question)?;
    let kind = asked.need(parts.name())?.zone;
    let because = Because::answer(&asked.answer, Note::new("zone-is").with("kind", Figure::word(kind.name())));
    Ok(ClassifiedZone { kind, parts, because })
}

/// What decides the scheme besides the kind of the zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Circumstances {
    /// Whether the contour has other elements than cylinders and faces.
    pub shaped: bool,
    /// Whether the blank has nearly the shape of the part.
    pub near_part: bool,
    /// Whether it is turned against a stop.
    pub against_stop: bool,
}

/// The schemes of a zone.
#[derive(Clone, Debug, Serialize)]
pub struct SchemeChoice {
    /// The schemes, in the order of work; more than one if the zone is worked in parts.
    pub schemes: Vec<Scheme>,
    /// Schemes that may be used instead.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub also: Vec<Scheme>,
    /// The order of work in its parts.
    pub parts_worked: PartsWorked,
    /// `through-air` or `along-contour`.
    pub return_way: String,
    /// The reason.
    pub because: Because,
}

/// The schemes for a kind of zone.
///
/// # Errors
/// The knowledge base lacks the rule `turning-scheme` or a row of it.
pub fn scheme(
    classified: &ClassifiedZone,
    circumstances: Circumstances,
    knowledge: &Knowledge,
) -> Result<SchemeChoice, KnowledgeError> {
    let name = classified.kind.name();
    let asked = knowledge.ask(&TurningSchemeFor {
        zone: classified.kind,
        parts: classified.parts,
        contour: if circumstances.shaped { ContourShape::Shaped } else { ContourShape::Stepped },
        against_stop: circumstances.against_stop,
        blank_shape: if circumstances.near_part { BlankShape::NearPart } else { BlankShape::Bar },
    })?;
    let rule = asked.need(name)?;
    Ok(SchemeChoice {
        schemes: rule.schemes,
        also: rule.also.unwrap_or_default(),
        parts_worked: rule.parts_worked,
        return_way: rule.return_way.to_owned(),
        because: Because::answer(&asked.answer, Note::new("zone-scheme").with("kind", Figure::word(name))),
    })
}
