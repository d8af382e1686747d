//! The state kept from block to block: the modal functions and the positions of the axes.

use super::control::{Control, GROUPS};
use super::correction::Compensator;
use crate::motion::{Axis, Position, Turning};
use crate::program::Setting;
use crate::program::brought::{Registers, User};
use crate::program::limits::Floating;
use crate::program::setting::Before;
use crate::program::stay::Stay;
use crate::units::Micrometres;

/// Groups of table 3.5 by their subject.
pub(super) const ONE_SHOT: usize = 0;
pub(super) const MOTION: usize = 1;
pub(super) const PLANE: usize = 2;
pub(super) const RADIUS: usize = 3;
pub(super) const LENGTH: usize = 4;
pub(super) const SYSTEM: usize = 5;
pub(super) const CYCLE: usize = 6;
pub(super) const DISTANCE: usize = 7;

/// The state of the control.
#[derive(Debug)]
pub(super) struct ControlState {
    /// The function in force in every group.
    pub groups: [u8; GROUPS],
    /// The groups whose function the program has set itself.
    pub own: [bool; GROUPS],
    /// Whether the program itself has brought Z somewhere: until then the quill may be down.
    pub height_known: bool,
    /// F, in thousandths of mm/min.
    pub feed: i64,
    /// S, 1/min.
    pub speed: i64,
    /// Whose F and S are.
    pub feed_user: User,
    pub speed_user: User,
    /// The functions of length that have acted with a register: G43, G44.
    pub lengths: [bool; 2],
    /// The spindle.
    pub turning: Turning,
    /// T: the tool that the next M06 brings.
    pub wanted: u32,
    /// The correctors of length that the tools have had.
    pub registers: Registers,
    /// The tool in the spindle; 0 before the first M06.
    pub tool: u32,
    /// D and H.
    pub radius_corrector: u32,
    pub length_corrector: u32,
    /// The last parameters of the cycle, by their letters, in thousandths.
    pub parameters: [Option<i64>; 26],
    /// The programmed point, machine coordinates, without corrections.
    pub base: Position,
    /// The length correction in force: its axis and the added value.
    pub length: (Axis, Micrometres),
    /// The number of its offset register; 0 where there is none.
    pub length_in_force: u32,
    /// Axes whose machine position is not known.
    pub floating: [Floating; 3],
    /// Whether a tool was changed where Z stood at a position of the machine, and the program moves by zeros that are not set.
    pub changed_on_machine: bool,
    /// How the tool has stood since it came.
    pub stay: Stay,
    /// The origin set by G92.
    pub origin: Position,
    /// Which of its axes are floating.
    pub origin_floating: [Floating; 3],
    /// Axes that have been homed.
    pub homed: [bool; 3],
    /// The intermediate point of the last return, which G30 uses again.
    pub stored: Option<Position>,
    /// The radius correction in progress.
    pub compensator: Compensator,
    /// The real positions of the axes.
    pub actual: Position,
}

impl ControlState {
    /// The state after power-on (table 3.5, note 1; 4.1).
    pub(super) fn power_on(control: &Control, setting: &Setting) -> Self {
        Self {
            groups: control.power_on,
            // After power-on what acts is known, too.
            own: [setting.before == Before::PoweredOn; GROUPS],
            height_known: setting.before == Before::PoweredOn,
            feed: 0,
            speed: 0,
            feed_user: User::Nobody,
            speed_user: User::Nobody,
            lengths: [false; 2],
            turning: Turning::Stopped,
            wanted: 0,
            registers: Registers::default(),
            tool: 0,
            radius_corrector: 0,
            length_corrector: 0,
            parameters: [None; 26],
            base: setting.start,
            length: (Axis::Z, Micrometres::ZERO),
            length_in_force: 0,
            floating: [None; 3],
            changed_on_machine: false,
            stay: Stay::comes(setting.start, None),
            origin: Position::default(),
            origin_floating: [None; 3],
            homed: [setting.homed; 3],
            stored: None,
            compensator: Compensator::default(),
            actual: setting.start,
        }
    }

    /// The zero of the active system along an axis, machine coordinates, and whether it was set.
    ///
    /// G53 is relative to the machine zero, G92 to its own origin, G54…G59 to the operator's zero with СМ1, СМ2.
    pub(super) fn origin_of(&self, axis: Axis, setting: &Setting) -> (Micrometres, Floating) {
        let system = self.groups[SYSTEM];
        match system {
            53 => (Micrometres::ZERO, None),
            92 => (self.origin.get(axis), self.origin_floating[axis.index()]),
            _ => {
                let zero = setting.zeros.get(usize::from(system.saturating_sub(54))).and_then(|it| it[axis.index()]);
                let shift = setting.shift.get(axis);
                let unknown = zero.is_none() || setting.assumed.zeros[axis.index()];
                (zero.unwrap_or_default() + shift, unknown.then_some(system))
            }
        }
    }

    /// 1, or -1 along a mirrored axis; positions of the machine itself are not mirrored (4.2.4.4).
    pub(super) const fn sign(&self, axis: Axis, setting: &Setting) -> i64 {
        if setting.mirror[axis.index()] && self.groups[SYSTEM] != 53 { -1 } else { 1 }
    }

    /// The position of the machine for a programmed point.
    pub(super) fn corrected(&self, base: Position) -> Position {
        let (axis, value) = self.length;
        base.with(axis, base.get(axis) + value)
    }

    /// Whether words are positions (G90).
    pub(super) const fn absolute(&self) -> bool {
        self.groups[DISTANCE] != 91
    }
}
