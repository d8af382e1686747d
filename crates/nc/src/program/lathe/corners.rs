//! Chamfers and roundings at the corner between two straight elements: `C`, `R` of Fanuc, with or without a comma (concise guide of
//! Robur, page 22), and CHR, CHF, RND of Sinumerik (840D, Programming Guide Fundamentals, 4.22). The program names the corner; the
//! element before it ends sooner, the one behind it begins later, and between them goes a line or a tangent arc. RND of Sinumerik
//! rounds corners with arcs, too; its chamfers beside an arc are not carried out here.

use std::f64::consts::TAU;

use super::LatheReader;
use super::block::{Maker, point, sense, spot};
use super::contour::{Leg, PassPoint, Round, SAME};
use super::motion::{LatheAct, LatheFeed, LatheMotion};
use super::rules::fault;
use super::words::BlockWords;
use crate::motion::Sense;
use crate::program::{Fault, TextSpan};
use crate::units::{MillimetresPerMinute, MillimetresPerRev};

/// What stands at a corner, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Corner {
    /// A chamfer that takes so much of each element: `C`, CHR.
    Leg(f64),
    /// A chamfer that is so long: CHF.
    Length(f64),
    /// A tangent arc of this radius: `R`, RND.
    Radius(f64),
}

/// What a size makes of a corner.
type Kind = fn(f64) -> Corner;

/// A corner that waits for the element behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Waiting {
    pub corner: Corner,
    pub span: TextSpan,
    /// The feed along it, where it has its own: FRC.
    pub feed: Option<f64>,
    /// Its word.
    pub word: &'static str,
    /// Whether the control takes arcs beside it.
    arcs: bool,
}

/// A line or an arc beside a corner.
#[derive(Clone, Copy, Debug)]
struct Beside {
    from: PassPoint,
    to: PassPoint,
    round: Option<Round>,
}

/// Why a corner beside an arc is not made.
const NOT_HERE: &str = "lathe-not-carried-out";

/// A corner with what stands at it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Broken {
    pub from: PassPoint,
    pub to: PassPoint,
    pub round: Option<Round>,
}

impl Corner {
    /// Between two lines that meet; none where one of them is too short, or where they turn back.
    pub fn broken(self, from: PassPoint, at: PassPoint, to: PassPoint) -> Option<Broken> {
        let (before, behind) = (from.to(at), at.to(to));
        let towards = |end: PassPoint, far: f64| PassPoint { z: (end.z - at.z) / far, x: (end.x - at.x) / far };
        let (back, on) = (towards(from, before), towards(to, behind));
        // Half the angle between the elements, by its sine and cosine.
        let cosine = back.z * on.z + back.x * on.x;
        let (half_sine, half_cosine) = (libm::sqrt((1.0 - cosine) / 2.0), libm::sqrt((1.0 + cosine).max(0.0) / 2.0));
        let leg = match self {
            Self::Leg(leg) => leg,
            Self::Length(length) => length / (2.0 * half_sine),
            Self::Radius(radius) => radius * half_cosine / half_sine,
        };
        let place = |along: PassPoint, far: f64| PassPoint { z: at.z + along.z * far, x: at.x + along.x * far };
        let (from, to) = (place(back, leg), place(on, leg));
        let round = match self {
            Self::Radius(radius) if leg > SAME => {
                let middle = PassPoint { z: (back.z + on.z) / 2.0, x: (back.x + on.x) / 2.0 };
                // The centre lies on the bisector; it is to the left where the way turns left.
                let centre = place(middle, radius / (half_sine * half_cosine));
                Some(Round { centre, ccw: on.x * back.z - on.z * back.x < 0.0 })
            }
            _ => None,
        };
        (half_sine > SAME && leg <= before.min(behind) + SAME).then_some(Broken { from, to, round })
    }
}

impl Beside {
    /// The direction at a point of it.
    fn direction(self, at: PassPoint) -> PassPoint {
        let (dz, dx) = match self.round {
            None => (self.to.z - self.from.z, self.to.x - self.from.x),
            Some(Round { centre, ccw: true }) => (centre.x - at.x, at.z - centre.z),
            Some(Round { centre, ccw: false }) => (at.x - centre.x, centre.z - at.z),
        };
        let length = libm::hypot(dz, dx);
        PassPoint { z: dz / length, x: dx / length }
    }

