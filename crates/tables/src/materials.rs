//! Row types: materials and clamping.

use technolog_knowledge::contract::{Named, Use};
use technolog_knowledge::units::{Brinell, ItGrade, Kilograms, Megapascals, Micrometres, Newtons};
use technolog_knowledge::{rows, vocabulary};

use crate::rules::{PinKind, TableKeying};

vocabulary! {
    /// A constant of clamping or of tool travel.
    pub enum ClampingConstant {
        Friction = "friction",
        SupportFriction = "support-friction",
        Safety = "safety",
        Clamps = "clamps",
        OverhangAddition = "overhang-addition",
        LeastScrew = "least-screw",
        SafetyRounding = "safety-rounding",
        ViceGrip = "vice-grip",
        ViceGripShare = "vice-grip-share",
        ViceBelowFace = "vice-below-face",
        ViceRoomBelow = "vice-room-below",
    }
}

vocabulary! {
    /// What errs when a part is set.
    pub enum SettingErrorOf {
        Straps = "straps",
        Vice = "vice",
        Chuck = "chuck",
        Touch = "touch",
        Truing = "truing",
    }
}

rows! {
    /// Errors of setting a part.
    pub struct SettingError of One("setting-errors") complete name {
        name: Named<'t, SettingErrorOf>,
        least: Micrometres,
        most: Micrometres,
        over: Option<Micrometres>,
    }

    /// Pins that locate a part by a hole of it.
    pub struct LocatingPinRow of One("locating-pins") asked by LocatingPinFor {
        kind: PinKind,
        diameter: Micrometres,
    } {
        standard: &'t str,
        field: &'t str,
        grade: ItGrade,
        land: Option<Micrometres>,
    }

    /// Fits of what keys a fixture to the table.
    pub struct KeyingFit of One("keying-fits") {
        keying: TableKeying,
        hole: &'t str,
        hole_grade: ItGrade,
        shaft: &'t str,
        shaft_grade: ItGrade,
        size: Option<Micrometres>,
    }

    /// Clamps by their designations.
    pub struct ClampDesignations of One("clamp-designations") {
        designation: &'t str,
        standard: &'t str,
        screw: &'t str,
    }

    /// Constants of clamping and of tool travel.
    pub struct Clamping of One("clamping") complete name {
        name: Named<'t, ClampingConstant>,
        minimum: f64,
        maximum: f64,
        use_ as "use": Use,
    } shown { unit }

    /// Clamp screws: force and safe distance.
    pub struct ClampScrew of One("clamp-screws") {
        thread: &'t str,
        nominal_diameter: Micrometres,
        force_80: Newtons,
        safe_distance: Micrometres,
    } shown { force_90, force_100 }

    /// Straps by their screws.
    pub struct StrapRow of One("straps") {
        screw: &'t str,
        slot: Micrometres,
        width: Micrometres,
        length: Micrometres,
        stands: Micrometres,
    }

    /// Machine vices, those that are tried first first.
    pub struct MachineVice of One("vices") {
        designation: &'t str,
        jaw_width: Micrometres,
        opening: Micrometres,
        jaw_height: Micrometres,
        bed_height: Micrometres,
        force: Newtons,
    }

    /// Three-jaw chucks that lie on the table, those that are tried first first; a row for each wall of the steps of their jaws.
    pub struct TableChuck of One("chucks") {
        designation: &'t str,
        step: i64,
        diameter: Micrometres,
        part_diameter_min: Micrometres,
        part_diameter_max: Micrometres,
        part_height: Micrometres,
        room: Micrometres,
        wall: Micrometres,
        jaws_above: Micrometres,
        ledge: Micrometres,
        jaw_width: Micrometres,
        force: Newtons,
        mass: Kilograms,
    }

    /// Parallels under a part in a vice.
    pub struct Parallels of One("parallels") {
        height: Micrometres,
        thinnest: Micrometres,
        thickest: Micrometres,
        length: Micrometres,
    }

    /// Other designations of materials.
    pub struct MaterialAlias of One("material-aliases") {
        alias: &'t str,
        id: &'t str,
    }

    /// Workpiece materials.
    pub struct MaterialGrade of One("materials") {
        id: &'t str,
        designation: &'t str,
        group: &'t str,
        steel_class: &'t str,
        alloy_class: &'t str,
        hardness: Brinell,
        strength: Option<Megapascals>,
        governs: Governs,
    } shown { standard, delivery_state, hardness_min, hardness_max, name_uk, name_en }

    /// Delivery states of steels.
    pub struct DeliveryStates of One("material-states") {
        material: &'t str,
        state: DeliveryState,
        hardness: Option<Brinell>,
        strength: Option<Megapascals>,
    } shown { standard }

    /// Strength of steel by its hardness.
    pub struct HardnessStrength of One("hardness-strength") {
        material_group: &'t str,
        ratio: f64,
        least: f64,
        most: f64,
    }

    /// Density of the metals of a group, kg/m³: the lightest and the heaviest of them.
    pub struct Density of One("densities") {
        material_group: &'t str,
        lightest: f64,
        heaviest: f64,
    }

    /// Between which hardness, HB, metals of a group lie.
    pub struct HardnessBounds of One("hardness-bounds") {
        material_group: &'t str,
        least: Brinell,
        most: Brinell,
    }
}

vocabulary! {
    /// How a steel is delivered.
    pub enum DeliveryState {
        HotRolled = "hot-rolled",
        Annealed = "annealed",
        ColdDrawn = "cold-drawn",
    }

    /// The figure of a grade that describes the state of the blank.
    pub enum Governs {
        Strength = "strength",
        Hardness = "hardness",
        Both = "both",
    }
}
