//! The state kept from block to block.

use std::collections::{BTreeMap, BTreeSet};

use super::control::LatheLanguage;
use super::corners::Waiting;
use super::expression::Parameters;
use super::motion::{LatheFeed, LatheModes, LathePlace, LathePoint, LatheSpeed, LatheTool};
use crate::motion::{Side, Turning};
use crate::tables::controls::lathe_reading::{LatheGroup, WordEffect};
use crate::units::{MetresPerMinute, MillimetresPerMinute, MillimetresPerRev, RevsPerMinute};

/// The first block of a cycle of Fanuc, kept for the second.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct FirstBlocks {
    /// G71: depth and retract.
    pub along: Option<(f64, f64)>,
    /// G72: the same.
    pub across: Option<(f64, f64)>,
    /// G74 and G75: the way back after each step.
    pub back: Option<f64>,
    /// G76: finishing passes, run-out in tenths of the lead, angle, least depth, finishing allowance.
    pub thread: Option<[f64; 5]>,
}

/// The state of the control; copied before every block.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub at: LathePlace,
    pub modes: BTreeMap<LatheGroup, WordEffect>,
    /// Groups for which the program has given a function.
    pub given: BTreeSet<LatheGroup>,
    /// The active system, by its function.
    pub system: Option<String>,
    pub feed: Option<f64>,
    pub speed: Option<f64>,
    pub limit: Option<f64>,
    pub turning: Turning,
    pub coolant: bool,
    pub wanted: Option<u32>,
    pub tool: Option<LatheTool>,
    /// The largest number of a tool in the program.
    pub numbered: u32,
    /// The names of tools that were called by name, with their numbers here.
    pub named: BTreeMap<String, u32>,
    /// The chamfer or rounding at the end of the motion before.
    pub corner: Option<Waiting>,
    pub parameters: Parameters,
    pub first: FirstBlocks,
    /// R of G90, G92 and G94, modal with it.
    pub box_taper: f64,
    /// The end of G90, G92 or G94, whose X and Z are modal with it too.
    pub box_end: Option<LathePoint>,
    /// The lead of G32 and G92, modal with them.
    pub lead: Option<f64>,
    /// Whether something has moved.
    pub moved: bool,
    /// Whether some length of the program has a point.
    pub pointed: bool,
}

impl State {
    pub fn power_on(language: &LatheLanguage) -> Self {
        Self {
            at: LathePlace::default(),
            modes: language.power_on.iter().copied().collect(),
            given: BTreeSet::new(),
            system: None,
            feed: None,
            speed: None,
            limit: None,
            turning: Turning::Stopped,
            coolant: false,
            wanted: None,
            tool: None,
            numbered: 0,
            named: BTreeMap::new(),
            corner: None,
            parameters: BTreeMap::new(),
            first: FirstBlocks::default(),
            box_taper: 0.0,
            box_end: None,
            lead: None,
            moved: false,
            pointed: false,
        }
    }

    pub fn is(&self, group: LatheGroup, does: WordEffect) -> bool {
        self.modes.get(&group) == Some(&does)
    }

    /// The feed of a line, where one is given.
    pub fn feed(&self) -> Option<LatheFeed> {
        let value = self.feed.filter(|feed| *feed > 0.0)?;
        let turns = self.is(LatheGroup::FeedMode, WordEffect::PerRevolution);
        Some(if turns {
            LatheFeed::PerRevolution(MillimetresPerRev(value))
        } else {
            LatheFeed::PerMinute(MillimetresPerMinute(value))
        })
    }

    /// The modal state.
    pub fn lathe_modes(&self) -> LatheModes {
        let speed = self.speed.map(|speed| {
            if self.is(LatheGroup::SpeedMode, WordEffect::CuttingSpeed) {
                LatheSpeed::Cutting { speed: MetresPerMinute(speed), limit: self.limit.map(RevsPerMinute) }
            } else {
                LatheSpeed::Spindle(RevsPerMinute(speed))
            }
        });
        let compensation = match self.modes.get(&LatheGroup::Compensation) {
            Some(WordEffect::CompensationLeft) => Side::Left,
            Some(WordEffect::CompensationRight) => Side::Right,
            _ => Side::Off,
        };
        LatheModes { tool: self.tool, turning: self.turning, speed, coolant: self.coolant, compensation }
    }
}
