//! The input of the proof: one set-up, in its own coordinates.

use crate::note::Figure;
use crate::plane::{Vector, chords, turned};
use crate::stock::Stock;
use crate::tool::Tool;
use crate::units::{At, Block, Degrees, Mm};

/// The direction of an arc, with Z to the right and the radius up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// To the right.
    Clockwise,
    /// To the left.
    Counterclockwise,
}

/// A line or an arc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// Straight.
    Line {
        /// Its beginning.
        from: At,
        /// Its end.
        to: At,
    },
    /// Around a centre; a whole circle if both ends are one place.
    Arc {
        /// Its beginning.
        from: At,
        /// Its end.
        to: At,
        /// Its centre.
        centre: At,
        /// Its direction.
        sense: Sense,
    },
}

impl Piece {
    /// Its beginning.
    pub const fn from(&self) -> At {
        match self {
            Self::Line { from, .. } | Self::Arc { from, .. } => *from,
        }
    }

    /// Its end.
    pub const fn to(&self) -> At {
        match self {
            Self::Line { to, .. } | Self::Arc { to, .. } => *to,
        }
    }

    /// Lines from place to place.
    pub fn lines(places: &[At]) -> Vec<Self> {
        places.windows(2).map(|pair| Self::Line { from: pair[0], to: pair[1] }).collect()
    }

    /// The ends of its chords, its beginning first.
    pub(crate) fn spots(&self) -> Vec<Vector> {
        let (from, to) = (self.from().spot(), self.to().spot());
        let mut spots = vec![from];
        match self {
            Self::Line { .. } => spots.push(to),
            Self::Arc { centre, sense, .. } => {
                let centre = centre.spot();
                let angle = turned(centre, from, to, *sense == Sense::Counterclockwise);
                spots.extend(chords(centre, from, to, angle));
            }
        }
        spots
    }

    pub(crate) fn places(&self) -> Vec<At> {
        match *self {
            Self::Line { from, to } => vec![from, to],
            Self::Arc { from, to, centre, .. } => vec![from, to, centre],
        }
    }
}

/// The crests and roots of a thread. Its passes may go down to the root over its length and a little beyond both
/// ends, and where it has no relief over its run-out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thread {
    /// The radius of its crests, to which its cylinder is turned before.
    pub crest: Mm,
    /// The radius that its deepest pass must reach: the pitch diameter with the most metal that its tolerance allows.
    pub shallow: Mm,
    /// The radius that no pass may go beyond: the pitch diameter with the least metal.
    pub root: Mm,
    /// Its pitch, by which its passes are fed.
    pub pitch: Mm,
    /// How far its passes may cut into the metal towards the chuck; 0 where it ends in a relief.
    pub run_out: Mm,
    /// What a tap must meet; none for a thread outside.
    pub tap: Option<TapLimits>,
}

/// A thread in a hole as a tap cuts it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TapLimits {
    /// Its nominal diameter.
    pub diameter: Mm,
    /// Its pitch.
    pub pitch: Mm,
    /// The largest minor diameter that its tolerance allows.
    pub largest_hole: Mm,
    /// How far behind the thread the tap may cut into the wall of the hole.
    pub run_out: Mm,
}

/// The limits of a size, between which its cylinder or face is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// What is measured.
    pub size: Size,
    /// The least size.
    pub least: Mm,
    /// The largest size.
    pub most: Mm,
}

/// A size that has limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Size {
    /// The diameter of a cylinder.
    Diameter,
    /// The distance of a face from a Z, towards the chuck or away from it.
    Length {
        /// That Z.
        from: Mm,
        /// Whether it is measured towards the chuck.
        to_chuck: bool,
    },
}

impl Limits {
    /// Where a size lies: a radius, or a Z, mm.
    pub(crate) fn place(&self, size: f64) -> f64 {
        match self.size {
            Size::Diameter => size / 2.0,
            Size::Length { from, to_chuck: true } => from.0 - size,
            Size::Length { from, to_chuck: false } => from.0 + size,
        }
    }

