//! The trace of a program: one line per step, in words that are the same in every language.
//!
//! A line is `line block motion position details`. The position names every axis, so that two traces can be compared
//! line by line.

use std::fmt::Write;

use super::{Axis, Motion, Position, Sense, Side, Sink, Step, Turning};

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
    fn take(&mut self, step: &Step) {
        self.text.push_str(&line(step));
        self.text.push('\n');
    }
}

/// A position as traces write it: `X10 Y-5.5 Z0`.
pub fn position(at: Position) -> String {
    let [x, y, z] = Axis::ALL.map(|axis| at.get(axis));
    format!("X{x} Y{y} Z{z}")
}

/// A step as a line without its end.
pub fn line(step: &Step) -> String {
    let mut text = format!("{:>4} ", step.block.line);
    // Writing into a String cannot fail.
    let _ = match step.block.number {
        Some(number) => write!(text, "{:<6}", format!("N{number}")),
        None => write!(text, "{:<6}", "-"),
    };
    let at = position(step.at);
    let _ = match &step.motion {
        Motion::Rapid => write!(text, "rapid   {at}"),
        Motion::Feed { feed_mm_per_min } => write!(text, "feed    {at} F{}", feed_mm_per_min.rounded(3).0),
        Motion::Arc { plane, sense, centre, turns, feed_mm_per_min } => {
            let name = match sense {
                Sense::Clockwise => "arc-cw ",
                Sense::Counterclockwise => "arc-ccw",
            };
            let [a, b, _] = plane.axes();
            let more = if *turns == 0 { String::new() } else { format!(" turns +{turns}") };
            write!(
                text,
                "{name} {at} centre {}{} {}{}{more} F{}",
                a.letter(),
                centre[0],
                b.letter(),
                centre[1],
                feed_mm_per_min.rounded(3).0
            )
        }
        Motion::Dwell { seconds } => write!(text, "dwell   {seconds} s"),
        Motion::Spindle { turning, speed_rpm } => match turning {
            Turning::Stopped => write!(text, "spindle stopped"),
            Turning::Clockwise => write!(text, "spindle clockwise S{}", speed_rpm.rounded(1).0),
            Turning::Counterclockwise => write!(text, "spindle counterclockwise S{}", speed_rpm.rounded(1).0),
        },
        Motion::Coolant { on } => write!(text, "coolant {}", if *on { "on" } else { "off" }),
        Motion::ToolChange { tool } => write!(text, "tool    T{tool} {at}"),
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
        Motion::End => write!(text, "end     {at}"),
    };
    text
}
