//! Laws of reading a part file with every key of a hole, tried on random ones.
//!
//! - A valid file is read, and its holes have the order and the sizes that the format promises.
//! - A spoilt file is read, or refused with places inside it; nothing makes the reader panic.

use proptest::prelude::*;
use technolog::part::{Face, Part, read_part};
use technolog::units::Micrometres;
use technolog_testing::KNOWLEDGE;
use technolog_testing::holes::part_files;
use technolog_testing::spoilt::{damaged, read_or_refused};

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
    #![proptest_config(technolog_laws::cases!(256))]

    #[test]
    fn every_key_of_a_hole_is_read(text in part_files()) {
        let part = read_part("part.yaml", &text, &KNOWLEDGE)
            .map_err(|problems| TestCaseError::fail(format!("{problems:#?}\n{text}")))?;
        lawful(&part).map_err(|error| TestCaseError::fail(format!("{error}\n{text}")))?;
        let again: Part = serde_json::from_str(&serde_json::to_string(&part).unwrap()).unwrap();
        prop_assert_eq!(again, part);
    }

    #[test]
    fn a_spoilt_file_is_read_or_refused_with_places_inside_it(text in damaged(part_files(), litter())) {
        if let Some(part) = read_or_refused(&text)? {
            lawful(&part).map_err(|error| TestCaseError::fail(format!("{error}\n{text}")))?;
        }
    }
}
