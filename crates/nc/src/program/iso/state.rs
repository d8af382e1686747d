//! The state kept from block to block: the modal functions and the positions of the axes.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::control::{Control, Effect, Group};
use super::kept::Kept;
use super::zeros::SYSTEMS;
use crate::motion::{Axis, Plane, Position, Turning};
use crate::program::Setting;
use crate::program::TextSpan;
use crate::program::brought::Registers;
pub(super) use crate::program::brought::User;
use crate::program::limits::Floating;
use crate::program::setting::Before;
use crate::program::stay::Stay;
use crate::units::Micrometres;

/// The function in force in every group.
pub(super) type Modes = [Option<i64>; Group::NAMES.len()];

/// The state of the control. Copied before every block, and kept only if the block has no error.
#[derive(Clone, Debug)]
pub(super) struct ControlState {
    /// The function in force in every group, in tenths; none for cycles when no cycle is active, and none for motions
    /// where G80 cancels those too.
    modes: Modes,
    /// The groups whose function the program has set itself.
    pub own: [bool; Group::NAMES.len()],
    /// Whether the program itself has brought Z somewhere: until then the quill may be down.
    pub height_known: bool,
    /// Whether G91 came with a return and nobody has said since that distances are meant, and whether a tool came since.
    pub left_by_return: Option<bool>,
    /// Whether a subprogram that was called with G90 has left G91, and at which depth of calls at most it counts.
    pub left_by_call: Option<usize>,
    /// The register of the radius.
    pub radius_register: Option<u32>,
    /// Whether motions are not carried out until the next function of motion or cycle.
    pub passes: bool,
    /// Whether the M function before a tapping cycle acts.
    pub tap_prepared: bool,
    /// Where it stands, until a tapping cycle comes.
    pub tap_expected: Option<TextSpan>,
    /// F, mm/min.
    pub feed: f64,
    /// S, 1/min.
    pub speed: f64,
    /// Whose F and S are.
    pub feed_user: User,
    pub speed_user: User,
    pub turning: Turning,
    /// Whether the coolant flows.
    pub coolant: bool,
    /// What M70 and M73 have kept, by the depth of calls.
    pub kept: Vec<Option<Kept>>,
    /// T: the tool that the next M6 brings.
    pub wanted: u32,
    /// The tool that the operator has put in at a stop, where no M6 did.
    pub by_hand: u32,
    /// Whether a T has named it; T0 of LinuxCNC takes the tool out.
    pub tool_named: bool,
    /// The tool in the spindle.
    pub tool: u32,
    /// The offset registers that the tools have had.
    pub registers: Registers,
    /// What G43 adds to Z.
    pub length: Micrometres,
    /// The zeros of the systems, G54 to G59.3, machine coordinates, and by which zero that is not known they are counted.
    pub zeros: [[Option<(Micrometres, Floating)>; 3]; SYSTEMS],
    /// What G52 and G92 add to every zero, and what G92.3 brings back.
    pub shift: [Micrometres; 3],
    pub shift_kept: [Micrometres; 3],
    /// Whether the shift acts.
    pub shifted: bool,
    /// The lengths of the tools.
    pub correctors: Rc<BTreeMap<u32, Micrometres>>,
    /// The last parameters of cycles, by their letters: lengths in micrometres, P in millionths of a second.
    pub parameters: [Option<i64>; 26],
    /// Z at the start of the first of several cycles, in the program's system.
    pub initial: Option<Micrometres>,
    /// Where the axes are, machine coordinates.
    pub at: Position,
    /// What rounding to the micrometre has taken off the position of each axis, mm: an arc is judged before it.
    pub lost: [f64; 3],
    /// Axes whose machine position is not known.
    pub floating: [Floating; 3],
    /// Whether the program has moved any axis: before that they stand where nobody knows.
    pub moved: bool,
    /// Whether Z was last brought to a position of the machine.
    pub z_on_machine: bool,
    /// Whether a tool was changed there.
    pub changed_on_machine: bool,
    /// How the tool has stood since it came.
    pub stay: Stay,
}

