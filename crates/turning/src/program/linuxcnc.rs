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
/// The subprogram comes before the call. The cycle makes the first move of the subprogram as a rapid from its start
/// point. The feed of the passes is in a block before the call, because feeds in the subprogram are ignored. The cycle
/// itself follows the contour after its passes and leaves the blank.
pub(super) fn write(
    control: &Control,
    cycles: &Cycles,
    task: &Task<'_>,
    setting: &Setting,
) -> Result<CycleProgram, NotWritten> {
    let words = control.words()?;
    // D, which would leave an allowance, makes half circles (LinuxCNC issue 2939) or is refused («Cannot intersect
    // parallel lines»).
    if task.roughing.allowance != super::Allowance::default() {
        return Err(NotWritten::Allowance { control: control.name.clone() });
    }
    let mut sheet = ProgramWriter::new(words);
    begin(&mut sheet, control, setting)?;
    sheet.rapid(task.begins());
    sheet.line(&words.filled(Use::ContourBegins, &[("number", CONTOUR.to_owned())]));
    sheet.forget();
    // The profile must leave the blank. If it only touches the surface, and an arc ends there slightly below it, G71
    // searches for the end of its first pass forever (seen in rs274 of 2.9.0~pre1).
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
