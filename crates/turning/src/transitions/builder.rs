//! Builds the toolpath over a zone: the moves, the role of each point, and the in-process stock.

use serde::{Deserialize, Serialize};

use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::toolpath::{Purpose, Toolpath};

use super::in_process_stock::InProcessStock;
use super::monotone::{MonotoneContour, lies_on, radius_on, within};
use super::narrow::is_narrow;
use super::straight::Back;
use super::{PreparedZone, Settings};

/// The role of a support point of a toolpath.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SupportPointRole {
    /// Off the corner of the blank by the approach, where a toolpath begins and ends.
    Home,
    /// Before a pass, off the metal by the approach or by as much as there is room for.
    Start,
    /// Where a pass enters the metal from its side or from above.
    Entry,
    /// Along the contour to the depth of a pass.
    AtDepth,
    /// Where a straight pass ends.
    End,
    /// A corner of the contour, or of the path beside it.
    Corner,
    /// Where a motion along the contour ends.
    ContourEnd,
    /// Beyond that by half the nose radius.
    Overrun,
    /// Retracted from the metal.
    Retracted,
    /// Above all metal between here and there.
    Clear,
    /// On the vertical of the next start.
    Returned,
}

/// A toolpath under construction, with its in-process stock.
pub struct ToolpathBuilder<'z> {
    /// The zone.
    pub zone: &'z PreparedZone,
    /// The settings of the tool's motions.
    pub settings: &'z Settings,
    /// The in-process stock.
    pub stock: InProcessStock,
    /// The toolpath so far.
    pub path: Toolpath,
    /// The role of each point, its start point included.
    pub roles: Vec<SupportPointRole>,
    /// Working passes so far.
    pub passes: usize,
    /// The pieces of the last pass, along which the tool can return.
    trail: Vec<Piece>,
}

impl<'z> ToolpathBuilder<'z> {
    /// At the home point.
    pub fn new(zone: &'z PreparedZone, settings: &'z Settings) -> Self {
        Self {
            zone,
            settings,
            stock: zone.whole.clone(),
            path: Toolpath::at(zone.home(settings)),
            roles: vec![SupportPointRole::Home],
            passes: 0,
            trail: Vec::new(),
        }
    }

