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
    /// When in its block an M function acts.
    pub enum Acts {
        /// Before the motion.
        Start = "start",
        /// After it.
        End = "end",
    }

    /// A figure of `program-conventions`.
    pub enum Convention {
        /// How high over the entry face a tool goes from point to point, mm.
        Withdrawal = "withdrawal",
        /// To what the height of the knee is set, mm.
        KneeStep = "knee-step",
        /// By how much the numbers of blocks grow.
        BlockNumberStep = "block-number-step",
        /// In what steps programs count feeds, mm/min.
        FeedStep = "feed-step",
        /// How many times the planned speed or feed somebody else may have chosen.
        Overload = "overload",
        /// How many times the planned feed of a centring tool somebody else may have chosen.
        SpotOverload = "spot-overload",
        /// In what steps dwells are counted, s.
        DwellStep = "dwell-step",
        /// How many times the planned dwell is no choice any more.
        Overlong = "overlong",
        /// What it takes to put a tool into the magazine by hand, min.
        LoadToolTime = "load-tool-time",
        /// What it takes to set the bar of a boring tool to a diameter, min.
        SetBarTime = "set-bar-time",
        /// What it takes to turn the part over and clamp it again, min.
        TurnOverTime = "turn-over-time",
    }
}

impl Convention {
    /// The unit of its value, as the table writes it.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Withdrawal | Self::KneeStep => "mm",
            Self::FeedStep => "mm/min",
            Self::DwellStep => "s",
            Self::LoadToolTime | Self::SetBarTime | Self::TurnOverTime => "min",
            Self::BlockNumberStep | Self::Overload | Self::SpotOverload | Self::Overlong => "1",
        }
    }
}

rows! {
    /// Conventions of programs.
    pub struct ProgramConventions of One("program-conventions") complete name {
        name: Convention,
        value: f64,
        unit: &'t str,
    }
}
