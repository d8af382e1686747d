//! The motions of a lathe program, the same for every control: the motions of the tool in the half-plane of the part.
//!
//! A position is that of the programmed point of the tool in the part's system, as in the program: the radius (never
//! the diameter) and Z, mm; seen with Z to the right and the radius upwards.

use serde::Serialize;

use crate::motion::{Sense, Side, Turning};
use crate::units::{MetresPerMinute, MillimetresPerMinute, MillimetresPerRev, RevsPerMinute, Seconds};

/// A place of the tool, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LathePoint {
    /// Distance from the axis, mm.
    pub radius_mm: f64,
    /// Along the axis, mm.
    pub z_mm: f64,
}

/// A place with perhaps an unknown axis: before the first motion, at a reference point, at a machine position.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct LathePlace {
    /// Distance from the axis, mm.
    pub radius_mm: Option<f64>,
    /// Along the axis, mm.
    pub z_mm: Option<f64>,
}

impl LathePlace {
    /// The place, where both axes are known.
    pub fn point(self) -> Option<LathePoint> {
        self.radius_mm.zip(self.z_mm).map(|(radius_mm, z_mm)| LathePoint { radius_mm, z_mm })
    }
}

impl From<LathePoint> for LathePlace {
    fn from(point: LathePoint) -> Self {
        Self { radius_mm: Some(point.radius_mm), z_mm: Some(point.z_mm) }
    }
}

/// A feed as the program gives it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum LatheFeed {
    /// G95, G99 of Fanuc.
    PerRevolution(MillimetresPerRev),
    /// G94, G98 of Fanuc.
    PerMinute(MillimetresPerMinute),
}

/// How fast the spindle turns.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum LatheSpeed {
    /// G96: constant cutting speed.
    Cutting {
        /// At the radius where the tool is, m/min.
        speed: MetresPerMinute,
        /// The most that the spindle may turn; none where the program sets none.
        limit: Option<RevsPerMinute>,
    },
    /// G97.
    Spindle(RevsPerMinute),
}

/// A tool of the turret with its offset.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct LatheTool {
    /// Its number.
    pub number: u32,
    /// The number of its offset; none where none is in force.
    pub offset: Option<u32>,
    /// Whether the program calls it by a name, and the number is one that it was given here.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub by_name: bool,
}

/// The modal state during a motion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LatheModes {
    /// The tool.
    pub tool: Option<LatheTool>,
    /// Whether and how the spindle turns.
    pub turning: Turning,
    /// Its programmed speed.
    pub speed: Option<LatheSpeed>,
    /// Whether coolant flows.
    pub coolant: bool,
    /// The side of the contour for nose radius compensation (G41, G42); **not** applied to the positions.
    pub compensation: Side,
}

/// What a motion is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum LatheAct {
    /// Both axes at their rapid rate; the path is no straight line in general.
    Rapid,
    /// To a reference point or a machine position, whose part coordinates are not known.
    Away,
    /// A straight line at feed.
    Feed {
        /// The feed.
        feed: LatheFeed,
    },
    /// An arc at feed.
    Arc {
        /// The feed.
        feed: LatheFeed,
        /// Its centre.
        centre: LathePoint,
        /// Its sense, seen with Z to the right and the radius upwards.
        sense: Sense,
    },
    /// A line synchronised with the spindle.
    Thread {
        /// Travel along the line per turn of the spindle.
        lead: MillimetresPerRev,
        /// How far the spindle turns on from its mark before the line starts, degrees.
        #[serde(skip_serializing_if = "is_zero")]
        start_deg: f64,
    },
    /// The axes wait.
    Dwell {
        /// How long.
        seconds: Seconds,
    },
    /// The spindle starts, stops or changes its speed; the modal state has the result.
    Spindle,
    /// Another tool or offset is active; the modal state has it.
    ToolChange,
    /// The coolant is switched; the modal state has the result.
    Coolant,
    /// A planned stop: M0, M1.
    Stop,
    /// The end of the program.
    End,
}

impl LatheAct {
    /// Whether it cuts: a line, an arc or a thread.
    pub const fn cuts(self) -> bool {
        matches!(self, Self::Feed { .. } | Self::Arc { .. } | Self::Thread { .. })
    }

    /// Whether axes move.
    pub const fn moves(self) -> bool {
        self.cuts() || matches!(self, Self::Rapid | Self::Away)
    }
}

fn is_zero(angle: &f64) -> bool {
    *angle == 0.0
}

/// One action of a lathe.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LatheMotion {
    /// The kind of action.
    #[serde(flatten)]
    pub act: LatheAct,
    /// Where it begins.
    pub from: LathePlace,
    /// Where the tool stands after it.
    pub to: LathePlace,
    /// The modal state during it.
    pub modes: LatheModes,
    /// The line of the program that makes it, from 1; of a cycle, the line of its call.
    pub line: u32,
    /// Whether a cycle makes it.
    pub of_cycle: bool,
}
