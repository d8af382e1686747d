//! Grooves of real parts; their toolpaths are simulated by columns that know only the blade and the profile.

use super::*;
use crate::turning::contour::{Side, SurfaceKind};
use crate::turning::jobs::Body;
use crate::turning::jobs::tests::{at_bench, part};
use crate::turning::workpiece::Workpiece;

/// The job of the first groove of a part, and that groove.
fn job(workpiece: &Workpiece, side: Side) -> (Result<Job, NoJob>, Surface) {
    let profile = match side {
        Side::Outer => &workpiece.outer,
        Side::Inner => workpiece.inner.as_ref().unwrap(),
    };
    let is_groove = |surface: &&Surface| surface.kind.is_additional() && surface.kind != SurfaceKind::Thread;
    let surface = profile.surfaces.iter().find(is_groove).unwrap().clone();
    let radius = if side == Side::Outer { 62.0 } else { 15.0 };
    let site = Site { profile, clear: Point { radius: Half::from(radius), z: Half::from(-2.0) }, off: Half::from(0.5) };
    (at_bench(workpiece, |bench| Refusal::split(groove(site, &surface, bench)).unwrap()), surface)
}

/// Height over a place of the mouth and that place, of a point: how the columns see each kind of groove.
fn seen(point: (f64, f64), side: Side, face: bool) -> (f64, f64) {
    let (z, radius) = point;
    match (side, face) {
        (_, true) => (-radius, -z),
        (Side::Outer, _) => (z, radius),
        (Side::Inner, _) => (z, -radius),
    }
}

const COLUMN: f64 = 0.02;

/// What the edge is like over a place that lies `off` behind its leading corner: how high above its lowest.
fn edge_over(off: f64, width: f64, corner: f64) -> Option<f64> {
    if !(0.0..=width).contains(&off) {
        return None;
    }
    let from_end = off.min(width - off);
    let inside = (corner - from_end).max(0.0);
    Some(corner - (corner * corner - inside * inside).sqrt())
}

/// Columns over a groove: the finished height, and the height of the metal.
struct Columns {
    from: f64,
    own: (f64, f64),
    finished: Vec<f64>,
    metal: Vec<f64>,
}

impl Columns {
    /// A groove with its neighbours.
    fn of(part: &Workpiece, surface: &Surface, side: Side) -> Self {
        let face = surface.kind == SurfaceKind::FaceGroove;
        let mut points: Vec<(f64, f64)> = Vec::new();
        let all = match side {
            Side::Outer => &part.outer.surfaces,
            Side::Inner => &part.inner.as_ref().unwrap().surfaces,
        };
        let index = all.iter().position(|one| one == surface).unwrap();
        let mut own = (f64::MAX, f64::MIN);
        for (piece, groove) in
            (index - 1..=index + 1).flat_map(|at| all[at].pieces.iter().map(move |piece| (piece, at == index)))
        {
            if groove {
                for end in [piece.from, piece.to] {
                    let (at, _) = seen((end.z.to_mm(), end.radius.to_mm()), side, face);
                    own = (own.0.min(at), own.1.max(at));
                }
            }
            let (from, to) = (piece.from.vector(), piece.to.vector());
            match piece.centre() {
                None => points.extend([from, to].map(|at| seen((at.z, at.radius), side, face))),
                Some(centre) => {
                    let (a, b) = (from.minus(centre), to.minus(centre));
                    let radius = a.length();
                    for step in 0..=400 {
                        let share = f64::from(step) / 400.0;
                        let spoke = a.times(1.0 - share).plus(b.times(share)).unit().times(radius);
                        let at = centre.plus(spoke);
                        points.push(seen((at.z, at.radius), side, face));
                    }
                }
            }
        }
        let (from, to) = points.iter().fold((f64::MAX, f64::MIN), |(low, high), at| (low.min(at.0), high.max(at.0)));
        let (from, to) = (from.max(own.0 - 8.0), to.min(own.1 + 8.0));
        let ends = [surface.pieces[0].from, surface.pieces.last().unwrap().to];
        let mouth = ends.map(|end| seen((end.z.to_mm(), end.radius.to_mm()), side, face).1);
        let mouth = mouth[0].max(mouth[1]);
        let count = ((to - from) / COLUMN).round() as usize;
        let height = |index: usize| {
            let at = from + (index as f64 + 0.5) * COLUMN;
            points.windows(2).fold(f64::MAX, |low, pair| {
                let ((a, high_a), (b, high_b)) = (pair[0], pair[1]);
                if (a.min(b)..=a.max(b)).contains(&at) && (b - a).abs() > 1e-9 {
                    low.min(high_a + (high_b - high_a) * (at - a) / (b - a))
                } else {
                    low
                }
            })
        };
        let finished: Vec<f64> = (0..count).map(height).collect();
        let is_own = |index: usize| (own.0..own.1).contains(&(from + (index as f64 + 0.5) * COLUMN));
        let metal = (0..count).map(|index| if is_own(index) { mouth } else { finished[index] }).collect();
        Self { from, own, finished, metal }
    }

