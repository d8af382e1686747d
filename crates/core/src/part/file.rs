//! The part file as its author writes it: the source of docs/part.schema.json, which editors use for
//! completion and hints.
//!
//! These types say which keys there are, what they hold and in which units. [`super::read_part`] takes the keys from them,
//! and reads the file itself, because it says where every mistake stands.

pub mod hole;
pub mod slot;

use schemars::{JsonSchema, Schema, schema_for};
use serde::Deserialize;
use technolog_knowledge::forms;

use super::{BlankKind, Entry, Holding};
use hole::Hole;
use slot::Slot;

/// The JSON Schema of a part file.
pub fn schema() -> Schema {
    schema_for!(PartFile)
}

forms! {
    /// A part to be planned by `technolog plan`. All lengths are in mm with a decimal point and at most
    /// three decimal places.
    #[schemars(extend("anyOf" = [{"required": ["holes"]}, {"required": ["slots"]}]))]
    pub struct PartFile {
        /// Name of the part.
        pub part: Name,
        /// Material: an id of `technolog table materials` (`steel-45`) or another name of it (`Сталь 45`, `C45`); with its
        /// state `{grade: 40Х, hardness: 250}`.
        pub material: MaterialField,
        /// What the part is made from.
        pub blank: Blank,
        /// The machine's id: `gf2171`.
        pub machine: String,
        /// Where the zeros of X, Y and Z lie; else in the middle of the top face.
        pub datum: Option<Datum>,
        /// The face that the tools enter; `machined` unless said.
        pub entry: Option<Entry>,
        /// How the part is held.
        pub fixture: Option<Fixture>,
        /// Permitted position error Δ0 of table A.6, mm; else the centre tolerance of each group.
        pub position_tolerance: Option<Size>,
        /// Mass of the blank, kg.
        pub mass: Option<Mass>,
        /// From which side or hole the drawing dimensions each coordinate, and with which tolerance.
        pub dimensions: Option<Vec<Dimension>>,
        /// The groups of equal holes.
        #[schemars(length(min = 1))]
        pub holes: Option<Vec<Hole>>,
        /// The slots.
        #[schemars(length(min = 1))]
        pub slots: Option<Vec<Slot>>,
    }

    /// A material in a state: how it is delivered, or its hardness, its strength or both.
    pub struct StatedMaterial {
        /// The grade, as `material` by itself.
        pub grade: Name,
        /// How it is delivered, of the states in `technolog table material-states`.
        #[schemars(extend("enum" = ["hot-rolled", "annealed", "cold-drawn"]))]
        pub state: Option<String>,
        /// Brinell hardness, HB.
        pub hardness: Option<Size>,
        /// Tensile strength, MPa.
        pub strength: Option<Size>,
    }

    /// The blank, with the hole axes along Z: a plate by length and width, or a disc or ring by its diameter.
    #[schemars(extend("oneOf" = [{"required": ["length", "width"]}, {"required": ["diameter"]}]))]
    pub struct Blank {
        /// Its kind.
        pub kind: BlankKind,
        /// Of a plate along X, mm.
        pub length: Option<Size>,
        /// Of a plate along Y, mm.
        pub width: Option<Size>,
        /// Of a disc, mm.
        pub diameter: Option<Size>,
        /// Of a ring: the bore about its axis that is there already and is not made here, mm.
        pub bore: Option<Size>,
        /// Along Z, mm.
        pub thickness: Size,
    }

    /// A point by its distance from the zero of the drawing, mm, and its angle from X towards Y, degrees.
    pub struct PolarPoint {
        /// From the zero, mm.
        pub r: Size,
        /// From X, counter-clockwise, degrees.
        pub angle: Direction,
    }

    /// Where the part's zeros lie: a side by its word, or the zero's distance from the left, front or
    /// bottom side, mm.
    pub struct Datum {
        /// Zero of X: `left`, `centre` (unless said), `right`, or its distance from the left side, mm.
        pub x: Option<ZeroX>,
        /// Zero of Y: `front`, `centre` (unless said), `back`, or its distance from the front side, mm.
        pub y: Option<ZeroY>,
        /// Zero of Z: `top` (unless said), `middle`, `bottom`, or its distance from the bottom, mm.
        pub z: Option<ZeroZ>,
    }

    /// A dimension of the drawing.
    pub struct Dimension {
        /// Where it begins: `left`, `right`, `front`, `back`, or a group of holes that have one coordinate along the axis.
        pub from: Name,
        /// Where it ends: a group of holes, each of which has this dimension, or the opposite side of the blank.
        pub to: Name,
        /// Along `x` or `y`: needed between two groups of holes.
        pub axis: Option<AxisOfTable>,
        /// The full width of its tolerance, mm: 0.2 for ±0.1.
        pub tolerance: Size,
    }

    /// How the part is held.
    pub struct Fixture {
        /// Height of the fixture under the part, mm.
        pub height: Option<Size>,
        /// The clamps; without them a symmetric pair is proposed.
        pub clamps: Option<Vec<Clamp>>,
        /// One or two finished holes of the blank that pins of the fixture enter in the first set-up; `height` is then needed, with
        /// the plate that they stand in.
        #[schemars(length(min = 1, max = 2))]
        pub pins: Option<Vec<PinHole>>,
        /// What else stands over the face, and the clamps of the second set-up.
        pub obstacles: Option<Vec<Obstacle>>,
        /// How high over the face tools go from hole to hole, mm; else 15, and higher over what is in the way.
        pub retract: Option<Size>,
        /// The name of a fixture of the shop's own that holds the part: then neither clamps nor a vice are planned. `height` is then needed.
        pub own: Option<Name>,
        /// The device that holds the part: `chuck`, a three-jaw chuck on the table, for a disc; else straps where they hold it.
        pub holding: Option<Holding>,
    }

    /// A finished hole of the blank that takes a pin.
    pub struct PinHole {
        /// Its axis, `[X, Y]`, mm: on the blank, and clear of the holes that are made.
        pub at: [Coordinate; 2],
        /// Its diameter with its tolerance: `12H7`.
        pub diameter: hole::Diameter,
    }

    /// Something that stands over the face.
    pub struct Obstacle {
        /// Two opposite corners of its outline, `[[X, Y], [X, Y]]`, mm, as the holes are given.
        pub outline: [[Coordinate; 2]; 2],
        /// How high it stands over the face that is up, mm.
        pub height: Size,
        /// The set-up, 1 (unless said) or 2.
        #[schemars(range(min = 1, max = 2))]
        pub set_up: Option<u32>,
    }

    /// A clamp.
    pub struct Clamp {
        /// Where it presses, `[X, Y]`, mm: on the blank, and not on a hole.
        pub at: [Coordinate; 2],
        /// Its screw, M6 to M24: `M10`; else the smallest that bears the force.
        #[schemars(regex(pattern = r"^[MМ][0-9]+$"))]
        pub screw: Option<String>,
        /// How high it stands over the face, with its screw, mm.
        pub height: Option<Size>,
        /// Two opposite corners of its outline, `[[X, Y], [X, Y]]`, mm; else 20 mm about `at`.
        pub outline: Option<[[Coordinate; 2]; 2]>,
    }
}

