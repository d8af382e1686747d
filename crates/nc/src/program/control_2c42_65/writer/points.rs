//! The path over the points of one cycle: positions, or increments where equal steps follow each other and L repeats
//! them.

use crate::job::{Cycle, CycleKind, ToolWork};
use crate::part::Point;
use crate::units::Micrometres;

use crate::program::block::Block;
use crate::program::written::Form;

/// Successive points with the same cycle.
pub(super) struct PointRun {
    /// The cycle, by its place in the work.
    pub cycle: usize,
    /// The first point, on the grid.
    pub first: Point,
    /// The last point, where the tool is afterwards.
    pub last: Point,
    /// Whether `blocks` are increments (G91) and not positions.
    pub incremental: bool,
    /// A block for each further point, or for a row of them.
    pub blocks: Vec<Block>,
}

/// A section of the path.
pub(super) enum Repeat {
    /// A block.
    Once(Block),
    /// Blocks that are run several times.
    Times(Vec<Block>, usize),
}

/// The characters of a block besides its words: its number and its end.
const FRAME: usize = 6;
/// The characters of a subprogram besides its blocks: its number, its end, and the call.
const SUBPROGRAM: usize = 22;

/// Whether it is a cycle of the control, which runs at every point until it is cancelled.
pub(super) const fn is_fixed(cycle: &Cycle) -> bool {
    !matches!(cycle.kind, CycleKind::Circles { .. } | CycleKind::Slot(_))
}

/// The runs of a tool, in order.
pub(super) fn runs(work: &ToolWork, form: Form) -> Vec<PointRun> {
    let stops = work.stops.chunk_by(|a, b| a.cycle == b.cycle);
    stops
        .filter_map(|stops| {
            let points: Vec<Point> = stops.iter().map(|stop| form.point(stop.at)).collect();
            let cycle = stops.first()?.cycle;
            // The contour of a mill is called at each point, so nothing repeats.
            let fixed = is_fixed(work.cycles.get(cycle)?);
            let (positions, ways) = (positions(&points), ways(&points));
            // Positions are easier to read: increments are used where rows make the program a fifth shorter.
            let incremental = fixed && length(&ways) * 5 < length(&positions) * 4;
            let blocks = if incremental { ways } else { positions };
            Some(PointRun { cycle, first: *points.first()?, last: *points.last()?, incremental, blocks })
        })
        .collect()
}

/// The number of characters of a path, with the saving of repeats.
fn length(blocks: &[Block]) -> usize {
    repeats(blocks)
        .iter()
        .map(|piece| match piece {
            Repeat::Once(block) => cost(block),
            Repeat::Times(blocks, _) => blocks.iter().map(cost).sum::<usize>() + SUBPROGRAM,
        })
        .sum()
}

fn cost(block: &Block) -> usize {
    block.text().len() + FRAME
}

/// A block for each point after the first, with the axes that change. A repeated point is written, because its cycle
/// would not run otherwise.
fn positions(points: &[Point]) -> Vec<Block> {
    points
        .windows(2)
        .map(|pair| {
            let (from, to) = (pair[0], pair[1]);
            match (from.x == to.x, from.y == to.y) {
                (true, true) => Block::new().axis('X', to.x),
                (true, false) => Block::new().axis('Y', to.y),
                (false, true) => Block::new().axis('X', to.x),
                (false, false) => Block::new().axis('X', to.x).axis('Y', to.y),
            }
        })
        .collect()
}

/// The same as increments; equal successive ones are one block with L.
fn ways(points: &[Point]) -> Vec<Block> {
    let steps: Vec<(Micrometres, Micrometres)> =
        points.windows(2).map(|pair| (pair[1].x - pair[0].x, pair[1].y - pair[0].y)).collect();
    let row = |steps: &[(Micrometres, Micrometres)]| {
        let (x, y) = steps[0];
        let zero = Micrometres::ZERO;
        let mut block = Block::new();
        if x != zero || y == zero {
            block = block.axis('X', x);
        }
        if y != zero {
            block = block.axis('Y', y);
        }
        if steps.len() > 1 { block.word('L', steps.len()) } else { block }
    };
    steps.chunk_by(|a, b| a == b).map(row).collect()
}

/// Replaces repeated groups of blocks where a subprogram with L is shorter. Positions rarely repeat, but the same
/// rule applies to them.
pub(super) fn repeats(blocks: &[Block]) -> Vec<Repeat> {
    let mut pieces = Vec::new();
    let mut at = 0;
    while at < blocks.len() {
        match best_repeat(&blocks[at..]) {
            Some((period, times)) => {
                pieces.push(Repeat::Times(blocks[at..at + period].to_vec(), times));
                at += period * times;
            }
            None => {
                pieces.push(Repeat::Once(blocks[at].clone()));
                at += 1;
            }
        }
    }
    pieces
}

/// The longest group that is tried: a row, the step to the next, the row back, and the step.
const LONGEST_PERIOD: usize = 8;

/// The group of next blocks that saves most when repeated: its number of blocks and of repeats.
fn best_repeat(blocks: &[Block]) -> Option<(usize, usize)> {
    (1..=LONGEST_PERIOD.min(blocks.len() / 2))
        .filter_map(|period| {
            let group = &blocks[..period];
            let times = blocks.chunks_exact(period).take_while(|next| *next == group).count();
            let once: usize = group.iter().map(cost).sum();
            let saved = (once * times).checked_sub(once + SUBPROGRAM).filter(|saved| times > 1 && *saved > 0)?;
            Some((saved, period, times))
        })
        .max_by_key(|(saved, period, _)| (*saved, std::cmp::Reverse(*period)))
        .map(|(_, period, times)| (period, times))
}

/// Whether blocks that occur at several places are shorter as a subprogram.
pub(super) fn worth_sharing(blocks: &[Block], places: usize) -> bool {
    let once: usize = blocks.iter().map(cost).sum();
    let call = FRAME + 3;
    places > 1 && once + SUBPROGRAM + call * places < once * places
}
