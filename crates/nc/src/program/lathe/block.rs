//! One block, on a copy of the state: words are read and everything is checked while motions are made; motions are
//! output only if there is no error.
//!
//! The order within a block: modes; feed, speed, tool; spindle and coolant; dwell; the motion or the cycle; stop and end.

use super::LatheReader;
use super::contour::PassPoint;
use super::control::LatheLanguage;
use super::motion::{LatheAct, LatheMotion, LathePlace, LathePoint, LatheTool};
use super::rules::fault;
use super::state::State;
use super::words::{BlockWords, Value};
use crate::motion::{Sense, Turning};
use crate::note::IntoFigure;
use crate::program::{Fault, TextSpan};
use crate::tables::controls::lathe_reading::{LatheGroup, WordEffect};
use crate::units::{MillimetresPerRev, Seconds};

/// A block during its execution.
pub(super) struct Maker<'a> {
    pub language: &'a LatheLanguage,
    pub state: State,
    pub motions: Vec<LatheMotion>,
    pub faults: Vec<Fault>,
    pub span: TextSpan,
    pub number: Option<u32>,
    /// Whether the motions come from a cycle.
    pub of_cycle: bool,
    /// The most further motions.
    pub budget: usize,
}

/// What a block requests besides its motions.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum After {
    Next,
    Return,
    End,
}

/// The shape of a line or an arc: what a motion and an element of a contour have in common.
#[derive(Clone, Copy, Debug)]
pub(super) struct PathShape {
    pub to: LathePlace,
    /// Centre and whether it is counterclockwise.
    pub round: Option<(PassPoint, bool)>,
}

/// The permitted difference between the radii at both ends of an arc, mm, and as a part of the radius.
const ARC_TOLERANCE: (f64, f64) = (0.005, 0.001);

