//! Roughing passes over a contour, in the frame of [`super::contour`].
//!
//! [`hollows`] is the method of G71 and G72 of LinuxCNC 2.9, determined by running its own interpreter and from its
//! published behaviour. It works downwards from the start, level by level: at each level at feed to the contour, and
//! back at rapid. Where a falling element ends, it follows the rising contour to the next pocket, which it clears in
//! the same way. [`levels`] is the simple method of G71 of Fanuc, type I, and of CYCLE95: level by level from one
//! start.

use super::contour::{Leg, PassPoint, Round, SAME, Stroke};

/// Why passes cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NoPasses {
    /// More motions than the budget.
    TooMany,
    /// A level lies above the element that leads to it.
    Above,
}

/// The parameters of passes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passes {
    /// Distance between levels.
    pub depth: f64,
    /// Retract from the cut, along both axes.
    pub retract: f64,
    /// The most motions.
    pub budget: usize,
}

/// The passes over a contour with pockets; the first element leads from the start down to the contour.
pub(super) fn hollows(legs: &[Leg], passes: Passes) -> Result<Vec<Stroke>, NoPasses> {
    let Some(first) = legs.first() else { return Ok(Vec::new()) };
    let mut roughing = HollowRoughing {
        legs,
        passes,
        strokes: vec![Stroke::Rapid(first.from)],
        at: first.from,
        top: first.from.x,
        left: passes.budget,
    };
    let mut from = Some(0);
    // Each iteration clears one pocket; following the contour then finds the next.
    while let Some(index) = from {
        from = roughing.hollow(index)?;
    }
    Ok(roughing.strokes)
}

/// Where the descent along an element ended.
enum Down {
    /// It does not fall.
    Rises,
    /// It fell to its end or to the level.
    Fell,
}

struct HollowRoughing<'a> {
    legs: &'a [Leg],
    passes: Passes,
    strokes: Vec<Stroke>,
    at: PassPoint,
    top: f64,
    left: usize,
}

impl HollowRoughing<'_> {
    fn push_stroke(&mut self, stroke: Stroke) {
        self.strokes.push(stroke);
        self.at = stroke.end();
    }

    fn spend(&mut self) -> Result<(), NoPasses> {
        self.left = self.left.checked_sub(1).ok_or(NoPasses::TooMany)?;
        Ok(())
    }

    /// Clears a pocket, then follows the contour up after it; returns the element that falls into the next pocket.
    fn hollow(&mut self, mut index: usize) -> Result<Option<usize>, NoPasses> {
        let mut level = self.top;
        while index < self.legs.len() {
            while level > self.at.x {
                self.spend()?;
                level -= self.passes.depth;
            }
            self.spend()?;
            if matches!(self.down(index, level)?, Down::Rises) {
                return Ok(self.up(index));
            }
            if self.at.x > level + SAME || self.at.x < level - SAME {
                index += 1;
                continue;
            }
            if self.pass(&mut index) {
                level -= self.passes.depth;
            }
        }
        Ok(None)
    }

    /// Down an element as far as the level; the first element at rapid.
    fn down(&mut self, index: usize, level: f64) -> Result<Down, NoPasses> {
        let Some(leg) = self.legs.get(index).copied() else { return Ok(Down::Rises) };
        let Some(round) = leg.round else {
            if leg.from.x <= leg.to.x {
                return Ok(Down::Rises);
            }
            let end = if level < leg.to.x {
                leg.to
            } else {
                let z = leg.crossings(level).first().copied().ok_or(NoPasses::Above)?;
                PassPoint { z, x: level }
            };
            self.push_stroke(if index == 0 { Stroke::Rapid(end) } else { Stroke::Line(end) });
            return Ok(Down::Fell);
        };
        if self.at.to(leg.to) < 1e-3 {
            return Ok(Down::Fell);
        }
        let crossings = leg.crossings(level);
        // A convex arc falls after its top, a concave one before its bottom.
        let falls = if round.ccw { self.at.z <= round.centre.z + SAME } else { self.at.z > round.centre.z + SAME };
        if !falls {
            return Ok(Down::Rises);
        }
        let met = if round.ccw {
            crossings.last().copied().filter(|z| *z <= round.centre.z)
        } else {
            crossings.first().copied().filter(|z| *z >= round.centre.z)
        };
        let end = met.map_or(leg.to, |z| PassPoint { z, x: level });
        self.arc(round, end, met.is_none());
        Ok(Down::Fell)
    }

    /// An arc, unless it is too short to matter.
    fn arc(&mut self, round: Round, end: PassPoint, always: bool) {
        if always || self.at.to(end) > 1e-3 {
            self.strokes.push(Stroke::Arc(round, end));
        }
        self.at = end;
    }

    /// Follows the contour from here; returns the element where it falls again.
    fn up(&mut self, from: usize) -> Option<usize> {
        for index in from..self.legs.len() {
            let leg = *self.legs.get(index)?;
            match leg.round {
                None if leg.to.x < leg.from.x => return Some(index),
                None => self.push_stroke(Stroke::Line(leg.to)),
                Some(round) if !round.ccw => {
                    if self.at.z > round.centre.z + SAME {
                        return Some(index);
                    }
                    self.arc(round, leg.to, false);
                }
                Some(round) => {
                    if self.at.z < round.centre.z - SAME {
                        return Some(index);
                    }
                    let radius = leg.from.to(round.centre);
                    let over = leg.to.z < round.centre.z;
                    let top = PassPoint { z: round.centre.z, x: round.centre.x + radius };
                    self.arc(round, if over { top } else { leg.to }, false);
                    return Some(index);
                }
            }
        }
        None
    }

    /// One pass at the level up to the contour; returns whether the level is done.
    fn pass(&mut self, index: &mut usize) -> bool {
        let here = self.at;
        for ahead in *index..self.legs.len() {
            let crossings = self.legs.get(ahead).map(|leg| leg.crossings(here.x)).unwrap_or_default();
            let met = if ahead == *index { crossings.last() } else { crossings.first() };
            let Some(z) = met.copied() else { continue };
            let distance = (z - here.z).abs();
            if distance < SAME {
                if ahead == *index {
                    continue;
                }
                // At the foot of an element the walk continues with the next one; in a descent without width there is
                // nothing to cut at this level.
                let at_foot = self.legs.get(*index).is_some_and(|leg| leg.to.to(here) < SAME);
                *index += usize::from(at_foot);
                return !at_foot;
            }
            self.push_stroke(Stroke::Line(PassPoint { z, x: here.x }));
            // A short pass retracts by at most half its length.
            let back = self.passes.retract * (distance / 2.0 / self.passes.retract).min(1.0);
            self.push_stroke(Stroke::Rapid(PassPoint { z: z + back, x: here.x + back }));
            self.push_stroke(Stroke::Rapid(PassPoint { z: here.z - back, x: here.x + back }));
            self.push_stroke(if *index == 0 { Stroke::Rapid(here) } else { Stroke::Line(here) });
            return true;
        }
        // No contour follows: continue with the next element.
        *index += 1;
        false
    }
}

