//! The execution of a program: its blocks, calls and contours.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::LatheReader;
use super::block::{After, Maker};
use super::contour::{Leg, Round};
use super::control::LatheLanguage;
use super::corners::Waiting;
use super::expression::{Expression, Parameters};
use super::motion::{LatheMotion, LathePlace, LathePoint};
use super::rules::fault;
use super::state::State;
use super::text::{self, Argument, Block, Head};
use super::words::BlockWords;
use crate::program::{Fault, TextSpan};
use crate::tables::controls::lathe_reading::{LatheGroup, WordEffect};

/// The most blocks and motions of a run.
const BUDGET: usize = crate::program::running::BUDGET;

/// The deepest nesting of subprogram calls.
const DEPTH: usize = 10;

/// A subprogram in a file of its own, as Sinumerik keeps contours.
#[derive(Clone, Copy, Debug)]
pub struct Subprogram<'a> {
    /// Its name, without ending.
    pub name: &'a str,
    /// Its text.
    pub text: &'a str,
}

/// The actions of a program and its faults.
#[derive(Clone, Debug, Default)]
pub struct LatheRun {
    /// All actions, in order.
    pub motions: Vec<LatheMotion>,
    /// What is wrong, by place.
    pub faults: Vec<Fault>,
    /// The control that it was read for.
    pub control: Option<LatheReader>,
}

