//! Faults of a program, as types; each makes its own note.

use std::collections::BTreeMap;

use crate::note::{Figure, Note};
use crate::set_up::{MotionKind, Size};
use crate::units::{At, Block, Mm};

/// A fault, once for each surface, tool or body: its worst place, and how often.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// The finished part is cut (gouge).
    Gouge {
        /// The surface; none if its piece has no name.
        surface: Option<Figure>,
        /// The greatest depth below the surface with its allowance, along its normal.
        depth: Mm,
        /// The deepest place.
        at: At,
        /// Its block.
        block: Block,
        /// The number of places, motion by motion.
        count: usize,
    },
    /// A cutter moves through metal at rapid.
    RapidCut {
        /// The tool's designation.
        tool: String,
        /// The width of the metal it hits, where it is narrowest.
        width: Mm,
        /// The middle of it.
        at: At,
        /// Its block.
        block: Block,
        /// The number of motions.
        count: usize,
    },
    /// A shank, a bar or the non-cutting part of a drill moves through metal.
    Holder {
        /// The tool's designation.
        tool: String,
        /// The width of the metal it hits, where it is narrowest.
        width: Mm,
        /// The middle of it.
        at: At,
        /// The kind of the worst motion.
        kind: MotionKind,
        /// Its block.
        block: Block,
        /// The number of motions.
        count: usize,
    },
    /// A tool collides with a jaw, a centre or a steady rest.
    Struck {
        /// The tool's designation.
        tool: String,
        /// The body it hits.
        body: Figure,
        /// The width of the overlap, where it is narrowest.
        width: Mm,
        /// The middle of it.
        at: At,
        /// Its block.
        block: Block,
        /// The number of motions.
        count: usize,
    },
    /// A drill cuts off the axis or sideways.
    OffAxis {
        /// The tool's designation.
        tool: String,
        /// The end of the motion.
        at: At,
        /// Its block.
        block: Block,
        /// The number of motions.
        count: usize,
    },
    /// Metal remains over a surface.
    Stands {
        /// The surface; none if its piece has no name.
        surface: Option<Figure>,
        /// The greatest thickness over the surface with its allowance, along its normal.
        thickness: Mm,
        /// The thickest place.
        at: At,
        /// The end of the remaining metal at the free end.
        from_z: Mm,
        /// Its end at the chuck.
        to_z: Mm,
    },
    /// A size is outside of its limits.
    OffSize {
        /// The surface; none if its piece has no name.
        surface: Option<Figure>,
        /// What was measured.
        size: Size,
        /// How large it is.
        measured: Mm,
        /// The least that is permitted.
        least: Mm,
        /// The most that is permitted.
        most: Mm,
        /// Whether metal is missing, so that nothing can mend it.
        missing: bool,
        /// Where it was measured, along the axis.
        z: Mm,
        /// The block that made it, if it is known.
        block: Option<Block>,
    },
    /// An inner corner keeps the rounding of the nose that made it.
    Corner {
        /// The surface nearest to the remaining metal.
        surface: Option<Figure>,
        /// The radius of the nose.
        radius: Mm,
        /// The greatest distance of the rounding from the sides of the corner.
        left: Mm,
        /// Its place.
        at: At,
        /// The number of corners.
        count: usize,
    },
    /// A tap meets metal that its drill should have removed: no hole, a narrower one, or the bottom.
    TapBlocked {
        /// The tool's designation.
        tool: String,
        /// The width of the metal, where it is narrowest.
        width: Mm,
        /// The middle of it.
        at: At,
        /// Its block.
        block: Block,
        /// The number of motions.
        count: usize,
    },
    /// A tap cuts, and the feed is not in step with the spindle by its pitch.
    TapOutOfStep {
        /// The tool's designation.
        tool: String,
        /// Its pitch.
        pitch: Mm,
        /// The travel per turn; zero where the program gives none.
        lead: Mm,
        /// The end of the motion.
        at: At,
        /// Its block.
        block: Block,
        /// The number of motions.
        count: usize,
    },
    /// A pass of a thread is not fed by its pitch.
    ThreadLead {
        /// The thread's surface.
        surface: Option<Figure>,
        /// Its pitch.
        pitch: Mm,
        /// The travel per turn.
        lead: Mm,
        /// The end of the pass.
        at: At,
        /// Its block.
        block: Block,
        /// The number of passes.
        count: usize,
    },
    /// The hole before a tap is wider than the tolerance of the minor diameter.
    TapHoleWide {
        /// The thread's surface.
        surface: Option<Figure>,
        /// The metal that is missing, radial.
        width: Mm,
        /// The middle of it.
        at: At,
        /// The block of the tap.
        block: Block,
        /// The number of motions.
        count: usize,
    },
    /// The full thread of a tap ends before that of the drawing.
    ThreadShort {
        /// The thread's surface.
        surface: Option<Figure>,
        /// The length that is missing.
        left: Mm,
    },
    /// Passes go down to the root of a thread only along a part of its length.
    ThreadPart {
        /// The thread's surface.
        surface: Option<Figure>,
        /// The longest stretch without its depth.
        left: Mm,
        /// Where that begins, at the free end.
        from_z: Mm,
        /// Its end at the chuck.
        to_z: Mm,
    },
    /// A tool on the axis goes in deeper than its flutes, its cone or its reach.
    Buried {
        /// Its designation.
        tool: String,
        /// How much of its shank is in the hole.
        depth: Mm,
        /// Where the hole closes round it.
        at: At,
        /// The block.
        block: Block,
        /// The number of motions.
        count: usize,
    },
    /// A pass of a thread runs beside the groove of its deepest pass: they start at other angles of the spindle.
    ThreadPhase {
        /// The thread's surface.
        surface: Option<Figure>,
        /// The pitch of the thread.
        pitch: Mm,
        /// How far beside it is along the axis.
        shift: Mm,
        /// Where the pass starts.
        at: At,
        /// The block.
        block: Block,
        /// The number of passes.
        count: usize,
    },
    /// No pass of a thread goes down to its root.
    ThreadShallow {
        /// The thread's surface.
        surface: Option<Figure>,
        /// The distance of the deepest pass from the root.
        left: Mm,
    },
}

