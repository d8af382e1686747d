//! The law of a set-up: in a plan without findings no motion of any tool passes through fixture, clamp or part other than where it
//! cuts. The geometry here is the test's own: points along each motion, against boxes and cylinders that are drawn from the plan anew.

use proptest::prelude::*;
use technolog::motion::{Motion, MotionStep, Position};
use technolog::note::Severity;
use technolog::part::Part;
use technolog::plan::Plan;
use technolog::program::Setting;
use technolog::units::Micrometres;
use technolog_testing::KNOWLEDGE;
use technolog_testing::proof_bench::ProofBench;

/// A millimetre of a way, or less.
const STEP_MM: f64 = 1.0;
/// What rounding to the grid of the control may do, mm.
const GRID_MM: f64 = 0.02;

/// A box over the face: its lowest and highest corner, and its height, mm.
type Standing = ([f64; 2], [f64; 2], f64);

fn mm(length: Micrometres) -> f64 {
    length.to_mm()
}

/// Plates with drilled, reamed and wide holes on a grid, with and without clamps of their own.
fn parts() -> impl Strategy<Value = String> {
    let hole = (
        prop::sample::select(vec!["6H12", "10H12", "12H9", "20H12", "32H12", "60H12"]),
        0_i64..=4,
        0_i64..=3,
        prop::bool::ANY,
    );
    let fixture = prop::sample::select(vec![
        "",
        "fixture: {height: 40, clamps: [{at: [30, 100], height: 30}, {at: [370, 100], height: 45}]}",
        "fixture: {obstacles: [{outline: [[150, 80], [190, 120]], height: 60}]}",
        "fixture: {clamps: [{at: [200, 15], height: 35, outline: [[180, -40], [220, 30]]}, {at: [200, 185], height: 35}]}",
    ]);
    (prop::collection::vec(hole, 1..=4), 12_i64..=60, fixture).prop_map(|(holes, thickness, fixture)| {
        let mut text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\ndatum: {{x: left, y: front}}\n\
             blank: {{kind: plate, length: 400, width: 200, thickness: {thickness}}}\n{fixture}\nholes:\n"
        );
        for (number, (diameter, column, row, blind)) in holes.into_iter().enumerate() {
            let depth = if blind { format!("depth: {}", thickness / 2) } else { "through: true".to_owned() };
            let (x, y) = (45 + column * 77, 35 + row * 43);
            text.push_str(&format!(
                "  - {{name: H{number}, diameter: {diameter}, {depth}, roughness: Ra 6.3, centre_tolerance: 0.5, \
                 at: [[{x}, {y}]]}}\n"
            ));
        }
        text
    })
}

/// Discs and rings with holes around their axis.
fn discs() -> impl Strategy<Value = String> {
    let hole = (
        prop::sample::select(vec!["6H12", "10H12", "12H9", "20H12", "32H12"]),
        prop::sample::select(vec![60_i64, 95, 120]),
        0_i64..=15,
        prop::bool::ANY,
    );
    let blank = prop::sample::select(vec![
        "diameter: 300",
        "diameter: 300, bore: 70",
        "diameter: 300, held",
        "diameter: 190, held",
        "diameter: 150, bore: 50",
        "diameter: 105, held",
    ]);
    (prop::collection::vec(hole, 1..=4), 12_i64..=60, blank).prop_map(|(holes, thickness, blank)| {
        let asked = if blank.ends_with("held") { "fixture: {holding: chuck}\n" } else { "" };
        let blank = blank.trim_end_matches(", held");
        let mut text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\n{asked}\
             blank: {{kind: disc, {blank}, thickness: {thickness}}}\nholes:\n"
        );
        let outer: i64 = blank[10..13].parse().unwrap();
        for (number, (diameter, radius, place, blind)) in holes.into_iter().enumerate() {
            // 60, 95 and 120 mm of a disc of 300 mm.
            let radius = radius * outer / 300;
            let depth = if blind { format!("depth: {}", thickness / 2) } else { "through: true".to_owned() };
            let angle = place as f64 * 22.5;
            text.push_str(&format!(
                "  - {{name: H{number}, diameter: {diameter}, {depth}, roughness: Ra 6.3, centre_tolerance: 0.5, \
                 at: [{{r: {radius}, angle: {angle}}}]}}\n"
            ));
        }
        text
    })
}

