//! A group of holes as its author writes it.

use schemars::JsonSchema;
use serde::Deserialize;
use technolog_knowledge::forms;

use super::super::Bottom;
use super::{Angle, Coordinate, Direction, Name, PointOfFace, Size};

forms! {
    /// A group of equal holes.
    #[schemars(extend("oneOf" = [{"required": ["at"]}, {"required": ["pattern"]}]))]
    #[schemars(extend("allOf" = [
        {"anyOf": [{"required": ["depth"]}, {"required": ["through"]}, {"required": ["steps"]}]},
        {"anyOf": [{"required": ["diameter"]}, {"required": ["thread"]}, {"required": ["steps"]}]},
        {"anyOf": [{"required": ["roughness"]}, {"required": ["thread"]}, {"required": ["steps"]}]},
    ]))]
    #[schemars(extend("dependentRequired" = {"state_diameter": ["state"]}))]
    pub struct Hole {
        /// Name of the group, unique in the part.
        pub name: Name,
        /// Diameter with its tolerance: `10H12`, `10K7` (Ø3 to Ø80, to Ø160 where the blank has the hole, fields D to H, JS, K to S, grades 6 to 14), `10` for a free size (grade 13), or
        /// `{nominal: 10, upper: 0.15, lower: 0}`. A thread says it itself; with `steps` it is the narrowest.
        pub diameter: Option<Diameter>,
        /// Depth of the hole from the entry face, mm; of a through hole the thickness of the blank, and may be
        /// left out.
        pub depth: Option<Size>,
        /// Whether the hole goes through; `false` unless said.
        pub through: Option<bool>,
        /// Bottom of a blind hole; `free` unless said.
        pub bottom: Option<Bottom>,
        /// Roughness limit, micrometres: `Ra 12.5`, or `Rz` of 80, 40, 20, 10, 6.3 or 3.2. A thread may leave it
        /// out; steps that give none have this one.
        pub roughness: Option<RoughnessText>,
        /// Full width of the tolerance on centre distances, mm, up to 10; or `IT5` to `IT14`: that grade at
        /// the smallest centre distance of the group.
        pub centre_tolerance: CentreTolerance,
        /// Chamfer at the entry, mm.
        pub chamfer: Option<Size>,
        /// Whether the tool cuts through a casting or forging skin; `false` unless said.
        pub skin: Option<bool>,
        /// The centres: `[[X, Y], [X, Y]]`, mm.
        #[schemars(length(min = 1))]
        pub at: Option<Vec<PointOfFace>>,
        /// A pattern of centres instead of `at`.
        pub pattern: Option<Pattern>,
        /// A cone that the hole opens into at the entry.
        pub cone: Option<Cone>,
        /// Thread, metric (`M8-6H`, `M8x1`) or conical (`K1/2`).
        pub thread: Option<ThreadText>,
        /// A flat-bottomed opening at the entry.
        pub counterbore: Option<Counterbore>,
        /// A conical opening at the entry for a screw head.
        pub countersink: Option<Countersink>,
        /// A face around the entry, cut flat: its diameter, mm.
        pub face: Option<Face>,
        /// A groove inside the hole.
        pub groove: Option<Groove>,
        /// State of the hole in the blank; `solid` unless said.
        pub state: Option<State>,
        /// Diameter of a cast or pre-machined hole in the blank, mm.
        pub state_diameter: Option<Size>,
        /// Whether a cast or pre-machined hole is in an outer wall; `false` unless said.
        pub outer_wall: Option<bool>,
        /// The cylinders of a stepped hole, from the entry face inwards.
        pub steps: Option<Vec<Step>>,
    }

    /// A diameter by its deviations; the grade is the coarsest whose tolerance they hold.
    pub struct Limits {
        /// Nominal diameter, mm, 3 to 80, to 160 where the blank has the hole.
        #[schemars(range(min = 3, max = 80))]
        pub nominal: f64,
        /// Upper deviation, mm, with its sign; above the lower.
        pub upper: Coordinate,
        /// Lower deviation, mm, with its sign.
        pub lower: Coordinate,
    }

    /// A cylinder of a stepped hole.
    #[schemars(extend("anyOf" = [{"required": ["diameter"]}, {"required": ["thread"]}]))]
    #[schemars(extend("not" = {"required": ["depth", "length"]}))]
    pub struct Step {
        /// Diameter with its tolerance, as of a hole; a thread says it itself.
        pub diameter: Option<Diameter>,
        /// From the entry face of the hole to the end of the step, mm.
        pub depth: Option<Size>,
        /// The step's own length, mm, instead of `depth`. The last step of a through hole may leave both out.
        pub length: Option<Size>,
        /// Roughness limit, micrometres; the hole's unless said.
        pub roughness: Option<RoughnessText>,
        /// The shoulder at its end; `flat` unless said.
        pub bottom: Option<Bottom>,
        /// Its thread.
        pub thread: Option<ThreadText>,
        /// Chamfer at its edge, mm.
        pub chamfer: Option<Size>,
    }

    /// A pattern of centres, of one kind.
    #[schemars(extend("minProperties" = 1, "maxProperties" = 1))]
    pub struct Pattern {
        /// Rows and columns.
        pub grid: Option<Grid>,
        /// Points of a line.
        pub line: Option<Line>,
        /// Points of a circle.
        pub circle: Option<Circle>,
    }

    /// Rows and columns of centres, row by row.
    pub struct Grid {
        /// The first point `[X, Y]`, mm.
        pub start: [Coordinate; 2],
        /// Points in a row.
        #[schemars(range(min = 1))]
        pub columns: u32,
        /// Number of rows.
        #[schemars(range(min = 1))]
        pub rows: u32,
        /// From column to column and from row to row, `[X, Y]`, or one figure for both, mm.
        pub step: GridStep,
        /// Direction of the rows, degrees counter-clockwise from +X; 0 unless said.
        pub angle: Option<Direction>,
    }

    /// Centres on a line.
    pub struct Line {
        /// The first point `[X, Y]`, mm.
        pub start: [Coordinate; 2],
        /// Number of points.
        #[schemars(range(min = 1))]
        pub count: u32,
        /// From point to point, mm.
        pub step: Size,
        /// Direction of the line, degrees counter-clockwise from +X; 0 unless said.
        pub angle: Option<Direction>,
    }

    /// Centres evenly on a circle, counter-clockwise.
    pub struct Circle {
        /// Its centre `[X, Y]`, mm.
        pub centre: [Coordinate; 2],
        /// Its diameter, mm.
        pub diameter: Size,
        /// Number of points.
        #[schemars(range(min = 2))]
        pub count: u32,
        /// Direction of the first point from the centre, degrees counter-clockwise from +X; 0 unless said.
        pub start_angle: Option<Direction>,
    }

    /// A cone at the entry, by its angle or its taper.
    #[schemars(extend("oneOf" = [{"required": ["angle"]}, {"required": ["taper"]}]))]
    pub struct Cone {
        /// Its diameter at the entry, mm.
        pub diameter: Size,
        /// Its full angle, degrees.
        pub angle: Option<Angle>,
        /// The difference of two of its diameters over the length between them: 0.02 for 1:50.
        pub taper: Option<Taper>,
    }

    /// A counterbore.
    pub struct Counterbore {
        /// Its diameter, mm.
        pub diameter: Size,
        /// Its depth from the entry face, mm.
        pub depth: Size,
    }

    /// A countersink.
    pub struct Countersink {
        /// Its largest diameter, mm.
        pub diameter: Size,
        /// Its full angle, degrees; 90 unless said.
        pub angle: Option<Angle>,
    }

    /// A face around the entry, by its key.
    pub struct FaceKeys {
        /// Its diameter, mm.
        pub diameter: Size,
    }

    /// A groove inside a hole.
    pub struct Groove {
        /// Its diameter, mm.
        pub diameter: Size,
        /// Its width along the axis, mm.
        pub width: Size,
        /// From the entry face to its nearer side, mm.
        pub depth: Size,
    }
}

