//! Motions of a block: positioning and lines, in the active system or in machine coordinates (G53), and the returns
//! G28 and G30.

use super::block::Maker;
use super::control::{Characteristic as Q, Effect, Group};
use super::words::{BlockWords, Function, WordValue};
use crate::motion::{Axis, Motion, Position};
use crate::note::IntoFigure;
use crate::program::TextSpan;
use crate::program::limits::Floating;
use crate::units::{Micrometres, MillimetresPerMinute};

/// The target position of a block.
#[derive(Clone, Copy, Debug)]
pub(super) struct Target {
    pub at: Position,
    /// What rounding has taken off it, mm.
    pub lost: [f64; 3],
    pub floating: [Floating; 3],
    /// The first word of an axis.
    pub span: Option<TextSpan>,
}

impl Maker<'_> {
    /// The motion or the cycle of the block, if any.
    ///
    /// A function of motion ends a cycle. G80 ends it too; where cycles are motions it ends these as well.
    pub(super) fn motion(&mut self, words: &BlockWords) {
        let cycle = words.function(Group::Cycle);
        let off = cycle.is_some_and(|it| self.control.g.get(&it.code).is_some_and(|it| it.effect == Effect::CycleOff));
        if let Some(function) = words.function(Group::Motion) {
            self.state.set(Group::Motion, Some(function.code));
            if self.state.mode(Group::Cycle).is_some() {
                self.cycle_off();
            }
        }
        if off {
            self.cycle_off();
            // G80 beside a function of motion only ends the cycle.
            if self.control.is(Q::CyclesAreMotions) && words.function(Group::Motion).is_none() {
                self.state.set(Group::Motion, None);
            }
        }
        if let Some(function) = words.one_shot(Effect::Return, self.control) {
            let other = words.function(Group::Motion).or(cycle.filter(|_| !off));
            if let Some(other) = other.filter(|_| self.control.is(Q::ReturnAlone)) {
                let figures = [("first", other.name().into_figure()), ("second", function.name().into_figure())];
                self.report("axes-taken-twice", function.span, &figures);
                return;
            }
            return self.returning(function, words);
        }
        // Where X may be a time, the block moves nothing.
        if self.control.is(Q::DwellInX) && words.one_shot(Effect::Dwell, self.control).is_some() {
            return;
        }
        if self.offset_by_value(words) {
            return;
        }
        if let Some((function, effect)) = self.sets_zero(words) {
            return self.set_zero(function, effect, words);
        }
        if let Some(function) = words.one_shot(Effect::MachinePosition, self.control) {
            return self.on_machine(function, words);
        }
        if let Some(function) = cycle.filter(|_| !off) {
            return self.cycle(function.code, Some(function), words);
        }
        if let Some(code) = self.state.mode(Group::Cycle) {
            return self.cycle(code, None, words);
        }
        match self.state.mode(Group::Motion) {
            Some(20 | 30) => self.arc(words),
            Some(330 | 331) => self.thread(words, self.state.mode(Group::Motion) == Some(331)),
            Some(382..=385) => self.probe(words),
            Some(code) => self.line(code, words),
            None => {
                if let Some(span) = self.target(words, false).span {
                    self.fault("motion-missing", span);
                }
            }
        }
    }

    fn line(&mut self, code: i64, words: &BlockWords) {
        let target = self.target(words, false);
        let Some(span) = target.span else { return };
        let motion =
            if code == 0 { Motion::Rapid } else { Motion::Feed { feed_mm_per_min: self.line_feed(target.at, span) } };
        self.go(motion, target.at, target.floating, span);
        self.state.lost = target.lost;
    }

    /// The feed of a line from where the axes are.
    fn line_feed(&mut self, to: Position, span: TextSpan) -> MillimetresPerMinute {
        let along = Axis::ALL.map(|axis| (to.get(axis) - self.state.at.get(axis)).to_mm());
        let length = libm::sqrt(along.iter().map(|part| part * part).sum());
        self.feed_along(Some(length), span)
    }

    /// The target of the words: positions in the active system (G90), or distances (G91). In machine coordinates
    /// (G53) they are positions from the machine zero, without length correction.
    pub(super) fn target(&mut self, words: &BlockWords, on_machine: bool) -> Target {
        let Maker { state, .. } = self;
        let mut target = Target { at: state.at, lost: state.lost, floating: state.floating, span: None };
        if !on_machine {
            self.polar(words, &mut target);
        }
        for axis in Axis::ALL {
            let Some(word) = self.take_axis(words, axis) else { continue };
            let inches = self.state.inches();
            let value = word.length(inches);
            self.finer_than_machine(value, word.span);
            let over = word.exact_mm(inches) - value.to_mm();
            let (at, over, floating) = if on_machine {
                (value, over, None)
            } else if self.state.absolute() {
                let (origin, floating) = self.state.origin(axis, self.setting);
                (origin + value, over, floating)
            } else {
                // What was lost before counts, so that many small distances do not add up to an error.
                let over = over + target.lost[axis.index()];
                let whole = Micrometres::from_mm_rounded(over);
                (target.at.get(axis) + value + whole, over - whole.to_mm(), target.floating[axis.index()])
            };
            target.at = target.at.with(axis, at);
            target.lost[axis.index()] = over;
            target.floating[axis.index()] = floating;
            target.span = target.span.or(Some(word.span));
        }
        target
    }

    /// The word of an axis; behind G7 X counts diameters.
    pub(super) fn take_axis(&mut self, words: &BlockWords, axis: Axis) -> Option<WordValue> {
        let half = axis == Axis::X && self.state.mode(Group::Diameter) == Some(70);
        let word = self.take(words, axis.letter())?;
        Some(if half { WordValue { millionths: word.millionths / 2, ..word } } else { word })
    }

    /// `@` and `^`: the distance from the zero and the angle, degrees; one that is missing is that of the present place.
    fn polar(&mut self, words: &BlockWords, target: &mut Target) {
        let [distance, angle] = ['@', '^'].map(|address| self.take(words, address));
        let Some(span) = distance.or(angle).map(|word| word.span) else { return };
        if self.state.mode(Group::Plane) != Some(170) {
            self.fault("polar-plane", span);
        }
        if let Some(other) = words.get('X').or(words.get('Y')) {
            let sign = if distance.is_some() { "@" } else { "^" };
            self.report(
                "axes-taken-twice",
                other.span,
                &[("first", sign.into_figure()), ("second", "X, Y".into_figure())],
            );
        }
        let origins = [Axis::X, Axis::Y].map(|axis| self.state.origin(axis, self.setting));
        let mm = |axis: Axis| self.state.at.get(axis).to_mm() - origins[axis.index()].0.to_mm();
        let [x, y] = [Axis::X, Axis::Y].map(|axis| mm(axis) + self.state.lost[axis.index()]);
        let (mut radius, mut degrees) = (libm::hypot(x, y), libm::atan2(y, x).to_degrees());
        let add = !self.state.absolute();
        if let Some(given) = distance {
            radius = given.exact_mm(self.state.inches()) + if add { radius } else { 0.0 };
        }
        if let Some(given) = angle {
            degrees = given.value() + if add { degrees } else { 0.0 };
        }
        let turned = degrees.to_radians();
        for (axis, exact) in [(Axis::X, radius * libm::cos(turned)), (Axis::Y, radius * libm::sin(turned))] {
            let whole = Micrometres::from_mm_rounded(exact);
            let (origin, floating) = origins[axis.index()];
            target.at = target.at.with(axis, origin + whole);
            target.lost[axis.index()] = exact - whole.to_mm();
            target.floating[axis.index()] = floating;
        }
        target.span = Some(span);
    }

    /// The control resolves thousandths, perhaps finer than the machine. Inches are rounded anyway.
    fn finer_than_machine(&mut self, value: crate::units::Micrometres, span: TextSpan) {
        let Some(step) = self.machine.map(|machine| machine.resolution) else { return };
        if !self.state.inches() && value.micrometres() % step.micrometres().max(1) != 0 {
            self.report("finer-than-machine", span, &[("step", step.into_figure())]);
        }
    }

    /// G53: a position of the machine, with the active motion, or at rapid whatever it is.
    fn on_machine(&mut self, function: Function, words: &BlockWords) {
        if !self.state.absolute() {
            self.fault("machine-position-with-g91", function.span);
            return;
        }
        let target = self.target(words, true);
        let Some(span) = target.span else { return };
        let code = if self.control.is(Q::MachinePositionAtRapid) { Some(0) } else { self.state.mode(Group::Motion) };
        // G80 beside it only ends a cycle, where it is no function of motion.
        let ends = |it: Function| self.control.g.get(&it.code).is_some_and(|it| it.effect == Effect::CycleOff);
        let other = words.function(Group::Cycle).filter(|it| self.control.is(Q::CyclesAreMotions) || !ends(*it));
        let motion = match code.filter(|_| other.is_none()) {
            Some(0) => Motion::Rapid,
            Some(10) => Motion::Feed { feed_mm_per_min: self.line_feed(target.at, span) },
            _ => {
                self.fault("motion-missing", function.span);
                return;
            }
        };
        self.goes_home(target.at, span);
        self.go(motion, target.at, target.floating, span);
        self.state.lost = target.lost;
        self.state.z_on_machine |= words.names(Axis::Z);
    }

    /// A way to a place of the machine that goes sideways while the tool stands in what it has cut, whether the spindle turns or not.
    fn goes_home(&mut self, to: Position, span: TextSpan) {
        let at = self.state.at;
        let zero = self.state.origin(Axis::Z, self.setting).0;
        let sideways = to.x != at.x || to.y != at.y;
        if sideways
            && at.z < zero
            && self.state.floating[Axis::Z.index()].is_some() == self.state.stay.floats()
            && self.state.stay.is_in_cut(at.z)
        {
            self.fault("home-in-cut", span).of_program_alone = true;
        }
    }

    /// A return by a point below, on the face or in the part: with G90 `Z0` of a return is a place of the program.
    fn goes_down_first(&mut self, through: Target, words: &BlockWords, span: TextSpan) {
        if !words.names(Axis::Z) {
            return;
        }
        let z = Axis::Z.index();
        let (at, to, zero) = (self.state.at.z, through.at.z, self.state.origin(Axis::Z, self.setting).0);
        let other_zero = through.floating[z] != self.state.floating[z];
        if (other_zero || to < at) && to <= zero {
            self.fault("return-goes-down", span);
        }
    }

    /// The second reference point: of the setting, or else, where the builder of the machine sets it, the place of its
    /// tool change, which the run has to assume.
    fn second_point(&mut self, function: Function) -> Option<Position> {
        let known = self.setting.fixed_point;
        if known.is_none() && self.control.is(Q::ReturnNumber) {
            let Some(machine) = self.machine else {
                self.fault("fixed-point-not-given", function.span);
                return Some(Position::default());
            };
            let place = Position::of(machine.change_place());
            let shown = crate::motion::trace::position(place).into_figure();
            self.report("fixed-point-assumed", function.span, &[("place", shown)]);
            return Some(place);
        }
        known
    }

    /// G28, G30: at rapid through the point of the words, then along their axes to the machine zero or to the fixed
    /// point of the setting. Without words some controls move every axis.
    fn returning(&mut self, function: Function, words: &BlockWords) {
        let goal = if function.code == 280 { Some(Position::default()) } else { self.second_point(function) };
        // P2 means the same point as G30 alone.
        let second = function.code == 280
            || !self.control.is(Q::ReturnNumber)
            || self.take(words, 'P').is_none_or(|point| point.millionths == 2_000_000);
        let Some(goal) = goal.filter(|_| second) else {
            self.report("fixed-point-unknown", function.span, &[("function", function.name().into_figure())]);
            return;
        };
        let named: Vec<Axis> = Axis::ALL.into_iter().filter(|axis| words.get(axis.letter()).is_some()).collect();
        let through = self.target(words, false);
        if named.is_empty() && !self.control.is(Q::ReturnOfAllAxes) {
            self.report("axes-missing", function.span, &[("function", function.name().into_figure())]);
            return;
        }
        self.goes_down_first(through, words, function.span);
        self.goes_home(through.at, function.span);
        self.go(Motion::Rapid, through.at, through.floating, function.span);
        let (mut at, mut floating) = (through.at, through.floating);
        let named = if named.is_empty() { Axis::ALL.to_vec() } else { named };
        for axis in named.iter().copied() {
            at = at.with(axis, goal.get(axis));
            floating[axis.index()] = None;
        }
        self.goes_home(at, function.span);
        self.go(Motion::Rapid, at, floating, function.span);
        self.state.z_on_machine |= named.contains(&Axis::Z);
    }
}