    /// The rough contour.
    pub fn rough(&self) -> &'z MonotoneContour {
        &self.zone.rough
    }

    /// Where the tool is.
    pub fn here(&self) -> Point {
        self.path.end()
    }

    /// Where straight passes have ended.
    pub fn ends(&self) -> impl Iterator<Item = Point> + '_ {
        let moves = self.path.moves.iter().zip(self.roles.iter().skip(1));
        moves
            .filter(|(one, role)| **role == SupportPointRole::End && one.purpose == Purpose::Cut)
            .map(|(one, _)| one.to)
    }

    /// Along a piece at a feed. Where the contour is so steep that one Z has several radii, an upright line leads to it.
    pub fn feed(&mut self, piece: Piece, purpose: Purpose, role: SupportPointRole) {
        let here = self.here();
        debug_assert_eq!(piece.from.z, here.z, "a piece begins where the toolpath ends");
        if piece.from != here {
            self.straight(piece.from, purpose, SupportPointRole::Corner);
        }
        if !piece.is_nothing() {
            self.path.follow(piece, purpose);
            self.roles.push(role);
            self.stock.lower(&piece);
        }
    }

    /// Along pieces at a feed; `end` is the role of the last point.
    pub fn follow(&mut self, pieces: &[Piece], purpose: Purpose, end: SupportPointRole) {
        for (index, piece) in pieces.iter().enumerate() {
            let role = if index + 1 == pieces.len() { end } else { SupportPointRole::Corner };
            self.feed(*piece, purpose, role);
        }
    }

    /// A straight line at a feed.
    pub fn straight(&mut self, to: Point, purpose: Purpose, role: SupportPointRole) {
        self.feed(Piece::line(self.here(), to), purpose, role);
    }

    /// A straight rapid.
    pub fn rapid(&mut self, to: Point, role: SupportPointRole) {
        if to != self.here() {
            self.path.go(to, Purpose::Rapid);
            self.roles.push(role);
        }
    }

    /// Retracts from the metal on both axes; only upwards if there is no room for that.
    pub fn draw_back(&mut self) {
        let (here, by) = (self.here(), self.settings.retract);
        let up = self.zone.limited(here.radius + by);
        let aslant = Point { radius: up, z: here.z - by };
        let to = if self.stock.is_clear(here, aslant) { aslant } else { Point { radius: up, z: here.z } };
        self.rapid(to, SupportPointRole::Retracted);
    }

    /// Rapids to a point, not through metal.
    ///
    /// 1. Along the axis at the current radius if there is no metal in the way; otherwise first up, above all metal
    ///    between the two points.
    /// 2. Across the axis to the point.
    pub fn travel(&mut self, to: Point, role: SupportPointRole) {
        let here = self.here();
        if to == here {
            return;
        }
        let over = self.stock.highest(here.z, to.z);
        let high = if over.is_none_or(|over| over <= here.radius) && (to.radius <= here.radius || here.z == to.z) {
            here.radius
        } else {
            let over = over.map_or(here.radius, |over| over + self.settings.retract);
            self.zone.limited(over.max(here.radius).max(to.radius))
        };
        self.rapid(Point { radius: high, z: here.z }, SupportPointRole::Clear);
        self.rapid(Point { radius: high, z: to.z }, if high == to.radius { role } else { SupportPointRole::Returned });
        self.rapid(to, role);
    }

    /// To a point from above: a rapid to just above the metal, then the infeed rate.
    pub fn enter(&mut self, at: Point) {
        let top = self.stock.least_at(at.z).map_or(at.radius, |least| least.max(at.radius));
        if at == self.here() {
            return;
        }
        let above = Point { radius: self.zone.limited(top + self.settings.retract), z: at.z };
        // If the tool is already on the vertical below that, it continues from its position.
        if !(self.here().z == at.z && self.here().radius >= top && self.here().radius <= above.radius) {
            self.travel(above, SupportPointRole::Start);
        }
        self.straight(at, Purpose::Infeed, SupportPointRole::Entry);
    }

    /// A pass along pieces; only the part through metal is followed ([`Self::trimmed`]). Returns whether it cut
    /// anything.
    pub fn pass(&mut self, pieces: &[Piece], purpose: Purpose, end: SupportPointRole) -> bool {
        let mut pieces = self.trimmed(pieces);
        let Some(first) = pieces.first_mut() else { return false };
        self.begin(first, purpose);
        self.follow(&pieces, purpose, end);
        self.passed(pieces);
        true
    }

    /// To the beginning of the first piece of a pass: from the side, off the metal by the approach or by as much as
    /// there is room for; without room from above, at the infeed rate. A cylinder is extended to the start.
    pub fn begin(&mut self, first: &mut Piece, purpose: Purpose) {
        match self.side_start(first.from).filter(|_| first.from != self.here()) {
            Some(start) => {
                self.travel(start, SupportPointRole::Start);
                if first.is_cylinder() {
                    first.from = start;
                } else {
                    self.straight(first.from, purpose, SupportPointRole::Entry);
                }
            }
            None => self.enter(first.from),
        }
    }

    /// Where a pass may start beside the metal; none if there is no room for the retract.
    pub fn side_start(&self, at: Point) -> Option<Point> {
        let room = self.stock.room_before(at.z, at.radius, self.settings.approach);
        let enough = room > Half::ZERO && room >= self.settings.retract.min(self.settings.approach);
        enough.then_some(Point { radius: at.radius, z: at.z - room })
    }

    /// Ends a pass: the tool can return along its pieces.
    pub fn passed(&mut self, trail: Vec<Piece>) {
        self.passes += 1;
        self.trail = trail;
    }

    /// Begins another section or another stock: the tool cannot return along the last pass.
    pub fn leave_trail(&mut self) {
        self.trail.clear();
    }

    /// Along the contour back to where the last pass began, at the infeed rate, if the next pass continues from that
    /// point (l. 468-478).
    pub fn back_along(&mut self, to: Point) {
        let begins = self.trail.first().is_some_and(|first| first.from == to);
        if !begins || self.trail.last().is_none_or(|last| last.to != self.here()) {
            return;
        }
        let back: Vec<Piece> = self.trail.iter().rev().map(|piece| piece.reversed()).collect();
        self.follow(&back, Purpose::Return, SupportPointRole::Returned);
    }

    /// The part of a falling flank that the tool must cut. If the last pass began on the flank, it is only the part
    /// below: the part above is already cut, apart from rounding.
    pub fn flank(&self, foot: Point, back: Back) -> Vec<Piece> {
        let mut flank = self.rough().flank(foot);
        let began =
            self.trail.first().map(|first| first.from).filter(|began| *began != foot && back == Back::AlongContour);
        let on = |began: Point| flank.iter().rposition(|piece| lies_on(piece, began));
        let Some((index, began)) = began.and_then(|began| Some((on(began)?, began))) else { return self.uncut(&flank) };
        flank.drain(..index);
        if let Some(first) = flank.first_mut() {
            *first = within(first, began, first.to);
        }
        flank.retain(|piece| !piece.is_nothing());
        flank
    }

    /// The part of a falling flank that still has metal on it, down to its foot.
    fn uncut(&self, flank: &[Piece]) -> Vec<Piece> {
        let mut uncut = Vec::new();
        for piece in flank.iter().rev() {
            let from = if piece.is_face() {
                let top = self.stock.sides(piece.from.z).1.map_or(piece.to.radius, |top| top.min(piece.from.radius));
                Point { radius: top.max(piece.to.radius), z: piece.from.z }
            } else {
                match self.stock.metal(piece).last() {
                    Some((from, to)) if *to == piece.to.z => Point { radius: radius_on(piece, *from), z: *from },
                    _ => break,
                }
            };
            let whole = from.z == piece.from.z && (!piece.is_face() || from.radius == piece.from.radius);
            let part = piece.between(if whole { piece.from } else { from }, piece.to);
            if !part.is_nothing() {
                uncut.push(part);
            }
            if !whole {
                break;
            }
        }
        uncut.reverse();
        uncut
    }

    /// The part of a path that cuts metal, from its first to its last contact. A face down to its beginning and one
    /// up from its end are included where there is metal beside them. Slivers narrower than the rounding do not
    /// count, nor does contact outside the worked range.
    pub fn trimmed(&self, pieces: &[Piece]) -> Vec<Piece> {
        let (from, to) = self.zone.worked;
        let metal = |piece: &Piece| {
            let mut metal = if piece.is_face() { Vec::new() } else { self.stock.metal(piece) };
            metal.retain(|(begins, ends)| *begins < to && from < *ends);
            metal
        };
        let metal: Vec<Vec<(Half, Half)>> = pieces.iter().map(metal).collect();
        if metal.iter().flatten().all(|(from, to)| is_narrow(*from, *to)) {
            return Vec::new();
        }
        let first = metal.iter().position(|one| !one.is_empty());
        let last = metal.iter().rposition(|one| !one.is_empty());
        let (Some(first), Some(last)) = (first, last) else { return Vec::new() };
        let mut kept: Vec<Piece> = pieces.get(first..=last).unwrap_or_default().to_vec();
        let at = |piece: &Piece, z: Half| Point { radius: radius_on(piece, z), z };
        if let (Some(piece), Some((_, to))) = (kept.last_mut(), metal.get(last).and_then(|one| one.last())) {
            let after = pieces.get(last + 1).filter(|next| next.is_face() && next.to.radius > next.from.radius);
            piece.to = at(piece, *to);
            if let Some(face) = after.filter(|face| face.from == piece.to) {
                let top = self.stock.sides(*to).0.map_or(face.to.radius, |top| top.min(face.to.radius));
                if top > face.from.radius {
                    kept.push(Piece::line(face.from, Point { radius: top, z: *to }));
                }
            }
        }
        if let (Some(piece), Some((from, _))) = (kept.first_mut(), metal.get(first).and_then(|one| one.first())) {
            let before = first.checked_sub(1).and_then(|before| pieces.get(before));
            piece.from = at(piece, *from);
            if let Some(face) = before.filter(|face| face.is_face() && face.to == piece.from) {
                let top = self.stock.sides(*from).1.map_or(face.from.radius, |top| top.min(face.from.radius));
                if top > face.to.radius {
                    kept.insert(0, Piece::line(Point { radius: top, z: *from }, face.to));
                }
            }
        }
        kept
    }

    /// To the home point: straight if there is no metal in the way, otherwise up first.
    pub fn home(mut self) -> Self {
        let home = self.path.from;
        if self.here() != home {
            if !self.stock.is_clear(self.here(), home) {
                let here = self.here();
                self.rapid(Point { radius: home.radius.max(here.radius), z: here.z }, SupportPointRole::Clear);
            }
            self.rapid(home, SupportPointRole::Home);
        }
        self
    }
}