/// A roughness limit, micrometres: `Ra 12.5` or `Rz 80`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct RoughnessText(
    #[schemars(regex(pattern = r"^[Rr]([aAаА][ =]*[0-9]+(\.[0-9]{1,3})?|[zZ][ =]*(80|40|20|10|6\.3|3\.2))$"))]
    pub  String,
);

/// A thread: metric, with the coarse pitch or `x` and a fine one, and its tolerance field; or conical, in inches.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct ThreadText(#[schemars(regex(pattern = r"^ *([MmМм] *[0-9]|[KkКк] *[0-9])"))] pub String);

/// A diameter with its tolerance.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Diameter {
    /// Size and field, `10H12`.
    Field(#[schemars(regex(pattern = r"^[Ø⌀∅Фф]? *[0-9]+(\.[0-9]{1,3})?( *[HНн](6|7|8|9|10|11|12|13|14))?$"))] String),
    /// A free size, mm: grade 13.
    Free(#[schemars(range(min = 3, max = 80))] f64),
    /// Size and deviations.
    Limits(Limits),
}

/// The tolerance on centre distances.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum CentreTolerance {
    /// Its full width, mm.
    Width(#[schemars(range(max = 10), extend("exclusiveMinimum" = 0))] f64),
    /// A grade at the smallest centre distance of the group.
    Grade(#[schemars(regex(pattern = r"^[IiІі][TtТт] *(5|6|7|8|9|10|11|12|13|14)$"))] String),
}

/// The step of a grid.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum GridStep {
    /// The same in both directions, mm.
    Both(Size),
    /// From column to column and from row to row, mm.
    Each([Size; 2]),
}

/// A face around the entry.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Face {
    /// Its diameter, mm.
    Diameter(Size),
    /// By its key.
    Keyed(FaceKeys),
}

/// The difference of two diameters of a cone over the length between them, above zero.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(transparent)]
#[schemars(extend("exclusiveMinimum" = 0))]
pub struct Taper(pub f64);

/// State of a hole in the blank.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum State {
    /// Solid metal.
    Solid,
    /// Cast or forged.
    Cast,
    /// Machined beforehand.
    PreMachined,
}
