//! Widths of the holes of a program held against one another, where comments name its tools and their diameters: a wide tool at
//! rapid in a narrow hole, taps in the holes of other threads, tools that only widen holes before there is one, feeds of drills.

use super::below::{BELOW, Measure, Seen, ToldBelow};
use super::drilled::{Hole, Holes, Review, place};
use super::named::Names;
use crate::motion::MotionStep;
use crate::note::Note;
use crate::tables::audit::ToolKind;
use crate::units::round_to;

/// By how much a tool may be wider than its hole and still be said to fit, mm: diameters of drills are rounded.
const FITS: f64 = 0.2;
/// How high the point of a drill is, as a part of its diameter: that of 118°, half its diameter / tan 59°.
const POINT: f64 = 0.3;
/// The most holes of a place that are looked through for every rapid.
const MOST: usize = 50;
/// How near depths are one, mm.
const SAME: f64 = 0.01;

/// The diameter that a tool has at its end, mm, and the height of its end, where it is not of that diameter yet.
fn width(names: &Names, tool: u32) -> Option<(f64, f64)> {
    let kind = names.kind(tool)?;
    let diameter = names.diameter(tool)?;
    match kind {
        ToolKind::Drill => Some((diameter, POINT * diameter)),
        ToolKind::CoreDrill | ToolKind::Ream | ToolKind::Mill | ToolKind::Counterbore => Some((diameter, 0.0)),
        ToolKind::Centring | ToolKind::Bore | ToolKind::Tap | ToolKind::Countersink | ToolKind::Chamfer => None,
    }
}

/// Whether its tool only marks a place or breaks an edge.
fn marks(names: &Names, hole: &Hole) -> bool {
    let kind = names.kind(hole.tool);
    matches!(kind, Some(ToolKind::Centring | ToolKind::Countersink | ToolKind::Chamfer))
}

/// Whether its tool is a reamer. Of the holes of a core drill some may be cast.
pub(super) fn reams(names: &Names, hole: &Hole) -> bool {
    names.kind(hole.tool) == Some(ToolKind::Ream)
}

/// The width of the widest of these holes that goes down to there, where all of them are known.
fn widest<'h>(names: &Names, holes: impl Iterator<Item = &'h Hole>, z: f64) -> Option<f64> {
    let mut most = None::<f64>;
    for hole in holes {
        if hole.mills || hole.begin < -BELOW {
            return None;
        }
        // What breaks an edge or marks the place is wide only there.
        let narrow = names.kind(hole.tool).is_some_and(|kind| {
            matches!(kind, ToolKind::Centring | ToolKind::Countersink | ToolKind::Chamfer | ToolKind::Tap)
        });
        if narrow {
            continue;
        }
        let (diameter, _) = width(names, hole.tool)?;
        if hole.bottom <= z + BELOW {
            most = Some(most.map_or(diameter, |most| most.max(diameter)));
        }
    }
    most
}

/// A rapid down into a hole of the program that is narrower than the tool.
pub(super) fn comes_down(
    holes: &Holes,
    step: &MotionStep,
    z: f64,
    seen: Seen,
    measure: &Measure,
    told: &mut Vec<ToldBelow>,
) {
    let Some((own, end)) = width(&measure.names, seen.tool).filter(|(_, end)| z < -end - BELOW) else { return };
    let there = holes.of(place(seen.system, step.at)).take_while(|hole| hole.section != holes.section()).take(MOST);
    let Some(other) = widest(&measure.names, there, z).filter(|other| own > other + FITS) else { return };
    let code = "rapid-into-narrower";
    let note = Note::new(code).with("tool", seen.tool).with("z", round_to(z + end, 3));
    let note = note.with("diameter", own).with("other", other);
    if !told.iter().any(|(_, known, other)| *known == code && *other == note) {
        told.push((step.block, code, note));
    }
}

