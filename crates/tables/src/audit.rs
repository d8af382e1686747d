//! Row types: audit.

use technolog_knowledge::rows;
use technolog_knowledge::units::Percent;

rows! {
    /// Constants people compute with.
    pub struct Constants of One("audit-constants") {
        name: &'t str,
        value: f64,
    }

    /// What of a program has one cause.
    pub struct ProgramCauses of One("audit-program-causes") {
        cause: &'t str,
        consequence: &'t str,
        alike: Option<Vec<&'t str>>,
    }

    /// How a program may differ from its plan.
    pub struct ProgramTolerance of One("audit-program-tolerance") {
        quantity: &'t str,
        whole: f64,
        relative: Percent,
        severity: &'t str,
    }

    /// What may be rounded how.
    pub struct Tolerance of One("audit-tolerance") {
        quantity: &'t str,
        half_places: f64,
        relative: Percent,
        own_places: i64,
        rounded: bool,
        severity: &'t str,
        range: &'t str,
        whole: bool,
    }
}
