//! The tool table of LinuxCNC, `tool.tbl`: a line for each tool of an operation.
//!
//! The format is that of the LinuxCNC manual, Tool Compensation, Tool Table Format: tool T, pocket P, offsets X and
//! Z, nose diameter D, front and back angle I and J, orientation Q, a comment after a semicolon. Angles are measured
//! from +Z towards +X (glcanon.py draws the edges so), whether the turret is before or behind the axis.

use std::fmt::Write;

use crate::turning::jobs::{Body, JobTool, Work};
use crate::turning::tooling::{Hand, Place, ToolKind};
use crate::units::Degrees;
use technolog_core::ascii::ascii;

use super::setting::Setting;

/// The control that has such a table.
pub const CONTROL: &str = "linuxcnc";

/// The file; `head` is the comment before its lines, one line of ASCII, `named` the name of a job in its language. The
/// offsets are 0 until they are measured.
pub fn tool_table(setting: &Setting, head: &str, named: impl Fn(Work) -> String) -> String {
    let mut file = format!("; {}\n", ascii(head).replace('\n', " "));
    for tool in &setting.tools {
        let station = &tool.station;
        let number = station.seat.offset;
        let nose = 2.0 * station.tool.nose_radius().to_mm();
        let angles =
            edges(&station.tool).map_or_else(String::new, |(front, back)| format!(" I{:+.3} J{:+.3}", front.0, back.0));
        let orientation = tool.orientation.unwrap_or_default();
        let works: Vec<String> = tool.works.iter().map(|work| ascii(&named(*work))).collect();
        let remark = format!("{}, {}", ascii(&station.tool.designation), works.join(", ")).replace(';', ",");
        // Writing to a string cannot fail.
        let _ = writeln!(file, "T{number} P{number} X+0.000 Z+0.000 D{nose:+.3}{angles} Q{orientation} ;{remark}");
    }
    file
}

/// The directions of the main edge and of the edge behind the tip, from +Z towards +X, 0 to 360°; none for a blade, a
/// thread or a drill, whose shape no pair of edges gives.
fn edges(tool: &JobTool) -> Option<(Degrees, Degrees)> {
    let Body::Insert {
        kind: ToolKind::Turning | ToolKind::Boring, works, hand, lead_angle_deg, trail_angle_deg, ..
    } = tool.body
    else {
        return None;
    };
    // φ is measured from the feed: towards the chuck, for a left-hand tool away from it.
    let (front, back) = match hand {
        Hand::R | Hand::N => (180.0 - lead_angle_deg.0, trail_angle_deg.0),
        Hand::L => (lead_angle_deg.0, 180.0 - trail_angle_deg.0),
    };
    // Inside, the tool is upside down.
    let seen = |angle: f64| Degrees(if works == Place::Inner { 360.0 - angle } else { angle });
    Some((seen(front), seen(back)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shipped;
    use crate::turning::tooling::TurningTool;

    fn edges_of(designation: &str) -> Option<(f64, f64)> {
        let knowledge = shipped::knowledge().unwrap();
        let tool = TurningTool::find(&knowledge, designation).unwrap().unwrap();
        edges(&JobTool::of(&tool)).map(|(front, back)| (front.0, back.0))
    }

    /// By hand from φ and φ1 of the rows: PCLNR φ 95, φ1 5, so the main edge stands 5° short of square to the axis and the
    /// other 5° above it; between them the 80° of its insert. A neutral one has the same on both sides of 90°.
    #[test]
    fn edges_count_from_the_free_end_towards_positive_x() {
        assert_eq!(edges_of("PCLNR 2525M12"), Some((85.0, 5.0)));
        assert_eq!(edges_of("SVVBN 2525M16"), Some((107.5, 72.5)));
        assert_eq!(edges_of("S32U-PCLNR12"), Some((275.0, 355.0)));
        assert_eq!(edges_of("MGEHR 2525-3"), None);
    }
}
