//! The tables of lathes, turning tools and turning feeds, compared with what their designations, standards and geometry
//! say. Expectations stand here in the letters of ISO 5608 and ISO 1832, not in the tables.

use std::collections::BTreeSet;

use technolog::knowledge::{Input, Knowledge, Value};
use technolog::tables::lathes::{LatheQuantity, LatheRecord};
use technolog::turning::tooling::{Hand, Lathe, Place, Shank, Spindle, ToolKind, TurningTool};
use technolog::units::{Decimal, Micrometres, RevsPerMinute};
use technolog_testing::{KNOWLEDGE, number};

/// Read once: every test only looks at it.
fn knowledge() -> &'static Knowledge {
    &KNOWLEDGE
}

/// φ of a style letter (ISO 5608; the letters of Sumitomo's page: B 75, G 90, J 93, L 95, S 45; U as J from the other
/// end, V 72.5).
fn style_angle(letter: char) -> f64 {
    match letter {
        'B' => 75.0,
        'G' => 90.0,
        'J' | 'U' => 93.0,
        'L' => 95.0,
        'S' => 45.0,
        'V' => 72.5,
        other => panic!("no angle of style {other}"),
    }
}

/// A length of a tool's row that is for people only.
fn length(tool: &TurningTool<'_>, column: &str) -> Option<Micrometres> {
    match tool.row.value(column) {
        Some(Value::Length(length)) => Some(*length),
        _ => None,
    }
}

/// ε of an insert's letter (ISO 1832).
fn included_angle(letter: char) -> f64 {
    match letter {
        'C' | 'W' => 80.0,
        'D' => 55.0,
        'S' => 90.0,
        'T' => 60.0,
        'V' => 35.0,
        other => panic!("no angle of shape {other}"),
    }
}

/// Length over all of a length letter, mm (ISO 5608).
fn length_of(letter: char) -> i64 {
    match letter {
        'K' => 125,
        'M' => 150,
        'P' => 170,
        'Q' => 180,
        'R' => 200,
        'S' => 250,
        'T' => 300,
        'U' => 350,
        'V' => 400,
        other => panic!("no length of {other}"),
    }
}

fn close(a: Decimal, b: f64) -> bool {
    (a.to_f64() - b).abs() < 1e-9
}

/// The holder's letters, and the figures behind them: `PCLNR 2525M12` is P C L N R, 25, 25, M, 12.
#[test]
fn every_turning_tool_is_what_its_designation_says() {
    let knowledge = knowledge();
    let mut seen = 0;
    for tool in TurningTool::all(knowledge).unwrap() {
        let (letters, figures) = match (tool.kind, tool.designation) {
            (_, "contour-95-30" | "contour-95-30-left") => continue,
            (ToolKind::Turning, name) => name.split_once(' ').unwrap(),
            (ToolKind::Boring, name) => (&name[5..10], ""),
            _ => continue,
        };
        seen += 1;
        let letters: Vec<char> = letters.chars().collect();
        let what = tool.designation;
        assert!(close(tool.lead_angle, style_angle(letters[2])), "{what}: φ");
        assert!(close(tool.trail_angle, 180.0 - style_angle(letters[2]) - included_angle(letters[1])), "{what}: φ1");
        let hand = match letters[4] {
            'R' => Hand::R,
            'L' => Hand::L,
            _ => Hand::N,
        };
        assert_eq!(tool.hand, hand, "{what}");
        let insert: Vec<char> = tool.insert.unwrap().chars().collect();
        assert_eq!((insert[0], insert[1]), (letters[1], letters[3]), "{what}: shape and clearance of the insert");
        let nose: i64 = tool.insert.unwrap()[9..11].parse().unwrap();
        assert_eq!(tool.nose_radius.unwrap(), Micrometres::new(nose * 100), "{what}: nose");
        let edge: i64 = tool.insert.unwrap()[5..7].parse().unwrap();
        assert_eq!(tool.edge.unwrap(), Micrometres::from_mm(edge), "{what}: edge");
        assert!(what.ends_with(&format!("{edge:02}")), "{what}: edge of the seat");
        match tool.shank.unwrap() {
            Shank::Square { height, width } => {
                assert_eq!(figures[..2].parse::<i64>().unwrap(), height.micrometres() / 1000, "{what}");
                assert_eq!(figures[2..4].parse::<i64>().unwrap(), width.micrometres() / 1000, "{what}");
                assert_eq!(
                    length(&tool, "length").unwrap(),
                    Micrometres::from_mm(length_of(figures.as_bytes()[4].into())),
                    "{what}"
                );
                assert_eq!(tool.works, Place::Outer, "{what}");
            }
            Shank::Round { diameter } => {
                assert_eq!(what[1..3].parse::<i64>().unwrap(), diameter.micrometres() / 1000, "{what}");
                assert_eq!(
                    length(&tool, "length").unwrap(),
                    Micrometres::from_mm(length_of(what.as_bytes()[3].into())),
                    "{what}"
                );
                assert!(tool.min_bore.unwrap() > diameter, "{what}: the bar must enter its bore");
                assert_eq!(tool.carbide_bar, what.starts_with('E'), "{what}");
                assert_eq!(tool.works, Place::Inner, "{what}");
            }
        }
    }
    assert!(seen > 40, "only {seen} tools were looked at");
}

