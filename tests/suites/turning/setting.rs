//! The setting of a lathe: its tool list, and the tool table that LinuxCNC reads.

use std::process::Command;

use technolog::program::lathe::{LatheAct, LatheFeed, LatheLanguage, LatheSpeed, Subprogram, read};
use technolog::turning::jobs::Work;
use technolog::turning::operation::programs::{Form, programs};
use technolog::turning::operation::setting::{SetTool, setting};
use technolog::turning::operation::times::times;
use technolog::turning::operation::tool_table::tool_table;
use technolog::turning::tooling::Lathe;
use technolog::turning::workpiece::{ThreadLimits, read_turned};
use technolog::words::{Lang, say};
use technolog_testing::KNOWLEDGE;

use crate::operation::{example, planned};

fn table_of(name: &str) -> String {
    let setting = setting(&planned(&example(name)), "linuxcnc", &KNOWLEDGE).unwrap();
    tool_table(&setting, "Втулка", |work| work.name().to_owned())
}

/// By hand from the catalog: noses of 0.8 and of a blade 0.4 mm, as diameters; a right-hand tool outside is 2 for LinuxCNC
/// (its glcanon.py), a boring bar 3. 80° lie between the edges of a C insert, from 5° on.
#[test]
fn a_tool_table_has_a_line_for_each_place_of_the_turret() {
    let table = table_of("turned-bushing");
    let lines: Vec<&str> = table.lines().filter(|line| !line.starts_with(';')).collect();
    assert_eq!(lines.len(), 5, "{table}");
    assert_eq!(lines[0], "T1 P1 X+0.000 Z+0.000 D+1.600 I+85.000 J+5.000 Q2 ;PCLNR 2525M12, FACE, ROUGH");
    assert_eq!(lines[1], "T2 P2 X+0.000 Z+0.000 D+1.600 I+275.000 J+355.000 Q3 ;S32U-PCLNR12, ROUGH");
    assert_eq!(lines[4], "T5 P5 X+0.000 Z+0.000 D+0.800 Q2 ;MGEHR 2525-4, GROOVE");
    assert!(table.is_ascii() && table.starts_with(';') && table.ends_with('\n'));
}

/// Head and remarks are of one language: Ukrainian goes into Latin letters, nothing of it is English.
#[test]
fn a_tool_table_is_of_one_language() {
    let setting = setting(&planned(&example("turned-bushing")), "linuxcnc", &KNOWLEDGE).unwrap();
    let named = |work: Work| Lang::UK.term("turn-does", work.name()).to_owned();
    let table = tool_table(&setting, &say!(Lang::UK, "turn-tool-table-head", part = "Втулка"), named);
    assert!(table.is_ascii() && table.contains(";PCLNR 2525M12, PIDRIZATY TORETS, TOCHYTY NACHORNO\n"), "{table}");
    assert!(["TOUCH", "FACE", "ROUGH", "GROOVE", "UNTIL"].iter().all(|word| !table.contains(word)), "{table}");
}

/// By hand, M30x2-6g: d2 28.493 to 28.663 (ISO 965-2), crests 29.682 to 29.962; the best wire 2/√3 = 1.155; over three of them
/// 28.493 + 3·1.155 − 0.866·2 = 30.226, and 30.396.
#[test]
fn a_thread_is_told_with_what_the_operator_measures() {
    let setting = setting(&planned(&example("turned-stepped")), "fanuc", &KNOWLEDGE).unwrap();
    let [thread] = setting.threads.as_slice() else { panic!("{:?}", setting.threads) };
    let limits = |limits: &Option<ThreadLimits>| limits.as_ref().map(|one| (one.least.to_mm(), one.most.to_mm()));
    assert_eq!(thread.thread, "M30x2-6g");
    assert_eq!(limits(&thread.pitch_diameter), Some((28.493, 28.663)));
    assert_eq!(limits(&thread.crests), Some((29.682, 29.962)));
    assert_eq!(thread.wire_mm.map(|wire| wire.to_mm()), Some(1.155));
    assert_eq!(limits(&thread.over_wires), Some((30.226, 30.396)));
}

/// By hand: a centre drill with a pilot of 8 and 10.1 mm of it (ГОСТ 14034) opens the cone of its row, 17 mm.
#[test]
fn a_spot_has_a_cutting_speed() {
    let operation = planned(&example("turned-sleeve"));
    let set_up = &operation.set_ups[0];
    let spot = set_up.jobs.iter().find(|job| job.work == Work::Centre).unwrap();
    let opened = spot.spot_diameter(set_up.rough_face()).unwrap().to_mm();
    assert!((opened - 17.0).abs() < 0.05, "{opened}");
}

/// A drill has no nose, and points along the axis.
#[test]
fn a_drill_is_set_on_the_axis() {
    let setting = setting(&planned(&example("turned-sleeve")), "linuxcnc", &KNOWLEDGE).unwrap();
    let drills = setting.tools.iter().filter(|tool| tool.station.tool.tip().is_none());
    let of: Vec<_> = drills.map(|tool| (tool.orientation, tool.x.code(), tool.z.code())).collect();
    assert!(!of.is_empty());
    assert!(of.iter().all(|one| *one == (Some(7), "set-x-axis", "set-z-point")), "{of:?}");
}

