//! The clamping scheme: the part from above with its clamps, the hole that needs the largest force, and its arm d (the
//! textbook's W = k·M/(f·d)).

use crate::part::{Outline, Point};
use crate::plan::{Clamping, Plan};

use super::super::canvas::{Anchor, At, Canvas, Pen, THIN, width_of};
use super::super::sheet::{exactly, rounded};
use super::super::words::say;
use super::Lang;
use super::from_above::{MARGIN, Plate, SIZE, WIDTH};

const CLAMP: Pen = Pen::solid("#7a5c3e", 1.2);
const FORCE: Pen = Pen::solid("#d55e00", 1.6);
/// How far the arm may differ from that of the plan: what rounding to micrometres leaves, mm.
const ROUNDING: f64 = 0.002;

/// The scheme; none for a part that no clamps hold.
pub(super) fn scheme(plan: &Plan, lang: Lang) -> Option<String> {
    let clamping = plan.clamping.as_ref().filter(|own| !own.clamps.is_empty())?;
    let plate = Plate::of(&plan.part, MARGIN);
    let mut canvas = Canvas::default();
    plate.outline(&mut canvas);
    for hole in &plan.part.holes {
        for way in hole.middles() {
            let ends = [plate.at(way.from), plate.at(way.to)];
            canvas.opening(ends, (plate.radius(hole), plate.corner_of(hole)), "none", Some(THIN));
        }
    }
    for at in &clamping.clamps {
        if let Some(strap) = clamping.strap
            && let Outline::Box(low, high) = strap.standing(*at, &plan.part).outline
        {
            let foot = plate.corner.1 + plate.up + MARGIN - 24.0;
            let on_page = |(x, y): At| (x.clamp(4.0, WIDTH - 4.0), y.clamp(4.0, foot));
            // A strap may reach beyond the page.
            canvas.rectangle(on_page(plate.at(low)), on_page(plate.at(high)), "#f0e6dc", Some(CLAMP));
        }
        // Where it presses.
        let (x, y) = plate.at(*at);
        canvas.circle((x, y), 5.0, "white", Some(CLAMP));
        canvas.line(&[(x - 3.5, y - 3.5), (x + 3.5, y + 3.5)], CLAMP);
        canvas.line(&[(x - 3.5, y + 3.5), (x + 3.5, y - 3.5)], CLAMP);
    }
    arm(&mut canvas, &plate, clamping, plan, lang);
    let foot = plate.corner.1 + plate.up + MARGIN - 6.0;
    let force = say!(lang, "lab-clamping-force", force = rounded(clamping.force_per_clamp_n.0, 0));
    canvas.circle((plate.corner.0 + 6.0, foot - 4.0), 5.0, "white", Some(CLAMP));
    canvas.text((plate.corner.0 + 18.0, foot), SIZE, Anchor::Start, &force);
    Some(canvas.page(WIDTH, foot + 16.0))
}

/// The hole, the nearest clamp, and what turns the part about it or pushes it. Not drawn if no hole has that arm.
fn arm(canvas: &mut Canvas, plate: &Plate, clamping: &Clamping, plan: &Plan, lang: Lang) {
    let Some(hole) = plan.part.holes.iter().find(|hole| hole.name == clamping.hole) else { return };
    let pairs = hole.at.iter().flat_map(|from| clamping.clamps.iter().map(move |to| (*from, *to)));
    let off = |(from, to): &(Point, Point)| (distance(*from, *to) - clamping.distance_mm.to_mm()).abs();
    let Some((from, to)) = pairs.min_by(|a, b| off(a).total_cmp(&off(b))).filter(|pair| off(pair) < ROUNDING) else {
        return;
    };
    let (a, b) = (plate.at(from), plate.at(to));
    canvas.circle(a, plate.radius(hole), "#fbe3d3", Some(FORCE));
    canvas.line(&[a, b], FORCE);
    canvas.head(a, b, FORCE);
    canvas.head(b, a, FORCE);
    let said = say!(lang, "lab-clamping-arm", distance = rounded(clamping.distance_mm.to_mm(), 1));
    // Beside the line, above it, whichever way it falls.
    let long = libm::hypot(b.0 - a.0, b.1 - a.1).max(1.0);
    let (nx, ny) = ((b.1 - a.1) / long, (a.0 - b.0) / long);
    let up = if ny > 0.0 { -1.0 } else { 1.0 };
    let off = 8.0 + nx.abs() * width_of(&said, SIZE) / 2.0;
    let beside = ((a.0 + b.0) / 2.0 + nx * up * off, (a.1 + b.1) / 2.0 + ny * up * off + SIZE / 3.0);
    canvas.text(beside, SIZE, Anchor::Middle, &said);
    let acts = match clamping.side_force_n {
        Some(side) => say!(lang, "lab-clamping-side", side = rounded(side.0, 0)),
        None => say!(lang, "lab-clamping-torque", torque = exactly(clamping.torque_n_m.0, 2)),
    };
    // On the side of the hole that the arm leaves free.
    let below = if b.1 > a.1 { -plate.radius(hole) - 6.0 } else { plate.radius(hole) + SIZE + 4.0 };
    canvas.text((a.0, a.1 + below), SIZE, Anchor::Middle, &format!("{}: {acts}", hole.name));
}

/// In mm.
fn distance(a: Point, b: Point) -> f64 {
    libm::hypot((a.x - b.x).to_mm(), (a.y - b.y).to_mm())
}
