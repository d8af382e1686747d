//! Cycles of Sinumerik: CYCLE95 and CYCLE97. Their fields are in the table lathe-read-cycles; their effect is known
//! only from memory of the manual, and reported so.

use super::block::Maker;
use super::contour::{Leg, PassFrame, PassPoint, Round, SAME, Stroke};
use super::motion::{LathePlace, LathePoint};
use super::roughing::{Between, Passes, hollows, levels};
use super::text::Argument;
use crate::program::TextSpan;
use crate::tables::controls::lathe_reading::Form;

/// The arguments of a call by their names.
pub(super) struct Fields {
    names: Vec<String>,
    values: Vec<Option<f64>>,
}

impl Fields {
    pub fn get(&self, name: &str) -> Option<f64> {
        let index = self.names.iter().position(|known| known == name)?;
        self.values.get(index).copied().flatten()
    }

    pub fn or_zero(&self, name: &str) -> f64 {
        self.get(name).unwrap_or_default()
    }
}

impl Maker<'_> {
    /// The arguments of a call, checked against the table.
    pub(super) fn call_fields(&mut self, cycle: &str, arguments: &[Argument], span: TextSpan) -> Option<Fields> {
        let known = self.language.cycle(cycle, Form::One);
        if arguments.len() > known.all.len() {
            self.report_with("lathe-cycle-fields-too-many", span, "most", known.all.len());
            return None;
        }
        let mut values = Vec::new();
        for argument in arguments {
            values.push(match argument {
                Argument::Number(expression) => {
                    let value = expression.value(&self.state.parameters);
                    if value.is_none() {
                        self.report_with("lathe-parameter-unknown", span, "word", cycle.to_owned());
                    }
                    value
                }
                Argument::Text(_) => Some(0.0),
                Argument::Nothing => None,
            });
        }
        let fields = Fields { names: known.all, values };
        let missing: Vec<String> = known.required.into_iter().filter(|name| fields.get(name).is_none()).collect();
        if !missing.is_empty() {
            self.report_with("lathe-cycle-field", span, "field", missing.join(", "));
            return None;
        }
        (!self.broken()).then_some(fields)
    }

    /// CYCLE95(NPP, MID, FALZ, FALX, FAL, FF1, FF2, FF3, VARI, DT, DAM, _VRT).
    pub(super) fn cycle95(&mut self, arguments: &[Argument], span: TextSpan, legs: Vec<Leg>) {
        self.before_moving(span, true);
        let Some(fields) = self.call_fields("CYCLE95", arguments, span) else { return };
        let variant = fields.or_zero("VARI") as i64;
        let (kind, hundreds) = (variant % 100, variant / 100);
        let depth = fields.or_zero("MID");
        let wrong = [
            ("VARI", !(1..=12).contains(&kind) || !(0..=2).contains(&hundreds)),
            ("MID", depth <= 0.0 && kind != 5 && kind != 6 && kind != 7 && kind != 8),
            ("FF1", fields.or_zero("FF1") <= 0.0),
            ("FF3", kind > 4 && fields.or_zero("FF3") <= 0.0),
            ("FAL", fields.or_zero("FAL") != 0.0),
            ("DAM", fields.or_zero("DAM") != 0.0),
        ];
        if let Some((field, _)) = wrong.iter().find(|(_, wrong)| *wrong) {
            self.report_with("lathe-cycle-value", span, "field", *field);
            return;
        }
        let (Some(first), Some(last)) = (legs.first().copied(), legs.last().copied()) else {
            self.report("lathe-contour-short", span);
            return;
        };
        self.report_with("lathe-cycle-from-memory", span, "word", "CYCLE95");
        let (across, inside) = (kind % 2 == 0, (kind - 1) % 4 >= 2);
        // The cycle works towards the chuck, across towards the axis (inside away from it), whatever the direction of
        // the contour.
        let backwards = match (across, inside) {
            (false, _) => last.to.z > first.from.z,
            (true, false) => last.to.x > first.from.x,
            (true, true) => last.to.x < first.from.x,
        };
        let legs = if backwards { reversed(&legs) } else { legs };
        let out = if inside { -1.0 } else { 1.0 };
        let allowance = PassPoint { z: fields.or_zero("FALZ"), x: out * fields.or_zero("FALX") };
        let clear = fields.get("_VRT").filter(|clear| *clear > 0.0).unwrap_or(1.0);
        let kept = self.state.feed;
        if !(5..=8).contains(&kind) {
            self.state.feed = fields.get("FF1");
            self.rough95(&moved(&legs, allowance), across, (depth, clear), hundreds != 2, span);
        }
        if kind > 4 {
            self.state.feed = fields.get("FF3");
            self.finish95(&legs, across, clear, span);
        }
        self.state.feed = kept;
    }

    fn rough95(&mut self, legs: &[Leg], across: bool, (depth, clear): (f64, f64), clean: bool, span: TextSpan) {
        let (Some(first), Some(last)) = (legs.first(), legs.last()) else { return };
        let frame = PassFrame::of(first.from, last.to, across);
        let framed: Vec<Leg> = legs.iter().map(|leg| frame.leg(*leg)).collect();
        if let Some(leg) = framed.iter().find(|leg| !leg.is_monotone()) {
            self.report_with("lathe-not-monotone", span, "line", leg.line);
            return;
        }
        let top = framed.iter().map(|leg| leg.from.x.max(leg.to.x)).fold(f64::NEG_INFINITY, f64::max);
        let lowest = framed.iter().map(|leg| leg.from.x.min(leg.to.x)).fold(f64::INFINITY, f64::min);
        let Some(begin) = framed.first().map(|leg| PassPoint { z: leg.from.z + clear, x: top }) else { return };
        // Passes of equal depth, none deeper than the given one.
        let count = libm::ceil(((top - lowest) / depth - SAME).max(1.0));
        let passes = Passes { depth: (top - lowest) / count, retract: clear, budget: self.budget };
        self.stroke(Stroke::Rapid(PassPoint { x: top + clear, ..begin }), frame, span);
        let rises = framed.iter().all(|leg| leg.to.x >= leg.from.x - SAME);
        let made = if rises {
            levels(
                begin,
                &framed,
                lowest - passes.depth / 2.0,
                passes,
                Between { down_at_rapid: true, along_contour: clean },
            )
        } else {
            let down = framed.first().map(|leg| Leg { from: begin, to: leg.from, round: None, ..*leg });
            let all: Vec<Leg> = down.into_iter().chain(framed.iter().copied()).collect();
            hollows(&all, passes)
        };
        self.strokes(made, frame, span);
    }

    fn finish95(&mut self, legs: &[Leg], across: bool, clear: f64, span: TextSpan) {
        let (Some(first), Some(last)) = (legs.first(), legs.last()) else { return };
        let frame = PassFrame::of(first.from, last.to, across);
        let framed: Vec<Leg> = legs.iter().map(|leg| frame.leg(*leg)).collect();
        let top = framed.iter().map(|leg| leg.from.x.max(leg.to.x)).fold(f64::NEG_INFINITY, f64::max);
        let Some(begin) = framed.first().map(|leg| leg.from) else { return };
        self.stroke(Stroke::Rapid(PassPoint { z: begin.z + clear, x: top + clear }), frame, span);
        self.stroke(Stroke::Rapid(PassPoint { z: begin.z + clear, x: begin.x }), frame, span);
        self.stroke(Stroke::Line(begin), frame, span);
        for leg in &framed {
            self.stroke(leg.round.map_or(Stroke::Line(leg.to), |round| Stroke::Arc(round, leg.to)), frame, span);
        }
        if let Some(end) = framed.last().map(|leg| leg.to) {
            self.stroke(Stroke::Rapid(PassPoint { z: end.z + clear, x: end.x + clear }), frame, span);
            self.stroke(Stroke::Rapid(PassPoint { z: begin.z + clear, x: end.x + clear }), frame, span);
        }
    }

    /// CYCLE97(PIT, MPIT, SPL, FPL, DM1, DM2, APP, ROP, TDEP, FAL, IANG, NSP, NRC, NID, VARI, NUMT, _VRT).
    pub(super) fn cycle97(&mut self, arguments: &[Argument], span: TextSpan) {
        self.before_moving(span, true);
        let Some(fields) = self.call_fields("CYCLE97", arguments, span) else { return };
        let variant = fields.or_zero("VARI") as i64;
        let (lead, depth, passes) = (fields.or_zero("PIT"), fields.or_zero("TDEP"), fields.or_zero("NRC"));
        let wrong = [
            ("PIT", lead <= 0.0),
            ("TDEP", depth <= 0.0),
            ("FAL", fields.or_zero("FAL") < 0.0 || fields.or_zero("FAL") >= depth),
            ("NRC", !(1.0..=1000.0).contains(&passes)),
            ("NID", !(0.0..=1000.0).contains(&fields.or_zero("NID"))),
            ("VARI", !(1..=4).contains(&variant)),
            ("NUMT", fields.or_zero("NUMT") > 1.0),
            ("SPL", (fields.or_zero("SPL") - fields.or_zero("FPL")).abs() < SAME),
        ];
        if let Some((field, _)) = wrong.iter().find(|(_, wrong)| *wrong) {
            self.report_with("lathe-cycle-value", span, "field", *field);
            return;
        }
        self.report_with("lathe-cycle-from-memory", span, "word", "CYCLE97");
        let (inside, area) = (variant % 2 == 0, variant > 2);
        let out = if inside { -1.0 } else { 1.0 };
        let (begin, end) = (fields.or_zero("SPL"), fields.or_zero("FPL"));
        let direction = if end < begin { -1.0 } else { 1.0 };
        let (from, to) = (begin - direction * fields.or_zero("APP"), end + direction * fields.or_zero("ROP"));
        let (r1, r2) = (fields.or_zero("DM1") / 2.0, fields.or_zero("DM2") / 2.0);
        // The crest continues over the run-in and the run-out with its slope.
        let crest = |z: f64| r1 + (r2 - r1) * (z - begin) / (end - begin);
        let clear = fields.get("_VRT").filter(|clear| *clear > 0.0).unwrap_or(1.0);
        let high = if inside { r1.min(r2) } else { r1.max(r2) } + out * clear;
        let rough = depth - fields.or_zero("FAL");
        let count = passes as usize;
        let mut depths: Vec<f64> = (1..=count)
            .map(|pass| {
                let share = pass as f64 / count as f64;
                rough * if area { libm::sqrt(share) } else { share }
            })
            .collect();
        if fields.or_zero("FAL") > 0.0 {
            depths.push(depth);
        }
        depths.extend(std::iter::repeat_n(depth, fields.or_zero("NID") as usize));
        let angle = fields.or_zero("IANG");
        let slope = libm::tan(angle.abs().to_radians());
        for (pass, depth) in depths.into_iter().enumerate() {
            // Along one flank or, with a minus, along both in turn.
            let side = if angle < 0.0 && pass % 2 == 1 { -1.0 } else { 1.0 };
            let begin_z = from + direction * side * depth * slope;
            let place = |radius_mm: f64, z_mm: f64| LathePoint { radius_mm, z_mm };
            let a = place(crest(from) - out * depth, begin_z);
            let b = place(crest(to) - out * depth, to);
            for to in [place(high, begin_z), a] {
                self.stroke(Stroke::Rapid(PassPoint { z: to.z_mm, x: to.radius_mm }), PassFrame::default(), span);
            }
            self.thread_to(a, b, (lead, 0.0), span);
            self.stroke(Stroke::Rapid(PassPoint { z: to, x: high }), PassFrame::default(), span);
        }
        self.stroke(Stroke::Rapid(PassPoint { z: from, x: high }), PassFrame::default(), span);
        debug_assert!(self.state.at != LathePlace::default());
    }
}

/// A contour with both allowances.
fn moved(legs: &[Leg], by: PassPoint) -> Vec<Leg> {
    let shift = |point: PassPoint| PassPoint { z: point.z + by.z, x: point.x + by.x };
    let moved = |leg: &Leg| {
        let round = leg.round.map(|it| Round { centre: shift(it.centre), ..it });
        Leg { from: shift(leg.from), to: shift(leg.to), round, ..*leg }
    };
    legs.iter().map(moved).collect()
}

/// A contour in the opposite direction.
fn reversed(legs: &[Leg]) -> Vec<Leg> {
    let turned = |leg: &Leg| {
        let round = leg.round.map(|it| Round { ccw: !it.ccw, ..it });
        Leg { from: leg.to, to: leg.from, round, ..*leg }
    };
    legs.iter().rev().map(turned).collect()
}
