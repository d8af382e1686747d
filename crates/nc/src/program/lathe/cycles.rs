//! Cycles that rough and finish along a contour: G70, G71, G72 of LinuxCNC and of Fanuc.

use super::LatheReader;
use super::block::{Maker, point, sense, shown, spot};
use super::contour::{Leg, PassFrame, PassPoint, SAME, Stroke};
use super::motion::{LatheAct, LathePlace, LathePoint};
use super::roughing::{Between, NoPasses, Passes, hollows, levels};
use super::words::{BlockWords, Value};
use crate::program::{Subject, TextSpan};
use crate::tables::controls::lathe_reading::{Form, WordEffect};

/// The name of a cycle.
const fn name(does: WordEffect) -> &'static str {
    match does {
        WordEffect::RoughAlong => "G71",
        WordEffect::RoughAcross => "G72",
        WordEffect::ThreadCycle => "G76",
        _ => "G70",
    }
}

impl Maker<'_> {
    /// Checks the required fields of a cycle; false, with a fault, where one is missing.
    pub(super) fn fields(&mut self, words: &BlockWords, cycle: &str, form: Form, span: TextSpan) -> bool {
        let fields = self.language.cycle(cycle, form);
        let missing: Vec<String> = fields.required.iter().filter(|it| words.look(it).is_none()).cloned().collect();
        if !missing.is_empty() {
            self.report_with("lathe-cycle-field", span, "field", missing.join(", "));
            let last = self.faults.len() - 1;
            self.faults[last].subject = Some(Subject::Function(cycle.to_owned()));
        }
        missing.is_empty()
    }

    /// A word of a cycle that must be above 0.
    pub(super) fn above_zero(&mut self, given: Option<Value>, otherwise: f64, span: TextSpan) -> f64 {
        let value = given.as_ref().map_or(otherwise, |given| given.value);
        if value <= 0.0 || !value.is_finite() {
            let span = given.as_ref().map_or(span, |given| given.span);
            let field = given.map_or_else(String::new, |given| given.name);
            self.report_with("lathe-cycle-value", span, "field", field);
        }
        value
    }

    /// Fanuc takes a length without a point as thousandths of a millimetre or as millimetres; that is reported once a
    /// block.
    pub(super) fn points(&mut self, words: &BlockWords) {
        if !self.is(LatheReader::Fanuc) {
            return;
        }
        // R of the first block of G73 is a number of passes.
        let others = [WordEffect::ThreadCycle, WordEffect::Dwell, WordEffect::NotCarriedOut];
        let thread = others.iter().any(|effect| words.function_for(*effect).is_some());
        let pointless = words
            .all()
            .iter()
            .find(|it| super::text::LENGTHS.contains(&it.name.as_str()) && !it.point && it.value != 0.0);
        if let Some(value) = pointless.filter(|_| !thread) {
            // A program that writes points has forgotten one, and the axis goes a thousandth of the way.
            let code = if self.state.pointed { "point-missing" } else { "number-without-point" };
            self.report_with(code, value.span, "address", value.name.clone());
        }
    }

    /// The start of a cycle of LinuxCNC: its X and Z, or the position of the tool.
    pub(super) fn begin_of_words(&mut self, words: &BlockWords, span: TextSpan) -> Option<LathePoint> {
        let diameter = self.diameters();
        let x = words.take("X").map(|value| value.value * if diameter { 0.5 } else { 1.0 }).or(self.state.at.radius_mm);
        let z = words.take("Z").map(|it| it.value).or(self.state.at.z_mm);
        let place = LathePlace { radius_mm: x, z_mm: z };
        if place.point().is_none() || self.state.at.point().is_none() {
            self.report("lathe-place-unknown", span);
            return None;
        }
        place.point()
    }

    pub(super) fn diameters(&self) -> bool {
        use crate::tables::controls::lathe_reading::LatheGroup::Measure;
        self.is(LatheReader::Fanuc)
            || self.state.is(Measure, WordEffect::Diameters)
            || self.state.is(Measure, WordEffect::DiametersAbsolute)
    }

    /// G70, G71, G72 of LinuxCNC.
    pub(super) fn linuxcnc_cycle(
        &mut self,
        words: &BlockWords,
        does: WordEffect,
        span: TextSpan,
        begin: LathePoint,
        legs: Vec<Leg>,
    ) {
        self.before_moving(span, true);
        if !self.fields(words, name(does), Form::One, span) {
            return;
        }
        for field in ["D", "E"] {
            if let Some(given) = words.take(field).filter(|value| value.value != 0.0).cloned() {
                self.report_with("lathe-cycle-not-read", given.span, "word", format!("{}{}", given.name, given.value));
            }
        }
        // The first motion of the subprogram leads from the tool to the contour, whatever its function.
        let mut legs = legs;
        let Some(first) = legs.first_mut() else {
            self.report("lathe-contour-short", span);
            return;
        };
        first.from = spot(begin);
        if legs.len() < 2 {
            self.report("lathe-contour-short", span);
            return;
        }
        if does == WordEffect::Finish {
            let passes = words.take("P").map_or(1.0, |it| it.value).clamp(0.0, 1000.0) as usize;
            for _ in 0..passes {
                self.stroke(Stroke::Rapid(spot(begin)), PassFrame::default(), span);
                self.along(&legs, span);
            }
        } else {
            let depth = self.above_zero(words.take("I").cloned(), 1.0, span);
            let retract = self.above_zero(words.take("R").cloned(), 0.5, span);
            if !self.broken() {
                self.rough(&legs, does == WordEffect::RoughAcross, (depth, retract), span);
            }
        }
        // It is not certain which motion the control has active afterwards.
        self.state.modes.remove(&crate::tables::controls::lathe_reading::LatheGroup::Motion);
    }

    /// Passes over a contour with pockets, and along it.
    fn rough(&mut self, legs: &[Leg], across: bool, (depth, retract): (f64, f64), span: TextSpan) {
        let (Some(first), Some(last)) = (legs.first(), legs.last()) else { return };
        let frame = PassFrame::of(first.to, last.to, across);
        let mut legs: Vec<Leg> = legs.iter().map(|leg| frame.leg(*leg)).collect();
        // A first element that would lead back is replaced by a straight move down.
        if let Some(first) = legs.first_mut()
            && first.to.z > first.from.z
        {
            first.from.z = first.to.z;
        }
        if let Some(leg) = legs.iter().find(|leg| !leg.is_monotone()) {
            self.report_with("lathe-not-monotone", span, "line", leg.line);
            return;
        }
        let ends = legs.first().map(|it| it.from).zip(legs.last().copied());
        if let Some((top, last)) = ends
            && last.to.x < top.x
        {
            legs.push(Leg { from: last.to, to: PassPoint { x: top.x, ..last.to }, round: None, ..last });
        }
        let made = hollows(&legs, Passes { depth, retract, budget: self.budget });
        self.strokes(made, frame, span);
    }

    pub(super) fn strokes(&mut self, made: Result<Vec<Stroke>, NoPasses>, frame: PassFrame, span: TextSpan) {
        match made {
            Ok(strokes) => strokes.into_iter().for_each(|stroke| self.stroke(stroke, frame, span)),
            Err(NoPasses::TooMany) => self.report_with("run-too-long", span, "budget", crate::program::running::BUDGET),
            Err(NoPasses::Above) => self.report("lathe-cycle-begins-inside", span),
        }
    }

    /// A motion of a cycle, converted from its frame.
    pub(super) fn stroke(&mut self, stroke: Stroke, frame: PassFrame, span: TextSpan) {
        let to = LathePlace::from(point(frame.out(stroke.end())));
        let same = |a: Option<f64>, b: Option<f64>| a.zip(b).is_some_and(|(a, b)| (a - b).abs() < SAME);
        let here = self.state.at;
        let stands = same(here.radius_mm, to.radius_mm) && same(here.z_mm, to.z_mm);
        let act = match (stroke, self.state.feed()) {
            _ if stands => return,
            (Stroke::Rapid(_), _) => LatheAct::Rapid,
            (_, None) => {
                if !self.broken() {
                    self.report("feed-zero", span);
                }
                return;
            }
            (Stroke::Line(_), Some(feed)) => LatheAct::Feed { feed },
            (Stroke::Arc(round, _), Some(feed)) => {
                let centre = point(frame.out(round.centre));
                LatheAct::Arc { feed, centre, sense: sense(frame.sense(round.ccw)) }
            }
        };
        self.push_motion(act, to);
    }

    /// One pass along a contour, its first element at rapid.
    pub(super) fn along(&mut self, legs: &[Leg], span: TextSpan) {
        for (index, leg) in legs.iter().enumerate() {
            let stroke = match leg.round {
                _ if index == 0 => Stroke::Rapid(leg.to),
                None => Stroke::Line(leg.to),
                Some(round) => Stroke::Arc(round, leg.to),
            };
            self.stroke(stroke, PassFrame::default(), span);
        }
    }

    /// The first block of G71 and G72 of Fanuc: depth and retract.
    pub(super) fn first_block(&mut self, words: &BlockWords, does: WordEffect, span: TextSpan) {
        if !self.fields(words, name(does), Form::First, span) {
            return;
        }
        let depth = words.take(if does == WordEffect::RoughAlong { "U" } else { "W" }).cloned();
        let depth = self.above_zero(depth, 0.0, span);
        let retract = self.above_zero(words.take("R").cloned(), 0.0, span);
        let kept =
            if does == WordEffect::RoughAlong { &mut self.state.first.along } else { &mut self.state.first.across };
        *kept = Some((depth, retract));
    }

    /// The second block of G71 and G72 of Fanuc, and G70.
    pub(super) fn fanuc_cycle(
        &mut self,
        words: &BlockWords,
        does: WordEffect,
        span: TextSpan,
        begin: LathePoint,
        legs: Vec<Leg>,
        type_two: bool,
    ) {
        self.before_moving(span, true);
        if legs.len() < 2 {
            self.report("lathe-contour-short", span);
            return;
        }
        if does == WordEffect::Finish {
            self.finish(&legs, begin, span);
            return;
        }
        let across = does == WordEffect::RoughAcross;
        let Some((depth, retract)) = (if across { self.state.first.across } else { self.state.first.along }) else {
            self.report_with("lathe-cycle-first-block", span, "word", name(does));
            return;
        };
        let allowance = PassPoint {
            x: words.take("U").map_or(0.0, |value| value.value) / 2.0,
            z: words.take("W").map_or(0.0, |it| it.value),
        };
        let shift = |point: PassPoint| PassPoint { z: point.z + allowance.z, x: point.x + allowance.x };
        // The rough contour is the finished one, moved by both allowances; so is the start of the passes.
        let moved: Vec<Leg> = legs
            .iter()
            .map(|leg| {
                let round = leg.round.map(|it| super::contour::Round { centre: shift(it.centre), ..it });
                Leg { from: shift(leg.from), to: shift(leg.to), round, ..*leg }
            })
            .collect();
        let (Some(first), Some(last)) = (moved.first().copied(), moved.last().copied()) else { return };
        let frame = PassFrame::of(first.to, last.to, across);
        let framed: Vec<Leg> = moved.iter().map(|leg| frame.leg(*leg)).collect();
        if first.round.is_some() {
            self.report_with("lathe-not-monotone", span, "line", first.line);
            return;
        }
        let rises = |leg: &&Leg| leg.is_monotone() && leg.to.x >= leg.from.x - SAME;
        let wrong = framed.iter().skip(1).find(|leg| if type_two { !leg.is_monotone() } else { !rises(leg) });
        if let Some(leg) = wrong {
            self.report_with("lathe-not-monotone", span, "line", leg.line);
            return;
        }
        let start = frame.into(shift(spot(begin)));
        let top = framed.iter().skip(1).map(|leg| leg.to.x).fold(f64::NEG_INFINITY, f64::max);
        let lowest = framed.iter().map(|leg| leg.to.x).fold(f64::INFINITY, f64::min);
        if start.x < top - SAME {
            let problem = super::rules::fault("lathe-cycle-begins-inside", span, self.number);
            self.faults.push(problem.with("by", shown(top - start.x)));
            return;
        }
        let passes = Passes { depth, retract, budget: self.budget };
        self.report_with("lathe-cycle-from-memory", span, "word", name(does));
        if type_two {
            self.rough(&moved, across, (depth, retract), span);
        } else {
            self.stroke(Stroke::Rapid(start), frame, span);
            let between = Between { down_at_rapid: first.rapid, along_contour: false };
            // A contour that ends below the start ends every pass above it at its last Z, as a wall would.
            let mut legs = framed.get(1..).unwrap_or_default().to_vec();
            if let Some(last) = legs.last().copied().filter(|last| last.to.x < start.x - SAME) {
                legs.push(Leg { from: last.to, to: PassPoint { x: start.x, ..last.to }, round: None, ..last });
            }
            let made = levels(start, &legs, lowest, passes, between);
            self.strokes(made, frame, span);
        }
        // One pass along the rough contour, then back to the start of the cycle.
        if let Some(first) = framed.first() {
            let back = PassPoint { z: start.z, x: start.x.max(first.to.x) };
            let here = self.state.at.point().map(|at| frame.into(spot(at)));
            if let Some(here) = here.filter(|here| here.z < start.z) {
                self.stroke(Stroke::Rapid(PassPoint { z: here.z, x: back.x.max(here.x) }), frame, span);
            }
            self.stroke(Stroke::Rapid(back), frame, span);
            let down = if first.rapid { Stroke::Rapid(first.to) } else { Stroke::Line(first.to) };
            self.stroke(down, frame, span);
            for leg in framed.iter().skip(1) {
                self.stroke(leg.round.map_or(Stroke::Line(leg.to), |round| Stroke::Arc(round, leg.to)), frame, span);
            }
        }
        self.stroke(Stroke::Rapid(spot(begin)), PassFrame::default(), span);
    }

    /// G70 of Fanuc: one pass along the contour with its own feeds, then back to the start.
    fn finish(&mut self, legs: &[Leg], begin: LathePoint, span: TextSpan) {
        self.report_with("lathe-cycle-from-memory", span, "word", "G70");
        let kept = self.state.feed;
        for leg in legs {
            if leg.feed.is_some() {
                self.state.feed = leg.feed;
            }
            let stroke = match leg.round {
                _ if leg.rapid => Stroke::Rapid(leg.to),
                None => Stroke::Line(leg.to),
                Some(round) => Stroke::Arc(round, leg.to),
            };
            self.stroke(stroke, PassFrame::default(), span);
        }
        self.state.feed = kept;
        self.stroke(Stroke::Rapid(spot(begin)), PassFrame::default(), span);
    }
}
