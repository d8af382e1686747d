//! LinuxCNC 2.9: G71 and G72 with the contour in a subprogram of the same file.

use super::Control;
use super::call::Cycles;
use super::cycle::{CycleCall, CycleTask};
use super::refused::NotWritten;
use super::setting::Setting;
use super::text::{Pace, ProgramWriter, number};
use super::words::Use;

/// The numbers of subprograms with contours begin here.
const FIRST: usize = 100;

/// The call of a cycle with its contour, which is subprogram number `index` of the program.
///
/// The subprogram comes before the call. The cycle makes the first move of the subprogram as a rapid from its start
/// point. The feed of the passes is in a block before the call, because feeds in the subprogram are ignored. The cycle
/// itself follows the contour after its passes and leaves the blank.
pub(super) fn write(
    control: &Control,
    cycles: &Cycles,
    task: &CycleTask<'_>,
    setting: &Setting,
    index: usize,
) -> Result<CycleCall, NotWritten> {
    let words = control.words()?;
    // D, which would leave an allowance, makes half circles (LinuxCNC issue 2939) or is refused («Cannot intersect
    // parallel lines»).
    if task.roughing.allowance != super::Allowance::default() {
        return Err(NotWritten::Allowance { control: control.name.clone() });
    }
    let number_of = (FIRST + index).to_string();
    let mut sheet = ProgramWriter::new(words);
    sheet.line(&words.filled(Use::ContourBegins, &[("number", number_of.clone())]));
    // The profile must leave the blank. If it only touches the surface, and an arc ends there slightly below it, G71
    // searches for the end of its first pass forever (observed in rs274 of 2.9.0~pre1).
    let clearance = task.roughing.clearance;
    let profile = task.profile(clearance, clearance);
    for (index, piece) in profile.iter().enumerate() {
        if index == 0 {
            sheet.rapid(piece.from);
        }
        sheet.go(*piece, Pace::Contour);
    }
    sheet.line(&words.filled(Use::ContourEnds, &[("number", number_of.clone())]));
    let fields = cycles.filled(task, &number_of, &setting.feeds);
    let fields: Vec<String> = fields.into_iter().map(|(name, value)| format!("{name}{value}")).collect();
    let call = format!("F{}\n{} {}\n", number(setting.feeds.cut.0, 4), cycles.code(task), fields.join(" "));
    Ok(CycleCall { before: sheet.finish(), call, file: None })
}
