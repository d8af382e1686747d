//! One program of a set-up: all tools in order, with the turret at its change position between them.

use serde::Serialize;

use crate::note::Note;
use crate::turning::contour::{Contour, Curve, Side};
use crate::turning::jobs::ThreadCut;
use crate::turning::point::Point;
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::units::MillimetresPerRev;
use technolog_core::ascii::ascii;

use super::cycle::{CycleCall, CycleTask, ProgramFile, Roughing};
use super::plain::{end, modes, spindle};
use super::refused::{NotWritten, check_arc};
use super::setting::{Feeds, Setting, Speed};
use super::text::{Pace, ProgramWriter};
use super::thread::{self, NotCycled, ThreadCall};
use super::words::{ControlWords, Use};
use super::{Control, file_name};

/// A tool in the turret.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Seat {
    /// Its place, at least 1.
    pub place: u32,
    /// The number of its offset, which no other tool has.
    #[serde(skip)]
    pub offset: u32,
    /// Which of the tools that come into this place it is, from 1: some controls number offsets for each place.
    #[serde(skip)]
    pub edge: u32,
}

impl Seat {
    /// That of a tool whose place no other tool takes.
    pub const fn only(place: u32) -> Self {
        Self { place, offset: place, edge: 1 }
    }
}

/// What the operator puts into the turret before a section.
#[derive(Clone, Debug)]
pub struct SectionLoad {
    /// The comments: a tool each.
    pub remarks: Vec<String>,
    /// Whether the program stops for it; before its first section it has not begun.
    pub stops: bool,
}

/// The work of one tool with the same speed and feeds.
#[derive(Clone, Debug)]
pub struct ToolSection {
    /// The tool in the turret.
    pub tool: Seat,
    /// What is put into the turret before it.
    pub load: Option<SectionLoad>,
    /// The comment for the operator at the tool: its designation and its work.
    pub title: String,
    /// The speed of the spindle.
    pub speed: Speed,
    /// The feeds.
    pub feeds: Feeds,
    /// Whether coolant is on.
    pub coolant: bool,
    /// Its toolpath.
    pub path: Toolpath,
    /// The same work as a cycle of the control, if requested.
    pub cycle: Option<SectionCycle>,
    /// Whether its moves along a thread are those of a tap: in, and back with the spindle reversed.
    pub taps: bool,
}

/// Work that a cycle of the control may do.
#[derive(Clone, Debug)]
pub enum SectionCycle {
    /// Roughing over a contour.
    Rough(CycleOf),
    /// A thread.
    Thread(ThreadCut, Side),
}

/// A program with its files, the main file first.
#[derive(Clone, Debug)]
pub struct WholeProgram {
    /// The files.
    pub files: Vec<ProgramFile>,
    /// Why threads of it are cut by single passes, although cycles are requested.
    pub remarks: Vec<Note>,
}

/// The work of a section as a call.
enum Call {
    Motions,
    Rough(CycleCall, Point),
    Thread(Result<ThreadCall, NotCycled>),
}

/// A roughing cycle over a contour.
#[derive(Clone, Debug)]
pub struct CycleOf {
    /// The rough contour.
    pub rough: Contour,
    /// The corner of the blank before it.
    pub corner: Point,
    /// The parameters.
    pub roughing: Roughing,
}

/// What is in front of the free end of the part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FreeEnd {
    /// Nothing: both axes may go to the change position together.
    Open,
    /// A tailstock: the tool passes it with X retracted, so X leaves first and comes last.
    Tailstock,
}

/// The program of a set-up; `number` tells the set-ups of a part apart, `single` says why a thread has single passes.
///
/// Before each tool and at the end the turret moves to the change position of the control, so that the program can
/// begin wherever the last one ended. Paths of one tool follow each other from home point to home point.
///
/// # Errors
/// Why it cannot be written.
pub fn whole(
    control: &Control,
    name: &str,
    number: u8,
    sections: &[ToolSection],
    end_of_part: FreeEnd,
    single: &dyn Fn(NotCycled) -> String,
) -> Result<WholeProgram, NotWritten> {
    let words = control.words()?;
    let latin = file_name(name);
    let mut sheet = ProgramWriter::new(words);
    modes(&mut sheet, &format!("{name} - {number}"));
    let mut files = Vec::new();
    let mut before: Option<&ToolSection> = None;
    // Whether the coolant is on.
    let mut wet = false;
    let mut remarks = Vec::new();
    let calls = sections.iter().enumerate().map(|(index, section)| {
        let task = match &section.cycle {
            Some(SectionCycle::Thread(cut, side)) => return Ok(Call::Thread(thread::call(control, cut, *side))),
            Some(SectionCycle::Rough(one)) => CycleTask::new(&one.rough, one.corner, one.roughing),
            None => return Ok(Call::Motions),
        };
        // Work without a possible cycle is written as motions.
        let (Ok(task), Some((cycles, writer))) = (task, &control.cycles) else { return Ok(Call::Motions) };
        let setting = Setting {
            name: name.to_owned(),
            tool: section.tool.place,
            speed: section.speed,
            feeds: section.feeds,
            coolant: section.coolant,
        };
        setting.check()?;
        let call = writer(control, cycles, &task, &setting, index);
        Ok(call.map_or(Call::Motions, |call| Call::Rough(call, task.begins())))
    });
    let calls: Vec<_> = calls.collect::<Result<_, NotWritten>>()?;
    for call in &calls {
        if let Call::Rough(call, _) = call {
            sheet.lines(&call.before);
            files.extend(call.file.clone());
        }
    }
    for (section, call) in sections.iter().zip(&calls) {
        check(section, name, words)?;
        let same = before.filter(|before| before.tool == section.tool && section.load.is_none());
        if same.is_none() {
            change(&mut sheet, before.is_some(), wet, end_of_part);
            wet = false;
            load(&mut sheet, section.load.as_ref());
            sheet.comment(&ascii(&section.title));
            sheet.line(&words.tool(section.tool));
        }
        if same.is_none_or(|before| before.speed != section.speed) {
            sheet.lines(&spindle(words, section.speed));
        }
        if section.coolant != wet {
            sheet.put(&[if section.coolant { Use::CoolantOn } else { Use::CoolantOff }]);
            wet = section.coolant;
        }
        if same.is_none() {
            sheet.forget();
        }
        match call {
            Call::Rough(call, begins) => {
                sheet.approach(*begins, end_of_part);
                sheet.lines(&call.call);
                sheet.forget();
                sheet.rapid(*begins);
            }
            Call::Thread(Ok(call)) => {
                let home = section.path.from;
                let beside = Point { radius: home.radius, z: call.start.z };
                sheet.approach(home, end_of_part);
                sheet.rapid(beside);
                sheet.rapid(call.start);
                sheet.lines(&call.lines);
                sheet.forget();
                sheet.rapid(call.start);
                sheet.rapid(beside);
                sheet.rapid(home);
            }
            Call::Thread(Err(why)) => {
                sheet.comment(&ascii(&single(*why)));
                remarks.push(why.note());
                along(&mut sheet, section, end_of_part);
            }
            Call::Motions => along(&mut sheet, section, end_of_part),
        }
        before = Some(section);
    }
    leave(&mut sheet, end_of_part);
    end(&mut sheet);
    let ending = &control.ending;
    files.insert(0, ProgramFile { name: format!("{latin}_{number}{ending}"), text: sheet.finish() });
    Ok(WholeProgram { files, remarks })
}

