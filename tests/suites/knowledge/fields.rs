//! Limits of tolerance fields beside those that makers and schools print.

use technolog::part::Deviations;
use technolog::units::{ItGrade, Micrometres};
use technolog_testing::KNOWLEDGE;

/// 433 limits of eight pages that print ISO 286-2; they share no figure with our tables, which have the deviations of ISO 286-1.
#[test]
fn fields_have_the_limits_that_pages_print() {
    let printed = include_str!("../../data/iso-286-limits.csv");
    let mut compared = 0;
    for line in printed.lines().skip(1) {
        let [_, size, field, upper, lower] = line.split(',').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let digits = field.find(|letter: char| letter.is_ascii_digit()).unwrap();
        let (letters, grade) = field.split_at(digits);
        let grade = ItGrade::new(grade.parse().unwrap()).unwrap();
        let size = Micrometres::from_mm(size.parse().unwrap());
        let ours = Deviations::of_field(letters, grade, size, &KNOWLEDGE).unwrap();
        let of = |text: &str| Micrometres::new(text.parse().unwrap());
        assert_eq!(ours, Some(Deviations { upper: of(upper), lower: of(lower) }), "{line}");
        compared += 1;
    }
    assert_eq!(compared, 433);
}

/// The deviations of holes that four other pages print, A to C and U to ZC: the limit nearest to the zero line, without Δ above
/// grade 7. They are a second reading: our rows are those of shafts, or off a fifth page.
#[test]
fn holes_begin_where_tables_of_holes_have_them() {
    let printed = include_str!("../../data/iso-286-hole-deviations.csv");
    let mut compared = 0;
    for line in printed.lines().skip(1) {
        let [_, size, letters, deviation] = line.split(',').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let (size, deviation) = (size.parse().unwrap(), Micrometres::new(deviation.parse().unwrap()));
        for grade in [8, 11] {
            let grade = ItGrade::new(grade).unwrap();
            let ours = Deviations::of_field(letters, grade, Micrometres::from_mm(size), &KNOWLEDGE).unwrap();
            let ours = ours.map(|ours| if deviation > Micrometres::ZERO { ours.lower } else { ours.upper });
            assert_eq!(ours, Some(deviation), "{line} grade {grade}");
        }
        compared += 1;
    }
    assert_eq!(compared, 194);
}

/// IT7 of 10 mm is 15 µm, and js7 has half of it on either side, which ISO 286-2 prints as ±7; h11 and H7 begin at the nominal size. Nothing is told of
/// letters without a row, of j, which lies unevenly, and of M6 of 300 mm, an exception of the standard.
#[test]
fn fields_beside_the_pages() {
    let of = |letters: &str, grade: u8, size: i64| {
        let grade = ItGrade::new(grade).unwrap();
        let ours = Deviations::of_field(letters, grade, Micrometres::from_mm(size), &KNOWLEDGE).unwrap();
        ours.map(|ours| (ours.upper.micrometres(), ours.lower.micrometres()))
    };
    assert_eq!(of("js", 7, 10), Some((7, -7)));
    let js7 =
        Deviations::of_field("js", ItGrade::new(7).unwrap(), Micrometres::from_mm(10), &KNOWLEDGE).unwrap().unwrap();
    assert_eq!(js7.to_string(), "+0.0075/-0.0075");
    assert_eq!(of("h", 11, 20), Some((0, -130)));
    assert_eq!(of("H", 7, 40), Some((25, 0)));
    assert_eq!(of("k", 8, 20), Some((33, 0)));
    assert_eq!(of("N", 9, 20), Some((0, -52)));
    for (letters, grade, size) in
        [("j", 6, 20), ("x", 8, 20), ("qq", 7, 20), ("M", 6, 300), ("h", 15, 20), ("f", 7, 600)]
    {
        assert_eq!(of(letters, grade, size), None, "{letters}{grade} {size}");
    }
}