/// What stands over the face by the file and the plan: clamps with a height, 20 mm about their point without an outline, obstacles,
/// and the straps of the plan, half their width inside the point and the rest of their length over the nearest side.
fn standing(plan: &Plan, part: &Part) -> Vec<Standing> {
    let mut all = Vec::new();
    for clamp in &part.fixture.clamps {
        let Some(height) = clamp.height else { continue };
        let at = [mm(clamp.at.x), mm(clamp.at.y)];
        let (low, high) = match clamp.outline {
            Some([low, high]) => ([mm(low.x), mm(low.y)], [mm(high.x), mm(high.y)]),
            // The margin about a clamp without an outline is in its 20 mm: the clamp itself is narrower.
            None => (at.map(|at| at - 10.0), at.map(|at| at + 10.0)),
        };
        all.push((low, high, mm(height)));
    }
    for obstacle in &part.fixture.obstacles {
        let [low, high] = obstacle.outline;
        all.push(([mm(low.x), mm(low.y)], [mm(high.x), mm(high.y)], mm(obstacle.height)));
    }
    let Some(clamping) = plan.clamping.as_ref().filter(|clamping| clamping.proposed) else { return all };
    let Some(strap) = clamping.strap else { return all };
    let (width, length, height) = (mm(strap.width_mm), mm(strap.length_mm), mm(strap.height_mm));
    let size = [mm(part.blank.length), mm(part.blank.width)];
    let corner = [mm(part.datum.left), mm(part.datum.front)];
    for at in &clamping.clamps {
        let at = [mm(at.x), mm(at.y)];
        let (mut low, mut high) = (at.map(|at| at - width / 2.0), at.map(|at| at + width / 2.0));
        let [along, across] = [at[0] - corner[0], at[1] - corner[1]];
        let sides = [along, size[0] - along, across, size[1] - across];
        let nearest = (0..4).min_by(|one, two| sides[*one].total_cmp(&sides[*two])).unwrap();
        let (axis, outward) = (nearest / 2, nearest % 2 == 1);
        if outward {
            high[axis] = at[axis] + length - width / 2.0
        } else {
            low[axis] = at[axis] - length + width / 2.0
        }
        all.push((low, high, height));
    }
    all
}

/// What of a chuck the tip of a tool of that radius meets there, with Z from the face: the wall of a jaw beside the part, a step under
/// it, or its body. The depths of the steps are half the differences of the least diameters that two walls hold, by the pages of `chucks`.
fn in_chuck(plan: &Plan, at: [f64; 2], z: f64, radius: f64) -> Option<&'static str> {
    let chuck = plan.setup.chuck.as_ref()?;
    let (part, wall) = (&plan.part, mm(chuck.grip_mm));
    let (rim, thickness) = (mm(part.blank.length) / 2.0, mm(part.blank.thickness));
    let ledge = match mm(chuck.diameter_mm).round() as i64 {
        160 => (98.0 - 50.0) / 2.0,
        200 => (130.0 - 60.0) / 2.0,
        _ => (190.0 - 90.0) / 2.0,
    };
    if z < -thickness - mm(chuck.room_mm) + GRID_MM && at[0].hypot(at[1]) < mm(chuck.diameter_mm) / 2.0 + radius {
        return Some("body");
    }
    [0.0, 120.0, 240.0].into_iter().find_map(|more| {
        let angle = (f64::from(chuck.jaw_deg) + more).to_radians();
        let (along, aside) = (at[0] * angle.cos() + at[1] * angle.sin(), at[1] * angle.cos() - at[0] * angle.sin());
        let meets = |from: f64, to: f64, top: f64| {
            let away =
                (from - along).max(along - to).max(0.0).hypot((aside.abs() - mm(chuck.jaw_width_mm) / 2.0).max(0.0));
            z < top - GRID_MM && away < radius - GRID_MM
        };
        if meets(rim, rim.max(mm(chuck.diameter_mm) / 2.0), -mm(chuck.below_face_mm)) {
            return Some("wall");
        }
        let steps = (0..i32::try_from(chuck.step).unwrap()).map(f64::from);
        let mut under = steps.map(|step| (rim - (step + 1.0) * ledge, rim - step * ledge, -thickness - step * wall));
        under.any(|(from, to, top)| meets(from.max(0.0), to, top)).then_some("step")
    })
}

