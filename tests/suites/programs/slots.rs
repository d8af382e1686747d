//! Slots and pockets: their programs on every control, the time of their passes by hand, and what the proof says of spoilt ones.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const CONTROLS: [&str; 6] = ["2c42-65", "linuxcnc", "fanuc", "haas-ngc", "mach3", "grbl"];

/// Along an axis and across both, blind and through, narrow and wide, with and without a finishing way round. No strap finds room
/// on the face.
const SLOTS: &str = "part: P
material: steel-45
blank: {kind: plate, length: 240, width: 120, thickness: 16}
machine: gf2171
fixture: {own: side clamps, height: 60}
slots:
  - {name: S, centre: [0, 0], length: 70, angle: 27, width: 20H12, depth: 8, roughness: Ra 3.2, centre_tolerance: 0.4}
  - {name: T, centre: [60, -30], length: 40, angle: 90, width: 6H12, depth: 4, roughness: Ra 12.5, centre_tolerance: 0.4}
  - {name: U, centre: [-60, 30], length: 60, width: 25H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.4}
  - {name: V, centre: [72, 32], length: 46, width: 40H12, depth: 5, roughness: Ra 12.5, centre_tolerance: 0.4}
";

/// One slot 14 mm wide, 40 mm between the middles of its end radii, 8 mm deep.
const ONE: &str = "part: P
material: steel-45
blank: {kind: plate, length: 200, width: 120, thickness: 16}
machine: gf2171
fixture: {height: 60, clamps: [{at: [-80, 0], height: 30}, {at: [80, 0], height: 30}]}
slots:
  - {name: S, from: [-20, 0], to: [20, 0], width: 14H12, depth: 8, roughness: Ra 6.3, centre_tolerance: 0.4}
";

/// Pockets along the axes and across both, blind and through, a square one, with large and small corners, and a slot beside them.
const POCKETS: &str = "part: P
material: steel-45
blank: {kind: plate, length: 300, width: 200, thickness: 25}
machine: gf2171
fixture: {height: 60}
slots:
  - {name: K, centre: [0, 0], length: 60, width: 40H12, corner: 8, depth: 10, roughness: Ra 6.3, centre_tolerance: 0.4}
  - {name: L, centre: [-90, 40], length: 50, angle: 30, width: 32, corner: 6.5, depth: 6, roughness: Ra 12.5, centre_tolerance: 0.4}
  - {name: M, centre: [-90, -50], length: 36, width: 36H11, corner: 10, through: true, roughness: Ra 3.2, centre_tolerance: 0.4}
  - {name: N, centre: [90, 30], length: 80, angle: 90, width: 50, corner: 20, depth: 5, roughness: Ra 12.5, centre_tolerance: 0.4}
  - {name: S, centre: [80, -60], length: 70, angle: 27, width: 20H12, depth: 8, roughness: Ra 3.2, centre_tolerance: 0.4}
";

/// One pocket 60 × 40 with corners of 8 mm, 10 mm deep.
const POCKET: &str = "part: P
material: steel-45
blank: {kind: plate, length: 240, width: 160, thickness: 25}
machine: gf2171
fixture: {height: 60}
slots:
  - {name: K, centre: [0, 0], length: 60, width: 40H12, corner: 8, depth: 10, roughness: Ra 6.3, centre_tolerance: 0.4}
";

/// Slots open at one edge, across the part and under an angle, blind and through, with and without a finishing way round.
const OPEN: &str = "part: P
material: steel-45
blank: {kind: plate, length: 200, width: 120, thickness: 16}
machine: gf2171
fixture: {height: 60}
slots:
  - {name: A, from: [100, 0], to: [60, 0], open: from, width: 14H12, depth: 8, roughness: Ra 6.3, centre_tolerance: 0.4}
  - {name: B, from: [-40, -60], to: [-40, 60], open: both, width: 20H12, depth: 6, roughness: Ra 6.3, centre_tolerance: 0.4}
  - {name: C, from: [0, 0], to: [30, 60], open: to, width: 12H12, through: true, roughness: Ra 12.5, centre_tolerance: 0.4}
