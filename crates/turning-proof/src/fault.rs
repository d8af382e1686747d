//! Faults of a program, as types; each makes its own note.

use std::collections::BTreeMap;
use std::mem::discriminant;

use crate::note::{Figure, Note};
use crate::set_up::{MotionKind, Size};
use crate::units::{At, Block, Mm};

/// A fault, once for each surface, tool or body: its worst place, and how often.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// What is wrong.
    pub what: What,
    /// The surface or the tool that it is told of.
    pub whose: Whose,
    /// The worst place; none where a whole thread is meant.
    pub at: Option<At>,
    /// Its block; none for metal that remains at the end, and for a size if nobody knows what made it.
    pub block: Option<Block>,
    /// The number of places, motion by motion.
    pub count: usize,
}

/// The surface or the tool that a fault is told of.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Whose {
    /// A surface; none if its piece has no name.
    Surface(Option<Figure>),
    /// A tool, by its designation.
    Tool(String),
}

/// What is wrong, with its own figures.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// The finished part is cut (gouge).
    Gouge {
        /// The greatest depth below the surface with its allowance, along its normal.
        depth: Mm,
    },
    /// A cutter moves through metal at rapid.
    RapidCut {
        /// The width of the metal it hits, where it is narrowest; the place is the middle of it.
        width: Mm,
    },
    /// A shank, a bar or the non-cutting part of a drill moves through metal.
    Holder {
        /// The width of the metal it hits, where it is narrowest; the place is the middle of it.
        width: Mm,
        /// The kind of the worst motion.
        kind: MotionKind,
    },
    /// A tool collides with a jaw, a centre or a steady rest.
    Struck {
        /// The body it hits.
        body: Figure,
        /// The width of the overlap, where it is narrowest; the place is the middle of it.
        width: Mm,
    },
    /// A drill cuts off the axis or sideways; the place is the end of the motion.
    OffAxis,
    /// Metal remains over a surface.
    Stands {
        /// The greatest thickness over the surface with its allowance, along its normal.
        thickness: Mm,
        /// The end of the remaining metal at the free end.
        from_z: Mm,
        /// Its end at the chuck.
        to_z: Mm,
    },
    /// A size is outside of its limits.
    OffSize {
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
    },
    /// An inner corner keeps the rounding of the nose that made it.
    Corner {
        /// The radius of the nose.
        radius: Mm,
        /// The greatest distance of the rounding from the sides of the corner.
        left: Mm,
    },
    /// A tap meets metal that its drill should have removed: no hole, a narrower one, or the bottom.
    TapBlocked {
        /// The width of the metal, where it is narrowest; the place is the middle of it.
        width: Mm,
    },
    /// A tap cuts, and the feed is not in step with the spindle by its pitch; the place is the end of the motion.
    TapOutOfStep {
        /// Its pitch.
        pitch: Mm,
        /// The travel per turn; zero where the program gives none.
        lead: Mm,
    },
    /// A pass of a thread is not fed by its pitch; the place is the end of the pass.
    ThreadLead {
        /// Its pitch.
        pitch: Mm,
        /// The travel per turn.
        lead: Mm,
    },
    /// The hole before a tap is wider than the tolerance of the minor diameter.
    TapHoleWide {
        /// The metal that is missing, radial; the place is the middle of it.
        width: Mm,
    },
    /// The full thread of a tap ends before that of the drawing.
    ThreadShort {
        /// The length that is missing.
        left: Mm,
    },
    /// Passes go down to the root of a thread only along a part of its length.
    ThreadPart {
        /// The longest stretch without its depth.
        left: Mm,
        /// Where that begins, at the free end.
        from_z: Mm,
        /// Its end at the chuck.
        to_z: Mm,
    },
    /// A tool on the axis goes in deeper than its flutes, its cone or its reach; the place is where the hole closes round it.
    Buried {
        /// How much of its shank is in the hole.
        depth: Mm,
    },
    /// A pass of a thread runs beside the groove of its deepest pass: they start at other angles of the spindle. The place is where
    /// the pass starts.
    ThreadPhase {
        /// The pitch of the thread.
        pitch: Mm,
        /// How far beside it is along the axis.
        shift: Mm,
    },
    /// No pass of a thread goes down to its root.
    ThreadShallow {
        /// The distance of the deepest pass from the root.
        left: Mm,
    },
}

