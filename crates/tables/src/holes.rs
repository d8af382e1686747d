//! Row types: holes.

use technolog_knowledge::rows;
use technolog_knowledge::units::{ItGrade, Micrometres, Microns, Percent, Roughness};
use technolog_knowledge::vocabulary::Operation;

rows! {
    /// Accuracy and roughness of cylindrical holes by method (A.1).
    pub struct HoleAccuracy of One("A.1") {
        no: i64,
        blank: &'t str,
        method: &'t str,
        method_uk: &'t str,
        it_finest: Option<ItGrade>,
        it_coarsest: Option<ItGrade>,
        ra_coarsest: Microns,
        ra_finest: Microns,
    }

    /// Accuracy and roughness of milled planes (A.2).
    pub struct PlaneAccuracy of One("A.2") {
        no: i64,
        method: &'t str,
        it_coarsest: ItGrade,
        it_finest: ItGrade,
        ra_coarsest: Microns,
        ra_finest: Microns,
    }

    /// Accuracy and roughness of threads (A.3).
    pub struct ThreadAccuracy of One("A.3") {
        method: Operation,
        thread_grade: &'t str,
        ra_coarsest: Microns,
        ra_finest: Microns,
    }

    /// Complex of transitions for a hole (A.4).
    pub struct ComplexForHole of One("A.4") asked by ComplexForHoleFor<'t> {
        hole: &'t str,
        diameter: Micrometres,
        centre_tolerance: Micrometres,
    } {
        group: i64,
        complex: Vec<&'t str>,
    }

    /// What the complexes of transitions consist of (A.5).
    pub struct Complexes of One("A.5") {
        complex: i64,
        tools: i64,
        centre_drilling: bool,
        drilling: bool,
        core_drilling: bool,
        counterboring: bool,
        chamfering: bool,
        rough_reaming: bool,
        finish_reaming: bool,
        tapping: bool,
        transitions: Vec<Operation>,
    }

    /// Routes of hole machining by stages (A.6).
    pub struct RouteStages of One("A.6") asked by RouteStagesFor<'t> {
        hole: &'t str,
        it: ItGrade,
        diameter: Micrometres,
        position: &'t str,
    } {
        stages: Vec<&'t str>,
    }

    /// Schemes of hole machining (A.7).
    pub struct Schemes of One("A.7") {
        scheme: &'t str,
        centre_drilling: Option<i64>,
        drilling: Option<i64>,
        milling: Option<i64>,
        boring_4: Option<i64>,
        core_drilling: Option<i64>,
        boring_6: Option<i64>,
        chamfering: Option<i64>,
        boring_8: Option<i64>,
        counterboring: Option<i64>,
        boring_10: Option<i64>,
        rough_reaming: Option<i64>,
        finish_reaming: Option<i64>,
        tapping: Option<i64>,
        transitions: Vec<Operation>,
    }

    /// Schemes for main holes, IT 6 to 10 (A.8).
    pub struct SchemeMainHolesFine of One("A.8") asked by SchemeMainHolesFineFor<'t> {
        it: ItGrade,
        diameter: Micrometres,
        centre_tolerance: Micrometres,
        roughness: Roughness,
        state: Option<&'t str>,
        outer_wall: Option<bool>,
    } {
        schemes: Vec<&'t str>,
        finish_elsewhere: bool,
    }

    /// Schemes for main holes, IT 11, 13 and coarser (A.9).
    pub struct SchemeMainHolesCoarse of One("A.9") asked by SchemeMainHolesCoarseFor<'t> {
        it: ItGrade,
        diameter: Micrometres,
        centre_tolerance: Micrometres,
        roughness: Roughness,
        state: Option<&'t str>,
        outer_wall: Option<bool>,
    } {
        schemes: Vec<&'t str>,
        if_drill_differs: Option<Vec<&'t str>>,
    }

    /// Schemes for auxiliary holes (A.10).
    pub struct SchemeAuxiliaryHoles of One("A.10") asked by SchemeAuxiliaryHolesFor<'t> {
        hole: &'t str,
        diameter: Micrometres,
        centre_tolerance: Micrometres,
    } {
        schemes: Vec<&'t str>,
        if_drill_differs: Option<Vec<&'t str>>,
    }

    /// Allowances of hole machining.
    pub struct Allowances of One("allowances") {
        name: &'t str,
        minimum: Option<Micrometres>,
        maximum: Option<Micrometres>,
        share: Option<f64>,
    }

    /// Core drills No.1 before reaming.
    pub struct CoreDrillBeforeReaming of One("core-drill-before-reaming") {
        hole_diameter: Micrometres,
        diameter: Micrometres,
    }

    /// Undersize of core drill No.1.
    pub struct CoreDrillUndersize of One("core-drill-undersize") asked by CoreDrillUndersizeFor {
        diameter: Micrometres,
    } {
        undersize: Micrometres,
    }

    /// Depth of cut in core drilling.
    pub struct CoreDrillingDepth of One("core-drilling-depth") asked by CoreDrillingDepthFor {
        diameter: Micrometres,
    } {
        depth: Micrometres,
    }

    /// First drill of two-pass drilling.
    pub struct FirstDrill of One("first-drill") {
        name: &'t str,
        above_diameter: Micrometres,
        share_min: f64,
        share_max: f64,
    }

    /// General conventions on holes.
    pub struct HoleDefaults of One("hole-defaults") {
        name: &'t str,
        value: f64,
    }

    /// Position accuracy of drilled holes.
    pub struct PositionAccuracy of One("position-accuracy") {
        name: &'t str,
        minimum: Option<Micrometres>,
        maximum: Option<Micrometres>,
        loss_min: Option<Percent>,
        loss_max: Option<Percent>,
    }

    /// Depth of cut in reaming.
    pub struct ReamingDepth of One("reaming-depth") asked by ReamingDepthFor {
        diameter: Micrometres,
    } {
        depth: Micrometres,
    }

    /// Step diameters of H7 holes in solid metal.
    pub struct StepDiameters of One("step-diameters") {
        diameter: Micrometres,
        drill_1: Micrometres,
        drill_2: Option<Micrometres>,
        bore: Option<Micrometres>,
        core_drill: Option<Micrometres>,
        rough_ream: Option<Micrometres>,
    }

    /// Accuracy and roughness by transition.
    pub struct TransitionAccuracy of One("transition-accuracy") {
        operation: &'t str,
        it_coarsest: ItGrade,
        it_finest: ItGrade,
        ra_coarsest: Microns,
        ra_finest: Microns,
        prepares: Option<Vec<Operation>>,
    }
}