/// The motions between two levels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Between {
    /// Whether the tool goes down to a level at rapid.
    pub down_at_rapid: bool,
    /// Whether it follows the contour up to the previous level.
    pub along_contour: bool,
}

/// Passes level by level from one start to a contour that only rises; all of them are open to the start.
///
/// `lowest` is the height below which passes cut nothing.
pub(super) fn levels(
    begin: PassPoint,
    legs: &[Leg],
    lowest: f64,
    passes: Passes,
    between: Between,
) -> Result<Vec<Stroke>, NoPasses> {
    let mut strokes = Vec::new();
    let mut before = begin.x;
    while before - passes.depth > lowest + SAME {
        let level = before - passes.depth;
        let here = PassPoint { z: begin.z, x: level };
        // The element with the largest z meets the pass first.
        let met = legs.iter().enumerate().find_map(|(index, leg)| {
            let z = leg
                .crossings(level)
                .into_iter()
                .filter(|z| *z < begin.z - SAME)
                .fold(None, |most: Option<f64>, z| Some(most.map_or(z, |most| most.max(z))))?;
            Some((index, z))
        });
        let Some((index, z)) = met else { break };
        strokes.push(if between.down_at_rapid { Stroke::Rapid(here) } else { Stroke::Line(here) });
        strokes.push(Stroke::Line(PassPoint { z, x: level }));
        let mut at = PassPoint { z, x: level };
        if between.along_contour {
            for leg in legs.iter().skip(index) {
                let end = leg.crossings(before).first().map_or(leg.to, |z| PassPoint { z: *z, x: before });
                if at.to(end) > SAME {
                    strokes.push(leg.round.map_or(Stroke::Line(end), |round| Stroke::Arc(round, end)));
                }
                at = end;
                if (at.x - before).abs() < SAME {
                    break;
                }
            }
        }
        strokes.push(Stroke::Rapid(PassPoint { z: at.z + passes.retract, x: at.x + passes.retract }));
        strokes.push(Stroke::Rapid(PassPoint { z: begin.z, x: at.x + passes.retract }));
        if strokes.len() > passes.budget {
            return Err(NoPasses::TooMany);
        }
        before = level;
    }
    Ok(strokes)
}