/// A material.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum MaterialField {
    /// By its name.
    Grade(Name),
    /// By its name and state.
    Stated(StatedMaterial),
}

/// Zero of X.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum ZeroX {
    /// By a side's word.
    Side(SideX),
    /// By its distance from the left side, mm.
    Distance(Coordinate),
}

/// Zero of Y.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum ZeroY {
    /// By a side's word.
    Side(SideY),
    /// By its distance from the front side, mm.
    Distance(Coordinate),
}

/// A point of the face.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum PointOfFace {
    /// By X and Y, mm.
    Cartesian([Coordinate; 2]),
    /// By its distance from the zero and its angle.
    Polar(PolarPoint),
}

/// Zero of Z.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum ZeroZ {
    /// By a side's word.
    Side(SideZ),
    /// By its distance from the bottom, mm.
    Distance(Coordinate),
}

/// Sides along X.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[allow(missing_docs)] // the words of the format
pub enum SideX {
    Left,
    Centre,
    Right,
}

/// Sides along Y.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[allow(missing_docs)] // the words of the format
pub enum SideY {
    Front,
    Centre,
    Back,
}

/// Sides along Z.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[allow(missing_docs)] // the words of the format
pub enum SideZ {
    Bottom,
    Middle,
    Top,
}

/// Axes of the table.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[allow(missing_docs)] // the words of the format
pub enum AxisOfTable {
    X,
    Y,
}

