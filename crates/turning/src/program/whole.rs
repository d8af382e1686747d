//! One program of a set-up: all tools in order, with the turret at its change position between them.

use crate::turning::contour::{Contour, Curve};
use crate::turning::point::Point;
use crate::turning::toolpath::{Purpose, Toolpath};
use crate::units::MillimetresPerRev;
use technolog_core::ascii::ascii;

use super::cycle::{CycleTask, ProgramFile, Roughing};
use super::plain::{end, modes, spindle};
use super::refused::{NotWritten, check_arc};
use super::setting::{Feeds, Setting, Speed};
use super::text::{Pace, ProgramWriter};
use super::words::{ControlWords, Use};
use super::{Control, file_name};

/// The work of one tool with the same speed and feeds.
#[derive(Clone, Debug)]
pub struct ToolSection {
    /// The place of the tool in the turret, at least 1.
    pub tool: u32,
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
    /// The same work as a roughing cycle of the control, if requested and possible.
    pub cycle: Option<CycleOf>,
    /// Whether its moves along a thread are those of a tap: in, and back with the spindle reversed.
    pub taps: bool,
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

/// The program of a set-up; `number` tells the set-ups of a part apart. The main file comes first.
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
) -> Result<Vec<ProgramFile>, NotWritten> {
    let words = control.words()?;
    let latin = file_name(name);
    let mut sheet = ProgramWriter::new(words);
    modes(&mut sheet, &format!("{name} - {number}"));
    let mut files = Vec::new();
    let mut before: Option<&ToolSection> = None;
    let calls = sections.iter().enumerate().map(|(index, section)| {
        let task = section.cycle.as_ref().map(|one| CycleTask::new(&one.rough, one.corner, one.roughing));
        // Work without a possible cycle is written as motions.
        let (Some(Ok(task)), Some((cycles, writer))) = (task, &control.cycles) else { return Ok(None) };
        let setting = Setting {
            name: name.to_owned(),
            tool: section.tool,
            speed: section.speed,
            feeds: section.feeds,
            coolant: section.coolant,
        };
        setting.check()?;
        Ok(writer(control, cycles, &task, &setting, index).ok().map(|call| (call, task.begins())))
    });
    let calls: Vec<_> = calls.collect::<Result<_, NotWritten>>()?;
    for (call, _) in calls.iter().flatten() {
        sheet.lines(&call.before);
        files.extend(call.file.clone());
    }
    for (section, call) in sections.iter().zip(&calls) {
        check(section, name, words)?;
        let same = before.filter(|before| before.tool == section.tool);
        if same.is_none() {
            change(&mut sheet, before.is_some(), end_of_part);
            sheet.comment(&ascii(&section.title));
            sheet.line(&words.tool(section.tool));
        }
        if same.is_none_or(|before| before.speed != section.speed) {
            sheet.lines(&spindle(words, section.speed));
        }
        if section.coolant && same.is_none_or(|before| !before.coolant) {
            sheet.put(&[Use::CoolantOn]);
        }
        if same.is_none() {
            sheet.forget();
        }
        match call {
            Some((call, begins)) => {
                sheet.approach(*begins, end_of_part);
                sheet.lines(&call.call);
                sheet.forget();
                sheet.rapid(*begins);
            }
            None => along(&mut sheet, section, end_of_part),
        }
        before = Some(section);
    }
    leave(&mut sheet, end_of_part);
    end(&mut sheet);
    let ending = &control.ending;
    files.insert(0, ProgramFile { name: format!("{latin}_{number}{ending}"), text: sheet.finish() });
    Ok(files)
}

/// To the change position; after a tool its spindle and coolant stop there.
fn change(sheet: &mut ProgramWriter<'_>, after: bool, end_of_part: FreeEnd) {
    leave(sheet, end_of_part);
    if after {
        sheet.put(&[Use::SpindleStop]);
        sheet.put(&[Use::CoolantOff]);
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
    Setting { name: name.to_owned(), tool, speed, feeds, coolant }.check()?;
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
