//! The room before and after a thread.
//!
//! Before it the carriage accelerates to the pitch, after it it stops. Heights are radii outside and negative radii
//! in a bore, so that metal is always below.

use crate::error::{Refusal, Tried};
use crate::turning::contour::{Piece, Side, Surface, SurfaceKind};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::units::Micrometres;

use super::super::refused::NoJob;
use super::super::site::Site;

/// The room that a thread needs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Room {
    /// The cylinder of the thread.
    pub thread: Piece,
    /// The radius of the roots.
    pub root: Half,
    /// The height above the crests where the tool returns.
    pub lift: Half,
    /// The run-in before it.
    pub entry: Half,
    /// The run-out after it.
    pub run_out: Half,
    /// From the tip of the insert to its side.
    pub side_of_insert: Half,
    /// The longest run-out in the metal behind a thread without a relief.
    pub longest: Micrometres,
    /// The number of the finest IT grade of a surface on which a thread may run out.
    pub finest: f64,
}

/// Where the passes begin and end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Found {
    pub from: Half,
    pub to: Half,
    /// Whether the tool is withdrawn from the metal during the run-out, because there is no relief after the thread.
    pub pull_out: bool,
}

/// Half the angle of the profile, as a slope.
const FLANK: f64 = 0.577_350_269_19;

impl Room {
    /// Where the passes begin and end.
    ///
    /// # Errors
    /// What stands before or behind the thread leaves too little room; its relief is too shallow.
    pub fn find(self, site: Site<'_>, surface: &Surface) -> Tried<Found, NoJob> {
        let seen = |point: Point| match site.side() {
            Side::Outer => point,
            Side::Inner => point.inside_out(Half::ZERO),
        };
        let piece = |piece: &Piece| piece.mapped(site.side() == Side::Inner, seen);
        let height = |radius: Half| seen(Point { radius, z: Half::ZERO }).radius;
        let (crest, root) = (height(self.thread.from.radius), height(self.root));
        let (begin, end) = (self.thread.from.z, self.thread.to.z);
        let surfaces = &site.profile.surfaces;
        let index = surfaces.iter().position(|one| std::ptr::eq(one, surface) || one == surface).unwrap_or_default();
        let (before, behind) = surfaces.split_at(index);

        // Metal that the tool would meet before the thread; an element that breaks its edge belongs to the thread.
        let breaks = |one: &Surface| matches!(one.kind, SurfaceKind::Chamfer | SurfaceKind::Ball);
        let edge = before.last().filter(|last| breaks(last));
        let begin_of_metal = edge.and_then(|edge| edge.pieces.first()).map_or(begin, |first| first.from.z);
        let ahead = before.iter().filter(|one| edge.is_none_or(|edge| !std::ptr::eq(*one, edge)));
        let high = ahead
            .flat_map(|one| &one.pieces)
            .map(piece)
            .filter(|one| one.radii().1 > root && one.from.z < begin_of_metal);
        if let Some(stands) = high.map(|one| one.to.z).max() {
            let (needs, room) = (self.entry + self.side_of_insert, begin - stands);
            if needs > room {
                return Err(Refusal::Not(NoJob::NoEntry { surface: surface.name.clone(), needs, room }));
            }
        }
        let from = begin - self.entry;

        let after: Vec<Piece> = behind.iter().skip(1).flat_map(|one| &one.pieces).map(piece).collect();
        let rises = after.iter().find(|one| one.radii().1 > crest);
        let stands = rises.map(|one| one.at_radius(crest).iter().map(|at| at.z).min().unwrap_or(one.from.z));
        // Beyond the end of the outer contour nothing is turned in this set-up; a bore ends in the air.
        let profile_ends = || surfaces.last().and_then(|last| last.pieces.last()).map(|last| last.to.z);
        let stands = stands.or_else(|| if site.side() == Side::Outer { profile_ends() } else { None });
        let top = after.iter().map(|one| one.radii().1).max().map_or(crest, |high| high.max(crest));
        let flank = Half::from((top - root).to_mm() * FLANK);
        let insert = flank.min(self.side_of_insert);
        // What comes later than the tool has left the metal is no relief.
        let last = end + self.run_out.max(Half::of(self.longest));
        let free = after.iter().take_while(|one| stands.is_none_or(|stands| one.from.z < stands) && one.from.z <= last);
        let free: Vec<&Piece> = free.collect();
        let low = free.iter().map(|one| one.radii().0).min();
        let no_run_out =
            |needs: Half, room: Half| Err(Refusal::Not(NoJob::NoRunOut { surface: surface.name.clone(), needs, room }));
        let (to, pull_out) = match low {
            // Somewhere the contour is below the roots: a relief, a neck, or the end of a bore.
            Some(low) if low <= root => {
                let open = free.iter().find(|one| one.radii().0 <= root);
                let open = open.and_then(|one| {
                    let crossing = one.at_radius(root).iter().map(|at| at.z).min();
                    if one.from.radius <= root { Some(one.from.z) } else { crossing }
                });
                ((end + self.run_out).max(open.unwrap_or(end)), false)
            }
            None if stands.is_none() => (end + self.run_out, false),
            Some(low) if low < crest => {
                let diameter = |height: Half| -> Micrometres {
                    match site.side() {
                        Side::Outer => height.diameter(),
                        Side::Inner => (Half::ZERO - height).diameter(),
                    }
                };
                let (relief, root) = (diameter(low), diameter(root));
                return Err(Refusal::Not(NoJob::ReliefTooShallow { surface: surface.name.clone(), relief, root }));
            }
            // After the thread there is metal up to the crests: the tool is withdrawn from it, at 45° or flatter.
            _ => (end + self.run_out.max(crest - root + self.lift), true),
        };
        if pull_out {
            let in_metal =
                Half::from((to - end).to_mm() * ((crest - root).to_mm() / (crest - root + self.lift).to_mm()));
            self.runs_out(surface, behind, end + in_metal)?;
        }
        if let Some(stands) = stands {
            let (needs, room) = (to - end + insert, stands - end);
            if needs > room {
                return no_run_out(needs, room);
            }
        }
        Ok(Found { from, to, pull_out })
    }

    /// Whether the thread may run out in the metal behind it, to a Z.
    fn runs_out(self, surface: &Surface, behind: &[Surface], to: Half) -> Tried<(), NoJob> {
        let needs = to - self.thread.to.z;
        if needs > Half::of(self.longest) {
            let (surface, most) = (surface.name.clone(), self.longest);
            return Err(Refusal::Not(NoJob::RunOutTooLong { surface, needs, most }));
        }
        let scored = |next: &&Surface| next.pieces.first().is_some_and(|first| first.from.z < to);
        for seat in behind.iter().skip(1).take_while(scored) {
            if let Some(grade) = seat.grade.filter(|grade| f64::from(grade.number()) < self.finest) {
                let (surface, seat) = (surface.name.clone(), seat.name.clone());
                return Err(Refusal::Not(NoJob::RunOutOnSeat { surface, seat, grade }));
            }
        }
        Ok(())
    }
}
