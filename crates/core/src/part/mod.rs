//! What is to be made: a plate with holes, its blank and its material.
//!
//! [`read_part`] turns the user's YAML into these types and reports all mistakes of the file at once, each with its
//! place and remedy. [`schema`] is the JSON Schema for editors.

mod arrange_steps;
mod check;
mod check_features;
mod deviations;
mod dimension;
mod domain;
pub mod file;
pub mod limits;
mod read;
mod read_diameter;
mod read_dimensions;
mod read_features;
mod read_fixture;
mod read_holes;
mod read_pattern;
mod read_slots;
mod read_steps;
mod slot;
mod standing;
pub mod stated;
mod thread;
mod tolerance;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::material::MaterialState;
use crate::units::{ItGrade, Micrometres, Roughness};

pub use crate::tables::rules::Entry;
pub use deviations::Deviations;
pub use dimension::{Along, Base, Dimension, Side};
pub use file::schema;
pub use read::{read_part, read_part_node};
pub use slot::{OpenEnds, Slot, Way};
pub use standing::{Outline, Standing};
pub use tolerance::{LimitsOf, ToleratedDiameter, tolerance_width};

/// A part with holes, as its drawing gives it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Part {
    /// Its name.
    pub part: String,
    /// The id of its material in the catalog `materials`.
    pub material: String,
    /// How hard or strong the blank is, where the file says it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub material_state: Option<MaterialState>,
    /// What it is made from.
    pub blank: Blank,
    /// The id of the machine: `gf2171`.
    pub machine: String,
    /// Where the zeros of X, Y and Z lie.
    pub datum: Datum,
    /// The state of the face the tools enter.
    pub entry: Entry,
    /// How it is held.
    pub fixture: Fixture,
    /// Permitted position error Δ0 of table A.6, mm; absent: the centre tolerance of each group of holes.
    pub position_tolerance: Option<Micrometres>,
    /// Mass of the blank, kg.
    pub mass_kg: Option<f64>,
    /// The dimensions of the drawing: from where each coordinate is dimensioned.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub dimensions: Vec<Dimension>,
    /// The groups of equal holes.
    pub holes: Vec<Hole>,
}

/// The blank.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Blank {
    /// Its kind.
    pub kind: BlankKind,
    /// Along X, mm.
    pub length: Micrometres,
    /// Along Y, mm.
    pub width: Micrometres,
    /// Along Z, mm.
    pub thickness: Micrometres,
    /// The bore of a round blank, about its axis, that is there before the operation and is not made here, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bore: Option<Micrometres>,
}

/// Kinds of blanks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BlankKind {
    /// A plate.
    Plate,
    /// A round one, disc or ring: length and width are its diameter.
    Disc,
}

impl Blank {
    /// Whether it is round about the Z axis.
    pub const fn is_round(&self) -> bool {
        matches!(self.kind, BlankKind::Disc)
    }
}

/// Where the part's zeros lie, as the blank's lower left corner and top face seen from them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Datum {
    /// X of the blank's left side, mm.
    pub left: Micrometres,
    /// Y of the blank's front side, mm.
    pub front: Micrometres,
    /// Z of the blank's top face, mm.
    pub top: Micrometres,
}

/// How the part is held.
#[derive(Clone, Debug, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Fixture {
    /// Height of the fixture under the part, mm.
    pub height: Option<Micrometres>,
    /// The clamps; none: a symmetric pair is proposed.
    pub clamps: Vec<Clamp>,
    /// The finished holes of the blank that pins of the fixture enter in the first set-up: none, one or two.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pins: Vec<PinHole>,
    /// What else stands over the face.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub obstacles: Vec<Obstacle>,
    /// How high over the face tools go from hole to hole, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub retract: Option<Micrometres>,
    /// The name of a fixture of the shop's own that holds the part.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub own: Option<String>,
    /// The device that the file asks for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub holding: Option<Holding>,
}

/// A device of the tables that a file may ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Holding {
    /// A three-jaw chuck on the table.
    Chuck,
}

impl Holding {
    /// Their names in files.
    pub const NAMES: &'static [(&'static str, Self)] = &[("chuck", Self::Chuck)];
}

/// A finished hole of the blank, by which a pin locates the part.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct PinHole {
    /// Its axis.
    pub at: Point,
    /// Its diameter with its tolerance.
    pub diameter: ToleratedDiameter,
}

/// Something that stands over the face of the part.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Obstacle {
    /// Two opposite corners of its outline.
    pub outline: [Point; 2],
    /// How high it stands over the face that is up, mm.
    pub height: Micrometres,
    /// The set-up, from 1.
    pub set_up: u32,
}