impl ControlState {
    pub(super) fn power_on(control: &Control, setting: &Setting) -> Self {
        let mut state = Self {
            modes: [None; Group::NAMES.len()],
            // After power-on what acts is known, too.
            own: [setting.before == Before::PoweredOn; Group::NAMES.len()],
            height_known: setting.before == Before::PoweredOn,
            left_by_return: None,
            left_by_call: None,
            radius_register: None,
            passes: false,
            tap_prepared: false,
            tap_expected: None,
            feed: 0.0,
            speed: 0.0,
            feed_user: User::Nobody,
            speed_user: User::Nobody,
            turning: Turning::Stopped,
            coolant: false,
            kept: Vec::new(),
            wanted: 0,
            by_hand: 0,
            tool_named: false,
            tool: 0,
            registers: Registers::default(),
            length: Micrometres::ZERO,
            zeros: [[None; 3]; SYSTEMS],
            shift: [Micrometres::ZERO; 3],
            shift_kept: [Micrometres::ZERO; 3],
            shifted: false,
            correctors: Rc::new(setting.correctors.clone()),
            parameters: [None; 26],
            initial: None,
            at: setting.start,
            lost: [0.0; 3],
            floating: [None; 3],
            moved: false,
            z_on_machine: false,
            changed_on_machine: false,
            stay: Stay::comes(setting.start, None),
        };
        for code in &control.power_on {
            if let Some(function) = control.g.get(code).filter(|function| function.effect != Effect::CycleOff) {
                state.set(function.group, Some(*code));
            }
        }
        state
    }

    /// The function in force in a group.
    pub(super) const fn mode(&self, group: Group) -> Option<i64> {
        self.modes[group as usize]
    }

    pub(super) const fn modes(&self) -> Modes {
        self.modes
    }

    pub(super) const fn set(&mut self, group: Group, code: Option<i64>) {
        self.modes[group as usize] = code;
    }

    fn is(&self, group: Group, code: i64) -> bool {
        self.mode(group) == Some(code)
    }

    /// Whether lengths are inches (G20, G70).
    pub(super) fn inches(&self) -> bool {
        self.is(Group::Units, 200) || self.is(Group::Units, 700)
    }

    /// Whether words are positions (G90).
    pub(super) fn absolute(&self) -> bool {
        !self.is(Group::Distance, 910)
    }

    /// Whether cycles return to their initial level (G98).
    pub(super) fn to_initial_level(&self) -> bool {
        self.is(Group::Retract, 980)
    }

    pub(super) fn plane(&self) -> Plane {
        match self.mode(Group::Plane) {
            Some(180) => Plane::Zx,
            Some(190) => Plane::Yz,
            _ => Plane::Xy,
        }
    }

    /// The place of the program's system: 0 for G54, 8 for G59.3.
    pub(super) fn system_index(&self) -> usize {
        let code = usize::try_from(self.mode(Group::System).unwrap_or(540)).unwrap_or(540);
        if code > 590 { code - 585 } else { code.saturating_sub(540) / 10 }
    }

    /// The zero of a system along an axis, machine coordinates, where it is set.
    pub(super) fn zero(&self, system: usize, axis: Axis, setting: &Setting) -> Option<(Micrometres, Floating)> {
        let own = self.zeros.get(system).and_then(|zero| zero[axis.index()]);
        let assumed = setting.assumed.zeros[axis.index()];
        let floating = if assumed { u8::try_from(system + 54).ok() } else { None };
        own.or_else(|| setting.zeros.get(system)?[axis.index()].map(|zero| (zero, floating)))
    }

    /// What the length offset adds along an axis.
    pub(super) const fn length_along(&self, axis: Axis) -> Micrometres {
        if matches!(axis, Axis::Z) { self.length } else { Micrometres::ZERO }
    }

    /// The zero of the program's system along an axis, machine coordinates, with shift and length correction, and
    /// whether it was set.
    pub(super) fn origin(&self, axis: Axis, setting: &Setting) -> (Micrometres, Floating) {
        let system = self.system_index();
        let unknown = (Micrometres::ZERO, u8::try_from(system + 54).ok());
        let (zero, floating) = self.zero(system, axis, setting).unwrap_or(unknown);
        (zero + self.shift[axis.index()] + self.length_along(axis), floating)
    }
}