/// A program that must not be run, with the reasons in its first lines. Where its number comes first they stand behind it, too:
/// what comes before it a control does not keep.
///
/// # Errors
/// The control has no words.
pub fn warned(control: &Control, file: ProgramFile, reasons: &[String]) -> Result<ProgramFile, NotWritten> {
    let words = control.words()?;
    let mut told = ProgramWriter::new(words);
    reasons.iter().for_each(|reason| told.comment(&ascii(&format!("DO NOT RUN: {reason}"))));
    let told = told.finish();
    let text = match file.text.split_once('\n').filter(|(head, _)| head.starts_with('O')) {
        Some((head, rest)) => format!("{told}{head}\n{told}{rest}"),
        None => format!("{told}{}", file.text),
    };
    Ok(ProgramFile { text, ..file })
}

/// To the change position; after a tool its spindle and coolant stop there.
fn change(sheet: &mut ProgramWriter<'_>, after: bool, wet: bool, end_of_part: FreeEnd) {
    leave(sheet, end_of_part);
    if after {
        sheet.put(&[Use::SpindleStop]);
    }
    if wet {
        sheet.put(&[Use::CoolantOff]);
    }
}

/// The turret stands at the change position, spindle and coolant are off: the operator reads what to put in, and starts again.
fn load(sheet: &mut ProgramWriter<'_>, load: Option<&SectionLoad>) {
    let Some(load) = load else { return };
    for remark in &load.remarks {
        sheet.comment(&ascii(remark));
    }
    if load.stops {
        sheet.put(&[Use::Stop]);
    }
}

/// To the change position.
fn leave(sheet: &mut ProgramWriter<'_>, end_of_part: FreeEnd) {
    match end_of_part {
        FreeEnd::Open => sheet.put(&[Use::ChangePosition]),
        FreeEnd::Tailstock => {
            sheet.put(&[Use::ChangePositionX]);
            sheet.put(&[Use::ChangePositionZ]);
            // LinuxCNC names the axis by a distance of zero.
            sheet.put(&[Use::Absolute]);
        }
    }
}

/// The motions of a section.
fn along(sheet: &mut ProgramWriter<'_>, section: &ToolSection, end_of_part: FreeEnd) {
    sheet.approach(section.path.from, end_of_part);
    for (piece, purpose, own) in section.path.paced() {
        if section.taps && purpose == Purpose::Thread {
            // The control brings the tap back to where it began.
            if piece.to.z > piece.from.z {
                sheet.tap(piece, section.speed, section.feeds.thread);
            }
            continue;
        }
        let pace = match (purpose, own.or_else(|| section.feeds.of(purpose))) {
            (Purpose::Thread, Some(lead)) => Pace::Thread(lead),
            (_, Some(feed)) => Pace::Feed(feed),
            (_, None) => Pace::Rapid,
        };
        sheet.go(piece, pace);
    }
}

/// Whether a section can be written.
fn check(section: &ToolSection, name: &str, words: &ControlWords) -> Result<(), NotWritten> {
    let ToolSection { tool, speed, feeds, coolant, .. } = *section;
    Setting { name: name.to_owned(), tool: tool.place, speed, feeds, coolant }.check()?;
    if section.path.moves.is_empty() {
        return Err(NotWritten::EmptyWay);
    }
    if section.taps && words.get(Use::Tap).is_empty() {
        return Err(NotWritten::NoTapping);
    }
    for (number, (piece, purpose, own)) in (1..).zip(section.path.paced()) {
        check_arc(piece, number)?;
        if let Some(feed) = own.filter(|feed| !super::setting::is_written(feed.0, 4)) {
            return Err(NotWritten::NoFeed { feed });
        }
        let feed: Option<MillimetresPerRev> = feeds.of(purpose);
        if feed.is_none() && piece.curve != Curve::Line {
            return Err(NotWritten::RapidArc { piece: number });
        }
    }
    Ok(())
}