/// A text; a bare number is one too (`45`).
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Name {
    /// As text.
    Text(#[schemars(length(min = 1))] String),
    /// As number.
    Number(f64),
}

/// A length above zero, mm.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(transparent)]
#[schemars(extend("exclusiveMinimum" = 0))]
pub struct Size(pub f64);

/// A coordinate or deviation, mm.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct Coordinate(pub f64);

/// The full angle of a cone, between 0 and 180 degrees.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(transparent)]
#[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 180))]
pub struct Angle(pub f64);

/// A direction in the plane of the top face, degrees counter-clockwise from +X.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct Direction(pub f64);

/// A mass above zero, kg.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(transparent)]
#[schemars(extend("exclusiveMinimum" = 0))]
pub struct Mass(pub f64);

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;
    use crate::knowledge::Knowledge;
    use crate::knowledge::form::Form;
    use crate::shipped;

    /// Every key of the format.
    const FULL: &str = r"
part: Плита
material: 45
blank: {kind: plate, length: 500, width: 300, thickness: 40.5}
machine: gf2171
datum: {x: left, y: 150, z: top}
entry: rough
fixture: {height: 60, clamps: [{at: [250, -130], screw: М10}, {at: [250, 130]}], pins: [{at: [20, 100], diameter: 12H7}]}
position_tolerance: 0.1
mass: 46.5
dimensions:
  - {from: left, to: C, tolerance: 0.2}
  - {from: C, to: A, axis: x, tolerance: 0.3}
  - {from: left, to: right, tolerance: 0.5}
holes:
  - name: A
    diameter: 6.8
    depth: 20
    through: false
    bottom: flat
    roughness: Rz 80
    centre_tolerance: IT12
    chamfer: 1
    skin: true
    at: [[50, 0], [100, 0]]
    thread: M8-6H
    counterbore: {diameter: 15, depth: 9}
    countersink: {diameter: 17, angle: 90}
    face: {diameter: 24}
    groove: {diameter: 9, width: 2, depth: 12}
    state: pre-machined
    state_diameter: 5
    outer_wall: true
  - name: 2
    diameter: 20Н12
    through: true
    roughness: Ra 12.5
    centre_tolerance: 0.46
    pattern: {line: {start: [150, 0], count: 3, step: 30.5, angle: 30}}
    cone: {diameter: 20.6, taper: 0.02}
    face: 24
  - {name: C, diameter: 12.5, through: true, roughness: Ra 12.5, centre_tolerance: 0.46, at: [[400, 0]], state: solid}
  - name: D
    through: true
    centre_tolerance: 0.46
    steps:
      - {diameter: 12, depth: 5, roughness: Ra 6.3, bottom: free, chamfer: 0.5}
      - {thread: M8, length: 10}
      - {diameter: 20H9, roughness: Ra 2.5}
    pattern: {grid: {start: [50, 50], columns: 2, rows: 2, step: [30, 40], angle: 0}}
  - name: E
    diameter: {nominal: 6, upper: 0.15, lower: 0}
    depth: 20
    roughness: Ra 12.5
    centre_tolerance: 0.46
    pattern: {circle: {centre: [400, 80], diameter: 60, count: 6, start_angle: 15}}
    cone: {diameter: 8, angle: 60}
slots:
  - {name: S, from: [200, 100], to: [240, 100], width: 12H12, depth: 10, roughness: Ra 6.3, centre_tolerance: 0.4}
  - {name: T, centre: [200, -100], length: 60, angle: 30, width: 14, through: true, roughness: Ra 12.5, centre_tolerance: 0.4}
  - {name: U, centre: [300, -60], length: 60, width: 40, corner: 8, depth: 10, roughness: Ra 12.5, centre_tolerance: 0.4}
  - {name: V, from: [450, -100], to: [500, -100], open: to, width: 14, depth: 10, roughness: Ra 12.5, centre_tolerance: 0.4}
";

    fn root(path: &str) -> PathBuf {
        PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
    }

    fn knowledge() -> Knowledge {
        shipped::knowledge().unwrap()
    }

    #[test]
    fn the_schema_in_docs_is_the_generated_one() {
        let path = root("docs/part.schema.json");
        let generated = serde_json::to_string_pretty(&schema()).unwrap() + "\n";
        if std::env::var_os("UPDATE_SCHEMA").is_some() {
            std::fs::write(&path, &generated).unwrap();
        }
        let kept = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(kept == generated, "docs/part.schema.json is old: run `UPDATE_SCHEMA=1 cargo test schema`");
    }

    #[test]
    fn every_object_of_the_schema_is_closed_and_every_key_described() {
        let schema = serde_json::to_value(schema()).unwrap();
        let objects = schema["$defs"].as_object().unwrap().iter().map(|(name, object)| (name.as_str(), object));
        for (name, object) in objects.chain([("PartFile", &schema)]).filter(|(_, object)| object["type"] == "object") {
            assert_eq!(object["additionalProperties"], false, "{name}");
            for (key, property) in object["properties"].as_object().unwrap() {
                assert!(property["description"].is_string(), "{name}.{key}");
            }
        }
    }

    #[test]
    fn the_examples_fit_the_schema_types_and_the_reader() {
        let knowledge = knowledge();
        let mut seen = 0;
        for entry in std::fs::read_dir(root("examples")).unwrap() {
            let path = entry.unwrap().path();
            // The folder holds shafts, plans and programs too.
            if path.extension().is_none_or(|extension| extension != "yaml") {
                continue;
            }
            let text = std::fs::read_to_string(&path).unwrap();
            if !text.contains("\npart:") {
                continue;
            }
            serde_yaml::from_str::<PartFile>(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            super::super::read_part("example", &text, &knowledge).unwrap();
            seen += 1;
        }
        assert!(seen > 0);
    }

    #[test]
    fn a_part_with_every_key_fits_the_schema_types_and_the_reader() {
        let part = super::super::read_part("full", FULL, &knowledge()).unwrap();
        assert_eq!(part.material, "steel-45");
        assert_eq!(part.holes.iter().map(|hole| hole.at.len()).collect::<Vec<_>>(), [2, 3, 1, 4, 6, 1, 1, 1, 1]);
        serde_yaml::from_str::<PartFile>(FULL).unwrap();
        fn used<F: Form>() -> bool {
            F::KEYS.iter().all(|key| FULL.contains(&format!("{}:", key.name())))
        }
        assert!(used::<PartFile>() && used::<Hole>() && used::<hole::Step>());
        assert!(used::<slot::Slot>() && used::<hole::Grid>() && used::<hole::Circle>() && used::<hole::Cone>());
    }

    #[test]
    fn the_schema_types_and_the_reader_refuse_the_same_forms() {
        let knowledge = knowledge();
        for (from, to) in [
            ("mass:", "masse:"),
            ("thickness:", "thick:"),
            ("kind: plate", "kind: bar"),
            ("x: left", "x: top"),
            ("entry: rough", "entry: raw"),
            ("height: 60", "hight: 60"),
            ("axis: x", "axis: z"),
            ("from: C,", "form: C,"),
            ("to: C, tolerance: 0.2", "to: C, tolerance: wide"),
            ("at: [250, 130]", "at: [250, 130, 0]"),
            ("lower: 0", "low: 0"),
            ("bottom: flat", "bottom: round"),
            ("through: false", "through: no"),
            ("depth: 9", "deep: 9"),
            ("angle: 90", "angel: 90"),
            ("width: 2", "wide: 2"),
            ("taper: 0.02", "tapper: 0.02"),
            ("length: 10", "lenght: 10"),
            ("columns: 2", "colums: 2"),
            ("columns: 2", "columns: 2.5"),
            ("start_angle: 15", "angle: 15"),
            ("face: 24", "face: {}"),
            ("state: pre-machined", "state: forged"),
            ("line:", "row:"),
            ("step: 30.5", "step: [1, 2]"),
            ("at: [[50, 0], [100, 0]]", "at: [50, 0]"),
            ("from: [200, 100]", "form: [200, 100]"),
            ("length: 60", "length: long"),
        ] {
            let text = FULL.replacen(from, to, 1);
            assert_ne!(text, FULL, "{from}");
            assert!(serde_yaml::from_str::<PartFile>(&text).is_err(), "{to}");
            assert!(super::super::read_part("full", &text, &knowledge).is_err(), "{to}");
        }
    }
}
