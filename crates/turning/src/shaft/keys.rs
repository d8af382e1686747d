//! The keys of a shaft file, for the reader and for the schema.

/// The keys of a shaft.
pub(super) const SHAFT: &[&str] = &["shaft", "material", "blank", "holding", "steps", "roughing", "rates"];
/// The keys of a blank.
pub(super) const BLANK: &[&str] = &["kind", "diameter", "length", "steps"];
/// The keys of a step.
pub(super) const STEP: &[&str] = &["diameter", "length"];
/// The keys of roughing.
pub(super) const ROUGHING: &[&str] = &["longitudinal_depth", "transverse_depth", "division", "moves"];
/// The keys of rates.
pub(super) const RATES: &[&str] = &["longitudinal_feed", "transverse_feed", "rapid", "approach", "retract"];
