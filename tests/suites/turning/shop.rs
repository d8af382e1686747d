//! What a turner found clumsy in programs.

use std::collections::BTreeSet;

use technolog::turning::jobs::{Job, Work};
use technolog::turning::operation::Operation;
use technolog::turning::program::Speed;
use technolog::turning::toolpath::Purpose;
use technolog::turning::workpiece::read_turned;
use technolog_testing::KNOWLEDGE;

use super::operation::planned;

fn shaft(machine: &str, bar: u32, outer: &str) -> Operation {
    let text = format!(
        "shaft: Shaft\nmaterial: steel-45\nblank: {{kind: bar, diameter: {bar}, length: 160, face: 1}}\nmachine: \
         {machine}\nouter:\n  - {{from: {{d: 0, z: 0}}}}\n{outer}"
    );
    planned(&read_turned("part", &text, &KNOWLEDGE).unwrap())
}

const STEPPED: &str = "  - {face: 30}\n  - {cylinder: -40}\n  - {face: 45}\n  - {cylinder: -70}\n  - {face: 60}\n  - \
                       {cylinder: -100}\n";

fn jobs(operation: &Operation, work: Work) -> impl Iterator<Item = &Job> {
    operation.set_ups.iter().flat_map(|set_up| &set_up.jobs).filter(move |job| job.work == work)
}

/// Along a face that has just been cut no tool goes back at rapid.
#[test]
fn no_tool_rubs_back_over_the_face_it_has_cut() {
    let operation = shaft("16k20f3", 65, STEPPED);
    let mut faces = 0;
    for job in jobs(&operation, Work::Face) {
        let mut cut = None;
        for (piece, purpose) in job.path.pieces() {
            let upright = piece.from.z == piece.to.z;
            let back = upright && purpose == Purpose::Rapid && piece.to.radius > piece.from.radius;
            assert!(!(back && cut == Some(piece.from.z)), "{piece:?}");
            if purpose != Purpose::Rapid && upright {
                cut = Some(piece.from.z);
                faces += 1;
            }
        }
    }
    assert!(faces > 5, "{faces}");
}

/// From Ø65 down to Ø31 the passes work on diameters of more than 1.5 to 1, the pass over Ø61 does not. A spindle of steps has
/// one speed for each.
#[test]
fn roughing_of_unlike_diameters_holds_the_cutting_speed() {
    let speeds = |machine: &str| -> Vec<bool> {
        let operation = shaft(machine, 65, STEPPED);
        let rough = jobs(&operation, Work::Rough).filter_map(|job| job.pace.speed());
        rough.map(|speed| matches!(speed, Speed::Cutting { .. })).collect()
    };
    assert_eq!(speeds("16a20f3"), [false, true]);
    assert_eq!(speeds("16k20f3"), [false, false]);
}

/// The lecture (12.4, l. 540-546) wants few tools: a blade of 3 mm cuts grooves of 4 and 5 mm with a second plunge or along their
/// walls. A groove with a tolerance keeps its own, and so does one whose many plunges would take too long.
#[test]
fn one_blade_cuts_grooves_of_several_widths() {
    let blades = |grooves: [&str; 3]| -> Vec<String> {
        let mut outer = String::from("  - {face: 40}\n");
        for (place, groove) in grooves.iter().enumerate() {
            outer.push_str(&format!("  - {{cylinder: -{}}}\n  - {{groove: rectangular, {groove}}}\n", 20 + 30 * place));
        }
        outer.push_str("  - {cylinder: -105}\n  - {face: 44}\n  - {cylinder: -120}\n");
        let operation = shaft("16k20f3", 50, &outer);
        let names: BTreeSet<String> = jobs(&operation, Work::Groove).map(|job| job.tool.designation.clone()).collect();
        names.into_iter().collect()
    };
    assert_eq!(blades(["width: 3, depth: 2", "width: 4, depth: 2", "width: 5, depth: 2"]), ["MGEHR 2525-3"]);
    let wide = blades(["width: 3, depth: 2", "width: 20, depth: 10", "width: 5, depth: 2"]);
    assert_eq!(wide, ["MGEHR 2525-3", "MGEHR 2525-5"]);
}
