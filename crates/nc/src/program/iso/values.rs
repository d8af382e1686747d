//! The parameters of a run: those of the program, and those of the control that follow from its state.

use std::collections::BTreeMap;

use super::control::{Characteristic as Q, Control, Group};
use super::state::ControlState;
use super::zeros::SYSTEMS;
use crate::motion::{Axis, Turning};
use crate::program::Setting;
use crate::program::expression::Lookup;

/// What the program has set. A value that is not known is kept as none.
#[derive(Debug, Default)]
pub(super) struct Values {
    shared: BTreeMap<String, Option<f64>>,
    local: Locals,
    /// Whether those that were never set are 0.
    zero: bool,
    /// How many numbers each called o-word has for itself, and the last that belongs to programs; those above are the control's own.
    numbers: (u32, u32),
}

/// The parameters that a called o-word has for itself: `#1` to `#30` and names that do not begin with `_`.
pub(super) type Locals = BTreeMap<String, Option<f64>>;

impl Values {
    pub(super) fn new(control: &Control) -> Self {
        let numbers = (control.local_parameters, control.free_parameters);
        Self { zero: control.is(Q::OWords), numbers, ..Self::default() }
    }

    fn is_local(&self, name: &str) -> bool {
        match number(name) {
            Some(number) => number <= self.numbers.0,
            None => !name.starts_with("#_"),
        }
    }

    pub(super) fn set(&mut self, name: String, value: Option<f64>) {
        let owner = if self.zero && self.is_local(&name) { &mut self.local } else { &mut self.shared };
        owner.insert(name, value);
    }

    /// Where the probe touched, and whether, only the machine knows.
    pub(super) fn forget_probe(&mut self) {
        self.shared.retain(|name, _| !number(name).is_some_and(|number| (5061..=5070).contains(&number)));
    }

    /// Begins a called o-word with its arguments; what the caller had.
    pub(super) fn enter(&mut self, arguments: impl Iterator<Item = Option<f64>>) -> Locals {
        let given = (1..=self.numbers.0).zip(arguments).map(|(number, value)| (format!("#{number}"), value));
        std::mem::replace(&mut self.local, given.collect())
    }

    /// Goes back to the caller.
    pub(super) fn leave(&mut self, before: Locals) {
        self.local = before;
    }
}

/// Whether a parameter is a point of G28 or G30, a shift or a zero.
pub(super) fn is_place(name: &str) -> bool {
    number(name).is_some_and(|number| (5161..=5390).contains(&number))
}

fn number(name: &str) -> Option<u32> {
    name.strip_prefix('#')?.parse().ok()
}

/// The parameters as a block sees them.
pub(super) struct Seen<'a> {
    pub values: &'a Values,
    pub state: &'a ControlState,
    pub setting: &'a Setting,
    pub line: u32,
    /// How deep the block is in calls.
    pub depth: usize,
}

impl Seen<'_> {
    /// A parameter of LinuxCNC itself; none where the state does not say it.
    fn of_control(&self, name: &str) -> Option<f64> {
        let whether = |yes: bool| Some(f64::from(u8::from(yes)));
        let state = self.state;
        let mode = |group: Group, power_on: i64| Some(state.mode(group).unwrap_or(power_on) as f64);
        match name {
            "#5220" => Some(state.system_index() as f64 + 1.0),
            "#5400" | "#_CURRENT_TOOL" => Some(f64::from(state.tool)),
            "#_SELECTED_TOOL" => Some(f64::from(state.wanted)),
            "#5420" | "#_X" => Some(self.position(Axis::X)),
            "#5421" | "#_Y" => Some(self.position(Axis::Y)),
            "#5422" | "#_Z" => Some(self.position(Axis::Z)),
            "#5210" => whether(state.shifted),
            "#_LINE" => Some(f64::from(self.line)),
            "#_METRIC" => whether(!state.inches()),
            "#_IMPERIAL" => whether(state.inches()),
            "#_ABSOLUTE" => whether(state.absolute()),
            "#_INCREMENTAL" => whether(!state.absolute()),
            // The version whose interpreter ours is held against.
            "#_VMAJOR" => Some(2.9),
            "#_INVERSE_TIME" => whether(state.mode(Group::FeedMode) == Some(930)),
            "#_UNITS_PER_MINUTE" => whether(state.mode(Group::FeedMode).is_none_or(|mode| mode == 940)),
            "#_UNITS_PER_REV" => whether(state.mode(Group::FeedMode) == Some(950)),
            "#_LATHE_DIAMETER_MODE" => whether(state.mode(Group::Diameter) == Some(70)),
            "#_LATHE_RADIUS_MODE" => whether(state.mode(Group::Diameter) != Some(70)),
            "#_IJK_ABSOLUTE_MODE" => whether(state.mode(Group::ArcDistance) == Some(901)),
            "#_TOOL_OFFSET" => whether(state.mode(Group::Length).is_some_and(|mode| mode != 490)),
            // F of G93 counts ways in a minute and has no unit of length.
            "#_FEED" => {
                let by_time = state.mode(Group::FeedMode) == Some(930);
                Some(state.feed / if state.inches() && !by_time { 25.4 } else { 1.0 })
            }
            "#_PLANE" => mode(Group::Plane, 170),
            "#_COORD_SYSTEM" => mode(Group::System, 540),
            "#_RPM" => Some(state.speed),
            "#_SPINDLE_ON" => whether(state.turning != Turning::Stopped),
            "#_SPINDLE_CW" => whether(state.turning == Turning::Clockwise),
            "#_CALL_LEVEL" => Some(self.depth as f64),
            // These count the unit of the machine, which a program does not say.
            _ => self.of_machine(name).filter(|value| *value == 0.0),
        }
    }

    /// A parameter in the unit of the machine: the point of G28, the shift, the zeros; mm.
    fn of_machine(&self, name: &str) -> Option<f64> {
        let number = number(name)?;
        let along = |first: u32| Axis::ALL.get(usize::try_from(number.checked_sub(first)?).ok()?).copied();
        if let Some(axis) = along(5211) {
            return Some(self.state.shift_kept[axis.index()].to_mm());
        }
        if along(5161).is_some() {
            return Some(0.0);
        }
        let system = usize::try_from(number.checked_sub(5221)? / 20).ok().filter(|system| *system < SYSTEMS)?;
        let axis = along(5221 + 20 * u32::try_from(system).ok()?)?;
        let (zero, floating) = self.state.zero(system, axis, self.setting)?;
        floating.is_none().then(|| zero.to_mm())
    }

    /// Where an axis is in the program's system, in the program's unit.
    fn position(&self, axis: Axis) -> f64 {
        let here = self.state.at.get(axis) - self.state.origin(axis, self.setting).0;
        (here.to_mm() + self.state.lost[axis.index()]) / if self.state.inches() { 25.4 } else { 1.0 }
    }
}

impl Lookup for Seen<'_> {
    fn value_of(&self, name: &str) -> Option<f64> {
        let Values { shared, local, zero, numbers: (_, free) } = self.values;
        if let Some(value) = local.get(name).or_else(|| shared.get(name)) {
            return *value;
        }
        match number(name) {
            _ if !zero => None,
            Some(number) if number <= *free => Some(0.0),
            _ => self.of_control(name),
        }
    }
}