/// A clamp.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Clamp {
    /// Where it presses.
    pub at: Point,
    /// Its screw, `M10`.
    pub screw: Option<String>,
    /// How high it stands over the face, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height: Option<Micrometres>,
    /// The lowest and highest corners of its outline.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outline: Option<[Point; 2]>,
}

/// A point of the part's top face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(from = "[Micrometres; 2]", into = "[Micrometres; 2]")]
pub struct Point {
    /// X, mm.
    pub x: Micrometres,
    /// Y, mm.
    pub y: Micrometres,
}

impl From<[Micrometres; 2]> for Point {
    fn from([x, y]: [Micrometres; 2]) -> Self {
        Self { x, y }
    }
}

impl From<Point> for [Micrometres; 2] {
    fn from(point: Point) -> Self {
        [point.x, point.y]
    }
}

impl Point {
    /// As messages show it: `[10; -5.5]`.
    pub fn shown(self) -> String {
        format!("[{}; {}]", self.x, self.y)
    }

    /// Straight distance to the nearest of other points; none where there are none.
    pub fn to_nearest(self, others: &[Self]) -> Option<Micrometres> {
        others.iter().map(|other| self.distance(*other)).min()
    }

    /// Straight distance to another point.
    pub fn distance(self, other: Self) -> Micrometres {
        Micrometres::from_mm_rounded(libm::hypot((self.x - other.x).to_mm(), (self.y - other.y).to_mm()))
    }
}

/// A group of equal holes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Hole {
    /// Its name, unique in the part.
    pub name: String,
    /// Diameter with its tolerance.
    pub diameter: ToleratedDiameter,
    /// Depth of the full diameter, mm.
    pub depth: Micrometres,
    /// Whether it goes through.
    pub through: bool,
    /// The bottom of a blind hole.
    pub bottom: Bottom,
    /// Roughness limit.
    pub roughness: Roughness,
    /// Width of the tolerance on centre distances.
    pub centre_tolerance: CentreTolerance,
    /// Chamfer at the entry, mm.
    pub chamfer: Option<Micrometres>,
    /// Whether the material around it carries a casting or forging skin.
    pub skin: bool,
    /// Its thread; `diameter` is then that of the hole under the thread.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thread: Option<Thread>,
    /// The cone it opens into at the entry; `diameter` is then that of its narrow end.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cone: Option<Cone>,
    /// Counterbore at the entry.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub counterbore: Option<Counterbore>,
    /// Countersink at the entry.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub countersink: Option<Countersink>,
    /// A face around the entry, cut flat: its diameter, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub face: Option<Micrometres>,
    /// A groove inside it, which no axial tool makes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub groove: Option<Groove>,
    /// The state of the hole in the blank.
    #[serde(default)]
    pub state: BlankHole,
    /// Whether a cast or pre-machined hole lies in an outer wall (tables A.8, A.9).
    #[serde(default)]
    pub outer_wall: bool,
    /// The wider cylinders of a stepped hole beside the main one, from the entry face inwards.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub steps: Vec<HoleStep>,
    /// How it runs on from each of its centres, where it is a slot or a pocket: its width is `diameter`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slot: Option<Slot>,
    /// The centres.
    pub at: Vec<Point>,
}

/// A thread.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Thread {
    /// As the drawing writes it: `M8-6H`, `К1/2"`.
    pub written: String,
    /// Its kind.
    pub kind: ThreadKind,
    /// The id its tap is known by in the catalogs: `M8`, `M8x1`, `K1/2`.
    pub id: String,
    /// Nominal diameter; of a conical thread its outer diameter in the main plane, mm.
    pub size: Micrometres,
    /// Pitch, mm.
    pub pitch: Micrometres,
}

/// Kinds of threads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ThreadKind {
    /// Metric, cylindrical.
    Cylindrical,
    /// Conical, in inches.
    Conical,
}

/// A conical opening.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Cone {
    /// Its diameter at the entry, mm.
    pub diameter: Micrometres,
    /// Its full angle, thousandths of a degree.
    pub angle_millideg: u32,
}

/// A counterbore: a flat-bottomed opening at the entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Counterbore {
    /// Its diameter, mm.
    pub diameter: Micrometres,
    /// Its depth from the entry face, mm.
    pub depth: Micrometres,
}

/// A countersink: a conical opening at the entry for a screw head.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Countersink {
    /// Its largest diameter, mm.
    pub diameter: Micrometres,
    /// Its full angle, thousandths of a degree.
    pub angle_millideg: u32,
}

