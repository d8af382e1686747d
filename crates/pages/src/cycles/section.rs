//! The section of the hole: the plate, the hole before and after, and the levels of the cycle.

use crate::job::{Cycle, CycleKind, SlotCycle, ToolWork};
use crate::part::Hole;
use crate::plan::{Feature, Operation, Plan, Transition};
use crate::report::Lang;
use crate::report::canvas::{Anchor, At, Canvas, Pen};
use crate::report::sheet::mm;
use crate::report::transitions;
use crate::report::words::say;
use crate::units::Micrometres;

use super::{BODY, GREY, INK, MARGIN};

/// Heights of the diagram body: above the face, and down to the lowest level.
const OVER: f64 = 85.0;
const UNDER: f64 = 122.0;
/// The width of the widest diameter in a section, and of the plate on both sides.
const BORE: f64 = 120.0;
const PLATE: f64 = 92.0;
/// Height of a point of 118° over its diameter: 1/(2·tan 59°).
const POINT: f64 = 0.300_4;

/// A hole in its section, with the conversion of heights and widths to the page.
pub(super) struct HoleSection<'p> {
    hole: &'p Hole,
    pub transition: &'p Transition,
    /// Z of the upper face, of the opposite face, of the highest and of the lowest shown level.
    top: f64,
    bottom: f64,
    high: f64,
    low: f64,
    /// The depth of the hole before the cycle, as Z; absent in solid metal.
    before: Option<f64>,
    /// The axis, and the upper left corner of the body.
    pub axis: f64,
    corner: At,
    across: f64,
}

impl<'p> HoleSection<'p> {
    /// The section for a cycle: the first hole that it makes.
    pub(super) fn of(plan: &'p Plan, work: &ToolWork, index: usize, corner: At) -> Option<Self> {
        let cycle = work.cycles.get(index)?;
        let (hole, number, _) = transitions::stops_of_work(work, &[index]).into_iter().next()?;
        let (hole, transition) = transitions::find_in_plan(plan, hole, number)?;
        let (datum, blank) = (plan.part.datum, plan.part.blank);
        let (top, bottom) = (datum.top.to_mm(), (datum.top - blank.thickness).to_mm());
        let (high, end) = (cycle.out.to_mm(), cycle.end.to_mm());
        // Down to the bottom of the plate, but no further than leaves the hole readable.
        let low = end.min(bottom.max(end - 0.8 * (top - end).max(1.0)));
        let own = plan.holes.iter().find(|own| own.name == hole.name)?;
        let earlier = own.transitions.iter().take(number).rev();
        let made = earlier.filter(|earlier| earlier.diameter_mm == transition.from_diameter_mm).map(|it| it.depth_mm);
        let made = made.map(|depth| top - depth.to_mm()).next();
        let through = if hole.through { bottom } else { top - hole.depth.to_mm() };
        let depth = match made {
            // A hole drilled through is open at the bottom.
            Some(depth) if depth > bottom || !hole.through => depth,
            _ => through,
        };
        let before = (transition.from_diameter_mm > Micrometres::ZERO).then_some(depth);
        let widest = transition.diameter_mm.max(transition.from_diameter_mm).to_mm().max(0.1);
        let axis = corner.0 + MARGIN + PLATE + 10.0;
        Some(Self { hole, transition, top, bottom, high, low, before, axis, corner, across: BORE / widest })
    }

    /// The position of a height on the page. Above and below the face the scales differ.
    pub(super) fn y(&self, z: f64) -> f64 {
        let face = self.corner.1 + 14.0 + OVER;
        if z >= self.top {
            face - (z - self.top) / (self.high - self.top).max(1.0) * OVER
        } else {
            face + (self.top - z) / (self.top - self.low).max(0.5) * UNDER
        }
    }

    /// The width of a length perpendicular to the axis.
    pub(super) fn across(&self, mm: f64) -> f64 {
        mm * self.across
    }

    /// Half of a diameter after the transition, on the page.
    fn half(&self, diameter: Micrometres) -> f64 {
        self.across(diameter.to_mm()) / 2.0
    }

