//! Why a program is not written.

use crate::note::Note;
use crate::turning::contour::{Curve, Piece};
use crate::turning::length::Half;
use crate::units::MillimetresPerRev;

use super::cycle::Direction;

/// Why a program is not written. [`NotWritten::note`] is its sentence; `report::sentence` and `report::remedy` have the
/// words. Pieces and moves are counted from 1.
#[derive(Clone, Debug, PartialEq)]
pub enum NotWritten {
    /// The language of the control is not known well enough.
    NotDocumented {
        /// The control.
        control: String,
        /// Its words that are known by name only.
        words: Vec<String>,
    },
    /// The toolpath has no move.
    EmptyWay,
    /// The contour has no piece.
    EmptyContour,
    /// A piece does not begin where the one before it ends.
    Apart {
        /// The piece.
        piece: usize,
    },
    /// An arc of no radius.
    ArcWithoutRadius {
        /// The piece or move.
        piece: usize,
    },
    /// An arc whose radius is less than half the distance of its ends.
    ArcTooSmall {
        /// The piece or move.
        piece: usize,
        /// Its radius.
        radius: Half,
        /// The least radius.
        needed: Half,
    },
    /// A rapid along an arc.
    RapidArc {
        /// The move.
        piece: usize,
    },
    /// The words of the control for a tap are not known.
    NoTapping,
    /// The tool has the number 0.
    NoTool,
    /// A speed that is not above 0.
    NoSpeed,
    /// A tool whose cutting conditions are not known.
    NoConditions {
        /// Its place.
        tool: u32,
    },
    /// A feed that is not above 0.
    NoFeed {
        /// The feed.
        feed: MillimetresPerRev,
    },
    /// A contour on which the cycle would have to go back.
    NotMonotone {
        /// The piece.
        piece: usize,
        /// The direction of the passes.
        direction: Direction,
    },
    /// A contour that reaches beyond the blank.
    BeyondBlank {
        /// The radius of the blank.
        blank: Half,
        /// The radius of the contour.
        contour: Half,
    },
    /// A contour that begins before the face of the blank.
    BeforeFace,
    /// A contour that begins on the surface of the blank or ends at its face, so that nothing can be cut.
    NothingToCut,
    /// A depth or a distance that is not above 0.
    NotAboveZero {
        /// Its name.
        name: &'static str,
    },
    /// A retract that would lead back into the blank, because the cycle begins nearer to it.
    RetractBeyondClearance {
        /// The retract.
        retract: Half,
        /// The clearance.
        clearance: Half,
    },
    /// A bore in which there is no room for the clearance.
    BoreTooNarrow {
        /// The radius of the bore.
        bore: Half,
        /// The clearance.
        clearance: Half,
    },
    /// The tool would go to the axis, where the tailstock centre is.
    ThroughCentre,
    /// The proof found that it would damage the part or hit something.
    Unsafe {
        /// The first finding of the proof.
        why: Note,
    },
    /// The cycle does not leave an allowance.
    Allowance {
        /// The control.
        control: String,
    },
}

impl NotWritten {
    /// Whether the plan itself is at fault, and not what is asked for: something is found wrong.
    pub const fn is_found(&self) -> bool {
        matches!(self, Self::ThroughCentre | Self::Unsafe { .. } | Self::NoConditions { .. })
    }

    /// It as a sentence.
    pub fn note(&self) -> Note {
        match self {
            Self::NotDocumented { control, words } => {
                Note::new("lathe-language-not-documented").with("control", control).with("words", words.join(", "))
            }
            Self::EmptyWay => Note::new("lathe-way-empty"),
            Self::EmptyContour => Note::new("lathe-contour-empty"),
            Self::Apart { piece } => Note::new("lathe-contour-apart").with("piece", piece),
            Self::ArcWithoutRadius { piece } => Note::new("lathe-arc-without-radius").with("piece", piece),
            Self::ArcTooSmall { piece, radius, needed } => {
                Note::new("lathe-arc-too-small").with("piece", piece).with("radius", radius).with("needed", needed)
            }
            Self::RapidArc { piece } => Note::new("lathe-rapid-arc").with("piece", piece),
            Self::NoTapping => Note::new("lathe-no-tapping"),
            Self::NoTool => Note::new("lathe-no-tool"),
            Self::NoSpeed => Note::new("lathe-no-speed"),
            Self::NoConditions { tool } => Note::new("lathe-no-conditions").with("tool", tool),
            Self::NoFeed { feed } => Note::new("lathe-no-feed").with("feed", feed.0),
            Self::NotMonotone { piece, direction: Direction::Longitudinal } => {
                Note::new("lathe-contour-turns-back").with("piece", piece)
            }
            Self::NotMonotone { piece, direction: Direction::Facing } => {
                Note::new("lathe-contour-falls").with("piece", piece)
            }
            Self::BeyondBlank { blank, contour } => Note::new("lathe-contour-beyond-blank")
                .with("blank", blank.diameter())
                .with("diameter", contour.diameter()),
            Self::BeforeFace => Note::new("lathe-contour-before-face"),
            Self::NothingToCut => Note::new("lathe-nothing-to-cut"),
            Self::NotAboveZero { name } => Note::new("lathe-not-above-zero").with("key", name),
            Self::RetractBeyondClearance { retract, clearance } => {
                Note::new("lathe-retract-beyond-clearance").with("retract", retract).with("clearance", clearance)
            }
            Self::BoreTooNarrow { bore, clearance } => {
                Note::new("lathe-bore-too-narrow").with("bore", bore.diameter()).with("clearance", clearance)
            }
            Self::ThroughCentre => Note::new("lathe-through-centre"),
            Self::Unsafe { why } => Note::new("lathe-unsafe").with("why", why.clone()),
            Self::Allowance { control } => Note::new("lathe-allowance").with("control", control),
        }
    }
}

/// Whether an arc can be written, by its number; a line always can.
///
/// # Errors
/// It has no radius, or one less than half the distance of its ends by more than their rounding.
pub(super) fn check_arc(piece: Piece, number: usize) -> Result<(), NotWritten> {
    let Curve::Arc { radius, .. } = piece.curve else { return Ok(()) };
    // Both ends are rounded to half a micrometre along both axes.
    let rounding = 0.001;
    let half = piece.chord().length() / 2.0;
    if radius <= Half::ZERO {
        return Err(NotWritten::ArcWithoutRadius { piece: number });
    }
    if radius.to_mm() + rounding < half {
        return Err(NotWritten::ArcTooSmall { piece: number, radius, needed: Half::from(half) });
    }
    Ok(())
}