    /// How far the edge at a place is below the metal and below the finished groove at most, and cuts.
    fn cut(&mut self, lead: f64, low: f64, width: f64, corner: f64, takes: bool) -> (f64, f64) {
        let (mut into, mut gouge) = (0.0_f64, 0.0_f64);
        let index = |at: f64| ((at - self.from) / COLUMN).clamp(0.0, self.metal.len() as f64) as usize;
        for index in index(lead - width)..index(lead + COLUMN) {
            let at = self.from + (index as f64 + 0.5) * COLUMN;
            let Some(over) = edge_over(lead - at, width, corner) else { continue };
            let height = low + over;
            into = into.max(self.metal[index] - height);
            gouge = gouge.max(self.finished[index] - height);
            if takes {
                self.metal[index] = self.metal[index].min(height);
            }
        }
        (into, gouge)
    }
}

/// Executes a job: its deepest gouge, its deepest rapid, and what stands above what the edge could reach, mm.
fn worked_off(part: &Workpiece, job: &Job, surface: &Surface, side: Side) -> (f64, f64, f64) {
    let face = surface.kind == SurfaceKind::FaceGroove;
    let Body::Insert { nose_radius_mm, width_mm, .. } = job.tool.body else { panic!("a blade") };
    let corner = nose_radius_mm.to_mm();
    let width = width_mm.map_or(2.0 * corner, crate::units::Micrometres::to_mm);
    let mut columns = Columns::of(part, surface, side);
    let (mut gouge, mut rapid) = (0.0_f64, 0.0_f64);
    for (piece, purpose) in job.path.pieces() {
        let steps = (piece.length_mm() / 0.02).ceil().max(1.0) as usize;
        let (from, to) = (piece.from.vector(), piece.to.vector());
        for step in 0..=steps {
            let share = step as f64 / steps as f64;
            let at = match piece.centre() {
                None => from.plus(to.minus(from).times(share)),
                Some(centre) => {
                    let (a, b) = (from.minus(centre), to.minus(centre));
                    centre.plus(a.times(1.0 - share).plus(b.times(share)).unit().times(a.length()))
                }
            };
            let (lead, low) = seen((at.z, at.radius), side, face);
            let (into, below) = columns.cut(lead, low, width, corner, purpose != Purpose::Rapid);
            gouge = gouge.max(below);
            if purpose == Purpose::Rapid {
                rapid = rapid.max(into);
            }
        }
    }
    // What the edge could reach at best: everywhere as low as the finished groove lets it.
    let mut best = Columns::of(part, surface, side);
    let places = ((best.own.1 - best.own.0) / 0.01).round() as usize;
    for place in 0..=places {
        let lead = best.own.0 + place as f64 * 0.01;
        if lead - width < best.own.0 - 1e-6 || lead > best.own.1 + 1e-6 {
            continue;
        }
        let mut low = f64::MIN;
        for (index, finished) in best.finished.iter().enumerate() {
            let at = best.from + (index as f64 + 0.5) * COLUMN;
            if let Some(over) = edge_over(lead - at, width, corner) {
                low = low.max(finished - over);
            }
        }
        best.cut(lead, low, width, corner, true);
    }
    let left = columns.metal.iter().zip(&best.metal).fold(0.0_f64, |most, (is, could)| most.max(is - could));
    (gouge, rapid, left)
}

