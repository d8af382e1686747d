//! Set-ups that cannot be proven.

use crate::note::Note;
use crate::set_up::SetUp;
use crate::tool::{Cutter, Holder, Tool};
use crate::units::{At, Block, Mm};

/// Why a set-up cannot be proven.
#[derive(Clone, Debug, PartialEq)]
pub enum Refused {
    /// There is no outer contour.
    NoContour,
    /// A motion names a missing tool.
    NoTool {
        /// Its block.
        block: Block,
    },
    /// A coordinate is no number, or farther away than any part.
    Place {
        /// The largest distance permitted.
        limit: Mm,
    },
    /// A tool has a length or an angle that no tool has.
    Tool {
        /// Its designation.
        tool: String,
    },
}

impl Refused {
    /// The sentence.
    pub fn note(&self) -> Note {
        match self {
            Self::NoContour => Note::new("swept-no-contour"),
            Self::NoTool { block } => Note::new("swept-no-tool").with("block", block),
            Self::Place { limit } => Note::new("swept-far").with("limit", limit),
            Self::Tool { tool } => Note::new("swept-tool").with("tool", tool),
        }
    }
}

/// The farthest place, mm: with tools, the range of the grid of regions.
const LIMIT: f64 = 5000.0;
/// The largest tool, mm.
const LARGEST: f64 = 500.0;

pub fn check(set_up: &SetUp) -> Result<(), Refused> {
    if set_up.profile.outside.is_empty() {
        return Err(Refused::NoContour);
    }
    if let Some(motion) = set_up.motions.iter().find(|motion| motion.tool >= set_up.tools.len()) {
        return Err(Refused::NoTool { block: motion.block });
    }
    let pieces = || set_up.profile.outside.iter().chain(&set_up.profile.bore);
    let threads = pieces().filter_map(|piece| piece.thread);
    let threads = threads.flat_map(|thread| [thread.crest, thread.root, thread.run_out]);
    let lengths = pieces().map(|piece| piece.allowance).chain(threads);
    let motions = set_up.motions.iter().flat_map(|motion| motion.path.places());
    let bodies = set_up.bodies.iter().flat_map(|body| body.outline.iter().copied());
    let stock = set_up.stock.0.window();
    let stock = [stock.least, stock.most].map(At::of).into_iter().filter(|_| !set_up.stock.0.is_empty());
    let places = pieces().flat_map(|piece| piece.path.places()).chain(motions).chain(bodies).chain(stock);
    let all = places.flat_map(|at| [at.z, at.radius]).chain(lengths);
    if !all.into_iter().all(|length| length.0.abs() <= LIMIT) {
        return Err(Refused::Place { limit: Mm(LIMIT) });
    }
    match set_up.tools.iter().find(|tool| !is_possible(tool)) {
        Some(tool) => Err(Refused::Tool { tool: tool.designation.clone() }),
        None => Ok(()),
    }
}

/// Whether lengths are possible and the edges of the insert meet in a point.
fn is_possible(tool: &Tool) -> bool {
    let lengths = |lengths: &[Mm]| lengths.iter().all(|length| length.0 > 0.0 && length.0 <= LARGEST);
    let point = |angle: f64| angle > 0.0 && angle < 180.0;
    let not_negative = |length: Mm| length.0 >= 0.0 && length.0 <= LARGEST;
    let cutter = match tool.cutter {
        Cutter::Insert { lead_angle, trail_angle, nose_radius, edge_length, .. } => {
            let angles = lead_angle.0 > 0.0 && trail_angle.0 >= 0.0 && point(180.0 - lead_angle.0 - trail_angle.0);
            angles && not_negative(nose_radius) && lengths(&[edge_length])
        }
        Cutter::Blade { width, corner_radius, depth, .. } | Cutter::FaceBlade { width, corner_radius, depth } => {
            not_negative(corner_radius) && lengths(&[width, depth])
        }
        Cutter::Thread { angle, reach, beside, .. } => point(angle.0) && lengths(&[reach, beside]),
        Cutter::Drill { diameter, point_angle, flute } => {
            point_angle.0 > 0.0 && point_angle.0 <= 180.0 && lengths(&[diameter, flute])
        }
        Cutter::Reamer { diameter, front, lead, reach } => {
            lengths(&[diameter, front, lead, reach]) && front.0 <= diameter.0 && lead.0 <= reach.0
        }
        Cutter::Tap { diameter, pitch, core, lead, thread, neck, shank, free } => {
            let ordered = core.0 <= diameter.0 && lead.0 <= thread.0 && thread.0 <= neck.0 && neck.0 <= free.0;
            ordered && lengths(&[diameter, pitch, core, lead, thread, neck, shank, free])
        }
        Cutter::CentreDrill { pilot, pilot_length, body } => lengths(&[pilot, pilot_length, body]),
    };
    let holder = match tool.holder {
        Holder::None => true,
        Holder::Shank { width, set_back } => lengths(&[width]) && set_back.0.abs() <= LARGEST,
        Holder::Bar { diameter, stands_out } => lengths(&[diameter]) && stands_out.0.abs() <= LARGEST,
    };
    cutter && holder
}
