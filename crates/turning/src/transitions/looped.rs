//! The loop (петля; lecture l. 314-324).

use super::builder::ToolpathBuilder;
use super::split::Split;
use super::straight::{Back, clear};

/// Straight passes without anything after them.
///
/// 1. The tool cuts along the axis to the contour ahead.
/// 2. It is drawn back about 0.5 mm from the machined surface (l. 316).
/// 3. It returns as a rapid, and goes down to the next depth.
///
/// The contour keeps the ridges between the levels; where it has none, in open zones over a cylinder, what is left for
/// finishing is even (l. 490-494). Used most in open and half-open zones (l. 318-320).
///
/// Against a stop (від упора, l. 320-324) it is the same with levels that begin anew at each cylinder of a stepped
/// roller: each pass goes at the full depth to the shoulder where its step ends, and the last of a step on its cylinder.
pub fn work(course: &mut ToolpathBuilder<'_>, split: &Split) {
    for section in &split.sections {
        clear(course, section, Back::ThroughAir);
    }
    if course.passes > 0 {
        course.draw_back();
    }
}