    /// Where it touches a circle around a point.
    fn foot(self, centre: PassPoint) -> PassPoint {
        match self.round {
            None => {
                let on = self.direction(self.from);
                let along = (centre.z - self.from.z) * on.z + (centre.x - self.from.x) * on.x;
                PassPoint { z: self.from.z + on.z * along, x: self.from.x + on.x * along }
            }
            Some(round) => {
                let share = round.centre.to(self.from) / round.centre.to(centre);
                let along = |own: f64, other: f64| own + (other - own) * share;
                PassPoint { z: along(round.centre.z, centre.z), x: along(round.centre.x, centre.x) }
            }
        }
    }

    /// Whether a point of its line or circle lies between its ends.
    fn holds(self, spot: PassPoint) -> bool {
        let Some(Round { centre, ccw }) = self.round else {
            return self.from.to(spot) + spot.to(self.to) <= self.from.to(self.to) + SAME;
        };
        let angle = |at: PassPoint| libm::atan2(at.x - centre.x, at.z - centre.z);
        let turn = |to: PassPoint| {
            let turned = if ccw { angle(to) - angle(self.from) } else { angle(self.from) - angle(to) };
            turned.rem_euclid(TAU)
        };
        turn(spot) <= turn(self.to) + SAME
    }

    /// The places from which a circle of a radius touches it on its left (positive) or its right: on a line through a point, or
    /// around a centre.
    fn beside(self, radius: f64, left: f64) -> Locus {
        match self.round {
            None => {
                let on = self.direction(self.from);
                let off = radius * left;
                Locus::Line(PassPoint { z: self.from.z - on.x * off, x: self.from.x + on.z * off }, on)
            }
            Some(Round { centre, ccw }) => {
                let inwards = if ccw { left } else { -left };
                Locus::Circle(centre, centre.to(self.from) - inwards * radius)
            }
        }
    }
}

/// Where the centre of a rounding may lie.
#[derive(Clone, Copy, Debug)]
enum Locus {
    Line(PassPoint, PassPoint),
    Circle(PassPoint, f64),
}

impl Locus {
    /// Where both are met.
    fn meets(self, other: Self) -> Vec<PassPoint> {
        match (self, other) {
            (Self::Line(..), Self::Line(..)) => Vec::new(),
            (Self::Circle(..), Self::Line(..)) => other.meets(self),
            (Self::Line(at, on), Self::Circle(centre, radius)) => {
                let along = (centre.z - at.z) * on.z + (centre.x - at.x) * on.x;
                let foot = PassPoint { z: at.z + on.z * along, x: at.x + on.x * along };
                let square = radius * radius - foot.to(centre) * foot.to(centre);
                let half = libm::sqrt(square.max(0.0));
                let both = [half, -half].map(|far| PassPoint { z: foot.z + on.z * far, x: foot.x + on.x * far });
                if radius <= 0.0 || square < -SAME { Vec::new() } else { both.to_vec() }
            }
            (Self::Circle(one, first), Self::Circle(two, second)) => {
                let far = one.to(two);
                let along = (far * far + first * first - second * second) / (2.0 * far);
                let square = first * first - along * along;
                if first <= 0.0 || second <= 0.0 || far < SAME || square < -SAME {
                    return Vec::new();
                }
                let (on, half) = ((two.z - one.z) / far, libm::sqrt(square.max(0.0)));
                let up = (two.x - one.x) / far;
                let both = [half, -half]
                    .map(|off| PassPoint { z: one.z + on * along - up * off, x: one.x + up * along + on * off });
                both.to_vec()
            }
        }
    }
}

/// A tangent arc of a radius between two elements, one of them at least an arc.
fn rounded(radius: f64, before: Beside, behind: Beside) -> Option<Broken> {
    let at = before.to;
    let (into, out) = (before.direction(at), behind.direction(at));
    let turn = into.z * out.x - into.x * out.z;
    let left = turn.signum();
    let centres = before.beside(radius, left).meets(behind.beside(radius, left));
    let centre = centres.into_iter().min_by(|a, b| a.to(at).total_cmp(&b.to(at))).filter(|_| turn.abs() > SAME)?;
    let (from, to) = (before.foot(centre), behind.foot(centre));
    let round = Some(Round { centre, ccw: left > 0.0 });
    (before.holds(from) && behind.holds(to)).then_some(Broken { from, to, round })
}

