//! Why a program is not written.

use crate::note::Note;
use crate::turning::contour::{Curve, Piece};
use crate::turning::length::Half;
use crate::turning::reasons::reasons;
use crate::units::MillimetresPerRev;

reasons! {
    /// Why a program is not written. [`NotWritten::note`] is its sentence; `report::sentence` and `report::remedy` have the
    /// words. Pieces and moves are counted from 1.
    #[derive(Clone, Debug, PartialEq)]
    pub enum NotWritten {
        /// The language of the control is not known well enough.
        NotDocumented {
            /// The control.
            control: String,
            /// Its words that are known by name only.
            words: Vec<String> as words.join(", "),
        } = note!("lathe-language-not-documented"),
        /// The toolpath has no move.
        EmptyWay = note!("lathe-way-empty"),
        /// The contour has no piece.
        EmptyContour = note!("lathe-contour-empty"),
        /// A piece does not begin where the one before it ends.
        Apart {
            /// The piece.
            piece: usize,
        } = note!("lathe-contour-apart"),
        /// An arc of no radius.
        ArcWithoutRadius {
            /// The piece or move.
            piece: usize,
        } = note!("lathe-arc-without-radius"),
        /// An arc whose radius is less than half the distance of its ends.
        ArcTooSmall {
            /// The piece or move.
            piece: usize,
            /// Its radius.
            radius: Half,
            /// The least radius.
            needed: Half,
        } = note!("lathe-arc-too-small"),
        /// A rapid along an arc.
        RapidArc {
            /// The move.
            piece: usize,
        } = note!("lathe-rapid-arc"),
        /// The words of the control for a tap are not known.
        NoTapping = note!("lathe-no-tapping"),
        /// The tool has the number 0.
        NoTool = note!("lathe-no-tool"),
        /// A speed that is not above 0.
        NoSpeed = note!("lathe-no-speed"),
        /// A tool whose cutting conditions are not known.
        NoConditions {
            /// Its place.
            tool: u32,
        } = note!("lathe-no-conditions"),
        /// A feed that is not above 0.
        NoFeed {
            /// The feed.
            feed: MillimetresPerRev as feed.0,
        } = note!("lathe-no-feed"),
        /// A contour on which a cycle along the axis would have to go back.
        TurnsBack {
            /// The piece.
            piece: usize,
        } = note!("lathe-contour-turns-back"),
        /// A contour on which a cycle across the axis would have to go back.
        Falls {
            /// The piece.
            piece: usize,
        } = note!("lathe-contour-falls"),
        /// A contour that reaches beyond the blank.
        BeyondBlank {
            /// The radius of the blank.
            blank: Half as blank.diameter(),
            /// The radius of the contour.
            diameter: Half as diameter.diameter(),
        } = note!("lathe-contour-beyond-blank"),
        /// A contour that begins before the face of the blank.
        BeforeFace = note!("lathe-contour-before-face"),
        /// A contour that begins on the surface of the blank or ends at its face, so that nothing can be cut.
        NothingToCut = note!("lathe-nothing-to-cut"),
        /// A depth or a distance that is not above 0.
        NotAboveZero {
            /// Its name.
            key: &'static str,
        } = note!("lathe-not-above-zero"),
        /// A retract that would lead back into the blank, because the cycle begins nearer to it.
        RetractBeyondClearance {
            /// The retract.
            retract: Half,
            /// The clearance.
            clearance: Half,
        } = note!("lathe-retract-beyond-clearance"),
        /// A bore in which there is no room for the clearance.
        BoreTooNarrow {
            /// The radius of the bore.
            bore: Half as bore.diameter(),
            /// The clearance.
            clearance: Half,
        } = note!("lathe-bore-too-narrow"),
        /// The tool would go to the axis, where the tailstock centre is.
        ThroughCentre = note!("lathe-through-centre"),
        /// The proof found that it would damage the part or hit something.
        Unsafe {
            /// The first finding of the proof.
            why: Note as why.clone(),
        } = note!("lathe-unsafe"),
        /// The cycle does not leave an allowance.
        Allowance {
            /// The control.
            control: String,
        } = note!("lathe-allowance"),
    }
}

impl NotWritten {
    /// Whether the plan itself is at fault, and not what is asked for: something is found wrong.
    pub const fn is_found(&self) -> bool {
        matches!(self, Self::ThroughCentre | Self::Unsafe { .. } | Self::NoConditions { .. })
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
