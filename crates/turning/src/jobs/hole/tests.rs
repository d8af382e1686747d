//! Holes on the axis. Figures are of the tables that the sentences beside them name.

use super::*;
use crate::turning::jobs::tests::{at_bench, plain};

fn with_bench<T>(material: &str, of: impl FnOnce(&Bench<'_, '_>) -> T) -> T {
    at_bench(&plain(material), of)
}

fn drilled(diameter: i64, end: HoleEnd) -> Result<Job, NoJob> {
    let hole = Hole {
        diameter: Micrometres::from_mm(diameter),
        from: Micrometres::ZERO,
        face: Half::ZERO,
        end,
        surfaces: Vec::new(),
        exact: false,
        tapped: false,
    };
    with_bench("steel-45", |bench| Refusal::split(drill(&hole, bench)).unwrap())
}

/// А.12: Ø20 is 035-2301-1060, flute of 140. Its point of 118° is 10/tan 59° = 6.009 long. Blind the point stays at the
/// bottom, through it comes 2 mm out with its full diameter.
#[test]
fn the_point_of_a_drill_stays_above_the_bottom() {
    let blind = drilled(20, HoleEnd::Blind(Half::from(48.0))).unwrap();
    assert_eq!(blind.tool.designation, "035-2301-1060");
    let deepest = blind.path.moves.iter().map(|one| one.to.z).max().unwrap();
    assert_eq!(deepest, Half::from(48.0));
    let point = blind.notes.iter().find(|note| note.code() == "job-drill-point").unwrap();
    assert!((point.figure_text("full").unwrap().parse::<f64>().unwrap() - (48.0 - 6.0086)).abs() < 0.001);
    let through = drilled(20, HoleEnd::Through(Half::from(50.0))).unwrap();
    let deepest = through.path.moves.iter().map(|one| one.to.z.to_mm()).fold(0.0, f64::max);
    assert!((deepest - 58.0086).abs() < 0.001, "{deepest}");
    assert_eq!(through.path.from.radius, Half::ZERO);
    // Three diameters deep: in one go.
    assert_eq!(through.path.moves.iter().filter(|one| one.purpose == Purpose::Plunge).count(), 1);
}

/// By the rule machining-cycle: over 5 diameters the chip is broken after each diameter, over 8 the drill comes out after each half.
#[test]
fn deep_holes_are_drilled_in_steps() {
    let broken = drilled(10, HoleEnd::Blind(Half::from(60.0))).unwrap();
    let plunges = |job: &Job| job.path.moves.iter().filter(|one| one.purpose == Purpose::Plunge).count();
    assert_eq!(plunges(&broken), 6);
    assert!(broken.path.moves.iter().any(|one| one.purpose == Purpose::Return));
    let pecked = drilled(10, HoleEnd::Blind(Half::from(85.0))).unwrap();
    assert_eq!(plunges(&pecked), 17);
    let out = pecked.path.moves.iter().filter(|one| one.purpose == Purpose::Rapid && one.to.z < Half::ZERO).count();
    assert_eq!(out, 17, "out after every step");
    let mut at = pecked.path.from.z;
    let mut cut = Half::ZERO;
    for one in &pecked.path.moves {
        if one.purpose == Purpose::Rapid {
            assert!(one.to.z <= cut, "no rapid into metal");
        } else {
            cut = cut.max(one.to.z);
        }
        at = one.to.z;
    }
    assert_eq!(at, pecked.path.from.z);
}

/// The thrust of Косилова/Мещеряков, table 32, P = 10·68·D·s^0.7·(σB/750)^0.75, stays within the drive of Z: 8000 N.
#[test]
fn a_drill_is_held_by_the_drive_of_z() {
    let made = drilled(30, HoleEnd::Blind(Half::from(40.0))).unwrap();
    let strength = with_bench("steel-45", |bench| bench.material.strength.to_f64());
    let thrust =
        10.0 * 68.0 * 30.0 * libm::pow(made.pace.feeds().unwrap().plunge.0, 0.7) * libm::pow(strength / 750.0, 0.75);
    assert!(thrust < 8000.5, "{thrust} at {:?}", made.pace.feeds().unwrap().plunge);
    let wide = drilled(50, HoleEnd::Blind(Half::from(40.0))).unwrap();
    let thrust =
        10.0 * 68.0 * 50.0 * libm::pow(wide.pace.feeds().unwrap().plunge.0, 0.7) * libm::pow(strength / 750.0, 0.75);
    assert!((7990.0..8000.5).contains(&thrust), "held at the limit: {thrust}");
    assert!(drilled(2, HoleEnd::Blind(Half::from(300.0))).is_err());
}

/// ГОСТ 14034-74: for Ø40 form A of d 5: D 10.6, l1 4.85, l 6.3. Form B protects with D2 16. For a drill of 20 mm the spot is
/// at most Ø12: d 5 again.
#[test]
fn centre_holes_are_those_of_the_standard() {
    with_bench("steel-45", |bench| {
        let deep = |job: &Job| job.path.moves[0].to.z;
        let plain =
            Refusal::split(centre_hole(CentreForm::A, Micrometres::from_mm(40), Half::ZERO, bench)).unwrap().unwrap();
        assert_eq!(plain.tool.designation, "ГОСТ 14952-75 A5.0");
        assert_eq!(deep(&plain), Half::from(4.85 + 6.3));
        let kept =
            Refusal::split(centre_hole(CentreForm::B, Micrometres::from_mm(40), Half::ZERO, bench)).unwrap().unwrap();
        assert_eq!(deep(&kept), Half::from(6.41 + 6.3));
        let spotted =
            Refusal::split(spot(Micrometres::from_mm(20), Half::ZERO, Half::from(40.0), bench)).unwrap().unwrap();
        assert_eq!(spotted.tool.designation, "ГОСТ 14952-75 A5.0");
        let small = Refusal::split(centre_hole(CentreForm::A, Micrometres::from_mm(3), Half::ZERO, bench)).unwrap();
        assert_eq!(small.unwrap_err().note().code(), "job-no-centre-hole");
        for made in [plain, kept, spotted] {
            assert!(
                made.pace.feeds().unwrap().plunge.0 > 0.0 && made.pace.feeds().unwrap().plunge.0 < 0.2,
                "{:?}",
                made.pace.feeds().unwrap().plunge
            );
            assert!(made.time_min.0 > 0.0 && made.time_min.0 < 1.0);
        }
    });
}

/// Textbook 1.2.1: above 30 mm in two passes, the first drill 0.5 to 0.6 of the second.
#[test]
fn wide_holes_are_drilled_in_two_passes() {
    let hole = |diameter: i64| Hole {
        diameter: Micrometres::from_mm(diameter),
        from: Micrometres::ZERO,
        face: Half::ZERO,
        end: HoleEnd::Blind(Half::from(60.0)),
        surfaces: Vec::new(),
        exact: false,
        tapped: false,
    };
    with_bench("steel-45", |bench| {
        let widths = |diameter: i64| -> Vec<f64> {
            let jobs = Refusal::split(drilling(&hole(diameter), bench)).unwrap().unwrap();
            let width = |job: &Job| match job.tool.body {
                Body::Drill { diameter_mm, .. } => diameter_mm.to_mm(),
                _ => panic!("a drill"),
            };
            jobs.iter().map(width).collect()
        };
        assert_eq!(widths(30).len(), 1);
        let two = widths(40);
        assert!(two.len() == 2 && two[1] == 40.0 && (0.5..=0.6).contains(&(two[0] / 40.0)), "{two:?}");
    });
}
