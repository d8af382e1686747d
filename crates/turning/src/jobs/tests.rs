//! What the tests of jobs are made on: a part of a bar of 120 mm on a lathe 16К20Ф3.

use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::shipped;
use crate::turning::operation::Sizes;
use crate::turning::operation::tools::Bench;
use crate::turning::tooling::Lathe;
use crate::turning::workpiece::{Workpiece, read_workpiece};

/// A plain outside, where a test is of something else.
pub(crate) const PLAIN: &str = "  - {from: {d: 0, z: 0}}\n  - {face: 30}\n  - {cylinder: -40}\n";

/// A part by the items of its contours.
pub(crate) fn part(outer: &str, inner: &str, material: &str) -> Workpiece {
    let inner = if inner.is_empty() { String::new() } else { format!("inner:\n{inner}") };
    let text = format!(
        "shaft: P\nmaterial: {material}\nblank: {{kind: bar, diameter: 120, length: 130, face: 1}}\nmachine: 16k20f3\n\
         outer:\n{outer}{inner}"
    );
    read_workpiece("part", &text, &shipped::knowledge().unwrap()).unwrap_or_else(|faults| panic!("{faults:?}"))
}

/// Something of the bench of a part.
pub(crate) fn on_bench<T>(workpiece: &Workpiece, of: impl FnOnce(&Bench<'_, '_>) -> T) -> T {
    let knowledge: Knowledge = shipped::knowledge().unwrap();
    let lathe = Lathe::find(&knowledge, "16k20f3").unwrap();
    let material = Material::find(&knowledge, &workpiece.material).unwrap();
    let sizes = Sizes::default();
    of(&Bench::new(workpiece, Some(&lathe), material, &sizes, &knowledge))
}
