//! Row types: lathes.

use technolog_knowledge::rows;

rows! {
    /// The quantities a lathe's catalog must name.
    pub struct LatheQuantities of One("lathe-quantities") {
        name: &'t str,
        unit: Option<&'t str>,
        required: bool,
    }

    /// A characteristic of a lathe.
    pub struct LatheRecord of Record("lathe-quantities") {
        name: &'t str,
        value: Option<Vec<f64>>,
        unit: Option<&'t str>,
        text: Option<&'t str>,
    }
}