/// The groove between two cylinders of Ø60, with the mouth at Z 20.
fn outside(groove: &str) -> String {
    format!(
        "  - {{from: {{d: 0, z: 0}}}}\n  - {{face: 60}}\n  - {{cylinder: -20}}\n  - {{groove: {groove}}}\n  - {{cylinder: -100}}\n"
    )
}

fn plunges(job: &Job) -> Vec<String> {
    let mut places: Vec<String> =
        job.path.moves.iter().filter(|one| one.purpose == Purpose::Plunge).map(|one| one.to.z.to_string()).collect();
    places.dedup();
    places
}

/// By hand: with blades of 2 to 5 mm the widest is 5, r 0.8: it leaves 0.8 on sides and floor. Its leading corner goes
/// from 20 + 0.8 + 5 to 28 - 0.8: 25.8 to 27.2, 1.4 apart, which is one step of at most 0.75 · 5.
#[test]
fn a_rectangular_groove_is_plunged_with_the_widest_blade() {
    let own = part(&outside("rectangular, width: 8, depth: 5"), "", "steel-45");
    let (made, surface) = job(&own, Side::Outer);
    let made = made.unwrap();
    assert_eq!(made.tool.designation, "MGEHR 2525-5");
    assert_eq!(plunges(&made), ["25.8", "27.2"]);
    let (gouge, rapid, left) = worked_off(&own, &made, &surface, Side::Outer);
    assert!(gouge < 0.001 && rapid < 0.001 && left < 0.005, "{gouge} {rapid} {left}");
    let kept = made.notes.iter().find(|note| note.code() == "groove-corner-kept").unwrap();
    assert_eq!(kept.figure_text("radius").unwrap(), "0.8");
    assert!(made.time_min.0 > 0.1 && made.time_min.0 < 3.0, "{:?}", made.time_min);
}

/// By hand, with the blade of 5 mm and r 0.8: in a groove of 7 the leading corner may lie from 25.8 to 26.2. One plunge at 26
/// leaves 0.2 + 0.8 = 1 mm on each side, which finishing takes (1 mm), so a second one would cut a sliver of 0.2 at each. In one
/// of 7.2 it would leave 1.1.
#[test]
fn no_plunge_cuts_a_sliver() {
    let made = |width: f64| {
        let own = part(&outside(&format!("rectangular, width: {width}, depth: 5")), "", "steel-45");
        let (made, surface) = job(&own, Side::Outer);
        let made = made.unwrap();
        assert_eq!(made.tool.designation, "MGEHR 2525-5");
        let (gouge, rapid, left) = worked_off(&own, &made, &surface, Side::Outer);
        assert!(gouge < 0.001 && rapid < 0.001 && left < 0.005, "{width}: {gouge} {rapid} {left}");
        plunges(&made)
    };
    assert_eq!(made(7.0), ["26"]);
    assert_eq!(made(7.2), ["25.8", "26.4"]);
}