/// How far a point is from a box, seen from above.
fn away(at: [f64; 2], (low, high, _): &Standing) -> f64 {
    let beside = |axis: usize| (low[axis] - at[axis]).max(at[axis] - high[axis]).max(0.0);
    beside(0).hypot(beside(1))
}

/// The points of the tip along a motion, the end among them.
fn points(from: Position, step: &MotionStep) -> Vec<[f64; 3]> {
    let [a, b] = [from, step.at].map(|at| [mm(at.x), mm(at.y), mm(at.z)]);
    match &step.motion {
        Motion::Arc { centre, sense, .. } => {
            let centre = centre.map(mm);
            let radius = (a[0] - centre[0]).hypot(a[1] - centre[1]);
            let angle = |at: [f64; 3]| (at[1] - centre[1]).atan2(at[0] - centre[0]);
            let mut sweep = angle(b) - angle(a);
            let turn = 2.0 * std::f64::consts::PI;
            let clockwise = *sense == technolog::motion::Sense::Clockwise;
            if clockwise && sweep >= -1e-9 {
                sweep -= turn;
            } else if !clockwise && sweep <= 1e-9 {
                sweep += turn;
            }
            let count = ((sweep.abs() * radius / STEP_MM).ceil() as usize).max(8);
            let of = |part: f64| {
                let angle = angle(a) + sweep * part;
                [centre[0] + radius * angle.cos(), centre[1] + radius * angle.sin(), a[2] + (b[2] - a[2]) * part]
            };
            (0..=count).map(|index| of(index as f64 / count as f64)).collect()
        }
        Motion::Rapid | Motion::Feed { .. } => {
            let length = (0..3).map(|axis| (b[axis] - a[axis]).powi(2)).sum::<f64>().sqrt();
            let count = ((length / STEP_MM).ceil() as usize).max(1);
            let of = |part: f64| std::array::from_fn(|axis| a[axis] + (b[axis] - a[axis]) * part);
            (0..=count).map(|index| of(index as f64 / count as f64)).collect()
        }
        _ => Vec::new(),
    }
}

