//! The trace of a program: one line per step, in a fixed, language-independent form.
//!
//! A line is `line block motion position details`. The position names every axis, so that two traces can be compared
//! line by line.

use std::fmt::Write;

use super::{Motion, MotionStep, Position, Sense, Side, Sink, Turning};
use crate::units::{Decimal, MillimetresPerMinute};

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
        put(&mut self.text, step);
        self.text.push('\n');
    }
}

/// A position as traces write it: `X10 Y-5.5 Z0`.
pub fn position(at: Position) -> String {
    format!("X{} Y{} Z{}", at.x, at.y, at.z)
}

/// A step as a line without its end.
pub fn line(step: &MotionStep) -> String {
    let mut text = String::new();
    put(&mut text, step);
    text
}

/// Puts the line of a step behind a text. A full memory of the control makes thousands of them, so nothing is made
/// beside that text; writing into a String cannot fail.
fn put(text: &mut String, step: &MotionStep) {
    let line = step.block.line;
    text.push_str(match line {
        0..10 => "   ",
        10..100 => "  ",
        100..1000 => " ",
        _ => "",
    });
    whole(text, line);
    text.push(' ');
    let begin = text.len();
    match step.block.number {
        Some(number) => {
            text.push('N');
            whole(text, number);
        }
        None => text.push('-'),
    }
    for _ in text.len()..(begin + 6) {
        text.push(' ');
    }
    let _ = match &step.motion {
        Motion::Rapid => {
            text.push_str("rapid   ");
            axes(text, step.at);
            Ok(())
        }
        Motion::Feed { feed_mm_per_min } => {
            text.push_str("feed    ");
            axes(text, step.at);
            feed(text, *feed_mm_per_min);
            Ok(())
        }
        Motion::Arc { plane, sense, centre, turns, feed_mm_per_min } => {
            text.push_str(match sense {
                Sense::Clockwise => "arc-cw  ",
                Sense::Counterclockwise => "arc-ccw ",
            });
            let [a, b, _] = plane.axes();
            axes(text, step.at);
            let _ = write!(text, " centre {}{} {}{}", a.letter(), centre[0], b.letter(), centre[1]);
            if *turns > 0 {
                let _ = write!(text, " turns +{turns}");
            }
            feed(text, *feed_mm_per_min);
            Ok(())
        }
        Motion::Dwell { seconds } => write!(text, "dwell   {seconds} s"),
        Motion::Spindle { turning, speed_rpm } => match turning {
            Turning::Stopped => write!(text, "spindle stopped"),
            Turning::Clockwise => write!(text, "spindle clockwise S{}", speed_rpm.rounded(1).0),
            Turning::Counterclockwise => write!(text, "spindle counterclockwise S{}", speed_rpm.rounded(1).0),
        },
        Motion::Coolant { on } => write!(text, "coolant {}", if *on { "on" } else { "off" }),
        Motion::ToolChange { tool } => write!(text, "tool    T{tool} ").map(|()| axes(text, step.at)),
        Motion::LengthCorrection { axis, corrector, value } => {
            write!(text, "length  H{corrector} {}{value}", axis.letter())
        }
        Motion::RadiusCorrection { side, corrector, value } => match side {
            Side::Off => write!(text, "radius  off"),
            Side::Left => write!(text, "radius  left D{corrector} {value}"),
            Side::Right => write!(text, "radius  right D{corrector} {value}"),
        },
        Motion::Auxiliary { word } => write!(text, "machine {word}"),
        Motion::Stop { optional } => write!(text, "stop{}", if *optional { " optional" } else { "" }),
        Motion::End => {
            text.push_str("end     ");
            axes(text, step.at);
            Ok(())
        }
    };
}

fn axes(text: &mut String, at: Position) {
    for (letter, value) in [("X", at.x), (" Y", at.y), (" Z", at.z)] {
        text.push_str(letter);
        value.put(text);
    }
}

/// A feed to three places, as programs give it.
fn feed(text: &mut String, feed: MillimetresPerMinute) {
    text.push_str(" F");
    Decimal::from_f64_rounded(feed.rounded(3).0).put(text);
}

fn whole(text: &mut String, number: u32) {
    Decimal::from_int(i64::from(number)).put(text);
}
