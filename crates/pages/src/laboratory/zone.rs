//! The working zone from the front, in scale: the table, what the part lies on, the part, and the longest tool over the zero
//! of the part, at the level where the program first approaches. Set-up by set-up.

use crate::machine::Machine;
use crate::plan::{Plan, Stand};
use crate::tables::machines::MachineQuantity;
use crate::units::Micrometres;

use super::super::canvas::{Anchor, At, Canvas, Pen};
use super::super::words::say;
use super::Lang;

const WIDTH: f64 = 680.0;
const MARGIN: f64 = 20.0;
/// What the figures at the right need.
const FIGURES: f64 = 190.0;
const TALLEST: f64 = 420.0;
const INK: Pen = Pen::solid("#333", 1.2);
const THIN: Pen = Pen::solid("#888", 0.8);
/// The table on the page: only its upper side matters.
const TABLE: f64 = 16.0;

/// The drawing of a set-up and the number of its longest tool; none if the plan does not say how high the spindle stands.
pub(super) fn drawing(plan: &Plan, stand: &Stand, machine: &Machine<'_>, lang: Lang) -> Option<(u32, String)> {
    let nose = stand.nose_to_table_mm?;
    let in_setup = plan.sequence.iter().filter(|visit| visit.setup == stand.set_up).map(|visit| visit.tool);
    let tools = in_setup.filter_map(|number| plan.tools.iter().find(|tool| tool.number == number));
    let tool = tools.max_by_key(|tool| tool.length_mm)?;
    let of_table = machine.characteristics().find(|own| own.name == MachineQuantity::TableLength.name());
    let table = of_table.and_then(|own| own.values.first().copied()).map(Micrometres::from_mm_rounded)?;
    let part = &plan.part;
    let scale = ((WIDTH - 2.0 * MARGIN - FIGURES) / table.to_mm().max(1.0)).min(TALLEST / nose.to_mm().max(1.0));
    let floor = MARGIN + 34.0 + nose.to_mm() * scale;
    let middle = MARGIN + table.to_mm() * scale / 2.0;
    // Lengths from the middle of the table, heights over it.
    let at = |x: f64, z: f64| -> At { (middle + x * scale, floor - z * scale) };
    let (low, top) = (stand.height_mm.to_mm(), (stand.height_mm + part.blank.thickness).to_mm());
    let (left, right) = (stand.corner_mm.x.to_mm(), (stand.corner_mm.x + part.blank.length).to_mm());
    let mut canvas = Canvas::default();
    let half = table.to_mm() / 2.0;
    let (edge, side) = (at(-half, 0.0), at(half, 0.0));
    canvas.rectangle(edge, (side.0, floor + TABLE), "#e6e6e6", Some(INK));
    if low > 0.0 {
        let wide = ((right - left) * 0.08).max(4.0 / scale);
        for x in [left + wide, right - 2.0 * wide] {
            canvas.rectangle(at(x, 0.0), at(x + wide, low), "#f0e6dc", Some(INK));
        }
    }
    canvas.rectangle(at(left, low), at(right, top), "#f4f4f4", Some(INK));
    // The spindle with the tool, over the zero of the drawing as the part lies.
    let zero = left - part.datum.left.to_mm();
    let tip = nose - tool.length_mm;
    let (axis, face) = at(zero, nose.to_mm());
    let wide = 20.0_f64.max(40.0 * scale);
    canvas.rectangle((axis - wide, MARGIN), (axis + wide, face), "#e6e6e6", Some(INK));
    let joint = at(zero, (nose - (tool.length_mm - tool.overhang_mm)).to_mm()).1;
    let thick = (tool.diameter_mm.to_mm() * scale / 2.0).max(1.5);
    canvas.rectangle((axis - wide / 2.0, face), (axis + wide / 2.0, joint), "white", Some(INK));
    canvas.rectangle((axis - thick, joint), (axis + thick, at(zero, tip.to_mm()).1), "white", Some(INK));
    canvas.line(&[(axis, MARGIN - 8.0), (axis, floor)], Pen::dashed("#999", 0.7));
    canvas.text((axis + wide + 6.0, MARGIN + 14.0), 12.0, Anchor::Start, &format!("T{}", tool.number));
    let gap = tip - stand.height_mm - part.blank.thickness;
    let heights = [
        (0.0, nose.to_mm(), say!(lang, "lab-zone-nose", height = nose)),
        (tip.to_mm(), nose.to_mm(), say!(lang, "lab-zone-tool", length = tool.length_mm)),
        (top, tip.to_mm(), say!(lang, "lab-zone-gap", height = gap)),
        (low, top, say!(lang, "lab-zone-part", height = part.blank.thickness)),
        (0.0, low, say!(lang, "lab-zone-supports", height = stand.height_mm)),
    ];
    figures(&mut canvas, &heights, side.0, &|z| at(0.0, z).1, axis);
    let below = floor + TABLE + 18.0;
    canvas.line(&[(edge.0, below), (side.0, below)], THIN);
    canvas.head((edge.0, below), (side.0, below), THIN);
    canvas.head((side.0, below), (edge.0, below), THIN);
    canvas.text((middle, below + 14.0), 12.0, Anchor::Middle, &say!(lang, "lab-zone-table", length = table));
    Some((tool.number, canvas.page(WIDTH, below + 26.0)))
}

/// The heights at the right, each with its own line; texts that would stand in one another are moved down.
fn figures(canvas: &mut Canvas, heights: &[(f64, f64, String)], side: f64, y: &dyn Fn(f64) -> f64, from: f64) {
    let [whole, parts @ ..] = heights else { return };
    let mut last = f64::NEG_INFINITY;
    let one = |canvas: &mut Canvas, x: f64, own: &(f64, f64, String), row: f64| {
        let (low, high) = (y(own.0), y(own.1));
        for level in [low, high] {
            canvas.line(&[(from + 24.0, level), (x + 4.0, level)], Pen::solid("#ccc", 0.6));
        }
        canvas.line(&[(x, low), (x, high)], THIN);
        canvas.head((x, high), (x, low), THIN);
        canvas.head((x, low), (x, high), THIN);
        canvas.line(&[(x, (low + high) / 2.0), (x + 10.0, row - 4.0)], Pen::solid("#ccc", 0.6));
        canvas.text((x + 12.0, row), 11.0, Anchor::Start, &own.2);
    };
    for own in parts.iter().filter(|own| own.1 > own.0) {
        let row = ((y(own.0) + y(own.1)) / 2.0 + 4.0).max(last + 15.0);
        last = row;
        one(canvas, side + 14.0, own, row);
    }
    // The whole height stands farther out, its text above all others.
    one(canvas, side + 100.0, whole, y(whole.1) - 6.0);
}
