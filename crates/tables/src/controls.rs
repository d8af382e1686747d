//! Row types: controls of machines, conventions of programs.

pub mod control_2c42_65;
pub mod iso;
pub mod lathe;
pub mod lathe_reading;

use technolog_knowledge::contract::{FromValue, Holds};
use technolog_knowledge::value::Value;
use technolog_knowledge::{rows, vocabulary};

/// A letter of a program: an address.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Letter(pub char);

impl FromValue<'_> for Letter {
    const HOLDS: Holds = Holds::Text;

    fn from_value(value: &Value) -> Option<Self> {
        let mut letters = value.as_text()?.chars();
        letters.next().filter(|_| letters.next().is_none()).map(Self)
    }
}

vocabulary! {
    /// When an M function acts within its block.
    pub enum Acts {
        /// Before the motion.
        Start = "start",
        /// After it.
        End = "end",
    }

    /// A figure of `program-conventions`.
    pub enum Convention {
        /// The height above the entry face at which a tool moves from point to point, mm.
        Withdrawal = "withdrawal",
        /// How high over a clamp or an obstacle a tool goes, mm.
        ObstacleClearance = "obstacle-clearance",
        /// How far beside a clamp or an obstacle of a measured outline a tool keeps, mm.
        ObstacleSide = "obstacle-side",
        /// How much more room than tools need supports leave below the part, mm.
        SupportRoom = "support-room",
        /// The step to which the height of the knee is set, mm.
        KneeStep = "knee-step",
        /// The increment of block numbers.
        BlockNumberStep = "block-number-step",
        /// The step in which programs give feeds, mm/min.
        FeedStep = "feed-step",
        /// The factor on the planned speed or feed that is still another choice.
        Overload = "overload",
        /// The same factor for the feed of a centring tool.
        SpotOverload = "spot-overload",
        /// The step in which dwells are given, s.
        DwellStep = "dwell-step",
        /// The factor on the planned dwell above which it is a mistake, and on the planned feed below whose part it is.
        Overlong = "overlong",
        /// The part of a turn that the spindle makes in a dwell in a hole at least.
        DwellTurnsLeast = "dwell-turns-least",
        /// The longest dwell in a hole, s.
        DwellInHoleMost = "dwell-in-hole-most",
        /// The shortest dwell elsewhere that waits for anything, s.
        DwellLeast = "dwell-least",
        /// The longest dwell elsewhere, s.
        DwellMost = "dwell-most",
        /// The longest step of deep drilling, mm.
        PeckMost = "peck-most",
        /// How far the feed of a tap may be off the pitch of a thread, as a part of it.
        TapFeedNear = "tap-feed-near",
        /// How many times the feed of the cuts beside it a feed may be.
        FeedBesideMost = "feed-beside-most",
        /// How many pitches a tap may come out of a through hole farther than the drill before it.
        TapBeyondDrill = "tap-beyond-drill",
        /// How far from its hole a tap is beside it, mm.
        TapBesideHole = "tap-beside-hole",
        /// How many times the depth of the others of its tool a depth may be.
        DepthBesideMost = "depth-beside-most",
        /// The greatest feed of a drill for a turn, as a part of its diameter.
        DrillFeedMost = "drill-feed-most",
        /// How many pitches the hole of a thread is narrower than it at most.
        TapHoleLeast = "tap-hole-least",
        /// How many pitches the hole of a thread is narrower than it at least.
        TapHoleMost = "tap-hole-most",
        /// How far a boring bar is drawn off the wall at most, mm.
        BoringShiftMost = "boring-shift-most",
        /// How far below a through hole a reamer goes at most over free room, mm.
        ReamerOverrunMost = "reamer-overrun-most",
        /// How much wider than its hole a reamer is at most, mm.
        ReamerStockMost = "reamer-stock-most",
        /// The greatest feed of a turn, mm.
        FeedOfTurnMost = "feed-of-turn-most",
        /// The least feed of a minute, mm.
        FeedOfMinuteLeast = "feed-of-minute-least",
        /// How far around its cuts a program has made room, mm.
        CutsAround = "cuts-around",
        /// The time to put a tool into the magazine by hand, min.
        LoadToolTime = "load-tool-time",
        /// The time to set the bar of a boring tool to a diameter, min.
        SetBarTime = "set-bar-time",
        /// The time to turn the part over and clamp it again, min.
        TurnOverTime = "turn-over-time",
    }
}

impl Convention {
    /// The unit of its value, as the table writes it.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Withdrawal
            | Self::ObstacleClearance
            | Self::ObstacleSide
            | Self::SupportRoom
            | Self::KneeStep
            | Self::PeckMost
            | Self::ReamerOverrunMost
            | Self::ReamerStockMost
            | Self::BoringShiftMost
            | Self::TapBesideHole
            | Self::FeedOfTurnMost
            | Self::CutsAround => "mm",
            Self::FeedStep | Self::FeedOfMinuteLeast => "mm/min",
            Self::DwellStep | Self::DwellInHoleMost | Self::DwellLeast | Self::DwellMost => "s",
            Self::LoadToolTime | Self::SetBarTime | Self::TurnOverTime => "min",
            Self::BlockNumberStep
            | Self::Overload
            | Self::SpotOverload
            | Self::Overlong
            | Self::DwellTurnsLeast
            | Self::TapFeedNear
            | Self::TapBeyondDrill
            | Self::DrillFeedMost
            | Self::TapHoleLeast
            | Self::TapHoleMost
            | Self::DepthBesideMost
            | Self::FeedBesideMost => "1",
        }
    }
}

vocabulary! {
    /// A step of setting a control, in the order of the work.
    pub enum OperatorStage {
        /// The mode of input from the panel.
        Input = "input",
        /// The table of correctors.
        Correctors = "correctors",
        /// The reference tool on the gauge block.
        Reference = "reference",
        /// Another tool on it, into its corrector.
        Corrector = "corrector",
        /// The display as it was.
        Restore = "restore",
        /// Out of the table.
        Leave = "leave",
        /// The table of zeros.
        Zeros = "zeros",
        /// A page on.
        Page = "page",
        /// A value by hand.
        Value = "value",
        /// Z as it is shown.
        ReadZ = "read-z",
    }
}

rows! {
    /// Keys of setting controls.
    pub struct OperatorKeys of One("operator-keys") {
        control: &'t str,
        stage: OperatorStage,
        keys: &'t str,
    }

    /// Conventions of programs.
    pub struct ProgramConventions of One("program-conventions") complete name {
        name: Convention,
        value: f64,
        unit: &'t str,
    }
}
