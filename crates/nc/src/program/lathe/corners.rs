//! Chamfers and roundings at the corner between two straight elements: `C`, `R` of Fanuc, with or without a comma (concise guide of
//! Robur, page 22), and CHR, CHF, RND of Sinumerik (840D, Programming Guide Fundamentals, 4.22). The program names the corner; the
//! element before it ends sooner, the one behind it begins later, and between them goes a line or a tangent arc.

use super::LatheReader;
use super::block::{Maker, point, sense, spot};
use super::contour::{Leg, PassPoint, Round, SAME};
use super::motion::{LatheAct, LatheFeed, LatheMotion};
use super::words::BlockWords;
use crate::program::TextSpan;
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
}

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

impl Waiting {
    /// The element at a corner, between two motions, which become shorter; or which rule is broken.
    pub fn between(
        self,
        before: Option<&mut LatheMotion>,
        behind: &mut LatheMotion,
    ) -> Result<Option<LatheMotion>, &'static str> {
        let alone = "lathe-corner-alone";
        let before = before.filter(|before| before.to == behind.from).ok_or(alone)?;
        let (LatheAct::Feed { .. }, LatheAct::Feed { feed }) = (before.act, behind.act) else { return Err(alone) };
        let [from, at, to] = [before.from, before.to, behind.to].map(|place| place.point().map(spot));
        let (from, at, to) = (from.ok_or(alone)?, at.ok_or(alone)?, to.ok_or(alone)?);
        let broken = self.corner.broken(from, at, to).ok_or("lathe-corner-long")?;
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
        let straight = |leg: &Leg| leg.round.is_none() && !leg.rapid;
        let before = before.filter(|before| straight(before) && straight(behind)).ok_or("lathe-corner-alone")?;
        let broken = self.corner.broken(before.from, before.to, behind.to).ok_or("lathe-corner-long")?;
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
        let mut given = kinds.iter().filter_map(|(name, kind)| Some((words.take(name)?.clone(), kind)));
        let (value, kind) = given.next()?;
        // In the older form without a comma the sign tells the side, which the next block tells, too.
        let size = if fanuc && !value.name.starts_with(',') { value.value.abs() } else { value.value };
        let is_two = given.next().is_some();
        if is_two || size <= 0.0 {
            self.report_with("lathe-cycle-value", value.span, "field", value.name);
            return None;
        }
        Some(Waiting { corner: kind(size), span: value.span, feed })
    }
}
