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

/// Feet 20 mm to both sides of where a strap presses do not stand on a ring 30 mm wide, and a disc rolls between flat jaws.
#[test]
fn a_narrow_ring_is_not_held_until_the_file_says_by_what() {
    let ring = "diameter: 120, bore: 60, thickness: 30";
    let bare = plan(ring, "", "[[45, 0]]");
    assert!(bare.clamping.is_none() && bare.setup.vice.is_none());
    assert_eq!(told(&bare, "no-vice"), Some(Severity::Wrong));
    let own = plan(ring, "fixture: {own: chuck of the shop, height: 90}", "[[45, 0]]");
    assert!(!own.has_errors(), "{:?}", own.findings);
    assert_eq!(told(&own, "no-vice"), None);
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