    /// The cut plate, the hole before and the hole after.
    pub(super) fn hole(&self, canvas: &mut Canvas, lang: Lang) {
        let (left, right) = (self.axis - PLATE, self.axis + PLATE);
        let (face, floor) = (self.y(self.top), self.y(self.bottom.max(self.low)));
        let is_through = self.bottom >= self.low;
        // The plate, hatched.
        let id = format!("c{:.0}-{:.0}", self.corner.0, self.corner.1);
        canvas.push_element(format_args!(
            "<pattern id=\"{id}\" width=\"7\" height=\"7\" patternUnits=\"userSpaceOnUse\"><path d=\"M0 7 L7 0\" \
             stroke=\"#bbb\" stroke-width=\"0.8\"/></pattern>"
        ));
        canvas.rectangle((left, face), (right, floor), &format!("url(#{id})"), None);
        let edge = Pen::solid(INK, 1.2);
        canvas.line(&[(left, face), (right, face)], edge);
        if is_through {
            canvas.line(&[(left, floor), (right, floor)], edge);
        } else {
            broken_edge(canvas, left, right, floor);
        }
        // The holes before and after are cut out of the hatching; the old one is dashed.
        let outline = Pen::solid(INK, 1.6);
        let (after, open) = self.outline_after();
        if let Some(before) = self.before {
            let half = self.half_before();
            let end = self.y(before.max(self.low));
            canvas.rectangle((self.axis - half, face), (self.axis + half, end), "white", None);
            canvas.area(&after, "white", None);
            let dashes = Pen::dashed(GREY, 1.0);
            for x in [self.axis - half, self.axis + half] {
                canvas.line(&[(x, face), (x, end)], dashes);
            }
            if before > self.bottom.max(self.low) {
                canvas.line(&[(self.axis - half, end), (self.axis + half, end)], dashes);
            }
        } else {
            canvas.area(&after, "white", None);
        }
        if open {
            // The floor belongs to the plate: only the walls are lines.
            let (left, right) = after.split_at(after.len() / 2);
            canvas.line(left, outline);
            canvas.line(right, outline);
        } else if let (Some(before), [wall, left, right, other]) = (self.before, after.as_slice()) {
            // The floor of a counterbore has the hole in its middle.
            let goes_on = self.y(before) > left.1 + 1.0;
            let half = if goes_on { self.half_before() } else { 0.0 };
            canvas.line(&[*wall, *left, (self.axis - half, left.1)], outline);
            canvas.line(&[(self.axis + half, right.1), *right, *other], outline);
        } else {
            canvas.line(&after, outline);
        }
        self.tip(canvas);
        let (high, low) = (self.y(self.high) - 14.0, self.y(self.low) + 12.0);
        canvas.push_element(format_args!(
            "<path d=\"M{0:.2} {high:.2} V{low:.2}\" fill=\"none\" stroke=\"{GREY}\" stroke-width=\"0.8\" \
             stroke-dasharray=\"12 3 2 3\"/>",
            self.axis
        ));
        self.diameters(canvas, lang);
    }

    /// Half of the diameter before, a little narrower than after where both are nearly equal, and so that an edge is broken
    /// at 45°.
    fn half_before(&self) -> f64 {
        let t = self.transition;
        let (before, after) = (self.half(t.from_diameter_mm), self.half(t.diameter_mm));
        if matches!(t.operation, Operation::Chamfer | Operation::Countersink) {
            // Depth and width have different scales, with which 45° would stand nearly upright.
            let deep = self.y(self.top - t.depth_mm.to_mm()) - self.y(self.top - t.start_mm.to_mm());
            return before.min(after - deep.clamp(5.0, 0.6 * after));
        }
        if t.from_diameter_mm < t.diameter_mm { before.min(after - 5.0) } else { before }
    }

    /// The outline after the transition, from the left edge over the bottom to the right one, and whether it is open
    /// below.
    fn outline_after(&self) -> (Vec<At>, bool) {
        let t = self.transition;
        let (start, depth) = (self.top - t.start_mm.to_mm(), self.top - t.depth_mm.to_mm());
        let half = self.half(t.diameter_mm);
        let (left, right) = (self.axis - half, self.axis + half);
        if matches!(t.operation, Operation::CentreDrill) {
            return (vec![(left, self.y(start)), (self.axis, self.y(depth)), (right, self.y(start))], false);
        }
        if matches!(t.operation, Operation::Chamfer | Operation::Countersink) {
            let (y, from) = (self.y(depth), self.half_before());
            let sides = [(left, self.y(start)), (self.axis - from, y), (self.axis + from, y), (right, self.y(start))];
            return (sides.to_vec(), true);
        }
        let opens = matches!(t.feature, Feature::Bore) && self.hole.through || depth <= self.bottom;
        let floor = self.y(if opens { self.bottom.max(self.low) } else { depth });
        let tip = self.lead();
        let mut outline = vec![(left, self.y(start)), (left, floor)];
        if !opens && tip > 0.0 {
            outline.push((self.axis, self.y(depth - tip)));
        }
        outline.extend([(right, floor), (right, self.y(start))]);
        (outline, opens)
    }

    /// The height of a drill point, mm: in the plan, the travel beyond the full diameter; with the overrun where the
    /// hole is open.
    fn lead(&self) -> f64 {
        let beyond = (self.transition.end() - self.transition.depth_mm).to_mm();
        match self.transition.operation {
            Operation::Drill | Operation::DrillOut => beyond.min(self.transition.diameter_mm.to_mm() * POINT),
            _ => 0.0,
        }
    }