/// By hand, with the blade of 3 mm and r 0.4: from 20 + 0.4 + 3 = 23.4 to 28 - 0.4 = 27.6; 4.2 are two steps of at most
/// 2.25, the middle first.
#[test]
fn a_blade_of_three_plunges_three_times_in_a_groove_of_eight() {
    let own = part(&outside("rectangular, width: 8, depth: 5"), "", "steel-45");
    let (_, surface) = job(&own, Side::Outer);
    let valley = Valley::of(&surface, Side::Outer).map_err(|_| ()).unwrap();
    let division = Division {
        step: 0.75,
        allowance: 0.4,
        finish: 1.0,
        peck: (9.0, 1.0, 0.5),
        approach: Half::from(2.0),
        layer: None,
    };
    let ways = ways::blade(&valley, ways::CuttingEdge { width: 3.0, corner: 0.4 }, division).unwrap();
    let places: Vec<String> = ways.plunges.iter().map(Half::to_string).collect();
    assert_eq!(places, ["25.5", "23.4", "27.6"]);
    let lowest = ways.path.moves.iter().filter(|one| one.purpose == Purpose::Plunge).map(|one| one.to.radius).min();
    assert_eq!(lowest, Some(Half::from(25.4)), "0.4 over the floor");
}

/// Every kind outside, inside and in a face: nothing below the profile, no rapid through metal, nothing left that the
/// edge reaches.
#[test]
fn grooves_are_cut_to_their_profile_and_not_below() {
    let outer = [
        "rectangular, width: 3, depth: 2",
        "rectangular, width: 6, depth: 9, radius: 1",
        "rectangular, width: 20, depth: 4",
        "trapezoid, width: 12, depth: 4, angle: 60",
        "trapezoid, width: 20, depth: 5, angle: 120",
        "pulley, width: 13, depth: 10.8, angle: 34, radius: 1",
        "pulley, width: 22, depth: 14, angle: 38, radius: 0.3",
        "pulley, width: 31, depth: 20, angle: 34, radius: 2",
    ];
    for kind in outer {
        let own = part(&outside(kind), "", "steel-45");
        let (made, surface) = job(&own, Side::Outer);
        let made = made.unwrap_or_else(|why| panic!("{kind}: {why:?}"));
        let (gouge, rapid, left) = worked_off(&own, &made, &surface, Side::Outer);
        assert!(gouge < 0.001 && rapid < 0.001 && left < 0.005, "{kind}: {gouge} {rapid} {left}");
    }
    let plain = "  - {from: {d: 50, z: 0}}\n  - {face: 90}\n  - {cylinder: -100}\n";
    for kind in [
        "rectangular, width: 4, depth: 3",
        "rectangular, width: 10, depth: 4.5",
        "trapezoid, width: 9, depth: 3, angle: 40",
    ] {
        let bore = format!(
            "  - {{from: {{d: 50, z: 0}}}}\n  - {{cylinder: -30}}\n  - {{groove: {kind}}}\n  - {{cylinder: -100}}\n"
        );
        let own = part(plain, &bore, "steel-45");
        let (made, surface) = job(&own, Side::Inner);
        let made = made.unwrap_or_else(|why| panic!("{kind}: {why:?}"));
        let (gouge, rapid, left) = worked_off(&own, &made, &surface, Side::Inner);
        assert!(gouge < 0.001 && rapid < 0.001 && left < 0.005, "in a bore {kind}: {gouge} {rapid} {left}");
    }
    // At the bottom of a blind bore, whose face goes to the axis.
    let bore = "  - {from: {d: 50, z: 0}}\n  - {cylinder: -30}\n  - {groove: grinding-relief, width: 5, depth: 0.5}\n  - {face: 0}\n";
    let own = part(plain, bore, "steel-45");
    let (made, surface) = job(&own, Side::Inner);
    let made = made.unwrap_or_else(|why| panic!("at the bottom: {why:?}"));
    let (gouge, rapid, left) = worked_off(&own, &made, &surface, Side::Inner);
    assert!(gouge < 0.001 && rapid < 0.001 && left < 0.005, "at the bottom: {gouge} {rapid} {left}");
    for kind in ["face, width: 4, depth: 5", "face, width: 12, depth: 6"] {
        let face = format!(
            "  - {{from: {{d: 0, z: 0}}}}\n  - {{face: 60}}\n  - {{groove: {kind}}}\n  - {{face: 110}}\n  - {{cylinder: -100}}\n"
        );
        let own = part(&face, "", "steel-45");
        let (made, surface) = job(&own, Side::Outer);
        let made = made.unwrap_or_else(|why| panic!("{kind}: {why:?}"));
        let (gouge, rapid, left) = worked_off(&own, &made, &surface, Side::Outer);
        assert!(gouge < 0.001 && rapid < 0.001 && left < 0.005, "in a face {kind}: {gouge} {rapid} {left}");
    }
}

