//! What a program tells against itself, without a part: whose length offset acts while a tool cuts, which way the spindle
//! turns then, whether a tap is fed by the pitch of a thread, and dwells that are likely meant in another unit of time.
//!
//! It sees the steps of a run, so it is the same for every control. Which tool is how long nobody knows here; but two
//! tools are not of one length, and a program that corrects one tool has to correct the others.

use std::collections::{BTreeMap, BTreeSet};

use crate::error::KnowledgeError;
use crate::job::convention;
use crate::knowledge::Knowledge;
use crate::motion::{Axis, BlockRef, Motion, MotionStep, Position, Turning};
use crate::note::Note;
use crate::program::Setting;
use crate::program::named::{KindWord, Names};
use crate::tables::audit::{ProgramWords, ToolKind};
use crate::tables::controls::Convention;
use crate::tables::standards::CoarseThread;
use crate::tables::turning::jobs::ThreadRunOut;
use crate::units::Micrometres;

/// Figures of `program-conventions` that a run is watched by.
#[derive(Clone, Debug)]
pub(super) struct Habits {
    /// The part of a turn that the spindle must make in a dwell in the hole, 1.
    dwell_turns: f64,
    /// The longest dwell in a hole, s.
    dwell_in_hole_s: f64,
    /// The shortest and the longest dwell elsewhere, s.
    dwell_s: (f64, f64),
    /// The longest step of deep drilling, mm.
    peck_mm: f64,
    /// How far the feed of a tap may be off the pitch of a thread, as a part of it.
    pub tap_near: f64,
    /// The pitches of metric threads, mm.
    pitches: Vec<f64>,
    /// Sizes and pitches of coarse metric threads, mm.
    pub coarse: Vec<(f64, f64)>,
    /// The words of comments that name a tap.
    pub of_taps: Vec<String>,
    /// The words of comments that name a tool of edges.
    pub of_edges: Vec<String>,
    /// The words of comments that name a kind of tool.
    pub of_kinds: Vec<KindWord>,
    /// The greatest feed of a drill for a turn, as a part of its diameter.
    pub drill_feed: f64,
    /// How many pitches the hole of a thread is narrower than it: at least, at most.
    pub tap_hole: (f64, f64),
    /// How far beyond its hole a reamer may come out of a through one, mm.
    pub reamer_beyond: f64,
    /// How much wider than its hole a reamer may be, mm.
    pub reamer_stock: f64,
    /// How far a boring bar is drawn off the wall at most, mm.
    pub shift: f64,
    /// How many pitches a tap may come out of a through hole farther than the drill before it.
    pub tap_beyond: f64,
    /// How far from its hole a tap is beside it, mm.
    pub tap_beside: f64,
    /// How many times the depth of the others of its tool a depth may be.
    pub depth_beside: f64,
    /// The greatest feed of a turn, mm.
    pub feed_of_turn: f64,
    /// The least feed of a minute, mm.
    pub feed_of_minute: f64,
    /// How many times the feed of the cuts beside it a feed may be.
    pub feed_beside: f64,
    /// How far around its cuts a program has made room, mm.
    pub cuts_around: f64,
    /// Whether a tool from the magazine needs a length offset even where it is the only one.
    by_offset: bool,
    /// Whether tools are changed at a stop, by hand.
    by_hand: bool,
    /// The feed and the speed that act, as parts of those written: by the operator's switches.
    overrides: (f64, f64),
}

impl Habits {
    /// Reads them.
    ///
    /// # Errors
    /// A figure is missing.
    pub fn read(knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let figure = |name| convention(name, knowledge).map(|(value, _)| value);
        Ok(Self {
            dwell_turns: figure(Convention::DwellTurnsLeast)?,
            dwell_in_hole_s: figure(Convention::DwellInHoleMost)?,
            dwell_s: (figure(Convention::DwellLeast)?, figure(Convention::DwellMost)?),
            peck_mm: figure(Convention::PeckMost)?,
            tap_near: figure(Convention::TapFeedNear)?,
            pitches: knowledge.rows::<ThreadRunOut<'_>>()?.into_iter().map(|row| row.pitch.to_mm()).collect(),
            coarse: knowledge.rows::<CoarseThread<'_>>()?.into_iter().filter_map(|row| size(&row)).collect(),
            of_taps: words_of(knowledge, &[ToolKind::Tap])?,
            of_edges: words_of(knowledge, &[ToolKind::Chamfer, ToolKind::Countersink, ToolKind::Centring])?,
            of_kinds: kinds(knowledge)?,
            drill_feed: figure(Convention::DrillFeedMost)?,
            tap_hole: (figure(Convention::TapHoleMost)?, figure(Convention::TapHoleLeast)?),
            shift: figure(Convention::BoringShiftMost)?,
            reamer_beyond: figure(Convention::ReamerOverrunMost)?,
            reamer_stock: figure(Convention::ReamerStockMost)?,
            tap_beyond: figure(Convention::TapBeyondDrill)?,
            tap_beside: figure(Convention::TapBesideHole)?,
            depth_beside: figure(Convention::DepthBesideMost)?,
            feed_of_turn: figure(Convention::FeedOfTurnMost)?,
            feed_of_minute: figure(Convention::FeedOfMinuteLeast)?,
            feed_beside: figure(Convention::FeedBesideMost)?,
            cuts_around: figure(Convention::CutsAround)?,
            by_offset: false,
            by_hand: false,
            overrides: (1.0, 1.0),
        })
    }