/// The three angles that the drawing of each tool shows, worked by hand: 180-95-80, 180-93-55, 180-93-35, 180-45-90,
/// 180-72.5-35 and for the bar with the 55 degree insert 180-93-55.
#[test]
fn angles_behind_the_tip_are_those_worked_by_hand() {
    let knowledge = knowledge();
    for (designation, phi, phi1) in [
        ("PCLNR 2525M12", 95.0, 5.0),
        ("PDJNL 2020K15", 93.0, 32.0),
        ("SVJBR 2525M16", 93.0, 52.0),
        ("PSSNR 2525M12", 45.0, 45.0),
        ("SVVBN 2525M16", 72.5, 72.5),
        ("PTGNR 2525M16", 90.0, 30.0),
        ("S25T-SDUCR11", 93.0, 32.0),
        ("contour-95-30", 95.0, 30.0),
        ("MGEHR 2525-3", 90.0, 90.0),
    ] {
        let tool = TurningTool::find(knowledge, designation).unwrap().unwrap();
        assert!(close(tool.lead_angle, phi) && close(tool.trail_angle, phi1), "{designation}");
    }
    let by_hand = TurningTool::find(knowledge, "pclnr2525m12").unwrap().unwrap();
    assert_eq!(by_hand.designation, "PCLNR 2525M12", "spaces and case do not count");
    assert!(TurningTool::find(knowledge, "PCLNR 9999Z99").unwrap().is_none());
}

/// Makers sell both hands of a tool. Blades for grooves of their own width are our choice, and only what is used stands
/// in the table.
#[test]
fn every_handed_tool_has_its_twin() {
    let knowledge = knowledge();
    let tools = TurningTool::all(knowledge).unwrap();
    for tool in tools.iter().filter(|tool| tool.hand != Hand::N && !tool.own_width) {
        let is_twin = |other: &&TurningTool<'_>| {
            let same = (other.kind, other.works, other.lead_angle, other.trail_angle, other.shank, other.edge)
                == (tool.kind, tool.works, tool.lead_angle, tool.trail_angle, tool.shank, tool.edge);
            let sizes = (
                other.width,
                other.groove_depth,
                length(other, "face_diameter_min"),
                other.min_bore,
                other.nose_radius,
            ) == (
                tool.width,
                tool.groove_depth,
                length(tool, "face_diameter_min"),
                tool.min_bore,
                tool.nose_radius,
            );
            same && sizes && other.hand != tool.hand && other.hand != Hand::N
        };
        assert!(tools.iter().any(|other| is_twin(&other)), "{} has no twin", tool.designation);
    }
    let designations: BTreeSet<&str> = tools.iter().map(|tool| tool.designation).collect();
    assert_eq!(designations.len(), tools.len(), "a designation stands twice");
}

