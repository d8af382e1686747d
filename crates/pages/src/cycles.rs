//! Diagrams of cycles: the path of a tool through the points 0 to 4, in a section of the hole.
//!
//! The points are those of the textbook's figure 3.3 (l. 2601-3060): 0 the tool above the hole, 1 the beginning of
//! the feed, 2 the bottom, 3 the end of the retract, 4 the level of the next travel. Letters of the levels are those
//! of 2C42-65: U, Z, I. Heights are in the coordinates of the drawing; no direction is to scale, so that 3 mm is
//! readable beside 150.
//!
//! - `section` the hole, the plate and the levels; `toolpath` the path of the tool.

use super::canvas::{Anchor, Canvas, Pen, broken, width_of};
use super::sheet::{mm, rounded};
use super::words::say;
use super::{Lang, transitions};
use crate::job::{Cycle, CycleKind, Job, SetUp, ToolWork};
use crate::plan::Plan;

mod section;
mod toolpath;

use section::HoleSection;

/// Width of a diagram.
const WIDTH: f64 = 350.0;
/// The least width of a page, for its foot.
const LEAST: f64 = 560.0;
/// Most diagrams in a row.
const COLUMNS: usize = 4;
const TITLE: f64 = 32.0;
const HEAD: f64 = 92.0;
const BODY: f64 = 280.0;
/// The height of the view from above, for a mill's circles.
const ABOVE: f64 = 190.0;
const FOOT: f64 = 34.0;
const MARGIN: f64 = 16.0;

const INK: &str = "#333";
const GREY: &str = "#888";
const WAY: &str = "#0072b2";

/// The diagrams of one tool.
#[derive(Clone, Debug)]
pub struct Diagram {
    /// The set-up, from 1.
    pub setup: u32,
    /// The tool's number in the plan.
    pub tool: u32,
    /// The drawing: all distinct cycles of the tool side by side.
    pub svg: String,
}

/// One drawing for each tool, in the order of the work.
pub fn diagrams(job: &Job, plan: &Plan, lang: Lang) -> Vec<Diagram> {
    works(job)
        .map(|(setup, work)| {
            let mut canvas = Canvas::default();
            tool(&mut canvas, (0.0, 0.0), setup, work, job, plan, lang);
            let (width, height) = size(work);
            foot(&mut canvas, height, lang);
            Diagram { setup: setup.number, tool: work.tool, svg: canvas.page(width.max(LEAST), height + FOOT) }
        })
        .collect()
}

/// All of them on one page, side by side where they fit.
pub fn page(job: &Job, plan: &Plan, lang: Lang) -> String {
    let mut canvas = Canvas::default();
    let (mut x, mut y, mut row, mut all) = (0.0_f64, 0.0_f64, 0.0_f64, LEAST);
    for (setup, work) in works(job) {
        let (width, height) = size(work);
        if x > 0.0 && x + width > WIDTH * COLUMNS as f64 {
            (x, y, row) = (0.0, y + row, 0.0);
        }
        tool(&mut canvas, (x, y), setup, work, job, plan, lang);
        (x, row) = (x + width, row.max(height));
        all = all.max(x);
    }
    foot(&mut canvas, y + row, lang);
    canvas.page(all, y + row + FOOT)
}

fn works(job: &Job) -> impl Iterator<Item = (&SetUp, &ToolWork)> {
    job.setups.iter().flat_map(|setup| setup.works.iter().map(move |work| (setup, work)))
}

/// The rows of a tool's cycles.
fn rows(work: &ToolWork) -> Vec<Vec<usize>> {
    let cycles: Vec<usize> = (0..work.cycles.len()).collect();
    cycles.chunks(COLUMNS).map(<[usize]>::to_vec).collect()
}

fn row_height(work: &ToolWork, row: &[usize]) -> f64 {
    let round =
        row.iter().any(|&cycle| matches!(work.cycles[cycle].kind, CycleKind::Circles { .. } | CycleKind::Slot(_)));
    HEAD + BODY + if round { ABOVE } else { 0.0 }
}

/// The size of a tool's drawing.
fn size(work: &ToolWork) -> (f64, f64) {
    let height: f64 = rows(work).iter().map(|row| row_height(work, row)).sum();
    (WIDTH * work.cycles.len().clamp(1, COLUMNS) as f64, TITLE + height)
}

/// The cycles of a tool side by side.
fn tool(canvas: &mut Canvas, (x, y): (f64, f64), setup: &SetUp, work: &ToolWork, job: &Job, plan: &Plan, lang: Lang) {
    let own = plan.tools.iter().find(|tool| tool.number == work.tool);
    // A designation that is an order text has its diameter already.
    let own = own.filter(|_| !work.designation.contains('Ø'));
    let diameter = own.map_or_else(String::new, |tool| format!(" Ø{}", mm(tool.diameter_mm, lang)));
    let mut title = format!("T{} {}{diameter}, H{:02}", work.place, work.designation, work.corrector);
    if job.setups.len() > 1 {
        title.push_str(", ");
        title.push_str(&say!(lang, "drawing-set-up", setup = setup.number));
    }
    let edge = [(x + MARGIN, y + 1.0), (x + size(work).0 - MARGIN, y + 1.0)];
    canvas.line(&edge, Pen::solid("#ccc", 1.0));
    canvas.text((x + MARGIN, y + 24.0), 15.0, Anchor::Start, &title);
    let mut down = y + TITLE;
    for row in rows(work) {
        for (column, &cycle) in row.iter().enumerate() {
            diagram(canvas, (x + column as f64 * WIDTH, down), work, cycle, plan, lang);
        }
        down += row_height(work, &row);
    }
}

