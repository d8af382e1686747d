//! Turning tools, from the tables of `catalogs/tools/turning`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, RowRef, TableError};
use crate::units::{Decimal, Micrometres, Unit};

/// The tables of tools, in the order in which they are asked.
const TABLES: [&str; 4] =
    ["turning-outer-tools", "turning-boring-bars", "turning-grooving-tools", "turning-threading-tools"];

/// What a tool is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ToolKind {
    /// Cylinders, faces and contours outside.
    Turning,
    /// The same inside.
    Boring,
    /// Grooves and parting, across the axis.
    Grooving,
    /// Grooves in a face, along the axis.
    FaceGrooving,
    /// Threads.
    Threading,
}

/// Where a tool works.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Works {
    /// On outer surfaces.
    Outer,
    /// In a bore.
    Inner,
    /// In a face.
    Face,
}

/// Which way a tool cuts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Hand {
    /// Right: towards the chuck.
    R,
    /// Left: away from the chuck.
    L,
    /// Neutral: both ways.
    N,
}

/// What of a tool is clamped, and bends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shank {
    /// A square shank: its height lies in the direction of the main force.
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

/// A turning tool. What its row does not have is `None`.
#[derive(Clone, Debug)]
pub struct TurningTool<'k> {
    /// Its row.
    pub row: RowRef<'k>,
    /// Its designation, by which files name it.
    pub designation: &'k str,
    /// What it is for.
    pub kind: ToolKind,
    /// Where it works.
    pub works: Works,
    /// Which way it cuts.
    pub hand: Hand,
    /// φ, between the main edge and the feed along the axis, degrees.
    pub lead_angle: Decimal,
    /// φ1, between the edge behind the tip and the finished surface, degrees: how steeply a contour may fall behind
    /// the tip. φ1 = 180 − φ − ε with ε of the insert.
    pub trail_angle: Decimal,
    /// Nose radius r.
    pub nose_radius: Option<Micrometres>,
    /// The insert by ISO 1832.
    pub insert: Option<&'k str>,
    /// Length of the insert's edge.
    pub edge: Option<Micrometres>,
    /// Its shank or bar.
    pub shank: Option<Shank>,
    /// Overhang out of the holder, where the row has one of its own; else by `turning-limits`.
    pub reach: Option<Micrometres>,
    /// Length over all.
    pub length: Option<Micrometres>,
    /// The smallest bore it enters.
    pub min_bore: Option<Micrometres>,
    /// Width of the blade of a grooving tool.
    pub width: Option<Micrometres>,
    /// The deepest groove.
    pub groove_depth: Option<Micrometres>,
    /// The smallest outer diameter of a face groove.
    pub face_diameter_min: Option<Micrometres>,
    /// Least and largest pitch of a threading tool.
    pub pitch: Option<(Micrometres, Micrometres)>,
    /// Carbide grades of its inserts, in the names of `tool-material-factor`; empty where the row has none.
    pub grades: Vec<&'k str>,
}

impl<'k> TurningTool<'k> {
    /// Every turning tool, in the order of the tables.
    ///
    /// # Errors
    /// A table is not there, or a row lacks a required cell.
    pub fn all(knowledge: &'k Knowledge) -> Result<Vec<Self>, KnowledgeError> {
        let mut tools = Vec::new();
        for table in TABLES {
            for row in knowledge.table(table)?.all_rows() {
                tools.push(Self::read(row)?);
            }
        }
        Ok(tools)
    }

    /// The tool of that designation; spaces and the case of letters do not count. Nothing where there is none.
    ///
    /// # Errors
    /// As [`Self::all`].
    pub fn find(knowledge: &'k Knowledge, designation: &str) -> Result<Option<Self>, KnowledgeError> {
        let wanted = plain(designation);
        Ok(Self::all(knowledge)?.into_iter().find(|tool| plain(tool.designation) == wanted))
    }

    fn read(row: RowRef<'k>) -> Result<Self, KnowledgeError> {
        let round = row.length_if_any("bar_diameter").map(|diameter| Shank::Round { diameter });
        let square = row.length_if_any("shank_height").zip(row.length_if_any("shank_width"));
        Ok(Self {
            row,
            designation: row.text("designation")?,
            kind: word(row, "kind", ToolKind::of)?,
            works: word(row, "place_of_work", Works::of)?,
            hand: word(row, "hand", Hand::of)?,
            lead_angle: Decimal::from_f64_rounded(row.number_in("lead_angle", Unit::Degree)?),
            trail_angle: Decimal::from_f64_rounded(row.number_in("trail_angle", Unit::Degree)?),
            nose_radius: row.length_if_any("nose_radius"),
            insert: row.text("insert").ok(),
            edge: row.length_if_any("edge"),
            shank: round.or(square.map(|(height, width)| Shank::Square { height, width })),
            reach: row.length_if_any("reach"),
            length: row.length_if_any("length"),
            min_bore: row.length_if_any("min_bore"),
            width: row.length_if_any("width"),
            groove_depth: row.length_if_any("groove_depth"),
            face_diameter_min: row.length_if_any("face_diameter_min"),
            pitch: row.length_if_any("pitch_min").zip(row.length_if_any("pitch_max")),
            grades: row.texts("grades").unwrap_or_default(),
        })
    }

    /// Whether it is fed straight into the metal, so that the width of its blade is the depth of cut.
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

/// A designation as it is compared.
fn plain(designation: &str) -> String {
    designation.chars().filter(|letter| !letter.is_whitespace()).flat_map(char::to_uppercase).collect()
}

fn word<'k, T>(row: RowRef<'k>, column: &str, of: fn(&str) -> Option<T>) -> Result<T, TableError> {
    let text = row.text(column)?;
    of(text).ok_or_else(|| TableError {
        table: row.table.id.clone(),
        file: format!("{}:{}", row.table.file, row.row().line),
        row: format!(", row {}", row.number()),
        problem: format!("`{text}` in the column `{column}` is nothing that turning knows"),
    })
}

impl ToolKind {
    const ALL: [Self; 5] = [Self::Turning, Self::Boring, Self::Grooving, Self::FaceGrooving, Self::Threading];

    /// Its name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Turning => "turning",
            Self::Boring => "boring",
            Self::Grooving => "grooving",
            Self::FaceGrooving => "face-grooving",
            Self::Threading => "threading",
        }
    }

    fn of(text: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == text)
    }
}

impl Works {
    fn of(text: &str) -> Option<Self> {
        Some(match text {
            "outer" => Self::Outer,
            "inner" => Self::Inner,
            "face" => Self::Face,
            _ => return None,
        })
    }
}

impl Hand {
    fn of(text: &str) -> Option<Self> {
        Some(match text {
            "R" => Self::R,
            "L" => Self::L,
            "N" => Self::N,
            _ => return None,
        })
    }
}
