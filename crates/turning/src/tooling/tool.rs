//! Turning tools, from the tables of `catalogs/tools/turning`.

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, RowRef};
use crate::tables::turning::jobs::{JobLimit, JobLimits};
use crate::tables::turning::tools::{TOOL_TABLES, TurningToolRow};
use crate::units::{Decimal, Micrometres};

pub use crate::tables::turning::tools::{Hand, Place, ToolKind};

/// The clamped part of a tool, which bends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shank {
    /// A square shank: its height is in the direction of the main force.
    Square {
        /// Height H.
        height: Micrometres,
        /// Width B.
        width: Micrometres,
    },
    /// A round bar.
    Round {
        /// Diameter d.
        diameter: Micrometres,
    },
}

/// A turning tool. Figures missing in its row are `None`.
#[derive(Clone, Debug)]
pub struct TurningTool<'k> {
    /// Its row.
    pub row: RowRef<'k>,
    /// Its designation, by which files name it.
    pub designation: &'k str,
    /// Its purpose.
    pub kind: ToolKind,
    /// The place where it works.
    pub works: Place,
    /// Its cutting direction.
    pub hand: Hand,
    /// φ, between the main edge and the feed along the axis, degrees.
    pub lead_angle: Decimal,
    /// φ1, between the secondary edge and the finished surface, degrees: the steepest fall of a contour behind the
    /// tip. φ1 = 180 − φ − ε with ε of the insert.
    pub trail_angle: Decimal,
    /// Nose radius r.
    pub nose_radius: Option<Micrometres>,
    /// The insert by ISO 1832.
    pub insert: Option<&'k str>,
    /// Length of the insert's edge.
    pub edge: Option<Micrometres>,
    /// Its shank or bar.
    pub shank: Option<Shank>,
    /// Whether its bar is of carbide, which bends a third as much as steel.
    pub carbide_bar: bool,
    /// Overhang from the holder, if its row has one; otherwise by `turning-limits`.
    pub reach: Option<Micrometres>,
    /// The smallest bore it enters.
    pub min_bore: Option<Micrometres>,
    /// Width of the blade of a grooving tool.
    pub width: Option<Micrometres>,
    /// The deepest groove.
    pub groove_depth: Option<Micrometres>,
    /// Whether a blade is made for grooves of its own width, as for retaining rings; elsewhere it comes after the others.
    pub own_width: bool,
    /// The smallest outer diameter of a groove in a face.
    pub face_diameter: Option<Micrometres>,
    /// Least and largest pitch of a threading tool.
    pub pitch: Option<(Micrometres, Micrometres)>,
    /// From the tip of a threading insert to its side, which stands upright towards the chuck.
    pub insert_side: Option<Micrometres>,
    /// Carbide grades of its inserts, in the names of `tool-material-factor`; empty if the row has none.
    pub grades: Vec<&'k str>,
}

impl<'k> TurningTool<'k> {
    /// Every turning tool, in the order of the tables.
    ///
    /// # Errors
    /// A table is missing, or a row lacks a required cell.
    pub fn all(knowledge: &'k Knowledge) -> Result<Vec<Self>, KnowledgeError> {
        let mut tools = Vec::new();
        let side = JobLimit::ThreadInsertSide;
        let side = knowledge.need(side.name(), |row: &JobLimits<'_>| row.name == side)?.length;
        for table in TOOL_TABLES {
            for row in knowledge.table(table)?.rows() {
                tools.push(Self::of(row?, side));
            }
        }
        Ok(tools)
    }

    /// The tool with a designation; spaces and the case of letters are ignored. None if there is none.
    ///
    /// # Errors
    /// As [`Self::all`].
    pub fn find(knowledge: &'k Knowledge, designation: &str) -> Result<Option<Self>, KnowledgeError> {
        let wanted = plain(designation);
        Ok(Self::all(knowledge)?.into_iter().find(|tool| plain(tool.designation) == wanted))
    }

    fn of(tool: TurningToolRow<'k>, side: Option<Micrometres>) -> Self {
        let round = tool.bar_diameter.map(|diameter| Shank::Round { diameter });
        let square = tool.shank_height.zip(tool.shank_width);
        Self {
            row: tool.row,
            designation: tool.designation,
            kind: tool.kind,
            works: tool.place_of_work,
            hand: tool.hand,
            lead_angle: Decimal::from_f64_rounded(tool.lead_angle.0),
            trail_angle: Decimal::from_f64_rounded(tool.trail_angle.0),
            nose_radius: tool.nose_radius,
            insert: tool.insert,
            edge: tool.edge,
            shank: round.or(square.map(|(height, width)| Shank::Square { height, width })),
            carbide_bar: tool.carbide_bar.unwrap_or_default(),
            reach: tool.reach,
            min_bore: tool.min_bore,
            width: tool.width,
            groove_depth: tool.groove_depth,
            own_width: tool.own_width.unwrap_or_default(),
            face_diameter: tool.face_diameter_min,
            pitch: tool.pitch_min.zip(tool.pitch_max),
            insert_side: tool.insert_side.or(side).filter(|_| tool.kind == ToolKind::Threading),
            grades: tool.grades.unwrap_or_default(),
        }
    }

    /// Whether it plunges into the metal, so that the width of its blade is the depth of cut.
    pub const fn plunges(&self) -> bool {
        matches!(self.kind, ToolKind::Grooving | ToolKind::FaceGrooving)
    }

    /// The shape of its insert by ISO 1832, the first letter.
    pub fn insert_shape(&self) -> Option<&'k str> {
        self.insert.and_then(|insert| insert.get(..1))
    }

    /// The clearance of its insert by ISO 1832, the second letter.
    pub fn insert_clearance(&self) -> Option<&'k str> {
        self.insert.and_then(|insert| insert.get(1..2))
    }
}

/// A designation normalised for comparison.
fn plain(designation: &str) -> String {
    designation.chars().filter(|letter| !letter.is_whitespace()).flat_map(char::to_uppercase).collect()
}
