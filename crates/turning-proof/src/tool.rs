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

/// The cutting direction of an insert.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hand {
    /// Towards the chuck.
    Right,
    /// Away from the chuck.
    Left,
    /// Both ways.
    Neutral,
}

/// The side where a tool works.
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
        /// φ, between the main edge and the feed along the axis.
        lead_angle: Degrees,
        /// φ1, between the secondary edge and the surface it has made.
        trail_angle: Degrees,
        /// Nose radius; 0 for a sharp point.
        nose_radius: Mm,
        /// Length of both edges from their intersection; the holder begins beyond them.
        edge_length: Mm,
        /// Its cutting direction.
        hand: Hand,
        /// The side where it works.
        side: Side,
    },
    /// A blade for grooves and parting, perpendicular to the axis. Its corner towards the chuck is its programmed
    /// point.
    Blade {
        /// Its width.
        width: Mm,
        /// The radius of its corners.
        corner_radius: Mm,
        /// Its usable depth.
        depth: Mm,
        /// The side where it works.
        side: Side,
    },
    /// A blade for grooves in faces, parallel to the axis.
    FaceBlade {
        /// Its width.
        width: Mm,
        /// The radius of its corners.
        corner_radius: Mm,
        /// Its usable depth.
        depth: Mm,
    },
    /// A sharp point for threads.
    Thread {
        /// Its full angle: 60° for metric threads.
        angle: Degrees,
        /// The distance of the point from its holder.
        reach: Mm,
        /// The distance of the point from the side of the insert, which stands upright towards the chuck. The flank ends there.
        beside: Mm,
        /// The side where it works.
        side: Side,
    },
    /// A drill on the axis.
    Drill {
        /// Its diameter.
        diameter: Mm,
        /// The full angle of its point.
        point_angle: Degrees,
        /// Its usable depth.
        flute: Mm,
    },
    /// A core drill or a reamer on the axis: its front is narrower by its lead.
    Reamer {
        /// Its diameter.
        diameter: Mm,
        /// The diameter of its front.
        front: Mm,
        /// The length of its lead.
        lead: Mm,
        /// Its usable depth.
        reach: Mm,
    },
    /// A tap on the axis: its lead cuts, its thread follows.
    Tap {
        /// The nominal diameter of its thread.
        diameter: Mm,
        /// Its pitch.
        pitch: Mm,
        /// The diameter of its front and its core: the hole for it is wider.
        core: Mm,
        /// The length of its lead, behind which the thread is full.
        lead: Mm,
        /// The length of its thread, with the lead.
        thread: Mm,
        /// Where its shank begins, behind thread and neck.
        neck: Mm,
        /// The diameter of its shank.
        shank: Mm,
        /// From its front to its chuck.
        free: Mm,
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
    /// The radius of the shank of a tool on the axis, and where it begins behind the point; none of other tools and of taps, whose
    /// shank is a body of its own.
    pub(crate) fn shank_on_axis(&self) -> Option<(f64, f64)> {
        match *self {
            Self::Drill { diameter, flute, .. } => Some((diameter.0 / 2.0, flute.0)),
            Self::Reamer { diameter, reach, .. } => Some((diameter.0 / 2.0, reach.0)),
            Self::CentreDrill { pilot, pilot_length, body } => {
                let (pilot, body) = (pilot.0 / 2.0, body.0 / 2.0);
                Some((body, pilot_length.0 + (body - pilot) / libm::tan(30_f64.to_radians())))
            }
            _ => None,
        }
    }

    /// The largest radius that it can leave in an inner corner: its nose or the corner of its blade.
    pub const fn nose_radius(&self) -> Mm {
        match *self {
            Self::Insert { nose_radius, .. } => nose_radius,
            Self::Blade { corner_radius, .. } | Self::FaceBlade { corner_radius, .. } => corner_radius,
            Self::Thread { .. }
            | Self::Drill { .. }
            | Self::Reamer { .. }
            | Self::Tap { .. }
            | Self::CentreDrill { .. } => Mm(0.0),
        }
    }

    /// The side where it works, if it is one of the sides.
    pub(crate) const fn side(&self) -> Option<Side> {
        match *self {
            Self::Insert { side, .. } | Self::Blade { side, .. } | Self::Thread { side, .. } => Some(side),
            Self::FaceBlade { .. }
            | Self::Drill { .. }
            | Self::Reamer { .. }
            | Self::Tap { .. }
            | Self::CentreDrill { .. } => None,
        }
    }

    pub(crate) const fn turns_on_axis(&self) -> bool {
        matches!(self, Self::Drill { .. } | Self::Reamer { .. } | Self::Tap { .. } | Self::CentreDrill { .. })
    }
}

/// The holder of a cutter, in the plane of its edge. Cutter and holder are joined by the hull of both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Holder {
    /// None that could touch anything: drills have their own shank.
    None,
    /// A square shank perpendicular to the axis. It begins at the ends of the edges.
    Shank {
        /// Its width, along the axis.
        width: Mm,
        /// From the point to its side towards the chuck, away from the chuck (for left-hand tools: the other way
        /// round).
        set_back: Mm,
    },
    /// A bar parallel to the axis. It begins at the ends of the edges.
    Bar {
        /// Its diameter.
        diameter: Mm,
        /// The distance of the point beyond its side.
        stands_out: Mm,
    },
}

impl Holder {
    /// The shank of an insert's holder. The point is at f from its back, which ISO 5608 makes a quarter more than its
    /// width (16: 20, 20: 25, 25: 32, 32: 40 mm); for a neutral one in its middle.
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

    /// A boring bar by its diameter and the smallest bore that it enters. Of the clearance in that bore four fifths
    /// are on the side of the point, one fifth is behind the bar (bars of ISO 6261: 3 of 4 mm for 16 in 20, 6 of 8
    /// for 32 in 40).
    pub fn bar(diameter: Mm, smallest_bore: Mm) -> Self {
        Self::Bar { diameter, stands_out: Mm((smallest_bore.0 - diameter.0).max(0.0) * 0.8) }
    }
}

/// A tool.
#[derive(Clone, Debug, PartialEq)]
pub struct Tool {
    /// Its designation, by which findings name it.
    pub designation: String,
    /// The cutting part.
    pub cutter: Cutter,
    /// Its holder.
    pub holder: Holder,
}

impl Tool {
    pub(crate) const fn is_tap(&self) -> bool {
        matches!(self.cutter, Cutter::Tap { .. })
    }
}