fn holds(bench: &ProofBench) -> Result<(), TestCaseError> {
    let (plan, part) = (&bench.plan, &bench.plan.part);
    let Some(stand) = plan.setup.stands.first() else { return Ok(()) };
    let standing = standing(plan, part);
    let thickness = mm(part.blank.thickness);
    // The table, or the ways of the vice, below the face.
    let raised = plan.setup.vice.as_ref().map_or(mm(stand.height_mm), |vice| mm(vice.parallels_mm.unwrap_or_default()));
    let floor = -thickness - raised;
    for control in ["linuxcnc", "2c42-65"] {
        let language = technolog::program::Language::read(control, &KNOWLEDGE).unwrap();
        let text = bench.written(&language);
        let setting = Setting::of_job(&bench.job);
        let mut steps: Vec<MotionStep> = Vec::new();
        language.check(&text, &bench.machine, &setting, &mut steps);
        let (mut at, mut place) = (setting.start, 0);
        for step in &steps {
            if let Motion::ToolChange { tool } = step.motion {
                place = tool;
            }
            // The magazine of the test is never loaded twice: the place of a tool is its number.
            let tool = plan.tools.iter().find(|tool| tool.number == place);
            if let Some(tool) = tool {
                let radius = mm(tool.diameter_mm) / 2.0;
                let [x0, y0, z0] = stand.zero_mm.map(mm);
                for [x, y, z] in points(at, step) {
                    let (tip, z) = ([x - x0, y - y0], z - z0 - mm(tool.correction_mm));
                    for one in &standing {
                        let through = z < one.2 - GRID_MM && away(tip, one) < radius - GRID_MM;
                        prop_assert!(!through, "{control}: T{place} at {tip:?} Z{z}: {one:?}\n{text}");
                    }
                    prop_assert!(z > floor - GRID_MM, "{control}: T{place} at {tip:?} Z{z} in the fixture, {floor}");
                    let chuck = in_chuck(plan, tip, z, radius);
                    prop_assert!(
                        chuck.is_none(),
                        "{control}: T{place} at {tip:?} Z{z} in the chuck, {chuck:?}\n{text}"
                    );
                    if z < -GRID_MM {
                        let cuts = part.holes.iter().any(|hole| {
                            // A drill of 90° wider than the hole centres it.
                            let widest = mm(hole.diameter.largest()).max(2.0 * radius) / 2.0;
                            hole.at.iter().any(|hole| {
                                let off = (mm(hole.x) - tip[0]).hypot(mm(hole.y) - tip[1]);
                                off + radius <= widest + GRID_MM
                            })
                        });
                        prop_assert!(cuts, "{control}: T{place} at {tip:?} Z{z} in the part\n{text}");
                    }
                }
                let envelope = bench.job.envelopes.iter().find(|envelope| envelope.tool == place);
                for body in envelope.into_iter().flat_map(|envelope| &envelope.bodies).filter(|body| body.known) {
                    for [x, y, z] in points(at, step) {
                        let (axis, low) = ([x - x0, y - y0], z - z0 - mm(tool.correction_mm) + mm(body.from));
                        for one in &standing {
                            let through = low < one.2 - GRID_MM && away(axis, one) < mm(body.diameter) / 2.0 - GRID_MM;
                            prop_assert!(
                                !through,
                                "{control}: {:?} of T{place} at {axis:?} Z{low}: {one:?}",
                                body.kind
                            );
                        }
                        let enters = part.holes.iter().any(|hole| {
                            let over = |at: &technolog::part::Point| {
                                away(axis, &([mm(at.x), mm(at.y)], [mm(at.x), mm(at.y)], 0.0))
                            };
                            body.diameter < hole.diameter.nominal
                                && hole.at.iter().any(|at| over(at) < mm(hole.diameter.nominal) / 2.0)
                        });
                        prop_assert!(low > -GRID_MM || enters, "{control}: {body:?} of T{place} at {axis:?} Z{low}");
                    }
                }
            }
            at = step.at;
        }
    }
    Ok(())
}

/// A part that is planned without a grave finding sends no motion through anything.
fn clear(text: &str) -> Result<(), TestCaseError> {
    let Ok(part) = technolog::part::read_part("part.yaml", text, &KNOWLEDGE) else { return Ok(()) };
    let bench = ProofBench::of(&part);
    let grave = |finding: &technolog::note::Finding| finding.severity <= Severity::Wrong;
    if bench.plan.findings.iter().any(grave) || bench.job.findings.iter().any(grave) {
        return Ok(());
    }
    holds(&bench)
}

proptest! {
    #![proptest_config(technolog_laws::cases!(40))]

    #[test]
    fn no_motion_of_a_plan_without_findings_passes_through_anything(text in parts()) {
        clear(&text)?;
    }
}

proptest! {
    #![proptest_config(technolog_laws::cases!(20))]

    #[test]
    fn no_motion_over_a_disc_passes_through_anything(text in discs()) {
        clear(&text)?;
    }
}
