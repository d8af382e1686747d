//! Limits of tolerance fields beside those that makers and schools print.

use technolog::part::Deviations;
use technolog::units::{ItGrade, Micrometres};
use technolog_testing::KNOWLEDGE;

/// 354 limits of six pages that print ISO 286-2; they share no figure with our tables, which have the deviations of ISO 286-1.
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
    assert_eq!(compared, 354);
}

/// js7 of 10 mm is ±7.5 µm by the table and ±7 as ISO 286-1 rounds it; h11 and H7 begin at the nominal size. Nothing is told of
/// letters without a row, of j, which lies unevenly, and of M6 of 300 mm, an exception of the standard.
#[test]
fn fields_beside_the_pages() {
    let of = |letters: &str, grade: u8, size: i64| {
        let grade = ItGrade::new(grade).unwrap();
        let ours = Deviations::of_field(letters, grade, Micrometres::from_mm(size), &KNOWLEDGE).unwrap();
        ours.map(|ours| (ours.upper.micrometres(), ours.lower.micrometres()))
    };
    assert_eq!(of("js", 7, 10), Some((7, -7)));
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