";

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/tmp/slots").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn technolog(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_technolog")).current_dir(folder).args(args).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
fn every_control_cuts_slots_whole() {
    let folder = folder("controls");
    for (part, control) in [SLOTS, POCKETS, OPEN].into_iter().flat_map(|part| CONTROLS.map(|control| (part, control))) {
        fs::write(folder.join("part.yaml"), part).unwrap();
        // The program is read back and proven before it is shown.
        let made = technolog(&folder, &["program", "part.yaml", "--control", control, "--lang", "en", "-o", "p.nc"]);
        assert_eq!(made.status.code(), Some(0), "{control}: {}", text(&made.stderr));
        let found = technolog(&folder, &["check", "p.nc", "--control", control, "--part", "part.yaml", "--lang", "en"]);
        let said = text(&found.stdout) + &text(&found.stderr);
        assert!(found.status.code() == Some(0) && !said.contains("slot-"), "{control}: {said}");
    }
}

/// Mill Ø12, 2 teeth. Roughing to 13.09: 2 levels of 4 mm, each once along the middle and once round, r = (13.09 - 12)/2 = 0.545,
/// onto the walls by r and off them by r/√2: 2·(40 + 2·40 + 1.7071·0.545) = 241.86 mm at 48 mm/min. Arcs: two halves and a quarter
/// of r, a quarter of r/2, 2.75·π·r: 2·4.708 = 9.417 mm. 48·0.545/6.545 = 4 mm/min would be 2.5 µm a tooth: 0.01·2·800 = 16. 11 mm
/// down at a quarter of 48. 5.039 + 0.589 + 0.917 = 6.544 min. Finishing to 14.09: one level, r = 1.045, 0.7 of the feed for
/// Ra 6.3, 2·40 + 1.784 + 11 = 92.78 mm at 33.6, 9.028 mm of arcs at 16, of which 33.6·1.045/7.045 = 5 is less: 2.761 + 0.564 = 3.326.
#[test]
fn the_passes_of_a_slot_take_what_they_take_by_hand() {
    let folder = folder("time");
    fs::write(folder.join("part.yaml"), ONE).unwrap();
    let plan = technolog(&folder, &["plan", "part.yaml", "--format", "json"]);
    assert_eq!(plan.status.code(), Some(0), "{}", text(&plan.stderr));
    let plan: serde_json::Value = serde_json::from_slice(&plan.stdout).unwrap();
    let steps = plan["holes"][0]["transitions"].as_array().unwrap();
    let figure = |step: usize, name: &str| steps[step]["conditions"][name].as_f64().unwrap();
    assert_eq!(steps.len(), 2);
    assert_eq!([figure(0, "feed_mm_per_min"), figure(1, "feed_mm_per_min")], [48.0, 33.6]);
    assert_eq!([figure(0, "depth_of_cut_mm"), figure(1, "depth_of_cut_mm")], [12.0, 0.5]);
    for (step, minutes) in [(0, 6.544), (1, 3.326)] {
        let took = figure(step, "machine_time_min");
        assert!((took - minutes).abs() < 0.01, "{step}: {took}");
    }
}

/// Mill Ø14, 2 teeth, 630 turns. Roughing to 39.125: 2 levels of 5 mm, each 20 mm along the middle and round by r = 6.281 and
/// 12.563, at most half of the mill apart. In the corners the mill's middle turns by 8 - 0.5 - 7 = 0.5 in the last and not at all in
/// the first: 2·20 + 8·6.281 = 90.25 and 2·20 + 8·12.063 = 136.5 mm straight. On and off the walls by quarters of 6.281 and 3.141,
/// 7 and 3.5, with 6.281 + 4.442 and 8.941 + 9.715 mm straight: 40 + 2·256.13 = 552.26 mm at 63 mm/min. Arcs at r/(r + 7) of that in whole mm/min:
/// onto the walls 9.866 mm at 29 and 10.996 at 31, off them 4.933 at 19 and 5.498 at 21, in the corners 2·π·0.5 mm, no slower than
/// 0.01·2·630 = 12, twice 1.478 min; 13 mm down at 15. 8.766 + 2.956 + 0.867 = 12.589 min.
/// Finishing to 40.125: one level, r = 13.063, 136.5 + 9.260 + 10.183 + 13 = 168.94 mm at 44.1, arcs 10.996 mm at 22, 5.498 at 14 and
/// 2·π·1 at 12: 3.831 + 1.416 = 5.247.
#[test]
fn the_passes_of_a_pocket_take_what_they_take_by_hand() {
    let folder = folder("pocket-time");
    fs::write(folder.join("part.yaml"), POCKET).unwrap();
    let plan = technolog(&folder, &["plan", "part.yaml", "--format", "json"]);
    assert_eq!(plan.status.code(), Some(0), "{}", text(&plan.stderr));
    let plan: serde_json::Value = serde_json::from_slice(&plan.stdout).unwrap();
    let steps = plan["holes"][0]["transitions"].as_array().unwrap();
    assert_eq!(steps.len(), 2);
    for (step, minutes) in [(0, 12.589), (1, 5.247)] {
        let took = steps[step]["conditions"]["machine_time_min"].as_f64().unwrap();
        assert!((took - minutes).abs() < 0.01, "{step}: {took}");
    }
}

