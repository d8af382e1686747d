//! Row types: machines.

use technolog_knowledge::rows;

rows! {
    /// The quantities a machine's catalog must name.
    pub struct MachineQuantities of One("machine-quantities") {
        name: &'t str,
        unit: Option<&'t str>,
        required: bool,
    }

    /// A characteristic of a machine.
    pub struct MachineRecord of Record("machine-quantities") {
        name: &'t str,
        value: Option<Vec<f64>>,
        unit: Option<&'t str>,
        text: Option<&'t str>,
    }
}
