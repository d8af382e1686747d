//! G41 and G42 as a control makes them: the way of the nose's centre, which keeps the nose's radius off the programmed contour, and
//! the reference point beside it. Of Fanuc and Sinumerik (NORM, G450); radius and place of the tip are those of our plan's tool.
//!
//! - The first block goes to the place at right angles to the beginning of the next one, the block that ends it begins at right angles
//!   to the end of the last one (Sinumerik 840D, Programming Guide Fundamentals, G40 to G42; NORM).
//! - At inner corners the ways are cut off where they meet (Okuma OSP-P200L, Programming Manual, page 62: as controls do); where they do
//!   not meet the element is too short for the nose, and a control stops.
//! - At outer corners the centre goes round the corner. Some controls go straight on to where the ways meet instead: off the part.

use crate::motion::{Sense, Side};
use crate::program::lathe::{LatheAct, LatheFeed, LatheMotion, LathePoint};

/// A length in the half-plane with Z to the right and the radius upwards, mm.
#[derive(Clone, Copy, Debug)]
struct Spot {
    z: f64,
    r: f64,
}

impl Spot {
    const fn of(point: LathePoint) -> Self {
        Self { z: point.z_mm, r: point.radius_mm }
    }

    const fn point(self) -> LathePoint {
        LathePoint { radius_mm: self.r, z_mm: self.z }
    }

    fn plus(self, other: Self) -> Self {
        Self { z: self.z + other.z, r: self.r + other.r }
    }

    fn minus(self, other: Self) -> Self {
        Self { z: self.z - other.z, r: self.r - other.r }
    }

    fn times(self, by: f64) -> Self {
        Self { z: self.z * by, r: self.r * by }
    }

    fn cross(self, other: Self) -> f64 {
        self.z * other.r - self.r * other.z
    }

    fn dot(self, other: Self) -> f64 {
        self.z * other.z + self.r * other.r
    }

    fn length(self) -> f64 {
        libm::hypot(self.z, self.r)
    }

    fn unit(self) -> Self {
        self.times(1.0 / self.length())
    }

    const fn left(self) -> Self {
        Self { z: -self.r, r: self.z }
    }
}

/// The nose of a tool: its radius, mm, and the direction from its centre to the reference point, away from the chuck and from the
/// axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct TipOfNose {
    pub radius: f64,
    pub z: f64,
    pub r: f64,
}

/// What lies so near is at one place, mm.
const SAME: f64 = 1e-6;

/// An element on the way of the centre.
#[derive(Clone, Copy, Debug)]
struct Element {
    from: Spot,
    to: Spot,
    /// Its centre, and whether it is counter-clockwise.
    round: Option<(Spot, bool)>,
}

impl Element {
    fn of(motion: &LatheMotion) -> Option<Self> {
        let (from, to) = (Spot::of(motion.from.point()?), Spot::of(motion.to.point()?));
        let round = match motion.act {
            LatheAct::Feed { .. } | LatheAct::Rapid => None,
            LatheAct::Arc { centre, sense, .. } => Some((Spot::of(centre), sense == Sense::Counterclockwise)),
            _ => return None,
        };
        (from.minus(to).length() > SAME).then_some(Self { from, to, round })
    }

    /// Its direction at a place of it.
    fn along(self, place: Spot) -> Spot {
        match self.round {
            None => self.to.minus(self.from).unit(),
            Some((centre, ccw)) => place.minus(centre).unit().left().times(if ccw { 1.0 } else { -1.0 }),
        }
    }

    /// So far to its left; none for an arc that the nose does not enter.
    fn moved(self, left: f64) -> Option<Self> {
        let by = |place: Spot| place.plus(self.along(place).left().times(left));
        let inwards = self.round.is_some_and(|(centre, ccw)| {
            let radius = self.from.minus(centre).length();
            (if ccw { left } else { -left }) > radius - SAME
        });
        (!inwards).then(|| Self { from: by(self.from), to: by(self.to), ..self })
    }

    /// Whether a place on its line or circle lies between its ends.
    fn has(self, place: Spot) -> bool {
        let Some((centre, ccw)) = self.round else {
            let part = place.minus(self.from).dot(self.along(place));
            return (-SAME..=self.to.minus(self.from).length() + SAME).contains(&part);
        };
        let angle = |to: Spot| {
            let (a, b) = (self.from.minus(centre), to.minus(centre));
            let angle = libm::atan2(a.cross(b), a.dot(b)) * if ccw { 1.0 } else { -1.0 };
            if angle < -1e-9 { angle + std::f64::consts::TAU } else { angle }
        };
        angle(place) <= angle(self.to) + 1e-9
    }

    /// Where its line or circle meets that of another.
    fn crossings(self, other: Self) -> Vec<Spot> {
        match (self.round, other.round) {
            (None, None) => {
                let (a, b) = (self.along(self.from), other.along(other.from));
                let cross = a.cross(b);
                if cross.abs() < 1e-12 {
                    return Vec::new();
                }
                vec![self.from.plus(a.times(other.from.minus(self.from).cross(b) / cross))]
            }
            (None, Some((centre, _))) => {
                let along = self.along(self.from);
                let foot = self.from.plus(along.times(centre.minus(self.from).dot(along)));
                around(foot, along, centre.minus(foot).length(), other.from.minus(centre).length())
            }
            (Some(_), None) => other.crossings(self),
            (Some((one, _)), Some((two, _))) => {
                let (a, b) = (self.from.minus(one).length(), other.from.minus(two).length());
                let path = two.minus(one);
                let far = path.length();
                if far < SAME {
                    return Vec::new();
                }
                let along = (far * far + a * a - b * b) / (2.0 * far);
                let foot = one.plus(path.unit().times(along));
                around(foot, path.unit().left(), along.abs(), a)
            }
        }
    }
}

