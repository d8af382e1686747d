//! What kind of zone something is, and by which schemes it is worked: the rules `turning-zone` and `turning-scheme`, asked
//! for stepped shafts and for contours of any shape.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::{Answer, Input, Knowledge};
use crate::note::{Because, Note};

/// Kinds of zones (lecture 12.3, l. 221-269), in the order of fig. 12.3.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Free on both sides.
    Open,
    /// Bounded on one side.
    HalfOpen,
    /// Bounded on both.
    Closed,
    /// Of two or three kinds.
    Combined,
}

impl Kind {
    const ALL: [Self; 4] = [Self::Open, Self::HalfOpen, Self::Closed, Self::Combined];

    /// Its name in rules and outputs.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::HalfOpen => "half-open",
            Self::Closed => "closed",
            Self::Combined => "combined",
        }
    }
}

/// What bounds a zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// A face, slope or stock ahead of the tool.
    pub ahead: bool,
    /// A face or slope behind it.
    pub behind: bool,
}

/// A kind with its reason.
#[derive(Clone, Debug)]
pub struct KindFound {
    /// The kind.
    pub kind: Kind,
    /// What its parts are called in both rules.
    pub parts: &'static str,
    /// The row.
    pub because: Because,
}

/// The kind of a zone that is no combination.
///
/// # Errors
/// The knowledge base lacks the rule `turning-zone` or a row of it.
pub fn alone(bounds: Bounds, knowledge: &Knowledge) -> Result<KindFound, KnowledgeError> {
    kind("alone", bounds, knowledge)
}

/// The kind of a zone that consists of zones with these kinds and bounds. Of one kind they remain what they are.
///
/// # Errors
/// The knowledge base lacks the rule `turning-zone` or a row of it.
pub fn together(parts: &[(Kind, Bounds)], knowledge: &Knowledge) -> Result<KindFound, KnowledgeError> {
    let has = |kind| parts.iter().any(|(one, _)| *one == kind);
    let name = match (has(Kind::Open), has(Kind::HalfOpen), has(Kind::Closed)) {
        (true, true, true) => "all-three",
        (true, true, false) => "open-and-half-open",
        (true, false, true) => "open-and-closed",
        (false, true, true) => "half-open-and-closed",
        _ => "alone",
    };
    let first = parts.first().map_or(Bounds { ahead: false, behind: false }, |(_, bounds)| *bounds);
    let any = |of: fn(&Bounds) -> bool| parts.iter().any(|(_, bounds)| of(bounds));
    let all = Bounds { ahead: any(|one| one.ahead), behind: any(|one| one.behind) };
    kind(name, if name == "alone" { first } else { all }, knowledge)
}

fn kind(parts: &'static str, bounds: Bounds, knowledge: &Knowledge) -> Result<KindFound, KnowledgeError> {
    let rule = knowledge.table("turning-zone")?;
    let answer = rule.decide(&[
        ("parts", Input::Text(parts)),
        ("face_ahead", Input::Bool(bounds.ahead)),
        ("face_behind", Input::Bool(bounds.behind)),
    ])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, parts))?;
    let name = row.text("zone")?;
    let found = Kind::ALL.into_iter().find(|kind| kind.name() == name);
    let kind = found.ok_or_else(|| KnowledgeError::no_row(rule, name))?;
    let because = Because::answer(&answer, Note::new("zone-is").with("kind", name));
    Ok(KindFound { kind, parts, because })
}

/// What a scheme depends on besides the kind of the zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Circumstances {
    /// Whether the contour has anything but cylinders and faces.
    pub shaped: bool,
    /// Whether the blank has nearly the shape of the part.
    pub near_part: bool,
    /// Whether it is turned against a stop.
    pub against_stop: bool,
}

/// How a zone is worked.
#[derive(Clone, Debug, Serialize)]
pub struct SchemeChoice {
    /// The schemes, in the order of work; more than one where the zone is worked in parts.
    pub schemes: Vec<String>,
    /// Schemes that may be used instead.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub also: Vec<String>,
    /// `whole`, `each` part after part, or `joined`: all but the closed parts as one, these by themselves.
    pub parts_worked: String,
    /// `through-air` or `along-contour`.
    pub return_way: String,
    /// Why.
    pub because: Because,
}

/// The schemes for a kind of zone.
///
/// # Errors
/// The knowledge base lacks the rule `turning-scheme` or a row of it.
pub fn scheme(
    found: &KindFound,
    circumstances: Circumstances,
    knowledge: &Knowledge,
) -> Result<SchemeChoice, KnowledgeError> {
    let rule = knowledge.table("turning-scheme")?;
    let name = found.kind.name();
    let answer: Answer<'_> = rule.decide(&[
        ("zone", Input::Text(name)),
        ("parts", Input::Text(found.parts)),
        ("contour", Input::Text(if circumstances.shaped { "shaped" } else { "stepped" })),
        ("blank_shape", Input::Text(if circumstances.near_part { "near-part" } else { "bar" })),
        ("against_stop", Input::Bool(circumstances.against_stop)),
    ])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, name))?;
    let texts = |column| -> Result<Vec<String>, KnowledgeError> {
        Ok(row.texts(column)?.into_iter().map(str::to_owned).collect())
    };
    let because = Because::answer(&answer, Note::new("zone-scheme").with("kind", name));
    Ok(SchemeChoice {
        schemes: texts("schemes")?,
        also: if row.value("also").is_some() { texts("also")? } else { Vec::new() },
        parts_worked: row.text("parts_worked")?.to_owned(),
        return_way: row.text("return_way")?.to_owned(),
        because,
    })
}
