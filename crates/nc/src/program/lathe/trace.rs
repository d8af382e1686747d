//! The trace of a program of a lathe: one line per motion, X as a diameter as turners read it.

use super::block::shown;
use super::motion::{LatheAct, LatheFeed, LatheMotion, LathePlace, LatheSpeed};
use crate::motion::{Sense, Turning};

/// A place as traces write it: `Ø57 Z-2`; an axis that is not known is left out.
fn place(at: LathePlace) -> String {
    let x = at.radius_mm.map(|radius| format!("Ø{}", shown(radius * 2.0)));
    let z = at.z_mm.map(|z| format!("Z{}", shown(z)));
    x.into_iter().chain(z).collect::<Vec<_>>().join(" ")
}

fn feed(feed: LatheFeed, word: &dyn Fn(&'static str) -> &'static str) -> String {
    match feed {
        LatheFeed::PerRevolution(feed) => format!("F{}", shown(feed.0)),
        LatheFeed::PerMinute(feed) => format!("F{}/{}", shown(feed.0), word("min")),
    }
}

/// The line of a motion, with its words in a language.
pub fn line_in(motion: &LatheMotion, word: &dyn Fn(&'static str) -> &'static str) -> String {
    let (name, more) = match motion.act {
        LatheAct::Rapid => ("rapid", String::new()),
        LatheAct::Away => ("away", String::new()),
        LatheAct::Feed { feed: at } => ("feed", feed(at, word)),
        LatheAct::Arc { feed: at, centre, sense } => {
            let name = if sense == Sense::Clockwise { "arc-cw" } else { "arc-ccw" };
            (name, format!("{} {} {}", word("centre"), place(centre.into()), feed(at, word)))
        }
        LatheAct::Thread { lead, .. } => ("thread", format!("{} {}", word("lead"), shown(lead.0))),
        LatheAct::Dwell { seconds } => ("dwell", format!("{} {}", shown(seconds.0), word("s"))),
        LatheAct::Spindle => ("spindle", spindle(motion, word)),
        LatheAct::ToolChange => {
            let shown = motion.modes.tool.map(|tool| {
                let offset = tool.offset.map(|offset| format!(" D{offset}")).unwrap_or_default();
                format!("T{}{offset}", tool.number)
            });
            ("tool", shown.unwrap_or_default())
        }
        LatheAct::Coolant => ("coolant", word(if motion.modes.coolant { "on" } else { "off" }).to_owned()),
        LatheAct::Stop => ("stop", String::new()),
        LatheAct::End => ("end", String::new()),
    };
    let at = if motion.act.moves() { place(motion.to) } else { String::new() };
    let mut line = format!("{:>4} {:<9}", motion.line, word(name));
    for part in [at, more].into_iter().filter(|part| !part.is_empty()) {
        line.push(' ');
        line.push_str(&part);
    }
    line.truncate(line.trim_end().len());
    line
}

fn spindle(motion: &LatheMotion, word: &dyn Fn(&'static str) -> &'static str) -> String {
    let sense = match motion.modes.turning {
        Turning::Stopped => return word("stopped").to_owned(),
        Turning::Clockwise => word("clockwise"),
        Turning::Counterclockwise => word("counterclockwise"),
    };
    match motion.modes.speed {
        None => sense.to_owned(),
        Some(LatheSpeed::Spindle(speed)) => format!("{sense} S{}", shown(speed.0)),
        Some(LatheSpeed::Cutting { speed, limit }) => {
            let limit = limit.map(|limit| format!(" ≤ S{}", shown(limit.0))).unwrap_or_default();
            format!("{sense} v{}{limit}", shown(speed.0))
        }
    }
}