/// A groove inside a hole.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Groove {
    /// Its diameter, mm.
    pub diameter: Micrometres,
    /// Its width along the axis, mm.
    pub width: Micrometres,
    /// From the entry face to its nearer side, mm.
    pub depth: Micrometres,
}

/// The state of a hole in the blank.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BlankHole {
    /// Solid metal.
    #[default]
    Solid,
    /// A cast or forged hole of that diameter, mm.
    Cast(Micrometres),
    /// A hole machined beforehand, of that diameter, mm.
    PreMachined(Micrometres),
}

impl BlankHole {
    /// The diameter of the hole in the blank, if there is one.
    pub const fn diameter(self) -> Option<Micrometres> {
        match self {
            Self::Solid => None,
            Self::Cast(diameter) | Self::PreMachined(diameter) => Some(diameter),
        }
    }
}

/// The face a step is entered from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Face {
    /// The face of the first set-up.
    #[default]
    Entry,
    /// The opposite face, after turning the part over.
    Back,
}

/// A cylinder of a stepped hole that is wider than the main one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct HoleStep {
    /// Diameter with its tolerance.
    pub diameter: ToleratedDiameter,
    /// The face it is entered from.
    pub face: Face,
    /// From that face to its bottom, mm.
    pub depth: Micrometres,
    /// Its shoulder: flat, or the cone of a drill.
    pub bottom: Bottom,
    /// Roughness limit.
    pub roughness: Roughness,
    /// Its thread.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thread: Option<Thread>,
    /// Chamfer at its edge, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub chamfer: Option<Micrometres>,
}

/// The bottom of a blind hole.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Bottom {
    /// Any, the drill's cone included.
    #[default]
    Free,
    /// Flat.
    Flat,
}

/// The tolerance on centre distances of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum CentreTolerance {
    /// Its full width, mm.
    Width(Micrometres),
    /// That grade at the smallest centre distance of the group.
    Grade {
        /// The grade.
        it: ItGrade,
    },
}

impl Blank {
    /// How far a point is from its nearest edge, its lower left corner being where the datum says; below zero outside it.
    pub(crate) fn to_edge(self, datum: &Datum, at: Point) -> Micrometres {
        let (left, front) = (at.x - datum.left, at.y - datum.front);
        if !self.is_round() {
            return left.min(front).min(self.length - left).min(self.width - front);
        }
        let radius = self.length.half();
        let from_axis = Point { x: left, y: front }.distance(Point { x: radius, y: radius });
        let to_rim = radius - from_axis;
        self.bore.map_or(to_rim, |bore| to_rim.min(from_axis - bore.half()))
    }
}

impl Part {
    /// How far a point of the face is from the nearest edge of the blank, that of a bore too; below zero outside it.
    pub fn to_edge(&self, at: Point) -> Micrometres {
        self.blank.to_edge(&self.datum, at)
    }

    /// The middle of the blank's top face.
    pub fn middle(&self) -> Point {
        Point { x: self.datum.left + self.blank.length.half(), y: self.datum.front + self.blank.width.half() }
    }
}

impl Hole {
    /// The thread of its main cylinder, or of the step of that number, from 1.
    pub fn thread_at(&self, step: Option<usize>) -> Option<&Thread> {
        match step {
            None => self.thread.as_ref(),
            Some(number) => self.steps.get(number.checked_sub(1)?)?.thread.as_ref(),
        }
    }

    /// The smallest distance between two centres of the group, if it has two.
    pub fn smallest_centre_distance(&self) -> Option<Micrometres> {
        let extent = |coordinate: fn(&Point) -> Micrometres| {
            let (least, most) = (self.at.iter().map(coordinate).min()?, self.at.iter().map(coordinate).max()?);
            Some(most - least)
        };
        // Sorted along the longer side, the search for a nearer point can stop early: patterns may have thousands of
        // points.
        let along: fn(&Point) -> Micrometres =
            if extent(|point| point.x) >= extent(|point| point.y) { |point| point.x } else { |point| point.y };
        let mut points = self.at.clone();
        points.sort_by_key(along);
        let mut smallest: Option<Micrometres> = None;
        for (index, point) in points.iter().enumerate() {
            for other in &points[index + 1..] {
                if smallest.is_some_and(|smallest| along(other) - along(point) > smallest) {
                    break;
                }
                let distance = point.distance(*other);
                smallest = Some(smallest.map_or(distance, |smallest| smallest.min(distance)));
            }
        }
        smallest
    }
}
