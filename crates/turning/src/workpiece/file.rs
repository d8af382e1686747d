//! The file of a turned part as its author writes it: the source of docs/shaft.schema.json, which editors
//! use for completion.
//!
//! These types say which keys there are and what they hold. [`super::read_turned`] takes the keys from them, and reads the
//! file itself, because it says where every mistake stands.

use schemars::{JsonSchema, Schema, schema_for};
use serde::Deserialize;
use technolog_core::part::file::MaterialField;
use technolog_knowledge::forms;

use crate::turning::shaft::{Division, Holding, Moves};

use super::item_file::ItemFile;
use super::{HeatTreatment, JawKind, Scheme, StockKind};

/// The JSON Schema of the file of a turned part.
pub fn schema() -> Schema {
    schema_for!(WorkpieceFile)
}

/// A length above zero, mm, with a decimal point and at most three decimal places.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
pub struct Size(#[schemars(range(min = 0.001, max = 100_000.0))] pub f64);

/// A length of zero or more, mm, with a decimal point and at most three decimal places.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
pub struct Width(#[schemars(range(min = 0.0, max = 100_000.0))] pub f64);

/// A Z, mm: 0 in the finished face of the free end, negative towards the chuck.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
pub struct Z(#[schemars(range(min = -100_000.0, max = 100_000.0))] pub f64);

/// A height or an error, micrometres.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
pub struct Micron(#[schemars(range(min = 0.0))] pub f64);

/// A contour: item by item, or by its points.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum ContourFile {
    /// Item by item.
    Items(#[schemars(length(min = 2, max = 2000))] Vec<ItemFile>),
    /// By points.
    Points(PointsFile),
    /// By a polyline of a drawing.
    Drawn(DrawnFile),
}

/// Points, joined by straight lines.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum PointsOf {
    /// Diameter and Z of each.
    List(#[schemars(length(min = 2, max = 2000))] Vec<(Width, Z)>),
    /// The name of a table (CSV), relative to this file, with the columns `d` (or `x`, a diameter; or `r`, a radius) and `z`, and if
    /// wanted `radius` and `bulge` of the arc that leads to the point, `name`, `grade`, `roughness`, `allowance` of the surface.
    Table(String),
}

forms! {
    /// A contour by its points.
    pub struct PointsFile {
        /// The points from the free end towards the chuck.
        pub points: PointsOf,
    }

    /// A contour by a polyline: the half-section over the axis, the free end at the right.
    pub struct DrawnFile {
        /// The name of a drawing (ASCII DXF, mm), relative to this file.
        pub dxf: String,
        /// The layer of the polyline; without it the drawing has only one.
        pub layer: Option<String>,
        /// X and Y of the point of the drawing where the axis meets the finished face of the free end; [0, 0] unless said.
        pub zero: Option<(f64, f64)>,
    }

    /// A part to be turned by `technolog turn`, by its contour (`outer`) or, for short, by its cylinders (`steps`). All lengths
    /// are in mm; diameters across, Z along the axis.
    #[schemars(extend("oneOf" = [{"required": ["outer"]}, {"required": ["steps", "roughing"]}]))]
    pub struct WorkpieceFile {
        /// Name of the part.
        pub shaft: String,
        /// Material: an id of `technolog table materials` (`steel-45`) or another name of it (`Сталь 45`, `C45`); with its
        /// state `{grade: 40Х, hardness: 250}`.
        pub material: MaterialField,
        /// What it is made from.
        pub blank: BlankFile,
        /// The id of a lathe, such as `16k20f3`; without it no speeds and loads are told.
        pub machine: Option<String>,
        /// How it is held; in the chuck unless said.
        pub holding: Option<Holding>,
        /// The jaws of the chuck: three unless said, or soft ones that close nearly all around.
        pub jaws: Option<JawKind>,
        /// A steady rest of the first set-up; none unless said.
        pub steady_rest: Option<SteadyRestFile>,
        /// Whether and when it is heat-treated; not unless said.
        pub heat_treatment: Option<HeatTreatment>,
        /// Its outside from the axis, or from the bore, at the free end towards the chuck.
        pub outer: Option<ContourFile>,
        /// Short for `outer` of a stepped shaft that is only roughed: its cylinders from the free end towards the chuck, none
        /// smaller than the one before it.
        #[schemars(length(min = 1))]
        pub steps: Option<Vec<Step>>,
        /// Its bore from the free end; not with `steps`.
        pub inner: Option<ContourFile>,
        /// How roughing is bounded.
        pub roughing: Option<RoughingFile>,
        /// Where finishing allowances come from; from tables unless said. Not with `steps`, which are diameters after roughing.
        pub allowances: Option<AllowancesFile>,
        /// How fast the tool moves; with `steps`, time can be the objective only where it is given.
        pub rates: Option<RatesFile>,
    }

    /// A steady rest, which holds the part on a cylinder of the blank.
    pub struct SteadyRestFile {
        /// Z of its middle.
        pub z: Z,
        /// How long it is along the axis, its frame counted.
        pub width: Size,
    }

    /// A cylinder of the shaft.
    pub struct Step {
        /// Its diameter after roughing.
        pub diameter: Size,
        /// Its length.
        pub length: Size,
    }

    /// The blank. A forging or casting has `outer` (and `inner`), or `diameter`, `length` and `steps`. With `steps` of the part it
    /// has neither bore, nor stock on its face, nor a contour.
    pub struct BlankFile {
        /// Its kind.
        pub kind: StockKind,
        /// Its diameter.
        pub diameter: Option<Size>,
        /// Of a tube: the diameter of its bore.
        pub bore: Option<Size>,
        /// Its whole length.
        pub length: Option<Size>,
        /// The stock on the finished face of the free end; none unless said.
        pub face: Option<Width>,
        /// How much its length may deviate.
        pub length_tolerance: Option<Width>,
        /// Of a forging or casting: its cylinders from the free end; behind them it has its full diameter.
        #[schemars(length(min = 1))]
        pub steps: Option<Vec<Step>>,
        /// Of a forging or casting: its outside; it may begin before the finished face, at Z above 0.
        pub outer: Option<ContourFile>,
        /// Of a forging or casting: its bore.
        pub inner: Option<ContourFile>,
    }

    /// How roughing is bounded: with `outer` by `limiting_depth` and `scheme`, with `steps` by the others.
    pub struct RoughingFile {
        /// The limiting depth of a pass, radial; computed from tool and lathe unless said.
        pub limiting_depth: Option<Size>,
        /// The scheme of passes; chosen by the rules unless said.
        pub scheme: Option<Scheme>,
        /// Largest radial depth of a longitudinal pass.
        pub longitudinal_depth: Option<Size>,
        /// Largest axial depth of a transverse pass.
        pub transverse_depth: Option<Size>,
        /// How stock is divided between shoulders: full depths with the remainder last unless said.
        pub division: Option<Division>,
        /// Which moves passes may make: those of the paper unless said.
        pub moves: Option<Moves>,
    }

    /// Where finishing allowances come from.
    pub struct AllowancesFile {
        /// How they are found.
        pub method: MethodFile,
        /// `stated`: on the diameter.
        pub on_diameter: Option<Width>,
        /// `stated`: on a face.
        pub on_face: Option<Width>,
        /// `analytic`: what is added up.
        pub errors: Option<ErrorsFile>,
    }

    /// The errors of the analytic method, micrometres.
    pub struct ErrorsFile {
        /// Rz that the previous pass left.
        pub rz_um: Micron,
        /// The defect layer that it left.
        pub defect_layer_um: Micron,
        /// The spatial deviation that is left of the blank's.
        pub spatial_deviation_um: Micron,
        /// The error of set-up.
        pub setup_error_um: Micron,
    }

    /// How fast the tool moves.
    pub struct RatesFile {
        /// Feed of longitudinal passes, mm/min.
        pub longitudinal_feed: Size,
        /// Feed of transverse passes, mm/min.
        pub transverse_feed: Size,
        /// Rapid rate, mm/min.
        pub rapid: Size,
        /// How far before the metal the feed begins; 2 unless said.
        pub approach: Option<Size>,
        /// How far the tool draws back after a pass; 0.5 unless said.
        pub retract: Option<Size>,
        /// Feed of cutting in, mm/min.
        pub infeed: Option<Size>,
        /// Feed of picking up along the contour, mm/min.
        pub pick_up_feed: Option<Size>,
        /// Feed of the semi-finishing pass, mm/min.
        pub semi_finishing_feed: Option<Size>,
        /// Feed of finishing, mm/min.
        pub finishing_feed: Option<Size>,
    }
}

technolog_knowledge::vocabulary! {
    /// How allowances are found.
    #[derive(Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum MethodFile {
        /// From tables.
        Table = "table",
        /// From stated errors.
        Analytic = "analytic",
        /// As stated here.
        Stated = "stated",
    }
}

#[cfg(test)]
mod tests {
    use super::super::item_file::{Bulge, ConeKind, GrooveKind};
    use super::super::items::MOST_ITEMS;
    use super::*;
    use crate::knowledge::Word;
    use std::path::Path;

    #[test]
    fn the_schema_of_the_book_is_this_one() {
        let schema = schema();
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/shaft.schema.json");
        let generated = serde_json::to_string_pretty(&schema).unwrap() + "\n";
        if std::env::var_os("UPDATE_SCHEMA").is_some() {
            std::fs::write(&path, &generated).unwrap();
        }
        let kept = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(kept == generated, "docs/shaft.schema.json is old: run `UPDATE_SCHEMA=1 cargo test schema`");
    }

    #[test]
    fn schema_and_reader_have_the_same_bound() {
        let most = |path: &str| schema().as_value().pointer(path).and_then(|most| most.as_u64());
        for name in ["ContourFile/anyOf/0", "PointsOf/anyOf/0"] {
            assert_eq!(most(&format!("/$defs/{name}/maxItems")), Some(MOST_ITEMS as u64), "{name}");
        }
    }

    #[test]
    fn schema_and_reader_know_the_same_words() {
        let words = |name: &str| -> Vec<String> {
            let schema = schema();
            let choices = schema.as_value().pointer(&format!("/$defs/{name}/oneOf")).unwrap();
            choices.as_array().unwrap().iter().map(|one| one["const"].as_str().unwrap().to_owned()).collect()
        };
        assert_eq!(words("GrooveKind"), GrooveKind::WORDS);
        assert_eq!(words("StockKind"), StockKind::WORDS);
        assert_eq!(words("Scheme"), Scheme::WORDS);
        assert_eq!(words("HeatTreatment"), HeatTreatment::WORDS);
        assert_eq!(words("MethodFile"), MethodFile::WORDS);
        assert_eq!(words("Bulge"), Bulge::WORDS);
        assert_eq!(words("ConeKind"), ConeKind::WORDS);
    }

    /// Both descriptions of the form must agree: these types accept the examples, which the reader accepts, and refuse
    /// a key that the reader does not know.
    #[test]
    fn the_examples_are_of_this_form() {
        for name in ["turned-pin", "turned-ball", "turned-bushing", "turned-forging", "shaft", "shaft-forging"] {
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../examples/{name}.yaml"));
            let text = std::fs::read_to_string(path).unwrap();
            serde_yaml::from_str::<WorkpieceFile>(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
            let spoilt = format!("{text}colour: red\n");
            assert!(serde_yaml::from_str::<WorkpieceFile>(&spoilt).is_err(), "{name}");
        }
    }
}