    /// Those of a control on which the length of a tool stands in an offset register.
    #[must_use]
    pub fn with_lengths(mut self, by_offset: bool) -> Self {
        self.by_offset = by_offset;
        self
    }

    /// Those of a control without a function for the tool change: it is made at a stop, by hand.
    #[must_use]
    pub fn with_changes(mut self, by_hand: bool) -> Self {
        self.by_hand = by_hand;
        self
    }

    /// With the switches of a setting.
    #[must_use]
    pub fn under(mut self, setting: &Setting) -> Self {
        self.overrides = (setting.feed_override as f64 / 100.0, setting.speed_override as f64 / 100.0);
        self
    }

    /// The longest step of deep drilling, in millionths of a millimetre.
    pub fn peck_most(&self) -> i64 {
        libm::round(self.peck_mm * 1e6) as i64
    }
}

/// The words of comments that name a kind of tool, in their order.
fn kinds(knowledge: &Knowledge) -> Result<Vec<KindWord>, KnowledgeError> {
    let rows = knowledge.rows::<ProgramWords<'_>>()?.into_iter();
    Ok(rows.filter_map(|row| Some((row.word.to_owned(), row.kind?))).collect())
}

/// The words of comments that name tools of these kinds.
fn words_of(knowledge: &Knowledge, kinds: &[ToolKind]) -> Result<Vec<String>, KnowledgeError> {
    let rows = knowledge.rows::<ProgramWords<'_>>()?.into_iter();
    let named = rows.filter(|row| row.kind.is_some_and(|kind| kinds.contains(&kind)));
    Ok(named.map(|row| row.word.to_owned()).collect())
}

/// The size of a coarse thread and its pitch, mm.
fn size(row: &CoarseThread<'_>) -> Option<(f64, f64)> {
    Some((row.thread.strip_prefix('M')?.parse().ok()?, row.pitch.to_mm()))
}

/// The offset that acts: its register, none where the program gives the value, and what it adds.
type Offset = (Option<u32>, Micrometres);

/// Cuts of a tool with an offset: the first of them, whether the offset was set before the tool came, and whether the
/// program stopped between the change and the cut.
#[derive(Clone, Copy, Debug)]
struct Cut {
    tool: u32,
    section: usize,
    block: BlockRef,
    offset: Offset,
    /// Whether it was set since the tool came: a value that the program gives itself is else that of the tool before.
    own: bool,
    /// Whether the operator could set the zero anew.
    stopped: bool,
    /// How often the program had stopped: at a stop another tool may come into a place.
    stops: usize,
}

/// The register of the radius that a tool has.
#[derive(Clone, Copy, Debug)]
pub(super) struct Radius {
    pub tool: u32,
    pub register: u32,
    pub block: BlockRef,
}

/// A feed straight down.
#[derive(Clone, Copy, Debug)]
struct Down {
    /// The feed, mm/min.
    feed: f64,
    /// How the spindle turned then.
    turning: Turning,
    speed: f64,
}

