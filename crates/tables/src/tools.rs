//! Row types: tools.

use technolog_knowledge::units::{Degrees, Kilograms, Micrometres};
use technolog_knowledge::{rows, vocabulary};

vocabulary! {
    /// What of boring a bar is made for.
    pub enum BoringStage {
        Rough = "rough",
        Finish = "finish",
    }
}

rows! {
    /// Rake of the seat by the clearance of the insert.
    pub struct InsertRake of One("insert-rake") {
        clearance: &'t str,
        rake: Degrees,
    }

    /// Insert shapes and their included angle.
    pub struct InsertShapes of One("insert-shapes") {
        shape: &'t str,
        included_angle: Degrees,
    }

    /// A cutter for holes.
    pub struct CutterRow of Tools {
        designation: Option<&'t str>,
        designation_through: Option<&'t str>,
        designation_blind: Option<&'t str>,
        designation_5deg: Option<&'t str>,
        designation_15deg: Option<&'t str>,
        diameter: Option<Micrometres>,
        diameter_min: Option<Micrometres>,
        diameter_max: Option<Micrometres>,
        step_diameter: Option<Micrometres>,
        step_length: Option<Micrometres>,
        thread: Option<&'t str>,
        pitch: Option<Micrometres>,
        cone_angle: Option<Degrees>,
        tip_diameter: Option<Micrometres>,
        stage: Option<BoringStage>,
        length: Option<Micrometres>,
        projection: Option<Micrometres>,
        reach: Option<Micrometres>,
        flute_length: Option<Micrometres>,
        cutting_length: Option<Micrometres>,
        shank_diameter: Option<Micrometres>,
        shank_length: Option<Micrometres>,
        morse: Option<i64>,
        bore: Option<Micrometres>,
        pilot_bore: Option<Micrometres>,
        bar_diameter: Option<Micrometres>,
        nose_radius: Option<Micrometres>,
        teeth: Option<i64>,
        mass: Option<Kilograms>,
    } shown { helix_angle, accuracy, preferred_row, "type", execution, neck_diameter, insert, taper, series }

    /// A turning tool.
    pub struct TurningToolRow of Each(&["turning-boring-bars", "turning-grooving-tools", "turning-outer-tools", "turning-threading-tools"]) {
        designation: &'t str,
        kind: &'t str,
        place_of_work: &'t str,
        hand: &'t str,
        lead_angle: Degrees,
        trail_angle: Degrees,
        nose_radius: Option<Micrometres>,
        insert: Option<&'t str>,
        edge: Option<Micrometres>,
        bar_diameter: Option<Micrometres>,
        min_bore: Option<Micrometres>,
        length: Option<Micrometres>,
        reach: Option<Micrometres>,
        grades: Option<Vec<&'t str>>,
        width: Option<Micrometres>,
        groove_depth: Option<Micrometres>,
        face_diameter_min: Option<Micrometres>,
        shank_height: Option<Micrometres>,
        shank_width: Option<Micrometres>,
        pitch_min: Option<Micrometres>,
        pitch_max: Option<Micrometres>,
    }
}

impl<'t> CutterRow<'t> {
    /// Its designations: one, or one for each bottom of the hole or lead of the reamer.
    pub fn designations(&self) -> impl Iterator<Item = &'t str> + use<'t> {
        let all = [self.designation, self.designation_through, self.designation_blind];
        all.into_iter().chain([self.designation_5deg, self.designation_15deg]).flatten()
    }
}
