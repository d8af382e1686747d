//! Row types: holders.

use technolog_knowledge::rows;
use technolog_knowledge::units::{Kilograms, Micrometres};

impl HolderRow<'_> {
    /// The tables with such rows.
    pub const TABLES: &'static [&'static str] = &[
        "holders-collet-chucks",
        "holders-morse-drawbar-sleeves",
        "holders-morse-sleeves",
        "holders-shell-arbors",
        "holders-tap-chucks",
    ];
}

rows! {
    /// A holder of cutters.
    pub struct HolderRow of Each(HolderRow::TABLES) {
        designation: &'t str,
        taper: i64,
        clamp_min: Option<Micrometres>,
        clamp_max: Option<Micrometres>,
        length: Micrometres,
        max_diameter: Option<Micrometres>,
        mass: Option<Kilograms>,
        morse: Option<i64>,
        bore: Option<Micrometres>,
        thread_min: Option<Micrometres>,
        thread_max: Option<Micrometres>,
    } shown { synchronous }
}
