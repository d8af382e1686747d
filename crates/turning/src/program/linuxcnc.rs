//! LinuxCNC 2.9: G71 and G72 with the contour in a subprogram of the same file.

use super::call::Cycles;
use super::cycle::{CycleProgram, ProgramFile, Task};
use super::plain::{begin, end};
use super::refused::NotWritten;
use super::setting::Setting;
use super::text::{Pace, ProgramWriter, number};
use super::words::Use;
use super::{Control, file_name};

/// The number of the subprogram with the contour.
const CONTOUR: &str = "100";

/// The program of a task.
///
/// The subprogram stands before the call, which takes its first move as a rapid from the beginning of the cycle. The feed
/// of the passes stands in a block before the call: what the subprogram says of feeds is not read. The cycle itself goes
/// along the contour after its passes and leaves the blank.
pub(super) fn write(
    control: &Control,
    cycles: &Cycles,
    task: &Task<'_>,
    setting: &Setting,
) -> Result<CycleProgram, NotWritten> {
    let words = control.words()?;
    // D, which would leave one, makes half circles (LinuxCNC issue 2939) or is refused («Cannot intersect parallel lines»).
    if task.roughing.allowance != super::Allowance::default() {
        return Err(NotWritten::Allowance { control: control.name.clone() });
    }
    let mut sheet = ProgramWriter::new(words);
    begin(&mut sheet, control, setting)?;
    sheet.rapid(task.begins());
    sheet.line(&words.filled(Use::ContourBegins, &[("number", CONTOUR.to_owned())]));
    sheet.forget();
    // The profile leaves the blank: where it only touches its surface, an arc that ends there a trifle below makes G71 seek
    // the end of its first pass for ever (seen in rs274 of 2.9.0~pre1).
    let clearance = task.roughing.clearance;
    let profile = task.profile(clearance, clearance);
    for (index, piece) in profile.iter().enumerate() {
        if index == 0 {
            sheet.rapid(piece.from);
        }
        sheet.go(*piece, Pace::Contour);
    }
    sheet.line(&words.filled(Use::ContourEnds, &[("number", CONTOUR.to_owned())]));
    sheet.line(&format!("F{}", number(setting.feeds.cut.0, 4)));
    let fields = cycles.filled(task, CONTOUR, &setting.feeds);
    let fields: Vec<String> = fields.into_iter().map(|(name, value)| format!("{name}{value}")).collect();
    sheet.line(&format!("{} {}", cycles.code(task), fields.join(" ")));
    end(&mut sheet);
    let name = format!("{}.ngc", file_name(&setting.name));
    Ok(CycleProgram { files: vec![ProgramFile { name, text: sheet.finish() }] })
}