/// Reliefs before a shoulder: by a blade where one goes in, otherwise along their contour by a tool of 35°, whose 52°
/// behind the tip clear the 45° of the relief.
#[test]
fn reliefs_before_a_shoulder_are_cut() {
    let before = |groove: &str| {
        format!(
            "  - {{from: {{d: 0, z: 0}}}}\n  - {{face: 40}}\n  - {{cylinder: -30}}\n  - {{groove: {groove}}}\n  - {{face: 70}}\n  - {{cylinder: -100}}\n"
        )
    };
    for (kind, tool) in [
        ("grinding-relief, width: 3, depth: 0.25", "MGEHR 2525-2"),
        ("grinding-relief, width: 5, depth: 0.5", "MGEHR 2525-4"),
        ("thread-relief, width: 5, depth: 1.5", "MGEHR 2525-3"),
        ("grinding-relief, width: 1.6, depth: 0.25", "CGR-1.3"),
        ("grinding-relief, width: 1.1, depth: 0.25", "SVJBR 2525M16"),
    ] {
        let own = part(&before(kind), "", "steel-45");
        let (made, surface) = job(&own, Side::Outer);
        let made = made.unwrap_or_else(|why| panic!("{kind}: {why:?}"));
        assert_eq!(made.tool.designation, tool, "{kind}: {:?}", made.notes);
        let (gouge, rapid, left) = worked_off(&own, &made, &surface, Side::Outer);
        assert!(gouge < 0.001 && rapid < 0.001 && left < 0.005, "{kind}: {gouge} {rapid} {left}");
    }
}

/// A groove that no tool can make is refused with the inequality that fails.
#[test]
fn what_no_tool_makes_is_refused() {
    let refused = |outer: &str, inner: &str, side| job(&part(outer, inner, "steel-45"), side).0.unwrap_err();
    let narrow = refused(&outside("rectangular, width: 0.9, depth: 1"), "", Side::Outer);
    assert_eq!(narrow.note().code(), "groove-too-narrow", "{narrow:?}");
    assert_eq!(narrow.note().figure_text("width").unwrap(), "1");
    // A blade of 1.3 mm enters 1.9 mm deep.
    let slot = refused(&outside("rectangular, width: 1.5, depth: 4"), "", Side::Outer);
    assert_eq!(slot.note().code(), "groove-beyond-blade", "{slot:?}");
    let deep = refused(&outside("rectangular, width: 6, depth: 21"), "", Side::Outer);
    assert_eq!(deep.note().code(), "groove-beyond-blade", "{deep:?}");
    // Both mouths of a corner relief lead under the metal: 135° and 45° with the angle of any insert are over 180°.
    let corner = "  - {from: {d: 0, z: 0}}\n  - {face: 40}\n  - {cylinder: -30}\n  - {groove: corner, width: 2, depth: 0.5}\n  - {face: 70}\n  - {cylinder: -100}\n";
    let under = refused(corner, "", Side::Outer);
    let NoJob::Undercut { main, secondary, .. } = under else { panic!("{under:?}") };
    assert!((main - 135.0).abs() < 0.1 && (secondary - 45.0).abs() < 0.1);
    let bore = "  - {from: {d: 18, z: 0}}\n  - {cylinder: -30}\n  - {groove: rectangular, width: 3, depth: 1}\n  - {cylinder: -100}\n";
    let outer = "  - {from: {d: 18, z: 0}}\n  - {face: 60}\n  - {cylinder: -100}\n";
    assert_eq!(refused(outer, bore, Side::Inner).note().code(), "job-bore-too-small");
    let face = "  - {from: {d: 0, z: 0}}\n  - {face: 20}\n  - {groove: face, width: 4, depth: 5}\n  - {face: 110}\n  - {cylinder: -100}\n";
    assert_eq!(refused(face, "", Side::Outer).note().code(), "groove-face-too-small");
}