/// Reads a program and runs it.
///
/// A text with errors is not run. A block with an error makes no motion, but its modal functions take effect and the
/// run continues, so that all mistakes are reported at once.
pub fn read(text: &str, language: &LatheLanguage, files: &[Subprogram<'_>]) -> LatheRun {
    let (mut blocks, mut faults) = text::blocks(text, language.kind);
    let main = blocks.len();
    let mut programs = Programs { end: main, ..Programs::default() };
    for file in files {
        let begin = blocks.len();
        let (more, wrong) = text::blocks(file.text, language.kind);
        // Places in another file would be misread as places in this one: faults there are reported at the call.
        programs.unread.extend((!wrong.is_empty()).then(|| file.name.to_ascii_uppercase()));
        blocks.extend(more);
        programs.named.insert(file.name.to_ascii_uppercase(), begin..blocks.len());
    }
    programs.find(&blocks, main, language.kind, &mut faults);
    if main == 0 {
        faults.push(fault("empty-program", TextSpan { line: 1, column: 1, width: 1 }, None));
    }
    let pointed = blocks.iter().flat_map(|block| &block.words).any(text::Word::is_pointed_length);
    let mut run = Run {
        blocks: &blocks,
        programs: &programs,
        language,
        state: State { pointed, numbered: largest_tool(&blocks), ..State::power_on(language) },
        motions: Vec::new(),
        faults: Vec::new(),
        reported: BTreeSet::new(),
        left: BUDGET,
    };
    if !faults.iter().any(Fault::is_error) {
        run.main();
    }
    faults.append(&mut run.faults);
    faults.extend(super::offsets::shared(language.kind, &run.motions));
    faults.sort_by_key(|fault| fault.span);
    LatheRun { motions: run.motions, faults, control: Some(language.kind) }
}

/// The largest number of a tool.
fn largest_tool(blocks: &[Block]) -> u32 {
    let number = |word: &text::Word| match word.value {
        Expression::Number(number) if word.name == "T" && (0.0..1e6).contains(&number) => Some(number as u32),
        _ => None,
    };
    blocks.iter().flat_map(|block| &block.words).filter_map(number).max().unwrap_or_default()
}

/// The places of programs in the blocks.
#[derive(Debug, Default)]
struct Programs {
    named: BTreeMap<String, Range<usize>>,
    /// For the block that begins a subprogram of LinuxCNC: the block after it.
    passed: BTreeMap<usize, usize>,
    end: usize,
    unread: Vec<String>,
}

impl Programs {
    fn find(&mut self, blocks: &[Block], main: usize, kind: LatheReader, faults: &mut Vec<Fault>) {
        let mut open: Option<(usize, String)> = None;
        let mut heads = Vec::new();
        for (index, block) in blocks.iter().enumerate().take(main) {
            match &block.head {
                Some(Head::Program(name)) if kind != LatheReader::LinuxCnc => heads.push((index, name.clone())),
                Some(Head::Sub(name)) if open.is_none() => open = Some((index, name.clone())),
                Some(Head::EndSub(name)) if open.as_ref().is_some_and(|(_, opened)| opened == name) => {
                    if let Some((start, name)) = open.take() {
                        self.named.insert(name, start + 1..index);
                        self.passed.insert(start, index + 1);
                    }
                }
                Some(Head::Sub(_) | Head::EndSub(_)) => {
                    faults.push(fault("sub-without-pair", block.span, block.number));
                }
                _ => {}
            }
        }
        if let Some((start, _)) = open
            && let Some(block) = blocks.get(start)
        {
            faults.push(fault("sub-without-pair", block.span, block.number));
        }
        if kind == LatheReader::Sinumerik && heads.is_empty() {
            self.behind_the_end(blocks.get(..main).unwrap_or_default(), faults);
        }
        for (place, (start, name)) in heads.iter().enumerate() {
            let end = heads.get(place + 1).map_or(main, |next| next.0);
            if *start > 0 {
                self.named.insert(name.clone(), *start..end);
                self.end = self.end.min(*start);
            }
        }
    }
}

impl Programs {
    /// Contours without a name after the end of the program, as when files were joined into one text: they belong to
    /// the calls, in order.
    fn behind_the_end(&mut self, blocks: &[Block], faults: &mut Vec<Fault>) {
        let Some(end) = blocks.iter().position(|block| says(block, &[2.0, 30.0])) else { return };
        let mut called: Vec<(&str, &Block)> = Vec::new();
        for block in blocks.get(..end).unwrap_or_default() {
            if let Some((cycle, arguments, _)) = &block.call
                && cycle == "CYCLE95"
                && let Some(Argument::Text(name)) = arguments.first()
                && !self.named.contains_key(name)
                && !name.contains(':')
                && !called.iter().any(|(known, _)| known == name)
            {
                called.push((name, block));
            }
        }
        let mut begin = end + 1;
        for (name, block) in called {
            let Some(length) = blocks.get(begin..).unwrap_or_default().iter().position(|block| says(block, &[17.0]))
            else {
                return;
            };
            self.named.insert(name.to_owned(), begin..begin + length + 1);
            faults.push(fault("lathe-contour-behind", block.span, block.number).with("name", name.to_owned()));
            begin += length + 1;
        }
    }
}

/// Whether a block has one of these M functions.
fn says(block: &Block, codes: &[f64]) -> bool {
    let is =
        |word: &text::Word| word.name == "M" && matches!(word.value, Expression::Number(code) if codes.contains(&code));
    block.words.iter().any(is)
}

struct Run<'a> {
    blocks: &'a [Block],
    programs: &'a Programs,
    language: &'a LatheLanguage,
    state: State,
    motions: Vec<LatheMotion>,
    faults: Vec<Fault>,
    reported: BTreeSet<(u32, u32, &'static str)>,
    left: usize,
}

/// The next block of the run.
enum Next {
    On,
    To(usize),
    Back,
    Out,
}

impl Run<'_> {
    fn main(&mut self) {
        let ended = self.program(0..self.programs.end, 0);
        if let Some(corner) = self.state.corner {
            self.report(fault("lathe-corner-alone", corner.span, None));
        }
        if matches!(ended, Next::On) {
            let last = self.blocks.get(self.programs.end.wrapping_sub(1));
            if let Some((span, number)) = last.map(|block| (block.span, block.number)) {
                self.report(fault("program-without-end", span, number));
            }
        }
    }

    fn report(&mut self, fault: Fault) {
        if self.reported.insert((fault.span.line, fault.span.column, fault.code)) {
            self.faults.push(fault);
        }
    }

    fn program(&mut self, range: Range<usize>, depth: usize) -> Next {
        let mut index = range.start;
        while index < range.end {
            if let Some(behind) = self.programs.passed.get(&index) {
                index = *behind;
                continue;
            }
            match self.block(index, depth) {
                Next::On => index += 1,
                Next::To(next) => index = next,
                outcome => return outcome,
            }
        }
        Next::On
    }

    fn block(&mut self, index: usize, depth: usize) -> Next {
        let Some(block) = self.blocks.get(index) else { return Next::Out };
        if self.left == 0 {
            self.report(fault("run-too-long", block.span, block.number).with("budget", BUDGET));
            return Next::Out;
        }
        self.left -= 1;
        for (name, value, span) in &block.sets {
            match value.value(&self.state.parameters) {
                Some(value) => {
                    self.state.parameters.insert(name.clone(), value);
                }
                None => {
                    let problem = fault("lathe-parameter-unknown", *span, block.number).with("word", name.clone());
                    self.report(problem);
                }
            }
        }
        let mut faults = Vec::new();
        let waiting = self.state.corner.take();
        let words = BlockWords::read(block, self.language, &self.state.parameters, &mut faults);
        let mut maker = Maker {
            language: self.language,
            state: self.state.clone(),
            motions: Vec::new(),
            faults,
            span: block.span,
            number: block.number,
            of_cycle: false,
            budget: self.left,
        };
        maker.points(&words);
        maker.before_motion(&words);
        let mut next = Next::On;
        let cycle = words.functions.iter().find(|it| {
            matches!(
                it.effect,
                WordEffect::RoughAlong
                    | WordEffect::RoughAcross
                    | WordEffect::Finish
                    | WordEffect::ThreadCycle
                    | WordEffect::PeckAlong
                    | WordEffect::PeckAcross
            ) || it.effect == WordEffect::NotCarriedOut && it.group == LatheGroup::OneShot
        });
        if let Some(function) = cycle {
            maker.of_cycle = true;
            if function.effect == WordEffect::ThreadCycle {
                maker.thread_cycle(&words, function.span);
            } else if matches!(function.effect, WordEffect::PeckAlong | WordEffect::PeckAcross) {
                maker.pecks(&words, function.effect == WordEffect::PeckAcross, function.span);
            } else if function.effect == WordEffect::NotCarriedOut {
                // The contour of G73 belongs to it.
                let behind = words.look("Q").and_then(|last| self.numbered(last.value)).filter(|last| *last > index);
                maker.not_carried_out(&words, function.span);
                next = behind.map_or(Next::On, |last| Next::To(last + 1));
            } else if let Some(after_cycle) =
                self.contour_cycle(&mut maker, &words, function.effect, function.span, index)
            {
                next = after_cycle;
            }
        } else if let Some((name, arguments, span)) = &block.call {
            maker.of_cycle = true;
            self.call_of_siemens(&mut maker, name, arguments, *span);
        } else if words.function_for(WordEffect::SpeedLimit).is_none()
            && words.function_for(WordEffect::Dwell).is_none()
            && words.function_for(WordEffect::Call).is_none()
        {
            maker.motion(&words);
        }
        let after = maker.after_motion(&words);
        let call = self.call(block, &words);
        maker.unused(&words);
        let Maker { mut state, mut motions, mut faults, .. } = maker;
        if let Some(corner) = waiting {
            match motions.iter_mut().find(|motion| motion.act.moves()) {
                Some(behind) => {
                    let before = self.motions.iter_mut().rev().find(|motion| motion.act.moves());
                    match corner.between(before, behind) {
                        Ok(at_corner) => motions.splice(0..0, at_corner).for_each(drop),
                        Err(code) => faults.push(corner.fault(code, block.number)),
                    }
                }
                None => state.corner = Some(corner),
            }
        }
        if faults.iter().any(Fault::is_error) {
            state.corner = None;
        }
        // Of a block with an error only the modal functions are kept.
        if !faults.iter().any(Fault::is_error) {
            self.left = self.left.saturating_sub(motions.len());
            self.motions.extend(motions);
        }
        self.state = state;
        faults.into_iter().for_each(|fault| self.report(fault));
        match after {
            After::End => return Next::Out,
            After::Return if depth == 0 => {
                self.report(fault("return-without-call", block.span, block.number));
                return Next::Out;
            }
            After::Return => return Next::Back,
            After::Next => {}
        }
        match call {
            Some((name, times, span)) => self.run_call(&name, times, span, block.number, depth),
            None => next,
        }
    }

    /// The call of a block: name, repeats, place.
    fn call(&self, block: &Block, words: &BlockWords) -> Option<(String, u32, TextSpan)> {
        if let Some(Head::Call(name, _)) = &block.head {
            return Some((name.clone(), 1, block.span));
        }
        if let Some(function) = words.function_for(WordEffect::Call) {
            let number = words.take("P").map_or(0.0, |value| value.value).max(0.0) as u64;
            let times = words.take("L").map(|value| value.value.max(0.0) as u32);
            let (number, packed) = if number > 9999 { (number % 10_000, number / 10_000) } else { (number, 1) };
            let packed = u32::try_from(packed).unwrap_or(1);
            return Some((number.to_string(), times.unwrap_or(packed), function.span));
        }
        words.names.first().map(|(name, span)| (name.clone(), 1, *span))
    }

    fn run_call(&mut self, name: &str, times: u32, span: TextSpan, number: Option<u32>, depth: usize) -> Next {
        let Some(range) = self.programs.named.get(name).cloned() else {
            let is_word = self.language.kind == LatheReader::Sinumerik;
            let (code, key) = if is_word { ("unknown-word", "word") } else { ("subprogram-missing", "number") };
            self.report(fault(code, span, number).with(key, name.to_owned()));
            return Next::On;
        };
        if depth >= DEPTH {
            self.report(fault("calls-too-deep", span, number).with("limit", DEPTH));
            return Next::Out;
        }
        for _ in 0..times {
            if matches!(self.program(range.clone(), depth + 1), Next::Out) {
                return Next::Out;
            }
        }
        Next::On
    }

    /// G70, G71, G72 with the blocks of their contour; returns where the run continues.
    fn contour_cycle(
        &mut self,
        maker: &mut Maker<'_>,
        words: &BlockWords,
        does: WordEffect,
        span: TextSpan,
        index: usize,
    ) -> Option<Next> {
        if self.language.kind == LatheReader::LinuxCnc {
            let name = words.take("Q").map_or(0.0, |value| value.value).max(0.0) as u64;
            let Some(range) = self.programs.named.get(&name.to_string()).cloned() else {
                maker.report_with("lathe-contour-missing", span, "name", name.to_string());
                return None;
            };
            let begin = maker.begin_of_words(words, span)?;
            let legs = self.legs(maker, range, begin, false)?;
            maker.linuxcnc_cycle(words, does, span, begin, legs);
            return None;
        }
        // Fanuc: the first block of G71 and G72 has no P.
        if words.look("P").is_none() && does != WordEffect::Finish {
            maker.first_block(words, does, span);
            return None;
        }
        let (Some(first), Some(last)) = (words.take("P").map(|it| it.value), words.take("Q").map(|it| it.value)) else {
            maker.report_with("lathe-cycle-field", span, "field", "P, Q");
            return None;
        };
        let (Some(from), Some(to)) = (self.numbered(first), self.numbered(last)) else {
            maker.report_with("lathe-contour-missing", span, "name", format!("N{first} … N{last}"));
            return None;
        };
        let Some(begin) = maker.state.at.point() else {
            maker.report("lathe-place-unknown", span);
            return None;
        };
        let legs = self.legs(maker, from..to + 1, begin, true)?;
        let type_two =
            self.blocks.get(from).is_some_and(|block| names_axis(block, "X", "U") && names_axis(block, "Z", "W"));
        maker.fanuc_cycle(words, does, span, begin, legs, type_two);
        // The control continues after the contour if the call comes before it.
        (does != WordEffect::Finish && to > index).then_some(Next::To(to + 1))
    }

    /// The block of a number.
    fn numbered(&self, number: f64) -> Option<usize> {
        self.blocks.iter().position(|block| block.number.is_some_and(|it| f64::from(it) == number))
    }

    /// CYCLE84, CYCLE95, CYCLE97 and MSG.
    fn call_of_siemens(&mut self, maker: &mut Maker<'_>, name: &str, arguments: &[Argument], span: TextSpan) {
        match name {
            "MSG" | "SETMS" => maker.of_cycle = false,
            "CYCLE97" => maker.cycle97(arguments, span),
            "CYCLE84" => maker.cycle84(arguments, span),
            "CYCLE95" => {
                let Some(Argument::Text(contour)) = arguments.first() else {
                    maker.report_with("lathe-cycle-field", span, "field", "NPP");
                    return;
                };
                let contour = contour.trim_end_matches(".SPF");
                let marked = contour.split_once(':').and_then(|(from, to)| {
                    let find = |name: &str| {
                        self.blocks.iter().position(|block| block.head == Some(Head::Mark(name.to_owned())))
                    };
                    Some(find(from)? + 1..find(to)?)
                });
                let range = marked.or_else(|| self.programs.named.get(contour).cloned());
                let Some(range) = range.filter(|_| !self.programs.unread.iter().any(|name| name == contour)) else {
                    maker.report_with("lathe-contour-missing", span, "name", contour.to_owned());
                    return;
                };
                let nowhere = LathePoint { radius_mm: f64::NAN, z_mm: f64::NAN };
                if let Some(legs) = self.legs(maker, range, nowhere, true) {
                    maker.cycle95(arguments, span, legs);
                }
            }
            _ if self.language.functions.get(name).is_some_and(|known| known.1 == WordEffect::NotCarriedOut) => {
                maker.report_with("lathe-not-carried-out", span, "word", name.to_owned());
            }
            _ => maker.report_with("lathe-cycle-not-read", span, "word", name.to_owned()),
        }
    }

    /// The elements of a contour; its blocks are read but not executed.
    fn legs(&self, maker: &mut Maker<'_>, range: Range<usize>, begin: LathePoint, finite: bool) -> Option<Vec<Leg>> {
        let known = begin.radius_mm.is_finite();
        let mut state = maker.state.clone();
        state.at = if known { begin.into() } else { LathePlace::default() };
        state.modes.remove(&LatheGroup::Motion);
        let parameters: Parameters = state.parameters.clone();
        let (mut legs, before): (Vec<Leg>, _) = (Vec::new(), maker.faults.len());
        let mut waiting: Option<Waiting> = None;
        for block in self.blocks.get(range)?.iter() {
            let mut inner = Maker {
                language: self.language,
                state: state.clone(),
                motions: Vec::new(),
                faults: Vec::new(),
                span: block.span,
                number: block.number,
                of_cycle: true,
                budget: 0,
            };
            let words = BlockWords::read(block, self.language, &parameters, &mut inner.faults);
            let feed = words.take("F").map(|value| value.value);
            let modes = [LatheGroup::Motion, LatheGroup::Plane, LatheGroup::Distance, LatheGroup::Compensation];
            for function in &words.functions {
                match function.effect {
                    WordEffect::Return => break,
                    WordEffect::Thread | WordEffect::ThreadBox | WordEffect::TurnBox | WordEffect::FaceBox => {
                        inner.report_with("lathe-contour-word", function.span, "word", function.code.clone())
                    }
                    _ if modes.contains(&function.group) => {
                        inner.state.modes.insert(function.group, function.effect);
                    }
                    _ if finite && function.group != LatheGroup::OneShot => {}
                    _ => inner.report_with("lathe-contour-word", function.span, "word", function.code.clone()),
                }
            }
            for name in ["S", "T"] {
                words.take(name);
            }
            let mode = inner.state.modes.get(&LatheGroup::Motion).copied();
            let axes = ["X", "Z", "U", "W"].into_iter().any(|name| words.look(name).is_some());
            if axes {
                let in_block = words.of_group(LatheGroup::Motion).is_some();
                let round = matches!(mode, Some(WordEffect::Clockwise | WordEffect::Counterclockwise));
                // LinuxCNC takes an arc in a contour without its own function as G2.
                if round && !in_block && self.language.kind == LatheReader::LinuxCnc {
                    inner.report("lathe-arc-unsaid", block.span);
                }
                let Some(mode) = mode else {
                    maker.faults.push(fault("motion-missing", block.span, block.number));
                    return None;
                };
                if let Some(shape) = inner.shape(&words, mode, block.span) {
                    let corner = if inner.has_corner(mode) { inner.corner(&words) } else { None };
                    if let (Some(from), Some(to)) = (inner.state.at.point(), shape.to.point()) {
                        let (from, to) = (super::block::spot(from), super::block::spot(to));
                        if from.to(to) > 0.0 {
                            let round = shape.round.map(|(centre, ccw)| Round { centre, ccw });
                            let (rapid, line) = (mode == WordEffect::Rapid, block.span.line);
                            let mut leg = Leg { from, to, round, rapid, feed, line };
                            match waiting.take().map(|corner| (corner, corner.between_legs(legs.last_mut(), &mut leg)))
                            {
                                Some((_, Ok(at_corner))) => legs.extend(at_corner),
                                Some((corner, Err(code))) => inner.faults.push(corner.fault(code, block.number)),
                                None => {}
                            }
                            legs.push(leg);
                            waiting = corner;
                        }
                    }
                    inner.state.at = shape.to;
                }
                inner.unused(&words);
            }
            state = inner.state;
            maker.faults.append(&mut inner.faults);
        }
        if let Some(corner) = waiting {
            maker.report("lathe-corner-alone", corner.span);
        }
        (maker.faults[before..].iter().all(|fault| !fault.is_error())).then_some(legs)
    }
}

fn names_axis(block: &Block, absolute: &str, relative: &str) -> bool {
    block.words.iter().any(|word| word.name == absolute || word.name == relative)
}