/// A finding: its block, its code, and the same with its figures.
pub(super) type Told = (BlockRef, &'static str, Note);

/// Watches the steps of a run.
#[derive(Clone, Debug)]
pub(super) struct Watch {
    habits: Habits,
    names: Names,
    at: Position,
    /// The last motion where it was a feed straight down.
    down: Option<Down>,
    /// The first of such feeds, one behind another, with the spindle turning backwards: a drill, unless it turns round at the
    /// bottom.
    backwards: Option<BlockRef>,
    turning: Turning,
    speed: f64,
    tool: u32,
    section: usize,
    offset: Offset,
    /// Whether the offset was set since the tool came.
    own: bool,
    stopped: bool,
    stops: usize,
    cuts: Vec<Cut>,
    told: Vec<Told>,
}

impl Watch {
    pub const fn new(habits: Habits, names: Names) -> Self {
        Self {
            habits,
            names,
            at: Position { x: Micrometres::ZERO, y: Micrometres::ZERO, z: Micrometres::ZERO },
            down: None,
            backwards: None,
            turning: Turning::Stopped,
            speed: 0.0,
            tool: 0,
            section: 0,
            offset: (Some(0), Micrometres::ZERO),
            own: false,
            stopped: false,
            stops: 0,
            cuts: Vec::new(),
            told: Vec::new(),
        }
    }

    /// One more step.
    pub fn take(&mut self, step: &MotionStep) {
        let from = std::mem::replace(&mut self.at, step.at);
        match &step.motion {
            Motion::Rapid => self.fed(None),
            Motion::Feed { feed_mm_per_min } => {
                let upright = from.x == step.at.x && from.y == step.at.y;
                let down = Down { feed: feed_mm_per_min.0, turning: self.turning, speed: self.speed };
                self.fed(Some(down).filter(|_| upright && step.at.z < from.z));
                self.cuts_backwards(upright, step.block);
                self.cuts_with(step.block);
            }
            Motion::Arc { .. } => {
                self.fed(None);
                self.cuts_backwards(false, step.block);
                self.cuts_with(step.block);
            }
            Motion::Dwell { seconds } => self.dwell(*seconds, step.block),
            Motion::Spindle { turning, speed_rpm } => {
                self.turns_round(*turning, step.block);
                (self.turning, self.speed) = (*turning, speed_rpm.0);
            }
            Motion::ToolChange { tool } => {
                self.fed(None);
                self.tool = *tool;
                self.section += 1;
                (self.own, self.stopped) = (false, self.habits.by_hand);
            }
            Motion::LengthCorrection { axis: Axis::Z, corrector, value } => {
                self.offset = (*corrector, *value);
                self.own = true;
            }
            Motion::Stop { .. } => {
                self.stopped = true;
                self.stops += 1;
            }
            _ => {}
        }
    }

    /// A motion that is a feed straight down, or none: then the way down before it was no tap. A tap may go down in several
    /// blocks.
    fn fed(&mut self, down: Option<Down>) {
        self.down = down;
        if let Some(block) = self.backwards.take_if(|_| down.is_none()) {
            let code = "drilling-backwards";
            self.tell(block, code, Note::new(code).with("tool", self.tool));
        }
    }

    /// A cut while the spindle turns counterclockwise. Left-hand tools are rare: a drill would be one that bores nothing but
    /// old bolts out, a mill may be one. The way up of a tap is none, and the way down of a left-hand one is not known yet.
    fn cuts_backwards(&mut self, upright: bool, block: BlockRef) {
        if self.turning != Turning::Counterclockwise || self.names.is_left_hand(self.tool) {
            return;
        }
        if !upright {
            let code = "milling-backwards";
            self.tell(block, code, Note::new(code).with("tool", self.tool));
        } else if self.down.is_some() {
            self.backwards.get_or_insert(block);
        }
    }

    /// A spindle that turns round at the bottom of a feed cuts a thread: then the feed of a turn is its pitch. It may stop
    /// before it turns back.
    fn turns_round(&mut self, turning: Turning, block: BlockRef) {
        let Some(down) = self.down.filter(|down| down.turning != turning) else { return };
        if turning == Turning::Stopped || down.turning == Turning::Stopped {
            return;
        }
        self.backwards = None;
        if down.turning == Turning::Clockwise && self.names.is_left_hand(self.tool) {
            self.tell(block, "tap-turns-wrong", Note::new("tap-turns-wrong").with("tool", self.tool));
        }
        let (of_feed, of_speed) = self.habits.overrides;
        let (feed, speed) = (down.feed / of_feed, down.speed / of_speed);
        // With a switch at nothing there is no feed for a turn.
        if !(feed > 0.0 && speed > 0.0 && feed.is_finite() && speed.is_finite()) {
            return;
        }
        let pitch = feed / speed;
        let Habits { tap_near, pitches, .. } = &self.habits;
        let near = |known: f64| (pitch / known - 1.0).abs() <= *tap_near;
        let named = self.names.threads(self.tool);
        if let Some(thread) = named.first().filter(|_| !named.iter().any(|thread| near(thread.pitch))) {
            let note = Note::new("tap-pitch-named").with("pitch", crate::units::round_to(pitch, 3));
            let note = note.with("thread", thread.name.clone()).with("needed", thread.pitch).with("tool", self.tool);
            return self.tell(block, "tap-pitch-named", note);
        }
        // Inch threads have a whole number of turns to the inch, the finest of them 80, a few of them a half more.
        let halves = libm::round(2.0 * 25.4 / pitch);
        let inches = halves <= 160.0 && (halves % 2.0 == 0.0 || [9.0, 23.0].contains(&halves));
        let least = pitches.iter().copied().fold(f64::INFINITY, f64::min);
        let most = pitches.iter().copied().fold(0.0, f64::max);
        let code = if pitch < least * (1.0 - tap_near) || pitch > most * (1.0 + tap_near) {
            "tap-feed"
        } else if pitches.iter().any(|known| near(*known)) || (inches && near(50.8 / halves)) {
            return;
        } else {
            "tap-feed-odd"
        };
        let note = Note::new(code).with("pitch", crate::units::round_to(pitch, 3));
        self.tell(block, code, note.with("feed", crate::units::round_to(feed, 3)).with("speed", speed));
    }

    /// A block may be repeated many times, and a tool may make many such cuts: the first says it.
    fn tell(&mut self, block: BlockRef, code: &'static str, note: Note) {
        if !self.told.iter().any(|(_, known, other)| *known == code && *other == note) {
            self.told.push((block, code, note));
        }
    }

    /// Takes the first cut of a tool with every offset.
    fn cuts_with(&mut self, block: BlockRef) {
        let known = self.cuts.iter().rev().take_while(|cut| cut.section == self.section);
        if self.tool == 0 || known.into_iter().any(|cut| cut.offset == self.offset) {
            return;
        }
        self.cuts.push(Cut {
            tool: self.tool,
            section: self.section,
            block,
            offset: self.offset,
            own: self.own,
            stopped: self.stopped,
            stops: self.stops,
        });
    }

    /// At the bottom of a feed the tool turns at least a part of a turn, and does not rub for long.
    fn dwell(&mut self, seconds: f64, block: BlockRef) {
        let Habits { dwell_turns, dwell_in_hole_s, dwell_s: (least, most), .. } = self.habits;
        if seconds <= 0.0 {
            return;
        }
        let turns = seconds * self.speed / 60.0;
        let cutting = self.down.is_some() && self.turning != Turning::Stopped && self.speed > 0.0;
        let note = |code: &'static str, needed: f64, limit: &'static str| {
            let shown = crate::units::round_to(needed, 3);
            (code, Note::new(code).with("seconds", seconds).with("needed", shown).with("limit", limit.to_owned()))
        };
        let told = if cutting && turns < dwell_turns {
            note("dwell-unit", dwell_turns * 60.0 / self.speed, "least")
        } else if cutting && seconds > dwell_in_hole_s {
            note("dwell-unit", dwell_in_hole_s, "most")
        } else if seconds < least {
            note("dwell-odd", least, "least")
        } else if seconds > most {
            note("dwell-odd", most, "most")
        } else {
            return;
        };
        // A block may be repeated many times.
        let (code, note) = told;
        if self.told.last().is_none_or(|(last, known, _)| (*last, *known) != (block, code)) {
            self.told.push((block, code, note));
        }
    }

    /// What is told of the run, in no order.
    pub fn finish(mut self, radii: &[Radius]) -> Vec<Told> {
        self.fed(None);
        self.offsets();
        self.two_lengths();
        self.radii(radii);
        self.told
    }

    /// The cuts with a register of a length, each with it.
    fn lengths(&self) -> impl Iterator<Item = (u32, &Cut)> + '_ {
        self.cuts.iter().filter_map(|cut| Some((cut.offset.0.filter(|number| *number > 0)?, cut)))
    }

    /// A tool that comes again with another register than before. A second one beside the first is that of another edge, and so
    /// may be one as far off as that of another tool; at a stop another tool may have come into its place.
    fn two_lengths(&mut self) {
        let lengths: Vec<(u32, &Cut)> = self.lengths().collect();
        let mut told = Vec::new();
        for (number, cut) in &lengths {
            let own = || lengths.iter().filter(|(_, other)| other.tool == cut.tool);
            let others = || lengths.iter().filter(|(_, other)| other.tool != cut.tool);
            let Some((known, first)) = own().find(|(_, other)| other.section < cut.section) else { continue };
            let beside = own().any(|(other, at)| {
                (at.section == cut.section && other == known) || (at.section == first.section && other == number)
            });
            let habit = others().any(|(low, one)| {
                let apart = |high: &u32| number > known && high.checked_sub(*low) == Some(number - known);
                others().any(|(high, other)| one.tool == other.tool && apart(high))
            });
            let of_other = others().any(|(other, _)| other == number);
            if number != known && first.stops == cut.stops && !beside && !habit && !of_other {
                let note = Note::new("two-lengths").with("tool", cut.tool).with("corrector", *number);
                told.push((cut.block, "two-lengths", note.with("other", *known)));
            }
        }
        told.into_iter().for_each(|(block, code, note)| self.tell(block, code, note));
    }

    /// A radius of another tool: its register has been that of one, or has its number where tools have those of their numbers.
    fn radii(&mut self, radii: &[Radius]) {
        let tools: BTreeSet<u32> = self.cuts.iter().map(|cut| cut.tool).collect();
        let by_number = radii.iter().any(|radius| radius.register == radius.tool)
            || self.lengths().any(|(number, cut)| cut.tool == number);
        let mut told = Vec::new();
        for (index, Radius { tool, register, block }) in
            radii.iter().enumerate().filter(|(_, it)| it.register != it.tool)
        {
            let of = |other: &&Radius| other.register == *register && other.tool != *tool;
            let own = radii.iter().filter(of).find(|other| other.tool == other.register);
            let before = radii.iter().take(index).find(of);
            let named = Some(*register).filter(|number| by_number && tools.contains(number));
            let other = own.or(before).map(|other| other.tool).or(named);
            if let Some(other) = other.filter(|other| other != tool) {
                let code = "radius-of-other-tool";
                let note = Note::new(code).with("tool", *tool).with("corrector", *register).with("other", other);
                told.push((*block, code, note));
            }
        }
        told.into_iter().for_each(|(block, code, note)| self.tell(block, code, note));
    }

    /// Cuts without an offset where others have one, and with that of another tool.
    fn offsets(&mut self) {
        let none = |cut: &Cut| match cut.offset {
            (Some(number), _) => number == 0,
            (None, value) => !cut.own && value == Micrometres::ZERO,
        };
        let tools: BTreeSet<u32> = self.cuts.iter().map(|cut| cut.tool).collect();
        let any = self.cuts.iter().any(|cut| !none(cut));
        let mut owners: BTreeMap<u32, u32> = BTreeMap::new();
        // A register with the number of the tool is its own, whoever used it first.
        let with_register = |cut: &Cut| cut.offset.0.filter(|number| *number > 0).map(|number| (number, cut.tool));
        let pairs: Vec<(u32, u32)> = self.cuts.iter().filter_map(with_register).collect();
        let by_number = pairs.iter().any(|(number, tool)| number == tool);
        owners.extend(pairs.iter().copied().filter(|(number, tool)| number == tool));
        for (number, tool) in &pairs {
            owners.entry(*number).or_insert(*tool);
        }
        for cut in &self.cuts {
            let told = if none(cut) {
                if tools.len() < 2 && !self.habits.by_offset {
                    continue;
                }
                let code = if any || !cut.stopped { "no-length-offset" } else { "length-by-hand" };
                (code, Note::new(code).with("tool", cut.tool))
            } else if cut.offset.0.is_none() && !cut.own {
                let code = "offset-of-tool-before";
                (code, Note::new(code).with("tool", cut.tool).with("value", cut.offset.1))
            } else if let Some((number, tool)) = with_register(cut) {
                let owner = owners.get(&number).copied().filter(|owner| *owner != tool);
                // A program whose tools have the registers of their numbers has confused this one.
                let named = (by_number && tools.contains(&number)).then_some(number);
                let (code, other) = match owner.or(named.filter(|named| *named != tool)) {
                    Some(other) => ("offset-of-other-tool", other),
                    None if number != tool && tools.contains(&number) => ("offset-of-other-number", number),
                    // Of several tools whose registers have other numbers a habit of their owner shows; of one, or where the
                    // other tools have those of their own numbers, it may be a slip.
                    None if number != tool && (tools.len() == 1 || by_number) && !pairs.contains(&(tool, tool)) => {
                        let code = "offset-of-strange-number";
                        let note = Note::new(code).with("tool", tool).with("corrector", number);
                        self.told.push((cut.block, code, note));
                        continue;
                    }
                    None => continue,
                };
                (code, Note::new(code).with("tool", tool).with("corrector", number).with("other", other))
            } else {
                continue;
            };
            let (code, note) = told;
            self.told.push((cut.block, code, note));
        }
    }
}
