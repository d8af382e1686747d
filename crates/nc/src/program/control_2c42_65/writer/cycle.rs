//! The blocks of one cycle: G81…G86 with their parameters, or the contour of a mill.

use std::fmt::Write;

use crate::job::{Cycle, CycleKind, SlotCycle, SlotMotion};
use crate::motion::Sense;
use crate::units::{Micrometres, MillimetresPerMinute, Seconds};

use super::program_writer::{BlockGroup, BlockPurpose, ProgramWriter};
use crate::program::block::Block;
use crate::program::written::Form;

/// A fixed cycle. In absolute form U, Z, I are levels; in incremental form they are the travels 0-1, 1-2 and 2-4
/// (table 3.10), and the tool is at level I before.
pub(super) fn fixed(cycle: &Cycle, incremental: bool, form: Form) -> Block {
    let (begin, end, out) = (form.grid(cycle.begin), form.grid(cycle.end), form.grid(cycle.out));
    let [u, z, i] = if incremental { [begin - out, end - begin, out - end] } else { [begin, end, out] };
    let (code, steps) = match &cycle.kind {
        CycleKind::FeedOut => (82, None),
        CycleKind::BoreStop => (85, None),
        CycleKind::Peck { step, clearance } => (83, Some((*step, *clearance))),
        CycleKind::ChipBreak { step, retreat } => (86, Some((*step, *retreat))),
        CycleKind::Tap { .. } => (84, None),
        // Milled circles and slots are no fixed cycles: `contour` and `slot` write them.
        CycleKind::Drill | CycleKind::Circles { .. } | CycleKind::Slot(_) => (81, None),
    };
    let mut text = format!("G{code} U{u} Z{z} I{i}");
    // Writing to a text cannot fail.
    if let Some((step, clearance)) = steps {
        let _ =
            write!(text, " V{} W{}", form.grid(step).max(form.resolution), form.grid(clearance).max(form.resolution));
    }
    let _ = write!(text, " F{}", cycle.feed_mm_per_min.0);
    if let Some(dwell) = cycle.dwell_s {
        let _ = write!(text, " E{}", tenths(dwell));
    }
    let block = if incremental { Block::new().g(91) } else { Block::new().g(90) };
    block.cycle(text)
}

/// E counts tenths of a second (3.10.6).
fn tenths(dwell: Seconds) -> u64 {
    libm::round(dwell.0 * 10.0) as u64
}

/// The contour of a mill around its point: down to a level, out to each circle and round, and back to the middle;
/// with several levels the circles are a subprogram.
pub(super) fn contour(
    cycle: &Cycle,
    (levels, radii, sense): (&[Micrometres], &[Micrometres], Sense),
    plunge: Option<MillimetresPerMinute>,
    sheet: &mut ProgramWriter,
    place: BlockPurpose,
) -> BlockGroup {
    let form = sheet.form;
    let feed = cycle.feed_mm_per_min.0;
    let mut blocks = vec![Block::new().g(90).g(0).axis('Z', form.grid(cycle.begin))];
    let round = circles(radii, sense, form, plunge.map(|_| feed));
    let rounds = (levels.len() > 1).then(|| sheet.subprogram(round.clone(), place));
    for (index, level) in levels.iter().enumerate() {
        let down = Block::new().g(90).g(1).axis('Z', form.grid(*level));
        // The circles set their own feed after the descent.
        let down = match plunge {
            Some(plunge) => down.word('F', plunge.0),
            None if index == 0 => down.word('F', feed),
            None => down,
        };
        match rounds.as_ref().and_then(BlockGroup::number) {
            Some(number) => blocks.push(down.calls(number, 1)),
            None => {
                blocks.push(down);
                blocks.extend(round.iter().cloned());
            }
        }
    }
    blocks.push(Block::new().g(90).g(0).axis('Z', form.grid(cycle.out)));
    sheet.subprogram(blocks, place)
}

/// The circles of one level, in increments from the middle and back to it; the feed, where the descent had another.
fn circles(radii: &[Micrometres], sense: Sense, form: Form, mut feed: Option<f64>) -> Vec<Block> {
    let code = match sense {
        Sense::Clockwise => 2,
        Sense::Counterclockwise => 3,
    };
    let mut blocks = Vec::new();
    let mut at = Micrometres::ZERO;
    for radius in radii.iter().map(|radius| form.grid(*radius)) {
        let out = Block::new().g(91).g(1).axis('X', radius - at);
        blocks.push(match feed.take() {
            Some(feed) => out.word('F', feed),
            None => out,
        });
        blocks.push(Block::new().g(code).axis('I', -radius).axis('J', Micrometres::ZERO));
        at = radius;
    }
    blocks.push(Block::new().g(1).axis('X', -at));
    blocks
}

/// The way of a mill through a slot, in increments from its point.
pub(super) fn slot(cycle: &Cycle, slot: &SlotCycle, sheet: &mut ProgramWriter, place: BlockPurpose) -> BlockGroup {
    let form = sheet.form;
    let code = match slot.sense {
        Sense::Clockwise => 2,
        Sense::Counterclockwise => 3,
    };
    let mut blocks = vec![Block::new().g(90).g(0).axis('Z', form.grid(cycle.begin))];
    let (mut at, mut fed) = ([Micrometres::ZERO; 2], None);
    for made in Cycle::slot_path(slot, form.resolution) {
        let step = |block: Block| block.axis('X', made.to[0] - at[0]).axis('Y', made.to[1] - at[1]);
        let block = match made.motion {
            SlotMotion::Down(level) => Block::new().g(90).g(1).axis('Z', level),
            SlotMotion::Across => step(Block::new().g(91).g(1)),
            SlotMotion::Arc(centre, _) => {
                step(Block::new().g(91).g(code)).axis('I', centre[0] - at[0]).axis('J', centre[1] - at[1])
            }
        };
        let feed = slot.feed_of(made, cycle.feed_mm_per_min).0;
        blocks.push(if fed == Some(feed) { block } else { block.word('F', feed) });
        (at, fed) = (made.to, Some(feed));
    }
    blocks.push(Block::new().g(90).g(0).axis('Z', form.grid(cycle.out)));
    sheet.subprogram(blocks, place)
}
