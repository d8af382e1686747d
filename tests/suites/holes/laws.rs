//! Laws for every part, tried on random ones.
//!
//! - A part file is read, or refused with places inside it; nothing makes the reader panic.
//! - A part that can be read can be planned: every hole has a route with consistent steps, tools of the catalogs and
//!   loads within the machine's limits, or an error that gives the reason.
//! - A plan survives JSON and YAML.

use proptest::prelude::*;
use technolog::plan::{CuttingMethod, Plan};
use technolog::units::Micrometres;
use technolog_testing::lawful::lawful;
use technolog_testing::spoilt::{damaged, read_or_refused};
use technolog_testing::{KNOWLEDGE, planned, read};

// ---------------------------------------------------------------------------------------------------
// Parts.

/// A group of holes as it stands in a part file, without its points.
fn group() -> impl Strategy<Value = String> {
    let size = prop_oneof![
        (3_i64..=80).prop_map(|mm| mm * 1000),
        (6_i64..=160).prop_map(|half| half * 500),
        (30_i64..=800).prop_map(|tenth| tenth * 100),
        (3_000_i64..=80_000),
    ];
    let depth = prop_oneof![Just(None), (100_i64..=39_999).prop_map(Some), (1_i64..=39).prop_map(|mm| Some(mm * 1000))];
    let roughness = prop::sample::select(vec![
        "Ra 25", "Ra 12.5", "Rz 80", "Ra 6.3", "Rz 40", "Ra 3.2", "Rz 20", "Ra 2.5", "Ra 1.25", "Ra 0.63", "Ra 0.1",
    ]);
    let centres = prop::sample::select(vec![
        "0.01", "0.05", "0.051", "0.1", "0.3", "0.301", "0.46", "1", "10", "IT5", "IT7", "IT9", "IT12", "IT14",
    ]);
    let extras = prop::sample::select(vec!["", "", "", ", chamfer: 1", ", skin: true", ", chamfer: 2.5, skin: true"]);
    (size, 7_u8..=14, depth, roughness, centres, extras).prop_map(|(size, grade, depth, roughness, centres, extras)| {
        let depth = depth.map_or("through: true".to_owned(), |depth| format!("depth: {}", Micrometres::new(depth)));
        format!(
            "diameter: {}H{grade}, {depth}, roughness: {roughness}, centre_tolerance: {centres}{extras}",
            Micrometres::new(size)
        )
    })
}

/// A valid part file: up to five groups on a grid of 100 mm, so that even Ø80 keeps apart.
fn part_files() -> impl Strategy<Value = String> {
    let grid: Vec<(i64, i64)> = (-4..=4).flat_map(|x| (-1..=1).map(move |y| (x * 100, y * 100))).collect();
    let materials: Vec<String> = KNOWLEDGE
        .table("materials")
        .unwrap()
        .all_rows()
        .map(|row| technolog_testing::text(row, "id").to_owned())
        .collect();
    let heads = prop::sample::select(vec![
        "",
        "entry: rough\n",
        "position_tolerance: 0.04\nmass: 30\n",
        "mass: 900\nfixture: {height: 60, clamps: [{at: [-450, -180]}, {at: [450, 180], screw: M24}]}\n",
        "fixture: {clamps: [{at: [0, 190], screw: M6}]}\n",
    ]);
    let groups = prop::collection::vec((group(), 1_usize..=5), 1..=5);
    (prop::sample::select(materials), heads, groups, Just(grid).prop_shuffle()).prop_map(
        |(material, head, groups, points)| {
            let mut text = format!(
                "part: P\nmaterial: {material}\nmachine: gf2171\n{head}\
                 blank: {{kind: plate, length: 1000, width: 400, thickness: 40}}\nholes:\n"
            );
            let mut points = points.into_iter();
            for (number, (group, count)) in groups.into_iter().enumerate() {
                let at: Vec<String> = points.by_ref().take(count).map(|(x, y)| format!("[{x}, {y}]")).collect();
                text.push_str(&format!("  - {{name: H{number}, {group}, at: [{}]}}\n", at.join(", ")));
            }
            text
        },
    )
}

