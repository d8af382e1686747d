//! The keys of a plan file; `super::file` holds the same for the schema, and a test holds the two together.

/// Of the file.
pub const PLAN: &[&str] = &["plan", "part", "cutting", "route", "tools", "conditions", "clamping", "program", "times"];
/// Of a row of the route.
pub const ROW: &[&str] = &[
    "row",
    "operation",
    "hole",
    "feature",
    "step",
    "setup",
    "count",
    "diameter",
    "also",
    "from",
    "depth",
    "passes",
    "tool",
    "elsewhere",
    "scheme",
    "table",
];
/// Of a tool.
pub const TOOL: &[&str] = &[
    "designation",
    "standard",
    "table",
    "diameter",
    "length",
    "flute_length",
    "projection",
    "point_angle",
    "shank",
    "shank_diameter",
    "morse",
    "holder",
    "overhang",
    "holder_used",
    "assembly",
    "corrector",
    "correction",
    "reference_length",
    "with",
];
/// Of a holder.
pub const HOLDER: &[&str] = &["designation", "standard", "clamp_min", "clamp_max", "morse", "length"];
/// Of conditions.
pub const CONDITIONS: &[&str] = &[
    "for",
    "count",
    "diameter",
    "depth_of_cut",
    "passes",
    "card",
    "factors",
    "feed",
    "feed_taken",
    "speed",
    "rpm_computed",
    "rpm",
    "limited_by",
    "speed_taken",
    "minute_feed",
    "force",
    "power",
    "torque",
    "travel",
    "time",
    "tool_life",
];
/// Of the figures of a card.
pub const CARD: &[&str] = &["feed", "speed", "force", "power"];
/// Of the clamping.
pub const CLAMPING: &[&str] = &[
    "for",
    "hole",
    "power",
    "rpm",
    "torque",
    "safety",
    "friction",
    "distance",
    "force",
    "clamps",
    "at",
    "force_per_clamp",
    "screw",
    "designation",
    "standard",
];
/// Of the program.
pub const PROGRAM: &[&str] = &["file", "control", "setting"];
/// Of the times.
pub const TIMES: &[&str] = &["machine", "rapid", "tool_change", "total"];