#[test]
fn a_spoilt_program_of_a_pocket_is_found_out() {
    let folder = folder("spoilt-pocket");
    fs::write(folder.join("part.yaml"), POCKET).unwrap();
    let made = technolog(&folder, &["program", "part.yaml", "--control", "2c42-65", "-o", "right.nc"]);
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    let right = fs::read_to_string(folder.join("right.nc")).unwrap();
    for (from, to, code) in [
        // The first way round, without which a ridge stays; a corner that is cut off, and one that is cut square.
        ("N7 G91 G1 X0 Y12.56\nN8 G91 G1 X-32.56 Y0\nN9 G91 G1 X0 Y-12.56", "N7 G91 G1 X-32.56 Y0", "slot-uncut"),
        ("G91 G3 X-1 Y-1 I0 J-1 F12", "G91 G1 X-1 Y-1 F12", "slot-uncut"),
        ("G91 G3 X-1 Y-1 I0 J-1 F12", "G91 G1 X-1 Y0 F12\nG91 G1 X0 Y-1", "slot-gouged"),
        ("G91 G1 X-44.12 Y0 F63", "G91 G1 X-45.12 Y0 F63", "slot-gouged"),
    ] {
        assert!(right.contains(from), "{from}: {right}");
        fs::write(folder.join("p.nc"), right.replacen(from, to, 1)).unwrap();
        let found =
            technolog(&folder, &["check", "p.nc", "--control", "2c42-65", "--part", "part.yaml", "--lang", "en"]);
        let said = text(&found.stdout) + &text(&found.stderr);
        assert!(found.status.code() == Some(1) && said.contains(code), "{to}: {said}");
    }
}

/// What a plan states of its slots and pockets agrees with what is reckoned anew.
#[test]
fn a_plan_of_slots_and_pockets_of_our_own_has_no_mistake() {
    let folder = folder("own");
    for part in [SLOTS, POCKETS, OPEN] {
        fs::write(folder.join("part.yaml"), part).unwrap();
        let made = technolog(&folder, &["plan", "part.yaml", "--format", "json", "-o", "plan.json"]);
        assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
        let audit = technolog(&folder, &["audit", "plan.json", "--lang", "en"]);
        assert_eq!(audit.status.code(), Some(0), "{}", text(&audit.stdout));
    }
}

