//! The keys of the contour form, for the reader and for the schema.

/// The keys of a file.
pub(super) const WORKPIECE: &[&str] = &[
    "shaft",
    "material",
    "blank",
    "machine",
    "holding",
    "heat_treatment",
    "outer",
    "inner",
    "roughing",
    "allowances",
    "rates",
];
/// Keys that only the contour form has: by them a file without `outer` is known to be meant as one.
pub(super) const ONLY_CONTOUR: &[&str] = &["outer", "inner", "machine", "heat_treatment", "allowances"];
/// The keys of a blank.
pub(super) const BLANK: &[&str] =
    &["kind", "diameter", "bore", "length", "face", "length_tolerance", "steps", "outer", "inner"];
/// The keys of roughing.
pub(super) const ROUGHING: &[&str] = &["limiting_depth", "scheme"];
/// The keys of allowances.
pub(super) const ALLOWANCES: &[&str] = &["method", "on_diameter", "on_face", "errors"];
/// The keys of the errors of the analytic method.
pub(super) const ERRORS: &[&str] = &["rz_um", "defect_layer_um", "spatial_deviation_um", "setup_error_um"];
/// The keys of rates.
pub(super) const RATES: &[&str] = &[
    "longitudinal_feed",
    "transverse_feed",
    "rapid",
    "approach",
    "retract",
    "infeed",
    "pick_up_feed",
    "semi_finishing_feed",
    "finishing_feed",
];
/// The keys of a point.
pub(super) const POINT: &[&str] = &["d", "z"];
/// The keys of a stretch along the axis.
pub(super) const STRETCH: &[&str] = &["length"];
/// What a surface may say of itself.
pub(super) const SAID: &[&str] = &["name", "grade", "roughness", "allowance"];
/// The keys that say what an item is, each with the keys beside it.
pub(super) const ITEMS: &[(&str, &[&str])] = &[
    ("from", &[]),
    ("face", &[]),
    ("cylinder", &[]),
    ("cone", &["kind"]),
    ("chamfer", &[]),
    ("arc", &["radius", "bulge"]),
    ("thread", &["to", "length"]),
    ("groove", &["width", "depth", "angle", "radius"]),
];
/// The items that a blank may have.
pub(super) const BLANK_ITEMS: &[&str] = &["from", "face", "cylinder", "cone", "chamfer", "arc"];
