//! The path of the tool through the points 0 to 4.

use crate::job::{Cycle, CycleKind, SlotCycle};
use crate::motion::Sense;
use crate::report::Lang;
use crate::report::canvas::{Anchor, At, Canvas, Pen};
use crate::report::sheet::mm;
use crate::report::words::say;
use crate::units::Micrometres;

use super::section::HoleSection;
use super::{ABOVE, GREY, INK, WAY};

const RAPID: Pen = Pen::dashed(WAY, 1.4);
const FEED: Pen = Pen::solid(WAY, 2.0);
/// The distance of the paths down and up from the axis, and of the path down where steps are side by side.
const APART: f64 = 17.0;
const STEPPED: f64 = 46.0;
/// More steps than these are drawn with a gap: the first ones, and the last.
const STEPS: usize = 5;
/// The least length of a drawn retract.
const RETREAT: f64 = 9.0;

/// The path with its points.
pub(super) fn draw(canvas: &mut Canvas, section: &HoleSection<'_>, cycle: &Cycle) {
    let y = |z: Micrometres| section.y(z.to_mm());
    let (out, begin, end) = (y(cycle.out), y(cycle.begin), y(cycle.end));
    let stepped = matches!(cycle.kind, CycleKind::Peck { .. } | CycleKind::ChipBreak { .. });
    let (down, up) = (section.axis - if stepped { STEPPED } else { APART }, section.axis + APART);
    let way_out = match cycle.kind {
        CycleKind::FeedOut | CycleKind::Tap { .. } => FEED,
        _ => RAPID,
    };
    arrow(canvas, (down, out), (down, begin), RAPID);
    match &cycle.kind {
        CycleKind::Peck { step, clearance } => {
            let depths = depths(cycle, *step);
            let back = |depth: Micrometres| (y(depth) - y(depth + *clearance)).max(RETREAT);
            pecks(canvas, section, &depths, &|depth| y(depth), begin, Some(&back));
        }
        CycleKind::ChipBreak { step, retreat } => {
            let depths = depths(cycle, *step);
            let back = |depth: Micrometres| (y(depth) - y(depth + *retreat)).max(RETREAT);
            breaks(canvas, section, &depths, &|depth| y(depth), begin, &back);
        }
        CycleKind::Circles { levels, radii, .. } => {
            arrow(canvas, (down, begin), (down, end), FEED);
            let reach = section.across(radii.iter().max().copied().unwrap_or_default().to_mm());
            for level in levels {
                let at = y(*level);
                canvas.line(&[(section.axis - reach, at), (section.axis + reach, at)], FEED);
                for side in [-1.0, 1.0] {
                    canvas.circle((section.axis + side * reach, at), 2.6, WAY, None);
                }
            }
            canvas.line(&[(down, end), (up, end)], FEED);
        }
        CycleKind::Slot(slot) => {
            arrow(canvas, (down, begin), (down, end), FEED);
            let reach = section.across(slot.widest().to_mm()).max(APART);
            for level in &slot.levels {
                let at = y(*level);
                canvas.line(&[(section.axis - reach, at), (section.axis + reach, at)], FEED);
            }
            canvas.line(&[(down, end), (up, end)], FEED);
        }
        _ => {
            arrow(canvas, (down, begin), (down, end), FEED);
            canvas.line(&[(down, end), (up, end)], FEED);
        }
    }
    arrow(canvas, (up, end), (up, begin), way_out);
    arrow(canvas, (up, begin), (up, out), RAPID);
    // If two levels are close, the number of the lower one moves aside.
    let close = (begin - out).abs() < 18.0;
    let aside = if close { 16.0 } else { 0.0 };
    if cycle.out != cycle.begin {
        point(canvas, (down - aside, begin), "1");
        point(canvas, (up + aside, begin), "3");
        point(canvas, (down, out), "0");
        point(canvas, (up, out), "4");
    } else {
        point(canvas, (down, out), "0");
        point(canvas, (down - 16.0, out), "1");
        point(canvas, (up, out), "3");
        point(canvas, (up + 16.0, out), "4");
    }
    point(canvas, (section.axis, end), "2");
    if cycle.dwell_s.is_some() {
        canvas.text((section.axis, end + 18.0), 10.0, Anchor::Middle, "E");
    }
}

/// The depths of the steps from point 1 to point 2.
fn depths(cycle: &Cycle, step: Micrometres) -> Vec<Micrometres> {
    let step = step.max(Micrometres::new(1));
    let mut depths = Vec::new();
    let mut at = cycle.begin;
    while at > cycle.end {
        at = (at - step).max(cycle.end);
        // Steps that are not drawn need not be counted beyond a few hundred.
        if depths.len() < 500 {
            depths.push(at);
        }
    }
    if let Some(last) = depths.last_mut() {
        *last = cycle.end;
    }
    depths
}