impl<M: Fn([f64; 2], f64) -> bool> Review<'_, M> {
    /// What is told of the widths of a hole.
    pub fn widths(&mut self, index: usize, hole: &Hole) {
        let names = &self.measure.names;
        let kind = names.kind(hole.tool);
        if let Some((diameter, end)) = width(names, hole.tool) {
            self.feed_of_drill(index, hole, diameter, kind);
            if hole.begin < -end - BELOW && !hole.milled && !hole.mills {
                self.begins_in_narrower(index, hole, diameter);
            }
        }
        if hole.mills {
            return;
        }
        match kind {
            Some(ToolKind::Tap) => self.hole_of_thread(index, hole),
            Some(kind @ (ToolKind::Ream | ToolKind::CoreDrill | ToolKind::Bore)) => {
                self.deeper_than_hole(index, hole, kind);
                if kind == ToolKind::Ream {
                    self.hole_of_reamer(index, hole);
                }
            }
            _ => {}
        }
        self.made_later(index, hole, kind);
    }

    /// A feed for a turn that no table gives a drill. Drilling out is fed up to twice as fast as drilling (table `feed-step`); what
    /// only marks the place or breaks its edge is drilled as solid metal.
    fn feed_of_drill(&mut self, index: usize, hole: &Hole, diameter: f64, kind: Option<ToolKind>) {
        // A feed by hand that ends above the zero may be a way through the air.
        if hole.bottom > -BELOW && !hole.in_cycle {
            return;
        }
        let names = &self.measure.names;
        let drilled_out = self.earlier(index, hole).any(|other| other.section != hole.section && !marks(names, other));
        let most = self.measure.drill_feed * diameter * if drilled_out { 2.0 } else { 1.0 };
        if kind == Some(ToolKind::Drill) && hole.pitch.is_none() && hole.per_turn.is_finite() && hole.per_turn > most {
            let feed = round_to(hole.per_turn, 3);
            self.tell(hole, "drill-feed", |note| {
                note.with("feed", feed).with("diameter", diameter).with("most", round_to(most, 3))
            });
        }
    }

    /// A feed that begins inside a hole narrower than the tool.
    fn begins_in_narrower(&mut self, index: usize, hole: &Hole, diameter: f64) {
        let there = self.earlier(index, hole).filter(|other| other.section != hole.section);
        let other = widest(&self.measure.names, there, hole.begin);
        if let Some(other) = other.filter(|other| diameter > other + FITS) {
            self.tell(hole, "rapid-into-narrower", |note| {
                note.with("z", round_to(hole.begin, 3)).with("diameter", diameter).with("other", other)
            });
        }
    }

    /// A tap in a hole that its own drill has not made.
    fn hole_of_thread(&mut self, index: usize, hole: &Hole) {
        let threads = self.measure.names.threads(hole.tool);
        let Some((thread, size)) = threads.first().and_then(|thread| Some((thread.clone(), thread.diameter?))) else {
            return;
        };
        if threads.iter().any(|other| *other != thread) {
            return;
        }
        let there = || self.earlier(index, hole).filter(|other| other.section != hole.section);
        let beyond = self.measure.beyond * thread.pitch;
        let Some(drilled) = widest(&self.measure.names, there(), hole.bottom + beyond) else { return };
        let (least, most) = self.measure.tap_hole;
        // A wide hole over that of the thread does not go down to its end.
        if let Some(drilled) = widest(&self.measure.names, there(), hole.bottom).filter(|drilled| *drilled >= size) {
            let needed = round_to(size - thread.pitch, 2);
            let figures =
                |note: Note| note.with("thread", thread.name).with("diameter", drilled).with("needed", needed);
            return self.tell(hole, "tap-hole-no-thread", figures);
        }
        let code = if drilled < size - most * thread.pitch {
            "tap-hole-narrow"
        } else if drilled > size - least * thread.pitch {
            "tap-hole-wide"
        } else {
            return;
        };
        let needed = round_to(size - thread.pitch, 2);
        self.tell(hole, code, |note| note.with("thread", thread.name).with("diameter", drilled).with("needed", needed));
    }

    /// A reamer in a hole that is no narrower than it, or narrower by more than reamers take.
    fn hole_of_reamer(&mut self, index: usize, hole: &Hole) {
        let names = &self.measure.names;
        let Some(own) = names.diameter(hole.tool) else { return };
        let there = self.earlier(index, hole).filter(|other| other.section != hole.section);
        let Some(drilled) = widest(names, there, hole.bottom) else { return };
        let code = if drilled > own + SAME {
            "ream-hole-wide"
        } else if own - drilled > self.measure.reamer_stock {
            "ream-hole-narrow"
        } else {
            return;
        };
        let most = self.measure.reamer_stock;
        self.tell(hole, code, |note| note.with("diameter", own).with("other", drilled).with("most", most));
    }

    /// A reamer where nothing was made, while other holes were drilled for it.
    pub fn widens_nothing(&mut self, index: usize, hole: &Hole) {
        let others = |other: &&Hole| other.section != hole.section;
        let made = self.earlier(index, hole).any(|other| others(&other) && !marks(&self.measure.names, other));
        if !made && !self.later(index, hole).any(|other| others(&other)) && !hole.mills && !self.is_milled(hole) {
            self.tell(hole, "widens-no-hole", |note| note);
        }
    }

    /// Whether it is a reamer in a hole that a drill of the program made.
    pub fn widens_drilled(&self, index: usize, hole: &Hole) -> bool {
        let names = &self.measure.names;
        let drilled = |other: &Hole| names.kind(other.tool) == Some(ToolKind::Drill) && other.section != hole.section;
        reams(names, hole) && self.earlier(index, hole).any(drilled)
    }

    /// A tool that only widens holes, fed deeper than the hole. A boring bar may go down what was cast.
    fn deeper_than_hole(&mut self, index: usize, hole: &Hole, kind: ToolKind) {
        let there = || self.earlier(index, hole).filter(|other| other.section != hole.section && !other.mills);
        let names = &self.measure.names;
        let drilled = there().any(|other| match names.kind(other.tool) {
            Some(ToolKind::Drill) => true,
            Some(ToolKind::CoreDrill | ToolKind::Bore) => kind != ToolKind::Bore,
            _ => false,
        });
        let Some(bottom) = there().map(|other| other.bottom).reduce(f64::min).filter(|_| drilled) else { return };
        if bottom <= hole.bottom + SAME || self.is_milled(hole) {
            return;
        }
        let through = bottom - hole.bottom <= self.measure.reamer_beyond;
        let code = if through { "widens-beyond-hole-maybe" } else { "widens-beyond-hole" };
        self.tell(hole, code, |note| note.with("z", round_to(hole.bottom, 3)).with("other", round_to(bottom, 3)));
    }

    /// A tool that needs a hole, where the program makes it only afterwards.
    fn made_later(&mut self, index: usize, hole: &Hole, kind: Option<ToolKind>) {
        let code = match kind {
            Some(ToolKind::Ream | ToolKind::CoreDrill | ToolKind::Bore | ToolKind::Tap) => "hole-made-later",
            Some(ToolKind::Counterbore) => "hole-made-later-maybe",
            _ => return,
        };
        let names = &self.measure.names;
        let others = |other: &&Hole| other.section != hole.section && !marks(names, other);
        let drilled = |other: &Hole| names.kind(other.tool) == Some(ToolKind::Drill) && other.stops == hole.stops;
        let later = self.later(index, hole).filter(others).find(|other| drilled(other)).copied();
        let Some(later) = later.filter(|_| !self.earlier(index, hole).any(|other| others(&other))) else { return };
        // Another hole begins where this one ends.
        if later.begin < -BELOW || self.is_milled(hole) {
            return;
        }
        self.tell(hole, code, |note| note.with("other", later.tool));
    }
}
