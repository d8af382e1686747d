//! Tool assemblies from the side, all in one scale: holder and cutter with their lengths, and the value of the offset register.

use crate::plan::{Plan, ToolPlan};

use super::super::canvas::{Anchor, Canvas, Pen, THIN, width_of};
use super::super::sheet::mm;
use super::super::words::say;
use super::Lang;

const WIDTH: f64 = 680.0;
const MARGIN: f64 = 24.0;
/// The height of a tool with its figures, and how many stand on a sheet.
const ROW: f64 = 114.0;
const ROWS: usize = 8;
/// The widest that a diameter is drawn.
const WIDEST: f64 = 44.0;
const INK: Pen = Pen::solid("#333", 1.2);

/// Sheets of all assemblies.
pub(super) fn sheets(plan: &Plan, lang: Lang) -> Vec<String> {
    let longest = plan.tools.iter().map(|tool| tool.length_mm.to_mm()).fold(1.0, f64::max);
    let widest = plan.tools.iter().map(|tool| tool.diameter_mm.to_mm()).fold(1.0, f64::max);
    let scale = ((WIDTH - 2.0 * MARGIN - 40.0) / longest).min(WIDEST / widest);
    let sheet = |tools: &[ToolPlan]| {
        let mut canvas = Canvas::default();
        for (row, tool) in tools.iter().enumerate() {
            one(&mut canvas, row as f64 * ROW, tool, scale, lang);
        }
        canvas.page(WIDTH, ROW * tools.len() as f64 + 8.0)
    };
    plan.tools.chunks(ROWS).map(sheet).collect()
}

fn one(canvas: &mut Canvas, top: f64, tool: &ToolPlan, scale: f64, lang: Lang) {
    let offset = say!(lang, "lab-assembly-offset", offset = tool.correction_mm);
    let (number, register) = (tool.number, tool.corrector);
    let title = format!(
        "T{number} {} Ø{}; {}; H{register:02}: {offset}",
        tool.designation,
        mm(tool.diameter_mm, lang),
        tool.holder
    );
    canvas.text((MARGIN, top + 18.0), 12.0, Anchor::Start, &title);
    let axis = top + 52.0;
    let holder = tool.length_mm - tool.overhang_mm;
    // The nose of the spindle is the plane that lengths are counted from.
    let nose = MARGIN + 20.0;
    let (joint, end) = (nose + holder.to_mm() * scale, nose + tool.length_mm.to_mm() * scale);
    let half = (tool.diameter_mm.to_mm() * scale / 2.0).max(1.5);
    canvas.rectangle((nose - 12.0, axis - 26.0), (nose, axis + 26.0), "#e6e6e6", Some(INK));
    canvas.rectangle((nose, axis - 16.0), (joint, axis + 16.0), "#f4f4f4", Some(INK));
    canvas.rectangle((joint, axis - half), (end, axis + half), "white", Some(INK));
    canvas.line(&[(nose - 18.0, axis), (end + 10.0, axis)], Pen::dashed("#999", 0.7));
    let texts = [
        (nose, joint, 39.0, holder, say!(lang, "lab-assembly-holder", length = holder)),
        (joint, end, 39.0, tool.overhang_mm, say!(lang, "lab-assembly-overhang", length = tool.overhang_mm)),
        (nose, end, 56.0, tool.length_mm, say!(lang, "lab-assembly-length", length = tool.length_mm)),
    ];
    // A cutter with the taper of the machine has no holder.
    for (from, to, down, length, text) in texts.into_iter().filter(|(from, to, ..)| from < to) {
        // The figure alone where its name has no room; the caption names them in their order.
        let text = if width_of(&text, 11.0) < to - from { text } else { mm(length, lang) };
        let y = axis + down;
        for x in [from, to] {
            canvas.line(&[(x, axis), (x, y + 3.0)], THIN);
        }
        canvas.line(&[(from, y), (to, y)], THIN);
        canvas.head((from, y), (to, y), THIN);
        canvas.head((to, y), (from, y), THIN);
        canvas.text(((from + to) / 2.0, y - 3.0), 11.0, Anchor::Middle, &text);
    }
}