/// By either method it has a lawful plan, and always the same.
fn can_be_planned(text: &str) -> Result<(), TestCaseError> {
    let part = read(text);
    for method in [CuttingMethod::Formula, CuttingMethod::Card] {
        let plan = planned(&part, method);
        lawful(&part, &plan).map_err(|error| TestCaseError::fail(format!("{error}\n{text}")))?;
        prop_assert_eq!(&planned(&part, method), &plan, "the same part, another plan");
    }
    Ok(())
}

/// Of what laws once found, the holes without further features; `route_laws` has all.
#[test]
fn what_laws_found_can_be_planned() {
    let plain = ["shallowest-hole-sch20", "shallowest-hole-sch30", "size-behind-a-row"];
    let found: Vec<_> = technolog_testing::found().into_iter().filter(|(name, _)| plain.contains(&&**name)).collect();
    assert_eq!(found.len(), plain.len());
    for (name, text) in found {
        can_be_planned(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

proptest! {
    #![proptest_config(technolog_laws::cases!(24))]

    #[test]
    fn every_part_that_can_be_read_can_be_planned(text in part_files()) {
        can_be_planned(&text)?;
    }

    #[test]
    fn a_hole_ends_inside_deviations_on_one_side_of_its_nominal(
        size in 4_i64..=40, lower in 1_i64..300, width in 60_i64..400, below in any::<bool>()
    ) {
        let (upper, lower) = if below { (-lower, -lower - width) } else { (lower + width, lower) };
        let (upper, lower) = (Micrometres::new(upper), Micrometres::new(lower));
        let text = format!(
            "part: P\nmaterial: steel-45\nmachine: gf2171\n\
             blank: {{kind: plate, length: 100, width: 100, thickness: 20}}\nholes:\n  \
             - {{name: A, diameter: {{nominal: {size}, upper: {upper}, lower: {lower}}}, through: true, \
             roughness: Ra 12.5, centre_tolerance: 0.46, at: [[0, 0]]}}\n"
        );
        let part = read(&text);
        lawful(&part, &planned(&part, CuttingMethod::Formula))?;
    }

    #[test]
    fn a_plan_survives_json_and_yaml(text in part_files()) {
        let plan = planned(&read(&text), CuttingMethod::Formula);
        let json = serde_json::to_string(&plan).unwrap();
        prop_assert_eq!(&serde_json::from_str::<Plan>(&json).unwrap(), &plan);
        let yaml = serde_yaml::to_string(&plan).unwrap();
        prop_assert_eq!(&serde_yaml::from_str::<Plan>(&yaml).unwrap(), &plan);
    }
}

// ---------------------------------------------------------------------------------------------------
// Spoilt part files.

/// Something to put into a part file where it does not belong.
fn litter() -> impl Strategy<Value = String> {
    let known = vec![
        "",
        "-",
        "-1",
        "0",
        "1e9",
        "99999999999",
        ".5",
        ",",
        ":",
        ": ",
        "\n",
        "\t",
        "  ",
        "- ",
        "[",
        "]",
        "{",
        "}",
        "#",
        "'",
        "\"",
        "&a ",
        "*a",
        "!!str ",
        "---\n",
        "null",
        "true",
        "Ø",
        "Н",
        "IT",
        "mm",
        "\u{feff}",
        "\r",
        "\u{0}",
        "%",
        "|",
        ">",
        "? ",
        "at: ",
        "name: A",
        "holes: []\n",
    ];
    prop_oneof![4 => prop::sample::select(known).prop_map(str::to_owned), 1 => any::<char>().prop_map(String::from)]
}

proptest! {
    #![proptest_config(technolog_laws::cases!(512))]

    #[test]
    fn a_spoilt_part_file_is_read_or_refused_with_places_inside_it(text in damaged(part_files(), litter())) {
        if let Some(part) = read_or_refused(&text)? {
            planned(&part, CuttingMethod::Formula);
        }
    }
}
