//! Threads outside that are left to the second set-up. Right-hand threads are cut towards the chuck: where the metal before one
//! leaves no room to begin, or the set-up ends where the thread does, it is cut from the other end, where both are free.

use crate::turning::contour::{Profile, Side, Surface, SurfaceKind};

/// The first surface of the first set-up that is left to the second one, by index; none if no thread asks for it, or if a later
/// surface stands higher than the thread and would be in the way from the other end.
///
/// Such a thread stands behind a cylinder of its own diameter (a stud, a shank with a thread at its far end), or it is the last
/// surface of the set-up (behind a neck, or a step up to it). A groove between them goes with it.
pub(super) fn begin(near: &Profile) -> Option<usize> {
    // Those of a bore are tapped, each from its own end, or turned from the end to which the bore widens.
    if near.side == Side::Inner {
        return None;
    }
    let top = |surface: &Surface| surface.pieces.iter().map(|piece| piece.radii().1).max();
    let is_thread = |surface: &Surface| surface.kind == SurfaceKind::Thread;
    near.surfaces.iter().enumerate().filter(|(_, surface)| is_thread(surface)).find_map(|(index, thread)| {
        let (before, from) = near.surfaces.split_at_checked(index)?;
        let behind = from.get(1..)?;
        let first = index - before.iter().rev().take_while(|surface| surface.is_groove()).count();
        let lead = before.iter().rev().find(|surface| !surface.is_groove() && surface.kind != SurfaceKind::Chamfer)?;
        let free_end = before.first().is_some_and(|first| std::ptr::eq(first, lead));
        let stands_before = !lead.is_face() && top(lead) >= top(thread);
        let ends = lead.is_face() && !free_end && behind.is_empty();
        let free = behind.iter().all(|surface| top(surface) <= top(thread));
        (free && (stands_before || ends)).then_some(first)
    })
}
