//! Tapping on the axis: G33.1 of LinuxCNC, G84 of Fanuc, CYCLE84 of Sinumerik. The tap goes in in step with the spindle, the spindle
//! reverses, and the tap comes back. How far the spindle runs on at the end is not known.

use super::LatheReader;
use super::block::Maker;
use super::motion::{LatheAct, LathePlace, LathePoint};
use super::text::Argument;
use super::words::BlockWords;
use crate::motion::Turning;
use crate::program::TextSpan;
use crate::tables::controls::lathe_reading::{Form, WordEffect};

impl Maker<'_> {
    /// G33.1 or G84: from where the tool stands to Z and back.
    pub(super) fn tap(&mut self, words: &BlockWords, span: TextSpan) {
        let fanuc = self.is(LatheReader::Fanuc);
        if fanuc && !self.fields(words, "G84", Form::One, span) {
            return;
        }
        if fanuc {
            self.report_with("lathe-cycle-from-memory", span, "word", "G84");
            // The return level is where the cycle begins; another one and repeated holes are not read.
            for (name, read) in [("R", 0.0), ("K", 1.0)] {
                if words.take(name).is_some_and(|given| given.value != read) {
                    self.report_with("lathe-cycle-value", span, "field", name);
                }
            }
            words.take("P");
        }
        let lead = words.take(if fanuc { "F" } else { "K" }).map(|value| value.value);
        let Some(lead) = lead.filter(|lead| *lead > 0.0) else {
            self.report("lathe-no-lead", span);
            return;
        };
        let Some(shape) = self.shape(words, WordEffect::Tap, span) else { return };
        let (Some(from), Some(to)) = (self.state.at.point(), shape.to.point()) else {
            self.report("lathe-place-unknown", span);
            return;
        };
        if !self.broken() {
            self.in_and_out(from, to, lead, span);
        }
    }

    /// A cycle that starts the spindle itself, where its speed is known.
    pub(super) fn starts_spindle(&mut self) {
        if self.state.turning == Turning::Stopped && self.state.speed.is_some_and(|speed| speed > 0.0) {
            self.state.turning = Turning::Clockwise;
        }
    }

    /// CYCLE84(RTP, RFP, SDIS, DP, DPR, DTB, SDAC, MPIT, PIT, POSS, SST, SST1, _AXN).
    pub(super) fn cycle84(&mut self, arguments: &[Argument], span: TextSpan) {
        let Some(fields) = self.call_fields("CYCLE84", arguments, span) else { return };
        let speed = fields.or_zero("SST");
        self.state.speed = Some(speed);
        self.starts_spindle();
        self.before_moving(span, true);
        let (retract, reference) = (fields.or_zero("RTP"), fields.or_zero("RFP"));
        let depth = fields.get("DP").or_else(|| Some(reference - fields.get("DPR")?));
        // MPIT names a metric thread by its size, whose pitch is not looked up here.
        let lead = fields.or_zero("PIT");
        let after = match fields.or_zero("SDAC") as i64 {
            3 => Some(Turning::Clockwise),
            4 => Some(Turning::Counterclockwise),
            5 => Some(Turning::Stopped),
            _ => None,
        };
        let wrong = [
            ("DP", depth.is_none_or(|depth| depth >= reference)),
            ("PIT", lead <= 0.0 || fields.get("MPIT").is_some()),
            ("SDAC", after.is_none()),
            ("SST", speed <= 0.0),
            ("SDIS", fields.or_zero("SDIS") < 0.0),
            // The first axis of the plane G18 is Z.
            ("_AXN", fields.get("_AXN") != Some(1.0)),
        ];
        if let Some((field, _)) = wrong.iter().find(|(_, wrong)| *wrong) {
            self.report_with("lathe-cycle-value", span, "field", *field);
            return;
        }
        let (Some(depth), Some(after)) = (depth, after) else { return };
        self.report_with("lathe-cycle-from-memory", span, "word", "CYCLE84");
        let Some(here) = self.state.at.point() else {
            self.report("lathe-place-unknown", span);
            return;
        };
        let at = |z_mm: f64| LathePoint { z_mm, ..here };
        let begin = at(reference + fields.or_zero("SDIS"));
        self.rapid_to(begin);
        self.in_and_out(begin, at(depth), lead, span);
        self.state.turning = after;
        self.rapid_to(at(retract));
    }

    fn rapid_to(&mut self, to: LathePoint) {
        if self.state.at != LathePlace::from(to) {
            self.push_motion(LatheAct::Rapid, to.into());
        }
    }

    /// In, and back with the spindle reversed.
    fn in_and_out(&mut self, from: LathePoint, to: LathePoint, lead: f64, span: TextSpan) {
        if self.state.turning == Turning::Counterclockwise {
            self.report("lathe-tap-counterclockwise", span);
            return;
        }
        let (of_cycle, turning) = (self.of_cycle, self.state.turning);
        self.of_cycle = true;
        self.thread_to(from, to, (lead, 0.0), span);
        self.state.turning = Turning::Counterclockwise;
        self.thread_to(to, from, (lead, 0.0), span);
        (self.of_cycle, self.state.turning) = (of_cycle, turning);
    }
}
