//! Random part files with every key of a hole.

use proptest::prelude::*;

const THICKNESS: i64 = 40;

/// The keys of a hole that say its diameter and depth.
pub fn body() -> impl Strategy<Value = String> {
    let plain = (4_i64..=20, 15_i64..=39, 6_u8..=14).prop_map(|(size, depth, grade)| {
        format!("diameter: {size}H{grade}, depth: {depth}, roughness: Ra 6.3, countersink: {{diameter: {}}}", size + 4)
    });
    let threads = vec!["M3", "M8-6H", "М10х1-6Н", "M20x1.5", "M30-7H"];
    let threaded = (prop::sample::select(threads), 15_i64..=39)
        .prop_map(|(thread, depth)| format!("thread: {thread}, depth: {depth}, chamfer: 1"));
    let extras = prop::sample::select(vec![
        "counterbore: {diameter: 25, depth: 9}",
        "cone: {diameter: 20.4, taper: 0.02}",
        "cone: {diameter: 22, angle: 60}",
        "face: {diameter: 30}",
        "groove: {diameter: 21, width: 3, depth: 10}",
        "state: cast, state_diameter: 12, outer_wall: true",
        "state: pre-machined, state_diameter: 18.5",
    ])
    .prop_map(|extra| format!("diameter: 20H9, through: true, roughness: Rz 20, {extra}"));
    prop_oneof![plain, threaded, extras, steps()]
}

/// A through hole that narrows from both faces.
pub fn steps() -> impl Strategy<Value = String> {
    let part = || prop::collection::vec((1_i64..=4, 1_i64..=5, any::<bool>()), 0..=3);
    (part(), part(), 4_i64..=10).prop_map(|(front, back, narrow)| {
        let (mut items, mut wide, mut end) = (Vec::new(), narrow + front.iter().map(|(by, ..)| by).sum::<i64>(), 0);
        for (by, length, own) in front {
            end += length;
            let deep = if own { format!("length: {length}") } else { format!("depth: {end}") };
            items.push(format!("{{diameter: {wide}, {deep}}}"));
            wide -= by;
        }
        let behind: i64 = back.iter().map(|(_, length, _)| length).sum();
        let count = back.len();
        end = THICKNESS - behind;
        items.push(format!("{{diameter: {narrow}, depth: {end}}}"));
        wide = narrow;
        for (index, (by, length, own)) in back.into_iter().enumerate() {
            end += length;
            wide += by;
            let deep = match (own, index + 1 == count) {
                (true, true) => String::new(),
                (true, false) => format!(", length: {length}"),
                (false, _) => format!(", depth: {end}"),
            };
            items.push(format!("{{diameter: {wide}{deep}}}"));
        }
        format!("through: true, roughness: Ra 12.5, steps: [{}]", items.join(", "))
    })
}

/// The centres of the group of that number, in a square of 200 mm of its own.
pub fn centres(number: usize) -> impl Strategy<Value = String> {
    let (x, y) = (number as i64 * 200 + 100, 100);
    prop_oneof![
        Just(format!("at: [[{x}, {y}], [{}, {y}]]", x - 60)),
        (1_u8..=2, 1_u8..=2, -180_i64..=180).prop_map(move |(columns, rows, angle)| format!(
            "pattern: {{grid: {{start: [{x}, {y}], columns: {columns}, rows: {rows}, step: [40, 35.5], angle: {angle}}}}}"
        )),
        (1_u8..=2, 0_i64..=360)
            .prop_map(move |(count, angle)| format!("pattern: {{line: {{start: [{x}, {y}], count: {count}, step: 50, angle: {angle}}}}}")),
        (2_u8..=4, -90_i64..=90).prop_map(move |(count, angle)| format!(
            "pattern: {{circle: {{centre: [{x}, {y}], diameter: 60, count: {count}, start_angle: {angle}}}}}"
        )),
    ]
}

/// A valid part file of such holes.
pub fn part_files() -> impl Strategy<Value = String> {
    let groups =
        (1_usize..=4).prop_flat_map(|count| (0..count).map(|number| (body(), centres(number))).collect::<Vec<_>>());
    groups.prop_map(|groups| {
        let mut text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\ndatum: {{x: left, y: front}}\n\
             blank: {{kind: plate, length: 1000, width: 200, thickness: {THICKNESS}}}\nholes:\n"
        );
        for (number, (body, centres)) in groups.into_iter().enumerate() {
            text.push_str(&format!("  - {{name: H{number}, centre_tolerance: 0.5, {body}, {centres}}}\n"));
        }
        text
    })
}
