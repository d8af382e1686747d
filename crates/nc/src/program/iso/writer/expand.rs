//! A cycle of a job in single motions, for controls that have no fixed cycles.

use crate::job::{Cycle, CycleKind};
use crate::program::block::Block;
use crate::program::written::Form;
use crate::units::Micrometres;

use super::dialect::Dialect;

/// The motions of a cycle at a point, from over it and back to there: what the fixed cycle of another control does.
///
/// ```text
/// out      rapid down to begin
/// begin    feed, at once or in steps: out to begin (peck) or a little back (chip-break) after each, at rapid
/// end      the dwell; the spindle of a boring bar stops
/// out      at rapid; at feed as far as begin where the cycle goes out so
/// ```
///
/// A tap needs a spindle that goes with the feed: the caller has left it out of the job (`Control::taps`).
pub(super) fn expand(cycle: &Cycle, form: Form, dialect: Dialect<'_>) -> Vec<Block> {
    let level = |z: Micrometres| dialect.length(form.grid(z));
    let rapid = |z: Micrometres| Block::new().g(0).word('Z', level(z));
    let feed = |z: Micrometres| Block::new().g(1).word('Z', level(z)).word('F', dialect.feed(cycle.feed_mm_per_min));
    let mut blocks = vec![rapid(cycle.begin)];
    // Back to where the next step begins, behind each step.
    let steps = match &cycle.kind {
        CycleKind::Peck { step, clearance } => Some((*step, *clearance, true)),
        CycleKind::ChipBreak { step, retreat } => Some((*step, *retreat, false)),
        _ => None,
    };
    if let Some((step, back, leaves)) = steps.filter(|(step, ..)| form.grid(*step) > Micrometres::ZERO) {
        let step = form.grid(step);
        let mut depth = form.grid(cycle.begin) - step;
        while depth > form.grid(cycle.end) {
            blocks.push(feed(depth));
            if leaves {
                blocks.push(rapid(cycle.begin));
            }
            blocks.push(rapid(depth + form.grid(back)));
            depth = depth - step;
        }
    }
    blocks.push(feed(cycle.end));
    if let Some(time) = cycle.dwell_s {
        blocks.push(Block::new().g(4).word('P', dialect.dwell(time)));
    }
    let stops = matches!(cycle.kind, CycleKind::BoreStop);
    if stops {
        blocks.push(Block::new().m(5));
    }
    if matches!(cycle.kind, CycleKind::FeedOut) {
        blocks.push(feed(cycle.begin));
    }
    blocks.push(rapid(cycle.out));
    if stops {
        blocks.push(Block::new().word('S', cycle.speed_rpm.0).m(3));
    }
    blocks
}