#[test]
fn every_lathe_is_read_and_hangs_together() {
    let knowledge = knowledge();
    let ids = Lathe::ids(knowledge);
    assert!(ids.contains(&"16k20f3") && !ids.contains(&"quantities"), "{ids:?}");
    for id in ids {
        let lathe = Lathe::find(knowledge, id).unwrap();
        assert_eq!(lathe.id(), id);
        let rows: Vec<LatheRecord<'_>> = lathe.table.rows().map(Result::unwrap).collect();
        let over_bed = rows.iter().find(|row| row.name.is(LatheQuantity::DiameterOverBed)).unwrap();
        let over_bed = over_bed.value.as_ref().unwrap()[0];
        assert!(lathe.over_carriage.to_mm() < over_bed, "{id}: the carriage takes room");
        assert!(lathe.feed_z.0.0 < lathe.feed_z.1.0 && lathe.feed_x.0.0 < lathe.feed_x.1.0, "{id}: feeds");
        let (slowest, fastest) = lathe.spindle.ends();
        assert!(0.0 < slowest.0 && slowest.0 < fastest.0, "{id}: spindle");
        if let Spindle::Steps(steps) = &lathe.spindle {
            assert!(steps.windows(2).all(|pair| pair[0].0 < pair[1].0), "{id}: steps rise");
        }
        // The torque that the whole power gives at the slowest speed is above what any spindle bears, so a torque in the
        // record must be below it: 9550·N/n.
        if let Some(torque) = lathe.torque {
            assert!(torque.0 < 9550.0 * lathe.power.0 / slowest.0, "{id}: torque");
        }
    }
}

/// Two rows of preferred numbers: 12.5·1.41^k up to 800 and 125·1.41^k up to 2000, 13 + 9 speeds.
#[test]
fn the_steps_of_16k20f3_are_those_of_its_three_ranges() {
    let knowledge = knowledge();
    let Spindle::Steps(steps) = Lathe::find(knowledge, "16k20f3").unwrap().spindle else { panic!("it has steps") };
    assert_eq!(steps.len(), 22);
    for (first, last, count) in [(12.5, 200.0, 9), (50.0, 800.0, 9), (125.0, 2000.0, 9)] {
        for k in 0..count {
            let ideal = first * libm::pow(last / first, f64::from(k) / f64::from(count - 1));
            assert!(steps.iter().any(|step| (step.0 / ideal - 1.0).abs() < 0.03), "no step near {ideal}");
        }
    }
}

#[test]
fn a_spindle_takes_the_step_below() {
    let steps = Spindle::Steps([100.0, 200.0, 400.0].map(RevsPerMinute).to_vec());
    let range = Spindle::Range { min: RevsPerMinute(20.0), max: RevsPerMinute(2500.0) };
    for (wanted, step, free) in
        [(399.0, 200.0, 399.0), (400.0, 400.0, 400.0), (50.0, 100.0, 50.0), (10.0, 100.0, 20.0), (9e3, 400.0, 2500.0)]
    {
        assert_eq!(steps.at_most(RevsPerMinute(wanted)).0, step);
        assert_eq!(range.at_most(RevsPerMinute(wanted)).0, free);
    }
}

#[test]
fn a_lathe_says_what_does_not_go_in() {
    let knowledge = knowledge();
    let lathe = Lathe::find(knowledge, "16k20f3").unwrap();
    let mm = Micrometres::from_mm;
    assert!(lathe.refuses_part(mm(220), mm(1000)).is_none());
    assert_eq!(
        lathe.refuses_part(mm(221), mm(10)).unwrap().figure_text("quantity").as_deref(),
        Some("diameter-over-carriage")
    );
    assert_eq!(
        lathe.refuses_part(mm(20), mm(1001)).unwrap().figure_text("quantity").as_deref(),
        Some("length-between-centres")
    );
    let tool = |name: &str| TurningTool::find(knowledge, name).unwrap().unwrap();
    assert!(lathe.refuses_tool(&tool("PCLNR 2525M12")).is_none());
    assert_eq!(lathe.refuses_tool(&tool("PCLNR 3225P16")).unwrap().code(), "shank-too-high");
    assert!(lathe.refuses_tool(&tool("S25T-PCLNR12")).is_none(), "a bar has no height");
}

