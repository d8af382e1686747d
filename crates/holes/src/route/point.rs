//! The points of drills: their angle by the catalogs, and their height.

use crate::knowledge::Knowledge;
use crate::plan::Operation;
use crate::units::{Decimal, Micrometres};

/// The sharpest point angle in the tables of an operation's cutters, degrees. It gives the longest cone, so every
/// cutter of them clears the hole. 180, a flat end, where no table states an angle.
pub fn point_angle(knowledge: &Knowledge, operation: Operation) -> f64 {
    knowledge
        .tables_of_cutters()
        .filter_map(|table| table.tool.as_ref())
        .filter(|head| head.operations.contains(&operation))
        .filter_map(|head| head.point_angle)
        .min()
        .map_or(180.0, Decimal::to_f64)
}

/// Height of a cone over a diameter: d/2 / tan(φ/2), the point of a drill or the lead of a core drill.
pub fn cone(diameter: Micrometres, angle_deg: f64) -> Micrometres {
    Micrometres::from_mm_rounded(diameter.to_mm() / 2.0 / libm::tan((angle_deg / 2.0).to_radians()))
}
