//! Example values for missing keys, so that nobody must look up their form.

use technolog_note::{Note, note};

/// How the path of a mapping in Rust ends, and values of its keys.
const EXAMPLES: &[(&str, &[(&str, &str)])] = &[
    (
        "part::file::PartFile",
        &[
            ("part", "plate-1"),
            ("material", "steel-45"),
            ("blank", "{kind: plate, length: 200, width: 100, thickness: 40}"),
            ("machine", "gf2171"),
            (
                "holes",
                "[{name: A, diameter: 10H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.46, at: [[0, 0]]}]",
            ),
        ],
    ),
    (
        "::Hole",
        &[
            ("name", "A"),
            ("diameter", "10H12"),
            ("roughness", "Ra 12.5"),
            ("centre_tolerance", "0.46"),
            ("at", "[[-50, 0], [50, 0]]"),
            ("state_diameter", "8"),
        ],
    ),
    ("::StatedMaterial", &[("grade", "steel-45")]),
    ("part::file::Blank", &[("kind", "plate"), ("length", "200"), ("width", "100"), ("thickness", "40")]),
    ("::Limits", &[("nominal", "10"), ("upper", "0.1"), ("lower", "-0.1")]),
    ("::Clamp", &[("at", "[90, 40]")]),
    ("::Grid", &[("start", "[-60, -30]"), ("columns", "3"), ("rows", "2"), ("step", "[60, 30]")]),
    ("::Line", &[("start", "[-60, 0]"), ("step", "30"), ("count", "3")]),
    ("::Circle", &[("centre", "[0, 0]"), ("diameter", "60"), ("count", "6")]),
    ("::Counterbore", &[("diameter", "18"), ("depth", "5")]),
    ("::Countersink", &[("diameter", "14")]),
    ("::Cone", &[("diameter", "12")]),
    (
        "slot::Slot",
        &[
            ("name", "S"),
            ("from", "[-20, 0]"),
            ("to", "[20, 0]"),
            ("centre", "[0, 0]"),
            ("length", "52"),
            ("width", "12H12"),
            ("roughness", "Ra 6.3"),
            ("centre_tolerance", "0.4"),
        ],
    ),
    ("::Groove", &[("diameter", "22"), ("width", "3"), ("depth", "10")]),
    ("::FaceKeys", &[("diameter", "30")]),
    (
        "::WorkpieceFile",
        &[
            ("shaft", "shaft-1"),
            ("material", "steel-45"),
            ("blank", "{kind: bar, diameter: 65, length: 62}"),
            ("outer", "[{from: {d: 40, z: 0}}, {cylinder: -60}]"),
            ("steps", "[{diameter: 40, length: 16}, {diameter: 50, length: 18}]"),
            ("roughing", "{longitudinal_depth: 4, transverse_depth: 3.5}"),
        ],
    ),
    ("::BlankFile", &[("kind", "bar"), ("diameter", "65"), ("length", "62"), ("bore", "20")]),
    ("workpiece::file::Step", &[("diameter", "40"), ("length", "16")]),
    ("::RoughingFile", &[("longitudinal_depth", "4"), ("transverse_depth", "3.5")]),
    ("::RatesFile", &[("longitudinal_feed", "180"), ("transverse_feed", "150"), ("rapid", "6000")]),
    ("::PointFile", &[("d", "40"), ("z", "0")]),
    ("::AllowancesFile", &[("method", "table")]),
    (
        "::ErrorsFile",
        &[("rz_um", "50"), ("defect_layer_um", "50"), ("spatial_deviation_um", "80"), ("setup_error_um", "120")],
    ),
    ("::Program", &[("file", "program.nc"), ("control", "2c42-65")]),
    ("::Row", &[("operation", "drill")]),
    ("::Conditions", &[("for", "[2]")]),
    ("::PlanFile", &[("part", "part.yaml")]),
    ("::SchemeFile", &[("points", "100")]),
];

/// The remedy for a mapping that lacks a key.
pub(crate) fn to_add(form: &str, key: &str) -> Note {
    let of_form = EXAMPLES.iter().filter(|(end, _)| form.ends_with(end)).flat_map(|(_, keys)| *keys);
    match of_form.into_iter().find(|(known, _)| *known == key) {
        Some((_, value)) => note!("yaml-add-key-such-as", example = format!("{key}: {value}")),
        None => note!("yaml-add-key", name = key),
    }
}
