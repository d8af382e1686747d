//! Round blanks: discs, flanges and rings.

use technolog::note::Severity;
use technolog::part::{Part, Point};
use technolog::plan::{CuttingMethod, HeldBy, PartLocating, Plan};
use technolog::units::Micrometres;
use technolog_testing::{planned, read};

fn disc(blank: &str, more: &str, at: &str) -> Part {
    read(&format!(
        "part: P\nmaterial: steel-45\nmachine: gf2171\nblank: {{kind: disc, {blank}}}\n{more}\nholes:\n  \
         - {{name: A, diameter: 10H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.46, at: {at}}}\n"
    ))
}

fn plan(blank: &str, more: &str, at: &str) -> Plan {
    planned(&disc(blank, more, at), CuttingMethod::Formula)
}

fn told(plan: &Plan, code: &str) -> Option<Severity> {
    plan.findings.iter().find(|finding| finding.note.code() == code).map(|finding| finding.severity)
}

/// 62.5 mm at 45° are 62.5/√2 = 44.1942 mm along both axes; the zero lies at the axis of the disc.
#[test]
fn a_point_may_be_given_by_distance_and_angle() {
    let part = disc("diameter: 170, thickness: 20", "", "[{r: 62.5, angle: 45}, {r: 62.5, angle: 180}, [0, -62.5]]");
    let at = |x, y| Point { x: Micrometres::new(x), y: Micrometres::new(y) };
    assert_eq!(part.holes[0].at, [at(44_194, 44_194), at(-62_500, 0), at(0, -62_500)]);
    assert_eq!(part.middle(), at(0, 0));
}

/// π/4 · 0.9² · s · 7850 kg/m³: 400 kg at s = 80.1 mm, where a square plate of that size would have 509 kg. A bore of 600 mm takes
/// 4/9 of it away.
#[test]
fn a_disc_weighs_less_than_the_plate_about_it() {
    for (blank, heavy) in [
        ("diameter: 900, thickness: 80", false),
        ("diameter: 900, thickness: 81", true),
        ("diameter: 900, bore: 600, thickness: 81", false),
        ("diameter: 900, bore: 600, thickness: 146", true),
    ] {
        let plan = plan(blank, "", "[[0, 400]]");
        assert_eq!(told(&plan, "plate-too-heavy").is_some(), heavy, "{blank}");
    }
}

/// Straps press 20 mm inside the rim of a disc, opposite each other, clear of the bolts; nothing but its axis says where it is.
#[test]
fn a_disc_is_held_at_its_rim_and_found_by_its_axis() {
    let bolts = "[{r: 62.5, angle: 45}, {r: 62.5, angle: 135}, {r: 62.5, angle: 225}, {r: 62.5, angle: 315}]";
    let plan = plan("diameter: 170, thickness: 20", "", bolts);
    assert!(!plan.has_errors(), "{:?}", plan.findings);
    let clamping = plan.clamping.as_ref().unwrap();
    let axis = Point { x: Micrometres::ZERO, y: Micrometres::ZERO };
    for at in &clamping.clamps {
        assert!((at.distance(axis).to_mm() - 65.0).abs() < 0.002, "{at:?}");
    }
    let fixture = plan.setup.fixture.as_ref().unwrap();
    assert_eq!((fixture.held, fixture.locating), (HeldBy::Straps, PartLocating::PlaneAndAxis));
    assert_eq!(fixture.locating_error_mm, None, "each one is found anew");
    assert_eq!(plan.zero_axis(1), Some(axis));
    let [stand] = &plan.setup.stands[..] else { panic!("{:?}", plan.setup.stands) };
    assert_eq!((stand.zero_mm[0], stand.zero_mm[1]), (Micrometres::ZERO, Micrometres::ZERO));
}

