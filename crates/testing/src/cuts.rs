//! Cuts to ask the conditions of.

use technolog::cutting::{Cut, Surface};
use technolog::knowledge::vocabulary::ToolMaterial;
use technolog::plan::Operation;
use technolog::units::Micrometres;

/// One pass of a high-speed steel tool through clean metal, with nothing else asked of it.
pub fn plain_cut(operation: Operation, from: Micrometres, diameter: Micrometres) -> Cut {
    Cut {
        operation,
        diameter,
        from,
        passes: 1,
        depth: diameter,
        travel: diameter,
        tool_material: ToolMaterial::HighSpeedSteel,
        nose_radius: None,
        roughness: None,
        reamer_follows: false,
        blind: false,
        surface: Surface::None,
        it: None,
        pitch: None,
        around: None,
        plunges: false,
        slot: None,
        cutter: None,
        feed_diameter: None,
        tool_diameter: None,
        flutes: None,
    }
}