    /// The size of something that lies there.
    pub(crate) fn size(&self, place: f64) -> f64 {
        match self.size {
            Size::Diameter => 2.0 * place,
            Size::Length { from, to_chuck: true } => from.0 - place,
            Size::Length { from, to_chuck: false } => place - from.0,
        }
    }

    /// The coordinate that it is of.
    pub(crate) const fn of(&self, spot: Vector) -> f64 {
        match self.size {
            Size::Diameter => spot.r,
            Size::Length { .. } => spot.z,
        }
    }
}

/// A piece of the finished part's contour.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfilePiece {
    /// Its shape.
    pub path: Piece,
    /// The surface that it belongs to: a name of the user's, or a word. Findings name it.
    pub surface: Option<Figure>,
    /// The allowance over it for another machine, along its normal.
    pub allowance: Mm,
    /// The thread on it, if it is a cylinder with one.
    pub thread: Option<Thread>,
    /// The limits of its size, if it is a cylinder or a face with some; without them it is held to what is drawn.
    pub limits: Option<Limits>,
}

impl ProfilePiece {
    /// A piece without allowance and thread.
    pub const fn new(path: Piece, surface: Option<Figure>) -> Self {
        Self { path, surface, allowance: Mm(0.0), thread: None, limits: None }
    }
}

/// The finished part within the range of the set-up: between both chains, or between the outer one and the axis.
///
/// Each chain runs from the free end towards the chuck, piece after piece. If the outer chain begins on the axis it
/// includes the face of the free end. If a chain ends off the axis and off the other chain, the part continues into
/// the chuck: metal beyond belongs to another set-up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Profile {
    /// The outer chain.
    pub outside: Vec<ProfilePiece>,
    /// The chain of the bore; a blind one ends on the axis. Empty if there is none.
    pub bore: Vec<ProfilePiece>,
}

/// A body that no tool may touch: jaws, a quill with its centre, a steady rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Its name: one of the user's, or a word.
    pub name: Figure,
    /// Its outline, corner after corner.
    pub outline: Vec<At>,
}

/// The kind of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionKind {
    /// At rapid.
    Rapid,
    /// At feed.
    Feed,
    /// A pass of a thread, at its pitch.
    Thread,
}

/// A motion of a tool's reference point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Its kind.
    pub kind: MotionKind,
    /// Its path.
    pub path: Piece,
    /// The index of its tool in [`SetUp::tools`].
    pub tool: usize,
    /// Its travel per turn of the spindle, in step with it or as its feed; none where the feed is by time.
    pub lead: Option<Mm>,
    /// Of a pass of a thread: how far the spindle turns on from its mark before it starts.
    pub start: Degrees,
    /// Its block in the program.
    pub block: Block,
}

/// A change of tools by turning the turret.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Indexed {
    /// How many motions are made before it.
    pub after: usize,
    /// The index of the tool that worked until then.
    pub tool: usize,
    /// Where that stands.
    pub at: At,
    /// The block.
    pub block: Block,
}

/// How near the stock a turret turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IndexedNear {
    /// The block.
    pub block: Block,
    /// The index of the tool that worked until then.
    pub tool: usize,
    /// Its distance from the stock, mm.
    pub distance: Mm,
}

/// The complete input of a proof.
#[derive(Clone, Debug, Default)]
pub struct SetUp {
    /// The finished part.
    pub profile: Profile,
    /// The whole of it, where the profile is the stretch that this set-up makes: no later one puts metal back.
    pub finished: Option<Profile>,
    /// The stock before: the blank, or the remaining metal of the previous set-up.
    pub stock: Stock,
    /// Obstacles: jaws, centres, steady rests.
    pub bodies: Vec<Body>,
    /// The tools.
    pub tools: Vec<Tool>,
    /// Their motions, in the order of the program.
    pub motions: Vec<Motion>,
    /// The changes between them whose distance from the stock is measured.
    pub indexed: Vec<Indexed>,
    /// Whether the cuts are measured, too: it takes most of the time of a proof, and who planned them knows them.
    pub measures_cuts: bool,
}
