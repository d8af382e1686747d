//! Tools: cutting edges, holders, and reference points.
//!
//! | cutter | reference point |
//! |---|---|
//! | insert | its theoretical point: where the tangents to the nose across and along the axis meet |
//! | neutral insert | the lowest point of the nose |
//! | blade | its corner towards the chuck, as a theoretical point |
//! | face blade | its corner towards the axis, as a theoretical point |
//! | thread insert | the sharp point of its profile |
//! | drill, centre drill | its point on the axis |

mod outline;

pub(crate) use outline::Outline;

use crate::units::{Degrees, Mm};

/// Which way an insert cuts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hand {
    /// Towards the chuck.
    Right,
    /// Away from the chuck.
    Left,
    /// Both ways.
    Neutral,
}

/// Where a tool works.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Its point looks towards the axis.
    Outside,
    /// Its point looks away from the axis.
    Inside,
}

/// The cutting part of a tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cutter {
    /// A turning insert.
    Insert {
        /// φ, between the main edge and the feed along the axis; beyond 90° the edge leans back.
        lead_angle: Degrees,
        /// φ1, between the edge behind the nose and the surface it has made.
        trail_angle: Degrees,
        /// Nose radius; 0 for a sharp point.
        nose_radius: Mm,
        /// Length of both edges from where they would meet; what lies beyond them is the holder's.
        edge_length: Mm,
        /// Which way it cuts.
        hand: Hand,
        /// Where it works.
        side: Side,
    },
    /// A blade for grooves and parting, across the axis. Its corner at the chuck is its programmed point.
    Blade {
        /// Its width.
        width: Mm,
        /// The radius of its corners.
        corner_radius: Mm,
        /// How deep it reaches.
        depth: Mm,
        /// Where it works.
        side: Side,
    },
    /// A blade for grooves in faces, along the axis.
    FaceBlade {
        /// Its width.
        width: Mm,
        /// The radius of its corners.
        corner_radius: Mm,
        /// How deep it reaches.
        depth: Mm,
    },
    /// A sharp point for threads.
    Thread {
        /// Its whole angle: 60° of metric threads.
        angle: Degrees,
        /// How far the point stands out of its holder.
        reach: Mm,
        /// Where it works.
        side: Side,
    },
    /// A drill on the axis.
    Drill {
        /// Its diameter.
        diameter: Mm,
        /// The whole angle of its point.
        point_angle: Degrees,
        /// How deep it cuts.
        flute: Mm,
    },
    /// A centre drill with its 60° cone.
    CentreDrill {
        /// The diameter of its pilot.
        pilot: Mm,
        /// The length of the pilot, with its point.
        pilot_length: Mm,
        /// The diameter of its body.
        body: Mm,
    },
}

impl Cutter {
    /// The largest radius that it can leave in an inner corner: its nose or the corner of its blade.
    pub const fn nose_radius(&self) -> Mm {
        match *self {
            Self::Insert { nose_radius, .. } => nose_radius,
            Self::Blade { corner_radius, .. } | Self::FaceBlade { corner_radius, .. } => corner_radius,
            Self::Thread { .. } | Self::Drill { .. } | Self::CentreDrill { .. } => Mm(0.0),
        }
    }

    pub(crate) const fn turns_on_axis(&self) -> bool {
        matches!(self, Self::Drill { .. } | Self::CentreDrill { .. })
    }
}

/// What holds a cutter, as it lies in the plane of its edge. Cutter and holder are joined by the hull of both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Holder {
    /// None that could touch anything: drills have their own shank.
    None,
    /// A square shank across the axis. It begins as far behind the point as the edges reach.
    Shank {
        /// Its width, along the axis.
        width: Mm,
        /// From the point to its side towards the chuck, away from the chuck (for left hands: the other way round).
        set_back: Mm,
    },
    /// A bar along the axis. It begins as far behind the point as the edges reach.
    Bar {
        /// Its diameter.
        diameter: Mm,
        /// How far the point stands out beyond its side.
        stands_out: Mm,
    },
}

impl Holder {
    /// The shank of an insert's holder. The point lies f from its back, which ISO 5608 makes a quarter more than its width
    /// (16: 20, 20: 25, 25: 32, 32: 40 mm); that of a neutral one in its middle.
    pub fn shank(width: Mm, hand: Hand) -> Self {
        let set_back = match hand {
            Hand::Neutral => -width.0 / 2.0,
            Hand::Right | Hand::Left => width.0 / 4.0,
        };
        Self::Shank { width, set_back: Mm(set_back) }
    }

    /// The shank of a blade's holder: flush with the blade.
    pub const fn shank_of_blade(width: Mm) -> Self {
        Self::Shank { width, set_back: Mm(0.0) }
    }

    /// A boring bar by its diameter and the smallest bore that it enters. Of the room over in that bore four fifths are on the
    /// side of the point, a fifth is left behind the bar (bars of ISO 6261: 3 of 4 mm for 16 in 20, 6 of 8 for 32 in 40).
    pub fn bar(diameter: Mm, smallest_bore: Mm) -> Self {
        Self::Bar { diameter, stands_out: Mm((smallest_bore.0 - diameter.0).max(0.0) * 0.8) }
    }
}

/// A tool.
#[derive(Clone, Debug, PartialEq)]
pub struct Tool {
    /// Its designation, by which findings name it.
    pub designation: String,
    /// What of it cuts.
    pub cutter: Cutter,
    /// What holds that.
    pub holder: Holder,
}