impl Fault {
    /// Its stable code, the same as that of its note.
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Gouge { .. } => "swept-gouge",
            Self::RapidCut { .. } => "swept-rapid",
            Self::Holder { kind: MotionKind::Rapid, .. } => "swept-holder-rapid",
            Self::Holder { .. } => "swept-holder",
            Self::Struck { .. } => "swept-struck",
            Self::OffAxis { .. } => "swept-off-axis",
            Self::Stands { .. } => "swept-stands",
            Self::OffSize { size: Size::Diameter, missing: false, .. } => "swept-size-left",
            Self::OffSize { size: Size::Diameter, missing: true, .. } => "swept-size-lost",
            Self::OffSize { missing: false, .. } => "swept-length-left",
            Self::OffSize { missing: true, .. } => "swept-length-lost",
            Self::Corner { .. } => "swept-corner",
            Self::ThreadShallow { .. } => "swept-thread-shallow",
            Self::ThreadPart { .. } => "swept-thread-part",
            Self::ThreadLead { .. } => "swept-thread-lead",
            Self::ThreadPhase { .. } => "swept-thread-phase",
            Self::Buried { .. } => "swept-buried",
            Self::TapBlocked { .. } => "swept-tap-blocked",
            Self::TapOutOfStep { .. } => "swept-tap-out-of-step",
            Self::TapHoleWide { .. } => "swept-tap-hole-wide",
            Self::ThreadShort { .. } => "swept-thread-short",
        }
    }

    /// The block of its worst place; none for metal that remains at the end.
    pub const fn block(&self) -> Option<Block> {
        match self {
            Self::Gouge { block, .. }
            | Self::RapidCut { block, .. }
            | Self::Holder { block, .. }
            | Self::Struck { block, .. }
            | Self::OffAxis { block, .. }
            | Self::TapBlocked { block, .. }
            | Self::TapOutOfStep { block, .. }
            | Self::ThreadLead { block, .. }
            | Self::ThreadPhase { block, .. }
            | Self::Buried { block, .. }
            | Self::TapHoleWide { block, .. } => Some(*block),
            Self::OffSize { block, .. } => *block,
            Self::Stands { .. }
            | Self::Corner { .. }
            | Self::ThreadShallow { .. }
            | Self::ThreadShort { .. }
            | Self::ThreadPart { .. } => None,
        }
    }

    /// Whether it is only a note: the rounding that every nose leaves.
    pub const fn is_mild(&self) -> bool {
        matches!(self, Self::Corner { .. })
    }

    /// The sentence.
    pub fn note(&self) -> Note {
        let code = self.code();
        let placed = |at: &At| Note::new(code).with("z", at.z).with("diameter", Mm(2.0 * at.radius.0.abs()));
        let of_surface = |note: Note, surface: &Option<Figure>| {
            note.with("surface", surface.clone().unwrap_or_else(|| Figure::word("surface-without-name")))
        };
        match self {
            Self::Gouge { surface, depth, at, count, .. } => {
                of_surface(placed(at), surface).with("depth", depth).with("count", count)
            }
            Self::TapOutOfStep { tool, pitch, lead, at, count, .. } => {
                let note = Note::new(code).with("z", at.z).with("tool", tool);
                note.with("pitch", pitch).with("lead", lead).with("count", count)
            }
            Self::ThreadLead { surface, pitch, lead, at, count, .. } => {
                let note = of_surface(Note::new(code).with("z", at.z), surface);
                note.with("pitch", pitch).with("lead", lead).with("count", count)
            }
            Self::Buried { tool, depth, at, count, .. } => {
                Note::new(code).with("z", at.z).with("tool", tool).with("depth", depth).with("count", count)
            }
            Self::ThreadPhase { surface, pitch, shift, at, count, .. } => {
                let note = of_surface(Note::new(code).with("z", at.z), surface).with("pitch", pitch);
                note.with("shift", shift).with("count", count)
            }
            Self::TapHoleWide { surface, width, at, count, .. } => {
                of_surface(placed(at), surface).with("width", width).with("count", count)
            }
            Self::RapidCut { tool, width, at, count, .. }
            | Self::Holder { tool, width, at, count, .. }
            | Self::TapBlocked { tool, width, at, count, .. } => {
                placed(at).with("tool", tool).with("width", width).with("count", count)
            }
            Self::Struck { tool, body, width, at, count, .. } => {
                placed(at).with("tool", tool).with("body", body).with("width", width).with("count", count)
            }
            Self::OffAxis { tool, at, count, .. } => placed(at).with("tool", tool).with("count", count),
            Self::Stands { surface, thickness, at, from_z, to_z } => {
                of_surface(placed(at), surface).with("thickness", thickness).with("from", from_z).with("to", to_z)
            }
            Self::OffSize { surface, measured, least, most, z, .. } => {
                let note = of_surface(Note::new(code).with("z", z), surface).with("measured", measured);
                note.with("least", least).with("most", most)
            }
            Self::Corner { surface, radius, left, at, count } => {
                of_surface(placed(at), surface).with("radius", radius).with("left", left).with("count", count)
            }
            Self::ThreadPart { surface, left, from_z, to_z } => {
                of_surface(Note::new(code), surface).with("left", left).with("from", from_z).with("to", to_z)
            }
            Self::ThreadShallow { surface, left } | Self::ThreadShort { surface, left } => {
                of_surface(Note::new(code), surface).with("left", left)
            }
        }
    }

    /// The surface by which it is merged with others; none of what is told of a tool.
    const fn surface(&self) -> Option<&Figure> {
        match self {
            Self::Gouge { surface, .. }
            | Self::Stands { surface, .. }
            | Self::OffSize { surface, .. }
            | Self::Corner { surface, .. }
            | Self::ThreadShallow { surface, .. }
            | Self::ThreadPart { surface, .. }
            | Self::ThreadLead { surface, .. }
            | Self::ThreadPhase { surface, .. }
            | Self::TapHoleWide { surface, .. }
            | Self::ThreadShort { surface, .. } => surface.as_ref(),
            Self::RapidCut { .. }
            | Self::Holder { .. }
            | Self::Struck { .. }
            | Self::OffAxis { .. }
            | Self::Buried { .. }
            | Self::TapBlocked { .. }
            | Self::TapOutOfStep { .. } => None,
        }
    }

    /// Merges another fault of the same kind, surface, tool and body; false if it differs.
    fn take(&mut self, other: &Self) -> bool {
        let worse = match (&*self, other) {
            (Self::Gouge { surface: a, depth: mine, .. }, Self::Gouge { surface: b, depth, .. }) if a == b => {
                depth > mine
            }
            (Self::TapHoleWide { surface: a, width: mine, .. }, Self::TapHoleWide { surface: b, width, .. })
                if a == b =>
            {
                width > mine
            }
            (Self::RapidCut { tool: a, width: mine, .. }, Self::RapidCut { tool: b, width, .. })
            | (Self::TapBlocked { tool: a, width: mine, .. }, Self::TapBlocked { tool: b, width, .. })
            | (Self::Holder { tool: a, width: mine, .. }, Self::Holder { tool: b, width, .. })
                if a == b =>
            {
                width > mine
            }
            (Self::Struck { tool: a, body: of, width: mine, .. }, Self::Struck { tool: b, body: on, width, .. })
                if a == b && of == on =>
            {
                width > mine
            }
            (Self::OffAxis { tool: a, .. }, Self::OffAxis { tool: b, .. })
            | (Self::TapOutOfStep { tool: a, .. }, Self::TapOutOfStep { tool: b, .. })
                if a == b =>
            {
                false
            }
            (Self::ThreadLead { surface: a, .. }, Self::ThreadLead { surface: b, .. }) if a == b => false,
            (Self::Buried { tool: a, depth: mine, .. }, Self::Buried { tool: b, depth, .. }) if a == b => depth > mine,
            (Self::ThreadPhase { surface: a, shift: mine, .. }, Self::ThreadPhase { surface: b, shift, .. })
                if a == b =>
            {
                shift > mine
            }
            (Self::Stands { surface: a, thickness: mine, .. }, Self::Stands { surface: b, thickness, .. })
                if a == b =>
            {
                thickness > mine
            }
            (
                Self::Corner { surface: a, radius: of, left: mine, .. },
                Self::Corner { surface: b, radius: on, left, .. },
            ) if a == b && of == on => left > mine,
            _ => return false,
        };
        let (known, length) = (self.count(), self.length());
        if worse {
            *self = other.clone();
        }
        if let Some(count) = self.count_mut() {
            *count = known + other.count();
        }
        if let (Self::Stands { from_z, to_z, .. }, Some(mine), Some(other)) = (self, length, other.length()) {
            *from_z = Mm(mine.0.max(other.0));
            *to_z = Mm(mine.1.min(other.1));
        }
        true
    }

    const fn length(&self) -> Option<(f64, f64)> {
        match self {
            Self::Stands { from_z, to_z, .. } => Some((from_z.0, to_z.0)),
            _ => None,
        }
    }

    const fn count(&self) -> usize {
        match self {
            Self::Gouge { count, .. }
            | Self::RapidCut { count, .. }
            | Self::Holder { count, .. }
            | Self::Struck { count, .. }
            | Self::OffAxis { count, .. }
            | Self::TapBlocked { count, .. }
            | Self::TapOutOfStep { count, .. }
            | Self::TapHoleWide { count, .. }
            | Self::ThreadLead { count, .. }
            | Self::ThreadPhase { count, .. }
            | Self::Buried { count, .. }
            | Self::Corner { count, .. } => *count,
            Self::Stands { .. }
            | Self::OffSize { .. }
            | Self::ThreadShallow { .. }
            | Self::ThreadShort { .. }
            | Self::ThreadPart { .. } => 1,
        }
    }

    const fn count_mut(&mut self) -> Option<&mut usize> {
        match self {
            Self::Gouge { count, .. }
            | Self::RapidCut { count, .. }
            | Self::Holder { count, .. }
            | Self::Struck { count, .. }
            | Self::OffAxis { count, .. }
            | Self::TapBlocked { count, .. }
            | Self::TapOutOfStep { count, .. }
            | Self::TapHoleWide { count, .. }
            | Self::ThreadLead { count, .. }
            | Self::ThreadPhase { count, .. }
            | Self::Buried { count, .. }
            | Self::Corner { count, .. } => Some(count),
            Self::Stands { .. }
            | Self::OffSize { .. }
            | Self::ThreadShallow { .. }
            | Self::ThreadShort { .. }
            | Self::ThreadPart { .. } => None,
        }
    }
}

/// Faults, merged by kind and surface, tool or body.
#[derive(Clone, Debug, Default)]
pub struct Faults {
    all: Vec<Fault>,
    /// Where those of a surface stand, and those of none: only these may be merged.
    of: BTreeMap<Option<Figure>, Vec<usize>>,
}

impl Faults {
    pub fn add(&mut self, fault: Fault) {
        let places = self.of.entry(fault.surface().cloned()).or_default();
        if !places.iter().any(|place| self.all[*place].take(&fault)) {
            places.push(self.all.len());
            self.all.push(fault);
        }
    }

    /// Leaves out the faults that are told by another one.
    pub fn without(&mut self, told: impl Fn(&Fault) -> bool) {
        let left: Vec<Fault> = std::mem::take(self).all.into_iter().filter(|fault| !told(fault)).collect();
        left.into_iter().for_each(|fault| self.add(fault));
    }

    pub fn all(self) -> Vec<Fault> {
        self.all
    }
}
