//! How much of the length of a thread its passes cut to the depth, and whether all of them run in one groove.

use crate::carry::TOLERANCE;
use crate::fault::{Fault, What};
use crate::plane::Vector;
use crate::set_up::Motion;
use crate::taps::LEAD;
use crate::target::Threaded;
use crate::tool::{Cutter, Side, Tool};
use crate::units::{At, Degrees, Mm};

/// How long a stretch of a thread may lack its depth, in pitches: the profile of the last turn is half a pitch wide to each side
/// of the point that cuts it.
const SPARE: f64 = 0.5;

/// The angle of the metric profile (ISO 68-1), for a pass by a tool that is none for threads.
const METRIC: Degrees = Degrees(60.0);

/// A pass that cuts a thread.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pass {
    motion: Motion,
    /// The radius of its point where it is deepest, mm.
    radius: f64,
    /// How often the spindle has turned when the point is at the middle of the thread.
    turns: f64,
    /// How far each flank opens along the axis for 1 mm of depth, mm.
    slope: f64,
}

impl Pass {
    fn is_towards_chuck(&self) -> bool {
        self.motion.path.to().z.0 < self.motion.path.from().z.0
    }
}

impl Threaded {
    /// A fault of the whole thread.
    pub(crate) fn fault(&self, what: What) -> Fault {
        Fault::of_surface(what, self.surface.clone(), None, None)
    }

    fn fault_of_pass(&self, what: What, at: At, motion: &Motion) -> Fault {
        Fault::of_surface(what, self.surface.clone(), Some(at), Some(motion.block))
    }

    /// Whether a tool may cut it: one of the other side passes it by, however deep its point is. Which tool of its own side
    /// cuts it does not matter here.
    pub(crate) fn is_cut_by(&self, tool: &Tool) -> bool {
        let own = if self.thread.root.0 < self.thread.crest.0 { Side::Outside } else { Side::Inside };
        tool.cutter.side().is_none_or(|side| side == own)
    }

    /// The stretch along Z in which a straight pass is deep enough, ascending; a pass that is drawn out is so up to there.
    pub(crate) fn deep(&self, from: Vector, to: Vector) -> Option<[f64; 2]> {
        let (crest, shallow) = (self.thread.crest.0, self.thread.shallow.0);
        let beyond = |radius: f64| (radius - shallow) * (shallow - crest).signum() + TOLERANCE;
        let (first, last) = (beyond(from.r), beyond(to.r));
        let turns = || from.z + (to.z - from.z) * first / (first - last);
        let [one, other] = match (first >= 0.0, last >= 0.0) {
            (true, true) => [from.z, to.z],
            (true, false) => [from.z, turns()],
            (false, true) => [turns(), to.z],
            (false, false) => return None,
        };
        Some([one.min(other), one.max(other)])
    }

    /// A motion in step with the spindle, which has turned so often when it starts, if it cuts the thread; the pass, or
    /// that it is not fed by the pitch.
    pub(crate) fn pass(&self, motion: &Motion, tool: &Tool, begun: f64) -> Option<Result<Pass, Fault>> {
        let (from, to) = (motion.path.from().spot(), motion.path.to().spot());
        let along = to.z - from.z;
        let (least, most) = (from.z.min(to.z).max(self.z[0]), from.z.max(to.z).min(self.z[1]));
        if most - least <= TOLERANCE || !self.is_cut_by(tool) {
            return None;
        }
        let at = |z: f64| from.r + (to.r - from.r) * (z - from.z) / along;
        let (crest, root) = (self.thread.crest.0, self.thread.root.0);
        let depth = |radius: f64| (radius - crest) * (root - crest).signum();
        let radius = if depth(at(least)) > depth(at(most)) { at(least) } else { at(most) };
        let lead = motion.lead.filter(|_| depth(radius) > TOLERANCE)?;
        let (pitch, share) = (self.thread.pitch, along.abs() / to.minus(from).length());
        if (lead.0 * share - pitch.0).abs() > LEAD {
            return Some(Err(self.fault_of_pass(What::ThreadLead { pitch, lead }, motion.path.to(), motion)));
        }
        let middle = (self.z[0] + self.z[1]) / 2.0;
        let turns = begun + (middle - from.z) * along.signum() / (lead.0 * share);
        let angle = match tool.cutter {
            Cutter::Thread { angle, .. } => angle,
            _ => METRIC,
        };
        let slope = libm::tan((angle.0 / 2.0).to_radians());
        Some(Ok(Pass { motion: *motion, radius, turns, slope }))
    }

    /// Passes beside the groove of the deepest one. Each makes a groove as wide as its own depth; what lies outside of the deepest
    /// groove widens it, which is as if the point had gone so much deeper. Found where that leaves the limits of the pitch diameter.
    pub(crate) fn out_of_step(&self, passes: &[Pass]) -> Vec<Fault> {
        let outwards = (self.thread.root.0 - self.thread.crest.0).signum();
        let Some(deepest) = passes.iter().max_by(|a, b| (a.radius * outwards).total_cmp(&(b.radius * outwards))) else {
            return Vec::new();
        };
        let pitch = self.thread.pitch.0;
        // Thread by thread the helix rises the other way where a pass goes away from the chuck.
        let shift = |pass: &Pass| {
            let turns = pass.turns - deepest.turns;
            let off = (turns - libm::round(turns)) * pitch;
            if pass.is_towards_chuck() == deepest.is_towards_chuck() { off } else { pitch / 2.0 }
        };
        let beside = |pass: &Pass| {
            let above = (deepest.radius - pass.radius) * outwards;
            (shift(pass).abs() - above * pass.slope).max(0.0)
        };
        let widened = |sign: f64| passes.iter().filter(|one| shift(one) * sign > 0.0).map(beside).fold(0.0, f64::max);
        let as_if = deepest.radius + outwards * (widened(1.0) + widened(-1.0)) / (2.0 * deepest.slope);
        if (as_if - self.thread.root.0) * outwards <= TOLERANCE {
            return Vec::new();
        }
        let out = passes.iter().filter(|pass| beside(pass) > TOLERANCE);
        let fault = |pass: &Pass| {
            let beside = What::ThreadPhase { pitch: self.thread.pitch, shift: Mm(shift(pass).abs()) };
            self.fault_of_pass(beside, pass.motion.path.from(), &pass.motion)
        };
        out.map(fault).collect()
    }

    /// The longest stretch that none of these covers, ascending; none if it is within the last turn.
    pub(crate) fn widest_gap(&self, full: &[[f64; 2]]) -> Option<[f64; 2]> {
        let [end, begin] = self.z;
        let mut full: Vec<[f64; 2]> = full.to_vec();
        full.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let (mut known, mut widest) = (end, [end, end]);
        for [least, most] in full.into_iter().chain([[begin, begin]]) {
            let gap = [known, least.min(begin)];
            if gap[1] - gap[0] > widest[1] - widest[0] {
                widest = gap;
            }
            known = known.max(most);
        }
        (widest[1] - widest[0] > SPARE * self.thread.pitch.0 + TOLERANCE).then_some(widest)
    }
}
