//! Laws of reading a part file with every key of a hole, tried on random ones.
//!
//! - A valid file is read, and its holes keep the order and the sizes that the format promises.
//! - A spoilt file is read or refused with places inside it; nothing makes the reader panic.

#![allow(clippy::unwrap_used, clippy::panic, reason = "clippy allows it in tests, but not in the functions they share")]

use std::sync::LazyLock;

use proptest::prelude::*;
use technolog::knowledge::Knowledge;
use technolog::part::{Face, Part, read_part};
use technolog::shipped;
use technolog::units::Micrometres;

static KNOWLEDGE: LazyLock<Knowledge> = LazyLock::new(|| shipped::knowledge().unwrap());

const THICKNESS: i64 = 40;

/// The keys of a hole that say its diameter and depth.
fn body() -> impl Strategy<Value = String> {
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
fn steps() -> impl Strategy<Value = String> {
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
fn centres(number: usize) -> impl Strategy<Value = String> {
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

fn part_files() -> impl Strategy<Value = String> {
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

fn lawful(part: &Part) -> Result<(), TestCaseError> {
    for hole in &part.holes {
        prop_assert!(!hole.at.is_empty() && hole.diameter.lower < hole.diameter.upper);
        prop_assert_eq!(hole.through, hole.depth == part.blank.thickness);
        let faces: Vec<Face> = hole.steps.iter().map(|step| step.face).collect();
        prop_assert!(faces.is_sorted(), "those of the back come last");
        for step in &hole.steps {
            prop_assert!(step.diameter.nominal > hole.diameter.nominal);
            prop_assert!(step.depth > Micrometres::ZERO && step.depth < hole.depth);
        }
        // Towards the main cylinder steps narrow and go deeper, from either face.
        for pair in hole.steps.windows(2).filter(|pair| pair[0].face == pair[1].face) {
            let (outer, inner) = if pair[0].face == Face::Entry { (&pair[0], &pair[1]) } else { (&pair[1], &pair[0]) };
            prop_assert!(outer.diameter.nominal > inner.diameter.nominal && outer.depth < inner.depth);
        }
        if let Some(diameter) = hole.state.diameter() {
            prop_assert!(diameter < hole.diameter.smallest());
        }
    }
    Ok(())
}

/// Something to put into a part file where it does not belong.
fn litter() -> impl Strategy<Value = String> {
    let known = vec![
        "",
        "-",
        "-1",
        "0",
        "1e9",
        "99999999999",
        "9223372036854",
        ".5",
        ",",
        ": ",
        "\n",
        "[",
        "]",
        "{",
        "}",
        "null",
        "true",
        "Ø",
        "М",
        "х",
        "К1/2\"",
        "steps: ",
        "depth: 5",
        "length: 5",
        "thread: M8",
        "step: 0.001",
        "count: 9999",
        "state: cast",
        "angle: 180",
        "taper: 99999",
        "[1, 2]",
        "steps: []\n",
    ];
    prop_oneof![4 => prop::sample::select(known).prop_map(str::to_owned), 1 => any::<char>().prop_map(String::from)]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, ..ProptestConfig::default() })]

    #[test]
    fn every_key_of_a_hole_is_read(text in part_files()) {
        let part = read_part("part.yaml", &text, &KNOWLEDGE)
            .map_err(|problems| TestCaseError::fail(format!("{problems:#?}\n{text}")))?;
        lawful(&part).map_err(|error| TestCaseError::fail(format!("{error}\n{text}")))?;
        let again: Part = serde_json::from_str(&serde_json::to_string(&part).unwrap()).unwrap();
        prop_assert_eq!(again, part);
    }

    #[test]
    fn a_spoilt_file_is_read_or_refused_with_places_inside_it(
        text in part_files(),
        spoils in prop::collection::vec((any::<prop::sample::Index>(), 0_usize..6, litter()), 1..4),
    ) {
        let mut characters: Vec<char> = text.chars().collect();
        for (index, cut, litter) in spoils {
            let at = index.index(characters.len() + 1);
            let end = (at + cut).min(characters.len());
            characters.splice(at..end, litter.chars());
        }
        let text: String = characters.into_iter().collect();
        let lines = text.split(['\n', '\r']).count();
        match read_part("part.yaml", &text, &KNOWLEDGE) {
            Ok(part) => lawful(&part).map_err(|error| TestCaseError::fail(format!("{error}\n{text}")))?,
            Err(problems) => {
                prop_assert!(!problems.is_empty());
                for problem in problems {
                    let line = problem.place.as_ref().map_or(0, |place| place.line as usize);
                    prop_assert!(line >= 1 && line <= lines + 1, "{problem:?}\n{text}");
                }
            }
        }
    }
}
