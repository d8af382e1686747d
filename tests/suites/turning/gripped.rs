//! Whether jaws hold a part, and whether it bears them.

use technolog::note::Severity;
use technolog::turning::contour::Side;
use technolog::turning::jobs::Work;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::operation::setting::setting;
use technolog::turning::operation::{SetUpWork, plan};
use technolog::turning::workpiece::read_turned;
use technolog_testing::KNOWLEDGE;

/// What is told of jaws, doubtful or worse.
fn told(part: &str) -> Vec<(Severity, String)> {
    let operation = plan(&read_turned("part", part, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap();
    let found = operation.findings.iter().filter(|finding| finding.severity <= Severity::Doubtful);
    let of_jaws =
        found.filter(|finding| finding.note.code().starts_with("jaws-") || finding.note.code().starts_with("grip-"));
    of_jaws.map(|finding| (finding.severity, finding.note.code().to_owned())).collect()
}

/// A sleeve of a tube: Ø63 with a bore of 56, held by it in the second set-up.
fn sleeve(jaws: &str, outside: u32) -> String {
    format!(
        "shaft: Sleeve\nmaterial: steel-45\nblank: {{kind: tube, diameter: {}, bore: 52, length: 90, face: 1}}\n\
         machine: 16k20f3\n{jaws}outer:\n  - {{from: {{d: 56, z: 0}}}}\n  - {{face: {}}}\n  - {{cylinder: -30}}\n  \
         - {{face: {outside}}}\n  - {{cylinder: -50}}\ninner:\n  - {{from: {{d: 56, z: 0}}}}\n  \
         - {{cylinder: -50, grade: H7, roughness: Ra 1.6}}\n",
        outside + 3,
        outside - 3
    )
}

/// By hand, second set-up: R = 29.75 and t = 3.5 under soft jaws of 35 mm (36°: 0.60 of the bending), 20 mm long, and 13 mm of tube on
/// a side, as far as there is one: σ = 0.3·600 = 180 MPa. Of F/3·0.189·R·0.6·6/(b·t²) + F/(2π·b·t) with b = 40: 180 = F·0.0138 +
/// F·0.0011, F = 12 kN; at b = 20, half of it. The far face pulls with 0.5 kN on μ = 0.1, which asks for 10 kN.
#[test]
fn a_thin_wall_gives_way_to_three_jaws() {
    let has = |part: &str, code: &str| told(part).iter().any(|one| one.1 == code);
    assert!(told(&sleeve("", 63)).contains(&(Severity::Wrong, "jaws-crush".to_owned())));
    // Held nearly all around it bears the same force; a thick wall bears it in three jaws.
    assert!(!has(&sleeve("jaws: full-grip\n", 63), "jaws-crush"));
    assert!(!has(&sleeve("jaws: full-grip\n", 63), "jaws-make-lobes"));
    assert!(!has(&sleeve("", 90), "jaws-crush"));
}

/// A flange of Ø180 on 7 mm of its hub of Ø60, in soft jaws at 40 kN: they hold 40000·(7 + 0.1·60)/(2·√3) = 150 N·m. A cut of 4 mm at
/// 0.5 mm/rev, some 3300 N of Pz, at 33 mm from the middle of the grip tips with 110 N·m and more; with the safety of 2 too much.
#[test]
fn a_flange_on_a_short_hub_tips() {
    let part = |roughing: &str| {
        format!(
            "shaft: Flange\nmaterial: steel-45\nblank: {{kind: bar, diameter: 190, length: 38, face: 2}}\nmachine: 16k20f3\n\
             outer:\n  - {{from: {{d: 0, z: 0}}}}\n  - {{face: 60}}\n  - {{cylinder: -10}}\n  - {{face: 180}}\n  \
             - {{cylinder: -30}}\n{roughing}"
        )
    };
    let weak = |part: String| told(&part).iter().any(|one| one.1 == "grip-tips" || one.1 == "grip-too-weak");
    assert!(weak(part("roughing: {limiting_depth: 4}\n")));
    // Left to the plan, passes are as shallow as the jaws hold.
    assert!(!weak(part("")));
}

/// A bar of 250 mm for a part of 90, by hand: 13 mm of soft jaws from 3 mm behind the face hold 40000·(13 + 0.1·40)/(2·√3) = 196 N·m.
/// Facing begins 158 mm before it: at 3.35 mm deep 1855 N act at 158 + 3 + 6.5 = 167.5 mm, 311 N·m, and across them the
/// feed there less the side force at a radius of 20 mm. With 6 mm of stock they act at 15.5 mm only.
#[test]
fn stock_before_the_face_is_part_of_the_arm() {
    let part = |length: u32| {
        format!(
            "shaft: Long bar\nmaterial: steel-45\nblank: {{kind: bar, diameter: 40, length: {length}, face: 2}}\n\
             machine: 16k20f3\nroughing: {{limiting_depth: 3.35}}\nouter:\n  - {{from: {{d: 0, z: 0}}}}\n  \
             - {{face: 24}}\n  - {{cylinder: -35}}\n  - {{face: 32}}\n  - {{cylinder: -73}}\n  - {{face: 40}}\n  \
             - {{cylinder: -90}}\n"
        )
    };
    let operation = plan(&read_turned("part", &part(250), &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap();
    let tips = operation.set_ups[1].grip.as_ref().unwrap().tips_n_m.unwrap();
    let face = operation.set_ups[1].jobs.iter().find(|job| job.work == Work::Face).unwrap();
    let cut = face.conditions.as_ref().unwrap();
    let [main, across, along] = [cut.main_force_n, cut.axial_force_n, cut.radial_force_n].map(|one| one.unwrap().0);
    let by_hand = (main * 0.1675).hypot(across * 0.1675 - along * 0.020);
    assert!(main * 0.1675 > 310.0 && (tips.0 - by_hand).abs() < 0.01 * by_hand, "{tips:?} {by_hand}");
    assert!(told(&part(250)).contains(&(Severity::Wrong, "grip-tips".to_owned())));
    assert!(!told(&part(98)).iter().any(|one| one.1 == "grip-tips"));
}

/// The head of Ø40 stays as the bar has it and needs no stock; the far face has its allowance, 0.7 mm by the table, and is finished with
/// it. It is no surface of the set-up, and no feed is told for it by name.
#[test]
fn a_head_of_the_bar_itself_is_no_work() {
    let part = "shaft: Head\nmaterial: steel-45\nblank: {kind: bar, diameter: 40, length: 84, face: 2}\nmachine: 16k20f3\n\
                outer:\n  - {from: {d: 0, z: 0}}\n  - {face: 28}\n  - {chamfer: 1}\n  \
                - {cylinder: -50, name: j, grade: h9, roughness: Ra 3.2}\n  - {face: 40}\n  - {cylinder: -80}\n";
    let operation = plan(&read_turned("part", part, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap();
    let finish = operation.set_ups[1].jobs.iter().find(|job| job.work == Work::Finish).unwrap();
    assert_eq!(finish.conditions.as_ref().unwrap().depth_mm.to_mm(), 0.7);
    assert!(finish.surfaces.is_empty() && finish.notes.iter().all(|note| !note.code().starts_with("finish-feed")));
    assert!(!operation.has_errors());
}

/// A lathe that is named and has a chuck: only that nothing is long enough for its jaws is told, and no lathe is asked for.
#[test]
fn a_named_lathe_is_not_asked_for() {
    let part = |machine: &str| {
        format!(
            "shaft: Stub\nmaterial: steel-45\nblank: {{kind: bar, diameter: 40, length: 13, face: 1}}\n{machine}outer:\n  \
             - {{from: {{d: 0, z: 0}}}}\n  - {{face: 30}}\n  - {{cylinder: -6}}\n  - {{face: 36}}\n  - {{cylinder: -12}}\n"
        )
    };
    let has = |machine: &str, code: &str| told(&part(machine)).iter().any(|one| one.1 == code);
    assert!(has("machine: 16k20f3\n", "jaws-not-proven-none"));
    assert!(!has("machine: 16k20f3\n", "jaws-not-proven"));
}

/// A ring that roughing would spring out of round: before its bore is finished the program stops, after all roughing, and the sheet has
/// the stop, too.
#[test]
fn a_program_stops_where_the_jaws_are_loosened() {
    let part = RING;
    assert!(told(part).iter().any(|one| one.1 == "jaws-loosen"));
    let operation = plan(&read_turned("part", part, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap();
    let stopped = |one: &&SetUpWork| one.grip.as_ref().is_some_and(|grip| !grip.regrips(&one.jobs).is_empty());
    let set_up = operation.set_ups.iter().find(stopped).unwrap();
    let number = set_up.set_up.number;
    let programs = programs(&operation, "fanuc", Form::Motions, None, &KNOWLEDGE).unwrap();
    let text = &programs.iter().find(|one| one.set_up == number).unwrap().files.as_ref().unwrap()[0].text;
    let lines: Vec<&str> = text.lines().collect();
    let stop = lines.iter().position(|line| line.split(' ').any(|word| word == "M0" || word == "M00")).unwrap();
    assert!(lines[stop - 1].to_lowercase().contains("kn"), "{}", lines[stop - 1]);
    let bar = &set_up.jobs.iter().find(|job| job.side == Side::Inner && job.work == Work::Finish).unwrap().tool;
    assert!(lines[stop + 1].to_lowercase().contains(&bar.designation.to_lowercase()), "{}", lines[stop + 1]);
    assert!(lines[stop..].iter().all(|line| !line.to_lowercase().contains("rough")));
    let sheet = setting(&operation, "fanuc", &KNOWLEDGE).unwrap();
    let notes = &sheet.set_ups.iter().find(|one| one.set_up == number).unwrap().notes;
    assert!(notes.iter().any(|note| note.code() == "jaws-stop"));
}

/// By hand: a blade of 4 mm at 0.18 mm/rev in steel presses with 10·408·4^0.72·0.18^0.8 = 2808 N (×0.99 for 735 MPa) at Ø120, where
/// the jaws grip, too: 2·2808/0.35 = 16 kN. The jaws that the bore is finished in hold far less and are tightened before the blade.
#[test]
fn jaws_loosened_for_a_bore_hold_the_blade_that_parts_it() {
    let part = PARTED;
    let operation = plan(&read_turned("part", part, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap();
    let set_up = &operation.set_ups[0];
    let (grip, parts) = (set_up.grip.as_ref().unwrap(), &set_up.jobs[set_up.jobs.len() - 1]);
    assert_eq!(parts.work, Work::PartOff);
    let needs = grip.required_by(parts).unwrap().0;
    assert!((15_500.0..16_500.0).contains(&needs), "{needs}");
    let last = grip.regrips(&set_up.jobs).pop().unwrap();
    assert!(last.force.0 >= needs - 1.0 && !last.loosens && last.before == set_up.jobs.len() - 1, "{last:?}");
}

/// By hand: 33 mm of Ø40 at 40 kN hold 40000·(33 + 0.35·40)/(2·√3) = 543 N·m, half of it with the safety: 271 N·m less what the speed
/// takes. A groove whose far corner is 92 mm from the face and a blade of 5 mm, 10·408·5^0.72·0.15^0.8 = 2850 N and its Py of some
/// 1500 N at 20 mm and more before the jaws: the moment is told, not left at that of turning.
#[test]
fn a_blade_far_out_tips_the_part() {
    let part = |width: &str| {
        format!(
            "shaft: Neck\nmaterial: steel-45\nblank: {{kind: bar, diameter: 40, length: 150, face: 2}}\nmachine: 16k20f3\nouter:\n  \
             - {{from: {{d: 0, z: 0}}}}\n  - {{face: 36}}\n  - {{cylinder: -20}}\n{width}  - {{cylinder: -110}}\n"
        )
    };
    let tips = |text: &str| {
        let operation = plan(&read_turned("part", text, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap();
        operation.set_ups[0].grip.as_ref().unwrap().tips_n_m.unwrap().0
    };
    let [plain, grooved] =
        ["", "  - {groove: pulley, width: 12, depth: 6, angle: 38, radius: 1}\n"].map(|one| tips(&part(one)));
    // At 20 to 32 mm from the face the blade is 92 mm and more before the middle of 33 mm of jaws: 3.2 kN · 0.09 m = 290 N·m.
    assert!(grooved > plain && (200.0..330.0).contains(&grooved), "{plain} {grooved}");
}

/// The inequality that is told holds between the figures as they are told: what the speed takes off the jaws is taken off what they hold.
#[test]
fn what_tips_is_more_than_what_the_speed_leaves() {
    let part = "shaft: Stub\nmaterial: steel-45\nblank: {kind: bar, diameter: 50, length: 130, face: 2}\nmachine: 16a20f3\nouter:\n  - \
                {from: {d: 0, z: 0}}\n  - {face: 20}\n  - {chamfer: 2}\n  - {thread: M24x3-6g, to: -30}\n  - {groove: thread-relief}\n  \
                - {face: 30}\n  - {chamfer: 1}\n  - {cylinder: -60, name: seat, grade: h7, roughness: Ra 1.6}\n  - {face: 46}\n  - \
                {chamfer: 1}\n  - {cylinder: -80}\n";
    let operation = plan(&read_turned("part", part, &KNOWLEDGE).unwrap(), &KNOWLEDGE).unwrap();
    let tips: Vec<_> = operation.findings.iter().filter(|one| one.note.code() == "grip-tips").collect();
    let figure = |finding: &&technolog::note::Finding, name: &str| -> f64 {
        finding.note.figure_text(name).unwrap().parse().unwrap()
    };
    assert!(!tips.is_empty());
    for one in tips {
        let [moment, safety, holds] = ["moment", "safety", "holds"].map(|name| figure(&one, name));
        assert!(moment * safety > holds, "{moment} · {safety} > {holds}");
    }
}

const PARTED: &str = "shaft: Ring\nmaterial: steel-40x\nblank: {kind: tube, diameter: 120, bore: 90, length: 60, face: 1.5}\nmachine: 16k20f3\nouter:\n  - {from: {d: 96, z: 0}}\n  - {face: 116}\n  - {chamfer: 1}\n  - {cylinder: -20, name: od, grade: h7, roughness: Ra 1.6}\ninner:\n  - {from: {d: 96, z: 0}}\n  - {chamfer: 1}\n  - {cylinder: -20, name: id, grade: H7, roughness: Ra 1.6}\n";

const RING: &str = "# thin-walled ring, bronze-less: aluminium, full grip\nshaft: Thin ring\nmaterial: aluminium-d16\nblank: {kind: tube, diameter: 105, bore: 85, length: 60, face: 2}\nmachine: 16k20f3\nouter:\n  - {from: {d: 94, z: 0}}\n  - {face: 100}\n  - {chamfer: 0.5}\n  - {cylinder: -25, name: seat, grade: h7, roughness: Ra 1.6}\ninner:\n  - {from: {d: 94, z: 0}}\n  - {chamfer: 0.5}\n  - {cylinder: -25, name: bore, grade: H7, roughness: Ra 1.6}\n";
