//! The working zone from the front, in scale: the table, what the part lies on, the part, and the longest tool over the zero
//! of the part while the quill is retracted. Set-up by set-up.

use crate::machine::Machine;
use crate::plan::{Held, Plan, Stand};
use crate::tables::machines::MachineQuantity;
use crate::units::Micrometres;

use super::super::canvas::{Anchor, At, Canvas, Pen};
use super::super::words::say;
use super::Lang;

const WIDTH: f64 = 680.0;
const MARGIN: f64 = 20.0;
/// What the figures at the right need.
const FIGURES: f64 = 150.0;
/// What the height of the spindle needs at the left.
const LEFT: f64 = 30.0;
const TALLEST: f64 = 460.0;
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
    let (left, right) = (stand.corner_mm.x.to_mm(), (stand.corner_mm.x + part.blank.length).to_mm());
    // Of a long table as much as the part and the spindle need; it is broken off on both sides.
    let whole = table.to_mm() / 2.0;
    let half = whole.min(1.3 * left.abs().max(right.abs()).max(nose.to_mm() / 2.0));
    let room = WIDTH - 2.0 * MARGIN - FIGURES - LEFT;
    let scale = (room / (2.0 * half).max(1.0)).min(TALLEST / nose.to_mm().max(1.0));
    let floor = MARGIN + 34.0 + nose.to_mm() * scale;
    let middle = MARGIN + LEFT + room / 2.0;
    // Lengths from the middle of the table, heights over it.
    let at = |x: f64, z: f64| -> At { (middle + x * scale, floor - z * scale) };
    let (low, top) = (stand.height_mm.to_mm(), (stand.height_mm + part.blank.thickness).to_mm());
    let mut canvas = Canvas::default();
    let (edge, side) = (at(-half, 0.0), at(half, 0.0));
    canvas.rectangle(edge, (side.0, floor + TABLE), "#e6e6e6", Some(INK));
    if let Some(chuck) = &plan.setup.chuck {
        // Its body, two jaws beside the part as they would stand if they stood along X, and what the part lies on.
        let (axis, body) = ((left + right) / 2.0, low - chuck.room_mm.to_mm());
        let [half, from, jaw] =
            [chuck.diameter_mm.half(), chuck.jaws_from_mm, part.blank.thickness - chuck.below_face_mm]
                .map(Micrometres::to_mm);
        canvas.rectangle(at(axis - half, 0.0), at(axis + half, body), "#f0e6dc", Some(INK));
        for (inner, outer) in [(-from, left - axis), (from, right - axis)] {
            let end = if inner < outer { outer.max(half) } else { outer.min(-half) };
            for (x, top) in [(inner, low), (outer, low + jaw)] {
                let (a, b) = if x < end { (x, end) } else { (end, x) };
                canvas.rectangle(at(axis + a, body), at(axis + b, top), "#f0e6dc", Some(INK));
            }
        }
    } else if plan.setup.vice.is_some() {
        // Its jaws are not drawn: the plan knows how high it holds the part, not how they look.
        canvas.rectangle(at(left, 0.0), at(right, low), "#f0e6dc", Some(INK));
    } else if low > 0.0 {
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
    let x = MARGIN + 6.0;
    canvas.line(&[(x - 4.0, face), (axis - wide, face)], Pen::solid("#ccc", 0.6));
    canvas.line(&[(x - 4.0, floor), (edge.0, floor)], Pen::solid("#ccc", 0.6));
    height(&mut canvas, x, floor, face);
    let heights = [
        (tip.to_mm(), nose.to_mm(), say!(lang, "lab-zone-tool", length = tool.length_mm)),
        (top, tip.to_mm(), say!(lang, "lab-zone-gap", height = gap)),
        (low, top, say!(lang, "lab-zone-part", height = part.blank.thickness)),
        match plan.held(stand.set_up) {
            Held::Vice(_) => (0.0, low, say!(lang, "lab-zone-vice", height = stand.height_mm)),
            Held::Chuck(_) => (0.0, low, say!(lang, "lab-zone-chuck", height = stand.height_mm)),
            _ => (0.0, low, say!(lang, "lab-zone-supports", height = stand.height_mm)),
        },
    ];
    figures(&mut canvas, &heights, side.0, &|z| at(0.0, z).1, axis);
    let below = floor + TABLE + 18.0;
    let length = say!(lang, "lab-zone-table", length = table);
    if half < whole {
        // The ends are not those of the table: the length is told, not measured off.
        for x in [edge.0, side.0] {
            canvas.rectangle((x - 4.0, floor - 2.0), (x + 4.0, floor + TABLE + 2.0), "white", None);
        }
        canvas.text((middle, below), 12.0, Anchor::Middle, &length);
    } else {
        canvas.line(&[(edge.0, below), (side.0, below)], THIN);
        canvas.head((edge.0, below), (side.0, below), THIN);
        canvas.head((side.0, below), (edge.0, below), THIN);
        canvas.text((middle, below + 14.0), 12.0, Anchor::Middle, &length);
    }
    // Beside its line it would stand in the tool over a narrow part.
    let foot = below + 30.0;
    canvas.text((x - 4.0, foot), 11.0, Anchor::Start, &say!(lang, "lab-zone-nose", height = nose));
    Some((tool.number, canvas.page(WIDTH, foot + 12.0)))
}

/// The heights at the right, each with its own line; texts that would stand in one another are moved down.
fn figures(canvas: &mut Canvas, heights: &[(f64, f64, String)], side: f64, y: &dyn Fn(f64) -> f64, from: f64) {
    let mut last = f64::NEG_INFINITY;
    for (low, high, text) in heights.iter().filter(|own| own.1 > own.0) {
        let (low, high) = (y(*low), y(*high));
        let row = ((low + high) / 2.0 + 4.0).max(last + 15.0);
        last = row;
        let x = side + 14.0;
        for level in [low, high] {
            canvas.line(&[(from + 24.0, level), (x + 4.0, level)], Pen::solid("#ccc", 0.6));
        }
        height(canvas, x, low, high);
        canvas.line(&[(x, (low + high) / 2.0), (x + 10.0, row - 4.0)], Pen::solid("#ccc", 0.6));
        canvas.text((x + 12.0, row), 11.0, Anchor::Start, text);
    }
}

/// An upright dimension line.
fn height(canvas: &mut Canvas, x: f64, low: f64, high: f64) {
    canvas.line(&[(x, low), (x, high)], THIN);
    canvas.head((x, high), (x, low), THIN);
    canvas.head((x, low), (x, high), THIN);
}
