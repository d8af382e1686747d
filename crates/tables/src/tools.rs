//! Row types: tools.

use technolog_knowledge::units::{Degrees, Kilograms, Micrometres};
use technolog_knowledge::{rows, vocabulary};

vocabulary! {
    /// The stage of boring for which a bar is made.
    pub enum BoringStage {
        Rough = "rough",
        Finish = "finish",
    }
}

rows! {
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
        carbide_bar: Option<bool>,
        damped_bar: Option<bool>,
        nose_radius: Option<Micrometres>,
        teeth: Option<i64>,
        mass: Option<Kilograms>,
    } shown { helix_angle, accuracy, preferred_row, "type", execution, neck_diameter, insert, taper, series }
}

impl<'t> CutterRow<'t> {
    /// Its designations: one, or one for each bottom of the hole or lead of the reamer.
    pub fn designations(&self) -> impl Iterator<Item = &'t str> + use<'t> {
        let all = [self.designation, self.designation_through, self.designation_blind];
        all.into_iter().chain([self.designation_5deg, self.designation_15deg]).flatten()
    }

    /// Whether it is a tap whose shank is thinner than its tapping hole, so that it follows the thread in.
    pub fn shank_follows(&self) -> bool {
        let all = (self.pitch, self.diameter, self.shank_diameter);
        matches!(all, (Some(pitch), Some(diameter), Some(shank)) if shank < diameter - pitch)
    }
}