/// What a handbook of feeds must obey: a deeper cut is fed no faster, a thicker part no slower.
#[test]
fn rough_feeds_fall_with_the_depth_and_rise_with_the_diameter() {
    let knowledge = knowledge();
    let table = knowledge.table("turning-rough-feed").unwrap();
    let feed = |group: &str, diameter: i64, depth: i64| {
        let inputs = [
            ("material_group", Input::Text(group)),
            ("shank_height", Input::Length(Micrometres::from_mm(32))),
            ("diameter", Input::Length(Micrometres::from_mm(diameter))),
            ("depth", Input::Length(Micrometres::from_mm(depth))),
        ];
        table.decide(&inputs).unwrap().winner().map(|row| number(row, "feed_min"))
    };
    for group in ["steel", "grey-iron"] {
        for diameter in [20, 40, 60, 100, 400, 500, 600] {
            let feeds: Vec<f64> = [3, 5, 8, 12].iter().filter_map(|&depth| feed(group, diameter, depth)).collect();
            assert!(feeds.windows(2).all(|pair| pair[1] <= pair[0]), "{group} Ø{diameter}: {feeds:?}");
        }
        for depth in [3, 5, 8, 12] {
            let feeds: Vec<f64> =
                [20, 40, 60, 100, 400, 500, 600].iter().filter_map(|&diameter| feed(group, diameter, depth)).collect();
            assert!(feeds.windows(2).all(|pair| pair[0] <= pair[1]), "{group} t {depth}: {feeds:?}");
        }
    }
    // Two cells as the handbook's reader knows them: steel of Ø41-60 at up to 3 mm 0.5, Ø61-100 at 3 to 5 mm 0.5.
    assert_eq!((feed("steel", 60, 3), feed("steel", 100, 5)), (Some(0.5), Some(0.5)));
    assert_eq!(feed("steel", 20, 4), None, "so thin a part does not bear it");
}

/// The roughness that a round nose leaves is s²/(32·r) in theory (Ra = Rz/4, Rz = s²/8r): no feed of finishing may leave
/// more than twice what it is given for by geometry alone, and a larger nose or a coarser surface is fed no slower.
#[test]
fn finishing_feeds_leave_the_roughness_they_are_given_for() {
    let knowledge = knowledge();
    let tables = ["turning-finish-feed", "boring-finish-feed"].map(|id| knowledge.table(id).unwrap());
    let feed = |ra: &str, nose: &str| {
        let cell = [("roughness", Input::Roughness(ra.parse().unwrap())), ("nose_radius", Input::Text(nose))];
        let found = tables.iter().filter_map(|table| {
            let row = table.decide(&cell).ok()?.winner()?;
            Some(number(row, "feed"))
        });
        let found: Vec<f64> = found.collect();
        assert_eq!(found.len(), 1, "{ra}, {nose}: a cell stands in one table and not in two");
        found[0]
    };
    let noses = ["0.4", "0.8", "1.2", "1.6", "2", "2.4"];
    let surfaces = ["Ra 0.63", "Ra 1.25", "Ra 2.5", "Ra 3.2", "Ra 6.3", "Ra 12.5"];
    for nose in noses {
        let column: Vec<f64> = surfaces.iter().map(|ra| feed(ra, nose)).collect();
        assert!(column.windows(2).all(|pair| pair[0] < pair[1]), "nose {nose}: {column:?}");
        for (ra, feed) in surfaces.iter().zip(&column) {
            let radius: f64 = nose.parse().unwrap();
            let theory = 1000.0 * feed * feed / (32.0 * radius);
            let required: f64 = ra[3..].parse().unwrap();
            assert!(theory < 2.0 * required, "{ra}, nose {nose}, feed {feed}: geometry alone leaves Ra {theory:.2}");
        }
    }
    for ra in surfaces {
        let row: Vec<f64> = noses.iter().map(|nose| feed(ra, nose)).collect();
        assert!(row.windows(2).all(|pair| pair[0] < pair[1]), "{ra}: {row:?}");
    }
}
