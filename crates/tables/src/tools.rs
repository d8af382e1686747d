//! Row types: tools.

use technolog_knowledge::rows;
use technolog_knowledge::units::{Degrees, Kilograms, Micrometres};

rows! {
    /// A cutter for holes.
    pub struct CutterRow of Tools {
        designation: Option<&'t str>,
        diameter: Option<Micrometres>,
        length: Option<Micrometres>,
        flute_length: Option<Micrometres>,
        helix_angle: Option<Degrees>,
        projection: Option<Micrometres>,
        morse: Option<i64>,
        accuracy: Option<&'t str>,
        thread: Option<&'t str>,
        step_diameter: Option<Micrometres>,
        step_length: Option<Micrometres>,
        pitch: Option<Micrometres>,
        designation_through: Option<&'t str>,
        designation_blind: Option<&'t str>,
        shank_diameter: Option<Micrometres>,
        shank_length: Option<Micrometres>,
        bore: Option<Micrometres>,
        preferred_row: Option<i64>,
        type_ as "type": Option<i64>,
        cone_angle: Option<Degrees>,
        tip_diameter: Option<Micrometres>,
        cutting_length: Option<Micrometres>,
        pilot_bore: Option<Micrometres>,
        designation_5deg: Option<&'t str>,
        designation_15deg: Option<&'t str>,
        teeth: Option<i64>,
        execution: Option<i64>,
        neck_diameter: Option<Micrometres>,
        diameter_min: Option<Micrometres>,
        diameter_max: Option<Micrometres>,
        bar_diameter: Option<Micrometres>,
        reach: Option<Micrometres>,
        nose_radius: Option<Micrometres>,
        insert: Option<&'t str>,
        stage: Option<&'t str>,
        mass: Option<Kilograms>,
        taper: Option<i64>,
        series: Option<&'t str>,
    }
}
