//! The differences between programs for LinuxCNC and Fanuc.

use std::fmt;

use crate::job::{self, Cycle};
use crate::program::block::Block;
use crate::program::iso::control::IsoControl;
use crate::units::{Micrometres, Seconds};

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
    pub(super) fn feed(self, cycle: &Cycle) -> String {
        let text = cycle.feed_mm_per_min.0.to_string();
        if self.0 == IsoControl::Fanuc && !text.contains('.') { text + "." } else { text }
    }

    fn dwell(self, time: Seconds) -> String {
        match self.0 {
            IsoControl::LinuxCnc => time.0.to_string(),
            IsoControl::Fanuc => libm::round(time.0 * 1000.0).to_string(),
        }
    }

    /// The lines before the first block.
    pub(super) fn head(self, part: &str) -> Vec<String> {
        match self.0 {
            IsoControl::LinuxCnc => vec![format!("({part})")],
            IsoControl::Fanuc => vec![format!("O0001 ({part})")],
        }
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
        words += &format!(" F{}", self.feed(cycle));
        Block::new().g(98).g(code).word('Z', self.length(lengths(cycle.end))).cycle(words)
    }
}