fn diagram(canvas: &mut Canvas, (x, y): (f64, f64), work: &ToolWork, index: usize, plan: &Plan, lang: Lang) {
    let cycle = &work.cycles[index];
    let mut row = y + 14.0;
    for line in broken(&transitions::sentence(plan, work, &[index], lang), 12.0, WIDTH - 2.0 * MARGIN).iter().take(4) {
        canvas.text((x + MARGIN, row), 12.0, Anchor::Start, line);
        row += 15.0;
    }
    for line in broken(&figures(cycle, work, lang), 11.0, WIDTH - 2.0 * MARGIN) {
        canvas.text((x + MARGIN, row), 11.0, Anchor::Start, &line);
        row += 14.0;
    }
    let Some(section) = HoleSection::of(plan, work, index, (x, y + HEAD)) else { return };
    section.hole(canvas, lang);
    toolpath::draw(canvas, &section, cycle);
    section.levels(canvas, cycle, lang);
    if let CycleKind::Circles { radii, sense, .. } = &cycle.kind {
        toolpath::from_above(
            canvas,
            (x + WIDTH / 2.0, y + HEAD + BODY + ABOVE / 2.0 - 12.0),
            radii,
            *sense,
            &section,
            lang,
        );
    }
    if let CycleKind::Slot(slot) = &cycle.kind {
        let middle = (x + WIDTH / 2.0, y + HEAD + BODY + ABOVE / 2.0 - 12.0);
        toolpath::slot_from_above(canvas, middle, WIDTH - 2.0 * MARGIN, slot, &section, lang);
    }
}

/// Speed, feed, dwell, and the steps of a cycle that has them.
fn figures(cycle: &Cycle, work: &ToolWork, lang: Lang) -> String {
    let mut parts = vec![
        say!(lang, "cycles-speed", speed = rounded(cycle.speed_rpm.0, 0)),
        say!(lang, "cycles-feed", feed = rounded(cycle.feed_mm_per_min.0, 0)),
    ];
    if let Some(dwell) = cycle.dwell_s {
        parts.push(say!(lang, "cycles-dwell", seconds = rounded(dwell.0, 1)));
    }
    match &cycle.kind {
        CycleKind::Peck { step, clearance } => {
            parts.push(say!(lang, "cycles-step", step = *step));
            parts.push(say!(lang, "cycles-clearance", clearance = *clearance));
        }
        CycleKind::ChipBreak { step, retreat } => {
            parts.push(say!(lang, "cycles-step", step = *step));
            parts.push(say!(lang, "cycles-retreat", retreat = *retreat));
        }
        CycleKind::Tap { pitch } => parts.push(say!(lang, "cycles-pitch", pitch = *pitch)),
        CycleKind::BoreStop => parts.push(say!(lang, "cycles-out-stopped").to_owned()),
        CycleKind::FeedOut => parts.push(say!(lang, "cycles-out-at-feed").to_owned()),
        CycleKind::Circles { plunge_mm_per_min: Some(plunge), .. } => {
            parts.push(say!(lang, "cycles-plunge", feed = rounded(plunge.0, 0)));
        }
        CycleKind::Slot(slot) => {
            if let Some(plunge) = slot.plunge_mm_per_min {
                parts.push(say!(lang, "cycles-plunge", feed = rounded(plunge.0, 0)));
            }
            if let (Some(slow), Some(fast)) = (slot.arcs.first(), slot.arcs.last()) {
                let (slow, fast) = (rounded(slow.mm_per_min.0, 0), rounded(fast.mm_per_min.0, 0));
                parts.push(match slow == fast {
                    true => say!(lang, "cycles-arcs", feed = slow),
                    false => say!(lang, "cycles-arcs-between", slow = slow, fast = fast),
                });
            }
        }
        CycleKind::Drill | CycleKind::Circles { .. } => {}
    }
    if work.coolant {
        parts.push(say!(lang, "cycles-coolant").to_owned());
    }
    parts.join(", ")
}

fn foot(canvas: &mut Canvas, y: f64, lang: Lang) {
    let row = y + 16.0;
    let mut at = MARGIN;
    for (pen, text) in
        [(Pen::dashed(WAY, 1.4), say!(lang, "drawing-rapid")), (Pen::solid(WAY, 2.0), say!(lang, "drawing-feed"))]
    {
        canvas.line(&[(at, row), (at + 26.0, row)], pen);
        canvas.text((at + 32.0, row + 4.0), 11.0, Anchor::Start, text);
        at += 32.0 + width_of(text, 11.0) + 10.0;
    }
    canvas.text((at, row + 4.0), 11.0, Anchor::Start, say!(lang, "cycles-not-to-scale"));
}
