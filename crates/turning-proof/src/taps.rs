//! Taps: the hole before them, their step with the spindle, and how deep their thread is full.

use crate::carry::{Carried, TOLERANCE, thickest};
use crate::fault::{Fault, What};
use crate::plane::{Convex, Region, Rule, Vector};
use crate::set_up::Motion;
use crate::target::Threaded;
use crate::tool::Cutter;
use crate::units::Mm;

/// How far the lead of a program may differ from the pitch, mm per turn: the last decimal that programs write.
pub(crate) const LEAD: f64 = 0.0001;

impl Carried<'_> {
    /// A motion of a tap at feed: what it swept, and its body.
    pub(crate) fn tap(&mut self, motion: &Motion, cuts: &[Convex], holds: &[Convex]) {
        let Cutter::Tap { diameter, pitch, lead, .. } = self.tool(motion).cutter else { return };
        self.take_off();
        let (from, to) = (motion.path.from(), motion.path.to());
        let cut = self.overlap(cuts, &[]).is_some();
        // In step, or at a feed per turn, which a chuck with compensation follows.
        let travel = motion.lead;
        if cut && travel.is_none_or(|travel| (travel.0 - pitch.0).abs() > LEAD) {
            self.fault(What::TapOutOfStep { pitch, lead: travel.unwrap_or_default() }, motion, to);
        }
        if let Some((width, at)) = self.overlap(holds, &[]) {
            self.fault(What::TapBlocked { width }, motion, at);
        }
        if to.z.0 >= from.z.0 {
            return;
        }
        let full = to.z.0 + lead.0;
        for index in 0..self.target.threads.len() {
            let thread = self.target.threads[index].clone();
            let Some(tap) = thread.thread.tap else { continue };
            let same = (tap.diameter.0 - diameter.0).abs() < TOLERANCE && (tap.pitch.0 - pitch.0).abs() < LEAD;
            // It comes from before the thread.
            if !same || full > thread.z[1] || from.z.0 < thread.z[1] {
                continue;
            }
            let deepest = self.tapped[index].map_or(full, |known: f64| known.min(full));
            self.tapped[index] = Some(deepest);
            if let Some((width, at)) = self.missing(&thread, tap.largest_hole.0 / 2.0, full) {
                let (what, surface) = (What::TapHoleWide { width }, thread.surface.clone());
                self.faults.add(Fault::of_surface(what, surface, Some(at), Some(motion.block)));
            }
        }
    }

    /// Metal that lacks around the hole of a thread, from the largest radius that it may have outwards.
    fn missing(&self, thread: &Threaded, largest: f64, full: f64) -> Option<(Mm, crate::units::At)> {
        let outside = thread.thread.tap.map_or(0.0, |tap| tap.diameter.0 / 2.0);
        let [end, begin] = thread.z;
        let from = Vector::new(end.max(full), largest + TOLERANCE);
        let ring = Convex::hull(Convex::rectangle(from, Vector::new(begin, outside)))?;
        thickest(&Region::pieces([&ring]).made(&self.stock.0, Rule::Without))
    }
}
