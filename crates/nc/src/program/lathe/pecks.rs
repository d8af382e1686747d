//! G74 and G75 of Fanuc: grooves and holes that are cut step by step, beside each other. The first block has the way back after each
//! step; the second goes to X and Z, with the steps P across and Q along, in thousandths of a millimetre, P on the radius.
//! After the last step of each plunge the tool goes back to where the cycle began, then on to the next plunge. That a plunge ends
//! exactly at its depth and the last one exactly at the end is from memory.

use super::block::{Maker, spot};
use super::contour::{PassFrame, PassPoint, SAME, Stroke};
use super::words::BlockWords;
use crate::program::TextSpan;
use crate::tables::controls::lathe_reading::{Form, WordEffect};

/// The most steps of a cycle.
const MOST: usize = 10_000;

impl Maker<'_> {
    /// G74, or across G75.
    pub(super) fn pecks(&mut self, words: &BlockWords, across: bool, span: TextSpan) {
        let name = if across { "G75" } else { "G74" };
        let to_somewhere = ["X", "U", "Z", "W"].iter().any(|name| words.look(name).is_some());
        if !to_somewhere {
            if self.fields(words, name, Form::First, span) {
                let back = words.take("R").map_or(0.0, |value| value.value);
                self.state.first.back = Some(back.max(0.0));
            }
            return;
        }
        self.before_moving(span, true);
        // The older form of one block has I, K and D; what R does at the bottom is not certain.
        let shifted = words.look("R").is_some_and(|value| value.value != 0.0);
        if shifted || ["I", "K", "D"].iter().any(|name| words.look(name).is_some()) {
            words.take_all();
            self.report_with("lathe-not-carried-out", span, "word", name);
            return;
        }
        if !self.fields(words, name, Form::Second, span) {
            return;
        }
        words.take("R");
        let Some(back) = self.state.first.back else {
            self.report_with("lathe-cycle-first-block", span, "word", name);
            return;
        };
        let [p, q] = ["P", "Q"].map(|name| words.take(name).cloned());
        let [p, q] = [p, q].map(|step| step.map(|step| self.thousandths(Some(step))).filter(|step| *step > 0.0));
        let Some(shape) = self.shape(words, WordEffect::Line, span) else { return };
        let (Some(from), Some(to)) = (self.state.at.point(), shape.to.point()) else {
            self.report("lathe-place-unknown", span);
            return;
        };
        self.report_with("lathe-cycle-from-memory", span, "word", name);
        // Depth along x of the frame, from plunge to plunge along z.
        let turned = PassFrame { across: !across, ..PassFrame::default() };
        let (from, to) = (turned.into(spot(from)), turned.into(spot(to)));
        let (depths, places) = if across { (p, q) } else { (q, p) };
        let depths = steps(from.x, to.x, depths);
        let places = std::iter::once(from.z).chain(steps(from.z, to.z, places)).collect::<Vec<_>>();
        if depths.len().saturating_mul(places.len()) > MOST.min(self.budget) {
            self.report_with("run-too-long", span, "budget", MOST);
            return;
        }
        let out = if to.x < from.x { 1.0 } else { -1.0 };
        for z in places {
            self.stroke(Stroke::Rapid(PassPoint { z, x: from.x }), turned, span);
            for (index, x) in depths.iter().enumerate() {
                self.stroke(Stroke::Line(PassPoint { z, x: *x }), turned, span);
                if index + 1 < depths.len() {
                    self.stroke(Stroke::Rapid(PassPoint { z, x: x + out * back }), turned, span);
                }
            }
            self.stroke(Stroke::Rapid(PassPoint { z, x: from.x }), turned, span);
        }
        self.stroke(Stroke::Rapid(from), turned, span);
    }
}

/// The places from one to another by steps, the last one exactly there; only that where there is no step, none where it is the same.
fn steps(from: f64, to: f64, step: Option<f64>) -> Vec<f64> {
    let far = (to - from).abs();
    if far < SAME {
        return Vec::new();
    }
    let count = step.map_or(1.0, |step| (far / step - SAME).ceil().max(1.0)).min(1e6) as usize;
    let step = step.unwrap_or(far) * (to - from).signum();
    (1..=count).map(|index| if index == count { to } else { from + step * index as f64 }).collect()
}