/// The programmed point of a core drill, a reamer and a flat drill lies in its front; they have no point to touch a face with.
#[test]
fn a_reamer_touches_a_face_with_its_front() {
    let everyday = |name: &str| {
        let path = format!("{}/tests/everyday/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
        read_turned(&path, &std::fs::read_to_string(&path).unwrap(), &KNOWLEDGE).unwrap()
    };
    for (name, work) in [("reamed", Work::CoreDrill), ("reamed", Work::Ream), ("pot", Work::Flatten)] {
        let sheet = setting(&planned(&everyday(name)), "linuxcnc", &KNOWLEDGE).unwrap();
        let of_work = |tool: &&SetTool| tool.works.contains(&work);
        let tool = sheet.tools.iter().find(of_work).unwrap_or_else(|| panic!("{name}: {:?}", sheet.tools));
        assert_eq!((tool.x.code(), tool.z.code()), ("set-x-axis", "set-z-front"), "{name}");
    }
}

/// LinuxCNC's own interpreter loads the table: nose diameter, tip and edges of each tool come out as they were written.
/// Where it is not installed there is nothing to compare with.
#[test]
fn the_interpreter_of_linuxcnc_reads_the_table() {
    let folder = std::env::temp_dir().join(format!("technolog-tool-table-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let table = table_of("turned-bushing");
    std::fs::write(folder.join("tool.tbl"), &table).unwrap();
    let calls = |place: u32| format!("T{place} M6 G43\n(debug,D#5410 I#5411 J#5412 Q#5413)\n");
    let program: String = (1..=5).map(calls).collect();
    std::fs::write(folder.join("program.ngc"), format!("G18 G21 G7\n{program}M2\n")).unwrap();
    let run = Command::new("rs274").args(["-g", "-t", "tool.tbl", "program.ngc"]).current_dir(&folder).output();
    std::fs::remove_dir_all(&folder).unwrap();
    let Ok(run) = run else { return };
    let answer = String::from_utf8_lossy(&run.stdout).into_owned();
    let messages: Vec<&str> =
        answer.lines().filter_map(|line| line.split_once("MESSAGE(\"")).map(|(_, message)| message).collect();
    assert_eq!(messages.len(), 5, "{answer}");
    assert_eq!(messages[0], "D1.600000 I85.000000 J5.000000 Q2.000000\")");
    assert_eq!(messages[1], "D1.600000 I275.000000 J355.000000 Q3.000000\")");
    assert_eq!(messages[4], "D0.800000 I0.000000 J0.000000 Q2.000000\")");
}

/// The motions of a program as its control reads them, timed by itself: way over feed and spindle speed, rapids straight at
/// the rate of the lathe's record, from wherever the place of the tool is known.
fn timed(text: &str, rapid: f64) -> (f64, f64) {
    let language = LatheLanguage::read("linuxcnc-lathe", &KNOWLEDGE).unwrap();
    let run = read(text, &language, &[] as &[Subprogram<'_>]);
    let (mut cutting, mut rapids) = (0.0, 0.0);
    for motion in &run.motions {
        let Some((from, to)) = motion.from.point().zip(motion.to.point()) else { continue };
        let (across, along) = (to.radius_mm - from.radius_mm, to.z_mm - from.z_mm);
        let straight = across.hypot(along);
        let (length, feed) = match motion.act {
            LatheAct::Rapid => {
                rapids += straight / rapid;
                continue;
            }
            LatheAct::Feed { feed } => (straight, feed),
            LatheAct::Arc { feed, centre, .. } => {
                let radius = (from.radius_mm - centre.radius_mm).hypot(from.z_mm - centre.z_mm);
                (2.0 * radius * (straight / 2.0 / radius).asin(), feed)
            }
            LatheAct::Thread { lead, .. } => (straight, LatheFeed::PerRevolution(lead)),
            _ => continue,
        };
        let Some(LatheSpeed::Spindle(rpm)) = motion.modes.speed else { panic!("{motion:?}") };
        cutting += match feed {
            LatheFeed::PerRevolution(feed) => length / (feed.0 * rpm.0),
            LatheFeed::PerMinute(feed) => length / feed.0,
        };
    }
    (cutting, rapids)
}

/// The page's times are those of its programs, read back. The lathe has steps of speed, so nothing is at G96.
#[test]
fn times_are_those_of_the_program() {
    for name in ["turned-stepped", "turned-bushing", "turned-sleeve"] {
        let operation = planned(&example(name));
        let rapid = Lathe::find(&KNOWLEDGE, operation.workpiece.machine.as_deref().unwrap()).unwrap().rapid_z.0;
        let times = times(&operation, &KNOWLEDGE).unwrap();
        let programs = programs(&operation, "linuxcnc", Form::Motions, None, &KNOWLEDGE).unwrap();
        for (times, program) in times.iter().zip(&programs) {
            let Ok(files) = &program.files else { continue };
            let (cutting, rapids) = timed(&files[0].text, rapid);
            assert!((times.cutting_min.0 - cutting).abs() < 0.005, "{name}: {} {cutting}", times.cutting_min.0);
            assert!((times.rapid_min.0 - rapids).abs() < 0.005, "{name}: {} {rapids}", times.rapid_min.0);
            let calls = files[0].text.lines().filter(|line| line.contains(" M6")).count();
            assert_eq!(times.tool_changes, calls, "{name}");
            // 4 s, 2 s and half a minute of `chuck-and-tailstock`: the record of the lathe has no time of its own.
            let around = times.tool_change_min.0 + times.spindle_start_min.0 + times.load_min.0;
            assert!((around - (calls as f64 * 0.1 + 0.5)).abs() < 1e-9, "{name}: {around}");
        }
    }
}
