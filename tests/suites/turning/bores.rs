//! Bores of everyday bushings: drilled, bored and finished whole, or told truly why not.

use technolog::note::Severity;
use technolog::turning::contour::Side;
use technolog::turning::jobs::{Body, Work};
use technolog::turning::operation::Operation;
use technolog::turning::workpiece::read_turned;
use technolog_testing::KNOWLEDGE;

use super::operation::planned;

/// A bushing of a bar, with a bore of H8 from end to end, wider over its first half by so much.
fn bushing(material: &str, bore: i64, wider: i64, length: i64) -> Operation {
    let (mouth, outer) = (bore + wider, (bore + wider) * 8 / 5 + 4);
    let wide = match wider {
        0 => String::new(),
        _ => format!("  - {{cylinder: -{}, grade: H8, roughness: Ra 3.2}}\n  - {{face: {bore}}}\n", length / 2),
    };
    let text = format!(
        "shaft: Bushing\nmaterial: {material}\nblank: {{kind: bar, diameter: {}, length: {}, face: 1}}\n\
         machine: 16k20f3\nouter:\n  - {{from: {{d: {}, z: 0}}}}\n  - {{face: {outer}}}\n  - {{cylinder: -{length}, \
         grade: h11, roughness: Ra 6.3}}\ninner:\n  - {{from: {{d: {}, z: 0}}}}\n  - {{chamfer: 1}}\n{wide}  - \
         {{cylinder: -{length}, grade: H8, roughness: Ra 3.2}}\n",
        outer + 5,
        length + 45,
        mouth + 2,
        mouth + 2,
    );
    planned(&read_turned("part", &text, &KNOWLEDGE).unwrap())
}

fn wrong(operation: &Operation) -> Vec<&str> {
    let wrong = operation.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
    wrong.map(|finding| finding.note.code()).collect()
}

fn tools(operation: &Operation, work: Work) -> Vec<&str> {
    let jobs = operation.set_ups.iter().flat_map(|set_up| &set_up.jobs);
    let inside = jobs.filter(|job| job.side == Side::Inner && job.work == work);
    let mut tools: Vec<&str> = inside.map(|job| job.tool.designation.as_str()).collect();
    tools.dedup();
    tools
}

/// Every third of Ø16 to Ø60 by one to three diameters deep; all of them are planned whole but Ø60 by 180.
#[test]
fn bores_of_bushings_are_made_whole() {
    let depths = [(16, 1), (16, 3), (20, 2), (25, 3), (30, 1), (40, 3), (50, 2), (60, 2)];
    for material in ["steel-45", "40Х", "СЧ20", "БрО10Ф1", "Д16"] {
        for (bore, times) in depths {
            let operation = bushing(material, bore, 0, bore * times);
            assert_eq!(wrong(&operation), [""; 0], "{material} Ø{bore}x{}: {:?}", bore * times, operation.findings);
        }
        for (bore, wider, length) in [(16, 9, 50), (20, 10, 60), (40, 20, 120)] {
            let operation = bushing(material, bore, wider, length);
            assert_eq!(wrong(&operation), [""; 0], "{material} Ø{bore}+{wider}x{length}: {:?}", operation.findings);
        }
    }
}

/// A bar of steel stands out 4 diameters at most, one of carbide 6 (cuttingtoolsai.eu; Widia 2017, p. 376), with 5 mm more than
/// the bore is deep. The first set-up bores 2 mm past the end. Ø30 by 60: 67 are within 4·20. By 90: 97 are not, but within 6·20.
/// Ø40 by 120: 127 are beyond 6·20, so the hole is opened for a bar of 25, which enters Ø32: 6·25 = 150.
#[test]
fn the_bar_reaches_the_end_of_its_bore() {
    let rough = |bore: i64, length: i64| tools(&bushing("steel-45", bore, 0, length), Work::Rough).join(", ");
    assert_eq!(rough(30, 60), "S20S-SCLCR09");
    assert_eq!(rough(30, 90), "E20S-SCLCR09");
    assert_eq!(rough(40, 120), "E25T-SCLCR12");
    let drilled = |bore: i64, material: &str| -> Vec<String> {
        let operation = bushing(material, bore, 0, bore * 3);
        let jobs = operation.set_ups.iter().flat_map(|set_up| &set_up.jobs);
        let drills = jobs.filter_map(|job| match job.tool.body {
            Body::Drill { diameter_mm, .. } if job.work == Work::Drill => Some(diameter_mm.to_string()),
            _ => None,
        });
        drills.collect()
    };
    // Two drills above 30 (textbook 1.2.1), the first of 0.5 to 0.6 of the second; in stainless steel above 20.
    assert_eq!(drilled(40, "steel-45"), ["19", "32"]);
    assert_eq!(drilled(30, "steel-45"), ["27"]);
    assert_eq!(drilled(30, "12Х18Н10Т"), ["16", "27"]);
}

/// The longest drill up to Ø30 of ГОСТ 2092-77 has flutes of 275; and of the bars that enter Ø56 none stands out more than 6·32 = 192.
#[test]
fn a_bore_too_deep_says_what_is_too_short() {
    assert!(wrong(&bushing("steel-45", 60, 0, 280)).contains(&"job-no-drill"));
    let tube = "shaft: Tube\nmaterial: steel-45\nblank: {kind: tube, diameter: 90, bore: 56, length: 300, face: 1}\n\
                machine: 16k20f3\nouter:\n  - {from: {d: 60, z: 0}}\n  - {face: 84}\n  - {cylinder: -240}\n\
                inner:\n  - {from: {d: 60, z: 0}}\n  - {cylinder: -240, grade: H8, roughness: Ra 3.2}\n";
    let operation = planned(&read_turned("part", tube, &KNOWLEDGE).unwrap());
    assert!(wrong(&operation).contains(&"bar-too-long"), "{:?}", operation.findings);
}
