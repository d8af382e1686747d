//! Slots: their programs on every control, the time of their passes by hand, and what the proof says of spoilt ones.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const CONTROLS: [&str; 6] = ["2c42-65", "linuxcnc", "fanuc", "haas-ngc", "mach3", "grbl"];

/// Along an axis and across both, blind and through, narrow and wide, with and without a finishing way round.
const SLOTS: &str = "part: P
material: steel-45
blank: {kind: plate, length: 240, width: 120, thickness: 16}
machine: gf2171
fixture: {height: 60}
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
    fs::write(folder.join("part.yaml"), SLOTS).unwrap();
    for control in CONTROLS {
        // The program is read back and proven before it is shown.
        let made = technolog(&folder, &["program", "part.yaml", "--control", control, "--lang", "en", "-o", "p.nc"]);
        assert_eq!(made.status.code(), Some(0), "{control}: {}", text(&made.stderr));
        let found = technolog(&folder, &["check", "p.nc", "--control", control, "--part", "part.yaml", "--lang", "en"]);
        let said = text(&found.stdout) + &text(&found.stderr);
        assert!(found.status.code() == Some(0) && !said.contains("slot-"), "{control}: {said}");
    }
}

/// Mill Ø12, 2 teeth. Roughing to 13.09: 2 levels of 4 mm, each once along the middle and once round, r = (13.09 - 12)/2 = 0.545;
/// 2·(40 + 2·40 + 2·0.545) = 242.18 mm at 48 mm/min, 2·2·π·0.545 = 6.85 mm of arcs at 48·0.545/6.545 = 3 whole mm/min, 11 mm down
/// at a quarter of 48: 5.05 + 2.28 + 0.92 = 8.25 min. Finishing to 14.09: one level, r = 1.045, 0.7 of the feed for Ra 6.3,
/// 2·40 + 2·1.045 + 11 = 93.09 mm at 33.6, 6.57 mm of arcs at 33.6·1.045/7.045 = 4: 2.77 + 1.64 = 4.41 min.
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
    for (step, minutes) in [(0, 8.245), (1, 4.413)] {
        let took = figure(step, "machine_time_min");
        assert!((took - minutes).abs() < 0.01, "{step}: {took}");
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
        ("G91 G3 X0 Y-1.1 I0 J-0.55 F3", "G91 G1 X0 Y-1.1 F3", "slot-uncut"),
        ("G91 G3 X0 Y2.1 I0 J1.05 F4", "G91 G2 X0 Y2.1 I0 J1.05 F4", "slot-uncut"),
        // A wall that is not finished, a level that is not deep enough.
        ("G91 G1 X0 Y-1.05", "G91 G1 X0 Y-0.75", "slot-"),
        ("G90 G1 Z-8 F12", "G90 G1 Z-7.5 F12", "slot-uncut"),
        ("G91 G1 X40 Y0 F48", "G91 G0 X40 Y0", "rapid-across"),
        // On the arcs as fast as along the walls: the teeth there would take too much.
        ("J-0.55 F3", "J-0.55 F30", "other-feed"),
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
        ("12H8", "does not reach grade 8"),
        ("3H12", "mill"),
        ("5H12", "reach"),
    ] {
        fs::write(folder.join("part.yaml"), ONE.replace("14H12", width)).unwrap();
        let plan = technolog(&folder, &["plan", "part.yaml", "--lang", "en", "--all-problems"]);
        let said = text(&plan.stdout);
        assert_eq!(plan.status.code(), Some(1), "{width}: {said}");
        assert!(said.contains("impossible: slot S") && said.contains(words), "{width}: {said}");
    }
}
