//! The canonical motions: planning makes them, controls print them, interpreters emit them; drawings, traces and
//! times use them.
//!
//! A [`MotionStep`] is one action of the machine and the position of its axes after it. A consumer of steps is a
//! [`Sink`]; there are two here, [`trace::Trace`] (a text) and [`time::Clock`] (a sum of times). A sink numbers its
//! steps itself: the same steps may go to several sinks.
//!
//! Architecture invariant: a motion depends on no control and on no plan.

pub mod geometry;
pub mod time;
pub mod trace;

use serde::Serialize;

pub use crate::machine::Axis;
use crate::units::{Micrometres, MillimetresPerMinute, RevsPerMinute};

/// A position of the axes, or a distance along them, in machine coordinates: mm from the machine zero, exact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct Position {
    /// Along X.
    pub x: Micrometres,
    /// Along Y.
    pub y: Micrometres,
    /// Along Z.
    pub z: Micrometres,
}

impl Position {
    /// From three lengths.
    pub const fn of([x, y, z]: [Micrometres; 3]) -> Self {
        Self { x, y, z }
    }

    /// Along one axis.
    pub const fn get(self, axis: Axis) -> Micrometres {
        match axis {
            Axis::X => self.x,
            Axis::Y => self.y,
            Axis::Z => self.z,
        }
    }

    /// The same except for one axis.
    #[must_use]
    pub const fn with(mut self, axis: Axis, value: Micrometres) -> Self {
        match axis {
            Axis::X => self.x = value,
            Axis::Y => self.y = value,
            Axis::Z => self.z = value,
        }
        self
    }
}

/// A plane of circles and radius correction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Plane {
    /// X to Y, seen from plus Z.
    #[serde(rename = "XY")]
    Xy,
    /// Z to X, seen from plus Y.
    #[serde(rename = "ZX")]
    Zx,
    /// Y to Z, seen from plus X.
    #[serde(rename = "YZ")]
    Yz,
}

impl Plane {
    /// Its first and second axis and the axis perpendicular to it, always right-handed.
    pub const fn axes(self) -> [Axis; 3] {
        match self {
            Self::Xy => [Axis::X, Axis::Y, Axis::Z],
            Self::Zx => [Axis::Z, Axis::X, Axis::Y],
            Self::Yz => [Axis::Y, Axis::Z, Axis::X],
        }
    }

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Xy => "XY",
            Self::Zx => "ZX",
            Self::Yz => "YZ",
        }
    }
}

/// The sense of an arc, seen from the plus end of the axis across its plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sense {
    /// As the hands of a clock.
    Clockwise,
    /// Against them.
    Counterclockwise,
}

impl Sense {
    /// The other one.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Clockwise => Self::Counterclockwise,
            Self::Counterclockwise => Self::Clockwise,
        }
    }
}

/// The rotation of the spindle, seen from the spindle towards the tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Turning {
    /// It stands.
    Stopped,
    /// As the hands of a clock: a right-hand drill cuts.
    Clockwise,
    /// Against them.
    Counterclockwise,
}

impl Turning {
    /// The other way round; a spindle that stands does not turn.
    pub const fn reversed(self) -> Self {
        match self {
            Self::Stopped => Self::Stopped,
            Self::Clockwise => Self::Counterclockwise,
            Self::Counterclockwise => Self::Clockwise,
        }
    }
}

/// The side of its path on which a tool is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// On the path itself.
    Off,
    /// To the left of the direction of motion.
    Left,
    /// To the right.
    Right,
}

/// One action of a machine.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "motion", rename_all = "kebab-case")]
pub enum Motion {
    /// Every axis at the machine's rapid rate, each by itself: the path is no straight line in general.
    Rapid,
    /// A straight line at a feed.
    Feed {
        /// The feed along the line.
        feed_mm_per_min: MillimetresPerMinute,
    },
    /// An arc in a plane, with a motion across it a helix.
    Arc {
        /// Its plane.
        plane: Plane,
        /// Its sense.
        sense: Sense,
        /// Its centre along the plane's first and second axis, machine coordinates.
        centre: [Micrometres; 2],
        /// Whole turns besides the arc itself; a full circle is an arc without any.
        turns: u32,
        /// The feed along the path.
        feed_mm_per_min: MillimetresPerMinute,
    },
    /// The axes wait.
    Dwell {
        /// How long, s.
        seconds: f64,
    },
    /// The spindle starts, stops or changes its speed.
    Spindle {
        /// The new rotation.
        turning: Turning,
        /// Its speed; for a stopped spindle, the speed with which it would start.
        speed_rpm: RevsPerMinute,
    },
    /// The coolant is switched.
    Coolant {
        /// Whether it flows now.
        on: bool,
    },
    /// A tool comes into the spindle.
    ToolChange {
        /// Its number.
        tool: u32,
    },
    /// A length correction begins, changes or, with 0, ends; the axis itself moves in other steps.
    LengthCorrection {
        /// The axis.
        axis: Axis,
        /// The number of the offset register; none where the program itself gives the value.
        #[serde(skip_serializing_if = "Option::is_none")]
        corrector: Option<u32>,
        /// The value added to the axis.
        value: Micrometres,
    },
    /// A radius correction begins, changes or ends.
    RadiusCorrection {
        /// The side.
        side: Side,
        /// The number of the offset register.
        corrector: u32,
        /// The distance to the path.
        value: Micrometres,
    },
    /// A function of the machine without a motion here.
    Auxiliary {
        /// As it is written.
        word: String,
    },
    /// The program stops until the operator starts it again.
    Stop {
        /// Whether it stops only if the operator has switched such stops on.
        optional: bool,
    },
    /// The program ends.
    End,
}

/// The block of a program that a step comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct BlockRef {
    /// Its line in the file, from 1.
    pub line: u32,
    /// Its own number, where it has one.
    #[serde(rename = "block")]
    pub number: Option<u32>,
}

/// A motion, the position of the axes after it, and the block it comes from.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MotionStep {
    /// What is done.
    #[serde(flatten)]
    pub motion: Motion,
    /// The position of the axes after it, machine coordinates, with corrections.
    pub at: Position,
    /// The block that asked for it.
    #[serde(flatten)]
    pub block: BlockRef,
}

/// A consumer of steps.
pub trait Sink {
    /// One more step has been made.
    fn take(&mut self, step: &MotionStep);
}

impl Sink for Vec<MotionStep> {
    fn take(&mut self, step: &MotionStep) {
        self.push(step.clone());
    }
}

impl<A: Sink, B: Sink> Sink for (A, B) {
    fn take(&mut self, step: &MotionStep) {
        self.0.take(step);
        self.1.take(step);
    }
}

impl<S: Sink + ?Sized> Sink for &mut S {
    fn take(&mut self, step: &MotionStep) {
        (**self).take(step);
    }
}
