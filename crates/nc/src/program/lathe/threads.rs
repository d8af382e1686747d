//! Cycles that cut threads: G76 of LinuxCNC and of Fanuc, G92 of Fanuc.

use super::LatheReader;
use super::block::{Maker, spot};
use super::motion::{LatheAct, LathePlace, LathePoint};
use super::words::{BlockWords, Value};
use crate::program::TextSpan;
use crate::tables::controls::lathe_reading::{Form, WordEffect};
use crate::units::MillimetresPerRev;

/// The most passes of a thread.
const MOST_PASSES: usize = 2000;

/// The run-in and run-out of a LinuxCNC thread.
#[derive(Clone, Copy)]
struct Tapers {
    length: f64,
    entry: bool,
    exit: bool,
}

fn at(radius_mm: f64, z_mm: f64) -> LathePlace {
    LathePoint { radius_mm, z_mm }.into()
}

impl Maker<'_> {
    /// G76.
    pub(super) fn thread_cycle(&mut self, words: &BlockWords, span: TextSpan) {
        match self.language.kind {
            LatheReader::Fanuc if words.look("F").is_none() => self.first_of_thread(words, span),
            // The older form of one block.
            LatheReader::Fanuc if words.look("K").is_some() || words.look("D").is_some() => {
                words.take_all();
                self.report_with("lathe-not-carried-out", span, "word", "G76");
            }
            LatheReader::Fanuc => self.fanuc_thread(words, span),
            _ => self.linuxcnc_thread(words, span),
        }
    }

    /// G76 of LinuxCNC: passes of depth J·n^(1/R) up to K below the crest, which is offset by I from the drive line;
    /// a whole pass is shifted by the remaining depth, so that the last one begins on the drive line. Observed in
    /// rs274.
    fn linuxcnc_thread(&mut self, words: &BlockWords, span: TextSpan) {
        self.before_moving(span, true);
        self.thread_at(span);
        if !self.fields(words, "G76", Form::One, span) {
            return;
        }
        let scale = if self.diameters() { 0.5 } else { 1.0 };
        let number = |name: &str| words.take(name).cloned();
        let lead = self.above_zero(number("P"), 0.0, span);
        let first = self.above_zero(number("J"), 0.0, span) * scale;
        let full = self.above_zero(number("K"), 0.0, span) * scale;
        let crest = number("I").map_or(0.0, |value| value.value) * scale;
        let end = number("Z").map_or(0.0, |it| it.value);
        let power = number("R").map_or(1.0, |it| it.value).max(1.0);
        let angle = number("Q").map_or(0.0, |it| it.value);
        let springs = number("H").map_or(0.0, |it| it.value).clamp(0.0, 1000.0) as usize;
        let length = number("E").map_or(0.0, |it| it.value);
        let which = number("L").map_or(0.0, |it| it.value);
        let tapers = Tapers { length, entry: which == 1.0 || which == 3.0, exit: which == 2.0 || which == 3.0 };
        let Some(drive) = self.state.at.point() else {
            self.report("lathe-place-unknown", span);
            return;
        };
        if self.broken() {
            return;
        }
        if crest == 0.0 || first > full || !(0.0..90.0).contains(&angle) {
            let field = if crest == 0.0 {
                "I"
            } else if first > full {
                "J"
            } else {
                "Q"
            };
            self.report_with("lathe-cycle-value", span, "field", field);
            return;
        }
        let slope = libm::tan(angle.to_radians());
        let mut depths: Vec<f64> = (1..=MOST_PASSES)
            .map(|pass| first * libm::pow(pass as f64, 1.0 / power))
            .take_while(|depth| *depth < full)
            .collect();
        if depths.len() == MOST_PASSES {
            self.report_with("run-too-long", span, "budget", MOST_PASSES);
            return;
        }
        depths.extend(std::iter::repeat_n(full, springs + 1));
        let lead_of_taper = lead * libm::hypot(length, full) / length.max(f64::MIN_POSITIVE);
        // Away from the thread: up outside, down inside.
        let out = if crest < 0.0 { 1.0 } else { -1.0 };
        for depth in depths {
            let safe = drive.radius_mm + out * (full - depth);
            let cut = drive.radius_mm + crest - out * depth;
            let (from, to) = (drive.z_mm - depth * slope, end + (full - depth) * slope);
            self.rapid(at(safe, from));
            let thread = |lead: f64| LatheAct::Thread { lead: MillimetresPerRev(lead), start_deg: 0.0 };
            if tapers.entry {
                self.push_motion(thread(lead_of_taper), at(cut + out * full, from));
                self.push_motion(thread(lead_of_taper), at(cut, from - tapers.length));
            } else {
                self.rapid(at(cut, from));
            }
            if tapers.exit {
                self.push_motion(thread(lead), at(cut, to + tapers.length));
                self.push_motion(thread(lead_of_taper), at(cut + out * full, to));
            } else {
                self.push_motion(thread(lead), at(cut, to));
            }
            self.rapid(at(safe, to));
        }
        self.rapid(at(drive.radius_mm, end));
    }

    /// A rapid, if it moves.
    fn rapid(&mut self, to: LathePlace) {
        if self.state.at != to {
            self.push_motion(LatheAct::Rapid, to);
        }
    }

    /// The first block of G76 of Fanuc.
    fn first_of_thread(&mut self, words: &BlockWords, span: TextSpan) {
        if !self.fields(words, "G76", Form::First, span) {
            return;
        }
        let code = words.take("P").map_or(0.0, |value| value.value);
        let least = self.thousandths(words.take("Q").cloned());
        let allowance = words.take("R").cloned().map_or(0.0, |it| self.millimetres(&it));
        let whole = code.clamp(0.0, 999_999.0) as u32;
        let (passes, run_out, angle) = (whole / 10_000, whole / 100 % 100, whole % 100);
        if ![80, 60, 55, 30, 29, 0].contains(&angle) || passes == 0 {
            self.report_with("lathe-cycle-value", span, "field", "P");
        }
        let values = [f64::from(passes), f64::from(run_out) / 10.0, f64::from(angle), least, allowance];
        self.state.first.thread = Some(values);
    }

    /// P and Q of G76: thousandths of a millimetre, which have no point.
    pub(super) fn thousandths(&mut self, given: Option<Value>) -> f64 {
        let Some(given) = given else { return 0.0 };
        if given.point {
            self.report_with("number-not-whole", given.span, "address", given.name.clone());
        }
        given.value / 1000.0
    }

    /// R of the first block: thousandths without a point, millimetres with one.
    fn millimetres(&self, given: &Value) -> f64 {
        if given.point { given.value } else { given.value / 1000.0 }
    }

    /// The second block of G76 of Fanuc: passes of depth d·√n, none less than the minimum, down to the finishing
    /// allowance, then the finishing passes at full depth. From memory of the manual.
    fn fanuc_thread(&mut self, words: &BlockWords, span: TextSpan) {
        self.before_moving(span, true);
        let Some([finishes, run_out, angle, least, allowance]) = self.state.first.thread else {
            self.report_with("lathe-cycle-first-block", span, "word", "G76");
            return;
        };
        if !self.fields(words, "G76", Form::Second, span) {
            return;
        }
        let lead = self.above_zero(words.take("F").cloned(), 0.0, span);
        let height = self.thousandths(words.take("P").cloned());
        let first = self.thousandths(words.take("Q").cloned());
        let taper = words.take("R").cloned().map_or(0.0, |value| self.millimetres(&value));
        let Some((begin, end)) = self.ends_of_thread(words, None, span) else { return };
        if height <= 0.0 || first <= 0.0 || allowance >= height {
            self.report_with("lathe-cycle-value", span, "field", if first <= 0.0 { "Q" } else { "P" });
            return;
        }
        if self.broken() {
            return;
        }
        self.report_with("lathe-cycle-from-memory", span, "word", "G76");
        let (mut depths, mut depth) = (Vec::new(), 0.0_f64);
        for pass in 1..=MOST_PASSES {
            let next = (first * libm::sqrt(pass as f64)).max(depth + least);
            if next >= height - allowance {
                break;
            }
            depth = next;
            depths.push(depth);
        }
        depths.push(height - allowance);
        depths.extend(std::iter::repeat_n(
            height,
            if allowance > 0.0 { finishes as usize } else { finishes as usize - 1 },
        ));
        let slope = libm::tan((angle / 2.0).to_radians());
        let direction = if end.z_mm < begin.z_mm { -1.0 } else { 1.0 };
        for depth in depths {
            // The root is the target of the block; each pass is above it by the remaining depth.
            let z = begin.z_mm + direction * depth * slope;
            self.rapid(at(begin.radius_mm, z));
            self.thread_pass(begin, z, (end, taper), height - depth, (lead, run_out, 0.0), span);
        }
        self.rapid(begin.into());
    }

    /// X or U, Z or W of a thread: its start and end.
    ///
    /// `kept` is the end of the block before, and whether this one gives X and Z again.
    fn ends_of_thread(
        &mut self,
        words: &BlockWords,
        kept: Option<(LathePoint, bool, bool)>,
        span: TextSpan,
    ) -> Option<(LathePoint, LathePoint)> {
        let Some(begin) = self.state.at.point() else {
            self.report("lathe-place-unknown", span);
            return None;
        };
        let mut end = self.shape(words, WordEffect::Rapid, span)?.to.point()?;
        if let Some((kept, x, z)) = kept {
            end.radius_mm = if x { end.radius_mm } else { kept.radius_mm };
            end.z_mm = if z { end.z_mm } else { kept.z_mm };
        }
        if spot(begin).to(spot(end)) < 1e-9 || (begin.radius_mm - end.radius_mm).abs() < 1e-9 {
            self.report_with("lathe-cycle-value", span, "field", "X");
            return None;
        }
        Some((begin, end))
    }

    /// Infeed, the thread with its run-out at 45°, retract, and back to the start of the cycle.
    fn thread_pass(
        &mut self,
        begin: LathePoint,
        from_z: f64,
        (end, taper): (LathePoint, f64),
        above: f64,
        (lead, run_out, start): (f64, f64, f64),
        span: TextSpan,
    ) {
        let out = if begin.radius_mm > end.radius_mm { 1.0 } else { -1.0 };
        let root = end.radius_mm + out * above;
        let back = run_out * lead * if end.z_mm < begin.z_mm { 1.0 } else { -1.0 };
        self.rapid(at(root + taper, from_z));
        let from = LathePoint { radius_mm: root + taper, z_mm: from_z };
        let straight = LathePoint { radius_mm: root, z_mm: end.z_mm + back };
        self.thread_to(from, straight, (lead, start), span);
        if back != 0.0 {
            let over = LathePoint { radius_mm: root + out * back.abs(), z_mm: end.z_mm };
            self.thread_to(straight, over, (lead, start), span);
        }
        self.rapid(at(begin.radius_mm, end.z_mm));
        self.rapid(begin.into());
    }

    /// Begin and end of a pass of G90, G92 or G94, `in_block` where its function stands; else X, Z and R that the block does not
    /// give are those of the block before.
    fn box_ends(&mut self, words: &BlockWords, in_block: bool, span: TextSpan) -> Option<(LathePoint, LathePoint)> {
        match words.take("R") {
            Some(taper) => self.state.box_taper = taper.value,
            None if in_block => self.state.box_taper = 0.0,
            None => {}
        }
        let given = |a: &str, b: &str| words.look(a).is_some() || words.look(b).is_some();
        let (x, z) = (given("X", "U"), given("Z", "W"));
        let kept = self.state.box_end.filter(|_| !in_block && (!x || !z)).map(|end| (end, x, z));
        self.ends_of_thread(words, kept, span)
    }

    /// Notes that a pass of G90, G92 or G94 is made, whose way is from memory of the manual.
    fn in_box(&mut self, word: &'static str, end: LathePoint, span: TextSpan) {
        self.state.box_end = Some(end);
        self.of_cycle = true;
        self.report_with("lathe-cycle-from-memory", span, "word", word);
    }

    /// G90 and G94 of Fanuc: at rapid to the end across (G94: along), a pass at feed, the retract at feed, and back to the start at
    /// rapid. R is how much farther the pass begins than it ends. The order of rapids and feeds is from memory of the manual.
    pub(super) fn cut_box(&mut self, words: &BlockWords, mode: WordEffect, span: TextSpan) {
        let Some(feed) = self.state.feed() else {
            self.report("feed-zero", span);
            return;
        };
        let in_block = words.function_for(mode).is_some();
        let Some((begin, end)) = self.box_ends(words, in_block, span) else { return };
        if (begin.z_mm - end.z_mm).abs() < 1e-9 {
            self.report_with("lathe-cycle-value", span, "field", "Z");
            return;
        }
        let turns = mode == WordEffect::TurnBox;
        self.in_box(if turns { "G90" } else { "G94" }, end, span);
        let taper = self.state.box_taper;
        let (from, back) = match turns {
            true => (at(end.radius_mm + taper, begin.z_mm), at(begin.radius_mm, end.z_mm)),
            false => (at(begin.radius_mm, end.z_mm + taper), at(end.radius_mm, begin.z_mm)),
        };
        self.rapid(from);
        for to in [end.into(), back] {
            self.push_motion(LatheAct::Feed { feed }, to);
        }
        self.rapid(begin.into());
    }

    /// G92 of Fanuc: one pass, and back. Its run-out is a parameter of the machine: none is made here.
    pub(super) fn thread_box(&mut self, words: &BlockWords, span: TextSpan) {
        if let Some(lead) = words.take("F") {
            self.state.lead = Some(lead.value);
        }
        let Some(lead) = self.state.lead.filter(|lead| *lead > 0.0) else {
            self.report("lathe-no-lead", span);
            return;
        };
        let start = self.start_angle(words);
        let in_block = words.function_for(WordEffect::ThreadBox).is_some();
        let Some((begin, end)) = self.box_ends(words, in_block, span) else { return };
        self.in_box("G92", end, span);
        self.thread_pass(begin, begin.z_mm, (end, self.state.box_taper), 0.0, (lead, 0.0, start), span);
    }
}