/// A groove with a tolerance is not left to the width of a blade, if a narrower one goes in.
#[test]
fn a_groove_with_a_tolerance_is_turned_on_both_walls() {
    let (plain, _) = job(&part(&outside("rectangular, width: 4, depth: 3"), "", "steel-45"), Side::Outer);
    assert_eq!(plain.unwrap().tool.designation, "MGEHR 2525-4");
    let (fine, _) = job(&part(&outside("rectangular, width: 4, depth: 3, grade: h10"), "", "steel-45"), Side::Outer);
    assert_eq!(fine.unwrap().tool.designation, "MGEHR 2525-3");
}

/// Kyocera 2016, p. 461: aluminium, a blade of 5 mm: 200 m/min and 0.10 mm/rev at the least. On Ø60 1061 1/min, of the
/// spindle's steps 1000.
#[test]
fn a_light_alloy_is_grooved_by_the_maker() {
    let (made, _) = job(&part(&outside("rectangular, width: 8, depth: 5"), "", "aluminium-d16"), Side::Outer);
    let made = made.unwrap();
    assert_eq!(
        made.pace.speed().unwrap(),
        crate::turning::program::Speed::Spindle(crate::units::RevsPerMinute(1000.0))
    );
    assert!((made.pace.feeds().unwrap().plunge.0 - 0.1).abs() < 1e-9);
}

/// Deeper than one and a half widths the blade is drawn back: 9 mm with a blade of 4 are three steps.
#[test]
fn a_deep_groove_is_cut_in_steps() {
    let (made, _) = job(&part(&outside("rectangular, width: 6, depth: 9, radius: 1"), "", "steel-45"), Side::Outer);
    let made = made.unwrap();
    let pecked = made.notes.iter().find(|note| note.code() == "groove-pecked");
    assert!(pecked.is_some(), "{:?} {:?}", made.tool.designation, made.notes);
}

/// The groove of a V-belt, 31 at its mouth and 20 deep, was once cut by 63 plunges 0.2 mm apart. By hand: floor 31 − 40·tan 17° = 18.8,
/// five plunges of 5 mm, and the blade may take layers of 0.04·W²/(0.075·W) = 2.67 mm at 0.075·W, so 20 mm take eight.
#[test]
fn wide_walls_are_turned_in_layers() {
    let own = part(&outside("pulley, width: 31, depth: 20, angle: 34, radius: 2"), "", "steel-45");
    let made = job(&own, Side::Outer).0.unwrap();
    assert_eq!(plunges(&made).len(), 5, "{:?}", made.notes);
    let layers =
        made.notes.iter().find(|note| note.code() == "groove-layers").and_then(|note| note.figure_text("layers"));
    assert_eq!(layers.as_deref(), Some("8"), "{:?}", made.notes);
    let feeds = made.pace.feeds().unwrap();
    assert!(feeds.cut.0 <= 0.075 * 5.0 + 1e-9 && feeds.cut.0 * 8.0 / 3.0 <= feeds.plunge.0 * 5.0 + 0.001, "{feeds:?}");
    // Between upright walls plunges leave nothing to the sides.
    let own = part(&outside("rectangular, width: 20, depth: 4"), "", "steel-45");
    let made = job(&own, Side::Outer).0.unwrap();
    assert!(made.notes.iter().all(|note| note.code() != "groove-layers"), "{:?}", made.notes);
}
