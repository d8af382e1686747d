//! Row types: standards.

use technolog_knowledge::contract::Named;
use technolog_knowledge::units::{ItGrade, Micrometres};
use technolog_knowledge::{rows, vocabulary};

rows! {
    /// Clearance holes for fasteners.
    pub struct ClearanceHoles of One("clearance-holes") {} shown { thread, diameter, row1, row2, row3 }

    /// Inch conical threads.
    pub struct ConicalThread of One("conical-threads") {
        thread: &'t str,
        size: Micrometres,
        pitch: Micrometres,
        thread_length: Micrometres,
        drill: Micrometres,
    } shown { minor_diameter, main_plane }

    /// Counterbores for socket heads and hex bearing faces.
    pub struct Counterbores of One("counterbores") {} shown {
        thread,
        counterbore_diameter,
        clearance_hole,
        head_height,
        depth,
        hex_bearing_diameter,
    }

    /// Countersinks 90 deg for countersunk screws.
    pub struct Countersinks of One("countersinks") {} shown { thread, diameter_min, diameter_max }

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

    /// Fundamental deviations of shafts.
    pub struct FundamentalDeviation of One("fundamental-deviations") asked by FundamentalDeviationFor<'t> {
        letters: &'t str,
        grade: ItGrade,
        diameter: Micrometres,
    } {
        deviation: Micrometres,
    }

    /// Morse tapers 1 to 5.
    pub struct MorseTaper of One("morse-tapers") {
        morse: i64,
        tang_length: Micrometres,
    } shown { drawbar_length, large_diameter }

    /// Pairs of Rz and Ra.
    pub struct RaRz of One("ra-rz") {} shown { rz, ra_preferred, ra_by_class }

    /// Roughness classes 3 to 9.
    pub struct RoughnessClasses of One("roughness-classes") {} shown { class, rz_coarsest, rz_finest, ra_coarsest, ra_finest }

    /// Tap drills, fine metric threads.
    pub struct FineThread of One("tap-drills-fine") {
        thread: &'t str,
        pitch: Micrometres,
        diameter: Micrometres,
    }

    /// Tap drills, coarse metric threads.
    pub struct CoarseThread of One("tap-drills") {
        thread: &'t str,
        pitch: Micrometres,
        diameter: Micrometres,
    } shown { hole_nominal_6h }

    /// Spindle noses and collars of holders.
    pub struct SpindleNose of One("spindle-noses") {
        number: i64,
        nose_diameter: Micrometres,
        collar_diameter: Micrometres,
        collar_length: Micrometres,
    }

    /// 7:24 taper shanks.
    pub struct Taper724 of One("taper-7-24") {} shown { number, large_diameter, taper_length, thread }

    /// Reliefs at the end of external metric threads.
    pub struct ThreadRelief of One("thread-relief") {
        pitch: Micrometres,
        width: Micrometres,
        depth: Micrometres,
    }

    /// Deviations of metric threads and the tolerance of their crests, by pitch.
    pub struct ThreadDeviations of One("thread-deviations") {
        pitch: Micrometres,
        e: Micrometres,
        f: Micrometres,
        g: Micrometres,
        crest_4: Micrometres,
        crest_6: Micrometres,
        crest_8: Option<Micrometres>,
        minor_6: Micrometres,
    }

    /// Constants of the minor diameter of internal metric threads.
    pub struct ThreadMinorDiameter of One("thread-minor-diameter") complete name {
        name: Named<'t, MinorDiameterConstant>,
        value: f64,
    } shown { used }

    /// General tolerances of linear sizes, to either side.
    pub struct GeneralTolerance of One("general-tolerances") {
        over: Micrometres,
        up_to: Micrometres,
        medium: Micrometres,
    }

    /// Tolerance of the pitch diameter of metric threads, by range of diameters and pitch.
    pub struct ThreadPitchTolerance of One("thread-pitch-tolerance") {
        over: Micrometres,
        up_to: Micrometres,
        pitch: Micrometres,
        outer_4: Micrometres,
        outer_5: Micrometres,
        outer_6: Micrometres,
        outer_7: Micrometres,
        outer_8: Option<Micrometres>,
        inner_4: Micrometres,
        inner_5: Micrometres,
        inner_6: Micrometres,
        inner_7: Micrometres,
        inner_8: Option<Micrometres>,
    }
}

vocabulary! {
    /// A constant of the minor diameter of internal metric threads.
    pub enum MinorDiameterConstant {
        MinorHeight = "minor-height",
        FineLinear = "fine-linear",
        FinePower = "fine-power",
        FineExponent = "fine-exponent",
        CoarseFactor = "coarse-factor",
        CoarseExponent = "coarse-exponent",
        CoarseFrom = "coarse-from",
    }
}
