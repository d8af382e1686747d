//! Row types: standards.

use technolog_knowledge::rows;
use technolog_knowledge::units::{ItGrade, Micrometres, Microns};

rows! {
    /// Clearance holes for fasteners.
    pub struct ClearanceHoles of One("clearance-holes") {
        thread: &'t str,
        diameter: Micrometres,
        row1: Micrometres,
        row2: Micrometres,
        row3: Micrometres,
    }

    /// Inch conical threads.
    pub struct ConicalThreads of One("conical-threads") {
        thread: &'t str,
        size: Micrometres,
        pitch: Micrometres,
        minor_diameter: Micrometres,
        thread_length: Micrometres,
        main_plane: Micrometres,
        drill: Micrometres,
    }

    /// Counterbores for socket heads and hex bearing faces.
    pub struct Counterbores of One("counterbores") {
        thread: &'t str,
        counterbore_diameter: Micrometres,
        clearance_hole: Micrometres,
        head_height: Micrometres,
        depth: Micrometres,
        hex_bearing_diameter: Option<Micrometres>,
    }

    /// Countersinks 90 deg for countersunk screws.
    pub struct Countersinks of One("countersinks") {
        thread: &'t str,
        diameter_min: Micrometres,
        diameter_max: Micrometres,
    }

    /// Reliefs for the grinding wheel.
    pub struct GrindingRelief of One("grinding-relief") asked by GrindingReliefFor {
        diameter: Micrometres,
    } {
        width: Micrometres,
        depth: Micrometres,
    }

    /// Standard tolerances IT5 to IT14.
    pub struct ItGrades of One("it-grades") asked by ItGradesFor {
        it: ItGrade,
        diameter: Micrometres,
    } {
        tolerance: Micrometres,
    }

    /// Morse tapers 1 to 5.
    pub struct MorseTapers of One("morse-tapers") {
        morse: i64,
        tang_length: Micrometres,
        drawbar_length: Micrometres,
        large_diameter: Micrometres,
    }

    /// Rz and Ra beside each other.
    pub struct RaRz of One("ra-rz") {
        rz: Microns,
        ra_preferred: Microns,
        ra_by_class: Option<Microns>,
    }

    /// Roughness classes 3 to 9.
    pub struct RoughnessClasses of One("roughness-classes") {
        class: i64,
        rz_coarsest: Option<Microns>,
        rz_finest: Option<Microns>,
        ra_coarsest: Microns,
        ra_finest: Microns,
    }

    /// Tap drills, fine metric threads.
    pub struct TapDrillsFine of One("tap-drills-fine") {
        thread: &'t str,
        pitch: Micrometres,
        diameter: Micrometres,
    }

    /// Tap drills, coarse metric threads.
    pub struct TapDrills of One("tap-drills") {
        thread: &'t str,
        pitch: Micrometres,
        diameter: Micrometres,
        hole_nominal_6h: Option<Micrometres>,
    }

    /// 7:24 taper shanks.
    pub struct Taper724 of One("taper-7-24") {
        number: i64,
        large_diameter: Micrometres,
        taper_length: Micrometres,
        thread: &'t str,
    }

    /// Reliefs at the end of external metric threads.
    pub struct ThreadRelief of One("thread-relief") {
        pitch: Micrometres,
        width: Micrometres,
        depth: Micrometres,
    }
}
