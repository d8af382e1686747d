//! Row types: top.

use technolog_knowledge::rows;
use technolog_knowledge::units::{Brinell, Megapascals, Micrometres, Newtons};

rows! {
    /// Clamps by their designations.
    pub struct ClampDesignations of One("clamp-designations") {
        designation: &'t str,
        standard: &'t str,
        screw: &'t str,
    }

    /// Constants of clamping and of tool travel.
    pub struct Clamping of One("clamping") {
        name: &'t str,
        minimum: f64,
        maximum: f64,
        unit: &'t str,
    }

    /// Clamp screws: force and safe distance.
    pub struct Clamps of One("clamp-screws") {
        thread: &'t str,
        nominal_diameter: Micrometres,
        force_80: Newtons,
        force_90: Newtons,
        force_100: Newtons,
        safe_distance: Micrometres,
    }

    /// Other designations of materials.
    pub struct MaterialAliases of One("material-aliases") {
        alias: &'t str,
        id: &'t str,
    }

    /// Workpiece materials.
    pub struct Materials of One("materials") {
        id: &'t str,
        designation: &'t str,
        standard: &'t str,
        group: &'t str,
        steel_class: &'t str,
        alloy_class: &'t str,
        delivery_state: &'t str,
        hardness: Brinell,
        strength: Option<Megapascals>,
        hardness_min: Option<Brinell>,
        hardness_max: Option<Brinell>,
        name_uk: &'t str,
        name_en: &'t str,
    }
}