impl Waiting {
    /// What stands at the corner between two elements; or which rule is broken.
    fn broken(self, before: Beside, behind: Beside) -> Result<Broken, &'static str> {
        let straight = before.round.is_none() && behind.round.is_none();
        let broken = match self.corner {
            _ if straight => self.corner.broken(before.from, before.to, behind.to),
            _ if !self.arcs => return Err("lathe-corner-alone"),
            Corner::Radius(radius) => rounded(radius, before, behind),
            Corner::Leg(_) | Corner::Length(_) => return Err(NOT_HERE),
        };
        broken.ok_or("lathe-corner-long")
    }

    /// The fault of a rule that the corner breaks.
    pub fn fault(self, code: &'static str, block: Option<u32>) -> Fault {
        let problem = fault(code, self.span, block);
        if code == NOT_HERE { problem.with("word", self.word) } else { problem }
    }

    /// The element at a corner, between two motions, which become shorter; or which rule is broken.
    pub fn between(
        self,
        before: Option<&mut LatheMotion>,
        behind: &mut LatheMotion,
    ) -> Result<Option<LatheMotion>, &'static str> {
        let alone = "lathe-corner-alone";
        let before = before.filter(|before| before.to == behind.from).ok_or(alone)?;
        let beside = |motion: &LatheMotion| {
            let round = match motion.act {
                LatheAct::Feed { .. } => None,
                LatheAct::Arc { centre, sense, .. } => {
                    Some(Round { centre: spot(centre), ccw: sense == Sense::Counterclockwise })
                }
                _ => return None,
            };
            Some(Beside { from: spot(motion.from.point()?), to: spot(motion.to.point()?), round })
        };
        let broken = self.broken(beside(before).ok_or(alone)?, beside(behind).ok_or(alone)?)?;
        let (LatheAct::Feed { feed } | LatheAct::Arc { feed, .. }) = behind.act else { return Err(alone) };
        before.to = point(broken.from).into();
        behind.from = point(broken.to).into();
        let feed = match (feed, self.feed) {
            (LatheFeed::PerRevolution(_), Some(own)) => LatheFeed::PerRevolution(MillimetresPerRev(own)),
            (LatheFeed::PerMinute(_), Some(own)) => LatheFeed::PerMinute(MillimetresPerMinute(own)),
            (feed, None) => feed,
        };
        let act = match broken.round {
            Some(round) => LatheAct::Arc { feed, centre: point(round.centre), sense: sense(round.ccw) },
            None => LatheAct::Feed { feed },
        };
        let made = LatheMotion { act, from: before.to, to: behind.from, ..*before };
        Ok((broken.from.to(broken.to) > SAME).then_some(made))
    }

    /// The same between two elements of a contour.
    pub fn between_legs(self, before: Option<&mut Leg>, behind: &mut Leg) -> Result<Option<Leg>, &'static str> {
        let before = before.filter(|before| !before.rapid && !behind.rapid).ok_or("lathe-corner-alone")?;
        let beside = |leg: &Leg| Beside { from: leg.from, to: leg.to, round: leg.round };
        let broken = self.broken(beside(before), beside(behind))?;
        before.to = broken.from;
        behind.from = broken.to;
        let made = Leg { from: broken.from, to: broken.to, round: broken.round, feed: self.feed, ..*before };
        Ok((broken.from.to(broken.to) > SAME).then_some(made))
    }
}

impl Maker<'_> {
    /// The chamfer or rounding that a block asks for at its end. A line that has one is checked when the next one is known.
    pub(super) fn corner(&mut self, words: &BlockWords) -> Option<Waiting> {
        let fanuc = self.is(LatheReader::Fanuc);
        let leg: Kind = Corner::Leg;
        let kinds: &[(&str, Kind)] = match self.language.kind {
            LatheReader::LinuxCnc => &[],
            LatheReader::Fanuc => &[(",C", leg), ("C", leg), (",R", Corner::Radius), ("R", Corner::Radius)],
            LatheReader::Sinumerik => &[("CHR", leg), ("CHF", Corner::Length), ("RND", Corner::Radius)],
        };
        let feed = words.take("FRC").map(|value| value.value).filter(|feed| *feed > 0.0);
        let mut given = kinds.iter().filter_map(|(name, kind)| Some((words.take(name)?.clone(), (*name, kind))));
        let (value, (word, kind)) = given.next()?;
        // In the older form without a comma the sign tells the side, which the next block tells, too.
        let size = if fanuc && !value.name.starts_with(',') { value.value.abs() } else { value.value };
        let is_two = given.next().is_some();
        if is_two || size <= 0.0 {
            self.report_with("lathe-cycle-value", value.span, "field", value.name);
            return None;
        }
        let arcs = self.is(LatheReader::Sinumerik);
        Some(Waiting { corner: kind(size), span: value.span, feed, word, arcs })
    }
}
