//! Sinumerik: CYCLE95 with the contour in a subprogram, in a file of its own.

use crate::turning::contour::Piece;
use crate::turning::length::Half;

use super::call::Cycles;
use super::cycle::{CycleCall, CycleTask, ProgramFile};
use super::refused::NotWritten;
use super::setting::Setting;
use super::text::{Pace, ProgramWriter};
use super::words::Use;
use super::{Control, file_name};

/// The call of a cycle with its contour, which is contour number `index` of the program.
///
/// The contour begins on the face of the blank and ends on its surface, because the cycle assumes that the stock
/// extends as far as the contour. The cycle computes its own start point, to which the tool must be able to move from
/// its current position.
pub(super) fn write(
    control: &Control,
    cycles: &Cycles,
    task: &CycleTask<'_>,
    setting: &Setting,
    index: usize,
) -> Result<CycleCall, NotWritten> {
    let words = control.words()?;
    let name = file_name(&setting.name);
    let contour = if index == 0 { format!("{name}_K") } else { format!("{name}_K{index}") };
    let fields = cycles.filled(task, &format!("\"{contour}\""), &setting.feeds);
    let fields: Vec<String> = fields.into_iter().map(|(_, value)| value).collect();
    let call = format!("{}({})\n", cycles.code(task), fields.join(", "));
    let mut sheet = ProgramWriter::new(words);
    let profile = task.profile(Half::ZERO, Half::ZERO);
    for (index, piece) in profile.iter().enumerate() {
        if index == 0 {
            sheet.go(Piece::line(piece.from, piece.from), Pace::Contour);
        }
        sheet.go(*piece, Pace::Contour);
    }
    sheet.put(&[Use::ContourEnds]);
    let file = ProgramFile { name: format!("{contour}.SPF"), text: sheet.finish() };
    Ok(CycleCall { before: String::new(), call, file: Some(file) })
}