/// The steps that are drawn: all, or the first ones and the last with a gap between them.
fn drawn(depths: &[Micrometres]) -> (Vec<usize>, bool) {
    let count = depths.len();
    if count <= STEPS { ((0..count).collect(), false) } else { (vec![0, 1, 2, count - 1], true) }
}

/// G83: after each step out of the hole, and back to a clearance above the metal.
fn pecks(
    canvas: &mut Canvas,
    section: &HoleSection<'_>,
    depths: &[Micrometres],
    y: &dyn Fn(Micrometres) -> f64,
    begin: f64,
    back: Option<&dyn Fn(Micrometres) -> f64>,
) {
    let (shown, broken) = drawn(depths);
    let columns = columns(section, shown.len());
    for (place, &index) in shown.iter().enumerate() {
        let (x, last) = (columns[place], place + 1 == shown.len());
        let depth = y(depths[index]);
        let start = match index.checked_sub(1) {
            None => begin,
            Some(before) => y(depths[before]) - back.map_or(0.0, |back| back(depths[before])),
        };
        if start > begin {
            arrow(canvas, (x, begin), (x, start), RAPID);
        }
        arrow(canvas, (x, start), (x, depth), FEED);
        if last {
            canvas.line(&[(x, depth), (section.axis + APART, depth)], FEED);
        } else {
            let next = columns[place + 1];
            let middle = f64::midpoint(x, next);
            canvas.line(&[(x, depth), (middle, depth)], RAPID);
            arrow(canvas, (middle, depth), (middle, begin), RAPID);
            canvas.line(&[(middle, begin), (next, begin)], RAPID);
            if broken && place == 2 {
                dots(canvas, (middle, f64::midpoint(depth, y(depths[depths.len() - 1]))));
            }
        }
    }
}

/// G86: after each step a small retract, inside the hole.
fn breaks(
    canvas: &mut Canvas,
    section: &HoleSection<'_>,
    depths: &[Micrometres],
    y: &dyn Fn(Micrometres) -> f64,
    begin: f64,
    back: &dyn Fn(Micrometres) -> f64,
) {
    let (shown, broken) = drawn(depths);
    let columns = columns(section, shown.len());
    let mut start = begin;
    for (place, &index) in shown.iter().enumerate() {
        let x = columns[place];
        let depth = y(depths[index]);
        if broken && place == 3 {
            start = y(depths[index - 1]) - back(depths[index - 1]);
        }
        arrow(canvas, (x, start), (x, depth), FEED);
        match columns.get(place + 1) {
            None => canvas.line(&[(x, depth), (section.axis + APART, depth)], FEED),
            Some(&next) => {
                start = depth - back(depths[index]);
                canvas.line(&[(x, depth), (next, start)], RAPID);
                canvas.head((x, depth), (next, start), Pen::solid(WAY, 1.0));
                if broken && place == 2 {
                    let last = y(depths[depths.len() - 2]);
                    dots(canvas, (next, f64::midpoint(start, last)));
                }
            }
        }
    }
}

/// The columns of steps side by side, from the path down to the left of the path up.
fn columns(section: &HoleSection<'_>, count: usize) -> Vec<f64> {
    let (first, room) = (section.axis - STEPPED, STEPPED + 4.0);
    (0..count).map(|index| first + room * index as f64 / (count.max(2) - 1) as f64).collect()
}

/// The mark for steps that are left out.
fn dots(canvas: &mut Canvas, (x, y): At) {
    for shift in [-7.0, 0.0, 7.0] {
        canvas.circle((x, y + shift), 1.6, WAY, None);
    }
}

/// A segment of the path with an arrow head in the middle; none if it has no length.
fn arrow(canvas: &mut Canvas, from: At, to: At, pen: Pen) {
    let long = libm::hypot(to.0 - from.0, to.1 - from.1);
    if long < 0.5 {
        return;
    }
    canvas.line(&[from, to], pen);
    if long > 10.0 {
        let share = (long / 2.0 + 4.0) / long;
        canvas.head(from, (from.0 + (to.0 - from.0) * share, from.1 + (to.1 - from.1) * share), pen);
    }
}

fn point(canvas: &mut Canvas, (x, y): At, name: &str) {
    canvas.circle((x, y), 7.5, "white", Some(Pen::solid(WAY, 1.2)));
    canvas.text((x, y + 3.8), 10.5, Anchor::Middle, name);
}

