//! Contours of cycles: lines and arcs in the half-plane, in a frame where passes go towards smaller `z` and get
//! deeper towards smaller `x`. The variants outside and inside, along and across, are rotations of this frame.

/// Lengths that differ by less are equal, mm.
pub(super) const SAME: f64 = 1e-6;

/// A point: `z` along the passes, `x` perpendicular to them, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct PassPoint {
    pub z: f64,
    pub x: f64,
}

impl PassPoint {
    pub fn to(self, other: Self) -> f64 {
        libm::hypot(other.z - self.z, other.x - self.x)
    }
}

/// The centre of an arc and its sense; counterclockwise with z to the right and x upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Round {
    pub centre: PassPoint,
    pub ccw: bool,
}

/// An element of a contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Leg {
    pub from: PassPoint,
    pub to: PassPoint,
    pub round: Option<Round>,
    /// Whether the program has it as a rapid.
    pub rapid: bool,
    /// The feed that the program gives in its block, where it gives one.
    pub feed: Option<f64>,
    /// The line of the program.
    pub line: u32,
}

impl Leg {
    /// Whether z never increases along it and, for an arc, x turns at most at a quadrant point: the elements that a
    /// pass can meet.
    pub fn is_monotone(&self) -> bool {
        let fine = 1e-3;
        let Some(round) = self.round else { return self.to.z - self.from.z <= fine };
        let (entry, exit) = (self.from.x - round.centre.x, self.to.x - round.centre.x);
        let falls = self.to.z - self.from.z <= -fine;
        let upper = if round.ccw { (entry, exit) } else { (-entry, -exit) };
        falls && upper.0 >= -fine && upper.1 >= -fine
    }

    /// The crossings with the height x, from large z to small, or in the direction of the line if it lies at that
    /// height.
    pub fn crossings(&self, x: f64) -> Vec<f64> {
        let Some(round) = self.round else {
            let (low, high) = (self.from.x.min(self.to.x), self.from.x.max(self.to.x));
            if low > x + SAME || high < x - SAME {
                return Vec::new();
            }
            if high - low < SAME {
                return vec![self.from.z, self.to.z];
            }
            return vec![self.from.z + (x - self.from.x) / (self.to.x - self.from.x) * (self.to.z - self.from.z)];
        };
        let radius = self.from.to(round.centre);
        let square = radius * radius - (x - round.centre.x) * (x - round.centre.x);
        if square < -SAME {
            return Vec::new();
        }
        let half = libm::sqrt(square.max(0.0));
        let candidates = [round.centre.z + half, round.centre.z - half];
        candidates.into_iter().filter(|z| self.is_on(PassPoint { z: *z, x }, round)).collect()
    }

    /// Whether a point of the circle lies between the ends of the arc.
    fn is_on(&self, spot: PassPoint, round: Round) -> bool {
        let cross = |a: PassPoint, b: PassPoint| {
            (a.z - round.centre.z) * (b.x - round.centre.x) - (a.x - round.centre.x) * (b.z - round.centre.z)
        };
        let (after, before) = (cross(self.from, spot), cross(self.to, spot));
        if round.ccw { after >= -SAME && before <= SAME } else { after <= SAME && before >= -SAME }
    }
}

/// The position of the frame of passes in the half-plane of the part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct PassFrame {
    /// Passes across: the axes change places.
    pub across: bool,
    /// Deeper means larger x: inside, or across from the chuck.
    pub mirror_x: bool,
    /// Passes go towards larger z.
    pub mirror_z: bool,
}

impl PassFrame {
    /// The frame in which a contour falls in z and rises in x from the end of its first element to its end.
    pub fn of(first: PassPoint, last: PassPoint, across: bool) -> Self {
        let turned = Self { across, ..Self::default() };
        let (first, last) = (turned.into(first), turned.into(last));
        Self { across, mirror_x: first.x > last.x, mirror_z: first.z < last.z }
    }

    /// A point of the part in the frame.
    pub fn into(self, spot: PassPoint) -> PassPoint {
        let turned = if self.across { PassPoint { z: spot.x, x: -spot.z } } else { spot };
        PassPoint {
            z: if self.mirror_z { -turned.z } else { turned.z },
            x: if self.mirror_x { -turned.x } else { turned.x },
        }
    }

    /// A point of the frame in the part.
    pub fn out(self, spot: PassPoint) -> PassPoint {
        let x = if self.mirror_x { -spot.x } else { spot.x };
        let z = if self.mirror_z { -spot.z } else { spot.z };
        if self.across { PassPoint { z: -x, x: z } } else { PassPoint { z, x } }
    }

    /// Converts a sense of rotation between frame and part.
    pub const fn sense(self, ccw: bool) -> bool {
        ccw != (self.mirror_x != self.mirror_z)
    }

    /// An element of the part in the frame.
    pub fn leg(self, leg: Leg) -> Leg {
        let round = leg.round.map(|it| Round { centre: self.into(it.centre), ccw: self.sense(it.ccw) });
        Leg { from: self.into(leg.from), to: self.into(leg.to), round, ..leg }
    }
}

/// A motion that a cycle makes, in its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Stroke {
    Rapid(PassPoint),
    Line(PassPoint),
    Arc(Round, PassPoint),
}

impl Stroke {
    pub const fn end(self) -> PassPoint {
        match self {
            Self::Rapid(to) | Self::Line(to) | Self::Arc(_, to) => to,
        }
    }
}
