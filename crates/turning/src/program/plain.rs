//! A toolpath as a program of single moves: G0, G1, G2, G3.

use crate::turning::contour::Curve;
use crate::turning::toolpath::Toolpath;
use technolog_core::ascii::ascii;

use super::Control;
use super::refused::{NotWritten, check_arc};
use super::setting::{Setting, Speed};
use super::text::{Pace, ProgramWriter, number};
use super::whole::Seat;
use super::words::{ControlWords, Use};

/// The program of a toolpath on a control.
///
/// # Errors
/// The reason why it cannot be written.
pub fn plain(control: &Control, path: &Toolpath, setting: &Setting) -> Result<String, NotWritten> {
    let words = control.words()?;
    setting.check()?;
    if path.moves.is_empty() {
        return Err(NotWritten::EmptyWay);
    }
    for (number, (piece, purpose)) in (1..).zip(path.pieces()) {
        check_arc(piece, number)?;
        if setting.feeds.of(purpose).is_none() && piece.curve != Curve::Line {
            return Err(NotWritten::RapidArc { piece: number });
        }
    }
    let mut sheet = ProgramWriter::new(words);
    begin(&mut sheet, control, setting)?;
    sheet.rapid(path.from);
    for (piece, purpose) in path.pieces() {
        sheet.go(piece, setting.feeds.of(purpose).map_or(Pace::Rapid, Pace::Feed));
    }
    end(&mut sheet);
    Ok(sheet.finish())
}

/// The beginning of every program: the modes, the tool, the spindle, the coolant.
pub(super) fn begin(sheet: &mut ProgramWriter<'_>, control: &Control, setting: &Setting) -> Result<(), NotWritten> {
    let words = control.words()?;
    modes(sheet, &setting.name);
    sheet.line(&words.tool(Seat::only(setting.tool)));
    sheet.lines(&spindle(words, setting.speed));
    if setting.coolant {
        sheet.put(&[Use::CoolantOn]);
    }
    Ok(())
}

/// The name, and every mode that could be left over from another program.
pub(super) fn modes(sheet: &mut ProgramWriter<'_>, name: &str) {
    sheet.put(&[Use::ProgramBegins]);
    sheet.comment(&ascii(name));
    sheet.put(&[
        Use::Plane,
        Use::Millimetres,
        Use::Diameters,
        Use::RadiusCorrectionOff,
        Use::Absolute,
        Use::FeedPerRevolution,
    ]);
    sheet.put(&[Use::System, Use::ExactPath]);
}

/// The rotation of the spindle.
pub(super) fn spindle(words: &ControlWords, speed: Speed) -> String {
    match speed {
        Speed::Cutting { speed, limit } => {
            let values = [("speed", number(speed.0, 1)), ("limit", number(limit.0, 1))];
            [Use::SpeedLimit, Use::CuttingSpeed].map(|one| words.filled(one, &values)).join("\n")
        }
        Speed::Spindle(speed) => words.filled(Use::SpindleSpeed, &[("speed", number(speed.0, 1))]),
    }
}

/// The end of every program; the coolant is stopped even if this program did not start it.
pub(super) fn end(sheet: &mut ProgramWriter<'_>) {
    sheet.put(&[Use::SpindleStop]);
    sheet.put(&[Use::CoolantOff]);
    sheet.put(&[Use::End]);
}
