//! What programs for one control have that those for another have not, by its record.

use std::fmt;

use crate::job::{self, Cycle};
use crate::program::block::Block;
use crate::program::iso::control::{Characteristic as Q, Control, Outwards};
use crate::units::{Micrometres, MillimetresPerMinute, RevsPerMinute, Seconds};

/// A block with its number.
pub(super) struct Numbered(pub usize, pub String);

impl fmt::Display for Numbered {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "N{} {}", self.0, self.1)
    }
}

/// How a control writes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dialect<'c>(pub &'c Control);

impl Dialect<'_> {
    /// A length, mm. Where a number without a point may count increments, it has one.
    pub(super) fn length(self, value: Micrometres) -> String {
        let text = value.to_string();
        if self.0.is(Q::PointsWritten) && !text.contains('.') { text + ".0" } else { text }
    }

    /// A feed, mm/min.
    pub(super) fn feed(self, feed: MillimetresPerMinute) -> String {
        let text = feed.0.to_string();
        if self.0.is(Q::PointsWritten) && !text.contains('.') { text + "." } else { text }
    }

    /// P of a dwell: whole where its unit is a part of a second.
    pub(super) fn dwell(self, time: Seconds) -> String {
        let unit = self.0.dwell_unit_s;
        if unit < 1.0 { libm::round(time.0 / unit).to_string() } else { time.0.to_string() }
    }

    /// Whether the control has subprograms.
    pub(super) const fn subprograms(self) -> bool {
        self.0.depth > 0
    }

    /// Whether a program begins with its number.
    pub(super) const fn numbers_programs(self) -> bool {
        self.0.number_digits > 0
    }

    /// The lines before the first block.
    pub(super) fn head(self, part: &str, number: u32) -> Vec<String> {
        match self.0.number_digits {
            0 => vec![format!("({part})")],
            digits => vec![format!("O{number:0digits$} ({part})")],
        }
    }

    /// What the operator must know of the whole program: where the lengths of the tools stand.
    pub(super) fn notice(self) -> Option<String> {
        let by_value = !self.0.g.contains_key(&430);
        by_value.then(|| "G43.1 Z IS THE LENGTH OFFSET OF EACH TOOL: SET THE TOOLS TO IT".to_owned())
    }

    /// From wherever a tool is to the place of the tool change. Where G49 alone may move the axis by the length of the
    /// tool, it stands with the way up.
    pub(super) fn withdrawal(self, up: String, across: [String; 2]) -> Vec<Block> {
        let [x, y] = across;
        let off = Block::new().g(90).g(80);
        let on_machine = |block: Block| {
            let block = block.g(53);
            if self.0.is(Q::MachinePositionAtRapid) { block } else { block.g(0) }
        };
        let (first, up_from) = match self.0.is(Q::LengthOffOnWayUp) {
            true => (off, Block::new().g(49)),
            false => (off.g(49), Block::new()),
        };
        let up = on_machine(up_from).word('Z', up);
        let aside = on_machine(Block::new()).word('X', x).word('Y', y);
        vec![first, up, Block::new().m(5), Block::new().m(9), aside]
    }

    /// The spindle, and the coolant where it flows.
    pub(super) fn turning(self, speed: RevsPerMinute, coolant: bool) -> Vec<Block> {
        let turning = Block::new().word('S', speed.0).m(3);
        match coolant {
            false => vec![turning],
            true if self.0.m_written > 1 => vec![turning.m(8)],
            true => vec![turning, Block::new().m(8)],
        }
    }

    /// The change of a tool; by hand at a stop where the control has none.
    pub(super) fn change(self, place: u32) -> Block {
        let change = Block::new().word('T', place);
        change.m(if self.0.changes_tools() { 6 } else { 0 })
    }

    /// The way down to a level with the length offset of a tool: its register, or where there are none its value.
    pub(super) fn length_on(self, level: String, corrector: u32, value: Micrometres) -> Vec<Block> {
        let down = Block::new().g(0);
        if self.0.g.contains_key(&430) {
            return vec![down.g(43).word('Z', level).word('H', corrector)];
        }
        vec![Block::new().word('G', "43.1").word('Z', self.length(value)), down.word('Z', level)]
    }

    /// Whether the control has the fixed cycle.
    pub(super) fn has(self, cycle: &Cycle) -> bool {
        let (code, _) = fixed(cycle);
        self.0.cycles.contains_key(&(i64::from(code) * 10))
    }

    /// A circle around a centre that lies so far from where it begins and ends.
    pub(super) fn circle(self, code: u32, radius: Micrometres) -> Block {
        let zero = || self.length(Micrometres::ZERO);
        let block = Block::new().g(code).word('I', self.length(-radius)).word('J', zero());
        if self.0.is(Q::ArcNamesEnd) { block.word('X', zero()).word('Y', zero()) } else { block }
    }

    /// What stands before a cycle: the function by which a tap is turned and fed as one, where there is one.
    pub(super) fn before_cycle(self, cycle: &Cycle) -> Option<Block> {
        let taps = matches!(cycle.kind, job::CycleKind::Tap { .. });
        let code = self.0.tap_preparation.filter(|_| taps)?;
        Some(Block::new().word('S', cycle.speed_rpm.0).m(code))
    }

    /// The first blocks: what the program relies on.
    pub(super) fn beginning(self) -> Vec<Block> {
        let modes = Block::new().g(21).g(17).g(40).g(49).g(80).g(90).g(94);
        let centres = self.0.is(Q::ArcCentresAsSet);
        vec![if centres { modes.word('G', "91.1") } else { modes }]
    }

    pub(super) fn subprogram_begins(self, number: u32) -> String {
        match self.0.number_digits {
            _ if self.0.is(Q::OWords) => format!("o{number} sub"),
            digits => format!("O{number:0digits$}"),
        }
    }

    pub(super) fn subprogram_ends(self, number: u32) -> String {
        if self.0.is(Q::OWords) { format!("o{number} endsub") } else { "M99".to_owned() }
    }

    pub(super) fn call(self, number: usize, called: u32) -> String {
        match self.0.number_digits {
            _ if self.0.is(Q::OWords) => format!("o{called} call"),
            digits => Numbered(number, format!("M98 P{called:0digits$}")).to_string(),
        }
    }

    /// Whether the fixed cycle goes out at feed as far as it goes, higher than where its feed begins.
    pub(super) fn feeds_beyond(self, cycle: &Cycle) -> bool {
        let (code, _) = fixed(cycle);
        let known = self.0.cycles.get(&(i64::from(code) * 10));
        cycle.out > cycle.begin && known.is_some_and(|known| known.outwards == Outwards::FeedToTheEnd)
    }

    /// The fixed cycle at a point, with the function of its return: to the initial level (98) or to where the feed begins (99).
    pub(super) fn cycle(self, cycle: &Cycle, returns: u32, lengths: impl Fn(Micrometres) -> Micrometres) -> Block {
        let dwell = cycle.dwell_s.map(|time| self.dwell(time));
        let (code, step) = fixed(cycle);
        let mut words = format!("R{}", self.length(lengths(cycle.begin)));
        if let Some(step) = step {
            words += &format!(" Q{}", self.length(lengths(step)));
        }
        // Some controls do not run a cycle without a dwell.
        let known = self.0.cycles.get(&(i64::from(code) * 10));
        let needed = known.is_some_and(|cycle| cycle.required.contains(&'P')).then(|| "0".to_owned());
        if let Some(dwell) = dwell.or(needed) {
            words += &format!(" P{dwell}");
        }
        words += &format!(" F{}", self.feed(cycle.feed_mm_per_min));
        Block::new().g(returns).g(code).word('Z', self.length(lengths(cycle.end))).cycle(words)
    }
}

/// The G function of a fixed cycle, and its step.
const fn fixed(cycle: &Cycle) -> (u32, Option<Micrometres>) {
    match (&cycle.kind, cycle.dwell_s) {
        (job::CycleKind::FeedOut, None) => (85, None),
        (job::CycleKind::FeedOut, Some(_)) => (89, None),
        (job::CycleKind::BoreStop, _) => (86, None),
        (job::CycleKind::Peck { step, .. }, _) => (83, Some(*step)),
        (job::CycleKind::ChipBreak { step, .. }, _) => (73, Some(*step)),
        (job::CycleKind::Tap { .. }, _) => (84, None),
        // Milled circles and slots are no fixed cycles: `tool` writes them.
        (job::CycleKind::Drill | job::CycleKind::Circles { .. } | job::CycleKind::Slot(_), None) => (81, None),
        (job::CycleKind::Drill | job::CycleKind::Circles { .. } | job::CycleKind::Slot(_), Some(_)) => (82, None),
    }
}
