//! The keys of a part file, for the reader and for the schema.

/// The keys of a part.
pub(super) const PART: &[&str] =
    &["part", "material", "blank", "machine", "datum", "entry", "fixture", "position_tolerance", "mass", "holes"];
/// The keys of a blank.
pub(super) const BLANK: &[&str] = &["kind", "length", "width", "thickness"];
/// The keys of a group of holes.
pub(super) const HOLE: &[&str] = &[
    "name",
    "diameter",
    "depth",
    "through",
    "bottom",
    "roughness",
    "centre_tolerance",
    "chamfer",
    "skin",
    "at",
    "cone",
    "thread",
    "counterbore",
    "countersink",
    "face",
    "groove",
    "state",
    "state_diameter",
    "outer_wall",
    "steps",
    "pattern",
];
/// The keys of a diameter given by its limits.
pub(super) const DIAMETER: &[&str] = &["nominal", "upper", "lower"];
/// The keys of a datum.
pub(super) const DATUM: &[&str] = &["x", "y", "z"];
/// The keys of a fixture.
pub(super) const FIXTURE: &[&str] = &["height", "clamps"];
/// The keys of a clamp.
pub(super) const CLAMP: &[&str] = &["at", "screw"];
/// The keys of a cone.
pub(super) const CONE: &[&str] = &["diameter", "angle", "taper"];
/// The keys of a counterbore.
pub(super) const COUNTERBORE: &[&str] = &["diameter", "depth"];
/// The keys of a countersink.
pub(super) const COUNTERSINK: &[&str] = &["diameter", "angle"];
/// The keys of a face around the entry.
pub(super) const FACE: &[&str] = &["diameter"];
/// The keys of a groove.
pub(super) const GROOVE: &[&str] = &["diameter", "width", "depth"];
/// The keys of a step.
pub(super) const STEP: &[&str] = &["diameter", "depth", "length", "roughness", "bottom", "thread", "chamfer"];
/// The kinds of patterns.
pub(super) const PATTERN: &[&str] = &["grid", "line", "circle"];
/// The keys of a grid.
pub(super) const GRID: &[&str] = &["start", "columns", "rows", "step", "angle"];
/// The keys of a line.
pub(super) const LINE: &[&str] = &["start", "count", "step", "angle"];
/// The keys of a circle.
pub(super) const CIRCLE: &[&str] = &["centre", "diameter", "count", "start_angle"];
