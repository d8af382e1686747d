//! Motions of a block: positioning, lines, arcs, helices, returns, and the offset G45…G48 (textbook 3.10, 3.11.4).

use super::block::Maker;
use super::state::{ONE_SHOT, PLANE, SYSTEM};
use super::words::{BlockWords, Function, WordValue};
use crate::motion::geometry::{distance, in_plane, sweep};
use crate::motion::{Axis, Motion, Position, Sense};
use crate::note::IntoFigure;
use crate::program::TextSpan;
use crate::program::limits::Floating;
use crate::units::Micrometres;

/// The target position of a block.
#[derive(Clone, Copy, Debug)]
struct Target {
    base: Position,
    floating: [Floating; 3],
}

impl Maker<'_> {
    /// The motion of the block, if it has one.
    pub(super) fn motion(&mut self, words: &BlockWords) {
        // The words of G92 are no motion.
        if words.function(SYSTEM) == Some(92) {
            return;
        }
        let one_shot = words.g[ONE_SHOT];
        let arc = matches!(self.motion_function(), 2 | 3);
        let centred = words.centre.iter().any(Option::is_some);
        match one_shot {
            Some(function) if (27..=31).contains(&function.code) => return self.returning(function, words),
            Some(function) if function.code == 10 && !arc => {
                self.fault("helix-without-arc", function.span);
                return;
            }
            // The position where the signal would stop it is not known: the whole motion is made.
            Some(function) if function.code == 32 => {
                self.fault("until-signal", function.span);
            }
            Some(function) if function.code == 60 => {
                self.fault("one-sided", function.span);
            }
            _ => {}
        }
        if let Some(stray) = words.centre.iter().flatten().next().filter(|_| !arc) {
            self.report("word-unused", stray.span, &[("word", "I, J, K".to_owned().into_figure())]);
        }
        let moves = words.any_axis() || (arc && centred);
        if !moves {
            return;
        }
        if !self.axes_may_move(words) {
            return;
        }
        let mut target = self.target(words);
        let mut centre = words.centre.map(|given| given.map(|given| Micrometres::new(given.thousandths)));
        self.offset(words, &mut target, &mut centre);
        let from = self.state.corrected(self.state.base);
        let span = words.axes.iter().chain(&words.centre).flatten().next().map_or(self.span, |word| word.span);
        let one_sided = one_shot.is_some_and(|function| function.code == 60);
        let motion = match self.motion_function() {
            0 => Motion::Rapid,
            _ if one_sided => Motion::Rapid,
            2 | 3 => match self.arc(words, &mut target, centre, span) {
                Some(motion) => motion,
                None => return,
            },
            _ => Motion::Feed { feed_mm_per_min: self.feed(span) },
        };
        self.state.base = target.base;
        self.state.floating = target.floating;
        self.push_from(motion, from, span);
    }

    /// Whether every axis of the block may move: no motion before the search of the machine zero (4.2.5, note 4).
    fn axes_may_move(&mut self, words: &BlockWords) -> bool {
        let mut may = true;
        for axis in Axis::ALL {
            if let Some(word) = words.axis(axis) {
                may &= self.may_move(axis, word.span);
            }
        }
        may
    }

    /// Whether an axis may move.
    pub(super) fn may_move(&mut self, axis: Axis, span: TextSpan) -> bool {
        let homed = self.state.homed[axis.index()];
        if !homed {
            self.report("not-homed", span, &[("axis", axis.letter().into_figure())]);
        }
        homed
    }

    /// The target of the words: positions in the active system (G90), or distances (G91).
    fn target(&self, words: &BlockWords) -> Target {
        let mut target = Target { base: self.state.base, floating: self.state.floating };
        for axis in Axis::ALL {
            let Some(word) = words.axis(axis) else { continue };
            let (value, floating) = self.level(axis, word.thousandths, self.state.base.get(axis));
            target.base = target.base.with(axis, value);
            target.floating[axis.index()] = floating;
        }
        target
    }

    /// A number as a machine position: in the active system, or from a point.
    pub(super) fn level(&self, axis: Axis, thousandths: i64, from: Micrometres) -> (Micrometres, Floating) {
        let value = Micrometres::new(thousandths * self.state.sign(axis, self.setting));
        if self.state.absolute() {
            let (origin, floating) = self.state.origin_of(axis, self.setting);
            (origin + value, floating)
        } else {
            (from + value, self.state.floating[axis.index()])
        }
    }

    /// G45…G48: the travel along every axis of the plane in the block becomes longer or shorter by the value of D,
    /// once or twice, and so do I, J, K (tables 3.8, 3.9). A travel of 0 counts as positive: so the contour of the
    /// example in 3.11.4 closes.
    fn offset(&mut self, words: &BlockWords, target: &mut Target, centre: &mut [Option<Micrometres>; 3]) {
        let Some(function) = words.g[ONE_SHOT] else { return };
        let Some(factor) = self.control.offsets.get(function.code).copied() else { return };
        if self.cycle_in_force() {
            let name = format!("G{:02}", function.code);
            self.report("offset-in-cycle", function.span, &[("function", name.into_figure())]);
            return;
        }
        let value = self.corrector(self.state.radius_corrector, function.span).micrometres() * factor;
        let on = self.control.offset_words.get(self.state.groups[PLANE]).cloned().unwrap_or_default();
        for axis in Axis::ALL {
            let sign = self.state.sign(axis, self.setting);
            if words.axis(axis).is_some() && on.contains(&axis.letter()) {
                let at = target.base.get(axis);
                let distance = (at - self.state.base.get(axis)).micrometres() * sign;
                let longer = if distance < 0 { -value } else { value };
                target.base = target.base.with(axis, at + Micrometres::new(longer * sign));
            }
            let letter = ['I', 'J', 'K'][axis.index()];
            if let Some(offset) = centre[axis.index()].as_mut().filter(|_| on.contains(&letter)) {
                let longer = if *offset < Micrometres::ZERO { -value } else { value };
                *offset = *offset + Micrometres::new(longer);
            }
        }
    }

    /// G02, G03, with G10 a helix (3.10.4, 3.10.5). The centre is relative to the start in both G90 and G91. A block
    /// without an axis is a full circle.
    fn arc(
        &mut self,
        words: &BlockWords,
        target: &mut Target,
        centre: [Option<Micrometres>; 3],
        span: TextSpan,
    ) -> Option<Motion> {
        let row = self.control.plane(self.state.groups[PLANE]);
        let [a, b, across] = row.plane.axes();
        if centre[a.index()].is_none() && centre[b.index()].is_none() {
            self.fault("arc-without-centre", span);
            return None;
        }
        let signs = [a, b].map(|axis| self.state.sign(axis, self.setting));
        let middle = [(a, signs[0]), (b, signs[1])].map(|(axis, sign)| {
            let distance = centre[axis.index()].unwrap_or_default().micrometres() * sign;
            self.state.base.get(axis) + Micrometres::new(distance)
        });
        let sense = if self.motion_function() == 2 { Sense::Clockwise } else { Sense::Counterclockwise };
        let sense = if signs[0] * signs[1] < 0 { sense.other() } else { sense };
        let point = [middle[0].to_mm(), middle[1].to_mm()];
        let (start, end) = (in_plane(self.state.base, row.plane), in_plane(target.base, row.plane));
        let (radius, other) = (distance(start, point), distance(end, point));
        if radius == 0.0 {
            self.fault("arc-without-radius", span);
            return None;
        }
        // Start, end and centre are each rounded to the step of the machine; together they may differ by two steps
        // without being wrong.
        if (radius - other).abs() > 2.0 * self.machine.resolution.to_mm() {
            let shown = |value: f64| Micrometres::from_mm_rounded(value).to_string();
            self.report(
                "arc-radius",
                span,
                &[("start", shown(radius).into_figure()), ("end", shown(other).into_figure())],
            );
            return None;
        }
        let helix = words.g[ONE_SHOT].filter(|function| function.code == 10);
        let climb = target.base.get(across) - self.state.base.get(across);
        let turns = match helix {
            Some(function) => {
                let angle = sweep(start, end, point, sense);
                let pitch = words.centre[centre_place(row.pitch)];
                self.turns(pitch, climb, angle, self.state.sign(across, self.setting), function)?
            }
            None if climb != Micrometres::ZERO => {
                self.fault("helix-without-function", span);
                return None;
            }
            None => 0,
        };
        let feed_mm_per_min = self.feed(span);
        // The length correction does not change the plane, so the centre is as programmed.
        Some(Motion::Arc { plane: row.plane, sense, centre: middle, turns, feed_mm_per_min })
    }

    /// Whole turns of a helix: its rise divided by its pitch, minus the arc itself. The pitch is per turn and has the
    /// sign of the rise (3.10.5, notes 1 and 4).
    fn turns(
        &mut self,
        pitch: Option<WordValue>,
        climb: Micrometres,
        angle: f64,
        sign: i64,
        function: Function,
    ) -> Option<u32> {
        let Some(pitch) = pitch.filter(|pitch| pitch.thousandths != 0) else {
            self.fault("helix-pitch-missing", function.span);
            return None;
        };
        let value = pitch.thousandths * sign;
        if value.signum() != climb.micrometres().signum() {
            self.fault("helix-pitch-sign", pitch.span);
            return None;
        }
        let all = climb.to_mm() / (value as f64 / 1000.0);
        let whole = libm::round(all - angle / std::f64::consts::TAU).max(0.0);
        let made = (whole + angle / std::f64::consts::TAU) * value as f64 / 1000.0;
        if (made - climb.to_mm()).abs() > 2.0 * self.machine.resolution.to_mm() {
            let made = Micrometres::from_mm_rounded(made).to_string();
            self.report("helix-pitch", pitch.span, &[("climb", climb.into_figure()), ("made", made.into_figure())]);
            return None;
        }
        Some(whole as u32)
    }

    /// G27…G31, which the text only names. Reconstructed: every axis of the block moves at rapid
    ///
    /// - G27: through the intermediate point of the words to its zero by the limit switches, and is homed then;
    ///   before that the words are relative to its position (4.2.5, note 4);
    /// - G28: through that point to the machine zero;
    /// - G29, G31: through that point to the machine's fixed point;
    /// - G30: through the point stored by the last such function to the point of the words.
    fn returning(&mut self, function: Function, words: &BlockWords) {
        let named: Vec<Axis> = Axis::ALL.into_iter().filter(|axis| words.axis(*axis).is_some()).collect();
        if function.code != 27 && !self.axes_may_move(words) {
            return;
        }
        let mut intermediate = self.target(words);
        // Of an axis without its zero the words of G27 count from where it stands (4.2.5, note 4).
        for axis in named.iter().copied().filter(|axis| !self.state.homed[axis.index()]) {
            let way = words.axis(axis).map_or(0, |word| word.thousandths) * self.state.sign(axis, self.setting);
            intermediate.base = intermediate.base.with(axis, self.state.base.get(axis) + Micrometres::new(way));
            intermediate.floating[axis.index()] = self.state.floating[axis.index()];
        }
        let goal = match function.code {
            27 | 28 => Some(Position::default()),
            30 => Some(intermediate.base),
            _ => self.setting.fixed_point,
        };
        let Some(goal) = goal else {
            self.report(
                "fixed-point-unknown",
                function.span,
                &[("function", format!("G{:02}", function.code).into_figure())],
            );
            return;
        };
        let through = if function.code == 30 {
            let Some(stored) = self.state.stored else {
                self.fault("nothing-stored", function.span);
                return;
            };
            Target { base: stored, floating: self.state.floating }
        } else {
            self.state.stored = Some(intermediate.base);
            intermediate
        };
        self.flush();
        for (point, last) in [(through, false), (Target { base: goal, floating: [None; 3] }, true)] {
            let from = self.state.corrected(self.state.base);
            for axis in &named {
                self.state.base = self.state.base.with(*axis, point.base.get(*axis));
                let floating = if last && function.code == 30 { intermediate.floating } else { point.floating };
                self.state.floating[axis.index()] = floating[axis.index()];
                // The zero is a position of the machine: the length correction is removed on the way there.
                if last && function.code != 30 && self.state.length.0 == *axis {
                    self.state.base = self.state.base.with(*axis, point.base.get(*axis) - self.state.length.1);
                }
                if last && function.code == 27 {
                    self.state.homed[axis.index()] = true;
                }
            }
            self.push_from(Motion::Rapid, from, function.span);
        }
    }
}

/// The place of I, J, K in an array of three.
const fn centre_place(letter: char) -> usize {
    match letter {
        'I' => 0,
        'J' => 1,
        _ => 2,
    }
}