impl Maker<'_> {
    /// Reports a broken rule.
    pub fn report(&mut self, code: &'static str, span: TextSpan) {
        self.faults.push(fault(code, span, self.number));
    }

    pub fn report_with(&mut self, code: &'static str, span: TextSpan, name: &'static str, value: impl IntoFigure) {
        self.faults.push(fault(code, span, self.number).with(name, value));
    }

    pub fn broken(&self) -> bool {
        self.faults.iter().any(Fault::is_error)
    }

    pub fn is(&self, kind: LatheReader) -> bool {
        self.language.kind == kind
    }

    /// Outputs a motion of the block.
    pub fn push_motion(&mut self, act: LatheAct, to: LathePlace) {
        let (from, modes, line, of_cycle) = (self.state.at, self.state.lathe_modes(), self.span.line, self.of_cycle);
        self.motions.push(LatheMotion { act, from, to, modes, line, of_cycle });
        self.state.at = to;
    }

    fn put_here(&mut self, act: LatheAct) {
        self.push_motion(act, self.state.at);
    }

    /// Modes, feed, speed, tool, spindle, coolant and dwell: everything before the motion.
    pub fn before_motion(&mut self, words: &BlockWords) {
        self.modes(words);
        let limit = words.function_for(WordEffect::SpeedLimit).map(|function| function.span);
        if let Some(span) = limit {
            match words.take("S").map(|value| value.value).filter(|value| *value > 0.0) {
                Some(value) => self.state.limit = Some(value),
                None => self.report("lathe-limit-without-speed", span),
            }
        }
        if let Some(value) = words.take("LIMS") {
            self.state.limit = Some(value.value);
        }
        if words.function_for(WordEffect::CuttingSpeed).is_some() && self.is(LatheReader::LinuxCnc) {
            self.state.limit = words.take("D").map(|value| value.value);
        }
        if let Some(function) = words.function_for(WordEffect::CuttingSpeed)
            && self.state.turning != Turning::Stopped
            && self.state.limit.is_none()
        {
            self.report("lathe-no-limit", function.span);
        }
        self.feed_and_speed(words, limit.is_some());
        self.tool(words);
        self.machine(words);
        self.dwell(words);
    }

    fn modes(&mut self, words: &BlockWords) {
        let cycles = [WordEffect::Tap, WordEffect::NotCarriedOut];
        let in_cycle = cycles.iter().any(|effect| self.state.is(LatheGroup::Motion, *effect));
        if in_cycle && words.function_for(WordEffect::CycleOff).is_some() {
            self.state.modes.remove(&LatheGroup::Motion);
        }
        for function in &words.functions {
            match function.group {
                LatheGroup::OneShot | LatheGroup::Machine | LatheGroup::Free => continue,
                LatheGroup::System => {
                    let other = self.state.system.as_ref().is_some_and(|known| *known != function.code);
                    if other && self.state.moved {
                        self.state.at = LathePlace::default();
                    }
                    self.state.system = Some(function.code.clone());
                }
                LatheGroup::Length => {
                    if let Some(tool) = &mut self.state.tool {
                        let given = words.take("H").map(|value| value.value as u32);
                        tool.offset = (function.effect == WordEffect::Offset).then(|| given.unwrap_or(tool.number));
                    }
                }
                LatheGroup::SpeedMode if !self.state.is(LatheGroup::SpeedMode, function.effect) => {
                    self.state.speed = None;
                }
                LatheGroup::FeedMode if !self.state.is(LatheGroup::FeedMode, function.effect) => self.state.feed = None,
                _ => {}
            }
            if function.effect == WordEffect::Inches {
                self.report("lathe-inches", function.span);
            }
            if matches!(function.effect, WordEffect::CompensationLeft | WordEffect::CompensationRight) {
                self.report_with("lathe-compensation", function.span, "word", function.code.clone());
            }
            self.state.modes.insert(function.group, function.effect);
            self.state.given.insert(function.group);
        }
    }

    fn feed_and_speed(&mut self, words: &BlockWords, limit: bool) {
        let modes = [WordEffect::Thread, WordEffect::ThreadBox, WordEffect::Tap];
        let thread = self.state.modes.get(&LatheGroup::Motion).is_some_and(|mode| modes.contains(mode))
            || words.function_for(WordEffect::ThreadCycle).is_some();
        let dwell = words.function_for(WordEffect::Dwell).is_some();
        // The lead of a thread is no feed, and Sinumerik gives the time of G4 as F.
        let is_lead = thread && self.is(LatheReader::Fanuc);
        if !is_lead
            && !dwell
            && let Some(feed) = words.take("F")
        {
            let (value, span) = (feed.value, feed.span);
            if value <= 0.0 {
                self.report("feed-zero", span);
            }
            self.state.feed = Some(value);
        }
        if limit {
            return;
        }
        if let Some(speed) = words.take("S") {
            self.state.speed = Some(speed.value);
            if self.state.turning != Turning::Stopped {
                self.put_here(LatheAct::Spindle);
            }
        }
    }

    fn tool(&mut self, words: &BlockWords) {
        let change = words.function_for(WordEffect::ToolChange).is_some();
        let given = words.take("T").cloned();
        if let Some((name, span)) = &words.tool {
            self.tool_by_name(name, *span);
        }
        if let Some(given) = &given {
            let whole = given.value >= 0.0 && given.value < 1e6 && (given.value % 1.0).abs() < 1e-9;
            if !whole {
                self.report_with("number-not-whole", given.span, "address", "T");
                return;
            }
            let number = given.value as u32;
            if self.is(LatheReader::Fanuc) {
                // T0101: two digits of the tool, two of its offset.
                let offset = (!number.is_multiple_of(100)).then_some(number % 100);
                self.state.tool = Some(LatheTool { number: number / 100, offset, by_name: false });
                self.put_here(LatheAct::ToolChange);
            } else {
                self.state.wanted = Some(number);
            }
        }
        let sinumerik = self.is(LatheReader::Sinumerik);
        let edge = if sinumerik { words.take("D") } else { None };
        let offset = edge.map(|edge| (edge.value > 0.0).then_some(edge.value as u32));
        let turret = sinumerik && (given.is_some() || words.tool.is_some());
        if (change || turret)
            && let Some(number) = self.state.wanted
        {
            // Sinumerik activates D1 with a new tool.
            let offset = if sinumerik { offset.unwrap_or(Some(1)) } else { None };
            let by_name = self.state.named.values().any(|known| *known == number);
            self.state.tool = Some(LatheTool { number, offset, by_name });
            let length = words.function_for(WordEffect::Offset).is_some();
            if length && let Some(tool) = &mut self.state.tool {
                tool.offset = Some(words.take("H").map_or(number, |value| value.value as u32));
            }
            if self.is(LatheReader::LinuxCnc) {
                self.state.turning = Turning::Stopped;
            }
            self.put_here(LatheAct::ToolChange);
        } else if let (Some(offset), Some(tool)) = (offset, &mut self.state.tool) {
            tool.offset = offset;
        }
    }

    /// A tool that is called by its name gets a number that no other tool of the program has: they go on behind the largest.
    fn tool_by_name(&mut self, name: &str, span: TextSpan) {
        let next = self.state.numbered + u32::try_from(self.state.named.len()).unwrap_or(u32::MAX) + 1;
        let number = *self.state.named.entry(name.to_owned()).or_insert(next);
        let problem = fault("lathe-tool-named", span, self.number).with("name", name.to_owned());
        self.faults.push(problem.with("number", number));
        self.state.wanted = Some(number);
    }

    fn machine(&mut self, words: &BlockWords) {
        for function in &words.functions {
            let turning = match function.effect {
                WordEffect::SpindleClockwise => Turning::Clockwise,
                WordEffect::SpindleCounterclockwise => Turning::Counterclockwise,
                WordEffect::SpindleStop => Turning::Stopped,
                WordEffect::CoolantOn | WordEffect::CoolantOff => {
                    self.state.coolant = function.effect == WordEffect::CoolantOn;
                    self.put_here(LatheAct::Coolant);
                    continue;
                }
                _ => continue,
            };
            if turning != Turning::Stopped && self.state.speed.is_none_or(|speed| speed <= 0.0) {
                self.report("spindle-without-speed", function.span);
            }
            let cutting = self.state.is(LatheGroup::SpeedMode, WordEffect::CuttingSpeed);
            if turning != Turning::Stopped && cutting && self.state.limit.is_none() {
                self.report("lathe-no-limit", function.span);
            }
            self.state.turning = turning;
            self.put_here(LatheAct::Spindle);
        }
    }

    fn dwell(&mut self, words: &BlockWords) {
        let Some(function) = words.function_for(WordEffect::Dwell) else { return };
        let span = function.span;
        let time = match self.language.kind {
            LatheReader::LinuxCnc => words.take("P").map(|value| value.value),
            // P in milliseconds, X and U in seconds.
            LatheReader::Fanuc => words
                .take("P")
                .map(|value| value.value / 1000.0)
                .or_else(|| words.take("X").or_else(|| words.take("U")).map(|value| value.value)),
            // F in seconds, S in turns of the spindle, which are no time here.
            LatheReader::Sinumerik => words.take("F").map(|value| value.value),
        };
        match time.filter(|time| *time >= 0.0) {
            Some(time) => self.put_here(LatheAct::Dwell { seconds: Seconds(time) }),
            None => self.report_with("dwell-time-missing", span, "words", "G4"),
        }
    }

    /// M0 holds the program, and hands may come near the chuck: LinuxCNC leaves the spindle turning, of the others the builder of
    /// the machine says. M1 holds only where the operator wants it.
    fn stop(&mut self, span: TextSpan, always: bool) {
        if always && self.state.turning != Turning::Stopped {
            let leaves = self.is(LatheReader::LinuxCnc);
            self.report(if leaves { "stop-turning" } else { "stop-turning-maybe" }, span);
        }
    }

    /// Stop, return and end.
    pub fn after_motion(&mut self, words: &BlockWords) -> After {
        for function in &words.functions {
            match function.effect {
                WordEffect::Stop => {
                    self.stop(function.span, function.code == "M0");
                    self.put_here(LatheAct::Stop);
                }
                WordEffect::End => {
                    self.state.turning = Turning::Stopped;
                    self.put_here(LatheAct::End);
                    return After::End;
                }
                WordEffect::Return => return After::Return,
                _ => {}
            }
        }
        After::Next
    }

    /// Reports words that no function used.
    pub fn unused(&mut self, words: &BlockWords) {
        if self.broken() {
            return;
        }
        for value in words.unused() {
            self.report_with("word-unused", value.span, "word", value.name);
        }
    }

    /// A return to a reference point, a move to a machine position, or the active motion.
    pub fn motion(&mut self, words: &BlockWords) {
        let axes = ["X", "Z", "U", "W"].into_iter().any(|name| words.look(name).is_some());
        let away = words
            .function_for(WordEffect::Away)
            .or_else(|| words.function_for(WordEffect::MachinePosition))
            .map(|function| function.span);
        if let Some(span) = away {
            self.away(words, axes, span);
            return;
        }
        let Some(mode) = self.state.modes.get(&LatheGroup::Motion).copied() else {
            if axes {
                self.report("motion-missing", self.span);
            }
            return;
        };
        let in_block = words.of_group(LatheGroup::Motion).is_some();
        let circle = matches!(mode, WordEffect::Clockwise | WordEffect::Counterclockwise)
            && ["I", "K"].into_iter().any(|name| words.look(name).is_some());
        if !axes && !circle {
            return;
        }
        let span =
            if in_block { words.of_group(LatheGroup::Motion).map_or(self.span, |it| it.span) } else { self.span };
        if mode == WordEffect::ThreadBox {
            self.before_moving(span, true);
            self.thread_box(words, span);
            return;
        }
        if mode == WordEffect::NotCarriedOut {
            self.not_carried_out(words, span);
            return;
        }
        if matches!(mode, WordEffect::TurnBox | WordEffect::FaceBox) {
            self.before_moving(span, true);
            self.cut_box(words, mode, span);
            return;
        }
        if mode == WordEffect::Tap {
            if self.is(LatheReader::Fanuc) {
                self.starts_spindle();
            }
            self.before_moving(span, true);
            self.tap(words, span);
            return;
        }
        let Some(shape) = self.shape(words, mode, span) else { return };
        let corner = if self.has_corner(mode) { self.corner(words) } else { None };
        self.before_moving(span, mode != WordEffect::Rapid);
        match mode {
            WordEffect::Rapid => self.push_motion(LatheAct::Rapid, shape.to),
            WordEffect::Thread => self.thread(words, shape.to, span),
            _ => self.cut(shape, span),
        }
        self.state.corner = corner;
    }

    /// Whether a motion may end with a chamfer or a rounding: on Sinumerik an arc may, too.
    pub fn has_corner(&self, mode: WordEffect) -> bool {
        let arc = matches!(mode, WordEffect::Clockwise | WordEffect::Counterclockwise);
        mode == WordEffect::Line || arc && self.is(LatheReader::Sinumerik)
    }

    /// A cycle of which only the name is known here: told, and nothing of it is made. Such cycles end where they begin.
    pub fn not_carried_out(&mut self, words: &BlockWords, span: TextSpan) {
        words.take_all();
        let code = words.functions.iter().find(|function| function.effect == WordEffect::NotCarriedOut);
        let code = code.map_or_else(|| "".to_owned(), |function| function.code.clone());
        self.report_with("lathe-not-carried-out", span, "word", code);
    }

    /// G28 with axes goes to the place that they name first, at rapid, and only then home: G28 X0 Z0 goes through the part.
    fn by_middle(&mut self, words: &BlockWords) {
        let goes_by = words.function_for(WordEffect::Away).is_some() && !self.is(LatheReader::Sinumerik);
        // A step from a place that is not known leads nowhere that is known.
        let steps = self.state.is(LatheGroup::Distance, WordEffect::Incremental);
        let known = |name: &str, here: Option<f64>, step: bool| words.look(name).is_none() || !step || here.is_some();
        let here = self.state.at;
        let all_known = known("X", here.radius_mm, steps)
            && known("Z", here.z_mm, steps)
            && known("U", here.radius_mm, true)
            && known("W", here.z_mm, true);
        if !goes_by || !all_known {
            return;
        }
        if let Some(middle) = self.target(words).filter(|middle| *middle != here) {
            self.push_motion(LatheAct::Rapid, middle);
        }
    }

    /// A motion to a place with unknown part coordinates: the named axes are unknown afterwards.
    fn away(&mut self, words: &BlockWords, axes: bool, span: TextSpan) {
        self.start_said(span);
        self.by_middle(words);
        let mut to = self.state.at;
        let named = |names: [&str; 2]| {
            let mut any = false;
            for name in names {
                any |= words.take(name).is_some();
            }
            any
        };
        let (x, z) = (named(["X", "U"]), named(["Z", "W"]));
        // G28 of LinuxCNC without axes moves all of them.
        if x || !axes {
            to.radius_mm = None;
        }
        if z || !axes {
            to.z_mm = None;
        }
        self.push_motion(LatheAct::Away, to);
        self.state.moved = true;
    }

    /// Conditions for any motion, and for a cut.
    pub fn before_moving(&mut self, span: TextSpan, cuts: bool) {
        self.start_said(span);
        if self.state.modes.get(&LatheGroup::Plane).is_some_and(|plane| *plane != WordEffect::PlaneZx) {
            self.report("lathe-plane", span);
        }
        if !cuts {
            return;
        }
        match self.state.tool {
            None => self.report("lathe-no-tool-yet", span),
            Some(LatheTool { number: 0, .. }) => self.report("lathe-no-tool-yet", span),
            Some(LatheTool { offset: None, .. }) => self.report("lathe-no-offset", span),
            Some(_) => {}
        }
        if self.state.turning == Turning::Stopped {
            self.report("feed-without-spindle", span);
        }
    }

    fn start_said(&mut self, span: TextSpan) {
        if std::mem::replace(&mut self.state.moved, true) {
            return;
        }
        let given = &self.state.given;
        let unsaid: Vec<String> = self
            .language
            .must_be_said
            .iter()
            .filter(|(group, _)| !given.contains(group))
            .map(|(_, code)| code.clone())
            .collect();
        if !unsaid.is_empty() {
            self.report_with("lathe-start-unsaid", span, "words", unsaid.join(" "));
        }
    }

    /// A line or an arc at feed.
    fn cut(&mut self, shape: PathShape, span: TextSpan) {
        let Some(feed) = self.state.feed() else {
            self.report("feed-zero", span);
            return;
        };
        if self.state.at.point().is_none() || shape.to.point().is_none() {
            self.report("lathe-place-unknown", span);
            return;
        }
        let act = match shape.round {
            None => LatheAct::Feed { feed },
            Some((centre, ccw)) => LatheAct::Arc { feed, centre: point(centre), sense: sense(ccw) },
        };
        self.push_motion(act, shape.to);
    }

    /// G33 with K (and I), G32 with F.
    fn thread(&mut self, words: &BlockWords, to: LathePlace, span: TextSpan) {
        let lead = match self.language.kind {
            LatheReader::Fanuc => {
                self.state.lead = words.take("F").map(|value| value.value).or(self.state.lead);
                self.state.lead
            }
            _ => words.take("K").or_else(|| words.take("I")).map(|value| value.value),
        };
        let start = self.start_angle(words);
        let Some(lead) = lead.filter(|lead| *lead > 0.0) else {
            self.report("lathe-no-lead", span);
            return;
        };
        let (Some(from), Some(end)) = (self.state.at.point(), to.point()) else {
            self.report("lathe-place-unknown", span);
            return;
        };
        self.thread_to(from, end, (lead, start), span);
    }

    /// The angle of the spindle at which a pass of a thread starts: SF of Sinumerik in degrees, Q of Fanuc in thousandths of one,
    /// which has no point.
    pub fn start_angle(&mut self, words: &BlockWords) -> f64 {
        match self.language.kind {
            LatheReader::Sinumerik => words.take("SF").map_or(0.0, |angle| angle.value),
            LatheReader::Fanuc => self.thousandths(words.take("Q").cloned()),
            LatheReader::LinuxCnc => 0.0,
        }
    }

    /// A thread needs the same spindle speed in every pass.
    pub fn thread_at(&mut self, span: TextSpan) {
        if self.state.is(LatheGroup::SpeedMode, WordEffect::CuttingSpeed) {
            self.report("lathe-thread-at-cutting-speed", span);
        }
    }

    /// A line synchronised with the spindle; LinuxCNC measures the lead along the line, the others along its longer
    /// axis.
    pub fn thread_to(&mut self, from: LathePoint, to: LathePoint, (lead, start_deg): (f64, f64), span: TextSpan) {
        self.thread_at(span);
        let (dx, dz) = ((to.radius_mm - from.radius_mm).abs(), (to.z_mm - from.z_mm).abs());
        let along = match self.language.kind {
            LatheReader::LinuxCnc => lead,
            _ if dx.max(dz) > 0.0 => lead * libm::hypot(dx, dz) / dx.max(dz),
            _ => lead,
        };
        self.push_motion(LatheAct::Thread { lead: MillimetresPerRev(along), start_deg }, to.into());
    }

    /// The end of the motion, and for an arc its centre; none if something is wrong.
    pub fn shape(&mut self, words: &BlockWords, mode: WordEffect, span: TextSpan) -> Option<PathShape> {
        let to = self.target(words)?;
        if !matches!(mode, WordEffect::Clockwise | WordEffect::Counterclockwise) {
            return Some(PathShape { to, round: None });
        }
        let (Some(from), Some(end)) = (self.state.at.point(), to.point()) else {
            self.report("lathe-place-unknown", span);
            return None;
        };
        let (from, end) = (spot(from), spot(end));
        let ccw = mode == WordEffect::Counterclockwise;
        let radius = words.take(if self.is(LatheReader::Sinumerik) { "CR" } else { "R" }).cloned();
        let centre = match radius {
            Some(radius) => self.centre_of_radius(from, end, ccw, &radius)?,
            None => self.centre_of_distances(words, from, end, span)?,
        };
        Some(PathShape { to, round: Some((centre, ccw)) })
    }

    fn centre_of_radius(&mut self, from: PassPoint, to: PassPoint, ccw: bool, given: &Value) -> Option<PassPoint> {
        let (chord, radius) = (from.to(to), given.value);
        if chord < 1e-9 || radius.abs() < 1e-9 {
            self.report("arc-radius-alone", given.span);
            return None;
        }
        // A rounded radius may be a little smaller than half the chord.
        let half = chord / 2.0;
        if radius.abs() + 0.001 < half {
            let problem = fault("arc-radius-short", given.span, self.number).with("radius", shown(radius.abs()));
            self.faults.push(problem.with("needed", shown(half)));
            return None;
        }
        let height = libm::sqrt((radius * radius - half * half).max(0.0));
        // The centre of a counterclockwise arc of at most half a circle lies to the left of its direction.
        let left = if ccw == (radius > 0.0) { 1.0 } else { -1.0 };
        let (dz, dx) = ((to.z - from.z) / chord, (to.x - from.x) / chord);
        Some(PassPoint { z: (from.z + to.z) / 2.0 - left * height * dx, x: (from.x + to.x) / 2.0 + left * height * dz })
    }

    fn centre_of_distances(
        &mut self,
        words: &BlockWords,
        from: PassPoint,
        to: PassPoint,
        span: TextSpan,
    ) -> Option<PassPoint> {
        let distance = |name: &str| words.take(name).map(|value| value.value);
        let (i, k) = (distance("I"), distance("K"));
        if i.is_none() && k.is_none() {
            self.report("arc-without-centre", span);
            return None;
        }
        let centre = PassPoint { z: from.z + k.unwrap_or_default(), x: from.x + i.unwrap_or_default() };
        let (begin, end) = (from.to(centre), to.to(centre));
        let allowed = ARC_TOLERANCE.0.max(ARC_TOLERANCE.1 * begin).min(ARC_TOLERANCE.0 * 10.0);
        if (begin - end).abs() > allowed || begin < 1e-9 {
            let problem = fault("arc-radius", span, self.number).with("start", shown(begin));
            self.faults.push(problem.with("end", shown(end)).with("tolerance", shown(allowed)));
            return None;
        }
        Some(centre)
    }

    /// The target of the axis words of a block.
    fn target(&mut self, words: &BlockWords) -> Option<LathePlace> {
        let incremental = self.state.is(LatheGroup::Distance, WordEffect::Incremental);
        let measure = self.state.modes.get(&LatheGroup::Measure).copied();
        let fanuc = self.is(LatheReader::Fanuc);
        let diameter = match measure {
            _ if fanuc => true,
            Some(WordEffect::Diameters) => true,
            Some(WordEffect::DiametersAbsolute) => !incremental,
            _ => false,
        };
        let scale = if diameter { 0.5 } else { 1.0 };
        let mut to = self.state.at;
        for (name, step, is_x) in [("X", "U", true), ("Z", "W", false)] {
            let (absolute, relative) =
                (words.take(name).cloned(), if fanuc { words.take(step).cloned() } else { None });
            if let (Some(_), Some(relative)) = (&absolute, &relative) {
                self.report_with("word-twice", relative.span, "address", step);
                return None;
            }
            let axis = if is_x { &mut to.radius_mm } else { &mut to.z_mm };
            let here = *axis;
            let by = if is_x { scale } else { 1.0 };
            match (absolute, relative) {
                (Some(value), _) if !incremental => *axis = Some(value.value * by),
                (Some(value), _) | (None, Some(value)) => {
                    let Some(here) = here else {
                        self.report("lathe-place-unknown", value.span);
                        return None;
                    };
                    *axis = Some(here + value.value * by);
                }
                (None, None) => {}
            }
        }
        Some(to)
    }
}

/// A length in messages, mm.
pub(super) fn shown(mm: f64) -> String {
    let rounded = libm::round(mm * 10_000.0) / 10_000.0;
    format!("{rounded}")
}

pub(super) const fn spot(point: LathePoint) -> PassPoint {
    PassPoint { z: point.z_mm, x: point.radius_mm }
}

pub(super) const fn point(spot: PassPoint) -> LathePoint {
    LathePoint { radius_mm: spot.x, z_mm: spot.z }
}

pub(super) const fn sense(ccw: bool) -> Sense {
    if ccw { Sense::Counterclockwise } else { Sense::Clockwise }
}