    /// The tip of the tool where it comes out below the plate.
    fn tip(&self, canvas: &mut Canvas) {
        let t = self.transition;
        let end = self.top - t.end().to_mm();
        if end >= self.bottom || matches!(self.transition.operation, Operation::Mill) {
            return;
        }
        let (half, shoulder) = (self.half(t.diameter_mm), end + self.lead());
        let begin = self.y(self.bottom.min(shoulder.max(self.bottom)));
        let sides = [
            (self.axis - half, begin),
            (self.axis - half, self.y(shoulder)),
            (self.axis, self.y(end)),
            (self.axis + half, self.y(shoulder)),
            (self.axis + half, begin),
        ];
        let flat = [sides[0], sides[1], sides[3], sides[4]];
        let pen = Pen::solid(GREY, 0.8);
        if self.lead() > 0.0 { canvas.line(&sides, pen) } else { canvas.line(&flat, pen) }
    }

    /// The diameters, under the section.
    fn diameters(&self, canvas: &mut Canvas, lang: Lang) {
        let t = self.transition;
        let mut y = self.corner.1 + BODY - 38.0;
        let pen = Pen::solid(INK, 0.8);
        let sides = [(t.diameter_mm, self.half(t.diameter_mm)), (t.from_diameter_mm, self.half_before())];
        for (number, (diameter, half)) in sides.into_iter().enumerate() {
            let before = number > 0;
            if diameter == Micrometres::ZERO || (before && diameter == t.diameter_mm) {
                continue;
            }
            // Of a slot it is the width.
            let sign = if t.conditions.rounds.is_some_and(|own| own.of_slot()) { "" } else { "Ø" };
            let size = format!("{sign}{}", mm(diameter, lang));
            let text = if before { say!(lang, "cycles-before", size = size) } else { size };
            let (a, b) = ((self.axis - half, y), (self.axis + half, y));
            canvas.line(&[a, b], pen);
            canvas.head(b, a, pen);
            canvas.head(a, b, pen);
            for x in [a.0, b.0] {
                canvas.line(&[(x, y - 5.0), (x, y + 5.0)], pen);
            }
            canvas.text((self.axis + BORE / 2.0 + 10.0, y + 4.0), 11.0, Anchor::Start, &text);
            y += 22.0;
        }
    }

    /// The levels with their heights, on the right, moved apart where they are close.
    pub(super) fn levels(&self, canvas: &mut Canvas, cycle: &Cycle, lang: Lang) {
        let z = Micrometres::from_mm_rounded;
        let mut levels: Vec<(f64, String)> = vec![
            (cycle.out.to_mm(), format!("I = {}", mm(cycle.out, lang))),
            (cycle.begin.to_mm(), format!("U = {}", mm(cycle.begin, lang))),
            (self.top, say!(lang, "cycles-top", z = z(self.top))),
            (cycle.end.to_mm(), format!("Z = {}", mm(cycle.end, lang))),
        ];
        let depth = self.top - self.transition.depth_mm.to_mm();
        let inside = depth > self.bottom && depth > cycle.end.to_mm();
        if inside {
            levels.push((depth, say!(lang, "cycles-full-diameter", z = z(depth))));
        }
        if self.bottom >= self.low && self.bottom != cycle.end.to_mm() {
            levels.push((self.bottom, say!(lang, "cycles-bottom", z = z(self.bottom))));
        }
        if let CycleKind::Circles { levels: rounds, .. } | CycleKind::Slot(SlotCycle { levels: rounds, .. }) =
            &cycle.kind
        {
            let rest = rounds.iter().filter(|level| **level != cycle.end).take(6);
            levels.extend(rest.map(|level| (level.to_mm(), mm(*level, lang))));
        }
        if cycle.out == cycle.begin {
            levels.remove(1);
            levels[0].1 = format!("U = I = {}", mm(cycle.out, lang));
        }
        levels.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut last = f64::NEG_INFINITY;
        let (edge, column) = (self.axis + PLATE + 4.0, self.axis + PLATE + 34.0);
        for (height, text) in levels {
            let y = self.y(height);
            let row = y.max(last + 15.0);
            last = row;
            canvas.line(&[(self.axis + 30.0, y), (edge, y)], Pen::solid("#aaa", 0.7));
            canvas.line(&[(edge, y), (column - 10.0, row), (column - 2.0, row)], Pen::solid("#aaa", 0.7));
            canvas.text((column, row + 4.0), 11.0, Anchor::Start, &text);
        }
    }
}

/// The edge of a plate that continues: a broken line.
fn broken_edge(canvas: &mut Canvas, left: f64, right: f64, y: f64) {
    let middle = left + (right - left) * 0.12;
    let points =
        [(left, y), (middle - 6.0, y), (middle - 2.0, y - 6.0), (middle + 2.0, y + 6.0), (middle + 6.0, y), (right, y)];
    canvas.line(&points, Pen::solid(GREY, 0.9));
}
