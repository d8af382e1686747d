//! The loop (петля; lecture l. 314-324).

use super::builder::ToolpathBuilder;
use super::split::Split;
use super::straight::{Back, clear};

/// Straight passes only.
///
/// 1. The tool cuts along the axis to the contour ahead.
/// 2. It retracts about 0.5 mm from the machined surface (l. 316).
/// 3. It returns as a rapid, and moves down to the next depth.
///
/// Ridges remain between the levels. Where there are none, in open zones over a cylinder, the allowance for finishing
/// is even (l. 490-494). Used most in open and half-open zones (l. 318-320).
///
/// Against a stop (від упора, l. 320-324) it is the same, but levels begin again at each cylinder of a stepped
/// roller: each pass is at the full depth to the shoulder of its step, and the last one of a step goes along its
/// cylinder.
pub fn work(builder: &mut ToolpathBuilder<'_>, split: &Split) {
    for section in &split.sections {
        clear(builder, section, Back::ThroughAir);
    }
    if builder.passes > 0 {
        builder.draw_back();
    }
}