#[test]
fn a_spoilt_program_of_a_slot_is_found_out() {
    let folder = folder("spoilt");
    fs::write(folder.join("part.yaml"), ONE).unwrap();
    let made = technolog(&folder, &["program", "part.yaml", "--control", "2c42-65", "-o", "right.nc"]);
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    let right = fs::read_to_string(folder.join("right.nc")).unwrap();
    for (from, to, code) in [
        // Not to the end, and beyond it.
        ("G91 G1 X40 Y0 F48", "G91 G1 X39 Y0 F48", "slot-uncut"),
        ("G91 G1 X40 Y0 F48", "G91 G1 X41 Y0 F48", "slot-gouged"),
        // An end without its arc, and one round the wrong way.
        ("G91 G3 X0 Y-1.1 I0 J-0.55 F16", "G91 G1 X0 Y-1.1 F16", "slot-uncut"),
        ("G91 G3 X0 Y2.1 I0 J1.05 F16", "G91 G2 X0 Y2.1 I0 J1.05 F16", "slot-uncut"),
        // The quarter onto a wall round the wrong way.
        ("G91 G3 X-1.05 Y1.05 I-1.05 J0 F16", "G91 G2 X-1.05 Y1.05 I0 J1.05 F16", "circle-sense"),
        // A wall that is not finished, a level that is not deep enough.
        ("G91 G1 X40 Y0 F33", "G91 G1 X40 Y0.3 F33", "slot-"),
        ("G90 G1 Z-8 F12", "G90 G1 Z-7.5 F12", "slot-uncut"),
        ("G91 G1 X40 Y0 F48", "G91 G0 X40 Y0", "rapid-across"),
        // On the arcs as fast as along the walls: the teeth there would take too much.
        ("J-0.55 F16", "J-0.55 F48", "other-feed"),
    ] {
        assert!(right.contains(from), "{from}: {right}");
        fs::write(folder.join("p.nc"), right.replacen(from, to, 1)).unwrap();
        let found =
            technolog(&folder, &["check", "p.nc", "--control", "2c42-65", "--part", "part.yaml", "--lang", "en"]);
        let said = text(&found.stdout) + &text(&found.stderr);
        assert!(found.status.code() == Some(1) && said.contains(code), "{to}: {said}");
    }
}

/// What is not made here is said, and is no success.
#[test]
fn a_slot_that_cannot_be_made_is_a_finding() {
    let folder = folder("refused");
    for (width, words) in [
        // Finer than a mill reaches; narrower than the mills; deeper than one reaches.
        ("12H8, depth: 8", "does not reach grade 8"),
        // Grade 10 a mill reaches at best, 11 ordinarily: that is what is named instead.
        ("12H8, depth: 8", "the same hole is possible at grade 11 with Ra 6.3"),
        ("3H12, depth: 8", "mill"),
        ("5H12, depth: 14", "reach"),
    ] {
        fs::write(folder.join("part.yaml"), ONE.replace("14H12, depth: 8", width)).unwrap();
        let plan = technolog(&folder, &["plan", "part.yaml", "--lang", "en", "--all-problems"]);
        let said = text(&plan.stdout);
        assert_eq!(plan.status.code(), Some(1), "{width}: {said}");
        assert!(said.contains("impossible: slot S") && said.contains(words), "{width}: {said}");
    }
    for (from, to, words) in [
        // Corners that no slot mill makes, or none so deep; finer than a mill reaches.
        ("corner: 8", "corner: 0.5", "no end mill"),
        ("corner: 8", "corner: 2", "reach"),
        ("40H12", "40H9", "the same hole is possible at grade 11 with Ra 6.3"),
    ] {
        fs::write(folder.join("part.yaml"), POCKET.replace(from, to)).unwrap();
        let plan = technolog(&folder, &["plan", "part.yaml", "--lang", "en", "--all-problems"]);
        let said = text(&plan.stdout);
        assert_eq!(plan.status.code(), Some(1), "{to}: {said}");
        assert!(said.contains("impossible: pocket K") && said.contains(words), "{to}: {said}");
    }
}

/// Where stops stand the file does not say: a mill that goes beyond an edge may meet them.
#[test]
fn an_open_slot_is_told_to_whoever_sets_the_stops() {
    let folder = folder("open");
    fs::write(folder.join("part.yaml"), OPEN).unwrap();
    let plan = technolog(&folder, &["plan", "part.yaml", "--lang", "en"]);
    let said = text(&plan.stdout).split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(plan.status.code(), Some(0), "{said}");
    assert!(
        said.contains("doubtful: slot A: it runs out of the blank: the mill goes up to 14 mm beyond the edge"),
        "{said}"
    );
    // As drawn, from the edge: 40 mm and half of the width.
    assert!(said.contains("slot 14H12 × 47, open (A)") && said.contains("slot 20H12 × 120, open (B)"), "{said}");
    assert!(!said.contains("nothing holds"), "{said}");
}