impl What {
    const fn code(&self) -> &'static str {
        match self {
            Self::Gouge { .. } => "swept-gouge",
            Self::RapidCut { .. } => "swept-rapid",
            Self::Holder { kind: MotionKind::Rapid, .. } => "swept-holder-rapid",
            Self::Holder { .. } => "swept-holder",
            Self::Struck { .. } => "swept-struck",
            Self::OffAxis => "swept-off-axis",
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

    /// Whether it is told once, however often it is found: what a whole size or thread lacks.
    const fn is_single(&self) -> bool {
        matches!(
            self,
            Self::OffSize { .. } | Self::ThreadShallow { .. } | Self::ThreadShort { .. } | Self::ThreadPart { .. }
        )
    }

    /// Whether its sentence has the diameter of its place beside its Z.
    const fn tells_diameter(&self) -> bool {
        let along = matches!(self, Self::TapOutOfStep { .. } | Self::ThreadLead { .. } | Self::ThreadPhase { .. });
        !along && !matches!(self, Self::Buried { .. } | Self::OffSize { .. })
    }

    /// Its note with its own figures.
    fn told(&self, note: Note) -> Note {
        match self {
            Self::OffAxis => note,
            Self::Gouge { depth } | Self::Buried { depth } => note.with("depth", depth),
            Self::RapidCut { width }
            | Self::Holder { width, .. }
            | Self::TapBlocked { width }
            | Self::TapHoleWide { width } => note.with("width", width),
            Self::Struck { body, width } => note.with("body", body).with("width", width),
            Self::Stands { thickness, from_z, to_z } => {
                note.with("thickness", thickness).with("from", from_z).with("to", to_z)
            }
            Self::OffSize { measured, least, most, .. } => {
                note.with("measured", measured).with("least", least).with("most", most)
            }
            Self::Corner { radius, left } => note.with("radius", radius).with("left", left),
            Self::TapOutOfStep { pitch, lead } | Self::ThreadLead { pitch, lead } => {
                note.with("pitch", pitch).with("lead", lead)
            }
            Self::ThreadPhase { pitch, shift } => note.with("pitch", pitch).with("shift", shift),
            Self::ThreadPart { left, from_z, to_z } => note.with("left", left).with("from", from_z).with("to", to_z),
            Self::ThreadShallow { left } | Self::ThreadShort { left } => note.with("left", left),
        }
    }

    /// What the worst of two is found by; none where the first is as good as any.
    const fn worst(&self) -> Option<Mm> {
        match self {
            Self::Gouge { depth } | Self::Buried { depth } => Some(*depth),
            Self::RapidCut { width }
            | Self::Holder { width, .. }
            | Self::Struck { width, .. }
            | Self::TapBlocked { width }
            | Self::TapHoleWide { width } => Some(*width),
            Self::Stands { thickness, .. } => Some(*thickness),
            Self::Corner { left, .. } => Some(*left),
            Self::ThreadPhase { shift, .. } => Some(*shift),
            _ => None,
        }
    }

    /// The ends of metal that remains.
    const fn span(&self) -> Option<(Mm, Mm)> {
        match self {
            Self::Stands { from_z, to_z, .. } => Some((*from_z, *to_z)),
            _ => None,
        }
    }

    /// Whether another of the same surface or tool is merged with it.
    fn is_one_with(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Struck { body: one, .. }, Self::Struck { body: other, .. }) => one == other,
            (Self::Corner { radius: one, .. }, Self::Corner { radius: other, .. }) => one == other,
            _ => discriminant(self) == discriminant(other) && !self.is_single(),
        }
    }
}

impl Fault {
    pub(crate) fn of_tool(what: What, tool: &str, at: At, block: Block) -> Self {
        Self { what, whose: Whose::Tool(tool.to_owned()), at: Some(at), block: Some(block), count: 1 }
    }

    pub(crate) const fn of_surface(what: What, surface: Option<Figure>, at: Option<At>, block: Option<Block>) -> Self {
        Self { what, whose: Whose::Surface(surface), at, block, count: 1 }
    }

    /// Its stable code, the same as that of its note.
    pub const fn code(&self) -> &'static str {
        self.what.code()
    }

    /// The surface that it is told of; none if that has no name, or if it is told of a tool.
    pub const fn surface(&self) -> Option<&Figure> {
        match &self.whose {
            Whose::Surface(surface) => surface.as_ref(),
            Whose::Tool(_) => None,
        }
    }

    /// Whether it is only a note: the rounding that every nose leaves.
    pub const fn is_mild(&self) -> bool {
        matches!(self.what, What::Corner { .. })
    }

    /// The sentence.
    pub fn note(&self) -> Note {
        let mut note = Note::new(self.code());
        if let Some(at) = self.at {
            note = note.with("z", at.z);
            if self.what.tells_diameter() {
                note = note.with("diameter", Mm(2.0 * at.radius.0.abs()));
            }
        }
        let note = match &self.whose {
            Whose::Tool(tool) => note.with("tool", tool),
            Whose::Surface(surface) => {
                note.with("surface", surface.clone().unwrap_or_else(|| Figure::word("surface-without-name")))
            }
        };
        let note = self.what.told(note);
        let counted = !self.what.is_single() && !matches!(self.what, What::Stands { .. });
        if counted { note.with("count", self.count) } else { note }
    }

    /// Merges another fault of the same surface or tool; false if it is none of the same kind.
    fn take(&mut self, other: &Self) -> bool {
        if !self.what.is_one_with(&other.what) {
            return false;
        }
        let (count, spans) = (self.count + other.count, (self.what.span(), other.what.span()));
        // Of two that the grid alone tells apart the first stands.
        if other.what.worst() > self.what.worst().map(|known| Mm(known.0 + ALIKE)) {
            *self = other.clone();
        }
        self.count = count;
        if let (What::Stands { from_z, to_z, .. }, (Some(mine), Some(others))) = (&mut self.what, spans) {
            (*from_z, *to_z) = (Mm(mine.0.0.max(others.0.0)), Mm(mine.1.0.min(others.1.0)));
        }
        true
    }
}

/// Ten steps of the grid of regions, mm.
const ALIKE: f64 = 1e-4;

/// Faults, merged by kind and surface, tool or body.
#[derive(Clone, Debug, Default)]
pub struct Faults {
    all: Vec<Fault>,
    /// Where those of a surface or a tool stand: only these may be merged.
    of: BTreeMap<Whose, Vec<usize>>,
}

impl Faults {
    pub fn add(&mut self, fault: Fault) {
        let places = self.of.entry(fault.whose.clone()).or_default();
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