/// The circles of a mill from above: the hole before and after, the mill, and the path of its centre.
pub(super) fn from_above(
    canvas: &mut Canvas,
    middle: At,
    radii: &[Micrometres],
    sense: Sense,
    section: &HoleSection<'_>,
    lang: Lang,
) {
    let t = section.transition;
    let scale = (ABOVE - 50.0) / t.diameter_mm.to_mm().max(0.1);
    canvas.circle(middle, t.diameter_mm.to_mm() / 2.0 * scale, "#f4f4f4", Some(Pen::solid(INK, 1.6)));
    canvas.circle(middle, t.from_diameter_mm.to_mm() / 2.0 * scale, "white", Some(Pen::dashed(GREY, 1.0)));
    let mut at = middle;
    for radius in radii {
        let radius = radius.to_mm() * scale;
        let next = (middle.0 + radius, middle.1);
        canvas.line(&[at, next], FEED);
        canvas.circle(middle, radius, "none", Some(FEED));
        // The arrow head at the top of the circle, in its visible direction.
        let (top, direction) =
            ((middle.0, middle.1 - radius), if sense == Sense::Counterclockwise { -1.0 } else { 1.0 });
        canvas.head((top.0 - direction * 10.0, top.1), (top.0 + direction * 4.0, top.1), FEED);
        at = next;
    }
    if let Some(rounds) = t.conditions.rounds {
        canvas.circle(at, rounds.mill_diameter_mm.to_mm() / 2.0 * scale, "none", Some(Pen::solid(GREY, 1.0)));
    }
    let shown: Vec<String> = radii.iter().take(4).map(|radius| mm(*radius, lang)).collect();
    let more = if radii.len() > 4 { "; …" } else { "" };
    let text = say!(lang, "cycles-radii", count = radii.len(), radii = format!("{}{more}", shown.join("; ")));
    canvas.text((middle.0, middle.1 + ABOVE / 2.0 - 6.0), 10.5, Anchor::Middle, &text);
}

/// The way of a mill in a slot at one level, from above, with the slot laid along the page: the slot, the mill, the path of its
/// centre.
pub(super) fn slot_from_above(
    canvas: &mut Canvas,
    middle: At,
    room: f64,
    slot: &SlotCycle,
    section: &HoleSection<'_>,
    lang: Lang,
) {
    let t = section.transition;
    let (width, length) = (t.diameter_mm.to_mm(), slot.run.length().to_mm());
    let scale = ((ABOVE - 50.0) / width).min(room / (length + width));
    let half = length / 2.0 * scale;
    let ends = [(middle.0 - half, middle.1), (middle.0 + half, middle.1)];
    // The way of the mill's middle is rounded less in a corner by its radius, and so is what it left before.
    let corner = |wide: f64| slot.run.corner.map(|own| (own.to_mm() - (width - wide) / 2.0).max(0.0) * scale);
    canvas.opening(ends, (width / 2.0 * scale, corner(width)), "#f4f4f4", Some(Pen::solid(INK, 1.6)));
    if !slot.along_middle {
        let from = t.from_diameter_mm.to_mm();
        canvas.opening(ends, (from / 2.0 * scale, corner(from)), "white", Some(Pen::dashed(GREY, 1.0)));
    }
    if slot.along_middle {
        arrow(canvas, ends[0], ends[1], FEED);
    }
    for wide in slot.radii.iter().map(|radius| 2.0 * radius.to_mm()) {
        let radius = wide / 2.0 * scale;
        canvas.opening(ends, (radius, corner(wide)), "none", Some(FEED));
        // On the far wall of the page, in its visible direction.
        let direction = if slot.sense == Sense::Counterclockwise { -1.0 } else { 1.0 };
        let top = (middle.0, middle.1 - radius);
        canvas.head((top.0 - direction * 10.0, top.1), (top.0 + direction * 4.0, top.1), FEED);
    }
    if let Some(rounds) = t.conditions.rounds {
        canvas.circle(ends[0], rounds.mill_diameter_mm.to_mm() / 2.0 * scale, "none", Some(Pen::solid(GREY, 1.0)));
    }
    let shown: Vec<String> = slot.radii.iter().take(4).map(|radius| mm(*radius, lang)).collect();
    let more = if slot.radii.len() > 4 { "; …" } else { "" };
    let text = say!(lang, "cycles-slot-ways", count = slot.radii.len(), radii = format!("{}{more}", shown.join("; ")));
    canvas.text((middle.0, middle.1 + ABOVE / 2.0 - 6.0), 10.5, Anchor::Middle, &text);
}
