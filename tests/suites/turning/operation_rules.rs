//! What a technologist decides about a turning operation stands in `rules/`: a row that is changed changes the operation,
//! and the operation says on which row it rests.

use technolog::knowledge::Knowledge;
use technolog::shipped;
use technolog::turning::operation::work::ZoneWork;
use technolog::turning::operation::{Operation, plan};
use technolog::turning::workpiece::read_turned;
use technolog_testing::changed_knowledge;

/// The shipped knowledge with one text of a rule put instead of another.
fn with(rule: &str, old: &str, new: &str) -> Knowledge {
    changed_knowledge(&format!("rules/{rule}.yaml"), old, new)
}

fn shipped_knowledge() -> Knowledge {
    shipped::knowledge().unwrap()
}

/// A shaft with a bore into solid metal, on a lathe: the rough bore is Ø24 less 1.
fn planned(kind: &str, knowledge: &Knowledge) -> Operation {
    let text = format!(
        "shaft: S\nmaterial: steel-45\nmachine: 16k20f3\nblank: {{kind: {kind}, diameter: 60, length: 62, face: 1}}\n\
         outer: [{{from: {{d: 24, z: 0}}}}, {{face: 40}}, {{cylinder: -30}}, {{face: 56}}, {{cylinder: -60}}]\n\
         inner: [{{from: {{d: 24, z: 0}}}}, {{cylinder: -60}}]\n\
         allowances: {{method: stated, on_diameter: 1, on_face: 0.5}}\n"
    );
    plan(&read_turned("part", &text, knowledge).unwrap(), knowledge).unwrap()
}

/// The first outer zone along the axis.
fn zone(operation: &Operation) -> &ZoneWork {
    operation.zones().map(|(_, _, zone)| zone).find(|zone| !zone.zone.parts.is_empty()).unwrap()
}

/// The speed at which the tool lasts is proportional to Kpv: 0.9 through rolled skin, 0.8 through that of a forging.
#[test]
fn the_skin_of_the_blank_is_a_row() {
    let speed = |operation: &Operation| {
        let conditions = zone(operation).works[0].pace.conditions.clone().unwrap();
        let row = conditions.because.iter().find(|because| because.table == "turning-skin").unwrap();
        (conditions.computed_speed_m_per_min.0, row.note.figure_text("surface").unwrap())
    };
    let (rolled, surface) = speed(&planned("bar", &shipped_knowledge()));
    assert_eq!(surface, "rolled");
    let other = with("turning-skin", "surface: rolled, source", "surface: forged, source");
    let (forged, surface) = speed(&planned("bar", &other));
    assert_eq!(surface, "forged");
    // Speeds are rounded to 0.01 m/min.
    assert!((forged / rolled - 0.8 / 0.9).abs() < 2e-4, "{forged} {rolled}");
    let limit = planned("bar", &other);
    let limit = zone(&limit).depth.as_ref().unwrap().limit.as_ref().unwrap();
    assert!(limit.because.iter().any(|because| because.table == "turning-skin"));
}

/// By hand: the rough bore is Ø23; 1 mm on the side leaves Ø21, 1.5 mm leaves Ø20, and in steps of 3 mm Ø18.
#[test]
fn the_drill_before_boring_is_a_row() {
    let drilled = |knowledge: &Knowledge| {
        let operation = planned("bar", knowledge);
        let sides = operation.set_ups.iter().flat_map(|set_up| &set_up.sides);
        let drilled = sides.filter_map(|side| side.layers.drilled_first.as_ref()).next().unwrap();
        assert_eq!((drilled.because.table.as_str(), drilled.because.row), ("bore-drill", Some(2)));
        drilled.diameter_mm.to_string()
    };
    assert_eq!(drilled(&shipped_knowledge()), "21");
    assert_eq!(drilled(&with("bore-drill", "least_stock: 1, stock_for_bar", "least_stock: 1.5, stock_for_bar")), "20");
    assert_eq!(drilled(&with("bore-drill", "stock_for_bar: 0.5, step: 1", "stock_for_bar: 0.5, step: 6")), "18");
    let none = planned("bar", &with("bore-drill", "drilled: true", "drilled: false"));
    assert!(none.findings.iter().any(|finding| finding.note.code() == "bore-too-narrow-to-drill"));
}

/// The first of the tools that fit is that of the least φ1, and of these the one with the thickest shank.
#[test]
fn the_order_of_tools_is_a_row() {
    let knowledge = shipped_knowledge();
    let operation = planned("bar", &knowledge);
    let tool = zone(&operation).tool.clone().unwrap();
    assert_eq!((tool.designation.as_str(), tool.secondary_angle_deg.0), ("PCLNR 2525M12", 5.0));
    assert_eq!(tool.because_order.table, "turning-tool-order");
    // No turning tool has a blade: of those with φ1 = 5° the earlier row is first, whose shank is of 20.
    let other = with("turning-tool-order", "least-trail-angle, largest-shank]", "least-trail-angle, widest-blade]");
    assert_eq!(zone(&planned("bar", &other)).tool.clone().unwrap().designation, "PCLNR 2020K12");
}
