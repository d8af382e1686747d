//! The trace of a program: one line per step, in a fixed, language-independent form.
//!
//! A line is `line block motion position details`. The position names every axis, so that two traces can be compared
//! line by line.

use std::fmt::Write;

use super::{Motion, MotionStep, Position, Sense, Side, Sink, Turning};
use crate::units::{Decimal, MillimetresPerMinute};

/// How wide the column of motions is: the longest of them and a space.
const KIND_WIDTH: usize = 8;

/// A sink that writes lines.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    text: String,
}

impl Trace {
    /// The lines so far.
    pub fn text(&self) -> &str {
        &self.text
    }
}

impl Sink for Trace {
    fn take(&mut self, step: &MotionStep) {
        push_step(&mut self.text, step, &|word| word);
        self.text.push('\n');
    }
}

/// A position as traces write it: `X10 Y-5.5 Z0`.
pub fn position(at: Position) -> String {
    format!("X{} Y{} Z{}", at.x, at.y, at.z)
}

/// A step as a line without its end.
pub fn line(step: &MotionStep) -> String {
    line_in(step, &|word| word)
}

/// The line of a step with its words, `rapid` and `centre`, in another language.
pub fn line_in(step: &MotionStep, word: &dyn Fn(&'static str) -> &'static str) -> String {
    let mut text = String::new();
    push_step(&mut text, step, word);
    text
}

/// Appends the line of a step to a text. A full memory of the control gives thousands of lines, so there are no other
/// allocations; writing into a String cannot fail.
fn push_step(text: &mut String, step: &MotionStep, word: &dyn Fn(&'static str) -> &'static str) {
    let line = step.block.line;
    text.push_str(match line {
        0..10 => "   ",
        10..100 => "  ",
        100..1000 => " ",
        _ => "",
    });
    push_integer(text, line);
    text.push(' ');
    let begin = text.len();
    match step.block.number {
        Some(number) => {
            text.push('N');
            push_integer(text, number);
        }
        None => text.push('-'),
    }
    for _ in text.len()..(begin + 6) {
        text.push(' ');
    }
    // A stop has no figures and is one phrase: `stop optional`.
    let width = if matches!(step.motion, Motion::Stop { .. }) { 0 } else { KIND_WIDTH };
    let name = word(name(&step.motion));
    text.push_str(name);
    text.extend(std::iter::repeat_n(' ', width.saturating_sub(name.chars().count()).max(1)));
    let _ = match &step.motion {
        Motion::Rapid | Motion::End => {
            axes(text, step.at);
            Ok(())
        }
        Motion::Feed { feed_mm_per_min } => {
            axes(text, step.at);
            feed(text, *feed_mm_per_min);
            Ok(())
        }
        Motion::Arc { plane, centre, turns, feed_mm_per_min, .. } => {
            let [a, b, _] = plane.axes();
            axes(text, step.at);
            let _ = write!(text, " {} {}{} {}{}", word("centre"), a.letter(), centre[0], b.letter(), centre[1]);
            if *turns > 0 {
                let _ = write!(text, " {} +{turns}", word("turns"));
            }
            feed(text, *feed_mm_per_min);
            Ok(())
        }
        Motion::Dwell { seconds } => write!(text, "{seconds} {}", word("s")),
        Motion::Spindle { turning: Turning::Stopped, .. } => write!(text, "{}", word("stopped")),
        Motion::Spindle { turning, speed_rpm } => {
            let sense = if *turning == Turning::Clockwise { "clockwise" } else { "counterclockwise" };
            write!(text, "{} S{}", word(sense), speed_rpm.rounded(1).0)
        }
        Motion::Coolant { on } => write!(text, "{}", word(if *on { "on" } else { "off" })),
        Motion::ToolChange { tool } => write!(text, "T{tool} ").map(|()| axes(text, step.at)),
        Motion::LengthCorrection { axis, corrector: None, value } => write!(text, "{}{value}", axis.letter()),
        Motion::LengthCorrection { axis, corrector: Some(corrector), value } => {
            write!(text, "H{corrector} {}{value}", axis.letter())
        }
        Motion::RadiusCorrection { side: Side::Off, .. } => write!(text, "{}", word("off")),
        Motion::RadiusCorrection { side, corrector, value } => {
            let side = if *side == Side::Left { "left" } else { "right" };
            write!(text, "{} D{corrector} {value}", word(side))
        }
        Motion::Auxiliary { word } => write!(text, "{word}"),
        Motion::Stop { optional: true } => write!(text, "{}", word("optional")),
        Motion::Stop { optional: false } => Ok(()),
    };
    text.truncate(text.trim_end().len());
}

/// The word of a motion.
const fn name(motion: &Motion) -> &'static str {
    match motion {
        Motion::Rapid => "rapid",
        Motion::Feed { .. } => "feed",
        Motion::Arc { sense: Sense::Clockwise, .. } => "arc-cw",
        Motion::Arc { sense: Sense::Counterclockwise, .. } => "arc-ccw",
        Motion::Dwell { .. } => "dwell",
        Motion::Spindle { .. } => "spindle",
        Motion::Coolant { .. } => "coolant",
        Motion::ToolChange { .. } => "tool",
        Motion::LengthCorrection { .. } => "length",
        Motion::RadiusCorrection { .. } => "radius",
        Motion::Auxiliary { .. } => "machine",
        Motion::Stop { .. } => "stop",
        Motion::End => "end",
    }
}

fn axes(text: &mut String, at: Position) {
    for (letter, value) in [("X", at.x), (" Y", at.y), (" Z", at.z)] {
        text.push_str(letter);
        value.append_to(text);
    }
}

/// A feed to three places, as programs give it.
fn feed(text: &mut String, feed: MillimetresPerMinute) {
    text.push_str(" F");
    Decimal::from_f64_rounded(feed.rounded(3).0).append_to(text);
}

fn push_integer(text: &mut String, number: u32) {
    Decimal::from_int(i64::from(number)).append_to(text);
}