/// Feet 20 mm to both sides of where a strap presses do not stand on a ring 30 mm wide, so jaws hold it: on their outer wall from
/// Ø98 on, 117.7 mm over the table; the wall of 14.6 mm ends 15.4 mm below the face of a ring 30 mm thick.
///
/// M and T of the drill: 2.5·2·M/(D·f) against turning; and about the line between two jaws 22 mm wide, 60·cos(60° − asin(11/60))
/// = 39.02 mm from the axis, 2.5·T·(45 − 39.02)/(60 + 39.02) must be borne by 0.15/3 of the force.
#[test]
fn a_narrow_ring_is_held_in_a_chuck() {
    let plan = plan("diameter: 120, bore: 60, thickness: 30", "", "[[45, 0]]");
    assert!(!plan.has_errors(), "{:?}", plan.findings);
    assert!(plan.clamping.is_none() && plan.setup.vice.is_none());
    let chuck = plan.setup.chuck.as_ref().unwrap();
    let um = |length: Micrometres| length.micrometres();
    assert_eq!((chuck.step, um(chuck.part_height_mm), um(chuck.below_face_mm)), (2, 117_700, 15_400));
    let [stand] = &plan.setup.stands[..] else { panic!("{:?}", plan.setup.stands) };
    assert_eq!(um(stand.height_mm), 117_700, "the zero of Z lies on the jaws");
    let cuts = || plan.holes[0].transitions.iter().map(|one| &one.conditions);
    let torque = cuts().filter_map(|one| one.torque_n_m).fold(0.0_f64, |most, one| most.max(one.0));
    let thrust = cuts().filter_map(|one| one.axial_force_n).fold(0.0_f64, |most, one| most.max(one.0));
    let needed = (2.5 * 2.0 * torque / (0.12 * 0.15)).max(2.5 * thrust * (45.0 - 39.02) / (60.0 + 39.02) / 0.05);
    assert!((chuck.force_n.0 - needed).abs() < 5.0, "{} for {needed}", chuck.force_n.0);
    let fixture = plan.setup.fixture.as_ref().unwrap();
    assert_eq!((fixture.held, fixture.keying), (HeldBy::Chuck, None));
    assert_eq!(told(&plan, "chuck-squeezes-ring"), Some(Severity::Doubtful), "a wall of 30 mm gives way unreckoned");
}

/// Ø10 at 45 mm: the hole reaches from 40 to 50 mm, over the steps under the ring, which end 36 mm from the axis. A jaw 22 mm wide
/// is clear of it by 1 mm from asin((11 + 5 + 1)/45) = 22.2° on; three holes at 0°, 120°, 240° leave the jaws 60° to stand at.
#[test]
fn no_jaw_stands_under_a_through_hole() {
    let plan = plan("diameter: 120, bore: 60, thickness: 30", "", "[[45, 0], [-22.5, 38.971], [-22.5, -38.971]]");
    let jaws = plan.setup.chuck.as_ref().unwrap().jaws(technolog::part::Face::Entry);
    for jaw in jaws {
        let off = [0, 120, 240].map(|hole: i64| (i64::from(jaw) - hole + 540).rem_euclid(360) - 180);
        assert!(off.iter().all(|off| off.abs() > 22), "{jaws:?}");
    }
    // Turned over, right and left change places: 30° and 90° are then the same jaws.
    assert_eq!(plan.setup.chuck.as_ref().unwrap().jaws(technolog::part::Face::Back), jaws);
}

/// What no chuck of the table holds: a disc too thin for the jaws to end below its face, one with through holes every 20° so that
/// each place of the jaws meets one, one wider than the table has.
#[test]
fn a_disc_that_no_chuck_holds_needs_a_fixture_of_its_own() {
    let asked = "fixture: {holding: chuck}";
    let at = |radius: f64, count: u32| {
        let point = |step: u32| f64::from(step) * std::f64::consts::TAU / f64::from(count);
        let points = (0..count).map(point).map(|a| format!("[{:.3}, {:.3}]", radius * a.cos(), radius * a.sin()));
        format!("[{}]", points.collect::<Vec<_>>().join(", "))
    };
    for (blank, holes, why) in [
        ("diameter: 120, thickness: 16", at(30.0, 1), "chuck-no-grip"),
        ("diameter: 120, thickness: 30", at(45.0, 18), "chuck-jaws-below"),
        ("diameter: 330, thickness: 30", at(45.0, 1), "chuck-of-no-size"),
    ] {
        let plan = plan(blank, asked, &holes);
        let finding = plan.findings.iter().find(|finding| finding.note.code() == "no-chuck").unwrap();
        assert_eq!(finding.severity, Severity::Wrong);
        assert!(format!("{:?}", finding.note).contains(why), "{:?}", finding.note);
        assert!(plan.setup.chuck.is_none() && plan.clamping.is_none(), "{blank}");
    }
    let own = plan("diameter: 120, thickness: 16", "fixture: {own: chuck of the shop, height: 90}", "[[45, 0]]");
    assert!(!own.has_errors() && told(&own, "no-chuck").is_none(), "{:?}", own.findings);
    let held = plan("diameter: 120, thickness: 17", asked, "[[30, 0]]");
    assert_eq!(held.setup.chuck.as_ref().map(|chuck| chuck.below_face_mm.micrometres()), Some(2400));
}

/// Between the corners of the plate about a disc there is no metal: a hole at [60, 60] is 84.9 mm from the axis, and one of 10 mm
/// leaves 100 − 84.9 − 5 = 10.1 mm of a disc Ø200, but 0.1 mm of one of Ø180.
#[test]
fn the_wall_beside_a_hole_is_that_to_the_rim() {
    let thin = |diameter: u32| {
        let plan = plan(&format!("diameter: {diameter}, thickness: 20"), "", "[[60, 60]]");
        ["proof-wall-to-edge", "proof-no-wall-to-edge"].iter().any(|code| told(&plan, code).is_some())
    };
    assert!(!thin(200) && thin(180));
}
