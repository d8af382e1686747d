//! The differences between programs for LinuxCNC and Fanuc.

use std::fmt;

use crate::job::{self, Cycle};
use crate::program::block::Block;
use crate::program::iso::control::IsoControl;
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
pub(super) struct Dialect(pub IsoControl);

impl Dialect {
    /// A length, mm. Fanuc counts a number without a point in micrometres, unless it is set otherwise.
    pub(super) fn length(self, value: Micrometres) -> String {
        let text = value.to_string();
        if self.0 == IsoControl::Fanuc && !text.contains('.') { text + ".0" } else { text }
    }

    /// A feed, mm/min.
    pub(super) fn feed(self, feed: MillimetresPerMinute) -> String {
        let text = feed.0.to_string();
        if self.0 == IsoControl::Fanuc && !text.contains('.') { text + "." } else { text }
    }

    fn dwell(self, time: Seconds) -> String {
        match self.0 {
            IsoControl::LinuxCnc => time.0.to_string(),
            IsoControl::Fanuc => libm::round(time.0 * 1000.0).to_string(),
        }
    }

    /// The lines before the first block.
    pub(super) fn head(self, part: &str, number: u32) -> Vec<String> {
        match self.0 {
            IsoControl::LinuxCnc => vec![format!("({part})")],
            IsoControl::Fanuc => vec![format!("O{number:04} ({part})")],
        }
    }

    /// From wherever a tool is to the place of the tool change. Of Fanuc G49 stands with the way up, because alone it may
    /// move the axis by the length of the tool, and G53 is always rapid.
    pub(super) fn withdrawal(self, up: String, across: [String; 2]) -> Vec<Block> {
        let [x, y] = across;
        let off = Block::new().g(90).g(80);
        let on_machine = || Block::new().g(53).g(0);
        let (first, up, aside) = match self.0 {
            IsoControl::LinuxCnc => (off.g(49), on_machine().word('Z', up), on_machine()),
            IsoControl::Fanuc => (off, Block::new().g(49).g(53).word('Z', up), Block::new().g(53)),
        };
        vec![first, up, Block::new().m(5), Block::new().m(9), aside.word('X', x).word('Y', y)]
    }

    /// The spindle, and the coolant where it flows. Fanuc takes one M function in a block unless a parameter allows more
    /// (3404#7).
    pub(super) fn turning(self, speed: RevsPerMinute, coolant: bool) -> Vec<Block> {
        let turning = Block::new().word('S', speed.0).m(3);
        match (coolant, self.0) {
            (false, _) => vec![turning],
            (true, IsoControl::LinuxCnc) => vec![turning.m(8)],
            (true, IsoControl::Fanuc) => vec![turning, Block::new().m(8)],
        }
    }

    /// What stands before a cycle: of Fanuc M29, so that a tap is turned and fed as one.
    pub(super) fn before_cycle(self, cycle: &Cycle) -> Option<Block> {
        let rigid = self.0 == IsoControl::Fanuc && matches!(cycle.kind, job::CycleKind::Tap { .. });
        rigid.then(|| Block::new().word('S', cycle.speed_rpm.0).m(29))
    }

    /// The first blocks: what the program relies on.
    pub(super) fn beginning(self) -> Vec<Block> {
        let modes = Block::new().g(21).g(17).g(40).g(49).g(80).g(90).g(94);
        vec![modes]
    }

    pub(super) fn subprogram_begins(self, number: u32) -> String {
        match self.0 {
            IsoControl::LinuxCnc => format!("o{number} sub"),
            IsoControl::Fanuc => format!("O{number:04}"),
        }
    }

    pub(super) fn subprogram_ends(self, number: u32) -> String {
        match self.0 {
            IsoControl::LinuxCnc => format!("o{number} endsub"),
            IsoControl::Fanuc => "M99".to_owned(),
        }
    }

    pub(super) fn call(self, number: usize, called: u32) -> String {
        match self.0 {
            IsoControl::LinuxCnc => format!("o{called} call"),
            IsoControl::Fanuc => Numbered(number, format!("M98 P{called:04}")).to_string(),
        }
    }

    /// The fixed cycle at a point, with return to the initial level (G98).
    pub(super) fn cycle(self, cycle: &Cycle, lengths: impl Fn(Micrometres) -> Micrometres) -> Block {
        let dwell = cycle.dwell_s.map(|time| self.dwell(time));
        let (code, step) = match (&cycle.kind, &dwell) {
            (job::CycleKind::FeedOut, None) => (85, None),
            (job::CycleKind::FeedOut, Some(_)) => (89, None),
            (job::CycleKind::BoreStop, _) => (86, None),
            (job::CycleKind::Peck { step, .. }, _) => (83, Some(*step)),
            (job::CycleKind::ChipBreak { step, .. }, _) => (73, Some(*step)),
            (job::CycleKind::Tap { .. }, _) => (84, None),
            // Milled circles are no fixed cycle: `tool` writes them.
            (job::CycleKind::Drill | job::CycleKind::Circles { .. }, None) => (81, None),
            (job::CycleKind::Drill | job::CycleKind::Circles { .. }, Some(_)) => (82, None),
        };
        let mut words = format!("R{}", self.length(lengths(cycle.begin)));
        if let Some(step) = step {
            words += &format!(" Q{}", self.length(lengths(step)));
        }
        // LinuxCNC does not run G86 without a dwell.
        let needed = (code == 86 && self.0 == IsoControl::LinuxCnc).then(|| "0".to_owned());
        if let Some(dwell) = dwell.or(needed) {
            words += &format!(" P{dwell}");
        }
        words += &format!(" F{}", self.feed(cycle.feed_mm_per_min));
        Block::new().g(98).g(code).word('Z', self.length(lengths(cycle.end))).cycle(words)
    }
}