/// The places on a line on either side of its foot, so far from a centre; the foot has that distance from it.
fn around(foot: Spot, along: Spot, off: f64, radius: f64) -> Vec<Spot> {
    let square = radius * radius - off * off;
    if square < -SAME {
        return Vec::new();
    }
    let half = libm::sqrt(square.max(0.0));
    vec![foot.plus(along.times(half)), foot.plus(along.times(-half))]
}

/// The motions with those under G41 and G42 as the control makes them, or the line of the first that cannot be followed.
pub(super) fn followed(
    motions: &[LatheMotion],
    nose: impl Fn(&LatheMotion) -> Option<TipOfNose>,
) -> Result<Vec<LatheMotion>, u32> {
    let mut made: Vec<LatheMotion> = Vec::new();
    let mut index = 0;
    while let Some(first) = motions.get(index) {
        if first.modes.compensation == Side::Off || !first.act.moves() {
            made.push(*first);
            index += 1;
            continue;
        }
        let goes_on = |one: &&LatheMotion| !one.act.moves() || one.modes.compensation == first.modes.compensation;
        let count = motions[index..].iter().take_while(goes_on).count();
        let stretch = &motions[index..index + count];
        let nose = nose(first).filter(|_| stretch.iter().all(|one| one.modes.tool == first.modes.tool));
        let end = way(stretch, nose.ok_or(first.line)?, &mut made)?;
        index += count;
        // The block that ends it begins where the tool stands then.
        if let Some(next) = motions.get(index) {
            let from = if next.modes.compensation == Side::Off { end } else { return Err(next.line) };
            made.push(LatheMotion { from: from.into(), ..*next });
            index += 1;
        }
    }
    Ok(made)
}

/// The motions of one stretch; returns where the reference point stands at its end.
fn way(stretch: &[LatheMotion], nose: TipOfNose, made: &mut Vec<LatheMotion>) -> Result<LathePoint, u32> {
    let moving: Vec<&LatheMotion> = stretch.iter().filter(|one| one.act.moves() && one.from != one.to).collect();
    let Some((entry, rest)) = moving.split_first() else { return Err(stretch.first().map_or(1, |one| one.line)) };
    let left = if entry.modes.compensation == Side::Left { nose.radius } else { -nose.radius };
    let tip = Spot { z: nose.z * nose.radius, r: nose.r * nose.radius };
    let mut put = |motion: &LatheMotion, from: Spot, to: Spot, act: LatheAct| {
        let act = match act {
            LatheAct::Arc { feed, centre, sense } => {
                LatheAct::Arc { feed, centre: Spot::of(centre).plus(tip).point(), sense }
            }
            act => act,
        };
        let mut modes = motion.modes;
        modes.compensation = Side::Off;
        let (from, to) = (from.plus(tip).point().into(), to.plus(tip).point().into());
        made.push(LatheMotion { act, from, to, modes, ..*motion });
    };
    let mut elements = Vec::new();
    for one in rest {
        let drawn = Element::of(one).ok_or(one.line)?;
        elements.push((*one, drawn, drawn.moved(left).ok_or(one.line)?));
    }
    let drawn = Element::of(entry).filter(|drawn| drawn.round.is_none()).ok_or(entry.line)?;
    let begin = elements.first().map_or_else(|| drawn.moved(left).map(|moved| moved.to), |first| Some(first.2.from));
    let mut at = begin.ok_or(entry.line)?;
    // The reference point stood where the program says before.
    put(entry, drawn.from.minus(tip), at, entry.act);
    let mut feed: Option<LatheFeed> = None;
    for (index, (motion, drawn, moved)) in elements.iter().enumerate() {
        if let LatheAct::Feed { feed: own } | LatheAct::Arc { feed: own, .. } = motion.act {
            feed = Some(own);
        }
        let Some((_, next, next_moved)) = elements.get(index + 1) else {
            put(motion, at, moved.to, motion.act);
            at = moved.to;
            continue;
        };
        let corner = drawn.to;
        let (before, behind) = (drawn.along(corner), next.along(corner));
        let turn = before.cross(behind);
        let is_smooth = turn.abs() < 1e-4 && before.dot(behind) > 0.0;
        if !is_smooth && turn * left > 0.0 {
            let met =
                moved.crossings(*next_moved).into_iter().filter(|place| moved.has(*place) && next_moved.has(*place));
            let far = |place: &Spot| place.minus(corner).length();
            let met = met.min_by(|a, b| far(a).total_cmp(&far(b))).ok_or(motion.line)?;
            put(motion, at, met, motion.act);
            at = met;
            continue;
        }
        put(motion, at, moved.to, motion.act);
        at = moved.to;
        if at.minus(next_moved.from).length() > SAME {
            let sense = if left > 0.0 { Sense::Clockwise } else { Sense::Counterclockwise };
            let feed = feed.ok_or(motion.line)?;
            let round = LatheAct::Arc { feed, centre: corner.point(), sense };
            put(motion, at, next_moved.from, if is_smooth { LatheAct::Feed { feed } } else { round });
            at = next_moved.from;
        }
    }
    Ok(at.plus(tip).point())
}
